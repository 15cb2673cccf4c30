/** Die Seite der Experimente; was die Läufe selbst schreiben, ist Englisch. */

import type { Book } from "../book";

export const experiments: Book["experiments"] = {
  lists: { curves: "Experimente mit Kurven", surfaces: "Experimente mit Flächen" },
  paper: "Im Artikel.",
  here: "Hier.",
  open: "In der Seite öffnen",
  cancel: "Abbrechen",
  compute: "Berechnen",
  inFull: "Vollständig berechnen",
  of: (what, title) => `${what}: ${title}`,
  part: (title, number) => `${title}, Teil ${number}`,
  failed: (why) =>
    `Das Experiment ist gescheitert: ${why}. Berechnen Sie es noch einmal; scheitert es wieder, laden Sie die Seite neu.`,
  doing: (percent, what) => `${percent} %: ${what}`,
  beforehand:
    "Vorab berechnet; was Sie hier berechnen, tritt an seine Stelle. Was ein Lauf selbst schreibt, ist Englisch.",
  done: (seconds, short) => `Berechnet in ${seconds}${short ? ", auf kleinen Gittern" : ""}.`,
  saveSvg: "Als SVG speichern",
  table: (name) => `Tabelle: ${name}`,
};

export const experimentTexts: Book["experimentTexts"] = {
  strain: {
    title: "Tabelle 1: Die Streckung gleicht sich mit der Verfeinerung aus",
    paper:
      "Ein Kreis wird mit einer Ellipse von 2,38-fachem Umfang abgeglichen, auf 33² bis 513² Knoten. Mit der dünnen Schale halbiert jede Verfeinerung die Standardabweichung der tangentialen Streckung: 0,1758, 0,0875, 0,0440, 0,0234, 0,0143. Mit der Volumenenergie allein, Gl. (9), bleibt sie nahe 0,8, wie fein das Gitter auch ist.",
    setup:
      "Ein Kreis vom Radius 0,12 und eine Ellipse mit den Halbachsen 0,4106 und 0,12, sodass das Verhältnis der Umfänge 2,38 ist; beide in der Mitte des Einheitsquadrats. Schale: α_bend = 0, σ = 0,04, sonst die Einstellungen des Artikels. Nur Volumen: ξ = 1, ζ = 10⁻³, 1/ε = 10⁵ auf allen Stufen, α_mem = α_bend = 0, einmal mit θ = 0 und einmal mit θ = 0,25. Toleranz 10⁻⁷. Jede Zeile ist das Ende einer eigenen Kaskade, ab 17², für θ = 0,25 ab 9². Gemessen wird die nach Fläche gewichtete Standardabweichung von l = |Dφ t| über alle Gauß-Punkte mit |d₁| < h, wobei t die Tangente des Abstandskreises durch den Punkt ist.",
  },
  grids: {
    title: "Abb. 4: die verformten Gitter",
    paper:
      "Der Abgleich des Kreises mit der Ellipse, einmal allein mit der Volumenenergie und einmal mit der dünnen Schale. Die Volumenenergie zieht das Gitter an den Spitzen aus und lässt den Rest, wie er ist; die Schale verteilt die Streckung gleichmäßig entlang der Kurve.",
    setup:
      "Formen und Einstellungen der Tabelle 1 auf 65² Knoten, Volumenenergie mit Eckenanteil θ = 0 und 0,25. Gezeichnet ist jede zweite Gitterlinie; Striche verbinden gleichmäßig verteilte Punkte des Kreises mit ihren Partnern.",
  },
  crumpling: {
    title: "Abb. 5: Zerknittern bei starkem Schrumpfen",
    paper:
      "Auf 33² Knoten schrumpft ein Kreis, der mit einem viel kleineren abgeglichen wird, nicht: Er legt sich innerhalb des Bandes in Wellen und behält viel von seiner Länge. Der Abstandsterm kann eine glatte Kurve nicht von einer zerknitterten unterscheiden, wenn sie einander näher sind, als das Gitter auflöst.",
    setup:
      "Ein Kreis vom Radius 0,3 auf einen im angegebenen Verhältnis kleineren, erst 17², dann 33² Knoten, Einstellungen des Artikels mit α_bend = 0 und 1; dieselben mit der Stauchung entlang des Ziels gemessen (projected); und die Voreinstellungen. Gemessen wird die Länge der zugeordneten Kurve durch den Umfang des kleinen Kreises, weniger 1.",
  },
  rotation: {
    title: "Abb. 6 in 2D: ein gedrehtes Quadrat",
    paper:
      "Formen, die sich um eine Drehung unterscheiden: Mit der Biegeenergie (3) finden Ecken Ecken. Ohne sie, oder mit der mittleren Krümmung der Gl. (10) an ihrer Stelle, finden sie sie nicht.",
    setup:
      "Ein abgerundetes Quadrat, halbe Seite 0,12, Eckenradius 0,08, abgeglichen mit sich selbst, um 15°, 30°, 40° und 44,5° gedreht, von der Identität aus, sonst mit den Einstellungen des Artikels. Bei 45° ist der Anfang symmetrisch, und nichts unterscheidet links von rechts; deshalb ein halbes Grad weniger. Gemessen wird die Drehung, die die Punkte von M1 im Sinne kleinster Quadrate am besten auf ihre Partner bringt; beide Minimierer.",
  },
  cascade: {
    title: "Algorithmus 1: von grob zu fein",
    paper:
      "Verwickelte Flächen werden Stufe für Stufe abgeglichen, δ und ε jedes Mal halbiert (Abb. 7): Die groben Stufen finden die große Bewegung, die feinen die Einzelheiten.",
    setup:
      "Das Beispiel „Hand → gespreizte Hand“ der Seite mit den Einstellungen des Artikels: 17² bis 129² Knoten, der Zustand am Ende jeder Stufe. Dann die feinste Stufe allein, von der Identität aus: einmal mit δ und ε, wie sie die Kaskade dort hat, einmal mit denen, mit denen sie beginnt.",
  },
  metric: {
    title: "Die Metrik: L², Sobolev, Newton",
    paper:
      "Der Gradient wird in der Metrik (1 − β²/2 Δ)⁻¹ genommen, wobei β im Lauf der Suche halbiert wird: Große Bereiche bewegen sich zuerst gemeinsam. Der Artikel verwendet sie mit den Richtungen von Fletcher und Reeves und zeigt keinen Vergleich.",
    setup:
      "Ein Kreis vom Radius 0,2 auf eine Ellipse mit den Halbachsen 0,3 und 0,22, auf einer einzigen Stufe von 65² Knoten (33² in der Kurzform), von der Identität aus, mit δ und ε, wie sie eine Kaskade ab 17² dort hat, Toleranz 10⁻¹², höchstens 1500 Iterationen. β wird halbiert, sooft die Energie stockt, bis hinab zu h. Die erste Kurve beginnt bei β = h, wo die Metrik L² so nahe ist, wie es hier geht. Gezeigt wird die Energie abzüglich der kleinsten gefundenen, über den Iterationen und über der Zeit.",
  },
  sweep: {
    title: "Was ε, δ, σ, ξ und θ bewirken",
    paper: "Der Artikel nennt die Werte seiner Parameter, ohne sie zu untersuchen.",
    setup:
      "Das Beispiel „Hand → gespreizte Hand“ der Seite, 17² bis 65² Knoten, jeweils eine Einstellung geändert, die anderen wie im Artikel (1/ε = 10³, δ = 0,5, σ = 0,05, ξ = 10⁻³, θ = 0,25).",
  },
  spheres: {
    title: "Flächen, Tabelle 1: Das Flächenverhältnis wird mit der Verfeinerung gleichmäßiger",
    paper:
      "Ein Kreis wird mit einer 2,38-mal so langen Ellipse abgeglichen: Mit der dünnen Schale halbiert sich die Streuung der tangentialen Verzerrung mit jeder Verfeinerung, mit der Volumenenergie allein nimmt sie nicht ab.",
    setup:
      "Eine Kugel vom Radius 0,16 auf eine vom 2,38-fachen Flächeninhalt, beide in der Mitte des Würfels. Schale: α_bend = 0, σ = 0,05, sonst die Einstellungen des Artikels; nur Volumen: ξ = 1, ζ = 10⁻³, 1/ε = 10⁵ auf allen Stufen, α_mem = α_bend = 0. Jede Zeile ist das Ende einer eigenen Folge von Gittern ab 17³. Gemessen wird die Standardabweichung, nach dem Volumen, des Flächenverhältnisses |cof Dφ n| über alle Gauß-Punkte mit |d₁| < h, und die auf der abgeglichenen Fläche selbst.",
  },
  octahedron: {
    title: "Flächen, Abb. 6 (oben): ein gedrehtes Oktaeder",
    paper:
      "Ein gerundetes Oktaeder wird mit sich selbst, gedreht, abgeglichen. Mit dem relativen Formoperator (3) finden Kanten zu Kanten und Ecken zu Ecken; ohne Biegung, und mit der mittleren Krümmung von Gl. (10), nicht.",
    setup:
      "Die l¹-Kugel eines geglätteten Betrags, um die Achse durch zwei ihrer Ecken um 15°, 24°, 30° und 44,5° gedreht, von der Identität aus, mit den Einstellungen des Artikels. Bei 45° ist der Anfang symmetrisch, darum ein halbes Grad weniger. Gemessen wird die Drehung um diese Achse, die die Ecken des Netzes von M1 im Sinne der kleinsten Quadrate am besten zu ihren Partnern führt.",
  },
  unduloid: {
    title: "Flächen, Abb. 6 (unten): Abschnitte eines Unduloids",
    paper:
      "Zwei Abschnitte eines Unduloids, einer Fläche konstanter mittlerer Krümmung, der zweite entlang der Achse verschoben. Der relative Formoperator (3) unterscheidet Bauch und Hals und findet die Verschiebung; die mittlere Krümmung von Gl. (10) ist überall gleich und findet nichts.",
    setup:
      "Echte Unduloide, ihr Profil durch elliptische Integrale (Kenmotsu 1980): Abschnitte von 2,2 Perioden, durch Kugelkappen geschlossen, die sie berühren; im zweiten ist das Profil um 0,1 Perioden (0,0292 Längen des Würfels) verschoben, während die Enden bleiben. Von der Identität aus, mit den Einstellungen des Artikels. Gemessen wird, wie weit sich die Punkte des Bauches (bis zu einer viertel Periode von seiner weitesten Stelle) entlang der Achse bewegt haben, durch die Verschiebung.",
  },
  figure: {
    title: "Flächen, Abb. 7: Stufe um Stufe",
    paper:
      "Eine Fläche mit vielen Einzelheiten wird auf 17³ bis 129³ Knoten mit sich selbst in anderer Haltung abgeglichen; Bilder nach jeder Stufe zeigen, dass Glieder zuerst und Einzelheiten zuletzt gefunden werden.",
    setup:
      "Eine Figur aus runden Gliedern und dieselbe Figur, winkend (beide aus der Galerie der Seite), 17³ bis 65³ Knoten in einer Folge von der Identität aus, mit den üblichen Gewichten. Gezeigt und gemessen wird der Abgleich am Ende jeder Stufe.",
  },
  pairs: {
    title: "Flächen, Abb. 8 und 9: dünne Schale gegen Volumen allein",
    paper:
      "Paare von Flächen mit vielen Einzelheiten werden als dünne Schale und mit der Volumenenergie allein abgeglichen. Beides bringt die eine Fläche auf die andere; nur die Schale führt Merkmale zu Merkmalen.",
    setup:
      "Paare aus der Galerie der Seite und eines mit bekannter Zuordnung, von der Identität aus, mit den üblichen Gewichten; „nur Volumen“ lässt Membran, Biegung und den H¹-Teil der Abweichung weg. Abstände in beide Richtungen: von der bewegten Referenz zum Ziel und vom Ziel zur bewegten Referenz; die kleinste Determinante ist eine sichere Schranke (Bernstein-Koeffizienten). Das Flächenverhältnis ist das der abgeglichenen Fläche.",
  },
  truth: {
    title: "Flächen, über den Artikel hinaus: eine bekannte Zuordnung",
    paper: "Der Artikel beurteilt Zuordnungen nach dem Augenschein.",
    setup:
      "Eine Kugel mit Beulen und dasselbe Netz, durch eine Formel bewegt: verdreht, gebogen, gebaucht. Die Nummern sagen, wohin jede Ecke gehört; der Löser sieht nur zwei Flächen. Übliche Einstellungen. Fehler: der Abstand des Bildes einer Ecke von der gleichen Nummer, in Längen des Würfels; Anteil: der mittlere Fehler des Abgleichs durch den der Identität.",
  },
};
