<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Removal</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove %1, session %2, %3, capture %4?</source>
        <translation>%1, Sitzung %2, %3, Aufnahme %4 entfernen?</translation>
    </message>
    <message numerus="yes">
        <source>Its %n picture(s) are deleted for good. The next capture of this hand takes its number.</source>
        <translation>
            <numerusform>Ihr %n Bild wird endgültig gelöscht. Die nächste Aufnahme dieser Hand bekommt ihre Nummer.</numerusform>
            <numerusform>Ihre %n Bilder werden endgültig gelöscht. Die nächste Aufnahme dieser Hand bekommt ihre Nummer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n capture(s), %1 together, are deleted for good. The id and what was said of the person go too. Exports, surfaces and backups are not reached.</source>
        <translation>
            <numerusform>%n Aufnahme, zusammen %1, wird endgültig gelöscht. Die Kennung und die Angaben zur Person gehen mit. Exporte, Oberflächen und Sicherungen werden nicht erreicht.</numerusform>
            <numerusform>%n Aufnahmen, zusammen %1, werden endgültig gelöscht. Die Kennung und die Angaben zur Person gehen mit. Exporte, Oberflächen und Sicherungen werden nicht erreicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove %1 from the campaign?</source>
        <translation>%1 aus der Kampagne entfernen?</translation>
    </message>
</context>
<context>
    <name>dorsum::Banner</name>
    <message>
        <source>What went wrong</source>
        <translation>Was schiefging</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Meldung schließen</translation>
    </message>
</context>
<context>
    <name>dorsum::CalibrateModel</name>
    <message>
        <source>Chessboard %1 of %2</source>
        <translation>Schachbrett %1 von %2</translation>
    </message>
    <message>
        <source>Empty backplane</source>
        <translation>Leere Grundplatte</translation>
    </message>
    <message>
        <source>Chessboard under laser %1</source>
        <translation>Schachbrett unter Laser %1</translation>
    </message>
    <message>
        <source>Sheet of lines</source>
        <translation>Linienblatt</translation>
    </message>
    <message>
        <source>Object of %1 mm</source>
        <translation>Körper von %1 mm</translation>
    </message>
    <message>
        <source>Board on object, laser %1</source>
        <translation>Brett auf Körper, Laser %1</translation>
    </message>
    <message>
        <source>Box of %1 mm</source>
        <translation>Quader von %1 mm</translation>
    </message>
    <message>
        <source>Looking at what is there already…</source>
        <translation>Nachsehen, was schon da ist…</translation>
    </message>
    <message>
        <source>Taking the calibration series</source>
        <translation>Kalibrierserie wird aufgenommen</translation>
    </message>
    <message>
        <source>Stopped. What was taken is kept; the series goes on from there.</source>
        <translation>Angehalten. Was aufgenommen ist, bleibt; die Serie geht von dort weiter.</translation>
    </message>
    <message>
        <source>The series broke off. What was taken is kept; the series goes on from there.</source>
        <translation>Die Serie brach ab. Was aufgenommen ist, bleibt; die Serie geht von dort weiter.</translation>
    </message>
    <message>
        <source>All pictures are there. The boards cover %1 % of the picture.</source>
        <translation>Alle Bilder sind da. Die Bretter decken %1 % des Bildes ab.</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Kalibrierung läuft</translation>
    </message>
</context>
<context>
    <name>dorsum::CalibratePage</name>
    <message>
        <source>&amp;Series</source>
        <translation>&amp;Serie</translation>
    </message>
    <message>
        <source>&amp;Go back to the calibration before</source>
        <translation>&amp;Zurück zur vorigen Kalibrierung</translation>
    </message>
    <message>
        <source>Puts the calibration back that the last one replaced.</source>
        <translation>Stellt die Kalibrierung wieder her, die von der letzten ersetzt wurde.</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>&amp;Ergebnis</translation>
    </message>
    <message>
        <source>Where the pictures of the series are, or go. What is there already is kept.</source>
        <translation>Wo die Bilder der Serie liegen oder hinkommen. Was schon dort ist, bleibt.</translation>
    </message>
    <message>
        <source>The calibration that is written; its report comes beside it.</source>
        <translation>Die Kalibrierung, die geschrieben wird; ihr Bericht kommt daneben.</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Durchsuchen: %1</translation>
    </message>
    <message>
        <source>Series &amp;folder</source>
        <translation>&amp;Ordner der Serie</translation>
    </message>
    <message>
        <source>Calibration f&amp;ile</source>
        <translation>Kalibrier&amp;datei</translation>
    </message>
    <message>
        <source>&amp;Take the series</source>
        <translation>Serie &amp;aufnehmen</translation>
    </message>
    <message>
        <source>Leads through the series with the open device. A series that was broken off goes on where it ended.</source>
        <translation>Führt mit dem offenen Gerät durch die Serie. Eine abgebrochene Serie geht weiter, wo sie endete.</translation>
    </message>
    <message>
        <source>&amp;Calibrate from the folder</source>
        <translation>Aus dem Ordner &amp;kalibrieren</translation>
    </message>
    <message>
        <source>Calibrates from the pictures that the folder holds; needs no device.</source>
        <translation>Kalibriert aus den Bildern im Ordner; braucht kein Gerät.</translation>
    </message>
    <message>
        <source>Steps of the series</source>
        <translation>Schritte der Serie</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Live picture with what the boards cover</source>
        <translation>Livebild mit dem, was die Bretter abdecken</translation>
    </message>
    <message>
        <source>The live picture comes when the series is taken.</source>
        <translation>Das Livebild kommt, wenn die Serie aufgenommen wird.</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>What was asked for stands: take the pictures (Return).</source>
        <translation>Alles steht wie verlangt: Bilder aufnehmen (Eingabetaste).</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Ends the series; what was taken is kept.</source>
        <translation>Beendet die Serie; was aufgenommen ist, bleibt.</translation>
    </message>
    <message>
        <source>Go on &amp;by itself</source>
        <translation>Von &amp;selbst weitergehen</translation>
    </message>
    <message>
        <source>A virtual device lays things down by itself, without being asked.</source>
        <translation>Ein virtuelles Gerät legt die Dinge ohne Rückfrage selbst hin.</translation>
    </message>
    <message>
        <source>S&amp;how what boards cover</source>
        <translation>&amp;Abdeckung durch Bretter zeigen</translation>
    </message>
    <message>
        <source>Choose the folder of the series</source>
        <translation>Ordner der Serie wählen</translation>
    </message>
    <message>
        <source>Choose where the calibration goes</source>
        <translation>Ort der Kalibrierung wählen</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrierungen (*.json)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Go on &amp;taking the series</source>
        <translation>Serie weiter &amp;aufnehmen</translation>
    </message>
    <message>
        <source>Take the series: you are led through it step by step.</source>
        <translation>Serie aufnehmen: Sie werden Schritt für Schritt hindurchgeführt.</translation>
    </message>
    <message>
        <source>Open a device on the device page, or calibrate from a folder.</source>
        <translation>Öffnen Sie auf der Geräteseite ein Gerät, oder kalibrieren Sie aus einem Ordner.</translation>
    </message>
    <message>
        <source>Covered: %1 %</source>
        <translation>Abgedeckt: %1 %</translation>
    </message>
</context>
<context>
    <name>dorsum::CalibrationViews</name>
    <message>
        <source>Verdicts</source>
        <translation>Urteile</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Bretter</translation>
    </message>
    <message>
        <source>Lasers</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>The board with arrows to where its corners are expected</source>
        <translation>Das Brett mit Pfeilen dorthin, wo seine Ecken erwartet werden</translation>
    </message>
    <message>
        <source>What the light sheets leave, order by order</source>
        <translation>Was die Lichtflächen übrig lassen, Beugungsordnung für Beugungsordnung</translation>
    </message>
    <message>
        <source>What the light sheets leave along the stripes</source>
        <translation>Was die Lichtflächen entlang der Laserstreifen übrig lassen</translation>
    </message>
    <message>
        <source>Each board with its reprojection error. The arrows are drawn many times longer.</source>
        <translation>Jedes Brett mit seinem Reprojektionsfehler. Die Pfeile sind um ein Vielfaches verlängert.</translation>
    </message>
    <message>
        <source>Noise scatters evenly about zero; a pattern is an error of the model, or a laser that moved.</source>
        <translation>Rauschen streut gleichmäßig um null; ein Muster ist ein Fehler des Modells oder ein Laser, der sich bewegt hat.</translation>
    </message>
    <message>
        <source>&amp;Verdicts</source>
        <translation>&amp;Urteile</translation>
    </message>
    <message>
        <source>&amp;Boards</source>
        <translation>&amp;Bretter</translation>
    </message>
    <message>
        <source>&amp;Light sheets</source>
        <translation>&amp;Lichtflächen</translation>
    </message>
    <message>
        <source>Before and &amp;after</source>
        <translation>Vorher und &amp;nachher</translation>
    </message>
    <message>
        <source>Nothing was calibrated here yet.</source>
        <translation>Hier wurde noch nichts kalibriert.</translation>
    </message>
    <message>
        <source>%1: %2 px</source>
        <translation>%1: %2 px</translation>
    </message>
    <message>
        <source>Laser %1</source>
        <translation>Laser %1</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No calibration was loaded before.</source>
        <translation>Vorher war keine Kalibrierung geladen.</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignCaptures</name>
    <message>
        <source>%1, session %2, %3, capture %4: %5.</source>
        <translation>%1, Sitzung %2, %3, Aufnahme %4: %5.</translation>
    </message>
    <message>
        <source>The picture of a laser is missing.</source>
        <translation>Das Bild eines Lasers fehlt.</translation>
    </message>
    <message>
        <source>It has no calibration.</source>
        <translation>Sie hat keine Kalibrierung.</translation>
    </message>
    <message>
        <source>Session %1, %2, %3</source>
        <translation>Sitzung %1, %2, %3</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignDetails</name>
    <message>
        <source>Live picture</source>
        <translation>Livebild</translation>
    </message>
    <message>
        <source>Captures</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>&amp;Look at it</source>
        <translation>An&amp;sehen</translation>
    </message>
    <message>
        <source>Reconstructs the chosen capture, for the pages Surface and Stages</source>
        <translation>Rekonstruiert die gewählte Aufnahme für die Seiten Oberfläche und Stufen</translation>
    </message>
    <message>
        <source>Remove &amp;capture…</source>
        <translation>Aufnahme lös&amp;chen…</translation>
    </message>
    <message>
        <source>Deletes the chosen capture, to take it again</source>
        <translation>Löscht die gewählte Aufnahme, um sie zu wiederholen</translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Kein Bild: %1</translation>
    </message>
    <message>
        <source>C&amp;orrect…</source>
        <translation>&amp;Korrigieren…</translation>
    </message>
    <message>
        <source>Replaces what was said of the person wrongly</source>
        <translation>Ersetzt, was zur Person falsch angegeben wurde</translation>
    </message>
    <message>
        <source>Remove &amp;person…</source>
        <translation>Person &amp;entfernen…</translation>
    </message>
    <message>
        <source>Deletes the person with all captures, for good</source>
        <translation>Löscht die Person mit allen Aufnahmen endgültig</translation>
    </message>
    <message>
        <source>Takes what is missing next, with the open device (Ctrl+Return)</source>
        <translation>Nimmt mit dem offenen Gerät auf, was als Nächstes fehlt (Strg+Eingabetaste)</translation>
    </message>
    <message>
        <source>From a &amp;folder…</source>
        <translation>A&amp;us einem Ordner…</translation>
    </message>
    <message>
        <source>Takes over a capture that lies in a folder already</source>
        <translation>Übernimmt eine Aufnahme, die schon in einem Ordner liegt</translation>
    </message>
    <message>
        <source>Choose a person in the table, or add one.</source>
        <translation>Wählen Sie in der Tabelle eine Person, oder fügen Sie eine hinzu.</translation>
    </message>
    <message>
        <source>%1, session %2, %3</source>
        <translation>%1, Sitzung %2, %3</translation>
    </message>
    <message>
        <source>Next: session %1, %2; %3 missing.</source>
        <translation>Als Nächstes: Sitzung %1, %2; %3 fehlen.</translation>
    </message>
    <message>
        <source>Nothing is missing here.</source>
        <translation>Hier fehlt nichts.</translation>
    </message>
    <message numerus="yes">
        <source>%n capture(s) are missing in all.</source>
        <translation>
            <numerusform>Insgesamt fehlt %n Aufnahme.</numerusform>
            <numerusform>Insgesamt fehlen %n Aufnahmen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No device is open; open one on the Device page.</source>
        <translation>Kein Gerät ist offen; öffnen Sie eines auf der Geräteseite.</translation>
    </message>
    <message>
        <source>&amp;Make all that is missing</source>
        <translation>Alles Fehlende erzeu&amp;gen</translation>
    </message>
    <message>
        <source>Capture the %1</source>
        <translation>Aufnehmen: %1</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Take over a capture folder</source>
        <translation>Ordner einer Aufnahme übernehmen</translation>
    </message>
    <message>
        <source>Waiting for a picture…</source>
        <translation>Warten auf ein Bild…</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignModel</name>
    <message>
        <source>Reading the campaign</source>
        <translation>Kampagne wird gelesen</translation>
    </message>
    <message>
        <source>Making the campaign</source>
        <translation>Kampagne wird angelegt</translation>
    </message>
    <message>
        <source>The campaign %1 is there. Add the first person.</source>
        <translation>Die Kampagne %1 ist angelegt. Fügen Sie die erste Person hinzu.</translation>
    </message>
    <message>
        <source>Capturing virtual people</source>
        <translation>Virtuelle Personen werden aufgenommen</translation>
    </message>
    <message>
        <source>%1 virtual people with %2 captures are there.</source>
        <translation>Virtuelle Personen: %1, ihre Aufnahmen: %2.</translation>
    </message>
    <message>
        <source>Adding a person</source>
        <translation>Person wird hinzugefügt</translation>
    </message>
    <message>
        <source>What is said of %1 is corrected.</source>
        <translation>Die Angaben zu %1 sind korrigiert.</translation>
    </message>
    <message>
        <source>%1 belongs to the campaign now.</source>
        <translation>%1 gehört jetzt zur Kampagne.</translation>
    </message>
    <message>
        <source>Removing a person</source>
        <translation>Person wird entfernt</translation>
    </message>
    <message numerus="yes">
        <source>Removed the person and %n capture(s). Exports, surfaces and backups are not reached.</source>
        <translation>
            <numerusform>Die Person und %n Aufnahme sind entfernt. Exporte, Oberflächen und Sicherungen werden nicht erreicht.</numerusform>
            <numerusform>Die Person und %n Aufnahmen sind entfernt. Exporte, Oberflächen und Sicherungen werden nicht erreicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Removing a capture</source>
        <translation>Aufnahme wird entfernt</translation>
    </message>
    <message>
        <source>Removed %1. The next capture of this hand takes its number.</source>
        <translation>%1 ist entfernt. Die nächste Aufnahme dieser Hand bekommt die Nummer.</translation>
    </message>
    <message>
        <source>Capturing %1, session %2, %3</source>
        <translation>Aufnahme von %1, Sitzung %2, %3</translation>
    </message>
    <message>
        <source>Taking over a capture</source>
        <translation>Aufnahme wird übernommen</translation>
    </message>
    <message>
        <source>%1, session %2, %3: capture %4 of %5 is stored.</source>
        <translation>%1, Sitzung %2, %3: Aufnahme %4 von %5 ist gespeichert.</translation>
    </message>
    <message>
        <source>Reconstructing %1</source>
        <translation>Rekonstruktion von %1</translation>
    </message>
    <message>
        <source>%1 is on the pages Surface and Stages now.</source>
        <translation>%1 ist jetzt auf den Seiten Oberfläche und Stufen.</translation>
    </message>
    <message>
        <source>Verifying the campaign</source>
        <translation>Kampagne wird geprüft</translation>
    </message>
    <message numerus="yes">
        <source>Verified: all %n file(s) are as they were stored.</source>
        <translation>
            <numerusform>Geprüft: %n Datei ist, wie sie gespeichert wurde.</numerusform>
            <numerusform>Geprüft: alle %n Dateien sind, wie sie gespeichert wurden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Verified: the campaign is not as it was stored, with %n finding(s). Bring back what is missing or damaged from a copy of the folder, or remove the capture and take it again.</source>
        <translation>
            <numerusform>Geprüft: die Kampagne ist nicht, wie sie gespeichert wurde; %n Befund. Holen Sie Fehlendes oder Beschädigtes aus einer Kopie des Ordners zurück, oder entfernen Sie die Aufnahme und wiederholen Sie sie.</numerusform>
            <numerusform>Geprüft: die Kampagne ist nicht, wie sie gespeichert wurde; %n Befunde. Holen Sie Fehlendes oder Beschädigtes aus einer Kopie des Ordners zurück, oder entfernen Sie die Aufnahme und wiederholen Sie sie.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting the campaign</source>
        <translation>Kampagne wird exportiert</translation>
    </message>
    <message>
        <source>Exported %1 people with %2 captures to %3.</source>
        <translation>Exportiert nach %3: Personen: %1, Aufnahmen: %2.</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignPage</name>
    <message>
        <source>%1 of %2 people</source>
        <translation>%1 von %2 Personen</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 are there, %2 of them with all captures; %3 of %4 captures.</source>
        <translation>Bisher %1, davon %2 mit allen Aufnahmen; %3 von %4 Aufnahmen.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Nothing is missing of the people who came.</source>
        <translation>Von den Personen, die da waren, fehlt nichts.</translation>
    </message>
    <message>
        <source>A campaign collects captures of many people: who came, which hands are there, and what is missing. Open the folder of one, or begin a new one; one of virtual people needs no device.</source>
        <translation>Eine Kampagne sammelt Aufnahmen vieler Personen: wer da war, welche Hände vorliegen und was fehlt. Öffnen Sie den Ordner einer Kampagne, oder beginnen Sie eine neue; eine mit virtuellen Personen braucht kein Gerät.</translation>
    </message>
    <message>
        <source>&amp;Open a campaign…</source>
        <translation>Kampagne &amp;öffnen…</translation>
    </message>
    <message>
        <source>Opens the folder of a campaign</source>
        <translation>Öffnet den Ordner einer Kampagne</translation>
    </message>
    <message>
        <source>&amp;New campaign…</source>
        <translation>&amp;Neue Kampagne…</translation>
    </message>
    <message>
        <source>Begins a campaign in a new folder</source>
        <translation>Beginnt eine Kampagne in einem neuen Ordner</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>Opens the folder of another campaign</source>
        <translation>Öffnet den Ordner einer anderen Kampagne</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>&amp;Neu…</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>P&amp;rüfen</translation>
    </message>
    <message>
        <source>Reads every byte: is all as it was stored?</source>
        <translation>Liest jedes Byte: ist alles so, wie es gespeichert wurde?</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Writes the captures for others, under new random ids and without personal data</source>
        <translation>Schreibt die Aufnahmen für andere, unter neuen zufälligen Kennungen und ohne persönliche Daten</translation>
    </message>
    <message>
        <source>Open the folder of a campaign</source>
        <translation>Ordner einer Kampagne öffnen</translation>
    </message>
    <message>
        <source>Something of this campaign cannot be read, and does not count. Verify says more.</source>
        <translation>Etwas an dieser Kampagne ist nicht lesbar und zählt nicht. „Prüfen“ sagt mehr.</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignPeople</name>
    <message>
        <source>Only &amp;what is missing</source>
        <translation>Nur &amp;Fehlendes</translation>
    </message>
    <message>
        <source>&amp;Add a person…</source>
        <translation>&amp;Person hinzufügen…</translation>
    </message>
    <message>
        <source>Find an id</source>
        <translation>Kennung suchen</translation>
    </message>
    <message>
        <source>Hides the people of whom all is there</source>
        <translation>Blendet die Personen aus, von denen alles da ist</translation>
    </message>
    <message>
        <source>With the day of the consent</source>
        <translation>Mit dem Tag der Einwilligung</translation>
    </message>
    <message>
        <source>Next &amp;gap</source>
        <translation>Nächste &amp;Lücke</translation>
    </message>
    <message>
        <source>Goes to the next hand of which something is missing</source>
        <translation>Geht zur nächsten Hand, von der etwas fehlt</translation>
    </message>
    <message>
        <source>People and their hands</source>
        <translation>Personen und ihre Hände</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignTable</name>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>man</source>
        <translation>Mann</translation>
    </message>
    <message>
        <source>woman</source>
        <translation>Frau</translation>
    </message>
    <message>
        <source>other</source>
        <translation>anderes</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>%1 is a virtual person.</source>
        <translation>%1 ist eine virtuelle Person.</translation>
    </message>
    <message>
        <source>%1 consented on %2.</source>
        <translation>%1 hat am %2 eingewilligt.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, session %2, %3: %4 captures are there, %5 are missing.</source>
        <translation>%1, Sitzung %2, %3: vorhandene Aufnahmen: %4, fehlende: %5.</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Session %1,
