/// The shaders that draw copies. All of them find their copy in the same way, so their depths agree to the last bit and
/// one pass can rely on another's.

/// A copy's slot stands in `list` at the mesh's base plus the number of the instance. Its texels in `copyData` are the
/// three rows of its transform and its colour, in linear light, with how far it has faded in.
const findCopy = /* glsl */ `
uniform highp usampler2D list;
uniform highp sampler2D copyData;
invariant gl_Position;
out vec3 vWorld;
out vec3 vNormal;
flat out vec4 vTint;
flat out uint vEntry;

void main() {
  // modelMatrix holds no place but where the part's copies begin in the list: three.js hands it over for every mesh
  // anyway, and a uniform of our own would make it look through all others again for each of thousands of parts.
  int number = int(modelMatrix[3][0]) + gl_InstanceID;
  vEntry = texelFetch(list, ivec2(number & 1023, number >> 10), 0).r;
  int texel = int(vEntry & 0x0fffffffu) * 4;
  ivec2 at = ivec2(texel & 1023, texel >> 10);
  vec4 local = vec4(position, 1.0);
  vec4 r0 = texelFetch(copyData, at, 0);
  vec4 r1 = texelFetch(copyData, at + ivec2(1, 0), 0);
  vec4 r2 = texelFetch(copyData, at + ivec2(2, 0), 0);
  vWorld = vec3(dot(r0, local), dot(r1, local), dot(r2, local));
  // Zero where the mesh has none. Copies are turned and scaled alike along all axes, so normals turn as points do.
  vNormal = vec3(dot(r0.xyz, normal), dot(r1.xyz, normal), dot(r2.xyz, normal));
  vTint = texelFetch(copyData, at + ivec2(3, 0), 0);
  gl_Position = projectionMatrix * (viewMatrix * vec4(vWorld, 1.0));
}
`;

export const copyVertex = findCopy;

const inputs = /* glsl */ `
in vec3 vWorld;
in vec3 vNormal;
flat in vec4 vTint;
flat in uint vEntry;
out vec4 colour;
`;

/// What the section cuts away is not drawn. The plane is outside all that matters while there is no section.
const cutAway = /* glsl */ `
uniform vec4 plane;
void cutAway() {
  if (dot(plane, vec4(vWorld, 1.0)) < 0.0) discard;
}
`;

/// sRGB's curve by three square roots, right to a third of a step of 255: powers cost software renderers dear.
const encode = /* glsl */ `
vec3 encode(vec3 c) {
  vec3 r = sqrt(clamp(c, 0.0, 1.0));
  vec3 q = sqrt(r);
  return max(vec3(0.0), 0.662002687 * r + 0.684122060 * q - 0.323583601 * sqrt(q) - 0.0225411470 * c);
}
`;

const lighting = /* glsl */ `
uniform vec3 eye;
uniform vec3 sun;
uniform highp sampler2DShadow sunDepth;
uniform mat4 sunMatrix;
uniform vec2 sunBias; // mm along the normal; a texel of the map
uniform highp sampler3D ambient;
uniform vec3 ambientCorner;
uniform vec3 ambientScale;
uniform float ambientCell;
uniform vec3 skyLight;
uniform vec3 groundLight;
uniform vec3 sunLight;

float inSun(vec3 p, vec3 n) {
  vec3 q = (sunMatrix * vec4(p + n * sunBias.x, 1.0)).xyz;
  // Each look mixes four texels by itself; two of them, aslant, are soft enough.
  vec3 t = vec3(0.7, 0.3, 0.0) * sunBias.y;
  return 0.5 * (texture(sunDepth, q + t) + texture(sunDepth, q - t));
}

vec3 lightAt(vec3 p, vec3 n) {
  float facing = dot(n, sun);
  float lit = facing > 0.0 ? facing * inSun(p, n) : 0.0;
  vec4 a = texture(ambient, (p + n * ambientCell - ambientCorner) * ambientScale);
  float open = clamp(a.a + 2.0 * dot(a.rgb - 0.5, n), 0.0, 1.0);
  open = mix(0.10, 1.0, open);
  vec3 sky = mix(groundLight, skyLight, n.z * 0.5 + 0.5);
  // A little light from the viewer, so that faces turned away from the sun still show their shape.
  float towards = max(0.0, dot(n, normalize(eye - p)));
  return open * (sky + 0.10 * towards) + lit * sunLight;
}
`;

const normal = /* glsl */ `
// The mesh's normal where it has one, else the facet's. Facets face the viewer, whichever way round the mesh is; the
// mesh's normal is on the facet's side.
vec3 surfaceNormal() {
  vec3 facet = cross(dFdx(vWorld), dFdy(vWorld));
  float size = dot(facet, facet);
  // A sliver seen edge on has no normal that could be computed.
  facet = size > 0.0 ? facet * inversesqrt(size) : normalize(eye - vWorld);
  if (dot(facet, eye - vWorld) < 0.0) facet = -facet;
  if (dot(vNormal, vNormal) < 1e-12) return facet;
  vec3 n = normalize(vNormal);
  return dot(n, facet) < 0.0 ? -n : n;
}
`;

