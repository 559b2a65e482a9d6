<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
 <context>
  <name>SheetMorph_AddPart</name>
  <message>
   <source>Add Part</source>
   <translation>部品を追加</translation>
  </message>
  <message>
   <source>Adds the selected meshes and shapes to the morph as parts that deform</source>
   <translation>選択したメッシュと形状を、変形する部品としてモーフに加えます</translation>
  </message>
  <message>
   <source>What is selected has no faces.</source>
   <translation>選択したものには面がありません。</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_BlendPoses</name>
  <message>
   <source>Blend Poses…</source>
   <translation>姿勢を混ぜる…</translation>
  </message>
  <message>
   <source>Goes from one pose to another with a slider, and compares them</source>
   <translation>スライダーで姿勢から姿勢へ動かし、比べます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Certify</name>
  <message>
   <source>Certificate…</source>
   <translation>証明書…</translation>
  </message>
  <message>
   <source>Writes all deformed parts into a folder, reads them again, measures and judges them</source>
   <translation>変形したすべてのパーツをフォルダーに書き出し、読み直して測定・判定します</translation>
  </message>
  <message>
   <source>Certificate</source>
   <translation>証明書</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>基準</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CheckInstallation</name>
  <message>
   <source>Check Installation</source>
   <translation>インストールの確認</translation>
  </message>
  <message>
   <source>Shows whether the deformation kernel works, as a report to copy</source>
   <translation>変形カーネルが動作するかを、コピーできる報告として示します</translation>
  </message>
  <message>
   <source>Copy</source>
   <translation>コピー</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyAsMeshes</name>
  <message>
   <source>Copy as Meshes</source>
   <translation>メッシュとして複製</translation>
  </message>
  <message>
   <source>Copies the parts as ordinary meshes, as they are now or in the selected pose</source>
   <translation>部品を今の形または選択した姿勢で通常のメッシュとして複製します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyInPose</name>
  <message>
   <source>Copy in Pose</source>
   <translation>姿勢で複製</translation>
  </message>
  <message>
   <source>Copies the whole morph and puts the copy into the selected pose; the original stays</source>
   <translation>モーフ全体を複製し、複製を選択した姿勢にします。元はそのまま残ります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CreateMorph</name>
  <message>
   <source>Create Morph</source>
   <translation>モーフを作成</translation>
  </message>
  <message>
   <source>Creates a morph; selected meshes and shapes become its parts and stay as they are</source>
   <translation>モーフを作成します。選択したメッシュと形状は部品になり、元のまま残ります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_DeformedShape</name>
  <message>
   <source>Deformed Shape</source>
   <translation>変形した形状</translation>
  </message>
  <message>
   <source>Makes a shape of the selected part, deformed, with the faces of the one it was made from</source>
   <translation>選択した部品から、元の形状と同じ面を持つ変形した形状を作ります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportParts</name>
  <message>
   <source>These files are there already, and SheetMorph did not write them as they are now:</source>
   <translation>次のファイルはすでにあり、SheetMorph が書いたままのものではありません:</translation>
  </message>
  <message>
   <source>Write over them?</source>
   <translation>上書きしますか?</translation>
  </message>
  <message>
   <source>Export Parts…</source>
   <translation>部品を書き出す…</translation>
  </message>
  <message>
   <source>Writes all deformed parts into a folder, each in its own file format</source>
   <translation>変形した全部品を、それぞれのファイル形式でフォルダーに書き出します</translation>
  </message>
  <message>
   <source>Export Parts</source>
   <translation>部品をエクスポート</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportRecipe</name>
  <message>
   <source>Export Recipe…</source>
   <translation>レシピを書き出す…</translation>
  </message>
  <message>
   <source>Writes the morph as a recipe that also runs without FreeCAD</source>
   <translation>FreeCADなしでも実行できるレシピとしてモーフを書き出します</translation>
  </message>
  <message>
   <source>Export Recipe</source>
   <translation>レシピをエクスポート</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FeatureSettings</name>
  <message>
   <source>Form Feature Settings…</source>
   <translation>形状特徴の設定…</translation>
  </message>
  <message>
   <source>Says how the selected form feature turns, what it may do, and which size it has</source>
   <translation>選択した形状特徴の回り方、許される動き、大きさを決めます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindContacts</name>
  <message>
   <source>Find Contacts…</source>
   <translation>接触を探す…</translation>
  </message>
  <message>
   <source>Finds where parts lie on each other or are bolted; those you accept become contacts</source>
   <translation>部品が重なる所やボルト締めの所を探します。採用したものが接触になります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindFeatures</name>
  <message>
   <source>Find Features…</source>
   <translation>形状特徴を探す…</translation>
  </message>
  <message>
   <source>Finds holes and other features on all parts; those you accept become form features</source>
   <translation>全部品の穴などを探します。採用したものが形状特徴になります</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Flatten</name>
  <message>
   <source>Flatten</source>
   <translation>展開</translation>
  </message>
  <message>
   <source>Lays the selected part flat, as it is now and at rest: sketches of its blank and bend lines</source>
   <translation>選択した部品を今の形のまま平らに展開します: 曲げ線の入ったブランクのスケッチ</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FollowShape</name>
  <message>
   <source>Follow Shape</source>
   <translation>形状に追従</translation>
  </message>
  <message>
   <source>Meshes the body or shape that the selected part was made from as it is now; what was picked is found again, and what came out different is told and selected</source>
   <translation>選択した部品の元になったボディまたは形状を現在の状態でメッシュ化します。選択していた箇所は再び見つけられ、変わったものは通知され選択されます</translation>
  </message>
  <message>
   <source>“{0}” was {1}. Which one is it now?</source>
   <translation>「{0}」は{1}でした。現在はどれですか？</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_GroupFeatures</name>
  <message>
   <source>Group Form Features</source>
   <translation>形状特徴をまとめる</translation>
  </message>
  <message>
   <source>Lets the selected form features of a part move as one body</source>
   <translation>選択した同じ部品の形状特徴を一つの剛体として動かします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Guide</name>
  <message>
   <source>Guide</source>
   <translation>ガイド</translation>
  </message>
  <message>
   <source>Leads through a morph step by step: says what is missing and opens what is needed</source>
   <translation>モーフの作り方を一歩ずつ案内します。足りないものを示し、必要なパネルを開きます</translation>
  </message>
  <message>
   <source>Import a mesh or CAD file, or select meshes in the tree and create a morph.</source>
   <translation>メッシュかCADファイルを読み込むか、ツリーでメッシュを選んでモーフを作成してください。</translation>
  </message>
  <message>
   <source>This document has several morphs: select one of them in the tree.</source>
   <translation>この文書には複数のモーフがあります。ツリーで一つ選んでください。</translation>
  </message>
  <message>
   <source>The morph has no part yet: import a file or add a mesh.</source>
   <translation>モーフに部品がまだありません。ファイルを読み込むかメッシュを追加してください。</translation>
  </message>
  <message>
   <source>Parts: {count}; “{primary}” is deformed first.</source>
   <translation>部品 {count} 個。「{primary}」が最初に変形します。</translation>
  </message>
  <message>
   <source>“{source}” was edited: Follow Shape lets “{part}” follow.</source>
   <translation>「{source}」が編集されました。「形状に追従」で「{part}」が追従します。</translation>
  </message>
  <message>
   <source>Nothing is held yet: mark what stays where it is.</source>
   <translation>まだ何も固定されていません。動かない所を指定してください。</translation>
  </message>
  <message>
   <source>Fixed regions: {count}.</source>
   <translation>固定領域 {count} 個。</translation>
  </message>
  <message>
   <source>No hole keeps its shape yet: find them all, or pick those that matter. Or go on without.</source>
   <translation>形を保つ穴がまだありません。すべて探すか、必要な穴を選んでください。なしで進むこともできます。</translation>
  </message>
  <message>
   <source>Form features that keep their shape exactly: {count}.</source>
   <translation>形状特徴 {count} 個の形が正確に保たれます。</translation>
  </message>
  <message>
   <source>One part only: there is nothing to connect.</source>
   <translation>部品は一つだけで、つなぐものはありません。</translation>
  </message>
  <message>
   <source>One control mesh around everything moves all parts.</source>
   <translation>全体を囲む一つの制御メッシュがすべての部品を動かします。</translation>
  </message>
  <message>
   <source>Not connected with “{primary}”, so they would not follow: {parts}.</source>
   <translation>「{primary}」とつながっていないため追従しません: {parts}。</translation>
  </message>
  <message>
   <source>Contacts, reaching every part: {count}.</source>
   <translation>接触 {count} 個ですべての部品に届きます。</translation>
  </message>
  <message>
   <source>Nothing can be moved yet: mark what you want to move.</source>
   <translation>まだ動かせるものがありません。動かしたい所を指定してください。</translation>
  </message>
  <message>
   <source>Handles: {count}.</source>
   <translation>ハンドル {count} 個。</translation>
  </message>
  <message>
   <source>Comes when there is a fixed region and a handle.</source>
   <translation>固定領域とハンドルがそろうと使えます。</translation>
  </message>
  <message>
   <source>Everything is ready: move the handle and watch.</source>
   <translation>準備ができました。ハンドルを動かしてみてください。</translation>
  </message>
  <message>
   <source>Moved. Move on, export the parts, keep this as a pose, or study variants.</source>
   <translation>動かしました。さらに動かすか、部品を書き出すか、ポーズとして残すか、変種を調べてください。</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportPart</name>
  <message>
   <source>Mesh CAD Shapes</source>
   <translation>CAD 形状をメッシュ化</translation>
  </message>
  <message>
   <source>Longest edge (0 mm: a hundredth of the size)</source>
   <translation>最長の辺 (0 mm は大きさの百分の一)</translation>
  </message>
  <message>
   <source>“{0}” is no length; type one such as 5 mm.</source>
   <translation>“{0}” は長さではありません。5 mm のように入力してください。</translation>
  </message>
  <message>
   <source>Import Part…</source>
   <translation>部品を読み込む…</translation>
  </message>
  <message>
   <source>Imports a mesh as a part, with its exact positions, every property of a deck, or every solid of a CAD file, meshed</source>
   <translation>メッシュを正確な座標のままパーツとして、デッキの各プロパティ、または CAD ファイルの各ソリッドをメッシュ化して読み込みます</translation>
  </message>
  <message>
   <source>Import Part</source>
   <translation>部品をインポート</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportRecipe</name>
  <message>
   <source>Import Recipe…</source>
   <translation>レシピを読み込む…</translation>
  </message>
  <message>
   <source>Creates a morph from a recipe and the mesh files it names</source>
   <translation>レシピとそこに書かれたメッシュファイルからモーフを作成します</translation>
  </message>
  <message>
   <source>Import Recipe</source>
   <translation>レシピをインポート</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_KeepDistance</name>
  <message>
   <source>Keep Distance</source>
   <translation>距離を保つ</translation>
  </message>
  <message>
   <source>Lets two selected form features, of one part or of two, keep their distance</source>
   <translation>選択した二つの形状特徴(同じ部品でも別の部品でも)の距離を保ちます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MakeCoaxial</name>
  <message>
   <source>Make Coaxial</source>
   <translation>同軸にする</translation>
  </message>
  <message>
   <source>Lets two selected form features, of one part or of two, keep their common axis</source>
   <translation>選択した二つの形状特徴(同じ部品でも別の部品でも)の共通の軸を保ちます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Manual</name>
  <message>
   <source>SheetMorph Manual</source>
   <translation>SheetMorph マニュアル</translation>
  </message>
  <message>
   <source>Opens the manual in the browser, also without a network</source>
   <translation>ブラウザーでマニュアルを開きます。ネットワークは不要です</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkContact</name>
  <message>
   <source>Mark Contact…</source>
   <translation>接触を指定…</translation>
  </message>
  <message>
   <source>Joins two parts where they touch, so that one follows the other; select both, or click on them in the panel</source>
   <translation>触れ合う二つの部品をつなぎ、一方が他方に追従するようにします。両方を選ぶか、パネルで選んでください</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFeature</name>
  <message>
   <source>Mark Form Features…</source>
   <translation>形状特徴を指定…</translation>
  </message>
  <message>
   <source>Marks holes and other form features that move but keep their shape</source>
   <translation>動いても形を保つ穴などの形状特徴を指定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFixed</name>
  <message>
   <source>Mark Fixed Region…</source>
   <translation>固定領域を指定…</translation>
  </message>
  <message>
   <source>Marks a region that stays where it is, by picking in the 3D view</source>
   <translation>3Dビューで選んで、動かない領域を指定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFollower</name>
  <message>
   <source>Mark Follower…</source>
   <translation>追従領域を指定…</translation>
  </message>
  <message>
   <source>Marks a region that goes with the control meshes of the part's contacts</source>
   <translation>部品の接触の制御メッシュとともに動く領域を指定します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkHandle</name>
  <message>
   <source>Mark Handle…</source>
   <translation>ハンドルを指定…</translation>
  </message>
  <message>
   <source>Marks a region that is moved and turned as you say; the part follows</source>
   <translation>思いどおりに動かし回す領域を指定します。部品が追従します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MoveHandle</name>
  <message>
   <source>Move Handle…</source>
   <translation>ハンドルを動かす…</translation>
  </message>
  <message>
   <source>Moves and turns a handle; the parts follow while you change the values</source>
   <translation>ハンドルを動かし回します。値を変える間、部品が追従します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_OpenExample</name>
  <message>
   <source>Open Example…</source>
   <translation>例題を開く…</translation>
  </message>
  <message>
   <source>Opens an example assembly whose regions are marked, ready to move</source>
   <translation>領域を指定済みで、すぐ動かせる例題のアセンブリを開きます</translation>
  </message>
  <message>
   <source>Open Example</source>
   <translation>例を開く</translation>
  </message>
  <message>
   <source>Example</source>
   <translation>例</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_PrepareMesh</name>
  <message>
   <source>Prepare Mesh…</source>
   <translation>メッシュを準備…</translation>
  </message>
  <message>
   <source>Tells what is wrong with the mesh of the selected part, cures it and meshes it anew</source>
   <translation>選択した部品のメッシュの問題を示し、修復し、再メッシュします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Propagation</name>
  <message>
   <source>Propagation…</source>
   <translation>伝播…</translation>
  </message>
  <message>
   <source>Shows how the motion goes from the primary part through the contacts to the others</source>
   <translation>動きが主部品から接触を通って他の部品へ伝わる様子を示します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ReplaceFile</name>
  <message>
   <source>Replace File…</source>
   <translation>ファイルを置き換え…</translation>
  </message>
  <message>
   <source>Reads the changed file of the selected part; what was picked on it is found again, and what came out different is told and selected</source>
   <translation>選択した部品の変更されたファイルを読み込みます。選択していた箇所は再び見つけられ、変わったものは通知され選択されます</translation>
  </message>
  <message>
   <source>Replace File</source>
   <translation>ファイルを置き換え</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ResetMotion</name>
  <message>
   <source>Reset Motion</source>
   <translation>動きを戻す</translation>
  </message>
  <message>
   <source>Puts the selected handles, else all handles of the morph, back to rest</source>
   <translation>選択したハンドル、なければモーフの全ハンドルを初期位置に戻します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SavePose</name>
  <message>
   <source>Save Pose…</source>
   <translation>姿勢を保存…</translation>
  </message>
  <message>
   <source>Keeps where all handles are now, under a name to come back to</source>
   <translation>全ハンドルの今の位置に名前を付けて残し、後で戻れるようにします</translation>
  </message>
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
 </context>
 <context>
  <name>SheetMorph_SetPrimary</name>
  <message>
   <source>Set as Primary</source>
   <translation>主部品にする</translation>
  </message>
  <message>
   <source>Makes the selected part the primary: it is deformed first, the others follow it</source>
   <translation>選択した部品を主部品にします。最初に変形し、他の部品が追従します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Study</name>
  <message>
   <source>Study…</source>
   <translation>スタディ…</translation>
  </message>
  <message>
   <source>Computes many variants in the background, each certified, and shows them in a table</source>
   <translation>多くの変種を背景で計算し、それぞれ検証して表に示します</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ThicknessMap</name>
  <message>
   <source>Thickness…</source>
   <translation>板厚…</translation>
  </message>
  <message>
   <source>Shows in colours how thick the selected part is, and lets it bend as one sheet</source>
   <translation>選択した部品の板厚を色で示し、一枚の板として曲がるようにします</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_actions</name>
  <message>
   <source>This is a mistake of the program ({0}). Please report it.</source>
   <translation>これはプログラムの誤りです({0})。報告してください。</translation>
  </message>
  <message>
   <source>Cancelled; nothing was changed.</source>
   <translation>中止しました。何も変更されていません。</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>キャンセル</translation>
  </message>
  <message>
   <source>Cancelling…</source>
   <translation>中止しています…</translation>
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
   <source>The part on this side; or click on it in the 3D view</source>
   <translation>こちら側の部品。3Dビューで選ぶこともできます</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>種類</translation>
  </message>
  <message>
   <source>How the second part follows the first</source>
   <translation>二つ目の部品が一つ目にどう追従するか</translation>
  </message>
  <message>
   <source>In use</source>
   <translation>使用する</translation>
  </message>
  <message>
   <source>Off: the contact is kept but moves nothing, as if the weld were open</source>
   <translation>オフ: 接触は残りますが、溶接が外れたように何も動かしません</translation>
  </message>
  <message>
   <source>Vertices</source>
   <translation>頂点</translation>
  </message>
  <message>
   <source>Which vertices of both parts are joined</source>
   <translation>両部品のどの頂点をつなぐか</translation>
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
   <translation>隙間距離: 相手の部品からこの距離以内の頂点が接触に含まれます</translation>
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
   <source>What decides how the form feature turns</source>
   <translation>形状特徴の回り方を決めるもの</translation>
  </message>
  <message>
   <source>Free: the sheet turns it</source>
   <translation>自由: 板が回す</translation>
  </message>
  <message>
   <source>Interpolated: as the handles turn</source>
   <translation>補間: ハンドルの回転に合わせる</translation>
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
   <source>Angle of the rotation, any number of turns</source>
   <translation>回転角度(何回転でも可)</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>動き</translation>
  </message>
  <message>
   <source>What the form feature may do</source>
   <translation>形状特徴に許される動き</translation>
  </message>
  <message>
   <source>Free</source>
   <translation>自由</translation>
  </message>
  <message>
   <source>Fixed: stays where it is</source>
   <translation>固定: 動かない</translation>
  </message>
  <message>
   <source>Translation: never turns</source>
   <translation>平行移動: 回らない</translation>
  </message>
  <message>
   <source>Plane: shifts in a plane</source>
   <translation>平面: 平面内で動く</translation>
  </message>
  <message>
   <source>Line: shifts along a line</source>
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
   <source>Gives the hole, slot or cylinder a size of its own; the sheet around follows</source>
   <translation>穴・長穴・円筒に独自の大きさを与えます。周りの板が追従します</translation>
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
   <source>What the form feature keeps with the others that are ticked</source>
   <translation>チェックした他の形状特徴との間で保つもの</translation>
  </message>
  <message>
   <source>None to add</source>
   <translation>追加しない</translation>
  </message>
  <message>
   <source>Group: moves as one body with…</source>
   <translation>まとめる: 一つの剛体として動く相手…</translation>
  </message>
  <message>
   <source>Coaxial: keeps its axis with…</source>
   <translation>同軸: 軸を共有する相手…</translation>
  </message>
  <message>
   <source>Distance: keeps its distance to…</source>
   <translation>距離: 距離を保つ相手…</translation>
  </message>
  <message>
   <source>The form features it is related to</source>
   <translation>関係する形状特徴</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_find</name>
  <message>
   <source>Find Features</source>
   <translation>形状特徴を探す</translation>
  </message>
  <message>
   <source>Find Contacts</source>
   <translation>接触を探す</translation>
  </message>
  <message>
   <source>Size: diameter or length. Quality: how far the rim is off its form.</source>
   <translation>大きさ: 直径または長さ。品質: 縁が形からどれだけずれているか。</translation>
  </message>
  <message>
   <source>Size: of the place. Gap: between the parts, measured in the middle.</source>
   <translation>大きさ: 接触する所の大きさ。隙間: 部品の間を中央で測ったもの。</translation>
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
   <source>Shows one kind only; what is not shown is not taken</source>
   <translation>一種類だけ表示します。表示されないものは採用されません</translation>
  </message>
  <message>
   <source>From</source>
   <translation>最小</translation>
  </message>
  <message>
   <source>Hides what is smaller; what is hidden is not taken</source>
   <translation>これより小さいものを隠します。隠れたものは採用されません</translation>
  </message>
  <message>
   <source>to</source>
   <translation>最大</translation>
  </message>
  <message>
   <source>Hides what is larger; what is hidden is not taken</source>
   <translation>これより大きいものを隠します。隠れたものは採用されません</translation>
  </message>
  <message>
   <source>any size</source>
   <translation>制限なし</translation>
  </message>
  <message>
   <source>What was found; what is checked is taken. What the mouse is over lights up in the view</source>
   <translation>見つかったもの。チェックしたものを採用します。マウスを重ねるとビューで光ります</translation>
  </message>
  <message>
   <source>Checks everything that is shown</source>
   <translation>表示中のものをすべてチェックします</translation>
  </message>
  <message>
   <source>All</source>
   <translation>すべて</translation>
  </message>
  <message>
   <source>Unchecks everything</source>
   <translation>チェックをすべて外します</translation>
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
   <source>Rim off a circle, up to</source>
   <translation>縁の円からのずれの上限</translation>
  </message>
  <message>
   <source>Largest distance of a rim vertex from the circle, of its radius</source>
   <translation>縁の頂点の円からの最大距離(半径に対する比)</translation>
  </message>
  <message>
   <source>An edge bends more than</source>
   <translation>稜とみなす折れ角</translation>
  </message>
  <message>
   <source>Where the surface bends more than this it has an edge</source>
   <translation>面がこれより大きく折れる所を稜とします</translation>
  </message>
  <message>
   <source>Washer rings</source>
   <translation>ワッシャーの輪</translation>
  </message>
  <message>
   <source>Rings of triangles around a hole that keep their form with it</source>
   <translation>穴とともに形を保つ周りの三角形の輪の数</translation>
  </message>
  <message>
   <source>All kinds, surfaces and beads too</source>
   <translation>面やビードも含むすべての種類</translation>
  </message>
  <message>
   <source>Proposes planes, cylinders, flanges and beads as well</source>
   <translation>平面・円筒・フランジ・ビードも提案します</translation>
  </message>
  <message>
   <source>Largest gap</source>
   <translation>最大のすき間</translation>
  </message>
  <message>
   <source>Parts farther apart are not in contact; 0: as is proposed for these parts</source>
   <translation>これより離れた部品は接触しません。0: これらの部品に対する提案値</translation>
  </message>
  <message>
   <source>as proposed</source>
   <translation>提案値</translation>
  </message>
  <message>
   <source>Surfaces face within</source>
   <translation>面の向きの差</translation>
  </message>
  <message>
   <source>Largest angle between two surfaces in contact</source>
   <translation>接触する二つの面の間の最大角度</translation>
  </message>
  <message>
   <source>One contact for two parts</source>
   <translation>二部品に一つの接触</translation>
  </message>
  <message>
   <source>Joins all places in which two parts touch into one contact</source>
   <translation>二つの部品が触れ合うすべての所を一つの接触にまとめます</translation>
  </message>
  <message>
   <source>Searches anew with these tolerances</source>
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
   <source>The morph that the guide speaks of: the selected one, or the only one</source>
   <translation>ガイドの対象のモーフ(選択中のもの、または唯一のもの)</translation>
  </message>
  <message>
   <source>1  Parts</source>
   <translation>1  部品</translation>
  </message>
  <message>
   <source>2  What stays</source>
   <translation>2  動かない所</translation>
  </message>
  <message>
   <source>3  What keeps its shape</source>
   <translation>3  形を保つ所</translation>
  </message>
  <message>
   <source>4  What is joined</source>
   <translation>4  つながる所</translation>
  </message>
  <message>
   <source>5  What moves</source>
   <translation>5  動かす所</translation>
  </message>
  <message>
   <source>6  Move</source>
   <translation>6  動かす</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_menus</name>
  <message>
   <source>Do Not Use Contact</source>
   <translation>接触を使わない</translation>
  </message>
  <message>
   <source>Use Contact</source>
   <translation>接触を使う</translation>
  </message>
  <message>
   <source>Show What Is Wrong</source>
   <translation>問題を表示</translation>
  </message>
  <message>
   <source>Propagation…</source>
   <translation>伝播…</translation>
  </message>
  <message>
   <source>Edit Contact…</source>
   <translation>接触を編集…</translation>
  </message>
  <message>
   <source>Set as Primary</source>
   <translation>主部品にする</translation>
  </message>
  <message>
   <source>Follow Shape</source>
   <translation>形状に追従</translation>
  </message>
  <message>
   <source>Study…</source>
   <translation>スタディ…</translation>
  </message>
  <message>
   <source>Edit Region…</source>
   <translation>領域を編集…</translation>
  </message>
  <message>
   <source>Move Handle…</source>
   <translation>ハンドルを動かす…</translation>
  </message>
  <message>
   <source>Reset Motion</source>
   <translation>動きを戻す</translation>
  </message>
  <message>
   <source>Form Feature Settings…</source>
   <translation>形状特徴の設定…</translation>
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
   <source>The handle that is moved</source>
   <translation>動かすハンドル</translation>
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
   <source>Translation along the global X axis</source>
   <translation>全体座標のX軸に沿う移動</translation>
  </message>
  <message>
   <source>Y</source>
   <translation>Y</translation>
  </message>
  <message>
   <source>Translation along the global Y axis</source>
   <translation>全体座標のY軸に沿う移動</translation>
  </message>
  <message>
   <source>Z</source>
   <translation>Z</translation>
  </message>
  <message>
   <source>Translation along the global Z axis</source>
   <translation>全体座標のZ軸に沿う移動</translation>
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
   <source>How far the value that was changed last may go: red beyond, where something breaks. The mark is where it is</source>
   <translation>最後に変えた値がどこまで行けるか：赤はその先で、何かが壊れます。印は現在の値です</translation>
  </message>
  <message>
   <source>Pivot</source>
   <translation>回転中心</translation>
  </message>
  <message>
   <source>X of the point that the handle turns about</source>
   <translation>ハンドルの回転中心の X</translation>
  </message>
  <message>
   <source>Y of the point that the handle turns about</source>
   <translation>ハンドルの回転中心の Y</translation>
  </message>
  <message>
   <source>Z of the point that the handle turns about</source>
   <translation>ハンドルの回転中心の Z</translation>
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
   <source>The arrows move the pivot; the shape stays as it is</source>
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
   <source>Shows arrows and arcs in the 3D view that drag the handle</source>
   <translation>ハンドルをドラッグする矢印と円弧を3Dビューに表示します</translation>
  </message>
  <message>
   <source>Drag points</source>
   <translation>点をドラッグ</translation>
  </message>
  <message>
   <source>Drags the point under the mouse in the plane of the view; the sheet decides how it turns. A point that is in no handle becomes one</source>
   <translation>マウスの下の点を画面の平面内でドラッグします。回転は板が決めます。ハンドルにない点は新しいハンドルになります</translation>
  </message>
  <message>
   <source>Snap to</source>
   <translation>刻み</translation>
  </message>
  <message>
   <source>Drags the arrows in steps</source>
   <translation>矢印を刻みに合わせてドラッグします</translation>
  </message>
  <message>
   <source>Steps of a translation</source>
   <translation>移動の刻み</translation>
  </message>
  <message>
   <source>Steps of a rotation</source>
   <translation>回転の刻み</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>表示</translation>
  </message>
  <message>
   <source>Original</source>
   <translation>元の形</translation>
  </message>
  <message>
   <source>Shows the shape at rest as a ghost</source>
   <translation>初期形状を半透明で表示します</translation>
  </message>
  <message>
   <source>Form features</source>
   <translation>形状特徴</translation>
  </message>
  <message>
   <source>Shows how far every form feature moves and turns</source>
   <translation>各形状特徴の移動量と回転量を表示します</translation>
  </message>
  <message>
   <source>Control meshes</source>
   <translation>制御メッシュ</translation>
  </message>
  <message>
   <source>Shows the control meshes of contacts as wires that move along</source>
   <translation>接触の制御メッシュを、ともに動く線で表示します</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>色</translation>
  </message>
  <message>
   <source>What the colours of the parts say</source>
   <translation>部品の色が表すもの</translation>
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
   <source>Elements by quality: bars as it is, grey lines as it was at rest, red where the limit is</source>
   <translation>品質ごとの要素数：棒は現在、灰色の線は静止時、赤は限界</translation>
  </message>
  <message>
   <source>Reset</source>
   <translation>元に戻す</translation>
  </message>
  <message>
   <source>Puts this handle back to rest</source>
   <translation>このハンドルを初期位置に戻します</translation>
  </message>
  <message>
   <source>Update results</source>
   <translation>結果の更新</translation>
  </message>
  <message>
   <source>When the result objects follow; the 3D view always follows at once</source>
   <translation>結果オブジェクトがいつ追従するか。3Dビューは常にすぐ追従します</translation>
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
  <name>SheetMorph_panels</name>
  <message>
   <source>The shape of {0} failed</source>
   <translation>{0} の形状を計算できませんでした</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>停止</translation>
  </message>
  <message>
   <source>Stops computing; a recompute of the document computes the shape.</source>
   <translation>計算を停止します。ドキュメントを再計算すると形状が計算されます。</translation>
  </message>
  <message>
   <source>Computing the final shape of {0}</source>
   <translation>{0} の最終形状を計算中</translation>
  </message>
  <message>
   <source>This shape failed for an unknown reason ({0}). Please report it.</source>
   <translation>原因不明のエラーでこの形状を計算できませんでした ({0})。ご報告ください。</translation>
  </message>
  <message>
   <source>There is not enough memory for this shape. Close other documents, or mesh it coarser.</source>
   <translation>この形状を計算するにはメモリが足りません。ほかのドキュメントを閉じるか、メッシュを粗くしてください。</translation>
  </message>
  <message>
   <source>There is nothing to show: no contact is in use.</source>
   <translation>表示するものがありません。使用中の接触がありません。</translation>
  </message>
  <message>
   <source>{0}, near {1}</source>
   <translation>{0}、{1} の近く</translation>
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
   <source>Take out of “{0}”</source>
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
   <translation>パーツ: {0}、フォームフィーチャ: {1}、接触: {2}、結合: {3}</translation>
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
   <source>The parts are farther apart than that: give a larger gap distance, or pick by hand.</source>
   <translation>部品はそれより離れています。隙間の距離を大きくするか、手で選んでください。</translation>
  </message>
  <message>
   <source>Choose two parts: click on one, then on the other.</source>
   <translation>二つの部品を順にクリックして選んでください。</translation>
  </message>
  <message>
   <source>A side is empty: pick at least one vertex on each part.</source>
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
   <source>The other part bends along smoothly. Right for most flanges and weld seams.</source>
   <translation>相手の部品が滑らかに一緒に曲がります。ほとんどのフランジや溶接線に適します。</translation>
  </message>
  <message>
   <source>Every vertex keeps its place over the facing triangle. For glued faces and mesh ties.</source>
   <translation>各頂点が向かいの三角形上の位置を保ちます。接着面やメッシュの結合に。</translation>
  </message>
  <message>
   <source>Both sides move as one stiff body. For bolts, rivets and spot welds.</source>
   <translation>両側が一つの剛体として動きます。ボルト、リベット、スポット溶接に。</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>自動</translation>
  </message>
  <message>
   <source>1 Whole part</source>
   <translation>1 部品全体</translation>
  </message>
  <message>
   <source>2 Contacts lead</source>
   <translation>2 接触が導く</translation>
  </message>
  <message>
   <source>3 Contacts and edges lead</source>
   <translation>3 接触と縁が導く</translation>
  </message>
  <message>
   <source>SheetMorph chooses by contacts and form features.</source>
   <translation>接触と形状特徴から自動で選びます。</translation>
  </message>
  <message>
   <source>The control mesh moves every vertex; form features would lose their shape.</source>
   <translation>制御メッシュが全頂点を動かします。形状特徴は形を失います。</translation>
  </message>
  <message>
   <source>Contacts and followers go with the control mesh, the rest bends like sheet; form features keep their shape.</source>
   <translation>接触と追従領域は制御メッシュとともに動き、残りは板のように曲がります。形状特徴は形を保ちます。</translation>
  </message>
  <message>
   <source>As 2, and free edges inside the control mesh go with it too.</source>
   <translation>2に加え、制御メッシュ内の自由な縁もともに動きます。</translation>
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
   <source>No hole, slot or cylinder: it has no size to set.</source>
   <translation>穴でも長穴でも円筒でもなく、設定できる寸法がありません。</translation>
  </message>
  <message>
   <source>Tick the form features it is related to, or choose no relation.</source>
   <translation>関係する形状要素をチェックするか、関係なしを選んでください。</translation>
  </message>
  <message>
   <source>A pair has two form features; tick one.</source>
   <translation>対は二つの形状要素です。一つをチェックしてください。</translation>
  </message>
  <message>
   <source>all kinds</source>
   <translation>すべての種類</translation>
  </message>
  <message>
   <source>{0} of {1} chosen</source>
   <translation>{1} 件中 {0} 件を選択</translation>
  </message>
  <message>
   <source>{0} of {1} chosen, {2} in the document already</source>
   <translation>{1} 件中 {0} 件を選択、{2} 件は文書に既存</translation>
  </message>
  <message>
   <source>{0} not certain (?): point at them to read why</source>
   <translation>{0} 件は不確か（?）: 指すと理由が読めます</translation>
  </message>
  <message>
   <source>Nothing is checked; check proposals, or cancel.</source>
   <translation>何もチェックされていません。提案をチェックするか、キャンセルしてください。</translation>
  </message>
  <message>
   <source>of the selected parts only</source>
   <translation>選択した部品のみ</translation>
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
   <source>Will not follow, no contact leads there: {0}</source>
   <translation>接触でつながらないため追従しません: {0}</translation>
  </message>
  <message>
   <source>Linear preview: steel follows when you rest. {0}</source>
   <translation>線形プレビュー: 手を止めると鋼の解が続きます。{0}</translation>
  </message>
  <message>
   <source>Linear preview, the exact shape follows ({0})</source>
   <translation>線形プレビュー、正確な形状が続きます ({0})</translation>
  </message>
  <message>
   <source>Nothing has moved yet.</source>
   <translation>まだ何も動いていません。</translation>
  </message>
  <message>
   <source>{0} contacts open too far, see Propagation; the first:</source>
   <translation>{0} 個の接触が開きすぎています。「伝播」を参照。最初の接触:</translation>
  </message>
  <message>
   <source>Preview: refined on release. {0}</source>
   <translation>プレビュー: 離すと精密な形状になります。{0}</translation>
  </message>
  <message>
   <source>Steel, final. {0}</source>
   <translation>鋼、最終結果。{0}</translation>
  </message>
  <message>
   <source>At rest</source>
   <translation>静止</translation>
  </message>
  <message>
   <source>As it was before; move the slider to blend again.</source>
   <translation>以前の状態です。スライダーを動かすと再びブレンドします。</translation>
  </message>
  <message>
   <source>Largest and mean distance, mm</source>
   <translation>最大と平均の距離、mm</translation>
  </message>
  <message>
   <source>Choose a pose.</source>
   <translation>ポーズを選んでください。</translation>
  </message>
  <message>
   <source>and {0} more parts</source>
   <translation>ほか {0} 部品</translation>
  </message>
  <message>
   <source>Make a part of each of its {} pieces</source>
   <translation>つながっていない{}個の部分をそれぞれ部品にする</translation>
  </message>
  <message>
   <source>Weld within how much? Type a length, for example 0.01 mm.</source>
   <translation>どの距離以内を結合しますか。長さを入力してください。例: 0.01 mm</translation>
  </message>
  <message>
   <source>Nothing is chosen; choose a cure, or cancel.</source>
   <translation>何も選ばれていません。対処を選ぶか、キャンセルしてください。</translation>
  </message>
  <message>
   <source>Choose a cure first.</source>
   <translation>先に対処を選んでください。</translation>
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
   <source>How much the gap between both sides has changed, at most</source>
   <translation>両側のすき間が最大でどれだけ変わったか</translation>
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
   <translation>使われていません</translation>
  </message>
  <message>
   <source>level {0}</source>
   <translation>段 {0}</translation>
  </message>
  <message>
   <source>Change a value to see how far it may go.</source>
   <translation>値を変えると、どこまで行けるかを示します。</translation>
  </message>
  <message>
   <source>a triangle turns over</source>
   <translation>三角形が裏返ります</translation>
  </message>
  <message>
   <source>The angle</source>
   <translation>角度</translation>
  </message>
  <message>
   <source>{0}: {1} to {2}{3}</source>
   <translation>{0}：{1} ～ {2}{3}</translation>
  </message>
  <message>
   <source>{0}; beyond: {1}</source>
   <translation>{0}；その先：{1}</translation>
  </message>
  <message>
   <source>{0}, as far as was looked</source>
   <translation>{0}（調べた範囲）</translation>
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
   <source>; {0} of {1} elements beyond {2:g}</source>
   <translation>；{1} 要素中 {0} が {2:g} を超過</translation>
  </message>
  <message>
   <source>No variants yet.</source>
   <translation>まだ変種がありません。</translation>
  </message>
  <message>
   <source>Folder for the Variants</source>
   <translation>変種のフォルダ</translation>
  </message>
  <message>
   <source>{0}. A double click takes the morph there.</source>
   <translation>{0}。ダブルクリックでモーフがその形になります。</translation>
  </message>
  <message>
   <source>Wait for the variants, or stop them.</source>
   <translation>変種を待つか、中止してください。</translation>
  </message>
  <message>
   <source>Stopped: the document has changed.</source>
   <translation>中止しました：ドキュメントが変わりました。</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>名前</translation>
  </message>
  <message>
   <source>Changes</source>
   <translation>変えるもの</translation>
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
   <source>“{0}” of “{1}” is no number.</source>
   <translation>「{1}」の「{0}」は数ではありません。</translation>
  </message>
  <message>
   <source>'{0}' is no thin solid: {1}.</source>
   <translation>「{0}」は薄肉ソリッドではありません: {1}。</translation>
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
   <translation>左ボタンでなぞります。ホイールで大きさ、Ctrl+ホイールで拡大縮小。Ctrl+なぞるで除去。</translation>
  </message>
  <message>
   <source>Drag from corner to corner. Shift adds, Ctrl removes.</source>
   <translation>角から角へドラッグします。Shiftで追加、Ctrlで除去。</translation>
  </message>
  <message>
   <source>Draw around it with the left button held. Shift adds, Ctrl removes.</source>
   <translation>左ボタンを押したまま囲みます。Shiftで追加、Ctrlで除去。</translation>
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
   <source>Picks the rim of a hole by one click near it</source>
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
   <source>Picks what you paint over; the wheel changes the size of the brush</source>
   <translation>なぞった所を選びます。ホイールでブラシの大きさを変えます</translation>
  </message>
  <message>
   <source>Rectangle</source>
   <translation>長方形</translation>
  </message>
  <message>
   <source>Picks what lies in a rectangle that you draw</source>
   <translation>描いた長方形の中を選びます</translation>
  </message>
  <message>
   <source>Lasso</source>
   <translation>投げ縄</translation>
  </message>
  <message>
   <source>Picks what lies in a closed figure that you draw</source>
   <translation>描いた閉じた図形の中を選びます</translation>
  </message>
  <message>
   <source>New</source>
   <translation>新規</translation>
  </message>
  <message>
   <source>A pick starts anew; the brush goes on</source>
   <translation>選択を新しく始めます。ブラシは続けて選びます</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>追加</translation>
  </message>
  <message>
   <source>A pick adds, as with Shift</source>
   <translation>Shiftと同じく、選択に加えます</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>除去</translation>
  </message>
  <message>
   <source>A pick removes, as with Ctrl</source>
   <translation>Ctrlと同じく、選択から除きます</translation>
  </message>
  <message>
   <source>Crease angle</source>
   <translation>折れ角</translation>
  </message>
  <message>
   <source>A face and a rim end where the surface turns by more than this</source>
   <translation>面と縁は、表面がこれより大きく折れる所で終わります</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>穴の周りの輪</translation>
  </message>
  <message>
   <source>Takes so many rings of vertices around the rim as well</source>
   <translation>縁の周りの頂点の輪もこの数だけ選びます</translation>
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
   <source>Picks through parts and facets that hide others, as if all were made of glass</source>
   <translation>すべてが透明であるかのように、隠している部品や三角形を通して選びます</translation>
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
   <source>Picks what is not picked, and nothing else</source>
   <translation>選ばれていない所だけを選びます</translation>
  </message>
  <message>
   <source>Undo Pick</source>
   <translation>選択を戻す</translation>
  </message>
  <message>
   <source>Takes back the last pick</source>
   <translation>最後の選択を取り消します</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>クリア</translation>
  </message>
  <message>
   <source>Picks nothing</source>
   <translation>何も選ばない状態にします</translation>
  </message>
  <message>
   <source>All Holes</source>
   <translation>すべての穴</translation>
  </message>
  <message>
   <source>Picks the rims of all holes of the part</source>
   <translation>部品のすべての穴の縁を選びます</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_pose</name>
  <message>
   <source>Blend Poses</source>
   <translation>姿勢を混ぜる</translation>
  </message>
  <message>
   <source>From</source>
   <translation>最小</translation>
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
   <source>How far the morph is on the way from one pose to the other</source>
   <translation>一方の姿勢から他方への進み具合</translation>
  </message>
  <message>
   <source>The same as a number; beyond 0 and 100 % the motion goes on</source>
   <translation>同じ値を数で。0 % と 100 % の外でも動きは続きます</translation>
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
   <source>When the result objects follow a motion: the 3D view always does at once. Automatically: at once if that takes less than 50 ms, else on a pause</source>
   <translation>結果オブジェクトが動きにいつ追従するか。3Dビューは常にすぐ追従します。自動: 50 ms未満ならすぐ、それ以外は止まったとき</translation>
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
   <source>Shows arrows to drag when the Move Handle panel opens</source>
   <translation>「ハンドルを動かす」を開いたとき、ドラッグ用の矢印を表示します</translation>
  </message>
  <message>
   <source>Arrows and arcs in the view</source>
   <translation>ビューに矢印と円弧を表示</translation>
  </message>
  <message>
   <source>Motions by the mouse go in steps</source>
   <translation>マウスの動きを刻みに合わせます</translation>
  </message>
  <message>
   <source>Snap to steps</source>
   <translation>刻みに合わせる</translation>
  </message>
  <message>
   <source>Step of a length</source>
   <translation>長さの刻み</translation>
  </message>
  <message>
   <source>Motions by the mouse are multiples of this length when they snap</source>
   <translation>刻みに合わせるとき、マウスの動きはこの長さの倍数になります</translation>
  </message>
  <message>
   <source>Step of an angle</source>
   <translation>角度の刻み</translation>
  </message>
  <message>
   <source>Turns by the mouse are multiples of this angle when they snap</source>
   <translation>刻みに合わせるとき、マウスの回転はこの角度の倍数になります</translation>
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
   <source>A face ends at edges where the sheet turns by more than this angle</source>
   <translation>板がこの角度より大きく折れる稜で面は終わります</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>穴の周りの輪</translation>
  </message>
  <message>
   <source>How many rings of vertices around the rim of a hole belong to it</source>
   <translation>穴の縁の周りの頂点の輪をいくつ穴に含めるか</translation>
  </message>
  <message>
   <source>Size of brush</source>
   <translation>ブラシの大きさ</translation>
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
   <source>First side of contacts is drawn in this colour</source>
   <translation>接触の一つ目の側をこの色で描きます</translation>
  </message>
  <message>
   <source>Second side of contacts</source>
   <translation>接触の二つ目の側</translation>
  </message>
  <message>
   <source>Second side of contacts is drawn in this colour</source>
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
   <source>What is found</source>
   <translation>見つかったこと</translation>
  </message>
  <message>
   <source>Cures</source>
   <translation>対処</translation>
  </message>
  <message>
   <source>Coordinates are in</source>
   <translation>座標の単位</translation>
  </message>
  <message>
   <source>Scales the mesh from another unit to mm</source>
   <translation>メッシュを他の単位から mm に変換します</translation>
  </message>
  <message>
   <source>The unit of the file</source>
   <translation>ファイルの単位</translation>
  </message>
  <message>
   <source>Weld vertices within</source>
   <translation>頂点を結合する距離</translation>
  </message>
  <message>
   <source>Closes cuts and T-junctions, removes doubled facets, turns facets that face the wrong way</source>
   <translation>切れ目と T 字接合を閉じ、重複した面を除き、裏返った面を直します</translation>
  </message>
  <message>
   <source>Vertices nearer than this become one</source>
   <translation>これより近い頂点は一つになります</translation>
  </message>
  <message>
   <source>Mesh anew with edges of</source>
   <translation>再メッシュの辺の長さ</translation>
  </message>
  <message>
   <source>Well-shaped triangles on the facets as they are: flats stay exact, shorter edges at holes and bends</source>
   <translation>元の面の上に形の良い三角形を作ります。平面は正確なまま、穴と曲げでは辺が短くなります</translation>
  </message>
  <message>
   <source>Length of the edges on flats</source>
   <translation>平面での辺の長さ</translation>
  </message>
  <message>
   <source>Round rims</source>
   <translation>丸い縁</translation>
  </message>
  <message>
   <source>What becomes of the rims of round holes</source>
   <translation>丸穴の縁の扱い</translation>
  </message>
  <message>
   <source>keep their polygon</source>
   <translation>多角形のまま</translation>
  </message>
  <message>
   <source>go to their circle</source>
   <translation>円に合わせる</translation>
  </message>
  <message>
   <source>Bend as one sheet (thin solid)</source>
   <translation>一枚の板として曲げる（薄肉ソリッド）</translation>
  </message>
  <message>
   <source>Both skins and the walls follow one sheet and keep their distance, if it is recognised as a thin solid</source>
   <translation>薄肉ソリッドと認識されれば、両面と壁は一枚の板に従い、間隔を保ちます</translation>
  </message>
  <message>
   <source>Make a part of each of its pieces</source>
   <translation>つながっていない部分をそれぞれ部品にする</translation>
  </message>
  <message>
   <source>What nothing connects becomes a part of its own, so that contacts can join it to the others; only while nothing is marked on it</source>
   <translation>つながっていない部分はそれぞれ独立した部品になり、接触で他と結合できます。何も指定されていない間だけ可能です</translation>
  </message>
  <message>
   <source>Shows the new mesh in place of the part; nothing changes</source>
   <translation>部品の代わりに新しいメッシュを表示します。何も変わりません</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_propagation</name>
  <message>
   <source>Propagation</source>
   <translation>伝播</translation>
  </message>
  <message>
   <source>Local: from part to part along contacts. Single: one control mesh around everything</source>
   <translation>局所: 接触に沿って部品から部品へ。単一: 全体を囲む一つの制御メッシュ</translation>
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
   <source>Levels</source>
   <translation>細分の段数</translation>
  </message>
  <message>
   <source>How often control meshes are subdivided: more follows finer bends and takes longer (3 is right for most sheets)</source>
   <translation>制御メッシュの細分の回数。多いほど細かい曲がりに追従し、時間がかかります(ほとんどの板では3が適切)</translation>
  </message>
  <message>
   <source>Smoothness</source>
   <translation>滑らかさ</translation>
  </message>
  <message>
   <source>How smooth control meshes stay: small follows the source closely, large evens out its details</source>
   <translation>制御メッシュの滑らかさ。小さいと元に忠実に従い、大きいと細部をならします</translation>
  </message>
  <message>
   <source>Loose pieces</source>
   <translation>離れた部分</translation>
  </message>
  <message>
   <source>What becomes of pieces of a part that nothing holds, while others of it move</source>
   <translation>他の部分が動くとき、何にも保持されない部分をどうするか</translation>
  </message>
  <message>
   <source>stay at rest, with a warning</source>
   <translation>静止したまま (警告)</translation>
  </message>
  <message>
   <source>go along with what is nearest</source>
   <translation>最も近い部分に従う</translation>
  </message>
  <message>
   <source>are an error</source>
   <translation>エラーにする</translation>
  </message>
  <message>
   <source>A click shows parts and contacts in the 3D view</source>
   <translation>クリックすると部品と接触を3Dビューに示します</translation>
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
   <source>Shows the control mesh of the chosen contact, else all of them, as wires</source>
   <translation>選択した接触の、なければすべての制御メッシュを線で示します</translation>
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
   <source>How the part follows; the primary is deformed by its handles</source>
   <translation>部品がどう追従するか。主部品は自分のハンドルで変形します</translation>
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
   <translation>一方の側が他方にどう追従するか</translation>
  </message>
  <message>
   <source>In use</source>
   <translation>使用する</translation>
  </message>
  <message>
   <source>Off: the contact is kept but moves nothing, as if the weld were open</source>
   <translation>オフ: 接触は残りますが、溶接が外れたように何も動かしません</translation>
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
   <source>What {0} has already is left out: a vertex has one of them.</source>
   <translation>{0} にある頂点は除かれます。1つの頂点は1つにだけ属します。</translation>
  </message>
  <message>
   <source>Picked: {0}, 1 piece</source>
   <translation>選択: {0}、かたまり 1 個</translation>
  </message>
  <message>
   <source>Nothing is picked: click on the part first.</source>
   <translation>何も選択されていません。先に部品をクリックしてください。</translation>
  </message>
  <message>
   <source>Picked: {0}, {1} pieces</source>
   <translation>選択: {0}、かたまり {1} 個</translation>
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
   <source>or type a selector: {"face_at": [x, y, z]}</source>
   <translation>またはセレクターを入力: {"face_at": [x, y, z]}</translation>
  </message>
  <message>
   <source>What is picked, in the words of a recipe and the coordinates of the part's file; type another selector and press Enter</source>
   <translation>選択されているものを、レシピの言葉と部品ファイルの座標で示します。別のセレクターを入力して Enter を押してください</translation>
  </message>
  <message>
   <source>Each hole is a feature of its own</source>
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
   <source>What changes between which numbers; a double click edits a name or a number</source>
   <translation>何がどの数の間で変わるか。ダブルクリックで名前や数を編集します</translation>
  </message>
  <message>
   <source>Motions of handles, sizes of form features, and cells of the spreadsheets that drive them</source>
   <translation>ハンドルの動き、形状要素の寸法、それらを動かすスプレッドシートのセル</translation>
  </message>
  <message>
   <source>Lets the study change this number</source>
   <translation>この数をスタディで変えます</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>追加</translation>
  </message>
  <message>
   <source>Takes the selected parameters out</source>
   <translation>選んだパラメータを外します</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>削除</translation>
  </message>
  <message>
   <source>Variants</source>
   <translation>変種</translation>
  </message>
  <message>
   <source>Sampling</source>
   <translation>標本化</translation>
  </message>
  <message>
   <source>How values are chosen: three ways that fill the ranges evenly, or a grid of all combinations</source>
   <translation>値の選び方：範囲を一様に満たす三つの方法、または全組み合わせの格子</translation>
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
   <source>How many variants; of a full grid at most so many</source>
   <translation>変種の数。全格子では最大数</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>シード</translation>
  </message>
  <message>
   <source>Another number gives other values</source>
   <translation>別の数にすると別の値になります</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>基準</translation>
  </message>
  <message>
   <source>What every variant must keep, commas between: stretch, angle, gap change, edge error, displacement, touching and more, or a parameter. That no triangle turns over is always asked for</source>
   <translation>各変種が守ること（コンマ区切り）：stretch, angle, gap change, edge error, displacement, touching など、またはパラメータ。三角形が裏返らないことは常に求めます</translation>
  </message>
  <message>
   <source>such as stretch &lt;= 0.2, angle &gt;= 12</source>
   <translation>例：stretch &lt;= 0.2, angle &gt;= 12</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>フォルダ</translation>
  </message>
  <message>
   <source>Where recipe, study and the files of every variant are kept; a run that was stopped goes on there. Empty: only the table is kept</source>
   <translation>レシピ、スタディ、各変種のファイルを置く場所。中止した計算はそこから続きます。空なら表だけを残します</translation>
  </message>
  <message>
   <source>keep only the table</source>
   <translation>表だけを残す</translation>
  </message>
  <message>
   <source>Chooses a folder</source>
   <translation>フォルダを選びます</translation>
  </message>
  <message>
   <source>Computes the variants in processes of their own; FreeCAD stays free</source>
   <translation>変種を別プロセスで計算します。FreeCAD はそのまま使えます</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>実行</translation>
  </message>
  <message>
   <source>Stops; what is done becomes the table</source>
   <translation>止めます。終わった分が表になります</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>中止</translation>
  </message>
  <message>
   <source>Variants that are done</source>
   <translation>終わった変種</translation>
  </message>
  <message>
   <source>One row for each variant; point at its state to read why it did not pass. A double click takes the morph there</source>
   <translation>変種ごとに一行。状態を指すと不合格の理由が読めます。ダブルクリックでモーフがその形になります</translation>
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
   <source>Both skins and the walls follow one sheet and keep their distance; off: the closed surface bends as it is</source>
   <translation>両面と側面が一枚の板に従い、間隔を保ちます。オフ: 閉じた表面がそのまま曲がります</translation>
  </message>
  <message>
   <source>Mark Holes as Form Features</source>
   <translation>穴を形状特徴に指定</translation>
  </message>
  <message>
   <source>Every hole through both skins becomes a form feature: it keeps its shape, wall included</source>
   <translation>両面を貫く穴はすべて、側面も含めて形を保つ形状特徴になります</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>SheetMorph Morph</source>
   <translation>SheetMorph モーフ</translation>
  </message>
  <message>
   <source>SheetMorph Regions</source>
   <translation>SheetMorph 領域</translation>
  </message>
  <message>
   <source>SheetMorph Contacts</source>
   <translation>SheetMorph 接触</translation>
  </message>
  <message>
   <source>SheetMorph Features</source>
   <translation>SheetMorph 形状特徴</translation>
  </message>
  <message>
   <source>SheetMorph Motion</source>
   <translation>SheetMorph 動き</translation>
  </message>
  <message>
   <source>SheetMorph Exchange</source>
   <translation>SheetMorph 入出力</translation>
  </message>
 </context>
</TS>
