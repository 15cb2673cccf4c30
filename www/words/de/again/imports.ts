/** Was der Import sagt: was er nicht nimmt, was er weglässt, und wie Formen ohne Namen heißen (www/shapes/import). */

import type { Patterns } from "../again";

const PLAIN = "speichern Sie die Zeichnung als einfaches SVG";

export const imports: Patterns = {
  "Everything together": "Alles zusammen",
  Points: "Punkte",
  Picture: "Bild",
  Reference: "Referenz",
  Target: "Ziel",
  "Matched reference": "Verformte Referenz",
  "Shape {number}": "Form {number}",
  "Specimen {number}": "Exemplar {number}",
  "Feature {number}": "Gebiet {number}",

  "This is a PDF; export the drawing as SVG, or the page as PNG.":
    "Das ist ein PDF; exportieren Sie die Zeichnung als SVG oder die Seite als PNG.",
  "This is an archive or an office document; take the picture or the drawing out of it.":
    "Das ist ein Archiv oder ein Bürodokument; nehmen Sie das Bild oder die Zeichnung heraus.",
  "This is a compressed file; unpack it first (an .svgz becomes an .svg).":
    "Das ist eine komprimierte Datei; entpacken Sie sie erst (aus .svgz wird .svg).",
  "This is PostScript; export the drawing as SVG.": "Das ist PostScript; exportieren Sie die Zeichnung als SVG.",
  "This is a TIFF picture, which browsers do not read; save it as PNG.":
    "Das ist ein TIFF-Bild, das Browser nicht lesen; speichern Sie es als PNG.",
  "This is a Photoshop file; export it as PNG.": "Das ist eine Photoshop-Datei; exportieren Sie sie als PNG.",
  "This is a binary file of an unknown kind; choose an SVG, a picture, JSON or CSV.":
    "Das ist eine Binärdatei unbekannter Art; wählen Sie SVG, ein Bild, JSON oder CSV.",
  "The import could not be started or ran out of memory, because the browser ended the page's worker. Close other pages or take a smaller file; let the page's security policy allow “worker-src blob:”.":
    "Der Import ließ sich nicht starten oder hatte nicht genug Speicher, denn der Browser hat den Worker der Seite beendet. Schließen Sie andere Seiten, oder nehmen Sie eine kleinere Datei; die Sicherheitsregeln der Seite müssen „worker-src blob:“ erlauben.",
  "The file is empty.": "Die Datei ist leer.",
  "The file cannot be read; it may be a folder, or gone. Choose it again.":
    "Die Datei lässt sich nicht lesen; vielleicht ist sie ein Ordner oder nicht mehr da. Wählen Sie sie noch einmal.",
  "The picture has more than 400 MB; make it smaller.": "Das Bild hat mehr als 400 MB; verkleinern Sie es.",
  "The file has more than 40 MB; simplify the drawing first.":
    "Die Datei hat mehr als 40 MB; vereinfachen Sie erst die Zeichnung.",
  "This is a web page or other markup, not a drawing; import the SVG itself.":
    "Das ist eine Webseite oder anderes Markup, keine Zeichnung; importieren Sie das SVG selbst.",
  "The text is empty.": "Der Text ist leer.",
  "This is none of SVG, PNG, JPEG, WebP, JSON, GeoJSON, TPS and CSV; choose a drawing, a picture or a list of points.":
    "Das ist weder SVG, PNG, JPEG oder WebP noch JSON, GeoJSON, TPS oder CSV; wählen Sie eine Zeichnung, ein Bild oder eine Punktliste.",

  "The picture cannot be decoded ({why}); it may be damaged or too large. Save it again as PNG, or make it smaller.":
    "Das Bild lässt sich nicht entschlüsseln ({why}); vielleicht ist es beschädigt oder zu groß. Speichern Sie es noch einmal als PNG, oder verkleinern Sie es.",
  "This browser gives no canvas to read pictures with; use a current one.":
    "Dieser Browser bietet keine Zeichenfläche, mit der Bilder zu lesen wären; nehmen Sie einen aktuellen.",
  "The picture of {width} × {height} pixels is read at {less} × {lower}.":
    "Das Bild von {width} × {height} Pixeln wird mit {less} × {lower} gelesen.",
  "The picture is nearly uniform: there is no outline in it. Choose one with more contrast.":
    "Das Bild ist fast einfarbig: Es enthält keinen Umriss. Wählen Sie eines mit mehr Kontrast.",
  "Nothing is inside at this threshold; move the slider.":
    "Bei dieser Schwelle ist nichts innen; bewegen Sie den Regler.",
  "The shape reaches the picture's edge and is cut there.":
    "Die Form reicht bis zum Bildrand und ist dort abgeschnitten.",

  "Nothing is left that is larger than a cell of the grid; scale the shape up.":
    "Nichts bleibt übrig, das größer wäre als eine Zelle des Gitters; vergrößern Sie die Form.",
  "{count} speck smaller than a cell is left out.": "{count} Fleck, kleiner als eine Zelle, ist weggelassen.",
  "{count} specks smaller than a cell are left out.": "{count} Flecken, kleiner als eine Zelle, sind weggelassen.",
  "Of {all} loops the {most} largest are taken.": "Von {all} Kurven sind die {most} größten genommen.",
  "Details finer than {cells} cells are smoothed away.": "Einzelheiten, feiner als {cells} Zellen, sind geglättet.",

  "The SVG is broken ({why}); save or copy it again, whole.":
    "Das SVG ist beschädigt ({why}); speichern oder kopieren Sie es noch einmal, vollständig.",
  "it is not well-formed": "es ist nicht wohlgeformt",
  "This is XML, but not a drawing: its root is not <svg>.":
    "Das ist XML, aber keine Zeichnung: Die Wurzel ist nicht <svg>.",
  "The drawing has more than {most} MB of text; simplify its paths first.":
    "Die Zeichnung hat mehr als {most} MB Text; vereinfachen Sie erst ihre Pfade.",
  "The drawing abbreviates its text by entities; save it as plain SVG.": `Die Zeichnung kürzt ihren Text durch Entitäten ab; ${PLAIN}.`,
  "A tag of the drawing has more than {most} attributes, or a script or style sheet is as long; save it as plain SVG.": `Ein Element der Zeichnung hat mehr als {most} Attribute, oder ein Skript oder Stylesheet ist so lang; ${PLAIN}.`,
  "The drawing has more than {most} elements, each use of one counted; simplify it, or import a picture of it.":
    "Die Zeichnung hat mehr als {most} Elemente, jede Verwendung gezählt; vereinfachen Sie sie, oder importieren Sie ein Bild davon.",
  "The drawing has a style sheet of too many rules; save it as plain SVG.": `Die Zeichnung hat ein Stylesheet mit zu vielen Regeln; ${PLAIN}.`,
  "The drawing uses itself or is nested too deeply; save it as plain SVG.": `Die Zeichnung verwendet sich selbst oder ist zu tief verschachtelt; ${PLAIN}.`,
  "Some rules of the drawing's style sheet are left out; save it as plain SVG if parts are missing or too many.":
    "Einige Regeln des Stylesheets sind weggelassen; speichern Sie die Zeichnung als einfaches SVG, wenn Teile fehlen oder überzählig sind.",
  "Text is left out: turn it into paths to have it.":
    "Text ist weggelassen: Wandeln Sie ihn in Pfade um, wenn Sie ihn brauchen.",
  "Pictures inside the drawing are left out: import them by themselves.":
    "Bilder in der Zeichnung sind weggelassen: Importieren Sie sie für sich.",
  "The drawing has more than {most} MB of path data, each use counted; simplify its paths first.":
    "Die Zeichnung hat mehr als {most} MB Pfaddaten, jede Verwendung gezählt; vereinfachen Sie erst ihre Pfade.",
  "Parts kept in other files are left out.": "Was in anderen Dateien liegt, ist weggelassen.",
  "The transform-origin “{origin}” is not in pixels; save the drawing as plain SVG.": `Der transform-origin „{origin}“ ist nicht in Pixeln angegeben; ${PLAIN}.`,
  "The transform “{text}” cannot be read; save the drawing as plain SVG, with its transforms applied.": `Die Transformation „{text}“ ist nicht lesbar; ${PLAIN}, mit angewandten Transformationen.`,
  "Path data cannot be read ({why}); save the drawing again.":
    "Die Pfaddaten sind nicht lesbar ({why}); speichern Sie die Zeichnung noch einmal.",
  "The drawing has more than {most} path commands; simplify its paths first, or import a picture of it.":
    "Die Zeichnung hat mehr als {most} Pfadbefehle; vereinfachen Sie erst ihre Pfade, oder importieren Sie ein Bild davon.",
  "The drawing has no paths and no basic shapes; turn text and strokes into paths.":
    "Die Zeichnung hat keine Pfade und keine Grundformen; wandeln Sie Text und Striche in Pfade um.",
  "The drawing has only open lines, which enclose nothing; close them, or turn strokes into paths.":
    "Die Zeichnung hat nur offene Linien, die nichts umschließen; schließen Sie sie, oder wandeln Sie Striche in Pfade um.",
  "Open lines are left out: they enclose nothing.": "Offene Linien sind weggelassen: Sie umschließen nichts.",
  "The paths cross so often that they are read as a picture of 1024 points a side.":
    "Die Pfade kreuzen sich so oft, dass sie als Bild von 1024 Punkten je Seite gelesen werden.",
  "The paths of the drawing enclose no area.": "Die Pfade der Zeichnung umschließen keine Fläche.",
  "This drawing of a match holds no shape; save it again.":
    "Diese Zeichnung eines Abgleichs enthält keine Form; speichern Sie sie noch einmal.",
  "The rectangle behind everything is taken for paper and left out.":
    "Das Rechteck hinter allem gilt als Papier und ist weggelassen.",

  "The table holds no points; each line needs an x and a y.":
    "Die Tabelle enthält keine Punkte; jede Zeile braucht ein x und ein y.",
  "Without curves the landmarks themselves, in their order, are the outline.":
    "Ohne Kurven sind die Landmarken selbst, in ihrer Reihenfolge, der Umriss.",
  "{name} has no outline: no curve, and of its {all} landmarks {there} are there (negative coordinates mean a missing point).":
    "{name} hat keinen Umriss: keine Kurve, und von {all} Landmarken sind {there} da (negative Koordinaten bedeuten einen fehlenden Punkt).",
  "Line {line}: landmarks in space are not read, only LM=.":
    "Zeile {line}: Landmarken im Raum werden nicht gelesen, nur LM=.",
  "Line {line}: a specimen begins with LM=, not with {key}=.":
    "Zeile {line}: Ein Exemplar beginnt mit LM=, nicht mit {key}=.",
  "The TPS file holds no specimen.": "Die TPS-Datei enthält kein Exemplar.",
  "Line {line}: “{shown}” is neither announced by a count nor named.":
    "Zeile {line}: „{shown}“ ist weder durch eine Anzahl angekündigt noch benannt.",
  "Line {line}: “{shown}” is not the two numbers of a point.":
    "Zeile {line}: „{shown}“ sind nicht die zwei Zahlen eines Punktes.",
  "Line {line} ({shown}) announces {count} points, and {there} follow.":
    "Zeile {line} ({shown}) kündigt {count} Punkte an, und {there} folgen.",
  "Line {line} ({shown}) does not fit the number of its lines POINTS=: {there}.":
    "Zeile {line} ({shown}) passt nicht zur Zahl ihrer Zeilen POINTS=: {there}.",
  "Line {line}: “{shown}” gives no count.": "Zeile {line}: „{shown}“ nennt keine Anzahl.",
  "Line {line}: “{shown}” is no scale; it is empty, or a number above 0.":
    "Zeile {line}: „{shown}“ ist kein Maßstab; er ist leer oder eine Zahl über 0.",
  "Line {line} names {count} columns; call the two to be used x and y.":
    "Zeile {line} nennt {count} Spalten; nennen Sie die beiden gemeinten x und y.",
  "Line {line} has {count} numbers, and no line before names x and y; decimal commas need semicolons between the numbers.":
    "Zeile {line} hat {count} Zahlen, und keine Zeile davor nennt x und y; mit Dezimalkommas gehören Strichpunkte zwischen die Zahlen.",
  "Line {line} has only one number; each line needs an x and a y.":
    "Zeile {line} hat nur eine Zahl; jede Zeile braucht ein x und ein y.",
  "Line {line}: “{shown}” is not a number; each line needs an x and a y.":
    "Zeile {line}: „{shown}“ ist keine Zahl; jede Zeile braucht ein x und ein y.",
  "The JSON is broken ({why}); save it again, whole.":
    "Das JSON ist beschädigt ({why}); speichern Sie es noch einmal, vollständig.",
  "This is TopoJSON; convert it to GeoJSON first.": "Das ist TopoJSON; wandeln Sie es erst in GeoJSON um.",
  "The list in the JSON is empty.": "Die Liste im JSON ist leer.",
  '{name} has no points; the JSON should be a list of {"name": …, "points": [[x, y], …]}, GeoJSON, or a file saved here.':
    '{name} hat keine Punkte; das JSON sollte eine Liste von {"name": …, "points": [[x, y], …]} sein, GeoJSON oder eine hier gespeicherte Datei.',
  "{name} has something that is no list of points.": "{name} enthält etwas, was keine Punktliste ist.",
  "Point {number} of {name} is not [x, y] with two finite numbers.":
    "Punkt {number} von {name} ist nicht [x, y] mit zwei endlichen Zahlen.",
  "The GeoJSON has no polygons, only points or lines; choose a file with areas.":
    "Das GeoJSON hat keine Polygone, nur Punkte oder Linien; wählen Sie eine Datei mit Flächen.",
  "Features without an area are left out: {count}.": "Gebiete ohne Fläche sind weggelassen: {count}.",
  "The GeoJSON is damaged: {name} is not a list.": "Das GeoJSON ist beschädigt: {name} ist keine Liste.",
  "Position {number} of {name} is not [longitude, latitude].":
    "Position {number} von {name} ist nicht [Länge, Breite].",
  "Position {number} of {name} is {longitude}, {latitude}, which are no degrees; GeoJSON needs WGS 84.":
    "Position {number} von {name} ist {longitude}, {latitude}, was keine Grade sind; GeoJSON braucht WGS 84.",
  "{name} encloses no area.": "{name} umschließt keine Fläche.",
  "Loop {number} of {name} has {points} points; a closed curve needs at least three.":
    "Kurve {number} von {name} hat {points} Punkte; eine geschlossene Kurve braucht mindestens drei.",
  "The points of {name} enclose no area.": "Die Punkte von {name} umschließen keine Fläche.",
  "The numbers of {name} are too large or too small to be computed with; take another unit.":
    "Die Zahlen von {name} sind zu groß oder zu klein zum Rechnen; nehmen Sie eine andere Einheit.",
  "Path data holds a number that is too large to be computed with; take another unit.":
    "Die Pfaddaten enthalten eine Zahl, die zum Rechnen zu groß ist; nehmen Sie eine andere Einheit.",
};