export const solidFragment = /* glsl */ `${inputs}${cutAway}${encode}${lighting}${normal}
void main() {
  vec3 n = surfaceNormal();
  cutAway();
  colour = vec4(encode(vTint.rgb * lightAt(vWorld, n)), 1.0);
}
`;

/// Faint copies and those that fade in: drawn once all others are, over their own depths.
export const ghostFragment = /* glsl */ `${inputs}${cutAway}${encode}${lighting}${normal}
void main() {
  vec3 n = surfaceNormal();
  cutAway();
  colour = vec4(encode(vTint.rgb * lightAt(vWorld, n)) * vTint.a, vTint.a);
}
`;

export const depthFragment = /* glsl */ `${inputs}${cutAway}
void main() {
  cutAway();
  colour = vec4(0.0);
}
`;

/// Where the line of sight comes through the section plane to this fragment.
const throughPlane = /* glsl */ `
vec3 throughPlane(vec3 eye) {
  vec3 d = vWorld - eye;
  float there = dot(plane, vec4(vWorld, 1.0));
  float here = dot(plane, vec4(eye, 1.0));
  return eye + d * (here / min(here - there, -1e-6));
}
`;

/// An inner side, drawn as the cut face through which it is seen: in the copy's colour with lines at 45 degrees.
export const cutFragment = /* glsl */ `${inputs}${cutAway}${encode}${lighting}${throughPlane}
uniform float hatchStep;
void main() {
  vec3 p = throughPlane(eye);
  vec3 a = abs(plane.xyz);
  float across = (a.z > 0.5 ? p.x + p.y : a.y > 0.5 ? p.x + p.z : p.y + p.z) * 0.70711 / hatchStep;
  float width = max(fwidth(across), 1e-5);
  cutAway();
  // The line is a sixth of the step; where steps are finer than pixels it becomes an even tone.
  float wave = abs(fract(across) - 0.5);
  float line = 1.0 - smoothstep(0.083 - width * 0.75, 0.083 + width * 0.75, wave);
  line = mix(line, 0.17, clamp(width * 2.0 - 0.6, 0.0, 1.0));
  vec3 n = -plane.xyz;
  float facing = max(0.0, dot(n, sun));
  vec3 light = mix(groundLight, skyLight, n.z * 0.5 + 0.5) + 0.10 + facing * sunLight;
  vec3 tint = vTint.rgb * min(light, vec3(1.08));
  colour = vec4(mix(encode(tint), encode(tint * 0.45), line * 0.8), 1.0);
}
`;

/// Which pixels the outlined copies cover: red and green in sight and hidden for the accent, blue and alpha for the mark.
export const outlineFragment = /* glsl */ `${inputs}${cutAway}
uniform highp sampler2D sceneDepth;
uniform vec2 nearFar;
float distanceOf(float d) {
  return nearFar.x * nearFar.y / (nearFar.y - d * (nearFar.y - nearFar.x));
}
void main() {
  float own = distanceOf(gl_FragCoord.z);
  float slope = fwidth(own);
  cutAway();
  vec2 at = gl_FragCoord.xy / vec2(textureSize(sceneDepth, 0));
  float scene = distanceOf(texture(sceneDepth, at).r);
  bool seen = own <= scene + slope * 2.5 + own * 6e-4;
  bool mark = (vEntry & 0x10000000u) != 0u;
  vec2 kind = seen ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  colour = mark ? vec4(0.0, 0.0, kind) : vec4(kind, 0.0, 0.0);
}
`;

/// The same for inner sides seen through the cut.
export const outlineCutFragment = /* glsl */ `${inputs}${cutAway}
void main() {
  cutAway();
  bool mark = (vEntry & 0x10000000u) != 0u;
  colour = mark ? vec4(0.0, 0.0, 1.0, 0.0) : vec4(1.0, 0.0, 0.0, 0.0);
}
`;

/// A flat shape in the world, in one colour: the section plane's quad.
export const planeVertex = /* glsl */ `
invariant gl_Position;
void main() {
  gl_Position = projectionMatrix * (viewMatrix * (modelMatrix * vec4(position, 1.0)));
}
`;

/// All over the picture, as far away as depths go.
export const farVertex = /* glsl */ `
void main() {
  gl_Position = vec4(position.xy * 2.0, 1.0, 1.0);
}
`;

export const plainFragment = /* glsl */ `
out vec4 colour;
void main() {
  colour = vec4(0.0);
}
`;
