// Colours by name of paint: light theme, dark theme, opacity. Lane types differ in lightness as well as in hue, so that they can
// be told apart without seeing colours. A test holds that what is chosen, what an overlay says and the line of a route differ from each other and from lanes
// with protanopia, deuteranopia and tritanopia, too.
const COLORS = {
  "none": ["#dcdfd7", "#1d2225", 1],
  "other lane": ["#c6c8c4", "#33383c", 1],
  "edge": ["#b3b8b2", "#3b4347", 1],
  "median": ["#b4cf9f", "#2f4a33", 1],
  "walking": ["#e3d5b8", "#6b6250", 1],
  "biking": ["#c9826b", "#8a4f3e", 1],
  "parking": ["#9db4d3", "#3f5674", 1],
  "rail": ["#8d7a66", "#5e4f40", 1],
  "bus": ["#a597b8", "#5d5075", 1],
  "road works": ["#e0a93f", "#94701f", 1],
  "driving": ["#868c94", "#4d555d", 1],
  "border": ["#474c53", "#99a3ac", 0.5],
  "border in junction": ["#5d636b", "#8b949c", 0.28],
  "reference line": ["#c8650a", "#ff9f43", 0.9],
  "direction": ["#ffffff", "#cfd6dc", 0.55],
  "white mark": ["#ffffff", "#f4f6f7", 1],
  "yellow mark": ["#ffd21f", "#ffd21f", 1],
  "blue mark": ["#1f6fe0", "#5aa2ff", 1],
  "green mark": ["#1f9d4d", "#45c97a", 1],
  "red mark": ["#d4342c", "#ff6a60", 1],
  "black mark": ["#111111", "#000000", 1],
  "orange mark": ["#f08a1d", "#ffa447", 1],
  "violet mark": ["#8a46c8", "#b583ea", 1],
  "object": ["#5a4a9c", "#9d8ff0", 0.3],
  "object outline": ["#44368a", "#b3a8f5", 0.9],
  "crosswalk": ["#ffffff", "#ffffff", 0.55],
  "crosswalk outline": ["#ffffff", "#ffffff", 0.9],
  "stop line": ["#ffffff", "#ffffff", 1],
  "left out": ["#d21f1f", "#ff4d4d", 0.22],
  "left out outline": ["#c01515", "#ff6b6b", 1],
  "conflict": ["#d400a8", "#ff5fd7", 0.8],
  "index box": ["#0a8f52", "#2bd98a", 0.55],
  "chosen": ["#0d43e0", "#517efc", 0.85],
  "next": ["#066b7a", "#00ede7", 0.85],
  "before": ["#512705", "#562000", 0.85],
  "other": ["#ba73fc", "#4a00cc", 0.85],
  "route": ["#a60056", "#c7539f", 1],
  "corridor": ["#a60056", "#c7539f", 0.25],
  "corridor edge": ["#a60056", "#c7539f", 0.8],
  "closed": ["#dd3536", "#eb544c", 1],
  "opened": ["#547e3f", "#a1f484", 1],
  "slower": ["#e36f06", "#f08827", 1],
  "told": ["#f1d43f", "#dbd224", 1],
};

// Lanes by type, as the legend lists them.
const LEGEND = ["driving", "bus", "biking", "walking", "parking", "edge", "median", "rail", "road works", "other lane", "none"];

// What an overlay says, as the legend lists it.
const TODAY = [["closed", "closed"], ["opened", "opened"], ["slower", "another speed"], ["told", "told of: wet, works, …"]];

function rgba(name, dark) {
  const [light, night, alpha] = COLORS[name] ?? ["#ff00ff", "#ff00ff", 1];
  const hex = dark ? night : light;
  return [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16) / 255).concat(alpha);
}
