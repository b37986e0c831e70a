/* Built from web/scene/main.js by esbuild 0.28.2; sources 95d8ac73e47cc3f3bb0e236b12f19008 */
"use strict";(()=>{var s=ot(JSON.parse(document.getElementById("data").textContent)),x=document.getElementById("scene"),ut=document.getElementById("labels"),i=x.getContext("webgl",
{antialias:!0}),Z=128,tt=16,et=.05,Rt=.1,wt=.05,nt=L([.32,.75,-1]),m=s.radius;function ot(t){if(Array.isArray(t))return t.map(ot);if(t===null||typeof t!="object")
return t;if(t.f32!==void 0){let e=Uint8Array.from(atob(t.f32),a=>a.charCodeAt(0));return new Float32Array(e.buffer)}return Object.fromEntries(Object.entries(t).
map(([e,a])=>[e,ot(a)]))}function L(t){let e=Math.hypot(...t)||1;return t.map(a=>a/e)}function q(t,e){return t[0]*e[0]+t[1]*e[1]+t[2]*e[2]}function at(t,e){return[
t[1]*e[2]-t[2]*e[1],t[2]*e[0]-t[0]*e[2],t[0]*e[1]-t[1]*e[0]]}function K(t,e){let a=new Float32Array(16);for(let n=0;n<4;n++)for(let o=0;o<4;o++){let r=0;for(let c=0;c<
4;c++)r+=t[c*4+o]*e[n*4+c];a[n*4+o]=r}return a}function z(t,e,a,n){return new Float32Array([...t,0,...e,0,...a,0,...n,1])}function j(t){return z([1,0,0],[0,1,0],
[0,0,1],t)}function Ft(t,e,a,n){let o=1/Math.tan(t/2),r=1/(a-n);return new Float32Array([o/e,0,0,0,0,o,0,0,0,0,(n+a)*r,-1,0,0,2*n*a*r,0])}function St(t,e){let a=L(
[t[0]-e[0],t[1]-e[1],t[2]-e[2]]),n=L(at([0,0,1],a)),o=at(a,n);return new Float32Array([n[0],o[0],a[0],0,n[1],o[1],a[1],0,n[2],o[2],a[2],0,-q(n,t),-q(o,t),-q(a,t),
1])}function R(t){return[1,3,5].map(e=>parseInt(t.slice(e,e+2),16)/255)}function W(t,e,a){return t.map((n,o)=>n+a*(e[o]-n))}function U(t,e,a){let n=Math.cos(s.slope),
o=Math.sin(s.slope);return[t*n+e*o,a,e*n-t*o]}function G(t,e,a){let n=[],o=[],r=[];for(let c=0;c<=t;c++)for(let f=0;f<=e;f++){let[u,d]=a(c/t,f/e);n.push(...u),o.
push(...d)}for(let c=0;c<t;c++)for(let f=0;f<e;f++){let u=c*(e+1)+f,d=u+e+1;r.push(u,d,d+1,u,d+1,u+1)}return{points:n,normals:o,faces:r}}function Tt(t){return G(
Z,tt,(e,a)=>{let n=2*Math.PI*e,o=2*Math.PI*a,r=[Math.sin(n),0,Math.cos(n)],c=[Math.cos(o)*r[0],Math.sin(o),Math.cos(o)*r[2]];return[r.map((f,u)=>t*((1-et)*f+et*
c[u])),c]})}function ct(t){return G(28,18,(e,a)=>{let n=2*Math.PI*e,o=Math.PI*a,r=[Math.cos(n)*Math.sin(o),Math.sin(n)*Math.sin(o),Math.cos(o)];return[r.map(c=>t*
c),r]})}function it(t){return G(1,24,(e,a)=>{let n=2*Math.PI*a,o=t?1-e:1;return[[e,o*Math.cos(n),o*Math.sin(n)],[t?.4:0,Math.cos(n),Math.sin(n)]]})}function lt(t,e,a){
let n=t.length/2;return G(Math.max(n-1,1),5,(r,c)=>{let f=Math.min(Math.round(r*Math.max(n-1,1)),n-1),u=Math.max(f-1,0),d=Math.min(f+1,n-1),l=L([t[2*d]-t[2*u],t[2*
d+1]-t[2*u+1]]),p=2*Math.PI*c,g=Math.cos(p),M=Math.sin(p),v=[-l[1]*g,M,l[0]*g];return[[t[2*f]+e*v[0],a+e*M,t[2*f+1]+e*v[2]],v]})}var kt=`
attribute vec3 point; attribute vec3 normal; attribute vec3 shade;
uniform mat4 view; uniform mat4 model; uniform vec3 color; uniform float shaded;
varying vec3 vNormal; varying vec3 vColor;
void main() {
  gl_Position = view * model * vec4(point, 1.0);
  vNormal = mat3(model[0].xyz, model[1].xyz, model[2].xyz) * normal;
  vColor = mix(color, shade, shaded);
}`,Bt=`
precision mediump float;
varying vec3 vNormal; varying vec3 vColor;
uniform vec3 sun; uniform vec3 eye; uniform float lit;
void main() {
  vec3 n = normalize(vNormal);
  float light = 0.45 + 0.4 * max(dot(n, -sun), 0.0) + 0.3 * abs(dot(n, eye));
  float gloss = 0.25 * pow(max(dot(n, normalize(eye - sun)), 0.0), 24.0);
  gl_FragColor = vec4(mix(vColor, vColor * light + gloss, lit), 1.0);
}`,F,y;function _t(){F=i.createProgram();for(let[t,e]of[[i.VERTEX_SHADER,kt],[i.FRAGMENT_SHADER,Bt]]){let a=i.createShader(t);i.shaderSource(a,e),i.compileShader(
a),i.attachShader(F,a)}if(i.linkProgram(F),!i.getProgramParameter(F,i.LINK_STATUS))throw new Error(i.getProgramInfoLog(F));i.useProgram(F),y={};for(let t of["po\
int","normal","shade"])y[t]=i.getAttribLocation(F,t);for(let t of["view","model","color","shaded","sun","eye","lit"])y[t]=i.getUniformLocation(F,t)}var dt=i?.getExtension(
"OES_element_index_uint");function I(t){let e=(n,o)=>{let r=i.createBuffer();return i.bindBuffer(n,r),i.bufferData(n,o,i.STATIC_DRAW),r},a=dt?Uint32Array:Uint16Array;
return{point:e(i.ARRAY_BUFFER,new Float32Array(t.points)),normal:e(i.ARRAY_BUFFER,new Float32Array(t.normals)),faces:e(i.ELEMENT_ARRAY_BUFFER,new a(t.faces)),count:t.
faces.length,shade:t.shades?e(i.ARRAY_BUFFER,new Float32Array(t.shades)):null}}function b(t,e,a,n=1,o=t.count,r=t.shade!==null){for(let c of["point","normal","s\
hade"])t[c]&&(c!=="shade"||r)?(i.bindBuffer(i.ARRAY_BUFFER,t[c]),i.enableVertexAttribArray(y[c]),i.vertexAttribPointer(y[c],3,i.FLOAT,!1,0,0)):i.disableVertexAttribArray(
y[c]);i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.faces),i.uniformMatrix4fv(y.model,!1,e),i.uniform3fv(y.color,a),i.uniform1f(y.shaded,r?1:0),i.uniform1f(y.lit,n),i.drawElements(
i.TRIANGLES,o,dt?i.UNSIGNED_INT:i.UNSIGNED_SHORT,0)}var w=s.theme,H=R(w.ground),O=R(w.ink),mt=Math.max(...s.hoops.map(t=>Math.abs(t.lane))),P=mt+1.1*m,C=U(0,1,0),
ht,pt,gt,Mt,yt;function J(t,e,a,n,o){return{points:[[t,a],[e,a],[e,n],[t,n]].map(([c,f])=>U(c,o*m,f)).flat(),normals:[0,1,2,3].flatMap(()=>C),faces:[0,1,2,0,2,3]}}
function bt(){let t=Math.ceil((s.along[0]-6*m)/s.grid),e=[];for(let a=t;a*s.grid<=s.along[1]+6*m&&e.length<2e3;a++)e.push(a);return e}function Nt(){let t=s.along[0]-
40*m,e=s.along[1]+40*m;ht=I(J(t,e,-40*m,40*m,-.014)),pt=I(J(t,e,-P,P,-.009));let a={points:[],normals:[],faces:[]};for(let n of bt()){let o=J(n*s.grid-.008*m,n*
s.grid+.008*m,-P,P,-.006);a.faces.push(...o.faces.map(r=>r+a.points.length/3)),a.points.push(...o.points),a.normals.push(...o.normals)}gt=I(a),Mt=I(it(!1)),yt=I(
it(!0));for(let n of s.hoops){let o=Tt(n.radius);if(o.shades=new Float32Array(o.points.length),n.shades=o.shades,n.ring=I(o),n.ballMesh=I(ct(Rt*n.radius)),n.beadMesh=
I(ct(wt*n.radius)),n.traces===null)continue;n.loadTrace=I(lt(n.traces.load,.011*m,n.lane));let r=lt(n.traces.heavy,.016*m,n.lane),[c,f]=[R(s.colors.center),R(s.
colors.airborne)];r.shades=n.traces.airborne.flatMap(u=>Array(6).fill(u?f:c).flat()),n.heavyTrace=I(r)}}var $={turn:-.35,rise:.2,away:7*m+2*mt+1.5*s.height,shift:[
0,0,0]},h={...$,shift:[...$.shift]},N=null;function Pt(t){let e=document.getElementById("follow").checked,a=.5*(s.along[0]+s.along[1]),n=e?s.hoops.reduce((f,u)=>f+
E(u.center,t,2,0)/s.hoops.length,0)/Math.cos(s.slope):a;N=N===null?n:N+(n-N)*.12;let o=U(N,.95*m,0).map((f,u)=>f+h.shift[u]),r=Math.cos(h.rise),c=[Math.sin(h.turn)*
r,-Math.cos(h.turn)*r,Math.sin(h.rise)];return{eye:o.map((f,u)=>f+h.away*c[u]),spot:o,away:c}}function E(t,e,a,n){let o=Math.min(Math.floor(e),s.count-1),r=Math.
min(o+1,s.count-1),c=e-o;return t[o*a+n]*(1-c)+t[r*a+n]*c}function Ct(){let t=q(C,nt),e=[];for(let a=0;a<3;a++)e.push([0,1,2].map(n=>(n===a?1:0)-nt[n]*C[a]/t));
return z(...e,C.map(a=>.002*m*a))}function Lt(t,e){let a=E(t.velocity,e,2,0),n=E(t.velocity,e,2,1),o=t.radius*E(t.omega,e,1,0),r=s.map.length-1;for(let c=0;c<=Z;c++){
let f=2*Math.PI*c/Z-s.slope,u=Math.hypot(a+o*Math.cos(f),n-o*Math.sin(f)),d=Math.min(Math.max(u/s.topSpeed,0),1)*r,l=Math.min(Math.floor(d),r-1);for(let p=0;p<3;p++){
let g=s.map[l][p]+(d-l)*(s.map[l+1][p]-s.map[l][p]);for(let M=0;M<=tt;M++)t.shades[3*(c*(tt+1)+M)+p]=g/255}}i.bindBuffer(i.ARRAY_BUFFER,t.ring.shade),i.bufferSubData(
i.ARRAY_BUFFER,0,t.shades)}function ft(t,e,a,n){if(Math.abs(a)<.02*m)return;let o=e.map(M=>M*Math.sign(a)),r=[0,1,0],c=at(o,r),f=Math.abs(a),u=Math.min(.2*m,f),
d=.03*m,l=(M,v)=>M.map(Y=>Y*v),p=t.map((M,v)=>M+o[v]*(f-u));f>u&&b(Mt,z(l(o,f-u),l(r,d),l(c,d),t),n);let g=Math.min(2.4*d,.6*u);b(yt,z(l(o,u),l(r,g),l(c,g),p),n)}
function Ut(t){let e=window.devicePixelRatio||1,a=Math.round(x.clientWidth*e),n=Math.round(x.clientHeight*e);for(let l of[x,ut])(l.width!==a||l.height!==n)&&(l.
width=a,l.height=n);i.viewport(0,0,a,n);let o=Pt(t),r=a>n?.56:.9,c=K(Ft(r,a/n,.05*h.away,12*h.away+60*m),St(o.eye,o.spot));i.clearColor(...R(w.background),1),i.
clear(i.COLOR_BUFFER_BIT|i.DEPTH_BUFFER_BIT),i.enable(i.DEPTH_TEST),i.uniformMatrix4fv(y.view,!1,c),i.uniform3fv(y.sun,nt),i.uniform3fv(y.eye,L(o.away));let f=j(
[0,0,0]);b(ht,f,H,0),b(pt,f,W(H,O,.06),0),b(gt,f,W(H,O,.25),0);let u=Ct(),d=W(H,[0,0,0],.38);for(let l of s.hoops){let p=[E(l.center,t,2,0),l.lane,E(l.center,t,
2,1)],g=E(l.angle,t,1,0)+s.slope,M=[Math.sin(g),0,Math.cos(g)],v=T=>p.map((S,_)=>S+T*M[_]),Y=j(v(l.load)),rt=j(p),vt=l.mode[Math.floor(t)]==="H";if(Lt(l,t),b(l.
ring,K(u,rt),d,0,l.ring.count,!1),b(l.ballMesh,K(u,Y),d,0),b(l.ring,rt,O),b(l.ballMesh,Y,R(w.load)),b(l.beadMesh,j(v(l.heavy)),R(vt?s.colors.airborne:s.colors.center)),
l.traces!==null){let T=E(l.t,t,1,0),S=l.traces.t,_=S.findIndex(It=>It>T);_<0&&(_=S.length);let st=Math.max(_-1,0)*5*6;b(l.loadTrace,f,R(w.load),.3,Math.min(st,l.
loadTrace.count)),b(l.heavyTrace,f,O,.3,Math.min(st,l.heavyTrace.count))}if(s.newton>0){let T=[E(l.contact,t,2,0),l.lane-(et+.04)*l.radius,E(l.contact,t,2,1)],S=Math.
floor(t);ft(T,C,s.newton*l.normalForce[S],R(s.colors.normal)),ft(T,U(1,0,0),s.newton*l.frictionForce[S],R(s.colors.friction))}}Dt(c,a,n,e),jt(t)}function Dt(t,e,a,n){
let o=ut.getContext("2d");o.clearRect(0,0,e,a),o.fillStyle=w.muted,o.textAlign="center",o.font=`${13*n}px "DejaVu Sans", system-ui, sans-serif`;let r=-1e9;for(let c of bt()){
let f=[...U(c*s.grid,0,-P-.15*m),1],u=[0,0,0,0];for(let p=0;p<4;p++)for(let g=0;g<4;g++)u[p]+=t[g*4+p]*f[g];if(u[3]<=0)continue;let d=(u[0]/u[3]*.5+.5)*e,l=(.5-
u[1]/u[3]*.5)*a;d<0||d>e||l<0||l>a-50*n||Math.abs(d-r)<55*n||(o.fillText(`${+(c*s.grid).toPrecision(6)} m`.replace("-","−"),d,l+12*n),r=d)}}var Et=[];function Yt(){
document.body.style.background=w.background,document.body.style.color=w.ink;for(let o of s.hoops){let r=document.createElement("div");r.className="row",r.innerHTML=
'<span class="mode"><span class="dot"></span><span class="word"></span></span><span class="t"></span><span class="angle"></span><span class="label"></span>',r.querySelector(
".label").textContent=o.label,document.getElementById("words").append(r),Et.push(r)}let t=s.map.map(o=>`rgb(${o.join(",")})`).join(",");document.getElementById(
"bar").style.background=`linear-gradient(to right, ${t})`;let e=10**Math.floor(Math.log10(s.topSpeed/3)),a=[5,2,1].map(o=>o*e).find(o=>o<=s.topSpeed/3*1.000001);
for(let o=0;o<=s.topSpeed;o+=a){let r=document.createElement("span");r.textContent=+o.toPrecision(6),r.style.left=`${100*o/s.topSpeed}%`,document.getElementById(
"ticks").append(r)}let n=[];s.hoops.some(o=>o.traces!==null)&&n.push([w.load,"load"],[s.colors.center,"centre of gravity"],[s.colors.airborne,"airborne"]),s.newton>
0&&n.push([s.colors.normal,"normal force"],[s.colors.friction,"friction"]);for(let[o,r]of n){let c=document.createElement("span"),f=document.createElement("i");
f.style.borderColor=o,c.append(f,r),document.getElementById("lines").append(c)}}function jt(t){s.hoops.forEach((e,a)=>{let[n,o]=s.modes[e.mode[Math.floor(t)]],r=Et[a];
r.querySelector(".dot").style.background=o,r.querySelector(".word").textContent=n,r.querySelector(".t").textContent=`t = ${E(e.t,t,1,0).toFixed(3)} s`;let c=(E(
e.angle,t,1,0)*180/Math.PI).toFixed(1);r.querySelector(".angle").textContent=`θ = ${c}°`.replace("-","−")})}var A=0,V=!0,Q=null,B=document.getElementById("t\
ime"),X=document.getElementById("play");B.max=s.count-1;function D(t){V=t,X.textContent=t?"Pause":"Play"}X.onclick=()=>{!V&&A>=s.count-1&&(A=0),D(!V)};B.oninput=
()=>{A=Number(B.value),D(!1)};document.getElementById("reset").onclick=()=>{h={...$,shift:[...$.shift]}};document.addEventListener("keydown",t=>{if(t.target.tagName===
"SELECT"||t.target===X)return;t.key===" "&&(X.onclick(),t.preventDefault());let e={ArrowRight:1,ArrowLeft:-1}[t.key];e&&t.target!==B&&(D(!1),A=Math.min(Math.max(
Math.round(A)+e,0),s.count-1))});var k=new Map;x.addEventListener("pointerdown",t=>{x.setPointerCapture(t.pointerId),k.set(t.pointerId,t)});for(let t of["pointe\
rup","pointercancel"])x.addEventListener(t,e=>k.delete(e.pointerId));x.addEventListener("pointermove",t=>{let e=k.get(t.pointerId);if(!e)return;let a=t.clientX-
e.clientX,n=t.clientY-e.clientY;if(k.size===2){let[o]=[...k.values()].filter(c=>c.pointerId!==t.pointerId),r=c=>Math.hypot(c.clientX-o.clientX,c.clientY-o.clientY);
At(r(e)/Math.max(r(t),1))}else if(t.shiftKey||t.buttons===2){let o=h.away/x.clientHeight;h.shift[0]-=a*o*Math.cos(h.turn),h.shift[1]-=a*o*Math.sin(h.turn),h.shift[2]+=
n*o}else h.turn-=a*.008,h.rise=Math.min(Math.max(h.rise+n*.006,.02),1.5);k.set(t.pointerId,t)});function At(t){h.away=Math.min(Math.max(h.away*t,2*m),200*m)}x.addEventListener(
"wheel",t=>{At(Math.exp(t.deltaY*.001)),t.preventDefault()},{passive:!1});x.addEventListener("contextmenu",t=>t.preventDefault());function xt(t){V&&Q!==null&&(A+=
(t-Q)/1e3*s.fps*Number(document.getElementById("rate").value),A>=s.count-1&&(A=s.count-1,D(!1)),B.value=A),Q=t,Ut(A),requestAnimationFrame(xt)}if(!i)document.getElementById(
"problem").style.display="flex";else{_t(),Nt(),Yt();let t=/t=([\d.]+)/.exec(location.hash);if(t){let e=s.hoops[0].t.findIndex(a=>a>=Number(t[1]));A=e<0?s.count-
1:e,B.value=A,D(!1)}requestAnimationFrame(xt)}})();
