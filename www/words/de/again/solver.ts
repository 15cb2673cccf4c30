/** Was der Löser sagt: was an Formen und Einstellungen nicht geht (src/error.rs), und wie Flächen passen. */

import type { Patterns } from "../again";

const SMALLER = "machen Sie die Form kleiner, oder schieben Sie sie nach innen („Einpassen“ tut beides)";

export const solver: Patterns = {
  "the reference {problem}": "die Referenz {problem}",
  "the template {problem}": "das Ziel {problem}",
  "{name} is {value}, but must be {range}": "{name} ist {value}, muss aber {range} sein",
  "0 (automatic) or at least {least}, half a cell of the finest grid, or no quadrature point sees the shell; widen it or raise finest":
    "0 (automatisch) oder mindestens {least} (die Hälfte einer Zelle des feinsten Gitters, sonst sieht kein Quadraturpunkt die Schale)",
  "settings has no field {name}; {hint}": "es gibt keine Einstellung {name}; {hint}",
  "{name} holds {found} numbers, but {expected} are needed ({why})":
    "{name} hat {found} Zahlen, nötig sind {expected} ({why})",
  "{name} has a value that is not finite at position {position}; replace or remove it":
    "{name} hat an der Stelle {position} einen Wert, der nicht endlich ist; ersetzen oder entfernen Sie ihn",
  "finest = {finest} with these settings needs up to {gigabytes} GB of memory, more than there is; choose a smaller coarsest or finest level":
    "das feinste Gitter (Stufe {finest}) braucht mit diesen Einstellungen bis zu {gigabytes} GB Speicher, mehr, als da ist; wählen Sie ein gröberes",
  "the {term} energy is {value} before anything has moved, more than numbers of this precision can balance ({most} at most); choose smaller weights, or level sets that are distances":
    "die Energie des Terms „{term}“ ist {value}, bevor sich etwas bewegt hat, mehr, als Zahlen dieser Genauigkeit ausgleichen können (höchstens {most}); wählen Sie kleinere Gewichte, oder Abstandsfelder, die Abstände sind",
  'backend is "gpu", but {reason}; choose "auto" or "cpu"':
    "die Grafikkarte soll rechnen, aber {reason}; lassen Sie den Schnelleren oder den Prozessor rechnen",
  "there is no WebGPU here, which browsers reach graphics cards by":
    "hier gibt es kein WebGPU, über das Browser Grafikkarten erreichen",
  "the browser finds no graphics card to compute on": "der Browser findet keine Grafikkarte zum Rechnen",
  "the graphics card refuses to compute ({why})": "die Grafikkarte weigert sich zu rechnen ({why})",
  "the graphics card is none, the processor plays it ({name})":
    "die Grafikkarte ist keine, der Prozessor spielt sie ({name})",
  "on this grid the graphics card takes {card} ms for what takes the processor {processor} ms":
    "auf diesem Gitter braucht die Grafikkarte {card} ms, wozu der Prozessor {processor} ms braucht",
  "on this grid the processor is done before a graphics card would answer":
    "auf diesem Gitter ist der Prozessor fertig, ehe eine Grafikkarte antwortete",
  "the first step will tell whether the graphics card is faster":
    "der erste Schritt wird zeigen, ob die Grafikkarte schneller ist",
  "the graphics device was lost ({why})": "das Grafikgerät ging verloren ({why})",
  "the graphics device failed ({why})": "das Grafikgerät versagte ({why})",
  "the graphics device gives no answer": "das Grafikgerät antwortet nicht",
  membrane: "Streckung",
  bending: "Biegung",
  mismatch: "Abweichung",
  volume: "Volumen",
  pins: "Nadeln",

  "has no points; draw or load a closed curve": "hat keine Punkte; zeichnen oder laden Sie eine geschlossene Kurve",
  "has a loop of only {points} points (loop {index}); a closed curve needs at least three":
    "hat eine Kurve von nur {points} Punkten (Kurve {index}); eine geschlossene Kurve braucht mindestens drei",
  "has a coordinate that is not finite (loop {index}, point {point}); remove that point":
    "hat eine Koordinate, die nicht endlich ist (Kurve {index}, Punkt {point}); entfernen Sie diesen Punkt",
  "encloses no area; draw a curve that goes around something":
    "umschließt keine Fläche; zeichnen Sie eine Kurve, die um etwas herumgeht",
  "holds no node of the grid of {cells} cells a side; make it larger or choose a finer grid":
    "enthält keinen Knoten des Gitters von {cells} Zellen je Seite; machen Sie die Form größer, oder wählen Sie ein feineres Gitter",
  "is too thin for the grid of {cells} cells a side, which sees {share} % of its outline; make it thicker or choose a finer grid":
    "ist zu dünn für das Gitter von {cells} Zellen je Seite, das {share} % des Umrisses sieht; machen Sie die Form dicker, oder wählen Sie ein feineres Gitter",
  'leaves the box on the {side} ({coordinate} = {value}); make it smaller or move it inwards ("Fit" does both)': `ragt {side} über den Rand hinaus ({coordinate} = {value}); ${SMALLER}`,
  'comes within {cells} cells of the {side} border (at {coordinate} = {value}), at least {needed} are needed; make it smaller or move it inwards ("Fit" does both)': `kommt {side} dem Rand auf {cells} Zellen nahe (bei {coordinate} = {value}), nötig sind mindestens {needed}; ${SMALLER}`,
  left: "links",
  right: "rechts",
  bottom: "unten",
  top: "oben",
  front: "vorn",
  back: "hinten",
  "has a level set of {found} values, but {cells} cells a side in {dim}D make {expected} nodes":
    "hat ein Abstandsfeld von {found} Werten, aber {cells} Zellen je Seite in {dim}D ergeben {expected} Knoten",
  "has a level set of {cells} cells a side; a power of two from {least} to {most} is needed":
    "hat ein Abstandsfeld von {cells} Zellen je Seite; nötig ist eine Zweierpotenz von {least} bis {most}",
  "has a level set value that is not finite at node {node}; replace it":
    "hat ein Abstandsfeld mit einem Wert, der nicht endlich ist, am Knoten {node}; ersetzen Sie ihn",
  "has a level set without a sign change; it must be negative inside and positive outside":
    "hat ein Abstandsfeld ohne Vorzeichenwechsel; es muss innen negativ sein und außen positiv",
  "has a level set that is no distance: it climbs {slope} a unit of length at its zero set and reaches {greatest}, a distance 1 and less than 2; set redistance to true, or scale it":
    "hat ein Feld, das kein Abstand ist: Es steigt an seiner Nullmenge um {slope} je Längeneinheit und reicht bis {greatest}, ein Abstand um 1 und bis unter 2; skalieren Sie es",
  "has a mask of {found} pixels, but {width} × {height} = {expected} are needed":
    "hat eine Maske von {found} Pixeln, nötig sind aber {width} × {height} = {expected}",
  "has too many strokes that cross or lie close together (at most {most} crossings are handled); draw a simpler curve":
    "hat zu viele Striche, die sich kreuzen oder eng beieinander liegen (höchstens {most} Kreuzungen gehen); zeichnen Sie eine einfachere Kurve",
  "has an outline of more than {most} points; smooth it, or make the picture smaller":
    "hat einen Umriss von mehr als {most} Punkten; glätten Sie ihn, oder verkleinern Sie das Bild",

  "is too thin for the grid of {cells} cells a side, which sees {share} % of its surface and least of it at {at}; make it thicker or choose a finer grid":
    "ist zu dünn für das Gitter von {cells} Zellen je Seite, das {share} % der Fläche sieht, am wenigsten bei {at}; machen Sie die Form dicker, oder wählen Sie ein feineres Gitter",
  "has no triangles; load a closed mesh": "hat keine Dreiecke; laden Sie ein geschlossenes Netz",
  "has more than {most} triangles; simplify the mesh": "hat mehr als {most} Dreiecke; vereinfachen Sie das Netz",
  "has a vertex with a coordinate that is not finite (vertex {vertex}); remove or replace it":
    "hat eine Ecke mit einer Koordinate, die nicht endlich ist (Ecke {vertex}); entfernen oder ersetzen Sie sie",
  "has a triangle with vertex {index} (triangle {triangle}), but there are only {vertices} vertices, numbered from 0":
    "hat ein Dreieck mit der Ecke {index} (Dreieck {triangle}), aber es gibt nur {vertices} Ecken, gezählt von 0 an",
  "holds {found} numbers as its {name}, but {needed}": "hat {found} Zahlen als {name}, aber {needed}",
  "is open: {edges} edges belong to one triangle only, the largest hole is at {at}; close it, only small holes are closed by themselves":
    "ist offen: {edges} Kanten gehören nur zu einem Dreieck, das größte Loch ist bei {at}; schließen Sie es, denn nur kleine Löcher schließen sich von selbst",
  "encloses no volume; load a mesh that goes around something":
    "umschließt kein Volumen; laden Sie ein Netz, das um etwas herumgeht",

  "There is no match to go on from; press Match.":
    "Es gibt keinen Abgleich, von dem aus es weitergehen könnte; drücken Sie „Abgleichen“.",
  "Fits: nowhere more than {cells} cells off.": "Passt: nirgends mehr als {cells} Zellen daneben.",
  "Fits but the surface at {at} was not reached: it is {cells} cells away.":
    "Passt, aber die Fläche bei {at} wurde nicht erreicht: Der Abstand ist {cells} Zellen.",
  "Crumpled (measure {ratio}).": "Zerknittert (Flächenverhältnis {ratio}).",
  "Not resolved by this grid.": "Dieses Gitter löst die Form nicht auf.",
  "Does not fit.": "Passt nicht.",
  "The largest distance is {cells} cells: the surface at {at} was not reached.":
    "Der größte Abstand ist {cells} Zellen: Die Fläche bei {at} wurde nicht erreicht.",
  "The largest distance is {cells} cells, at {at}.": "Der größte Abstand ist {cells} Zellen, bei {at}.",
  "The reference is thinner than the grid at {at}; choose a finer one.":
    "Die Referenz ist bei {at} dünner, als das Gitter sieht; wählen Sie ein feineres.",
  "The target is thinner than the grid at {at}; choose a finer one.":
    "Das Ziel ist bei {at} dünner, als das Gitter sieht; wählen Sie ein feineres.",
  "{from} parts against {to}: no deformation takes the one shape to the other.":
    "{from} Teile gegen {to}: Keine Verformung führt die eine Form in die andere über.",
  "{from} part against {to}: no deformation takes the one shape to the other.":
    "{from} Teil gegen {to}: Keine Verformung führt die eine Form in die andere über.",
  "{from} handles against {to}: no deformation takes the one shape to the other.":
    "{from} Henkel gegen {to}: Keine Verformung führt die eine Form in die andere über.",
  "{from} handle against {to}: no deformation takes the one shape to the other.":
    "{from} Henkel gegen {to}: Keine Verformung führt die eine Form in die andere über.",
  "{count} part": "{count} Teil",
  "{count} parts": "{count} Teile",
  "{count} handle": "{count} Henkel",
  "{count} handles": "{count} Henkel",
  No: "Kein",
  no: "kein",
  One: "Ein",
  one: "ein",
  Two: "Zwei",
  two: "zwei",
  Three: "Drei",
  three: "drei",
  Four: "Vier",
  four: "vier",
  Five: "Fünf",
  five: "fünf",
  Six: "Sechs",
  six: "sechs",
};
