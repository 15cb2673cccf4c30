/** What the page says of the tools to draw with. */
export const words = {
  group: "Tool",
  draw: { label: "Draw", help: "Draw, bend and move shapes" },
  pin: { label: "Pin", help: "Tie a point of the reference to a point of the template" },
  drawFirst: "Draw a closed curve on either side.",
  drawOn: "Draw, pull a curve to bend it, or take its round grip to move it.",
};
