<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>AccessibleWidgets</name>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Checksum</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>Depth map</source>
        <translation>Tiefenkarte</translation>
    </message>
    <message>
        <source>Drawing the depth buffer</source>
        <translation>Tiefenpuffer wird gezeichnet</translation>
    </message>
    <message>
        <source>Filling gaps</source>
        <translation>Lücken werden gefüllt</translation>
    </message>
    <message>
        <source>Filling holes</source>
        <translation>Löcher werden gefüllt</translation>
    </message>
    <message>
        <source>Heights of cells</source>
        <translation>Höhen der Zellen</translation>
    </message>
    <message>
        <source>Looking for gaps</source>
        <translation>Lücken werden gesucht</translation>
    </message>
    <message>
        <source>Looking through gaps</source>
        <translation>Durch Lücken wird geschaut</translation>
    </message>
    <message>
        <source>Measuring the scan</source>
        <translation>Der Scan wird vermessen</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Sorting points into tiles</source>
        <translation>Punkte werden in Kacheln sortiert</translation>
    </message>
    <message>
        <source>Writing levels</source>
        <translation>Ebenen werden geschrieben</translation>
    </message>
    <message>
        <source>checking pages</source>
        <translation>Seiten werden geprüft</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>wird geöffnet</translation>
    </message>
    <message>
        <source>reading mesh</source>
        <translation>Netz wird gelesen</translation>
    </message>
    <message>
        <source>reading points</source>
        <translation>Punkte werden gelesen</translation>
    </message>
    <message>
        <source>front-most point</source>
        <translation>vorderster Punkt</translation>
    </message>
    <message>
        <source>second point from the front</source>
        <translation>zweiter Punkt von vorn</translation>
    </message>
    <message>
        <source>mean of the top layer</source>
        <translation>Mittel der obersten Schicht</translation>
    </message>
    <message>
        <source>rear-most point</source>
        <translation>hinterster Punkt</translation>
    </message>
    <message>
        <source>median of the points</source>
        <translation>Median der Punkte</translation>
    </message>
    <message>
        <source>mean of the points</source>
        <translation>Mittel der Punkte</translation>
    </message>
    <message>
        <source>bilinear splat</source>
        <translation>bilineare Verteilung</translation>
    </message>
    <message>
        <source>local quadratic</source>
        <translation>lokale quadratische Fläche</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>length on the map</source>
        <translation>Länge auf der Karte</translation>
    </message>
    <message>
        <source>height range</source>
        <translation>Höhenspanne</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>längs der Oberfläche</translation>
    </message>
    <message>
        <source>area in the view</source>
        <translation>Fläche in der Ansicht</translation>
    </message>
    <message>
        <source>volume above the plane</source>
        <translation>Volumen über der Ebene</translation>
    </message>
    <message>
        <source>area of the surface</source>
        <translation>Fläche der Oberfläche</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Distanz</translation>
    </message>
    <message>
        <source>depth difference</source>
        <translation>Höhenunterschied</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>local relief</source>
        <translation>lokales Relief</translation>
    </message>
    <message>
        <source>sky-view factor</source>
        <translation>Himmelssichtfaktor</translation>
    </message>
    <message>
        <source>openness</source>
        <translation>Offenheit</translation>
    </message>
    <message>
        <source>hillshade</source>
        <translation>Schummerung</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Bildunterschrift</translation>
    </message>
    <message>
        <source>hillshade, four lights</source>
        <translation>Schummerung, vier Lichter</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>batlow</source>
        <translation>Batlow</translation>
    </message>
    <message>
        <source>length of the cut</source>
        <translation>Länge des Schnitts</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>reading heights</source>
        <translation>Höhen lesen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>Aufbereiten</translation>
    </message>
    <message>
        <source>Writing the scan</source>
        <translation>Scan wird geschrieben</translation>
    </message>
    <message>
        <source>multi-scale deviation</source>
        <translation>Abweichung in mehreren Maßstäben</translation>
    </message>
    <message>
        <source>multi-scale curvature</source>
        <translation>Krümmung in mehreren Maßstäben</translation>
    </message>
    <message>
        <source>ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>proxy</source>
        <translation>Proxy</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Finding the front</source>
        <translation>Vorderste Schicht wird gesucht</translation>
    </message>
    <message>
        <source>Laying the scans on each other</source>
        <translation>Scans werden aufeinandergelegt</translation>
    </message>
    <message>
        <source>Looking at colours</source>
        <translation>Farben werden angesehen</translation>
    </message>
    <message>
        <source>Looking at the scans</source>
        <translation>Scans werden angesehen</translation>
    </message>
    <message>
        <source>Opening the files</source>
        <translation>Dateien werden geöffnet</translation>
    </message>
    <message>
        <source>Publishing</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>Searching where the scans meet</source>
        <translation>Gemeinsame Stellen der Scans werden gesucht</translation>
    </message>
    <message>
        <source>Solving all poses together</source>
        <translation>Alle Lagen werden gemeinsam berechnet</translation>
    </message>
    <message>
        <source>Sorting colours into tiles</source>
        <translation>Farben werden auf Kacheln verteilt</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Writing colours</source>
        <translation>Farben werden geschrieben</translation>
    </message>
    <message>
        <source>reading pictures</source>
        <translation>Bilder werden gelesen</translation>
    </message>
    <message>
        <source>Fetching the map</source>
        <translation>Karte wird geholt</translation>
    </message>
    <message>
        <source>HIP</source>
        <translation>HIP</translation>
    </message>
</context>
<context>
    <name>Event</name>
    <message>
        <source>%1 samples dropped before this one</source>
        <translation>vor diesem %1 Werte ausgelassen</translation>
    </message>
    <message>
        <source>resumed after %1 ms</source>
        <translation>nach %1 ms fortgesetzt</translation>
    </message>
    <message>
        <source>stiffness %1 N/m</source>
        <translation>Steifigkeit %1 N/m</translation>
    </message>
    <message>
        <source>softened against swinging</source>
        <translation>gegen Schwingen weicher gemacht</translation>
    </message>
    <message>
        <source>forces off</source>
        <translation>Kräfte aus</translation>
    </message>
    <message>
        <source>forces wait for a clear hand</source>
        <translation>Kräfte warten auf eine freie Hand</translation>
    </message>
    <message>
        <source>forces rise</source>
        <translation>Kräfte setzen ein</translation>
    </message>
    <message>
        <source>forces on</source>
        <translation>Kräfte an</translation>
    </message>
    <message>
        <source>button %1 down</source>
        <translation>Knopf %1 gedrückt</translation>
    </message>
    <message>
        <source>button %1 up</source>
        <translation>Knopf %1 losgelassen</translation>
    </message>
    <message>
        <source>no fault</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>the device did not answer in time</source>
        <translation>das Gerät hat nicht rechtzeitig geantwortet</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>das Gerät wurde getrennt</translation>
    </message>
    <message>
        <source>the device sent something unreadable</source>
        <translation>das Gerät hat Unlesbares gesendet</translation>
    </message>
    <message>
        <source>the device is too hot</source>
        <translation>das Gerät ist zu heiß</translation>
    </message>
    <message>
        <source>the device reported an impossible position</source>
        <translation>das Gerät meldet eine unmögliche Position</translation>
    </message>
    <message>
        <source>the device is not ready yet</source>
        <translation>das Gerät ist noch nicht bereit</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>new window at resolution %2</source>
        <translation>neuer Ausschnitt in Auflösung %2</translation>
    </message>
    <message>
        <source>window at resolution %2</source>
        <translation>Ausschnitt in Auflösung %2</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>US-Vermessungsfuß</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Free view</source>
        <translation>Freie Ansicht</translation>
    </message>
    <message>
        <source>Best-fit plane</source>
        <translation>Ausgleichsebene</translation>
    </message>
    <message>
        <source>Principal axes</source>
        <translation>Hauptachsen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Automatic, as in earlier versions</source>
        <translation>Automatisch, wie in früheren Versionen</translation>
    </message>
    <message>
        <source>%1, turned to the left</source>
        <translation>%1, nach links gedreht</translation>
    </message>
    <message>
        <source>%1, turned to the right</source>
        <translation>%1, nach rechts gedreht</translation>
    </message>
    <message>
        <source>%1, upside down</source>
        <translation>%1, auf dem Kopf</translation>
    </message>
</context>
<context>
    <name>relievo</name>
    <message>
        <source>There is not enough memory for this. Nothing was changed. Close other programs or choose a smaller file.</source>
        <translation>Der Speicher reicht dafür nicht. Nichts wurde geändert. Schließen Sie andere Programme oder wählen Sie eine kleinere Datei.</translation>
    </message>
    <message>
        <source>This failed unexpectedly: %1. Nothing was changed.</source>
        <translation>Das ist unerwartet fehlgeschlagen: %1. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>longer than %1</source>
        <translation>länger als %1</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Noch nicht gemessen.</translation>
    </message>
    <message numerus="yes">
        <source>Force interrupted %n time(s).</source>
        <translation>
            <numerusform>Kraft %n-mal unterbrochen.</numerusform>
            <numerusform>Kraft %n-mal unterbrochen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Softened against swinging, times: %1.</source>
        <translation>Gegen Schwingen weicher gemacht, Anzahl: %1.</translation>
    </message>
    <message>
        <source>Pauses after which the force rose anew: %1.</source>
        <translation>Pausen, nach denen die Kraft neu anstieg: %1.</translation>
    </message>
    <message>
        <source>Slow.</source>
        <translation>Langsam.</translation>
    </message>
    <message>
        <source>Runs well.</source>
        <translation>Läuft gut.</translation>
    </message>
    <message>
        <source>%1 per second, %2 of %3 ticks late, longest gap %4 ms.</source>
        <translation>%1 pro Sekunde, %2 von %3 Takten verspätet, längste Lücke %4 ms.</translation>
    </message>
    <message>
        <source>Real-time priority granted.</source>
        <translation>Echtzeitpriorität erteilt.</translation>
    </message>
    <message>
        <source>No real-time priority; the tables say why.</source>
        <translation>Keine Echtzeitpriorität; die Tabellen nennen den Grund.</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Gerät: %1</translation>
    </message>
    <message>
        <source>Computing, mean and longest: %1 µs, %2 µs</source>
        <translation>Rechenzeit, im Mittel und längste: %1 µs, %2 µs</translation>
    </message>
    <message>
        <source>Real time: everything was granted.</source>
        <translation>Echtzeit: alles wurde erteilt.</translation>
    </message>
    <message>
        <source>Woken late by, in ticks:</source>
        <translation>Verspätung beim Wecken, in Takten:</translation>
    </message>
    <message>
        <source>Time spent computing, in ticks:</source>
        <translation>Rechenzeit, in Takten:</translation>
    </message>
    <message>
        <source>Waited for memory in %1 ticks.</source>
        <translation>In %1 Takten auf Speicher gewartet.</translation>
    </message>
    <message>
        <source>Memory locked.</source>
        <translation>Speicher gesperrt.</translation>
    </message>
    <message>
        <source>Memory not locked; the tables say why.</source>
        <translation>Speicher nicht gesperrt; die Tabellen nennen den Grund.</translation>
    </message>
    <message>
        <source>Page faults of the loop: %1, in %2 ticks</source>
        <translation>Seitenfehler der Schleife: %1, in %2 Takten</translation>
    </message>
    <message>
        <source>Memory locked: %1 kB</source>
        <translation>Speicher gesperrt: %1 kB</translation>
    </message>
    <message>
        <source>&amp;Crop to a box</source>
        <translation>Auf einen &amp;Quader zuschneiden</translation>
    </message>
    <message>
        <source>Crop to an outline on the &amp;view</source>
        <translation>Auf einen &amp;Umriss in der Ansicht zuschneiden</translation>
    </message>
    <message>
        <source>&amp;Stray points, as for most scans</source>
        <translation>&amp;Streupunkte, wie für die meisten Scans</translation>
    </message>
    <message>
        <source>&amp;Outliers, statistical</source>
        <translation>&amp;Ausreißer, statistisch</translation>
    </message>
    <message>
        <source>Outliers, within a &amp;radius</source>
        <translation>Ausreißer, in einem &amp;Radius</translation>
    </message>
    <message>
        <source>Thin &amp;beside dense</source>
        <translation>Dünnes neben &amp;Dichtem</translation>
    </message>
    <message>
        <source>&amp;Equal points</source>
        <translation>&amp;Gleiche Punkte</translation>
    </message>
    <message>
        <source>C&amp;lasses of points</source>
        <translation>&amp;Klassen der Punkte</translation>
    </message>
    <message>
        <source>Returns of a p&amp;ulse</source>
        <translation>Echos eines P&amp;ulses</translation>
    </message>
    <message>
        <source>&amp;Intensities</source>
        <translation>&amp;Intensitäten</translation>
    </message>
    <message>
        <source>&amp;Thin out</source>
        <translation>Aus&amp;dünnen</translation>
    </message>
    <message>
        <source>Leave out the &amp;plane under the object</source>
        <translation>&amp;Ebene unter dem Objekt weglassen</translation>
    </message>
    <message>
        <source>Lay the plane under the object le&amp;vel</source>
        <translation>Ebene unter dem Objekt &amp;waagerecht legen</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>&amp;Normalen</translation>
    </message>
    <message>
        <source>what is outside stays</source>
        <translation>was außen liegt, bleibt</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>%1, what is outside stays</source>
        <translation>%1, was außen liegt, bleibt</translation>
    </message>
    <message>
        <source>all but noise</source>
        <translation>alle außer Rauschen</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erste</translation>
    </message>
    <message>
        <source>last</source>
        <translation>letzte</translation>
    </message>
    <message>
        <source>single</source>
        <translation>einzige</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 neighbours, %2 deviations</source>
        <translation>%1 Nachbarn, %2 Abweichungen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 spacings</source>
        <translation>%1 Punktabständen</translation>
    </message>
    <message>
        <source>fewer than %1 within %2</source>
        <translation>weniger als %1 in %2</translation>
    </message>
    <message>
        <source>%1 neighbours, %2 times</source>
        <translation>%1 Nachbarn, %2-fach</translation>
    </message>
    <message>
        <source>%1, off the surface %2 times</source>
        <translation>%1, abseits der Fläche %2-mal</translation>
    </message>
    <message>
        <source>one in %1 mm</source>
        <translation>einer in %1 mm</translation>
    </message>
    <message>
        <source>laid level</source>
        <translation>waagerecht gelegt</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>%1 neighbours</source>
        <translation>%1 Nachbarn</translation>
    </message>
    <message>
        <source>as stored</source>
        <translation>wie gespeichert</translation>
    </message>
    <message>
        <source>by picked pairs</source>
        <translation>über gewählte Paare</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Crop to a box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Crop to an outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Classes of points</source>
        <translation>Klassen der Punkte</translation>
    </message>
    <message>
        <source>Returns of a pulse</source>
        <translation>Echos eines Pulses</translation>
    </message>
    <message>
        <source>Intensities</source>
        <translation>Intensitäten</translation>
    </message>
    <message>
        <source>Equal points</source>
        <translation>Gleiche Punkte</translation>
    </message>
    <message>
        <source>Outliers, statistical</source>
        <translation>Ausreißer, statistisch</translation>
    </message>
    <message>
        <source>Outliers, within a radius</source>
        <translation>Ausreißer, in einem Radius</translation>
    </message>
    <message>
        <source>Thin beside dense</source>
        <translation>Dünnes neben Dichtem</translation>
    </message>
    <message>
        <source>Thin out</source>
        <translation>Ausdünnen</translation>
    </message>
    <message>
        <source>Plane under the object</source>
        <translation>Ebene unter dem Objekt</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Align and join</source>
        <translation>Ausrichten und verbinden</translation>
    </message>
    <message>
        <source>What is being done</source>
        <translation>Was gerade geschieht</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Stop the work</source>
        <translation>Die Arbeit anhalten</translation>
    </message>
    <message>
        <source>Map by tiles</source>
        <translation>Karte in Kacheln</translation>
    </message>
    <message>
        <source>Looks at the hand 250 times a second while it rests; before:</source>
        <translation>Sieht 250-mal je Sekunde nach der Hand, solange sie ruht; davor:</translation>
    </message>
</context>
<context>
    <name>relievo::AddressDialog</name>
    <message>
        <source>Open web address</source>
        <translation>Webadresse öffnen</translation>
    </message>
    <message>
        <source>&amp;Address of a published map</source>
        <translation>&amp;Adresse einer veröffentlichten Karte</translation>
    </message>
    <message>
        <source>Address of a published map</source>
        <translation>Adresse einer veröffentlichten Karte</translation>
    </message>
    <message>
        <source>Of the folder that relievo publish made, or of its map.json</source>
        <translation>Des Ordners, den „relievo publish“ angelegt hat, oder seiner map.json</translation>
    </message>
    <message>
        <source>The server is asked when you open it.</source>
        <translation>Der Server wird gefragt, wenn Sie sie öffnen.</translation>
    </message>
    <message>
        <source>An address begins with https://, http:// or s3://.</source>
        <translation>Eine Adresse beginnt mit https://, http:// oder s3://.</translation>
    </message>
</context>
<context>
    <name>relievo::ButtonControl</name>
    <message>
        <source>Buttons</source>
        <translation>Knöpfe am Gerät</translation>
    </message>
    <message>
        <source>Gamepads rumble at contact and edge. It is a cue, no force.</source>
        <translation>Gamepads vibrieren bei Berührung und am Rand. Das ist ein Hinweis und keine Kraft.</translation>
    </message>
    <message>
        <source>Gamepads do not rumble.</source>
        <translation>Gamepads vibrieren nicht.</translation>
    </message>
</context>
<context>
    <name>relievo::ButtonsPanel</name>
    <message>
        <source>Sca&amp;nning with one button</source>
        <translation>Aus&amp;wahl mit einem Knopf</translation>
    </message>
    <message>
        <source>Scanning with one button</source>
        <translation>Auswahl mit einem Knopf</translation>
    </message>
    <message>
        <source>Any button: the first press begins to offer where am I, finer, coarser, move, forces; the next one takes what was offered last.</source>
        <translation>Irgendein Knopf: Der erste Druck beginnt, wo bin ich, feiner, gröber, verschieben und Kräfte anzubieten; der nächste nimmt, was zuletzt angeboten wurde.</translation>
    </message>
    <message>
        <source>How long each command is offered, in seconds</source>
        <translation>Wie lange jeder Befehl angeboten wird, in Sekunden</translation>
    </message>
    <message>
        <source>How long each command is offered.</source>
        <translation>Wie lange jeder Befehl angeboten wird.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>What a SpaceMouse moves</source>
        <translation>Was eine SpaceMouse bewegt</translation>
    </message>
    <message>
        <source>The hand</source>
        <translation>Die Hand</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>Die Ansicht</translation>
    </message>
    <message>
        <source>Each offer</source>
        <translation>Jedes Angebot</translation>
    </message>
    <message>
        <source>SpaceMouse moves</source>
        <translation>SpaceMouse bewegt</translation>
    </message>
    <message>
        <source>Gamepads r&amp;umble (a cue)</source>
        <translation>Gamepads &amp;vibrieren (ein Hinweis)</translation>
    </message>
    <message>
        <source>Gamepads rumble at contact and edge</source>
        <translation>Gamepads vibrieren bei Berührung und am Rand</translation>
    </message>
    <message>
        <source>A knock when the hand meets the surface, and a soft hum at the edge of the window. It is a cue: it has no direction and is no force.</source>
        <translation>Ein Klopfen, wenn die Hand die Oberfläche trifft, und ein leises Brummen am Rand des Ausschnitts. Es ist ein Hinweis: Er hat keine Richtung und ist keine Kraft.</translation>
    </message>
    <message>
        <source>What the cap of a 3Dconnexion SpaceMouse moves. The hand follows pushes only. In the view the relief follows the cap: pushed to a side, up or down it moves, toward you it comes nearer; tilted forward or back, or twisted, it turns.</source>
        <translation>Was die Kappe einer SpaceMouse von 3Dconnexion bewegt. Die Hand folgt nur dem Drücken. In der Ansicht folgt das Relief der Kappe: Zur Seite, nach oben oder unten gedrückt, verschiebt es sich, zu Ihnen hin kommt es näher; nach vorn oder hinten gekippt oder gedreht, dreht es sich.</translation>
    </message>
</context>
<context>
    <name>relievo::CellLegend</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>less than %1 %</source>
        <translation>weniger als %1 %</translation>
    </message>
    <message>
        <source>interpolated: %1</source>
        <translation>interpoliert: %1</translation>
    </message>
    <message>
        <source>hole, on base plane: %1</source>
        <translation>Loch, auf der Grundebene: %1</translation>
    </message>
    <message>
        <source>All cells in view were measured</source>
        <translation>Alle Zellen im Bild wurden gemessen</translation>
    </message>
    <message>
        <source>Legend of marks</source>
        <translation>Legende der Zeichen</translation>
    </message>
    <message>
        <source>ball: proxy, on the surface</source>
        <translation>Kugel: Proxy, auf der Oberfläche</translation>
    </message>
    <message>
        <source>ring with a cross: HIP</source>
        <translation>Ring mit Kreuz: HIP</translation>
    </message>
</context>
<context>
    <name>relievo::CloudView</name>
    <message>
        <source>A point under the cross: %1, %2, %3</source>
        <translation>Ein Punkt unter dem Kreuz: %1, %2, %3</translation>
    </message>
    <message>
        <source>No point under the cross</source>
        <translation>Kein Punkt unter dem Kreuz</translation>
    </message>
    <message numerus="yes">
        <source>%n corner(s) so far</source>
        <translation>
            <numerusform>%n Ecke bisher</numerusform>
            <numerusform>%n Ecken bisher</numerusform>
        </translation>
    </message>
    <message>
        <source>An outline needs three corners</source>
        <translation>Ein Umriss braucht drei Ecken</translation>
    </message>
</context>
<context>
    <name>relievo::ColourBar</name>
    <message>
        <source>Bar of colours</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>relievo::CommandSearch</name>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Wörter eines Befehls</translation>
    </message>
    <message>
        <source>Words of a command&apos;s name or explanation; Enter runs the first</source>
        <translation>Wörter aus Name oder Erklärung eines Befehls; die Eingabetaste führt den ersten aus</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>No command has these words. Try one word, or another for the same; F1 lists all keys, Shift+F1 opens the manual.</source>
        <translation>Kein Befehl hat diese Wörter. Versuchen Sie ein einzelnes oder ein anderes Wort; F1 zeigt alle Tasten, Umschalt+F1 öffnet das Handbuch.</translation>
    </message>
</context>
<context>
    <name>relievo::CommandTable</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>A&amp;nsicht</translation>
    </message>
    <message>
        <source>&amp;Detail view</source>
        <translation>De&amp;tailansicht</translation>
    </message>
    <message>
        <source>What the left button does, and turning by keys</source>
        <translation>Was die linke Maustaste tut, und Drehen mit Tasten</translation>
    </message>
    <message>
        <source>Relief ima&amp;ge</source>
        <translation>Relie&amp;fbild</translation>
    </message>
    <message>
        <source>How heights are painted</source>
        <translation>Wie Höhen dargestellt werden</translation>
    </message>
    <message>
        <source>R&amp;elief colours</source>
        <translation>&amp;Relieffarben</translation>
    </message>
    <message>
        <source>Colours of heights, slopes and other values</source>
        <translation>Farben der Höhen, Neigungen und anderer Werte</translation>
    </message>
    <message>
        <source>Ke&amp;y light</source>
        <translation>Licht&amp;quelle</translation>
    </message>
    <message>
        <source>From where the light shines; low light brings out detail</source>
        <translation>Woher das Licht kommt; niedriges Licht zeigt Einzelheiten</translation>
    </message>
    <message>
        <source>Lig&amp;ht or dark</source>
        <translation>Hell &amp;oder dunkel</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>Farben des Fensters</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>How the depth map is made</source>
        <translation>Wie die Tiefenkarte gemacht wird</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>&amp;Fühlen</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>&amp;Aufzeichnen</translation>
    </message>
    <message>
        <source>Record &amp;as</source>
        <translation>Aufzeichnen a&amp;ls</translation>
    </message>
    <message>
        <source>Kind of file of the next recording</source>
        <translation>Dateiart der nächsten Aufzeichnung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a scan or a height map</source>
        <translation>Einen Scan oder eine Höhenkarte öffnen</translation>
    </message>
    <message>
        <source>Open fol&amp;der…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open all scans of a folder: parts of one object</source>
        <translation>Alle Scans eines Ordners öffnen: Teile eines Objekts</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>P&amp;rojekt speichern</translation>
    </message>
    <message>
        <source>Keep this state: file, depth map, window, measurements</source>
        <translation>Diesen Stand aufheben: Datei, Tiefenkarte, Ausschnitt, Messungen</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>Projekt &amp;speichern unter…</translation>
    </message>
    <message>
        <source>Keep this state in another file</source>
        <translation>Diesen Stand in einer anderen Datei aufheben</translation>
    </message>
    <message>
        <source>&amp;Figure…</source>
        <translation>&amp;Abbildung…</translation>
    </message>
    <message>
        <source>A figure for print, with scale bar, legend and caption</source>
        <translation>Eine Abbildung für den Druck, mit Maßstab, Legende und Bildunterschrift</translation>
    </message>
    <message>
        <source>&amp;Image…</source>
        <translation>B&amp;ild…</translation>
    </message>
    <message>
        <source>Save a picture of a view or of the window</source>
        <translation>Ein Bild einer Ansicht oder des Fensters speichern</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>A map, mesh, picture, profile or section for other programs</source>
        <translation>Eine Karte, ein Netz, ein Bild, ein Profil oder ein Schnitt für andere Programme</translation>
    </message>
    <message>
        <source>One zip with project, scan, recordings, figures and checksums</source>
        <translation>Eine Zip-Datei mit Projekt, Scan, Aufzeichnungen, Abbildungen und Prüfsummen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close the scan and go back to the start page</source>
        <translation>Den Scan schließen und zur Startseite zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close relievo</source>
        <translation>relievo schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>&amp;Verlauf…</translation>
    </message>
    <message>
        <source>Every step so far; choose one to go back to it</source>
        <translation>Jeder Schritt bisher; wählen Sie einen, um zu ihm zurückzukehren</translation>
    </message>
    <message>
        <source>&amp;Copy view as text</source>
        <translation>Ansicht als &amp;Text kopieren</translation>
    </message>
    <message>
        <source>Paste &amp;view</source>
        <translation>&amp;Ansicht einfügen</translation>
    </message>
    <message>
        <source>Show the view that was copied as text</source>
        <translation>Die Ansicht zeigen, die als Text kopiert wurde</translation>
    </message>
    <message>
        <source>&amp;Answer the message</source>
        <translation>&amp;Meldung beantworten</translation>
    </message>
    <message>
        <source>Press the first button of the message above the views</source>
        <translation>Den ersten Knopf der Meldung über den Ansichten drücken</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Colours, text size, language, units, stereo, device</source>
        <translation>Farben, Schriftgröße, Sprache, Einheiten, Stereo, Gerät</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Look from this side and make the relief anew</source>
        <translation>Von dieser Seite sehen und das Relief neu machen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Re&amp;chts</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>O&amp;ben</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>Auto&amp;matisch</translation>
    </message>
    <message>
        <source>Look from the side that shows most</source>
        <translation>Von der Seite sehen, die am meisten zeigt</translation>
    </message>
    <message>
        <source>Loo&amp;k with the left button</source>
        <translation>Mit der linken Taste &amp;betrachten</translation>
    </message>
    <message>
        <source>Dragging with the left button turns the detail view</source>
        <translation>Ziehen mit der linken Taste dreht die Detailansicht</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Betrachten</translation>
    </message>
    <message>
        <source>&amp;Touch with the left button</source>
        <translation>Mit der linken Taste &amp;fühlen</translation>
    </message>
    <message>
        <source>The left button presses the hand into the surface</source>
        <translation>Die linke Taste drückt die Hand in die Oberfläche</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>&amp;Switch between look and touch</source>
        <translation>&amp;Zwischen Betrachten und Fühlen wechseln</translation>
    </message>
    <message>
        <source>What the left button does in the detail view: turn it, or press the hand in</source>
        <translation>Was die linke Taste in der Detailansicht tut: sie drehen oder die Hand eindrücken</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn the detail view by 15 degrees</source>
        <translation>Die Detailansicht um 15 Grad drehen</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation>Nach &amp;oben drehen</translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation>&amp;Nach unten drehen</translation>
    </message>
    <message>
        <source>&amp;Use this view</source>
        <translation>&amp;Diese Ansicht nehmen</translation>
    </message>
    <message>
        <source>Make the relief anew from where the turned detail view looks</source>
        <translation>Das Relief neu machen, aus der Richtung der gedrehten Detailansicht</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Look straight down on the relief, fitted to the view</source>
        <translation>Gerade auf das Relief sehen, in die Ansicht eingepasst</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>Show or hide the whole object</source>
        <translation>Das ganze Objekt zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Show or hide the side panels</source>
        <translation>Die Seitenfelder zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Pl&amp;ots</source>
        <translation>&amp;Kurven</translation>
    </message>
    <message>
        <source>Show or hide the plots of height and force</source>
        <translation>Die Kurven von Höhe und Kraft zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Matt stone under lamps</source>
        <translation>Matter Stein unter Lampen</translation>
    </message>
    <message>
        <source>&amp;Height in colour</source>
        <translation>Höhe &amp;in Farbe</translation>
    </message>
    <message>
        <source>H&amp;illshade</source>
        <translation>S&amp;chummerung</translation>
    </message>
    <message>
        <source>Brightness under one light</source>
        <translation>Helligkeit unter einem Licht</translation>
    </message>
    <message>
        <source>Hillshade, &amp;four lights</source>
        <translation>&amp;Schummerung, vier Lichter</translation>
    </message>
    <message>
        <source>No direction stays in the dark</source>
        <translation>Keine Richtung bleibt im Dunkeln</translation>
    </message>
    <message>
        <source>&amp;Slope</source>
        <translation>&amp;Neigung</translation>
    </message>
    <message>
        <source>Steepness in degrees</source>
        <translation>Steilheit in Grad</translation>
    </message>
    <message>
        <source>Local &amp;relief</source>
        <translation>&amp;Lokales Relief</translation>
    </message>
    <message>
        <source>Worn detail without the broad shape</source>
        <translation>Abgenutzte Einzelheiten ohne die große Form</translation>
    </message>
    <message>
        <source>Sky &amp;view</source>
        <translation>&amp;Himmelssicht</translation>
    </message>
    <message>
        <source>How much of the sky each place sees</source>
        <translation>Wieviel vom Himmel jede Stelle sieht</translation>
    </message>
    <message>
        <source>&amp;Openness</source>
        <translation>&amp;Offenheit</translation>
    </message>
    <message>
        <source>Hollows dark, ridges bright</source>
        <translation>Vertiefungen dunkel, Grate hell</translation>
    </message>
    <message>
        <source>&amp;Deviation, several scales</source>
        <translation>Ab&amp;weichung, mehrere Maßstäbe</translation>
    </message>
    <message>
        <source>What stands out from its neighbourhood, at the scale where it does so most</source>
        <translation>Was aus seiner Nachbarschaft hervortritt, in dem Maßstab, in dem es das am meisten tut</translation>
    </message>
    <message>
        <source>&amp;Curvature, several scales</source>
        <translation>&amp;Krümmung, mehrere Maßstäbe</translation>
    </message>
    <message>
        <source>Ridges and incisions of several widths, however the ground is tilted</source>
        <translation>Grate und Einschnitte verschiedener Breite, wie auch immer der Grund geneigt ist</translation>
    </message>
    <message>
        <source>&amp;Natural colours</source>
        <translation>N&amp;atürliche Farben</translation>
    </message>
    <message>
        <source>The colours that the scan has</source>
        <translation>Die Farben, die der Scan hat</translation>
    </message>
    <message>
        <source>In&amp;tensity</source>
        <translation>In&amp;tensität</translation>
    </message>
    <message>
        <source>How strongly the scanner&apos;s light came back</source>
        <translation>Wie stark das Licht des Scanners zurückkam</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>Colours that grow lighter in even steps</source>
        <translation>Farben, die in gleichen Stufen heller werden</translation>
    </message>
    <message>
        <source>&amp;Viridis</source>
        <translation>&amp;Viridis</translation>
    </message>
    <message>
        <source>&amp;Cividis</source>
        <translation>&amp;Cividis</translation>
    </message>
    <message>
        <source>&amp;Batlow</source>
        <translation>&amp;Batlow</translation>
    </message>
    <message>
        <source>&amp;Usual light</source>
        <translation>Üb&amp;liches Licht</translation>
    </message>
    <message>
        <source>From the upper left, 45 degrees high</source>
        <translation>Von links oben, 45 Grad hoch</translation>
    </message>
    <message>
        <source>Raking from the &amp;left</source>
        <translation>&amp;Streiflicht von links</translation>
    </message>
    <message>
        <source>Light almost along the surface, 10 degrees above it</source>
        <translation>Licht fast entlang der Oberfläche, 10 Grad darüber</translation>
    </message>
    <message>
        <source>Raking from the &amp;right</source>
        <translation>Streiflicht von &amp;rechts</translation>
    </message>
    <message>
        <source>Raking from &amp;above</source>
        <translation>Streiflicht von &amp;oben</translation>
    </message>
    <message>
        <source>Raking from &amp;below</source>
        <translation>Strei&amp;flicht von unten</translation>
    </message>
    <message>
        <source>Turn &amp;counterclockwise</source>
        <translation>&amp;Gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the light by 5 degrees, counterclockwise</source>
        <translation>Das Licht um 5 Grad gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn cloc&amp;kwise</source>
        <translation>Im &amp;Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the light by 5 degrees, clockwise</source>
        <translation>Das Licht um 5 Grad im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>&amp;Higher</source>
        <translation>&amp;Höher</translation>
    </message>
    <message>
        <source>The light 5 degrees higher</source>
        <translation>Das Licht 5 Grad höher</translation>
    </message>
    <message>
        <source>Lo&amp;wer</source>
        <translation>&amp;Niedriger</translation>
    </message>
    <message>
        <source>The light 5 degrees lower: worn detail comes out</source>
        <translation>Das Licht 5 Grad niedriger: Abgenutztes tritt hervor</translation>
    </message>
    <message>
        <source>Mar&amp;k unmeasured cells</source>
        <translation>Nicht gemessene &amp;Zellen markieren</translation>
    </message>
    <message>
        <source>Cells that were interpolated in colour, with a legend; holes are always hatched</source>
        <translation>Interpolierte Zellen in Farbe, mit Legende; Löcher sind immer schraffiert</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>&amp;Wie das System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>H&amp;ell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Hoher Kontrast</translation>
    </message>
    <message>
        <source>Full s&amp;creen detail</source>
        <translation>Detail &amp;im Vollbild</translation>
    </message>
    <message>
        <source>The detail view alone on the whole screen</source>
        <translation>Die Detailansicht allein auf dem ganzen Bildschirm</translation>
    </message>
    <message>
        <source>Other vie&amp;w</source>
        <translation>&amp;Andere Ansicht</translation>
    </message>
    <message>
        <source>Ne&amp;xt part</source>
        <translation>&amp;Nächster Teil</translation>
    </message>
    <message>
        <source>Move the focus to the next part of the window</source>
        <translation>Den Fokus zum nächsten Teil des Fensters bewegen</translation>
    </message>
    <message>
        <source>Move the focus to the part before</source>
        <translation>Den Fokus zum Teil davor bewegen</translation>
    </message>
    <message>
        <source>&amp;Finer</source>
        <translation>&amp;Feiner</translation>
    </message>
    <message>
        <source>&amp;Coarser</source>
        <translation>G&amp;röber</translation>
    </message>
    <message>
        <source>&amp;Whole object</source>
        <translation>&amp;Ganzes Objekt</translation>
    </message>
    <message>
        <source>The whole object in the window</source>
        <translation>Das ganze Objekt im Ausschnitt</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Nach &amp;links</translation>
    </message>
    <message>
        <source>Move the window by a quarter of its side</source>
        <translation>Den Ausschnitt um ein Viertel seiner Seite verschieben</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>N&amp;ach rechts</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>&amp;Type window…</source>
        <translation>Ausschnitt &amp;eintippen…</translation>
    </message>
    <message>
        <source>Type the window&apos;s place and size in millimetres</source>
        <translation>Ort und Größe des Ausschnitts in Millimetern eintippen</translation>
    </message>
    <message>
        <source>&amp;Suggest windows</source>
        <translation>Ausschnitte vors&amp;chlagen</translation>
    </message>
    <message>
        <source>Rank windows by how much of their relief a hand feels</source>
        <translation>Ausschnitte danach ordnen, wie viel von ihrem Relief eine Hand fühlt</translation>
    </message>
    <message>
        <source>Prep&amp;are…</source>
        <translation>Auf&amp;bereiten…</translation>
    </message>
    <message>
        <source>Crop, clean, thin and join scans before the depth map</source>
        <translation>Scans vor der Tiefenkarte zuschneiden, säubern, ausdünnen und verbinden</translation>
    </message>
    <message>
        <source>Depth ma&amp;p…</source>
        <translation>&amp;Tiefenkarte…</translation>
    </message>
    <message>
        <source>Everything between the scan and its depth map, with a preview</source>
        <translation>Alles zwischen dem Scan und seiner Tiefenkarte, mit Vorschau</translation>
    </message>
    <message>
        <source>U&amp;nits…</source>
        <translation>E&amp;inheiten…</translation>
    </message>
    <message>
        <source>Say which length unit the file&apos;s coordinates have; kept for its folder</source>
        <translation>Angeben, welche Längeneinheit die Koordinaten der Datei haben; gilt für ihren Ordner</translation>
    </message>
    <message>
        <source>Make the depth map on the processor</source>
        <translation>Die Tiefenkarte mit dem Prozessor machen</translation>
    </message>
    <message>
        <source>Make the depth map by the graphics card&apos;s depth buffer</source>
        <translation>Die Tiefenkarte mit dem Tiefenpuffer der Grafikkarte machen</translation>
    </message>
    <message>
        <source>&amp;Point</source>
        <translation>P&amp;unkt</translation>
    </message>
    <message>
        <source>Height of one place</source>
        <translation>Höhe einer Stelle</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>D&amp;istanz</translation>
    </message>
    <message>
        <source>Between two places</source>
        <translation>Zwischen zwei Stellen</translation>
    </message>
    <message>
        <source>Depth di&amp;fference</source>
        <translation>&amp;Höhenunterschied</translation>
    </message>
    <message>
        <source>How much higher the second place lies</source>
        <translation>Wieviel höher die zweite Stelle liegt</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>At the second of three places</source>
        <translation>An der zweiten von drei Stellen</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>&amp;Profil</translation>
    </message>
    <message>
        <source>Heights along a line</source>
        <translation>Höhen längs einer Linie</translation>
    </message>
    <message>
        <source>Area and &amp;volume</source>
        <translation>&amp;Fläche und Volumen</translation>
    </message>
    <message>
        <source>Of a piece of surface above its lowest corner, or another plane</source>
        <translation>Eines Stücks Oberfläche über seiner tiefsten Ecke, oder einer anderen Ebene</translation>
    </message>
    <message>
        <source>Se&amp;ction</source>
        <translation>Sch&amp;nitt</translation>
    </message>
    <message>
        <source>Where a plane through one, two or three places cuts the surface</source>
        <translation>Wo eine Ebene durch eine, zwei oder drei Stellen die Oberfläche schneidet</translation>
    </message>
    <message>
        <source>By &amp;touch</source>
        <translation>&amp;Durch Ertasten</translation>
    </message>
    <message>
        <source>Taps of the hand that feels the surface give depth differences, strokes profiles</source>
        <translation>Tippen mit der fühlenden Hand ergibt Tiefenunterschiede, Striche ergeben Profile</translation>
    </message>
    <message>
        <source>Profile c&amp;urve</source>
        <translation>Profil&amp;kurve</translation>
    </message>
    <message>
        <source>Show or hide the curve of the selected profile under the views</source>
        <translation>Die Kurve des gewählten Profils unter den Ansichten zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Save profil&amp;e as shown…</source>
        <translation>Profil wie &amp;gezeigt speichern…</translation>
    </message>
    <message>
        <source>The curve under the views with its cursor as SVG, or its numbers as CSV</source>
        <translation>Die Kurve unter den Ansichten mit ihrem Zeiger als SVG oder ihre Zahlen als CSV</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>The list as CSV, or the selected profile or section as CSV or SVG</source>
        <translation>Die Liste als CSV, oder das gewählte Profil oder den Schnitt als CSV oder SVG</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>&amp;CSV</translation>
    </message>
    <message>
        <source>A table as text that every program opens</source>
        <translation>Eine Tabelle als Text, die jedes Programm öffnet</translation>
    </message>
    <message>
        <source>&amp;HDF5</source>
        <translation>&amp;HDF5</translation>
    </message>
    <message>
        <source>Smaller, with units and surface; for Python and MATLAB</source>
        <translation>Kleiner, mit Einheiten und Oberfläche; für Python und MATLAB</translation>
    </message>
    <message>
        <source>F&amp;older of recordings…</source>
        <translation>Or&amp;dner der Aufnahmen …</translation>
    </message>
    <message>
        <source>Where recordings go that are made from now on</source>
        <translation>Wohin Aufnahmen von jetzt an kommen</translation>
    </message>
    <message>
        <source>Re&amp;play…</source>
        <translation>&amp;Wiedergabe…</translation>
    </message>
    <message>
        <source>Show a recording of a touch again; no device is moved</source>
        <translation>Eine Aufzeichnung eines Ertastens noch einmal zeigen; kein Gerät wird bewegt</translation>
    </message>
    <message>
        <source>P&amp;lay or pause</source>
        <translation>Abspielen &amp;oder halten</translation>
    </message>
    <message>
        <source>Go on with the replay, or halt it</source>
        <translation>Die Wiedergabe fortsetzen oder anhalten</translation>
    </message>
    <message>
        <source>Ne&amp;xt event</source>
        <translation>Nächstes &amp;Ereignis</translation>
    </message>
    <message>
        <source>Go to the next event or note of the recording</source>
        <translation>Zum nächsten Ereignis oder zur nächsten Notiz der Aufzeichnung gehen</translation>
    </message>
    <message>
        <source>Event &amp;before</source>
        <translation>Vo&amp;riges Ereignis</translation>
    </message>
    <message>
        <source>Go back to the event or note before</source>
        <translation>Zum Ereignis oder zur Notiz davor zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Close replay</source>
        <translation>Wiedergabe &amp;schließen</translation>
    </message>
    <message>
        <source>Back to the window from before</source>
        <translation>Zurück zum Ausschnitt von vorher</translation>
    </message>
    <message>
        <source>A video of the replay, or of the camera path, frame by frame</source>
        <translation>Ein Video der Wiedergabe oder des Kamerawegs, Bild für Bild</translation>
    </message>
    <message>
        <source>Video of the vie&amp;w</source>
        <translation>&amp;Video der Ansicht</translation>
    </message>
    <message>
        <source>Start or stop a video of what the detail view and the plots show</source>
        <translation>Ein Video dessen, was Detailansicht und Kurven zeigen, beginnen oder beenden</translation>
    </message>
    <message>
        <source>Add &amp;key view</source>
        <translation>Kamerapunkt &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Let the camera path pass this view, three seconds after the one before</source>
        <translation>Den Kameraweg durch diese Ansicht führen, drei Sekunden nach der vorigen</translation>
    </message>
    <message>
        <source>Show camera pa&amp;th</source>
        <translation>Kameraweg &amp;zeigen</translation>
    </message>
    <message>
        <source>Run along the key views once, or stop</source>
        <translation>Die Kamerapunkte einmal durchlaufen, oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Forget key views</source>
        <translation>&amp;Kamerapunkte vergessen</translation>
    </message>
    <message>
        <source>Begin a new camera path</source>
        <translation>Einen neuen Kameraweg beginnen</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Help in the browser, at the page for what has the keyboard; guide, documentation</source>
        <translation>Handbuch im Browser, auf der Seite zu dem, wo die Tastatur ist; Hilfe, Anleitung, Dokumentation</translation>
    </message>
    <message>
        <source>&amp;Search commands…</source>
        <translation>&amp;Befehle suchen…</translation>
    </message>
    <message>
        <source>Find a command by its words and run it</source>
        <translation>Einen Befehl an seinen Wörtern finden und ausführen</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>All keys on one sheet</source>
        <translation>Alle Tasten auf einem Blatt</translation>
    </message>
    <message>
        <source>&amp;Introduction</source>
        <translation>&amp;Einführung</translation>
    </message>
    <message>
        <source>Say what is open and how it is touched</source>
        <translation>Sagen, was geöffnet ist und wie man es tastet</translation>
    </message>
    <message>
        <source>&amp;About relievo</source>
        <translation>Über &amp;relievo</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Depth m&amp;ethod</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>Export archive pac&amp;kage…</source>
        <translation>Archiv&amp;paket exportieren…</translation>
    </message>
    <message>
        <source>Over&amp;view</source>
        <translation>Üb&amp;ersicht</translation>
    </message>
    <message>
        <source>Side pa&amp;nels</source>
        <translation>&amp;Seitenfelder</translation>
    </message>
    <message>
        <source>Shaded re&amp;lief</source>
        <translation>&amp;Beleuchtetes Relief</translation>
    </message>
    <message>
        <source>Move the focus between the overview and the detail view</source>
        <translation>Den Fokus zwischen Übersicht und Detailansicht wechseln</translation>
    </message>
    <message>
        <source>&amp;Previous part</source>
        <translation>Vori&amp;ger Teil</translation>
    </message>
    <message>
        <source>&amp;CPU</source>
        <translation>&amp;CPU</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>&amp;OpenGL</translation>
    </message>
    <message>
        <source>Save &amp;video…</source>
        <translation>V&amp;ideo speichern…</translation>
    </message>
    <message>
        <source>Keep view and &amp;zoom for next file</source>
        <translation>&amp;Jetzigen Blick für nächste Datei behalten</translation>
    </message>
    <message>
        <source>The next file is seen from the same side, turned and placed alike; Ctrl while dropping it does the same once</source>
        <translation>Die nächste Datei wird von derselben Seite gezeigt, ebenso gedreht und an derselben Stelle; Strg beim Ablegen bewirkt das einmal</translation>
    </message>
    <message>
        <source>&amp;Stereo</source>
        <translation>Stereo (z&amp;wei Augen)</translation>
    </message>
    <message>
        <source>Depth for two eyes: red and cyan glasses, or a screen for stereo</source>
        <translation>Tiefe für zwei Augen: Rot-Cyan-Brille oder ein Stereobildschirm</translation>
    </message>
    <message>
        <source>Mar&amp;ker here</source>
        <translation>Mar&amp;kierung hier</translation>
    </message>
    <message>
        <source>Mark the place under the hand, or remove the marker there</source>
        <translation>Die Stelle unter der Hand markieren oder die Markierung dort entfernen</translation>
    </message>
    <message>
        <source>Begin s&amp;itting of a study…</source>
        <translation>Sitzung einer St&amp;udie beginnen…</translation>
    </message>
    <message>
        <source>Next con&amp;dition</source>
        <translation>Nächste Bedin&amp;gung</translation>
    </message>
    <message>
        <source>Show the next condition of the sitting, or end it after the last</source>
        <translation>Die nächste Bedingung der Sitzung zeigen oder sie nach der letzten beenden</translation>
    </message>
    <message>
        <source>End sittin&amp;g</source>
        <translation>Sitzung &amp;beenden</translation>
    </message>
    <message>
        <source>End the sitting before all conditions were shown</source>
        <translation>Die Sitzung beenden, bevor alle Bedingungen gezeigt wurden</translation>
    </message>
    <message>
        <source>Show the points or the mesh behind the relief in the place of the overview, turned freely</source>
        <translation>Die Punkte oder das Netz hinter dem Relief an der Stelle der Übersicht zeigen, frei gedreht</translation>
    </message>
    <message>
        <source>3-D</source>
        <translation>3-D</translation>
    </message>
    <message>
        <source>Make the relief anew from where the scan in 3-D is looked at</source>
        <translation>Das Relief neu machen, von wo der Scan in 3-D betrachtet wird</translation>
    </message>
    <message>
        <source>Scan in &amp;3-D</source>
        <translation>Scan in &amp;3-D</translation>
    </message>
    <message>
        <source>Make rel&amp;ief as the scan is seen</source>
        <translation>Relief, &amp;wie der Scan gesehen wird</translation>
    </message>
    <message>
        <source>Region, level, vertical exaggeration, light, colours and turn, to be sent or pasted</source>
        <translation>Region, Ebene, Überhöhung, Licht, Farben und Drehung, zum Verschicken oder Einfügen</translation>
    </message>
    <message>
        <source>Shaded, with a colour for each height</source>
        <translation>Beleuchtet, mit einer Farbe für jede Höhe</translation>
    </message>
    <message>
        <source>Shaded, with &amp;ambient occlusion</source>
        <translation>Beleuchtet, mit &amp;Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Shaded, and darker in hollows and grooves</source>
        <translation>Beleuchtet und dunkler in Mulden und Rillen</translation>
    </message>
    <message>
        <source>Finer resolution: a smaller window</source>
        <translation>Feinere Auflösung: ein kleinerer Ausschnitt</translation>
    </message>
    <message>
        <source>Coarser resolution: a larger window</source>
        <translation>Gröbere Auflösung: ein größerer Ausschnitt</translation>
    </message>
    <message>
        <source>Add book&amp;mark…</source>
        <translation>Lese&amp;zeichen hinzufügen…</translation>
    </message>
    <message>
        <source>Keep the window under a name, to come back to it</source>
        <translation>Den Ausschnitt unter einem Namen merken, um zu ihm zurückzukehren</translation>
    </message>
    <message>
        <source>Ne&amp;xt bookmark</source>
        <translation>&amp;Nächstes Lesezeichen</translation>
    </message>
    <message>
        <source>Go to the next bookmark or marker</source>
        <translation>Zum nächsten Lesezeichen oder zur nächsten Markierung gehen</translation>
    </message>
    <message>
        <source>Pre&amp;vious bookmark</source>
        <translation>Voriges Le&amp;sezeichen</translation>
    </message>
    <message>
        <source>Go to the bookmark or marker before this one</source>
        <translation>Zum Lesezeichen oder zur Markierung davor gehen</translation>
    </message>
    <message>
        <source>Bookmarks as conditions in random order, under letters, for one participant</source>
        <translation>Lesezeichen als Bedingungen in zufälliger Reihenfolge, unter Buchstaben, für eine teilnehmende Person</translation>
    </message>
    <message>
        <source>Open &amp;web address…</source>
        <translation>&amp;Webadresse öffnen…</translation>
    </message>
    <message>
        <source>Open a map that was published on the web, by its address</source>
        <translation>Eine im Netz veröffentlichte Karte über ihre Adresse öffnen</translation>
    </message>
    <message>
        <source>&amp;Object turns with the view</source>
        <translation>Objek&amp;t dreht sich mit der Ansicht</translation>
    </message>
    <message>
        <source>While the view is turned, the relief is made anew again and again, and the hand feels the object turn</source>
        <translation>Während die Ansicht gedreht wird, wird das Relief immer wieder neu berechnet, und die Hand spürt, wie sich das Objekt dreht</translation>
    </message>
    <message>
        <source>Map by &amp;tiles…</source>
        <translation>&amp;Karte in Kacheln…</translation>
    </message>
    <message>
        <source>Make the map of a scan that is larger than the memory</source>
        <translation>Die Karte eines Scans machen, der größer als der Speicher ist</translation>
    </message>
    <message>
        <source>Set up exhi&amp;bit…</source>
        <translation>Ausstellung einrichte&amp;n…</translation>
    </message>
    <message>
        <source>What visitors of an exhibit are offered, and how it looks after them</source>
        <translation>Was den Besuchern einer Ausstellung angeboten wird, und wie sie begleitet werden</translation>
    </message>
    <message>
        <source>&amp;Feel with the mouse</source>
        <translation>Mit der &amp;Maus fühlen</translation>
    </message>
    <message>
        <source>The pointer is slower uphill and faster downhill, and larger on heights; Escape ends it</source>
        <translation>Der Zeiger ist bergauf langsamer, bergab schneller und auf Höhen größer; Escape beendet es</translation>
    </message>
</context>
<context>
    <name>relievo::CommandWords</name>
    <message>
        <source>load import file read</source>
        <translation>laden importieren Datei einlesen</translation>
    </message>
    <message>
        <source>load import directory images</source>
        <translation>laden importieren Verzeichnis Bilder</translation>
    </message>
    <message>
        <source>store keep session</source>
        <translation>sichern behalten Sitzung</translation>
    </message>
    <message>
        <source>export publish print paper PDF SVG TIFF screenshot</source>
        <translation>exportieren veröffentlichen drucken Aufsatz PDF SVG TIFF Bildschirmfoto</translation>
    </message>
    <message>
        <source>export screenshot snapshot picture photo PNG capture</source>
        <translation>exportieren Bildschirmfoto Schnappschuss Foto PNG</translation>
    </message>
    <message>
        <source>save as convert STL PLY OBJ glTF GeoTIFF mesh 3D print section profile</source>
        <translation>speichern unter umwandeln STL PLY OBJ glTF GeoTIFF Netz 3D-Druck Schnitt Profil</translation>
    </message>
    <message>
        <source>export archive zip share cite</source>
        <translation>exportieren Archiv zip teilen zitieren</translation>
    </message>
    <message>
        <source>end unload</source>
        <translation>beenden zumachen</translation>
    </message>
    <message>
        <source>exit end</source>
        <translation>verlassen schließen</translation>
    </message>
    <message>
        <source>clean crop cut trim align register merge join thin decimate outliers noise edit cloud</source>
        <translation>säubern reinigen zuschneiden beschneiden ausrichten registrieren zusammenfügen vereinen ausdünnen Ausreißer Rauschen Punktwolke bearbeiten</translation>
    </message>
    <message>
        <source>align rotate orient resolution grid holes fill rasterize crop clean</source>
        <translation>ausrichten drehen orientieren Auflösung Raster Löcher füllen rastern zuschneiden säubern</translation>
    </message>
    <message>
        <source>scale millimetres metres inches</source>
        <translation>Maßstab Millimeter Meter Zoll</translation>
    </message>
    <message>
        <source>zoom all overview reset fit</source>
        <translation>zoomen alles Übersicht zurücksetzen einpassen</translation>
    </message>
    <message>
        <source>zoom reset home straighten camera</source>
        <translation>zoomen zurücksetzen geraderichten Kamera</translation>
    </message>
    <message>
        <source>crop region coordinates selection go to</source>
        <translation>zuschneiden Bereich Koordinaten Auswahl gehe zu</translation>
    </message>
    <message>
        <source>best feel where find interesting places</source>
        <translation>beste fühlen wo finden interessante Stellen</translation>
    </message>
    <message>
        <source>rotate orbit spin</source>
        <translation>rotieren kreisen schwenken</translation>
    </message>
    <message>
        <source>rotate orbit tilt</source>
        <translation>rotieren kreisen kippen</translation>
    </message>
    <message>
        <source>align rotate orient plane</source>
        <translation>ausrichten rotieren orientieren Ebene</translation>
    </message>
    <message>
        <source>align rotate orient level</source>
        <translation>ausrichten rotieren orientieren eben</translation>
    </message>
    <message>
        <source>rotate orbit mouse navigate</source>
        <translation>rotieren drehen Maus navigieren</translation>
    </message>
    <message>
        <source>feel press mouse haptic</source>
        <translation>ertasten drücken Maus haptisch</translation>
    </message>
    <message>
        <source>mouse button mode tool</source>
        <translation>Maustaste Modus Werkzeug</translation>
    </message>
    <message>
        <source>light shadow oblique grazing</source>
        <translation>Licht Schatten schräg streifend</translation>
    </message>
    <message>
        <source>light lamp reset</source>
        <translation>Licht Lampe zurücksetzen</translation>
    </message>
    <message>
        <source>cross section cut line height curve</source>
        <translation>Querschnitt Linie Höhenkurve</translation>
    </message>
    <message>
        <source>export curve plot SVG CSV</source>
        <translation>exportieren Kurve SVG CSV</translation>
    </message>
    <message>
        <source>export table spreadsheet CSV</source>
        <translation>exportieren Tabelle CSV</translation>
    </message>
    <message>
        <source>help guide documentation handbook</source>
        <translation>Hilfe Anleitung Dokumentation</translation>
    </message>
    <message>
        <source>help shortcuts hotkeys keyboard mouse</source>
        <translation>Hilfe Tastenkürzel Tastatur Maus</translation>
    </message>
    <message>
        <source>settings options configure language theme</source>
        <translation>Optionen konfigurieren Sprache Farben</translation>
    </message>
    <message>
        <source>compare same camera series next scan lock</source>
        <translation>vergleichen gleiche Kamera Serie nächster Scan festhalten</translation>
    </message>
    <message>
        <source>experiment participant trial blind randomize</source>
        <translation>Experiment Versuch Teilnehmer Durchgang blind zufällig</translation>
    </message>
    <message>
        <source>point cloud mesh raw 3D turn rotate orbit object arrow</source>
        <translation>Punktwolke Netz roh 3D drehen Objekt Pfeil</translation>
    </message>
    <message>
        <source>align rotate orient projection view direction</source>
        <translation>ausrichten drehen Projektion Blickrichtung</translation>
    </message>
    <message>
        <source>zoom in closer magnify level detail</source>
        <translation>zoomen hinein näher vergrößern Ebene Detail</translation>
    </message>
    <message>
        <source>zoom out farther level detail</source>
        <translation>zoomen heraus weiter verkleinern Ebene Detail</translation>
    </message>
    <message>
        <source>place name save position favourite</source>
        <translation>Stelle Ort benennen merken Position Favorit</translation>
    </message>
    <message>
        <source>place position favourite</source>
        <translation>Stelle Ort Position Favorit</translation>
    </message>
    <message>
        <source>internet network URL link online server remote https</source>
        <translation>Internet Netz URL Link online Server entfernt https</translation>
    </message>
    <message>
        <source>rotate orbit object under the hand while touching live</source>
        <translation>drehen rotieren Objekt unter der Hand beim Berühren mitdrehen live</translation>
    </message>
    <message>
        <source>large huge out of core memory build pyramid survey site LAS</source>
        <translation>groß riesig Speicher Pyramide Vermessung Gelände Fundstätte LAS</translation>
    </message>
    <message>
        <source>museum kiosk playlist visitors exhibition PIN</source>
        <translation>Museum Kiosk Abspielliste Besucher Ausstellung PIN</translation>
    </message>
    <message>
        <source>pseudo-haptic cursor slow bumps holes touch</source>
        <translation>pseudohaptisch Mauszeiger langsam Buckel Löcher ertasten</translation>
    </message>
</context>
<context>
    <name>relievo::DepthMapDialog</name>
    <message>
        <source>What the map is made of</source>
        <translation>Woraus die Karte besteht</translation>
    </message>
    <message>
        <source>%1 of the cells are measured</source>
        <translation>%1 der Zellen sind gemessen</translation>
    </message>
    <message>
        <source>%1 interpolated</source>
        <translation>%1 interpoliert</translation>
    </message>
    <message>
        <source>%1 holes on the base plane</source>
        <translation>%1 Löcher auf der Grundebene</translation>
    </message>
    <message>
        <source>%1 too steep</source>
        <translation>%1 zu steil</translation>
    </message>
    <message>
        <source>%1 outside</source>
        <translation>%1 außerhalb</translation>
    </message>
    <message>
        <source>No enclosed holes.</source>
        <translation>Keine umschlossenen Löcher.</translation>
    </message>
    <message>
        <source>%1 (filled)</source>
        <translation>%1 (gefüllt)</translation>
    </message>
    <message>
        <source>Enclosed holes: %1, of %2 mm².</source>
        <translation>Umschlossene Löcher: %1, mit %2 mm².</translation>
    </message>
    <message>
        <source>Hidden from here: %1; undercut: %2; too steep: %3.</source>
        <translation>Von hier verdeckt: %1; hinterschnitten: %2; zu steil: %3.</translation>
    </message>
    <message>
        <source>%1 × %2 cells of %3, %4 levels; %5.</source>
        <translation>%1 × %2 Zellen zu %3, %4 Ebenen; %5.</translation>
    </message>
    <message>
        <source>Shares of the cells</source>
        <translation>Anteile der Zellen</translation>
    </message>
    <message>
        <source>About this depth map</source>
        <translation>Über diese Tiefenkarte</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>L&amp;ive</source>
        <translation>&amp;Laufend</translation>
    </message>
    <message>
        <source>Sho&amp;w what was not measured</source>
        <translation>&amp;Nicht Gemessenes zeigen</translation>
    </message>
    <message>
        <source>Recom&amp;pute</source>
        <translation>Neu &amp;berechnen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Depth map</source>
        <translation>Tiefenkarte</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>Make the preview of the choices shown</source>
        <translation>Die Vorschau mit dieser Auswahl machen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop the work; the picture before stays</source>
        <translation>Die Arbeit anhalten; das Bild von vorher bleibt</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>Laufende Vorschau</translation>
    </message>
    <message>
        <source>Make the preview anew after each change</source>
        <translation>Die Vorschau nach jeder Änderung neu machen</translation>
    </message>
    <message>
        <source>Show what was not measured</source>
        <translation>Nicht Gemessenes zeigen</translation>
    </message>
    <message>
        <source>Blue stripes: interpolated. Purple crosses: holes on the base plane. Orange: too steep</source>
        <translation>Blaue Streifen: interpoliert. Lila Kreuze: Löcher auf der Grundebene. Orange: zu steil</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>What is being done</source>
        <translation>Was gerade geschieht</translation>
    </message>
    <message>
        <source>Recom&amp;pute *</source>
        <translation>Neu &amp;berechnen *</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stray points left out: %1.</source>
        <translation>Streupunkte weggelassen: %1.</translation>
    </message>
</context>
<context>
    <name>relievo::DepthMapForm</name>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>E&amp;inheit der Datei</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>Längeneinheit der Koordinaten in der Datei</translation>
    </message>
    <message>
        <source>Size in millimetres</source>
        <translation>Größe in Millimetern</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>An&amp;sicht</translation>
    </message>
    <message>
        <source>From which side the object is seen</source>
        <translation>Von welcher Seite das Objekt gesehen wird</translation>
    </message>
    <message>
        <source>As turned in the detail view</source>
        <translation>Wie in der Detailansicht gedreht</translation>
    </message>
    <message>
        <source>Turn about &amp;x</source>
        <translation>Drehung um &amp;x</translation>
    </message>
    <message>
        <source>Turn about &amp;y</source>
        <translation>Drehung um &amp;y</translation>
    </message>
    <message>
        <source>Turn a&amp;bout z</source>
        <translation>&amp;Drehung um z</translation>
    </message>
    <message>
        <source>Right-handed, about the view&apos;s own axes, x first</source>
        <translation>Rechtshändig, um die Achsen der Ansicht, zuerst x</translation>
    </message>
    <message>
        <source>The processor, or the graphics card&apos;s depth buffer as in the paper</source>
        <translation>Der Prozessor, oder der Tiefenpuffer der Grafikkarte wie im Aufsatz</translation>
    </message>
    <message>
        <source>Which height a cell gets from the points in it</source>
        <translation>Welche Höhe eine Zelle aus ihren Punkten bekommt</translation>
    </message>
    <message>
        <source>From the data</source>
        <translation>Aus den Daten</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>R&amp;aster</translation>
    </message>
    <message>
        <source>How fine the grid is</source>
        <translation>Wie fein das Raster ist</translation>
    </message>
    <message>
        <source>Number of cells</source>
        <translation>Anzahl der Zellen</translation>
    </message>
    <message>
        <source>Size of a cell</source>
        <translation>Größe einer Zelle</translation>
    </message>
    <message>
        <source>&amp;Cells</source>
        <translation>Z&amp;ellen</translation>
    </message>
    <message>
        <source>Cells across the longer side</source>
        <translation>Zellen über die längere Seite</translation>
    </message>
    <message>
        <source>Cell si&amp;ze</source>
        <translation>&amp;Zellengröße</translation>
    </message>
    <message>
        <source>Distance of neighbouring cells</source>
        <translation>Abstand benachbarter Zellen</translation>
    </message>
    <message>
        <source>How much coarser each level of the pyramid is; 2 in the paper</source>
        <translation>Wievielmal gröber jede Ebene der Pyramide ist; 2 im Aufsatz</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>Lö&amp;cher</translation>
    </message>
    <message>
        <source>What becomes of enclosed places where nothing was measured</source>
        <translation>Was aus umschlossenen Stellen wird, an denen nichts gemessen wurde</translation>
    </message>
    <message>
        <source>On the base plane</source>
        <translation>Auf der Grundebene</translation>
    </message>
    <message>
        <source>Interpolate up to</source>
        <translation>Interpolieren bis</translation>
    </message>
    <message>
        <source>Smooth membrane up to</source>
        <translation>Glatte Membran bis</translation>
    </message>
    <message>
        <source>Leave open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>&amp;Largest hole</source>
        <translation>&amp;Größtes Loch</translation>
    </message>
    <message>
        <source>Larger holes rest on the base plane</source>
        <translation>Größere Löcher liegen auf der Grundebene</translation>
    </message>
    <message>
        <source>The lowest cell of the raster</source>
        <translation>Die tiefste Zelle des Rasters</translation>
    </message>
    <message>
        <source>0.1 % of the measured cells lie below it</source>
        <translation>0,1 % der gemessenen Zellen liegen darunter</translation>
    </message>
    <message>
        <source>Base plane</source>
        <translation>Grundebene</translation>
    </message>
    <message>
        <source>A height map keeps its cells and its view.</source>
        <translation>Eine Höhenkarte behält ihre Zellen und ihre Ansicht.</translation>
    </message>
    <message>
        <source>A map of this program is in millimetres.</source>
        <translation>Eine Karte dieses Programms ist in Millimetern.</translation>
    </message>
    <message>
        <source>A map of this program has its holes treated already.</source>
        <translation>In einer Karte dieses Programms sind die Löcher schon behandelt.</translation>
    </message>
    <message>
        <source>Triangles need no rule.</source>
        <translation>Dreiecke brauchen keine Regel.</translation>
    </message>
    <message>
        <source>The depth buffer keeps the front-most point.</source>
        <translation>Der Tiefenpuffer behält den vordersten Punkt.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>&amp;Far-off points</source>
        <translation>&amp;Weit entfernte Punkte</translation>
    </message>
    <message>
        <source>Few points so far from all others that they stretch the map</source>
        <translation>Wenige Punkte, die so weit von allen anderen liegen, dass sie die Karte strecken</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>A height map has none.</source>
        <translation>Eine Höhenkarte hat keine.</translation>
    </message>
    <message>
        <source>Leave out, groups too</source>
        <translation>Weglassen, auch Gruppen</translation>
    </message>
    <message>
        <source>M&amp;ethod</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Height pe&amp;r cell</source>
        <translation>Höhe je &amp;Zelle</translation>
    </message>
    <message>
        <source>Pyra&amp;mid factor</source>
        <translation>Pyra&amp;midenfaktor</translation>
    </message>
</context>
<context>
    <name>relievo::DepthMapPreview</name>
    <message>
        <source>Preview of the depth map</source>
        <translation>Vorschau der Tiefenkarte</translation>
    </message>
    <message>
        <source>Of other choices than those shown</source>
        <translation>Mit anderer Auswahl als gezeigt</translation>
    </message>
    <message>
        <source>Of the choices shown</source>
        <translation>Mit der gezeigten Auswahl</translation>
    </message>
    <message>
        <source>Not of these choices yet</source>
        <translation>Noch nicht mit dieser Auswahl</translation>
    </message>
</context>
<context>
    <name>relievo::DetailView</name>
    <message>
        <source>Detail view</source>
        <translation>Detailansicht</translation>
    </message>
    <message>
        <source>Move window</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>The part inside the pink window. The pointer carries the hand just above the surface. What dragging does, F7 changes between the two: %1. %2; the wheel meanwhile presses deeper, and with another button held it changes the resolution. Keys: arrows, Page Down, Page Up.</source>
        <translation>Der Teil im rosa Ausschnitt. Der Zeiger führt die Hand dicht über der Oberfläche. Was Ziehen bewirkt, F7 wechselt zwischen beiden: %1. %2; das Rad drückt währenddessen tiefer, und solange eine weitere Taste gehalten wird, ändert es die Auflösung. Tasten: Pfeile, Bild ab, Bild auf.</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceButtons</name>
    <message>
        <source>%1 connected.</source>
        <translation>%1 angeschlossen.</translation>
    </message>
    <message>
        <source>%1 disconnected.</source>
        <translation>%1 getrennt.</translation>
    </message>
    <message>
        <source>%1?</source>
        <translation>%1?</translation>
    </message>
    <message>
        <source>Move mode. Push the grip to a side; Forward when you are there.</source>
        <translation>Verschieben. Drücken Sie den Griff zur Seite; Vorwärts, wenn Sie da sind.</translation>
    </message>
    <message>
        <source>%1 is not possible here.</source>
        <translation>%1 ist hier nicht möglich.</translation>
    </message>
    <message>
        <source>%1 is plugged in but this account may not use it. Install the rule that &apos;relievo devices rule&apos; prints, once, then replug.</source>
        <translation>%1 ist angesteckt, aber dieses Konto darf es nicht benutzen. Installieren Sie einmal die Regel, die „relievo devices rule“ ausgibt, und stecken Sie es neu an.</translation>
    </message>
    <message>
        <source>Forces are off.</source>
        <translation>Die Kräfte sind aus.</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceRows</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>What the hand holds. A virtual hand is moved by the mouse and pushed by the force, as a real one is.</source>
        <translation>Was die Hand hält. Eine virtuelle Hand wird von der Maus bewegt und von der Kraft gedrückt, wie eine wirkliche.</translation>
    </message>
    <message>
        <source>Whether somebody has tried such a device</source>
        <translation>Ob jemand ein solches Gerät erprobt hat</translation>
    </message>
    <message>
        <source>How warm the motors are</source>
        <translation>Wie warm die Motoren sind</translation>
    </message>
    <message>
        <source>Hold the grip&apos;s weig&amp;ht</source>
        <translation>Das Gewic&amp;ht des Griffs halten</translation>
    </message>
    <message>
        <source>Hold the grip&apos;s weight</source>
        <translation>Das Gewicht des Griffs halten</translation>
    </message>
    <message>
        <source>While forces are on, the device holds its own grip, as heavy as the calibration found it. Nothing happens where it was not calibrated, or where the device does so by itself.</source>
        <translation>Solange die Kräfte an sind, hält das Gerät seinen Griff selbst, so schwer, wie die Kalibrierung ihn fand. Nichts geschieht, wo nicht kalibriert wurde oder das Gerät es von sich aus tut.</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>G&amp;erät</translation>
    </message>
    <message>
        <source>Tried on hardware: ask who made the plug-in.</source>
        <translation>An einem echten Gerät erprobt: Fragen Sie, wer das Plug-in gemacht hat.</translation>
    </message>
    <message>
        <source>Tried on hardware: never.</source>
        <translation>An einem echten Gerät erprobt: nie.</translation>
    </message>
    <message>
        <source>Tried on hardware: %1.</source>
        <translation>An einem echten Gerät erprobt: %1.</translation>
    </message>
    <message>
        <source>%1 (not here now)</source>
        <translation>%1 (gerade nicht da)</translation>
    </message>
    <message>
        <source>Before you, relief upright</source>
        <translation>Vor Ihnen, Relief aufrecht</translation>
    </message>
    <message>
        <source>Before you, relief flat</source>
        <translation>Vor Ihnen, Relief liegend</translation>
    </message>
    <message>
        <source>At your left, turned to you</source>
        <translation>Links von Ihnen, Ihnen zugewandt</translation>
    </message>
    <message>
        <source>At your right, turned to you</source>
        <translation>Rechts von Ihnen, Ihnen zugewandt</translation>
    </message>
    <message>
        <source>How the device stands</source>
        <translation>Wie das Gerät steht</translation>
    </message>
    <message>
        <source>Which way the grip is pushed to press: away from you, or down onto a relief that lies flat; or the device stands beside you. Forces go off when it changes. The mouse is the same in each.</source>
        <translation>Wohin der Griff gedrückt wird: von Ihnen weg, oder nach unten auf ein liegendes Relief; oder das Gerät steht neben Ihnen. Beim Wechsel gehen die Kräfte aus. Die Maus ist in jeder gleich.</translation>
    </message>
    <message>
        <source>Grip posi&amp;tion</source>
        <translation>Grif&amp;fposition</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceSetupDialog</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>Device set-up</source>
        <translation>Gerät einrichten</translation>
    </message>
    <message>
        <source>State of the Falcon</source>
        <translation>Zustand des Falcon</translation>
    </message>
    <message>
        <source>&amp;Left-handed: plus and minus change sides</source>
        <translation>&amp;Linkshändig: Plus und Minus tauschen die Seiten</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Linkshändig</translation>
    </message>
    <message>
        <source>&amp;Save and use the Falcon</source>
        <translation>Speichern &amp;und den Falcon benutzen</translation>
    </message>
    <message>
        <source>Save and use the Falcon</source>
        <translation>Speichern und den Falcon benutzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The rule is copied.</source>
        <translation>Die Regel ist kopiert.</translation>
    </message>
    <message>
        <source>Test and calibration</source>
        <translation>Prüfung und Kalibrierung</translation>
    </message>
    <message>
        <source>Self &amp;test</source>
        <translation>&amp;Selbsttest</translation>
    </message>
    <message>
        <source>Self test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Weight for calibration in grams</source>
        <translation>Gewicht zum Kalibrieren in Gramm</translation>
    </message>
    <message>
        <source> g</source>
        <translation> g</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>&amp;Gewicht</translation>
    </message>
    <message>
        <source>C&amp;alibrate</source>
        <translation>&amp;Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Force gain</source>
        <translation>Kraftverstärkung</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>%1 counts per N mm</source>
        <translation>%1 Zählschritte je N mm</translation>
    </message>
    <message>
        <source>Falcon firmware</source>
        <translation>Falcon-Firmware</translation>
    </message>
    <message>
        <source>Firmware (*.bin);;All files (*)</source>
        <translation>Firmware (*.bin);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Unknown firmware</source>
        <translation>Unbekannte Firmware</translation>
    </message>
    <message>
        <source>The file has the form of a boot image, but nobody knows this one (sha256 %1). Load it into the Falcon all the same?</source>
        <translation>Die Datei hat die Form eines Startabbilds, aber niemand kennt es (sha256 %1). Trotzdem in den Falcon laden?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Contin&amp;ue</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>The computer goes to sleep; the forces are off and this has ended. Begin again when it is awake.</source>
        <translation>Der Computer geht in den Ruhezustand; die Kräfte sind aus und dies ist beendet. Beginnen Sie noch einmal, wenn er wach ist.</translation>
    </message>
    <message>
        <source>Set up a &amp;Haply device…</source>
        <translation>Ein &amp;Haply-Gerät einrichten …</translation>
    </message>
    <message>
        <source>Set up a Haply device</source>
        <translation>Ein Haply-Gerät einrichten</translation>
    </message>
</context>
<context>
    <name>relievo::DeviceTrustBox</name>
    <message>
        <source>They are being looked for.</source>
        <translation>Sie werden gesucht.</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>Noch einmal &amp;suchen</translation>
    </message>
    <message>
        <source>Look for plug-ins again</source>
        <translation>Noch einmal nach Plugins suchen</translation>
    </message>
    <message>
        <source>None was found. Your own are looked for in %1.</source>
        <translation>Keines wurde gefunden. Ihre eigenen werden in %1 gesucht.</translation>
    </message>
    <message>
        <source>Its folder is trusted.</source>
        <translation>Seinem Ordner wird vertraut.</translation>
    </message>
    <message>
        <source>%1 may run</source>
        <translation>%1 darf laufen</translation>
    </message>
    <message>
        <source>%1 may run from now on, until its file changes.</source>
        <translation>%1 darf von jetzt an laufen, bis sich seine Datei ändert.</translation>
    </message>
    <message>
        <source>%1 may not run any more.</source>
        <translation>%1 darf nicht mehr laufen.</translation>
    </message>
</context>
<context>
    <name>relievo::Document</name>
    <message>
        <source>This map is read by tiles, as it was made; nothing was changed. To make it otherwise, run relievo depthmap --memory on its scan, with the choices you want.</source>
        <translation>Diese Karte wird in Kacheln gelesen, so wie sie gemacht wurde; nichts wurde geändert. Um sie anders zu machen, rufen Sie relievo depthmap --memory mit ihrem Scan und der gewünschten Auswahl auf.</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Straighten the view</source>
        <translation>Ansicht geraderichten</translation>
    </message>
</context>
<context>
    <name>relievo::ExhibitDialog</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Is it whole?</source>
        <translation>Ist sie vollständig?</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Enter or a double click goes to the place</source>
        <translation>Eingabetaste oder Doppelklick führt zu der Stelle</translation>
    </message>
    <message>
        <source>Op&amp;en…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Change an exhibit that is there</source>
        <translation>Eine vorhandene Ausstellung ändern</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Keep the exhibit in its file</source>
        <translation>Die Ausstellung in ihrer Datei speichern</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Keep the exhibit in another file</source>
        <translation>Die Ausstellung in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>Obje&amp;cts</source>
        <translation>Ob&amp;jekte</translation>
    </message>
    <message>
        <source>V&amp;isit</source>
        <translation>&amp;Besuch</translation>
    </message>
    <message>
        <source>%1 has faults. What they stand at is as it would be if nothing were said: %2</source>
        <translation>%1 hat Fehler. Was sie betreffen, steht so da, als wäre nichts gesagt: %2</translation>
    </message>
    <message>
        <source>Exhibit[*]</source>
        <translation>Ausstellung[*]</translation>
    </message>
    <message>
        <source>Exhibit %1[*]</source>
        <translation>Ausstellung %1[*]</translation>
    </message>
    <message>
        <source>It cannot be shown yet; this is missing or wrong:</source>
        <translation>Sie kann noch nicht gezeigt werden; dies fehlt oder stimmt nicht:</translation>
    </message>
    <message>
        <source>It is whole. Once it is saved, it can be shown.</source>
        <translation>Sie ist vollständig. Ist sie gespeichert, kann sie gezeigt werden.</translation>
    </message>
    <message>
        <source>It is whole. This shows it: %1</source>
        <translation>Sie ist vollständig. So wird sie gezeigt: %1</translation>
    </message>
    <message>
        <source>Exhibit</source>
        <translation>Ausstellung</translation>
    </message>
    <message>
        <source>Exhibits (*.json)</source>
        <translation>Ausstellungen (*.json)</translation>
    </message>
    <message>
        <source>Save exhibit</source>
        <translation>Ausstellung speichern</translation>
    </message>
    <message>
        <source>Unsaved exhibit</source>
        <translation>Nicht gespeicherte Ausstellung</translation>
    </message>
    <message>
        <source>What was changed in the exhibit is in no file yet.</source>
        <translation>Was an der Ausstellung geändert wurde, ist noch in keiner Datei.</translation>
    </message>
    <message>
        <source>Object %1: %2</source>
        <translation>Objekt %1: %2</translation>
    </message>
    <message>
        <source>Nothing is missing. The objects are being opened to see whether they can be.</source>
        <translation>Nichts fehlt. Die Objekte werden geöffnet, um zu sehen, ob das geht.</translation>
    </message>
</context>
<context>
    <name>relievo::ExhibitObjectsPage</name>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>What visitors are offered, in this order</source>
        <translation>Was Besuchern angeboten wird, in dieser Reihenfolge</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Take scans, height maps or projects into the list</source>
        <translation>Scans, Höhenkarten oder Projekte in die Liste aufnehmen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the object out of the list</source>
        <translation>Das Objekt aus der Liste nehmen</translation>
    </message>
    <message>
        <source>U&amp;p</source>
        <translation>&amp;Nach oben</translation>
    </message>
    <message>
        <source>Offer the object earlier</source>
        <translation>Das Objekt früher anbieten</translation>
    </message>
    <message>
        <source>Dow&amp;n</source>
        <translation>Nach un&amp;ten</translation>
    </message>
    <message>
        <source>Offer the object later</source>
        <translation>Das Objekt später anbieten</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>A scan, a height map or a project</source>
        <translation>Ein Scan, eine Höhenkarte oder ein Projekt</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>Du&amp;rchsuchen…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Eine andere Datei wählen</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>Längeneinheit der Koordinaten in der Datei</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>From which side the object is touched</source>
        <translation>Von welcher Seite das Objekt befühlt wird</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>What is said and shown, in each language</source>
        <translation>Was gesagt und gezeigt wird, in jeder Sprache</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <translation>Titel, %1</translation>
    </message>
    <message>
        <source>At most %1 words, spoken and shown</source>
        <translation>Höchstens %1 Wörter, gesprochen und gezeigt</translation>
    </message>
    <message>
        <source>Description, %1</source>
        <translation>Beschreibung, %1</translation>
    </message>
    <message>
        <source>At most %1 words, spoken after the title; in every language or in none</source>
        <translation>Höchstens %1 Wörter, nach dem Titel gesprochen; in jeder Sprache oder in keiner</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>Tite&amp;l</translation>
    </message>
    <message>
        <source>&amp;Description</source>
        <translation>Beschreibun&amp;g</translation>
    </message>
    <message>
        <source>Objects of the exhibit</source>
        <translation>Objekte der Ausstellung</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>&amp;Objekte</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>Aus der Datei</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>E&amp;inheit der Datei</translation>
    </message>
    <message>
        <source>Vie&amp;w</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Object of the exhibit</source>
        <translation>Objekt der Ausstellung</translation>
    </message>
    <message>
        <source>No file</source>
        <translation>Keine Datei</translation>
    </message>
</context>
<context>
    <name>relievo::ExhibitVisitPage</name>
    <message>
        <source>Language of a new visitor</source>
        <translation>Sprache eines neuen Besuchers</translation>
    </message>
    <message>
        <source>The first that is offered, and in which all begins</source>
        <translation>Die erste, die angeboten wird und in der alles beginnt</translation>
    </message>
    <message>
        <source>Ask whether somebody is there after</source>
        <translation>Fragen, ob jemand da ist, nach</translation>
    </message>
    <message>
        <source>Seconds without any input</source>
        <translation>Sekunden ohne jede Eingabe</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Begin anew after</source>
        <translation>Neu beginnen nach</translation>
    </message>
    <message>
        <source>Seconds after the question</source>
        <translation>Sekunden nach der Frage</translation>
    </message>
    <message>
        <source>Chime every</source>
        <translation>Gong alle</translation>
    </message>
    <message>
        <source>Seconds between chimes while nobody is there: 10 to 3600, or none</source>
        <translation>Sekunden zwischen Gongs, solange niemand da ist: 10 bis 3600, oder keine</translation>
    </message>
    <message>
        <source>Volume of a new visitor</source>
        <translation>Lautstärke für neue Besucher</translation>
    </message>
    <message>
        <source>Buttons change it until the visit ends</source>
        <translation>Tasten ändern sie bis zum Ende des Besuchs</translation>
    </message>
    <message>
        <source>Loudest</source>
        <translation>Am lautesten</translation>
    </message>
    <message>
        <source>No button goes above it; how loud it is depends on the loudspeaker</source>
        <translation>Keine Taste geht darüber; wie laut das ist, hängt vom Lautsprecher ab</translation>
    </message>
    <message>
        <source>Words a minute</source>
        <translation>Wörter je Minute</translation>
    </message>
    <message>
        <source>How fast the voice speaks</source>
        <translation>Wie schnell die Stimme spricht</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Sprachen</translation>
    </message>
    <message>
        <source>Offered to visitors</source>
        <translation>Wird Besuchern angeboten</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>Stimme</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Sounds of touch</source>
        <translation>Klänge beim Fühlen</translation>
    </message>
    <message>
        <source>Staff</source>
        <translation>Personal</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of counts and logs</source>
        <translation>Den Ordner der Zählungen und Protokolle wählen</translation>
    </message>
    <message>
        <source>New PIN of the staff</source>
        <translation>Neue PIN des Personals</translation>
    </message>
    <message>
        <source>Folder of counts and logs</source>
        <translation>Ordner der Zählungen und Protokolle</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Stays as it is</source>
        <translation>Bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>falcon, mouse, or what the panel Touch calls the device</source>
        <translation>falcon, mouse, oder wie das Panel Fühlen das Gerät nennt</translation>
    </message>
    <message>
        <source>How much of every force is felt</source>
        <translation>Wie viel von jeder Kraft zu fühlen ist</translation>
    </message>
    <message>
        <source>Their volume; 0: none</source>
        <translation>Ihre Lautstärke; 0: keine</translation>
    </message>
    <message>
        <source>No force is larger</source>
        <translation>Keine Kraft ist größer</translation>
    </message>
    <message>
        <source>Begin with the introduction</source>
        <translation>Mit der Einführung beginnen</translation>
    </message>
    <message>
        <source>Each visitor&apos;s first object begins with two shapes to feel</source>
        <translation>Das erste Objekt jedes Besuchers beginnt mit zwei Formen zum Fühlen</translation>
    </message>
    <message>
        <source>Offer to lead the hand</source>
        <translation>Anbieten, die Hand zu führen</translation>
    </message>
    <message>
        <source>Once round the outline, with a device that can</source>
        <translation>Einmal um den Umriss, mit einem Gerät, das es kann</translation>
    </message>
    <message>
        <source>Taps say what sounds say</source>
        <translation>Stöße sagen, was Klänge sagen</translation>
    </message>
    <message>
        <source>For who hears neither sounds nor speech</source>
        <translation>Für Menschen, die weder Klänge noch Sprache hören</translation>
    </message>
    <message>
        <source>One button does all</source>
        <translation>Eine Taste für alles</translation>
    </message>
    <message>
        <source>For a foot switch or another single switch</source>
        <translation>Für einen Fußschalter oder einen anderen einzelnen Schalter</translation>
    </message>
    <message>
        <source>4 to 12 digits. The file keeps a checksum of them, not the digits</source>
        <translation>4 bis 12 Ziffern. Die Datei behält eine Prüfsumme davon, nicht die Ziffern</translation>
    </message>
    <message>
        <source>Empty: a folder of the account that shows the exhibit</source>
        <translation>Leer: ein Ordner des Kontos, das die Ausstellung zeigt</translation>
    </message>
    <message>
        <source>Loudest in the room</source>
        <translation>Am lautesten im Raum</translation>
    </message>
    <message>
        <source>The same on a loudspeaker; the volume falls to it where headphones are pulled out</source>
        <translation>Dasselbe über einen Lautsprecher; auf sie fällt die Lautstärke, wenn Kopfhörer herausgezogen werden</translation>
    </message>
    <message>
        <source>The same</source>
        <translation>Ebenso</translation>
    </message>
</context>
<context>
    <name>relievo::ExportController</name>
    <message>
        <source>Cancelled. Nothing was exported.</source>
        <translation>Abgebrochen. Nichts wurde exportiert.</translation>
    </message>
    <message>
        <source>%1 x %2 pixels; File &gt; Image asks for others</source>
        <translation>%1 x %2 Pixel; Datei &gt; Bild fragt nach anderen</translation>
    </message>
    <message>
        <source>Picture of the detail view (.png)</source>
        <translation>Bild der Detailansicht (.png)</translation>
    </message>
    <message>
        <source>Picture of the whole object (.png)</source>
        <translation>Bild des ganzen Objekts (.png)</translation>
    </message>
    <message>
        <source>Profile %1, drawing (.svg)</source>
        <translation>Profil %1, Zeichnung (.svg)</translation>
    </message>
    <message>
        <source>Profile %1, numbers (.csv)</source>
        <translation>Profil %1, Zahlen (.csv)</translation>
    </message>
    <message>
        <source>Section %1, drawing (.svg)</source>
        <translation>Schnitt %1, Zeichnung (.svg)</translation>
    </message>
    <message>
        <source>Section %1, numbers (.csv)</source>
        <translation>Schnitt %1, Zahlen (.csv)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 ist gespeichert</translation>
    </message>
</context>
<context>
    <name>relievo::ExportDialog</name>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What the other program reads</source>
        <translation>Was das andere Programm liest</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>How much of the map is written</source>
        <translation>Wie viel der Karte geschrieben wird</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>In which coordinates and unit heights are written</source>
        <translation>In welchen Koordinaten und welcher Einheit Höhen geschrieben werden</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Where it is written</source>
        <translation>Wohin geschrieben wird</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>D&amp;urchsuchen…</translation>
    </message>
    <message>
        <source>Browse</source>
        <translation>Durchsuchen</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>&amp;Teil</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Cloud-optimised GeoTIFF (.tif)</source>
        <translation>Cloud-optimiertes GeoTIFF (.tif)</translation>
    </message>
    <message>
        <source>GeoTIFF that relievo opens again (.tif)</source>
        <translation>GeoTIFF, das relievo wieder öffnet (.tif)</translation>
    </message>
    <message>
        <source>Mesh for web viewers, glTF (.glb)</source>
        <translation>Netz für Webbetrachter, glTF (.glb)</translation>
    </message>
    <message>
        <source>Mesh, PLY (.ply)</source>
        <translation>Netz, PLY (.ply)</translation>
    </message>
    <message>
        <source>Plate to print, STL (.stl)</source>
        <translation>Platte zum Drucken, STL (.stl)</translation>
    </message>
    <message>
        <source>Points as text (.xyz)</source>
        <translation>Punkte als Text (.xyz)</translation>
    </message>
    <message>
        <source>ESRI ASCII grid (.asc)</source>
        <translation>ESRI-ASCII-Raster (.asc)</translation>
    </message>
    <message>
        <source>VTK image (.vti)</source>
        <translation>VTK-Bild (.vti)</translation>
    </message>
    <message>
        <source>Whole map</source>
        <translation>Ganze Karte</translation>
    </message>
    <message>
        <source>Window, 200 x 200 samples</source>
        <translation>Ausschnitt, 200 x 200 Stützstellen</translation>
    </message>
    <message>
        <source>Millimetres above the base plane</source>
        <translation>Millimeter über der Grundebene</translation>
    </message>
    <message>
        <source>Those of the file</source>
        <translation>Die der Datei</translation>
    </message>
    <message>
        <source>%1 x %2 cells, about %3</source>
        <translation>%1 x %2 Zellen, etwa %3</translation>
    </message>
    <message>
        <source>Coor&amp;dinates</source>
        <translation>&amp;Koordinaten</translation>
    </message>
    <message>
        <source>as long as its lines</source>
        <translation>so lang wie seine Linien</translation>
    </message>
    <message>
        <source>Whole map, resolution %1 of %2</source>
        <translation>Ganze Karte, Auflösung %1 von %2</translation>
    </message>
</context>
<context>
    <name>relievo::FalconStatusAnnouncer</name>
    <message>
        <source>Top arm found.</source>
        <translation>Oberer Arm gefunden.</translation>
    </message>
    <message>
        <source>Right arm found.</source>
        <translation>Rechter Arm gefunden.</translation>
    </message>
    <message>
        <source>Left arm found.</source>
        <translation>Linker Arm gefunden.</translation>
    </message>
    <message>
        <source>Touch &gt; Device set-up &gt; Firmware file takes one.</source>
        <translation>Unter Fühlen &gt; Gerät einrichten &gt; Firmware-Datei lässt sich eine angeben.</translation>
    </message>
</context>
<context>
    <name>relievo::FeelForm</name>
    <message>
        <source>S&amp;urface</source>
        <translation>Oberflä&amp;che</translation>
    </message>
    <message>
        <source>Sh&amp;ape</source>
        <translation>Fo&amp;rm</translation>
    </message>
    <message>
        <source>Prox&amp;y</source>
        <translation>Prox&amp;y</translation>
    </message>
    <message>
        <source>Stiff&amp;ness</source>
        <translation>S&amp;teifigkeit</translation>
    </message>
    <message>
        <source>Fr&amp;iction</source>
        <translation>Reib&amp;ung</translation>
    </message>
    <message>
        <source>Dam&amp;ping</source>
        <translation>Däm&amp;pfung</translation>
    </message>
    <message>
        <source>Not measure&amp;d</source>
        <translation>Nicht &amp;gemessen</translation>
    </message>
    <message>
        <source>Edge &amp;cue</source>
        <translation>&amp;Tastmarke am Rand</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtur</translation>
    </message>
    <message>
        <source>Co&amp;ntact impulse</source>
        <translation>Ko&amp;ntaktimpuls</translation>
    </message>
    <message>
        <source>Ma&amp;gnet</source>
        <translation>Ma&amp;gnet</translation>
    </message>
    <message>
        <source>How the surface feels</source>
        <translation>Wie sich die Oberfläche anfühlt</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>Wie im Aufsatz</translation>
    </message>
    <message>
        <source>Soft stone</source>
        <translation>Weicher Stein</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronze</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Sets shape, proxy, stiffness, friction and damping together. Each can be changed afterwards.</source>
        <translation>Setzt Form, Proxy, Steifigkeit, Reibung und Dämpfung zusammen. Jedes lässt sich danach ändern.</translation>
    </message>
    <message>
        <source>Shape of the surface between the samples</source>
        <translation>Form der Oberfläche zwischen den Stützstellen</translation>
    </message>
    <message>
        <source>Smooth with walls</source>
        <translation>Glatt, mit Wänden</translation>
    </message>
    <message>
        <source>Smooth everywhere</source>
        <translation>Überall glatt</translation>
    </message>
    <message>
        <source>Flat facets (exact)</source>
        <translation>Ebene Facetten (exakt)</translation>
    </message>
    <message>
        <source>The height samples are exact in each; only what lies between them differs.</source>
        <translation>Die Stützhöhen sind in jeder exakt; nur was dazwischen liegt, unterscheidet sich.</translation>
    </message>
    <message>
        <source>How the proxy follows the hand</source>
        <translation>Wie der Proxy der Hand folgt</translation>
    </message>
    <message>
        <source>Converged (exact)</source>
        <translation>Konvergiert (exakt)</translation>
    </message>
    <message>
        <source>As in the paper (eq. 2)</source>
        <translation>Wie im Aufsatz (Gl. 2)</translation>
    </message>
    <message>
        <source>Successive approximation (paper)</source>
        <translation>Schrittweise Näherung (Aufsatz)</translation>
    </message>
    <message>
        <source>The proxy is the point that stays on the surface.</source>
        <translation>Der Proxy ist der Punkt, der auf der Oberfläche bleibt.</translation>
    </message>
    <message>
        <source>Friction at rest, 0 to 1</source>
        <translation>Haftreibung, 0 bis 1</translation>
    </message>
    <message>
        <source>Force along the surface that holds the hand, as a part of the force against it; three quarters of it while sliding. The paper&apos;s proxies know none.</source>
        <translation>Kraft längs der Oberfläche, die die Hand hält, als Teil der Kraft dagegen; beim Gleiten drei Viertel davon. Die Proxys des Aufsatzes kennen keine.</translation>
    </message>
    <message>
        <source>Damping in newton seconds per metre</source>
        <translation>Dämpfung in Newtonsekunden je Meter</translation>
    </message>
    <message>
        <source> N s/m</source>
        <translation> N s/m</translation>
    </message>
    <message>
        <source>Against the speed of pressing in.</source>
        <translation>Gegen die Geschwindigkeit des Eindrückens.</translation>
    </message>
    <message>
        <source>as the &amp;level suggests</source>
        <translation>wie die Ebene empfieh&amp;lt</translation>
    </message>
    <message>
        <source>Stiffness as the level suggests</source>
        <translation>Steifigkeit, wie die Ebene empfiehlt</translation>
    </message>
    <message>
        <source>Stiffness in newtons per millimetre</source>
        <translation>Steifigkeit in Newton je Millimeter</translation>
    </message>
    <message>
        <source> N/mm</source>
        <translation> N/mm</translation>
    </message>
    <message>
        <source>Force per millimetre that the hand is pressed in.</source>
        <translation>Kraft je Millimeter, den die Hand eingedrückt ist.</translation>
    </message>
    <message>
        <source>Stiffness of ground that was not measured, in percent</source>
        <translation>Steifigkeit nicht gemessener Stellen, in Prozent</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How stiff filled gaps and the base plane are, as a part of the stiffness of measured ground. 100 %: no difference.</source>
        <translation>Wie steif gefüllte Lücken und die Grundebene sind, als Teil der Steifigkeit gemessener Stellen. 100 %: kein Unterschied.</translation>
    </message>
    <message>
        <source>Edge cue at the border of measured ground, in newtons</source>
        <translation>Tastmarke am Rand des Gemessenen, in Newton</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Texture of the next finer level, in micrometres of hand</source>
        <translation>Textur der nächstfeineren Ebene, in Mikrometern der Hand</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>How much of the next finer level is felt, at most, on top of the level that is touched. 0: none.</source>
        <translation>Wieviel von der nächstfeineren Ebene höchstens zusätzlich zur getasteten zu fühlen ist. 0: nichts.</translation>
    </message>
    <message>
        <source>Contact impulse, in newtons at most</source>
        <translation>Kontaktimpuls, höchstens in Newton</translation>
    </message>
    <message>
        <source>Pull toward the surface, in newtons at most</source>
        <translation>Zug zur Oberfläche, höchstens in Newton</translation>
    </message>
    <message>
        <source>A gentle pull that begins 3 mm above the surface and ends on it. 0: none.</source>
        <translation>Ein sanfter Zug, der 3 mm über der Oberfläche beginnt und auf ihr endet. 0: keiner.</translation>
    </message>
    <message>
        <source>0.8 N/mm at resolution 1 and 2, 0.6 at 3, 0.5 at finer ones. What is set here is then the shown level&apos;s own.</source>
        <translation>0,8 N/mm bei Auflösung 1 und 2, 0,6 bei 3, 0,5 bei feineren. Was hier gesetzt wird, gilt dann für die gezeigte Ebene.</translation>
    </message>
    <message>
        <source>A faint cue on the way from measured ground to other ground, and back. 0: none.</source>
        <translation>Ein schwacher Hinweis beim Übergang vom Gemessenen zu anderem und zurück. 0: keiner.</translation>
    </message>
    <message>
        <source>A short impulse as hard as the hand comes. 0: none.</source>
        <translation>Ein kurzer Impuls, so stark wie die Hand kommt. 0: keiner.</translation>
    </message>
</context>
<context>
    <name>relievo::FeltPatterns</name>
    <message>
        <source>Felt patterns on: one tap is yes, two not measured, three the edge.</source>
        <translation>Tastzeichen an: ein Stoß ist ja, zwei nicht gemessen, drei der Rand.</translation>
    </message>
    <message>
        <source>Felt patterns off.</source>
        <translation>Tastzeichen aus.</translation>
    </message>
</context>
<context>
    <name>relievo::FigureDialog</name>
    <message>
        <source>There is not enough memory for this figure. Nothing was written.</source>
        <translation>Der Speicher reicht für diese Abbildung nicht. Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>Anha&amp;lten</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Preview of the figure</source>
        <translation>Vorschau der Abbildung</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Bildunterschrift</translation>
    </message>
    <message>
        <source>The text that belongs under this figure</source>
        <translation>Der Text, der unter diese Abbildung gehört</translation>
    </message>
    <message>
        <source>Cop&amp;y caption</source>
        <translation>Te&amp;xt kopieren</translation>
    </message>
    <message>
        <source>Copy caption</source>
        <translation>Bildunterschrift kopieren</translation>
    </message>
    <message>
        <source>Put the caption into the clipboard</source>
        <translation>Die Bildunterschrift in die Zwischenablage legen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>%1 × %2 mm on paper, %3 × %4 pixels, scale 1 : %5</source>
        <translation>%1 × %2 mm auf Papier, %3 × %4 Pixel, Maßstab 1 : %5</translation>
    </message>
    <message>
        <source>. Parallax %1° of %2° with %3° between the eyes</source>
        <translation>. Parallaxe %1° von %2° bei %3° zwischen den Augen</translation>
    </message>
    <message>
        <source>Stopped. Nothing was written.</source>
        <translation>Abgebrochen. Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>There is no folder %1. Nothing was written. Choose another, or make it.</source>
        <translation>Den Ordner %1 gibt es nicht. Nichts wurde geschrieben. Wählen Sie einen anderen, oder legen Sie ihn an.</translation>
    </message>
    <message>
        <source>Replace figure</source>
        <translation>Abbildung ersetzen</translation>
    </message>
    <message>
        <source>%1 exists already in %2. Replace it?</source>
        <translation>%1 gibt es schon in %2. Ersetzen?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>These files exist already. Replace them?</source>
        <translation>Diese Dateien gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Stopped. Only this was written: %1.</source>
        <translation>Abgebrochen. Nur dies wurde geschrieben: %1.</translation>
    </message>
    <message>
        <source>Stop the work; no further file is written</source>
        <translation>Die Arbeit anhalten; keine weitere Datei wird geschrieben</translation>
    </message>
</context>
<context>
    <name>relievo::FigureForm</name>
    <message>
        <source>Browse: %1</source>
        <translation>Durchsuchen: %1</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>Shaded relief</source>
        <translation>Beleuchtetes Relief</translation>
    </message>
    <message>
        <source>Height in colour</source>
        <translation>Höhe in Farbe</translation>
    </message>
    <message>
        <source>Hillshade</source>
        <translation>Schummerung</translation>
    </message>
    <message>
        <source>Hillshade, four lights</source>
        <translation>Schummerung, vier Lichter</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Local relief</source>
        <translation>Lokales Relief</translation>
    </message>
    <message>
        <source>Sky-view factor</source>
        <translation>Himmelssichtfaktor</translation>
    </message>
    <message>
        <source>Openness</source>
        <translation>Offenheit</translation>
    </message>
    <message>
        <source>Deviation, several scales</source>
        <translation>Abweichung, mehrere Maßstäbe</translation>
    </message>
    <message>
        <source>Curvature, several scales</source>
        <translation>Krümmung, mehrere Maßstäbe</translation>
    </message>
    <message>
        <source>Natural colours</source>
        <translation>Natürliche Farben</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Rel&amp;ief</source>
        <translation>R&amp;elief</translation>
    </message>
    <message>
        <source>How heights are painted</source>
        <translation>Wie Höhen dargestellt werden</translation>
    </message>
    <message>
        <source>This scan has none</source>
        <translation>Dieser Scan hat keine</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Even steps of lightness, also for colour-blind readers</source>
        <translation>Gleichmäßige Helligkeitsstufen, auch für Farbenblinde</translation>
    </message>
    <message>
        <source>Light from</source>
        <translation>Licht von</translation>
    </message>
    <message>
        <source>0 is above, clockwise; 315 is the upper left</source>
        <translation>0 ist oben, im Uhrzeigersinn; 315 ist links oben</translation>
    </message>
    <message>
        <source>Light&apos;s height</source>
        <translation>Lichthöhe</translation>
    </message>
    <message>
        <source>Low light brings out worn detail</source>
        <translation>Streiflicht zeigt abgenutzte Einzelheiten</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Of the neighbourhood that this relief image looks at</source>
        <translation>Der Nachbarschaft, die dieses Reliefbild betrachtet</translation>
    </message>
    <message>
        <source>10 samples</source>
        <translation>10 Stützstellen</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>How much relief shading natural colours and intensity get</source>
        <translation>Wie stark natürliche Farben und Intensität schattiert werden</translation>
    </message>
    <message>
        <source>O&amp;wn ends of the colours</source>
        <translation>Fa&amp;rbgrenzen vorgeben</translation>
    </message>
    <message>
        <source>The same colours for the same values in several figures; otherwise they follow from what is shown</source>
        <translation>Gleiche Farben für gleiche Werte in mehreren Abbildungen; sonst ergeben sie sich aus dem Gezeigten</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Farben von</translation>
    </message>
    <message>
        <source>Value at the colours&apos; lower end</source>
        <translation>Wert am unteren Ende der Farben</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>Farben bis</translation>
    </message>
    <message>
        <source>Value at the colours&apos; upper end</source>
        <translation>Wert am oberen Ende der Farben</translation>
    </message>
    <message>
        <source>Its colours are the scan&apos;s own</source>
        <translation>Seine Farben sind die des Scans</translation>
    </message>
    <message>
        <source>Turn on &quot;Own ends of the colours&quot; first</source>
        <translation>Zuerst „Farbgrenzen vorgeben“ einschalten</translation>
    </message>
    <message>
        <source>No lamp shines on this relief</source>
        <translation>Auf dieses Relief scheint kein Licht</translation>
    </message>
    <message>
        <source>The four lights come from all sides</source>
        <translation>Die vier Lichter kommen von allen Seiten</translation>
    </message>
    <message>
        <source>This relief does not depend on one</source>
        <translation>Dieses Relief hängt von keinem ab</translation>
    </message>
    <message>
        <source>Only natural colours and intensity are mixed with it</source>
        <translation>Nur natürliche Farben und Intensität werden damit gemischt</translation>
    </message>
    <message>
        <source>Detail alone</source>
        <translation>Detail allein</translation>
    </message>
    <message>
        <source>Whole object and detail</source>
        <translation>Ganzes Objekt und Detail</translation>
    </message>
    <message>
        <source>As measured and filled</source>
        <translation>Wie gemessen und gefüllt</translation>
    </message>
    <message>
        <source>Several levels</source>
        <translation>Mehrere Ebenen</translation>
    </message>
    <message>
        <source>With force plots of a recording</source>
        <translation>Mit Kraftkurven einer Aufzeichnung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>Date&amp;i</translation>
    </message>
    <message>
        <source>Ends in .png, .tif, .pdf or .svg</source>
        <translation>Endet mit .png, .tif, .pdf oder .svg</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>Abbildung speichern</translation>
    </message>
    <message>
        <source>Figures (*.png *.tif *.pdf *.svg)</source>
        <translation>Abbildungen (*.png *.tif *.pdf *.svg)</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>An&amp;ordnung</translation>
    </message>
    <message>
        <source>What stands beside what</source>
        <translation>Was neben was steht</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>Au&amp;fzeichnung</translation>
    </message>
    <message>
        <source>File of a recording, CSV or HDF5, for the plots</source>
        <translation>Datei einer Aufzeichnung, CSV oder HDF5, für die Kurven</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.h5 *.hdf5)</source>
        <translation>Aufzeichnungen (*.csv *.h5 *.hdf5)</translation>
    </message>
    <message>
        <source>Wi&amp;dth on paper</source>
        <translation>Breite auf &amp;Papier</translation>
    </message>
    <message>
        <source>Journals have columns of 85 and pages of 180 mm</source>
        <translation>Zeitschriften haben Spalten von 85 und Seiten von 180 mm</translation>
    </message>
    <message>
        <source>To &amp;scale</source>
        <translation>Maßst&amp;äblich</translation>
    </message>
    <message>
        <source>Choose the scale of the detail; the width follows from it</source>
        <translation>Den Maßstab des Details wählen; die Breite folgt daraus</translation>
    </message>
    <message>
        <source>Scale &amp;1 :</source>
        <translation>&amp;Maßstab 1 :</translation>
    </message>
    <message>
        <source>Millimetres of object on one millimetre of paper</source>
        <translation>Millimeter des Objekts auf einem Millimeter Papier</translation>
    </message>
    <message>
        <source>D&amp;ensity</source>
        <translation>A&amp;uflösung</translation>
    </message>
    <message>
        <source>Dots per inch of paper</source>
        <translation>Punkte je Zoll Papier</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>S&amp;chriftgröße</translation>
    </message>
    <message>
        <source>Text and bars on paper, in points</source>
        <translation>Schrift und Skalen auf Papier, in Punkt</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Turn on &quot;To scale&quot; first</source>
        <translation>Zuerst „Maßstäblich“ einschalten</translation>
    </message>
    <message>
        <source>It follows from the scale</source>
        <translation>Sie folgt aus dem Maßstab</translation>
    </message>
    <message>
        <source>Only the layout with force plots shows one</source>
        <translation>Nur die Anordnung mit Kraftkurven zeigt eine</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>Maßsta&amp;b</translation>
    </message>
    <message>
        <source>&amp;Height bar</source>
        <translation>Höhens&amp;kala</translation>
    </message>
    <message>
        <source>&amp;Up mark</source>
        <translation>&amp;Zeiger nach oben</translation>
    </message>
    <message>
        <source>Window&apos;s &amp;outline</source>
        <translation>Umriss &amp;des Ausschnitts</translation>
    </message>
    <message>
        <source>Hat&amp;ch</source>
        <translation>&amp;Schraffur</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>Le&amp;gende</translation>
    </message>
    <message>
        <source>Letters a, b</source>
        <translation>Buchstaben a, b</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>Messu&amp;ngen</translation>
    </message>
    <message>
        <source>Drawn in points, whatever the density</source>
        <translation>In Punkt gezeichnet, unabhängig von der Auflösung</translation>
    </message>
    <message>
        <source>Tra&amp;nsparent paper</source>
        <translation>Ohne &amp;weißen Grund</translation>
    </message>
    <message>
        <source>No white behind the relief</source>
        <translation>Kein Weiß hinter dem Relief</translation>
    </message>
    <message>
        <source>It is drawn on the whole object, which this layout lacks</source>
        <translation>Er wird auf das ganze Objekt gezeichnet, das dieser Anordnung fehlt</translation>
    </message>
    <message>
        <source>An anaglyph needs its background</source>
        <translation>Eine Anaglyphe braucht ihren Hintergrund</translation>
    </message>
    <message>
        <source>Both eyes &amp;as files</source>
        <translation>Beide &amp;Augen als Dateien</translation>
    </message>
    <message>
        <source>Also write the detail as each eye sees it, as NAME.left.png and NAME.right.png beside the figure</source>
        <translation>Auch das Detail schreiben, wie jedes Auge es sieht, als NAME.left.png und NAME.right.png neben der Abbildung</translation>
    </message>
    <message>
        <source>Sa&amp;ve heights too</source>
        <translation>H&amp;öhen auch speichern</translation>
    </message>
    <message>
        <source>Also write the detail&apos;s heights as a picture of 16 bits; its description says millimetres per step</source>
        <translation>Auch die Höhen des Details als Bild mit 16 Bit schreiben; seine Beschreibung nennt Millimeter je Stufe</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Ends in .tif</source>
        <translation>Endet mit .tif</translation>
    </message>
    <message>
        <source>Save heights</source>
        <translation>Höhen speichern</translation>
    </message>
    <message>
        <source>Heights of 16 bits (*.tif *.tiff)</source>
        <translation>Höhen mit 16 Bit (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>Save caption as te&amp;xt</source>
        <translation>Unterschrift als &amp;Text speichern</translation>
    </message>
    <message>
        <source>Also write the caption as a text file</source>
        <translation>Auch die Bildunterschrift als Textdatei schreiben</translation>
    </message>
    <message>
        <source>Caption&apos;s file</source>
        <translation>Textdatei</translation>
    </message>
    <message>
        <source>Where the caption is written</source>
        <translation>Wohin die Bildunterschrift geschrieben wird</translation>
    </message>
    <message>
        <source>Save caption</source>
        <translation>Bildunterschrift speichern</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>Turn on &quot;Save heights too&quot; first</source>
        <translation>Zuerst „Höhen auch speichern“ einschalten</translation>
    </message>
    <message>
        <source>Turn on &quot;Save caption as text&quot; first</source>
        <translation>Zuerst „Unterschrift als Text speichern“ einschalten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Anaglyph, grey</source>
        <translation>Anaglyphe, grau</translation>
    </message>
    <message>
        <source>Anaglyph, half colour</source>
        <translation>Anaglyphe, halbfarbig</translation>
    </message>
    <message>
        <source>Anaglyph, Dubois</source>
        <translation>Anaglyphe, Dubois</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>One over the other</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>For red and cyan glasses, or two pictures</source>
        <translation>Für rot-cyane Brillen, oder zwei Bilder</translation>
    </message>
    <message>
        <source>Eyes apart</source>
        <translation>Augenabstand</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions</source>
        <translation>Winkel zwischen den Blickrichtungen beider Augen</translation>
    </message>
    <message>
        <source>&amp;Keep to 1° of parallax</source>
        <translation>&amp;Höchstens 1° Parallaxe</translation>
    </message>
    <message>
        <source>Less angle where many readers would see double</source>
        <translation>Weniger Winkel, wo viele Leser doppelt sähen</translation>
    </message>
    <message>
        <source>Own &amp;zero plane</source>
        <translation>Nullebene &amp;vorgeben</translation>
    </message>
    <message>
        <source>Choose the height that lies in the plane of the paper; otherwise it is mid height</source>
        <translation>Die Höhe wählen, die in der Ebene des Papiers liegt; sonst ist es die mittlere Höhe</translation>
    </message>
    <message>
        <source>Zero plane</source>
        <translation>Nullebene</translation>
    </message>
    <message>
        <source>Height of zero parallax: what is higher stands out of the paper, what is lower lies behind it</source>
        <translation>Höhe ohne Parallaxe: was höher ist, steht aus dem Papier heraus, was tiefer ist, liegt dahinter</translation>
    </message>
    <message>
        <source>Swap eyes</source>
        <translation>Augen tauschen</translation>
    </message>
    <message>
        <source>For glasses the other way round, or for crossed eyes</source>
        <translation>Für umgekehrte Brillen oder gekreuzte Augen</translation>
    </message>
    <message>
        <source>Choose a kind of stereo, or both eyes as files</source>
        <translation>Eine Art von Stereo wählen, oder beide Augen als Dateien</translation>
    </message>
    <message>
        <source>Turn on &quot;Own zero plane&quot; first</source>
        <translation>Zuerst „Nullebene vorgeben“ einschalten</translation>
    </message>
    <message>
        <source>Shaded, with ambient occlusion</source>
        <translation>Beleuchtet, mit Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Shaded reliefs and hillshades have no colours</source>
        <translation>Beleuchtete Reliefs und Schummerungen haben keine Farben</translation>
    </message>
</context>
<context>
    <name>relievo::FirmnessRow</name>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>No&amp;ne</source>
        <translation>Ke&amp;ines</translation>
    </message>
    <message>
        <source>Stiffness &amp;map</source>
        <translation>St&amp;eifigkeitskarte</translation>
    </message>
    <message>
        <source>Stiffness map</source>
        <translation>Steifigkeitskarte</translation>
    </message>
    <message>
        <source>Rasters (*.tif *.tiff *.asc *.png);;All files (*)</source>
        <translation>Raster (*.tif *.tiff *.asc *.png);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>where it was measured</source>
        <translation>wo gemessen wurde</translation>
    </message>
    <message>
        <source>%1 (not of this map)</source>
        <translation>%1 (nicht von dieser Karte)</translation>
    </message>
    <message>
        <source>Stiffness map in use</source>
        <translation>Benutzte Steifigkeitskarte</translation>
    </message>
    <message>
        <source>Choose a stiffness map</source>
        <translation>Eine Steifigkeitskarte wählen</translation>
    </message>
    <message>
        <source>A raster over the whole map: 1 where the surface is stiff, 0 where it is as soft as set above. In place of where it was measured.</source>
        <translation>Ein Raster über die ganze Karte: 1, wo die Oberfläche steif ist, 0, wo sie so weich ist wie oben eingestellt. Anstelle davon, wo gemessen wurde.</translation>
    </message>
    <message>
        <source>No stiffness map: stiff where it was measured</source>
        <translation>Keine Steifigkeitskarte: steif, wo gemessen wurde</translation>
    </message>
    <message>
        <source>The surface is stiff where it was measured.</source>
        <translation>Die Oberfläche ist steif, wo gemessen wurde.</translation>
    </message>
</context>
<context>
    <name>relievo::FirstViewCard</name>
    <message>
        <source>First view of the file that is being read</source>
        <translation>Erste Ansicht der Datei, die gelesen wird</translation>
    </message>
    <message>
        <source>%1: first view from %2 of %3 points. The whole is being read.</source>
        <translation>%1: erste Ansicht aus %2 von %3 Punkten. Das Ganze wird gelesen.</translation>
    </message>
    <message>
        <source>Until then the views and the hand stay with the object before.</source>
        <translation>Bis dahin bleiben Ansichten und Hand beim bisherigen Objekt.</translation>
    </message>
    <message>
        <source>It can be touched then.</source>
        <translation>Dann kann es ertastet werden.</translation>
    </message>
</context>
<context>
    <name>relievo::ForceReturn</name>
    <message>
        <source>The device can push again. Lift the hand and press F5, or hold its button Centre: the forces rise from zero.</source>
        <translation>Das Gerät kann wieder drücken. Die Hand anheben und F5 drücken oder seine Taste Mitte halten: Die Kräfte steigen von null an.</translation>
    </message>
    <message>
        <source>Lift the hand and press F5: the device is opened anew, and its forces rise from zero.</source>
        <translation>Die Hand anheben und F5 drücken: Das Gerät wird neu geöffnet, und seine Kräfte steigen von null an.</translation>
    </message>
    <message>
        <source>Shift+F5 opens the chosen device again and takes its forces back.</source>
        <translation>Umschalt+F5 öffnet das gewählte Gerät wieder und holt seine Kräfte zurück.</translation>
    </message>
</context>
<context>
    <name>relievo::ForeignFiles</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Files elsewhere</source>
        <translation>Dateien anderswo</translation>
    </message>
    <message numerus="yes">
        <source>%1 names %n file(s) outside of its folder that are not, by their checksums, what it was made from:</source>
        <translation>
            <numerusform>%1 nennt %n Datei außerhalb seines Ordners, die nach ihrer Prüfsumme nicht die ist, aus der es gemacht wurde:</numerusform>
            <numerusform>%1 nennt %n Dateien außerhalb seines Ordners, die nach ihren Prüfsummen nicht die sind, aus denen es gemacht wurde:</numerusform>
        </translation>
    </message>
    <message>
        <source>The work that was kept</source>
        <translation>Die aufbewahrte Arbeit</translation>
    </message>
    <message>
        <source>Whoever made it chose these names. Shall they be read? What is not read stays named in it, and all else opens.</source>
        <translation>Wer es gemacht hat, hat diese Namen gewählt. Sollen sie gelesen werden? Was nicht gelesen wird, bleibt darin genannt, und alles andere wird geöffnet.</translation>
    </message>
    <message>
        <source>&amp;Read them</source>
        <translation>&amp;Lesen</translation>
    </message>
    <message>
        <source>&amp;Do not read them</source>
        <translation>&amp;Nicht lesen</translation>
    </message>
</context>
<context>
    <name>relievo::GlassesDialog</name>
    <message>
        <source>Test picture</source>
        <translation>Testbild</translation>
    </message>
    <message>
        <source>Left an L for the left eye alone, right an R for the right eye alone</source>
        <translation>Links ein L nur für das linke Auge, rechts ein R nur für das rechte Auge</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left eye</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right eye</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>Test glasses</source>
        <translation>Brille prüfen</translation>
    </message>
    <message>
        <source>Put the glasses on and close your right eye: you should see only the L, bright on black. With the left eye closed only the R. If it is the other way round, turn on &quot;Swap eyes&quot;. What shines through faintly is a ghost; Dubois has the least.</source>
        <translation>Setzen Sie die Brille auf und schließen Sie das rechte Auge: Sie sollten nur das L sehen, hell auf schwarz. Mit geschlossenem linkem Auge nur das R. Ist es umgekehrt, schalten Sie „Augen tauschen“ ein. Was schwach durchscheint, ist ein Geisterbild; Dubois hat davon am wenigsten.</translation>
    </message>
</context>
<context>
    <name>relievo::GuideControl</name>
    <message>
        <source>Guide along a recording</source>
        <translation>Wie in einer Aufnahme führen</translation>
    </message>
    <message>
        <source>Recordings and strokes (*.csv *.h5 *.hdf5)</source>
        <translation>Aufnahmen und Handwege (*.csv *.h5 *.hdf5)</translation>
    </message>
    <message>
        <source>A recording is running. The introduction lays shapes under the hand that are not of this relief. End the recording first.</source>
        <translation>Es läuft eine Aufnahme. Die Einführung legt Formen unter die Hand, die nicht zu diesem Relief gehören. Beenden Sie zuerst die Aufnahme.</translation>
    </message>
    <message>
        <source>The introduction is not recorded. End it first.</source>
        <translation>Die Einführung wird nicht aufgezeichnet. Beenden Sie sie zuerst.</translation>
    </message>
</context>
<context>
    <name>relievo::HandDevice</name>
    <message>
        <source>The device %1 is being opened. The mouse is the hand meanwhile.</source>
        <translation>Das Gerät %1 wird geöffnet. Solange ist die Maus die Hand.</translation>
    </message>
    <message>
        <source>Device: %1.</source>
        <translation>Gerät: %1.</translation>
    </message>
    <message>
        <source>%1 The mouse is the hand now.</source>
        <translation>%1 Jetzt ist die Maus die Hand.</translation>
    </message>
    <message>
        <source>Motors: %1 % of what they can take for good; forces stay below %2 N.</source>
        <translation>Motoren: %1 % dessen, was sie auf Dauer vertragen; Kräfte bleiben unter %2 N.</translation>
    </message>
    <message>
        <source>A Falcon was plugged in. Choose it in the panel Touch to use it.</source>
        <translation>Ein Falcon wurde eingesteckt. Wählen Sie ihn im Feld Fühlen, um ihn zu benutzen.</translation>
    </message>
</context>
<context>
    <name>relievo::HaplySetupDialog</name>
    <message>
        <source>Device set-up: Haply</source>
        <translation>Gerät einrichten: Haply</translation>
    </message>
    <message>
        <source>State of the Haply device</source>
        <translation>Zustand des Haply-Geräts</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service is being looked for.</source>
        <translation>Haplys Inverse Service wird gesucht.</translation>
    </message>
    <message>
        <source>What the service told last</source>
        <translation>Was der Dienst zuletzt gemeldet hat</translation>
    </message>
    <message>
        <source>Which Haply device</source>
        <translation>Welches Haply-Gerät</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>G&amp;erät</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Noch einmal</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>After another program set the device up, or the service did not obey forces</source>
        <translation>Nachdem ein anderes Programm das Gerät eingerichtet hat oder der Dienst Kräfte nicht befolgt hat</translation>
    </message>
    <message>
        <source>&amp;Use this device</source>
        <translation>Dieses Gerät &amp;benutzen</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>Dieses Gerät benutzen</translation>
    </message>
    <message>
        <source>Set up a &amp;Falcon…</source>
        <translation>Einen &amp;Falcon einrichten …</translation>
    </message>
    <message>
        <source>Set up a Falcon</source>
        <translation>Einen Falcon einrichten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>relievo::HaplySteps</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Inverse Service runs</source>
        <translation>Inverse Service läuft</translation>
    </message>
    <message>
        <source>Device is plugged in</source>
        <translation>Gerät ist eingesteckt</translation>
    </message>
    <message>
        <source>Motors have power</source>
        <translation>Motoren haben Strom</translation>
    </message>
    <message>
        <source>Service has started it</source>
        <translation>Der Dienst hat es gestartet</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Kalibriert</translation>
    </message>
    <message>
        <source>Set up for touching</source>
        <translation>Zum Fühlen eingerichtet</translation>
    </message>
    <message>
        <source>Place of the hand</source>
        <translation>Ort der Hand</translation>
    </message>
    <message>
        <source>Buttons that are pressed</source>
        <translation>Gedrückte Tasten</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Knöpfe am Gerät</translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation>✓ erledigt</translation>
    </message>
    <message>
        <source>– waits for this</source>
        <translation>– darauf wird gewartet</translation>
    </message>
    <message>
        <source>– not known yet</source>
        <translation>– noch nicht bekannt</translation>
    </message>
    <message>
        <source>%1 right, %2 up, %3 out, in millimetres; %4 answers per second</source>
        <translation>%1 nach rechts, %2 nach oben, %3 nach vorn, in Millimetern; %4 Antworten je Sekunde</translation>
    </message>
    <message>
        <source>not known before the device is there</source>
        <translation>nicht bekannt, bevor das Gerät da ist</translation>
    </message>
    <message>
        <source>Plus</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Minus</source>
        <translation>Minus</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>relievo::HapticsPanel</name>
    <message>
        <source>Off: %1. Switch off and on to try again.</source>
        <translation>Aus: %1. Zum neuen Versuch aus- und einschalten.</translation>
    </message>
    <message>
        <source>Off. Press F5 to switch forces on.</source>
        <translation>Aus. F5 schaltet die Kräfte ein.</translation>
    </message>
    <message>
        <source>Waiting until the hand is clear of the surface.</source>
        <translation>Warten, bis die Hand von der Oberfläche frei ist.</translation>
    </message>
    <message>
        <source>Coming on.</source>
        <translation>Wird eingeschaltet.</translation>
    </message>
    <message>
        <source>On, softened to %1 N/mm against swinging until switched off.</source>
        <translation>An, gegen Schwingen auf %1 N/mm verringert, bis zum Ausschalten.</translation>
    </message>
    <message>
        <source>On.</source>
        <translation>An.</translation>
    </message>
    <message>
        <source>On: computed and shown; a mouse cannot push back.</source>
        <translation>An: berechnet und gezeigt; eine Maus kann nicht zurückdrücken.</translation>
    </message>
    <message>
        <source>Forces &amp;on</source>
        <translation>&amp;Kräfte an</translation>
    </message>
    <message>
        <source>Forces on</source>
        <translation>Kräfte an</translation>
    </message>
    <message>
        <source>Switch forces on or off (F5). Esc switches them off.</source>
        <translation>Kräfte ein- oder ausschalten (F5). Esc schaltet sie aus.</translation>
    </message>
    <message>
        <source>State of the forces</source>
        <translation>Zustand der Kräfte</translation>
    </message>
    <message>
        <source>On. E306: Update rate fell to %1 per second (need %2). Stiffness reduced from %3 to %4 N/m.</source>
        <translation>An. E306: Die Rate ist auf %1 pro Sekunde gefallen (nötig: %2). Steifigkeit von %3 auf %4 N/m verringert.</translation>
    </message>
    <message>
        <source>A new surface under the hand</source>
        <translation>Eine neue Oberfläche unter der Hand</translation>
    </message>
    <message>
        <source>The new surface comes under the hand: %1 %.</source>
        <translation>Die neue Oberfläche kommt unter die Hand: %1 %.</translation>
    </message>
    <message>
        <source>Off: %1. %2</source>
        <translation>Aus: %1. %2</translation>
    </message>
    <message>
        <source>Take the forces bac&amp;k</source>
        <translation>Kräfte zurückh&amp;olen</translation>
    </message>
    <message>
        <source>Take the forces back</source>
        <translation>Kräfte zurückholen</translation>
    </message>
    <message>
        <source>Opens the device again (Shift+F5). Its forces rise from zero once the hand is clear.</source>
        <translation>Öffnet das Gerät wieder (Umschalt+F5). Seine Kräfte steigen von null an, sobald die Hand frei ist.</translation>
    </message>
</context>
<context>
    <name>relievo::HapticsPlugin</name>
    <message>
        <source>Touch</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>Nothing to touch yet. Open a scan first.</source>
        <translation>Noch nichts zu fühlen. Öffnen Sie zuerst einen Scan.</translation>
    </message>
    <message>
        <source>Forces on.</source>
        <translation>Kräfte an.</translation>
    </message>
    <message>
        <source>Forces off.</source>
        <translation>Kräfte aus.</translation>
    </message>
    <message>
        <source>Strength %1 percent.</source>
        <translation>Stärke %1 Prozent.</translation>
    </message>
    <message>
        <source>Forces are off after the sleep. Press F5 to switch them on.</source>
        <translation>Die Kräfte sind nach dem Ruhezustand aus. F5 schaltet sie ein.</translation>
    </message>
    <message>
        <source>Touch: advanced</source>
        <translation>Fühlen: erweitert</translation>
    </message>
    <message>
        <source>Strength: %1.</source>
        <translation>Stärke: %1.</translation>
    </message>
    <message>
        <source>Grip position: %1.</source>
        <translation>Griffposition: %1.</translation>
    </message>
</context>
<context>
    <name>relievo::HeightHistogram</name>
    <message>
        <source>Heights of measured cells</source>
        <translation>Höhen der gemessenen Zellen</translation>
    </message>
    <message>
        <source>From %1 to %2 mm</source>
        <translation>Von %1 bis %2 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>relievo::HomingPicture</name>
    <message>
        <source>What to do with the grip</source>
        <translation>Was mit dem Griff zu tun ist</translation>
    </message>
    <message>
        <source>Push the grip all the way in. The light is red.</source>
        <translation>Drücken Sie den Griff ganz hinein. Das Licht ist rot.</translation>
    </message>
    <message>
        <source>Pull the grip all the way out. The light is blue.</source>
        <translation>Ziehen Sie den Griff ganz heraus. Das Licht ist blau.</translation>
    </message>
    <message>
        <source>The grip&apos;s place is known. The light is blue.</source>
        <translation>Der Ort des Griffs ist bekannt. Das Licht ist blau.</translation>
    </message>
    <message>
        <source>Nothing to do with the grip yet.</source>
        <translation>Mit dem Griff ist noch nichts zu tun.</translation>
    </message>
</context>
<context>
    <name>relievo::ImageDialog</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Bild von</translation>
    </message>
    <message>
        <source>What the picture shows</source>
        <translation>Was das Bild zeigt</translation>
    </message>
    <message>
        <source>Detail view</source>
        <translation>Detailansicht</translation>
    </message>
    <message>
        <source>Whole window</source>
        <translation>Ganzes Fenster</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Where the picture is saved</source>
        <translation>Wo das Bild gespeichert wird</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>D&amp;urchsuchen…</translation>
    </message>
    <message>
        <source>Browse</source>
        <translation>Durchsuchen</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>&amp;Picture of</source>
        <translation>&amp;Bild von</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Both &amp;eyes as files</source>
        <translation>Beide &amp;Augen als Dateien</translation>
    </message>
    <message>
        <source>Also each eye&apos;s picture of the detail, as NAME.left.png and NAME.right.png</source>
        <translation>Auch das Bild jedes Auges vom Detail, als NAME.left.png und NAME.right.png</translation>
    </message>
</context>
<context>
    <name>relievo::KeysSheet</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Stop forces, then cancel, then leave the mode</source>
        <translation>Kräfte anhalten, dann abbrechen, dann den Modus verlassen</translation>
    </message>
    <message>
        <source>Detail view: arrows, Shift+arrows</source>
        <translation>Detailansicht: Pfeile, Umschalt+Pfeile</translation>
    </message>
    <message>
        <source>Move the hand by 1 or by 10 cells</source>
        <translation>Die Hand um 1 oder um 10 Zellen bewegen</translation>
    </message>
    <message>
        <source>Detail view: Page Down, Page Up</source>
        <translation>Detailansicht: Bild ab, Bild auf</translation>
    </message>
    <message>
        <source>Press in, lift</source>
        <translation>Eindrücken, anheben</translation>
    </message>
    <message>
        <source>Detail view: left button</source>
        <translation>Detailansicht: linke Maustaste</translation>
    </message>
    <message>
        <source>Detail view: Ctrl+wheel</source>
        <translation>Detailansicht: Strg+Rad</translation>
    </message>
    <message>
        <source>Change the press depth</source>
        <translation>Die Eindrücktiefe ändern</translation>
    </message>
    <message>
        <source>Detail view: wheel</source>
        <translation>Detailansicht: Rad</translation>
    </message>
    <message>
        <source>Draw, move or resize the window</source>
        <translation>Den Ausschnitt zeichnen, verschieben oder in der Größe ändern</translation>
    </message>
    <message>
        <source>Move, resize the window</source>
        <translation>Den Ausschnitt verschieben, in der Größe ändern</translation>
    </message>
    <message>
        <source>Draw a window</source>
        <translation>Einen Ausschnitt zeichnen</translation>
    </message>
    <message>
        <source>Finer, coarser</source>
        <translation>Feiner, gröber</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>Was sie tun</translation>
    </message>
    <message>
        <source>Other commands</source>
        <translation>Andere Befehle</translation>
    </message>
    <message>
        <source>In the views, by mouse and keys</source>
        <translation>In den Ansichten, mit Maus und Tasten</translation>
    </message>
    <message>
        <source>Search keys</source>
        <translation>Tasten suchen</translation>
    </message>
    <message>
        <source>Words of what a key does, or the key itself</source>
        <translation>Wörter dessen, was eine Taste tut, oder die Taste selbst</translation>
    </message>
    <message>
        <source>No key has these words. Ctrl+K finds commands without a key, too.</source>
        <translation>Keine Taste hat diese Wörter. Strg+K findet auch Befehle ohne Taste.</translation>
    </message>
    <message>
        <source>Look: %1. Touch: %2</source>
        <translation>Betrachten: %1. Fühlen: %2</translation>
    </message>
    <message>
        <source>press the hand in</source>
        <translation>die Hand eindrücken</translation>
    </message>
    <message>
        <source>Detail view: middle button</source>
        <translation>Detailansicht: mittlere Maustaste</translation>
    </message>
    <message>
        <source>Detail view: right button</source>
        <translation>Detailansicht: rechte Maustaste</translation>
    </message>
    <message>
        <source>Zoom about the pointer; away from you is closer</source>
        <translation>Um den Zeiger vergrößern; von Ihnen weg ist näher</translation>
    </message>
    <message>
        <source>Zoom about the pointer; towards you is closer</source>
        <translation>Um den Zeiger vergrößern; zu Ihnen hin ist näher</translation>
    </message>
    <message>
        <source>Overview: drag</source>
        <translation>Übersicht: Ziehen</translation>
    </message>
    <message>
        <source>Overview: arrows, Shift+arrows</source>
        <translation>Übersicht: Pfeile, Umschalt+Pfeile</translation>
    </message>
    <message>
        <source>Overview: Space, arrows, Enter</source>
        <translation>Übersicht: Leertaste, Pfeile, Eingabe</translation>
    </message>
    <message>
        <source>Overview: +, −, wheel</source>
        <translation>Übersicht: +, −, Rad</translation>
    </message>
</context>
<context>
    <name>relievo::LightBall</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Drag to move the light: the rim is raking light, the middle is light from you. Arrows move it by 5 degrees</source>
        <translation>Ziehen bewegt das Licht: Am Rand ist Streiflicht, in der Mitte Licht von Ihnen her. Pfeile bewegen es um 5 Grad</translation>
    </message>
    <message>
        <source>Light from %1°, %2° high</source>
        <translation>Licht aus %1°, %2° hoch</translation>
    </message>
</context>
<context>
    <name>relievo::LookController</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Shading of colours</source>
        <translation>Schattierung der Farben</translation>
    </message>
    <message>
        <source>Relief image</source>
        <translation>Reliefbild</translation>
    </message>
    <message>
        <source>Unmeasured cells</source>
        <translation>Nicht gemessene Zellen</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>%1. This relief image has no lamp: the light shows in others.</source>
        <translation>%1. Dieses Reliefbild hat keine Lampe: Das Licht zeigt sich in anderen.</translation>
    </message>
    <message>
        <source>%1 % of this picture is a strong red or cyan, which one eye sees dark through the glasses. Grey stereo shows it to both</source>
        <translation>%1 % dieses Bildes sind ein kräftiges Rot oder Cyan, das ein Auge durch die Brille dunkel sieht. Graues Stereo zeigt es beiden</translation>
    </message>
    <message>
        <source>This scan has no colours; it is shown as shaded relief</source>
        <translation>Dieser Scan hat keine Farben; er wird als beleuchtetes Relief gezeigt</translation>
    </message>
    <message>
        <source>This scan has no intensities; it is shown as shaded relief</source>
        <translation>Dieser Scan hat keine Intensitäten; er wird als beleuchtetes Relief gezeigt</translation>
    </message>
</context>
<context>
    <name>relievo::LoopAnnouncer</name>
    <message>
        <source>Forces off: %1.</source>
        <translation>Kräfte aus: %1.</translation>
    </message>
    <message>
        <source>Forces went off, because the window did not answer for %1 s. Press F5 to switch them on.</source>
        <translation>Die Kräfte sind aus, weil das Fenster %1 s lang nicht geantwortet hat. F5 schaltet sie ein.</translation>
    </message>
    <message>
        <source>The hand pushes over the edge of the window.</source>
        <translation>Die Hand drückt über den Rand des Fensters.</translation>
    </message>
    <message>
        <source>The hand is clear: forces come on.</source>
        <translation>Die Hand ist frei: Die Kräfte kommen.</translation>
    </message>
    <message>
        <source>Forces wait: the hand is inside. Let go or press Page Up.</source>
        <translation>Kräfte warten: Die Hand ist im Inneren. Loslassen oder Bild auf.</translation>
    </message>
    <message>
        <source>Forces wait: the hand is inside. Raise the grip.</source>
        <translation>Kräfte warten: Die Hand ist im Inneren. Heben Sie den Griff.</translation>
    </message>
    <message>
        <source>Softened to %1 N/mm: hand and surface had begun to swing.</source>
        <translation>Auf %1 N/mm verringert: Hand und Oberfläche begannen zu schwingen.</translation>
    </message>
    <message>
        <source>Surface made softer to stay steady.</source>
        <translation>Oberfläche weicher gemacht, damit sie ruhig bleibt.</translation>
    </message>
</context>
<context>
    <name>relievo::LoopDetailsDialog</name>
    <message>
        <source>How the force loop runs</source>
        <translation>Wie die Kraftschleife läuft</translation>
    </message>
    <message>
        <source>Counts of the force loop since it began</source>
        <translation>Zählungen der Kraftschleife seit ihrem Beginn</translation>
    </message>
</context>
<context>
    <name>relievo::LoopRows</name>
    <message>
        <source>How far the hand is pressed in</source>
        <translation>Wie weit die Hand eingedrückt ist</translation>
    </message>
    <message>
        <source>How the force loop runs</source>
        <translation>Wie die Kraftschleife läuft</translation>
    </message>
    <message>
        <source>More a&amp;bout the loop…</source>
        <translation>Mehr über d&amp;ie Schleife…</translation>
    </message>
    <message>
        <source>More about the force loop</source>
        <translation>Mehr über die Kraftschleife</translation>
    </message>
    <message>
        <source>Plots &amp;with a cursor…</source>
        <translation>Kurven mit &amp;Zeiger…</translation>
    </message>
    <message>
        <source>Plots of height and force with a cursor</source>
        <translation>Kurven von Höhe und Kraft mit Zeiger</translation>
    </message>
    <message>
        <source>Pause, zoom, read values, and save as SVG or CSV.</source>
        <translation>Anhalten, vergrößern, Werte ablesen und als SVG oder CSV speichern.</translation>
    </message>
    <message>
        <source>Wake-ups and computing times as tables, and what the system granted.</source>
        <translation>Weck- und Rechenzeiten als Tabellen, und was das System gewährte.</translation>
    </message>
    <message>
        <source>Pressed in</source>
        <translation>Eingedrückt</translation>
    </message>
    <message>
        <source>Force loop</source>
        <translation>Kraftschleife</translation>
    </message>
    <message>
        <source>%1 mm of hand</source>
        <translation>%1 mm der Hand</translation>
    </message>
    <message>
        <source>not touching</source>
        <translation>keine Berührung</translation>
    </message>
</context>
<context>
    <name>relievo::MainWindow</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Files opened before</source>
        <translation>Zuvor geöffnete Dateien</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>From which side the object is seen (Alt+1 to Alt+6)</source>
        <translation>Von welcher Seite das Objekt gesehen wird (Alt+1 bis Alt+6)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Diese Liste leeren</translation>
    </message>
    <message>
        <source>Forget these files</source>
        <translation>Diese Dateien vergessen</translation>
    </message>
    <message>
        <source>About relievo</source>
        <translation>Über relievo</translation>
    </message>
    <message>
        <source>&lt;b&gt;relievo %1&lt;/b&gt;&lt;br&gt;See and touch scans of reliefs: a depth map, its pyramid, and a window on it that is shown in stereo and felt.&lt;br&gt;&lt;br&gt;BSD-3-Clause licence.</source>
        <translation>&lt;b&gt;relievo %1&lt;/b&gt;&lt;br&gt;Scans von Reliefs sehen und fühlen: eine Tiefenkarte, ihre Pyramide und ein Ausschnitt daraus, der in Stereo gezeigt und gefühlt wird.&lt;br&gt;&lt;br&gt;BSD-3-Clause-Lizenz.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1: %2, points: %3</source>
        <translation>%1: %2, Punkte: %3</translation>
    </message>
    <message>
        <source>%1 is open.</source>
        <translation>%1 ist geöffnet.</translation>
    </message>
    <message>
        <source>%1 Press F5 to switch forces on.</source>
        <translation>%1 F5 schaltet die Kräfte ein.</translation>
    </message>
    <message>
        <source>the haptics plugin was not found.</source>
        <translation>das Haptik-Plugin wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>Level 0 of the pyramid: not smoothed</source>
        <translation>Ebene 0 der Pyramide: nicht geglättet</translation>
    </message>
    <message>
        <source>Level %1 of the pyramid, smoothed by a Gaussian of σ = %2</source>
        <translation>Ebene %1 der Pyramide, geglättet durch eine Gauß-Funktion mit σ = %2</translation>
    </message>
    <message>
        <source>%1 is closed</source>
        <translation>%1 ist geschlossen</translation>
    </message>
    <message>
        <source>%1 is closed when the recording is saved</source>
        <translation>%1 wird geschlossen, wenn die Aufnahme gesichert ist</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 stays open</source>
        <translation>%1 bleibt offen</translation>
    </message>
    <message>
        <source>The scan in 3-D: arrows turn it, Enter makes the relief from there</source>
        <translation>Der Scan in 3-D: Pfeile drehen ihn, Enter macht das Relief von dort</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Resolution %1 of %2</source>
        <translation>Auflösung %1 von %2</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Which level of the pyramid feeds the window</source>
        <translation>Welche Ebene der Pyramide den Ausschnitt speist</translation>
    </message>
    <message>
        <source>Resolution %1/%2</source>
        <translation>Auflösung %1/%2</translation>
    </message>
    <message>
        <source>Only files on this computer, or one address of a published map, can be opened. Nothing was opened.</source>
        <translation>Nur Dateien auf diesem Rechner oder eine einzige Adresse einer veröffentlichten Karte können geöffnet werden. Nichts wurde geöffnet.</translation>
    </message>
    <message>
        <source>Resolution %1/%2, %3 on its way</source>
        <translation>Auflösung %1/%2, %3 kommt</translation>
    </message>
</context>
<context>
    <name>relievo::Manual</name>
    <message>
        <source>The manual is not here. The package relievo brings it, unless the system leaves out what belongs in /usr/share/doc; in the sources &quot;cmake --build --preset release --target site&quot; makes it, and docs/user has the same as text.</source>
        <translation>Das Handbuch ist nicht hier. Das Paket relievo bringt es mit, falls das System nicht weglässt, was nach /usr/share/doc gehört; in den Quellen erstellt es &quot;cmake --build --preset release --target site&quot;, und in docs/user steht dasselbe als Text.</translation>
    </message>
    <message>
        <source>No browser could be started. Install one, or open this file elsewhere: %1</source>
        <translation>Kein Browser ließ sich starten. Installieren Sie einen, oder öffnen Sie diese Datei anderswo: %1</translation>
    </message>
    <message>
        <source>The manual opens in the browser: %1</source>
        <translation>Das Handbuch öffnet sich im Browser: %1</translation>
    </message>
</context>
<context>
    <name>relievo::MeasureController</name>
    <message>
        <source>Save measurements</source>
        <translation>Messungen speichern</translation>
    </message>
    <message>
        <source>List of measurements (*.csv)</source>
        <translation>Liste der Messungen (*.csv)</translation>
    </message>
    <message>
        <source>Selected profile or section (*.csv *.svg)</source>
        <translation>Gewähltes Profil oder Schnitt (*.csv *.svg)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 ist gespeichert</translation>
    </message>
    <message>
        <source>Save profile</source>
        <translation>Profil speichern</translation>
    </message>
    <message>
        <source>As it is shown (*.svg)</source>
        <translation>Wie gezeigt (*.svg)</translation>
    </message>
    <message>
        <source>Its numbers (*.csv)</source>
        <translation>Seine Zahlen (*.csv)</translation>
    </message>
</context>
<context>
    <name>relievo::MeasurePanel</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanz</translation>
    </message>
    <message>
        <source>Depth difference</source>
        <translation>Höhenunterschied</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Area and volume</source>
        <translation>Fläche und Volumen</translation>
    </message>
    <message>
        <source>%1 %2 ± %3 %4</source>
        <translation>%1 %2 ± %3 %4</translation>
    </message>
    <message>
        <source>%1 % of it is not measured</source>
        <translation>%1 % davon sind nicht gemessen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>Liste speichern…</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Was als nächstes zu tun ist</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Names can be changed by a double click or F2</source>
        <translation>Namen lassen sich durch Doppelklick oder F2 ändern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alle auswählen</translation>
    </message>
    <message>
        <source>Delete the selected measurement</source>
        <translation>Die gewählte Messung löschen</translation>
    </message>
    <message>
        <source>There is no surface here</source>
        <translation>Hier ist keine Oberfläche</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>Choose in the Measure menu.</source>
        <translation>Wählen Sie im Menü Messen.</translation>
    </message>
    <message>
        <source>%1: place %2 of %3. Click on the detail view, or move the hand there and press Enter.</source>
        <translation>%1: Stelle %2 von %3. Klicken Sie in die Detailansicht, oder führen Sie die Hand dorthin und drücken Sie die Eingabetaste.</translation>
    </message>
    <message>
        <source>A double click or F ends.</source>
        <translation>Ein Doppelklick oder F beendet.</translation>
    </message>
    <message>
        <source>By touch: with forces on (F5), tap two places for their depth difference, or draw a stroke for a profile. Escape ends.</source>
        <translation>Durch Ertasten: bei eingeschalteten Kräften (F5) zwei Stellen antippen für ihren Tiefenunterschied, oder einen Strich ziehen für ein Profil. Escape beendet.</translation>
    </message>
    <message>
        <source>Being read…</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Plane level at %1 mm</source>
        <translation>Ebene waagerecht bei %1 mm</translation>
    </message>
    <message>
        <source>Plane upright, %1 mm from the corner</source>
        <translation>Ebene aufrecht, %1 mm von der Ecke</translation>
    </message>
    <message>
        <source>Plane oblique, %1 mm from the corner</source>
        <translation>Ebene schräg, %1 mm von der Ecke</translation>
    </message>
    <message>
        <source>Save the list as CSV, or the selected profile or section as CSV or SVG</source>
        <translation>Die Liste als CSV speichern, oder das gewählte Profil oder den Schnitt als CSV oder SVG</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Volume counts from:</source>
        <translation>Volumen zählt ab:</translation>
    </message>
    <message>
        <source>Plane at:</source>
        <translation>Ebene bei:</translation>
    </message>
    <message>
        <source>Height from which the volume counts</source>
        <translation>Höhe, ab der das Volumen zählt</translation>
    </message>
    <message>
        <source>Place of the section&apos;s plane</source>
        <translation>Ort der Schnittebene</translation>
    </message>
    <message>
        <source>Height of the plane above which the volume of the selected area counts</source>
        <translation>Höhe der Ebene, über der das Volumen der gewählten Fläche zählt</translation>
    </message>
    <message>
        <source>Distance of the section&apos;s plane from the lower left corner at height 0, along its normal; the height of a level plane</source>
        <translation>Abstand der Schnittebene von der linken unteren Ecke in Höhe 0, entlang ihrer Normalen; bei einer waagerechten Ebene ihre Höhe</translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s)</source>
        <translation>
            <numerusform>%n Kurve</numerusform>
            <numerusform>%n Kurven</numerusform>
        </translation>
    </message>
    <message>
        <source>The outline would cross itself here. Choose another place.</source>
        <translation>Der Umriss würde sich hier selbst kreuzen. Wählen Sie eine andere Stelle.</translation>
    </message>
    <message>
        <source>The outline crosses itself or has no area. Its last corner was taken back.</source>
        <translation>Der Umriss kreuzt sich selbst oder hat keine Fläche. Seine letzte Ecke wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>F after one place: the contour at its height; after two: an upright cut through both. Three places: the plane through them.</source>
        <translation>F nach einer Stelle: die Höhenlinie dort; nach zweien: ein aufrechter Schnitt durch beide. Drei Stellen: die Ebene durch sie.</translation>
    </message>
    <message>
        <source>The finest resolution of this place is on its way. Choose the place again in a moment.</source>
        <translation>Die feinste Auflösung dieser Stelle ist unterwegs. Wählen Sie die Stelle gleich noch einmal.</translation>
    </message>
</context>
<context>
    <name>relievo::Message</name>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>what has this name is no regular file</source>
        <translation>was so heißt, ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it is read-only</source>
        <translation>sie ist schreibgeschützt</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>ihre symbolischen Verknüpfungen führen im Kreis</translation>
    </message>
    <message>
        <source>Cannot write %1: %2. It was left as it is. Choose another name.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Es blieb, wie es ist. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is the scan itself. Nothing was written. Choose another name.</source>
        <translation>Das Ziel „%1“ ist der Scan selbst. Nichts wurde geschrieben. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is %2. Nothing was written. Choose another name.</source>
        <translation>Die Ausgabe „%1“ ist zugleich eine Eingabe (%2). Nichts wurde geschrieben. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Two of the outputs would be &apos;%1&apos;. Nothing was written. Give one of them another name.</source>
        <translation>Zwei der Ausgaben hießen „%1“. Nichts wurde geschrieben. Geben Sie einer davon einen anderen Namen.</translation>
    </message>
    <message>
        <source>Cannot write %1: %2. Check the folder, its permissions and the free space.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Prüfen Sie den Ordner, seine Rechte und den freien Platz.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; cannot be read.</source>
        <translation>Die Aufzeichnung „%1“ ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; cannot be read to its end.</source>
        <translation>Die Aufzeichnung „%1“ ist nicht bis zu ihrem Ende lesbar.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; cannot be read as a log of this version.</source>
        <translation>Die Aufzeichnung „%1“ ist nicht als eine dieser Version lesbar.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has a row that cannot be read: number %2.</source>
        <translation>Die Aufzeichnung „%1“ hat eine Zeile, die nicht gelesen werden kann: Nummer %2.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has other columns than this version&apos;s: it has no &quot;%2&quot;.</source>
        <translation>Die Aufzeichnung „%1“ hat andere Spalten als die dieser Version: „%2“ fehlt.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has no rows.</source>
        <translation>Die Aufzeichnung „%1“ hat keine Zeilen.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; has columns of two lengths.</source>
        <translation>Die Aufzeichnung „%1“ hat Spalten von zweierlei Länge.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no recording of relievo. Choose a .csv or .h5 file that it recorded.</source>
        <translation>„%1“ ist keine Aufnahme von relievo. Wählen Sie eine .csv- oder .h5-Datei, die es aufgenommen hat.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read as HDF5.</source>
        <translation>„%1“ ist nicht als HDF5 lesbar.</translation>
    </message>
    <message>
        <source>HDF5 refused a part of the file.</source>
        <translation>HDF5 lehnte einen Teil der Datei ab.</translation>
    </message>
    <message>
        <source>HDF5 could not write.</source>
        <translation>HDF5 konnte nicht schreiben.</translation>
    </message>
    <message>
        <source>The folder %1 for automatic copies cannot be written (%2). Save by hand, or free some space.</source>
        <translation>Der Ordner %1 für automatische Kopien kann nicht beschrieben werden (%2). Speichern Sie von Hand, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>A figure&apos;s width in mm must be %1 to %2. Nothing was drawn.</source>
        <translation>Die Breite einer Abbildung in mm muss zwischen %1 und %2 liegen. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>A figure&apos;s dots per inch must be %1 to %2. Nothing was drawn.</source>
        <translation>Die Zahl der Punkte je Zoll einer Abbildung muss zwischen %1 und %2 liegen. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>A figure&apos;s text size in points must be %1 to %2. Nothing was drawn.</source>
        <translation>Die Schriftgröße einer Abbildung in Punkt muss zwischen %1 und %2 liegen. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>A figure&apos;s angle between the eyes in degrees must be %1 to %2. Nothing was drawn.</source>
        <translation>Der Winkel zwischen den Augen einer Abbildung in Grad muss zwischen %1 und %2 liegen. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>A scale of 1:N needs an N above 0. Nothing was drawn.</source>
        <translation>Ein Maßstab 1:N braucht ein N über 0. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>An anaglyph needs its background: without paper the eyes would see different pages. Choose one of the two.</source>
        <translation>Ein Anaglyphenbild braucht seinen Hintergrund: Ohne Papier sähen die Augen verschiedene Seiten. Wählen Sie eines von beiden.</translation>
    </message>
    <message>
        <source>Two eyes&apos; pictures fill a figure of their own: they need the layout &apos;detail&apos;. Choose it, or an anaglyph.</source>
        <translation>Die Bilder zweier Augen füllen eine eigene Abbildung: Sie brauchen die Anordnung „detail“. Wählen Sie diese oder ein Anaglyphenbild.</translation>
    </message>
    <message>
        <source>One eye&apos;s picture of two needs the layout &apos;detail&apos; and the stereo &apos;sidebyside&apos; or &apos;overunder&apos;. Choose both eyes, or these.</source>
        <translation>Das Bild eines von zwei Augen braucht die Anordnung „detail“ und das Stereo „sidebyside“ oder „overunder“. Wählen Sie beide Augen oder diese.</translation>
    </message>
    <message>
        <source>A figure with plots needs a recording. Choose one, CSV or HDF5.</source>
        <translation>Eine Abbildung mit Kurven braucht eine Aufzeichnung. Wählen Sie eine, CSV oder HDF5.</translation>
    </message>
    <message>
        <source>The package %1 could not be written (%2). Nothing was left behind. Choose another folder or free some space.</source>
        <translation>Das Paket %1 konnte nicht geschrieben werden (%2). Nichts blieb zurück. Wählen Sie einen anderen Ordner, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not there. Nothing was packed. Relink it, or take it out of the project.</source>
        <translation>„%1“ ist nicht da. Nichts wurde gepackt. Verknüpfen Sie die Datei neu, oder nehmen Sie sie aus dem Projekt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since (checksum differs). Nothing was packed. Relink it, or take it out of the project.</source>
        <translation>„%1“ wurde seither geändert (andere Prüfsumme). Nichts wurde gepackt. Verknüpfen Sie die Datei neu, oder nehmen Sie sie aus dem Projekt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not there. Nothing was packed. It is needed to repeat &apos;%2&apos;: put it back, or take the recording out.</source>
        <translation>„%1“ ist nicht da. Nichts wurde gepackt. Die Datei wird gebraucht, um „%2“ zu wiederholen: Legen Sie sie zurück, oder nehmen Sie die Aufzeichnung heraus.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since (checksum differs). Nothing was packed. It is needed to repeat &apos;%2&apos;: put it back, or take the recording out.</source>
        <translation>„%1“ wurde seither geändert (andere Prüfsumme). Nichts wurde gepackt. Die Datei wird gebraucht, um „%2“ zu wiederholen: Legen Sie sie zurück, oder nehmen Sie die Aufzeichnung heraus.</translation>
    </message>
    <message>
        <source>%1 would unpack to %2 bytes, more than %3 times its own size. Nothing was unpacked. Ask whoever made it for another.</source>
        <translation>%1 ergäbe ausgepackt %2 Bytes, mehr als das %3-Fache der eigenen Größe. Nichts wurde ausgepackt. Bitten Sie den Ersteller um ein anderes Paket.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is not a whole zip file. Copy or download it again.</source>
        <translation>%1 kann nicht gelesen werden: Es ist keine vollständige Zip-Datei. Kopieren oder laden Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 holds no %2 of relievo.</source>
        <translation>%1 enthält kein %2 von relievo.</translation>
    </message>
    <message>
        <source>%1 holds no %2 of relievo, so that nothing can be checked. Choose a package for citation.</source>
        <translation>%1 enthält kein %2 von relievo, deshalb kann nichts geprüft werden. Wählen Sie ein Paket zum Zitieren.</translation>
    </message>
    <message>
        <source>%1 names a file outside of itself (&apos;%2&apos;). Nothing was unpacked.</source>
        <translation>%1 nennt eine Datei außerhalb seiner selbst („%2“). Nichts wurde ausgepackt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be unpacked; is the disk full?</source>
        <translation>„%1“ kann nicht ausgepackt werden; ist der Datenträger voll?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 is damaged.</source>
        <translation>„%1“ in %2 ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 is not a project of relievo. Nothing was changed. Choose another file.</source>
        <translation>%1 ist kein Projekt von relievo. Nichts wurde geändert. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The project %1 was written by another relievo (schema %2; this one reads %3). Nothing was changed. Use that version, or choose another file.</source>
        <translation>Das Projekt %1 stammt von einem anderen relievo (Schema %2; dieses liest %3). Nichts wurde geändert. Benutzen Sie jene Version, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The project %1 is damaged (line %2). Nothing was changed. Choose another file.</source>
        <translation>Das Projekt %1 ist beschädigt (Zeile %2). Nichts wurde geändert. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The project %1 is damaged (a part is missing or has another form). Nothing was changed. Choose another file.</source>
        <translation>Das Projekt %1 ist beschädigt (ein Teil fehlt oder hat eine andere Form). Nichts wurde geändert. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The project %1 is damaged (%2). Nothing was changed. Choose another file.</source>
        <translation>Das Projekt %1 ist beschädigt (%2). Nichts wurde geändert. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>%1 was made from &apos;%2&apos;, which is not there (E501). Nothing was made. Give its place as FILE.</source>
        <translation>%1 wurde aus „%2“ gemacht, das nicht da ist (E501). Nichts wurde gemacht. Nennen Sie den Ort als DATEI.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; goes back in time in row %2. It is not replayed.</source>
        <translation>Die Aufzeichnung „%1“ springt in Zeile %2 in der Zeit zurück. Sie wird nicht wiedergegeben.</translation>
    </message>
    <message>
        <source>Cannot read %1: the picture is damaged. Nothing was restored.</source>
        <translation>%1 kann nicht gelesen werden: Das Bild ist beschädigt. Nichts wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>Cannot read %1: what it carries of relievo is cut off. Nothing was restored.</source>
        <translation>%1 kann nicht gelesen werden: Was die Datei von relievo mitbringt, ist abgeschnitten. Nichts wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>Cannot read %1: what it says of how it was made is damaged. Nothing was compared.</source>
        <translation>%1 kann nicht gelesen werden: Was die Datei über ihre Entstehung sagt, ist beschädigt. Nichts wurde verglichen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, beyond what it may be.</source>
        <translation>„%1“ ist %2 und damit außerhalb des Erlaubten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is beyond what it may be.</source>
        <translation>„%1“ ist außerhalb des Erlaubten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a whole number.</source>
        <translation>„%1“ ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has not {2|%2 number|%2 numbers}.</source>
        <translation>„%1“ hat nicht {2|%2 Zahl|%2 Zahlen}.</translation>
    </message>
    <message>
        <source>It is nested too deep.</source>
        <translation>Es ist zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a checksum.</source>
        <translation>„%1“ ist keine Prüfsumme.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a file&apos;s name.</source>
        <translation>„%1“ ist kein Dateiname.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a known &apos;%2&apos;.</source>
        <translation>„%1“ ist kein bekannter Wert für „%2“.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no size.</source>
        <translation>„%1“ hat keine Größe.</translation>
    </message>
    <message>
        <source>a place of a picture has not 3 numbers.</source>
        <translation>Eine Stelle eines Bildes hat nicht 3 Zahlen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no colour.</source>
        <translation>„%1“ ist keine Farbe.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an object.</source>
        <translation>„%1“ ist kein Objekt.</translation>
    </message>
    <message>
        <source>There is no &apos;%1&apos; in it.</source>
        <translation>„%1“ fehlt darin.</translation>
    </message>
    <message>
        <source>It is of schema %1; this version reads up to %2.</source>
        <translation>Es hat Schema %1; diese Version liest bis %2.</translation>
    </message>
    <message>
        <source>There is no &apos;relievo_view&apos; of schema 1 in it.</source>
        <translation>„relievo_view“ nach Schema 1 fehlt darin.</translation>
    </message>
    <message>
        <source>%1 holds no state that this version can read: it is damaged. Nothing was changed.</source>
        <translation>%1 enthält keinen Zustand, den diese Version lesen kann: Er ist beschädigt. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 holds no state that this version can read: a part is missing or has another form. Nothing was changed.</source>
        <translation>%1 enthält keinen Zustand, den diese Version lesen kann: Ein Teil fehlt oder hat eine andere Form. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 holds no state that this version can read. %2 Nothing was changed.</source>
        <translation>%1 enthält keinen Zustand, den diese Version lesen kann. %2 Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This text is not a view of relievo (it is damaged, or a part is missing). The view was not changed. Copy a view again.</source>
        <translation>Dieser Text ist keine Ansicht von relievo (er ist beschädigt, oder ein Teil fehlt). Die Ansicht wurde nicht geändert. Kopieren Sie eine Ansicht noch einmal.</translation>
    </message>
    <message>
        <source>This text is not a view of relievo (%1). The view was not changed. Copy a view again.</source>
        <translation>Dieser Text ist keine Ansicht von relievo (%1). Die Ansicht wurde nicht geändert. Kopieren Sie eine Ansicht noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is missing or not a file. Its checksum was not made.</source>
        <translation>%1 kann nicht gelesen werden: Es fehlt oder ist keine Datei. Die Prüfsumme wurde nicht gebildet.</translation>
    </message>
    <message>
        <source>Cannot read %1 to its end. Its checksum was not made.</source>
        <translation>%1 kann nicht bis zum Ende gelesen werden. Die Prüfsumme wurde nicht gebildet.</translation>
    </message>
    <message>
        <source>%1 was not seen from the top, so heights are no z of the file. Nothing was written. Choose --view top or view millimetres.</source>
        <translation>%1 wurde nicht von oben gesehen, deshalb sind die Höhen kein z der Datei. Nichts wurde geschrieben. Wählen Sie --view top oder Millimeter der Ansicht.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 x %3 cells, but the map is %4 x %5 mm: it is not a raster of the whole map, and was not used. Cut it to the outline of the map.</source>
        <translation>„%1“ hat %2 x %3 Zellen, die Karte aber misst %4 x %5 mm: Es ist kein Raster der ganzen Karte und wurde nicht verwendet. Schneiden Sie es auf den Umriss der Karte zu.</translation>
    </message>
    <message>
        <source>%1: a mesh&apos;s triangles cannot be read in blocks. Nothing was made. Leave out --memory, or save it without faces.</source>
        <translation>%1: Die Dreiecke eines Netzes können nicht in Blöcken gelesen werden. Nichts wurde gemacht. Lassen Sie --memory weg, oder speichern Sie die Datei ohne Flächen.</translation>
    </message>
    <message>
        <source>%1: only LAS, LAZ and binary PLY clouds and rasters are read in blocks. Nothing was made. Convert it to LAS, or leave out --memory.</source>
        <translation>%1: Nur Wolken in LAS, LAZ und binärem PLY sowie Raster werden in Blöcken gelesen. Nichts wurde gemacht. Wandeln Sie die Datei in LAS um, oder lassen Sie --memory weg.</translation>
    </message>
    <message>
        <source>%1 and %2 are not of one unit (%3 and %4), so they are no single scan. Nothing was made. Convert one of them, or make a map of each.</source>
        <translation>%1 und %2 haben nicht eine Einheit (%3 und %4) und sind deshalb kein einzelner Scan. Nichts wurde gemacht. Wandeln Sie eine davon um, oder machen Sie von jeder eine Karte.</translation>
    </message>
    <message>
        <source>%1 and %2 have different reference systems, so they are no single scan. Nothing was made. Convert one of them, or make a map of each.</source>
        <translation>%1 und %2 haben verschiedene Bezugssysteme und sind deshalb kein einzelner Scan. Nichts wurde gemacht. Wandeln Sie eine davon um, oder machen Sie von jeder eine Karte.</translation>
    </message>
    <message>
        <source>%1 cannot be listed: %2. Nothing was made. Check its permissions.</source>
        <translation>%1 kann nicht gelesen werden: %2. Nichts wurde gemacht. Prüfen Sie die Rechte des Ordners.</translation>
    </message>
    <message>
        <source>%1 names or holds no LAS, LAZ or PLY file. Nothing was made. Choose another folder or list.</source>
        <translation>%1 nennt oder enthält keine Datei LAS, LAZ oder PLY. Nichts wurde gemacht. Wählen Sie einen anderen Ordner oder eine andere Liste.</translation>
    </message>
    <message>
        <source>No file fits %1. Nothing was made. Check the pattern.</source>
        <translation>Keine Datei passt zu %1. Nichts wurde gemacht. Prüfen Sie das Muster.</translation>
    </message>
    <message>
        <source>%1 names %2, and there is no such file. Nothing was made. Correct the list.</source>
        <translation>%1 nennt %2, und eine solche Datei gibt es nicht. Nichts wurde gemacht. Berichtigen Sie die Liste.</translation>
    </message>
    <message>
        <source>%1 is longer than lists of files are (64 MB). Nothing was made. Divide it, or name a folder.</source>
        <translation>%1 ist länger, als Listen von Dateien sind (64 MB). Nichts wurde gemacht. Teilen Sie sie, oder nennen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>%1 cannot be read as a tile index: it is damaged, or one of its features names no file. Nothing was made. Make it anew, or name a folder.</source>
        <translation>%1 ist als Kachelverzeichnis nicht lesbar: Es ist beschädigt, oder ein Eintrag nennt keine Datei. Nichts wurde gemacht. Erzeugen Sie es neu, oder nennen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>%1 names %2, which is no file of this computer. Nothing was made. Fetch the files first.</source>
        <translation>%1 nennt %2, und das ist keine Datei dieses Rechners. Nichts wurde gemacht. Holen Sie die Dateien zuerst.</translation>
    </message>
    <message>
        <source>Several files become one map by tiles only. Nothing was made. Give --memory as well, or join them with relievo prepare.</source>
        <translation>Mehrere Dateien werden nur in Kacheln zu einer Karte. Nichts wurde gemacht. Geben Sie auch --memory an, oder fügen Sie sie mit relievo prepare zusammen.</translation>
    </message>
    <message>
        <source>%1 holds work on another map: %2 differs. Nothing was made. Give the same files and options as then, or another folder with --job.</source>
        <translation>%1 enthält die Arbeit an einer anderen Karte: %2 ist anders. Nichts wurde gemacht. Geben Sie dieselben Dateien und Optionen wie damals an, oder mit --job einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Another process works in %1. Nothing was made. Wait until it ends, or give another folder with --job.</source>
        <translation>In %1 arbeitet ein anderer Prozess. Nichts wurde gemacht. Warten Sie, bis er endet, oder geben Sie mit --job einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>%1 is not empty and holds no work of this program. Nothing was made. Give an empty or a new folder with --job.</source>
        <translation>%1 ist nicht leer und enthält keine Arbeit dieses Programms. Nichts wurde gemacht. Geben Sie mit --job einen leeren oder neuen Ordner an.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. What was finished before stays in its folder. Free some space, and give the same command again.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Was vorher fertig war, bleibt in seinem Ordner. Schaffen Sie Platz, und geben Sie denselben Befehl noch einmal.</translation>
    </message>
    <message>
        <source>%1: none of its points that were looked at is finite. Nothing was made.</source>
        <translation>%1: Keiner der angesehenen Punkte ist endlich. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A raster is a height map already and is seen from the top only.</source>
        <translation>Ein Raster ist schon eine Höhenkarte und wird nur von oben gesehen.</translation>
    </message>
    <message>
        <source>A map of %1 x %2 cells needs at least %3 MB of memory when made by tiles; %4 MB are allowed. Nothing was made. Allow more with --memory, or choose larger cells.</source>
        <translation>Eine Karte von %1 x %2 Zellen braucht in Kacheln mindestens %3 MB Speicher; erlaubt sind %4 MB. Nichts wurde gemacht. Erlauben Sie mit --memory mehr, oder wählen Sie größere Zellen.</translation>
    </message>
    <message>
        <source>There is no level %1.</source>
        <translation>Es gibt keine Ebene %1.</translation>
    </message>
    <message>
        <source>This needs about %1; %2 are free. Nothing was made. Choose cells of at least %3 (%4), or close other programs.</source>
        <translation>Das braucht etwa %1; frei sind %2. Nichts wurde erzeugt. Wählen Sie Zellen von mindestens %3 (%4) oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1: every height is the one that stands for none, so there is no surface. Nothing was made. Choose another --nodata.</source>
        <translation>%1: Jede Höhe ist die, die für keine steht; es gibt also keine Oberfläche. Nichts wurde gemacht. Wählen Sie ein anderes --nodata.</translation>
    </message>
    <message>
        <source>%1: no point is left to make a surface from. Nothing was made. Choose another --nodata.</source>
        <translation>%1: Kein Punkt bleibt, aus dem eine Oberfläche werden könnte. Nichts wurde gemacht. Wählen Sie ein anderes --nodata.</translation>
    </message>
    <message>
        <source>%1: seen from here all points lie on one spot, so there is no surface. Nothing was made. Choose another view or another file.</source>
        <translation>%1: Von hier gesehen liegen alle Punkte auf einer Stelle, deshalb gibt es keine Oberfläche. Nichts wurde gemacht. Wählen Sie eine andere Ansicht oder eine andere Datei.</translation>
    </message>
    <message>
        <source>Give the number of cells or their spacing, not both.</source>
        <translation>Nennen Sie die Zahl der Zellen oder ihren Abstand, nicht beides.</translation>
    </message>
    <message>
        <source>The spacing must be above 0 mm.</source>
        <translation>Der Abstand muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The grid needs at least 2 cells across.</source>
        <translation>Das Gitter braucht mindestens 2 Zellen in der Breite.</translation>
    </message>
    <message>
        <source>A grid of %1 x %2 cells is larger than this version can hold (16384 x 16384). Choose fewer cells, or have the map made by tiles (--memory).</source>
        <translation>Ein Gitter von %1 x %2 Zellen ist größer, als diese Version fassen kann (16384 x 16384). Wählen Sie weniger Zellen, oder lassen Sie die Karte aus Kacheln machen (--memory).</translation>
    </message>
    <message>
        <source>A grid of %1 x %2 cells is larger than maps by tiles can be (2^40 cells, 2^23 a side). Choose fewer cells.</source>
        <translation>Ein Gitter von %1 x %2 Zellen ist größer, als Karten aus Kacheln sein können (2^40 Zellen, 2^23 je Seite). Wählen Sie weniger Zellen.</translation>
    </message>
    <message>
        <source>A map of %1 x %2 cells needs about %3 MB on the disk of %4 while it is made; %5 MB are free. Nothing was made. Free some space, or choose larger cells.</source>
        <translation>Eine Karte von %1 x %2 Zellen braucht, während sie gemacht wird, etwa %3 MB auf der Platte von %4; %5 MB sind frei. Es wurde nichts gemacht. Schaffen Sie Platz, oder wählen Sie größere Zellen.</translation>
    </message>
    <message>
        <source>The relief image &apos;natural&apos; cannot be drawn: this surface has no colours. Choose another, for example &apos;lit&apos;.</source>
        <translation>Das Reliefbild „natürliche Farben“ kann nicht gezeichnet werden: Diese Oberfläche hat keine Farben. Wählen Sie ein anderes, zum Beispiel das beleuchtete Relief.</translation>
    </message>
    <message>
        <source>The relief image &apos;intensity&apos; cannot be drawn: this surface has no intensities. Choose another, for example &apos;lit&apos;.</source>
        <translation>Das Reliefbild „Intensität“ kann nicht gezeichnet werden: Diese Oberfläche hat keine Intensitäten. Wählen Sie ein anderes, zum Beispiel das beleuchtete Relief.</translation>
    </message>
    <message>
        <source>An angle needs three different points.</source>
        <translation>Ein Winkel braucht drei verschiedene Punkte.</translation>
    </message>
    <message>
        <source>The profile&apos;s line is not on the object.</source>
        <translation>Die Linie des Profils liegt nicht auf dem Objekt.</translation>
    </message>
    <message>
        <source>The outline crosses itself, so that it has no inside. Choose its corners in order.</source>
        <translation>Der Umriss kreuzt sich selbst und hat deshalb kein Inneres. Wählen Sie seine Ecken der Reihe nach.</translation>
    </message>
    <message>
        <source>The corners lie on one line, so that there is no area among them. Choose others.</source>
        <translation>Die Ecken liegen auf einer Geraden, zwischen ihnen ist keine Fläche. Wählen Sie andere.</translation>
    </message>
    <message>
        <source>The plane does not cut the surface. Choose another plane.</source>
        <translation>Die Ebene schneidet die Oberfläche nicht. Wählen Sie eine andere Ebene.</translation>
    </message>
    <message>
        <source>The plane of &apos;%1&apos; does not cut the surface. Choose another plane.</source>
        <translation>Die Ebene von „%1“ schneidet die Oberfläche nicht. Wählen Sie eine andere Ebene.</translation>
    </message>
    <message>
        <source>A measurement of kind %1 needs %2 places.</source>
        <translation>Eine Messung der Art %1 braucht %2 Stellen.</translation>
    </message>
    <message>
        <source>There is no surface at x %1, y %2 mm. Choose a place on the object.</source>
        <translation>Bei x %1, y %2 mm gibt es keine Oberfläche. Wählen Sie eine Stelle auf dem Objekt.</translation>
    </message>
    <message>
        <source>A profile needs at least two places.</source>
        <translation>Ein Profil braucht mindestens zwei Stellen.</translation>
    </message>
    <message>
        <source>The plane cuts this map in more than %1 points. Choose another plane, or make a map with coarser cells.</source>
        <translation>Die Ebene schneidet diese Karte in mehr als %1 Punkten. Wählen Sie eine andere Ebene, oder machen Sie eine Karte mit gröberen Zellen.</translation>
    </message>
    <message>
        <source>A section&apos;s plane goes through one, two or three places.</source>
        <translation>Die Ebene eines Schnitts geht durch eine, zwei oder drei Stellen.</translation>
    </message>
    <message>
        <source>Two places, one above the other, give no plane. Choose another.</source>
        <translation>Zwei Stellen übereinander ergeben keine Ebene. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>Three places on one line give no plane. Choose another.</source>
        <translation>Drei Stellen auf einer Geraden ergeben keine Ebene. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>A section needs a plane with a direction and a distance.</source>
        <translation>Ein Schnitt braucht eine Ebene mit Richtung und Abstand.</translation>
    </message>
    <message>
        <source>The shading of a scan&apos;s own colours must lie between 0 and 1.</source>
        <translation>Die Schattierung der eigenen Farben eines Scans muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>The colours&apos; upper end must lie above their lower end.</source>
        <translation>Das obere Ende der Farben muss über dem unteren liegen.</translation>
    </message>
    <message>
        <source>A light needs a direction and a height of 0 to 90 degrees.</source>
        <translation>Ein Licht braucht eine Richtung und eine Höhe von 0 bis 90 Grad.</translation>
    </message>
    <message>
        <source>The radius of a relief image must be 0 (automatic) or more millimetres.</source>
        <translation>Der Radius eines Reliefbilds muss 0 (automatisch) oder mehr Millimeter sein.</translation>
    </message>
    <message>
        <source>This surface has no colours of its own. Choose another relief image.</source>
        <translation>Diese Oberfläche hat keine eigenen Farben. Wählen Sie ein anderes Reliefbild.</translation>
    </message>
    <message>
        <source>This surface has no intensities of its own. Choose another relief image.</source>
        <translation>Diese Oberfläche hat keine eigenen Intensitäten. Wählen Sie ein anderes Reliefbild.</translation>
    </message>
    <message>
        <source>Two pictures of one size are needed for an anaglyph.</source>
        <translation>Ein Anaglyphenbild braucht zwei Bilder gleicher Größe.</translation>
    </message>
    <message>
        <source>The plane of zero parallax, %1 mm, lies far from the heights here, %2 to %3 mm. Nothing was drawn. Choose one among them.</source>
        <translation>Die Nullebene der Parallaxe, %1 mm, liegt weit von den Höhen hier, %2 bis %3 mm. Nichts wurde gezeichnet. Wählen Sie eine dazwischen.</translation>
    </message>
    <message>
        <source>There is no level %1; this map has levels 0 to %2. Choose one of them.</source>
        <translation>Es gibt keine Ebene %1; diese Karte hat die Ebenen 0 bis %2. Wählen Sie eine davon.</translation>
    </message>
    <message>
        <source>A region needs a position and a width and height above 0, in millimetres. Nothing was changed.</source>
        <translation>Ein Ausschnitt braucht eine Lage sowie Breite und Höhe über 0, in Millimetern. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The region names a level that the pyramid does not have.</source>
        <translation>Der Ausschnitt nennt eine Ebene, die die Pyramide nicht hat.</translation>
    </message>
    <message>
        <source>A region needs a finite position and a side above 0 mm.</source>
        <translation>Ein Ausschnitt braucht eine endliche Lage und eine Seite über 0 mm.</translation>
    </message>
    <message>
        <source>The camera path &quot;%1&quot; needs at least two key views. Nothing was made.</source>
        <translation>Der Kamerapfad „%1“ braucht mindestens zwei Kamerapunkte. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>The camera path &quot;%1&quot; cannot be followed: key view %2 is not later than the one before it.</source>
        <translation>Dem Kamerapfad „%1“ kann nicht gefolgt werden: Kamerapunkt %2 liegt nicht später als der vorige.</translation>
    </message>
    <message>
        <source>The camera path &quot;%1&quot; cannot be followed: key view %2 has no size or no place.</source>
        <translation>Dem Kamerapfad „%1“ kann nicht gefolgt werden: Kamerapunkt %2 hat keine Größe oder keinen Ort.</translation>
    </message>
    <message>
        <source>A video&apos;s width in pixels must be %1 to %2. Nothing was made.</source>
        <translation>Die Breite eines Videos in Pixeln muss zwischen %1 und %2 liegen. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A video&apos;s height in pixels must be %1 to %2. Nothing was made.</source>
        <translation>Die Höhe eines Videos in Pixeln muss zwischen %1 und %2 liegen. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A video&apos;s frames per second must be %1 to %2. Nothing was made.</source>
        <translation>Die Zahl der Bilder je Sekunde eines Videos muss zwischen %1 und %2 liegen. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A video&apos;s speed must be %1 to %2. Nothing was made.</source>
        <translation>Das Tempo eines Videos muss zwischen %1 und %2 liegen. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A video&apos;s angle between the eyes in degrees must be %1 to %2. Nothing was made.</source>
        <translation>Der Winkel zwischen den Augen eines Videos in Grad muss zwischen %1 und %2 liegen. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A video&apos;s width and height must be even. Nothing was made.</source>
        <translation>Breite und Höhe eines Videos müssen gerade sein. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>A video needs a recording or a camera path. Nothing was made.</source>
        <translation>Ein Video braucht eine Aufzeichnung oder einen Kamerapfad. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>There is nothing between %1 s and %2 s: the recording is %3 s long. Nothing was made.</source>
        <translation>Zwischen %1 s und %2 s ist nichts: Die Aufnahme ist %3 s lang. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>There is nothing between %1 s and %2 s: the camera path is %3 s long. Nothing was made.</source>
        <translation>Zwischen %1 s und %2 s ist nichts: Der Kameraweg ist %3 s lang. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>This would be more than a million frames. Choose a part of the recording.</source>
        <translation>Das wären mehr als eine Million Bilder. Wählen Sie einen Teil der Aufzeichnung.</translation>
    </message>
    <message>
        <source>Cannot read %1: there is no such file. Check the name and the folder.</source>
        <translation>%1 kann nicht gelesen werden: Es gibt keine solche Datei. Prüfen Sie Name und Ordner.</translation>
    </message>
    <message>
        <source>Cannot read %1: this account may not read it. Change its permissions, or copy it.</source>
        <translation>%1 kann nicht gelesen werden: Dieses Konto darf es nicht. Ändern Sie die Rechte oder kopieren Sie die Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: its links lead in a circle. Choose the file itself.</source>
        <translation>%1 kann nicht gelesen werden: Die Verknüpfungen führen im Kreis. Wählen Sie die Datei selbst.</translation>
    </message>
    <message>
        <source>Cannot read %1: %2. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: %2. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a folder. Choose one of the files in it.</source>
        <translation>%1 kann nicht gelesen werden: Es ist ein Ordner. Wählen Sie eine der Dateien darin.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a pipe or device, not a file. Save the scan to a file first.</source>
        <translation>%1 kann nicht gelesen werden: Es ist eine Pipe oder ein Gerät, keine Datei. Speichern Sie den Scan zuerst in eine Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is empty (0 bytes). Copy or export it again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist leer (0 Bytes). Kopieren oder exportieren Sie sie erneut.</translation>
    </message>
    <message>
        <source>Cannot read %1 as a scan: it is %2. Open it as a raster.</source>
        <translation>%1 kann nicht als Scan gelesen werden: Es ist %2. Öffnen Sie es als Raster.</translation>
    </message>
    <message>
        <source>Cannot read %1: it has %2 bytes, more than the %3 that such a file may have. Nothing was loaded.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei hat %2 Bytes, mehr als die %3, die eine solche Datei haben darf. Nichts wurde geladen.</translation>
    </message>
    <message>
        <source>Cannot write %1 (%2). What was there is as before. Choose another folder or free some space.</source>
        <translation>%1 kann nicht geschrieben werden (%2). Was dort war, ist wie vorher. Wählen Sie einen anderen Ordner, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Cannot read %1: its header has no end (%2). Copy or export it again.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf hat kein Ende (%2). Kopieren oder exportieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 point|%2 points}, file ends at %3. Nothing was loaded. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht {2|%2 Punkt|%2 Punkte}, die Datei endet bei %3. Nichts wurde geladen. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 point|%2 points}, file ends at %3. Nothing was loaded. Load the {4|%4 complete point|%4 complete points}, or choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht {2|%2 Punkt|%2 Punkte}, die Datei endet bei %3. Nichts wurde geladen. Laden Sie {4|den %4 vollständigen Punkt|die %4 vollständigen Punkte}, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: it has {2|%2 point|%2 points}, none finite. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei hat {2|%2 Punkt, der nicht endlich ist|%2 Punkte, keiner ist endlich}. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: the system stopped the import, probably for lack of memory. Close other programs, or thin the scan out first.</source>
        <translation>%1 kann nicht gelesen werden: Das System hat das Lesen beendet, wahrscheinlich aus Speichermangel. Schließen Sie andere Programme oder dünnen Sie den Scan vorher aus.</translation>
    </message>
    <message>
        <source>Cannot read %1: its points have no %2 coordinate. Export it with x, y and z.</source>
        <translation>%1 kann nicht gelesen werden: Die Punkte haben keine Koordinate %2. Exportieren Sie die Datei mit x, y und z.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds no rows of numbers. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei enthält keine Zeilen mit Zahlen. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: it has 0 points. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei hat 0 Punkte. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds 0 triangles. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei enthält 0 Dreiecke. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: its header promises no vertices. Choose a file with points.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht keine Punkte. Wählen Sie eine Datei mit Punkten.</translation>
    </message>
    <message>
        <source>Cannot read %1: its header names no format. Export it again.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf nennt kein Format. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is shorter than the header of a LAS file. Copy or export it again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist kürzer als der Kopf einer LAS-Datei. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is shorter than the header of an E57 file. Copy or export it again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist kürzer als der Kopf einer E57-Datei. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is shorter than the header of an STL file. Copy or export it again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei ist kürzer als der Kopf einer STL-Datei. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: its points cannot be decoded. The file is damaged; export it again.</source>
        <translation>%1 kann nicht gelesen werden: Die Punkte lassen sich nicht entschlüsseln. Die Datei ist beschädigt; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it became shorter while it was read, or its disk failed. Try again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei wurde beim Lesen kürzer, oder ihr Datenträger versagte. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it was changed while it was read. Try again.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei wurde beim Lesen geändert. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a colour picture, not a height raster. Choose the raster with one band of heights.</source>
        <translation>%1 kann nicht gelesen werden: Es ist ein Farbbild, kein Höhenraster. Wählen Sie das Raster mit einem Band von Höhen.</translation>
    </message>
    <message>
        <source>Cannot read %1: its pixels are measured in degrees. Reproject it to metres, for example gdalwarp -t_srs EPSG:UTM-ZONE.</source>
        <translation>%1 kann nicht gelesen werden: Die Pixel sind in Grad gemessen. Rechnen Sie die Datei in Meter um, zum Beispiel gdalwarp -t_srs EPSG:UTM-ZONE.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds the colours of a map&apos;s cells, not heights. Open the map beside it.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei enthält die Farben der Zellen einer Karte, keine Höhen. Öffnen Sie die Karte daneben.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds the intensities of a map&apos;s cells, not heights. Open the map beside it.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei enthält die Intensitäten der Zellen einer Karte, keine Höhen. Öffnen Sie die Karte daneben.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number from -1e12 to 1e12.</source>
        <translation>%1: „%2“ ist keine Zahl von -1e12 bis 1e12.</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number.</source>
        <translation>%1: %2 ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>%1: there is no &apos;%2&apos;; there are %3.</source>
        <translation>%1: „%2“ gibt es nicht; es gibt %3.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is none of %3.</source>
        <translation>%1: „%2“ ist keines von %3.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither %3 nor %4.</source>
        <translation>%1: „%2“ ist weder %3 noch %4.</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3.</source>
        <translation>%1 muss zwischen %2 und %3 liegen.</translation>
    </message>
    <message>
        <source>%1 needs {2|%2 number|%2 numbers} separated by commas, not &apos;%3&apos;.</source>
        <translation>%1 braucht {2|%2 Zahl|%2 Zahlen} mit Kommas dazwischen, nicht „%3“.</translation>
    </message>
    <message>
        <source>%1 needs %2. Nothing was made. Give that as well, or leave %1 out.</source>
        <translation>%1 braucht %2. Nichts wurde gemacht. Geben Sie das auch an, oder lassen Sie %1 weg.</translation>
    </message>
    <message>
        <source>--parts: &apos;%1&apos; is no list of scan numbers from 1, such as 1,3.</source>
        <translation>--parts: „%1“ ist keine Liste von Nummern der Scans ab 1, wie 1,3.</translation>
    </message>
    <message>
        <source>--holes: the largest area must not be below 0.</source>
        <translation>--holes: Die größte Fläche darf nicht unter 0 liegen.</translation>
    </message>
    <message>
        <source>--cells must be at least 2.</source>
        <translation>--cells muss mindestens 2 sein.</translation>
    </message>
    <message>
        <source>--spacing must be above 0 mm.</source>
        <translation>--spacing muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>Give --cells or --spacing, not both.</source>
        <translation>Geben Sie --cells oder --spacing an, nicht beide.</translation>
    </message>
    <message>
        <source>--factor must be from 1.1 to 8.</source>
        <translation>--factor muss zwischen 1.1 und 8 liegen.</translation>
    </message>
    <message>
        <source>--memory must be a number of megabytes above 0.</source>
        <translation>--memory muss eine Zahl von Megabytes über 0 sein.</translation>
    </message>
    <message>
        <source>--memory must be from 64 MB to 1000000000 MB.</source>
        <translation>--memory muss zwischen 64 MB und 1000000000 MB liegen.</translation>
    </message>
    <message>
        <source>--light: the elevation must be between 0 and 90 degrees.</source>
        <translation>--light: Die Höhe muss zwischen 0 und 90 Grad liegen.</translation>
    </message>
    <message>
        <source>--radius: it must be 0 (automatic) or more millimetres.</source>
        <translation>--radius: Er muss 0 (automatisch) oder mehr Millimeter sein.</translation>
    </message>
    <message>
        <source>--shading: it must be between 0, as photographed, and 1.</source>
        <translation>--shading: Sie muss zwischen 0, wie fotografiert, und 1 liegen.</translation>
    </message>
    <message>
        <source>--quality is for maps that are made in memory. Leave out --memory.</source>
        <translation>--quality ist für Karten, die im Speicher gemacht werden. Lassen Sie --memory weg.</translation>
    </message>
    <message>
        <source>a raster has no points to be read.</source>
        <translation>ein Raster hat keine Punkte, die gelesen werden könnten.</translation>
    </message>
    <message>
        <source>--scale: &apos;%1&apos; is not of the form 1:N. Nothing was drawn.</source>
        <translation>--scale: „%1“ hat nicht die Form 1:N. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>--scale: the width follows from it. Leave out --width-mm, or --scale.</source>
        <translation>--scale: Die Breite folgt daraus. Lassen Sie --width-mm weg, oder --scale.</translation>
    </message>
    <message>
        <source>--measure: &apos;%1&apos; is not of the form NAME:KIND:X,Y;X,Y.</source>
        <translation>--measure: „%1“ hat nicht die Form NAME:KIND:X,Y;X,Y.</translation>
    </message>
    <message>
        <source>--measure: &apos;%1&apos; has two planes.</source>
        <translation>--measure: „%1“ hat zwei Ebenen.</translation>
    </message>
    <message>
        <source>Give one of --from-image and --project. Nothing was drawn.</source>
        <translation>Geben Sie eines von --from-image und --project an. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>Give FILE, --project or --from-image. Nothing was drawn.</source>
        <translation>Geben Sie FILE, --project oder --from-image an. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>--%1: the image says this already. Leave it out, or leave out --from-image. Nothing was drawn.</source>
        <translation>--%1: Das Bild sagt das schon. Lassen Sie es weg, oder lassen Sie --from-image weg. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>--%1: the project says this already. Leave it out, or leave out --project. Nothing was drawn.</source>
        <translation>--%1: Das Projekt sagt das schon. Lassen Sie es weg, oder lassen Sie --project weg. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>%1 shows no region that relievo could draw again. Nothing was made. Choose a picture or log as relievo wrote it; other programs may drop what is inside.</source>
        <translation>%1 zeigt keinen Ausschnitt, den relievo noch einmal zeichnen könnte. Nichts wurde gemacht. Wählen Sie ein Bild oder eine Aufzeichnung, wie relievo sie schrieb; andere Programme werfen manchmal weg, was darin ist.</translation>
    </message>
    <message>
        <source>The map of &apos;%1&apos; has no level %2. Nothing was drawn.</source>
        <translation>Die Karte von „%1“ hat keine Ebene %2. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>--pixels: of two pictures in one file each has %1 to %2. Nothing was drawn.</source>
        <translation>--pixels: Von zwei Bildern in einer Datei hat jedes %1 bis %2. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>A picture&apos;s name ends in .png or .tif; &apos;%1&apos; does not. Nothing was drawn.</source>
        <translation>Der Name eines Bildes endet auf .png oder .tif; „%1“ tut das nicht. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not one of its words.</source>
        <translation>%1: „%2“ ist keines seiner Wörter.</translation>
    </message>
    <message>
        <source>--size must be WIDTHxHEIGHT, like 1280x720.</source>
        <translation>--size muss BREITExHÖHE sein, wie 1280x720.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; does not say how its map was made; an older version wrote it. Nothing was made. Replay it in the window on the open map.</source>
        <translation>Die Aufzeichnung „%1“ sagt nicht, wie ihre Karte gemacht wurde; eine ältere Version schrieb sie. Nichts wurde gemacht. Spielen Sie sie im Fenster auf der geöffneten Karte ab.</translation>
    </message>
    <message>
        <source>--frame: there {1|is %1 frame|are %1 frames}, counted from 0. Nothing was drawn.</source>
        <translation>--frame: Es gibt {1|%1 Bild|%1 Bilder}, ab 0 gezählt. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>The project &quot;%1&quot; has no camera path. Nothing was made. Add key views in the window.</source>
        <translation>Das Projekt „%1“ hat keinen Kameraweg. Nichts wurde gemacht. Fügen Sie im Fenster Kamerapunkte hinzu.</translation>
    </message>
    <message>
        <source>Give a recording, or a project with --path. Nothing was made.</source>
        <translation>Geben Sie eine Aufzeichnung an, oder ein Projekt mit --path. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>--classes: a class is from 0 to 255.</source>
        <translation>--classes: Eine Klasse geht von 0 bis 255.</translation>
    </message>
    <message>
        <source>--sparse needs two or three numbers separated by commas, not &apos;%1&apos;.</source>
        <translation>--sparse braucht zwei oder drei Zahlen mit Kommas dazwischen, nicht „%1“.</translation>
    </message>
    <message>
        <source>--reference: scans are counted from 1.</source>
        <translation>--reference: Scans werden ab 1 gezählt.</translation>
    </message>
    <message>
        <source>--reference needs more than one FILE.</source>
        <translation>--reference braucht mehr als ein FILE.</translation>
    </message>
    <message>
        <source>--seed belongs to --align and --base. Give one, or leave it out.</source>
        <translation>--seed gehört zu --align und --base. Geben Sie eines an, oder lassen Sie es weg.</translation>
    </message>
    <message>
        <source>%1: the recipe says what is done. Leave one of them out.</source>
        <translation>%1: Das Rezept sagt, was getan wird. Lassen Sie eines von beiden weg.</translation>
    </message>
    <message>
        <source>The reference is scan %1, but there {2|is|are} only %2.</source>
        <translation>Die Referenz ist Scan %1, aber es gibt nur %2.</translation>
    </message>
    <message>
        <source>There is no FILE to prepare. Nothing was done.</source>
        <translation>Es gibt kein FILE zum Aufbereiten. Nichts wurde getan.</translation>
    </message>
    <message>
        <source>%1, line %2: %3. Nothing was done. Its first line is %4; then one pair a line.</source>
        <translation>%1, Zeile %2: %3. Nichts wurde getan. Die erste Zeile ist %4; dann ein Paar je Zeile.</translation>
    </message>
    <message>
        <source>-o: &apos;%1&apos; is no .ply. Nothing was done.</source>
        <translation>-o: „%1“ ist keine .ply-Datei. Nichts wurde getan.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs &apos;%2&apos;, which the package does not hold. Nothing outside of it was read. Ask whoever made it for a whole one.</source>
        <translation>„%1“ braucht „%2“, was das Paket nicht enthält. Nichts außerhalb davon wurde gelesen. Bitten Sie den Ersteller um ein vollständiges.</translation>
    </message>
    <message>
        <source>The package does not hold its input, so that nothing can be replayed. Give the file with --input; its checksum is %1.</source>
        <translation>Das Paket enthält seine Eingabe nicht, so dass nichts wiederholt werden kann. Geben Sie die Datei mit --input an; ihre Prüfsumme ist %1.</translation>
    </message>
    <message>
        <source>No folder to unpack the package can be made. Set TMPDIR to another one.</source>
        <translation>Zum Auspacken des Pakets kann kein Ordner gemacht werden. Setzen Sie TMPDIR auf einen anderen.</translation>
    </message>
    <message>
        <source>--output is for a single recording; a package is only checked. Nothing was replayed. Leave it out.</source>
        <translation>--output ist für eine einzelne Aufzeichnung; ein Paket wird nur geprüft. Nichts wurde wiederholt. Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; lacks its last lines: the program or the computer ended while it recorded, or the disk was full. It cannot be verified. Show it with Record &gt; Replay, or make a video.</source>
        <translation>Der Aufzeichnung „%1“ fehlen die letzten Zeilen: Das Programm oder der Computer endete während der Aufnahme, oder der Datenträger war voll. Sie kann nicht geprüft werden. Zeigen Sie sie mit Aufzeichnen &gt; Abspielen, oder machen Sie ein Video.</translation>
    </message>
    <message>
        <source>The log &quot;%1&quot; does not say what made it; only logs of touch, record and the window can be replayed.</source>
        <translation>Die Aufzeichnung „%1“ sagt nicht, was sie gemacht hat; nur Aufzeichnungen von touch, record und dem Fenster können wiederholt werden.</translation>
    </message>
    <message>
        <source>The log was made by a command that this version does not understand: %1.</source>
        <translation>Die Aufzeichnung wurde von einem Befehl gemacht, den diese Version nicht versteht: %1.</translation>
    </message>
    <message>
        <source>Window %1 is not what was touched: its depth map cannot be made again as it was. Nothing was replayed.</source>
        <translation>Ausschnitt %1 ist nicht, was ertastet wurde: Seine Tiefenkarte kann nicht wieder so gemacht werden, wie sie war. Nichts wurde wiederholt.</translation>
    </message>
    <message>
        <source>The map of the recording has no level %1. Nothing was replayed.</source>
        <translation>Die Karte der Aufzeichnung hat keine Ebene %1. Nichts wurde wiederholt.</translation>
    </message>
    <message>
        <source>The recording does not say how one of its maps was made. Nothing was replayed.</source>
        <translation>Die Aufzeichnung sagt nicht, wie eine ihrer Karten gemacht wurde. Nichts wurde wiederholt.</translation>
    </message>
    <message>
        <source>project new needs -o PROJECT.json.</source>
        <translation>project new braucht -o PROJECT.json.</translation>
    </message>
    <message>
        <source>project package needs -o PACKAGE.zip.</source>
        <translation>project package braucht -o PACKAGE.zip.</translation>
    </message>
    <message>
        <source>%1 shows no region, so that no project can be made from it. Choose a picture or log that relievo wrote.</source>
        <translation>%1 zeigt keinen Ausschnitt, so dass kein Projekt daraus gemacht werden kann. Wählen Sie ein Bild oder eine Aufzeichnung, die relievo schrieb.</translation>
    </message>
    <message>
        <source>%1 is a recording of %2, and %3 shows another file. No project was written. Leave it out.</source>
        <translation>%1 ist eine Aufzeichnung von %2, und %3 zeigt eine andere Datei. Kein Projekt wurde geschrieben. Lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>%1 belongs to project %2, not to %3. Nothing was done. Leave it out.</source>
        <translation>%1 gehört zu project %2, nicht zu %3. Nichts wurde getan. Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is a package for citation, not a scan. &apos;relievo project info&apos; says what it holds, &apos;relievo project verify&apos; whether all of it is as it was packed.</source>
        <translation>%1 kann nicht gelesen werden: Es ist ein Paket zum Zitieren, kein Scan. „relievo project info“ sagt, was es enthält, „relievo project verify“, ob alles darin noch so ist, wie es gepackt wurde.</translation>
    </message>
    <message>
        <source>--relief: &apos;%1&apos; has no values of the relief. Choose another, or &apos;relievo render&apos;; colours are written beside a map without --relief.</source>
        <translation>--relief: „%1“ hat keine Werte des Reliefs. Wählen Sie ein anderes, oder &apos;relievo render&apos;; Farben werden ohne --relief neben eine Karte geschrieben.</translation>
    </message>
    <message>
        <source>--relief: its values go into .tif or .asc, not into &apos;%1&apos;.</source>
        <translation>--relief: Seine Werte gehen in .tif oder .asc, nicht in „%1“.</translation>
    </message>
    <message>
        <source>--relief paints the whole map. Leave out --level and --region.</source>
        <translation>--relief malt die ganze Karte. Lassen Sie --level und --region weg.</translation>
    </message>
    <message>
        <source>%1: its ending is none of .tif, .asc, .vti, .ply, .xyz, .stl and .glb.</source>
        <translation>%1: Die Endung ist keine von .tif, .asc, .vti, .ply, .xyz, .stl und .glb.</translation>
    </message>
    <message>
        <source>--light and --radius belong to --relief. Give it, or leave them out.</source>
        <translation>--light und --radius gehören zu --relief. Geben Sie es an, oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>%1 needs x and y of {2|%2 place|%2 places}, not &apos;%3&apos;.</source>
        <translation>%1 braucht x und y von {2|%2 Stelle|%2 Stellen}, nicht „%3“.</translation>
    </message>
    <message>
        <source>%1 needs x and y of at least {2|%2 place|%2 places}, not &apos;%3&apos;.</source>
        <translation>%1 braucht x und y von mindestens {2|%2 Stelle|%2 Stellen}, nicht „%3“.</translation>
    </message>
    <message>
        <source>There is nothing to measure. Give --point, --distance, --depth, --angle, --profile, --area or --section.</source>
        <translation>Es gibt nichts zu messen. Geben Sie --point, --distance, --depth, --angle, --profile, --area oder --section an.</translation>
    </message>
    <message>
        <source>%1 is for one --%2; there are more.</source>
        <translation>%1 ist für ein --%2; es gibt mehr.</translation>
    </message>
    <message>
        <source>%1 needs a --%2.</source>
        <translation>%1 braucht ein --%2.</translation>
    </message>
    <message>
        <source>%1: the file&apos;s name must end with %2, not &apos;%3&apos;. Nothing was written.</source>
        <translation>%1: Der Name der Datei muss auf %2 enden, nicht „%3“. Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>There is nothing to plot: the stroke has no ticks.</source>
        <translation>Es gibt nichts zu zeichnen: Der Strich hat keine Takte.</translation>
    </message>
    <message>
        <source>--stiffness must be above 0 N/mm.</source>
        <translation>--stiffness muss über 0 N/mm liegen.</translation>
    </message>
    <message>
        <source>--level-stiffness must be above 0 N/mm at every level.</source>
        <translation>--level-stiffness muss auf jeder Ebene über 0 N/mm liegen.</translation>
    </message>
    <message>
        <source>--stiffness is one for all levels. Nothing was touched. Leave it out, or --level-stiffness.</source>
        <translation>--stiffness ist eine für alle Ebenen. Nichts wurde ertastet. Lassen Sie sie weg, oder --level-stiffness.</translation>
    </message>
    <message>
        <source>--friction: the paper&apos;s proxies know no friction; use --proxy converged.</source>
        <translation>--friction: Die Proxys des Aufsatzes kennen keine Reibung; verwenden Sie --proxy converged.</translation>
    </message>
    <message>
        <source>--friction must be 0 to %1, the static coefficient not below the dynamic one.</source>
        <translation>--friction muss 0 bis %1 sein, der Haftbeiwert nicht unter dem Gleitbeiwert.</translation>
    </message>
    <message>
        <source>--device: a stroke cannot move &apos;%1&apos;, which a person holds. Use virtual, or record without a stroke.</source>
        <translation>--device: Ein Strich kann „%1“ nicht bewegen, das jemand hält. Verwenden Sie virtual, oder zeichnen Sie ohne Strich auf.</translation>
    </message>
    <message>
        <source>--seconds must be above 0 and at most 86400.</source>
        <translation>--seconds muss über 0 und höchstens 86400 sein.</translation>
    </message>
    <message>
        <source>--safety off is for a simulated hand, and a person holds the device &apos;%1&apos;. Nothing was recorded. Leave it out, or record with --device virtual.</source>
        <translation>--safety off ist für eine simulierte Hand, und das Gerät „%1“ hält jemand. Nichts wurde aufgezeichnet. Lassen Sie es weg, oder zeichnen Sie mit --device virtual auf.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the form of a boot image, but nobody knows this one (sha256 %2). Nothing was installed. Add --accept if you trust it.</source>
        <translation>„%1“ hat die Form eines Startabbilds, aber niemand kennt dieses (sha256 %2). Nichts wurde installiert. Fügen Sie --accept hinzu, wenn Sie ihm trauen.</translation>
    </message>
    <message>
        <source>--device: &apos;%1&apos; names no Falcon. Nothing was tried. Use an id of &apos;relievo devices&apos;.</source>
        <translation>--device: „%1“ nennt keinen Falcon. Nichts wurde versucht. Verwenden Sie eine Kennung aus &apos;relievo devices&apos;.</translation>
    </message>
    <message>
        <source>The input ended before Enter said that the weight hangs. The old setting is kept. Run it at a terminal.</source>
        <translation>Die Eingabe endete, bevor Enter sagte, dass das Gewicht hängt. Die alte Einstellung bleibt. Führen Sie es an einem Terminal aus.</translation>
    </message>
    <message>
        <source>The computer goes to sleep; the forces are off and this has ended. Begin again when it is awake.</source>
        <translation>Der Computer geht schlafen; die Kräfte sind aus, und dies ist beendet. Beginnen Sie noch einmal, wenn er wach ist.</translation>
    </message>
    <message>
        <source>The computer goes to sleep; the forces are off and this has ended. The old setting is kept. Begin again when it is awake.</source>
        <translation>Der Computer geht schlafen; die Kräfte sind aus, und dies ist beendet. Die alte Einstellung bleibt. Beginnen Sie noch einmal, wenn er wach ist.</translation>
    </message>
    <message>
        <source>%1 names &apos;%2&apos;, which lies outside of its folder and is not, by a checksum, what it was made from. It was not read, and nothing was made. %3 --outside-files allow reads it all the same.</source>
        <translation>%1 nennt „%2“, was außerhalb des eigenen Ordners liegt und nach der Prüfsumme nicht das ist, woraus es gemacht wurde. Es wurde nicht gelesen, und nichts wurde gemacht. %3 --outside-files allow liest es trotzdem.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the file that %2 was made from (checksum differs, E501). Nothing was made. Give the right one as FILE, or --changed-input to use this one.</source>
        <translation>„%1“ ist nicht die Datei, aus der %2 gemacht wurde (Prüfsumme verschieden, E501). Nichts wurde gemacht. Geben Sie die richtige als FILE an, oder --changed-input, um diese zu verwenden.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the file that %2 was made for (checksum differs, E501). Nothing was done. Give the file by its name to use it all the same.</source>
        <translation>„%1“ ist nicht die Datei, für die %2 gemacht wurde (Prüfsumme verschieden, E501). Nichts wurde getan. Geben Sie die Datei mit ihrem Namen an, um sie trotzdem zu verwenden.</translation>
    </message>
    <message>
        <source>Recording stopped: disk full. {1|%1 sample is|%1 samples are} saved and complete in &quot;%2&quot;.</source>
        <translation>Aufnahme beendet: Datenträger voll. {1|%1 Abtastwert ist|%1 Abtastwerte sind} gespeichert und vollständig in „%2“.</translation>
    </message>
    <message>
        <source>Recording stopped: HDF5 could not write. {1|%1 sample is|%1 samples are} saved and complete in &quot;%2&quot;.</source>
        <translation>Aufnahme beendet: HDF5 konnte nicht schreiben. {1|%1 Abtastwert ist|%1 Abtastwerte sind} gespeichert und vollständig in „%2“.</translation>
    </message>
    <message>
        <source>Recording stopped: %1. {2|%2 sample is|%2 samples are} saved and complete in &quot;%3&quot;.</source>
        <translation>Aufnahme beendet: %1. {2|%2 Abtastwert ist|%2 Abtastwerte sind} gespeichert und vollständig in „%3“.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be written: disk full. Nothing was kept. Free some space or choose another place.</source>
        <translation>Die Aufnahme „%1“ kann nicht geschrieben werden: Der Datenträger ist voll. Nichts wurde behalten. Schaffen Sie Platz oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be written: HDF5 refuses it. Choose another place.</source>
        <translation>Die Aufzeichnung „%1“ kann nicht geschrieben werden: HDF5 verweigert es. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be written: %2. Choose another place.</source>
        <translation>Die Aufzeichnung „%1“ kann nicht geschrieben werden: %2. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; may be incomplete.</source>
        <translation>Die Aufzeichnung „%1“ ist vielleicht unvollständig.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; may be incomplete: %2.</source>
        <translation>Die Aufzeichnung „%1“ ist vielleicht unvollständig: %2.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; is being written by another program. Nothing was recorded. Choose another name, or end the other one first.</source>
        <translation>Die Aufzeichnung &quot;%1&quot; wird gerade von einem anderen Programm geschrieben. Es wurde nichts aufgezeichnet. Wählen Sie einen anderen Namen, oder beenden Sie die andere zuerst.</translation>
    </message>
    <message>
        <source>The recording is whole, but it cannot be called &quot;%1&quot;: %2. It is in &quot;%3&quot;.</source>
        <translation>Die Aufzeichnung ist vollständig, kann aber nicht &quot;%1&quot; heißen: %2. Sie liegt in &quot;%3&quot;.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; for recordings cannot be made. Nothing is recorded. Choose another one.</source>
        <translation>Der Ordner „%1“ für Aufnahmen kann nicht angelegt werden. Nichts wird aufgenommen. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>no fault</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>the device did not answer in time</source>
        <translation>das Gerät hat nicht rechtzeitig geantwortet</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>das Gerät wurde getrennt</translation>
    </message>
    <message>
        <source>the device sent something unreadable</source>
        <translation>das Gerät hat Unlesbares gesendet</translation>
    </message>
    <message>
        <source>the device is too hot</source>
        <translation>das Gerät ist zu heiß</translation>
    </message>
    <message>
        <source>the device reported an impossible position</source>
        <translation>das Gerät meldet eine unmögliche Position</translation>
    </message>
    <message>
        <source>the device is not ready yet</source>
        <translation>das Gerät ist noch nicht bereit</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpoliert</translation>
    </message>
    <message>
        <source>base plane</source>
        <translation>Grundebene</translation>
    </message>
    <message>
        <source>steep</source>
        <translation>steil</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Whole object</source>
        <translation>Ganzes Objekt</translation>
    </message>
    <message>
        <source>Where am I</source>
        <translation>Wo bin ich</translation>
    </message>
    <message>
        <source>Where am I, in full</source>
        <translation>Wo bin ich, ausführlich</translation>
    </message>
    <message>
        <source>Forces on or off</source>
        <translation>Kräfte ein oder aus</translation>
    </message>
    <message>
        <source>Forces off</source>
        <translation>Kräfte aus</translation>
    </message>
    <message>
        <source>Move mode</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Verschoben</translation>
    </message>
    <message>
        <source>Back to the old window</source>
        <translation>Zurück zum alten Ausschnitt</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Introduction</source>
        <translation>Einführung</translation>
    </message>
    <message>
        <source>The Falcon is not in use.</source>
        <translation>Der Falcon wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Falcon unplugged. Forces off. View and recording go on. Plug it in again, or choose the mouse as the device.</source>
        <translation>Falcon getrennt. Kräfte aus. Ansicht und Aufzeichnung gehen weiter. Stecken Sie ihn wieder an oder wählen Sie die Maus als Gerät.</translation>
    </message>
    <message>
        <source>Falcon unplugged. Forces are off.</source>
        <translation>Falcon getrennt. Kräfte sind aus.</translation>
    </message>
    <message>
        <source>Falcon unplugged. Forces off. View and recording go on. Plug it in again. There is also %1, which is not used in its place unless you choose it.</source>
        <translation>Falcon abgezogen. Kräfte aus. Ansicht und Aufnahme laufen weiter. Stecken Sie ihn wieder ein. Es gibt noch %1; er wird nicht an seiner Stelle benutzt, solange Sie ihn nicht wählen.</translation>
    </message>
    <message>
        <source>No Falcon is plugged in. Plug in its power supply, then its USB cable.</source>
        <translation>Es ist kein Falcon angeschlossen. Schließen Sie sein Netzteil an, dann sein USB-Kabel.</translation>
    </message>
    <message>
        <source>No Falcon is plugged in.</source>
        <translation>Es ist kein Falcon angeschlossen.</translation>
    </message>
    <message>
        <source>%1 was chosen and is not plugged in. Plug in its power supply, then its USB cable.</source>
        <translation>%1 wurde gewählt und ist nicht angeschlossen. Schließen Sie sein Netzteil an, dann sein USB-Kabel.</translation>
    </message>
    <message>
        <source>The chosen Falcon is not plugged in.</source>
        <translation>Der gewählte Falcon ist nicht angeschlossen.</translation>
    </message>
    <message>
        <source>%1 was chosen and is not plugged in. There is %2, which is not used in its place unless you choose it.</source>
        <translation>%1 wurde gewählt und ist nicht angeschlossen. Da ist %2; er wird nicht an seiner Stelle benutzt, solange Sie ihn nicht wählen.</translation>
    </message>
    <message>
        <source>Several Falcons are plugged in: %1. None is used until you choose one.</source>
        <translation>Mehrere Falcons sind angeschlossen: %1. Keiner wird benutzt, bis Sie einen wählen.</translation>
    </message>
    <message>
        <source>Several Falcons are plugged in. Choose one.</source>
        <translation>Mehrere Falcons sind angeschlossen. Wählen Sie einen.</translation>
    </message>
    <message>
        <source>A Falcon is plugged in but this account may not use it. Install the rule that the device set-up shows and &apos;relievo devices rule&apos; prints, once (needs an administrator), then replug.</source>
        <translation>Ein Falcon ist angeschlossen, aber dieses Konto darf ihn nicht benutzen. Installieren Sie einmal die Regel, die „Gerät einrichten“ zeigt und „relievo devices rule“ ausgibt (dazu braucht es einen Verwalter), und stecken Sie ihn neu an.</translation>
    </message>
    <message>
        <source>Falcon found, but not allowed. Ask staff.</source>
        <translation>Falcon gefunden, aber nicht erlaubt. Fragen Sie das Personal.</translation>
    </message>
    <message>
        <source>Another program is using the Falcon. Close it, then try again.</source>
        <translation>Ein anderes Programm benutzt den Falcon. Schließen Sie es und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon is busy.</source>
        <translation>Der Falcon ist besetzt.</translation>
    </message>
    <message>
        <source>The Falcon could not be opened: %1. Replug it, or try another port.</source>
        <translation>Der Falcon konnte nicht geöffnet werden: %1. Stecken Sie ihn neu an oder versuchen Sie einen anderen Anschluss.</translation>
    </message>
    <message>
        <source>The Falcon could not be opened.</source>
        <translation>Der Falcon konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>USB cannot be used</source>
        <translation>USB ist nicht benutzbar</translation>
    </message>
    <message>
        <source>Asking the Falcon whether it is ready.</source>
        <translation>Der Falcon wird gefragt, ob er bereit ist.</translation>
    </message>
    <message>
        <source>Falcon found.</source>
        <translation>Falcon gefunden.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware file.</source>
        <translation>Der Falcon braucht seine Firmware-Datei.</translation>
    </message>
    <message>
        <source>Starting the Falcon – attempt %1 of %2. This is normal.</source>
        <translation>Der Falcon wird gestartet – Versuch %1 von %2. Das ist normal.</translation>
    </message>
    <message>
        <source>Starting the Falcon.</source>
        <translation>Der Falcon wird gestartet.</translation>
    </message>
    <message>
        <source>Still starting.</source>
        <translation>Startet noch.</translation>
    </message>
    <message>
        <source>The connection to the Falcon failed {1|%1 time|%1 times}, although it is plugged in. Forces are off; it is tried again every 10 seconds. Plug it straight into the computer, if you can with another cable, or choose Touch &gt; Device set-up &gt; Retry.</source>
        <translation>Die Verbindung zum Falcon ist %1-mal gescheitert, obwohl er eingesteckt ist. Die Kräfte sind aus; alle 10 Sekunden wird es noch einmal versucht. Stecken Sie ihn direkt am Computer ein, möglichst mit einem anderen Kabel, oder wählen Sie Fühlen &gt; Gerät einrichten &gt; Noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Forces are off.</source>
        <translation>Der Falcon antwortet nicht. Kräfte sind aus.</translation>
    </message>
    <message>
        <source>The Falcon did not start after {1|%1 attempt|%1 attempts}; it is left alone now. Check its power supply and plug it straight into the computer, or choose Touch &gt; Device set-up &gt; Retry.</source>
        <translation>Der Falcon ist nach {1|%1 Versuch|%1 Versuchen} nicht gestartet; er wird jetzt in Ruhe gelassen. Prüfen Sie sein Netzteil und stecken Sie ihn direkt am Rechner an, oder wählen Sie Fühlen &gt; Gerät einrichten &gt; Noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon did not start. You can continue with the mouse.</source>
        <translation>Der Falcon ist nicht gestartet. Sie können mit der Maus weitermachen.</translation>
    </message>
    <message>
        <source>The Falcon did not start after {1|%1 attempt|%1 attempts}; it is left alone now. Check its power supply and plug it straight into the computer, or choose Touch &gt; Device set-up &gt; Retry. (%2)</source>
        <translation>Der Falcon ist nach {1|%1 Versuch|%1 Versuchen} nicht gestartet; er wird jetzt in Ruhe gelassen. Prüfen Sie sein Netzteil und stecken Sie ihn direkt am Rechner an, oder wählen Sie Fühlen &gt; Gerät einrichten &gt; Noch einmal. (%2)</translation>
    </message>
    <message>
        <source>its boot loader did not answer</source>
        <translation>sein Startprogramm hat nicht geantwortet</translation>
    </message>
    <message>
        <source>it did not lock on to the baud rate</source>
        <translation>er hat sich nicht auf die Baudrate eingestellt</translation>
    </message>
    <message>
        <source>it echoed wrongly after byte %1 of %2</source>
        <translation>nach Byte %1 von %2 kam ein falsches Echo</translation>
    </message>
    <message>
        <source>it did not run after loading</source>
        <translation>er lief nach dem Laden nicht</translation>
    </message>
    <message>
        <source>Please pull the grip fully out, then push it fully in. Still missing: %1.</source>
        <translation>Bitte ziehen Sie den Griff ganz heraus und drücken Sie ihn dann ganz hinein. Es fehlen noch die Arme: %1.</translation>
    </message>
    <message>
        <source>Please pull the grip fully out, then push it fully in.</source>
        <translation>Bitte ziehen Sie den Griff ganz heraus und drücken Sie ihn dann ganz hinein.</translation>
    </message>
    <message>
        <source>Please pull the grip fully out, then push it fully in. Still missing: %1. It takes long: pull straight out, push straight in, as far as it goes; do not twist.</source>
        <translation>Bitte ziehen Sie den Griff ganz heraus und drücken Sie ihn dann ganz hinein. Es fehlen noch die Arme: %1. Es dauert lange: gerade herausziehen, gerade hineindrücken, so weit es geht; nicht drehen.</translation>
    </message>
    <message>
        <source>Straight out, straight in; do not twist the grip.</source>
        <translation>Gerade heraus, gerade hinein; den Griff nicht drehen.</translation>
    </message>
    <message>
        <source>All three arms have found their place. Pull the grip fully out once more.</source>
        <translation>Alle drei Arme haben ihren Ort gefunden. Ziehen Sie den Griff noch einmal ganz heraus.</translation>
    </message>
    <message>
        <source>Pull the grip fully out.</source>
        <translation>Ziehen Sie den Griff ganz heraus.</translation>
    </message>
    <message>
        <source>Falcon ready.</source>
        <translation>Falcon bereit.</translation>
    </message>
    <message>
        <source>The connection to the Falcon fails, although it is plugged in. Forces are off; it is opened anew – %1 of %2.</source>
        <translation>Die Verbindung zum Falcon scheitert, obwohl er eingesteckt ist. Die Kräfte sind aus; er wird neu geöffnet – %1 von %2.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Forces are off; trying to wake it.</source>
        <translation>Der Falcon antwortet nicht. Die Kräfte sind aus; es wird versucht, ihn zu wecken.</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>Minus</translation>
    </message>
    <message>
        <source>USB cannot be used: %1.</source>
        <translation>USB ist nicht benutzbar: %1.</translation>
    </message>
    <message>
        <source>The Falcon&apos;s thread could not be started: %1.</source>
        <translation>Der Thread des Falcon konnte nicht gestartet werden: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no Falcon. Write falcon:SERIAL, falcon:SERIAL@PORT or falcon:@PORT as &apos;relievo devices&apos; lists them, or falcon for the only one.</source>
        <translation>„%1“ benennt keinen Falcon. Schreiben Sie falcon:SERIAL, falcon:SERIAL@PORT oder falcon:@PORT, wie &apos;relievo devices&apos; sie auflistet, oder falcon für den einzigen.</translation>
    </message>
    <message>
        <source>There is no mouse device named &quot;%1&quot;.</source>
        <translation>Es gibt kein Mausgerät namens „%1“.</translation>
    </message>
    <message>
        <source>There is no device &quot;%1&quot;. This build knows: %2.</source>
        <translation>Es gibt kein Gerät „%1“. Dieses Programm kennt: %2.</translation>
    </message>
    <message>
        <source>HID devices cannot be used on this system.</source>
        <translation>HID-Geräte können auf diesem System nicht verwendet werden.</translation>
    </message>
    <message>
        <source>There is no virtual hand &quot;%1&quot;. Known: %2.</source>
        <translation>Es gibt keine virtuelle Hand „%1“. Bekannt: %2.</translation>
    </message>
    <message>
        <source>The virtual hand&apos;s delay is {1|%1 tick|%1 ticks}; 0, 1 and 2 are possible.</source>
        <translation>Die Verzögerung der virtuellen Hand ist {1|%1 Takt|%1 Takte}; 0, 1 und 2 sind möglich.</translation>
    </message>
    <message>
        <source>A scripted device needs at least one reading.</source>
        <translation>Ein Gerät nach Vorschrift braucht mindestens eine Ablesung.</translation>
    </message>
    <message>
        <source>The test ended early: %1. %2</source>
        <translation>Der Selbsttest endete vorzeitig: %1. %2</translation>
    </message>
    <message>
        <source>Rate: %1 answers per second (%2 are needed).</source>
        <translation>Rate: %1 Antworten je Sekunde (%2 sind nötig).</translation>
    </message>
    <message>
        <source>Line: {1|%1 damaged answer|%1 damaged answers}, {2|%2 stall|%2 stalls}, {3|%3 overrun|%3 overruns}.</source>
        <translation>Leitung: {1|%1 beschädigte Antwort|%1 beschädigte Antworten}, {2|%2 Stockung|%2 Stockungen}, {3|%3 Überlauf|%3 Überläufe}.</translation>
    </message>
    <message>
        <source>Times from answer to answer: up to 0.8 ms %1, up to 1.0 ms %2, up to 1.2 ms %3, up to 2.0 ms %4, up to 5.0 ms %5, up to 20.0 ms %6, up to 100.0 ms %7, above 100.0 ms %8; the longest %9 ms.</source>
        <translation>Zeiten von Antwort zu Antwort: bis 0.8 ms %1, bis 1.0 ms %2, bis 1.2 ms %3, bis 2.0 ms %4, bis 5.0 ms %5, bis 20.0 ms %6, bis 100.0 ms %7, über 100.0 ms %8; die längste %9 ms.</translation>
    </message>
    <message>
        <source>From question to answer: %1 ms on average, %2 ms at worst.</source>
        <translation>Von der Frage zur Antwort: %1 ms im Mittel, %2 ms höchstens.</translation>
    </message>
    <message>
        <source>Lights: red, green and blue were shown one after the other.</source>
        <translation>Lichter: Rot, Grün und Blau wurden nacheinander gezeigt.</translation>
    </message>
    <message>
        <source>Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, in %6 mm.</source>
        <translation>Stöße von 0.5 N bewegten die Hand: nach rechts %1 mm, nach links %2 mm, nach oben %3 mm, nach unten %4 mm, nach vorn %5 mm, nach hinten %6 mm.</translation>
    </message>
    <message>
        <source>Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, in %6 mm; a hand that holds on moves less.</source>
        <translation>Stöße von 0.5 N bewegten die Hand: nach rechts %1 mm, nach links %2 mm, nach oben %3 mm, nach unten %4 mm, nach vorn %5 mm, nach hinten %6 mm; eine Hand, die festhält, bewegt sich weniger.</translation>
    </message>
    <message>
        <source>Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, in %6 mm; the motors moved nothing. Check the Falcon&apos;s power supply, hold the grip loosely or let go of it, and test again.</source>
        <translation>Stöße von 0.5 N bewegten die Hand nach rechts um %1 mm, links %2 mm, oben %3 mm, unten %4 mm, außen %5 mm, innen %6 mm; die Motoren haben nichts bewegt. Prüfen Sie das Netzteil des Falcon, halten Sie den Griff locker oder lassen Sie ihn los und prüfen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Buttons: all four work.</source>
        <translation>Knöpfe: Alle vier funktionieren.</translation>
    </message>
    <message>
        <source>Buttons that were not pressed: %1.</source>
        <translation>Knöpfe, die nicht gedrückt wurden: %1.</translation>
    </message>
    <message>
        <source>Encoder of the %1 arm: moved by {2|%2 count|%2 counts}.</source>
        <translation>Encoder des Arms %1: um {2|%2 Zählschritt|%2 Zählschritte} bewegt.</translation>
    </message>
    <message>
        <source>Measuring how evenly the Falcon answers.</source>
        <translation>Gemessen wird, wie gleichmäßig der Falcon antwortet.</translation>
    </message>
    <message>
        <source>Watch the lights: red, green, blue.</source>
        <translation>Achten Sie auf die Lichter: rot, grün, blau.</translation>
    </message>
    <message>
        <source>Hold the grip loosely: six small nudges of half a newton.</source>
        <translation>Halten Sie den Griff locker: sechs kleine Stöße von einem halben Newton.</translation>
    </message>
    <message>
        <source>The self test passed.</source>
        <translation>Der Selbsttest ist bestanden.</translation>
    </message>
    <message>
        <source>The self test found something wrong.</source>
        <translation>Der Selbsttest hat einen Fehler gefunden.</translation>
    </message>
    <message>
        <source>The weight must be 20 to 300 grams.</source>
        <translation>Das Gewicht muss 20 bis 300 Gramm betragen.</translation>
    </message>
    <message>
        <source>Take your hand off the grip. The Falcon holds it in place.</source>
        <translation>Nehmen Sie die Hand vom Griff. Der Falcon hält ihn an seinem Ort.</translation>
    </message>
    <message>
        <source>Hang the weight on the grip, let it come to rest, then press Continue.</source>
        <translation>Hängen Sie das Gewicht an den Griff, lassen Sie es zur Ruhe kommen und drücken Sie dann „Weiter“.</translation>
    </message>
    <message>
        <source>Holding the weight. Do not touch it.</source>
        <translation>Das Gewicht wird gehalten. Berühren Sie es nicht.</translation>
    </message>
    <message>
        <source>The force is calibrated.</source>
        <translation>Die Kraft ist kalibriert.</translation>
    </message>
    <message>
        <source>The calibration ended: %1. The old setting is kept.</source>
        <translation>Die Kalibrierung endete: %1. Die alte Einstellung bleibt.</translation>
    </message>
    <message>
        <source>the grip did not come to rest</source>
        <translation>der Griff ist nicht zur Ruhe gekommen</translation>
    </message>
    <message>
        <source>the Falcon or this computer was interrupted too often to measure a force</source>
        <translation>der Falcon oder dieser Rechner wurde zu oft unterbrochen, um eine Kraft zu messen</translation>
    </message>
    <message>
        <source>the weight seemed to be %1 g, which no Falcon&apos;s motors explain (is it the right one, and hanging free?)</source>
        <translation>das Gewicht schien %1 g zu haben, was die Motoren keines Falcon erklären (ist es das richtige, und hängt es frei?)</translation>
    </message>
    <message>
        <source>The hash of the firmware could not be computed. Nothing was loaded. Check that OpenSSL&apos;s library is whole and allows SHA-256.</source>
        <translation>Die Prüfsumme der Firmware konnte nicht berechnet werden. Nichts wurde geladen. Prüfen Sie, ob die Bibliothek von OpenSSL heil ist und SHA-256 erlaubt.</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. Nothing was loaded. Check its name.</source>
        <translation>Es gibt keine Datei „%1“. Nichts wurde geladen. Prüfen Sie ihren Namen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read: %2. Nothing was loaded. Check its permissions and its folder&apos;s.</source>
        <translation>„%1“ kann nicht gelesen werden: %2. Nichts wurde geladen. Prüfen Sie die Rechte der Datei und ihres Ordners.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a regular file; it was not read as Falcon firmware. Name the file itself, such as nvent_firmware.bin.</source>
        <translation>„%1“ ist keine gewöhnliche Datei und wurde nicht als Falcon-Firmware gelesen. Nennen Sie die Datei selbst, etwa nvent_firmware.bin.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Falcon firmware: it has more than %2 bytes. Nothing was loaded. Choose another file.</source>
        <translation>„%1“ ist keine Falcon-Firmware: Die Datei hat mehr als %2 Bytes. Nichts wurde geladen. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read to its end. Nothing was loaded. Copy it to another disk, or choose another file.</source>
        <translation>„%1“ konnte nicht bis zum Ende gelesen werden. Nichts wurde geladen. Kopieren Sie die Datei auf einen anderen Datenträger oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Falcon firmware: %2. Nothing was loaded. Choose another file.</source>
        <translation>„%1“ ist keine Falcon-Firmware: %2. Nichts wurde geladen. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>it has {1|%1 byte|%1 bytes}; 2048 to 65536 are possible</source>
        <translation>sie hat {1|%1 Byte|%1 Bytes}; möglich sind 2048 bis 65536</translation>
    </message>
    <message>
        <source>its length is odd</source>
        <translation>ihre Länge ist ungerade</translation>
    </message>
    <message>
        <source>it does not begin with AA 08</source>
        <translation>sie beginnt nicht mit AA 08</translation>
    </message>
    <message>
        <source>it ends before its entry point</source>
        <translation>sie endet vor ihrem Einsprung</translation>
    </message>
    <message>
        <source>it ends in block %1</source>
        <translation>sie endet in Block %1</translation>
    </message>
    <message>
        <source>{1|%1 byte follows|%1 bytes follow} its last block</source>
        <translation>auf ihren letzten Block {1|folgt %1 Byte|folgen %1 Bytes}</translation>
    </message>
    <message>
        <source>it has no blocks</source>
        <translation>sie hat keine Blöcke</translation>
    </message>
    <message>
        <source>%1 (recommended)</source>
        <translation>%1 (empfohlen)</translation>
    </message>
    <message>
        <source>the setting Falcon firmware (Preferences &gt; Device)</source>
        <translation>die Einstellung Falcon-Firmware (Einstellungen &gt; Gerät)</translation>
    </message>
    <message>
        <source>The Falcon firmware &quot;%1&quot; that %2 names does not exist. Nothing was loaded. Correct %2, or clear it to search the usual places.</source>
        <translation>Die Falcon-Firmware „%1“ gibt es nicht; genannt wird sie durch: %2. Nichts wurde geladen. Berichtigen Sie: %2, oder leeren Sie das, um an den üblichen Orten zu suchen.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; that %2 names has no Falcon firmware (such as nvent_firmware.bin). Nothing was loaded. Correct %2, or clear it to search the usual places.</source>
        <translation>Der Ordner „%1“ enthält keine Falcon-Firmware (etwa nvent_firmware.bin); genannt wird er durch: %2. Nichts wurde geladen. Berichtigen Sie: %2, oder leeren Sie das, um an den üblichen Orten zu suchen.</translation>
    </message>
    <message>
        <source>%1 It is what %2 names. Correct %2, or clear it to search the usual places.</source>
        <translation>%1 Genannt wird sie durch: %2. Berichtigen Sie: %2, oder leeren Sie das, um an den üblichen Orten zu suchen.</translation>
    </message>
    <message>
        <source>The Falcon is connected but has no firmware loaded. relievo cannot include Novint&apos;s firmware. Run &apos;relievo devices firmware FILE&apos; with the file nvent_firmware.bin (8492 bytes) from your Novint software or libnifalcon, or set RELIEVO_FALCON_FIRMWARE. Places searched: %1.</source>
        <translation>Der Falcon ist angeschlossen, aber keine Firmware ist geladen. relievo darf Novints Firmware nicht mitbringen. Rufen Sie „relievo devices firmware FILE“ mit der Datei nvent_firmware.bin (8492 Bytes) aus Ihrer Novint-Software oder libnifalcon auf, oder setzen Sie RELIEVO_FALCON_FIRMWARE. Durchsucht wurden: %1.</translation>
    </message>
    <message>
        <source>The Falcon firmware &quot;%1&quot; has the form of a boot image, but nobody knows this one (sha256 %2); it was not loaded. If you trust it, run &apos;relievo devices firmware FILE --accept&apos; once.</source>
        <translation>Die Falcon-Firmware „%1“ hat die Form eines Startabbilds, aber niemand kennt es (sha256 %2); sie wurde nicht geladen. Wenn Sie ihr vertrauen, rufen Sie einmal „relievo devices firmware FILE --accept“ auf.</translation>
    </message>
    <message>
        <source>The firmware could not be copied to &quot;%1&quot;: %2. Nothing was changed. Check the folder and the disk&apos;s room.</source>
        <translation>Die Firmware konnte nicht nach „%1“ kopiert werden: %2. Nichts wurde geändert. Prüfen Sie den Ordner und den freien Platz.</translation>
    </message>
    <message>
        <source>The Falcon&apos;s settings could not be written to &quot;%1&quot;. They hold until the program ends. Check the folder&apos;s permissions.</source>
        <translation>Die Einstellungen des Falcon konnten nicht nach „%1“ geschrieben werden. Sie gelten, bis das Programm endet. Prüfen Sie die Rechte des Ordners.</translation>
    </message>
    <message>
        <source>The haptic loop needs a device.</source>
        <translation>Die haptische Schleife braucht ein Gerät.</translation>
    </message>
    <message>
        <source>A device that a person holds never gets the bare spring.</source>
        <translation>Ein Gerät, das jemand hält, bekommt nie die bloße Feder.</translation>
    </message>
    <message>
        <source>The haptic loop&apos;s period must be above 0 ns.</source>
        <translation>Die Periode der haptischen Schleife muss über 0 ns liegen.</translation>
    </message>
    <message>
        <source>The window has %1 samples; the haptic space holds exactly 200 x 200.</source>
        <translation>Der Ausschnitt hat %1 Abtastwerte; der haptische Raum hält genau 200 x 200.</translation>
    </message>
    <message>
        <source>The window has a height that is not a finite number; nothing can be felt.</source>
        <translation>Der Ausschnitt hat eine Höhe, die keine endliche Zahl ist; nichts ist zu fühlen.</translation>
    </message>
    <message>
        <source>The window&apos;s side is %1 mm; it must be greater than 0.</source>
        <translation>Die Seite des Ausschnitts ist %1 mm; sie muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>A texture has %1 heights; exactly 400 x 400 finite ones are needed.</source>
        <translation>Eine Textur hat %1 Höhen; genau 400 x 400 endliche sind nötig.</translation>
    </message>
    <message>
        <source>This recording cannot be replayed: %1.</source>
        <translation>Diese Aufzeichnung kann nicht wiederholt werden: %1.</translation>
    </message>
    <message>
        <source>This recording cannot be replayed: samples were dropped before tick %1.</source>
        <translation>Diese Aufzeichnung kann nicht wiederholt werden: Vor Takt %1 gingen Abtastwerte verloren.</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; cannot be read.</source>
        <translation>Der Strich „%1“ kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; cannot be read to its end.</source>
        <translation>Der Strich „%1“ kann nicht bis zum Ende gelesen werden.</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; does not start with the line %2.</source>
        <translation>Der Strich „%1“ beginnt nicht mit der Zeile %2.</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; row %2 %3.</source>
        <translation>Der Strich „%1“, Zeile %2: %3.</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; row %2 is not later than the row before it; times must increase.</source>
        <translation>Der Strich „%1“, Zeile %2 ist nicht später als die Zeile davor; die Zeiten müssen wachsen.</translation>
    </message>
    <message>
        <source>The stroke &quot;%1&quot; has no rows.</source>
        <translation>Der Strich „%1“ hat keine Zeilen.</translation>
    </message>
    <message>
        <source>The stroke lasts %1 s; are its times in seconds?</source>
        <translation>Der Strich dauert %1 s; sind seine Zeiten in Sekunden?</translation>
    </message>
    <message>
        <source>A stroke needs at least one point.</source>
        <translation>Ein Strich braucht mindestens einen Punkt.</translation>
    </message>
    <message>
        <source>The stiffness must be a finite number of N/mm above 0.</source>
        <translation>Die Steifigkeit muss eine endliche Zahl von N/mm über 0 sein.</translation>
    </message>
    <message>
        <source>The damping must be a finite number of N s/mm, 0 or above.</source>
        <translation>Die Dämpfung muss eine endliche Zahl von N s/mm sein, 0 oder mehr.</translation>
    </message>
    <message>
        <source>No cell of the grid was hit by the scan. Nothing was made. Choose another view.</source>
        <translation>Der Scan traf keine Zelle des Rasters. Nichts wurde gemacht. Wählen Sie eine andere Ansicht.</translation>
    </message>
    <message>
        <source>A free view needs its rotation.</source>
        <translation>Eine freie Ansicht braucht ihre Drehung.</translation>
    </message>
    <message>
        <source>There is no view &apos;%1&apos;. Choose front, back, left, right, top, bottom, auto, fit or axes.</source>
        <translation>Es gibt keine Ansicht „%1“. Wählen Sie front, back, left, right, top, bottom, auto, fit oder axes.</translation>
    </message>
    <message>
        <source>A view is turned by finite numbers of degrees.</source>
        <translation>Eine Ansicht wird um endliche Gradzahlen gedreht.</translation>
    </message>
    <message>
        <source>A point is not finite.</source>
        <translation>Ein Punkt ist nicht endlich.</translation>
    </message>
    <message>
        <source>At least one neighbour must be asked for.</source>
        <translation>Es muss nach mindestens einem Nachbarn gefragt werden.</translation>
    </message>
    <message>
        <source>%1 is no recipe that this version can read. %2 Nothing was done.</source>
        <translation>%1 ist kein Rezept, das diese Version lesen kann. %2 Nichts wurde getan.</translation>
    </message>
    <message>
        <source>Line %1 of it is not JSON.</source>
        <translation>Seine Zeile %1 ist kein JSON.</translation>
    </message>
    <message>
        <source>A number in it is too large.</source>
        <translation>Eine Zahl darin ist zu groß.</translation>
    </message>
    <message>
        <source>There is no &apos;%1&apos; where one belongs.</source>
        <translation>Wo „%1“ hingehört, ist keines.</translation>
    </message>
    <message>
        <source>A part of it is missing or has another form.</source>
        <translation>Ein Teil davon fehlt oder hat eine andere Form.</translation>
    </message>
    <message>
        <source>A part of it is no object.</source>
        <translation>Ein Teil davon ist kein Objekt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a key that is known there.</source>
        <translation>„%1“ ist dort kein bekannter Schlüssel.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 4294967295.</source>
        <translation>%1 ist keine ganze Zahl von 0 bis 4294967295.</translation>
    </message>
    <message>
        <source>A list of it has not %1 numbers.</source>
        <translation>Eine Liste davon hat nicht %1 Zahlen.</translation>
    </message>
    <message>
        <source>%1 is none of the six standard views.</source>
        <translation>%1 ist keine der sechs Standardansichten.</translation>
    </message>
    <message>
        <source>&apos;keep&apos; is neither inside nor outside.</source>
        <translation>„keep“ ist weder inside noch outside.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no list of at most %2 entries.</source>
        <translation>„%1“ ist keine Liste von höchstens %2 Einträgen.</translation>
    </message>
    <message>
        <source>A class is from 0 to 255.</source>
        <translation>Eine Klasse geht von 0 bis 255.</translation>
    </message>
    <message>
        <source>&apos;keep&apos; is none of first, last and single.</source>
        <translation>„keep“ ist keines von first, last und single.</translation>
    </message>
    <message>
        <source>&apos;method&apos; is none of stored, points and auto.</source>
        <translation>„method“ ist keines von stored, points und auto.</translation>
    </message>
    <message>
        <source>A step is no object.</source>
        <translation>Ein Schritt ist kein Objekt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no step that is known.</source>
        <translation>„%1“ ist kein bekannter Schritt.</translation>
    </message>
    <message>
        <source>&apos;unit&apos; is none of mm, cm, m, in, ft and us-ft.</source>
        <translation>„unit“ ist keines von mm, cm, m, in, ft und us-ft.</translation>
    </message>
    <message>
        <source>&apos;parts&apos; are not numbers of a file&apos;s scans, from 1.</source>
        <translation>„parts“ sind keine Nummern der Scans einer Datei, ab 1.</translation>
    </message>
    <message>
        <source>Its schema is %1; this version reads 1.</source>
        <translation>Sein Schema ist %1; diese Version liest 1.</translation>
    </message>
    <message>
        <source>The recipe names %1 scans; at most %2 can be prepared at once.</source>
        <translation>Das Rezept nennt %1 Scans; höchstens %2 können auf einmal aufbereitet werden.</translation>
    </message>
    <message>
        <source>The recipe has %1 steps; at most %2 can be done at once.</source>
        <translation>Das Rezept hat %1 Schritte; höchstens %2 können auf einmal getan werden.</translation>
    </message>
    <message>
        <source>The recipe aligns its scans twice. Leave one step out.</source>
        <translation>Das Rezept richtet seine Scans zweimal aus. Lassen Sie einen Schritt weg.</translation>
    </message>
    <message>
        <source>The recipe is for {1|%1 scan|%1 scans}, but there are %2. Nothing was done.</source>
        <translation>Das Rezept ist für {1|%1 Scan|%1 Scans}, aber es sind %2. Nichts wurde getan.</translation>
    </message>
    <message>
        <source>The recipe has poses for {1|%1 scan|%1 scans}, but there are %2. Nothing was done. Give the scans that it was made for.</source>
        <translation>Das Rezept hat Lagen für {1|%1 Scan|%1 Scans}, aber es sind %2. Nichts wurde getan. Geben Sie die Scans an, für die es gemacht wurde.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>the box ends before it begins; its first corner must be the lower one</source>
        <translation>der Quader endet, bevor er beginnt; seine erste Ecke muss die untere sein</translation>
    </message>
    <message>
        <source>the outline has {1|%1 corner|%1 corners}; it takes 3 to %2</source>
        <translation>der Umriss hat {1|%1 Ecke|%1 Ecken}; er braucht 3 bis %2</translation>
    </message>
    <message>
        <source>the highest intensity is below the lowest</source>
        <translation>die höchste Intensität liegt unter der niedrigsten</translation>
    </message>
    <message>
        <source>&apos;reference&apos; is beyond the scans there can be</source>
        <translation>„reference“ liegt jenseits der möglichen Scans</translation>
    </message>
    <message>
        <source>it has more than %1 pairs</source>
        <translation>er hat mehr als %1 Paare</translation>
    </message>
    <message>
        <source>a pair names a scan beyond those there can be</source>
        <translation>ein Paar nennt einen Scan jenseits der möglichen</translation>
    </message>
    <message>
        <source>it has more poses than there can be scans</source>
        <translation>er hat mehr Lagen, als es Scans geben kann</translation>
    </message>
    <message>
        <source>a pose is no rotation and translation</source>
        <translation>eine Lage ist keine Drehung und Verschiebung</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2; it takes %3 to %4</source>
        <translation>„%1“ ist %2; möglich ist %3 bis %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not finite; it takes %2 to %3</source>
        <translation>„%1“ ist nicht endlich; möglich ist %2 bis %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 mm</source>
        <translation>„%1“ muss über 0 mm liegen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no rotation: 9 numbers, rows of length 1 at right angles, right-handed</source>
        <translation>„%1“ ist keine Drehung: 9 Zahlen, Zeilen der Länge 1 im rechten Winkel, rechtshändig</translation>
    </message>
    <message>
        <source>The scans are not all in one unit: %1 is in %2, %3 in %4. Nothing was done. Give --unit if it is the same for all.</source>
        <translation>Die Scans haben nicht alle dieselbe Einheit: %1 hat %2, %3 hat %4. Nichts wurde getan. Geben Sie --unit an, wenn sie für alle gleich ist.</translation>
    </message>
    <message>
        <source>none that it states</source>
        <translation>keine angegebene</translation>
    </message>
    <message>
        <source>The files hold more than %1 scans together. Nothing was done. Prepare fewer at once.</source>
        <translation>Die Dateien enthalten zusammen mehr als %1 Scans. Nichts wurde getan. Bereiten Sie weniger auf einmal auf.</translation>
    </message>
    <message>
        <source>No point is left after all steps. Nothing was written. Take a step out, or widen its limits.</source>
        <translation>Nach allen Schritten ist kein Punkt übrig. Nichts wurde geschrieben. Nehmen Sie einen Schritt heraus oder weiten Sie seine Grenzen.</translation>
    </message>
    <message>
        <source>The scan is more than 2 097 152 times as long as the distance it should be thinned to. Nothing was thinned; choose a larger distance, or crop the scan first.</source>
        <translation>Der Scan ist mehr als 2 097 152-mal so lang wie der Abstand, auf den er ausgedünnt werden soll. Nichts wurde ausgedünnt; wählen Sie einen größeren Abstand, oder schneiden Sie den Scan vorher zu.</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the steps take more than %1 s of processor time. Nothing was changed. Thin the scans out first.</source>
        <translation>Die Scans können nicht aufbereitet werden: Die Schritte brauchen mehr als %1 s Rechenzeit. Nichts wurde geändert. Dünnen Sie die Scans vorher aus.</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the system stopped the work, probably for lack of memory. Nothing was changed. Close other programs, or thin the scans out first.</source>
        <translation>Die Scans können nicht aufbereitet werden: Das System hat die Arbeit beendet, wahrscheinlich aus Speichermangel. Nichts wurde geändert. Schließen Sie andere Programme, oder dünnen Sie die Scans vorher aus.</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the program that does it broke down. Nothing was changed. Leave out one step after the other to find the one.</source>
        <translation>Die Scans können nicht aufbereitet werden: Das Programm, das es tut, ist zusammengebrochen. Nichts wurde geändert. Lassen Sie einen Schritt nach dem anderen weg, um den schuldigen zu finden.</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the program that does it broke down (&quot;%1&quot;). Nothing was changed. Leave out one step after the other to find the one.</source>
        <translation>Die Scans können nicht aufbereitet werden: Das Programm, das es tut, ist zusammengebrochen („%1“). Nichts wurde geändert. Lassen Sie einen Schritt nach dem anderen weg, um den schuldigen zu finden.</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: the system gives no memory for them. Nothing was changed. Close other programs and try again.</source>
        <translation>Die Scans können nicht aufbereitet werden: Das System gibt keinen Speicher für sie. Nichts wurde geändert. Schließen Sie andere Programme, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: a step needs more than %1 MB of memory. Nothing was changed. Crop or thin them first, or allow more (--memory).</source>
        <translation>Die Scans können nicht aufbereitet werden: Ein Schritt braucht mehr als %1 MB Speicher. Nichts wurde geändert. Schneiden Sie sie vorher zu, dünnen Sie sie aus, oder erlauben Sie mehr (--memory).</translation>
    </message>
    <message>
        <source>The scans cannot be prepared: a library gave up (%1). Nothing was changed.</source>
        <translation>Die Scans können nicht aufbereitet werden: Eine Bibliothek gab auf (%1). Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The scans did not arrive whole. Nothing was changed. Try again.</source>
        <translation>Die Scans kamen nicht ganz an. Nichts wurde geändert. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The scan cannot be passed on: %1. Nothing was done. Close other programs and try again.</source>
        <translation>Der Scan kann nicht weitergegeben werden: %1. Nichts wurde getan. Schließen Sie andere Programme, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Aligning needs two scans or more, one of them the reference. Nothing was aligned.</source>
        <translation>Zum Ausrichten braucht es zwei oder mehr Scans, einen davon als Referenz. Nichts wurde ausgerichtet.</translation>
    </message>
    <message>
        <source>A picked pair names scan %1; there are %2, counted from 1. Nothing was aligned.</source>
        <translation>Ein gewähltes Paar nennt Scan %1; es gibt %2, ab 1 gezählt. Nichts wurde ausgerichtet.</translation>
    </message>
    <message>
        <source>A picked pair names scan %1, which is the reference; there are %2, counted from 1. Nothing was aligned.</source>
        <translation>Ein gewähltes Paar nennt Scan %1, der die Referenz ist; es gibt %2, ab 1 gezählt. Nichts wurde ausgerichtet.</translation>
    </message>
    <message>
        <source>%1 has another unit than %2. Nothing was aligned; only scans of one unit can be.</source>
        <translation>%1 hat eine andere Einheit als %2. Nichts wurde ausgerichtet; nur Scans derselben Einheit können es.</translation>
    </message>
    <message>
        <source>%1: {2|%2 different point|%2 different points}; aligning needs %3 in every scan. Nothing was aligned; leave this scan out.</source>
        <translation>%1: {2|%2 Punkt|%2 verschiedene Punkte}; zum Ausrichten braucht jeder Scan %3. Nichts wurde ausgerichtet; lassen Sie diesen Scan weg.</translation>
    </message>
    <message>
        <source>%1: its points stand too far apart to be a surface. Nothing was aligned; leave this scan out.</source>
        <translation>%1: Seine Punkte stehen zu weit auseinander für eine Fläche. Nichts wurde ausgerichtet; lassen Sie diesen Scan weg.</translation>
    </message>
    <message>
        <source>%1: {2|%2 picked pair|%2 picked pairs}; three or more are needed. Nothing was aligned.</source>
        <translation>%1: {2|%2 gewähltes Paar|%2 gewählte Paare}; drei oder mehr sind nötig. Nichts wurde ausgerichtet.</translation>
    </message>
    <message>
        <source>%1: the picked places lie nearly in one line, which leaves open how the scan is turned about it. Nothing was aligned; pick one more place well beside that line.</source>
        <translation>%1: Die gewählten Stellen liegen fast auf einer Geraden; wie der Scan um sie gedreht ist, bleibt offen. Nichts wurde ausgerichtet; eine weitere Stelle deutlich neben dieser Geraden wählen.</translation>
    </message>
    <message>
        <source>%1: the picked places are not equally far from each other on the two scans. Nothing was aligned; look whether the pairs are in the same order and the scans in the same unit.</source>
        <translation>%1: Die gewählten Stellen sind auf den beiden Scans nicht gleich weit voneinander entfernt. Nichts wurde ausgerichtet; prüfen, ob die Paare in derselben Reihenfolge und die Scans in derselben Einheit sind.</translation>
    </message>
    <message>
        <source>%1 states no classes; all its points stay.</source>
        <translation>%1 nennt keine Klassen; alle seine Punkte bleiben.</translation>
    </message>
    <message>
        <source>%1 states no pulses with several returns; all its points stay.</source>
        <translation>%1 nennt keine Pulse mit mehreren Echos; alle seine Punkte bleiben.</translation>
    </message>
    <message>
        <source>%1 states no intensities; all its points stay.</source>
        <translation>%1 nennt keine Intensitäten; alle seine Punkte bleiben.</translation>
    </message>
    <message>
        <source>the joined scans</source>
        <translation>den verbundenen Scans</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>less than 0.1 %</source>
        <translation>weniger als 0,1 %</translation>
    </message>
    <message>
        <source>All points of %1 are one place, which has no spacing.</source>
        <translation>Alle Punkte von %1 sind eine Stelle, die keinen Punktabstand hat.</translation>
    </message>
    <message>
        <source>{1|%1 point has|%1 points have} no normal: too few neighbours.</source>
        <translation>{1|%1 Punkt hat|%1 Punkte haben} keine Normale: zu wenige Nachbarn.</translation>
    </message>
    <message>
        <source>%1 of the points of %2 were left out; those are more than strays. Look at the result.</source>
        <translation>%1 der Punkte von %2 wurden weggelassen; das sind mehr als Streupunkte. Sehen Sie sich das Ergebnis an.</translation>
    </message>
    <message>
        <source>No three points of %1 span a plane; they stay as they are.</source>
        <translation>Keine drei Punkte von %1 spannen eine Ebene auf; sie bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>One plane holds %1 of the points of %2.</source>
        <translation>Auf einer Ebene liegen %1 der Punkte von %2.</translation>
    </message>
    <message>
        <source>One plane holds %1 of the points of %2; that is hardly a base. Look at the result.</source>
        <translation>Auf einer Ebene liegen %1 der Punkte von %2; das ist kaum eine Grundfläche. Sehen Sie sich das Ergebnis an.</translation>
    </message>
    <message>
        <source>This program aligns no scans. They stay where their files have them; give their poses in a recipe, or leave the step out.</source>
        <translation>Dieses Programm richtet keine Scans aus. Sie bleiben, wo ihre Dateien sie haben; geben Sie ihre Lagen in einem Rezept an, oder lassen Sie den Schritt weg.</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <translation>%1 wurde weggelassen: %2</translation>
    </message>
    <message>
        <source>The reference.</source>
        <translation>Die Referenz.</translation>
    </message>
    <message>
        <source>As stored.</source>
        <translation>Wie gespeichert.</translation>
    </message>
    <message>
        <source>The pose that was found before was used.</source>
        <translation>Die vorher gefundene Lage wurde verwendet.</translation>
    </message>
    <message>
        <source>%1 rms over %2 in common.</source>
        <translation>%1 mittlerer Abstand (rms) über %2 gemeinsamer Fläche.</translation>
    </message>
    <message>
        <source>%1 rms over %2 in common. Weak %3: about %4.</source>
        <translation>%1 mittlerer Abstand (rms) über %2 gemeinsamer Fläche. Schwach gehalten %3: etwa %4.</translation>
    </message>
    <message>
        <source>%1 rms over %2 in common. Nothing in the shape holds it %3: there it lies as it was placed by hand.</source>
        <translation>%1 mittlerer Abstand (rms) über %2 gemeinsamer Fläche. Nichts in der Form hält ihn %3: dort liegt er, wie er von Hand gelegt wurde.</translation>
    </message>
    <message>
        <source>Not aligned: %1.</source>
        <translation>Nicht ausgerichtet: %1.</translation>
    </message>
    <message>
        <source>hardly anything of it lies on the others</source>
        <translation>kaum etwas davon liegt auf den anderen</translation>
    </message>
    <message>
        <source>only %1 of it lies on the others</source>
        <translation>nur %1 davon liegen auf den anderen</translation>
    </message>
    <message>
        <source>it touches the others, but does not lie on them</source>
        <translation>er berührt die anderen, liegt aber nicht auf ihnen</translation>
    </message>
    <message>
        <source>nothing in its shape says where it belongs %1</source>
        <translation>nichts in seiner Form sagt, wohin er %1 gehört</translation>
    </message>
    <message>
        <source>no place was found where it fits</source>
        <translation>keine Stelle wurde gefunden, an der er passt</translation>
    </message>
    <message>
        <source>it meets none of the others</source>
        <translation>er trifft keinen der anderen</translation>
    </message>
    <message>
        <source>By itself it lies elsewhere on %1 than by way of the others; look at this pair.</source>
        <translation>Für sich allein liegt er auf %1 anderswo als über die anderen; sehen Sie sich dieses Paar an.</translation>
    </message>
    <message>
        <source>turning about %1</source>
        <translation>bei Drehung um %1</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>entlang %1</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>The map&apos;s holes are too many to count. Nothing was made.</source>
        <translation>Die Karte hat zu viele Löcher, um sie zu zählen. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>The map&apos;s empty areas are so ragged that they alone take more than the memory allowed. Nothing was made. Allow more memory, or choose larger cells.</source>
        <translation>Die leeren Flächen der Karte sind so zerklüftet, dass sie allein mehr als den erlaubten Speicher brauchen. Nichts wurde gemacht. Erlauben Sie mehr Speicher, oder wählen Sie größere Zellen.</translation>
    </message>
    <message>
        <source>Points and heights that do not fit into memory cannot be kept in %1: %2. Nothing was made. Free some space there, write the result to another disk, or allow more memory.</source>
        <translation>Punkte und Höhen, die nicht in den Speicher passen, können nicht in %1 gehalten werden: %2. Nichts wurde gemacht. Schaffen Sie dort Platz, schreiben Sie das Ergebnis auf einen anderen Datenträger, oder erlauben Sie mehr Speicher.</translation>
    </message>
    <message>
        <source>The region names a level that the map does not have.</source>
        <translation>Der Ausschnitt nennt eine Ebene, die die Karte nicht hat.</translation>
    </message>
    <message>
        <source>Cannot read %1 as a tiled map: %2. Make the levels again with relievo pyramid --memory.</source>
        <translation>%1 kann nicht als Karte in Kacheln gelesen werden: %2. Machen Sie die Ebenen neu mit relievo pyramid --memory.</translation>
    </message>
    <message>
        <source>it has another number of bands</source>
        <translation>sie hat eine andere Zahl von Bändern</translation>
    </message>
    <message>
        <source>it is compressed</source>
        <translation>sie ist komprimiert</translation>
    </message>
    <message>
        <source>its bands are mixed</source>
        <translation>ihre Bänder sind gemischt</translation>
    </message>
    <message>
        <source>its tiles have another size</source>
        <translation>ihre Kacheln haben eine andere Größe</translation>
    </message>
    <message>
        <source>its cells are of another type</source>
        <translation>ihre Zellen sind von anderer Art</translation>
    </message>
    <message>
        <source>its bytes are in another order</source>
        <translation>ihre Bytes haben eine andere Reihenfolge</translation>
    </message>
    <message>
        <source>it is no readable GeoTIFF</source>
        <translation>sie ist kein lesbares GeoTIFF</translation>
    </message>
    <message>
        <source>a tile is missing</source>
        <translation>eine Kachel fehlt</translation>
    </message>
    <message>
        <source>it became shorter while it was read, or its disk failed</source>
        <translation>sie wurde beim Lesen kürzer, oder ihr Datenträger versagte</translation>
    </message>
    <message>
        <source>its entry %1 is missing or makes no sense</source>
        <translation>ihr Eintrag %1 fehlt oder ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>a height is not finite</source>
        <translation>eine Höhe ist nicht endlich</translation>
    </message>
    <message>
        <source>a code is none of an origin</source>
        <translation>ein Code steht für keine Herkunft</translation>
    </message>
    <message>
        <source>its number of levels or its factor makes no sense</source>
        <translation>ihre Zahl der Ebenen oder ihr Faktor ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>its spacing is not above 0</source>
        <translation>ihr Abstand liegt nicht über 0</translation>
    </message>
    <message>
        <source>it belongs to another map</source>
        <translation>sie gehört zu einer anderen Karte</translation>
    </message>
    <message>
        <source>its size is not that of the level</source>
        <translation>ihre Größe ist nicht die der Ebene</translation>
    </message>
    <message>
        <source>its lowest height is above its highest</source>
        <translation>ihre niedrigste Höhe liegt über der höchsten</translation>
    </message>
    <message>
        <source>its number of cells of one origin makes no sense</source>
        <translation>ihre Zahl der Zellen einer Herkunft ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>its cells by origin are not all its cells</source>
        <translation>ihre Zellen nach Herkunft sind nicht alle ihre Zellen</translation>
    </message>
    <message>
        <source>it is a level of another map</source>
        <translation>sie ist eine Ebene einer anderen Karte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no recording of &apos;%2&apos; but of another file (checksum differs, E501). Nothing was drawn. Choose a recording of this one.</source>
        <translation>„%1“ ist keine Aufzeichnung von „%2“, sondern von einer anderen Datei (andere Prüfsumme, E501). Nichts wurde gezeichnet. Wählen Sie eine Aufzeichnung von dieser.</translation>
    </message>
    <message>
        <source>A figure&apos;s name ends in .png, .tif, .pdf or .svg; &apos;%1&apos; does not. Nothing was drawn.</source>
        <translation>Der Name einer Abbildung endet mit .png, .tif, .pdf oder .svg; „%1“ nicht. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>The name of a figure&apos;s heights ends in .tif; &apos;%1&apos; does not. Nothing was drawn.</source>
        <translation>Der Name der Höhen einer Abbildung endet mit .tif; „%1“ nicht. Nichts wurde gezeichnet.</translation>
    </message>
    <message>
        <source>Two of the figure&apos;s files would be &apos;%1&apos;. Nothing was drawn. Give one of them another name.</source>
        <translation>Zwei Dateien der Abbildung hießen „%1“. Nichts wurde gezeichnet. Geben Sie einer davon einen anderen Namen.</translation>
    </message>
    <message>
        <source>This figure would be %1 x %2 mm large. Nothing was drawn. Choose a smaller scale or width.</source>
        <translation>Diese Abbildung würde %1 x %2 mm groß. Nichts wurde gezeichnet. Wählen Sie einen kleineren Maßstab oder weniger Breite.</translation>
    </message>
    <message>
        <source>This figure would be %1 x %2 mm small, and at least 20 mm wide it must be. Nothing was drawn. Choose a larger scale, 1:N with a smaller N.</source>
        <translation>Diese Abbildung würde nur %1 x %2 mm groß, muss aber mindestens 20 mm breit sein. Nichts wurde gezeichnet. Wählen Sie einen größeren Maßstab, 1:N mit kleinerem N.</translation>
    </message>
    <message>
        <source>Numbers of %1 points leave no room for plots on %2 mm. Nothing was drawn. Choose a smaller text or a larger width.</source>
        <translation>Zahlen von %1 Punkt lassen auf %2 mm keinen Platz für Kurven. Nichts wurde gezeichnet. Wählen Sie kleinere Schrift oder mehr Breite.</translation>
    </message>
    <message>
        <source>There is nothing of the object in this region. Choose another.</source>
        <translation>In diesem Ausschnitt liegt nichts vom Objekt. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Level %1 has more than %2 samples across this region. Choose a coarser level.</source>
        <translation>Ebene %1 hat über diesen Ausschnitt mehr als %2 Stützstellen. Wählen Sie eine gröbere Ebene.</translation>
    </message>
    <message>
        <source>There is no surface along this line.</source>
        <translation>Entlang dieser Linie gibt es keine Oberfläche.</translation>
    </message>
    <message>
        <source>This is a picture of the %1, which only the window can draw. Nothing was drawn. Open it with relievo to get its state back.</source>
        <translation>Das ist ein Bild von %1, das nur das Fenster zeichnen kann. Nichts wurde gezeichnet. Öffnen Sie es mit relievo, um seinen Zustand wiederzubekommen.</translation>
    </message>
    <message>
        <source>Cannot write the picture &apos;%1&apos; (%2). Choose another folder or free some space.</source>
        <translation>Das Bild „%1“ kann nicht geschrieben werden (%2). Wählen Sie einen anderen Ordner, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>Cannot write the picture &apos;%1&apos;. Choose another folder or free some space.</source>
        <translation>Das Bild „%1“ kann nicht geschrieben werden. Wählen Sie einen anderen Ordner, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>The graphics driver returned a black picture. Try a smaller one.</source>
        <translation>Der Grafiktreiber lieferte ein schwarzes Bild. Versuchen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>The graphics driver cannot draw pictures of %1 x %2 pixels. Choose a smaller size.</source>
        <translation>Der Grafiktreiber kann keine Bilder von %1 x %2 Pixeln zeichnen. Wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is more than this version can hold, %3 million in all. Nothing was drawn. Choose a smaller one.</source>
        <translation>Ein Bild von %1 x %2 Pixeln ist mehr, als diese Version fasst (%3 Millionen im Ganzen). Nichts wurde gezeichnet. Wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>There is not enough memory to draw: the graphics driver needs 512 MB of address space, and a limit that was set (ulimit -v) leaves less. Nothing was drawn. Raise the limit.</source>
        <translation>Zum Zeichnen reicht der Speicher nicht: Der Grafiktreiber braucht 512 MB Adressraum, und eine gesetzte Grenze (ulimit -v) lässt weniger. Nichts wurde gezeichnet. Heben Sie die Grenze an.</translation>
    </message>
    <message>
        <source>There is no display to draw with. Set DISPLAY, or start the program on a desktop or under xvfb-run.</source>
        <translation>Es gibt keine Anzeige zum Zeichnen. Setzen Sie DISPLAY, oder starten Sie das Programm auf einer Arbeitsfläche oder mit xvfb-run.</translation>
    </message>
    <message>
        <source>Cannot make a pipe to start Xvfb. Close other programs and try again.</source>
        <translation>Für den Start von Xvfb kann keine Pipe gemacht werden. Schließen Sie andere Programme, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>There is no display, and Xvfb did not start. Install the package xvfb, or run this on a desktop.</source>
        <translation>Es gibt keine Anzeige, und Xvfb ist nicht gestartet. Installieren Sie das Paket xvfb, oder führen Sie dies auf einer Arbeitsfläche aus.</translation>
    </message>
    <message>
        <source>A picture needs a width and a height above 0.</source>
        <translation>Ein Bild braucht eine Breite und eine Höhe über 0.</translation>
    </message>
    <message>
        <source>The graphics driver returned a black picture of %1 x %2 pixels. Try a smaller one.</source>
        <translation>Der Grafiktreiber gab ein schwarzes Bild von %1 x %2 Pixeln zurück. Versuchen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>A PNG text entry&apos;s name has 1 to 79 characters, not &apos;%1&apos;.</source>
        <translation>Der Name eines Texteintrags in PNG hat 1 bis 79 Zeichen, nicht „%1“.</translation>
    </message>
    <message>
        <source>There is no picture to write to &apos;%1&apos;.</source>
        <translation>Es gibt kein Bild, das nach „%1“ geschrieben werden könnte.</translation>
    </message>
    <message>
        <source>A surface to draw needs one height and at most one origin and colour per sample.</source>
        <translation>Eine Fläche zum Zeichnen braucht je Abtastwert eine Höhe und höchstens eine Herkunft und Farbe.</translation>
    </message>
    <message>
        <source>A surface to draw needs at least 2 x 2 samples and a spacing above 0.</source>
        <translation>Eine Fläche zum Zeichnen braucht mindestens 2 x 2 Abtastwerte und einen Abstand über 0.</translation>
    </message>
    <message>
        <source>A depth map needs at least one sample and a spacing above 0.</source>
        <translation>Eine Tiefenkarte braucht mindestens einen Abtastwert und einen Abstand über 0.</translation>
    </message>
    <message>
        <source>A camera needs a rectangle with a width and a height above 0.</source>
        <translation>Eine Kamera braucht ein Rechteck mit einer Breite und einer Höhe über 0.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made. Nothing was written. Choose another place.</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden. Nichts wurde geschrieben. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds frames of a video already. Nothing was written. Choose another.</source>
        <translation>Der Ordner „%1“ enthält schon Bilder eines Videos. Nichts wurde geschrieben. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Video stopped: disk full. %1 s ({2|%2 frame|%2 frames}) are saved and complete in &quot;%3&quot;.</source>
        <translation>Video beendet: Datenträger voll. %1 s ({2|%2 Bild|%2 Bilder}) sind gespeichert und vollständig in „%3“.</translation>
    </message>
    <message>
        <source>The program ffmpeg is not installed, which packs videos. Nothing was written. Install the package ffmpeg, or choose the profile images: a folder of pictures.</source>
        <translation>Das Programm ffmpeg, das Videos packt, ist nicht installiert. Nichts wurde geschrieben. Installieren Sie das Paket ffmpeg, oder wählen Sie das Profil images: einen Ordner mit Bildern.</translation>
    </message>
    <message>
        <source>The video &quot;%1&quot; cannot be written: %2. Choose another place.</source>
        <translation>Das Video „%1“ kann nicht geschrieben werden: %2. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The encoder cannot be reached: %1.</source>
        <translation>Der Encoder ist nicht zu erreichen: %1.</translation>
    </message>
    <message>
        <source>ffmpeg could not pack the video. Nothing was kept. Choose another size or profile.</source>
        <translation>ffmpeg konnte das Video nicht packen. Nichts wurde behalten. Wählen Sie eine andere Größe oder ein anderes Profil.</translation>
    </message>
    <message>
        <source>ffmpeg could not pack the video (&quot;%1&quot;). Nothing was kept. Choose another size or profile.</source>
        <translation>ffmpeg konnte das Video nicht packen („%1“). Nichts wurde behalten. Wählen Sie eine andere Größe oder ein anderes Profil.</translation>
    </message>
    <message>
        <source>A video&apos;s name must end in .mp4. Nothing was made.</source>
        <translation>Der Name eines Videos muss auf .mp4 enden. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>Video stopped: %1. %2 s ({3|%3 frame|%3 frames}) are saved and complete in &quot;%4&quot;.</source>
        <translation>Video beendet: %1. %2 s ({3|%3 Bild|%3 Bilder}) sind gespeichert und vollständig in „%4“.</translation>
    </message>
    <message>
        <source>Video stopped: %1. Nothing of it could be kept.</source>
        <translation>Video beendet: %1. Nichts davon konnte behalten werden.</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>Datenträger voll</translation>
    </message>
    <message>
        <source>Video stopped: %1 {2|%2 frame is|%2 frames are} saved and complete in &quot;%3&quot;.</source>
        <translation>Video beendet: %1 {2|%2 Bild ist|%2 Bilder sind} gespeichert und vollständig in „%3“.</translation>
    </message>
    <message>
        <source>%1 is a recording of %2, another file. Nothing was packed. Leave it out.</source>
        <translation>%1 ist eine Aufzeichnung von %2, einer anderen Datei. Nichts wurde eingepackt. Lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>No map is open that the raster could lie on.</source>
        <translation>Es ist keine Karte geöffnet, auf der das Raster liegen könnte.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since it was read. Nothing was written. Close the dialog and open the file again.</source>
        <translation>&apos;%1&apos; hat sich seit dem Lesen geändert. Nichts wurde geschrieben. Schließen Sie den Dialog und öffnen Sie die Datei neu.</translation>
    </message>
    <message>
        <source>%1 is still being read. Nothing was saved. Save again when the list shows its value.</source>
        <translation>%1 wird noch gelesen. Nichts wurde gespeichert. Speichern Sie erneut, sobald die Liste den Wert zeigt.</translation>
    </message>
    <message>
        <source>Select a profile or a section in the list first.</source>
        <translation>Wählen Sie zuerst ein Profil oder einen Schnitt in der Liste.</translation>
    </message>
    <message>
        <source>Pictures cannot be drawn: the program relievo-draw, which does it, is not installed. Nothing was done. Install relievo with its drawing part.</source>
        <translation>Bilder können nicht gezeichnet werden: Das Programm relievo-draw, das sie zeichnet, ist nicht installiert. Es wurde nichts getan. Installieren Sie relievo mit dem Teil, der zeichnet.</translation>
    </message>
    <message>
        <source>The window is not installed. Install the package relievo, or use a verb, which needs no window: &apos;relievo --help&apos; lists the verbs.</source>
        <translation>Das Fenster ist nicht installiert. Installieren Sie das Paket relievo, oder nehmen Sie einen Befehl, der kein Fenster braucht: „relievo --help“ nennt die Befehle.</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2. Nothing was done. Install relievo again.</source>
        <translation>Das Programm %1 kann nicht gestartet werden: %2. Es wurde nichts getan. Installieren Sie relievo neu.</translation>
    </message>
    <message>
        <source>The part %1 of relievo cannot be loaded: %2. Nothing was written. Install relievo again.</source>
        <translation>Der Teil %1 von relievo kann nicht geladen werden: %2. Es wurde nichts geschrieben. Installieren Sie relievo neu.</translation>
    </message>
    <message>
        <source>Windows are suggested for maps that fit into memory; this one is read by tiles. Nothing was made. Give a level of it, or a map with larger cells.</source>
        <translation>Fenster werden für Karten vorgeschlagen, die in den Speicher passen; diese wird kachelweise gelesen. Es wurde nichts gemacht. Geben Sie eine Stufe davon oder eine Karte mit größeren Zellen an.</translation>
    </message>
    <message>
        <source>%1 is no plugin of relievo. It was not loaded. Take it out of the folder of plugins.</source>
        <translation>%1 ist kein Plugin von relievo. Es wurde nicht geladen. Nehmen Sie es aus dem Ordner der Plugins.</translation>
    </message>
    <message>
        <source>%1 was built for version %2 of the plugin interface, and this relievo has version %3. It was not loaded. Build it again with the headers of this relievo.</source>
        <translation>%1 wurde für Version %2 der Plugin-Schnittstelle gebaut, und dieses relievo hat Version %3. Es wurde nicht geladen. Bauen Sie es mit den Headern dieses relievo neu.</translation>
    </message>
    <message>
        <source>%1 cannot be loaded: %2. Build or install it again.</source>
        <translation>%1 lässt sich nicht laden: %2. Bauen oder installieren Sie es neu.</translation>
    </message>
    <message>
        <source>The plugin %1 could not start and was left out: %2. All else works.</source>
        <translation>Das Plugin %1 konnte nicht starten und wurde weggelassen: %2. Alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The plugin %1 could not take its settings back and was left out: %2. Its settings were kept; all else works.</source>
        <translation>Das Plugin %1 konnte seine Einstellungen nicht zurücknehmen und wurde weggelassen: %2. Seine Einstellungen wurden behalten; alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The plugin %1 could not tell its settings: %2. Those it had before were kept.</source>
        <translation>Das Plugin %1 konnte seine Einstellungen nicht nennen: %2. Die bisherigen wurden behalten.</translation>
    </message>
    <message>
        <source>it threw something that says no reason</source>
        <translation>es warf etwas, das keinen Grund nennt</translation>
    </message>
    <message>
        <source>SpaceMouse, foot switches and gamepads cannot be used: %1. Install the library, or go on without them.</source>
        <translation>SpaceMouse, Fußschalter und Gamepads können nicht benutzt werden: %1. Installieren Sie die Bibliothek, oder arbeiten Sie ohne sie weiter.</translation>
    </message>
    <message>
        <source>A touch along this stroke has %1 rows, which need about %2 MB; %3 MB are free. Nothing was made. Are its times in seconds? Give a shorter stroke.</source>
        <translation>Eine Berührung entlang dieser Bahn hat %1 Zeilen, die etwa %2 MB brauchen; %3 MB sind frei. Es wurde nichts gemacht. Sind ihre Zeiten in Sekunden? Geben Sie eine kürzere Bahn an.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no device of a plug-in. Write plugin:FILE/ID as &apos;relievo devices&apos; lists them.</source>
        <translation>„%1“ nennt kein Gerät eines Plugins. Schreiben Sie plugin:DATEI/KENNUNG, wie „relievo devices“ sie auflistet.</translation>
    </message>
    <message>
        <source>There is no plug-in &quot;%1&quot; for devices. &apos;relievo devices&apos; lists those that were found.</source>
        <translation>Es gibt kein Plugin „%1“ für Geräte. „relievo devices“ listet die gefundenen auf.</translation>
    </message>
    <message>
        <source>The plug-in %1 was not allowed yet, or was changed since. If you know where it is from, allow it by &apos;relievo devices --trust %1&apos;, then try again.</source>
        <translation>Das Plugin %1 wurde noch nicht erlaubt oder seitdem geändert. Wenn Sie wissen, woher es stammt, erlauben Sie es mit „relievo devices --trust %1“ und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The plug-in %1 cannot be read: %2.</source>
        <translation>Das Plugin %1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>The device %1 was not opened: %2.</source>
        <translation>Das Gerät %1 wurde nicht geöffnet: %2.</translation>
    </message>
    <message>
        <source>The program that runs a device&apos;s plug-in could not be started: %1.</source>
        <translation>Das Programm, in dem das Plugin eines Geräts läuft, konnte nicht gestartet werden: %1.</translation>
    </message>
    <message>
        <source>its plug-in crashed (signal %1)</source>
        <translation>sein Plugin ist abgestürzt (Signal %1)</translation>
    </message>
    <message>
        <source>its plug-in ended the process that it runs in</source>
        <translation>sein Plugin hat den Prozess beendet, in dem es läuft</translation>
    </message>
    <message>
        <source>it was not ready within {1|%1 second|%1 seconds}</source>
        <translation>es war nicht innerhalb von {1|%1 Sekunde|%1 Sekunden} bereit</translation>
    </message>
    <message>
        <source>its plug-in cannot be loaded (%1)</source>
        <translation>sein Plugin kann nicht geladen werden (%1)</translation>
    </message>
    <message>
        <source>the file is no plug-in for devices: it exports no relievo_device_entry</source>
        <translation>die Datei ist kein Plugin für Geräte: sie exportiert kein relievo_device_entry</translation>
    </message>
    <message>
        <source>its plug-in is made for version %1 of the interface for devices, and this program has version %2</source>
        <translation>sein Plugin ist für Version %1 der Schnittstelle für Geräte gemacht, und dieses Programm hat Version %2</translation>
    </message>
    <message>
        <source>its plug-in lacks a function or a name that every plug-in must have</source>
        <translation>seinem Plugin fehlt eine Funktion oder ein Name, den jedes haben muss</translation>
    </message>
    <message>
        <source>its plug-in could not begin (status %1)</source>
        <translation>sein Plugin konnte nicht beginnen (Status %1)</translation>
    </message>
    <message>
        <source>its plug-in knows no device of this name</source>
        <translation>sein Plugin kennt kein Gerät dieses Namens</translation>
    </message>
    <message>
        <source>its plug-in says: %1</source>
        <translation>sein Plugin meldet: %1</translation>
    </message>
    <message>
        <source>the limits that its plug-in tells are impossible</source>
        <translation>die Grenzen, die sein Plugin nennt, sind unmöglich</translation>
    </message>
    <message>
        <source>{1|%1 millimetre|%1 millimetres}</source>
        <translation>%1 Millimeter</translation>
    </message>
    <message>
        <source>{1|%1 centimetre|%1 centimetres}</source>
        <translation>%1 Zentimeter</translation>
    </message>
    <message>
        <source>{1|%1 metre|%1 metres}</source>
        <translation>%1 Meter</translation>
    </message>
    <message>
        <source>%1 millimetres</source>
        <translation>%1 Millimeter</translation>
    </message>
    <message>
        <source>%1 centimetres</source>
        <translation>%1 Zentimeter</translation>
    </message>
    <message>
        <source>%1 metres</source>
        <translation>%1 Meter</translation>
    </message>
    <message>
        <source>nearly %1</source>
        <translation>knapp %1</translation>
    </message>
    <message>
        <source>a little over %1</source>
        <translation>gut %1</translation>
    </message>
    <message>
        <source>about a half</source>
        <translation>etwa die Hälfte</translation>
    </message>
    <message>
        <source>about a third</source>
        <translation>etwa ein Drittel</translation>
    </message>
    <message>
        <source>about a quarter</source>
        <translation>etwa ein Viertel</translation>
    </message>
    <message>
        <source>about a fifth</source>
        <translation>etwa ein Fünftel</translation>
    </message>
    <message>
        <source>about a sixth</source>
        <translation>etwa ein Sechstel</translation>
    </message>
    <message>
        <source>about an eighth</source>
        <translation>etwa ein Achtel</translation>
    </message>
    <message>
        <source>about a tenth</source>
        <translation>etwa ein Zehntel</translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1 Prozent</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top middle</source>
        <translation>oben in der Mitte</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>middle left</source>
        <translation>Mitte links</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <source>middle right</source>
        <translation>Mitte rechts</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>bottom middle</source>
        <translation>unten in der Mitte</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>Relief, %1 by %2.</source>
        <translation>Relief, %1 mal %2.</translation>
    </message>
    <message>
        <source>Relief, %3 by %4.</source>
        <translation>Relief, %3 mal %4.</translation>
    </message>
    <message>
        <source>Heights from %1 to %2: a span of %3.</source>
        <translation>Höhen von %1 bis %2: eine Spanne von %3.</translation>
    </message>
    <message>
        <source>Its heights span %4.</source>
        <translation>Die Höhen umfassen %4.</translation>
    </message>
    <message>
        <source>All heights are the same.</source>
        <translation>Alle Höhen sind gleich.</translation>
    </message>
    <message>
        <source>There are no heights to describe.</source>
        <translation>Es gibt keine Höhen zu beschreiben.</translation>
    </message>
    <message>
        <source>Highest place: %1, at x %2, y %3, height %4.</source>
        <translation>Höchste Stelle: %1, bei x %2, y %3, Höhe %4.</translation>
    </message>
    <message>
        <source>Highest place: %1.</source>
        <translation>Höchste Stelle: %1.</translation>
    </message>
    <message>
        <source>A raised rim goes all round.</source>
        <translation>Ein erhabener Rand läuft ringsum.</translation>
    </message>
    <message>
        <source>One raised area: %1, %2 of the surface; %3 wide, %4 high in the picture.</source>
        <translation>Eine erhabene Fläche: %1, %2 der Oberfläche; im Bild %3 breit, %4 hoch.</translation>
    </message>
    <message>
        <source>One raised area: %1, %2 of the surface.</source>
        <translation>Eine erhabene Fläche: %1, %2 der Oberfläche.</translation>
    </message>
    <message>
        <source>%1 raised areas: %2.</source>
        <translation>%1 erhabene Flächen: %2.</translation>
    </message>
    <message>
        <source>%1 raised areas.</source>
        <translation>%1 erhabene Flächen.</translation>
    </message>
    <message>
        <source>Area %1: %2, %3 of the surface; %4 wide, %5 high in the picture.</source>
        <translation>Fläche %1: %2, %3 der Oberfläche; im Bild %4 breit, %5 hoch.</translation>
    </message>
    <message>
        <source>Area %1: %2, %3 of the surface.</source>
        <translation>Fläche %1: %2, %3 der Oberfläche.</translation>
    </message>
    <message>
        <source>Left and right are nearly mirror images (correlation %1).</source>
        <translation>Links und rechts sind fast spiegelgleich (Korrelation %1).</translation>
    </message>
    <message>
        <source>Left and right are nearly mirror images.</source>
        <translation>Links und rechts sind fast spiegelgleich.</translation>
    </message>
    <message>
        <source>Top and bottom are nearly mirror images (correlation %1).</source>
        <translation>Oben und unten sind fast spiegelgleich (Korrelation %1).</translation>
    </message>
    <message>
        <source>Top and bottom are nearly mirror images.</source>
        <translation>Oben und unten sind fast spiegelgleich.</translation>
    </message>
    <message>
        <source>Roughest part: %1.</source>
        <translation>Rauester Teil: %1.</translation>
    </message>
    <message>
        <source>Smoothest part: %1.</source>
        <translation>Glattester Teil: %1.</translation>
    </message>
    <message>
        <source>All of it was measured.</source>
        <translation>Alles wurde gemessen.</translation>
    </message>
    <message>
        <source>Not measured: %1 % of the surface.</source>
        <translation>Nicht gemessen: %1 % der Oberfläche.</translation>
    </message>
    <message>
        <source>Not measured: %2 of the surface.</source>
        <translation>Nicht gemessen: %2 der Oberfläche.</translation>
    </message>
    <message>
        <source>Largest part that was not measured: %1.</source>
        <translation>Größter Teil, der nicht gemessen wurde: %1.</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Nichts ist geöffnet.</translation>
    </message>
    <message>
        <source>Moved.</source>
        <translation>Verschoben.</translation>
    </message>
    <message>
        <source>Back at the old window.</source>
        <translation>Zurück beim alten Ausschnitt.</translation>
    </message>
    <message>
        <source>Touching: %1, height %2.</source>
        <translation>Berührt: %1, Höhe %2.</translation>
    </message>
    <message>
        <source>Touching: %1, %3 high.</source>
        <translation>Berührt: %1, %3 hoch.</translation>
    </message>
    <message>
        <source>Touching: %1, on the ground.</source>
        <translation>Berührt: %1, auf dem Grund.</translation>
    </message>
    <message>
        <source>Touching: %1, %3 deep.</source>
        <translation>Berührt: %1, %3 tief.</translation>
    </message>
    <message>
        <source>In the air: %1.</source>
        <translation>In der Luft: %1.</translation>
    </message>
    <message>
        <source>Beside the relief.</source>
        <translation>Neben dem Relief.</translation>
    </message>
    <message>
        <source>Measured here.</source>
        <translation>Hier gemessen.</translation>
    </message>
    <message>
        <source>Not measured here: %1.</source>
        <translation>Hier nicht gemessen: %1.</translation>
    </message>
    <message>
        <source>Not measured here.</source>
        <translation>Hier nicht gemessen.</translation>
    </message>
    <message>
        <source>%1 from the left edge.</source>
        <translation>%1 vom linken Rand.</translation>
    </message>
    <message>
        <source>%2 from the left edge.</source>
        <translation>%2 vom linken Rand.</translation>
    </message>
    <message>
        <source>%1 from the bottom edge.</source>
        <translation>%1 vom unteren Rand.</translation>
    </message>
    <message>
        <source>%2 from the bottom edge.</source>
        <translation>%2 vom unteren Rand.</translation>
    </message>
    <message>
        <source>1 mm of hand is %1 of relief.</source>
        <translation>1 mm der Hand ist %1 des Reliefs.</translation>
    </message>
    <message>
        <source>One centimetre of hand: %2 of relief.</source>
        <translation>Ein Zentimeter der Hand: %2 des Reliefs.</translation>
    </message>
    <message>
        <source>Samples are %1 apart.</source>
        <translation>Abtastwerte liegen %1 auseinander.</translation>
    </message>
    <message>
        <source>Samples are %2 apart.</source>
        <translation>Abtastwerte liegen %2 auseinander.</translation>
    </message>
    <message>
        <source>Speech is not available: %1. Texts appear here. Install speech-dispatcher or espeak-ng, or choose the screen reader in the panel Voice.</source>
        <translation>Sprache ist nicht verfügbar: %1. Texte erscheinen hier. Installieren Sie speech-dispatcher oder espeak-ng, oder wählen Sie im Bereich Stimme das Vorleseprogramm.</translation>
    </message>
    <message>
        <source>Speech is not available.</source>
        <translation>Sprache ist nicht verfügbar.</translation>
    </message>
    <message>
        <source>no speech service listens at %1</source>
        <translation>kein Sprachdienst hört auf %1</translation>
    </message>
    <message>
        <source>the speech service does not answer</source>
        <translation>der Sprachdienst antwortet nicht</translation>
    </message>
    <message>
        <source>the speech service ended the connection</source>
        <translation>der Sprachdienst hat die Verbindung beendet</translation>
    </message>
    <message>
        <source>the speech service says &quot;%1&quot;</source>
        <translation>der Sprachdienst sagt „%1“</translation>
    </message>
    <message>
        <source>the program %1 cannot be started</source>
        <translation>das Programm %1 kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>the program %1 ended with an error</source>
        <translation>das Programm %1 endete mit einem Fehler</translation>
    </message>
    <message>
        <source>This is the voice of relievo.</source>
        <translation>Dies ist die Stimme von relievo.</translation>
    </message>
    <message>
        <source>Nothing was said yet.</source>
        <translation>Es wurde noch nichts gesagt.</translation>
    </message>
    <message>
        <source>Roughest part: %1 (%2 off its surroundings).</source>
        <translation>Rauester Teil: %1 (%2 neben seiner Umgebung).</translation>
    </message>
    <message>
        <source>Smoothest part: %1 (%2 off its surroundings).</source>
        <translation>Glattester Teil: %1 (%2 neben seiner Umgebung).</translation>
    </message>
    <message>
        <source>Measured here, but too steep to trust.</source>
        <translation>Hier gemessen, aber zu steil, um dem zu trauen.</translation>
    </message>
    <message>
        <source>The plug-in %1 is not run: others may change %2. Take that right from them (&apos;chmod go-w&apos;), or keep the plug-in where only you write, then try again.</source>
        <translation>Das Plug-in %1 wird nicht ausgeführt: Andere können %2 ändern. Nehmen Sie ihnen dieses Recht („chmod go-w“), oder legen Sie das Plug-in dorthin, wo nur Sie schreiben, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>{1|%1 newton|%1 newtons}</source>
        <translation>%1 Newton</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1 Newton</translation>
    </message>
    <message>
        <source>%1 newtons per millimetre</source>
        <translation>%1 Newton je Millimeter</translation>
    </message>
    <message>
        <source>{1|%1 second|%1 seconds}</source>
        <translation>{1|%1 Sekunde|%1 Sekunden}</translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation>%1 Sekunden</translation>
    </message>
    <message>
        <source>{1|%1 degree|%1 degrees}</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>%1 hertz</source>
        <translation>%1 Hertz</translation>
    </message>
    <message>
        <source>%1 square millimetres</source>
        <translation>%1 Quadratmillimeter</translation>
    </message>
    <message>
        <source>%1 cubic millimetres</source>
        <translation>%1 Kubikmillimeter</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>minus %1</translation>
    </message>
    <message>
        <source>by</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>Volume %1 percent.</source>
        <translation>Lautstärke %1 Prozent.</translation>
    </message>
    <message>
        <source>The sound is a WAV file, and &apos;%1&apos; does not end in .wav. Nothing was written. Choose another name.</source>
        <translation>Der Klang ist eine WAV-Datei, und „%1“ endet nicht auf .wav. Nichts wurde geschrieben. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>A WAV file holds %1 hours of sound, and this would be %2. Nothing was written. Choose a part with --from and --to.</source>
        <translation>Eine WAV-Datei fasst %1 Stunden Klang, und dies wären %2. Nichts wurde geschrieben. Wählen Sie einen Teil mit --from und --to.</translation>
    </message>
    <message>
        <source>Say it again</source>
        <translation>Noch einmal sagen</translation>
    </message>
    <message>
        <source>Louder</source>
        <translation>Lauter</translation>
    </message>
    <message>
        <source>Softer</source>
        <translation>Leiser</translation>
    </message>
    <message>
        <source>Now, for 20 seconds: Plus: louder. Minus: softer. Centre: say it again. Forward: back.</source>
        <translation>Jetzt, für 20 Sekunden: Plus: lauter. Minus: leiser. Mitte: noch einmal sagen. Vorwärts: zurück.</translation>
    </message>
    <message>
        <source>The Haply device is not in use.</source>
        <translation>Das Haply-Gerät ist nicht in Gebrauch.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not answer at %1. Start it, by the Haply Hub or by &apos;systemctl start haply-inverse-service&apos;, then try again.</source>
        <translation>Haplys Inverse Service antwortet unter %1 nicht. Starten Sie ihn mit dem Haply Hub oder mit &apos;systemctl start haply-inverse-service&apos; und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not answer.</source>
        <translation>Haplys Inverse Service antwortet nicht.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service at %1 went away. Forces are off; it is looked for until it is back.</source>
        <translation>Haplys Inverse Service unter %1 ist verschwunden. Die Kräfte sind aus; er wird gesucht, bis er wieder da ist.</translation>
    </message>
    <message>
        <source>The Haply device went away. Forces are off.</source>
        <translation>Das Haply-Gerät ist verschwunden. Kräfte sind aus.</translation>
    </message>
    <message>
        <source>What answers at %1 is not Haply&apos;s Inverse Service, or does not tell its version (%2). Nothing is sent to it. If the service has another port, name it by RELIEVO_HAPLY_SERVICE.</source>
        <translation>Was unter %1 antwortet, ist nicht Haplys Inverse Service oder nennt seine Version nicht (%2). Es wird nichts dorthin gesendet. Hat der Dienst einen anderen Port, nennen Sie ihn in RELIEVO_HAPLY_SERVICE.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service has version %1; relievo needs 3.1 or a newer 3. Bring it up to date by the Haply Hub, then try again.</source>
        <translation>Haplys Inverse Service hat die Version %1; relievo braucht 3.1 oder eine neuere 3. Aktualisieren Sie ihn mit dem Haply Hub und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service runs, but sees no Inverse3 or Minverse. Plug it in and switch it on.</source>
        <translation>Haplys Inverse Service läuft, sieht aber kein Inverse3 oder Minverse. Stecken Sie es ein und schalten Sie es an.</translation>
    </message>
    <message>
        <source>No Haply device is plugged in.</source>
        <translation>Es ist kein Haply-Gerät eingesteckt.</translation>
    </message>
    <message>
        <source>The Haply device went away. Forces are off; plug it in again and switch it on.</source>
        <translation>Das Haply-Gerät ist verschwunden. Die Kräfte sind aus; stecken Sie es wieder ein und schalten Sie es an.</translation>
    </message>
    <message>
        <source>%1 is not there. There is: %2.</source>
        <translation>%1 ist nicht da. Da ist: %2.</translation>
    </message>
    <message>
        <source>There are several Haply devices: %1. Choose one of them, as haply:ID.</source>
        <translation>Es gibt mehrere Haply-Geräte: %1. Wählen Sie eines davon, als haply:ID.</translation>
    </message>
    <message>
        <source>Setting up the Haply device …</source>
        <translation>Das Haply-Gerät wird eingerichtet …</translation>
    </message>
    <message>
        <source>The Haply device is not calibrated. Put its grip into the inkwell and wait until the light is steady.</source>
        <translation>Das Haply-Gerät ist nicht kalibriert. Stecken Sie seinen Griff in die Halterung und warten Sie, bis das Licht ruhig leuchtet.</translation>
    </message>
    <message>
        <source>Put the grip into the inkwell.</source>
        <translation>Stecken Sie den Griff in die Halterung.</translation>
    </message>
    <message>
        <source>The Haply device has no power for its motors. Plug in its power supply, and release its emergency stop if it has one.</source>
        <translation>Das Haply-Gerät hat keinen Strom für seine Motoren. Stecken Sie sein Netzteil ein und lösen Sie den Notaus, wenn es einen hat.</translation>
    </message>
    <message>
        <source>The Haply device has no power.</source>
        <translation>Das Haply-Gerät hat keinen Strom.</translation>
    </message>
    <message>
        <source>The Haply device is not ready: its service has not started it. Look at it in the Haply Hub.</source>
        <translation>Das Haply-Gerät ist nicht bereit: Sein Dienst hat es nicht gestartet. Sehen Sie im Haply Hub nach.</translation>
    </message>
    <message>
        <source>Another program changes how the Haply device is set up, or its service does not tell how it is. Forces are off. Close the other program; it is tried again in 10 seconds.</source>
        <translation>Ein anderes Programm ändert, wie das Haply-Gerät eingerichtet ist, oder sein Dienst sagt es nicht. Die Kräfte sind aus. Schließen Sie das andere Programm; in 10 Sekunden wird es wieder versucht.</translation>
    </message>
    <message>
        <source>Another program changes the Haply device. Forces are off.</source>
        <translation>Ein anderes Programm verstellt das Haply-Gerät. Kräfte sind aus.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not obey forces: %1 were ordered, and it tells of %2. Forces are off. Report this with the version of the service, %3.</source>
        <translation>Haplys Inverse Service befolgt Kräfte nicht: %1 waren verlangt, und er meldet %2. Die Kräfte sind aus. Melden Sie das mit der Version des Dienstes, %3.</translation>
    </message>
    <message>
        <source>The Haply service does not obey forces.</source>
        <translation>Der Haply-Dienst befolgt Kräfte nicht.</translation>
    </message>
    <message>
        <source>Another program pushes the Haply device, too. Forces are off. Close that program.</source>
        <translation>Ein anderes Programm drückt das Haply-Gerät ebenfalls. Die Kräfte sind aus. Schließen Sie dieses Programm.</translation>
    </message>
    <message>
        <source>Another program pushes the Haply device. Forces are off.</source>
        <translation>Ein anderes Programm drückt das Haply-Gerät. Kräfte sind aus.</translation>
    </message>
    <message>
        <source>Haply&apos;s Inverse Service does not answer any more. Forces are off; it is tried again.</source>
        <translation>Haplys Inverse Service antwortet nicht mehr. Die Kräfte sind aus; es wird wieder versucht.</translation>
    </message>
    <message>
        <source>The Haply device does not answer. Forces are off.</source>
        <translation>Das Haply-Gerät antwortet nicht. Kräfte sind aus.</translation>
    </message>
    <message>
        <source>Haply device ready.</source>
        <translation>Haply-Gerät bereit.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no Haply device. Write haply:ID as &apos;relievo devices&apos; lists it, or haply for the only one.</source>
        <translation>&quot;%1&quot; benennt kein Haply-Gerät. Schreiben Sie haply:ID, wie &apos;relievo devices&apos; es nennt, oder haply für das einzige.</translation>
    </message>
    <message>
        <source>RELIEVO_HAPLY_SERVICE is &quot;%1&quot;, which is no port and no address with a port. Write 10001 or 127.0.0.1:10001, or unset it.</source>
        <translation>RELIEVO_HAPLY_SERVICE ist &quot;%1&quot;, und das ist kein Port und keine Adresse mit einem Port. Schreiben Sie 10001 oder 127.0.0.1:10001, oder entfernen Sie die Variable.</translation>
    </message>
    <message>
        <source>This relievo was built without Boost, which it needs to speak with Haply&apos;s Inverse Service. Install libboost-dev and build it again.</source>
        <translation>Dieses relievo wurde ohne Boost gebaut, das es braucht, um mit Haplys Inverse Service zu sprechen. Installieren Sie libboost-dev und bauen Sie es neu.</translation>
    </message>
    <message>
        <source>The Haply device&apos;s thread could not be started: %1.</source>
        <translation>Der Thread des Haply-Geräts konnte nicht gestartet werden: %1.</translation>
    </message>
    <message>
        <source>The Haply device was not ready within %1, and nothing was recorded. %2</source>
        <translation>Das Haply-Gerät war nicht innerhalb von %1 bereit, und es wurde nichts aufgezeichnet. %2</translation>
    </message>
    <message>
        <source>A way that a hand is led along needs two different places, three of a closed one, in the order of their times.</source>
        <translation>Ein Weg, auf dem eine Hand geführt wird, braucht zwei verschiedene Orte, ein geschlossener drei, in der Reihenfolge ihrer Zeiten.</translation>
    </message>
    <message>
        <source>The way that the hand was led along is damaged in this recording: it cannot be replayed.</source>
        <translation>Der Weg, auf dem die Hand geführt wurde, ist in dieser Aufnahme beschädigt: Sie kann nicht wiederholt werden.</translation>
    </message>
    <message>
        <source>--guide leads a hand. Give one that can be led, with --device virtual:light, virtual:relaxed or virtual:firm, and leave --safety on.</source>
        <translation>--guide führt eine Hand. Geben Sie eine an, die sich führen lässt, mit --device virtual:light, virtual:relaxed oder virtual:firm, und lassen Sie --safety an.</translation>
    </message>
    <message>
        <source>There is no outline in this window to be led along: none that was measured all round. Choose another region, or give --guide a stroke.</source>
        <translation>In diesem Ausschnitt gibt es keinen Umriss zum Führen: keinen, der ringsum gemessen wurde. Wählen Sie einen anderen Bereich oder geben Sie --guide einen Handweg.</translation>
    </message>
    <message>
        <source>There is nothing to touch along. Give --stroke FILE.csv, or --guide.</source>
        <translation>Es gibt nichts, woran entlang gefühlt wird. Geben Sie --stroke DATEI.csv oder --guide an.</translation>
    </message>
    <message>
        <source>Guiding along %1. You lead: push against it, or press a button, and it lets go.</source>
        <translation>Ich führe Sie %1 entlang. Sie bestimmen: Drücken Sie dagegen oder drücken Sie einen Knopf, dann lasse ich los.</translation>
    </message>
    <message>
        <source>Guiding along %1, you lead.</source>
        <translation>Ich führe Sie %1 entlang, Sie bestimmen.</translation>
    </message>
    <message>
        <source>the outline of a raised area</source>
        <translation>am Umriss einer Erhebung</translation>
    </message>
    <message>
        <source>the outline of a sunken area</source>
        <translation>am Umriss einer Vertiefung</translation>
    </message>
    <message>
        <source>the border of the object</source>
        <translation>am Rand des Objekts</translation>
    </message>
    <message>
        <source>a recorded way</source>
        <translation>einen aufgezeichneten Weg</translation>
    </message>
    <message>
        <source>You lead.</source>
        <translation>Sie führen.</translation>
    </message>
    <message>
        <source>The guide has arrived.</source>
        <translation>Die Führung ist am Ziel.</translation>
    </message>
    <message>
        <source>The hand is at the marker.</source>
        <translation>Die Hand ist bei der Markierung.</translation>
    </message>
    <message>
        <source>The guide is off.</source>
        <translation>Die Führung ist aus.</translation>
    </message>
    <message>
        <source>The guide is off: the window is another one.</source>
        <translation>Die Führung ist aus: Der Ausschnitt ist ein anderer.</translation>
    </message>
    <message>
        <source>There is no outline here to be led along.</source>
        <translation>Hier gibt es keinen Umriss zum Führen.</translation>
    </message>
    <message>
        <source>The guide needs the forces. Press F5 to switch them on, then ask for it again.</source>
        <translation>Die Führung braucht die Kräfte. Schalten Sie sie mit F5 ein und verlangen Sie sie dann noch einmal.</translation>
    </message>
    <message>
        <source>The guide needs the forces. Switch them on first.</source>
        <translation>Die Führung braucht die Kräfte. Schalten Sie sie zuerst ein.</translation>
    </message>
    <message>
        <source>The guide needs a device that can move the hand.</source>
        <translation>Die Führung braucht ein Gerät, das die Hand bewegen kann.</translation>
    </message>
    <message>
        <source>Guide along the outline</source>
        <translation>Am Umriss entlangführen</translation>
    </message>
    <message>
        <source>Introduction: five shapes under the hand, one after the other. Next shape (Ctrl+Alt+N) or the button Forward goes on at once, Introduction again ends it.</source>
        <translation>Einführung: fünf Formen unter der Hand, eine nach der anderen. Nächste Form (Strg+Alt+N) oder der Knopf Vorwärts geht sofort weiter, Einführung noch einmal beendet sie.</translation>
    </message>
    <message>
        <source>Introduction: five shapes. The button Forward goes on.</source>
        <translation>Einführung: fünf Formen. Der Knopf Vorwärts geht weiter.</translation>
    </message>
    <message>
        <source>I switch the forces on now. They start softly.</source>
        <translation>Ich schalte jetzt die Kräfte ein. Sie beginnen sanft.</translation>
    </message>
    <message>
        <source>There is a flat plate. Push towards it and slide.</source>
        <translation>Da ist eine flache Platte. Drücken Sie darauf und gleiten Sie.</translation>
    </message>
    <message>
        <source>Now there is a bump. Find it.</source>
        <translation>Jetzt ist da ein Buckel. Finden Sie ihn.</translation>
    </message>
    <message>
        <source>Now there is a step. Go over its edge.</source>
        <translation>Jetzt ist da eine Stufe. Gehen Sie über ihre Kante.</translation>
    </message>
    <message>
        <source>Now there are waves. Stroke across them.</source>
        <translation>Jetzt sind da Wellen. Streichen Sie quer darüber.</translation>
    </message>
    <message>
        <source>Now there is a groove. Find it and follow it.</source>
        <translation>Jetzt ist da eine Rille. Finden Sie sie und folgen Sie ihr.</translation>
    </message>
    <message>
        <source>The bump is a little right and above the middle.</source>
        <translation>Der Buckel ist etwas rechts und über der Mitte.</translation>
    </message>
    <message>
        <source>The edge is in the middle. Go from left to right.</source>
        <translation>Die Kante ist in der Mitte. Gehen Sie von links nach rechts.</translation>
    </message>
    <message>
        <source>Go from left to right while you touch.</source>
        <translation>Gehen Sie beim Fühlen von links nach rechts.</translation>
    </message>
    <message>
        <source>The groove runs from left to right, above the middle.</source>
        <translation>Die Rille verläuft von links nach rechts, über der Mitte.</translation>
    </message>
    <message>
        <source>Push the grip away from you until it meets the plate.</source>
        <translation>Drücken Sie den Griff von sich weg, bis er auf die Platte trifft.</translation>
    </message>
    <message>
        <source>Yes.</source>
        <translation>Ja.</translation>
    </message>
    <message>
        <source>Let us go on.</source>
        <translation>Gehen wir weiter.</translation>
    </message>
    <message>
        <source>The introduction has ended. The relief is under the hand again.</source>
        <translation>Die Einführung ist zu Ende. Das Relief ist wieder unter der Hand.</translation>
    </message>
    <message>
        <source>The introduction is off. The relief is under the hand again.</source>
        <translation>Die Einführung ist aus. Das Relief ist wieder unter der Hand.</translation>
    </message>
    <message>
        <source>Gamepads that are no HID devices cannot be used: this program was built without the system&apos;s header linux/input.h.</source>
        <translation>Gamepads, die keine HID-Geräte sind, können nicht benutzt werden: Dieses Programm wurde ohne die Kopfdatei linux/input.h des Systems gebaut.</translation>
    </message>
    <message>
        <source>%1&apos;s library was not found, or cannot be used (%2)</source>
        <translation>die Bibliothek von %1 wurde nicht gefunden oder kann nicht benutzt werden (%2)</translation>
    </message>
    <message>
        <source>Look or touch</source>
        <translation>Betrachten oder fühlen</translation>
    </message>
    <message>
        <source>A pixel size is above 0 mm, and a height scale is not 0 mm.</source>
        <translation>Ein Pixelabstand ist größer als 0 mm, und ein Höhenmaßstab ist nicht 0 mm.</translation>
    </message>
    <message>
        <source>--every thins what is read into memory; a map by tiles (--memory) takes all points. Leave one of the two out.</source>
        <translation>--every dünnt aus, was in den Speicher gelesen wird; eine Karte in Kacheln (--memory) nimmt alle Punkte. Lassen Sie eines von beiden weg.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no participant code: 1 to 32 letters, digits, &apos;-&apos; and &apos;_&apos;, and no name. Nothing was begun.</source>
        <translation>„%1“ ist kein Teilnehmercode: 1 bis 32 Buchstaben, Ziffern, „-“ und „_“, und kein Name. Es wurde nichts begonnen.</translation>
    </message>
    <message>
        <source>A sitting needs a note on the participant&apos;s consent. Nothing was begun.</source>
        <translation>Eine Sitzung braucht eine Notiz zur Einwilligung der teilnehmenden Person. Es wurde nichts begonnen.</translation>
    </message>
    <message>
        <source>A study has 2 to 26 conditions, each shown 1 to 100 times; this has {1|%1 condition|%1 conditions}, %2 times. Nothing was begun.</source>
        <translation>Eine Studie hat 2 bis 26 Bedingungen, jede 1- bis 100-mal gezeigt; diese hat {1|%1 Bedingung|%1 Bedingungen}, %2-mal. Es wurde nichts begonnen.</translation>
    </message>
    <message>
        <source>No folder for the sitting could be made in %1: %2. Nothing was begun. Choose another folder.</source>
        <translation>In %1 konnte kein Ordner für die Sitzung angelegt werden: %2. Es wurde nichts begonnen. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The profile talk halves the colours&apos; size, which mixes the two eyes of an anaglyph and of alternate rows. Choose the profile anaglyph or archive. Nothing was made.</source>
        <translation>Das Profil talk halbiert die Größe der Farben, was die beiden Augen eines Anaglyphen und abwechselnder Zeilen vermischt. Wählen Sie das Profil anaglyph oder archive. Es wurde nichts erzeugt.</translation>
    </message>
    <message>
        <source>Cannot read %1: its %2 points need about %3 of memory; %4 are free. Nothing was loaded. Load one point in %5 (--every %5), about %6, or make the map by tiles (--memory).</source>
        <translation>%1 kann nicht gelesen werden: seine %2 Punkte brauchen etwa %3 Speicher; %4 sind frei. Es wurde nichts geladen. Laden Sie einen von %5 Punkten (--every %5), etwa %6, oder machen Sie die Karte in Kacheln (--memory).</translation>
    </message>
    <message>
        <source>The scan needs about %3 of memory, and %4 are free. Press Control and Enter to load one point in %5.</source>
        <translation>Der Scan braucht etwa %3 Speicher, %4 sind frei. Mit Steuerung und Eingabe wird einer von %5 Punkten geladen.</translation>
    </message>
    <message>
        <source>Cannot read %1: its %2 corners need about %3 of memory; %4 are free. Nothing was loaded. Close other programs, or simplify the mesh first.</source>
        <translation>%1 kann nicht gelesen werden: seine %2 Ecken brauchen etwa %3 Speicher; %4 sind frei. Es wurde nichts geladen. Schließen Sie andere Programme, oder vereinfachen Sie das Netz vorher.</translation>
    </message>
    <message>
        <source>--every: %1 has faces, which need all of its points. Nothing was loaded. Leave the option out, or simplify the mesh first.</source>
        <translation>--every: %1 hat Flächen, die alle seine Punkte brauchen. Es wurde nichts geladen. Lassen Sie die Option weg, oder vereinfachen Sie das Netz vorher.</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>Edges: the hand reached %1 mm right, %2 left, %3 up, %4 down, %5 out and %6 in.</source>
        <translation>Ränder: die Hand kam %1 mm nach rechts, %2 nach links, %3 nach oben, %4 nach unten, %5 heraus und %6 hinein.</translation>
    </message>
    <message>
        <source>Edges: the hand reached %1 mm right, %2 left, %3 up, %4 down, %5 out and %6 in; not to the end: %7.</source>
        <translation>Ränder: die Hand kam %1 mm nach rechts, %2 nach links, %3 nach oben, %4 nach unten, %5 heraus und %6 hinein; nicht bis zum Ende: %7.</translation>
    </message>
    <message>
        <source>right side</source>
        <translation>rechte Seite</translation>
    </message>
    <message>
        <source>left side</source>
        <translation>linke Seite</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>down</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>out</source>
        <translation>heraus</translation>
    </message>
    <message>
        <source>in</source>
        <translation>hinein</translation>
    </message>
    <message>
        <source>Move the grip to its end on every side and press each of the four buttons.</source>
        <translation>Bewegen Sie den Griff auf jeder Seite bis zum Ende und drücken Sie jeden der vier Knöpfe.</translation>
    </message>
    <message>
        <source>Move the grip to its end on every side and press each of the four buttons. Still missing: %1.</source>
        <translation>Bewegen Sie den Griff auf jeder Seite bis zum Ende und drücken Sie jeden der vier Knöpfe. Es fehlen noch: %1.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is %2; this version reads scans as %3, and rasters as GeoTIFF, TIFF, PNG or ESRI ASCII grid. Convert it to one of these, or choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Es ist %2; diese Version liest Scans als %3 und Raster als GeoTIFF, TIFF, PNG oder ESRI-ASCII-Gitter. Wandeln Sie die Datei in eines davon um oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>Cannot publish to %1: there is something already. It was left as it is. Give a folder that is empty or not there yet.</source>
        <translation>Nach %1 kann nicht veröffentlicht werden: Dort ist schon etwas. Es blieb, wie es ist. Geben Sie einen Ordner an, der leer ist oder den es noch nicht gibt.</translation>
    </message>
    <message>
        <source>%1 is no map by tiles, and so it cannot be published. Nothing was written. Make one with relievo depthmap --memory, and publish that.</source>
        <translation>%1 ist keine Karte aus Kacheln und kann darum nicht veröffentlicht werden. Nichts wurde geschrieben. Machen Sie eine mit relievo depthmap --memory und veröffentlichen Sie diese.</translation>
    </message>
    <message>
        <source>The published map %1 has no file %2 (%3). Look at the address, or publish the map again.</source>
        <translation>Die veröffentlichte Karte %1 hat keine Datei %2 (%3). Prüfen Sie die Adresse oder veröffentlichen Sie die Karte noch einmal.</translation>
    </message>
    <message>
        <source>The file %2 of the published map %1 is damaged: it is not what was published. It was not used. Publish the map again.</source>
        <translation>Die Datei %2 der veröffentlichten Karte %1 ist beschädigt: Sie ist nicht, was veröffentlicht wurde. Sie wurde nicht verwendet. Veröffentlichen Sie die Karte noch einmal.</translation>
    </message>
    <message>
        <source>A tile of level %2 of the published map %1 is damaged: its checksum is not the one that was published (%3). It was not used. Publish the map again.</source>
        <translation>Eine Kachel der Ebene %2 der veröffentlichten Karte %1 ist beschädigt: Ihre Prüfsumme ist nicht die veröffentlichte (%3). Sie wurde nicht verwendet. Veröffentlichen Sie die Karte noch einmal.</translation>
    </message>
    <message>
        <source>The map %1 cannot be fetched now: %2. Look at the network, and try again.</source>
        <translation>Die Karte %1 kann jetzt nicht geholt werden: %2. Prüfen Sie das Netz und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>There is no published map at %1: its map.json is none of this version. Give the address of a folder that relievo publish made.</source>
        <translation>Bei %1 ist keine veröffentlichte Karte: Die Datei map.json dort ist keine dieser Version. Geben Sie die Adresse eines Ordners an, den relievo publish gemacht hat.</translation>
    </message>
    <message>
        <source>%1 gives no answer. The map is shown as it was when it was last opened, with the tiles that were kept.</source>
        <translation>%1 antwortet nicht. Die Karte wird gezeigt, wie sie beim letzten Öffnen war, mit den Kacheln, die aufgehoben wurden.</translation>
    </message>
    <message>
        <source>The server gives no answer. The map is shown as it was kept.</source>
        <translation>Der Server antwortet nicht. Die Karte wird gezeigt, wie sie aufgehoben wurde.</translation>
    </message>
    <message>
        <source>Coarser until the tiles are here.</source>
        <translation>Gröber, bis die Kacheln da sind.</translation>
    </message>
    <message>
        <source>%1 gives no answer. What is here can be seen and felt; the rest is asked for again and again.</source>
        <translation>%1 antwortet nicht. Was da ist, kann gesehen und gefühlt werden; nach dem Übrigen wird immer wieder gefragt.</translation>
    </message>
    <message>
        <source>The server gives no answer. What is here can be felt.</source>
        <translation>Der Server antwortet nicht. Was da ist, kann gefühlt werden.</translation>
    </message>
    <message>
        <source>%1 answers again.</source>
        <translation>%1 antwortet wieder.</translation>
    </message>
    <message>
        <source>The server answers again.</source>
        <translation>Der Server antwortet wieder.</translation>
    </message>
    <message>
        <source>%1 is not JSON: line %2 cannot be read.</source>
        <translation>%1 ist kein JSON: Zeile %2 ist nicht lesbar.</translation>
    </message>
    <message>
        <source>%1 is no exhibit: it does not begin with &quot;relievo_exhibit&quot;: 1.</source>
        <translation>%1 ist keine Ausstellung: Die Datei beginnt nicht mit &quot;relievo_exhibit&quot;: 1.</translation>
    </message>
    <message>
        <source>%1 is an exhibit of version %2. This program reads version 1.</source>
        <translation>%1 ist eine Ausstellung der Version %2. Dieses Programm liest Version 1.</translation>
    </message>
    <message>
        <source>%1 cannot be shown as an exhibit. %2</source>
        <translation>%1 kann nicht als Ausstellung gezeigt werden. %2</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 fehlt.</translation>
    </message>
    <message>
        <source>%1 means nothing here. There are %2.</source>
        <translation>%1 bedeutet hier nichts. Es gibt %2.</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 muss %2 sein.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a list in square brackets</source>
        <translation>eine Liste in eckigen Klammern</translation>
    </message>
    <message>
        <source>a group in braces</source>
        <translation>eine Gruppe in geschweiften Klammern</translation>
    </message>
    <message>
        <source>%1 is %2; it must be from %3 to %4.</source>
        <translation>%1 ist %2; es muss von %3 bis %4 sein.</translation>
    </message>
    <message>
        <source>%1: relievo does not speak &apos;%2&apos;. It speaks %3.</source>
        <translation>%1: relievo spricht &apos;%2&apos; nicht. Es spricht %3.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; stands there twice.</source>
        <translation>%1: &apos;%2&apos; steht dort zweimal.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 ist leer.</translation>
    </message>
    <message>
        <source>%1 has %2 entries; it can have %3.</source>
        <translation>%1 hat %2 Einträge; %3 sind möglich.</translation>
    </message>
    <message>
        <source>%1: there is no file %2.</source>
        <translation>%1: Die Datei %2 gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 has no words.</source>
        <translation>%1 hat keine Wörter.</translation>
    </message>
    <message>
        <source>%1 has no text for the language &apos;%2&apos;.</source>
        <translation>%1 hat keinen Text für die Sprache &apos;%2&apos;.</translation>
    </message>
    <message>
        <source>%1 has a text for &apos;%2&apos;, which is none of the exhibit&apos;s languages (%3).</source>
        <translation>%1 hat einen Text für &apos;%2&apos;, das keine Sprache der Ausstellung ist (%3).</translation>
    </message>
    <message>
        <source>%1 has %2 words; it can have %3.</source>
        <translation>%1 hat %2 Wörter; %3 sind möglich.</translation>
    </message>
    <message>
        <source>staff_pin must hold a salt of up to 64 characters and 64 hexadecimal digits. &apos;relievo exhibit pin&apos; makes both.</source>
        <translation>staff_pin muss ein salt mit bis zu 64 Zeichen und 64 hexadezimale Ziffern haben. &apos;relievo exhibit pin&apos; macht beides.</translation>
    </message>
    <message>
        <source>The counts in %1 could not be read. They were set aside as %2, and counting begins anew.</source>
        <translation>Die Zählungen in %1 waren nicht lesbar. Sie wurden als %2 zur Seite gelegt, und das Zählen beginnt neu.</translation>
    </message>
    <message>
        <source>A PIN has 4 to 12 digits, one line on standard input. Nothing was made.</source>
        <translation>Eine PIN hat 4 bis 12 Ziffern, eine Zeile auf der Standardeingabe. Nichts wurde erzeugt.</translation>
    </message>
    <message>
        <source>exhibit %1 needs the file of the exhibit.</source>
        <translation>exhibit %1 braucht die Datei der Ausstellung.</translation>
    </message>
    <message>
        <source>exhibit pin takes no file. It prints what belongs into one.</source>
        <translation>exhibit pin nimmt keine Datei. Es gibt aus, was in eine gehört.</translation>
    </message>
    <message>
        <source>The exhibit ended %1 times within %2 minutes and was not started again. %3 says when and how.</source>
        <translation>Die Ausstellung endete %1-mal innerhalb von %2 Minuten und wurde nicht noch einmal gestartet. %3 sagt, wann und wie.</translation>
    </message>
    <message>
        <source>Welcome. You can touch reliefs here.</source>
        <translation>Willkommen. Hier können Sie Reliefs ertasten.</translation>
    </message>
    <message>
        <source>In front of you is a grip with four buttons.</source>
        <translation>Vor Ihnen ist ein Griff mit vier Knöpfen.</translation>
    </message>
    <message>
        <source>For English press the middle button.</source>
        <translation>Für Deutsch drücken Sie den mittleren Knopf.</translation>
    </message>
    <message>
        <source>The button Forward: another language.</source>
        <translation>Der Knopf Vorwärts: eine andere Sprache.</translation>
    </message>
    <message>
        <source>Plus is louder, Minus is softer.</source>
        <translation>Plus ist lauter, Minus ist leiser.</translation>
    </message>
    <message>
        <source>Object %1 of %2: %3.</source>
        <translation>Objekt %1 von %2: %3.</translation>
    </message>
    <message>
        <source>The middle button: touch it.</source>
        <translation>Der mittlere Knopf: es ertasten.</translation>
    </message>
    <message>
        <source>Forward: the next one. Forward held: say it again.</source>
        <translation>Vorwärts: das nächste. Vorwärts gehalten: noch einmal sagen.</translation>
    </message>
    <message>
        <source>One moment please.</source>
        <translation>Einen Moment bitte.</translation>
    </message>
    <message>
        <source>Hold the grip lightly. The forces come on softly.</source>
        <translation>Halten Sie den Griff locker. Die Kräfte kommen sanft.</translation>
    </message>
    <message>
        <source>Middle: where am I. Plus: closer. Minus: wider. Forward: move.</source>
        <translation>Mitte: wo bin ich. Plus: näher. Minus: weiter. Vorwärts: verschieben.</translation>
    </message>
    <message>
        <source>Minus held: the whole relief, then other objects.</source>
        <translation>Minus gehalten: das ganze Relief, dann andere Objekte.</translation>
    </message>
    <message>
        <source>Are you still there? Press any button, or I will stop.</source>
        <translation>Sind Sie noch da? Drücken Sie einen Knopf, sonst höre ich auf.</translation>
    </message>
    <message>
        <source>Goodbye.</source>
        <translation>Auf Wiedersehen.</translation>
    </message>
    <message>
        <source>This object cannot be touched now.</source>
        <translation>Dieses Objekt kann jetzt nicht ertastet werden.</translation>
    </message>
    <message>
        <source>This exhibit needs help. Please ask the staff.</source>
        <translation>Diese Station braucht Hilfe. Bitte fragen Sie das Personal.</translation>
    </message>
    <message>
        <source>Staff: type the PIN, then Enter. Escape goes back.</source>
        <translation>Personal: PIN eingeben, dann Enter. Escape führt zurück.</translation>
    </message>
    <message>
        <source>That is not the PIN. {1|%1 try is|%1 tries are} left.</source>
        <translation>Das ist nicht die PIN. Noch {1|%1 Versuch|%1 Versuche}.</translation>
    </message>
    <message>
        <source>Too many tries. A PIN is taken again in %1 s.</source>
        <translation>Zu viele Versuche. In %1 s wird wieder eine PIN angenommen.</translation>
    </message>
    <message>
        <source>A map of %1 x %2 samples cannot be exported.</source>
        <translation>Eine Karte von %1 x %2 Punkten kann nicht exportiert werden.</translation>
    </message>
    <message>
        <source>The map has no height anywhere, so there is nothing to export.</source>
        <translation>Die Karte hat nirgends eine Höhe; es gibt nichts zu exportieren.</translation>
    </message>
    <message>
        <source>A plate to print needs a thickness above 0.</source>
        <translation>Eine Platte zum Drucken braucht eine Dicke über 0.</translation>
    </message>
    <message>
        <source>The map has more triangles than an STL file can count. Use fewer cells.</source>
        <translation>Die Karte hat mehr Dreiecke, als eine STL-Datei zählen kann. Nehmen Sie weniger Zellen.</translation>
    </message>
    <message>
        <source>No four neighbouring cells have a height, so there is no surface to export as glTF. Nothing was written. Choose points (.xyz).</source>
        <translation>Keine vier benachbarten Zellen haben eine Höhe; es gibt keine Fläche, die als glTF exportiert werden kann. Nichts wurde geschrieben. Wählen Sie Punkte (.xyz).</translation>
    </message>
    <message>
        <source>The mesh has more than the 4 GB that a glTF file can hold. Nothing was written. Export a coarser level or a window.</source>
        <translation>Das Netz hat mehr als die 4 GB, die eine glTF-Datei fasst. Nichts wurde geschrieben. Exportieren Sie eine gröbere Stufe oder ein Fenster.</translation>
    </message>
    <message>
        <source>Another program cannot be started: no more than %1 files may be open at once here (ulimit -n), and it takes %2. Allow more and try again.</source>
        <translation>Ein weiteres Programm kann nicht gestartet werden: Hier dürfen höchstens %1 Dateien zugleich offen sein (ulimit -n), und es braucht %2. Erlauben Sie mehr und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Another program cannot be started: %1. Close other programs and try again.</source>
        <translation>Ein weiteres Programm kann nicht gestartet werden: %1. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Another program cannot be started: %1. Install relievo again, or give the right to run it.</source>
        <translation>Ein weiteres Programm kann nicht gestartet werden: %1. Installieren Sie relievo neu, oder geben Sie das Recht, es auszuführen.</translation>
    </message>
    <message>
        <source>Cannot write %1: a file of this name is there that relievo did not write. It was left as it is. Move it, or choose another name for the result.</source>
        <translation>%1 kann nicht geschrieben werden: Es gibt eine Datei dieses Namens, die relievo nicht geschrieben hat. Sie blieb, wie sie ist. Verschieben Sie sie, oder wählen Sie einen anderen Namen für das Ergebnis.</translation>
    </message>
    <message>
        <source>Cannot read %1: it is not a readable TIFF. Copy or export it again.</source>
        <translation>%1 kann nicht gelesen werden: Es ist kein lesbares TIFF. Kopieren oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Cannot read %1: its heights take %2 MB, and there is less room where they are kept meanwhile. Free some space, or write the result to another disk.</source>
        <translation>%1 kann nicht gelesen werden: Die Höhen brauchen %2 MB, und wo sie solange liegen, ist weniger Platz. Schaffen Sie Platz, oder schreiben Sie das Ergebnis auf einen anderen Datenträger.</translation>
    </message>
    <message>
        <source>The import cannot keep heights in %1: %2. Write the result to another folder.</source>
        <translation>Der Import kann in %1 keine Höhen ablegen: %2. Schreiben Sie das Ergebnis in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Cannot read %1: it holds more than %2 points, the limit. Thin it out or cut it into parts first.</source>
        <translation>%1 kann nicht gelesen werden: Die Datei enthält mehr als %2 Punkte; mehr geht nicht. Dünnen Sie sie vorher aus, oder teilen Sie sie.</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>Plus held: help, and louder, softer, say it again.</source>
        <translation>Plus gehalten: Hilfe, und lauter, leiser, noch einmal.</translation>
    </message>
    <message>
        <source>Hold the grip lightly. Nothing will pull you.</source>
        <translation>Halten Sie den Griff locker. Nichts zieht Sie.</translation>
    </message>
    <message>
        <source>Push it in as far as it goes, and pull it out.</source>
        <translation>Drücken Sie ihn ganz hinein, und ziehen Sie ihn heraus.</translation>
    </message>
    <message>
        <source>Now the buttons. Press any of them to go on.</source>
        <translation>Nun die Knöpfe. Drücken Sie einen, um weiterzugehen.</translation>
    </message>
    <message>
        <source>Middle button: where am I.</source>
        <translation>Mittlerer Knopf: wo bin ich.</translation>
    </message>
    <message>
        <source>Plus: closer. Plus held: help.</source>
        <translation>Plus: näher. Plus gehalten: Hilfe.</translation>
    </message>
    <message>
        <source>Minus: wider. Minus held: the whole relief.</source>
        <translation>Minus: weiter. Minus gehalten: das ganze Relief.</translation>
    </message>
    <message>
        <source>Forward: move. Forward held: a marker.</source>
        <translation>Vorwärts: verschieben. Vorwärts gehalten: eine Marke.</translation>
    </message>
    <message>
        <source>Middle button held long: stop, and go on.</source>
        <translation>Mittlerer Knopf lang gehalten: anhalten und weitermachen.</translation>
    </message>
    <message>
        <source>You feel all of it now.</source>
        <translation>Sie fühlen es jetzt ganz.</translation>
    </message>
    <message>
        <source>Shall I guide your hand along the outline once?</source>
        <translation>Soll ich Ihre Hand einmal am Umriss entlangführen?</translation>
    </message>
    <message>
        <source>Plus for yes, Minus for no.</source>
        <translation>Plus für ja, Minus für nein.</translation>
    </message>
    <message>
        <source>Now touch as you like.</source>
        <translation>Fühlen Sie nun, wie Sie möchten.</translation>
    </message>
    <message>
        <source>Not measured here. The real surface is missing in the scan.</source>
        <translation>Hier nicht gemessen. Die wirkliche Oberfläche fehlt im Scan.</translation>
    </message>
    <message>
        <source>Forces off. Middle button held long: on again.</source>
        <translation>Kräfte aus. Mittlerer Knopf lang gehalten: wieder an.</translation>
    </message>
    <message>
        <source>Take the grip again to go on.</source>
        <translation>Nehmen Sie den Griff wieder, um weiterzumachen.</translation>
    </message>
    <message>
        <source>Now Plus is louder and Minus is softer.</source>
        <translation>Jetzt ist Plus lauter und Minus leiser.</translation>
    </message>
    <message>
        <source>Middle button: say it again. Forward: back to touching.</source>
        <translation>Mittlerer Knopf: noch einmal sagen. Vorwärts: zurück zum Fühlen.</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>The next one</source>
        <translation>Das nächste</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>One button. Press: I offer where am I, finer, coarser, whole object, move, guide, forces, say it again, louder, softer, help. Press again to take what I said last. Hold for a second and a half: forces off.</source>
        <translation>Ein Knopf. Drücken: Ich biete an: wo bin ich, feiner, gröber, ganzes Objekt, verschieben, führen, Kräfte, noch einmal sagen, lauter, leiser, Hilfe. Noch einmal drücken nimmt, was ich zuletzt gesagt habe. Anderthalb Sekunden halten: Kräfte aus.</translation>
    </message>
    <message>
        <source>The plug-in %1 was not allowed, so that nothing was taken back.</source>
        <translation>Das Plugin %1 war nicht erlaubt; es wurde nichts zurückgenommen.</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. Nothing was changed. Name the maker&apos;s library itself, libdhd.so.3 for example.</source>
        <translation>Es gibt keine Datei „%1“. Nichts wurde geändert. Nennen Sie die Bibliothek des Herstellers selbst, etwa libdhd.so.3.</translation>
    </message>
    <message>
        <source>The settings of devices could not be written to &quot;%1&quot;. Nothing was changed. Check the folder&apos;s permissions.</source>
        <translation>Die Einstellungen der Geräte konnten nicht nach „%1“ geschrieben werden. Nichts wurde geändert. Prüfen Sie die Rechte des Ordners.</translation>
    </message>
    <message>
        <source>A Haply device was plugged in.</source>
        <translation>Ein Haply-Gerät wurde eingesteckt.</translation>
    </message>
    <message>
        <source>A Haply device was unplugged.</source>
        <translation>Ein Haply-Gerät wurde getrennt.</translation>
    </message>
    <message>
        <source>The Haply device connects and goes away again and again. Look at its cable, its plug and its power supply.</source>
        <translation>Das Haply-Gerät verbindet sich und verschwindet immer wieder. Sehen Sie nach seinem Kabel, seinem Stecker und seinem Netzteil.</translation>
    </message>
    <message>
        <source>The Haply device connects again and again. Look at its cable.</source>
        <translation>Das Haply-Gerät verbindet sich immer wieder neu. Sehen Sie nach seinem Kabel.</translation>
    </message>
    <message>
        <source>The battery of the Haply grip is low. Charge it.</source>
        <translation>Die Batterie des Haply-Griffs ist schwach. Laden Sie ihn auf.</translation>
    </message>
    <message>
        <source>The battery of the grip is low.</source>
        <translation>Die Batterie des Griffs ist schwach.</translation>
    </message>
    <message>
        <source>The Haply grip went to sleep. Press one of its buttons to wake it.</source>
        <translation>Der Haply-Griff ist eingeschlafen. Drücken Sie eine seiner Tasten, um ihn zu wecken.</translation>
    </message>
    <message>
        <source>The grip went to sleep.</source>
        <translation>Der Griff ist eingeschlafen.</translation>
    </message>
    <message>
        <source>The calibration of the Haply device failed. Put its grip into the inkwell again and wait until the light is steady.</source>
        <translation>Das Kalibrieren des Haply-Geräts ist misslungen. Stecken Sie seinen Griff noch einmal in die Halterung und warten Sie, bis das Licht ruhig leuchtet.</translation>
    </message>
    <message>
        <source>The calibration failed. Put the grip into the inkwell again.</source>
        <translation>Das Kalibrieren ist misslungen. Stecken Sie den Griff noch einmal in die Halterung.</translation>
    </message>
    <message>
        <source>The emergency stop of the Haply device was pressed. Forces are off until it is released.</source>
        <translation>Der Notaus des Haply-Geräts wurde gedrückt. Die Kräfte sind aus, bis er gelöst wird.</translation>
    </message>
    <message>
        <source>The emergency stop was pressed.</source>
        <translation>Der Notaus wurde gedrückt.</translation>
    </message>
    <message>
        <source>The emergency stop of the Haply device was released. F5 switches forces on again.</source>
        <translation>Der Notaus des Haply-Geräts wurde gelöst. F5 schaltet die Kräfte wieder an.</translation>
    </message>
    <message>
        <source>The emergency stop was released.</source>
        <translation>Der Notaus wurde gelöst.</translation>
    </message>
    <message>
        <source>A motor of the Haply device is held fast. Let its arm move freely.</source>
        <translation>Ein Motor des Haply-Geräts wird festgehalten. Lassen Sie seinem Arm freie Bewegung.</translation>
    </message>
    <message>
        <source>A motor is held fast.</source>
        <translation>Ein Motor wird festgehalten.</translation>
    </message>
    <message>
        <source>The Haply service holds the forces down, because the arm trembles. Hold the grip more firmly, or lower the strength.</source>
        <translation>Der Haply-Dienst hält die Kräfte klein, weil der Arm zittert. Halten Sie den Griff fester, oder verringern Sie die Stärke.</translation>
    </message>
    <message>
        <source>Forces are held down, because the arm trembles.</source>
        <translation>Die Kräfte werden klein gehalten, weil der Arm zittert.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds values outside 0 to 1, such as %2, and was not used. Scale them: 1 where the surface is stiff, 0 where it is softest.</source>
        <translation>„%1“ enthält Werte außerhalb von 0 bis 1, etwa %2, und wurde nicht verwendet. Skalieren Sie sie: 1, wo die Oberfläche steif ist, 0, wo sie am weichsten ist.</translation>
    </message>
    <message>
        <source>Maps by tiles are made by the method CPU. Nothing was made.</source>
        <translation>Karten in Kacheln entstehen mit dem Verfahren CPU. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>Heights other than front are for point clouds by the method CPU. Nothing was made.</source>
        <translation>Andere Höhen je Zelle als front gelten für Punktwolken mit dem Verfahren CPU. Nichts wurde gemacht.</translation>
    </message>
    <message>
        <source>The vertical exaggeration must be a finite number above 0; 1 is true to scale.</source>
        <translation>Die Überhöhung muss eine endliche Zahl über 0 sein; 1 ist maßstäblich.</translation>
    </message>
    <message>
        <source>The pyramid factor must be from 1.1 to 8. Nothing was made; 2 is the paper&apos;s.</source>
        <translation>Der Pyramidenfaktor muss zwischen 1.1 und 8 liegen. Nichts wurde gemacht; 2 ist der des Artikels.</translation>
    </message>
    <message>
        <source>The pyramid factor is so near to 1 that its levels do not fit into memory. Nothing was made; choose a larger one.</source>
        <translation>Der Pyramidenfaktor liegt so nahe bei 1, dass die Ebenen nicht in den Speicher passen. Nichts wurde gemacht; wählen Sie einen größeren.</translation>
    </message>
    <message>
        <source>The recording does not say where its stiffness map is. Nothing was replayed.</source>
        <translation>Die Aufzeichnung sagt nicht, wo ihre Steifigkeitskarte ist. Nichts wurde wiederholt.</translation>
    </message>
    <message>
        <source>--relief: shaded relief has no values. Choose another, or &apos;relievo render&apos;.</source>
        <translation>--relief: Das beleuchtete Relief hat keine Werte. Wählen Sie ein anderes, oder &apos;relievo render&apos;.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the stiffness map that was felt (checksum differs, E501). Nothing was replayed. Put the right one back, there or beside the recording.</source>
        <translation>„%1“ ist nicht die Steifigkeitskarte, die ertastet wurde (Prüfsumme verschieden, E501). Nichts wurde wiederholt. Legen Sie die richtige zurück, dorthin oder neben die Aufzeichnung.</translation>
    </message>
    <message>
        <source>Exaggeration, grip factor and number of windows must be above 0. Nothing was made.</source>
        <translation>Überhöhung, Griff-Faktor und Anzahl der Fenster müssen über 0 liegen. Es wurde nichts gemacht.</translation>
    </message>
    <message>
        <source>Bookmark: %1.</source>
        <translation>Lesezeichen: %1.</translation>
    </message>
    <message>
        <source>Resolution %1 of %2, window %3.</source>
        <translation>Auflösung %1 von %2, Ausschnitt %3.</translation>
    </message>
    <message>
        <source>Resolution %1 of %2, %4 wide.</source>
        <translation>Auflösung %1 von %2, %4 breit.</translation>
    </message>
    <message>
        <source>Finer resolution</source>
        <translation>Feinere Auflösung</translation>
    </message>
    <message>
        <source>Coarser resolution</source>
        <translation>Gröbere Auflösung</translation>
    </message>
    <message>
        <source>Resolution and scale</source>
        <translation>Auflösung und Maßstab</translation>
    </message>
    <message>
        <source>Next bookmark</source>
        <translation>Nächstes Lesezeichen</translation>
    </message>
    <message>
        <source>Previous bookmark</source>
        <translation>Voriges Lesezeichen</translation>
    </message>
    <message>
        <source>Plus: finer; long: resolution and scale. Minus: coarser; long: whole object. Forward: move; long: marker. Centre: where am I; long: forces off or on. Plus and Minus: look or touch; for two seconds: help; for five: introduction.</source>
        <translation>Plus: feiner; lang: Auflösung und Maßstab. Minus: gröber; lang: ganzes Objekt. Vorwärts: verschieben; lang: Markierung. Mitte: wo bin ich; lang: Kräfte aus oder an. Plus und Minus: Betrachten oder Fühlen; zwei Sekunden: Hilfe; fünf: Einführung.</translation>
    </message>
    <message>
        <source>Move mode. Push the grip to a side to go there. Plus: next bookmark. Minus: previous bookmark. Forward: done; long: guide along the outline. Centre: back; long: forces off or on. Plus and Minus for two seconds: help; for five: introduction.</source>
        <translation>Verschieben. Drücken Sie den Griff zur Seite, um dorthin zu gehen. Plus: nächstes Lesezeichen. Minus: voriges Lesezeichen. Vorwärts: fertig; lang: am Umriss entlangführen. Mitte: zurück; lang: Kräfte aus oder an. Plus und Minus zwei Sekunden: Hilfe; fünf: Einführung.</translation>
    </message>
    <message>
        <source>Move mode. Push the grip to a side to go there. Press: I offer done, next bookmark, previous bookmark, back, forces, say it again, louder, softer, help. Press again to take it. Hold for a second and a half: forces off.</source>
        <translation>Verschieben. Drücken Sie den Griff zur Seite, um dorthin zu gehen. Drücken: Ich biete an: fertig, nächstes Lesezeichen, voriges Lesezeichen, zurück, Kräfte, noch einmal sagen, lauter, leiser, Hilfe. Noch einmal drücken nimmt es. Anderthalb Sekunden halten: Kräfte aus.</translation>
    </message>
    <message>
        <source>A stiffness map must hold 200 x 200 numbers from 0 to 1.</source>
        <translation>Eine Steifigkeitskarte muss 200 x 200 Zahlen von 0 bis 1 enthalten.</translation>
    </message>
    <message>
        <source>The pyramid factor must be from 1.1 to 8.</source>
        <translation>Der Pyramidenfaktor muss zwischen 1,1 und 8 liegen.</translation>
    </message>
    <message>
        <source>Resolution %2 is on its way. Until it is here, resolution %1 is shown and felt.</source>
        <translation>Auflösung %2 ist unterwegs. Bis sie da ist, wird Auflösung %1 gezeigt und gefühlt.</translation>
    </message>
    <message>
        <source>Resolution %1 is here.</source>
        <translation>Auflösung %1 ist da.</translation>
    </message>
    <message>
        <source>Full resolution.</source>
        <translation>Volle Auflösung.</translation>
    </message>
    <message>
        <source>The graphics driver does not say how exact its depth buffer is. Use the method CPU instead.</source>
        <translation>Der Grafiktreiber sagt nicht, wie genau sein Tiefenpuffer ist. Verwenden Sie stattdessen das Verfahren CPU.</translation>
    </message>
    <message>
        <source>The graphics driver returned an empty depth buffer. Use the method CPU instead.</source>
        <translation>Der Grafiktreiber gab einen leeren Tiefenpuffer zurück. Verwenden Sie stattdessen das Verfahren CPU.</translation>
    </message>
    <message>
        <source>Grid: %1 samples across (%2).</source>
        <translation>Gitter: %1 Stützstellen in der Breite (%2).</translation>
    </message>
    <message>
        <source>mesh: the paper&apos;s grid of 800 samples</source>
        <translation>Netz: das Gitter des Aufsatzes mit 800 Stützstellen</translation>
    </message>
    <message>
        <source>all points lie on one spot</source>
        <translation>alle Punkte liegen auf einer Stelle</translation>
    </message>
    <message>
        <source>the points lie on a regular grid</source>
        <translation>die Punkte liegen auf einem regelmäßigen Gitter</translation>
    </message>
    <message>
        <source>%1 points a cell</source>
        <translation>%1 Punkte je Zelle</translation>
    </message>
    <message>
        <source>Seen from here the points lie on one line of cells, so that next to nothing can be seen or touched. Choose another view, or more cells.</source>
        <translation>Von hier gesehen liegen die Punkte auf einer Zeile von Zellen, sodass fast nichts zu sehen oder zu ertasten ist. Wählen Sie eine andere Ansicht oder mehr Zellen.</translation>
    </message>
    <message>
        <source>Heights: %1.</source>
        <translation>Höhen: %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>as chosen</source>
        <translation>wie gewählt</translation>
    </message>
    <message>
        <source>depth buffer</source>
        <translation>Tiefenpuffer</translation>
    </message>
    <message>
        <source>one point at each sample</source>
        <translation>ein Punkt an jeder Stützstelle</translation>
    </message>
    <message>
        <source>%1 points per cell</source>
        <translation>%1 Punkte pro Zelle</translation>
    </message>
    <message>
        <source>%1 points per cell in several layers</source>
        <translation>%1 Punkte pro Zelle in mehreren Schichten</translation>
    </message>
    <message>
        <source>%1 points per cell in one layer</source>
        <translation>%1 Punkte pro Zelle in einer Schicht</translation>
    </message>
    <message>
        <source>front-most point</source>
        <translation>vorderster Punkt</translation>
    </message>
    <message>
        <source>second point from the front</source>
        <translation>zweiter Punkt von vorn</translation>
    </message>
    <message>
        <source>mean of the top layer</source>
        <translation>Mittel der obersten Schicht</translation>
    </message>
    <message>
        <source>median of the points</source>
        <translation>Median der Punkte</translation>
    </message>
    <message>
        <source>mean of the points</source>
        <translation>Mittel der Punkte</translation>
    </message>
    <message>
        <source>bilinear splat</source>
        <translation>bilineare Verteilung</translation>
    </message>
    <message>
        <source>local quadratic</source>
        <translation>lokale quadratische Fläche</translation>
    </message>
    <message>
        <source>rear-most point</source>
        <translation>hinterster Punkt</translation>
    </message>
    <message>
        <source>Depth buffer of %1 bits over %2: steps of %3, heights exact to %4.</source>
        <translation>Tiefenpuffer mit %1 Bit über %2: Schritte von %3, Höhen auf %4 genau.</translation>
    </message>
    <message>
        <source>Depth buffer of %1 bits, floating point, over %2: steps of %3, heights exact to %4.</source>
        <translation>Tiefenpuffer mit %1 Bit, Gleitkomma, über %2: Schritte von %3, Höhen auf %4 genau.</translation>
    </message>
    <message>
        <source>The object is as thick one way as the other; its best-fit plane is not certain.</source>
        <translation>Das Objekt ist in der einen Richtung so dick wie in der anderen; seine ausgleichende Ebene ist nicht sicher.</translation>
    </message>
    <message>
        <source>The object is as long one way as the other; its principal axes are not certain.</source>
        <translation>Das Objekt ist in der einen Richtung so lang wie in der anderen; seine Hauptachsen sind nicht sicher.</translation>
    </message>
    <message>
        <source>%1 of %2 holes filled. The largest left (%3 mm2) is larger than the limit of %4 mm2 and now rests on the base plane.</source>
        <translation>%1 von %2 {2|Loch|Löchern} gefüllt. Das größte übrige (%3 mm2) ist größer als die Grenze von %4 mm2 und liegt nun auf der Grundebene.</translation>
    </message>
    <message>
        <source>%1 of %2 holes filled. The largest left (%3 mm2) is too large for a membrane or has too little rim and now rests on the base plane.</source>
        <translation>%1 von %2 {2|Loch|Löchern} gefüllt. Das größte übrige (%3 mm2) ist zu groß für eine Membran oder hat zu wenig Rand und liegt nun auf der Grundebene.</translation>
    </message>
    <message>
        <source>Seen from here %1 of the scan is hidden and cannot be felt. Turn the object, or continue.</source>
        <translation>Von hier gesehen sind %1 des Scans verdeckt und nicht zu ertasten. Drehen Sie das Objekt, oder machen Sie weiter.</translation>
    </message>
    <message>
        <source>%1 points far off all their neighbours were left out.</source>
        <translation>{1|%1 Punkt, der weit von allen seinen Nachbarn liegt, wurde|%1 Punkte, die weit von allen ihren Nachbarn liegen, wurden} weggelassen.</translation>
    </message>
    <message>
        <source>%1 cells showed the object&apos;s back through gaps of its front; they were interpolated instead.</source>
        <translation>{1|%1 Zelle zeigte|%1 Zellen zeigten} durch Lücken der Vorderseite die Rückseite des Objekts; {1|sie wurde|sie wurden} stattdessen interpoliert.</translation>
    </message>
    <message>
        <source>Most cells are interpolated: %1 of the map is measured. A coarser grid would rest on more.</source>
        <translation>Die meisten Zellen sind interpoliert: %1 der Karte sind gemessen. Ein gröberes Gitter würde auf mehr Messwerten ruhen.</translation>
    </message>
    <message>
        <source>In %1 of the cells the points lie in several layers, front and back, and the chosen height per cell makes one height of them. Choose the mean of the top layer (topmean) to keep them apart.</source>
        <translation>In %1 der Zellen liegen die Punkte in mehreren Schichten, vorn und hinten, und die gewählte Höhe je Zelle macht eine Höhe daraus. Wählen Sie das Mittel der obersten Schicht (topmean), um sie zu trennen.</translation>
    </message>
    <message>
        <source>%1 of %2 points {1|lies|lie} %3 of the box away from all others; {1|it was|they were} left out.</source>
        <translation>%1 von %2 Punkten {1|liegt|liegen} %3 des Quaders von allen anderen entfernt; {1|er wurde|sie wurden} weggelassen.</translation>
    </message>
    <message>
        <source>%1 of %2 points {1|lies|lie} %3 of the box away from all others; {1|it was|they were} kept.</source>
        <translation>%1 von %2 Punkten {1|liegt|liegen} %3 des Quaders von allen anderen entfernt; {1|er wurde|sie wurden} behalten.</translation>
    </message>
    <message>
        <source>{1|%1 vertex belongs|%1 vertices belong} to no face and {1|lies|lie} outside of the object; {1|it was|they were} left out.</source>
        <translation>{1|%1 Eckpunkt gehört|%1 Eckpunkte gehören} zu keiner Fläche und {1|liegt|liegen} außerhalb des Objekts; {1|er wurde|sie wurden} weggelassen.</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together %3 of the box away from all others; they were left out.</source>
        <translation>%1 von %2 Punkten {1|liegt|liegen} zusammen %3 des Quaders von allen anderen entfernt; {1|er wurde|sie wurden} weggelassen.</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together %3 of the box away from all others; they were kept, as they may belong to the object.</source>
        <translation>%1 von %2 Punkten {1|liegt|liegen} zusammen %3 des Quaders von allen anderen entfernt; {1|er wurde|sie wurden} behalten, da {1|er|sie} zum Objekt gehören {1|kann|können}.</translation>
    </message>
    <message>
        <source>%1 of %2 heights are %3, which often stands for a missing one; they were left out. Say --nodata none to take them as heights, --nodata %3 to leave them out without this message.</source>
        <translation>%1 von %2 Höhen sind %3, was oft für eine fehlende steht; sie wurden weggelassen. Geben Sie --nodata none an, um sie als Höhen zu nehmen, --nodata %3, um sie ohne diese Meldung wegzulassen.</translation>
    </message>
    <message>
        <source>%1 {1|height of|heights of} %2 {1|was|were} taken as missing.</source>
        <translation>%1 {1|Höhe|Höhen} von %2 {1|wurde|wurden} als fehlend genommen.</translation>
    </message>
    <message>
        <source>The points carry no unit; one file unit was taken as 1 %1, a guess: %2. Give the unit if it is another, for example feet.</source>
        <translation>Die Punkte tragen keine Einheit; eine Einheit der Datei wurde als 1 %1 genommen, eine Vermutung: %2. Geben Sie die Einheit an, wenn es eine andere ist, zum Beispiel Fuß.</translation>
    </message>
    <message>
        <source>The points carry no unit; one file unit was taken as 1 mm. Give the unit if it is another.</source>
        <translation>Die Punkte tragen keine Einheit; eine Einheit der Datei wurde als 1 mm genommen. Geben Sie die Einheit an, wenn es eine andere ist.</translation>
    </message>
    <message>
        <source>The points carry no unit; one file unit was taken as 1 mm. Give the unit if it is another. More likely is %1, %2 x %3 x %4 mm: %5.</source>
        <translation>Die Punkte tragen keine Einheit; eine Einheit der Datei wurde als 1 mm genommen. Geben Sie die Einheit an, wenn es eine andere ist. Wahrscheinlicher ist %1, %2 x %3 x %4 mm: %5.</translation>
    </message>
    <message>
        <source>its coordinates are those of a map projection</source>
        <translation>die Koordinaten sind die einer Kartenprojektion</translation>
    </message>
    <message>
        <source>it lies as far off as in a map projection</source>
        <translation>der Scan liegt so weit ab wie in einer Kartenprojektion</translation>
    </message>
    <message>
        <source>files of this format are in metres as a rule</source>
        <translation>Dateien dieses Formats sind in der Regel in Metern</translation>
    </message>
    <message>
        <source>it is smaller than anything scanned in millimetres</source>
        <translation>der Scan ist kleiner als alles, was in Millimetern gescannt wird</translation>
    </message>
    <message>
        <source>an object of this shape is seldom as small</source>
        <translation>ein Objekt dieser Form ist selten so klein</translation>
    </message>
    <message>
        <source>it is larger than most that is in millimetres</source>
        <translation>der Scan ist größer als das meiste, was in Millimetern ist</translation>
    </message>
    <message>
        <source>of its size</source>
        <translation>der Größe wegen</translation>
    </message>
    <message>
        <source>The raster does not say how large it is; its samples were taken to lie %1 apart, and a step of its values to be %2 high. Say --pixel-size and --height-scale in mm; --height-zero is the value on the base plane.</source>
        <translation>Das Raster sagt nicht, wie groß es ist; als Abstand seiner Abtastwerte wurde %1 genommen, als Höhe einer Stufe seiner Werte %2. Geben Sie --pixel-size und --height-scale in mm an; --height-zero ist der Wert auf der Grundebene.</translation>
    </message>
    <message>
        <source>The raster does not say how large it is; its samples were taken to lie %1 apart, and a step of its values to be %2 high, a guess: with steps of a unit it would be higher than it is long, with these it is about a tenth as high. Say --pixel-size and --height-scale in mm; --height-zero is the value on the base plane.</source>
        <translation>Das Raster sagt nicht, wie groß es ist; als Abstand seiner Abtastwerte wurde %1 genommen, als Höhe einer Stufe seiner Werte %2, eine Vermutung: mit Stufen von einer Einheit wäre es höher als lang, mit diesen ist es etwa ein Zehntel so hoch. Geben Sie --pixel-size und --height-scale in mm an; --height-zero ist der Wert auf der Grundebene.</translation>
    </message>
    <message>
        <source>The map has no origins of its own; every height was taken as measured.</source>
        <translation>Die Karte hat keine eigenen Angaben zur Herkunft; jede Höhe wurde als gemessen genommen.</translation>
    </message>
    <message>
        <source>A map written by this program is taken as it is; its holes were not treated anew.</source>
        <translation>Eine Karte, die dieses Programm geschrieben hat, wird genommen, wie sie ist; ihre Löcher wurden nicht neu behandelt.</translation>
    </message>
    <message>
        <source>The map has colours beside it; the relief images &apos;natural&apos; and &apos;intensity&apos; show what there is.</source>
        <translation>Neben der Karte liegen Farben; die Reliefbilder „natürliche Farben“ und „Intensität“ zeigen, was da ist.</translation>
    </message>
    <message>
        <source>%1 The map is shown without colours.</source>
        <translation>%1 Die Karte wird ohne Farben gezeigt.</translation>
    </message>
    <message>
        <source>The scan has colours; %1 of the measured cells have one of their own. The relief image &apos;natural&apos; shows them.</source>
        <translation>Der Scan hat Farben; %1 der gemessenen Zellen haben eine eigene. Das Reliefbild „natürliche Farben“ zeigt sie.</translation>
    </message>
    <message>
        <source>The scan has intensities; %1 of the measured cells have one of their own. The relief image &apos;intensity&apos; shows them, black at %2 and white at %3.</source>
        <translation>Der Scan hat Intensitäten; %1 der gemessenen Zellen haben eine eigene. Das Reliefbild „Intensität“ zeigt sie, schwarz bei %2 und weiß bei %3.</translation>
    </message>
    <message>
        <source>A first view from %1 % of the points.</source>
        <translation>Eine erste Ansicht aus %1 % der Punkte.</translation>
    </message>
    <message>
        <source>The points were merged as they came; stray points were not looked for.</source>
        <translation>Die Punkte wurden zusammengefasst, wie sie kamen; nach Streupunkten wurde nicht gesucht.</translation>
    </message>
    <message>
        <source>Went on with earlier work: %1 points were in tiles, %2 of %3 rows of tiles had their heights.</source>
        <translation>Eine frühere Arbeit wurde fortgesetzt: {1|%1 Punkt war|%1 Punkte waren} auf Kacheln verteilt, %2 von %3 Kachelzeilen {2|hatte|hatten} Höhen.</translation>
    </message>
    <message>
        <source>%1 of its files were damaged and were made anew.</source>
        <translation>{1|%1 ihrer Dateien war beschädigt und wurde|%1 ihrer Dateien waren beschädigt und wurden} neu erzeugt.</translation>
    </message>
    <message>
        <source>The scan&apos;s colours were left out: with them this map needs about %1 MB of memory. Allow more with --memory.</source>
        <translation>Die Farben des Scans wurden weggelassen: mit ihnen braucht diese Karte etwa %1 MB Speicher. Erlauben Sie mit --memory mehr.</translation>
    </message>
    <message>
        <source>Colours beside a map are not read by tiles; its levels are made without. Leave out --memory, or make the map from its scan.</source>
        <translation>Farben neben einer Karte werden nicht kachelweise gelesen; ihre Ebenen werden ohne sie gemacht. Lassen Sie --memory weg, oder machen Sie die Karte aus ihrem Scan.</translation>
    </message>
    <message>
        <source>Points and spread per cell are known for point clouds by the method CPU only; no quality map was written.</source>
        <translation>Punkte und Streuung je Zelle sind nur für Punktwolken mit dem Verfahren CPU bekannt; es wurde keine Qualitätskarte geschrieben.</translation>
    </message>
    <message>
        <source>The file is incomplete: its header promises {1|%1 point|%1 points}, it ends at %2. What is there was loaded.</source>
        <translation>Die Datei ist unvollständig: Ihr Dateikopf verspricht {1|%1 Punkt|%1 Punkte}, sie endet bei %2. Geladen wurde, was da ist.</translation>
    </message>
    <message>
        <source>The file is incomplete: its header promises {1|%1 face|%1 faces}, it ends at %2. What is there was loaded.</source>
        <translation>Die Datei ist unvollständig: Ihr Dateikopf verspricht {1|%1 Fläche|%1 Flächen}, sie endet bei %2. Geladen wurde, was da ist.</translation>
    </message>
    <message>
        <source>The file is incomplete: its header promises %1 bytes, it ends at %2. What is there was loaded.</source>
        <translation>Die Datei ist unvollständig: Ihr Dateikopf verspricht %1 Bytes, sie endet bei %2. Geladen wurde, was da ist.</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 face|%2 faces}, file ends at %3. Nothing was loaded. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht {2|%2 Fläche|%2 Flächen}, die Datei endet bei %3. Nichts wurde geladen. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises {2|%2 face|%2 faces}, file ends at %3. Nothing was loaded. Load the {4|%4 point|%4 points} and {3|%3 complete face|%3 complete faces}, or choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht {2|%2 Fläche|%2 Flächen}, die Datei endet bei %3. Nichts wurde geladen. Laden Sie {4|den %4 Punkt|die %4 Punkte} und {3|die %3 vollständige Fläche|die %3 vollständigen Flächen}, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises %2 bytes, file ends at %3. Nothing was loaded. Choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht %2 Bytes, die Datei endet bei %3. Nichts wurde geladen. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read %1: header promises %2 bytes, file ends at %3. Nothing was loaded. Load the {4|%4 complete point|%4 complete points}, or choose another file.</source>
        <translation>%1 kann nicht gelesen werden: Der Dateikopf verspricht %2 Bytes, die Datei endet bei %3. Nichts wurde geladen. Laden Sie {4|den %4 vollständigen Punkt|die %4 vollständigen Punkte}, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>{1|%1 face has|%1 faces have} dents and more than 4096 corners; {1|it was|they were} cut into triangles without regard to these. Split them where they were made.</source>
        <translation>{1|%1 Fläche hat|%1 Flächen haben} einspringende Ecken und mehr als 4096 Ecken; {1|sie wurde|sie wurden} ohne Rücksicht darauf in Dreiecke zerlegt. Teilen Sie sie dort, wo sie entstanden sind.</translation>
    </message>
    <message>
        <source>%1 of %2 faces {1|was|were} left out: they name points that are not there or not finite, or have fewer than three corners.</source>
        <translation>%1 von %2 Flächen {1|wurde|wurden} weggelassen: Sie nennen Punkte, die fehlen oder nicht endlich sind, oder haben weniger als drei Ecken.</translation>
    </message>
    <message>
        <source>One point in %1 was taken: %2 of %3.</source>
        <translation>Einer von %1 Punkten wurde genommen: %2 von %3.</translation>
    </message>
    <message>
        <source>{1|%1 point|%1 points} beyond 1e38 {1|was|were} left out; they are no measurements.</source>
        <translation>{1|%1 Punkt|%1 Punkte} jenseits von 1e38 {1|wurde|wurden} weggelassen; das sind keine Messwerte.</translation>
    </message>
    <message>
        <source>The scan has one point only.</source>
        <translation>Der Scan hat nur einen Punkt.</translation>
    </message>
    <message>
        <source>All points are the same.</source>
        <translation>Alle Punkte sind gleich.</translation>
    </message>
    <message>
        <source>Its colours hold numbers beyond 65535, which mean nothing known; they were left out.</source>
        <translation>Ihre Farben enthalten Zahlen über 65535, die nichts Bekanntes bedeuten; sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>Its colours hold nothing but 0 and 1; they were taken as none and all of red, green, blue.</source>
        <translation>Ihre Farben enthalten nur 0 und 1; sie wurden als nichts und alles von Rot, Grün, Blau genommen.</translation>
    </message>
    <message>
        <source>%1: its colours are not of the form of those before; no colours are taken.</source>
        <translation>%1: Ihre Farben haben nicht die Form der vorigen; es werden keine Farben übernommen.</translation>
    </message>
    <message>
        <source>And %1 more such {1|remark|remarks} on the files.</source>
        <translation>Und {1|%1 weitere Bemerkung|%1 weitere Bemerkungen} dieser Art zu den Dateien.</translation>
    </message>
    <message>
        <source>Commas were read as decimal points.</source>
        <translation>Kommas wurden als Dezimalzeichen gelesen.</translation>
    </message>
    <message>
        <source>Line %1 names no columns x, y, z; the first three columns were taken.</source>
        <translation>Zeile %1 nennt keine Spalten x, y, z; die ersten drei Spalten wurden genommen.</translation>
    </message>
    <message>
        <source>The first line promises %1 points; the file holds %2, and all were loaded.</source>
        <translation>Die erste Zeile verspricht %1 Punkte; die Datei enthält %2, und alle wurden geladen.</translation>
    </message>
    <message>
        <source>Header line %1 (&quot;%2&quot;) is not of PLY; it was passed over.</source>
        <translation>Zeile %1 des Dateikopfs („%2“) gehört nicht zu PLY; sie wurde übergangen.</translation>
    </message>
    <message>
        <source>Header line %1 (&quot;%2&quot;) is not of PCD; it was passed over.</source>
        <translation>Zeile %1 des Dateikopfs („%2“) gehört nicht zu PCD; sie wurde übergangen.</translation>
    </message>
    <message>
        <source>The file ends early, within &quot;%1&quot;; all points were loaded.</source>
        <translation>Die Datei endet zu früh, mitten in „%1“; alle Punkte wurden geladen.</translation>
    </message>
    <message>
        <source>Its &quot;%1&quot; records are of a kind that is not read; the points were loaded without faces.</source>
        <translation>Ihre Einträge „%1“ sind von einer Art, die nicht gelesen wird; die Punkte wurden ohne Flächen geladen.</translation>
    </message>
    <message>
        <source>Its faces have colours, its points none; colours of faces are not read. Save it with colours of vertices.</source>
        <translation>Ihre Flächen haben Farben, ihre Punkte keine; Farben von Flächen werden nicht gelesen. Speichern Sie sie mit Farben der Punkte.</translation>
    </message>
    <message>
        <source>Bytes after the last triangle were ignored.</source>
        <translation>Bytes nach dem letzten Dreieck wurden nicht beachtet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, which it names, %2; the mesh was loaded without it.</source>
        <translation>„%1“, von der Datei genannt, %2; das Netz wurde ohne dies geladen.</translation>
    </message>
    <message>
        <source>lies outside its folder and was not opened</source>
        <translation>liegt außerhalb ihres Ordners und wurde nicht geöffnet</translation>
    </message>
    <message>
        <source>is not there</source>
        <translation>ist nicht da</translation>
    </message>
    <message>
        <source>is no file, or too large</source>
        <translation>ist keine Datei oder zu groß</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>is one picture too many</source>
        <translation>ist ein Bild zu viel</translation>
    </message>
    <message>
        <source>carries more metadata than are taken</source>
        <translation>trägt mehr Metadaten, als übernommen werden</translation>
    </message>
    <message>
        <source>is no PNG, JPEG or TIFF picture</source>
        <translation>ist kein Bild in PNG, JPEG oder TIFF</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than are taken</source>
        <translation>hat %1 x %2 Pixel, mehr, als übernommen werden</translation>
    </message>
    <message>
        <source>is no picture of 8 or 16 bits</source>
        <translation>ist kein Bild mit 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>cannot be decoded (%1)</source>
        <translation>kann nicht entschlüsselt werden (%1)</translation>
    </message>
    <message>
        <source>%1 of %2 scans {1|was|were} left out: %3.</source>
        <translation>%1 von %2 Scans {1|wurde|wurden} weggelassen: %3.</translation>
    </message>
    <message>
        <source>%1 of %2 scans {1|was|were} left out: %3 and others.</source>
        <translation>%1 von %2 Scans {1|wurde|wurden} weggelassen: %3 und andere.</translation>
    </message>
    <message>
        <source>scan %1 (%2)</source>
        <translation>Scan %1 (%2)</translation>
    </message>
    <message>
        <source>scan %1 &quot;%2&quot; (%3)</source>
        <translation>Scan %1 „%2“ (%3)</translation>
    </message>
    <message>
        <source>%1 of its points {1|is|are} marked as withheld (not to be used) and {1|was|were} taken all the same.</source>
        <translation>%1 ihrer Punkte {1|ist|sind} als zurückgehalten (nicht zu verwenden) gekennzeichnet und {1|wurde|wurden} trotzdem genommen.</translation>
    </message>
    <message>
        <source>%1 of its points {1|is|are} marked as withheld (not to be used) and {1|was|were} left out. They can be taken, too (--keep-withheld).</source>
        <translation>%1 ihrer Punkte {1|ist|sind} als zurückgehalten (nicht zu verwenden) gekennzeichnet und {1|wurde|wurden} weggelassen. Sie können mitgenommen werden (--keep-withheld).</translation>
    </message>
    <message>
        <source>Bytes after the last of the points that the header promises were ignored.</source>
        <translation>Bytes nach dem letzten der Punkte, die der Dateikopf verspricht, wurden nicht beachtet.</translation>
    </message>
    <message>
        <source>Its heights are in %1, its x and y in %2; heights were converted to %2.</source>
        <translation>Ihre Höhen sind in %1, ihre x und y in %2; die Höhen wurden in %2 umgerechnet.</translation>
    </message>
    <message>
        <source>Its x and y are degrees, not lengths, so shapes will be wrong. Reproject it to metres, for example with pdal translate and filters.reprojection.</source>
        <translation>Ihre x und y sind Grad und keine Längen, sodass Formen falsch werden. Projizieren Sie sie in Meter um, zum Beispiel mit pdal translate und filters.reprojection.</translation>
    </message>
    <message>
        <source>It states a unit %1, which is not known here; state it (--unit).</source>
        <translation>Sie nennt eine Einheit %1, die hier nicht bekannt ist; geben Sie sie an (--unit).</translation>
    </message>
    <message>
        <source>It names its coordinate system, EPSG:%1, which is not known here, and no unit; state it (--unit).</source>
        <translation>Sie nennt ihr Koordinatensystem, EPSG:%1, das hier nicht bekannt ist, und keine Einheit; geben Sie sie an (--unit).</translation>
    </message>
    <message>
        <source>It names its coordinate system, EPSG:%1, whose x and y are degrees, not lengths, so shapes will be wrong. Reproject it to metres.</source>
        <translation>Sie nennt ihr Koordinatensystem, EPSG:%1, dessen x und y Grad und keine Längen sind, sodass Formen falsch werden. Projizieren Sie sie in Meter um.</translation>
    </message>
    <message>
        <source>It names its coordinate system, EPSG:%1, whose unit of %2 m is not known here; state it (--unit).</source>
        <translation>Sie nennt ihr Koordinatensystem, EPSG:%1, dessen Einheit von %2 m hier nicht bekannt ist; geben Sie sie an (--unit).</translation>
    </message>
    <message>
        <source>Points lie outside the box that the header states, so that the file may be damaged: LAZ holds no checksum.</source>
        <translation>Punkte liegen außerhalb des Quaders, den der Dateikopf nennt, sodass die Datei beschädigt sein kann: LAZ enthält keine Prüfsumme.</translation>
    </message>
    <message>
        <source>The points are not of the returns that the header counts, so that the file may be damaged: LAZ holds no checksum.</source>
        <translation>Die Punkte gehören nicht zu den Echos, die der Dateikopf zählt, sodass die Datei beschädigt sein kann: LAZ enthält keine Prüfsumme.</translation>
    </message>
    <message>
        <source>Blocks of points hold bytes behind their last point, so that the file may be damaged: LAZ holds no checksum.</source>
        <translation>Blöcke von Punkten enthalten Bytes hinter ihrem letzten Punkt, sodass die Datei beschädigt sein kann: LAZ enthält keine Prüfsumme.</translation>
    </message>
    <message>
        <source>The file ends before the list of its blocks of points, so that it was cut or not written to its end; the blocks were found without it.</source>
        <translation>Die Datei endet vor der Liste ihrer Blöcke von Punkten; sie wurde also abgeschnitten oder nicht zu Ende geschrieben. Die Blöcke wurden ohne die Liste gefunden.</translation>
    </message>
    <message>
        <source>The raster has no georeference; one pixel was taken as one unit.</source>
        <translation>Das Raster hat keine Georeferenz; ein Pixel wurde als eine Einheit genommen.</translation>
    </message>
    <message>
        <source>The raster has %1 bands; the first was read as heights.</source>
        <translation>Das Raster hat %1 Kanäle; der erste wurde als Höhen gelesen.</translation>
    </message>
    <message>
        <source>The raster&apos;s unit of %1 m is not known here; state it (--unit).</source>
        <translation>Die Einheit des Rasters von %1 m ist hier nicht bekannt; geben Sie sie an (--unit).</translation>
    </message>
    <message>
        <source>The raster states no unit for its heights; they were taken to be in the unit of its coordinates.</source>
        <translation>Das Raster nennt keine Einheit für seine Höhen; sie wurden in der Einheit seiner Koordinaten genommen.</translation>
    </message>
    <message>
        <source>Heights in %1 were converted to %2, the unit of the coordinates.</source>
        <translation>Höhen in %1 wurden in %2, die Einheit der Koordinaten, umgerechnet.</translation>
    </message>
    <message>
        <source>The reference system of the heights was left out: it does not hold for another unit.</source>
        <translation>Das Bezugssystem der Höhen wurde weggelassen: Es gilt nicht für eine andere Einheit.</translation>
    </message>
    <message>
        <source>%1 was not written with the map and was left aside.</source>
        <translation>%1 wurde nicht mit der Karte geschrieben und blieb unbeachtet.</translation>
    </message>
    <message>
        <source>%1 belongs to another map and was left aside.</source>
        <translation>%1 gehört zu einer anderen Karte und blieb unbeachtet.</translation>
    </message>
    <message>
        <source>%1 cannot be read and was left aside.</source>
        <translation>%1 kann nicht gelesen werden und blieb unbeachtet.</translation>
    </message>
    <message>
        <source>%1 has another size than the map and was left aside.</source>
        <translation>%1 hat eine andere Größe als die Karte und blieb unbeachtet.</translation>
    </message>
    <message>
        <source>%1 does not fit the map and was left aside.</source>
        <translation>%1 passt nicht zur Karte und blieb unbeachtet.</translation>
    </message>
    <message>
        <source>In %1: %2</source>
        <translation>In %1: %2</translation>
    </message>
    <message>
        <source>Cannot read %1: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Copy or export it again.</source>
        <translation>Kopieren oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The file is damaged; export it again.</source>
        <translation>Die Datei ist beschädigt; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The file is damaged; copy or export it again.</source>
        <translation>Die Datei ist beschädigt; kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Convert it to LAS.</source>
        <translation>Wandeln Sie die Datei in LAS um.</translation>
    </message>
    <message>
        <source>Write the map again.</source>
        <translation>Schreiben Sie die Karte noch einmal.</translation>
    </message>
    <message>
        <source>line %1 is longer than 64 kB. It is no file of points.</source>
        <translation>Zeile %1 ist länger als 64 kB. Es ist keine Datei mit Punkten.</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) does not start with three numbers. Correct the line, or choose another file.</source>
        <translation>Zeile %1 („%2“) beginnt nicht mit drei Zahlen. Berichtigen Sie die Zeile, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) groups the digits of its numbers by thousands. Write them without such separators.</source>
        <translation>Zeile %1 („%2“) gliedert die Ziffern ihrer Zahlen nach Tausendern. Schreiben Sie die Zahlen ohne solche Trennzeichen.</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) %3.</source>
        <translation>Zeile %1 („%2“) %3.</translation>
    </message>
    <message>
        <source>header line %1 (&quot;%2&quot;) %3.</source>
        <translation>Zeile %1 des Dateikopfs („%2“) %3.</translation>
    </message>
    <message>
        <source>line %1 is longer than 1 MB.</source>
        <translation>Zeile %1 ist länger als 1 MB.</translation>
    </message>
    <message>
        <source>does not hold three coordinates</source>
        <translation>enthält keine drei Koordinaten</translation>
    </message>
    <message>
        <source>has too few numbers</source>
        <translation>hat zu wenige Zahlen</translation>
    </message>
    <message>
        <source>has fewer numbers than the header says</source>
        <translation>hat weniger Zahlen, als der Dateikopf angibt</translation>
    </message>
    <message>
        <source>has a list without a usable length</source>
        <translation>hat eine Liste ohne brauchbare Länge</translation>
    </message>
    <message>
        <source>has a list shorter than it says</source>
        <translation>hat eine Liste, die kürzer ist, als sie angibt</translation>
    </message>
    <message>
        <source>names a corner that is no number</source>
        <translation>nennt eine Ecke, die keine Zahl ist</translation>
    </message>
    <message>
        <source>is no part of an STL file</source>
        <translation>gehört nicht zu einer STL-Datei</translation>
    </message>
    <message>
        <source>it does not start with the word &quot;ply&quot;. It is no PLY file, or damaged.</source>
        <translation>Die Datei beginnt nicht mit dem Wort „ply“. Sie ist keine PLY-Datei, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>its header mixes kinds of line ends.</source>
        <translation>Im Dateikopf sind verschiedene Arten von Zeilenenden gemischt.</translation>
    </message>
    <message>
        <source>a list in it has the length %1.</source>
        <translation>Eine Liste darin hat die Länge %1.</translation>
    </message>
    <message>
        <source>its points have no fixed places in the file (text, or lists). Save it as binary PLY, or as LAS.</source>
        <translation>Die Punkte haben keine festen Plätze in der Datei (Text oder Listen). Speichern Sie sie als binäres PLY oder als LAS.</translation>
    </message>
    <message>
        <source>is too long for a PLY header</source>
        <translation>ist zu lang für den Kopf einer PLY-Datei</translation>
    </message>
    <message>
        <source>names no known format</source>
        <translation>nennt kein bekanntes Format</translation>
    </message>
    <message>
        <source>holds no usable count</source>
        <translation>enthält keine brauchbare Anzahl</translation>
    </message>
    <message>
        <source>names an element a second time</source>
        <translation>nennt ein Element zum zweiten Mal</translation>
    </message>
    <message>
        <source>belongs to no element</source>
        <translation>gehört zu keinem Element</translation>
    </message>
    <message>
        <source>gives a list no whole-number length</source>
        <translation>gibt einer Liste keine ganzzahlige Länge</translation>
    </message>
    <message>
        <source>names an unknown type</source>
        <translation>nennt einen unbekannten Typ</translation>
    </message>
    <message>
        <source>has no name</source>
        <translation>hat keinen Namen</translation>
    </message>
    <message>
        <source>is one property too many</source>
        <translation>ist eine Eigenschaft zu viel</translation>
    </message>
    <message>
        <source>names a property a second time</source>
        <translation>nennt eine Eigenschaft zum zweiten Mal</translation>
    </message>
    <message>
        <source>its header %1 (line %2). It is no PCD file, or damaged; export it again.</source>
        <translation>Der Dateikopf %1 (Zeile %2). Die Datei ist keine PCD-Datei, oder sie ist beschädigt; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>has a line too long for a PCD file</source>
        <translation>hat eine Zeile, die für eine PCD-Datei zu lang ist</translation>
    </message>
    <message>
        <source>has no end (&quot;DATA&quot;)</source>
        <translation>hat kein Ende („DATA“)</translation>
    </message>
    <message>
        <source>has too many fields</source>
        <translation>hat zu viele Felder</translation>
    </message>
    <message>
        <source>holds no usable %1</source>
        <translation>enthält kein brauchbares %1</translation>
    </message>
    <message>
        <source>names no known kind of data</source>
        <translation>nennt keine bekannte Art von Daten</translation>
    </message>
    <message>
        <source>ends its lines with CR alone</source>
        <translation>beendet seine Zeilen nur mit CR</translation>
    </message>
    <message>
        <source>names no fields</source>
        <translation>nennt keine Felder</translation>
    </message>
    <message>
        <source>does not give every field its SIZE, TYPE and COUNT</source>
        <translation>gibt nicht jedem Feld SIZE, TYPE und COUNT</translation>
    </message>
    <message>
        <source>gives field %1 an impossible SIZE or TYPE</source>
        <translation>gibt dem Feld %1 ein unmögliches SIZE oder TYPE</translation>
    </message>
    <message>
        <source>gives field %1 an impossible COUNT</source>
        <translation>gibt dem Feld %1 ein unmögliches COUNT</translation>
    </message>
    <message>
        <source>has no single field %1</source>
        <translation>hat nicht genau ein Feld %1</translation>
    </message>
    <message>
        <source>says nowhere how many points there are</source>
        <translation>sagt nirgends, wie viele Punkte es gibt</translation>
    </message>
    <message>
        <source>promises an impossible number of points</source>
        <translation>verspricht eine unmögliche Zahl von Punkten</translation>
    </message>
    <message>
        <source>promises %1 points, but %2 x %3</source>
        <translation>verspricht {1|%1 Punkt|%1 Punkte}, aber %2 x %3</translation>
    </message>
    <message>
        <source>it promises %1 points, more than the limit of %2. Thin it out first.</source>
        <translation>Die Datei verspricht %1 Punkte, mehr als die Grenze von %2. Dünnen Sie sie vorher aus.</translation>
    </message>
    <message>
        <source>its compressed data hold %1 bytes, not those of %2 points.</source>
        <translation>Die komprimierten Daten enthalten %1 Bytes, nicht die von {2|%2 Punkt|%2 Punkten}.</translation>
    </message>
    <message>
        <source>header promises %1 points, but the compressed data are cut, and no part of them can be read.</source>
        <translation>Der Dateikopf verspricht {1|%1 Punkt|%1 Punkte}, aber die komprimierten Daten sind abgeschnitten, und kein Teil davon lässt sich lesen.</translation>
    </message>
    <message>
        <source>it ends before &quot;endsolid&quot;. It is incomplete; copy or export it again.</source>
        <translation>Die Datei endet vor „endsolid“. Sie ist unvollständig; kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it does not hold the chunks of a 3DS file.</source>
        <translation>Die Datei enthält nicht die Abschnitte einer 3DS-Datei.</translation>
    </message>
    <message>
        <source>it has no vertices (&quot;v x y z&quot;). Choose another file.</source>
        <translation>Die Datei hat keine Eckpunkte („v x y z“). Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>it promises more points than there can be.</source>
        <translation>Die Datei verspricht mehr Punkte, als es geben kann.</translation>
    </message>
    <message>
        <source>the matrix before line %1 does not place a scan.</source>
        <translation>Die Matrix vor Zeile %1 legt keine Lage eines Scans fest.</translation>
    </message>
    <message>
        <source>line %1 (&quot;%2&quot;) should hold %3.</source>
        <translation>Zeile %1 („%2“) sollte %3 enthalten.</translation>
    </message>
    <message>
        <source>the number of columns of a scan</source>
        <translation>die Zahl der Spalten eines Scans</translation>
    </message>
    <message>
        <source>the number of rows of a scan</source>
        <translation>die Zahl der Zeilen eines Scans</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>drei Zahlen</translation>
    </message>
    <message>
        <source>four numbers of a matrix</source>
        <translation>vier Zahlen einer Matrix</translation>
    </message>
    <message>
        <source>a point&apos;s x, y and z</source>
        <translation>x, y und z eines Punktes</translation>
    </message>
    <message>
        <source>it says to be E57 version %1; this version reads E57 1. Export it again as E57 1.0.</source>
        <translation>Die Datei gibt an, E57-Version %1 zu sein; diese Version von relievo liest E57 1. Exportieren Sie sie noch einmal als E57 1.0.</translation>
    </message>
    <message>
        <source>its header gives an impossible page size.</source>
        <translation>Der Dateikopf nennt eine unmögliche Seitengröße.</translation>
    </message>
    <message>
        <source>its length is no multiple of its pages.</source>
        <translation>Die Länge der Datei ist kein Vielfaches der Länge ihrer Seiten.</translation>
    </message>
    <message>
        <source>the checksum of its page %1 of %2 is wrong.</source>
        <translation>Seite %1 von %2 der Datei hat eine falsche Prüfsumme.</translation>
    </message>
    <message>
        <source>it names a place outside itself.</source>
        <translation>Die Datei nennt eine Stelle außerhalb ihrer selbst.</translation>
    </message>
    <message>
        <source>a part of it reaches beyond its end.</source>
        <translation>Ein Teil der Datei reicht über ihr Ende hinaus.</translation>
    </message>
    <message>
        <source>its list of scans has an impossible length.</source>
        <translation>Die Liste der Scans hat eine unmögliche Länge.</translation>
    </message>
    <message>
        <source>its list of scans is no proper XML (%1).</source>
        <translation>Die Liste der Scans ist kein richtiges XML (%1).</translation>
    </message>
    <message>
        <source>it lists no scans.</source>
        <translation>Die Datei führt keine Scans auf.</translation>
    </message>
    <message>
        <source>a packet of its points makes no sense.</source>
        <translation>Ein Paket von Punkten ergibt keinen Sinn.</translation>
    </message>
    <message>
        <source>a section of its points makes no sense.</source>
        <translation>Ein Abschnitt von Punkten ergibt keinen Sinn.</translation>
    </message>
    <message>
        <source>it has no %1.</source>
        <translation>Das Feld %1 fehlt.</translation>
    </message>
    <message>
        <source>its entry in the list of scans %1.</source>
        <translation>Der Eintrag in der Liste der Scans %1.</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot; in place of a number</source>
        <translation>enthält „%1“ statt einer Zahl</translation>
    </message>
    <message>
        <source>names an unknown codec</source>
        <translation>nennt einen unbekannten Codec</translation>
    </message>
    <message>
        <source>gives %1 a maximum below its minimum</source>
        <translation>gibt %1 ein Maximum unter dem Minimum</translation>
    </message>
    <message>
        <source>holds a rotation that is no unit quaternion</source>
        <translation>enthält eine Drehung, die keine Einheitsquaternion ist</translation>
    </message>
    <message>
        <source>has points of an unknown kind</source>
        <translation>hat Punkte unbekannter Art</translation>
    </message>
    <message>
        <source>does not say what a point consists of</source>
        <translation>sagt nicht, woraus ein Punkt besteht</translation>
    </message>
    <message>
        <source>it says to be LAS version %1.%2; versions 1.0 to 1.4 exist. Export it again as LAS 1.4.</source>
        <translation>Die Datei gibt an, LAS-Version %1.%2 zu sein; es gibt die Versionen 1.0 bis 1.4. Exportieren Sie sie noch einmal als LAS 1.4.</translation>
    </message>
    <message>
        <source>it says to hold points of format %1; formats 0 to 10 exist.</source>
        <translation>Die Datei gibt an, Punkte im Format %1 zu enthalten; es gibt die Formate 0 bis 10.</translation>
    </message>
    <message>
        <source>its header gives points of format %1 %2 bytes each; they need %3.</source>
        <translation>Der Dateikopf gibt Punkten im Format %1 je %2 Bytes; sie brauchen %3.</translation>
    </message>
    <message>
        <source>its header places the points within itself.</source>
        <translation>Laut Dateikopf liegen die Punkte im Dateikopf selbst.</translation>
    </message>
    <message>
        <source>its header holds no usable scale and offset of coordinates.</source>
        <translation>Der Dateikopf enthält keine brauchbare Skalierung und Verschiebung der Koordinaten.</translation>
    </message>
    <message>
        <source>it says its header has %1 bytes; %2 are needed.</source>
        <translation>Die Datei gibt an, dass ihr Dateikopf %1 Bytes hat; nötig sind %2.</translation>
    </message>
    <message>
        <source>it packs %1 points in one block, which cannot be unpacked in parts. Read it as a whole, or pack it again in blocks of 50 000.</source>
        <translation>Die Datei packt %1 Punkte in einen Block, der sich nicht in Teilen auspacken lässt. Lesen Sie sie als Ganzes, oder packen Sie sie neu in Blöcken von 50 000.</translation>
    </message>
    <message>
        <source>its record of packing names fields of kind %1 with %2 bytes, which do not exist there.</source>
        <translation>Der Eintrag zur Packung nennt Felder der Art %1 mit %2 Bytes, die es dort nicht gibt.</translation>
    </message>
    <message>
        <source>its points are packed by version %1 of the method, which is not known here.</source>
        <translation>Die Punkte sind mit Version %1 des Verfahrens gepackt, die hier nicht bekannt ist.</translation>
    </message>
    <message>
        <source>its points are packed in a way (%1) that is not known here.</source>
        <translation>Die Punkte sind auf eine Art (%1) gepackt, die hier nicht bekannt ist.</translation>
    </message>
    <message>
        <source>its record of packing is cut.</source>
        <translation>Der Eintrag zur Packung ist abgeschnitten.</translation>
    </message>
    <message>
        <source>its record of packing does not begin with the coordinates.</source>
        <translation>Der Eintrag zur Packung beginnt nicht mit den Koordinaten.</translation>
    </message>
    <message>
        <source>its record of packing is not for points of format %1.</source>
        <translation>Der Eintrag zur Packung ist nicht für Punkte im Format %1.</translation>
    </message>
    <message>
        <source>its header gives each point %1 bytes, its record of packing %2.</source>
        <translation>Der Dateikopf gibt jedem Punkt %1 Bytes, der Eintrag zur Packung %2.</translation>
    </message>
    <message>
        <source>the list of its blocks of points %1.</source>
        <translation>Die Liste der Blöcke von Punkten %1.</translation>
    </message>
    <message>
        <source>lies within its header</source>
        <translation>liegt im Dateikopf</translation>
    </message>
    <message>
        <source>is none</source>
        <translation>ist keine Liste</translation>
    </message>
    <message>
        <source>its header promises %1 points, the list of its blocks others (%2 blocks).</source>
        <translation>Der Dateikopf verspricht {1|%1 Punkt|%1 Punkte}, die Liste der Blöcke eine andere Zahl ({2|%2 Block|%2 Blöcke}).</translation>
    </message>
    <message>
        <source>it is a compressed LAS file, and no record in it says how its points are packed.</source>
        <translation>Es ist eine komprimierte LAS-Datei, und kein Eintrag darin sagt, wie die Punkte gepackt sind.</translation>
    </message>
    <message>
        <source>its header promises %1 points.</source>
        <translation>Der Dateikopf verspricht %1 Punkte.</translation>
    </message>
    <message>
        <source>it ends before its points.</source>
        <translation>Die Datei endet vor ihren Punkten.</translation>
    </message>
    <message>
        <source>its block of points number %1 %2.</source>
        <translation>Der Block von Punkten mit der Nummer %1 %2.</translation>
    </message>
    <message>
        <source>mixes fields of old and of new point formats</source>
        <translation>vermischt Felder alter und neuer Punktformate</translation>
    </message>
    <message>
        <source>is shorter than its layers</source>
        <translation>ist kürzer als die Schichten darin</translation>
    </message>
    <message>
        <source>ends within its list of layers</source>
        <translation>endet mitten in der Liste der Schichten</translation>
    </message>
    <message>
        <source>says another number of points than the list of chunks</source>
        <translation>nennt eine andere Zahl von Punkten als die Liste der Blöcke</translation>
    </message>
    <message>
        <source>holds no coordinates</source>
        <translation>enthält keine Koordinaten</translation>
    </message>
    <message>
        <source>ends before its last point</source>
        <translation>endet vor dem letzten Punkt</translation>
    </message>
    <message>
        <source>ends before its first point</source>
        <translation>endet vor dem ersten Punkt</translation>
    </message>
    <message>
        <source>names more bytes than there are</source>
        <translation>nennt mehr Bytes, als es gibt</translation>
    </message>
    <message>
        <source>holds bytes that no coder writes</source>
        <translation>enthält Bytes, die kein Kodierer schreibt</translation>
    </message>
    <message>
        <source>switches between sequences of times without end</source>
        <translation>wechselt ohne Ende zwischen Folgen von Zeiten</translation>
    </message>
    <message>
        <source>its COPC hierarchy %1.</source>
        <translation>Die COPC-Hierarchie %1.</translation>
    </message>
    <message>
        <source>leaves out points that the file holds</source>
        <translation>lässt Punkte aus, die die Datei enthält</translation>
    </message>
    <message>
        <source>has a page outside the file or of odd size</source>
        <translation>hat eine Seite außerhalb der Datei oder von unpassender Größe</translation>
    </message>
    <message>
        <source>leads in a circle</source>
        <translation>führt im Kreis</translation>
    </message>
    <message>
        <source>has a node outside its octree</source>
        <translation>hat einen Knoten außerhalb ihres Octrees</translation>
    </message>
    <message>
        <source>names points that are no block of the file</source>
        <translation>nennt Punkte, die kein Block der Datei sind</translation>
    </message>
    <message>
        <source>names a block of points twice</source>
        <translation>nennt einen Block von Punkten zweimal</translation>
    </message>
    <message>
        <source>has no root</source>
        <translation>hat keine Wurzel</translation>
    </message>
    <message>
        <source>header promises %1 cells, file ends at %2.</source>
        <translation>Der Dateikopf verspricht %1 Zellen, die Datei endet bei %2.</translation>
    </message>
    <message>
        <source>it has not the bands that colours of a map have.</source>
        <translation>Die Datei hat nicht die Bänder, die Farben einer Karte haben.</translation>
    </message>
    <message>
        <source>row %1 is damaged or missing.</source>
        <translation>Zeile %1 ist beschädigt oder fehlt.</translation>
    </message>
    <message>
        <source>it carries %1 bytes of metadata, more than the limit of %2. Export it again without them.</source>
        <translation>Die Datei trägt %1 Bytes Metadaten, mehr als die Grenze von %2. Exportieren Sie sie noch einmal ohne Metadaten.</translation>
    </message>
    <message>
        <source>it is not a readable %1. Export it again as GeoTIFF.</source>
        <translation>Es ist kein lesbares %1. Exportieren Sie die Datei noch einmal als GeoTIFF.</translation>
    </message>
    <message>
        <source>it is not a readable %1 (%2). Export it again as GeoTIFF.</source>
        <translation>Es ist kein lesbares %1 (%2). Exportieren Sie die Datei noch einmal als GeoTIFF.</translation>
    </message>
    <message>
        <source>its georeference holds no usable numbers. Write it again with gdal_translate.</source>
        <translation>Die Georeferenz enthält keine brauchbaren Zahlen. Schreiben Sie die Datei neu mit gdal_translate.</translation>
    </message>
    <message>
        <source>its rows do not run from west to east; it is rotated or mirrored. Make it north-up with gdalwarp.</source>
        <translation>Die Zeilen laufen nicht von Westen nach Osten; das Raster ist gedreht oder gespiegelt. Richten Sie es mit gdalwarp nach Norden aus.</translation>
    </message>
    <message>
        <source>its pixels are not square (%1). Resample it with gdalwarp -tr.</source>
        <translation>Die Pixel sind nicht quadratisch (%1). Tasten Sie die Datei mit gdalwarp -tr neu ab.</translation>
    </message>
    <message>
        <source>its cells are complex numbers, not heights. Choose a height raster.</source>
        <translation>Die Zellen sind komplexe Zahlen, keine Höhen. Wählen Sie ein Höhenraster.</translation>
    </message>
    <message>
        <source>each of its strips or tiles holds %1 MB; they are read whole, and 1 073 MB is the limit. Write one band of it again with gdal_translate -b 1 -co TILED=YES.</source>
        <translation>Jeder Streifen oder jede Kachel der Datei umfasst %1 MB; sie werden als Ganzes gelesen, und 1 073 MB sind die Grenze. Schreiben Sie ein Band davon neu mit gdal_translate -b 1 -co TILED=YES.</translation>
    </message>
    <message>
        <source>none of its %1 cells holds a height. Choose another raster.</source>
        <translation>Keine der %1 Zellen enthält eine Höhe. Wählen Sie ein anderes Raster.</translation>
    </message>
    <message>
        <source>row %1 is damaged or missing (%2).</source>
        <translation>Zeile %1 ist beschädigt oder fehlt (%2).</translation>
    </message>
    <message>
        <source>it holds the origins of a map&apos;s cells, not heights. Open the map beside it.</source>
        <translation>Die Datei enthält die Herkunft der Zellen einer Karte, keine Höhen. Öffnen Sie die Karte daneben.</translation>
    </message>
    <message>
        <source>its RELIEVO_ entries were changed and make no sense.</source>
        <translation>Die RELIEVO_-Einträge wurden geändert und ergeben keinen Sinn.</translation>
    </message>
    <message>
        <source>it has %1 x %2 cells; at least 2 x 2 are needed. Choose a larger raster.</source>
        <translation>Die Datei hat %1 x %2 Zellen; mindestens 2 x 2 sind nötig. Wählen Sie ein größeres Raster.</translation>
    </message>
    <message>
        <source>it has %1 cells, more than the limit of %2. Cut or thin it with gdal_translate.</source>
        <translation>Die Datei hat %1 Zellen, mehr als die Grenze von %2. Schneiden Sie sie mit gdal_translate zu, oder dünnen Sie sie damit aus.</translation>
    </message>
    <message>
        <source>its heights could not be kept while they were used, or its reader broke down on it. Try again, or export it again.</source>
        <translation>Die Höhen konnten nicht aufbewahrt werden, während sie gebraucht wurden, oder das Leseprogramm ist an der Datei zusammengebrochen. Versuchen Sie es noch einmal, oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its points cannot be kept while they are used. Free some memory, and try again.</source>
        <translation>Die Punkte können nicht aufbewahrt werden, während sie gebraucht werden. Schaffen Sie freien Speicher, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>only LAS, LAZ and binary PLY files are read in blocks. Convert it to LAS first.</source>
        <translation>Nur Dateien in LAS, LAZ und binärem PLY werden in Blöcken gelesen. Wandeln Sie die Datei vorher in LAS um.</translation>
    </message>
    <message>
        <source>this import program reads no rasters. Install relievo again.</source>
        <translation>Dieses Importprogramm liest keine Raster. Installieren Sie relievo neu.</translation>
    </message>
    <message>
        <source>it takes more than %1 s of processor time. Thin it out or cut it into parts first.</source>
        <translation>Das Lesen braucht mehr als %1 s Rechenzeit. Dünnen Sie die Datei vorher aus, oder teilen Sie sie.</translation>
    </message>
    <message>
        <source>it needs more than %1 MB of memory. Thin it out or cut it into parts first.</source>
        <translation>Die Datei braucht mehr als %1 MB Arbeitsspeicher. Dünnen Sie sie vorher aus, oder teilen Sie sie in Teile.</translation>
    </message>
    <message>
        <source>what it holds is passed on as a file, and files may have no more than %1 kB here (ulimit -f). Allow larger ones and try again.</source>
        <translation>Der Inhalt der Datei wird als Datei weitergegeben, und Dateien dürfen hier nicht mehr als %1 kB haben (ulimit -f). Lassen Sie größere zu, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>its reader gave up (%1).</source>
        <translation>Das Leseprogramm hat aufgegeben (%1).</translation>
    </message>
    <message>
        <source>PCL gave up on its points. The program&apos;s own reader may take them (--reader own).</source>
        <translation>PCL hat bei den Punkten der Datei aufgegeben. Das eigene Leseprogramm kann sie vielleicht lesen (--reader own).</translation>
    </message>
    <message>
        <source>its reader broke down on it. The program is unharmed; the file is probably damaged. Export it again.</source>
        <translation>Das Leseprogramm ist an der Datei zusammengebrochen. Das Hauptprogramm ist unversehrt; die Datei ist wahrscheinlich beschädigt. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its reader broke down on it (&quot;%1&quot;). The program is unharmed; the file is probably damaged. Export it again.</source>
        <translation>Das Leseprogramm ist an der Datei zusammengebrochen („%1“). Das Hauptprogramm ist unversehrt; die Datei ist wahrscheinlich beschädigt. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>a raster keeps its cells and heights.</source>
        <translation>ein Raster behält seine Zellen und Höhen.</translation>
    </message>
    <message>
        <source>a map that relievo wrote is taken as it is.</source>
        <translation>eine Karte, die relievo geschrieben hat, wird genommen, wie sie ist.</translation>
    </message>
    <message>
        <source>a raster that relievo did not write</source>
        <translation>ein Raster, das relievo nicht geschrieben hat</translation>
    </message>
    <message>
        <source>%1 changes nothing here: %2</source>
        <translation>%1 ändert hier nichts: %2</translation>
    </message>
    <message>
        <source>%1 is %2, above %3, which is %4.</source>
        <translation>%1 ist %2 und damit mehr als %3, das %4 ist.</translation>
    </message>
    <message>
        <source>Closer. %1 wide.</source>
        <translation>Näher. %1 breit.</translation>
    </message>
    <message>
        <source>Wider. %1 wide.</source>
        <translation>Weiter. %1 breit.</translation>
    </message>
    <message>
        <source>The whole relief.</source>
        <translation>Das ganze Relief.</translation>
    </message>
    <message>
        <source>%1 of %2 points {1|lies|lie} %3 of the box away from all others; surfaces are made without {1|it|them}, unless --strays keep is given.</source>
        <translation>%1 von %2 Punkten {1|liegt|liegen} %3 des Quaders von allen anderen entfernt; Oberflächen entstehen ohne {1|ihn|sie}, wenn nicht --strays keep angegeben ist.</translation>
    </message>
    <message>
        <source>{1|%1 vertex belongs|%1 vertices belong} to no face and {1|lies|lie} outside of the object; surfaces are made without {1|it|them}, unless --strays keep is given.</source>
        <translation>{1|%1 Eckpunkt gehört|%1 Eckpunkte gehören} zu keiner Fläche und {1|liegt|liegen} außerhalb des Objekts; Oberflächen entstehen ohne {1|ihn|sie}, wenn nicht --strays keep angegeben ist.</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together %3 of the box away from all others; surfaces are made with them, as they may belong to the object, unless --strays drop-groups is given.</source>
        <translation>%1 von %2 Punkten {1|liegt|liegen} zusammen %3 des Quaders von allen anderen entfernt; Oberflächen entstehen mit {1|ihm|ihnen}, da {1|er|sie} zum Objekt gehören {1|kann|können}, wenn nicht --strays drop-groups angegeben ist.</translation>
    </message>
    <message>
        <source>%1 of %2 heights are %3, which often stands for a missing one; surfaces are made without them, unless --nodata none is given.</source>
        <translation>%1 von %2 Höhen sind %3, was oft für eine fehlende steht; Oberflächen entstehen ohne sie, wenn nicht --nodata none angegeben ist.</translation>
    </message>
    <message>
        <source>Several processes make one map by tiles only, and through a folder that all of them see. Nothing was made. Give --memory and --job as well.</source>
        <translation>Mehrere Prozesse machen zusammen nur Karten in Kacheln, und zwar über einen Ordner, den alle sehen. Es wurde nichts gemacht. Geben Sie auch --memory und --job an.</translation>
    </message>
    <message>
        <source>Process %1 of %2 has other work than the first: %3 differs. Nothing was made. Start all of them with the same command and version, where all see the same files.</source>
        <translation>Prozess %1 von %2 hat eine andere Arbeit als der erste: %3 ist anders. Es wurde nichts gemacht. Starten Sie alle mit demselben Befehl und derselben Version, wo alle dieselben Dateien sehen.</translation>
    </message>
    <message>
        <source>Process %1 of %2: %3</source>
        <translation>Prozess %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>relievo::MessageStrip</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Key of the first button</source>
        <translation>Taste des ersten Knopfes</translation>
    </message>
</context>
<context>
    <name>relievo::NoteDialog</name>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>&amp;Note at %1 s of the recording</source>
        <translation>&amp;Notiz bei %1 s der Aufzeichnung</translation>
    </message>
    <message>
        <source>At %1 s of the recording</source>
        <translation>Bei %1 s der Aufzeichnung</translation>
    </message>
    <message>
        <source>What was seen or felt, in a few words</source>
        <translation>Was zu sehen oder zu fühlen war, in wenigen Worten</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Write the note into the recording</source>
        <translation>Die Notiz in die Aufzeichnung schreiben</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close without a note</source>
        <translation>Ohne Notiz schließen</translation>
    </message>
</context>
<context>
    <name>relievo::OpenController</name>
    <message>
        <source>%1 needs %2, which has moved. Nothing was changed. Find it, or choose another file. (E501)</source>
        <translation>%1 braucht %2; diese Datei ist nicht mehr dort. Nichts wurde geändert. Suchen Sie sie oder wählen Sie eine andere Datei. (E501)</translation>
    </message>
    <message>
        <source>&amp;Find it…</source>
        <translation>&amp;Suchen…</translation>
    </message>
    <message>
        <source>&amp;Choose another…</source>
        <translation>Andere &amp;wählen…</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>%1 has changed since this was saved (its checksum differs). It is shown as it is now; results may differ. (E501)</source>
        <translation>%1 hat sich seit dem Speichern geändert (die Prüfsumme ist eine andere). Es wird gezeigt, wie es jetzt ist; Ergebnisse können abweichen. (E501)</translation>
    </message>
    <message>
        <source>&amp;Work that was kept…</source>
        <translation>Auf&amp;gehobene Arbeit…</translation>
    </message>
    <message>
        <source>&amp;Load what is there</source>
        <translation>&amp;Laden, was da ist</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>Wä&amp;hlen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Scans, height maps, projects and figures (%1)</source>
        <translation>Scans, Höhenkarten, Projekte und Abbildungen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 was not opened: it needs %2, which is outside of its folder and was not read. Nothing was changed. Find it, or choose another file.</source>
        <translation>%1 wurde nicht geöffnet: Es braucht %2, das außerhalb seines Ordners liegt und nicht gelesen wurde. Nichts wurde geändert. Suchen Sie es, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message numerus="yes">
        <source>relievo ended unexpectedly. Work on %1 of %2 was kept (%n step(s)).</source>
        <translation>
            <numerusform>relievo wurde unerwartet beendet. Die Arbeit an %1 von %2 ist aufgehoben (%n Schritt).</numerusform>
            <numerusform>relievo wurde unerwartet beendet. Die Arbeit an %1 von %2 ist aufgehoben (%n Schritte).</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>There is no scan in %1. Nothing was opened.</source>
        <translation>In %1 ist kein Scan. Nichts wurde geöffnet.</translation>
    </message>
    <message>
        <source>%1 files are more than the %2 scans that can be joined. Nothing was opened.</source>
        <translation>%1 Dateien sind mehr als die %2 Scans, die verbunden werden können. Nichts wurde geöffnet.</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Aufbereiten</translation>
    </message>
    <message>
        <source>The next file is seen like this one.</source>
        <translation>Die nächste Datei wird wie diese gezeigt.</translation>
    </message>
    <message>
        <source>The next file is seen from its own best side.</source>
        <translation>Die nächste Datei wird von ihrer besten Seite gezeigt.</translation>
    </message>
    <message>
        <source>&amp;Load one point in %1</source>
        <translation>&amp;Einen von %1 Punkten laden</translation>
    </message>
    <message>
        <source>%1 shows the map at %2, which was not opened on this computer yet. Nothing was changed. To open it asks that server.</source>
        <translation>%1 zeigt die Karte unter %2, die auf diesem Rechner noch nicht geöffnet wurde. Nichts wurde geändert. Wird sie geöffnet, wird dieser Server gefragt.</translation>
    </message>
    <message>
        <source>The work that was kept</source>
        <translation>Die aufbewahrte Arbeit</translation>
    </message>
    <message>
        <source>&amp;Open the map</source>
        <translation>Karte ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Noch einmal</translation>
    </message>
    <message>
        <source>Another &amp;address…</source>
        <translation>Andere &amp;Adresse…</translation>
    </message>
    <message>
        <source>A map is opened by its address alone, without other files. Nothing was opened.</source>
        <translation>Eine Karte wird über ihre Adresse allein geöffnet, ohne andere Dateien. Nichts wurde geöffnet.</translation>
    </message>
</context>
<context>
    <name>relievo::OverviewInset</name>
    <message>
        <source>Place of the window on the object</source>
        <translation>Ort des Ausschnitts auf dem Objekt</translation>
    </message>
</context>
<context>
    <name>relievo::PackageController</name>
    <message>
        <source>Cancelled. Nothing was packed.</source>
        <translation>Abgebrochen. Nichts wurde gepackt.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was opened.</source>
        <translation>Abgebrochen. Nichts wurde geöffnet.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is packed: %n file(s), each with its checksum</source>
        <translation>
            <numerusform>%1 ist gepackt: %n Datei mit ihrer Prüfsumme</numerusform>
            <numerusform>%1 ist gepackt: %n Dateien, jede mit ihrer Prüfsumme</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) of %1 are not as they were packed. Nothing was opened. &apos;relievo project verify&apos; names them.</source>
        <translation>
            <numerusform>%n Teil von %1 ist nicht, wie er gepackt wurde. Nichts wurde geöffnet. „relievo project verify“ nennt ihn.</numerusform>
            <numerusform>%n Teile von %1 sind nicht, wie sie gepackt wurden. Nichts wurde geöffnet. „relievo project verify“ nennt sie.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unpack elsewhere…</source>
        <translation>&amp;Anderswo entpacken…</translation>
    </message>
    <message>
        <source>%1 was unpacked into %2</source>
        <translation>%1 wurde nach %2 entpackt</translation>
    </message>
    <message>
        <source>Unpack %1 into</source>
        <translation>%1 entpacken nach</translation>
    </message>
</context>
<context>
    <name>relievo::PackageDialog</name>
    <message>
        <source>One zip with this work as a project, what is ticked here, a README, and the checksum of each file. Recordings bring the rasters along that they need to be repeated.</source>
        <translation>Eine Zip-Datei mit dieser Arbeit als Projekt, dem hier Angekreuzten, einer README und der Prüfsumme jeder Datei. Aufzeichnungen bringen die Raster mit, die sie zur Wiederholung brauchen.</translation>
    </message>
    <message>
        <source>The &amp;scan %1, %2</source>
        <translation>Der &amp;Scan %1, %2</translation>
    </message>
    <message>
        <source>The scan %1</source>
        <translation>Der Scan %1</translation>
    </message>
    <message>
        <source>Off: only its name and checksum, if it may not be given away</source>
        <translation>Aus: nur Name und Prüfsumme, wenn er nicht weitergegeben werden darf</translation>
    </message>
    <message>
        <source>Recordings and &amp;figures</source>
        <translation>&amp;Aufzeichnungen und Abbildungen</translation>
    </message>
    <message>
        <source>Recordings and figures</source>
        <translation>Aufzeichnungen und Abbildungen</translation>
    </message>
    <message>
        <source>Ticked files are packed</source>
        <translation>Angekreuzte Dateien werden gepackt</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Take another recording or figure along</source>
        <translation>Eine weitere Aufzeichnung oder Abbildung mitnehmen</translation>
    </message>
    <message>
        <source>&amp;Package</source>
        <translation>&amp;Paket</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Paket</translation>
    </message>
    <message>
        <source>Where the package is saved</source>
        <translation>Wo das Paket gespeichert wird</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Take along</source>
        <translation>Mitnehmen</translation>
    </message>
    <message>
        <source>Recordings and figures (*.csv *.h5 *.hdf5 *.png *.tif *.tiff *.pdf *.svg)</source>
        <translation>Aufzeichnungen und Abbildungen (*.csv *.h5 *.hdf5 *.png *.tif *.tiff *.pdf *.svg)</translation>
    </message>
    <message>
        <source>Packages (*.zip)</source>
        <translation>Pakete (*.zip)</translation>
    </message>
    <message>
        <source>Export archive package</source>
        <translation>Archivpaket exportieren</translation>
    </message>
    <message>
        <source>The map %1, by its address</source>
        <translation>Die Karte %1, mit ihrer Adresse</translation>
    </message>
    <message>
        <source>Of a map on the web only what was looked at is on this computer</source>
        <translation>Von einer Karte im Netz ist auf diesem Rechner nur, was angesehen wurde</translation>
    </message>
</context>
<context>
    <name>relievo::PairPicking</name>
    <message>
        <source>The scans are still being read</source>
        <translation>Die Scans werden noch gelesen</translation>
    </message>
    <message>
        <source>Scan %1: %2</source>
        <translation>Scan %1: %2</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>Referenz: %1</translation>
    </message>
    <message>
        <source>Now place %1 on the reference</source>
        <translation>Jetzt Stelle %1 auf der Referenz</translation>
    </message>
    <message>
        <source>Now place %1 on the scan</source>
        <translation>Jetzt Stelle %1 auf dem Scan</translation>
    </message>
    <message>
        <source>Choose place %1 on the scan, then the same on the reference</source>
        <translation>Stelle %1 auf dem Scan wählen, dann dieselbe auf der Referenz</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s). Escape or the button ends; more pairs do no harm.</source>
        <translation>
            <numerusform>%n Paar. Escape oder die Schaltfläche beendet; mehr Paare schaden nicht.</numerusform>
            <numerusform>%n Paare. Escape oder die Schaltfläche beendet; mehr Paare schaden nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>They fit to %1 mm; pair %2 fits worst, %3 mm.</source>
        <translation>Sie passen auf %1 mm; Paar %2 passt am schlechtesten, %3 mm.</translation>
    </message>
</context>
<context>
    <name>relievo::PictureController</name>
    <message>
        <source>Cancelled. No picture was saved.</source>
        <translation>Abgebrochen. Kein Bild wurde gespeichert.</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 ist gespeichert</translation>
    </message>
    <message>
        <source>%1 is saved in %2</source>
        <translation>%1 ist in %2 gespeichert</translation>
    </message>
</context>
<context>
    <name>relievo::PlaceController</name>
    <message>
        <source>%1 removed.</source>
        <translation>%1 entfernt.</translation>
    </message>
    <message>
        <source>%1 set.</source>
        <translation>%1 gesetzt.</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Gehe zu %1</translation>
    </message>
    <message>
        <source>The view is copied as text</source>
        <translation>Die Ansicht ist als Text kopiert</translation>
    </message>
    <message>
        <source>The copied view does not lie on this map. The window was not moved. Open the scan that it was copied from.</source>
        <translation>Die kopierte Ansicht liegt nicht auf dieser Karte. Der Ausschnitt wurde nicht verschoben. Öffnen Sie den Scan, von dem sie kopiert wurde.</translation>
    </message>
    <message>
        <source>Paste view</source>
        <translation>Ansicht einfügen</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Markierung %1</translation>
    </message>
    <message>
        <source>There are %1 markers already. Remove one first.</source>
        <translation>Es gibt schon %1 Markierungen. Entfernen Sie erst eine.</translation>
    </message>
    <message>
        <source>%1 is in the window already.</source>
        <translation>%1 ist schon im Ausschnitt.</translation>
    </message>
    <message>
        <source>%1 has a finer resolution than this map. The window was not moved.</source>
        <translation>%1 hat eine feinere Auflösung als diese Karte. Der Ausschnitt wurde nicht verschoben.</translation>
    </message>
    <message>
        <source>%1. Resolution %2 of %3</source>
        <translation>%1. Auflösung %2 von %3</translation>
    </message>
    <message>
        <source>The copied view is shown. Resolution %1 of %2</source>
        <translation>Die kopierte Ansicht wird gezeigt. Auflösung %1 von %2</translation>
    </message>
</context>
<context>
    <name>relievo::PlacesPanel</name>
    <message>
        <source>With light and view</source>
        <translation>Mit Licht und Ansicht</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>%1 is forgotten</source>
        <translation>%1 ist vergessen</translation>
    </message>
    <message>
        <source>Add bookmark</source>
        <translation>Lesezeichen hinzufügen</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Enter goes to a bookmark, F2 renames it, Delete removes it</source>
        <translation>Eingabe geht zu einem Lesezeichen, F2 benennt es um, Entf löscht es</translation>
    </message>
    <message>
        <source>A new bookmark also keeps light, relief image, stereo and the turn of the view</source>
        <translation>Ein neues Lesezeichen behält auch Licht, Reliefbild, Stereo und die Drehung der Ansicht</translation>
    </message>
    <message>
        <source>Keep the window under a name (Ctrl+N)</source>
        <translation>Den Ausschnitt unter einem Namen merken (Strg+N)</translation>
    </message>
    <message>
        <source>Move the window to the selected bookmark</source>
        <translation>Den Ausschnitt zum gewählten Lesezeichen bewegen</translation>
    </message>
    <message>
        <source>Change the selected bookmark&apos;s name (F2)</source>
        <translation>Den Namen des gewählten Lesezeichens ändern (F2)</translation>
    </message>
    <message>
        <source>Delete the selected bookmark</source>
        <translation>Das gewählte Lesezeichen löschen</translation>
    </message>
    <message>
        <source>Bookmark %1</source>
        <translation>Lesezeichen %1</translation>
    </message>
    <message>
        <source>There is no bookmark yet</source>
        <translation>Es gibt noch kein Lesezeichen</translation>
    </message>
    <message>
        <source>The window alone</source>
        <translation>Nur der Ausschnitt</translation>
    </message>
</context>
<context>
    <name>relievo::PointerBindings</name>
    <message>
        <source>left turns</source>
        <translation>links dreht</translation>
    </message>
    <message>
        <source>left moves</source>
        <translation>links verschiebt</translation>
    </message>
    <message>
        <source>left zooms</source>
        <translation>links zoomt</translation>
    </message>
    <message>
        <source>middle turns</source>
        <translation>Mitte dreht</translation>
    </message>
    <message>
        <source>middle moves</source>
        <translation>Mitte verschiebt</translation>
    </message>
    <message>
        <source>middle zooms</source>
        <translation>Mitte zoomt</translation>
    </message>
    <message>
        <source>right turns</source>
        <translation>rechts dreht</translation>
    </message>
    <message>
        <source>right moves</source>
        <translation>rechts verschiebt</translation>
    </message>
    <message>
        <source>right zooms</source>
        <translation>rechts zoomt</translation>
    </message>
    <message>
        <source>left presses the hand in</source>
        <translation>links drückt die Hand ein</translation>
    </message>
    <message>
        <source>wheel zooms</source>
        <translation>Rad zoomt</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Betrachten</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>turn the view</source>
        <translation>die Ansicht drehen</translation>
    </message>
    <message>
        <source>move the window</source>
        <translation>den Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>vergrößern</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>relievo::PointerController</name>
    <message>
        <source>What the mouse does in the detail view; F7 changes between look and touch, Preferences choose the buttons</source>
        <translation>Was die Maus in der Detailansicht tut; F7 wechselt zwischen Betrachten und Fühlen, die Einstellungen belegen die Tasten</translation>
    </message>
    <message>
        <source>The mouse feels the surface; Escape ends it</source>
        <translation>Die Maus fühlt die Oberfläche; Escape beendet es</translation>
    </message>
    <message>
        <source>The mouse no longer feels the surface</source>
        <translation>Die Maus fühlt die Oberfläche nicht mehr</translation>
    </message>
</context>
<context>
    <name>relievo::PreferencesDialog</name>
    <message>
        <source>No setting has these words.</source>
        <translation>Keine Einstellung hat diese Wörter.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Search settings</source>
        <translation>Einstellungen suchen</translation>
    </message>
    <message>
        <source>Words of a setting&apos;s name or explanation</source>
        <translation>Wörter aus Name oder Erklärung einer Einstellung</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>&amp;Defaults of this page</source>
        <translation>&amp;Vorgaben dieser Seite</translation>
    </message>
    <message>
        <source>Defaults of this page</source>
        <translation>Vorgaben dieser Seite</translation>
    </message>
    <message>
        <source>Every setting of this page as it was at first</source>
        <translation>Jede Einstellung dieser Seite wie am Anfang</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Light, dark or high contrast window; or as the desktop</source>
        <translation>Helles, dunkles oder kontrastreiches Fenster; oder wie der Desktop</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Of the system&apos;s text size; everything grows with it</source>
        <translation>Der Schriftgröße des Systems; alles wächst mit</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of the window; holds from the next start</source>
        <translation>Des Fensters; gilt ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Ask</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Files without a unit</source>
        <translation>Dateien ohne Einheit</translation>
    </message>
    <message>
        <source>Which unit is taken where neither the file nor its folder says one</source>
        <translation>Welche Einheit gilt, wo weder die Datei noch ihr Ordner eine nennt</translation>
    </message>
    <message>
        <source>Sizes are shown in</source>
        <translation>Größen werden gezeigt in</translation>
    </message>
    <message>
        <source>Millimetres, and metres for what is larger than 10 m; or always one unit</source>
        <translation>Millimeter, und Meter für alles über 10 m; oder immer eine Einheit</translation>
    </message>
    <message>
        <source>Fitting unit</source>
        <translation>Passende Einheit</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Half colour</source>
        <translation>Halbfarbig</translation>
    </message>
    <message>
        <source>Dubois</source>
        <translation>Dubois</translation>
    </message>
    <message>
        <source>Eye separation</source>
        <translation>Augenabstand</translation>
    </message>
    <message>
        <source>Keep comfortable</source>
        <translation>Angenehm halten</translation>
    </message>
    <message>
        <source>Less eye separation where it would pass 1 degree of parallax</source>
        <translation>Weniger Augenabstand, wo die Parallaxe 1 Grad überschritte</translation>
    </message>
    <message>
        <source>Swap eyes</source>
        <translation>Augen tauschen</translation>
    </message>
    <message>
        <source>For glasses whose red filter is at the right eye</source>
        <translation>Für Brillen mit dem roten Filter am rechten Auge</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Falcon firmware</source>
        <translation>Falcon-Firmware</translation>
    </message>
    <message>
        <source>Keep work for a crash</source>
        <translation>Arbeit bei Absturz aufheben</translation>
    </message>
    <message>
        <source>A copy of unsaved work every two seconds, offered after a crash</source>
        <translation>Alle zwei Sekunden eine Kopie ungespeicherter Arbeit, nach einem Absturz angeboten</translation>
    </message>
    <message>
        <source>Restart no&amp;w</source>
        <translation>&amp;Jetzt neu starten</translation>
    </message>
    <message>
        <source>For another language</source>
        <translation>Für eine andere Sprache</translation>
    </message>
    <message>
        <source>End and start again with the same file; asks first if something is not saved</source>
        <translation>Beenden und mit derselben Datei neu starten; fragt vorher, wenn etwas nicht gespeichert ist</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>Jetzt neu starten</translation>
    </message>
    <message>
        <source>File with the Falcon&apos;s firmware, or its folder; empty: the usual places. Holds when a Falcon is started next</source>
        <translation>Datei mit der Firmware des Falcon, oder ihr Ordner; leer: die üblichen Orte. Gilt, sobald ein Falcon das nächste Mal gestartet wird</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recordings are</source>
        <translation>Aufzeichnungen sind</translation>
    </message>
    <message>
        <source>Kind of file of the next recording: a table as text, or HDF5, smaller and with units and surface</source>
        <translation>Dateiart der nächsten Aufzeichnung: eine Tabelle als Text, oder HDF5, kleiner und mit Einheiten und Oberfläche</translation>
    </message>
    <message>
        <source>CSV: every program opens it</source>
        <translation>CSV: jedes Programm öffnet es</translation>
    </message>
    <message>
        <source>HDF5: for Python and MATLAB</source>
        <translation>HDF5: für Python und MATLAB</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Where recordings go that are made from now on; empty: relievo in the documents folder</source>
        <translation>Wohin Aufnahmen von jetzt an kommen; leer: relievo im Ordner der Dokumente</translation>
    </message>
    <message>
        <source>Automatic depth</source>
        <translation>Automatische Tiefe</translation>
    </message>
    <message>
        <source>Eye separation by the heights that are shown, at the start</source>
        <translation>Augenabstand nach den gezeigten Höhen, am Anfang</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions at the start, without automatic depth</source>
        <translation>Winkel zwischen den Blickrichtungen der Augen am Anfang, ohne automatische Tiefe</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
    </message>
    <message>
        <source>What it does in the detail view: look turns it, touch presses the hand in (F7)</source>
        <translation>Was sie in der Detailansicht tut: Betrachten dreht sie, Fühlen drückt die Hand ein (F7)</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Betrachten</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>turns the view</source>
        <translation>dreht die Ansicht</translation>
    </message>
    <message>
        <source>moves the window</source>
        <translation>verschiebt den Ausschnitt</translation>
    </message>
    <message>
        <source>zooms</source>
        <translation>zoomt</translation>
    </message>
    <message>
        <source>does nothing</source>
        <translation>tut nichts</translation>
    </message>
    <message>
        <source>What dragging with this button does in the detail view</source>
        <translation>Was Ziehen mit dieser Taste in der Detailansicht tut</translation>
    </message>
    <message>
        <source>To look: left</source>
        <translation>Betrachten: links</translation>
    </message>
    <message>
        <source>To look: middle</source>
        <translation>Betrachten: Mitte</translation>
    </message>
    <message>
        <source>To look: right</source>
        <translation>Betrachten: rechts</translation>
    </message>
    <message>
        <source>To touch: middle</source>
        <translation>Fühlen: Mitte</translation>
    </message>
    <message>
        <source>To touch: right</source>
        <translation>Fühlen: rechts</translation>
    </message>
    <message>
        <source>Wheel away from you</source>
        <translation>Rad von Ihnen weg</translation>
    </message>
    <message>
        <source>Which way the wheel zooms in the detail view</source>
        <translation>In welche Richtung das Rad in der Detailansicht zoomt</translation>
    </message>
    <message>
        <source>zooms in</source>
        <translation>zoomt hinein</translation>
    </message>
    <message>
        <source>zooms out</source>
        <translation>zoomt heraus</translation>
    </message>
    <message>
        <source>Kind of stereo</source>
        <translation>Art des Stereos</translation>
    </message>
    <message>
        <source>What stereo starts with: an anaglyph for red and cyan glasses, or pictures for a screen that shows each eye its own</source>
        <translation>Womit Stereo beginnt: mit einem Anaglyphen für Rot-Cyan-Brillen oder mit Bildern für einen Bildschirm, der jedem Auge das seine zeigt</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>Zeilenweise</translation>
    </message>
    <message>
        <source>Force Dimension&apos;s library</source>
        <translation>Bibliothek von Force Dimension</translation>
    </message>
    <message>
        <source>File libdhd.so.3 or libdrd.so.3 of the maker of omega, delta, sigma and lambda; empty: the usual places. Holds when such a device is looked for next</source>
        <translation>Datei libdhd.so.3 oder libdrd.so.3 des Herstellers von omega, delta, sigma und lambda; leer: die üblichen Orte. Gilt, sobald ein solches Gerät das nächste Mal gesucht wird</translation>
    </message>
    <message>
        <source>Plug-ins for devices</source>
        <translation>Plugins für Geräte</translation>
    </message>
    <message>
        <source>Which plug-ins for haptic devices may run. A plug-in can do all that you can do: allow one only if you know where it is from. A file that changes must be allowed again</source>
        <translation>Welche Plugins für haptische Geräte laufen dürfen. Ein Plugin kann alles, was Sie können: Erlauben Sie eines nur, wenn Sie wissen, woher es stammt. Eine Datei, die sich ändert, muss neu erlaubt werden</translation>
    </message>
    <message>
        <source>Settings found: %1</source>
        <translation>Gefundene Einstellungen: %1</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareDialog</name>
    <message>
        <source>Arrow keys carry the cross, Enter sets a corner, Ctrl+Enter closes the outline</source>
        <translation>Pfeiltasten tragen das Kreuz, Eingabe setzt eine Ecke, Strg+Eingabe schließt den Umriss</translation>
    </message>
    <message>
        <source>Drag the mouse round what is meant, or set corners with Enter; Ctrl+Enter closes.</source>
        <translation>Mit der Maus umfahren, was gemeint ist, oder Ecken mit Eingabe setzen; Strg+Eingabe schließt.</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Aufbereiten</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>Rezept sichern</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Rezepte (*.json)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 ist gespeichert</translation>
    </message>
    <message>
        <source>The command is in the clipboard</source>
        <translation>Der Befehl ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>Undone</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>Redone</source>
        <translation>Wiederholt</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareReport</name>
    <message>
        <source>The chain of scans %1 misses its beginning by %2 mm.</source>
        <translation>Die Kette der Scans %1 verfehlt ihren Anfang um %2 mm.</translation>
    </message>
    <message>
        <source>%1 % of its points lie within one spacing.</source>
        <translation>%1 % seiner Punkte liegen innerhalb eines Punktabstands.</translation>
    </message>
    <message>
        <source>It may be off by %1 mm.</source>
        <translation>Er kann um %1 mm daneben liegen.</translation>
    </message>
    <message>
        <source>How many points stay</source>
        <translation>Wie viele Punkte bleiben</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>scan, words</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 points stay.</source>
        <translation>%1 von %2 Punkten bleiben.</translation>
    </message>
    <message>
        <source>%1 points.</source>
        <translation>%1 Punkte.</translation>
    </message>
    <message>
        <source>%1 of them are drawn.</source>
        <translation>%1 davon sind gezeichnet.</translation>
    </message>
    <message>
        <source>Blue lies on the surface of the other scans, red three spacings from it; grey: no other scan is near.</source>
        <translation>Blau liegt auf der Fläche der anderen Scans, Rot drei Punktabstände davon entfernt; grau: kein anderer Scan ist nah.</translation>
    </message>
    <message>
        <source>%1 points that the file marks as withheld are left out.</source>
        <translation>%1 Punkte, die die Datei als zurückgehalten kennzeichnet, sind weggelassen.</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareRunner</name>
    <message>
        <source>No scan is chosen. Tick one in the list of scans.</source>
        <translation>Kein Scan ist gewählt. Haken Sie einen in der Liste der Scans an.</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareViews</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Drag or arrow keys turn, the right button moves, the wheel or + and - bring it nearer, Home shows all</source>
        <translation>Ziehen oder Pfeiltasten drehen, die rechte Taste schiebt, Rad oder + und - holen heran, Pos1 zeigt alles</translation>
    </message>
    <message>
        <source>Points of the reference</source>
        <translation>Punkte der Referenz</translation>
    </message>
    <message>
        <source>Seen &amp;from:</source>
        <translation>Gesehen &amp;von:</translation>
    </message>
    <message>
        <source>From which side the points are seen</source>
        <translation>Von welcher Seite die Punkte gesehen werden</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>Zei&amp;gen:</translation>
    </message>
    <message>
        <source>Points before and after the steps</source>
        <translation>Punkte vor und nach den Schritten</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Both, red goes</source>
        <translation>Beides, Rotes geht</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Co&amp;lours:</source>
        <translation>&amp;Farben:</translation>
    </message>
    <message>
        <source>What the colours of the points say</source>
        <translation>Was die Farben der Punkte sagen</translation>
    </message>
    <message>
        <source>Their own</source>
        <translation>Ihre eigenen</translation>
    </message>
    <message>
        <source>One for each scan</source>
        <translation>Eine je Scan</translation>
    </message>
    <message>
        <source>Distance of the scans</source>
        <translation>Abstand der Scans</translation>
    </message>
    <message>
        <source>From the surface of the other scans: blue at 0, red at three spacings, grey where there is none</source>
        <translation>Von der Fläche der anderen Scans: blau bei 0, rot bei drei Punktabständen, grau, wo keiner ist</translation>
    </message>
</context>
<context>
    <name>relievo::PrepareWorkRow</name>
    <message>
        <source>L&amp;ive</source>
        <translation>&amp;Laufend</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>Laufende Vorschau</translation>
    </message>
    <message>
        <source>Do the steps anew after each change</source>
        <translation>Die Schritte nach jeder Änderung neu tun</translation>
    </message>
    <message>
        <source>Recom&amp;pute</source>
        <translation>Neu &amp;berechnen</translation>
    </message>
    <message>
        <source>Do the steps as they are shown</source>
        <translation>Die Schritte tun, wie sie gezeigt werden</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Anhal&amp;ten</translation>
    </message>
    <message>
        <source>Stop the work; the picture before stays</source>
        <translation>Die Arbeit anhalten; das Bild von vorher bleibt</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>What is being done</source>
        <translation>Was gerade geschieht</translation>
    </message>
    <message>
        <source>Sa&amp;ve recipe…</source>
        <translation>Re&amp;zept sichern…</translation>
    </message>
    <message>
        <source>Keep these steps as a file, to do them again</source>
        <translation>Diese Schritte als Datei behalten, um sie wieder zu tun</translation>
    </message>
    <message>
        <source>Cop&amp;y as command</source>
        <translation>Als Bef&amp;ehl kopieren</translation>
    </message>
    <message>
        <source>The command that does the same, once the recipe is saved</source>
        <translation>Der Befehl, der dasselbe tut, sobald das Rezept gesichert ist</translation>
    </message>
    <message>
        <source>Write the prepared scan and open it</source>
        <translation>Den aufbereiteten Scan schreiben und öffnen</translation>
    </message>
    <message>
        <source>Recom&amp;pute *</source>
        <translation>Neu &amp;berechnen *</translation>
    </message>
</context>
<context>
    <name>relievo::PreparedFileRow</name>
    <message>
        <source>Prepared scan</source>
        <translation>Aufbereiteter Scan</translation>
    </message>
    <message>
        <source>The file that the prepared scan is written to; the scans stay as they are</source>
        <translation>Die Datei, in die der aufbereitete Scan geschrieben wird; die Scans bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>It is there already and will be replaced.</source>
        <translation>Sie ist schon da und wird ersetzt.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Another place or name</source>
        <translation>Ein anderer Ort oder Name</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Die Datei wählen</translation>
    </message>
    <message>
        <source>P&amp;repared scan:</source>
        <translation>Aufbereiteter S&amp;can:</translation>
    </message>
    <message>
        <source>Scans (*.ply)</source>
        <translation>Scans (*.ply)</translation>
    </message>
</context>
<context>
    <name>relievo::ProfileStrip</name>
    <message>
        <source>at %1 mm: height %2 mm</source>
        <translation>bei %1 mm: Höhe %2 mm</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Press to put the cursor, drag to choose a piece. Arrows move the cursor, with Shift they choose a piece</source>
        <translation>Drücken setzt den Zeiger, Ziehen wählt ein Stück. Pfeile bewegen den Zeiger, mit Umschalt wählen sie ein Stück</translation>
    </message>
    <message>
        <source>Profile under the views</source>
        <translation>Profil unter den Ansichten</translation>
    </message>
    <message>
        <source>Length and depth</source>
        <translation>Länge und Tiefe</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save profile</source>
        <translation>Profil speichern</translation>
    </message>
    <message>
        <source>Save the curve as it is shown, or its numbers</source>
        <translation>Die Kurve wie gezeigt oder ihre Zahlen speichern</translation>
    </message>
    <message>
        <source>Hide profile</source>
        <translation>Profil verbergen</translation>
    </message>
    <message>
        <source>Hide the curve; the Measure menu shows it again</source>
        <translation>Die Kurve verbergen; das Menü Messen zeigt sie wieder</translation>
    </message>
    <message>
        <source>Profile %1: %2</source>
        <translation>Profil %1: %2</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm deep</source>
        <translation>%1 mm lang, %2 mm tief</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3 mm long, %4 mm deep, ends differ by %5 mm</source>
        <translation>%1 bis %2 mm: %3 mm lang, %4 mm tief, Enden %5 mm verschieden</translation>
    </message>
</context>
<context>
    <name>relievo::QuestionController</name>
    <message>
        <source>&amp;Keep them</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>&amp;Leave them out</source>
        <translation>&amp;Weglassen</translation>
    </message>
    <message>
        <source>One of %1 points lies %2 % of the box away from all others.</source>
        <translation>Einer von %1 Punkten liegt %2 % des Kastens von allen anderen entfernt.</translation>
    </message>
    <message>
        <source>%1 of %2 points lie %3 % of the box away from all others.</source>
        <translation>%1 von %2 Punkten liegen %3 % des Kastens von allen anderen entfernt.</translation>
    </message>
    <message>
        <source>Kept, and so most of the map is empty.</source>
        <translation>Sie bleiben, und so ist der größte Teil der Karte leer.</translation>
    </message>
    <message>
        <source>Left out.</source>
        <translation>Weggelassen.</translation>
    </message>
    <message>
        <source>%1 of %2 points lie together, %3 % of the box away from all others.</source>
        <translation>%1 von %2 Punkten liegen beisammen, %3 % des Kastens von allen anderen entfernt.</translation>
    </message>
    <message>
        <source>Kept, as they may belong to the object.</source>
        <translation>Sie bleiben, da sie zum Objekt gehören können.</translation>
    </message>
    <message>
        <source>%1 of %2 heights are %3, which often stands for a missing one. They were left out.</source>
        <translation>%1 von %2 Höhen sind %3, was oft für eine fehlende steht. Sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>&amp;Take as missing</source>
        <translation>Als &amp;fehlend nehmen</translation>
    </message>
    <message>
        <source>&amp;Keep as heights</source>
        <translation>Als Höhen &amp;behalten</translation>
    </message>
    <message>
        <source>How this object stands is not certain. From where shall it be seen?</source>
        <translation>Wie dieses Objekt steht, ist nicht sicher. Von wo soll es gesehen werden?</translation>
    </message>
    <message>
        <source>in %1 %2</source>
        <translation>als %1 %2</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>%1: %2. Which unit?</source>
        <translation>%1: %2. Welche Einheit?</translation>
    </message>
    <message>
        <source>The points carry no unit. %1 – %2. The coordinates are those of a map projection; shown as %3 until you say. (E103)</source>
        <translation>Die Punkte tragen keine Einheit. %1 – %2. Die Koordinaten sind die einer Kartenprojektion; gezeigt als %3, bis Sie es sagen. (E103)</translation>
    </message>
    <message>
        <source>The points carry no unit. %1 – %2. Most likely %3. Shown as millimetres until you say. (E103)</source>
        <translation>Die Punkte tragen keine Einheit. %1 – %2. Am wahrscheinlichsten %3. Als Millimeter gezeigt, bis Sie es sagen. (E103)</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) that this project names were not read. They stay named in it, and are offered for no package and no figure.</source>
        <translation>
            <numerusform>%n Datei, die dieses Projekt nennt, wurde nicht gelesen. Sie bleibt darin genannt und wird für kein Paket und keine Abbildung angeboten.</numerusform>
            <numerusform>%n Dateien, die dieses Projekt nennt, wurden nicht gelesen. Sie bleiben darin genannt und werden für kein Paket und keine Abbildung angeboten.</numerusform>
        </translation>
    </message>
    <message>
        <source>This picture of heights does not say how large it is. Shown with pixels of %1 mm and steps of %2 mm: %3.</source>
        <translation>Dieses Bild von Höhen sagt nicht, wie groß es ist. Gezeigt mit Pixeln von %1 mm und Stufen von %2 mm: %3.</translation>
    </message>
    <message>
        <source>The steps are a guess: with 1 mm it would be higher than it is long.</source>
        <translation>Die Stufen sind eine Vermutung: mit 1 mm wäre es höher als lang.</translation>
    </message>
    <message>
        <source>Both are a guess.</source>
        <translation>Beides ist eine Vermutung.</translation>
    </message>
    <message>
        <source>&amp;Say how large…</source>
        <translation>&amp;Größe angeben…</translation>
    </message>
    <message>
        <source>&amp;Keep it so</source>
        <translation>So &amp;lassen</translation>
    </message>
</context>
<context>
    <name>relievo::RasterScaleDialog</name>
    <message>
        <source>Distance of the pixels</source>
        <translation>Abstand der Pixel</translation>
    </message>
    <message>
        <source>From one sample to the next, on the object</source>
        <translation>Von einem Abtastwert zum nächsten, am Objekt</translation>
    </message>
    <message>
        <source>Height of a step</source>
        <translation>Höhe einer Stufe</translation>
    </message>
    <message>
        <source>By how much the surface rises where the value grows by 1</source>
        <translation>Um wie viel die Oberfläche steigt, wo der Wert um 1 wächst</translation>
    </message>
    <message>
        <source>Value on the base plane</source>
        <translation>Wert auf der Grundebene</translation>
    </message>
    <message>
        <source>Samples with this value lie at height 0, lower ones below it</source>
        <translation>Abtastwerte mit diesem Wert liegen auf der Höhe 0, niedrigere darunter</translation>
    </message>
    <message>
        <source>&amp;Larger values lie deeper</source>
        <translation>&amp;Größere Werte liegen tiefer</translation>
    </message>
    <message>
        <source>&amp;Base plane at the value</source>
        <translation>G&amp;rundebene beim Wert</translation>
    </message>
    <message>
        <source>Size of the samples</source>
        <translation>Größe der Abtastwerte</translation>
    </message>
    <message>
        <source>As in pictures of distances from a camera</source>
        <translation>Wie in Bildern von Abständen zu einer Kamera</translation>
    </message>
    <message>
        <source>Otherwise it is the lowest sample</source>
        <translation>Sonst ist es der niedrigste Abtastwert</translation>
    </message>
    <message>
        <source>Size that follows</source>
        <translation>Größe, die sich ergibt</translation>
    </message>
    <message>
        <source>&amp;Distance of the pixels</source>
        <translation>&amp;Abstand der Pixel</translation>
    </message>
    <message>
        <source>&amp;Height of a step of 1</source>
        <translation>&amp;Höhe einer Stufe von 1</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
</context>
<context>
    <name>relievo::RecordingControl</name>
    <message>
        <source>Recording to %1</source>
        <translation>Aufzeichnung in %1</translation>
    </message>
    <message>
        <source>The last %1 before the fault are kept: %2</source>
        <translation>Die letzten %1 vor dem Fehler sind aufgehoben: %2</translation>
    </message>
    <message>
        <source>The recording has ended early.</source>
        <translation>Die Aufzeichnung endete vorzeitig.</translation>
    </message>
    <message>
        <source>Recording saved: %1, %2 samples in %3</source>
        <translation>Aufzeichnung gespeichert: %1, %2 Werte in %3</translation>
    </message>
    <message>
        <source>Note at %1 s: %2</source>
        <translation>Notiz bei %1 s: %2</translation>
    </message>
    <message>
        <source>The recording had ended before the note &quot;%1&quot; was added. The note is in no file.</source>
        <translation>Die Aufzeichnung war zu Ende, bevor die Notiz „%1“ hinzugefügt wurde. Die Notiz steht in keiner Datei.</translation>
    </message>
</context>
<context>
    <name>relievo::RecordingsEnd</name>
    <message>
        <source>Recording saved: %1</source>
        <translation>Aufnahme gesichert: %1</translation>
    </message>
</context>
<context>
    <name>relievo::ReferenceView</name>
    <message>
        <source>Draw window</source>
        <translation>Ausschnitt zeichnen</translation>
    </message>
    <message>
        <source>Move window</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>Resize window</source>
        <translation>Größe des Ausschnitts ändern</translation>
    </message>
    <message>
        <source>Drawing a window from x %1, y %2. Arrows carry the other corner, Enter ends, Escape returns</source>
        <translation>Ausschnitt ab x %1, y %2. Pfeile führen die andere Ecke, Eingabe beendet, Esc kehrt zurück</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>The whole object. The pink window is what the detail view shows: drag inside it to move it, drag its edges to resize it, drag outside to draw a new one. The wheel changes the resolution. Keys: arrows, Shift+arrows, + and -; Space, arrows and Enter draw a window.</source>
        <translation>Das ganze Objekt. Der rosa Ausschnitt ist, was die Detailansicht zeigt: Ziehen darin verschiebt ihn, Ziehen an den Rändern ändert seine Größe, Ziehen außerhalb zeichnet einen neuen. Das Rad wechselt die Auflösung. Tasten: Pfeile, Umschalt+Pfeile, + und -; Leertaste, Pfeile und Eingabe zeichnen einen Ausschnitt.</translation>
    </message>
    <message>
        <source>Resolution %1 of %2, window %3 wide, lower left corner at x %4, y %5</source>
        <translation>Auflösung %1 von %2, Ausschnitt %3 breit, linke untere Ecke bei x %4, y %5</translation>
    </message>
</context>
<context>
    <name>relievo::RegionEditor</name>
    <message>
        <source>Larger window</source>
        <translation>Größeres Fenster</translation>
    </message>
    <message>
        <source>Smaller window</source>
        <translation>Kleineres Fenster</translation>
    </message>
    <message>
        <source>Whole object</source>
        <translation>Ganzes Objekt</translation>
    </message>
    <message>
        <source>Move window</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>Choose window</source>
        <translation>Ausschnitt wählen</translation>
    </message>
    <message>
        <source>Vertical exaggeration</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Resolution %1 → %2</source>
        <translation>Auflösung %1 → %2</translation>
    </message>
</context>
<context>
    <name>relievo::RegionPanel</name>
    <message>
        <source>Left edge of the pink window</source>
        <translation>Linker Rand des rosa Ausschnitts</translation>
    </message>
    <message>
        <source>Left edge of the window</source>
        <translation>Linker Rand des Ausschnitts</translation>
    </message>
    <message>
        <source>Lower edge of the pink window</source>
        <translation>Unterer Rand des rosa Ausschnitts</translation>
    </message>
    <message>
        <source>Lower edge of the window</source>
        <translation>Unterer Rand des Ausschnitts</translation>
    </message>
    <message>
        <source>Si&amp;de</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>Width and height of the pink window</source>
        <translation>Breite und Höhe des rosa Ausschnitts</translation>
    </message>
    <message>
        <source>Heights are multiplied by this; 1 is true to scale</source>
        <translation>Höhen werden damit vervielfacht; 1 ist maßstabsgetreu</translation>
    </message>
    <message>
        <source>Heights are multiplied by this; the middle is true to scale</source>
        <translation>Höhen werden damit vervielfacht; die Mitte ist maßstabsgetreu</translation>
    </message>
    <message>
        <source>Hand scale</source>
        <translation>Maßstab der Hand</translation>
    </message>
    <message>
        <source>Vertical exaggeration</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>Exaggeratio&amp;n</source>
        <translation>Übe&amp;rhöhung</translation>
    </message>
    <message>
        <source>Hand scale 1 : %1</source>
        <translation>Maßstab der Hand 1 : %1</translation>
    </message>
    <message>
        <source>%1/%2 (level 0)</source>
        <translation>%1/%2 (Ebene 0)</translation>
    </message>
    <message>
        <source>%1/%2 (level %3, σ %4)</source>
        <translation>%1/%2 (Ebene %3, σ %4)</translation>
    </message>
    <message>
        <source>Reso&amp;lution</source>
        <translation>A&amp;uflösung</translation>
    </message>
    <message>
        <source>Which level of the pyramid feeds the window</source>
        <translation>Welche Ebene der Pyramide den Ausschnitt speist</translation>
    </message>
</context>
<context>
    <name>relievo::ReplayControl</name>
    <message>
        <source>Paused, %1</source>
        <translation>Angehalten, %1</translation>
    </message>
    <message numerus="yes">
        <source>The recording does not say where %n window(s) lay; they are shown around what was touched.</source>
        <translation>
            <numerusform>Die Aufzeichnung sagt nicht, wo %n Ausschnitt lag; er wird um das Getastete gezeigt.</numerusform>
            <numerusform>Die Aufzeichnung sagt nicht, wo %n Ausschnitte lagen; sie werden um das Getastete gezeigt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 does not say what was touched. Open that file first.</source>
        <translation>%1 sagt nicht, was getastet wurde. Öffnen Sie zuerst diese Datei.</translation>
    </message>
    <message>
        <source>%1 was recorded on %2, which is not open.</source>
        <translation>%1 wurde auf %2 aufgezeichnet; diese Datei ist nicht geöffnet.</translation>
    </message>
    <message>
        <source>%1 was recorded on %2, not on %3.</source>
        <translation>%1 wurde auf %2 aufgezeichnet, nicht auf %3.</translation>
    </message>
    <message>
        <source>%1 was recorded on another view of %2 or with another unit.</source>
        <translation>%1 wurde auf einer anderen Ansicht von %2 oder mit einer anderen Einheit aufgezeichnet.</translation>
    </message>
    <message>
        <source>%1 does not say what it was recorded on; it is shown on the open map.</source>
        <translation>%1 sagt nicht, worauf sie aufgezeichnet wurde; sie wird auf der geöffneten Karte gezeigt.</translation>
    </message>
    <message>
        <source>Replay of %1, %2 s. Forces are off. Space plays.</source>
        <translation>Wiedergabe von %1, %2 s. Die Kräfte sind aus. Die Leertaste spielt ab.</translation>
    </message>
    <message>
        <source>Replay closed</source>
        <translation>Wiedergabe geschlossen</translation>
    </message>
    <message>
        <source>No event after this place</source>
        <translation>Kein Ereignis nach dieser Stelle</translation>
    </message>
    <message>
        <source>No event before this place</source>
        <translation>Kein Ereignis vor dieser Stelle</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>Playing</source>
        <translation>Wiedergabe</translation>
    </message>
</context>
<context>
    <name>relievo::ReplayController</name>
    <message>
        <source>The next recording is %1</source>
        <translation>Die nächste Aufzeichnung ist %1</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Recordings go to %1</source>
        <translation>Aufnahmen kommen nach %1</translation>
    </message>
    <message>
        <source>Recordings are kept in %1.</source>
        <translation>Aufnahmen liegen in %1.</translation>
    </message>
    <message>
        <source>Another &amp;folder…</source>
        <translation>Anderer &amp;Ordner …</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.h5 *.hdf5)</source>
        <translation>Aufzeichnungen (*.csv *.h5 *.hdf5)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>A recording is running. Nothing was opened. Stop it first (Ctrl+R).</source>
        <translation>Eine Aufzeichnung läuft. Nichts wurde geöffnet. Halten Sie sie zuerst an (Strg+R).</translation>
    </message>
    <message>
        <source>%1 Nothing was changed.</source>
        <translation>%1 Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>&amp;Open its input</source>
        <translation>&amp;Ihre Quelle öffnen</translation>
    </message>
</context>
<context>
    <name>relievo::ReplayPanel</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Abspielen oder halten (Leertaste)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>End the replay (Esc)</source>
        <translation>Die Wiedergabe beenden (Esc)</translation>
    </message>
    <message>
        <source>Height of hand and proxy in the recording</source>
        <translation>Höhe von Hand und Proxy in der Aufzeichnung</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>Force in the recording</source>
        <translation>Kraft in der Aufzeichnung</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Place in the recording</source>
        <translation>Stelle in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>Zeit in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the recording is shown</source>
        <translation>Wie schnell die Aufzeichnung gezeigt wird</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>Drag through the recording; left and right by 0.1 s, Page keys by 1 s, up and down by events</source>
        <translation>Durch die Aufzeichnung ziehen; links und rechts um 0,1 s, Bild-Tasten um 1 s, auf und ab um Ereignisse</translation>
    </message>
    <message>
        <source>◂ Event</source>
        <translation>◂ Ereignis</translation>
    </message>
    <message>
        <source>Event before</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Pfeil auf</translation>
    </message>
    <message>
        <source>Event ▸</source>
        <translation>Ereignis ▸</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Pfeil ab</translation>
    </message>
    <message>
        <source>◂ Sample</source>
        <translation>◂ Wert</translation>
    </message>
    <message>
        <source>Sample before</source>
        <translation>Voriger Wert</translation>
    </message>
    <message>
        <source>Shift+Left</source>
        <translation>Umschalt+Pfeil links</translation>
    </message>
    <message>
        <source>Sample ▸</source>
        <translation>Wert ▸</translation>
    </message>
    <message>
        <source>Next sample</source>
        <translation>Nächster Wert</translation>
    </message>
    <message>
        <source>Shift+Right</source>
        <translation>Umschalt+Pfeil rechts</translation>
    </message>
    <message>
        <source>Here in the recording</source>
        <translation>Hier in der Aufzeichnung</translation>
    </message>
    <message>
        <source>   |   since %1 s: %2</source>
        <translation>   |   seit %1 s: %2</translation>
    </message>
    <message>
        <source>HIP z %1 mm   proxy z %2 mm   force %3 N</source>
        <translation>HIP z %1 mm   Proxy z %2 mm   Kraft %3 N</translation>
    </message>
</context>
<context>
    <name>relievo::SaveController</name>
    <message>
        <source>Unsaved work</source>
        <translation>Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Save it as a project?</source>
        <translation>Als Projekt speichern?</translation>
    </message>
    <message>
        <source>relievo could not be started again. Nothing was changed. Close it and start it yourself.</source>
        <translation>relievo konnte nicht neu gestartet werden. Nichts wurde geändert. Beenden Sie es und starten Sie es selbst.</translation>
    </message>
    <message>
        <source>relievo closes when the package is written</source>
        <translation>relievo schließt, wenn das Paket geschrieben ist</translation>
    </message>
    <message>
        <source>relievo closes when the map is written</source>
        <translation>relievo schließt, wenn die Karte geschrieben ist</translation>
    </message>
    <message>
        <source>relievo closes when the video is saved; Escape stops both</source>
        <translation>relievo schließt, wenn das Video gespeichert ist; Escape bricht beides ab</translation>
    </message>
    <message>
        <source>relievo closes when the picture is saved</source>
        <translation>relievo schließt, sobald das Bild gespeichert ist</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Projects (*.relievo.json)</source>
        <translation>Projekte (*.relievo.json)</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 ist gespeichert</translation>
    </message>
    <message>
        <source>%1[*] – relievo</source>
        <translation>%1[*] – relievo</translation>
    </message>
    <message>
        <source>Work on %1 is in no file yet: bookmarks, measurements, camera paths or settings.</source>
        <translation>Arbeit an %1 steht noch in keiner Datei: Lesezeichen, Messungen, Kamerawege oder Einstellungen.</translation>
    </message>
</context>
<context>
    <name>relievo::ScanList</name>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Lies</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Further scans of the same object</source>
        <translation>Weitere Scans desselben Objekts</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the chosen scan off the list</source>
        <translation>Den gewählten Scan aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>The chosen scan stays where it is; the others are laid on it</source>
        <translation>Der gewählte Scan bleibt, wo er ist; die anderen werden auf ihn gelegt</translation>
    </message>
    <message>
        <source>Pic&amp;k pairs…</source>
        <translation>&amp;Paare wählen…</translation>
    </message>
    <message>
        <source>Show the same three places on the chosen scan and on the reference</source>
        <translation>Dieselben drei Stellen auf dem gewählten Scan und auf der Referenz zeigen</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Forget the place picked last</source>
        <translation>Die zuletzt gewählte Stelle vergessen</translation>
    </message>
    <message>
        <source>Remove pair</source>
        <translation>Paar entfernen</translation>
    </message>
    <message>
        <source>Forget the chosen pair, such as the one that fits worst (Delete)</source>
        <translation>Das ausgewählte Paar vergessen, etwa das am schlechtesten passende (Entf)</translation>
    </message>
    <message>
        <source>Picked pairs</source>
        <translation>Gewählte Paare</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>How far apart each pair&apos;s places are left where all pairs fit best; from three on</source>
        <translation>Wie weit die Stellen jedes Paares auseinander bleiben, wo alle Paare am besten passen; ab drei Paaren</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Aufteilen</translation>
    </message>
    <message>
        <source>Each of the file&apos;s scans for itself, to leave some out or align them</source>
        <translation>Jeder Scan der Datei für sich, um einige wegzulassen oder auszurichten</translation>
    </message>
    <message>
        <source>With withheld points</source>
        <translation>Mit zurückgehaltenen Punkten</translation>
    </message>
    <message>
        <source>Points of the chosen scan that its file marks as not to be used</source>
        <translation>Punkte des gewählten Scans, die seine Datei als nicht zu verwenden kennzeichnet</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number, scan</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>as stored</source>
        <translation>wie gespeichert</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>Pairs are pic&amp;ked</source>
        <translation>&amp;Paare sind gewählt</translation>
    </message>
    <message>
        <source>Pairs are picked</source>
        <translation>Paare sind gewählt</translation>
    </message>
    <message>
        <source>Pick pairs</source>
        <translation>Paare wählen</translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>Paar %1</translation>
    </message>
    <message>
        <source>%1 mm, worst</source>
        <translation>%1 mm, am größten</translation>
    </message>
    <message>
        <source>Add scans</source>
        <translation>Scans hinzufügen</translation>
    </message>
</context>
<context>
    <name>relievo::ScanView</name>
    <message>
        <source>Make relief from here</source>
        <translation>Relief von hier machen</translation>
    </message>
    <message>
        <source>As the relief</source>
        <translation>Wie das Relief</translation>
    </message>
    <message>
        <source>Make the relief anew as the scan is looked at now (Enter)</source>
        <translation>Das Relief neu machen, wie der Scan jetzt betrachtet wird (Enter)</translation>
    </message>
    <message>
        <source>Look at the scan from where the relief is seen</source>
        <translation>Den Scan von dort betrachten, von wo das Relief gesehen wird</translation>
    </message>
    <message>
        <source>Scan in 3-D</source>
        <translation>Scan in 3-D</translation>
    </message>
    <message>
        <source>The scan behind the relief. Drag with the left button or use the arrows to turn it, the right button moves it, the wheel or + and - bring it nearer, Home shows all of it. Enter makes the relief from here. The box is the window, the arrow shows along which direction the relief is seen.</source>
        <translation>Der Scan hinter dem Relief. Ziehen mit der linken Taste oder die Pfeiltasten drehen ihn, die rechte Taste verschiebt ihn, das Rad oder + und - holen ihn näher, Pos1 zeigt ihn ganz. Enter macht das Relief von hier. Der Kasten ist der Ausschnitt, der Pfeil zeigt, in welcher Richtung das Relief gesehen wird.</translation>
    </message>
    <message>
        <source>The scan is being prepared for the view…</source>
        <translation>Der Scan wird für die Ansicht vorbereitet…</translation>
    </message>
    <message>
        <source>Points: %1 of %2</source>
        <translation>Punkte: %1 von %2</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Dreiecke: %1</translation>
    </message>
    <message>
        <source>Seen as the relief is</source>
        <translation>Gesehen wie das Relief</translation>
    </message>
    <message>
        <source>Turned by %1° from where the relief is seen</source>
        <translation>Um %1° gedreht gegenüber dem Blick auf das Relief</translation>
    </message>
</context>
<context>
    <name>relievo::ScopeDialog</name>
    <message>
        <source>Force and height against time</source>
        <translation>Kraft und Höhe über der Zeit</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>Werte am Zeiger</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Hold the plots still</source>
        <translation>Die Kurven anhalten</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>V&amp;ergrößern</translation>
    </message>
    <message>
        <source>Show a shorter time (plus, wheel)</source>
        <translation>Eine kürzere Zeit zeigen (Plus, Rad)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Verkleinern</translation>
    </message>
    <message>
        <source>Show a longer time (minus, wheel)</source>
        <translation>Eine längere Zeit zeigen (Minus, Rad)</translation>
    </message>
    <message>
        <source>&amp;SVG…</source>
        <translation>&amp;SVG…</translation>
    </message>
    <message>
        <source>Save what is shown as a drawing</source>
        <translation>Das Gezeigte als Zeichnung speichern</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>&amp;CSV…</source>
        <translation>&amp;CSV…</translation>
    </message>
    <message>
        <source>Save what is shown as a table</source>
        <translation>Das Gezeigte als Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>Die Kurven speichern</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>relievo::ScopeView</name>
    <message>
        <source>Height of hand and proxy, and force</source>
        <translation>Höhe von Hand und Proxy, und Kraft</translation>
    </message>
    <message>
        <source>Left and Right move the cursor, plus and minus zoom.</source>
        <translation>Links und Rechts bewegen den Zeiger, Plus und Minus vergrößern und verkleinern.</translation>
    </message>
    <message>
        <source>Nothing measured yet.</source>
        <translation>Noch nichts gemessen.</translation>
    </message>
    <message>
        <source>At %1 s: HIP %2 mm, proxy %3 mm, force %4 N</source>
        <translation>Bei %1 s: HIP %2 mm, Proxy %3 mm, Kraft %4 N</translation>
    </message>
</context>
<context>
    <name>relievo::SetupHomingBox</name>
    <message>
        <source>Homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Top arm</source>
        <translation>Oberer Arm</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Rechter Arm</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>Linker Arm</translation>
    </message>
    <message>
        <source>Place of the hand</source>
        <translation>Ort der Hand</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>✓ found</source>
        <translation>✓ gefunden</translation>
    </message>
    <message>
        <source>– missing</source>
        <translation>– fehlt</translation>
    </message>
    <message>
        <source>%1 right, %2 up, %3 out, in millimetres; %4 answers per second</source>
        <translation>%1 nach rechts, %2 nach oben, %3 nach vorn, in Millimetern; %4 Antworten je Sekunde</translation>
    </message>
    <message>
        <source>not known before homing</source>
        <translation>vor der Referenzfahrt nicht bekannt</translation>
    </message>
</context>
<context>
    <name>relievo::SetupStartBox</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>&amp;Noch einmal</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>&amp;Firmware file…</source>
        <translation>&amp;Firmware-Datei…</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>Firmware-Datei</translation>
    </message>
    <message>
        <source>&amp;Copy rule</source>
        <translation>&amp;Regel kopieren</translation>
    </message>
    <message>
        <source>Copy rule</source>
        <translation>Regel kopieren</translation>
    </message>
    <message>
        <source>Firmware file in use</source>
        <translation>Benutzte Firmware-Datei</translation>
    </message>
    <message>
        <source>Firmware loaded</source>
        <translation>Firmware geladen</translation>
    </message>
    <message>
        <source>not loaded yet</source>
        <translation>noch nicht geladen</translation>
    </message>
    <message>
        <source>Rule that gives access</source>
        <translation>Regel, die Zugang gibt</translation>
    </message>
    <message>
        <source># As an administrator, write this into /etc/udev/rules.d/60-relievo-falcon.rules, then replug:
</source>
        <translation># Als Verwalter in /etc/udev/rules.d/60-relievo-falcon.rules schreiben, dann neu einstecken:
</translation>
    </message>
    <message>
        <source>attempt %1 of %2, %p %</source>
        <translation>Versuch %1 von %2, %p %</translation>
    </message>
    <message>
        <source>was running already</source>
        <translation>lief schon</translation>
    </message>
    <message>
        <source>Firmware: %1, %2</source>
        <translation>Firmware: %1, %2</translation>
    </message>
    <message>
        <source>Firmware: %1, accepted by you</source>
        <translation>Firmware: %1, von Ihnen angenommen</translation>
    </message>
    <message>
        <source>Firmware: no file found yet</source>
        <translation>Firmware: noch keine Datei gefunden</translation>
    </message>
    <message>
        <source>Firmware: %1 cannot be used</source>
        <translation>Firmware: %1 ist nicht verwendbar</translation>
    </message>
</context>
<context>
    <name>relievo::SidePanels</name>
    <message>
        <source>Panels</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>%1 zeigen oder verbergen</translation>
    </message>
    <message>
        <source>%1 panel</source>
        <translation>Feld %1</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>zugeklappt</translation>
    </message>
    <message>
        <source>open</source>
        <translation>aufgeklappt</translation>
    </message>
</context>
<context>
    <name>relievo::SoundControl</name>
    <message>
        <source>the sound server does not answer</source>
        <translation>der Klangserver antwortet nicht</translation>
    </message>
    <message>
        <source>There is no sound: %1. Touch goes on without it. Switch the sounds off and on to try again.</source>
        <translation>Es gibt keinen Klang: %1. Das Fühlen geht ohne ihn weiter. Schalten Sie die Klänge aus und wieder ein, um es neu zu versuchen.</translation>
    </message>
    <message>
        <source>Sounds of touch at %1 percent.</source>
        <translation>Klänge beim Fühlen bei %1 Prozent.</translation>
    </message>
    <message>
        <source>Sounds of touch on.</source>
        <translation>Klänge beim Fühlen an.</translation>
    </message>
    <message>
        <source>Sounds of touch off.</source>
        <translation>Klänge beim Fühlen aus.</translation>
    </message>
</context>
<context>
    <name>relievo::SoundRows</name>
    <message>
        <source>Sounds of touch</source>
        <translation>Klänge beim Fühlen</translation>
    </message>
    <message>
        <source>Volume of the sounds in percent</source>
        <translation>Lautstärke der Klänge in Prozent</translation>
    </message>
    <message>
        <source>Hear what the hand meets, while it touches (Ctrl+Alt+A).</source>
        <translation>Hören, worauf die Hand trifft, während sie fühlt (Ctrl+Alt+A).</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Of the sounds of touch; speech has a volume of its own.</source>
        <translation>Der Klänge beim Fühlen; die Sprache hat eine eigene Lautstärke.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Felt patterns</source>
        <translation>Tastzeichen</translation>
    </message>
    <message>
        <source>Taps of the grip: one is yes, two not measured, three the edge. Only while forces are on.</source>
        <translation>Stöße des Griffs: einer ist ja, zwei nicht gemessen, drei der Rand. Nur solange Kräfte an sind.</translation>
    </message>
</context>
<context>
    <name>relievo::StartPage</name>
    <message>
        <source>Acceptance relief: dome, step, ridge, grating</source>
        <translation>Abnahmerelief: Kuppel, Stufe, Grat, Gitter</translation>
    </message>
    <message>
        <source>Coin, 24 mm across</source>
        <translation>Münze, 24 mm breit</translation>
    </message>
    <message>
        <source>Carved panel with undercuts</source>
        <translation>Geschnitzte Tafel mit Hinterschnitten</translation>
    </message>
    <message>
        <source>Ruin, 400 m across</source>
        <translation>Ruine, 400 m breit</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Open a scan to see and touch it</source>
        <translation>Einen Scan öffnen, um ihn zu sehen und zu fühlen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a scan (Ctrl+O)</source>
        <translation>Einen Scan öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Point clouds and meshes (%1), height maps (TIFF, PNG, ASCII grid), projects and figures. You can also drop a file on this window.</source>
        <translation>Punktwolken und Netze (%1), Höhenkarten (TIFF, PNG, ASCII-Gitter), Projekte und Abbildungen. Sie können eine Datei auch auf dieses Fenster ziehen.</translation>
    </message>
</context>
<context>
    <name>relievo::StatusFields</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Kind of surface</source>
        <translation>Art der Oberfläche</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force rate</source>
        <translation>Takt der Kraft</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Running step</source>
        <translation>Laufender Schritt</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop this work; what is shown stays (Esc)</source>
        <translation>Diese Arbeit anhalten; was gezeigt wird, bleibt (Esc)</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
</context>
<context>
    <name>relievo::StepForm</name>
    <message>
        <source>What is inside</source>
        <translation>Was innen liegt</translation>
    </message>
    <message>
        <source>What is outside</source>
        <translation>Was außen liegt</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>Which part of the scan stays</source>
        <translation>Welcher Teil des Scans bleibt</translation>
    </message>
    <message>
        <source>x from</source>
        <translation>x von</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x bis</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y von</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y bis</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z von</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z bis</translation>
    </message>
    <message>
        <source>In the file&apos;s coordinates</source>
        <translation>In den Koordinaten der Datei</translation>
    </message>
    <message>
        <source>&amp;Draw on the view</source>
        <translation>Auf der Ansicht zeich&amp;nen</translation>
    </message>
    <message>
        <source>&amp;Draw it anew</source>
        <translation>Neu zeich&amp;nen</translation>
    </message>
    <message>
        <source>Drag the mouse round what is meant; or arrow keys and Enter for each corner, Ctrl+Enter to close</source>
        <translation>Mit der Maus umfahren, was gemeint ist; oder Pfeiltasten und Eingabe für jede Ecke, Strg+Eingabe zum Schließen</translation>
    </message>
    <message>
        <source>No outline is drawn yet; nothing is left out.</source>
        <translation>Noch ist kein Umriss gezeichnet; nichts wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>Classes that stay</source>
        <translation>Klassen, die bleiben</translation>
    </message>
    <message>
        <source>Numbers of LAS classes such as 2, 6; none: all</source>
        <translation>Nummern von LAS-Klassen wie 2, 6; keine: alle</translation>
    </message>
    <message>
        <source>Noise stays, too</source>
        <translation>Rauschen bleibt auch</translation>
    </message>
    <message>
        <source>Classes 7 and 18 are marked as noise</source>
        <translation>Klassen 7 und 18 sind als Rauschen gekennzeichnet</translation>
    </message>
    <message>
        <source>Returns that stay</source>
        <translation>Echos, die bleiben</translation>
    </message>
    <message>
        <source>Of each pulse of a laser scanner; one that came back once is first, last and single</source>
        <translation>Von jedem Puls eines Laserscanners; ein Puls mit einem Echo ist erstes, letztes und einziges</translation>
    </message>
    <message>
        <source>First: the tops of trees and roofs</source>
        <translation>Erste: Baumkronen und Dächer</translation>
    </message>
    <message>
        <source>Last: mostly the ground</source>
        <translation>Letzte: meist der Boden</translation>
    </message>
    <message>
        <source>Single: pulses that came back once</source>
        <translation>Einzige: Pulse mit nur einem Echo</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Lowest intensity that stays, as stored</source>
        <translation>Kleinste Intensität, die bleibt, wie gespeichert</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Highest intensity that stays, as stored</source>
        <translation>Größte Intensität, die bleibt, wie gespeichert</translation>
    </message>
    <message>
        <source>Of points with equal coordinates the first stays.</source>
        <translation>Von Punkten mit gleichen Koordinaten bleibt der erste.</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>How many nearest points are looked at</source>
        <translation>Wie viele nächste Punkte angesehen werden</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>Points farther from these than the mean and so many standard deviations go</source>
        <translation>Punkte, die von ihnen weiter entfernt sind als der Mittelwert und so viele Standardabweichungen, gehen</translation>
    </message>
    <message>
        <source>Radius in</source>
        <translation>Radius in</translation>
    </message>
    <message>
        <source>Whether the radius follows the scan&apos;s density</source>
        <translation>Ob der Radius der Dichte des Scans folgt</translation>
    </message>
    <message>
        <source>Spacings of the scan</source>
        <translation>Punktabständen des Scans</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>How far neighbours may be</source>
        <translation>Wie weit Nachbarn entfernt sein dürfen</translation>
    </message>
    <message>
        <source>Points with fewer neighbours within the radius go</source>
        <translation>Punkte mit weniger Nachbarn im Radius gehen</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Points so many times as far from these as the densest of them go</source>
        <translation>Punkte, die so viel Mal so weit von ihnen liegen wie der dichteste von ihnen, gehen</translation>
    </message>
    <message>
        <source>Off the surface</source>
        <translation>Abseits der Fläche</translation>
    </message>
    <message>
        <source>Then points go that lie so many times as far off the plane of their neighbours as others, at most 0.18 % of them</source>
        <translation>Dann gehen Punkte, die so viele Male so weit von der Ebene ihrer Nachbarn liegen wie andere, höchstens 0,18 %</translation>
    </message>
    <message>
        <source>Nothing goes</source>
        <translation>Nichts geht</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>In every cube of this side one point stays</source>
        <translation>In jedem Würfel dieser Kante bleibt ein Punkt</translation>
    </message>
    <message>
        <source>Its points</source>
        <translation>Ihre Punkte</translation>
    </message>
    <message>
        <source>What becomes of the plane that holds most points</source>
        <translation>Was aus der Ebene wird, auf der die meisten Punkte liegen</translation>
    </message>
    <message>
        <source>Are left out</source>
        <translation>Werden weggelassen</translation>
    </message>
    <message>
        <source>Are laid level, with the object above them</source>
        <translation>Werden waagerecht gelegt, das Objekt darüber</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Nearer points are on the plane; 0: twice the scan&apos;s spacing</source>
        <translation>Nähere Punkte liegen auf der Ebene; 0: der doppelte Punktabstand des Scans</translation>
    </message>
    <message>
        <source>Twice the spacing</source>
        <translation>Doppelter Punktabstand</translation>
    </message>
    <message>
        <source>How many nearest points a normal is made of</source>
        <translation>Aus wie vielen nächsten Punkten eine Normale gemacht wird</translation>
    </message>
    <message>
        <source>Where they lie</source>
        <translation>Wo sie liegen</translation>
    </message>
    <message>
        <source>How the scans are laid on the reference</source>
        <translation>Wie die Scans auf die Referenz gelegt werden</translation>
    </message>
    <message>
        <source>As stored</source>
        <translation>Wie gespeichert</translation>
    </message>
    <message>
        <source>By three picked pairs</source>
        <translation>Über drei gewählte Paare</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number is another search</source>
        <translation>Eine andere Zahl ist eine andere Suche</translation>
    </message>
</context>
<context>
    <name>relievo::StepList</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Add s&amp;tep</source>
        <translation>Schritt h&amp;inzufügen</translation>
    </message>
    <message>
        <source>Choose what is done next</source>
        <translation>Wählen, was als Nächstes geschieht</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Leave the chosen step out (Delete)</source>
        <translation>Den gewählten Schritt weglassen (Entf)</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>Schritt entfernen</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Do the chosen step earlier (Ctrl+Up)</source>
        <translation>Den gewählten Schritt früher tun (Strg+Auf)</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Do the chosen step later (Ctrl+Down)</source>
        <translation>Den gewählten Schritt später tun (Strg+Ab)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>Die letzte Änderung zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redo it (Ctrl+Y)</source>
        <translation>Sie wiederholen (Strg+Y)</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>nicht getan</translation>
    </message>
</context>
<context>
    <name>relievo::StereoPanel</name>
    <message>
        <source>At mi&amp;d height</source>
        <translation>A&amp;uf mittlerer Höhe</translation>
    </message>
    <message>
        <source>S&amp;wap eyes</source>
        <translation>Augen &amp;tauschen</translation>
    </message>
    <message>
        <source>&amp;Keep comfortable</source>
        <translation>Angenehm ha&amp;lten</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Half colour</source>
        <translation>Halbfarbig</translation>
    </message>
    <message>
        <source>Dubois</source>
        <translation>Dubois</translation>
    </message>
    <message>
        <source>Eye separation</source>
        <translation>Augenabstand</translation>
    </message>
    <message>
        <source>Zero plane at mid height</source>
        <translation>Nullebene auf mittlerer Höhe</translation>
    </message>
    <message>
        <source>The screen lies halfway between the lowest and the highest point</source>
        <translation>Der Bildschirm liegt auf halbem Weg zwischen dem tiefsten und dem höchsten Punkt</translation>
    </message>
    <message>
        <source>Zero plane</source>
        <translation>Nullebene</translation>
    </message>
    <message>
        <source>Height that appears in the plane of the screen</source>
        <translation>Höhe, die in der Bildschirmebene erscheint</translation>
    </message>
    <message>
        <source>Swap eyes</source>
        <translation>Augen tauschen</translation>
    </message>
    <message>
        <source>For glasses whose red filter is at the right eye</source>
        <translation>Für Brillen mit dem roten Filter am rechten Auge</translation>
    </message>
    <message>
        <source>Keep comfortable</source>
        <translation>Angenehm halten</translation>
    </message>
    <message>
        <source>Less eye separation where the two pictures would lie farther apart than the eyes like</source>
        <translation>Weniger Augenabstand, wo die zwei Bilder weiter auseinander lägen, als die Augen mögen</translation>
    </message>
    <message>
        <source>Parallax</source>
        <translation>Parallaxe</translation>
    </message>
    <message>
        <source>How far apart the eyes see the farthest point, at 60 cm from the screen; above 1 degree many people see double</source>
        <translation>Wie weit auseinander die Augen den fernsten Punkt sehen, 60 cm vor dem Bildschirm; über 1 Grad sehen viele doppelt</translation>
    </message>
    <message>
        <source>Test &amp;glasses…</source>
        <translation>Brille &amp;prüfen…</translation>
    </message>
    <message>
        <source>Test glasses</source>
        <translation>Brille prüfen</translation>
    </message>
    <message>
        <source>A picture that says whether the filters are at the right eyes</source>
        <translation>Ein Bild, das sagt, ob die Filter an den richtigen Augen sind</translation>
    </message>
    <message>
        <source>K&amp;ind</source>
        <translation>A&amp;rt</translation>
    </message>
    <message>
        <source>Eye sepa&amp;ration</source>
        <translation>A&amp;ugenabstand</translation>
    </message>
    <message>
        <source>Zero &amp;plane</source>
        <translation>Nu&amp;llebene</translation>
    </message>
    <message>
        <source>%1°, above %2°</source>
        <translation>%1°, über %2°</translation>
    </message>
    <message>
        <source>%1° of %2°</source>
        <translation>%1° von %2°</translation>
    </message>
    <message>
        <source>Automatic dept&amp;h</source>
        <translation>Automatische Tie&amp;fe</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions; more gives more depth. A value of your own ends the automatic depth</source>
        <translation>Winkel zwischen den Blickrichtungen der Augen; mehr gibt mehr Tiefe. Ein eigener Wert beendet die automatische Tiefe</translation>
    </message>
    <message>
        <source>Automatic depth</source>
        <translation>Automatische Tiefe</translation>
    </message>
    <message>
        <source>The eye separation with which the heights that are shown fill the comfortable depth</source>
        <translation>Der Augenabstand, mit dem die gezeigten Höhen die angenehme Tiefe ausfüllen</translation>
    </message>
    <message>
        <source>%1, automatic</source>
        <translation>%1, automatisch</translation>
    </message>
    <message>
        <source>Show in &amp;stereo</source>
        <translation>In &amp;Stereo zeigen</translation>
    </message>
    <message>
        <source>Show in stereo</source>
        <translation>In Stereo zeigen</translation>
    </message>
    <message>
        <source>For red and cyan glasses, or for a screen for two eyes (Ctrl+3)</source>
        <translation>Für Rot-Cyan-Brillen oder für einen Bildschirm für zwei Augen (Strg+3)</translation>
    </message>
    <message>
        <source>Kind of stereo</source>
        <translation>Art des Stereos</translation>
    </message>
    <message>
        <source>Grey: no colour fights with the glasses. Half colour: some colour. Dubois: least ghosts by the filters of common glasses. The others are for screens that show each eye its own half or rows; F11 gives them the whole screen</source>
        <translation>Grau: keine Farbe streitet mit der Brille. Halbfarbe: etwas Farbe. Dubois: am wenigsten Geisterbilder nach den Filtern üblicher Brillen. Die anderen sind für Bildschirme, die jedem Auge seine Hälfte oder seine Zeilen zeigen; F11 gibt ihnen den ganzen Bildschirm</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>Zeilenweise</translation>
    </message>
</context>
<context>
    <name>relievo::StrengthRow</name>
    <message>
        <source>Gentle</source>
        <translation>Sanft</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Strength in percent</source>
        <translation>Stärke in Prozent</translation>
    </message>
    <message>
        <source>Multiplies every force. The limit stays.</source>
        <translation>Vervielfacht jede Kraft. Die Grenze bleibt.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Strength of all forces</source>
        <translation>Stärke aller Kräfte</translation>
    </message>
    <message>
        <source>Own strength</source>
        <translation>Eigene Stärke</translation>
    </message>
    <message>
        <source>How strong all forces are, in one choice.</source>
        <translation>Wie stark alle Kräfte sind, in einer Auswahl.</translation>
    </message>
    <message>
        <source>St&amp;rength</source>
        <translation>&amp;Stärke</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>relievo::StudyController</name>
    <message>
        <source>Stop the recording first (Ctrl+R): it belongs to this condition.</source>
        <translation>Beenden Sie erst die Aufnahme (Strg+R): sie gehört zu dieser Bedingung.</translation>
    </message>
    <message>
        <source>Condition %1</source>
        <translation>Bedingung %1</translation>
    </message>
    <message>
        <source>Condition %1, %2 of %3.</source>
        <translation>Bedingung %1, %2 von %3.</translation>
    </message>
    <message>
        <source>All %1 conditions were shown. The sitting is in %2.</source>
        <translation>Alle %1 Bedingungen wurden gezeigt. Die Sitzung ist in %2.</translation>
    </message>
    <message>
        <source>The sitting ended after %1 of %2 conditions. It is in %3.</source>
        <translation>Die Sitzung endete nach %1 von %2 Bedingungen. Sie ist in %3.</translation>
    </message>
</context>
<context>
    <name>relievo::StudyDialog</name>
    <message>
        <source>Participant code</source>
        <translation>Teilnehmercode</translation>
    </message>
    <message>
        <source>Letters, digits, - and _; no name. Who has which code is kept elsewhere</source>
        <translation>Buchstaben, Ziffern, - und _; kein Name. Wer welchen Code hat, wird anderswo verwahrt</translation>
    </message>
    <message>
        <source>Note on the consent</source>
        <translation>Notiz zur Einwilligung</translation>
    </message>
    <message>
        <source>What was agreed to, when and how, as: form 3, signed 24 November</source>
        <translation>Worin wann und wie eingewilligt wurde, etwa: Formular 3, unterschrieben am 24. November</translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation>Ordner der Studie</translation>
    </message>
    <message>
        <source>Each participant gets a folder in it, and each sitting one in that</source>
        <translation>Jede teilnehmende Person bekommt darin einen Ordner und jede Sitzung darin wieder einen</translation>
    </message>
    <message>
        <source>The participant has a&amp;greed</source>
        <translation>Die teilnehmende Person hat ein&amp;gewilligt</translation>
    </message>
    <message>
        <source>Sitting of a study</source>
        <translation>Sitzung einer Studie</translation>
    </message>
    <message>
        <source>To be asked before every sitting</source>
        <translation>Vor jeder Sitzung zu fragen</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>How often each condition is shown</source>
        <translation>Wie oft jede Bedingung gezeigt wird</translation>
    </message>
    <message>
        <source>All once in random order, then all again in another one</source>
        <translation>Alle einmal in zufälliger Reihenfolge, dann alle noch einmal in einer anderen</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>B&amp;rowse…</source>
        <translation>Du&amp;rchsuchen…</translation>
    </message>
    <message>
        <source>Browse</source>
        <translation>Durchsuchen</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>&amp;Participant code</source>
        <translation>&amp;Teilnehmercode</translation>
    </message>
    <message>
        <source>&amp;Note on the consent</source>
        <translation>&amp;Notiz zur Einwilligung</translation>
    </message>
    <message>
        <source>&amp;Conditions</source>
        <translation>Be&amp;dingungen</translation>
    </message>
    <message>
        <source>&amp;Each shown</source>
        <translation>&amp;Jede gezeigt</translation>
    </message>
    <message>
        <source>&amp;Folder of the study</source>
        <translation>&amp;Ordner der Studie</translation>
    </message>
    <message>
        <source>The code has 1 to 32 letters, digits, - and _.</source>
        <translation>Der Code hat 1 bis 32 Buchstaben, Ziffern, - und _.</translation>
    </message>
    <message>
        <source>Nothing begins before the participant has agreed.</source>
        <translation>Nichts beginnt, bevor die teilnehmende Person eingewilligt hat.</translation>
    </message>
    <message>
        <source>Note what was agreed to.</source>
        <translation>Notieren Sie, worin eingewilligt wurde.</translation>
    </message>
    <message>
        <source>Choose at least two conditions.</source>
        <translation>Wählen Sie mindestens zwei Bedingungen.</translation>
    </message>
    <message>
        <source>Choose at most 26 conditions: they have letters.</source>
        <translation>Wählen Sie höchstens 26 Bedingungen: sie haben Buchstaben.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Wählen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>Bookmarks, each with its resolution and exaggeration. They are shown in random order, under letters</source>
        <translation>Lesezeichen, jedes mit seiner Auflösung und seiner Überhöhung. Sie werden in zufälliger Reihenfolge unter Buchstaben gezeigt</translation>
    </message>
    <message>
        <source>A study needs at least two bookmarks: Surface &gt; Add bookmark.</source>
        <translation>Eine Studie braucht mindestens zwei Lesezeichen: Oberfläche &gt; Lesezeichen hinzufügen.</translation>
    </message>
</context>
<context>
    <name>relievo::SuggestPanel</name>
    <message>
        <source>Suggest windows</source>
        <translation>Ausschnitte vorschlagen</translation>
    </message>
    <message>
        <source>Show them in the overview</source>
        <translation>In der Übersicht zeigen</translation>
    </message>
    <message>
        <source>Look for windows with relief that a hand feels (Ctrl+Shift+F)</source>
        <translation>Ausschnitte suchen, deren Relief eine Hand fühlt (Strg+Umschalt+F)</translation>
    </message>
    <message>
        <source>Ranked by the share of a window whose relief is higher than what a hand on a grip just feels at that scale: the threshold of a fingertip (Louw, Kappers and Koenderink 2000) times %1, which is an estimate. Steep, filled and missing places do not count.</source>
        <translation>Geordnet nach dem Anteil eines Ausschnitts, dessen Relief höher ist, als eine Hand am Griff bei diesem Maßstab gerade fühlt: die Schwelle einer Fingerspitze (Louw, Kappers und Koenderink 2000) mal %1, was geschätzt ist. Steile, gefüllte und fehlende Stellen zählen nicht.</translation>
    </message>
    <message>
        <source>Suggested windows</source>
        <translation>Vorgeschlagene Ausschnitte</translation>
    </message>
    <message>
        <source>Frames with their ranks over the whole object</source>
        <translation>Rahmen mit ihren Rängen über dem ganzen Objekt</translation>
    </message>
    <message>
        <source>This map is read by tiles; windows are suggested on maps in memory.</source>
        <translation>Diese Karte wird kachelweise gelesen; Ausschnitte werden auf Karten im Speicher vorgeschlagen.</translation>
    </message>
    <message>
        <source>%1 % measured, %2 % steep</source>
        <translation>%1 % gemessen, %2 % steil</translation>
    </message>
    <message>
        <source>No window has relief that stands out from what a hand just feels.</source>
        <translation>Kein Ausschnitt hat ein Relief, das über das gerade Fühlbare hinausgeht.</translation>
    </message>
    <message>
        <source>Suggested window %1</source>
        <translation>Vorgeschlagener Ausschnitt %1</translation>
    </message>
    <message>
        <source>Windows: %1, the best first</source>
        <translation>Ausschnitte: %1, der beste zuerst</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was suggested.</source>
        <translation>Abgebrochen. Nichts wurde vorgeschlagen.</translation>
    </message>
    <message>
        <source>A click or Enter shows the window at its resolution; undo goes back</source>
        <translation>Ein Klick oder Eingabe zeigt den Ausschnitt mit seiner Auflösung; Rückgängig führt zurück</translation>
    </message>
    <message>
        <source>%1. Resolution %2 of %3, %4: %5 % felt, relief about %6 wide</source>
        <translation>%1. Auflösung %2 von %3, %4: %5 % fühlbar, Relief etwa %6 breit</translation>
    </message>
</context>
<context>
    <name>relievo::SurfaceChoices</name>
    <message>
        <source>View %1 → %2</source>
        <translation>Ansicht %1 → %2</translation>
    </message>
    <message>
        <source>Depth method → %1</source>
        <translation>Verfahren → %1</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Unit %1 → %2</source>
        <translation>Einheit %1 → %2</translation>
    </message>
    <message>
        <source>Keep far-off points</source>
        <translation>Weit entfernte Punkte behalten</translation>
    </message>
    <message>
        <source>Leave out far-off groups</source>
        <translation>Weit entfernte Gruppen weglassen</translation>
    </message>
    <message>
        <source>Leave out far-off points</source>
        <translation>Weit entfernte Punkte weglassen</translation>
    </message>
    <message>
        <source>Take heights as missing</source>
        <translation>Höhen als fehlend nehmen</translation>
    </message>
    <message>
        <source>Keep all heights</source>
        <translation>Alle Höhen behalten</translation>
    </message>
    <message>
        <source>Size of the samples</source>
        <translation>Größe der Abtastwerte</translation>
    </message>
    <message>
        <source>Turn the relief</source>
        <translation>Relief drehen</translation>
    </message>
</context>
<context>
    <name>relievo::SurfaceController</name>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>Whole object</source>
        <translation>Ganzes Objekt</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>This is the whole object</source>
        <translation>Das ist das ganze Objekt</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>%1. Window at %2, %3 mm</source>
        <translation>%1. Ausschnitt bei %2, %3 mm</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>undo, step</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Resolution %1 of %2</source>
        <translation>Auflösung %1 von %2</translation>
    </message>
    <message>
        <source>This is the finest resolution</source>
        <translation>Das ist die feinste Auflösung</translation>
    </message>
</context>
<context>
    <name>relievo::SurfacePanel</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>E&amp;inheit</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>Längeneinheit der Koordinaten in der Datei</translation>
    </message>
    <message>
        <source>%1 × %2, %3 apart</source>
        <translation>%1 × %2, Abstand %3</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates (%1)</source>
        <translation>Längeneinheit der Koordinaten in der Datei (%1)</translation>
    </message>
    <message>
        <source>on the base plane</source>
        <translation>auf der Grundebene</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpoliert</translation>
    </message>
    <message>
        <source>left open</source>
        <translation>offen gelassen</translation>
    </message>
    <message>
        <source>not counted; %1 % of the cells on the base plane, %2 % interpolated</source>
        <translation>nicht gezählt; %1 % der Zellen auf der Grundebene, %2 % interpoliert</translation>
    </message>
</context>
<context>
    <name>relievo::TiledMapDialog</name>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>LAS, LAZ or binary PLY files and folders of them, which are one scan, or one height raster</source>
        <translation>LAS-, LAZ- oder binäre PLY-Dateien und Ordner davon, die ein Scan sind, oder ein Höhenraster</translation>
    </message>
    <message>
        <source>F&amp;iles…</source>
        <translation>Da&amp;teien…</translation>
    </message>
    <message>
        <source>Take files into the list</source>
        <translation>Dateien in die Liste aufnehmen</translation>
    </message>
    <message>
        <source>Fo&amp;lder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Take all LAS, LAZ and PLY files of a folder</source>
        <translation>Alle LAS-, LAZ- und PLY-Dateien eines Ordners aufnehmen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the chosen entries from the list</source>
        <translation>Die gewählten Einträge aus der Liste nehmen</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Where the finest level is written; the others lie beside it</source>
        <translation>Wohin die feinste Ebene geschrieben wird; die anderen liegen daneben</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>Length unit of the file&apos;s coordinates</source>
        <translation>Längeneinheit der Koordinaten in der Datei</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>From which side the object is seen</source>
        <translation>Von welcher Seite das Objekt gesehen wird</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>What the work may take beside the program itself</source>
        <translation>Was die Arbeit neben dem Programm selbst belegen darf</translation>
    </message>
    <message>
        <source>Cores</source>
        <translation>Rechenkerne</translation>
    </message>
    <message>
        <source>How many work at once</source>
        <translation>Wie viele gleichzeitig arbeiten</translation>
    </message>
    <message>
        <source>&amp;Keep what is finished, to go on after a stop</source>
        <translation>Fertiges &amp;behalten, um nach einem Abbruch weiterzumachen</translation>
    </message>
    <message>
        <source>Keep what is finished, to go on after a stop</source>
        <translation>Fertiges behalten, um nach einem Abbruch weiterzumachen</translation>
    </message>
    <message>
        <source>In a folder beside the map, until the map is made</source>
        <translation>In einem Ordner neben der Karte, bis die Karte gemacht ist</translation>
    </message>
    <message>
        <source>&amp;Open the map when it is made</source>
        <translation>Karte ö&amp;ffnen, wenn sie gemacht ist</translation>
    </message>
    <message>
        <source>Open the map when it is made</source>
        <translation>Karte öffnen, wenn sie gemacht ist</translation>
    </message>
    <message>
        <source>In the place of what is open</source>
        <translation>Anstelle dessen, was offen ist</translation>
    </message>
    <message>
        <source>What is ready</source>
        <translation>Was fertig ist</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>Aus der Datei</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Map by tiles</source>
        <translation>Karte in Kacheln</translation>
    </message>
    <message>
        <source>Scans and height rasters (*.las *.laz *.ply *.tif *.tiff *.asc *.png);;All files (*)</source>
        <translation>Scans und Höhenraster (*.las *.laz *.ply *.tif *.tiff *.asc *.png);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Karte</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>E&amp;inheit der Datei</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>A&amp;nsicht</translation>
    </message>
    <message>
        <source>M&amp;emory</source>
        <translation>S&amp;peicher</translation>
    </message>
    <message>
        <source>What is ready of the map</source>
        <translation>Was von der Karte fertig ist</translation>
    </message>
    <message>
        <source>While the map is made, what is ready of it is shown here.</source>
        <translation>Während die Karte gemacht wird, steht hier, was von ihr fertig ist.</translation>
    </message>
    <message>
        <source>M&amp;ake</source>
        <translation>Karte &amp;machen</translation>
    </message>
    <message>
        <source>Make the map</source>
        <translation>Die Karte machen</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif)</source>
        <translation>GeoTIFF (*.tif)</translation>
    </message>
    <message>
        <source>Nothing of it can be seen yet.</source>
        <translation>Noch ist nichts von ihr zu sehen.</translation>
    </message>
    <message>
        <source>Sca&amp;n</source>
        <translation>&amp;Scan</translation>
    </message>
    <message>
        <source>&amp;Cores</source>
        <translation>&amp;Rechenkerne</translation>
    </message>
</context>
<context>
    <name>relievo::TilesController</name>
    <message>
        <source>about %1 s left of it</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min left of it</source>
        <translation>noch etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h left of it</source>
        <translation>noch etwa %1 h</translation>
    </message>
    <message>
        <source>From a sample of the points: %1 × %2 cells of %3, %4 high.</source>
        <translation>Aus einer Stichprobe der Punkte: %1 × %2 Zellen von %3, %4 hoch.</translation>
    </message>
    <message>
        <source>Cancelled. No map was made.</source>
        <translation>Abgebrochen. Es wurde keine Karte gemacht.</translation>
    </message>
    <message>
        <source>Cancelled. No map was made; what was finished is kept in %1, and the same choices go on there.</source>
        <translation>Abgebrochen. Es wurde keine Karte gemacht; was fertig war, liegt in %1, und mit derselben Auswahl geht es dort weiter.</translation>
    </message>
    <message>
        <source>%1 is made: %2 × %3 cells, %4 levels.</source>
        <translation>%1 ist gemacht: %2 × %3 Zellen, %4 Ebenen.</translation>
    </message>
    <message>
        <source>All heights of %1 × %2 cells are there; gaps are looked for.</source>
        <translation>Alle Höhen von %1 × %2 Zellen sind da; Lücken werden gesucht.</translation>
    </message>
    <message>
        <source>%1 of %2 rows have their heights, from below; the rest is from a sample of the points.</source>
        <translation>%1 von %2 Zeilen haben ihre Höhen, von unten an; der Rest ist aus einer Stichprobe der Punkte.</translation>
    </message>
</context>
<context>
    <name>relievo::TimePlot</name>
    <message>
        <source>Height of hand and proxy over the last ten seconds</source>
        <translation>Höhe von Hand und Proxy in den letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>Force over the last ten seconds</source>
        <translation>Kraft in den letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Plots of height and force</source>
        <translation>Kurven von Höhe und Kraft</translation>
    </message>
</context>
<context>
    <name>relievo::TouchActions</name>
    <message>
        <source>&amp;Forces on</source>
        <translation>Kräfte &amp;an</translation>
    </message>
    <message>
        <source>Switch forces on or off (F5)</source>
        <translation>Kräfte ein- oder ausschalten (F5)</translation>
    </message>
    <message>
        <source>Forces come on gently, once the hand is clear of the surface.</source>
        <translation>Die Kräfte setzen sanft ein, sobald die Hand von der Oberfläche frei ist.</translation>
    </message>
    <message>
        <source>Forces &amp;off now</source>
        <translation>&amp;Kräfte sofort aus</translation>
    </message>
    <message>
        <source>Switch forces off (Esc)</source>
        <translation>Kräfte ausschalten (Esc)</translation>
    </message>
    <message>
        <source>Escape always stops the forces first.</source>
        <translation>Esc hält immer zuerst die Kräfte an.</translation>
    </message>
    <message>
        <source>&amp;Stronger</source>
        <translation>S&amp;tärker</translation>
    </message>
    <message>
        <source>Raise the strength of all forces by 10 %</source>
        <translation>Die Stärke aller Kräfte um 10 % erhöhen</translation>
    </message>
    <message>
        <source>Strength multiplies every force; the limit stays.</source>
        <translation>Die Stärke vervielfacht jede Kraft; die Grenze bleibt.</translation>
    </message>
    <message>
        <source>&amp;Weaker</source>
        <translation>&amp;Schwächer</translation>
    </message>
    <message>
        <source>Lower the strength of all forces by 10 %</source>
        <translation>Die Stärke aller Kräfte um 10 % senken</translation>
    </message>
    <message>
        <source>De&amp;vice set-up…</source>
        <translation>&amp;Gerät einrichten…</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufzeichnen</translation>
    </message>
    <message>
        <source>Start or stop recording every sample (Ctrl+R)</source>
        <translation>Das Aufzeichnen jedes Werts beginnen oder beenden (Strg+R)</translation>
    </message>
    <message>
        <source>Writes hand, proxy and force, 1000 times a second, to a table in your documents folder.</source>
        <translation>Schreibt Hand, Proxy und Kraft, 1000-mal je Sekunde, in eine Tabelle in Ihrem Dokumentenordner.</translation>
    </message>
    <message>
        <source>&amp;Use the mouse</source>
        <translation>Die &amp;Maus benutzen</translation>
    </message>
    <message>
        <source>Let the mouse be the hand</source>
        <translation>Die Maus zur Hand machen</translation>
    </message>
    <message>
        <source>Lets go of a Falcon, whether it is ready or still starting or homing.</source>
        <translation>Lässt einen Falcon los, ob er bereit ist oder noch startet oder seine Referenzfahrt macht.</translation>
    </message>
    <message>
        <source>&amp;Move mode</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Begin Move mode, or confirm and leave it (Ctrl+Shift+M)</source>
        <translation>Den Modus Verschieben beginnen, oder bestätigen und verlassen (Strg+Umschalt+M)</translation>
    </message>
    <message>
        <source>Pushing the grip to a side moves the window there, one click per quarter.</source>
        <translation>Wer den Griff zu einer Seite drückt, verschiebt den Ausschnitt dorthin, einen Klick je Viertel.</translation>
    </message>
    <message>
        <source>&amp;Back to the old window</source>
        <translation>&amp;Zurück zum alten Ausschnitt</translation>
    </message>
    <message>
        <source>Leave Move mode and go back to where it began</source>
        <translation>Den Modus Verschieben verlassen und dorthin zurückgehen, wo er begann</translation>
    </message>
    <message>
        <source>The device&apos;s button Centre does the same in Move mode.</source>
        <translation>Der mittlere Knopf des Geräts tut im Modus Verschieben dasselbe.</translation>
    </message>
    <message>
        <source>Where am &amp;I</source>
        <translation>&amp;Wo bin ich</translation>
    </message>
    <message>
        <source>Say where the hand is (Ctrl+I)</source>
        <translation>Sagen, wo die Hand ist (Strg+I)</translation>
    </message>
    <message>
        <source>Place and height under the hand, and whether it was measured.</source>
        <translation>Ort und Höhe unter der Hand, und ob dort gemessen wurde.</translation>
    </message>
    <message>
        <source>How large the window is and what one millimetre of hand is.</source>
        <translation>Wie groß der Ausschnitt ist und was ein Millimeter der Hand ist.</translation>
    </message>
    <message>
        <source>Button &amp;help</source>
        <translation>&amp;Hilfe zu den Knöpfen</translation>
    </message>
    <message>
        <source>Say what the device&apos;s buttons do now</source>
        <translation>Sagen, was die Knöpfe des Geräts jetzt tun</translation>
    </message>
    <message>
        <source>It differs in Move mode and while scanning with one button.</source>
        <translation>Beim Verschieben und bei der Auswahl mit einem Knopf ist es etwas anderes.</translation>
    </message>
    <message>
        <source>Add &amp;note…</source>
        <translation>&amp;Notiz hinzufügen…</translation>
    </message>
    <message>
        <source>Write a note into the running recording (Ctrl+Shift+N)</source>
        <translation>Eine Notiz in die laufende Aufzeichnung schreiben (Strg+Umschalt+N)</translation>
    </message>
    <message>
        <source>It belongs to the moment at which this is chosen; the recording goes on while you write.</source>
        <translation>Sie gehört zu dem Augenblick, in dem dies gewählt wird; die Aufzeichnung läuft beim Schreiben weiter.</translation>
    </message>
    <message>
        <source>Wh&amp;ere am I, in full</source>
        <translation>Wo bin ich, ausführ&amp;lich</translation>
    </message>
    <message>
        <source>Also the distances from the object&apos;s edges, and how fine the shown samples are.</source>
        <translation>Auch die Abstände von den Rändern des Objekts, und wie fein die gezeigten Abtastwerte sind.</translation>
    </message>
    <message>
        <source>&amp;Guide along the outline</source>
        <translation>Am Um&amp;riss entlangführen</translation>
    </message>
    <message>
        <source>Lead the hand along the nearest outline, or let go (Ctrl+Alt+G)</source>
        <translation>Die Hand am nächsten Umriss entlangführen oder loslassen (Strg+Alt+G)</translation>
    </message>
    <message>
        <source>Of a raised or sunken area, or of the object; with 2 N at most. Push against it or press any button, and it lets go.</source>
        <translation>Einer Erhebung, einer Vertiefung oder des Objekts; mit höchstens 2 N. Drücken Sie dagegen oder drücken Sie einen Knopf, und sie lässt los.</translation>
    </message>
    <message>
        <source>Guide along a re&amp;cording…</source>
        <translation>Wie in einer Auf&amp;nahme führen…</translation>
    </message>
    <message>
        <source>Lead the hand as somebody&apos;s hand went in a recording or stroke</source>
        <translation>Die Hand so führen, wie eine Hand in einer Aufnahme oder einem Handweg ging</translation>
    </message>
    <message>
        <source>At that hand&apos;s own speed, 15 to 60 mm/s, and with its rests.</source>
        <translation>Mit der Geschwindigkeit jener Hand, 15 bis 60 mm/s, und mit ihren Pausen.</translation>
    </message>
    <message>
        <source>Five shapes to find under the hand, in two minutes (Ctrl+Alt+U)</source>
        <translation>Fünf Formen unter der Hand finden, in zwei Minuten (Strg+Alt+U)</translation>
    </message>
    <message>
        <source>A plate, a bump, a step, waves and a groove take the place of the relief; each task is said, and each can be passed over.</source>
        <translation>Eine Platte, ein Buckel, eine Stufe, Wellen und eine Rille kommen an die Stelle des Reliefs; jede Aufgabe wird gesagt, und jede kann übergangen werden.</translation>
    </message>
    <message>
        <source>Ne&amp;xt shape</source>
        <translation>Nä&amp;chste Form</translation>
    </message>
    <message>
        <source>Go on to the introduction&apos;s next shape (Ctrl+Alt+N)</source>
        <translation>Zur nächsten Form der Einführung weitergehen (Strg+Alt+N)</translation>
    </message>
    <message>
        <source>The device&apos;s button Forward does the same in the introduction.</source>
        <translation>Der Knopf Vorwärts des Geräts tut in der Einführung dasselbe.</translation>
    </message>
    <message>
        <source>I&amp;ntroduction to touch</source>
        <translation>E&amp;inführung ins Fühlen</translation>
    </message>
    <message>
        <source>G&amp;amepads rumble</source>
        <translation>Gamepads vi&amp;brieren</translation>
    </message>
    <message>
        <source>Let gamepads rumble at contact and edge: a cue, no force</source>
        <translation>Gamepads bei Berührung und am Rand vibrieren lassen: ein Hinweis, keine Kraft</translation>
    </message>
    <message>
        <source>A knock when the hand meets the surface, and a soft hum at the edge of the window. The panel Buttons has the same switch.</source>
        <translation>Ein Klopfen, wenn die Hand die Oberfläche trifft, und ein leises Brummen am Rand des Ausschnitts. Das Feld Knöpfe am Gerät hat denselben Schalter.</translation>
    </message>
    <message>
        <source>Ta&amp;ke the forces back</source>
        <translation>Kräfte zurückh&amp;olen</translation>
    </message>
    <message>
        <source>Open a device again that took its forces away (Shift+F5)</source>
        <translation>Ein Gerät wieder öffnen, das seine Kräfte weggenommen hat (Umschalt+F5)</translation>
    </message>
    <message>
        <source>The device is closed and opened; its forces rise from zero once the hand is clear of the surface.</source>
        <translation>Das Gerät wird geschlossen und geöffnet; seine Kräfte steigen von null an, sobald die Hand von der Oberfläche frei ist.</translation>
    </message>
    <message>
        <source>Pla&amp;y sounds of touch</source>
        <translation>Klänge beim &amp;Fühlen</translation>
    </message>
    <message>
        <source>Hear what the hand meets, while it touches (Ctrl+Alt+A)</source>
        <translation>Hören, worauf die Hand trifft, während sie fühlt (Ctrl+Alt+A)</translation>
    </message>
    <message>
        <source>A click at contact, a rustle while sliding, a tone that is higher where the surface is; the edge and filled ground. The tone ends after two minutes.</source>
        <translation>Ein Klick bei Berührung, ein Rauschen beim Gleiten, ein Ton, der höher ist, wo die Oberfläche höher ist; der Rand und gefüllter Grund. Der Ton endet nach zwei Minuten.</translation>
    </message>
    <message>
        <source>Ma&amp;ke sounds louder</source>
        <translation>Klänge lauter (&amp;X)</translation>
    </message>
    <message>
        <source>Make the sounds of touch louder (Ctrl+Alt+Page Up)</source>
        <translation>Die Klänge beim Fühlen lauter machen (Ctrl+Alt+Bild auf)</translation>
    </message>
    <message>
        <source>Speech has a volume of its own.</source>
        <translation>Die Sprache hat eine eigene Lautstärke.</translation>
    </message>
    <message>
        <source>Sounds &amp;quieter</source>
        <translation>Klänge leiser (&amp;Y)</translation>
    </message>
    <message>
        <source>Make the sounds of touch quieter (Ctrl+Alt+Page Down)</source>
        <translation>Die Klänge beim Fühlen leiser machen (Ctrl+Alt+Bild ab)</translation>
    </message>
    <message>
        <source>Felt &amp;patterns</source>
        <translation>Tastzeichen (&amp;Q)</translation>
    </message>
    <message>
        <source>Taps of the grip say what sounds say, for who does not hear them</source>
        <translation>Stöße des Griffs sagen, was Klänge sagen, für alle, die sie nicht hören</translation>
    </message>
    <message>
        <source>One tap: yes. Two: not measured. Three: the edge. Only while forces are on.</source>
        <translation>Ein Stoß: ja. Zwei: nicht gemessen. Drei: der Rand. Nur solange Kräfte an sind.</translation>
    </message>
    <message>
        <source>Set up a Falcon or a Haply device, step by step</source>
        <translation>Einen Falcon oder ein Haply-Gerät Schritt für Schritt einrichten</translation>
    </message>
    <message>
        <source>From plug to touch. A Falcon: access, firmware, homing, self test, force by a known weight, left or right hand. Haply: service, power, calibration, buttons.</source>
        <translation>Vom Stecker zum Fühlen. Ein Falcon: Zugang, Firmware, Referenzfahrt, Selbsttest, Kraft an einem bekannten Gewicht, linke oder rechte Hand. Haply: Dienst, Strom, Kalibrieren, Tasten.</translation>
    </message>
    <message>
        <source>Next strength &amp;preset</source>
        <translation>Nächste Stärkest&amp;ufe</translation>
    </message>
    <message>
        <source>Gentle, medium and full strength, one after another (Ctrl+Alt+F)</source>
        <translation>Sanfte, mittlere und volle Stärke, eine nach der anderen (Strg+Alt+F)</translation>
    </message>
    <message>
        <source>The panel Touch has the same choice, and every strength between.</source>
        <translation>Das Feld Fühlen hat dieselbe Auswahl und jede Stärke dazwischen.</translation>
    </message>
    <message>
        <source>Next grip posi&amp;tion</source>
        <translation>Nächst&amp;e Griffposition</translation>
    </message>
    <message>
        <source>How the device stands: upright, flat, at the left or the right, one after another (Ctrl+Alt+H)</source>
        <translation>Wie das Gerät steht: aufrecht, liegend, links oder rechts, eins nach dem anderen (Strg+Alt+H)</translation>
    </message>
    <message>
        <source>Which way the grip is pushed to press into the relief. Forces go off first.</source>
        <translation>Wohin der Griff gedrückt wird, um ins Relief zu drücken. Vorher gehen die Kräfte aus.</translation>
    </message>
    <message>
        <source>Say where the hand is, with edges, resolution and scale (Ctrl+Alt+I)</source>
        <translation>Sagt, wo die Hand ist, mit Rändern, Auflösung und Maßstab (Strg+Alt+I)</translation>
    </message>
    <message>
        <source>Say resolution, window and hand scale (Ctrl+Shift+I)</source>
        <translation>Auflösung, Ausschnitt und Maßstab der Hand sagen (Strg+Umschalt+I)</translation>
    </message>
    <message>
        <source>Resolution an&amp;d scale</source>
        <translation>Auflösung un&amp;d Maßstab</translation>
    </message>
</context>
<context>
    <name>relievo::TouchController</name>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpoliert</translation>
    </message>
    <message>
        <source>hole, on base plane</source>
        <translation>Loch, auf Grundebene</translation>
    </message>
    <message>
        <source>steep</source>
        <translation>steil</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>Press depth %1 mm of hand</source>
        <translation>Eindrücktiefe %1 mm der Hand</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3 mm</source>
        <translation>x %1  y %2  z %3 mm</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Force when it was recorded</source>
        <translation>Kraft bei der Aufzeichnung</translation>
    </message>
    <message>
        <source>replay %1</source>
        <translation>Wiedergabe %1</translation>
    </message>
    <message>
        <source>%1/%2 N</source>
        <translation>%1/%2 N</translation>
    </message>
    <message>
        <source>forces off</source>
        <translation>Kräfte aus</translation>
    </message>
    <message>
        <source>Force on the hand and its limit</source>
        <translation>Kraft auf die Hand und ihre Grenze</translation>
    </message>
    <message>
        <source>Press F5 to switch forces on</source>
        <translation>F5 schaltet die Kräfte ein</translation>
    </message>
    <message>
        <source>Forces are on: the replay was closed.</source>
        <translation>Die Kräfte sind an: die Wiedergabe wurde geschlossen.</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Gerät: %1</translation>
    </message>
    <message>
        <source>Worst period: %1 ms</source>
        <translation>Längste Periode: %1 ms</translation>
    </message>
    <message>
        <source>Real-time priority</source>
        <translation>Echtzeitpriorität</translation>
    </message>
    <message>
        <source>No real-time priority: %1</source>
        <translation>Keine Echtzeitpriorität: %1</translation>
    </message>
    <message>
        <source>%1/s, late %2</source>
        <translation>%1/s, verspätet %2</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Touch is not available: %1 Viewing works.</source>
        <translation>Fühlen ist nicht möglich: %1 Sehen geht.</translation>
    </message>
    <message>
        <source>Nothing is open. Open a scan with Ctrl+O.</source>
        <translation>Nichts ist geöffnet. Öffnen Sie einen Scan mit Strg+O.</translation>
    </message>
    <message>
        <source>%1, %2. Resolution %3 of %4</source>
        <translation>%1, %2. Auflösung %3 von %4</translation>
    </message>
    <message>
        <source>%1, %2 by %3 mm, in %4 resolutions. Push the hand in to touch; F5 switches forces on. Plus: finer; Minus: coarser; both for two seconds: help.</source>
        <translation>%1, %2 mal %3 mm, in %4 Auflösungen. Zum Fühlen die Hand eindrücken; F5 schaltet die Kräfte ein. Plus: feiner; Minus: gröber; beide zwei Sekunden lang: Hilfe.</translation>
    </message>
</context>
<context>
    <name>relievo::TouchGuide</name>
    <message>
        <source>The recorded way leaves the shown window. Go to where it was recorded.</source>
        <translation>Der aufgezeichnete Weg verlässt den gezeigten Ausschnitt. Gehen Sie dorthin, wo er aufgezeichnet wurde.</translation>
    </message>
</context>
<context>
    <name>relievo::TouchedSurface</name>
    <message>
        <source>Stiffness map: %1.</source>
        <translation>Steifigkeitskarte: %1.</translation>
    </message>
    <message>
        <source>Stiffness map: %1. Set Not measured below 100 % to feel it.</source>
        <translation>Steifigkeitskarte: %1. Stellen Sie „Nicht gemessen“ unter 100 %, um sie zu fühlen.</translation>
    </message>
    <message>
        <source>The surface is stiff where it was measured.</source>
        <translation>Die Oberfläche ist steif, wo gemessen wurde.</translation>
    </message>
</context>
<context>
    <name>relievo::VideoControl</name>
    <message>
        <source>Video saved: %1 s, %2 frames in %3</source>
        <translation>Video gespeichert: %1 s, %2 Bilder in %3</translation>
    </message>
    <message>
        <source>Cancelled. No video was kept.</source>
        <translation>Abgebrochen. Kein Video wurde behalten.</translation>
    </message>
    <message>
        <source>Video saved: %1 s, %2 pictures dropped, in %3</source>
        <translation>Video gespeichert: %1 s, %2 Bilder ausgelassen, in %3</translation>
    </message>
    <message>
        <source>The video has ended early</source>
        <translation>Das Video endete vorzeitig</translation>
    </message>
    <message>
        <source>The video has no sound.</source>
        <translation>Das Video hat keinen Ton.</translation>
    </message>
</context>
<context>
    <name>relievo::VideoController</name>
    <message>
        <source>End of the camera path</source>
        <translation>Ende des Kamerawegs</translation>
    </message>
    <message>
        <source>The camera path is empty</source>
        <translation>Der Kameraweg ist leer</translation>
    </message>
    <message>
        <source>The program ffmpeg is not installed: a folder of pictures can be made.</source>
        <translation>Das Programm ffmpeg ist nicht installiert: ein Ordner mit Bildern ist möglich.</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>A folder of pictures (*)</source>
        <translation>Ein Ordner mit Bildern (*)</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>Videos (*.mp4)</translation>
    </message>
    <message>
        <source>Video to %1</source>
        <translation>Video in %1</translation>
    </message>
    <message>
        <source>The program ffmpeg, which packs videos, is not installed. Nothing was made. Install the package ffmpeg, or keep a folder of pictures.</source>
        <translation>Das Programm ffmpeg, das Videos packt, ist nicht installiert. Nichts wurde gemacht. Installieren Sie das Paket ffmpeg, oder behalten Sie einen Ordner mit Bildern.</translation>
    </message>
    <message>
        <source>&amp;Keep pictures</source>
        <translation>&amp;Bilder behalten</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>Kameraweg</translation>
    </message>
    <message>
        <source>Key view %1 at %2 s</source>
        <translation>Kamerapunkt %1 bei %2 s</translation>
    </message>
</context>
<context>
    <name>relievo::VideoDialog</name>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Für</translation>
    </message>
    <message>
        <source>How the pictures are packed: small, or without loss</source>
        <translation>Wie die Bilder gepackt werden: klein oder ohne Verlust</translation>
    </message>
    <message>
        <source>Talk: plays everywhere</source>
        <translation>Vortrag: läuft überall</translation>
    </message>
    <message>
        <source>Archive: every pixel comes back</source>
        <translation>Archiv: jedes Pixel kommt zurück</translation>
    </message>
    <message>
        <source>Anaglyph: for red and cyan glasses</source>
        <translation>Anaglyphe: für rot-cyane Brillen</translation>
    </message>
    <message>
        <source>Images: a folder of pictures</source>
        <translation>Bilder: ein Ordner mit Bildern</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Of each picture, in pixels</source>
        <translation>Jedes Bildes, in Pixeln</translation>
    </message>
    <message>
        <source>As the detail view: %1 × %2</source>
        <translation>Wie die Detailansicht: %1 × %2</translation>
    </message>
    <message>
        <source>&amp;Pictures a second</source>
        <translation>&amp;Bilder je Sekunde</translation>
    </message>
    <message>
        <source>30 look smooth; 24 to 60 are usual</source>
        <translation>30 wirken flüssig; üblich sind 24 bis 60</translation>
    </message>
    <message>
        <source>&amp;Choose file…</source>
        <translation>&amp;Datei wählen…</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>1 as it was; 0.25 four times slower</source>
        <translation>1 wie es war; 0,25 viermal langsamer</translation>
    </message>
    <message>
        <source>F&amp;rom</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>Where it begins, since the start of recording or path</source>
        <translation>Wo es beginnt, seit Anfang von Aufzeichnung oder Weg</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>B&amp;is</translation>
    </message>
    <message>
        <source>Where it ends, since the start of recording or path</source>
        <translation>Wo es endet, seit Anfang von Aufzeichnung oder Weg</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation>&amp;Kurven</translation>
    </message>
    <message>
        <source>Height of hand and proxy, and the force, below</source>
        <translation>Höhe von Hand und Proxy, und die Kraft, darunter</translation>
    </message>
    <message>
        <source>&amp;Whole object</source>
        <translation>Ganzes &amp;Objekt</translation>
    </message>
    <message>
        <source>The whole object with the pink window, beside the detail</source>
        <translation>Das ganze Objekt mit dem rosa Ausschnitt, neben dem Detail</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>How long a millimetre is in the detail</source>
        <translation>Wie lang ein Millimeter im Detail ist</translation>
    </message>
    <message>
        <source>Along the camera pat&amp;h</source>
        <translation>Entlang des Kamera&amp;wegs</translation>
    </message>
    <message>
        <source>The camera passes the key views; else it looks at the recorded window</source>
        <translation>Die Kamera durchläuft die Kamerapunkte; sonst blickt sie auf den aufgezeichneten Ausschnitt</translation>
    </message>
    <message>
        <source>Stere&amp;o</source>
        <translation>&amp;Stereo</translation>
    </message>
    <message>
        <source>Red and cyan pictures; not for talks, whose colours are halved</source>
        <translation>Rot-cyane Bilder; nicht für Vorträge, deren Farben halbiert werden</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Half colour</source>
        <translation>Halbfarbig</translation>
    </message>
    <message>
        <source>Dubois</source>
        <translation>Dubois</translation>
    </message>
    <message>
        <source>Eye sep&amp;aration</source>
        <translation>&amp;Augenabstand</translation>
    </message>
    <message>
        <source>Angle between the two eyes&apos; directions</source>
        <translation>Winkel zwischen den Blickrichtungen beider Augen</translation>
    </message>
    <message>
        <source>Swap e&amp;yes</source>
        <translation>Augen ta&amp;uschen</translation>
    </message>
    <message>
        <source>For glasses whose red filter is at the right eye</source>
        <translation>Für Brillen mit dem roten Filter am rechten Auge</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>Zeilenweise</translation>
    </message>
    <message>
        <source>Both eyes as f&amp;iles</source>
        <translation>Beide Augen als Dateie&amp;n</translation>
    </message>
    <message>
        <source>Also each eye&apos;s video as a file of its own: NAME.left.mp4 and NAME.right.mp4</source>
        <translation>Auch das Video jedes Auges als eigene Datei: NAME.left.mp4 und NAME.right.mp4</translation>
    </message>
    <message>
        <source>So&amp;und</source>
        <translation>K&amp;länge</translation>
    </message>
    <message>
        <source>What the hand met, at its time: clicks, rustling and the tone of heights; a folder of pictures has none</source>
        <translation>Was die Hand antraf, zu seiner Zeit: Klicken, Rauschen und der Ton der Höhen; ein Ordner mit Bildern hat keine</translation>
    </message>
</context>
<context>
    <name>relievo::ViewPanel</name>
    <message>
        <source>Seen from</source>
        <translation>Gesehen von</translation>
    </message>
    <message>
        <source>Look from this side (Alt+%1)</source>
        <translation>Von dieser Seite sehen (Alt+%1)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Look from the side that shows most</source>
        <translation>Von der Seite sehen, die am meisten zeigt</translation>
    </message>
    <message>
        <source>Use this view</source>
        <translation>Diese Ansicht nehmen</translation>
    </message>
    <message>
        <source>Make the depth map from where the turned detail view looks</source>
        <translation>Die Tiefenkarte aus der Richtung der gedrehten Detailansicht machen</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Gerade richten</translation>
    </message>
    <message>
        <source>Look straight down on the relief again</source>
        <translation>Wieder gerade auf das Relief sehen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Direction of the light</source>
        <translation>Richtung des Lichts</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is above, clockwise</source>
        <translation>Woher das Licht kommt: 0 ist oben, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Height of the light</source>
        <translation>Höhe des Lichts</translation>
    </message>
    <message>
        <source>Low light brings out worn detail</source>
        <translation>Streiflicht zeigt abgenutzte Einzelheiten</translation>
    </message>
    <message>
        <source>Light from %1°, %2° high</source>
        <translation>Licht von %1°, %2° hoch</translation>
    </message>
    <message>
        <source>Seen from: %1</source>
        <translation>Gesehen von: %1</translation>
    </message>
    <message>
        <source>Shading of colours</source>
        <translation>Schattierung der Farben</translation>
    </message>
    <message>
        <source>How much relief shading the scan&apos;s own colours get: 0 is as photographed</source>
        <translation>Wie stark die eigenen Farben des Scans schattiert werden: 0 ist wie fotografiert</translation>
    </message>
    <message>
        <source>Only natural colours and intensity are mixed with relief shading</source>
        <translation>Nur natürliche Farben und Intensität werden mit Schattierung gemischt</translation>
    </message>
    <message>
        <source>Shading of colours: %1 %</source>
        <translation>Schattierung der Farben: %1 %</translation>
    </message>
</context>
<context>
    <name>relievo::VoicePanel</name>
    <message>
        <source>Words a minute</source>
        <translation>Wörter je Minute</translation>
    </message>
    <message>
        <source>Volume of speech, percent</source>
        <translation>Lautstärke der Sprache, Prozent</translation>
    </message>
    <message>
        <source>Try the voice</source>
        <translation>Stimme probieren</translation>
    </message>
    <message>
        <source>Say it again</source>
        <translation>Noch einmal sagen</translation>
    </message>
    <message>
        <source>Who says what the hand meets</source>
        <translation>Wer sagt, was die Hand trifft</translation>
    </message>
    <message>
        <source>With a voice of its own, the program says what the hand meets and what commands find, and the screen reader is not told the same.</source>
        <translation>Mit einer eigenen Stimme sagt das Programm, was die Hand trifft und was Befehle ergeben; dem Vorleseprogramm wird nicht dasselbe gesagt.</translation>
    </message>
    <message>
        <source>The screen reader</source>
        <translation>Das Vorleseprogramm</translation>
    </message>
    <message>
        <source>A voice of its own</source>
        <translation>Eine eigene Stimme</translation>
    </message>
    <message>
        <source>Language of the voice</source>
        <translation>Sprache der Stimme</translation>
    </message>
    <message>
        <source>As the window</source>
        <translation>Wie das Fenster</translation>
    </message>
    <message>
        <source>Exact with espeak-ng; other synthesizers have a scale of their own.</source>
        <translation>Genau mit espeak-ng; andere Synthesizer haben eine eigene Skala.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Say again what was said last (Ctrl+Alt+S)</source>
        <translation>Sagt noch einmal, was zuletzt gesagt wurde (Strg+Alt+S)</translation>
    </message>
    <message>
        <source>Spoken by</source>
        <translation>Gesprochen von</translation>
    </message>
    <message>
        <source>Spoken language</source>
        <translation>Gesprochene Sprache</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Speech Dispatcher speaks.</source>
        <translation>Speech Dispatcher spricht.</translation>
    </message>
    <message>
        <source>espeak-ng speaks; Speech Dispatcher does not answer.</source>
        <translation>espeak-ng spricht; Speech Dispatcher antwortet nicht.</translation>
    </message>
    <message>
        <source>No voice can be heard.</source>
        <translation>Keine Stimme ist zu hören.</translation>
    </message>
    <message>
        <source>The program has no voice of its own now.</source>
        <translation>Das Programm hat jetzt keine eigene Stimme.</translation>
    </message>
</context>
<context>
    <name>relievo::VoicePlugin</name>
    <message>
        <source>Voice</source>
        <translation>Stimme</translation>
    </message>
    <message>
        <source>&amp;Repeat what was said</source>
        <translation>G&amp;esagtes wiederholen</translation>
    </message>
    <message>
        <source>Say again what was said last (Ctrl+Alt+S)</source>
        <translation>Sagt noch einmal, was zuletzt gesagt wurde (Strg+Alt+S)</translation>
    </message>
    <message>
        <source>In the voice&apos;s language of now; with a voice of its own.</source>
        <translation>In der jetzigen Sprache der Stimme; mit einer eigenen Stimme.</translation>
    </message>
    <message>
        <source>&amp;Louder speech</source>
        <translation>La&amp;uter sprechen</translation>
    </message>
    <message>
        <source>Sof&amp;ter speech</source>
        <translation>Leiser s&amp;prechen</translation>
    </message>
    <message>
        <source>Raise the volume of the voice by 3 decibels</source>
        <translation>Erhöht die Lautstärke der Stimme um 3 Dezibel</translation>
    </message>
    <message>
        <source>Lower the volume of the voice by 3 decibels</source>
        <translation>Verringert die Lautstärke der Stimme um 3 Dezibel</translation>
    </message>
</context>
<context>
    <name>relievo::WindowHost</name>
    <message>
        <source>%1 is too large for the memory and was not used. Make it coarser; it is laid over the whole map.</source>
        <translation>%1 ist zu groß für den Speicher und wurde nicht verwendet. Machen Sie es gröber; es wird über die ganze Karte gelegt.</translation>
    </message>
    <message>
        <source>Move and zoom</source>
        <translation>Verschieben und vergrößern</translation>
    </message>
</context>
<context>
    <name>relievo::WindowMessages</name>
    <message>
        <source>%1 is saved</source>
        <translation>%1 ist gespeichert</translation>
    </message>
    <message>
        <source>The message is closed.</source>
        <translation>Die Meldung ist geschlossen.</translation>
    </message>
</context>
<context>
    <name>relievo::WorkArea</name>
    <message>
        <source>Window</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>heights × %1   |   </source>
        <translation>Höhen × %1   |   </translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>OVERVIEW</source>
        <translation>ÜBERSICHT</translation>
    </message>
    <message>
        <source>hand scale 1 : %1</source>
        <translation>Maßstab der Hand 1 : %1</translation>
    </message>
    <message>
        <source>SCAN</source>
        <translation>SCAN</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>DETAIL   |   Resolution %1 of %2</source>
        <translation>DETAIL   |   Auflösung %1 von %2</translation>
    </message>
</context>
</TS>
