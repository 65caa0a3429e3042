<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>Removal</name>
    <message>
        <source>Remove</source>
        <translation>Odstranit</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Odstranit</translation>
    </message>
    <message>
        <source>Remove %1, session %2, %3, capture %4?</source>
        <translation>Odstranit %1, sezení %2, %3, snímek %4?</translation>
    </message>
    <message numerus="yes">
        <source>Its %n picture(s) are deleted for good. The next capture of this hand takes its number.</source>
        <translation>
            <numerusform>Jeho %n obraz se nenávratně smaže. Další snímek této ruky dostane jeho číslo.</numerusform>
            <numerusform>Jeho %n obrazy se nenávratně smažou. Další snímek této ruky dostane jeho číslo.</numerusform>
            <numerusform>Jeho %n obrazů se nenávratně smaže. Další snímek této ruky dostane jeho číslo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n capture(s), %1 together, are deleted for good. The id and what was said of the person go too. Exports, surfaces and backups are not reached.</source>
        <translation>
            <numerusform>Nenávratně se smaže %n snímek, celkem %1, i identifikátor a údaje o osobě. Exporty, povrchy a zálohy tím dotčeny nejsou.</numerusform>
            <numerusform>Nenávratně se smažou %n snímky, celkem %1, i identifikátor a údaje o osobě. Exporty, povrchy a zálohy tím dotčeny nejsou.</numerusform>
            <numerusform>Nenávratně se smaže %n snímků, celkem %1, i identifikátor a údaje o osobě. Exporty, povrchy a zálohy tím dotčeny nejsou.</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove %1 from the campaign?</source>
        <translation>Odstranit %1 z kampaně?</translation>
    </message>
</context>
<context>
    <name>dorsum::Banner</name>
    <message>
        <source>What went wrong</source>
        <translation>Co se nepovedlo</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Zavřít hlášení</translation>
    </message>
</context>
<context>
    <name>dorsum::CalibrateModel</name>
    <message>
        <source>Chessboard %1 of %2</source>
        <translation>Šachovnice %1 z %2</translation>
    </message>
    <message>
        <source>Empty backplane</source>
        <translation>Prázdná podložka</translation>
    </message>
    <message>
        <source>Chessboard under laser %1</source>
        <translation>Šachovnice pod laserem %1</translation>
    </message>
    <message>
        <source>Sheet of lines</source>
        <translation>List s čarami</translation>
    </message>
    <message>
        <source>Object of %1 mm</source>
        <translation>Těleso %1 mm</translation>
    </message>
    <message>
        <source>Board on object, laser %1</source>
        <translation>Šachovnice na tělese, laser %1</translation>
    </message>
    <message>
        <source>Box of %1 mm</source>
        <translation>Kvádr %1 mm</translation>
    </message>
    <message>
        <source>Looking at what is there already…</source>
        <translation>Zjišťuje se, co už je hotovo…</translation>
    </message>
    <message>
        <source>Taking the calibration series</source>
        <translation>Pořizuje se kalibrační série</translation>
    </message>
    <message>
        <source>Stopped. What was taken is kept; the series goes on from there.</source>
        <translation>Zastaveno. Co bylo pořízeno, zůstává; série odtud pokračuje.</translation>
    </message>
    <message>
        <source>The series broke off. What was taken is kept; the series goes on from there.</source>
        <translation>Série se přerušila. Co bylo pořízeno, zůstává; série odtud pokračuje.</translation>
    </message>
    <message>
        <source>All pictures are there. The boards cover %1 % of the picture.</source>
        <translation>Všechny snímky jsou hotové. Šachovnice pokrývají %1 % obrazu.</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Probíhá kalibrace</translation>
    </message>
</context>
<context>
    <name>dorsum::CalibratePage</name>
    <message>
        <source>&amp;Series</source>
        <translation>&amp;Série</translation>
    </message>
    <message>
        <source>&amp;Go back to the calibration before</source>
        <translation>&amp;Vrátit předchozí kalibraci</translation>
    </message>
    <message>
        <source>Puts the calibration back that the last one replaced.</source>
        <translation>Vrátí kalibraci, kterou ta poslední nahradila.</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>Výs&amp;ledek</translation>
    </message>
    <message>
        <source>Where the pictures of the series are, or go. What is there already is kept.</source>
        <translation>Kde snímky série jsou nebo kam přijdou. Co tam už je, zůstane.</translation>
    </message>
    <message>
        <source>The calibration that is written; its report comes beside it.</source>
        <translation>Kalibrace, která se zapíše; její zpráva přijde vedle ní.</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Procházet…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Procházet: %1</translation>
    </message>
    <message>
        <source>Series &amp;folder</source>
        <translation>S&amp;ložka série</translation>
    </message>
    <message>
        <source>Calibration f&amp;ile</source>
        <translation>Soubor kal&amp;ibrace</translation>
    </message>
    <message>
        <source>&amp;Take the series</source>
        <translation>&amp;Pořídit sérii</translation>
    </message>
    <message>
        <source>Leads through the series with the open device. A series that was broken off goes on where it ended.</source>
        <translation>Provede sérií s otevřeným zařízením. Přerušená série pokračuje tam, kde skončila.</translation>
    </message>
    <message>
        <source>&amp;Calibrate from the folder</source>
        <translation>&amp;Kalibrovat ze složky</translation>
    </message>
    <message>
        <source>Calibrates from the pictures that the folder holds; needs no device.</source>
        <translation>Kalibruje ze snímků ve složce; nepotřebuje zařízení.</translation>
    </message>
    <message>
        <source>Steps of the series</source>
        <translation>Kroky série</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Co udělat</translation>
    </message>
    <message>
        <source>Live picture with what the boards cover</source>
        <translation>Živý obraz s tím, co šachovnice pokrývají</translation>
    </message>
    <message>
        <source>The live picture comes when the series is taken.</source>
        <translation>Živý obraz se objeví, až se bude série pořizovat.</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Další</translation>
    </message>
    <message>
        <source>What was asked for stands: take the pictures (Return).</source>
        <translation>Vše je připraveno: pořídit snímky (Enter).</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>Z&amp;astavit</translation>
    </message>
    <message>
        <source>Ends the series; what was taken is kept.</source>
        <translation>Ukončí sérii; co bylo pořízeno, zůstává.</translation>
    </message>
    <message>
        <source>Go on &amp;by itself</source>
        <translation>Pokračovat &amp;samo</translation>
    </message>
    <message>
        <source>A virtual device lays things down by itself, without being asked.</source>
        <translation>Virtuální zařízení věci pokládá samo, bez ptaní.</translation>
    </message>
    <message>
        <source>S&amp;how what boards cover</source>
        <translation>&amp;Ukázat pokrytí šachovnicemi</translation>
    </message>
    <message>
        <source>Choose the folder of the series</source>
        <translation>Zvolit složku série</translation>
    </message>
    <message>
        <source>Choose where the calibration goes</source>
        <translation>Zvolit, kam kalibrace přijde</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrace (*.json)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hotovo</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nyní</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>chybí</translation>
    </message>
    <message>
        <source>Go on &amp;taking the series</source>
        <translation>&amp;Pokračovat v sérii</translation>
    </message>
    <message>
        <source>Take the series: you are led through it step by step.</source>
        <translation>Pořiďte sérii: budete jí provedeni krok za krokem.</translation>
    </message>
    <message>
        <source>Open a device on the device page, or calibrate from a folder.</source>
        <translation>Otevřete zařízení na stránce Zařízení, nebo kalibrujte ze složky.</translation>
    </message>
    <message>
        <source>Covered: %1 %</source>
        <translation>Pokryto: %1 %</translation>
    </message>
</context>
<context>
    <name>dorsum::CalibrationViews</name>
    <message>
        <source>Verdicts</source>
        <translation>Hodnocení</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Část</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Hodnocení</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Před a po</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Před</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Změna</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Šachovnice</translation>
    </message>
    <message>
        <source>Lasers</source>
        <translation>Lasery</translation>
    </message>
    <message>
        <source>The board with arrows to where its corners are expected</source>
        <translation>Šachovnice se šipkami tam, kde se čekají její rohy</translation>
    </message>
    <message>
        <source>What the light sheets leave, order by order</source>
        <translation>Co zbývá po světelných plochách, řád po řádu</translation>
    </message>
    <message>
        <source>What the light sheets leave along the stripes</source>
        <translation>Co zbývá po světelných plochách podél laserových pruhů</translation>
    </message>
    <message>
        <source>Each board with its reprojection error. The arrows are drawn many times longer.</source>
        <translation>Každá šachovnice se svou reprojekční chybou. Šipky jsou mnohonásobně prodloužené.</translation>
    </message>
    <message>
        <source>Noise scatters evenly about zero; a pattern is an error of the model, or a laser that moved.</source>
        <translation>Šum je rozptýlen rovnoměrně kolem nuly; vzor znamená chybu modelu nebo laser, který se pohnul.</translation>
    </message>
    <message>
        <source>&amp;Verdicts</source>
        <translation>&amp;Hodnocení</translation>
    </message>
    <message>
        <source>&amp;Boards</source>
        <translation>Ša&amp;chovnice</translation>
    </message>
    <message>
        <source>&amp;Light sheets</source>
        <translation>Světelné plo&amp;chy</translation>
    </message>
    <message>
        <source>Before and &amp;after</source>
        <translation>Před &amp;a po</translation>
    </message>
    <message>
        <source>Nothing was calibrated here yet.</source>
        <translation>Zde se ještě nic nekalibrovalo.</translation>
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
        <translation>Varování</translation>
    </message>
    <message>
        <source>good</source>
        <translation>dobré</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>pochybné</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>špatné</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No calibration was loaded before.</source>
        <translation>Předtím nebyla načtena žádná kalibrace.</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignCaptures</name>
    <message>
        <source>%1, session %2, %3, capture %4: %5.</source>
        <translation>%1, sezení %2, %3, snímek %4: %5.</translation>
    </message>
    <message>
        <source>The picture of a laser is missing.</source>
        <translation>Chybí obraz jednoho laseru.</translation>
    </message>
    <message>
        <source>It has no calibration.</source>
        <translation>Nemá kalibraci.</translation>
    </message>
    <message>
        <source>Session %1, %2, %3</source>
        <translation>Sezení %1, %2, %3</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignDetails</name>
    <message>
        <source>Live picture</source>
        <translation>Živý obraz</translation>
    </message>
    <message>
        <source>Captures</source>
        <translation>Snímky</translation>
    </message>
    <message>
        <source>&amp;Look at it</source>
        <translation>&amp;Prohlédnout</translation>
    </message>
    <message>
        <source>Reconstructs the chosen capture, for the pages Surface and Stages</source>
        <translation>Zrekonstruuje zvolený snímek pro stránky Povrch a Kroky</translation>
    </message>
    <message>
        <source>Remove &amp;capture…</source>
        <translation>Smazat sní&amp;mek…</translation>
    </message>
    <message>
        <source>Deletes the chosen capture, to take it again</source>
        <translation>Smaže zvolený snímek, aby bylo možné pořídit jej znovu</translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Žádný obraz: %1</translation>
    </message>
    <message>
        <source>C&amp;orrect…</source>
        <translation>Op&amp;ravit…</translation>
    </message>
    <message>
        <source>Replaces what was said of the person wrongly</source>
        <translation>Nahradí chybné údaje o osobě</translation>
    </message>
    <message>
        <source>Remove &amp;person…</source>
        <translation>Odstranit oso&amp;bu…</translation>
    </message>
    <message>
        <source>Deletes the person with all captures, for good</source>
        <translation>Nenávratně smaže osobu se všemi snímky</translation>
    </message>
    <message>
        <source>Takes what is missing next, with the open device (Ctrl+Return)</source>
        <translation>Pořídí otevřeným zařízením, co chybí jako další (Ctrl+Enter)</translation>
    </message>
    <message>
        <source>From a &amp;folder…</source>
        <translation>Z&amp;e složky…</translation>
    </message>
    <message>
        <source>Takes over a capture that lies in a folder already</source>
        <translation>Převezme snímek, který už je ve složce</translation>
    </message>
    <message>
        <source>Choose a person in the table, or add one.</source>
        <translation>Zvolte osobu v tabulce, nebo nějakou přidejte.</translation>
    </message>
    <message>
        <source>%1, session %2, %3</source>
        <translation>%1, sezení %2, %3</translation>
    </message>
    <message>
        <source>Next: session %1, %2; %3 missing.</source>
        <translation>Další: sezení %1, %2; chybí %3.</translation>
    </message>
    <message>
        <source>Nothing is missing here.</source>
        <translation>Tady nic nechybí.</translation>
    </message>
    <message numerus="yes">
        <source>%n capture(s) are missing in all.</source>
        <translation>
            <numerusform>Celkem chybí %n snímek.</numerusform>
            <numerusform>Celkem chybějí %n snímky.</numerusform>
            <numerusform>Celkem chybí %n snímků.</numerusform>
        </translation>
    </message>
    <message>
        <source>No device is open; open one on the Device page.</source>
        <translation>Žádné zařízení není otevřené; otevřete je na stránce Zařízení.</translation>
    </message>
    <message>
        <source>&amp;Make all that is missing</source>
        <translation>Vytvořit vše ch&amp;ybějící</translation>
    </message>
    <message>
        <source>Capture the %1</source>
        <translation>Pořídit: %1</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Pořídit</translation>
    </message>
    <message>
        <source>Take over a capture folder</source>
        <translation>Převzít složku snímku</translation>
    </message>
    <message>
        <source>Waiting for a picture…</source>
        <translation>Čeká se na obraz…</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignModel</name>
    <message>
        <source>Reading the campaign</source>
        <translation>Čte se kampaň</translation>
    </message>
    <message>
        <source>Making the campaign</source>
        <translation>Zakládá se kampaň</translation>
    </message>
    <message>
        <source>The campaign %1 is there. Add the first person.</source>
        <translation>Kampaň %1 je založena. Přidejte první osobu.</translation>
    </message>
    <message>
        <source>Capturing virtual people</source>
        <translation>Snímají se virtuální osoby</translation>
    </message>
    <message>
        <source>%1 virtual people with %2 captures are there.</source>
        <translation>Virtuální osoby: %1, jejich snímky: %2.</translation>
    </message>
    <message>
        <source>Adding a person</source>
        <translation>Přidává se osoba</translation>
    </message>
    <message>
        <source>What is said of %1 is corrected.</source>
        <translation>Údaje o %1 jsou opraveny.</translation>
    </message>
    <message>
        <source>%1 belongs to the campaign now.</source>
        <translation>%1 nyní patří do kampaně.</translation>
    </message>
    <message>
        <source>Removing a person</source>
        <translation>Odstraňuje se osoba</translation>
    </message>
    <message numerus="yes">
        <source>Removed the person and %n capture(s). Exports, surfaces and backups are not reached.</source>
        <translation>
            <numerusform>Odstraněna osoba a %n snímek. Exporty, povrchy a zálohy tím dotčeny nejsou.</numerusform>
            <numerusform>Odstraněna osoba a %n snímky. Exporty, povrchy a zálohy tím dotčeny nejsou.</numerusform>
            <numerusform>Odstraněna osoba a %n snímků. Exporty, povrchy a zálohy tím dotčeny nejsou.</numerusform>
        </translation>
    </message>
    <message>
        <source>Removing a capture</source>
        <translation>Odstraňuje se snímek</translation>
    </message>
    <message>
        <source>Removed %1. The next capture of this hand takes its number.</source>
        <translation>%1 odstraněno. Další snímek této ruky dostane jeho číslo.</translation>
    </message>
    <message>
        <source>Capturing %1, session %2, %3</source>
        <translation>Snímá se %1, sezení %2, %3</translation>
    </message>
    <message>
        <source>Taking over a capture</source>
        <translation>Přebírá se snímek</translation>
    </message>
    <message>
        <source>%1, session %2, %3: capture %4 of %5 is stored.</source>
        <translation>%1, sezení %2, %3: snímek %4 z %5 je uložen.</translation>
    </message>
    <message>
        <source>Reconstructing %1</source>
        <translation>Rekonstruuje se %1</translation>
    </message>
    <message>
        <source>%1 is on the pages Surface and Stages now.</source>
        <translation>%1 je nyní na stránkách Povrch a Kroky.</translation>
    </message>
    <message>
        <source>Verifying the campaign</source>
        <translation>Ověřuje se kampaň</translation>
    </message>
    <message numerus="yes">
        <source>Verified: all %n file(s) are as they were stored.</source>
        <translation>
            <numerusform>Ověřeno: %n soubor je takový, jak byl uložen.</numerusform>
            <numerusform>Ověřeno: všechny %n soubory jsou takové, jak byly uloženy.</numerusform>
            <numerusform>Ověřeno: všech %n souborů je takových, jak byly uloženy.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Verified: the campaign is not as it was stored, with %n finding(s). Bring back what is missing or damaged from a copy of the folder, or remove the capture and take it again.</source>
        <translation>
            <numerusform>Ověřeno: kampaň není taková, jak byla uložena; %n nález. Co chybí nebo je poškozené, vraťte z kopie složky, nebo snímek odstraňte a pořiďte znovu.</numerusform>
            <numerusform>Ověřeno: kampaň není taková, jak byla uložena; %n nálezy. Co chybí nebo je poškozené, vraťte z kopie složky, nebo snímek odstraňte a pořiďte znovu.</numerusform>
            <numerusform>Ověřeno: kampaň není taková, jak byla uložena; %n nálezů. Co chybí nebo je poškozené, vraťte z kopie složky, nebo snímek odstraňte a pořiďte znovu.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting the campaign</source>
        <translation>Exportuje se kampaň</translation>
    </message>
    <message>
        <source>Exported %1 people with %2 captures to %3.</source>
        <translation>Exportováno do %3: osoby: %1, snímky: %2.</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignPage</name>
    <message>
        <source>%1 of %2 people</source>
        <translation>%1 z %2 osob</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n osoba</numerusform>
            <numerusform>%n osoby</numerusform>
            <numerusform>%n osob</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 are there, %2 of them with all captures; %3 of %4 captures.</source>
        <translation>Zatím %1, z toho %2 se všemi snímky; %3 z %4 snímků.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Nálezy</translation>
    </message>
    <message>
        <source>Nothing is missing of the people who came.</source>
        <translation>Od osob, které přišly, nic nechybí.</translation>
    </message>
    <message>
        <source>A campaign collects captures of many people: who came, which hands are there, and what is missing. Open the folder of one, or begin a new one; one of virtual people needs no device.</source>
        <translation>Kampaň shromažďuje snímky mnoha osob: kdo přišel, které ruce už jsou a co chybí. Otevřete složku některé kampaně, nebo začněte novou; kampaň s virtuálními osobami nepotřebuje zařízení.</translation>
    </message>
    <message>
        <source>&amp;Open a campaign…</source>
        <translation>&amp;Otevřít kampaň…</translation>
    </message>
    <message>
        <source>Opens the folder of a campaign</source>
        <translation>Otevře složku kampaně</translation>
    </message>
    <message>
        <source>&amp;New campaign…</source>
        <translation>Nová &amp;kampaň…</translation>
    </message>
    <message>
        <source>Begins a campaign in a new folder</source>
        <translation>Začne kampaň v nové složce</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otevřít…</translation>
    </message>
    <message>
        <source>Opens the folder of another campaign</source>
        <translation>Otevře složku jiné kampaně</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>Nov&amp;á…</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>O&amp;věřit</translation>
    </message>
    <message>
        <source>Reads every byte: is all as it was stored?</source>
        <translation>Přečte každý bajt: je vše tak, jak bylo uloženo?</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportovat…</translation>
    </message>
    <message>
        <source>Writes the captures for others, under new random ids and without personal data</source>
        <translation>Zapíše snímky pro ostatní, pod novými náhodnými identifikátory a bez osobních údajů</translation>
    </message>
    <message>
        <source>Open the folder of a campaign</source>
        <translation>Otevřít složku kampaně</translation>
    </message>
    <message>
        <source>Something of this campaign cannot be read, and does not count. Verify says more.</source>
        <translation>Něco v této kampani nelze přečíst, a proto se nepočítá. Více řekne Ověřit.</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignPeople</name>
    <message>
        <source>Only &amp;what is missing</source>
        <translation>Jen &amp;chybějící</translation>
    </message>
    <message>
        <source>&amp;Add a person…</source>
        <translation>Přid&amp;at osobu…</translation>
    </message>
    <message>
        <source>Find an id</source>
        <translation>Najít identifikátor</translation>
    </message>
    <message>
        <source>Hides the people of whom all is there</source>
        <translation>Skryje osoby, od kterých je už vše</translation>
    </message>
    <message>
        <source>With the day of the consent</source>
        <translation>S datem souhlasu</translation>
    </message>
    <message>
        <source>Next &amp;gap</source>
        <translation>&amp;Další chybějící</translation>
    </message>
    <message>
        <source>Goes to the next hand of which something is missing</source>
        <translation>Přejde na další ruku, od které něco chybí</translation>
    </message>
    <message>
        <source>People and their hands</source>
        <translation>Osoby a jejich ruce</translation>
    </message>
