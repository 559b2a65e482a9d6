<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
 <context>
  <name>SheetMorph_AddPart</name>
  <message>
   <source>The selected objects have no faces. Select meshes or shapes.</source>
   <translation>選択したオブジェクトには面がありません。メッシュまたは形状を選択してください。</translation>
  </message>
  <message>
   <source>&amp;Add Part</source>
   <translation>部品を追加(&amp;A)</translation>
  </message>
  <message>
   <source>Adds the selected meshes and shapes to the morph as parts</source>
   <translation>選択したメッシュと形状を部品としてモーフに追加します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ApplyPose</name>
  <message>
   <source>&amp;Apply Pose</source>
   <translation>姿勢を適用(&amp;A)</translation>
  </message>
  <message>
   <source>Moves all handles to their positions in the selected pose</source>
   <translation>すべてのハンドルを選択した姿勢の位置に動かします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_BlendPoses</name>
  <message>
   <source>&amp;Blend Poses…</source>
   <translation>姿勢をブレンド(&amp;B)…</translation>
  </message>
  <message>
   <source>Blends from one pose to another with a slider, and compares the two</source>
   <translation>スライダーで一方の姿勢から他方の姿勢へブレンドし、両者を比較します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Certify</name>
  <message>
   <source>Certificate</source>
   <translation>証明書</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>基準</translation>
  </message>
  <message>
   <source>&amp;Certificate…</source>
   <translation>証明書(&amp;C)…</translation>
  </message>
  <message>
   <source>Writes all deformed parts to a folder, reads them back, and checks them against criteria</source>
   <translation>変形したすべての部品をフォルダーに書き出し、読み直して基準に照らして検査します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CheckInstallation</name>
  <message>
   <source>&amp;Check Installation</source>
   <translation>インストールの確認(&amp;C)</translation>
  </message>
  <message>
   <source>Checks the deformation kernel and shows a report that you can copy</source>
   <translation>変形カーネルを検査し、コピーできる報告を表示します</translation>
  </message>
  <message>
   <source>Check Installation</source>
   <translation>インストールの確認</translation>
  </message>
  <message>
   <source>Copy</source>
   <translation>コピー</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyAsMeshes</name>
  <message>
   <source>Copy as &amp;Meshes</source>
   <translation>メッシュとして複製(&amp;M)</translation>
  </message>
  <message>
   <source>Copies the parts as plain meshes, in their current shape or in the selected pose</source>
   <translation>部品を、現在の形状または選択した姿勢で、通常のメッシュとして複製します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyInPose</name>
  <message>
   <source>&amp;Copy in Pose</source>
   <translation>姿勢で複製(&amp;C)</translation>
  </message>
  <message>
   <source>Copies the whole morph and applies the selected pose to the copy</source>
   <translation>モーフ全体を複製し、選択した姿勢を複製に適用します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CreateMorph</name>
  <message>
   <source>&amp;Create Morph</source>
   <translation>モーフを作成(&amp;C)</translation>
  </message>
  <message>
   <source>Creates a morph from the selected meshes and shapes, which stay unchanged</source>
   <translation>選択したメッシュと形状からモーフを作成します。元のオブジェクトは変わりません</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_DeformedShape</name>
  <message>
   <source>&amp;Deformed Shape</source>
   <translation>変形した形状(&amp;D)</translation>
  </message>
  <message>
   <source>Creates a deformed CAD shape of the selected part, with the faces of its original shape</source>
   <translation>選択した部品の変形後の CAD 形状を、元の形状と同じ面構成で作成します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_EditContact</name>
  <message>
   <source>&amp;Edit Contact…</source>
   <translation>接触を編集(&amp;E)…</translation>
  </message>
  <message>
   <source>Changes the type, the regions and the settings of the selected contact</source>
   <translation>選択した接触の種類、領域、設定を変更します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_EditRegion</name>
  <message>
   <source>&amp;Edit Region…</source>
   <translation>領域を編集(&amp;E)…</translation>
  </message>
  <message>
   <source>Changes the vertices of the selected region by picking in the 3D view</source>
   <translation>選択した領域の頂点を 3D ビューで選び直します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportParts</name>
  <message>
   <source>These files already exist, and SheetMorph did not write their current content:</source>
   <translation>次のファイルはすでに存在し、現在の内容は SheetMorph が書いたものではありません:</translation>
  </message>
  <message>
   <source>Overwrite them?</source>
   <translation>上書きしますか?</translation>
  </message>
  <message>
   <source>Export Parts</source>
   <translation>部品をエクスポート</translation>
  </message>
  <message>
   <source>&amp;Export Parts…</source>
   <translation>部品をエクスポート(&amp;E)…</translation>
  </message>
  <message>
   <source>Writes all deformed parts to a folder, each in its original file format</source>
   <translation>変形したすべての部品を、それぞれ元のファイル形式でフォルダーに書き出します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportRecipe</name>
  <message>
   <source>Export Recipe</source>
   <translation>レシピをエクスポート</translation>
  </message>
  <message>
   <source>E&amp;xport Recipe…</source>
   <translation>レシピをエクスポート(&amp;X)…</translation>
  </message>
  <message>
   <source>Writes the morph as a recipe that also runs without FreeCAD</source>
   <translation>モーフを、FreeCAD なしでも実行できるレシピとして書き出します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FeatureSettings</name>
  <message>
   <source>Form Feature &amp;Settings…</source>
   <translation>形状特徴の設定(&amp;S)…</translation>
  </message>
  <message>
   <source>Sets the rotation, the motion and the size of the selected form feature</source>
   <translation>選択した形状特徴の回転、動き、大きさを設定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindContacts</name>
  <message>
   <source>&amp;Find Contacts…</source>
   <translation>接触を探す(&amp;F)…</translation>
  </message>
  <message>
   <source>Finds where parts touch or are bolted; the ones you accept become contacts</source>
   <translation>部品が接する所やボルト締めの所を探します。採用したものが接触になります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindFeatures</name>
  <message>
   <source>F&amp;ind Features…</source>
   <translation>形状特徴を探す(&amp;I)…</translation>
  </message>
  <message>
   <source>Finds holes and other features on all parts; the ones you accept become form features</source>
   <translation>すべての部品の穴やその他の特徴を探します。採用したものが形状特徴になります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Flatten</name>
  <message>
   <source>&amp;Flatten</source>
   <translation>展開(&amp;F)</translation>
  </message>
  <message>
   <source>Flattens the selected part, in its current shape and at rest: sketches of blank and bend lines</source>
   <translation>選択した部品を、現在の形状と初期形状の両方で展開します: ブランクと曲げ線のスケッチ</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FollowShape</name>
  <message>
   <source>“{0}” was {1}. Which one is it now?</source>
   <translation>「{0}」は{1}でした。現在はどれですか？</translation>
  </message>
  <message>
   <source>&amp;Follow Shape</source>
   <translation>形状に追従(&amp;F)</translation>
  </message>
  <message>
   <source>Meshes the changed body or shape of the selected part again and finds its regions on the new mesh; regions that changed are listed and selected</source>
   <translation>選択した部品の変更されたボディまたは形状を再メッシュし、新しいメッシュ上で領域を見つけ直します。変わった領域は一覧に示して選択します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_GroupFeatures</name>
  <message>
   <source>&amp;Group Form Features</source>
   <translation>形状特徴をまとめる(&amp;G)</translation>
  </message>
  <message>
   <source>Moves the selected form features of a part as one rigid body</source>
   <translation>選択した同じ部品の形状特徴を、一つの剛体として動かします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Guide</name>
  <message>
   <source>&amp;Guide</source>
   <translation>ガイド(&amp;G)</translation>
  </message>
  <message>
   <source>Guides you through a morph step by step: shows what is missing and opens the right panel</source>
   <translation>モーフの作成を順を追って案内します。足りないものを示し、該当するパネルを開きます</translation>
  </message>
  <message>
   <source>Import a mesh or CAD file, or select meshes in the tree and create a morph.</source>
   <translation>メッシュまたは CAD ファイルをインポートするか、ツリーでメッシュを選択してモーフを作成してください。</translation>
  </message>
  <message>
   <source>This document has several morphs: select one in the tree.</source>
   <translation>このドキュメントには複数のモーフがあります。ツリーで一つ選択してください。</translation>
  </message>
  <message>
   <source>The morph has no part yet: import a file or add a mesh.</source>
   <translation>モーフにまだ部品がありません。ファイルをインポートするか、メッシュを追加してください。</translation>
  </message>
  <message>
   <source>Parts: {count}; “{primary}” is deformed first.</source>
   <translation>部品 {count} 個。「{primary}」が最初に変形します。</translation>
  </message>
  <message>
   <source>“{source}” was edited: use Follow Shape to update “{part}”.</source>
   <translation>「{source}」が編集されました。「形状に追従」で「{part}」を更新してください。</translation>
  </message>
  <message>
   <source>Nothing is fixed yet: mark a region that stays in place.</source>
   <translation>まだ何も固定されていません。動かない領域を指定してください。</translation>
  </message>
  <message>
   <source>Fixed regions: {count}.</source>
   <translation>固定領域 {count} 個。</translation>
  </message>
  <message>
   <source>No hole keeps its shape yet: find all holes, mark the important ones, or skip this step.</source>
   <translation>形を保つ穴がまだありません。すべて探すか、重要な穴を指定するか、この手順を飛ばしてください。</translation>
  </message>
  <message>
   <source>Form features that keep their exact shape: {count}.</source>
   <translation>形を正確に保つ形状特徴: {count} 個。</translation>
  </message>
  <message>
   <source>There is only one part: no contact is needed.</source>
   <translation>部品は一つだけなので、接触は不要です。</translation>
  </message>
  <message>
   <source>A single control mesh around everything moves all parts.</source>
   <translation>全体を囲む一つの制御メッシュがすべての部品を動かします。</translation>
  </message>
  <message>
   <source>These parts are not connected to “{primary}” and will not follow: {parts}.</source>
   <translation>次の部品は「{primary}」とつながっていないため追従しません: {parts}。</translation>
  </message>
  <message>
   <source>Contacts: {count}; they connect all parts.</source>
   <translation>接触 {count} 個がすべての部品をつなぎます。</translation>
  </message>
  <message>
   <source>There is no handle yet: mark a region that you want to move.</source>
   <translation>ハンドルがまだありません。動かしたい領域を指定してください。</translation>
  </message>
  <message>
   <source>Handles: {count}.</source>
   <translation>ハンドル {count} 個。</translation>
  </message>
  <message>
   <source>Available after you mark a fixed region and a handle.</source>
   <translation>固定領域とハンドルを指定すると使えます。</translation>
  </message>
  <message>
   <source>Everything is ready: move the handle.</source>
   <translation>準備ができました。ハンドルを動かしてください。</translation>
  </message>
  <message>
   <source>The handle has moved. Move it further, export the parts, save a pose, or run a study.</source>
   <translation>ハンドルが動きました。さらに動かすか、部品をエクスポートするか、姿勢を保存するか、スタディを実行してください。</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportPart</name>
  <message>
   <source>Mesh CAD Shapes</source>
   <translation>CAD 形状をメッシュ化</translation>
  </message>
  <message>
   <source>Maximum edge length (0 = automatic, 1/100 of the size)</source>
   <translation>最大の辺の長さ (0 = 自動、大きさの 1/100)</translation>
  </message>
  <message>
   <source>“{0}” is not a length. Enter a length such as 5 mm.</source>
   <translation>「{0}」は長さではありません。5 mm のような長さを入力してください。</translation>
  </message>
  <message>
   <source>Import Part</source>
   <translation>部品をインポート</translation>
  </message>
  <message>
   <source>&amp;Import Part…</source>
   <translation>部品をインポート(&amp;I)…</translation>
  </message>
  <message>
   <source>Imports a mesh, every property of a deck, or every solid of a CAD file as parts</source>
   <translation>メッシュ、デッキの各プロパティ、または CAD ファイルの各ソリッドを部品としてインポートします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportRecipe</name>
  <message>
   <source>Import Recipe</source>
   <translation>レシピをインポート</translation>
  </message>
  <message>
   <source>&amp;Import Recipe…</source>
   <translation>レシピをインポート(&amp;I)…</translation>
  </message>
  <message>
   <source>Creates a morph from a recipe and its mesh files</source>
   <translation>レシピとそのメッシュファイルからモーフを作成します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_KeepDistance</name>
  <message>
   <source>&amp;Keep Distance</source>
   <translation>距離を保つ(&amp;K)</translation>
  </message>
  <message>
   <source>Keeps the distance between two selected form features, on one part or on two</source>
   <translation>選択した二つの形状特徴(同じ部品でも別の部品でも)の距離を保ちます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MakeCoaxial</name>
  <message>
   <source>&amp;Make Coaxial</source>
   <translation>同軸にする(&amp;M)</translation>
  </message>
  <message>
   <source>Keeps two selected form features on a common axis, on one part or on two</source>
   <translation>選択した二つの形状特徴(同じ部品でも別の部品でも)を共通の軸上に保ちます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Manual</name>
  <message>
   <source>SheetMorph &amp;Manual</source>
   <translation>SheetMorph マニュアル(&amp;M)</translation>
  </message>
  <message>
   <source>Opens the manual in the browser, also without a network</source>
   <translation>ブラウザーでマニュアルを開きます。ネットワークは不要です</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkContact</name>
  <message>
   <source>&amp;Mark Contact…</source>
   <translation>接触を指定(&amp;M)…</translation>
  </message>
  <message>
   <source>Joins two parts where they touch, so that one follows the other. Select both parts, or click on them in the 3D view</source>
   <translation>触れ合う二つの部品をつなぎ、一方が他方に追従するようにします。両方の部品を選択するか、3D ビューでクリックしてください</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFeature</name>
  <message>
   <source>Mark F&amp;orm Features…</source>
   <translation>形状特徴を指定(&amp;O)…</translation>
  </message>
  <message>
   <source>Marks holes and other form features, which move but keep their shape</source>
   <translation>動いても形を保つ、穴などの形状特徴を指定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFixed</name>
  <message>
   <source>Mark &amp;Fixed Region…</source>
   <translation>固定領域を指定(&amp;F)…</translation>
  </message>
  <message>
   <source>Marks a region that stays in place, by picking in the 3D view</source>
   <translation>3D ビューで選択して、動かない領域を指定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFollower</name>
  <message>
   <source>Mark Fo&amp;llower…</source>
   <translation>追従領域を指定(&amp;L)…</translation>
  </message>
  <message>
   <source>Marks a region that follows the control meshes of the part's contacts</source>
   <translation>部品の接触の制御メッシュに追従する領域を指定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkHandle</name>
  <message>
   <source>Mark &amp;Handle…</source>
   <translation>ハンドルを指定(&amp;H)…</translation>
  </message>
  <message>
   <source>Marks a region that you move and turn; the part follows</source>
   <translation>動かしたり回したりする領域を指定します。部品がそれに追従します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MoveHandle</name>
  <message>
   <source>&amp;Move Handle…</source>
   <translation>ハンドルを動かす(&amp;M)…</translation>
  </message>
  <message>
   <source>Moves and turns a handle; the parts follow as you change the values</source>
   <translation>ハンドルを動かして回します。値を変えると部品が追従します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_OpenExample</name>
  <message>
   <source>Open Example</source>
   <translation>例を開く</translation>
  </message>
  <message>
   <source>Example</source>
   <translation>例</translation>
  </message>
  <message>
   <source>&amp;Open Example…</source>
   <translation>例を開く(&amp;O)…</translation>
  </message>
  <message>
   <source>Opens an example assembly that is ready to move</source>
   <translation>すぐに動かせるアセンブリの例を開きます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_PrepareMesh</name>
  <message>
   <source>&amp;Prepare Mesh…</source>
   <translation>メッシュを準備(&amp;P)…</translation>
  </message>
  <message>
   <source>Checks the mesh of the selected part, repairs it and remeshes it</source>
   <translation>選択した部品のメッシュを検査し、修復し、再メッシュします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Propagation</name>
  <message>
   <source>&amp;Propagation…</source>
   <translation>伝播(&amp;P)…</translation>
  </message>
  <message>
   <source>Shows how the motion spreads from the primary part through the contacts</source>
   <translation>主部品から接触を通じて動きが伝わる様子を示します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ReplaceFile</name>
  <message>
   <source>Replace File</source>
   <translation>ファイルを置き換え</translation>
  </message>
  <message>
   <source>&amp;Replace File…</source>
   <translation>ファイルを置き換え(&amp;R)…</translation>
  </message>
  <message>
   <source>Reads the changed file of the selected part and finds its regions on the new mesh; regions that changed are listed and selected</source>
   <translation>選択した部品の変更されたファイルを読み込み、新しいメッシュ上で領域を見つけ直します。変わった領域は一覧に示して選択します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ResetMotion</name>
  <message>
   <source>&amp;Reset Motion</source>
   <translation>動きを戻す(&amp;R)</translation>
  </message>
  <message>
   <source>Returns the selected handles, or all handles of the morph, to rest</source>
   <translation>選択したハンドル、選択がなければモーフのすべてのハンドルを初期位置に戻します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SavePose</name>
  <message>
   <source>Save Pose</source>
   <translation>姿勢を保存</translation>
  </message>
  <message>
   <source>Name of the pose</source>
   <translation>姿勢の名前</translation>
  </message>
  <message>
   <source>Pose {0}</source>
   <translation>姿勢 {0}</translation>
  </message>
  <message>
   <source>&amp;Save Pose…</source>
   <translation>姿勢を保存(&amp;S)…</translation>
  </message>
  <message>
   <source>Saves the current positions of all handles under a name</source>
   <translation>すべてのハンドルの現在の位置に名前を付けて保存します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SetPrimary</name>
  <message>
   <source>&amp;Set as Primary</source>
   <translation>主部品にする(&amp;S)</translation>
  </message>
  <message>
   <source>Makes the selected part the primary part, which is deformed first; the others follow it</source>
   <translation>選択した部品を主部品にします。主部品が最初に変形し、他の部品が追従します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Study</name>
  <message>
   <source>S&amp;tudy…</source>
   <translation>スタディ(&amp;T)…</translation>
  </message>
  <message>
   <source>Computes and certifies many variants in the background and lists them in a table</source>
   <translation>多くのバリアントをバックグラウンドで計算・認証し、表に示します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ThicknessMap</name>
  <message>
   <source>&amp;Thickness…</source>
   <translation>板厚(&amp;T)…</translation>
  </message>
  <message>
   <source>Shows the thickness of the selected part in colours, and lets the part bend as one sheet</source>
   <translation>選択した部品の板厚を色で示し、一枚の板として曲がるようにします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ToggleContact</name>
  <message>
   <source>&amp;Toggle Contact</source>
   <translation>接触のオン/オフを切り替え(&amp;T)</translation>
  </message>
  <message>
   <source>Switches the selected contacts off, so that nothing propagates through them, or on again</source>
   <translation>選択した接触をオフにして伝播を止め、またはオンに戻します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_actions</name>
  <message>
   <source>SheetMorph has a bug ({0}). Please report it.</source>
   <translation>SheetMorph の不具合です({0})。ご報告ください。</translation>
  </message>
  <message>
   <source>Cancelled. Nothing was changed.</source>
   <translation>キャンセルしました。何も変更されていません。</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>キャンセル</translation>
  </message>
  <message>
   <source>Cancelling…</source>
   <translation>キャンセルしています…</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_contact</name>
  <message>
   <source>Contact</source>
   <translation>接触</translation>
  </message>
  <message>
   <source>Parts</source>
   <translation>部品</translation>
  </message>
  <message>
   <source>The part on this side. You can also click on it in the 3D view</source>
   <translation>こちら側の部品。3D ビューでクリックして選ぶこともできます</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>種類</translation>
  </message>
  <message>
   <source>How the second part follows the first</source>
   <translation>二つ目の部品が一つ目に追従する方法</translation>
  </message>
  <message>
   <source>In use</source>
   <translation>使用中</translation>
  </message>
  <message>
   <source>Off: the contact stays in the document but transfers no motion</source>
   <translation>オフ: 接触はドキュメントに残りますが、動きを伝えません</translation>
  </message>
  <message>
   <source>Vertices</source>
   <translation>頂点</translation>
  </message>
  <message>
   <source>The vertices of both parts that the contact joins</source>
   <translation>接触でつなぐ両部品の頂点</translation>
  </message>
  <message>
   <source>Within the gap distance</source>
   <translation>隙間の距離以内</translation>
  </message>
  <message>
   <source>Picked by hand: first part</source>
   <translation>手で選択: 一つ目の部品</translation>
  </message>
  <message>
   <source>Picked by hand: second part</source>
   <translation>手で選択: 二つ目の部品</translation>
  </message>
  <message>
   <source>Gap distance: vertices within this distance of the other part belong to the contact</source>
   <translation>隙間の距離: 相手の部品からこの距離以内の頂点が接触に含まれます</translation>
  </message>
  <message>
   <source>Pick</source>
   <translation>選択</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_feature</name>
  <message>
   <source>Form Feature</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>回転</translation>
  </message>
  <message>
   <source>How the rotation of the form feature is determined</source>
   <translation>形状特徴の回転の決め方</translation>
  </message>
  <message>
   <source>Free: follows the sheet</source>
   <translation>自由: 板に従う</translation>
  </message>
  <message>
   <source>Interpolated: follows the handles</source>
   <translation>補間: ハンドルに従う</translation>
  </message>
  <message>
   <source>Prescribed</source>
   <translation>指定</translation>
  </message>
  <message>
   <source>Axis</source>
   <translation>軸</translation>
  </message>
  <message>
   <source>x of the axis of the rotation, global</source>
   <translation>回転軸のx成分(全体座標)</translation>
  </message>
  <message>
   <source>y of the axis of the rotation, global</source>
   <translation>回転軸のy成分(全体座標)</translation>
  </message>
  <message>
   <source>z of the axis of the rotation, global</source>
   <translation>回転軸のz成分(全体座標)</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>角度</translation>
  </message>
  <message>
   <source>Angle of the rotation; more than one turn is possible</source>
   <translation>回転角度。一回転を超えてもかまいません</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>動き</translation>
  </message>
  <message>
   <source>The motion that the form feature is allowed</source>
   <translation>形状特徴に許される動き</translation>
  </message>
  <message>
   <source>Free</source>
   <translation>自由</translation>
  </message>
  <message>
   <source>Fixed: stays in place</source>
   <translation>固定: 動かない</translation>
  </message>
  <message>
   <source>Translation: does not turn</source>
   <translation>平行移動: 回らない</translation>
  </message>
  <message>
   <source>Plane: moves in a plane</source>
   <translation>平面: 平面内で動く</translation>
  </message>
  <message>
   <source>Line: moves along a line</source>
   <translation>直線: 直線に沿って動く</translation>
  </message>
  <message>
   <source>Axis: turns about an axis</source>
   <translation>軸: 軸のまわりに回る</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>方向</translation>
  </message>
  <message>
   <source>x of the normal, line or axis, global</source>
   <translation>法線・直線・軸のx成分(全体座標)</translation>
  </message>
  <message>
   <source>y of the normal, line or axis, global</source>
   <translation>法線・直線・軸のy成分(全体座標)</translation>
  </message>
  <message>
   <source>z of the normal, line or axis, global</source>
   <translation>法線・直線・軸のz成分(全体座標)</translation>
  </message>
  <message>
   <source>Point</source>
   <translation>点</translation>
  </message>
  <message>
   <source>x of a point on the axis, global</source>
   <translation>軸上の点の x(全体座標)</translation>
  </message>
  <message>
   <source>y of a point on the axis, global</source>
   <translation>軸上の点の y(全体座標)</translation>
  </message>
  <message>
   <source>z of a point on the axis, global</source>
   <translation>軸上の点の z(全体座標)</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>大きさ</translation>
  </message>
  <message>
   <source>Sets the size of the hole, slot or cylinder; the sheet around it follows</source>
   <translation>穴・長穴・円筒の大きさを設定します。周りの板が追従します</translation>
  </message>
  <message>
   <source>Diameter of a hole, length of a slot, radius of a cylinder</source>
   <translation>穴の直径、長穴の長さ、円筒の半径</translation>
  </message>
  <message>
   <source>Relation</source>
   <translation>関係</translation>
  </message>
  <message>
   <source>Relation between this form feature and the ticked ones</source>
   <translation>この形状特徴とチェックした形状特徴との関係</translation>
  </message>
  <message>
   <source>No new relation</source>
   <translation>新しい関係なし</translation>
  </message>
  <message>
   <source>Group: moves as one body with…</source>
   <translation>まとめる: 一つの剛体として動く相手…</translation>
  </message>
  <message>
   <source>Coaxial: shares its axis with…</source>
   <translation>同軸: 軸を共有する相手…</translation>
  </message>
  <message>
   <source>Distance: keeps its distance to…</source>
   <translation>距離: 距離を保つ相手…</translation>
  </message>
  <message>
   <source>Form features for the new relation</source>
   <translation>新しい関係の相手となる形状特徴</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_find</name>
  <message>
   <source>Already in the document</source>
   <translation>ドキュメントに既存</translation>
  </message>
  <message>
   <source>Find Features</source>
   <translation>形状特徴を探す</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>大きさ</translation>
  </message>
  <message>
   <source>Deviation</source>
   <translation>偏差</translation>
  </message>
  <message>
   <source>Find Contacts</source>
   <translation>接触を探す</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>接触</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>種類</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>隙間</translation>
  </message>
  <message>
   <source>Size: diameter or length. Deviation: distance of the rim from its ideal form.</source>
   <translation>大きさ: 直径または長さ。偏差: 縁と理想形状との距離。</translation>
  </message>
  <message>
   <source>Size of the contact area; median gap.</source>
   <translation>接触領域の大きさと、隙間の中央値。</translation>
  </message>
  <message>
   <source>Find</source>
   <translation>探す</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>表示</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>種類</translation>
  </message>
  <message>
   <source>Shows one kind only. Hidden rows are not created</source>
   <translation>一種類だけ表示します。隠れた行は作成されません</translation>
  </message>
  <message>
   <source>From</source>
   <translation>最小</translation>
  </message>
  <message>
   <source>Hides smaller ones. Hidden rows are not created</source>
   <translation>これより小さいものを隠します。隠れた行は作成されません</translation>
  </message>
  <message>
   <source>to</source>
   <translation>最大</translation>
  </message>
  <message>
   <source>Hides larger ones. Hidden rows are not created</source>
   <translation>これより大きいものを隠します。隠れた行は作成されません</translation>
  </message>
  <message>
   <source>any size</source>
   <translation>制限なし</translation>
  </message>
  <message>
   <source>Checked rows are created. The row under the mouse lights up in the 3D view</source>
   <translation>チェックした行を作成します。マウスの下の行が 3D ビューで光ります</translation>
  </message>
  <message>
   <source>Checks all visible rows</source>
   <translation>表示中のすべての行をチェックします</translation>
  </message>
  <message>
   <source>All</source>
   <translation>すべて</translation>
  </message>
  <message>
   <source>Unchecks all visible rows</source>
   <translation>表示中のすべての行のチェックを外します</translation>
  </message>
  <message>
   <source>None</source>
   <translation>なし</translation>
  </message>
  <message>
   <source>Tolerances</source>
   <translation>許容値</translation>
  </message>
  <message>
   <source>Roundness tolerance</source>
   <translation>真円度の許容値</translation>
  </message>
  <message>
   <source>Largest distance of a rim vertex from the fitted circle, relative to its radius</source>
   <translation>縁の頂点と当てはめた円との最大距離(半径に対する比)</translation>
  </message>
  <message>
   <source>Edge angle</source>
   <translation>稜の角度</translation>
  </message>
  <message>
   <source>The surface has an edge where it bends by more than this angle</source>
   <translation>面がこの角度より大きく折れる所を稜とします</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>穴の周りの輪</translation>
  </message>
  <message>
   <source>Number of triangle rings around a hole that keep their shape with it</source>
   <translation>穴とともに形を保つ、周りの三角形の輪の数</translation>
  </message>
  <message>
   <source>Also surfaces and beads</source>
   <translation>面とビードも含む</translation>
  </message>
  <message>
   <source>Also proposes planes, cylinders, flanges and beads</source>
   <translation>平面・円筒・フランジ・ビードも提案します</translation>
  </message>
  <message>
   <source>Largest gap</source>
   <translation>最大の隙間</translation>
  </message>
  <message>
   <source>Parts farther apart are not in contact. 0: the proposed value for these parts</source>
   <translation>これより離れた部品は接触とみなしません。0: これらの部品に対する提案値</translation>
  </message>
  <message>
   <source>automatic</source>
   <translation>自動</translation>
  </message>
  <message>
   <source>Facing tolerance</source>
   <translation>対向角の許容値</translation>
  </message>
  <message>
   <source>Largest angle between two surfaces in contact</source>
   <translation>接触する二つの面の間の最大角度</translation>
  </message>
  <message>
   <source>One contact per pair of parts</source>
   <translation>部品の組ごとに一つの接触</translation>
  </message>
  <message>
   <source>Joins all places where two parts touch into one contact</source>
   <translation>二つの部品が触れ合うすべての所を一つの接触にまとめます</translation>
  </message>
  <message>
   <source>Searches again with these tolerances</source>
   <translation>この許容値で探し直します</translation>
  </message>
  <message>
   <source>Search Again</source>
   <translation>探し直す</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_guide</name>
  <message>
   <source>Guide</source>
   <translation>ガイド</translation>
  </message>
  <message>
   <source>The morph of this guide: the selected one, or the only one in the document</source>
   <translation>ガイドの対象のモーフ(選択中のもの、またはドキュメント内の唯一のもの)</translation>
  </message>
  <message>
   <source>1  Parts</source>
   <translation>1  部品</translation>
  </message>
  <message>
   <source>2  Fixed regions</source>
   <translation>2  固定領域</translation>
  </message>
  <message>
   <source>3  Form features</source>
   <translation>3  形状特徴</translation>
  </message>
  <message>
   <source>4  Contacts</source>
   <translation>4  接触</translation>
  </message>
  <message>
   <source>5  Handles</source>
   <translation>5  ハンドル</translation>
  </message>
  <message>
   <source>6  Move</source>
   <translation>6  動かす</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_menus</name>
  <message>
   <source>Show Problem</source>
   <translation>問題を表示</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_move</name>
  <message>
   <source>Move Handle</source>
   <translation>ハンドルを動かす</translation>
  </message>
  <message>
   <source>Handle</source>
   <translation>ハンドル</translation>
  </message>
  <message>
   <source>The handle to move</source>
   <translation>動かすハンドル</translation>
  </message>
  <message>
   <source>The axes of fields and arrows: global, or local: Z is the normal of the sheet at the handle, X its longest direction</source>
   <translation>入力欄と矢印の軸: グローバル、またはローカル。ローカルの Z はハンドル位置での板の法線、X はハンドルの最も長い方向です</translation>
  </message>
  <message>
   <source>Global axes</source>
   <translation>グローバル軸</translation>
  </message>
  <message>
   <source>Local axes</source>
   <translation>ローカル軸</translation>
  </message>
  <message>
   <source>Translation</source>
   <translation>平行移動</translation>
  </message>
  <message>
   <source>X</source>
   <translation>X</translation>
  </message>
  <message>
   <source>Translation along the X axis</source>
   <translation>X 軸方向の移動</translation>
  </message>
  <message>
   <source>Y</source>
   <translation>Y</translation>
  </message>
  <message>
   <source>Translation along the Y axis</source>
   <translation>Y 軸方向の移動</translation>
  </message>
  <message>
   <source>Z</source>
   <translation>Z</translation>
  </message>
  <message>
   <source>Translation along the Z axis</source>
   <translation>Z 軸方向の移動</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>回転</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>角度</translation>
  </message>
  <message>
   <source>Angle of rotation about the axis</source>
   <translation>軸まわりの回転角度</translation>
  </message>
  <message>
   <source>Axis</source>
   <translation>軸</translation>
  </message>
  <message>
   <source>Turns about the global X axis</source>
   <translation>全体座標のX軸まわりに回します</translation>
  </message>
  <message>
   <source>Turns about the global Y axis</source>
   <translation>全体座標のY軸まわりに回します</translation>
  </message>
  <message>
   <source>Turns about the global Z axis</source>
   <translation>全体座標のZ軸まわりに回します</translation>
  </message>
  <message>
   <source>X component of the axis</source>
   <translation>軸のX成分</translation>
  </message>
  <message>
   <source>Y component of the axis</source>
   <translation>軸のY成分</translation>
  </message>
  <message>
   <source>Z component of the axis</source>
   <translation>軸のZ成分</translation>
  </message>
  <message>
   <source>Admissible range of the value that you changed last: green is possible, red is not. The mark shows the current value</source>
   <translation>最後に変えた値の許容範囲: 緑は可能、赤は不可能です。印は現在の値を示します</translation>
  </message>
  <message>
   <source>Pivot</source>
   <translation>回転中心</translation>
  </message>
  <message>
   <source>X of the centre of rotation</source>
   <translation>回転中心の X</translation>
  </message>
  <message>
   <source>Y of the centre of rotation</source>
   <translation>回転中心の Y</translation>
  </message>
  <message>
   <source>Z of the centre of rotation</source>
   <translation>回転中心の Z</translation>
  </message>
  <message>
   <source>Centre of Handle</source>
   <translation>ハンドルの中心</translation>
  </message>
  <message>
   <source>Turns about the centre of the handle's vertices</source>
   <translation>ハンドルの頂点の中心まわりに回します</translation>
  </message>
  <message>
   <source>Move</source>
   <translation>移動</translation>
  </message>
  <message>
   <source>The arrows move the pivot; the shape stays unchanged</source>
   <translation>矢印で回転中心を動かします。形は変わりません</translation>
  </message>
  <message>
   <source>Mouse</source>
   <translation>マウス</translation>
  </message>
  <message>
   <source>Arrows</source>
   <translation>矢印</translation>
  </message>
  <message>
   <source>Shows arrows and arcs in the 3D view for dragging the handle</source>
   <translation>ハンドルをドラッグする矢印と円弧を3Dビューに表示します</translation>
  </message>
  <message>
   <source>Drag points</source>
   <translation>点をドラッグ</translation>
  </message>
  <message>
   <source>Drags the point under the mouse in the plane of the view; its rotation follows the sheet. A point outside every handle becomes a new handle</source>
   <translation>マウスの下の点を画面の平面内でドラッグします。回転は板に従います。ハンドルの外の点は新しいハンドルになります</translation>
  </message>
  <message>
   <source>Snap to</source>
   <translation>刻み</translation>
  </message>
  <message>
   <source>Drags in steps; Ctrl reverses this choice while you hold it</source>
   <translation>一定の刻みでドラッグします。Ctrl キーを押している間は逆になります</translation>
  </message>
  <message>
   <source>Step of translations</source>
   <translation>移動の刻み</translation>
  </message>
  <message>
   <source>Step of rotations</source>
   <translation>回転の刻み</translation>
  </message>
  <message>
   <source>Snap to points of parts</source>
   <translation>部品の点にスナップ</translation>
  </message>
  <message>
   <source>Drags the handle to the vertex or mid-point of an edge under the mouse, or level with it; Shift reverses this choice while you hold it</source>
   <translation>マウスの下の頂点または辺の中点まで、あるいはそれと同じ高さまでハンドルをドラッグします。Shift キーを押している間は逆になります</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>表示</translation>
  </message>
  <message>
   <source>Before</source>
   <translation>変形前</translation>
  </message>
  <message>
   <source>Shows the shape on its way from rest to the full motion; the motion itself stays unchanged</source>
   <translation>初期状態から最終の動きまでの途中の形状を表示します。動きそのものは変わりません</translation>
  </message>
  <message>
   <source>After</source>
   <translation>変形後</translation>
  </message>
  <message>
   <source>Original</source>
   <translation>元の形</translation>
  </message>
  <message>
   <source>Shows the shape at rest, transparent</source>
   <translation>初期形状を半透明で表示します</translation>
  </message>
  <message>
   <source>Form features</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Shows the displacement and the rotation of every form feature</source>
   <translation>各形状特徴の移動量と回転量を表示します</translation>
  </message>
  <message>
   <source>Control meshes</source>
   <translation>制御メッシュ</translation>
  </message>
  <message>
   <source>Shows the control meshes of the contacts as wireframes</source>
   <translation>接触の制御メッシュをワイヤーフレームで表示します</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>色</translation>
  </message>
  <message>
   <source>The quantity that the colours of the parts show</source>
   <translation>部品の色が表す量</translation>
  </message>
  <message>
   <source>None</source>
   <translation>なし</translation>
  </message>
  <message>
   <source>Displacement</source>
   <translation>変位</translation>
  </message>
  <message>
   <source>Triangle quality</source>
   <translation>三角形の品質</translation>
  </message>
  <message>
   <source>Contact gaps</source>
   <translation>接触の隙間</translation>
  </message>
  <message>
   <source>Stretch</source>
   <translation>伸び</translation>
  </message>
  <message>
   <source>Number of elements by quality. Bars: current shape; grey lines: at rest; red: limit</source>
   <translation>品質ごとの要素数。棒: 現在の形状、灰色の線: 初期形状、赤: 限界</translation>
  </message>
  <message>
   <source>Measure</source>
   <translation>計測</translation>
  </message>
  <message>
   <source>Measures the distance between two points that you click: at rest, now, and the change</source>
   <translation>クリックした 2 点間の距離を計測します: 初期状態、現在、およびその変化</translation>
  </message>
  <message>
   <source>Section Planes…</source>
   <translation>断面…</translation>
  </message>
  <message>
   <source>Opens FreeCAD's section planes, which cut the view along X, Y, Z or the line of sight</source>
   <translation>FreeCAD の断面機能を開きます。X、Y、Z または視線方向でビューを切断します</translation>
  </message>
  <message>
   <source>Reset</source>
   <translation>元に戻す</translation>
  </message>
  <message>
   <source>Returns this handle to rest</source>
   <translation>このハンドルを初期位置に戻します</translation>
  </message>
  <message>
   <source>Update results</source>
   <translation>結果の更新</translation>
  </message>
  <message>
   <source>When the result objects are updated; the 3D view always updates at once</source>
   <translation>結果オブジェクトを更新するタイミング。3D ビューは常にすぐ更新されます</translation>
  </message>
  <message>
   <source>Automatically</source>
   <translation>自動</translation>
  </message>
  <message>
   <source>While changing</source>
   <translation>変更中</translation>
  </message>
  <message>
   <source>On pause</source>
   <translation>止まったとき</translation>
  </message>
  <message>
   <source>On OK</source>
   <translation>OKのとき</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_needs</name>
  <message>
   <source>Close the open panel first.</source>
   <translation>先に開いているパネルを閉じてください。</translation>
  </message>
  <message>
   <source>The kernel does not work: see Check Installation.</source>
   <translation>カーネルが動作しません。「インストールの確認」をご覧ください。</translation>
  </message>
  <message>
   <source>Create a morph or import a part first.</source>
   <translation>先にモーフを作成するか、部品をインポートしてください。</translation>
  </message>
  <message>
   <source>Select one of the morphs first.</source>
   <translation>先にモーフを 1 つ選択してください。</translation>
  </message>
  <message>
   <source>Select a mesh or a shape first.</source>
   <translation>先にメッシュまたは形状を選択してください。</translation>
  </message>
  <message>
   <source>Add a part to the morph first.</source>
   <translation>先にモーフに部品を追加してください。</translation>
  </message>
  <message>
   <source>Add a second part to the morph first.</source>
   <translation>先にモーフに 2 つ目の部品を追加してください。</translation>
  </message>
  <message>
   <source>Select a part other than the primary part first.</source>
   <translation>先に主部品以外の部品を選択してください。</translation>
  </message>
  <message>
   <source>Select a part made from a shape of the document first.</source>
   <translation>先にドキュメントの形状から作った部品を選択してください。</translation>
  </message>
  <message>
   <source>Select a part made from a CAD shape first.</source>
   <translation>先に CAD 形状から作った部品を選択してください。</translation>
  </message>
  <message>
   <source>Select a region first.</source>
   <translation>先に領域を選択してください。</translation>
  </message>
  <message>
   <source>Select a form feature first.</source>
   <translation>先に形状特徴を選択してください。</translation>
  </message>
  <message>
   <source>Select two form features first.</source>
   <translation>先に形状特徴を 2 つ選択してください。</translation>
  </message>
  <message>
   <source>Select two or more form features first.</source>
   <translation>先に形状特徴を 2 つ以上選択してください。</translation>
  </message>
  <message>
   <source>Select a contact first.</source>
   <translation>先に接触を選択してください。</translation>
  </message>
  <message>
   <source>Mark a handle first.</source>
   <translation>先にハンドルを指定してください。</translation>
  </message>
  <message>
   <source>Save a pose first.</source>
   <translation>先に姿勢を保存してください。</translation>
  </message>
  <message>
   <source>Select a pose first.</source>
   <translation>先に姿勢を選択してください。</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_panels</name>
  <message>
   <source>The shape of {0} could not be computed</source>
   <translation>{0} の形状を計算できませんでした</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>停止</translation>
  </message>
  <message>
   <source>Stops the computation. Recompute the document to get the shape.</source>
   <translation>計算を停止します。形状を得るにはドキュメントを再計算してください。</translation>
  </message>
  <message>
   <source>Computing the final shape of {0}</source>
   <translation>{0} の最終形状を計算中</translation>
  </message>
  <message>
   <source>This shape could not be computed for an unknown reason ({0}). Please report it.</source>
   <translation>原因不明のエラーでこの形状を計算できませんでした({0})。ご報告ください。</translation>
  </message>
  <message>
   <source>There is not enough memory for this shape. Close other documents, or use a coarser mesh.</source>
   <translation>この形状を計算するにはメモリが足りません。ほかのドキュメントを閉じるか、より粗いメッシュを使ってください。</translation>
  </message>
  <message>
   <source>No values: no contact is in use.</source>
   <translation>値がありません。使用中の接触がありません。</translation>
  </message>
  <message>
   <source>{0} {1} on {2}</source>
   <translation>{0} {1}({2})</translation>
  </message>
  <message>
   <source>{0}, near {1}</source>
   <translation>{0}({1} の近く)</translation>
  </message>
  <message>
   <source>Leave at rest</source>
   <translation>静止したままにする</translation>
  </message>
  <message>
   <source>Do not use “{0}”</source>
   <translation>「{0}」を使わない</translation>
  </message>
  <message>
   <source>Remove from “{0}”</source>
   <translation>「{0}」から除く</translation>
  </message>
  <message>
   <source>Fixed</source>
   <translation>固定</translation>
  </message>
  <message>
   <source>Handle</source>
   <translation>ハンドル</translation>
  </message>
  <message>
   <source>Form feature</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Follower</source>
   <translation>追従領域</translation>
  </message>
  <message>
   <source>1 vertex</source>
   <translation>頂点 1 個</translation>
  </message>
  <message>
   <source>{0} vertices</source>
   <translation>頂点 {0} 個</translation>
  </message>
  <message>
   <source>Open Page</source>
   <translation>ページを開く</translation>
  </message>
  <message>
   <source>Parts: {0}, form features: {1}, contacts: {2}, joints: {3}</source>
   <translation>部品: {0}、形状特徴: {1}、接触: {2}、接合: {3}</translation>
  </message>
  <message>
   <source>Certificate</source>
   <translation>証明書</translation>
  </message>
  <message>
   <source>Certified</source>
   <translation>合格</translation>
  </message>
  <message>
   <source>Not certified</source>
   <translation>不合格</translation>
  </message>
  <message>
   <source>and {0} more</source>
   <translation>ほか {0} 件</translation>
  </message>
  <message>
   <source>The parts are farther apart than the gap distance: enter a larger one, or pick by hand.</source>
   <translation>部品が隙間の距離より離れています。より大きい距離を入力するか、手で選択してください。</translation>
  </message>
  <message>
   <source>Choose two parts: click on one, then on the other.</source>
   <translation>二つの部品を選んでください。一方をクリックし、次に他方をクリックします。</translation>
  </message>
  <message>
   <source>One side is empty: pick at least one vertex on each part.</source>
   <translation>片側が空です。各部品で頂点を一つ以上選んでください。</translation>
  </message>
  <message>
   <source>Click on a part…</source>
   <translation>部品をクリック…</translation>
  </message>
  <message>
   <source>Control mesh</source>
   <translation>制御メッシュ</translation>
  </message>
  <message>
   <source>Tied</source>
   <translation>結合</translation>
  </message>
  <message>
   <source>Rigid</source>
   <translation>剛結</translation>
  </message>
  <message>
   <source>The other part bends smoothly with it. Suits most flanges and weld seams.</source>
   <translation>相手の部品が滑らかに一緒に曲がります。ほとんどのフランジや溶接線に適します。</translation>
  </message>
  <message>
   <source>Every vertex keeps its position relative to the facing triangle. Suits glued faces and tied meshes.</source>
   <translation>各頂点が向かいの三角形に対する位置を保ちます。接着面や結合したメッシュに適します。</translation>
  </message>
  <message>
   <source>Both sides move as one rigid body. Suits bolts, rivets and spot welds.</source>
   <translation>両側が一つの剛体として動きます。ボルト、リベット、スポット溶接に適します。</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>自動</translation>
  </message>
  <message>
   <source>1 Whole part driven</source>
   <translation>1 部品全体を駆動</translation>
  </message>
  <message>
   <source>2 Contacts driven</source>
   <translation>2 接触を駆動</translation>
  </message>
  <message>
   <source>3 Contacts and edges driven</source>
   <translation>3 接触と縁を駆動</translation>
  </message>
  <message>
   <source>SheetMorph chooses from the contacts and form features.</source>
   <translation>接触と形状特徴から自動で選びます。</translation>
  </message>
  <message>
   <source>The control mesh drives every vertex; form features would lose their shape.</source>
   <translation>制御メッシュがすべての頂点を動かします。形状特徴は形を失います。</translation>
  </message>
  <message>
   <source>The control mesh drives contacts and followers; the rest bends like sheet metal, and form features keep their shape.</source>
   <translation>制御メッシュが接触と追従領域を動かします。残りは板金のように曲がり、形状特徴は形を保ちます。</translation>
  </message>
  <message>
   <source>As 2, and the control mesh also drives free edges inside it.</source>
   <translation>2 に加え、制御メッシュ内の自由縁も動かします。</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>表示</translation>
  </message>
  <message>
   <source>&lt;b&gt;{0}&lt;/b&gt; on {1}</source>
   <translation>{1} の &lt;b&gt;{0}&lt;/b&gt;</translation>
  </message>
  <message>
   <source>Relations: {0}</source>
   <translation>関係: {0}</translation>
  </message>
  <message>
   <source>Not a hole, slot or cylinder: it has no size to set.</source>
   <translation>穴でも長穴でも円筒でもないため、設定できる大きさがありません。</translation>
  </message>
  <message>
   <source>Tick the related form features, or choose “No new relation”.</source>
   <translation>関係する形状特徴をチェックするか、「新しい関係なし」を選んでください。</translation>
  </message>
  <message>
   <source>A pair has two form features: tick one other.</source>
   <translation>組は二つの形状特徴からなります。もう一つをチェックしてください。</translation>
  </message>
  <message>
   <source>all kinds</source>
   <translation>すべての種類</translation>
  </message>
  <message>
   <source>{0} of {1} checked</source>
   <translation>{1} 件中 {0} 件をチェック</translation>
  </message>
  <message>
   <source>{0} of {1} checked, {2} already in the document</source>
   <translation>{1} 件中 {0} 件をチェック、{2} 件はドキュメントに既存</translation>
  </message>
  <message>
   <source>{0} uncertain (?): point at a row to read why</source>
   <translation>{0} 件は不確か(?): 行を指すと理由が読めます</translation>
  </message>
  <message>
   <source>Nothing is checked. Check proposals, or cancel.</source>
   <translation>何もチェックされていません。提案をチェックするか、キャンセルしてください。</translation>
  </message>
  <message>
   <source>selected parts only</source>
   <translation>選択した部品のみ</translation>
  </message>
  <message>
   <source>Distance {0}; at rest {1}; change {2}</source>
   <translation>距離 {0}、初期状態 {1}、変化 {2}</translation>
  </message>
  <message>
   <source>Click the second point.</source>
   <translation>2 点目をクリックしてください。</translation>
  </message>
  <message>
   <source>Click two points of the parts.</source>
   <translation>部品の 2 点をクリックしてください。</translation>
  </message>
  <message>
   <source>Driven by the expression {0}</source>
   <translation>式 {0} で決まります</translation>
  </message>
  <message>
   <source>Computed in {0:.1f} ms, drawn in {1:.1f} ms</source>
   <translation>計算 {0:.1f} ms、描画 {1:.1f} ms</translation>
  </message>
  <message>
   <source>These parts will not follow, because no contact reaches them: {0}</source>
   <translation>次の部品は接触でつながっていないため追従しません: {0}</translation>
  </message>
  <message>
   <source>Shown at {0:.0f} % of the motion. {1}</source>
   <translation>動きの {0:.0f} % で表示しています。{1}</translation>
  </message>
  <message>
   <source>Computing the exact shape</source>
   <translation>正確な形状を計算中</translation>
  </message>
  <message>
   <source>Nothing has moved yet.</source>
   <translation>まだ何も動いていません。</translation>
  </message>
  <message>
   <source>{0} contacts open or close too far (see Propagation). The first:</source>
   <translation>{0} 個の接触の隙間が変わりすぎています(「伝播」を参照)。最初の接触:</translation>
  </message>
  <message>
   <source>Linear preview; the steel shape is computed on a pause. {0}</source>
   <translation>線形プレビュー。手を止めると鋼板の形状を計算します。{0}</translation>
  </message>
  <message>
   <source>Computing steel shape (step {0})</source>
   <translation>鋼板の形状を計算中 (ステップ {0})</translation>
  </message>
  <message>
   <source>Preview: refined on release. {0}</source>
   <translation>プレビュー: 離すと精密な形状を計算します。{0}</translation>
  </message>
  <message>
   <source>Final steel shape. {0}</source>
   <translation>鋼板の最終形状。{0}</translation>
  </message>
  <message>
   <source>At rest</source>
   <translation>初期状態</translation>
  </message>
  <message>
   <source>Back in the previous shape. Move the slider to blend again.</source>
   <translation>以前の形状に戻りました。スライダーを動かすと再びブレンドします。</translation>
  </message>
  <message>
   <source>Largest and mean distance, mm</source>
   <translation>最大と平均の距離、mm</translation>
  </message>
  <message>
   <source>Choose a pose.</source>
   <translation>姿勢を選んでください。</translation>
  </message>
  <message>
   <source>and {0} more parts</source>
   <translation>ほか {0} 部品</translation>
  </message>
  <message>
   <source>Split into its {} pieces</source>
   <translation>つながっていない {} 個の部分に分割</translation>
  </message>
  <message>
   <source>Enter a distance for merging vertices, such as 0.01 mm.</source>
   <translation>頂点を統合する距離を入力してください(例: 0.01 mm)。</translation>
  </message>
  <message>
   <source>Nothing is chosen. Choose a repair, or cancel.</source>
   <translation>何も選ばれていません。修復を選ぶか、キャンセルしてください。</translation>
  </message>
  <message>
   <source>Choose a repair first.</source>
   <translation>先に修復を選んでください。</translation>
  </message>
  <message>
   <source>The parts follow in the background…</source>
   <translation>部品はバックグラウンドで追従します…</translation>
  </message>
  <message>
   <source>Mark a fixed region and a handle first.</source>
   <translation>先に固定領域とハンドルを指定してください。</translation>
  </message>
  <message>
   <source>No contact reaches these parts, so they stay at rest: mark a contact with a part above.</source>
   <translation>接触でつながっていないため、これらの部品は動きません。上の部品との接触を指定してください。</translation>
  </message>
  <message>
   <source>Contacts that transfer no motion: switched off, not reached, or not needed.</source>
   <translation>動きを伝えない接触: オフ、未到達、または不要。</translation>
  </message>
  <message>
   <source>Largest change of the gap between both sides</source>
   <translation>両側の隙間の最大の変化</translation>
  </message>
  <message>
   <source>Not reached</source>
   <translation>未到達</translation>
  </message>
  <message>
   <source>Contacts not in use</source>
   <translation>使われていない接触</translation>
  </message>
  <message>
   <source>primary</source>
   <translation>主部品</translation>
  </message>
  <message>
   <source>off</source>
   <translation>オフ</translation>
  </message>
  <message>
   <source>not in use</source>
   <translation>不使用</translation>
  </message>
  <message>
   <source>from {0}</source>
   <translation>{0} から</translation>
  </message>
  <message>
   <source>step {0}</source>
   <translation>ステップ {0}</translation>
  </message>
  <message>
   <source>Change one value to see its admissible range.</source>
   <translation>値を一つ変えると、その許容範囲を示します。</translation>
  </message>
  <message>
   <source>Searching the admissible range…</source>
   <translation>許容範囲を探しています…</translation>
  </message>
  <message>
   <source>{0}; beyond this, triangles flip</source>
   <translation>{0}、これを超えると三角形が裏返ります</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>角度</translation>
  </message>
  <message>
   <source>{0}: {1} to {2}{3}</source>
   <translation>{0}: {1} ～ {2}{3}</translation>
  </message>
  <message>
   <source>{0}; beyond this: {1}</source>
   <translation>{0}、これを超えると: {1}</translation>
  </message>
  <message>
   <source>{0}: at least {1} to {2}{3}</source>
   <translation>{0}: 少なくとも {1} ～ {2}{3}</translation>
  </message>
  <message>
   <source>Elements: aspect</source>
   <translation>要素: アスペクト比</translation>
  </message>
  <message>
   <source>Elements: warpage</source>
   <translation>要素: そり</translation>
  </message>
  <message>
   <source>Elements: skew</source>
   <translation>要素: スキュー</translation>
  </message>
  <message>
   <source>Elements: taper</source>
   <translation>要素: テーパー</translation>
  </message>
  <message>
   <source>Elements: Jacobian</source>
   <translation>要素: ヤコビアン</translation>
  </message>
  <message>
   <source>Elements: smallest angle</source>
   <translation>要素: 最小角度</translation>
  </message>
  <message>
   <source>Elements: largest angle</source>
   <translation>要素: 最大角度</translation>
  </message>
  <message>
   <source>Elements: shortest edge</source>
   <translation>要素: 最短辺</translation>
  </message>
  <message>
   <source>; {0} of {1} elements beyond the limit of {2:g}</source>
   <translation>、{1} 要素中 {0} 要素が限界 {2:g} を超過</translation>
  </message>
  <message>
   <source>No variants yet.</source>
   <translation>まだバリアントがありません。</translation>
  </message>
  <message>
   <source>Folder for the Variants</source>
   <translation>バリアントのフォルダー</translation>
  </message>
  <message>
   <source>{0}. Double-click a row to apply the variant.</source>
   <translation>{0}。行をダブルクリックすると、そのバリアントを適用します。</translation>
  </message>
  <message>
   <source>Variants are still being computed. Wait, or stop them.</source>
   <translation>バリアントを計算中です。待つか、停止してください。</translation>
  </message>
  <message>
   <source>Stopped: the document has changed.</source>
   <translation>停止しました: ドキュメントが変更されました。</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>名前</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>変数</translation>
  </message>
  <message>
   <source>From</source>
   <translation>から</translation>
  </message>
  <message>
   <source>To</source>
   <translation>まで</translation>
  </message>
  <message>
   <source>smallest corner, °</source>
   <translation>最小の角、°</translation>
  </message>
  <message>
   <source>stretch, %</source>
   <translation>伸び、%</translation>
  </message>
  <message>
   <source>passed</source>
   <translation>合格</translation>
  </message>
  <message>
   <source>failed</source>
   <translation>不合格</translation>
  </message>
  <message>
   <source>refused</source>
   <translation>拒否</translation>
  </message>
  <message>
   <source>error</source>
   <translation>エラー</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>番号</translation>
  </message>
  <message>
   <source>State</source>
   <translation>状態</translation>
  </message>
  <message>
   <source>“{0}” for “{1}” is not a number.</source>
   <translation>「{1}」の値「{0}」は数値ではありません。</translation>
  </message>
  <message>
   <source>Median thickness &lt;b&gt;{0}&lt;/b&gt;, from {1} to {2}</source>
   <translation>板厚の中央値 &lt;b&gt;{0}&lt;/b&gt;、{1} ～ {2}</translation>
  </message>
  <message>
   <source>Holes through both skins: {0}</source>
   <translation>両面を貫く穴: {0} 個</translation>
  </message>
  <message>
   <source>Thick regions (stay rigid): {0}</source>
   <translation>厚い領域(剛体のまま): {0} 個</translation>
  </message>
  <message>
   <source>{0} walls and thick regions: no thickness</source>
   <translation>{0} 側面と厚い領域: 板厚なし</translation>
  </message>
  <message>
   <source>'{0}' is not a thin solid: {1}.</source>
   <translation>「{0}」は薄肉ソリッドではありません: {1}。</translation>
  </message>
  <message>
   <source>worst aspect</source>
   <translation>最悪のアスペクト比</translation>
  </message>
  <message>
   <source>worst warpage</source>
   <translation>最大のそり</translation>
  </message>
  <message>
   <source>worst skew</source>
   <translation>最大のスキュー</translation>
  </message>
  <message>
   <source>worst taper</source>
   <translation>最大のテーパー</translation>
  </message>
  <message>
   <source>worst Jacobian</source>
   <translation>最悪のヤコビアン</translation>
  </message>
  <message>
   <source>smallest corner</source>
   <translation>最小の角</translation>
  </message>
  <message>
   <source>largest corner</source>
   <translation>最大の角</translation>
  </message>
  <message>
   <source>shortest edge</source>
   <translation>最短の辺</translation>
  </message>
  <message>
   <source>largest displacement</source>
   <translation>最大の変位</translation>
  </message>
  <message>
   <source>largest stretch</source>
   <translation>最大の伸び</translation>
  </message>
  <message>
   <source>largest change</source>
   <translation>最大の変化</translation>
  </message>
  <message>
   <source>Vertex</source>
   <translation>頂点</translation>
  </message>
  <message>
   <source>Mid-point</source>
   <translation>中点</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_picking</name>
  <message>
   <source>Click picks, Shift adds, Ctrl removes.</source>
   <translation>クリックで選択、Shiftで追加、Ctrlで除去。</translation>
  </message>
  <message>
   <source>Paint with the left button. The wheel changes the size, Ctrl+wheel zooms. Ctrl+paint removes.</source>
   <translation>左ボタンでなぞります。ホイールで大きさ、Ctrl+ホイールで拡大縮小。Ctrl+なぞりで除去。</translation>
  </message>
  <message>
   <source>Drag from corner to corner. Shift adds, Ctrl removes.</source>
   <translation>角から角へドラッグします。Shiftで追加、Ctrlで除去。</translation>
  </message>
  <message>
   <source>Hold the left button and draw an outline. Shift adds, Ctrl removes.</source>
   <translation>左ボタンを押したまま輪郭を描きます。Shift で追加、Ctrl で除去。</translation>
  </message>
  <message>
   <source>Vertex</source>
   <translation>頂点</translation>
  </message>
  <message>
   <source>Picks single vertices</source>
   <translation>頂点を一つずつ選びます</translation>
  </message>
  <message>
   <source>Facet</source>
   <translation>三角形</translation>
  </message>
  <message>
   <source>Picks single facets</source>
   <translation>三角形を一つずつ選びます</translation>
  </message>
  <message>
   <source>Face</source>
   <translation>面</translation>
  </message>
  <message>
   <source>Picks a face up to its creases</source>
   <translation>折れ目までの面を選びます</translation>
  </message>
  <message>
   <source>Hole rim</source>
   <translation>穴の縁</translation>
  </message>
  <message>
   <source>Picks the rim of a hole with one click near it</source>
   <translation>近くを一度クリックして穴の縁を選びます</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>部品</translation>
  </message>
  <message>
   <source>Picks the whole connected part</source>
   <translation>つながった部品全体を選びます</translation>
  </message>
  <message>
   <source>Brush</source>
   <translation>ブラシ</translation>
  </message>
  <message>
   <source>Picks everything that you paint over; the wheel changes the size of the brush</source>
   <translation>なぞった所を選びます。ホイールでブラシの大きさを変えます</translation>
  </message>
  <message>
   <source>Rectangle</source>
   <translation>長方形</translation>
  </message>
  <message>
   <source>Picks everything inside a rectangle that you draw</source>
   <translation>描いた長方形の中をすべて選びます</translation>
  </message>
  <message>
   <source>Lasso</source>
   <translation>投げ縄</translation>
  </message>
  <message>
   <source>Picks everything inside an outline that you draw</source>
   <translation>描いた輪郭の中をすべて選びます</translation>
  </message>
  <message>
   <source>New</source>
   <translation>置き換え</translation>
  </message>
  <message>
   <source>Replaces the selection (the brush adds)</source>
   <translation>選択を置き換えます(ブラシは追加します)</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>追加</translation>
  </message>
  <message>
   <source>Adds to the selection, as with Shift</source>
   <translation>Shift と同じく、選択に追加します</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>除去</translation>
  </message>
  <message>
   <source>Removes from the selection, as with Ctrl</source>
   <translation>Ctrl と同じく、選択から除きます</translation>
  </message>
  <message>
   <source>Crease angle</source>
   <translation>折れ角</translation>
  </message>
  <message>
   <source>A face or a rim ends where the surface bends by more than this angle</source>
   <translation>面や縁は、表面がこの角度より大きく折れる所で終わります</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>穴の周りの輪</translation>
  </message>
  <message>
   <source>Number of vertex rings around the rim that are picked with it</source>
   <translation>縁とともに選ぶ、周りの頂点の輪の数</translation>
  </message>
  <message>
   <source>Brush radius</source>
   <translation>ブラシの半径</translation>
  </message>
  <message>
   <source>Radius of the brush on the screen; the wheel changes it</source>
   <translation>画面上のブラシの半径。ホイールで変わります</translation>
  </message>
  <message>
   <source> px</source>
   <translation> px</translation>
  </message>
  <message>
   <source>Select through</source>
   <translation>透過して選択</translation>
  </message>
  <message>
   <source>Also picks vertices that other parts or facets hide</source>
   <translation>他の部品や面に隠れた頂点も選びます</translation>
  </message>
  <message>
   <source>Grow</source>
   <translation>広げる</translation>
  </message>
  <message>
   <source>Adds one ring of neighbouring vertices</source>
   <translation>隣の頂点の輪を一つ加えます</translation>
  </message>
  <message>
   <source>Shrink</source>
   <translation>狭める</translation>
  </message>
  <message>
   <source>Removes the outermost ring of vertices</source>
   <translation>一番外の頂点の輪を除きます</translation>
  </message>
  <message>
   <source>Invert</source>
   <translation>反転</translation>
  </message>
  <message>
   <source>Picks the vertices that are not picked now, and releases the others</source>
   <translation>選択されている頂点と選択されていない頂点を入れ替えます</translation>
  </message>
  <message>
   <source>Undo Pick</source>
   <translation>選択を戻す</translation>
  </message>
  <message>
   <source>Undoes the last pick</source>
   <translation>最後の選択を取り消します</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>クリア</translation>
  </message>
  <message>
   <source>Clears the selection</source>
   <translation>選択を解除します</translation>
  </message>
  <message>
   <source>All Holes</source>
   <translation>すべての穴</translation>
  </message>
  <message>
   <source>Picks the rims of all holes of the part</source>
   <translation>部品のすべての穴の縁を選びます</translation>
  </message>
  <message>
   <source>Advanced</source>
   <translation>詳細</translation>
  </message>
  <message>
   <source>Shows the selector of the picked vertices</source>
   <translation>選択した頂点のセレクターを表示します</translation>
  </message>
  <message>
   <source>Selector, such as {"face_at": [x, y, z]}</source>
   <translation>セレクター (例: {"face_at": [x, y, z]})</translation>
  </message>
  <message>
   <source>Selector of the picked vertices, as in a recipe, in the coordinates of the part's file. Type another one and press Enter</source>
   <translation>選択した頂点のセレクター(レシピと同じ書式、部品ファイルの座標)。別のセレクターを入力して Enter を押してください</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_pose</name>
  <message>
   <source>Blend Poses</source>
   <translation>姿勢をブレンド</translation>
  </message>
  <message>
   <source>From</source>
   <translation>始め</translation>
  </message>
  <message>
   <source>The pose at 0 %</source>
   <translation>0 % の姿勢</translation>
  </message>
  <message>
   <source>To</source>
   <translation>終わり</translation>
  </message>
  <message>
   <source>The pose at 100 %</source>
   <translation>100 % の姿勢</translation>
  </message>
  <message>
   <source>Position of the morph between the two poses</source>
   <translation>二つの姿勢の間でのモーフの位置</translation>
  </message>
  <message>
   <source>The same as a number; values below 0 or above 100 % extrapolate the motion</source>
   <translation>同じ値を数値で指定します。0 % 未満や 100 % 超では動きを延長します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_preferences</name>
  <message>
   <source>General</source>
   <translation>一般</translation>
  </message>
  <message>
   <source>Moving handles</source>
   <translation>ハンドルを動かす</translation>
  </message>
  <message>
   <source>Update results</source>
   <translation>結果の更新</translation>
  </message>
  <message>
   <source>When the result objects are updated; the 3D view always updates at once. Automatically: at once if this takes less than 50 ms, otherwise on a pause</source>
   <translation>結果オブジェクトを更新するタイミング。3D ビューは常にすぐ更新されます。自動: 50 ms 未満ならすぐ、それ以外は止まったとき</translation>
  </message>
  <message>
   <source>Automatically</source>
   <translation>自動</translation>
  </message>
  <message>
   <source>While changing</source>
   <translation>変更中</translation>
  </message>
  <message>
   <source>On pause</source>
   <translation>止まったとき</translation>
  </message>
  <message>
   <source>On OK</source>
   <translation>OKのとき</translation>
  </message>
  <message>
   <source>Shows arrows for dragging when the Move Handle panel opens</source>
   <translation>「ハンドルを動かす」を開いたとき、ドラッグ用の矢印を表示します</translation>
  </message>
  <message>
   <source>Arrows and arcs in the view</source>
   <translation>ビューに矢印と円弧を表示</translation>
  </message>
  <message>
   <source>Moves in steps while you drag with the mouse</source>
   <translation>マウスでドラッグするとき、刻みに合わせて動かします</translation>
  </message>
  <message>
   <source>Snap to steps</source>
   <translation>刻みに合わせる</translation>
  </message>
  <message>
   <source>Length step</source>
   <translation>長さの刻み</translation>
  </message>
  <message>
   <source>Translations by the mouse snap to multiples of this length</source>
   <translation>マウスによる移動をこの長さの倍数に合わせます</translation>
  </message>
  <message>
   <source>Angle step</source>
   <translation>角度の刻み</translation>
  </message>
  <message>
   <source>Rotations by the mouse snap to multiples of this angle</source>
   <translation>マウスによる回転をこの角度の倍数に合わせます</translation>
  </message>
  <message>
   <source>Picking</source>
   <translation>選択</translation>
  </message>
  <message>
   <source>Crease angle</source>
   <translation>折れ角</translation>
  </message>
  <message>
   <source>A face ends where the sheet bends by more than this angle</source>
   <translation>板がこの角度より大きく折れる所で面は終わります</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>穴の周りの輪</translation>
  </message>
  <message>
   <source>Number of vertex rings around the rim that belong to a hole</source>
   <translation>穴に含める、縁の周りの頂点の輪の数</translation>
  </message>
  <message>
   <source>Brush radius</source>
   <translation>ブラシの半径</translation>
  </message>
  <message>
   <source>Radius of the brush on the screen</source>
   <translation>画面上のブラシの半径</translation>
  </message>
  <message>
   <source> px</source>
   <translation> px</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>色</translation>
  </message>
  <message>
   <source>Fixed regions</source>
   <translation>固定領域</translation>
  </message>
  <message>
   <source>Fixed regions are drawn in this colour</source>
   <translation>固定領域をこの色で描きます</translation>
  </message>
  <message>
   <source>Handles</source>
   <translation>ハンドル</translation>
  </message>
  <message>
   <source>Handles are drawn in this colour</source>
   <translation>ハンドルをこの色で描きます</translation>
  </message>
  <message>
   <source>Form features</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Form features are drawn in this colour</source>
   <translation>形状特徴をこの色で描きます</translation>
  </message>
  <message>
   <source>Followers</source>
   <translation>追従領域</translation>
  </message>
  <message>
   <source>Followers are drawn in this colour</source>
   <translation>追従領域をこの色で描きます</translation>
  </message>
  <message>
   <source>First side of contacts</source>
   <translation>接触の一つ目の側</translation>
  </message>
  <message>
   <source>The first side of contacts is drawn in this colour</source>
   <translation>接触の一つ目の側をこの色で描きます</translation>
  </message>
  <message>
   <source>Second side of contacts</source>
   <translation>接触の二つ目の側</translation>
  </message>
  <message>
   <source>The second side of contacts is drawn in this colour</source>
   <translation>接触の二つ目の側をこの色で描きます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_prepare</name>
  <message>
   <source>Prepare Mesh</source>
   <translation>メッシュを準備</translation>
  </message>
  <message>
   <source>Preview</source>
   <translation>プレビュー</translation>
  </message>
  <message>
   <source>Findings</source>
   <translation>診断結果</translation>
  </message>
  <message>
   <source>Repairs</source>
   <translation>修復</translation>
  </message>
  <message>
   <source>Unit of coordinates</source>
   <translation>座標の単位</translation>
  </message>
  <message>
   <source>Converts the coordinates from this unit to mm</source>
   <translation>座標をこの単位から mm に変換します</translation>
  </message>
  <message>
   <source>The unit of the file</source>
   <translation>ファイルの単位</translation>
  </message>
  <message>
   <source>Merge vertices within</source>
   <translation>頂点を統合する距離</translation>
  </message>
  <message>
   <source>Closes cuts and T-junctions, removes duplicate facets and reorients facets that face the wrong way</source>
   <translation>切れ目と T 字接合を閉じ、重複した面を除き、裏返った面の向きを直します</translation>
  </message>
  <message>
   <source>Vertices closer than this are merged</source>
   <translation>これより近い頂点を一つに統合します</translation>
  </message>
  <message>
   <source>Remesh with edges of</source>
   <translation>再メッシュの辺の長さ</translation>
  </message>
  <message>
   <source>Creates well-shaped triangles on the present facets. Flat faces stay exact; edges are shorter at holes and bends</source>
   <translation>現在の面の上に形の良い三角形を作ります。平面は正確に保たれ、穴と曲げでは辺が短くなります</translation>
  </message>
  <message>
   <source>Edge length on flat faces</source>
   <translation>平面での辺の長さ</translation>
  </message>
  <message>
   <source>Round rims</source>
   <translation>丸い縁</translation>
  </message>
  <message>
   <source>How the rims of round holes are remeshed</source>
   <translation>丸穴の縁の再メッシュの方法</translation>
  </message>
  <message>
   <source>keep polygon</source>
   <translation>多角形のまま</translation>
  </message>
  <message>
   <source>fit to circle</source>
   <translation>円に合わせる</translation>
  </message>
  <message>
   <source>Bend as one sheet (thin solid)</source>
   <translation>一枚の板として曲げる（薄肉ソリッド）</translation>
  </message>
  <message>
   <source>Both skins follow one sheet and keep their distance, if the part is recognised as a thin solid</source>
   <translation>薄肉ソリッドと認識された場合、両面が一枚の板に従い、間隔を保ちます</translation>
  </message>
  <message>
   <source>Split into pieces</source>
   <translation>つながっていない部分に分割</translation>
  </message>
  <message>
   <source>Turns each unconnected piece into a part of its own, so that contacts can join them. Possible while nothing is marked on the part</source>
   <translation>つながっていない部分をそれぞれ独立した部品にし、接触でつなげるようにします。部品に何も指定されていない間だけ可能です</translation>
  </message>
  <message>
   <source>Shows the new mesh in the 3D view without changing the part</source>
   <translation>部品を変えずに、新しいメッシュを 3D ビューに表示します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_propagation</name>
  <message>
   <source>Propagation</source>
   <translation>伝播</translation>
  </message>
  <message>
   <source>Local: from part to part along contacts. Single: one control mesh around everything. Whole: all parts in one solve</source>
   <translation>局所: 接触に沿って部品から部品へ。単一: 全体を囲む一つの制御メッシュ。全体: すべての部品を一度に解く</translation>
  </message>
  <message>
   <source>Local: from contact to contact</source>
   <translation>局所: 接触から接触へ</translation>
  </message>
  <message>
   <source>Single: one control mesh for all</source>
   <translation>単一: 全体に一つの制御メッシュ</translation>
  </message>
  <message>
   <source>Whole: all parts in one solve</source>
   <translation>全体: すべての部品を一度に解く</translation>
  </message>
  <message>
   <source>Subdivision</source>
   <translation>細分</translation>
  </message>
  <message>
   <source>Number of subdivisions of the control meshes. More follow finer bends but take longer; 3 suits most sheets</source>
   <translation>制御メッシュの細分の回数。多いほど細かい曲がりに追従しますが、時間がかかります。ほとんどの板では 3 が適切です</translation>
  </message>
  <message>
   <source>Smoothness</source>
   <translation>滑らかさ</translation>
  </message>
  <message>
   <source>Smoothness of the control meshes. Small values follow the driving part closely, large values even out its details</source>
   <translation>制御メッシュの滑らかさ。小さい値は駆動側の部品に忠実に従い、大きい値は細部をならします</translation>
  </message>
  <message>
   <source>Loose pieces</source>
   <translation>離れた部分</translation>
  </message>
  <message>
   <source>How unconstrained pieces of a part behave while others move. Stay: at rest, with a warning. Move along: with the nearest constrained piece. Error: the morph fails</source>
   <translation>他の部分が動くときの、拘束されていない部分の扱い。静止: 警告を出して動かない。追従: 最も近い拘束された部分に従う。エラー: モーフは失敗する</translation>
  </message>
  <message>
   <source>stay</source>
   <translation>静止</translation>
  </message>
  <message>
   <source>move along</source>
   <translation>追従</translation>
  </message>
  <message>
   <source>error</source>
   <translation>エラー</translation>
  </message>
  <message>
   <source>Click a row to show the part or contact in the 3D view</source>
   <translation>行をクリックすると、部品や接触を 3D ビューに表示します</translation>
  </message>
  <message>
   <source>Part, contact</source>
   <translation>部品、接触</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>種類</translation>
  </message>
  <message>
   <source>Gap, mm</source>
   <translation>隙間、mm</translation>
  </message>
  <message>
   <source>Show control meshes</source>
   <translation>制御メッシュを表示</translation>
  </message>
  <message>
   <source>Shows the control mesh of the selected contact, or all control meshes, as wireframes</source>
   <translation>選択した接触の制御メッシュ、選択がなければすべての制御メッシュをワイヤーフレームで表示します</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>部品</translation>
  </message>
  <message>
   <source>Mode</source>
   <translation>モード</translation>
  </message>
  <message>
   <source>How the part follows. The handles deform the primary part</source>
   <translation>部品が追従する方法。主部品はハンドルで変形します</translation>
  </message>
  <message>
   <source>Set as Primary</source>
   <translation>主部品にする</translation>
  </message>
  <message>
   <source>This part is deformed first, the others follow it</source>
   <translation>この部品が最初に変形し、他が追従します</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>接触</translation>
  </message>
  <message>
   <source>How one side follows the other</source>
   <translation>一方の側が他方に追従する方法</translation>
  </message>
  <message>
   <source>In use</source>
   <translation>使用中</translation>
  </message>
  <message>
   <source>Off: the contact stays in the document but transfers no motion</source>
   <translation>オフ: 接触はドキュメントに残りますが、動きを伝えません</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_region</name>
  <message>
   <source>Fixed Region</source>
   <translation>固定領域</translation>
  </message>
  <message>
   <source>Handle</source>
   <translation>ハンドル</translation>
  </message>
  <message>
   <source>Form Features</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Follower</source>
   <translation>追従領域</translation>
  </message>
  <message>
   <source>Nothing picked yet</source>
   <translation>まだ何も選択されていません</translation>
  </message>
  <message>
   <source>Skipped vertices that already belong to {0}.</source>
   <translation>すでに {0} に属する頂点を除外しました。</translation>
  </message>
  <message>
   <source>Picked: {0}, 1 piece</source>
   <translation>選択: {0}、1 か所</translation>
  </message>
  <message>
   <source>Nothing is picked: click on the part first.</source>
   <translation>何も選択されていません。先に部品をクリックしてください。</translation>
  </message>
  <message>
   <source>Picked: {0}, {1} pieces</source>
   <translation>選択: {0}、{1} か所</translation>
  </message>
  <message>
   <source>On {0}</source>
   <translation>対象: {0}</translation>
  </message>
  <message>
   <source>Region</source>
   <translation>領域</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>部品</translation>
  </message>
  <message>
   <source>Pick</source>
   <translation>選択</translation>
  </message>
  <message>
   <source>Nothing picked</source>
   <translation>何も選択されていません</translation>
  </message>
  <message>
   <source>Each hole is a separate feature</source>
   <translation>穴ごとに別の形状特徴</translation>
  </message>
  <message>
   <source>Separate pieces of the selection become separate form features that move independently</source>
   <translation>選択の離れた部分は、独立に動く別々の形状特徴になります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_study</name>
  <message>
   <source>Study</source>
   <translation>スタディ</translation>
  </message>
  <message>
   <source>Parameters</source>
   <translation>パラメータ</translation>
  </message>
  <message>
   <source>Parameters and their ranges. Double-click a name or a number to edit it</source>
   <translation>パラメータとその範囲。名前や数値をダブルクリックして編集します</translation>
  </message>
  <message>
   <source>Handle motions, form feature sizes, and the spreadsheet cells that drive them</source>
   <translation>ハンドルの動き、形状特徴の大きさ、それらを動かすスプレッドシートのセル</translation>
  </message>
  <message>
   <source>Adds this number as a parameter</source>
   <translation>この数値をパラメータに追加します</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>追加</translation>
  </message>
  <message>
   <source>Removes the selected parameters</source>
   <translation>選んだパラメータを外します</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>削除</translation>
  </message>
  <message>
   <source>Variants</source>
   <translation>バリアント</translation>
  </message>
  <message>
   <source>Sampling</source>
   <translation>サンプリング</translation>
  </message>
  <message>
   <source>How the values are sampled: three methods that fill the ranges evenly, or a grid of all combinations</source>
   <translation>値の選び方: 範囲を一様に満たす三つの方法、またはすべての組み合わせの格子</translation>
  </message>
  <message>
   <source>Latin hypercube</source>
   <translation>ラテン超方格</translation>
  </message>
  <message>
   <source>Sobol</source>
   <translation>Sobol</translation>
  </message>
  <message>
   <source>Halton</source>
   <translation>Halton</translation>
  </message>
  <message>
   <source>Full grid</source>
   <translation>全格子</translation>
  </message>
  <message>
   <source>Count</source>
   <translation>数</translation>
  </message>
  <message>
   <source>Number of variants; for a full grid, the largest number</source>
   <translation>バリアントの数。全格子では上限</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>シード</translation>
  </message>
  <message>
   <source>Another seed gives other values</source>
   <translation>シードを変えると値も変わります</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>基準</translation>
  </message>
  <message>
   <source>Criteria for every variant, separated by commas: stretch, angle, gap change, edge error, displacement, touching and others, or a parameter. Flipped triangles always fail</source>
   <translation>各バリアントの基準(コンマ区切り): stretch, angle, gap change, edge error, displacement, touching など、またはパラメータ。裏返った三角形は常に不合格です</translation>
  </message>
  <message>
   <source>such as stretch &lt;= 0.2, angle &gt;= 12</source>
   <translation>例：stretch &lt;= 0.2, angle &gt;= 12</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>フォルダー</translation>
  </message>
  <message>
   <source>Folder for the recipe, the study and the files of every variant. A stopped run continues there. Empty: only the table is kept</source>
   <translation>レシピ、スタディ、各バリアントのファイルを置くフォルダー。停止した計算はそこから続きます。空の場合は表だけを残します</translation>
  </message>
  <message>
   <source>keep only the table</source>
   <translation>表だけを残す</translation>
  </message>
  <message>
   <source>Chooses a folder</source>
   <translation>フォルダーを選びます</translation>
  </message>
  <message>
   <source>Computes the variants in separate processes; you can go on working in FreeCAD</source>
   <translation>バリアントを別プロセスで計算します。FreeCAD での作業は続けられます</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>実行</translation>
  </message>
  <message>
   <source>Stops the run; the finished variants stay in the table</source>
   <translation>計算を停止します。終わったバリアントは表に残ります</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>停止</translation>
  </message>
  <message>
   <source>Finished variants</source>
   <translation>終わったバリアント</translation>
  </message>
  <message>
   <source>One row per variant. Point at a state to read why the variant did not pass. Double-click a row to apply the variant</source>
   <translation>バリアントごとに一行。状態を指すと不合格の理由が読めます。行をダブルクリックすると、そのバリアントを適用します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_thickness</name>
  <message>
   <source>Thickness</source>
   <translation>板厚</translation>
  </message>
  <message>
   <source>Bend as one sheet (thin solid)</source>
   <translation>一枚の板として曲げる(薄肉ソリッド)</translation>
  </message>
  <message>
   <source>Both skins follow one sheet and keep their distance. Off: the closed surface bends as a surface</source>
   <translation>両面が一枚の板に従い、間隔を保ちます。オフ: 閉じた表面を面として曲げます</translation>
  </message>
  <message>
   <source>Mark Holes as Form Features</source>
   <translation>穴を形状特徴に指定</translation>
  </message>
  <message>
   <source>Turns every hole through both skins into a form feature, which keeps its shape, wall included</source>
   <translation>両面を貫くすべての穴を、側面も含めて形を保つ形状特徴にします</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>&amp;Parts</source>
   <translation>部品(&amp;P)</translation>
  </message>
  <message>
   <source>&amp;Regions</source>
   <translation>領域(&amp;R)</translation>
  </message>
  <message>
   <source>&amp;Features</source>
   <translation>形状特徴(&amp;F)</translation>
  </message>
  <message>
   <source>&amp;Contacts</source>
   <translation>接触(&amp;C)</translation>
  </message>
  <message>
   <source>&amp;Motion</source>
   <translation>動き(&amp;M)</translation>
  </message>
  <message>
   <source>&amp;Exchange</source>
   <translation>入出力(&amp;E)</translation>
  </message>
  <message>
   <source>SheetMorph Parts</source>
   <translation>SheetMorph 部品</translation>
  </message>
  <message>
   <source>SheetMorph Regions</source>
   <translation>SheetMorph 領域</translation>
  </message>
  <message>
   <source>SheetMorph Motion</source>
   <translation>SheetMorph 動き</translation>
  </message>
 </context>
</TS>
