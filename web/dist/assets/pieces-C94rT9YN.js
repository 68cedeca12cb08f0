import{a1 as vt,a2 as Z,a3 as Wt,S as P,a4 as wt,G as W,D as st,a5 as H,a6 as U,a7 as Zt,a8 as yt,a9 as Ht,aa as Kt,ab as xt,ac as bt,ad as Mt,ae as Yt,f as ut,F as C,af as It,W as K,d as R,ag as dt,V as k,ah as G,ai as Y,aj as ft,ak as Qt,al as Xt,am as $,an as Lt,M as Bt,ao as Jt,ap as qt,aq as te,ar as Nt,as as ee,at as se,k as ne,w as ie,au as ae,av as Rt,aw as oe,ax as re,ay as $t,az as he,c as nt,I as le,e as ce,aA as ue,x as de,l as fe,aB as Ft,aC as kt,aD as me}from"./section-BqabMN7-.js";import{a as q,b as pe,d as ge,f as ve,r as we,g as At}from"./index-Cfpd6ssD.js";const ye=`
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
`,xe=ye,L=`
in vec3 vWorld;
in vec3 vNormal;
flat in vec4 vTint;
flat in uint vEntry;
out vec4 colour;
`,B=`
uniform vec4 plane;
void cutAway() {
  if (dot(plane, vec4(vWorld, 1.0)) < 0.0) discard;
}
`,mt=`
vec3 encode(vec3 c) {
  vec3 r = sqrt(clamp(c, 0.0, 1.0));
  vec3 q = sqrt(r);
  return max(vec3(0.0), 0.662002687 * r + 0.684122060 * q - 0.323583601 * sqrt(q) - 0.0225411470 * c);
}
`,pt=`
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
`,Ut=`
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
`,St=`${L}${B}${mt}${pt}${Ut}
void main() {
  vec3 n = surfaceNormal();
  cutAway();
  colour = vec4(encode(vTint.rgb * lightAt(vWorld, n)), 1.0);
}
`,be=`${L}${B}${mt}${pt}${Ut}
void main() {
  vec3 n = surfaceNormal();
  cutAway();
  colour = vec4(encode(vTint.rgb * lightAt(vWorld, n)) * vTint.a, vTint.a);
}
`,J=`${L}${B}
void main() {
  cutAway();
  colour = vec4(0.0);
}
`,Me=`
vec3 throughPlane(vec3 eye) {
  vec3 d = vWorld - eye;
  float there = dot(plane, vec4(vWorld, 1.0));
  float here = dot(plane, vec4(eye, 1.0));
  return eye + d * (here / min(here - there, -1e-6));
}
`,Fe=`${L}${B}${mt}${pt}${Me}
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
`,ke=`${L}${B}
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
`,Ae=`${L}${B}
void main() {
  cutAway();
  bool mark = (vEntry & 0x10000000u) != 0u;
  colour = mark ? vec4(0.0, 0.0, 1.0, 0.0) : vec4(1.0, 0.0, 0.0, 0.0);
}
`,Se=`
invariant gl_Position;
void main() {
  gl_Position = projectionMatrix * (viewMatrix * (modelMatrix * vec4(position, 1.0)));
}
`,De=`
void main() {
  gl_Position = vec4(position.xy * 2.0, 1.0, 1.0);
}
`,Dt=`
out vec4 colour;
void main() {
  colour = vec4(0.0);
}
`,it=128,Et={blending:Wt,blendSrc:Z,blendDst:vt,blendSrcAlpha:Z,blendDstAlpha:vt};function Ce(a,t){const e=(h,l,f=a)=>{const m=new P({glslVersion:W,vertexShader:xe,fragmentShader:h,uniforms:f,blending:H,side:st,...l});return Object.assign(m.defaultAttributeValues,{normal:[0,0,0]}),m},s=h=>new P({glslVersion:W,vertexShader:Se,fragmentShader:Dt,blending:H,side:st,...h}),n=h=>({stencilWrite:!0,stencilFunc:Yt,stencilFail:U,stencilZFail:h?bt:Mt,stencilZPass:h?bt:Mt}),i={stencilFail:U,stencilZFail:U,stencilZPass:U},r={colorWrite:!1,depthWrite:!1,depthTest:!1},o={...a,...t};return{solid:e(St,{side:xt}),solidBoth:e(St,{}),cutInner:e(Fe,{side:yt,...n(!0)}),cutOuter:e(J,{side:xt,...r,...n(!1)}),cutPlane:s({colorWrite:!1,depthFunc:wt,stencilWrite:!0,stencilFunc:Kt,stencilRef:it,...i}),forgetDepth:new P({glslVersion:W,vertexShader:De,fragmentShader:Dt,colorWrite:!1,depthFunc:wt}),ghostDepth:e(J,{colorWrite:!1}),ghost:e(be,{...Et,depthWrite:!1}),outline:e(ke,{depthTest:!1,depthWrite:!1,blending:Wt,blendEquation:Ht,blendSrc:Z,blendDst:Z},o),outlineInner:e(Ae,{side:yt,...n(!0)}),outlineErase:s({depthTest:!1,depthWrite:!1,stencilWrite:!0,stencilFunc:Zt,stencilRef:it,...i}),shadow:e(J,{colorWrite:!1})}}function ze(a){for(const t of Object.values(a))t.dispose()}function Oe({positions:a,indices:t}){const e=ut();for(let d=0;d+2<a.length;d+=3)for(let c=0;c<3;++c){const u=a[d+c];u<e[c]&&(e[c]=u),u>e[c+3]&&(e[c+3]=u)}const[s,n,i]=e;let r=0,o=0,h=0,l=0,f=0;for(let d=0;d+2<t.length;d+=3){const c=3*t[d],u=3*t[d+1],p=3*t[d+2],g=a[c]-s,w=a[c+1]-n,y=a[c+2]-i,v=a[u]-s-g,x=a[u+1]-n-w,S=a[u+2]-i-y,M=a[p]-s-g,D=a[p+1]-n-w,z=a[p+2]-i-y,F=x*z-S*D,A=S*M-v*z,b=v*D-x*M;r+=Math.sqrt(F*F+A*A+b*b)/2,o+=g*F+w*A+y*b,h+=F,l+=A,f+=b}const m=r>0?Math.hypot(h,l,f)/2/r:0;return{box:e,area:r,openness:m,insideOut:o<0}}function Te({positions:a,indices:t},e,s){const n=[],i=e/Math.max(1,s);if(!(i>0))return new Float32Array(0);let r=i/2,o=0;for(let h=0;h+2<t.length;h+=3){const l=3*t[h],f=3*t[h+1],m=3*t[h+2],d=(v,x)=>a[v+x],c=d(f,0)-d(l,0),u=d(f,1)-d(l,1),p=d(f,2)-d(l,2),g=d(m,0)-d(l,0),w=d(m,1)-d(l,1),y=d(m,2)-d(l,2);for(r+=Math.hypot(u*y-p*w,p*g-c*y,c*w-u*g)/2;r>=i;){r-=i,o+=1;let v=o*.7548776662466927%1,x=o*.5698402909980532%1;v+x>1&&(v=1-v,x=1-x),n.push(d(l,0)+v*c+x*g,d(l,1)+v*u+x*w,d(l,2)+v*p+x*y)}}return new Float32Array(n)}const Pe={view1:"#fbfcfd",view2:"#e9ecf1",surface:"#ffffff",line:"#e2e5ea",text:"#171b21",text2:"#4a5360",accent:"#2a5bd7",onAccent:"#ffffff",rim:"#ffffff",warnMark:"#e0a030",bad:"#d84a3c",stay:"#b9c0ca",select:"#8fb0ff",edge:"#5a6270",shadow:"#1a2233",axes:{x:"#b3261e",y:"#17704a",z:"#2a5bd7"},glass:"#7d8aa0"},We={view1:"#272e38",view2:"#14181e",surface:"#161a20",line:"#2a313a",text:"#e8ebef",text2:"#b3bbc6",accent:"#84a8ff",onAccent:"#0b1530",rim:"#ffffff",warnMark:"#e0a030",bad:"#ff938a",stay:"#5d6672",select:"#3f5fb3",edge:"#a4acb8",shadow:"#000308",axes:{x:"#ff938a",y:"#62cd97",z:"#84a8ff"},glass:"#94a5c0"};function at(a){return a==="dark"?We:Pe}const Ie=`
void main() {
  gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
}
`,Le=`
uniform sampler2D scene;
uniform highp sampler2D depth;
uniform sampler2D outlines;
uniform bool hasOutlines;
uniform vec2 pixel; // of the canvas, in texture units
uniform float ratio; // device pixels a CSS pixel
uniform vec2 nearFar;
uniform float reach; // mm: depth that counts as a full step
uniform vec3 accent;
uniform vec3 mark;
uniform vec3 rim;
uniform vec2 through; // how strongly what is hidden is seen: of the accent, of the mark
out vec4 colour;

float distanceAt(vec2 at) {
  float d = texture(depth, at).r;
  return nearFar.x * nearFar.y / (nearFar.y - d * (nearFar.y - nearFar.x));
}

// How far a point lies behind the line between two opposite neighbours: above 0 in dents and behind edges, below on
// ridges. On a plane it is 0, however it slopes.
float behind(vec2 at, float own, vec2 offset) {
  float a = distanceAt(at + offset);
  float b = distanceAt(at - offset);
  return clamp((own - 0.5 * (a + b)) / reach, -0.35, 1.0);
}

vec4 line(vec2 kind, float least, float most, vec3 tint, vec4 under) {
  // In sight: the line inside the edge, the rim outside it.
  float inner = kind.x * (1.0 - least);
  float outer = (1.0 - kind.x) * most;
  vec4 c = mix(under, vec4(tint, 1.0), inner);
  return mix(c, vec4(rim, 1.0), outer * 0.95);
}

void main() {
  vec2 at = gl_FragCoord.xy * pixel;
  vec4 c = texture(scene, at);
  // Depths lie coarser than pixels while moving on a slow machine: neighbours must be other texels.
  vec2 texel = 1.0 / vec2(textureSize(depth, 0));
  vec2 there = (floor(at / texel) + 0.5) * texel;
  float own = distanceAt(there);
  if (own < nearFar.y * 0.9999) {
    vec2 p = max(pixel * ratio, texel);
    float near = behind(there, own, p * vec2(1.0, 0.0)) + behind(there, own, p * vec2(0.0, 1.0)) +
                 behind(there, own, p * vec2(1.0, 1.0)) + behind(there, own, p * vec2(1.0, -1.0));
    float wide = behind(there, own, p * vec2(4.0, 1.5)) + behind(there, own, p * vec2(-1.5, 4.0)) +
                 behind(there, own, p * vec2(2.0, 2.5)) + behind(there, own, p * vec2(-2.5, 2.0));
    float s = near * 0.25;
    // Small steps are the facets of round faces, which are to look round.
    float dent = max(s - 0.015, 0.0);
    float halo = max(wide * 0.25 - 0.03, 0.0);
    float ridge = min(s + 0.1, 0.0);
    c.rgb *= exp(-0.64 * dent - 0.42 * halo) * (1.0 - 0.22 * ridge);
    c.rgb = min(c.rgb, vec3(c.a));
  }
  if (hasOutlines) {
    vec4 inside = texture(outlines, at);
    vec4 least = inside;
    vec4 most = inside;
    vec4 hiddenLeast = inside;
    for (int i = 0; i < 12; ++i) {
      float angle = float(i) * 0.5235988;
      vec2 away = vec2(cos(angle), sin(angle)) * pixel * ratio;
      vec4 t = texture(outlines, at + away * 1.9);
      least = min(least, t);
      most = max(most, t);
      hiddenLeast = min(hiddenLeast, texture(outlines, at + away * 1.1));
    }
    // What is hidden: a faint tint and a thin line, so that a copy deep in the tray can be found.
    vec2 covered = inside.yw * (1.0 - inside.xz);
    vec2 thin = covered * (1.0 - hiddenLeast.yw);
    vec2 seen = covered * through + thin * 0.5 * step(0.001, through);
    c = mix(c, vec4(accent, 1.0), min(seen.x, 1.0));
    c = mix(c, vec4(mark, 1.0), min(seen.y, 1.0));
    c = line(inside.zw, least.z, most.z, mark, c);
    c = line(inside.xy, least.x, most.x, accent, c);
  }
  colour = c;
}
`;function Os(){return{sceneDepth:{value:null},nearFar:{value:new C(1,2)}}}class Ts{constructor(t){this.inputs=t,this.targets=new Map,this.camera=new It,this.quadScene=new K,this.quad=new R(new dt(1,1),new P({glslVersion:W,vertexShader:Ie,fragmentShader:Le,uniforms:{scene:{value:null},depth:t.sceneDepth,outlines:{value:null},hasOutlines:{value:!1},pixel:{value:new C},ratio:{value:1},nearFar:t.nearFar,reach:{value:1},accent:{value:new k},mark:{value:new k},rim:{value:new k},through:{value:new C}},blending:H,depthTest:!1,depthWrite:!1})),this.quad.frustumCulled=!1,this.quadScene.add(this.quad)}setColours(t,e,s){const n=(i,r)=>{const o=h=>Number.parseInt(r.slice(h,h+2),16)/255;this.uniform(i).value.set(o(1),o(3),o(5))};n("accent",t),n("mark",e),n("rim",s)}setThrough(t,e){this.uniform("through").value.set(t,e)}render(t,e,s,n,i,r,o){const h=this.targetsFor(i);this.inputs.nearFar.value.set(n.near,n.far),t.state.buffers.stencil.setClear(it),t.setRenderTarget(h.scene),t.render(e,n),this.inputs.sceneDepth.value=h.scene.depthTexture,s&&(h.outlines??=Ct({...i,samples:r>=1.5?0:i.samples},!1),t.setRenderTarget(h.outlines),t.render(s,n));const l=t.getDrawingBufferSize(new C);this.uniform("pixel").value.set(1/l.x,1/l.y),this.uniform("ratio").value=r,this.uniform("reach").value=o,this.uniform("scene").value=h.scene.texture,this.uniform("outlines").value=h.outlines?.texture??h.scene.texture,this.uniform("hasOutlines").value=s!==null,t.setRenderTarget(null),t.render(this.quadScene,this.camera)}release(){for(const{scene:t,outlines:e}of this.targets.values())t.depthTexture?.dispose(),t.dispose(),e?.dispose();this.targets.clear()}dispose(){this.release(),this.quad.geometry.dispose(),this.quad.material.dispose()}uniform(t){return this.quad.material.uniforms[t]}targetsFor(t){const e=`${t.width} ${t.height} ${t.samples}`;let s=this.targets.get(e);return s||(this.targets.size>=2&&this.release(),s={scene:Ct(t,!0),outlines:null},this.targets.set(e,s)),s}}function Ct({width:a,height:t,samples:e},s){const n=new G(a,t,{samples:e,stencilBuffer:!0,minFilter:Y,magFilter:Y,resolveStencilBuffer:!1,resolveDepthBuffer:s});if(s){const i=new ft(a,t,Qt);i.format=Xt,i.minFilter=i.magFilter=$,n.depthTexture=i}return n}const Be=48,E=2,qe=2;function Vt(a){const t=n=>Math.max(.001,a[n+3]-a[n]),e=Math.max(t(0),t(1),t(2))/Be,s=n=>Math.ceil(t(n)/e-1e-6)+2*E;return{size:[s(0),s(1),s(2)],cell:e,corner:[a[0]-E*e,a[1]-E*e,a[2]-E*e]}}function Ps(a,t,e){const s=Vt(a),[n,i,r]=s.size,o=new Float32Array(n*i*r);Re(s,t,e,o);for(const l of[1,n,n*i])$e(o,l);const h=[1,Math.SQRT2,Math.sqrt(3)].map(l=>o.map(f=>Math.exp(f*l)));return{...s,texels:Ue(n,i,r,h)}}function Ne(){const a=ut().fill(0);return{...Vt(a),size:[1,1,1],texels:new Uint8Array([128,128,128,255])}}function Re({size:a,cell:t,corner:e},s,n,i){const[r,o,h]=a;for(const{points:l,rows:f,at:m,areaEach:d}of s){const c=Array.from({length:12},(g,w)=>f[m+w]),u=g=>c[g],p=qe*d/(t*t);for(let g=0;g+2<l.length;g+=3){const w=l[g],y=l[g+1],v=l[g+2],x=u(0)*w+u(1)*y+u(2)*v+u(3),S=u(4)*w+u(5)*y+u(6)*v+u(7),M=u(8)*w+u(9)*y+u(10)*v+u(11);if(n&&!n(x,S,M))continue;const D=Math.floor((x-e[0])/t),z=Math.floor((S-e[1])/t),F=Math.floor((M-e[2])/t);if(D<0||z<0||F<0||D>=r||z>=o||F>=h)continue;const A=D+r*(z+o*F);i[A]=i[A]-p}}}function $e(a,t){const e=a.slice();for(let s=t;s+t<a.length;++s)a[s]=(e[s-t]+2*e[s]+e[s+t])/4}function Ue(a,t,e,s){const n=a*t*e,i=new Float32Array(n),r=new Float32Array(n),o=new Float32Array(n),h=new Float32Array(n),l=new Float32Array(n);let f=0;for(let c=-1;c<=1;++c)for(let u=-1;u<=1;++u)for(let p=-1;p<=1;++p){if(p===0&&u===0&&c===0)continue;f+=1;const g=Math.hypot(p,u,c),w=p+a*(u+t*c),y=s[Math.abs(p)+Math.abs(u)+Math.abs(c)-1];for(let v=0;v<e;++v){const x=c>0?e-1-v:v,S=x+c<0||x+c>=e;for(let M=0;M<t;++M){const D=u>0?t-1-M:M,z=S||D+u<0||D+u>=t;for(let F=0;F<a;++F){const A=p>0?a-1-F:F,b=A+a*(D+t*x),gt=b+w,Q=z||A+p<0||A+p>=a?1:l[gt]*y[gt];l[b]=Q,i[b]=i[b]+Q;const X=Q/g;r[b]=r[b]+p*X,o[b]=o[b]+u*X,h[b]=h[b]+c*X}}}}const m=new Uint8Array(4*n),d=c=>Math.min(255,Math.max(0,Math.round(255*c)));for(let c=0;c<n;++c)m[4*c]=d(r[c]/f+.5),m[4*c+1]=d(o[c]/f+.5),m[4*c+2]=d(h[c]/f+.5),m[4*c+3]=d(i[c]/f);return m}const O=new k(-.36,-.5,.8).normalize(),Ee=[0,0,0,1];function Ve(){const a={list:{value:null},copyData:{value:null},eye:{value:new k},plane:{value:new Jt(...Ee)},hatchStep:{value:4},sun:{value:O},sunDepth:{value:new ft(1,1)},sunMatrix:{value:new Bt},sunBias:{value:new C(0,0)},ambient:{value:new Lt(null,1,1,1)},ambientCorner:{value:new k},ambientScale:{value:new k(1,1,1)},ambientCell:{value:0},skyLight:{value:new k},groundLight:{value:new k},sunLight:{value:new k}};return je(a,Ne()),_e(a,"light"),a}function _e(a,t){const e=t==="dark"?.94:1;a.skyLight.value.set(.6,.615,.64).multiplyScalar(e),a.groundLight.value.set(.3,.3,.31).multiplyScalar(e),a.sunLight.value.set(.76,.745,.71).multiplyScalar(e)}function je(a,t){const[e,s,n]=t.size,i=new Lt(t.texels,e,s,n);i.format=qt,i.type=te,i.minFilter=i.magFilter=Y,i.needsUpdate=!0,a.ambient.value.dispose(),a.ambient.value=i,a.ambientCorner.value.set(...t.corner),a.ambientScale.value.set(1/(e*t.cell),1/(s*t.cell),1/(n*t.cell)),a.ambientCell.value=t.cell}const N=192,zt=.05,Ge=.012,Ze=`
void main() {
  gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
}
`,He=`
uniform highp sampler2DShadow sunDepth;
uniform mat4 sunMatrix;
uniform vec4 rectangle; // corner, size
uniform float texels;
out vec4 colour;

void main() {
  vec2 p = rectangle.xy + gl_FragCoord.xy / texels * rectangle.zw;
  vec3 q = (sunMatrix * vec4(p, 0.0, 1.0)).xyz;
  bool outside = any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0)));
  colour = vec4(outside ? 0.0 : 1.0 - texture(sunDepth, vec3(q.xy, min(q.z, 1.0))));
}
`,Ke=`
uniform sampler2D shade;
uniform vec2 wide; // standard deviation, in texture units
uniform vec2 close;
uniform float texels;
out vec4 colour;

void main() {
  vec2 at = gl_FragCoord.xy / texels;
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int i = -8; i <= 8; ++i) {
    float t = float(i) / 3.2;
    float w = exp(-0.5 * t * t);
    sum += w * vec2(texture(shade, at + wide * t).r, texture(shade, at + close * t).g);
    weights += w;
  }
  colour = vec4(sum / weights, 0.0, 0.0);
}
`,Ye=`
uniform vec4 rectangle;
out vec2 place;
void main() {
  place = position.xy + 0.5;
  gl_Position = projectionMatrix * viewMatrix * vec4(rectangle.xy + place * rectangle.zw, 0.0, 1.0);
}
`,Qe=`
uniform sampler2D shade;
uniform vec4 tint; // as encoded; alpha: the darkest shadow
in vec2 place;
out vec4 colour;
void main() {
  vec2 s = texture(shade, place).rg;
  vec2 edge = min(place, 1.0 - place);
  float a = (0.72 * s.r + 0.28 * s.g) * tint.a * smoothstep(0.0, 0.06, min(edge.x, edge.y));
  colour = vec4(tint.rgb * a, a);
}
`;class Ws{constructor(t,e=1024){this.shared=t,this.mapSize=e,this.groundMap=new G(N,N,{depthBuffer:!1}),this.groundMap2=new G(N,N,{depthBuffer:!1}),this.camera=new It,this.rectangle={value:[0,0,1,1]},this.nothing=new K,this.bounds=null,this.side=1;const s=new ft(e,e,Nt);s.format=ee,s.compareFunction=se,s.minFilter=s.magFilter=Y,this.map=new G(e,e,{depthTexture:s,minFilter:$,magFilter:$}),t.sunDepth.value?.dispose(),t.sunDepth.value=s;const n=new dt(1,1),i=(h,l)=>{const f=new R(n,new P({glslVersion:W,vertexShader:Ze,fragmentShader:h,uniforms:{...l,texels:{value:N}},blending:H,depthTest:!1,depthWrite:!1}));return f.frustumCulled=!1,f},{sunDepth:r,sunMatrix:o}=t;this.bake=i(He,{sunDepth:r,sunMatrix:o,rectangle:this.rectangle}),this.blur=i(Ke,{shade:{value:null},wide:{value:new C},close:{value:new C}}),this.ground=new R(n,new P({glslVersion:W,vertexShader:Ye,fragmentShader:Qe,uniforms:{rectangle:this.rectangle,shade:{value:this.groundMap.texture},tint:{value:[0,0,0,0]}},...Et,side:st,depthWrite:!1})),this.ground.frustumCulled=!1,this.ground.visible=!1,this.setTheme("light")}setTheme(t){const e=at(t).shadow,s=n=>Number.parseInt(e.slice(n,n+2),16)/255;this.set(this.ground,"tint",[s(1),s(3),s(5),t==="dark"?.6:.3])}holds(t){const e=this.bounds;return e!==null&&[0,1,2].every(s=>V(t,s)>=V(e,s)-.001&&V(t,s+3)<=V(e,s+3)+.001)}render(t,e,s,n){n||this.look(s);const i=t.getRenderTarget(),r=t.autoClear;t.autoClear=!n,t.setRenderTarget(this.map),t.render(e,this.camera),t.autoClear=r,t.setRenderTarget(i)}clear(t,e){this.render(t,this.nothing,e,!1),this.forget()}renderGround(t){const e=t.getRenderTarget();t.setRenderTarget(this.groundMap),t.render(this.bake,this.camera);const[,,s,n]=this.rectangle.value;for(const[i,r,o,h]of[[this.groundMap,this.groundMap2,1/s,0],[this.groundMap2,this.groundMap,0,1/n]])this.set(this.blur,"shade",i.texture),this.set(this.blur,"wide",new C(o,h).multiplyScalar(zt*this.side)),this.set(this.blur,"close",new C(o,h).multiplyScalar(Ge*this.side)),t.setRenderTarget(r),t.render(this.blur,this.camera);t.setRenderTarget(e)}showGround(t){this.ground.visible=t&&this.bounds!==null}forget(){this.bounds=null}dispose(){this.map.depthTexture?.dispose(),this.map.dispose(),this.groundMap.dispose(),this.groundMap2.dispose(),this.bake.geometry.dispose(),this.bake.material.dispose(),this.blur.material.dispose(),this.ground.material.dispose()}look(t){this.bounds=[...t];const e=Math.max(.001,t[3]-t[0],t[4]-t[1],t[5]-t[2]),s=new k((t[0]+t[3])/2,(t[1]+t[4])/2,(t[2]+t[5])/2),n=this.camera;n.up.set(0,1,0),n.position.copy(s).addScaledVector(O,4*e),n.lookAt(s),n.updateMatrixWorld();let i=0;const r=new k,o=[1/0,1/0,-1/0,-1/0];for(const u of ne(t)){r.set(...u).applyMatrix4(n.matrixWorldInverse),i=Math.max(i,Math.abs(r.x),Math.abs(r.y));for(const p of[Math.max(0,u[2]),0]){const g=u[0]-O.x/O.z*p,w=u[1]-O.y/O.z*p;o[0]=Math.min(o[0],g),o[1]=Math.min(o[1],w),o[2]=Math.max(o[2],g),o[3]=Math.max(o[3],w)}}i*=1.02,n.left=n.bottom=-i,n.right=n.top=i,n.near=2*e,n.far=6*e,n.updateProjectionMatrix();const h=new Bt().set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1);this.shared.sunMatrix.value.copy(h).multiply(n.projectionMatrix).multiply(n.matrixWorldInverse),this.shared.sunBias.value.set(2.3*2*i/this.mapSize,1/this.mapSize),this.side=e;const[l,f,m,d]=o,c=2.6*zt*e;this.rectangle.value=[l-c,f-c,m-l+2*c,d-f+2*c],this.set(this.ground,"rectangle",this.rectangle.value),this.set(this.bake,"rectangle",this.rectangle.value)}set(t,e,s){const n=t.material.uniforms[e];n&&(n.value=s)}}function V(a,t){return a[t]}const ot=1,rt=2,_t=4,ht=8,jt=16,Gt=32,Xe=268435456;function Ot(a,t,e){const s=[],n=[],i=[],r=[],o=[],h=[],l=[],f=[];for(const m of t){i.length=r.length=o.length=h.length=l.length=f.length=0;for(const w of m.parts)for(const y of a.ofPart(w)){const v=e(y);v&ot?(v&rt?i:r).push(y):v&_t?o.push(y):v&Gt&&h.push(y),v&ht&&(v&rt?l:f).push(v&jt?y|Xe:y)}const d=s.length;for(const w of[i,r,o,h,l,f])for(const y of w)s.push(y);const c=i.length+r.length,u=d+c,p=u+o.length,g=p+h.length;n.push({shape:m,solids:d,solidCount:c,cuts:i.length,ghosts:u,ghostCount:o.length,faints:p,faintCount:h.length,outlines:g,outlineCount:l.length+f.length,outlineCuts:l.length})}return{list:Uint32Array.from(s),ranges:n}}function Is(a){const t=n=>[a[n]??0,a[n+4]??0,a[n+8]??0,a[n+12]??0],e=t(3),s=[];for(let n=0;n<3;++n){const i=t(n);s.push([e[0]+i[0],e[1]+i[1],e[2]+i[2],e[3]+i[3]]),s.push([e[0]-i[0],e[1]-i[1],e[2]-i[2],e[3]-i[3]])}return s}function Je(a,t,e){for(const[s,n,i,r]of a){const o=t[s>0?e+3:e],h=t[n>0?e+4:e+1],l=t[i>0?e+5:e+2];if(s*o+n*h+i*l+r<0)return!1}return!0}function ts(a,t,e){for(const[s,n,i,r]of a){const o=t[s>0?e:e+3],h=t[n>0?e+1:e+4],l=t[i>0?e+2:e+5];if(s*o+n*h+i*l+r<0)return!1}return!0}function T({part:a,copy:t}){return a*2**26+t}class es{constructor(){this.rows=new Float32Array(0),this.boxes=new Float32Array(0),this.part=new Int32Array(0),this.copy=new Int32Array(0),this.order=new Float64Array(0),this.step=new Float64Array(0),this.landedAt=new Float64Array(0),this.movedAt=new Float64Array(0),this.slots=new Map,this.free=[],this.used=0,this.partSlots=new Map,this.partBoxes=new Map}get size(){return this.slots.size}get end(){return this.used}setPart(t,e){this.partBoxes.set(t,e);for(const s of this.partSlots.get(t)??[])this.updateBox(s)}hasPart(t){return this.partBoxes.has(t)}clear(){this.slots.clear(),this.partSlots.clear(),this.free=[],this.used=0}clearParts(){this.clear(),this.partBoxes.clear()}slotOf(t){return this.slots.get(T(t))}keyOf(t){return{part:this.part[t],copy:this.copy[t]}}keyNumberOf(t){return T({part:this.part[t],copy:this.copy[t]})}all(){return this.slots.values()}ofPart(t){return this.partSlots.get(t)??[]}place(t,e,s){if(!this.partBoxes.has(t.part))return null;const n=T(t),i=this.slots.get(n),r=i??this.free.pop()??this.used++;if(r>=this.part.length&&this.enlarge(Math.max(64,2*r)),ie(t.transform,this.rows,12*r),this.part[r]=t.part,this.copy[r]=t.copy,this.order[r]=t.order,this.step[r]=t.step??Number.NaN,this.landedAt[r]=s?e:-1/0,this.movedAt[r]=i===void 0?-1/0:e,this.updateBox(r),i===void 0){this.slots.set(n,r);const o=this.partSlots.get(t.part);o?o.add(r):this.partSlots.set(t.part,new Set([r]))}return{slot:r,moved:i!==void 0}}remove(t){const e=this.slots.get(T(t));return e===void 0?!1:(this.slots.delete(T(t)),this.partSlots.get(t.part)?.delete(e),this.free.push(e),!0)}boxOf(t){const e=this.boxes,s=6*t;return[e[s],e[s+1],e[s+2],e[s+3],e[s+4],e[s+5]]}updateBox(t){const e=this.partBoxes.get(this.part[t]);e&&this.boxes.set(ae(this.rows,e,12*t),6*t)}enlarge(t){const e=(s,n)=>(n.set(s),n);this.rows=e(this.rows,new Float32Array(12*t)),this.boxes=e(this.boxes,new Float32Array(6*t)),this.part=e(this.part,new Int32Array(t)),this.copy=e(this.copy,new Int32Array(t)),this.order=e(this.order,new Float64Array(t)),this.step=e(this.step,new Float64Array(t)),this.landedAt=e(this.landedAt,new Float64Array(t)),this.movedAt=e(this.movedAt,new Float64Array(t))}}const lt=0,ct=1,ss=2,tt=255,ns={"one-hue":[],height:[]};function is(a,t){const e=ns[a];if(e.length===0)for(let s=0;s<=tt;++s)e.push(ve(a,s/tt));return e[Math.round(Math.min(1,Math.max(0,t))*tt)]??[0,0,0]}function _(a){return new Set(a.map(T))}function j(a,t){return a.size===t.size&&[...a].every(e=>t.has(e))}class as{constructor(){this.theme="light",this.colouring="part",this.selected=new Set,this.leaving=new Set,this.leavesInColour=!1,this.marked=new Set,this.mark="warn",this.othersPale=!1,this.locked=new Set,this.hidden=null,this.faint=null,this.latest=null,this.paint=null,this.low=0,this.high=0,this.bases=new Map}select(t){const e=this.selected;return this.selected=_(t),!j(e,this.selected)}leave(t,e=!1){const s=this.leaving,n=this.leavesInColour===e;return this.leaving=_(t),this.leavesInColour=e,!n||!j(s,this.leaving)}markThese(t,e,s){const n=this.marked,i=this.othersPale===e&&this.mark===s;return this.marked=_(t),this.othersPale=e,this.mark=s,!i||!j(n,this.marked)}lock(t){const e=this.locked;return this.locked=_(t),!j(e,this.locked)}isHidden(t,e){return this.hidden?.(t.keyOf(e))??!1}isFaint(t,e){return this.faint?.(t.keyOf(e))??!1}outlineOf(t,e){const s=t.keyNumberOf(e);return this.selected.has(s)||this.latest===s||this.leavesInColour&&this.leaving.has(s)?ct:(this.marked.size>0||this.othersPale?this.marked:this.locked).has(s)?ss:lt}get outlineColour(){const t=at(this.theme);return this.marked.size===0?{accent:t.accent,mark:t.text}:{accent:t.accent,mark:this.mark==="bad"?t.bad:t.warnMark}}get through(){const t=this.othersPale&&this.mark==="bad"?.45:.1;return{accent:t,mark:this.marked.size===0?0:t}}measure(t){if(this.low=1/0,this.high=-1/0,this.colouring!=="part")for(const e of t.all()){const s=this.valueOf(t,e);Number.isNaN(s)||(this.low=Math.min(this.low,s),this.high=Math.max(this.high,s))}}colourOf(t,e){const s=at(this.theme),n=t.keyNumberOf(e);if(this.leaving.has(n))return this.leavesInColour?this.baseOf(t,e,n):q(s.accent);if(this.selected.has(n))return q(this.leaving.size>0?s.select:s.accent);if(this.marked.has(n))return q(this.mark==="bad"?s.bad:s.warnMark);if(this.othersPale)return q(s.stay);if(this.colouring==="part")return this.baseOf(t,e,n);const i=this.valueOf(t,e);return Number.isNaN(i)?q(s.stay):is(this.ramp,(i-this.low)/(this.high-this.low||1))}legend(){return this.colouring==="part"||!(this.low<=this.high)?null:{colours:pe(this.ramp),values:[this.low,(this.low+this.high)/2,this.high]}}get ramp(){return this.colouring==="height"?"height":"one-hue"}baseOf(t,e,s){if(this.paint)return this.paint(t.keyOf(e));let n=this.bases.get(s);return n||(n=ge(t.part[e],t.copy[e]),this.bases.set(s,n)),n}valueOf(t,e){return this.colouring==="order"?t.order[e]:this.colouring==="way"?t.step[e]:(t.boxes[6*e+2]+t.boxes[6*e+5])/2}}const I=1024;class os extends R{constructor(t,e){super(t,e),this.runs=0,this.frustumCulled=!1,this.matrixAutoUpdate=!1,this.matrixWorldAutoUpdate=!1,this.onBeforeRender=()=>{this.geometry.instanceCount=this.runs}}set(t,e){this.matrixWorld.elements[12]=t,this.runs=e,this.visible=e>0}}class rs{constructor(t){this.material=t,this.group=new $t,this.meshes=new Map,this.group.matrixWorldAutoUpdate=!1}set(t,e,s,n){let i=this.meshes.get(t);if(!i){if(n===0)return;i=new os(e,this.material),this.meshes.set(t,i),this.group.add(i)}i.geometry=e,i.set(s,n)}remove(t){const e=this.meshes.get(t);e&&(this.group.remove(e),this.meshes.delete(t))}clear(){this.group.clear(),this.meshes.clear()}}function et(a){const t=Math.max(1,Math.ceil(a/I)),e=new Uint32Array(I*t),s=new Rt(e,I,t,oe,Nt);return s.minFilter=s.magFilter=$,s.unpackAlignment=4,s}function Tt(a){const t=Math.max(1,Math.ceil(4*a/I)),e=new Float32Array(4*I*t),s=new Rt(e,I,t,qt,re);return s.minFilter=s.magFilter=$,s}class hs{constructor(t){this.picture=new $t,this.outlines=new K,this.shadows=new K,this.all=[],this.quad=new dt(1,1);const e=n=>{const i=new rs(n);return this.all.push(i),i},s=n=>{const i=new R(this.quad,n);return i.frustumCulled=i.matrixAutoUpdate=i.matrixWorldAutoUpdate=i.visible=!1,i};this.faintDepth=e(t.ghostDepth),this.faint=e(t.ghost),this.faintForget=s(t.forgetDepth),this.cutInner=e(t.cutInner),this.cutOuter=e(t.cutOuter),this.cutPlane=s(t.cutPlane),this.solid=e(t.solid),this.solidBoth=e(t.solidBoth),this.ghostDepth=e(t.ghostDepth),this.ghost=e(t.ghost),this.outlineInner=e(t.outlineInner),this.outlineOuter=e(t.cutOuter),this.outlineErase=s(t.outlineErase),this.outline=e(t.outline),this.shadow=e(t.shadow),this.picture.add(this.faintDepth.group,this.faint.group,this.faintForget),this.picture.add(this.cutInner.group,this.cutOuter.group,this.cutPlane),this.picture.add(this.solid.group,this.solidBoth.group),this.picture.add(this.ghostDepth.group,this.ghost.group),this.outlines.add(this.outlineInner.group,this.outlineOuter.group,this.outlineErase,this.outline.group),this.shadows.add(this.shadow.group),this.picture.matrixWorldAutoUpdate=!1,this.outlines.matrixWorldAutoUpdate=this.shadows.matrixWorldAutoUpdate=!1}set(t,e,s){this.faintDepth.set(t.shape.number,e,t.faints,t.faintCount),this.faint.set(t.shape.number,e,t.faints,t.faintCount),this.cutInner.set(t.shape.number,e,t.solids,t.cuts),this.cutOuter.set(t.shape.number,e,t.solids,t.cuts),this.solid.set(t.shape.number,e,t.solids,s?0:t.solidCount),this.solidBoth.set(t.shape.number,e,t.solids,s?t.solidCount:0),this.ghostDepth.set(t.shape.number,e,t.ghosts,t.ghostCount),this.ghost.set(t.shape.number,e,t.ghosts,t.ghostCount),this.outlineInner.set(t.shape.number,e,t.outlines,t.outlineCuts),this.outlineOuter.set(t.shape.number,e,t.outlines,t.outlineCuts),this.outline.set(t.shape.number,e,t.outlines,t.outlineCount)}setFaint(t){this.faintForget.visible=t}setShadow(t,e,s,n){this.shadow.set(t.number,e,s,n)}remove(t){for(const e of this.all)e.remove(t)}setSection(t,e){if(this.cutPlane.visible=this.outlineErase.visible=t!==null,!t)return;const s=2*Math.max(1,e[3]-e[0],e[4]-e[1],e[5]-e[2]),n=[0,1,2].map(h=>(e[h]+e[h+3])/2),i={x:0,y:1,z:2}[t.axis];n[i]=he(t);const[r,o]=[i===0?1:0,i===2?1:2];for(const{matrixWorld:h}of[this.cutPlane,this.outlineErase]){const l=h.elements;l.fill(0),l[r]=l[4+o]=s,l[12]=n[0],l[13]=n[1],l[14]=n[2],l[15]=1}}clear(){for(const t of this.all)t.clear()}release(){this.quad.dispose()}}const ls=35,cs=48;function us({positions:a,indices:t}){const e=a.length/3,s=ds(a,t),{starts:n,corners:i}=fs(e,t),r=Math.cos(ls*Math.PI/180),o=new Uint32Array(t.length),h=[],l=[];let f=[];for(let m=0;m<e;++m){const d=n[m],c=n[m+1]-d;f=ms(i,d,c,s.units,r,f);for(let u=0;u<c;++u){if(f[u]!==u)continue;let p=0,g=0,w=0;const y=h.length/3;for(let x=u;x<c;++x){if(f[x]!==u)continue;const S=i[d+x];o[S]=y;const M=3*Math.floor(S/3);p+=s.areas[M],g+=s.areas[M+1],w+=s.areas[M+2]}const v=Math.hypot(p,g,w)||1;h.push(a[3*m],a[3*m+1],a[3*m+2]),l.push(Math.round(127*p/v),Math.round(127*g/v),Math.round(127*w/v),0)}}return{positions:Float32Array.from(h),normals:Int8Array.from(l),indices:o}}function ds(a,t){const e=new Float32Array(t.length),s=new Float32Array(t.length);for(let n=0;n+2<t.length;n+=3){const i=3*t[n],r=3*t[n+1],o=3*t[n+2],h=a[r]-a[i],l=a[r+1]-a[i+1],f=a[r+2]-a[i+2],m=a[o]-a[i],d=a[o+1]-a[i+1],c=a[o+2]-a[i+2],u=l*c-f*d,p=f*m-h*c,g=h*d-l*m,w=Math.sqrt(u*u+p*p+g*g)||1;e[n]=u,e[n+1]=p,e[n+2]=g,s[n]=u/w,s[n+1]=p/w,s[n+2]=g/w}return{areas:e,units:s}}function fs(a,t){const e=new Uint32Array(a+1);for(const i of t)e[i+1]=e[i+1]+1;for(let i=0;i<a;++i)e[i+1]=e[i+1]+e[i];const s=e.slice(),n=new Uint32Array(t.length);return t.forEach((i,r)=>{const o=s[i];n[o]=r,s[i]=o+1}),{starts:e,corners:n}}function ms(a,t,e,s,n,i){for(let r=0;r<e;++r){i[r]=r;const o=3*Math.floor(a[t+r]/3);for(let h=Math.max(0,r-cs);h<r;++h){if(i[h]===i[r])continue;const l=3*Math.floor(a[t+h]/3);if(s[o]*s[l]+s[o+1]*s[l+1]+s[o+2]*s[l+2]<n)continue;const[m,d]=[i[r],i[h]];if(m===r){i[r]=d;continue}const[c,u]=[Math.min(m,d),Math.max(m,d)];for(let p=0;p<=r;++p)i[p]===u&&(i[p]=c)}}return i}const ps=4,gs=16,vs=6e4,ws=6e4,ys=25e5;class xs{constructor(t){this.gone=t,this.light=!1,this.byMesh=new Map,this.byPart=new Map,this.rough=[],this.smoothed=0,this.made=0}of(t){return this.byPart.get(t)}all(){return this.byMesh.values()}drawn(t){const{mesh:e,geometry:s,lighter:n}=t;return this.light&&n?n:{geometry:s,triangles:e.indices.length/3}}set(t,e,s=!1){const n=this.byPart.get(t);if(n?.mesh===e)return n;let i=this.byMesh.get(e);if(!i){const r=Oe(e),o=Pt(e,r);i={number:this.made++,mesh:e,facts:r,parts:new Set,geometry:o,lighter:null,points:null,mirrored:!1},this.byMesh.set(e,i),this.smoothed+e.indices.length/3<=ws?this.smoothShape(i):this.rough.push(i)}return i.parts.add(t),this.byPart.set(t,i),n&&(n.mirrored&&(i.mirrored=!0),s&&(i.lighter??={geometry:n.geometry,triangles:n.mesh.indices.length/3}),this.leave(t,n)),i}clear(){this.release(),this.byMesh.clear(),this.byPart.clear(),this.rough=[],this.smoothed=0}release(){for(const{geometry:t,lighter:e}of this.all())t.dispose(),e?.geometry.dispose()}get isRough(){return this.rough.length>0}smoothSome(t){const e=performance.now()+t;let s=!1;for(;this.rough.length>0&&performance.now()<e;){const n=this.rough.shift();!n||this.smoothed+n.mesh.indices.length/3>ys||(this.smoothShape(n),s=!0)}return s}leave(t,e){e.parts.delete(t),!(e.parts.size>0)&&(this.byMesh.delete(e.mesh),this.rough=this.rough.filter(s=>s!==e),e.geometry.dispose(),e.lighter?.geometry.dispose(),this.gone(e.number))}smoothShape(t){this.smoothed+=t.mesh.indices.length/3,t.geometry.dispose();const{positions:e,normals:s,indices:n}=us(t.mesh);t.geometry=Pt({positions:e,indices:n},t.facts),t.geometry.setAttribute("normal",new nt(s,4))}}function bs(a,t,e){const s=Math.min(vs,Math.max(gs,ps*a.facts.area*t/e**2));return(!a.points||a.points.length<1.5*s||a.points.length>12*s)&&(a.points=Te(a.mesh,a.facts.area,s)),a.points}function Pt(a,t){const e=new le;return e.setAttribute("position",new nt(a.positions,3)),e.setIndex(new nt(t.insideOut?Ms(a.indices):a.indices,1)),e.boundingSphere=new ce,e}function Ms(a){const t=a.slice();for(let e=0;e+2<t.length;e+=3)t[e+1]=a[e+2],t[e+2]=a[e+1];return t}const Fs=.16,ks=.02,As=1e-4,Ss=350,Ds=250;class Ls{constructor(t){this.copies=new es,this.looks=new as,this.shared=Ve(),this.shadowsDirty=!0,this.shadowsAdded=[],this.parts=new Map,this.shapes=new xs(e=>this.passes.remove(e)),this.section=null,this.listsDirty=!0,this.coloursDirty=!0,this.changed=new Set,this.landedAt=-1/0,this.fading=new Set,this.resting=new Set,this.shadowList=et(1),this.viewList=et(1),this.lastFrustum="",this.lastFacesCut=!1,this.extent=null,this.outlinedCount=0,this.drawnTriangles=0,this.materials=Ce(this.shared,t),this.passes=new hs(this.materials),this.shared.list.value=this.viewList,this.shared.copyData.value=Tt(64)}setParts(t){this.parts=new Map(t.map(e=>[e.index,e])),this.shapes.clear(),this.passes.clear(),this.copies.clearParts();for(const{index:e,mesh:s}of t)this.setMesh(e,s);this.afterClear()}refine(t,e=!1){for(const[s,n]of t)this.parts.has(s)&&this.setMesh(s,n,e);this.extent=null,this.listsDirty=!0,this.shadowsDirty=!0}clear(){this.copies.clear(),this.afterClear()}place(t,e,s){const n=e&&!we();let i=null;for(const r of t){const o=this.copies.place(r,s,n);if(!o)continue;this.changed.add(o.slot);const h=this.shapes.of(r.part);h&&ue(this.copies.rows,12*o.slot)<0&&(h.mirrored=!0),n&&this.fading.add(o.slot),o.moved?(this.resting.has(o.slot)||(this.shadowsDirty=!0),this.resting.add(o.slot)):this.shadowsAdded.push(o.slot),i=this.copies.keyNumberOf(o.slot)}e&&(this.looks.latest=i,this.landedAt=s),this.looks.colouring!=="part"&&(this.coloursDirty=!0),this.extent=null,this.listsDirty=!0}remove(t){for(const e of t){const s=this.copies.slotOf(e);s!==void 0&&(this.copies.remove(e),this.fading.delete(s),this.resting.delete(s),this.changed.delete(s))}this.looks.colouring!=="part"&&(this.coloursDirty=!0),this.extent=null,this.listsDirty=!0,this.shadowsDirty=!0}setSection(t){this.section=t,this.listsDirty=!0,this.shadowsDirty=!0}looksChanged(t){this.coloursDirty=!0,this.listsDirty=!0,t&&(this.shadowsDirty=!0)}meshOf(t){return this.shapes.of(this.copies.part[t])?.mesh}nameOf(t){return this.parts.get(t)?.name??""}*pickable(){for(const t of this.copies.all())!this.looks.isHidden(this.copies,t)&&!this.looks.isFaint(this.copies,t)&&(yield t)}bounds(){if(!this.extent){this.extent=ut();for(const t of this.copies.all())de(this.extent,this.copies.boxOf(t))}return this.extent}measure(){this.looks.measure(this.copies)}get hasOutlines(){return this.outlinedCount>0}get triangles(){return this.drawnTriangles}update(t,e,s){this.updateCopies(t);const n=this.section!==null&&fe(this.section,s),i=this.frustumKey(e);return(this.listsDirty||i!==this.lastFrustum||n!==this.lastFacesCut)&&(this.lastFrustum=i,this.lastFacesCut=n,this.listsDirty=!1,this.updateLists(e,n)),this.fading.size>0}setMoving(t){t!==this.shapes.light&&(this.shapes.light=t,this.listsDirty=!0)}get isRough(){return this.shapes.isRough}smoothSome(t){this.shapes.smoothSome(t)&&(this.listsDirty=!0)}rested(t){let e=!1;for(const s of this.resting)t-this.copies.movedAt[s]<Ss||(this.resting.delete(s),e=!0);return e&&(this.shadowsDirty=!0),e}isLanding(t){return t-this.landedAt<Ds}get anyResting(){return this.resting.size>0}prepareShadows(t){const e=t?new Set(this.shadowsAdded):null,s=Ot(this.copies,this.shapes.all(),n=>e&&!e.has(n)||!this.castsShadow(n)?0:ot);this.shadowList=this.fill(this.shadowList,s.list);for(const{shape:n,solids:i,solidCount:r}of s.ranges)this.passes.setShadow(n,this.shapes.drawn(n).geometry,i,r);this.shadowsDirty=!1,this.shadowsAdded=[]}useShadowList(t){this.shared.list.value=t?this.shadowList:this.viewList}*surfaces(t){const e=this.copies.rows;for(const s of this.shapes.all())for(const n of s.parts)for(const i of this.copies.ofPart(n)){if(!this.castsShadow(i))continue;const r=12*i,o=e[r]**2+e[r+4]**2+e[r+8]**2,h=bs(s,o,t),l=s.facts.area*o/Math.max(1,h.length/3);yield{points:h,rows:e,at:r,areaEach:l}}}release(){this.shapes.release(),ze(this.materials),this.passes.release(),this.viewList.dispose(),this.shadowList.dispose(),this.shared.copyData.value?.dispose(),this.shared.ambient.value.dispose()}dispose(){this.release(),this.parts.clear(),this.shapes.clear()}afterClear(){this.fading.clear(),this.resting.clear(),this.changed.clear(),this.shadowsAdded=[],this.looks.latest=null,this.extent=null,this.listsDirty=!0,this.shadowsDirty=!0}setMesh(t,e,s=!1){this.copies.setPart(t,this.shapes.set(t,e,s).facts.box)}castsShadow(t){return this.resting.has(t)||this.looks.isHidden(this.copies,t)||this.looks.isFaint(this.copies,t)?!1:this.section===null||Ft(this.section,this.copies.boxes,6*t)!==kt}updateCopies(t){let e=this.shared.copyData.value;const{copies:s,looks:n}=this;let i=this.coloursDirty;16*s.end>e.image.data.length&&(e.dispose(),e=Tt(2*s.end),this.shared.copyData.value=e,i=!0);for(const o of this.fading)this.changed.add(o),!(t-s.landedAt[o]<At)&&(this.fading.delete(o),this.listsDirty=!0);if(!i&&this.changed.size===0)return;i&&n.measure(s);const r=e.image.data;for(const o of i?s.all():this.changed){r.set(s.rows.subarray(12*o,12*o+12),16*o);const[h,l,f]=n.colourOf(s,o),m=Math.min(1,Math.max(.02,(t-s.landedAt[o])/At));r[16*o+12]=h,r[16*o+13]=l,r[16*o+14]=f,r[16*o+15]=n.isFaint(s,o)?Fs*m:m}e.needsUpdate=!0,this.changed.clear(),this.coloursDirty=!1}updateLists(t,e){const{copies:s,looks:n,section:i}=this,r=Ot(s,this.shapes.all(),o=>{if(n.isHidden(s,o))return 0;const h=i?Ft(i,s.boxes,6*o):0;if(i&&h===kt||!Je(t,s.boxes,6*o))return 0;const l=n.isFaint(s,o);let f=l?Gt:this.fading.has(o)?_t:ot;const m=this.shapes.of(s.part[o]);h===me&&e&&m&&m.facts.openness<ks&&(f|=rt);const d=l?lt:n.outlineOf(s,o);return d!==lt&&(f|=d===ct?ht:ht|jt),f});this.viewList=this.fill(this.viewList,r.list),this.shared.list.value=this.viewList,this.outlinedCount=0,this.drawnTriangles=0,this.passes.setFaint(r.ranges.some(o=>o.faintCount>0));for(const o of r.ranges){const{shape:h}=o,{geometry:l,triangles:f}=this.shapes.drawn(h);this.passes.set(o,l,h.mirrored||h.facts.openness>As),this.drawnTriangles+=f*(o.solidCount+o.ghostCount+o.faintCount),this.outlinedCount+=o.outlineCount}this.passes.setSection(i,this.bounds())}fill(t,e){let s=t;return e.length>s.image.data.length&&(s.dispose(),s=et(2*e.length)),s.image.data.set(e),s.needsUpdate=!0,s}frustumKey(t){return ts(t,this.bounds(),0)?"all":t.map(e=>e.join()).join()}}export{Ts as C,Ls as P,Ws as S,Vt as a,_e as b,Ps as c,Is as f,Oe as m,Ee as n,Os as o,Et as p,je as s,at as t};
