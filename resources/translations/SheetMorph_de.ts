<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>SheetMorph_AddPart</name>
  <message>
   <source>Add Part</source>
   <translation>Teil hinzufügen</translation>
  </message>
  <message>
   <source>Adds the selected meshes and shapes to the morph as parts that deform</source>
   <translation>Fügt dem Morph die gewählten Netze und Formen als Teile hinzu, die sich verformen</translation>
  </message>
  <message>
   <source>What is selected has no faces.</source>
   <translation>Das Gewählte hat keine Flächen.</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_BlendPoses</name>
  <message>
   <source>Blend Poses…</source>
   <translation>Stellungen mischen…</translation>
  </message>
  <message>
   <source>Goes from one pose to another with a slider, and compares them</source>
   <translation>Geht mit einem Schieber von einer Stellung zur anderen und vergleicht sie</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Certify</name>
  <message>
   <source>Certificate…</source>
   <translation>Zertifikat…</translation>
  </message>
  <message>
   <source>Writes all deformed parts into a folder, reads them again, measures and judges them</source>
   <translation>Schreibt alle verformten Teile in einen Ordner, liest sie wieder, misst und beurteilt sie</translation>
  </message>
  <message>
   <source>Certificate</source>
   <translation>Zertifikat</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>Kriterien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CheckInstallation</name>
  <message>
   <source>Check Installation</source>
   <translation>Installation prüfen</translation>
  </message>
  <message>
   <source>Shows whether the deformation kernel works, as a report to copy</source>
   <translation>Zeigt als Bericht zum Kopieren, ob der Verformungskern funktioniert</translation>
  </message>
  <message>
   <source>Copy</source>
   <translation>Kopieren</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyAsMeshes</name>
  <message>
   <source>Copy as Meshes</source>
   <translation>Als Netze kopieren</translation>
  </message>
  <message>
   <source>Copies the parts as ordinary meshes, as they are now or in the selected pose</source>
   <translation>Kopiert die Teile als gewöhnliche Netze, wie sie jetzt sind oder in der gewählten Stellung</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CopyInPose</name>
  <message>
   <source>Copy in Pose</source>
   <translation>In Stellung kopieren</translation>
  </message>
  <message>
   <source>Copies the whole morph and puts the copy into the selected pose; the original stays</source>
   <translation>Kopiert den ganzen Morph und bringt die Kopie in die gewählte Stellung; das Original bleibt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_CreateMorph</name>
  <message>
   <source>Create Morph</source>
   <translation>Morph erzeugen</translation>
  </message>
  <message>
   <source>Creates a morph; selected meshes and shapes become its parts and stay as they are</source>
   <translation>Erzeugt einen Morph; gewählte Netze und Formen werden seine Teile und bleiben, wie sie sind</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_DeformedShape</name>
  <message>
   <source>Deformed Shape</source>
   <translation>Verformte Form</translation>
  </message>
  <message>
   <source>Makes a shape of the selected part, deformed, with the faces of the one it was made from</source>
   <translation>Macht aus dem gewählten Teil eine verformte Form mit den Flächen derjenigen, aus der es entstand</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportParts</name>
  <message>
   <source>These files are there already, and SheetMorph did not write them as they are now:</source>
   <translation>Diese Dateien gibt es schon, und SheetMorph hat sie nicht so geschrieben, wie sie jetzt sind:</translation>
  </message>
  <message>
   <source>Write over them?</source>
   <translation>Sollen sie überschrieben werden?</translation>
  </message>
  <message>
   <source>Export Parts…</source>
   <translation>Teile exportieren…</translation>
  </message>
  <message>
   <source>Writes all deformed parts into a folder, each in its own file format</source>
   <translation>Schreibt alle verformten Teile in einen Ordner, jedes in seinem eigenen Dateiformat</translation>
  </message>
  <message>
   <source>Export Parts</source>
   <translation>Teile exportieren</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ExportRecipe</name>
  <message>
   <source>Export Recipe…</source>
   <translation>Rezept exportieren…</translation>
  </message>
  <message>
   <source>Writes the morph as a recipe that also runs without FreeCAD</source>
   <translation>Schreibt den Morph als Rezept, das auch ohne FreeCAD läuft</translation>
  </message>
  <message>
   <source>Export Recipe</source>
   <translation>Rezept exportieren</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FeatureSettings</name>
  <message>
   <source>Form Feature Settings…</source>
   <translation>Formelement einstellen…</translation>
  </message>
  <message>
   <source>Says how the selected form feature turns, what it may do, and which size it has</source>
   <translation>Sagt, wie sich das gewählte Formelement dreht, was es darf und welche Größe es hat</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindContacts</name>
  <message>
   <source>Find Contacts…</source>
   <translation>Kontakte finden…</translation>
  </message>
  <message>
   <source>Finds where parts lie on each other or are bolted; those you accept become contacts</source>
   <translation>Findet, wo Teile aufeinander liegen oder verschraubt sind; was du annimmst, wird Kontakt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FindFeatures</name>
  <message>
   <source>Find Features…</source>
   <translation>Formelemente finden…</translation>
  </message>
  <message>
   <source>Finds holes and other features on all parts; those you accept become form features</source>
   <translation>Findet Löcher und andere Formelemente auf allen Teilen; was du annimmst, wird Formelement</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Flatten</name>
  <message>
   <source>Flatten</source>
   <translation>Abwickeln</translation>
  </message>
  <message>
   <source>Lays the selected part flat, as it is now and at rest: sketches of its blank and bend lines</source>
   <translation>Wickelt das gewählte Teil ab, wie es jetzt ist: eine Skizze seines Zuschnitts mit Biegelinien</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_FollowShape</name>
  <message>
   <source>Follow Shape</source>
   <translation>Form folgen</translation>
  </message>
  <message>
   <source>Meshes the body or shape that the selected part was made from as it is now; what was picked is found again, and what came out different is told and selected</source>
   <translation>Vernetzt den Körper oder die Form, aus der das gewählte Teil gemacht ist, so wie sie jetzt ist; was gewählt war, wird wiedergefunden, und was anders geworden ist, wird gesagt und ausgewählt</translation>
  </message>
  <message>
   <source>“{0}” was {1}. Which one is it now?</source>
   <translation>„{0}“ war {1}. Welches ist es jetzt?</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_GroupFeatures</name>
  <message>
   <source>Group Form Features</source>
   <translation>Formelemente gruppieren</translation>
  </message>
  <message>
   <source>Lets the selected form features of a part move as one body</source>
   <translation>Lässt die gewählten Formelemente eines Teils sich als ein Körper bewegen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Guide</name>
  <message>
   <source>Guide</source>
   <translation>Wegweiser</translation>
  </message>
  <message>
   <source>Leads through a morph step by step: says what is missing and opens what is needed</source>
   <translation>Führt Schritt für Schritt durch einen Morph: sagt, was fehlt, und öffnet, was man braucht</translation>
  </message>
  <message>
   <source>Import a mesh or CAD file, or select meshes in the tree and create a morph.</source>
   <translation>Importiere ein Netz oder eine CAD-Datei, oder wähle Netze im Baum und erzeuge einen Morph.</translation>
  </message>
  <message>
   <source>This document has several morphs: select one of them in the tree.</source>
   <translation>Dieses Dokument hat mehrere Morphs: wähle einen davon im Baum.</translation>
  </message>
  <message>
   <source>The morph has no part yet: import a file or add a mesh.</source>
   <translation>Der Morph hat noch kein Teil: importiere eine Datei oder füge ein Netz hinzu.</translation>
  </message>
  <message>
   <source>Parts: {count}; “{primary}” is deformed first.</source>
   <translation>Teile: {count}; „{primary}“ wird zuerst verformt.</translation>
  </message>
  <message>
   <source>“{source}” was edited: Follow Shape lets “{part}” follow.</source>
   <translation>„{source}“ wurde bearbeitet: „Form folgen“ lässt „{part}“ folgen.</translation>
  </message>
  <message>
   <source>Nothing is held yet: mark what stays where it is.</source>
   <translation>Noch hält nichts: markiere, was bleibt, wo es ist.</translation>
  </message>
  <message>
   <source>Fixed regions: {count}.</source>
   <translation>Feste Regionen: {count}.</translation>
  </message>
  <message>
   <source>No hole keeps its shape yet: find them all, or pick those that matter. Or go on without.</source>
   <translation>Noch behält kein Loch seine Form: finde alle, oder wähle die wichtigen. Oder mach ohne weiter.</translation>
  </message>
  <message>
   <source>Form features that keep their shape exactly: {count}.</source>
   <translation>Formelemente, die ihre Form exakt behalten: {count}.</translation>
  </message>
  <message>
   <source>One part only: there is nothing to connect.</source>
   <translation>Nur ein Teil: es gibt nichts zu verbinden.</translation>
  </message>
  <message>
   <source>One control mesh around everything moves all parts.</source>
   <translation>Ein Steuernetz um alles herum bewegt alle Teile.</translation>
  </message>
  <message>
   <source>Not connected with “{primary}”, so they would not follow: {parts}.</source>
   <translation>Nicht mit „{primary}“ verbunden, sie würden also nicht folgen: {parts}.</translation>
  </message>
  <message>
   <source>Contacts, reaching every part: {count}.</source>
   <translation>Kontakte, die jedes Teil erreichen: {count}.</translation>
  </message>
  <message>
   <source>Nothing can be moved yet: mark what you want to move.</source>
   <translation>Noch lässt sich nichts bewegen: markiere, was du bewegen willst.</translation>
  </message>
  <message>
   <source>Handles: {count}.</source>
   <translation>Griffe: {count}.</translation>
  </message>
  <message>
   <source>Comes when there is a fixed region and a handle.</source>
   <translation>Kommt, wenn es eine feste Region und einen Griff gibt.</translation>
  </message>
  <message>
   <source>Everything is ready: move the handle and watch.</source>
   <translation>Alles ist bereit: bewege den Griff und sieh zu.</translation>
  </message>
  <message>
   <source>Moved. Move on, export the parts, keep this as a pose, or study variants.</source>
   <translation>Bewegt. Bewegen Sie weiter, exportieren Sie die Teile, behalten Sie dies als Pose oder untersuchen Sie Varianten.</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportPart</name>
  <message>
   <source>Mesh CAD Shapes</source>
   <translation>CAD-Formen vernetzen</translation>
  </message>
  <message>
   <source>Longest edge (0 mm: a hundredth of the size)</source>
   <translation>Längste Kante (0 mm: ein Hundertstel der Größe)</translation>
  </message>
  <message>
   <source>“{0}” is no length; type one such as 5 mm.</source>
   <translation>„{0}“ ist keine Länge; geben Sie eine wie 5 mm ein.</translation>
  </message>
  <message>
   <source>Import Part…</source>
   <translation>Teil importieren…</translation>
  </message>
  <message>
   <source>Imports a mesh as a part, with its exact positions, every property of a deck, or every solid of a CAD file, meshed</source>
   <translation>Importiert ein Netz als Teil, mit seinen genauen Koordinaten, jedes Property eines Decks, oder jeden Körper einer CAD-Datei, vernetzt</translation>
  </message>
  <message>
   <source>Import Part</source>
   <translation>Teil importieren</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ImportRecipe</name>
  <message>
   <source>Import Recipe…</source>
   <translation>Rezept importieren…</translation>
  </message>
  <message>
   <source>Creates a morph from a recipe and the mesh files it names</source>
   <translation>Erzeugt einen Morph aus einem Rezept und den Netzdateien, die es nennt</translation>
  </message>
  <message>
   <source>Import Recipe</source>
   <translation>Rezept importieren</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_KeepDistance</name>
  <message>
   <source>Keep Distance</source>
   <translation>Abstand halten</translation>
  </message>
  <message>
   <source>Lets two selected form features, of one part or of two, keep their distance</source>
   <translation>Lässt zwei gewählte Formelemente, eines Teils oder zweier, ihren Abstand behalten</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MakeCoaxial</name>
  <message>
   <source>Make Coaxial</source>
   <translation>Koaxial machen</translation>
  </message>
  <message>
   <source>Lets two selected form features, of one part or of two, keep their common axis</source>
   <translation>Lässt zwei gewählte Formelemente, eines Teils oder zweier, ihre gemeinsame Achse behalten</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Manual</name>
  <message>
   <source>SheetMorph Manual</source>
   <translation>SheetMorph-Handbuch</translation>
  </message>
  <message>
   <source>Opens the manual in the browser, also without a network</source>
   <translation>Öffnet das Handbuch im Browser, auch ohne Netz</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkContact</name>
  <message>
   <source>Mark Contact…</source>
   <translation>Kontakt markieren…</translation>
  </message>
  <message>
   <source>Joins two parts where they touch, so that one follows the other; select both, or click on them in the panel</source>
   <translation>Verbindet zwei Teile, wo sie sich berühren, so dass eines dem anderen folgt; wähle beide, oder klicke sie im Panel an</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFeature</name>
  <message>
   <source>Mark Form Features…</source>
   <translation>Formelemente markieren…</translation>
  </message>
  <message>
   <source>Marks holes and other form features that move but keep their shape</source>
   <translation>Markiert Löcher und andere Formelemente, die sich bewegen, aber ihre Form behalten</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFixed</name>
  <message>
   <source>Mark Fixed Region…</source>
   <translation>Feste Region markieren…</translation>
  </message>
  <message>
   <source>Marks a region that stays where it is, by picking in the 3D view</source>
   <translation>Markiert durch Anklicken in der 3D-Ansicht eine Region, die bleibt, wo sie ist</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkFollower</name>
  <message>
   <source>Mark Follower…</source>
   <translation>Mitläufer markieren…</translation>
  </message>
  <message>
   <source>Marks a region that goes with the control meshes of the part's contacts</source>
   <translation>Markiert eine Region, die mit den Steuernetzen der Kontakte ihres Teils geht</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MarkHandle</name>
  <message>
   <source>Mark Handle…</source>
   <translation>Griff markieren…</translation>
  </message>
  <message>
   <source>Marks a region that is moved and turned as you say; the part follows</source>
   <translation>Markiert eine Region, die bewegt und gedreht wird, wie du es sagst; das Teil folgt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_MoveHandle</name>
  <message>
   <source>Move Handle…</source>
   <translation>Griff bewegen…</translation>
  </message>
  <message>
   <source>Moves and turns a handle; the parts follow while you change the values</source>
   <translation>Bewegt und dreht einen Griff; die Teile folgen, während du die Werte änderst</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_OpenExample</name>
  <message>
   <source>Open Example…</source>
   <translation>Beispiel öffnen…</translation>
  </message>
  <message>
   <source>Opens an example assembly whose regions are marked, ready to move</source>
   <translation>Öffnet eine Beispielbaugruppe, deren Regionen markiert sind, bereit zum Bewegen</translation>
  </message>
  <message>
   <source>Open Example</source>
   <translation>Beispiel öffnen</translation>
  </message>
  <message>
   <source>Example</source>
   <translation>Beispiel</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_PrepareMesh</name>
  <message>
   <source>Prepare Mesh…</source>
   <translation>Netz vorbereiten…</translation>
  </message>
  <message>
   <source>Tells what is wrong with the mesh of the selected part, cures it and meshes it anew</source>
   <translation>Sagt, was am Netz des gewählten Teils nicht stimmt, behebt es und vernetzt neu</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Propagation</name>
  <message>
   <source>Propagation…</source>
   <translation>Ausbreitung…</translation>
  </message>
  <message>
   <source>Shows how the motion goes from the primary part through the contacts to the others</source>
   <translation>Zeigt, wie die Bewegung vom Hauptteil über die Kontakte zu den anderen gelangt</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ReplaceFile</name>
  <message>
   <source>Replace File…</source>
   <translation>Datei ersetzen…</translation>
  </message>
  <message>
   <source>Reads the changed file of the selected part; what was picked on it is found again, and what came out different is told and selected</source>
   <translation>Liest die geänderte Datei des gewählten Teils; was darauf gewählt war, wird wiedergefunden, und was anders ausfiel, wird gesagt und markiert</translation>
  </message>
  <message>
   <source>Replace File</source>
   <translation>Datei ersetzen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ResetMotion</name>
  <message>
   <source>Reset Motion</source>
   <translation>Bewegung zurücksetzen</translation>
  </message>
  <message>
   <source>Puts the selected handles, else all handles of the morph, back to rest</source>
   <translation>Bringt die gewählten Griffe, sonst alle Griffe des Morphs, in Ruhelage</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SavePose</name>
  <message>
   <source>Save Pose…</source>
   <translation>Stellung speichern…</translation>
  </message>
  <message>
   <source>Keeps where all handles are now, under a name to come back to</source>
   <translation>Behält, wo alle Griffe jetzt sind, unter einem Namen, um zurückzukommen</translation>
  </message>
  <message>
   <source>Save Pose</source>
   <translation>Pose speichern</translation>
  </message>
  <message>
   <source>Name of the pose</source>
   <translation>Name der Pose</translation>
  </message>
  <message>
   <source>Pose {0}</source>
   <translation>Pose {0}</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_SetPrimary</name>
  <message>
   <source>Set as Primary</source>
   <translation>Zum Hauptteil machen</translation>
  </message>
  <message>
   <source>Makes the selected part the primary: it is deformed first, the others follow it</source>
   <translation>Macht das gewählte Teil zum Hauptteil: es wird zuerst verformt, die anderen folgen ihm</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_Study</name>
  <message>
   <source>Study…</source>
   <translation>Studie…</translation>
  </message>
  <message>
   <source>Computes many variants in the background, each certified, and shows them in a table</source>
   <translation>Rechnet im Hintergrund viele Varianten, jede geprüft, und zeigt sie in einer Tabelle</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_ThicknessMap</name>
  <message>
   <source>Thickness…</source>
   <translation>Dicke…</translation>
  </message>
  <message>
   <source>Shows in colours how thick the selected part is, and lets it bend as one sheet</source>
   <translation>Zeigt in Farben, wie dick das gewählte Teil ist, und lässt es sich als ein Blech biegen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_actions</name>
  <message>
   <source>This is a mistake of the program ({0}). Please report it.</source>
   <translation>Das ist ein Fehler des Programms ({0}). Bitte melden Sie ihn.</translation>
  </message>
  <message>
   <source>Cancelled; nothing was changed.</source>
   <translation>Abgebrochen; nichts wurde geändert.</translation>
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
   <source>The part on this side; or click on it in the 3D view</source>
   <translation>Das Teil auf dieser Seite; oder klicke es in der 3D-Ansicht an</translation>
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
   <translation>In Gebrauch</translation>
  </message>
  <message>
   <source>Off: the contact is kept but moves nothing, as if the weld were open</source>
   <translation>Aus: der Kontakt bleibt erhalten, bewegt aber nichts, als wäre die Schweißnaht offen</translation>
  </message>
  <message>
   <source>Vertices</source>
   <translation>Vertices</translation>
  </message>
  <message>
   <source>Which vertices of both parts are joined</source>
   <translation>Welche Vertices beider Teile verbunden sind</translation>
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
   <translation>Spaltabstand: Vertices innerhalb dieses Abstands vom anderen Teil gehören zum Kontakt</translation>
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
   <source>What decides how the form feature turns</source>
   <translation>Was entscheidet, wie sich das Formelement dreht</translation>
  </message>
  <message>
   <source>Free: the sheet turns it</source>
   <translation>Frei: das Blech dreht es</translation>
  </message>
  <message>
   <source>Interpolated: as the handles turn</source>
   <translation>Interpoliert: wie sich die Griffe drehen</translation>
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
   <source>Angle of the rotation, any number of turns</source>
   <translation>Drehwinkel, beliebig viele Umdrehungen</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>Bewegung</translation>
  </message>
  <message>
   <source>What the form feature may do</source>
   <translation>Was das Formelement darf</translation>
  </message>
  <message>
   <source>Free</source>
   <translation>Frei</translation>
  </message>
  <message>
   <source>Fixed: stays where it is</source>
   <translation>Fest: bleibt, wo es ist</translation>
  </message>
  <message>
   <source>Translation: never turns</source>
   <translation>Verschiebung: dreht sich nie</translation>
  </message>
  <message>
   <source>Plane: shifts in a plane</source>
   <translation>Ebene: verschiebt sich in einer Ebene</translation>
  </message>
  <message>
   <source>Line: shifts along a line</source>
   <translation>Gerade: verschiebt sich entlang einer Geraden</translation>
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
   <source>Gives the hole, slot or cylinder a size of its own; the sheet around follows</source>
   <translation>Gibt dem Loch, Langloch oder Zylinder eine eigene Größe; das Blech darum folgt</translation>
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
   <source>What the form feature keeps with the others that are ticked</source>
   <translation>Was das Formelement mit den anderen angehakten einhält</translation>
  </message>
  <message>
   <source>None to add</source>
   <translation>Keine hinzufügen</translation>
  </message>
  <message>
   <source>Group: moves as one body with…</source>
   <translation>Gruppe: bewegt sich als ein Körper mit…</translation>
  </message>
  <message>
   <source>Coaxial: keeps its axis with…</source>
   <translation>Koaxial: behält seine Achse mit…</translation>
  </message>
  <message>
   <source>Distance: keeps its distance to…</source>
   <translation>Abstand: behält seinen Abstand zu…</translation>
  </message>
  <message>
   <source>The form features it is related to</source>
   <translation>Die Formelemente, mit denen es in Beziehung steht</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_find</name>
  <message>
   <source>Find Features</source>
   <translation>Formelemente finden</translation>
  </message>
  <message>
   <source>Find Contacts</source>
   <translation>Kontakte finden</translation>
  </message>
  <message>
   <source>Size: diameter or length. Quality: how far the rim is off its form.</source>
   <translation>Größe: Durchmesser oder Länge. Güte: wie weit der Rand von seiner Form abweicht.</translation>
  </message>
  <message>
   <source>Size: of the place. Gap: between the parts, measured in the middle.</source>
   <translation>Größe: der Stelle. Spalt: zwischen den Teilen, in der Mitte gemessen.</translation>
  </message>
  <message>
   <source>Find</source>
   <translation>Finden</translation>
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
   <source>Shows one kind only; what is not shown is not taken</source>
   <translation>Zeigt nur eine Art; was nicht gezeigt wird, wird nicht genommen</translation>
  </message>
  <message>
   <source>From</source>
   <translation>Von</translation>
  </message>
  <message>
   <source>Hides what is smaller; what is hidden is not taken</source>
   <translation>Verbirgt, was kleiner ist; was verborgen ist, wird nicht genommen</translation>
  </message>
  <message>
   <source>to</source>
   <translation>bis</translation>
  </message>
  <message>
   <source>Hides what is larger; what is hidden is not taken</source>
   <translation>Verbirgt, was größer ist; was verborgen ist, wird nicht genommen</translation>
  </message>
  <message>
   <source>any size</source>
   <translation>jede Größe</translation>
  </message>
  <message>
   <source>What was found; what is checked is taken. What the mouse is over lights up in the view</source>
   <translation>Was gefunden wurde; Angehaktes wird genommen. Worüber die Maus steht, leuchtet in der Ansicht auf</translation>
  </message>
  <message>
   <source>Checks everything that is shown</source>
   <translation>Hakt alles an, was gezeigt wird</translation>
  </message>
  <message>
   <source>All</source>
   <translation>Alle</translation>
  </message>
  <message>
   <source>Unchecks everything</source>
   <translation>Nimmt alle Haken weg</translation>
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
   <source>Rim off a circle, up to</source>
   <translation>Rand neben einem Kreis, bis</translation>
  </message>
  <message>
   <source>Largest distance of a rim vertex from the circle, of its radius</source>
   <translation>Größter Abstand eines Randvertex vom Kreis, bezogen auf dessen Radius</translation>
  </message>
  <message>
   <source>An edge bends more than</source>
   <translation>Eine Kante knickt mehr als</translation>
  </message>
  <message>
   <source>Where the surface bends more than this it has an edge</source>
   <translation>Wo die Fläche mehr als dies knickt, hat sie eine Kante</translation>
  </message>
  <message>
   <source>Washer rings</source>
   <translation>Unterlegringe</translation>
  </message>
  <message>
   <source>Rings of triangles around a hole that keep their form with it</source>
   <translation>Ringe von Dreiecken um ein Loch, die mit ihm ihre Form behalten</translation>
  </message>
  <message>
   <source>All kinds, surfaces and beads too</source>
   <translation>Alle Arten, auch Flächen und Sicken</translation>
  </message>
  <message>
   <source>Proposes planes, cylinders, flanges and beads as well</source>
   <translation>Schlägt auch Ebenen, Zylinder, Flansche und Sicken vor</translation>
  </message>
  <message>
   <source>Largest gap</source>
   <translation>Größter Abstand</translation>
  </message>
  <message>
   <source>Parts farther apart are not in contact; 0: as is proposed for these parts</source>
   <translation>Teile mit größerem Abstand sind nicht in Kontakt; 0: wie für diese Teile vorgeschlagen</translation>
  </message>
  <message>
   <source>as proposed</source>
   <translation>wie vorgeschlagen</translation>
  </message>
  <message>
   <source>Surfaces face within</source>
   <translation>Flächen stehen sich gegenüber bis</translation>
  </message>
  <message>
   <source>Largest angle between two surfaces in contact</source>
   <translation>Größter Winkel zwischen zwei Flächen in Kontakt</translation>
  </message>
  <message>
   <source>One contact for two parts</source>
   <translation>Ein Kontakt für zwei Teile</translation>
  </message>
  <message>
   <source>Joins all places in which two parts touch into one contact</source>
   <translation>Fasst alle Stellen, an denen sich zwei Teile berühren, zu einem Kontakt zusammen</translation>
  </message>
  <message>
   <source>Searches anew with these tolerances</source>
   <translation>Sucht neu mit diesen Toleranzen</translation>
  </message>
  <message>
   <source>Search Again</source>
   <translation>Neu suchen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_guide</name>
  <message>
   <source>Guide</source>
   <translation>Wegweiser</translation>
  </message>
  <message>
   <source>The morph that the guide speaks of: the selected one, or the only one</source>
   <translation>Der Morph, von dem der Wegweiser spricht: der gewählte, oder der einzige</translation>
  </message>
  <message>
   <source>1  Parts</source>
   <translation>1  Teile</translation>
  </message>
  <message>
   <source>2  What stays</source>
   <translation>2  Was bleibt</translation>
  </message>
  <message>
   <source>3  What keeps its shape</source>
   <translation>3  Was seine Form behält</translation>
  </message>
  <message>
   <source>4  What is joined</source>
   <translation>4  Was verbunden ist</translation>
  </message>
  <message>
   <source>5  What moves</source>
   <translation>5  Was sich bewegt</translation>
  </message>
  <message>
   <source>6  Move</source>
   <translation>6  Bewegen</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_menus</name>
  <message>
   <source>Do Not Use Contact</source>
   <translation>Kontakt nicht verwenden</translation>
  </message>
  <message>
   <source>Use Contact</source>
   <translation>Kontakt verwenden</translation>
  </message>
  <message>
   <source>Show What Is Wrong</source>
   <translation>Zeigen, was nicht stimmt</translation>
  </message>
  <message>
   <source>Propagation…</source>
   <translation>Ausbreitung…</translation>
  </message>
  <message>
   <source>Edit Contact…</source>
   <translation>Kontakt bearbeiten…</translation>
  </message>
  <message>
   <source>Set as Primary</source>
   <translation>Zum Hauptteil machen</translation>
  </message>
  <message>
   <source>Follow Shape</source>
   <translation>Form folgen</translation>
  </message>
  <message>
   <source>Study…</source>
   <translation>Studie…</translation>
  </message>
  <message>
   <source>Edit Region…</source>
   <translation>Region bearbeiten…</translation>
  </message>
  <message>
   <source>Move Handle…</source>
   <translation>Griff bewegen…</translation>
  </message>
  <message>
   <source>Reset Motion</source>
   <translation>Bewegung zurücksetzen</translation>
  </message>
  <message>
   <source>Form Feature Settings…</source>
   <translation>Formelement einstellen…</translation>
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
   <source>The handle that is moved</source>
   <translation>Der Griff, der bewegt wird</translation>
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
   <source>Translation along the global X axis</source>
   <translation>Verschiebung entlang der globalen x-Achse</translation>
  </message>
  <message>
   <source>Y</source>
   <translation>Y</translation>
  </message>
  <message>
   <source>Translation along the global Y axis</source>
   <translation>Verschiebung entlang der globalen y-Achse</translation>
  </message>
  <message>
   <source>Z</source>
   <translation>Z</translation>
  </message>
  <message>
   <source>Translation along the global Z axis</source>
   <translation>Verschiebung entlang der globalen z-Achse</translation>
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
   <source>How far the value that was changed last may go: red beyond, where something breaks. The mark is where it is</source>
   <translation>Wie weit der zuletzt geänderte Wert gehen darf: rot, wo etwas nicht mehr hält. Die Marke steht, wo er ist</translation>
  </message>
  <message>
   <source>Pivot</source>
   <translation>Drehpunkt</translation>
  </message>
  <message>
   <source>X of the point that the handle turns about</source>
   <translation>X des Punkts, um den sich der Griff dreht</translation>
  </message>
  <message>
   <source>Y of the point that the handle turns about</source>
   <translation>Y des Punkts, um den sich der Griff dreht</translation>
  </message>
  <message>
   <source>Z of the point that the handle turns about</source>
   <translation>Z des Punkts, um den sich der Griff dreht</translation>
  </message>
  <message>
   <source>Centre of Handle</source>
   <translation>Mitte des Griffs</translation>
  </message>
  <message>
   <source>Turns about the centre of the handle's vertices</source>
   <translation>Dreht um die Mitte der Vertices des Griffs</translation>
  </message>
  <message>
   <source>Move</source>
   <translation>Verschieben</translation>
  </message>
  <message>
   <source>The arrows move the pivot; the shape stays as it is</source>
   <translation>Die Pfeile verschieben den Drehpunkt; die Form bleibt, wie sie ist</translation>
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
   <source>Shows arrows and arcs in the 3D view that drag the handle</source>
   <translation>Zeigt in der 3D-Ansicht Pfeile und Bögen, die den Griff ziehen</translation>
  </message>
  <message>
   <source>Drag points</source>
   <translation>Punkte ziehen</translation>
  </message>
  <message>
   <source>Drags the point under the mouse in the plane of the view; the sheet decides how it turns. A point that is in no handle becomes one</source>
   <translation>Zieht den Punkt unter der Maus in der Bildebene; das Blech entscheidet, wie er sich dreht. Ein Punkt, der in keinem Griff ist, wird einer</translation>
  </message>
  <message>
   <source>Snap to</source>
   <translation>Einrasten auf</translation>
  </message>
  <message>
   <source>Drags the arrows in steps</source>
   <translation>Zieht die Pfeile in Schritten</translation>
  </message>
  <message>
   <source>Steps of a translation</source>
   <translation>Schritte einer Verschiebung</translation>
  </message>
  <message>
   <source>Steps of a rotation</source>
   <translation>Schritte einer Drehung</translation>
  </message>
  <message>
   <source>Show</source>
   <translation>Zeigen</translation>
  </message>
  <message>
   <source>Original</source>
   <translation>Original</translation>
  </message>
  <message>
   <source>Shows the shape at rest as a ghost</source>
   <translation>Zeigt die Form in Ruhe als Geist</translation>
  </message>
  <message>
   <source>Form features</source>
   <translation>Formelemente</translation>
  </message>
  <message>
   <source>Shows how far every form feature moves and turns</source>
   <translation>Zeigt, wie weit sich jedes Formelement verschiebt und dreht</translation>
  </message>
  <message>
   <source>Control meshes</source>
   <translation>Steuernetze</translation>
  </message>
  <message>
   <source>Shows the control meshes of contacts as wires that move along</source>
   <translation>Zeigt die Steuernetze der Kontakte als Drahtgitter, die sich mitbewegen</translation>
  </message>
  <message>
   <source>Colours</source>
   <translation>Farben</translation>
  </message>
  <message>
   <source>What the colours of the parts say</source>
   <translation>Was die Farben der Teile sagen</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>Displacement</source>
   <translation>Verschiebungsweg</translation>
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
   <source>Elements by quality: bars as it is, grey lines as it was at rest, red where the limit is</source>
   <translation>Elemente nach Qualität: Balken wie sie ist, graue Linien wie in Ruhe, rot die Grenze</translation>
  </message>
  <message>
   <source>Reset</source>
   <translation>Zurücksetzen</translation>
  </message>
  <message>
   <source>Puts this handle back to rest</source>
   <translation>Bringt diesen Griff in Ruhelage</translation>
  </message>
  <message>
   <source>Update results</source>
   <translation>Ergebnisse nachführen</translation>
  </message>
  <message>
   <source>When the result objects follow; the 3D view always follows at once</source>
   <translation>Wann die Ergebnisobjekte folgen; die 3D-Ansicht folgt immer sofort</translation>
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
   <translation>In Pausen</translation>
  </message>
  <message>
   <source>On OK</source>
   <translation>Bei OK</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_panels</name>
  <message>
   <source>The shape of {0} failed</source>
   <translation>Die Form von {0} ist fehlgeschlagen</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stops computing; a recompute of the document computes the shape.</source>
   <translation>Hält die Berechnung an; Neuberechnen des Dokuments berechnet die Form.</translation>
  </message>
  <message>
   <source>Computing the final shape of {0}</source>
   <translation>Die endgültige Form von {0} wird berechnet</translation>
  </message>
  <message>
   <source>This shape failed for an unknown reason ({0}). Please report it.</source>
   <translation>Diese Form konnte aus unbekanntem Grund nicht berechnet werden ({0}). Bitte melden Sie das.</translation>
  </message>
  <message>
   <source>There is not enough memory for this shape. Close other documents, or mesh it coarser.</source>
   <translation>Der Speicher reicht für diese Form nicht. Schließen Sie andere Dokumente, oder vernetzen Sie gröber.</translation>
  </message>
  <message>
   <source>There is nothing to show: no contact is in use.</source>
   <translation>Es gibt nichts zu zeigen: kein Kontakt ist in Gebrauch.</translation>
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
   <translation>„{0}“ nicht verwenden</translation>
  </message>
  <message>
   <source>Take out of “{0}”</source>
   <translation>Aus „{0}“ herausnehmen</translation>
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
   <translation>Mitläufer</translation>
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
   <source>The parts are farther apart than that: give a larger gap distance, or pick by hand.</source>
   <translation>Die Teile liegen weiter auseinander: gib einen größeren Abstand an oder wähle von Hand.</translation>
  </message>
  <message>
   <source>Choose two parts: click on one, then on the other.</source>
   <translation>Wähle zwei Teile: klicke auf das eine, dann auf das andere.</translation>
  </message>
  <message>
   <source>A side is empty: pick at least one vertex on each part.</source>
   <translation>Eine Seite ist leer: wähle auf jedem Teil mindestens einen Knoten.</translation>
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
   <translation>Gebunden</translation>
  </message>
  <message>
   <source>Rigid</source>
   <translation>Starr</translation>
  </message>
  <message>
   <source>The other part bends along smoothly. Right for most flanges and weld seams.</source>
   <translation>Das andere Teil biegt sich weich mit. Richtig für die meisten Flansche und Schweißnähte.</translation>
  </message>
  <message>
   <source>Every vertex keeps its place over the facing triangle. For glued faces and mesh ties.</source>
   <translation>Jeder Vertex behält seinen Platz über dem gegenüberliegenden Dreieck. Für Klebeflächen und Netzkopplungen.</translation>
  </message>
  <message>
   <source>Both sides move as one stiff body. For bolts, rivets and spot welds.</source>
   <translation>Beide Seiten bewegen sich als ein starrer Körper. Für Schrauben, Niete und Schweißpunkte.</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>1 Whole part</source>
   <translation>1 Ganzes Teil</translation>
  </message>
  <message>
   <source>2 Contacts lead</source>
   <translation>2 Kontakte führen</translation>
  </message>
  <message>
   <source>3 Contacts and edges lead</source>
   <translation>3 Kontakte und Ränder führen</translation>
  </message>
  <message>
   <source>SheetMorph chooses by contacts and form features.</source>
   <translation>SheetMorph wählt nach Kontakten und Formelementen.</translation>
  </message>
  <message>
   <source>The control mesh moves every vertex; form features would lose their shape.</source>
   <translation>Das Steuernetz bewegt jeden Vertex; Formelemente würden ihre Form verlieren.</translation>
  </message>
  <message>
   <source>Contacts and followers go with the control mesh, the rest bends like sheet; form features keep their shape.</source>
   <translation>Kontakte und Mitläufer gehen mit dem Steuernetz, der Rest biegt sich wie Blech; Formelemente behalten ihre Form.</translation>
  </message>
  <message>
   <source>As 2, and free edges inside the control mesh go with it too.</source>
   <translation>Wie 2, und freie Ränder im Steuernetz gehen auch mit.</translation>
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
   <source>No hole, slot or cylinder: it has no size to set.</source>
   <translation>Weder Loch noch Langloch noch Zylinder: es hat keine einstellbare Größe.</translation>
  </message>
  <message>
   <source>Tick the form features it is related to, or choose no relation.</source>
   <translation>Hake die Formelemente an, zu denen die Beziehung besteht, oder wähle keine.</translation>
  </message>
  <message>
   <source>A pair has two form features; tick one.</source>
   <translation>Ein Paar hat zwei Formelemente; hake eines an.</translation>
  </message>
  <message>
   <source>all kinds</source>
   <translation>alle Arten</translation>
  </message>
  <message>
   <source>{0} of {1} chosen</source>
   <translation>{0} von {1} gewählt</translation>
  </message>
  <message>
   <source>{0} of {1} chosen, {2} in the document already</source>
   <translation>{0} von {1} gewählt, {2} schon im Dokument</translation>
  </message>
  <message>
   <source>{0} not certain (?): point at them to read why</source>
   <translation>{0} nicht sicher (?): darauf zeigen, um zu lesen, warum</translation>
  </message>
  <message>
   <source>Nothing is checked; check proposals, or cancel.</source>
   <translation>Nichts ist angehakt; hake Vorschläge an oder brich ab.</translation>
  </message>
  <message>
   <source>of the selected parts only</source>
   <translation>nur von den gewählten Teilen</translation>
  </message>
  <message>
   <source>Driven by the expression {0}</source>
   <translation>Gesteuert vom Ausdruck {0}</translation>
  </message>
  <message>
   <source>Computed in {0:.1f} ms, drawn in {1:.1f} ms</source>
   <translation>Berechnet in {0:.1f} ms, gezeichnet in {1:.1f} ms</translation>
  </message>
  <message>
   <source>Will not follow, no contact leads there: {0}</source>
   <translation>Folgt nicht, kein Kontakt führt dorthin: {0}</translation>
  </message>
  <message>
   <source>Linear preview: steel follows when you rest. {0}</source>
   <translation>Lineare Vorschau: Stahl folgt, wenn du innehältst. {0}</translation>
  </message>
  <message>
   <source>Linear preview, the exact shape follows ({0})</source>
   <translation>Lineare Vorschau, die genaue Form folgt ({0})</translation>
  </message>
  <message>
   <source>Nothing has moved yet.</source>
   <translation>Noch ist nichts bewegt.</translation>
  </message>
  <message>
   <source>{0} contacts open too far, see Propagation; the first:</source>
   <translation>{0} Kontakte öffnen sich zu weit, siehe Ausbreitung; der erste:</translation>
  </message>
  <message>
   <source>Preview: refined on release. {0}</source>
   <translation>Vorschau: wird beim Loslassen verfeinert. {0}</translation>
  </message>
  <message>
   <source>Steel, final. {0}</source>
   <translation>Stahl, endgültig. {0}</translation>
  </message>
  <message>
   <source>At rest</source>
   <translation>In Ruhe</translation>
  </message>
  <message>
   <source>As it was before; move the slider to blend again.</source>
   <translation>Wie zuvor; zum Überblenden den Regler bewegen.</translation>
  </message>
  <message>
   <source>Largest and mean distance, mm</source>
   <translation>Größter und mittlerer Abstand, mm</translation>
  </message>
  <message>
   <source>Choose a pose.</source>
   <translation>Wähle eine Stellung.</translation>
  </message>
  <message>
   <source>and {0} more parts</source>
   <translation>und {0} weitere Teile</translation>
  </message>
  <message>
   <source>Make a part of each of its {} pieces</source>
   <translation>Ein Teil aus jedem seiner {} Stücke machen</translation>
  </message>
  <message>
   <source>Weld within how much? Type a length, for example 0.01 mm.</source>
   <translation>Verschweißen innerhalb welcher Länge? Gib eine an, zum Beispiel 0.01 mm.</translation>
  </message>
  <message>
   <source>Nothing is chosen; choose a cure, or cancel.</source>
   <translation>Nichts ist gewählt; wähle eine Abhilfe oder brich ab.</translation>
  </message>
  <message>
   <source>Choose a cure first.</source>
   <translation>Wähle zuerst eine Abhilfe.</translation>
  </message>
  <message>
   <source>The parts follow in the background…</source>
   <translation>Die Teile folgen im Hintergrund …</translation>
  </message>
  <message>
   <source>Mark a fixed region and a handle first.</source>
   <translation>Markiere zuerst eine feste Region und einen Griff.</translation>
  </message>
  <message>
   <source>How much the gap between both sides has changed, at most</source>
   <translation>Um wie viel sich der Spalt zwischen beiden Seiten höchstens geändert hat</translation>
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
   <translation>nicht in Gebrauch</translation>
  </message>
  <message>
   <source>level {0}</source>
   <translation>Stufe {0}</translation>
  </message>
  <message>
   <source>Change a value to see how far it may go.</source>
   <translation>Ändern Sie einen Wert, um zu sehen, wie weit er gehen darf.</translation>
  </message>
  <message>
   <source>a triangle turns over</source>
   <translation>ein Dreieck klappt um</translation>
  </message>
  <message>
   <source>The angle</source>
   <translation>Der Winkel</translation>
  </message>
  <message>
   <source>{0}: {1} to {2}{3}</source>
   <translation>{0}: {1} bis {2}{3}</translation>
  </message>
  <message>
   <source>{0}; beyond: {1}</source>
   <translation>{0}; dahinter: {1}</translation>
  </message>
  <message>
   <source>{0}, as far as was looked</source>
   <translation>{0}, soweit gesucht wurde</translation>
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
   <source>; {0} of {1} elements beyond {2:g}</source>
   <translation>; {0} von {1} Elementen jenseits {2:g}</translation>
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
   <source>{0}. A double click takes the morph there.</source>
   <translation>{0}. Ein Doppelklick bringt den Morph dorthin.</translation>
  </message>
  <message>
   <source>Wait for the variants, or stop them.</source>
   <translation>Warten Sie auf die Varianten oder halten Sie an.</translation>
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
   <source>Changes</source>
   <translation>Ändert</translation>
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
   <source>passed</source>
   <translation>bestanden</translation>
  </message>
  <message>
   <source>failed</source>
   <translation>durchgefallen</translation>
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
   <translation>Zustand</translation>
  </message>
  <message>
   <source>“{0}” of “{1}” is no number.</source>
   <translation>„{0}“ von „{1}“ ist keine Zahl.</translation>
  </message>
  <message>
   <source>'{0}' is no thin solid: {1}.</source>
   <translation>„{0}“ ist kein dünner Körper: {1}.</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_picking</name>
  <message>
   <source>Click picks, Shift adds, Ctrl removes.</source>
   <translation>Klick wählt, Umschalt fügt hinzu, Strg nimmt weg.</translation>
  </message>
  <message>
   <source>Paint with the left button. The wheel changes the size, Ctrl+wheel zooms. Ctrl+paint removes.</source>
   <translation>Male mit der linken Taste. Das Rad ändert die Größe, Strg+Rad zoomt. Strg+Malen nimmt weg.</translation>
  </message>
  <message>
   <source>Drag from corner to corner. Shift adds, Ctrl removes.</source>
   <translation>Ziehe von Ecke zu Ecke. Umschalt fügt hinzu, Strg nimmt weg.</translation>
  </message>
  <message>
   <source>Draw around it with the left button held. Shift adds, Ctrl removes.</source>
   <translation>Umfahre es mit gedrückter linker Taste. Umschalt fügt hinzu, Strg nimmt weg.</translation>
  </message>
  <message>
   <source>Vertex</source>
   <translation>Vertex</translation>
  </message>
  <message>
   <source>Picks single vertices</source>
   <translation>Wählt einzelne Vertices</translation>
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
   <source>Picks the rim of a hole by one click near it</source>
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
   <source>Picks what you paint over; the wheel changes the size of the brush</source>
   <translation>Wählt, worüber du malst; das Rad ändert die Größe des Pinsels</translation>
  </message>
  <message>
   <source>Rectangle</source>
   <translation>Rechteck</translation>
  </message>
  <message>
   <source>Picks what lies in a rectangle that you draw</source>
   <translation>Wählt, was in einem Rechteck liegt, das du aufziehst</translation>
  </message>
  <message>
   <source>Lasso</source>
   <translation>Lasso</translation>
  </message>
  <message>
   <source>Picks what lies in a closed figure that you draw</source>
   <translation>Wählt, was in einer geschlossenen Figur liegt, die du zeichnest</translation>
  </message>
  <message>
   <source>New</source>
   <translation>Neu</translation>
  </message>
  <message>
   <source>A pick starts anew; the brush goes on</source>
   <translation>Eine Auswahl beginnt neu; der Pinsel macht weiter</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Hinzu</translation>
  </message>
  <message>
   <source>A pick adds, as with Shift</source>
   <translation>Ein Klick fügt hinzu, wie mit Umschalt</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Weg</translation>
  </message>
  <message>
   <source>A pick removes, as with Ctrl</source>
   <translation>Ein Klick nimmt weg, wie mit Strg</translation>
  </message>
  <message>
   <source>Crease angle</source>
   <translation>Knickwinkel</translation>
  </message>
  <message>
   <source>A face and a rim end where the surface turns by more than this</source>
   <translation>Fläche und Rand enden, wo die Oberfläche mehr als dies knickt</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>Ringe um Loch</translation>
  </message>
  <message>
   <source>Takes so many rings of vertices around the rim as well</source>
   <translation>Nimmt so viele Ringe von Vertices um den Rand dazu</translation>
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
   <translation>Hindurch wählen</translation>
  </message>
  <message>
   <source>Picks through parts and facets that hide others, as if all were made of glass</source>
   <translation>Wählt durch Teile und Facetten hindurch, die andere verdecken, als wäre alles aus Glas</translation>
  </message>
  <message>
   <source>Grow</source>
   <translation>Wachsen</translation>
  </message>
  <message>
   <source>Adds one ring of neighbouring vertices</source>
   <translation>Fügt einen Ring benachbarter Vertices hinzu</translation>
  </message>
  <message>
   <source>Shrink</source>
   <translation>Schrumpfen</translation>
  </message>
  <message>
   <source>Removes the outermost ring of vertices</source>
   <translation>Nimmt den äußersten Ring von Vertices weg</translation>
  </message>
  <message>
   <source>Invert</source>
   <translation>Umkehren</translation>
  </message>
  <message>
   <source>Picks what is not picked, and nothing else</source>
   <translation>Wählt, was nicht gewählt ist, und nichts sonst</translation>
  </message>
  <message>
   <source>Undo Pick</source>
   <translation>Auswahl zurück</translation>
  </message>
  <message>
   <source>Takes back the last pick</source>
   <translation>Nimmt die letzte Auswahl zurück</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>Leeren</translation>
  </message>
  <message>
   <source>Picks nothing</source>
   <translation>Wählt nichts</translation>
  </message>
  <message>
   <source>All Holes</source>
   <translation>Alle Löcher</translation>
  </message>
  <message>
   <source>Picks the rims of all holes of the part</source>
   <translation>Wählt die Ränder aller Löcher des Teils</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_pose</name>
  <message>
   <source>Blend Poses</source>
   <translation>Stellungen mischen</translation>
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
   <source>How far the morph is on the way from one pose to the other</source>
   <translation>Wie weit der Morph auf dem Weg von einer Stellung zur anderen ist</translation>
  </message>
  <message>
   <source>The same as a number; beyond 0 and 100 % the motion goes on</source>
   <translation>Dasselbe als Zahl; jenseits von 0 und 100 % geht die Bewegung weiter</translation>
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
   <translation>Ergebnisse nachführen</translation>
  </message>
  <message>
   <source>When the result objects follow a motion: the 3D view always does at once. Automatically: at once if that takes less than 50 ms, else on a pause</source>
   <translation>Wann die Ergebnisobjekte einer Bewegung folgen: die 3D-Ansicht folgt immer sofort. Automatisch: sofort, wenn es weniger als 50 ms dauert, sonst in Pausen</translation>
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
   <translation>In Pausen</translation>
  </message>
  <message>
   <source>On OK</source>
   <translation>Bei OK</translation>
  </message>
  <message>
   <source>Shows arrows to drag when the Move Handle panel opens</source>
   <translation>Zeigt Pfeile zum Ziehen, wenn „Griff bewegen“ geöffnet wird</translation>
  </message>
  <message>
   <source>Arrows and arcs in the view</source>
   <translation>Pfeile und Bögen in der Ansicht</translation>
  </message>
  <message>
   <source>Motions by the mouse go in steps</source>
   <translation>Bewegungen mit der Maus gehen in Schritten</translation>
  </message>
  <message>
   <source>Snap to steps</source>
   <translation>Auf Schritte einrasten</translation>
  </message>
  <message>
   <source>Step of a length</source>
   <translation>Schritt einer Länge</translation>
  </message>
  <message>
   <source>Motions by the mouse are multiples of this length when they snap</source>
   <translation>Bewegungen mit der Maus sind beim Einrasten Vielfache dieser Länge</translation>
  </message>
  <message>
   <source>Step of an angle</source>
   <translation>Schritt eines Winkels</translation>
  </message>
  <message>
   <source>Turns by the mouse are multiples of this angle when they snap</source>
   <translation>Drehungen mit der Maus sind beim Einrasten Vielfache dieses Winkels</translation>
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
   <source>A face ends at edges where the sheet turns by more than this angle</source>
   <translation>Eine Fläche endet an Kanten, an denen das Blech mehr als um diesen Winkel knickt</translation>
  </message>
  <message>
   <source>Rings around hole</source>
   <translation>Ringe um Loch</translation>
  </message>
  <message>
   <source>How many rings of vertices around the rim of a hole belong to it</source>
   <translation>Wie viele Ringe von Vertices um den Rand eines Lochs zu ihm gehören</translation>
  </message>
  <message>
   <source>Size of brush</source>
   <translation>Größe des Pinsels</translation>
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
   <translation>Mitläufer</translation>
  </message>
  <message>
   <source>Followers are drawn in this colour</source>
   <translation>Mitläufer werden in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>First side of contacts</source>
   <translation>Erste Seite von Kontakten</translation>
  </message>
  <message>
   <source>First side of contacts is drawn in this colour</source>
   <translation>Die erste Seite von Kontakten wird in dieser Farbe gezeichnet</translation>
  </message>
  <message>
   <source>Second side of contacts</source>
   <translation>Zweite Seite von Kontakten</translation>
  </message>
  <message>
   <source>Second side of contacts is drawn in this colour</source>
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
   <source>What is found</source>
   <translation>Befund</translation>
  </message>
  <message>
   <source>Cures</source>
   <translation>Abhilfe</translation>
  </message>
  <message>
   <source>Coordinates are in</source>
   <translation>Koordinaten sind in</translation>
  </message>
  <message>
   <source>Scales the mesh from another unit to mm</source>
   <translation>Rechnet das Netz aus einer anderen Einheit in mm um</translation>
  </message>
  <message>
   <source>The unit of the file</source>
   <translation>Die Einheit der Datei</translation>
  </message>
  <message>
   <source>Weld vertices within</source>
   <translation>Knoten verschweißen innerhalb</translation>
  </message>
  <message>
   <source>Closes cuts and T-junctions, removes doubled facets, turns facets that face the wrong way</source>
   <translation>Schließt Schnitte und T-Stöße, entfernt doppelte Facetten, wendet verkehrte Facetten</translation>
  </message>
  <message>
   <source>Vertices nearer than this become one</source>
   <translation>Knoten, die näher liegen, werden einer</translation>
  </message>
  <message>
   <source>Mesh anew with edges of</source>
   <translation>Neu vernetzen mit Kanten von</translation>
  </message>
  <message>
   <source>Well-shaped triangles on the facets as they are: flats stay exact, shorter edges at holes and bends</source>
   <translation>Wohlgeformte Dreiecke auf den Facetten, wie sie sind: Ebenes bleibt exakt, kürzere Kanten an Löchern und Biegungen</translation>
  </message>
  <message>
   <source>Length of the edges on flats</source>
   <translation>Länge der Kanten auf ebenen Flächen</translation>
  </message>
  <message>
   <source>Round rims</source>
   <translation>Runde Ränder</translation>
  </message>
  <message>
   <source>What becomes of the rims of round holes</source>
   <translation>Was aus den Rändern runder Löcher wird</translation>
  </message>
  <message>
   <source>keep their polygon</source>
   <translation>behalten ihr Vieleck</translation>
  </message>
  <message>
   <source>go to their circle</source>
   <translation>gehen auf ihren Kreis</translation>
  </message>
  <message>
   <source>Bend as one sheet (thin solid)</source>
   <translation>Als ein Blech biegen (dünner Körper)</translation>
  </message>
  <message>
   <source>Both skins and the walls follow one sheet and keep their distance, if it is recognised as a thin solid</source>
   <translation>Beide Häute und die Wände folgen einem Blech und behalten ihren Abstand, wenn es als dünner Körper erkannt wird</translation>
  </message>
  <message>
   <source>Make a part of each of its pieces</source>
   <translation>Ein Teil aus jedem seiner Stücke machen</translation>
  </message>
  <message>
   <source>What nothing connects becomes a part of its own, so that contacts can join it to the others; only while nothing is marked on it</source>
   <translation>Was nichts verbindet, wird ein eigenes Teil, damit Kontakte es mit den anderen verbinden können; nur solange nichts darauf markiert ist</translation>
  </message>
  <message>
   <source>Shows the new mesh in place of the part; nothing changes</source>
   <translation>Zeigt das neue Netz anstelle des Teils; nichts ändert sich</translation>
  </message>
 </context>
 <context>
  <name>SheetMorph_propagation</name>
  <message>
   <source>Propagation</source>
   <translation>Ausbreitung</translation>
  </message>
  <message>
   <source>Local: from part to part along contacts. Single: one control mesh around everything</source>
   <translation>Lokal: von Teil zu Teil entlang der Kontakte. Einzeln: ein Steuernetz um alles herum</translation>
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
   <source>Levels</source>
   <translation>Stufen</translation>
  </message>
  <message>
   <source>How often control meshes are subdivided: more follows finer bends and takes longer (3 is right for most sheets)</source>
   <translation>Wie oft Steuernetze unterteilt werden: mehr folgt feineren Biegungen und dauert länger (3 passt für die meisten Bleche)</translation>
  </message>
  <message>
   <source>Smoothness</source>
   <translation>Glattheit</translation>
  </message>
  <message>
   <source>How smooth control meshes stay: small follows the source closely, large evens out its details</source>
   <translation>Wie glatt Steuernetze bleiben: klein folgt der Vorlage genau, groß gleicht ihre Einzelheiten aus</translation>
  </message>
  <message>
   <source>Loose pieces</source>
   <translation>Lose Stücke</translation>
  </message>
  <message>
   <source>What becomes of pieces of a part that nothing holds, while others of it move</source>
   <translation>Was aus Stücken eines Teils wird, die nichts hält, während andere sich bewegen</translation>
  </message>
  <message>
   <source>stay at rest, with a warning</source>
   <translation>bleiben in Ruhe, mit einer Warnung</translation>
  </message>
  <message>
   <source>go along with what is nearest</source>
   <translation>gehen mit dem Nächsten mit</translation>
  </message>
  <message>
   <source>are an error</source>
   <translation>sind ein Fehler</translation>
  </message>
  <message>
   <source>A click shows parts and contacts in the 3D view</source>
   <translation>Ein Klick zeigt Teile und Kontakte in der 3D-Ansicht</translation>
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
   <source>Shows the control mesh of the chosen contact, else all of them, as wires</source>
   <translation>Zeigt das Steuernetz des gewählten Kontakts, sonst alle, als Drahtgitter</translation>
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
   <source>How the part follows; the primary is deformed by its handles</source>
   <translation>Wie das Teil folgt; das Hauptteil wird durch seine Griffe verformt</translation>
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
   <translation>In Gebrauch</translation>
  </message>
  <message>
   <source>Off: the contact is kept but moves nothing, as if the weld were open</source>
   <translation>Aus: der Kontakt bleibt erhalten, bewegt aber nichts, als wäre die Schweißnaht offen</translation>
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
   <translation>Mitläufer</translation>
  </message>
  <message>
   <source>Nothing picked yet</source>
   <translation>Noch nichts gewählt</translation>
  </message>
  <message>
   <source>What {0} has already is left out: a vertex has one of them.</source>
   <translation>Was {0} schon hat, bleibt weg: ein Eckpunkt gehört nur einem davon.</translation>
  </message>
  <message>
   <source>Picked: {0}, 1 piece</source>
   <translation>Gewählt: {0}, 1 Stück</translation>
  </message>
  <message>
   <source>Nothing is picked: click on the part first.</source>
   <translation>Nichts ist gewählt: klicke zuerst auf das Teil.</translation>
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
   <source>or type a selector: {"face_at": [x, y, z]}</source>
   <translation>oder einen Selektor eingeben: {"face_at": [x, y, z]}</translation>
  </message>
  <message>
   <source>What is picked, in the words of a recipe and the coordinates of the part's file; type another selector and press Enter</source>
   <translation>Was gewählt ist, in den Worten eines Rezepts und den Koordinaten der Datei des Teils; gib einen anderen Selektor ein und drücke Enter</translation>
  </message>
  <message>
   <source>Each hole is a feature of its own</source>
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
   <source>What changes between which numbers; a double click edits a name or a number</source>
   <translation>Was sich zwischen welchen Zahlen ändert; ein Doppelklick bearbeitet Namen oder Zahl</translation>
  </message>
  <message>
   <source>Motions of handles, sizes of form features, and cells of the spreadsheets that drive them</source>
   <translation>Bewegungen der Griffe, Größen der Formelemente und Zellen der Tabellen, die sie steuern</translation>
  </message>
  <message>
   <source>Lets the study change this number</source>
   <translation>Lässt die Studie diese Zahl ändern</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <source>Takes the selected parameters out</source>
   <translation>Nimmt die ausgewählten Parameter heraus</translation>
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
   <translation>Auswahl</translation>
  </message>
  <message>
   <source>How values are chosen: three ways that fill the ranges evenly, or a grid of all combinations</source>
   <translation>Wie Werte gewählt werden: drei Arten, die Bereiche gleichmäßig zu füllen, oder ein Raster aller Kombinationen</translation>
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
   <source>How many variants; of a full grid at most so many</source>
   <translation>Wie viele Varianten; bei einem vollen Raster höchstens so viele</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Startwert</translation>
  </message>
  <message>
   <source>Another number gives other values</source>
   <translation>Eine andere Zahl gibt andere Werte</translation>
  </message>
  <message>
   <source>Criteria</source>
   <translation>Kriterien</translation>
  </message>
  <message>
   <source>What every variant must keep, commas between: stretch, angle, gap change, edge error, displacement, touching and more, or a parameter. That no triangle turns over is always asked for</source>
   <translation>Was jede Variante einhalten muss, mit Kommas dazwischen: stretch, angle, gap change, edge error, displacement, touching und mehr, oder ein Parameter. Dass kein Dreieck umklappt, wird immer verlangt</translation>
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
   <source>Where recipe, study and the files of every variant are kept; a run that was stopped goes on there. Empty: only the table is kept</source>
   <translation>Wo Rezept, Studie und die Dateien jeder Variante bleiben; ein angehaltener Lauf geht dort weiter. Leer: nur die Tabelle bleibt</translation>
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
   <source>Computes the variants in processes of their own; FreeCAD stays free</source>
   <translation>Rechnet die Varianten in eigenen Prozessen; FreeCAD bleibt frei</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>Starten</translation>
  </message>
  <message>
   <source>Stops; what is done becomes the table</source>
   <translation>Hält an; was fertig ist, wird zur Tabelle</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Variants that are done</source>
   <translation>Fertige Varianten</translation>
  </message>
  <message>
   <source>One row for each variant; point at its state to read why it did not pass. A double click takes the morph there</source>
   <translation>Eine Zeile je Variante; zeigen Sie auf ihren Zustand, um zu lesen, warum sie durchfiel. Ein Doppelklick bringt den Morph dorthin</translation>
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
   <source>Both skins and the walls follow one sheet and keep their distance; off: the closed surface bends as it is</source>
   <translation>Beide Häute und die Wände folgen einem Blech und behalten ihren Abstand; aus: die geschlossene Oberfläche biegt sich, wie sie ist</translation>
  </message>
  <message>
   <source>Mark Holes as Form Features</source>
   <translation>Löcher als Formelemente markieren</translation>
  </message>
  <message>
   <source>Every hole through both skins becomes a form feature: it keeps its shape, wall included</source>
   <translation>Jedes Loch durch beide Häute wird ein Formelement: es behält seine Form samt Wand</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>SheetMorph Morph</source>
   <translation>SheetMorph Morph</translation>
  </message>
  <message>
   <source>SheetMorph Regions</source>
   <translation>SheetMorph Regionen</translation>
  </message>
  <message>
   <source>SheetMorph Contacts</source>
   <translation>SheetMorph Kontakte</translation>
  </message>
  <message>
   <source>SheetMorph Features</source>
   <translation>SheetMorph Formelemente</translation>
  </message>
  <message>
   <source>SheetMorph Motion</source>
   <translation>SheetMorph Bewegung</translation>
  </message>
  <message>
   <source>SheetMorph Exchange</source>
   <translation>SheetMorph Austausch</translation>
  </message>
 </context>
</TS>
