/* Built from web/lab/main.js by esbuild 0.28.2; sources b154002e1efb52ef276843082cbbaabf */
function c(n,t={},...e){let s=document.createElement(n);for(let[i,o]of Object.entries(t))o==null||o===!1||(i.startsWith("on")?s.addEventListener(i.slice(2),o):i===
"class"?s.className=o:i in s&&i!=="list"&&typeof o!="string"?s[i]=o:s.setAttribute(i,o===!0?"":o));for(let i of e.flat())i==null||i===!1||s.append(i.nodeType?i:
document.createTextNode(String(i)));return s}var _=n=>n.getRootNode().activeElement===n,b=(n,t,e)=>Math.min(Math.max(n,t),e);function v(n,t=4){if(n==null)return"\
–";if(typeof n!="number")return String(n);if(!Number.isFinite(n))return Number.isNaN(n)?"–":n>0?"∞":"−∞";if(n===0)return"0";let e=Math.abs(n),s;if(e>=
1e6||e<1e-4){let[i,o]=n.toExponential(t-1).split("e");s=`${Ft(i)}·10${ne(Number(o))}`}else s=Ft(n.toPrecision(t)),s.includes("e")&&(s=String(Math.round(n)));return s.
replace("-","−")}function Ft(n){return n.includes(".")&&!n.includes("e")?n.replace(/\.?0+$/,""):n}function ne(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",
4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}var L=(n,t)=>t?t==="°"?`${n}°`:`${n} ${t}`:n,et=n=>`${(n*180/Math.
PI).toFixed(1)}°`.replace("-","−");function Nt(n){let t=Math.abs(n),[e,s]=t>=.995?[1,"m"]:t>=.00995?[100,"cm"]:[1e3,"mm"];return L(v(n*e,3),s)}function S(n,t){
let e=n/Math.max(t,1),s=10**Math.floor(Math.log10(e)),i=e/s;return(i>5?10:i>2?5:i>1?2:1)*s}function $(n,t,e){if(!(t>n)||!Number.isFinite(n)||!Number.isFinite(t))
return[];let s=S(t-n,e),i=[];for(let o=Math.ceil(n/s-1e-9);o*s<=t+1e-9*s&&i.length<200;o++)i.push(o*s);return i}function P(n,t){let e=b(-Math.floor(Math.log10(t)+
1e-9),0,15);return Math.max(Math.abs(n),t)>=1e6||e>12?v(n,3):(Math.abs(n)<t*1e-6?0:n).toFixed(e).replace("-","−")}function R(n){let t=n.getBoundingClientRect(),
e=Math.min(globalThis.devicePixelRatio||1,2.5),s=Math.max(Math.round(t.width*e),1),i=Math.max(Math.round(t.height*e),1);(n.width!==s||n.height!==i)&&(n.width=s,
n.height=i);let o=n.getContext("2d");return o.setTransform(e,0,0,e,0,0),{context:o,width:s/e,height:i/e}}function F(n){let t=Number.parseInt(n.slice(1,7),16);return[
t>>16&255,t>>8&255,t&255]}var Dt=n=>St(n)>.2?"#111111":"#ffffff",V=(n,t)=>`rgba(${F(n).join(",")},${t})`,ae=n=>{let t=n/255;return t<=.04045?t/12.92:((t+.055)/1.055)**
2.4};function St(n){let[t,e,s]=F(n).map(ae);return .2126*t+.7152*e+.0722*s}function st(n,t){if(!t||!/^#[0-9a-f]{6}$/i.test(n))return n;if(St(n)<.002)return"#ece\
ef2";let e=n;for(let s=0;St(e)<.2&&s<1;s+=.05)e=`#${F(n).map(i=>Math.round(i+(255-i)*s).toString(16).padStart(2,"0")).join("")}`;return e}var he={play:"M5 3l9 5\
.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"M8.5 3.5v10l-\
6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"M11 2.5l4 4-4\
 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.\
5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function E(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 \
17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class","icon");let s=document.createElementNS(t,"path");return s.setAttribute("d",he[n]),e.append(s),
e}var tt=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function re(){let n=[];for(let t=0;t<256;t++){let e=t/255*(tt.
length-1),s=Math.min(Math.floor(e),tt.length-2),i=F(tt[s]),o=F(tt[s+1]);n.push(i.map((a,h)=>Math.round(a+(o[h]-a)*(e-s))))}return n}var X=re(),it=X.map(n=>`rgb(${n.
join(",")})`);function Ot(n){let t=getComputedStyle(n),e=s=>t.getPropertyValue(s).trim();return{ink:e("--ink"),soft:e("--soft"),line:e("--line"),paper:e("--pape\
r"),panel:e("--panel"),ground:e("--ground"),font:e("--font"),dark:e("--dark")==="1"}}function B(n,t,e,s=()=>{}){let i=new AbortController,{signal:o}=i,a=(r,l)=>n.
addEventListener(r,d=>d.pointerId===t.pointerId&&l(d),{signal:o}),h=r=>l=>{i.abort(),s(l,r)};n.setPointerCapture(t.pointerId),a("pointermove",e),a("pointerup",h(
!0)),a("pointercancel",h(!1))}function C(n,t){let e=new Map,s=null,i=()=>{let[a,h]=[...e.values()];return{span:Math.max(Math.hypot(a.clientX-h.clientX,a.clientY-
h.clientY),1),clientX:.5*(a.clientX+h.clientX),clientY:.5*(a.clientY+h.clientY)}};n.addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(e.set(a.pointerId,
a),s=e.size===2?i():null)}),n.addEventListener("pointermove",a=>{if(!e.has(a.pointerId)||(e.set(a.pointerId,a),e.size!==2||!s))return;let h=i();t(h.span/s.span,
h),s=h});for(let a of["pointerup","pointercancel"])n.addEventListener(a,h=>{e.delete(h.pointerId),s=null});let o=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();
return n.addEventListener("touchmove",o,{passive:!1}),()=>e.size>1}function ot(n,t){let e=c("a",{href:URL.createObjectURL(n),download:t});document.body.append(e),
e.click(),e.remove(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function q(n,t){let e=0;return(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)}}var J=[.05,.1,.25,.5,1,2,4],nt=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let t of this.listeners)t(this)}seek(t){this.time=b(t,0,this.duration),this.changed()}play(t=!this.playing){this.playing=t,this.last=null,t&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(t){let e=J.indexOf(this.speed);this.speed=J[b(e+t,0,J.length-1)],this.changed()}tick(t){if(!this.playing)return!1;
let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};var ce={f8:Float64Array,f4:Float32Array,u1:Uint8Array},Et="RSKHM";function Y(n){let t=n instanceof DataView||ArrayBuffer.isView(n)?n:new DataView(n),e=new Uint8Array(
t.buffer,t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(
e.subarray(4,4+s))),o={};for(let{name:a,type:h,shape:r,place:l}of i.arrays){let d=r.reduce((p,f)=>p*f,1);o[a]=new ce[h](e.buffer,e.byteOffset+4+s+l,d)}return{header:i,
arrays:o}}var le=new Set(["x","angle","height"]),de={x:"vx",angle:"omega",height:"vy"},D=class{constructor(t){Object.assign(this,t.header),this.columns=t.arrays,
this.t=t.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radius"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccent\
ricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.
cache=new Map}findPhases(){let{mode:t}=this.columns,e=[];for(let s=0;s<this.length;s++){let i=e.at(-1);i&&i.mode===Et[t[s]]?i.to=this.t[s]:e.push({mode:Et[t[s]],
from:this.t[s],to:this.t[s]})}for(let s=0;s+1<e.length;s++)e[s].to=e[s+1].from;return e.filter(s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,
vy:i,omega:o}=this.columns,a={left:1/0,right:-1/0,top:0,speed:0},h=[];for(let r=0;r<this.length;r++){Number.isFinite(t[r])&&(a.left=Math.min(a.left,t[r]),a.right=
Math.max(a.right,t[r])),e[r]>a.top&&(a.top=e[r]);let l=Math.hypot(s[r],i[r])+this.radius*Math.abs(o[r]);Number.isFinite(l)&&h.push(l)}return h.sort((r,l)=>r-l),
a.speed=h[Math.floor(.95*(h.length-1))]||1,a}index(t){let e=0,s=this.length;for(;s-e>1;){let i=e+s>>1;this.t[i]<=t?e=i:s=i}return e}at(t){let e=b(t,0,this.duration),
s=this.index(e),i=Math.min(s+1,this.length-1),o=this.t[i]-this.t[s],a=o>0?(e-this.t[s])/o:0,h={t:e,mode:Et[this.columns.mode[s]]};for(let[r,l]of Object.entries(
this.columns)){if(r==="t"||r==="mode")continue;let d=l[s],p=l[i];if(a===0||!Number.isFinite(p))h[r]=d;else if(le.has(r)){let f=this.columns[de[r]];h[r]=pe(d,p,f[s]*
o,f[i]*o,a)}else h[r]=d+(p-d)*a}return h}derived(t,e){return this.cache.has(t)||this.cache.set(t,e(this.columns,this)),this.cache.get(t)}};function pe(n,t,e,s,i){
if(!Number.isFinite(e)||!Number.isFinite(s))return n+(t-n)*i;let o=1-i;return o*o*(1+2*i)*n+i*i*(3-2*i)*t+i*o*(o*e-i*s)}var Ut={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},ue={mass:"mass [kg]",inner_radius:"inner radius [m]",outer_radius:"outer radius [m]",radius:"radius [m\
]",at:"distance from centre [m]",length:"length [m]"},fe=(n,t,e)=>({ring:{shape:n,mass:e,inner_radius:.95*t,outer_radius:t},disk:{shape:n,mass:e,radius:.1*t,at:.8*
t},point_mass:{shape:n,mass:e,at:t},rod:{shape:n,mass:e,length:.5*t,at:.5*t}})[n];function Ht(n){let t=n["hoop.radius"],e=n["hoop.mass"],s=Math.min(Math.max(n["\
hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:at(e*(1-s)),inner_radius:at(.98*t),outer_radius:t},{shape:"point_mass",mass:at(e*s),at:t}]}var at=n=>Number(
n.toPrecision(6)),ht=class{constructor(t){this.onchange=t,this.list=c("div",{class:"parts"}),this.element=c("div",{},this.list,c("select",{"aria-label":"Add a p\
art",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,fe(s,this.radius,at(.2*this.mass))])}},c("option",{value:""},"+ add a part \
…"),Object.entries(Ut).map(([e,{label:s}])=>c("option",{value:e},s))))}send(t){this.onchange([["hoop.parts",t]])}show(t,e,s){let i=JSON.stringify(t);if(i===this.
text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(this,{text:i,parts:t,radius:e,mass:s}),this.list.replaceChildren(
...t.map((o,a)=>this.row(o,a)))}row(t,e){let{label:s,keys:i}=Ut[t.shape];return c("fieldset",{class:"part"},c("legend",{},s,this.parts.length>1&&c("button",{type:"\
button",class:"quiet","aria-label":`Remove part ${e+1}, ${s}`,onclick:()=>this.send(this.parts.filter((o,a)=>a!==e))},"×")),i.map(o=>c("label",{},ue[o],c("inpu\
t",{type:"number",step:"any",value:String(t[o]??0),onchange:a=>this.send(this.parts.map((h,r)=>r===e?{...h,[o]:Number(a.target.value)}:h))}))))}};var Wt=Math.PI/180,At=class{constructor(t,e){this.info=t,this.onchange=e;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`;this.range=c("input",{type:"\
range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,oninput:()=>this.slid(!1),
onchange:()=>this.slid(!0)}),this.number=c("input",{type:"number",step:"any",class:"exact","aria-label":`${t.label}, exact value${t.unit?` in ${t.unit}`:""}`,onchange:()=>this.
typed()}),this.element=c("div",{class:"control",title:t.help},c("label",{for:s},c("span",{},t.label),c("span",{class:"symbol"},t.symbol)),this.range,c("span",{class:"\
entry"},this.number,c("span",{class:"unit"},t.unit)))}low(){return this.info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?
Math.log10(this.info.most):this.info.most}slid(t){let e=Number(this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.number.value=String(
s),this.say(s),this.send(s,t)}typed(){this.number.value.trim()!==""&&this.send(Number(this.number.value),!0)}send(t,e){this.onchange([[this.info.path,this.info.
degrees?t*Wt:t]],e)}say(t){this.range.setAttribute("aria-valuetext",L(v(t,4),this.info.unit))}show(t,e=null){let s=t!=null,i=s?t:e;if(i==null){this.number.value=
"";return}let o=i==="inf"?1/0:this.info.degrees?i/Wt:i,a=Number.isFinite(o)?String(Number(o.toPrecision(9))):"";this.number.value=s?a:"",this.number.placeholder=
s?Number.isFinite(o)?"":"∞":`auto ${v(o,2)}`,this.number.title=s?L(String(o),this.info.unit):"";let h=this.info.logarithmic?Math.log10(o):o;(!_(this.range)||Math.
abs(Number(this.range.value)-h)>1e-6)&&(this.range.value=String(b(h,this.low(),this.high()))),this.say(o)}};function me(n,t){let e=c("select",{"data-path":n.path,
onchange:()=>t([[n.path,e.value]],!0)},n.options.map(([i,o])=>c("option",{value:i},o)));return{element:c("label",{class:"choice",title:n.help},c("span",{},n.label),
e),select:e,path:n.path}}var rt=class{constructor(t,e){this.onchange=(s,i=!0)=>e(s,i),this.sliders=new Map;for(let s of Object.values(t.groups))for(let i of s)this.
sliders.set(i.path,new At(i,this.onchange));this.choices=new Map(t.choices.map(s=>[s.path,me(s,this.onchange)])),this.parts=new ht(this.onchange),this.gravities=
t.gravities,this.element=c("div",{class:"controls"},this.hoop(),this.plane(),this.start(),this.contact())}at(t){return(this.sliders.get(t)??this.choices.get(t)).
element}select(t,e,s){let i=c("select",{onchange:()=>s(i.value)},e.map(([o,a])=>c("option",{value:o},a)));return{select:i,element:c("label",{class:"choice"},c("\
span",{},t),i)}}group(t,...e){let s=t==="Start"||t==="Plane"||!matchMedia("(max-width: 760px)").matches;return c("details",{class:"group",open:s},c("summary",{},
t),e)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],t=>{let{values:e}=this.
film;t==="parts"?this.onchange([["hoop.parts",Ht(e)]]):this.onchange([[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=c("p",{class:"derived"}),this.group(
"Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.eccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.r\
adius"),this.at("hoop.mass"))}plane(){return this.apart=c("input",{type:"checkbox",onchange:()=>{let{values:t}=this.film;this.apart.checked?this.onchange([["pla\
ne.mu_static",t["plane.mu_static"]],["plane.mu_kinetic",t["plane.mu_kinetic"]]]):this.onchange([["plane.mu",t["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([t])=>[t,t]),["","elsewhere"]],t=>{let e=this.gravities.find(([s])=>s===t);e&&this.onchange([["plane.gravity",e[1]]])}),this.group(
"Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_kinetic"),c("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.
at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("plane.restitution"),this.at("plane.impact_law"),this.at("plane.painleve"))}start(){return this.
kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],t=>{let{values:e}=this.film;t==="rolling"?this.onchange([["start.speed",e["start.vx"]]]):
this.onchange([["start.omega",e["start.omega"]]])}),this.group("Start",this.kind.element,this.at("start.speed"),this.at("start.angle"),this.at("start.height"),this.
at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.at("duration"))}contact(){return this.group("Contact",this.at("contact.model"),this.at("contact.l\
aw"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitution"))}show(t){this.film=t;let{scenario:e,values:s}=t,
i=e.hoop.parts?"parts":"load_fraction"in e.hoop?"load_fraction":"eccentricity",o="speed"in e.start,a="mu_static"in e.plane,h=e.contact.model==="compliant";this.
way.select.value=i,this.kind.select.value=o?"rolling":"free",this.apart.checked=a;let r=this.gravities.find(([,d])=>Math.abs(d-e.plane.gravity)<1e-9);this.gravity.
select.value=r?r[0]:"";let l={"hoop.load_fraction":i==="load_fraction","hoop.eccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!==
"parts","plane.mu":!a,"plane.mu_static":a,"plane.mu_kinetic":a,"plane.restitution":!h,"plane.impact_law":!h,"plane.painleve":!h,"start.speed":o,"start.height":!o,
"start.vx":!o,"start.vy":!o,"start.omega":!o,"contact.law":h,"contact.friction":h,"contact.stiffness":h,"contact.slip_speed":h,"contact.restitution":h};for(let[
d,p]of Object.entries(l))this.at(d).hidden=!p;this.parts.element.hidden=i!=="parts",i==="parts"&&this.parts.show(e.hoop.parts,s["hoop.radius"],s["hoop.mass"]),this.
derived.textContent=i==="eccentricity"?"":`ε = ${v(s["hoop.eccentricity"],5)}, κ = ${v(s["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${v(s["hoop.mass"],5)}\
 kg`:"");for(let[d,p]of this.sliders){let[f,g]=d.split(".");p.show(s[d]??(g?e[f]?.[g]:e[f]),t.automatic?.[d])}for(let[d,{select:p}]of this.choices){let[f,g]=d.split(
".");e[f]?.[g]!==void 0&&(p.value=e[f][g])}}};var[jt,ge]=[62,92],ye=12,H=10,we=36,Xt=[[24,16],[72,48],[216,144]],ct=Math.PI/180,lt=class{constructor(t){this.lab=t;let{map_axes:e}=t.setup.controls;this.axes=
new Map(e.map(i=>[i.path,i])),this.what="sequence",this.paths={x:"start.speed",y:"plane.mu"},this.windows={x:[...this.axes.get("start.speed").range],y:[...this.
axes.get("plane.mu").range]},this.layers=[],this.canvas=c("canvas",{class:"plot-canvas"}),this.tip=c("div",{class:"tip",hidden:!0}),this.body=c("div",{class:"ma\
p-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.
tip),this.keys=c("div",{class:"map-keys"}),this.state=c("span",{class:"hint",role:"status"});let s=(i,o)=>c("label",{},o,c("select",{"data-axis":i,onchange:a=>this.
setAxis(i,a.target.value)},e.map(({path:a,label:h})=>c("option",{value:a},h))));this.selects={x:s("x","Across"),y:s("y","Up")},this.quantity=c("select",{"aria-l\
abel":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},t.setup.map_quantities.map(([i,o])=>c("option",{value:i},o))),this.element=
c("section",{class:"map","aria-label":"Map of motions"},c("div",{class:"map-head"},c("h2",{},"Map"),c("label",{},"of",this.quantity),this.selects.x,this.selects.
y,c("span",{class:"buttons"},c("button",{type:"button","aria-label":"Zoom into the map",onclick:()=>this.zoom(.5)},"+"),c("button",{type:"button","aria-label":"\
Zoom out of the map",onclick:()=>this.zoom(2)},"−"),c("button",{type:"button",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,c("p",{class:"\
hint"},"Click to take that motion into the player; wheel or two fingers to zoom, drag to move.")),this.body.addEventListener("wheel",i=>this.wheel(i),{passive:!1}),
this.body.addEventListener("pointerdown",i=>this.press(i)),this.body.addEventListener("pointermove",i=>this.hover(i)),this.body.addEventListener("pointerleave",
()=>this.tip.hidden=!0),this.body.addEventListener("dblclick",()=>this.zoom(.35,this.pointed)),this.body.addEventListener("keydown",i=>this.key(i)),this.pinched=
C(this.body,(i,o)=>this.box&&this.zoom(1/i,this.place(o))),this.left=jt,this.soon=q(()=>this.refresh(),140),this.seen=!1,new IntersectionObserver(([i])=>{this.seen=
i.isIntersecting,this.seen&&this.stale&&this.refresh()}).observe(this.body),this.syncSelects()}syncSelects(){for(let t of["x","y"])this.selects[t].querySelector(
"select").value=this.paths[t]}setAxis(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t],this.windows[s]=[...this.windows[t]]),this.paths[t]=
e,this.windows[t]=[...this.axes.get(e).range],this.syncSelects(),this.home()}home(){for(let t of["x","y"])this.windows[t]=[...this.axes.get(this.paths[t]).range];
this.refresh()}key_of(t){let e=structuredClone(t);for(let s of Object.values(this.paths)){let[i,o]=s.split(".");e[i]&&delete e[i][o]}return JSON.stringify(e)}mark(t){
this.film=t;let e=this.key_of(t.scenario);e!==this.key_now&&(this.key_now=e,this.soon()),this.redraw()}async refresh(){if(!this.film)return;if(!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let i=`${this.what} ${this.paths.x} ${this.paths.y} ${this.key_now}`;i!==this.kind&&(this.layers=[]),this.kind=i,this.
redraw();try{for(let[o,a]of Xt){this.state.textContent=`computing ${o*a} motions …`;let h={scenario:e,changes:s,x:this.axis("x",o),y:this.axis("y",a),what:this.
what},r=await this.lab.backend.call("map",h,t);this.add(r),this.state.textContent=`${o*a} motions${s.length?", with rigid contact":""}`,this.redraw()}this.level=
Xt.length}catch(o){if(o.name==="AbortError")return;this.state.textContent=o.message}this.computing=!1}axis(t,e){let[s,i]=this.windows[t];return{path:this.paths[t],
from:s,to:i,cells:e}}add({header:t,arrays:e}){let{values:s}=e,{x:i,y:o,classes:a}=t,h=new ImageData(i.cells,o.cells),[r,l]=[1/0,-1/0];if(!a){for(let u of s)u<r&&
(r=u),u>l&&(l=u);["hop_height","flight_time","energy_lost","greatest_utilisation"].includes(t.what)&&(r=Math.min(r,0))}let d=a?.map(({color:u})=>F(u));for(let u=0;u<
o.cells;u++)for(let y=0;y<i.cells;y++){let m=s[u*i.cells+y],w=4*((o.cells-1-u)*i.cells+y);if(!Number.isFinite(m))continue;let x=d&&(y+1<i.cells&&s[u*i.cells+y+1]!==
m||u+1<o.cells&&s[(u+1)*i.cells+y]!==m),k=d?d[m].map(T=>x?.72*T:T):X[b(Math.round(255*(m-r)/(l-r||1)),0,255)];h.data.set([...k,255],w)}let p=c("canvas",{width:i.
cells,height:o.cells});p.getContext("2d").putImageData(h,0,0);let f={picture:p,header:t,values:s,x:[i.from,i.to],y:[o.from,o.to],low:r,high:l},g=(u,y)=>u[0]>=y[0]-
1e-300&&u[1]<=y[1]+1e-300;this.layers=this.layers.filter(u=>!(g(u.x,f.x)&&g(u.y,f.y))),this.layers.push(f),this.layers.length>12&&this.layers.shift(),this.legend(
f)}legend({header:t,low:e,high:s,values:i}){if(!t.classes){let h=c("canvas",{width:120,height:10,style:"width:120px;height:10px"}),r=h.getContext("2d");for(let p=0;p<
120;p++)r.fillStyle=`rgb(${X[Math.floor(255*p/119)].join(",")})`,r.fillRect(p,0,1,10);let l=t.unit==="rad"?1/ct:1,d=t.unit==="rad"?"°":t.unit==="1"?"":t.unit;this.
keys.replaceChildren(c("span",{},`${t.label}: ${s>=e?v(e*l,3):"none"} `),h,c("span",{},s>=e?L(v(s*l,3),d):""),i.some(p=>!Number.isFinite(p))?c("span",{},c("i",{
class:"blank"}),"none"):"");return}let o=new Map;for(let h of i)o.set(h,(o.get(h)??0)+1);let a=[...o].filter(([h])=>h>=0).sort((h,r)=>r[1]-h[1]);this.keys.replaceChildren(
...a.slice(0,10).map(([h])=>{let{color:r,text:l}=t.classes[h];return c("span",{},c("i",{style:`background:${r}`,"aria-hidden":"true"}),l)}),a.length>10?c("span",
{},`and ${a.length-10} more`):"")}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-e)*this.box.width}y(t){let[e,s]=this.windows.y;return H+(1-(t-e)/(s-e))*
this.box.height}redraw(){if(!this.film)return;let{look:t}=this.lab,{context:e,width:s,height:i}=R(this.canvas);this.left=this.deep("y")?ge:jt,this.box={width:s-
this.left-ye,height:i-H-we},e.clearRect(0,0,s,i),e.save(),e.beginPath(),e.rect(this.left,H,this.box.width,this.box.height),e.clip(),e.imageSmoothingEnabled=!1;for(let a of this.
layers){let[h,r]=a.x.map(p=>this.x(p)),[l,d]=a.y.map(p=>this.y(p));e.drawImage(a.picture,h,d,r-h,l-d)}let o=this.here();o&&this.cross(e,this.x(o.x),this.y(o.y),
t.ink,t.paper),this.pointed&&_(this.body)&&this.cross(e,this.x(this.pointed.x),this.y(this.pointed.y),"#D55E00",t.paper),e.restore(),this.frame(e,i,t)}cross(t,e,s,i,o){
for(let[a,h]of[[o,4],[i,1.8]])t.strokeStyle=a,t.lineWidth=h,t.beginPath(),t.arc(e,s,7,0,2*Math.PI),t.moveTo(e-13,s),t.lineTo(e-4,s),t.moveTo(e+4,s),t.lineTo(e+13,
s),t.moveTo(e,s-13),t.lineTo(e,s-4),t.moveTo(e,s+4),t.lineTo(e,s+13),t.stroke()}here(){let t=s=>{let[i,o]=s.split(".");return this.film.values[s]??this.film.scenario[i]?.[o]},
e={x:t(this.paths.x),y:t(this.paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}deep(t){let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.
abs(e),Math.abs(s))}frame(t,e,s){t.strokeStyle=s.soft,t.fillStyle=s.soft,t.lineWidth=1,t.strokeRect(this.left+.5,H+.5,this.box.width-1,this.box.height-1),t.font=
`11px ${s.font}`;for(let i of["x","y"]){let o=this.axes.get(this.paths[i]),a=o.degrees?1/ct:1,[h,r]=this.windows[i].map(m=>m*a),l=i==="x"?this.box.width/80:this.
box.height/40,d=S(r-h,l),p=this.deep(i),f=p?Number((.5*(h+r)).toPrecision(12)):0,g=p?$(h-f,r-f,l).map(m=>m+f):$(h,r,l);for(let m of g){let w=p?v(m-f,3):P(m,d);i===
"x"?(t.textAlign="center",t.fillText(w,this.x(m/a),H+this.box.height+14)):(t.textAlign="right",t.textBaseline="middle",t.fillText(w,this.left-5,this.y(m/a)),t.textBaseline=
"alphabetic")}let u=p?` − ${String(f).replace("-","−")}`:"",y=`${o.label}${u}${o.unit?` [${o.unit}]`:""}`;t.save(),t.textAlign="center",i==="x"?t.translate(
this.left+.5*this.box.width,e-5):(t.translate(12,H+.5*this.box.height),t.rotate(-Math.PI/2)),t.fillText(y,0,0),t.restore()}}place(t){let e=this.body.getBoundingClientRect(),
s=(t.clientX-e.left-this.left)/this.box.width,i=1-(t.clientY-e.top-H)/this.box.height,o=([a,h],r)=>a+b(r,0,1)*(h-a);return{x:o(this.windows.x,s),y:o(this.windows.
y,i)}}value(t){for(let e of[...this.layers].reverse()){let{x:s,y:i}=e.header,o=Math.floor((t.x-s.from)/(s.to-s.from)*s.cells),a=Math.floor((t.y-i.from)/(i.to-i.
from)*i.cells);if(o<0||a<0||o>=s.cells||a>=i.cells)continue;let h=e.values[a*s.cells+o];if(e.header.classes)return e.header.classes[h]?.text??"not allowed";let r=e.
header.unit==="rad",l=r?"°":e.header.unit==="1"?"":e.header.unit;return Number.isFinite(h)?L(v(r?h/ct:h,4),l):"none"}return"…"}said(t){let e=s=>{let i=this.axes.
get(this.paths[s]),[o,a]=this.windows[s],h=Math.max(Math.abs(o),Math.abs(a)),r=b(Math.ceil(Math.log10(h/(a-o)))+4,4,16);return`${i.label} = ${L(v(i.degrees?t[s]/
ct:t[s],r),i.unit)}`};return`${e("x")}, ${e("y")}: ${this.value(t)}`}hover(t){if(!this.box||this.dragging||t.pointerType==="touch")return;let e=this.place(t);this.
tip.textContent=this.said(e),this.tip.hidden=!1;let s=this.body.getBoundingClientRect();this.tip.style.left=`${b(t.clientX-s.left,150,Math.max(s.width-150,150))}\
px`,this.tip.style.bottom=`${s.bottom-t.clientY+16}px`}press(t){t.preventDefault(),this.body.focus({preventScroll:!0});let e=[t.clientX,t.clientY],s={x:[...this.
windows.x],y:[...this.windows.y]};this.pointed=this.place(t);let i=this.pinched(),o=a=>{if(i||=this.pinched(),i)return;let[h,r]=[a.clientX-e[0],a.clientY-e[1]];
if(Math.hypot(h,r)<5&&!this.dragging)return;this.dragging=!0,this.tip.hidden=!0;let l=(d,p)=>s[d].map(f=>f+p*(s[d][1]-s[d][0]));this.windows.x=l("x",-h/this.box.
width),this.windows.y=l("y",r/this.box.height),this.redraw(),this.soon()};B(this.body,t,o,(a,h)=>{h&&!this.dragging&&!i&&this.take(this.pointed),this.dragging=!1})}take(t){
this.lab.clock.time=0,this.lab.change([[this.paths.x,t.x],[this.paths.y,t.y]],!0)}wheel(t){this.box&&(t.preventDefault(),this.zoom(Math.exp(b(t.deltaY,-200,200)*
.0022),this.place(t)))}zoom(t,e){this.tip.hidden=!0;let s={};for(let i of["x","y"]){let[o,a]=this.windows[i],h=e?.[i]??.5*(o+a);s[i]=[h-(h-o)*t,h+(a-h)*t];let r=Math.
max(Math.abs(s[i][0]),Math.abs(s[i][1]),1e-9);if(s[i][1]-s[i][0]<400*Number.EPSILON*r)return;let{range:l}=this.axes.get(this.paths[i]);if(s[i][1]-s[i][0]>4*(l[1]-
l[0]))return}this.windows=s,this.redraw(),this.soon()}key(t){let e={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},s=i=>.5*(this.windows[i][0]+
this.windows[i][1]);if(this.pointed??=this.here()??{x:s("x"),y:s("y")},e[t.key]){let[i,o]=e[t.key],a=(h,r)=>r*(this.windows[h][1]-this.windows[h][0])/48;this.pointed=
{x:this.pointed.x+a("x",i),y:this.pointed.y+a("y",o)},this.state.textContent=this.said(this.pointed)}else if(t.key==="Enter")this.take(this.pointed);else if(t.key===
"+"||t.key==="=")this.zoom(.6,this.pointed);else if(t.key==="-")this.zoom(1.7,this.pointed);else if(t.key==="0")this.home();else return;t.preventDefault(),t.stopPropagation(),
this.redraw()}};var I=52,_t=10,A=8,be=30,ve={solid:[],dash:[6,4],dot:[2,3]},dt=class{constructor({key:t,title:e,unit:s,curves:i,limits:o,symmetric:a=!1},h){Object.assign(this,{
key:t,title:e,unit:s,curves:i,limits:o,symmetric:a,shared:h}),this.canvas=c("canvas",{class:"plot-canvas"}),this.over=c("canvas",{class:"plot-canvas plot-over"}),
this.keys=c("div",{class:"plot-keys"}),this.body=c("div",{class:"plot-body",tabindex:"0",role:"img","aria-label":e},this.canvas,this.over),this.element=c("secti\
on",{class:"plot","data-plot":t},c("header",{},c("h3",{},e),this.keys),this.body),this.body.addEventListener("pointerdown",r=>this.press(r)),this.body.addEventListener(
"wheel",r=>this.wheel(r),{passive:!1}),this.body.addEventListener("dblclick",()=>this.zoomTo(null)),this.body.addEventListener("keydown",r=>this.key_(r)),this.pinched=
C(this.body,(r,l)=>this.films&&this.zoomAbout(this.valueAt(l),1/r)),this.onseek=()=>{}}abscissa(t){return this.shared.axis==="time"?t.columns.t:t.derived("degre\
es",({angle:e})=>Float64Array.from(e,s=>s*180/Math.PI))}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.duration),1e-9)];let[t,
e]=[1/0,-1/0];for(let s of this.films)for(let i of this.abscissa(s))i<t&&(t=i),i>e&&(e=i);return e>t?[t,e]:[t-1,e+1]}draw(t,e,s,i){this.films=t,this.active=e,this.
look=s;let{context:o,width:a,height:h}=R(this.canvas);this.box={width:a-I-_t,height:h-A-be},o.clearRect(0,0,a,h),this.range=this.shared.range??this.fullRange();
let r=t.flatMap((l,d)=>this.shades(l).map(p=>({...p,film:l,lane:d})));this.heights=this.limits??this.findHeights(r),this.shared.axis==="time"&&this.bands(o,t[e],
i),this.grid(o,s,a,h),o.save(),o.beginPath(),o.rect(I,A,this.box.width,this.box.height),o.clip();for(let l of r)this.curve(o,l,t.length>1);o.restore(),this.legend(
this.shades(t[e]),s.dark),this.describe(r)}shades(t){return this.curves(t).map(e=>({...e,color:e.color&&st(e.color,this.look.dark)}))}x(t){return I+(t-this.range[0])/
(this.range[1]-this.range[0])*this.box.width}y(t){return A+(1-(t-this.heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(t){let e=[];for(let{
film:d,values:p}of t){let f=this.abscissa(d);for(let g=0;g<p.length;g++)f[g]>=this.range[0]&&f[g]<=this.range[1]&&Number.isFinite(p[g])&&e.push(p[g])}if(!e.length)
return[0,1];let s=Float64Array.from(e).sort(),[i,o]=[s[0],s.at(-1)],[a,h]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],r=Math.max(h-a,1e-12);o>h+4*
r&&(o=h+.6*r),i<a-4*r&&(i=a-.6*r),i=Math.min(i,0),o=Math.max(o,0),this.symmetric&&([i,o]=[-Math.max(-i,o),Math.max(-i,o)]);let l=.06*(o-i)||1;return[i<0?i-l:i,o+
l]}bands(t,e,s){for(let i of e.phases){let o=b(this.x(i.from),I,I+this.box.width),a=b(this.x(i.to),I,I+this.box.width);a<=o||(t.fillStyle=V(s.modes[i.mode],.14),
t.fillRect(o,A,a-o,this.box.height))}}grid(t,e,s,i){t.font=`11px ${e.font}`,t.strokeStyle=e.line,t.fillStyle=e.soft,t.lineWidth=1;let o=Math.max(this.box.height/
28,4);for(;$(...this.heights,o).length<3&&o<12;)o+=1;let a=S(this.heights[1]-this.heights[0],o);t.textAlign="right",t.textBaseline="middle";for(let d of $(...this.
heights,o)){let p=Math.round(this.y(d))+.5;t.globalAlpha=Math.abs(d)<1e-9*a?1:.55,t.beginPath(),t.moveTo(I,p),t.lineTo(s-_t,p),t.stroke(),t.globalAlpha=1,t.fillText(
P(d,a),I-6,p)}let h=this.box.width/70,r=S(this.range[1]-this.range[0],h);t.textAlign="center",t.textBaseline="alphabetic";let l=this.shared.axis==="time"?"time \
[s]":"angle [°]";for(let d of $(...this.range,h)){let p=this.x(d);t.beginPath(),t.moveTo(p,A+this.box.height),t.lineTo(p,A+this.box.height+4),t.stroke(),t.fillText(
P(d,r),p,A+this.box.height+15)}t.textAlign="right",t.fillText(l,s-_t,i-3),t.save(),t.translate(11,A+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",
t.fillText(this.unit,0,0),t.restore()}curve(t,{film:e,lane:s,values:i,color:o,dash:a},h){let r=this.abscissa(e);t.strokeStyle=o??this.look.ink,t.lineWidth=h&&s===
1?1.2:1.8,t.setLineDash(h&&s===1?[3,3]:ve[a??"solid"]),t.globalAlpha=h&&s===1?.85:1,t.beginPath();let l=!1;for(let d=0;d<i.length;d++){if(!Number.isFinite(i[d])||
!Number.isFinite(r[d])){l=!1;continue}let p=this.x(r[d]),f=b(this.y(i[d]),-1e4,1e4);l?t.lineTo(p,f):t.moveTo(p,f),l=!0}t.stroke(),t.setLineDash([]),t.globalAlpha=
1}legend(t,e){let s=t.map(i=>i.name).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>c("output",{})),this.keys.replaceChildren(...t.map((i,o)=>c("s\
pan",{class:"plot-key"},Pt(i.color,i.dash),i.name," ",this.values[o]))))}describe(t){let e=t.slice(0,6).map(({name:s,values:i,lane:o})=>{let[a,h]=[1/0,-1/0];for(let l of i)
l<a&&(a=l),l>h&&(h=l);let r=this.films.length>1?`${"AB"[o]}: `:"";return h>=a?`${r}${s} from ${v(a,3)} to ${v(h,3)}`:""});this.body.setAttribute("aria-label",`${this.
title} in ${this.unit}. ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.films)return;let{context:e,width:s,height:i}=R(this.over);if(e.clearRect(0,0,s,i),
this.films.forEach((o,a)=>{let h=o.at(t),r=this.x(this.shared.axis==="time"?h.t:h.angle*180/Math.PI),l=r>=I-1&&r<=I+this.box.width+1,d=o.index(h.t),p=Math.min(d+
1,o.length-1),f=o.t[p]>o.t[d]?(h.t-o.t[d])/(o.t[p]-o.t[d]):0;l&&(e.strokeStyle=this.look.soft,e.lineWidth=1,e.beginPath(),e.moveTo(r,A),e.lineTo(r,A+this.box.height),
e.stroke()),this.shades(o).forEach((g,u)=>{let y=g.values[p],m=Number.isFinite(y)?g.values[d]+f*(y-g.values[d]):g.values[d];a===this.active&&this.values?.[u]&&(this.
values[u].textContent=v(m,3));let w=this.y(m);!l||!(w>=A-1&&w<=A+this.box.height+1)||(e.fillStyle=g.color??this.look.ink,e.beginPath(),e.arc(r,w,3.2,0,2*Math.PI),
e.fill())})}),this.picked){let[o,a]=this.picked;e.fillStyle=V("#0072B2",.2),e.fillRect(Math.min(o,a),A,Math.abs(a-o),this.box.height)}}valueAt(t){let e=this.body.
getBoundingClientRect(),s=b((t.clientX-e.left-I)/this.box.width,0,1);return this.range[0]+s*(this.range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.
body.getBoundingClientRect(),s=t.clientX-e.left,i=this.valueAt(t),o=this.pinched(),a=h=>{if(o||=this.pinched(),o)return;let r=h.clientX-e.left;this.picked=t.pointerType===
"mouse"&&Math.abs(r-s)>5?[s,r]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(h)),this.cursor(this.shared.clock.time)};B(this.body,t,a,(h,r)=>{let l=this.
valueAt(h),{picked:d}=this;this.picked=null,d&&r?this.zoomTo(i<l?[i,l]:[l,i]):d?this.cursor(this.shared.clock.time):r&&!o&&this.seek(t.pointerType==="mouse"?i:l)})}seek(t){
if(this.shared.axis==="time")return this.onseek(t);let e=this.films[this.active],s=this.abscissa(e),i=0;for(let o=0;o<s.length;o++)Math.abs(s[o]-t)<Math.abs(s[i]-
t)&&(i=o);return this.onseek(e.t[i])}wheel(t){!this.films||!(t.ctrlKey||t.shiftKey||_(this.body))||(t.preventDefault(),this.zoomAbout(this.valueAt(t),Math.exp((t.
deltaY||t.deltaX)*.002)))}zoomAbout(t,e){let s=this.fullRange(),i=Math.max(t-(t-this.range[0])*e,s[0]),o=Math.min(t+(this.range[1]-t)*e,s[1]);this.zoomTo(i<=s[0]&&
o>=s[1]?null:[i,o])}zoomTo(t){this.shared.range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}key_(t){let e=this.range?.5*(this.range[0]+this.range[1]):0;if(t.
key==="+"||t.key==="=")this.zoomAbout(e,.6);else if(t.key==="-")this.zoomAbout(e,1.7);else if(t.key==="0")this.zoomTo(null);else return;t.preventDefault(),t.stopPropagation()}};
function Pt(n,t="solid"){let e=c("i",{class:"swatch","aria-hidden":"true"});return e.style.borderTopColor=n??"var(--ink)",e.style.borderTopStyle={solid:"solid",
dash:"dashed",dot:"dotted"}[t],e}var O=52,qt=10,M=8,xe=30,ke="RSKHM?",pt=class{constructor(t){this.lab=t,this.canvas=c("canvas",{class:"plot-canvas"}),this.over=c("canvas",{class:"plot-canvas p\
lot-over"}),this.keys=c("div",{class:"plot-keys"}),this.body=c("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocit\
y with the regions of rolling, slip and flight"},this.canvas,this.over),this.element=c("section",{class:"phase"},c("header",{},c("h3",{},"Plane of θ and θ̇"),
this.keys),this.body,c("p",{class:"hint"},"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox. "+(matchMedia("(\
hover: none)").matches?"Tap to go there, two fingers zoom.":"Click to go there; with Ctrl or Shift the wheel zooms, double-click for all."))),this.body.addEventListener(
"pointerdown",e=>this.seek(e)),this.body.addEventListener("wheel",e=>this.wheel(e),{passive:!1}),this.body.addEventListener("dblclick",()=>this.zoomTo(null)),this.
body.addEventListener("keydown",e=>this.key(e)),this.pinched=C(this.body,(e,s)=>this.box&&this.zoomAbout(this.point(s),1/e)),this.range=[0,2*Math.PI],this.asked=
"",this.soon=q(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),i=JSON.stringify([t.hoop,t.plane,s]);if(i!==this.asked){let o=await this.painted(t,[0,
2*Math.PI,-s,s],e);this.asked=i,this.pictures=[o],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.pictures||!this.window)){this.sharpening?.
abort(),this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,[...this.range,...this.window],this.sharpening.signal);
this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){let{header:i,arrays:o}=await this.lab.backend.
call("regions",{scenario:t,window:e},s);return{window:i.window,paradox:o.paradox,picture:this.paint(o.modes,i.arrays[0].shape)}}reach(){return this.reached}findReach(){
let t=0;for(let s of this.films??[]){let i=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(t,i[Math.floor(.99*(i.length-1))]??
0)}let e=S(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}zoomTo(t){this.range=t??[0,2*Math.PI],this.window=null,this.pictures?.splice(1),this.redraw()}wheel(t){
!(t.ctrlKey||t.shiftKey||_(this.body))||!this.box||(t.preventDefault(),this.zoomAbout(this.point(t),Math.exp((t.deltaY||t.deltaX)*.002)))}key(t){let e=[.5*(this.
range[0]+this.range[1]),.5*(this.bottom()+this.top())];if(t.key==="+"||t.key==="=")this.zoomAbout(e,.6);else if(t.key==="-")this.zoomAbout(e,1.7);else if(t.key===
"0")this.zoomTo(null);else return;t.preventDefault(),t.stopPropagation()}point(t){let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left-O)/this.box.width,
i=1-(t.clientY-e.top-M)/this.box.height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+i*(this.top()-this.bottom())]}zoomAbout([t,e],s){let i=Math.
max(t-(t-this.range[0])*s,0),o=Math.min(t+(this.range[1]-t)*s,2*Math.PI),a=this.reach(),h=Math.max(e-(e-this.bottom())*s,-a),r=Math.min(e+(this.top()-e)*s,a);this.
range=[i,o],this.window=o-i<2*Math.PI-1e-9||r-h<2*a-1e-9?[h,r]:null,this.redraw(),this.soon()}bottom(){return this.window?this.window[0]:this.backwards?-this.reach():
0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){this.films=t,this.active=e,this.look=s,this.reached=this.findReach(),
this.forwards=t.some(i=>i.columns.omega.some(o=>o>.3)),this.backwards=t.some(i=>i.columns.omega.some(o=>o<-.3)),!this.forwards&&!this.backwards&&(this.forwards=
!0),this.redraw()}x(t){return O+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return M+(1-(t-this.bottom())/(this.top()-this.bottom()))*this.
box.height}paint(t,[e,s]){let{modes:i}=this.lab.colors,o=c("canvas",{width:s,height:e}),a=new ImageData(s,e);for(let h=0;h<e;h++)for(let r=0;r<s;r++){let l=ke[t[h*
s+r]],d=F(i[l]??"#6E6E6E"),p=4*((e-1-h)*s+r);a.data.set([...d,255],p)}return o.getContext("2d").putImageData(a,0,0),o}redraw(){if(!this.films)return;let{lab:t,look:e}=this,
{context:s,width:i,height:o}=R(this.canvas);if(this.box={width:i-O-qt,height:o-M-xe},s.clearRect(0,0,i,o),s.save(),s.beginPath(),s.rect(O,M,this.box.width,this.
box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:h}of this.pictures){let[r,l,d,p]=h,f=[this.x(r),this.y(p),this.x(l)-this.
x(r),this.y(d)-this.y(p)];s.fillStyle=e.panel,s.fillRect(...f),s.globalAlpha=.35,s.drawImage(a,...f),s.globalAlpha=1}this.hatch(s)}for(let[a,h]of this.films.entries())
this.way(s,h,a);if(s.restore(),this.axes(s,i,o),this.keyed!==e.dark){this.keyed=e.dark;let a=Object.entries(t.colors.mode_names).filter(([h])=>"RSKH".includes(h));
this.keys.replaceChildren(...a.map(([h,r])=>c("span",{class:"plot-key"},Pt(t.colors.modes[h]),r)))}this.cursor(t.clock.time)}hatch(t){let{paradox:e}=this.pictures[0],
s=e.length;t.strokeStyle=V(this.look.dark?"#ffffff":"#000000",.28),t.lineWidth=1;for(let i=0;i<s;i++){if(!e[i])continue;let o=i;for(;o<s&&e[o]===e[i];)o++;let a=this.
x(i*2*Math.PI/s),h=this.x(o*2*Math.PI/s);t.save(),t.beginPath(),t.rect(a,M,h-a,this.box.height),t.clip(),t.beginPath();let r=e[i];for(let l=-this.box.height;l<h-
a+this.box.height;l+=7)t.moveTo(a+l,r>0?M+this.box.height:M),t.lineTo(a+l+this.box.height,r>0?M:M+this.box.height);t.stroke(),t.restore(),i=o}}way(t,e,s){let{angle:i,
omega:o,mode:a}=e.columns,h=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=this.look.ink,t.beginPath();let r=null;for(let l=0;l<e.length;l++){
if(!Number.isFinite(o[l])){r=null;continue}let d=Math.floor(i[l]/h),p=i[l]-d*h;if(r===null)t.moveTo(this.x(p),this.y(o[l]));else if(d!==r.lap){let f=d>r.lap?h:0;
t.lineTo(this.x(f),this.y(o[l])),t.moveTo(this.x(h-f),this.y(o[l])),t.lineTo(this.x(p),this.y(o[l]))}else t.lineTo(this.x(p),this.y(o[l]));r={lap:d,mode:a[l]}}t.
stroke(),t.setLineDash([])}axes(t,e,s){let{look:i}=this;t.font=`11px ${i.font}`,t.strokeStyle=i.soft,t.fillStyle=i.soft,t.lineWidth=1,t.strokeRect(O+.5,M+.5,this.
box.width-1,this.box.height-1),t.textAlign="center";let o=this.range[0]*180/Math.PI,a=this.range[1]*180/Math.PI,h=a-o>200?45:S(a-o,6);for(let l=Math.ceil(o/h-1e-9);l*
h<=a+1e-9;l++){let d=this.x(l*h*Math.PI/180);t.beginPath(),t.moveTo(d,M+this.box.height),t.lineTo(d,M+this.box.height+4),t.stroke(),t.fillText(P(l*h,h),d,M+this.
box.height+15)}t.textAlign="right",t.fillText("angle θ within a turn [°]",e-qt,s-3),t.textBaseline="middle";let r=this.top()-this.bottom();for(let l of $(this.
bottom(),this.top(),5))t.fillText(P(l,S(r,5)),O-6,this.y(l));t.textBaseline="alphabetic",t.save(),t.translate(11,M+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign=
"center",t.fillText("θ̇ [rad/s]",0,0),t.restore()}cursor(t){if(!this.films||!this.box)return;let{context:e,width:s,height:i}=R(this.over);e.clearRect(0,0,s,i),
this.films.forEach((o,a)=>{let h=o.at(t),r=2*Math.PI,l=h.angle-Math.floor(h.angle/r)*r,d=this.x(l),p=this.y(h.omega);d>=O&&d<=O+this.box.width&&p>=M&&p<=M+this.
box.height&&(e.beginPath(),e.arc(d,p,a?4:5.5,0,2*Math.PI),e.fillStyle=this.lab.colors.modes[h.mode],e.fill(),e.lineWidth=2,e.strokeStyle=this.look.ink,e.stroke())})}seek(t){
let e=this.body.getBoundingClientRect(),[s,i]=[t.clientX-e.left,t.clientY-e.top];if(this.pinched())return;let o=this.films[this.active],{angle:a,omega:h}=o.columns,
r=2*Math.PI,l={distance:1/0,t:0};for(let d=0;d<o.length;d++){let p=a[d]-Math.floor(a[d]/r)*r,f=Math.hypot(this.x(p)-s,this.y(h[d])-i);f<l.distance&&(l={distance:f,
t:o.t[d]})}l.distance<40&&this.lab.clock.seek(b(l.t,0,o.duration))}};function Yt(n,t,...e){return n.derived(t,s=>Float64Array.from(s.t,(i,o)=>e.reduce((a,h)=>a+s[h][o],0)))}function Me(n){return[{key:"velocities",title:"Velocitie\
s",unit:"velocity [m/s]",curves:t=>[{name:"v (centre)",color:n.center_speed,values:t.columns.vx},{name:"R θ̇",color:n.rotation_speed,dash:"dash",values:t.derived(
"spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"Energies and losses",unit:"energy [J]",curves:t=>[{name:"kinetic",color:n.kinetic,
values:t.columns.kinetic},{name:"potential",color:n.potential,values:t.columns.potential},{name:"total",values:Yt(t,"total","kinetic","potential"),dash:"dash"},
{name:"friction",color:n.friction_loss,values:t.columns.friction},{name:t.scenario.contact.model==="compliant"?"damping":"impacts",color:n.impact_loss,values:t.
scenario.contact.model==="compliant"?t.columns.damping:Yt(t,"impacts","impact_normal","impact_tangential"),dash:"dot"}]},{key:"forces",title:"Contact forces",unit:"\
force [N]",curves:t=>[{name:"normal N",color:n.normal_force,values:t.columns.normal_force},{name:"friction F",color:n.friction_force,dash:"dash",values:t.columns.
friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],curves:t=>[{name:"|F| / μN",color:n.friction_force,values:t.columns.
utilization}]}]}var ut=class{constructor(t,e){this.colors=e,this.shared={axis:"time",range:null,clock:t,changed:()=>this.redraw()},this.plots=Me(e).map(i=>new dt(
i,this.shared));for(let i of this.plots)i.onseek=o=>t.seek(o);this.seen=new Map(this.plots.map(i=>[i.element,!0]));let s=new IntersectionObserver(i=>{for(let{target:o,
isIntersecting:a}of i)this.seen.set(o,a);this.redraw()},{rootMargin:"400px"});for(let i of this.plots)s.observe(i.element);this.axis=c("select",{"aria-label":"H\
orizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=null,this.redraw()}},c("option",{value:"time"},"over time"),c("\
option",{value:"angle"},"over angle")),this.back=c("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=c("span",
{class:"hint"}),this.element=c("div",{class:"plots"},c("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(i=>i.element))}draw(t,e,s){this.
films=t,this.active=e,this.look=s;let i=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":"drag to zoom, double-click for all, click to \
go there";this.hint.textContent=t.length>1?`A full, B dotted; numbers and colours of ${"AB"[e]}; ${i}`:i,this.redraw()}redraw(){if(this.films?.length){this.back.
hidden=!this.shared.range;for(let t of this.visible())t.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.
plots.filter(t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())e.cursor(t)}};var Te=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],ft=class{constructor(t){this.lab=t,this.menu=c("details",{class:"menu"},c("summary",{class:"button"},"Keep"),c("div",{class:"menu-body"},t.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),Te.map(([e,s])=>this.item(s,()=>this.download(e))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=c("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),t.root.addEventListener("pointerdown",e=>{this.menu.contains(e.target)||(this.menu.open=!1)})}item(t,e){return c("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await e()}catch(s){this.lab.fail(s)}}},t)}async copyLink(){let t=this.lab.link();try{await navigator.clipboard.writeText(t),this.lab.say("\
The link is copied.")}catch{this.show("The link to this motion",t)}}async download(t){let e=this.lab.film();this.lab.say(t.endsWith("mp4")?"The film is being ma\
de; this takes a while …":`Fetching ${t} …`),ot(await this.lab.backend.file(t,e.query),`hophoop-${t}`),this.lab.say(`${t} is there.`)}picture(){return new Promise(
t=>{this.lab.drawStage();let e=this.lab.stageCanvas(),s=c("canvas",{width:e.width,height:e.height});this.copyInto(s),s.toBlob(i=>{ot(i,"hophoop.png"),t()},"imag\
e/png")})}copyInto(t){let{lab:e}=this,s=e.stageCanvas(),i=t.getContext("2d");i.fillStyle=e.look.paper,i.fillRect(0,0,t.width,t.height),i.drawImage(s,0,0,t.width,
t.height);let o=t.width/Math.max(s.getBoundingClientRect().width,1);i.textBaseline="top",i.textAlign="left",e.films().forEach((a,h,r)=>{let l=a.at(e.clock.time),
d=[r.length>1?`${"AB"[h]}: `:"",`${e.colors.mode_names[l.mode]}, t = ${l.t.toFixed(3)} s, θ = ${et(l.angle)}, v = ${v(l.vx,3)} m/s`].join(""),p=e.options.three?
10+20*h:10+h*s.getBoundingClientRect().height/r.length;i.fillStyle=e.colors.modes[l.mode],i.fillRect(12*o,(p+2)*o,11*o,11*o),i.fillStyle=e.look.ink,i.font=`${13*
o}px ${e.look.font}`,i.fillText(d,30*o,p*o)})}async record(){let{lab:t}=this,e=t.stageCanvas();if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("T\
his browser cannot record a canvas; take the MP4 instead.");let s=c("canvas",{width:2*Math.ceil(e.width/2),height:2*Math.ceil(e.height/2)}),i=new MediaRecorder(
s.captureStream(60),{videoBitsPerSecond:8e6}),o=[];i.ondataavailable=r=>o.push(r.data);let a=new Promise(r=>i.onstop=r),h=t.clock.loop;t.clock.loop=!1,t.clock.seek(
0),t.say("Recording one run …"),t.afterFrame=()=>{this.copyInto(s),!t.clock.playing&&i.state==="recording"&&i.stop()},i.start(),t.clock.play(!0),await a,t.afterFrame=
null,t.clock.loop=h,ot(new Blob(o,{type:i.mimeType}),"hophoop.webm"),t.say("The film is there.")}async code(){let{header:t}=await this.lab.backend.call("code",{
scenario:this.lab.film().scenario});this.show("The same motion in Python",t.python,"The scenario as a file",t.toml)}show(...t){let e=[];for(let s=0;s<t.length;s+=
2){let i=t[s+1],o=c("button",{type:"button"},"Copy");o.onclick=async()=>{await navigator.clipboard?.writeText(i).catch(()=>{}),o.textContent="Copied"},e.push(c(
"header",{},c("h2",{},t[s]),o),c("pre",{tabindex:"0"},c("code",{},i)))}this.dialog.replaceChildren(...e,c("button",{type:"button",class:"close",onclick:()=>this.
dialog.close()},"Close")),this.dialog.showModal()}};var Kt=120,mt=class{constructor(t){this.canvas=t,this.zoom=1,this.shift=[0,0],t.addEventListener("wheel",e=>this.wheel(e),{passive:!1}),t.addEventListener("poin\
terdown",e=>this.drag(e)),t.addEventListener("dblclick",()=>this.reset()),this.pinched=C(t,e=>this.zoomBy(e)),this.onview=()=>{}}reset(){this.zoom=1,this.shift=
[0,0],this.onview()}zoomBy(t){this.zoom=b(this.zoom*t,.05,60),this.onview()}wheel(t){(t.ctrlKey||t.shiftKey||_(this.canvas.parentElement))&&(t.preventDefault(),
this.zoomBy(Math.exp(-(t.deltaY||t.deltaX)*.0015)))}drag(t){let e=[t.clientX,t.clientY],s=this.shift;B(this.canvas,t,i=>{this.pinched()||(this.shift=[s[0]+i.clientX-
e[0],s[1]+i.clientY-e[1]],this.onview())})}draw(t,e,s,i,o){let{context:a,width:h,height:r}=R(this.canvas);if(a.clearRect(0,0,h,r),h<40||r<40)return;let l=r/t.length,
d={top:Math.max(...t.map(p=>p.extent.top)),radius:Math.max(...t.map(p=>p.radius)),speed:Math.max(...t.map(p=>p.extent.speed))};t.forEach((p,f)=>{a.save(),a.beginPath(),
a.rect(0,f*l,h,l),a.clip(),a.translate(0,f*l),new Rt(a,h,l,p,e,s,i,o,this.zoom,this.shift,d).draw(),t.length>1&&(a.fillStyle=i.soft,a.font=`600 15px ${i.font}`,
a.textAlign="left",a.fillText("AB"[f],12,l-12)),a.restore(),f>0&&(a.fillStyle=i.line,a.fillRect(0,f*l-.5,h,1))})}},Rt=class{constructor(t,e,s,i,o,a,h,r,l,d,p){Object.
assign(this,{context:t,width:e,height:s,film:i,options:a,look:h,colors:r,common:p}),this.pose=i.at(o);let f=i.radius,{left:g,right:u}=i.extent,{top:y}=p;this.cosine=
Math.cos(i.slope),this.sine=Math.sin(i.slope);let m=2*p.radius+Math.min(y,6*p.radius),w=Math.min(.66*s/m,.36*e/p.radius);if(a.whole){let x=(u-g)*this.cosine+2.6*
f,k=(u-g)*Math.abs(this.sine)+2.6*f+y;this.scale=Math.min(e/x,.86*s/k,w)*l,this.focus=[.5*(g+u),0],this.place=[.5*e+d[0],(i.slope?.62:.8)*s+d[1]]}else this.scale=
w*l,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.place=[(e<520?.6:.46)*e+d[0],.82*s+d[1]]}point(t,e){let s=t-this.focus[0],i=e-this.focus[1];return[
this.place[0]+this.scale*(s*this.cosine+i*this.sine),this.place[1]-this.scale*(i*this.cosine-s*this.sine)]}draw(){this.ground(),this.options.traces&&this.traces(),
this.hoop(),this.options.forces&&this.forces()}ground(){let{context:t,look:e,width:s,height:i}=this,o=(Math.hypot(s,i)*1.2+Math.abs(this.place[0])+Math.abs(this.
place[1]))/this.scale,[a,h]=this.point(this.focus[0]-o,0),[r,l]=this.point(this.focus[0]+o,0),d=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,t.beginPath(),
t.moveTo(a,h),t.lineTo(r,l),t.lineTo(r+d[0],l+d[1]),t.lineTo(a+d[0],h+d[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(a,h),t.lineTo(r,
l),t.stroke();let p=S(s/this.scale,s/90);t.fillStyle=e.soft,t.font=`11px ${e.font}`,t.textAlign="center",t.lineWidth=1;let f=Math.ceil((this.focus[0]-o)/p),g=Math.
min(Math.floor((this.focus[0]+o)/p),f+400);for(let u=f;u<=g;u++){let[y,m]=this.point(u*p,0);y<-40||y>s+40||(t.beginPath(),t.moveTo(y,m),t.lineTo(y-6*this.sine,m+
6*this.cosine),t.stroke(),t.fillText(`${P(u*p,p)} m`,y-18*this.sine,m+8+10*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:i}=this,o=t.index(this.pose.
t),a=t.radius,{x:h,height:r,angle:l,mode:d}=t.columns,p=(f,g,u,y)=>{e.strokeStyle=g,e.lineWidth=u,e.lineJoin="round",e.beginPath();let m=!1,w=(x,k,T)=>{let[N,U]=this.
point(x+f*Math.sin(T),a+k+f*Math.cos(T));m?e.lineTo(N,U):e.moveTo(N,U),m=!0};for(let x=0;x<=o;x++)y===void 0||d[x]===3===y?w(h[x],r[x],l[x]):m=!1;(y===void 0||this.
pose.mode==="H"===y)&&w(this.pose.x,this.pose.height,this.pose.angle),e.stroke()};p(a,s.ink,1.3),p(t.eccentricity*a,i.gravity_center,1.8,!1),p(t.eccentricity*a,
i.airborne,2.4,!0)}hoop(){let{film:t,pose:e,context:s,look:i,colors:o,scale:a}=this,h=t.radius,r=b(.07*h*a,2,14),l=h-.5*r/a,d=[e.x,h+e.height],p=(m,w=l)=>this.point(
d[0]+w*Math.sin(m),d[1]+w*Math.cos(m));if(s.lineCap="butt",i.dark&&(s.strokeStyle=i.soft,s.lineWidth=r+2,s.beginPath(),s.arc(...this.point(...d),l*a,0,2*Math.PI),
s.stroke()),this.options.speed){let m=this.common.speed;s.lineWidth=r;let w=2*Math.PI/Kt;for(let x=0;x<Kt;x++){let k=e.angle+x*w,T=Math.hypot(e.vx+h*e.omega*Math.
cos(k+.5*w),e.vy-h*e.omega*Math.sin(k+.5*w));s.strokeStyle=it[b(Math.round(255*T/m)||0,0,255)],s.beginPath(),s.moveTo(...p(k-.04*w)),s.lineTo(...p(k+1.04*w)),s.
stroke()}}else s.strokeStyle=o.modes[e.mode],s.lineWidth=r,s.beginPath(),s.arc(...this.point(...d),l*a,0,2*Math.PI),s.stroke();s.strokeStyle=i.soft,s.lineWidth=
1,s.beginPath(),s.moveTo(...this.point(...d)),s.lineTo(...p(e.angle)),s.stroke();let f=(m,w,x,k)=>{s.beginPath(),s.arc(...m,w,0,2*Math.PI),s.fillStyle=x,s.fill(),
s.lineWidth=1.5,s.strokeStyle=k,s.stroke()};f(this.point(...d),2.5,i.soft,i.soft);let g=t.scenario.hoop.parts;g?this.parts(g,d):f(p(e.angle),b(.1*h*a,4,16),i.ink,
i.paper);let u=t.eccentricity*h,y=this.point(d[0]+u*Math.sin(e.angle),d[1]+u*Math.cos(e.angle));f(y,b(.05*h*a,3.5,7),e.mode==="H"?o.airborne:o.gravity_center,i.
paper)}parts(t,e){let{film:s,pose:i,context:o,look:a,scale:h}=this,l=t.reduce((d,p)=>d+p.mass*(p.at??0),0)<0?-1:1;o.strokeStyle=a.ink;for(let d of t){let p=l*(d.
at??0),f=this.point(e[0]+p*Math.sin(i.angle),e[1]+p*Math.cos(i.angle));if(o.fillStyle=a.ink,o.lineWidth=1,o.beginPath(),d.shape==="ring")o.globalAlpha=.22,o.arc(
...f,d.outer_radius*h,0,2*Math.PI),o.arc(...f,d.inner_radius*h,0,2*Math.PI,!0),o.fill(),o.globalAlpha=1;else if(d.shape==="rod"){let g=.5*d.length,u=y=>this.point(
e[0]+y*Math.sin(i.angle),e[1]+y*Math.cos(i.angle));o.lineWidth=4,o.moveTo(...u(p-g)),o.lineTo(...u(p+g)),o.stroke()}else{let g=d.shape==="disk"?d.radius*h:b(.08*
s.radius*h,3,12);o.globalAlpha=d.shape==="disk"?.55:1,o.arc(...f,g,0,2*Math.PI),o.fill(),o.globalAlpha=1}}}forces(){let{film:t,pose:e,colors:s}=this,i=t.radius,
o=t.mass*(t.gravity||9.81),a=r=>.55*i*r/o;if(e.mode==="H"||!(e.normal_force>0))return;let h=[e.x,e.height];this.arrow(h,[0,a(e.normal_force)],s.normal_force,`N \
= ${v(e.normal_force,3)} N`,!1),this.arrow(h,[a(e.friction_force),0],s.friction_force,`F = ${v(e.friction_force,3)} N`,!0)}arrow([t,e],[s,i],o,a,h){let{context:r,
look:l,width:d}=this,p=2.2*this.film.radius,f=Math.abs(s)>p||Math.abs(i)>p;[s,i]=[b(s,-p,p),b(i,-p,p)];let g=this.point(t,e),u=this.point(t+s,e+i),y=Math.hypot(
u[0]-g[0],u[1]-g[1]);if(y<2)return;let m=(u[0]-g[0])/y,w=(u[1]-g[1])/y,x=Math.min(11,y);for(let[N,U]of[[l.paper,6],[o,3]])r.strokeStyle=N,r.fillStyle=N,r.lineWidth=
U,r.beginPath(),r.moveTo(...g),r.lineTo(u[0]-m*x,u[1]-w*x),r.stroke();if(r.beginPath(),r.moveTo(...u),r.lineTo(u[0]-m*x-w*x*.5,u[1]-w*x+m*x*.5),r.lineTo(u[0]-m*
x+w*x*.5,u[1]-w*x-m*x*.5),r.fill(),f){let[N,U]=[g[0]+.55*m*y,g[1]+.55*w*y];r.strokeStyle=l.paper,r.lineWidth=2,r.beginPath();for(let Q of[-3,3])r.moveTo(N+m*(Q-
3)-w*7,U+w*(Q-3)+m*7),r.lineTo(N+m*(Q+3)+w*7,U+w*(Q+3)-m*7);r.stroke()}r.font=`600 12px ${l.font}`;let k=r.measureText(a).width;r.lineWidth=3,r.strokeStyle=h?l.
ground:l.paper,r.textAlign="left";let T=h?[g[0]-.5*k-32*this.sine,g[1]+32*this.cosine]:[u[0]+12,b(u[1]+4,16,g[1]-.36*this.film.radius*this.scale)];T[0]=b(T[0],4,
d-k-4),r.strokeText(a,...T),r.fillText(a,...T)}};var gt=class{constructor(t){this.clock=t,this.summary=c("p",{class:"summary"}),this.list=c("ol",{class:"story-list"}),this.heading=c("h2",{},"What happens"),this.
live=c("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=c("section",{class:"story","aria-label":"The motion in words"},this.heading,this.
summary,this.list,this.live)}draw(t,e,s){this.film=t[e],this.heading.textContent=t.length>1?`What happens to hoop ${"AB"[e]}`:"What happens",this.summary.replaceChildren(
...t.flatMap((i,o)=>[t.length>1?c("b",{},`${"AB"[o]}: `):"",i.summary,i.status==="event_limit"||i.shortened?" (not all events are shown)":"",o+1<t.length?c("br"):
""])),this.items=this.film.story.map(i=>c("li",{},c("button",{type:"button",onclick:()=>this.clock.seek(i.t)},c("i",{class:"dot",style:`background:${s.modes[i.mode]}`,
"aria-hidden":"true"}),c("span",{class:"when"},`${v(i.t,4)} s`),c("span",{},i.text)))),this.list.replaceChildren(...this.items),this.current=-1,this.cursor(this.
clock.time)}announce(t){this.live.textContent=t.map(e=>e.summary).join(" ")}cursor(t){let{story:e}=this.film,s=-1;for(let o=0;o<e.length&&e[o].t<=t+1e-9;o++)s=o;
if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),this.items[this.current]?.removeAttribute("aria\
-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let i=this.items[s];if(i){let o=i.offsetTop-this.list.offsetTop;(o<this.list.scrollTop||
o+i.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=o-.4*this.list.clientHeight)}}},yt=class{constructor(){this.list=c("dl",{}),this.
heading=c("h2",{},"What theory says"),this.element=c("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){this.heading.textContent=e?`What theory say\
s of hoop ${e}`:"What theory says",this.list.replaceChildren(...t.flatMap(({label:s,text:i})=>[c("dt",{},s),c("dd",{},i)]))}};var Se={takeoff:"▲",impact:"▼",apex:"•",jam:"✖",kane_gain:"✚",bounce_limit:"≋",turn:"↺",rest:"■",painleve_inconsistent:"◆",painleve_indeterminate:"\
◇",skim:"◗"},Ee={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns b\
ack",apex:"highest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"j\
am",kane_gain:"energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},wt=class{constructor(t){this.clock=t,this.canvas=c("canvas",{class:"timeline\
-canvas"}),this.tip=c("div",{class:"tip",hidden:!0}),this.element=c("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","\
aria-orientation":"horizontal"},this.canvas,this.tip),this.element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermove",
e=>this.hover(e)),this.element.addEventListener("pointerleave",()=>this.tip.hidden=!0)}timeAt(t){let e=this.canvas.getBoundingClientRect();return b((t.clientX-e.
left)/e.width,0,1)*this.clock.duration}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});let e=this.clock.playing;this.clock.playing=!1;let s=i=>this.
clock.seek(this.timeAt(i));s(t),B(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){let e=this.timeAt(t),s=this.nearest(e,8),i=s?`${Ee[s.kind]??s.kind} · ${v(
s.t,5)} s · ${v(s.angle*180/Math.PI,4)}°`:`${v(e,4)} s`;this.tip.textContent=i,this.tip.hidden=!1;let o=this.canvas.getBoundingClientRect();this.tip.style.left=
`${b(t.clientX-o.left,70,o.width-70)}px`}nearest(t,e){let s=e*this.clock.duration/(this.canvas.getBoundingClientRect().width||1),i=null;for(let o of this.films??
[])for(let a of o.events){if(a.kind==="end")continue;let h=Math.abs(a.t-t);h<=s&&(!i||h<Math.abs(i.t-t))&&(i=a)}return i}draw(t,e,s){this.films=t;let{context:i,
width:o,height:a}=R(this.canvas),h=this.clock.duration||1,r=u=>u/h*o;i.clearRect(0,0,o,a);let l=15,d=(a-15)/t.length-l;t.forEach((u,y)=>{let m=l+y*(l+d);for(let w of u.
phases){let x=r(w.from),k=Math.max(r(w.to)-x,.6),T=s.modes[w.mode];i.fillStyle=T,i.fillRect(x,m,k,d-2),this.named(i,s.mode_names[w.mode],x,k,m,d-2,T,e)}u.duration<
h&&(i.fillStyle=e.line,i.fillRect(r(u.duration),m,o,d-2)),this.marks(i,u,r,m,o,e),t.length>1&&(i.fillStyle=e.soft,i.font=`600 11px ${e.font}`,i.textAlign="left",
i.fillText("AB"[y],1,m-4))});let p=S(h,o/60);i.fillStyle=e.soft,i.font=`10.5px ${e.font}`;for(let u of $(0,h,o/60))i.textAlign=u===0?"left":r(u)>o-14?"right":"c\
enter",i.fillText(P(u,p)+(u===0?" s":""),r(u),a-3);let f=b(r(this.clock.time),6,o-6),g=b(r(this.clock.time),1,o-1);i.fillStyle=e.ink,i.fillRect(g-1,l-4,2,a-l-9),
i.beginPath(),i.moveTo(f-6,l-10),i.lineTo(f+6,l-10),i.lineTo(g,l-1),i.fill(),this.element.setAttribute("aria-valuemax",h.toFixed(3)),this.element.setAttribute("\
aria-valuenow",this.clock.time.toFixed(3)),this.element.setAttribute("aria-valuetext",`${v(this.clock.time,4)} seconds`)}named(t,e,s,i,o,a,h,r){t.font=`11px ${r.
font}`,!(a<13||t.measureText(e).width+8>i)&&(t.fillStyle=Dt(h),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*i,o+.5*a+1),t.textBaseline="alphab\
etic")}marks(t,e,s,i,o,a){t.font=`11px ${a.font}`,t.textAlign="center";let h=-1/0;for(let r of e.events){let l=Se[r.kind],d=s(r.t);r.kind!=="start"&&r.kind!=="e\
nd"&&(t.fillStyle=a.panel,t.fillRect(d-.5,i,1,5)),!(!l||d-h<8)&&(h=d,t.fillStyle=a.ink,t.fillText(l,b(d,6,o-6),i-4))}}};var Ae=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"]];function Gt(n){let{clock:t}=n;n.canvas2=c("canvas",
{class:"stage-canvas"}),n.canvas3=c("canvas",{class:"stage-canvas",hidden:!0}),n.stage2=new mt(n.canvas2),n.stage2.onview=()=>n.request(),n.readout=c("dl",{class:"\
readout","aria-hidden":"true"}),n.fastest=c("span",{}),n.legend=c("div",{class:"legend","aria-hidden":"true"},c("i",{style:`background: linear-gradient(90deg, ${it.
filter((h,r)=>r%15===0).join(",")})`}),c("span",{},"0"),c("span",{},"rim speed"),n.fastest);let e=(h,r)=>c("span",{},c("i",{class:"dot",style:`background:${h}`}),
r);n.stageKeys=[e("var(--ink)","load"),e(n.colors.gravity_center,"centre of gravity"),e(n.colors.airborne,"airborne"),c("span",{hidden:!0},"A in front, B behind")],
n.stageBox=c("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},n.canvas2,n.canvas3,n.readout,n.legend,c("div",{class:"stage-keys","aria-hidd\
en":"true"},n.stageKeys)),n.timeline=new wt(t),n.story=new gt(t),n.theory=new yt,n.plots=new ut(t,n.colors),n.phase=new pt(n),n.map=new lt(n),n.controls=new rt(
n.setup.controls,(h,r)=>n.change(h,r)),n.share=new ft(n),n.message=c("p",{class:"message",role:"alert",hidden:!0});let s=h=>!n.panels||n.panels.includes(h),i=c(
"aside",{class:"side","aria-label":"Parameters"},Pe(n),n.message,n.controls.element),o=c("div",{class:"middle"},c("div",{class:"player"},n.stageBox,n.timeline.element,
Re(n)),c("div",{class:"words"},n.story.element,s("theory")&&n.theory.element),s("map")&&n.map.element),a=c("div",{class:"why"},s("plots")&&n.plots.element,s("pl\
ots")&&n.phase.element);n.toast=c("div",{class:"toast",role:"status",hidden:!0}),n.root.replaceChildren(c("div",{class:"page"},_e(n),c("div",{class:"columns"},s(
"controls")&&i,o,a)),n.toast,n.share.dialog,Ie(n)),s("controls")||n.root.classList.add("no-controls"),n.hosted?document.addEventListener("keydown",h=>n.key(h)):
n.root.addEventListener("keydown",h=>{n.key(h),h.stopPropagation()})}function _e(n){let t=new Map;for(let i of n.setup.presets)t.set(i.group,[...t.get(i.group)??
[],i]);n.presets=c("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let i=n.setup.presets.find(({key:o})=>o===n.presets.value);i&&n.
take(i.query,i)}},c("option",{value:""},"Motions to start from …"),[...t].map(([i,o])=>c("optgroup",{label:i},o.map(({key:a,title:h})=>c("option",{value:a},h)))));
let e=(i,o,a,h={})=>c("button",{type:"button",title:o,"aria-label":o,onclick:a,...h},i);n.undoButton=e(E("undo"),"Undo (z)",()=>n.undo()),n.redoButton=e(E("redo"),
"Redo (y)",()=>n.redo());let s=c("span",{},c("span",{class:"long"},"Compare"),c("span",{class:"short"},E("two")));return n.compareButton=e(s,"Compare two hoops",
()=>n.compare(),{"aria-pressed":"false"}),c("header",{class:"top"},c("h1",{},c("span",{class:"logo","aria-hidden":"true"}),c("span",{},"hophoop",c("span",{class:"\
long"}," lab"))),n.presets,c("div",{class:"buttons"},n.undoButton,n.redoButton,n.compareButton),c("div",{class:"buttons right"},n.share.menu,e(E("theme"),"Dark \
or light (d)",()=>n.toggleTheme()),e("?","Keys and help (?)",()=>n.helpDialog.showModal())))}function Pe(n){return n.tabs=["A","B"].map((t,e)=>c("button",{type:"\
button","aria-pressed":"false",onclick:()=>n.choose(e)},`Hoop ${t}`)),n.tabBar=c("div",{class:"tabs",role:"group","aria-label":"Which hoop the controls change",
hidden:!0},n.tabs),n.presetText=c("p",{class:"preset-text"}),c("div",{class:"lanes"},n.tabBar,n.presetText)}function Re(n){let t=(s,i)=>c("span",{},c("span",{"a\
ria-hidden":"true"},`${s} `),i),e=(s,i,o)=>c("button",{type:"button",title:i,"aria-label":i,onclick:o},s);return n.playButton=e(E("play"),"Play (space)",()=>n.clock.
play()),n.playButton.classList.add("play"),n.speeds=c("select",{"aria-label":"Speed of the film",onchange:()=>{n.clock.speed=Number(n.speeds.value)}},J.map(s=>c(
"option",{value:String(s)},`${s}×`))),n.speeds.value="1",n.switches=new Map(Ae.map(([s,i,o])=>{let a=c("button",{type:"button",class:"switch",title:`${i} (${o}\
)`,onclick:()=>n.toggle(s)},i);return[s,a]})),n.threeButton=c("button",{type:"button",class:"switch",title:"In space (3)",onclick:()=>n.toggle("three")},"3D"),n.
switches.set("three",n.threeButton),c("div",{class:"transport"},c("div",{class:"buttons"},e(E("start"),"To the start (Home)",()=>n.clock.seek(0)),e(E("previous"),
"Previous event (Shift ←)",()=>n.jump(-1)),e(E("back"),"One frame back (←)",()=>n.nudge(-1)),n.playButton,e(E("on"),"One frame on (→)",()=>n.nudge(1)),e(E(
"next"),"Next event (Shift →)",()=>n.jump(1))),c("div",{class:"buttons"},e(t("▲","hop"),"To the next hop (h)",()=>n.jump(1,"takeoff")),e(t("▼","landing"),
"To the next landing (l)",()=>n.jump(1,"impact"))),n.speeds,c("div",{class:"buttons switches"},[...n.switches.values()]))}function Ie(n){let t=[["space","play, \
pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next hop, landing"],["[ ]","slower, faster"],["Home End","start, end"],["t f c\
 w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["z y","undo, redo"],["d","dark, light"],["p","Python"]];return n.helpDialog=
c("dialog",{class:"help","aria-label":"Keys and help"},c("h2",{},"The hoop"),c("p",{},"A ring with a load on its rim rolls on a plane. Friction can only hold so\
 much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see."),c("table",{},
c("caption",{},"Keys"),t.map(([e,s])=>c("tr",{},c("th",{scope:"row"},e),c("td",{},s)))),c("p",{class:"hint"},`hophoop ${n.setup.version}`),c("button",{type:"but\
ton",class:"close",onclick:()=>n.helpDialog.close()},"Close")),n.helpDialog}function Lt(n,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let i=0;i<4;i++){let o=0;for(let a=0;a<4;a++)o+=n[4*a+i]*t[4*s+a];e[4*s+i]=o}return e}function Vt(n,t,e,s){
let i=1/Math.tan(n/2),o=1/(e-s);return new Float32Array([i/t,0,0,0,0,i,0,0,0,0,(s+e)*o,-1,0,0,2*s*e*o,0])}function Jt(n,t){let e=W($t(n,t)),s=W(bt([0,1,0],e)),i=bt(
e,s);return new Float32Array([s[0],i[0],e[0],0,s[1],i[1],e[1],0,s[2],i[2],e[2],0,-It(s,n),-It(i,n),-It(e,n),1])}var $t=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],It=(n,t)=>n[0]*
t[0]+n[1]*t[1]+n[2]*t[2],bt=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]];function W(n){let t=Math.hypot(...n)||1;return[n[0]/t,n[1]/t,n[2]/
t]}function vt(n,t,e,s){let i=W(t),o=W(bt(i,Math.abs(i[2])>.9?[1,0,0]:[0,0,1])),a=bt(o,i);return new Float32Array([...o.map(h=>h*s),0,...i.map(h=>h*e),0,...a.map(
h=>h*s),0,...n,1])}function zt(n){let[t,e]=[Math.cos(n),Math.sin(n)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function z(n){let t=Number.parseInt(n.slice(1,7),16);
return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function K(n,t,e){let s=n.createProgram();for(let[o,a]of[[n.VERTEX_SHADER,t],[n.FRAGMENT_SHADER,e]]){let h=n.createShader(o);if(n.shaderSource(h,a),n.compileShader(
h),!n.getShaderParameter(h,n.COMPILE_STATUS))throw new Error(n.getShaderInfoLog(h));n.attachShader(s,h)}if(n.linkProgram(s),!n.getProgramParameter(s,n.LINK_STATUS))
throw new Error(n.getProgramInfoLog(s));let i={program:s,uniforms:{},attributes:{}};for(let o=0;o<n.getProgramParameter(s,n.ACTIVE_UNIFORMS);o++){let{name:a}=n.
getActiveUniform(s,o);i.uniforms[a]=n.getUniformLocation(s,a)}for(let o=0;o<n.getProgramParameter(s,n.ACTIVE_ATTRIBUTES);o++){let{name:a}=n.getActiveAttrib(s,o);
i.attributes[a]=n.getAttribLocation(s,a)}return i}function j(n,t,e,s){let i=n.createBuffer();n.bindBuffer(n.ARRAY_BUFFER,i),n.bufferData(n.ARRAY_BUFFER,new Float32Array(
t),n.STATIC_DRAW);let o=s&&n.createBuffer();s&&(n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,o),n.bufferData(n.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),n.STATIC_DRAW));let a=4*
Object.values(e).reduce((h,r)=>h+r,0);return{vertices:i,elements:o,parts:e,stride:a,count:s?s.length:4*t.length/a}}function G(n,{attributes:t},e){n.bindBuffer(n.
ARRAY_BUFFER,e.vertices);let s=0;for(let[i,o]of Object.entries(e.parts)){let a=t[i];a!==void 0&&(n.enableVertexAttribArray(a),n.vertexAttribPointer(a,o,n.FLOAT,
!1,e.stride,s)),s+=4*o}e.elements&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.elements)}function Bt(n,t){let e=[];for(let s=0;s<n;s++)for(let i=0;i<t;i++){let o=s*(t+
1)+i,a=o+t+1;e.push(o,a,o+1,a,a+1,o+1)}return e}function Zt(n,t=120,e=14){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++)s.push(2*Math.PI*i/t,2*Math.PI*o/e);
return j(n,s,{bend:2},Bt(t,e))}function Qt(n,t=28,e=18){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++){let[a,h]=[2*Math.PI*i/t,Math.PI*o/e],r=[Math.sin(h)*
Math.cos(a),Math.cos(h),Math.sin(h)*Math.sin(a)];s.push(...r,...r)}return j(n,s,{position:3,normal:3},Bt(t,e))}function Ct(n,t,e=20){let s=[];for(let i=0;i<=e;i++){
let o=2*Math.PI*i/e,a=[Math.cos(o),1-t,Math.sin(o)];s.push(Math.cos(o),0,Math.sin(o),...a,t*Math.cos(o),1,t*Math.sin(o),...a)}return j(n,s,{position:3,normal:3},
Bt(e,1))}var te=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,ee=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,se="vec4(0.0, 0.0, 0.0, shadow)",Le=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${ee}
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
   ${te}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${se} : vec4(shaded(color, n), 1.0);
   }`],$e=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${ee}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${te}
   void main() { gl_FragColor = shadow > 0.0 ? ${se} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],ze=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],xt=class{constructor(t,e,s,i,{keep:o=!1}={}){let a=t.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:o});if(!a)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=a,this.canvas=
t,this.sun=W(s),this.dark=i,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=K(a,...Le),this.body=K(a,...$e),this.line=K(a,...ze),this.torus=Zt(a),this.sphere=Qt(a),
this.cylinder=Ct(a,1),this.cone=Ct(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.colors);let h=new Uint8Array(e.flatMap(r=>[...r,255]));a.pixelStorei(
a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,e.length,1,0,a.RGBA,a.UNSIGNED_BYTE,h);for(let r of["TEXTURE_WRAP_S","TEXTURE_WRAP_T"])a.texParameteri(
a.TEXTURE_2D,a[r],a.CLAMP_TO_EDGE);for(let r of["TEXTURE_MIN_FILTER","TEXTURE_MAG_FILTER"])a.texParameteri(a.TEXTURE_2D,a[r],a.LINEAR);this.view=zt(0),this.eye=
[0,0,1],this.fastest=1}begin({background:t,eye:e,target:s,slope:i,angle:o,near:a,far:h}){let{gl:r,canvas:l}=this;r.viewport(0,0,l.width,l.height),r.clearColor(...t,
1),r.clear(r.COLOR_BUFFER_BIT|r.DEPTH_BUFFER_BIT|r.STENCIL_BUFFER_BIT),r.enable(r.DEPTH_TEST);let d=Vt(o,l.width/l.height,a,h);this.view=Lt(Lt(d,Jt(e,s)),zt(i)),
this.eye=W($t(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let i={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[o,a]of Object.
entries(i)){let h=t.uniforms[o];h!==void 0&&(typeof a=="number"?s.uniform1f(h,a):a.length===16?s.uniformMatrix4fv(h,!1,a):s[`uniform${a.length}fv`](h,a))}}ground(t){
let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.
ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),e.
depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:i=!1,lit:o=!0}={}){let{gl:a}=this;this.use(this.body,{model:e,color:s,shadow:i?
this.dark:0,lit:Number(o)}),G(a,this.body,t),a.drawElements(a.TRIANGLES,t.count,a.UNSIGNED_SHORT,0)}ball(t,e,s,i){this.solid(this.sphere,vt(t,[0,1,0],e,e),s,{shadow:i})}ring({
center:t,radius:e,tube:s,broad:i,angle:o,velocity:a,omega:h,plain:r=null},l){let{gl:d}=this;this.use(this.rim,{center:t,size:[e,s,i,o],motion:[...a,h],most:this.
fastest,shadow:l?this.dark:0,plain:r??[0,0,0],colored:r?0:1}),G(d,this.rim,this.torus),d.drawElements(d.TRIANGLES,this.torus.count,d.UNSIGNED_SHORT,0)}rod(t,e,s,i,o,a=!1){
this.solid(this.cylinder,vt(t,e,s,i),o,{shadow:a})}arrow(t,e,s,i,o){if(!(s>.02*i))return;let a=Math.min(.18*i,s),h=t.map((r,l)=>r+e[l]*(s-a));s>a&&this.rod(t,e,
s-a,.029*i,o),this.solid(this.cone,vt(h,e,a,Math.min(.075*i,.6*a)),o)}trace(t,e,s){let i=[];for(let o=0;o<t;o++){let a=e(o),h=e(Math.min(o+1,t-1));if(Math.hypot(
h[0]-a[0],h[1]-a[1])<1e-9&&o>0){let r=e(o-1);h=a.map((l,d)=>2*l-r[d])}for(let r of[-1,1])i.push(...a,0,...h,0,...s(o),r)}return j(this.gl,i,{position:3,next:3,tint:3,
side:1})}drawTrace(t,e,{width:s,distance:i=0,shift:o,depth:a}){let{gl:h,canvas:r}=this;this.use(this.line,{pixel:[2/r.width,2/r.height],width:s,distance:i,shift:o,
depth:a}),G(h,this.line,t),h.drawArrays(h.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let i=this.view,[o,a,h]=[0,1,3].map(r=>i[r]*t+i[4+r]*e+i[8+r]*s+i[12+r]);return h>
0?[(.5+.5*o/h)*this.canvas.width,(.5-.5*a/h)*this.canvas.height]:null}};var Be=[.35,.85,.4],Ce=.18,ie={azimuth:.5,height:.22,distance:5.2},Fe=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],kt=class{constructor(t,e){this.canvas=t,this.onview=e,this.space=new xt(t,X,Be,Ce,{keep:!0}),this.floor=K(this.space.gl,...Fe),this.corners=j(this.space.
gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...ie},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,t.addEventListener(
"pointerdown",s=>this.drag(s)),t.addEventListener("wheel",s=>{(s.ctrlKey||s.shiftKey||_(t.parentElement))&&(s.preventDefault(),this.zoomBy(Math.exp(-(s.deltaY||
s.deltaX)*.0015)))},{passive:!1}),this.pinched=C(t,s=>this.zoomBy(s))}zoomBy(t){t?this.turned.distance=b(this.turned.distance/t,1.6,60):this.turned={...ie},this.
onview()}drag(t){let e={...this.turned,x:t.clientX,y:t.clientY};B(this.canvas,t,s=>{this.pinched()||(this.turned.azimuth=b(e.azimuth-(s.clientX-e.x)*.008,-1.5,1.5),
this.turned.height=b(e.height+(s.clientY-e.y)*.006,.02,1.45),this.onview())})}quality(){let t=performance.now(),e=t-(this.before||t);return this.before=t,e>0&&e<
200&&(this.pace=.9*this.pace+.1*e),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.pace=16),this.share}draw(t,e,s,i,o,a){let{canvas:h,space:r}=this,
l=Math.min(globalThis.devicePixelRatio||1,2)*(a?this.quality():1),d=h.getBoundingClientRect();h.width=Math.max(Math.round(d.width*l),1),h.height=Math.max(Math.round(
d.height*l),1);let p=t.map(u=>u.at(e)),f=t[0].radius;r.fastest=Math.max(...t.map(u=>u.extent.speed)),this.focus=Number.isFinite(p[0].x)?p[0].x:0,r.begin({background:z(
i.paper),...this.camera(t[0],p[0],f,s)}),r.ground(()=>this.drawFloor(f,i));let g=u=>{for(let[y,m]of t.entries())u(m,p[y],-2.1*f*y)};r.shadows(()=>g((u,y,m)=>this.
drawHoop(u,y,m,s,i,o,!0))),g((u,y,m)=>{this.drawHoop(u,y,m,s,i,o,!1),s.traces&&this.drawTraces(u,y,m,i,o,l),s.forces&&this.drawForces(u,y,m,o)})}camera(t,e,s,i){
let{azimuth:o,height:a,distance:h}=this.turned,{left:r,right:l}=t.extent,d=i.whole?Math.max(h*s,.85*(l-r)+3*s):h*s,[p,f]=[i.whole?.5*(r+l)-this.focus:0,s+.45*(e.
height||0)],g=Math.cos(t.slope),u=Math.sin(t.slope),y=[p*g+f*u,-p*u+f*g,0],m=[y[0]+d*Math.sin(o)*Math.cos(a),y[1]+d*Math.sin(a),d*Math.cos(o)*Math.cos(a)];return this.
reach=12*s+3*d,{eye:m,target:y,slope:t.slope,angle:.75,near:.05*s,far:40*s+6*d}}drawFloor(t,e){let{space:s}=this,i=z(e.ground),o=i.map(r=>r*(e.dark?.82:.94)),a=.5*
t,h=this.focus%(2*a);s.use(this.floor,{reach:this.reach,light:i,dark:o,far:z(e.paper),tile:a,shift:h}),G(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,
0,4)}drawHoop(t,e,s,i,o,a,h){let{space:r}=this,l=t.radius,d=.045*l,p=[e.x-this.focus,l+e.height,s];r.ring({center:p,radius:l,tube:d,broad:3.2*d,angle:e.angle,velocity:[
e.vx,e.vy],omega:e.omega,plain:i.speed?null:z(a.modes[e.mode])},h);let f=[Math.sin(e.angle),Math.cos(e.angle),0],g=y=>p.map((m,w)=>m+y*f[w]);r.ball(g(l-d),.125*
l,o.dark?[.9,.91,.94]:[.12,.13,.15],h),r.rod(p,f,l-d,.012*l,[.55,.57,.6],h);let u=e.mode==="H";r.ball(g(t.eccentricity*l),.07*l,z(u?a.airborne:a.gravity_center),
h)}drawForces(t,e,s,i){if(e.mode==="H"||!(e.normal_force>0))return;let o=t.radius,a=t.mass*(t.gravity||9.81),h=[e.x-this.focus,e.height+.03*o,s+.2*o],r=d=>b(.55*
o*Math.abs(d)/a,0,3.2*o),l=Math.sign(e.friction_force);this.space.arrow(h,[0,1,0],r(e.normal_force),o,z(i.normal_force)),this.space.arrow(h,[l,0,0],r(e.friction_force),
o,z(i.friction_force))}linesOf(t,e,s){let i=this.lines.get(t);if(i?.dark===e.dark)return i;let o=t.radius,{x:a,height:h,angle:r,mode:l}=t.columns,d=(y,m)=>this.
space.trace(t.length,w=>[a[w]+y*Math.sin(r[w]),o+h[w]+y*Math.cos(r[w])],m),[p,f,g]=[z(s.gravity_center),z(s.airborne),z(e.ink)],u={dark:e.dark,load:d(o,()=>g),center:d(
t.eccentricity*o,y=>l[y]===3?f:p)};return this.lines.set(t,u),u}drawTraces(t,e,s,i,o,a){let{load:h,center:r}=this.linesOf(t,i,o),l=Math.min(t.index(e.t)+2,t.length),
d={shift:this.focus,depth:s};this.space.drawTrace(h,l,{width:a,...d}),this.space.drawTrace(r,l,{width:1.6*a,...d})}};var Ne=1/60,Z=class{constructor(t,e,{hosted:s=!1,panels:i=null}={}){Object.assign(this,{root:t,backend:e,hosted:s,panels:i}),this.clock=new nt,this.lanes=[],this.
active=0,this.options={traces:!0,forces:!0,speed:!0,whole:!1,three:!1},this.past=[],this.future=[],this.latencies=[],this.frame=this.frame.bind(this),this.later=
q(()=>this.fetchTheory(),120),t.classList.add("hophoop"),s||(t.classList.add("embedded"),t.dataset.lmSuppressShortcuts="true",t.dataset.pSuppressShortcuts="true")}async start({
setup:t,films:e,queries:s=[""],time:i=0}){this.setup=t??(await this.backend.call("setup",{})).header,this.colors=this.setup.colors,Gt(this),this.watchTheme(),e?
this.lanes=e.map(o=>({film:new D(o)})):await this.load(s),this.clock.time=i,this.remember(),this.show(),this.clock.listeners.add(()=>this.request()),new ResizeObserver(
()=>this.show()).observe(this.stageBox),this.root.dataset.ready="true"}film(t=this.active){return this.lanes[t].film}films(){return this.lanes.map(t=>t.film)}async load(t){
let e=await Promise.all(t.map(s=>this.backend.call("film",{query:s})));this.lanes=e.map(s=>({film:new D(s)})),this.active=Math.min(this.active,this.lanes.length-
1)}change(t,e){let s=this.lanes[this.active];s.since??=performance.now(),s.pending=[...(s.pending??[]).filter(([i])=>!t.some(([o])=>o===i)),...t],s.commit||=e,this.
pump(s)}async pump(t){if(t.busy||!t.pending){!t.busy&&t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{let i=await this.
backend.call("film",{scenario:t.film.scenario,changes:e});t.film=new D(i),this.presets.value="",this.clear(),this.show(s)}catch(i){this.fail(i)}finally{t.busy=!1}
this.pump(t)}settle(t){t.commit=!1,this.remember(),this.story.announce(this.films())}async take(t,e=null){try{let s=await this.backend.call("film",{query:t});this.
lanes[this.active].film=new D(s),this.clear(),this.clock.time=0,this.presetText.textContent=e?.text??"",this.show(),this.remember(),this.story.announce(this.films())}catch(s){
this.fail(s)}}remember(){let t=this.films().map(e=>e.query);this.now&&JSON.stringify(this.now)!==JSON.stringify(t)&&(this.past.push(this.now),this.past.length>500&&
this.past.shift(),this.future=[]),this.now=t,this.addressed()}replace(t){this.lanes[this.active].film=new D(t),this.clear(),this.show(),this.remember()}close(){
this.clock.playing=!1,this.asked?.abort(),this.map.asked?.abort()}async undo(){this.past.length&&await this.travel(this.past,this.future)}async redo(){this.future.
length&&await this.travel(this.future,this.past)}async travel(t,e){let s=t.pop();e.push(this.now),this.now=s,await this.load(s),this.clear(),this.presetText.textContent=
"",this.show(),this.addressed()}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.
active=0),this.show(),this.remember()}choose(t){this.active=t,this.show(),this.addressed()}link(){let t=this.lanes.length>1?`#with=${encodeURIComponent(this.film(
1).query)}`:"";return this.backend.link(this.film(0).query,t)}addressed(){this.undoButton.disabled=!this.past.length,this.redoButton.disabled=!this.future.length,
this.hosted&&history.replaceState(null,"",this.link()),this.onmotion?.(this.film().query)}show(t=null){let e=this.films();if(!e.length)return;this.look=Ot(this.
root),this.inks={...this.colors};for(let i of["gravity_center","airborne","normal_force","friction_force"])this.inks[i]=st(this.colors[i],this.look.dark);this.clock.
duration=Math.max(...e.map(i=>i.duration)),this.clock.time=Math.min(this.clock.time,this.clock.duration);let s=e.length>1;this.compareButton.setAttribute("aria-\
pressed",String(s)),this.root.classList.toggle("two",s),this.tabBar.hidden=!s;for(let[i,o]of this.tabs.entries())o.setAttribute("aria-pressed",String(i===this.active));
for(let[i,o]of this.switches)o.setAttribute("aria-pressed",String(this.options[i]));this.drawStage(),this.drawReadout(),this.controls.show(this.film()),t!=null&&
requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-t),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(
()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let t=this.films();this.timeline.draw(t,this.look,this.colors),this.plots.draw(t,this.active,
this.look),this.phase.draw(t,this.active,this.look),this.story.draw(t,this.active,this.colors),this.drawTime(),this.map.mark(this.film()),this.stageBox.setAttribute(
"aria-label",`The hoop. ${t.map(e=>e.summary).join(" ")}`),this.later()}stageCanvas(){return this.options.three?this.canvas3:this.canvas2}drawStage(){let{clock:t,
options:e,look:s,inks:i}=this;this.legend.hidden=!e.speed,this.stageKeys.at(-1).hidden=!(e.three&&this.lanes.length>1),this.fastest.textContent=`≥ ${v(Math.max(
...this.films().map(o=>o.extent.speed)),2)} m/s`,e.three?(this.stage3??=new kt(this.canvas3,()=>this.request()),this.stage3.draw(this.films(),t.time,e,s,i,t.playing)):
this.stage2.draw(this.films(),t.time,e,s,i)}drawTime(){let{clock:t}=this;if(this.surrounding)return;this.timeline.draw(this.films(),this.look,this.colors),this.
plots.cursor(t.time),this.phase.cursor(t.time),this.story.cursor(t.time);let e=t.playing?"Pause (space)":"Play (space)";(this.playButton.title!==e||!this.playButton.
firstChild)&&(this.playButton.replaceChildren(E(t.playing?"pause":"play")),this.playButton.title=e,this.playButton.setAttribute("aria-label",e)),this.speeds.value!==
String(t.speed)&&(this.speeds.value=String(t.speed))}drawReadout(){let t=this.film(),e=t.at(this.clock.time),s=[["hoop",this.lanes.length>1?"AB"[this.active]:""],
["mode",this.colors.mode_names[e.mode]],["time",`${e.t.toFixed(3)} s`],["angle",et(e.angle)],["v",L(v(e.vx,3),"m/s")],["R θ̇",L(v(e.omega*t.radius,3),"m/s")],
["gap",e.height>0?Nt(e.height):"0"]];this.outputs||(this.outputs=s.map(([i])=>[i,c("dd",{})]),this.readout.replaceChildren(...this.outputs.flatMap(([i,o])=>[c("\
dt",{},i),o]))),s.forEach(([,i],o)=>{this.outputs[o][1].textContent!==i&&(this.outputs[o][1].textContent=i)}),this.outputs[0][1].hidden=this.outputs[0][1].previousSibling.
hidden=this.lanes.length<2,this.outputs[1][1].className="mode",this.outputs[1][1].style.setProperty("--mode",this.colors.modes[e.mode])}request(){this.requested||
(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){this.requested=!1,this.lanes.length&&(this.clock.tick(t),this.drawStage(),this.drawTime(),this.drawReadout(),
this.afterFrame?.(),this.frames=(this.frames??0)+1,this.clock.playing&&this.request())}async fetchTheory(){let{scenario:t}=this.film();this.asked?.abort(),this.
asked=new AbortController;try{let e=await this.backend.call("theory",{scenario:t},this.asked.signal);this.theory.draw(e.header.thresholds,this.lanes.length>1?"A\
B"[this.active]:""),await this.phase.fetch(t,this.asked.signal)}catch(e){e.name!=="AbortError"&&this.theory.draw([{label:"–",text:e.message}])}}fail(t){this.message.
textContent=t.message,this.message.hidden=!1,this.message.isConnected||this.say(t.message)}clear(){this.message.hidden=!0}say(t){this.toast.textContent=t,this.toast.
hidden=!1,clearTimeout(this.toastTimer),this.toastTimer=setTimeout(()=>this.toast.hidden=!0,4e3)}toggle(t){if(this.options[t]=!this.options[t],t==="three")try{this.
canvas2.hidden=this.options.three,this.canvas3.hidden=!this.options.three,this.drawStage()}catch(e){this.options.three=!1,this.canvas2.hidden=!1,this.canvas3.hidden=
!0,this.say(e.message)}this.switches.get(t)?.setAttribute("aria-pressed",String(this.options[t])),this.request()}nudge(t){this.clock.playing=!1,this.clock.seek(
this.clock.time+t*Ne*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap(a=>a.events).filter(a=>e?a.kind===e:!0).map(a=>a.
t).sort((a,h)=>a-h),i=this.clock.time,o=t>0?s.find(a=>a>i+1e-9):s.findLast(a=>a<i-1e-9);if(o===void 0&&e&&(o=s[0]),o===void 0){e&&this.say(e==="takeoff"?"This m\
otion has no hop.":"This motion has no landing.");return}this.clock.seek(o)}zoom(t){this.options.three?this.stage3.zoomBy(t):t?this.stage2.zoomBy(t):this.stage2.
reset()}key(t){let{target:e}=t;if(t.ctrlKey||t.metaKey||t.altKey||this.root.querySelector("dialog[open]")||e.matches?.("input:not([type=range]), textarea, selec\
t")||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary"))return;let o={" ":()=>this.clock.play(),
ArrowLeft:()=>t.shiftKey?this.jump(-1):this.nudge(-1),ArrowRight:()=>t.shiftKey?this.jump(1):this.nudge(1),Home:()=>this.clock.seek(0),End:()=>this.clock.seek(this.
clock.duration),h:()=>this.jump(1,"takeoff"),l:()=>this.jump(1,"impact"),"[":()=>this.clock.faster(-1),"]":()=>this.clock.faster(1),t:()=>this.toggle("traces"),
f:()=>this.toggle("forces"),c:()=>this.toggle("speed"),w:()=>this.toggle("whole"),3:()=>this.toggle("three"),"+":()=>this.zoom(1.25),"=":()=>this.zoom(1.25),"-":()=>this.
zoom(.8),0:()=>this.zoom(0),z:()=>this.undo(),y:()=>this.redo(),d:()=>this.toggleTheme(),p:()=>this.share.code(),"?":()=>this.helpDialog.showModal()}[t.key];o&&
(t.preventDefault(),o())}watchTheme(){let t=matchMedia("(prefers-color-scheme: dark)"),e=()=>{let s=this.hosted?De("hophoop-theme"):null;this.root.dataset.theme=
this.chosenTheme??s??(t.matches?"dark":"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme),this.show(),this.map.redraw()};
t.addEventListener("change",e),this.applyTheme=e,e()}toggleTheme(){this.chosenTheme=this.root.dataset.theme==="dark"?"light":"dark",this.hosted&&Oe("hophoop-the\
me",this.chosenTheme),this.applyTheme()}};function De(n){try{return localStorage.getItem(n)}catch{return null}}function Oe(n,t){try{localStorage.setItem(n,t)}catch{}}var Mt=class{constructor(t){this.base=t,this.shares=!0}async call(t,e,s){let i=await fetch(new URL(`lab/${t}`,this.base),{method:"POST",headers:{"Content-Type":"\
application/json"},body:JSON.stringify(e),signal:s});if(!i.ok){let o=await i.json().catch(()=>({}));throw new Error(o.detail??`The server answered ${i.status}.`)}
return Y(await i.arrayBuffer())}async file(t,e){let s=await fetch(new URL(`api/v1/files/${t}?${e}`,this.base));if(!s.ok)throw new Error((await s.json()).detail);
return s.blob()}link(t,e){return`${new URL(t?`?${t}`:"",this.base)}${e}`}},Ue=2e4,He=3e5,Tt=class{constructor(t){this.model=t,this.shares=!1,this.waiting=new Map,
this.number=0,this.view=Math.random().toString(36).slice(2),this.listen=(e,s)=>this.answered(e,s),t.on("msg:custom",this.listen)}answered(t,e){let s=t?.view===this.
view&&this.waiting.get(t.number);s&&(clearTimeout(s.timer),this.waiting.delete(t.number),t.error?s.reject(new Error(t.error)):s.resolve(Y(e[0])))}call(t,e,s){let i=++this.
number;return new Promise((o,a)=>{let h=setTimeout(()=>{this.waiting.delete(i),a(new Error("The notebook’s kernel does not answer; run the cell again."))},t===
"file"?He:Ue);this.waiting.set(i,{resolve:o,reject:a,timer:h}),s?.addEventListener("abort",()=>{clearTimeout(h),this.waiting.delete(i),a(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:i,call:t,body:e})})}async file(t,e){let{arrays:s}=await this.call("file",{query:e,name:t});return new Blob(
[s.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};async function We(n){let t=new URL("./",document.baseURI.split(/[?#]/)[0]),e=new Z(n,new Mt(t),{hosted:!0}),s=new URLSearchParams(location.hash.slice(1)).get("w\
ith"),i=[location.search.slice(1),...s===null?[]:[s]];globalThis.hophoopLab=e;try{await e.start({queries:i})}catch(o){if(!e.setup){n.textContent=o.message;return}
e.lanes=[],history.replaceState(null,"",t),await e.start({setup:e.setup,queries:[""]}),e.fail(o)}}function je({model:n,el:t}){let e=document.createElement("div");
t.append(e);let s=new Tt(n),i=new Z(e,s,{panels:n.get("panels")});i.onmotion=a=>{n.get("query")!==a&&(n.set("query",a),n.save_changes())},i.start({setup:n.get("\
setup"),films:[Y(n.get("film"))]});let o=()=>i.replace(Y(n.get("film")));return n.on("change:film",o),()=>{n.off("change:film",o),s.close(),i.close()}}var oe=document.
getElementById("hophoop-lab");oe&&We(oe);var Js={render:je};export{Js as default};
