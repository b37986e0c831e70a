/* Built from web/scene/main.js by esbuild 0.28.2; sources 9a4d4bb0b07a0c045e287e5cd1307514 */
"use strict";(()=>{var k=r=>{if(Array.isArray(r))return r.map(k);if(r===null||typeof r!="object")return r;if(r.f32!==void 0){let e=Uint8Array.from(atob(r.f32),t=>t.charCodeAt(0));
return new Float32Array(e.buffer)}return Object.fromEntries(Object.entries(r).map(([e,t])=>[e,k(t)]))};function z(r,e){let[t,s]=[Math.cos(e),Math.sin(e)],n=new Float32Array(
r.length);for(let i=0;i<r.length;i+=2)n[i]=r[i]*t-r[i+1]*s,n[i+1]=r[i]*s+r[i+1]*t;return n}function H(r){let e=k(JSON.parse(r));for(let t of e.hoops){for(let s of[
"center","contact","velocity"])t[s]=z(t[s],e.slope);if(t.traces!==null)for(let s of["load","heavy"])t.traces[s]=z(t.traces[s],e.slope)}return e}function f(r,e,t=1,s=0){
let n=Math.floor(e),i=Math.min(n+1,r.length/t-1),o=e-n;return r[n*t+s]*(1-o)+r[i*t+s]*o}var v=class{turn;rise;away;shift;along;constructor(e,t,s){this.data=t,this.follows=s;let n=Math.max(...t.hoops.map(i=>Math.abs(i.lane)));this.home={turn:-.35,rise:.2,
away:7*t.radius+2*n+1.5*t.height,shift:[0,0,0]},this.reset(),this.along=null,this.listen(e)}reset(){Object.assign(this,this.home,{shift:[...this.home.shift]})}closer(e){
let t=this.data.radius;this.away=Math.min(Math.max(this.away*e,2*t),200*t)}focus(e){let{hoops:t,along:s}=this.data,n=this.follows()?t.reduce((i,o)=>i+f(o.center,
e,2)/t.length,0):.5*(s[0]+s[1]);return this.along=this.along===null?n:this.along+(n-this.along)*.12,this.along}view(e){let{radius:t,slope:s}=this.data,n=.95*t,i=[
n*Math.sin(s),n*Math.cos(s),0].map((c,h)=>c+this.shift[h]),o=Math.cos(this.rise),a=[Math.sin(this.turn)*o,Math.sin(this.rise),Math.cos(this.turn)*o];return{eye:i.
map((c,h)=>c+this.away*a[h]),target:i,slope:s,angle:e?.56:.9,near:.05*this.away,far:12*this.away+60*t}}listen(e){let t=new Map;e.addEventListener("pointerdown",
s=>{e.setPointerCapture(s.pointerId),t.set(s.pointerId,s)});for(let s of["pointerup","pointercancel"])e.addEventListener(s,n=>t.delete(n.pointerId));e.addEventListener(
"pointermove",s=>{let n=t.get(s.pointerId);if(!n)return;let[i,o]=[s.clientX-n.clientX,s.clientY-n.clientY];if(t.size===2){let[a]=[...t.values()].filter(h=>h.pointerId!==
s.pointerId),c=h=>Math.hypot(h.clientX-a.clientX,h.clientY-a.clientY);this.closer(c(n)/Math.max(c(s),1))}else if(s.shiftKey||s.buttons===2){let a=this.away/e.clientHeight;
this.shift[0]-=i*a*Math.cos(this.turn),this.shift[1]+=o*a,this.shift[2]+=i*a*Math.sin(this.turn)}else this.turn-=i*.008,this.rise=Math.min(Math.max(this.rise+o*
.006,.02),1.5);t.set(s.pointerId,s)}),e.addEventListener("wheel",s=>{this.closer(Math.exp(s.deltaY*.001)),s.preventDefault()},{passive:!1}),e.addEventListener("\
contextmenu",s=>s.preventDefault())}};function N(r,e){let t=new Float32Array(16);for(let s=0;s<4;s++)for(let n=0;n<4;n++){let i=0;for(let o=0;o<4;o++)i+=r[4*o+n]*e[4*s+o];t[4*s+n]=i}return t}function Y(r,e,t,s){
let n=1/Math.tan(r/2),i=1/(t-s);return new Float32Array([n/e,0,0,0,0,n,0,0,0,0,(s+t)*i,-1,0,0,2*s*t*i,0])}function j(r,e){let t=g(P(r,e)),s=g(M([0,1,0],t)),n=M(
t,s);return new Float32Array([s[0],n[0],t[0],0,s[1],n[1],t[1],0,s[2],n[2],t[2],0,-L(s,r),-L(n,r),-L(t,r),1])}var P=(r,e)=>[r[0]-e[0],r[1]-e[1],r[2]-e[2]],L=(r,e)=>r[0]*
e[0]+r[1]*e[1]+r[2]*e[2],M=(r,e)=>[r[1]*e[2]-r[2]*e[1],r[2]*e[0]-r[0]*e[2],r[0]*e[1]-r[1]*e[0]];function g(r){let e=Math.hypot(...r)||1;return[r[0]/e,r[1]/e,r[2]/
e]}function E(r,e,t,s){let n=g(e),i=g(M(n,Math.abs(n[2])>.9?[1,0,0]:[0,0,1])),o=M(i,n);return new Float32Array([...i.map(a=>a*s),0,...n.map(a=>a*t),0,...o.map(a=>a*
s),0,...r,1])}var $=([r,e,t])=>new Float32Array([1,0,0,0,0,1,0,0,0,0,1,0,r,e,t,1]);function U(r){let[e,t]=[Math.cos(r),Math.sin(r)];return new Float32Array([e,-t,
0,0,t,e,0,0,0,0,1,0,0,0,0,1])}function m(r){let e=Number.parseInt(r.slice(1,7),16);return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}function x(r,e,t){let s=r.createProgram(),n=[[r.VERTEX_SHADER,e],[r.FRAGMENT_SHADER,t]];for(let[o,a]of n){let c=r.createShader(o);if(r.shaderSource(c,a),r.compileShader(
c),!r.getShaderParameter(c,r.COMPILE_STATUS))throw new Error(String(r.getShaderInfoLog(c)));r.attachShader(s,c)}if(r.linkProgram(s),!r.getProgramParameter(s,r.LINK_STATUS))
throw new Error(String(r.getProgramInfoLog(s)));let i={program:s,uniforms:{},attributes:{}};for(let o=0;o<r.getProgramParameter(s,r.ACTIVE_UNIFORMS);o++){let{name:a}=r.
getActiveUniform(s,o);i.uniforms[a]=r.getUniformLocation(s,a)}for(let o=0;o<r.getProgramParameter(s,r.ACTIVE_ATTRIBUTES);o++){let{name:a}=r.getActiveAttrib(s,o);
i.attributes[a]=r.getAttribLocation(s,a)}return i}function y(r,e,t,s){let n=r.createBuffer();r.bindBuffer(r.ARRAY_BUFFER,n),r.bufferData(r.ARRAY_BUFFER,new Float32Array(
e),r.STATIC_DRAW);let i=s?r.createBuffer():null;s&&(r.bindBuffer(r.ELEMENT_ARRAY_BUFFER,i),r.bufferData(r.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),r.STATIC_DRAW));
let o=4*Object.values(t).reduce((a,c)=>a+c,0);return{vertices:n,elements:i,parts:t,stride:o,count:s?s.length:4*e.length/o}}function A(r,e,t){r.bindBuffer(r.ARRAY_BUFFER,
t.vertices);let s=0;for(let[n,i]of Object.entries(t.parts)){let o=e.attributes[n];o!==void 0&&(r.enableVertexAttribArray(o),r.vertexAttribPointer(o,i,r.FLOAT,!1,
t.stride,s)),s+=4*i}t.elements&&r.bindBuffer(r.ELEMENT_ARRAY_BUFFER,t.elements)}function D(r,e){let t=[];for(let s=0;s<r;s++)for(let n=0;n<e;n++){let i=s*(e+1)+
n,o=i+e+1;t.push(i,o,i+1,o,o+1,i+1)}return t}function G(r,e=120,t=14){let s=[];for(let n=0;n<=e;n++)for(let i=0;i<=t;i++)s.push(2*Math.PI*n/e,2*Math.PI*i/t);return y(
r,s,{bend:2},D(e,t))}function X(r,e=28,t=18){let s=[];for(let n=0;n<=e;n++)for(let i=0;i<=t;i++){let[o,a]=[2*Math.PI*n/e,Math.PI*i/t],c=[Math.sin(a)*Math.cos(o),
Math.cos(a),Math.sin(a)*Math.sin(o)];s.push(...c,...c)}return y(r,s,{position:3,normal:3},D(e,t))}function B(r,e,t=20){let s=[];for(let n=0;n<=t;n++){let i=2*Math.
PI*n/t,o=[Math.cos(i),1-e,Math.sin(i)];s.push(Math.cos(i),0,Math.sin(i),...o,e*Math.cos(i),1,e*Math.sin(i),...o)}return y(r,s,{position:3,normal:3},D(t,1))}var q=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,J=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Q="vec4(0.0, 0.0, 0.0, shadow)",W=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${J}
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
   ${q}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Q} : vec4(shaded(color, n), 1.0);
   }`],V=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${J}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${q}
   void main() { gl_FragColor = shadow > 0.0 ? ${Q} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],K=[`attribute vec3 position, next, tint; attribute fl\
