<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>BatteryGauge</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1 V, %2 %</source>
        <translation>%1 V, %2 %</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>%1, %2 s ago</source>
        <translation>%1, vor %2 s</translation>
    </message>
    <message>
        <source>%1, charging</source>
        <translation>%1, lädt</translation>
    </message>
    <message>
        <source>The battery is empty: charge it now.</source>
        <translation>Der Akku ist leer: jetzt laden.</translation>
    </message>
    <message>
        <source>The battery is low: charge it soon.</source>
        <translation>Der Akku ist fast leer: bald laden.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>BehaviorModel</name>
    <message>
        <source>%1: %2 for %3 s</source>
        <translation>%1: %2 seit %3 s</translation>
    </message>
    <message>
        <source>%1, forced</source>
        <translation>%1, erzwungen</translation>
    </message>
    <message>
        <source>%1, because %2</source>
        <translation>%1, weil %2</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>Adds a bookmark to the log</source>
        <translation>Setzt ein Lesezeichen im Log</translation>
    </message>
    <message>
        <source>Adds a curve to the plots</source>
        <translation>Fügt den Kurven eine Kurve hinzu</translation>
    </message>
    <message>
        <source>Adds a disc of the color view&apos;s image to the samples</source>
        <translation>Fügt den Proben eine Scheibe aus dem Bild der Farbansicht hinzu</translation>
    </message>
    <message>
        <source>Adds a key frame like the selected one behind it</source>
        <translation>Fügt hinter dem ausgewählten Keyframe einen gleichen ein</translation>
    </message>
    <message>
        <source>Adds a log file to the timeline</source>
        <translation>Fügt der Zeitleiste eine Logdatei hinzu</translation>
    </message>
    <message>
        <source>Adds pictures to the strip and shows the first</source>
        <translation>Fügt dem Streifen Bilder hinzu und zeigt das erste</translation>
    </message>
    <message>
        <source>Adds the pose of the selected robot to the motion in the editor, as a key frame</source>
        <translation>Fügt die Pose des gewählten Roboters der Bewegung im Editor als Keyframe hinzu</translation>
    </message>
    <message>
        <source>Adds the samples of another file</source>
        <translation>Fügt die Proben einer anderen Datei hinzu</translation>
    </message>
    <message>
        <source>Brings a view to the front and opens it if needed</source>
        <translation>Holt eine Ansicht nach vorn und öffnet sie, wenn nötig</translation>
    </message>
    <message>
        <source>Cancels opening a log, map or scene; what ran before continues</source>
        <translation>Bricht das Öffnen eines Logs, einer Karte oder Szene ab; was vorher lief, läuft weiter</translation>
    </message>
    <message>
        <source>Cancels the selected robot&apos;s goal</source>
        <translation>Hebt das Ziel des gewählten Roboters auf</translation>
    </message>
    <message>
        <source>Changes the light that cameras see; 1 0 restores the scene&apos;s own</source>
        <translation>Ändert das Licht, das Kameras sehen; 1 0 ist das der Szene</translation>
    </message>
    <message>
        <source>Chooses how images are recorded</source>
        <translation>Wählt, wie Bilder aufgezeichnet werden</translation>
    </message>
    <message>
        <source>Chooses how new files are compressed</source>
        <translation>Wählt, wie neue Dateien komprimiert werden</translation>
    </message>
    <message>
        <source>Chooses the method that makes the table</source>
        <translation>Wählt, wie die Tabelle entsteht</translation>
    </message>
    <message>
        <source>Chooses the class of the next stroke</source>
        <translation>Wählt die Klasse des nächsten Strichs</translation>
    </message>
    <message>
        <source>Chooses the colors of the window</source>
        <translation>Wählt die Farben des Fensters</translation>
    </message>
    <message>
        <source>Chooses the folder for new recordings</source>
        <translation>Wählt den Ordner für neue Aufzeichnungen</translation>
    </message>
    <message>
        <source>Chooses the language of the window, used from its next start on</source>
        <translation>Wählt die Sprache des Fensters, ab seinem nächsten Start</translation>
    </message>
    <message>
        <source>Chooses the process whose frames are counted and stepped through</source>
        <translation>Wählt den Prozess, dessen Frames schrittweise gezeigt und gezählt werden</translation>
    </message>
    <message>
        <source>Chooses what is recorded; empty: all that a replay needs</source>
        <translation>Wählt, was aufgezeichnet wird; leer: alles, was eine Wiedergabe braucht</translation>
    </message>
    <message>
        <source>Chooses how the robot that was taken over moves its head</source>
        <translation>Wählt, was der Kopf des übernommenen Roboters tut</translation>
    </message>
    <message>
        <source>Chooses whether a package is taken from the log or recomputed by the program that runs on it</source>
        <translation>Wählt, ob ein Paket aus dem Log genommen oder vom Programm, das darauf läuft, neu berechnet wird</translation>
    </message>
    <message>
        <source>Chooses whether each new table is sent to the robot at once</source>
        <translation>Wählt, ob jede neue Tabelle sofort an den Roboter gesendet wird</translation>
    </message>
    <message>
        <source>Chooses whether the next strokes mark colors that must not be of the class</source>
        <translation>Wählt, ob die nächsten Striche nicht zur Klasse gehören dürfen</translation>
    </message>
    <message>
        <source>Closes all views of a kind; their positions are remembered</source>
        <translation>Schließt alle Ansichten einer Art; sie behalten ihre Plätze</translation>
    </message>
    <message>
        <source>Closes the open logs</source>
        <translation>Schließt die offenen Logs</translation>
    </message>
    <message>
        <source>Compares the table with another one</source>
        <translation>Vergleicht die Tabelle mit einer anderen</translation>
    </message>
    <message>
        <source>Connects a Pioneer over TCP or a serial line and runs its program here; it stays connected until something else is opened</source>
        <translation>Verbindet einen Pioneer über TCP oder eine serielle Leitung und führt sein Programm hier aus; er bleibt verbunden, bis etwas anderes geöffnet wird</translation>
    </message>
    <message>
        <source>Connects remote robots, in addition to those that are open here</source>
        <translation>Verbindet Roboter, deren Programme anderswo laufen, neben denen, die hier offen sind</translation>
    </message>
    <message>
        <source>Deletes a perspective of your own</source>
        <translation>Löscht eine eigene Perspektive</translation>
    </message>
    <message>
        <source>Deletes a preset</source>
        <translation>Löscht eine Voreinstellung</translation>
    </message>
    <message>
        <source>Discards unsaved changes of the samples</source>
        <translation>Verwirft nicht gespeicherte Änderungen der Proben</translation>
    </message>
    <message>
        <source>Uses the same scale on both axes of plots of one value over another</source>
        <translation>Zeichnet Einheiten auf beiden Achsen von Kurven über anderen gleich lang</translation>
    </message>
    <message>
        <source>Disconnects remote robots, which disappear from the window</source>
        <translation>Beendet die Verbindung zu entfernten Robotern, die das Fenster verlassen</translation>
    </message>
    <message>
        <source>Disconnects all clients and stops offering the session</source>
        <translation>Beendet die Verbindungen aller, die beobachten und steuern, was hier offen ist</translation>
    </message>
    <message>
        <source>Ends the recording</source>
        <translation>Beendet die Aufzeichnung</translation>
    </message>
    <message>
        <source>Ends the search; what was found stays</source>
        <translation>Beendet die Suche; Gefundenes bleibt</translation>
    </message>
    <message>
        <source>Ends the sweep of a parameter and restores its previous value</source>
        <translation>Beendet den Durchlauf eines Parameters, der seinen früheren Wert bekommt</translation>
    </message>
    <message>
        <source>Engages or releases STOP for all robots: their platforms hold them, whatever the programs do</source>
        <translation>Löst STOP für alle Roboter aus oder hebt es auf: ihre Plattformen halten sie an, was auch immer die Programme tun</translation>
    </message>
    <message>
        <source>Swaps the selected key frame with another one</source>
        <translation>Vertauscht den ausgewählten Keyframe mit einem anderen</translation>
    </message>
    <message>
        <source>Lists how the current choices differ from a preset, and fails if they do</source>
        <translation>Scheitert mit dem, worin sich die jetzige Wahl von einer Voreinstellung unterscheidet</translation>
    </message>
    <message>
        <source>Forgets the token that is remembered for a remote robot</source>
        <translation>Vergisst das gemerkte Token eines entfernten Roboters</translation>
    </message>
    <message>
        <source>Gives a view all the space</source>
        <translation>Gibt einer Ansicht allen Platz</translation>
    </message>
    <message>
        <source>Jumps to a frame of the chosen process</source>
        <translation>Springt zu einem Frame des gewählten Prozesses</translation>
    </message>
    <message>
        <source>Jumps to a time of the log</source>
        <translation>Springt zu einer Zeit des Logs</translation>
    </message>
    <message>
        <source>Jumps to the hit before the shown time</source>
        <translation>Springt zum Fund vor der gezeigten Zeit</translation>
    </message>
    <message>
        <source>Jumps to the next hit of the search</source>
        <translation>Springt zum nächsten Fund der Suche</translation>
    </message>
    <message>
        <source>Keeps the last seconds in memory, to save them when something happens; 0 keeps nothing</source>
        <translation>Behält die letzten Sekunden im Speicher, um sie zu speichern, wenn etwas geschieht; 0 behält nichts</translation>
    </message>
    <message>
        <source>Lets others watch and steer what is open here, as clients of the Foxglove WebSocket protocol</source>
        <translation>Lässt andere beobachten und steuern, was hier offen ist, als Clients des Foxglove-WebSocket-Protokolls</translation>
    </message>
    <message>
        <source>Makes the robot that was taken over stand still</source>
        <translation>Lässt den übernommenen Roboter stehen</translation>
    </message>
    <message>
        <source>Makes the robot that was taken over walk or drive until another command</source>
        <translation>Lässt den übernommenen Roboter bis zum nächsten Befehl gehen oder fahren</translation>
    </message>
    <message>
        <source>Makes the selected robot play the motion from its own files again</source>
        <translation>Lässt den gewählten Roboter wieder die Bewegung aus seinen Dateien abspielen</translation>
    </message>
    <message>
        <source>Limits the data rate of remote robots, for slow or shared links; the limits are remembered</source>
        <translation>Begrenzt, was entfernte Roboter senden, für schmale oder geteilte Leitungen; es wird gemerkt</translation>
    </message>
    <message>
        <source>Loops the whole log or the selected range</source>
        <translation>Wiederholt das ganze Log oder den ausgewählten Bereich</translation>
    </message>
    <message>
        <source>Marks the times of matching text messages in the timeline and in plots</source>
        <translation>Markiert in Zeitleiste und Kurven, wann passende Meldungen geschrieben wurden</translation>
    </message>
    <message>
        <source>Marks the shown instant in the recording; if none is running, saves the last seconds with the mark</source>
        <translation>Markiert den gezeigten Zeitpunkt in der Aufzeichnung; ohne Aufzeichnung werden die letzten Sekunden mit der Markierung gespeichert</translation>
    </message>
    <message>
        <source>Mirrors the motion: what the left side did, the right side does</source>
        <translation>Spiegelt die Bewegung: was die linke Seite tat, tut die rechte</translation>
    </message>
    <message>
        <source>Moves a joint of the head of the robot that was taken over</source>
        <translation>Bewegt ein Gelenk des Kopfs des übernommenen Roboters</translation>
    </message>
    <message>
        <source>Opens a camera of this computer and runs perception on its images</source>
        <translation>Öffnet eine Kamera dieses Rechners und führt die Wahrnehmung auf ihren Bildern aus</translation>
    </message>
    <message>
        <source>Opens a door of the simulation for its set time, or closes it at once</source>
        <translation>Öffnet eine Tür der Simulation für ihre Zeit oder schließt sie sofort</translation>
    </message>
    <message>
        <source>Opens a log, a video or a folder of pictures, paused at its first image; closes what was open</source>
        <translation>Öffnet ein Log, ein Video oder einen Ordner mit Bildern, angehalten am ersten Bild; schließt, was offen war</translation>
    </message>
    <message>
        <source>Opens a motion in the editor, or imports another team&apos;s</source>
        <translation>Öffnet eine Bewegung im Editor, oder importiert eine eines anderen Teams</translation>
    </message>
    <message>
        <source>Opens a motion of the selected robot&apos;s program in the editor</source>
        <translation>Öffnet eine Bewegung, die das Programm des gewählten Roboters hat</translation>
    </message>
    <message>
        <source>Opens a scene or a map and adds robots to it</source>
        <translation>Öffnet eine Szene oder eine Karte und fügt ihr Roboter hinzu</translation>
    </message>
    <message>
        <source>Opens a scene, by its path or the name of a shipped one</source>
        <translation>Öffnet eine Szene nach ihrem Pfad oder dem Namen einer mitgelieferten</translation>
    </message>
    <message>
        <source>Opens another view of a kind</source>
        <translation>Öffnet eine weitere Ansicht einer Art</translation>
    </message>
    <message>
        <source>Opens the samples of a color table</source>
        <translation>Öffnet die Proben einer Farbtabelle</translation>
    </message>
    <message>
        <source>Pauses the log and steps by frames of the chosen process</source>
        <translation>Hält das Log an und geht um Frames des gewählten Prozesses weiter</translation>
    </message>
    <message>
        <source>Pauses the log and steps by messages of a stream</source>
        <translation>Hält das Log an und geht um Nachrichten eines Datenstroms weiter</translation>
    </message>
    <message>
        <source>Pauses the log at its start</source>
        <translation>Hält das Log an seinem Anfang an</translation>
    </message>
    <message>
        <source>Pauses the log</source>
        <translation>Hält das Log an</translation>
    </message>
    <message>
        <source>Pauses the simulation</source>
        <translation>Hält die Simulation an</translation>
    </message>
    <message>
        <source>Plays a key-frame motion of the robot that was taken over</source>
        <translation>Spielt eine Keyframe-Bewegung des übernommenen Roboters ab</translation>
    </message>
    <message>
        <source>Plays the log; at its end, from the start</source>
        <translation>Spielt das Log ab; an seinem Ende von vorn</translation>
    </message>
    <message>
        <source>Plays the motion once on the robot that was taken over</source>
        <translation>Spielt die Bewegung einmal auf dem übernommenen Roboter ab</translation>
    </message>
    <message>
        <source>Reloads the motion in the editor from its file; unsaved changes are lost</source>
        <translation>Liest die Bewegung im Editor wieder aus ihrer Datei; nicht gespeicherte Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>Reconnects to the robot now instead of after a pause; its program keeps running</source>
        <translation>Verbindet jetzt wieder mit dem Roboter statt nach einer Pause; sein Programm läuft weiter</translation>
    </message>
    <message>
        <source>Redoes what was undone</source>
        <translation>Stellt wieder her, was rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Releases all joints of the robot that was taken over, so that you can pose it by hand, or makes them hold</source>
        <translation>Gibt alle Gelenke des übernommenen Roboters frei, damit er von Hand in Pose gebracht wird, oder lässt sie halten</translation>
    </message>
    <message>
        <source>Remembers the token of a connection on this computer, once the robot has accepted it</source>
        <translation>Merkt das Token einer Verbindung auf diesem Rechner, sobald der Roboter es angenommen hat</translation>
    </message>
    <message>
        <source>Removes a curve from the plots</source>
        <translation>Entfernt eine Kurve</translation>
    </message>
    <message>
        <source>Removes all curves from the plots</source>
        <translation>Entfernt alle Kurven</translation>
    </message>
    <message>
        <source>Removes the selected key frame</source>
        <translation>Entfernt den ausgewählten Keyframe</translation>
    </message>
    <message>
        <source>Renames a preset</source>
        <translation>Benennt eine Voreinstellung um</translation>
    </message>
    <message>
        <source>Resets a parameter of the selected robot&apos;s program to its default</source>
        <translation>Setzt einen Parameter des Programms des gewählten Roboters auf seine Vorgabe zurück</translation>
    </message>
    <message>
        <source>Resets all parameters of the selected robot&apos;s program to their defaults</source>
        <translation>Setzt alle Parameter des Programms des gewählten Roboters auf ihre Vorgaben zurück</translation>
    </message>
    <message>
        <source>Resets everything to its initial state</source>
        <translation>Setzt alles auf den Anfang zurück</translation>
    </message>
    <message>
        <source>Restarts the program on the log in another process layout, given by its path or the name of a shipped one</source>
        <translation>Startet das Programm auf dem Log in einem anderen Prozesslayout neu, nach seinem Pfad oder dem Namen eines mitgelieferten</translation>
    </message>
    <message>
        <source>Restarts the robots&apos; programs in another process layout, given by its path or the name of a shipped one</source>
        <translation>Startet die Programme der Roboter in einem anderen Prozesslayout neu, nach seinem Pfad oder dem Namen eines mitgelieferten</translation>
    </message>
    <message>
        <source>Runs a robot&apos;s program here, for a remote body that &apos;robotctl platform ... --listen&apos; offers</source>
        <translation>Führt hier das Programm eines Roboters aus, dessen Körper anderswo ist, wo &apos;robotctl platform ... --listen&apos; läuft</translation>
    </message>
    <message>
        <source>Runs the simulation</source>
        <translation>Lässt die Simulation laufen</translation>
    </message>
    <message>
        <source>Saves a picture of a view, which is opened if needed, or of the whole window</source>
        <translation>Speichert ein Bild einer Ansicht, die wenn nötig geöffnet wird, oder des ganzen Fensters</translation>
    </message>
    <message>
        <source>Saves the arrangement of the views as a perspective</source>
        <translation>Speichert die Anordnung der Ansichten als Perspektive</translation>
    </message>
    <message>
        <source>Saves the last seconds when a message arrives on a stream; empty: never</source>
        <translation>Speichert die letzten Sekunden, wenn eine Nachricht auf einem Datenstrom eintrifft; leer: nie</translation>
    </message>
    <message>
        <source>Saves the last seconds, which are kept in memory, to a file</source>
        <translation>Speichert die letzten Sekunden, die im Speicher behalten werden, in einer Datei</translation>
    </message>
    <message>
        <source>Saves the last seconds, which are kept in memory, to a new file</source>
        <translation>Speichert die letzten Sekunden, die im Speicher behalten werden, in einer neuen Datei</translation>
    </message>
    <message>
        <source>Saves the motion in the editor to a file</source>
        <translation>Speichert die Bewegung im Editor in einer Datei</translation>
    </message>
    <message>
        <source>Saves the motion in the editor to its file</source>
        <translation>Speichert die Bewegung im Editor in ihrer Datei</translation>
    </message>
    <message>
        <source>Saves the samples of the color table to their file</source>
        <translation>Speichert die Proben der Farbtabelle in der Datei, aus der sie sind</translation>
    </message>
    <message>
        <source>Saves the samples of the color table</source>
        <translation>Speichert die Proben der Farbtabelle</translation>
    </message>
    <message>
        <source>Saves changed parameters to the files that the program reads when it starts; their comments stay</source>
        <translation>Speichert geänderte Parameter in den Dateien, die das Programm bei seinem Start liest; ihre Kommentare bleiben</translation>
    </message>
    <message>
        <source>Searches for the images where the table looks most suspicious</source>
        <translation>Sucht die Bilder, in denen die Tabelle am verdächtigsten aussieht</translation>
    </message>
    <message>
        <source>Finds where a condition is true in the open logs, without playing them; fails if it never is</source>
        <translation>Durchsucht die offenen Logs vollständig danach, wo eine Bedingung gilt, ohne sie abzuspielen; scheitert, wenn sie nie gilt</translation>
    </message>
    <message>
        <source>Searches the open logs in the view Search, without playing them</source>
        <translation>Durchsucht die offenen Logs vollständig in der Ansicht Suche, ohne sie abzuspielen</translation>
    </message>
    <message>
        <source>Selects a key frame of the motion</source>
        <translation>Wählt einen Keyframe der Bewegung aus</translation>
    </message>
    <message>
        <source>Selects a range, for example to loop it; equal times clear the selection</source>
        <translation>Wählt einen Bereich aus, etwa um ihn zu wiederholen; gleiche Zeiten heben die Auswahl auf</translation>
    </message>
    <message>
        <source>Selects another key frame; a robot that was taken over moves to its pose</source>
        <translation>Wählt einen anderen Keyframe aus; ein übernommener Roboter nimmt seine Pose ein</translation>
    </message>
    <message>
        <source>Selects the robot that toolbars and views show</source>
        <translation>Wählt den Roboter, den Werkzeugleisten und Ansichten zeigen</translation>
    </message>
    <message>
        <source>Sends a color table to the selected robot&apos;s program, which uses it from its next image on</source>
        <translation>Sendet eine Farbtabelle an das Programm des gewählten Roboters, das sie ab seinem nächsten Bild verwendet</translation>
    </message>
    <message>
        <source>Sends each change of the motion that has no errors</source>
        <translation>Sendet jede fehlerfreie Änderung der Bewegung</translation>
    </message>
    <message>
        <source>Sends the motion to the selected robot, whose program plays it from then on</source>
        <translation>Sendet die Bewegung an den gewählten Roboter, dessen Programm sie von da an abspielt</translation>
    </message>
    <message>
        <source>Sends the selected robot to a place, if it has wheels</source>
        <translation>Schickt den gewählten Roboter an einen Ort, wenn er Räder hat</translation>
    </message>
    <message>
        <source>Sends the table to the selected robot&apos;s program</source>
        <translation>Sendet die Tabelle an das Programm des gewählten Roboters</translation>
    </message>
    <message>
        <source>Sets a parameter of a solution of the selected robot&apos;s program</source>
        <translation>Setzt einen Parameter einer Lösung des Programms des gewählten Roboters</translation>
    </message>
    <message>
        <source>Sets a parameter to one value after another and measures a quantity at each</source>
        <translation>Setzt einen Parameter auf einen Wert nach dem anderen und misst jeweils eine Größe</translation>
    </message>
    <message>
        <source>Sets an option of that method</source>
        <translation>Setzt eine Option dafür, wie die Tabelle entsteht</translation>
    </message>
    <message>
        <source>Sets how long the selected key frame takes</source>
        <translation>Setzt, wie lange der ausgewählte Keyframe dauert</translation>
    </message>
    <message>
        <source>Sets the playback speed relative to real time</source>
        <translation>Setzt, mit welchem Vielfachen der Echtzeit das Log abgespielt wird</translation>
    </message>
    <message>
        <source>Sets the speed of the simulation relative to real time; 0 is as fast as possible</source>
        <translation>Setzt, mit welchem Vielfachen der Echtzeit die Simulation läuft; 0 ist so schnell wie möglich</translation>
    </message>
    <message>
        <source>Sets how much older history of the robots is kept on disk; the setting is remembered</source>
        <translation>Setzt, wie viel des früher von Robotern Gesendeten auf dem Datenträger behalten wird; es wird gemerkt</translation>
    </message>
    <message>
        <source>Sets how much history of the robots is kept in memory; the setting is remembered</source>
        <translation>Setzt, wie viel des von Robotern Gesendeten im Speicher behalten wird; es wird gemerkt</translation>
    </message>
    <message>
        <source>Sets how much the next strokes count</source>
        <translation>Setzt, wie stark die nächsten Striche zählen</translation>
    </message>
    <message>
        <source>Sets how the selected key frame is reached</source>
        <translation>Setzt, wie der ausgewählte Keyframe erreicht wird</translation>
    </message>
    <message>
        <source>Sets the angle of a joint in the selected key frame</source>
        <translation>Setzt den Winkel eines Gelenks im ausgewählten Keyframe</translation>
    </message>
    <message>
        <source>Sets the classes; strokes keep the class of their name</source>
        <translation>Setzt die Klassen; Striche behalten die Klasse ihres Namens</translation>
    </message>
    <message>
        <source>Sets the size of all texts</source>
        <translation>Setzt die Größe aller Texte</translation>
    </message>
    <message>
        <source>Shifts one of the open logs on the timeline</source>
        <translation>Verschiebt eines der offenen Logs auf der Zeitleiste</translation>
    </message>
    <message>
        <source>Shows a curve of the plots as a strip of states, or as a curve</source>
        <translation>Zeigt eine Kurve als Streifen von Zuständen oder als Kurve</translation>
    </message>
    <message>
        <source>Imports an exported perspective and shows it</source>
        <translation>Zeigt eine exportierte Perspektive und fügt sie den eigenen hinzu</translation>
    </message>
    <message>
        <source>Shows a perspective</source>
        <translation>Zeigt eine Perspektive</translation>
    </message>
    <message>
        <source>Sends a token to a remote robot that asks for one</source>
        <translation>Zeigt einem entfernten Roboter, der danach fragt, ein Token</translation>
    </message>
    <message>
        <source>Shows all views again after one was maximized</source>
        <translation>Zeigt wieder alle Ansichten, nachdem eine maximiert war</translation>
    </message>
    <message>
        <source>Shows an earlier instant in all views, while the robots continue</source>
        <translation>Zeigt in allen Ansichten einen früheren Augenblick, während die Roboter weiterlaufen</translation>
    </message>
    <message>
        <source>Shows spectra of the curves in the plots, of the shown times or between the cursors</source>
        <translation>Zeigt Spektren der Kurven, der gezeigten Zeiten oder zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Resets the current perspective to its shipped layout</source>
        <translation>Zeigt die jetzige Perspektive, wie sie mitgeliefert ist</translation>
    </message>
    <message>
        <source>Returns all views to what the robots send now</source>
        <translation>Zeigt wieder, was die Roboter jetzt senden</translation>
    </message>
    <message>
        <source>Skips gaps of more than a second in the log</source>
        <translation>Überspringt Lücken von mehr als einer Sekunde im Log</translation>
    </message>
    <message>
        <source>Starts a motion in the editor with the joints of the selected robot</source>
        <translation>Beginnt im Editor eine Bewegung mit den Gelenken des gewählten Roboters</translation>
    </message>
    <message>
        <source>Starts new samples of a color table</source>
        <translation>Beginnt neue Proben einer Farbtabelle</translation>
    </message>
    <message>
        <source>Starts recording into a file</source>
        <translation>Beginnt, in eine Datei aufzuzeichnen</translation>
    </message>
    <message>
        <source>Starts recording into a new file in the folder for recordings</source>
        <translation>Beginnt, in eine neue Datei im Ordner für Aufzeichnungen aufzuzeichnen</translation>
    </message>
    <message>
        <source>Starts recording into a new file, or ends the recording</source>
        <translation>Beginnt, in eine neue Datei aufzuzeichnen, oder beendet die Aufzeichnung</translation>
    </message>
    <message>
        <source>Takes control of a robot that other clients can also steer, or releases it</source>
        <translation>Steuert ab jetzt einen Roboter, den auch andere steuern können; oder gibt ihn ab</translation>
    </message>
    <message>
        <source>Steps the simulation by 8 ms</source>
        <translation>Führt die Simulation einen Schritt von 8 ms weiter</translation>
    </message>
    <message>
        <source>Steps to where a value changes, or crosses a threshold: in the open logs, without playing them, or in the history of live robots, while they continue</source>
        <translation>Geht dorthin, wo sich ein Wert ändert oder eine Zahl überschreitet: in den offenen Logs, ohne sie abzuspielen, oder in dem, was von Robotern behalten ist, während sie weiterlaufen</translation>
    </message>
    <message>
        <source>Steps what all views show by frames of the selected robot, while the robots continue</source>
        <translation>Geht mit allen Ansichten um Frames des gewählten Roboters weiter, während die Roboter weiterlaufen</translation>
    </message>
    <message>
        <source>Steps what all views show by messages of a stream, while the robots continue</source>
        <translation>Geht mit allen Ansichten um Nachrichten eines Datenstroms weiter, während die Roboter weiterlaufen</translation>
    </message>
    <message>
        <source>Switches the motors of the selected robot on wheels</source>
        <translation>Schaltet die Motoren des gewählten Roboters auf Rädern</translation>
    </message>
    <message>
        <source>Switches the selected robot and the window to a preset</source>
        <translation>Schaltet den gewählten Roboter und das Fenster auf eine Voreinstellung um</translation>
    </message>
    <message>
        <source>Switches the selected robot&apos;s program back to its built-in color table</source>
        <translation>Schaltet das Programm des gewählten Roboters auf seine eingebaute Farbtabelle zurück</translation>
    </message>
    <message>
        <source>Switches the sonars of the selected robot on wheels</source>
        <translation>Schaltet die Sonare des gewählten Roboters auf Rädern</translation>
    </message>
    <message>
        <source>Takes manual control of the selected robot, or gives it back</source>
        <translation>Übernimmt den gewählten Roboter zur manuellen Steuerung oder gibt ihn zurück</translation>
    </message>
    <message>
        <source>Trusts the certificate that a remote robot shows, from now on, and connects it</source>
        <translation>Vertraut ab jetzt dem Zertifikat, das ein entfernter Roboter zeigt, und verbindet ihn</translation>
    </message>
    <message>
        <source>Turns a joint of the robot that was taken over; it holds the others where they are until it walks, plays or stands</source>
        <translation>Dreht ein Gelenk des übernommenen Roboters; er hält die anderen, wo sie sind, bis er geht, eine Bewegung abspielt oder steht</translation>
    </message>
    <message>
        <source>Undoes the last change of the arrangement of the views</source>
        <translation>Macht die letzte Änderung der Anordnung der Ansichten rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change of the samples</source>
        <translation>Macht die letzte Änderung der Proben rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last edit of the motion</source>
        <translation>Macht die letzte Bearbeitung der Bewegung rückgängig</translation>
    </message>
    <message>
        <source>Writes the color table to a file</source>
        <translation>Schreibt die Farbtabelle in eine Datei</translation>
    </message>
    <message>
        <source>Writes the shown perspective to a file</source>
        <translation>Schreibt die gezeigte Perspektive in eine Datei</translation>
    </message>
    <message>
        <source>Cancels the export of a view; an unfinished video is deleted, written images stay</source>
        <translation>Bricht den Export einer Ansicht ab; ein Video wird gelöscht, schon geschriebene Bilder bleiben</translation>
    </message>
    <message>
        <source>Removes a curve from the timeline</source>
        <translation>Entfernt eine Kurve aus der Zeitleiste</translation>
    </message>
    <message>
        <source>Shows a value as a curve in the timeline</source>
        <translation>Zeigt einen Wert als Kurve in der Zeitleiste</translation>
    </message>
    <message>
        <source>Writes a view over time as a video, from the open logs or the history of live robots</source>
        <translation>Schreibt eine Ansicht über der Zeit als Video: von den offenen Logs, oder von dem, was von laufenden Robotern aufbewahrt wird</translation>
    </message>
    <message>
        <source>Writes a view over time as numbered PNG files into a folder</source>
        <translation>Schreibt eine Ansicht über der Zeit als nummerierte PNG-Dateien in einen Ordner</translation>
    </message>
    <message>
        <source>Changes a setting of the selected robot&apos;s camera, as in the view Camera</source>
        <translation>Ändert eine Einstellung der Kamera des ausgewählten Roboters, wie in der Ansicht Kamera</translation>
    </message>
    <message>
        <source>Saves what a view shows: its picture, table or text, points of plots, packets</source>
        <translation>Speichert, was eine Ansicht zeigt: Bild, Tabelle oder Text, Punkte von Kurven, Pakete</translation>
    </message>
    <message>
        <source>Changes the text of a bookmark of the open logs; if several have this text, the first</source>
        <translation>Ändert den Text eines Lesezeichens der offenen Logs; von mehreren mit diesem Text das erste</translation>
    </message>
    <message>
        <source>Checks or unchecks a drawing in the list of a view; checking one that is off on the robot switches it on there</source>
        <translation>Hakt eine Zeichnung in der Liste einer Ansicht an oder ab; ist sie beim Roboter aus, wird sie dort eingeschaltet</translation>
    </message>
    <message>
        <source>Chooses the images that an Image view shows</source>
        <translation>Wählt, welche Bilder eine Ansicht Bild zeigt</translation>
    </message>
    <message>
        <source>Chooses where the program of the selected robot, of another one or of all runs, and how the processes of all programs are executed; the programs are restarted</source>
        <translation>Wählt, wo das Programm des gewählten Roboters, eines anderen oder aller läuft und wie die Prozesse aller Programme ausgeführt werden; die Programme werden neu gestartet</translation>
    </message>
    <message>
        <source>Chooses whether sensors, cameras and odometry have errors; the simulation restarts from the beginning</source>
        <translation>Wählt, ob Sensoren, Kameras und Odometrie Fehler haben; die Simulation wird neu geöffnet und beginnt von vorn</translation>
    </message>
    <message>
        <source>Compares the images of an Image view with second ones</source>
        <translation>Vergleicht die Bilder einer Ansicht Bild mit zweiten</translation>
    </message>
    <message>
        <source>Compares the values in a Data view with others</source>
        <translation>Vergleicht die Werte in einer Ansicht Daten mit anderen</translation>
    </message>
    <message>
        <source>Places a robot or the ball of the simulation; with a height, roll or pitch also tilted, or lying on its side</source>
        <translation>Setzt einen Roboter oder den Ball der Simulation an einen Ort; mit Höhe, Roll- oder Nickwinkel auch gekippt, etwa liegend</translation>
    </message>
    <message>
        <source>Redoes the last edit undone there</source>
        <translation>Stellt wieder her, was dort rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Removes a bookmark of the open logs; if several have this text, the first</source>
        <translation>Entfernt ein Lesezeichen der offenen Logs; von mehreren mit diesem Text das erste</translation>
    </message>
    <message>
        <source>Sends a message to a robot once, as the view Data does</source>
        <translation>Sendet einem Roboter einmal eine Nachricht, wie die Ansicht Daten</translation>
    </message>
    <message>
        <source>Sets a debug key of the program of the selected robot, of another one, or of all</source>
        <translation>Setzt einen Debug-Schlüssel des Programms des gewählten Roboters, eines anderen oder aller</translation>
    </message>
    <message>
        <source>Shows only messages whose text or source contains a text</source>
        <translation>Zeigt nur Meldungen, deren Text oder Quelle einen Text enthält</translation>
    </message>
    <message>
        <source>Restarts the program of the selected robot, of another one or of all; keys, solutions and parameters stay</source>
        <translation>Startet das Programm des gewählten Roboters, eines anderen oder aller neu; Schlüssel, Lösungen und Parameter bleiben</translation>
    </message>
    <message>
        <source>Switches the solution of a task of the program of the selected robot, of another one, or of all</source>
        <translation>Schaltet die Lösung einer Aufgabe im Programm des gewählten Roboters, eines anderen oder aller um</translation>
    </message>
    <message>
        <source>Undoes the last edit in the panel of parameters of the view Solutions</source>
        <translation>Macht die letzte Änderung bei den Parametern der Ansicht Lösungen rückgängig</translation>
    </message>
    <message>
        <source>Exports a part of an open log as images, a table (CSV), JSON lines or texts</source>
        <translation>Schreibt einen Teil eines offenen Logs als Bilder, Tabelle (CSV), JSON-Zeilen oder Texte</translation>
    </message>
    <message>
        <source>Writes a part of the open logs into a new log</source>
        <translation>Schreibt einen Teil der offenen Logs in ein neues Log</translation>
    </message>
    <message>
        <source>Chooses at which pose of a robot a view places its drawings</source>
        <translation>Wählt, an welche Pose eines Roboters eine Ansicht seine Zeichnungen setzt</translation>
    </message>
    <message>
        <source>Substitutes a value for a package in the program of the selected robot, of another one or of all</source>
        <translation>Setzt einen Wert an die Stelle eines Pakets, das das Programm des gewählten, eines anderen oder aller Roboter anbietet</translation>
    </message>
    <message>
        <source>Saves the current choices as a preset: debug keys, solutions, parameters, views and camera settings</source>
        <translation>Speichert, was jetzt gewählt ist, als Voreinstellung: Debug-Schlüssel, Lösungen, Parameter, Ansichten und Einstellungen der Kamera</translation>
    </message>
    <message>
        <source>Moves the gripper of the selected robot, if it has one</source>
        <translation>Bewegt den Greifer des gewählten Pioneers, wenn er einen hat</translation>
    </message>
    <message>
        <source>Saves what the selected robot has mapped as a map for localization and planning; its home is where the robot is</source>
        <translation>Speichert, was der gewählte Roboter kartiert hat, als Karte für Lokalisierung und Planung; ihr Startplatz ist, wo der Roboter ist</translation>
    </message>
    <message>
        <source>Switches a digital output of the selected robot, if it has any</source>
        <translation>Schaltet einen digitalen Ausgang des Benutzeranschlusses des gewählten Pioneers</translation>
    </message>
    <message>
        <source>Chooses how an Image view shows its images</source>
        <translation>Wählt, wie eine Ansicht Bild ihre Bilder zeigt</translation>
    </message>
    <message>
        <source>Copies what a view shows to the clipboard</source>
        <translation>Kopiert, was eine Ansicht zeigt, in die Zwischenablage</translation>
    </message>
    <message>
        <source>Lets programs set an actuator again</source>
        <translation>Lässt Programme einen Aktor wieder stellen</translation>
    </message>
    <message>
        <source>Reloads the scene&apos;s file after an edit, and continues in it: what has not changed stays as it is</source>
        <translation>Liest die Datei der Szene nach einer Änderung erneut und läuft in ihr weiter: was sich nicht geändert hat, bleibt wie es ist</translation>
    </message>
    <message>
        <source>Saves the file in the scene editor</source>
        <translation>Speichert die Datei im Szeneneditor</translation>
    </message>
    <message>
        <source>Shows an object of the simulated scene in the scene editor, or a scene file</source>
        <translation>Zeigt ein Objekt der simulierten Szene oder eine Szenendatei im Szeneneditor</translation>
    </message>
    <message>
        <source>Shows the values of a list as columns</source>
        <translation>Zeigt die Werte einer Liste als Säulen</translation>
    </message>
    <message>
        <source>Adds a copy of an object to the text of the simulated scene, half a meter away</source>
        <translation>Fügt dem Text der simulierten Szene eine Kopie eines Objekts hinzu, einen halben Meter daneben</translation>
    </message>
    <message>
        <source>Adds a model to the running scene; the program of an added robot starts</source>
        <translation>Fügt der laufenden Szene ein Modell hinzu; das Programm eines Roboters startet mit ihm</translation>
    </message>
    <message>
        <source>Adds an object to the text of the simulated scene, and applies it; nothing is saved</source>
        <translation>Fügt dem Text der simulierten Szene ein Objekt hinzu und macht darin weiter; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Adds a copy of a model next to it</source>
        <translation>Stellt ein weiteres Modell wie dieses daneben</translation>
    </message>
    <message>
        <source>Chooses how an object and everything in it is drawn</source>
        <translation>Wählt, wie ein Objekt mit allem, was dazugehört, gezeichnet wird</translation>
    </message>
    <message>
        <source>Chooses how the surfaces of a view of the scene are drawn</source>
        <translation>Wählt, wie die Oberflächen einer Ansicht der Szene gezeichnet werden</translation>
    </message>
    <message>
        <source>Clicks in the simulated scene, for its controllers: on whatever a ray hits first</source>
        <translation>Klickt für die Steuerungen der simulierten Szene auf eine Stelle: entlang eines Strahls, dessen erster Treffer zählt</translation>
    </message>
    <message>
        <source>Redoes the last change undone</source>
        <translation>Stellt das zuletzt Zurückgenommene wieder her</translation>
    </message>
    <message>
        <source>Cancels replaying the programs up to a snapshot, and pauses the simulation</source>
        <translation>Beendet das erneute Ausführen der Programme bis zu einer Momentaufnahme; die Simulation pausiert dann</translation>
    </message>
    <message>
        <source>Deletes a snapshot in memory</source>
        <translation>Vergisst eine Momentaufnahme im Speicher</translation>
    </message>
    <message>
        <source>Rewinds the paused simulation by some seconds; the robots&apos; programs keep running</source>
        <translation>Geht in der pausierten Simulation um einige Sekunden zurück; die Programme der Roboter laufen weiter</translation>
    </message>
    <message>
        <source>Applies the texts of the scene editor to the running simulation without saving them</source>
        <translation>Lässt die Simulation in den Texten des Szeneneditors weiterlaufen, wie sie sind, ohne sie zu speichern</translation>
    </message>
    <message>
        <source>Hides an object of the scene and everything in it</source>
        <translation>Blendet ein Objekt der Szene mit allem aus, was dazugehört</translation>
    </message>
    <message>
        <source>Pins an object of the simulation where it is, so that nothing can move it</source>
        <translation>Hält ein Objekt der Simulation fest, wo es ist, was auch immer daran schiebt</translation>
    </message>
    <message>
        <source>Takes a snapshot of the simulation: in memory under a name or, if there is a slash or the suffix .snapshot, in a file</source>
        <translation>Bewahrt den jetzigen Zustand der Simulation auf, im Speicher unter einem Namen oder, mit Schrägstrich oder der Endung .snapshot, in einer Datei</translation>
    </message>
    <message>
        <source>Makes an object transparent</source>
        <translation>Lässt ein Objekt durchscheinen</translation>
    </message>
    <message>
        <source>Releases a dragged object of the simulation</source>
        <translation>Lässt ein Objekt der Simulation los, das gezogen wird</translation>
    </message>
    <message>
        <source>Makes the camera of a view follow an object</source>
        <translation>Lässt die Kamera einer Ansicht einem Objekt folgen</translation>
    </message>
    <message>
        <source>Limits a view to an object and everything in it</source>
        <translation>Beschränkt eine Ansicht auf ein Objekt mit allem, was dazugehört</translation>
    </message>
    <message>
        <source>Opens a view of an object of the scene</source>
        <translation>Öffnet eine Ansicht eines Objekts der Szene</translation>
    </message>
    <message>
        <source>Presses and releases a key for the controllers of the simulated scene, as in the Scene view</source>
        <translation>Drückt eine Taste für die Steuerungen der simulierten Szene, wie in der Ansicht Szene</translation>
    </message>
    <message>
        <source>Pulls the center of an object of the simulation toward a point by a spring, until it is released</source>
        <translation>Zieht die Mitte eines Objekts der Simulation mit einer Feder zu einem Punkt, bis es losgelassen wird</translation>
    </message>
    <message>
        <source>Pushes the center of an object of the simulation with a force</source>
        <translation>Schiebt die Mitte eines Objekts der Simulation mit einer Kraft</translation>
    </message>
    <message>
        <source>Restores the world of the simulation from a snapshot. The robots&apos; programs keep running; with --programs on they are replayed from the start, with all requests since then, up to the snapshot</source>
        <translation>Setzt die Welt der Simulation auf eine Momentaufnahme zurück. Die Programme der Roboter laufen weiter; mit --programs on werden sie vom Start an erneut ausgeführt, mit allem, was seitdem verlangt wurde, bis auch sie dort sind</translation>
    </message>
    <message>
        <source>Removes an object from the text of the simulated scene, and applies it; nothing is saved</source>
        <translation>Entfernt ein Objekt aus dem Text der simulierten Szene und macht darin weiter; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Renames an object in the text of the simulated scene</source>
        <translation>Benennt ein Objekt im Text der simulierten Szene um</translation>
    </message>
    <message>
        <source>Sets a model of the simulation in motion</source>
        <translation>Setzt ein Modell der Simulation in Bewegung</translation>
    </message>
    <message>
        <source>Shows a hidden object again</source>
        <translation>Zeigt ein ausgeblendetes Objekt wieder</translation>
    </message>
    <message>
        <source>Shows or hides something in views of the scene</source>
        <translation>Zeigt etwas in Ansichten der Szene oder lässt es weg</translation>
    </message>
    <message>
        <source>Removes a model from the running scene; the program of a removed robot ends</source>
        <translation>Nimmt ein Modell aus der laufenden Szene; das Programm eines Roboters endet</translation>
    </message>
    <message>
        <source>Undoes the last scene.add, scene.remove or scene.duplicate: a removed model returns to its pose and motion</source>
        <translation>Nimmt das letzte scene.add, scene.remove oder scene.duplicate zurück: Was entfernt wurde, steht und bewegt sich wieder wie zuvor</translation>
    </message>
    <message>
        <source>Turns a model of the simulation in place</source>
        <translation>Dreht ein Modell der Simulation auf der Stelle</translation>
    </message>
    <message>
        <source>Undoes the last change of the scene, made by hand or by these commands</source>
        <translation>Nimmt das Letzte zurück, was von Hand oder mit diesen Befehlen an der Szene geändert wurde</translation>
    </message>
    <message>
        <source>Makes the present pose of an object its initial one in the text of the simulated scene; nothing is saved</source>
        <translation>Schreibt in den Text der simulierten Szene, dass ein Objekt dort beginnt, wo es jetzt ist; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Starts the game over: no goals, first half, nobody is penalized</source>
        <translation>Beginnt das Spiel von vorn: keine Tore, erste Halbzeit, niemand ist bestraft</translation>
    </message>
    <message>
        <source>Chooses whether the referee decides by itself: phases, goals, balls out, penalties</source>
        <translation>Wählt, ob der Schiedsrichter selbst entscheidet: Phasen, Tore, Bälle im Aus, Strafen</translation>
    </message>
    <message>
        <source>Ends the half</source>
        <translation>Beendet die Halbzeit</translation>
    </message>
    <message>
        <source>Gives a team the kick-off</source>
        <translation>Gibt einem Team den Anstoß</translation>
    </message>
    <message>
        <source>Sends the robots to their kick-off positions; starts a new half if one is over</source>
        <translation>Lässt die Roboter für einen Anstoß auf ihre Plätze gehen; nach dem Ende einer Halbzeit beginnt die nächste</translation>
    </message>
    <message>
        <source>Starts play</source>
        <translation>Lässt die Roboter spielen</translation>
    </message>
    <message>
        <source>Puts a penalized robot back into the game</source>
        <translation>Setzt einen bestraften Roboter wieder ins Spiel</translation>
    </message>
    <message>
        <source>Places the robots at their positions and the ball at the center; the robots wait</source>
        <translation>Setzt die Roboter auf ihre Plätze und den Ball in die Mitte; sie warten</translation>
    </message>
    <message>
        <source>Sets range, delay and losses of the radio between robots of a team</source>
        <translation>Stellt ein, wie Nachrichten in einem Team von Roboter zu Roboter kommen</translation>
    </message>
    <message>
        <source>Sets the goals of a team</source>
        <translation>Setzt die Tore eines Teams</translation>
    </message>
    <message>
        <source>Takes a robot out of the game for the time that the rules set</source>
        <translation>Nimmt einen Roboter für die Zeit aus dem Spiel, die die Regeln sagen</translation>
    </message>
    <message>
        <source>Runs a solution in the shadow of its task&apos;s active one, or stops it; what it publishes is under shadow/</source>
        <translation>Führt eine Lösung neben der aus, die für ihre Aufgabe benutzt wird, oder beendet das; was sie veröffentlicht, steht unter shadow/</translation>
    </message>
    <message>
        <source>Holds an actuator of the simulation at a value, regardless of the robot&apos;s program; omitted values of an actuator with several are 0</source>
        <translation>Hält einen Aktor der Simulation auf einem Wert, was das Programm des Roboters auch verlangt; bei mehreren Werten sind weggelassene 0</translation>
    </message>
    <message>
        <source>Changes the errors of a simulated sensor from now on; omitted ones stay as they are. Given the sensor alone, it measures the true values. Numbers are in the unit of its readings; cameras use only noise, delay, rate and dropout</source>
        <translation>Ändert von jetzt an Fehler eines Sensors der Simulation; was wegbleibt, bleibt, wie es ist. Mit dem Sensor allein misst er, was wahr ist. Zahlen sind in der Einheit seiner Messwerte; bei einer Kamera zählen nur noise, delay, rate und dropout</translation>
    </message>
    <message>
        <source>Pauses all views, while the robots continue</source>
        <translation>Hält alle Ansichten an, während die Roboter weiterlaufen</translation>
    </message>
</context>
<context>
    <name>Data</name>
    <message>
        <source>1 element</source>
        <translation>1 Element</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>%1, %2 to %3, mean %4</source>
        <translation>%1, %2 bis %3, Mittelwert %4</translation>
    </message>
    <message>
        <source>map of %1</source>
        <translation>Zuordnung von %1</translation>
    </message>
    <message>
        <source>list of %1</source>
        <translation>Liste von %1</translation>
    </message>
</context>
<context>
    <name>DrawingTip</name>
    <message>
        <source>stream %1</source>
        <translation>Strom %1</translation>
    </message>
    <message>
        <source>robot %1, debug key %2</source>
        <translation>Roboter %1, Debug-Schlüssel %2</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>circle at %1, diameter %2</source>
        <translation>Kreis bei %1, Durchmesser %2</translation>
    </message>
    <message>
        <source>robot %1, debug key %2, of %3 in the shadow</source>
        <translation>Roboter %1, Debug-Schlüssel %2, von %3 im Schatten</translation>
    </message>
</context>
<context>
    <name>FieldMarks</name>
    <message>
        <source>goal post</source>
        <translation>Torpfosten</translation>
    </message>
    <message>
        <source>field corner</source>
        <translation>Feldecke</translation>
    </message>
    <message>
        <source>wall corner</source>
        <translation>Bandenecke</translation>
    </message>
    <message>
        <source>halfway line</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>center circle</source>
        <translation>Mittelkreis</translation>
    </message>
    <message>
        <source>penalty corner</source>
        <translation>Strafraumecke</translation>
    </message>
    <message>
        <source>penalty at goal</source>
        <translation>Strafraum/Torlinie</translation>
    </message>
    <message>
        <source>beacon</source>
        <translation>Bake</translation>
    </message>
</context>
<context>
    <name>Gantt</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1, over: %2</source>
        <translation>%1, zu lang: %2</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, Frame %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>begins at %1 s</source>
        <translation>beginnt bei %1 s</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>dauert %1</translation>
    </message>
    <message>
        <source>, %1 % of the period of %2</source>
        <translation>, %1 % der Periode von %2</translation>
    </message>
    <message>
        <source>The frame overruns by %1.</source>
        <translation>Der Frame dauert %1 zu lang.</translation>
    </message>
</context>
<context>
    <name>Gizmo</name>
    <message>
        <source>%1: %2°</source>
        <translation>%1: %2°</translation>
    </message>
    <message>
        <source>%1: %2 m (%3)</source>
        <translation>%1: %2 m (%3)</translation>
    </message>
</context>
<context>
    <name>ImageHint</name>
    <message>
        <source>The log has no images up to this time. Its contents are shown in the views Data, Plots, Field and Scene.</source>
        <translation>Bis hierher gibt es in diesem Log keine Bilder. Was es hat, zeigen die Ansichten Daten, Kurven, Feld und Szene.</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot.</source>
        <translation>Kein Roboter. Starten Sie eine Simulation, oder verbinden Sie sich mit einem Roboter.</translation>
    </message>
    <message>
        <source>No image yet from %1</source>
        <translation>Noch kein Bild von %1</translation>
    </message>
    <message>
        <source>%1 has no camera. Choose another robot, or other images at the top. A simulated robot can be given a camera in the scene editor.</source>
        <translation>%1 hat keine Kamera. Wählen Sie einen anderen Roboter oder oben andere Bilder. Ein simulierter Roboter kann im Szeneneditor eine Kamera bekommen.</translation>
    </message>
    <message>
        <source>There is no robot in this scene. Add one, or a camera, by + in the view Scene, or choose other images at the top.</source>
        <translation>In dieser Szene ist kein Roboter. Fügen Sie mit + in der Ansicht Szene einen Roboter oder eine Kamera hinzu, oder wählen Sie oben andere Bilder.</translation>
    </message>
    <message>
        <source>There are no images of %1 in this scene. Choose others at the top.</source>
        <translation>In dieser Szene gibt es keine Bilder von %1. Wählen Sie oben andere.</translation>
    </message>
</context>
<context>
    <name>KeyValue</name>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>always</source>
        <translation>immer</translation>
    </message>
    <message>
        <source>n times</source>
        <translation>n-mal</translation>
    </message>
    <message>
        <source>every n-th</source>
        <translation>jedes n-te</translation>
    </message>
    <message>
        <source>every n ms</source>
        <translation>alle n ms</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>LinkWords</name>
    <message>
        <source>connecting…</source>
        <translation>verbindet…</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>waits for a client</source>
        <translation>wartet auf einen Client</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>%1; nothing new for %2 s</source>
        <translation>%1; nichts Neues seit %2 s</translation>
    </message>
    <message>
        <source>%1, %2 commands/s</source>
        <translation>%1, %2 Befehle/s</translation>
    </message>
</context>
<context>
    <name>LogJobs</name>
    <message>
        <source>%1: %2 in %3, %4</source>
        <translation>%1: %2 in %3, %4</translation>
    </message>
    <message>
        <source>1 message</source>
        <translation>1 Nachricht</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 Nachrichten</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 Frame</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Frames</translation>
    </message>
    <message>
        <source>%1 is called %2</source>
        <translation>%1 heißt %2</translation>
    </message>
    <message>
        <source>%1: images written: %2</source>
        <translation>%1: geschriebene Bilder: %2</translation>
    </message>
    <message>
        <source>%1: rows written: %2</source>
        <translation>%1: geschriebene Zeilen: %2</translation>
    </message>
    <message>
        <source>%1: texts written: %2</source>
        <translation>%1: geschriebene Texte: %2</translation>
    </message>
    <message>
        <source>A log is not repaired in place; choose another name.</source>
        <translation>Ein Log wird nicht an Ort und Stelle repariert; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1: %2 saved; %3 and %4 were lost</source>
        <translation>%1: %2 gerettet; %3 und %4 gingen verloren</translation>
    </message>
    <message>
        <source>1 chunk</source>
        <translation>1 Block</translation>
    </message>
    <message>
        <source>%1 chunks</source>
        <translation>%1 Blöcke</translation>
    </message>
</context>
<context>
    <name>LogOverview</name>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>wird geöffnet</translation>
    </message>
    <message>
        <source>reading times</source>
        <translation>Zeiten werden gelesen</translation>
    </message>
    <message>
        <source>reading messages</source>
        <translation>Nachrichten werden gelesen</translation>
    </message>
    <message>
        <source>counting sizes</source>
        <translation>Größen werden gezählt</translation>
    </message>
</context>
<context>
    <name>ManualControl</name>
    <message>
        <source>its %1 has no solution “obey”</source>
        <translation>seine Aufgabe %1 hat keine Lösung „obey“</translation>
    </message>
    <message>
        <source>The robot has not reported its behavior yet.</source>
        <translation>Der Roboter hat sein Verhalten noch nicht gemeldet.</translation>
    </message>
    <message>
        <source>Cannot be taken over: %1</source>
        <translation>Kann nicht übernommen werden: %1</translation>
    </message>
    <message>
        <source>Switching to %1…</source>
        <translation>Umschalten auf %1…</translation>
    </message>
    <message>
        <source>You steer the robot.</source>
        <translation>Der Roboter wird von hier gesteuert.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>%1 steers the robot.</source>
        <translation>%1 steuert den Roboter.</translation>
    </message>
</context>
<context>
    <name>MessageFields</name>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>ja oder nein</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>whole number, not negative</source>
        <translation>ganze Zahl, nicht negativ</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
</context>
<context>
    <name>OptionGraph</name>
    <message>
        <source>to %1: %2</source>
        <translation>nach %1: %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>OptionHistory</name>
    <message>
        <source>%1 for %2 s</source>
        <translation>%1 seit %2 s</translation>
    </message>
</context>
<context>
    <name>OwnModels</name>
    <message>
        <source>%1 (pose unknown)</source>
        <translation>%1 (Pose unbekannt)</translation>
    </message>
</context>
<context>
    <name>PlaceNotice</name>
    <message>
        <source>%1 is not localized yet, and is stopped: release its stop button or STOP, so that it can drive around.</source>
        <translation>%1 weiß noch nicht, wo er ist, und steht: den Stopptaster oder STOP lösen, damit er umherfahren kann.</translation>
    </message>
    <message>
        <source>%1 is not localized yet: switch its motors on (Robot state), then send it anywhere (G, and a click on the map). It drives around until it has localized itself.</source>
        <translation>%1 weiß noch nicht, wo er ist: die Motoren einschalten (Roboterzustand), dann irgendwohin schicken (G und ein Klick auf die Karte). Er fährt umher, bis er sich lokalisiert hat.</translation>
    </message>
    <message>
        <source>%1 is not localized yet: send it anywhere (G, and a click on the map), and it drives around until it has localized itself; or steer it with the motion tester.</source>
        <translation>%1 weiß noch nicht, wo er ist: irgendwohin schicken (G und ein Klick auf die Karte), dann fährt er umher, bis er sich lokalisiert hat; oder mit dem Bewegungstester steuern.</translation>
    </message>
    <message>
        <source>%1 has no map for localization: connect it again, and choose a map in the dialog (menu Robot, Connect a Pioneer…); a program that runs elsewhere is started with --map.</source>
        <translation>%1 hat keine Karte zur Lokalisierung: neu verbinden und dabei im Dialog eine Karte wählen (Menü Roboter, Mit einem Pioneer verbinden…); ein Programm, das anderswo läuft, wird mit --map gestartet.</translation>
    </message>
</context>
<context>
    <name>Platform</name>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse:</translation>
    </message>
    <message>
        <source>&amp;Camera:</source>
        <translation>&amp;Kamera:</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>Ver&amp;binden</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Host:</source>
        <translation>&amp;Rechner:</translation>
    </message>
    <message>
        <source>&amp;Layout:</source>
        <translation>&amp;Layout:</translation>
    </message>
    <message>
        <source>&amp;Map:</source>
        <translation>&amp;Karte:</translation>
    </message>
    <message>
        <source>&amp;Network (TCP)</source>
        <translation>&amp;Netzwerk (TCP)</translation>
    </message>
    <message>
        <source>&amp;Open scene…</source>
        <translation>&amp;Szene öffnen…</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>&amp;Port:</source>
        <translation>&amp;Port:</translation>
    </message>
    <message>
        <source>&amp;Serial</source>
        <translation>&amp;Seriell</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>8101 for the first robot, 8102 for the next</source>
        <translation>8101 ist der des ersten Roboters, 8102 der des nächsten</translation>
    </message>
    <message>
        <source>A map contains no robots: set how many to add.</source>
        <translation>Eine Karte hat keine eigenen Roboter: es wird keine geben.</translation>
    </message>
    <message>
        <source>A robot at a serial port of this computer</source>
        <translation>Ein Roboter an einer seriellen Schnittstelle dieses Rechners</translation>
    </message>
    <message>
        <source>A shipped scene by its name, or a file: an SDFormat world, or the map of a building (.map)</source>
        <translation>Eine mitgelieferte Szene nach ihrem Namen, oder eine Datei: eine SDFormat-Welt oder die Karte eines Gebäudes (.map)</translation>
    </message>
    <message>
        <source>A simulated robot, or one whose serial line a computer forwards</source>
        <translation>Ein simulierter Roboter, oder einer, dessen Leitung ein Rechner weiterleitet</translation>
    </message>
    <message>
        <source>Add:</source>
        <translation>Hinzufügen:</translation>
    </message>
    <message>
        <source>All, as many in each</source>
        <translation>Alle, in jedem gleich viele</translation>
    </message>
    <message>
        <source>Anyone who can reach this computer can then drive the robots: ARCOS has no password</source>
        <translation>Wer diesen Rechner erreicht, kann dann die Roboter fahren: ARCOS hat kein Passwort</translation>
    </message>
    <message>
        <source>Anyone who can reach this computer over the network will be able to drive these robots.</source>
        <translation>Wer diesen Rechner über das Netzwerk erreicht, kann diese Roboter fahren.</translation>
    </message>
    <message>
        <source>As set in the robot; Pioneers use 9600 by default</source>
        <translation>Wie im Roboter eingestellt; Pioneers beginnen mit 9600</translation>
    </message>
    <message>
        <source>Cameras of this computer; the device of another one can be typed</source>
        <translation>Kameras dieses Rechners; das Gerät einer anderen lässt sich eingeben</translation>
    </message>
    <message>
        <source>Can drive the robots over ARCOS</source>
        <translation>Können die Roboter über ARCOS fahren</translation>
    </message>
    <message>
        <source>Connect a &amp;Pioneer…</source>
        <translation>Mit einem &amp;Pioneer verbinden…</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>Mit einem Roboter verbinden</translation>
    </message>
    <message>
        <source>Connects a robot over TCP or a serial line, and runs its program here</source>
        <translation>Verbindet einen Roboter über TCP oder eine serielle Leitung und führt sein Programm hier aus</translation>
    </message>
    <message>
        <source>External programs</source>
        <translation>Externe Programme</translation>
    </message>
    <message>
        <source>First port:</source>
        <translation>Erster Port:</translation>
    </message>
    <message>
        <source>From other computers, too</source>
        <translation>Auch von anderen Rechnern</translation>
    </message>
    <message>
        <source>HOST:PORT, tcp://HOST[:PORT] or serial://DEVICE[?baud=RATE]; the list has the recent ones</source>
        <translation>HOST:PORT, tcp://HOST[:PORT] oder serial://DEVICE[?baud=RATE]; die Liste enthält die letzten</translation>
    </message>
    <message>
        <source>How many robots are added: at the map&apos;s home or the kick-off positions first, then where there is room</source>
        <translation>Wie viele Roboter hinzugefügt werden: zuerst am Startplatz der Karte oder auf den Anstoßpositionen, dann wo Platz ist</translation>
    </message>
    <message>
        <source>How the camera sends its images</source>
        <translation>Wie die Kamera ihre Bilder sendet</translation>
    </message>
    <message>
        <source>How the processes of the programs are executed: lockstep, one after another and reproducible; or threads, one each, with the layout&apos;s priorities</source>
        <translation>Wie die Prozesse der Programme ausgeführt werden: lockstep, nacheinander und reproduzierbar; oder threads, je einer, mit den Prioritäten des Layouts</translation>
    </message>
    <message>
        <source>Images per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Kind of the robots to add to the world; by default the kind of the robots in it</source>
        <translation>Art der Roboter, die der Welt hinzugefügt werden; als Vorgabe die der Roboter darin</translation>
    </message>
    <message>
        <source>Kind:</source>
        <translation>Art:</translation>
    </message>
    <message>
        <source>Line:</source>
        <translation>Leitung:</translation>
    </message>
    <message>
        <source>Map of the area where the robot drives, for localization; may be empty</source>
        <translation>Karte dessen, wo der Roboter fährt, zur Lokalisierung; darf leer sein</translation>
    </message>
    <message>
        <source>Maps (*.map)</source>
        <translation>Karten (*.map)</translation>
    </message>
    <message>
        <source>More images per second at large sizes, but lossy (JPEG)</source>
        <translation>Mehr Bilder pro Sekunde bei großen Formaten, mit den Verlusten von JPEG</translation>
    </message>
    <message>
        <source>Motion JPEG</source>
        <translation>Motion JPEG</translation>
    </message>
    <message>
        <source>Moved by their odometry, without forces</source>
        <translation>Nach ihrer Odometrie bewegt, ohne Kräfte</translation>
    </message>
    <message>
        <source>Name or address of the computer; localhost is this one</source>
        <translation>Name oder Adresse des Rechners; localhost ist dieser</translation>
    </message>
    <message>
        <source>Lossless, but few images per second at large sizes</source>
        <translation>Kein Verlust, aber wenige Bilder pro Sekunde bei großen Formaten</translation>
    </message>
    <message>
        <source>Open a Ca&amp;mera…</source>
        <translation>&amp;Kamera öffnen…</translation>
    </message>
    <message>
        <source>Open a camera</source>
        <translation>Eine Kamera öffnen</translation>
    </message>
    <message>
        <source>Opens a camera of this computer, to calibrate colors and to try perception</source>
        <translation>Öffnet eine Kamera dieses Rechners, um Farben zu kalibrieren und die Wahrnehmung zu erproben</translation>
    </message>
    <message>
        <source>Opens a scene or a map and adds robots to it</source>
        <translation>Öffnet eine Szene oder eine Karte und fügt ihr Roboter hinzu</translation>
    </message>
    <message>
        <source>Pixels; the camera uses the nearest size that it supports</source>
        <translation>Pixel; die Kamera nimmt die nächste Größe, die sie hat</translation>
    </message>
    <message>
        <source>Robots on wheels are moved by their odometry, without forces; faster with many robots: nothing slips, and obstacles stop them</source>
        <translation>Roboter auf Rädern werden nach ihrer Odometrie bewegt, ohne Kräfte; schneller bei vielen Robotern: nichts rutscht, und Hindernisse halten sie an</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Robots: switches the motors on as soon as it is connected</source>
        <translation>Roboter: schaltet die Motoren ein, sobald er verbunden ist</translation>
    </message>
    <message>
        <source>S&amp;imulate robots…</source>
        <translation>Roboter si&amp;mulieren…</translation>
    </message>
    <message>
        <source>Scene:</source>
        <translation>Szene:</translation>
    </message>
    <message>
        <source>Searches for cameras</source>
        <translation>Sucht Kameras</translation>
    </message>
    <message>
        <source>Searches for serial ports</source>
        <translation>Sucht serielle Schnittstellen</translation>
    </message>
    <message>
        <source>Seed of the simulation&apos;s noise</source>
        <translation>Startwert für das Rauschen der Simulation</translation>
    </message>
    <message>
        <source>Serial ports of this computer; another one can be typed</source>
        <translation>Serielle Schnittstellen dieses Rechners; eine andere lässt sich eingeben</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>TCP port at which external programs reach the first ARCOS robot; each further robot has the next port</source>
        <translation>TCP-Port des ersten Roboters, der ARCOS spricht, unter dem externe Programme ihn finden; der nächste Roboter hat den nächsten</translation>
    </message>
    <message>
        <source>Team of the added robots, if they play; red plays toward the sky-blue goal</source>
        <translation>Team der hinzugefügten Roboter, wenn sie spielen; Rot spielt auf das himmelblaue Tor</translation>
    </message>
    <message>
        <source>Teams:</source>
        <translation>Teams:</translation>
    </message>
    <message>
        <source>The program of each robot runs in its own process: if it crashes or hangs, only that robot stops</source>
        <translation>Das Programm jedes Roboters läuft in einem eigenen Prozess: stürzt es ab oder hängt es, steht nur dieser Roboter</translation>
    </message>
    <message>
        <source>Process layout (which process runs which tasks): a file or the name of a shipped one; empty: perception</source>
        <translation>Welcher Prozess welche Aufgaben erledigt: eine Layoutdatei oder der Name eines mitgelieferten; leer: perception</translation>
    </message>
    <message>
        <source>Process layout (which process runs which tasks): a file or the name of a shipped one; empty: the robot&apos;s</source>
        <translation>Welcher Prozess des Roboterprogramms welche Aufgaben erledigt: eine Layoutdatei oder der Name eines mitgelieferten; leer: das des Roboters</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>Worlds and maps (*.sdf *.world *.map)</source>
        <translation>Welten und Karten (*.sdf *.world *.map)</translation>
    </message>
    <message>
        <source>YUYV (uncompressed)</source>
        <translation>YUYV (unkomprimiert)</translation>
    </message>
    <message>
        <source>a Pioneer: tcp://HOST[:PORT], serial://DEVICE[?baud=RATE]</source>
        <translation>ein Pioneer: tcp://HOST[:PORT], serial://DEVICE[?baud=RATE]</translation>
    </message>
    <message>
        <source>a camera: camera:///dev/video0[?size=640x480&amp;rate=30&amp;format=YUYV]</source>
        <translation>eine Kamera: camera:///dev/video0[?size=640x480&amp;rate=30&amp;format=YUYV]</translation>
    </message>
    <message>
        <source>a layout file or the name of a shipped one; &apos;&apos;: the robot&apos;s</source>
        <translation>eine Layoutdatei oder der Name eines mitgelieferten; &apos;&apos;: das des Roboters</translation>
    </message>
    <message>
        <source>a map of the area where it drives, or &apos;&apos;</source>
        <translation>eine Karte dessen, wo er fährt, oder &apos;&apos;</translation>
    </message>
    <message>
        <source>as the camera takes them</source>
        <translation>wie die Kamera sie aufnimmt</translation>
    </message>
    <message>
        <source>at</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>baud</source>
        <translation>Baud</translation>
    </message>
    <message>
        <source>camera:///dev/video0?size=640x480&amp;rate=30&amp;format=YUYV; other names are the camera&apos;s controls, such as brightness=128; the list has the recent ones</source>
        <translation>camera:///dev/video0?size=640x480&amp;rate=30&amp;format=YUYV; andere Namen sind Einstellungen der Kamera, etwa brightness=128; die Liste enthält die letzten</translation>
    </message>
    <message>
        <source>images/s</source>
        <translation>Bilder/s</translation>
    </message>
    <message>
        <source>no camera found; plug one in, or type its device</source>
        <translation>keine Kamera gefunden; eine anschließen oder ihr Gerät eingeben</translation>
    </message>
    <message>
        <source>no serial port found; type its path</source>
        <translation>keine serielle Schnittstelle gefunden; ihren Pfad eingeben</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none: no localization in a map</source>
        <translation>keine: keine Lokalisierung in einer Karte</translation>
    </message>
    <message>
        <source>of the camera</source>
        <translation>der Kamera</translation>
    </message>
    <message>
        <source>of the robot</source>
        <translation>des Roboters</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>the token printed there, or &apos;&apos;</source>
        <translation>das dort ausgegeben wurde, oder &apos;&apos;</translation>
    </message>
    <message>
        <source>the camera&apos;s best</source>
        <translation>das beste, das die Kamera hat</translation>
    </message>
    <message>
        <source>the robot whose body it is; &apos;&apos;: the first one offered</source>
        <translation>wessen Körper es ist; &apos;&apos;: der erste, der angeboten wird</translation>
    </message>
    <message>
        <source>ws://HOST[:PORT]</source>
        <translation>ws://HOST[:PORT]</translation>
    </message>
    <message>
        <source>Sensors with noise</source>
        <translation>Sensoren mit Rauschen</translation>
    </message>
    <message>
        <source>Sensors, cameras and odometry have the errors set in the scene; otherwise they measure the true values</source>
        <translation>Sensoren, Kameras und Odometrie haben Fehler, wie die Szene sie angibt; ohne messen sie, was wahr ist</translation>
    </message>
    <message>
        <source>&amp;Kind:</source>
        <translation>&amp;Art:</translation>
    </message>
    <message>
        <source>La&amp;ser:</source>
        <translation>La&amp;ser:</translation>
    </message>
    <message>
        <source>Line of a SICK LMS 200, such as /dev/ttyUSB1; empty: the robot has none</source>
        <translation>Leitung eines SICK LMS 200, etwa /dev/ttyUSB1; leer: Der Roboter hat keinen</translation>
    </message>
    <message>
        <source>The robot&apos;s description: p3at, p3dx, peoplebot or one of your own</source>
        <translation>Die Beschreibung des Roboters: p3at, p3dx, peoplebot oder eine eigene</translation>
    </message>
    <message>
        <source>Folders in which model://NAME is searched first, with colons between them; the scene editor finds models there, too</source>
        <translation>Ordner, in denen model://NAME zuerst gesucht wird, durch Doppelpunkte getrennt; auch der Szeneneditor findet dort Modelle</translation>
    </message>
    <message>
        <source>How many threads share physics, sensors, images and the robots&apos; programs; the results are the same for any number</source>
        <translation>Wie viele Threads sich Physik, Sensoren, Bilder und die Programme der Roboter teilen; die Ergebnisse sind bei jeder Anzahl gleich</translation>
    </message>
    <message>
        <source>Models in:</source>
        <translation>Modelle in:</translation>
    </message>
    <message>
        <source>Threads:</source>
        <translation>Threads:</translation>
    </message>
    <message>
        <source>one per core</source>
        <translation>einer je Kern</translation>
    </message>
    <message>
        <source>the scene&apos;s folder and the usual ones</source>
        <translation>dem Ordner der Szene und den üblichen</translation>
    </message>
</context>
<context>
    <name>PlotChoices</name>
    <message>
        <source>Its debug key is off; adding the curve switches it on.</source>
        <translation>Der Debug-Schlüssel ist aus; das Hinzufügen der Kurve schaltet ihn ein.</translation>
    </message>
    <message>
        <source>No running solution provides it; see the view Solutions.</source>
        <translation>Es läuft keine Lösung, die das hat; siehe die Ansicht Lösungen.</translation>
    </message>
    <message>
        <source>Its contents are known once it has been played.</source>
        <translation>Der Inhalt ist bekannt, sobald es zum ersten Mal abgespielt wurde.</translation>
    </message>
    <message>
        <source>The log has it at other times; its curve is read from the file.</source>
        <translation>Das Log enthält es zu anderen Zeiten; die Kurve wird aus der Datei gelesen.</translation>
    </message>
</context>
<context>
    <name>PlotReader</name>
    <message>
        <source>nothing is published on %1</source>
        <translation>auf %1 wird nichts veröffentlicht</translation>
    </message>
</context>
<context>
    <name>PointFilter</name>
    <message>
        <source>average</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>derivative</source>
        <translation>Ableitung</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>integral</source>
        <translation>Integral</translation>
    </message>
    <message>
        <source>is added</source>
        <translation>wird addiert</translation>
    </message>
    <message>
        <source>low-pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skalierung</translation>
    </message>
</context>
<context>
    <name>PoseCapture</name>
    <message>
        <source>Capture pose</source>
        <translation>Pose erfassen</translation>
    </message>
    <message>
        <source>Key frame %1 of %2 added</source>
        <translation>Keyframe %1 von %2 hinzugefügt</translation>
    </message>
</context>
<context>
    <name>PropertyRule</name>
    <message>
        <source>%1 must be above %2 and at most %3 %4</source>
        <translation>%1 muss über %2 und höchstens %3 %4 sein</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3 %4</source>
        <translation>%1 muss zwischen %2 und %3 %4 liegen</translation>
    </message>
    <message>
        <source>%1 takes %2 numbers, separated by blanks; %3 were typed</source>
        <translation>%1 hat %2 Zahlen, durch Leerzeichen getrennt; eingegeben wurden %3</translation>
    </message>
    <message>
        <source>%1 is not a number; use a point as the decimal separator</source>
        <translation>%1 ist keine Zahl; das Dezimaltrennzeichen ist ein Punkt</translation>
    </message>
    <message>
        <source>These moments of inertia are impossible: about the principal axes they must be positive, and none may exceed the sum of the other two</source>
        <translation>Kein Körper hat diese Trägheitsmomente: Um seine Hauptachsen sind sie positiv, und keines der drei ist größer als die Summe der beiden anderen</translation>
    </message>
    <message>
        <source>%1 takes %2 number; %3 were typed</source>
        <translation>%1 hat %2 Zahl; %3 wurden eingegeben</translation>
    </message>
</context>
<context>
    <name>QLabel</name>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>true</source>
        <comment>legend of the field</comment>
        <translation>wahr</translation>
    </message>
    <message>
        <source>estimated</source>
        <comment>legend of the field</comment>
        <translation>geschätzt</translation>
    </message>
    <message>
        <source>no way</source>
        <translation>kein Weg</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>goal, why it cannot be reached</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Home</source>
        <comment>place of a map</comment>
        <translation>Startplatz</translation>
    </message>
    <message>
        <source>Dock</source>
        <comment>place of a map</comment>
        <translation>Ladestation</translation>
    </message>
    <message>
        <source>connection closed</source>
        <translation>Verbindung geschlossen</translation>
    </message>
    <message>
        <source>new connection</source>
        <translation>neue Verbindung</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 Byte</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <comment>error on the field</comment>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>Radar</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>both sides are stalled</source>
        <translation>beide Seiten sind blockiert</translation>
    </message>
    <message>
        <source>the left side is stalled</source>
        <translation>die linke Seite ist blockiert</translation>
    </message>
    <message>
        <source>the right side is stalled</source>
        <translation>die rechte Seite ist blockiert</translation>
    </message>
    <message>
        <source>a front bumper is pressed</source>
        <translation>ein vorderer Stoßfänger ist gedrückt</translation>
    </message>
    <message>
        <source>a rear bumper is pressed</source>
        <translation>ein hinterer Stoßfänger ist gedrückt</translation>
    </message>
</context>
<context>
    <name>RobotCard</name>
    <message>
        <source>program ended</source>
        <translation>Programm beendet</translation>
    </message>
    <message>
        <source>program does not answer</source>
        <translation>Programm antwortet nicht</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>stopped: STOP is engaged</source>
        <translation>steht: STOP ist ausgelöst</translation>
    </message>
    <message>
        <source>stopped: emergency stop on the robot</source>
        <translation>steht: Not-Halt am Roboter</translation>
    </message>
    <message>
        <source>silent for %1 s</source>
        <translation>schweigt seit %1 s</translation>
    </message>
    <message>
        <source>waits for its program</source>
        <translation>wartet auf sein Programm</translation>
    </message>
    <message>
        <source>no frame for %1 s</source>
        <translation>seit %1 s kein Frame</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>log, playing</source>
        <translation>Log, spielt ab</translation>
    </message>
    <message>
        <source>log, paused</source>
        <translation>Log, angehalten</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>simulated here</source>
        <translation>hier simuliert</translation>
    </message>
    <message>
        <source>battery: %1</source>
        <translation>Akku: %1</translation>
    </message>
</context>
<context>
    <name>Silence</name>
    <message>
        <source>%1 last heard %2 s ago</source>
        <translation>%1, zuletzt vor %2 s gehört</translation>
    </message>
</context>
<context>
    <name>SpectrumCanvas</name>
    <message>
        <source>Hann</source>
        <translation>Hann</translation>
    </message>
    <message>
        <source>none (rectangle)</source>
        <translation>keines (Rechteck)</translation>
    </message>
    <message>
        <source>Hamming</source>
        <translation>Hamming</translation>
    </message>
    <message>
        <source>Blackman</source>
        <translation>Blackman</translation>
    </message>
    <message>
        <source>flat top</source>
        <translation>Flat-Top</translation>
    </message>
</context>
<context>
    <name>Steering</name>
    <message>
        <source>Nobody steers %1.</source>
        <translation>Niemand steuert %1.</translation>
    </message>
    <message>
        <source>You steer %1.</source>
        <translation>%1 wird von hier gesteuert.</translation>
    </message>
    <message>
        <source>%1 was steering %2, and has stopped responding.</source>
        <translation>%1 hat %2 gesteuert und meldet sich nicht mehr.</translation>
    </message>
    <message>
        <source>%1 steers %2.</source>
        <translation>%1 steuert %2.</translation>
    </message>
    <message>
        <source>A user at the robot&apos;s own computer</source>
        <translation>Jemand am Rechner des Roboters</translation>
    </message>
</context>
<context>
    <name>Stop</name>
    <message>
        <source>STOPPED: click to release</source>
        <translation>GESTOPPT: zum Lösen klicken</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
</context>
<context>
    <name>StreamAskers</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>nothing for %1 s</source>
        <translation>%1 s lang nichts</translation>
    </message>
    <message>
        <source>images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>warnings: %1, errors: %2</source>
        <translation>Warnungen: %1, Fehler: %2</translation>
    </message>
    <message>
        <source>no values here</source>
        <translation>hier keine Werte</translation>
    </message>
    <message>
        <source>on disk; look there with the timeline</source>
        <translation>auf der Platte; dort mit der Zeitleiste ansehen</translation>
    </message>
    <message>
        <source>being read from disk</source>
        <translation>wird von der Platte gelesen</translation>
    </message>
    <message>
        <source>lost, since the disk was too slow</source>
        <translation>verloren, weil die Platte zu langsam war</translation>
    </message>
</context>
<context>
    <name>TrainingPanel</name>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>How far a sample reaches in Cb and Cr, in values of a channel</source>
        <translation>Wie weit eine Probe in Cb und Cr reicht, in Werten eines Kanals</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Weight of a difference in Y, relative to Cb or Cr; small: light and shadow matter less</source>
        <translation>Gewicht eines Unterschieds in Y, im Verhältnis zu Cb oder Cr; klein: Licht und Schatten zählen weniger</translation>
    </message>
    <message>
        <source>Rejection</source>
        <translation>Zurückweisung</translation>
    </message>
    <message>
        <source>Minimum votes for a class; larger: more colors have no class</source>
        <translation>Stimmen, die eine Klasse mindestens braucht; größer: mehr Farben gehören zu keiner Klasse</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Weight of a background sample, relative to one of a class</source>
        <translation>Gewicht einer Probe des Hintergrunds, im Verhältnis zu der einer Klasse</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>How much a sample supports its color in shadow and glare, where no other is near</source>
        <translation>Wie stark eine Probe ihre Farbe in Schatten und Glanzlicht unterstützt, wo keine andere in der Nähe ist</translation>
    </message>
    <message>
        <source>Gray guard</source>
        <translation>Grauschutz</translation>
    </message>
    <message>
        <source>Confidence that nearly gray colors, like those of walls and shadows, need to count as ball, goal or robot</source>
        <translation>Wie sicher die Farbe eines Balls, eines Tors oder eines Roboters sein muss, wo sie fast grau ist wie Wände und Schatten</translation>
    </message>
    <message>
        <source>Distance²</source>
        <translation>Abstand²</translation>
    </message>
    <message>
        <source>Squared Mahalanobis distance beyond which a color has no class</source>
        <translation>Quadrierter Mahalanobis-Abstand, jenseits dessen eine Farbe zu keiner Klasse gehört</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>Cost of a misclassified sample; larger: follows single samples more closely</source>
        <translation>Kosten einer Probe auf der falschen Seite; größer: folgt einzelnen Proben genauer</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>How narrow the functions around samples are; larger: narrower</source>
        <translation>Wie schmal die Funktionen um die Proben sind; größer: schmaler</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>A color farther than this from all samples has no class</source>
        <translation>Eine Farbe, die von allen Proben weiter entfernt ist, gehört zu keiner Klasse</translation>
    </message>
</context>
<context>
    <name>View</name>
    <message>
        <source>Find frames</source>
        <translation>Bilder finden</translation>
    </message>
    <message>
        <source>Finds the images of a log where the color table looks most suspicious</source>
        <translation>Findet die Bilder eines Logs, in denen die Farbtabelle am verdächtigsten aussieht</translation>
    </message>
    <message>
        <source>Color image</source>
        <translation>Farbbild</translation>
    </message>
    <message>
        <source>Draw strokes in images and see how the color table classifies them</source>
        <translation>Striche in Bilder zeichnen und sehen, wie die Farbtabelle sie klassifiziert</translation>
    </message>
    <message>
        <source>Compare tables</source>
        <translation>Tabellen vergleichen</translation>
    </message>
    <message>
        <source>Compares the color table with another one, or with itself some steps ago</source>
        <translation>Vergleicht die Farbtabelle mit einer anderen oder mit ihrem Stand vor einigen Schritten</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Shows how good the color table is: recall, confusion and false colors.</source>
        <translation>Zeigt, wie gut die Farbtabelle ist: Trefferquote, Verwechslungen und falsche Farben.</translation>
    </message>
    <message>
        <source>Color classes</source>
        <translation>Farbklassen</translation>
    </message>
    <message>
        <source>Chooses the class of strokes, keeps samples in files, and sets how the color table is made from them.</source>
        <translation>Wählt die Klasse der Striche, verwaltet Proben in Dateien und legt fest, wie daraus die Farbtabelle entsteht.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Lists the strokes that the color table is made from, and the history of their changes.</source>
        <translation>Listet die Striche auf, aus denen die Farbtabelle entsteht, und den Verlauf ihrer Änderungen.</translation>
    </message>
    <message>
        <source>Color space</source>
        <translation>Farbraum</translation>
    </message>
    <message>
        <source>Pixels, samples and the table&apos;s classes in the three dimensions of color</source>
        <translation>Pixel, Proben und die Klassen der Tabelle in den drei Dimensionen der Farbe</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Runs typed commands and shows their results.</source>
        <translation>Führt eingegebene Befehle aus und zeigt ihr Ergebnis.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Shows the messages of all streams with all their fields, and compares them.</source>
        <translation>Zeigt die Nachrichten aller Datenströme mit allen Feldern und vergleicht sie.</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>Roboterzustand</translation>
    </message>
    <message>
        <source>Battery, motors, bumpers, odometry and line of a robot on wheels.</source>
        <translation>Akku, Motoren, Stoßfänger, Odometrie und Leitung eines Roboters auf Rädern.</translation>
    </message>
    <message>
        <source>Radar</source>
        <translation>Radar</translation>
    </message>
    <message>
        <source>What sonars, laser and bumpers of a robot on wheels measure around it.</source>
        <translation>Was Sonare, Laser und Stoßfänger eines Roboters auf Rädern um ihn herum messen.</translation>
    </message>
    <message>
        <source>Field and map</source>
        <translation>Feld und Karte</translation>
    </message>
    <message>
        <source>The field or the building from above: true and estimated poses, goals, and drawings</source>
        <translation>Das Feld oder das Gebäude von oben: wahre und geschätzte Posen, Ziele und Zeichnungen</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Images with the drawings of what the program sees in them</source>
        <translation>Bilder mit Zeichnungen dessen, was das Programm darin sieht</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Shows all joints of a robot, turns single ones, and captures poses for motions.</source>
        <translation>Zeigt alle Gelenke eines Roboters, dreht einzelne und erfasst Posen für Bewegungen.</translation>
    </message>
    <message>
        <source>Debug keys</source>
        <translation>Debug-Schlüssel</translation>
    </message>
    <message>
        <source>Switches what the robot&apos;s processes publish: drawings, images, plots.</source>
        <translation>Schaltet, was die Prozesse des Roboters veröffentlichen: Zeichnungen, Bilder, Kurven.</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Lists the bookmarks of the open logs; lets you jump to them, edit and remove them.</source>
        <translation>Listet die Lesezeichen der offenen Logs auf; sie lassen sich anspringen, bearbeiten und entfernen.</translation>
    </message>
    <message>
        <source>Packages</source>
        <translation>Pakete</translation>
    </message>
    <message>
        <source>Chooses which packages of a log are recomputed by the program, and shows how they differ from what was logged.</source>
        <translation>Wählt, welche Pakete eines Logs vom Programm neu berechnet werden, und zeigt, wie sie vom Aufgezeichneten abweichen.</translation>
    </message>
    <message>
        <source>Streams</source>
        <translation>Datenströme</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Shows the robots&apos; text messages, with filters and a search.</source>
        <translation>Zeigt die Textmeldungen der Roboter, mit Filtern und Suche.</translation>
    </message>
    <message>
        <source>Motion tester</source>
        <translation>Bewegungstester</translation>
    </message>
    <message>
        <source>Takes over the robot and steers it with mouse, keys or gamepad.</source>
        <translation>Übernimmt den Roboter und steuert ihn mit Maus, Tasten und Gamepad.</translation>
    </message>
    <message>
        <source>Motion editor</source>
        <translation>Bewegungseditor</translation>
    </message>
    <message>
        <source>Edits key-frame motions as text, as a table and over time, and plays them on the robot.</source>
        <translation>Bearbeitet Keyframe-Bewegungen als Text, als Tabelle und über der Zeit und spielt sie auf dem Roboter ab.</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Datenpakete</translation>
    </message>
    <message>
        <source>Shows the decoded packets from and to a robot; saves and replays conversations.</source>
        <translation>Zeigt die dekodierten Datenpakete vom und zum Roboter; speichert Kommunikation und spielt sie ab.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Draws plot values and numbers of any stream over time.</source>
        <translation>Zeichnet Kurvenwerte und Zahlen beliebiger Datenströme über der Zeit.</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Prozesse</translation>
    </message>
    <message>
        <source>Shows the robot&apos;s processes, the packages between them and their rates.</source>
        <translation>Zeigt die Prozesse des Roboters, die Pakete zwischen ihnen und ihre Raten.</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Laufzeiten</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>The world in three dimensions, with the robots&apos; drawings</source>
        <translation>Die Welt in drei Dimensionen, mit den Zeichnungen der Roboter</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Searches whole logs for conditions and texts, without playing them.</source>
        <translation>Durchsucht ganze Logs nach Bedingungen und Texten, ohne sie abzuspielen.</translation>
    </message>
    <message>
        <source>Solutions</source>
        <translation>Lösungen</translation>
    </message>
    <message>
        <source>Chooses how each task of the robot is done, and sets the parameters.</source>
        <translation>Wählt, wie jede Aufgabe des Roboters gelöst wird, und setzt die Parameter.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Shows logs over time: images, messages, warnings, bookmarks; lets you jump, select, cut and export. Of live robots, lets you look back while they continue.</source>
        <translation>Zeigt Logs über der Zeit: Bilder, Meldungen, Warnungen, Lesezeichen; zum Springen, Auswählen, Schneiden und Exportieren. Bei laufenden Robotern ein Blick zurück, während sie weiterlaufen.</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Shows all robots with image, state, battery and link; a click selects one.</source>
        <translation>Zeigt alle Roboter mit Bild, Zustand, Akku und Verbindung; ein Klick wählt einen aus.</translation>
    </message>
    <message>
        <source>Lists the streams of logs and live robots with rates, sizes, what was left out, and who asked for them.</source>
        <translation>Listet die Datenströme von Logs und laufenden Robotern mit Raten, Größen, Ausgelassenem, und wer sie angefordert hat.</translation>
    </message>
    <message>
        <source>Shows how long processes and tasks take, as a chart of the last seconds and as statistics, and how long images take to become commands.</source>
        <translation>Zeigt, wie lange Prozesse und Aufgaben brauchen, als Diagramm der letzten Sekunden und als Statistik, und wie lange es vom Bild bis zum Befehl dauert.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Calibrates a camera: its lens with a chessboard, its pose with a board or field marks; and sets its exposure, gain and white balance</source>
        <translation>Kalibriert eine Kamera: ihr Objektiv mit einem Schachbrett, ihre Lage mit einem Brett oder mit Marken des Feldes; und ändert Belichtung, Verstärkung und Weißabgleich</translation>
    </message>
    <message>
        <source>Column graph</source>
        <translation>Säulendiagramm</translation>
    </message>
    <message>
        <source>The values of a list as columns, such as those of a laser</source>
        <translation>Die Werte einer Liste als Säulen, etwa die eines Lasers</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Pose, mass, size, friction and noise of the selected object of the scene</source>
        <translation>Pose, Masse, Größe, Reibung und Rauschen des ausgewählten Objekts der Szene</translation>
    </message>
    <message>
        <source>Scene tree</source>
        <translation>Szenenbaum</translation>
    </message>
    <message>
        <source>All objects of a simulated scene, with the values of sensors and sliders for actuators</source>
        <translation>Alle Objekte einer simulierten Szene, mit den Werten der Sensoren und Reglern für Aktoren</translation>
    </message>
    <message>
        <source>Scene editor</source>
        <translation>Szeneneditor</translation>
    </message>
    <message>
        <source>Edits the files of simulated scenes, and applies the changes to the running simulation.</source>
        <translation>Bearbeitet die Dateien simulierter Szenen und lässt die Simulation mit den Änderungen weiterlaufen.</translation>
    </message>
    <message>
        <source>Game</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Shows score, time and penalties of a simulated game, and lets you referee it.</source>
        <translation>Zeigt Spielstand, Zeit und Strafen eines simulierten Spiels und lässt Sie Schiedsrichter sein.</translation>
    </message>
    <message>
        <source>Behavior</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>Shows the options and states of the robot&apos;s behavior, what is active and why.</source>
        <translation>Zeigt die Optionen und Zustände des Verhaltens des Roboters, was aktiv ist und warum.</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Shows the errors of the robot&apos;s percepts and models against the simulator&apos;s ground truth, for each solution.</source>
        <translation>Zeigt für jede Lösung, wie weit Perzepte und Modelle des Roboters von der Wahrheit abweichen, die der Simulator kennt.</translation>
    </message>
</context>
<context>
    <name>app::AppearanceMenu</name>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Darstellung</translation>
    </message>
    <message>
        <source>Same as the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>Size of texts</source>
        <translation>Größe der Texte</translation>
    </message>
    <message>
        <source>100 % (as the system)</source>
        <translation>100 % (wie das System)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>app::ColorTableButton</name>
    <message>
        <source>Color table in use</source>
        <translation>Verwendete Farbtabelle</translation>
    </message>
    <message>
        <source>Colors: %1</source>
        <translation>Farben: %1</translation>
    </message>
    <message>
        <source>The robot&apos;s program uses its built-in color table, made from the field&apos;s colors</source>
        <translation>Das Programm des Roboters verwendet seine eingebaute Farbtabelle, die aus den Farben des Felds entstand</translation>
    </message>
    <message>
        <source>The color table that the robot&apos;s program uses: %1</source>
        <translation>Die Farbtabelle, die das Programm des Roboters verwendet: %1</translation>
    </message>
    <message>
        <source>loaded %1</source>
        <translation>geladen %1</translation>
    </message>
    <message>
        <source>Click to use another one</source>
        <translation>Klicken, um eine andere zu verwenden</translation>
    </message>
</context>
<context>
    <name>app::CommandPalette</name>
    <message>
        <source>Command or menu entry</source>
        <translation>Befehl oder Menüeintrag</translation>
    </message>
    <message>
        <source>What to do: words of a command or menu entry</source>
        <translation>Was zu tun ist: Wörter eines Befehls oder Menüeintrags</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>Was als Nächstes kommt</translation>
    </message>
    <message>
        <source>Commands and menu entries</source>
        <translation>Befehle und Menüeinträge</translation>
    </message>
    <message>
        <source>used before</source>
        <translation>schon verwendet</translation>
    </message>
    <message>
        <source>No match. Try fewer or shorter words.</source>
        <translation>Nichts heißt so. Kürzere Wörter finden mehr.</translation>
    </message>
    <message>
        <source>Return runs it.</source>
        <translation>Die Eingabetaste führt es aus.</translation>
    </message>
    <message>
        <source>Go to: words of a view&apos;s title</source>
        <translation>Wohin: Wörter aus dem Titel einer Ansicht</translation>
    </message>
</context>
<context>
    <name>app::FailedView</name>
    <message>
        <source>This view has failed: %1.
Close and reopen it to try again; if it belongs to a plug-in, report this to its author.</source>
        <translation>Diese Ansicht ist ausgefallen: %1.
Schließen und wieder öffnen, um es noch einmal zu versuchen; gehört sie zu einem Plug-in, dies dessen Autor melden.</translation>
    </message>
</context>
<context>
    <name>app::FieldEditor</name>
    <message>
        <source>Chooses a file</source>
        <translation>Wählt eine Datei</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>app::FoundRobots</name>
    <message>
        <source>body only: its program can run on this computer</source>
        <translation>nur der Körper: sein Programm kann hier laufen</translation>
    </message>
    <message>
        <source>layout %1</source>
        <translation>Layout %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Robots on the network</source>
        <translation>Roboter im Netzwerk</translation>
    </message>
    <message>
        <source>On the network</source>
        <translation>Im Netzwerk</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läuft mit</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Heard for</source>
        <translation>Gehört seit</translation>
    </message>
    <message>
        <source>Encrypted. The announced fingerprint is %1; the real one is shown when you connect</source>
        <translation>Verschlüsselt. Der Fingerabdruck soll %1 sein; beim Verbinden wird der wirkliche gezeigt</translation>
    </message>
    <message>
        <source>Not encrypted</source>
        <translation>Nicht verschlüsselt</translation>
    </message>
    <message>
        <source>Time since the robot was first found</source>
        <translation>Seit es hier zum ersten Mal gehört wurde</translation>
    </message>
    <message>
        <source>Listening for robots on the network…</source>
        <translation>Hört auf Roboter im Netzwerk…</translation>
    </message>
    <message>
        <source>No robots found. Robots announce themselves if they were started with --listen and a network address, such as --listen 0.0.0.0:8765.</source>
        <translation>Kein Roboter kündigt sich an. Roboter tun das, wenn sie mit --listen und einer Adresse des Netzwerks gestartet wurden, etwa --listen 0.0.0.0:8765.</translation>
    </message>
</context>
<context>
    <name>app::HistoryLine</name>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>&amp;Pause what is shown</source>
        <translation>Gezeigtes an&amp;halten</translation>
    </message>
    <message>
        <source>All views show one instant, while the robots continue. What you switch, tune or steer acts on the robots as they are now.</source>
        <translation>Alle Ansichten zeigen einen Augenblick, während die Roboter weiterlaufen. Schalten, Einstellen und Steuern wirkt auf die Roboter, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>Step &amp;forward</source>
        <translation>Schritt &amp;vor</translation>
    </message>
    <message>
        <source>&amp;1 s back</source>
        <translation>&amp;1 s zurück</translation>
    </message>
    <message>
        <source>1 &amp;s forward</source>
        <translation>1 &amp;s vor</translation>
    </message>
    <message>
        <source>Return to &amp;now</source>
        <translation>Zurück zu &amp;jetzt</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>%1 s behind, reading…</source>
        <translation>%1 s zurück, wird gelesen…</translation>
    </message>
    <message>
        <source>%1 s behind live</source>
        <translation>%1 s hinter live</translation>
    </message>
    <message>
        <source>What is shown: live</source>
        <translation>Was gezeigt wird: live</translation>
    </message>
    <message>
        <source>What is shown: %1</source>
        <translation>Was gezeigt wird: %1</translation>
    </message>
    <message>
        <source>Pauses all views, while the robots continue (Ctrl+Space)</source>
        <translation>Hält an, was alle Ansichten zeigen, während die Roboter weiterlaufen (Strg+Leertaste)</translation>
    </message>
    <message>
        <source>Returns to what happens now (Ctrl+Space).
The robots continue: what you switch, tune or steer acts on them as they are now.</source>
        <translation>Kehrt zu dem zurück, was jetzt geschieht (Strg+Leertaste).
Die Roboter laufen weiter: Schalten, Einstellen und Steuern wirkt auf sie, wie sie jetzt sind.</translation>
    </message>
</context>
<context>
    <name>app::LanguageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>Spr&amp;ache</translation>
    </message>
    <message>
        <source>Same as the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>The language of the window from the next start on; commands and scripts do not change</source>
        <translation>Die Sprache des Fensters ab dem nächsten Start; Befehle und Skripte bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Restart RobotControl to see the window in the chosen language.</source>
        <translation>Das Fenster ist ab dem nächsten Start von RobotControl in der gewählten Sprache.</translation>
    </message>
</context>
<context>
    <name>app::LeftOpenBar</name>
    <message>
        <source>What was open</source>
        <translation>Was offen war</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Wieder öffnen</translation>
    </message>
    <message>
        <source>Opens what was open before, in place of what is open now</source>
        <translation>Öffnet, was vorher offen war, anstelle dessen, was hier läuft</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hides this</source>
        <translation>Blendet dies aus</translation>
    </message>
    <message>
        <source>RobotControl did not end properly while %1 was open.</source>
        <translation>RobotControl wurde nicht ordnungsgemäß beendet, während %1 offen war.</translation>
    </message>
    <message>
        <source>RobotControl did not end properly while %1 and %2 more were open.</source>
        <translation>RobotControl wurde nicht ordnungsgemäß beendet, während %1 und %2 weitere offen waren.</translation>
    </message>
</context>
<context>
    <name>app::LightMenu</name>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Licht</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Brightness of all light, relative to the scene&apos;s</source>
        <translation>Helligkeit allen Lichts, im Verhältnis zu der der Szene</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>2</source>
        <translation>2</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>Warmth</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>Color of all light: above 0 reddish like bulbs, below 0 bluish like the sky</source>
        <translation>Farbe allen Lichts: über 0 rötlich wie Glühlampen, unter 0 bläulich wie der Himmel</translation>
    </message>
    <message>
        <source>bluish</source>
        <translation>bläulich</translation>
    </message>
    <message>
        <source>reddish</source>
        <translation>rötlich</translation>
    </message>
    <message>
        <source>As in the &amp;scene</source>
        <translation>Wie in der &amp;Szene</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>&amp;Heller</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>&amp;Dunkler</translation>
    </message>
    <message>
        <source>&amp;Warmer</source>
        <translation>&amp;Wärmer</translation>
    </message>
    <message>
        <source>&amp;Cooler</source>
        <translation>&amp;Kühler</translation>
    </message>
    <message>
        <source>Darker and w&amp;armer</source>
        <translation>Dunkler &amp;und wärmer</translation>
    </message>
    <message>
        <source>Brightness %1, warmth %2</source>
        <translation>Helligkeit %1, Wärme %2</translation>
    </message>
</context>
<context>
    <name>app::LogContentsBar</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Streams</source>
        <translation>Datenströme</translation>
    </message>
    <message>
        <source>Shows the view that lists all streams with their types</source>
        <translation>Zeigt die Ansicht, die alle Datenströme mit ihren Typen auflistet</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Shows the view that plots numbers of the streams</source>
        <translation>Zeigt die Ansicht, die Zahlen der Datenströme als Kurven zeichnet</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 holds no messages.</source>
        <translation>%1 enthält keine Nachrichten.</translation>
    </message>
    <message>
        <source>%1 contains no known robot, so no program runs on it.</source>
        <translation>%1 enthält keinen hier bekannten Roboter, daher läuft kein Programm darauf.</translation>
    </message>
    <message>
        <source>It holds %1.</source>
        <translation>Es enthält %1.</translation>
    </message>
    <message>
        <source>Not decoded: %1.</source>
        <translation>Nicht dekodiert: %1.</translation>
    </message>
</context>
<context>
    <name>app::LogOpening</name>
    <message>
        <source>Open &amp;log…</source>
        <translation>&amp;Log öffnen…</translation>
    </message>
    <message>
        <source>&amp;Add log…</source>
        <translation>Log hin&amp;zufügen…</translation>
    </message>
    <message>
        <source>Adds a log to the timeline</source>
        <translation>Fügt der Zeitleiste ein Log hinzu</translation>
    </message>
    <message>
        <source>&amp;Recent logs</source>
        <translation>Zuletzt &amp;geöffnete Logs</translation>
    </message>
    <message>
        <source>&amp;Close log</source>
        <translation>Log sc&amp;hließen</translation>
    </message>
    <message>
        <source>Add a log</source>
        <translation>Ein Log hinzufügen</translation>
    </message>
    <message>
        <source>Open a log</source>
        <translation>Ein Log öffnen</translation>
    </message>
    <message>
        <source>Logs and videos (*.mcap *.log *.mp4 *.mov *.avi *.mkv *.webm *.mpg)</source>
        <translation>Logs und Videos (*.mcap *.log *.mp4 *.mov *.avi *.mkv *.webm *.mpg)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>app::LogToolBar</name>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plays the log, or pauses it</source>
        <translation>Spielt das Log ab oder hält es an</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Pauses at the start of the log</source>
        <translation>Hält am Anfang des Logs an</translation>
    </message>
    <message>
        <source>Frame back</source>
        <translation>Frame zurück</translation>
    </message>
    <message>
        <source>Back one frame of the process</source>
        <translation>Einen Frame des Prozesses zurück</translation>
    </message>
    <message>
        <source>Frame forward</source>
        <translation>Frame vor</translation>
    </message>
    <message>
        <source>Forward one frame of the process</source>
        <translation>Einen Frame des Prozesses vor</translation>
    </message>
    <message>
        <source>Message back</source>
        <translation>Nachricht zurück</translation>
    </message>
    <message>
        <source>Message forward</source>
        <translation>Nachricht vor</translation>
    </message>
    <message>
        <source>10 frames back</source>
        <translation>10 Frames zurück</translation>
    </message>
    <message>
        <source>Back ten frames of the process</source>
        <translation>Zehn Frames des Prozesses zurück</translation>
    </message>
    <message>
        <source>10 frames forward</source>
        <translation>10 Frames vor</translation>
    </message>
    <message>
        <source>Forward ten frames of the process</source>
        <translation>Zehn Frames des Prozesses vor</translation>
    </message>
    <message>
        <source>1 s back</source>
        <translation>1 s zurück</translation>
    </message>
    <message>
        <source>Back one second</source>
        <translation>Eine Sekunde zurück</translation>
    </message>
    <message>
        <source>1 s forward</source>
        <translation>1 s vor</translation>
    </message>
    <message>
        <source>Forward one second</source>
        <translation>Eine Sekunde vor</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Jumps to the start of the log</source>
        <translation>Springt zum Anfang des Logs</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>Jumps to the end of the log</source>
        <translation>Springt zum Ende des Logs</translation>
    </message>
    <message>
        <source>Start range here</source>
        <translation>Bereich hier beginnen</translation>
    </message>
    <message>
        <source>Selects from the shown moment</source>
        <translation>Wählt ab dem gezeigten Zeitpunkt aus</translation>
    </message>
    <message>
        <source>End range here</source>
        <translation>Bereich hier beenden</translation>
    </message>
    <message>
        <source>Selects up to the shown moment</source>
        <translation>Wählt bis zum gezeigten Zeitpunkt aus</translation>
    </message>
    <message>
        <source>Clear range</source>
        <translation>Bereich aufheben</translation>
    </message>
    <message>
        <source>Clears the selection</source>
        <translation>Hebt die Auswahl auf</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Lesezeichen setzen</translation>
    </message>
    <message>
        <source>Adds a bookmark at the shown moment</source>
        <translation>Setzt ein Lesezeichen am gezeigten Zeitpunkt</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Loops the selected range, or the whole log</source>
        <translation>Wiederholt den ausgewählten Bereich oder das ganze Log</translation>
    </message>
    <message>
        <source>Timestamps</source>
        <translation>Zeitstempel</translation>
    </message>
    <message>
        <source>Shows the messages&apos; own timestamps in all views, instead of times since the log&apos;s start</source>
        <translation>Zeigt in allen Ansichten die eigenen Zeitstempel der Nachrichten statt der Zeiten seit Beginn des Logs</translation>
    </message>
    <message>
        <source>Skip gaps</source>
        <translation>Lücken überspringen</translation>
    </message>
    <message>
        <source>Skips gaps of more than a second in the log</source>
        <translation>Überspringt Lücken von mehr als einer Sekunde im Log</translation>
    </message>
    <message>
        <source>Time in seconds</source>
        <translation>Zeit in Sekunden</translation>
    </message>
    <message>
        <source>The shown time in seconds. Type another one to jump there: 12.5, 1:02.5, or +2 and -2 from here</source>
        <translation>Die gezeigte Zeit in Sekunden. Eine andere eingeben, um dorthin zu springen: 12.5, 1:02.5, oder +2 und -2 von hier aus</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>The shown frame&apos;s number. Type another one to jump there</source>
        <translation>Die Nummer des gezeigten Frames. Eine andere eingeben, um dorthin zu springen</translation>
    </message>
    <message>
        <source>End of the log</source>
        <translation>Ende des Logs</translation>
    </message>
    <message>
        <source>The time of the log&apos;s end</source>
        <translation>Die Zeit des Endes des Logs</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>The shown frame, and how many frames of the process the log holds</source>
        <translation>Der gezeigte Frame, und wie viele Frames des Prozesses das Log enthält</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>The process whose frames are stepped and counted</source>
        <translation>Der Prozess, dessen Frames schrittweise gezeigt und gezählt werden</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Playback speed, relative to real time</source>
        <translation>Mit welchem Vielfachen der Echtzeit das Log abgespielt wird</translation>
    </message>
    <message>
        <source>Time:</source>
        <translation>Zeit:</translation>
    </message>
    <message>
        <source>Frame:</source>
        <translation>Frame:</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Tempo:</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time; type seconds (12.5), minutes and seconds (1:02.5), or +2 and -2 from here.</source>
        <translation>„%1“ ist keine Zeit; Sekunden (12.5), Minuten und Sekunden (1:02.5) oder +2 und -2 von hier aus eingeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame number.</source>
        <translation>„%1“ ist keine Frame-Nummer.</translation>
    </message>
    <message>
        <source> / %1 s </source>
        <translation> / %1 s </translation>
    </message>
    <message>
        <source> (%1 / %2) </source>
        <translation> (%1 / %2) </translation>
    </message>
    <message>
        <source>the chosen stream</source>
        <translation>der gewählte Datenstrom</translation>
    </message>
    <message>
        <source>Back to the last message of %1</source>
        <translation>Zurück zur letzten Nachricht von %1</translation>
    </message>
    <message>
        <source>Forward to the next message of %1</source>
        <translation>Vor zur nächsten Nachricht von %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Pauses the log</source>
        <translation>Hält das Log an</translation>
    </message>
    <message>
        <source>Plays the log</source>
        <translation>Spielt das Log ab</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Refused (%1): %2</source>
        <translation>Abgelehnt (%1): %2</translation>
    </message>
    <message>
        <source>%1 – RobotControl</source>
        <translation>%1 – RobotControl</translation>
    </message>
    <message>
        <source>… and 1 more</source>
        <translation>… und 1 weiterer</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>
… and 1 more</source>
        <translation>
… und 1 weiterer</translation>
    </message>
    <message>
        <source>
… and %1 more</source>
        <translation>
… und %1 weitere</translation>
    </message>
    <message>
        <source>&amp;Maximize or restore view</source>
        <translation>Ansicht &amp;maximieren oder wiederherstellen</translation>
    </message>
    <message>
        <source>Maximizes the view that was used last or is under the mouse; a second time restores the layout</source>
        <translation>Maximiert die Ansicht, die zuletzt benutzt wurde oder unter der Maus ist; noch einmal: stellt die Anordnung wieder her</translation>
    </message>
    <message>
        <source>S&amp;weep a parameter…</source>
        <translation>Parameter &amp;durchlaufen…</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>&amp;Befehle…</translation>
    </message>
    <message>
        <source>Finds commands and menu entries by their words, and runs them</source>
        <translation>Findet Befehle und Menüeinträge nach ihren Wörtern und führt sie aus</translation>
    </message>
    <message>
        <source>No view is open here. The View menu opens one; Window &gt; Undo layout change (%1) brings back what was closed last; Window &gt; Reset perspective shows all views of %2 again.</source>
        <translation>Hier ist keine Ansicht offen. Das Menü Ansicht öffnet eine; Fenster &gt; Anordnungsänderung rückgängig (%1) bringt zurück, was zuletzt geschlossen wurde; Fenster &gt; Perspektive zurücksetzen zeigt wieder alle Ansichten von %2.</translation>
    </message>
    <message>
        <source>Export perspective</source>
        <translation>Perspektive exportieren</translation>
    </message>
    <message>
        <source>Perspectives (*.perspective.json);;All files (*)</source>
        <translation>Perspektiven (*.perspective.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import perspective</source>
        <translation>Perspektive importieren</translation>
    </message>
    <message>
        <source>Perspectives (*.perspective.json *.json);;All files (*)</source>
        <translation>Perspektiven (*.perspective.json *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Delete this perspective</source>
        <translation>Diese Perspektive &amp;löschen</translation>
    </message>
    <message>
        <source>Save perspective</source>
        <translation>Perspektive speichern</translation>
    </message>
    <message>
        <source>Name of the perspective:</source>
        <translation>Name der Perspektive:</translation>
    </message>
    <message>
        <source>Strokes are background, while a color view is shown</source>
        <translation>Striche sind Hintergrund, solange eine Farbansicht gezeigt wird</translation>
    </message>
    <message>
        <source>Strokes are of class %1, while a color view is shown</source>
        <translation>Striche gehören zur Klasse %1, solange eine Farbansicht gezeigt wird</translation>
    </message>
    <message>
        <source>Last change undone</source>
        <translation>Letzte Änderung rückgängig gemacht</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Change redone</source>
        <translation>Änderung wiederhergestellt</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nichts wiederherzustellen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Unsaved samples</source>
        <translation>Nicht gespeicherte Proben</translation>
    </message>
    <message>
        <source>Your color samples are not saved, and you are about to close %1.</source>
        <translation>Die Farbproben sind nicht gespeichert, und %1 wird gleich geschlossen.</translation>
    </message>
    <message>
        <source>what is open</source>
        <translation>was offen ist</translation>
    </message>
    <message>
        <source>Save them first? They stay in the color views either way.</source>
        <translation>Vorher speichern? In den Farbansichten bleiben sie auf jeden Fall.</translation>
    </message>
    <message>
        <source>Continue without saving</source>
        <translation>Weiter ohne Speichern</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>&amp;Log</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open process la&amp;yout…</source>
        <translation>P&amp;rozesslayout öffnen…</translation>
    </message>
    <message>
        <source>Save &amp;picture of the window…</source>
        <translation>Bild des &amp;Fensters speichern…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>Load &amp;color table…</source>
        <translation>&amp;Farbtabelle laden…</translation>
    </message>
    <message>
        <source>The selected robot&apos;s program uses it from the next image on</source>
        <translation>Das Programm des gewählten Roboters verwendet sie ab seinem nächsten Bild</translation>
    </message>
    <message>
        <source>&amp;Use the built-in color table</source>
        <translation>&amp;Eingebaute Farbtabelle verwenden</translation>
    </message>
    <message>
        <source>The selected robot&apos;s program makes a color table from the field&apos;s colors, as it does before one is sent</source>
        <translation>Das Programm des gewählten Roboters bildet eine Farbtabelle aus den Farben des Felds, wie bevor eine gesendet wurde</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>&amp;Save perspective as…</source>
        <translation>Perspektive &amp;speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Export perspective…</source>
        <translation>Perspektive &amp;exportieren…</translation>
    </message>
    <message>
        <source>&amp;Import perspective…</source>
        <translation>Perspektive &amp;importieren…</translation>
    </message>
    <message>
        <source>&amp;Reset perspective</source>
        <translation>Perspektive &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Undo layout change</source>
        <translation>Anordnungsänderung &amp;rückgängig</translation>
    </message>
    <message>
        <source>Re&amp;do layout change</source>
        <translation>Anordnungsänderung &amp;wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Opens the manual at the page of the focused view</source>
        <translation>Das Handbuch, auf der Seite der Ansicht mit dem Fokus</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Tour</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Tastatur&amp;kürzel…</translation>
    </message>
    <message>
        <source>&amp;Plug-ins…</source>
        <translation>&amp;Plug-ins…</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>Problem &amp;melden…</translation>
    </message>
    <message>
        <source>&amp;About RobotControl</source>
        <translation>&amp;Über RobotControl</translation>
    </message>
    <message>
        <source>Open process layout</source>
        <translation>Prozesslayout öffnen</translation>
    </message>
    <message>
        <source>Process layouts (*.yaml);;All files (*)</source>
        <translation>Prozesslayouts (*.yaml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Load color table</source>
        <translation>Farbtabelle laden</translation>
    </message>
    <message>
        <source>Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2);;All files (*)</source>
        <translation>Farbtabellen (*.c64 *.tm *.raw *.cal *.lut *.bz2);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>About RobotControl</source>
        <translation>Über RobotControl</translation>
    </message>
    <message>
        <source>&lt;b&gt;RobotControl %1&lt;/b&gt;&lt;p&gt;A workbench for developing and debugging the control programs of robots.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;b&gt;RobotControl %1&lt;/b&gt;&lt;p&gt;Eine Werkbank zum Entwickeln und Debuggen der Steuerprogramme von Robotern.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Export a &amp;view as video or images…</source>
        <translation>&amp;Ansicht als Video oder Bilder exportieren…</translation>
    </message>
    <message>
        <source>Everything is saved: bookmarks, the color table&apos;s samples, the motion and the scene files</source>
        <translation>Alles ist gespeichert: Lesezeichen, die Proben der Farbtabelle, die Bewegung und die Szenendateien</translation>
    </message>
    <message>
        <source>Copy view as picture</source>
        <translation>Ansicht als Bild kopieren</translation>
    </message>
    <message>
        <source>Copies the picture of the view that has the focus</source>
        <translation>Kopiert das Bild der Ansicht, die den Fokus hat</translation>
    </message>
    <message>
        <source>Copy view as numbers</source>
        <translation>Ansicht als Zahlen kopieren</translation>
    </message>
    <message>
        <source>Copies the table of the view that has the focus, with tabs between the columns</source>
        <translation>Kopiert die Tabelle der Ansicht, die den Fokus hat, mit Tabulatoren zwischen den Spalten</translation>
    </message>
    <message>
        <source>&amp;New scene…</source>
        <translation>&amp;Neue Szene…</translation>
    </message>
    <message>
        <source>Starts a room with walls, light, and a robot in the scene editor</source>
        <translation>Beginnt im Szeneneditor einen Raum mit Wänden, Licht und einem Roboter</translation>
    </message>
    <message>
        <source>The simulation continues with the saved files. The editor keeps unsaved changes: %1; scene.apply applies them.</source>
        <translation>Die Simulation geht mit dem weiter, was gespeichert ist. Der Editor behält nicht gespeicherte Änderungen: %1; mit scene.apply geht sie mit ihnen weiter.</translation>
    </message>
    <message>
        <source>&amp;Go to view…</source>
        <translation>&amp;Gehe zu Ansicht…</translation>
    </message>
    <message>
        <source>Lists the open views; type a part of a title to bring that view to the front</source>
        <translation>Listet die offenen Ansichten auf, von denen eine nach ihrem Titel gefunden und nach vorne geholt wird</translation>
    </message>
</context>
<context>
    <name>app::ManualWindow</name>
    <message>
        <source>Manual of RobotControl</source>
        <translation>Handbuch von RobotControl</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Lists only pages that contain these words</source>
        <translation>Listet nur Seiten auf, die diese Wörter enthalten</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Shows the previous page</source>
        <translation>Zeigt die vorige Seite</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Shows the next page</source>
        <translation>Zeigt die nächste Seite</translation>
    </message>
</context>
<context>
    <name>app::OfferDialog</name>
    <message>
        <source>Offer this session</source>
        <translation>Diese Sitzung anbieten</translation>
    </message>
    <message>
        <source>Others can watch and steer what is open here: with RobotControl (Robot &gt; Connect…), robotctl watch, or any client of the Foxglove WebSocket protocol.</source>
        <translation>Andere beobachten und steuern, was hier offen ist: mit RobotControl (Roboter &gt; Verbinden…), robotctl watch oder jedem Programm, das das Foxglove-WebSocket-Protokoll spricht.</translation>
    </message>
    <message>
        <source>&amp;Offer</source>
        <translation>An&amp;bieten</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The address of this machine at which others connect; 127.0.0.1 is for programs on this machine only</source>
        <translation>Die Adresse dieses Rechners, unter der sich andere verbinden; 127.0.0.1 ist nur für Programme auf diesem Rechner</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Usually 8765; 0: any free port</source>
        <translation>8765 ist üblich; 0: ein beliebiger freier</translation>
    </message>
    <message>
        <source>port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse:</translation>
    </message>
    <message>
        <source>URL for others</source>
        <translation>URL für andere</translation>
    </message>
    <message>
        <source>What others connect to</source>
        <translation>Womit sich andere verbinden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copies the URL to the clipboard</source>
        <translation>Kopiert die URL in die Zwischenablage</translation>
    </message>
    <message>
        <source>Others connect to:</source>
        <translation>Andere verbinden sich mit:</translation>
    </message>
    <message>
        <source>They need a token:</source>
        <translation>Sie brauchen ein Token:</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>How it is protected</source>
        <translation>Wie es geschützt ist</translation>
    </message>
    <message>
        <source>Copy the token to &amp;control</source>
        <translation>Zum &amp;Steuern</translation>
    </message>
    <message>
        <source>Copies the token for full control to the clipboard</source>
        <translation>Kopiert das Token derer, die alles dürfen, in die Zwischenablage</translation>
    </message>
    <message>
        <source>Copy the token to &amp;watch</source>
        <translation>Zum Be&amp;obachten</translation>
    </message>
    <message>
        <source>Copies the token for watching and STOP only to the clipboard</source>
        <translation>Kopiert das Token derer, die nur beobachten und STOP auslösen dürfen, in die Zwischenablage</translation>
    </message>
    <message>
        <source>Who is connected</source>
        <translation>Wer verbunden ist</translation>
    </message>
    <message>
        <source>Is sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Who was refused</source>
        <translation>Wer abgewiesen wurde</translation>
    </message>
    <message>
        <source>not offered</source>
        <translation>es wird nichts angeboten</translation>
    </message>
    <message>
        <source>What others connect to: %1</source>
        <translation>Womit sich andere verbinden: %1</translation>
    </message>
    <message>
        <source>Stop &amp;offering</source>
        <translation>Nicht mehr an&amp;bieten</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>%1 (watch only)</source>
        <translation>%1 (darf nur beobachten)</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Offered. No client is connected yet.</source>
        <translation>Angeboten. Noch ist niemand verbunden.</translation>
    </message>
    <message>
        <source>Offered. 1 client is connected.</source>
        <translation>Angeboten. 1 Client ist verbunden.</translation>
    </message>
    <message>
        <source>Offered. %1 clients are connected.</source>
        <translation>Angeboten. %1 Clients sind verbunden.</translation>
    </message>
</context>
<context>
    <name>app::OpeningBar</name>
    <message>
        <source>Opening</source>
        <translation>Öffnen läuft</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancels opening; what was open before stays open</source>
        <translation>Bricht das Öffnen ab; was vorher offen war, läuft weiter</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet…</translation>
    </message>
</context>
<context>
    <name>app::PlatformDialog</name>
    <message>
        <source>A lost line is reopened automatically.</source>
        <translation>Eine verlorene Leitung wird automatisch wieder geöffnet.</translation>
    </message>
    <message>
        <source>Connect &amp;now</source>
        <translation>Jetzt &amp;verbinden</translation>
    </message>
    <message>
        <source>Tries again at once, instead of after the pause</source>
        <translation>Versucht es sofort wieder, statt nach der Pause</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet…</translation>
    </message>
    <message>
        <source>Connected to %1.</source>
        <translation>Verbunden mit %1.</translation>
    </message>
</context>
<context>
    <name>app::PlatformMenus</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>app::PluginsDialog</name>
    <message>
        <source>Plug-ins</source>
        <translation>Plug-ins</translation>
    </message>
    <message>
        <source>Plug-in</source>
        <translation>Plug-in</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>What it does, or why it is not loaded</source>
        <translation>Was es tut, oder warum es nicht verwendet wird</translation>
    </message>
    <message>
        <source>Where plug-ins are</source>
        <translation>Wo Plug-ins sind</translation>
    </message>
    <message>
        <source>There are no plug-ins. </source>
        <translation>Es gibt keine Plug-ins. </translation>
    </message>
    <message>
        <source>Plug-ins in the folder %1 are loaded at the next start; load others with --plugin FILE.</source>
        <translation>Die im Ordner %1 werden beim nächsten Start geladen; andere durch --plugin FILE.</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>&amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>Shows the folder of plug-ins, which is created if it is missing</source>
        <translation>Zeigt den Ordner der Plug-ins, der angelegt wird, wenn er fehlt</translation>
    </message>
    <message>
        <source>Not loaded: %1</source>
        <translation>Nicht geladen: %1</translation>
    </message>
</context>
<context>
    <name>app::PresetMenu</name>
    <message>
        <source>Pr&amp;esets</source>
        <translation>Vo&amp;reinstellungen</translation>
    </message>
    <message>
        <source>&amp;Save, compare, delete…</source>
        <translation>&amp;Speichern, vergleichen, löschen…</translation>
    </message>
</context>
<context>
    <name>app::PresetsDialog</name>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Differences from the current settings</source>
        <translation>Was von der jetzigen Wahl abweicht</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>The name to save under, or the new name</source>
        <translation>Der Name zum Speichern oder der neue Name</translation>
    </message>
    <message>
        <source>Debug &amp;keys</source>
        <translation>&amp;Debug-Schlüssel</translation>
    </message>
    <message>
        <source>S&amp;olutions</source>
        <translation>Lös&amp;ungen</translation>
    </message>
    <message>
        <source>&amp;Parameters</source>
        <translation>&amp;Parameter</translation>
    </message>
    <message>
        <source>&amp;Views</source>
        <translation>&amp;Ansichten</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Load</source>
        <translation>&amp;Laden</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Um&amp;benennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Lös&amp;chen</translation>
    </message>
    <message>
        <source>Last result</source>
        <translation>Letztes Ergebnis</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Loaded: %1</source>
        <translation>Geladen: %1</translation>
    </message>
    <message>
        <source>Renamed</source>
        <translation>Umbenannt</translation>
    </message>
    <message>
        <source>Deleted</source>
        <translation>Gelöscht</translation>
    </message>
    <message>
        <source>There is no preset yet. Type a name, choose its parts, and save.</source>
        <translation>Es gibt noch keine Voreinstellung. Einen Namen eingeben, wählen, was dazugehört, und speichern.</translation>
    </message>
    <message>
        <source>The current settings match this preset.</source>
        <translation>Alles ist wie in dieser Voreinstellung.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>The settings of the camera, known only while the view Camera is open</source>
        <translation>Die Einstellungen der Kamera; bekannt, solange die Ansicht Kamera offen ist</translation>
    </message>
</context>
<context>
    <name>app::ProblemDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Problem melden</translation>
    </message>
    <message>
        <source>&amp;What did you do, what did you expect, and what happened?</source>
        <translation>&amp;Was wurde getan, was war erwartet, und was ist geschehen?</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>The report also contains the following. It is only saved or copied, never sent; it has names of files and robots, so read it before you pass it on.</source>
        <translation>Der Bericht enthält auch, was folgt. Er wird gespeichert oder kopiert und nirgendwohin gesendet; er enthält Namen von Dateien und Robotern, daher vor dem Weitergeben lesen.</translation>
    </message>
    <message>
        <source>Contents of the report</source>
        <translation>Was der Bericht enthält</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Den Bericht speichern</translation>
    </message>
    <message>
        <source>Reports (*.md);;All files (*)</source>
        <translation>Berichte (*.md);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>app::RecordedBar</name>
    <message>
        <source>Where the recording went</source>
        <translation>Wo die Aufzeichnung ist</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Opens the recording as a log, in place of what is open now</source>
        <translation>Öffnet die Aufzeichnung als Log, anstelle dessen, was hier läuft</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Opens the folder that the recording is in</source>
        <translation>Öffnet den Ordner, in dem die Aufzeichnung ist</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hides this</source>
        <translation>Blendet dies aus</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>The recording ended early (%1), and is readable up to there:</source>
        <translation>Die Aufzeichnung endete vorzeitig (%1) und ist bis dahin lesbar:</translation>
    </message>
    <message>
        <source> (the last of %1 files: each reset starts a new one)</source>
        <translation> (die letzte von %1 Dateien: jedes Zurücksetzen beginnt eine neue)</translation>
    </message>
    <message>
        <source>%1 %2 into %3</source>
        <translation>%1 %2 in %3</translation>
    </message>
    <message>
        <source>The last seconds are in %1</source>
        <translation>Die letzten Sekunden sind in %1</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, in %2</translation>
    </message>
    <message>
        <source>No file manager was found on this computer. The recording is %1</source>
        <translation>Kein Programm auf diesem Rechner zeigt Ordner. Die Aufzeichnung ist %1</translation>
    </message>
</context>
<context>
    <name>app::RecordingToolBar</name>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Save the last seconds</source>
        <translation>Letzte Sekunden speichern</translation>
    </message>
    <message>
        <source>Mark this instant…</source>
        <translation>Diesen Zeitpunkt markieren…</translation>
    </message>
    <message>
        <source>Marks the shown instant in the recording; without one, saves the last seconds with the mark (%1)</source>
        <translation>Markiert den gezeigten Zeitpunkt in der Aufzeichnung; ohne Aufzeichnung werden die letzten Sekunden mit der Markierung gespeichert (%1)</translation>
    </message>
    <message>
        <source>Re&amp;cording</source>
        <translation>Auf&amp;zeichnung</translation>
    </message>
    <message>
        <source>&amp;Keep in memory</source>
        <translation>Im Speicher be&amp;halten</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>5 s</source>
        <translation>5 s</translation>
    </message>
    <message>
        <source>10 s</source>
        <translation>10 s</translation>
    </message>
    <message>
        <source>30 s</source>
        <translation>30 s</translation>
    </message>
    <message>
        <source>60 s</source>
        <translation>60 s</translation>
    </message>
    <message>
        <source>2 min</source>
        <translation>2 min</translation>
    </message>
    <message>
        <source>&amp;Trigger…</source>
        <translation>Aus&amp;löser…</translation>
    </message>
    <message>
        <source>Saves the last seconds when a message arrives on a stream you choose</source>
        <translation>Speichert die letzten Sekunden, wenn eine Nachricht auf einem gewählten Datenstrom eintrifft</translation>
    </message>
    <message>
        <source>&amp;Streams…</source>
        <translation>&amp;Datenströme…</translation>
    </message>
    <message>
        <source>What is recorded</source>
        <translation>Was aufgezeichnet wird</translation>
    </message>
    <message>
        <source>&amp;Images</source>
        <translation>&amp;Bilder</translation>
    </message>
    <message>
        <source>As they are</source>
        <translation>Wie sie sind</translation>
    </message>
    <message>
        <source>JPEG (small, lossy)</source>
        <translation>JPEG (klein, mit Verlust)</translation>
    </message>
    <message>
        <source>PNG (lossless, slow)</source>
        <translation>PNG (verlustfrei, langsam)</translation>
    </message>
    <message>
        <source>&amp;Compression</source>
        <translation>&amp;Kompression</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>LZ4 (fast)</source>
        <translation>LZ4 (schnell)</translation>
    </message>
    <message>
        <source>Zstandard (small)</source>
        <translation>Zstandard (klein)</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Where new recordings go</source>
        <translation>Wohin neue Aufzeichnungen kommen</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Datei der Aufzeichnung</translation>
    </message>
    <message>
        <source>State of the recording</source>
        <translation>Zustand der Aufzeichnung</translation>
    </message>
    <message>
        <source>0:00  00.0 MB  keeps 30 s</source>
        <translation>0:00  00.0 MB  behält 30 s</translation>
    </message>
    <message>
        <source>keeps %1 s</source>
        <translation>behält %1 s</translation>
    </message>
    <message>
        <source>1 message dropped</source>
        <translation>1 Nachricht verworfen</translation>
    </message>
    <message>
        <source>%1 messages dropped</source>
        <translation>%1 Nachrichten verworfen</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>keine Aufzeichnung</translation>
    </message>
    <message>
        <source>recording failed</source>
        <translation>Aufzeichnung gescheitert</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>last: %1</source>
        <translation>letzte: %1</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Recording into %1</source>
        <translation>Aufzeichnung in %1</translation>
    </message>
    <message>
        <source>The disk did not keep up: %1 were dropped</source>
        <translation>Der Datenträger war zu langsam: %1 wurden verworfen</translation>
    </message>
    <message>
        <source>Last: %1</source>
        <translation>Letzte: %1</translation>
    </message>
    <message>
        <source>Last seconds saved: %1</source>
        <translation>Letzte Sekunden gespeichert: %1</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet</source>
        <translation>Noch wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>&amp;Trigger: %1…</source>
        <translation>Aus&amp;löser: %1…</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Auslöser</translation>
    </message>
    <message>
        <source>Saves the last seconds when a message arrives on this stream (* matches any text). A debug key must be on to publish. Empty: never.</source>
        <translation>Speichert die letzten Sekunden, wenn auf diesem Datenstrom eine Nachricht eintrifft (* passt auf jeden Text). Zum Veröffentlichen muss ein Debug-Schlüssel an sein. Leer: nie.</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Ordner für Aufzeichnungen</translation>
    </message>
    <message>
        <source>Mark this instant</source>
        <translation>Diesen Zeitpunkt markieren</translation>
    </message>
    <message>
        <source>What happens at %1 s:</source>
        <translation>Was bei %1 s geschieht:</translation>
    </message>
</context>
<context>
    <name>app::RecordingsDialog</name>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>Recordings at the robot</source>
        <translation>Aufzeichnungen beim Roboter</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Whose recordings are shown</source>
        <translation>Wessen Aufzeichnungen gezeigt werden</translation>
    </message>
    <message>
        <source>&amp;Start recording</source>
        <translation>Aufzeichnung &amp;starten</translation>
    </message>
    <message>
        <source>The robot records into its own storage, even if the connection is lost</source>
        <translation>Der Roboter zeichnet in seinen eigenen Speicher auf, was auch immer aus der Verbindung wird</translation>
    </message>
    <message>
        <source>S&amp;top recording</source>
        <translation>Aufzeichnung b&amp;eenden</translation>
    </message>
    <message>
        <source>Ends the recording at the robot</source>
        <translation>Beendet die Aufzeichnung beim Roboter</translation>
    </message>
    <message>
        <source>&amp;Robot:</source>
        <translation>&amp;Roboter:</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Last written</source>
        <translation>Zuletzt geschrieben</translation>
    </message>
    <message>
        <source>At the robot</source>
        <translation>Beim Roboter</translation>
    </message>
    <message>
        <source>is being recorded</source>
        <translation>wird aufgezeichnet</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>No remote robot is connected. Robot &gt; Connect… connects one.</source>
        <translation>Kein entfernter Roboter ist verbunden. Roboter &gt; Verbinden… verbindet einen.</translation>
    </message>
    <message>
        <source>The robot has no recordings yet. Start recording makes one, in its own storage.</source>
        <translation>Der Roboter hat noch keine Aufzeichnungen. „Aufzeichnung starten“ erzeugt eine in seinem eigenen Speicher.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Folder for downloaded recordings</source>
        <translation>Wohin Aufzeichnungen geholt werden</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Chooses the folder</source>
        <translation>Wählt den Ordner</translation>
    </message>
    <message>
        <source>Fetch &amp;into:</source>
        <translation>Holen &amp;in:</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Stops the download; the next one resumes where it stopped</source>
        <translation>Beendet das Holen; beim nächsten Mal geht es weiter, wo es aufgehört hat</translation>
    </message>
    <message>
        <source>&amp;Fetch</source>
        <translation>&amp;Holen</translation>
    </message>
    <message>
        <source>Downloads the selected recordings from the robot, and verifies their checksums</source>
        <translation>Kopiert die ausgewählten Aufzeichnungen vom Roboter und prüft dabei jedes Byte</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>Opens the selected recording as a log, instead of what is open here</source>
        <translation>Öffnet die ausgewählte Aufzeichnung als Log, anstelle dessen, was hier offen ist</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Löschen…</translation>
    </message>
    <message>
        <source>Deletes the selected recordings at the robot</source>
        <translation>Löscht die ausgewählten Aufzeichnungen beim Roboter</translation>
    </message>
    <message>
        <source>This robot&apos;s program keeps no recordings. Restart it with --recordings FOLDER.</source>
        <translation>Das Programm dieses Roboters bewahrt keine Aufzeichnungen auf: es muss mit --recordings FOLDER gestartet werden.</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>was cut off</source>
        <translation>wurde abgeschnitten</translation>
    </message>
    <message>
        <source>The robot&apos;s program ended before it could finish this recording; it is readable up to there</source>
        <translation>Das Programm des Roboters endete, bevor es diese Aufzeichnung abschließen konnte; sie ist bis dahin lesbar</translation>
    </message>
    <message>
        <source>fetched</source>
        <translation>geholt</translation>
    </message>
    <message>
        <source>%1 % fetched</source>
        <translation>%1 % geholt</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>eine andere Datei</translation>
    </message>
    <message>
        <source>The download of %1 was canceled. The next one resumes where it stopped.</source>
        <translation>Das Holen von %1 wurde abgebrochen. Beim nächsten Mal geht es weiter, wo es aufgehört hat.</translation>
    </message>
    <message>
        <source>, %1 of them from an earlier download</source>
        <translation>, davon %1 von vorher</translation>
    </message>
    <message>
        <source>%1 was downloaded: %2%3; the checksum matches the robot&apos;s.</source>
        <translation>%1 wurde geholt: %2%3; die Prüfsumme ist die des Roboters.</translation>
    </message>
    <message>
        <source>%1 was deleted on the robot.</source>
        <translation>%1 wurde beim Roboter gelöscht.</translation>
    </message>
    <message>
        <source>The robot is recording.</source>
        <translation>Der Roboter zeichnet auf.</translation>
    </message>
    <message>
        <source>The recording at the robot has ended.</source>
        <translation>Die Aufzeichnung beim Roboter ist beendet.</translation>
    </message>
    <message>
        <source>Folder for fetched recordings</source>
        <translation>Ordner für geholte Aufzeichnungen</translation>
    </message>
    <message>
        <source>There is no folder %1. Choose another one.</source>
        <translation>Es gibt keinen Ordner %1: einen anderen wählen.</translation>
    </message>
    <message>
        <source>Replace the file?</source>
        <translation>Die Datei ersetzen?</translation>
    </message>
    <message>
        <source>%1 exists already. Fetch the recording again, and replace the file?</source>
        <translation>%1 gibt es schon. Die Aufzeichnung noch einmal holen und die Datei ersetzen?</translation>
    </message>
    <message>
        <source>these %1 recordings</source>
        <translation>diese %1 Aufzeichnungen</translation>
    </message>
    <message>
        <source>Delete %1 on the robot? The copy here stays.</source>
        <translation>%1 beim Roboter löschen? Die Kopie hier bleibt.</translation>
    </message>
    <message>
        <source>Delete %1 on the robot? There is no copy here; it will be lost.</source>
        <translation>%1 beim Roboter löschen? Hier gibt es keine Kopie; die Daten gehen verloren.</translation>
    </message>
    <message>
        <source>Delete on the robot?</source>
        <translation>Beim Roboter löschen?</translation>
    </message>
</context>
<context>
    <name>app::RemoteDialog</name>
    <message>
        <source>not decoded: %1</source>
        <translation>nicht dekodiert: %1</translation>
    </message>
    <message>
        <source>%1 thinned</source>
        <translation>%1 ausgedünnt</translation>
    </message>
    <message>
        <source>%1 thinned, %2 lost</source>
        <translation>%1 ausgedünnt, %2 verloren</translation>
    </message>
    <message>
        <source>Connect to robots</source>
        <translation>Mit Robotern verbinden</translation>
    </message>
    <message>
        <source>Connects remote robots: there, robotctl sim or robotctl run was started with --listen, or somebody chose Robot &gt; Offer this session. They are shown in addition to those that are open here. Where only robotctl platform was started, the program runs here, in place of what is open. Robots that announce themselves are listed; click one to use its address.</source>
        <translation>Roboter, deren Programme anderswo laufen: dort wurde robotctl sim oder robotctl run mit --listen gestartet, oder jemand hat Roboter &gt; Diese Sitzung anbieten gewählt. Sie werden neben denen gezeigt, die hier offen sind. Wo nur robotctl platform gestartet wurde, läuft das Programm hier, anstelle dessen, was offen ist. Roboter, die sich ankündigen, sind aufgelistet; ein Klick übernimmt ihre Adresse.</translation>
    </message>
    <message>
        <source>URL</source>
        <translation>URL</translation>
    </message>
    <message>
        <source>ws://HOST[:PORT]; the list has the recent ones</source>
        <translation>ws://HOST[:PORT]; die Liste enthält die letzten</translation>
    </message>
    <message>
        <source>&amp;URL:</source>
        <translation>&amp;URL:</translation>
    </message>
    <message>
        <source>&amp;Token:</source>
        <translation>&amp;Token:</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Where the robot&apos;s program runs: there, where it is watched and steered; or here, if there is only the body (robotctl platform)</source>
        <translation>Wo das Programm des Roboters läuft: dort, wo es beobachtet und gesteuert wird; oder hier, wenn dort nur der Körper ist (robotctl platform)</translation>
    </message>
    <message>
        <source>there: it is watched and steered</source>
        <translation>dort: es wird beobachtet und gesteuert</translation>
    </message>
    <message>
        <source>here: only the body is there</source>
        <translation>hier: nur der Körper ist dort</translation>
    </message>
    <message>
        <source>&amp;Program:</source>
        <translation>&amp;Programm:</translation>
    </message>
    <message>
        <source>&amp;Images:</source>
        <translation>&amp;Bilder:</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>The robot prints it when it creates it. A robot that needs one asks for it; it can be remembered then</source>
        <translation>Der Roboter gibt es aus, wenn es erzeugt wird. Ein Roboter, der eines will, fragt danach, und es lässt sich dann merken</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>Ver&amp;gessen</translation>
    </message>
    <message>
        <source>Forgets the token that is remembered for this robot</source>
        <translation>Vergisst das gemerkte Token dieses Roboters</translation>
    </message>
    <message>
        <source>Forget the token</source>
        <translation>Das Token vergessen</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How the robots at this URL send images; JPEG needs a tenth of the bandwidth</source>
        <translation>Wie die Roboter dieser URL Bilder senden; JPEG braucht ein Zehntel der Leitung</translation>
    </message>
    <message>
        <source>raw, or JPEG if the link is too slow</source>
        <translation>roh, als JPEG wo die Leitung zu schmal ist</translation>
    </message>
    <message>
        <source>always raw</source>
        <translation>immer roh</translation>
    </message>
    <message>
        <source>as JPEG</source>
        <translation>als JPEG</translation>
    </message>
    <message>
        <source>as PNG</source>
        <translation>als PNG</translation>
    </message>
    <message>
        <source>Images a second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Maximum images per second of each stream from the robots at this URL. Images left out count as thinned</source>
        <translation>Wie viele Bilder pro Sekunde jedes Datenstroms die Roboter dieser URL höchstens senden. Ausgelassenes zählt als ausgedünnt</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> pro Sekunde</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Maximum data rate of the robots at this URL. Newer images and states replace those still waiting; texts and results arrive late</source>
        <translation>Was die Roboter dieser URL höchstens senden dürfen. Neuere Bilder und Zustände ersetzen dann wartende; Texte und Ergebnisse kommen spät</translation>
    </message>
    <message>
        <source> kB/s</source>
        <translation> kB/s</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>at &amp;most</source>
        <translation>&amp;höchstens</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>gemerkt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Connects to the server at this URL</source>
        <translation>Verbindet mit dem Server dieser URL</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>T&amp;rennen</translation>
    </message>
    <message>
        <source>Ends the selected connection and removes its robots from the window</source>
        <translation>Beendet die ausgewählte Verbindung; ihre Roboter verlassen das Fenster</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Looking for a body at %1…</source>
        <translation>Unter %1 wird ein Körper gesucht…</translation>
    </message>
    <message>
        <source>%1 has a question before it accepts the connection.</source>
        <translation>%1 hat eine Frage, bevor die Verbindung angenommen wird.</translation>
    </message>
    <message>
        <source>everything sent</source>
        <translation>alles wurde gesendet</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>Verbindung mit %1 wird hergestellt…</translation>
    </message>
    <message>
        <source>%1
Trying again…</source>
        <translation>%1
Neuer Versuch…</translation>
    </message>
</context>
<context>
    <name>app::RemoteLine</name>
    <message>
        <source>Connection to %1</source>
        <translation>Verbindung mit %1</translation>
    </message>
    <message>
        <source>%1 of %2 connections are up</source>
        <translation>%1 von %2 Verbindungen bestehen</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>no client is connected</source>
        <translation>niemand ist verbunden</translation>
    </message>
    <message>
        <source>1 client</source>
        <translation>1 Client</translation>
    </message>
    <message>
        <source>%1 clients</source>
        <translation>%1 Clients</translation>
    </message>
    <message>
        <source>Offered: %1</source>
        <translation>Angeboten: %1</translation>
    </message>
    <message>
        <source>This session is offered at %1: %2</source>
        <translation>Diese Sitzung wird unter %1 angeboten: %2</translation>
    </message>
    <message>
        <source>State of the offered session</source>
        <translation>Angebot dieser Sitzung</translation>
    </message>
    <message>
        <source>%1 steers %2. Steer instead</source>
        <translation>%1 steuert %2. Selbst steuern</translation>
    </message>
    <message>
        <source>%1 Click to take control; anyone can press STOP.</source>
        <translation>%1 Ein Klick, und von hier wird gesteuert; STOP darf jeder auslösen.</translation>
    </message>
    <message>
        <source>%1 Click to release control to others.</source>
        <translation>%1 Ein Klick lässt andere steuern.</translation>
    </message>
    <message>
        <source>Who steers</source>
        <translation>Wer steuert</translation>
    </message>
    <message>
        <source>The milliseconds include waiting behind other data: on a slow link that is most of them.</source>
        <translation>In den Millisekunden steckt das Warten hinter Daten, die unterwegs sind: Auf einer schmalen Leitung ist es der größte Teil.</translation>
    </message>
    <message>
        <source>%1: %2
Click to see all connections and limit their data rates</source>
        <translation>%1: %2
Ein Klick zeigt alle Verbindungen und begrenzt ihre Datenraten</translation>
    </message>
</context>
<context>
    <name>app::RemoteMenus</name>
    <message>
        <source>C&amp;onnect…</source>
        <translation>&amp;Verbinden…</translation>
    </message>
    <message>
        <source>Watches and controls remote robots, in addition to those that are open here</source>
        <translation>Beobachtet und steuert Roboter, deren Programme anderswo laufen, neben denen, die hier offen sind</translation>
    </message>
    <message>
        <source>Connect &amp;again</source>
        <translation>&amp;Wieder verbinden</translation>
    </message>
    <message>
        <source>O&amp;ffer this session…</source>
        <translation>Diese Sitzung &amp;anbieten…</translation>
    </message>
    <message>
        <source>Lets others watch and steer what is open here</source>
        <translation>Lässt andere beobachten und steuern, was hier offen ist</translation>
    </message>
    <message>
        <source>Ro&amp;bots…</source>
        <translation>R&amp;oboter…</translation>
    </message>
    <message>
        <source>Connects sets of robots, and sends them layouts, parameters, motions and color tables</source>
        <translation>Verbindet Gruppen von Robotern und sendet ihnen Layouts, Parameter, Bewegungen und Farbtabellen</translation>
    </message>
    <message>
        <source>&amp;Recordings at the robot…</source>
        <translation>Auf&amp;zeichnungen beim Roboter…</translation>
    </message>
    <message>
        <source>Starts, downloads, opens and deletes recordings in the storage of remote robots</source>
        <translation>Startet, holt, öffnet und löscht Aufzeichnungen im Speicher entfernter Roboter</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>%1, program here</source>
        <translation>%1, Programm hier</translation>
    </message>
    <message>
        <source>Nothing was connected yet</source>
        <translation>Noch wurde nichts verbunden</translation>
    </message>
</context>
<context>
    <name>app::RobotsDialog</name>
    <message>
        <source>Robots[*]</source>
        <translation>Roboter[*]</translation>
    </message>
    <message>
        <source>Name of the set</source>
        <translation>Name der Gruppe</translation>
    </message>
    <message>
        <source>A name for display, such as Home game</source>
        <translation>Für Menschen, etwa Heimspiel</translation>
    </message>
    <message>
        <source>&amp;Set:</source>
        <translation>&amp;Gruppe:</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Starts a set without robots</source>
        <translation>Beginnt eine Gruppe ohne Roboter</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>Opens the file of a set</source>
        <translation>Öffnet die Datei einer Gruppe</translation>
    </message>
    <message>
        <source>Sa&amp;ve</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Saves the set as a text file (YAML)</source>
        <translation>Speichert die Gruppe als Textdatei (YAML)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Saves the set in another file</source>
        <translation>Speichert die Gruppe in einer anderen Datei</translation>
    </message>
    <message>
        <source>Robots of the set</source>
        <translation>Roboter der Gruppe</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>Color table</source>
        <translation>Farbtabelle</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>The set has no robots yet. Click Add, or double click a robot below.</source>
        <translation>Die Gruppe hat noch keine Roboter. „Hinzufügen“ gibt ihr einen; ein Doppelklick auf einen Roboter unten übernimmt diesen.</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Adds the selected robots on the network; else those that are connected; else an empty row</source>
        <translation>Fügt die ausgewählten Roboter im Netzwerk hinzu; sonst die verbundenen; sonst eine leere Zeile</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Removes the selected robot from the set</source>
        <translation>Entfernt den ausgewählten Roboter aus der Gruppe</translation>
    </message>
    <message>
        <source>Choose &amp;file…</source>
        <translation>Date&amp;i…</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>Ver&amp;binden</translation>
    </message>
    <message>
        <source>Connects all checked robots</source>
        <translation>Verbindet alle angekreuzten Roboter</translation>
    </message>
    <message>
        <source>D&amp;isconnect</source>
        <translation>T&amp;rennen</translation>
    </message>
    <message>
        <source>Disconnects all checked robots</source>
        <translation>Trennt alle angekreuzten</translation>
    </message>
    <message>
        <source>C&amp;heck</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Compares the files on the checked robots with those here, by checksum</source>
        <translation>Vergleicht die Dateien der angekreuzten Roboter mit denen hier, anhand ihrer Prüfsummen</translation>
    </message>
    <message>
        <source>De&amp;ploy</source>
        <translation>Ver&amp;teilen</translation>
    </message>
    <message>
        <source>Sends the files that differ to the checked robots, and compares again</source>
        <translation>Sendet den angekreuzten Robotern, was abweicht, und vergleicht noch einmal</translation>
    </message>
    <message>
        <source>Restart pro&amp;grams</source>
        <translation>Neu st&amp;arten</translation>
    </message>
    <message>
        <source>Restarts the programs of the checked robots that have not read the deployed files yet; these robots are stopped meanwhile</source>
        <translation>Startet die Programme der angekreuzten Roboter neu, wenn sie noch nicht gelesen haben, was verteilt wurde; diese Roboter stehen währenddessen</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Cancels comparing and sending</source>
        <translation>Bricht das Vergleichen und Senden ab</translation>
    </message>
    <message>
        <source>What the robots have</source>
        <translation>Was die Roboter haben</translation>
    </message>
    <message>
        <source>File on the robot</source>
        <translation>Datei beim Roboter</translation>
    </message>
    <message>
        <source>Compared with the file here</source>
        <translation>Verglichen mit der hier</translation>
    </message>
    <message>
        <source> – %1</source>
        <translation> – %1</translation>
    </message>
    <message>
        <source>Robots%1[*]</source>
        <translation>Roboter%1[*]</translation>
    </message>
    <message>
        <source>Discard the changes?</source>
        <translation>Die Änderungen verwerfen?</translation>
    </message>
    <message>
        <source>This set was changed and not saved. Discard the changes?</source>
        <translation>Diese Gruppe wurde geändert und nicht gespeichert. Die Änderungen verwerfen?</translation>
    </message>
    <message>
        <source>Open a set of robots</source>
        <translation>Eine Gruppe von Robotern öffnen</translation>
    </message>
    <message>
        <source>Sets of robots (*.yaml);;All files (*)</source>
        <translation>Gruppen von Robotern (*.yaml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Save the set of robots</source>
        <translation>Die Gruppe von Robotern speichern</translation>
    </message>
    <message>
        <source>Sets of robots (*.yaml)</source>
        <translation>Gruppen von Robotern (*.yaml)</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Einen Ordner wählen</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Eine Datei wählen</translation>
    </message>
    <message>
        <source>Process layouts (*.yaml)</source>
        <translation>Prozesslayouts (*.yaml)</translation>
    </message>
    <message>
        <source>Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2)</source>
        <translation>Farbtabellen (*.c64 *.tm *.raw *.cal *.lut *.bz2)</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>the same; takes effect when the program restarts</source>
        <translation>gleich; gilt, wenn das Programm neu startet</translation>
    </message>
    <message>
        <source>%1 %…</source>
        <translation>%1 %…</translation>
    </message>
    <message>
        <source>deployed: %1</source>
        <translation>verteilt: %1</translation>
    </message>
    <message>
        <source>restarted: %1</source>
        <translation>neu gestartet: %1</translation>
    </message>
    <message>
        <source>%1 is not connected.</source>
        <translation>%1 ist nicht verbunden.</translation>
    </message>
    <message>
        <source>%1 takes no files. Restart its program with --resources FOLDER.</source>
        <translation>%1 nimmt keine Dateien an: das Programm muss mit --resources FOLDER gestartet werden.</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Chooses the layout, the color table, the preset, or the folder of parameters or motions for the selected cell</source>
        <translation>Wählt für die gewählte Zelle das Layout, die Farbtabelle, die Voreinstellung oder den Ordner mit Parametern oder Bewegungen</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Voreinstellungen (*.json)</translation>
    </message>
</context>
<context>
    <name>app::Shortcuts</name>
    <message>
        <source>The key of &quot;%1&quot; cannot be changed.</source>
        <translation>Die Taste von „%1“ kann nicht geändert werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a single key.</source>
        <translation>„%1“ braucht eine einzelne Taste.</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>in the view %1</source>
        <translation>in der Ansicht %1</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot; already, %3; give that another one first.</source>
        <translation>%1 ist schon die Taste von „%2“, %3; jenem zuerst eine andere geben.</translation>
    </message>
</context>
<context>
    <name>app::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastaturkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Shows only entries that contain these words</source>
        <translation>Zeigt nur Einträge, die diese Wörter enthalten</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was es tut</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
    <message>
        <source>Press the new key here; empty removes it</source>
        <translation>Die neue Taste hier drücken; leer entfernt sie</translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation>Zu&amp;weisen</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset a&amp;ll</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Last result</source>
        <translation>Letztes Ergebnis</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>In the view %1</source>
        <translation>In der Ansicht %1</translation>
    </message>
</context>
<context>
    <name>app::SimulationToolBar</name>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Stops all robots at their platforms, regardless of their programs, until released; pauses a log (Shift+Esc, Pause)</source>
        <translation>Hält alle Roboter an ihrer Plattform an, was auch immer ihre Programme tun, bis zum Lösen; hält ein Log an (Umschalt+Esc, Pause)</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>The simulated scene</source>
        <translation>Die simulierte Szene</translation>
    </message>
    <message>
        <source>Process layout</source>
        <translation>Prozesslayout</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>The robot shown in views and toolbars</source>
        <translation>Der Roboter, den Ansichten und Werkzeugleisten zeigen</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Scene:</source>
        <translation>Szene:</translation>
    </message>
    <message>
        <source>Layout:</source>
        <translation>Layout:</translation>
    </message>
    <message>
        <source>Robot:</source>
        <translation>Roboter:</translation>
    </message>
    <message>
        <source>of the log</source>
        <translation>des Logs</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source>Rewind 1 s</source>
        <translation>1 s zurückspulen</translation>
    </message>
    <message>
        <source>Process layout of the selected robot&apos;s program: which process runs which tasks. Choosing another restarts the programs of all robots</source>
        <translation>Welcher Prozess des Programms des gewählten Roboters welche Aufgaben erledigt; ein anderes gilt für alle Roboter, deren Programme neu starten</translation>
    </message>
    <message>
        <source>Speed of the simulation, relative to real time</source>
        <translation>Geschwindigkeit der Simulation, relativ zur Echtzeit</translation>
    </message>
</context>
<context>
    <name>app::SnapshotMenu</name>
    <message>
        <source>S&amp;napshots</source>
        <translation>S&amp;chnappschüsse</translation>
    </message>
    <message>
        <source>No simulation is open</source>
        <translation>Es ist keine Simulation geöffnet</translation>
    </message>
    <message>
        <source>&amp;Take a snapshot</source>
        <translation>&amp;Schnappschuss aufnehmen</translation>
    </message>
    <message>
        <source>Keeps the present state of the world until the scene is closed</source>
        <translation>Bewahrt den jetzigen Zustand der Welt auf, bis die Szene geschlossen wird</translation>
    </message>
    <message>
        <source>Take a snapshot as a &amp;file…</source>
        <translation>Schnappschuss als &amp;Datei aufnehmen…</translation>
    </message>
    <message>
        <source>Writes the present state of the world to a file</source>
        <translation>Schreibt den jetzigen Zustand der Welt in eine Datei</translation>
    </message>
    <message>
        <source>&amp;Go back to a file…</source>
        <translation>&amp;Zurück zu einer Datei…</translation>
    </message>
    <message>
        <source>Restores the state of the world from a file; the robots&apos; programs keep running</source>
        <translation>Versetzt die Welt in den Zustand in einer Datei; die Programme der Roboter laufen weiter</translation>
    </message>
    <message>
        <source>%1: at %2 s</source>
        <translation>%1: bei %2 s</translation>
    </message>
    <message>
        <source>&amp;Cancel replaying the programs (%1 %)</source>
        <translation>Wiederholen der Programme &amp;abbrechen (%1 %)</translation>
    </message>
    <message>
        <source>Leaves world and programs in their current state, and pauses</source>
        <translation>Lässt Welt und Programme, wo sie angekommen sind, und hält an</translation>
    </message>
    <message>
        <source>&amp;Go back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Restores this state of the world; the robots&apos; programs keep running</source>
        <translation>Versetzt die Welt in diesen Zustand; die Programme der Roboter laufen weiter</translation>
    </message>
    <message>
        <source>Go back with the &amp;programs</source>
        <translation>Zurück mit den &amp;Programmen</translation>
    </message>
    <message>
        <source>Also replays the programs from their start, with all requests, up to this snapshot</source>
        <translation>Lässt die Programme von ihrem Start an mit allem, was verlangt wurde, noch einmal laufen, bis auch sie dort sind</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Vergessen</translation>
    </message>
    <message>
        <source>Removes this snapshot</source>
        <translation>Entfernt diesen Schnappschuss</translation>
    </message>
    <message>
        <source>Rewind by %1 s</source>
        <translation>Um %1 s zurückspulen</translation>
    </message>
    <message>
        <source>Rewinds the world; the robots&apos; programs keep running. The last %1 s are kept</source>
        <translation>Geht in der Welt zurück; die Programme der Roboter laufen weiter. Die letzten %1 s sind aufbewahrt</translation>
    </message>
    <message>
        <source>Pause the simulation to rewind it</source>
        <translation>Zum Zurückspulen die Simulation anhalten</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>Schnappschuss aufnehmen</translation>
    </message>
    <message>
        <source>Snapshots (*.snapshot)</source>
        <translation>Schnappschüsse (*.snapshot)</translation>
    </message>
    <message>
        <source>Go back to a snapshot</source>
        <translation>Zurück zu einem Schnappschuss</translation>
    </message>
</context>
<context>
    <name>app::StallWatch</name>
    <message>
        <source>Stalls of the window: number longer than %1 ms, and the longest one</source>
        <translation>Wie lange das Fenster nicht geantwortet hat: wie oft länger als %1 ms, und die längste Zeit</translation>
    </message>
    <message>
        <source>stalls: %1, longest %2 ms (CPU %3 ms)</source>
        <translation>Hänger: %1, längster %2 ms (CPU %3 ms)</translation>
    </message>
    <message>
        <source>%1, of %2 events with %3 page faults</source>
        <translation>%1, von %2 Ereignissen mit %3 Seitenfehlern</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>State of the simulation or the log</source>
        <translation>Zustand der Simulation oder des Logs</translation>
    </message>
    <message>
        <source>Simulated time; in a log the shown time and frame</source>
        <translation>Simulierte Zeit; in einem Log die gezeigte Zeit und der gezeigte Frame</translation>
    </message>
    <message>
        <source>Speed of the simulation or the log, relative to real time</source>
        <translation>Mit welchem Vielfachen der Echtzeit die Simulation läuft oder das Log abgespielt wird</translation>
    </message>
    <message>
        <source>How often a robot has touched the ball</source>
        <translation>Wie oft ein Roboter den Ball berührt hat</translation>
    </message>
    <message>
        <source>Messages dropped because too many arrived</source>
        <translation>Nachrichten, die verworfen wurden, weil zu viele eintrafen</translation>
    </message>
    <message>
        <source>%1 dropped</source>
        <translation>%1 verworfen</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>schweigt</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>%1, last heard %2 s ago</source>
        <translation>%1, zuletzt vor %2 s gehört</translation>
    </message>
    <message>
        <source>loading…</source>
        <translation>lädt…</translation>
    </message>
    <message>
        <source>STOP engaged</source>
        <translation>STOP ausgelöst</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>sim %1×</source>
        <translation>Sim. %1×</translation>
    </message>
    <message>
        <source>1 ball contact</source>
        <translation>1 Ballkontakt</translation>
    </message>
    <message>
        <source>%1 ball contacts</source>
        <translation>%1 Ballkontakte</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>spielt ab</translation>
    </message>
    <message>
        <source>%1 s  frame %2</source>
        <translation>%1 s  Frame %2</translation>
    </message>
    <message>
        <source>log %1×</source>
        <translation>Log %1×</translation>
    </message>
    <message>
        <source>nothing is open</source>
        <translation>nichts ist offen</translation>
    </message>
</context>
<context>
    <name>app::StopToolBar</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
</context>
<context>
    <name>app::StreamChooser</name>
    <message>
        <source>What is recorded</source>
        <translation>Was aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Comma-separated stream paths; * matches any text, - excludes. Empty: all that a replay needs. The program&apos;s setup is always recorded.</source>
        <translation>Pfade von Datenströmen, durch Kommas getrennt; * passt auf jeden Text, - schließt aus. Leer: alles, was eine Wiedergabe braucht. Die Einrichtung des Programms wird immer aufgezeichnet.</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>all that a replay needs</source>
        <translation>alles, was eine Wiedergabe braucht</translation>
    </message>
    <message>
        <source>For example red1/*,-*/transforms</source>
        <translation>Zum Beispiel red1/*,-*/transforms</translation>
    </message>
    <message>
        <source>Streams</source>
        <translation>Datenströme</translation>
    </message>
    <message>
        <source>Current streams; check those to record</source>
        <translation>Jetzige Datenströme; angekreuzte werden aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>app::SweepDialog</name>
    <message>
        <source>Sweep a parameter</source>
        <translation>Parameter durchlaufen</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>A task (for its active solution), or TASK/SOLUTION</source>
        <translation>Eine Aufgabe, für ihre aktive Lösung, oder eine der Lösungen</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>A list 1,2,5 or a range from:to:step</source>
        <translation>Eine Liste 1,2,5 oder ein Bereich from:to:step</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>An expression over streams, measured at each value</source>
        <translation>Ein Ausdruck über Datenströme, der bei jedem Wert gemessen wird</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Duration of the measurement at each value</source>
        <translation>Wie lange bei jedem Wert gemessen wird</translation>
    </message>
    <message>
        <source>S&amp;olution:</source>
        <translation>Lös&amp;ung:</translation>
    </message>
    <message>
        <source>&amp;Parameter:</source>
        <translation>&amp;Parameter:</translation>
    </message>
    <message>
        <source>&amp;Values:</source>
        <translation>&amp;Werte:</translation>
    </message>
    <message>
        <source>&amp;Figure:</source>
        <translation>&amp;Messgröße:</translation>
    </message>
    <message>
        <source>S&amp;econds each:</source>
        <translation>Je S&amp;ekunden:</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>State of the sweep</source>
        <translation>Zustand des Durchlaufs</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Save &amp;table…</source>
        <translation>&amp;Tabelle speichern…</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>St&amp;opp</translation>
    </message>
    <message>
        <source>Measuring %1 of %2…</source>
        <translation>%1 von %2 wird gemessen…</translation>
    </message>
    <message>
        <source>Done; the parameter was set back to its previous value.</source>
        <translation>Fertig; der Parameter hat wieder seinen früheren Wert.</translation>
    </message>
</context>
<context>
    <name>app::TokenDialog</name>
    <message>
        <source>The robot at %1 only accepts clients with its token. It printed two when it created them: one to control, and one to watch.</source>
        <translation>Der Roboter unter %1 lässt nur ein, wer sein Token zeigt. Er hat zwei ausgegeben, als sie erzeugt wurden: eines zum Steuern und eines zum Beobachten.</translation>
    </message>
    <message>
        <source>The robot at %1 does not accept this token. Enter one of the two that it printed when it created them.</source>
        <translation>Der Roboter unter %1 nimmt dieses Token nicht an. Eines der beiden eingeben, die er beim Erzeugen ausgegeben hat.</translation>
    </message>
    <message>
        <source>The robot at %1 does not accept the remembered token any more. Enter one of the two that it printed when it created them.</source>
        <translation>Der Roboter unter %1 nimmt das hier gemerkte Token nicht mehr an. Eines der beiden eingeben, die er beim Erzeugen ausgegeben hat.</translation>
    </message>
    <message>
        <source>Token of a robot</source>
        <translation>Token eines Roboters</translation>
    </message>
    <message>
        <source>What is asked</source>
        <translation>Was gefragt wird</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>&amp;Token:</source>
        <translation>&amp;Token:</translation>
    </message>
    <message>
        <source>&amp;Remember it on this computer</source>
        <translation>Auf diesem Rechner &amp;merken</translation>
    </message>
    <message>
        <source>Remember it</source>
        <translation>Merken</translation>
    </message>
    <message>
        <source>In %1, which only you can read; Robot &gt; Connect… forgets it</source>
        <translation>In %1, nur für den eigenen Benutzer lesbar; Roboter &gt; Verbinden… vergisst es</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>This connection is not encrypted: anyone who monitors the network can read the token.</source>
        <translation>Diese Verbindung ist nicht verschlüsselt: wer im Netzwerk mithört, sieht das Token.</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>Ver&amp;binden</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>T&amp;rennen</translation>
    </message>
</context>
<context>
    <name>app::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;End the tour</source>
        <translation>Tour b&amp;eenden</translation>
    </message>
    <message>
        <source>Help &gt; Tour shows it again (Esc)</source>
        <translation>Hilfe &gt; Tour zeigt sie wieder (Esc)</translation>
    </message>
    <message>
        <source>A robot and its program</source>
        <translation>Ein Roboter und sein Programm</translation>
    </message>
    <message>
        <source>This is the field of a simulated robot. Its whole program runs here, too, and you can look into it: what it sees, what it believes, what it decides. Drag to look around, turn the wheel to zoom. Real robots and log files are shown in the same views.</source>
        <translation>Dies ist das Feld eines simulierten Roboters. Auch sein ganzes Programm läuft hier und lässt sich durchschauen: was es sieht, was es glaubt, was es entscheidet. Ziehen zum Umsehen, Mausrad zum Zoomen. Wirkliche Roboter und Logdateien werden in denselben Ansichten gezeigt.</translation>
    </message>
    <message>
        <source>Play, pause, step</source>
        <translation>Abspielen, anhalten, Einzelschritt</translation>
    </message>
    <message>
        <source>F5 starts, F6 pauses, F10 takes one step of 8 ms, Ctrl+R resets. Shift+Esc is STOP: it halts the robot, whatever its program does.</source>
        <translation>F5 startet, F6 hält an, F10 geht einen Schritt von 8 ms, Strg+R beginnt von vorn. Umschalt+Esc ist STOP: der Roboter steht, was auch immer sein Programm will.</translation>
    </message>
    <message>
        <source>Debug keys</source>
        <translation>Debug-Schlüssel</translation>
    </message>
    <message>
        <source>Type &quot;ball&quot;, choose a key and press Enter: the program then publishes this drawing, plot or package, and views show it. In Solutions, next to it, a click switches a task to another solution.</source>
        <translation>„ball“ eingeben, einen Schlüssel wählen und die Eingabetaste drücken: das Programm veröffentlicht dann diese Zeichnung, Kurve oder dieses Paket, und Ansichten zeigen es. Daneben, in Lösungen, lässt ein Klick eine Aufgabe anders lösen.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Ctrl+Space freezes all views, while the robot continues. In the timeline you then go back and forth, for live robots as for logs; &quot;live&quot; returns to now.</source>
        <translation>Strg+Leertaste hält an, was alle Ansichten zeigen, während der Roboter weiterläuft. In der Zeitleiste geht es dann vor und zurück, bei laufenden Robotern wie bei Logs; „live“ kehrt zu jetzt zurück.</translation>
    </message>
    <message>
        <source>Views and perspectives</source>
        <translation>Ansichten und Perspektiven</translation>
    </message>
    <message>
        <source>The menu View lists all views; drag their tabs to arrange them, even out of the window. Window &gt; Perspective has arrangements for one job: colors, motions, logs, and your own.</source>
        <translation>Das Menü Ansicht enthält alle Ansichten; ihre Reiter lassen sich ziehen, auch aus dem Fenster heraus. Fenster &gt; Perspektive hat Anordnungen für je einen Zweck: Farben, Bewegungen, Logs und eigene.</translation>
    </message>
    <message>
        <source>Logs and other robots</source>
        <translation>Logs und andere Roboter</translation>
    </message>
    <message>
        <source>Drop a log file on the window to open it. Robot &gt; Connect… finds robots in your network; Ctrl+Shift+R records what the robot sends, and the log runs through the program again.</source>
        <translation>Eine Logdatei auf das Fenster ziehen, um sie zu öffnen. Roboter &gt; Verbinden… findet Roboter im Netzwerk; Strg+Umschalt+R zeichnet auf, was der Roboter sendet, und das Log läuft wieder durch das Programm.</translation>
    </message>
    <message>
        <source>Find everything by name</source>
        <translation>Alles nach seinen Wörtern</translation>
    </message>
    <message>
        <source>Ctrl+P finds every command and menu entry. F1 opens the manual at the page of the focused view. Help &gt; Tour shows this again.</source>
        <translation>Strg+P findet jeden Befehl und Menüeintrag. F1 öffnet das Handbuch auf der Seite der benutzten Ansicht. Hilfe &gt; Tour zeigt dies noch einmal.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
</context>
<context>
    <name>app::TrustDialog</name>
    <message>
        <source>A new robot</source>
        <translation>Ein neuer Roboter</translation>
    </message>
    <message>
        <source>Not the same robot as before?</source>
        <translation>Ein anderer Roboter als vorher?</translation>
    </message>
    <message>
        <source>This computer has never connected to the robot at %1. Is this the fingerprint that the robot printed at its start? If so, it is remembered for the next connections.</source>
        <translation>Der Roboter unter %1 war von hier noch nie verbunden. Er hat beim Start einen Fingerabdruck ausgegeben: ist es dieser? Dann wird er gemerkt und beim nächsten Mal wiedererkannt.</translation>
    </message>
    <message>
        <source>The certificate of the robot at %1 has changed. Either the robot was set up again, or someone else is answering in its place and would see the token and everything that is sent.</source>
        <translation>Der Roboter unter %1 zeigt ein anderes Zertifikat als vorher. Entweder wurde er neu eingerichtet, oder jemand anderes antwortet an seiner Stelle und würde das Token und alles Gesendete sehen.</translation>
    </message>
    <message>
        <source>The known robots are in %1.</source>
        <translation>Die bekannten Roboter stehen in %1.</translation>
    </message>
    <message>
        <source>What is asked</source>
        <translation>Was gefragt wird</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>&amp;Trust and connect</source>
        <translation>&amp;Vertrauen und verbinden</translation>
    </message>
    <message>
        <source>&amp;Replace and connect</source>
        <translation>&amp;Ersetzen und verbinden</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>The robot was set up again, and &amp;printed the fingerprint shown here</source>
        <translation>Der Roboter wurde neu eingerichtet und hat den Fingerabdruck &amp;ausgegeben, den er jetzt zeigt</translation>
    </message>
</context>
<context>
    <name>app::ViewDocks</name>
    <message>
        <source>The saved window layout has too many views (%1); only the first %2 were opened.</source>
        <translation>Die gespeicherte Fensteranordnung hat zu viele Ansichten (%1); nur die ersten %2 wurden geöffnet.</translation>
    </message>
</context>
<context>
    <name>app::ViewMenu</name>
    <message>
        <source>The robot and its world</source>
        <translation>Der Roboter und seine Welt</translation>
    </message>
    <message>
        <source>The robot&apos;s program</source>
        <translation>Das Programm des Roboters</translation>
    </message>
    <message>
        <source>Logs</source>
        <translation>Logs</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Another one</source>
        <translation>&amp;Weitere</translation>
    </message>
</context>
<context>
    <name>widgets::ActuatorPanel</name>
    <message>
        <source>Release</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Lets the robots&apos; programs set these actuators again</source>
        <translation>Lässt die Programme der Roboter diese Aktoren wieder stellen</translation>
    </message>
    <message>
        <source>Whether the actuators could be set</source>
        <translation>Ob die Aktoren gestellt werden konnten</translation>
    </message>
    <message>
        <source>Holds %1 between %2 and %3 %4</source>
        <translation>Hält %1 zwischen %2 und %3 %4</translation>
    </message>
    <message>
        <source>The value to hold</source>
        <translation>Der Wert, der gehalten wird</translation>
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
        <source>ahead</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>up</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>steering</source>
        <translation>Lenkung</translation>
    </message>
    <message>
        <source>blocked</source>
        <translation>blockiert</translation>
    </message>
    <message>
        <source>Blocked: %1</source>
        <translation>Blockiert: %1</translation>
    </message>
    <message>
        <source>It has hit an obstacle since its last command</source>
        <translation>Was er bewegt, ist seit seinem letzten Kommando auf ein Hindernis gestoßen</translation>
    </message>
</context>
<context>
    <name>widgets::BaseStateView</name>
    <message>
        <source>%1 mm/s, %2°/s</source>
        <translation>%1 mm/s, %2°/s</translation>
    </message>
    <message>
        <source>front %1</source>
        <translation>vorn %1</translation>
    </message>
    <message>
        <source>rear %1</source>
        <translation>hinten %1</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Switches the motors on and off, at the base</source>
        <translation>Schaltet die Motoren an der Basis ein und aus</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Sonars</source>
        <translation>Sonare</translation>
    </message>
    <message>
        <source>Switches the sonars on and off</source>
        <translation>Schaltet die Sonare ein und aus</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Reset odometry</source>
        <translation>Odometrie zurücksetzen</translation>
    </message>
    <message>
        <source>Makes this pose the odometry&apos;s origin</source>
        <translation>Macht diesen Ort zum Ursprung der Odometrie</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Age of this state</source>
        <translation>Alter dieses Zustands</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Charge level; at the lowest voltage the robot switches itself off</source>
        <translation>Wie voll er ist; bei seiner niedrigsten Spannung schaltet sich der Roboter aus</translation>
    </message>
    <message>
        <source>What the battery needs</source>
        <translation>Was der Akku braucht</translation>
    </message>
    <message>
        <source>Whether the motors hold and turn the wheels</source>
        <translation>Ob die Motoren die Räder halten und drehen</translation>
    </message>
    <message>
        <source>Whether the sonars fire</source>
        <translation>Ob die Sonare messen</translation>
    </message>
    <message>
        <source>Stall</source>
        <translation>Blockade</translation>
    </message>
    <message>
        <source>Stalled wheels</source>
        <translation>Räder, die sich drehen sollten, es aber nicht tun</translation>
    </message>
    <message>
        <source>Bumpers</source>
        <translation>Stoßfänger</translation>
    </message>
    <message>
        <source>Pressed bumpers, from left to right</source>
        <translation>Gedrückte Stoßfänger, von links nach rechts</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>The button on the robot, and STOP of this workbench</source>
        <translation>Der Taster am Roboter und STOP dieser Werkbank</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Temperature of the base&apos;s electronics</source>
        <translation>Temperatur der Elektronik der Basis</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Flags of its microcontroller</source>
        <translation>Fehlerbits seines Mikrocontrollers</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Odometry</source>
        <translation>Odometrie</translation>
    </message>
    <message>
        <source>Pose from the wheels: x, y, heading</source>
        <translation>Pose nach den Rädern: x, y, Richtung</translation>
    </message>
    <message>
        <source>Requested</source>
        <translation>Angefordert</translation>
    </message>
    <message>
        <source>Velocity that the program requested (drive/request)</source>
        <translation>Was sein Programm von den Motoren angefordert hat (drive/request)</translation>
    </message>
    <message>
        <source>Real</source>
        <translation>Wirklich</translation>
    </message>
    <message>
        <source>From the wheels: forward, and counterclockwise</source>
        <translation>Wie sich die Räder drehen: vorwärts und gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>Räder</translation>
    </message>
    <message>
        <source>Speeds of the left and right wheels&apos; rims</source>
        <translation>Geschwindigkeiten der Umfänge des linken und rechten Rads</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Leitung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Whether packets arrive</source>
        <translation>Ob Datenpakete kommen</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Address of the robot; of a simulated one, where it listens</source>
        <translation>Adresse des Roboters; bei einem simulierten, wo er lauscht</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Name, class and subclass from the handshake</source>
        <translation>Name, Klasse und Unterklasse aus dem Verbindungsaufbau</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>Who drives a simulated robot through its port</source>
        <translation>Wer einen simulierten Roboter über seinen Port fährt</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Datenpakete</translation>
    </message>
    <message>
        <source>From the robot, over the last seconds</source>
        <translation>Vom Roboter, in den letzten Sekunden</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Packets whose checksum was wrong, and bytes that belonged to no packet</source>
        <translation>Datenpakete mit falscher Prüfsumme, und Bytes, die zu keinem Datenpaket gehörten</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Umlaufzeit</translation>
    </message>
    <message>
        <source>Time until the last request was answered</source>
        <translation>Bis die letzte Anfrage beantwortet war</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>Längste Lücke</translation>
    </message>
    <message>
        <source>Interval between information packets, over the last seconds; nominally 100 ms</source>
        <translation>Zwischen zwei Informationspaketen, in den letzten Sekunden; sie kommen alle 100 ms</translation>
    </message>
    <message>
        <source>Reconnected</source>
        <translation>Neu verbunden</translation>
    </message>
    <message>
        <source>Number of times the connection was lost and restored</source>
        <translation>Wie oft die Leitung verloren ging und wiederkam</translation>
    </message>
    <message>
        <source>Status of the line</source>
        <translation>Status der Leitung</translation>
    </message>
    <message>
        <source>Connect now</source>
        <translation>Jetzt verbinden</translation>
    </message>
    <message>
        <source>Tries to reach the robot at once, instead of after the pause</source>
        <translation>Versucht sofort, den Roboter zu erreichen, statt nach der Pause</translation>
    </message>
    <message>
        <source>What was refused</source>
        <translation>Was abgelehnt wurde</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>%1 has no wheels. Choose a robot that drives.</source>
        <translation>%1 hat keine Räder. Einen Roboter wählen, der fährt.</translation>
    </message>
    <message>
        <source>The base has been silent for %1 s: this is its last state.</source>
        <translation>Die Basis schweigt seit %1 s: dies ist ihr letzter Zustand.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>both sides are stalled</source>
        <translation>beide Seiten sind blockiert</translation>
    </message>
    <message>
        <source>left is stalled</source>
        <translation>links ist blockiert</translation>
    </message>
    <message>
        <source>right is stalled</source>
        <translation>rechts ist blockiert</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>not fitted</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>pressed: %1</source>
        <translation>gedrückt: %1</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>STOP is engaged in this workbench</source>
        <translation>STOP ist in dieser Werkbank ausgelöst</translation>
    </message>
    <message>
        <source>pressed on the robot</source>
        <translation>am Roboter gedrückt</translation>
    </message>
    <message>
        <source>released</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>%1 m, %2 m, %3°</source>
        <translation>%1 m, %2 m, %3°</translation>
    </message>
    <message>
        <source>left %1, right %2 mm/s</source>
        <translation>links %1, rechts %2 mm/s</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>nicht gemeldet</translation>
    </message>
    <message>
        <source>%1/s, %2 kB/s; %3 in all</source>
        <translation>%1/s, %2 kB/s; %3 insgesamt</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1, %2 verloren</translation>
    </message>
    <message>
        <source>1 checksum</source>
        <translation>1 Prüfsumme</translation>
    </message>
    <message>
        <source>%1 checksums</source>
        <translation>%1 Prüfsummen</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 Byte</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms: too long</source>
        <translation>%1 ms: zu lang</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>zweimal</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>No robot. Open a map or scene with robots on wheels, or connect to one (menu Robot).</source>
        <translation>Kein Roboter. Eine Karte oder Szene mit Robotern auf Rädern öffnen oder einen verbinden (Menü Roboter).</translation>
    </message>
</context>
<context>
    <name>widgets::BatteryGauge</name>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Voltage and level of the robot&apos;s battery</source>
        <translation>Spannung und Füllstand des Akkus des Roboters</translation>
    </message>
</context>
<context>
    <name>widgets::BehaviorView</name>
    <message>
        <source>Force</source>
        <translation>Erzwingen</translation>
    </message>
    <message>
        <source>Keeps the behavior in the selected state until it is released</source>
        <translation>Hält das Verhalten im ausgewählten Zustand, bis es freigegeben wird</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Releases the behavior, so that it decides again</source>
        <translation>Das Verhalten entscheidet wieder</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Freezes all states until Step or a second click on Hold</source>
        <translation>Kein Zustand wechselt, bis ein Schritt folgt oder nicht mehr angehalten wird</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Lets the next change of a state happen</source>
        <translation>Lässt den nächsten Zustandswechsel geschehen</translation>
    </message>
    <message>
        <source>F10</source>
        <translation>F10</translation>
    </message>
    <message>
        <source>What is active</source>
        <translation>Was aktiv ist</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Starten Sie eine Simulation oder verbinden Sie sich mit einem Roboter und wählen Sie ihn in der Werkzeugleiste.</translation>
    </message>
    <message>
        <source>The robot has not reported its behavior yet. Start its program.</source>
        <translation>Der Roboter hat sein Verhalten noch nicht gemeldet. Starten Sie sein Programm.</translation>
    </message>
</context>
<context>
    <name>widgets::BookmarkModel</name>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Length [s]</source>
        <translation>Länge [s]</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
</context>
<context>
    <name>widgets::BookmarksView</name>
    <message>
        <source>Bookmark</source>
        <translation>Lesezeichen setzen</translation>
    </message>
    <message>
        <source>Adds a bookmark at this moment</source>
        <translation>Setzt ein Lesezeichen an diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen bookmark</source>
        <translation>Entfernt das gewählte Lesezeichen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change of the bookmarks</source>
        <translation>Macht die letzte Änderung der Lesezeichen rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redoes what was undone</source>
        <translation>Stellt wieder her, was rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Search bookmarks</source>
        <translation>Lesezeichen suchen</translation>
    </message>
    <message>
        <source>Shows only bookmarks whose text contains this</source>
        <translation>Zeigt nur Lesezeichen, deren Text dies enthält</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Enter jumps to a bookmark, F2 edits its text</source>
        <translation>Die Eingabetaste springt zu einem Lesezeichen, F2 bearbeitet seinen Text</translation>
    </message>
    <message>
        <source>No log is open.</source>
        <translation>Kein Log ist offen.</translation>
    </message>
    <message>
        <source>There are no bookmarks. Press Ctrl+B to mark the moment that is shown.</source>
        <translation>Es gibt keine Lesezeichen. Strg+B drücken, um den gezeigten Zeitpunkt zu markieren.</translation>
    </message>
</context>
<context>
    <name>widgets::CalibrationView</name>
    <message>
        <source>Image stream</source>
        <translation>Bilderstrom</translation>
    </message>
    <message>
        <source>Which camera is calibrated</source>
        <translation>Welche Kamera kalibriert wird</translation>
    </message>
    <message>
        <source>Time of the image</source>
        <translation>Zeit des Bildes</translation>
    </message>
    <message>
        <source>What the camera sees</source>
        <translation>Was zu sehen ist</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Nothing is computed yet.</source>
        <translation>Noch ist nichts berechnet.</translation>
    </message>
    <message>
        <source>Camera: %1</source>
        <translation>Kamera: %1</translation>
    </message>
    <message>
        <source>The whole board is not seen.</source>
        <translation>Das Brett ist nicht ganz zu sehen.</translation>
    </message>
    <message>
        <source>Calibrate the lens first: its opening angle is not known.</source>
        <translation>Erst das Objektiv kalibrieren: Sein Öffnungswinkel ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Select a mark and click it in the image; you need at least %1, not all on one line.</source>
        <translation>Eine Marke auswählen und im Bild anklicken; mindestens %1 sind nötig, und nicht alle auf einer Geraden.</translation>
    </message>
    <message>
        <source>no board is seen</source>
        <translation>kein Brett zu sehen</translation>
    </message>
    <message>
        <source>a board is seen</source>
        <translation>ein Brett ist zu sehen</translation>
    </message>
    <message>
        <source>No camera. Open one with Robot &gt; Open a Camera…, or a robot or a log that has images.</source>
        <translation>Keine Kamera. Eine öffnen mit Roboter &gt; Kamera öffnen…, oder einen Roboter oder ein Log mit Bildern.</translation>
    </message>
    <message>
        <source>Select a mark first.</source>
        <translation>Erst eine Marke auswählen.</translation>
    </message>
    <message>
        <source>Select %1 first.</source>
        <translation>Erst %1 auswählen.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Wird gesendet…</translation>
    </message>
    <message>
        <source>The robot&apos;s solution of camera-pose has no parameter for it; “mounted” has.</source>
        <translation>Die Lösung des Roboters für camera-pose hat dafür keinen Parameter; „mounted“ hat ihn.</translation>
    </message>
    <message>
        <source>Set: %1. Save them in Solutions.</source>
        <translation>Gesetzt: %1. Gespeichert werden sie unter Lösungen.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Fits the whole image into the view</source>
        <translation>Passt das ganze Bild in die Ansicht ein</translation>
    </message>
</context>
<context>
    <name>widgets::ColorActions</name>
    <message>
        <source>1 stroke</source>
        <translation>1 Strich</translation>
    </message>
    <message>
        <source>%1 strokes</source>
        <translation>%1 Striche</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change of the samples</source>
        <translation>Macht die letzte Änderung der Proben rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redoes what was undone</source>
        <translation>Stellt wieder her, was rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
</context>
<context>
    <name>widgets::ColorBench</name>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Not %1</source>
        <translation>Nicht %1</translation>
    </message>
    <message>
        <source>Stroke: %1</source>
        <translation>Strich: %1</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>The strip is full; remove some images first (Delete)</source>
        <translation>Der Streifen ist voll; zuerst einige Bilder entfernen (Entf)</translation>
    </message>
</context>
<context>
    <name>widgets::ColorClassModel</name>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Recall</source>
        <translation>Trefferquote</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Pixels without a class. Strokes of the background keep the classes separate from it.</source>
        <translation>Pixel keiner Klasse. Striche des Hintergrunds halten Klassen davon getrennt.</translation>
    </message>
    <message>
        <source>Click on the color to change it; F2 or a double click edits the name</source>
        <translation>Ein Klick auf die Farbe ändert sie; F2 oder ein Doppelklick bearbeitet den Namen</translation>
    </message>
    <message>
        <source>Percentage of its strokes&apos; pixels that the other strokes find</source>
        <translation>Anteil der Pixel ihrer Striche, den die anderen Striche finden</translation>
    </message>
    <message>
        <source>Not known: a class needs two strokes, to test one against the other</source>
        <translation>Nicht bekannt: eine Klasse braucht zwei Striche, damit sich einer am anderen erproben lässt</translation>
    </message>
</context>
<context>
    <name>widgets::ColorClassesView</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds a class</source>
        <translation>Fügt eine Klasse hinzu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen class and its strokes</source>
        <translation>Entfernt die gewählte Klasse und ihre Striche</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Edits the name of the chosen class</source>
        <translation>Bearbeitet den Namen der gewählten Klasse</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Moves the chosen class up; its key and its number follow</source>
        <translation>Verschiebt die gewählte Klasse nach oben; ihre Taste und ihre Nummer folgen</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Moves the chosen class down; its key and its number follow</source>
        <translation>Verschiebt die gewählte Klasse nach unten; ihre Taste und ihre Nummer folgen</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
    <message>
        <source>Must not be</source>
        <translation>Ist nicht</translation>
    </message>
    <message>
        <source>The pixels of the next stroke must not be of the chosen class (N)</source>
        <translation>Die Pixel des nächsten Strichs dürfen nicht zur gewählten Klasse gehören (N)</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Last message</source>
        <translation>Letzte Meldung</translation>
    </message>
    <message>
        <source>How the table is made</source>
        <translation>Wie die Tabelle entsteht</translation>
    </message>
    <message>
        <source>Shows the method and its options</source>
        <translation>Zeigt das Verfahren und seine Optionen</translation>
    </message>
    <message>
        <source>Color classes</source>
        <translation>Farbklassen</translation>
    </message>
    <message>
        <source>A click chooses the class of the next stroke</source>
        <translation>Ein Klick wählt die Klasse des nächsten Strichs</translation>
    </message>
    <message>
        <source>Classes to start with; strokes keep the class of their name</source>
        <translation>Klassen für den Anfang; Striche behalten die Klasse ihres Namens</translation>
    </message>
    <message>
        <source>Next stroke:</source>
        <translation>Strich:</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>How much the next stroke counts</source>
        <translation>Wie stark der nächste Strich zählt</translation>
    </message>
    <message>
        <source>Color classes: %1</source>
        <translation>Farbklassen: %1</translation>
    </message>
    <message>
        <source>Add a class</source>
        <translation>Klasse hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Removed %1 with %2; Undo brings it back</source>
        <translation>%1 mit %2 entfernt; Rückgängig holt sie zurück</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Not renamed: %1</source>
        <translation>Nicht umbenannt: %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Color that %1 is shown in</source>
        <translation>Farbe, in der %1 gezeigt wird</translation>
    </message>
    <message>
        <source>Color of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>Vorlage: %1</translation>
    </message>
</context>
<context>
    <name>widgets::ColorCompareView</name>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Compares with a table in a file, even another team&apos;s</source>
        <translation>Vergleicht mit einer Tabelle in einer Datei, auch anderer Teams</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Keeps the table as it is now, to compare later ones with it</source>
        <translation>Behält die Tabelle, wie sie jetzt ist, um spätere damit zu vergleichen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Stops comparing</source>
        <translation>Beendet das Vergleichen</translation>
    </message>
    <message>
        <source>In the image</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Shows next to the image which of its pixels have another class</source>
        <translation>Zeigt neben dem Bild, welche seiner Pixel zu einer anderen Klasse gehören</translation>
    </message>
    <message>
        <source>Deselect</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Clears the selection of cells</source>
        <translation>Hebt die Auswahl der Zellen auf</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Compares with the table as it was some steps ago</source>
        <translation>Vergleicht mit der Tabelle, wie sie vor einigen Schritten war</translation>
    </message>
    <message>
        <source>What each class gained and lost, in cells</source>
        <translation>Was jede Klasse gewonnen und verloren hat, in Zellen</translation>
    </message>
    <message>
        <source>A click selects the cells that changed</source>
        <translation>Ein Klick wählt die Zellen aus, die sich geändert haben</translation>
    </message>
    <message>
        <source>What went wrong</source>
        <translation>Was schiefging</translation>
    </message>
    <message>
        <source>How many cells and pixels differ</source>
        <translation>Wie viele Zellen und Pixel sich unterscheiden</translation>
    </message>
    <message>
        <source>Compare with a color table</source>
        <translation>Mit einer Farbtabelle vergleichen</translation>
    </message>
    <message>
        <source>Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2);;All files (*)</source>
        <translation>Farbtabellen (*.c64 *.tm *.raw *.cal *.lut *.bz2);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation>%1 (jetzt)</translation>
    </message>
    <message>
        <source>The table of that step is being made…</source>
        <translation>Die Tabelle jenes Schritts wird gebildet…</translation>
    </message>
    <message>
        <source>There is no table to compare with.
Open one from a file, or keep the current one and continue drawing.</source>
        <translation>Es gibt keine Tabelle zum Vergleichen.
Eine aus einer Datei nehmen, oder die jetzige behalten und weiterzeichnen.</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Verglichen mit %1</translation>
    </message>
    <message>
        <source>No cell differs</source>
        <translation>Keine Zelle unterscheidet sich</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>1 cell differs</source>
        <translation>1 Zelle unterscheidet sich</translation>
    </message>
    <message>
        <source>%1 cells differ</source>
        <translation>%1 Zellen unterscheiden sich</translation>
    </message>
    <message>
        <source>, of this image&apos;s pixels %1 %</source>
        <translation>, von den Pixeln dieses Bilds %1 %</translation>
    </message>
</context>
<context>
    <name>widgets::ColorEffectRow</name>
    <message>
        <source>Pixels that the stroke takes from other classes</source>
        <translation>Was der Strich anderen Klassen nimmt</translation>
    </message>
    <message>
        <source>Drop outliers</source>
        <translation>Ausreißer verwerfen</translation>
    </message>
    <message>
        <source>Removes pixels of other classes from the stroke: what the brush touched next to a thin line</source>
        <translation>Entfernt aus dem Strich, was die Tabelle als andere Klasse kannte: was der Pinsel neben einer dünnen Linie berührt hat</translation>
    </message>
    <message>
        <source>pixels without a class</source>
        <translation>was zu keiner Klasse gehörte</translation>
    </message>
    <message>
        <source>%1 % of %2 (now %3)</source>
        <translation>%1 % von %2 (jetzt %3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>This stroke takes %1</source>
        <translation>Dieser Strich nimmt %1</translation>
    </message>
    <message>
        <source>1 of its pixels was of another class</source>
        <translation>1 seiner Pixel gehörte zu einer anderen Klasse</translation>
    </message>
    <message>
        <source>%1 of its pixels were of other classes</source>
        <translation>%1 seiner Pixel gehörten zu anderen Klassen</translation>
    </message>
</context>
<context>
    <name>widgets::ColorFileActions</name>
    <message>
        <source>Samples of colors (*.samples);;All files (*)</source>
        <translation>Farbproben (*.samples);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Color tables (*.c64)</source>
        <translation>Farbtabellen (*.c64)</translation>
    </message>
    <message>
        <source>Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2);;All files (*)</source>
        <translation>Farbtabellen (*.c64 *.tm *.raw *.cal *.lut *.bz2);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save samples</source>
        <translation>Proben speichern</translation>
    </message>
    <message>
        <source>Color samples</source>
        <translation>Farbproben</translation>
    </message>
    <message>
        <source>The samples of the new color table were not saved yet.</source>
        <translation>Die Proben der neuen Farbtabelle wurden noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>The samples in %1 were changed and not saved.</source>
        <translation>Die Proben in %1 wurden geändert und nicht gespeichert.</translation>
    </message>
    <message>
        <source>Save them?</source>
        <translation>Speichern?</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Starts new samples, with the classes of 2002</source>
        <translation>Beginnt neue Proben, mit den Klassen von 2002</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Opens samples from a file</source>
        <translation>Öffnet Proben aus einer Datei</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saves the samples to their file</source>
        <translation>Speichert die Proben in ihrer Datei</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Saves the samples to another file</source>
        <translation>Speichert die Proben in einer anderen Datei</translation>
    </message>
    <message>
        <source>&amp;Merge samples…</source>
        <translation>Proben zusammen&amp;führen…</translation>
    </message>
    <message>
        <source>Adds the samples of another file to these</source>
        <translation>Fügt die Proben einer anderen Datei zu diesen hinzu</translation>
    </message>
    <message>
        <source>&amp;Export table…</source>
        <translation>Tabelle &amp;exportieren…</translation>
    </message>
    <message>
        <source>Writes the table to a .c64 file, with the names of its classes in a file next to it</source>
        <translation>Schreibt die Tabelle in eine .c64-Datei, mit den Namen ihrer Klassen daneben</translation>
    </message>
    <message>
        <source>Exported cells may have &amp;several classes</source>
        <translation>Exportierte Zellen dürfen &amp;mehrere Klassen haben</translation>
    </message>
    <message>
        <source>Where classes are close, an exported cell belongs to all of them</source>
        <translation>Wo Klassen nah beieinander sind, gehört eine exportierte Zelle zu allen</translation>
    </message>
    <message>
        <source>&amp;Compare with table…</source>
        <translation>Mit Tabelle &amp;vergleichen…</translation>
    </message>
    <message>
        <source>Reads a table to compare with; yours does not change</source>
        <translation>Liest eine Tabelle zum Vergleichen; die eigene bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>More file actions</source>
        <translation>Mehr mit Dateien</translation>
    </message>
    <message>
        <source>Save as, merge, export the table, read a table to compare with</source>
        <translation>Speichern unter, zusammenführen, die Tabelle exportieren, eine Tabelle zum Vergleichen lesen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Open samples</source>
        <translation>Proben öffnen</translation>
    </message>
    <message>
        <source>Merge samples</source>
        <translation>Proben zusammenführen</translation>
    </message>
    <message>
        <source>Export color table</source>
        <translation>Farbtabelle exportieren</translation>
    </message>
    <message>
        <source>Compare with table</source>
        <translation>Mit Tabelle vergleichen</translation>
    </message>
</context>
<context>
    <name>widgets::ColorFiles</name>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>
… and %1 more</source>
        <translation>
… und %1 weitere</translation>
    </message>
    <message>
        <source>Only a part of %1 could be read. It was opened without a name, so that the file is not overwritten:</source>
        <translation>Nur ein Teil von %1 war lesbar. Er ist ohne Namen geöffnet, damit die Datei bleibt, wie sie ist:</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Merge %1</source>
        <translation>%1 zusammenführen</translation>
    </message>
    <message>
        <source>%1 came from %2</source>
        <translation>%1 kamen aus %2</translation>
    </message>
    <message>
        <source>Only a part of %1 could be read and was added:</source>
        <translation>Nur ein Teil von %1 war lesbar und wurde hinzugefügt:</translation>
    </message>
    <message>
        <source>Exported: %1</source>
        <translation>Exportiert: %1</translation>
    </message>
    <message>
        <source>
Cells of several classes, one of them above %1, that keep only the best one, because the format has no room for more: %2</source>
        <translation>
Zellen mehrerer Klassen, eine davon über %1, die nur die beste behalten, da das Format keinen Platz für mehr hat: %2</translation>
    </message>
    <message>
        <source>
The corrections of cameras and vignetting are not part of the table</source>
        <translation>
Die Korrekturen von Kameras und Vignettierung sind nicht Teil der Tabelle</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Verglichen mit %1</translation>
    </message>
    <message>
        <source>; its classes %1 are not among yours and are ignored</source>
        <translation>; ihre Klassen %1 sind nicht unter den eigenen und zählen als keine</translation>
    </message>
    <message>
        <source>Changes cannot be backed up: %1</source>
        <translation>Änderungen können nicht gesichert werden: %1</translation>
    </message>
    <message>
        <source>Unsaved samples could not be restored: %1</source>
        <translation>Nicht gespeicherte Proben konnten nicht wiederhergestellt werden: %1</translation>
    </message>
    <message>
        <source>The program ended without saving last time. Unsaved samples were restored: %1. Save them to keep them.</source>
        <translation>Das Programm endete letztes Mal ohne Speichern. Nicht gespeicherte Proben wurden wiederhergestellt: %1. Speichern, um sie zu behalten.</translation>
    </message>
    <message>
        <source>The strip is full; remove some images first (Delete)</source>
        <translation>Der Streifen ist voll; zuerst einige Bilder entfernen (Entf)</translation>
    </message>
    <message>
        <source>Pictures added: %1</source>
        <translation>Bilder hinzugefügt: %1</translation>
    </message>
    <message>
        <source>; there was no room for %1 more, remove some images first (Delete)</source>
        <translation>; für %1 weitere war kein Platz, zuerst einige Bilder entfernen (Entf)</translation>
    </message>
    <message>
        <source>. These could not be read:</source>
        <translation>. Diese waren nicht lesbar:</translation>
    </message>
</context>
<context>
    <name>widgets::ColorFrameFinder</name>
    <message>
        <source>There are no images to search: open a log, or show images of a robot in the view Color image</source>
        <translation>Es gibt keine Bilder zum Durchsuchen: ein Log öffnen, oder Bilder eines Roboters in der Ansicht Farbbild zeigen</translation>
    </message>
    <message>
        <source>There are no images of %1 in the logs and in the history</source>
        <translation>In den Logs und im Verlauf gibt es keine Bilder von %1</translation>
    </message>
    <message>
        <source>history of %1</source>
        <translation>Verlauf von %1</translation>
    </message>
</context>
<context>
    <name>widgets::ColorFramesView</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Searches all images for those where the table looks suspicious</source>
        <translation>Durchsucht alle Bilder nach solchen, in denen die Tabelle verdächtig aussieht</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops the search</source>
        <translation>Beendet die Suche</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Returns to the newest images, from those of the history</source>
        <translation>Zeigt wieder die neuesten Bilder, nicht die des Verlaufs</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Which classes are searched: those of objects, but not ground and walls</source>
        <translation>Welche Klassen gesucht werden: die von Objekten, nicht Boden und Wände</translation>
    </message>
    <message>
        <source>⚠ The table has changed</source>
        <translation>⚠ Die Tabelle hat sich geändert</translation>
    </message>
    <message>
        <source>These frames were found with an older table; search again (Ctrl+Shift+F)</source>
        <translation>Diese Bilder wurden mit einer älteren Tabelle gefunden; noch einmal suchen (Strg+Umschalt+F)</translation>
    </message>
    <message>
        <source>What was searched, and what was found</source>
        <translation>Was durchsucht und was gefunden wurde</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Suspicious images</source>
        <translation>Verdächtige Bilder</translation>
    </message>
    <message>
        <source>A click or Enter shows an image</source>
        <translation>Ein Klick oder die Eingabetaste zeigt ein Bild</translation>
    </message>
    <message>
        <source>What went wrong</source>
        <translation>Was schiefging</translation>
    </message>
    <message>
        <source>%1: reading</source>
        <translation>%1: wird gelesen</translation>
    </message>
    <message>
        <source>%1: %2, suspicious: %3</source>
        <translation>%1: %2, verdächtig: %3</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source> (the %1 worst are listed)</source>
        <translation> (die %1 schlimmsten sind aufgelistet)</translation>
    </message>
    <message>
        <source>, unreadable: %1</source>
        <translation>, nicht lesbar: %1</translation>
    </message>
    <message>
        <source>, canceled</source>
        <translation>, abgebrochen</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Noch einmal suchen</translation>
    </message>
    <message>
        <source>%p %</source>
        <translation>%p %</translation>
    </message>
    <message>
        <source>opening: %p %</source>
        <translation>wird geöffnet: %p %</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>Nothing suspicious was found.</source>
        <translation>Nichts Verdächtiges gefunden.</translation>
    </message>
    <message>
        <source>Search lists the images with the most suspicious pixels first:
specks, ambiguous colors, and areas enclosed by another color.</source>
        <translation>Die Suche listet die Bilder mit den meisten verdächtigen Pixeln zuerst auf:
Sprenkel, mehrdeutige Farben, und was eine andere Farbe umschließt.</translation>
    </message>
</context>
<context>
    <name>widgets::ColorImageView</name>
    <message>
        <source>This is</source>
        <translation>Dies ist</translation>
    </message>
    <message>
        <source>This must not be</source>
        <translation>Dies darf nicht sein</translation>
    </message>
    <message>
        <source>The whole spot is</source>
        <translation>Der ganze Fleck ist</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Shows the image pixel by pixel</source>
        <translation>Zeigt das Bild Pixel für Pixel</translation>
    </message>
    <message>
        <source>Collect</source>
        <translation>Sammeln</translation>
    </message>
    <message>
        <source>Adds this image to the strip, to return to it later</source>
        <translation>Sammelt dieses Bild im Streifen, um darauf zurückzukommen</translation>
    </message>
    <message>
        <source>Two pictures</source>
        <translation>Zwei Bilder</translation>
    </message>
    <message>
        <source>Shows the classified image next to it</source>
        <translation>Zeigt das klassifizierte Bild daneben</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Shows the strokes in the image</source>
        <translation>Zeigt die Striche im Bild</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancels the stroke or the selection</source>
        <translation>Bricht den Strich oder die Auswahl ab</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Sends the table to the selected robot&apos;s program</source>
        <translation>Sendet die Tabelle an das Programm des gewählten Roboters</translation>
    </message>
    <message>
        <source>Send always</source>
        <translation>Immer senden</translation>
    </message>
    <message>
        <source>Sends each new table to the robot at once</source>
        <translation>Sendet jede neue Tabelle sofort an den Roboter</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Shows the collected images below this one</source>
        <translation>Zeigt die gesammelten Bilder unter diesem</translation>
    </message>
    <message>
        <source>Open pictures…</source>
        <translation>Bilder öffnen…</translation>
    </message>
    <message>
        <source>Adds pictures to the strip, to paint in: PNG, JPEG, .yuyv</source>
        <translation>Fügt dem Streifen Bilder hinzu, um darin zu malen: PNG, JPEG, .yuyv</translation>
    </message>
    <message>
        <source>Open a folder of pictures…</source>
        <translation>Einen Ordner mit Bildern öffnen…</translation>
    </message>
    <message>
        <source>Adds all pictures of a folder to the strip, to paint in</source>
        <translation>Fügt alle Bilder eines Ordners dem Streifen hinzu, um darin zu malen</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Ordner mit Bildern</translation>
    </message>
    <message>
        <source>Open pictures</source>
        <translation>Bilder öffnen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.yuyv);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.yuyv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Image stream</source>
        <translation>Bilderstrom</translation>
    </message>
    <message>
        <source>Which images are shown</source>
        <translation>Welche Bilder gezeigt werden</translation>
    </message>
    <message>
        <source>Right picture</source>
        <translation>Rechtes Bild</translation>
    </message>
    <message>
        <source>What the right picture shows</source>
        <translation>Was das rechte Bild zeigt</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Classes by the reference</source>
        <translation>Klassen nach der Referenz</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Ambiguity</source>
        <translation>Mehrdeutigkeit</translation>
    </message>
    <message>
        <source>Time of the image</source>
        <translation>Zeit des Bilds</translation>
    </message>
    <message>
        <source>Whether the image is live, frozen or from the strip</source>
        <translation>Ob das Bild live, eingefroren oder aus dem Streifen ist</translation>
    </message>
    <message>
        <source>Pixel under the cursor: position, color, class, confidence, cell</source>
        <translation>Pixel unter dem Mauszeiger: Position, Farbe, Klasse, wie sicher sie ist, Zelle</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Color image: %1</source>
        <translation>Farbbild: %1</translation>
    </message>
    <message>
        <source>Choose a class and paint in the left picture</source>
        <translation>Eine Klasse wählen und im linken Bild malen</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>Nach %1</translation>
    </message>
    <message>
        <source>There is no table to compare with yet</source>
        <translation>Es gibt noch keine Tabelle zum Vergleichen</translation>
    </message>
    <message>
        <source>Different from %1; magenta: no class now</source>
        <translation>Anders als nach %1; magenta: jetzt keine</translation>
    </message>
    <message>
        <source>Bright: another class is nearly as likely</source>
        <translation>Hell: eine andere Klasse ist fast ebenso wahrscheinlich</translation>
    </message>
    <message>
        <source>no image yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>eingefroren</translation>
    </message>
    <message>
        <source>history</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source> %1 % sure</source>
        <translation> %1 % sicher</translation>
    </message>
    <message>
        <source>cell %1 %2 %3</source>
        <translation>Zelle %1 %2 %3</translation>
    </message>
    <message>
        <source>Fits the whole image into the view</source>
        <translation>Passt das ganze Bild in die Ansicht ein</translation>
    </message>
</context>
<context>
    <name>widgets::ColorQualityView</name>
    <message>
        <source>Labeled images…</source>
        <translation>Bilder mit Klassen…</translation>
    </message>
    <message>
        <source>Scores the table on a folder of images with labels: gray PNGs of the same name with the numbers of the classes</source>
        <translation>Bewertet die Tabelle über einen Ordner von Bildern mit wahren Klassen: graue PNGs gleichen Namens mit den Nummern der Klassen</translation>
    </message>
    <message>
        <source>Simulator&apos;s classes</source>
        <translation>Simulatorklassen</translation>
    </message>
    <message>
        <source>Scores the table against the simulated camera&apos;s true classes</source>
        <translation>Bewertet die Tabelle anhand der wahren Klassen der simulierten Kamera</translation>
    </message>
    <message>
        <source>Without images</source>
        <translation>Ohne Bilder</translation>
    </message>
    <message>
        <source>Removes the labeled images</source>
        <translation>Entfernt die Bilder mit wahren Klassen</translation>
    </message>
    <message>
        <source>State of the labeled images</source>
        <translation>Zustand der Bilder mit wahren Klassen</translation>
    </message>
    <message>
        <source>Your strokes</source>
        <translation>Eigene Striche</translation>
    </message>
    <message>
        <source>Labeled images</source>
        <translation>Bilder mit Klassen</translation>
    </message>
    <message>
        <source>Folder of images with labels</source>
        <translation>Ordner von Bildern mit wahren Klassen</translation>
    </message>
    <message>
        <source>Reading… %1 %</source>
        <translation>Wird gelesen… %1 %</translation>
    </message>
    <message>
        <source>No labeled images</source>
        <translation>Keine Bilder mit wahren Klassen</translation>
    </message>
    <message>
        <source>Labeled images: %1</source>
        <translation>Bilder mit wahren Klassen: %1</translation>
    </message>
    <message>
        <source>; %1 could not be read</source>
        <translation>; %1 waren nicht lesbar</translation>
    </message>
    <message>
        <source>Images of the simulation: %1</source>
        <translation>Bilder der Simulation: %1</translation>
    </message>
    <message>
        <source>Based on %1, at least %2 per class and %3 of the background; each counts the same, regardless of size.</source>
        <translation>Auf der Grundlage von %1, mindestens %2 einer Klasse und %3 des Hintergrunds; jeder zählt gleich viel, wie groß er auch ist.</translation>
    </message>
    <message>
        <source> That is not much: the figures are only a rough guide.</source>
        <translation> Das ist wenig: die Zahlen sind nur ein Hinweis.</translation>
    </message>
    <message>
        <source>yours is better</source>
        <translation>die eigene ist besser</translation>
    </message>
    <message>
        <source>both are equal</source>
        <translation>beide sind gleich gut</translation>
    </message>
    <message>
        <source>that one is better</source>
        <translation>jene ist besser</translation>
    </message>
    <message>
        <source>your table finds more, but has more false colors</source>
        <translation>die eigene findet mehr, hat aber mehr falsche Farben</translation>
    </message>
    <message>
        <source>your table finds less, but has fewer false colors</source>
        <translation>die eigene findet weniger, hat aber weniger falsche Farben</translation>
    </message>
    <message>
        <source>%1: mean recall %2, false colors %3; %4.</source>
        <translation>%1: mittlere Trefferquote %2, falsche Farben %3; %4.</translation>
    </message>
    <message>
        <source>In %1 images spread over the log</source>
        <translation>In %1 über das Log verteilten Bildern</translation>
    </message>
    <message>
        <source>In the %1 images seen</source>
        <translation>In den %1 gesehenen Bildern</translation>
    </message>
    <message>
        <source>%1 no color is in an impossible place.</source>
        <translation>%1 ist keine Farbe, wo sie nicht sein kann.</translation>
    </message>
    <message>
        <source>%1 %2 % of the pixels have the color of an object where none can be, mostly %3 (%4 %); the view Find frames shows where.</source>
        <translation>%1 haben %2 % der Pixel die Farbe eines Dings, wo keines sein kann, meist %3 (%4 %); die Ansicht Bilder finden zeigt, wo.</translation>
    </message>
    <message>
        <source>%1 % %2</source>
        <translation>%1 % %2</translation>
    </message>
    <message>
        <source> Of the background&apos;s colors there it takes for a class: %1.</source>
        <translation> Von den Farben des Hintergrunds dort hält sie für eine Klasse: %1.</translation>
    </message>
    <message>
        <source> Most of their pixels are of one class: %1.</source>
        <translation> Die meisten ihrer Pixel gehören zu einer Klasse: %1.</translation>
    </message>
    <message>
        <source>Of the background it takes for a class: %1.</source>
        <translation>Vom Hintergrund hält sie für eine Klasse: %1.</translation>
    </message>
    <message>
        <source>The labeled images next to this are more reliable.</source>
        <translation>Die Bilder mit wahren Klassen daneben urteilen besser.</translation>
    </message>
    <message>
        <source>Not enough strokes to judge %1: draw a second one, to test one against the other.</source>
        <translation>Zu wenig, um %1 zu beurteilen: einen zweiten Strich zeichnen, damit sich einer am anderen erproben lässt.</translation>
    </message>
    <message>
        <source>No stroke of the background: false colors are not known.</source>
        <translation>Kein Strich des Hintergrunds: falsche Farben sind nicht bekannt.</translation>
    </message>
    <message>
        <source>A single stroke of the background: false colors are not known; draw a second one.</source>
        <translation>Ein einziger Strich des Hintergrunds: falsche Farben sind nicht bekannt; einen zweiten zeichnen.</translation>
    </message>
    <message>
        <source>There are no strokes yet. Draw at least two of each class, and some of the background.</source>
        <translation>Es gibt noch keine Striche. Mindestens zwei jeder Klasse und einige des Hintergrunds zeichnen.</translation>
    </message>
    <message>
        <source>Finding out…</source>
        <translation>Wird ermittelt…</translation>
    </message>
    <message>
        <source>Waiting for the simulated camera. Only a simulated robot, or its log, has true classes.</source>
        <translation>Wartet auf die simulierte Kamera. Nur ein simulierter Roboter oder sein Log kennt wahre Klassen.</translation>
    </message>
    <message>
        <source>No labeled images. Open a folder of them, or use those of the simulator.</source>
        <translation>Keine Bilder mit wahren Klassen. Einen Ordner davon öffnen oder die des Simulators nehmen.</translation>
    </message>
</context>
<context>
    <name>widgets::ColorReferences</name>
    <message>
        <source>the table before all steps</source>
        <translation>die Tabelle vor allen Schritten</translation>
    </message>
    <message>
        <source>the table after step %1, %2</source>
        <translation>die Tabelle nach Schritt %1, %2</translation>
    </message>
</context>
<context>
    <name>widgets::ColorSamplesView</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected strokes</source>
        <translation>Entfernt die ausgewählten Striche</translation>
    </message>
    <message>
        <source>Lighting…</source>
        <translation>Beleuchtung…</translation>
    </message>
    <message>
        <source>Names the lighting of the images of the selected strokes</source>
        <translation>Benennt das Licht, in dem die Bilder der ausgewählten Striche aufgenommen wurden</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>A double click shows the image of a stroke</source>
        <translation>Ein Doppelklick zeigt das Bild eines Strichs</translation>
    </message>
    <message>
        <source>There are no strokes yet. Choose a class and draw in the view Color image.</source>
        <translation>Es gibt noch keine Striche. Eine Klasse wählen und in der Ansicht Farbbild zeichnen.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>A click goes to the state after that change</source>
        <translation>Ein Klick geht zum Stand nach dieser Änderung</translation>
    </message>
    <message>
        <source>At first</source>
        <translation>Am Anfang</translation>
    </message>
    <message>
        <source>Number of strokes</source>
        <translation>Anzahl der Striche</translation>
    </message>
    <message>
        <source>Must not be</source>
        <translation>Darf nicht sein</translation>
    </message>
    <message>
        <source>%1 of %2 strokes</source>
        <translation>%1 von %2 Strichen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
    <message>
        <source>Lighting %1</source>
        <translation>Beleuchtung %1</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>The light that these images were taken in:</source>
        <translation>Das Licht, in dem diese Bilder aufgenommen wurden:</translation>
    </message>
    <message>
        <source>The image %1 is not available: it was not collected, and its time is not on the timeline. Open its log to see it.</source>
        <translation>Das Bild %1 ist nicht hier: es wurde nicht gesammelt, und seine Zeit ist nicht auf der Zeitleiste. Sein Log öffnen, um es zu sehen.</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Class %1</source>
        <translation>Klasse %1</translation>
    </message>
    <message>
        <source>Show its &amp;image</source>
        <translation>Sein &amp;Bild zeigen</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Klasse</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>&amp;Gewicht</translation>
    </message>
    <message>
        <source>Must &amp;not be of its class</source>
        <translation>Darf &amp;nicht zu seiner Klasse gehören</translation>
    </message>
    <message>
        <source>Is of its class</source>
        <translation>Gehört zu seiner Klasse</translation>
    </message>
</context>
<context>
    <name>widgets::ColorSender</name>
    <message>
        <source>%1 does not answer; is its program running?</source>
        <translation>%1 antwortet nicht; läuft sein Programm?</translation>
    </message>
    <message>
        <source>There is no robot to send it to</source>
        <translation>Es gibt keinen Roboter, dem sie gesendet werden kann</translation>
    </message>
    <message>
        <source>Sending it to %1…</source>
        <translation>Wird an %1 gesendet…</translation>
    </message>
    <message>
        <source>painted, not saved</source>
        <translation>gemalt, nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 refuses it: %2</source>
        <translation>%1 lehnt sie ab: %2</translation>
    </message>
    <message>
        <source>%1 received something else (%2 instead of %3); send it again</source>
        <translation>%1 hat etwas anderes bekommen (%2 statt %3); noch einmal senden</translation>
    </message>
    <message>
        <source>%1 uses it (%2)</source>
        <translation>%1 verwendet sie (%2)</translation>
    </message>
</context>
<context>
    <name>widgets::ColorSpaceCanvas</name>
    <message>
        <source>Color space</source>
        <translation>Farbraum</translation>
    </message>
    <message>
        <source>Drag: turn; right or middle button: move; wheel: zoom; double click: reset. Shift+drag: select what is inside (with Control: add, with Alt: remove); Escape: clear the selection</source>
        <translation>Ziehen: drehen; rechte oder mittlere Taste: verschieben; Mausrad: zoomen; Doppelklick: zurücksetzen. Umschalt und ziehen: auswählen, was darin ist (mit Strg: hinzufügen, mit Alt: entfernen); Esc: Auswahl aufheben</translation>
    </message>
</context>
<context>
    <name>widgets::ColorSpacePanel</name>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Which classes are shown: their surfaces, their samples, and the pixels that the table puts into them</source>
        <translation>Welche Klassen gezeigt werden: ihre Oberflächen, ihre Proben, und die Pixel, die die Tabelle ihnen zuordnet</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Alle Klassen</translation>
    </message>
    <message>
        <source>Shows all classes</source>
        <translation>Zeigt alle Klassen</translation>
    </message>
    <message>
        <source>No classes</source>
        <translation>Keine Klassen</translation>
    </message>
    <message>
        <source>Hides all classes, to show a few</source>
        <translation>Blendet alle Klassen aus, um einige zu zeigen</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>Whose surfaces are shown</source>
        <translation>Wessen Oberflächen gezeigt werden</translation>
    </message>
    <message>
        <source>table&apos;s surfaces</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>reference&apos;s surfaces</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>what differs</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Opacity of surfaces</source>
        <translation>Deckkraft der Oberflächen</translation>
    </message>
    <message>
        <source>How much the surfaces hide what is behind them</source>
        <translation>Wie stark die Oberflächen verdecken, was dahinter ist</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cuts a part off, to look inside</source>
        <translation>Schneidet einen Teil ab, um hineinzusehen</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Ort des Schnitts</translation>
    </message>
    <message>
        <source>Where it is cut</source>
        <translation>Wo geschnitten wird</translation>
    </message>
    <message>
        <source>Other part</source>
        <translation>Anderer Teil</translation>
    </message>
    <message>
        <source>Shows the other side of the cut</source>
        <translation>Zeigt stattdessen, was abgeschnitten ist</translation>
    </message>
    <message>
        <source>There is no table to compare with: choose a reference first</source>
        <translation>Es gibt keine Tabelle zum Vergleichen: zuerst eine Referenz wählen</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>no cut</source>
        <translation>kein Schnitt</translation>
    </message>
    <message>
        <source>cut the view</source>
        <translation>Ansicht schneiden</translation>
    </message>
    <message>
        <source>cut at %1</source>
        <translation>Schnitt bei %1</translation>
    </message>
</context>
<context>
    <name>widgets::ColorSpaceView</name>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Shows the colors of the image&apos;s pixels</source>
        <translation>Zeigt die Farben der Pixel des Bilds</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Shows the colors that strokes touched, in their class&apos;s color</source>
        <translation>Zeigt die Farben, die Striche berührt haben, in der Farbe ihrer Klasse</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Shows the surfaces of the table&apos;s classes</source>
        <translation>Zeigt die Oberflächen der Klassen der Tabelle</translation>
    </message>
    <message>
        <source>Classes and cut</source>
        <translation>Klassen und Schnitt</translation>
    </message>
    <message>
        <source>Chooses which classes are shown, and where the space is cut</source>
        <translation>Wählt, welche Klassen gezeigt werden und wo der Raum geschnitten wird</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Resets the view</source>
        <translation>Setzt die Ansicht zurück</translation>
    </message>
    <message>
        <source>Clear selection</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Clears the selection (Escape in the picture)</source>
        <translation>Hebt die Auswahl auf (Esc im Bild)</translation>
    </message>
    <message>
        <source>Color space</source>
        <translation>Farbraum</translation>
    </message>
    <message>
        <source>In which space colors are shown</source>
        <translation>In welchem Raum Farben gezeigt werden</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Was ausgewählt ist</translation>
    </message>
    <message>
        <source>Color under the cursor</source>
        <translation>Farbe unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>Cell under the cursor</source>
        <translation>Zelle unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>There are no colors yet.
Open a color image and draw strokes in it: its pixels, the strokes&apos; samples and the table that is made from them appear here.</source>
        <translation>Es gibt noch keine Farben.
Ein Farbbild öffnen und Striche darin zeichnen: seine Pixel, die Proben der Striche und die daraus gebildete Tabelle erscheinen hier.</translation>
    </message>
    <message>
        <source>Y %1  Cb %2  Cr %3</source>
        <translation>Y %1  Cb %2  Cr %3</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>reference: %1</source>
        <translation>Referenz: %1</translation>
    </message>
    <message>
        <source>margin %1 %</source>
        <translation>Abstand %1 %</translation>
    </message>
    <message>
        <source>pixels: %1</source>
        <translation>Pixel: %1</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>1 pixel</source>
        <translation>1 Pixel</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
</context>
<context>
    <name>widgets::ColorStrip</name>
    <message>
        <source>Collected images</source>
        <translation>Gesammelte Bilder</translation>
    </message>
    <message>
        <source>Collected images; a click shows one, Delete removes it</source>
        <translation>Gesammelte Bilder; ein Klick zeigt eines, Entf entfernt es</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>widgets::ColorToolRow</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>The clicked pixel belongs to the class</source>
        <translation>Das angeklickte Pixel gehört zur Klasse</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Painted pixels belong to the class</source>
        <translation>Was übermalt wird, gehört zur Klasse</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>The pixels of a rectangle belong to the class</source>
        <translation>Was ein Rechteck überdeckt, gehört zur Klasse</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>The pixels inside a drawn line belong to the class</source>
        <translation>Was eine Linie umfährt, gehört zur Klasse</translation>
    </message>
    <message>
        <source>Magic wand</source>
        <translation>Zauberstab</translation>
    </message>
    <message>
        <source>Similar colors around the click, up to an edge, belong to the class</source>
        <translation>Ähnliche Farben um den Klick herum, bis zu einer Kante, gehören zur Klasse</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Removes strokes of this image</source>
        <translation>Entfernt Striche dieses Bilds</translation>
    </message>
    <message>
        <source>Select colors</source>
        <translation>Farben auswählen</translation>
    </message>
    <message>
        <source>Selects the colors inside a drawn line, here and in the color space</source>
        <translation>Wählt die Farben dessen aus, was eine Linie umfährt, hier und im Farbraum</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Moves the image (also the middle button with any tool)</source>
        <translation>Verschiebt das Bild (mit jedem Werkzeug auch die mittlere Taste)</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Careful brush</source>
        <translation>Sorgfältiger Pinsel</translation>
    </message>
    <message>
        <source>The brush snaps to thin lines and skips other colors, such as the field next to a line</source>
        <translation>Der Pinsel rastet an dünnen Linien ein und lässt andere Farben aus, etwa das Feld neben einer Linie</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Class of the strokes; digit keys also choose it</source>
        <translation>Klasse der Striche; auch Ziffern wählen sie</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of brush and eraser in pixels; [ and ], Ctrl and wheel</source>
        <translation>Radius von Pinsel und Radierer in Pixeln; [ und ], Strg und Mausrad</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far colors may differ for the magic wand to include them</source>
        <translation>Wie stark sich Farben unterscheiden dürfen, damit der Zauberstab sie nimmt</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the classes over the left picture</source>
        <translation>Deckkraft der Klassen über dem linken Bild</translation>
    </message>
    <message>
        <source>Whether the robot uses this table</source>
        <translation>Ob der Roboter diese Tabelle verwendet</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>not %1</source>
        <translation>nicht %1</translation>
    </message>
    <message>
        <source>Must &amp;not be (N)</source>
        <translation>Darf &amp;nicht sein (N)</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnsView</name>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Keeps what is shown now</source>
        <translation>Behält, was jetzt gezeigt wird</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>List whose values are shown</source>
        <translation>Liste, deren Werte gezeigt werden</translation>
    </message>
    <message>
        <source>A sensor of the scene, or a stream, a colon, and a list of its messages: red1/range/laser: ranges</source>
        <translation>Ein Sensor der Szene oder ein Strom, ein Doppelpunkt und eine Liste seiner Nachrichten: red1/range/laser: ranges</translation>
    </message>
    <message>
        <source>Value under the cursor</source>
        <translation>Wert unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>Choose a sensor of the scene above, or type a stream and a list of its messages.</source>
        <translation>Oben einen Sensor der Szene wählen oder einen Strom und eine Liste seiner Nachrichten eingeben.</translation>
    </message>
    <message>
        <source>There are no values of %1 yet.</source>
        <translation>Es gibt noch keine Werte von %1.</translation>
    </message>
    <message>
        <source>Column graph</source>
        <translation>Säulendiagramm</translation>
    </message>
    <message>
        <source>Column graph: %1</source>
        <translation>Säulendiagramm: %1</translation>
    </message>
    <message>
        <source>1 value</source>
        <translation>1 Wert</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>There is no sensor %1 in this scene. Choose another one above.</source>
        <translation>In dieser Szene gibt es keinen Sensor %1. Wählen Sie oben einen anderen.</translation>
    </message>
</context>
<context>
    <name>widgets::CommandLog</name>
    <message>
        <source>No command begins with %1.</source>
        <translation>Kein Befehl beginnt mit %1.</translation>
    </message>
    <message>
        <source>No longer waiting: %1</source>
        <translation>Nicht mehr gewartet wird auf: %1</translation>
    </message>
</context>
<context>
    <name>widgets::CompareRow</name>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>How both images are shown</source>
        <translation>Wie beide Bilder gezeigt werden</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Second image</source>
        <translation>Zweites Bild</translation>
    </message>
    <message>
        <source>Images to compare with: another camera, another robot, or the logged ones (logged/…) if the program recomputes them</source>
        <translation>Mit welchen Bildern verglichen wird: einer anderen Kamera, einem anderen Roboter, oder den aufgezeichneten (logged/…), wo das Programm wieder läuft</translation>
    </message>
    <message>
        <source>Time shift</source>
        <translation>Zeitversatz</translation>
    </message>
    <message>
        <source>Time offset of the second image, s: before (-) or after the first one</source>
        <translation>Zeigt das zweite Bild so viele Sekunden vor (-) oder nach dem ersten</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Festhalten</translation>
    </message>
    <message>
        <source>Holds the second image while the first one continues, even across jumps in a log</source>
        <translation>Hält das zweite Bild fest, während das erste weiterläuft, auch über Sprünge in einem Log</translation>
    </message>
    <message>
        <source>Left: the first image; right: the second</source>
        <translation>Links: das erste Bild; rechts: das zweite</translation>
    </message>
    <message>
        <source>Amplification</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Gain of the difference; black where both images are the same</source>
        <translation>Wie viel größer Unterschiede gezeigt werden; schwarz ist, wo beide gleich sind</translation>
    </message>
</context>
<context>
    <name>widgets::ConfusionModel</name>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>%1 of %2 of %3: found to be %4</source>
        <translation>%1 von %2 der Klasse %3: erkannt als %4</translation>
    </message>
    <message>
        <source>1 pixel</source>
        <translation>1 Pixel</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>of no class</source>
        <translation>ohne Klasse</translation>
    </message>
    <message>
        <source>A second stroke of %1 is needed, to test one against the other</source>
        <translation>Ein zweiter Strich von %1 wird gebraucht, um einen am anderen zu erproben</translation>
    </message>
    <message>
        <source>Recall</source>
        <translation>Trefferquote</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Pixels that are %1</source>
        <translation>Pixel, die %1 sind</translation>
    </message>
    <message>
        <source>Found to be %1</source>
        <translation>Erkannt als %1</translation>
    </message>
</context>
<context>
    <name>widgets::ConfusionPanel</name>
    <message>
        <source>Notes on these figures</source>
        <translation>Was zu diesen Zahlen zu wissen ist</translation>
    </message>
    <message>
        <source>%1: true classes in rows, found ones in columns, in percent</source>
        <translation>%1: wahre Klassen in Zeilen, erkannte in Spalten, Anteile in Prozent</translation>
    </message>
    <message>
        <source>Mean recall %1    False colors %2</source>
        <translation>Mittlere Trefferquote %1    Falsche Farben %2</translation>
    </message>
    <message>
        <source>Mean recall: the share of a class&apos;s pixels that is found, averaged over the classes. False colors: the share of the background that is classified as a color of objects, such as orange or blue.</source>
        <translation>Mittlere Trefferquote: über die Klassen, welcher Anteil ihrer Pixel gefunden wird. Falsche Farben: der Anteil des Hintergrunds, der als Farbe von Objekten erkannt wird, etwa Orange oder Blau.</translation>
    </message>
</context>
<context>
    <name>widgets::ConsoleView</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selection, or everything</source>
        <translation>Kopiert die Auswahl oder alles</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Removes all output</source>
        <translation>Entfernt alle Ausgaben</translation>
    </message>
    <message>
        <source>Output of commands</source>
        <translation>Ausgabe von Befehlen</translation>
    </message>
    <message>
        <source>Type a command below: Tab completes it, Up recalls earlier ones. help lists all commands.</source>
        <translation>Unten einen Befehl eingeben: Tab vervollständigt ihn, Pfeil nach oben holt frühere Eingaben zurück. help listet alle Befehle auf.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Command, as in scripts</source>
        <translation>Befehl, wie in Skripten</translation>
    </message>
    <message>
        <source>What the command takes</source>
        <translation>Was der Befehl annimmt</translation>
    </message>
</context>
<context>
    <name>widgets::CursorModel</name>
    <message>
        <source>Between the cursors</source>
        <translation>Zwischen den Cursorn</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>Bei A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>Bei B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
</context>
<context>
    <name>widgets::CurveModel</name>
    <message>
        <source>%1: only the first values of the log are shown, the others need too much memory</source>
        <translation>%1: nur die ersten Werte des Logs werden gezeigt, die anderen brauchen zu viel Speicher</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: no values yet</source>
        <translation>%1: noch keine Werte</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>in the log only</source>
        <translation>nur im Log</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>At %1 s</source>
        <translation>Bei %1 s</translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation>Am Cursor</translation>
    </message>
</context>
<context>
    <name>widgets::CutStreams</name>
    <message>
        <source>Streams of the new log</source>
        <translation>Datenströme des neuen Logs</translation>
    </message>
    <message>
        <source>Comma-separated stream paths; * matches any text, - excludes. Empty: all streams.</source>
        <translation>Pfade von Datenströmen, durch Kommas getrennt; * steht für beliebigen Text, - schließt aus. Leer: alle Datenströme.</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>For example red1/*,-*/camera/image</source>
        <translation>Zum Beispiel red1/*,-*/camera/image</translation>
    </message>
    <message>
        <source>all streams</source>
        <translation>alle Datenströme</translation>
    </message>
    <message>
        <source>Streams</source>
        <translation>Datenströme</translation>
    </message>
    <message>
        <source>Checked streams are written into the new log</source>
        <translation>Angehakte Datenströme werden in das neue Log geschrieben</translation>
    </message>
    <message>
        <source>No stream is left.</source>
        <translation>Es bleibt kein Datenstrom übrig.</translation>
    </message>
</context>
<context>
    <name>widgets::DataModel</name>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>off – click to switch on</source>
        <translation>aus – klicken zum Einschalten</translation>
    </message>
    <message>
        <source>no message yet</source>
        <translation>noch keine Nachricht</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>%1 Hz, %2</source>
        <translation>%1 Hz, %2</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>%1&lt;br&gt;The debug key %2 is off. Click to switch it on.</source>
        <translation>%1&lt;br&gt;Der Debug-Schlüssel %2 ist aus. Klicken, um ihn einzuschalten.</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>difference: %1</source>
        <translation>Unterschied: %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>held – %1</source>
        <translation>gehalten – %1</translation>
    </message>
</context>
<context>
    <name>widgets::DataView</name>
    <message>
        <source>Remember now</source>
        <translation>Jetzt merken</translation>
    </message>
    <message>
        <source>Compares with the values that are shown now</source>
        <translation>Vergleicht mit den Werten, die jetzt gezeigt werden</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Kurve zeichnen</translation>
    </message>
    <message>
        <source>Plots the selected numbers over time</source>
        <translation>Zeichnet die ausgewählten Zahlen über der Zeit</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Table over time</source>
        <translation>Tabelle über der Zeit</translation>
    </message>
    <message>
        <source>Lists the selected values over time</source>
        <translation>Listet die ausgewählten Werte über der Zeit auf</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>Fills in a message to a robot and sends it</source>
        <translation>Eine Nachricht an einen Roboter ausfüllen und senden</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Switches on the debug key of the stream</source>
        <translation>Schaltet den Debug-Schlüssel des Datenstroms ein</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Copies the paths of the selected rows, as expressions take them</source>
        <translation>Kopiert die Pfade der ausgewählten Zeilen, wie Ausdrücke sie verwenden</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Copies the values with all digits</source>
        <translation>Kopiert die Werte mit allen Ziffern</translation>
    </message>
    <message>
        <source>Copy as JSON</source>
        <translation>Als JSON kopieren</translation>
    </message>
    <message>
        <source>Copies the row and everything below it</source>
        <translation>Kopiert die Zeile mit allem darunter</translation>
    </message>
    <message>
        <source>Data of all streams</source>
        <translation>Daten aller Datenströme</translation>
    </message>
    <message>
        <source>Search data</source>
        <translation>Daten suchen</translation>
    </message>
    <message>
        <source>Words that paths of streams and fields contain</source>
        <translation>Wörter, die Pfade von Datenströmen und Feldern enthalten</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Shows other values next to these and marks differences; timestamps do not count</source>
        <translation>Zeigt andere Werte daneben und markiert Unterschiede; Zeitstempel zählen nicht</translation>
    </message>
    <message>
        <source>No comparison</source>
        <translation>Kein Vergleich</translation>
    </message>
    <message>
        <source>Remembered values</source>
        <translation>Gemerkte Werte</translation>
    </message>
    <message>
        <source>Logged values</source>
        <translation>Aufgezeichnete Werte</translation>
    </message>
    <message>
        <source>Path of the selected row</source>
        <translation>Pfad der ausgewählten Zeile</translation>
    </message>
    <message>
        <source>State of the data</source>
        <translation>Zustand der Daten</translation>
    </message>
    <message>
        <source>Nothing matches. Clear the search.</source>
        <translation>Nichts passt. Die Suche leeren.</translation>
    </message>
    <message>
        <source>No data yet. Start a simulation, connect to a robot, or open a log.</source>
        <translation>Noch keine Daten. Eine Simulation starten, mit einem Roboter verbinden oder ein Log öffnen.</translation>
    </message>
    <message>
        <source>Asked %1 for %2 (debug key)</source>
        <translation>%1 wurde um %2 gebeten (Debug-Schlüssel)</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 wurde abgelehnt: %2</translation>
    </message>
</context>
<context>
    <name>widgets::DebugKeysView</name>
    <message>
        <source>%1 (shipped)</source>
        <translation>%1 (mitgeliefert)</translation>
    </message>
    <message>
        <source>Switched to the preset %1.</source>
        <translation>Auf die Voreinstellung %1 umgeschaltet.</translation>
    </message>
    <message>
        <source>Type a name for the preset, then save.</source>
        <translation>Einen Namen für die Voreinstellung eingeben, dann speichern.</translation>
    </message>
    <message>
        <source>%1 is a shipped preset and stays as it is. Type another name, then save.</source>
        <translation>%1 ist eine mitgelieferte Voreinstellung und bleibt, wie sie ist. Einen anderen Namen eingeben, dann speichern.</translation>
    </message>
    <message>
        <source>Saved the preset %1 (keys that are on: %2).</source>
        <translation>Voreinstellung %1 gespeichert (eingeschaltete Schlüssel: %2).</translation>
    </message>
    <message>
        <source>%1 is a shipped preset and cannot be deleted.</source>
        <translation>%1 ist eine mitgelieferte Voreinstellung und kann nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>Deleted the preset %1.</source>
        <translation>Voreinstellung %1 gelöscht.</translation>
    </message>
    <message>
        <source>Only keys that are on</source>
        <translation>Nur eingeschaltete Schlüssel</translation>
    </message>
    <message>
        <source>Shows only the keys that are not off</source>
        <translation>Zeigt nur die Schlüssel, die nicht aus sind</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>Alle aus</translation>
    </message>
    <message>
        <source>Switches every key off</source>
        <translation>Schaltet jeden Schlüssel aus</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation>Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Saves the keys that are on under the name in the field</source>
        <translation>Behält die eingeschalteten Schlüssel unter dem Namen im Feld</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Delete preset</source>
        <translation>Voreinstellung löschen</translation>
    </message>
    <message>
        <source>Deletes the named preset</source>
        <translation>Löscht die genannte Voreinstellung</translation>
    </message>
    <message>
        <source>Search keys</source>
        <translation>Schlüssel suchen</translation>
    </message>
    <message>
        <source>Words that the key&apos;s name contains; just type in the list</source>
        <translation>Wörter, die der Name des Schlüssels enthält; einfach in der Liste tippen</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>A named set of keys: choose one to switch to it, or type a new name and save</source>
        <translation>Ein benannter Satz von Schlüsseln: einen wählen, um darauf umzuschalten, oder einen neuen Namen eingeben und speichern</translation>
    </message>
    <message>
        <source>Debug keys</source>
        <translation>Debug-Schlüssel</translation>
    </message>
    <message>
        <source>every n-th</source>
        <translation>jedes n-te</translation>
    </message>
    <message>
        <source>State of the debug keys</source>
        <translation>Zustand der Debug-Schlüssel</translation>
    </message>
    <message>
        <source>%1 of %2 keys are on</source>
        <translation>%1 von %2 Schlüsseln sind an</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Eine Simulation starten oder mit einem Roboter verbinden und ihn in der Werkzeugleiste wählen.</translation>
    </message>
    <message>
        <source>The robot has not reported its debug keys yet. Start its program.</source>
        <translation>Der Roboter hat seine Debug-Schlüssel noch nicht gemeldet. Sein Programm starten.</translation>
    </message>
    <message>
        <source>No key matches. Clear the search or the filter.</source>
        <translation>Kein Schlüssel passt. Die Suche oder den Filter leeren.</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 wurde abgelehnt: %2</translation>
    </message>
    <message>
        <source>In all robots</source>
        <translation>Bei allen Robotern</translation>
    </message>
    <message>
        <source>Copies the mode of this key, or of all keys below this row, to the other robots</source>
        <translation>Schaltet diesen Schlüssel, oder alle unter dieser Zeile, bei den anderen Robotern wie hier</translation>
    </message>
    <message>
        <source>%1 of %2 was refused: %3</source>
        <translation>%1 von %2 wurde abgelehnt: %3</translation>
    </message>
</context>
<context>
    <name>widgets::DrawingsModel</name>
    <message>
        <source>%1 (robot)</source>
        <translation>%1 (Roboter)</translation>
    </message>
    <message>
        <source>The robot refused to draw it: %1</source>
        <translation>Der Roboter hat abgelehnt, es zu zeichnen: %1</translation>
    </message>
    <message>
        <source>The robot was asked to draw it</source>
        <translation>Der Roboter wurde gebeten, es zu zeichnen</translation>
    </message>
    <message>
        <source>The robot does not draw it; check it to switch it on</source>
        <translation>Der Roboter zeichnet es nicht; ankreuzen, um es einzuschalten</translation>
    </message>
    <message>
        <source>No robot has drawn it yet</source>
        <translation>Noch kein Roboter hat es gezeichnet</translation>
    </message>
    <message>
        <source>The messages of this stream, in the frame that they name</source>
        <translation>Die Nachrichten dieses Stroms, in dem Koordinatensystem, das sie nennen</translation>
    </message>
    <message>
        <source>From a shadow solution: its lines are dashed</source>
        <translation>Von einer Lösung im Schatten: Ihre Linien sind gestrichelt</translation>
    </message>
</context>
<context>
    <name>widgets::DrawingsPanel</name>
    <message>
        <source>Search drawings</source>
        <translation>Zeichnungen suchen</translation>
    </message>
    <message>
        <source>Shows only drawings whose name contains this</source>
        <translation>Zeigt nur Zeichnungen, deren Name dies enthält</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>Checked drawings are shown; those lower in the list are on top. Gray ones are off on the robot: check one to switch it on</source>
        <translation>Angekreuzte Zeichnungen werden gezeigt; was weiter unten in der Liste steht, liegt darüber. Graue sind am Roboter aus: eine ankreuzen, um sie einzuschalten</translation>
    </message>
    <message>
        <source>There is no robot that could draw anything here.</source>
        <translation>Hier ist kein Roboter, der etwas zeichnen könnte.</translation>
    </message>
    <message>
        <source>No drawing has this in its name.</source>
        <translation>Keine Zeichnung hat dies in ihrem Namen.</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Shows all drawings</source>
        <translation>Zeigt alle Zeichnungen</translation>
    </message>
    <message>
        <source>Show none</source>
        <translation>Keine zeigen</translation>
    </message>
    <message>
        <source>Hides all drawings</source>
        <translation>Blendet alle Zeichnungen aus</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Switches the chosen drawing&apos;s debug key off: the robot no longer draws it</source>
        <translation>Schaltet den Debug-Schlüssel der gewählten Zeichnung aus: der Roboter zeichnet sie nicht mehr</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Moves the drawing below the previous one</source>
        <translation>Legt die Zeichnung unter die davor</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Moves the drawing on top of the next one</source>
        <translation>Legt die Zeichnung über die nächste</translation>
    </message>
</context>
<context>
    <name>widgets::ErrorModel</name>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Missed %</source>
        <translation>Verpasst %</translation>
    </message>
    <message>
        <source>False %</source>
        <translation>Falsch %</translation>
    </message>
    <message>
        <source>Latency ms</source>
        <translation>Latenz ms</translation>
    </message>
    <message>
        <source>%1 (shadow)</source>
        <translation>%1 (Schatten)</translation>
    </message>
    <message>
        <source>The solution that published it, or one that runs in its shadow</source>
        <translation>Die Lösung, die es veröffentlicht hat, oder eine, die in ihrem Schatten läuft</translation>
    </message>
    <message>
        <source>The newest error</source>
        <translation>Der neueste Fehler</translation>
    </message>
    <message>
        <source>Median error</source>
        <translation>Die Hälfte aller Fehler ist nicht größer</translation>
    </message>
    <message>
        <source>95th percentile of the errors</source>
        <translation>95 % aller Fehler sind nicht größer</translation>
    </message>
    <message>
        <source>Share of the real objects and events that were not reported</source>
        <translation>Von dem, was zu sehen oder zu wissen war: wie viel davon nicht gemeldet wurde</translation>
    </message>
    <message>
        <source>Share of the reports that did not match a real object or event</source>
        <translation>Von dem, was gemeldet wurde: wie viel davon nicht da war</translation>
    </message>
    <message>
        <source>Mean time from a sensor reading until a result based on it was published, on the robot&apos;s clock</source>
        <translation>Mittlere Zeit vom Messwert bis zur Veröffentlichung dessen, was auf ihm beruht, auf der Uhr des Roboters</translation>
    </message>
    <message>
        <source>% of the time</source>
        <translation>% der Zeit</translation>
    </message>
    <message>
        <source>What is compared; relative errors are fractions of the distance, delays the time until an event is reported</source>
        <translation>Was verglichen wird; relative Fehler sind Anteile der Entfernung, Verzögerungen vergehen, bis gemeldet wird, was geschieht</translation>
    </message>
</context>
<context>
    <name>widgets::ErrorsView</name>
    <message>
        <source>Plot</source>
        <translation>Auftragen</translation>
    </message>
    <message>
        <source>Plots the chosen error over time</source>
        <translation>Trägt den gewählten Fehler über der Zeit auf</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Copies the table with tabs</source>
        <translation>Kopiert die Tabelle mit Tabulatoren</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restarts the figures</source>
        <translation>Beginnt die Statistik von vorn</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>Search errors</source>
        <translation>Fehler suchen</translation>
    </message>
    <message>
        <source>Shows only errors whose stream, solution or name has this</source>
        <translation>Zeigt nur Fehler, in deren Datenstrom, Lösung oder Namen das vorkommt</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Starten Sie eine Simulation oder verbinden Sie sich mit einem Roboter und wählen Sie ihn in der Werkzeugleiste.</translation>
    </message>
    <message>
        <source>Nothing compared yet. Errors appear while the robot&apos;s program runs.</source>
        <translation>Es wurde noch nichts verglichen. Fehler kommen, während das Programm des Roboters läuft.</translation>
    </message>
    <message>
        <source>There is no ground truth for this robot. The simulator has it; a log has it if oracle/world was recorded.</source>
        <translation>Niemand kennt die Wahrheit über diesen Roboter. Der Simulator kennt sie; ein Log hat sie, wenn oracle/world aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>Why nothing was plotted</source>
        <translation>Warum nichts aufgetragen wurde</translation>
    </message>
</context>
<context>
    <name>widgets::ExportBar</name>
    <message>
        <source>Export of a view</source>
        <translation>Export einer Ansicht</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancels the export; a video is deleted, written images stay</source>
        <translation>Beendet den Export; ein Video wird gelöscht, geschriebene Bilder bleiben</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Opens the folder with the exported files</source>
        <translation>Öffnet den Ordner, in den geschrieben wurde</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Hides this</source>
        <translation>Blendet dies aus</translation>
    </message>
    <message>
        <source>No file manager was found on this computer. The export is in %1</source>
        <translation>Kein Programm auf diesem Rechner zeigt Ordner. Es ist %1</translation>
    </message>
</context>
<context>
    <name>widgets::ExportDialog</name>
    <message>
        <source>Export a view</source>
        <translation>Eine Ansicht exportieren</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>The view to export</source>
        <translation>Welche der offenen Ansichten geschrieben wird</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Als</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Video (.mp4)</source>
        <translation>Video (.mp4)</translation>
    </message>
    <message>
        <source>Video (.avi, Motion JPEG)</source>
        <translation>Video (.avi, Motion JPEG)</translation>
    </message>
    <message>
        <source>Images (.png), numbered</source>
        <translation>Bilder (.png), nummeriert</translation>
    </message>
    <message>
        <source>File or folder</source>
        <translation>Datei oder Ordner</translation>
    </message>
    <message>
        <source>Where it is written to</source>
        <translation>Wohin geschrieben wird</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Chooses the file or folder</source>
        <translation>Wählt die Datei oder den Ordner</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;As</source>
        <translation>A&amp;ls</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Nach</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben werden wird</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was falsch ist</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>The first instant, as the timeline shows it</source>
        <translation>Der erste Zeitpunkt, wie die Zeitleiste ihn zeigt</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>The last instant, as the timeline shows it</source>
        <translation>Der letzte Zeitpunkt, wie die Zeitleiste ihn zeigt</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>The whole log, or the whole history of live robots</source>
        <translation>Das ganze Log, oder alles, was von laufenden Robotern aufbewahrt wird</translation>
    </message>
    <message>
        <source>A–B</source>
        <translation>A–B</translation>
    </message>
    <message>
        <source>The range that is selected in the timeline (I and O select one)</source>
        <translation>Der Bereich, der in der Zeitleiste ausgewählt ist (I und O wählen einen)</translation>
    </message>
    <message>
        <source>until</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Pictures per second; also the video&apos;s frame rate</source>
        <translation>Bilder pro Sekunde; auch die des Videos</translation>
    </message>
    <message>
        <source> pictures/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>&amp;Rate</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the pictures</source>
        <translation>Breite der Bilder</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the pictures</source>
        <translation>Höhe der Bilder</translation>
    </message>
    <message>
        <source>As shown</source>
        <translation>Wie gezeigt</translation>
    </message>
    <message>
        <source>The size in which the view is shown now</source>
        <translation>Die Größe, in der die Ansicht jetzt gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Folder of the images</source>
        <translation>Ordner der Bilder</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.avi)</source>
        <translation>Videos (*.mp4 *.avi)</translation>
    </message>
    <message>
        <source>
The file exists, and will be replaced.</source>
        <translation>
Die Datei gibt es schon, sie wird ersetzt.</translation>
    </message>
    <message>
        <source>The end must not be before the beginning.</source>
        <translation>Das Ende darf nicht vor dem Anfang liegen.</translation>
    </message>
    <message>
        <source>Choose the output file or folder.</source>
        <translation>Wählen, wohin geschrieben wird.</translation>
    </message>
    <message>
        <source>1 picture</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source> of %1 s</source>
        <translation> von %1 s</translation>
    </message>
</context>
<context>
    <name>widgets::FieldCanvas</name>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Wheel: zoom; drag: move the picture; click a robot: select it; drag a robot or the ball (Shift: always): place it, wheel: turn it; Control+click: send the robot there; arrows: move; F: fit; R: turn</source>
        <translation>Mausrad: zoomen; ziehen: Bild verschieben; Roboter anklicken: auswählen; Roboter oder Ball ziehen (Umschalt: immer): platzieren, Mausrad: drehen; Strg und Klick: den Roboter dorthin schicken; Pfeile: verschieben; F: einpassen; R: drehen</translation>
    </message>
</context>
<context>
    <name>widgets::FieldTableModel</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
</context>
<context>
    <name>widgets::FieldTablePanel</name>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Rebuilds the table, up to now</source>
        <translation>Bildet die Tabelle neu, bis jetzt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancels the table</source>
        <translation>Beendet das Bilden der Tabelle</translation>
    </message>
    <message>
        <source>Save CSV</source>
        <translation>CSV speichern</translation>
    </message>
    <message>
        <source>Writes the table to a file</source>
        <translation>Schreibt die Tabelle in eine Datei</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Hides the table</source>
        <translation>Blendet die Tabelle aus</translation>
    </message>
    <message>
        <source>Values of</source>
        <translation>Werte von</translation>
    </message>
    <message>
        <source>Which messages the table contains</source>
        <translation>Welche Nachrichten die Tabelle enthält</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Whole log</source>
        <translation>Ganzes Log</translation>
    </message>
    <message>
        <source>State of the table</source>
        <translation>Zustand der Tabelle</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Values over time</source>
        <translation>Werte über der Zeit</translation>
    </message>
    <message>
        <source>No open log has these streams.</source>
        <translation>Kein offenes Log enthält diese Datenströme.</translation>
    </message>
    <message>
        <source>Canceled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>1 row</source>
        <translation>1 Zeile</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>The last %1; there are more</source>
        <translation>Die letzten %1; es gibt mehr</translation>
    </message>
    <message>
        <source>Save the table as CSV</source>
        <translation>Die Tabelle als CSV speichern</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
</context>
<context>
    <name>widgets::FieldView</name>
    <message>
        <source>Fits the whole field or map into the view</source>
        <translation>Zeigt das ganze Feld oder die ganze Karte, so groß es passt</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Turns the field by 90 degrees</source>
        <translation>Dreht das Feld um 90 Grad</translation>
    </message>
    <message>
        <source>Move robots and ball</source>
        <translation>Roboter und Ball bewegen</translation>
    </message>
    <message>
        <source>Dragging a robot or the ball places it; otherwise only with Shift. The wheel turns what is dragged</source>
        <translation>Ziehen eines Roboters oder des Balls platziert ihn; sonst nur mit Umschalt. Das Mausrad dreht, was gezogen wird</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Whose drawings and estimated poses are shown</source>
        <translation>Wessen Zeichnungen und geschätzte Posen gezeigt werden</translation>
    </message>
    <message>
        <source>Time that is shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>Which drawings are old</source>
        <translation>Welche Zeichnungen alt sind</translation>
    </message>
    <message>
        <source>Place under the cursor, in the field&apos;s frame</source>
        <translation>Ort unter dem Mauszeiger, im Koordinatensystem des Felds</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>x %1 m  y %2 m</source>
        <translation>x %1 m  y %2 m</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Karte: %1</translation>
    </message>
    <message>
        <source>It cannot be placed here: %1</source>
        <translation>Es kann hier nicht platziert werden: %1</translation>
    </message>
    <message>
        <source>The robot cannot go there: %1</source>
        <translation>Der Roboter fährt nicht dorthin: %1</translation>
    </message>
    <message>
        <source>faded: drawn in earlier frames</source>
        <translation>verblasst: in früheren Frames gezeichnet</translation>
    </message>
    <message>
        <source>%1  history</source>
        <translation>%1  Verlauf</translation>
    </message>
    <message>
        <source>%1 px/m</source>
        <translation>%1 px/m</translation>
    </message>
    <message>
        <source>Shows the paths of the last seconds; the arrow chooses how long, and of what</source>
        <translation>Zeigt, wo in den letzten Sekunden alles war; der Pfeil wählt wie lange und was</translation>
    </message>
    <message>
        <source>%1 (%2, %3) mm</source>
        <translation>%1 (%2, %3) mm</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>AB %1</source>
        <translation>AB %1</translation>
    </message>
    <message>
        <source>BC %1</source>
        <translation>BC %1</translation>
    </message>
    <message>
        <source>angle at B %1</source>
        <translation>Winkel bei B %1</translation>
    </message>
    <message>
        <source>%1, all robots</source>
        <translation>%1, alle Roboter</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Shows lines from the true to the estimated positions of robot and ball</source>
        <translation>Zeigt Linien von dort, wo Roboter und Ball sind, dorthin, wo der Roboter sie vermutet</translation>
    </message>
</context>
<context>
    <name>widgets::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Enter finds the next match, Shift+Enter the previous one</source>
        <translation>Enter findet die nächste Stelle, Umschalt+Enter die vorige</translation>
    </message>
    <message>
        <source>Replace by</source>
        <translation>Ersetzen durch</translation>
    </message>
    <message>
        <source>Replacement text</source>
        <translation>Was den gefundenen Text ersetzt</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Groß- und Kleinschreibung</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Finds the previous match</source>
        <translation>Findet die vorige Stelle</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>Finds the next match</source>
        <translation>Findet die nächste Stelle</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Replaces this match and finds the next one</source>
        <translation>Ersetzt diese Stelle und findet die nächste</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Alle ersetzen</translation>
    </message>
    <message>
        <source>Replaces all matches, as one undo step</source>
        <translation>Ersetzt alle Stellen in einem Schritt</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Nicht gefunden</translation>
    </message>
    <message>
        <source>Continued from the other end</source>
        <translation>Am anderen Ende weitergesucht</translation>
    </message>
    <message>
        <source>Replaced: %1</source>
        <translation>Ersetzt: %1</translation>
    </message>
</context>
<context>
    <name>widgets::GamePlayerModel</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Penalized for</source>
        <translation>Bestraft wegen</translation>
    </message>
    <message>
        <source>Left [s]</source>
        <translation>Noch [s]</translation>
    </message>
    <message>
        <source>Plays as</source>
        <translation>Spielt als</translation>
    </message>
    <message>
        <source>%1, %2 s ago</source>
        <translation>%1, vor %2 s</translation>
    </message>
    <message>
        <source>program does not run</source>
        <translation>Programm läuft nicht</translation>
    </message>
</context>
<context>
    <name>widgets::GameView</name>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Sends the robots to their positions</source>
        <translation>Die Roboter gehen auf ihre Plätze</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Aufstellen</translation>
    </message>
    <message>
        <source>Places robots and ball for the kick-off; they wait</source>
        <translation>Roboter und Ball werden auf ihre Plätze gesetzt und warten</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Spielen</translation>
    </message>
    <message>
        <source>Starts play</source>
        <translation>Die Roboter spielen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Ends the half</source>
        <translation>Die Halbzeit endet</translation>
    </message>
    <message>
        <source>New game</source>
        <translation>Neues Spiel</translation>
    </message>
    <message>
        <source>Restarts the game: no goals, first half, no penalties</source>
        <translation>Keine Tore, erste Halbzeit, niemand ist bestraft</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>The referee decides by itself: phases, goals, balls out, penalties</source>
        <translation>Der Schiedsrichter entscheidet selbst: Phasen, Tore, Bälle im Aus, Strafen</translation>
    </message>
    <message>
        <source>Penalize</source>
        <translation>Bestrafen</translation>
    </message>
    <message>
        <source>Takes the chosen robot out of the game</source>
        <translation>Nimmt den gewählten Roboter aus dem Spiel</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Zurück ins Spiel</translation>
    </message>
    <message>
        <source>Returns the chosen robot to the game</source>
        <translation>Der gewählte Roboter spielt wieder mit</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Spielstand</translation>
    </message>
    <message>
        <source>Kick-off</source>
        <translation>Anstoß</translation>
    </message>
    <message>
        <source>The team that kicks off next</source>
        <translation>Das Team, das als nächstes anstößt</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for the penalty</source>
        <translation>Wofür der Roboter bestraft wird</translation>
    </message>
    <message>
        <source>The latest event</source>
        <translation>Was zuletzt geschah</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>No game is played. Open a scene with a game, such as game2002.</source>
        <translation>Es wird nicht gespielt. Öffnen Sie eine Szene mit einem Spiel, etwa game2002.</translation>
    </message>
    <message>
        <source>initial</source>
        <translation>vor dem Spiel</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>set</source>
        <translation>aufgestellt</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>im Spiel</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>half %1, %2 left, %3</source>
        <translation>Halbzeit %1, noch %2, %3</translation>
    </message>
    <message>
        <source>Half, time and phase</source>
        <translation>Halbzeit, Zeit und Phase</translation>
    </message>
</context>
<context>
    <name>widgets::GamepadDialog</name>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was sie tut</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Totzone</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Knöpfe</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>Knopf</translation>
    </message>
    <message>
        <source>Command that it runs</source>
        <translation>Befehl, den er ausführt</translation>
    </message>
    <message>
        <source>What an empty command means</source>
        <translation>Was ein leerer Befehl bedeutet</translation>
    </message>
    <message>
        <source>Commands are those of the console. By default, a kicks and b is STOP; a single - does nothing. They work while the Motion tester is visible.</source>
        <translation>Befehle sind die der Konsole. Ausgeliefert schießt a, und b ist STOP; ein einzelnes - tut nichts. Sie wirken, solange der Bewegungstester sichtbar ist.</translation>
    </message>
    <message>
        <source>Last result</source>
        <translation>Letztes Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Reset all</source>
        <translation>Alles zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>walks forwards</source>
        <translation>geht vorwärts</translation>
    </message>
    <message>
        <source>walks to the left</source>
        <translation>geht nach links</translation>
    </message>
    <message>
        <source>turns to the left</source>
        <translation>dreht nach links</translation>
    </message>
    <message>
        <source>Value at full deflection; negative: reversed</source>
        <translation>Was voller Ausschlag bedeutet; negativ: andersherum</translation>
    </message>
    <message>
        <source>There is no command %1.</source>
        <translation>Es gibt keinen Befehl %1.</translation>
    </message>
</context>
<context>
    <name>widgets::GoalTool</name>
    <message>
        <source>Send the robot</source>
        <translation>Roboter schicken</translation>
    </message>
    <message>
        <source>A click sends the robot there, dragging sets its final heading; otherwise only with Control</source>
        <translation>Ein Klick schickt den Roboter dorthin, Ziehen legt seine Endrichtung fest; sonst nur mit Strg</translation>
    </message>
    <message>
        <source>Cancel the goal</source>
        <translation>Ziel aufheben</translation>
    </message>
    <message>
        <source>Cancels the robot&apos;s goal</source>
        <translation>Hebt das Ziel des Roboters auf</translation>
    </message>
</context>
<context>
    <name>widgets::HeadPanel</name>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Head mode</source>
        <translation>Kopfmodus</translation>
    </message>
    <message>
        <source>What the head does while you steer</source>
        <translation>Was der Kopf tut, während von hier gesteuert wird</translation>
    </message>
    <message>
        <source>look ahead</source>
        <translation>nach vorn sehen</translation>
    </message>
    <message>
        <source>search ball</source>
        <translation>Ball suchen</translation>
    </message>
    <message>
        <source>track ball</source>
        <translation>Ball verfolgen</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>umhersehen</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Mouth</source>
        <translation>Maul</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>Winkel in Grad</translation>
    </message>
</context>
<context>
    <name>widgets::HistoryCurves</name>
    <message>
        <source>Reading the history: %1 %</source>
        <translation>Der Verlauf wird gelesen: %1 %</translation>
    </message>
</context>
<context>
    <name>widgets::HistoryLimits</name>
    <message>
        <source>How much is kept</source>
        <translation>Wie viel behalten wird</translation>
    </message>
    <message>
        <source>In memory</source>
        <translation>Im Speicher</translation>
    </message>
    <message>
        <source>History of the robots is kept in memory up to this size; older history goes to disk</source>
        <translation>Was Roboter gesendet haben, wird bis zu dieser Größe behalten; Älteres kommt auf den Datenträger</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>Auf dem Datenträger</translation>
    </message>
    <message>
        <source>History that no longer fits into memory is kept in the folder for temporary files up to this size, until the program ends; older history is dropped. 0: none</source>
        <translation>Was nicht mehr in den Speicher passt, liegt bis zu dieser Größe im Ordner für temporäre Dateien, bis das Programm endet; Älteres wird verworfen. 0 legt dort nichts ab</translation>
    </message>
    <message>
        <source>In &amp;memory:</source>
        <translation>Im &amp;Speicher:</translation>
    </message>
    <message>
        <source>On &amp;disk:</source>
        <translation>Auf dem &amp;Datenträger:</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>Now %1 in memory and %2 on disk, %3 s back. The view Streams has the share of each stream.</source>
        <translation>Jetzt %1 im Speicher und %2 auf dem Datenträger, %3 s zurück. Die Ansicht Datenströme hat den Anteil jedes Datenstroms.</translation>
    </message>
</context>
<context>
    <name>widgets::HistoryStrip</name>
    <message>
        <source>States of the last minute</source>
        <translation>Zustände der letzten Minute</translation>
    </message>
</context>
<context>
    <name>widgets::HostingBar</name>
    <message>
        <source>Where the program runs</source>
        <translation>Wo das Programm läuft</translation>
    </message>
    <message>
        <source>Call stack</source>
        <translation>Aufrufe, die dorthin führten</translation>
    </message>
    <message>
        <source>All robots</source>
        <translation>Alle Roboter</translation>
    </message>
    <message>
        <source>Where the programs of all robots run</source>
        <translation>Wo die Programme aller Roboter laufen</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>Restarts the program of this robot; keys, solutions and parameters stay</source>
        <translation>Startet das Programm dieses Roboters neu; Schlüssel, Lösungen und Parameter bleiben</translation>
    </message>
    <message>
        <source>Own process</source>
        <translation>Eigener Prozess</translation>
    </message>
    <message>
        <source>Runs the program of this robot in its own process: if it crashes or hangs, nothing else is harmed</source>
        <translation>Führt das Programm dieses Roboters in einem eigenen Prozess aus: stürzt es ab oder hängt es, nimmt nichts anderes Schaden</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Gives each process of the programs of all robots a thread, with the priority of the layout, in real time; otherwise they are executed one after another, and the same input gives the same results</source>
        <translation>Gibt jedem Prozess der Programme aller Roboter einen Thread, mit der Priorität des Layouts, in Echtzeit; sonst werden sie nacheinander ausgeführt, und gleiche Eingaben geben gleiche Ergebnisse</translation>
    </message>
    <message>
        <source>Each in its own process</source>
        <translation>Jedes in einem eigenen Prozess</translation>
    </message>
    <message>
        <source>Runs the program of each robot in its own process</source>
        <translation>Führt das Programm jedes Roboters in einem eigenen Prozess aus</translation>
    </message>
    <message>
        <source>In the workbench</source>
        <translation>In der Werkbank</translation>
    </message>
    <message>
        <source>Runs all programs in the workbench</source>
        <translation>Führt alle Programme in der Werkbank aus</translation>
    </message>
    <message>
        <source>The program runs in its own process, ID %1. To attach a debugger: gdb -p %1</source>
        <translation>Das Programm läuft in einem eigenen Prozess mit der Nummer %1. Ein Debugger sieht es sich an mit: gdb -p %1</translation>
    </message>
    <message>
        <source>The program runs in the workbench, each of its processes in its own thread.</source>
        <translation>Das Programm läuft in der Werkbank, jeder seiner Prozesse in einem eigenen Thread.</translation>
    </message>
    <message>
        <source>The program runs in the workbench.</source>
        <translation>Das Programm läuft in der Werkbank.</translation>
    </message>
</context>
<context>
    <name>widgets::ImageCanvas</name>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Wheel: zoom; drag: move; arrows: move; F: fit; A: pixel by pixel</source>
        <translation>Mausrad: zoomen; ziehen: verschieben; Pfeile: verschieben; F: einpassen; A: Pixel für Pixel</translation>
    </message>
</context>
<context>
    <name>widgets::ImageStreamView</name>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Shows the image pixel by pixel</source>
        <translation>Zeigt das Bild Pixel für Pixel</translation>
    </message>
    <message>
        <source>Copy image only</source>
        <translation>Nur das Bild kopieren</translation>
    </message>
    <message>
        <source>Copies the image in its own size, without drawings</source>
        <translation>Kopiert das Bild in seiner eigenen Größe, ohne Zeichnungen</translation>
    </message>
    <message>
        <source>Save image only...</source>
        <translation>Nur das Bild speichern...</translation>
    </message>
    <message>
        <source>Saves the image in its own size, without drawings, as PNG</source>
        <translation>Speichert das Bild in seiner eigenen Größe, ohne Zeichnungen, als PNG</translation>
    </message>
    <message>
        <source>Image stream</source>
        <translation>Bilderstrom</translation>
    </message>
    <message>
        <source>Which images are shown</source>
        <translation>Welche Bilder gezeigt werden</translation>
    </message>
    <message>
        <source>Time of the image</source>
        <translation>Zeit des Bilds</translation>
    </message>
    <message>
        <source>Whether the image is live, frozen or old</source>
        <translation>Ob das Bild live, eingefroren oder alt ist</translation>
    </message>
    <message>
        <source>Pixel under the cursor</source>
        <translation>Pixel unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Image: %1</source>
        <translation>Bild: %1</translation>
    </message>
    <message>
        <source>no image yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>faded: drawn in earlier images</source>
        <translation>verblasst: in früheren Bildern gezeichnet</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>eingefroren</translation>
    </message>
    <message>
        <source>history</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>%1 s alt</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compares with a second image: another camera or robot, the logged one, or another time</source>
        <translation>Vergleicht mit einem zweiten Bild: einer anderen Kamera oder einem anderen Roboter, dem aufgezeichneten, oder zu einer anderen Zeit</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1: no image of that time here</source>
        <translation>%1: hier kein Bild dieser Zeit</translation>
    </message>
    <message>
        <source>held: %1</source>
        <translation>festgehalten: %1</translation>
    </message>
    <message>
        <source>%1 % of %2</source>
        <translation>%1 % von %2</translation>
    </message>
    <message>
        <source>%1 % of the pixels differ from %2, by at most %3</source>
        <translation>%1 % der Pixel unterscheiden sich von %2, um höchstens %3</translation>
    </message>
    <message>
        <source>   second R %1  G %2  B %3   Δ %4 %5 %6</source>
        <translation>   zweites R %1  G %2  B %3   Δ %4 %5 %6</translation>
    </message>
    <message>
        <source>%1 (%2, %3) %4</source>
        <translation>%1 (%2, %3) %4</translation>
    </message>
    <message>
        <source> on the floor (%1, %2) mm</source>
        <translation> auf dem Boden (%1, %2) mm</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>, %1 mm</source>
        <translation>, %1 mm</translation>
    </message>
    <message>
        <source>%1%2 %3 (%4, %5), %6</source>
        <translation>%1%2 %3 (%4, %5), %6</translation>
    </message>
    <message>
        <source>angle at B %1</source>
        <translation>Winkel bei B %1</translation>
    </message>
    <message>
        <source>Monochrome</source>
        <translation>Schwarzweiß</translation>
    </message>
    <message>
        <source>Shows the brightness of the pixels</source>
        <translation>Zeigt die Helligkeit der Bildpunkte</translation>
    </message>
    <message>
        <source>Stereogram</source>
        <translation>Stereogramm</translation>
    </message>
    <message>
        <source>Shows distances as a random-dot stereogram: focus behind the picture to see the depth</source>
        <translation>Zeigt Entfernungen als Zufallspunkte: Durch das Bild hindurchsehen, um sie räumlich zu sehen</translation>
    </message>
    <message>
        <source>Fits the whole image into the view</source>
        <translation>Passt das ganze Bild in die Ansicht ein</translation>
    </message>
</context>
<context>
    <name>widgets::JointsModel</name>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Last 5 s</source>
        <translation>Letzte 5 s</translation>
    </message>
    <message>
        <source>Turns the joint: a double click, or F2, edits the angle in degrees</source>
        <translation>Dreht das Gelenk: ein Doppelklick oder F2 bearbeitet den Winkel in Grad</translation>
    </message>
    <message>
        <source>The robot does not measure the torque of its joints</source>
        <translation>Der Roboter misst das Drehmoment seiner Gelenke nicht</translation>
    </message>
    <message>
        <source>At most %1°/s</source>
        <translation>Höchstens %1°/s</translation>
    </message>
    <message>
        <source>The angle that the program requests, degrees (joints/request)</source>
        <translation>Der Winkel, den das Programm anfordert, Grad (joints/request)</translation>
    </message>
    <message>
        <source>The angle that the robot measures, degrees (joints/states)</source>
        <translation>Der Winkel, den der Roboter misst, Grad (joints/states)</translation>
    </message>
    <message>
        <source>Requested minus measured, degrees</source>
        <translation>Angefordert minus gemessen, Grad</translation>
    </message>
    <message>
        <source>Degrees per second</source>
        <translation>Grad pro Sekunde</translation>
    </message>
    <message>
        <source>Torque, N m, if the robot measures it</source>
        <translation>Drehmoment, N m, bei Robotern, die es messen</translation>
    </message>
    <message>
        <source>The software limits, degrees</source>
        <translation>Die Softwaregrenzen, Grad</translation>
    </message>
    <message>
        <source>Measured as a bar, requested as a mark, between the limits; drag it while you steer</source>
        <translation>Gemessen als Balken, angefordert als Marke, zwischen den Grenzen; bei manueller Steuerung ziehen</translation>
    </message>
    <message>
        <source>Requested, °</source>
        <translation>Angefordert, °</translation>
    </message>
    <message>
        <source>Measured, °</source>
        <translation>Gemessen, °</translation>
    </message>
    <message>
        <source>Error, °</source>
        <translation>Abweichung, °</translation>
    </message>
    <message>
        <source>Speed, °/s</source>
        <translation>Geschwindigkeit, °/s</translation>
    </message>
    <message>
        <source>Load, N m</source>
        <translation>Last, N m</translation>
    </message>
    <message>
        <source>Limits, °</source>
        <translation>Grenzen, °</translation>
    </message>
</context>
<context>
    <name>widgets::JointsView</name>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Switches the behavior to obeying you, and back</source>
        <translation>Schaltet das Verhalten auf manuelle Steuerung um und zurück</translation>
    </message>
    <message>
        <source>Limp</source>
        <translation>Schlaff</translation>
    </message>
    <message>
        <source>Releases all joints, to pose the robot by hand; click again to hold them</source>
        <translation>Gibt alle Gelenke frei, damit der Roboter von Hand in Pose gebracht wird; noch einmal: sie halten</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Stehen</translation>
    </message>
    <message>
        <source>Makes the robot stand, and releases the joints you turned</source>
        <translation>Lässt den Roboter stehen; kein einzelnes Gelenk wird mehr gedreht</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Erfassen</translation>
    </message>
    <message>
        <source>Adds this pose to the motion in the editor, as a key frame</source>
        <translation>Fügt diese Pose der Bewegung im Editor als Keyframe hinzu</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Robot whose joints are shown</source>
        <translation>Roboter, dessen Gelenke gezeigt werden</translation>
    </message>
    <message>
        <source>It is chosen in the toolbar</source>
        <translation>Er wird in der Werkzeugleiste gewählt</translation>
    </message>
    <message>
        <source>Who steers</source>
        <translation>Wer steuert</translation>
    </message>
    <message>
        <source>Angles of the pose</source>
        <translation>Winkel der Pose</translation>
    </message>
    <message>
        <source>Which angles become a key frame</source>
        <translation>Welche Winkel zum Keyframe werden</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>angefordert</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>How long the motion takes to reach this pose</source>
        <translation>Wie lange die Bewegung bis zu dieser Pose braucht</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Result of capturing</source>
        <translation>Ergebnis des Erfassens</translation>
    </message>
    <message>
        <source>Teach in:</source>
        <translation>Teach-in:</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Turns %1 while you steer</source>
        <translation>Dreht %1 bei manueller Steuerung</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Eine Simulation starten oder mit einem Roboter verbinden und ihn in der Werkzeugleiste wählen.</translation>
    </message>
    <message>
        <source>The kind of robot %1 is not known yet.</source>
        <translation>Welche Art Roboter %1 ist, ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 has no joints.</source>
        <translation>%1 hat keine Gelenke.</translation>
    </message>
    <message>
        <source>All joints are limp: pose the robot by hand.</source>
        <translation>Alle Gelenke sind schlaff: den Roboter von Hand in Pose bringen.</translation>
    </message>
    <message>
        <source>You steer the robot: drag a slider.</source>
        <translation>Der Roboter wird von hier gesteuert: einen Schieber ziehen.</translation>
    </message>
    <message>
        <source>Which joints of another program are shown</source>
        <translation>Welche Gelenke eines anderen Programms gezeigt werden</translation>
    </message>
    <message>
        <source>The log has no joints up to this time. Its contents are shown in the views Data, Plots, Field and Scene.</source>
        <translation>Bis hierher gibt es in diesem Log keine Gelenke. Was es hat, zeigen die Ansichten Daten, Kurven, Feld und Szene.</translation>
    </message>
</context>
<context>
    <name>widgets::KeyDelegate</name>
    <message>
        <source>Mode of the debug key</source>
        <translation>Modus des Debug-Schlüssels</translation>
    </message>
    <message>
        <source>Number of the debug key&apos;s mode</source>
        <translation>Zahl zum Modus des Debug-Schlüssels</translation>
    </message>
</context>
<context>
    <name>widgets::KeyFrameModel</name>
    <message>
        <source>0 jumps at once and holds, 1 is linear, 2 and 3 start and end softly</source>
        <translation>0 springt sofort und hält, 1 ist linear, 2 und 3 beginnen und enden weich</translation>
    </message>
    <message>
        <source>An angle, * (stays as it is) or - (released)</source>
        <translation>Ein Winkel, * (bleibt, wie er ist) oder - (freigegeben)</translation>
    </message>
    <message>
        <source>The selected robot has no such joint</source>
        <translation>Der gewählte Roboter hat kein solches Gelenk</translation>
    </message>
    <message>
        <source>From %1° to %2°</source>
        <translation>Von %1° bis %2°</translation>
    </message>
    <message>
        <source>At, ticks</source>
        <translation>Bei, Takte</translation>
    </message>
    <message>
        <source>At, ms</source>
        <translation>Bei, ms</translation>
    </message>
    <message>
        <source>Takes, ticks</source>
        <translation>Dauert, Takte</translation>
    </message>
    <message>
        <source>Takes, ms</source>
        <translation>Dauert, ms</translation>
    </message>
    <message>
        <source>Int</source>
        <translation>Int</translation>
    </message>
</context>
<context>
    <name>widgets::KeyTreeModel</name>
    <message>
        <source>%1 of %2 on</source>
        <translation>%1 von %2 an</translation>
    </message>
    <message>
        <source>Used by: %1</source>
        <translation>Verwendet von: %1</translation>
    </message>
    <message>
        <source>Inactive: none of its solutions is running. What you set takes effect when one is switched on.</source>
        <translation>Inaktiv: keine seiner Lösungen läuft. Die Einstellung gilt, sobald eine eingeschaltet wird.</translation>
    </message>
    <message>
        <source>Requested by: %1</source>
        <translation>Angefordert von: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
</context>
<context>
    <name>widgets::LatencyModel</name>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Last ms</source>
        <translation>Letzte ms</translation>
    </message>
    <message>
        <source>Mean ms</source>
        <translation>Mittel ms</translation>
    </message>
    <message>
        <source>Median ms</source>
        <translation>Median ms</translation>
    </message>
    <message>
        <source>95 % ms</source>
        <translation>95 % ms</translation>
    </message>
    <message>
        <source>99 % ms</source>
        <translation>99 % ms</translation>
    </message>
    <message>
        <source>Max ms</source>
        <translation>Max. ms</translation>
    </message>
    <message>
        <source>Waiting ms</source>
        <translation>Warten ms</translation>
    </message>
    <message>
        <source>Computing ms</source>
        <translation>Rechnen ms</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>%1 to %2: %3 ms, 95 %: %4 ms</source>
        <translation>%1 bis %2: %3 ms, 95 %: %4 ms</translation>
    </message>
    <message>
        <source>The reading of the platform, whose timestamp is the beginning</source>
        <translation>Die Messung der Plattform, deren Zeitstempel der Anfang ist</translation>
    </message>
    <message>
        <source>The command to the platform, the first that is based on the reading</source>
        <translation>Der Befehl an die Plattform, der als erster auf der Messung beruht</translation>
    </message>
    <message>
        <source>Mean time on the robot&apos;s clock, from the reading&apos;s timestamp to the beginning of the frame that sent the command</source>
        <translation>Mittlere Zeit auf der Uhr des Roboters, vom Zeitstempel der Messung bis zum Beginn des Durchlaufs, der den Befehl gesendet hat</translation>
    </message>
    <message>
        <source>Mean real time from the beginning of that frame to the command; in lockstep, where the robot&apos;s clock is stopped meanwhile, it includes earlier processes</source>
        <translation>Mittlere wirkliche Zeit vom Beginn dieses Durchlaufs bis zum Befehl; im Gleichschritt, wo die Uhr des Roboters inzwischen steht, auch das, was die Prozesse davor gebraucht haben</translation>
    </message>
</context>
<context>
    <name>widgets::LayoutRow</name>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>The process layout for a robot or a team</source>
        <translation>Das Prozess-Layout, das ein Roboter oder ein Team bekommt</translation>
    </message>
    <message>
        <source>For the robot</source>
        <translation>Für den Roboter</translation>
    </message>
    <message>
        <source>Restarts the program of the chosen robot in this layout</source>
        <translation>Das Programm des gewählten Roboters beginnt in diesem Layout von neuem</translation>
    </message>
    <message>
        <source>For its team</source>
        <translation>Für sein Team</translation>
    </message>
    <message>
        <source>Restarts the programs of the chosen robot&apos;s team in this layout</source>
        <translation>Die Programme des Teams dieses Roboters beginnen in diesem Layout von neuem</translation>
    </message>
</context>
<context>
    <name>widgets::LensPanel</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Corners in a row</source>
        <translation>Ecken in einer Reihe</translation>
    </message>
    <message>
        <source>Inner corners, where four squares meet</source>
        <translation>Innere Ecken, an denen sich vier Felder treffen</translation>
    </message>
    <message>
        <source>Corners in a column</source>
        <translation>Ecken in einer Spalte</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>As printed: measure it</source>
        <translation>Wie gedruckt: nachmessen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Captures the current view of the board</source>
        <translation>Nimmt die Ansicht des Brettes auf, die jetzt zu sehen ist</translation>
    </message>
    <message>
        <source>Capture automatically</source>
        <translation>Von selbst aufnehmen</translation>
    </message>
    <message>
        <source>Captures a view automatically whenever the board has moved</source>
        <translation>Nimmt jede Ansicht auf, in der das Brett woanders ist</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected view</source>
        <translation>Entfernt die ausgewählte Ansicht</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Removes all views</source>
        <translation>Entfernt alle Ansichten</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Sets the opening angles as parameters of the solution of camera-pose</source>
        <translation>Setzt die Öffnungswinkel als Parameter der Lösung für camera-pose</translation>
    </message>
    <message>
        <source>Views of the board</source>
        <translation>Ansichten des Brettes</translation>
    </message>
    <message>
        <source>Each view with its error; remove those that are much worse than the others</source>
        <translation>Jede mit ihrem Fehler; solche, die viel schlechter als andere sind, entfernen</translation>
    </message>
    <message>
        <source>The lens</source>
        <translation>Das Objektiv</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>View %1: %2 px</source>
        <translation>Ansicht %1: %2 px</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Hold the board in at least %1 different places, near and far, tilted, and into the corners of the image; ten are better.</source>
        <translation>Das Brett an mindestens %1 verschiedene Stellen halten, nah und fern, geneigt, und in die Ecken des Bildes; zehn sind besser.</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>Opening angles %1 by %2, error %3 px
Focal lengths %4, %5 px; center %6, %7 px
Distortion %8</source>
        <translation>Öffnungswinkel %1 mal %2, Fehler %3 px
Brennweiten %4, %5 px; Mitte %6, %7 px
Verzeichnung %8</translation>
    </message>
</context>
<context>
    <name>widgets::LogDamageBar</name>
    <message>
        <source>Repair…</source>
        <translation>Reparieren…</translation>
    </message>
    <message>
        <source>Writes what can be read into a new, whole file</source>
        <translation>Schreibt, was lesbar ist, in eine neue, vollständige Datei</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hides this line</source>
        <translation>Blendet diese Zeile aus</translation>
    </message>
</context>
<context>
    <name>widgets::LogFilter</name>
    <message>
        <source>%1 at character %2</source>
        <translation>%1 bei Zeichen %2</translation>
    </message>
</context>
<context>
    <name>widgets::LogJobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancels the job and removes its output</source>
        <translation>Bricht es ab; nichts davon bleibt zurück</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Opens the new log instead of this one</source>
        <translation>Öffnet das neue Log anstelle von diesem</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hides this line</source>
        <translation>Blendet diese Zeile aus</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>%1: canceled</source>
        <translation>%1: abgebrochen</translation>
    </message>
    <message>
        <source>%1: failed. %2</source>
        <translation>%1: gescheitert. %2</translation>
    </message>
</context>
<context>
    <name>widgets::LogModel</name>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>debug</source>
        <translation>Debug</translation>
    </message>
    <message>
        <source>info</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>fatal</source>
        <translation>fatal</translation>
    </message>
    <message>
        <source>message</source>
        <translation>Meldung</translation>
    </message>
</context>
<context>
    <name>widgets::LoggedCurves</name>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 ist nicht lesbar: %2</translation>
    </message>
    <message>
        <source>Reading %1: %2 %</source>
        <translation>%1 wird gelesen: %2 %</translation>
    </message>
</context>
<context>
    <name>widgets::MarkModel</name>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Error, px</source>
        <translation>Fehler, px</translation>
    </message>
    <message>
        <source>Place, m</source>
        <translation>Ort, m</translation>
    </message>
</context>
<context>
    <name>widgets::MeasureTool</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measures distances and angles: click two or three points, or drag. Esc ends it</source>
        <translation>Misst Abstände und Winkel: zwei oder drei Punkte anklicken, oder ziehen. Esc beendet es</translation>
    </message>
    <message>
        <source>Copy measurement</source>
        <translation>Messung kopieren</translation>
    </message>
    <message>
        <source>Copies what was measured, as text</source>
        <translation>Kopiert das Gemessene als Text</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Click a point of the picture, then another one; a third gives an angle.</source>
        <translation>Einen Punkt des Bildes anklicken, dann einen weiteren; ein dritter ergibt einen Winkel.</translation>
    </message>
</context>
<context>
    <name>widgets::MessagesView</name>
    <message>
        <source>Regular expression</source>
        <translation>Regulärer Ausdruck</translation>
    </message>
    <message>
        <source>Reads the filter as a regular expression</source>
        <translation>Liest den Filter als regulären Ausdruck</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Voriger Treffer</translation>
    </message>
    <message>
        <source>Goes to the match above</source>
        <translation>Geht zum Treffer darüber</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Nächster Treffer</translation>
    </message>
    <message>
        <source>Goes to the match below</source>
        <translation>Geht zum Treffer darunter</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the newest message in view</source>
        <translation>Hält die neueste Meldung im Blick</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops adding messages until it continues; none are lost</source>
        <translation>Fügt keine Meldungen mehr hinzu; sie kommen, wenn es weitergeht</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected rows</source>
        <translation>Kopiert die ausgewählten Zeilen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Empties the list</source>
        <translation>Leert die Liste</translation>
    </message>
    <message>
        <source>Ctrl+Shift+X</source>
        <translation>Ctrl+Shift+X</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Shows messages that are at least this severe</source>
        <translation>Zeigt Meldungen, die mindestens so schwer sind</translation>
    </message>
    <message>
        <source>all levels</source>
        <translation>alle Stufen</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Shows messages of one robot, or of all</source>
        <translation>Zeigt Meldungen eines Roboters oder aller</translation>
    </message>
    <message>
        <source>all robots</source>
        <translation>alle Roboter</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Shows only messages whose text or source contains this</source>
        <translation>Zeigt nur Meldungen, deren Text oder Quelle dies enthält</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Goes to the next message that contains this; Enter for the next</source>
        <translation>Geht zur nächsten Meldung, die dies enthält; Eingabetaste für die nächste</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Number of messages</source>
        <translation>Anzahl der Meldungen</translation>
    </message>
    <message>
        <source>What is wrong with the filter</source>
        <translation>Was am Filter falsch ist</translation>
    </message>
    <message>
        <source>“%1” was not found</source>
        <translation>„%1“ wurde nicht gefunden</translation>
    </message>
    <message>
        <source>%1 of %2 messages</source>
        <translation>%1 von %2 Meldungen</translation>
    </message>
    <message>
        <source>1 message</source>
        <translation>1 Meldung</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 Meldungen</translation>
    </message>
    <message>
        <source>The log holds no messages.</source>
        <translation>Das Log enthält keine Meldungen.</translation>
    </message>
    <message>
        <source>No messages yet. They appear here when a robot&apos;s program logs something.</source>
        <translation>Noch keine Meldungen. Sie erscheinen hier, wenn das Programm eines Roboters etwas meldet.</translation>
    </message>
    <message>
        <source>No message passes the filters. Clear the filter or lower the level.</source>
        <translation>Keine Meldung passiert die Filter. Den Filter leeren oder die Stufe senken.</translation>
    </message>
</context>
<context>
    <name>widgets::MotionBench</name>
    <message>
        <source>(motion)</source>
        <translation>(Bewegung)</translation>
    </message>
    <message>
        <source>Duplicate key frame</source>
        <translation>Keyframe duplizieren</translation>
    </message>
    <message>
        <source>Remove key frame</source>
        <translation>Keyframe entfernen</translation>
    </message>
    <message>
        <source>Move key frame</source>
        <translation>Keyframe verschieben</translation>
    </message>
    <message>
        <source>Mirror key frame</source>
        <translation>Keyframe spiegeln</translation>
    </message>
    <message>
        <source>Mirror motion</source>
        <translation>Bewegung spiegeln</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
</context>
<context>
    <name>widgets::MotionButtons</name>
    <message>
        <source>Motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Plays this motion once, while you steer</source>
        <translation>Spielt diese Bewegung einmal ab, bei manueller Steuerung</translation>
    </message>
</context>
<context>
    <name>widgets::MotionEditorView</name>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>Starts a motion with the joints of the robot</source>
        <translation>Beginnt eine Bewegung mit den Gelenken des Roboters</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Opens a motion, or imports another team&apos;s (.pos, .mot)</source>
        <translation>Öffnet eine Bewegung, oder importiert eine eines anderen Teams (.pos, .mot)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saves the motion to its file</source>
        <translation>Speichert die Bewegung in ihrer Datei</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Saves the motion to another file</source>
        <translation>Speichert die Bewegung in einer anderen Datei</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Reloads the motion from its file</source>
        <translation>Liest die Bewegung wieder aus ihrer Datei</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last edit</source>
        <translation>Macht die letzte Bearbeitung rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redoes the edit</source>
        <translation>Stellt die Bearbeitung wieder her</translation>
    </message>
    <message>
        <source>Duplicate key frame</source>
        <translation>Keyframe duplizieren</translation>
    </message>
    <message>
        <source>Adds a key frame like the selected one behind it</source>
        <translation>Fügt hinter dem ausgewählten Keyframe einen gleichen ein</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Remove key frame</source>
        <translation>Keyframe entfernen</translation>
    </message>
    <message>
        <source>Removes the selected key frame</source>
        <translation>Entfernt den ausgewählten Keyframe</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Swaps the key frame with the previous one</source>
        <translation>Vertauscht den Keyframe mit dem davor</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Swaps the key frame with the next one</source>
        <translation>Vertauscht den Keyframe mit dem danach</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Mirrors the motion: what the left side did, the right side does</source>
        <translation>Spiegelt die Bewegung: was die linke Seite tat, tut die rechte</translation>
    </message>
    <message>
        <source>Mirror key frame</source>
        <translation>Keyframe spiegeln</translation>
    </message>
    <message>
        <source>Mirrors only the selected key frame</source>
        <translation>Spiegelt nur den ausgewählten Keyframe</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Sends the motion to the robot, whose program plays it from then on, without a restart</source>
        <translation>Sendet die Bewegung an den Roboter, dessen Programm sie von da an abspielt, ohne Neustart</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Send changes</source>
        <translation>Änderungen senden</translation>
    </message>
    <message>
        <source>Sends each change that has no errors</source>
        <translation>Sendet jede fehlerfreie Änderung</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Makes the robot play the motion from its own files again</source>
        <translation>Der Roboter spielt wieder die Bewegung aus seinen Dateien ab</translation>
    </message>
    <message>
        <source>Previous key frame</source>
        <translation>Voriger Keyframe</translation>
    </message>
    <message>
        <source>Selects the previous key frame; while you steer, the robot moves to its pose</source>
        <translation>Wählt den vorigen Keyframe aus; bei manueller Steuerung nimmt der Roboter seine Pose ein</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plays the motion once on the robot, while you steer</source>
        <translation>Spielt die Bewegung einmal auf dem Roboter ab, bei manueller Steuerung</translation>
    </message>
    <message>
        <source>Next key frame</source>
        <translation>Nächster Keyframe</translation>
    </message>
    <message>
        <source>Selects the next key frame; while you steer, the robot moves to its pose</source>
        <translation>Wählt den nächsten Keyframe aus; bei manueller Steuerung nimmt der Roboter seine Pose ein</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Open from the robot</source>
        <translation>Vom Roboter öffnen</translation>
    </message>
    <message>
        <source>Save as, motions of the robot, order of key frames, take back</source>
        <translation>Speichern unter, Bewegungen des Roboters, Reihenfolge der Keyframes, zurücknehmen</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Keyframes</translation>
    </message>
    <message>
        <source>Errors of the motion</source>
        <translation>Fehler der Bewegung</translation>
    </message>
    <message>
        <source>The motion and the robot</source>
        <translation>Die Bewegung und der Roboter</translation>
    </message>
    <message>
        <source>Name: letters, digits, - and _</source>
        <translation>Name: Buchstaben, Ziffern, - und _</translation>
    </message>
    <message>
        <source>New motion</source>
        <translation>Neue Bewegung</translation>
    </message>
    <message>
        <source>The robot&apos;s program plays no motions</source>
        <translation>Das Programm des Roboters spielt keine Bewegungen ab</translation>
    </message>
    <message>
        <source>%1 (sent)</source>
        <translation>%1 (gesendet)</translation>
    </message>
    <message>
        <source>No motion. Open one, start one with New, or capture a pose in the view Joints.</source>
        <translation>Keine Bewegung. Eine öffnen, mit „Neu“ eine beginnen oder in der Ansicht Gelenke eine Pose erfassen.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>Motion editor</source>
        <translation>Bewegungseditor</translation>
    </message>
    <message>
        <source>Motion editor: %1</source>
        <translation>Bewegungseditor: %1</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Up</source>
        <translation>Ctrl+Alt+Up</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Down</source>
        <translation>Ctrl+Alt+Down</translation>
    </message>
</context>
<context>
    <name>widgets::MotionFiles</name>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>%1 (not saved)</source>
        <translation>%1 (nicht gespeichert)</translation>
    </message>
    <message>
        <source>Imported from %1; save it to keep it.</source>
        <translation>Importiert aus %1; speichern, um sie zu behalten.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Changes cannot be backed up: %1</source>
        <translation>Änderungen können nicht gesichert werden: %1</translation>
    </message>
    <message>
        <source>An unsaved motion could not be restored: %1; it is kept in %2</source>
        <translation>Eine nicht gespeicherte Bewegung konnte nicht wiederhergestellt werden: %1; sie liegt in %2</translation>
    </message>
    <message>
        <source>The program ended without saving last time. The unsaved motion %1 was restored; save it to keep it.</source>
        <translation>Das Programm endete letztes Mal ohne Speichern. Die nicht gespeicherte Bewegung %1 wurde wiederhergestellt; speichern, um sie zu behalten.</translation>
    </message>
    <message>
        <source>Save motion</source>
        <translation>Bewegung speichern</translation>
    </message>
    <message>
        <source>Motions (*.mof)</source>
        <translation>Bewegungen (*.mof)</translation>
    </message>
    <message>
        <source>Open motion</source>
        <translation>Bewegung öffnen</translation>
    </message>
    <message>
        <source>Motions (*.mof *.pos *.mot);;All files (*)</source>
        <translation>Bewegungen (*.mof *.pos *.mot);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>The motion %1 was changed and not saved.</source>
        <translation>Die Bewegung %1 wurde geändert und nicht gespeichert.</translation>
    </message>
    <message>
        <source>Save it?</source>
        <translation>Speichern?</translation>
    </message>
</context>
<context>
    <name>widgets::MotionLink</name>
    <message>
        <source>Sending to %1…</source>
        <translation>Wird an %1 gesendet…</translation>
    </message>
    <message>
        <source>%1 refuses it: %2</source>
        <translation>%1 lehnt sie ab: %2</translation>
    </message>
    <message>
        <source>%1 has this motion, as it was sent</source>
        <translation>%1 hat diese Bewegung, wie sie gesendet wurde</translation>
    </message>
    <message>
        <source>%1 has this motion</source>
        <translation>%1 hat diese Bewegung</translation>
    </message>
    <message>
        <source>%1 has a different version of this motion</source>
        <translation>%1 hat einen anderen Text dieser Bewegung</translation>
    </message>
    <message>
        <source>%1 does not have this motion yet</source>
        <translation>%1 hat diese Bewegung noch nicht</translation>
    </message>
    <message>
        <source>No robot to send it to</source>
        <translation>Kein Roboter, dem sie gesendet werden kann</translation>
    </message>
    <message>
        <source>%1 has no joints, so it plays no motions</source>
        <translation>%1 hat keine Gelenke und spielt daher keine Bewegungen ab</translation>
    </message>
    <message>
        <source>The program of %1 plays no motions</source>
        <translation>Das Programm von %1 spielt keine Bewegungen ab</translation>
    </message>
    <message>
        <source>there is no answer; is its program running?</source>
        <translation>er antwortet nicht; läuft sein Programm?</translation>
    </message>
</context>
<context>
    <name>widgets::MotionTextEdit</name>
    <message>
        <source>Text of the motion</source>
        <translation>Text der Bewegung</translation>
    </message>
    <message>
        <source>Typing</source>
        <translation>Tippen</translation>
    </message>
</context>
<context>
    <name>widgets::MotionTimeLine</name>
    <message>
        <source>Timeline of key frames</source>
        <translation>Zeitleiste der Keyframes</translation>
    </message>
    <message>
        <source>No key frames yet</source>
        <translation>Noch keine Keyframes</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Key frame %1, line %2: from %3 s to %4 s. Drag its end to change how long it takes.</source>
        <translation>Keyframe %1, Zeile %2: von %3 s bis %4 s. Sein Ende ziehen, um seine Dauer zu ändern.</translation>
    </message>
</context>
<context>
    <name>widgets::MotionView</name>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Switches the behavior to obeying you, and back</source>
        <translation>Schaltet das Verhalten auf manuelle Steuerung um und zurück</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Switches the motors on and off, at the base</source>
        <translation>Schaltet die Motoren an der Basis ein und aus</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>Stops the robot at its platform, regardless of its program, until released</source>
        <translation>Hält den Roboter an seiner Plattform an, was auch immer sein Programm tut; gilt bis zum Lösen</translation>
    </message>
    <message>
        <source>Robot that is steered</source>
        <translation>Gesteuerter Roboter</translation>
    </message>
    <message>
        <source>It is chosen in the toolbar</source>
        <translation>Er wird in der Werkzeugleiste gewählt</translation>
    </message>
    <message>
        <source>Who steers</source>
        <translation>Wer steuert</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Turns while it is held: left is counterclockwise</source>
        <translation>Dreht, solange es gehalten wird: links ist gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>Left stick walks, right stick turns, A kicks, B is STOP</source>
        <translation>Linker Stick geht, rechter Stick dreht, A schießt, B ist STOP</translation>
    </message>
    <message>
        <source>Stops %1 at its platform, regardless of its program, until released</source>
        <translation>Hält %1 an seiner Plattform an, was auch immer das Programm tut; gilt bis zum Lösen</translation>
    </message>
    <message>
        <source>Either stick drives and turns, B is STOP</source>
        <translation>Jeder Stick fährt und dreht, B ist STOP</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>Gamepad: %1</translation>
    </message>
    <message>
        <source>No gamepad; plug one in to use it</source>
        <translation>Kein Gamepad; eines anschließen, um es zu verwenden</translation>
    </message>
    <message>
        <source>Give back</source>
        <translation>Zurückgeben</translation>
    </message>
    <message>
        <source>Motors on</source>
        <translation>Motoren ein</translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation>Motoren aus</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot.</source>
        <translation>Kein Roboter. Eine Simulation starten oder mit einem Roboter verbinden.</translation>
    </message>
    <message>
        <source>The connection to the robot is lost. The robot has stopped; you can steer it again when it is reconnected.</source>
        <translation>Die Verbindung zum Roboter ist verloren. Er steht und lässt sich steuern, sobald er wiedergefunden ist.</translation>
    </message>
    <message>
        <source>The emergency stop is pressed: release it on the robot.</source>
        <translation>Der Not-Halt ist gedrückt: am Roboter lösen.</translation>
    </message>
    <message>
        <source>You steer the robot, but its motors are off: switch them on.</source>
        <translation>Der Roboter wird von hier gesteuert, aber seine Motoren sind aus: sie einschalten.</translation>
    </message>
    <message>
        <source>Take over to steer</source>
        <translation>Zum Steuern übernehmen</translation>
    </message>
    <message>
        <source>Gamepad…</source>
        <translation>Gamepad…</translation>
    </message>
    <message>
        <source>Chooses what the axes and buttons of the gamepad do</source>
        <translation>Wählt, was Achsen und Knöpfe des Gamepads tun</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::NewSceneDialog</name>
    <message>
        <source>New scene</source>
        <translation>Neue Szene</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the world and its file: letters, digits, - and _</source>
        <translation>Der Welt und ihrer Datei: Buchstaben, Ziffern, - und _</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Height of the walls</source>
        <translation>Höhe der Wände</translation>
    </message>
    <message>
        <source>Wall across the middle with a doorway</source>
        <translation>Wand quer durch die Mitte mit einem Durchgang</translation>
    </message>
    <message>
        <source>The doorway is 1 m wide; a door fits into it</source>
        <translation>Der Durchgang ist 1 m breit; eine Tür passt hinein</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>The robot that stands in the room</source>
        <translation>Der Roboter, der im Raum steht</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Why the scene cannot be made</source>
        <translation>Warum die Szene nicht erzeugt werden kann</translation>
    </message>
</context>
<context>
    <name>widgets::OpenLogs</name>
    <message>
        <source>The bookmarks cannot be used: %1</source>
        <translation>Die Lesezeichen können nicht verwendet werden: %1</translation>
    </message>
    <message>
        <source>add a bookmark</source>
        <translation>Lesezeichen setzen</translation>
    </message>
    <message>
        <source>Bookmark %1</source>
        <translation>Lesezeichen %1</translation>
    </message>
    <message>
        <source>change a bookmark</source>
        <translation>Lesezeichen ändern</translation>
    </message>
    <message>
        <source>remove a bookmark</source>
        <translation>Lesezeichen entfernen</translation>
    </message>
    <message>
        <source>The bookmarks were not saved: %1</source>
        <translation>Die Lesezeichen wurden nicht gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>widgets::OptionCanvas</name>
    <message>
        <source>Options of the behavior</source>
        <translation>Optionen des Verhaltens</translation>
    </message>
</context>
<context>
    <name>widgets::PackageSourceDelegate</name>
    <message>
        <source>Source of the package</source>
        <translation>Quelle des Pakets</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::PacketDetails</name>
    <message>
        <source>Packet</source>
        <translation>Datenpaket</translation>
    </message>
    <message>
        <source>The selected packet, field by field, and its bytes</source>
        <translation>Das ausgewählte Datenpaket, Feld für Feld, und seine Bytes</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 Byte</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
</context>
<context>
    <name>widgets::PacketInspector</name>
    <message>
        <source>Damaged only</source>
        <translation>Nur beschädigte</translation>
    </message>
    <message>
        <source>Shows only damaged packets</source>
        <translation>Zeigt nur beschädigte Datenpakete</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the newest packet in view</source>
        <translation>Hält das neueste Datenpaket im Blick</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops adding packets until it continues; none are lost</source>
        <translation>Fügt keine Datenpakete mehr hinzu; sie kommen, wenn es weitergeht</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected rows with their bytes</source>
        <translation>Kopiert die ausgewählten Zeilen mit ihren Bytes</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Empties the list</source>
        <translation>Leert die Liste</translation>
    </message>
    <message>
        <source>Ctrl+Shift+X</source>
        <translation>Ctrl+Shift+X</translation>
    </message>
    <message>
        <source>Save conversation...</source>
        <translation>Kommunikation speichern...</translation>
    </message>
    <message>
        <source>Saves all packets of the list, regardless of the filters, as a .wire file</source>
        <translation>Speichert alle Datenpakete der Liste, ungeachtet der Filter, als .wire-Datei</translation>
    </message>
    <message>
        <source>Open conversation...</source>
        <translation>Kommunikation öffnen...</translation>
    </message>
    <message>
        <source>Opens a .wire file, whose client packets can be replayed</source>
        <translation>Öffnet eine .wire-Datei, deren Client-Datenpakete abgespielt werden können</translation>
    </message>
    <message>
        <source>Back to the line</source>
        <translation>Zurück zur Leitung</translation>
    </message>
    <message>
        <source>Closes the file and shows the line&apos;s current packets</source>
        <translation>Schließt die Datei und zeigt die jetzigen Datenpakete der Leitung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Shows packets from the robot, to it, or both</source>
        <translation>Zeigt Datenpakete vom Roboter, zum Roboter oder beide</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>beide Richtungen</translation>
    </message>
    <message>
        <source>from the robot</source>
        <translation>vom Roboter</translation>
    </message>
    <message>
        <source>to the robot</source>
        <translation>zum Roboter</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Which packets are shown, by their names</source>
        <translation>Welche Datenpakete gezeigt werden, nach ihren Namen</translation>
    </message>
    <message>
        <source>all names</source>
        <translation>alle Namen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Shows only packets whose name, text or bytes (as hexadecimal digits) contain this</source>
        <translation>Zeigt nur Datenpakete, deren Name, Text oder Bytes (als Hexadezimalziffern) dies enthalten</translation>
    </message>
    <message>
        <source>Conversation</source>
        <translation>Kommunikation</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Datenpakete</translation>
    </message>
    <message>
        <source>Number of packets</source>
        <translation>Anzahl der Datenpakete</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Save conversation</source>
        <translation>Kommunikation speichern</translation>
    </message>
    <message>
        <source>Open conversation</source>
        <translation>Kommunikation öffnen</translation>
    </message>
    <message>
        <source>Conversations (*.wire)</source>
        <translation>Kommunikation (*.wire)</translation>
    </message>
    <message>
        <source>Conversations (*.wire);;All files (*)</source>
        <translation>Kommunikation (*.wire);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 of %2 packets</source>
        <translation>%1 von %2 Datenpaketen</translation>
    </message>
    <message>
        <source>1 packet</source>
        <translation>1 Datenpaket</translation>
    </message>
    <message>
        <source>%1 packets</source>
        <translation>%1 Datenpakete</translation>
    </message>
    <message>
        <source>; %1 arrived too fast to keep</source>
        <translation>; %1 kamen zu schnell, um sie zu behalten</translation>
    </message>
    <message>
        <source>; paused</source>
        <translation>; angehalten</translation>
    </message>
    <message>
        <source>1 name hidden</source>
        <translation>1 Name ausgeblendet</translation>
    </message>
    <message>
        <source>%1 names hidden</source>
        <translation>%1 Namen ausgeblendet</translation>
    </message>
    <message>
        <source>No packets yet to or from %1. They appear when its line is open; a recorded conversation can be opened.</source>
        <translation>Noch keine Datenpakete zu oder von %1. Sie erscheinen, wenn die Leitung offen ist; eine aufgezeichnete Kommunikation lässt sich öffnen.</translation>
    </message>
    <message>
        <source>No packet passes the filters. Clear the filter, or show all names.</source>
        <translation>Kein Datenpaket passiert die Filter. Den Filter leeren oder alle Namen zeigen.</translation>
    </message>
    <message>
        <source>No robot. Connect to one (menu Robot), or open a recorded conversation.</source>
        <translation>Kein Roboter. Einen verbinden (Menü Roboter) oder eine aufgezeichnete Kommunikation öffnen.</translation>
    </message>
</context>
<context>
    <name>widgets::PacketModel</name>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>← robot</source>
        <translation>← Roboter</translation>
    </message>
    <message>
        <source>→ robot</source>
        <translation>→ Roboter</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
</context>
<context>
    <name>widgets::PacketReplayBar</name>
    <message>
        <source>Replay progress</source>
        <translation>Fortschritt des Abspielens</translation>
    </message>
    <message>
        <source>What is being replayed</source>
        <translation>Was abgespielt wird</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Sends the client&apos;s packets to the robot, at their times; continues only while this view is visible</source>
        <translation>Sendet die Datenpakete des Clients an den Roboter, zu ihren Zeiten; läuft nur weiter, solange diese Ansicht sichtbar ist</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Next packet</source>
        <translation>Nächstes Datenpaket</translation>
    </message>
    <message>
        <source>Sends the client&apos;s next packet</source>
        <translation>Sendet das nächste Datenpaket des Clients</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Stop replay</source>
        <translation>Abspielen beenden</translation>
    </message>
    <message>
        <source>Stops sending</source>
        <translation>Beendet das Senden</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Backspace</source>
        <translation>Ctrl+Shift+Backspace</translation>
    </message>
    <message>
        <source>There are no packets of a client.</source>
        <translation>Es gibt keine Datenpakete eines Clients.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source> (1 left out that would open or close a connection)</source>
        <translation> (1 ausgelassen, das eine Verbindung öffnen oder schließen würde)</translation>
    </message>
    <message>
        <source> (%1 left out that would open or close a connection)</source>
        <translation> (%1 ausgelassen, die eine Verbindung öffnen oder schließen würden)</translation>
    </message>
    <message>
        <source>Replaying %1 to %2</source>
        <translation>%1 wird an %2 abgespielt</translation>
    </message>
    <message>
        <source>%1, packet by packet, to %2</source>
        <translation>%1, Datenpaket für Datenpaket, an %2</translation>
    </message>
    <message>
        <source>Replay finished</source>
        <translation>Abspielen beendet</translation>
    </message>
    <message>
        <source>Connect to a robot to replay to.</source>
        <translation>Zum Abspielen mit einem Roboter verbinden.</translation>
    </message>
</context>
<context>
    <name>widgets::ParameterModel</name>
    <message>
        <source>changed from %1</source>
        <translation>geändert von %1</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>reset %1</source>
        <translation>%1 zurückgesetzt</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Eingebaut</translation>
    </message>
</context>
<context>
    <name>widgets::ParameterPanel</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last edit</source>
        <translation>Macht die letzte Bearbeitung rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redoes the edit</source>
        <translation>Stellt die Bearbeitung wieder her</translation>
    </message>
    <message>
        <source>Reset to default</source>
        <translation>Auf Vorgabe zurücksetzen</translation>
    </message>
    <message>
        <source>Resets the current parameter, or group, to its default</source>
        <translation>Setzt den jetzigen Parameter oder die Gruppe auf die Vorgabe zurück</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Resets every parameter to its default</source>
        <translation>Setzt jeden Parameter auf seine Vorgabe zurück</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Requests the robot&apos;s values again</source>
        <translation>Fordert die Werte des Roboters noch einmal an</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saves changes to the file that the program reads when it starts; its comments stay</source>
        <translation>Speichert die Änderungen in der Datei, die das Programm bei seinem Start liest; ihre Kommentare bleiben</translation>
    </message>
    <message>
        <source>Save to another file…</source>
        <translation>In einer anderen Datei speichern…</translation>
    </message>
    <message>
        <source>Saves the parameters to a file that you choose</source>
        <translation>Speichert die Parameter in einer gewählten Datei</translation>
    </message>
    <message>
        <source>Parameters of</source>
        <translation>Parameter von</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>State of the parameters</source>
        <translation>Zustand der Parameter</translation>
    </message>
    <message>
        <source>Save parameters</source>
        <translation>Parameter speichern</translation>
    </message>
    <message>
        <source>Parameters (*.textproto)</source>
        <translation>Parameter (*.textproto)</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Choose a solution to see its parameters.</source>
        <translation>Eine Lösung wählen, um ihre Parameter zu sehen.</translation>
    </message>
    <message>
        <source>This solution has no parameters.</source>
        <translation>Diese Lösung hat keine Parameter.</translation>
    </message>
    <message>
        <source>Asking the robot for the parameters…</source>
        <translation>Der Roboter wird nach den Parametern gefragt…</translation>
    </message>
    <message>
        <source>Not reported: %1</source>
        <translation>Nicht gemeldet: %1</translation>
    </message>
    <message>
        <source>These parameters are of the type %1, which cannot be read here.</source>
        <translation>Diese Parameter sind vom Typ %1, der hier nicht gelesen werden kann.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Wird gesendet…</translation>
    </message>
    <message>
        <source>The parameters of %1 were refused: %2</source>
        <translation>Die Parameter von %1 wurden abgelehnt: %2</translation>
    </message>
    <message>
        <source>Set.</source>
        <translation>Gesetzt.</translation>
    </message>
</context>
<context>
    <name>widgets::ParameterSlider</name>
    <message>
        <source>Value of the parameter</source>
        <translation>Wert des Parameters</translation>
    </message>
    <message>
        <source>Drag to change the current parameter; it is set on release</source>
        <translation>Ziehen ändert den jetzigen Parameter; gesetzt wird er beim Loslassen</translation>
    </message>
</context>
<context>
    <name>widgets::PathCanvas</name>
    <message>
        <source>Plot of one value over another</source>
        <translation>Kurve von Werten übereinander</translation>
    </message>
</context>
<context>
    <name>widgets::PictureFile</name>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Nothing was saved to %1: %2</source>
        <translation>In %1 wurde nichts gespeichert: %2</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>there is no picture yet</source>
        <translation>es gibt noch kein Bild</translation>
    </message>
    <message>
        <source>Replace %1?</source>
        <translation>%1 ersetzen?</translation>
    </message>
</context>
<context>
    <name>widgets::PictureView</name>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zooms in</source>
        <translation>Vergrößert, was gezeigt wird</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zooms out</source>
        <translation>Verkleinert, was gezeigt wird</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copies this picture</source>
        <translation>Kopiert dieses Bild</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Bild speichern...</translation>
    </message>
    <message>
        <source>Saves this picture as PNG</source>
        <translation>Speichert dieses Bild als PNG</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Freezes this image while the robot continues</source>
        <translation>Friert dieses Bild ein, während der Roboter weiterläuft</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>Shows the list of drawings</source>
        <translation>Zeigt die Liste der Zeichnungen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Video or images…</source>
        <translation>Video oder Bilder…</translation>
    </message>
    <message>
        <source>Writes this picture over time, as a video or as a series of images</source>
        <translation>Schreibt dieses Bild über der Zeit, als Video oder als Bildfolge</translation>
    </message>
    <message>
        <source>Pose of drawings</source>
        <translation>Pose der Zeichnungen</translation>
    </message>
    <message>
        <source>Chooses at which pose of the robot its drawings are placed: the true one or an estimate</source>
        <translation>Wählt, an welcher Pose des Roboters seine Zeichnungen liegen: der wahren oder einer Schätzung</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Zahlen kopieren</translation>
    </message>
    <message>
        <source>Copies the numbers that are shown here, with tabs between the columns</source>
        <translation>Kopiert die Zahlen, die hier gezeigt werden, mit Tabulatoren zwischen den Spalten</translation>
    </message>
</context>
<context>
    <name>widgets::PlacePanel</name>
    <message>
        <source>Computed from</source>
        <translation>Berechnet aus</translation>
    </message>
    <message>
        <source>Data from which the camera&apos;s pose is computed</source>
        <translation>Woraus der Ort der Kamera berechnet wird</translation>
    </message>
    <message>
        <source>Marks of the field</source>
        <translation>Marken des Feldes</translation>
    </message>
    <message>
        <source>Board on the ground</source>
        <translation>Brett auf dem Boden</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Computes the pose from the visible board, which must lie on the ground</source>
        <translation>Berechnet den Ort aus dem Brett, das jetzt zu sehen ist und auf dem Boden liegt</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Clears the click on the selected mark</source>
        <translation>Vergisst, wo die ausgewählte Marke angeklickt wurde</translation>
    </message>
    <message>
        <source>Forget all</source>
        <translation>Alle vergessen</translation>
    </message>
    <message>
        <source>Clears the clicks on all marks</source>
        <translation>Vergisst, wo alle Marken angeklickt wurden</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Sets height, tilt and roll as parameters of the solution of camera-pose</source>
        <translation>Setzt Höhe, Neigung und Rollwinkel als Parameter der Lösung für camera-pose</translation>
    </message>
    <message>
        <source>The place of the camera</source>
        <translation>Der Ort der Kamera</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>Height %1 m, tilt %2°, roll %3°; error %4 px</source>
        <translation>Höhe %1 m, Neigung %2°, Rollwinkel %3°; Fehler %4 px</translation>
    </message>
    <message>
        <source>On the field at %1, %2 m, looking along %3°</source>
        <translation>Im Feld bei %1, %2 m, Blick in Richtung %3°</translation>
    </message>
</context>
<context>
    <name>widgets::PlotCanvas</name>
    <message>
        <source>Plot</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
</context>
<context>
    <name>widgets::PlotHatches</name>
    <message>
        <source>being read from disk</source>
        <translation>wird von der Platte gelesen</translation>
    </message>
    <message>
        <source>on disk; look there with the timeline</source>
        <translation>auf der Platte; mit der Zeitleiste hinsehen</translation>
    </message>
    <message>
        <source>lost, since the disk was too slow</source>
        <translation>verloren, weil die Platte zu langsam war</translation>
    </message>
</context>
<context>
    <name>widgets::PlotsView</name>
    <message>
        <source>Export the points as CSV</source>
        <translation>Die Punkte als CSV exportieren</translation>
    </message>
    <message>
        <source>Export the spectrum as CSV</source>
        <translation>Das Spektrum als CSV exportieren</translation>
    </message>
    <message>
        <source>Export the picture</source>
        <translation>Das Bild exportieren</translation>
    </message>
    <message>
        <source>Export the drawing</source>
        <translation>Die Zeichnung exportieren</translation>
    </message>
    <message>
        <source>From A to B: %1 s</source>
        <translation>Von A bis B: %1 s</translation>
    </message>
    <message>
        <source>Nothing to plot yet. Start a simulation or connect to a robot.</source>
        <translation>Noch nichts zu zeichnen. Eine Simulation starten oder mit einem Roboter verbinden.</translation>
    </message>
    <message>
        <source>Choose values on the left: double click, Enter or drag them here.</source>
        <translation>Links Werte wählen: Doppelklick, Eingabetaste oder hierher ziehen.</translation>
    </message>
    <message>
        <source>At character %1: %2</source>
        <translation>Bei Zeichen %1: %2</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Select a curve below the plot first.</source>
        <translation>Zuerst unten eine Kurve auswählen.</translation>
    </message>
    <message>
        <source>Select two curves below the plot first: the upper one becomes the x axis, the lower one the y axis.</source>
        <translation>Zuerst unten zwei Kurven auswählen: die obere geht nach rechts, die untere nach oben.</translation>
    </message>
    <message>
        <source>Mark texts</source>
        <translation>Texte markieren</translation>
    </message>
    <message>
        <source>Messages that match this regular expression are marked in plots and timeline; empty: none</source>
        <translation>Meldungen, auf die dieser reguläre Ausdruck passt, werden in Kurven und Zeitleiste markiert; leer: keine</translation>
    </message>
    <message>
        <source>Asked %1 for %2 (debug key)</source>
        <translation>%1 wurde um %2 gebeten (Debug-Schlüssel)</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 wurde abgelehnt: %2</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>The saved layout has too many curves (%1); only the first %2 are shown.</source>
        <translation>Die gespeicherte Anordnung hat zu viele Kurven (%1); nur die ersten %2 werden gezeigt.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Shows the tree of what can be plotted</source>
        <translation>Zeigt den Baum dessen, was sich zeichnen lässt</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds the selected values as curves</source>
        <translation>Fügt die ausgewählten Werte als Kurven hinzu</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected curves</source>
        <translation>Entfernt die ausgewählten Kurven</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the newest values in view</source>
        <translation>Hält die neuesten Werte im Blick</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Freezes the plot; nothing is lost</source>
        <translation>Friert die Kurven ein; nichts geht verloren</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Whole log</source>
        <translation>Ganzes Log</translation>
    </message>
    <message>
        <source>Reads the curves of the whole log, without playing it</source>
        <translation>Liest die Kurven des ganzen Logs, ohne es abzuspielen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Shows all points of the curves</source>
        <translation>Zeigt alle Punkte der Kurven</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Writes all points to a table</source>
        <translation>Schreibt alle Punkte in eine Tabelle</translation>
    </message>
    <message>
        <source>Export PNG</source>
        <translation>PNG exportieren</translation>
    </message>
    <message>
        <source>Writes the picture to a file</source>
        <translation>Schreibt das Bild in eine Datei</translation>
    </message>
    <message>
        <source>Export SVG</source>
        <translation>SVG exportieren</translation>
    </message>
    <message>
        <source>Writes the drawing to a file</source>
        <translation>Schreibt die Zeichnung in eine Datei</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copies the picture</source>
        <translation>Kopiert das Bild</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Voriger Ausschnitt</translation>
    </message>
    <message>
        <source>Shows the previous section</source>
        <translation>Zeigt, was vorher gezeigt wurde</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Nächster Ausschnitt</translation>
    </message>
    <message>
        <source>Redoes the zoom</source>
        <translation>Zeigt, was vor dem Zurückgehen gezeigt wurde</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Koppeln</translation>
    </message>
    <message>
        <source>Keeps the same time range as the other linked plots</source>
        <translation>Zeigt dieselben Zeiten wie die anderen gekoppelten Kurven</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Shows what is at and between two cursors; a click sets A, Shift+click sets B</source>
        <translation>Zeigt, was an und zwischen zwei Cursorn ist; ein Klick setzt A, Umschalt+Klick setzt B</translation>
    </message>
    <message>
        <source>Other axis</source>
        <translation>Andere Achse</translation>
    </message>
    <message>
        <source>Moves the selected curves to the axis on the right, or back</source>
        <translation>Verschiebt die ausgewählten Kurven auf die rechte Achse oder zurück</translation>
    </message>
    <message>
        <source>As states</source>
        <translation>Als Zustände</translation>
    </message>
    <message>
        <source>Shows the selected curves as strips of states, or as curves again</source>
        <translation>Zeigt die ausgewählten Kurven als Streifen von Zuständen oder wieder als Kurven</translation>
    </message>
    <message>
        <source>Over each other</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Plots the lower of two selected curves over the upper one, instead of over time</source>
        <translation>Fügt die untere zweier ausgewählter Kurven über der oberen hinzu, statt über der Zeit</translation>
    </message>
    <message>
        <source>Equal axes</source>
        <translation>Gleiche Achsen</translation>
    </message>
    <message>
        <source>Uses the same scale on both axes of plots of one value over another</source>
        <translation>Zeichnet Einheiten auf beiden Achsen von Kurven über anderen gleich lang</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Shows the spectrum of the selected curves, or of all, of the shown times or between the cursors</source>
        <translation>Zeigt das Spektrum der ausgewählten Kurven oder aller, der gezeigten Zeiten oder zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Mark texts…</source>
        <translation>Texte markieren…</translation>
    </message>
    <message>
        <source>Marks the times of matching messages</source>
        <translation>Markiert, wann passende Meldungen geschrieben wurden</translation>
    </message>
    <message>
        <source>Previous change</source>
        <translation>Vorige Änderung</translation>
    </message>
    <message>
        <source>Shows when the selected curve changed before</source>
        <translation>Zeigt, wann sich die ausgewählte Kurve davor geändert hat</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Next change</source>
        <translation>Nächste Änderung</translation>
    </message>
    <message>
        <source>Shows when the selected curve changes next</source>
        <translation>Zeigt, wann sich die ausgewählte Kurve danach ändert</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Export the spectrum</source>
        <translation>Das Spektrum exportieren</translation>
    </message>
    <message>
        <source>Writes the amplitudes to a table</source>
        <translation>Schreibt die Amplituden in eine Tabelle</translation>
    </message>
    <message>
        <source>Search values</source>
        <translation>Werte suchen</translation>
    </message>
    <message>
        <source>Shows the values whose path contains this</source>
        <translation>Zeigt die Werte, deren Pfad dies enthält</translation>
    </message>
    <message>
        <source>Values that can be plotted</source>
        <translation>Werte, die sich zeichnen lassen</translation>
    </message>
    <message>
        <source>Double click, Enter or drag into the plot to add a curve</source>
        <translation>Doppelklick, Eingabetaste oder in die Kurven ziehen, um eine Kurve hinzuzufügen</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Ausdruck</translation>
    </message>
    <message>
        <source>A formula over values, as in sqrt(models/ball.position.x^2 + models/ball.position.y^2); Enter adds it as a curve. Manual: Expressions.</source>
        <translation>Eine Formel über Werte, etwa sqrt(models/ball.position.x^2 + models/ball.position.y^2); die Eingabetaste fügt sie als Kurve hinzu. Handbuch: Expressions.</translation>
    </message>
    <message>
        <source>Formula over values, Enter adds it</source>
        <translation>Formel über Werte, Eingabetaste fügt sie hinzu</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Between the cursors</source>
        <translation>Zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Adds a curve computed from the selected ones</source>
        <translation>Fügt hinzu, was aus den ausgewählten Kurven berechnet wird</translation>
    </message>
    <message>
        <source>Time window</source>
        <translation>Zeitfenster</translation>
    </message>
    <message>
        <source>What is shown while following: the last seconds, or all</source>
        <translation>Was beim Folgen gezeigt wird: die letzten Sekunden oder alles</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>State of the plots</source>
        <translation>Zustand der Kurven</translation>
    </message>
</context>
<context>
    <name>widgets::PoseMenu</name>
    <message>
        <source>Robots&apos; drawings are placed at</source>
        <translation>Zeichnungen der Roboter liegen an</translation>
    </message>
    <message>
        <source>The &amp;usual pose</source>
        <translation>Der ü&amp;blichen Pose</translation>
    </message>
    <message>
        <source>The true pose if known, otherwise the robot&apos;s own estimate</source>
        <translation>Die wahre Pose, wo sie bekannt ist, sonst die eigene Schätzung des Roboters</translation>
    </message>
    <message>
        <source>The &amp;true pose</source>
        <translation>Der &amp;wahren Pose</translation>
    </message>
    <message>
        <source>Only simulated robots have one</source>
        <translation>Nur simulierte Roboter haben eine</translation>
    </message>
    <message>
        <source>The estimate %1</source>
        <translation>Der Schätzung %1</translation>
    </message>
    <message>
        <source>The robot&apos;s own estimate of its pose</source>
        <translation>Wo der Roboter zu sein glaubt</translation>
    </message>
</context>
<context>
    <name>widgets::ProcessGraphWidget</name>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 verpasst</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>Plattform</translation>
    </message>
    <message>
        <source>Graph of the processes</source>
        <translation>Graph der Prozesse</translation>
    </message>
    <message>
        <source>%1, %2 a second</source>
        <translation>%1, %2 pro Sekunde</translation>
    </message>
    <message>
        <source>1 package</source>
        <translation>1 Paket</translation>
    </message>
    <message>
        <source>%1 packages</source>
        <translation>%1 Pakete</translation>
    </message>
    <message>
        <source>from %1, %2</source>
        <translation>von %1, %2</translation>
    </message>
    <message>
        <source>blocking</source>
        <translation>blockierend</translation>
    </message>
    <message>
        <source>not blocking</source>
        <translation>nicht blockierend</translation>
    </message>
    <message>
        <source>blocking: the next frame waits until all receivers have taken it</source>
        <translation>blockierend: der nächste Frame wartet, bis alle Empfänger es genommen haben</translation>
    </message>
    <message>
        <source>1 was replaced by a newer one before it was used</source>
        <translation>1 wurde durch ein neueres ersetzt, bevor es verwendet wurde</translation>
    </message>
    <message>
        <source>%1 were replaced by newer ones before they were used</source>
        <translation>%1 wurden durch neuere ersetzt, bevor sie verwendet wurden</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 Frame</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Frames</translation>
    </message>
    <message>
        <source>Tasks: %1</source>
        <translation>Aufgaben: %1</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>held: replaced by a value published in the view Data</source>
        <translation>gehalten: Ein in der Ansicht Daten veröffentlichter Wert steht an seiner Stelle</translation>
    </message>
</context>
<context>
    <name>widgets::ProcessTableModel</name>
    <message>
        <source>Process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Nice</source>
        <translation>Nice</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Verpasst</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Verworfen</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>The process does not keep up: it waits for each package, and loses some</source>
        <translation>Der Prozess kommt nicht mit: er wartet auf jedes Paket und verliert einige</translation>
    </message>
    <message>
        <source>Replaced by newer ones before they were read, as the layout intends</source>
        <translation>Durch neuere ersetzt, bevor sie gelesen wurden, wie das Layout es vorsieht</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>Plattform</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>events</source>
        <translation>Ereignisse</translation>
    </message>
</context>
<context>
    <name>widgets::ProcessesView</name>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Shows the whole graph</source>
        <translation>Zeigt den ganzen Graphen</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Makes the graph larger</source>
        <translation>Vergrößert den Graphen</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Makes the graph smaller</source>
        <translation>Verkleinert den Graphen</translation>
    </message>
    <message>
        <source>Debug links</source>
        <translation>Debug-Verbindungen</translation>
    </message>
    <message>
        <source>Also shows the links of the debug process with all others</source>
        <translation>Zeigt auch die Verbindungen des Debug-Prozesses mit allen anderen</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Shows the table of the processes</source>
        <translation>Zeigt die Tabelle der Prozesse</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Reloads the robot&apos;s tables</source>
        <translation>Fordert die Tabellen des Roboters noch einmal an</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Eine Simulation starten oder mit einem Roboter verbinden und ihn in der Werkzeugleiste wählen.</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Prozesse</translation>
    </message>
    <message>
        <source>The robot has not reported its processes yet. Start its program.</source>
        <translation>Der Roboter hat seine Prozesse noch nicht gemeldet. Sein Programm starten.</translation>
    </message>
</context>
<context>
    <name>widgets::PropertiesModel</name>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>attenuation</source>
        <translation>Abschwächung</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>center of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>initial position</source>
        <translation>Ort am Anfang</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>Lichtstärke</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>maximum speed</source>
        <translation>größte Geschwindigkeit</translation>
    </message>
    <message>
        <source>maximum torque</source>
        <translation>größtes Drehmoment</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>opening angles</source>
        <translation>Öffnungswinkel</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>Rückprall</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>track</source>
        <translation>Spurweite</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>wheel radius</source>
        <translation>Radradius</translation>
    </message>
    <message>
        <source>Not in the file yet: Save to file writes it; it takes effect when the scene is opened again</source>
        <translation>Noch nicht in der Datei: „In Datei speichern“ schreibt es; es gilt, wenn die Szene wieder geöffnet wird</translation>
    </message>
    <message>
        <source>Double click to move the object</source>
        <translation>Doppelklick, um das Objekt zu versetzen</translation>
    </message>
    <message>
        <source>Double click to change it in %1</source>
        <translation>Doppelklick, um es in %1 zu ändern</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>color: red, green, blue, 0 to 1</source>
        <translation>Farbe: Rot, Grün, Blau, 0 bis 1</translation>
    </message>
    <message>
        <source>fraction of lost readings</source>
        <translation>Anteil verlorener Messwerte</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>untere Grenze</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>obere Grenze</translation>
    </message>
    <message>
        <source>solid %1</source>
        <translation>Körper %1</translation>
    </message>
    <message>
        <source>visible %1</source>
        <translation>sichtbar %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>It moves with the object it belongs to</source>
        <translation>Es wird mit dem bewegt, wozu es gehört</translation>
    </message>
    <message>
        <source>%1 (cannot be changed here: no single number in the scene&apos;s files sets it)</source>
        <translation>%1 (hier nicht zu ändern: Keine einzelne Zahl in den Dateien der Szene sagt es)</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>axis in the link</source>
        <translation>Achse im Glied</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>Elevation</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>opening angle</source>
        <translation>Öffnungswinkel</translation>
    </message>
    <message>
        <source>maximum of each value</source>
        <translation>Maximum jedes Werts</translation>
    </message>
    <message>
        <source>minimum of each value</source>
        <translation>Minimum jedes Werts</translation>
    </message>
    <message>
        <source>team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>rotational damping</source>
        <translation>Dämpfung der Drehung</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>inertia: ixx, iyy, izz, ixy, ixz, iyz</source>
        <translation>Trägheit: ixx, iyy, izz, ixy, ixz, iyz</translation>
    </message>
    <message>
        <source>linear damping</source>
        <translation>Dämpfung der Bewegung</translation>
    </message>
    <message>
        <source>color of the palette</source>
        <translation>Farbe der Palette</translation>
    </message>
    <message>
        <source>width, height</source>
        <translation>Breite, Höhe</translation>
    </message>
</context>
<context>
    <name>widgets::PropertiesView</name>
    <message>
        <source>Save to file</source>
        <translation>In Datei speichern</translation>
    </message>
    <message>
        <source>Writes only the changed properties into the files of the scene</source>
        <translation>Schreibt, was geändert wurde, und sonst nichts, in die Dateien der Szene</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Discards unsaved changes</source>
        <translation>Vergisst, was geändert und nicht gespeichert wurde</translation>
    </message>
    <message>
        <source>Keep pose</source>
        <translation>Pose behalten</translation>
    </message>
    <message>
        <source>Makes the model&apos;s present pose its initial one, saved with the other changes</source>
        <translation>Speichert mit den anderen Änderungen, dass das Modell dort beginnt, wo es jetzt ist</translation>
    </message>
    <message>
        <source>Selected object</source>
        <translation>Ausgewähltes Objekt</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Result of the changes</source>
        <translation>Was aus den Änderungen wurde</translation>
    </message>
    <message>
        <source>Nothing is selected: click an object in the view Scene tree, or a robot in Scene.</source>
        <translation>Nichts ist ausgewählt: In der Ansicht Szenenbaum ein Objekt oder in Szene einen Roboter anklicken.</translation>
    </message>
    <message>
        <source>No objects: start a simulation (File &gt; Open scene…).</source>
        <translation>Keine Objekte: Eine Simulation starten (Datei &gt; Szene öffnen…).</translation>
    </message>
    <message>
        <source>It cannot be placed there: %1</source>
        <translation>Dort kann es nicht stehen: %1</translation>
    </message>
    <message>
        <source>The scene&apos;s file does not set the initial pose of %1.</source>
        <translation>Die Datei der Szene sagt nicht, wo %1 beginnt.</translation>
    </message>
    <message>
        <source>Saved. It takes effect when the scene is opened again.</source>
        <translation>Gespeichert. Es gilt, wenn die Szene wieder geöffnet wird.</translation>
    </message>
    <message>
        <source>Undone.</source>
        <translation>Rückgängig gemacht.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>This is now its initial pose; save to keep that.</source>
        <translation>Es beginnt von jetzt an hier; speichern Sie, damit das so bleibt.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>The simulation uses it now; save to keep it.</source>
        <translation>Die Simulation läuft damit weiter; speichern Sie, damit es so bleibt.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes: %1</source>
        <translation>Macht rückgängig: %1</translation>
    </message>
</context>
<context>
    <name>widgets::PublishPanel</name>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Sends the message once</source>
        <translation>Sendet die Nachricht einmal</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Sends the message repeatedly, with its current fields</source>
        <translation>Sendet die Nachricht immer wieder, wie sie dann ist</translation>
    </message>
    <message>
        <source>Reset the message</source>
        <translation>Nachricht zurücksetzen</translation>
    </message>
    <message>
        <source>Resets all fields to their defaults</source>
        <translation>Zeigt die Nachricht, wie sie anfangs ist</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Nachricht</translation>
    </message>
    <message>
        <source>What is sent</source>
        <translation>Was gesendet wird</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>How often Repeat sends the message</source>
        <translation>Wie oft „Wiederholen“ die Nachricht sendet</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>The fields of the message, as JSON</source>
        <translation>Die Felder der Nachricht, als JSON</translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation>Nicht gesendet: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>%1, %2 accepted</source>
        <translation>%1, %2 angenommen</translation>
    </message>
    <message>
        <source>1 message sent</source>
        <translation>1 Nachricht gesendet</translation>
    </message>
    <message>
        <source>%1 messages sent</source>
        <translation>%1 Nachrichten gesendet</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Replaces every such package that the program sends, until it is released</source>
        <translation>Setzt das Paket an die Stelle aller, die das Programm anbietet, bis es freigegeben wird</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Releases the held package, so that the program provides it again</source>
        <translation>Lässt das Programm das gehaltene Paket wieder selbst anbieten</translation>
    </message>
    <message>
        <source>Packages that are held</source>
        <translation>Gehaltene Pakete</translation>
    </message>
    <message>
        <source>Held at %1: %2</source>
        <translation>Gehalten bei %1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::RadarCanvas</name>
    <message>
        <source>Radar</source>
        <translation>Radar</translation>
    </message>
    <message>
        <source>The robot&apos;s surroundings. Blue: sonars, older ones paler; orange: laser; red: pressed bumpers and stalled wheels; green: where it drives in the next second. Wheel: zoom</source>
        <translation>Was um den Roboter herum ist. Blau: Sonare, je älter, desto blasser; orange: Laser; rot: gedrückte Stoßfänger und blockierte Räder; grün: wohin er in der nächsten Sekunde fährt. Mausrad: zoomen</translation>
    </message>
</context>
<context>
    <name>widgets::RadarView</name>
    <message>
        <source>Align with map</source>
        <translation>An Karte ausrichten</translation>
    </message>
    <message>
        <source>Up is the map&apos;s y-axis; otherwise the robot&apos;s heading</source>
        <translation>Oben ist die y-Achse der Karte; sonst die Richtung des Roboters</translation>
    </message>
    <message>
        <source>Time that is shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>Whether the data is old</source>
        <translation>Ob die Daten alt sind</translation>
    </message>
    <message>
        <source>The nearest obstacles, from sonar and laser</source>
        <translation>Die nächsten Dinge, nach Sonar und Laser</translation>
    </message>
    <message>
        <source>Place under the cursor, seen from the robot</source>
        <translation>Ort unter dem Mauszeiger, vom Roboter aus gesehen</translation>
    </message>
    <message>
        <source>Range shown</source>
        <translation>Wie weit gezeigt wird</translation>
    </message>
    <message>
        <source>%1 m at %2°</source>
        <translation>%1 m bei %2°</translation>
    </message>
    <message>
        <source>%1 has neither sonars nor a laser. Choose a robot on wheels.</source>
        <translation>%1 hat weder Sonare noch einen Laser. Einen Roboter auf Rädern wählen.</translation>
    </message>
    <message>
        <source>Nothing received yet from %1’s sonars and laser. Start the simulation, or switch the robot’s sonars on.</source>
        <translation>Noch nichts von den Sonaren und dem Laser von %1 empfangen. Die Simulation starten oder die Sonare des Roboters einschalten.</translation>
    </message>
    <message>
        <source>sonar %1 m</source>
        <translation>Sonar %1 m</translation>
    </message>
    <message>
        <source>laser %1 m</source>
        <translation>Laser %1 m</translation>
    </message>
    <message>
        <source>nearest: %1</source>
        <translation>am nächsten: %1</translation>
    </message>
    <message>
        <source>%1 m around</source>
        <translation>%1 m umher</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>distance, m</source>
        <translation>Entfernung, m</translation>
    </message>
    <message>
        <source>sonar</source>
        <translation>Sonar</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>No robot. Open a map or scene with robots on wheels, or connect to one (menu Robot).</source>
        <translation>Kein Roboter. Eine Karte oder Szene mit Robotern auf Rädern öffnen oder einen verbinden (Menü Roboter).</translation>
    </message>
</context>
<context>
    <name>widgets::RadioPanel</name>
    <message>
        <source>Range</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Range of the radio within a team; 0: unlimited</source>
        <translation>Wie weit entfernt sich Roboter eines Teams hören; 0: beliebig weit</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Delay of a message</source>
        <translation>Wie lange eine Nachricht braucht</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>Share of lost messages</source>
        <translation>Der Anteil der Nachrichten, die nicht ankommen</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
</context>
<context>
    <name>widgets::ReplayPackageModel</name>
    <message>
        <source>Package</source>
        <translation>Paket</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>Verglichen</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>Abweichend</translation>
    </message>
    <message>
        <source>First [s]</source>
        <translation>Erstes [s]</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>the log does not hold it</source>
        <translation>das Log enthält es nicht</translation>
    </message>
    <message>
        <source>no task of the program produces it</source>
        <translation>keine Aufgabe des Programms liefert es</translation>
    </message>
    <message>
        <source>as logged</source>
        <translation>wie aufgezeichnet</translation>
    </message>
    <message>
        <source>recomputed</source>
        <translation>neu berechnet</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>nicht verfügbar</translation>
    </message>
    <message>
        <source>%1 (automatic)</source>
        <translation>%1 (automatisch)</translation>
    </message>
    <message>
        <source>%1 + %2 alone</source>
        <translation>%1 + %2 allein</translation>
    </message>
    <message>
        <source>It cannot be recomputed: %1</source>
        <translation>Es kann nicht neu berechnet werden: %1</translation>
    </message>
    <message>
        <source>Double click: choose where it comes from</source>
        <translation>Doppelklick: wählen, woher es kommt</translation>
    </message>
    <message>
        <source>%1 differ, %2 were only logged, %3 are only recomputed, of %4 compared</source>
        <translation>%1 weichen ab, %2 wurden nur aufgezeichnet, %3 werden nur neu berechnet, von %4 verglichenen</translation>
    </message>
    <message>
        <source>Double click: go to the first difference</source>
        <translation>Doppelklick: zum ersten Unterschied gehen</translation>
    </message>
    <message>
        <source>At %1 s. Double click: go there</source>
        <translation>Bei %1 s. Doppelklick: dorthin gehen</translation>
    </message>
</context>
<context>
    <name>widgets::ReplayPackagesView</name>
    <message>
        <source>Search packages</source>
        <translation>Pakete suchen</translation>
    </message>
    <message>
        <source>Shows only packages whose name contains this</source>
        <translation>Zeigt nur Pakete, deren Name dies enthält</translation>
    </message>
    <message>
        <source>Packages of the replay</source>
        <translation>Pakete der Wiedergabe</translation>
    </message>
    <message>
        <source>F2 or a double click chooses where a package comes from</source>
        <translation>F2 oder ein Doppelklick wählt, woher ein Paket kommt</translation>
    </message>
    <message>
        <source>No log is open.
Open one with File &gt; Open log…, or drop log files onto the window.</source>
        <translation>Kein Log ist offen.
Eines mit Datei &gt; Log öffnen… öffnen, oder Logdateien auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>No program runs on this log.</source>
        <translation>Auf diesem Log läuft kein Programm.</translation>
    </message>
    <message>
        <source>Tasks that cannot run on this log:
%1</source>
        <translation>Aufgaben, die auf diesem Log nicht laufen können:
%1</translation>
    </message>
</context>
<context>
    <name>widgets::RobotCardModel</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
</context>
<context>
    <name>widgets::RobotChoice</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Whose drawings are shown</source>
        <translation>Wessen Zeichnungen gezeigt werden</translation>
    </message>
    <message>
        <source>Which robot is shown</source>
        <translation>Welcher Roboter gezeigt wird</translation>
    </message>
    <message>
        <source>Selected robot</source>
        <translation>Gewählter</translation>
    </message>
    <message>
        <source>All robots</source>
        <translation>Alle Roboter</translation>
    </message>
    <message>
        <source>%1 (not here)</source>
        <translation>%1 (nicht hier)</translation>
    </message>
</context>
<context>
    <name>widgets::RobotsView</name>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>no camera image</source>
        <translation>kein Kamerabild</translation>
    </message>
    <message>
        <source>no image at this time</source>
        <translation>kein Bild zu dieser Zeit</translation>
    </message>
    <message>
        <source>the image cannot be shown</source>
        <translation>ein Bild, das nicht gezeigt werden kann</translation>
    </message>
    <message>
        <source>There is no robot.
Start a simulation, connect to a robot, or open a log with File &gt; Open log…</source>
        <translation>Hier ist kein Roboter.
Eine Simulation starten, mit einem Roboter verbinden, oder ein Log öffnen: Datei &gt; Log öffnen…</translation>
    </message>
    <message>
        <source>There is no description of this log&apos;s robot. Its contents are shown in the views Data, Plots, Field and Scene.</source>
        <translation>Dieses Log ist von keinem unserer Roboter. Was es hat, zeigen die Ansichten Daten, Kurven, Feld und Szene.</translation>
    </message>
</context>
<context>
    <name>widgets::SceneBench</name>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Changes cannot be backed up: %1</source>
        <translation>Änderungen können nicht gesichert werden: %1</translation>
    </message>
    <message>
        <source>Unsaved scenes could not be restored: %1; they are kept in %2</source>
        <translation>Nicht gespeicherte Szenen konnten nicht wiederhergestellt werden: %1; sie liegen in %2</translation>
    </message>
    <message>
        <source>The program ended without saving last time. Unsaved scene files were restored in the scene editor; save them to keep them.</source>
        <translation>Das Programm endete letztes Mal ohne zu speichern. Nicht gespeicherte Szenendateien wurden im Szeneneditor wiederhergestellt; speichern Sie sie, um sie zu behalten.</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and has unsaved changes here: saving asks which version to keep</source>
        <translation>%1 wurde von einem anderen Programm geändert und hat hier nicht gespeicherte Änderungen: Beim Speichern wird gefragt, welche davon bleiben sollen</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and was reloaded</source>
        <translation>%1 wurde von einem anderen Programm geändert und neu gelesen</translation>
    </message>
</context>
<context>
    <name>widgets::SceneCanvas</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>The scene cannot be drawn: %1</source>
        <translation>Die Szene kann nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>x: %1 m  y: %2 m</source>
        <translation>x: %1 m  y: %2 m</translation>
    </message>
    <message>
        <source>Drag: turn; right or middle button, or Shift: move; wheel: zoom; click an object: select it; double click: select the ground or a room, too; Esc: select nothing; drag a robot or the ball (Control: always): place it, wheel: turn it; R: reset</source>
        <translation>Ziehen: drehen; rechte oder mittlere Taste oder Umschalt: verschieben; Mausrad: zoomen; Objekt anklicken: auswählen; Doppelklick: auch den Boden oder einen Raum auswählen; Esc: nichts auswählen; Roboter oder Ball ziehen (Strg: immer): platzieren, Mausrad: drehen; R: zurücksetzen</translation>
    </message>
</context>
<context>
    <name>widgets::SceneCompletion</name>
    <message>
        <source>default %1</source>
        <translation>Vorgabe %1</translation>
    </message>
    <message>
        <source>required</source>
        <translation>erforderlich</translation>
    </message>
</context>
<context>
    <name>widgets::SceneDialogs</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>Änderungen speichern?</translation>
    </message>
    <message>
        <source>Open scene file</source>
        <translation>Szenendatei öffnen</translation>
    </message>
    <message>
        <source>Scenes and models (*.sdf *.world *.xml *.map);;All files (*)</source>
        <translation>Szenen und Modelle (*.sdf *.world *.xml *.map);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save scene file</source>
        <translation>Szenendatei speichern</translation>
    </message>
    <message>
        <source>The scene file %1 was changed and not saved.</source>
        <translation>Die Szenendatei %1 wurde geändert und nicht gespeichert.</translation>
    </message>
    <message>
        <source>Scene files were changed and not saved: %1</source>
        <translation>Szenendateien wurden geändert und nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>The file %1 was changed by another program since it was read here.</source>
        <translation>Die Datei %1 wurde von einem anderen Programm geändert, seit sie hier gelesen wurde.</translation>
    </message>
    <message>
        <source>Overwrite it with the text of the editor, or reload it? Undo restores the text of the editor.</source>
        <translation>Soll sie mit dem Text des Editors überschrieben oder neu gelesen werden? Rückgängig bringt den Text des Editors zurück.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
</context>
<context>
    <name>widgets::SceneEditorView</name>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>Starts a room with walls, light, and a robot</source>
        <translation>Beginnt einen Raum mit Wänden, Licht und einem Roboter</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Opens a scene, a model or a map</source>
        <translation>Öffnet eine Szene, ein Modell oder eine Karte</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saves the file</source>
        <translation>Speichert die Datei</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Saves the text to another file</source>
        <translation>Speichert den Text in eine andere Datei</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last edit</source>
        <translation>Macht die letzte Änderung rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redoes the edit</source>
        <translation>Stellt die Änderung wieder her</translation>
    </message>
    <message>
        <source>Find and replace</source>
        <translation>Suchen und ersetzen</translation>
    </message>
    <message>
        <source>Finds and replaces text in the file</source>
        <translation>Sucht und ersetzt Text in der Datei</translation>
    </message>
    <message>
        <source>Indent all</source>
        <translation>Alles einrücken</translation>
    </message>
    <message>
        <source>Indents all lines by their nesting</source>
        <translation>Rückt alle Zeilen danach ein, worin sie stehen</translation>
    </message>
    <message>
        <source>What can be written here</source>
        <translation>Was hier stehen kann</translation>
    </message>
    <message>
        <source>Lists elements or attributes for the cursor: Ctrl+Space</source>
        <translation>Listet Elemente oder Attribute für die Schreibmarke auf: Strg+Leertaste</translation>
    </message>
    <message>
        <source>Save and run</source>
        <translation>Speichern und ausführen</translation>
    </message>
    <message>
        <source>Saves the file; the running simulation continues with it, or the scene is opened</source>
        <translation>Speichert die Datei; die Simulation läuft mit ihr weiter, wo sie ist, oder öffnet sie</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>Go to the selected object</source>
        <translation>Zum gewählten Objekt gehen</translation>
    </message>
    <message>
        <source>Goes to the text of the object that is selected in the scene</source>
        <translation>Geht zum Text des Objekts, das in der Szene gewählt ist</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Select in the scene</source>
        <translation>In der Szene wählen</translation>
    </message>
    <message>
        <source>Selects the object around the cursor in the views of the scene</source>
        <translation>Wählt das Objekt um die Schreibmarke in den Ansichten der Szene</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Open the included model</source>
        <translation>Das eingebundene Modell öffnen</translation>
    </message>
    <message>
        <source>Opens the file of the &lt;include&gt; at the cursor</source>
        <translation>Öffnet die Datei des &lt;include&gt; um die Schreibmarke</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>Einbinden</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Adds a model to the scene</source>
        <translation>Fügt der Szene ein Modell hinzu</translation>
    </message>
    <message>
        <source>Save as, discard changes, indent, included models</source>
        <translation>Speichern unter, Änderungen verwerfen, einrücken, eingebundene Modelle</translation>
    </message>
    <message>
        <source>The object around the cursor</source>
        <translation>Das Objekt um die Schreibmarke</translation>
    </message>
    <message>
        <source>Problems of the file</source>
        <translation>Probleme der Datei</translation>
    </message>
    <message>
        <source>Number of problems</source>
        <translation>Anzahl der Probleme</translation>
    </message>
    <message>
        <source>Open scene files</source>
        <translation>Offene Szenendateien</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Errors: %1, warnings: %2</source>
        <translation>Fehler: %1, Warnungen: %2</translation>
    </message>
    <message>
        <source>Nothing is selected in the scene; goes to the scene&apos;s file</source>
        <translation>In der Szene ist nichts gewählt; geht zur Datei der Szene</translation>
    </message>
    <message>
        <source>Goes to the text of %1</source>
        <translation>Geht zum Text von %1</translation>
    </message>
    <message>
        <source>No scene file. Open one, start one with New, or go to the scene that is simulated.</source>
        <translation>Keine Szenendatei. Öffnen Sie eine, beginnen Sie eine mit Neu, oder gehen Sie zur simulierten Szene.</translation>
    </message>
    <message>
        <source>Scene editor: %1</source>
        <translation>Szeneneditor: %1</translation>
    </message>
    <message>
        <source>Scene editor</source>
        <translation>Szeneneditor</translation>
    </message>
    <message>
        <source>%1 (robot)</source>
        <translation>%1 (Roboter)</translation>
    </message>
    <message>
        <source>There are no models</source>
        <translation>Es gibt keine Modelle</translation>
    </message>
    <message>
        <source>A model can only be included in a world or a model</source>
        <translation>Ein Modell kann nur in eine Welt oder ein Modell eingebunden werden</translation>
    </message>
    <message>
        <source>There is no object around the cursor</source>
        <translation>Um die Schreibmarke ist kein Objekt</translation>
    </message>
    <message>
        <source>Goes back to the saved text, also in the simulation; undo restores the changes</source>
        <translation>Geht zu dem zurück, was gespeichert ist, auch in der Simulation; Rückgängig bringt die Änderungen zurück</translation>
    </message>
</context>
<context>
    <name>widgets::SceneEdits</name>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Write the pose of %1</source>
        <translation>Pose von %1 schreiben</translation>
    </message>
    <message>
        <source>Discard changes of %1</source>
        <translation>Änderungen von %1 verwerfen</translation>
    </message>
    <message>
        <source>The simulation continues, but the scene could not be opened from its initial state: %1, or write the present pose into the scene (Ctrl+Shift+W)</source>
        <translation>Die Simulation geht weiter, aber die Szene lässt sich so nicht öffnen: %1, oder schreiben Sie in die Szene, wo es jetzt ist (Strg+Umschalt+W)</translation>
    </message>
    <message>
        <source>So the text keeps the change, and the simulation continues in it; objects in the way return to their places in the file.</source>
        <translation>Darum behält der Text die Änderung, und die Simulation läuft mit ihm weiter; Objekte im Weg kehren an ihre Plätze in der Datei zurück.</translation>
    </message>
</context>
<context>
    <name>widgets::SceneFile</name>
    <message>
        <source>unnamed.sdf</source>
        <translation>unbenannt.sdf</translation>
    </message>
</context>
<context>
    <name>widgets::SceneHands</name>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Shows handles at the selected object that move and turn it; Control: in steps of 0.1 m and 15°, Esc: back</source>
        <translation>Zeigt Griffe am ausgewählten Objekt, die es verschieben und drehen; Strg: in Schritten von 0,1 m und 15°, Esc: zurück</translation>
    </message>
    <message>
        <source>Own axes</source>
        <translation>Eigene Achsen</translation>
    </message>
    <message>
        <source>Aligns the handles with the object instead of the field</source>
        <translation>Die Griffe zeigen dorthin, wohin das Objekt zeigt, statt wohin das Feld zeigt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Add objects…</source>
        <translation>Objekte hinzufügen…</translation>
    </message>
    <message>
        <source>Lists objects and models that can be dragged into the scene</source>
        <translation>Listet Objekte und Modelle auf, die in die Szene gezogen werden können</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Adds another one beside it to the scene&apos;s text</source>
        <translation>Fügt dem Text der Szene ein weiteres daneben hinzu</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Removes the object from the scene&apos;s text</source>
        <translation>Entfernt das Objekt aus dem Text der Szene</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Renames the object in the scene&apos;s text</source>
        <translation>Benennt das Objekt im Text der Szene um</translation>
    </message>
    <message>
        <source>Write to the scene</source>
        <translation>In die Szene schreiben</translation>
    </message>
    <message>
        <source>Makes the object&apos;s present pose its initial one in the scene&apos;s text; save the file to keep it</source>
        <translation>Schreibt in den Text der Szene, dass das Objekt dort beginnt, wo es jetzt ist; die Datei wird gespeichert, wenn Sie sie speichern</translation>
    </message>
    <message>
        <source>Ctrl+Shift+W</source>
        <translation>Ctrl+Shift+W</translation>
    </message>
    <message>
        <source>Pin or release</source>
        <translation>Festhalten oder loslassen</translation>
    </message>
    <message>
        <source>Holds the object where it is, so that nothing can move it, or releases it</source>
        <translation>Hält das Objekt fest, wo es ist, was immer es schiebt, oder lässt es los</translation>
    </message>
    <message>
        <source>Go to its text</source>
        <translation>Zu seinem Text</translation>
    </message>
    <message>
        <source>Shows the object in the scene editor</source>
        <translation>Zeigt das Objekt im Szenen-Editor</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Shows the properties of the object</source>
        <translation>Zeigt die Eigenschaften des Objekts</translation>
    </message>
    <message>
        <source>Alt+Return</source>
        <translation>Alt+Return</translation>
    </message>
    <message>
        <source>Only what moves can be pinned</source>
        <translation>Nur was sich bewegt, kann festgehalten werden</translation>
    </message>
    <message>
        <source>Release %1</source>
        <translation>%1 loslassen</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>%1 festhalten</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>Neuer Name von %1:</translation>
    </message>
    <message>
        <source>%1 now starts here; save the scene to keep that</source>
        <translation>%1 beginnt hier; speichern Sie die Szene, damit das so bleibt</translation>
    </message>
    <message>
        <source>Follow %1</source>
        <translation>%1 folgen</translation>
    </message>
    <message>
        <source>Add here</source>
        <translation>Hier hinzufügen</translation>
    </message>
    <message>
        <source>Undoes: %1</source>
        <translation>Macht rückgängig: %1</translation>
    </message>
    <message>
        <source>There is no change of the scene to undo</source>
        <translation>An der Szene wurde nichts getan, das rückgängig gemacht werden könnte</translation>
    </message>
    <message>
        <source>Does again: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>There is no change of the scene to redo</source>
        <translation>Nichts wurde rückgängig gemacht, das wiederholt werden könnte</translation>
    </message>
    <message>
        <source>This cannot be done: %1</source>
        <translation>Das geht nicht: %1</translation>
    </message>
    <message>
        <source>The changed scene is being checked…</source>
        <translation>Die geänderte Szene wird geprüft…</translation>
    </message>
</context>
<context>
    <name>widgets::SceneModes</name>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Draws surfaces with soft light</source>
        <translation>Zeichnet Flächen mit weichem Licht</translation>
    </message>
    <message>
        <source>Shift+W</source>
        <translation>Shift+W</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Draws each triangle in one color</source>
        <translation>Zeichnet jedes Dreieck in einer Farbe</translation>
    </message>
    <message>
        <source>Alt+W</source>
        <translation>Alt+W</translation>
    </message>
    <message>
        <source>Edges, hidden ones left out</source>
        <translation>Kanten ohne verdeckte</translation>
    </message>
    <message>
        <source>Draws the edges that no surface hides</source>
        <translation>Zeichnet die Kanten, die keine Fläche verdeckt</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Wire frame</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Draws all edges, also the hidden ones</source>
        <translation>Zeichnet alle Kanten, auch die verdeckten</translation>
    </message>
    <message>
        <source>Visible shapes</source>
        <translation>Sichtbare Formen</translation>
    </message>
    <message>
        <source>Shows what cameras see</source>
        <translation>Zeigt, was Kameras sehen</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Shows what collides: as edges over the visible shapes, or in place of these</source>
        <translation>Zeigt, was zusammenstößt: als Kanten über den sichtbaren Formen oder an deren Stelle</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>Contacts and forces</source>
        <translation>Berührungen und Kräfte</translation>
    </message>
    <message>
        <source>Shows where objects touch, and forces as arrows of 1 cm for 1 N: of contacts orange, of joints blue, by hand green</source>
        <translation>Zeigt, wo Objekte sich berühren, und Kräfte als Pfeile von 1 cm je 1 N: von Berührungen orange, von Gelenken blau, von Hand grün</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Shows the axes of joints, and the names of those of the selected object</source>
        <translation>Zeigt die Achsen der Gelenke und die Namen derer des gewählten Objekts</translation>
    </message>
    <message>
        <source>Shift+J</source>
        <translation>Shift+J</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message>
        <source>Shows the axes of models and links: x red, y green, z blue</source>
        <translation>Zeigt die Achsen von Modellen und Gliedern: x rot, y grün, z blau</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Centers of mass</source>
        <translation>Schwerpunkte</translation>
    </message>
    <message>
        <source>Shows the center of mass of each link, larger if heavier</source>
        <translation>Zeigt den Schwerpunkt jedes Glieds, je schwerer, desto größer</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Shows what simulated cameras see, sonars reach, and rays hit</source>
        <translation>Zeigt, was simulierte Kameras sehen, wie weit Sonare reichen und was Strahlen treffen</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Names of objects</source>
        <translation>Namen der Objekte</translation>
    </message>
    <message>
        <source>Shows the names of all models, not only of robots</source>
        <translation>Zeigt die Namen aller Modelle, nicht nur der Roboter</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Shows shadows on the ground</source>
        <translation>Zeigt Schatten auf dem Boden</translation>
    </message>
</context>
<context>
    <name>widgets::ScenePalette</name>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>%1 (robot)</source>
        <translation>%1 (Roboter)</translation>
    </message>
    <message>
        <source>Add objects</source>
        <translation>Objekte hinzufügen</translation>
    </message>
    <message>
        <source>Drag an object to its place in the scene, or double click it</source>
        <translation>Ein Objekt an seinen Platz in der Szene ziehen oder doppelt anklicken</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
</context>
<context>
    <name>widgets::SceneProblemModel</name>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fehler: %1</translation>
    </message>
</context>
<context>
    <name>widgets::SceneTextEdit</name>
    <message>
        <source>Text of the scene</source>
        <translation>Text der Szene</translation>
    </message>
</context>
<context>
    <name>widgets::SceneTreeModel</name>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>Aktor</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>1 value</source>
        <translation>1 Wert</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>%1, held</source>
        <translation>%1, gehalten</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>Controller</translation>
    </message>
</context>
<context>
    <name>widgets::SceneTreeView</name>
    <message>
        <source>Plot</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Column graph</source>
        <translation>Säulendiagramm</translation>
    </message>
    <message>
        <source>Shows the values of the sensor as columns</source>
        <translation>Zeigt die Werte des Sensors als Säulen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Shows the images of the camera</source>
        <translation>Zeigt die Bilder der Kamera</translation>
    </message>
    <message>
        <source>Ctrl+Alt+I</source>
        <translation>Ctrl+Alt+I</translation>
    </message>
    <message>
        <source>Monochrome image</source>
        <translation>Schwarzweißbild</translation>
    </message>
    <message>
        <source>Shows the images of the camera in gray</source>
        <translation>Zeigt die Bilder der Kamera in Grau</translation>
    </message>
    <message>
        <source>Stereogram</source>
        <translation>Stereogramm</translation>
    </message>
    <message>
        <source>Shows depths as a random-dot stereogram: focus behind it to see them</source>
        <translation>Zeigt Tiefen als Zufallspunkt-Stereogramm, das man sieht, indem man hindurchsieht</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Shows the properties of the object</source>
        <translation>Zeigt die Eigenschaften des Objekts</translation>
    </message>
    <message>
        <source>Alt+Return</source>
        <translation>Alt+Return</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Copies the path of the object</source>
        <translation>Kopiert den Pfad des Objekts</translation>
    </message>
    <message>
        <source>Search objects</source>
        <translation>Objekte suchen</translation>
    </message>
    <message>
        <source>Shows only objects whose path, kind or type contains this</source>
        <translation>Zeigt nur Objekte, deren Pfad, Art oder Typ dies enthält</translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation>Objekte der Szene</translation>
    </message>
    <message>
        <source>What went wrong</source>
        <translation>Was misslang</translation>
    </message>
    <message>
        <source>No objects: start a simulation (File &gt; Open scene…). Real robots and logs have none.</source>
        <translation>Keine Objekte: Eine Simulation starten (Datei &gt; Szene öffnen…). Echte Roboter und Logs haben keine.</translation>
    </message>
    <message>
        <source>Nothing matches. Clear the search.</source>
        <translation>Nichts passt. Die Suche leeren.</translation>
    </message>
    <message>
        <source>Show in 3-D</source>
        <translation>In 3-D zeigen</translation>
    </message>
    <message>
        <source>Opens a view that shows only this object and everything in it</source>
        <translation>Öffnet eine Ansicht, die nur dieses Objekt zeigt, mit allem, was dazu gehört</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>Show in 3-D with surroundings</source>
        <translation>In 3-D mit Umgebung zeigen</translation>
    </message>
    <message>
        <source>Opens a view of the scene that looks at this object and follows it</source>
        <translation>Öffnet eine Ansicht der Szene, die auf dieses Objekt blickt und es verfolgt</translation>
    </message>
    <message>
        <source>Hide in 3-D</source>
        <translation>In 3-D ausblenden</translation>
    </message>
    <message>
        <source>Hides the object and everything in it in views of the scene</source>
        <translation>Lässt das Objekt mit allem, was dazu gehört, in Ansichten der Szene weg</translation>
    </message>
    <message>
        <source>Ctrl+Alt+H</source>
        <translation>Ctrl+Alt+H</translation>
    </message>
    <message>
        <source>Show again in 3-D</source>
        <translation>In 3-D wieder zeigen</translation>
    </message>
    <message>
        <source>Shows the object again in views of the scene</source>
        <translation>Zeigt das Objekt in Ansichten der Szene wieder</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+H</source>
        <translation>Ctrl+Alt+Shift+H</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Verfolgen</translation>
    </message>
    <message>
        <source>The camera of the scene moves with the object</source>
        <translation>Die Kamera der Szene bewegt sich mit dem Objekt</translation>
    </message>
    <message>
        <source>Follow and turn with it</source>
        <translation>Verfolgen und mitdrehen</translation>
    </message>
    <message>
        <source>The camera of the scene moves and turns with the object</source>
        <translation>Die Kamera der Szene bewegt und dreht sich mit dem Objekt</translation>
    </message>
    <message>
        <source>First person</source>
        <translation>Ego-Perspektive</translation>
    </message>
    <message>
        <source>Shows the scene from the object&apos;s camera, or from the object itself</source>
        <translation>Die Szene wird aus der Kamera des Objekts gesehen oder aus dem Objekt selbst</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>As the view</source>
        <translation>Wie die Ansicht</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Edges, hidden ones left out</source>
        <translation>Kanten ohne verdeckte</translation>
    </message>
    <message>
        <source>Wire frame</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Seen through</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Not at all</source>
        <translation>Gar nicht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Adds the values of the sensor to the view Plots, the first twelve of many</source>
        <translation>Fügt die Werte des Sensors der Ansicht Kurven hinzu, von vielen die ersten zwölf</translation>
    </message>
    <message>
        <source>Go to its text</source>
        <translation>Zu seinem Text</translation>
    </message>
    <message>
        <source>Shows the object in the scene editor</source>
        <translation>Zeigt das Objekt im Szenen-Editor</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Adds another one beside it to the scene&apos;s text</source>
        <translation>Fügt dem Text der Szene ein weiteres daneben hinzu</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Removes the object from the scene&apos;s text</source>
        <translation>Entfernt das Objekt aus dem Text der Szene</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Renames the object in the scene&apos;s text</source>
        <translation>Benennt das Objekt im Text der Szene um</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>New name of %1:</source>
        <translation>Neuer Name von %1:</translation>
    </message>
</context>
<context>
    <name>widgets::SceneView</name>
    <message>
        <source>Wire frame</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Shows lines every half meter around the field</source>
        <translation>Zeigt Linien alle halbe Meter neben dem Feld</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Shows the names of robots and the texts of drawings</source>
        <translation>Zeigt die Namen von Robotern und die Texte von Zeichnungen</translation>
    </message>
    <message>
        <source>Move robots and ball</source>
        <translation>Roboter und Ball bewegen</translation>
    </message>
    <message>
        <source>Dragging a robot or the ball places it; otherwise only with Control. The wheel turns what is dragged</source>
        <translation>Ziehen eines Roboters oder des Balls platziert ihn; sonst nur mit Strg. Das Mausrad dreht, was gezogen wird</translation>
    </message>
    <message>
        <source>Reset camera</source>
        <translation>Kamera zurücksetzen</translation>
    </message>
    <message>
        <source>Shows the whole field or building from the side</source>
        <translation>Zeigt das ganze Feld oder Gebäude von der Seite</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Over the shoulder</source>
        <translation>Über die Schulter</translation>
    </message>
    <message>
        <source>Looks over the robot&apos;s shoulder and follows it</source>
        <translation>Blickt dem Roboter über die Schulter und folgt ihm</translation>
    </message>
    <message>
        <source>Follow the robot</source>
        <translation>Dem Roboter folgen</translation>
    </message>
    <message>
        <source>Moves the camera with the robot</source>
        <translation>Bewegt die Kamera mit dem Roboter</translation>
    </message>
    <message>
        <source>Whose drawings are shown, and which robot the camera follows</source>
        <translation>Wessen Zeichnungen gezeigt werden und welchem Roboter die Kamera folgt</translation>
    </message>
    <message>
        <source>Whether drawings of earlier frames are shown</source>
        <translation>Ob Zeichnungen früherer Frames gezeigt werden</translation>
    </message>
    <message>
        <source>It cannot be placed here: %1</source>
        <translation>Es kann hier nicht platziert werden: %1</translation>
    </message>
    <message>
        <source>This log holds no scene; the field view shows the estimated poses of its robots.</source>
        <translation>Dieses Log enthält keine Szene; die Feldansicht zeigt die geschätzten Posen seiner Roboter.</translation>
    </message>
    <message>
        <source>No scene yet: start a simulation, or open a log.</source>
        <translation>Noch keine Szene: eine Simulation starten oder ein Log öffnen.</translation>
    </message>
    <message>
        <source>faded: drawn in earlier frames</source>
        <translation>verblasst: in früheren Frames gezeichnet</translation>
    </message>
    <message>
        <source>Cameras and ranges</source>
        <translation>Kameras und Abstände</translation>
    </message>
    <message>
        <source>Shows the fields of view of cameras and range sensors, for robots without a scene</source>
        <translation>Zeigt, was Kameras sehen und Abstandssensoren messen, bei Robotern, die keine Szene zeigt</translation>
    </message>
    <message>
        <source>Keys and clicks for controllers</source>
        <translation>Tasten und Klicks für Controller</translation>
    </message>
    <message>
        <source>Keys and the left button are sent to the controllers of the simulated scene, such as that of a lift; the right and the middle button still move the camera</source>
        <translation>Tasten und die linke Maustaste gehen an die Controller der simulierten Szene, etwa den eines Aufzugs; die rechte und die mittlere Taste bewegen weiterhin die Kamera</translation>
    </message>
    <message>
        <source>First person</source>
        <translation>Ego-Perspektive</translation>
    </message>
    <message>
        <source>Looks from the camera of the followed object, or from the object itself</source>
        <translation>Blickt aus der Kamera des Verfolgten oder aus dem Objekt selbst</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>How surfaces are drawn</source>
        <translation>Wie Flächen gezeichnet werden</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>What is shown: shapes, solids, forces, joints, sensors, ...</source>
        <translation>Was gezeigt wird: Formen, Körper, Kräfte, Gelenke, Sensoren, ...</translation>
    </message>
    <message>
        <source>Show the whole scene</source>
        <translation>Die ganze Szene zeigen</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Scene: %1</source>
        <translation>Szene: %1</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show alone</source>
        <translation>Allein zeigen</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Verfolgen</translation>
    </message>
    <message>
        <source>Follow and turn with it</source>
        <translation>Verfolgen und mitdrehen</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>As the view</source>
        <translation>Wie die Ansicht</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Edges, hidden ones left out</source>
        <translation>Kanten ohne verdeckte</translation>
    </message>
    <message>
        <source>Seen through</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Not at all</source>
        <translation>Gar nicht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Show the hidden part again</source>
        <translation>Ausgeblendetes Teil wieder zeigen</translation>
    </message>
    <message>
        <source>Show %1 hidden parts again</source>
        <translation>%1 ausgeblendete Teile wieder zeigen</translation>
    </message>
    <message>
        <source>faded</source>
        <translation>blass</translation>
    </message>
    <message>
        <source>From above: looks down on the scene</source>
        <translation>Von oben: blickt auf die Szene herab</translation>
    </message>
    <message>
        <source>%1 has no shape to be shown.</source>
        <translation>%1 hat keine Form, die gezeigt werden könnte.</translation>
    </message>
    <message>
        <source>There is no &apos;%1&apos; in this scene.</source>
        <translation>In dieser Szene gibt es kein „%1“.</translation>
    </message>
</context>
<context>
    <name>widgets::SearchModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Dauert</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>to the end</source>
        <translation>bis zum Ende</translation>
    </message>
</context>
<context>
    <name>widgets::SearchView</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Searches all open logs completely (Enter)</source>
        <translation>Durchsucht die offenen Logs vollständig (Eingabetaste)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Previous hit</source>
        <translation>Voriger Fund</translation>
    </message>
    <message>
        <source>Jumps to the hit before the shown time</source>
        <translation>Springt zum Fund vor der gezeigten Zeit</translation>
    </message>
    <message>
        <source>Next hit</source>
        <translation>Nächster Fund</translation>
    </message>
    <message>
        <source>Jumps to the next hit</source>
        <translation>Springt zum nächsten Fund</translation>
    </message>
    <message>
        <source>What is searched for</source>
        <translation>Wonach gesucht wird</translation>
    </message>
    <message>
        <source>A condition on values, or a part of messages</source>
        <translation>Eine Bedingung für Werte, oder ein Teil von Meldungen</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Search logs</source>
        <translation>Logs durchsuchen</translation>
    </message>
    <message>
        <source>A condition, such as models/ball.position.x &gt; 1, or, for texts, a regular expression; Enter searches</source>
        <translation>Eine Bedingung wie models/ball.position.x &gt; 1 oder, bei Texten, ein regulärer Ausdruck; die Eingabetaste sucht</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Funde</translation>
    </message>
    <message>
        <source>State of the search</source>
        <translation>Zustand der Suche</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>Canceled; hits so far: %1</source>
        <translation>Abgebrochen; Funde bisher: %1</translation>
    </message>
    <message>
        <source>1 hit</source>
        <translation>1 Fund</translation>
    </message>
    <message>
        <source>%1 hits</source>
        <translation>%1 Funde</translation>
    </message>
    <message>
        <source>Searching: %1 %, %2</source>
        <translation>Suche läuft: %1 %, %2</translation>
    </message>
    <message>
        <source>At character %1: %2</source>
        <translation>Bei Zeichen %1: %2</translation>
    </message>
    <message>
        <source>%1; there are more, which are not shown</source>
        <translation>%1; es gibt mehr, die nicht gezeigt werden</translation>
    </message>
    <message>
        <source>Type a condition, such as models/ball.position.x &gt; 1, or choose Texts, and press Enter.</source>
        <translation>Eine Bedingung eingeben, etwa models/ball.position.x &gt; 1, oder Texte wählen, und die Eingabetaste drücken.</translation>
    </message>
    <message>
        <source>Computing: %1 %, %2</source>
        <translation>Wird berechnet: %1 %, %2</translation>
    </message>
    <message>
        <source>Computed by the program: %1</source>
        <translation>Vom Programm berechnet: %1</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>There is nothing to search.
Open a log with File &gt; Open log…, or drop log files onto the window; or start a simulation, or connect to a robot.</source>
        <translation>Es gibt nichts zu durchsuchen.
Ein Log mit Datei &gt; Log öffnen… öffnen, oder Logdateien auf das Fenster ziehen; oder eine Simulation starten, oder einen Roboter verbinden.</translation>
    </message>
    <message>
        <source>Stops the search; its results are kept</source>
        <translation>Beendet die Suche; ihre Ergebnisse bleiben</translation>
    </message>
</context>
<context>
    <name>widgets::SettingsPanel</name>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Resets all settings to the values they had when the camera was opened</source>
        <translation>Setzt alle auf die Werte, mit denen die Kamera begonnen hat</translation>
    </message>
    <message>
        <source>Why there are no settings</source>
        <translation>Warum es keine Einstellungen gibt</translation>
    </message>
    <message>
        <source>This camera has no settings that can be changed while it takes images.</source>
        <translation>Diese Kamera hat keine Einstellungen, die geändert werden können, während sie Bilder aufnimmt.</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>%1 to %2; initially %3</source>
        <translation>%1 bis %2; die Kamera hat mit %3 begonnen</translation>
    </message>
</context>
<context>
    <name>widgets::SolutionModel</name>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>switching…</source>
        <translation>schaltet um…</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1 → %2…</source>
        <translation>%1 → %2…</translation>
    </message>
    <message>
        <source>Task and solutions</source>
        <translation>Aufgabe und Lösungen</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>liest %1</translation>
    </message>
    <message>
        <source>reads if offered %1</source>
        <translation>liest, falls angeboten, %1</translation>
    </message>
    <message>
        <source>publishes %1</source>
        <translation>veröffentlicht %1</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Runs %1 in the shadow of the active solution, on the same inputs and without being used. What it publishes is under shadow/%1; its computing time is in the next column.</source>
        <translation>Führt %1 neben der aktiven Lösung aus, mit denselben Eingaben und ohne dass es benutzt wird. Was es veröffentlicht, ist unter shadow/%1; was es kostet, steht in der nächsten Spalte.</translation>
    </message>
    <message>
        <source>Mean time of a frame and share of the process&apos;s period, in the last two seconds, while the robot measures its tasks (Measure in the view Timing)</source>
        <translation>Mittlere Zeit je Frame und Anteil an der Periode des Prozesses in den letzten zwei Sekunden, während der Roboter seine Aufgaben misst (Messen in der Ansicht Zeiten)</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
</context>
<context>
    <name>widgets::SolutionsView</name>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Switches every task to the solution that its layout names</source>
        <translation>Schaltet jede Aufgabe auf die Lösung um, die ihr Layout nennt</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Shows the parameters of the current solution</source>
        <translation>Zeigt die Parameter der jetzigen Lösung</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>Tasks and their solutions</source>
        <translation>Aufgaben und ihre Lösungen</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Eine Simulation starten oder mit einem Roboter verbinden und ihn in der Werkzeugleiste wählen.</translation>
    </message>
    <message>
        <source>Last answer</source>
        <translation>Letzte Antwort</translation>
    </message>
    <message>
        <source>The robot has not reported its tasks yet. Start its program.</source>
        <translation>Der Roboter hat seine Aufgaben noch nicht gemeldet. Sein Programm starten.</translation>
    </message>
    <message>
        <source>%1 cannot be chosen: %2</source>
        <translation>%1 kann nicht gewählt werden: %2</translation>
    </message>
    <message>
        <source>%1 was accepted</source>
        <translation>%1 wurde angenommen</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 wurde abgelehnt: %2</translation>
    </message>
    <message>
        <source>In all robots</source>
        <translation>Bei allen Robotern</translation>
    </message>
    <message>
        <source>Switches the task to this solution in all robots</source>
        <translation>Schaltet die Aufgabe bei allen Robotern auf diese Lösung</translation>
    </message>
    <message>
        <source>%1 has no solutions: its server is not a RobotControl program.</source>
        <translation>%1 hat keine Lösungen: Sein Server ist keiner von RobotControl.</translation>
    </message>
    <message>
        <source>%1 runs in the shadow</source>
        <translation>%1 läuft im Schatten</translation>
    </message>
    <message>
        <source>%1 no longer runs</source>
        <translation>%1 läuft nicht mehr</translation>
    </message>
    <message>
        <source>In its team</source>
        <translation>Bei seinem Team</translation>
    </message>
    <message>
        <source>Switches the task to this solution in the robot&apos;s team</source>
        <translation>Stellt die Aufgabe im Team des Roboters auf diese Lösung um</translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumCanvas</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window function: flat top is best for amplitudes, none for close frequencies, the others are in between</source>
        <translation>Womit die Werte multipliziert werden: Flat-Top zeigt Amplituden am besten, keines trennt nahe Frequenzen am besten, die anderen liegen dazwischen</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Shows amplitudes on a logarithmic scale</source>
        <translation>Zeigt Amplituden in logarithmischem Maßstab</translation>
    </message>
    <message>
        <source>About the spectrum</source>
        <translation>Über das Spektrum</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: largest %2 %3 at %4 Hz</source>
        <translation>%1: am größten %2 %3 bei %4 Hz</translation>
    </message>
    <message>
        <source> (points were left out)</source>
        <translation> (Punkte wurden ausgelassen)</translation>
    </message>
    <message>
        <source> (gaps were bridged by lines)</source>
        <translation> (Lücken wurden durch Linien überbrückt)</translation>
    </message>
    <message>
        <source>Add a curve of numbers; its spectrum is shown here.</source>
        <translation>Eine Kurve von Zahlen hinzufügen; ihr Spektrum wird hier gezeigt.</translation>
    </message>
</context>
<context>
    <name>widgets::SpeedPanel</name>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>forward
mm/s</source>
        <translation>vorwärts
mm/s</translation>
    </message>
    <message>
        <source>left
mm/s</source>
        <translation>links
mm/s</translation>
    </message>
    <message>
        <source>turn
rad/s</source>
        <translation>Drehung
rad/s</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>gewünscht</translation>
    </message>
    <message>
        <source>true</source>
        <translation>wahr</translation>
    </message>
    <message>
        <source>believed</source>
        <translation>geglaubt</translation>
    </message>
    <message>
        <source>What you request</source>
        <translation>Was von hier angefordert wird</translation>
    </message>
    <message>
        <source>How the robot really moved in the last half second (from the simulator)</source>
        <translation>Wie sich der Roboter in der letzten halben Sekunde bewegt hat, wie es der Simulator weiß</translation>
    </message>
    <message>
        <source>What the robot reports (motion/status, drive/state)</source>
        <translation>Was der Roboter meldet (motion/status, drive/state)</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>Speed at full deflection</source>
        <translation>Geschwindigkeit bei Vollausschlag</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> mm/s</translation>
    </message>
    <message>
        <source>Maximum turn</source>
        <translation>Höchste Drehung</translation>
    </message>
    <message>
        <source>Turning speed at full deflection</source>
        <translation>Drehgeschwindigkeit bei Vollausschlag</translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation> rad/s</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
</context>
<context>
    <name>widgets::SteeringBar</name>
    <message>
        <source>Who steers</source>
        <translation>Wer steuert</translation>
    </message>
    <message>
        <source>Steer instead</source>
        <translation>Selbst steuern</translation>
    </message>
    <message>
        <source>%1 Your commands are not sent.</source>
        <translation>%1 Was hier befohlen wird, wird nicht gesendet.</translation>
    </message>
    <message>
        <source>Let others steer</source>
        <translation>Andere steuern lassen</translation>
    </message>
    <message>
        <source>Takes control; the robot stays still until you send a command</source>
        <translation>Ab jetzt wird von hier gesteuert; der Roboter bleibt stehen, bis ein Befehl gesendet wird</translation>
    </message>
    <message>
        <source>Releases control to others; the robot stops</source>
        <translation>Andere dürfen ab jetzt steuern; der Roboter hält an</translation>
    </message>
</context>
<context>
    <name>widgets::StreamListModel</name>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Nachrichten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>%1: its messages are stepped</source>
        <translation>%1: seine Nachrichten werden schrittweise gezeigt</translation>
    </message>
    <message>
        <source>Bytes/s</source>
        <translation>Byte/s</translation>
    </message>
    <message>
        <source>Mean size</source>
        <translation>Mittlere Größe</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Asked by</source>
        <translation>Angefordert von</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 thinned</source>
        <translation>%1 ausgedünnt</translation>
    </message>
    <message>
        <source>%1 thinned, %2 lost</source>
        <translation>%1 ausgedünnt, %2 verloren</translation>
    </message>
    <message>
        <source>nobody; key %1</source>
        <translation>niemand; Schlüssel %1</translation>
    </message>
    <message>
        <source>Views: %1</source>
        <translation>Ansichten: %1</translation>
    </message>
    <message>
        <source>Clients: %1</source>
        <translation>Clients: %1</translation>
    </message>
    <message>
        <source>Debug key %1</source>
        <translation>Debug-Schlüssel %1</translation>
    </message>
    <message>
        <source>Size of its messages per second</source>
        <translation>Speicher, den seine Nachrichten einer Sekunde belegen</translation>
    </message>
    <message>
        <source>Size of its history, in memory and on disk; for a log, its size in the file</source>
        <translation>Was davon aufbewahrt wird, im Speicher und auf der Platte; in einem Log alles</translation>
    </message>
    <message>
        <source>Its share of the memory for the history of all streams</source>
        <translation>Sein Anteil an dem, was von allen Datenströmen aufbewahrt wird</translation>
    </message>
    <message>
        <source>Of remote robots: messages replaced by newer ones because the line is narrow or a lower rate was chosen (thinned), and lost ones</source>
        <translation>Von Robotern anderswo: Nachrichten, die durch neuere ersetzt wurden, weil die Leitung schmal ist oder eine niedrigere Rate gewählt wurde (ausgedünnt), und verlorene</translation>
    </message>
    <message>
        <source>The views of this window that read it, and the clients of a link that subscribe to it</source>
        <translation>Die Ansichten dieses Fensters, die ihn lesen, und die Clients einer Verbindung, die ihn abonniert haben</translation>
    </message>
</context>
<context>
    <name>widgets::StreamSelector</name>
    <message>
        <source>Selected robot: %1</source>
        <translation>Gewählter Roboter: %1</translation>
    </message>
</context>
<context>
    <name>widgets::StreamsView</name>
    <message>
        <source>Search streams</source>
        <translation>Datenströme suchen</translation>
    </message>
    <message>
        <source>Check a stream to show it in the timeline; double click it to step its messages</source>
        <translation>Das Kreuz zeigt einen Datenstrom in der Zeitleiste; ein Doppelklick geht seine Nachrichten durch</translation>
    </message>
    <message>
        <source>Nothing is open.
Start a simulation, connect to a robot, or open a log with File &gt; Open log…</source>
        <translation>Nichts ist offen.
Eine Simulation starten, mit einem Roboter verbinden oder ein Log öffnen mit Datei &gt; Log öffnen…</translation>
    </message>
    <message>
        <source>streams: %1, messages: %2</source>
        <translation>Datenströme: %1, Nachrichten: %2</translation>
    </message>
    <message>
        <source>All streams</source>
        <translation>Alle Datenströme</translation>
    </message>
    <message>
        <source>Shows only streams whose path, schema or reader contains this</source>
        <translation>Zeigt nur Datenströme, deren Pfad, Schema oder Leser dies enthält</translation>
    </message>
    <message>
        <source>Which streams</source>
        <translation>Welche Datenströme</translation>
    </message>
    <message>
        <source>Which streams are listed</source>
        <translation>Welche Datenströme gelistet werden</translation>
    </message>
    <message>
        <source>Not read</source>
        <translation>Von niemandem gelesen</translation>
    </message>
    <message>
        <source>With losses</source>
        <translation>Nicht alles angekommen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected rows</source>
        <translation>Kopiert die ausgewählten Zeilen</translation>
    </message>
    <message>
        <source>Sums of all listed streams</source>
        <translation>Summen aller gelisteten Datenströme</translation>
    </message>
    <message>
        <source>Dropped: because too many arrived for this window, or because the queues of robots&apos; own processes were full</source>
        <translation>Verworfen: weil zu viele für dieses Fenster ankamen, oder weil die Warteschlangen der Prozesse der Roboter voll waren</translation>
    </message>
    <message>
        <source>There are no such streams. “All streams” lists the others.</source>
        <translation>Solche Datenströme gibt es nicht. „Alle Datenströme“ listet die anderen.</translation>
    </message>
    <message>
        <source>size: %1</source>
        <translation>Größe: %1</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>dropped: %1</source>
        <translation>verworfen: %1</translation>
    </message>
    <message>
        <source>thinned: %1, lost: %2</source>
        <translation>ausgedünnt: %1, verloren: %2</translation>
    </message>
</context>
<context>
    <name>widgets::StrokeModel</name>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Not</source>
        <translation>Nicht</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Share of its pixels that a table without this stroke classifies correctly</source>
        <translation>Anteil seiner Pixel, die eine Tabelle ohne diesen Strich richtig erkennt</translation>
    </message>
    <message>
        <source>Not known: it needs a second stroke of its class for comparison</source>
        <translation>Nicht bekannt: zum Vergleichen braucht es einen weiteren Strich seiner Klasse</translation>
    </message>
    <message>
        <source>A double click shows the image %1</source>
        <translation>Ein Doppelklick zeigt das Bild %1</translation>
    </message>
</context>
<context>
    <name>widgets::SuspiciousFrameModel</name>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Suspicion</source>
        <translation>Verdacht</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Specks</source>
        <translation>Sprenkel</translation>
    </message>
    <message>
        <source>Enclosed</source>
        <translation>Umschlossen</translation>
    </message>
    <message>
        <source>Ambiguous</source>
        <translation>Mehrdeutig</translation>
    </message>
    <message>
        <source>Vast</source>
        <translation>Riesig</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Its time</source>
        <translation>Seine Zeit</translation>
    </message>
    <message>
        <source>Weighted suspicious pixels: specks count 1, enclosed ones 0.5, ambiguous ones 0.1, those of vast areas 0.02</source>
        <translation>Verdächtige Pixel nach ihren Gewichten: Sprenkel zählen 1, umschlossene 0.5, mehrdeutige 0.1, die riesiger Flächen 0.02</translation>
    </message>
    <message>
        <source>Suspicious pixels of each class</source>
        <translation>Verdächtige Pixel jeder Klasse</translation>
    </message>
    <message>
        <source>Pixels of colored areas that are too small to be objects</source>
        <translation>Pixel farbiger Flächen, die zu klein für Objekte sind</translation>
    </message>
    <message>
        <source>Pixels of small areas inside an object of another color</source>
        <translation>Pixel kleiner Flächen innerhalb eines Objekts anderer Farbe</translation>
    </message>
    <message>
        <source>Pixels of colored classes that are close to another class, or to none</source>
        <translation>Pixel farbiger Klassen, die fast zu einer anderen Klasse oder zu keiner gehören</translation>
    </message>
    <message>
        <source>Pixels of areas of one color that cover more of the image than an object could</source>
        <translation>Pixel von Flächen einer Farbe, die mehr vom Bild bedecken, als Objekte es tun</translation>
    </message>
</context>
<context>
    <name>widgets::TableDifferenceModel</name>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Gained</source>
        <translation>Gewonnen</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>to</source>
        <translation>an</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>all changes</source>
        <translation>alle Änderungen</translation>
    </message>
    <message>
        <source>A click selects the cells that changed</source>
        <translation>Ein Klick wählt die Zellen aus, die sich geändert haben</translation>
    </message>
    <message>
        <source>Class of colors</source>
        <translation>Farbklasse</translation>
    </message>
    <message>
        <source>Cells that have this class now and did not before</source>
        <translation>Zellen, die jetzt dazugehören und es vorher nicht taten</translation>
    </message>
    <message>
        <source>What they were</source>
        <translation>Was sie waren</translation>
    </message>
    <message>
        <source>Cells that had this class before and do not now</source>
        <translation>Zellen, die dazugehörten und es jetzt nicht mehr tun</translation>
    </message>
    <message>
        <source>What they are</source>
        <translation>Was sie sind</translation>
    </message>
    <message>
        <source>Cells that have this class in the reference table</source>
        <translation>Zellen, die in der Vergleichstabelle dazugehören</translation>
    </message>
    <message>
        <source>Cells that have this class now</source>
        <translation>Zellen, die jetzt dazugehören</translation>
    </message>
</context>
<context>
    <name>widgets::TimeLineCanvas</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>The logs over time, with the playhead</source>
        <translation>Die Logs über der Zeit, mit der Abspielmarke</translation>
    </message>
    <message>
        <source>Playhead at %1 s</source>
        <translation>Abspielmarke bei %1 s</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 s&lt;/b&gt; %2</source>
        <translation>&lt;b&gt;%1 s&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>Offset in seconds</source>
        <translation>Versatz in Sekunden</translation>
    </message>
    <message>
        <source>Text of the bookmark</source>
        <translation>Text des Lesezeichens</translation>
    </message>
    <message>
        <source>%1 s since the beginning (timestamp %2 s)</source>
        <translation>%1 s seit dem Beginn (Zeitstempel %2 s)</translation>
    </message>
    <message>
        <source>%1, for %2 s</source>
        <translation>%1, für %2 s</translation>
    </message>
    <message>
        <source>Click: go there. Drag: move. Double click or F2: edit. Delete: remove.</source>
        <translation>Klick: dorthin gehen. Ziehen: verschieben. Doppelklick oder F2: bearbeiten. Entf: entfernen.</translation>
    </message>
    <message>
        <source>%1&lt;br&gt;Drag: move the playhead. Shift+drag: select a range. Wheel: zoom.</source>
        <translation>%1&lt;br&gt;Ziehen: Abspielmarke verschieben. Umschalt+ziehen: einen Bereich auswählen. Mausrad: zoomen.</translation>
    </message>
    <message>
        <source>Double click: add a bookmark here. Drag: select a range.</source>
        <translation>Doppelklick: hier ein Lesezeichen setzen. Ziehen: einen Bereich auswählen.</translation>
    </message>
    <message>
        <source>Offset of this log&apos;s times. Drag it, or double click and type.</source>
        <translation>Versatz der Zeiten dieses Logs. Ziehen, oder Doppelklick und eingeben.</translation>
    </message>
    <message>
        <source>%1&lt;br&gt;Drag: move the playhead.</source>
        <translation>%1&lt;br&gt;Ziehen: Abspielmarke verschieben.</translation>
    </message>
    <message>
        <source>%1, %2 a second</source>
        <translation>%1, %2 pro Sekunde</translation>
    </message>
    <message>
        <source>1 message</source>
        <translation>1 Nachricht</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 Nachrichten</translation>
    </message>
    <message>
        <source>Double click: step the messages of this stream. Drag: select a range.</source>
        <translation>Doppelklick: die Nachrichten dieses Datenstroms durchgehen. Ziehen: einen Bereich auswählen.</translation>
    </message>
    <message>
        <source>Nothing was received from %1 for %2 s, from %3 s on%4</source>
        <translation>Von %1 wurde %2 s lang nichts empfangen, ab %3 s%4</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1: no longer kept. The context menu sets how much is.</source>
        <translation>%1: nicht mehr vorhanden. Das Kontextmenü legt fest, wie viel behalten wird.</translation>
    </message>
    <message>
        <source>%1, on disk. Click or drag: show it in all views.</source>
        <translation>%1, auf dem Datenträger. Klicken oder ziehen: in allen Ansichten zeigen.</translation>
    </message>
    <message>
        <source>%1. Click or drag: show it in all views.</source>
        <translation>%1. Klicken oder ziehen: in allen Ansichten zeigen.</translation>
    </message>
    <message>
        <source>Drag: show an earlier instant in all views. Shift+drag: select a range. Wheel: zoom.</source>
        <translation>Ziehen: einen früheren Zeitpunkt in allen Ansichten zeigen. Umschalt+Ziehen: einen Bereich wählen. Rad: zoomen.</translation>
    </message>
    <message>
        <source>%1 %2 at %3 s</source>
        <translation>%1 %2 bei %3 s</translation>
    </message>
    <message>
        <source>The context menu removes the curve.</source>
        <translation>Das Kontextmenü entfernt die Kurve.</translation>
    </message>
    <message>
        <source>Warnings and errors in the messages</source>
        <translation>Warnungen und Fehler in den Meldungen</translation>
    </message>
</context>
<context>
    <name>widgets::TimeLineView</name>
    <message>
        <source>Frame back</source>
        <translation>Frame zurück</translation>
    </message>
    <message>
        <source>Shows the frame before (Left), while the robots continue</source>
        <translation>Zeigt den vorigen Frame (Links), während die Roboter weiterlaufen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>All views show one instant, while the robots continue (Space). What you switch, tune or steer acts on the robots as they are now.</source>
        <translation>Alle Ansichten zeigen einen Augenblick, während die Roboter weiterlaufen (Leertaste). Schalten, Einstellen und Steuern wirkt auf die Roboter, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>Frame forward</source>
        <translation>Frame vor</translation>
    </message>
    <message>
        <source>Shows the next frame (Right), while the robots continue</source>
        <translation>Zeigt den nächsten Frame (Rechts), während die Roboter weiterlaufen</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Returns to what happens now (End)</source>
        <translation>Kehrt zu dem zurück, was jetzt geschieht (Ende)</translation>
    </message>
    <message>
        <source>How much is &amp;kept…</source>
        <translation>Wie viel &amp;behalten wird…</translation>
    </message>
    <message>
        <source>Cut into a new log</source>
        <translation>In ein neues Log schneiden</translation>
    </message>
    <message>
        <source>Logs (*.mcap)</source>
        <translation>Logs (*.mcap)</translation>
    </message>
    <message>
        <source>A log cannot be cut into itself; choose another name.</source>
        <translation>Ein Log kann nicht in sich selbst geschnitten werden; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Cutting into %1</source>
        <translation>Schneiden in %1</translation>
    </message>
    <message>
        <source>This log holds no images.</source>
        <translation>Dieses Log enthält keine Bilder.</translation>
    </message>
    <message>
        <source>Export images into a folder</source>
        <translation>Bilder in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Exporting images into %1</source>
        <translation>Bilder werden in %1 exportiert</translation>
    </message>
    <message>
        <source>Export %1 as a table</source>
        <translation>%1 als Tabelle exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Export texts</source>
        <translation>Texte exportieren</translation>
    </message>
    <message>
        <source>Texts (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
    <message>
        <source>Mark this event of %1, to find it in another log</source>
        <translation>Dieses Ereignis von %1 markieren, um es in einem anderen Log zu finden</translation>
    </message>
    <message>
        <source>This is the marked event of %1: align</source>
        <translation>Dies ist das markierte Ereignis von %1: ausrichten</translation>
    </message>
    <message>
        <source>Repair into a new log</source>
        <translation>In ein neues Log reparieren</translation>
    </message>
    <message>
        <source>Repairing into %1</source>
        <translation>Reparieren in %1</translation>
    </message>
    <message>
        <source>Value whose changes are stepped through</source>
        <translation>Wert, dessen Änderungen durchgegangen werden</translation>
    </message>
    <message>
        <source>A value or expression, such as models/ball.position.x &gt; 1; Enter goes to its next change</source>
        <translation>Ein Wert oder Ausdruck, etwa models/ball.position.x &gt; 1; die Eingabetaste geht zu seiner nächsten Änderung</translation>
    </message>
    <message>
        <source>Step by changes of…</source>
        <translation>Nach Änderungen gehen von…</translation>
    </message>
    <message>
        <source>Previous change</source>
        <translation>Vorige Änderung</translation>
    </message>
    <message>
        <source>Shows when that value changed before</source>
        <translation>Zeigt, wann sich dieser Wert davor geändert hat</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Next change</source>
        <translation>Nächste Änderung</translation>
    </message>
    <message>
        <source>Shows when that value changes next</source>
        <translation>Zeigt, wann sich dieser Wert danach ändert</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>Lesezeichen setzen</translation>
    </message>
    <message>
        <source>Adds a bookmark at this moment, and lets you name it</source>
        <translation>Setzt an diesem Zeitpunkt ein Lesezeichen, das sich benennen lässt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change of the bookmarks</source>
        <translation>Macht die letzte Änderung der Lesezeichen rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redoes what was undone</source>
        <translation>Stellt wieder her, was rückgängig gemacht wurde</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Shows more time (also: wheel)</source>
        <translation>Zeigt mehr Zeit (auch: Mausrad)</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Shows less time, larger (also: the wheel)</source>
        <translation>Zeigt weniger Zeit, größer (auch: das Mausrad)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Shows all of the logs</source>
        <translation>Zeigt die Logs vollständig</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the playhead in view</source>
        <translation>Hält die Abspielmarke im Blick</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Plays the selected range in a loop</source>
        <translation>Spielt den ausgewählten Bereich in einer Schleife ab</translation>
    </message>
    <message>
        <source>Cut…</source>
        <translation>Schneiden…</translation>
    </message>
    <message>
        <source>Writes the selected range into a new log</source>
        <translation>Schreibt den ausgewählten Bereich in ein neues Log</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Clear range</source>
        <translation>Bereich aufheben</translation>
    </message>
    <message>
        <source>Clears the selection (Esc)</source>
        <translation>Hebt die Auswahl auf (Esc)</translation>
    </message>
    <message>
        <source>Images as &amp;PNG…</source>
        <translation>Bilder als &amp;PNG…</translation>
    </message>
    <message>
        <source>The stepped stream as &amp;CSV…</source>
        <translation>Der durchgegangene Datenstrom als &amp;CSV…</translation>
    </message>
    <message>
        <source>&amp;Texts…</source>
        <translation>&amp;Texte…</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Whose images are shown</source>
        <translation>Wessen Bilder gezeigt werden</translation>
    </message>
    <message>
        <source>Bookmark %1</source>
        <translation>Lesezeichen %1</translation>
    </message>
    <message>
        <source>Nothing is open.
Start a simulation, connect to a robot, or open a log with File &gt; Open log…</source>
        <translation>Nichts ist offen.
Eine Simulation starten, mit einem Roboter verbinden oder ein Log öffnen mit Datei &gt; Log öffnen…</translation>
    </message>
    <message>
        <source>%1 – %2 s (%3 s)</source>
        <translation>%1 – %2 s (%3 s)</translation>
    </message>
    <message>
        <source>Start range here</source>
        <translation>Bereich hier beginnen</translation>
    </message>
    <message>
        <source>End range here</source>
        <translation>Bereich hier beenden</translation>
    </message>
    <message>
        <source>Step messages of %1</source>
        <translation>Nachrichten von %1 durchgehen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>A &amp;view as video or images…</source>
        <translation>&amp;Ansicht als Video oder Bilder…</translation>
    </message>
    <message>
        <source>Writes what an open view shows in the selected range</source>
        <translation>Schreibt, was eine offene Ansicht im gewählten Bereich zeigt</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>&amp;Remove the curve of %1</source>
        <translation>Die Kurve von %1 &amp;entfernen</translation>
    </message>
    <message>
        <source>Writes the selected range, or all, as images, a table, texts, a log of some streams, or a video of a view</source>
        <translation>Schreibt den gewählten Bereich, oder alles, als Bilder, Tabelle, Texte, als Log mancher Datenströme, oder als Video einer Ansicht</translation>
    </message>
    <message>
        <source>Some &amp;streams as a new log…</source>
        <translation>Manche &amp;Datenströme als neues Log…</translation>
    </message>
</context>
<context>
    <name>widgets::TimeMarks</name>
    <message>
        <source>%1 at character %2</source>
        <translation>%1 bei Zeichen %2</translation>
    </message>
</context>
<context>
    <name>widgets::TimingModel</name>
    <message>
        <source>Process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Last ms</source>
        <translation>Letzte ms</translation>
    </message>
    <message>
        <source>Mean ms</source>
        <translation>Mittel ms</translation>
    </message>
    <message>
        <source>Min ms</source>
        <translation>Min ms</translation>
    </message>
    <message>
        <source>Max ms</source>
        <translation>Max ms</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Share of period</source>
        <translation>Anteil an der Periode</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Mean time of the task, as a share of the time from one frame of its process to the next</source>
        <translation>Mittlere Zeit der Aufgabe, als Anteil an der Zeit von einem Frame ihres Prozesses zum nächsten</translation>
    </message>
    <message>
        <source>Median ms</source>
        <translation>Median ms</translation>
    </message>
    <message>
        <source>95 % ms</source>
        <translation>95 % ms</translation>
    </message>
    <message>
        <source>99 % ms</source>
        <translation>99 % ms</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Überschreitungen</translation>
    </message>
    <message>
        <source>%1 of %2 frames, %3 %</source>
        <translation>%1 von %2 Durchläufen, %3 %</translation>
    </message>
    <message>
        <source>Median: half of all frames took at most this long</source>
        <translation>Die Hälfte aller Durchläufe dauerte nicht länger</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95 % aller Durchläufe dauerten nicht länger</translation>
    </message>
    <message>
        <source>99th percentile</source>
        <translation>99 % aller Durchläufe dauerten nicht länger</translation>
    </message>
    <message>
        <source>Frames that took longer than the period of their process, or than the time from one frame to the next where it has none; of a task: those in which it took longest</source>
        <translation>Durchläufe, die länger dauerten als die Periode ihres Prozesses, oder als die Zeit von einem Durchlauf zum nächsten, wo es keine gibt; bei einer Aufgabe: die, in denen sie am längsten dauerte</translation>
    </message>
    <message>
        <source>Min period ms</source>
        <translation>Kürzeste Periode ms</translation>
    </message>
    <message>
        <source>Max period ms</source>
        <translation>Längste Periode ms</translation>
    </message>
    <message>
        <source>Jitter ms</source>
        <translation>Jitter ms</translation>
    </message>
    <message>
        <source>Shortest time from one frame to the next, on the robot&apos;s clock</source>
        <translation>Kürzeste Zeit von einem Frame zum nächsten, nach der Uhr des Roboters</translation>
    </message>
    <message>
        <source>Longest time from one frame to the next, on the robot&apos;s clock</source>
        <translation>Längste Zeit von einem Frame zum nächsten, nach der Uhr des Roboters</translation>
    </message>
    <message>
        <source>Standard deviation of the time from one frame to the next, on the robot&apos;s clock</source>
        <translation>Standardabweichung der Zeit von einem Frame zum nächsten, nach der Uhr des Roboters</translation>
    </message>
</context>
<context>
    <name>widgets::TimingView</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Lets the robot measure its tasks (debug key timing/tasks)</source>
        <translation>Lässt den Roboter seine Aufgaben messen (Debug-Schlüssel timing/tasks)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restarts the statistics</source>
        <translation>Beginnt die Statistik neu</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Times of the tasks</source>
        <translation>Zeiten der Aufgaben</translation>
    </message>
    <message>
        <source>State of the measurement</source>
        <translation>Zustand des Messens</translation>
    </message>
    <message>
        <source>The robot does not measure its tasks: %1</source>
        <translation>Der Roboter misst nicht: %1</translation>
    </message>
    <message>
        <source>No robot. Start a simulation or connect to a robot, and choose it in the toolbar.</source>
        <translation>Kein Roboter. Eine Simulation starten oder mit einem Roboter verbinden und ihn in der Werkzeugleiste wählen.</translation>
    </message>
    <message>
        <source>Waiting for the robot&apos;s times. They arrive while its program runs.</source>
        <translation>Wartet auf die Zeiten des Roboters. Sie kommen, während sein Programm läuft.</translation>
    </message>
    <message>
        <source>The robot does not measure its tasks. Press “Measure”.</source>
        <translation>Der Roboter misst nicht. „Messen“ drücken.</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the instant that the timeline shows in the chart (F)</source>
        <translation>Hält den Zeitpunkt, den die Zeitleiste zeigt, im Diagramm (F)</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Shows less time in the chart (+ or the wheel)</source>
        <translation>Zeigt weniger Zeit im Diagramm (+ oder das Rad)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Shows more time in the chart (- or the wheel)</source>
        <translation>Zeigt mehr Zeit im Diagramm (- oder das Rad)</translation>
    </message>
    <message>
        <source>Copies the table in front as CSV</source>
        <translation>Kopiert die vordere Tabelle als CSV</translation>
    </message>
    <message>
        <source>From readings to commands</source>
        <translation>Von Messungen zu Befehlen</translation>
    </message>
    <message>
        <source>How latencies are measured</source>
        <translation>Wie Latenzen gemessen werden</translation>
    </message>
    <message>
        <source>From a reading&apos;s own timestamp to when the first command that is based on it is sent: waiting, on the robot&apos;s clock, plus computing, in real time. In lockstep that clock is stopped while processes compute; then all time along the way counts as computing. The output of a process counts as based on the newest reading that reached it.</source>
        <translation>Vom eigenen Zeitstempel einer Messung bis zum Senden des ersten Befehls, der auf ihr beruht: Warten, auf der Uhr des Roboters, und Rechnen, in wirklicher Zeit. Im Gleichschritt steht diese Uhr, während Prozesse rechnen; dann zählt alles, was auf dem Weg liegt, als Rechnen. Was ein Prozess sendet, gilt als auf der neuesten Messung beruhend, die ihn erreicht hat.</translation>
    </message>
    <message>
        <source>Chart of the last seconds</source>
        <translation>Diagramm der letzten Sekunden</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>How long readings, such as images, take to become commands</source>
        <translation>Wie lange es dauert, bis Messungen, etwa Bilder, zu Befehlen werden</translation>
    </message>
    <message>
        <source>No frame was measured at this time. “Follow” shows the current one.</source>
        <translation>Zu dieser Zeit wurde kein Durchlauf gemessen. „Folgen“ zeigt den gegenwärtigen.</translation>
    </message>
    <message>
        <source>No command was based on a reading of the platform yet. Older programs and logs do not say which commands are.</source>
        <translation>Noch beruhte kein Befehl auf einer Messung der Plattform. Ältere Programme und Logs sagen nicht, welche Befehle es sind.</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
</context>
<context>
    <name>widgets::ToolRow</name>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>Tools that do not fit</source>
        <translation>Werkzeuge, für die kein Platz ist</translation>
    </message>
</context>
<context>
    <name>widgets::TrailMenu</name>
    <message>
        <source>Trails of</source>
        <translation>Spuren von</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Robotern</translation>
    </message>
    <message>
        <source>True paths of robots; for real robots, their estimated paths</source>
        <translation>Wo Roboter waren; bei wirklichen, wo sie zu sein glaubten</translation>
    </message>
    <message>
        <source>&amp;Estimated poses</source>
        <translation>&amp;Geschätzten Posen</translation>
    </message>
    <message>
        <source>Estimated paths of the chosen robots, next to the true ones</source>
        <translation>Wo die gewählten Roboter zu sein glaubten, neben dem, wo sie waren</translation>
    </message>
    <message>
        <source>&amp;Ball</source>
        <translation>&amp;Ball</translation>
    </message>
    <message>
        <source>True or estimated path of the ball</source>
        <translation>Wo der Ball war, oder vermutet wurde</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>&amp;Automatic (%1 s, on maps %2 s)</source>
        <translation>&amp;Automatisch (%1 s, auf Karten %2 s)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>widgets::TrainingPanel</name>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the table is made from the samples</source>
        <translation>Wie die Tabelle aus den Proben entsteht</translation>
    </message>
    <message>
        <source>Kernel votes</source>
        <translation>Kernel-Stimmen</translation>
    </message>
    <message>
        <source>Samples vote for the colors around them; the fastest, and good from the first stroke on</source>
        <translation>Proben stimmen für die Farben um sie herum; am schnellsten, und schon ab einem einzigen Strich gut</translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation>Gauß-Verteilungen</translation>
    </message>
    <message>
        <source>One Gaussian per class; smooth, and good from ten strokes on</source>
        <translation>Eine Gauß-Verteilung je Klasse; glatt, und ab zehn Strichen gut</translation>
    </message>
    <message>
        <source>Support vectors</source>
        <translation>Stützvektoren</translation>
    </message>
    <message>
        <source>A support vector machine; slower</source>
        <translation>Eine Stützvektormaschine; langsamer</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Resets the method and all options to their defaults</source>
        <translation>Setzt das Verfahren und alle Optionen auf ihre Vorgaben zurück</translation>
    </message>
    <message>
        <source>Remove strays</source>
        <translation>Streuner entfernen</translation>
    </message>
    <message>
        <source>Colors of a class that are far from all its samples lose it</source>
        <translation>Farben einer Klasse, die weit von allen ihren Proben sind, verlieren sie</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Unclassified colors that one class encloses are assigned to it</source>
        <translation>Farben ohne Klasse, die eine Klasse umschließt, bekommen sie</translation>
    </message>
    <message>
        <source>Correct vignetting</source>
        <translation>Vignettierung korrigieren</translation>
    </message>
    <message>
        <source>Removes the lens&apos;s darkening of the corners before the table is used</source>
        <translation>Entfernt die Abdunklung der Ecken durch das Objektiv, bevor die Tabelle verwendet wird</translation>
    </message>
    <message>
        <source>Correct cameras</source>
        <translation>Kameras korrigieren</translation>
    </message>
    <message>
        <source>Matches the colors of all cameras</source>
        <translation>Gleicht die Farben aller Kameras an</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzen</translation>
    </message>
    <message>
        <source>Estimates from the strokes how the lens and the cameras change colors, and corrects it</source>
        <translation>Schätzt aus den Strichen, wie Objektiv und Kameras die Farben verändern, und korrigiert es</translation>
    </message>
    <message>
        <source>Default options</source>
        <translation>Vorgaben der Optionen</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>Verfahren: %1</translation>
    </message>
    <message>
        <source>Estimate corrections</source>
        <translation>Korrekturen schätzen</translation>
    </message>
</context>
<context>
    <name>widgets::TrueClassFrames</name>
    <message>
        <source>The true classes are not published: %1</source>
        <translation>Die wahren Klassen werden nicht veröffentlicht: %1</translation>
    </message>
</context>
<context>
    <name>widgets::ViewExport</name>
    <message>
        <source>1 picture</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1: a video of %2, %3 s</source>
        <translation>%1: ein Video von %2, %3 s</translation>
    </message>
    <message>
        <source>%1: %2 of %3 s</source>
        <translation>%1: %2 von %3 s</translation>
    </message>
    <message>
        <source>The export failed or is incomplete: %1</source>
        <translation>Es wurde nichts exportiert, oder nicht alles: %1</translation>
    </message>
    <message>
        <source>Canceled; %1 are in %2</source>
        <translation>Abgebrochen; %1 sind in %2</translation>
    </message>
    <message>
        <source>Canceled; %1 was deleted</source>
        <translation>Abgebrochen; von %1 ist nichts übrig</translation>
    </message>
    <message>
        <source>Writing %1: %2 of %3 pictures</source>
        <translation>Schreibe %1: %2 von %3 Bildern</translation>
    </message>
</context>
<context>
    <name>widgets::WalkPad</name>
    <message>
        <source>Drag to walk, up is forward. Keys: W/A/S/D or the arrows walk, Q and E turn, Shift halves the speed.</source>
        <translation>Ziehen zum Gehen, oben ist vorwärts. Tasten: W/A/S/D oder die Pfeile gehen, Q und E drehen, Umschalt halbiert.</translation>
    </message>
    <message>
        <source>Drag to drive: up is forward, left turns left. Keys: W and S or the arrows drive, A and D or the arrows turn, Shift halves.</source>
        <translation>Ziehen zum Fahren: oben ist vorwärts, links dreht nach links. Tasten: W und S oder die Pfeile fahren, A und D oder die Pfeile drehen, Umschalt halbiert.</translation>
    </message>
    <message>
        <source>Driving pad</source>
        <translation>Fahrfeld</translation>
    </message>
    <message>
        <source>Walk pad</source>
        <translation>Gehfeld</translation>
    </message>
</context>
</TS>
