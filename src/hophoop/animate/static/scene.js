/* Built from web/scene/main.js by esbuild 0.28.2; sources fef7b403726746846543d997975d7593 */
"use strict";(()=>{var D=n=>{if(Array.isArray(n))return n.map(D);if(n===null||typeof n!="object")return n;if(n.f32!==void 0){let t=Uint8Array.from(atob(n.f32),e=>e.charCodeAt(0));
return new Float32Array(t.buffer)}return Object.fromEntries(Object.entries(n).map(([t,e])=>[t,D(e)]))};function X(n,t){let[e,s]=[Math.cos(t),Math.sin(t)],o=new Float32Array(
n.length);for(let r=0;r<n.length;r+=2)o[r]=n[r]*e-n[r+1]*s,o[r+1]=n[r]*s+n[r+1]*e;return o}function V(n){let t=D(JSON.parse(n));for(let e of t.hoops){for(let s of[
"center","contact","velocity"])e[s]=X(e[s],t.slope);if(e.traces!==null)for(let s of["load","heavy"])e.traces[s]=X(e.traces[s],t.slope)}return t}function m(n,t,e=1,s=0){
let o=Math.floor(t),r=Math.min(o+1,n.length/e-1),i=t-o;return n[o*e+s]*(1-i)+n[r*e+s]*i}var A=class{turn;rise;away;shift;along;constructor(t,e,s){this.data=e,this.follows=s;let o=Math.max(...e.hoops.map(r=>Math.abs(r.lane)));this.home={turn:-.35,rise:.2,
away:7*e.radius+2*o+1.5*e.height,shift:[0,0,0]},this.reset(),this.along=null,this.listen(t)}reset(){Object.assign(this,this.home,{shift:[...this.home.shift]})}closer(t){
let e=this.data.radius;this.away=Math.min(Math.max(this.away*t,2*e),200*e)}focus(t){let{hoops:e,along:s}=this.data,o=this.follows()?e.reduce((r,i)=>r+m(i.center,
t,2)/e.length,0):.5*(s[0]+s[1]);return this.along=this.along===null?o:this.along+(o-this.along)*.12,this.along}view(t){let{radius:e,slope:s}=this.data,o=.95*e,r=[
o*Math.sin(s),o*Math.cos(s),0].map((c,h)=>c+this.shift[h]),i=Math.cos(this.rise),a=[Math.sin(this.turn)*i,Math.sin(this.rise),Math.cos(this.turn)*i];return{eye:r.
map((c,h)=>c+this.away*a[h]),target:r,slope:s,angle:t?.56:.9,near:.05*this.away,far:12*this.away+60*e}}listen(t){let e=new Map;t.addEventListener("pointerdown",
s=>{t.setPointerCapture(s.pointerId),e.set(s.pointerId,s)});for(let s of["pointerup","pointercancel"])t.addEventListener(s,o=>e.delete(o.pointerId));t.addEventListener(
"pointermove",s=>{let o=e.get(s.pointerId);if(!o)return;let[r,i]=[s.clientX-o.clientX,s.clientY-o.clientY];if(e.size===2){let[a]=[...e.values()].filter(h=>h.pointerId!==
s.pointerId),c=h=>Math.hypot(h.clientX-a.clientX,h.clientY-a.clientY);this.closer(c(o)/Math.max(c(s),1))}else if(s.shiftKey||s.buttons===2){let a=this.away/t.clientHeight;
this.shift[0]-=r*a*Math.cos(this.turn),this.shift[1]+=i*a,this.shift[2]+=r*a*Math.sin(this.turn)}else this.turn-=r*.008,this.rise=Math.min(Math.max(this.rise+i*
.006,.02),1.5);e.set(s.pointerId,s)}),t.addEventListener("wheel",s=>{this.closer(Math.exp(s.deltaY*.001)),s.preventDefault()},{passive:!1}),t.addEventListener("\
contextmenu",s=>s.preventDefault())}};function B(n,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let o=0;o<4;o++){let r=0;for(let i=0;i<4;i++)r+=n[4*i+o]*t[4*s+i];e[4*s+o]=r}return e}function K(n,t,e,s){
let o=1/Math.tan(n/2),r=1/(e-s);return new Float32Array([o/t,0,0,0,0,o,0,0,0,0,(s+e)*r,-1,0,0,2*s*e*r,0])}function q(n,t){let e=b(O(n,t)),s=b(S([0,1,0],e)),o=S(
e,s);return new Float32Array([s[0],o[0],e[0],0,s[1],o[1],e[1],0,s[2],o[2],e[2],0,-C(s,n),-C(o,n),-C(e,n),1])}var O=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],C=(n,t)=>n[0]*
t[0]+n[1]*t[1]+n[2]*t[2],S=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]];function b(n){let t=Math.hypot(...n)||1;return[n[0]/t,n[1]/t,n[2]/
t]}function R(n,t,e,s){let o=b(t),r=b(S(o,Math.abs(o[2])>.9?[1,0,0]:[0,0,1])),i=S(r,o);return new Float32Array([...r.map(a=>a*s),0,...o.map(a=>a*e),0,...i.map(a=>a*
s),0,...n,1])}var Z=([n,t,e])=>new Float32Array([1,0,0,0,0,1,0,0,0,0,1,0,n,t,e,1]);function $(n){let[t,e]=[Math.cos(n),Math.sin(n)];return new Float32Array([t,-e,
0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function p(n){let t=Number.parseInt(n.slice(1,7),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function k(n,t,e){let s=n.createProgram(),o=[[n.VERTEX_SHADER,t],[n.FRAGMENT_SHADER,e]];for(let[i,a]of o){let c=n.createShader(i);if(n.shaderSource(c,a),n.compileShader(
c),!n.getShaderParameter(c,n.COMPILE_STATUS))throw new Error(String(n.getShaderInfoLog(c)));n.attachShader(s,c)}if(n.linkProgram(s),!n.getProgramParameter(s,n.LINK_STATUS))
throw new Error(String(n.getProgramInfoLog(s)));let r={program:s,uniforms:{},attributes:{}};for(let i=0;i<n.getProgramParameter(s,n.ACTIVE_UNIFORMS);i++){let{name:a}=n.
getActiveUniform(s,i);r.uniforms[a]=n.getUniformLocation(s,a)}for(let i=0;i<n.getProgramParameter(s,n.ACTIVE_ATTRIBUTES);i++){let{name:a}=n.getActiveAttrib(s,i);
r.attributes[a]=n.getAttribLocation(s,a)}return r}function E(n,t,e,s){let o=n.createBuffer();n.bindBuffer(n.ARRAY_BUFFER,o),n.bufferData(n.ARRAY_BUFFER,new Float32Array(
t),n.STATIC_DRAW);let r=s?n.createBuffer():null;s&&(n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,r),n.bufferData(n.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),n.STATIC_DRAW));
let i=4*Object.values(e).reduce((a,c)=>a+c,0);return{vertices:o,elements:r,parts:e,stride:i,count:s?s.length:4*t.length/i}}function _(n,t,e){n.bindBuffer(n.ARRAY_BUFFER,
e.vertices);let s=0;for(let[o,r]of Object.entries(e.parts)){let i=t.attributes[o];i!==void 0&&(n.enableVertexAttribArray(i),n.vertexAttribPointer(i,r,n.FLOAT,!1,
e.stride,s)),s+=4*r}e.elements&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.elements)}function H(n,t){let e=[];for(let s=0;s<n;s++)for(let o=0;o<t;o++){let r=s*(t+1)+
o,i=r+t+1;e.push(r,i,r+1,i,i+1,r+1)}return e}function J(n,t=120,e=14){let s=[];for(let o=0;o<=t;o++)for(let r=0;r<=e;r++)s.push(2*Math.PI*o/t,2*Math.PI*r/e);return E(
n,s,{bend:2},H(t,e))}function Q(n,t=28,e=18){let s=[];for(let o=0;o<=t;o++)for(let r=0;r<=e;r++){let[i,a]=[2*Math.PI*o/t,Math.PI*r/e],c=[Math.sin(a)*Math.cos(i),
Math.cos(a),Math.sin(a)*Math.sin(i)];s.push(...c,...c)}return E(n,s,{position:3,normal:3},H(t,e))}function j(n,t,e=20){let s=[];for(let o=0;o<=e;o++){let r=2*Math.
PI*o/e,i=[Math.cos(r),1-t,Math.sin(r)];s.push(Math.cos(r),0,Math.sin(r),...i,t*Math.cos(r),1,t*Math.sin(r),...i)}return E(n,s,{position:3,normal:3},H(e,1))}var ot=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,it=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,nt="vec4(0.0, 0.0, 0.0, shadow)",tt=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${it}
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
     gl_FragColor = shadow > 0.0 ? ${nt} : vec4(shaded(color, n), 1.0);
   }`],et=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${it}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${ot}
   void main() { gl_FragColor = shadow > 0.0 ? ${nt} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],st=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],F=class{constructor(t,e,s,o,{keep:r=!1}={}){let i=t.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:r});if(!i)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=i,this.canvas=
t,this.sun=b(s),this.dark=o,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=k(i,tt[0],tt[1]),this.body=k(i,et[0],et[1]),this.line=k(i,st[0],st[1]),this.torus=J(i),this.
sphere=Q(i),this.cylinder=j(i,1),this.cone=j(i,0),this.colors=i.createTexture(),i.bindTexture(i.TEXTURE_2D,this.colors);let a=new Uint8Array(e.flatMap(c=>[...c,
255]));i.pixelStorei(i.UNPACK_ALIGNMENT,1),i.texImage2D(i.TEXTURE_2D,0,i.RGBA,e.length,1,0,i.RGBA,i.UNSIGNED_BYTE,a);for(let c of[i.TEXTURE_WRAP_S,i.TEXTURE_WRAP_T])
i.texParameteri(i.TEXTURE_2D,c,i.CLAMP_TO_EDGE);for(let c of[i.TEXTURE_MIN_FILTER,i.TEXTURE_MAG_FILTER])i.texParameteri(i.TEXTURE_2D,c,i.LINEAR);this.view=$(0),
this.eye=[0,0,1],this.fastest=1}begin({background:t,eye:e,target:s,slope:o,angle:r,near:i,far:a}){let{gl:c,canvas:h}=this;c.viewport(0,0,h.width,h.height),c.clearColor(
t[0],t[1],t[2],1),c.clear(c.COLOR_BUFFER_BIT|c.DEPTH_BUFFER_BIT|c.STENCIL_BUFFER_BIT),c.enable(c.DEPTH_TEST);let l=K(r,h.width/h.height,i,a);this.view=B(B(l,q(e,
s)),$(o)),this.eye=b(O(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let o={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[r,i]of Object.
entries(o)){let a=t.uniforms[r];a!==void 0&&(typeof i=="number"?s.uniform1f(a,i):i.length===16?s.uniformMatrix4fv(a,!1,i):s[`uniform${i.length}fv`](a,i))}}ground(t){
let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.
ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),e.
depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:o=!1,lit:r=!0}={}){let{gl:i}=this;this.use(this.body,{model:e,color:s,shadow:o?
this.dark:0,lit:Number(r)}),_(i,this.body,t),i.drawElements(i.TRIANGLES,t.count,i.UNSIGNED_SHORT,0)}ball(t,e,s,o){this.solid(this.sphere,R(t,[0,1,0],e,e),s,{shadow:o})}ring({
center:t,radius:e,tube:s,broad:o,angle:r,velocity:i,omega:a,plain:c=null},h){let{gl:l}=this;this.use(this.rim,{center:t,size:[e,s,o,r],motion:[...i,a],most:this.
fastest,shadow:h?this.dark:0,plain:c??[0,0,0],colored:c?0:1}),_(l,this.rim,this.torus),l.drawElements(l.TRIANGLES,this.torus.count,l.UNSIGNED_SHORT,0)}rod(t,e,s,o,r,i=!1){
this.solid(this.cylinder,R(t,e,s,o),r,{shadow:i})}arrow(t,e,s,o,r){if(!(s>.02*o))return;let i=Math.min(.18*o,s),a=t.map((c,h)=>c+e[h]*(s-i));s>i&&this.rod(t,e,s-
i,.029*o,r),this.solid(this.cone,R(a,e,i,Math.min(.075*o,.6*i)),r)}trace(t,e,s){let o=[];for(let r=0;r<t;r++){let i=e(r),a=e(Math.min(r+1,t-1));if(Math.hypot(a[0]-
i[0],a[1]-i[1])<1e-9&&r>0){let c=e(r-1);a=i.map((h,l)=>2*h-c[l])}for(let c of[-1,1])o.push(...i,0,...a,0,...s(r),c)}return E(this.gl,o,{position:3,next:3,tint:3,
side:1})}drawTrace(t,e,{width:s,distance:o=0,shift:r,depth:i}){let{gl:a,canvas:c}=this;this.use(this.line,{pixel:[2/c.width,2/c.height],width:s,distance:o,shift:r,
depth:i}),_(a,this.line,t),a.drawArrays(a.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let o=this.view,[r,i,a]=[0,1,3].map(c=>o[c]*t+o[4+c]*e+o[8+c]*s+o[12+c]);return a>
0?[(.5+.5*r/a)*this.canvas.width,(.5-.5*i/a)*this.canvas.height]:null}};function I([n,t],[e,s]){return{data:[[n,s],[n,e],[t,s],[t,e]].flatMap(([o,r])=>[o,0,r,0,
1,0]),indices:[0,1,2,1,3,2]}}function P(n,t){let e=t.flatMap((s,o)=>s.indices.map(r=>r+4*o));return E(n,t.flatMap(s=>s.data),{position:3,normal:3},e)}var rt=.5,lt=.45,ft=6,dt='"DejaVu Sans", system-ui, sans-serif';function at(n,{space:t,data:e},{hoop:s},o,r,i,a){let c=m(s.t,o),h=-s.lane+.35*e.radius;n.strokeStyle=
e.theme.ink,n.fillStyle=e.theme.ink,n.font=`${12*a}px ${dt}`;let l=-1/0,f=s.marks.filter(([d])=>d<=c).sort((d,g)=>d[1]-g[1]);for(let[d,g,y,u]of f){let v=t.onScreen(
[g-r,0,h]);if(!v)continue;let[x,U]=v,G=(c-d)/e.rate[Math.floor(o)];G<rt&&ut(n,x,U,G/rt,s.radius*i,a),mt(n,y,x,U+12*a,ft*a);let W=.5*n.measureText(u).width;x-W<l||
(n.fillText(u,x,U+34*a),l=x+W+6*a)}}function ut(n,t,e,s,o,r){n.globalAlpha=1-s,n.lineWidth=(3*(1-s)+.6)*r,n.beginPath(),n.arc(t,e,(.08+lt*s)*o,0,2*Math.PI),n.stroke(),
n.globalAlpha=1}function mt(n,t,e,s,o){if(n.beginPath(),t==="takeoff"||t==="impact"){let r=t==="takeoff"?-o:o;n.moveTo(e-o,s-r),n.lineTo(e+o,s-r),n.lineTo(e,s+r),
n.fill();return}n.lineWidth=.4*o;for(let r of[-o,o])n.moveTo(e-o,s-r),n.lineTo(e+o,s+r);n.stroke()}var z=.05,pt=.1,wt=.05,gt=[-.32,1,.75],yt=.38,ct='"DejaVu Sans", system-ui, sans-serif',ht=(n,t,e)=>n.map((s,o)=>s+e*(t[o]-s)),N=class{constructor(t,e,s){this.canvas=
t,this.labels=e,this.data=s,this.space=new F(t,s.map,gt,yt),this.space.fastest=s.topSpeed,this.half=Math.max(...s.hoops.map(i=>Math.abs(i.lane)))+1.1*s.radius;let o=Math.
ceil((s.along[0]-6*s.radius)/s.grid),r=Math.min(Math.floor((s.along[1]+6*s.radius)/s.grid),o+1999);this.marks=Array.from({length:Math.max(r-o+1,0)},(i,a)=>(o+a)*
s.grid),this.floor=this.floorMeshes(),this.metre=1,this.traces=s.hoops.map(i=>i.traces&&this.traceMeshes(i.traces))}floorMeshes(){let{data:t,half:e,space:s}=this,
o=t.radius,r=[t.along[0]-40*o,t.along[1]+40*o],i=[e,-e];return{plane:P(s.gl,[I(r,[40*o,-40*o])]),track:P(s.gl,[I(r,i)]),bars:P(s.gl,this.marks.map(a=>I([a-.008*
o,a+.008*o],i)))}}traceMeshes({load:t,heavy:e,airborne:s}){let{theme:o,colors:r}=this.data,i=p(o.load),[a,c]=[p(r.center),p(r.airborne)],h=(l,f)=>this.space.trace(
l.length/2,d=>[l[2*d],l[2*d+1]],f);return{load:h(t,()=>i),heavy:h(e,l=>s[l]?c:a)}}draw(t,e){let{canvas:s,labels:o,data:r,space:i}=this,a=window.devicePixelRatio||
1,[c,h]=[Math.round(s.clientWidth*a),Math.round(s.clientHeight*a)];for(let u of[s,o])(u.width!==c||u.height!==h)&&Object.assign(u,{width:c,height:h});let l=e.focus(
t),f=e.view(c>h);i.begin({background:p(r.theme.background),...f}),i.ground(()=>this.drawFloor(l));let d=r.hoops.map(u=>this.pose(u,t,l));i.shadows(()=>{for(let u of d)
this.drawHoop(u,!0)});let g=h/(2*e.away*Math.tan(.5*f.angle));for(let[u,v]of d.entries())this.drawHoop(v,!1),this.drawTraces(r.hoops[u],this.traces[u],t,l,g,e.away),
r.newton&&this.drawForces(r.hoops[u],r.newton[Math.floor(t)],t,l);let y=o.getContext("2d");y.clearRect(0,0,o.width,o.height),y.textAlign="center",this.drawNumbers(
y,l,a);for(let u of d)at(y,this,u,t,l,g,a);for(let{hoop:u,center:v}of d)this.drawTag(y,u.tag,v,a);this.metre=g/a}pose(t,e,s){let o=m(t.angle,e),r=[Math.sin(o),Math.
cos(o),0],i=[m(t.center,e,2)-s,m(t.center,e,2,1),-t.lane];return{hoop:t,center:i,angle:o,velocity:[m(t.velocity,e,2),m(t.velocity,e,2,1)],omega:m(t.omega,e),airborne:t.
mode[Math.floor(e)]===this.data.flight,at:a=>i.map((c,h)=>c+a*r[h])}}drawFloor(t){let{theme:e}=this.data,[s,o]=[p(e.ground),p(e.ink)],r=Z([-t,0,0]);this.space.solid(
this.floor.plane,r,s,{lit:!1}),this.space.solid(this.floor.track,r,ht(s,o,.06),{lit:!1}),this.space.solid(this.floor.bars,r,ht(s,o,.25),{lit:!1})}drawHoop({hoop:t,
center:e,angle:s,velocity:o,omega:r,airborne:i,at:a},c){let{space:h,data:l}=this,{radius:f}=t;h.ring({center:e,radius:f,tube:z*f,broad:z*f,angle:s,velocity:o,omega:r},
c),h.ball(a(t.load),pt*f,p(l.theme.load),c);let d=i?l.colors.airborne:l.colors.center;c||h.ball(a(t.heavy),wt*f,p(d),c)}drawTraces(t,e,s,o,r,i){if(e===null||t.traces===
null)return;let a=m(t.t,s),c=t.traces.t.findIndex(d=>d>a),h=c<0?t.traces.t.length:c,l=this.data.radius,f={distance:i,shift:o,depth:-t.lane};this.space.drawTrace(
e.load,h,{width:.011*l*r,...f}),this.space.drawTrace(e.heavy,h,{width:.016*l*r,...f})}drawForces(t,e,s,o){let{data:r,space:i}=this,a=Math.floor(s),c=-t.lane+(z+
.04)*t.radius,h=[m(t.contact,s,2)-o,m(t.contact,s,2,1),c],[l,f]=[t.normalForce[a],t.frictionForce[a]].map(d=>e*d);i.arrow(h,[0,Math.sign(l),0],Math.abs(l),r.radius,
p(r.colors.normal)),i.arrow(h,[Math.sign(f),0,0],Math.abs(f),r.radius,p(r.colors.friction))}drawTag(t,e,s,o){let r=e&&this.space.onScreen(s);if(!r)return;let{theme:i}=this.
data;t.beginPath(),t.arc(r[0],r[1],10*o,0,2*Math.PI),t.fillStyle=i.background,t.fill(),t.strokeStyle=i.ink,t.lineWidth=1.2*o,t.stroke(),t.fillStyle=i.ink,t.font=
`bold ${12*o}px ${ct}`,t.fillText(e,r[0],r[1]+4.3*o)}drawNumbers(t,e,s){let{labels:o,data:r,half:i}=this;t.fillStyle=r.theme.muted,t.font=`${13*s}px ${ct}`;let a=-1e9;
for(let c of this.marks){let h=this.space.onScreen([c-e,0,i+.15*r.radius]);if(!h)continue;let[l,f]=h;!(l>=0&&l<=o.width&&f>=0&&f<=o.height-50*s)||Math.abs(l-a)<
55*s||(t.fillText(`${+c.toPrecision(6)} m`.replace("-","−"),l,f+12*s),a=l)}}};var bt=90,T=n=>document.getElementById(n),M=(n,t,...e)=>{let s=document.createElement(n);return s.className=t,s.append(...e),s},L=class{constructor(t){this.data=
t,document.body.style.background=t.theme.background,document.body.style.color=t.theme.ink,this.rows=t.hoops.map(e=>this.row(e)),this.scale(),this.key()}row(t){let[
e,s,o,r]=["dot","word","t","angle"].map(a=>M("span",a)),i=M("span","label",t.tag?`${t.tag}: ${t.label}`:t.label);return T("words").append(M("div","row",M("span",
"mode",e,s),o,r,i)),{dot:e,word:s,time:o,angle:r}}scale(){let{map:t,topSpeed:e}=this.data,s=t.map(i=>`rgb(${i.join(",")})`).join(",");T("bar").style.background=
`linear-gradient(to right, ${s})`;let o=10**Math.floor(Math.log10(e/3)),r=[5,2,1].map(i=>i*o).find(i=>i<=e/3*1.000001)??o;for(let i=0;i<=e;i+=r){let a=M("span",
"",String(+i.toPrecision(6)));a.style.left=`${100*i/e}%`,T("ticks").append(a)}}key(){let{hoops:t,colors:e,theme:s,newton:o,flies:r}=this.data,i=[];t.some(a=>a.traces!==
null)&&(i.push([s.load,"load"],[e.center,"centre of gravity"]),r&&i.push([e.airborne,"airborne"])),o&&i.push([e.normal,"normal force"],[e.friction,"friction"]);
for(let[a,c]of i){let h=document.createElement("i");h.style.borderColor=a,T("lines").append(M("span","",h,c))}o&&(this.ruler=document.createElement("i"),this.force=
document.createTextNode(""),T("lines").append(M("span","ruler",this.ruler,this.force)))}showScale(t,e){if(!this.ruler||!this.force)return;let s=bt/(t*e),o=10**Math.
floor(Math.log10(s)),r=[5,2,1].map(i=>i*o).find(i=>i<=s*1.000001)??o;this.ruler.style.width=`${(r*t*e).toFixed(1)}px`,this.force.textContent=`${+r.toPrecision(6)}\
 N`}show(t,e){let s=Math.floor(t);this.data.newton&&this.showScale(this.data.newton[s],e);for(let[o,r]of this.data.hoops.entries()){let[i,a]=this.data.modes[r.mode[s]],
c=this.rows[o],h=(m(r.angle,t)*180/Math.PI).toFixed(1);c.dot.style.background=a,c.word.textContent=i,c.time.textContent=`t = ${m(r.t,t).toFixed(3)} s`,c.angle.textContent=
`θ = ${h}°`.replace("-","−")}}};var w=n=>document.getElementById(n),Y=class{constructor(t){this.data=t,this.last=t.count-1,this.now=0,this.before=null,this.button=w("play"),this.slider=w("time"),
this.rate=w("rate"),this.follow=w("follow");let e=w("scene");this.picture=new N(e,w("labels"),t),this.camera=new A(e,t,()=>this.follow.checked),this.words=new L(
t),this.slider.max=String(this.last),this.button.onclick=()=>this.toggle(),this.slider.oninput=()=>{this.now=Number(this.slider.value),this.play(!1)},w("reset").
onclick=()=>this.camera.reset(),document.addEventListener("keydown",s=>this.key(s)),this.play(!0),this.open(location.hash),requestAnimationFrame(s=>this.tick(s))}open(t){
let e=/t=([\d.]+)/.exec(t);if(!e)return;let s=this.data.hoops[0].t.findIndex(o=>o>=Number(e[1]));this.now=s<0?this.last:s,this.slider.value=String(this.now),this.
play(!1)}play(t){this.playing=t,this.button.textContent=t?"Pause":"Play"}toggle(){!this.playing&&this.now>=this.last&&(this.now=0),this.play(!this.playing)}key(t){
if(t.target.tagName==="SELECT"||t.target===this.button)return;t.key===" "&&(this.toggle(),t.preventDefault());let e=t.key==="ArrowRight"?1:t.key==="ArrowLeft"?-1:
0;!e||t.target===this.slider||(this.play(!1),this.now=Math.min(Math.max(Math.round(this.now)+e,0),this.last))}tick(t){this.playing&&this.before!==null&&(this.now+=
(t-this.before)/1e3*this.data.fps*Number(this.rate.value),this.now>=this.last&&(this.now=this.last,this.play(!1)),this.slider.value=String(this.now)),this.before=
t,this.picture.draw(this.now,this.camera),this.words.show(this.now,this.picture.metre),requestAnimationFrame(e=>this.tick(e))}};try{new Y(V(w("data").textContent))}catch(n){
w("problem").textContent=n.message,w("problem").style.display="flex"}})();