</context>
<context>
    <name>dorsum::CampaignTable</name>
    <message>
        <source>left hand</source>
        <translation>levá ruka</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>pravá ruka</translation>
    </message>
    <message>
        <source>man</source>
        <translation>muž</translation>
    </message>
    <message>
        <source>woman</source>
        <translation>žena</translation>
    </message>
    <message>
        <source>other</source>
        <translation>jiné</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>neuvedeno</translation>
    </message>
    <message>
        <source>%1 is a virtual person.</source>
        <translation>%1 je virtuální osoba.</translation>
    </message>
    <message>
        <source>%1 consented on %2.</source>
        <translation>Souhlas %1: %2.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>%1, session %2, %3: %4 captures are there, %5 are missing.</source>
        <translation>%1, sezení %2, %3: hotové snímky: %4, chybějící: %5.</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Pohlaví</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Věk</translation>
    </message>
    <message>
        <source>Session %1,
%2</source>
        <translation>Sezení %1,
%2</translation>
    </message>
</context>
<context>
    <name>dorsum::DeviceModel</name>
    <message>
        <source>LEDs</source>
        <translation>LED</translation>
    </message>
    <message>
        <source>LEDs of channel %1</source>
        <translation>LED kanálu %1</translation>
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
        <translation>ponecháno podle kamery</translation>
    </message>
    <message>
        <source>No device is open, so no light can be switched on.</source>
        <translation>Žádné zařízení není otevřené, proto nelze rozsvítit žádné světlo.</translation>
    </message>
    <message>
        <source>A laser switched on here goes off by itself after %1.</source>
        <translation>Laser zapnutý zde sám zhasne po %1.</translation>
    </message>
    <message>
        <source>The controller itself puts all lights out when it hears nothing for %1.</source>
        <translation>Řídicí jednotka sama zhasne všechna světla, když %1 nic neuslyší.</translation>
    </message>
    <message>
        <source>The controller has no limit of its own.</source>
        <translation>Řídicí jednotka nemá vlastní limit.</translation>
    </message>
    <message>
        <source>All lights go off when this page is left.</source>
        <translation>Po opuštění této stránky všechna světla zhasnou.</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>kanál %1</translation>
    </message>
    <message>
        <source>The controller says: all lights are off.</source>
        <translation>Řídicí jednotka hlásí: všechna světla jsou zhasnutá.</translation>
    </message>
    <message>
        <source>The controller says these are on: %1.</source>
        <translation>Řídicí jednotka hlásí, že svítí: %1.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Rozlišení</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixelů</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Soubory</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>JPEG, quality %1</source>
        <translation>JPEG, kvalita %1</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Přenos obrazu</translation>
    </message>
    <message>
        <source>raw pictures</source>
        <translation>surové snímky</translation>
    </message>
    <message>
        <source>JPEG pictures</source>
        <translation>snímky JPEG</translation>
    </message>
    <message>
        <source>Exposure under lasers</source>
        <translation>Expozice pod lasery</translation>
    </message>
    <message>
        <source>Exposure under LEDs</source>
        <translation>Expozice pod LED</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Zesílení</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Zaostření</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Vyvážení bílé</translation>
    </message>
    <message>
        <source>%1 K</source>
        <translation>%1 K</translation>
    </message>
    <message>
        <source>Could not be set</source>
        <translation>Nelze nastavit</translation>
    </message>
    <message>
        <source>Examining the device</source>
        <translation>Zařízení se prověřuje</translation>
    </message>
    <message>
        <source>Examining this machine</source>
        <translation>Tento počítač se prověřuje</translation>
    </message>
</context>
<context>
    <name>dorsum::DevicePage</name>
    <message>
        <source>Live picture</source>
        <translation>Živý obraz</translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Žádný obraz: %1</translation>
    </message>
    <message>
        <source>The device does not answer. Open it again.</source>
        <translation>Zařízení neodpovídá. Otevřete je znovu.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Zařízení</translation>
    </message>
    <message>
        <source>A device description (device.toml), or virtual; virtual:7 is another virtual device, with the mounting errors of seed 7.</source>
        <translation>Popis zařízení (device.toml) nebo virtual; virtual:7 je jiné virtuální zařízení, s montážními chybami podle semínka 7.</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Procházet…</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Otevřít</translation>
    </message>
    <message>
        <source>Opens the device named above, in place of the one that is open.</source>
        <translation>Otevře výše uvedené zařízení místo toho, které je otevřené.</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Zavřít</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Otevírá se…</translation>
    </message>
    <message>
        <source>Lights by hand</source>
        <translation>Světla ručně</translation>
    </message>
    <message>
        <source>&amp;All off</source>
        <translation>Vš&amp;e zhasnout</translation>
    </message>
    <message>
        <source>Switches every light off at once (Ctrl+.).</source>
        <translation>Ihned zhasne všechna světla (Ctrl+.).</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <source>Camera settings</source>
        <translation>Nastavení kamery</translation>
    </message>
    <message>
        <source>Camera &amp;settings</source>
        <translation>&amp;Nastavení kamery</translation>
    </message>
    <message>
        <source>&amp;Examine</source>
        <translation>P&amp;rověřit</translation>
    </message>
    <message>
        <source>Looks at cameras, ports, disk and calibration, then takes a picture in the dark, under the LEDs and under each laser. Clear the backplane first.</source>
        <translation>Prohlédne kamery, porty, disk a kalibraci a pak pořídí snímek ve tmě, pod LED a pod každým laserem. Nejprve uvolněte podložku.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Část</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Zjištění</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Co udělat</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Zjištění</translation>
    </message>
    <message>
        <source>E&amp;xamination</source>
        <translation>Pro&amp;věření</translation>
    </message>
    <message>
        <source>Choose a device description</source>
        <translation>Zvolit popis zařízení</translation>
    </message>
    <message>
        <source>Device descriptions (*.toml)</source>
        <translation>Popisy zařízení (*.toml)</translation>
    </message>
    <message>
        <source>Open: %1. %2; %3, firmware %4.</source>
        <translation>Otevřeno: %1. %2; %3, firmware %4.</translation>
    </message>
    <message>
        <source>Waiting for a picture…</source>
        <translation>Čeká se na obraz…</translation>
    </message>
    <message>
        <source>No device is open.</source>
        <translation>Žádné zařízení není otevřené.</translation>
    </message>
    <message>
        <source>No device is open. Choose one at the left; virtual needs no hardware.</source>
        <translation>Žádné zařízení není otevřené. Zvolte je vlevo; virtual nepotřebuje hardware.</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1: zhasnuto</translation>
    </message>
    <message>
        <source>%1: on, off by itself in %2 s</source>
        <translation>%1: svítí, samo zhasne za %2 s</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1: svítí</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>v pořádku</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>porucha</translation>
    </message>
    <message>
        <source>note</source>
        <translation>poznámka</translation>
    </message>
</context>
<context>
    <name>dorsum::DeviceSession</name>
    <message>
        <source>Opening the device</source>
        <translation>Otevírá se zařízení</translation>
    </message>
    <message>
        <source>Closing the device</source>
        <translation>Zavírá se zařízení</translation>
    </message>
</context>
<context>
    <name>dorsum::ExportDialog</name>
    <message>
        <source>Export the campaign</source>
        <translation>Exportovat kampaň</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportovat</translation>
    </message>
    <message>
        <source>Tell sex and age group too</source>
        <translation>Uvést i pohlaví a věkovou skupinu</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Název:</translation>
    </message>
    <message>
        <source>The name of the new folder</source>
        <translation>Název nové složky</translation>
    </message>
    <message>
        <source>&amp;In the folder:</source>
        <translation>&amp;Ve složce:</translation>
    </message>
    <message>
        <source>The export becomes a folder of its own in it</source>
        <translation>Export v ní bude mít vlastní složku</translation>
    </message>
    <message>
        <source>&amp;Groups:</source>
        <translation>&amp;Skupiny:</translation>
    </message>
    <message>
        <source>Only where groups are large enough. Without it, nobody is told anything but the pictures under new random ids.</source>
        <translation>Jen kde jsou skupiny dost velké. Bez toho se předají jen obrazy pod novými náhodnými identifikátory.</translation>
    </message>
    <message>
        <source>&amp;Least:</source>
        <translation>Nej&amp;méně:</translation>
    </message>
    <message>
        <source>People that each group must have to be told</source>
        <translation>Kolik osob musí skupina mít, aby byla uvedena</translation>
    </message>
</context>
<context>
    <name>dorsum::FormDialog</name>
    <message>
        <source>Give it a name.</source>
        <translation>Zadejte název.</translation>
    </message>
    <message>
        <source>The name becomes a folder: it holds no slash and does not begin with a point.</source>
        <translation>Z názvu se stane složka: neobsahuje lomítko a nezačíná tečkou.</translation>
    </message>
    <message>
        <source>Choose a folder that is there, to put it in.</source>
        <translation>Zvolte existující složku, do které to přijde.</translation>
    </message>
    <message>
        <source>%1 is there already; choose another name.</source>
        <translation>%1 už existuje; zvolte jiný název.</translation>
    </message>
    <message>
        <source>What is still to be done</source>
        <translation>Co je ještě třeba udělat</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Zvolit…</translation>
    </message>
</context>
<context>
    <name>dorsum::LiveView</name>
    <message>
        <source>Live picture</source>
        <translation>Živý obraz</translation>
    </message>
</context>
<context>
    <name>dorsum::MainWindow</name>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Skenování</translation>
    </message>
    <message>
        <source>Scan a hand</source>
        <translation>Naskenovat ruku</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Povrch</translation>
    </message>
    <message>
        <source>Look at a surface and measure it</source>
        <translation>Prohlédnout a změřit povrch</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrace</translation>
    </message>
    <message>
        <source>Calibrate the device, or look at how well it is calibrated</source>
        <translation>Kalibrovat zařízení nebo zjistit, jak dobře je zkalibrované</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Zařízení</translation>
    </message>
    <message>
        <source>Open a device, switch its lights by hand, examine it</source>
        <translation>Otevřít zařízení, ručně ovládat jeho světla, prověřit je</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Soubor</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>&amp;Otevřít soubor…</translation>
    </message>
    <message>
        <source>Open &amp;capture folder…</source>
        <translation>Otevřít složku &amp;snímku…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Konec</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Nápověda</translation>
    </message>
    <message>
        <source>&amp;About Dorsum Studio</source>
        <translation>&amp;O aplikaci Dorsum Studio</translation>
    </message>
    <message>
        <source>About Dorsum Studio</source>
        <translation>O aplikaci Dorsum Studio</translation>
    </message>
    <message>
        <source>Dorsum Studio %1: scans the back of a hand. Apache License 2.0.</source>
        <translation>Dorsum Studio %1: skenuje hřbet ruky. Licence Apache 2.0.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Zobrazení</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Jazyk</translation>
    </message>
    <message>
        <source>The window speaks it from its next start on.</source>
        <translation>Okno tímto jazykem promluví od příštího spuštění.</translation>
    </message>
    <message>
        <source>&amp;As the desktop</source>
        <translation>&amp;Podle prostředí</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>Open a capture folder</source>
        <translation>Otevřít složku snímku</translation>
    </message>
    <message>
        <source>Open a calibration or a surface</source>
        <translation>Otevřít kalibraci nebo povrch</translation>
    </message>
    <message>
        <source>Calibrations and surfaces (*.json *.ply)</source>
        <translation>Kalibrace a povrchy (*.json *.ply)</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Kroky</translation>
    </message>
    <message>
        <source>See each step of the computation, the document&apos;s beside ours</source>
        <translation>Vidět každý krok výpočtu, postup z dokumentu vedle našeho</translation>
    </message>
    <message>
        <source>Campaign</source>
        <translation>Kampaň</translation>
    </message>
    <message>
        <source>Collect captures of many people, and see what is missing</source>
        <translation>Shromažďovat snímky mnoha osob a vidět, co chybí</translation>
    </message>
