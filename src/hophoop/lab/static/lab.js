/* Built from web/lab/main.js by esbuild 0.28.2; sources c6da7e9f44281774970bb2af38928960 */
var xi={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function rt(o){let t=o instanceof DataView||ArrayBuffer.isView(o)?o:new DataView(o),e=new Uint8Array(t.buffer,
t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(e.subarray(
4,4+s))),n={};for(let{name:a,type:r,shape:l,place:p}of i.arrays){let c=l.reduce((d,u)=>d*u,1);n[a]=new xi[r](e.buffer,e.byteOffset+4+s+p,c)}return{header:i,arrays:n}}var wt=class extends Error{},ki=500;async function is(o,t,e){for(;;)try{return await o()}catch(s){if(!(s instanceof wt))throw s;t(s.message),await new Promise(i=>setTimeout(
i,ki)),e.throwIfAborted()}}var Lt=class{constructor(t){this.base=t,this.shares=!0}async call(t,e,s){let i=await fetch(new URL(`lab/${t}`,this.base),{method:"POS\
T",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),signal:s});if(!i.ok){let n=await i.json().catch(()=>({}));throw new Error(n.detail??`The s\
erver answered ${i.status}.`)}if(i.status===202)throw new wt((await i.json()).detail);return rt(await i.arrayBuffer())}async file(t,e){let s=await fetch(new URL(
`api/v1/files/${t}?${e}`,this.base));if(!s.ok)throw new Error((await s.json()).detail);return s.blob()}link(t,e){return`${new URL(t?`?${t}`:"",this.base)}${e}`}},
Mi=2e4,Ti=3e5,Rt=class{constructor(t){this.model=t,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).slice(2),this.listen=(e,s)=>this.
answered(e,s),t.on("msg:custom",this.listen)}answered(t,e){let s=t?.view===this.view&&this.waiting.get(t.number);s&&(clearTimeout(s.timer),this.waiting.delete(t.
number),t.compiling?s.reject(new wt(t.compiling)):t.error?s.reject(new Error(t.error)):s.resolve(rt(e[0])))}call(t,e,s){let i=++this.number;return new Promise((n,a)=>{
let r=setTimeout(()=>{this.waiting.delete(i),a(new Error("The notebook’s kernel does not answer; run the cell again."))},t==="file"?Ti:Mi);this.waiting.set(i,
{resolve:n,reject:a,timer:r}),s?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(i),a(new DOMException("superseded","AbortError"))}),this.model.
send({view:this.view,number:i,call:t,body:e})})}async file(t,e){let{arrays:s}=await this.call("file",{query:e,name:t});return new Blob([s.content])}link(){return null}close(){
this.model.off("msg:custom",this.listen)}};var y=(o,t,e)=>Math.min(Math.max(o,t),e);function x(o,t=4){if(o==null)return"–";if(typeof o!="number")return String(o);if(!Number.isFinite(o))return Number.isNaN(
o)?"–":o>0?"∞":"−∞";if(o===0)return"0";let e=Math.abs(o),s;if(e>=1e6||e<1e-4){let[i,n]=o.toExponential(t-1).split("e");s=`${os(i)}·10${Si(Number(n))}`}else
s=os(o.toPrecision(t)),s.includes("e")&&(s=String(Math.round(o)));return s.replace("-","−")}function os(o){return o.includes(".")&&!o.includes("e")?o.replace(
/\.?0+$/,""):o}function Si(o){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(o)].map(e=>t[e]).join(
"")}var O=(o,t)=>t?t==="°"?`${o}°`:`${o} ${t}`:o,$=o=>`${(o*180/Math.PI).toFixed(1)}°`.replace("-","−");function G(o){let t=Math.abs(o),[e,s]=t>=.995?[1,"m"]:
t>=.00995?[100,"cm"]:[1e3,"mm"];return O(x(o*e,3),s)}function z(o,t){let e=o/Math.max(t,1),s=10**Math.floor(Math.log10(e)),i=e/s;return(i>5?10:i>2?5:i>1?2:1)*s}
function W(o,t,e){if(!(t>o)||!Number.isFinite(o)||!Number.isFinite(t))return[];let s=z(t-o,e),i=[];for(let n=Math.ceil(o/s-1e-9);n*s<=t+1e-9*s&&i.length<200;n++)
i.push(n*s);return i}function B(o,t){let e=y(-Math.floor(Math.log10(t)+1e-9),0,15);return Math.max(Math.abs(o),t)>=1e6||e>12?x(o,3):(Math.abs(o)<t*1e-6?0:o).toFixed(
e).replace("-","−")}var bt=[.05,.1,.25,.5,1,2,4],$t=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let t of this.listeners)t(this)}seek(t){this.time=y(t,0,this.duration),this.changed()}play(t=!this.playing){this.playing=t,this.last=null,t&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(t){let e=bt.indexOf(this.speed);this.speed=bt[y(e+t,0,bt.length-1)],this.changed()}tick(t){if(!this.playing)return!1;
let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};var ns={};var as={};var rs={};var hs={};var ke=new Map;function ht(o){try{return localStorage.getItem(o)??ke.get(o)??null}catch{return ke.get(o)??null}}function lt(o,t){ke.set(o,t);try{localStorage.setItem(
o,t)}catch{}}var vt={en:"English",de:"Deutsch",es:"Español",fr:"Français",zh:"中文"},ps={de:ns,es:as,fr:rs,zh:hs},Ii=new Set(["de","es","fr"]),ds="hophoop-language",Li=4e3,
Se=/\{(\w+)\}/g,ct="en",us=[],yt=new Map,Me=new Set,zt=()=>ct;function Ee(o){ct=o in vt?o:"en",yt=new Map,Me.clear(),us=Object.keys(ps[ct]??{}).filter(t=>t.includes(
"{")).map($i).sort((t,e)=>ls(e.key)-ls(t.key))}function Ri(){let o=ht(ds);return o&&o in vt?o:(navigator.languages??[navigator.language]).map(e=>e.slice(0,2).toLowerCase()).
find(e=>e in vt)??"en"}function ms(o){lt(ds,o)}var ls=o=>o.replace(Se,"").length;function $i(o){let t=[...o.matchAll(Se)].map(([,s])=>s),e=o.split(/\{\w+\}/).map(
s=>s.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));return{key:o,names:t,pattern:new RegExp(`^${e.join("(.+?)")}$`,"su")}}var fs=o=>Ii.has(ct)?o.replace(/(\d)\.(\d)/g,"\
$1,$2"):o;function T(o,t){let e=ps[ct];if(t)return gs(e?.[o]??cs(o),t);if(!e||!/\p{L}/u.test(o))return fs(o);let s=yt.get(o);if(s!==void 0)return s;let i=o.trim(),
n=e[i]??zi(i,e)??cs(i),a=o.replace(i,()=>n);return yt.size>Li&&yt.clear(),yt.set(o,a),a}var gs=(o,t)=>o.replace(Se,(e,s)=>T(String(t[s])));function zi(o,t){for(let{
key:e,pattern:s,names:i}of us){let n=o.match(s);if(n)return gs(t[e],Object.fromEntries(i.map((a,r)=>[a,n[r+1]])))}return Ni(o)}function Ni(o){if(o.includes(" → "))
return o.split(" → ").map(t=>T(t)).join(" → ")}function cs(o){let t=/\p{L}{3,}/u.test(o)&&!/^[\w.[\]]+\.\w+$/.test(o);return ct!=="en"&&t&&Me.size<200&&Me.add(o),fs(o)}var ws=new WeakMap,Te=new WeakMap;function Ae(o){
let t=document.createTextNode(T(o));return ws.set(t,o),t}function bs(o,t,e){let s=Te.get(o)??{};s[t]=e,Te.set(o,s),o.setAttribute(t,T(e))}function ys(o){let t=document.
createTreeWalker(o,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let e=t.nextNode();e;e=t.nextNode()){let s=ws.get(e);s!==void 0&&(e.nodeValue=T(s));let i=Te.
get(e);for(let[n,a]of Object.entries(i??{}))e.setAttribute(n,T(a))}}Ee(Ri());var Ci=new Set(["aria-label","title","placeholder","label"]);function h(o,t={},...e){let s=document.createElement(o),i=s;for(let[n,a]of Object.entries(t))a==null||
a===!1||(n.startsWith("on")?s.addEventListener(n.slice(2),a):n==="class"?s.className=a:n in s&&n!=="list"&&typeof a!="string"?i[n]=a:Ci.has(n)?bs(s,n,String(a)):
s.setAttribute(n,a===!0?"":a));for(let n of e.flat())n==null||n===!1||s.append(n.nodeType?n:Ae(String(n)));return s}function H(o,t){t?o.replaceChildren(Ae(t)):o.
replaceChildren()}var pt=o=>o!==null&&o.getRootNode().activeElement===o,K=o=>o.getContext("2d");function _(o){let t=o.getBoundingClientRect(),e=Math.min(globalThis.
devicePixelRatio||1,2.5),s=Math.max(Math.round(t.width*e),1),i=Math.max(Math.round(t.height*e),1);(o.width!==s||o.height!==i)&&(o.width=s,o.height=i);let n=K(o);
return n.setTransform(e,0,0,e,0,0),{context:n,width:s/e,height:i/e}}function Pe(o){let t=getComputedStyle(o),e=s=>t.getPropertyValue(s).trim();return{ink:e("--i\
nk"),soft:e("--soft"),line:e("--line"),paper:e("--paper"),panel:e("--panel"),ground:e("--ground"),font:e("--font"),dark:e("--dark")==="1"}}function dt(o,t){let e=h(
"a",{href:URL.createObjectURL(o),download:t});document.body.append(e),e.click(),e.remove(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function V(o,t){let e=0;
return()=>{clearTimeout(e),e=setTimeout(o,t)}}var vs={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},Fi={mass:"mass [kg]",inner_radius:"inner radius [m]",outer_radius:"outer radius [m]",radius:"radius [m\
]",at:"distance from centre [m]",length:"length [m]"},Oi=(o,t,e)=>({ring:{shape:o,mass:e,inner_radius:.95*t,outer_radius:t},disk:{shape:o,mass:e,radius:.1*t,at:.8*
t},point_mass:{shape:o,mass:e,at:t},rod:{shape:o,mass:e,length:.5*t,at:.5*t}})[o];function xs(o){let t=o["hoop.radius"],e=o["hoop.mass"],s=Math.min(Math.max(o["\
hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:Nt(e*(1-s)),inner_radius:Nt(.98*t),outer_radius:t},{shape:"point_mass",mass:Nt(e*s),at:t}]}var Nt=o=>Number(
o.toPrecision(6)),Ct=class{parts;text;radius;mass;constructor(t){this.onchange=t,this.list=h("div",{class:"parts"}),this.element=h("div",{},this.list,h("select",
{"aria-label":"Add a part",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,Oi(s,this.radius,Nt(.2*this.mass))])}},h("option",{value:""},
"+ add a part …"),Object.entries(vs).map(([e,{label:s}])=>h("option",{value:e},s))))}send(t){this.onchange([["hoop.parts",t]])}show(t,e,s){let i=JSON.stringify(
t);if(i===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(this,{text:i,parts:t,radius:e,mass:s}),this.list.
replaceChildren(...t.map((n,a)=>this.row(n,a)))}row(t,e){let{label:s,keys:i}=vs[t.shape];return h("fieldset",{class:"part"},h("legend",{},s,this.parts.length>1&&
h("button",{type:"button",class:"quiet","aria-label":`Remove part ${e+1}, ${s}`,onclick:()=>this.send(this.parts.filter((n,a)=>a!==e))},"×")),i.map(n=>h("label",
{},Fi[n],h("input",{type:"number",step:"any",value:String(t[n]??0),onchange:a=>this.send(this.parts.map((r,l)=>l===e?{...r,[n]:Number(a.target.value)}:r))}))))}};var ks=Math.PI/180,_e=class{constructor(t,e){this.info=t,this.onchange=e;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`;this.range=h("input",{type:"\
range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,oninput:()=>this.slid(!1),
onchange:()=>this.slid(!0)}),this.number=h("input",{type:"number",step:"any",class:"exact","aria-label":`${t.label}, exact value${t.unit?` in ${t.unit}`:""}`,onchange:()=>this.
typed()}),this.element=h("div",{class:"control",title:t.help},h("label",{for:s},h("span",{},t.label),h("span",{class:"symbol"},t.symbol)),this.range,h("span",{class:"\
entry"},this.number,h("span",{class:"unit"},t.unit)))}low(){return this.info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?
Math.log10(this.info.most):this.info.most}slid(t){let e=Number(this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.number.value=String(
s),this.say(s),this.send(s,t)}typed(){this.number.value.trim()!==""&&this.send(Number(this.number.value),!0)}send(t,e){this.onchange([[this.info.path,this.info.
degrees?t*ks:t]],e)}say(t){this.range.setAttribute("aria-valuetext",O(x(t,4),this.info.unit))}show(t,e=null){let s=t!=null,i=s?t:e;if(i==null){this.number.value=
"";return}let n=i==="inf"?1/0:Number(i)/(this.info.degrees?ks:1),a=Number.isFinite(n)?String(Number(n.toPrecision(9))):"";this.number.value=s?a:"",this.number.placeholder=
s?Number.isFinite(n)?"":"∞":`auto ${x(n,2)}`,this.number.title=s?O(String(n),this.info.unit):"";let r=this.info.logarithmic?Math.log10(n):n;(!pt(this.range)||
Math.abs(Number(this.range.value)-r)>1e-6)&&(this.range.value=String(y(r,this.low(),this.high()))),this.say(n)}};function Bi(o,t){let e=h("select",{"data-path":o.
path,onchange:()=>t([[o.path,e.value]],!0)},o.options.map(([i,n])=>h("option",{value:i},n)));return{element:h("label",{class:"choice",title:o.help},h("span",{},
o.label),e),select:e,path:o.path}}var Ft=class{way;kind;gravity;apart;derived;film;constructor(t,e){this.onchange=(s,i=!0)=>e(s,i),this.sliders=new Map;for(let s of Object.
values(t.groups))for(let i of s)this.sliders.set(i.path,new _e(i,this.onchange));this.choices=new Map(t.choices.map(s=>[s.path,Bi(s,this.onchange)])),this.parts=
new Ct(this.onchange),this.gravities=t.gravities,this.element=h("div",{class:"controls"},this.hoop(),this.plane(),this.start(),this.contact())}at(t){let e=this.
sliders.get(t)??this.choices.get(t);if(!e)throw new Error(`There is no control of ${t}.`);return e.element}select(t,e,s){let i=h("select",{onchange:()=>s(i.value)},
e.map(([n,a])=>h("option",{value:n},a)));return{select:i,element:h("label",{class:"choice"},h("span",{},t),i)}}group(t,...e){let s=t==="Start"||t==="Plane"||!matchMedia(
"(max-width: 760px)").matches;return h("details",{class:"group",open:s},h("summary",{},t),e)}hoop(){return this.way=this.select("Given by",[["load_fraction","lo\
ad fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],t=>{let{values:e}=this.film;t==="parts"?this.onchange([["hoop.parts",xs(e)]]):this.onchange(
[[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=h("p",{class:"derived"}),this.group("Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.e\
ccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.radius"),this.at("hoop.mass"))}plane(){return this.apart=h("input",{type:"\
checkbox",onchange:()=>{let{values:t}=this.film;this.apart.checked?this.onchange([["plane.mu_static",t["plane.mu_static"]],["plane.mu_kinetic",t["plane.mu_kinet\
ic"]]]):this.onchange([["plane.mu",t["plane.mu_static"]]])}}),this.gravity=this.select("Where",[...this.gravities.map(([t])=>[t,t]),["","elsewhere"]],t=>{let e=this.
gravities.find(([s])=>s===t);e&&this.onchange([["plane.gravity",e[1]]])}),this.group("Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_ki\
netic"),h("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("\
plane.restitution"),this.at("plane.impact_law"),this.at("plane.painleve"))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any \
state"]],t=>{let{values:e}=this.film;t==="rolling"?this.onchange([["start.speed",e["start.vx"]]]):this.onchange([["start.omega",e["start.omega"]]])}),this.group(
"Start",this.kind.element,this.at("start.speed"),this.at("start.angle"),this.at("start.height"),this.at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.
at("duration"))}contact(){return this.group("Contact",this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.
at("contact.slip_speed"),this.at("contact.restitution"))}show(t){this.film=t;let{scenario:e,values:s}=t,i=e.hoop.parts?"parts":"load_fraction"in e.hoop?"load_fr\
action":"eccentricity",n="speed"in e.start,a="mu_static"in e.plane,r=e.contact.model==="compliant";this.way.select.value=i,this.kind.select.value=n?"rolling":"f\
ree",this.apart.checked=a;let l=this.gravities.find(([,d])=>Math.abs(d-e.plane.gravity)<1e-9);this.gravity.select.value=l?l[0]:"";let p={"hoop.load_fraction":i===
"load_fraction","hoop.eccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!=="parts","plane.mu":!a,"plane.mu_static":a,"plane.\
mu_kinetic":a,"plane.restitution":!r,"plane.impact_law":!r,"plane.painleve":!r,"start.speed":n,"start.height":!n,"start.vx":!n,"start.vy":!n,"start.omega":!n,"c\
ontact.law":r,"contact.friction":r,"contact.stiffness":r,"contact.slip_speed":r,"contact.restitution":r};for(let[d,u]of Object.entries(p))this.at(d).hidden=!u;this.
parts.element.hidden=i!=="parts",e.hoop.parts&&this.parts.show(e.hoop.parts,s["hoop.radius"],s["hoop.mass"]),this.derived.textContent=i==="eccentricity"?"":`ε =\
 ${x(s["hoop.eccentricity"],5)}, κ = ${x(s["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${x(s["hoop.mass"],5)} kg`:"");let c=e;for(let[d,u]of this.sliders){let[
f,g]=d.split(".");u.show(s[d]??(g?c[f]?.[g]:c[f]),t.automatic?.[d])}for(let[d,{select:u}]of this.choices){let[f,g]=d.split(".");c[f]?.[g]!==void 0&&(u.value=c[f][g])}}};var Ie=Math.PI/180;function Ms(o,t){let{start:e,plane:s,contact:i,hoop:n}=o.scenario;return i.model!=="rigid"?"Rigid contact only.":o.slope!==0?"The plane must \
be level.":Math.abs(o.gravity-9.81)>1e-9?"It must be on Earth.":(s.restitution??0)!==0?"Restitution must be 0.":o.radius!==1||n.parts?"The radius must stay 1 m,\
 without parts.":o.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in n?"speed"in e?Math.abs(e.speed??3.1)>t+1e-9?t>5?"At most 10 \
m/s.":"At most 3.1 m/s.":o.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var Ts=o=>o.events.filter(
({kind:t})=>t==="takeoff");function Di(o){return o.events.filter(({kind:t})=>t==="apex").map(({height:t})=>t)}var Ss=(o,t)=>Math.min(Math.round(100*o/t),100),Wi=1.596,
qi=.37,Hi=.05,Le=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:o=>{let t=Ms(o,3.1);if(t)return{points:0,text:t};let e=Math.max(
0,...Di(o));return e?{points:Ss(e,Wi),text:"It rises by {height}.",values:{height:G(e)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land upright",
text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=0.9\
&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:o=>{let t=Ts(o)[0],e=o.events.find(({kind:a,t:r})=>a==="impact"&&t&&r>t.t);if(!t||!e)return{
points:0,text:"It does not hop."};let s=o.events.find(({kind:a,t:r})=>a==="apex"&&r>t.t);if(!s||s.height<Hi)return{points:0,text:"The first hop is too low."};let i=Math.
abs(e.angle-2*Math.PI*Math.round(e.angle/(2*Math.PI)))/Ie,n=Math.max(0,Math.round(100*(1-(i-.5)/89.5)));return{points:Math.min(n,100),text:"It lands {off} away \
from the top.",values:{off:$(i*Ie)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:o=>{let t=Ms(o,10);if(t)return{points:0,text:t};if(Math.
abs(Math.abs(o.scenario.start.angle??0)-Math.PI)>.5*Ie)return{points:0,text:"The load must start at the bottom."};if(o.values["plane.mu_kinetic"]>1.5||o.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let e=Ts(o)[0];if(!e)return{points:0,text:"It does not hop."};let s=o.phases.filter(
({from:n})=>n<e.t);if(s.some(({mode:n})=>n==="K"))return{points:0,text:"It skids before it hops."};if(s[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let i=o.events.find(({kind:n,t:a})=>n==="apex"&&a>e.t);return i?{points:Ss(i.height,qi),text:"It rises by {height}.",values:{height:G(i.height)}}:{points:0,
text:"It does not hop."}}}],Re=o=>o>=95?3:o>=75?2:o>=40?1:0;var Es="hophoop-best-",Ui=o=>"★".repeat(Re(o))+"☆".repeat(3-Re(o)),Ot=class{goal=null;constructor(t){this.lab=t,this.tabs=new Map(Le.map(e=>[e.key,h("button",
{type:"button","aria-pressed":"false",onclick:()=>this.choose(e)},e.title)])),this.text=h("p",{}),this.meter=h("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"\
100","aria-label":"Score"}),this.result=h("p",{class:"challenge-result",role:"status"}),this.kept=h("p",{class:"hint"}),this.element=h("section",{class:"challen\
ges card","aria-label":"Challenges",hidden:!0},h("header",{},h("h2",{},"Challenges"),h("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",
onclick:()=>this.close()},"×")),h("div",{class:"tabs",role:"group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.
kept,h("div",{class:"buttons"},h("button",{type:"button",onclick:()=>this.goal&&this.load(this.goal.start)},"Begin again"),h("button",{type:"button",onclick:()=>this.
goal&&this.load(this.goal.best)},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??Le[0]),this.element.scrollIntoView({block:"nearest"}),
this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(t){this.goal=t;for(let[e,s]of this.tabs)s.setAttribute(
"aria-pressed",String(e===t.key));H(this.text,t.text),this.changed()}async load(t){let{lab:e}=this;try{let s=await e.backend.call("film",{query:t});e.clock.play(
!1),e.clock.time=0,e.motions.replace(s)}catch(s){e.notice.fail(s)}}changed(){let{goal:t,lab:e}=this;if(!t)return;let{points:s,text:i,values:n={}}=t.score(e.film());
this.meter.value=s;let a=T("{stars} {points} points. {what}",{stars:Ui(s),points:s,what:T(i,n)});this.result.textContent!==a&&(this.result.textContent=a);let r=Number(
ht(Es+t.key)??0);s>r&&!e.stage.options.ahead&&lt(Es+t.key,String(s)),H(this.kept,T("Your best: {points} points.",{points:Math.max(r,e.stage.options.ahead?0:s)}))}};var As=.09,ji=.03,$e=Math.PI/180,Bt=Math.PI/4,Ps=2*Math.PI,xt=o=>o-Ps*Math.round(o/Ps);function Dt(o,t){let e=o.at(t),s=t===0;return{angle:xt(e.angle),height:Math.
max(e.height,0),vx:s?e.vx:0,vy:s?e.vy:0,omega:s?e.omega:0,slope:o.slope}}var _s=o=>2*Math.sqrt(Math.max(o.gravity,1)*o.radius),J=o=>Number(o.toFixed(4))+0;function Is(o,t,e){
if(o==="plane")return[["plane.slope",J(t.slope)]];if(t.height>0)return[["start.angle",J(t.angle)],["start.height",J(t.height)],["start.vx",J(t.vx)],["start.vy",
J(t.vy)],["start.omega",J(t.omega)]];let s=o==="load"?t.omega*e.radius:t.vx;return[["start.angle",J(t.angle)],["start.speed",J(s)]]}var kt=class{constructor(t,e,s,i,n){
this.grip=t,this.film=e,this.view=i,this.before=Dt(e,s),this.held={...this.before,vx:0,vy:0,omega:0};let a=e.at(s);this.center=[a.x,e.radius+a.height],this.foot=
i.point(a.x,0),this.from=this.read(n),this.turned=0,this.trail=[],this.moved=0}read(t){let[e,s]=this.view.unpoint(t.clientX,t.clientY),i=this.grip==="plane"?Math.
atan2(t.clientY-this.foot[1],t.clientX-this.foot[0]):Math.atan2(e-this.center[0],s-this.center[1]);return{x:t.clientX,y:t.clientY,along:e,away:s,turn:i}}move(t,e){
let s=this.read(t),{radius:i}=this.film;if(this.turned+=xt(s.turn-this.from.turn-this.turned),this.grip==="plane"){let n=y(this.before.slope+this.turned,-Bt,Bt);
this.held.slope=Math.abs(n)<$e?0:n}else if(this.grip==="load")this.held.angle=xt(this.before.angle+this.turned);else{let n=this.before.height+s.away-this.from.away;
this.held.height=n<ji*i?0:n;let a=s.along-this.from.along;this.held.angle=xt(this.before.angle+(this.held.height>0?0:a/i)),this.moved=s.x-this.from.x}for(this.trail.
push({t:e/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<e/1e3-As;)this.trail.shift();return this.held}release(t){let{held:e,
trail:s,film:i}=this,n=s.at(-1),a=s[0],r=n&&a?n.t-a.t:0,l=!n||r<.012||t/1e3-n.t>As,p=_s(i);return l||this.grip==="plane"||(this.grip==="load"?e.omega=y((n.turned-
a.turned)/r,-p/i.radius,p/i.radius):(e.vx=y((n.along-a.along)/r,-p,p),e.vy=e.height>0?y((n.away-a.away)/r,-p,p):0)),e}};function Ls(o,t,e,s,i){let n={ArrowLeft:-1,
ArrowRight:1}[t]??0,a={ArrowDown:-1,ArrowUp:1}[t]??0;if(!n&&!a)return null;let r=e?.2:1;if(o==="load"){let d=xt(s.angle+(n||a)*5*$e*r);return{...s,angle:d}}if(o===
"plane"){let d=y(s.slope+(n||-a)*$e*r,-Bt,Bt);return{...s,slope:Math.abs(d)<1e-9?0:d}}let l=_s(i),p=y(s.height+a*.05*r*i.radius,0,4*i.radius),c=y(s.vx+n*.1*r,-l,
l);return{...s,height:p<1e-9?0:p,vx:c}}function I(o,t,e,s=()=>{}){let i=new AbortController,{signal:n}=i,a=(l,p)=>o.addEventListener(l,c=>c.pointerId===t.pointerId&&p(c),{signal:n}),r=l=>p=>{i.abort(),
s(p,l)};o.setPointerCapture(t.pointerId),a("pointermove",e),a("pointerup",r(!0)),a("pointercancel",r(!1))}function Wt(o,t){let e=new Map,s=null,i=()=>{let[a,r]=[
...e.values()];return{span:Math.max(Math.hypot(a.clientX-r.clientX,a.clientY-r.clientY),1),clientX:.5*(a.clientX+r.clientX),clientY:.5*(a.clientY+r.clientY)}};o.
addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(e.set(a.pointerId,a),s=e.size===2?i():null)}),o.addEventListener("pointermove",a=>{if(!e.has(a.pointerId)||
(e.set(a.pointerId,a),e.size!==2||!s))return;let r=i();t(r.span/s.span,r),s=r});for(let a of["pointerup","pointercancel"])o.addEventListener(a,r=>{e.delete(r.pointerId),
s=null});let n=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();return o.addEventListener("touchmove",n,{passive:!1}),()=>e.size>1}var Yi=700,ze=44,Xi=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],qt=class{static Pull=kt;pull=null;held=null;before=null;constructor(t){this.
lab=t,this.places=new Map(Xi.map(([e,s,i])=>[e,this.place(e,s,i)])),this.tip=h("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=h("div",
{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.values()],this.tip),t.stage.element.before(this.element),this.settle=V(()=>this.
chosen(!1),Yi)}place(t,e,s){return h("div",{class:`grip grip-${t}`,role:"slider",tabindex:"0","aria-label":e,"aria-valuenow":"0",title:s,onpointerdown:i=>this.take(
t,i),onkeydown:i=>this.key(t,i),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.flat.views[this.lab.motions.active]}draw(){let{lab:t}=this,
e=this.view(),s=!!e&&!t.stage.options.three;if(this.element.hidden=!s,!s)return;this.element.classList.toggle("running",t.clock.playing);let{pose:i,film:n,scale:a}=e,
r=n.radius,l=e.point(i.x,r+i.height),p=e.point(i.x+r*Math.sin(i.angle),r+i.height+r*Math.cos(i.angle)),c=this.onPlane(e),d=y(1.1*r*a,ze,190),u=[["plane",c,ze],[
"hoop",l,d],["load",p,ze]];for(let[f,[g,b],w]of u){let m=this.places.get(f);m.style.transform=`translate(${g-w/2}px, ${e.top+b-w/2}px)`,m.style.width=m.style.height=
`${w}px`,m.hidden=g<0||b<0||g>e.width||b>e.height}t.clock.playing||this.tell(n)}onPlane(t){let e=t.point(t.pose.x,0),i=(Math.min(e[0]+Math.max(1.9*t.film.radius*
t.scale,90),t.width-30)-e[0])/(t.scale*Math.max(t.cosine,.2));return t.point(t.pose.x+i,0)}tell(t){let e=this.pull?.held??this.held??Dt(t,this.lab.clock.time),s={
load:$(e.angle),hoop:T("gap {height}, speed {speed} m/s",{height:G(e.height),speed:x(e.vx,3)}),plane:$(e.slope)},i={load:e.angle*(180/Math.PI),hoop:e.height,plane:e.
slope*(180/Math.PI)},n={load:[-180,180],hoop:[0,4*t.radius],plane:[-45,45]};for(let[a,r]of this.places)r.getAttribute("aria-valuetext")!==s[a]&&(r.setAttribute(
"aria-valuetext",s[a]),r.setAttribute("aria-valuenow",String(Number(i[a].toPrecision(4)))),r.setAttribute("aria-valuemin",String(n[a][0])),r.setAttribute("aria-\
valuemax",String(Number(n[a][1].toPrecision(4)))))}take(t,e){if(e.button>0||this.pull)return;e.preventDefault();let{lab:s}=this,i=this.places.get(t);i.focus({preventScroll:!0}),
this.hold();let n=this.view(),a=s.stage.element.getBoundingClientRect(),r=d=>({clientX:d.clientX-a.left,clientY:d.clientY-a.top-n.top}),l=new kt(t,s.film(),s.clock.
time,n,r(e)),p=!1,c=[...s.stage.flat.shift];this.pull=l,s.stage.flat.fixed=n.scale,i.classList.add("held"),I(i,e,d=>{!p&&Math.hypot(d.clientX-e.clientX,d.clientY-
e.clientY)<3||(p||this.begin(),p=!0,l.move(r(d),d.timeStamp),s.stage.flat.shift=[c[0]+l.moved,c[1]],this.change(t,l.held,!1),this.show(t,l.held))},(d,u)=>{if(i.
classList.remove("held"),this.pull=null,s.stage.flat.fixed=null,!p){this.before=null;return}u?(this.change(t,l.release(d.timeStamp),!0),this.end(!0)):this.back(),
this.comeBack(c)})}key(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{lab:s}=this;if(e.key==="Escape"&&(this.held||this.pull))this.back();else if(e.key==="En\
ter")this.chosen(!0);else{this.held??=Dt(s.film(),s.clock.time);let i=Ls(t,e.key,e.shiftKey,this.held,s.film());if(!i)return;this.before===null&&(this.hold(),this.
begin()),this.held=i,this.change(t==="load"?"hoop":t,i,!1),this.show(t,i),this.settle()}e.preventDefault(),e.stopPropagation()}hold(){this.lab.clock.play(!1),this.
before=this.lab.film().query}begin(){let{lab:t}=this;t.stage.options.ahead=!0,t.clock.seek(0),t.root.classList.add("holding")}change(t,e,s){this.lab.motions.change(
Is(t,e,this.lab.film()),s)}show(t,e){let s={load:`θ = ${$(e.angle)}`,hoop:e.height>0?`y = ${G(e.height)}`:`θ = ${$(e.angle)}`,plane:`β = ${$(e.slope)}`};H(this.
tip,e.vx&&this.held?`${s[t]}, v = ${x(e.vx,3)} m/s`:s[t]),this.tip.hidden=!1}chosen(t){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(t)}end(t){
let{lab:e}=this;this.held=null,this.before=null,this.tip.hidden=!0,e.stage.options.ahead=!1,e.root.classList.remove("holding"),t&&e.clock.seek(0),t&&!matchMedia(
"(prefers-reduced-motion: reduce)").matches&&e.clock.play(!0),e.request()}async back(){let{lab:t,before:e}=this;if(this.end(!1),e===null)return;let s=t.motions.
lanes[t.motions.active];for(s.pending=null;s.busy;)await new Promise(i=>requestAnimationFrame(i));try{t.motions.replace(await t.backend.call("film",{query:e}))}catch(i){
t.notice.fail(i)}}comeBack(t){let{flat:e}=this.lab.stage,s=matchMedia("(prefers-reduced-motion: reduce)").matches,i=()=>{if(this.pull)return;let n=e.shift[0]-t[0];
e.shift=Math.abs(n)<1||s?[...t]:[t[0]+.82*n,t[1]],this.lab.request(),e.shift[0]!==t[0]&&requestAnimationFrame(i)};i()}};var Gi={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function L(o){let t="\
http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class",
"icon");let s=document.createElementNS(t,"path");return s.setAttribute("d",Gi[o]),e.append(s),e}var Ht=class{constructor(t){this.lab=t,this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener("fullscreenchange",this.left),
this.full=!1,this.on=!1,this.onchange=()=>{}}async turn(t=!this.on){let{root:e}=this.lab;if(this.on=t,e.classList.toggle("presenting",t),this.onchange(),this.lab.
show(),!t){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await e.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var Rs=.22,$s=.03;function zs(o,t){let e=o.at(t),s=o.mass*(o.gravity||9.81),i=e.mode==="H"||!(e.normal_force>0)?0:e.normal_force/s,n=i/(1+i),a=e.mode==="S"||e.mode===
"K",r=Math.abs(e.slip)/Math.sqrt((o.gravity||9.81)*o.radius);return{tone:n,pitch:55*(1+Math.min(i,8))**.5,hiss:a?n*y(.15+r,0,1):0}}function Ns(o,t,e){let s=Math.
sqrt(2*(o.gravity||9.81)*o.radius);return o.events.filter(({kind:i,t:n,before:a})=>i==="impact"&&a&&n>t&&n<=e).map(({before:i})=>y(Math.abs(i.vy)/s,.02,1))}function Ki(o){
let t=o.createBuffer(1,o.sampleRate,o.sampleRate),e=t.getChannelData(0),s=1;for(let i=0;i<e.length;i++)s=s*16807%2147483647,e[i]=2*s/2147483647-1;return t}var Ut=class{static heard=zs;static knocks=Ns;context=null;on=!1;last=0;start(){
let t=new AudioContext,e=t.createOscillator();e.type="triangle";let s=t.createBufferSource();s.buffer=Ki(t),s.loop=!0;let i=t.createBiquadFilter();i.type="bandp\
ass",i.frequency.value=1800,i.Q.value=.6;let[n,a]=[t.createGain(),t.createGain()];n.gain.value=a.gain.value=0,e.connect(n).connect(t.destination),s.connect(i).connect(
a).connect(t.destination),e.start(),s.start(),this.context=t,Object.assign(this,{tone:e,low:n,high:a})}turn(t){this.on=t,t&&!this.context&&this.start(),t?this.context?.
resume():this.context&&(this.set("low",0),this.set("high",0))}set(t,e){let{gain:s}=this[t];s.setTargetAtTime(Rs*e,this.context.currentTime,$s)}follow(t,e){if(!this.
on||!this.context)return;if(!e.playing){this.set("low",0),this.set("high",0),this.last=e.time;return}let{tone:s,pitch:i,hiss:n}=zs(t,e.time);if(this.set("low",s),
this.set("high",.6*n),this.tone.frequency.setTargetAtTime(i,this.context.currentTime,$s),e.time>this.last)for(let a of Ns(t,this.last,e.time))this.knock(a);this.
last=e.time}knock(t){let e=this.context,s=e.currentTime,i=e.createGain();i.gain.setValueAtTime(2.2*Rs*Math.sqrt(t),s),i.gain.exponentialRampToValueAtTime(1e-4,s+
.18);let n=e.createOscillator();n.frequency.setValueAtTime(190,s),n.frequency.exponentialRampToValueAtTime(60,s+.15),n.connect(i).connect(e.destination),n.start(
s),n.stop(s+.2)}close(){this.context?.close()}};var Ne=Math.PI/180,N=o=>t=>t.columns[o],Mt=(o,t)=>e=>e.derived(o,s=>Float64Array.from(e.t,(i,n)=>t(s,n,e))),R={time:{name:"time",symbol:"t",unit:"s",values:o=>o.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:Mt("degrees",({angle:o},t)=>o[t]/Ne)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:Mt(
"within",({angle:o},t)=>{let e=s=>Math.floor(o[s]/Ne/360);return t>0&&e(t)!==e(t-1)?Number.NaN:o[t]/Ne-360*e(t)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:N("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:N("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:Mt(
"rise",({height:o,angle:t},e,s)=>s.radius*(1+s.eccentricity*Math.cos(t[e]))+o[e])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:N("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:Mt("spin",({omega:o},t,e)=>o[t]*e.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:N(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:N("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:N("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:N("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:N("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:N("utilization")},kinetic:{name:"kinetic energy",symbol:"E_k",unit:"J",values:N("kinetic")},potential:{name:"\
potential energy",symbol:"E_p",unit:"J",values:N("potential")},total:{name:"total energy",symbol:"E",unit:"J",values:Mt("total",({kinetic:o,potential:t},e)=>o[e]+
t[e])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:N("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:N("normal_loss")}},Cs=({name:o,symbol:t})=>`${o} ${t}`;var Vi=["time","angle","x","vx","spin","normal_force","friction_force"],Ji=[1,.5,.2,.1,.05,.02,.01],Ce=601;function Fs(o,t,e){let s=Math.min(Math.floor(o.duration/
e+1e-9)+1,Ce),i=[];for(let n=0;n<s;n++){let a=Number((n*e).toPrecision(12));i.push({time:a,mode:o.at(a).mode,values:t.map(r=>Qi(o,r,a))})}return i}function Qi(o,t,e){
if(t==="time")return e;let s=o.at(e);if(t in s&&t!=="angle")return s[t];let i=s.angle*180/Math.PI;if(t==="angle")return i;if(t==="turns")return i-360*Math.floor(
i/360);let n=R[t].values(o),a=o.index(e),r=Math.min(a+1,o.length-1),l=o.t[r]>o.t[a]?(e-o.t[a])/(o.t[r]-o.t[a]):0;return n[a]+l*(n[r]-n[a])}var jt=class{film;rows=[];now;constructor(t){
this.lab=t,this.columns=[...Vi],this.step=h("select",{onchange:()=>this.fill()},Ji.map(e=>h("option",{value:String(e)},`${e} s`))),this.step.value="0.1",this.picks=
h("div",{class:"table-picks"},Object.entries(R).filter(([e])=>e!=="time").map(([e,{name:s}])=>this.pick(e,s))),this.caption=h("caption",{}),this.head=h("thead",
{}),this.body=h("tbody",{}),this.element=h("section",{class:"table","aria-label":"Table of the motion",hidden:!0},h("header",{},h("h2",{},"Table"),h("label",{class:"\
table-step"},h("span",{},"Every"),this.step),h("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),h("button",{type:"button",onclick:()=>this.open(!1)},
"Close")),h("details",{class:"table-columns"},h("summary",{},"Columns"),this.picks),h("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table\
 of the motion, rows"},h("table",{},this.caption,this.head,this.body)))}pick(t,e){let s=h("input",{type:"checkbox",checked:this.columns.includes(t),onchange:()=>{
let i=new Set(this.columns);s.checked?i.add(t):i.delete(t),this.columns=Object.keys(R).filter(n=>i.has(n)),this.fill()}});return h("label",{},s,h("span",{},e))}open(t){
this.element.hidden=!t,t&&(this.draw(this.lab.film()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(t){this.
element.hidden||(this.film=t,this.fill())}fill(){let{film:t,columns:e}=this,s=Number(this.step.value),i=this.lab.theme.colors.mode_names,n=e.map(l=>R[l]);this.head.
replaceChildren(h("tr",{},n.map(({name:l,symbol:p,unit:c})=>h("th",{scope:"col",title:l},p,c&&h("small",{},` ${c}`))),h("th",{scope:"col"},"mode")));let a=Fs(t,
e,s);this.rows=a.map(({time:l,mode:p,values:c})=>({time:l,row:h("tr",{onclick:()=>this.lab.clock.seek(l)},c.map((d,u)=>u===0?h("th",{scope:"row"},x(d,4)):h("td",
{},x(d,4))),h("td",{class:"table-mode"},i[p]))})),this.body.replaceChildren(...this.rows.map(({row:l})=>l));let r=t.duration/s+1<=Ce+1e-6;H(this.caption,r?t.summary:
`${t.summary} ${T("The first {count} rows.",{count:Ce})}`),this.cursor(this.lab.clock.time)}cursor(t){if(this.element.hidden||!this.rows.length)return;let e=Number(
this.step.value),s=this.rows[Math.min(Math.round(t/e),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.add("now"),this.now=
s)}save(){let{film:t,columns:e}=this,s=[...e.map(n=>`${R[n].name} [${R[n].unit||"1"}]`),"mode"],i=Fs(t,e,Number(this.step.value)).map(({mode:n,values:a})=>[...a,
n].join(","));dt(new Blob([[s.join(","),...i,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var Os="hoop.radius=0.4&duration=1.5&start.speed=",Zi=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${Os}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],to=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],eo=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],so=["1.0","1.3","1.6","1.9","2.2","2.3"],io=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function Bs(o,t){
let e=c=>{p.close(),o(c)},s=(c,d="Show")=>h("button",{type:"button",class:"link",onclick:()=>e(c)},d),i=io(),n=i&&[["teach/index.html","Teaching with the hoop"],
["teach/worksheet.html","Worksheet"],["teach/solutions.html","Solutions"],["teach/exercises.html","Exercises"]],a=h("table",{},h("caption",{},"A lesson of 45 mi\
nutes"),h("thead",{},h("tr",{},["Minute","What happens","Motion"].map(c=>h("th",{scope:"col"},c)))),h("tbody",{},Zi.map(([c,d,u])=>h("tr",{},h("th",{scope:"row"},
c),h("td",{},d),h("td",{},u===null?"":s(u)))))),r=h("table",{},h("caption",{},"What students often think"),h("thead",{},h("tr",{},["Idea","What is right"].map(c=>h(
"th",{scope:"col"},c)))),h("tbody",{},to.map(([c,d])=>h("tr",{},h("td",{},c),h("td",{},d))))),l=h("section",{class:"sheet"},h("h3",{},"Worksheet: the hoop that \
hops"),h("p",{},"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at th\
e top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s²."),h("ol",{},eo.map(c=>h("li",{},c,h("div",{class:"answer-line"})))),h("table",{class:"sheet-\
table"},h("thead",{},h("tr",{},["v₀ [m/s]","phases","does it hop?","at which angle?"].map(c=>h("th",{scope:"col"},c)))),h("tbody",{},so.map(c=>h("tr",{},h("th",
{scope:"row"},s(`${Os}${Number(c)}`,c)),h("td",{}),h("td",{}),h("td",{})))))),p=h("dialog",{class:"teach","aria-label":"For teachers"},h("header",{},h("h2",{},"\
For teachers"),h("button",{type:"button",onclick:()=>print()},"Print"),h("button",{type:"button",class:"close",onclick:()=>p.close()},"Close")),h("p",{},"The vi\
sit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",h("button",{type:"button",class:"link",onclick:()=>{p.close(),
t()}},"Start the visit")),n&&h("p",{},n.map(([c,d])=>h("a",{class:"teach-page",href:new URL(c,new URL(i,document.baseURI)).href},d))),a,r,l);return p}var Fe="RSKHM",oo=new Set(["x","angle","height"]),no={x:"vx",angle:"omega",height:"vy"},Q=class{constructor(t){let{header:e}=t;this.scenario=e.scenario,this.query=
e.query,this.duration=e.duration,this.status=e.status,this.sequence=e.sequence,this.events=e.events,this.values=e.values,this.automatic=e.automatic,this.summary=
e.summary,this.story=e.story,this.shortened=e.shortened,this.columns=t.arrays,this.t=t.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radius"],
this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.gravity??
9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map}findPhases(){let{mode:t}=this.columns,e=[];for(let s=0;s<this.length;s++){let i=e.
at(-1);i&&i.mode===Fe[t[s]]?i.to=this.t[s]:e.push({mode:Fe[t[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<e.length;s++)e[s].to=e[s+1].from;return e.filter(
s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,vy:i,omega:n}=this.columns,a={left:1/0,right:-1/0,top:0,speed:0},r=[];for(let l=0;l<this.length;l++){
Number.isFinite(t[l])&&(a.left=Math.min(a.left,t[l]),a.right=Math.max(a.right,t[l])),e[l]>a.top&&(a.top=e[l]);let p=Math.hypot(s[l],i[l])+this.radius*Math.abs(n[l]);
Number.isFinite(p)&&r.push(p)}return r.sort((l,p)=>l-p),a.speed=r[Math.floor(.95*(r.length-1))]||1,a}index(t){let e=0,s=this.length;for(;s-e>1;){let i=e+s>>1;this.
t[i]<=t?e=i:s=i}return e}at(t){let e=y(t,0,this.duration),s=this.index(e),i=Math.min(s+1,this.length-1),n=this.t[i]-this.t[s],a=n>0?(e-this.t[s])/n:0,r={t:e,mode:Fe[this.
columns.mode[s]]};for(let[l,p]of Object.entries(this.columns)){if(l==="t"||l==="mode")continue;let c=p[s],d=p[i];if(a===0||!Number.isFinite(d))r[l]=c;else if(oo.
has(l)){let u=this.columns[no[l]];r[l]=ao(c,d,u[s]*n,u[i]*n,a)}else r[l]=c+(d-c)*a}return r}derived(t,e){let s=this.cache.get(t)??e(this.columns);return this.cache.
set(t,s),s}};function ao(o,t,e,s,i){if(!Number.isFinite(e)||!Number.isFinite(s))return o+(t-o)*i;let n=1-i;return n*n*(1+2*i)*o+i*i*(3-2*i)*t+i*n*(n*e-i*s)}var De=o=>o-360*Math.floor(o/360);function ro(o,t){let e=Math.abs(De(o-t+180)-180);return Math.round(100*y(1-(e-1)/89,0,1))}function ho(o,t){let e=Math.max(...t)-
Math.min(...t,0),s=t.reduce((i,n,a)=>i+Math.abs(n-o[a]),0)/t.length;return Math.round(100*y(1-2*s/(e||1),0,1))}var lo=0;function Et(o,t,e=!1){let s=`hh-guess-${++lo}`,
i="",n=o.map(([a,r])=>{let l=h("input",{type:"radio",name:s,value:a,onchange:()=>{i=a,t()}});return{key:a,radio:l,row:h("label",{class:"guess-choice"},l,h("span",
{},r))}});return{element:h("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},n.map(({row:a})=>a)),made:()=>i!=="",judge:a=>{for(let{key:r,radio:l,
row:p}of n){l.disabled=!0;let c=e||r===a;c&&p.append(h("b",{class:"guess-right"},"✓")),p.classList.toggle("right",c)}return e||i===a?100:0}}}var Y=168,St=58,Oe=(o,t=St)=>{
let e=o*Math.PI/180;return[Y/2+t*Math.sin(e),Y/2-t*Math.cos(e)]};function We(o,t){let e=0,s=!1,i=null,n=h("canvas",{class:"dial-canvas"}),a=h("div",{class:"gues\
s dial",role:"slider",tabindex:"0","aria-label":o,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},n),r=()=>{let{context:c}=_(n),d=getComputedStyle(
a),u=d.getPropertyValue("--ink").trim(),f=d.getPropertyValue("--soft").trim(),g=d.getPropertyValue("--accent").trim();c.clearRect(0,0,Y,Y),c.strokeStyle=f,c.fillStyle=
f,c.lineWidth=1.5,c.beginPath(),c.moveTo(8,Y/2+St),c.lineTo(Y-8,Y/2+St),c.stroke(),c.lineWidth=4,c.beginPath(),c.arc(Y/2,Y/2,St,0,2*Math.PI),c.stroke(),c.font="\
11px system-ui, sans-serif",c.textAlign="center";for(let w of[0,90,180,270]){let[m,v]=Oe(w,St-17);c.fillText(`${w}°`,m,v+4)}let b=(w,m,v)=>{c.fillStyle=m,c.beginPath(),
c.arc(...Oe(w),v,0,2*Math.PI),c.fill()};i!==null&&(c.strokeStyle=u,c.lineWidth=2,c.beginPath(),c.arc(...Oe(i),12,0,2*Math.PI),c.stroke(),b(i,u,7)),b(e,s?g:f,9)},
l=c=>{i===null&&(e=De(c),s=!0,a.setAttribute("aria-valuenow",String(Math.round(e))),a.setAttribute("aria-valuetext",`${Math.round(e)}°`),r(),t())},p=c=>{let d=n.
getBoundingClientRect(),[u,f]=[c.clientX-d.left-d.width/2,c.clientY-d.top-d.height/2];l(Math.atan2(u,-f)*180/Math.PI)};return a.addEventListener("pointerdown",c=>{
c.preventDefault(),a.focus({preventScroll:!0}),p(c),I(a,c,p)}),a.addEventListener("keydown",c=>{let d={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,
PageUp:45}[c.key];d!==void 0&&(c.preventDefault(),c.stopPropagation(),l(e+(c.shiftKey?d/5:d)))}),requestAnimationFrame(r),{element:a,redraw:r,made:()=>s,judge:c=>(i=
De(c),r(),ro(e,i))}}var Tt=9,[U,Yt,st,Be]=[34,12,12,26];function Ds({label:o,unit:t,most:e},s){let i=Array(Tt).fill(e/4),n=!1,a=null,r=h("canvas",{class:"sketch\
-canvas"}),l=i.map((m,v)=>h("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":T("{what} with the load at {angle}",{what:T(o),angle:`${45*v}°`}),
"aria-orientation":"vertical","aria-valuemin":"0","aria-valuemax":String(e),onkeydown:k=>{let M={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[k.key];M&&(k.
preventDefault(),k.stopPropagation(),g(v,i[v]+M*e/(k.shiftKey?100:20)))}})),p=h("div",{class:"guess sketch",role:"group","aria-label":"Draw the curve: pull the \
points up and down"},r,l),c=()=>r.getBoundingClientRect(),d=m=>U+m/(Tt-1)*(c().width-U-Yt),u=m=>st+(1-m/e)*(c().height-st-Be),f=()=>{let{context:m,width:v,height:k}=_(
r),M=getComputedStyle(p),A=S=>M.getPropertyValue(S).trim();m.clearRect(0,0,v,k),m.strokeStyle=A("--line"),m.fillStyle=A("--soft"),m.font="11px system-ui, sans-s\
erif";for(let S=0;S<Tt;S+=2)m.textAlign="center",m.fillText(`${45*S}°`,d(S),k-8),m.strokeRect(d(S),st,0,k-st-Be);for(let S of[0,e/2,e])m.textAlign="right",m.fillText(
String(S),U-6,u(S)+4),m.strokeRect(U,u(S),v-U-Yt,0);m.textAlign="left",m.fillText(t,U+4,st+10);let E=(S,j,vi)=>{m.strokeStyle=j,m.lineWidth=2.5,m.setLineDash(vi),
m.beginPath(),S.forEach((ts,es)=>{let ss=U+es/(S.length-1)*(v-U-Yt);es?m.lineTo(ss,u(y(ts,0,e))):m.moveTo(ss,u(y(ts,0,e)))}),m.stroke(),m.setLineDash([])};E(i,A(
"--accent"),[6,4]),a&&E(a,A("--ink"),[]),l.forEach((S,j)=>{S.style.transform=`translate(${d(j)}px, ${u(i[j])}px)`})},g=(m,v)=>{a||(i[m]=y(v,0,e),n=!0,l[m].setAttribute(
"aria-valuenow",i[m].toPrecision(3)),l[m].setAttribute("aria-valuetext",`${i[m].toPrecision(2)} ${t}`),f(),s())},b=null,w=m=>{let v=c(),k=y((m.clientX-v.left-U)/
(v.width-U-Yt),0,1),M=Math.round(k*(Tt-1)),A=e*(1-(m.clientY-v.top-st)/(v.height-st-Be)),E=b??M,S=i[E];for(let j=Math.min(E,M);j<=Math.max(E,M);j++)g(j,E===M?A:
S+(A-S)*(j-E)/(M-E));b=M};p.addEventListener("pointerdown",m=>{m.preventDefault(),b=null,w(m),I(p,m,w)});for(let[m,v]of l.entries())v.setAttribute("aria-valueno\
w",i[m].toPrecision(3));return requestAnimationFrame(f),{element:p,redraw:f,made:()=>n,judge:m=>{a=m,f();let v=(m.length-1)/(Tt-1);return ho(i,i.map((k,M)=>m[Math.
round(M*v)]))}}}var Gt=2*Math.PI,C=(o,t)=>o.events.find(e=>e.kind===t),Xt=o=>$(o-Gt*Math.floor(o/Gt));function co(o,t,e=72){let{angle:s}=o.columns,i=o.columns[t],n=[],a=0;for(let r=0;r<=
e;r++){let l=o.columns.angle[0]+Gt*r/e;for(;a+1<o.length&&s[a+1]<l;)a+=1;let p=Math.min(a+1,o.length-1),c=s[p]>s[a]?Math.min((l-s[a])/(s[p]-s[a]),1):0;n.push(i[a]+
c*(i[p]-i[a]))}return n}var po=(o,t)=>o.t[o.columns.angle.findIndex(e=>e>=t)]??o.duration,uo={R:"roll",S:"spin",K:"skid",H:"bounce"},it=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:o=>Et(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],o),until:([o])=>{
let[t,e]=[C(o,"skim"),C(o,"impact")];return t?t.t+.7*((e?.t??o.duration)-t.t):o.duration},answer:([o])=>{let t=C(o,"skim")??C(o,"takeoff");return{truth:t?.kind===
"skim"?"skim":t?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:Xt(t?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:o=>Ds({label:"Speed of the centre",unit:"m/s",most:10},
o),until:([o])=>po(o,Gt),answer:([o])=>{let t=co(o,"vx");return{truth:t,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:x(Math.max(
...t),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:o=>We("Angle of the load where it begins to slip",o),until:([o])=>(C(o,"slip_start")?.t??0)+.02,answer:([o])=>{let t=C(o,"slip_start"),e=o.at(t.t).normal_force/
(o.mass*o.gravity);return{truth:t.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:Xt(t.
angle),share:`${x(100*e,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:o=>We("Angle of the load\
 where it takes off",o),until:([o])=>(C(o,"takeoff")?.t??0)+.12,answer:([o])=>{let t=C(o,"takeoff"),e=o.at(t.t-1e-6);return{truth:t.angle*180/Math.PI,text:"It t\
akes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:Xt(t.angle),slip:x(Math.abs(e.slip),3)}}},why:"A rolling hoop would be braked by the plan\
e while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the \
top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does it d\
o just after it has landed?",queries:[""],guess:o=>Et([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim turns \
too fast."],["bounce","It bounces."]],o),until:([o])=>(C(o,"impact")?.t??o.duration)+.15,answer:([o])=>{let[t,e]=[C(o,"takeoff"),C(o,"impact")],s=o.events.find(
i=>i.kind==="apex");return{truth:uo[o.at((e?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
values:{time:x((e?.t??0)-(t?.t??0),3),height:x(100*(s?.height??0),3),angle:Xt(e?.angle??0)}}},why:"An impact takes no time, but its friction is as strong as its\
 push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",title:"\
More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highest?",queries:[
"plane.mu=0.05","plane.mu=0.2",""],guess:o=>Et([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],o),until:o=>.3+Math.max(0,...o.map(t=>C(t,"impact")?.t??0)),
answer:o=>{let t=o.map(n=>Math.max(0,...n.events.map(({kind:a,height:r})=>a==="apex"?r:0))),[e,s,i]=t.map(n=>x(100*n,3));return{truth:String(t.indexOf(Math.max(
...t))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:e,middle:s,high:i}}},why:"On ice nothing drives the ro\
tation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the\
 way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies w\
ith dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plan\
e.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:o=>Et([["flight","It flies off."],["impact","An impact stops the sli\
de at once."],["both","Both agree with the laws."]],o),until:o=>Math.min(.8,...o.map(t=>t.duration)),answer:o=>({truth:o.every(t=>C(t,"painleve_indeterminate"))?
"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws have two an\
swers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"Your tur\
n",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from\
 the motion itself.",question:"",queries:[""]}];var Ws="hophoop-visit",Kt=class{step=null;guess=null;films=[];points=new Map;play;next;stop=null;loop=null;asked=0;constructor(t,e){this.lab=t,this.onchallenges=
e,this.body=h("div",{class:"visit-body"}),this.said=h("div",{class:"visit-answer",role:"status"}),this.element=h("section",{class:"visit card","aria-label":"Gui\
ded visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){ht(Ws)||(this.element.hidden=!1,H(this.said,""),this.
body.replaceChildren(h("div",{class:"buttons offer"},h("p",{},h("b",{},"New here?")," ","Eight short questions: guess, then play."),h("button",{type:"button",class:"\
main",onclick:()=>this.start()},"Start the visit"),h("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){this.points.clear(),this.go(0)}leave(){
lt(Ws,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.root.classList.remove("visiting"),this.veil(),this.
lab.show()}async go(t){let e=it[t],s=++this.asked,{lab:i}=this;i.clock.play(!1),i.clock.time=0,this.step=e,this.stop=null,this.guess=null,this.unwind(),H(this.said,
""),this.element.hidden=!1,i.root.classList.toggle("visiting",t<it.length-1);try{let n=await Promise.all(e.queries.map(a=>i.backend.call("film",{query:a})));if(s!==
this.asked)return;this.films=n.map(a=>new Q(a)),i.motions.active=0,i.motions.set(n.slice(0,2)),this.guess=e.guess?.(()=>this.guessed())??null,this.veil(),i.changed(),
i.motions.note(),this.fill(t)}catch(n){i.notice.fail(n)}}veil(){this.lab.root.classList.toggle("guessing",this.guessing),this.guessing&&this.lab.stage.element.setAttribute(
"aria-label",T("The hoop, before it is let go."))}fill(t){let e=it[t];this.play=h("button",{type:"button",class:"main",disabled:!!this.guess,onclick:()=>this.show()},
"Play");let s=t===it.length-1,i=h("h2",{tabindex:"-1"},e.title);this.next=h("button",{type:"button",onclick:()=>this.go(t+1)},"Next"),this.body.replaceChildren(
h("header",{},h("span",{class:"visit-count"},`Step ${t+1} of ${it.length}`),h("progress",{max:String(it.length),value:String(t+1),"aria-hidden":"true"}),h("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),i,h("p",{},e.text),e.question?h("p",{class:"visit-question"},e.
question):"",this.guess?.element??"",h("div",{class:"buttons"},t>0&&h("button",{type:"button",onclick:()=>this.go(t-1)},"Back"),this.guess&&this.play,s?h("butto\
n",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,s&&h("button",{type:"button",onclick:()=>this.leave()},"Done"),this.guess&&
h("span",{class:"hint visit-wait"},"First say what you expect, then play."))),s&&this.points.size&&this.total(),i.focus({preventScroll:!0})}guessed(){this.play&&
(this.play.disabled=!1);let t=this.body.querySelector(".visit-wait");t&&(t.hidden=!0)}show(){let{lab:t,step:e}=this;!e||!this.guess||(this.play.disabled=!0,this.
stop=e.until?.(t.films())??t.clock.duration,this.loop??=t.clock.loop,t.clock.loop=!1,t.clock.seek(0),matchMedia("(prefers-reduced-motion: reduce)").matches?t.clock.
seek(this.stop):t.clock.play(!0),this.frame())}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:t}=this.lab;if(this.stop===
null||t.playing&&t.time<this.stop||!(t.time>=this.stop-1e-9||!t.playing))return;t.playing=!1;let s=this.stop;this.stop=null,this.unwind(),t.seek(s),this.judge()}judge(){
let{step:t,guess:e}=this;if(!t?.answer||!e)return;let{truth:s,text:i,values:n={}}=t.answer(this.films),a=e.judge(s);this.points.set(t.key,a),this.said.replaceChildren(
h("p",{},h("b",{},T("{points} of 100 points.",{points:a}))," ",T(i,n)),h("p",{},t.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.
scrollIntoView({block:"nearest"})}total(){let t=[...this.points.values()].reduce((e,s)=>e+s,0);this.said.replaceChildren(h("p",{},T("You have {sum} of {most} po\
ints.",{sum:t,most:100*this.points.size})))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&this.veil()}};var Vt=class{constructor(t){this.lab=t,this.grips=new qt(t),this.sound=new Ut,this.present=new Ht(t),this.challenges=new Ot(t),this.visit=new Kt(t,()=>this.challenges.
open()),this.table=new jt(t),this.teach=Bs(e=>this.challenges.load(e),()=>this.visit.start()),this.layOut(),this.spoken()}layOut(){let{lab:t}=this,e=t.stage.element.
parentElement,s=t.root.querySelector(".side");s?s.prepend(this.visit.element,this.challenges.element):e.before(this.visit.element,this.challenges.element),e.after(
this.table.element),t.root.append(this.teach),t.transport.element.querySelector(".switches")?.before(this.tools()),t.header.element.querySelector(".right")?.prepend(
this.menu(),this.languages()),t.hosted&&!location.search&&!location.hash&&this.visit.offer()}tools(){let{clock:t}=this.lab,e=(s,i,n)=>h("button",{type:"button",
title:i,"aria-label":i,"aria-pressed":"false",onclick:n},L(s));return this.loop=e("loop","Repeat",()=>{t.loop=!t.loop,this.mark()}),this.slow=e("slow","Slow mot\
ion: a tenth of the speed",()=>{t.speed=t.speed===.1?1:.1,t.changed(),this.mark()}),this.loud=e("sound","Sound of the contact",()=>{this.sound.turn(!this.sound.
on),this.mark()}),this.large=e("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),this.mark(),h("div",{class:"\
buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:t}=this.lab;this.loop?.setAttribute("aria-pressed",String(t.loop)),this.slow?.setAttribute(
"aria-pressed",String(t.speed===.1)),this.loud?.setAttribute("aria-pressed",String(this.sound.on)),this.large?.setAttribute("aria-pressed",String(this.present.on))}menu(){
let t=(s,i)=>h("button",{type:"button",onclick:()=>{e.open=!1,i()}},s),e=h("details",{class:"menu learn"},h("summary",{class:"button"},"Learn"),h("div",{class:"\
menu-body"},t("Guided visit",()=>this.visit.start()),t("Challenges",()=>this.challenges.open()),t("Table of the motion",()=>this.table.open(!0)),t("Presentation",
()=>this.present.turn(!0)),t("For teachers",()=>this.teach.showModal())));return this.lab.root.addEventListener("pointerdown",s=>{e.contains(s.target)||(e.open=
!1)}),e.addEventListener("keydown",s=>{s.key!=="Escape"||!e.open||(s.stopPropagation(),e.open=!1,e.querySelector("summary")?.focus())}),e}languages(){let t=h("s\
elect",{class:"language","aria-label":"Language",onchange:()=>{ms(t.value),Ee(t.value),this.spoken(),ys(this.lab.root),this.lab.show()}},Object.entries(vt).map(
([e,s])=>h("option",{value:e,lang:e},s)));return t.value=zt(),t}spoken(){this.lab.root.lang=zt(),this.lab.hosted&&(document.documentElement.lang=zt())}frame(){let{
lab:t}=this;this.grips.draw(),this.sound.follow(t.film(),t.clock),this.table.cursor(t.clock.time),this.visit.frame(),this.mark()}changed(){this.grips.draw(),this.
table.draw(this.lab.film()),this.challenges.changed(),this.visit.changed()}close(){this.sound.close(),this.present.close()}};var At=(o,t,e)=>h("button",{type:"button",title:t,"aria-label":t,onclick:e},o),Jt=class{constructor(t,e,s){let i=new Map;for(let a of t)i.set(a.group,[...i.get(
a.group)??[],a]);this.presets=h("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let a=t.find(({key:r})=>r===this.presets.value);a&&
s.take(a)}},h("option",{value:""},"Motions to start from …"),[...i].map(([a,r])=>h("optgroup",{label:a},r.map(({key:l,title:p})=>h("option",{value:l},p))))),this.
undo=At(L("undo"),"Undo (z)",s.undo),this.redo=At(L("redo"),"Redo (y)",s.redo);let n=h("span",{},h("span",{class:"long"},"Compare"),h("span",{class:"short"},L("\
two")));this.compare=At(n,"Compare two hoops",s.compare),this.element=h("header",{class:"top"},h("h1",{},h("span",{class:"logo","aria-hidden":"true"}),h("span",
{},"hophoop",h("span",{class:"long"}," lab"))),this.presets,h("div",{class:"buttons"},this.undo,this.redo,this.compare),h("div",{class:"buttons right"},e,At(L("\
theme"),"Dark or light (d)",s.theme),At("?","Keys and help (?)",s.help)))}show(t,e){this.undo.disabled=!t.past.length,this.redo.disabled=!t.future.length,this.compare.
setAttribute("aria-pressed",String(e))}};var mo=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next hop, landing"],["[ ]","slower, faster"],["Home En\
d","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["z y","undo, redo"],["d","dark, light"],["p",
"Python"]];function qs(o){let t=h("dialog",{class:"help","aria-label":"Keys and help"},h("h2",{},"The hoop"),h("p",{},"A ring with a load on its rim rolls on a \
plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a\
 slider and see."),h("table",{},h("caption",{},"Keys"),mo.map(([e,s])=>h("tr",{},h("th",{scope:"row"},e),h("td",{},s)))),h("p",{class:"hint"},`hophoop ${o}`),h(
"button",{type:"button",class:"close",onclick:()=>t.close()},"Close"));return t}var Qt=class{constructor(t){this.tabs=["A","B"].map((e,s)=>h("button",{type:"button","aria-pressed":"false",onclick:()=>t(s)},`Hoop ${e}`)),this.bar=h("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=h("p",{class:"preset-text"}),this.element=h("div",{class:"lanes"},
this.bar,this.text)}show(t,e){this.bar.hidden=t<2;for(let[s,i]of this.tabs.entries())i.setAttribute("aria-pressed",String(s===e))}};var fo=(o,t)=>({" ":()=>o.clock.play(),ArrowLeft:()=>t?o.transport.jump(-1):o.transport.nudge(-1),ArrowRight:()=>t?o.transport.jump(1):o.transport.nudge(1),Home:()=>o.
clock.seek(0),End:()=>o.clock.seek(o.clock.duration),h:()=>o.transport.jump(1,"takeoff"),l:()=>o.transport.jump(1,"impact"),"[":()=>o.clock.faster(-1),"]":()=>o.
clock.faster(1),t:()=>o.toggle("traces"),f:()=>o.toggle("forces"),c:()=>o.toggle("speed"),w:()=>o.toggle("whole"),3:()=>o.toggle("three"),"+":()=>o.stage.zoom(1.25),
"=":()=>o.stage.zoom(1.25),"-":()=>o.stage.zoom(.8),0:()=>o.stage.zoom(0),z:()=>o.travel(-1),y:()=>o.travel(1),d:()=>o.theme.toggle(),p:()=>o.share.code(),"?":()=>o.
help.showModal()});function go(o,t){let e=t.target;if(t.ctrlKey||t.metaKey||t.altKey||o.root.querySelector("dialog[open]")||e.matches?.("input:not([type=range])\
, textarea, select")||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary"))return;let i=fo(o,t.shiftKey)[t.
key];i&&(t.preventDefault(),i())}function Hs(o,t){let e=t?document:o.root,s=i=>{go(o,i),t||i.stopPropagation()};return e.addEventListener("keydown",s),()=>e.removeEventListener(
"keydown",s)}var[Us,wo]=[62,92],bo=12,ot=10,yo=36,js=Math.PI/180,Pt=["x","y"],Zt=class{box;constructor(t){this.known=new Map(t.map(e=>[e.path,e])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=Us}info(t){return this.known.get(this.paths[t])}whole(t){return[...this.info(t).range]}home(){
for(let t of Pt)this.windows[t]=this.whole(t)}choose(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t]),this.paths[t]=e,this.home()}asked(t,e){
let[s,i]=this.windows[t];return{path:this.paths[t],from:s,to:i,cells:e}}zoom(t,e){let s={x:[],y:[]};for(let i of Pt){let[n,a]=this.windows[i],r=e?.[i]??.5*(n+a);
s[i]=[r-(r-n)*t,r+(a-r)*t];let l=Math.max(Math.abs(s[i][0]),Math.abs(s[i][1]),1e-9);if(s[i][1]-s[i][0]<400*Number.EPSILON*l)return!1;let{range:p}=this.info(i);if(s[i][1]-
s[i][0]>4*(p[1]-p[0]))return!1}return this.windows=s,!0}drag(t,e,s){let i=(n,a)=>t[n].map(r=>r+a*(t[n][1]-t[n][0]));this.windows={x:i("x",-e/this.box.width),y:i(
"y",s/this.box.height)}}middle(){let{x:t,y:e}=this.windows;return{x:.5*(t[0]+t[1]),y:.5*(e[0]+e[1])}}fit(t,e){this.left=this.deep("y")?wo:Us,this.box={width:t-this.
left-bo,height:e-ot-yo}}clip(t){t.beginPath(),t.rect(this.left,ot,this.box.width,this.box.height),t.clip()}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-
e)*this.box.width}y(t){let[e,s]=this.windows.y;return ot+(1-(t-e)/(s-e))*this.box.height}place(t,e){let s=([i,n],a)=>i+y(a,0,1)*(n-i);return{x:s(this.windows.x,
(t-this.left)/this.box.width),y:s(this.windows.y,1-(e-ot)/this.box.height)}}deep(t){let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.abs(e),Math.abs(s))}said(t){
let e=s=>{let i=this.info(s),[n,a]=this.windows[s],r=Math.max(Math.abs(n),Math.abs(a)),l=y(Math.ceil(Math.log10(r/(a-n)))+4,4,16);return`${i.label} = ${O(x(i.degrees?
t[s]/js:t[s],l),i.unit)}`};return`${e("x")}, ${e("y")}`}draw(t,e,s){t.strokeStyle=s.soft,t.fillStyle=s.soft,t.lineWidth=1,t.strokeRect(this.left+.5,ot+.5,this.box.
width-1,this.box.height-1),t.font=`11px ${s.font}`;for(let i of Pt){let n=this.info(i),a=n.degrees?1/js:1,[r,l]=this.windows[i].map(w=>w*a),p=i==="x"?this.box.width/
80:this.box.height/40,c=z(l-r,p),d=this.deep(i),u=d?Number((.5*(r+l)).toPrecision(12)):0,f=d?W(r-u,l-u,p).map(w=>w+u):W(r,l,p);for(let w of f){let m=d?x(w-u,3):
B(w,c);i==="x"?(t.textAlign="center",t.fillText(m,this.x(w/a),ot+this.box.height+14)):(t.textAlign="right",t.textBaseline="middle",t.fillText(m,this.left-5,this.
y(w/a)),t.textBaseline="alphabetic")}let g=d?` − ${String(u).replace("-","−")}`:"",b=`${n.label}${g}${n.unit?` [${n.unit}]`:""}`;t.save(),t.textAlign="cente\
r",i==="x"?t.translate(this.left+.5*this.box.width,e-5):(t.translate(12,ot+.5*this.box.height),t.rotate(-Math.PI/2)),t.fillText(b,0,0),t.restore()}}};function qe(o,t,e,s,i){
for(let[n,a]of[[i,4],[s,1.8]])o.strokeStyle=n,o.lineWidth=a,o.beginPath(),o.arc(t,e,7,0,2*Math.PI),o.moveTo(t-13,e),o.lineTo(t-4,e),o.moveTo(t+4,e),o.lineTo(t+13,
e),o.moveTo(t,e-13),o.lineTo(t,e-4),o.moveTo(t,e+4),o.lineTo(t,e+13),o.stroke()}var Ys={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},Xs=48;function Gs(o){let{body:t}=o,e=Wt(t,(i,n)=>o.axes.box&&o.zoom(1/i,te(o,n))),s=!1;
t.addEventListener("wheel",i=>{o.axes.box&&(i.preventDefault(),o.zoom(Math.exp(y(i.deltaY,-200,200)*.0022),te(o,i)))},{passive:!1}),t.addEventListener("pointerd\
own",i=>xo(o,i,e,n=>s=n)),t.addEventListener("pointermove",i=>{o.axes.box&&!s&&i.pointerType!=="touch"&&vo(o,i)}),t.addEventListener("pointerleave",()=>o.tip.hidden=
!0),t.addEventListener("dblclick",()=>o.zoom(.35,o.pointed??void 0)),t.addEventListener("keydown",i=>ko(o,i))}function te(o,t){let e=o.body.getBoundingClientRect();
return o.axes.place(t.clientX-e.left,t.clientY-e.top)}function vo(o,t){o.tip.textContent=o.said(te(o,t)),o.tip.hidden=!1;let e=o.body.getBoundingClientRect();o.
tip.style.left=`${y(t.clientX-e.left,150,Math.max(e.width-150,150))}px`,o.tip.style.bottom=`${e.bottom-t.clientY+16}px`}function xo(o,t,e,s){t.preventDefault(),
o.body.focus({preventScroll:!0});let i=[t.clientX,t.clientY],n={x:[...o.axes.windows.x],y:[...o.axes.windows.y]};o.pointed=te(o,t);let a=!1,r=e(),l=p=>{if(r||=e(),
r)return;let[c,d]=[p.clientX-i[0],p.clientY-i[1]];Math.hypot(c,d)<5&&!a||(a=!0,s(!0),o.tip.hidden=!0,o.axes.drag(n,c,d),o.redraw(),o.soon())};I(o.body,t,l,(p,c)=>{
c&&!a&&!r&&o.pointed&&o.take(o.pointed),s(!1)})}function ko(o,t){let e=o.pointed??o.here()??o.axes.middle();if(o.pointed=e,Ys[t.key]){let[s,i]=Ys[t.key],{x:n,y:a}=o.
axes.windows;o.pointed={x:e.x+s*(n[1]-n[0])/Xs,y:e.y+i*(a[1]-a[0])/Xs},o.state.textContent=o.said(o.pointed)}else if(t.key==="Enter")o.take(e);else if(t.key==="\
+"||t.key==="=")o.zoom(.6,e);else if(t.key==="-")o.zoom(1.7,e);else if(t.key==="0")o.home();else return;t.preventDefault(),t.stopPropagation(),o.redraw()}function X(o){let t=Number.parseInt(o.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}var Ks=o=>He(o)>.2?"#111111":"#ffffff",_t=(o,t)=>`rgba(${X(o).join(",")},${t}\
)`,Mo=o=>{let t=o/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4};function He(o){let[t,e,s]=X(o).map(Mo);return .2126*t+.7152*e+.0722*s}function se(o,t){if(!t||
!/^#[0-9a-f]{6}$/i.test(o))return o;if(He(o)<.002)return"#eceef2";let e=o;for(let s=0;He(e)<.2&&s<1;s+=.05)e=`#${X(o).map(i=>Math.round(i+(255-i)*s).toString(16).
padStart(2,"0")).join("")}`;return e}var ee=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function To(){let o=[];for(let t=0;t<
256;t++){let e=t/255*(ee.length-1),s=Math.min(Math.floor(e),ee.length-2),i=X(ee[s]),n=X(ee[s+1]);o.push(i.map((a,r)=>Math.round(a+(n[r]-a)*(e-s))))}return o}var ut=To(),
ie=ut.map(o=>`rgb(${o.join(",")})`);var So=Math.PI/180,Eo=12,Ao=["hop_height","flight_time","energy_lost","greatest_utilization"];function Vs(o){return o.unit==="rad"?[1/So,"°"]:[1,o.unit==="1"?"":
o.unit]}function Po({classes:o,what:t},e){let[s,i]=[1/0,-1/0];if(o)return[s,i];for(let n of e)n<s&&(s=n),n>i&&(i=n);return[Ao.includes(t)?Math.min(s,0):s,i]}function Js(o){
let{values:t}=o.arrays,e=o.header,{x:s,y:i,classes:n}=e,a=new ImageData(s.cells,i.cells),[r,l]=Po(e,t),p=n?.map(({color:d})=>X(d));for(let d=0;d<i.cells;d++)for(let u=0;u<
s.cells;u++){let f=t[d*s.cells+u],g=4*((i.cells-1-d)*s.cells+u);if(!Number.isFinite(f))continue;let b=p&&(u+1<s.cells&&t[d*s.cells+u+1]!==f||d+1<i.cells&&t[(d+1)*
s.cells+u]!==f),w=p?p[f].map(m=>b?.72*m:m):ut[y(Math.round(255*(f-r)/(l-r||1)),0,255)];a.data.set([...w,255],g)}let c=h("canvas",{width:s.cells,height:i.cells});
return K(c).putImageData(a,0,0),{picture:c,header:e,values:t,x:[s.from,s.to],y:[i.from,i.to],low:r,high:l}}function Qs(o,t){let e=(i,n)=>i[0]>=n[0]-1e-300&&i[1]<=
n[1]+1e-300;return[...o.filter(i=>!(e(i.x,t.x)&&e(i.y,t.y))),t].slice(-Eo)}function Zs({header:o,low:t,high:e,values:s}){let{classes:i}=o;if(!i){let r=h("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=K(r);for(let d=0;d<120;d++)l.fillStyle=`rgb(${ut[Math.floor(255*d/119)].join(",")})`,l.fillRect(d,0,1,10);
let[p,c]=Vs(o);return[h("span",{},`${o.label}: ${e>=t?x(t*p,3):"none"} `),r,h("span",{},e>=t?O(x(e*p,3),c):""),s.some(d=>!Number.isFinite(d))?h("span",{},h("i",
{class:"blank"}),"none"):""]}let n=new Map;for(let r of s)n.set(r,(n.get(r)??0)+1);let a=[...n].filter(([r])=>r>=0).sort((r,l)=>l[1]-r[1]);return[...a.slice(0,10).
map(([r])=>{let{color:l,text:p}=i[r];return h("span",{},h("i",{style:`background:${l}`,"aria-hidden":"true"}),p)}),a.length>10?h("span",{},`and ${a.length-10} m\
ore`):""]}function ti(o,t){for(let{header:e,values:s}of[...o].reverse()){let{x:i,y:n,classes:a}=e,r=Math.floor((t.x-i.from)/(i.to-i.from)*i.cells),l=Math.floor(
(t.y-n.from)/(n.to-n.from)*n.cells);if(r<0||l<0||r>=i.cells||l>=n.cells)continue;let p=s[l*i.cells+r];if(a)return a[p]?.text??"not allowed";let[c,d]=Vs(e);return Number.
isFinite(p)?O(x(p*c,4),d):"none"}return"…"}var ei=[[24,16],[72,48],[216,144]],oe=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(t,e,s){this.backend=t,this.onmotion=s;let i=e.
controls.map_axes;this.axes=new Zt(i),this.what="sequence",this.layers=[],this.canvas=h("canvas",{class:"plot-canvas"}),this.tip=h("div",{class:"tip",hidden:!0}),
this.body=h("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow keys move the mark, Enter takes the motion, plus and min\
us zoom."},this.canvas,this.tip),this.keys=h("div",{class:"map-keys"}),this.state=h("span",{class:"hint",role:"status"});let n=a=>{let r=h("select",{"data-axis":a,
onchange:()=>this.setAxis(a,r.value)},i.map(({path:l,label:p})=>h("option",{value:l},p)));return r};this.selects={x:n("x"),y:n("y")},this.quantity=h("select",{"\
aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},e.map_quantities.map(([a,r])=>h("option",{value:a},r))),this.element=
h("section",{class:"map","aria-label":"Map of motions"},h("div",{class:"map-head"},h("h2",{},"Map"),h("label",{},"of",this.quantity),h("label",{},"Across",this.
selects.x),h("label",{},"Up",this.selects.y),h("span",{class:"buttons"},h("button",{type:"button","aria-label":"Zoom into the map",onclick:()=>this.zoom(.5)},"+"),
h("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),h("button",{type:"button",onclick:()=>this.home()},"Whole map")),this.
state),this.body,this.keys,h("p",{class:"hint"},"Click to take that motion into the player; wheel or two fingers to zoom, drag to move.")),Gs(this),this.soon=V(
()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([a])=>{this.seen=a.isIntersecting,this.seen&&this.stale&&this.refresh()}),this.watch.observe(
this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let t of Pt)this.selects[t].value=this.axes.paths[t]}setAxis(t,e){
this.axes.choose(t,e),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(t){let e=structuredClone(t);for(let s of Object.values(this.
axes.paths)){let[i,n]=s.split(".");e[i]&&delete e[i][n]}return JSON.stringify(e)}mark(t,e){this.film=t,this.look=e;let s=this.key_of(t.scenario);s!==this.key_now&&
(this.key_now=s,this.soon()),this.redraw()}async refresh(){if(!this.film)return;if(!this.seen){this.stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=
new AbortController;let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[["contact.model","rigid"]];this.computing=!0;let i=`${this.what}\
 ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;i!==this.kind&&(this.layers=[]),this.kind=i,this.redraw();try{for(let[n,a]of ei){this.state.textContent=
`computing ${n*a} motions …`;let r={x:this.axes.asked("x",n),y:this.axes.asked("y",a)},l={scenario:e,changes:s,...r,what:this.what},p=await is(()=>this.backend.
call("map",l,t),d=>{this.state.textContent=d},t),c=Js(p);this.layers=Qs(this.layers,c),this.keys.replaceChildren(...Zs(c)),this.state.textContent=`${n*a} motion\
s${s.length?", with rigid contact":""}`,this.redraw()}this.level=ei.length}catch(n){let{name:a,message:r}=n;if(a==="AbortError")return;this.state.textContent=r}
this.computing=!1}redraw(){if(!this.film)return;let{look:t}=this,{context:e,width:s,height:i}=_(this.canvas);this.axes.fit(s,i),e.clearRect(0,0,s,i),e.save(),this.
axes.clip(e),e.imageSmoothingEnabled=!1;let{axes:n}=this;for(let r of this.layers){let[l,p]=r.x.map(u=>n.x(u)),[c,d]=r.y.map(u=>n.y(u));e.drawImage(r.picture,l,
d,p-l,c-d)}let a=this.here();a&&qe(e,n.x(a.x),n.y(a.y),t.ink,t.paper),this.pointed&&pt(this.body)&&qe(e,n.x(this.pointed.x),n.y(this.pointed.y),"#D55E00",t.paper),
e.restore(),n.draw(e,i,t)}here(){let t=s=>{let[i,n]=s.split(".");return this.film.values[s]??this.film.scenario[i]?.[n]},e={x:t(this.axes.paths.x),y:t(this.axes.
paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}said(t){return`${this.axes.said(t)}: ${ti(this.layers,t)}`}take(t){this.onmotion([[this.axes.
paths.x,t.x],[this.axes.paths.y,t.y]])}zoom(t,e){this.tip.hidden=!0,this.axes.zoom(t,e)&&(this.redraw(),this.soon())}};var ne=class{constructor(){this.past=[],this.future=[],this.now=null}note(t){this.now&&JSON.stringify(this.now)!==JSON.stringify(t)&&(this.past.push(this.now),this.
past.length>500&&this.past.shift(),this.future=[]),this.now=t}step(t){let[e,s]=t<0?[this.past,this.future]:[this.future,this.past],i=e.pop();return!i||!this.now?
null:(s.push(this.now),this.now=i,i)}};var ae=class{constructor(t,e){this.backend=t,this.listener=e,this.history=new ne,this.lanes=[],this.active=0}film(t=this.active){return this.lanes[t].film}films(){
return this.lanes.map(t=>t.film)}name(){return this.lanes.length>1?"AB"[this.active]:""}set(t){this.lanes=t.map(e=>({film:new Q(e)})),this.active=Math.min(this.
active,this.lanes.length-1)}async load(t){this.set(await Promise.all(t.map(e=>this.backend.call("film",{query:e}))))}change(t,e){let s=this.lanes[this.active];s.
since??=performance.now(),s.pending=[...(s.pending??[]).filter(([i])=>!t.some(([n])=>n===i)),...t],s.commit||=e,this.pump(s)}async pump(t){if(t.busy)return;if(!t.
pending){t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{t.film=new Q(await this.backend.call("film",{scenario:t.
film.scenario,changes:e})),this.listener.shown(s)}catch(i){this.listener.failed(i)}finally{t.busy=!1}this.pump(t)}settle(t){t.commit=!1,this.note(),this.listener.
settled()}note(){this.history.note(this.films().map(t=>t.query)),this.listener.noted()}replace(t){this.lanes[this.active].film=new Q(t),this.listener.shown(),this.
note()}async travel(t){let e=this.history.step(t);e&&(await this.load(e),this.listener.shown(),this.listener.noted())}compare(){this.lanes.length===1?(this.lanes.
push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=0),this.listener.shown(),this.note()}choose(t){this.active=t,this.
listener.shown(),this.listener.noted()}link(){let t=this.lanes.length>1?`#with=${encodeURIComponent(this.film(1).query)}`:"";return this.backend.link(this.film(
0).query,t)}};var _o=4e3,re=class{constructor(){this.message=h("p",{class:"message",role:"alert",hidden:!0}),this.toast=h("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(t){this.message.textContent=t.message,this.message.hidden=!1,this.message.isConnected||this.say(t.message)}clear(){this.message.hidden=!0}say(t){this.
toast.textContent=t,this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},_o)}};var Io=.0018,[Lo,Ro]=[1/.6,1/1.7];function Z(o,{zoom:t,home:e,chosen:s=()=>o,keys:i=!1}){return o.addEventListener("wheel",n=>{(n.ctrlKey||n.shiftKey||pt(s()))&&
(n.preventDefault(),t(Math.exp(-(n.deltaY||n.deltaX)*Io),n))},{passive:!1}),o.addEventListener("dblclick",e),i&&o.addEventListener("keydown",n=>{if(n.key==="+"||
n.key==="=")t(Lo);else if(n.key==="-")t(Ro);else if(n.key==="0")e();else return;n.preventDefault(),n.stopPropagation()}),Wt(o,t)}var D=52,Ue=10,F=8,$o=30,zo={solid:[],dash:[6,4],dot:[2,3]},mt=class{films;active;look;box;range;heights;picked;named;values;constructor({key:t,title:e,unit:s,curves:i,
limits:n,symmetric:a=!1},r){this.key=t,this.title=e,this.unit=s,this.curves=i,this.limits=n,this.symmetric=a,this.shared=r,this.canvas=h("canvas",{class:"plot-c\
anvas"}),this.over=h("canvas",{class:"plot-canvas plot-over"}),this.keys=h("div",{class:"plot-keys"}),this.body=h("div",{class:"plot-body",tabindex:"0",role:"im\
g","aria-label":e},this.canvas,this.over),this.element=h("section",{class:"plot","data-plot":t},h("header",{},h("h3",{},e),this.keys),this.body),this.body.addEventListener(
"pointerdown",l=>this.press(l)),this.pinched=Z(this.body,{zoom:(l,p)=>this.films&&this.zoomAbout(p?this.valueAt(p):this.middle(),1/l),home:()=>this.zoomTo(null),
keys:!0}),this.onseek=()=>{}}abscissa(t){return R[this.shared.axis].values(t)}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.
duration),1e-9)];let[t,e]=[1/0,-1/0];for(let s of this.films)for(let i of this.abscissa(s))i<t&&(t=i),i>e&&(e=i);return e>t?[t,e]:[t-1,e+1]}draw(t,e,s,i){this.films=
t,this.active=e,this.look=s;let{context:n,width:a,height:r}=_(this.canvas);this.box={width:a-D-Ue,height:r-F-$o},n.clearRect(0,0,a,r),this.range=this.shared.range??
this.fullRange();let l=t.flatMap((p,c)=>this.shades(p).map(d=>({...d,film:p,lane:c})));this.heights=this.limits??this.findHeights(l),this.shared.axis==="time"&&
this.bands(n,t[e],i),this.grid(n,s,a,r),n.save(),n.beginPath(),n.rect(D,F,this.box.width,this.box.height),n.clip();for(let p of l)this.curve(n,p,t.length>1);n.restore(),
this.legend(this.shades(t[e]),s.dark),this.describe(l)}shades(t){return this.curves(t).map(e=>({...e,color:e.color&&se(e.color,this.look.dark)}))}x(t){return D+
(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return F+(1-(t-this.heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(t){
let e=[];for(let{film:c,values:d}of t){let u=this.abscissa(c);for(let f=0;f<d.length;f++)u[f]>=this.range[0]&&u[f]<=this.range[1]&&Number.isFinite(d[f])&&e.push(
d[f])}if(!e.length)return[0,1];let s=Float64Array.from(e).sort(),[i,n]=[s[0],s[s.length-1]],[a,r]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],l=Math.
max(r-a,1e-12);n>r+4*l&&(n=r+.6*l),i<a-4*l&&(i=a-.6*l),i=Math.min(i,0),n=Math.max(n,0),this.symmetric&&([i,n]=[-Math.max(-i,n),Math.max(-i,n)]);let p=.06*(n-i)||
1;return[i<0?i-p:i,n+p]}bands(t,e,s){for(let i of e.phases){let n=y(this.x(i.from),D,D+this.box.width),a=y(this.x(i.to),D,D+this.box.width);a<=n||(t.fillStyle=_t(
s.modes[i.mode],.14),t.fillRect(n,F,a-n,this.box.height))}}grid(t,e,s,i){t.font=`11px ${e.font}`,t.strokeStyle=e.line,t.fillStyle=e.soft,t.lineWidth=1;let n=Math.
max(this.box.height/28,4);for(;W(this.heights[0],this.heights[1],n).length<3&&n<12;)n+=1;let a=z(this.heights[1]-this.heights[0],n);t.textAlign="right",t.textBaseline=
"middle";for(let u of W(this.heights[0],this.heights[1],n)){let f=Math.round(this.y(u))+.5;t.globalAlpha=Math.abs(u)<1e-9*a?1:.55,t.beginPath(),t.moveTo(D,f),t.
lineTo(s-Ue,f),t.stroke(),t.globalAlpha=1,t.fillText(B(u,a),D-6,f)}let r=this.box.width/70,l=z(this.range[1]-this.range[0],r);t.textAlign="center",t.textBaseline=
"alphabetic";let{name:p,unit:c}=R[this.shared.axis],d=c?`${T(p)} [${c}]`:T(p);for(let u of W(this.range[0],this.range[1],r)){let f=this.x(u);t.beginPath(),t.moveTo(
f,F+this.box.height),t.lineTo(f,F+this.box.height+4),t.stroke(),t.fillText(B(u,l),f,F+this.box.height+15)}t.textAlign="right",t.fillText(d,s-Ue,i-3),t.save(),t.
translate(11,F+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText(this.unit,0,0),t.restore()}curve(t,{film:e,lane:s,values:i,color:n,dash:a},r){
let l=this.abscissa(e);t.strokeStyle=n??this.look.ink,t.lineWidth=r&&s===1?1.2:1.8,t.setLineDash(r&&s===1?[3,3]:zo[a??"solid"]),t.globalAlpha=r&&s===1?.85:1,t.beginPath();
let p=!1;for(let c=0;c<i.length;c++){if(!Number.isFinite(i[c])||!Number.isFinite(l[c])){p=!1;continue}let d=this.x(l[c]),u=y(this.y(i[c]),-1e4,1e4);p?t.lineTo(d,
u):t.moveTo(d,u),p=!0}t.stroke(),t.setLineDash([]),t.globalAlpha=1}legend(t,e){let s=t.map(i=>i.name).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>h(
"output",{})),this.keys.replaceChildren(...t.map((i,n)=>h("span",{class:"plot-key"},je(i.color,i.dash),i.name," ",this.values[n]))))}describe(t){let e=t.slice(0,
6).map(({name:s,values:i,lane:n})=>{let[a,r]=[1/0,-1/0];for(let p of i)p<a&&(a=p),p>r&&(r=p);let l=this.films.length>1?`${"AB"[n]}: `:"";return r>=a?`${l}${s} f\
rom ${x(a,3)} to ${x(r,3)}`:""});this.body.setAttribute("aria-label",`${this.title} in ${this.unit}. ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.films)
return;let{context:e,width:s,height:i}=_(this.over);if(e.clearRect(0,0,s,i),this.films.forEach((n,a)=>{let r=n.at(t),l=n.index(r.t),p=Math.min(l+1,n.length-1),c=n.
t[p]>n.t[l]?(r.t-n.t[l])/(n.t[p]-n.t[l]):0,d=this.abscissa(n),u=this.x(d[l]+c*(d[p]-d[l])),f=u>=D-1&&u<=D+this.box.width+1;f&&(e.strokeStyle=this.look.soft,e.lineWidth=
1,e.beginPath(),e.moveTo(u,F),e.lineTo(u,F+this.box.height),e.stroke()),this.shades(n).forEach((g,b)=>{let w=g.values[p],m=Number.isFinite(w)?g.values[l]+c*(w-g.
values[l]):g.values[l];a===this.active&&this.values?.[b]&&(this.values[b].textContent=x(m,3));let v=this.y(m);!f||!(v>=F-1&&v<=F+this.box.height+1)||(e.fillStyle=
g.color??this.look.ink,e.beginPath(),e.arc(u,v,3.2,0,2*Math.PI),e.fill())})}),this.picked){let[n,a]=this.picked;e.fillStyle=_t("#0072B2",.2),e.fillRect(Math.min(
n,a),F,Math.abs(a-n),this.box.height)}}valueAt(t){let e=this.body.getBoundingClientRect(),s=y((t.clientX-e.left-D)/this.box.width,0,1);return this.range[0]+s*(this.
range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.body.getBoundingClientRect(),s=t.clientX-e.left,i=this.valueAt(t),n=this.pinched(),a=r=>{if(n||=
this.pinched(),n)return;let l=r.clientX-e.left;this.picked=t.pointerType==="mouse"&&Math.abs(l-s)>5?[s,l]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(r)),
this.cursor(this.shared.clock.time)};I(this.body,t,a,(r,l)=>{let p=this.valueAt(r),{picked:c}=this;this.picked=null,c&&l?this.zoomTo(i<p?[i,p]:[p,i]):c?this.cursor(
this.shared.clock.time):l&&!n&&this.seek(t.pointerType==="mouse"?i:p)})}seek(t){if(this.shared.axis==="time")return this.onseek(t);let e=this.films[this.active],
s=this.abscissa(e),i=0;for(let n=0;n<s.length;n++)Math.abs(s[n]-t)<Math.abs(s[i]-t)&&(i=n);return this.onseek(e.t[i])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(t,e){
let s=this.fullRange(),i=Math.max(t-(t-this.range[0])*e,s[0]),n=Math.min(t+(this.range[1]-t)*e,s[1]);this.zoomTo(i<=s[0]&&n>=s[1]?null:[i,n])}zoomTo(t){this.shared.
range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}};function je(o,t="solid"){let e=h("i",{class:"swatch","aria-hidden":"true"});return e.style.borderTopColor=
o??"var(--ink)",e.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted"}[t],e}var tt=52,si=10,P=8,No=30,Co="RSKHM?",he=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(t,e,s){this.backend=
t,this.clock=e,this.colors=s,this.canvas=h("canvas",{class:"plot-canvas"}),this.over=h("canvas",{class:"plot-canvas plot-over"}),this.keys=h("div",{class:"plot-\
keys"}),this.body=h("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=h("section",{class:"phase"},h("header",{},h("h3",{},"Plane of θ and θ̇"),this.keys),this.body,h("p",{class:"hint"},
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox. "+(matchMedia("(hover: none)").matches?"Tap to go there, t\
wo fingers zoom.":"Click to go there; with Ctrl or Shift the wheel zooms, double-click for all."))),this.body.addEventListener("pointerdown",i=>this.seek(i)),this.
pinched=Z(this.body,{zoom:(i,n)=>this.box&&this.zoomAbout(n?this.point(n):this.middle(),1/i),home:()=>this.zoomTo(null),keys:!0}),this.range=[0,2*Math.PI],this.
asked="",this.soon=V(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),i=JSON.stringify([t.hoop,t.plane,s]);if(i!==this.asked){let n=await this.painted(
t,[0,2*Math.PI,-s,s],e);this.asked=i,this.pictures=[n],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.pictures||!this.window)){this.
sharpening?.abort(),this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,[...this.range,...this.window],this.sharpening.
signal);this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){let{header:i,arrays:n}=await this.backend.
call("regions",{scenario:t,window:e},s);return{window:i.window,paradox:n.paradox,picture:this.paint(n.modes,i.arrays[0].shape)}}reach(){return this.reached}findReach(){
let t=0;for(let s of this.films??[]){let i=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(t,i[Math.floor(.99*(i.length-1))]??
0)}let e=z(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}zoomTo(t){this.range=t??[0,2*Math.PI],this.window=null,this.pictures?.splice(1),this.redraw()}point(t){
let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left-tt)/this.box.width,i=1-(t.clientY-e.top-P)/this.box.height;return[this.range[0]+s*(this.range[1]-this.
range[0]),this.bottom()+i*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.bottom()+this.top())]}zoomAbout([t,e],s){let i=Math.
max(t-(t-this.range[0])*s,0),n=Math.min(t+(this.range[1]-t)*s,2*Math.PI),a=this.reach(),r=Math.max(e-(e-this.bottom())*s,-a),l=Math.min(e+(this.top()-e)*s,a);this.
range=[i,n],this.window=n-i<2*Math.PI-1e-9||l-r<2*a-1e-9?[r,l]:null,this.redraw(),this.soon()}bottom(){return this.window?this.window[0]:this.backwards?-this.reach():
0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){this.films=t,this.active=e,this.look=s,this.reached=this.findReach(),
this.forwards=t.some(i=>i.columns.omega.some(n=>n>.3)),this.backwards=t.some(i=>i.columns.omega.some(n=>n<-.3)),!this.forwards&&!this.backwards&&(this.forwards=
!0),this.redraw()}x(t){return tt+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return P+(1-(t-this.bottom())/(this.top()-this.bottom()))*this.
box.height}paint(t,[e,s]){let{modes:i}=this.colors,n=h("canvas",{width:s,height:e}),a=new ImageData(s,e);for(let r=0;r<e;r++)for(let l=0;l<s;l++){let p=Co[t[r*s+
l]],c=X(i[p]??"#6E6E6E"),d=4*((e-1-r)*s+l);a.data.set([...c,255],d)}return K(n).putImageData(a,0,0),n}redraw(){if(!this.films)return;let{colors:t,look:e}=this,{
context:s,width:i,height:n}=_(this.canvas);if(this.box={width:i-tt-si,height:n-P-No},s.clearRect(0,0,i,n),s.save(),s.beginPath(),s.rect(tt,P,this.box.width,this.
box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:r}of this.pictures){let[l,p,c,d]=r,u=[this.x(l),this.y(d),this.x(p)-this.
x(l),this.y(c)-this.y(d)];s.fillStyle=e.panel,s.fillRect(u[0],u[1],u[2],u[3]),s.globalAlpha=.35,s.drawImage(a,u[0],u[1],u[2],u[3]),s.globalAlpha=1}this.hatch(s)}
for(let[a,r]of this.films.entries())this.way(s,r,a);if(s.restore(),this.axes(s,i,n),this.keyed!==e.dark){this.keyed=e.dark;let a=Object.entries(t.mode_names).filter(
([r])=>"RSKH".includes(r));this.keys.replaceChildren(...a.map(([r,l])=>h("span",{class:"plot-key"},je(t.modes[r]),l)))}this.cursor(this.clock.time)}hatch(t){let{
paradox:e}=this.pictures[0],s=e.length;t.strokeStyle=_t(this.look.dark?"#ffffff":"#000000",.28),t.lineWidth=1;for(let i=0;i<s;i++){if(!e[i])continue;let n=i;for(;n<
s&&e[n]===e[i];)n++;let a=this.x(i*2*Math.PI/s),r=this.x(n*2*Math.PI/s);t.save(),t.beginPath(),t.rect(a,P,r-a,this.box.height),t.clip(),t.beginPath();let l=e[i];
for(let p=-this.box.height;p<r-a+this.box.height;p+=7)t.moveTo(a+p,l>0?P+this.box.height:P),t.lineTo(a+p+this.box.height,l>0?P:P+this.box.height);t.stroke(),t.restore(),
i=n}}way(t,e,s){let{angle:i,omega:n,mode:a}=e.columns,r=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=this.look.ink,t.beginPath();let l=null;
for(let p=0;p<e.length;p++){if(!Number.isFinite(n[p])){l=null;continue}let c=Math.floor(i[p]/r),d=i[p]-c*r;if(l===null)t.moveTo(this.x(d),this.y(n[p]));else if(c!==
l.lap){let u=c>l.lap?r:0;t.lineTo(this.x(u),this.y(n[p])),t.moveTo(this.x(r-u),this.y(n[p])),t.lineTo(this.x(d),this.y(n[p]))}else t.lineTo(this.x(d),this.y(n[p]));
l={lap:c,mode:a[p]}}t.stroke(),t.setLineDash([])}axes(t,e,s){let{look:i}=this;t.font=`11px ${i.font}`,t.strokeStyle=i.soft,t.fillStyle=i.soft,t.lineWidth=1,t.strokeRect(
tt+.5,P+.5,this.box.width-1,this.box.height-1),t.textAlign="center";let n=this.range[0]*180/Math.PI,a=this.range[1]*180/Math.PI,r=a-n>200?45:z(a-n,6);for(let p=Math.
ceil(n/r-1e-9);p*r<=a+1e-9;p++){let c=this.x(p*r*Math.PI/180);t.beginPath(),t.moveTo(c,P+this.box.height),t.lineTo(c,P+this.box.height+4),t.stroke(),t.fillText(
B(p*r,r),c,P+this.box.height+15)}t.textAlign="right",t.fillText("angle θ within a turn [°]",e-si,s-3),t.textBaseline="middle";let l=this.top()-this.bottom();for(let p of W(
this.bottom(),this.top(),5))t.fillText(B(p,z(l,5)),tt-6,this.y(p));t.textBaseline="alphabetic",t.save(),t.translate(11,P+.5*this.box.height),t.rotate(-Math.PI/2),
t.textAlign="center",t.fillText("θ̇ [rad/s]",0,0),t.restore()}cursor(t){if(!this.films||!this.box)return;let{context:e,width:s,height:i}=_(this.over);e.clearRect(
0,0,s,i),this.films.forEach((n,a)=>{let r=n.at(t),l=2*Math.PI,p=r.angle-Math.floor(r.angle/l)*l,c=this.x(p),d=this.y(r.omega);c>=tt&&c<=tt+this.box.width&&d>=P&&
d<=P+this.box.height&&(e.beginPath(),e.arc(c,d,a?4:5.5,0,2*Math.PI),e.fillStyle=this.colors.modes[r.mode],e.fill(),e.lineWidth=2,e.strokeStyle=this.look.ink,e.stroke())})}seek(t){
let e=this.body.getBoundingClientRect(),[s,i]=[t.clientX-e.left,t.clientY-e.top];if(this.pinched())return;let n=this.films[this.active],{angle:a,omega:r}=n.columns,
l=2*Math.PI,p={distance:1/0,t:0};for(let c=0;c<n.length;c++){let d=a[c]-Math.floor(a[c]/l)*l,u=Math.hypot(this.x(d)-s,this.y(r[c])-i);u<p.distance&&(p={distance:u,
t:n.t[c]})}p.distance<40&&this.clock.seek(y(p.t,0,n.duration))}};var Ye=o=>Object.entries(R).map(([t,e])=>h("option",{value:t},o(e)));function ii(o){let t="height",e=new mt({key:"own",title:"Your choice",unit:"",curves:n=>[{name:T(
R[t].name),values:R[t].values(n)}]},o),s=()=>{let{symbol:n,unit:a}=R[t];e.unit=a?`${n} [${a}]`:n},i=h("select",{"aria-label":"What your diagram shows",onchange:()=>{
t=i.value,s(),o.changed()}},Ye(Cs));return i.value=t,s(),e.element.querySelector("h3")?.after(i),e}function Fo(o){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:t=>[{name:"v (centre)",color:o.center_speed,values:t.columns.vx},{name:"\
R θ̇",color:o.rotation_speed,dash:"dash",values:t.derived("spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:t=>[{name:"kinetic",color:o.kinetic,values:t.columns.kinetic},{name:"potential",color:o.potential,values:t.columns.potential},{name:"\
total",values:t.derived("total",({t:e,kinetic:s,potential:i})=>Float64Array.from(e,(n,a)=>s[a]+i[a])),dash:"dash"},{name:"lost to friction",color:o.friction_loss,
values:t.columns.friction_loss},{name:t.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:o.impact_loss,values:t.columns.
normal_loss,dash:"dot"}]},{key:"forces",title:"Contact forces",unit:"force [N]",curves:t=>[{name:"normal N",color:o.normal_force,values:t.columns.normal_force},
{name:"friction F",color:o.friction_force,dash:"dash",values:t.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],
curves:t=>[{name:"|F| / μN",color:o.friction_force,values:t.columns.utilization}]}]}var le=class{films;active;look;constructor(t,e){this.colors=e,this.shared={
axis:"time",range:null,clock:t,changed:()=>this.redraw()},this.plots=[...Fo(e).map(i=>new mt(i,this.shared)),ii(this.shared)];for(let i of this.plots)i.onseek=n=>t.
seek(n);this.seen=new Map(this.plots.map(i=>[i.element,!0]));let s=new IntersectionObserver(i=>{for(let{target:n,isIntersecting:a}of i)this.seen.set(n,a);this.redraw()},
{rootMargin:"400px"});for(let i of this.plots)s.observe(i.element);this.axis=h("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.
axis=this.axis.value,this.shared.range=null,this.redraw()}},Ye(({name:i})=>`over ${i}`)),this.back=h("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].
zoomTo(null)},"Whole motion"),this.hint=h("span",{class:"hint"}),this.element=h("div",{class:"plots"},h("div",{class:"plots-head"},this.axis,this.back,this.hint),
this.plots.map(i=>i.element))}draw(t,e,s){this.films=t,this.active=e,this.look=s;let i=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":
"drag to zoom, double-click for all, click to go there";this.hint.textContent=t.length>1?`A full, B dotted; numbers and colours of ${"AB"[e]}; ${i}`:i,this.redraw()}redraw(){
if(this.films?.length){this.back.hidden=!this.shared.range;for(let t of this.visible())t.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.
clock.time)}}visible(){return this.plots.filter(t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())e.cursor(t)}};var Oo=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],ce=class{constructor(t){this.lab=t,this.menu=h("details",{class:"menu"},h("summary",{class:"button"},"Keep"),h("div",{class:"menu-body"},t.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),Oo.map(([e,s])=>this.item(s,()=>this.download(e))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=h("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),t.root.addEventListener("pointerdown",e=>{this.menu.contains(e.target)||(this.menu.open=!1)})}item(t,e){return h("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await e()}catch(s){this.lab.notice.fail(s)}}},t)}async copyLink(){let t=this.lab.motions.link()??"";try{await navigator.clipboard.writeText(
t),this.lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",t)}}async download(t){let e=this.lab.film();this.lab.notice.say(t.endsWith(
"mp4")?"The film is being made; this takes a while …":`Fetching ${t} …`),dt(await this.lab.backend.file(t,e.query),`hophoop-${t}`),this.lab.notice.say(`${t}\
 is there.`)}picture(){this.lab.drawStage();let t=this.lab.stage.canvas(),e=h("canvas",{width:t.width,height:t.height});return this.copyInto(e),new Promise(s=>{
e.toBlob(i=>{i&&dt(i,"hophoop.png"),s()},"image/png")})}copyInto(t){let{lab:e}=this,s=e.stage.canvas(),i=K(t);i.fillStyle=e.theme.look.paper,i.fillRect(0,0,t.width,
t.height),i.drawImage(s,0,0,t.width,t.height);let n=t.width/Math.max(s.getBoundingClientRect().width,1);i.textBaseline="top",i.textAlign="left";let a=e.films();
for(let[r,l]of a.entries()){let p=l.at(e.clock.time),c=[a.length>1?`${"AB"[r]}: `:"",`${e.theme.colors.mode_names[p.mode]}, t = ${p.t.toFixed(3)} s, θ = ${$(p.
angle)}, v = ${x(p.vx,3)} m/s`].join(""),d=e.stage.options.three?10+20*r:10+r*s.getBoundingClientRect().height/a.length;i.fillStyle=e.theme.colors.modes[p.mode],
i.fillRect(12*n,(d+2)*n,11*n,11*n),i.fillStyle=e.theme.look.ink,i.font=`${13*n}px ${e.theme.look.font}`,i.fillText(c,30*n,d*n)}}async record(){let{lab:t}=this,e=t.
stage.canvas();if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 instead.");let s=h("canvas",{width:2*
Math.ceil(e.width/2),height:2*Math.ceil(e.height/2)}),i=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),n=[];i.ondataavailable=l=>n.push(l.data);
let a=new Promise(l=>i.onstop=l),r=t.clock.loop;t.clock.loop=!1,t.clock.seek(0),t.notice.say("Recording one run …"),t.afterFrame=()=>{this.copyInto(s),!t.clock.
playing&&i.state==="recording"&&i.stop()},i.start(),t.clock.play(!0),await a,t.afterFrame=null,t.clock.loop=r,dt(new Blob(n,{type:i.mimeType}),"hophoop.webm"),t.
notice.say("The film is there.")}async code(){let{header:t}=await this.lab.backend.call("code",{scenario:this.lab.film().scenario});this.show("The same motion i\
n Python",t.python,"The scenario as a file",t.toml)}show(...t){let e=[];for(let s=0;s<t.length;s+=2){let i=t[s+1],n=h("button",{type:"button"},"Copy");n.onclick=
async()=>{await navigator.clipboard?.writeText(i).catch(()=>{}),n.textContent="Copied"},e.push(h("header",{},h("h2",{},t[s]),n),h("pre",{tabindex:"0"},h("code",
{},i)))}this.dialog.replaceChildren(...e,h("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};var oi=120,pe=class{constructor(t,e){this.canvas=t,this.onview=e,this.zoom=1,this.shift=[0,0],this.views=[],this.fixed=null,t.addEventListener("pointerdown",s=>this.
drag(s)),this.pinched=Z(t,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>t.parentElement})}reset(){this.zoom=1,this.shift=[0,0],this.onview()}zoomBy(t){
this.zoom=y(this.zoom*t,.05,60),this.onview()}drag(t){let e=[t.clientX,t.clientY],s=this.shift;I(this.canvas,t,i=>{this.pinched()||(this.shift=[s[0]+i.clientX-e[0],
s[1]+i.clientY-e[1]],this.onview())})}draw(t,e,s,i,n){let{context:a,width:r,height:l}=_(this.canvas);if(a.clearRect(0,0,r,l),r<40||l<40)return;let p=l/t.length,
c={top:Math.max(...t.map(d=>d.extent.top)),radius:Math.max(...t.map(d=>d.radius)),speed:Math.max(...t.map(d=>d.extent.speed))};t.forEach((d,u)=>{a.save(),a.beginPath(),
a.rect(0,u*p,r,p),a.clip(),a.translate(0,u*p);let f=new Xe(a,r,p,d,e,s,i,n,this.zoom,this.shift,c);f.top=u*p,f.scale=this.fixed??f.scale,f.draw(),this.views[u]=
f,t.length>1&&(a.fillStyle=i.soft,a.font=`600 15px ${i.font}`,a.textAlign="left",a.fillText("AB"[u],12,p-12)),a.restore(),u>0&&(a.fillStyle=i.line,a.fillRect(0,
u*p-.5,r,1))})}},Xe=class{top=0;constructor(t,e,s,i,n,a,r,l,p,c,d){this.context=t,this.width=e,this.height=s,this.film=i,this.options=a,this.look=r,this.colors=
l,this.common=d,this.pose=i.at(n);let u=i.radius,{left:f,right:g}=i.extent,{top:b}=d;this.cosine=Math.cos(i.slope),this.sine=Math.sin(i.slope);let w=2*d.radius+
Math.min(b,6*d.radius),m=Math.min(.66*s/w,.36*e/d.radius);if(a.whole){let v=(g-f)*this.cosine+2.6*u,k=(g-f)*Math.abs(this.sine)+2.6*u+b;this.scale=Math.min(e/v,
.86*s/k,m)*p,this.focus=[.5*(f+g),0],this.place=[.5*e+c[0],(i.slope?.62:.8)*s+c[1]]}else this.scale=m*p,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],
this.place=[(e<520?.6:.46)*e+c[0],.82*s+c[1]]}point(t,e){let s=t-this.focus[0],i=e-this.focus[1];return[this.place[0]+this.scale*(s*this.cosine+i*this.sine),this.
place[1]-this.scale*(i*this.cosine-s*this.sine)]}unpoint(t,e){let s=(t-this.place[0])/this.scale,i=-(e-this.place[1])/this.scale;return[this.focus[0]+s*this.cosine-
i*this.sine,this.focus[1]+s*this.sine+i*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&
this.forces()}ground(){let{context:t,look:e,width:s,height:i}=this,n=(Math.hypot(s,i)*1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[a,r]=this.
point(this.focus[0]-n,0),[l,p]=this.point(this.focus[0]+n,0),c=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,t.beginPath(),t.moveTo(a,r),t.lineTo(l,p),t.
lineTo(l+c[0],p+c[1]),t.lineTo(a+c[0],r+c[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(a,r),t.lineTo(l,p),t.stroke();let d=z(s/this.
scale,s/90);t.fillStyle=e.soft,t.font=`11px ${e.font}`,t.textAlign="center",t.lineWidth=1;let u=Math.ceil((this.focus[0]-n)/d),f=Math.min(Math.floor((this.focus[0]+
n)/d),u+400);for(let g=u;g<=f;g++){let[b,w]=this.point(g*d,0);b<-40||b>s+40||(t.beginPath(),t.moveTo(b,w),t.lineTo(b-6*this.sine,w+6*this.cosine),t.stroke(),t.fillText(
`${B(g*d,d)} m`,b-18*this.sine,w+8+10*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:i}=this,n=this.options.ahead?t.length-1:t.index(this.pose.t),a=t.
radius,{x:r,height:l,angle:p,mode:c}=t.columns,d=(u,f,g,b)=>{e.strokeStyle=f,e.lineWidth=g,e.lineJoin="round",e.beginPath();let w=!1,m=(v,k,M)=>{let[A,E]=this.point(
v+u*Math.sin(M),a+k+u*Math.cos(M));w?e.lineTo(A,E):e.moveTo(A,E),w=!0};for(let v=0;v<=n;v++)b===void 0||c[v]===3===b?m(r[v],l[v],p[v]):w=!1;!this.options.ahead&&
(b===void 0||this.pose.mode==="H"===b)&&m(this.pose.x,this.pose.height,this.pose.angle),e.stroke()};e.globalAlpha=this.options.ahead?.45:1,d(a,s.ink,1.3),d(t.eccentricity*
a,i.gravity_center,1.8,!1),d(t.eccentricity*a,i.airborne,2.4,!0),e.globalAlpha=1}hoop(){let{film:t,pose:e,context:s,look:i,colors:n,scale:a}=this,r=t.radius,l=y(
.07*r*a,2,14),p=r-.5*l/a,c=[e.x,r+e.height],d=(w,m=p)=>this.point(c[0]+m*Math.sin(w),c[1]+m*Math.cos(w));if(s.lineCap="butt",i.dark&&(s.strokeStyle=i.soft,s.lineWidth=
l+2,s.beginPath(),s.arc(...this.point(c[0],c[1]),p*a,0,2*Math.PI),s.stroke()),this.options.speed){let w=this.common.speed;s.lineWidth=l;let m=2*Math.PI/oi;for(let v=0;v<
oi;v++){let k=e.angle+v*m,M=Math.hypot(e.vx+r*e.omega*Math.cos(k+.5*m),e.vy-r*e.omega*Math.sin(k+.5*m));s.strokeStyle=ie[y(Math.round(255*M/w)||0,0,255)],s.beginPath(),
s.moveTo(...d(k-.04*m)),s.lineTo(...d(k+1.04*m)),s.stroke()}}else s.strokeStyle=n.modes[e.mode],s.lineWidth=l,s.beginPath(),s.arc(...this.point(c[0],c[1]),p*a,0,
2*Math.PI),s.stroke();s.strokeStyle=i.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(c[0],c[1])),s.lineTo(...d(e.angle)),s.stroke();let u=(w,m,v,k)=>{s.
beginPath(),s.arc(...w,m,0,2*Math.PI),s.fillStyle=v,s.fill(),s.lineWidth=1.5,s.strokeStyle=k,s.stroke()};u(this.point(c[0],c[1]),2.5,i.soft,i.soft);let f=t.scenario.
hoop.parts;f?this.parts(f,c):u(d(e.angle),y(.1*r*a,4,16),i.ink,i.paper);let g=t.eccentricity*r,b=this.point(c[0]+g*Math.sin(e.angle),c[1]+g*Math.cos(e.angle));u(
b,y(.05*r*a,3.5,7),e.mode==="H"?n.airborne:n.gravity_center,i.paper)}parts(t,e){let{film:s,pose:i,context:n,look:a,scale:r}=this,p=t.reduce((c,d)=>c+d.mass*(d.at??
0),0)<0?-1:1;n.strokeStyle=a.ink;for(let c of t){let d=p*(c.at??0),u=this.point(e[0]+d*Math.sin(i.angle),e[1]+d*Math.cos(i.angle));if(n.fillStyle=a.ink,n.lineWidth=
1,n.beginPath(),c.shape==="ring")n.globalAlpha=.22,n.arc(...u,c.outer_radius*r,0,2*Math.PI),n.arc(...u,c.inner_radius*r,0,2*Math.PI,!0),n.fill(),n.globalAlpha=1;else if(c.
shape==="rod"){let f=.5*c.length,g=b=>this.point(e[0]+b*Math.sin(i.angle),e[1]+b*Math.cos(i.angle));n.lineWidth=4,n.moveTo(...g(d-f)),n.lineTo(...g(d+f)),n.stroke()}else{
let f=c.shape==="disk"?c.radius*r:y(.08*s.radius*r,3,12);n.globalAlpha=c.shape==="disk"?.55:1,n.arc(...u,f,0,2*Math.PI),n.fill(),n.globalAlpha=1}}}forces(){let{
film:t,pose:e,colors:s}=this,i=t.radius,n=t.mass*(t.gravity||9.81),a=l=>.55*i*l/n;if(e.mode==="H"||!(e.normal_force>0))return;let r=[e.x,e.height];this.arrow(r,
[0,a(e.normal_force)],s.normal_force,`N = ${x(e.normal_force,3)} N`,!1),this.arrow(r,[a(e.friction_force),0],s.friction_force,`F = ${x(e.friction_force,3)} N`,!0)}arrow([
t,e],[s,i],n,a,r){let{context:l,look:p,width:c}=this,d=2.2*this.film.radius,u=Math.abs(s)>d||Math.abs(i)>d;[s,i]=[y(s,-d,d),y(i,-d,d)];let f=this.point(t,e),g=this.
point(t+s,e+i),b=Math.hypot(g[0]-f[0],g[1]-f[1]);if(b<2)return;let w=(g[0]-f[0])/b,m=(g[1]-f[1])/b,v=Math.min(11,b);for(let[A,E]of[[p.paper,6],[n,3]])l.strokeStyle=
A,l.fillStyle=A,l.lineWidth=E,l.beginPath(),l.moveTo(...f),l.lineTo(g[0]-w*v,g[1]-m*v),l.stroke();if(l.beginPath(),l.moveTo(...g),l.lineTo(g[0]-w*v-m*v*.5,g[1]-
m*v+w*v*.5),l.lineTo(g[0]-w*v+m*v*.5,g[1]-m*v-w*v*.5),l.fill(),u){let[A,E]=[f[0]+.55*w*b,f[1]+.55*m*b];l.strokeStyle=p.paper,l.lineWidth=2,l.beginPath();for(let S of[
-3,3])l.moveTo(A+w*(S-3)-m*7,E+m*(S-3)+w*7),l.lineTo(A+w*(S+3)+m*7,E+m*(S+3)-w*7);l.stroke()}l.font=`600 12px ${p.font}`;let k=l.measureText(a).width;l.lineWidth=
3,l.strokeStyle=r?p.ground:p.paper,l.textAlign="left";let M=r?[f[0]-.5*k-32*this.sine,f[1]+32*this.cosine]:[g[0]+12,y(g[1]+4,16,f[1]-.36*this.film.radius*this.scale)];
M[0]=y(M[0],4,c-k-4),l.strokeText(a,M[0],M[1]),l.fillText(a,M[0],M[1])}};function Ke(o,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let i=0;i<4;i++){let n=0;for(let a=0;a<4;a++)n+=o[4*a+i]*t[4*s+a];e[4*s+i]=n}return e}function ni(o,t,e,s){
let i=1/Math.tan(o/2),n=1/(e-s);return new Float32Array([i/t,0,0,0,0,i,0,0,0,0,(s+e)*n,-1,0,0,2*s*e*n,0])}function ai(o,t){let e=nt(Ve(o,t)),s=nt(de([0,1,0],e)),
i=de(e,s);return new Float32Array([s[0],i[0],e[0],0,s[1],i[1],e[1],0,s[2],i[2],e[2],0,-Ge(s,o),-Ge(i,o),-Ge(e,o),1])}var Ve=(o,t)=>[o[0]-t[0],o[1]-t[1],o[2]-t[2]],
Ge=(o,t)=>o[0]*t[0]+o[1]*t[1]+o[2]*t[2],de=(o,t)=>[o[1]*t[2]-o[2]*t[1],o[2]*t[0]-o[0]*t[2],o[0]*t[1]-o[1]*t[0]];function nt(o){let t=Math.hypot(...o)||1;return[
o[0]/t,o[1]/t,o[2]/t]}function ue(o,t,e,s){let i=nt(t),n=nt(de(i,Math.abs(i[2])>.9?[1,0,0]:[0,0,1])),a=de(n,i);return new Float32Array([...n.map(r=>r*s),0,...i.
map(r=>r*e),0,...a.map(r=>r*s),0,...o,1])}function Je(o){let[t,e]=[Math.cos(o),Math.sin(o)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function q(o){let t=Number.parseInt(o.slice(1,7),16);
return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function ft(o,t,e){let s=o.createProgram(),i=[[o.VERTEX_SHADER,t],[o.FRAGMENT_SHADER,e]];for(let[a,r]of i){let l=o.createShader(a);if(o.shaderSource(l,r),o.compileShader(
l),!o.getShaderParameter(l,o.COMPILE_STATUS))throw new Error(String(o.getShaderInfoLog(l)));o.attachShader(s,l)}if(o.linkProgram(s),!o.getProgramParameter(s,o.LINK_STATUS))
throw new Error(String(o.getProgramInfoLog(s)));let n={program:s,uniforms:{},attributes:{}};for(let a=0;a<o.getProgramParameter(s,o.ACTIVE_UNIFORMS);a++){let{name:r}=o.
getActiveUniform(s,a);n.uniforms[r]=o.getUniformLocation(s,r)}for(let a=0;a<o.getProgramParameter(s,o.ACTIVE_ATTRIBUTES);a++){let{name:r}=o.getActiveAttrib(s,a);
n.attributes[r]=o.getAttribLocation(s,r)}return n}function at(o,t,e,s){let i=o.createBuffer();o.bindBuffer(o.ARRAY_BUFFER,i),o.bufferData(o.ARRAY_BUFFER,new Float32Array(
t),o.STATIC_DRAW);let n=s?o.createBuffer():null;s&&(o.bindBuffer(o.ELEMENT_ARRAY_BUFFER,n),o.bufferData(o.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),o.STATIC_DRAW));
let a=4*Object.values(e).reduce((r,l)=>r+l,0);return{vertices:i,elements:n,parts:e,stride:a,count:s?s.length:4*t.length/a}}function gt(o,t,e){o.bindBuffer(o.ARRAY_BUFFER,
e.vertices);let s=0;for(let[i,n]of Object.entries(e.parts)){let a=t.attributes[i];a!==void 0&&(o.enableVertexAttribArray(a),o.vertexAttribPointer(a,n,o.FLOAT,!1,
e.stride,s)),s+=4*n}e.elements&&o.bindBuffer(o.ELEMENT_ARRAY_BUFFER,e.elements)}function Qe(o,t){let e=[];for(let s=0;s<o;s++)for(let i=0;i<t;i++){let n=s*(t+1)+
i,a=n+t+1;e.push(n,a,n+1,a,a+1,n+1)}return e}function ri(o,t=120,e=14){let s=[];for(let i=0;i<=t;i++)for(let n=0;n<=e;n++)s.push(2*Math.PI*i/t,2*Math.PI*n/e);return at(
o,s,{bend:2},Qe(t,e))}function hi(o,t=28,e=18){let s=[];for(let i=0;i<=t;i++)for(let n=0;n<=e;n++){let[a,r]=[2*Math.PI*i/t,Math.PI*n/e],l=[Math.sin(r)*Math.cos(
a),Math.cos(r),Math.sin(r)*Math.sin(a)];s.push(...l,...l)}return at(o,s,{position:3,normal:3},Qe(t,e))}function Ze(o,t,e=20){let s=[];for(let i=0;i<=e;i++){let n=2*
Math.PI*i/e,a=[Math.cos(n),1-t,Math.sin(n)];s.push(Math.cos(n),0,Math.sin(n),...a,t*Math.cos(n),1,t*Math.sin(n),...a)}return at(o,s,{position:3,normal:3},Qe(e,1))}var di=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,ui=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,mi="vec4(0.0, 0.0, 0.0, shadow)",li=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${ui}
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
   ${di}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${mi} : vec4(shaded(color, n), 1.0);
   }`],ci=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${ui}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${di}
   void main() { gl_FragColor = shadow > 0.0 ? ${mi} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],pi=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],me=class{constructor(t,e,s,i,{keep:n=!1}={}){let a=t.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:n});if(!a)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=a,this.canvas=
t,this.sun=nt(s),this.dark=i,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=ft(a,li[0],li[1]),this.body=ft(a,ci[0],ci[1]),this.line=ft(a,pi[0],pi[1]),this.torus=ri(
a),this.sphere=hi(a),this.cylinder=Ze(a,1),this.cone=Ze(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.colors);let r=new Uint8Array(e.flatMap(
l=>[...l,255]));a.pixelStorei(a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,e.length,1,0,a.RGBA,a.UNSIGNED_BYTE,r);for(let l of[a.TEXTURE_WRAP_S,a.TEXTURE_WRAP_T])
a.texParameteri(a.TEXTURE_2D,l,a.CLAMP_TO_EDGE);for(let l of[a.TEXTURE_MIN_FILTER,a.TEXTURE_MAG_FILTER])a.texParameteri(a.TEXTURE_2D,l,a.LINEAR);this.view=Je(0),
this.eye=[0,0,1],this.fastest=1}begin({background:t,eye:e,target:s,slope:i,angle:n,near:a,far:r}){let{gl:l,canvas:p}=this;l.viewport(0,0,p.width,p.height),l.clearColor(
t[0],t[1],t[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let c=ni(n,p.width/p.height,a,r);this.view=Ke(Ke(c,
ai(e,s)),Je(i)),this.eye=nt(Ve(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let i={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[
n,a]of Object.entries(i)){let r=t.uniforms[n];r!==void 0&&(typeof a=="number"?s.uniform1f(r,a):a.length===16?s.uniformMatrix4fv(r,!1,a):s[`uniform${a.length}fv`](
r,a))}}ground(t){let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,
e.ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),
e.depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:i=!1,lit:n=!0}={}){let{gl:a}=this;this.use(this.body,{model:e,color:s,shadow:i?
this.dark:0,lit:Number(n)}),gt(a,this.body,t),a.drawElements(a.TRIANGLES,t.count,a.UNSIGNED_SHORT,0)}ball(t,e,s,i){this.solid(this.sphere,ue(t,[0,1,0],e,e),s,{shadow:i})}ring({
center:t,radius:e,tube:s,broad:i,angle:n,velocity:a,omega:r,plain:l=null},p){let{gl:c}=this;this.use(this.rim,{center:t,size:[e,s,i,n],motion:[...a,r],most:this.
fastest,shadow:p?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),gt(c,this.rim,this.torus),c.drawElements(c.TRIANGLES,this.torus.count,c.UNSIGNED_SHORT,0)}rod(t,e,s,i,n,a=!1){
this.solid(this.cylinder,ue(t,e,s,i),n,{shadow:a})}arrow(t,e,s,i,n){if(!(s>.02*i))return;let a=Math.min(.18*i,s),r=t.map((l,p)=>l+e[p]*(s-a));s>a&&this.rod(t,e,
s-a,.029*i,n),this.solid(this.cone,ue(r,e,a,Math.min(.075*i,.6*a)),n)}trace(t,e,s){let i=[];for(let n=0;n<t;n++){let a=e(n),r=e(Math.min(n+1,t-1));if(Math.hypot(
r[0]-a[0],r[1]-a[1])<1e-9&&n>0){let l=e(n-1);r=a.map((p,c)=>2*p-l[c])}for(let l of[-1,1])i.push(...a,0,...r,0,...s(n),l)}return at(this.gl,i,{position:3,next:3,
tint:3,side:1})}drawTrace(t,e,{width:s,distance:i=0,shift:n,depth:a}){let{gl:r,canvas:l}=this;this.use(this.line,{pixel:[2/l.width,2/l.height],width:s,distance:i,
shift:n,depth:a}),gt(r,this.line,t),r.drawArrays(r.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let i=this.view,[n,a,r]=[0,1,3].map(l=>i[l]*t+i[4+l]*e+i[8+l]*s+i[12+
l]);return r>0?[(.5+.5*n/r)*this.canvas.width,(.5-.5*a/r)*this.canvas.height]:null}};var Bo=[.35,.85,.4],Do=.18,fi={azimuth:.5,height:.22,distance:5.2},gi=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],fe=class{constructor(t,e){this.canvas=t,this.onview=e,this.space=new me(t,ut,Bo,Do,{keep:!0}),this.floor=ft(this.space.gl,gi[0],gi[1]),this.corners=at(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...fi},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,t.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=Z(t,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>t.parentElement})}zoomBy(t){t?this.turned.distance=y(
this.turned.distance/t,1.6,60):this.turned={...fi},this.onview()}drag(t){let e={...this.turned,x:t.clientX,y:t.clientY};I(this.canvas,t,s=>{this.pinched()||(this.
turned.azimuth=y(e.azimuth-(s.clientX-e.x)*.008,-1.5,1.5),this.turned.height=y(e.height+(s.clientY-e.y)*.006,.02,1.45),this.onview())})}quality(){let t=performance.
now(),e=t-(this.before||t);return this.before=t,e>0&&e<200&&(this.pace=.9*this.pace+.1*e),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(t,e,s,i,n,a){let{canvas:r,space:l}=this,p=Math.min(globalThis.devicePixelRatio||1,2)*(a?this.quality():1),c=r.getBoundingClientRect();r.
width=Math.max(Math.round(c.width*p),1),r.height=Math.max(Math.round(c.height*p),1);let d=t.map(g=>g.at(e)),u=t[0].radius;l.fastest=Math.max(...t.map(g=>g.extent.
speed)),this.focus=Number.isFinite(d[0].x)?d[0].x:0,l.begin({background:q(i.paper),...this.camera(t[0],d[0],u,s)}),l.ground(()=>this.drawFloor(u,i));let f=g=>{for(let[
b,w]of t.entries())g(w,d[b],-2.1*u*b)};l.shadows(()=>f((g,b,w)=>this.drawHoop(g,b,w,s,i,n,!0))),f((g,b,w)=>{this.drawHoop(g,b,w,s,i,n,!1),s.traces&&this.drawTraces(
g,b,w,i,n,p),s.forces&&this.drawForces(g,b,w,n)})}camera(t,e,s,i){let{azimuth:n,height:a,distance:r}=this.turned,{left:l,right:p}=t.extent,c=i.whole?Math.max(r*
s,.85*(p-l)+3*s):r*s,[d,u]=[i.whole?.5*(l+p)-this.focus:0,s+.45*(e.height||0)],f=Math.cos(t.slope),g=Math.sin(t.slope),b=[d*f+u*g,-d*g+u*f,0],w=[b[0]+c*Math.sin(
n)*Math.cos(a),b[1]+c*Math.sin(a),c*Math.cos(n)*Math.cos(a)];return this.reach=12*s+3*c,{eye:w,target:b,slope:t.slope,angle:.75,near:.05*s,far:40*s+6*c}}drawFloor(t,e){
let{space:s}=this,i=q(e.ground),n=i.map(l=>l*(e.dark?.82:.94)),a=.5*t,r=this.focus%(2*a);s.use(this.floor,{reach:this.reach,light:i,dark:n,far:q(e.paper),tile:a,
shift:r}),gt(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(t,e,s,i,n,a,r){let{space:l}=this,p=t.radius,c=.045*p,d=[e.x-this.focus,
p+e.height,s];l.ring({center:d,radius:p,tube:c,broad:3.2*c,angle:e.angle,velocity:[e.vx,e.vy],omega:e.omega,plain:i.speed?null:q(a.modes[e.mode])},r);let u=[Math.
sin(e.angle),Math.cos(e.angle),0],f=b=>d.map((w,m)=>w+b*u[m]);l.ball(f(p-c),.125*p,n.dark?[.9,.91,.94]:[.12,.13,.15],r),l.rod(d,u,p-c,.012*p,[.55,.57,.6],r);let g=e.
mode==="H";l.ball(f(t.eccentricity*p),.07*p,q(g?a.airborne:a.gravity_center),r)}drawForces(t,e,s,i){if(e.mode==="H"||!(e.normal_force>0))return;let n=t.radius,a=t.
mass*(t.gravity||9.81),r=[e.x-this.focus,e.height+.03*n,s+.2*n],l=c=>y(.55*n*Math.abs(c)/a,0,3.2*n),p=Math.sign(e.friction_force);this.space.arrow(r,[0,1,0],l(e.
normal_force),n,q(i.normal_force)),this.space.arrow(r,[p,0,0],l(e.friction_force),n,q(i.friction_force))}linesOf(t,e,s){let i=this.lines.get(t);if(i?.dark===e.dark)
return i;let n=t.radius,{x:a,height:r,angle:l,mode:p}=t.columns,c=(b,w)=>this.space.trace(t.length,m=>[a[m]+b*Math.sin(l[m]),n+r[m]+b*Math.cos(l[m])],w),[d,u,f]=[
q(s.gravity_center),q(s.airborne),q(e.ink)],g={dark:e.dark,load:c(n,()=>f),center:c(t.eccentricity*n,b=>p[b]===3?u:d)};return this.lines.set(t,g),g}drawTraces(t,e,s,i,n,a){
let{load:r,center:l}=this.linesOf(t,i,n),p=Math.min(t.index(e.t)+2,t.length),c={shift:this.focus,depth:s};this.space.drawTrace(r,p,{width:a,...c}),this.space.drawTrace(
l,p,{width:1.6*a,...c})}};var Wo=["hoop","mode","time","angle","v","R θ̇","gap"],ge=class{constructor(t,e){this.colors=t,this.onview=e,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1},this.plane=h("canvas",{class:"stage-canvas"}),this.space=h("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new pe(this.plane,e),this.deep=
null,this.outputs=Wo.map(i=>({name:h("dt",{},i),value:h("dd",{})})),this.outputs[1].value.className="mode",this.fastest=h("span",{}),this.legend=h("div",{class:"\
legend","aria-hidden":"true"},h("i",{style:`background: linear-gradient(90deg, ${ie.filter((i,n)=>n%15===0).join(",")})`}),h("span",{},"0"),h("span",{},"rim spe\
ed"),this.fastest);let s=(i,n)=>h("span",{},h("i",{class:"dot",style:`background:${i}`}),n);this.order=h("span",{hidden:!0},"A in front, B behind"),this.element=
h("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,h("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(
({name:i,value:n})=>[i,n])),this.legend,h("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(t.gravity_center,"centre of gravity"),s(t.airborne,
"airborne"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(t,e,s,{look:i,inks:n}){let{options:a}=this;this.legend.hidden=!a.speed,this.
order.hidden=!(a.three&&t.length>1),this.fastest.textContent=`≥ ${x(Math.max(...t.map(r=>r.extent.speed)),2)} m/s`,a.three?(this.deep??=new fe(this.space,this.
onview),this.deep.draw(t,s.time,a,i,n,s.playing)):this.flat.draw(t,s.time,a,i,n),this.read(t,e,s.time)}read(t,e,s){let i=t[e],n=i.at(s),a=[t.length>1?"AB"[e]:"",
this.colors.mode_names[n.mode],`${n.t.toFixed(3)} s`,$(n.angle),O(x(n.vx,3),"m/s"),O(x(n.omega*i.radius,3),"m/s"),n.height>0?G(n.height):"0"];for(let[p,c]of a.entries()){
let{value:d}=this.outputs[p];d.textContent!==c&&(d.textContent=c)}let[r,l]=this.outputs;r.value.hidden=r.name.hidden=t.length<2,l.value.style.setProperty("--mod\
e",this.colors.modes[n.mode])}describe(t){this.element.setAttribute("aria-label",`The hoop. ${t.map(e=>e.summary).join(" ")}`)}turn(t){let e=()=>{this.plane.hidden=
this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,e();try{t()}catch(s){throw this.options.three=!1,e(),s}}zoom(t){
this.options.three?this.deep?.zoomBy(t):t?this.flat.zoomBy(t):this.flat.reset()}};var we=class{film;items;current;constructor(t){this.clock=t,this.summary=h("p",{class:"summary"}),this.list=h("ol",{class:"story-list"}),this.heading=h("h2",{},
"What happens"),this.live=h("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=h("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(t,e,s){this.film=t[e],this.heading.textContent=t.length>1?`What happens to hoop ${"AB"[e]}`:"What happens",this.
summary.replaceChildren(...t.flatMap((i,n)=>[t.length>1?h("b",{},`${"AB"[n]}: `):"",i.summary,i.status==="event_limit"||i.shortened?" (not all events are shown)":
"",n+1<t.length?h("br"):""])),this.items=this.film.story.map(i=>h("li",{},h("button",{type:"button",onclick:()=>this.clock.seek(i.t)},h("i",{class:"dot",style:`\
background:${s.modes[i.mode]}`,"aria-hidden":"true"}),h("span",{class:"when"},`${x(i.t,4)} s`),h("span",{},i.text)))),this.list.replaceChildren(...this.items),this.
current=-1,this.cursor(this.clock.time)}announce(t){this.live.textContent=t.map(e=>e.summary).join(" ")}cursor(t){let{story:e}=this.film,s=-1;for(let n=0;n<e.length&&
e[n].t<=t+1e-9;n++)s=n;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),this.items[this.current]?.
removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let i=this.items[s];if(i){let n=i.offsetTop-this.list.offsetTop;
(n<this.list.scrollTop||n+i.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=n-.4*this.list.clientHeight)}}},be=class{constructor(){
this.list=h("dl",{}),this.heading=h("h2",{},"What theory says"),this.element=h("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){this.heading.textContent=
e?`What theory says of hoop ${e}`:"What theory says",this.list.replaceChildren(...t.flatMap(({label:s,text:i})=>[h("dt",{},s),h("dd",{},i)]))}};var wi="hophoop-theme",qo=["gravity_center","airborne","normal_force","friction_force"],ye=class{constructor(t,e,s,i){this.root=t,this.colors=e,this.hosted=s,this.
changed=i,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=Pe(t),this.inks={...e},this.read()}mark(){let t=this.hosted?Ho(wi):null;this.root.dataset.theme=this.chosen??t??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=Pe(this.root),this.inks={...this.colors};for(let t of qo)
this.inks[t]=se(this.colors[t],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&Uo(wi,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};function Ho(o){try{return localStorage.getItem(o)}catch{
return null}}function Uo(o,t){try{localStorage.setItem(o,t)}catch{}}var jo={takeoff:"▲",impact:"▼",apex:"•",jam:"✖",kane_gain:"✚",bounce_limit:"≋",turn:"↺",rest:"■",painleve_inconsistent:"◆",painleve_indeterminate:"\
◇",skim:"◗"},Yo={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns b\
ack",apex:"highest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"j\
am",kane_gain:"energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},ve=class{films;constructor(t){this.clock=t,this.canvas=h("canvas",{class:"ti\
meline-canvas"}),this.tip=h("div",{class:"tip",hidden:!0}),this.element=h("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"\
0","aria-orientation":"horizontal"},this.canvas,this.tip),this.element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermo\
ve",e=>this.hover(e)),this.element.addEventListener("pointerleave",()=>this.tip.hidden=!0)}timeAt(t){let e=this.canvas.getBoundingClientRect();return y((t.clientX-
e.left)/e.width,0,1)*this.clock.duration}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});let e=this.clock.playing;this.clock.playing=!1;let s=i=>this.
clock.seek(this.timeAt(i));s(t),I(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){let e=this.timeAt(t),s=this.nearest(e,8),i=s?`${Yo[s.kind]??s.kind} · ${x(
s.t,5)} s · ${x(s.angle*180/Math.PI,4)}°`:`${x(e,4)} s`;this.tip.textContent=i,this.tip.hidden=!1;let n=this.canvas.getBoundingClientRect();this.tip.style.left=
`${y(t.clientX-n.left,70,n.width-70)}px`}nearest(t,e){let s=e*this.clock.duration/(this.canvas.getBoundingClientRect().width||1),i=null;for(let n of this.films??
[])for(let a of n.events){if(a.kind==="end")continue;let r=Math.abs(a.t-t);r<=s&&(!i||r<Math.abs(i.t-t))&&(i=a)}return i}draw(t,e,s){this.films=t;let{context:i,
width:n,height:a}=_(this.canvas),r=this.clock.duration||1,l=g=>g/r*n;i.clearRect(0,0,n,a);let p=15,c=(a-15)/t.length-p;t.forEach((g,b)=>{let w=p+b*(p+c);for(let m of g.
phases){let v=l(m.from),k=Math.max(l(m.to)-v,.6),M=s.modes[m.mode];i.fillStyle=M,i.fillRect(v,w,k,c-2),this.named(i,s.mode_names[m.mode],v,k,w,c-2,M,e)}g.duration<
r&&(i.fillStyle=e.line,i.fillRect(l(g.duration),w,n,c-2)),this.marks(i,g,l,w,n,e),t.length>1&&(i.fillStyle=e.soft,i.font=`600 11px ${e.font}`,i.textAlign="left",
i.fillText("AB"[b],1,w-4))});let d=z(r,n/60);i.fillStyle=e.soft,i.font=`10.5px ${e.font}`;for(let g of W(0,r,n/60))i.textAlign=g===0?"left":l(g)>n-14?"right":"c\
enter",i.fillText(B(g,d)+(g===0?" s":""),l(g),a-3);let u=y(l(this.clock.time),6,n-6),f=y(l(this.clock.time),1,n-1);i.fillStyle=e.ink,i.fillRect(f-1,p-4,2,a-p-9),
i.beginPath(),i.moveTo(u-6,p-10),i.lineTo(u+6,p-10),i.lineTo(f,p-1),i.fill(),this.element.setAttribute("aria-valuemax",r.toFixed(3)),this.element.setAttribute("\
aria-valuenow",this.clock.time.toFixed(3)),this.element.setAttribute("aria-valuetext",`${x(this.clock.time,4)} seconds`)}named(t,e,s,i,n,a,r,l){t.font=`11px ${l.
font}`,!(a<13||t.measureText(e).width+8>i)&&(t.fillStyle=Ks(r),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*i,n+.5*a+1),t.textBaseline="alphab\
etic")}marks(t,e,s,i,n,a){t.font=`11px ${a.font}`,t.textAlign="center";let r=-1/0;for(let l of e.events){let p=jo[l.kind],c=s(l.t);l.kind!=="start"&&l.kind!=="e\
nd"&&(t.fillStyle=a.panel,t.fillRect(c-.5,i,1,5)),!(!p||c-r<8)&&(r=c,t.fillStyle=a.ink,t.fillText(p,y(c,6,n-6),i-4))}}};var Xo=1/60,Go=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],Ko={three:"In space"},et=(o,t,e)=>h(
"button",{type:"button",title:t,"aria-label":t,onclick:e},o),bi=(o,t)=>h("span",{},h("span",{"aria-hidden":"true"},`${o} `),t),xe=class{constructor(t,e,s,i){this.
clock=t,this.films=e,this.say=i,this.playButton=et(L("play"),"Play (space)",()=>t.play()),this.playButton.classList.add("play"),this.speeds=h("select",{"aria-la\
bel":"Speed of the film",onchange:()=>{t.speed=Number(this.speeds.value)}},bt.map(n=>h("option",{value:String(n)},`${n}×`))),this.speeds.value="1",this.switches=
new Map(Go.map(([n,a,r])=>{let l=`${n==="three"?Ko.three:a} (${r})`;return[n,h("button",{type:"button",class:"switch",title:l,onclick:()=>s(n)},a)]})),this.element=
h("div",{class:"transport"},h("div",{class:"buttons"},et(L("start"),"To the start (Home)",()=>t.seek(0)),et(L("previous"),"Previous event (Shift ←)",()=>this.
jump(-1)),et(L("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,et(L("on"),"One frame on (→)",()=>this.nudge(1)),et(L("next"),"Next event (S\
hift →)",()=>this.jump(1))),h("div",{class:"buttons"},et(bi("▲","hop"),"To the next hop (h)",()=>this.jump(1,"takeoff")),et(bi("▼","landing"),"To the next\
 landing (l)",()=>this.jump(1,"impact"))),this.speeds,h("div",{class:"buttons switches"},[...this.switches.values()]))}show(t){let{clock:e,playButton:s}=this;for(let[
n,a]of this.switches)a.setAttribute("aria-pressed",String(t[n]));let i=e.playing?"Pause (space)":"Play (space)";(s.title!==i||!s.firstChild)&&(s.replaceChildren(
L(e.playing?"pause":"play")),s.title=i,s.setAttribute("aria-label",i)),this.speeds.value!==String(e.speed)&&(this.speeds.value=String(e.speed))}nudge(t){this.clock.
playing=!1,this.clock.seek(this.clock.time+t*Xo*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap(a=>a.events).filter(
a=>e?a.kind===e:!0).map(a=>a.t).sort((a,r)=>a-r),i=this.clock.time,n=t>0?s.find(a=>a>i+1e-9):s.findLast(a=>a<i-1e-9);if(n===void 0&&e&&(n=s[0]),n===void 0){e&&this.
say(e==="takeoff"?"This motion has no hop.":"This motion has no landing.");return}this.clock.seek(n)}};var It=class{constructor(t,e,s,{hosted:i=!1,panels:n=null,onmotion:a=()=>{}}={}){this.root=t,this.backend=e,this.hosted=i,this.onmotion=a,this.prepareRoot();let{
colors:r}=s;this.clock=new $t,this.motions=new ae(e,{shown:l=>this.changed(l),settled:()=>this.story.announce(this.films()),noted:()=>this.noted(),failed:l=>this.
notice.fail(l)}),this.notice=new re,this.theme=new ye(t,r,i,()=>this.show()),this.stage=new ge(r,()=>this.request()),this.transport=new xe(this.clock,()=>this.films(),
l=>this.toggle(l),l=>this.notice.say(l)),this.timeline=new ve(this.clock),this.story=new we(this.clock),this.theory=new be,this.plots=new le(this.clock,r),this.
phase=new he(e,this.clock,r),this.map=new oe(e,s,l=>{this.clock.time=0,this.motions.change(l,!0)}),this.controls=new Ft(s.controls,(l,p)=>this.motions.change(l,
p)),this.share=new ce(this),this.help=qs(s.version),this.hoops=new Qt(l=>this.motions.choose(l)),this.header=new Jt(s.presets,this.share.menu,{take:l=>this.take(
l),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(
n),this.extras=new Vt(this),this.requested=!1,this.surrounding=!1,this.afterFrame=null,this.asked=null,this.later=V(()=>this.fetchTheory(),120),this.frames=0,this.
latencies=[],this.frame=this.frame.bind(this),this.clock.listeners.add(()=>this.request()),this.deaf=Hs(this,i),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){
this.root.classList.add("hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts=
"true")}layOut(t){let{root:e,notice:s}=this,i=l=>!t||t.includes(l),n=h("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.
element),a=h("div",{class:"middle"},h("div",{class:"player"},this.stage.element,this.timeline.element,this.transport.element),h("div",{class:"words"},this.story.
element,i("theory")&&this.theory.element),i("map")&&this.map.element),r=h("div",{class:"why"},i("plots")&&this.plots.element,i("plots")&&this.phase.element);e.replaceChildren(
h("div",{class:"page"},this.header.element,h("div",{class:"columns"},i("controls")&&n,a,r)),s.toast,this.share.dialog,this.help),e.classList.toggle("no-controls",
!i("controls"))}async open(t){await this.motions.load(t),this.begin()}begin(){this.motions.note(),this.show(),this.sizes.observe(this.stage.element),this.root.dataset.
ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.map.close(),this.theme.close(),this.sizes.disconnect(),this.deaf()}film(t=this.
motions.active){return this.motions.film(t)}films(){return this.motions.films()}changed(t=null){t!==null&&(this.header.presets.value=""),this.notice.clear(),this.
show(t)}noted(){this.header.show(this.motions.history,this.motions.lanes.length>1),this.hosted&&history.replaceState(null,"",this.motions.link()),this.onmotion(
this.film().query)}async take(t){try{let e=await this.backend.call("film",{query:t.query});this.clock.time=0,this.motions.replace(e),this.hoops.text.textContent=
t.text,this.story.announce(this.films())}catch(e){this.notice.fail(e)}}async travel(t){await this.motions.travel(t),this.hoops.text.textContent=""}show(t=null){
let{motions:e,clock:s}=this,i=this.films();if(!i.length)return;let n=i.length>1;this.theme.read(),s.duration=Math.max(...i.map(a=>a.duration)),s.time=Math.min(s.
time,s.duration),this.root.classList.toggle("two",n),this.header.show(e.history,n),this.hoops.show(i.length,e.active),this.drawStage(),this.controls.show(this.film()),
t!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-t),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(
()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let t=this.films(),{active:e}=this.motions,{look:s,colors:i}=this.theme;this.plots.draw(
t,e,s),this.phase.draw(t,e,s),this.story.draw(t,e,i),this.drawTime(),this.map.mark(this.film(),s),this.stage.describe(t),this.extras.changed(),this.later()}drawStage(){
this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{time:t}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.
theme.look,this.theme.colors),this.plots.cursor(t),this.phase.cursor(t),this.story.cursor(t),this.transport.show(this.stage.options))}request(){this.requested||
(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){this.requested=!1,this.motions.lanes.length&&(this.clock.tick(t),this.drawStage(),this.drawTime(),
this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){let{scenario:t}=this.film();this.asked?.abort(),this.
asked=new AbortController;let{signal:e}=this.asked;try{let s=await this.backend.call("theory",{scenario:t},e);this.theory.draw(s.header.thresholds,this.motions.
name()),await this.phase.fetch(t,e)}catch(s){let{name:i,message:n}=s;i!=="AbortError"&&this.theory.draw([{label:"–",text:n}])}}toggle(t){let{options:e}=this.stage;
if(t!=="three")e[t]=!e[t];else try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}this.transport.show(e),this.request()}};async function Vo(o){let t=new URL("./",document.baseURI.split(/[?#]/)[0]),e=new Lt(t),s;try{s=(await e.call("setup",{})).header}catch(a){o.textContent=a.message;
return}let i=new It(o,e,s,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let n=new URLSearchParams(location.hash.slice(1)).get("with");try{await i.open([
location.search.slice(1),...n===null?[]:[n]])}catch(a){history.replaceState(null,"",t),await i.open([""]),i.notice.fail(a)}}function Jo({model:o,el:t}){let e=document.
createElement("div");t.append(e);let s=new Rt(o),i=new It(e,s,o.get("setup"),{panels:o.get("panels"),onmotion:a=>{o.get("query")!==a&&(o.set("query",a),o.save_changes())}});
i.motions.set([rt(o.get("film"))]),i.begin();let n=()=>i.motions.replace(rt(o.get("film")));return o.on("change:film",n),()=>{o.off("change:film",n),s.close(),i.
close()}}var yi=document.getElementById("hophoop-lab");yi&&Vo(yi);var Bh={render:Jo};export{Bh as default};