oat side;
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],T=class{constructor(e,t,s,n,{keep:i=!1}={}){let o=e.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:i});if(!o)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=o,this.canvas=
e,this.sun=g(s),this.dark=n,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=x(o,W[0],W[1]),this.body=x(o,V[0],V[1]),this.line=x(o,K[0],K[1]),this.torus=G(o),this.sphere=
X(o),this.cylinder=B(o,1),this.cone=B(o,0),this.colors=o.createTexture(),o.bindTexture(o.TEXTURE_2D,this.colors);let a=new Uint8Array(t.flatMap(c=>[...c,255]));
o.pixelStorei(o.UNPACK_ALIGNMENT,1),o.texImage2D(o.TEXTURE_2D,0,o.RGBA,t.length,1,0,o.RGBA,o.UNSIGNED_BYTE,a);for(let c of[o.TEXTURE_WRAP_S,o.TEXTURE_WRAP_T])o.
texParameteri(o.TEXTURE_2D,c,o.CLAMP_TO_EDGE);for(let c of[o.TEXTURE_MIN_FILTER,o.TEXTURE_MAG_FILTER])o.texParameteri(o.TEXTURE_2D,c,o.LINEAR);this.view=U(0),this.
eye=[0,0,1],this.fastest=1}begin({background:e,eye:t,target:s,slope:n,angle:i,near:o,far:a}){let{gl:c,canvas:h}=this;c.viewport(0,0,h.width,h.height),c.clearColor(
e[0],e[1],e[2],1),c.clear(c.COLOR_BUFFER_BIT|c.DEPTH_BUFFER_BIT|c.STENCIL_BUFFER_BIT),c.enable(c.DEPTH_TEST);let l=Y(i,h.width/h.height,o,a);this.view=N(N(l,j(t,
s)),U(n)),this.eye=g(P(t,s))}use(e,t){let{gl:s}=this;s.useProgram(e.program);let n={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...t};for(let[i,o]of Object.
entries(n)){let a=e.uniforms[i];a!==void 0&&(typeof o=="number"?s.uniform1f(a,o):o.length===16?s.uniformMatrix4fv(a,!1,o):s[`uniform${o.length}fv`](a,o))}}ground(e){
let{gl:t}=this;t.depthFunc(t.ALWAYS),e(),t.depthFunc(t.LESS)}shadows(e){let{gl:t}=this;t.enable(t.BLEND),t.blendFuncSeparate(t.SRC_ALPHA,t.ONE_MINUS_SRC_ALPHA,t.
ZERO,t.ONE),t.enable(t.STENCIL_TEST),t.stencilFunc(t.EQUAL,0,255),t.stencilOp(t.KEEP,t.KEEP,t.INCR),t.depthFunc(t.ALWAYS),t.depthMask(!1),e(),t.depthMask(!0),t.
depthFunc(t.LESS),t.disable(t.STENCIL_TEST),t.disable(t.BLEND)}solid(e,t,s,{shadow:n=!1,lit:i=!0}={}){let{gl:o}=this;this.use(this.body,{model:t,color:s,shadow:n?
this.dark:0,lit:Number(i)}),A(o,this.body,e),o.drawElements(o.TRIANGLES,e.count,o.UNSIGNED_SHORT,0)}ball(e,t,s,n){this.solid(this.sphere,E(e,[0,1,0],t,t),s,{shadow:n})}ring({
center:e,radius:t,tube:s,broad:n,angle:i,velocity:o,omega:a,plain:c=null},h){let{gl:l}=this;this.use(this.rim,{center:e,size:[t,s,n,i],motion:[...o,a],most:this.
fastest,shadow:h?this.dark:0,plain:c??[0,0,0],colored:c?0:1}),A(l,this.rim,this.torus),l.drawElements(l.TRIANGLES,this.torus.count,l.UNSIGNED_SHORT,0)}rod(e,t,s,n,i,o=!1){
this.solid(this.cylinder,E(e,t,s,n),i,{shadow:o})}arrow(e,t,s,n,i){if(!(s>.02*n))return;let o=Math.min(.18*n,s),a=e.map((c,h)=>c+t[h]*(s-o));s>o&&this.rod(e,t,s-
o,.029*n,i),this.solid(this.cone,E(a,t,o,Math.min(.075*n,.6*o)),i)}trace(e,t,s){let n=[];for(let i=0;i<e;i++){let o=t(i),a=t(Math.min(i+1,e-1));if(Math.hypot(a[0]-
o[0],a[1]-o[1])<1e-9&&i>0){let c=t(i-1);a=o.map((h,l)=>2*h-c[l])}for(let c of[-1,1])n.push(...o,0,...a,0,...s(i),c)}return y(this.gl,n,{position:3,next:3,tint:3,
side:1})}drawTrace(e,t,{width:s,distance:n=0,shift:i,depth:o}){let{gl:a,canvas:c}=this;this.use(this.line,{pixel:[2/c.width,2/c.height],width:s,distance:n,shift:i,
depth:o}),A(a,this.line,e),a.drawArrays(a.TRIANGLE_STRIP,0,2*t)}onScreen([e,t,s]){let n=this.view,[i,o,a]=[0,1,3].map(c=>n[c]*e+n[4+c]*t+n[8+c]*s+n[12+c]);return a>
0?[(.5+.5*i/a)*this.canvas.width,(.5-.5*o/a)*this.canvas.height]:null}};function R([r,e],[t,s]){return{data:[[r,s],[r,t],[e,s],[e,t]].flatMap(([n,i])=>[n,0,i,0,
1,0]),indices:[0,1,2,1,3,2]}}function S(r,e){let t=e.flatMap((s,n)=>s.indices.map(i=>i+4*n));return y(r,e.flatMap(s=>s.data),{position:3,normal:3},t)}var C=.05,st=.1,ot=.05,nt=[-.32,1,.75],it=.38,rt='"DejaVu Sans", system-ui, sans-serif',Z=(r,e,t)=>r.map((s,n)=>s+t*(e[n]-s)),_=class{constructor(e,t,s){this.canvas=
e,this.labels=t,this.data=s,this.space=new T(e,s.map,nt,it),this.space.fastest=s.topSpeed,this.half=Math.max(...s.hoops.map(o=>Math.abs(o.lane)))+1.1*s.radius;let n=Math.
ceil((s.along[0]-6*s.radius)/s.grid),i=Math.min(Math.floor((s.along[1]+6*s.radius)/s.grid),n+1999);this.marks=Array.from({length:Math.max(i-n+1,0)},(o,a)=>(n+a)*
s.grid),this.floor=this.floorMeshes(),this.traces=s.hoops.map(o=>o.traces&&this.traceMeshes(o.traces))}floorMeshes(){let{data:e,half:t,space:s}=this,n=e.radius,
i=[e.along[0]-40*n,e.along[1]+40*n],o=[t,-t];return{plane:S(s.gl,[R(i,[40*n,-40*n])]),track:S(s.gl,[R(i,o)]),bars:S(s.gl,this.marks.map(a=>R([a-.008*n,a+.008*n],
o)))}}traceMeshes({load:e,heavy:t,airborne:s}){let{theme:n,colors:i}=this.data,o=m(n.load),[a,c]=[m(i.center),m(i.airborne)],h=(l,d)=>this.space.trace(l.length/
2,p=>[l[2*p],l[2*p+1]],d);return{load:h(e,()=>o),heavy:h(t,l=>s[l]?c:a)}}draw(e,t){let{canvas:s,labels:n,data:i,space:o}=this,a=window.devicePixelRatio||1,[c,h]=[
Math.round(s.clientWidth*a),Math.round(s.clientHeight*a)];for(let u of[s,n])(u.width!==c||u.height!==h)&&Object.assign(u,{width:c,height:h});let l=t.focus(e),d=t.
view(c>h);o.begin({background:m(i.theme.background),...d}),o.ground(()=>this.drawFloor(l));let p=i.hoops.map(u=>this.pose(u,e,l));o.shadows(()=>{for(let u of p)
this.drawHoop(u,!0)});let tt=h/(2*t.away*Math.tan(.5*d.angle));for(let[u,et]of p.entries())this.drawHoop(et,!1),this.drawTraces(i.hoops[u],this.traces[u],e,l,tt,
t.away),i.newton>0&&this.drawForces(i.hoops[u],e,l);this.drawNumbers(l,a)}pose(e,t,s){let n=f(e.angle,t),i=[Math.sin(n),Math.cos(n),0],o=[f(e.center,t,2)-s,f(e.
center,t,2,1),-e.lane];return{hoop:e,center:o,angle:n,velocity:[f(e.velocity,t,2),f(e.velocity,t,2,1)],omega:f(e.omega,t),airborne:e.mode[Math.floor(t)]===this.
data.flight,at:a=>o.map((c,h)=>c+a*i[h])}}drawFloor(e){let{theme:t}=this.data,[s,n]=[m(t.ground),m(t.ink)],i=$([-e,0,0]);this.space.solid(this.floor.plane,i,s,{
lit:!1}),this.space.solid(this.floor.track,i,Z(s,n,.06),{lit:!1}),this.space.solid(this.floor.bars,i,Z(s,n,.25),{lit:!1})}drawHoop({hoop:e,center:t,angle:s,velocity:n,
omega:i,airborne:o,at:a},c){let{space:h,data:l}=this,{radius:d}=e;h.ring({center:t,radius:d,tube:C*d,broad:C*d,angle:s,velocity:n,omega:i},c),h.ball(a(e.load),st*
d,m(l.theme.load),c);let p=o?l.colors.airborne:l.colors.center;c||h.ball(a(e.heavy),ot*d,m(p),c)}drawTraces(e,t,s,n,i,o){if(t===null||e.traces===null)return;let a=f(
e.t,s),c=e.traces.t.findIndex(p=>p>a),h=c<0?e.traces.t.length:c,l=this.data.radius,d={distance:o,shift:n,depth:-e.lane};this.space.drawTrace(t.load,h,{width:.011*
l*i,...d}),this.space.drawTrace(t.heavy,h,{width:.016*l*i,...d})}drawForces(e,t,s){let{data:n,space:i}=this,o=Math.floor(t),a=-e.lane+(C+.04)*e.radius,c=[f(e.contact,
t,2)-s,f(e.contact,t,2,1),a],[h,l]=[e.normalForce[o],e.frictionForce[o]].map(d=>n.newton*d);i.arrow(c,[0,Math.sign(h),0],Math.abs(h),n.radius,m(n.colors.normal)),
i.arrow(c,[Math.sign(l),0,0],Math.abs(l),n.radius,m(n.colors.friction))}drawNumbers(e,t){let{labels:s,data:n,half:i}=this,o=s.getContext("2d");o.clearRect(0,0,s.
width,s.height),o.fillStyle=n.theme.muted,o.textAlign="center",o.font=`${13*t}px ${rt}`;let a=-1e9;for(let c of this.marks){let h=this.space.onScreen([c-e,0,i+.15*
n.radius]);if(!h)continue;let[l,d]=h;!(l>=0&&l<=s.width&&d>=0&&d<=s.height-50*t)||Math.abs(l-a)<55*t||(o.fillText(`${+c.toPrecision(6)} m`.replace("-","−"),l,
d+12*t),a=l)}}};var F=r=>document.getElementById(r),b=(r,e,...t)=>{let s=document.createElement(r);return s.className=e,s.append(...t),s},I=class{constructor(e){this.data=e,document.
body.style.background=e.theme.background,document.body.style.color=e.theme.ink,this.rows=e.hoops.map(t=>this.row(t)),this.scale(),this.key()}row(e){let[t,s,n,i]=[
"dot","word","t","angle"].map(a=>b("span",a)),o=b("span","label",e.label);return F("words").append(b("div","row",b("span","mode",t,s),n,i,o)),{dot:t,word:s,time:n,
angle:i}}scale(){let{map:e,topSpeed:t}=this.data,s=e.map(o=>`rgb(${o.join(",")})`).join(",");F("bar").style.background=`linear-gradient(to right, ${s})`;let n=10**
Math.floor(Math.log10(t/3)),i=[5,2,1].map(o=>o*n).find(o=>o<=t/3*1.000001)??n;for(let o=0;o<=t;o+=i){let a=b("span","",String(+o.toPrecision(6)));a.style.left=`${100*
o/t}%`,F("ticks").append(a)}}key(){let{hoops:e,colors:t,theme:s,newton:n}=this.data,i=[];e.some(o=>o.traces!==null)&&i.push([s.load,"load"],[t.center,"centre of\
 gravity"],[t.airborne,"airborne"]),n>0&&i.push([t.normal,"normal force"],[t.friction,"friction"]);for(let[o,a]of i){let c=document.createElement("i");c.style.borderColor=
o,F("lines").append(b("span","",c,a))}}show(e){for(let[t,s]of this.data.hoops.entries()){let[n,i]=this.data.modes[s.mode[Math.floor(e)]],o=this.rows[t],a=(f(s.angle,
e)*180/Math.PI).toFixed(1);o.dot.style.background=i,o.word.textContent=n,o.time.textContent=`t = ${f(s.t,e).toFixed(3)} s`,o.angle.textContent=`θ = ${a}°`.replace(
"-","−")}}};var w=r=>document.getElementById(r),O=class{constructor(e){this.data=e,this.last=e.count-1,this.now=0,this.before=null,this.button=w("play"),this.slider=w("time"),
this.rate=w("rate"),this.follow=w("follow");let t=w("scene");this.picture=new _(t,w("labels"),e),this.camera=new v(t,e,()=>this.follow.checked),this.words=new I(
e),this.slider.max=String(this.last),this.button.onclick=()=>this.toggle(),this.slider.oninput=()=>{this.now=Number(this.slider.value),this.play(!1)},w("reset").
onclick=()=>this.camera.reset(),document.addEventListener("keydown",s=>this.key(s)),this.play(!0),this.open(location.hash),requestAnimationFrame(s=>this.tick(s))}open(e){
let t=/t=([\d.]+)/.exec(e);if(!t)return;let s=this.data.hoops[0].t.findIndex(n=>n>=Number(t[1]));this.now=s<0?this.last:s,this.slider.value=String(this.now),this.
play(!1)}play(e){this.playing=e,this.button.textContent=e?"Pause":"Play"}toggle(){!this.playing&&this.now>=this.last&&(this.now=0),this.play(!this.playing)}key(e){
if(e.target.tagName==="SELECT"||e.target===this.button)return;e.key===" "&&(this.toggle(),e.preventDefault());let t=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:
0;!t||e.target===this.slider||(this.play(!1),this.now=Math.min(Math.max(Math.round(this.now)+t,0),this.last))}tick(e){this.playing&&this.before!==null&&(this.now+=
(e-this.before)/1e3*this.data.fps*Number(this.rate.value),this.now>=this.last&&(this.now=this.last,this.play(!1)),this.slider.value=String(this.now)),this.before=
e,this.picture.draw(this.now,this.camera),this.words.show(this.now),requestAnimationFrame(t=>this.tick(t))}};try{new O(H(w("data").textContent))}catch(r){w("pro\
blem").textContent=r.message,w("problem").style.display="flex"}})();