</context>
<context>
    <name>dorsum::NewCampaignDialog</name>
    <message>
        <source>New campaign</source>
        <translation>Nová kampaň</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Začít</translation>
    </message>
    <message>
        <source>The one that is open</source>
        <translation>Ta, která je otevřená</translation>
    </message>
    <message>
        <source>Captured without a device</source>
        <translation>Snímáno bez zařízení</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Název:</translation>
    </message>
    <message>
        <source>A name for people to read, and the name of the folder</source>
        <translation>Čitelný název, zároveň název složky</translation>
    </message>
    <message>
        <source>&amp;In the folder:</source>
        <translation>&amp;Ve složce:</translation>
    </message>
    <message>
        <source>The campaign becomes a folder of its own in it</source>
        <translation>Kampaň v ní bude mít vlastní složku</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>neuvedeno</translation>
    </message>
    <message>
        <source>&amp;People:</source>
        <translation>&amp;Osoby:</translation>
    </message>
    <message>
        <source>How many people are hoped for</source>
        <translation>V kolik osob se doufá</translation>
    </message>
    <message>
        <source>&amp;Sessions:</source>
        <translation>&amp;Sezení:</translation>
    </message>
    <message>
        <source>Visits of each person</source>
        <translation>Návštěvy každé osoby</translation>
    </message>
    <message>
        <source>C&amp;aptures:</source>
        <translation>Sní&amp;mky:</translation>
    </message>
    <message>
        <source>Captures of each hand in each session</source>
        <translation>Snímky každé ruky v každém sezení</translation>
    </message>
    <message>
        <source>both</source>
        <translation>obě</translation>
    </message>
    <message>
        <source>left</source>
        <translation>levá</translation>
    </message>
    <message>
        <source>right</source>
        <translation>pravá</translation>
    </message>
    <message>
        <source>&amp;Hands:</source>
        <translation>&amp;Ruce:</translation>
    </message>
    <message>
        <source>Which hands are captured</source>
        <translation>Které ruce se snímají</translation>
    </message>
    <message>
        <source>&amp;Calibration:</source>
        <translation>&amp;Kalibrace:</translation>
    </message>
    <message>
        <source>No calibration is open. The first capture can bring one.</source>
        <translation>Žádná kalibrace není otevřená. Může ji přinést první snímek.</translation>
    </message>
    <message>
        <source>&amp;Virtual people:</source>
        <translation>V&amp;irtuální osoby:</translation>
    </message>
    <message>
        <source>Virtual people come to a virtual device, which is calibrated first. This takes minutes, and can be stopped and gone on with.</source>
        <translation>Virtuální osoby přijdou k virtuálnímu zařízení, které se nejprve kalibruje. Trvá to minuty a lze to zastavit a pokračovat.</translation>
    </message>
    <message>
        <source>S&amp;eed:</source>
        <translation>&amp;Počáteční hodnota:</translation>
    </message>
    <message>
        <source>Another seed is another virtual device with other people</source>
        <translation>Jiná počáteční hodnota je jiné virtuální zařízení s jinými osobami</translation>
    </message>
    <message>
        <source>Say how many virtual people are to come.</source>
        <translation>Uveďte, kolik virtuálních osob má přijít.</translation>
    </message>
    <message>
        <source>A seed has 1 to 200 characters.</source>
        <translation>Počáteční hodnota má 1 až 200 znaků.</translation>
    </message>
</context>
<context>
    <name>dorsum::OptionBox</name>
    <message>
        <source>&amp;Undo</source>
        <translation>Zpě&amp;t</translation>
    </message>
    <message>
        <source>Takes the last change of a parameter back (Ctrl+Z)</source>
        <translation>Vrátí poslední změnu parametru (Ctrl+Z)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Zno&amp;vu</translation>
    </message>
    <message>
        <source>Makes the change again (Ctrl+Shift+Z)</source>
        <translation>Provede změnu znovu (Ctrl+Shift+Z)</translation>
    </message>
    <message>
        <source>R&amp;eset</source>
        <translation>Vý&amp;chozí</translation>
    </message>
    <message>
        <source>Puts all parameters back to their defaults; can be undone</source>
        <translation>Vrátí všem parametrům výchozí hodnoty; lze vzít zpět</translation>
    </message>
</context>
<context>
    <name>dorsum::OptionPanel</name>
    <message>
        <source>Reset</source>
        <translation>Výchozí</translation>
    </message>
</context>
<context>
    <name>dorsum::PersonDialog</name>
    <message>
        <source>Correct a person</source>
        <translation>Opravit osobu</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Přidat osobu</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>&amp;Opravit</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>Přid&amp;at</translation>
    </message>
    <message>
        <source>The person has signed it</source>
        <translation>Osoba jej podepsala</translation>
    </message>
    <message>
        <source>&amp;Id:</source>
        <translation>&amp;Identifikátor:</translation>
    </message>
    <message>
        <source>Pseudonymous, as p01; never a name. The list that says who p01 is belongs on paper, in another place.</source>
        <translation>Pseudonymní, například p01; nikdy jméno. Seznam, kdo je p01, patří na papír, na jiné místo.</translation>
    </message>
    <message>
        <source>&amp;Sex:</source>
        <translation>&amp;Pohlaví:</translation>
    </message>
    <message>
        <source>As the person says</source>
        <translation>Jak uvádí osoba</translation>
    </message>
    <message>
        <source>A&amp;ge group:</source>
        <translation>&amp;Věková skupina:</translation>
    </message>
    <message>
        <source>In years</source>
        <translation>V letech</translation>
    </message>
    <message>
        <source>C&amp;onsent:</source>
        <translation>&amp;Souhlas:</translation>
    </message>
    <message>
        <source>Without the consent nothing is stored</source>
        <translation>Bez souhlasu se nic neuloží</translation>
    </message>
    <message>
        <source>Signed o&amp;n:</source>
        <translation>Po&amp;depsán dne:</translation>
    </message>
    <message>
        <source>The day on which the person signed the consent. Without it nothing is stored.</source>
        <translation>Den, kdy osoba podepsala souhlas. Bez něj se nic neuloží.</translation>
    </message>
    <message>
        <source>Give the person an id, as p01; never a name.</source>
        <translation>Dejte osobě identifikátor, například p01; nikdy jméno.</translation>
    </message>
    <message>
        <source>%1 is in the campaign already; choose another id.</source>
        <translation>%1 už v kampani je; zvolte jiný identifikátor.</translation>
    </message>
    <message>
        <source>Nothing is stored of a person who has not signed the consent.</source>
        <translation>O osobě, která nepodepsala souhlas, se nic neuloží.</translation>
    </message>
</context>
<context>
    <name>dorsum::ScaleBar</name>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 až %2 mm</translation>
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
        <translation>Žádné zařízení není otevřené</translation>
    </message>
    <message>
        <source>The device does not answer: look at its cables</source>
        <translation>Zařízení neodpovídá: zkontrolujte kabely</translation>
    </message>
    <message>
        <source>The calibration is of another device</source>
        <translation>Kalibrace patří jinému zařízení</translation>
    </message>
    <message>
        <source>This device needs its calibration first</source>
        <translation>Toto zařízení nejprve potřebuje kalibraci</translation>
    </message>
    <message>
        <source>The virtual device calibrates itself</source>
        <translation>Virtuální zařízení se kalibruje</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Nehýbejte se</translation>
    </message>
    <message>
        <source>Once more: hold still</source>
        <translation>Ještě jednou: nehýbejte se</translation>
    </message>
    <message>
        <source>Thank you: you may take the hand away</source>
        <translation>Děkujeme: ruku můžete zvednout</translation>
    </message>
    <message>
        <source>Is it good?</source>
        <translation>Je to dobré?</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Uloženo</translation>
    </message>
    <message>
        <source>Put your hand down</source>
        <translation>Položte ruku</translation>
    </message>
    <message>
        <source>The light has changed: calibrate again</source>
        <translation>Světlo se změnilo: kalibrujte znovu</translation>
    </message>
    <message>
        <source>Move the hand to the left</source>
        <translation>Posuňte ruku doleva</translation>
    </message>
    <message>
        <source>Move the hand to the right</source>
        <translation>Posuňte ruku doprava</translation>
    </message>
    <message>
        <source>Move the hand up</source>
        <translation>Posuňte ruku nahoru</translation>
    </message>
    <message>
        <source>Move the hand down</source>
        <translation>Posuňte ruku dolů</translation>
    </message>
    <message>
        <source>Spread the fingers</source>
        <translation>Roztáhněte prsty</translation>
    </message>
    <message>
        <source>Good: hold still</source>
        <translation>Dobře: nehýbejte se</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Skenuje se</translation>
    </message>
    <message>
        <source>Keeping the capture</source>
        <translation>Snímek se ukládá</translation>
    </message>
</context>
<context>
    <name>dorsum::ScanPage</name>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Opakovat</translation>
    </message>
    <message>
        <source>Keep &amp;in…</source>
        <translation>Ukládat &amp;do…</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automaticky</translation>
    </message>
    <message>
        <source>&amp;Before the device:</source>
        <translation>&amp;Před zařízením:</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Co udělat</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>Průběh skenování</translation>
    </message>
    <message>
        <source>Quality of the fingers</source>
        <translation>Kvalita prstů</translation>
    </message>
    <message>
        <source>How much of each finger the surface covers, and the usual uncertainty of its heights</source>
        <translation>Kolik z každého prstu povrch pokrývá a obvyklá nejistota jeho výšek</translation>
    </message>
    <message>
        <source>Throw this scan away and take another</source>
        <translation>Zahodit tento sken a pořídit jiný</translation>
    </message>
    <message>
        <source>Scan when the hand has rested for a second; again when it has moved since</source>
        <translation>Skenovat, když je ruka vteřinu v klidu; znovu, až se pohne</translation>
    </message>
    <message>
        <source>The folder in which captures are kept, each in a folder of its own</source>
        <translation>Složka, kam se snímky ukládají, každý do vlastní složky</translation>
    </message>
    <message>
        <source>Keep captures in</source>
        <translation>Ukládat snímky do</translation>
    </message>
    <message>
        <source>What lies before the virtual device</source>
        <translation>Co leží před virtuálním zařízením</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>Anna&apos;s right hand</source>
        <translation>Annina pravá ruka</translation>
    </message>
    <message>
        <source>Anna&apos;s right hand, another day</source>
        <translation>Annina pravá ruka, jiný den</translation>
    </message>
    <message>
        <source>Ben&apos;s left hand</source>
        <translation>Benova levá ruka</translation>
    </message>
    <message>
        <source>Ben&apos;s left hand, which moves</source>
        <translation>Benova levá ruka, která se hýbe</translation>
    </message>
    <message>
        <source>a box, 25.5 mm high</source>
        <translation>kvádr vysoký 25,5 mm</translation>
    </message>
    <message>
        <source>&amp;Open the virtual device</source>
        <translation>&amp;Otevřít virtuální zařízení</translation>
    </message>
    <message>
        <source>&amp;Connect again</source>
        <translation>&amp;Znovu připojit</translation>
    </message>
    <message>
        <source>&amp;Calibrate this virtual device</source>
        <translation>&amp;Kalibrovat toto virtuální zařízení</translation>
    </message>
    <message>
        <source>&amp;Open its calibration…</source>
        <translation>&amp;Otevřít jeho kalibraci…</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Skenovat</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Z&amp;rušit</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>&amp;Next hand</source>
        <translation>&amp;Další ruka</translation>
    </message>
    <message>
        <source>Open the device&apos;s calibration</source>
        <translation>Otevřít kalibraci zařízení</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrace (*.json)</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>tma</translation>
    </message>
    <message>
        <source>lamps</source>
        <translation>světla</translation>
    </message>
    <message>
        <source>lamps again</source>
        <translation>světla znovu</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>povrch</translation>
    </message>
    <message>
        <source>laser %1</source>
        <translation>laser %1</translation>
    </message>
    <message>
        <source>Fingers: not told, since five cannot be separated</source>
        <translation>Prsty: bez údajů, protože se jich nepodařilo rozlišit pět</translation>
    </message>
    <message>
        <source>finger %1: %2 % covered, ±%3 mm</source>
        <translation>prst %1: pokryto %2 %, ±%3 mm</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Uloženo v %1</translation>
    </message>
    <message>
        <source>Is kept in %1</source>
        <translation>Uloží se do %1</translation>
    </message>
</context>
<context>
    <name>dorsum::SectionPlot</name>
    <message>
        <source>along the line, mm</source>
        <translation>podél čáry, mm</translation>
    </message>
    <message>
        <source>height, mm</source>
        <translation>výška, mm</translation>
    </message>
    <message>
        <source>%1 mm along, %2 mm high</source>
        <translation>na %1 mm, výška %2 mm</translation>
    </message>
    <message>
        <source>Choose Section and two places of the surface: the cut through them is drawn here.</source>
        <translation>Zvolte Řez a dvě místa povrchu: zde se nakreslí řez jimi.</translation>
    </message>
