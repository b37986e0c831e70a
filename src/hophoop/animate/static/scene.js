/* Built from web/scene/main.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
"use strict";(()=>{var D=r=>{if(Array.isArray(r))return r.map(D);if(r===null||typeof r!="object")return r;if(r.f32!==void 0){let t=Uint8Array.from(atob(r.f32),e=>e.charCodeAt(0));
return new Float32Array(t.buffer)}return Object.fromEntries(Object.entries(r).map(([t,e])=>[t,D(e)]))};function Y(r,t){let[e,n]=[Math.cos(t),Math.sin(t)],o=new Float32Array(
r.length);for(let i=0;i<r.length;i+=2)o[i]=r[i]*e-r[i+1]*n,o[i+1]=r[i]*n+r[i+1]*e;return o}function X(r){let t=D(JSON.parse(r));for(let e of t.hoops){for(let n of[
"center","contact","velocity"])e[n]=Y(e[n],t.slope);if(e.traces!==null)for(let n of["load","heavy"])e.traces[n]=Y(e.traces[n],t.slope)}return t}function f(r,t,e=1,n=0){
let o=Math.floor(t),i=Math.min(o+1,r.length/e-1),s=t-o;return r[o*e+n]*(1-s)+r[i*e+n]*s}var S=class{constructor(t,e,n){this.data=e;this.follows=n;let o=Math.max(...e.hoops.map(i=>Math.abs(i.lane)));this.home={turn:-.35,rise:.2,away:7*e.radius+2*o+1.5*
e.height,shift:[0,0,0]},this.reset(),this.along=null,this.listen(t)}reset(){Object.assign(this,this.home,{shift:[...this.home.shift]})}closer(t){let e=this.data.
radius;this.away=Math.min(Math.max(this.away*t,2*e),200*e)}focus(t){let{hoops:e,along:n}=this.data,o=this.follows()?e.reduce((i,s)=>i+f(s.center,t,2)/e.length,0):
.5*(n[0]+n[1]);return this.along=this.along===null?o:this.along+(o-this.along)*.12,this.along}view(t){let{radius:e,slope:n}=this.data,o=.95*e,i=[o*Math.sin(n),o*
Math.cos(n),0].map((c,l)=>c+this.shift[l]),s=Math.cos(this.rise),a=[Math.sin(this.turn)*s,Math.sin(this.rise),Math.cos(this.turn)*s];return{eye:i.map((c,l)=>c+this.
away*a[l]),target:i,slope:n,angle:t?.56:.9,near:.05*this.away,far:12*this.away+60*e}}listen(t){let e=new Map;t.addEventListener("pointerdown",n=>{t.setPointerCapture(
n.pointerId),e.set(n.pointerId,n)});for(let n of["pointerup","pointercancel"])t.addEventListener(n,o=>e.delete(o.pointerId));t.addEventListener("pointermove",n=>{
let o=e.get(n.pointerId);if(!o)return;let[i,s]=[n.clientX-o.clientX,n.clientY-o.clientY];if(e.size===2){let[a]=[...e.values()].filter(l=>l.pointerId!==n.pointerId),
c=l=>Math.hypot(l.clientX-a.clientX,l.clientY-a.clientY);this.closer(c(o)/Math.max(c(n),1))}else if(n.shiftKey||n.buttons===2){let a=this.away/t.clientHeight;this.
shift[0]-=i*a*Math.cos(this.turn),this.shift[1]+=s*a,this.shift[2]+=i*a*Math.sin(this.turn)}else this.turn-=i*.008,this.rise=Math.min(Math.max(this.rise+s*.006,
.02),1.5);e.set(n.pointerId,n)}),t.addEventListener("wheel",n=>{this.closer(Math.exp(n.deltaY*.001)),n.preventDefault()},{passive:!1}),t.addEventListener("conte\
xtmenu",n=>n.preventDefault())}};function U(r,t){let e=new Float32Array(16);for(let n=0;n<4;n++)for(let o=0;o<4;o++){let i=0;for(let s=0;s<4;s++)i+=r[4*s+o]*t[4*n+s];e[4*n+o]=i}return e}function K(r,t,e,n){
let o=1/Math.tan(r/2),i=1/(e-n);return new Float32Array([o/t,0,0,0,0,o,0,0,0,0,(n+e)*i,-1,0,0,2*n*e*i,0])}function q(r,t){let e=M(B(r,t)),n=M(A([0,1,0],e)),o=A(
e,n);return new Float32Array([n[0],o[0],e[0],0,n[1],o[1],e[1],0,n[2],o[2],e[2],0,-H(n,r),-H(o,r),-H(e,r),1])}var B=(r,t)=>[r[0]-t[0],r[1]-t[1],r[2]-t[2]],H=(r,t)=>r[0]*
t[0]+r[1]*t[1]+r[2]*t[2],A=(r,t)=>[r[1]*t[2]-r[2]*t[1],r[2]*t[0]-r[0]*t[2],r[0]*t[1]-r[1]*t[0]];function M(r){let t=Math.hypot(...r)||1;return[r[0]/t,r[1]/t,r[2]/
t]}function R(r,t,e,n){let o=M(t),i=M(A(o,Math.abs(o[2])>.9?[1,0,0]:[0,0,1])),s=A(i,o);return new Float32Array([...i.map(a=>a*n),0,...o.map(a=>a*e),0,...s.map(a=>a*
n),0,...r,1])}var Z=([r,t,e])=>new Float32Array([1,0,0,0,0,1,0,0,0,0,1,0,r,t,e,1]);function V(r){let[t,e]=[Math.cos(r),Math.sin(r)];return new Float32Array([t,-e,
0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function b(r){let t=Number.parseInt(r.slice(1,7),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function L(r,t,e){let n=r.createProgram(),o=[[r.VERTEX_SHADER,t],[r.FRAGMENT_SHADER,e]];for(let[s,a]of o){let c=r.createShader(s);if(r.shaderSource(c,a),r.compileShader(
c),!r.getShaderParameter(c,r.COMPILE_STATUS))throw new Error(String(r.getShaderInfoLog(c)));r.attachShader(n,c)}if(r.linkProgram(n),!r.getProgramParameter(n,r.LINK_STATUS))
throw new Error(String(r.getProgramInfoLog(n)));let i={program:n,uniforms:{},attributes:{}};for(let s=0;s<r.getProgramParameter(n,r.ACTIVE_UNIFORMS);s++){let{name:a}=r.
getActiveUniform(n,s);i.uniforms[a]=r.getUniformLocation(n,a)}for(let s=0;s<r.getProgramParameter(n,r.ACTIVE_ATTRIBUTES);s++){let{name:a}=r.getActiveAttrib(n,s);
i.attributes[a]=r.getAttribLocation(n,a)}return i}function E(r,t,e,n){let o=r.createBuffer();r.bindBuffer(r.ARRAY_BUFFER,o),r.bufferData(r.ARRAY_BUFFER,new Float32Array(
t),r.STATIC_DRAW);let i=n?r.createBuffer():null;n&&(r.bindBuffer(r.ELEMENT_ARRAY_BUFFER,i),r.bufferData(r.ELEMENT_ARRAY_BUFFER,new Uint16Array(n),r.STATIC_DRAW));
let s=4*Object.values(e).reduce((a,c)=>a+c,0);return{vertices:o,elements:i,parts:e,stride:s,count:n?n.length:4*t.length/s}}function k(r,t,e){r.bindBuffer(r.ARRAY_BUFFER,
e.vertices);let n=0;for(let[o,i]of Object.entries(e.parts)){let s=t.attributes[o];s!==void 0&&(r.enableVertexAttribArray(s),r.vertexAttribPointer(s,i,r.FLOAT,!1,
e.stride,n)),n+=4*i}e.elements&&r.bindBuffer(r.ELEMENT_ARRAY_BUFFER,e.elements)}function O(r,t){let e=[];for(let n=0;n<r;n++)for(let o=0;o<t;o++){let i=n*(t+1)+
o,s=i+t+1;e.push(i,s,i+1,s,s+1,i+1)}return e}function J(r,t=120,e=14){let n=[];for(let o=0;o<=t;o++)for(let i=0;i<=e;i++)n.push(2*Math.PI*o/t,2*Math.PI*i/e);return E(
r,n,{bend:2},O(t,e))}function Q(r,t=28,e=18){let n=[];for(let o=0;o<=t;o++)for(let i=0;i<=e;i++){let[s,a]=[2*Math.PI*o/t,Math.PI*i/e],c=[Math.sin(a)*Math.cos(s),
Math.cos(a),Math.sin(a)*Math.sin(s)];n.push(...c,...c)}return E(r,n,{position:3,normal:3},O(t,e))}function W(r,t,e=20){let n=[];for(let o=0;o<=e;o++){let i=2*Math.
PI*o/e,s=[Math.cos(i),1-t,Math.sin(i)];n.push(Math.cos(i),0,Math.sin(i),...s,t*Math.cos(i),1,t*Math.sin(i),...s)}return E(r,n,{position:3,normal:3},O(e,1))}var ot=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,st=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,rt="vec4(0.0, 0.0, 0.0, shadow)",tt=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${st}
   void main() {
     float phi = size.w + bend.x;
     vec2 outwards = vec2(sin(phi), cos(phi));
     vec3 p = center + vec3(outwards * (size.x - size.y + size.y * cos(bend.y)), size.z * sin(bend.y));
     n = vec3(outwards * cos(bend.y) / size.y, sin(bend.y) / size.z);
     vec2 v = motion.xy + motion.z * size.x * vec2(cos(phi), -sin(phi));
     speed = length(v) / most;
     gl_Position = view * vec4(flattened(p, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; varying float speed;
   uniform sampler2D colors; uniform vec3 plain; uniform float colored, shadow;
   ${ot}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${rt} : vec4(shaded(color, n), 1.0);
   }`],et=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${st}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${ot}
   void main() { gl_FragColor = shadow > 0.0 ? ${rt} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],nt=[`attribute vec3 position, next, tint; attribute \
float side;
   uniform mat4 view; uniform vec2 pixel; uniform float width, distance, shift, depth;
   varying vec3 color;
   void main() {
     vec3 moved = vec3(-shift, 0.0, depth);
     vec4 a = view * vec4(position + moved, 1.0);
     vec4 b = view * vec4(next + moved, 1.0);
     vec2 way = (b.xy / b.w - a.xy / a.w) / pixel;
     float size = length(way);
     vec2 across = size > 1e-6 ? vec2(-way.y, way.x) / size : vec2(0.0, 1.0);
     float wide = distance > 0.0 ? width * distance / a.w : width;
     a.xy += across * side * wide * pixel * a.w;
     gl_Position = a;
     color = tint;
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],P=class{constructor(t,e,n,o,{keep:i=!1}={}){this.canvas=t;this.
dark=o;this.eye=[0,0,1];this.fastest=1;let s=t.getContext("webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:i});if(!s)throw new Error("This browser draws n\
othing in space (WebGL is missing).");this.gl=s,this.sun=M(n),this.slant=[n[0]/n[1],1,n[2]/n[1]],this.rim=L(s,tt[0],tt[1]),this.body=L(s,et[0],et[1]),this.line=
L(s,nt[0],nt[1]),this.torus=J(s),this.sphere=Q(s),this.cylinder=W(s,1),this.cone=W(s,0),this.colors=s.createTexture(),s.bindTexture(s.TEXTURE_2D,this.colors);let a=new Uint8Array(
e.flatMap(c=>[...c,255]));s.pixelStorei(s.UNPACK_ALIGNMENT,1),s.texImage2D(s.TEXTURE_2D,0,s.RGBA,e.length,1,0,s.RGBA,s.UNSIGNED_BYTE,a);for(let c of[s.TEXTURE_WRAP_S,
s.TEXTURE_WRAP_T])s.texParameteri(s.TEXTURE_2D,c,s.CLAMP_TO_EDGE);for(let c of[s.TEXTURE_MIN_FILTER,s.TEXTURE_MAG_FILTER])s.texParameteri(s.TEXTURE_2D,c,s.LINEAR);
this.view=V(0)}begin({background:t,eye:e,target:n,slope:o,angle:i,near:s,far:a}){let{gl:c,canvas:l}=this;c.viewport(0,0,l.width,l.height),c.clearColor(t[0],t[1],
t[2],1),c.clear(c.COLOR_BUFFER_BIT|c.DEPTH_BUFFER_BIT|c.STENCIL_BUFFER_BIT),c.enable(c.DEPTH_TEST);let h=K(i,l.width/l.height,s,a);this.view=U(U(h,q(e,n)),V(o)),
this.eye=M(B(e,n))}use(t,e){let{gl:n}=this;n.useProgram(t.program);let o={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[i,s]of Object.
entries(o)){let a=t.uniforms[i];a!==void 0&&(typeof s=="number"?n.uniform1f(a,s):s.length===16?n.uniformMatrix4fv(a,!1,s):n[`uniform${s.length}fv`](a,s))}}ground(t){
let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.
ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),e.
depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,n,{shadow:o=!1,lit:i=!0}={}){let{gl:s}=this;this.use(this.body,{model:e,color:n,shadow:o?
this.dark:0,lit:Number(i)}),k(s,this.body,t),s.drawElements(s.TRIANGLES,t.count,s.UNSIGNED_SHORT,0)}ball(t,e,n,o){this.solid(this.sphere,R(t,[0,1,0],e,e),n,{shadow:o})}ring({
center:t,radius:e,tube:n,broad:o,angle:i,velocity:s,omega:a,plain:c=null},l){let{gl:h}=this;this.use(this.rim,{center:t,size:[e,n,o,i],motion:[...s,a],most:this.
fastest,shadow:l?this.dark:0,plain:c??[0,0,0],colored:c?0:1}),k(h,this.rim,this.torus),h.drawElements(h.TRIANGLES,this.torus.count,h.UNSIGNED_SHORT,0)}rod(t,e,n,o,i,s=!1){
this.solid(this.cylinder,R(t,e,n,o),i,{shadow:s})}arrow(t,e,n,o,i){if(!(n>.02*o))return;let s=Math.min(.18*o,n),a=t.map((c,l)=>c+e[l]*(n-s));n>s&&this.rod(t,e,n-
s,.029*o,i),this.solid(this.cone,R(a,e,s,Math.min(.075*o,.6*s)),i)}trace(t,e,n){let o=[];for(let i=0;i<t;i++){let s=e(i),a=e(Math.min(i+1,t-1));if(Math.hypot(a[0]-
s[0],a[1]-s[1])<1e-9&&i>0){let c=e(i-1);a=s.map((l,h)=>2*l-c[h])}for(let c of[-1,1])o.push(...s,0,...a,0,...n(i),c)}return E(this.gl,o,{position:3,next:3,tint:3,
side:1})}drawTrace(t,e,{width:n,distance:o=0,shift:i,depth:s}){let{gl:a,canvas:c}=this;this.use(this.line,{pixel:[2/c.width,2/c.height],width:n,distance:o,shift:i,
depth:s}),k(a,this.line,t),a.drawArrays(a.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,n]){let o=this.view,[i,s,a]=[0,1,3].map(c=>o[c]*t+o[4+c]*e+o[8+c]*n+o[12+c]);return a>
0?[(.5+.5*i/a)*this.canvas.width,(.5-.5*s/a)*this.canvas.height]:null}};function I([r,t],[e,n]){return{data:[[r,n],[r,e],[t,n],[t,e]].flatMap(([o,i])=>[o,0,i,0,
1,0]),indices:[0,1,2,1,3,2]}}function _(r,t){let e=t.flatMap((n,o)=>n.indices.map(i=>i+4*o));return E(r,t.flatMap(n=>n.data),{position:3,normal:3},e)}var it=.5,ht=.45,mt=6,ut='"DejaVu Sans", system-ui, sans-serif';function at(r,{space:t,data:e},{hoop:n},o,i,s,a){let c=f(n.t,o),l=-n.lane+.35*e.radius;r.strokeStyle=
e.theme.ink,r.fillStyle=e.theme.ink,r.font=`${12*a}px ${ut}`;let h=-1/0,m=n.marks.filter(([u])=>u<=c).sort((u,g)=>u[1]-g[1]);for(let[u,g,w,d]of m){let v=t.onScreen(
[g-i,0,l]);if(!v)continue;let[x,N]=v,j=(c-u)/e.rate[Math.floor(o)];j<it&&dt(r,x,N,j/it,n.radius*s,a),ft(r,w,x,N+12*a,mt*a);let z=.5*r.measureText(d).width;x-z<h||
(r.fillText(d,x,N+34*a),h=x+z+6*a)}}function dt(r,t,e,n,o,i){r.globalAlpha=1-n,r.lineWidth=(3*(1-n)+.6)*i,r.beginPath(),r.arc(t,e,(.08+ht*n)*o,0,2*Math.PI),r.stroke(),
r.globalAlpha=1}function ft(r,t,e,n,o){if(r.beginPath(),t==="takeoff"||t==="impact"){let i=t==="takeoff"?-o:o;r.moveTo(e-o,n-i),r.lineTo(e+o,n-i),r.lineTo(e,n+i),
r.fill();return}r.lineWidth=.4*o;for(let i of[-o,o])r.moveTo(e-o,n-i),r.lineTo(e+o,n+i);r.stroke()}var G=.05,bt=.1,pt=.05,gt=[-.32,1,.75],wt=.38,ct='"DejaVu Sans", system-ui, sans-serif',lt=(r,t,e)=>r.map((n,o)=>n+e*(t[o]-n)),C=class{constructor(t,e,n){this.canvas=
t;this.labels=e;this.data=n;this.space=new P(this.canvas,this.data.map,gt,wt);this.metre=1;this.space.fastest=n.topSpeed,this.half=Math.max(...n.hoops.map(s=>Math.
abs(s.lane)))+1.1*n.radius;let o=Math.ceil((n.along[0]-6*n.radius)/n.grid),i=Math.min(Math.floor((n.along[1]+6*n.radius)/n.grid),o+1999);this.marks=Array.from({
length:Math.max(i-o+1,0)},(s,a)=>(o+a)*n.grid),this.floor=this.floorMeshes(),this.traces=n.hoops.map(s=>s.traces&&this.traceMeshes(s.traces))}floorMeshes(){let{
data:t,half:e,space:n}=this,o=t.radius,i=[t.along[0]-40*o,t.along[1]+40*o],s=[e,-e];return{plane:_(n.gl,[I(i,[40*o,-40*o])]),track:_(n.gl,[I(i,s)]),bars:_(n.gl,
this.marks.map(a=>I([a-.008*o,a+.008*o],s)))}}traceMeshes({load:t,heavy:e,airborne:n}){let{theme:o,colors:i}=this.data,s=b(o.load),[a,c]=[b(i.center),b(i.airborne)],
l=(h,m)=>this.space.trace(h.length/2,u=>[h[2*u],h[2*u+1]],m);return{load:l(t,()=>s),heavy:l(e,h=>n[h]?c:a)}}draw(t,e){let{canvas:n,labels:o,data:i,space:s}=this,
a=window.devicePixelRatio||1,[c,l]=[Math.round(n.clientWidth*a),Math.round(n.clientHeight*a)];for(let d of[n,o])(d.width!==c||d.height!==l)&&Object.assign(d,{width:c,
height:l});let h=e.focus(t),m=e.view(c>l);s.begin({background:b(i.theme.background),...m}),s.ground(()=>this.drawFloor(h));let u=i.hoops.map(d=>this.pose(d,t,h));
s.shadows(()=>{for(let d of u)this.drawHoop(d,!0)});let g=l/(2*e.away*Math.tan(.5*m.angle));for(let[d,v]of u.entries())this.drawHoop(v,!1),this.drawTraces(i.hoops[d],
this.traces[d],t,h,g,e.away),i.newton&&this.drawForces(i.hoops[d],i.newton[Math.floor(t)],t,h);let w=o.getContext("2d");w.clearRect(0,0,o.width,o.height),w.textAlign=
"center",this.drawNumbers(w,h,a);for(let d of u)at(w,this,d,t,h,g,a);for(let{hoop:d,center:v}of u)this.drawTag(w,d.tag,v,a);this.metre=g/a}pose(t,e,n){let o=f(t.
angle,e),i=[Math.sin(o),Math.cos(o),0],s=[f(t.center,e,2)-n,f(t.center,e,2,1),-t.lane];return{hoop:t,center:s,angle:o,velocity:[f(t.velocity,e,2),f(t.velocity,e,
2,1)],omega:f(t.omega,e),airborne:t.mode[Math.floor(e)]===this.data.flight,at:a=>s.map((c,l)=>c+a*i[l])}}drawFloor(t){let{theme:e}=this.data,[n,o]=[b(e.ground),
b(e.ink)],i=Z([-t,0,0]);this.space.solid(this.floor.plane,i,n,{lit:!1}),this.space.solid(this.floor.track,i,lt(n,o,.06),{lit:!1}),this.space.solid(this.floor.bars,
i,lt(n,o,.25),{lit:!1})}drawHoop({hoop:t,center:e,angle:n,velocity:o,omega:i,airborne:s,at:a},c){let{space:l,data:h}=this,{radius:m}=t;l.ring({center:e,radius:m,
tube:G*m,broad:G*m,angle:n,velocity:o,omega:i},c),l.ball(a(t.load),bt*m,b(h.theme.load),c);let u=s?h.colors.airborne:h.colors.center;c||l.ball(a(t.heavy),pt*m,b(
u),c)}drawTraces(t,e,n,o,i,s){if(e===null||t.traces===null)return;let a=f(t.t,n),c=t.traces.t.findIndex(u=>u>a),l=c<0?t.traces.t.length:c,h=this.data.radius,m={
distance:s,shift:o,depth:-t.lane};this.space.drawTrace(e.load,l,{width:.011*h*i,...m}),this.space.drawTrace(e.heavy,l,{width:.016*h*i,...m})}drawForces(t,e,n,o){
let{data:i,space:s}=this,a=Math.floor(n),c=-t.lane+(G+.04)*t.radius,l=[f(t.contact,n,2)-o,f(t.contact,n,2,1),c],[h,m]=[t.normalForce[a],t.frictionForce[a]].map(
u=>e*u);s.arrow(l,[0,Math.sign(h),0],Math.abs(h),i.radius,b(i.colors.normal)),s.arrow(l,[Math.sign(m),0,0],Math.abs(m),i.radius,b(i.colors.friction))}drawTag(t,e,n,o){
let i=e&&this.space.onScreen(n);if(!i)return;let{theme:s}=this.data;t.beginPath(),t.arc(i[0],i[1],10*o,0,2*Math.PI),t.fillStyle=s.background,t.fill(),t.strokeStyle=
s.ink,t.lineWidth=1.2*o,t.stroke(),t.fillStyle=s.ink,t.font=`bold ${12*o}px ${ct}`,t.fillText(e,i[0],i[1]+4.3*o)}drawNumbers(t,e,n){let{labels:o,data:i,half:s}=this;
t.fillStyle=i.theme.muted,t.font=`${13*n}px ${ct}`;let a=-1e9;for(let c of this.marks){let l=this.space.onScreen([c-e,0,s+.15*i.radius]);if(!l)continue;let[h,m]=l;
!(h>=0&&h<=o.width&&m>=0&&m<=o.height-50*n)||Math.abs(h-a)<55*n||(t.fillText(`${+c.toPrecision(6)} m`.replace("-","−"),h,m+12*n),a=h)}}};var T=r=>document.getElementById(r),y=(r,t,...e)=>{let n=document.createElement(r);return n.className=t,n.append(...e),n},F=class{constructor(t){this.data=t;document.
body.style.background=t.theme.background,document.body.style.color=t.theme.ink,this.rows=t.hoops.map(e=>this.row(e)),this.scale(),this.key()}row(t){let[e,n,o,i]=[
"dot","word","t","angle"].map(a=>y("span",a)),s=y("span","label",t.tag?`${t.tag}: ${t.label}`:t.label);return T("words").append(y("div","row",y("span","mode",e,
n),o,i,s)),{dot:e,word:n,time:o,angle:i}}scale(){let{map:t,topSpeed:e}=this.data,n=t.map(s=>`rgb(${s.join(",")})`).join(",");T("bar").style.background=`linear-g\
radient(to right, ${n})`;let o=10**Math.floor(Math.log10(e/3)),i=[5,2,1].map(s=>s*o).find(s=>s<=e/3*1.000001)??o;for(let s=0;s<=e;s+=i){let a=y("span","",String(
+s.toPrecision(6)));a.style.left=`${100*s/e}%`,T("ticks").append(a)}}key(){let{hoops:t,colors:e,theme:n,newton:o,flies:i}=this.data,s=[];t.some(a=>a.traces!==null)&&
(s.push([n.load,"load"],[e.center,"centre of gravity"]),i&&s.push([e.airborne,"airborne"])),o&&s.push([e.normal,"normal force"],[e.friction,"friction"]);for(let[
a,c]of s){let l=document.createElement("i");l.style.borderColor=a,T("lines").append(y("span","",l,c))}o&&(this.ruler=document.createElement("i"),this.force=document.
createTextNode(""),T("lines").append(y("span","ruler",this.ruler,this.force)))}showScale(t,e){if(!this.ruler||!this.force)return;let n=90/(t*e),o=10**Math.floor(
Math.log10(n)),i=[5,2,1].map(s=>s*o).find(s=>s<=n*1.000001)??o;this.ruler.style.width=`${(i*t*e).toFixed(1)}px`,this.force.textContent=`${+i.toPrecision(6)} N`}show(t,e){
let n=Math.floor(t);this.data.newton&&this.showScale(this.data.newton[n],e);for(let[o,i]of this.data.hoops.entries()){let[s,a]=this.data.modes[i.mode[n]],c=this.
rows[o],l=(i.angle[n]*180/Math.PI).toFixed(1);c.dot.style.background=a,c.word.textContent=s,c.time.textContent=`t = ${i.t[n].toFixed(3)} s`,c.angle.textContent=
`θ = ${l}°`.replace("-","−")}}};var p=r=>document.getElementById(r),$=class{constructor(t){this.data=t;this.last=this.data.count-1;this.now=0;this.before=null;this.button=p("play");this.slider=
p("time");this.rate=p("rate");this.follow=p("follow");let e=p("scene");this.picture=new C(e,p("labels"),t),this.camera=new S(e,t,()=>this.follow.checked),this.words=
new F(t),this.slider.max=String(this.last),this.button.onclick=()=>this.toggle(),this.slider.oninput=()=>{this.now=Number(this.slider.value),this.play(!1)},p("r\
eset").onclick=()=>this.camera.reset(),document.addEventListener("keydown",n=>this.key(n)),this.play(!0),this.open(location.hash),requestAnimationFrame(n=>this.
tick(n))}open(t){let e=/t=([\d.]+)/.exec(t);if(!e)return;let n=this.data.hoops[0].t.findIndex(o=>o>=Number(e[1]));this.now=n<0?this.last:n,this.slider.value=String(
this.now),this.play(!1)}play(t){this.playing=t,t||(this.now=Math.floor(this.now)),this.button.textContent=t?"Pause":"Play"}toggle(){!this.playing&&this.now>=this.
last&&(this.now=0),this.play(!this.playing)}key(t){if(t.target.tagName==="SELECT"||t.target===this.button)return;t.key===" "&&(this.toggle(),t.preventDefault());
let e=t.key==="ArrowRight"?1:t.key==="ArrowLeft"?-1:0;!e||t.target===this.slider||(this.play(!1),this.now=Math.min(Math.max(Math.round(this.now)+e,0),this.last))}tick(t){
this.playing&&this.before!==null&&(this.now+=(t-this.before)/1e3*this.data.fps*Number(this.rate.value),this.now>=this.last&&(this.now=this.last,this.play(!1)),this.
slider.value=String(this.now)),this.before=t,this.picture.draw(this.now,this.camera),this.words.show(this.now,this.picture.metre),requestAnimationFrame(e=>this.
tick(e))}};try{new $(X(p("data").textContent))}catch(r){p("problem").textContent=r.message,p("problem").style.display="flex"}})();
