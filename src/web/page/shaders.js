// What the graphics card computes. Places come relative to the drawing's middle; `view` turns and scales them to the screen.
// A level lies before every lower one, so that bridges cover what passes below.
const COMMON = `#version 300 es
precision highp float;
uniform vec4 view;      // middle of the screen, then cosine and sine of the turn times the scale
uniform vec2 screen;    // half its size in pixels
uniform float lowest;   // level
uniform vec4 colors[64];
vec2 pixels(vec2 p) {
  vec2 d = p - view.xy;
  return vec2(view.z * d.x - view.w * d.y, view.w * d.x + view.z * d.y);
}
float depth(uint paint, float rank) {
  return max(0.98 - (float(paint >> 8) - lowest) * 4e-3 - rank * 1e-3, -0.99);
}
`;

const AREA_VERTEX = COMMON + `
layout(location = 0) in vec3 place;
layout(location = 1) in uint paint;
uniform vec2 heights;   // lowest, and one over the span; 0 for colours by type
uniform float alpha;    // 1 for what covers, else of the layer
out vec4 color;
out vec2 ground;
out float share;        // of the heights; below 0 for a colour by type
flat out uint kind;
void main() {
  kind = paint & 255u;
  ground = place.xy;
  color = colors[kind];
  share = heights.y > 0.0 && kind <= 10u ? clamp((place.z - heights.x) * heights.y, 0.0, 1.0) : -1.0;
  float rank = kind == 0u ? 0.0 : kind == 10u ? 2.0 : 1.0;
  gl_Position = vec4(pixels(place.xy) / screen, alpha < 1.0 ? depth(paint, 3.0) : depth(paint, rank), 1.0);
}`;

const AREA_FRAGMENT = `#version 300 es
precision highp float;
in vec4 color;
in vec2 ground;
in float share;
flat in uint kind;
uniform float alpha;
uniform uint hatched;   // paint with stripes of a metre
uniform float metre;    // in pixels
out vec4 result;
// From dark blue over green to yellow: rises in lightness. Pixel by pixel, because a long slope has corners at its ends only.
vec3 shade(float h) {
  vec3 a = vec3(0.27, 0.0, 0.33), b = vec3(0.13, 0.57, 0.55), c = vec3(0.99, 0.91, 0.15);
  return h < 0.5 ? mix(a, b, h * 2.0) : mix(b, c, h * 2.0 - 1.0);
}
void main() {
  float a = alpha < 1.0 ? color.a : 1.0;
  // At a triangle's edge a varying may lie beyond those of its corners.
  vec3 rgb = share < -0.5 ? color.rgb : shade(clamp(share, 0.0, 1.0));
  if (kind == hatched && metre > 0.0) {
    float stripe = fract((ground.x + ground.y) * 0.5);
    a *= stripe < 0.5 ? 1.5 : 0.5;
  }
  result = vec4(rgb * a, a);
}`;

// A piece of a line, by the number of its corner.
const PIECES = COMMON + `
uniform highp usampler2D pieces;     // three texels each
uniform int first;                   // the piece of corner 0
uniform int row;                     // pieces in a row
uvec4 part(int number) {
  int piece = first + gl_VertexID / 4;
  return texelFetch(pieces, ivec2(piece % row * 3 + number, piece / row), 0);
}
`;

const STROKE_VERTEX = PIECES + `
uniform float thinnest;              // pixels
uniform vec4 tint;                   // in place of the paint, if it can be seen
out vec4 color;
out vec2 at;                         // pixels along and across
flat out vec2 size;                  // length and half width in pixels
flat out vec3 dashes;                // pixels
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1);
  vec4 ends = uintBitsToFloat(part(0)), look = uintBitsToFloat(part(1));   // along, width, dash, gap
  vec2 from = ends.xy, to = ends.zw;
  uint paint = part(2).x;
  float scale = length(view.zw);
  vec2 a = pixels(from), b = pixels(to);
  vec2 ahead = b - a;
  float span = length(ahead);
  ahead = span > 0.0 ? ahead / span : vec2(1.0, 0.0);
  float wide = look.y * scale;
  float half_width = 0.5 * max(wide, thinnest);
  float reach = half_width + 1.0;
  at = vec2(mix(-reach, span + reach, corner.x), mix(-reach, reach, corner.y));
  size = vec2(span, half_width);
  dashes = vec3(look.x, look.z, look.w) * scale;
  color = tint.a > 0.0 ? tint : colors[paint & 255u];
  // Thinner than a pixel is fainter than its colour.
  if (look.y > 0.0) color.a *= clamp(wide / thinnest, 0.35, 1.0);
  vec2 p = a + ahead * at.x + vec2(-ahead.y, ahead.x) * at.y;
  gl_Position = vec4(p / screen, depth(paint, 3.0), 1.0);
}`;