</context>
<context>
    <name>dorsum::StagesPage</name>
    <message>
        <source>Mask: difference</source>
        <translation>Maska: rozdíl</translation>
    </message>
    <message>
        <source>Mask: threshold</source>
        <translation>Maska: práh</translation>
    </message>
    <message>
        <source>Mask: coarse</source>
        <translation>Maska: hrubá</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maska</translation>
    </message>
    <message>
        <source>Mask: without shadow</source>
        <translation>Maska: bez stínu</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Výšky</translation>
    </message>
    <message>
        <source>Laser %1: orders</source>
        <translation>Laser %1: řády</translation>
    </message>
    <message>
        <source>Laser %1: points</source>
        <translation>Laser %1: body</translation>
    </message>
    <message>
        <source>Laser %1: edges</source>
        <translation>Laser %1: hrany</translation>
    </message>
    <message>
        <source>Laser %1: stripes</source>
        <translation>Laser %1: pruhy</translation>
    </message>
    <message>
        <source>Laser %1: stripe points</source>
        <translation>Laser %1: body pruhů</translation>
    </message>
    <message>
        <source>This chain ended early: %1. Take the last change back, or try other values.</source>
        <translation>Tento řetězec skončil předčasně: %1. Vraťte poslední změnu, nebo zkuste jiné hodnoty.</translation>
    </message>
    <message>
        <source>%1 points, %2 faces, computed in %3 s</source>
        <translation>Body: %1, trojúhelníky: %2, spočteno za %3 s</translation>
    </message>
    <message>
        <source>Parameters of both</source>
        <translation>Parametry obou</translation>
    </message>
    <message>
        <source>Show &amp;before</source>
        <translation>Ukázat &amp;předchozí</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>Vypo&amp;čítat</translation>
    </message>
    <message>
        <source>Stages of the chain</source>
        <translation>Kroky řetězce</translation>
    </message>
    <message>
        <source>A dot marks what the last change of a parameter changed</source>
        <translation>Tečka označuje, co změnila poslední změna parametru</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Co se zobrazuje</translation>
    </message>
    <message>
        <source>Shows the pictures of the parameters before the last change, to compare</source>
        <translation>Pro porovnání ukáže obrazy s parametry před poslední změnou</translation>
    </message>
    <message>
        <source>Computes the stages with the parameters as they are now</source>
        <translation>Spočítá kroky s nynějšími parametry</translation>
    </message>
    <message>
        <source>The document&apos;s chain</source>
        <translation>Řetězec z dokumentu</translation>
    </message>
    <message>
        <source>Ours</source>
        <translation>Náš</translation>
    </message>
    <message>
        <source>Wheel or + and −: zoom; mouse or arrows: move; 0: all of it</source>
        <translation>Kolečko nebo + a −: zvětšení; myš nebo šipky: posun; 0: celý obraz</translation>
    </message>
    <message>
        <source>Figures: %1</source>
        <translation>Údaje: %1</translation>
    </message>
    <message>
        <source>Comparing the stages</source>
        <translation>Porovnávají se kroky</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>změněno</translation>
    </message>
    <message>
        <source>Scan a hand, or open a calibration and a capture folder (File menu): its stages are shown here.</source>
        <translation>Naskenujte ruku, nebo otevřete kalibraci a složku snímku (nabídka Soubor): zde se ukážou jeho kroky.</translation>
    </message>
    <message>
        <source>Only a surface is open, which has no stages. Open a capture folder (File menu).</source>
        <translation>Otevřen je jen povrch, který nemá kroky. Otevřete složku snímku (nabídka Soubor).</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Počítá se…</translation>
    </message>
    <message>
        <source>The stages come when the other work is done.</source>
        <translation>Kroky přijdou, až skončí ostatní práce.</translation>
    </message>
    <message>
        <source>The computation was stopped. Compute begins it again.</source>
        <translation>Výpočet byl zastaven. Znovu jej začne Vypočítat.</translation>
    </message>
    <message>
        <source>Before the last change of the parameters.</source>
        <translation>Před poslední změnou parametrů.</translation>
    </message>
    <message>
        <source>Computing with the new parameters…</source>
        <translation>Počítá se s novými parametry…</translation>
    </message>
    <message>
        <source>The parameters changed.</source>
        <translation>Parametry se změnily.</translation>
    </message>
    <message>
        <source>The computation was stopped: these pictures are of other parameters.</source>
        <translation>Výpočet byl zastaven: tyto obrazy patří k jiným parametrům.</translation>
    </message>
    <message>
        <source>The last change of the parameters changed no picture.</source>
        <translation>Poslední změna parametrů nezměnila žádný obraz.</translation>
    </message>
    <message numerus="yes">
        <source>The last change of the parameters changed %n picture(s); a dot marks them in the list.</source>
        <translation>
            <numerusform>Poslední změna parametrů změnila %n obraz; v seznamu jej označuje tečka.</numerusform>
            <numerusform>Poslední změna parametrů změnila %n obrazy; v seznamu je označuje tečka.</numerusform>
            <numerusform>Poslední změna parametrů změnila %n obrazů; v seznamu je označuje tečka.</numerusform>
        </translation>
    </message>
    <message>
        <source>This chain ended before this stage.</source>
        <translation>Tento řetězec skončil před tímto krokem.</translation>
    </message>
    <message>
        <source>This chain has no such stage.</source>
        <translation>Tento řetězec takový krok nemá.</translation>
    </message>
    <message>
        <source>Busy part</source>
        <translation>Obsazená část</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceControls</name>
    <message>
        <source>C&amp;lear</source>
        <translation>Vy&amp;mazat</translation>
    </message>
    <message>
        <source>Com&amp;pare…</source>
        <translation>Po&amp;rovnat…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportovat…</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Co se zobrazuje</translation>
    </message>
    <message>
        <source>The mesh, the points of the stripes, or both</source>
        <translation>Síť, body laserových pruhů, nebo obojí</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Síť</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Body</translation>
    </message>
    <message>
        <source>Mesh and points</source>
        <translation>Síť a body</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Barvy</translation>
    </message>
    <message>
        <source>What the colours of the surface mean</source>
        <translation>Co barvy povrchu znamenají</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Order of the stripe</source>
        <translation>Řád pruhu</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Uncertainty of z</source>
        <translation>Nejistota z</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Rozdíl</translation>
    </message>
    <message>
        <source>Shaded only</source>
        <translation>Jen stínování</translation>
    </message>
    <message>
        <source>&amp;Show:</source>
        <translation>&amp;Zobrazit:</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Barvy:</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Místo</translation>
    </message>
    <message>
        <source>Say where a place lies and which stripe runs there</source>
        <translation>Říci, kde místo leží a který laserový pruh tudy vede</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Vzdálenost</translation>
    </message>
    <message>
        <source>Two places: how far along the surface, and straight</source>
        <translation>Dvě místa: jak daleko po povrchu a přímo</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>Ře&amp;z</translation>
    </message>
    <message>
        <source>Two places: the upright cut through both, as a curve</source>
        <translation>Dvě místa: svislý řez oběma jako křivka</translation>
    </message>
    <message>
        <source>Clear the measure</source>
        <translation>Vymazat měření</translation>
    </message>
    <message>
        <source>Take the chosen places away</source>
        <translation>Odebrat zvolená místa</translation>
    </message>
    <message>
        <source>Compare with another surface</source>
        <translation>Porovnat s jiným povrchem</translation>
    </message>
    <message>
        <source>Colours show how far this surface lies above or below that of another PLY file</source>
        <translation>Barvy ukazují, jak vysoko nad povrchem jiného souboru PLY nebo pod ním tento povrch leží</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Write the surface as PLY, OBJ, STL or GLB, or the view as PNG</source>
        <translation>Zapsat povrch jako PLY, OBJ, STL nebo GLB, nebo pohled jako PNG</translation>
    </message>
    <message>
        <source>Difference to %1</source>
        <translation>Rozdíl od %1</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceFiles</name>
    <message>
        <source>Compare with a surface</source>
        <translation>Porovnat s povrchem</translation>
    </message>
    <message>
        <source>Surfaces (*.ply)</source>
        <translation>Povrchy (*.ply)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>PLY (*.ply);;OBJ (*.obj);;STL (*.stl);;GLB (*.glb);;Picture (*.png)</source>
        <translation>PLY (*.ply);;OBJ (*.obj);;STL (*.stl);;GLB (*.glb);;Obrázek (*.png)</translation>
    </message>
    <message>
        <source>PLY (*.ply);;Picture (*.png)</source>
        <translation>PLY (*.ply);;Obrázek (*.png)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Čte se %1</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Zapisuje se %1</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceImage</name>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>The image with its stripes; a click or Enter picks a stripe, the wheel, + and - zoom, Home shows all</source>
        <translation>Obraz s laserovými pruhy; kliknutí nebo Enter vybere pruh, kolečko, + a - mění zvětšení, Home ukáže vše</translation>
    </message>
    <message>
        <source>Image that is shown</source>
        <translation>Zobrazený obraz</translation>
    </message>
    <message>
        <source>Which of the capture&apos;s images, and whose stripes</source>
        <translation>Který z obrazů snímku a čí laserové pruhy</translation>
    </message>
    <message>
        <source>&amp;Image:</source>
        <translation>&amp;Obraz:</translation>
    </message>
    <message>
        <source>All stripes</source>
        <translation>Všechny laserové pruhy</translation>
    </message>
    <message>
        <source>LEDs, all stripes</source>
        <translation>LED, všechny laserové pruhy</translation>
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
        <translation>Měří se po povrchu</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfacePage</name>
    <message>
        <source>Surface</source>
        <translation>Povrch</translation>
    </message>
    <message>
        <source>Drag or arrow keys turn; Shift moves; wheel, + and - zoom; Home shows all; a click or Enter picks a place</source>
        <translation>Tažení nebo šipky otáčejí; Shift posouvá; kolečko, + a - mění zvětšení; Home ukáže vše; kliknutí nebo Enter vybere místo</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Řez</translation>
    </message>
    <message>
        <source>The cut through the two places</source>
        <translation>Řez oběma místy</translation>
    </message>
    <message>
        <source>Scale of the colours</source>
        <translation>Stupnice barev</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Co bylo změřeno</translation>
    </message>
    <message>
        <source>No surface</source>
        <translation>Žádný povrch</translation>
    </message>
    <message>
        <source>No surface yet. Scan a hand, open a capture folder or a PLY file, or drop one here.</source>
        <translation>Zatím žádný povrch. Naskenujte ruku, otevřete složku snímku nebo soubor PLY, nebo je sem přetáhněte.</translation>
    </message>
    <message>
        <source>Colouring the surface</source>
        <translation>Povrch se barví</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 mm</source>
        <translation>x %1, y %2, z %3 mm</translation>
    </message>
    <message>
        <source>; image %1, %2 px</source>
        <translation>; obraz %1, %2 px</translation>
    </message>
    <message>
        <source>; stripe of laser %1, order %2</source>
        <translation>; pruh laseru %1, řád %2</translation>
    </message>
    <message>
        <source>; one standard deviation of z %1 mm</source>
        <translation>; jedna směrodatná odchylka z %1 mm</translation>
    </message>
    <message>
        <source>Straight %1 mm</source>
        <translation>Přímo %1 mm</translation>
    </message>
    <message>
        <source>, along the surface %1 mm</source>
        <translation>, po povrchu %1 mm</translation>
    </message>
    <message>
        <source>; points alone have no way along a surface</source>
        <translation>; samotné body nemají cestu po povrchu</translation>
    </message>
    <message>
        <source>, measuring along the surface…</source>
        <translation>, měří se po povrchu…</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln point(s)</source>
        <translation>
            <numerusform>%Ln bod</numerusform>
            <numerusform>%Ln body</numerusform>
            <numerusform>%Ln bodů</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln trojúhelník</numerusform>
            <numerusform>%Ln trojúhelníky</numerusform>
            <numerusform>%Ln trojúhelníků</numerusform>
        </translation>
    </message>
    <message>
        <source>Click a place of the surface or a stripe of the image.</source>
        <translation>Klikněte na místo povrchu nebo pruh v obraze.</translation>
    </message>
    <message>
        <source>Click the first of two places.</source>
        <translation>Klikněte na první ze dvou míst.</translation>
    </message>
    <message>
        <source>Click the second place.</source>
        <translation>Klikněte na druhé místo.</translation>
    </message>
    <message>
        <source>Against %1: mean %2 mm, RMS %3 mm; places compared: %L4, outside it: %L5</source>
        <translation>Proti %1: průměr %2 mm, RMS %3 mm; porovnaných míst: %L4, mimo: %L5</translation>
    </message>
</context>
<context>
    <name>dorsum::SurfaceView</name>
    <message>
        <source>this display has no OpenGL 3.3, so the surface cannot be drawn; measuring and export of files work without it</source>
        <translation>tato obrazovka nemá OpenGL 3.3, proto nelze povrch vykreslit; měření a export souborů fungují i bez něj</translation>
    </message>
</context>
<context>
    <name>dorsum::TurningSurface</name>
    <message>
        <source>Surface</source>
        <translation>Povrch</translation>
    </message>
</context>
<context>
    <name>dorsum::VirtualSession</name>
    <message>
        <source>Laying something before the device</source>
        <translation>Před zařízení se něco pokládá</translation>
    </message>
    <message>
        <source>Calibrating the virtual device</source>
        <translation>Kalibruje se virtuální zařízení</translation>
    </message>
</context>
<context>
    <name>dorsum::Workbench</name>
    <message>
        <source>Reading the calibration</source>
        <translation>Čte se kalibrace</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Otevírá se %1</translation>
    </message>
