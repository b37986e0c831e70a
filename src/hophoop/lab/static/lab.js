/* Built from web/lab/main.js by esbuild 0.28.2; sources 50d2aa769352ecd1e55d0ae32a3e3e24 */
function B(n){let t=Number.parseInt(n.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}var pe=n=>st(n)>.2?"#111111":"#ffffff",it=(n,t)=>`rgba(${B(n).join(",")},${t}\
)`,ns=n=>{let t=n/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4};function st(n){let[t,e,s]=B(n).map(ns);return .2126*t+.7152*e+.0722*s}function dt(n,t){if(!t||
!/^#[0-9a-f]{6}$/i.test(n))return n;if(st(n)<.002)return"#eceef2";let e=n;for(let s=0;st(e)<.2&&s<1;s+=.05)e=`#${B(n).map(i=>Math.round(i+(255-i)*s).toString(16).
padStart(2,"0")).join("")}`;return e}var lt=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function rs(){let n=[];for(let t=0;t<
256;t++){let e=t/255*(lt.length-1),s=Math.min(Math.floor(e),lt.length-2),i=B(lt[s]),o=B(lt[s+1]);n.push(i.map((r,h)=>Math.round(r+(o[h]-r)*(e-s))))}return n}var Y=rs(),
pt=Y.map(n=>`rgb(${n.join(",")})`);function l(n,t={},...e){let s=document.createElement(n),i=s;for(let[o,r]of Object.entries(t))r==null||r===!1||(o.startsWith("on")?s.addEventListener(o.slice(2),
r):o==="class"?s.className=r:o in s&&o!=="list"&&typeof r!="string"?i[o]=r:s.setAttribute(o,r===!0?"":r));for(let o of e.flat())o==null||o===!1||s.append(o.nodeType?
o:document.createTextNode(String(o)));return s}var ft=n=>n!==null&&n.getRootNode().activeElement===n,D=n=>n.getContext("2d");function _(n){let t=n.getBoundingClientRect(),
e=Math.min(globalThis.devicePixelRatio||1,2.5),s=Math.max(Math.round(t.width*e),1),i=Math.max(Math.round(t.height*e),1);(n.width!==s||n.height!==i)&&(n.width=s,
n.height=i);let o=D(n);return o.setTransform(e,0,0,e,0,0),{context:o,width:s/e,height:i/e}}function as(n){if(/^#[0-9a-f]{6}$/i.test(n))return n;let t=D(l("canva\
s",{width:1,height:1}));t.fillStyle=n,t.fillRect(0,0,1,1);let[e,s,i]=t.getImageData(0,0,1,1).data;return`#${[e,s,i].map(o=>o.toString(16).padStart(2,"0")).join(
"")}`}function Kt(n){let t=getComputedStyle(n),e=i=>t.getPropertyValue(i).trim(),s=i=>as(e(i));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("\
--paper"),panel:s("--panel"),ground:s("--ground"),font:e("--font"),dark:st(s("--paper"))<.2}}function ut(n,t){let e=l("a",{href:URL.createObjectURL(n),download:t});
document.body.append(e),e.click(),e.remove(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function H(n,t){let e=0;return()=>{clearTimeout(e),e=setTimeout(n,t)}}var b=(n,t,e)=>Math.min(Math.max(n,t),e);function x(n,t=4){if(n==null)return"–";if(typeof n!="number")return String(n);if(!Number.isFinite(n))return Number.isNaN(
n)?"–":n>0?"∞":"−∞";if(n===0)return"0";let e=Math.abs(n),s;if(e>=1e6||e<1e-4){let[i,o]=n.toExponential(t-1).split("e");s=`${fe(i)}·10${hs(Number(o))}`}else
s=fe(n.toPrecision(t)),s.includes("e")&&(s=String(Math.round(n)));return s.replace("-","−")}function fe(n){return n.includes(".")&&!n.includes("e")?n.replace(
/\.?0+$/,""):n}function hs(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join(
"")}var T=(n,t)=>t?t==="°"?`${n}°`:`${n} ${t}`:n,G=n=>`${(n*180/Math.PI).toFixed(1)}°`.replace("-","−");function ue(n){let t=Math.abs(n),[e,s]=t>=.995?[1,"\
m"]:t>=.00995?[100,"cm"]:[1e3,"mm"];return T(x(n*e,3),s)}function E(n,t){let e=n/Math.max(t,1),s=10**Math.floor(Math.log10(e)),i=e/s;return(i>5?10:i>2?5:i>1?2:1)*
s}function N(n,t,e){if(!(t>n)||!Number.isFinite(n)||!Number.isFinite(t))return[];let s=E(t-n,e),i=[];for(let o=Math.ceil(n/s-1e-9);o*s<=t+1e-9*s&&i.length<200;o++)
i.push(o*s);return i}function $(n,t){let e=b(-Math.floor(Math.log10(t)+1e-9),0,15);return Math.max(Math.abs(n),t)>=1e6||e>12?x(n,3):(Math.abs(n)<t*1e-6?0:n).toFixed(
e).replace("-","−")}var me=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],cs="tfc",ls=400;function ge({time:n=0,options:t={},zoom:e=1,map:s}){let i=[];n>
0&&i.push(`t=${Number(n.toFixed(4))}`);let o=me.filter(([r])=>t[r]).map(([,r])=>r);return o.join("")!==cs&&i.push(`show=${o.join("")}`),e!==1&&i.push(`zoom=${Number(
e.toPrecision(3))}`),s&&i.push(`map=${[s.what,...s.x,...s.y].join(",")}`),i.join("&")}function we(n){let t=new URLSearchParams(n.replace(/^#/,"")),e={},s=Number(
t.get("t")??Number.NaN);s>=0&&(e.time=s);let i=t.get("show");i!==null&&(e.options=Object.fromEntries(me.map(([m,w])=>[m,i.includes(w)])));let o=Number(t.get("zo\
om")??Number.NaN);o>0&&(e.zoom=b(o,.05,60));let[r,h,a,c,d,p,f]=t.get("map")?.split(",")??[],u=[a,c,p,f].map(Number);return f!==void 0&&u.every(Number.isFinite)&&
u[0]<u[1]&&u[2]<u[3]&&(e.map={what:r,x:[h,u[0],u[1]],y:[d,u[2],u[3]]}),e}var ds=()=>{let n=new URLSearchParams(location.hash.slice(1)).get("with");return[location.
search.slice(1),...n===null?[]:[n]]},mt=class{constructor(t){this.lab=t,this.number=0,this.soon=H(()=>this.write("same"),ls),this.listen=()=>this.arrived(),addEventListener(
"popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(t){let{lab:e}=this;if(!e.motions.lanes.length)return;let s=e.link();t==="step"?
history.pushState({number:++this.number},"",s):history.replaceState({number:this.number},"",s)}travel(t){return new Promise(e=>{let s=()=>e();addEventListener("\
popstate",s,{once:!0}),setTimeout(s,300),history.go(t)})}async arrived(){let t=history.state?.number??0,e=ds();JSON.stringify(e)===JSON.stringify(this.lab.motions.
queries())?this.number=t:await this.lab.motions.arrive(e)?this.number=t:t!==this.number&&history.go(this.number-t)}};var ps={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function V(n){let t=n instanceof DataView||ArrayBuffer.isView(n)?n:new DataView(n),e=new Uint8Array(t.buffer,
t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(e.subarray(
4,4+s))),o={};for(let{name:r,type:h,shape:a,place:c}of i.arrays){let d=a.reduce((p,f)=>p*f,1);o[r]=new ps[h](e.buffer,e.byteOffset+4+s+c,d)}return{header:i,arrays:o}}var ot=class extends Error{},fs=500,us=4,ms="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";async function ye(n,t,e){
for(;;)try{return await n()}catch(s){if(!(s instanceof ot))throw s;t(s.message),await new Promise(i=>setTimeout(i,fs)),e.throwIfAborted()}}var gt=class{constructor(t){
this.base=t,this.shares=!0}async call(t,e,s){let i={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),signal:s},o=await this.answered(
new URL(`lab/${t}`,this.base),i);if(o.status===202)throw new ot((await o.json()).detail);return V(await o.arrayBuffer())}async answered(t,e){for(let s=us;;s--){
let i=await fetch(t,e).catch(r=>{throw r.name==="AbortError"?r:new Error(ms)});if(i.ok)return i;let o=Number(i.headers.get("Retry-After"));if(i.status!==503||!(o>
0)||s<=1){let r=await i.json().catch(()=>({}));throw new Error(r.detail??`The server answered ${i.status}.`)}await new Promise(r=>setTimeout(r,1e3*Math.min(o,10))),
e?.signal?.throwIfAborted()}}async file(t,e){return(await this.answered(new URL(`api/v1/files/${t}?${e}`,this.base))).blob()}link(t,e){return`${new URL(t?`?${t}`:
"",this.base)}${e}`}},gs=2e4,ws=3e5,wt=class{constructor(t){this.model=t,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).
slice(2),this.listen=(e,s)=>this.answered(e,s),t.on("msg:custom",this.listen)}answered(t,e){let s=t?.view===this.view&&this.waiting.get(t.number);s&&(clearTimeout(
s.timer),this.waiting.delete(t.number),t.compiling?s.reject(new ot(t.compiling)):t.error?s.reject(new Error(t.error)):s.resolve(V(e[0])))}call(t,e,s){let i=++this.
number;return new Promise((o,r)=>{let h=setTimeout(()=>{this.waiting.delete(i),r(new Error("The notebook’s kernel does not answer; run the cell again."))},t===
"file"?ws:gs);this.waiting.set(i,{resolve:o,reject:r,timer:h}),s?.addEventListener("abort",()=>{clearTimeout(h),this.waiting.delete(i),r(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:i,call:t,body:e})})}async file(t,e){let{arrays:s}=await this.call("file",{query:e,name:t});return new Blob(
[s.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};var nt=[.05,.1,.25,.5,1,2,4],yt=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let t of this.listeners)t(this)}seek(t){this.time=b(t,0,this.duration),this.changed()}play(t=!this.playing){this.playing=t,this.last=null,t&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(t){let e=nt.indexOf(this.speed);this.speed=nt[b(e+t,0,nt.length-1)],this.changed()}tick(t){if(!this.playing)return!1;
let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function ys(n,t=""){let e=n.trim();t&&e.endsWith(t)&&(e=e.slice(0,-t.length)),e=e.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(i,o,r)=>`e${o&&"-"}${r.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(e);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(e)?Number(e.replace(",",".")):Number.NaN}function bs(n,t,{label:e,unit:s,range:i}){let o=n.trim();if(Number.isNaN(t))return`${e} = ${o} must be a number, s\
uch as 2.5.`;if(!i||t>=i.least&&t<=i.most||i.also.includes(t))return"";let r=i.also.includes(0)?"0 or ":"",h=`from ${x(i.least,4)} to ${T(x(i.most,4),s)}`,a=i.also.
includes(1/0)?", or inf":"";return`${e} = ${T(x(t,6),s)} must be ${r}${h}${a}.`}var xs=0,J=class{constructor(t,e){this.info=t,this.onvalue=e,this.shown="",this.
typing=!1,this.error=l("p",{class:"error",role:"alert",id:`hh-error-${++xs}`,hidden:!0}),this.input=l("input",{type:"text",inputmode:"decimal",autocomplete:"off",
spellcheck:"false",class:"exact","aria-label":t.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:s=>{
s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute("aria-invalid")==="true"}typed(){
let t=this.input.value;if(!this.typing)return;if(this.typing=!1,t.trim()===""){this.restore();return}let e=ys(t,this.info.unit),s=bs(t,e,this.info);s?this.refuse(
s):this.onvalue(e)}refuse(t){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.id),this.error.textContent=t,this.
error.hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){this.typing=!1,
this.input.value=this.shown,this.accept()}show(t){this.shown=t,this.typing||this.restore()}};var be={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},vs={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},ks=(n,t,e)=>({ring:{shape:n,mass:e,inner_radius:.95*t,outer_radius:t},disk:{shape:n,mass:e,radius:.1*
t,at:.8*t},point_mass:{shape:n,mass:e,at:t},rod:{shape:n,mass:e,length:.5*t,at:.5*t}})[n];function xe(n){let t=n["hoop.radius"],e=n["hoop.mass"],s=Math.min(Math.
max(n["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:bt(e*(1-s)),inner_radius:bt(.98*t),outer_radius:t},{shape:"point_mass",mass:bt(e*s),at:t}]}var bt=n=>Number(
n.toPrecision(6)),xt=class{parts;text;radius;mass;constructor(t){this.onchange=t,this.list=l("div",{class:"parts"}),this.element=l("div",{},this.list,l("select",
{"aria-label":"Add a part",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,ks(s,this.radius,bt(.2*this.mass))])}},l("option",{value:""},
"+ add a part …"),Object.entries(be).map(([e,{label:s}])=>l("option",{value:e},s))))}send(t){this.onchange([["hoop.parts",t]])}show(t,e,s){let i=JSON.stringify(
t);if(i===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(this,{text:i,parts:t,radius:e,mass:s}),this.list.
replaceChildren(...t.map((o,r)=>this.row(o,r)))}row(t,e){let{label:s,keys:i}=be[t.shape];return l("fieldset",{class:"part"},l("legend",{},s,this.parts.length>1&&
l("button",{type:"button",class:"quiet","aria-label":`Remove part ${e+1}, ${s}`,onclick:()=>this.send(this.parts.filter((o,r)=>r!==e))},"×")),i.map(o=>this.field(
t,e,o)))}field(t,e,s){let[i,o]=vs[s],r=new J({label:i,unit:o},h=>this.send(this.parts.map((a,c)=>c===e?{...a,[s]:h}:a)));return r.show(String(t[s]??0)),l("div",
{},l("label",{},`${i} [${o}]`,r.input),r.error)}};var Yt=Math.PI/180;function Ms({allowed:n,degrees:t}){if(!n)return;let e=t?1/Yt:1;return{least:n.least*e,most:n.most*e,also:n.also.map(s=>s==="inf"?1/0:Number(s))}}
var Gt=class{constructor(t,e){this.info=t,this.onchange=e,this.held=!1;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`,i=a=>()=>{this.held=a};this.
range=l("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:i(!0),onpointerup:i(!1),onpointercancel:i(!1),onblur:i(!1)});let{label:o,unit:r}=t,h=`${o}, exact value${r?` i\
n ${r}`:""}`;this.entry=new J({label:o,unit:r,name:h,range:Ms(t)},a=>this.send(a,!0)),this.element=l("div",{class:"control",title:t.help},l("label",{for:s},l("s\
pan",{},o),l("span",{class:"symbol"},t.symbol)),this.range,l("span",{class:"entry"},this.entry.input,l("span",{class:"unit"},r)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(t){let e=Number(
this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.entry.typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,t)}send(t,e){
let s=this.info.degrees?t*Yt:t;this.onchange([[this.info.path,Number.isFinite(s)?s:"inf"]],e)}say(t){this.range.setAttribute("aria-valuetext",T(x(t,4),this.info.
unit))}show(t,e=null){if(this.held)return;let s=t!=null,i=s?t:e;if(i==null){this.entry.show("");return}let o=i==="inf"?1/0:Number(i)/(this.info.degrees?Yt:1);this.
entry.show(s?Number.isFinite(o)?String(Number(o.toPrecision(9))):"∞":""),this.entry.input.placeholder=s?"":`auto ${x(o,2)}`,this.entry.input.title=s?T(String(
o),this.info.unit):"";let r=b(this.info.logarithmic?Math.log10(o):o,this.low(),this.high());Math.abs(Number(this.range.value)-r)>1e-6&&(this.range.value=String(
r)),this.say(o)}};function Ts(n,t){let e=l("select",{"data-path":n.path,onchange:()=>t([[n.path,e.value]],!0)},n.options.map(([i,o])=>l("option",{value:i},o)));
return{element:l("label",{class:"choice",title:n.help},l("span",{},n.label),e),select:e,path:n.path}}var vt=class{way;kind;gravity;apart;derived;film;constructor(t,e){
this.onchange=(s,i=!0)=>e(s,i),this.sliders=new Map;for(let s of Object.values(t.groups))for(let i of s)this.sliders.set(i.path,new Gt(i,this.onchange));this.choices=
new Map(t.choices.map(s=>[s.path,Ts(s,this.onchange)])),this.parts=new xt(this.onchange),this.gravities=t.gravities,this.element=l("div",{class:"controls"},this.
hoop(),this.plane(),this.start(),this.contact())}at(t){let e=this.sliders.get(t)??this.choices.get(t);if(!e)throw new Error(`There is no control of ${t}.`);return e.
element}select(t,e,s){let i=l("select",{onchange:()=>s(i.value)},e.map(([o,r])=>l("option",{value:o},r)));return{select:i,element:l("label",{class:"choice"},l("\
span",{},t),i)}}group(t,...e){let s=t==="Start"||t==="Plane"||!matchMedia("(max-width: 760px)").matches;return l("details",{class:"group",open:s},l("summary",{},
t),e)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],t=>{let{values:e}=this.
film;t==="parts"?this.onchange([["hoop.parts",xe(e)]]):this.onchange([[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=l("p",{class:"derived"}),this.group(
"Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.eccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.r\
adius"),this.at("hoop.mass"))}plane(){return this.apart=l("input",{type:"checkbox",onchange:()=>{let{values:t}=this.film;this.apart.checked?this.onchange([["pla\
ne.mu_static",t["plane.mu_static"]],["plane.mu_kinetic",t["plane.mu_kinetic"]]]):this.onchange([["plane.mu",t["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([t])=>[t,t]),["","elsewhere"]],t=>{let e=this.gravities.find(([s])=>s===t);e&&this.onchange([["plane.gravity",e[1]]])}),this.group(
"Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_kinetic"),l("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.
at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("plane.restitution"),this.at("plane.impact_law"),this.at("plane.painleve"))}start(){return this.
kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],t=>{let{values:e}=this.film;t==="rolling"?this.onchange([["start.speed",e["start.vx"]]]):
this.onchange([["start.omega",e["start.omega"]]])}),this.group("Start",this.kind.element,this.at("start.speed"),this.at("start.angle"),this.at("start.height"),this.
at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.at("duration"))}contact(){return this.group("Contact",this.at("contact.model"),this.at("contact.l\
aw"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitution"))}refuse(t,e){let s=t.length===1?this.
sliders.get(t[0][0]):void 0;return s?.element.checkVisibility()?(s.entry.refuse(e),!0):!1}restore(){this.film&&this.showChoices(this.film,new Set)}show(t,e=new Set){
this.film=t,this.showChoices(t,e);let s=t.scenario;for(let[i,o]of this.sliders){if(e.has(i))continue;let[r,h]=i.split(".");o.show(t.values[i]??(h?s[r]?.[h]:s[r]),
t.automatic?.[i])}}showChoices(t,e){let{scenario:s,values:i}=t,o=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_fraction":"eccentricity",r="speed"in s.start,
h="mu_static"in s.plane,a=s.contact.model==="compliant",c=(...u)=>u.some(m=>e.has(m));c("hoop.load_fraction","hoop.eccentricity","hoop.parts")||(this.way.select.
value=o),c("start.speed","start.omega")||(this.kind.select.value=r?"rolling":"free"),c("plane.mu","plane.mu_static")||(this.apart.checked=h);let d=this.gravities.
find(([,u])=>Math.abs(u-s.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=d?d[0]:"");let p={"hoop.load_fraction":o==="load_fraction","hoop.e\
ccentricity":o==="eccentricity","hoop.inertia_ratio":o==="eccentricity","hoop.mass":o!=="parts","plane.mu":!h,"plane.mu_static":h,"plane.mu_kinetic":h,"plane.re\
stitution":!a,"plane.impact_law":!a,"plane.painleve":!a,"start.speed":r,"start.height":!r,"start.vx":!r,"start.vy":!r,"start.omega":!r,"contact.law":a,"contact.\
friction":a,"contact.stiffness":a,"contact.slip_speed":a,"contact.restitution":a};for(let[u,m]of Object.entries(p))this.at(u).hidden=!m;this.parts.element.hidden=
o!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,i["hoop.radius"],i["hoop.mass"]),this.derived.textContent=o==="eccentricity"?"":`ε = ${x(i["hoop.eccentr\
icity"],5)}, κ = ${x(i["hoop.inertia_ratio"],5)}`+(o==="parts"?`, m = ${x(i["hoop.mass"],5)} kg`:"");let f=s;for(let[u,{select:m}]of this.choices){if(e.has(u))
continue;let[w,g]=u.split(".");f[w]?.[g]!==void 0&&(m.value=f[w][g])}}};var Ss={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",theme:"M8.5 2a6.5 6.5 \
0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function A(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("v\
iewBox","0 0 17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class","icon");let s=document.createElementNS(t,"path");return s.setAttribute("d",Ss[n]),
e.append(s),e}var rt=(n,t,e)=>l("button",{type:"button",title:t,"aria-label":t,onclick:e},n),kt=class{constructor(t,e,s){let i=new Map;for(let r of t)i.set(r.group,[...i.get(
r.group)??[],r]);this.fresh=!1,this.presets=l("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let r=t.find(({key:h})=>h===this.presets.
value);this.fresh=r!==void 0,r&&s.take(r)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},l("option",{value:""},"Motions to start from …"),[...i].
map(([r,h])=>l("optgroup",{label:r},h.map(({key:a,title:c})=>l("option",{value:a},c))))),this.undo=rt(A("undo"),"Undo (z)",s.undo),this.redo=rt(A("redo"),"Redo \
(y)",s.redo);let o=l("span",{},l("span",{class:"long"},"Compare"),l("span",{class:"short"},A("two")));this.compare=rt(o,"Compare two hoops",s.compare),this.element=
l("header",{class:"top"},l("h1",{},l("span",{class:"logo","aria-hidden":"true"}),l("span",{},"hophoop",l("span",{class:"long"}," lab"))),this.presets,l("div",{class:"\
buttons"},this.undo,this.redo,this.compare),l("div",{class:"buttons right"},e,rt(A("theme"),"Dark or light (d)",s.theme),rt("?","Keys and help (?)",s.help)))}show(t,e){
this.undo.disabled=!t.past.length,this.redo.disabled=!t.future.length,this.compare.setAttribute("aria-pressed",String(e))}};var Es=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["Esc","leave a field, a menu, a picture \
that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],As=[["R","roll","the rim does not slide"],["S","spin","slip: the rim tur\
ns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],["H","\
flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],Ps=[["▲ ▼","take-off, landing"],["•","highest point"],
["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy out of nothing"],["≋","bounces without numbe\
r end"],["◗ ■","skimming begins, rest"]],Vt=(n,t,e=()=>!1)=>l("table",{},l("caption",{},n),t.map(([s,...i])=>l("tr",{},l("th",{scope:"row"},e(s),s),i.map(o=>l(
"td",{},o)))));function ve(n,t,e){let s=l("dialog",{class:"help","aria-label":"Keys and help"},l("h2",{},"The hoop"),l("p",{},"A ring with a load on its rim rol\
ls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide\
. Move a slider and see."),Vt("Modes",As,i=>l("i",{class:"dot",style:`background:${t.modes[i]}`})),Vt("Marks on the bar of time",Ps),Vt("Keys",Es),e,l("p",{class:"\
hint"},`hophoop ${n}`),l("button",{type:"button",class:"close",onclick:()=>s.close()},"Close"));return s}var Mt=class{constructor(t){this.tabs=["A","B"].map((e,s)=>l("button",{type:"button","aria-pressed":"false",onclick:()=>t(s)},`Hoop ${e}`)),this.bar=l("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=l("p",{class:"preset-text"}),this.element=l("div",{class:"lanes"},
this.bar,this.text)}show(t,e){this.bar.hidden=t<2;for(let[s,i]of this.tabs.entries())i.setAttribute("aria-pressed",String(s===e))}};var ke="hophoop-theme",_s=["gravity_center","airborne","normal_force","friction_force"],Tt=class{constructor(t,e,s,i){this.root=t,this.colors=e,this.hosted=s,this.
changed=i,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=Kt(t),this.inks={...e},this.read()}mark(){let t=this.hosted?Jt(ke):null;this.root.dataset.theme=this.chosen??t??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=Kt(this.root),this.inks={...this.colors};for(let t of _s)
this.inks[t]=dt(this.colors[t],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&Zt(ke,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};function Jt(n){try{return localStorage.getItem(n)}catch{
return null}}function Zt(n,t){try{localStorage.setItem(n,t)}catch{}}var Me="hophoop-single-keys",$s=(n,t)=>({" ":()=>n.clock.play(),ArrowLeft:()=>t?n.transport.jump(-1):n.transport.nudge(-1),ArrowRight:()=>t?n.transport.jump(1):
n.transport.nudge(1),Home:()=>n.clock.seek(0),End:()=>n.clock.seek(n.clock.duration),h:()=>n.transport.jump(1,"takeoff"),l:()=>n.transport.jump(1,"impact"),"[":()=>n.
clock.faster(-1),"]":()=>n.clock.faster(1),t:()=>n.toggle("traces"),f:()=>n.toggle("forces"),c:()=>n.toggle("speed"),w:()=>n.toggle("whole"),3:()=>n.toggle("thr\
ee"),"+":()=>n.stage.zoom(1.25),"=":()=>n.stage.zoom(1.25),"-":()=>n.stage.zoom(.8),0:()=>n.stage.zoom(0),z:()=>n.travel(-1),y:()=>n.travel(1),d:()=>n.theme.toggle(),
p:()=>n.share.code(),"?":()=>n.help.showModal()});function Rs(n,t){let e=t.key.toLowerCase();t.altKey||!(e==="z"||e==="y")||(t.preventDefault(),n.travel(e==="y"||
t.shiftKey?1:-1))}function Is(n){let t=n.share.menu;t.open&&(t.open=!1,t.querySelector("summary")?.focus())}var St=class{constructor(t){this.on=!t||Jt(Me)!=="of\
f";let e=l("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=e.checked,t&&Zt(Me,this.on?"on":"off")}});this.element=l("label",{class:"check"},e,"Si\
ngle keys (letters, digits, signs) do what the table says")}};function zs(n,t){let e=t.target;if(n.root.querySelector("dialog[open]"))return;if(t.key==="Escape"){
Is(n);return}if(e.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(t.ctrlKey||t.metaKey){Rs(n,t);return}if(t.altKey||e.matches?.("selec\
t")&&!(t.key===" "&&n.header.fresh)||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary, input[ty\
pe=checkbox]")||!n.singleKeys.on&&t.key!==" "&&t.key.length===1)return;let i=$s(n,t.shiftKey)[t.key];i&&(t.preventDefault(),i())}function Te(n,t){let e=t?document:
n.root,s=i=>{zs(n,i),t||i.stopPropagation()};return e.addEventListener("keydown",s),()=>e.removeEventListener("keydown",s)}var[Se,Ns]=[62,92],Ls=12,W=10,Cs=36,Ee=Math.PI/180,F=["x","y"],Et=class{box;constructor(t){this.known=new Map(t.map(e=>[e.path,e])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=Se}info(t){return this.known.get(this.paths[t])}whole(t){return[...this.info(t).range]}home(){
for(let t of F)this.windows[t]=this.whole(t)}choose(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t]),this.paths[t]=e,this.home()}asked(t,e){
let[s,i]=this.windows[t];return{path:this.paths[t],from:s,to:i,cells:e}}bounds(t){let{range:e,allowed:s}=this.info(t),i=2*(e[1]-e[0]);return[Math.max(s[0],e[0]-
i),Math.min(s[1],e[1]+i)]}zoom(t,e){let s={x:[],y:[]};for(let i of F){let[o,r]=this.windows[i],h=e?.[i]??.5*(o+r);s[i]=q([h-(h-o)*t,h+(r-h)*t],this.bounds(i));let a=Math.
max(Math.abs(s[i][0]),Math.abs(s[i][1]),1e-9);if(s[i][1]-s[i][0]<400*Number.EPSILON*a)return!1}return F.every(i=>s[i].every((o,r)=>o===this.windows[i][r]))?!1:(this.
windows=s,!0)}drag(t,e,s){let i=(o,r)=>q(t[o].map(h=>h+r*(t[o][1]-t[o][0])),this.bounds(o));this.windows={x:i("x",-e/this.box.width),y:i("y",s/this.box.height)}}restore(t){
if(!F.every(e=>this.known.has(t[e][0]))||t.x[0]===t.y[0])return!1;for(let e of F)this.paths[e]=t[e][0];for(let e of F)this.windows[e]=q(t[e].slice(1).map(Number),
this.bounds(e));return!0}isHome(){return F.every(t=>this.windows[t].every((e,s)=>e===this.whole(t)[s]))}middle(){let{x:t,y:e}=this.windows;return{x:.5*(t[0]+t[1]),
y:.5*(e[0]+e[1])}}fit(t,e){this.left=this.deep("y")?Ns:Se,this.box={width:t-this.left-Ls,height:e-W-Cs}}clip(t){t.beginPath(),t.rect(this.left,W,this.box.width,
this.box.height),t.clip()}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-e)*this.box.width}y(t){let[e,s]=this.windows.y;return W+(1-(t-e)/(s-e))*this.box.
height}place(t,e){let s=([i,o],r)=>i+b(r,0,1)*(o-i);return{x:s(this.windows.x,(t-this.left)/this.box.width),y:s(this.windows.y,1-(e-W)/this.box.height)}}deep(t){
let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.abs(e),Math.abs(s))}said(t){let e=s=>{let i=this.info(s),[o,r]=this.windows[s],h=Math.max(Math.abs(o),Math.
abs(r)),a=b(Math.ceil(Math.log10(h/(r-o)))+4,4,16);return`${i.label} = ${T(x(i.degrees?t[s]/Ee:t[s],a),i.unit)}`};return`${e("x")}, ${e("y")}`}draw(t,e,s){t.strokeStyle=
s.soft,t.fillStyle=s.soft,t.lineWidth=1,t.strokeRect(this.left+.5,W+.5,this.box.width-1,this.box.height-1),t.font=`11px ${s.font}`;for(let i of F){let o=this.info(
i),r=o.degrees?1/Ee:1,[h,a]=this.windows[i].map(g=>g*r),c=i==="x"?this.box.width/80:this.box.height/40,d=E(a-h,c),p=this.deep(i),f=p?Number((.5*(h+a)).toPrecision(
12)):0,u=p?N(h-f,a-f,c).map(g=>g+f):N(h,a,c);for(let g of u){let y=p?x(g-f,3):$(g,d);i==="x"?(t.textAlign="center",t.fillText(y,this.x(g/r),W+this.box.height+14)):
(t.textAlign="right",t.textBaseline="middle",t.fillText(y,this.left-5,this.y(g/r)),t.textBaseline="alphabetic")}let m=p?` − ${String(f).replace("-","−")}`:"",
w=`${o.label}${m}${o.unit?` [${o.unit}]`:""}`;t.save(),t.textAlign="center",i==="x"?t.translate(this.left+.5*this.box.width,e-5):(t.translate(12,W+.5*this.box.height),
t.rotate(-Math.PI/2)),t.fillText(w,0,0),t.restore()}}};function q([n,t],[e,s]){let i=Math.min(t-n,s-e);return n<e?[e,e+i]:t>s?[s-i,s]:[n,t]}function Qt(n,t,e,s,i){
for(let[o,r]of[[i,4],[s,1.8]])n.strokeStyle=o,n.lineWidth=r,n.beginPath(),n.arc(t,e,7,0,2*Math.PI),n.moveTo(t-13,e),n.lineTo(t-4,e),n.moveTo(t+4,e),n.lineTo(t+13,
e),n.moveTo(t,e-13),n.lineTo(t,e-4),n.moveTo(t,e+4),n.lineTo(t,e+13),n.stroke()}function O(n,t,e,s=()=>{}){let i=new AbortController,{signal:o}=i,r=(a,c)=>n.addEventListener(a,d=>d.pointerId===t.pointerId&&c(d),{signal:o}),h=a=>c=>{i.abort(),
s(c,a)};n.setPointerCapture(t.pointerId),r("pointermove",e),r("pointerup",h(!0)),r("pointercancel",h(!1))}function Ae(n,t){let e=new Map,s=null,i=()=>{let[r,h]=[
...e.values()];return{span:Math.max(Math.hypot(r.clientX-h.clientX,r.clientY-h.clientY),1),clientX:.5*(r.clientX+h.clientX),clientY:.5*(r.clientY+h.clientY)}};n.
addEventListener("pointerdown",r=>{r.pointerType!=="mouse"&&(e.set(r.pointerId,r),s=e.size===2?i():null)}),n.addEventListener("pointermove",r=>{if(!e.has(r.pointerId)||
(e.set(r.pointerId,r),e.size!==2||!s))return;let h=i();t(h.span/s.span,h),s=h});for(let r of["pointerup","pointercancel"])n.addEventListener(r,h=>{e.delete(h.pointerId),
s=null});let o=r=>r.touches.length>1&&r.cancelable&&r.preventDefault();return n.addEventListener("touchmove",o,{passive:!1}),()=>e.size>1}var Z=n=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${n&&`; ${n}`}; double-click for all`,Fs=.0018,Pe=200,
[Os,Bs]=[1/.6,1/1.7];function R(n,{zoom:t,home:e,chosen:s=()=>n,keys:i=!1}){return n.addEventListener("wheel",o=>{(o.ctrlKey||o.metaKey||ft(s()))&&(o.preventDefault(),
t(Math.exp(-Math.min(Math.max(o.deltaY,-Pe),Pe)*Fs),o))},{passive:!1}),n.addEventListener("dblclick",e),i&&n.addEventListener("keydown",o=>{if(o.key==="+"||o.key===
"=")t(Os);else if(o.key==="-")t(Bs);else if(o.key==="0")e();else if(o.key==="Escape")n.blur();else return;o.preventDefault(),o.stopPropagation()}),Ae(n,t)}var _e={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},$e=48;function Re(n){let{body:t}=n,e=!1,s=R(t,{zoom:(i,o)=>n.axes.box&&n.zoom(1/i,o?te(
n,o):n.pointed??void 0),home:()=>n.home(),keys:!0});t.addEventListener("pointerdown",i=>Hs(n,i,s,o=>e=o)),t.addEventListener("pointermove",i=>{n.axes.box&&!e&&i.
pointerType!=="touch"&&Ds(n,i)}),t.addEventListener("pointerleave",()=>n.tip.hidden=!0),t.addEventListener("keydown",i=>Us(n,i))}function te(n,t){let e=n.body.getBoundingClientRect();
return n.axes.place(t.clientX-e.left,t.clientY-e.top)}function Ds(n,t){n.tip.textContent=n.said(te(n,t)),n.tip.hidden=!1;let e=n.body.getBoundingClientRect();n.
tip.style.left=`${b(t.clientX-e.left,150,Math.max(e.width-150,150))}px`,n.tip.style.bottom=`${e.bottom-t.clientY+16}px`}function Hs(n,t,e,s){t.preventDefault(),
n.body.focus({preventScroll:!0});let i=[t.clientX,t.clientY],o={x:[...n.axes.windows.x],y:[...n.axes.windows.y]};n.pointed=te(n,t);let r=!1,h=e(),a=c=>{if(h||=e(),
h)return;let[d,p]=[c.clientX-i[0],c.clientY-i[1]];Math.hypot(d,p)<5&&!r||(r=!0,s(!0),n.tip.hidden=!0,n.axes.drag(o,d,p),n.redraw(),n.soon())};O(n.body,t,a,(c,d)=>{
d&&!r&&!h&&n.pointed&&n.take(n.pointed),s(!1)})}function Us(n,t){let e=n.pointed??n.here()??n.axes.middle();if(n.pointed=e,_e[t.key]){let[s,i]=_e[t.key],{x:o,y:r}=n.
axes.windows;n.pointed={x:b(e.x+s*(o[1]-o[0])/$e,o[0],o[1]),y:b(e.y+i*(r[1]-r[0])/$e,r[0],r[1])},n.state.textContent=n.said(n.pointed),n.say(n.said(n.pointed))}else if(t.
key==="Enter")n.take(e);else return;t.preventDefault(),t.stopPropagation(),n.redraw()}var js=["start.height","start.vx","start.vy","start.omega"];function Ie(n,t){let e="speed"in n.start;return!e&&t.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":e&&t.some(s=>js.includes(s))?"of starts in any state, though this motion starts rolling":""}var Ws=Math.PI/180,qs=12,Xs=["hop_height","flight_time","energy_lost","greatest_utilization"];function ze(n){return n.unit==="rad"?[1/Ws,"°"]:[1,n.unit==="1"?"":
n.unit]}function Ks({classes:n,what:t},e){let[s,i]=[1/0,-1/0];if(n)return[s,i];for(let o of e)o<s&&(s=o),o>i&&(i=o);return[Xs.includes(t)?Math.min(s,0):s,i]}function Ne(n){
let{values:t}=n.arrays,e=n.header,{x:s,y:i,classes:o}=e,r=new ImageData(s.cells,i.cells),[h,a]=Ks(e,t),c=o?.map(({color:p})=>B(p));for(let p=0;p<i.cells;p++)for(let f=0;f<
s.cells;f++){let u=t[p*s.cells+f],m=4*((i.cells-1-p)*s.cells+f);if(!Number.isFinite(u))continue;let w=c&&(f+1<s.cells&&t[p*s.cells+f+1]!==u||p+1<i.cells&&t[(p+1)*
s.cells+f]!==u),g=c?c[u].map(y=>w?.72*y:y):Y[b(Math.round(255*(u-h)/(a-h||1)),0,255)];r.data.set([...g,255],m)}let d=l("canvas",{width:s.cells,height:i.cells});
return D(d).putImageData(r,0,0),{picture:d,header:e,values:t,x:[s.from,s.to],y:[i.from,i.to],low:h,high:a}}function Le(n,t){let e=(i,o)=>i[0]>=o[0]-1e-300&&i[1]<=
o[1]+1e-300;return[...n.filter(i=>!(e(i.x,t.x)&&e(i.y,t.y))),t].slice(-qs)}function Ce({header:n,low:t,high:e,values:s}){let{classes:i}=n;if(!i){let h=l("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),a=D(h);for(let p=0;p<120;p++)a.fillStyle=`rgb(${Y[Math.floor(255*p/119)].join(",")})`,a.fillRect(p,0,1,10);
let[c,d]=ze(n);return[l("span",{},`${n.label}: ${e>=t?x(t*c,3):"none"} `),h,l("span",{},e>=t?T(x(e*c,3),d):""),s.some(p=>!Number.isFinite(p))?l("span",{},l("i",
{class:"blank"}),"none"):""]}let o=new Map;for(let h of s)o.set(h,(o.get(h)??0)+1);let r=[...o].filter(([h])=>h>=0).sort((h,a)=>a[1]-h[1]);return[...r.slice(0,10).
map(([h])=>{let{color:a,text:c}=i[h];return l("span",{},l("i",{style:`background:${a}`,"aria-hidden":"true"}),c)}),r.length>10?l("span",{},`and ${r.length-10} m\
ore`):""]}function Fe(n,t){for(let{header:e,values:s}of[...n].reverse()){let{x:i,y:o,classes:r}=e,h=Math.floor((t.x-i.from)/(i.to-i.from)*i.cells),a=Math.floor(
(t.y-o.from)/(o.to-o.from)*o.cells);if(h<0||a<0||h>=i.cells||a>=o.cells)continue;let c=s[a*i.cells+h];if(r)return r[c]?.text??"not allowed";let[d,p]=ze(e);return Number.
isFinite(c)?T(x(c*d,4),p):"none"}return"…"}var Oe=[[24,16],[72,48],[216,144]],At=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(t,e,{take:s,say:i,changed:o}){this.backend=
t,this.onmotion=s,this.say=i,this.changed=o;let r=e.controls.map_axes;this.axes=new Et(r),this.what="sequence",this.layers=[],this.canvas=l("canvas",{class:"plo\
t-canvas"}),this.tip=l("div",{class:"tip",hidden:!0}),this.body=l("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow ke\
ys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=l("div",{class:"map-keys"}),this.state=l("span",{class:"hint"});
let h=a=>{let c=l("select",{"data-axis":a,onchange:()=>this.setAxis(a,c.value)},r.map(({path:d,label:p})=>l("option",{value:d},p)));return c};this.selects={x:h(
"x"),y:h("y")},this.quantity=l("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},e.map_quantities.map(([a,
c])=>l("option",{value:a},c))),this.element=l("section",{class:"map","aria-label":"Map of motions"},l("div",{class:"map-head"},l("h2",{},"Map"),l("label",{},"of",
this.quantity),l("label",{},"Across",this.selects.x),l("label",{},"Up",this.selects.y),l("span",{class:"buttons"},l("button",{type:"button","aria-label":"Zoom i\
nto the map",onclick:()=>this.zoom(.5)},"+"),l("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),l("button",{type:"but\
ton",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,l("p",{class:"hint"},`Click to take that motion into the player; ${Z("drag to move")}\
.`)),Re(this),this.soon=H(()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([a])=>{this.seen=a.isIntersecting,this.seen&&this.stale&&this.
refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let t of F)this.selects[t].value=
this.axes.paths[t]}setAxis(t,e){this.axes.choose(t,e),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(t){let e=structuredClone(t);
for(let s of Object.values(this.axes.paths)){let[i,o]=s.split(".");e[i]&&delete e[i][o]}return JSON.stringify(e)}mark(t,e){this.film=t,this.look=e;let s=this.key_of(
t.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){let{paths:t,windows:e}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&
t.x==="start.speed"&&t.y==="plane.mu")return;let s=i=>[t[i],...e[i]];return{what:this.what,x:s("x"),y:s("y")}}restore(t){![...this.quantity.options].some(({value:e})=>e===
t.what)||!this.axes.restore(t)||(this.quantity.value=this.what=t.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let i=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;i!==this.kind&&(this.layers=[]),this.
kind=i,this.redraw();try{for(let[o,r]of Oe){this.state.textContent=`computing ${o*r} motions …`;let h={x:this.axes.asked("x",o),y:this.axes.asked("y",r)},a={scenario:e,
changes:s,...h,what:this.what},c=await ye(()=>this.backend.call("map",a,t),f=>{this.state.textContent=f},t),d=Ne(c);this.layers=Le(this.layers,d),this.keys.replaceChildren(
...Ce(d));let p=Ie(e,Object.values(this.axes.paths));this.state.textContent=`${o*r} motions${s.length?", with rigid contact":""}${p&&`; ${p}`}`,this.redraw()}this.
level=Oe.length}catch(o){let{name:r,message:h}=o;if(r==="AbortError")return;this.state.textContent=h}this.computing=!1}redraw(){if(!this.film)return;let{look:t}=this,
{context:e,width:s,height:i}=_(this.canvas);this.axes.fit(s,i),e.clearRect(0,0,s,i),e.save(),this.axes.clip(e),e.imageSmoothingEnabled=!1;let{axes:o}=this;for(let h of this.
layers){let[a,c]=h.x.map(f=>o.x(f)),[d,p]=h.y.map(f=>o.y(f));e.drawImage(h.picture,a,p,c-a,d-p)}let r=this.here();r&&Qt(e,o.x(r.x),o.y(r.y),t.ink,t.paper),this.
pointed&&ft(this.body)&&Qt(e,o.x(this.pointed.x),o.y(this.pointed.y),"#D55E00",t.paper),e.restore(),o.draw(e,i,t)}here(){let t=s=>{let[i,o]=s.split(".");return this.
film.values[s]??this.film.scenario[i]?.[o]},e={x:t(this.axes.paths.x),y:t(this.axes.paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}said(t){return`${this.
axes.said(t)}: ${Fe(this.layers,t)}`}take(t){this.onmotion([[this.axes.paths.x,t.x],[this.axes.paths.y,t.y]])}zoom(t,e){this.tip.hidden=!0,this.axes.zoom(t,e)&&
(this.redraw(),this.soon())}};var ee="RSKHM",Ys=new Set(["x","angle","height"]),Gs={x:"vx",angle:"omega",height:"vy"},Q=class{constructor(t){let{header:e}=t;this.scenario=e.scenario,this.query=
e.query,this.duration=e.duration,this.status=e.status,this.sequence=e.sequence,this.events=e.events,this.values=e.values,this.automatic=e.automatic,this.summary=
e.summary,this.story=e.story,this.shortened=e.shortened,this.columns=t.arrays,this.t=t.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radius"],
this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.gravity??
9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map}findPhases(){let{mode:t}=this.columns,e=[];for(let s=0;s<this.length;s++){let i=e.
at(-1);i&&i.mode===ee[t[s]]?i.to=this.t[s]:e.push({mode:ee[t[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<e.length;s++)e[s].to=e[s+1].from;return e.filter(
s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,vy:i,omega:o}=this.columns,r={left:1/0,right:-1/0,top:0,speed:0},h=[];for(let a=0;a<this.length;a++){
Number.isFinite(t[a])&&(r.left=Math.min(r.left,t[a]),r.right=Math.max(r.right,t[a])),e[a]>r.top&&(r.top=e[a]);let c=Math.hypot(s[a],i[a])+this.radius*Math.abs(o[a]);
Number.isFinite(c)&&h.push(c)}return h.sort((a,c)=>a-c),r.speed=h[Math.floor(.95*(h.length-1))]||1,r}index(t){let e=0,s=this.length;for(;s-e>1;){let i=e+s>>1;this.
t[i]<=t?e=i:s=i}return e}at(t){let e=b(t,0,this.duration),s=this.index(e),i=Math.min(s+1,this.length-1),o=this.t[i]-this.t[s],r=o>0?(e-this.t[s])/o:0,h={t:e,mode:ee[this.
columns.mode[s]]};for(let[a,c]of Object.entries(this.columns)){if(a==="t"||a==="mode")continue;let d=c[s],p=c[i];if(r===0||!Number.isFinite(p))h[a]=d;else if(Ys.
has(a)){let f=this.columns[Gs[a]];h[a]=Vs(d,p,f[s]*o,f[i]*o,r)}else h[a]=d+(p-d)*r}return h}derived(t,e){let s=this.cache.get(t)??e(this.columns);return this.cache.
set(t,s),s}};function Vs(n,t,e,s,i){if(!Number.isFinite(e)||!Number.isFinite(s))return n+(t-n)*i;let o=1-i;return o*o*(1+2*i)*n+i*i*(3-2*i)*t+i*o*(o*e-i*s)}var Pt=class{constructor(){this.past=[],this.future=[],this.now=null,this.what="",this.when=-1/0}note(t,e="",s=performance.now()){let i=this.now;if(this.now=t,i===
null||se(i,t))return"same";let o=e!==""&&e===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=e,this.when=s,this.future=[],o?"again":(this.past.push(
i),this.past.length>500&&this.past.shift(),"step")}next(t){return(t<0?this.past:this.future).at(-1)??null}step(t){let[e,s]=t<0?[this.past,this.future]:[this.future,
this.past],i=e.pop();!i||!this.now||(s.push(this.now),this.now=i,this.what="")}arrive(t){if(!(this.now&&se(this.now,t))){for(let e of[-1,1]){let s=e<0?this.past:
this.future,i=s.length-s.findLastIndex(o=>se(o,t));if(!(i>s.length)){for(let o=0;o<i;o++)this.step(e);return}}Object.assign(this,{past:[],future:[],now:t,what:""})}}},
se=(n,t)=>JSON.stringify(n)===JSON.stringify(t);var _t=class{constructor(t,e){this.backend=t,this.listener=e,this.history=new Pt,this.lanes=[],this.active=0,this.going=Promise.resolve()}film(t=this.active){return this.
lanes[t].film}films(){return this.lanes.map(t=>t.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([t])=>t))}name(){return this.lanes.length>
1?"AB"[this.active]:""}set(t){this.lanes=t.map(e=>({film:new Q(e)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(t){this.set(await Promise.
all(t.map(e=>this.backend.call("film",{query:e}))))}change(t,e){let s=this.lanes[this.active];s.since??=performance.now(),s.pending=[...(s.pending??[]).filter(([
i])=>!t.some(([o])=>o===i)),...t],s.commit||=e,s.what=t.map(([i])=>i).join(),this.pump(s)}async pump(t){if(t.busy||!this.lanes.includes(t))return;if(!t.pending){
t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{t.film=new Q(await this.backend.call("film",{scenario:t.film.
scenario,changes:e})),this.lanes.includes(t)&&this.listener.shown(s)}catch(i){this.lanes.includes(t)&&this.listener.failed(i,e)}finally{t.busy=!1}this.pump(t)}settle(t){
t.commit=!1,this.note(t.what),this.listener.settled()}queries(){return this.films().map(t=>t.query)}note(t){this.listener.noted(this.history.note(this.queries(),
t))}replace(t){this.lanes[this.active]={film:new Q(t)},this.listener.shown(),this.note()}travel(t){return this.inTurn(async()=>{let e=this.history.next(t);e&&(await this.
load(e),this.history.step(t),await this.listener.travelled(t),this.listener.shown(),this.listener.noted("travelled"))})}arrive(t){return this.inTurn(async()=>{await this.
load(t),this.history.arrive(t),this.listener.shown(),this.listener.noted("travelled")})}inTurn(t){return this.going=this.going.then(t).then(()=>!0,e=>(this.listener.
failed(e),!1)),this.going}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=
0),this.listener.shown(),this.note()}choose(t){this.active=t,this.listener.shown(),this.listener.noted("same")}link(t=""){let s=[this.lanes.length>1?`with=${encodeURIComponent(
this.film(1).query)}`:"",t].filter(Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};var Js=6e3,$t=class{constructor(){this.message=l("p",{class:"message",role:"alert",hidden:!0}),this.toast=l("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(t){this.message.textContent=t.message,this.message.hidden=!1,this.seen()||this.say(t.message,this.message.isConnected)}seen(){let{top:t,bottom:e,height:s}=this.
message.getBoundingClientRect();return this.message.isConnected&&s>0&&t>=0&&e<=innerHeight}clear(){this.message.hidden=!0}say(t,e=!1){this.toast.setAttribute("r\
ole",e?"presentation":"status"),this.toast.textContent=t,this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},Js)}};var I=52,ie=10,P=8,Zs=30,Qs={solid:[],dash:[6,4],dot:[2,3]},Rt=class{films;active;look;box;range;heights;picked;named;values;constructor({key:t,title:e,unit:s,curves:i,
limits:o,symmetric:r=!1},h){this.key=t,this.title=e,this.unit=s,this.curves=i,this.limits=o,this.symmetric=r,this.shared=h,this.canvas=l("canvas",{class:"plot-c\
anvas"}),this.over=l("canvas",{class:"plot-canvas plot-over"}),this.keys=l("div",{class:"plot-keys"}),this.body=l("div",{class:"plot-body",tabindex:"0",role:"im\
g","aria-label":e},this.canvas,this.over),this.element=l("section",{class:"plot","data-plot":t},l("header",{},l("h3",{},e),this.keys),this.body),this.body.addEventListener(
"pointerdown",a=>this.press(a)),this.pinched=R(this.body,{zoom:(a,c)=>this.films&&this.zoomAbout(c?this.valueAt(c):this.middle(),1/a),home:()=>this.zoomTo(null),
keys:!0}),this.onseek=()=>{}}abscissa(t){return this.shared.axis==="time"?t.columns.t:t.derived("degrees",({angle:e})=>Float64Array.from(e,s=>s*180/Math.PI))}fullRange(){
if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.duration),1e-9)];let[t,e]=[1/0,-1/0];for(let s of this.films)for(let i of this.abscissa(s))
i<t&&(t=i),i>e&&(e=i);return e>t?[t,e]:[t-1,e+1]}draw(t,e,s,i){this.films=t,this.active=e,this.look=s;let{context:o,width:r,height:h}=_(this.canvas);this.box={width:r-
I-ie,height:h-P-Zs},o.clearRect(0,0,r,h),this.range=this.shared.range??this.fullRange();let a=t.flatMap((c,d)=>this.shades(c).map(p=>({...p,film:c,lane:d})));this.
heights=this.limits??this.findHeights(a),this.shared.axis==="time"&&this.bands(o,t[e],i),this.grid(o,s,r,h),o.save(),o.beginPath(),o.rect(I,P,this.box.width,this.
box.height),o.clip();for(let c of a)this.curve(o,c,t.length>1);o.restore(),this.legend(this.shades(t[e]),s.dark),this.describe(a)}shades(t){return this.curves(t).
map(e=>({...e,color:e.color&&dt(e.color,this.look.dark)}))}x(t){return I+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return P+(1-(t-this.
heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(t){let e=[];for(let{film:d,values:p}of t){let f=this.abscissa(d);for(let u=0;u<p.length;u++)
f[u]>=this.range[0]&&f[u]<=this.range[1]&&Number.isFinite(p[u])&&e.push(p[u])}if(!e.length)return[0,1];let s=Float64Array.from(e).sort(),[i,o]=[s[0],s[s.length-
1]],[r,h]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],a=Math.max(h-r,1e-12);o>h+4*a&&(o=h+.6*a),i<r-4*a&&(i=r-.6*a),i=Math.min(i,0),o=Math.max(o,
0),this.symmetric&&([i,o]=[-Math.max(-i,o),Math.max(-i,o)]);let c=.06*(o-i)||1;return[i<0?i-c:i,o+c]}bands(t,e,s){for(let i of e.phases){let o=b(this.x(i.from),
I,I+this.box.width),r=b(this.x(i.to),I,I+this.box.width);r<=o||(t.fillStyle=it(s.modes[i.mode],.14),t.fillRect(o,P,r-o,this.box.height))}}grid(t,e,s,i){t.font=`\
11px ${e.font}`,t.strokeStyle=e.line,t.fillStyle=e.soft,t.lineWidth=1;let o=Math.max(this.box.height/28,4);for(;N(this.heights[0],this.heights[1],o).length<3&&o<
12;)o+=1;let r=E(this.heights[1]-this.heights[0],o);t.textAlign="right",t.textBaseline="middle";for(let d of N(this.heights[0],this.heights[1],o)){let p=Math.round(
this.y(d))+.5;t.globalAlpha=Math.abs(d)<1e-9*r?1:.55,t.beginPath(),t.moveTo(I,p),t.lineTo(s-ie,p),t.stroke(),t.globalAlpha=1,t.fillText($(d,r),I-6,p)}let h=this.
box.width/70,a=E(this.range[1]-this.range[0],h);t.textAlign="center",t.textBaseline="alphabetic";let c=this.shared.axis==="time"?"time [s]":"angle [°]";for(let d of N(
this.range[0],this.range[1],h)){let p=this.x(d);t.beginPath(),t.moveTo(p,P+this.box.height),t.lineTo(p,P+this.box.height+4),t.stroke(),t.fillText($(d,a),p,P+this.
box.height+15)}t.textAlign="right",t.fillText(c,s-ie,i-3),t.save(),t.translate(11,P+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText(this.
unit,0,0),t.restore()}curve(t,{film:e,lane:s,values:i,color:o,dash:r},h){let a=this.abscissa(e);t.strokeStyle=o??this.look.ink,t.lineWidth=h&&s===1?1.2:1.8,t.setLineDash(
h&&s===1?[3,3]:Qs[r??"solid"]),t.globalAlpha=h&&s===1?.85:1,t.beginPath();let c=!1;for(let d=0;d<i.length;d++){if(!Number.isFinite(i[d])||!Number.isFinite(a[d])){
c=!1;continue}let p=this.x(a[d]),f=b(this.y(i[d]),-1e4,1e4);c?t.lineTo(p,f):t.moveTo(p,f),c=!0}t.stroke(),t.setLineDash([]),t.globalAlpha=1}legend(t,e){let s=t.
map(i=>i.name).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>l("span",{class:"value"})),this.keys.replaceChildren(...t.map((i,o)=>l("span",{class:"\
plot-key"},oe(i.color,i.dash),i.name," ",this.values[o]))))}describe(t){let e=t.slice(0,6).map(({name:s,values:i,lane:o})=>{let[r,h]=[1/0,-1/0];for(let c of i)c<
r&&(r=c),c>h&&(h=c);let a=this.films.length>1?`${"AB"[o]}: `:"";return h>=r?`${a}${s} from ${x(r,3)} to ${x(h,3)}`:""});this.body.setAttribute("aria-label",`${this.
title} in ${this.unit}. ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.films)return;let{context:e,width:s,height:i}=_(this.over);if(e.clearRect(0,0,s,i),
this.films.forEach((o,r)=>{let h=o.at(t),a=this.x(this.shared.axis==="time"?h.t:h.angle*180/Math.PI),c=a>=I-1&&a<=I+this.box.width+1,d=o.index(h.t),p=Math.min(d+
1,o.length-1),f=o.t[p]>o.t[d]?(h.t-o.t[d])/(o.t[p]-o.t[d]):0;c&&(e.strokeStyle=this.look.soft,e.lineWidth=1,e.beginPath(),e.moveTo(a,P),e.lineTo(a,P+this.box.height),
e.stroke()),this.shades(o).forEach((u,m)=>{let w=u.values[p],g=Number.isFinite(w)?u.values[d]+f*(w-u.values[d]):u.values[d];r===this.active&&this.values?.[m]&&(this.
values[m].textContent=x(g,3));let y=this.y(g);!c||!(y>=P-1&&y<=P+this.box.height+1)||(e.fillStyle=u.color??this.look.ink,e.beginPath(),e.arc(a,y,3.2,0,2*Math.PI),
e.fill())})}),this.picked){let[o,r]=this.picked;e.fillStyle=it("#0072B2",.2),e.fillRect(Math.min(o,r),P,Math.abs(r-o),this.box.height)}}valueAt(t){let e=this.body.
getBoundingClientRect(),s=b((t.clientX-e.left-I)/this.box.width,0,1);return this.range[0]+s*(this.range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.
body.getBoundingClientRect(),s=t.clientX-e.left,i=this.valueAt(t),o=this.pinched(),r=h=>{if(o||=this.pinched(),o)return;let a=h.clientX-e.left;this.picked=t.pointerType===
"mouse"&&Math.abs(a-s)>5?[s,a]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(h)),this.cursor(this.shared.clock.time)};O(this.body,t,r,(h,a)=>{let c=this.
valueAt(h),{picked:d}=this;this.picked=null,d&&a?this.zoomTo(i<c?[i,c]:[c,i]):d?this.cursor(this.shared.clock.time):a&&!o&&this.seek(t.pointerType==="mouse"?i:c)})}seek(t){
if(this.shared.axis==="time")return this.onseek(t);let e=this.films[this.active],s=this.abscissa(e),i=0;for(let o=0;o<s.length;o++)Math.abs(s[o]-t)<Math.abs(s[i]-
t)&&(i=o);return this.onseek(e.t[i])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(t,e){let s=this.fullRange(),i=Math.max(t-(t-this.range[0])*e,s[0]),
o=Math.min(t+(this.range[1]-t)*e,s[1]);this.zoomTo(i<=s[0]&&o>=s[1]?null:[i,o])}zoomTo(t){this.shared.range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}};function oe(n,t="\
solid"){let e=l("i",{class:"swatch","aria-hidden":"true"});return e.style.borderTopColor=n??"var(--ink)",e.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"\
dotted"}[t],e}var U=52,Be=10,M=8,ti=30,ei="RSKHM?",It=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(t,e,s){this.backend=
t,this.clock=e,this.colors=s,this.canvas=l("canvas",{class:"plot-canvas"}),this.over=l("canvas",{class:"plot-canvas plot-over"}),this.keys=l("div",{class:"plot-\
keys"}),this.body=l("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=l("section",{class:"phase"},l("header",{},l("h3",{},"Plane of θ and θ̇"),this.keys),this.body,l("p",{class:"hint"},
`Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox. Click to go there; ${Z("")}.`)),this.body.addEventListener(
"pointerdown",i=>this.seek(i)),this.pinched=R(this.body,{zoom:(i,o)=>this.box&&this.zoomAbout(o?this.point(o):this.middle(),1/i),home:()=>this.zoomTo(null),keys:!0}),
this.range=[0,2*Math.PI],this.asked="",this.soon=H(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),i=JSON.stringify([t.hoop,t.plane,s]);if(i!==this.
asked){let o=await this.painted(t,[0,2*Math.PI,-s,s],e);this.asked=i,this.pictures=[o],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.
pictures||!this.window)){this.sharpening?.abort(),this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,[...this.range,
...this.window],this.sharpening.signal);this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){let{header:i,
arrays:o}=await this.backend.call("regions",{scenario:t,window:e},s);return{window:i.window,paradox:o.paradox,picture:this.paint(o.modes,i.arrays[0].shape)}}reach(){
return this.reached}findReach(){let t=0;for(let s of this.films??[]){let i=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(
t,i[Math.floor(.99*(i.length-1))]??0)}let e=E(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}zoomTo(t){this.range=t??[0,2*Math.PI],this.window=null,
this.pictures?.splice(1),this.redraw()}point(t){let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left-U)/this.box.width,i=1-(t.clientY-e.top-M)/this.box.height;
return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+i*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.bottom()+
this.top())]}zoomAbout([t,e],s){let i=Math.max(t-(t-this.range[0])*s,0),o=Math.min(t+(this.range[1]-t)*s,2*Math.PI),r=this.reach(),h=Math.max(e-(e-this.bottom())*
s,-r),a=Math.min(e+(this.top()-e)*s,r);this.range=[i,o],this.window=o-i<2*Math.PI-1e-9||a-h<2*r-1e-9?[h,a]:null,this.redraw(),this.soon()}bottom(){return this.window?
this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){this.films=t,this.
active=e,this.look=s,this.reached=this.findReach(),this.forwards=t.some(i=>i.columns.omega.some(o=>o>.3)),this.backwards=t.some(i=>i.columns.omega.some(o=>o<-.3)),
!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(t){return U+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return M+(1-
(t-this.bottom())/(this.top()-this.bottom()))*this.box.height}paint(t,[e,s]){let{modes:i}=this.colors,o=l("canvas",{width:s,height:e}),r=new ImageData(s,e);for(let h=0;h<
e;h++)for(let a=0;a<s;a++){let c=ei[t[h*s+a]],d=B(i[c]??"#6E6E6E"),p=4*((e-1-h)*s+a);r.data.set([...d,255],p)}return D(o).putImageData(r,0,0),o}redraw(){if(!this.
films)return;let{colors:t,look:e}=this,{context:s,width:i,height:o}=_(this.canvas);if(this.box={width:i-U-Be,height:o-M-ti},s.clearRect(0,0,i,o),s.save(),s.beginPath(),
s.rect(U,M,this.box.width,this.box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:r,window:h}of this.pictures){let[a,c,d,p]=h,f=[this.
x(a),this.y(p),this.x(c)-this.x(a),this.y(d)-this.y(p)];s.fillStyle=e.panel,s.fillRect(f[0],f[1],f[2],f[3]),s.globalAlpha=.35,s.drawImage(r,f[0],f[1],f[2],f[3]),
s.globalAlpha=1}this.hatch(s)}for(let[r,h]of this.films.entries())this.way(s,h,r);if(s.restore(),this.axes(s,i,o),this.keyed!==e.dark){this.keyed=e.dark;let r=Object.
entries(t.mode_names).filter(([h])=>"RSKH".includes(h));this.keys.replaceChildren(...r.map(([h,a])=>l("span",{class:"plot-key"},oe(t.modes[h]),a)))}this.cursor(
this.clock.time)}hatch(t){let{paradox:e}=this.pictures[0],s=e.length;t.strokeStyle=it(this.look.dark?"#ffffff":"#000000",.28),t.lineWidth=1;for(let i=0;i<s;i++){
if(!e[i])continue;let o=i;for(;o<s&&e[o]===e[i];)o++;let r=this.x(i*2*Math.PI/s),h=this.x(o*2*Math.PI/s);t.save(),t.beginPath(),t.rect(r,M,h-r,this.box.height),
t.clip(),t.beginPath();let a=e[i];for(let c=-this.box.height;c<h-r+this.box.height;c+=7)t.moveTo(r+c,a>0?M+this.box.height:M),t.lineTo(r+c+this.box.height,a>0?M:
M+this.box.height);t.stroke(),t.restore(),i=o}}way(t,e,s){let{angle:i,omega:o,mode:r}=e.columns,h=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=
this.look.ink,t.beginPath();let a=null;for(let c=0;c<e.length;c++){if(!Number.isFinite(o[c])){a=null;continue}let d=Math.floor(i[c]/h),p=i[c]-d*h;if(a===null)t.
moveTo(this.x(p),this.y(o[c]));else if(d!==a.lap){let f=d>a.lap?h:0;t.lineTo(this.x(f),this.y(o[c])),t.moveTo(this.x(h-f),this.y(o[c])),t.lineTo(this.x(p),this.
y(o[c]))}else t.lineTo(this.x(p),this.y(o[c]));a={lap:d,mode:r[c]}}t.stroke(),t.setLineDash([])}axes(t,e,s){let{look:i}=this;t.font=`11px ${i.font}`,t.strokeStyle=
i.soft,t.fillStyle=i.soft,t.lineWidth=1,t.strokeRect(U+.5,M+.5,this.box.width-1,this.box.height-1),t.textAlign="center";let o=this.range[0]*180/Math.PI,r=this.range[1]*
180/Math.PI,h=r-o>200?45:E(r-o,6);for(let c=Math.ceil(o/h-1e-9);c*h<=r+1e-9;c++){let d=this.x(c*h*Math.PI/180);t.beginPath(),t.moveTo(d,M+this.box.height),t.lineTo(
d,M+this.box.height+4),t.stroke(),t.fillText($(c*h,h),d,M+this.box.height+15)}t.textAlign="right",t.fillText("angle θ within a turn [°]",e-Be,s-3),t.textBaseline=
"middle";let a=this.top()-this.bottom();for(let c of N(this.bottom(),this.top(),5))t.fillText($(c,E(a,5)),U-6,this.y(c));t.textBaseline="alphabetic",t.save(),t.
translate(11,M+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText("θ̇ [rad/s]",0,0),t.restore()}cursor(t){if(!this.films||!this.box)return;
let{context:e,width:s,height:i}=_(this.over);e.clearRect(0,0,s,i),this.films.forEach((o,r)=>{let h=o.at(t),a=2*Math.PI,c=h.angle-Math.floor(h.angle/a)*a,d=this.
x(c),p=this.y(h.omega);d>=U&&d<=U+this.box.width&&p>=M&&p<=M+this.box.height&&(e.beginPath(),e.arc(d,p,r?4:5.5,0,2*Math.PI),e.fillStyle=this.colors.modes[h.mode],
e.fill(),e.lineWidth=2,e.strokeStyle=this.look.ink,e.stroke())})}seek(t){let e=this.body.getBoundingClientRect(),[s,i]=[t.clientX-e.left,t.clientY-e.top];if(this.
pinched())return;let o=this.films[this.active],{angle:r,omega:h}=o.columns,a=2*Math.PI,c={distance:1/0,t:0};for(let d=0;d<o.length;d++){let p=r[d]-Math.floor(r[d]/
a)*a,f=Math.hypot(this.x(p)-s,this.y(h[d])-i);f<c.distance&&(c={distance:f,t:o.t[d]})}c.distance<40&&this.clock.seek(b(c.t,0,o.duration))}};function si(n){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:t=>[{name:"v (centre)",color:n.center_speed,values:t.columns.vx},{name:"\
R θ̇",color:n.rotation_speed,dash:"dash",values:t.derived("spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:t=>[{name:"kinetic",color:n.kinetic,values:t.columns.kinetic},{name:"potential",color:n.potential,values:t.columns.potential},{name:"\
total",values:t.derived("total",({t:e,kinetic:s,potential:i})=>Float64Array.from(e,(o,r)=>s[r]+i[r])),dash:"dash"},{name:"lost to friction",color:n.friction_loss,
values:t.columns.friction_loss},{name:t.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:n.impact_loss,values:t.columns.
normal_loss,dash:"dot"}]},{key:"forces",title:"Contact forces",unit:"force [N]",curves:t=>[{name:"normal N",color:n.normal_force,values:t.columns.normal_force},
{name:"friction F",color:n.friction_force,dash:"dash",values:t.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],
curves:t=>[{name:"|F| / μN",color:n.friction_force,values:t.columns.utilization}]}]}var zt=class{films;active;look;constructor(t,e){this.colors=e,this.shared={
axis:"time",range:null,clock:t,changed:()=>this.redraw()},this.plots=si(e).map(i=>new Rt(i,this.shared));for(let i of this.plots)i.onseek=o=>t.seek(o);this.seen=
new Map(this.plots.map(i=>[i.element,!0]));let s=new IntersectionObserver(i=>{for(let{target:o,isIntersecting:r}of i)this.seen.set(o,r);this.redraw()},{rootMargin:"\
400px"});for(let i of this.plots)s.observe(i.element);this.axis=l("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.
value,this.shared.range=null,this.redraw()}},l("option",{value:"time"},"over time"),l("option",{value:"angle"},"over angle")),this.back=l("button",{type:"button",
hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=l("span",{class:"hint"}),this.element=l("div",{class:"plots"},l("div",{class:"plots-\
head"},this.axis,this.back,this.hint),this.plots.map(i=>i.element))}draw(t,e,s){this.films=t,this.active=e,this.look=s;let i=matchMedia("(hover: none)").matches?
"slide to go there, two fingers zoom":`click to go there, drag to zoom; ${Z("")}`;this.hint.textContent=t.length>1?`A full, B dotted; numbers and colours of ${"\
AB"[e]}; ${i}`:i,this.redraw()}redraw(){if(this.films?.length){this.back.hidden=!this.shared.range;for(let t of this.visible())t.draw(this.films,this.active,this.
look,this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.plots.filter(t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())e.cursor(
t)}};var ii=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],Nt=class{constructor(t){this.lab=t,this.menu=l("details",{class:"menu"},l("summary",{class:"button"},"Keep"),l("div",{class:"menu-body"},t.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),ii.map(([e,s])=>this.item(s,()=>this.download(e))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=l("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),t.root.addEventListener("pointerdown",e=>{this.menu.contains(e.target)||(this.menu.open=!1)})}item(t,e){return l("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await e()}catch(s){this.lab.notice.fail(s)}}},t)}async copyLink(){let t=this.lab.link()??"";try{await navigator.clipboard.writeText(t),this.
lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",t)}}async download(t){let e=this.lab.film();this.lab.notice.say(t.endsWith("mp4")?
"The film is being made; this takes a while …":`Fetching ${t} …`),ut(await this.lab.backend.file(t,e.query),`hophoop-${t}`),this.lab.notice.say(`${t} is the\
re.`)}picture(){this.lab.drawStage();let t=this.lab.stage.canvas(),e=l("canvas",{width:t.width,height:t.height});return this.copyInto(e),new Promise(s=>{e.toBlob(
i=>{i&&ut(i,"hophoop.png"),s()},"image/png")})}copyInto(t){let{lab:e}=this,s=e.stage.canvas(),i=D(t);i.fillStyle=e.theme.look.paper,i.fillRect(0,0,t.width,t.height),
i.drawImage(s,0,0,t.width,t.height);let o=t.width/Math.max(s.getBoundingClientRect().width,1);i.textBaseline="top",i.textAlign="left";let r=e.films();for(let[h,
a]of r.entries()){let c=a.at(e.clock.time),d=[r.length>1?`${"AB"[h]}: `:"",`${e.theme.colors.mode_names[c.mode]}, t = ${c.t.toFixed(3)} s, θ = ${G(c.angle)}, v\
 = ${x(c.vx,3)} m/s`].join(""),p=e.stage.options.three?10+20*h:10+h*s.getBoundingClientRect().height/r.length;i.fillStyle=e.theme.colors.modes[c.mode],i.fillRect(
12*o,(p+2)*o,11*o,11*o),i.fillStyle=e.theme.look.ink,i.font=`${13*o}px ${e.theme.look.font}`,i.fillText(d,30*o,p*o)}}async record(){let{lab:t}=this,e=t.stage.canvas();
if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 instead.");let s=l("canvas",{width:2*Math.ceil(
e.width/2),height:2*Math.ceil(e.height/2)}),i=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),o=[];i.ondataavailable=a=>o.push(a.data);let r=new Promise(
a=>i.onstop=a),h=t.clock.loop;t.clock.loop=!1,t.clock.seek(0),t.notice.say("Recording one run …"),t.afterFrame=()=>{this.copyInto(s),!t.clock.playing&&i.state===
"recording"&&i.stop()},i.start(),t.clock.play(!0),await r,t.afterFrame=null,t.clock.loop=h,ut(new Blob(o,{type:i.mimeType}),"hophoop.webm"),t.notice.say("The fi\
lm is there.")}async code(){let{header:t}=await this.lab.backend.call("code",{scenario:this.lab.film().scenario});this.show("The same motion in Python",t.python,
"The scenario as a file",t.toml)}show(...t){let e=[];for(let s=0;s<t.length;s+=2){let i=t[s+1],o=l("button",{type:"button"},"Copy");o.onclick=async()=>{await navigator.
clipboard?.writeText(i).catch(()=>{}),o.textContent="Copied"},e.push(l("header",{},l("h2",{},t[s]),o),l("pre",{tabindex:"0"},l("code",{},i)))}this.dialog.replaceChildren(
...e,l("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};function De(n,t){let e=l("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([i])=>{let o=!i.isIntersecting&&i.boundingClientRect.top<0;if(o===
n.classList.contains("stuck"))return;let r=n.offsetHeight;n.style.marginBottom="",n.classList.toggle("stuck",o),o&&(n.style.marginBottom=`${r-n.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=o?`${n.offsetHeight}px`:"",t()});return s.observe(e),{edge:e,close:()=>s.disconnect()}}var He=120,Lt=class{constructor(t,e){this.canvas=t,this.onview=e,this.zoom=1,this.shift=[0,0],t.addEventListener("pointerdown",s=>this.drag(s)),this.pinched=R(t,
{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>t.parentElement})}reset(){this.zoom=1,this.shift=[0,0],this.onview()}zoomBy(t){this.zoom=b(this.zoom*t,
.05,60),this.onview()}drag(t){let e=[t.clientX,t.clientY],s=this.shift;O(this.canvas,t,i=>{this.pinched()||(this.shift=[s[0]+i.clientX-e[0],s[1]+i.clientY-e[1]],
this.onview())})}draw(t,e,s,i,o){let{context:r,width:h,height:a}=_(this.canvas);if(r.clearRect(0,0,h,a),h<40||a<40)return;let c=a/t.length,d={top:Math.max(...t.
map(p=>p.extent.top)),radius:Math.max(...t.map(p=>p.radius)),speed:Math.max(...t.map(p=>p.extent.speed))};t.forEach((p,f)=>{r.save(),r.beginPath(),r.rect(0,f*c,
h,c),r.clip(),r.translate(0,f*c),new ne(r,h,c,p,e,s,i,o,this.zoom,this.shift,d).draw(),t.length>1&&(r.fillStyle=i.soft,r.font=`600 15px ${i.font}`,r.textAlign="\
left",r.fillText("AB"[f],12,c-12)),r.restore(),f>0&&(r.fillStyle=i.line,r.fillRect(0,f*c-.5,h,1))})}},ne=class{constructor(t,e,s,i,o,r,h,a,c,d,p){this.context=t,
this.width=e,this.height=s,this.film=i,this.options=r,this.look=h,this.colors=a,this.common=p,this.pose=i.at(o);let f=i.radius,{left:u,right:m}=i.extent,{top:w}=p;
this.cosine=Math.cos(i.slope),this.sine=Math.sin(i.slope);let g=2*p.radius+Math.min(w,6*p.radius),y=Math.min(.66*s/g,.36*e/p.radius);if(r.whole){let v=(m-u)*this.
cosine+2.6*f,k=(m-u)*Math.abs(this.sine)+2.6*f+w;this.scale=Math.min(e/v,.86*s/k,y)*c,this.focus=[.5*(u+m),0],this.place=[.5*e+d[0],(i.slope?.62:.8)*s+d[1]]}else
this.scale=y*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.place=[(e<520?.6:.46)*e+d[0],.82*s+d[1]]}point(t,e){let s=t-this.focus[0],i=e-this.
focus[1];return[this.place[0]+this.scale*(s*this.cosine+i*this.sine),this.place[1]-this.scale*(i*this.cosine-s*this.sine)]}draw(){this.ground(),this.options.traces&&
this.traces(),this.hoop(),this.options.forces&&this.forces()}ground(){let{context:t,look:e,width:s,height:i}=this,o=(Math.hypot(s,i)*1.2+Math.abs(this.place[0])+
Math.abs(this.place[1]))/this.scale,[r,h]=this.point(this.focus[0]-o,0),[a,c]=this.point(this.focus[0]+o,0),d=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,
t.beginPath(),t.moveTo(r,h),t.lineTo(a,c),t.lineTo(a+d[0],c+d[1]),t.lineTo(r+d[0],h+d[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(r,
h),t.lineTo(a,c),t.stroke();let p=E(s/this.scale,s/90);t.fillStyle=e.soft,t.font=`11px ${e.font}`,t.textAlign="center",t.lineWidth=1;let f=Math.ceil((this.focus[0]-
o)/p),u=Math.min(Math.floor((this.focus[0]+o)/p),f+400);for(let m=f;m<=u;m++){let[w,g]=this.point(m*p,0);w<-40||w>s+40||(t.beginPath(),t.moveTo(w,g),t.lineTo(w-
6*this.sine,g+6*this.cosine),t.stroke(),t.fillText(`${$(m*p,p)} m`,w-18*this.sine,g+8+10*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:i}=this,o=t.
index(this.pose.t),r=t.radius,{x:h,height:a,angle:c,mode:d}=t.columns,p=(f,u,m,w)=>{e.strokeStyle=u,e.lineWidth=m,e.lineJoin="round",e.beginPath();let g=!1,y=(v,k,S)=>{
let[z,C]=this.point(v+f*Math.sin(S),r+k+f*Math.cos(S));g?e.lineTo(z,C):e.moveTo(z,C),g=!0};for(let v=0;v<=o;v++)w===void 0||d[v]===3===w?y(h[v],a[v],c[v]):g=!1;
(w===void 0||this.pose.mode==="H"===w)&&y(this.pose.x,this.pose.height,this.pose.angle),e.stroke()};p(r,s.ink,1.3),p(t.eccentricity*r,i.gravity_center,1.8,!1),p(
t.eccentricity*r,i.airborne,2.4,!0)}hoop(){let{film:t,pose:e,context:s,look:i,colors:o,scale:r}=this,h=t.radius,a=b(.07*h*r,2,14),c=h-.5*a/r,d=[e.x,h+e.height],
p=(g,y=c)=>this.point(d[0]+y*Math.sin(g),d[1]+y*Math.cos(g));if(s.lineCap="butt",i.dark&&(s.strokeStyle=i.soft,s.lineWidth=a+2,s.beginPath(),s.arc(...this.point(
d[0],d[1]),c*r,0,2*Math.PI),s.stroke()),this.options.speed){let g=this.common.speed;s.lineWidth=a;let y=2*Math.PI/He;for(let v=0;v<He;v++){let k=e.angle+v*y,S=Math.
hypot(e.vx+h*e.omega*Math.cos(k+.5*y),e.vy-h*e.omega*Math.sin(k+.5*y));s.strokeStyle=pt[b(Math.round(255*S/g)||0,0,255)],s.beginPath(),s.moveTo(...p(k-.04*y)),s.
lineTo(...p(k+1.04*y)),s.stroke()}}else s.strokeStyle=o.modes[e.mode],s.lineWidth=a,s.beginPath(),s.arc(...this.point(d[0],d[1]),c*r,0,2*Math.PI),s.stroke();s.strokeStyle=
i.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(d[0],d[1])),s.lineTo(...p(e.angle)),s.stroke();let f=(g,y,v,k)=>{s.beginPath(),s.arc(...g,y,0,2*Math.PI),
s.fillStyle=v,s.fill(),s.lineWidth=1.5,s.strokeStyle=k,s.stroke()};f(this.point(d[0],d[1]),2.5,i.soft,i.soft);let u=t.scenario.hoop.parts;u?this.parts(u,d):f(p(
e.angle),b(.1*h*r,4,16),i.ink,i.paper);let m=t.eccentricity*h,w=this.point(d[0]+m*Math.sin(e.angle),d[1]+m*Math.cos(e.angle));f(w,b(.05*h*r,3.5,7),e.mode==="H"?
o.airborne:o.gravity_center,i.paper)}parts(t,e){let{film:s,pose:i,context:o,look:r,scale:h}=this,c=t.reduce((d,p)=>d+p.mass*(p.at??0),0)<0?-1:1;o.strokeStyle=r.
ink;for(let d of t){let p=c*(d.at??0),f=this.point(e[0]+p*Math.sin(i.angle),e[1]+p*Math.cos(i.angle));if(o.fillStyle=r.ink,o.lineWidth=1,o.beginPath(),d.shape===
"ring")o.globalAlpha=.22,o.arc(...f,d.outer_radius*h,0,2*Math.PI),o.arc(...f,d.inner_radius*h,0,2*Math.PI,!0),o.fill(),o.globalAlpha=1;else if(d.shape==="rod"){
let u=.5*d.length,m=w=>this.point(e[0]+w*Math.sin(i.angle),e[1]+w*Math.cos(i.angle));o.lineWidth=4,o.moveTo(...m(p-u)),o.lineTo(...m(p+u)),o.stroke()}else{let u=d.
shape==="disk"?d.radius*h:b(.08*s.radius*h,3,12);o.globalAlpha=d.shape==="disk"?.55:1,o.arc(...f,u,0,2*Math.PI),o.fill(),o.globalAlpha=1}}}forces(){let{film:t,pose:e,
colors:s}=this,i=t.radius,o=t.mass*(t.gravity||9.81),r=a=>.55*i*a/o;if(e.mode==="H"||!(e.normal_force>0))return;let h=[e.x,e.height];this.arrow(h,[0,r(e.normal_force)],
s.normal_force,`N = ${x(e.normal_force,3)} N`,!1),this.arrow(h,[r(e.friction_force),0],s.friction_force,`F = ${x(e.friction_force,3)} N`,!0)}arrow([t,e],[s,i],o,r,h){
let{context:a,look:c,width:d}=this,p=2.2*this.film.radius,f=Math.abs(s)>p||Math.abs(i)>p;[s,i]=[b(s,-p,p),b(i,-p,p)];let u=this.point(t,e),m=this.point(t+s,e+i),
w=Math.hypot(m[0]-u[0],m[1]-u[1]);if(w<2)return;let g=(m[0]-u[0])/w,y=(m[1]-u[1])/w,v=Math.min(11,w);for(let[z,C]of[[c.paper,6],[o,3]])a.strokeStyle=z,a.fillStyle=
z,a.lineWidth=C,a.beginPath(),a.moveTo(...u),a.lineTo(m[0]-g*v,m[1]-y*v),a.stroke();if(a.beginPath(),a.moveTo(...m),a.lineTo(m[0]-g*v-y*v*.5,m[1]-y*v+g*v*.5),a.
lineTo(m[0]-g*v+y*v*.5,m[1]-y*v-g*v*.5),a.fill(),f){let[z,C]=[u[0]+.55*g*w,u[1]+.55*y*w];a.strokeStyle=c.paper,a.lineWidth=2,a.beginPath();for(let ct of[-3,3])a.
moveTo(z+g*(ct-3)-y*7,C+y*(ct-3)+g*7),a.lineTo(z+g*(ct+3)+y*7,C+y*(ct+3)-g*7);a.stroke()}a.font=`600 12px ${c.font}`;let k=a.measureText(r).width;a.lineWidth=3,
a.strokeStyle=h?c.ground:c.paper,a.textAlign="left";let S=h?[u[0]-.5*k-32*this.sine,u[1]+32*this.cosine]:[m[0]+12,b(m[1]+4,16,u[1]-.36*this.film.radius*this.scale)];
S[0]=b(S[0],4,d-k-4),a.strokeText(r,S[0],S[1]),a.fillText(r,S[0],S[1])}};function ae(n,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let i=0;i<4;i++){let o=0;for(let r=0;r<4;r++)o+=n[4*r+i]*t[4*s+r];e[4*s+i]=o}return e}function Ue(n,t,e,s){
let i=1/Math.tan(n/2),o=1/(e-s);return new Float32Array([i/t,0,0,0,0,i,0,0,0,0,(s+e)*o,-1,0,0,2*s*e*o,0])}function je(n,t){let e=X(he(n,t)),s=X(Ct([0,1,0],e)),i=Ct(
e,s);return new Float32Array([s[0],i[0],e[0],0,s[1],i[1],e[1],0,s[2],i[2],e[2],0,-re(s,n),-re(i,n),-re(e,n),1])}var he=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],re=(n,t)=>n[0]*
t[0]+n[1]*t[1]+n[2]*t[2],Ct=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]];function X(n){let t=Math.hypot(...n)||1;return[n[0]/t,n[1]/t,n[2]/
t]}function Ft(n,t,e,s){let i=X(t),o=X(Ct(i,Math.abs(i[2])>.9?[1,0,0]:[0,0,1])),r=Ct(o,i);return new Float32Array([...o.map(h=>h*s),0,...i.map(h=>h*e),0,...r.map(
h=>h*s),0,...n,1])}function ce(n){let[t,e]=[Math.cos(n),Math.sin(n)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function L(n){let t=Number.parseInt(n.slice(1,7),16);
return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function tt(n,t,e){let s=n.createProgram(),i=[[n.VERTEX_SHADER,t],[n.FRAGMENT_SHADER,e]];for(let[r,h]of i){let a=n.createShader(r);if(n.shaderSource(a,h),n.compileShader(
a),!n.getShaderParameter(a,n.COMPILE_STATUS))throw new Error(String(n.getShaderInfoLog(a)));n.attachShader(s,a)}if(n.linkProgram(s),!n.getProgramParameter(s,n.LINK_STATUS))
throw new Error(String(n.getProgramInfoLog(s)));let o={program:s,uniforms:{},attributes:{}};for(let r=0;r<n.getProgramParameter(s,n.ACTIVE_UNIFORMS);r++){let{name:h}=n.
getActiveUniform(s,r);o.uniforms[h]=n.getUniformLocation(s,h)}for(let r=0;r<n.getProgramParameter(s,n.ACTIVE_ATTRIBUTES);r++){let{name:h}=n.getActiveAttrib(s,r);
o.attributes[h]=n.getAttribLocation(s,h)}return o}function K(n,t,e,s){let i=n.createBuffer();n.bindBuffer(n.ARRAY_BUFFER,i),n.bufferData(n.ARRAY_BUFFER,new Float32Array(
t),n.STATIC_DRAW);let o=s?n.createBuffer():null;s&&(n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,o),n.bufferData(n.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),n.STATIC_DRAW));
let r=4*Object.values(e).reduce((h,a)=>h+a,0);return{vertices:i,elements:o,parts:e,stride:r,count:s?s.length:4*t.length/r}}function et(n,t,e){n.bindBuffer(n.ARRAY_BUFFER,
e.vertices);let s=0;for(let[i,o]of Object.entries(e.parts)){let r=t.attributes[i];r!==void 0&&(n.enableVertexAttribArray(r),n.vertexAttribPointer(r,o,n.FLOAT,!1,
e.stride,s)),s+=4*o}e.elements&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.elements)}function le(n,t){let e=[];for(let s=0;s<n;s++)for(let i=0;i<t;i++){let o=s*(t+1)+
i,r=o+t+1;e.push(o,r,o+1,r,r+1,o+1)}return e}function We(n,t=120,e=14){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++)s.push(2*Math.PI*i/t,2*Math.PI*o/e);return K(
n,s,{bend:2},le(t,e))}function qe(n,t=28,e=18){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++){let[r,h]=[2*Math.PI*i/t,Math.PI*o/e],a=[Math.sin(h)*Math.cos(
r),Math.cos(h),Math.sin(h)*Math.sin(r)];s.push(...a,...a)}return K(n,s,{position:3,normal:3},le(t,e))}function de(n,t,e=20){let s=[];for(let i=0;i<=e;i++){let o=2*
Math.PI*i/e,r=[Math.cos(o),1-t,Math.sin(o)];s.push(Math.cos(o),0,Math.sin(o),...r,t*Math.cos(o),1,t*Math.sin(o),...r)}return K(n,s,{position:3,normal:3},le(e,1))}var Ge=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Ve=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Je="vec4(0.0, 0.0, 0.0, shadow)",Xe=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Ve}
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
   ${Ge}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Je} : vec4(shaded(color, n), 1.0);
   }`],Ke=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Ve}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${Ge}
   void main() { gl_FragColor = shadow > 0.0 ? ${Je} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],Ye=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],Ot=class{constructor(t,e,s,i,{keep:o=!1}={}){let r=t.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:o});if(!r)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=r,this.canvas=
t,this.sun=X(s),this.dark=i,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=tt(r,Xe[0],Xe[1]),this.body=tt(r,Ke[0],Ke[1]),this.line=tt(r,Ye[0],Ye[1]),this.torus=We(
r),this.sphere=qe(r),this.cylinder=de(r,1),this.cone=de(r,0),this.colors=r.createTexture(),r.bindTexture(r.TEXTURE_2D,this.colors);let h=new Uint8Array(e.flatMap(
a=>[...a,255]));r.pixelStorei(r.UNPACK_ALIGNMENT,1),r.texImage2D(r.TEXTURE_2D,0,r.RGBA,e.length,1,0,r.RGBA,r.UNSIGNED_BYTE,h);for(let a of[r.TEXTURE_WRAP_S,r.TEXTURE_WRAP_T])
r.texParameteri(r.TEXTURE_2D,a,r.CLAMP_TO_EDGE);for(let a of[r.TEXTURE_MIN_FILTER,r.TEXTURE_MAG_FILTER])r.texParameteri(r.TEXTURE_2D,a,r.LINEAR);this.view=ce(0),
this.eye=[0,0,1],this.fastest=1}begin({background:t,eye:e,target:s,slope:i,angle:o,near:r,far:h}){let{gl:a,canvas:c}=this;a.viewport(0,0,c.width,c.height),a.clearColor(
t[0],t[1],t[2],1),a.clear(a.COLOR_BUFFER_BIT|a.DEPTH_BUFFER_BIT|a.STENCIL_BUFFER_BIT),a.enable(a.DEPTH_TEST);let d=Ue(o,c.width/c.height,r,h);this.view=ae(ae(d,
je(e,s)),ce(i)),this.eye=X(he(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let i={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[
o,r]of Object.entries(i)){let h=t.uniforms[o];h!==void 0&&(typeof r=="number"?s.uniform1f(h,r):r.length===16?s.uniformMatrix4fv(h,!1,r):s[`uniform${r.length}fv`](
h,r))}}ground(t){let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,
e.ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),
e.depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:i=!1,lit:o=!0}={}){let{gl:r}=this;this.use(this.body,{model:e,color:s,shadow:i?
this.dark:0,lit:Number(o)}),et(r,this.body,t),r.drawElements(r.TRIANGLES,t.count,r.UNSIGNED_SHORT,0)}ball(t,e,s,i){this.solid(this.sphere,Ft(t,[0,1,0],e,e),s,{shadow:i})}ring({
center:t,radius:e,tube:s,broad:i,angle:o,velocity:r,omega:h,plain:a=null},c){let{gl:d}=this;this.use(this.rim,{center:t,size:[e,s,i,o],motion:[...r,h],most:this.
fastest,shadow:c?this.dark:0,plain:a??[0,0,0],colored:a?0:1}),et(d,this.rim,this.torus),d.drawElements(d.TRIANGLES,this.torus.count,d.UNSIGNED_SHORT,0)}rod(t,e,s,i,o,r=!1){
this.solid(this.cylinder,Ft(t,e,s,i),o,{shadow:r})}arrow(t,e,s,i,o){if(!(s>.02*i))return;let r=Math.min(.18*i,s),h=t.map((a,c)=>a+e[c]*(s-r));s>r&&this.rod(t,e,
s-r,.029*i,o),this.solid(this.cone,Ft(h,e,r,Math.min(.075*i,.6*r)),o)}trace(t,e,s){let i=[];for(let o=0;o<t;o++){let r=e(o),h=e(Math.min(o+1,t-1));if(Math.hypot(
h[0]-r[0],h[1]-r[1])<1e-9&&o>0){let a=e(o-1);h=r.map((c,d)=>2*c-a[d])}for(let a of[-1,1])i.push(...r,0,...h,0,...s(o),a)}return K(this.gl,i,{position:3,next:3,tint:3,
side:1})}drawTrace(t,e,{width:s,distance:i=0,shift:o,depth:r}){let{gl:h,canvas:a}=this;this.use(this.line,{pixel:[2/a.width,2/a.height],width:s,distance:i,shift:o,
depth:r}),et(h,this.line,t),h.drawArrays(h.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let i=this.view,[o,r,h]=[0,1,3].map(a=>i[a]*t+i[4+a]*e+i[8+a]*s+i[12+a]);return h>
0?[(.5+.5*o/h)*this.canvas.width,(.5-.5*r/h)*this.canvas.height]:null}};var oi=[.35,.85,.4],ni=.18,Ze={azimuth:.5,height:.22,distance:5.2},Qe=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],Bt=class{constructor(t,e){this.canvas=t,this.onview=e,this.space=new Ot(t,Y,oi,ni,{keep:!0}),this.floor=tt(this.space.gl,Qe[0],Qe[1]),this.corners=K(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...Ze},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,t.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=R(t,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>t.parentElement})}zoomBy(t){t?this.turned.distance=b(
this.turned.distance/t,1.6,60):this.turned={...Ze},this.onview()}drag(t){let e={...this.turned,x:t.clientX,y:t.clientY};O(this.canvas,t,s=>{this.pinched()||(this.
turned.azimuth=b(e.azimuth-(s.clientX-e.x)*.008,-1.5,1.5),this.turned.height=b(e.height+(s.clientY-e.y)*.006,.02,1.45),this.onview())})}quality(){let t=performance.
now(),e=t-(this.before||t);return this.before=t,e>0&&e<200&&(this.pace=.9*this.pace+.1*e),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(t,e,s,i,o,r){let{canvas:h,space:a}=this,c=Math.min(globalThis.devicePixelRatio||1,2)*(r?this.quality():1),d=h.getBoundingClientRect();h.
width=Math.max(Math.round(d.width*c),1),h.height=Math.max(Math.round(d.height*c),1);let p=t.map(m=>m.at(e)),f=t[0].radius;a.fastest=Math.max(...t.map(m=>m.extent.
speed)),this.focus=Number.isFinite(p[0].x)?p[0].x:0,a.begin({background:L(i.paper),...this.camera(t[0],p[0],f,s)}),a.ground(()=>this.drawFloor(f,i));let u=m=>{for(let[
w,g]of t.entries())m(g,p[w],-2.1*f*w)};a.shadows(()=>u((m,w,g)=>this.drawHoop(m,w,g,s,i,o,!0))),u((m,w,g)=>{this.drawHoop(m,w,g,s,i,o,!1),s.traces&&this.drawTraces(
m,w,g,i,o,c),s.forces&&this.drawForces(m,w,g,o)})}camera(t,e,s,i){let{azimuth:o,height:r,distance:h}=this.turned,{left:a,right:c}=t.extent,d=i.whole?Math.max(h*
s,.85*(c-a)+3*s):h*s,[p,f]=[i.whole?.5*(a+c)-this.focus:0,s+.45*(e.height||0)],u=Math.cos(t.slope),m=Math.sin(t.slope),w=[p*u+f*m,-p*m+f*u,0],g=[w[0]+d*Math.sin(
o)*Math.cos(r),w[1]+d*Math.sin(r),d*Math.cos(o)*Math.cos(r)];return this.reach=12*s+3*d,{eye:g,target:w,slope:t.slope,angle:.75,near:.05*s,far:40*s+6*d}}drawFloor(t,e){
let{space:s}=this,i=L(e.ground),o=i.map(a=>a*(e.dark?.82:.94)),r=.5*t,h=this.focus%(2*r);s.use(this.floor,{reach:this.reach,light:i,dark:o,far:L(e.paper),tile:r,
shift:h}),et(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(t,e,s,i,o,r,h){let{space:a}=this,c=t.radius,d=.045*c,p=[e.x-this.focus,
c+e.height,s];a.ring({center:p,radius:c,tube:d,broad:3.2*d,angle:e.angle,velocity:[e.vx,e.vy],omega:e.omega,plain:i.speed?null:L(r.modes[e.mode])},h);let f=[Math.
sin(e.angle),Math.cos(e.angle),0],u=w=>p.map((g,y)=>g+w*f[y]);a.ball(u(c-d),.125*c,o.dark?[.9,.91,.94]:[.12,.13,.15],h),a.rod(p,f,c-d,.012*c,[.55,.57,.6],h);let m=e.
mode==="H";a.ball(u(t.eccentricity*c),.07*c,L(m?r.airborne:r.gravity_center),h)}drawForces(t,e,s,i){if(e.mode==="H"||!(e.normal_force>0))return;let o=t.radius,r=t.
mass*(t.gravity||9.81),h=[e.x-this.focus,e.height+.03*o,s+.2*o],a=d=>b(.55*o*Math.abs(d)/r,0,3.2*o),c=Math.sign(e.friction_force);this.space.arrow(h,[0,1,0],a(e.
normal_force),o,L(i.normal_force)),this.space.arrow(h,[c,0,0],a(e.friction_force),o,L(i.friction_force))}linesOf(t,e,s){let i=this.lines.get(t);if(i?.dark===e.dark)
return i;let o=t.radius,{x:r,height:h,angle:a,mode:c}=t.columns,d=(w,g)=>this.space.trace(t.length,y=>[r[y]+w*Math.sin(a[y]),o+h[y]+w*Math.cos(a[y])],g),[p,f,u]=[
L(s.gravity_center),L(s.airborne),L(e.ink)],m={dark:e.dark,load:d(o,()=>u),center:d(t.eccentricity*o,w=>c[w]===3?f:p)};return this.lines.set(t,m),m}drawTraces(t,e,s,i,o,r){
let{load:h,center:a}=this.linesOf(t,i,o),c=Math.min(t.index(e.t)+2,t.length),d={shift:this.focus,depth:s};this.space.drawTrace(h,c,{width:r,...d}),this.space.drawTrace(
a,c,{width:1.6*r,...d})}};var ri=["hoop","mode","time","angle","v","R θ̇","gap"],Dt=class{constructor(t,e){this.colors=t,this.onview=e,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1},this.plane=l("canvas",{class:"stage-canvas"}),this.space=l("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new Lt(this.plane,e),this.deep=null,this.
outputs=ri.map(i=>({name:l("dt",{},i),value:l("dd",{})})),this.outputs[1].value.className="mode",this.fastest=l("span",{}),this.legend=l("div",{class:"legend","\
aria-hidden":"true"},l("i",{style:`background: linear-gradient(90deg, ${pt.filter((i,o)=>o%15===0).join(",")})`}),l("span",{},"0"),l("span",{},"rim speed"),this.
fastest);let s=(i,o)=>l("span",{},l("i",{class:"dot",style:`background:${i}`}),o);this.order=l("span",{hidden:!0},"A in front, B behind"),this.element=l("div",{
class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,l("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(({name:i,
value:o})=>[i,o])),this.legend,l("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(t.gravity_center,"centre of gravity"),s(t.airborne,"th\
e same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(t,e,s,{look:i,inks:o}){let{options:r}=this;this.legend.hidden=!r.speed,
this.order.hidden=!(r.three&&t.length>1),this.fastest.textContent=`≥ ${x(Math.max(...t.map(h=>h.extent.speed)),2)} m/s`,r.three?(this.deep??=new Bt(this.space,
this.onview),this.deep.draw(t,s.time,r,i,o,s.playing)):this.flat.draw(t,s.time,r,i,o),this.read(t,e,s.time)}read(t,e,s){let i=t[e],o=i.at(s),r=[t.length>1?"AB"[e]:
"",this.colors.mode_names[o.mode],`${o.t.toFixed(3)} s`,G(o.angle),T(x(o.vx,3),"m/s"),T(x(o.omega*i.radius,3),"m/s"),o.height>0?ue(o.height):"0"];for(let[c,d]of r.
entries()){let{value:p}=this.outputs[c];p.textContent!==d&&(p.textContent=d)}let[h,a]=this.outputs;h.value.hidden=h.name.hidden=t.length<2,a.value.style.setProperty(
"--mode",this.colors.modes[o.mode])}describe(t){this.element.setAttribute("aria-label",`The hoop. ${t.map(e=>e.summary).join(" ")}`)}turn(t){let e=()=>{this.plane.
hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,e();try{t()}catch(s){throw this.options.three=!1,e(),s}}zoom(t){
this.options.three?this.deep?.zoomBy(t):t?this.flat.zoomBy(t):this.flat.reset()}};var Ht=class{film;items;current;constructor(t){this.clock=t,this.summary=l("p",{class:"summary"}),this.list=l("ol",{class:"story-list"}),this.heading=l("h2",{},
"What happens"),this.live=l("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=l("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(t,e,s){this.film=t[e],this.heading.textContent=t.length>1?`What happens to hoop ${"AB"[e]}`:"What happens",this.
summary.replaceChildren(...t.flatMap((i,o)=>[t.length>1?l("b",{},`${"AB"[o]}: `):"",i.summary,i.status==="event_limit"||i.shortened?" (not all events are shown)":
"",o+1<t.length?l("br"):""])),this.items=this.film.story.map(i=>l("li",{},l("button",{type:"button",onclick:()=>this.clock.seek(i.t)},l("i",{class:"dot",style:`\
background:${s.modes[i.mode]}`,"aria-hidden":"true"}),l("span",{class:"when"},`${x(i.t,4)} s`),l("span",{},i.text)))),this.list.replaceChildren(...this.items),this.
current=-1,this.cursor(this.clock.time)}say(t){this.live.textContent=t}announce(t){this.say(t.map(e=>e.summary).join(" "))}cursor(t){let{story:e}=this.film,s=-1;
for(let o=0;o<e.length&&e[o].t<=t+1e-9;o++)s=o;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),
this.items[this.current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let i=this.items[s];if(i){let o=i.offsetTop-
this.list.offsetTop;(o<this.list.scrollTop||o+i.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=o-.4*this.list.clientHeight)}}},Ut=class{constructor(){
this.list=l("dl",{}),this.heading=l("h2",{},"What theory says"),this.element=l("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){this.heading.textContent=
e?`What theory says of hoop ${e}`:"What theory says",this.list.replaceChildren(...t.flatMap(({label:s,text:i})=>[l("dt",{},s),l("dd",{},i)]))}};var jt={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns back",apex:"hi\
ghest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"jam",kane_gain:"\
energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},ts=n=>n.kind==="takeoff"||n.to==="H"&&n.from!=="H"&&n.kind!=="impact";var at={jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"\
↺",apex:"•"},Wt=Object.keys(at);function es(n,t=11){let s=[...n.filter(({kind:o})=>o in at)].sort((o,r)=>Wt.indexOf(o.kind)-Wt.indexOf(r.kind)||o.x-r.x),i=[];
for(let{kind:o,x:r}of s){let h=Wt.indexOf(o)<Wt.indexOf("takeoff"),a=i.filter(c=>Math.abs(c.x-r)<t);a.length?a.length===1&&a[0].rare&&!i.some(c=>Math.abs(c.x-(a[0].
x+t))<t-1e-9)?a[0].mark!==at[o]&&i.push({mark:at[o],x:a[0].x+t,rare:!1,hidden:0}):a[0].hidden+=1:i.push({mark:at[o],x:r,rare:h,hidden:0})}return i.sort((o,r)=>o.
x-r.x).map(({mark:o,x:r})=>({mark:o,x:r}))}function ss(n,t,e){let s=[],i=new Map,o=-1,r=(a,c,d)=>{let p=s.at(-1);p&&p.mode===a&&Math.abs(p.from+p.wide-c)<1e-6?p.
wide+=d:s.push({mode:a,from:c,wide:d})},h=()=>{i.size&&r([...i].reduce((a,c)=>c[1]>a[1]?c:a)[0],o,1),i=new Map};for(let{mode:a,from:c,to:d}of n){let[p,f]=[Math.
max(t(c),0),Math.min(t(d),e)];if(f>p)for(let u=p;u<f-1e-9;){if((Math.floor(u+1e-9)!==o||!i.size)&&(h(),o=Math.floor(u+1e-9),f-u>=1&&Math.abs(u-o)<1e-6)){let w=Math.
floor(f-u+1e-9);r(a,o,w),u=o+w;continue}let m=Math.min(f,o+1);i.set(a,(i.get(a)??0)+m-u),u=m}}return h(),s}var qt=class{films;said;constructor(t){this.clock=t,this.window=null,this.canvas=l("canvas",{class:"timeline-canvas"}),this.tip=l("div",{class:"tip",hidden:!0}),
this.element=l("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),
this.element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermove",e=>this.hover(e)),this.element.addEventListener("point\
erleave",()=>this.tip.hidden=!0),this.pinched=R(this.element,{zoom:(e,s)=>this.zoom(1/e,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let t=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=t[1]?t:q(this.window,t)}zoom(t,e){let[s,i]=this.ends(),o=1e-6*this.clock.duration,
r=Math.max((i-s)*t,o),h=(e-s)/(i-s);this.window=r<this.clock.duration?q([e-h*r,e+(1-h)*r],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[t,e]=this.ends(),{time:s,duration:i}=this.clock;if(s>=t&&s<=e)return;let o=e-t;this.window=q(s>e?[s-.1*o,s+.9*o]:[s-.5*o,s+.5*o],[0,i])}timeAt(t){let e=this.
canvas.getBoundingClientRect(),[s,i]=this.ends();return s+b((t.clientX-e.left)/e.width,0,1)*(i-s)}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});
let e=this.clock.playing;this.clock.playing=!1;let s=i=>!this.pinched()&&this.clock.seek(this.timeAt(i));s(t),O(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){
let e=this.timeAt(t),s=this.nearest(e,8),i=s?`${jt[s.kind]??s.kind} · ${x(s.t,5)} s · ${x(s.angle*180/Math.PI,4)}°`:`${x(e,4)} s`;this.tip.textContent=i,this.
tip.hidden=!1;let o=this.canvas.getBoundingClientRect();this.tip.style.left=`${b(t.clientX-o.left,70,o.width-70)}px`}nearest(t,e){let[s,i]=this.ends(),o=e*(i-s)/
(this.canvas.getBoundingClientRect().width||1),r=null;for(let h of this.films??[])for(let a of h.events){if(a.kind==="end")continue;let c=Math.abs(a.t-t);c<=o&&
(!r||c<Math.abs(r.t-t))&&(r=a)}return r}draw(t,e,s){this.films=t;let{context:i,width:o,height:r}=_(this.canvas);this.keep();let[h,a]=this.ends(),c=g=>(g-h)/(a-h)*
o;i.clearRect(0,0,o,r);let d=15,p=(r-15)/t.length-d;t.forEach((g,y)=>{let v=d+y*(d+p);for(let{mode:k,from:S,wide:z}of ss(g.phases,c,o)){let C=s.modes[k];i.fillStyle=
C,i.fillRect(S,v,z,p-2),this.named(i,s.mode_names[k],S,z,v,p-2,C,e)}g.duration<a&&(i.fillStyle=e.line,i.fillRect(Math.max(c(g.duration),0),v,o,p-2)),this.marks(
i,g,c,v,o,e),t.length>1&&(i.fillStyle=e.soft,i.font=`600 11px ${e.font}`,i.textAlign="left",i.fillText("AB"[y],1,v-4))});let f=E(a-h,o/60);i.fillStyle=e.soft,i.
font=`10.5px ${e.font}`;let u=N(h,a,o/60);for(let g of u){let y=c(g);i.textAlign=y<14?"left":y>o-14?"right":"center",i.fillText($(g,f)+(g===u[0]?" s":""),y,r-3)}
let m=b(c(this.clock.time),6,o-6),w=b(c(this.clock.time),1,o-1);i.fillStyle=e.ink,i.fillRect(w-1,d-4,2,r-d-9),i.beginPath(),i.moveTo(m-6,d-10),i.lineTo(m+6,d-10),
i.lineTo(w,d-1),i.fill(),this.tell(t,s)}tell(t,e){let{time:s,duration:i,playing:o}=this.clock,h=t.map((a,c)=>{let d=e.mode_names[a.at(s).mode];return t.length>1?
`${"AB"[c]} ${d}`:d}).join(", ");o&&h===this.said||(this.said=h,this.element.setAttribute("aria-valuemax",i.toFixed(3)),this.element.setAttribute("aria-valuenow",
s.toFixed(3)),this.element.setAttribute("aria-valuetext",`${x(s,4)} seconds, ${h}`))}named(t,e,s,i,o,r,h,a){t.font=`11px ${a.font}`,!(r<13||t.measureText(e).width+
8>i)&&(t.fillStyle=pe(h),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*i,o+.5*r+1),t.textBaseline="alphabetic")}marks(t,e,s,i,o,r){t.font=`11px\
 ${r.font}`,t.textAlign="center";let h=e.events.filter(({kind:a})=>a!=="start"&&a!=="end").map(({kind:a,t:c})=>({kind:a,x:s(c)})).filter(({x:a})=>a>=-1&&a<=o+1);
if(t.fillStyle=r.panel,h.length<o/6)for(let{x:a}of h)t.fillRect(a-.5,i,1,5);t.fillStyle=r.ink;for(let{mark:a,x:c}of es(h))t.fillText(a,b(c,6,o-6),i-4)}};var ai=1/60,hi=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],ci={three:"In space"},j=(n,t,e)=>l(
"button",{type:"button",title:t,"aria-label":t,onclick:e},n),is=(n,t)=>l("span",{},l("span",{"aria-hidden":"true"},`${n} `),t),Xt=class{constructor(t,e,s,i,o){this.
clock=t,this.films=e,this.say=i,this.tell=o,this.playButton=j(A("play"),"Play (space)",()=>t.play()),this.playButton.classList.add("play"),this.speeds=l("select",
{"aria-label":"Speed of the film",onchange:()=>{t.speed=Number(this.speeds.value)}},nt.map(r=>l("option",{value:String(r)},`${r}×`))),this.speeds.value="1",this.
switches=new Map(hi.map(([r,h,a])=>{let c=`${r==="three"?ci.three:h} (${a})`;return[r,l("button",{type:"button",class:"switch",title:c,onclick:()=>s(r)},h)]})),
this.element=l("div",{class:"transport"},l("div",{class:"buttons"},j(A("start"),"To the start (Home)",()=>t.seek(0)),j(A("previous"),"Previous event (Shift ←)",
()=>this.jump(-1)),j(A("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,j(A("on"),"One frame on (→)",()=>this.nudge(1)),j(A("next"),"Next ev\
ent (Shift →)",()=>this.jump(1))),l("div",{class:"buttons jumps"},j(is("▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),j(is("▼","landin\
g"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,l("div",{class:"buttons switches"},[...this.switches.values()]))}show(t){let{clock:e,playButton:s}=this;
for(let[o,r]of this.switches)r.setAttribute("aria-pressed",String(t[o]));let i=e.playing?"Pause (space)":"Play (space)";(s.title!==i||!s.firstChild)&&(s.replaceChildren(
A(e.playing?"pause":"play")),s.title=i,s.setAttribute("aria-label",i)),this.speeds.value!==String(e.speed)&&(this.speeds.value=String(e.speed))}nudge(t){this.clock.
playing=!1,this.clock.seek(this.clock.time+t*ai*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap((c,d)=>c.events.map(
p=>({event:p,lane:d}))).filter(({event:c})=>!e||(e==="impact"?c.kind===e:ts(c))).sort((c,d)=>c.event.t-d.event.t),i=this.clock.time,o=t>0?s.find(({event:c})=>c.
t>i+1e-9):s.findLast(({event:c})=>c.t<i-1e-9);if(!o&&e&&(o=s[0]),!o){e&&this.say(e==="takeoff"?"This motion has no flight.":"This motion has no landing.");return}
this.clock.seek(o.event.t);let{event:r,lane:h}=o,a=this.films().length>1?`Hoop ${"AB"[h]}: `:"";this.tell(`${a}${jt[r.kind]??r.kind} at ${G(r.angle)}, ${x(r.t,4)}\
 s`)}};var ht=class{constructor(t,e,s,{hosted:i=!1,panels:o=null,onmotion:r=()=>{}}={}){this.root=t,this.backend=e,this.hosted=i,this.onmotion=r,this.prepareRoot();let{
colors:h}=s;this.known=s.presets,this.address=i?new mt(this):null,this.clock=new yt,this.motions=new _t(e,{shown:a=>this.changed(a),settled:()=>this.story.announce(
this.films()),noted:a=>this.noted(a),travelled:async a=>this.address?.travel(a),failed:(a,c)=>this.failed(a,c)}),this.notice=new $t,this.theme=new Tt(t,h,i,()=>this.
show()),this.stage=new Dt(h,()=>{this.request(),this.address?.soon()}),this.transport=new Xt(this.clock,()=>this.films(),a=>this.toggle(a),a=>this.notice.say(a),
a=>this.story.say(a)),this.timeline=new qt(this.clock),this.story=new Ht(this.clock),this.theory=new Ut,this.plots=new zt(this.clock,h),this.phase=new It(e,this.
clock,h),this.map=new At(e,s,{take:a=>{this.clock.time=0,this.motions.change(a,!0)},say:a=>this.story.say(a),changed:()=>this.address?.soon()}),this.controls=new vt(
s.controls,(a,c)=>this.motions.change(a,c)),this.share=new Nt(this),this.singleKeys=new St(i),this.help=ve(s.version,h,this.singleKeys.element),this.hoops=new Mt(
a=>this.motions.choose(a)),this.header=new kt(s.presets,this.share.menu,{take:a=>this.take(a),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.
motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(o),this.requested=!1,this.surrounding=!1,this.taken=null,this.afterFrame=
null,this.asked=null,this.later=H(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=this.frame.bind(this),this.clock.listeners.add(()=>{this.
request(),this.clock.playing||this.address?.soon()}),this.deaf=Te(this,i),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){this.root.classList.add("\
hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts="true")}layOut(t){
let{root:e,notice:s}=this,i=d=>!t||t.includes(d),o=l("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.element),r=l("d\
iv",{class:"player"},this.stage.element,this.timeline.element,this.transport.element);this.sticky=this.hosted?De(r,()=>this.request()):null;let h=l("a",{class:"\
skip button",href:"#hh-player"},"Skip to the player");h.onclick=d=>{d.preventDefault(),this.timeline.element.focus()};let a=l("div",{class:"middle"},this.sticky?.
edge,r,l("div",{class:"words"},this.story.element,i("theory")&&this.theory.element),i("map")&&this.map.element),c=l("div",{class:"why"},i("plots")&&this.plots.element,
i("plots")&&this.phase.element);e.replaceChildren(l("div",{class:"page"},this.hosted&&h,this.header.element,l("div",{class:"columns"},i("controls")&&o,a,c)),s.toast,
this.share.dialog,this.help),e.classList.toggle("no-controls",!i("controls"))}async open(t,e={}){await this.motions.load(t),this.clock.duration=Math.max(...this.
films().map(s=>s.duration)),this.restore(e),this.begin()}begin(){this.show(),this.motions.note(),this.sizes.observe(this.stage.element),this.root.dataset.ready=
"true"}close(){this.clock.playing=!1,this.asked?.abort(),this.map.close(),this.theme.close(),this.address?.close(),this.sticky?.close(),this.sizes.disconnect(),
this.deaf()}film(t=this.motions.active){return this.motions.film(t)}films(){return this.motions.films()}changed(t=null){this.notice.clear(),this.show(t)}failed(t,e=[]){
this.controls.refuse(e,t.message)||(this.notice.fail(t),this.controls.restore()),this.showPreset()}noted(t){this.header.show(this.motions.history,this.motions.lanes.
length>1),this.address?.write(t),this.onmotion(this.film().query)}link(){let{clock:t,stage:e,map:s}=this;return this.motions.link(ge({time:t.time,options:e.options,
zoom:e.flat.zoom,map:s.shown()}))}restore({time:t,options:e,zoom:s,map:i}){if(e){let{three:o,...r}=e;Object.assign(this.stage.options,r),o&&this.toggle("three")}
s&&(this.stage.flat.zoom=s),i&&this.map.restore(i),t&&this.clock.seek(t)}showPreset(){let{query:t}=this.film(),e=this.known.find(s=>s.query===t);this.header.presets.
value=e?.key??"",this.hoops.text.textContent=e?.text??""}async take(t){this.taken=t;try{let e=await this.backend.call("film",{query:t.query});if(this.taken!==t)
return;this.clock.time=0,this.motions.replace(e),this.story.announce(this.films())}catch(e){this.failed(e)}}travel(t){return this.motions.travel(t)}show(t=null){
let{motions:e,clock:s}=this,i=this.films();if(!i.length)return;let o=i.length>1;this.theme.read(),s.duration=Math.max(...i.map(r=>r.duration)),s.time=Math.min(s.
time,s.duration),this.root.classList.toggle("two",o),this.header.show(e.history,o),this.hoops.show(i.length,e.active),this.drawStage(),this.controls.show(this.film(),
this.motions.waiting()),this.showPreset(),t!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-t),0)),this.surrounding||(this.
surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let t=this.films(),{active:e}=this.motions,
{look:s,colors:i}=this.theme;this.plots.draw(t,e,s),this.phase.draw(t,e,s),this.story.draw(t,e,i),this.drawTime(),this.map.mark(this.film(),s),this.stage.describe(
t),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{time:t}=this.clock;this.surrounding||(this.timeline.
draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(t),this.phase.cursor(t),this.story.cursor(t),this.transport.show(this.stage.options))}request(){
this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){this.requested=!1,this.motions.lanes.length&&(this.clock.tick(t),this.drawStage(),
this.drawTime(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){let{scenario:t}=this.film();this.asked?.abort(),this.
asked=new AbortController;let{signal:e}=this.asked;try{let s=await this.backend.call("theory",{scenario:t},e);this.theory.draw(s.header.thresholds,this.motions.
name()),await this.phase.fetch(t,e)}catch(s){let{name:i,message:o}=s;i!=="AbortError"&&this.theory.draw([{label:"–",text:o}])}}toggle(t){let{options:e}=this.stage;
if(t!=="three")e[t]=!e[t];else try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}this.transport.show(e),this.address?.soon(),this.request()}};async function li(n){let t=new URL("./",document.baseURI.split(/[?#]/)[0]),e=new gt(t),s;try{s=(await e.call("setup",{})).header}catch(h){n.textContent=h.message;
return}let i=new ht(n,e,s,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let o=new URLSearchParams(location.hash.slice(1)).get("with"),r=we(location.hash);
try{await i.open([location.search.slice(1),...o===null?[]:[o]],r)}catch(h){history.replaceState(null,"",t),await i.open([""]),i.notice.fail(h)}}function di({model:n,
el:t}){let e=document.createElement("div");t.append(e);let s=new wt(n),i=new ht(e,s,n.get("setup"),{panels:n.get("panels"),onmotion:r=>{n.get("query")!==r&&(n.set(
"query",r),n.save_changes())}});i.motions.set([V(n.get("film"))]),i.begin();let o=()=>i.motions.replace(V(n.get("film")));return n.on("change:film",o),()=>{n.off(
"change:film",o),s.close(),i.close()}}var os=document.getElementById("hophoop-lab");os&&li(os);var dr={render:di};export{dr as default};