const STROKE_FRAGMENT = `#version 300 es
precision highp float;
in vec4 color;
in vec2 at;
flat in vec2 size;
flat in vec3 dashes;
out vec4 result;
void main() {
  float edge;
  float share = 1.0;
  if (dashes.z > 0.0) {
    float period = dashes.y + dashes.z;
    float phase = mod(dashes.x + at.x, period);
    float inside = min(phase, dashes.y - phase);
    // Too small to be seen one by one: as much of the colour as they cover.
    share = period < 4.0 ? dashes.y / period : clamp(inside + 0.5, 0.0, 1.0);
    edge = max(abs(at.y) - size.y, max(-at.x, at.x - size.x));
  } else {
    edge = length(vec2(at.x - clamp(at.x, 0.0, size.x), at.y)) - size.y;
  }
  float a = color.a * share * clamp(0.5 - edge, 0.0, 1.0);
  if (a < 0.004) discard;
  result = vec4(color.rgb * a, a);
}`;

// A signal: a picture that faces the screen, with a short stroke to where its face looks.
const SIGN_VERTEX = PIECES + `
uniform float radius;   // pixels
out vec2 at;
flat out uint kind;
flat out vec2 facing;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1) * 2.0 - 1.0;
  vec4 ends = uintBitsToFloat(part(0));
  vec2 from = ends.xy, to = ends.zw;
  uint paint = part(2).x;
  float reach = radius * 1.9;
  kind = paint & 255u;
  at = corner * 1.9;
  vec2 way = pixels(to) - pixels(from);
  facing = length(way) > 0.0 ? normalize(way) : vec2(0.0);
  gl_Position = vec4((pixels(from) + corner * reach) / screen, depth(paint, 3.0), 1.0);
}`;

const SIGN_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at;
flat in uint kind;
flat in vec2 facing;
uniform float radius;
out vec4 result;
const vec3 RED = vec3(0.8, 0.13, 0.12), BLUE = vec3(0.06, 0.36, 0.72), WHITE = vec3(1.0), DARK = vec3(0.1, 0.11, 0.13);
float box(vec2 p, vec2 half_size) { vec2 d = abs(p) - half_size; return max(d.x, d.y); }
float triangle(vec2 p) { return max(abs(p.x) * 0.87 + p.y * 0.5, -p.y) - 0.5; }
float octagon(vec2 p) { p = abs(p); return max(max(p.x, p.y), (p.x + p.y) * 0.7071) - 0.92; }
vec4 layer(vec4 below, float distance, vec3 color) {
  float a = clamp(0.5 - distance * radius, 0.0, 1.0);
  return vec4(mix(below.rgb, color, a), max(below.a, a));
}
void main() {
  vec4 c = vec4(DARK, 0.0);
  float along = dot(at, facing), beside = abs(dot(at, vec2(-facing.y, facing.x)));
  c = layer(c, max(max(beside - 0.13, -along), along - 1.75), DARK);
  vec2 p = at;
  if (kind == 1u) {
    c = layer(c, box(p, vec2(0.55, 1.0)), DARK);
    c = layer(c, length(p - vec2(0.0, 0.6)) - 0.27, vec3(1.0, 0.27, 0.22));
    c = layer(c, length(p) - 0.27, vec3(1.0, 0.8, 0.2));
    c = layer(c, length(p + vec2(0.0, 0.6)) - 0.27, vec3(0.2, 0.85, 0.4));
  } else if (kind == 2u) {
    c = layer(c, octagon(p), WHITE);
    c = layer(c, octagon(p * 1.15), RED);
    c = layer(c, box(p, vec2(0.55, 0.13)), WHITE);
  } else if (kind == 3u || kind == 8u) {
    vec2 q = vec2(p.x, kind == 3u ? -p.y : p.y) * 0.95;
    c = layer(c, triangle(q), RED);
    c = layer(c, triangle(q * 1.75), WHITE);
  } else if (kind == 4u) {
    c = layer(c, abs(p.x) + abs(p.y) - 1.15, DARK);
    c = layer(c, abs(p.x) + abs(p.y) - 1.05, WHITE);
    c = layer(c, abs(p.x) + abs(p.y) - 0.68, vec3(1.0, 0.78, 0.1));
  } else if (kind == 5u) {
    c = layer(c, length(p) - 0.95, RED);
    c = layer(c, length(p) - 0.66, WHITE);
  } else if (kind == 6u) {
    c = layer(c, length(p) - 0.95, RED);
    c = layer(c, box(p, vec2(0.6, 0.16)), WHITE);
  } else if (kind == 7u) {
    c = layer(c, length(p) - 0.95, WHITE);
    c = layer(c, length(p) - 0.86, BLUE);
    c = layer(c, box(p - vec2(0.0, -0.1), vec2(0.13, 0.45)), WHITE);
    c = layer(c, triangle((p - vec2(0.0, 0.35)) * 1.6), WHITE);
  } else if (kind == 9u) {
    c = layer(c, box(p, vec2(0.85)), WHITE);
    c = layer(c, box(p, vec2(0.76)), BLUE);
  } else if (kind == 10u) {
    c = layer(c, box(p, vec2(0.8, 0.3)), DARK);
    c = layer(c, box(p, vec2(0.7, 0.2)), WHITE);
  } else {
    c = layer(c, length(p) - 0.6, WHITE);
    c = layer(c, length(p) - 0.5, vec3(0.45, 0.48, 0.52));
  }
  if (c.a < 0.004) discard;
  result = vec4(c.rgb * c.a, c.a);
}`;
