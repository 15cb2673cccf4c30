/** Was in den Dateien der Seite selbst steht, Absatz für Absatz. */

import type { FileWords } from "../book";

const change = { textContent: "English", lang: "en" };
const root = { lang: "de" };

const footer = {
  innerHTML:
    'thinshell, nach Wahl unter MIT oder Apache-2.0. <a href="./licences.html">Lizenzen dessen, woraus diese Seite besteht</a>',
};

const paper =
  '<a href="https://doi.org/10.2312/PE.VMV.VMV13.089-096"><cite lang="en">A Thin Shell Approach to the Registration of Implicit Surfaces</cite></a>';

export const indexFile: FileWords = {
  root,
  change,
  title: { textContent: "thinshell: elastischer Abgleich zweier Kurven" },
  description: {
    content:
      "Zeichnen Sie zwei geschlossene Kurven und sehen Sie zu, wie die erste in die zweite verformt wird: elastische Registrierung mit Energien dünner Schalen, berechnet in Ihrem Browser.",
  },
  prose: [
    { innerHTML: "Elastischer Abgleich zweier Kurven" },
    {
      innerHTML:
        'Zeichnen Sie zwei Kurven: Die Ebene, mit einer dünnen Schale entlang der ersten, wird verformt, bis diese auf der zweiten liegt. <a href="./lessons.html">Lektionen</a>',
    },
    { innerHTML: "Was Sie sehen" },
    {
      innerHTML:
        "Die Farbe läuft einmal um die Referenz, gleichmäßig nach der Bogenlänge. Jeder Punkt behält unterwegs seine Farbe: <strong>Gleiche Farben sind einander zugeordnete Punkte.</strong> Das Gitter zeigt, was mit der Ebene ringsum geschieht: Keine Zelle faltet sich je. Was sonst gezeichnet ist, steht unter dem Bild, zu jeder Ansicht.",
    },
    {
      innerHTML:
        "Eine <em>Zelle</em> ist der Gitterabstand des feinsten Gitters: auf 129 × 129 Knoten einige Pixel des Bildes. Das kleinste Flächenverhältnis ist der kleinste Faktor, um den eine Ecke einer Zelle schrumpft; es bleibt über null.",
    },
    { innerHTML: "Wie es geht" },
    {
      innerHTML:
        "Mit den vorzeichenbehafteten Abständen <math><msub><mi>d</mi><mn>1</mn></msub></math> und <math><msub><mi>d</mi><mn>2</mn></msub></math> zu den beiden Kurven minimiert die Verformung <math><mi>φ</mi></math>",
    },
    {
      innerHTML: `Nahe der Referenz, wo <math><mi>η</mi></math> nicht null ist, wehrt sich der erste Term gegen Streckung entlang der Kurve, der zweite gegen eine Änderung ihrer Krümmung, der dritte zieht die Kurve auf das Ziel, und <math><msub><mi>W</mi><mtext>tan</mtext></msub></math> hält sie längs des Ziels, nicht in Wellen um es herum. Der letzte hält die Ebene zusammen, außerhalb der Referenz mit dem <math><mi>ζ</mi></math>-fachen Gewicht. Das Minimum wird zuerst auf einem groben Gitter gesucht, dann auf immer feineren. Das Verfahren stammt von J. A. Iglesias, B. Berkels, M. Rumpf und O. Scherzer, ${paper}, <span lang="en">Vision, Modeling and Visualization</span> 2013. Die Experimente des Artikels lassen sich <a href="./experiments.html">hier berechnen</a>.`,
    },
    { innerHTML: "Zeichnen" },
    {
      innerHTML:
        "Ein Strich schließt sich von selbst. Weitere Striche fügen Teile hinzu oder, wenn sie innen liegen, Löcher. Kreuzt sich ein Strich, umschließt er nichts oder verlässt er das Quadrat, fragt die Seite nach. Ziehen Sie die Kurve irgendwo, um sie zu biegen; nehmen Sie den runden Griff, um die ganze Form zu verschieben; mit zwei Fingern verschieben, drehen und skalieren Sie sie. Die zuletzt gedrückte Kurve glättet der Regler. <strong>Kreis</strong> wird aus seiner Mitte aufgezogen, <strong>Vieleck</strong> nimmt Ecke für Ecke, und <strong>Spiegel</strong> ergänzt die gezeichnete Hälfte zum Ganzen. Eine <strong>Nadel</strong> heftet einen Punkt der Referenz an einen Punkt des Ziels, und der Abgleich führt den einen in den anderen. Alles lässt sich rückgängig machen, und die Adresse dieser Seite enthält stets Ihre Formen. Mit <strong>Live</strong> folgt der Abgleich Ihrer Hand.",
    },
    { innerHTML: "Mit der Tastatur" },
    {
      innerHTML:
        "Auf einer fokussierten Form: Pfeiltasten verschieben sie (mit der Umschalttaste in kleinen Schritten), <kbd>+</kbd> und <kbd>−</kbd> skalieren, <kbd>[</kbd> und <kbd>]</kbd> drehen, <kbd>Entf</kbd> leert, <kbd>Strg</kbd> <kbd>Z</kbd> macht rückgängig.",
    },
    {
      innerHTML:
        "Mit <strong>Vieleck</strong>, <strong>Spiegel</strong> und <strong>Kreis</strong>, auf einer fokussierten Form: Pfeiltasten bewegen einen Zeiger (mit der Umschalttaste in kleinen Schritten), die <kbd>Eingabetaste</kbd> oder die <kbd>Leertaste</kbd> setzt einen Punkt, die <kbd>Eingabetaste</kbd> auf dem ersten oder letzten Punkt schließt den Umriss, <kbd>Bild ab</kbd> und <kbd>Bild auf</kbd> gehen von Punkt zu Punkt, die <kbd>Leertaste</kbd> nimmt einen auf und setzt ihn ab, <kbd>Entf</kbd> löscht ihn, <kbd>Esc</kbd> verwirft. <strong>Punkte</strong> tut dasselbe mit einer fertigen Kurve, auf der die <kbd>Eingabetaste</kbd> einen Punkt hinzufügt.",
    },
    {
      innerHTML:
        "Mit <strong>Nadel</strong>, auf einer fokussierten Form: Pfeiltasten bewegen einen Zeiger (mit der Umschalttaste in kleinen Schritten), die <kbd>Eingabetaste</kbd> setzt hier einen Punkt und dort seinen Partner, <kbd>Bild ab</kbd> und <kbd>Bild auf</kbd> gehen von Nadel zu Nadel, die <kbd>Eingabetaste</kbd> nimmt eine auf und setzt sie ab, <kbd>Entf</kbd> löscht sie, <kbd>Esc</kbd> verwirft.",
    },
    {
      innerHTML:
        "Auf dem fokussierten Ergebnis gehen Pfeiltasten die Kurve entlang und zeigen die Zahlen an jedem Punkt; <kbd>Esc</kbd> beendet das.",
    },
    footer,
  ],
};