%2</source>
        <translation>Sitzung %1,
%2</translation>
    </message>
</context>
<context>
    <name>dorsum::DeviceModel</name>
    <message>
        <source>LEDs</source>
        <translation>LEDs</translation>
    </message>
    <message>
        <source>LEDs of channel %1</source>
        <translation>LEDs an Kanal %1</translation>
    </message>
    <message>
        <source>Laser %1</source>
        <translation>Laser %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>left as the camera has it</source>
        <translation>wie die Kamera es eingestellt hat</translation>
    </message>
    <message>
        <source>No device is open, so no light can be switched on.</source>
        <translation>Kein Gerät ist offen, also lässt sich kein Licht einschalten.</translation>
    </message>
    <message>
        <source>A laser switched on here goes off by itself after %1.</source>
        <translation>Ein hier eingeschalteter Laser geht nach %1 von selbst aus.</translation>
    </message>
    <message>
        <source>The controller itself puts all lights out when it hears nothing for %1.</source>
        <translation>Die Steuerung löscht alle Lichter selbst, wenn sie %1 lang nichts hört.</translation>
    </message>
    <message>
        <source>The controller has no limit of its own.</source>
        <translation>Die Steuerung hat keine eigene Grenze.</translation>
    </message>
    <message>
        <source>All lights go off when this page is left.</source>
        <translation>Alle Lichter gehen aus, wenn diese Seite verlassen wird.</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>The controller says: all lights are off.</source>
        <translation>Die Steuerung meldet: alle Lichter sind aus.</translation>
    </message>
    <message>
        <source>The controller says these are on: %1.</source>
        <translation>Die Steuerung meldet, dass an sind: %1.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>JPEG, quality %1</source>
        <translation>JPEG, Qualität %1</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Bildstrom</translation>
    </message>
    <message>
        <source>raw pictures</source>
        <translation>Rohbilder</translation>
    </message>
    <message>
        <source>JPEG pictures</source>
        <translation>JPEG-Bilder</translation>
    </message>
    <message>
        <source>Exposure under lasers</source>
        <translation>Belichtung unter Lasern</translation>
    </message>
    <message>
        <source>Exposure under LEDs</source>
        <translation>Belichtung unter LEDs</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>%1 K</source>
        <translation>%1 K</translation>
    </message>
    <message>
        <source>Could not be set</source>
        <translation>Nicht einstellbar</translation>
    </message>
    <message>
        <source>Examining the device</source>
        <translation>Gerät wird untersucht</translation>
    </message>
    <message>
        <source>Examining this machine</source>
        <translation>Dieser Rechner wird untersucht</translation>
    </message>
</context>
<context>
    <name>dorsum::DevicePage</name>
    <message>
        <source>Live picture</source>
        <translation>Livebild</translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Kein Bild: %1</translation>
    </message>
    <message>
        <source>The device does not answer. Open it again.</source>
        <translation>Das Gerät antwortet nicht. Öffnen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>A device description (device.toml), or virtual; virtual:7 is another virtual device, with the mounting errors of seed 7.</source>
        <translation>Eine Gerätebeschreibung (device.toml) oder virtual; virtual:7 ist ein anderes virtuelles Gerät, mit den Montagefehlern der Zufallszahl 7.</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>Opens the device named above, in place of the one that is open.</source>
        <translation>Öffnet das oben genannte Gerät anstelle dessen, das offen ist.</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Wird geöffnet…</translation>
    </message>
    <message>
        <source>Lights by hand</source>
        <translation>Lichter von Hand</translation>
    </message>
    <message>
        <source>&amp;All off</source>
        <translation>&amp;Alles aus</translation>
    </message>
    <message>
        <source>Switches every light off at once (Ctrl+.).</source>
        <translation>Schaltet alle Lichter sofort aus (Strg+.).</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Camera settings</source>
        <translation>Kameraeinstellungen</translation>
    </message>
    <message>
        <source>Camera &amp;settings</source>
        <translation>&amp;Kameraeinstellungen</translation>
    </message>
    <message>
        <source>&amp;Examine</source>
        <translation>&amp;Untersuchen</translation>
    </message>
    <message>
        <source>Looks at cameras, ports, disk and calibration, then takes a picture in the dark, under the LEDs and under each laser. Clear the backplane first.</source>
        <translation>Sieht nach Kameras, Anschlüssen, Festplatte und Kalibrierung und nimmt dann im Dunkeln, unter den LEDs und unter jedem Laser ein Bild auf. Vorher die Grundplatte freiräumen.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>E&amp;xamination</source>
        <translation>Unter&amp;suchung</translation>
    </message>
    <message>
        <source>Choose a device description</source>
        <translation>Gerätebeschreibung wählen</translation>
    </message>
    <message>
        <source>Device descriptions (*.toml)</source>
        <translation>Gerätebeschreibungen (*.toml)</translation>
    </message>
    <message>
        <source>Open: %1. %2; %3, firmware %4.</source>
        <translation>Offen: %1. %2; %3, Firmware %4.</translation>
    </message>
    <message>
        <source>Waiting for a picture…</source>
        <translation>Warten auf ein Bild…</translation>
    </message>
    <message>
        <source>No device is open.</source>
        <translation>Kein Gerät ist offen.</translation>
    </message>
    <message>
        <source>No device is open. Choose one at the left; virtual needs no hardware.</source>
        <translation>Kein Gerät ist offen. Wählen Sie links eines; virtual braucht keine Hardware.</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1: aus</translation>
    </message>
    <message>
        <source>%1: on, off by itself in %2 s</source>
        <translation>%1: an, in %2 s von selbst aus</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1: an</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>defekt</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>dorsum::DeviceSession</name>
    <message>
        <source>Opening the device</source>
        <translation>Gerät wird geöffnet</translation>
    </message>
    <message>
        <source>Closing the device</source>
        <translation>Gerät wird geschlossen</translation>
    </message>
</context>
<context>
    <name>dorsum::ExportDialog</name>
    <message>
        <source>Export the campaign</source>
        <translation>Kampagne exportieren</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>Tell sex and age group too</source>
        <translation>Auch Geschlecht und Altersgruppe angeben</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Name:</translation>
    </message>
    <message>
        <source>The name of the new folder</source>
        <translation>Der Name des neuen Ordners</translation>
    </message>
    <message>
        <source>&amp;In the folder:</source>
        <translation>&amp;Im Ordner:</translation>
    </message>
    <message>
        <source>The export becomes a folder of its own in it</source>
        <translation>Der Export wird ein eigener Ordner darin</translation>
    </message>
    <message>
        <source>&amp;Groups:</source>
        <translation>&amp;Gruppen:</translation>
    </message>
    <message>
        <source>Only where groups are large enough. Without it, nobody is told anything but the pictures under new random ids.</source>
        <translation>Nur wo Gruppen groß genug sind. Ohne dies wird nichts weitergegeben als die Bilder unter neuen zufälligen Kennungen.</translation>
    </message>
    <message>
        <source>&amp;Least:</source>
        <translation>&amp;Mindestens:</translation>
    </message>
    <message>
        <source>People that each group must have to be told</source>
        <translation>Personen, die jede Gruppe haben muss, um angegeben zu werden</translation>
    </message>
</context>
<context>
    <name>dorsum::FormDialog</name>
    <message>
        <source>Give it a name.</source>
        <translation>Geben Sie einen Namen an.</translation>
    </message>
    <message>
        <source>The name becomes a folder: it holds no slash and does not begin with a point.</source>
        <translation>Der Name wird ein Ordner: er enthält keinen Schrägstrich und beginnt nicht mit einem Punkt.</translation>
    </message>
    <message>
        <source>Choose a folder that is there, to put it in.</source>
        <translation>Wählen Sie einen vorhandenen Ordner, in den es kommt.</translation>
    </message>
    <message>
        <source>%1 is there already; choose another name.</source>
        <translation>%1 gibt es schon; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>What is still to be done</source>
        <translation>Was noch zu tun ist</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
</context>
<context>
    <name>dorsum::LiveView</name>
    <message>
        <source>Live picture</source>
        <translation>Livebild</translation>
    </message>
</context>
<context>
    <name>dorsum::MainWindow</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Scan a hand</source>
        <translation>Eine Hand scannen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Look at a surface and measure it</source>
        <translation>Eine Oberfläche ansehen und vermessen</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate the device, or look at how well it is calibrated</source>
        <translation>Das Gerät kalibrieren oder ansehen, wie gut es kalibriert ist</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Open a device, switch its lights by hand, examine it</source>
        <translation>Ein Gerät öffnen, seine Lichter von Hand schalten, es untersuchen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>Datei &amp;öffnen…</translation>
    </message>
    <message>
        <source>Open &amp;capture folder…</source>
        <translation>Ordner einer &amp;Aufnahme öffnen…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Dorsum Studio</source>
        <translation>Ü&amp;ber Dorsum Studio</translation>
    </message>
    <message>
        <source>About Dorsum Studio</source>
        <translation>Über Dorsum Studio</translation>
    </message>
    <message>
        <source>Dorsum Studio %1: scans the back of a hand. Apache License 2.0.</source>
        <translation>Dorsum Studio %1: scannt den Handrücken. Apache-Lizenz 2.0.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>The window speaks it from its next start on.</source>
        <translation>Das Fenster spricht sie ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;As the desktop</source>
        <translation>&amp;Wie der Desktop</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Open a capture folder</source>
        <translation>Ordner einer Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Open a calibration or a surface</source>
        <translation>Kalibrierung oder Oberfläche öffnen</translation>
    </message>
    <message>
        <source>Calibrations and surfaces (*.json *.ply)</source>
        <translation>Kalibrierungen und Oberflächen (*.json *.ply)</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>See each step of the computation, the document&apos;s beside ours</source>
        <translation>Jeden Schritt der Berechnung sehen, den des Dokuments neben unserem</translation>
    </message>
    <message>
        <source>Campaign</source>
        <translation>Kampagne</translation>
    </message>
    <message>
        <source>Collect captures of many people, and see what is missing</source>
        <translation>Aufnahmen vieler Personen sammeln, und sehen, was fehlt</translation>
    </message>
</context>
<context>
    <name>dorsum::NewCampaignDialog</name>
    <message>
        <source>New campaign</source>
        <translation>Neue Kampagne</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>The one that is open</source>
        <translation>Die geöffnete</translation>
    </message>
    <message>
        <source>Captured without a device</source>
        <translation>Ohne Gerät aufgenommen</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Name:</translation>
    </message>
    <message>
        <source>A name for people to read, and the name of the folder</source>
        <translation>Ein lesbarer Name, zugleich der Name des Ordners</translation>
    </message>
    <message>
        <source>&amp;In the folder:</source>
        <translation>&amp;Im Ordner:</translation>
    </message>
    <message>
        <source>The campaign becomes a folder of its own in it</source>
        <translation>Die Kampagne wird ein eigener Ordner darin</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>&amp;People:</source>
        <translation>&amp;Personen:</translation>
    </message>
    <message>
        <source>How many people are hoped for</source>
        <translation>Wie viele Personen erhofft sind</translation>
    </message>
    <message>
        <source>&amp;Sessions:</source>
        <translation>&amp;Sitzungen:</translation>
    </message>
    <message>
        <source>Visits of each person</source>
        <translation>Besuche jeder Person</translation>
    </message>
    <message>
        <source>C&amp;aptures:</source>
        <translation>&amp;Aufnahmen:</translation>
    </message>
    <message>
        <source>Captures of each hand in each session</source>
        <translation>Aufnahmen jeder Hand in jeder Sitzung</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>&amp;Hands:</source>
        <translation>&amp;Hände:</translation>
    </message>
    <message>
        <source>Which hands are captured</source>
        <translation>Welche Hände aufgenommen werden</translation>
    </message>
    <message>
        <source>&amp;Calibration:</source>
        <translation>&amp;Kalibrierung:</translation>
    </message>
    <message>
        <source>No calibration is open. The first capture can bring one.</source>
        <translation>Keine Kalibrierung ist offen. Die erste Aufnahme kann eine mitbringen.</translation>
    </message>
    <message>
        <source>&amp;Virtual people:</source>
        <translation>&amp;Virtuelle Personen:</translation>
    </message>
    <message>
        <source>Virtual people come to a virtual device, which is calibrated first. This takes minutes, and can be stopped and gone on with.</source>
        <translation>Virtuelle Personen kommen zu einem virtuellen Gerät, das zuerst kalibriert wird. Das dauert Minuten und lässt sich anhalten und fortsetzen.</translation>
    </message>
    <message>
        <source>S&amp;eed:</source>
        <translation>Start&amp;wert:</translation>
    </message>
    <message>
        <source>Another seed is another virtual device with other people</source>
        <translation>Ein anderer Startwert ist ein anderes virtuelles Gerät mit anderen Personen</translation>
    </message>
    <message>
        <source>Say how many virtual people are to come.</source>
        <translation>Geben Sie an, wie viele virtuelle Personen kommen sollen.</translation>
    </message>
    <message>
        <source>A seed has 1 to 200 characters.</source>
        <translation>Ein Startwert hat 1 bis 200 Zeichen.</translation>
    </message>
