/* Built from web/lab/main.js by esbuild 0.28.2; sources 755fd330a1dc4043f5f328b4ad2eeb3f */
var Ce={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function q(a){let t=a instanceof DataView||ArrayBuffer.isView(a)?a:new DataView(a),e=new Uint8Array(t.buffer,
t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(e.subarray(
4,4+s))),o={};for(let{name:n,type:r,shape:h,place:c}of i.arrays){let d=h.reduce((p,m)=>p*m,1);o[n]=new Ce[r](e.buffer,e.byteOffset+4+s+c,d)}return{header:i,arrays:o}}var Z=class extends Error{},Oe=500;async function te(a,t,e){for(;;)try{return await a()}catch(s){if(!(s instanceof Z))throw s;t(s.message),await new Promise(i=>setTimeout(
i,Oe)),e.throwIfAborted()}}var nt=class{constructor(t){this.base=t,this.shares=!0}async call(t,e,s){let i=await fetch(new URL(`lab/${t}`,this.base),{method:"POS\
T",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),signal:s});if(!i.ok){let o=await i.json().catch(()=>({}));throw new Error(o.detail??`The s\
erver answered ${i.status}.`)}if(i.status===202)throw new Z((await i.json()).detail);return q(await i.arrayBuffer())}async file(t,e){let s=await fetch(new URL(`\
api/v1/files/${t}?${e}`,this.base));if(!s.ok)throw new Error((await s.json()).detail);return s.blob()}link(t,e){return`${new URL(t?`?${t}`:"",this.base)}${e}`}},
Be=2e4,De=3e5,at=class{constructor(t){this.model=t,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).slice(2),this.listen=(e,s)=>this.
answered(e,s),t.on("msg:custom",this.listen)}answered(t,e){let s=t?.view===this.view&&this.waiting.get(t.number);s&&(clearTimeout(s.timer),this.waiting.delete(t.
number),t.compiling?s.reject(new Z(t.compiling)):t.error?s.reject(new Error(t.error)):s.resolve(q(e[0])))}call(t,e,s){let i=++this.number;return new Promise((o,n)=>{
let r=setTimeout(()=>{this.waiting.delete(i),n(new Error("The notebook’s kernel does not answer; run the cell again."))},t==="file"?De:Be);this.waiting.set(i,
{resolve:o,reject:n,timer:r}),s?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(i),n(new DOMException("superseded","AbortError"))}),this.model.
send({view:this.view,number:i,call:t,body:e})})}async file(t,e){let{arrays:s}=await this.call("file",{query:e,name:t});return new Blob([s.content])}link(){return null}close(){
this.model.off("msg:custom",this.listen)}};var b=(a,t,e)=>Math.min(Math.max(a,t),e);function v(a,t=4){if(a==null)return"–";if(typeof a!="number")return String(a);if(!Number.isFinite(a))return Number.isNaN(
a)?"–":a>0?"∞":"−∞";if(a===0)return"0";let e=Math.abs(a),s;if(e>=1e6||e<1e-4){let[i,o]=a.toExponential(t-1).split("e");s=`${ee(i)}·10${Ue(Number(o))}`}else
s=ee(a.toPrecision(t)),s.includes("e")&&(s=String(Math.round(a)));return s.replace("-","−")}function ee(a){return a.includes(".")&&!a.includes("e")?a.replace(
/\.?0+$/,""):a}function Ue(a){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(a)].map(e=>t[e]).join(
"")}var _=(a,t)=>t?t==="°"?`${a}°`:`${a} ${t}`:a,rt=a=>`${(a*180/Math.PI).toFixed(1)}°`.replace("-","−");function se(a){let t=Math.abs(a),[e,s]=t>=.995?[1,
"m"]:t>=.00995?[100,"cm"]:[1e3,"mm"];return _(v(a*e,3),s)}function S(a,t){let e=a/Math.max(t,1),s=10**Math.floor(Math.log10(e)),i=e/s;return(i>5?10:i>2?5:i>1?2:
1)*s}function $(a,t,e){if(!(t>a)||!Number.isFinite(a)||!Number.isFinite(t))return[];let s=S(t-a,e),i=[];for(let o=Math.ceil(a/s-1e-9);o*s<=t+1e-9*s&&i.length<200;o++)
i.push(o*s);return i}function P(a,t){let e=b(-Math.floor(Math.log10(t)+1e-9),0,15);return Math.max(Math.abs(a),t)>=1e6||e>12?v(a,3):(Math.abs(a)<t*1e-6?0:a).toFixed(
e).replace("-","−")}var Q=[.05,.1,.25,.5,1,2,4],ht=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let t of this.listeners)t(this)}seek(t){this.time=b(t,0,this.duration),this.changed()}play(t=!this.playing){this.playing=t,this.last=null,t&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(t){let e=Q.indexOf(this.speed);this.speed=Q[b(e+t,0,Q.length-1)],this.changed()}tick(t){if(!this.playing)return!1;
let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function l(a,t={},...e){let s=document.createElement(a),i=s;for(let[o,n]of Object.entries(t))n==null||n===!1||(o.startsWith("on")?s.addEventListener(o.slice(2),
n):o==="class"?s.className=n:o in s&&o!=="list"&&typeof n!="string"?i[o]=n:s.setAttribute(o,n===!0?"":n));for(let o of e.flat())o==null||o===!1||s.append(o.nodeType?
o:document.createTextNode(String(o)));return s}var X=a=>a!==null&&a.getRootNode().activeElement===a,C=a=>a.getContext("2d");function R(a){let t=a.getBoundingClientRect(),
e=Math.min(globalThis.devicePixelRatio||1,2.5),s=Math.max(Math.round(t.width*e),1),i=Math.max(Math.round(t.height*e),1);(a.width!==s||a.height!==i)&&(a.width=s,
a.height=i);let o=C(a);return o.setTransform(e,0,0,e,0,0),{context:o,width:s/e,height:i/e}}function Dt(a){let t=getComputedStyle(a),e=s=>t.getPropertyValue(s).trim();
return{ink:e("--ink"),soft:e("--soft"),line:e("--line"),paper:e("--paper"),panel:e("--panel"),ground:e("--ground"),font:e("--font"),dark:e("--dark")==="1"}}function lt(a,t){
let e=l("a",{href:URL.createObjectURL(a),download:t});document.body.append(e),e.click(),e.remove(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function Y(a,t){
let e=0;return()=>{clearTimeout(e),e=setTimeout(a,t)}}var ie={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},He={mass:"mass [kg]",inner_radius:"inner radius [m]",outer_radius:"outer radius [m]",radius:"radius [m\
]",at:"distance from centre [m]",length:"length [m]"},We=(a,t,e)=>({ring:{shape:a,mass:e,inner_radius:.95*t,outer_radius:t},disk:{shape:a,mass:e,radius:.1*t,at:.8*
t},point_mass:{shape:a,mass:e,at:t},rod:{shape:a,mass:e,length:.5*t,at:.5*t}})[a];function oe(a){let t=a["hoop.radius"],e=a["hoop.mass"],s=Math.min(Math.max(a["\
hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:ct(e*(1-s)),inner_radius:ct(.98*t),outer_radius:t},{shape:"point_mass",mass:ct(e*s),at:t}]}var ct=a=>Number(
a.toPrecision(6)),dt=class{parts;text;radius;mass;constructor(t){this.onchange=t,this.list=l("div",{class:"parts"}),this.element=l("div",{},this.list,l("select",
{"aria-label":"Add a part",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,We(s,this.radius,ct(.2*this.mass))])}},l("option",{value:""},
"+ add a part …"),Object.entries(ie).map(([e,{label:s}])=>l("option",{value:e},s))))}send(t){this.onchange([["hoop.parts",t]])}show(t,e,s){let i=JSON.stringify(
t);if(i===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(this,{text:i,parts:t,radius:e,mass:s}),this.list.
replaceChildren(...t.map((o,n)=>this.row(o,n)))}row(t,e){let{label:s,keys:i}=ie[t.shape];return l("fieldset",{class:"part"},l("legend",{},s,this.parts.length>1&&
l("button",{type:"button",class:"quiet","aria-label":`Remove part ${e+1}, ${s}`,onclick:()=>this.send(this.parts.filter((o,n)=>n!==e))},"×")),i.map(o=>l("label",
{},He[o],l("input",{type:"number",step:"any",value:String(t[o]??0),onchange:n=>this.send(this.parts.map((r,h)=>h===e?{...r,[o]:Number(n.target.value)}:r))}))))}};var ne=Math.PI/180,Ut=class{constructor(t,e){this.info=t,this.onchange=e;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`;this.range=l("input",{type:"\
range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,oninput:()=>this.slid(!1),
onchange:()=>this.slid(!0)}),this.number=l("input",{type:"number",step:"any",class:"exact","aria-label":`${t.label}, exact value${t.unit?` in ${t.unit}`:""}`,onchange:()=>this.
typed()}),this.element=l("div",{class:"control",title:t.help},l("label",{for:s},l("span",{},t.label),l("span",{class:"symbol"},t.symbol)),this.range,l("span",{class:"\
entry"},this.number,l("span",{class:"unit"},t.unit)))}low(){return this.info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?
Math.log10(this.info.most):this.info.most}slid(t){let e=Number(this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.number.value=String(
s),this.say(s),this.send(s,t)}typed(){this.number.value.trim()!==""&&this.send(Number(this.number.value),!0)}send(t,e){this.onchange([[this.info.path,this.info.
degrees?t*ne:t]],e)}say(t){this.range.setAttribute("aria-valuetext",_(v(t,4),this.info.unit))}show(t,e=null){let s=t!=null,i=s?t:e;if(i==null){this.number.value=
"";return}let o=i==="inf"?1/0:Number(i)/(this.info.degrees?ne:1),n=Number.isFinite(o)?String(Number(o.toPrecision(9))):"";this.number.value=s?n:"",this.number.placeholder=
s?Number.isFinite(o)?"":"∞":`auto ${v(o,2)}`,this.number.title=s?_(String(o),this.info.unit):"";let r=this.info.logarithmic?Math.log10(o):o;(!X(this.range)||Math.
abs(Number(this.range.value)-r)>1e-6)&&(this.range.value=String(b(r,this.low(),this.high()))),this.say(o)}};function je(a,t){let e=l("select",{"data-path":a.path,
onchange:()=>t([[a.path,e.value]],!0)},a.options.map(([i,o])=>l("option",{value:i},o)));return{element:l("label",{class:"choice",title:a.help},l("span",{},a.label),
e),select:e,path:a.path}}var pt=class{way;kind;gravity;apart;derived;film;constructor(t,e){this.onchange=(s,i=!0)=>e(s,i),this.sliders=new Map;for(let s of Object.
values(t.groups))for(let i of s)this.sliders.set(i.path,new Ut(i,this.onchange));this.choices=new Map(t.choices.map(s=>[s.path,je(s,this.onchange)])),this.parts=
new dt(this.onchange),this.gravities=t.gravities,this.element=l("div",{class:"controls"},this.hoop(),this.plane(),this.start(),this.contact())}at(t){let e=this.
sliders.get(t)??this.choices.get(t);if(!e)throw new Error(`There is no control of ${t}.`);return e.element}select(t,e,s){let i=l("select",{onchange:()=>s(i.value)},
e.map(([o,n])=>l("option",{value:o},n)));return{select:i,element:l("label",{class:"choice"},l("span",{},t),i)}}group(t,...e){let s=t==="Start"||t==="Plane"||!matchMedia(
"(max-width: 760px)").matches;return l("details",{class:"group",open:s},l("summary",{},t),e)}hoop(){return this.way=this.select("Given by",[["load_fraction","lo\
ad fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],t=>{let{values:e}=this.film;t==="parts"?this.onchange([["hoop.parts",oe(e)]]):this.onchange(
[[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=l("p",{class:"derived"}),this.group("Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.e\
ccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.radius"),this.at("hoop.mass"))}plane(){return this.apart=l("input",{type:"\
checkbox",onchange:()=>{let{values:t}=this.film;this.apart.checked?this.onchange([["plane.mu_static",t["plane.mu_static"]],["plane.mu_kinetic",t["plane.mu_kinet\
ic"]]]):this.onchange([["plane.mu",t["plane.mu_static"]]])}}),this.gravity=this.select("Where",[...this.gravities.map(([t])=>[t,t]),["","elsewhere"]],t=>{let e=this.
gravities.find(([s])=>s===t);e&&this.onchange([["plane.gravity",e[1]]])}),this.group("Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_ki\
netic"),l("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("\
plane.restitution"),this.at("plane.impact_law"),this.at("plane.painleve"))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any \
state"]],t=>{let{values:e}=this.film;t==="rolling"?this.onchange([["start.speed",e["start.vx"]]]):this.onchange([["start.omega",e["start.omega"]]])}),this.group(
"Start",this.kind.element,this.at("start.speed"),this.at("start.angle"),this.at("start.height"),this.at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.
at("duration"))}contact(){return this.group("Contact",this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.
at("contact.slip_speed"),this.at("contact.restitution"))}show(t){this.film=t;let{scenario:e,values:s}=t,i=e.hoop.parts?"parts":"load_fraction"in e.hoop?"load_fr\
action":"eccentricity",o="speed"in e.start,n="mu_static"in e.plane,r=e.contact.model==="compliant";this.way.select.value=i,this.kind.select.value=o?"rolling":"f\
ree",this.apart.checked=n;let h=this.gravities.find(([,p])=>Math.abs(p-e.plane.gravity)<1e-9);this.gravity.select.value=h?h[0]:"";let c={"hoop.load_fraction":i===
"load_fraction","hoop.eccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!=="parts","plane.mu":!n,"plane.mu_static":n,"plane.\
mu_kinetic":n,"plane.restitution":!r,"plane.impact_law":!r,"plane.painleve":!r,"start.speed":o,"start.height":!o,"start.vx":!o,"start.vy":!o,"start.omega":!o,"c\
ontact.law":r,"contact.friction":r,"contact.stiffness":r,"contact.slip_speed":r,"contact.restitution":r};for(let[p,m]of Object.entries(c))this.at(p).hidden=!m;this.
parts.element.hidden=i!=="parts",e.hoop.parts&&this.parts.show(e.hoop.parts,s["hoop.radius"],s["hoop.mass"]),this.derived.textContent=i==="eccentricity"?"":`ε =\
 ${v(s["hoop.eccentricity"],5)}, κ = ${v(s["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${v(s["hoop.mass"],5)} kg`:"");let d=e;for(let[p,m]of this.sliders){let[
f,u]=p.split(".");m.show(s[p]??(u?d[f]?.[u]:d[f]),t.automatic?.[p])}for(let[p,{select:m}]of this.choices){let[f,u]=p.split(".");d[f]?.[u]!==void 0&&(m.value=d[f][u])}}};var qe={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",theme:"M8.5 2a6.5 6.5 \
0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function E(a){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("v\
iewBox","0 0 17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class","icon");let s=document.createElementNS(t,"path");return s.setAttribute("d",qe[a]),
e.append(s),e}var tt=(a,t,e)=>l("button",{type:"button",title:t,"aria-label":t,onclick:e},a),mt=class{constructor(t,e,s){let i=new Map;for(let n of t)i.set(n.group,[...i.get(
n.group)??[],n]);this.presets=l("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let n=t.find(({key:r})=>r===this.presets.value);n&&
s.take(n)}},l("option",{value:""},"Motions to start from …"),[...i].map(([n,r])=>l("optgroup",{label:n},r.map(({key:h,title:c})=>l("option",{value:h},c))))),this.
undo=tt(E("undo"),"Undo (z)",s.undo),this.redo=tt(E("redo"),"Redo (y)",s.redo);let o=l("span",{},l("span",{class:"long"},"Compare"),l("span",{class:"short"},E("\
two")));this.compare=tt(o,"Compare two hoops",s.compare),this.element=l("header",{class:"top"},l("h1",{},l("span",{class:"logo","aria-hidden":"true"}),l("span",
{},"hophoop",l("span",{class:"long"}," lab"))),this.presets,l("div",{class:"buttons"},this.undo,this.redo,this.compare),l("div",{class:"buttons right"},e,tt(E("\
theme"),"Dark or light (d)",s.theme),tt("?","Keys and help (?)",s.help)))}show(t,e){this.undo.disabled=!t.past.length,this.redo.disabled=!t.future.length,this.compare.
setAttribute("aria-pressed",String(e))}};var Xe=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next hop, landing"],["[ ]","slower, faster"],["Home En\
d","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["z y","undo, redo"],["d","dark, light"],["p",
"Python"]];function ae(a){let t=l("dialog",{class:"help","aria-label":"Keys and help"},l("h2",{},"The hoop"),l("p",{},"A ring with a load on its rim rolls on a \
plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a\
 slider and see."),l("table",{},l("caption",{},"Keys"),Xe.map(([e,s])=>l("tr",{},l("th",{scope:"row"},e),l("td",{},s)))),l("p",{class:"hint"},`hophoop ${a}`),l(
"button",{type:"button",class:"close",onclick:()=>t.close()},"Close"));return t}var ut=class{constructor(t){this.tabs=["A","B"].map((e,s)=>l("button",{type:"button","aria-pressed":"false",onclick:()=>t(s)},`Hoop ${e}`)),this.bar=l("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=l("p",{class:"preset-text"}),this.element=l("div",{class:"lanes"},
this.bar,this.text)}show(t,e){this.bar.hidden=t<2;for(let[s,i]of this.tabs.entries())i.setAttribute("aria-pressed",String(s===e))}};var Ye=(a,t)=>({" ":()=>a.clock.play(),ArrowLeft:()=>t?a.transport.jump(-1):a.transport.nudge(-1),ArrowRight:()=>t?a.transport.jump(1):a.transport.nudge(1),Home:()=>a.
clock.seek(0),End:()=>a.clock.seek(a.clock.duration),h:()=>a.transport.jump(1,"takeoff"),l:()=>a.transport.jump(1,"impact"),"[":()=>a.clock.faster(-1),"]":()=>a.
clock.faster(1),t:()=>a.toggle("traces"),f:()=>a.toggle("forces"),c:()=>a.toggle("speed"),w:()=>a.toggle("whole"),3:()=>a.toggle("three"),"+":()=>a.stage.zoom(1.25),
"=":()=>a.stage.zoom(1.25),"-":()=>a.stage.zoom(.8),0:()=>a.stage.zoom(0),z:()=>a.travel(-1),y:()=>a.travel(1),d:()=>a.theme.toggle(),p:()=>a.share.code(),"?":()=>a.
help.showModal()});function Ge(a,t){let e=t.target;if(t.ctrlKey||t.metaKey||t.altKey||a.root.querySelector("dialog[open]")||e.matches?.("input:not([type=range])\
, textarea, select")||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary"))return;let i=Ye(a,t.shiftKey)[t.
key];i&&(t.preventDefault(),i())}function re(a,t){let e=t?document:a.root,s=i=>{Ge(a,i),t||i.stopPropagation()};return e.addEventListener("keydown",s),()=>e.removeEventListener(
"keydown",s)}var[he,Ke]=[62,92],Ve=12,H=10,Je=36,le=Math.PI/180,et=["x","y"],ft=class{box;constructor(t){this.known=new Map(t.map(e=>[e.path,e])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=he}info(t){return this.known.get(this.paths[t])}whole(t){return[...this.info(t).range]}home(){
for(let t of et)this.windows[t]=this.whole(t)}choose(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t]),this.paths[t]=e,this.home()}asked(t,e){
let[s,i]=this.windows[t];return{path:this.paths[t],from:s,to:i,cells:e}}zoom(t,e){let s={x:[],y:[]};for(let i of et){let[o,n]=this.windows[i],r=e?.[i]??.5*(o+n);
s[i]=[r-(r-o)*t,r+(n-r)*t];let h=Math.max(Math.abs(s[i][0]),Math.abs(s[i][1]),1e-9);if(s[i][1]-s[i][0]<400*Number.EPSILON*h)return!1;let{range:c}=this.info(i);if(s[i][1]-
s[i][0]>4*(c[1]-c[0]))return!1}return this.windows=s,!0}drag(t,e,s){let i=(o,n)=>t[o].map(r=>r+n*(t[o][1]-t[o][0]));this.windows={x:i("x",-e/this.box.width),y:i(
"y",s/this.box.height)}}middle(){let{x:t,y:e}=this.windows;return{x:.5*(t[0]+t[1]),y:.5*(e[0]+e[1])}}fit(t,e){this.left=this.deep("y")?Ke:he,this.box={width:t-this.
left-Ve,height:e-H-Je}}clip(t){t.beginPath(),t.rect(this.left,H,this.box.width,this.box.height),t.clip()}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-
e)*this.box.width}y(t){let[e,s]=this.windows.y;return H+(1-(t-e)/(s-e))*this.box.height}place(t,e){let s=([i,o],n)=>i+b(n,0,1)*(o-i);return{x:s(this.windows.x,(t-
this.left)/this.box.width),y:s(this.windows.y,1-(e-H)/this.box.height)}}deep(t){let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.abs(e),Math.abs(s))}said(t){
let e=s=>{let i=this.info(s),[o,n]=this.windows[s],r=Math.max(Math.abs(o),Math.abs(n)),h=b(Math.ceil(Math.log10(r/(n-o)))+4,4,16);return`${i.label} = ${_(v(i.degrees?
t[s]/le:t[s],h),i.unit)}`};return`${e("x")}, ${e("y")}`}draw(t,e,s){t.strokeStyle=s.soft,t.fillStyle=s.soft,t.lineWidth=1,t.strokeRect(this.left+.5,H+.5,this.box.
width-1,this.box.height-1),t.font=`11px ${s.font}`;for(let i of et){let o=this.info(i),n=o.degrees?1/le:1,[r,h]=this.windows[i].map(g=>g*n),c=i==="x"?this.box.width/
80:this.box.height/40,d=S(h-r,c),p=this.deep(i),m=p?Number((.5*(r+h)).toPrecision(12)):0,f=p?$(r-m,h-m,c).map(g=>g+m):$(r,h,c);for(let g of f){let y=p?v(g-m,3):
P(g,d);i==="x"?(t.textAlign="center",t.fillText(y,this.x(g/n),H+this.box.height+14)):(t.textAlign="right",t.textBaseline="middle",t.fillText(y,this.left-5,this.
y(g/n)),t.textBaseline="alphabetic")}let u=p?` − ${String(m).replace("-","−")}`:"",w=`${o.label}${u}${o.unit?` [${o.unit}]`:""}`;t.save(),t.textAlign="cente\
r",i==="x"?t.translate(this.left+.5*this.box.width,e-5):(t.translate(12,H+.5*this.box.height),t.rotate(-Math.PI/2)),t.fillText(w,0,0),t.restore()}}};function Ht(a,t,e,s,i){
for(let[o,n]of[[i,4],[s,1.8]])a.strokeStyle=o,a.lineWidth=n,a.beginPath(),a.arc(t,e,7,0,2*Math.PI),a.moveTo(t-13,e),a.lineTo(t-4,e),a.moveTo(t+4,e),a.lineTo(t+13,
e),a.moveTo(t,e-13),a.lineTo(t,e-4),a.moveTo(t,e+4),a.lineTo(t,e+13),a.stroke()}function L(a,t,e,s=()=>{}){let i=new AbortController,{signal:o}=i,n=(h,c)=>a.addEventListener(h,d=>d.pointerId===t.pointerId&&c(d),{signal:o}),r=h=>c=>{i.abort(),
s(c,h)};a.setPointerCapture(t.pointerId),n("pointermove",e),n("pointerup",r(!0)),n("pointercancel",r(!1))}function gt(a,t){let e=new Map,s=null,i=()=>{let[n,r]=[
...e.values()];return{span:Math.max(Math.hypot(n.clientX-r.clientX,n.clientY-r.clientY),1),clientX:.5*(n.clientX+r.clientX),clientY:.5*(n.clientY+r.clientY)}};a.
addEventListener("pointerdown",n=>{n.pointerType!=="mouse"&&(e.set(n.pointerId,n),s=e.size===2?i():null)}),a.addEventListener("pointermove",n=>{if(!e.has(n.pointerId)||
(e.set(n.pointerId,n),e.size!==2||!s))return;let r=i();t(r.span/s.span,r),s=r});for(let n of["pointerup","pointercancel"])a.addEventListener(n,r=>{e.delete(r.pointerId),
s=null});let o=n=>n.touches.length>1&&n.cancelable&&n.preventDefault();return a.addEventListener("touchmove",o,{passive:!1}),()=>e.size>1}var ce={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},de=48;function pe(a){let{body:t}=a,e=gt(t,(i,o)=>a.axes.box&&a.zoom(1/i,wt(a,o))),s=!1;
t.addEventListener("wheel",i=>{a.axes.box&&(i.preventDefault(),a.zoom(Math.exp(b(i.deltaY,-200,200)*.0022),wt(a,i)))},{passive:!1}),t.addEventListener("pointerd\
own",i=>Qe(a,i,e,o=>s=o)),t.addEventListener("pointermove",i=>{a.axes.box&&!s&&i.pointerType!=="touch"&&Ze(a,i)}),t.addEventListener("pointerleave",()=>a.tip.hidden=
!0),t.addEventListener("dblclick",()=>a.zoom(.35,a.pointed??void 0)),t.addEventListener("keydown",i=>ts(a,i))}function wt(a,t){let e=a.body.getBoundingClientRect();
return a.axes.place(t.clientX-e.left,t.clientY-e.top)}function Ze(a,t){a.tip.textContent=a.said(wt(a,t)),a.tip.hidden=!1;let e=a.body.getBoundingClientRect();a.
tip.style.left=`${b(t.clientX-e.left,150,Math.max(e.width-150,150))}px`,a.tip.style.bottom=`${e.bottom-t.clientY+16}px`}function Qe(a,t,e,s){t.preventDefault(),
a.body.focus({preventScroll:!0});let i=[t.clientX,t.clientY],o={x:[...a.axes.windows.x],y:[...a.axes.windows.y]};a.pointed=wt(a,t);let n=!1,r=e(),h=c=>{if(r||=e(),
r)return;let[d,p]=[c.clientX-i[0],c.clientY-i[1]];Math.hypot(d,p)<5&&!n||(n=!0,s(!0),a.tip.hidden=!0,a.axes.drag(o,d,p),a.redraw(),a.soon())};L(a.body,t,h,(c,d)=>{
d&&!n&&!r&&a.pointed&&a.take(a.pointed),s(!1)})}function ts(a,t){let e=a.pointed??a.here()??a.axes.middle();if(a.pointed=e,ce[t.key]){let[s,i]=ce[t.key],{x:o,y:n}=a.
axes.windows;a.pointed={x:e.x+s*(o[1]-o[0])/de,y:e.y+i*(n[1]-n[0])/de},a.state.textContent=a.said(a.pointed)}else if(t.key==="Enter")a.take(e);else if(t.key==="\
+"||t.key==="=")a.zoom(.6,e);else if(t.key==="-")a.zoom(1.7,e);else if(t.key==="0")a.home();else return;t.preventDefault(),t.stopPropagation(),a.redraw()}function F(a){let t=Number.parseInt(a.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}var me=a=>Wt(a)>.2?"#111111":"#ffffff",st=(a,t)=>`rgba(${F(a).join(",")},${t}\
)`,es=a=>{let t=a/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4};function Wt(a){let[t,e,s]=F(a).map(es);return .2126*t+.7152*e+.0722*s}function bt(a,t){if(!t||
!/^#[0-9a-f]{6}$/i.test(a))return a;if(Wt(a)<.002)return"#eceef2";let e=a;for(let s=0;Wt(e)<.2&&s<1;s+=.05)e=`#${F(a).map(i=>Math.round(i+(255-i)*s).toString(16).
padStart(2,"0")).join("")}`;return e}var yt=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function ss(){let a=[];for(let t=0;t<
256;t++){let e=t/255*(yt.length-1),s=Math.min(Math.floor(e),yt.length-2),i=F(yt[s]),o=F(yt[s+1]);a.push(i.map((n,r)=>Math.round(n+(o[r]-n)*(e-s))))}return a}var G=ss(),
vt=G.map(a=>`rgb(${a.join(",")})`);var is=Math.PI/180,os=12,ns=["hop_height","flight_time","energy_lost","greatest_utilization"];function ue(a){return a.unit==="rad"?[1/is,"°"]:[1,a.unit==="1"?"":
a.unit]}function as({classes:a,what:t},e){let[s,i]=[1/0,-1/0];if(a)return[s,i];for(let o of e)o<s&&(s=o),o>i&&(i=o);return[ns.includes(t)?Math.min(s,0):s,i]}function fe(a){
let{values:t}=a.arrays,e=a.header,{x:s,y:i,classes:o}=e,n=new ImageData(s.cells,i.cells),[r,h]=as(e,t),c=o?.map(({color:p})=>F(p));for(let p=0;p<i.cells;p++)for(let m=0;m<
s.cells;m++){let f=t[p*s.cells+m],u=4*((i.cells-1-p)*s.cells+m);if(!Number.isFinite(f))continue;let w=c&&(m+1<s.cells&&t[p*s.cells+m+1]!==f||p+1<i.cells&&t[(p+1)*
s.cells+m]!==f),g=c?c[f].map(y=>w?.72*y:y):G[b(Math.round(255*(f-r)/(h-r||1)),0,255)];n.data.set([...g,255],u)}let d=l("canvas",{width:s.cells,height:i.cells});
return C(d).putImageData(n,0,0),{picture:d,header:e,values:t,x:[s.from,s.to],y:[i.from,i.to],low:r,high:h}}function ge(a,t){let e=(i,o)=>i[0]>=o[0]-1e-300&&i[1]<=
o[1]+1e-300;return[...a.filter(i=>!(e(i.x,t.x)&&e(i.y,t.y))),t].slice(-os)}function we({header:a,low:t,high:e,values:s}){let{classes:i}=a;if(!i){let r=l("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),h=C(r);for(let p=0;p<120;p++)h.fillStyle=`rgb(${G[Math.floor(255*p/119)].join(",")})`,h.fillRect(p,0,1,10);
let[c,d]=ue(a);return[l("span",{},`${a.label}: ${e>=t?v(t*c,3):"none"} `),r,l("span",{},e>=t?_(v(e*c,3),d):""),s.some(p=>!Number.isFinite(p))?l("span",{},l("i",
{class:"blank"}),"none"):""]}let o=new Map;for(let r of s)o.set(r,(o.get(r)??0)+1);let n=[...o].filter(([r])=>r>=0).sort((r,h)=>h[1]-r[1]);return[...n.slice(0,10).
map(([r])=>{let{color:h,text:c}=i[r];return l("span",{},l("i",{style:`background:${h}`,"aria-hidden":"true"}),c)}),n.length>10?l("span",{},`and ${n.length-10} m\
ore`):""]}function ye(a,t){for(let{header:e,values:s}of[...a].reverse()){let{x:i,y:o,classes:n}=e,r=Math.floor((t.x-i.from)/(i.to-i.from)*i.cells),h=Math.floor(
(t.y-o.from)/(o.to-o.from)*o.cells);if(r<0||h<0||r>=i.cells||h>=o.cells)continue;let c=s[h*i.cells+r];if(n)return n[c]?.text??"not allowed";let[d,p]=ue(e);return Number.
isFinite(c)?_(v(c*d,4),p):"none"}return"…"}var be=[[24,16],[72,48],[216,144]],xt=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(t,e,s){this.backend=t,this.onmotion=s;let i=e.
controls.map_axes;this.axes=new ft(i),this.what="sequence",this.layers=[],this.canvas=l("canvas",{class:"plot-canvas"}),this.tip=l("div",{class:"tip",hidden:!0}),
this.body=l("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow keys move the mark, Enter takes the motion, plus and min\
us zoom."},this.canvas,this.tip),this.keys=l("div",{class:"map-keys"}),this.state=l("span",{class:"hint",role:"status"});let o=n=>{let r=l("select",{"data-axis":n,
onchange:()=>this.setAxis(n,r.value)},i.map(({path:h,label:c})=>l("option",{value:h},c)));return r};this.selects={x:o("x"),y:o("y")},this.quantity=l("select",{"\
aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},e.map_quantities.map(([n,r])=>l("option",{value:n},r))),this.element=
l("section",{class:"map","aria-label":"Map of motions"},l("div",{class:"map-head"},l("h2",{},"Map"),l("label",{},"of",this.quantity),l("label",{},"Across",this.
selects.x),l("label",{},"Up",this.selects.y),l("span",{class:"buttons"},l("button",{type:"button","aria-label":"Zoom into the map",onclick:()=>this.zoom(.5)},"+"),
l("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),l("button",{type:"button",onclick:()=>this.home()},"Whole map")),this.
state),this.body,this.keys,l("p",{class:"hint"},"Click to take that motion into the player; wheel or two fingers to zoom, drag to move.")),pe(this),this.soon=Y(
()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([n])=>{this.seen=n.isIntersecting,this.seen&&this.stale&&this.refresh()}),this.watch.observe(
this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let t of et)this.selects[t].value=this.axes.paths[t]}setAxis(t,e){
this.axes.choose(t,e),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(t){let e=structuredClone(t);for(let s of Object.values(this.
axes.paths)){let[i,o]=s.split(".");e[i]&&delete e[i][o]}return JSON.stringify(e)}mark(t,e){this.film=t,this.look=e;let s=this.key_of(t.scenario);s!==this.key_now&&
(this.key_now=s,this.soon()),this.redraw()}async refresh(){if(!this.film)return;if(!this.seen){this.stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=
new AbortController;let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[["contact.model","rigid"]];this.computing=!0;let i=`${this.what}\
 ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;i!==this.kind&&(this.layers=[]),this.kind=i,this.redraw();try{for(let[o,n]of be){this.state.textContent=
`computing ${o*n} motions …`;let r={x:this.axes.asked("x",o),y:this.axes.asked("y",n)},h={scenario:e,changes:s,...r,what:this.what},c=await te(()=>this.backend.
call("map",h,t),p=>{this.state.textContent=p},t),d=fe(c);this.layers=ge(this.layers,d),this.keys.replaceChildren(...we(d)),this.state.textContent=`${o*n} motion\
s${s.length?", with rigid contact":""}`,this.redraw()}this.level=be.length}catch(o){let{name:n,message:r}=o;if(n==="AbortError")return;this.state.textContent=r}
this.computing=!1}redraw(){if(!this.film)return;let{look:t}=this,{context:e,width:s,height:i}=R(this.canvas);this.axes.fit(s,i),e.clearRect(0,0,s,i),e.save(),this.
axes.clip(e),e.imageSmoothingEnabled=!1;let{axes:o}=this;for(let r of this.layers){let[h,c]=r.x.map(m=>o.x(m)),[d,p]=r.y.map(m=>o.y(m));e.drawImage(r.picture,h,
p,c-h,d-p)}let n=this.here();n&&Ht(e,o.x(n.x),o.y(n.y),t.ink,t.paper),this.pointed&&X(this.body)&&Ht(e,o.x(this.pointed.x),o.y(this.pointed.y),"#D55E00",t.paper),
e.restore(),o.draw(e,i,t)}here(){let t=s=>{let[i,o]=s.split(".");return this.film.values[s]??this.film.scenario[i]?.[o]},e={x:t(this.axes.paths.x),y:t(this.axes.
paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}said(t){return`${this.axes.said(t)}: ${ye(this.layers,t)}`}take(t){this.onmotion([[this.axes.
paths.x,t.x],[this.axes.paths.y,t.y]])}zoom(t,e){this.tip.hidden=!0,this.axes.zoom(t,e)&&(this.redraw(),this.soon())}};var jt="RSKHM",rs=new Set(["x","angle","height"]),hs={x:"vx",angle:"omega",height:"vy"},K=class{constructor(t){let{header:e}=t;this.scenario=e.scenario,this.query=
e.query,this.duration=e.duration,this.status=e.status,this.sequence=e.sequence,this.events=e.events,this.values=e.values,this.automatic=e.automatic,this.summary=
e.summary,this.story=e.story,this.shortened=e.shortened,this.columns=t.arrays,this.t=t.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radius"],
this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.gravity??
9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map}findPhases(){let{mode:t}=this.columns,e=[];for(let s=0;s<this.length;s++){let i=e.
at(-1);i&&i.mode===jt[t[s]]?i.to=this.t[s]:e.push({mode:jt[t[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<e.length;s++)e[s].to=e[s+1].from;return e.filter(
s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,vy:i,omega:o}=this.columns,n={left:1/0,right:-1/0,top:0,speed:0},r=[];for(let h=0;h<this.length;h++){
Number.isFinite(t[h])&&(n.left=Math.min(n.left,t[h]),n.right=Math.max(n.right,t[h])),e[h]>n.top&&(n.top=e[h]);let c=Math.hypot(s[h],i[h])+this.radius*Math.abs(o[h]);
Number.isFinite(c)&&r.push(c)}return r.sort((h,c)=>h-c),n.speed=r[Math.floor(.95*(r.length-1))]||1,n}index(t){let e=0,s=this.length;for(;s-e>1;){let i=e+s>>1;this.
t[i]<=t?e=i:s=i}return e}at(t){let e=b(t,0,this.duration),s=this.index(e),i=Math.min(s+1,this.length-1),o=this.t[i]-this.t[s],n=o>0?(e-this.t[s])/o:0,r={t:e,mode:jt[this.
columns.mode[s]]};for(let[h,c]of Object.entries(this.columns)){if(h==="t"||h==="mode")continue;let d=c[s],p=c[i];if(n===0||!Number.isFinite(p))r[h]=d;else if(rs.
has(h)){let m=this.columns[hs[h]];r[h]=ls(d,p,m[s]*o,m[i]*o,n)}else r[h]=d+(p-d)*n}return r}derived(t,e){let s=this.cache.get(t)??e(this.columns);return this.cache.
set(t,s),s}};function ls(a,t,e,s,i){if(!Number.isFinite(e)||!Number.isFinite(s))return a+(t-a)*i;let o=1-i;return o*o*(1+2*i)*a+i*i*(3-2*i)*t+i*o*(o*e-i*s)}var kt=class{constructor(){this.past=[],this.future=[],this.now=null}note(t){this.now&&JSON.stringify(this.now)!==JSON.stringify(t)&&(this.past.push(this.now),this.
past.length>500&&this.past.shift(),this.future=[]),this.now=t}step(t){let[e,s]=t<0?[this.past,this.future]:[this.future,this.past],i=e.pop();return!i||!this.now?
null:(s.push(this.now),this.now=i,i)}};var Mt=class{constructor(t,e){this.backend=t,this.listener=e,this.history=new kt,this.lanes=[],this.active=0}film(t=this.active){return this.lanes[t].film}films(){
return this.lanes.map(t=>t.film)}name(){return this.lanes.length>1?"AB"[this.active]:""}set(t){this.lanes=t.map(e=>({film:new K(e)})),this.active=Math.min(this.
active,this.lanes.length-1)}async load(t){this.set(await Promise.all(t.map(e=>this.backend.call("film",{query:e}))))}change(t,e){let s=this.lanes[this.active];s.
since??=performance.now(),s.pending=[...(s.pending??[]).filter(([i])=>!t.some(([o])=>o===i)),...t],s.commit||=e,this.pump(s)}async pump(t){if(t.busy)return;if(!t.
pending){t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{t.film=new K(await this.backend.call("film",{scenario:t.
film.scenario,changes:e})),this.listener.shown(s)}catch(i){this.listener.failed(i)}finally{t.busy=!1}this.pump(t)}settle(t){t.commit=!1,this.note(),this.listener.
settled()}note(){this.history.note(this.films().map(t=>t.query)),this.listener.noted()}replace(t){this.lanes[this.active].film=new K(t),this.listener.shown(),this.
note()}async travel(t){let e=this.history.step(t);e&&(await this.load(e),this.listener.shown(),this.listener.noted())}compare(){this.lanes.length===1?(this.lanes.
push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=0),this.listener.shown(),this.note()}choose(t){this.active=t,this.
listener.shown(),this.listener.noted()}link(){let t=this.lanes.length>1?`#with=${encodeURIComponent(this.film(1).query)}`:"";return this.backend.link(this.film(
0).query,t)}};var cs=4e3,Tt=class{constructor(){this.message=l("p",{class:"message",role:"alert",hidden:!0}),this.toast=l("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(t){this.message.textContent=t.message,this.message.hidden=!1,this.message.isConnected||this.say(t.message)}clear(){this.message.hidden=!0}say(t){this.
toast.textContent=t,this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},cs)}};var ds=.0018,[ps,ms]=[1/.6,1/1.7];function O(a,{zoom:t,home:e,chosen:s=()=>a,keys:i=!1}){return a.addEventListener("wheel",o=>{(o.ctrlKey||o.shiftKey||X(s()))&&
(o.preventDefault(),t(Math.exp(-(o.deltaY||o.deltaX)*ds),o))},{passive:!1}),a.addEventListener("dblclick",e),i&&a.addEventListener("keydown",o=>{if(o.key==="+"||
o.key==="=")t(ps);else if(o.key==="-")t(ms);else if(o.key==="0")e();else return;o.preventDefault(),o.stopPropagation()}),gt(a,t)}var I=52,qt=10,A=8,us=30,fs={solid:[],dash:[6,4],dot:[2,3]},St=class{films;active;look;box;range;heights;picked;named;values;constructor({key:t,title:e,unit:s,curves:i,
limits:o,symmetric:n=!1},r){this.key=t,this.title=e,this.unit=s,this.curves=i,this.limits=o,this.symmetric=n,this.shared=r,this.canvas=l("canvas",{class:"plot-c\
anvas"}),this.over=l("canvas",{class:"plot-canvas plot-over"}),this.keys=l("div",{class:"plot-keys"}),this.body=l("div",{class:"plot-body",tabindex:"0",role:"im\
g","aria-label":e},this.canvas,this.over),this.element=l("section",{class:"plot","data-plot":t},l("header",{},l("h3",{},e),this.keys),this.body),this.body.addEventListener(
"pointerdown",h=>this.press(h)),this.pinched=O(this.body,{zoom:(h,c)=>this.films&&this.zoomAbout(c?this.valueAt(c):this.middle(),1/h),home:()=>this.zoomTo(null),
keys:!0}),this.onseek=()=>{}}abscissa(t){return this.shared.axis==="time"?t.columns.t:t.derived("degrees",({angle:e})=>Float64Array.from(e,s=>s*180/Math.PI))}fullRange(){
if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.duration),1e-9)];let[t,e]=[1/0,-1/0];for(let s of this.films)for(let i of this.abscissa(s))
i<t&&(t=i),i>e&&(e=i);return e>t?[t,e]:[t-1,e+1]}draw(t,e,s,i){this.films=t,this.active=e,this.look=s;let{context:o,width:n,height:r}=R(this.canvas);this.box={width:n-
I-qt,height:r-A-us},o.clearRect(0,0,n,r),this.range=this.shared.range??this.fullRange();let h=t.flatMap((c,d)=>this.shades(c).map(p=>({...p,film:c,lane:d})));this.
heights=this.limits??this.findHeights(h),this.shared.axis==="time"&&this.bands(o,t[e],i),this.grid(o,s,n,r),o.save(),o.beginPath(),o.rect(I,A,this.box.width,this.
box.height),o.clip();for(let c of h)this.curve(o,c,t.length>1);o.restore(),this.legend(this.shades(t[e]),s.dark),this.describe(h)}shades(t){return this.curves(t).
map(e=>({...e,color:e.color&&bt(e.color,this.look.dark)}))}x(t){return I+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return A+(1-(t-this.
heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(t){let e=[];for(let{film:d,values:p}of t){let m=this.abscissa(d);for(let f=0;f<p.length;f++)
m[f]>=this.range[0]&&m[f]<=this.range[1]&&Number.isFinite(p[f])&&e.push(p[f])}if(!e.length)return[0,1];let s=Float64Array.from(e).sort(),[i,o]=[s[0],s[s.length-
1]],[n,r]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],h=Math.max(r-n,1e-12);o>r+4*h&&(o=r+.6*h),i<n-4*h&&(i=n-.6*h),i=Math.min(i,0),o=Math.max(o,
0),this.symmetric&&([i,o]=[-Math.max(-i,o),Math.max(-i,o)]);let c=.06*(o-i)||1;return[i<0?i-c:i,o+c]}bands(t,e,s){for(let i of e.phases){let o=b(this.x(i.from),
I,I+this.box.width),n=b(this.x(i.to),I,I+this.box.width);n<=o||(t.fillStyle=st(s.modes[i.mode],.14),t.fillRect(o,A,n-o,this.box.height))}}grid(t,e,s,i){t.font=`\
11px ${e.font}`,t.strokeStyle=e.line,t.fillStyle=e.soft,t.lineWidth=1;let o=Math.max(this.box.height/28,4);for(;$(this.heights[0],this.heights[1],o).length<3&&o<
12;)o+=1;let n=S(this.heights[1]-this.heights[0],o);t.textAlign="right",t.textBaseline="middle";for(let d of $(this.heights[0],this.heights[1],o)){let p=Math.round(
this.y(d))+.5;t.globalAlpha=Math.abs(d)<1e-9*n?1:.55,t.beginPath(),t.moveTo(I,p),t.lineTo(s-qt,p),t.stroke(),t.globalAlpha=1,t.fillText(P(d,n),I-6,p)}let r=this.
box.width/70,h=S(this.range[1]-this.range[0],r);t.textAlign="center",t.textBaseline="alphabetic";let c=this.shared.axis==="time"?"time [s]":"angle [°]";for(let d of $(
this.range[0],this.range[1],r)){let p=this.x(d);t.beginPath(),t.moveTo(p,A+this.box.height),t.lineTo(p,A+this.box.height+4),t.stroke(),t.fillText(P(d,h),p,A+this.
box.height+15)}t.textAlign="right",t.fillText(c,s-qt,i-3),t.save(),t.translate(11,A+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText(this.
unit,0,0),t.restore()}curve(t,{film:e,lane:s,values:i,color:o,dash:n},r){let h=this.abscissa(e);t.strokeStyle=o??this.look.ink,t.lineWidth=r&&s===1?1.2:1.8,t.setLineDash(
r&&s===1?[3,3]:fs[n??"solid"]),t.globalAlpha=r&&s===1?.85:1,t.beginPath();let c=!1;for(let d=0;d<i.length;d++){if(!Number.isFinite(i[d])||!Number.isFinite(h[d])){
c=!1;continue}let p=this.x(h[d]),m=b(this.y(i[d]),-1e4,1e4);c?t.lineTo(p,m):t.moveTo(p,m),c=!0}t.stroke(),t.setLineDash([]),t.globalAlpha=1}legend(t,e){let s=t.
map(i=>i.name).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>l("output",{})),this.keys.replaceChildren(...t.map((i,o)=>l("span",{class:"plot-key"},
Xt(i.color,i.dash),i.name," ",this.values[o]))))}describe(t){let e=t.slice(0,6).map(({name:s,values:i,lane:o})=>{let[n,r]=[1/0,-1/0];for(let c of i)c<n&&(n=c),c>
r&&(r=c);let h=this.films.length>1?`${"AB"[o]}: `:"";return r>=n?`${h}${s} from ${v(n,3)} to ${v(r,3)}`:""});this.body.setAttribute("aria-label",`${this.title} \
in ${this.unit}. ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.films)return;let{context:e,width:s,height:i}=R(this.over);if(e.clearRect(0,0,s,i),this.films.
forEach((o,n)=>{let r=o.at(t),h=this.x(this.shared.axis==="time"?r.t:r.angle*180/Math.PI),c=h>=I-1&&h<=I+this.box.width+1,d=o.index(r.t),p=Math.min(d+1,o.length-
1),m=o.t[p]>o.t[d]?(r.t-o.t[d])/(o.t[p]-o.t[d]):0;c&&(e.strokeStyle=this.look.soft,e.lineWidth=1,e.beginPath(),e.moveTo(h,A),e.lineTo(h,A+this.box.height),e.stroke()),
this.shades(o).forEach((f,u)=>{let w=f.values[p],g=Number.isFinite(w)?f.values[d]+m*(w-f.values[d]):f.values[d];n===this.active&&this.values?.[u]&&(this.values[u].
textContent=v(g,3));let y=this.y(g);!c||!(y>=A-1&&y<=A+this.box.height+1)||(e.fillStyle=f.color??this.look.ink,e.beginPath(),e.arc(h,y,3.2,0,2*Math.PI),e.fill())})}),
this.picked){let[o,n]=this.picked;e.fillStyle=st("#0072B2",.2),e.fillRect(Math.min(o,n),A,Math.abs(n-o),this.box.height)}}valueAt(t){let e=this.body.getBoundingClientRect(),
s=b((t.clientX-e.left-I)/this.box.width,0,1);return this.range[0]+s*(this.range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.body.getBoundingClientRect(),
s=t.clientX-e.left,i=this.valueAt(t),o=this.pinched(),n=r=>{if(o||=this.pinched(),o)return;let h=r.clientX-e.left;this.picked=t.pointerType==="mouse"&&Math.abs(
h-s)>5?[s,h]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(r)),this.cursor(this.shared.clock.time)};L(this.body,t,n,(r,h)=>{let c=this.valueAt(r),{picked:d}=this;
this.picked=null,d&&h?this.zoomTo(i<c?[i,c]:[c,i]):d?this.cursor(this.shared.clock.time):h&&!o&&this.seek(t.pointerType==="mouse"?i:c)})}seek(t){if(this.shared.
axis==="time")return this.onseek(t);let e=this.films[this.active],s=this.abscissa(e),i=0;for(let o=0;o<s.length;o++)Math.abs(s[o]-t)<Math.abs(s[i]-t)&&(i=o);return this.
onseek(e.t[i])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(t,e){let s=this.fullRange(),i=Math.max(t-(t-this.range[0])*e,s[0]),o=Math.min(t+(this.
range[1]-t)*e,s[1]);this.zoomTo(i<=s[0]&&o>=s[1]?null:[i,o])}zoomTo(t){this.shared.range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}};function Xt(a,t="solid"){
let e=l("i",{class:"swatch","aria-hidden":"true"});return e.style.borderTopColor=a??"var(--ink)",e.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted"}[t],
e}var B=52,ve=10,M=8,gs=30,ws="RSKHM?",Et=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(t,e,s){this.backend=
t,this.clock=e,this.colors=s,this.canvas=l("canvas",{class:"plot-canvas"}),this.over=l("canvas",{class:"plot-canvas plot-over"}),this.keys=l("div",{class:"plot-\
keys"}),this.body=l("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=l("section",{class:"phase"},l("header",{},l("h3",{},"Plane of θ and θ̇"),this.keys),this.body,l("p",{class:"hint"},
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox. "+(matchMedia("(hover: none)").matches?"Tap to go there, t\
wo fingers zoom.":"Click to go there; with Ctrl or Shift the wheel zooms, double-click for all."))),this.body.addEventListener("pointerdown",i=>this.seek(i)),this.
pinched=O(this.body,{zoom:(i,o)=>this.box&&this.zoomAbout(o?this.point(o):this.middle(),1/i),home:()=>this.zoomTo(null),keys:!0}),this.range=[0,2*Math.PI],this.
asked="",this.soon=Y(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),i=JSON.stringify([t.hoop,t.plane,s]);if(i!==this.asked){let o=await this.painted(
t,[0,2*Math.PI,-s,s],e);this.asked=i,this.pictures=[o],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.pictures||!this.window)){this.
sharpening?.abort(),this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,[...this.range,...this.window],this.sharpening.
signal);this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){let{header:i,arrays:o}=await this.backend.
call("regions",{scenario:t,window:e},s);return{window:i.window,paradox:o.paradox,picture:this.paint(o.modes,i.arrays[0].shape)}}reach(){return this.reached}findReach(){
let t=0;for(let s of this.films??[]){let i=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(t,i[Math.floor(.99*(i.length-1))]??
0)}let e=S(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}zoomTo(t){this.range=t??[0,2*Math.PI],this.window=null,this.pictures?.splice(1),this.redraw()}point(t){
let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left-B)/this.box.width,i=1-(t.clientY-e.top-M)/this.box.height;return[this.range[0]+s*(this.range[1]-this.
range[0]),this.bottom()+i*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.bottom()+this.top())]}zoomAbout([t,e],s){let i=Math.
max(t-(t-this.range[0])*s,0),o=Math.min(t+(this.range[1]-t)*s,2*Math.PI),n=this.reach(),r=Math.max(e-(e-this.bottom())*s,-n),h=Math.min(e+(this.top()-e)*s,n);this.
range=[i,o],this.window=o-i<2*Math.PI-1e-9||h-r<2*n-1e-9?[r,h]:null,this.redraw(),this.soon()}bottom(){return this.window?this.window[0]:this.backwards?-this.reach():
0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){this.films=t,this.active=e,this.look=s,this.reached=this.findReach(),
this.forwards=t.some(i=>i.columns.omega.some(o=>o>.3)),this.backwards=t.some(i=>i.columns.omega.some(o=>o<-.3)),!this.forwards&&!this.backwards&&(this.forwards=
!0),this.redraw()}x(t){return B+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return M+(1-(t-this.bottom())/(this.top()-this.bottom()))*this.
box.height}paint(t,[e,s]){let{modes:i}=this.colors,o=l("canvas",{width:s,height:e}),n=new ImageData(s,e);for(let r=0;r<e;r++)for(let h=0;h<s;h++){let c=ws[t[r*s+
h]],d=F(i[c]??"#6E6E6E"),p=4*((e-1-r)*s+h);n.data.set([...d,255],p)}return C(o).putImageData(n,0,0),o}redraw(){if(!this.films)return;let{colors:t,look:e}=this,{
context:s,width:i,height:o}=R(this.canvas);if(this.box={width:i-B-ve,height:o-M-gs},s.clearRect(0,0,i,o),s.save(),s.beginPath(),s.rect(B,M,this.box.width,this.box.
height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:n,window:r}of this.pictures){let[h,c,d,p]=r,m=[this.x(h),this.y(p),this.x(c)-this.x(h),
this.y(d)-this.y(p)];s.fillStyle=e.panel,s.fillRect(m[0],m[1],m[2],m[3]),s.globalAlpha=.35,s.drawImage(n,m[0],m[1],m[2],m[3]),s.globalAlpha=1}this.hatch(s)}for(let[
n,r]of this.films.entries())this.way(s,r,n);if(s.restore(),this.axes(s,i,o),this.keyed!==e.dark){this.keyed=e.dark;let n=Object.entries(t.mode_names).filter(([r])=>"\
RSKH".includes(r));this.keys.replaceChildren(...n.map(([r,h])=>l("span",{class:"plot-key"},Xt(t.modes[r]),h)))}this.cursor(this.clock.time)}hatch(t){let{paradox:e}=this.
pictures[0],s=e.length;t.strokeStyle=st(this.look.dark?"#ffffff":"#000000",.28),t.lineWidth=1;for(let i=0;i<s;i++){if(!e[i])continue;let o=i;for(;o<s&&e[o]===e[i];)
o++;let n=this.x(i*2*Math.PI/s),r=this.x(o*2*Math.PI/s);t.save(),t.beginPath(),t.rect(n,M,r-n,this.box.height),t.clip(),t.beginPath();let h=e[i];for(let c=-this.
box.height;c<r-n+this.box.height;c+=7)t.moveTo(n+c,h>0?M+this.box.height:M),t.lineTo(n+c+this.box.height,h>0?M:M+this.box.height);t.stroke(),t.restore(),i=o}}way(t,e,s){
let{angle:i,omega:o,mode:n}=e.columns,r=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=this.look.ink,t.beginPath();let h=null;for(let c=0;c<
e.length;c++){if(!Number.isFinite(o[c])){h=null;continue}let d=Math.floor(i[c]/r),p=i[c]-d*r;if(h===null)t.moveTo(this.x(p),this.y(o[c]));else if(d!==h.lap){let m=d>
h.lap?r:0;t.lineTo(this.x(m),this.y(o[c])),t.moveTo(this.x(r-m),this.y(o[c])),t.lineTo(this.x(p),this.y(o[c]))}else t.lineTo(this.x(p),this.y(o[c]));h={lap:d,mode:n[c]}}
t.stroke(),t.setLineDash([])}axes(t,e,s){let{look:i}=this;t.font=`11px ${i.font}`,t.strokeStyle=i.soft,t.fillStyle=i.soft,t.lineWidth=1,t.strokeRect(B+.5,M+.5,this.
box.width-1,this.box.height-1),t.textAlign="center";let o=this.range[0]*180/Math.PI,n=this.range[1]*180/Math.PI,r=n-o>200?45:S(n-o,6);for(let c=Math.ceil(o/r-1e-9);c*
r<=n+1e-9;c++){let d=this.x(c*r*Math.PI/180);t.beginPath(),t.moveTo(d,M+this.box.height),t.lineTo(d,M+this.box.height+4),t.stroke(),t.fillText(P(c*r,r),d,M+this.
box.height+15)}t.textAlign="right",t.fillText("angle θ within a turn [°]",e-ve,s-3),t.textBaseline="middle";let h=this.top()-this.bottom();for(let c of $(this.
bottom(),this.top(),5))t.fillText(P(c,S(h,5)),B-6,this.y(c));t.textBaseline="alphabetic",t.save(),t.translate(11,M+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign=
"center",t.fillText("θ̇ [rad/s]",0,0),t.restore()}cursor(t){if(!this.films||!this.box)return;let{context:e,width:s,height:i}=R(this.over);e.clearRect(0,0,s,i),
this.films.forEach((o,n)=>{let r=o.at(t),h=2*Math.PI,c=r.angle-Math.floor(r.angle/h)*h,d=this.x(c),p=this.y(r.omega);d>=B&&d<=B+this.box.width&&p>=M&&p<=M+this.
box.height&&(e.beginPath(),e.arc(d,p,n?4:5.5,0,2*Math.PI),e.fillStyle=this.colors.modes[r.mode],e.fill(),e.lineWidth=2,e.strokeStyle=this.look.ink,e.stroke())})}seek(t){
let e=this.body.getBoundingClientRect(),[s,i]=[t.clientX-e.left,t.clientY-e.top];if(this.pinched())return;let o=this.films[this.active],{angle:n,omega:r}=o.columns,
h=2*Math.PI,c={distance:1/0,t:0};for(let d=0;d<o.length;d++){let p=n[d]-Math.floor(n[d]/h)*h,m=Math.hypot(this.x(p)-s,this.y(r[d])-i);m<c.distance&&(c={distance:m,
t:o.t[d]})}c.distance<40&&this.clock.seek(b(c.t,0,o.duration))}};function ys(a){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:t=>[{name:"v (centre)",color:a.center_speed,values:t.columns.vx},{name:"\
R θ̇",color:a.rotation_speed,dash:"dash",values:t.derived("spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:t=>[{name:"kinetic",color:a.kinetic,values:t.columns.kinetic},{name:"potential",color:a.potential,values:t.columns.potential},{name:"\
total",values:t.derived("total",({t:e,kinetic:s,potential:i})=>Float64Array.from(e,(o,n)=>s[n]+i[n])),dash:"dash"},{name:"lost to friction",color:a.friction_loss,
values:t.columns.friction_loss},{name:t.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:a.impact_loss,values:t.columns.
normal_loss,dash:"dot"}]},{key:"forces",title:"Contact forces",unit:"force [N]",curves:t=>[{name:"normal N",color:a.normal_force,values:t.columns.normal_force},
{name:"friction F",color:a.friction_force,dash:"dash",values:t.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],
curves:t=>[{name:"|F| / μN",color:a.friction_force,values:t.columns.utilization}]}]}var At=class{films;active;look;constructor(t,e){this.colors=e,this.shared={
axis:"time",range:null,clock:t,changed:()=>this.redraw()},this.plots=ys(e).map(i=>new St(i,this.shared));for(let i of this.plots)i.onseek=o=>t.seek(o);this.seen=
new Map(this.plots.map(i=>[i.element,!0]));let s=new IntersectionObserver(i=>{for(let{target:o,isIntersecting:n}of i)this.seen.set(o,n);this.redraw()},{rootMargin:"\
400px"});for(let i of this.plots)s.observe(i.element);this.axis=l("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.
value,this.shared.range=null,this.redraw()}},l("option",{value:"time"},"over time"),l("option",{value:"angle"},"over angle")),this.back=l("button",{type:"button",
hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=l("span",{class:"hint"}),this.element=l("div",{class:"plots"},l("div",{class:"plots-\
head"},this.axis,this.back,this.hint),this.plots.map(i=>i.element))}draw(t,e,s){this.films=t,this.active=e,this.look=s;let i=matchMedia("(hover: none)").matches?
"slide to go there, two fingers zoom":"drag to zoom, double-click for all, click to go there";this.hint.textContent=t.length>1?`A full, B dotted; numbers and co\
lours of ${"AB"[e]}; ${i}`:i,this.redraw()}redraw(){if(this.films?.length){this.back.hidden=!this.shared.range;for(let t of this.visible())t.draw(this.films,this.
active,this.look,this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.plots.filter(t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())
e.cursor(t)}};var bs=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],_t=class{constructor(t){this.lab=t,this.menu=l("details",{class:"menu"},l("summary",{class:"button"},"Keep"),l("div",{class:"menu-body"},t.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),bs.map(([e,s])=>this.item(s,()=>this.download(e))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=l("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),t.root.addEventListener("pointerdown",e=>{this.menu.contains(e.target)||(this.menu.open=!1)})}item(t,e){return l("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await e()}catch(s){this.lab.notice.fail(s)}}},t)}async copyLink(){let t=this.lab.motions.link()??"";try{await navigator.clipboard.writeText(
t),this.lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",t)}}async download(t){let e=this.lab.film();this.lab.notice.say(t.endsWith(
"mp4")?"The film is being made; this takes a while …":`Fetching ${t} …`),lt(await this.lab.backend.file(t,e.query),`hophoop-${t}`),this.lab.notice.say(`${t}\
 is there.`)}picture(){this.lab.drawStage();let t=this.lab.stage.canvas(),e=l("canvas",{width:t.width,height:t.height});return this.copyInto(e),new Promise(s=>{
e.toBlob(i=>{i&&lt(i,"hophoop.png"),s()},"image/png")})}copyInto(t){let{lab:e}=this,s=e.stage.canvas(),i=C(t);i.fillStyle=e.theme.look.paper,i.fillRect(0,0,t.width,
t.height),i.drawImage(s,0,0,t.width,t.height);let o=t.width/Math.max(s.getBoundingClientRect().width,1);i.textBaseline="top",i.textAlign="left";let n=e.films();
for(let[r,h]of n.entries()){let c=h.at(e.clock.time),d=[n.length>1?`${"AB"[r]}: `:"",`${e.theme.colors.mode_names[c.mode]}, t = ${c.t.toFixed(3)} s, θ = ${rt(c.
angle)}, v = ${v(c.vx,3)} m/s`].join(""),p=e.stage.options.three?10+20*r:10+r*s.getBoundingClientRect().height/n.length;i.fillStyle=e.theme.colors.modes[c.mode],
i.fillRect(12*o,(p+2)*o,11*o,11*o),i.fillStyle=e.theme.look.ink,i.font=`${13*o}px ${e.theme.look.font}`,i.fillText(d,30*o,p*o)}}async record(){let{lab:t}=this,e=t.
stage.canvas();if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 instead.");let s=l("canvas",{width:2*
Math.ceil(e.width/2),height:2*Math.ceil(e.height/2)}),i=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),o=[];i.ondataavailable=h=>o.push(h.data);
let n=new Promise(h=>i.onstop=h),r=t.clock.loop;t.clock.loop=!1,t.clock.seek(0),t.notice.say("Recording one run …"),t.afterFrame=()=>{this.copyInto(s),!t.clock.
playing&&i.state==="recording"&&i.stop()},i.start(),t.clock.play(!0),await n,t.afterFrame=null,t.clock.loop=r,lt(new Blob(o,{type:i.mimeType}),"hophoop.webm"),t.
notice.say("The film is there.")}async code(){let{header:t}=await this.lab.backend.call("code",{scenario:this.lab.film().scenario});this.show("The same motion i\
n Python",t.python,"The scenario as a file",t.toml)}show(...t){let e=[];for(let s=0;s<t.length;s+=2){let i=t[s+1],o=l("button",{type:"button"},"Copy");o.onclick=
async()=>{await navigator.clipboard?.writeText(i).catch(()=>{}),o.textContent="Copied"},e.push(l("header",{},l("h2",{},t[s]),o),l("pre",{tabindex:"0"},l("code",
{},i)))}this.dialog.replaceChildren(...e,l("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};var xe=120,Pt=class{constructor(t,e){this.canvas=t,this.onview=e,this.zoom=1,this.shift=[0,0],t.addEventListener("pointerdown",s=>this.drag(s)),this.pinched=O(t,
{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>t.parentElement})}reset(){this.zoom=1,this.shift=[0,0],this.onview()}zoomBy(t){this.zoom=b(this.zoom*t,
.05,60),this.onview()}drag(t){let e=[t.clientX,t.clientY],s=this.shift;L(this.canvas,t,i=>{this.pinched()||(this.shift=[s[0]+i.clientX-e[0],s[1]+i.clientY-e[1]],
this.onview())})}draw(t,e,s,i,o){let{context:n,width:r,height:h}=R(this.canvas);if(n.clearRect(0,0,r,h),r<40||h<40)return;let c=h/t.length,d={top:Math.max(...t.
map(p=>p.extent.top)),radius:Math.max(...t.map(p=>p.radius)),speed:Math.max(...t.map(p=>p.extent.speed))};t.forEach((p,m)=>{n.save(),n.beginPath(),n.rect(0,m*c,
r,c),n.clip(),n.translate(0,m*c),new Yt(n,r,c,p,e,s,i,o,this.zoom,this.shift,d).draw(),t.length>1&&(n.fillStyle=i.soft,n.font=`600 15px ${i.font}`,n.textAlign="\
left",n.fillText("AB"[m],12,c-12)),n.restore(),m>0&&(n.fillStyle=i.line,n.fillRect(0,m*c-.5,r,1))})}},Yt=class{constructor(t,e,s,i,o,n,r,h,c,d,p){this.context=t,
this.width=e,this.height=s,this.film=i,this.options=n,this.look=r,this.colors=h,this.common=p,this.pose=i.at(o);let m=i.radius,{left:f,right:u}=i.extent,{top:w}=p;
this.cosine=Math.cos(i.slope),this.sine=Math.sin(i.slope);let g=2*p.radius+Math.min(w,6*p.radius),y=Math.min(.66*s/g,.36*e/p.radius);if(n.whole){let x=(u-f)*this.
cosine+2.6*m,k=(u-f)*Math.abs(this.sine)+2.6*m+w;this.scale=Math.min(e/x,.86*s/k,y)*c,this.focus=[.5*(f+u),0],this.place=[.5*e+d[0],(i.slope?.62:.8)*s+d[1]]}else
this.scale=y*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.place=[(e<520?.6:.46)*e+d[0],.82*s+d[1]]}point(t,e){let s=t-this.focus[0],i=e-this.
focus[1];return[this.place[0]+this.scale*(s*this.cosine+i*this.sine),this.place[1]-this.scale*(i*this.cosine-s*this.sine)]}draw(){this.ground(),this.options.traces&&
this.traces(),this.hoop(),this.options.forces&&this.forces()}ground(){let{context:t,look:e,width:s,height:i}=this,o=(Math.hypot(s,i)*1.2+Math.abs(this.place[0])+
Math.abs(this.place[1]))/this.scale,[n,r]=this.point(this.focus[0]-o,0),[h,c]=this.point(this.focus[0]+o,0),d=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,
t.beginPath(),t.moveTo(n,r),t.lineTo(h,c),t.lineTo(h+d[0],c+d[1]),t.lineTo(n+d[0],r+d[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(n,
r),t.lineTo(h,c),t.stroke();let p=S(s/this.scale,s/90);t.fillStyle=e.soft,t.font=`11px ${e.font}`,t.textAlign="center",t.lineWidth=1;let m=Math.ceil((this.focus[0]-
o)/p),f=Math.min(Math.floor((this.focus[0]+o)/p),m+400);for(let u=m;u<=f;u++){let[w,g]=this.point(u*p,0);w<-40||w>s+40||(t.beginPath(),t.moveTo(w,g),t.lineTo(w-
6*this.sine,g+6*this.cosine),t.stroke(),t.fillText(`${P(u*p,p)} m`,w-18*this.sine,g+8+10*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:i}=this,o=t.
index(this.pose.t),n=t.radius,{x:r,height:h,angle:c,mode:d}=t.columns,p=(m,f,u,w)=>{e.strokeStyle=f,e.lineWidth=u,e.lineJoin="round",e.beginPath();let g=!1,y=(x,k,T)=>{
let[N,U]=this.point(x+m*Math.sin(T),n+k+m*Math.cos(T));g?e.lineTo(N,U):e.moveTo(N,U),g=!0};for(let x=0;x<=o;x++)w===void 0||d[x]===3===w?y(r[x],h[x],c[x]):g=!1;
(w===void 0||this.pose.mode==="H"===w)&&y(this.pose.x,this.pose.height,this.pose.angle),e.stroke()};p(n,s.ink,1.3),p(t.eccentricity*n,i.gravity_center,1.8,!1),p(
t.eccentricity*n,i.airborne,2.4,!0)}hoop(){let{film:t,pose:e,context:s,look:i,colors:o,scale:n}=this,r=t.radius,h=b(.07*r*n,2,14),c=r-.5*h/n,d=[e.x,r+e.height],
p=(g,y=c)=>this.point(d[0]+y*Math.sin(g),d[1]+y*Math.cos(g));if(s.lineCap="butt",i.dark&&(s.strokeStyle=i.soft,s.lineWidth=h+2,s.beginPath(),s.arc(...this.point(
d[0],d[1]),c*n,0,2*Math.PI),s.stroke()),this.options.speed){let g=this.common.speed;s.lineWidth=h;let y=2*Math.PI/xe;for(let x=0;x<xe;x++){let k=e.angle+x*y,T=Math.
hypot(e.vx+r*e.omega*Math.cos(k+.5*y),e.vy-r*e.omega*Math.sin(k+.5*y));s.strokeStyle=vt[b(Math.round(255*T/g)||0,0,255)],s.beginPath(),s.moveTo(...p(k-.04*y)),s.
lineTo(...p(k+1.04*y)),s.stroke()}}else s.strokeStyle=o.modes[e.mode],s.lineWidth=h,s.beginPath(),s.arc(...this.point(d[0],d[1]),c*n,0,2*Math.PI),s.stroke();s.strokeStyle=
i.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(d[0],d[1])),s.lineTo(...p(e.angle)),s.stroke();let m=(g,y,x,k)=>{s.beginPath(),s.arc(...g,y,0,2*Math.PI),
s.fillStyle=x,s.fill(),s.lineWidth=1.5,s.strokeStyle=k,s.stroke()};m(this.point(d[0],d[1]),2.5,i.soft,i.soft);let f=t.scenario.hoop.parts;f?this.parts(f,d):m(p(
e.angle),b(.1*r*n,4,16),i.ink,i.paper);let u=t.eccentricity*r,w=this.point(d[0]+u*Math.sin(e.angle),d[1]+u*Math.cos(e.angle));m(w,b(.05*r*n,3.5,7),e.mode==="H"?
o.airborne:o.gravity_center,i.paper)}parts(t,e){let{film:s,pose:i,context:o,look:n,scale:r}=this,c=t.reduce((d,p)=>d+p.mass*(p.at??0),0)<0?-1:1;o.strokeStyle=n.
ink;for(let d of t){let p=c*(d.at??0),m=this.point(e[0]+p*Math.sin(i.angle),e[1]+p*Math.cos(i.angle));if(o.fillStyle=n.ink,o.lineWidth=1,o.beginPath(),d.shape===
"ring")o.globalAlpha=.22,o.arc(...m,d.outer_radius*r,0,2*Math.PI),o.arc(...m,d.inner_radius*r,0,2*Math.PI,!0),o.fill(),o.globalAlpha=1;else if(d.shape==="rod"){
let f=.5*d.length,u=w=>this.point(e[0]+w*Math.sin(i.angle),e[1]+w*Math.cos(i.angle));o.lineWidth=4,o.moveTo(...u(p-f)),o.lineTo(...u(p+f)),o.stroke()}else{let f=d.
shape==="disk"?d.radius*r:b(.08*s.radius*r,3,12);o.globalAlpha=d.shape==="disk"?.55:1,o.arc(...m,f,0,2*Math.PI),o.fill(),o.globalAlpha=1}}}forces(){let{film:t,pose:e,
colors:s}=this,i=t.radius,o=t.mass*(t.gravity||9.81),n=h=>.55*i*h/o;if(e.mode==="H"||!(e.normal_force>0))return;let r=[e.x,e.height];this.arrow(r,[0,n(e.normal_force)],
s.normal_force,`N = ${v(e.normal_force,3)} N`,!1),this.arrow(r,[n(e.friction_force),0],s.friction_force,`F = ${v(e.friction_force,3)} N`,!0)}arrow([t,e],[s,i],o,n,r){
let{context:h,look:c,width:d}=this,p=2.2*this.film.radius,m=Math.abs(s)>p||Math.abs(i)>p;[s,i]=[b(s,-p,p),b(i,-p,p)];let f=this.point(t,e),u=this.point(t+s,e+i),
w=Math.hypot(u[0]-f[0],u[1]-f[1]);if(w<2)return;let g=(u[0]-f[0])/w,y=(u[1]-f[1])/w,x=Math.min(11,w);for(let[N,U]of[[c.paper,6],[o,3]])h.strokeStyle=N,h.fillStyle=
N,h.lineWidth=U,h.beginPath(),h.moveTo(...f),h.lineTo(u[0]-g*x,u[1]-y*x),h.stroke();if(h.beginPath(),h.moveTo(...u),h.lineTo(u[0]-g*x-y*x*.5,u[1]-y*x+g*x*.5),h.
lineTo(u[0]-g*x+y*x*.5,u[1]-y*x-g*x*.5),h.fill(),m){let[N,U]=[f[0]+.55*g*w,f[1]+.55*y*w];h.strokeStyle=c.paper,h.lineWidth=2,h.beginPath();for(let ot of[-3,3])h.
moveTo(N+g*(ot-3)-y*7,U+y*(ot-3)+g*7),h.lineTo(N+g*(ot+3)+y*7,U+y*(ot+3)-g*7);h.stroke()}h.font=`600 12px ${c.font}`;let k=h.measureText(n).width;h.lineWidth=3,
h.strokeStyle=r?c.ground:c.paper,h.textAlign="left";let T=r?[f[0]-.5*k-32*this.sine,f[1]+32*this.cosine]:[u[0]+12,b(u[1]+4,16,f[1]-.36*this.film.radius*this.scale)];
T[0]=b(T[0],4,d-k-4),h.strokeText(n,T[0],T[1]),h.fillText(n,T[0],T[1])}};function Kt(a,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let i=0;i<4;i++){let o=0;for(let n=0;n<4;n++)o+=a[4*n+i]*t[4*s+n];e[4*s+i]=o}return e}function ke(a,t,e,s){
let i=1/Math.tan(a/2),o=1/(e-s);return new Float32Array([i/t,0,0,0,0,i,0,0,0,0,(s+e)*o,-1,0,0,2*s*e*o,0])}function Me(a,t){let e=W(Vt(a,t)),s=W(Rt([0,1,0],e)),i=Rt(
e,s);return new Float32Array([s[0],i[0],e[0],0,s[1],i[1],e[1],0,s[2],i[2],e[2],0,-Gt(s,a),-Gt(i,a),-Gt(e,a),1])}var Vt=(a,t)=>[a[0]-t[0],a[1]-t[1],a[2]-t[2]],Gt=(a,t)=>a[0]*
t[0]+a[1]*t[1]+a[2]*t[2],Rt=(a,t)=>[a[1]*t[2]-a[2]*t[1],a[2]*t[0]-a[0]*t[2],a[0]*t[1]-a[1]*t[0]];function W(a){let t=Math.hypot(...a)||1;return[a[0]/t,a[1]/t,a[2]/
t]}function It(a,t,e,s){let i=W(t),o=W(Rt(i,Math.abs(i[2])>.9?[1,0,0]:[0,0,1])),n=Rt(o,i);return new Float32Array([...o.map(r=>r*s),0,...i.map(r=>r*e),0,...n.map(
r=>r*s),0,...a,1])}function Jt(a){let[t,e]=[Math.cos(a),Math.sin(a)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function z(a){let t=Number.parseInt(a.slice(1,7),16);
return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function V(a,t,e){let s=a.createProgram(),i=[[a.VERTEX_SHADER,t],[a.FRAGMENT_SHADER,e]];for(let[n,r]of i){let h=a.createShader(n);if(a.shaderSource(h,r),a.compileShader(
h),!a.getShaderParameter(h,a.COMPILE_STATUS))throw new Error(String(a.getShaderInfoLog(h)));a.attachShader(s,h)}if(a.linkProgram(s),!a.getProgramParameter(s,a.LINK_STATUS))
throw new Error(String(a.getProgramInfoLog(s)));let o={program:s,uniforms:{},attributes:{}};for(let n=0;n<a.getProgramParameter(s,a.ACTIVE_UNIFORMS);n++){let{name:r}=a.
getActiveUniform(s,n);o.uniforms[r]=a.getUniformLocation(s,r)}for(let n=0;n<a.getProgramParameter(s,a.ACTIVE_ATTRIBUTES);n++){let{name:r}=a.getActiveAttrib(s,n);
o.attributes[r]=a.getAttribLocation(s,r)}return o}function j(a,t,e,s){let i=a.createBuffer();a.bindBuffer(a.ARRAY_BUFFER,i),a.bufferData(a.ARRAY_BUFFER,new Float32Array(
t),a.STATIC_DRAW);let o=s?a.createBuffer():null;s&&(a.bindBuffer(a.ELEMENT_ARRAY_BUFFER,o),a.bufferData(a.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),a.STATIC_DRAW));
let n=4*Object.values(e).reduce((r,h)=>r+h,0);return{vertices:i,elements:o,parts:e,stride:n,count:s?s.length:4*t.length/n}}function J(a,t,e){a.bindBuffer(a.ARRAY_BUFFER,
e.vertices);let s=0;for(let[i,o]of Object.entries(e.parts)){let n=t.attributes[i];n!==void 0&&(a.enableVertexAttribArray(n),a.vertexAttribPointer(n,o,a.FLOAT,!1,
e.stride,s)),s+=4*o}e.elements&&a.bindBuffer(a.ELEMENT_ARRAY_BUFFER,e.elements)}function Zt(a,t){let e=[];for(let s=0;s<a;s++)for(let i=0;i<t;i++){let o=s*(t+1)+
i,n=o+t+1;e.push(o,n,o+1,n,n+1,o+1)}return e}function Te(a,t=120,e=14){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++)s.push(2*Math.PI*i/t,2*Math.PI*o/e);return j(
a,s,{bend:2},Zt(t,e))}function Se(a,t=28,e=18){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++){let[n,r]=[2*Math.PI*i/t,Math.PI*o/e],h=[Math.sin(r)*Math.cos(
n),Math.cos(r),Math.sin(r)*Math.sin(n)];s.push(...h,...h)}return j(a,s,{position:3,normal:3},Zt(t,e))}function Qt(a,t,e=20){let s=[];for(let i=0;i<=e;i++){let o=2*
Math.PI*i/e,n=[Math.cos(o),1-t,Math.sin(o)];s.push(Math.cos(o),0,Math.sin(o),...n,t*Math.cos(o),1,t*Math.sin(o),...n)}return j(a,s,{position:3,normal:3},Zt(e,1))}var Pe=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Re=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Ie="vec4(0.0, 0.0, 0.0, shadow)",Ee=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Re}
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
   ${Pe}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Ie} : vec4(shaded(color, n), 1.0);
   }`],Ae=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Re}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${Pe}
   void main() { gl_FragColor = shadow > 0.0 ? ${Ie} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],_e=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],$t=class{constructor(t,e,s,i,{keep:o=!1}={}){let n=t.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:o});if(!n)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=n,this.canvas=
t,this.sun=W(s),this.dark=i,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=V(n,Ee[0],Ee[1]),this.body=V(n,Ae[0],Ae[1]),this.line=V(n,_e[0],_e[1]),this.torus=Te(n),
this.sphere=Se(n),this.cylinder=Qt(n,1),this.cone=Qt(n,0),this.colors=n.createTexture(),n.bindTexture(n.TEXTURE_2D,this.colors);let r=new Uint8Array(e.flatMap(h=>[
...h,255]));n.pixelStorei(n.UNPACK_ALIGNMENT,1),n.texImage2D(n.TEXTURE_2D,0,n.RGBA,e.length,1,0,n.RGBA,n.UNSIGNED_BYTE,r);for(let h of[n.TEXTURE_WRAP_S,n.TEXTURE_WRAP_T])
n.texParameteri(n.TEXTURE_2D,h,n.CLAMP_TO_EDGE);for(let h of[n.TEXTURE_MIN_FILTER,n.TEXTURE_MAG_FILTER])n.texParameteri(n.TEXTURE_2D,h,n.LINEAR);this.view=Jt(0),
this.eye=[0,0,1],this.fastest=1}begin({background:t,eye:e,target:s,slope:i,angle:o,near:n,far:r}){let{gl:h,canvas:c}=this;h.viewport(0,0,c.width,c.height),h.clearColor(
t[0],t[1],t[2],1),h.clear(h.COLOR_BUFFER_BIT|h.DEPTH_BUFFER_BIT|h.STENCIL_BUFFER_BIT),h.enable(h.DEPTH_TEST);let d=ke(o,c.width/c.height,n,r);this.view=Kt(Kt(d,
Me(e,s)),Jt(i)),this.eye=W(Vt(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let i={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[
o,n]of Object.entries(i)){let r=t.uniforms[o];r!==void 0&&(typeof n=="number"?s.uniform1f(r,n):n.length===16?s.uniformMatrix4fv(r,!1,n):s[`uniform${n.length}fv`](
r,n))}}ground(t){let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,
e.ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),
e.depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:i=!1,lit:o=!0}={}){let{gl:n}=this;this.use(this.body,{model:e,color:s,shadow:i?
this.dark:0,lit:Number(o)}),J(n,this.body,t),n.drawElements(n.TRIANGLES,t.count,n.UNSIGNED_SHORT,0)}ball(t,e,s,i){this.solid(this.sphere,It(t,[0,1,0],e,e),s,{shadow:i})}ring({
center:t,radius:e,tube:s,broad:i,angle:o,velocity:n,omega:r,plain:h=null},c){let{gl:d}=this;this.use(this.rim,{center:t,size:[e,s,i,o],motion:[...n,r],most:this.
fastest,shadow:c?this.dark:0,plain:h??[0,0,0],colored:h?0:1}),J(d,this.rim,this.torus),d.drawElements(d.TRIANGLES,this.torus.count,d.UNSIGNED_SHORT,0)}rod(t,e,s,i,o,n=!1){
this.solid(this.cylinder,It(t,e,s,i),o,{shadow:n})}arrow(t,e,s,i,o){if(!(s>.02*i))return;let n=Math.min(.18*i,s),r=t.map((h,c)=>h+e[c]*(s-n));s>n&&this.rod(t,e,
s-n,.029*i,o),this.solid(this.cone,It(r,e,n,Math.min(.075*i,.6*n)),o)}trace(t,e,s){let i=[];for(let o=0;o<t;o++){let n=e(o),r=e(Math.min(o+1,t-1));if(Math.hypot(
r[0]-n[0],r[1]-n[1])<1e-9&&o>0){let h=e(o-1);r=n.map((c,d)=>2*c-h[d])}for(let h of[-1,1])i.push(...n,0,...r,0,...s(o),h)}return j(this.gl,i,{position:3,next:3,tint:3,
side:1})}drawTrace(t,e,{width:s,distance:i=0,shift:o,depth:n}){let{gl:r,canvas:h}=this;this.use(this.line,{pixel:[2/h.width,2/h.height],width:s,distance:i,shift:o,
depth:n}),J(r,this.line,t),r.drawArrays(r.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let i=this.view,[o,n,r]=[0,1,3].map(h=>i[h]*t+i[4+h]*e+i[8+h]*s+i[12+h]);return r>
0?[(.5+.5*o/r)*this.canvas.width,(.5-.5*n/r)*this.canvas.height]:null}};var vs=[.35,.85,.4],xs=.18,$e={azimuth:.5,height:.22,distance:5.2},ze=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],zt=class{constructor(t,e){this.canvas=t,this.onview=e,this.space=new $t(t,G,vs,xs,{keep:!0}),this.floor=V(this.space.gl,ze[0],ze[1]),this.corners=j(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...$e},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,t.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=O(t,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>t.parentElement})}zoomBy(t){t?this.turned.distance=b(
this.turned.distance/t,1.6,60):this.turned={...$e},this.onview()}drag(t){let e={...this.turned,x:t.clientX,y:t.clientY};L(this.canvas,t,s=>{this.pinched()||(this.
turned.azimuth=b(e.azimuth-(s.clientX-e.x)*.008,-1.5,1.5),this.turned.height=b(e.height+(s.clientY-e.y)*.006,.02,1.45),this.onview())})}quality(){let t=performance.
now(),e=t-(this.before||t);return this.before=t,e>0&&e<200&&(this.pace=.9*this.pace+.1*e),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(t,e,s,i,o,n){let{canvas:r,space:h}=this,c=Math.min(globalThis.devicePixelRatio||1,2)*(n?this.quality():1),d=r.getBoundingClientRect();r.
width=Math.max(Math.round(d.width*c),1),r.height=Math.max(Math.round(d.height*c),1);let p=t.map(u=>u.at(e)),m=t[0].radius;h.fastest=Math.max(...t.map(u=>u.extent.
speed)),this.focus=Number.isFinite(p[0].x)?p[0].x:0,h.begin({background:z(i.paper),...this.camera(t[0],p[0],m,s)}),h.ground(()=>this.drawFloor(m,i));let f=u=>{for(let[
w,g]of t.entries())u(g,p[w],-2.1*m*w)};h.shadows(()=>f((u,w,g)=>this.drawHoop(u,w,g,s,i,o,!0))),f((u,w,g)=>{this.drawHoop(u,w,g,s,i,o,!1),s.traces&&this.drawTraces(
u,w,g,i,o,c),s.forces&&this.drawForces(u,w,g,o)})}camera(t,e,s,i){let{azimuth:o,height:n,distance:r}=this.turned,{left:h,right:c}=t.extent,d=i.whole?Math.max(r*
s,.85*(c-h)+3*s):r*s,[p,m]=[i.whole?.5*(h+c)-this.focus:0,s+.45*(e.height||0)],f=Math.cos(t.slope),u=Math.sin(t.slope),w=[p*f+m*u,-p*u+m*f,0],g=[w[0]+d*Math.sin(
o)*Math.cos(n),w[1]+d*Math.sin(n),d*Math.cos(o)*Math.cos(n)];return this.reach=12*s+3*d,{eye:g,target:w,slope:t.slope,angle:.75,near:.05*s,far:40*s+6*d}}drawFloor(t,e){
let{space:s}=this,i=z(e.ground),o=i.map(h=>h*(e.dark?.82:.94)),n=.5*t,r=this.focus%(2*n);s.use(this.floor,{reach:this.reach,light:i,dark:o,far:z(e.paper),tile:n,
shift:r}),J(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(t,e,s,i,o,n,r){let{space:h}=this,c=t.radius,d=.045*c,p=[e.x-this.focus,
c+e.height,s];h.ring({center:p,radius:c,tube:d,broad:3.2*d,angle:e.angle,velocity:[e.vx,e.vy],omega:e.omega,plain:i.speed?null:z(n.modes[e.mode])},r);let m=[Math.
sin(e.angle),Math.cos(e.angle),0],f=w=>p.map((g,y)=>g+w*m[y]);h.ball(f(c-d),.125*c,o.dark?[.9,.91,.94]:[.12,.13,.15],r),h.rod(p,m,c-d,.012*c,[.55,.57,.6],r);let u=e.
mode==="H";h.ball(f(t.eccentricity*c),.07*c,z(u?n.airborne:n.gravity_center),r)}drawForces(t,e,s,i){if(e.mode==="H"||!(e.normal_force>0))return;let o=t.radius,n=t.
mass*(t.gravity||9.81),r=[e.x-this.focus,e.height+.03*o,s+.2*o],h=d=>b(.55*o*Math.abs(d)/n,0,3.2*o),c=Math.sign(e.friction_force);this.space.arrow(r,[0,1,0],h(e.
normal_force),o,z(i.normal_force)),this.space.arrow(r,[c,0,0],h(e.friction_force),o,z(i.friction_force))}linesOf(t,e,s){let i=this.lines.get(t);if(i?.dark===e.dark)
return i;let o=t.radius,{x:n,height:r,angle:h,mode:c}=t.columns,d=(w,g)=>this.space.trace(t.length,y=>[n[y]+w*Math.sin(h[y]),o+r[y]+w*Math.cos(h[y])],g),[p,m,f]=[
z(s.gravity_center),z(s.airborne),z(e.ink)],u={dark:e.dark,load:d(o,()=>f),center:d(t.eccentricity*o,w=>c[w]===3?m:p)};return this.lines.set(t,u),u}drawTraces(t,e,s,i,o,n){
let{load:r,center:h}=this.linesOf(t,i,o),c=Math.min(t.index(e.t)+2,t.length),d={shift:this.focus,depth:s};this.space.drawTrace(r,c,{width:n,...d}),this.space.drawTrace(
h,c,{width:1.6*n,...d})}};var ks=["hoop","mode","time","angle","v","R θ̇","gap"],Lt=class{constructor(t,e){this.colors=t,this.onview=e,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1},this.plane=l("canvas",{class:"stage-canvas"}),this.space=l("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new Pt(this.plane,e),this.deep=null,this.
outputs=ks.map(i=>({name:l("dt",{},i),value:l("dd",{})})),this.outputs[1].value.className="mode",this.fastest=l("span",{}),this.legend=l("div",{class:"legend","\
aria-hidden":"true"},l("i",{style:`background: linear-gradient(90deg, ${vt.filter((i,o)=>o%15===0).join(",")})`}),l("span",{},"0"),l("span",{},"rim speed"),this.
fastest);let s=(i,o)=>l("span",{},l("i",{class:"dot",style:`background:${i}`}),o);this.order=l("span",{hidden:!0},"A in front, B behind"),this.element=l("div",{
class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,l("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(({name:i,
value:o})=>[i,o])),this.legend,l("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(t.gravity_center,"centre of gravity"),s(t.airborne,"ai\
rborne"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(t,e,s,{look:i,inks:o}){let{options:n}=this;this.legend.hidden=!n.speed,this.
order.hidden=!(n.three&&t.length>1),this.fastest.textContent=`≥ ${v(Math.max(...t.map(r=>r.extent.speed)),2)} m/s`,n.three?(this.deep??=new zt(this.space,this.
onview),this.deep.draw(t,s.time,n,i,o,s.playing)):this.flat.draw(t,s.time,n,i,o),this.read(t,e,s.time)}read(t,e,s){let i=t[e],o=i.at(s),n=[t.length>1?"AB"[e]:"",
this.colors.mode_names[o.mode],`${o.t.toFixed(3)} s`,rt(o.angle),_(v(o.vx,3),"m/s"),_(v(o.omega*i.radius,3),"m/s"),o.height>0?se(o.height):"0"];for(let[c,d]of n.
entries()){let{value:p}=this.outputs[c];p.textContent!==d&&(p.textContent=d)}let[r,h]=this.outputs;r.value.hidden=r.name.hidden=t.length<2,h.value.style.setProperty(
"--mode",this.colors.modes[o.mode])}describe(t){this.element.setAttribute("aria-label",`The hoop. ${t.map(e=>e.summary).join(" ")}`)}turn(t){let e=()=>{this.plane.
hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,e();try{t()}catch(s){throw this.options.three=!1,e(),s}}zoom(t){
this.options.three?this.deep?.zoomBy(t):t?this.flat.zoomBy(t):this.flat.reset()}};var Ft=class{film;items;current;constructor(t){this.clock=t,this.summary=l("p",{class:"summary"}),this.list=l("ol",{class:"story-list"}),this.heading=l("h2",{},
"What happens"),this.live=l("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=l("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(t,e,s){this.film=t[e],this.heading.textContent=t.length>1?`What happens to hoop ${"AB"[e]}`:"What happens",this.
summary.replaceChildren(...t.flatMap((i,o)=>[t.length>1?l("b",{},`${"AB"[o]}: `):"",i.summary,i.status==="event_limit"||i.shortened?" (not all events are shown)":
"",o+1<t.length?l("br"):""])),this.items=this.film.story.map(i=>l("li",{},l("button",{type:"button",onclick:()=>this.clock.seek(i.t)},l("i",{class:"dot",style:`\
background:${s.modes[i.mode]}`,"aria-hidden":"true"}),l("span",{class:"when"},`${v(i.t,4)} s`),l("span",{},i.text)))),this.list.replaceChildren(...this.items),this.
current=-1,this.cursor(this.clock.time)}announce(t){this.live.textContent=t.map(e=>e.summary).join(" ")}cursor(t){let{story:e}=this.film,s=-1;for(let o=0;o<e.length&&
e[o].t<=t+1e-9;o++)s=o;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),this.items[this.current]?.
removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let i=this.items[s];if(i){let o=i.offsetTop-this.list.offsetTop;
(o<this.list.scrollTop||o+i.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=o-.4*this.list.clientHeight)}}},Nt=class{constructor(){
this.list=l("dl",{}),this.heading=l("h2",{},"What theory says"),this.element=l("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){this.heading.textContent=
e?`What theory says of hoop ${e}`:"What theory says",this.list.replaceChildren(...t.flatMap(({label:s,text:i})=>[l("dt",{},s),l("dd",{},i)]))}};var Le="hophoop-theme",Ms=["gravity_center","airborne","normal_force","friction_force"],Ct=class{constructor(t,e,s,i){this.root=t,this.colors=e,this.hosted=s,this.
changed=i,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=Dt(t),this.inks={...e},this.read()}mark(){let t=this.hosted?Ts(Le):null;this.root.dataset.theme=this.chosen??t??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=Dt(this.root),this.inks={...this.colors};for(let t of Ms)
this.inks[t]=bt(this.colors[t],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&Ss(Le,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};function Ts(a){try{return localStorage.getItem(a)}catch{
return null}}function Ss(a,t){try{localStorage.setItem(a,t)}catch{}}var Es={takeoff:"▲",impact:"▼",apex:"•",jam:"✖",kane_gain:"✚",bounce_limit:"≋",turn:"↺",rest:"■",painleve_inconsistent:"◆",painleve_indeterminate:"\
◇",skim:"◗"},As={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns b\
ack",apex:"highest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"j\
am",kane_gain:"energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},Ot=class{films;constructor(t){this.clock=t,this.canvas=l("canvas",{class:"ti\
meline-canvas"}),this.tip=l("div",{class:"tip",hidden:!0}),this.element=l("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"\
0","aria-orientation":"horizontal"},this.canvas,this.tip),this.element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermo\
ve",e=>this.hover(e)),this.element.addEventListener("pointerleave",()=>this.tip.hidden=!0)}timeAt(t){let e=this.canvas.getBoundingClientRect();return b((t.clientX-
e.left)/e.width,0,1)*this.clock.duration}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});let e=this.clock.playing;this.clock.playing=!1;let s=i=>this.
clock.seek(this.timeAt(i));s(t),L(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){let e=this.timeAt(t),s=this.nearest(e,8),i=s?`${As[s.kind]??s.kind} · ${v(
s.t,5)} s · ${v(s.angle*180/Math.PI,4)}°`:`${v(e,4)} s`;this.tip.textContent=i,this.tip.hidden=!1;let o=this.canvas.getBoundingClientRect();this.tip.style.left=
`${b(t.clientX-o.left,70,o.width-70)}px`}nearest(t,e){let s=e*this.clock.duration/(this.canvas.getBoundingClientRect().width||1),i=null;for(let o of this.films??
[])for(let n of o.events){if(n.kind==="end")continue;let r=Math.abs(n.t-t);r<=s&&(!i||r<Math.abs(i.t-t))&&(i=n)}return i}draw(t,e,s){this.films=t;let{context:i,
width:o,height:n}=R(this.canvas),r=this.clock.duration||1,h=u=>u/r*o;i.clearRect(0,0,o,n);let c=15,d=(n-15)/t.length-c;t.forEach((u,w)=>{let g=c+w*(c+d);for(let y of u.
phases){let x=h(y.from),k=Math.max(h(y.to)-x,.6),T=s.modes[y.mode];i.fillStyle=T,i.fillRect(x,g,k,d-2),this.named(i,s.mode_names[y.mode],x,k,g,d-2,T,e)}u.duration<
r&&(i.fillStyle=e.line,i.fillRect(h(u.duration),g,o,d-2)),this.marks(i,u,h,g,o,e),t.length>1&&(i.fillStyle=e.soft,i.font=`600 11px ${e.font}`,i.textAlign="left",
i.fillText("AB"[w],1,g-4))});let p=S(r,o/60);i.fillStyle=e.soft,i.font=`10.5px ${e.font}`;for(let u of $(0,r,o/60))i.textAlign=u===0?"left":h(u)>o-14?"right":"c\
enter",i.fillText(P(u,p)+(u===0?" s":""),h(u),n-3);let m=b(h(this.clock.time),6,o-6),f=b(h(this.clock.time),1,o-1);i.fillStyle=e.ink,i.fillRect(f-1,c-4,2,n-c-9),
i.beginPath(),i.moveTo(m-6,c-10),i.lineTo(m+6,c-10),i.lineTo(f,c-1),i.fill(),this.element.setAttribute("aria-valuemax",r.toFixed(3)),this.element.setAttribute("\
aria-valuenow",this.clock.time.toFixed(3)),this.element.setAttribute("aria-valuetext",`${v(this.clock.time,4)} seconds`)}named(t,e,s,i,o,n,r,h){t.font=`11px ${h.
font}`,!(n<13||t.measureText(e).width+8>i)&&(t.fillStyle=me(r),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*i,o+.5*n+1),t.textBaseline="alphab\
etic")}marks(t,e,s,i,o,n){t.font=`11px ${n.font}`,t.textAlign="center";let r=-1/0;for(let h of e.events){let c=Es[h.kind],d=s(h.t);h.kind!=="start"&&h.kind!=="e\
nd"&&(t.fillStyle=n.panel,t.fillRect(d-.5,i,1,5)),!(!c||d-r<8)&&(r=d,t.fillStyle=n.ink,t.fillText(c,b(d,6,o-6),i-4))}}};var _s=1/60,Ps=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],Rs={three:"In space"},D=(a,t,e)=>l(
"button",{type:"button",title:t,"aria-label":t,onclick:e},a),Fe=(a,t)=>l("span",{},l("span",{"aria-hidden":"true"},`${a} `),t),Bt=class{constructor(t,e,s,i){this.
clock=t,this.films=e,this.say=i,this.playButton=D(E("play"),"Play (space)",()=>t.play()),this.playButton.classList.add("play"),this.speeds=l("select",{"aria-lab\
el":"Speed of the film",onchange:()=>{t.speed=Number(this.speeds.value)}},Q.map(o=>l("option",{value:String(o)},`${o}×`))),this.speeds.value="1",this.switches=
new Map(Ps.map(([o,n,r])=>{let h=`${o==="three"?Rs.three:n} (${r})`;return[o,l("button",{type:"button",class:"switch",title:h,onclick:()=>s(o)},n)]})),this.element=
l("div",{class:"transport"},l("div",{class:"buttons"},D(E("start"),"To the start (Home)",()=>t.seek(0)),D(E("previous"),"Previous event (Shift ←)",()=>this.jump(
-1)),D(E("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,D(E("on"),"One frame on (→)",()=>this.nudge(1)),D(E("next"),"Next event (Shift →)",
()=>this.jump(1))),l("div",{class:"buttons"},D(Fe("▲","hop"),"To the next hop (h)",()=>this.jump(1,"takeoff")),D(Fe("▼","landing"),"To the next landing (l)",
()=>this.jump(1,"impact"))),this.speeds,l("div",{class:"buttons switches"},[...this.switches.values()]))}show(t){let{clock:e,playButton:s}=this;for(let[o,n]of this.
switches)n.setAttribute("aria-pressed",String(t[o]));let i=e.playing?"Pause (space)":"Play (space)";(s.title!==i||!s.firstChild)&&(s.replaceChildren(E(e.playing?
"pause":"play")),s.title=i,s.setAttribute("aria-label",i)),this.speeds.value!==String(e.speed)&&(this.speeds.value=String(e.speed))}nudge(t){this.clock.playing=
!1,this.clock.seek(this.clock.time+t*_s*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap(n=>n.events).filter(n=>e?n.
kind===e:!0).map(n=>n.t).sort((n,r)=>n-r),i=this.clock.time,o=t>0?s.find(n=>n>i+1e-9):s.findLast(n=>n<i-1e-9);if(o===void 0&&e&&(o=s[0]),o===void 0){e&&this.say(
e==="takeoff"?"This motion has no hop.":"This motion has no landing.");return}this.clock.seek(o)}};var it=class{constructor(t,e,s,{hosted:i=!1,panels:o=null,onmotion:n=()=>{}}={}){this.root=t,this.backend=e,this.hosted=i,this.onmotion=n,this.prepareRoot();let{
colors:r}=s;this.clock=new ht,this.motions=new Mt(e,{shown:h=>this.changed(h),settled:()=>this.story.announce(this.films()),noted:()=>this.noted(),failed:h=>this.
notice.fail(h)}),this.notice=new Tt,this.theme=new Ct(t,r,i,()=>this.show()),this.stage=new Lt(r,()=>this.request()),this.transport=new Bt(this.clock,()=>this.films(),
h=>this.toggle(h),h=>this.notice.say(h)),this.timeline=new Ot(this.clock),this.story=new Ft(this.clock),this.theory=new Nt,this.plots=new At(this.clock,r),this.
phase=new Et(e,this.clock,r),this.map=new xt(e,s,h=>{this.clock.time=0,this.motions.change(h,!0)}),this.controls=new pt(s.controls,(h,c)=>this.motions.change(h,
c)),this.share=new _t(this),this.help=ae(s.version),this.hoops=new ut(h=>this.motions.choose(h)),this.header=new mt(s.presets,this.share.menu,{take:h=>this.take(
h),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(
o),this.requested=!1,this.surrounding=!1,this.afterFrame=null,this.asked=null,this.later=Y(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=
this.frame.bind(this),this.clock.listeners.add(()=>this.request()),this.deaf=re(this,i),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){this.root.classList.
add("hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts="true")}layOut(t){
let{root:e,notice:s}=this,i=h=>!t||t.includes(h),o=l("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.element),n=l("d\
iv",{class:"middle"},l("div",{class:"player"},this.stage.element,this.timeline.element,this.transport.element),l("div",{class:"words"},this.story.element,i("the\
ory")&&this.theory.element),i("map")&&this.map.element),r=l("div",{class:"why"},i("plots")&&this.plots.element,i("plots")&&this.phase.element);e.replaceChildren(
l("div",{class:"page"},this.header.element,l("div",{class:"columns"},i("controls")&&o,n,r)),s.toast,this.share.dialog,this.help),e.classList.toggle("no-controls",
!i("controls"))}async open(t){await this.motions.load(t),this.begin()}begin(){this.motions.note(),this.show(),this.sizes.observe(this.stage.element),this.root.dataset.
ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.map.close(),this.theme.close(),this.sizes.disconnect(),this.deaf()}film(t=this.motions.active){
return this.motions.film(t)}films(){return this.motions.films()}changed(t=null){t!==null&&(this.header.presets.value=""),this.notice.clear(),this.show(t)}noted(){
this.header.show(this.motions.history,this.motions.lanes.length>1),this.hosted&&history.replaceState(null,"",this.motions.link()),this.onmotion(this.film().query)}async take(t){
try{let e=await this.backend.call("film",{query:t.query});this.clock.time=0,this.motions.replace(e),this.hoops.text.textContent=t.text,this.story.announce(this.
films())}catch(e){this.notice.fail(e)}}async travel(t){await this.motions.travel(t),this.hoops.text.textContent=""}show(t=null){let{motions:e,clock:s}=this,i=this.
films();if(!i.length)return;let o=i.length>1;this.theme.read(),s.duration=Math.max(...i.map(n=>n.duration)),s.time=Math.min(s.time,s.duration),this.root.classList.
toggle("two",o),this.header.show(e.history,o),this.hoops.show(i.length,e.active),this.drawStage(),this.controls.show(this.film()),t!==null&&requestAnimationFrame(
()=>setTimeout(()=>this.latencies.push(performance.now()-t),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),
0)))}showSurroundings(){this.surrounding=!1;let t=this.films(),{active:e}=this.motions,{look:s,colors:i}=this.theme;this.plots.draw(t,e,s),this.phase.draw(t,e,s),
this.story.draw(t,e,i),this.drawTime(),this.map.mark(this.film(),s),this.stage.describe(t),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,
this.clock,this.theme)}drawTime(){let{time:t}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(
t),this.phase.cursor(t),this.story.cursor(t),this.transport.show(this.stage.options))}request(){this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){
this.requested=!1,this.motions.lanes.length&&(this.clock.tick(t),this.drawStage(),this.drawTime(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){
let{scenario:t}=this.film();this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked;try{let s=await this.backend.call("theory",{scenario:t},
e);this.theory.draw(s.header.thresholds,this.motions.name()),await this.phase.fetch(t,e)}catch(s){let{name:i,message:o}=s;i!=="AbortError"&&this.theory.draw([{label:"\
–",text:o}])}}toggle(t){let{options:e}=this.stage;if(t!=="three")e[t]=!e[t];else try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}
this.transport.show(e),this.request()}};async function Is(a){let t=new URL("./",document.baseURI.split(/[?#]/)[0]),e=new nt(t),s;try{s=(await e.call("setup",{})).header}catch(n){a.textContent=n.message;
return}let i=new it(a,e,s,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let o=new URLSearchParams(location.hash.slice(1)).get("with");try{await i.open([
location.search.slice(1),...o===null?[]:[o]])}catch(n){history.replaceState(null,"",t),await i.open([""]),i.notice.fail(n)}}function $s({model:a,el:t}){let e=document.
createElement("div");t.append(e);let s=new at(a),i=new it(e,s,a.get("setup"),{panels:a.get("panels"),onmotion:n=>{a.get("query")!==n&&(a.set("query",n),a.save_changes())}});
i.motions.set([q(a.get("film"))]),i.begin();let o=()=>i.motions.replace(q(a.get("film")));return a.on("change:film",o),()=>{a.off("change:film",o),s.close(),i.close()}}
var Ne=document.getElementById("hophoop-lab");Ne&&Is(Ne);var sn={render:$s};export{sn as default};