</context>
<context>
    <name>library</name>
    <message>
        <source>Lay the chessboard flat on the backplane, its middle on the central stripe of laser %1 and its rows across the stripes.</source>
        <translation>Položte šachovnici naplocho na podložku, středem na prostřední pruh laseru %1 a řadami napříč pruhy.</translation>
    </message>
    <message>
        <source>Hold the chessboard raised and tilted by 10 to 25 degrees, another way than before, all of it in the picture.</source>
        <translation>Držte šachovnici zvednutou a nakloněnou o 10 až 25 stupňů, jinak než předtím, celou v obraze.</translation>
    </message>
    <message>
        <source>Clear the backplane.</source>
        <translation>Uvolněte podložku.</translation>
    </message>
    <message>
        <source>Lay the chessboard flat on the backplane, its middle on the central stripe of laser %1, which is on now.</source>
        <translation>Položte šachovnici naplocho na podložku, středem na prostřední pruh laseru %1, který nyní svítí.</translation>
    </message>
    <message>
        <source>Lay the sheet with one line for each laser on the backplane, the lines on the central stripes.</source>
        <translation>Položte na podložku list s jednou čarou pro každý laser, čáry na prostřední pruhy.</translation>
    </message>
    <message>
        <source>Put the calibration object of %1 mm on the backplane; it must fill the picture.</source>
        <translation>Postavte na podložku kalibrační těleso %1 mm; musí vyplnit obraz.</translation>
    </message>
    <message>
        <source>Lay the chessboard flat on the calibration object, its middle on the central stripe of laser %1, which is on now.</source>
        <translation>Položte šachovnici naplocho na kalibrační těleso, středem na prostřední pruh laseru %1, který nyní svítí.</translation>
    </message>
    <message>
        <source>Put the box of %1 mm on the empty backplane, in the middle of the picture.</source>
        <translation>Postavte kvádr %1 mm na prázdnou podložku doprostřed obrazu.</translation>
    </message>
    <message>
        <source>Again: %1. %2</source>
        <translation>Znovu: %1. %2</translation>
    </message>
    <message>
        <source>the chessboard of %1 x %2 inner corners is not seen whole</source>
        <translation>šachovnice s %1 x %2 vnitřními rohy není vidět celá</translation>
    </message>
    <message>
        <source>the chessboard lies as it did before</source>
        <translation>šachovnice leží stejně jako předtím</translation>
    </message>
    <message>
        <source>Chessboard %1 of %2: the boards cover %3 % of the picture; least at the %4.</source>
        <translation>Šachovnice %1 z %2: šachovnice pokrývají %3 % obrazu; nejméně: %4.</translation>
    </message>
    <message>
        <source>Chessboard %1 of %2: the boards cover %3 % of the picture.</source>
        <translation>Šachovnice %1 z %2: šachovnice pokrývají %3 % obrazu.</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>vlevo nahoře</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>vpravo nahoře</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>vlevo dole</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>vpravo dole</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>kamera</translation>
    </message>
    <message>
        <source>chessboard</source>
        <translation>šachovnice</translation>
    </message>
    <message>
        <source>known heights</source>
        <translation>známé výšky</translation>
    </message>
    <message>
        <source>surface error correction</source>
        <translation>korekce chyb povrchu</translation>
    </message>
    <message>
        <source>laser %1</source>
        <translation>laser %1</translation>
    </message>
    <message>
        <source>the camera model explains all chessboards</source>
        <translation>model kamery vysvětluje všechny šachovnice</translation>
    </message>
    <message>
        <source>the corners do not fit; capture the chessboards again with a flat board and a sharp picture</source>
        <translation>rohy nesedí; pořiďte šachovnice znovu s rovnou deskou a ostrým obrazem</translation>
    </message>
    <message>
        <source>the corners do not fit well, worst in %1</source>
        <translation>rohy nesedí dobře, nejhůře v %1</translation>
    </message>
    <message>
        <source>is the board flat, sharp and still?</source>
        <translation>je šachovnice rovná, ostrá a v klidu?</translation>
    </message>
    <message>
        <source>the board is flat</source>
        <translation>deska je rovná</translation>
    </message>
    <message>
        <source>the board is not flat: its corners lie %1 mm off its middle</source>
        <translation>deska není rovná: její rohy leží %1 mm mimo rovinu středu</translation>
    </message>
    <message>
        <source>that bow was taken into account, but mount the board on something flat</source>
        <translation>prohnutí bylo započteno, ale upevněte desku na něco rovného</translation>
    </message>
    <message>
        <source>all heights fit as they were given</source>
        <translation>všechny výšky sedí, jak byly zadány</translation>
    </message>
    <message>
        <source>the height of %1 is given as %2 mm, fits %3 mm</source>
        <translation>výška %1 je zadána jako %2 mm, sedí %3 mm</translation>
    </message>
    <message>
        <source>what fits was used, so measure it and correct setup.json</source>
        <translation>použito bylo, co sedí; změřte ji a opravte setup.json</translation>
    </message>
    <message>
        <source>cones explain all stripes</source>
        <translation>kužely vysvětlují všechny laserové pruhy</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees, too little to tell its form</source>
        <translation>vějíř je nakloněn o %1 stupně, příliš málo na určení tvaru</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees and is flat, as it leaves a laser</source>
        <translation>vějíř je nakloněn o %1 stupně a je rovinný, jak vychází z laseru</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees and has one cosine all along (a cone before the grating)</source>
        <translation>vějíř je nakloněn o %1 stupně a má všude stejný kosinus (kužel před difrakční mřížkou)</translation>
    </message>
    <message>
        <source>the fan leans by %1 degrees and is bowed, neither flat nor a cone</source>
        <translation>vějíř je nakloněn o %1 stupně a je prohnutý, ani rovinný, ani kužel</translation>
    </message>
    <message>
        <source>the second-order correction explains the boxes</source>
        <translation>korekce druhého řádu vysvětluje kvádry</translation>
    </message>
    <message>
        <source>views</source>
        <translation>pohledy</translation>
    </message>
    <message>
        <source>boards that lie on known heights</source>
        <translation>šachovnice ve známých výškách</translation>
    </message>
    <message>
        <source>reprojection error</source>
        <translation>reprojekční chyba</translation>
    </message>
    <message>
        <source>worst view</source>
        <translation>nejhorší pohled</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>ohnisková vzdálenost</translation>
    </message>
    <message>
        <source>principal point</source>
        <translation>hlavní bod</translation>
    </message>
    <message>
        <source>camera height</source>
        <translation>výška kamery</translation>
    </message>
    <message>
        <source>stripe points</source>
        <translation>body pruhů</translation>
    </message>
    <message>
        <source>sheet residual</source>
        <translation>zbytková chyba světelných ploch</translation>
    </message>
    <message>
        <source>pattern left</source>
        <translation>zbylý vzor</translation>
    </message>
    <message>
        <source>height uncertainty by calibration</source>
        <translation>nejistota výšky z kalibrace</translation>
    </message>
    <message>
        <source>grating x</source>
        <translation>mřížka x</translation>
    </message>
    <message>
        <source>grating height</source>
        <translation>výška mřížky</translation>
    </message>
    <message>
        <source>order step</source>
        <translation>krok řádu</translation>
    </message>
    <message>
        <source>fan distance</source>
        <translation>vzdálenost vějíře</translation>
    </message>
    <message>
        <source>fan tilt</source>
        <translation>náklon vějíře</translation>
    </message>
    <message>
        <source>fan bow</source>
        <translation>prohnutí vějíře</translation>
    </message>
    <message>
        <source>sag of the corners</source>
        <translation>průhyb rohů</translation>
    </message>
    <message>
        <source>sag, in standard deviations</source>
        <translation>průhyb ve směrodatných odchylkách</translation>
    </message>
    <message>
        <source>%1, uncertainty</source>
        <translation>%1, nejistota</translation>
    </message>
    <message>
        <source>%1: given</source>
        <translation>%1: zadáno</translation>
    </message>
    <message>
        <source>%1: fits</source>
        <translation>%1: sedí</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1: nejistota</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>kamery</translation>
    </message>
    <message>
        <source>serial ports</source>
        <translation>sériové porty</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>disk</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>kalibrace</translation>
    </message>
    <message>
        <source>device</source>
        <translation>zařízení</translation>
    </message>
    <message>
        <source>light controller</source>
        <translation>řízení světel</translation>
    </message>
    <message>
        <source>daylight</source>
        <translation>denní světlo</translation>
    </message>
    <message>
        <source>LEDs</source>
        <translation>LED</translation>
    </message>
    <message>
        <source>virtual camera</source>
        <translation>virtuální kamera</translation>
    </message>
    <message>
        <source>virtual light controller</source>
        <translation>virtuální řízení světel</translation>
    </message>
    <message>
        <source>virtual light controller, firmware virtual</source>
        <translation>virtuální řízení světel, firmware virtual</translation>
    </message>
    <message>
        <source>virtual camera, %1 x %2 pixels</source>
        <translation>virtuální kamera, %1 x %2 pixelů</translation>
    </message>
    <message>
        <source>this machine has no camera</source>
        <translation>tento počítač nemá kameru</translation>
    </message>
    <message>
        <source>plug one in; a network camera or virtual needs none</source>
        <translation>připojte ji; síťová kamera ani virtual ji nepotřebují</translation>
    </message>
    <message>
        <source>no serial port of a USB device is there</source>
        <translation>není tu žádný sériový port USB zařízení</translation>
    </message>
    <message>
        <source>plug the light controller in; virtual needs none</source>
        <translation>připojte řízení světel; virtual je nepotřebuje</translation>
    </message>
    <message>
        <source>%1 may be used</source>
        <translation>%1 lze používat</translation>
    </message>
    <message>
        <source>%1 may not be used by you</source>
        <translation>%1 nesmíte používat</translation>
    </message>
    <message>
        <source>%1 GB are free at %2</source>
        <translation>volno je %1 GB v %2</translation>
    </message>
    <message>
        <source>make room: a capture takes some megabytes</source>
        <translation>uvolněte místo: snímek zabere několik megabajtů</translation>
    </message>
    <message>
        <source>%1 is %2 days old, made by version %3 with method %4</source>
        <translation>stáří %1 je %2 dne, vytvořila verze %3 metodou %4</translation>
    </message>
    <message>
        <source>the check below says whether it still fits</source>
        <translation>kontrola níže řekne, zda ještě sedí</translation>
    </message>
    <message>
        <source>calibrate the device</source>
        <translation>kalibrujte zařízení</translation>
    </message>
    <message>
        <source>calibrate this device</source>
        <translation>kalibrujte toto zařízení</translation>
    </message>
    <message>
        <source>little light comes from elsewhere</source>
        <translation>odjinud přichází málo světla</translation>
    </message>
    <message>
        <source>they light the picture</source>
        <translation>osvětlují obraz</translation>
    </message>
    <message>
        <source>it lights its stripes</source>
        <translation>kreslí své laserové pruhy</translation>
    </message>
    <message>
        <source>it is of a camera of %1 x %2 pixels</source>
        <translation>patří ke kameře s %1 x %2 pixely</translation>
    </message>
    <message>
        <source>its stripes lie %1 px from where the calibration has them (%2 points)</source>
        <translation>jeho pruhy leží %1 px od míst podle kalibrace (bodů: %2)</translation>
    </message>
    <message>
        <source>camera, laser or backplane moved: calibrate again</source>
        <translation>kamera, laser nebo podložka se pohnuly: kalibrujte znovu</translation>
    </message>
    <message>
        <source>clear the backplane and ask again; if it is clear, calibrate again</source>
        <translation>uvolněte podložku a zkuste znovu; je-li volná, kalibrujte znovu</translation>
    </message>
    <message>
        <source>something else is being done; wait for it, or cancel it</source>
        <translation>právě běží něco jiného; počkejte na to, nebo to zrušte</translation>
    </message>
    <message>
        <source>no device is open; choose one on the device page</source>
        <translation>žádné zařízení není otevřené; zvolte je na stránce Zařízení</translation>
    </message>
    <message>
        <source>no device is open; open one on the device page, or calibrate from a folder that holds a series</source>
        <translation>žádné zařízení není otevřené; otevřete je na stránce Zařízení, nebo kalibrujte ze složky se sérií</translation>
    </message>
    <message>
        <source>no device is named; choose a device.toml, or write virtual</source>
        <translation>není uvedeno žádné zařízení; zvolte device.toml, nebo napište virtual</translation>
    </message>
    <message>
        <source>there is no surface to export; scan or open one first</source>
        <translation>není žádný povrch k exportu; nejprve jej naskenujte nebo otevřete</translation>
    </message>
    <message>
        <source>only points are open and .%1 files hold meshes; export them as .ply</source>
        <translation>otevřené jsou jen body a soubory .%1 obsahují sítě; exportujte je jako .ply</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not say which file to write; end it with .ply, .obj, .stl, .glb or .png</source>
        <translation>„%1“ neříká, jaký soubor zapsat; zakončete název .ply, .obj, .stl, .glb nebo .png</translation>
    </message>
    <message>
        <source>a capture needs the calibration of its device; open a calibration.json first</source>
        <translation>snímek potřebuje kalibraci svého zařízení; nejprve otevřete calibration.json</translation>
    </message>
    <message>
        <source>%1 is neither a capture folder nor a PLY file; drop one of those</source>
        <translation>%1 není ani složka snímku, ani soubor PLY; přetáhněte sem jedno z toho</translation>
    </message>
    <message>
        <source>what was dropped is no file of this machine; drop a capture folder or a PLY file</source>
        <translation>co bylo přetaženo, není soubor tohoto počítače; přetáhněte složku snímku nebo soubor PLY</translation>
    </message>
    <message>
        <source>laser %1: height error before</source>
        <translation>laser %1: chyba výšky před</translation>
    </message>
    <message>
        <source>laser %1: height error after</source>
        <translation>laser %1: chyba výšky po</translation>
    </message>
    <message>
        <source>laser %1: points</source>
        <translation>laser %1: body</translation>
    </message>
    <message>
        <source>how the object is found in the image (§3.4)</source>
        <translation>jak se v obraze najde objekt (§3.4)</translation>
    </message>
    <message>
        <source>how stripes are located (§3.4)</source>
        <translation>jak se určí poloha pruhů (§3.4)</translation>
    </message>
    <message>
        <source>how stripes get their orders (§3.5)</source>
        <translation>jak pruhy dostanou své řády (§3.5)</translation>
    </message>
    <message>
        <source>whether the surface&apos;s brightness is taken off the stripes&apos; centres (ridges)</source>
        <translation>zda se ze středů pruhů odečte jas povrchu (ridge)</translation>
    </message>
    <message>
        <source>model of a light sheet (§3.6)</source>
        <translation>model světelné plochy (§3.6)</translation>
    </message>
    <message>
        <source>surface error correction of plane sheets (3.9)</source>
        <translation>korekce chyb povrchu u rovinných světelných ploch (3.9)</translation>
    </message>
    <message>
        <source>how the lasers are merged</source>
        <translation>jak se sloučí lasery</translation>
    </message>
    <message>
        <source>a stripe keeps its order where any other costs this much more (joint)</source>
        <translation>pruh si ponechá svůj řád, kde každý jiný stojí o tolik více (joint)</translation>
    </message>
    <message>
        <source>the same for a whole surface</source>
        <translation>totéž pro celý povrch</translation>
    </message>
    <message>
        <source>how far the surface goes on beyond the last points, mm (robust)</source>
        <translation>jak daleko povrch pokračuje za poslední body, mm (robust)</translation>
    </message>
    <message>
        <source>widest gap between points that closes, mm (robust)</source>
        <translation>nejširší mezera mezi body, která se uzavře, mm (robust)</translation>
    </message>
    <message>
        <source>a point further from the surface than this, mm, and than … (robust)</source>
        <translation>bod vzdálený od povrchu více než toto, mm, a více než … (robust)</translation>
    </message>
    <message>
        <source>… that many of its sigma is left out (robust)</source>
        <translation>… tolik jeho sigma, se vynechá (robust)</translation>
    </message>
    <message>
        <source>side of the mask&apos;s opening, px</source>
        <translation>strana okna při otevření masky (morfologie), px</translation>
    </message>
    <message>
        <source>least contrast of the object, 255ths of the background</source>
        <translation>nejmenší kontrast objektu, 255tiny pozadí</translation>
    </message>
    <message>
        <source>window of the stripes&apos; adaptive threshold, px</source>
        <translation>okno adaptivního prahu pruhů, px</translation>
    </message>
    <message>
        <source>edge response above its local mean, grey values</source>
        <translation>odezva hrany nad jejím místním průměrem, stupně šedi</translation>
    </message>
    <message>
        <source>side of the stripe mask&apos;s median, px</source>
        <translation>okno mediánového filtru masky pruhů, px</translation>
    </message>
    <message>
        <source>smallest stripe region, px</source>
        <translation>nejmenší oblast pruhu, px</translation>
    </message>
    <message>
        <source>shortest stripe, px</source>
        <translation>nejkratší pruh, px</translation>
    </message>
    <message>
        <source>rows on either side smoothed together, px</source>
        <translation>řádky na každé straně vyhlazované společně, px</translation>
    </message>
    <message>
        <source>jump that parts a stripe, px</source>
        <translation>skok, který pruh rozdělí, px</translation>
    </message>
    <message>
        <source>V of Algorithm 2, in usual spacings</source>
        <translation>V z algoritmu 2, v obvyklých rozestupech</translation>
    </message>
    <message>
        <source>share of the central order&apos;s contrast that a level must show to be central</source>
        <translation>podíl kontrastu prostředního řádu, který musí úroveň mít, aby byla prostřední</translation>
    </message>
    <message>
        <source>grid of the height field, mm; robust fusion&apos;s mesh has a node each 1.25 of it</source>
        <translation>mřížka výškového pole, mm; síť robustní fúze má uzel po každých 1,25 z toho</translation>
    </message>
    <message>
        <source>widest gap between stripes that is bridged, mm</source>
        <translation>nejširší mezera mezi pruhy, která se překlene, mm</translation>
    </message>
    <message>
        <source>steepest surface between stripes, degrees</source>
        <translation>nejstrmější povrch mezi pruhy, stupně</translation>
    </message>
    <message>
        <source>no device is open; open one on the Device page, then capture</source>
        <translation>žádné zařízení není otevřené; otevřete je na stránce Zařízení a pak pořiďte snímek</translation>
    </message>
    <message>
        <source>cannot write %1: %2; choose a folder that you may write to and that has room</source>
        <translation>%1 nelze zapsat: %2; zvolte složku, do které smíte zapisovat a ve které je místo</translation>
    </message>
    <message>
        <source>cannot write %1: %2; make room or choose a folder that you may write to</source>
        <translation>%1 nelze zapsat: %2; uvolněte místo, nebo zvolte složku, do které smíte zapisovat</translation>
    </message>
    <message>
        <source>cannot write %1: %2</source>
        <translation>%1 nelze zapsat: %2</translation>
    </message>
    <message>
        <source>cannot write to %1: %2</source>
        <translation>do %1 nelze zapisovat: %2</translation>
    </message>
    <message>
        <source>cannot write to %1: it is a file, and a folder is needed</source>
        <translation>do %1 nelze zapisovat: je to soubor a potřebná je složka</translation>
    </message>
    <message>
        <source>cannot write %1: it is a folder; name a file in it</source>
        <translation>%1 nelze zapsat: je to složka; uveďte soubor v ní</translation>
    </message>
    <message>
        <source>cannot write %1: there is no folder %2; make it, or choose another</source>
        <translation>%1 nelze zapsat: složka %2 neexistuje; vytvořte ji, nebo zvolte jinou</translation>
    </message>
    <message>
        <source>cannot write the calibration to %1: its report takes that name; name a .json file</source>
        <translation>kalibraci nelze zapsat do %1: tento název dostane její zpráva; uveďte soubor .json</translation>
    </message>
    <message>
        <source>cannot read %1: %2</source>
        <translation>%1 nelze přečíst: %2</translation>
    </message>
    <message>
        <source>cannot read the folder %1: %2</source>
        <translation>složku %1 nelze přečíst: %2</translation>
    </message>
    <message>
        <source>the folder %1 cannot be read: %2</source>
        <translation>složku %1 nelze přečíst: %2</translation>
    </message>
    <message>
        <source>cannot make the folder %1: %2</source>
        <translation>složku %1 nelze vytvořit: %2</translation>
    </message>
    <message>
        <source>cannot rename %1: %2</source>
        <translation>%1 nelze přejmenovat: %2</translation>
    </message>
    <message>
        <source>cannot remove %1: %2</source>
        <translation>%1 nelze smazat: %2</translation>
    </message>
    <message>
        <source>cannot replace %1: %2</source>
        <translation>%1 nelze nahradit: %2</translation>
    </message>
    <message>
        <source>cannot put back %1: %2</source>
        <translation>%1 nelze vrátit zpět: %2</translation>
    </message>
    <message>
        <source>cannot set the time of %1: %2</source>
        <translation>čas souboru %1 nelze nastavit: %2</translation>
    </message>
    <message>
        <source>there is no file %1</source>
        <translation>soubor %1 neexistuje</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 není soubor</translation>
    </message>
    <message>
        <source>%1 is %2 bytes; at most %3 are expected here</source>
        <translation>%1 má %2 bajtů; zde se čeká nejvýše %3</translation>
    </message>
    <message>
        <source>%1 cannot be written to</source>
        <translation>do %1 nelze zapisovat</translation>
    </message>
    <message>
        <source>choose another folder, or ask for the right to write there</source>
        <translation>zvolte jinou složku, nebo požádejte o právo tam zapisovat</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>přístup odepřen</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>operace není povolena</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>na disku není místo</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>disková kvóta je vyčerpána</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>soubor je příliš velký</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>soubor ani složka neexistuje</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>soubor již existuje</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>je to složka</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>není to složka</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>složka není prázdná</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>název je příliš dlouhý</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>disk je jen pro čtení</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>chyba vstupu nebo výstupu</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>příliš mnoho otevřených souborů</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>síťový disk už není k dispozici</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>právě se používá</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>zařízení už tu není</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>zařízení už tu není</translation>
    </message>
    <message>
        <source>%1 is not valid JSON; write it again or restore it</source>
        <translation>%1 není platný JSON; zapište jej znovu, nebo jej obnovte</translation>
    </message>
    <message>
        <source>%1 is not valid JSON (it holds NaN or Infinity); write it again or restore it</source>
        <translation>%1 není platný JSON (obsahuje NaN nebo Infinity); zapište jej znovu, nebo jej obnovte</translation>
    </message>
    <message>
        <source>%1 is not valid JSON; restore it from a copy</source>
        <translation>%1 není platný JSON; obnovte jej z kopie</translation>
    </message>
    <message>
        <source>%1 is not valid JSON; calibrate again</source>
        <translation>%1 není platný JSON; kalibrujte znovu</translation>
    </message>
    <message>
        <source>%1: a JSON object is expected</source>
        <translation>%1: očekává se objekt JSON</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is missing</source>
        <translation>%1: chybí „%2“</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a number between %3 and %4, not %5</source>
        <translation>%1: „%2“ musí být číslo mezi %3 a %4, ne %5</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a whole number</source>
        <translation>%1: „%2“ musí být celé číslo</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a text</source>
        <translation>%1: „%2“ musí být text</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be true or false</source>
        <translation>%1: „%2“ musí být true nebo false</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a list of %3 numbers</source>
        <translation>%1: „%2“ musí být seznam čísel o délce %3</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a list of numbers</source>
        <translation>%1: „%2“ musí být seznam čísel</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must hold numbers between %3 and %4, not %5</source>
        <translation>%1: „%2“ musí obsahovat čísla mezi %3 a %4, ne %5</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be an object</source>
        <translation>%1: „%2“ musí být objekt</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; must be a list of at most %3 entries</source>
        <translation>%1: „%2“ musí být seznam nejvýše %3 položek</translation>
    </message>
    <message>
        <source>%1 is not a %2 file</source>
        <translation>%1 není soubor %2</translation>
    </message>
    <message>
        <source>%1 is not a %2 file but a %3 file</source>
        <translation>%1 není soubor %2, ale soubor %3</translation>
    </message>
    <message>
        <source>%1: &apos;version&apos; is %2, newer than this program reads (%3); use a newer program</source>
        <translation>%1: „version“ je %2, novější, než tento program čte (%3); použijte novější program</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, řádek %2: %3</translation>
    </message>
    <message>
        <source>%1: unknown key %2; known here: %3</source>
        <translation>%1: neznámý klíč %2; zde jsou známé: %3</translation>
    </message>
    <message>
        <source>%1: %2 is %3; it must be %4</source>
        <translation>%1: %2 je %3; musí to být %4</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>číslo od %1 do %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>celé číslo od %1 do %2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>text v uvozovkách</translation>
    </message>
    <message>
        <source>a list of %1 numbers from %2 to %3</source>
        <translation>seznam čísel od %2 do %3 o délce %1</translation>
    </message>
    <message>
        <source>a list of 1 to %1 numbers from %2 to %3</source>
        <translation>seznam 1 až %1 čísel od %2 do %3</translation>
    </message>
    <message>
        <source>0 (left as it is) or from %1 to %2</source>
        <translation>0 (zůstane, jak je) nebo od %1 do %2</translation>
    </message>
    <message>
        <source>0 (none) or from %1 to %2</source>
        <translation>0 (žádná) nebo od %1 do %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or &quot;%2&quot;</source>
        <translation>&quot;%1&quot; nebo &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1: %2; write the file again</source>
        <translation>%1: %2; zapište soubor znovu</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>je useknutý</translation>
    </message>
    <message>
        <source>it is not a PLY file</source>
        <translation>není to soubor PLY</translation>
    </message>
    <message>
        <source>its format is %1, not binary_little_endian</source>
        <translation>jeho formát je %1, ne binary_little_endian</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>jeho hlavička je poškozená</translation>
    </message>
    <message>
        <source>its vertices have no property &apos;%1&apos;</source>
        <translation>jeho vrcholům chybí vlastnost „%1“</translation>
    </message>
    <message>
        <source>a face has %1 corners</source>
        <translation>ploška má vrcholů: %1</translation>
    </message>
    <message>
        <source>it does not begin with vertices</source>
        <translation>nezačíná vrcholy</translation>
    </message>
    <message>
        <source>point %1 is not a number</source>
        <translation>bod %1 není číslo</translation>
    </message>
    <message>
        <source>point %1 has no such laser or order</source>
        <translation>laser ani řád bodu %1 neexistuje</translation>
    </message>
    <message>
        <source>vertex %1 is not a number</source>
        <translation>vrchol %1 není číslo</translation>
    </message>
    <message>
        <source>it has faces that are not triangles</source>
        <translation>má plošky, které nejsou trojúhelníky</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>ploška odkazuje na vrchol, který neexistuje</translation>
    </message>
    <message>
        <source>the surface is empty, so there is no mesh to write to %1</source>
        <translation>povrch je prázdný, takže do %1 není jakou síť zapsat</translation>
    </message>
    <message>
        <source>the view could not be made a picture</source>
        <translation>z pohledu nelze udělat obrázek</translation>
    </message>
    <message>
        <source>the two places lie on parts of the surface that do not touch; choose two on one part</source>
        <translation>obě místa leží na částech povrchu, které se nedotýkají; zvolte dvě na jedné části</translation>
    </message>
    <message>
        <source>the two places stand one above the other; choose two that lie side by side</source>
        <translation>obě místa leží nad sebou; zvolte dvě vedle sebe</translation>
    </message>
    <message>
        <source>the camera %1</source>
        <translation>kamera %1</translation>
    </message>
    <message>
        <source>the stream %1</source>
        <translation>videoproud %1</translation>
    </message>
    <message>
        <source>the recording %1</source>
        <translation>záznam %1</translation>
    </message>
    <message>
        <source>light controller on %1</source>
        <translation>řízení světel na %1</translation>
    </message>
    <message>
        <source>there is no camera under /dev/video; connect one, or set camera.source</source>
        <translation>pod /dev/video není žádná kamera; připojte ji, nebo nastavte camera.source</translation>
    </message>
    <message>
        <source>none of the cameras can be used: %1 %2</source>
        <translation>žádnou z kamer nelze použít: %1 %2</translation>
    </message>
    <message>
        <source>cannot be opened: %1; add yourself to the group &quot;video&quot; (sudo usermod -aG video $USER) and log in again</source>
        <translation>nelze otevřít: %1; přidejte se do skupiny &quot;video&quot; (sudo usermod -aG video $USER) a znovu se přihlaste</translation>
    </message>
    <message>
        <source>cannot be opened: %1; close the other program that uses it</source>
        <translation>nelze otevřít: %1; zavřete jiný program, který ji používá</translation>
    </message>
    <message>
        <source>cannot be opened: %1; unplug it and plug it in</source>
        <translation>nelze otevřít: %1; odpojte ji a znovu zapojte</translation>
    </message>
    <message>
        <source>does not answer as a camera; unplug it and plug it in</source>
        <translation>neodpovídá jako kamera; odpojte ji a znovu zapojte</translation>
    </message>
    <message>
        <source>the camera source &quot;%1&quot; is none: give a number, /dev/videoN, http://…, a video file or a folder that exists, or virtual[:SEED]</source>
        <translation>zdroj kamery &quot;%1&quot; neexistuje: zadejte číslo, /dev/videoN, http://…, soubor videa nebo složku, které existují, nebo virtual[:SEED]</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2; add yourself to the group &quot;video&quot; and log in again</source>
        <translation>%1 nelze otevřít: %2; přidejte se do skupiny &quot;video&quot; a znovu se přihlaste</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2; close the other program that uses it</source>
        <translation>%1 nelze otevřít: %2; zavřete jiný program, který ji používá</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2; check that it is connected</source>
        <translation>%1 nelze otevřít: %2; zkontrolujte, zda je připojena</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check that it is connected</source>
        <translation>%1 nelze otevřít; zkontrolujte připojení</translation>
    </message>
    <message>
        <source>%1 cannot be opened as a camera; close other programs that use it, or choose another one with camera.source</source>
        <translation>%1 nelze otevřít jako kameru; zavřete jiné programy, které ji používají, nebo zvolte jinou pomocí camera.source</translation>
    </message>
    <message>
        <source>%1 is no video that can be read, or it is damaged; record it again</source>
        <translation>%1 není čitelné video, nebo je poškozený; nahrajte jej znovu</translation>
    </message>
    <message>
        <source>%1 did not answer within %2; check the address, and that the camera is on and in the network</source>
        <translation>%1 neodpověděl do %2; zkontrolujte adresu a zda je kamera zapnutá a v síti</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check the address, and that the camera is on and in the network</source>
        <translation>%1 nelze otevřít; zkontrolujte adresu a zda je kamera zapnutá a v síti</translation>
    </message>
    <message>
        <source>%1 is gone; check its cable and plug it in again</source>
        <translation>%1 už tu není; zkontrolujte kabel a znovu jej zapojte</translation>
    </message>
    <message>
        <source>%1 is gone; check that the camera is on and connected, and start again</source>
        <translation>%1 už tu není; zkontrolujte, zda je kamera zapnutá a připojená, a začněte znovu</translation>
    </message>
    <message>
        <source>%1 was closed by the other side; check that the camera is on and connected, and start again</source>
        <translation>%1 zavřela protější strana; zkontrolujte, zda je kamera zapnutá a připojená, a začněte znovu</translation>
    </message>
    <message>
        <source>%1 stopped sending pictures: none came for %2; check its cable and plug it in again</source>
        <translation>%1 přestala posílat obrazy: %2 žádný nepřišel; zkontrolujte kabel a znovu jej zapojte</translation>
    </message>
    <message>
        <source>%1 is cut off after %2 frames of %3; copy or record it again</source>
        <translation>%1 je useknutý: z %3 snímků je jich tu %2; zkopírujte nebo nahrajte jej znovu</translation>
    </message>
    <message>
        <source>%1 is cut off after 1 frame of %2; copy or record it again</source>
        <translation>%1 je useknutý: z %2 snímků je tu 1; zkopírujte nebo nahrajte jej znovu</translation>
    </message>
    <message>
        <source>%1 has ended after %2 frames; record more, or begin again</source>
        <translation>%1 skončil, počet snímků: %2; nahrajte více, nebo začněte znovu</translation>
    </message>
    <message>
        <source>%1 has ended after 1 frame; record more, or begin again</source>
        <translation>%1 skončil po 1 snímku; nahrajte více, nebo začněte znovu</translation>
    </message>
    <message>
        <source>%1 has no more images after %2; record more, or begin again</source>
        <translation>%1 po %2 nemá další obrazy; nahrajte více, nebo začněte znovu</translation>
    </message>
    <message>
        <source>there is no PNG or JPEG image in %1 to take for a camera&apos;s</source>
        <translation>v %1 není obraz PNG ani JPEG, který by se dal vzít místo kamery</translation>
    </message>
    <message>
        <source>%1 has no picture under these lights together</source>
        <translation>%1 nemá obraz s těmito světly zároveň</translation>
    </message>
    <message>
        <source>%1 failed: %2; start again</source>
        <translation>%1 selhala: %2; začněte znovu</translation>
    </message>
    <message>
        <source>%1 is damaged or cut off at frame %2, counted from 0; copy or record it again</source>
        <translation>%1 je u snímku %2, počítáno od 0, poškozený nebo useknutý; zkopírujte nebo nahrajte jej znovu</translation>
    </message>
    <message>
        <source>%1 sends damaged pictures only; check its cable, or choose a lower resolution or another stream_format</source>
        <translation>%1 posílá jen poškozené obrazy; zkontrolujte kabel, nebo zvolte menší rozlišení nebo jiný stream_format</translation>
    </message>
    <message>
        <source>%1 sends pictures of %2 pixels, but %3 is expected; set camera.resolution_px to what it can do</source>
        <translation>%1 posílá obrazy s %2 pixely, ale čeká se %3; nastavte camera.resolution_px na to, co umí</translation>
    </message>
    <message>
        <source>%1 sent a picture of %2 pixels instead of %3; start again</source>
        <translation>%1 poslala obraz s %2 pixely místo %3; začněte znovu</translation>
    </message>
    <message>
        <source>%1 gave no picture within %2; check that it is connected and that no other program uses it</source>
        <translation>%1 nedala do %2 žádný obraz; zkontrolujte, zda je připojena a žádný jiný program ji nepoužívá</translation>
    </message>
    <message>
        <source>%1 sent no picture within %2; check that it is connected and that no other program uses it</source>
        <translation>%1 neposlala do %2 žádný obraz; zkontrolujte, zda je připojena a žádný jiný program ji nepoužívá</translation>
    </message>
    <message>
        <source>%1 sent no picture within %2; check that it is connected</source>
        <translation>%1 neposlala do %2 žádný obraz; zkontrolujte, zda je připojena</translation>
    </message>
    <message>
        <source>%1 sent only %2 picture(s) after the light changed, within %3; it is too slow: shorten the exposure or give it more time</source>
        <translation>%1 poslala po změně světla do %3 jen tolik obrazů: %2; je příliš pomalá: zkraťte expozici, nebo jí dejte více času</translation>
    </message>
    <message>
        <source>%1 is frozen: it sends the same picture again and again; unplug it and plug it in</source>
        <translation>%1 zamrzla: posílá stále stejný obraz; odpojte ji a znovu zapojte</translation>
    </message>
    <message>
        <source>%1 hangs: its exposure cannot be set; plug it in again</source>
        <translation>%1 se zasekla: expozici nelze nastavit; zapojte ji znovu</translation>
    </message>
    <message>
        <source>the picture of %1 did not settle within %2: frames still differ by %3 grey levels; keep the hand still, shade other lights, and set a fixed exposure (camera.laser_exposure_s and led_exposure_s)</source>
        <translation>obraz se do %2 neustálil (%1): snímky se stále liší o %3 stupňů šedi; držte ruku v klidu, zastiňte jiná světla a nastavte pevnou expozici (camera.laser_exposure_s a led_exposure_s)</translation>
    </message>
    <message>
        <source>the camera did not take %1 %2; it is %3</source>
        <translation>kamera nepřijala %1 %2; je to %3</translation>
    </message>
    <message>
        <source>the camera did not take %1 %2: it has no such control</source>
        <translation>kamera nepřijala %1 %2; toto nastavení nemá</translation>
    </message>
    <message>
        <source>the camera chooses its exposure itself, so pictures may not be comparable; set camera.laser_exposure_s and camera.led_exposure_s</source>
        <translation>kamera si volí expozici sama, takže obrazy nemusí být srovnatelné; nastavte camera.laser_exposure_s a camera.led_exposure_s</translation>
    </message>
    <message>
        <source>cameras need %1, which is missing or cannot be loaded; install Dorsum again, with OpenCV&apos;s videoio</source>
        <translation>kamery potřebují %1, který chybí nebo jej nelze načíst; nainstalujte Dorsum znovu, s videoio z OpenCV</translation>
    </message>
    <message>
        <source>there is no port %1; plug the light controller in, or correct controller.port in the device description</source>
        <translation>port %1 neexistuje; připojte řízení světel, nebo opravte controller.port v popisu zařízení</translation>
    </message>
    <message>
        <source>no permission to use %1; join the group dialout (sudo usermod -aG dialout $USER, then log in anew) or add the udev rule of docs/light-controller.md</source>
        <translation>chybí oprávnění používat %1; přidejte se do skupiny dialout (sudo usermod -aG dialout $USER, pak se znovu přihlaste), nebo přidejte pravidlo udev z docs/light-controller.md</translation>
    </message>
    <message>
        <source>%1 is in use by another program; close that first</source>
        <translation>%1 používá jiný program; nejprve jej zavřete</translation>
    </message>
    <message>
        <source>%1 is no serial port; name the light controller&apos;s as controller.port</source>
        <translation>%1 není sériový port; jako controller.port uveďte port řízení světel</translation>
    </message>
    <message>
        <source>cannot open %1: %2; unplug the light controller and plug it in again</source>
        <translation>%1 nelze otevřít: %2; odpojte řízení světel a znovu je zapojte</translation>
    </message>
    <message>
        <source>no serial port runs at %1 baud; set controller.baud to 115200, the firmware&apos;s</source>
        <translation>žádný sériový port neběží na %1 baudech; nastavte controller.baud na 115200 jako firmware</translation>
    </message>
    <message>
        <source>the light controller on %1 is gone; check its cable and plug it in again, then start over</source>
        <translation>řízení světel na %1 už tu není; zkontrolujte kabel, znovu jej zapojte a pak začněte znovu</translation>
    </message>
    <message>
        <source>the light controller on %1 speaks protocol %2 (firmware %3), this program protocol %4; flash the firmware that belongs to this program (scripts/firmware)</source>
        <translation>řízení světel na %1 mluví protokolem %2 (firmware %3), tento program protokolem %4; nahrajte firmware, který patří k tomuto programu (scripts/firmware)</translation>
    </message>
    <message>
        <source>what is on %1 talks, but not as a light controller; check controller.port and controller.baud, or flash the firmware (scripts/firmware)</source>
        <translation>co je na %1, odpovídá, ale ne jako řízení světel; zkontrolujte controller.port a controller.baud, nebo nahrajte firmware (scripts/firmware)</translation>
    </message>
    <message>
        <source>no answer from a light controller on %1; check controller.port, cable and power, or flash the firmware (scripts/firmware)</source>
        <translation>žádná odpověď řízení světel na %1; zkontrolujte controller.port, kabel a napájení, nebo nahrajte firmware (scripts/firmware)</translation>
    </message>
    <message>
        <source>the light controller on %1 has restarted in the middle, which switched its lights off; check its power and cable</source>
        <translation>řízení světel na %1 se uprostřed restartovalo, čímž světla zhasla; zkontrolujte napájení a kabel</translation>
    </message>
    <message>
        <source>the light controller on %1 does not answer any more; check its cable and power, then start over</source>
        <translation>řízení světel na %1 už neodpovídá; zkontrolujte kabel a napájení a pak začněte znovu</translation>
    </message>
    <message>
        <source>the light controller on %1 has firmware of %2 logic, but the device description says %3; flash the other firmware or correct the description (docs/light-controller.md)</source>
        <translation>firmware řízení světel na %1 má logiku %2, ale popis zařízení uvádí %3; nahrajte druhý firmware, nebo opravte popis (docs/light-controller.md)</translation>
    </message>
    <message>
        <source>the light controller on %1 does not tell its limits; flash the firmware that belongs to this program (scripts/firmware)</source>
        <translation>řízení světel na %1 neuvádí své meze; nahrajte firmware, který patří k tomuto programu (scripts/firmware)</translation>
    </message>
    <message>
        <source>there is no serial port of a USB device; plug the light controller in, or name its port as controller.port in the device description</source>
        <translation>není tu žádný sériový port USB zařízení; připojte řízení světel, nebo uveďte jeho port jako controller.port v popisu zařízení</translation>
    </message>
    <message>
        <source>no light controller on any of %1 (%2)</source>
        <translation>řízení světel není na žádném z %1 (%2)</translation>
    </message>
    <message>
        <source>the device description asks for channel %1, but the %2 has 0 to %3; correct the channels in the device description</source>
        <translation>popis zařízení žádá kanál %1, ale jsou jen 0 až %3 (%2); opravte kanály v popisu zařízení</translation>
    </message>
    <message>
        <source>the %1 found channel %2 not held off by its resistor when it started, so it does not drive it; check the wiring, and that the firmware&apos;s logic is the circuit&apos;s (docs/light-controller.md)</source>
        <translation>kanál %2 při startu nedržel vypnutý jeho odpor, proto se nespíná (%1); zkontrolujte zapojení a zda logika firmwaru odpovídá obvodu (docs/light-controller.md)</translation>
    </message>
    <message>
        <source>the %1 did not switch its lights as it was told (%2); check its cable and power</source>
        <translation>světla nebyla přepnuta, jak bylo žádáno (%1, %2); zkontrolujte kabel a napájení</translation>
    </message>
    <message>
        <source>the %1 switched its lights off while a picture was taken; it was reset, or its time limit is shorter than the camera needs</source>
        <translation>světla zhasla během snímání (%1); došlo k restartu, nebo je časová mez kratší, než kamera potřebuje</translation>
    </message>
    <message>
        <source>see the report beside %1</source>
        <translation>viz zprávu vedle %1</translation>
    </message>
    <message>
        <source>set it in device.toml to what the camera can do</source>
        <translation>nastavte to v device.toml na to, co kamera umí</translation>
    </message>
    <message>
        <source>%1 can be used</source>
        <translation>%1 lze použít</translation>
    </message>
    <message>
        <source>sudo usermod -aG dialout $USER, then log in again</source>
        <translation>sudo usermod -aG dialout $USER, pak se znovu přihlaste</translation>
    </message>
    <message>
        <source>%1, firmware %2: all off after %3 s without a word from here, a laser after %4 s</source>
        <translation>%1, firmware %2: vše zhasne po %3 s bez zprávy odtud, laser po %4 s</translation>
    </message>
    <message>
        <source>%1, %2 x %3 pixels</source>
        <translation>%1, %2 x %3 pixelů</translation>
    </message>
    <message>
        <source>there is no calibration folder %1</source>
        <translation>kalibrační složka %1 neexistuje</translation>
    </message>
    <message>
        <source>there is no capture folder %1</source>
        <translation>složka snímku %1 neexistuje</translation>
    </message>
    <message>
        <source>there is no image stripesHand0, stripesHand1, … in %1</source>
        <translation>v %1 není obraz stripesHand0, stripesHand1, …</translation>
    </message>
    <message>
        <source>there is no setup.json in %1; it says what the chessboard and the boxes measure</source>
        <translation>v %1 není setup.json; říká, jaké rozměry mají šachovnice a kvádry</translation>
    </message>
    <message>
        <source>the image %1 (.jpg or .png) is missing in %2</source>
        <translation>obraz %1 (.jpg nebo .png) chybí v %2</translation>
    </message>
    <message>
        <source>%1: the background image</source>
        <translation>%1: obraz pozadí</translation>
    </message>
    <message>
        <source>%1 is %2 pixels, more than any camera here has; capture it again</source>
        <translation>%1 má %2 pixelů, více než kterákoli zdejší kamera; pořiďte jej znovu</translation>
    </message>
    <message>
        <source>%1 has %2 bits per channel; 8 are expected, so save it as 8 bit</source>
        <translation>%1 má %2 bitů na kanál; čeká se 8, uložte jej tedy jako 8bitový</translation>
    </message>
    <message>
        <source>%1 is a grey image; the stripes are read from the green channel, so capture it in colour</source>
        <translation>%1 je šedý obraz; pruhy se čtou ze zeleného kanálu, pořiďte jej tedy barevně</translation>
    </message>
    <message>
        <source>%1 is not a plain colour image; the stripes are read from the green channel, so capture it in colour</source>
        <translation>%1 není prostý barevný obraz; pruhy se čtou ze zeleného kanálu, pořiďte jej tedy barevně</translation>
    </message>
    <message>
        <source>%1 is %2 pixels, but %3 is expected; use images of one camera at one resolution</source>
        <translation>%1 má %2 pixelů, ale čeká se %3; použijte obrazy jedné kamery v jednom rozlišení</translation>
    </message>
    <message>
        <source>%1 is cut off: its end is missing; copy or capture it again</source>
        <translation>%1 je useknutý: chybí konec; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 is damaged; copy or capture it again</source>
        <translation>%1 je poškozený; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 is a damaged PNG; copy or capture it again</source>
        <translation>%1 je poškozený PNG; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 is a damaged JPEG; copy or capture it again</source>
        <translation>%1 je poškozený JPEG; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 is empty; copy or capture it again</source>
        <translation>%1 je prázdný; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG image; copy or capture it again</source>
        <translation>%1 není obraz PNG ani JPEG; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 cannot be decoded; copy or capture it again</source>
        <translation>%1 nelze dekódovat; zkopírujte jej znovu, nebo jej pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 is black; check the light and the exposure</source>
        <translation>%1 je černý; zkontrolujte světlo a expozici</translation>
    </message>
    <message>
        <source>%1 is white all over; lower the exposure</source>
        <translation>%1 je celý bílý; snižte expozici</translation>
    </message>
    <message>
        <source>with all lights off %1 of the picture is brighter than it may be; shade the device from daylight, or shorten the camera&apos;s exposure</source>
        <translation>při zhasnutých světlech je %1 obrazu jasnějších, než smí být; zastiňte zařízení před denním světlem, nebo zkraťte expozici kamery</translation>
    </message>
    <message>
        <source>the LEDs light too little of the picture; check their supply and channel, or expose longer</source>
        <translation>LED osvětlují příliš málo obrazu; zkontrolujte jejich napájení a kanál, nebo exponujte déle</translation>
    </message>
    <message>
        <source>%1 of the picture under the LEDs is overexposed; shorten the camera&apos;s exposure under the LEDs, or dim them</source>
        <translation>%1 obrazu pod LED je přeexponováno; zkraťte expozici kamery pod LED, nebo je ztlumte</translation>
    </message>
    <message>
        <source>laser %1 does not light up; check its supply, its cable and its channel</source>
        <translation>laser %1 nesvítí; zkontrolujte jeho napájení, kabel a kanál</translation>
    </message>
    <message>
        <source>%1 of the picture under laser %2 is overexposed; shorten the camera&apos;s exposure for the lasers</source>
        <translation>%1 obrazu pod laserem %2 je přeexponováno; zkraťte expozici kamery pro lasery</translation>
    </message>
    <message>
        <source>the pictures of lasers %1 and %2 show the same stripes; check their cables, and that their channels in device.toml differ</source>
        <translation>obrazy laserů %1 a %2 ukazují stejné pruhy; zkontrolujte jejich kabely a zda se jejich kanály v device.toml liší</translation>
    </message>
    <message>
        <source>laser %1 was lit in place of laser %2: its cable is plugged elsewhere than when the device was calibrated, or a laser&apos;s channel in device.toml is wrong</source>
        <translation>laser %1 svítil místo laseru %2: kabel je zapojen jinam než při kalibraci zařízení, nebo je kanál laseru v device.toml špatně</translation>
    </message>
    <message>
        <source>the hand moved by %1 while it was captured; rest it on the backplane and capture again</source>
        <translation>ruka se během snímání pohnula o %1; položte ji v klidu na podložku a snímejte znovu</translation>
    </message>
    <message>
        <source>the hand moved by %1 while it was captured</source>
        <translation>ruka se během snímání pohnula o %1</translation>
    </message>
    <message>
        <source>the hand leaves the picture at more than one place; move it to the middle, so that only the wrist runs out</source>
        <translation>ruka vybíhá z obrazu na více místech; posuňte ji doprostřed, aby ven vedlo jen zápěstí</translation>
    </message>
    <message>
        <source>the device has no laser %1: its lasers are 0 to %2</source>
        <translation>zařízení nemá laser %1: jeho lasery jsou 0 až %2</translation>
    </message>
    <message>
        <source>%1 is there already and not empty; name a new folder</source>
        <translation>%1 již existuje a není prázdná; uveďte novou složku</translation>
    </message>
    <message>
        <source>%1 is of a camera of %2 pixels, the device&apos;s has %3; calibrate this device</source>
        <translation>%1 patří ke kameře s %2 pixely, kamera zařízení má %3; kalibrujte toto zařízení</translation>
    </message>
    <message>
        <source>%1 is of another device or board than %2; go on with that device, or name a new folder</source>
        <translation>%1 patří k jinému zařízení nebo šachovnici než %2; pokračujte s oním zařízením, nebo uveďte novou složku</translation>
    </message>
    <message>
        <source>no hand is seen in bgHand: it looks like the empty background; put the hand down and capture again</source>
        <translation>v bgHand není vidět ruka: vypadá jako prázdné pozadí; položte ruku a snímejte znovu</translation>
    </message>
    <message>
        <source>bgHand differs from the background nearly everywhere; the light or the camera changed since the calibration, so calibrate again</source>
        <translation>bgHand se od pozadí liší téměř všude; světlo nebo kamera se od kalibrace změnily, kalibrujte tedy znovu</translation>
    </message>
    <message>
        <source>no object is seen: a few stripes seem to lie on one, but make no outline together with bgHand; put the hand down and capture again</source>
        <translation>není vidět žádný objekt: několik pruhů na něm snad leží, ale s bgHand nedávají obrys; položte ruku a snímejte znovu</translation>
    </message>
    <message>
        <source>the object seems to fill the picture, so its outline is not seen; look whether bgHand and the stripes are of one capture and the calibration is this device&apos;s</source>
        <translation>objekt zřejmě vyplňuje obraz, takže není vidět jeho obrys; ověřte, zda bgHand a pruhy jsou z jednoho snímku a kalibrace je z tohoto zařízení</translation>
    </message>
    <message>
        <source>only shadow is seen in bgHand: the object is as bright as the backplane, or it is gone; cover a white object with something darker and capture again</source>
        <translation>v bgHand je vidět jen stín: objekt je stejně jasný jako podložka, nebo zmizel; bílý objekt zakryjte něčím tmavším a snímejte znovu</translation>
    </message>
    <message>
        <source>the stripes of laser %1 lie %2 px beside their places on the backplane: camera, laser or backplane moved since the calibration; calibrate again</source>
        <translation>pruhy laseru %1 leží %2 px vedle svých míst na podložce: kamera, laser nebo podložka se od kalibrace pohnuly; kalibrujte znovu</translation>
    </message>
    <message>
        <source>no stripe is seen on the object; are the lasers on, and is the capture of this device?</source>
        <translation>na objektu není vidět žádný pruh; svítí lasery a je snímek z tohoto zařízení?</translation>
    </message>
    <message>
        <source>the calibration is for images of %1, but the capture has %2; use the calibration of this camera and resolution</source>
        <translation>kalibrace je pro obrazy %1, ale snímek má %2; použijte kalibraci této kamery a rozlišení</translation>
    </message>
    <message>
        <source>the calibration holds no %1 sheets for laser %2; calibrate with --method %3, or reconstruct with --sheets %4</source>
        <translation>kalibrace neobsahuje světelné plochy %1 pro laser %2; kalibrujte s --method %3, nebo rekonstruujte s --sheets %4</translation>
    </message>
    <message>
        <source>the stripes shine as those of other orders do, so the object reaches out of the working volume of %1 to %2 mm; place it lower and capture again</source>
        <translation>pruhy září jako pruhy jiných řádů, objekt tedy přesahuje pracovní prostor od %1 do %2 mm; umístěte jej níže a snímejte znovu</translation>
    </message>
    <message>
        <source>the lasers put the object at heights that differ by %1 mm: it reaches out of the working volume of %2 to %3 mm, or moved while it was captured; place it lower and capture again</source>
        <translation>lasery kladou objekt do výšek, které se liší o %1 mm: přesahuje pracovní prostor od %2 do %3 mm, nebo se během snímání pohnul; umístěte jej níže a snímejte znovu</translation>
    </message>
    <message>
        <source>the lasers see the object at places that differ by %1 mm: it moved while it was captured, or reaches out of the working volume of %2 to %3 mm; place it lower, keep still and capture again</source>
        <translation>lasery vidí objekt na místech, která se liší o %1 mm: během snímání se pohnul, nebo přesahuje pracovní prostor od %2 do %3 mm; umístěte jej níže, držte jej v klidu a snímejte znovu</translation>
    </message>
    <message>
        <source>the object moved by about %1 mm while it was captured, since the lasers see it at different places; keep still and capture again</source>
        <translation>objekt se během snímání pohnul asi o %1 mm, neboť jej lasery vidí na různých místech; držte jej v klidu a snímejte znovu</translation>
    </message>
    <message>
        <source>stages are shown of a capture with its calibration; take one, or open its folder</source>
        <translation>kroky se zobrazují pro snímek s jeho kalibrací; pořiďte jej, nebo otevřete jeho složku</translation>
    </message>
    <message>
        <source>%1: the camera&apos;s matrix or pose is not one of a camera above the backplane</source>
        <translation>%1: matice nebo poloha kamery neodpovídá kameře nad podložkou</translation>
    </message>
    <message>
        <source>%1: laser %2 has no light sheets; calibrate again</source>
        <translation>%1: laser %2 nemá světelné plochy; kalibrujte znovu</translation>
    </message>
    <message>
        <source>%1: the working volume&apos;s bottom is not below its top</source>
        <translation>%1: dno pracovního prostoru není pod jeho vrchem</translation>
    </message>
    <message>
        <source>%1: the lasers are not in ascending order</source>
        <translation>%1: lasery nejsou ve vzestupném pořadí</translation>
    </message>
    <message>
        <source>%1 holds no laser; calibrate again</source>
        <translation>%1 neobsahuje žádný laser; kalibrujte znovu</translation>
    </message>
    <message>
        <source>%1: the background image is damaged; calibrate again</source>
        <translation>%1: obraz pozadí je poškozený; kalibrujte znovu</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen in %2, which fixes the world; capture it again or correct setup.json</source>
        <translation>v %2, který určuje souřadnice světa, není vidět šachovnice s %1 vnitřními rohy; pořiďte jej znovu, nebo opravte setup.json</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen in %2; capture it again or correct setup.json</source>
        <translation>v %2 není vidět šachovnice s %1 vnitřními rohy; pořiďte jej znovu, nebo opravte setup.json</translation>
    </message>
    <message>
        <source>a chessboard is seen in only %1 of %2 views; at least %3 are needed, so capture the chessboards again</source>
        <translation>šachovnice je vidět jen v %1 z %2 pohledů; potřeba je nejméně %3, pořiďte tedy šachovnice znovu</translation>
    </message>
    <message>
        <source>the chessboard views do not determine the camera; capture them again with the board tilted differently in each</source>
        <translation>pohledy na šachovnici kameru neurčují; pořiďte je znovu s šachovnicí pokaždé jinak nakloněnou</translation>
    </message>
    <message>
        <source>the chessboard lies alike in all views, which leaves the focal length open; capture chess00, chess01, … again with the board tilted differently in each</source>
        <translation>šachovnice leží ve všech pohledech stejně, takže ohnisková vzdálenost zůstává neurčená; pořiďte chess00, chess01, … znovu s šachovnicí pokaždé jinak nakloněnou</translation>
    </message>
    <message>
        <source>the stripes and chessboards do not determine the device; capture the series again</source>
        <translation>pruhy a šachovnice zařízení neurčují; pořiďte sérii znovu</translation>
    </message>
    <message>
        <source>only %1 whole stripes of laser %2 are seen in %3; capture it again with a longer exposure</source>
        <translation>v %3 je vidět jen %1 celých pruhů laseru %2; pořiďte jej znovu s delší expozicí</translation>
    </message>
    <message>
        <source>the central stripe of laser %1 is not seen in %2; capture it again</source>
        <translation>prostřední pruh laseru %1 není v %2 vidět; pořiďte jej znovu</translation>
    </message>
    <message>
        <source>no drawn lines are seen in laserFirstEstimates; capture the laser calibration plane again</source>
        <translation>v laserFirstEstimates nejsou vidět nakreslené čáry; pořiďte laserovou kalibrační rovinu znovu</translation>
    </message>
    <message>
        <source>no stripes are seen in %1; is laser %2 on and the exposure right? Capture it again</source>
        <translation>v %1 nejsou vidět pruhy; svítí laser %2 a je expozice správná? Pořiďte jej znovu</translation>
    </message>
    <message>
        <source>only %1 stripes are seen in %2; is laser %3 on and the exposure long enough?</source>
        <translation>v %2 je vidět jen %1 pruhů; svítí laser %3 a je expozice dost dlouhá?</translation>
    </message>
    <message>
        <source>only %1 stripes of laser %2 are seen on the backplane; capture %3 again with a longer exposure</source>
        <translation>na podložce je vidět jen %1 pruhů laseru %2; pořiďte %3 znovu s delší expozicí</translation>
    </message>
    <message>
        <source>only %1 stripes of laser %2 are seen on the calibration object; capture %3 again with a longer exposure</source>
        <translation>na kalibračním tělese je vidět jen %1 pruhů laseru %2; pořiďte %3 znovu s delší expozicí</translation>
    </message>
    <message>
        <source>fewer than three stripes of laser %1 are seen at both distances; capture %2 and %3 again</source>
        <translation>v obou vzdálenostech jsou vidět méně než tři pruhy laseru %1; pořiďte %2 a %3 znovu</translation>
    </message>
    <message>
        <source>the stripes of laser %1 are not closer together on the calibration object than on the backplane; are the Closer and Further images swapped?</source>
        <translation>pruhy laseru %1 nejsou na kalibračním tělese blíže u sebe než na podložce; nejsou obrazy Closer a Further zaměněné?</translation>
    </message>
    <message>
        <source>the chessboard under laser %1 does not lie higher on the calibration object than on the backplane; are the Closer and Further images swapped?</source>
        <translation>šachovnice pod laserem %1 neleží na kalibračním tělese výš než na podložce; nejsou obrazy Closer a Further zaměněné?</translation>
    </message>
    <message>
        <source>the stripes of laser %1 on the backplane and on the calibration object do not belong to one grating; are the Closer and Further images swapped?</source>
        <translation>pruhy laseru %1 na podložce a na kalibračním tělese nepatří k jedné mřížce; nejsou obrazy Closer a Further zaměněné?</translation>
    </message>
    <message>
        <source>too few points on the boxes under heights/ to fit the error correction</source>
        <translation>na kvádrech v heights/ je příliš málo bodů pro výpočet korekce chyb</translation>
    </message>
    <message>
        <source>the boxes under heights/ do not determine the error correction; at least three heights are needed</source>
        <translation>kvádry v heights/ neurčují korekci chyb; potřeba jsou nejméně tři výšky</translation>
    </message>
    <message>
        <source>only a virtual device calibrates by itself; use the calibrate page</source>
        <translation>sama se kalibruje jen virtuální zařízení; použijte stránku Kalibrace</translation>
    </message>
    <message>
        <source>this device is not virtual</source>
        <translation>toto zařízení není virtuální</translation>
    </message>
    <message>
        <source>there is no campaign in %1; dorsum campaign new makes one</source>
        <translation>v %1 není kampaň; vytvoří ji dorsum campaign new</translation>
    </message>
    <message>
        <source>%1 is a campaign already; add to it, or choose another folder</source>
        <translation>%1 už kampaní je; přidávejte do ní, nebo zvolte jinou složku</translation>
    </message>
    <message>
        <source>%1 is not an empty folder; choose another one for the campaign</source>
        <translation>%1 není prázdná složka; zvolte pro kampaň jinou</translation>
    </message>
    <message>
        <source>%1 is a campaign already, and another one than asked for; choose another folder, or ask for the same device, seed, people and plan to go on with it</source>
        <translation>%1 už kampaní je, a jinou než žádanou; zvolte jinou složku, nebo žádejte stejné zařízení, semínko, osoby a plán, abyste v ní pokračovali</translation>
    </message>
    <message>
        <source>%1 is a campaign of virtual people; make another for real ones</source>
        <translation>%1 je kampaň virtuálních osob; pro skutečné vytvořte jinou</translation>
    </message>
    <message>
        <source>%1 is a campaign of real people; virtual ones have their own</source>
        <translation>%1 je kampaň skutečných osob; virtuální mají vlastní</translation>
    </message>
    <message>
        <source>this campaign&apos;s virtual device is described by a file; go on with dorsum campaign new, --virtual and --device</source>
        <translation>virtuální zařízení této kampaně popisuje soubor; pokračujte s dorsum campaign new, --virtual a --device</translation>
    </message>
    <message>
        <source>a campaign&apos;s name has 1 to 100 characters, all of them printable</source>
        <translation>název kampaně má 1 až 100 znaků, všechny tisknutelné</translation>
    </message>
    <message>
        <source>a person&apos;s id is 1 to 32 letters a to z, digits, - and _, with at least one digit and neither - nor _ in front: p01, never a name</source>
        <translation>identifikátor osoby je 1 až 32 písmen a až z, číslic, - a _, s nejméně jednou číslicí a bez - či _ na začátku: p01, nikdy jméno</translation>
    </message>
    <message>
        <source>the consent date must be a day that exists, as 2024-05-31; without consent nothing is stored</source>
        <translation>datum souhlasu musí být existující den, jako 2024-05-31; bez souhlasu se nic neuloží</translation>
    </message>
    <message>
        <source>the consent date %1 is before 1990</source>
        <translation>datum souhlasu %1 je před rokem 1990</translation>
    </message>
    <message>
        <source>the consent date %1 lies in the future (today is %2); without consent nothing is stored</source>
        <translation>datum souhlasu %1 je v budoucnosti (dnes je %2); bez souhlasu se nic neuloží</translation>
    </message>
    <message>
        <source>there is no person %1 in %2; add the person first, with the date of the consent</source>
        <translation>osoba %1 v %2 není; nejprve ji přidejte, s datem souhlasu</translation>
    </message>
    <message>
        <source>there is no person %1 in %2 to correct</source>
        <translation>osoba %1, kterou by bylo možné opravit, v %2 není</translation>
    </message>
    <message>
        <source>there is no person %1 in %2</source>
        <translation>osoba %1 v %2 není</translation>
    </message>
    <message>
        <source>there is a person %1 in %2 already; choose another id</source>
        <translation>osoba %1 v %2 již je; zvolte jiný identifikátor</translation>
    </message>
    <message>
        <source>the person %1 was removed meanwhile; nothing was stored</source>
        <translation>osoba %1 byla mezitím odebrána; nic nebylo uloženo</translation>
    </message>
    <message>
        <source>the campaign&apos;s plan has no left hands</source>
        <translation>plán kampaně nemá levé ruce</translation>
    </message>
    <message>
        <source>the campaign&apos;s plan has no right hands</source>
        <translation>plán kampaně nemá pravé ruce</translation>
    </message>
    <message>
        <source>the campaign&apos;s plan has sessions 1 to %1, not %2</source>
        <translation>plán kampaně má sezení 1 až %1, ne %2</translation>
    </message>
    <message>
        <source>the left hand of %1 has all %2 captures of session %3 already</source>
        <translation>levá ruka osoby %1 už má všechny snímky (%2) sezení %3</translation>
    </message>
    <message>
        <source>the right hand of %1 has all %2 captures of session %3 already</source>
        <translation>pravá ruka osoby %1 už má všechny snímky (%2) sezení %3</translation>
    </message>
    <message>
        <source>the left hand of %1 has all %2 captures of session %3; name the next session with --session</source>
        <translation>levá ruka osoby %1 má všechny snímky (%2) sezení %3; uveďte další sezení pomocí --session</translation>
    </message>
    <message>
        <source>the right hand of %1 has all %2 captures of session %3; name the next session with --session</source>
        <translation>pravá ruka osoby %1 má všechny snímky (%2) sezení %3; uveďte další sezení pomocí --session</translation>
    </message>
    <message>
        <source>there is no left capture %1 in session %2 of %3</source>
        <translation>levý snímek %1 v sezení %2 osoby %3 není</translation>
    </message>
    <message>
        <source>there is no right capture %1 in session %2 of %3</source>
        <translation>pravý snímek %1 v sezení %2 osoby %3 není</translation>
    </message>
    <message>
        <source>%1 of %2 is in the campaign already, in %3; add each capture once</source>
        <translation>%1 z %2 už v kampani je, v %3; každý snímek přidejte jednou</translation>
    </message>
    <message>
        <source>%1 is there, but no manifest names it; move it away</source>
        <translation>%1 existuje, ale žádný seznam jej neuvádí; přesuňte jej jinam</translation>
    </message>
    <message>
        <source>%1 has a picture of laser %2, which the campaign&apos;s device does not have; a campaign has one device</source>
        <translation>%1 má obraz laseru %2, který zařízení kampaně nemá; kampaň má jedno zařízení</translation>
    </message>
    <message>
        <source>%1 is of a camera with %2 pixels, but the campaign&apos;s has %3; a campaign has one device</source>
        <translation>%1 patří ke kameře s %2 pixely, ale kamera kampaně má %3; kampaň má jedno zařízení</translation>
    </message>
    <message>
        <source>%1 knows laser %2, which the campaign&apos;s device does not have; a campaign has one device</source>
        <translation>%1 zná laser %2, který zařízení kampaně nemá; kampaň má jedno zařízení</translation>
    </message>
    <message>
        <source>%1 has no calibration, so that there is no surface of it; give the campaign the device&apos;s with the next capture, and take this one again</source>
        <translation>%1 nemá kalibraci, takže k němu není povrch; dejte kampani s dalším snímkem kalibraci zařízení a tento pořiďte znovu</translation>
    </message>
    <message>
        <source>%1 has no captures to export</source>
        <translation>%1 nemá snímky k exportu</translation>
    </message>
    <message>
        <source>%1 is not an empty folder; choose another one</source>
        <translation>%1 není prázdná složka; zvolte jinou</translation>
    </message>
    <message>
        <source>%1 lies in the campaign; choose a folder outside</source>
        <translation>%1 leží v kampani; zvolte složku mimo ni</translation>
    </message>
    <message>
        <source>%1 is no calibration; restore it from a copy</source>
        <translation>%1 není kalibrace; obnovte ji z kopie</translation>
    </message>
    <message>
        <source>%1 was changed since dorsum wrote it: its checksum is wrong; restore it from a copy</source>
        <translation>%1 bylo změněno od zápisu programem dorsum: kontrolní součet nesouhlasí; obnovte je z kopie</translation>
    </message>
    <message>
        <source>%1 was changed since it was stored; restore it from a copy</source>
        <translation>%1 bylo od uložení změněno; obnovte je z kopie</translation>
    </message>
    <message>
        <source>%1 is missing; restore it from a copy</source>
        <translation>%1 chybí; obnovte je z kopie</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, but %3 were stored; restore it from a copy</source>
        <translation>%1 má %2 bajtů, ale uloženo jich bylo %3; obnovte je z kopie</translation>
    </message>
    <message>
        <source>%1 names a capture twice; restore it from a copy</source>
        <translation>%1 uvádí snímek dvakrát; obnovte je z kopie</translation>
    </message>
    <message>
        <source>%1; what else lies in its folder cannot be checked</source>
        <translation>%1; co dalšího leží v jeho složce, nelze zkontrolovat</translation>
    </message>
    <message>
        <source>%1 was being added or removed when the command was killed; the next command that writes clears it</source>
        <translation>%1 se právě přidávalo nebo odebíralo, když byl příkaz přerušen; další, který zapisuje, to uklidí</translation>
    </message>
    <message>
        <source>%1 was left by a command that was killed; the next command that writes clears it</source>
        <translation>%1 zbylo po přerušeném příkazu; další, který zapisuje, to uklidí</translation>
    </message>
    <message>
        <source>%1 holds what is left of a person whose removal was interrupted; run the removal again</source>
        <translation>%1 obsahuje, co zbylo po osobě, jejíž odebrání bylo přerušeno; spusťte odebrání znovu</translation>
    </message>
    <message>
        <source>%1 is a virtual person in a campaign of the other kind</source>
        <translation>%1 je virtuální osoba v kampani druhého druhu</translation>
    </message>
    <message>
        <source>%1 is a real person in a campaign of the other kind</source>
        <translation>%1 je skutečná osoba v kampani druhého druhu</translation>
    </message>
    <message>
        <source>%1 is a session beyond the plan</source>
        <translation>%1 je sezení nad rámec plánu</translation>
    </message>
    <message>
        <source>%1 is a capture beyond the plan</source>
        <translation>%1 je snímek nad rámec plánu</translation>
    </message>
    <message>
        <source>%1 is a link; a campaign holds its files itself</source>
        <translation>%1 je odkaz; kampaň obsahuje své soubory sama</translation>
    </message>
    <message>
        <source>%1 does not belong to the campaign; move it away</source>
        <translation>%1 nepatří ke kampani; přesuňte to jinam</translation>
    </message>
    <message>
        <source>without a calibration it cannot be told whether a hand is there and each laser is the right one</source>
        <translation>bez kalibrace nelze říci, zda je tu ruka a každý laser je ten správný</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Dorsum Studio: the window of Dorsum.</source>
        <translation>Dorsum Studio: okno Dorsum.</translation>
    </message>
    <message>
        <source>capture folder or PLY file to open</source>
        <translation>složka snímku nebo soubor PLY k otevření</translation>
    </message>
    <message>
        <source>device description, or virtual[:SEED]</source>
        <translation>popis zařízení, nebo virtual[:SEED]</translation>
    </message>
    <message>
        <source>calibration.json</source>
        <translation>calibration.json</translation>
    </message>
</context>
</TS>