</context>
<context>
    <name>dorsum::OptionBox</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Takes the last change of a parameter back (Ctrl+Z)</source>
        <translation>Nimmt die letzte Änderung eines Parameters zurück (Strg+Z)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Makes the change again (Ctrl+Shift+Z)</source>
        <translation>Macht die Änderung noch einmal (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>R&amp;eset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Puts all parameters back to their defaults; can be undone</source>
        <translation>Setzt alle Parameter auf ihre Vorgaben zurück; lässt sich rückgängig machen</translation>
    </message>
</context>
<context>
    <name>dorsum::OptionPanel</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
</context>
<context>
    <name>dorsum::PersonDialog</name>
    <message>
        <source>Correct a person</source>
        <translation>Person korrigieren</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>Ko&amp;rrigieren</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>The person has signed it</source>
        <translation>Die Person hat sie unterschrieben</translation>
    </message>
    <message>
        <source>&amp;Id:</source>
        <translation>&amp;Kennung:</translation>
    </message>
    <message>
        <source>Pseudonymous, as p01; never a name. The list that says who p01 is belongs on paper, in another place.</source>
        <translation>Pseudonym, wie p01; nie ein Name. Die Liste, wer p01 ist, gehört auf Papier, an einen anderen Ort.</translation>
    </message>
    <message>
        <source>&amp;Sex:</source>
        <translation>&amp;Geschlecht:</translation>
    </message>
    <message>
        <source>As the person says</source>
        <translation>Wie die Person es angibt</translation>
    </message>
    <message>
        <source>A&amp;ge group:</source>
        <translation>&amp;Altersgruppe:</translation>
    </message>
    <message>
        <source>In years</source>
        <translation>In Jahren</translation>
    </message>
    <message>
        <source>C&amp;onsent:</source>
        <translation>&amp;Einwilligung:</translation>
    </message>
    <message>
        <source>Without the consent nothing is stored</source>
        <translation>Ohne Einwilligung wird nichts gespeichert</translation>
    </message>
    <message>
        <source>Signed o&amp;n:</source>
        <translation>&amp;Unterschrieben am:</translation>
    </message>
    <message>
        <source>The day on which the person signed the consent. Without it nothing is stored.</source>
        <translation>Der Tag, an dem die Person die Einwilligung unterschrieben hat. Ohne sie wird nichts gespeichert.</translation>
    </message>
    <message>
        <source>Give the person an id, as p01; never a name.</source>
        <translation>Geben Sie der Person eine Kennung, wie p01; nie einen Namen.</translation>
    </message>
    <message>
        <source>%1 is in the campaign already; choose another id.</source>
        <translation>%1 ist schon in der Kampagne; wählen Sie eine andere Kennung.</translation>
    </message>
    <message>
        <source>Nothing is stored of a person who has not signed the consent.</source>
        <translation>Von einer Person, die die Einwilligung nicht unterschrieben hat, wird nichts gespeichert.</translation>
    </message>
</context>
<context>
    <name>dorsum::ScaleBar</name>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
</context>
<context>
    <name>dorsum::ScanModel</name>
    <message>
        <source>No device is open</source>
        <translation>Kein Gerät ist offen</translation>
    </message>
    <message>
        <source>The device does not answer: look at its cables</source>
        <translation>Das Gerät antwortet nicht: Kabel prüfen</translation>
    </message>
    <message>
        <source>The calibration is of another device</source>
        <translation>Die Kalibrierung gehört zu einem anderen Gerät</translation>
    </message>
    <message>
        <source>This device needs its calibration first</source>
        <translation>Dieses Gerät braucht zuerst seine Kalibrierung</translation>
    </message>
    <message>
        <source>The virtual device calibrates itself</source>
        <translation>Das virtuelle Gerät kalibriert sich</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Stillhalten</translation>
    </message>
    <message>
        <source>Once more: hold still</source>
        <translation>Noch einmal: stillhalten</translation>
    </message>
    <message>
        <source>Thank you: you may take the hand away</source>
        <translation>Danke: die Hand kann weg</translation>
    </message>
    <message>
        <source>Is it good?</source>
        <translation>Ist es gut so?</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Put your hand down</source>
        <translation>Hand auflegen</translation>
    </message>
    <message>
        <source>The light has changed: calibrate again</source>
        <translation>Das Licht hat sich geändert: neu kalibrieren</translation>
    </message>
    <message>
        <source>Move the hand to the left</source>
        <translation>Hand nach links schieben</translation>
    </message>
    <message>
        <source>Move the hand to the right</source>
        <translation>Hand nach rechts schieben</translation>
    </message>
    <message>
        <source>Move the hand up</source>
        <translation>Hand nach oben schieben</translation>
    </message>
    <message>
        <source>Move the hand down</source>
        <translation>Hand nach unten schieben</translation>
    </message>
    <message>
        <source>Spread the fingers</source>
        <translation>Finger spreizen</translation>
    </message>
    <message>
        <source>Good: hold still</source>
        <translation>Gut: stillhalten</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Scan läuft</translation>
    </message>
    <message>
        <source>Keeping the capture</source>
        <translation>Aufnahme wird gespeichert</translation>
    </message>
</context>
<context>
    <name>dorsum::ScanPage</name>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Keep &amp;in…</source>
        <translation>Behalten &amp;in…</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>&amp;Before the device:</source>
        <translation>&amp;Vor dem Gerät:</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>Fortschritt des Scans</translation>
    </message>
    <message>
        <source>Quality of the fingers</source>
        <translation>Qualität der Finger</translation>
    </message>
    <message>
        <source>How much of each finger the surface covers, and the usual uncertainty of its heights</source>
        <translation>Wie viel von jedem Finger die Oberfläche abdeckt, und die übliche Unsicherheit ihrer Höhen</translation>
    </message>
    <message>
        <source>Throw this scan away and take another</source>
        <translation>Diesen Scan verwerfen und einen neuen machen</translation>
    </message>
    <message>
        <source>Scan when the hand has rested for a second; again when it has moved since</source>
        <translation>Scannen, wenn die Hand eine Sekunde ruht; erneut erst, wenn sie sich bewegt hat</translation>
    </message>
    <message>
        <source>The folder in which captures are kept, each in a folder of its own</source>
        <translation>Der Ordner, in dem Aufnahmen bleiben, jede in einem eigenen Ordner</translation>
    </message>
    <message>
        <source>Keep captures in</source>
        <translation>Aufnahmen behalten in</translation>
    </message>
    <message>
        <source>What lies before the virtual device</source>
        <translation>Was vor dem virtuellen Gerät liegt</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Anna&apos;s right hand</source>
        <translation>Annas rechte Hand</translation>
    </message>
    <message>
        <source>Anna&apos;s right hand, another day</source>
        <translation>Annas rechte Hand, an einem anderen Tag</translation>
    </message>
    <message>
        <source>Ben&apos;s left hand</source>
        <translation>Bens linke Hand</translation>
    </message>
    <message>
        <source>Ben&apos;s left hand, which moves</source>
        <translation>Bens linke Hand, die sich bewegt</translation>
    </message>
    <message>
        <source>a box, 25.5 mm high</source>
        <translation>ein Quader, 25,5 mm hoch</translation>
    </message>
    <message>
        <source>&amp;Open the virtual device</source>
        <translation>Das virtuelle Gerät &amp;öffnen</translation>
    </message>
    <message>
        <source>&amp;Connect again</source>
        <translation>Wieder &amp;verbinden</translation>
    </message>
    <message>
        <source>&amp;Calibrate this virtual device</source>
        <translation>Dieses virtuelle Gerät &amp;kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Open its calibration…</source>
        <translation>Seine Kalibrierung ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Scannen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>&amp;Next hand</source>
        <translation>&amp;Nächste Hand</translation>
    </message>
    <message>
        <source>Open the device&apos;s calibration</source>
        <translation>Kalibrierung des Geräts öffnen</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrierungen (*.json)</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>lamps</source>
        <translation>Lampen</translation>
    </message>
    <message>
        <source>lamps again</source>
        <translation>Lampen noch einmal</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>laser %1</source>
        <translation>Laser %1</translation>
    </message>
    <message>
        <source>Fingers: not told, since five cannot be separated</source>
        <translation>Finger: ohne Angabe, da sich keine fünf trennen lassen</translation>
    </message>
    <message>
        <source>finger %1: %2 % covered, ±%3 mm</source>
        <translation>Finger %1: %2 % abgedeckt, ±%3 mm</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>Is kept in %1</source>
        <translation>Wird gespeichert in %1</translation>
    </message>
</context>
<context>
    <name>dorsum::SectionPlot</name>
    <message>
        <source>along the line, mm</source>
        <translation>entlang der Linie, mm</translation>
    </message>
    <message>
        <source>height, mm</source>
        <translation>Höhe, mm</translation>
    </message>
    <message>
        <source>%1 mm along, %2 mm high</source>
        <translation>bei %1 mm, %2 mm hoch</translation>
    </message>
    <message>
        <source>Choose Section and two places of the surface: the cut through them is drawn here.</source>
        <translation>„Schnitt“ und zwei Stellen der Oberfläche wählen: der Schnitt durch sie wird hier gezeichnet.</translation>
    </message>
</context>
<context>
    <name>dorsum::StagesPage</name>
    <message>
        <source>Mask: difference</source>
        <translation>Maske: Differenz</translation>
    </message>
    <message>
        <source>Mask: threshold</source>
        <translation>Maske: Schwellwert</translation>
    </message>
    <message>
        <source>Mask: coarse</source>
        <translation>Maske: grob</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Mask: without shadow</source>
        <translation>Maske: ohne Schatten</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Laser %1: orders</source>
        <translation>Laser %1: Ordnungen</translation>
    </message>
    <message>
        <source>Laser %1: points</source>
        <translation>Laser %1: Punkte</translation>
    </message>
    <message>
        <source>Laser %1: edges</source>
        <translation>Laser %1: Kanten</translation>
    </message>
    <message>
        <source>Laser %1: stripes</source>
        <translation>Laser %1: Streifen</translation>
    </message>
    <message>
        <source>Laser %1: stripe points</source>
        <translation>Laser %1: Streifenpunkte</translation>
    </message>
    <message>
        <source>This chain ended early: %1. Take the last change back, or try other values.</source>
        <translation>Diese Kette endete vorzeitig: %1. Nehmen Sie die letzte Änderung zurück, oder versuchen Sie andere Werte.</translation>
    </message>
    <message>
        <source>%1 points, %2 faces, computed in %3 s</source>
        <translation>Punkte: %1, Dreiecke: %2, berechnet in %3 s</translation>
    </message>
    <message>
        <source>Parameters of both</source>
        <translation>Parameter beider</translation>
    </message>
    <message>
        <source>Show &amp;before</source>
        <translation>&amp;Vorher zeigen</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Berechnen</translation>
    </message>
    <message>
        <source>Stages of the chain</source>
        <translation>Stufen der Kette</translation>
    </message>
    <message>
        <source>A dot marks what the last change of a parameter changed</source>
        <translation>Ein Punkt markiert, was die letzte Änderung eines Parameters verändert hat</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>Shows the pictures of the parameters before the last change, to compare</source>
        <translation>Zeigt zum Vergleich die Bilder der Parameter vor der letzten Änderung</translation>
    </message>
    <message>
        <source>Computes the stages with the parameters as they are now</source>
        <translation>Berechnet die Stufen mit den jetzigen Parametern</translation>
    </message>
    <message>
        <source>The document&apos;s chain</source>
        <translation>Kette des Dokuments</translation>
    </message>
    <message>
        <source>Ours</source>
        <translation>Unsere</translation>
    </message>
    <message>
        <source>Wheel or + and −: zoom; mouse or arrows: move; 0: all of it</source>
        <translation>Mausrad oder + und −: Zoom; Maus oder Pfeile: verschieben; 0: alles</translation>
    </message>
    <message>
        <source>Figures: %1</source>
        <translation>Zahlen: %1</translation>
    </message>
    <message>
        <source>Comparing the stages</source>
        <translation>Stufen werden verglichen</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>verändert</translation>
    </message>
    <message>
        <source>Scan a hand, or open a calibration and a capture folder (File menu): its stages are shown here.</source>
        <translation>Scannen Sie eine Hand, oder öffnen Sie eine Kalibrierung und den Ordner einer Aufnahme (Menü Datei): ihre Stufen sind hier zu sehen.</translation>
    </message>
    <message>
        <source>Only a surface is open, which has no stages. Open a capture folder (File menu).</source>
        <translation>Nur eine Oberfläche ist offen, die keine Stufen hat. Öffnen Sie den Ordner einer Aufnahme (Menü Datei).</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>The stages come when the other work is done.</source>
        <translation>Die Stufen kommen, wenn die andere Arbeit getan ist.</translation>
    </message>
    <message>
        <source>The computation was stopped. Compute begins it again.</source>
        <translation>Die Berechnung wurde angehalten. „Berechnen“ beginnt sie neu.</translation>
    </message>
    <message>
        <source>Before the last change of the parameters.</source>
        <translation>Vor der letzten Änderung der Parameter.</translation>
    </message>
    <message>
        <source>Computing with the new parameters…</source>
        <translation>Berechnung mit den neuen Parametern…</translation>
    </message>
    <message>
        <source>The parameters changed.</source>
        <translation>Die Parameter haben sich geändert.</translation>
    </message>
    <message>
        <source>The computation was stopped: these pictures are of other parameters.</source>
        <translation>Die Berechnung wurde angehalten: diese Bilder gehören zu anderen Parametern.</translation>
    </message>
    <message>
        <source>The last change of the parameters changed no picture.</source>
        <translation>Die letzte Änderung der Parameter hat kein Bild verändert.</translation>
    </message>
    <message numerus="yes">
        <source>The last change of the parameters changed %n picture(s); a dot marks them in the list.</source>
        <translation>
            <numerusform>Die letzte Änderung der Parameter hat %n Bild verändert; ein Punkt markiert es in der Liste.</numerusform>
            <numerusform>Die letzte Änderung der Parameter hat %n Bilder verändert; ein Punkt markiert sie in der Liste.</numerusform>
        </translation>
    </message>
    <message>
        <source>This chain ended before this stage.</source>
        <translation>Diese Kette endete vor dieser Stufe.</translation>
    </message>
    <message>
        <source>This chain has no such stage.</source>
        <translation>Diese Kette hat keine solche Stufe.</translation>
    </message>
    <message>
        <source>Busy part</source>
        <translation>Belegter Teil</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceControls</name>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Com&amp;pare…</source>
        <translation>&amp;Vergleichen…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>The mesh, the points of the stripes, or both</source>
        <translation>Das Netz, die Punkte der Laserstreifen oder beides</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Mesh and points</source>
        <translation>Netz und Punkte</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>What the colours of the surface mean</source>
        <translation>Was die Farben der Oberfläche bedeuten</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Order of the stripe</source>
        <translation>Beugungsordnung</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Uncertainty of z</source>
        <translation>Unsicherheit von z</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Shaded only</source>
        <translation>Nur schattiert</translation>
    </message>
    <message>
        <source>&amp;Show:</source>
        <translation>&amp;Zeigen:</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Farben:</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Stelle</translation>
    </message>
    <message>
        <source>Say where a place lies and which stripe runs there</source>
        <translation>Sagen, wo eine Stelle liegt und welcher Laserstreifen dort läuft</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>Two places: how far along the surface, and straight</source>
        <translation>Zwei Stellen: wie weit entlang der Oberfläche und geradeaus</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>S&amp;chnitt</translation>
    </message>
    <message>
        <source>Two places: the upright cut through both, as a curve</source>
        <translation>Zwei Stellen: der senkrechte Schnitt durch beide, als Kurve</translation>
    </message>
    <message>
        <source>Clear the measure</source>
        <translation>Messung löschen</translation>
    </message>
    <message>
        <source>Take the chosen places away</source>
        <translation>Die gewählten Stellen wegnehmen</translation>
    </message>
    <message>
        <source>Compare with another surface</source>
        <translation>Mit einer anderen Oberfläche vergleichen</translation>
    </message>
    <message>
        <source>Colours show how far this surface lies above or below that of another PLY file</source>
        <translation>Farben zeigen, wie weit diese Oberfläche über oder unter der einer anderen PLY-Datei liegt</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the surface as PLY, OBJ, STL or GLB, or the view as PNG</source>
        <translation>Die Oberfläche als PLY, OBJ, STL oder GLB schreiben, oder die Ansicht als PNG</translation>
    </message>
    <message>
        <source>Difference to %1</source>
        <translation>Unterschied zu %1</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceFiles</name>
    <message>
        <source>Compare with a surface</source>
        <translation>Mit einer Oberfläche vergleichen</translation>
    </message>
    <message>
        <source>Surfaces (*.ply)</source>
        <translation>Oberflächen (*.ply)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>PLY (*.ply);;OBJ (*.obj);;STL (*.stl);;GLB (*.glb);;Picture (*.png)</source>
        <translation>PLY (*.ply);;OBJ (*.obj);;STL (*.stl);;GLB (*.glb);;Bild (*.png)</translation>
    </message>
    <message>
        <source>PLY (*.ply);;Picture (*.png)</source>
        <translation>PLY (*.ply);;Bild (*.png)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceImage</name>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The image with its stripes; a click or Enter picks a stripe, the wheel, + and - zoom, Home shows all</source>
        <translation>Das Bild mit seinen Laserstreifen; Klick oder Eingabe wählt einen Streifen, Rad, + und - vergrößern und verkleinern, Pos1 zeigt alles</translation>
    </message>
    <message>
        <source>Image that is shown</source>
        <translation>Bild, das gezeigt wird</translation>
    </message>
    <message>
        <source>Which of the capture&apos;s images, and whose stripes</source>
        <translation>Welches der Bilder der Aufnahme, und wessen Laserstreifen</translation>
    </message>
    <message>
        <source>&amp;Image:</source>
        <translation>&amp;Bild:</translation>
    </message>
    <message>
        <source>All stripes</source>
        <translation>Alle Laserstreifen</translation>
    </message>
    <message>
        <source>LEDs, all stripes</source>
        <translation>LEDs, alle Laserstreifen</translation>
    </message>
    <message>
        <source>Laser %1</source>
        <translation>Laser %1</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceMeasurer</name>
    <message>
        <source>Measuring along the surface</source>
        <translation>Messung entlang der Oberfläche</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfacePage</name>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Drag or arrow keys turn; Shift moves; wheel, + and - zoom; Home shows all; a click or Enter picks a place</source>
        <translation>Ziehen oder Pfeiltasten drehen; Umschalt verschiebt; Rad, + und - vergrößern und verkleinern; Pos1 zeigt alles; Klick oder Eingabe wählt eine Stelle</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>The cut through the two places</source>
        <translation>Der Schnitt durch die beiden Stellen</translation>
    </message>
    <message>
        <source>Scale of the colours</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>No surface</source>
        <translation>Keine Oberfläche</translation>
    </message>
    <message>
        <source>No surface yet. Scan a hand, open a capture folder or a PLY file, or drop one here.</source>
        <translation>Noch keine Oberfläche. Scannen Sie eine Hand, öffnen Sie den Ordner einer Aufnahme oder eine PLY-Datei, oder ziehen Sie eines davon hierher.</translation>
    </message>
    <message>
        <source>Colouring the surface</source>
        <translation>Oberfläche wird gefärbt</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 mm</source>
        <translation>x %1, y %2, z %3 mm</translation>
    </message>
    <message>
        <source>; image %1, %2 px</source>
        <translation>; Bild %1, %2 px</translation>
    </message>
    <message>
        <source>; stripe of laser %1, order %2</source>
        <translation>; Streifen von Laser %1, Beugungsordnung %2</translation>
    </message>
    <message>
        <source>; one standard deviation of z %1 mm</source>
        <translation>; eine Standardabweichung von z %1 mm</translation>
    </message>
    <message>
        <source>Straight %1 mm</source>
        <translation>Geradeaus %1 mm</translation>
    </message>
    <message>
        <source>, along the surface %1 mm</source>
        <translation>, entlang der Oberfläche %1 mm</translation>
    </message>
    <message>
        <source>; points alone have no way along a surface</source>
        <translation>; Punkte allein haben keinen Weg entlang einer Oberfläche</translation>
    </message>
    <message>
        <source>, measuring along the surface…</source>
        <translation>, Messung entlang der Oberfläche läuft…</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln point(s)</source>
        <translation>
            <numerusform>%Ln Punkt</numerusform>
            <numerusform>%Ln Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln Dreieck</numerusform>
            <numerusform>%Ln Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>Click a place of the surface or a stripe of the image.</source>
        <translation>Klicken Sie auf eine Stelle der Oberfläche oder einen Streifen im Bild.</translation>
    </message>
    <message>
        <source>Click the first of two places.</source>
        <translation>Klicken Sie auf die erste von zwei Stellen.</translation>
    </message>
    <message>
        <source>Click the second place.</source>
        <translation>Klicken Sie auf die zweite Stelle.</translation>
    </message>
    <message>
        <source>Against %1: mean %2 mm, RMS %3 mm; places compared: %L4, outside it: %L5</source>
        <translation>Gegen %1: Mittel %2 mm, RMS %3 mm; verglichene Stellen: %L4, außerhalb: %L5</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceView</name>
    <message>
        <source>this display has no OpenGL 3.3, so the surface cannot be drawn; measuring and export of files work without it</source>
        <translation>dieser Bildschirm hat kein OpenGL 3.3, darum kann die Oberfläche nicht gezeichnet werden; Messen und Exportieren von Dateien gehen auch ohne</translation>
    </message>
</context>
<context>
    <name>dorsum::TurningSurface</name>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
</context>
<context>
    <name>dorsum::VirtualSession</name>
    <message>
        <source>Laying something before the device</source>
        <translation>Etwas wird vor das Gerät gelegt</translation>
    </message>
    <message>
        <source>Calibrating the virtual device</source>
        <translation>Virtuelles Gerät wird kalibriert</translation>
    </message>
</context>
<context>
    <name>dorsum::Workbench</name>
    <message>
        <source>Reading the calibration</source>
        <translation>Kalibrierung wird gelesen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
</context>
<context>
    <name>library</name>
    <message>
        <source>Lay the chessboard flat on the backplane, its middle on the central stripe of laser %1 and its rows across the stripes.</source>
        <translation>Legen Sie das Schachbrett flach auf die Grundplatte, seine Mitte auf den mittleren Streifen von Laser %1 und seine Reihen quer zu den Streifen.</translation>
    </message>
    <message>
        <source>Hold the chessboard raised and tilted by 10 to 25 degrees, another way than before, all of it in the picture.</source>
        <translation>Halten Sie das Schachbrett angehoben und um 10 bis 25 Grad gekippt, anders als zuvor, ganz im Bild.</translation>
    </message>
    <message>
        <source>Clear the backplane.</source>
        <translation>Räumen Sie die Grundplatte frei.</translation>
    </message>
    <message>
        <source>Lay the chessboard flat on the backplane, its middle on the central stripe of laser %1, which is on now.</source>
        <translation>Legen Sie das Schachbrett flach auf die Grundplatte, seine Mitte auf den mittleren Streifen von Laser %1, der jetzt an ist.</translation>
    </message>
    <message>
        <source>Lay the sheet with one line for each laser on the backplane, the lines on the central stripes.</source>
        <translation>Legen Sie das Blatt mit einer Linie je Laser auf die Grundplatte, die Linien auf die mittleren Streifen.</translation>
    </message>
    <message>
        <source>Put the calibration object of %1 mm on the backplane; it must fill the picture.</source>
        <translation>Stellen Sie den Kalibrierkörper von %1 mm auf die Grundplatte; er muss das Bild füllen.</translation>
    </message>
    <message>
        <source>Lay the chessboard flat on the calibration object, its middle on the central stripe of laser %1, which is on now.</source>
        <translation>Legen Sie das Schachbrett flach auf den Kalibrierkörper, seine Mitte auf den mittleren Streifen von Laser %1, der jetzt an ist.</translation>
    </message>
    <message>
        <source>Put the box of %1 mm on the empty backplane, in the middle of the picture.</source>
        <translation>Stellen Sie den Quader von %1 mm auf die leere Grundplatte, in die Mitte des Bildes.</translation>
    </message>
    <message>
        <source>Again: %1. %2</source>
        <translation>Noch einmal: %1. %2</translation>
    </message>
    <message>
        <source>the chessboard of %1 x %2 inner corners is not seen whole</source>
        <translation>das Schachbrett mit %1 x %2 inneren Ecken ist nicht ganz zu sehen</translation>
    </message>
    <message>
        <source>the chessboard lies as it did before</source>
        <translation>das Schachbrett liegt wie zuvor</translation>
    </message>
    <message>
        <source>Chessboard %1 of %2: the boards cover %3 % of the picture; least at the %4.</source>
        <translation>Schachbrett %1 von %2: die Bretter decken %3 % des Bildes ab; am wenigsten: %4.</translation>
    </message>
    <message>
        <source>Chessboard %1 of %2: the boards cover %3 % of the picture.</source>
        <translation>Schachbrett %1 von %2: die Bretter decken %3 % des Bildes ab.</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>known heights</source>
        <translation>bekannte Höhen</translation>
    </message>
    <message>
        <source>surface error correction</source>
        <translation>Korrektur der Oberflächenfehler</translation>
    </message>
    <message>
        <source>laser %1</source>
        <translation>Laser %1</translation>
    </message>
    <message>
        <source>the camera model explains all chessboards</source>
        <translation>das Kameramodell erklärt alle Schachbretter</translation>
    </message>
    <message>
        <source>the corners do not fit; capture the chessboards again with a flat board and a sharp picture</source>
        <translation>die Ecken passen nicht; nehmen Sie die Schachbretter mit einem ebenen Brett und scharfem Bild noch einmal auf</translation>
    </message>
    <message>
        <source>the corners do not fit well, worst in %1</source>
        <translation>die Ecken passen nicht gut, am schlechtesten in %1</translation>
    </message>
    <message>
        <source>is the board flat, sharp and still?</source>
        <translation>ist das Brett eben, scharf und still?</translation>
    </message>
    <message>
        <source>the board is flat</source>
        <translation>das Brett ist eben</translation>
    </message>
    <message>
        <source>the board is not flat: its corners lie %1 mm off its middle</source>
        <translation>das Brett ist nicht eben: seine Ecken liegen %1 mm neben der Ebene seiner Mitte</translation>
    </message>
    <message>
        <source>that bow was taken into account, but mount the board on something flat</source>
        <translation>die Wölbung wurde berücksichtigt, aber befestigen Sie das Brett auf etwas Ebenem</translation>
    </message>
    <message>
        <source>all heights fit as they were given</source>
        <translation>alle Höhen passen wie angegeben</translation>
    </message>
    <message>
        <source>the height of %1 is given as %2 mm, fits %3 mm</source>
        <translation>die Höhe von %1 ist mit %2 mm angegeben, passend wären %3 mm</translation>
    </message>
    <message>
        <source>what fits was used, so measure it and correct setup.json</source>
        <translation>verwendet wurde, was passt; messen Sie nach und berichtigen Sie setup.json</translation>
    </message>
    <message>
        <source>cones explain all stripes</source>
        <translation>Kegel erklären alle Laserstreifen</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees, too little to tell its form</source>
        <translation>der Fächer neigt sich um %1 Grad, zu wenig, um seine Form zu bestimmen</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees and is flat, as it leaves a laser</source>
        <translation>der Fächer neigt sich um %1 Grad und ist eben, wie er einen Laser verlässt</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees and has one cosine all along (a cone before the grating)</source>
        <translation>der Fächer neigt sich um %1 Grad und hat überall denselben Kosinus (ein Kegel vor dem Gitter)</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees and is bowed, neither flat nor a cone</source>
        <translation>der Fächer neigt sich um %1 Grad und ist gewölbt, weder eben noch ein Kegel</translation>
    </message>
    <message>
        <source>the second-order correction explains the boxes</source>
        <translation>die Korrektur zweiter Ordnung erklärt die Quader</translation>
    </message>
    <message>
        <source>views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>boards that lie on known heights</source>
        <translation>Bretter auf bekannten Höhen</translation>
    </message>
    <message>
        <source>reprojection error</source>
        <translation>Reprojektionsfehler</translation>
    </message>
    <message>
        <source>worst view</source>
        <translation>schlechteste Ansicht</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>principal point</source>
        <translation>Bildhauptpunkt</translation>
    </message>
    <message>
        <source>camera height</source>
        <translation>Kamerahöhe</translation>
    </message>
    <message>
        <source>stripe points</source>
        <translation>Streifenpunkte</translation>
    </message>
    <message>
        <source>sheet residual</source>
        <translation>Restfehler der Lichtflächen</translation>
    </message>
    <message>
        <source>pattern left</source>
        <translation>verbliebenes Muster</translation>
    </message>
    <message>
        <source>height uncertainty by calibration</source>
        <translation>Höhenunsicherheit durch die Kalibrierung</translation>
    </message>
    <message>
        <source>grating x</source>
        <translation>Gitter x</translation>
    </message>
    <message>
        <source>grating height</source>
        <translation>Gitterhöhe</translation>
    </message>
    <message>
        <source>order step</source>
        <translation>Ordnungsschritt</translation>
    </message>
    <message>
        <source>fan distance</source>
        <translation>Fächerabstand</translation>
    </message>
    <message>
        <source>fan tilt</source>
        <translation>Fächerneigung</translation>
    </message>
    <message>
        <source>fan bow</source>
        <translation>Fächerwölbung</translation>
    </message>
    <message>
        <source>sag of the corners</source>
        <translation>Durchbiegung der Ecken</translation>
    </message>
    <message>
        <source>sag, in standard deviations</source>
        <translation>Durchbiegung, in Standardabweichungen</translation>
    </message>
    <message>
        <source>%1, uncertainty</source>
        <translation>%1, Unsicherheit</translation>
    </message>
    <message>
        <source>%1: given</source>
        <translation>%1: angegeben</translation>
    </message>
    <message>
        <source>%1: fits</source>
        <translation>%1: passt</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1: Unsicherheit</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>serial ports</source>
        <translation>serielle Anschlüsse</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>Festplatte</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>light controller</source>
        <translation>Lichtsteuerung</translation>
    </message>
    <message>
        <source>daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>LEDs</source>
        <translation>LEDs</translation>
    </message>
    <message>
        <source>virtual camera</source>
        <translation>virtuelle Kamera</translation>
    </message>
    <message>
        <source>virtual light controller</source>
        <translation>virtuelle Lichtsteuerung</translation>
    </message>
    <message>
        <source>virtual light controller, firmware virtual</source>
        <translation>virtuelle Lichtsteuerung, Firmware virtual</translation>
    </message>
    <message>
        <source>virtual camera, %1 x %2 pixels</source>
        <translation>virtuelle Kamera, %1 x %2 Pixel</translation>
    </message>
    <message>
        <source>this machine has no camera</source>
        <translation>dieser Rechner hat keine Kamera</translation>
    </message>
    <message>
        <source>plug one in; a network camera or virtual needs none</source>
        <translation>schließen Sie eine an; eine Netzwerkkamera oder virtual braucht keine</translation>
    </message>
    <message>
        <source>no serial port of a USB device is there</source>
        <translation>kein serieller Anschluss eines USB-Geräts ist da</translation>
    </message>
    <message>
        <source>plug the light controller in; virtual needs none</source>
        <translation>schließen Sie die Lichtsteuerung an; virtual braucht keine</translation>
    </message>
    <message>
        <source>%1 may be used</source>
        <translation>%1 darf benutzt werden</translation>
    </message>
    <message>
        <source>%1 may not be used by you</source>
        <translation>%1 dürfen Sie nicht benutzen</translation>
    </message>
    <message>
        <source>%1 GB are free at %2</source>
        <translation>%1 GB sind frei unter %2</translation>
    </message>
    <message>
        <source>make room: a capture takes some megabytes</source>
        <translation>schaffen Sie Platz: eine Aufnahme braucht einige Megabyte</translation>
    </message>
    <message>
        <source>%1 is %2 days old, made by version %3 with method %4</source>
        <translation>%1 ist %2 Tage alt, erstellt von Version %3 mit Methode %4</translation>
    </message>
    <message>
        <source>the check below says whether it still fits</source>
        <translation>die Prüfung unten sagt, ob sie noch passt</translation>
    </message>
    <message>
        <source>calibrate the device</source>
        <translation>kalibrieren Sie das Gerät</translation>
    </message>
    <message>
        <source>calibrate this device</source>
        <translation>kalibrieren Sie dieses Gerät</translation>
    </message>
    <message>
        <source>little light comes from elsewhere</source>
        <translation>wenig Licht kommt von anderswo</translation>
    </message>
    <message>
        <source>they light the picture</source>
        <translation>sie beleuchten das Bild</translation>
    </message>
    <message>
        <source>it lights its stripes</source>
        <translation>er zeichnet seine Laserstreifen</translation>
    </message>
    <message>
        <source>it is of a camera of %1 x %2 pixels</source>
        <translation>sie gehört zu einer Kamera mit %1 x %2 Pixeln</translation>
    </message>
    <message>
        <source>its stripes lie %1 px from where the calibration has them (%2 points)</source>
        <translation>seine Streifen liegen %1 px neben denen der Kalibrierung (%2 Punkte)</translation>
    </message>
    <message>
        <source>camera, laser or backplane moved: calibrate again</source>
        <translation>Kamera, Laser oder Grundplatte hat sich bewegt: neu kalibrieren</translation>
    </message>
    <message>
        <source>clear the backplane and ask again; if it is clear, calibrate again</source>
        <translation>räumen Sie die Grundplatte frei und fragen Sie noch einmal; ist sie frei, kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>something else is being done; wait for it, or cancel it</source>
        <translation>etwas anderes läuft gerade; warten Sie darauf, oder brechen Sie es ab</translation>
    </message>
    <message>
        <source>no device is open; choose one on the device page</source>
        <translation>kein Gerät ist offen; wählen Sie eines auf der Geräteseite</translation>
    </message>
    <message>
        <source>no device is open; open one on the device page, or calibrate from a folder that holds a series</source>
        <translation>kein Gerät ist offen; öffnen Sie eines auf der Geräteseite, oder kalibrieren Sie aus einem Ordner mit einer Serie</translation>
    </message>
    <message>
        <source>no device is named; choose a device.toml, or write virtual</source>
        <translation>kein Gerät ist genannt; wählen Sie eine device.toml, oder schreiben Sie virtual</translation>
    </message>
    <message>
        <source>there is no surface to export; scan or open one first</source>
        <translation>es gibt keine Oberfläche zu exportieren; scannen oder öffnen Sie zuerst eine</translation>
    </message>
    <message>
        <source>only points are open and .%1 files hold meshes; export them as .ply</source>
        <translation>nur Punkte sind offen, und .%1-Dateien enthalten Netze; exportieren Sie sie als .ply</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not say which file to write; end it with .ply, .obj, .stl, .glb or .png</source>
        <translation>„%1“ sagt nicht, welche Datei zu schreiben ist; lassen Sie den Namen auf .ply, .obj, .stl, .glb oder .png enden</translation>
    </message>
    <message>
        <source>a capture needs the calibration of its device; open a calibration.json first</source>
        <translation>eine Aufnahme braucht die Kalibrierung ihres Geräts; öffnen Sie zuerst eine calibration.json</translation>
    </message>
    <message>
        <source>%1 is neither a capture folder nor a PLY file; drop one of those</source>
        <translation>%1 ist weder der Ordner einer Aufnahme noch eine PLY-Datei; ziehen Sie eines davon hierher</translation>
    </message>
    <message>
        <source>what was dropped is no file of this machine; drop a capture folder or a PLY file</source>
        <translation>was hierhergezogen wurde, ist keine Datei dieses Rechners; ziehen Sie den Ordner einer Aufnahme oder eine PLY-Datei hierher</translation>
    </message>
    <message>
        <source>laser %1: height error before</source>
        <translation>Laser %1: Höhenfehler vorher</translation>
    </message>
    <message>
        <source>laser %1: height error after</source>
        <translation>Laser %1: Höhenfehler nachher</translation>
    </message>
    <message>
        <source>laser %1: points</source>
        <translation>Laser %1: Punkte</translation>
    </message>
    <message>
        <source>how the object is found in the image (§3.4)</source>
        <translation>wie das Objekt im Bild gefunden wird (§3.4)</translation>
    </message>
    <message>
        <source>how stripes are located (§3.4)</source>
        <translation>wie Laserstreifen lokalisiert werden (§3.4)</translation>
    </message>
    <message>
        <source>how stripes get their orders (§3.5)</source>
        <translation>wie Laserstreifen ihre Beugungsordnung bekommen (§3.5)</translation>
    </message>
    <message>
        <source>whether the surface&apos;s brightness is taken off the stripes&apos; centres (ridges)</source>
        <translation>ob die Helligkeit der Oberfläche aus den Streifenmitten herausgerechnet wird (ridge)</translation>
    </message>
    <message>
        <source>model of a light sheet (§3.6)</source>
        <translation>Modell einer Lichtfläche (§3.6)</translation>
    </message>
    <message>
        <source>surface error correction of plane sheets (3.9)</source>
        <translation>Korrektur der Oberflächenfehler ebener Lichtflächen (3.9)</translation>
    </message>
    <message>
        <source>how the lasers are merged</source>
        <translation>wie die Laser zusammengeführt werden</translation>
    </message>
    <message>
        <source>a stripe keeps its order where any other costs this much more (joint)</source>
        <translation>ein Streifen behält seine Ordnung, wo jede andere um so viel mehr kostet (joint)</translation>
    </message>
    <message>
        <source>the same for a whole surface</source>
        <translation>dasselbe für eine ganze Oberfläche</translation>
    </message>
    <message>
        <source>how far the surface goes on beyond the last points, mm (robust)</source>
        <translation>wie weit die Oberfläche über die letzten Punkte hinausgeht, mm (robust)</translation>
    </message>
    <message>
        <source>widest gap between points that closes, mm (robust)</source>
        <translation>breiteste Lücke zwischen Punkten, die sich schließt, mm (robust)</translation>
    </message>
    <message>
        <source>a point further from the surface than this, mm, and than … (robust)</source>
        <translation>ein Punkt, der weiter von der Oberfläche liegt als dies, mm, und als … (robust)</translation>
    </message>
    <message>
        <source>… that many of its sigma is left out (robust)</source>
        <translation>… so viele seiner Sigma, wird weggelassen (robust)</translation>
    </message>
    <message>
        <source>side of the mask&apos;s opening, px</source>
        <translation>Seitenlänge des Fensters beim Öffnen der Maske (Morphologie), px</translation>
    </message>
    <message>
        <source>least contrast of the object, 255ths of the background</source>
        <translation>kleinster Kontrast des Objekts, in 255steln des Hintergrunds</translation>
    </message>
    <message>
        <source>window of the stripes&apos; adaptive threshold, px</source>
        <translation>Fenster des adaptiven Schwellwerts der Streifen, px</translation>
    </message>
    <message>
        <source>edge response above its local mean, grey values</source>
        <translation>Kantenantwort über ihrem lokalen Mittelwert, Grauwerte</translation>
    </message>
    <message>
        <source>side of the stripe mask&apos;s median, px</source>
        <translation>Fenster des Medianfilters der Streifenmaske, px</translation>
    </message>
    <message>
        <source>smallest stripe region, px</source>
        <translation>kleinstes Streifengebiet, px</translation>
    </message>
    <message>
        <source>shortest stripe, px</source>
        <translation>kürzester Streifen, px</translation>
    </message>
    <message>
        <source>rows on either side smoothed together, px</source>
        <translation>Zeilen auf jeder Seite, die gemeinsam geglättet werden, px</translation>
    </message>
    <message>
        <source>jump that parts a stripe, px</source>
        <translation>Sprung, der einen Streifen teilt, px</translation>
    </message>
    <message>
        <source>V of Algorithm 2, in usual spacings</source>
        <translation>V aus Algorithmus 2, in üblichen Abständen</translation>
    </message>
    <message>
        <source>share of the central order&apos;s contrast that a level must show to be central</source>
        <translation>Anteil am Kontrast der mittleren Ordnung, den eine Stufe zeigen muss, um die mittlere zu sein</translation>
    </message>
    <message>
        <source>grid of the height field, mm; robust fusion&apos;s mesh has a node each 1.25 of it</source>
        <translation>Raster des Höhenfelds, mm; das Netz der robusten Fusion hat alle 1,25 davon einen Knoten</translation>
    </message>
    <message>
        <source>widest gap between stripes that is bridged, mm</source>
        <translation>breiteste Lücke zwischen Streifen, die überbrückt wird, mm</translation>
    </message>
    <message>
        <source>steepest surface between stripes, degrees</source>
        <translation>steilste Oberfläche zwischen Streifen, Grad</translation>
    </message>
    <message>
        <source>no device is open; open one on the Device page, then capture</source>
        <translation>kein Gerät ist offen; öffnen Sie eines auf der Geräteseite, und nehmen Sie dann auf</translation>
    </message>
    <message>
        <source>cannot write %1: %2; choose a folder that you may write to and that has room</source>
        <translation>%1 kann nicht geschrieben werden: %2; wählen Sie einen Ordner, in den Sie schreiben dürfen und in dem Platz ist</translation>
    </message>
    <message>
        <source>cannot write %1: %2; make room or choose a folder that you may write to</source>
        <translation>%1 kann nicht geschrieben werden: %2; schaffen Sie Platz, oder wählen Sie einen Ordner, in den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>cannot write %1: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>cannot write to %1: %2</source>
        <translation>in %1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>cannot write to %1: it is a file, and a folder is needed</source>
        <translation>in %1 kann nicht geschrieben werden: es ist eine Datei, und ein Ordner wird gebraucht</translation>
    </message>
    <message>
        <source>cannot write %1: it is a folder; name a file in it</source>
        <translation>%1 kann nicht geschrieben werden: es ist ein Ordner; nennen Sie eine Datei darin</translation>
    </message>
    <message>
        <source>cannot write %1: there is no folder %2; make it, or choose another</source>
        <translation>%1 kann nicht geschrieben werden: den Ordner %2 gibt es nicht; legen Sie ihn an, oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>cannot write the calibration to %1: its report takes that name; name a .json file</source>
        <translation>die Kalibrierung kann nicht in %1 geschrieben werden: ihr Bericht bekommt diesen Namen; nennen Sie eine .json-Datei</translation>
    </message>
    <message>
        <source>cannot read %1: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>cannot read the folder %1: %2</source>
        <translation>der Ordner %1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>the folder %1 cannot be read: %2</source>
        <translation>der Ordner %1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>cannot make the folder %1: %2</source>
        <translation>der Ordner %1 kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>cannot rename %1: %2</source>
        <translation>%1 kann nicht umbenannt werden: %2</translation>
    </message>
    <message>
        <source>cannot remove %1: %2</source>
        <translation>%1 kann nicht gelöscht werden: %2</translation>
    </message>
    <message>
        <source>cannot replace %1: %2</source>
        <translation>%1 kann nicht ersetzt werden: %2</translation>
    </message>
    <message>
        <source>cannot put back %1: %2</source>
        <translation>%1 kann nicht zurückgeholt werden: %2</translation>
    </message>
    <message>
        <source>cannot set the time of %1: %2</source>
        <translation>die Zeit von %1 kann nicht gesetzt werden: %2</translation>
    </message>
    <message>
        <source>there is no file %1</source>
        <translation>die Datei %1 gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 ist keine Datei</translation>
    </message>
    <message>
        <source>%1 is %2 bytes; at most %3 are expected here</source>
        <translation>%1 hat %2 Byte; höchstens %3 werden hier erwartet</translation>
    </message>
    <message>
        <source>%1 cannot be written to</source>
        <translation>in %1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>choose another folder, or ask for the right to write there</source>
        <translation>wählen Sie einen anderen Ordner, oder bitten Sie um das Recht, dort zu schreiben</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>das Kontingent des Datenträgers ist erschöpft</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>die Datei wird zu groß</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>die Datei gibt es schon</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>es ist kein Ordner</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>der Ordner ist nicht leer</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger ist nur lesbar</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>der Datenträger oder das Gerät antwortet falsch</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>das Netzlaufwerk ist nicht mehr da</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>es wird gerade benutzt</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>das Gerät ist nicht mehr da</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>das Gerät ist nicht mehr da</translation>
    </message>
    <message>
        <source>%1 is not valid JSON; write it again or restore it</source>
        <translation>%1 ist kein gültiges JSON; schreiben Sie es neu, oder stellen Sie es wieder her</translation>
    </message>
    <message>
        <source>%1 is not valid JSON (it holds NaN or Infinity); write it again or restore it</source>
        <translation>%1 ist kein gültiges JSON (es enthält NaN oder Infinity); schreiben Sie es neu, oder stellen Sie es wieder her</translation>
    </message>
    <message>
        <source>%1 is not valid JSON; restore it from a copy</source>
        <translation>%1 ist kein gültiges JSON; stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1 is not valid JSON; calibrate again</source>
        <translation>%1 ist kein gültiges JSON; kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>%1: a JSON object is expected</source>
        <translation>%1: ein JSON-Objekt wird erwartet</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is missing</source>
        <translation>%1: „%2“ fehlt</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a number between %3 and %4, not %5</source>
        <translation>%1: „%2“ muss eine Zahl zwischen %3 und %4 sein, nicht %5</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a whole number</source>
        <translation>%1: „%2“ muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a text</source>
        <translation>%1: „%2“ muss ein Text sein</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be true or false</source>
        <translation>%1: „%2“ muss true oder false sein</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a list of %3 numbers</source>
        <translation>%1: „%2“ muss eine Liste von %3 Zahlen sein</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a list of numbers</source>
        <translation>%1: „%2“ muss eine Liste von Zahlen sein</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must hold numbers between %3 and %4, not %5</source>
        <translation>%1: „%2“ muss Zahlen zwischen %3 und %4 enthalten, nicht %5</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be an object</source>
        <translation>%1: „%2“ muss ein Objekt sein</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a list of at most %3 entries</source>
        <translation>%1: „%2“ muss eine Liste von höchstens %3 Einträgen sein</translation>
    </message>
    <message>
        <source>%1 is not a %2 file</source>
        <translation>%1 ist keine %2-Datei</translation>
    </message>
    <message>
        <source>%1 is not a %2 file but a %3 file</source>
        <translation>%1 ist keine %2-Datei, sondern eine %3-Datei</translation>
    </message>
    <message>
        <source>%1: &apos;version&apos; is %2, newer than this program reads (%3); use a newer program</source>
        <translation>%1: „version“ ist %2, neuer, als dieses Programm liest (%3); benutzen Sie ein neueres Programm</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: unknown key %2; known here: %3</source>
        <translation>%1: unbekannter Schlüssel %2; bekannt sind hier: %3</translation>
    </message>
    <message>
        <source>%1: %2 is %3; it must be %4</source>
        <translation>%1: %2 ist %3; es muss %4 sein</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>a list of %1 numbers from %2 to %3</source>
        <translation>eine Liste von %1 Zahlen von %2 bis %3</translation>
    </message>
    <message>
        <source>a list of 1 to %1 numbers from %2 to %3</source>
        <translation>eine Liste von 1 bis %1 Zahlen von %2 bis %3</translation>
    </message>
    <message>
        <source>0 (left as it is) or from %1 to %2</source>
        <translation>0 (bleibt, wie es ist) oder von %1 bis %2</translation>
    </message>
    <message>
        <source>0 (none) or from %1 to %2</source>
        <translation>0 (keine) oder von %1 bis %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or &quot;%2&quot;</source>
        <translation>&quot;%1&quot; oder &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1: %2; write the file again</source>
        <translation>%1: %2; schreiben Sie die Datei neu</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>it is not a PLY file</source>
        <translation>es ist keine PLY-Datei</translation>
    </message>
    <message>
        <source>its format is %1, not binary_little_endian</source>
        <translation>ihr Format ist %1, nicht binary_little_endian</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>ihr Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>its vertices have no property &apos;%1&apos;</source>
        <translation>ihren Eckpunkten fehlt die Eigenschaft „%1“</translation>
    </message>
    <message>
        <source>a face has %1 corners</source>
        <translation>eine Fläche hat %1 Ecken</translation>
    </message>
    <message>
        <source>it does not begin with vertices</source>
        <translation>sie beginnt nicht mit Eckpunkten</translation>
    </message>
    <message>
        <source>point %1 is not a number</source>
        <translation>Punkt %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>point %1 has no such laser or order</source>
        <translation>Laser oder Ordnung von Punkt %1 gibt es nicht</translation>
    </message>
    <message>
        <source>vertex %1 is not a number</source>
        <translation>Eckpunkt %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>it has faces that are not triangles</source>
        <translation>sie hat Flächen, die keine Dreiecke sind</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>eine Fläche nennt einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>the surface is empty, so there is no mesh to write to %1</source>
        <translation>die Oberfläche ist leer, es gibt also kein Netz, das nach %1 zu schreiben wäre</translation>
    </message>
    <message>
        <source>the view could not be made a picture</source>
        <translation>aus der Ansicht konnte kein Bild werden</translation>
    </message>
    <message>
        <source>the two places lie on parts of the surface that do not touch; choose two on one part</source>
        <translation>die beiden Stellen liegen auf Teilen der Oberfläche, die einander nicht berühren; wählen Sie zwei auf einem Teil</translation>
    </message>
    <message>
        <source>the two places stand one above the other; choose two that lie side by side</source>
        <translation>die beiden Stellen liegen übereinander; wählen Sie zwei, die nebeneinander liegen</translation>
    </message>
    <message>
        <source>the camera %1</source>
        <translation>die Kamera %1</translation>
    </message>
    <message>
        <source>the stream %1</source>
        <translation>der Videostrom %1</translation>
    </message>
    <message>
        <source>the recording %1</source>
        <translation>die Aufzeichnung %1</translation>
    </message>
    <message>
        <source>light controller on %1</source>
        <translation>Lichtsteuerung an %1</translation>
    </message>
    <message>
        <source>there is no camera under /dev/video; connect one, or set camera.source</source>
        <translation>unter /dev/video ist keine Kamera; schließen Sie eine an, oder setzen Sie camera.source</translation>
    </message>
    <message>
        <source>none of the cameras can be used: %1 %2</source>
        <translation>keine der Kameras kann benutzt werden: %1 %2</translation>
    </message>
    <message>
        <source>cannot be opened: %1; add yourself to the group &quot;video&quot; (sudo usermod -aG video $USER) and log in again</source>
        <translation>kann nicht geöffnet werden: %1; fügen Sie sich der Gruppe &quot;video&quot; hinzu (sudo usermod -aG video $USER), und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>cannot be opened: %1; close the other program that uses it</source>
        <translation>kann nicht geöffnet werden: %1; schließen Sie das andere Programm, das sie benutzt</translation>
    </message>
    <message>
        <source>cannot be opened: %1; unplug it and plug it in</source>
        <translation>kann nicht geöffnet werden: %1; ziehen Sie sie ab, und stecken Sie sie wieder ein</translation>
    </message>
    <message>
        <source>does not answer as a camera; unplug it and plug it in</source>
        <translation>antwortet nicht wie eine Kamera; ziehen Sie sie ab, und stecken Sie sie wieder ein</translation>
    </message>
    <message>
        <source>the camera source &quot;%1&quot; is none: give a number, /dev/videoN, http://…, a video file or a folder that exists, or virtual[:SEED]</source>
        <translation>die Kameraquelle &quot;%1&quot; ist keine: geben Sie eine Zahl, /dev/videoN, http://…, eine Videodatei oder einen Ordner an, den es gibt, oder virtual[:SEED]</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2; add yourself to the group &quot;video&quot; and log in again</source>
        <translation>%1 kann nicht geöffnet werden: %2; fügen Sie sich der Gruppe &quot;video&quot; hinzu, und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2; close the other program that uses it</source>
        <translation>%1 kann nicht geöffnet werden: %2; schließen Sie das andere Programm, das sie benutzt</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2; check that it is connected</source>
        <translation>%1 kann nicht geöffnet werden: %2; prüfen Sie, ob sie angeschlossen ist</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check that it is connected</source>
        <translation>%1 kann nicht geöffnet werden; prüfen Sie die Verbindung</translation>
    </message>
    <message>
        <source>%1 cannot be opened as a camera; close other programs that use it, or choose another one with camera.source</source>
        <translation>%1 lässt sich nicht als Kamera öffnen; schließen Sie andere Programme, die sie benutzen, oder wählen Sie mit camera.source eine andere</translation>
    </message>
    <message>
        <source>%1 is no video that can be read, or it is damaged; record it again</source>
        <translation>%1 ist kein lesbares Video, oder beschädigt; nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 did not answer within %2; check the address, and that the camera is on and in the network</source>
        <translation>%1 hat innerhalb von %2 nicht geantwortet; prüfen Sie die Adresse, und ob die Kamera an und im Netz ist</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check the address, and that the camera is on and in the network</source>
        <translation>%1 kann nicht geöffnet werden; prüfen Sie die Adresse, und ob die Kamera an und im Netz ist</translation>
    </message>
    <message>
        <source>%1 is gone; check its cable and plug it in again</source>
        <translation>%1 ist nicht mehr da; prüfen Sie das Kabel, und stecken Sie es wieder ein</translation>
    </message>
    <message>
        <source>%1 is gone; check that the camera is on and connected, and start again</source>
        <translation>%1 ist nicht mehr da; prüfen Sie, ob die Kamera an und angeschlossen ist, und beginnen Sie neu</translation>
    </message>
    <message>
        <source>%1 was closed by the other side; check that the camera is on and connected, and start again</source>
        <translation>%1 wurde von der Gegenseite geschlossen; prüfen Sie, ob die Kamera an und angeschlossen ist, und beginnen Sie neu</translation>
    </message>
    <message>
        <source>%1 stopped sending pictures: none came for %2; check its cable and plug it in again</source>
        <translation>%1 sendet keine Bilder mehr: seit %2 kam keines; prüfen Sie das Kabel, und stecken Sie es wieder ein</translation>
    </message>
    <message>
        <source>%1 is cut off after %2 frames of %3; copy or record it again</source>
        <translation>%1 ist nach %2 von %3 Bildern abgeschnitten; kopieren oder nehmen Sie sie neu auf</translation>
    </message>
    <message>
        <source>%1 is cut off after 1 frame of %2; copy or record it again</source>
        <translation>%1 ist nach 1 von %2 Bildern abgeschnitten; kopieren oder nehmen Sie sie neu auf</translation>
    </message>
    <message>
        <source>%1 has ended after %2 frames; record more, or begin again</source>
        <translation>%1 ist nach %2 Bildern zu Ende; nehmen Sie mehr auf, oder beginnen Sie von vorn</translation>
    </message>
    <message>
        <source>%1 has ended after 1 frame; record more, or begin again</source>
        <translation>%1 ist nach 1 Bild zu Ende; nehmen Sie mehr auf, oder beginnen Sie von vorn</translation>
    </message>
    <message>
        <source>%1 has no more images after %2; record more, or begin again</source>
        <translation>%1 hat nach %2 keine Bilder mehr; nehmen Sie mehr auf, oder beginnen Sie von vorn</translation>
    </message>
    <message>
        <source>there is no PNG or JPEG image in %1 to take for a camera&apos;s</source>
        <translation>in %1 ist kein PNG- oder JPEG-Bild, das als das einer Kamera dienen könnte</translation>
    </message>
    <message>
        <source>%1 has no picture under these lights together</source>
        <translation>%1 hat kein Bild mit diesen Lichtern zusammen</translation>
    </message>
    <message>
        <source>%1 failed: %2; start again</source>
        <translation>%1 ist ausgefallen: %2; beginnen Sie neu</translation>
    </message>
    <message>
        <source>%1 is damaged or cut off at frame %2, counted from 0; copy or record it again</source>
        <translation>%1 ist bei Bild %2, von 0 an gezählt, beschädigt oder abgeschnitten; kopieren oder nehmen Sie sie neu auf</translation>
    </message>
    <message>
        <source>%1 sends damaged pictures only; check its cable, or choose a lower resolution or another stream_format</source>
        <translation>%1 sendet nur beschädigte Bilder; prüfen Sie das Kabel, oder wählen Sie eine kleinere Auflösung oder ein anderes stream_format</translation>
    </message>
    <message>
        <source>%1 sends pictures of %2 pixels, but %3 is expected; set camera.resolution_px to what it can do</source>
        <translation>%1 sendet Bilder mit %2 Pixeln, aber %3 wird erwartet; setzen Sie camera.resolution_px auf etwas, das sie kann</translation>
    </message>
    <message>
        <source>%1 sent a picture of %2 pixels instead of %3; start again</source>
        <translation>%1 hat ein Bild mit %2 Pixeln statt %3 gesendet; beginnen Sie neu</translation>
    </message>
    <message>
        <source>%1 gave no picture within %2; check that it is connected and that no other program uses it</source>
        <translation>%1 hat innerhalb von %2 kein Bild geliefert; prüfen Sie, ob sie angeschlossen ist und kein anderes Programm sie benutzt</translation>
    </message>
    <message>
        <source>%1 sent no picture within %2; check that it is connected and that no other program uses it</source>
        <translation>%1 hat innerhalb von %2 kein Bild gesendet; prüfen Sie, ob sie angeschlossen ist und kein anderes Programm sie benutzt</translation>
    </message>
    <message>
        <source>%1 sent no picture within %2; check that it is connected</source>
        <translation>%1 hat innerhalb von %2 kein Bild gesendet; prüfen Sie, ob sie angeschlossen ist</translation>
    </message>
    <message>
        <source>%1 sent only %2 picture(s) after the light changed, within %3; it is too slow: shorten the exposure or give it more time</source>
        <translation>%1 hat nach dem Lichtwechsel innerhalb von %3 nur %2 Bild(er) gesendet; sie ist zu langsam: verkürzen Sie die Belichtung, oder geben Sie ihr mehr Zeit</translation>
    </message>
    <message>
        <source>%1 is frozen: it sends the same picture again and again; unplug it and plug it in</source>
        <translation>%1 ist eingefroren: sie sendet immer dasselbe Bild; ziehen Sie sie ab, und stecken Sie sie wieder ein</translation>
    </message>
    <message>
        <source>%1 hangs: its exposure cannot be set; plug it in again</source>
        <translation>%1 hängt: die Belichtung lässt sich nicht setzen; stecken Sie sie neu ein</translation>
    </message>
    <message>
        <source>the picture of %1 did not settle within %2: frames still differ by %3 grey levels; keep the hand still, shade other lights, and set a fixed exposure (camera.laser_exposure_s and led_exposure_s)</source>
        <translation>das Bild kam innerhalb von %2 nicht zur Ruhe (%1): die Bilder weichen noch um %3 Graustufen voneinander ab; halten Sie die Hand still, schirmen Sie anderes Licht ab, und setzen Sie eine feste Belichtung (camera.laser_exposure_s und led_exposure_s)</translation>
    </message>
    <message>
        <source>the camera did not take %1 %2; it is %3</source>
        <translation>die Kamera hat nicht angenommen: %1 %2; es ist %3</translation>
    </message>
    <message>
        <source>the camera did not take %1 %2: it has no such control</source>
        <translation>die Kamera hat nicht angenommen: %1 %2; sie hat diese Einstellung nicht</translation>
    </message>
    <message>
        <source>the camera chooses its exposure itself, so pictures may not be comparable; set camera.laser_exposure_s and camera.led_exposure_s</source>
        <translation>die Kamera wählt die Belichtung selbst, sodass Bilder nicht vergleichbar sein können; setzen Sie camera.laser_exposure_s und camera.led_exposure_s</translation>
    </message>
    <message>
        <source>cameras need %1, which is missing or cannot be loaded; install Dorsum again, with OpenCV&apos;s videoio</source>
        <translation>Kameras brauchen %1, das fehlt oder sich nicht laden lässt; installieren Sie Dorsum neu, mit OpenCVs videoio</translation>
    </message>
    <message>
        <source>there is no port %1; plug the light controller in, or correct controller.port in the device description</source>
        <translation>den Anschluss %1 gibt es nicht; schließen Sie die Lichtsteuerung an, oder berichtigen Sie controller.port in der Gerätebeschreibung</translation>
    </message>
    <message>
        <source>no permission to use %1; join the group dialout (sudo usermod -aG dialout $USER, then log in anew) or add the udev rule of docs/light-controller.md</source>
        <translation>keine Berechtigung für %1; treten Sie der Gruppe dialout bei (sudo usermod -aG dialout $USER, dann neu anmelden), oder richten Sie die udev-Regel aus docs/light-controller.md ein</translation>
    </message>
    <message>
        <source>%1 is in use by another program; close that first</source>
        <translation>%1 wird von einem anderen Programm benutzt; schließen Sie dieses zuerst</translation>
    </message>
    <message>
        <source>%1 is no serial port; name the light controller&apos;s as controller.port</source>
        <translation>%1 ist kein serieller Anschluss; nennen Sie den der Lichtsteuerung als controller.port</translation>
    </message>
    <message>
        <source>cannot open %1: %2; unplug the light controller and plug it in again</source>
        <translation>%1 kann nicht geöffnet werden: %2; ziehen Sie die Lichtsteuerung ab, und stecken Sie sie wieder ein</translation>
    </message>
    <message>
        <source>no serial port runs at %1 baud; set controller.baud to 115200, the firmware&apos;s</source>
        <translation>kein serieller Anschluss läuft mit %1 Baud; setzen Sie controller.baud auf 115200, wie die Firmware</translation>
    </message>
    <message>
        <source>the light controller on %1 is gone; check its cable and plug it in again, then start over</source>
        <translation>die Lichtsteuerung an %1 ist nicht mehr da; prüfen Sie das Kabel, stecken Sie es wieder ein, und beginnen Sie dann neu</translation>
    </message>
    <message>
        <source>the light controller on %1 speaks protocol %2 (firmware %3), this program protocol %4; flash the firmware that belongs to this program (scripts/firmware)</source>
        <translation>die Lichtsteuerung an %1 spricht Protokoll %2 (Firmware %3), dieses Programm Protokoll %4; spielen Sie die Firmware auf, die zu diesem Programm gehört (scripts/firmware)</translation>
    </message>
    <message>
        <source>what is on %1 talks, but not as a light controller; check controller.port and controller.baud, or flash the firmware (scripts/firmware)</source>
        <translation>was an %1 hängt, antwortet, aber nicht wie eine Lichtsteuerung; prüfen Sie controller.port und controller.baud, oder spielen Sie die Firmware auf (scripts/firmware)</translation>
    </message>
    <message>
        <source>no answer from a light controller on %1; check controller.port, cable and power, or flash the firmware (scripts/firmware)</source>
        <translation>keine Antwort einer Lichtsteuerung an %1; prüfen Sie controller.port, Kabel und Strom, oder spielen Sie die Firmware auf (scripts/firmware)</translation>
    </message>
    <message>
        <source>the light controller on %1 has restarted in the middle, which switched its lights off; check its power and cable</source>
        <translation>die Lichtsteuerung an %1 ist mittendrin neu gestartet, wodurch ihre Lichter ausgingen; prüfen Sie Strom und Kabel</translation>
    </message>
    <message>
        <source>the light controller on %1 does not answer any more; check its cable and power, then start over</source>
        <translation>die Lichtsteuerung an %1 antwortet nicht mehr; prüfen Sie Kabel und Strom, und beginnen Sie dann neu</translation>
    </message>
    <message>
        <source>the light controller on %1 has firmware of %2 logic, but the device description says %3; flash the other firmware or correct the description (docs/light-controller.md)</source>
        <translation>die Firmware der Lichtsteuerung an %1 hat die Logik %2, die Gerätebeschreibung sagt aber %3; spielen Sie die andere Firmware auf, oder berichtigen Sie die Beschreibung (docs/light-controller.md)</translation>
    </message>
    <message>
        <source>the light controller on %1 does not tell its limits; flash the firmware that belongs to this program (scripts/firmware)</source>
        <translation>die Lichtsteuerung an %1 nennt ihre Grenzen nicht; spielen Sie die Firmware auf, die zu diesem Programm gehört (scripts/firmware)</translation>
    </message>
    <message>
        <source>there is no serial port of a USB device; plug the light controller in, or name its port as controller.port in the device description</source>
        <translation>es gibt keinen seriellen Anschluss eines USB-Geräts; schließen Sie die Lichtsteuerung an, oder nennen Sie ihren Anschluss als controller.port in der Gerätebeschreibung</translation>
    </message>
    <message>
        <source>no light controller on any of %1 (%2)</source>
        <translation>keine Lichtsteuerung an einem von %1 (%2)</translation>
    </message>
    <message>
        <source>the device description asks for channel %1, but the %2 has 0 to %3; correct the channels in the device description</source>
        <translation>die Gerätebeschreibung verlangt Kanal %1, aber es gibt 0 bis %3 (%2); berichtigen Sie die Kanäle in der Gerätebeschreibung</translation>
    </message>
    <message>
        <source>the %1 found channel %2 not held off by its resistor when it started, so it does not drive it; check the wiring, and that the firmware&apos;s logic is the circuit&apos;s (docs/light-controller.md)</source>
        <translation>Kanal %2 wurde beim Start nicht von seinem Widerstand ausgehalten und wird deshalb nicht geschaltet (%1); prüfen Sie die Verdrahtung, und ob die Logik der Firmware die der Schaltung ist (docs/light-controller.md)</translation>
    </message>
    <message>
        <source>the %1 did not switch its lights as it was told (%2); check its cable and power</source>
        <translation>die Lichter wurden nicht geschaltet wie verlangt (%1, %2); prüfen Sie Kabel und Strom</translation>
    </message>
    <message>
        <source>the %1 switched its lights off while a picture was taken; it was reset, or its time limit is shorter than the camera needs</source>
        <translation>die Lichter gingen während einer Aufnahme aus (%1); es gab einen Neustart, oder die Zeitgrenze ist kürzer, als die Kamera braucht</translation>
    </message>
    <message>
        <source>see the report beside %1</source>
        <translation>siehe den Bericht neben %1</translation>
    </message>
    <message>
        <source>set it in device.toml to what the camera can do</source>
        <translation>setzen Sie es in device.toml auf etwas, das die Kamera kann</translation>
    </message>
    <message>
        <source>%1 can be used</source>
        <translation>%1 kann benutzt werden</translation>
    </message>
    <message>
        <source>sudo usermod -aG dialout $USER, then log in again</source>
        <translation>sudo usermod -aG dialout $USER, dann neu anmelden</translation>
    </message>
    <message>
        <source>%1, firmware %2: all off after %3 s without a word from here, a laser after %4 s</source>
        <translation>%1, Firmware %2: alles aus nach %3 s ohne ein Wort von hier, ein Laser nach %4 s</translation>
    </message>
    <message>
        <source>%1, %2 x %3 pixels</source>
        <translation>%1, %2 x %3 Pixel</translation>
    </message>
    <message>
        <source>there is no calibration folder %1</source>
        <translation>den Kalibrierordner %1 gibt es nicht</translation>
    </message>
    <message>
        <source>there is no capture folder %1</source>
        <translation>den Aufnahmeordner %1 gibt es nicht</translation>
    </message>
    <message>
        <source>there is no image stripesHand0, stripesHand1, … in %1</source>
        <translation>in %1 ist kein Bild stripesHand0, stripesHand1, …</translation>
    </message>
    <message>
        <source>there is no setup.json in %1; it says what the chessboard and the boxes measure</source>
        <translation>in %1 ist keine setup.json; sie sagt, wie groß das Schachbrett und die Quader sind</translation>
    </message>
    <message>
        <source>the image %1 (.jpg or .png) is missing in %2</source>
        <translation>das Bild %1 (.jpg oder .png) fehlt in %2</translation>
    </message>
    <message>
        <source>%1: the background image</source>
        <translation>%1: das Hintergrundbild</translation>
    </message>
    <message>
        <source>%1 is %2 pixels, more than any camera here has; capture it again</source>
        <translation>%1 hat %2 Pixel, mehr als jede Kamera hier; nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 has %2 bits per channel; 8 are expected, so save it as 8 bit</source>
        <translation>%1 hat %2 Bit je Kanal; 8 werden erwartet, speichern Sie es also mit 8 Bit</translation>
    </message>
    <message>
        <source>%1 is a grey image; the stripes are read from the green channel, so capture it in colour</source>
        <translation>%1 ist ein Graubild; die Laserstreifen werden aus dem Grünkanal gelesen, nehmen Sie es also in Farbe auf</translation>
    </message>
    <message>
        <source>%1 is not a plain colour image; the stripes are read from the green channel, so capture it in colour</source>
        <translation>%1 ist kein einfaches Farbbild; die Laserstreifen werden aus dem Grünkanal gelesen, nehmen Sie es also in Farbe auf</translation>
    </message>
    <message>
        <source>%1 is %2 pixels, but %3 is expected; use images of one camera at one resolution</source>
        <translation>%1 hat %2 Pixel, aber %3 werden erwartet; benutzen Sie Bilder einer Kamera mit einer Auflösung</translation>
    </message>
    <message>
        <source>%1 is cut off: its end is missing; copy or capture it again</source>
        <translation>%1 ist abgeschnitten: das Ende fehlt; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 is damaged; copy or capture it again</source>
        <translation>%1 ist beschädigt; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 is a damaged PNG; copy or capture it again</source>
        <translation>%1 ist ein beschädigtes PNG; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 is a damaged JPEG; copy or capture it again</source>
        <translation>%1 ist ein beschädigtes JPEG; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 is empty; copy or capture it again</source>
        <translation>%1 ist leer; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG image; copy or capture it again</source>
        <translation>%1 ist weder ein PNG- noch ein JPEG-Bild; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 cannot be decoded; copy or capture it again</source>
        <translation>%1 kann nicht entschlüsselt werden; kopieren Sie es neu, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>%1 is black; check the light and the exposure</source>
        <translation>%1 ist schwarz; prüfen Sie Licht und Belichtung</translation>
    </message>
    <message>
        <source>%1 is white all over; lower the exposure</source>
        <translation>%1 ist überall weiß; verringern Sie die Belichtung</translation>
    </message>
    <message>
        <source>with all lights off %1 of the picture is brighter than it may be; shade the device from daylight, or shorten the camera&apos;s exposure</source>
        <translation>bei ausgeschalteten Lichtern sind %1 des Bildes heller als erlaubt; schirmen Sie das Gerät gegen Tageslicht ab, oder verkürzen Sie die Belichtung der Kamera</translation>
    </message>
    <message>
        <source>the LEDs light too little of the picture; check their supply and channel, or expose longer</source>
        <translation>die LEDs beleuchten zu wenig vom Bild; prüfen Sie Versorgung und Kanal, oder belichten Sie länger</translation>
    </message>
    <message>
        <source>%1 of the picture under the LEDs is overexposed; shorten the camera&apos;s exposure under the LEDs, or dim them</source>
        <translation>%1 des Bildes unter den LEDs sind überbelichtet; verkürzen Sie die Belichtung unter den LEDs, oder dimmen Sie sie</translation>
    </message>
    <message>
        <source>laser %1 does not light up; check its supply, its cable and its channel</source>
        <translation>Laser %1 leuchtet nicht; prüfen Sie Versorgung, Kabel und Kanal</translation>
    </message>
    <message>
        <source>%1 of the picture under laser %2 is overexposed; shorten the camera&apos;s exposure for the lasers</source>
        <translation>%1 des Bildes unter Laser %2 sind überbelichtet; verkürzen Sie die Belichtung für die Laser</translation>
    </message>
    <message>
        <source>the pictures of lasers %1 and %2 show the same stripes; check their cables, and that their channels in device.toml differ</source>
        <translation>die Bilder der Laser %1 und %2 zeigen dieselben Streifen; prüfen Sie die Kabel, und ob ihre Kanäle in device.toml verschieden sind</translation>
    </message>
    <message>
        <source>laser %1 was lit in place of laser %2: its cable is plugged elsewhere than when the device was calibrated, or a laser&apos;s channel in device.toml is wrong</source>
        <translation>Laser %1 leuchtete statt Laser %2: das Kabel steckt anders als bei der Kalibrierung des Geräts, oder der Kanal eines Lasers in device.toml ist falsch</translation>
    </message>
    <message>
        <source>the hand moved by %1 while it was captured; rest it on the backplane and capture again</source>
        <translation>die Hand hat sich während der Aufnahme um %1 bewegt; legen Sie sie ruhig auf die Grundplatte, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>the hand moved by %1 while it was captured</source>
        <translation>die Hand hat sich während der Aufnahme um %1 bewegt</translation>
    </message>
    <message>
        <source>the hand leaves the picture at more than one place; move it to the middle, so that only the wrist runs out</source>
        <translation>die Hand ragt an mehr als einer Stelle aus dem Bild; legen Sie sie in die Mitte, sodass nur das Handgelenk hinausragt</translation>
    </message>
    <message>
        <source>the device has no laser %1: its lasers are 0 to %2</source>
        <translation>das Gerät hat keinen Laser %1: seine Laser sind 0 bis %2</translation>
    </message>
    <message>
        <source>%1 is there already and not empty; name a new folder</source>
        <translation>%1 gibt es schon und ist nicht leer; nennen Sie einen neuen Ordner</translation>
    </message>
    <message>
        <source>%1 is of a camera of %2 pixels, the device&apos;s has %3; calibrate this device</source>
        <translation>%1 gehört zu einer Kamera mit %2 Pixeln, die des Geräts hat %3; kalibrieren Sie dieses Gerät</translation>
    </message>
    <message>
        <source>%1 is of another device or board than %2; go on with that device, or name a new folder</source>
        <translation>%1 gehört zu einem anderen Gerät oder Brett als %2; machen Sie mit jenem Gerät weiter, oder nennen Sie einen neuen Ordner</translation>
    </message>
    <message>
        <source>no hand is seen in bgHand: it looks like the empty background; put the hand down and capture again</source>
        <translation>in bgHand ist keine Hand zu sehen: es sieht aus wie der leere Hintergrund; legen Sie die Hand hin, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>bgHand differs from the background nearly everywhere; the light or the camera changed since the calibration, so calibrate again</source>
        <translation>bgHand weicht fast überall vom Hintergrund ab; Licht oder Kamera haben sich seit der Kalibrierung geändert, kalibrieren Sie also neu</translation>
    </message>
    <message>
        <source>no object is seen: a few stripes seem to lie on one, but make no outline together with bgHand; put the hand down and capture again</source>
        <translation>kein Objekt ist zu sehen: einige Streifen scheinen auf einem zu liegen, ergeben aber mit bgHand keinen Umriss; legen Sie die Hand hin, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>the object seems to fill the picture, so its outline is not seen; look whether bgHand and the stripes are of one capture and the calibration is this device&apos;s</source>
        <translation>das Objekt scheint das Bild zu füllen, sodass sein Umriss nicht zu sehen ist; sehen Sie nach, ob bgHand und die Streifen aus einer Aufnahme sind und die Kalibrierung von diesem Gerät ist</translation>
    </message>
    <message>
        <source>only shadow is seen in bgHand: the object is as bright as the backplane, or it is gone; cover a white object with something darker and capture again</source>
        <translation>in bgHand ist nur Schatten zu sehen: das Objekt ist so hell wie die Grundplatte, oder es ist weg; bedecken Sie ein weißes Objekt mit etwas Dunklerem, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>the stripes of laser %1 lie %2 px beside their places on the backplane: camera, laser or backplane moved since the calibration; calibrate again</source>
        <translation>die Streifen von Laser %1 liegen %2 px neben ihren Plätzen auf der Grundplatte: Kamera, Laser oder Grundplatte haben sich seit der Kalibrierung bewegt; kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>no stripe is seen on the object; are the lasers on, and is the capture of this device?</source>
        <translation>auf dem Objekt ist kein Laserstreifen zu sehen; sind die Laser an, und ist die Aufnahme von diesem Gerät?</translation>
    </message>
    <message>
        <source>the calibration is for images of %1, but the capture has %2; use the calibration of this camera and resolution</source>
        <translation>die Kalibrierung ist für Bilder mit %1 Pixeln, die Aufnahme hat aber %2; benutzen Sie die Kalibrierung dieser Kamera und Auflösung</translation>
    </message>
    <message>
        <source>the calibration holds no %1 sheets for laser %2; calibrate with --method %3, or reconstruct with --sheets %4</source>
        <translation>die Kalibrierung enthält keine Lichtflächen %1 für Laser %2; kalibrieren Sie mit --method %3, oder rekonstruieren Sie mit --sheets %4</translation>
    </message>
    <message>
        <source>the stripes shine as those of other orders do, so the object reaches out of the working volume of %1 to %2 mm; place it lower and capture again</source>
        <translation>die Streifen leuchten wie solche anderer Ordnungen, das Objekt ragt also aus dem Arbeitsraum von %1 bis %2 mm; legen Sie es tiefer, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>the lasers put the object at heights that differ by %1 mm: it reaches out of the working volume of %2 to %3 mm, or moved while it was captured; place it lower and capture again</source>
        <translation>die Laser legen das Objekt in Höhen, die um %1 mm voneinander abweichen: es ragt aus dem Arbeitsraum von %2 bis %3 mm, oder hat sich während der Aufnahme bewegt; legen Sie es tiefer, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>the lasers see the object at places that differ by %1 mm: it moved while it was captured, or reaches out of the working volume of %2 to %3 mm; place it lower, keep still and capture again</source>
        <translation>die Laser sehen das Objekt an Orten, die um %1 mm voneinander abweichen: es hat sich während der Aufnahme bewegt, oder ragt aus dem Arbeitsraum von %2 bis %3 mm; legen Sie es tiefer, halten Sie still, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>the object moved by about %1 mm while it was captured, since the lasers see it at different places; keep still and capture again</source>
        <translation>das Objekt hat sich während der Aufnahme um etwa %1 mm bewegt, denn die Laser sehen es an verschiedenen Orten; halten Sie still, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>stages are shown of a capture with its calibration; take one, or open its folder</source>
        <translation>Stufen werden von einer Aufnahme mit ihrer Kalibrierung gezeigt; nehmen Sie eine auf, oder öffnen Sie ihren Ordner</translation>
    </message>
    <message>
        <source>%1: the camera&apos;s matrix or pose is not one of a camera above the backplane</source>
        <translation>%1: Matrix oder Lage der Kamera sind nicht die einer Kamera über der Grundplatte</translation>
    </message>
    <message>
        <source>%1: laser %2 has no light sheets; calibrate again</source>
        <translation>%1: Laser %2 hat keine Lichtflächen; kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>%1: the working volume&apos;s bottom is not below its top</source>
        <translation>%1: der Boden des Arbeitsraums liegt nicht unter seiner Decke</translation>
    </message>
    <message>
        <source>%1: the lasers are not in ascending order</source>
        <translation>%1: die Laser stehen nicht in aufsteigender Reihenfolge</translation>
    </message>
    <message>
        <source>%1 holds no laser; calibrate again</source>
        <translation>%1 enthält keinen Laser; kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>%1: the background image is damaged; calibrate again</source>
        <translation>%1: das Hintergrundbild ist beschädigt; kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen in %2, which fixes the world; capture it again or correct setup.json</source>
        <translation>in %2, das die Welt festlegt, ist kein Schachbrett mit %1 inneren Ecken zu sehen; nehmen Sie es neu auf, oder berichtigen Sie setup.json</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen in %2; capture it again or correct setup.json</source>
        <translation>in %2 ist kein Schachbrett mit %1 inneren Ecken zu sehen; nehmen Sie es neu auf, oder berichtigen Sie setup.json</translation>
    </message>
    <message>
        <source>a chessboard is seen in only %1 of %2 views; at least %3 are needed, so capture the chessboards again</source>
        <translation>ein Schachbrett ist nur in %1 von %2 Ansichten zu sehen; mindestens %3 werden gebraucht, nehmen Sie die Schachbretter also neu auf</translation>
    </message>
    <message>
        <source>the chessboard views do not determine the camera; capture them again with the board tilted differently in each</source>
        <translation>die Ansichten des Schachbretts bestimmen die Kamera nicht; nehmen Sie sie neu auf, das Brett jedes Mal anders gekippt</translation>
    </message>
    <message>
        <source>the chessboard lies alike in all views, which leaves the focal length open; capture chess00, chess01, … again with the board tilted differently in each</source>
        <translation>das Schachbrett liegt in allen Ansichten gleich, was die Brennweite offen lässt; nehmen Sie chess00, chess01, … neu auf, das Brett jedes Mal anders gekippt</translation>
    </message>
    <message>
        <source>the stripes and chessboards do not determine the device; capture the series again</source>
        <translation>Laserstreifen und Schachbretter bestimmen das Gerät nicht; nehmen Sie die Serie neu auf</translation>
    </message>
    <message>
        <source>only %1 whole stripes of laser %2 are seen in %3; capture it again with a longer exposure</source>
        <translation>nur %1 ganze Streifen von Laser %2 sind in %3 zu sehen; nehmen Sie es mit längerer Belichtung neu auf</translation>
    </message>
    <message>
        <source>the central stripe of laser %1 is not seen in %2; capture it again</source>
        <translation>der mittlere Streifen von Laser %1 ist in %2 nicht zu sehen; nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>no drawn lines are seen in laserFirstEstimates; capture the laser calibration plane again</source>
        <translation>in laserFirstEstimates sind keine gezeichneten Linien zu sehen; nehmen Sie die Laser-Kalibrierebene neu auf</translation>
    </message>
    <message>
        <source>no stripes are seen in %1; is laser %2 on and the exposure right? Capture it again</source>
        <translation>in %1 sind keine Laserstreifen zu sehen; ist Laser %2 an und die Belichtung richtig? Nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>only %1 stripes are seen in %2; is laser %3 on and the exposure long enough?</source>
        <translation>nur %1 Laserstreifen sind in %2 zu sehen; ist Laser %3 an und die Belichtung lang genug?</translation>
    </message>
    <message>
        <source>only %1 stripes of laser %2 are seen on the backplane; capture %3 again with a longer exposure</source>
        <translation>nur %1 Streifen von Laser %2 sind auf der Grundplatte zu sehen; nehmen Sie %3 mit längerer Belichtung neu auf</translation>
    </message>
    <message>
        <source>only %1 stripes of laser %2 are seen on the calibration object; capture %3 again with a longer exposure</source>
        <translation>nur %1 Streifen von Laser %2 sind auf dem Kalibrierkörper zu sehen; nehmen Sie %3 mit längerer Belichtung neu auf</translation>
    </message>
    <message>
        <source>fewer than three stripes of laser %1 are seen at both distances; capture %2 and %3 again</source>
        <translation>weniger als drei Streifen von Laser %1 sind in beiden Abständen zu sehen; nehmen Sie %2 und %3 neu auf</translation>
    </message>
    <message>
        <source>the stripes of laser %1 are not closer together on the calibration object than on the backplane; are the Closer and Further images swapped?</source>
        <translation>die Streifen von Laser %1 liegen auf dem Kalibrierkörper nicht enger als auf der Grundplatte; sind die Bilder Closer und Further vertauscht?</translation>
    </message>
    <message>
        <source>the chessboard under laser %1 does not lie higher on the calibration object than on the backplane; are the Closer and Further images swapped?</source>
        <translation>das Schachbrett unter Laser %1 liegt auf dem Kalibrierkörper nicht höher als auf der Grundplatte; sind die Bilder Closer und Further vertauscht?</translation>
    </message>
    <message>
        <source>the stripes of laser %1 on the backplane and on the calibration object do not belong to one grating; are the Closer and Further images swapped?</source>
        <translation>die Streifen von Laser %1 auf der Grundplatte und auf dem Kalibrierkörper gehören nicht zu einem Gitter; sind die Bilder Closer und Further vertauscht?</translation>
    </message>
    <message>
        <source>too few points on the boxes under heights/ to fit the error correction</source>
        <translation>zu wenige Punkte auf den Quadern unter heights/, um die Fehlerkorrektur anzupassen</translation>
    </message>
    <message>
        <source>the boxes under heights/ do not determine the error correction; at least three heights are needed</source>
        <translation>die Quader unter heights/ bestimmen die Fehlerkorrektur nicht; mindestens drei Höhen werden gebraucht</translation>
    </message>
    <message>
        <source>only a virtual device calibrates by itself; use the calibrate page</source>
        <translation>nur ein virtuelles Gerät kalibriert sich selbst; benutzen Sie die Seite Kalibrieren</translation>
    </message>
    <message>
        <source>this device is not virtual</source>
        <translation>dieses Gerät ist nicht virtuell</translation>
    </message>
    <message>
        <source>there is no campaign in %1; dorsum campaign new makes one</source>
        <translation>in %1 ist keine Kampagne; dorsum campaign new legt eine an</translation>
    </message>
    <message>
        <source>%1 is a campaign already; add to it, or choose another folder</source>
        <translation>%1 ist schon eine Kampagne; fügen Sie zu ihr hinzu, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>%1 is not an empty folder; choose another one for the campaign</source>
        <translation>%1 ist kein leerer Ordner; wählen Sie einen anderen für die Kampagne</translation>
    </message>
    <message>
        <source>%1 is a campaign already, and another one than asked for; choose another folder, or ask for the same device, seed, people and plan to go on with it</source>
        <translation>%1 ist schon eine Kampagne, und eine andere als die verlangte; wählen Sie einen anderen Ordner, oder verlangen Sie dasselbe Gerät, denselben Startwert, dieselben Personen und denselben Plan, um sie fortzusetzen</translation>
    </message>
    <message>
        <source>%1 is a campaign of virtual people; make another for real ones</source>
        <translation>%1 ist eine Kampagne virtueller Personen; legen Sie für wirkliche eine andere an</translation>
    </message>
    <message>
        <source>%1 is a campaign of real people; virtual ones have their own</source>
        <translation>%1 ist eine Kampagne wirklicher Personen; virtuelle haben ihre eigene</translation>
    </message>
    <message>
        <source>this campaign&apos;s virtual device is described by a file; go on with dorsum campaign new, --virtual and --device</source>
        <translation>das virtuelle Gerät dieser Kampagne ist durch eine Datei beschrieben; machen Sie mit dorsum campaign new, --virtual und --device weiter</translation>
    </message>
    <message>
        <source>a campaign&apos;s name has 1 to 100 characters, all of them printable</source>
        <translation>der Name einer Kampagne hat 1 bis 100 Zeichen, alle druckbar</translation>
    </message>
    <message>
        <source>a person&apos;s id is 1 to 32 letters a to z, digits, - and _, with at least one digit and neither - nor _ in front: p01, never a name</source>
        <translation>die Kennung einer Person besteht aus 1 bis 32 Buchstaben a bis z, Ziffern, - und _, mit mindestens einer Ziffer und weder - noch _ am Anfang: p01, niemals ein Name</translation>
    </message>
    <message>
        <source>the consent date must be a day that exists, as 2024-05-31; without consent nothing is stored</source>
        <translation>das Datum der Einwilligung muss ein Tag sein, den es gibt, wie 2024-05-31; ohne Einwilligung wird nichts gespeichert</translation>
    </message>
    <message>
        <source>the consent date %1 is before 1990</source>
        <translation>das Datum der Einwilligung %1 liegt vor 1990</translation>
    </message>
    <message>
        <source>the consent date %1 lies in the future (today is %2); without consent nothing is stored</source>
        <translation>das Datum der Einwilligung %1 liegt in der Zukunft (heute ist %2); ohne Einwilligung wird nichts gespeichert</translation>
    </message>
    <message>
        <source>there is no person %1 in %2; add the person first, with the date of the consent</source>
        <translation>die Person %1 gibt es in %2 nicht; fügen Sie sie zuerst hinzu, mit dem Datum der Einwilligung</translation>
    </message>
    <message>
        <source>there is no person %1 in %2 to correct</source>
        <translation>die Person %1, die zu berichtigen wäre, gibt es in %2 nicht</translation>
    </message>
    <message>
        <source>there is no person %1 in %2</source>
        <translation>die Person %1 gibt es in %2 nicht</translation>
    </message>
    <message>
        <source>there is a person %1 in %2 already; choose another id</source>
        <translation>die Person %1 gibt es in %2 schon; wählen Sie eine andere Kennung</translation>
    </message>
    <message>
        <source>the person %1 was removed meanwhile; nothing was stored</source>
        <translation>die Person %1 wurde inzwischen entfernt; nichts wurde gespeichert</translation>
    </message>
    <message>
        <source>the campaign&apos;s plan has no left hands</source>
        <translation>der Plan der Kampagne hat keine linken Hände</translation>
    </message>
    <message>
        <source>the campaign&apos;s plan has no right hands</source>
        <translation>der Plan der Kampagne hat keine rechten Hände</translation>
    </message>
    <message>
        <source>the campaign&apos;s plan has sessions 1 to %1, not %2</source>
        <translation>der Plan der Kampagne hat die Sitzungen 1 bis %1, nicht %2</translation>
    </message>
    <message>
        <source>the left hand of %1 has all %2 captures of session %3 already</source>
        <translation>die linke Hand von %1 hat schon alle %2 Aufnahmen der Sitzung %3</translation>
    </message>
    <message>
        <source>the right hand of %1 has all %2 captures of session %3 already</source>
        <translation>die rechte Hand von %1 hat schon alle %2 Aufnahmen der Sitzung %3</translation>
    </message>
    <message>
        <source>the left hand of %1 has all %2 captures of session %3; name the next session with --session</source>
        <translation>die linke Hand von %1 hat alle %2 Aufnahmen der Sitzung %3; nennen Sie die nächste Sitzung mit --session</translation>
    </message>
    <message>
        <source>the right hand of %1 has all %2 captures of session %3; name the next session with --session</source>
        <translation>die rechte Hand von %1 hat alle %2 Aufnahmen der Sitzung %3; nennen Sie die nächste Sitzung mit --session</translation>
    </message>
    <message>
        <source>there is no left capture %1 in session %2 of %3</source>
        <translation>eine linke Aufnahme %1 gibt es in Sitzung %2 von %3 nicht</translation>
    </message>
    <message>
        <source>there is no right capture %1 in session %2 of %3</source>
        <translation>eine rechte Aufnahme %1 gibt es in Sitzung %2 von %3 nicht</translation>
    </message>
    <message>
        <source>%1 of %2 is in the campaign already, in %3; add each capture once</source>
        <translation>%1 von %2 ist schon in der Kampagne, in %3; fügen Sie jede Aufnahme einmal hinzu</translation>
    </message>
    <message>
        <source>%1 is there, but no manifest names it; move it away</source>
        <translation>%1 ist da, aber kein Verzeichnis nennt es; räumen Sie es weg</translation>
    </message>
    <message>
        <source>%1 has a picture of laser %2, which the campaign&apos;s device does not have; a campaign has one device</source>
        <translation>%1 hat ein Bild von Laser %2, den das Gerät der Kampagne nicht hat; eine Kampagne hat ein Gerät</translation>
    </message>
    <message>
        <source>%1 is of a camera with %2 pixels, but the campaign&apos;s has %3; a campaign has one device</source>
        <translation>%1 gehört zu einer Kamera mit %2 Pixeln, die der Kampagne hat aber %3; eine Kampagne hat ein Gerät</translation>
    </message>
    <message>
        <source>%1 knows laser %2, which the campaign&apos;s device does not have; a campaign has one device</source>
        <translation>%1 kennt Laser %2, den das Gerät der Kampagne nicht hat; eine Kampagne hat ein Gerät</translation>
    </message>
    <message>
        <source>%1 has no calibration, so that there is no surface of it; give the campaign the device&apos;s with the next capture, and take this one again</source>
        <translation>%1 hat keine Kalibrierung, sodass es davon keine Oberfläche gibt; geben Sie der Kampagne mit der nächsten Aufnahme die des Geräts, und wiederholen Sie diese</translation>
    </message>
    <message>
        <source>%1 has no captures to export</source>
        <translation>%1 hat keine Aufnahmen, die zu exportieren wären</translation>
    </message>
    <message>
        <source>%1 is not an empty folder; choose another one</source>
        <translation>%1 ist kein leerer Ordner; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>%1 lies in the campaign; choose a folder outside</source>
        <translation>%1 liegt in der Kampagne; wählen Sie einen Ordner außerhalb</translation>
    </message>
    <message>
        <source>%1 is no calibration; restore it from a copy</source>
        <translation>%1 ist keine Kalibrierung; stellen Sie sie aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1 was changed since dorsum wrote it: its checksum is wrong; restore it from a copy</source>
        <translation>%1 wurde verändert, seit dorsum es schrieb: die Prüfsumme ist falsch; stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1 was changed since it was stored; restore it from a copy</source>
        <translation>%1 wurde seit dem Speichern verändert; stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1 is missing; restore it from a copy</source>
        <translation>%1 fehlt; stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, but %3 were stored; restore it from a copy</source>
        <translation>%1 hat %2 Byte, gespeichert wurden aber %3; stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1 names a capture twice; restore it from a copy</source>
        <translation>%1 nennt eine Aufnahme zweimal; stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>%1; what else lies in its folder cannot be checked</source>
        <translation>%1; was sonst in seinem Ordner liegt, kann nicht geprüft werden</translation>
    </message>
    <message>
        <source>%1 was being added or removed when the command was killed; the next command that writes clears it</source>
        <translation>%1 wurde gerade hinzugefügt oder entfernt, als der Befehl abgebrochen wurde; der nächste, der schreibt, räumt es auf</translation>
    </message>
    <message>
        <source>%1 was left by a command that was killed; the next command that writes clears it</source>
        <translation>%1 blieb von einem abgebrochenen Befehl übrig; der nächste, der schreibt, räumt es auf</translation>
    </message>
    <message>
        <source>%1 holds what is left of a person whose removal was interrupted; run the removal again</source>
        <translation>%1 enthält, was von einer Person blieb, deren Entfernung unterbrochen wurde; entfernen Sie sie noch einmal</translation>
    </message>
    <message>
        <source>%1 is a virtual person in a campaign of the other kind</source>
        <translation>%1 ist eine virtuelle Person in einer Kampagne der anderen Art</translation>
    </message>
    <message>
        <source>%1 is a real person in a campaign of the other kind</source>
        <translation>%1 ist eine wirkliche Person in einer Kampagne der anderen Art</translation>
    </message>
    <message>
        <source>%1 is a session beyond the plan</source>
        <translation>%1 ist eine Sitzung über den Plan hinaus</translation>
    </message>
    <message>
        <source>%1 is a capture beyond the plan</source>
        <translation>%1 ist eine Aufnahme über den Plan hinaus</translation>
    </message>
    <message>
        <source>%1 is a link; a campaign holds its files itself</source>
        <translation>%1 ist ein Verweis; eine Kampagne enthält ihre Dateien selbst</translation>
    </message>
    <message>
        <source>%1 does not belong to the campaign; move it away</source>
        <translation>%1 gehört nicht zur Kampagne; räumen Sie es weg</translation>
    </message>
    <message>
        <source>without a calibration it cannot be told whether a hand is there and each laser is the right one</source>
        <translation>ohne Kalibrierung lässt sich nicht sagen, ob eine Hand da ist und jeder Laser der richtige ist</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Dorsum Studio: the window of Dorsum.</source>
        <translation>Dorsum Studio: das Fenster von Dorsum.</translation>
    </message>
    <message>
        <source>capture folder or PLY file to open</source>
        <translation>Ordner einer Aufnahme oder PLY-Datei zum Öffnen</translation>
    </message>
    <message>
        <source>device description, or virtual[:SEED]</source>
        <translation>Gerätebeschreibung, oder virtual[:SEED]</translation>
    </message>
    <message>
        <source>calibration.json</source>
        <translation>calibration.json</translation>
    </message>
</context>
</TS>