export const experimentsFile: FileWords = {
  root,
  change,
  title: { textContent: "thinshell: die Experimente des Artikels" },
  description: {
    content:
      "Die Experimente von „A Thin Shell Approach to the Registration of Implicit Surfaces“, auf Kurven übertragen und in Ihrem Browser berechnet.",
  },
  prose: [
    { innerHTML: "Die Experimente des Artikels" },
    {
      innerHTML:
        'Jedes Experiment des Artikels, auf Kurven der Ebene übertragen und hier berechnet, während Sie zusehen. <a href="./index.html">Eigene Formen zeichnen und abgleichen</a>',
    },
    footer,
  ],
};

export const lessonsFile: FileWords = {
  root,
  change,
  title: { textContent: "thinshell: Lektionen" },
  description: {
    content:
      "Kurze Lektionen über den elastischen Abgleich von Kurven und Flächen, jede mit einem lebenden Bild zum Vorhersagen und Ausprobieren.",
  },
  prose: [
    { innerHTML: "Lektionen" },
    {
      innerHTML:
        'Der elastische Abgleich in kurzen Schritten, jeder neben einem lebenden Bild; die Texte der Lektionen sind Englisch. <a href="./index.html">Eigene Formen zeichnen und abgleichen</a>',
    },
    footer,
  ],
};
