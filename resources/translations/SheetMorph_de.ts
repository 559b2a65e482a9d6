<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>SheetMorph_AddPart</name>
  <message>
   <source>The selected objects have no faces. Select meshes or shapes.</source>
   <translation>Die ausgewählten Objekte haben keine Flächen. Wählen Sie Netze oder Formen aus.</translation>
  </message>
  <message>
   <source>&amp;Add Part</source>
   <translation>&amp;Teil hinzufügen</translation>
  </message>
  <message>
   <source>Adds the selected meshes and shapes to the morph as parts</source>
   <translation>Fügt dem Morph die ausgewählten Netze und Formen als Teile hinzu</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ApplyPose</name>
  <message>
   <source>&amp;Apply Pose</source>
   <translation>Stellung &amp;anwenden</translation>
  </message>
  <message>
   <source>Moves all handles to their positions in the selected pose</source>
   <translation>Bewegt alle Griffe in die gewählte Stellung</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_BlendPoses</name>
  <message>
   <source>&amp;Blend Poses…</source>
   <translation>Stellungen ü&amp;berblenden…</translation>
  </message>
  <message>
   <source>Blends from one pose to another with a slider, and compares the two</source>
   <translation>Überblendet mit einem Schieberegler von einer Stellung zur anderen und vergleicht beide</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Certify</name>
  <message>
   <source>Certificate</source>
   <translation>Zertifikat</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>Kriterien</translation>
  </message>
  <message>
   <source>&amp;Certificate…</source>
   <translation>&amp;Zertifikat…</translation>
  </message>
  <message>
   <source>Writes all deformed parts to a folder, reads them back, and checks them against criteria</source>
   <translation>Schreibt alle verformten Teile in einen Ordner, liest sie zurück und prüft sie nach Kriterien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CheckInstallation</name>
  <message>
   <source>&amp;Check Installation</source>
   <translation>&amp;Installation prüfen</translation>
  </message>
  <message>
   <source>Checks the deformation kernel and shows a report that you can copy</source>
   <translation>Prüft den Verformungskern und zeigt einen Bericht, den Sie kopieren können</translation>
  </message>
  <message>
   <source>Check Installation</source>
   <translation>Installation prüfen</translation>
  </message>
  <message>
   <source>Copy</source>
   <translation>Kopieren</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyAsMeshes</name>
  <message>
   <source>Copy as &amp;Meshes</source>
   <translation>Als &amp;Netze kopieren</translation>
  </message>
  <message>
   <source>Copies the parts as plain meshes, in their current shape or in the selected pose</source>
   <translation>Kopiert die Teile als einfache Netze, in ihrer aktuellen Form oder in der ausgewählten Stellung</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyInPose</name>
  <message>
   <source>&amp;Copy in Pose</source>
   <translation>In Stellung &amp;kopieren</translation>
  </message>
  <message>
   <source>Copies the whole morph and applies the selected pose to the copy</source>
   <translation>Kopiert den ganzen Morph und wendet die ausgewählte Stellung auf die Kopie an</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CreateMorph</name>
  <message>
   <source>&amp;Create Morph</source>
   <translation>Morph &amp;erzeugen</translation>
  </message>
  <message>
   <source>Creates a morph from the selected meshes and shapes, which stay unchanged</source>
   <translation>Erzeugt einen Morph aus den ausgewählten Netzen und Formen; diese bleiben unverändert</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_DeformedShape</name>
  <message>
   <source>&amp;Deformed Shape</source>
   <translation>&amp;Verformte Form</translation>
  </message>
  <message>
   <source>Creates a deformed CAD shape of the selected part, with the faces of its original shape</source>
   <translation>Erzeugt eine verformte CAD-Form des ausgewählten Teils mit den Flächen seiner ursprünglichen Form</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_EditContact</name>
  <message>
   <source>&amp;Edit Contact…</source>
   <translation>Kontakt &amp;bearbeiten…</translation>
  </message>
  <message>
   <source>Changes the type, the regions and the settings of the selected contact</source>
   <translation>Ändert Art, Regionen und Einstellungen des gewählten Kontakts</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_EditRegion</name>
  <message>
   <source>&amp;Edit Region…</source>
   <translation>Region &amp;bearbeiten…</translation>
  </message>
  <message>
   <source>Changes the vertices of the selected region by picking in the 3D view</source>
   <translation>Ändert die Knoten der gewählten Region durch Anklicken in der 3D-Ansicht</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportParts</name>
  <message>
   <source>These files already exist, and SheetMorph did not write their current content:</source>
   <translation>Diese Dateien existieren bereits, und ihr aktueller Inhalt stammt nicht von SheetMorph:</translation>
  </message>
  <message>
   <source>Overwrite them?</source>
   <translation>Überschreiben?</translation>
  </message>
  <message>
   <source>Export Parts</source>
   <translation>Teile exportieren</translation>
  </message>
  <message>
   <source>&amp;Export Parts…</source>
   <translation>&amp;Teile exportieren…</translation>
  </message>
  <message>
   <source>Writes all deformed parts to a folder, each in its original file format</source>
   <translation>Schreibt alle verformten Teile in einen Ordner, jedes in seinem ursprünglichen Dateiformat</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportRecipe</name>
  <message>
   <source>Export Recipe</source>
   <translation>Rezept exportieren</translation>
  </message>
  <message>
   <source>E&amp;xport Recipe…</source>
   <translation>&amp;Rezept exportieren…</translation>
  </message>
  <message>
   <source>Writes the morph as a recipe that also runs without FreeCAD</source>
   <translation>Schreibt den Morph als Rezept, das auch ohne FreeCAD läuft</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FeatureSettings</name>
  <message>
   <source>Form Feature &amp;Settings…</source>
   <translation>Formelement-&amp;Einstellungen…</translation>
  </message>
  <message>
   <source>Sets the rotation, the motion and the size of the selected form feature</source>
   <translation>Legt Drehung, Bewegung und Größe des ausgewählten Formelements fest</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindContacts</name>
  <message>
   <source>&amp;Find Contacts…</source>
   <translation>Kontakte &amp;finden…</translation>
  </message>
  <message>
   <source>Finds where parts touch or are bolted; the ones you accept become contacts</source>
   <translation>Findet Stellen, an denen sich Teile berühren oder verschraubt sind; was Sie annehmen, wird ein Kontakt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindFeatures</name>
  <message>
   <source>F&amp;ind Features…</source>
   <translation>Formelemente fi&amp;nden…</translation>
  </message>
  <message>
   <source>Finds holes and other features on all parts; the ones you accept become form features</source>
   <translation>Findet Löcher und andere Formelemente auf allen Teilen; was Sie annehmen, wird ein Formelement</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Flatten</name>
  <message>
   <source>&amp;Flatten</source>
   <translation>&amp;Abwickeln</translation>
  </message>
  <message>
   <source>Flattens the selected part, in its current shape and at rest: sketches of blank and bend lines</source>
   <translation>Wickelt das ausgewählte Teil ab, in aktueller Form und in Ruhe: Skizzen von Zuschnitt und Biegelinien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FollowShape</name>
  <message>
   <source>“{0}” was {1}. Which one is it now?</source>
   <translation>„{0}“ war {1}. Welches ist es jetzt?</translation>
  </message>
  <message>
   <source>&amp;Follow Shape</source>
   <translation>&amp;Form folgen</translation>
  </message>
  <message>
   <source>Meshes the changed body or shape of the selected part again and finds its regions on the new mesh; regions that changed are listed and selected</source>
   <translation>Vernetzt den geänderten Körper oder die geänderte Form des ausgewählten Teils neu und findet die Regionen auf dem neuen Netz; geänderte Regionen werden gemeldet und ausgewählt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_GroupFeatures</name>
  <message>
   <source>&amp;Group Form Features</source>
   <translation>Formelemente &amp;gruppieren</translation>
  </message>
  <message>
   <source>Moves the selected form features of a part as one rigid body</source>
   <translation>Bewegt die ausgewählten Formelemente eines Teils als einen starren Körper</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Guide</name>
  <message>
   <source>&amp;Guide</source>
   <translation>&amp;Assistent</translation>
  </message>
  <message>
   <source>Guides you through a morph step by step: shows what is missing and opens the right panel</source>
   <translation>Führt Sie Schritt für Schritt durch einen Morph: zeigt, was fehlt, und öffnet die passende Maske</translation>
  </message>
  <message>
   <source>Import a mesh or CAD file, or select meshes in the tree and create a morph.</source>
   <translation>Importieren Sie ein Netz oder eine CAD-Datei, oder wählen Sie Netze im Baum aus und erzeugen Sie einen Morph.</translation>
  </message>
  <message>
   <source>This document has several morphs: select one in the tree.</source>
   <translation>Dieses Dokument hat mehrere Morphs: Wählen Sie einen im Baum aus.</translation>
  </message>
  <message>
   <source>The morph has no part yet: import a file or add a mesh.</source>
   <translation>Der Morph hat noch kein Teil: Importieren Sie eine Datei oder fügen Sie ein Netz hinzu.</translation>
  </message>
  <message>
   <source>Parts: {count}; “{primary}” is deformed first.</source>
   <translation>Teile: {count}; „{primary}“ wird zuerst verformt.</translation>
  </message>
  <message>
   <source>“{source}” was edited: use Follow Shape to update “{part}”.</source>
   <translation>„{source}“ wurde bearbeitet: Aktualisieren Sie „{part}“ mit „Form folgen“.</translation>
  </message>
  <message>
   <source>Nothing is fixed yet: mark a region that stays in place.</source>
   <translation>Noch ist nichts fest: Markieren Sie eine Region, die an ihrem Ort bleibt.</translation>
  </message>
  <message>
   <source>Fixed regions: {count}.</source>
   <translation>Feste Regionen: {count}.</translation>
  </message>
  <message>
   <source>No hole keeps its shape yet: find all holes, mark the important ones, or skip this step.</source>
   <translation>Noch behält kein Loch seine Form: Finden Sie alle, markieren Sie die wichtigen, oder überspringen Sie diesen Schritt.</translation>
  </message>
  <message>
   <source>Form features that keep their exact shape: {count}.</source>
   <translation>Formelemente, die ihre Form exakt behalten: {count}.</translation>
  </message>
  <message>
   <source>There is only one part: no contact is needed.</source>
   <translation>Es gibt nur ein Teil: Kontakte sind nicht nötig.</translation>
  </message>
  <message>
   <source>A single control mesh around everything moves all parts.</source>
   <translation>Ein einziges Steuernetz um alles bewegt alle Teile.</translation>
  </message>
  <message>
   <source>These parts are not connected to “{primary}” and will not follow: {parts}.</source>
   <translation>Diese Teile sind nicht mit „{primary}“ verbunden und folgen nicht: {parts}.</translation>
  </message>
  <message>
   <source>Contacts: {count}; they connect all parts.</source>
   <translation>Kontakte: {count}; sie verbinden alle Teile.</translation>
  </message>
  <message>
   <source>There is no handle yet: mark a region that you want to move.</source>
   <translation>Es gibt noch keinen Griff: Markieren Sie eine Region, die Sie bewegen möchten.</translation>
  </message>
  <message>
   <source>Handles: {count}.</source>
   <translation>Griffe: {count}.</translation>
  </message>
  <message>
   <source>Available after you mark a fixed region and a handle.</source>
   <translation>Verfügbar, sobald Sie eine feste Region und einen Griff markiert haben.</translation>
  </message>
  <message>
   <source>Everything is ready: move the handle.</source>
   <translation>Alles ist bereit: Bewegen Sie den Griff.</translation>
  </message>
  <message>
   <source>The handle has moved. Move it further, export the parts, save a pose, or run a study.</source>
   <translation>Der Griff ist bewegt. Bewegen Sie ihn weiter, exportieren Sie die Teile, speichern Sie eine Stellung oder starten Sie eine Studie.</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportPart</name>
  <message>
   <source>Mesh CAD Shapes</source>
   <translation>CAD-Formen vernetzen</translation>
  </message>
  <message>
   <source>Maximum edge length (0 = automatic, 1/100 of the size)</source>
   <translation>Maximale Kantenlänge (0 = automatisch, 1/100 der Größe)</translation>
  </message>
  <message>
   <source>“{0}” is not a length. Enter a length such as 5 mm.</source>
   <translation>„{0}“ ist keine Länge. Geben Sie eine Länge wie 5 mm ein.</translation>
  </message>
  <message>
   <source>Import Part</source>
   <translation>Teil importieren</translation>
  </message>
  <message>
   <source>&amp;Import Part…</source>
   <translation>Teil &amp;importieren…</translation>
  </message>
  <message>
   <source>Imports a mesh, every property of a deck, or every solid of a CAD file as parts</source>
   <translation>Importiert ein Netz, jedes Property eines Decks oder jeden Körper einer CAD-Datei als Teile</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportRecipe</name>
  <message>
   <source>Import Recipe</source>
   <translation>Rezept importieren</translation>
  </message>
  <message>
   <source>&amp;Import Recipe…</source>
   <translation>Rezept &amp;importieren…</translation>
  </message>
  <message>
   <source>Creates a morph from a recipe and its mesh files</source>
   <translation>Erzeugt einen Morph aus einem Rezept und seinen Netzdateien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_KeepDistance</name>
  <message>
   <source>&amp;Keep Distance</source>
   <translation>&amp;Abstand halten</translation>
  </message>
  <message>
   <source>Keeps the distance between two selected form features, on one part or on two</source>
   <translation>Hält den Abstand zwischen zwei ausgewählten Formelementen, auf einem Teil oder auf zweien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MakeCoaxial</name>
  <message>
   <source>&amp;Make Coaxial</source>
   <translation>&amp;Koaxial machen</translation>
  </message>
  <message>
   <source>Keeps two selected form features on a common axis, on one part or on two</source>
   <translation>Hält zwei ausgewählte Formelemente auf einer gemeinsamen Achse, auf einem Teil oder auf zweien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Manual</name>
  <message>
   <source>SheetMorph &amp;Manual</source>
   <translation>SheetMorph-&amp;Handbuch</translation>
  </message>
  <message>
   <source>Opens the manual in the browser, also without a network</source>
   <translation>Öffnet das Handbuch im Browser, auch ohne Netz</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkContact</name>
  <message>
   <source>&amp;Mark Contact…</source>
   <translation>Kontakt &amp;markieren…</translation>
  </message>
  <message>
   <source>Joins two parts where they touch, so that one follows the other. Select both parts, or click on them in the 3D view</source>
   <translation>Verbindet zwei Teile an ihrer Berührstelle, sodass eines dem anderen folgt. Wählen Sie beide Teile aus, oder klicken Sie sie in der 3D-Ansicht an</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFeature</name>
  <message>
   <source>Mark F&amp;orm Features…</source>
   <translation>F&amp;ormelemente markieren…</translation>
  </message>
  <message>
   <source>Marks holes and other form features, which move but keep their shape</source>
   <translation>Markiert Löcher und andere Formelemente, die sich bewegen, aber ihre Form behalten</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFixed</name>
  <message>
   <source>Mark &amp;Fixed Region…</source>
   <translation>&amp;Feste Region markieren…</translation>
  </message>
  <message>
   <source>Marks a region that stays in place, by picking in the 3D view</source>
   <translation>Markiert durch Anklicken in der 3D-Ansicht eine Region, die an ihrem Ort bleibt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFollower</name>
  <message>
   <source>Mark Fo&amp;llower…</source>
   <translation>Fo&amp;lgeregion markieren…</translation>
  </message>
  <message>
   <source>Marks a region that follows the control meshes of the part's contacts</source>
   <translation>Markiert eine Region, die den Steuernetzen der Kontakte ihres Teils folgt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkHandle</name>
  <message>
   <source>Mark &amp;Handle…</source>
   <translation>&amp;Griff markieren…</translation>
  </message>
  <message>
   <source>Marks a region that you move and turn; the part follows</source>
   <translation>Markiert eine Region, die Sie bewegen und drehen; das Teil folgt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MoveHandle</name>
  <message>
   <source>&amp;Move Handle…</source>
   <translation>&amp;Griff bewegen…</translation>
  </message>
  <message>
   <source>Moves and turns a handle; the parts follow as you change the values</source>
   <translation>Bewegt und dreht einen Griff; die Teile folgen, während Sie die Werte ändern</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_OpenExample</name>
  <message>
   <source>Open Example</source>
   <translation>Beispiel öffnen</translation>
  </message>
  <message>
   <source>Example</source>
   <translation>Beispiel</translation>
  </message>
  <message>
   <source>&amp;Open Example…</source>
   <translation>Beispiel ö&amp;ffnen…</translation>
  </message>
  <message>
   <source>Opens an example assembly that is ready to move</source>
   <translation>Öffnet eine Beispielbaugruppe, die Sie sofort bewegen können</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_PrepareMesh</name>
  <message>
   <source>&amp;Prepare Mesh…</source>
   <translation>&amp;Netz vorbereiten…</translation>
  </message>
  <message>
   <source>Checks the mesh of the selected part, repairs it and remeshes it</source>
   <translation>Prüft das Netz des ausgewählten Teils, repariert es und vernetzt es neu</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Propagation</name>
  <message>
   <source>&amp;Propagation…</source>
   <translation>&amp;Ausbreitung…</translation>
  </message>
  <message>
   <source>Shows how the motion spreads from the primary part through the contacts</source>
   <translation>Zeigt, wie sich die Bewegung vom Hauptteil über die Kontakte ausbreitet</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ReplaceFile</name>
  <message>
   <source>Replace File</source>
   <translation>Datei ersetzen</translation>
  </message>
  <message>
   <source>&amp;Replace File…</source>
   <translation>&amp;Datei ersetzen…</translation>
  </message>
  <message>
   <source>Reads the changed file of the selected part and finds its regions on the new mesh; regions that changed are listed and selected</source>
   <translation>Liest die geänderte Datei des ausgewählten Teils und findet die Regionen auf dem neuen Netz; geänderte Regionen werden gemeldet und ausgewählt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ResetMotion</name>
  <message>
   <source>&amp;Reset Motion</source>
   <translation>Bewegung &amp;zurücksetzen</translation>
  </message>
  <message>
   <source>Returns the selected handles, or all handles of the morph, to rest</source>
   <translation>Bringt die ausgewählten Griffe, sonst alle Griffe des Morphs, in die Ruhelage zurück</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SavePose</name>
  <message>
   <source>Save Pose</source>
   <translation>Stellung speichern</translation>
  </message>
  <message>
   <source>Name of the pose</source>
   <translation>Name der Stellung</translation>
  </message>
  <message>
   <source>Pose {0}</source>
   <translation>Stellung {0}</translation>
  </message>
  <message>
   <source>&amp;Save Pose…</source>
   <translation>Stellung &amp;speichern…</translation>
  </message>
  <message>
   <source>Saves the current positions of all handles under a name</source>
   <translation>Speichert die aktuellen Lagen aller Griffe unter einem Namen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SetPrimary</name>
  <message>
   <source>&amp;Set as Primary</source>
   <translation>Zum &amp;Hauptteil machen</translation>
  </message>
  <message>
   <source>Makes the selected part the primary part, which is deformed first; the others follow it</source>
   <translation>Macht das ausgewählte Teil zum Hauptteil, das zuerst verformt wird; die anderen folgen ihm</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Study</name>
  <message>
   <source>S&amp;tudy…</source>
   <translation>S&amp;tudie…</translation>
  </message>
  <message>
   <source>Computes and certifies many variants in the background and lists them in a table</source>
   <translation>Berechnet und zertifiziert im Hintergrund viele Varianten und listet sie in einer Tabelle auf</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ThicknessMap</name>
  <message>
   <source>&amp;Thickness…</source>
   <translation>Di&amp;cke…</translation>
  </message>
  <message>
   <source>Shows the thickness of the selected part in colours, and lets the part bend as one sheet</source>
   <translation>Zeigt die Dicke des ausgewählten Teils in Farben und lässt es sich als ein Blech biegen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ToggleContact</name>
  <message>
   <source>&amp;Toggle Contact</source>
   <translation>Kontakt &amp;ein-/ausschalten</translation>
  </message>
  <message>
   <source>Switches the selected contacts off, so that nothing propagates through them, or on again</source>
   <translation>Schaltet die gewählten Kontakte aus, sodass sich nichts durch sie ausbreitet, oder wieder ein</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_actions</name>
  <message>
   <source>SheetMorph has a bug ({0}). Please report it.</source>
   <translation>SheetMorph hat einen Programmfehler ({0}). Bitte melden Sie ihn.</translation>
  </message>
  <message>
   <source>Cancelled. Nothing was changed.</source>
   <translation>Abgebrochen. Nichts wurde geändert.</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>Abbrechen</translation>
  </message>
  <message>
   <source>Cancelling…</source>
   <translation>Wird abgebrochen …</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_contact</name>
  <message>
   <source>Contact</source>
   <translation>Kontakt</translation>
  </message>
  <message>
   <source>Parts</source>
   <translation>Teile</translation>
  </message>
  <message>
   <source>The part on this side. You can also click on it in the 3D view</source>
   <translation>Das Teil auf dieser Seite. Sie können es auch in der 3D-Ansicht anklicken</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>Typ</translation>
  </message>
  <message>
   <source>How the second part follows the first</source>
   <translation>Wie das zweite Teil dem ersten folgt</translation>
  </message>
  <message>
   <source>In use</source>
   <translation>Aktiv</translation>
  </message>
  <message>
   <source>Off: the contact stays in the document but transfers no motion</source>
   <translation>Aus: Der Kontakt bleibt im Dokument, überträgt aber keine Bewegung</translation>
  </message>
  <message>
   <source>Vertices</source>
   <translation>Knoten</translation>
  </message>
  <message>
   <source>The vertices of both parts that the contact joins</source>
   <translation>Die Knoten beider Teile, die der Kontakt verbindet</translation>
  </message>
  <message>
   <source>Within the gap distance</source>
   <translation>Innerhalb des Spaltabstands</translation>
  </message>
  <message>
   <source>Picked by hand: first part</source>
   <translation>Von Hand gewählt: erstes Teil</translation>
  </message>
  <message>
   <source>Picked by hand: second part</source>
   <translation>Von Hand gewählt: zweites Teil</translation>
  </message>
  <message>
   <source>Gap distance: vertices within this distance of the other part belong to the contact</source>
   <translation>Spaltabstand: Knoten innerhalb dieses Abstands vom anderen Teil gehören zum Kontakt</translation>
  </message>
  <message>
   <source>Pick</source>
   <translation>Wählen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_feature</name>
  <message>
   <source>Form Feature</source>
   <translation>Formelement</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>How the rotation of the form feature is determined</source>
   <translation>Wodurch die Drehung des Formelements bestimmt wird</translation>
  </message>
  <message>
   <source>Free: follows the sheet</source>
   <translation>Frei: folgt dem Blech</translation>
  </message>
  <message>
   <source>Interpolated: follows the handles</source>
   <translation>Interpoliert: folgt den Griffen</translation>
  </message>
  <message>
   <source>Prescribed</source>
   <translation>Vorgeschrieben</translation>
  </message>
  <message>
   <source>Axis</source>
   <translation>Achse</translation>
  </message>
  <message>
   <source>x of the axis of the rotation, global</source>
   <translation>x der Drehachse, global</translation>
  </message>
  <message>
   <source>y of the axis of the rotation, global</source>
   <translation>y der Drehachse, global</translation>
  </message>
  <message>
   <source>z of the axis of the rotation, global</source>
   <translation>z der Drehachse, global</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Angle of the rotation; more than one turn is possible</source>
   <translation>Drehwinkel; mehr als eine Umdrehung ist möglich</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>Bewegung</translation>
  </message>
  <message>
   <source>The motion that the form feature is allowed</source>
   <translation>Die Bewegung, die dem Formelement erlaubt ist</translation>
  </message>
  <message>
   <source>Free</source>
   <translation>Frei</translation>
  </message>
  <message>
   <source>Fixed: stays in place</source>
   <translation>Fest: bleibt an seinem Ort</translation>
  </message>
  <message>
   <source>Translation: does not turn</source>
   <translation>Verschiebung: dreht sich nicht</translation>
  </message>
  <message>
   <source>Plane: moves in a plane</source>
   <translation>Ebene: bewegt sich in einer Ebene</translation>
  </message>
  <message>
   <source>Line: moves along a line</source>
   <translation>Gerade: bewegt sich entlang einer Geraden</translation>
  </message>
  <message>
   <source>Axis: turns about an axis</source>
   <translation>Achse: dreht sich um eine Achse</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>Richtung</translation>
  </message>
  <message>
   <source>x of the normal, line or axis, global</source>
   <translation>x der Normalen, Geraden oder Achse, global</translation>
  </message>
  <message>
   <source>y of the normal, line or axis, global</source>
   <translation>y der Normalen, Geraden oder Achse, global</translation>
  </message>
  <message>
   <source>z of the normal, line or axis, global</source>
   <translation>z der Normalen, Geraden oder Achse, global</translation>
  </message>
  <message>
   <source>Point</source>
   <translation>Punkt</translation>
  </message>
  <message>
   <source>x of a point on the axis, global</source>
   <translation>x eines Punkts auf der Achse, global</translation>
  </message>
  <message>
   <source>y of a point on the axis, global</source>
   <translation>y eines Punkts auf der Achse, global</translation>
  </message>
  <message>
   <source>z of a point on the axis, global</source>
   <translation>z eines Punkts auf der Achse, global</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>Sets the size of the hole, slot or cylinder; the sheet around it follows</source>
   <translation>Legt die Größe von Loch, Langloch oder Zylinder fest; das Blech ringsum folgt</translation>
  </message>
  <message>
   <source>Diameter of a hole, length of a slot, radius of a cylinder</source>
   <translation>Durchmesser eines Lochs, Länge eines Langlochs, Radius eines Zylinders</translation>
  </message>
  <message>
   <source>Relation</source>
   <translation>Beziehung</translation>
  </message>
  <message>
   <source>Relation between this form feature and the ticked ones</source>
   <translation>Beziehung zwischen diesem Formelement und den angehakten</translation>
  </message>
  <message>
   <source>No new relation</source>
   <translation>Keine neue Beziehung</translation>
  </message>
  <message>
   <source>Group: moves as one body with…</source>
   <translation>Gruppe: bewegt sich als ein Körper mit…</translation>
  </message>
  <message>
   <source>Coaxial: shares its axis with…</source>
   <translation>Koaxial: teilt seine Achse mit…</translation>
  </message>
  <message>
   <source>Distance: keeps its distance to…</source>
   <translation>Abstand: behält seinen Abstand zu…</translation>
  </message>
  <message>
   <source>Form features for the new relation</source>
   <translation>Formelemente für die neue Beziehung</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_find</name>
  <message>
   <source>Already in the document</source>
   <translation>Bereits im Dokument</translation>
  </message>
  <message>
   <source>Find Features</source>
   <translation>Formelemente finden</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Formelement</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>Deviation</source>
   <translation>Abweichung</translation>
  </message>
  <message>
   <source>Find Contacts</source>
   <translation>Kontakte finden</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>Kontakt</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>Typ</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>Spalt</translation>
  </message>
  <message>
   <source>Size: diameter or length. Deviation: distance of the rim from its ideal form.</source>
   <translation>Größe: Durchmesser oder Länge. Abweichung: Abstand des Rands von seiner Idealform.</translation>
  </message>
  <message>
   <source>Size of the contact area; median gap.</source>
   <translation>Größe der Kontaktfläche; mittlerer Spalt (Median).</translation>
  </message>
  <message>
   <source>Find</source>
   <translation>Suchen</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>Zeigen</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>Art</translation>
  </message>
  <message>
   <source>Shows one kind only. Hidden rows are not created</source>
   <translation>Zeigt nur eine Art. Ausgeblendete Zeilen werden nicht erzeugt</translation>
  </message>
  <message>
   <source>From</source>
   <translation>Von</translation>
  </message>
  <message>
   <source>Hides smaller ones. Hidden rows are not created</source>
   <translation>Blendet kleinere aus. Ausgeblendete Zeilen werden nicht erzeugt</translation>
  </message>
  <message>
   <source>to</source>
   <translation>bis</translation>
  </message>
  <message>
   <source>Hides larger ones. Hidden rows are not created</source>
   <translation>Blendet größere aus. Ausgeblendete Zeilen werden nicht erzeugt</translation>
  </message>
  <message>
   <source>any size</source>
   <translation>jede Größe</translation>
  </message>
  <message>
   <source>Checked rows are created. The row under the mouse lights up in the 3D view</source>
   <translation>Angehakte Zeilen werden erzeugt. Die Zeile unter der Maus leuchtet in der 3D-Ansicht auf</translation>
  </message>
  <message>
   <source>Checks all visible rows</source>
   <translation>Hakt alle sichtbaren Zeilen an</translation>
  </message>
  <message>
   <source>All</source>
   <translation>Alle</translation>
  </message>
  <message>
   <source>Unchecks all visible rows</source>
   <translation>Nimmt alle sichtbaren Haken weg</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>Tolerances</source>
   <translation>Toleranzen</translation>
  </message>
  <message>
   <source>Roundness tolerance</source>
   <translation>Rundheitstoleranz</translation>
  </message>
  <message>
   <source>Largest distance of a rim vertex from the fitted circle, relative to its radius</source>
   <translation>Größter Abstand eines Randknotens vom angepassten Kreis, bezogen auf dessen Radius</translation>
  </message>
  <message>
   <source>Edge angle</source>
   <translation>Kantenwinkel</translation>
  </message>
  <message>
   <source>The surface has an edge where it bends by more than this angle</source>
   <translation>Die Fläche hat eine Kante, wo sie um mehr als diesen Winkel knickt</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>Ringe um Loch</translation>
  </message>
  <message>
   <source>Number of triangle rings around a hole that keep their shape with it</source>
   <translation>Anzahl der Dreiecksringe um ein Loch, die mit ihm ihre Form behalten</translation>
  </message>
  <message>
   <source>Also surfaces and beads</source>
   <translation>Auch Flächen und Sicken</translation>
  </message>
  <message>
   <source>Also proposes planes, cylinders, flanges and beads</source>
   <translation>Schlägt auch Ebenen, Zylinder, Flansche und Sicken vor</translation>
  </message>
  <message>
   <source>Largest gap</source>
   <translation>Größter Spalt</translation>
  </message>
  <message>
   <source>Parts farther apart are not in contact. 0: the proposed value for these parts</source>
   <translation>Teile mit größerem Abstand sind nicht in Kontakt. 0: der für diese Teile vorgeschlagene Wert</translation>
  </message>
  <message>
   <source>automatic</source>
   <translation>automatisch</translation>
  </message>
  <message>
   <source>Facing tolerance</source>
   <translation>Winkeltoleranz</translation>
  </message>
  <message>
   <source>Largest angle between two surfaces in contact</source>
   <translation>Größter Winkel zwischen zwei Flächen in Kontakt</translation>
  </message>
  <message>
   <source>One contact per pair of parts</source>
   <translation>Ein Kontakt je Teilepaar</translation>
  </message>
  <message>
   <source>Joins all places where two parts touch into one contact</source>
   <translation>Fasst alle Stellen, an denen sich zwei Teile berühren, zu einem Kontakt zusammen</translation>
  </message>
  <message>
   <source>Searches again with these tolerances</source>
   <translation>Sucht erneut mit diesen Toleranzen</translation>
  </message>
  <message>
   <source>Search Again</source>
   <translation>Erneut suchen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_guide</name>
  <message>
   <source>Guide</source>
   <translation>Assistent</translation>
  </message>
  <message>
   <source>The morph of this guide: the selected one, or the only one in the document</source>
   <translation>Der Morph dieses Assistenten: der ausgewählte oder der einzige im Dokument</translation>
  </message>
  <message>
   <source>1  Parts</source>
   <translation>1  Teile</translation>
  </message>
  <message>
   <source>2  Fixed regions</source>
   <translation>2  Feste Regionen</translation>
  </message>
  <message>
   <source>3  Form features</source>
   <translation>3  Formelemente</translation>
  </message>
  <message>
   <source>4  Contacts</source>
   <translation>4  Kontakte</translation>
  </message>
  <message>
   <source>5  Handles</source>
   <translation>5  Griffe</translation>
  </message>
  <message>
   <source>6  Move</source>
   <translation>6  Bewegen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_menus</name>
  <message>
   <source>Show Problem</source>
   <translation>Problem zeigen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_move</name>
  <message>
   <source>Move Handle</source>
   <translation>Griff bewegen</translation>
  </message>
  <message>
   <source>Handle</source>
   <translation>Griff</translation>
  </message>
  <message>
   <source>The handle to move</source>
   <translation>Der Griff, den Sie bewegen</translation>
  </message>
  <message>
   <source>The axes of fields and arrows: global, or local: Z is the normal of the sheet at the handle, X its longest direction</source>
   <translation>Die Achsen der Felder und Pfeile: global oder lokal: Z ist die Normale des Blechs am Griff, X seine längste Richtung</translation>
  </message>
  <message>
   <source>Global axes</source>
   <translation>Globale Achsen</translation>
  </message>
  <message>
   <source>Local axes</source>
   <translation>Lokale Achsen</translation>
  </message>
  <message>
   <source>Translation</source>
   <translation>Verschiebung</translation>
  </message>
  <message>
   <source>X</source>
   <translation>X</translation>
  </message>
  <message>
   <source>Translation along the X axis</source>
   <translation>Verschiebung entlang der X-Achse</translation>
  </message>
  <message>
   <source>Y</source>
   <translation>Y</translation>
  </message>
  <message>
   <source>Translation along the Y axis</source>
   <translation>Verschiebung entlang der Y-Achse</translation>
  </message>
  <message>
   <source>Z</source>
   <translation>Z</translation>
  </message>
  <message>
   <source>Translation along the Z axis</source>
   <translation>Verschiebung entlang der Z-Achse</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Angle of rotation about the axis</source>
   <translation>Drehwinkel um die Achse</translation>
  </message>
  <message>
   <source>Axis</source>
   <translation>Achse</translation>
  </message>
  <message>
   <source>Turns about the global X axis</source>
   <translation>Dreht um die globale x-Achse</translation>
  </message>
  <message>
   <source>Turns about the global Y axis</source>
   <translation>Dreht um die globale y-Achse</translation>
  </message>
  <message>
   <source>Turns about the global Z axis</source>
   <translation>Dreht um die globale z-Achse</translation>
  </message>
  <message>
   <source>X component of the axis</source>
   <translation>x-Komponente der Achse</translation>
  </message>
  <message>
   <source>Y component of the axis</source>
   <translation>y-Komponente der Achse</translation>
  </message>
  <message>
   <source>Z component of the axis</source>
   <translation>z-Komponente der Achse</translation>
  </message>
  <message>
   <source>Admissible range of the value that you changed last: green is possible, red is not. The mark shows the current value</source>
   <translation>Zulässiger Bereich des zuletzt geänderten Werts: Grün ist möglich, Rot nicht. Die Marke zeigt den aktuellen Wert</translation>
  </message>
  <message>
   <source>Pivot</source>
   <translation>Drehpunkt</translation>
  </message>
  <message>
   <source>X of the centre of rotation</source>
   <translation>X des Drehpunkts</translation>
  </message>
  <message>
   <source>Y of the centre of rotation</source>
   <translation>Y des Drehpunkts</translation>
  </message>
  <message>
   <source>Z of the centre of rotation</source>
   <translation>Z des Drehpunkts</translation>
  </message>
  <message>
   <source>Centre of Handle</source>
   <translation>Mitte des Griffs</translation>
  </message>
  <message>
   <source>Turns about the centre of the handle's vertices</source>
   <translation>Dreht um die Mitte der Knoten des Griffs</translation>
  </message>
  <message>
   <source>Move</source>
   <translation>Verschieben</translation>
  </message>
  <message>
   <source>The arrows move the pivot; the shape stays unchanged</source>
   <translation>Die Pfeile verschieben den Drehpunkt; die Form bleibt unverändert</translation>
  </message>
  <message>
   <source>Mouse</source>
   <translation>Maus</translation>
  </message>
  <message>
   <source>Arrows</source>
   <translation>Pfeile</translation>
  </message>
  <message>
   <source>Shows arrows and arcs in the 3D view for dragging the handle</source>
   <translation>Zeigt in der 3D-Ansicht Pfeile und Bögen zum Ziehen des Griffs</translation>
  </message>
  <message>
   <source>Drag points</source>
   <translation>Punkte ziehen</translation>
  </message>
  <message>
   <source>Drags the point under the mouse in the plane of the view; its rotation follows the sheet. A point outside every handle becomes a new handle</source>
   <translation>Zieht den Punkt unter der Maus in der Bildebene; seine Drehung folgt dem Blech. Ein Punkt außerhalb aller Griffe wird ein neuer Griff</translation>
  </message>
  <message>
   <source>Snap to</source>
   <translation>Einrasten auf</translation>
  </message>
  <message>
   <source>Drags in steps; Ctrl reverses this choice while you hold it</source>
   <translation>Zieht in Schritten; solange Sie Strg halten, gilt das Gegenteil</translation>
  </message>
  <message>
   <source>Step of translations</source>
   <translation>Schrittweite von Verschiebungen</translation>
  </message>
  <message>
   <source>Step of rotations</source>
   <translation>Schrittweite von Drehungen</translation>
  </message>
  <message>
   <source>Snap to points of parts</source>
   <translation>Auf Punkte von Teilen einrasten</translation>
  </message>
  <message>
   <source>Drags the handle to the vertex or mid-point of an edge under the mouse, or level with it; Shift reverses this choice while you hold it</source>
   <translation>Zieht den Griff zum Knoten oder zur Kantenmitte unter der Maus oder auf deren Höhe; solange Sie die Umschalttaste halten, gilt das Gegenteil</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>Zeigen</translation>
  </message>
  <message>
   <source>Before</source>
   <translation>Vorher</translation>
  </message>
  <message>
   <source>Shows the shape on its way from rest to the full motion; the motion itself stays unchanged</source>
   <translation>Zeigt die Form auf dem Weg von der Ruhelage zur vollen Bewegung; die Bewegung selbst bleibt unverändert</translation>
  </message>
  <message>
   <source>After</source>
   <translation>Nachher</translation>
  </message>
  <message>
   <source>Original</source>
   <translation>Original</translation>
  </message>
  <message>
   <source>Shows the shape at rest, transparent</source>
   <translation>Zeigt die Form in Ruhe durchscheinend</translation>
  </message>
  <message>
   <source>Form features</source>
   <translation>Formelemente</translation>
  </message>
  <message>
   <source>Shows the displacement and the rotation of every form feature</source>
   <translation>Zeigt Verschiebung und Drehung jedes Formelements</translation>
  </message>
  <message>
   <source>Control meshes</source>
   <translation>Steuernetze</translation>
  </message>
  <message>
   <source>Shows the control meshes of the contacts as wireframes</source>
   <translation>Zeigt die Steuernetze der Kontakte als Drahtgitter</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>Farben</translation>
  </message>
  <message>
   <source>The quantity that the colours of the parts show</source>
   <translation>Die Größe, die die Farben der Teile zeigen</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>Displacement</source>
   <translation>Verschiebung</translation>
  </message>
  <message>
   <source>Triangle quality</source>
   <translation>Dreiecksqualität</translation>
  </message>
  <message>
   <source>Contact gaps</source>
   <translation>Kontaktspalte</translation>
  </message>
  <message>
   <source>Stretch</source>
   <translation>Dehnung</translation>
  </message>
  <message>
   <source>Number of elements by quality. Bars: current shape; grey lines: at rest; red: limit</source>
   <translation>Anzahl der Elemente nach Qualität. Balken: aktuelle Form; graue Linien: in Ruhe; rot: Grenze</translation>
  </message>
  <message>
   <source>Measure</source>
   <translation>Messen</translation>
  </message>
  <message>
   <source>Measures the distance between two points that you click: at rest, now, and the change</source>
   <translation>Misst den Abstand zweier Punkte, die Sie anklicken: in Ruhe, jetzt und die Änderung</translation>
  </message>
  <message>
   <source>Section Planes…</source>
   <translation>Schnittebenen…</translation>
  </message>
  <message>
   <source>Opens FreeCAD's section planes, which cut the view along X, Y, Z or the line of sight</source>
   <translation>Öffnet die Schnittebenen von FreeCAD, die die Ansicht entlang X, Y, Z oder der Blickrichtung schneiden</translation>
  </message>
  <message>
   <source>Reset</source>
   <translation>Zurücksetzen</translation>
  </message>
  <message>
   <source>Returns this handle to rest</source>
   <translation>Bringt diesen Griff in die Ruhelage zurück</translation>
  </message>
  <message>
   <source>Update results</source>
   <translation>Ergebnisse aktualisieren</translation>
  </message>
  <message>
   <source>When the result objects are updated; the 3D view always updates at once</source>
   <translation>Wann die Ergebnisobjekte aktualisiert werden; die 3D-Ansicht folgt immer sofort</translation>
  </message>
  <message>
   <source>Automatically</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>While changing</source>
   <translation>Während der Änderung</translation>
  </message>
  <message>
   <source>On pause</source>
   <translation>Bei Pausen</translation>
  </message>
  <message>
   <source>On OK</source>
   <translation>Bei OK</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_needs</name>
  <message>
   <source>Close the open panel first.</source>
   <translation>Schließen Sie zuerst die offene Maske.</translation>
  </message>
  <message>
   <source>The kernel does not work: see Check Installation.</source>
   <translation>Der Kern funktioniert nicht: siehe „Installation prüfen“.</translation>
  </message>
  <message>
   <source>Create a morph or import a part first.</source>
   <translation>Erzeugen Sie zuerst einen Morph, oder importieren Sie ein Teil.</translation>
  </message>
  <message>
   <source>Select one of the morphs first.</source>
   <translation>Wählen Sie zuerst einen der Morphs.</translation>
  </message>
  <message>
   <source>Select a mesh or a shape first.</source>
   <translation>Wählen Sie zuerst ein Netz oder eine Form.</translation>
  </message>
  <message>
   <source>Add a part to the morph first.</source>
   <translation>Fügen Sie dem Morph zuerst ein Teil hinzu.</translation>
  </message>
  <message>
   <source>Add a second part to the morph first.</source>
   <translation>Fügen Sie dem Morph zuerst ein zweites Teil hinzu.</translation>
  </message>
  <message>
   <source>Select a part other than the primary part first.</source>
   <translation>Wählen Sie zuerst ein anderes Teil als das Hauptteil.</translation>
  </message>
  <message>
   <source>Select a part made from a shape of the document first.</source>
   <translation>Wählen Sie zuerst ein Teil, das aus einer Form des Dokuments entstand.</translation>
  </message>
  <message>
   <source>Select a part made from a CAD shape first.</source>
   <translation>Wählen Sie zuerst ein Teil, das aus einer CAD-Form entstand.</translation>
  </message>
  <message>
   <source>Select a region first.</source>
   <translation>Wählen Sie zuerst eine Region.</translation>
  </message>
  <message>
   <source>Select a form feature first.</source>
   <translation>Wählen Sie zuerst ein Formelement.</translation>
  </message>
  <message>
   <source>Select two form features first.</source>
   <translation>Wählen Sie zuerst zwei Formelemente.</translation>
  </message>
  <message>
   <source>Select two or more form features first.</source>
   <translation>Wählen Sie zuerst zwei oder mehr Formelemente.</translation>
  </message>
  <message>
   <source>Select a contact first.</source>
   <translation>Wählen Sie zuerst einen Kontakt.</translation>
  </message>
  <message>
   <source>Mark a handle first.</source>
   <translation>Markieren Sie zuerst einen Griff.</translation>
  </message>
  <message>
   <source>Save a pose first.</source>
   <translation>Speichern Sie zuerst eine Stellung.</translation>
  </message>
  <message>
   <source>Select a pose first.</source>
   <translation>Wählen Sie zuerst eine Stellung.</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_panels</name>
  <message>
   <source>The shape of {0} could not be computed</source>
   <translation>Die Form von {0} konnte nicht berechnet werden</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stops the computation. Recompute the document to get the shape.</source>
   <translation>Hält die Berechnung an. Berechnen Sie das Dokument neu, um die Form zu erhalten.</translation>
  </message>
  <message>
   <source>Computing the final shape of {0}</source>
   <translation>Die endgültige Form von {0} wird berechnet</translation>
  </message>
  <message>
   <source>This shape could not be computed for an unknown reason ({0}). Please report it.</source>
   <translation>Diese Form konnte aus unbekanntem Grund nicht berechnet werden ({0}). Bitte melden Sie das.</translation>
  </message>
  <message>
   <source>There is not enough memory for this shape. Close other documents, or use a coarser mesh.</source>
   <translation>Der Speicher reicht für diese Form nicht. Schließen Sie andere Dokumente, oder verwenden Sie ein gröberes Netz.</translation>
  </message>
  <message>
   <source>No values: no contact is in use.</source>
   <translation>Keine Werte: Kein Kontakt ist aktiv.</translation>
  </message>
  <message>
   <source>{0} {1} on {2}</source>
   <translation>{0} {1} auf {2}</translation>
  </message>
  <message>
   <source>{0}, near {1}</source>
   <translation>{0}, nahe {1}</translation>
  </message>
  <message>
   <source>Leave at rest</source>
   <translation>In Ruhe lassen</translation>
  </message>
  <message>
   <source>Do not use “{0}”</source>
   <translation>„{0}“ deaktivieren</translation>
  </message>
  <message>
   <source>Remove from “{0}”</source>
   <translation>Aus „{0}“ entfernen</translation>
  </message>
  <message>
   <source>Fixed</source>
   <translation>Fest</translation>
  </message>
  <message>
   <source>Handle</source>
   <translation>Griff</translation>
  </message>
  <message>
   <source>Form feature</source>
   <translation>Formelement</translation>
  </message>
  <message>
   <source>Follower</source>
   <translation>Folgeregion</translation>
  </message>
  <message>
   <source>1 vertex</source>
   <translation>1 Knoten</translation>
  </message>
  <message>
   <source>{0} vertices</source>
   <translation>{0} Knoten</translation>
  </message>
  <message>
   <source>Open Page</source>
   <translation>Seite öffnen</translation>
  </message>
  <message>
   <source>Parts: {0}, form features: {1}, contacts: {2}, joints: {3}</source>
   <translation>Teile: {0}, Formelemente: {1}, Kontakte: {2}, Verbindungen: {3}</translation>
  </message>
  <message>
   <source>Certificate</source>
   <translation>Zertifikat</translation>
  </message>
  <message>
   <source>Certified</source>
   <translation>Zertifiziert</translation>
  </message>
  <message>
   <source>Not certified</source>
   <translation>Nicht zertifiziert</translation>
  </message>
  <message>
   <source>and {0} more</source>
   <translation>und {0} weitere</translation>
  </message>
  <message>
   <source>The parts are farther apart than the gap distance: enter a larger one, or pick by hand.</source>
   <translation>Die Teile liegen weiter auseinander als der Spaltabstand: Geben Sie einen größeren ein, oder wählen Sie von Hand.</translation>
  </message>
  <message>
   <source>Choose two parts: click on one, then on the other.</source>
   <translation>Wählen Sie zwei Teile: Klicken Sie auf das eine, dann auf das andere.</translation>
  </message>
  <message>
   <source>One side is empty: pick at least one vertex on each part.</source>
   <translation>Eine Seite ist leer: Wählen Sie auf jedem Teil mindestens einen Knoten.</translation>
  </message>
  <message>
   <source>Click on a part…</source>
   <translation>Auf ein Teil klicken…</translation>
  </message>
  <message>
   <source>Control mesh</source>
   <translation>Steuernetz</translation>
  </message>
  <message>
   <source>Tied</source>
   <translation>Gekoppelt</translation>
  </message>
  <message>
   <source>Rigid</source>
   <translation>Starr</translation>
  </message>
  <message>
   <source>The other part bends smoothly with it. Suits most flanges and weld seams.</source>
   <translation>Das andere Teil biegt sich gleichmäßig mit. Geeignet für die meisten Flansche und Schweißnähte.</translation>
  </message>
  <message>
   <source>Every vertex keeps its position relative to the facing triangle. Suits glued faces and tied meshes.</source>
   <translation>Jeder Knoten behält seine Lage zum gegenüberliegenden Dreieck. Geeignet für Klebeflächen und gekoppelte Netze.</translation>
  </message>
  <message>
   <source>Both sides move as one rigid body. Suits bolts, rivets and spot welds.</source>
   <translation>Beide Seiten bewegen sich als ein starrer Körper. Geeignet für Schrauben, Niete und Schweißpunkte.</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>1 Whole part driven</source>
   <translation>1 Ganzes Teil geführt</translation>
  </message>
  <message>
   <source>2 Contacts driven</source>
   <translation>2 Kontakte geführt</translation>
  </message>
  <message>
   <source>3 Contacts and edges driven</source>
   <translation>3 Kontakte und Ränder geführt</translation>
  </message>
  <message>
   <source>SheetMorph chooses from the contacts and form features.</source>
   <translation>SheetMorph wählt anhand der Kontakte und Formelemente.</translation>
  </message>
  <message>
   <source>The control mesh drives every vertex; form features would lose their shape.</source>
   <translation>Das Steuernetz führt jeden Knoten; Formelemente würden ihre Form verlieren.</translation>
  </message>
  <message>
   <source>The control mesh drives contacts and followers; the rest bends like sheet metal, and form features keep their shape.</source>
   <translation>Das Steuernetz führt Kontakte und Folgeregionen; der Rest biegt sich wie Blech, und Formelemente behalten ihre Form.</translation>
  </message>
  <message>
   <source>As 2, and the control mesh also drives free edges inside it.</source>
   <translation>Wie 2, und das Steuernetz führt auch freie Ränder in seinem Inneren.</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>Zeigen</translation>
  </message>
  <message>
   <source>&lt;b&gt;{0}&lt;/b&gt; on {1}</source>
   <translation>&lt;b&gt;{0}&lt;/b&gt; auf {1}</translation>
  </message>
  <message>
   <source>Relations: {0}</source>
   <translation>Beziehungen: {0}</translation>
  </message>
  <message>
   <source>Not a hole, slot or cylinder: it has no size to set.</source>
   <translation>Weder Loch noch Langloch noch Zylinder: Es gibt keine einstellbare Größe.</translation>
  </message>
  <message>
   <source>Tick the related form features, or choose “No new relation”.</source>
   <translation>Haken Sie die Formelemente der Beziehung an, oder wählen Sie „Keine neue Beziehung“.</translation>
  </message>
  <message>
   <source>A pair has two form features: tick one other.</source>
   <translation>Ein Paar hat zwei Formelemente: Haken Sie ein weiteres an.</translation>
  </message>
  <message>
   <source>all kinds</source>
   <translation>alle Arten</translation>
  </message>
  <message>
   <source>{0} of {1} checked</source>
   <translation>{0} von {1} angehakt</translation>
  </message>
  <message>
   <source>{0} of {1} checked, {2} already in the document</source>
   <translation>{0} von {1} angehakt, {2} bereits im Dokument</translation>
  </message>
  <message>
   <source>{0} uncertain (?): point at a row to read why</source>
   <translation>{0} unsicher (?): Zeigen Sie auf eine Zeile, um den Grund zu lesen</translation>
  </message>
  <message>
   <source>Nothing is checked. Check proposals, or cancel.</source>
   <translation>Nichts ist angehakt. Haken Sie Vorschläge an, oder brechen Sie ab.</translation>
  </message>
  <message>
   <source>selected parts only</source>
   <translation>nur ausgewählte Teile</translation>
  </message>
  <message>
   <source>Distance {0}; at rest {1}; change {2}</source>
   <translation>Abstand {0}; in Ruhe {1}; Änderung {2}</translation>
  </message>
  <message>
   <source>Click the second point.</source>
   <translation>Klicken Sie auf den zweiten Punkt.</translation>
  </message>
  <message>
   <source>Click two points of the parts.</source>
   <translation>Klicken Sie auf zwei Punkte der Teile.</translation>
  </message>
  <message>
   <source>Driven by the expression {0}</source>
   <translation>Vom Ausdruck {0} gesteuert</translation>
  </message>
  <message>
   <source>Computed in {0:.1f} ms, drawn in {1:.1f} ms</source>
   <translation>Berechnet in {0:.1f} ms, gezeichnet in {1:.1f} ms</translation>
  </message>
  <message>
   <source>These parts will not follow, because no contact reaches them: {0}</source>
   <translation>Diese Teile folgen nicht, weil kein Kontakt sie erreicht: {0}</translation>
  </message>
  <message>
   <source>Shown at {0:.0f} % of the motion. {1}</source>
   <translation>Gezeigt bei {0:.0f} % der Bewegung. {1}</translation>
  </message>
  <message>
   <source>Computing the exact shape</source>
   <translation>Die genaue Form wird berechnet</translation>
  </message>
  <message>
   <source>Nothing has moved yet.</source>
   <translation>Noch ist nichts bewegt.</translation>
  </message>
  <message>
   <source>{0} contacts open or close too far (see Propagation). The first:</source>
   <translation>{0} Kontakte öffnen oder schließen sich zu weit (siehe Ausbreitung). Der erste:</translation>
  </message>
  <message>
   <source>Linear preview; the steel shape is computed on a pause. {0}</source>
   <translation>Lineare Vorschau; die Stahlform wird in einer Pause berechnet. {0}</translation>
  </message>
  <message>
   <source>Computing steel shape (step {0})</source>
   <translation>Stahlform wird berechnet (Schritt {0})</translation>
  </message>
  <message>
   <source>Preview: refined on release. {0}</source>
   <translation>Vorschau: wird beim Loslassen verfeinert. {0}</translation>
  </message>
  <message>
   <source>Final steel shape. {0}</source>
   <translation>Endgültige Stahlform. {0}</translation>
  </message>
  <message>
   <source>At rest</source>
   <translation>In Ruhe</translation>
  </message>
  <message>
   <source>Back in the previous shape. Move the slider to blend again.</source>
   <translation>Wieder in der vorherigen Form. Bewegen Sie den Regler, um erneut zu überblenden.</translation>
  </message>
  <message>
   <source>Largest and mean distance, mm</source>
   <translation>Größter und mittlerer Abstand, mm</translation>
  </message>
  <message>
   <source>Choose a pose.</source>
   <translation>Wählen Sie eine Stellung.</translation>
  </message>
  <message>
   <source>and {0} more parts</source>
   <translation>und {0} weitere Teile</translation>
  </message>
  <message>
   <source>Split into its {} pieces</source>
   <translation>In seine {} Stücke aufteilen</translation>
  </message>
  <message>
   <source>Enter a distance for merging vertices, such as 0.01 mm.</source>
   <translation>Geben Sie einen Abstand zum Zusammenführen der Knoten ein, etwa 0.01 mm.</translation>
  </message>
  <message>
   <source>Nothing is chosen. Choose a repair, or cancel.</source>
   <translation>Nichts ist gewählt. Wählen Sie eine Reparatur, oder brechen Sie ab.</translation>
  </message>
  <message>
   <source>Choose a repair first.</source>
   <translation>Wählen Sie zuerst eine Reparatur.</translation>
  </message>
  <message>
   <source>The parts follow in the background…</source>
   <translation>Die Teile folgen im Hintergrund …</translation>
  </message>
  <message>
   <source>Mark a fixed region and a handle first.</source>
   <translation>Markieren Sie zuerst eine feste Region und einen Griff.</translation>
  </message>
  <message>
   <source>No contact reaches these parts, so they stay at rest: mark a contact with a part above.</source>
   <translation>Kein Kontakt erreicht diese Teile, daher bleiben sie in Ruhe: Markieren Sie einen Kontakt mit einem Teil weiter oben.</translation>
  </message>
  <message>
   <source>Contacts that transfer no motion: switched off, not reached, or not needed.</source>
   <translation>Kontakte, die keine Bewegung übertragen: ausgeschaltet, nicht erreicht oder nicht benötigt.</translation>
  </message>
  <message>
   <source>Largest change of the gap between both sides</source>
   <translation>Größte Änderung des Spalts zwischen beiden Seiten</translation>
  </message>
  <message>
   <source>Not reached</source>
   <translation>Nicht erreicht</translation>
  </message>
  <message>
   <source>Contacts not in use</source>
   <translation>Nicht aktive Kontakte</translation>
  </message>
  <message>
   <source>primary</source>
   <translation>Hauptteil</translation>
  </message>
  <message>
   <source>off</source>
   <translation>aus</translation>
  </message>
  <message>
   <source>not in use</source>
   <translation>nicht aktiv</translation>
  </message>
  <message>
   <source>from {0}</source>
   <translation>von {0}</translation>
  </message>
  <message>
   <source>step {0}</source>
   <translation>Schritt {0}</translation>
  </message>
  <message>
   <source>Change one value to see its admissible range.</source>
   <translation>Ändern Sie einen Wert, um seinen zulässigen Bereich zu sehen.</translation>
  </message>
  <message>
   <source>Searching the admissible range…</source>
   <translation>Zulässiger Bereich wird gesucht …</translation>
  </message>
  <message>
   <source>{0}; beyond this, triangles flip</source>
   <translation>{0}; darüber hinaus klappen Dreiecke um</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>{0}: {1} to {2}{3}</source>
   <translation>{0}: {1} bis {2}{3}</translation>
  </message>
  <message>
   <source>{0}; beyond this: {1}</source>
   <translation>{0}; darüber hinaus: {1}</translation>
  </message>
  <message>
   <source>{0}: at least {1} to {2}{3}</source>
   <translation>{0}: mindestens {1} bis {2}{3}</translation>
  </message>
  <message>
   <source>Elements: aspect</source>
   <translation>Elemente: Seitenverhältnis</translation>
  </message>
  <message>
   <source>Elements: warpage</source>
   <translation>Elemente: Verwindung</translation>
  </message>
  <message>
   <source>Elements: skew</source>
   <translation>Elemente: Schiefe</translation>
  </message>
  <message>
   <source>Elements: taper</source>
   <translation>Elemente: Verjüngung</translation>
  </message>
  <message>
   <source>Elements: Jacobian</source>
   <translation>Elemente: Jacobi</translation>
  </message>
  <message>
   <source>Elements: smallest angle</source>
   <translation>Elemente: kleinster Winkel</translation>
  </message>
  <message>
   <source>Elements: largest angle</source>
   <translation>Elemente: größter Winkel</translation>
  </message>
  <message>
   <source>Elements: shortest edge</source>
   <translation>Elemente: kürzeste Kante</translation>
  </message>
  <message>
   <source>; {0} of {1} elements beyond the limit of {2:g}</source>
   <translation>; {0} von {1} Elementen jenseits der Grenze von {2:g}</translation>
  </message>
  <message>
   <source>No variants yet.</source>
   <translation>Noch keine Varianten.</translation>
  </message>
  <message>
   <source>Folder for the Variants</source>
   <translation>Ordner für die Varianten</translation>
  </message>
  <message>
   <source>{0}. Double-click a row to apply the variant.</source>
   <translation>{0}. Doppelklicken Sie auf eine Zeile, um die Variante anzuwenden.</translation>
  </message>
  <message>
   <source>Variants are still being computed. Wait, or stop them.</source>
   <translation>Varianten werden noch berechnet. Warten Sie, oder halten Sie an.</translation>
  </message>
  <message>
   <source>Stopped: the document has changed.</source>
   <translation>Angehalten: das Dokument hat sich geändert.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Name</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>From</source>
   <translation>Von</translation>
  </message>
  <message>
   <source>To</source>
   <translation>Bis</translation>
  </message>
  <message>
   <source>smallest corner, °</source>
   <translation>kleinster Winkel, °</translation>
  </message>
  <message>
   <source>stretch, %</source>
   <translation>Dehnung, %</translation>
  </message>
  <message>
   <source>passed</source>
   <translation>bestanden</translation>
  </message>
  <message>
   <source>failed</source>
   <translation>nicht bestanden</translation>
  </message>
  <message>
   <source>refused</source>
   <translation>abgelehnt</translation>
  </message>
  <message>
   <source>error</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>Lauf</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Status</translation>
  </message>
  <message>
   <source>“{0}” for “{1}” is not a number.</source>
   <translation>„{0}“ für „{1}“ ist keine Zahl.</translation>
  </message>
  <message>
   <source>Median thickness &lt;b&gt;{0}&lt;/b&gt;, from {1} to {2}</source>
   <translation>Mittlere Dicke (Median) &lt;b&gt;{0}&lt;/b&gt;, von {1} bis {2}</translation>
  </message>
  <message>
   <source>Holes through both skins: {0}</source>
   <translation>Löcher durch beide Häute: {0}</translation>
  </message>
  <message>
   <source>Thick regions (stay rigid): {0}</source>
   <translation>Dicke Bereiche (bleiben starr): {0}</translation>
  </message>
  <message>
   <source>{0} walls and thick regions: no thickness</source>
   <translation>{0} Wände und dicke Bereiche: ohne Dicke</translation>
  </message>
  <message>
   <source>'{0}' is not a thin solid: {1}.</source>
   <translation>„{0}“ ist kein dünner Körper: {1}.</translation>
  </message>
  <message>
   <source>worst aspect</source>
   <translation>schlechtestes Seitenverhältnis</translation>
  </message>
  <message>
   <source>worst warpage</source>
   <translation>größte Verwindung</translation>
  </message>
  <message>
   <source>worst skew</source>
   <translation>größte Schiefe</translation>
  </message>
  <message>
   <source>worst taper</source>
   <translation>größte Verjüngung</translation>
  </message>
  <message>
   <source>worst Jacobian</source>
   <translation>schlechteste Jacobi-Zahl</translation>
  </message>
  <message>
   <source>smallest corner</source>
   <translation>kleinster Winkel</translation>
  </message>
  <message>
   <source>largest corner</source>
   <translation>größter Winkel</translation>
  </message>
  <message>
   <source>shortest edge</source>
   <translation>kürzeste Kante</translation>
  </message>
  <message>
   <source>largest displacement</source>
   <translation>größte Verschiebung</translation>
  </message>
  <message>
   <source>largest stretch</source>
   <translation>größte Dehnung</translation>
  </message>
  <message>
   <source>largest change</source>
   <translation>größte Änderung</translation>
  </message>
  <message>
   <source>Vertex</source>
   <translation>Knoten</translation>
  </message>
  <message>
   <source>Mid-point</source>
   <translation>Kantenmitte</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_picking</name>
  <message>
   <source>Click picks, Shift adds, Ctrl removes.</source>
   <translation>Klick wählt, Umschalt fügt hinzu, Strg entfernt.</translation>
  </message>
  <message>
   <source>Paint with the left button. The wheel changes the size, Ctrl+wheel zooms. Ctrl+paint removes.</source>
   <translation>Malen Sie mit der linken Taste. Das Rad ändert die Größe, Strg+Rad zoomt. Strg+Malen entfernt.</translation>
  </message>
  <message>
   <source>Drag from corner to corner. Shift adds, Ctrl removes.</source>
   <translation>Ziehen Sie von Ecke zu Ecke. Umschalt fügt hinzu, Strg entfernt.</translation>
  </message>
  <message>
   <source>Hold the left button and draw an outline. Shift adds, Ctrl removes.</source>
   <translation>Zeichnen Sie mit gedrückter linker Taste einen Umriss. Umschalt fügt hinzu, Strg entfernt.</translation>
  </message>
  <message>
   <source>Vertex</source>
   <translation>Knoten</translation>
  </message>
  <message>
   <source>Picks single vertices</source>
   <translation>Wählt einzelne Knoten</translation>
  </message>
  <message>
   <source>Facet</source>
   <translation>Facette</translation>
  </message>
  <message>
   <source>Picks single facets</source>
   <translation>Wählt einzelne Facetten</translation>
  </message>
  <message>
   <source>Face</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>Picks a face up to its creases</source>
   <translation>Wählt eine Fläche bis zu ihren Knicken</translation>
  </message>
  <message>
   <source>Hole rim</source>
   <translation>Lochrand</translation>
  </message>
  <message>
   <source>Picks the rim of a hole with one click near it</source>
   <translation>Wählt den Rand eines Lochs durch einen Klick in seiner Nähe</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>Teil</translation>
  </message>
  <message>
   <source>Picks the whole connected part</source>
   <translation>Wählt das ganze zusammenhängende Teil</translation>
  </message>
  <message>
   <source>Brush</source>
   <translation>Pinsel</translation>
  </message>
  <message>
   <source>Picks everything that you paint over; the wheel changes the size of the brush</source>
   <translation>Wählt alles, was Sie übermalen; das Rad ändert die Größe des Pinsels</translation>
  </message>
  <message>
   <source>Rectangle</source>
   <translation>Rechteck</translation>
  </message>
  <message>
   <source>Picks everything inside a rectangle that you draw</source>
   <translation>Wählt alles in einem Rechteck, das Sie aufziehen</translation>
  </message>
  <message>
   <source>Lasso</source>
   <translation>Lasso</translation>
  </message>
  <message>
   <source>Picks everything inside an outline that you draw</source>
   <translation>Wählt alles in einem Umriss, den Sie zeichnen</translation>
  </message>
  <message>
   <source>New</source>
   <translation>Ersetzen</translation>
  </message>
  <message>
   <source>Replaces the selection (the brush adds)</source>
   <translation>Ersetzt die Auswahl (der Pinsel fügt hinzu)</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <source>Adds to the selection, as with Shift</source>
   <translation>Fügt zur Auswahl hinzu, wie mit Umschalt</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Entfernen</translation>
  </message>
  <message>
   <source>Removes from the selection, as with Ctrl</source>
   <translation>Entfernt aus der Auswahl, wie mit Strg</translation>
  </message>
  <message>
   <source>Crease angle</source>
   <translation>Knickwinkel</translation>
  </message>
  <message>
   <source>A face or a rim ends where the surface bends by more than this angle</source>
   <translation>Eine Fläche oder ein Rand endet, wo die Oberfläche um mehr als diesen Winkel knickt</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>Ringe um Loch</translation>
  </message>
  <message>
   <source>Number of vertex rings around the rim that are picked with it</source>
   <translation>Anzahl der Knotenringe um den Rand, die mitgewählt werden</translation>
  </message>
  <message>
   <source>Brush radius</source>
   <translation>Pinselradius</translation>
  </message>
  <message>
   <source>Radius of the brush on the screen; the wheel changes it</source>
   <translation>Radius des Pinsels auf dem Bildschirm; das Rad ändert ihn</translation>
  </message>
  <message>
   <source> px</source>
   <translation> px</translation>
  </message>
  <message>
   <source>Select through</source>
   <translation>Durch Verdeckendes wählen</translation>
  </message>
  <message>
   <source>Also picks vertices that other parts or facets hide</source>
   <translation>Wählt auch Knoten, die von anderen Teilen oder Facetten verdeckt sind</translation>
  </message>
  <message>
   <source>Grow</source>
   <translation>Wachsen</translation>
  </message>
  <message>
   <source>Adds one ring of neighbouring vertices</source>
   <translation>Fügt einen Ring benachbarter Knoten hinzu</translation>
  </message>
  <message>
   <source>Shrink</source>
   <translation>Schrumpfen</translation>
  </message>
  <message>
   <source>Removes the outermost ring of vertices</source>
   <translation>Entfernt den äußersten Ring von Knoten</translation>
  </message>
  <message>
   <source>Invert</source>
   <translation>Umkehren</translation>
  </message>
  <message>
   <source>Picks the vertices that are not picked now, and releases the others</source>
   <translation>Wählt die bisher nicht gewählten Knoten und gibt die anderen frei</translation>
  </message>
  <message>
   <source>Undo Pick</source>
   <translation>Auswahl rückgängig</translation>
  </message>
  <message>
   <source>Undoes the last pick</source>
   <translation>Macht die letzte Auswahl rückgängig</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>Leeren</translation>
  </message>
  <message>
   <source>Clears the selection</source>
   <translation>Leert die Auswahl</translation>
  </message>
  <message>
   <source>All Holes</source>
   <translation>Alle Löcher</translation>
  </message>
  <message>
   <source>Picks the rims of all holes of the part</source>
   <translation>Wählt die Ränder aller Löcher des Teils</translation>
  </message>
  <message>
   <source>Advanced</source>
   <translation>Erweitert</translation>
  </message>
  <message>
   <source>Shows the selector of the picked vertices</source>
   <translation>Zeigt den Selektor der gewählten Knoten</translation>
  </message>
  <message>
   <source>Selector, such as {"face_at": [x, y, z]}</source>
   <translation>Selektor, etwa {"face_at": [x, y, z]}</translation>
  </message>
  <message>
   <source>Selector of the picked vertices, as in a recipe, in the coordinates of the part's file. Type another one and press Enter</source>
   <translation>Selektor der gewählten Knoten, wie in einem Rezept, in den Koordinaten der Datei des Teils. Geben Sie einen anderen ein und drücken Sie Enter</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_pose</name>
  <message>
   <source>Blend Poses</source>
   <translation>Stellungen überblenden</translation>
  </message>
  <message>
   <source>From</source>
   <translation>Von</translation>
  </message>
  <message>
   <source>The pose at 0 %</source>
   <translation>Die Stellung bei 0 %</translation>
  </message>
  <message>
   <source>To</source>
   <translation>Bis</translation>
  </message>
  <message>
   <source>The pose at 100 %</source>
   <translation>Die Stellung bei 100 %</translation>
  </message>
  <message>
   <source>Position of the morph between the two poses</source>
   <translation>Lage des Morphs zwischen den beiden Stellungen</translation>
  </message>
  <message>
   <source>The same as a number; values below 0 or above 100 % extrapolate the motion</source>
   <translation>Dasselbe als Zahl; Werte unter 0 oder über 100 % setzen die Bewegung fort</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_preferences</name>
  <message>
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <source>Moving handles</source>
   <translation>Griffe bewegen</translation>
  </message>
  <message>
   <source>Update results</source>
   <translation>Ergebnisse aktualisieren</translation>
  </message>
  <message>
   <source>When the result objects are updated; the 3D view always updates at once. Automatically: at once if this takes less than 50 ms, otherwise on a pause</source>
   <translation>Wann die Ergebnisobjekte aktualisiert werden; die 3D-Ansicht folgt immer sofort. Automatisch: sofort, wenn es weniger als 50 ms dauert, sonst bei Pausen</translation>
  </message>
  <message>
   <source>Automatically</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>While changing</source>
   <translation>Während der Änderung</translation>
  </message>
  <message>
   <source>On pause</source>
   <translation>Bei Pausen</translation>
  </message>
  <message>
   <source>On OK</source>
   <translation>Bei OK</translation>
  </message>
  <message>
   <source>Shows arrows for dragging when the Move Handle panel opens</source>
   <translation>Zeigt Pfeile zum Ziehen, wenn „Griff bewegen“ geöffnet wird</translation>
  </message>
  <message>
   <source>Arrows and arcs in the view</source>
   <translation>Pfeile und Bögen in der Ansicht</translation>
  </message>
  <message>
   <source>Moves in steps while you drag with the mouse</source>
   <translation>Bewegt beim Ziehen mit der Maus in Schritten</translation>
  </message>
  <message>
   <source>Snap to steps</source>
   <translation>Auf Schritte einrasten</translation>
  </message>
  <message>
   <source>Length step</source>
   <translation>Längenschritt</translation>
  </message>
  <message>
   <source>Translations by the mouse snap to multiples of this length</source>
   <translation>Verschiebungen mit der Maus rasten auf Vielfache dieser Länge ein</translation>
  </message>
  <message>
   <source>Angle step</source>
   <translation>Winkelschritt</translation>
  </message>
  <message>
   <source>Rotations by the mouse snap to multiples of this angle</source>
   <translation>Drehungen mit der Maus rasten auf Vielfache dieses Winkels ein</translation>
  </message>
  <message>
   <source>Picking</source>
   <translation>Auswählen</translation>
  </message>
  <message>
   <source>Crease angle</source>
   <translation>Knickwinkel</translation>
  </message>
  <message>
   <source>A face ends where the sheet bends by more than this angle</source>
   <translation>Eine Fläche endet, wo das Blech um mehr als diesen Winkel knickt</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>Ringe um Loch</translation>
  </message>
  <message>
   <source>Number of vertex rings around the rim that belong to a hole</source>
   <translation>Anzahl der Knotenringe um den Rand, die zu einem Loch gehören</translation>
  </message>
  <message>
   <source>Brush radius</source>
   <translation>Pinselradius</translation>
  </message>
  <message>
   <source>Radius of the brush on the screen</source>
   <translation>Radius des Pinsels auf dem Bildschirm</translation>
  </message>
  <message>
   <source> px</source>
   <translation> px</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>Farben</translation>
  </message>
  <message>
   <source>Fixed regions</source>
   <translation>Feste Regionen</translation>
  </message>
  <message>
   <source>Fixed regions are drawn in this colour</source>
   <translation>Feste Regionen werden in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>Handles</source>
   <translation>Griffe</translation>
  </message>
  <message>
   <source>Handles are drawn in this colour</source>
   <translation>Griffe werden in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>Form features</source>
   <translation>Formelemente</translation>
  </message>
  <message>
   <source>Form features are drawn in this colour</source>
   <translation>Formelemente werden in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>Followers</source>
   <translation>Folgeregionen</translation>
  </message>
  <message>
   <source>Followers are drawn in this colour</source>
   <translation>Folgeregionen werden in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>First side of contacts</source>
   <translation>Erste Seite von Kontakten</translation>
  </message>
  <message>
   <source>The first side of contacts is drawn in this colour</source>
   <translation>Die erste Seite von Kontakten wird in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>Second side of contacts</source>
   <translation>Zweite Seite von Kontakten</translation>
  </message>
  <message>
   <source>The second side of contacts is drawn in this colour</source>
   <translation>Die zweite Seite von Kontakten wird in dieser Farbe gezeichnet</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_prepare</name>
  <message>
   <source>Prepare Mesh</source>
   <translation>Netz vorbereiten</translation>
  </message>
  <message>
   <source>Preview</source>
   <translation>Vorschau</translation>
  </message>
  <message>
   <source>Findings</source>
   <translation>Befund</translation>
  </message>
  <message>
   <source>Repairs</source>
   <translation>Reparaturen</translation>
  </message>
  <message>
   <source>Unit of coordinates</source>
   <translation>Einheit der Koordinaten</translation>
  </message>
  <message>
   <source>Converts the coordinates from this unit to mm</source>
   <translation>Rechnet die Koordinaten aus dieser Einheit in mm um</translation>
  </message>
  <message>
   <source>The unit of the file</source>
   <translation>Die Einheit der Datei</translation>
  </message>
  <message>
   <source>Merge vertices within</source>
   <translation>Knoten zusammenführen innerhalb</translation>
  </message>
  <message>
   <source>Closes cuts and T-junctions, removes duplicate facets and reorients facets that face the wrong way</source>
   <translation>Schließt Schnitte und T-Stöße, entfernt doppelte Facetten und richtet verkehrte Facetten neu aus</translation>
  </message>
  <message>
   <source>Vertices closer than this are merged</source>
   <translation>Knoten mit kleinerem Abstand werden zusammengeführt</translation>
  </message>
  <message>
   <source>Remesh with edges of</source>
   <translation>Neu vernetzen mit Kanten von</translation>
  </message>
  <message>
   <source>Creates well-shaped triangles on the present facets. Flat faces stay exact; edges are shorter at holes and bends</source>
   <translation>Erzeugt wohlgeformte Dreiecke auf den vorhandenen Facetten. Ebene Flächen bleiben exakt; an Löchern und Biegungen sind die Kanten kürzer</translation>
  </message>
  <message>
   <source>Edge length on flat faces</source>
   <translation>Kantenlänge auf ebenen Flächen</translation>
  </message>
  <message>
   <source>Round rims</source>
   <translation>Runde Ränder</translation>
  </message>
  <message>
   <source>How the rims of round holes are remeshed</source>
   <translation>Wie die Ränder runder Löcher neu vernetzt werden</translation>
  </message>
  <message>
   <source>keep polygon</source>
   <translation>Vieleck behalten</translation>
  </message>
  <message>
   <source>fit to circle</source>
   <translation>an Kreis anpassen</translation>
  </message>
  <message>
   <source>Bend as one sheet (thin solid)</source>
   <translation>Als ein Blech biegen (dünner Körper)</translation>
  </message>
  <message>
   <source>Both skins follow one sheet and keep their distance, if the part is recognised as a thin solid</source>
   <translation>Beide Häute folgen einem Blech und behalten ihren Abstand, wenn das Teil als dünner Körper erkannt wird</translation>
  </message>
  <message>
   <source>Split into pieces</source>
   <translation>In Stücke aufteilen</translation>
  </message>
  <message>
   <source>Turns each unconnected piece into a part of its own, so that contacts can join them. Possible while nothing is marked on the part</source>
   <translation>Macht jedes nicht verbundene Stück zu einem eigenen Teil, damit Kontakte sie verbinden können. Möglich, solange auf dem Teil nichts markiert ist</translation>
  </message>
  <message>
   <source>Shows the new mesh in the 3D view without changing the part</source>
   <translation>Zeigt das neue Netz in der 3D-Ansicht, ohne das Teil zu ändern</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_propagation</name>
  <message>
   <source>Propagation</source>
   <translation>Ausbreitung</translation>
  </message>
  <message>
   <source>Local: from part to part along contacts. Single: one control mesh around everything. Whole: all parts in one solve</source>
   <translation>Lokal: von Teil zu Teil entlang der Kontakte. Einzeln: ein Steuernetz um alles. Ganz: alle Teile in einer Rechnung</translation>
  </message>
  <message>
   <source>Local: from contact to contact</source>
   <translation>Lokal: von Kontakt zu Kontakt</translation>
  </message>
  <message>
   <source>Single: one control mesh for all</source>
   <translation>Einzeln: ein Steuernetz für alles</translation>
  </message>
  <message>
   <source>Whole: all parts in one solve</source>
   <translation>Ganz: alle Teile in einer Rechnung</translation>
  </message>
  <message>
   <source>Subdivision</source>
   <translation>Unterteilung</translation>
  </message>
  <message>
   <source>Number of subdivisions of the control meshes. More follow finer bends but take longer; 3 suits most sheets</source>
   <translation>Anzahl der Unterteilungen der Steuernetze. Mehr folgen feineren Biegungen, dauern aber länger; 3 passt für die meisten Bleche</translation>
  </message>
  <message>
   <source>Smoothness</source>
   <translation>Glattheit</translation>
  </message>
  <message>
   <source>Smoothness of the control meshes. Small values follow the driving part closely, large values even out its details</source>
   <translation>Glattheit der Steuernetze. Kleine Werte folgen dem führenden Teil genau, große gleichen seine Einzelheiten aus</translation>
  </message>
  <message>
   <source>Loose pieces</source>
   <translation>Lose Stücke</translation>
  </message>
  <message>
   <source>How unconstrained pieces of a part behave while others move. Stay: at rest, with a warning. Move along: with the nearest constrained piece. Error: the morph fails</source>
   <translation>Wie sich ungehaltene Stücke eines Teils verhalten, während andere sich bewegen. Bleiben: in Ruhe, mit Warnung. Mitgehen: mit dem nächsten gehaltenen Stück. Fehler: der Morph schlägt fehl</translation>
  </message>
  <message>
   <source>stay</source>
   <translation>bleiben</translation>
  </message>
  <message>
   <source>move along</source>
   <translation>mitgehen</translation>
  </message>
  <message>
   <source>error</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Click a row to show the part or contact in the 3D view</source>
   <translation>Klicken Sie auf eine Zeile, um Teil oder Kontakt in der 3D-Ansicht zu zeigen</translation>
  </message>
  <message>
   <source>Part, contact</source>
   <translation>Teil, Kontakt</translation>
  </message>
  <message>
   <source>Type</source>
   <translation>Typ</translation>
  </message>
  <message>
   <source>Gap, mm</source>
   <translation>Spalt, mm</translation>
  </message>
  <message>
   <source>Show control meshes</source>
   <translation>Steuernetze zeigen</translation>
  </message>
  <message>
   <source>Shows the control mesh of the selected contact, or all control meshes, as wireframes</source>
   <translation>Zeigt das Steuernetz des ausgewählten Kontakts, sonst alle Steuernetze, als Drahtgitter</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>Teil</translation>
  </message>
  <message>
   <source>Mode</source>
   <translation>Modus</translation>
  </message>
  <message>
   <source>How the part follows. The handles deform the primary part</source>
   <translation>Wie das Teil folgt. Das Hauptteil wird durch seine Griffe verformt</translation>
  </message>
  <message>
   <source>Set as Primary</source>
   <translation>Zum Hauptteil machen</translation>
  </message>
  <message>
   <source>This part is deformed first, the others follow it</source>
   <translation>Dieses Teil wird zuerst verformt, die anderen folgen ihm</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>Kontakt</translation>
  </message>
  <message>
   <source>How one side follows the other</source>
   <translation>Wie eine Seite der anderen folgt</translation>
  </message>
  <message>
   <source>In use</source>
   <translation>Aktiv</translation>
  </message>
  <message>
   <source>Off: the contact stays in the document but transfers no motion</source>
   <translation>Aus: Der Kontakt bleibt im Dokument, überträgt aber keine Bewegung</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_region</name>
  <message>
   <source>Fixed Region</source>
   <translation>Feste Region</translation>
  </message>
  <message>
   <source>Handle</source>
   <translation>Griff</translation>
  </message>
  <message>
   <source>Form Features</source>
   <translation>Formelemente</translation>
  </message>
  <message>
   <source>Follower</source>
   <translation>Folgeregion</translation>
  </message>
  <message>
   <source>Nothing picked yet</source>
   <translation>Noch nichts gewählt</translation>
  </message>
  <message>
   <source>Skipped vertices that already belong to {0}.</source>
   <translation>Knoten, die bereits zu {0} gehören, wurden übersprungen.</translation>
  </message>
  <message>
   <source>Picked: {0}, 1 piece</source>
   <translation>Gewählt: {0}, 1 Stück</translation>
  </message>
  <message>
   <source>Nothing is picked: click on the part first.</source>
   <translation>Nichts ist gewählt: Klicken Sie zuerst auf das Teil.</translation>
  </message>
  <message>
   <source>Picked: {0}, {1} pieces</source>
   <translation>Gewählt: {0}, {1} Stücke</translation>
  </message>
  <message>
   <source>On {0}</source>
   <translation>Auf {0}</translation>
  </message>
  <message>
   <source>Region</source>
   <translation>Region</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>Teil</translation>
  </message>
  <message>
   <source>Pick</source>
   <translation>Wählen</translation>
  </message>
  <message>
   <source>Nothing picked</source>
   <translation>Nichts gewählt</translation>
  </message>
  <message>
   <source>Each hole is a separate feature</source>
   <translation>Jedes Loch ist ein eigenes Formelement</translation>
  </message>
  <message>
   <source>Separate pieces of the selection become separate form features that move independently</source>
   <translation>Getrennte Stücke der Auswahl werden getrennte Formelemente, die sich unabhängig bewegen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_study</name>
  <message>
   <source>Study</source>
   <translation>Studie</translation>
  </message>
  <message>
   <source>Parameters</source>
   <translation>Parameter</translation>
  </message>
  <message>
   <source>Parameters and their ranges. Double-click a name or a number to edit it</source>
   <translation>Parameter und ihre Bereiche. Doppelklicken Sie auf einen Namen oder eine Zahl, um sie zu bearbeiten</translation>
  </message>
  <message>
   <source>Handle motions, form feature sizes, and the spreadsheet cells that drive them</source>
   <translation>Bewegungen der Griffe, Größen der Formelemente und Zellen der Tabellen, die sie steuern</translation>
  </message>
  <message>
   <source>Adds this number as a parameter</source>
   <translation>Fügt diese Zahl als Parameter hinzu</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <source>Removes the selected parameters</source>
   <translation>Entfernt die ausgewählten Parameter</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Entfernen</translation>
  </message>
  <message>
   <source>Variants</source>
   <translation>Varianten</translation>
  </message>
  <message>
   <source>Sampling</source>
   <translation>Stichprobe</translation>
  </message>
  <message>
   <source>How the values are sampled: three methods that fill the ranges evenly, or a grid of all combinations</source>
   <translation>Wie die Werte gewählt werden: drei Verfahren, die die Bereiche gleichmäßig füllen, oder ein Raster aller Kombinationen</translation>
  </message>
  <message>
   <source>Latin hypercube</source>
   <translation>Latin Hypercube</translation>
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
   <translation>Volles Raster</translation>
  </message>
  <message>
   <source>Count</source>
   <translation>Anzahl</translation>
  </message>
  <message>
   <source>Number of variants; for a full grid, the largest number</source>
   <translation>Anzahl der Varianten; bei einem vollen Raster die Höchstzahl</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Startwert</translation>
  </message>
  <message>
   <source>Another seed gives other values</source>
   <translation>Ein anderer Startwert gibt andere Werte</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>Kriterien</translation>
  </message>
  <message>
   <source>Criteria for every variant, separated by commas: stretch, angle, gap change, edge error, displacement, touching and others, or a parameter. Flipped triangles always fail</source>
   <translation>Kriterien für jede Variante, durch Kommas getrennt: stretch, angle, gap change, edge error, displacement, touching und weitere, oder ein Parameter. Umgeklappte Dreiecke fallen immer durch</translation>
  </message>
  <message>
   <source>such as stretch &lt;= 0.2, angle &gt;= 12</source>
   <translation>etwa stretch &lt;= 0.2, angle &gt;= 12</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Ordner</translation>
  </message>
  <message>
   <source>Folder for the recipe, the study and the files of every variant. A stopped run continues there. Empty: only the table is kept</source>
   <translation>Ordner für Rezept, Studie und die Dateien jeder Variante. Ein angehaltener Lauf geht dort weiter. Leer: Nur die Tabelle bleibt</translation>
  </message>
  <message>
   <source>keep only the table</source>
   <translation>nur die Tabelle behalten</translation>
  </message>
  <message>
   <source>Chooses a folder</source>
   <translation>Wählt einen Ordner</translation>
  </message>
  <message>
   <source>Computes the variants in separate processes; you can go on working in FreeCAD</source>
   <translation>Berechnet die Varianten in eigenen Prozessen; Sie können in FreeCAD weiterarbeiten</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>Starten</translation>
  </message>
  <message>
   <source>Stops the run; the finished variants stay in the table</source>
   <translation>Hält den Lauf an; die fertigen Varianten bleiben in der Tabelle</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Finished variants</source>
   <translation>Fertige Varianten</translation>
  </message>
  <message>
   <source>One row per variant. Point at a state to read why the variant did not pass. Double-click a row to apply the variant</source>
   <translation>Eine Zeile je Variante. Zeigen Sie auf den Status, um zu lesen, warum sie nicht bestanden hat. Doppelklicken Sie auf eine Zeile, um die Variante anzuwenden</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_thickness</name>
  <message>
   <source>Thickness</source>
   <translation>Dicke</translation>
  </message>
  <message>
   <source>Bend as one sheet (thin solid)</source>
   <translation>Als ein Blech biegen (dünner Körper)</translation>
  </message>
  <message>
   <source>Both skins follow one sheet and keep their distance. Off: the closed surface bends as a surface</source>
   <translation>Beide Häute folgen einem Blech und behalten ihren Abstand. Aus: Die geschlossene Oberfläche biegt sich als Fläche</translation>
  </message>
  <message>
   <source>Mark Holes as Form Features</source>
   <translation>Löcher als Formelemente markieren</translation>
  </message>
  <message>
   <source>Turns every hole through both skins into a form feature, which keeps its shape, wall included</source>
   <translation>Macht jedes Loch durch beide Häute zu einem Formelement, das seine Form samt Wand behält</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>&amp;Parts</source>
   <translation>&amp;Teile</translation>
  </message>
  <message>
   <source>&amp;Regions</source>
   <translation>&amp;Regionen</translation>
  </message>
  <message>
   <source>&amp;Features</source>
   <translation>&amp;Formelemente</translation>
  </message>
  <message>
   <source>&amp;Contacts</source>
   <translation>&amp;Kontakte</translation>
  </message>
  <message>
   <source>&amp;Motion</source>
   <translation>&amp;Bewegung</translation>
  </message>
  <message>
   <source>&amp;Exchange</source>
   <translation>A&amp;ustausch</translation>
  </message>
  <message>
   <source>SheetMorph Parts</source>
   <translation>SheetMorph Teile</translation>
  </message>
  <message>
   <source>SheetMorph Regions</source>
   <translation>SheetMorph Regionen</translation>
  </message>
  <message>
   <source>SheetMorph Motion</source>
   <translation>SheetMorph Bewegung</translation>
  </message>
 </context>
</TS>
