/* Built from web/lab/main.js by esbuild 0.28.2; sources 9a4d4bb0b07a0c045e287e5cd1307514 */
var ms={};var gs={};var ws={};var ys={};var _e=new Map;function lt(o){try{return localStorage.getItem(o)??_e.get(o)??null}catch{return _e.get(o)??null}}function ct(o,t){_e.set(o,t);try{localStorage.setItem(
o,t)}catch{}}var xt={en:"English",de:"Deutsch",es:"Español",fr:"Français",zh:"中文"},xs={de:ms,es:gs,fr:ws,zh:ys},Gi=new Set(["de","es","fr"]),ks="hophoop-language",Ki=4e3,
Re=/\{(\w+)\}/g,pt="en",Ms=[],vt=new Map,Ie=new Set,zt=()=>pt;function Le(o){pt=o in xt?o:"en",vt=new Map,Ie.clear(),Ms=Object.keys(xs[pt]??{}).filter(t=>t.includes(
"{")).map(Vi).sort((t,e)=>bs(e.key)-bs(t.key))}function Xi(){let o=lt(ks);return o&&o in xt?o:(navigator.languages??[navigator.language]).map(e=>e.slice(0,2).toLowerCase()).
find(e=>e in xt)??"en"}function Ts(o){ct(ks,o)}var bs=o=>o.replace(Re,"").length;function Vi(o){let t=[...o.matchAll(Re)].map(([,s])=>s),e=o.split(/\{\w+\}/).map(
s=>s.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));return{key:o,names:t,pattern:new RegExp(`^${e.join("(.+?)")}$`,"su")}}var Ss=o=>Gi.has(pt)?o.replace(/(\d)\.(\d)/g,"\
$1,$2"):o;function T(o,t){let e=xs[pt];if(t)return Es(e?.[o]??vs(o),t);if(!e||!/\p{L}/u.test(o))return Ss(o);let s=vt.get(o);if(s!==void 0)return s;let i=o.trim(),
n=e[i]??Ji(i,e)??vs(i),a=o.replace(i,()=>n);return vt.size>Ki&&vt.clear(),vt.set(o,a),a}var Es=(o,t)=>o.replace(Re,(e,s)=>T(String(t[s])));function Ji(o,t){for(let{
key:e,pattern:s,names:i}of Ms){let n=o.match(s);if(n)return Es(t[e],Object.fromEntries(i.map((a,h)=>[a,n[h+1]])))}return Zi(o)}function Zi(o){if(o.includes(" → "))
return o.split(" → ").map(t=>T(t)).join(" → ")}function vs(o){let t=/\p{L}{3,}/u.test(o)&&!/^[\w.[\]]+\.\w+$/.test(o);return pt!=="en"&&t&&Ie.size<200&&Ie.add(o),Ss(o)}var As=new WeakMap,$e=new WeakMap;function Ne(o){
let t=document.createTextNode(T(o));return As.set(t,o),t}function Ps(o,t,e){let s=$e.get(o)??{};s[t]=e,$e.set(o,s),o.setAttribute(t,T(e))}function _s(o){let t=document.
createTreeWalker(o,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let e=t.nextNode();e;e=t.nextNode()){let s=As.get(e);s!==void 0&&(e.nodeValue=T(s));let i=$e.
get(e);for(let[n,a]of Object.entries(i??{}))e.setAttribute(n,T(a))}}Le(Xi());function X(o){let t=Number.parseInt(o.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}var Is=o=>kt(o)>.2?"#111111":"#ffffff",Mt=(o,t)=>`rgba(${X(o).join(",")},${t}\
)`,Qi=o=>{let t=o/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4};function kt(o){let[t,e,s]=X(o).map(Qi);return .2126*t+.7152*e+.0722*s}function Ot(o,t){if(!t||
!/^#[0-9a-f]{6}$/i.test(o))return o;if(kt(o)<.002)return"#eceef2";let e=o;for(let s=0;kt(e)<.2&&s<1;s+=.05)e=`#${X(o).map(i=>Math.round(i+(255-i)*s).toString(16).
padStart(2,"0")).join("")}`;return e}var Ct=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function to(){let o=[];for(let t=0;t<
256;t++){let e=t/255*(Ct.length-1),s=Math.min(Math.floor(e),Ct.length-2),i=X(Ct[s]),n=X(Ct[s+1]);o.push(i.map((a,h)=>Math.round(a+(n[h]-a)*(e-s))))}return o}var dt=to(),
Ft=dt.map(o=>`rgb(${o.join(",")})`);var eo=new Set(["aria-label","title","placeholder","label"]);function l(o,t={},...e){let s=document.createElement(o),i=s;for(let[n,a]of Object.entries(t))a==null||
a===!1||(n.startsWith("on")?s.addEventListener(n.slice(2),a):n==="class"?s.className=a:n in s&&n!=="list"&&typeof a!="string"?i[n]=a:eo.has(n)?Ps(s,n,String(a)):
s.setAttribute(n,a===!0?"":a));for(let n of e.flat())n==null||n===!1||s.append(n.nodeType?n:Ne(String(n)));return s}function j(o,t){t?o.replaceChildren(Ne(t)):o.
replaceChildren()}var Bt=o=>o!==null&&o.getRootNode().activeElement===o,V=o=>o.getContext("2d");function I(o){let t=o.getBoundingClientRect(),e=Math.min(globalThis.
devicePixelRatio||1,2.5),s=Math.max(Math.round(t.width*e),1),i=Math.max(Math.round(t.height*e),1);(o.width!==s||o.height!==i)&&(o.width=s,o.height=i);let n=V(o);
return n.setTransform(e,0,0,e,0,0),{context:n,width:s/e,height:i/e}}function so(o){if(/^#[0-9a-f]{6}$/i.test(o))return o;let t=V(l("canvas",{width:1,height:1}));
t.fillStyle=o,t.fillRect(0,0,1,1);let[e,s,i]=t.getImageData(0,0,1,1).data;return`#${[e,s,i].map(n=>n.toString(16).padStart(2,"0")).join("")}`}function ze(o){let t=getComputedStyle(
o),e=i=>t.getPropertyValue(i).trim(),s=i=>so(e(i));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("--paper"),panel:s("--panel"),ground:s("--gro\
und"),font:e("--font"),dark:kt(s("--paper"))<.2}}function ut(o,t){let e=l("a",{href:URL.createObjectURL(o),download:t});document.body.append(e),e.click(),e.remove(),
setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function U(o,t){let e=0;return()=>{clearTimeout(e),e=setTimeout(o,t)}}var b=(o,t,e)=>Math.min(Math.max(o,t),e);function x(o,t=4){if(o==null)return"–";if(typeof o!="number")return String(o);if(!Number.isFinite(o))return Number.isNaN(
o)?"–":o>0?"∞":"−∞";if(o===0)return"0";let e=Math.abs(o),s;if(e>=1e6||e<1e-4){let[i,n]=o.toExponential(t-1).split("e");s=`${$s(i)}·10${io(Number(n))}`}else
s=$s(o.toPrecision(t)),s.includes("e")&&(s=String(Math.round(o)));return s.replace("-","−")}function $s(o){return o.includes(".")&&!o.includes("e")?o.replace(
/\.?0+$/,""):o}function io(o){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(o)].map(e=>t[e]).join(
"")}var $=(o,t)=>t?t==="°"?`${o}°`:`${o} ${t}`:o,P=o=>`${(o*180/Math.PI).toFixed(1)}°`.replace("-","−");function Z(o){let t=Math.abs(o),[e,s]=t>=.995?[1,"m"]:
t>=.00995?[100,"cm"]:[1e3,"mm"];return $(x(o*e,3),s)}function z(o,t){let e=o/Math.max(t,1),s=10**Math.floor(Math.log10(e)),i=e/s;return(i>5?10:i>2?5:i>1?2:1)*s}
function q(o,t,e){if(!(t>o)||!Number.isFinite(o)||!Number.isFinite(t))return[];let s=z(t-o,e),i=[];for(let n=Math.ceil(o/s-1e-9);n*s<=t+1e-9*s&&i.length<200;n++)
i.push(n*s);return i}function B(o,t){let e=b(-Math.floor(Math.log10(t)+1e-9),0,15);return Math.max(Math.abs(o),t)>=1e6||e>12?x(o,3):(Math.abs(o)<t*1e-6?0:o).toFixed(
e).replace("-","−")}var Rs=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],oo="tfc",no=400;function Ls({time:o=0,options:t={},zoom:e=1,map:s}){let i=[];o>
0&&i.push(`t=${Number(o.toFixed(4))}`);let n=Rs.filter(([a])=>t[a]).map(([,a])=>a);return n.join("")!==oo&&i.push(`show=${n.join("")}`),e!==1&&i.push(`zoom=${Number(
e.toPrecision(3))}`),s&&i.push(`map=${[s.what,...s.x,...s.y].join(",")}`),i.join("&")}function Ns(o){let t=new URLSearchParams(o.replace(/^#/,"")),e={},s=Number(
t.get("t")??Number.NaN);s>=0&&(e.time=s);let i=t.get("show");i!==null&&(e.options=Object.fromEntries(Rs.map(([g,y])=>[g,i.includes(y)])));let n=Number(t.get("zo\
om")??Number.NaN);n>0&&(e.zoom=b(n,.05,60));let[a,h,r,c,p,d,u]=t.get("map")?.split(",")??[],f=[r,c,d,u].map(Number);return u!==void 0&&f.every(Number.isFinite)&&
f[0]<f[1]&&f[2]<f[3]&&(e.map={what:a,x:[h,f[0],f[1]],y:[p,f[2],f[3]]}),e}var ao=()=>{let o=new URLSearchParams(location.hash.slice(1)).get("with");return[location.
search.slice(1),...o===null?[]:[o]]},Dt=class{constructor(t){this.lab=t,this.number=0,this.soon=U(()=>this.write("same"),no),this.listen=()=>this.arrived(),addEventListener(
"popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(t){let{lab:e}=this;if(!e.motions.lanes.length)return;let s=e.link();t==="step"?
history.pushState({number:++this.number},"",s):history.replaceState({number:this.number},"",s)}travel(t){return new Promise(e=>{let s=()=>e();addEventListener("\
popstate",s,{once:!0}),setTimeout(s,300),history.go(t)})}async arrived(){let t=history.state?.number??0,e=ao();JSON.stringify(e)===JSON.stringify(this.lab.motions.
queries())?this.number=t:await this.lab.motions.arrive(e)?this.number=t:t!==this.number&&history.go(this.number-t)}};var ro={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function ft(o){let t=o instanceof DataView||ArrayBuffer.isView(o)?o:new DataView(o),e=new Uint8Array(t.buffer,
t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(e.subarray(
4,4+s))),n={};for(let{name:a,type:h,shape:r,place:c}of i.arrays){let p=r.reduce((d,u)=>d*u,1);n[a]=new ro[h](e.buffer,e.byteOffset+4+s+c,p)}return{header:i,arrays:n}}var Tt=class extends Error{},ho=500,lo=4,co="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";async function zs(o,t,e){
for(;;)try{return await o()}catch(s){if(!(s instanceof Tt))throw s;t(s.message),await new Promise(i=>setTimeout(i,ho)),e.throwIfAborted()}}var Ht=class{constructor(t){
this.base=t,this.shares=!0}async call(t,e,s){let i={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),signal:s},n=await this.answered(
new URL(`lab/${t}`,this.base),i);if(n.status===202)throw new Tt((await n.json()).detail);return ft(await n.arrayBuffer())}async answered(t,e){for(let s=lo;;s--){
let i=await fetch(t,e).catch(a=>{throw a.name==="AbortError"?a:new Error(co)});if(i.ok)return i;let n=Number(i.headers.get("Retry-After"));if(i.status!==503||!(n>
0)||s<=1){let a=await i.json().catch(()=>({}));throw new Error(a.detail??`The server answered ${i.status}.`)}await new Promise(a=>setTimeout(a,1e3*Math.min(n,10))),
e?.signal?.throwIfAborted()}}async file(t,e){return(await this.answered(new URL(`api/v1/files/${t}?${e}`,this.base))).blob()}link(t,e){return`${new URL(t?`?${t}`:
"",this.base)}${e}`}},po=2e4,uo=3e5,qt=class{constructor(t){this.model=t,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).
slice(2),this.listen=(e,s)=>this.answered(e,s),t.on("msg:custom",this.listen)}answered(t,e){let s=t?.view===this.view&&this.waiting.get(t.number);s&&(clearTimeout(
s.timer),this.waiting.delete(t.number),t.compiling?s.reject(new Tt(t.compiling)):t.error?s.reject(new Error(t.error)):s.resolve(ft(e[0])))}call(t,e,s){let i=++this.
number;return new Promise((n,a)=>{let h=setTimeout(()=>{this.waiting.delete(i),a(new Error("The notebook’s kernel does not answer; run the cell again."))},t===
"file"?uo:po);this.waiting.set(i,{resolve:n,reject:a,timer:h}),s?.addEventListener("abort",()=>{clearTimeout(h),this.waiting.delete(i),a(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:i,call:t,body:e})})}async file(t,e){let{arrays:s}=await this.call("file",{query:e,name:t});return new Blob(
[s.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};var St=[.05,.1,.25,.5,1,2,4],Wt=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let t of this.listeners)t(this)}seek(t){this.time=b(t,0,this.duration),this.changed()}play(t=!this.playing){this.playing=t,this.last=null,t&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(t){let e=St.indexOf(this.speed);this.speed=St[b(e+t,0,St.length-1)],this.changed()}tick(t){if(!this.playing)return!1;
let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function fo(o,t=""){let e=o.trim();t&&e.endsWith(t)&&(e=e.slice(0,-t.length)),e=e.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(i,n,a)=>`e${n&&"-"}${a.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(e);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(e)?Number(e.replace(",",".")):Number.NaN}function mo(o,t,{label:e,unit:s,range:i}){let n=o.trim();if(Number.isNaN(t))return`${e} = ${n} must be a number, s\
uch as 2.5.`;if(!i||t>=i.least&&t<=i.most||i.also.includes(t))return"";let a=i.also.includes(0)?"0 or ":"",h=`from ${x(i.least,4)} to ${$(x(i.most,4),s)}`,r=i.also.
includes(1/0)?", or inf":"";return`${e} = ${$(x(t,6),s)} must be ${a}${h}${r}.`}var go=0,mt=class{constructor(t,e){this.info=t,this.onvalue=e,this.shown="",this.
typing=!1,this.error=l("p",{class:"error",role:"alert",id:`hh-error-${++go}`,hidden:!0}),this.input=l("input",{type:"text",inputmode:"decimal",autocomplete:"off",
spellcheck:"false",class:"exact","aria-label":t.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:s=>{
s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute("aria-invalid")==="true"}typed(){
let t=this.input.value;if(!this.typing)return;if(this.typing=!1,t.trim()===""){this.restore();return}let e=fo(t,this.info.unit),s=mo(t,e,this.info);s?this.refuse(
s):this.onvalue(e)}refuse(t){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.id),this.error.textContent=t,this.
error.hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){this.typing=!1,
this.input.value=this.shown,this.accept()}show(t){this.shown=t,this.typing||this.restore()}};var Cs={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},wo={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},yo=(o,t,e)=>({ring:{shape:o,mass:e,inner_radius:.95*t,outer_radius:t},disk:{shape:o,mass:e,radius:.1*
t,at:.8*t},point_mass:{shape:o,mass:e,at:t},rod:{shape:o,mass:e,length:.5*t,at:.5*t}})[o];function Os(o){let t=o["hoop.radius"],e=o["hoop.mass"],s=Math.min(Math.
max(o["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:jt(e*(1-s)),inner_radius:jt(.98*t),outer_radius:t},{shape:"point_mass",mass:jt(e*s),at:t}]}var jt=o=>Number(
o.toPrecision(6)),Ut=class{parts;text;radius;mass;constructor(t){this.onchange=t,this.list=l("div",{class:"parts"}),this.element=l("div",{},this.list,l("select",
{"aria-label":"Add a part",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,yo(s,this.radius,jt(.2*this.mass))])}},l("option",{value:""},
"+ add a part …"),Object.entries(Cs).map(([e,{label:s}])=>l("option",{value:e},s))))}send(t){this.onchange([["hoop.parts",t]])}show(t,e,s){let i=JSON.stringify(
t);if(i===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(this,{text:i,parts:t,radius:e,mass:s}),this.list.
replaceChildren(...t.map((n,a)=>this.row(n,a)))}row(t,e){let{label:s,keys:i}=Cs[t.shape];return l("fieldset",{class:"part"},l("legend",{},s,this.parts.length>1&&
l("button",{type:"button",class:"quiet","aria-label":`Remove part ${e+1}, ${s}`,onclick:()=>this.send(this.parts.filter((n,a)=>a!==e))},"×")),i.map(n=>this.field(
t,e,n)))}field(t,e,s){let[i,n]=wo[s],a=new mt({label:i,unit:n},h=>this.send(this.parts.map((r,c)=>c===e?{...r,[s]:h}:r)));return a.show(String(t[s]??0)),l("div",
{},l("label",{},`${i} [${n}]`,a.input),a.error)}};var Ce=Math.PI/180;function bo({allowed:o,degrees:t}){if(!o)return;let e=t?1/Ce:1;return{least:o.least*e,most:o.most*e,also:o.also.map(s=>s==="inf"?1/0:Number(s))}}
var Oe=class{constructor(t,e){this.info=t,this.onchange=e,this.held=!1;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`,i=r=>()=>{this.held=r};this.
range=l("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:i(!0),onpointerup:i(!1),onpointercancel:i(!1),onblur:i(!1)});let{label:n,unit:a}=t,h=`${n}, exact value${a?` i\
n ${a}`:""}`;this.entry=new mt({label:n,unit:a,name:h,range:bo(t)},r=>this.send(r,!0)),this.element=l("div",{class:"control",title:t.help},l("label",{for:s},l("\
span",{},n),l("span",{class:"symbol"},t.symbol)),this.range,l("span",{class:"entry"},this.entry.input,l("span",{class:"unit"},a)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(t){let e=Number(
this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.entry.typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,t)}send(t,e){
let s=this.info.degrees?t*Ce:t;this.onchange([[this.info.path,Number.isFinite(s)?s:"inf"]],e)}say(t){this.range.setAttribute("aria-valuetext",$(x(t,4),this.info.
unit))}show(t,e=null){if(this.held)return;let s=t!=null,i=s?t:e;if(i==null){this.entry.show("");return}let n=i==="inf"?1/0:Number(i)/(this.info.degrees?Ce:1);this.
entry.show(s?Number.isFinite(n)?String(Number(n.toPrecision(9))):"∞":""),this.entry.input.placeholder=s?"":`auto ${x(n,2)}`,this.entry.input.title=s?$(String(
n),this.info.unit):"";let a=b(this.info.logarithmic?Math.log10(n):n,this.low(),this.high());Math.abs(Number(this.range.value)-a)>1e-6&&(this.range.value=String(
a)),this.say(n)}};function vo(o,t){let e=l("select",{"data-path":o.path,onchange:()=>t([[o.path,e.value]],!0)},o.options.map(([i,n])=>l("option",{value:i},n)));
return{element:l("label",{class:"choice",title:o.help},l("span",{},o.label),e),select:e,path:o.path}}var Yt=class{way;kind;gravity;apart;derived;film;constructor(t,e){
this.onchange=(s,i=!0)=>e(s,i),this.sliders=new Map;for(let s of Object.values(t.groups))for(let i of s)this.sliders.set(i.path,new Oe(i,this.onchange));this.choices=
new Map(t.choices.map(s=>[s.path,vo(s,this.onchange)])),this.parts=new Ut(this.onchange),this.gravities=t.gravities,this.element=l("div",{class:"controls"},this.
hoop(),this.plane(),this.start(),this.contact())}at(t){let e=this.sliders.get(t)??this.choices.get(t);if(!e)throw new Error(`There is no control of ${t}.`);return e.
element}select(t,e,s){let i=l("select",{onchange:()=>s(i.value)},e.map(([n,a])=>l("option",{value:n},a)));return{select:i,element:l("label",{class:"choice"},l("\
span",{},t),i)}}group(t,...e){let s=t==="Start"||t==="Plane"||!matchMedia("(max-width: 760px)").matches;return l("details",{class:"group",open:s},l("summary",{},
t),e)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],t=>{let{values:e}=this.
film;t==="parts"?this.onchange([["hoop.parts",Os(e)]]):this.onchange([[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=l("p",{class:"derived"}),this.group(
"Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.eccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.r\
adius"),this.at("hoop.mass"))}plane(){return this.apart=l("input",{type:"checkbox",onchange:()=>{let{values:t}=this.film;this.apart.checked?this.onchange([["pla\
ne.mu_static",t["plane.mu_static"]],["plane.mu_kinetic",t["plane.mu_kinetic"]]]):this.onchange([["plane.mu",t["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([t])=>[t,t]),["","elsewhere"]],t=>{let e=this.gravities.find(([s])=>s===t);e&&this.onchange([["plane.gravity",e[1]]])}),this.group(
"Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_kinetic"),l("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.
at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("plane.restitution"),this.at("plane.rolling_resistance"),this.at("plane.impact_law"),this.
at("plane.painleve"))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],t=>{let{values:e}=this.film;t==="rolling"?this.
onchange([["start.speed",e["start.vx"]]]):this.onchange([["start.omega",e["start.omega"]]])}),this.group("Start",this.kind.element,this.at("start.speed"),this.at(
"start.angle"),this.at("start.height"),this.at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.at("duration"))}contact(){return this.group("Contact",
this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitut\
ion"))}refuse(t,e){let s=t.length===1?this.sliders.get(t[0][0]):void 0;return s?.element.checkVisibility()?(s.entry.refuse(e),!0):!1}restore(){this.film&&this.showChoices(
this.film,new Set)}show(t,e=new Set){this.film=t,this.showChoices(t,e);let s=t.scenario;for(let[i,n]of this.sliders){if(e.has(i))continue;let[a,h]=i.split(".");
n.show(t.values[i]??(h?s[a]?.[h]:s[a]),t.automatic?.[i])}}showChoices(t,e){let{scenario:s,values:i}=t,n=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_frac\
tion":"eccentricity",a="speed"in s.start,h="mu_static"in s.plane,r=s.contact.model==="compliant",c=(...f)=>f.some(g=>e.has(g));c("hoop.load_fraction","hoop.ecce\
ntricity","hoop.parts")||(this.way.select.value=n),c("start.speed","start.omega")||(this.kind.select.value=a?"rolling":"free"),c("plane.mu","plane.mu_static")||
(this.apart.checked=h);let p=this.gravities.find(([,f])=>Math.abs(f-s.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=p?p[0]:"");let d={"hoo\
p.load_fraction":n==="load_fraction","hoop.eccentricity":n==="eccentricity","hoop.inertia_ratio":n==="eccentricity","hoop.mass":n!=="parts","plane.mu":!h,"plane\
.mu_static":h,"plane.mu_kinetic":h,"plane.restitution":!r,"plane.impact_law":!r,"plane.painleve":!r,"start.speed":a,"start.height":!a,"start.vx":!a,"start.vy":!a,
"start.omega":!a,"contact.law":r,"contact.friction":r,"contact.stiffness":r,"contact.slip_speed":r,"contact.restitution":r};for(let[f,g]of Object.entries(d))this.
at(f).hidden=!g;this.parts.element.hidden=n!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,i["hoop.radius"],i["hoop.mass"]),this.derived.textContent=n==="\
eccentricity"?"":`ε = ${x(i["hoop.eccentricity"],5)}, κ = ${x(i["hoop.inertia_ratio"],5)}`+(n==="parts"?`, m = ${x(i["hoop.mass"],5)} kg`:"");let u=s;for(let[
f,{select:g}]of this.choices){if(e.has(f))continue;let[y,w]=f.split(".");u[y]?.[w]!==void 0&&(g.value=u[y][w])}}};var Fe=Math.PI/180;function Fs(o,t){let{start:e,plane:s,contact:i,hoop:n}=o.scenario;return i.model!=="rigid"?"Rigid contact only.":o.slope!==0?"The plane must \
be level.":Math.abs(o.gravity-9.81)>1e-9?"It must be on Earth.":(s.restitution??0)!==0?"Restitution must be 0.":o.radius!==1||n.parts?"The radius must stay 1 m,\
 without parts.":o.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in n?"speed"in e?Math.abs(e.speed??3.1)>t+1e-9?t>5?"At most 10 \
m/s.":"At most 3.1 m/s.":o.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var Bs=o=>o.events.filter(
({kind:t})=>t==="takeoff");function xo(o){return o.events.filter(({kind:t})=>t==="apex").map(({height:t})=>t)}var Ds=(o,t)=>Math.min(Math.round(100*o/t),100),ko=1.596,
Mo=.37,To=.05,Be=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:o=>{let t=Fs(o,3.1);if(t)return{points:0,text:t};let e=Math.max(
0,...xo(o));return e?{points:Ds(e,ko),text:"It rises by {height}.",values:{height:Z(e)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land upright",
text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=0.9\
&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:o=>{let t=Bs(o)[0],e=o.events.find(({kind:a,t:h})=>a==="impact"&&t&&h>t.t);if(!t||!e)return{
points:0,text:"It does not hop."};let s=o.events.find(({kind:a,t:h})=>a==="apex"&&h>t.t);if(!s||s.height<To)return{points:0,text:"The first hop is too low."};let i=Math.
abs(e.angle-2*Math.PI*Math.round(e.angle/(2*Math.PI)))/Fe,n=Math.max(0,Math.round(100*(1-(i-.5)/89.5)));return{points:Math.min(n,100),text:"It lands {off} away \
from the top.",values:{off:P(i*Fe)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:o=>{let t=Fs(o,10);if(t)return{points:0,text:t};if(Math.
abs(Math.abs(o.scenario.start.angle??0)-Math.PI)>.5*Fe)return{points:0,text:"The load must start at the bottom."};if(o.values["plane.mu_kinetic"]>1.5||o.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let e=Bs(o)[0];if(!e)return{points:0,text:"It does not hop."};let s=o.phases.filter(
({from:n})=>n<e.t);if(s.some(({mode:n})=>n==="K"))return{points:0,text:"It skids before it hops."};if(s[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let i=o.events.find(({kind:n,t:a})=>n==="apex"&&a>e.t);return i?{points:Ds(i.height,Mo),text:"It rises by {height}.",values:{height:Z(i.height)}}:{points:0,
text:"It does not hop."}}}],De=o=>o>=95?3:o>=75?2:o>=40?1:0;var Hs="hophoop-best-",So=o=>"★".repeat(De(o))+"☆".repeat(3-De(o)),Gt=class{goal=null;constructor(t){this.lab=t,this.tabs=new Map(Be.map(e=>[e.key,l("button",
{type:"button","aria-pressed":"false",onclick:()=>this.choose(e)},e.title)])),this.text=l("p",{}),this.meter=l("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"\
100","aria-label":"Score"}),this.result=l("p",{class:"challenge-result",role:"status"}),this.kept=l("p",{class:"hint"}),this.element=l("section",{class:"challen\
ges card","aria-label":"Challenges",hidden:!0},l("header",{},l("h2",{},"Challenges"),l("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",
onclick:()=>this.close()},"×")),l("div",{class:"tabs",role:"group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.
kept,l("div",{class:"buttons"},l("button",{type:"button",onclick:()=>this.goal&&this.load(this.goal.start)},"Begin again"),l("button",{type:"button",onclick:()=>this.
goal&&this.load(this.goal.best)},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??Be[0]),this.element.scrollIntoView({block:"nearest"}),
this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(t){this.goal=t;for(let[e,s]of this.tabs)s.setAttribute(
"aria-pressed",String(e===t.key));j(this.text,t.text),this.changed()}async load(t){let{lab:e}=this;try{let s=await e.backend.call("film",{query:t});e.clock.play(
!1),e.clock.time=0,e.motions.replace(s)}catch(s){e.notice.fail(s)}}changed(){let{goal:t,lab:e}=this;if(!t)return;let{points:s,text:i,values:n={}}=t.score(e.film());
this.meter.value=s;let a=T("{stars} {points} points. {what}",{stars:So(s),points:s,what:T(i,n)});this.result.textContent!==a&&(this.result.textContent=a);let h=Number(
lt(Hs+t.key)??0);s>h&&!e.stage.options.ahead&&ct(Hs+t.key,String(s)),j(this.kept,T("Your best: {points} points.",{points:Math.max(h,e.stage.options.ahead?0:s)}))}};var qs=.09,Eo=.03,He=Math.PI/180,Kt=Math.PI/4,Ws=2*Math.PI,Et=o=>o-Ws*Math.round(o/Ws);function Xt(o,t){let e=o.at(t),s=t===0;return{angle:Et(e.angle),height:Math.
max(e.height,0),vx:s?e.vx:0,vy:s?e.vy:0,omega:s?e.omega:0,slope:o.slope}}var js=o=>2*Math.sqrt(Math.max(o.gravity,1)*o.radius),Q=o=>Number(o.toFixed(4))+0;function Us(o,t,e){
if(o==="plane")return[["plane.slope",Q(t.slope)]];if(t.height>0)return[["start.angle",Q(t.angle)],["start.height",Q(t.height)],["start.vx",Q(t.vx)],["start.vy",
Q(t.vy)],["start.omega",Q(t.omega)]];let s=o==="load"?t.omega*e.radius:t.vx;return[["start.angle",Q(t.angle)],["start.speed",Q(s)]]}var At=class{constructor(t,e,s,i,n){
this.grip=t,this.film=e,this.view=i,this.before=Xt(e,s),this.held={...this.before,vx:0,vy:0,omega:0};let a=e.at(s);this.center=[a.x,e.radius+a.height],this.foot=
i.point(a.x,0),this.from=this.read(n),this.turned=0,this.trail=[],this.moved=0}read(t){let[e,s]=this.view.unpoint(t.clientX,t.clientY),i=this.grip==="plane"?Math.
atan2(t.clientY-this.foot[1],t.clientX-this.foot[0]):Math.atan2(e-this.center[0],s-this.center[1]);return{x:t.clientX,y:t.clientY,along:e,away:s,turn:i}}move(t,e){
let s=this.read(t),{radius:i}=this.film;if(this.turned+=Et(s.turn-this.from.turn-this.turned),this.grip==="plane"){let n=b(this.before.slope+this.turned,-Kt,Kt);
this.held.slope=Math.abs(n)<He?0:n}else if(this.grip==="load")this.held.angle=Et(this.before.angle+this.turned);else{let n=this.before.height+s.away-this.from.away;
this.held.height=n<Eo*i?0:n;let a=s.along-this.from.along;this.held.angle=Et(this.before.angle+(this.held.height>0?0:a/i)),this.moved=s.x-this.from.x}for(this.trail.
push({t:e/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<e/1e3-qs;)this.trail.shift();return this.held}release(t){let{held:e,
trail:s,film:i}=this,n=s.at(-1),a=s[0],h=n&&a?n.t-a.t:0,r=!n||h<.012||t/1e3-n.t>qs,c=js(i);return r||this.grip==="plane"||(this.grip==="load"?e.omega=b((n.turned-
a.turned)/h,-c/i.radius,c/i.radius):(e.vx=b((n.along-a.along)/h,-c,c),e.vy=e.height>0?b((n.away-a.away)/h,-c,c):0)),e}};function Ys(o,t,e,s,i){let n={ArrowLeft:-1,
ArrowRight:1}[t]??0,a={ArrowDown:-1,ArrowUp:1}[t]??0;if(!n&&!a)return null;let h=e?.2:1;if(o==="load"){let d=Et(s.angle+(n||a)*5*He*h);return{...s,angle:d}}if(o===
"plane"){let d=b(s.slope+(n||-a)*He*h,-Kt,Kt);return{...s,slope:Math.abs(d)<1e-9?0:d}}let r=js(i),c=b(s.height+a*.05*h*i.radius,0,4*i.radius),p=b(s.vx+n*.1*h,-r,
r);return{...s,height:c<1e-9?0:c,vx:p}}function R(o,t,e,s=()=>{}){let i=new AbortController,{signal:n}=i,a=(r,c)=>o.addEventListener(r,p=>p.pointerId===t.pointerId&&c(p),{signal:n}),h=r=>c=>{i.abort(),
s(c,r)};o.setPointerCapture(t.pointerId),a("pointermove",e),a("pointerup",h(!0)),a("pointercancel",h(!1))}function Gs(o,t){let e=new Map,s=null,i=()=>{let[a,h]=[
...e.values()];return{span:Math.max(Math.hypot(a.clientX-h.clientX,a.clientY-h.clientY),1),clientX:.5*(a.clientX+h.clientX),clientY:.5*(a.clientY+h.clientY)}};o.
addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(e.set(a.pointerId,a),s=e.size===2?i():null)}),o.addEventListener("pointermove",a=>{if(!e.has(a.pointerId)||
(e.set(a.pointerId,a),e.size!==2||!s))return;let h=i();t(h.span/s.span,h),s=h});for(let a of["pointerup","pointercancel"])o.addEventListener(a,h=>{e.delete(h.pointerId),
s=null});let n=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();return o.addEventListener("touchmove",n,{passive:!1}),()=>e.size>1}var Ao=700,qe=44,Po=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],Vt=class{static Pull=At;pull=null;held=null;before=null;constructor(t){this.
lab=t,this.places=new Map(Po.map(([e,s,i])=>[e,this.place(e,s,i)])),this.tip=l("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=l("div",
{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.values()],this.tip),t.stage.element.before(this.element),this.settle=U(()=>this.
chosen(!1),Ao)}place(t,e,s){return l("div",{class:`grip grip-${t}`,role:"slider",tabindex:"0","aria-label":e,"aria-valuenow":"0",title:s,onpointerdown:i=>this.take(
t,i),onkeydown:i=>this.key(t,i),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.flat.views[this.lab.motions.active]}draw(){let{lab:t}=this,
e=this.view(),s=!!e&&!t.stage.options.three;if(this.element.hidden=!s,!s)return;this.element.classList.toggle("running",t.clock.playing);let{pose:i,film:n,scale:a}=e,
h=n.radius,r=e.point(i.x,h+i.height),c=e.point(i.x+h*Math.sin(i.angle),h+i.height+h*Math.cos(i.angle)),p=this.onPlane(e),d=b(1.1*h*a,qe,190),u=[["plane",p,qe],[
"hoop",r,d],["load",c,qe]];for(let[f,[g,y],w]of u){let m=this.places.get(f);m.style.transform=`translate(${g-w/2}px, ${e.top+y-w/2}px)`,m.style.width=m.style.height=
`${w}px`,m.hidden=g<0||y<0||g>e.width||y>e.height}t.clock.playing||this.tell(n)}onPlane(t){let e=t.point(t.pose.x,0),i=(Math.min(e[0]+Math.max(1.9*t.film.radius*
t.scale,90),t.width-30)-e[0])/(t.scale*Math.max(t.cosine,.2));return t.point(t.pose.x+i,0)}tell(t){let e=this.pull?.held??this.held??Xt(t,this.lab.clock.time),s={
load:P(e.angle),hoop:T("gap {height}, speed {speed} m/s",{height:Z(e.height),speed:x(e.vx,3)}),plane:P(e.slope)},i={load:e.angle*(180/Math.PI),hoop:e.height,plane:e.
slope*(180/Math.PI)},n={load:[-180,180],hoop:[0,4*t.radius],plane:[-45,45]};for(let[a,h]of this.places)h.getAttribute("aria-valuetext")!==s[a]&&(h.setAttribute(
"aria-valuetext",s[a]),h.setAttribute("aria-valuenow",String(Number(i[a].toPrecision(4)))),h.setAttribute("aria-valuemin",String(n[a][0])),h.setAttribute("aria-\
valuemax",String(Number(n[a][1].toPrecision(4)))))}take(t,e){if(e.button>0||this.pull)return;e.preventDefault();let{lab:s}=this,i=this.places.get(t);i.focus({preventScroll:!0}),
this.hold();let n=this.view(),a=s.stage.element.getBoundingClientRect(),h=d=>({clientX:d.clientX-a.left,clientY:d.clientY-a.top-n.top}),r=new At(t,s.film(),s.clock.
time,n,h(e)),c=!1,p=[...s.stage.flat.shift];this.pull=r,s.stage.flat.fixed=n.scale,i.classList.add("held"),R(i,e,d=>{!c&&Math.hypot(d.clientX-e.clientX,d.clientY-
e.clientY)<3||(c||this.begin(),c=!0,r.move(h(d),d.timeStamp),s.stage.flat.shift=[p[0]+r.moved,p[1]],this.change(t,r.held,!1),this.show(t,r.held))},(d,u)=>{if(i.
classList.remove("held"),this.pull=null,s.stage.flat.fixed=null,!c){this.before=null;return}u?(this.change(t,r.release(d.timeStamp),!0),this.end(!0)):this.back(),
this.comeBack(p)})}key(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{lab:s}=this;if(e.key==="Escape"&&(this.held||this.pull))this.back();else if(e.key==="En\
ter")this.chosen(!0);else{this.held??=Xt(s.film(),s.clock.time);let i=Ys(t,e.key,e.shiftKey,this.held,s.film());if(!i)return;this.before===null&&(this.hold(),this.
begin()),this.held=i,this.change(t==="load"?"hoop":t,i,!1),this.show(t,i),this.settle()}e.preventDefault(),e.stopPropagation()}hold(){this.lab.clock.play(!1),this.
before=this.lab.film().query}begin(){let{lab:t}=this;t.stage.options.ahead=!0,t.clock.seek(0),t.root.classList.add("holding")}change(t,e,s){this.lab.motions.change(
Us(t,e,this.lab.film()),s)}show(t,e){let s={load:`θ = ${P(e.angle)}`,hoop:e.height>0?`y = ${Z(e.height)}`:`θ = ${P(e.angle)}`,plane:`β = ${P(e.slope)}`};j(this.
tip,e.vx&&this.held?`${s[t]}, v = ${x(e.vx,3)} m/s`:s[t]),this.tip.hidden=!1}chosen(t){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(t)}end(t){
let{lab:e}=this;this.held=null,this.before=null,this.tip.hidden=!0,e.stage.options.ahead=!1,e.root.classList.remove("holding"),t&&e.clock.seek(0),t&&!matchMedia(
"(prefers-reduced-motion: reduce)").matches&&e.clock.play(!0),e.request()}async back(){let{lab:t,before:e}=this;if(this.end(!1),e===null)return;let s=t.motions.
lanes[t.motions.active];for(s.pending=null;s.busy;)await new Promise(i=>requestAnimationFrame(i));try{t.motions.replace(await t.backend.call("film",{query:e}))}catch(i){
t.notice.fail(i)}}comeBack(t){let{flat:e}=this.lab.stage,s=matchMedia("(prefers-reduced-motion: reduce)").matches,i=()=>{if(this.pull)return;let n=e.shift[0]-t[0];
e.shift=Math.abs(n)<1||s?[...t]:[t[0]+.82*n,t[1]],this.lab.request(),e.shift[0]!==t[0]&&requestAnimationFrame(i)};i()}};var _o={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function L(o){let t="\
http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class",
"icon");let s=document.createElementNS(t,"path");return s.setAttribute("d",_o[o]),e.append(s),e}var Jt=class{constructor(t){this.lab=t,this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener("fullscreenchange",this.left),
this.full=!1,this.on=!1,this.onchange=()=>{}}async turn(t=!this.on){let{root:e}=this.lab;if(this.on=t,e.classList.toggle("presenting",t),this.onchange(),this.lab.
show(),!t){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await e.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var Ks=.22,Xs=.03;function Vs(o,t){let e=o.at(t),s=o.mass*(o.gravity||9.81),i=e.mode==="H"||!(e.normal_force>0)?0:e.normal_force/s,n=i/(1+i),a=e.mode==="S"||e.mode===
"K",h=Math.abs(e.slip)/Math.sqrt((o.gravity||9.81)*o.radius);return{tone:n,pitch:55*(1+Math.min(i,8))**.5,hiss:a?n*b(.15+h,0,1):0}}function Js(o,t,e){let s=Math.
sqrt(2*(o.gravity||9.81)*o.radius);return o.events.filter(({kind:i,t:n,before:a})=>i==="impact"&&a&&n>t&&n<=e).map(({before:i})=>b(Math.abs(i.vy)/s,.02,1))}function Io(o){
let t=o.createBuffer(1,o.sampleRate,o.sampleRate),e=t.getChannelData(0),s=1;for(let i=0;i<e.length;i++)s=s*16807%2147483647,e[i]=2*s/2147483647-1;return t}var Zt=class{static heard=Vs;static knocks=Js;context=null;on=!1;last=0;start(){
let t=new AudioContext,e=t.createOscillator();e.type="triangle";let s=t.createBufferSource();s.buffer=Io(t),s.loop=!0;let i=t.createBiquadFilter();i.type="bandp\
ass",i.frequency.value=1800,i.Q.value=.6;let[n,a]=[t.createGain(),t.createGain()];n.gain.value=a.gain.value=0,e.connect(n).connect(t.destination),s.connect(i).connect(
a).connect(t.destination),e.start(),s.start(),this.context=t,Object.assign(this,{tone:e,low:n,high:a})}turn(t){this.on=t,t&&!this.context&&this.start(),t?this.context?.
resume():this.context&&(this.set("low",0),this.set("high",0))}set(t,e){let{gain:s}=this[t];s.setTargetAtTime(Ks*e,this.context.currentTime,Xs)}follow(t,e){if(!this.
on||!this.context)return;if(!e.playing){this.set("low",0),this.set("high",0),this.last=e.time;return}let{tone:s,pitch:i,hiss:n}=Vs(t,e.time);if(this.set("low",s),
this.set("high",.6*n),this.tone.frequency.setTargetAtTime(i,this.context.currentTime,Xs),e.time>this.last)for(let a of Js(t,this.last,e.time))this.knock(a);this.
last=e.time}knock(t){let e=this.context,s=e.currentTime,i=e.createGain();i.gain.setValueAtTime(2.2*Ks*Math.sqrt(t),s),i.gain.exponentialRampToValueAtTime(1e-4,s+
.18);let n=e.createOscillator();n.frequency.setValueAtTime(190,s),n.frequency.exponentialRampToValueAtTime(60,s+.15),n.connect(i).connect(e.destination),n.start(
s),n.stop(s+.2)}close(){this.context?.close()}};var We=Math.PI/180,C=o=>t=>t.columns[o],Pt=(o,t)=>e=>e.derived(o,s=>Float64Array.from(e.t,(i,n)=>t(s,n,e))),N={time:{name:"time",symbol:"t",unit:"s",values:o=>o.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:Pt("degrees",({angle:o},t)=>o[t]/We)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:Pt(
"within",({angle:o},t)=>{let e=s=>Math.floor(o[s]/We/360);return t>0&&e(t)!==e(t-1)?Number.NaN:o[t]/We-360*e(t)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:C("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:C("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:Pt(
"rise",({height:o,angle:t},e,s)=>s.radius*(1+s.eccentricity*Math.cos(t[e]))+o[e])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:C("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:Pt("spin",({omega:o},t,e)=>o[t]*e.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:C(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:C("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:C("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:C("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:C("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:C("utilization")},kinetic:{name:"kinetic energy",symbol:"E_k",unit:"J",values:C("kinetic")},potential:{name:"\
potential energy",symbol:"E_p",unit:"J",values:C("potential")},total:{name:"total energy",symbol:"E",unit:"J",values:Pt("total",({kinetic:o,potential:t},e)=>o[e]+
t[e])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:C("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:C("normal_loss")},rolling_resistance:{name:"lost to rolling resistance",symbol:"W_r",unit:"J",values:C("rolling_resistance")}},Zs=({name:o,symbol:t})=>`${o}\
 ${t}`;var $o=["time","angle","x","vx","spin","normal_force","friction_force"],Ro=[1,.5,.2,.1,.05,.02,.01],je=601;function Qs(o,t,e){let s=Math.min(Math.floor(o.duration/
e+1e-9)+1,je),i=[];for(let n=0;n<s;n++){let a=Number((n*e).toPrecision(12));i.push({time:a,mode:o.at(a).mode,values:t.map(h=>Lo(o,h,a))})}return i}function Lo(o,t,e){
if(t==="time")return e;let s=o.at(e);if(t in s&&t!=="angle")return s[t];let i=s.angle*180/Math.PI;if(t==="angle")return i;if(t==="turns")return i-360*Math.floor(
i/360);let n=N[t].values(o),a=o.index(e),h=Math.min(a+1,o.length-1),r=o.t[h]>o.t[a]?(e-o.t[a])/(o.t[h]-o.t[a]):0;return n[a]+r*(n[h]-n[a])}var Qt=class{film;rows=[];now;constructor(t){
this.lab=t,this.columns=[...$o],this.step=l("select",{onchange:()=>this.fill()},Ro.map(e=>l("option",{value:String(e)},`${e} s`))),this.step.value="0.1",this.picks=
l("div",{class:"table-picks"},Object.entries(N).filter(([e])=>e!=="time").map(([e,{name:s}])=>this.pick(e,s))),this.caption=l("caption",{}),this.head=l("thead",
{}),this.body=l("tbody",{}),this.element=l("section",{class:"table","aria-label":"Table of the motion",hidden:!0},l("header",{},l("h2",{},"Table"),l("label",{class:"\
table-step"},l("span",{},"Every"),this.step),l("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),l("button",{type:"button",onclick:()=>this.open(!1)},
"Close")),l("details",{class:"table-columns"},l("summary",{},"Columns"),this.picks),l("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table\
 of the motion, rows"},l("table",{},this.caption,this.head,this.body)))}pick(t,e){let s=l("input",{type:"checkbox",checked:this.columns.includes(t),onchange:()=>{
let i=new Set(this.columns);s.checked?i.add(t):i.delete(t),this.columns=Object.keys(N).filter(n=>i.has(n)),this.fill()}});return l("label",{},s,l("span",{},e))}open(t){
this.element.hidden=!t,t&&(this.draw(this.lab.film()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(t){this.
element.hidden||(this.film=t,this.fill())}fill(){let{film:t,columns:e}=this,s=Number(this.step.value),i=this.lab.theme.colors.mode_names,n=e.map(r=>N[r]);this.head.
replaceChildren(l("tr",{},n.map(({name:r,symbol:c,unit:p})=>l("th",{scope:"col",title:r},c,p&&l("small",{},` ${p}`))),l("th",{scope:"col"},"mode")));let a=Qs(t,
e,s);this.rows=a.map(({time:r,mode:c,values:p})=>({time:r,row:l("tr",{onclick:()=>this.lab.clock.seek(r)},p.map((d,u)=>u===0?l("th",{scope:"row"},x(d,4)):l("td",
{},x(d,4))),l("td",{class:"table-mode"},i[c]))})),this.body.replaceChildren(...this.rows.map(({row:r})=>r));let h=t.duration/s+1<=je+1e-6;j(this.caption,h?t.summary:
`${t.summary} ${T("The first {count} rows.",{count:je})}`),this.cursor(this.lab.clock.time)}cursor(t){if(this.element.hidden||!this.rows.length)return;let e=Number(
this.step.value),s=this.rows[Math.min(Math.round(t/e),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.add("now"),this.now=
s)}save(){let{film:t,columns:e}=this,s=[...e.map(n=>`${N[n].name} [${N[n].unit||"1"}]`),"mode"],i=Qs(t,e,Number(this.step.value)).map(({mode:n,values:a})=>[...a,
n].join(","));ut(new Blob([[s.join(","),...i,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var ti="hoop.radius=0.4&duration=1.5&start.speed=",No=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${ti}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],zo=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],Co=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],Oo=["1.0","1.3","1.6","1.9","2.2","2.3"],Fo=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function ei(o,t){
let e=p=>{c.close(),o(p)},s=(p,d="Show")=>l("button",{type:"button",class:"link",onclick:()=>e(p)},d),i=Fo(),n=i&&[["teach/index.html","Teaching with the hoop"],
["teach/worksheet.html","Worksheet"],["teach/solutions.html","Solutions"],["teach/exercises.html","Exercises"]],a=l("table",{},l("caption",{},"A lesson of 45 mi\
nutes"),l("thead",{},l("tr",{},["Minute","What happens","Motion"].map(p=>l("th",{scope:"col"},p)))),l("tbody",{},No.map(([p,d,u])=>l("tr",{},l("th",{scope:"row"},
p),l("td",{},d),l("td",{},u===null?"":s(u)))))),h=l("table",{},l("caption",{},"What students often think"),l("thead",{},l("tr",{},["Idea","What is right"].map(p=>l(
"th",{scope:"col"},p)))),l("tbody",{},zo.map(([p,d])=>l("tr",{},l("td",{},p),l("td",{},d))))),r=l("section",{class:"sheet"},l("h3",{},"Worksheet: the hoop that \
hops"),l("p",{},"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at th\
e top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s²."),l("ol",{},Co.map(p=>l("li",{},p,l("div",{class:"answer-line"})))),l("table",{class:"sheet-\
table"},l("thead",{},l("tr",{},["v₀ [m/s]","phases","does it hop?","at which angle?"].map(p=>l("th",{scope:"col"},p)))),l("tbody",{},Oo.map(p=>l("tr",{},l("th",
{scope:"row"},s(`${ti}${Number(p)}`,p)),l("td",{}),l("td",{}),l("td",{})))))),c=l("dialog",{class:"teach","aria-label":"For teachers"},l("header",{},l("h2",{},"\
For teachers"),l("button",{type:"button",onclick:()=>print()},"Print"),l("button",{type:"button",class:"close",onclick:()=>c.close()},"Close")),l("p",{},"The vi\
sit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",l("button",{type:"button",class:"link",onclick:()=>{c.close(),
t()}},"Start the visit")),n&&l("p",{},n.map(([p,d])=>l("a",{class:"teach-page",href:new URL(p,new URL(i,document.baseURI)).href},d))),a,h,r);return c}var Ue="RSKHM",Bo=new Set(["x","angle","height"]),Do={x:"vx",angle:"omega",height:"vy"},tt=class{constructor(t){let{header:e}=t;this.scenario=e.scenario,this.query=
e.query,this.duration=e.duration,this.status=e.status,this.sequence=e.sequence,this.events=e.events,this.values=e.values,this.automatic=e.automatic,this.summary=
e.summary,this.story=e.story,this.shortened=e.shortened,this.columns=t.arrays,this.t=t.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radius"],
this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.gravity??
9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map}findPhases(){let{mode:t}=this.columns,e=[];for(let s=0;s<this.length;s++){let i=e.
at(-1);i&&i.mode===Ue[t[s]]?i.to=this.t[s]:e.push({mode:Ue[t[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<e.length;s++)e[s].to=e[s+1].from;return e.filter(
s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,vy:i,omega:n}=this.columns,a={left:1/0,right:-1/0,top:0,speed:0},h=[];for(let r=0;r<this.length;r++){
Number.isFinite(t[r])&&(a.left=Math.min(a.left,t[r]),a.right=Math.max(a.right,t[r])),e[r]>a.top&&(a.top=e[r]);let c=Math.hypot(s[r],i[r])+this.radius*Math.abs(n[r]);
Number.isFinite(c)&&h.push(c)}return h.sort((r,c)=>r-c),a.speed=h[Math.floor(.95*(h.length-1))]||1,a}index(t){let e=0,s=this.length;for(;s-e>1;){let i=e+s>>1;this.
t[i]<=t?e=i:s=i}return e}at(t){let e=b(t,0,this.duration),s=this.index(e),i=Math.min(s+1,this.length-1),n=this.t[i]-this.t[s],a=n>0?(e-this.t[s])/n:0,h={t:e,mode:Ue[this.
columns.mode[s]]};for(let[r,c]of Object.entries(this.columns)){if(r==="t"||r==="mode")continue;let p=c[s],d=c[i];if(a===0||!Number.isFinite(d))h[r]=p;else if(Bo.
has(r)){let u=this.columns[Do[r]];h[r]=Ho(p,d,u[s]*n,u[i]*n,a)}else h[r]=p+(d-p)*a}return h}derived(t,e){let s=this.cache.get(t)??e(this.columns);return this.cache.
set(t,s),s}};function Ho(o,t,e,s,i){if(!Number.isFinite(e)||!Number.isFinite(s))return o+(t-o)*i;let n=1-i;return n*n*(1+2*i)*o+i*i*(3-2*i)*t+i*n*(n*e-i*s)}var Ke=o=>o-360*Math.floor(o/360);function qo(o,t){let e=Math.abs(Ke(o-t+180)-180);return Math.round(100*b(1-(e-1)/89,0,1))}function Wo(o,t){let e=Math.max(...t)-
Math.min(...t,0),s=t.reduce((i,n,a)=>i+Math.abs(n-o[a]),0)/t.length;return Math.round(100*b(1-2*s/(e||1),0,1))}var jo=0;function $t(o,t,e=!1){let s=`hh-guess-${++jo}`,
i="",n=o.map(([a,h])=>{let r=l("input",{type:"radio",name:s,value:a,onchange:()=>{i=a,t()}});return{key:a,radio:r,row:l("label",{class:"guess-choice"},r,l("span",
{},h))}});return{element:l("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},n.map(({row:a})=>a)),made:()=>i!=="",judge:a=>{for(let{key:h,radio:r,
row:c}of n){r.disabled=!0;let p=e||h===a;p&&c.append(l("b",{class:"guess-right"},"✓")),c.classList.toggle("right",p)}return e||i===a?100:0}}}var J=168,It=58,Ye=(o,t=It)=>{
let e=o*Math.PI/180;return[J/2+t*Math.sin(e),J/2-t*Math.cos(e)]};function Xe(o,t){let e=0,s=!1,i=null,n=l("canvas",{class:"dial-canvas"}),a=l("div",{class:"gues\
s dial",role:"slider",tabindex:"0","aria-label":o,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},n),h=()=>{let{context:p}=I(n),d=getComputedStyle(
a),u=d.getPropertyValue("--ink").trim(),f=d.getPropertyValue("--soft").trim(),g=d.getPropertyValue("--accent").trim();p.clearRect(0,0,J,J),p.strokeStyle=f,p.fillStyle=
f,p.lineWidth=1.5,p.beginPath(),p.moveTo(8,J/2+It),p.lineTo(J-8,J/2+It),p.stroke(),p.lineWidth=4,p.beginPath(),p.arc(J/2,J/2,It,0,2*Math.PI),p.stroke(),p.font="\
11px system-ui, sans-serif",p.textAlign="center";for(let w of[0,90,180,270]){let[m,v]=Ye(w,It-17);p.fillText(`${w}°`,m,v+4)}let y=(w,m,v)=>{p.fillStyle=m,p.beginPath(),
p.arc(...Ye(w),v,0,2*Math.PI),p.fill()};i!==null&&(p.strokeStyle=u,p.lineWidth=2,p.beginPath(),p.arc(...Ye(i),12,0,2*Math.PI),p.stroke(),y(i,u,7)),y(e,s?g:f,9)},
r=p=>{i===null&&(e=Ke(p),s=!0,a.setAttribute("aria-valuenow",String(Math.round(e))),a.setAttribute("aria-valuetext",`${Math.round(e)}°`),h(),t())},c=p=>{let d=n.
getBoundingClientRect(),[u,f]=[p.clientX-d.left-d.width/2,p.clientY-d.top-d.height/2];r(Math.atan2(u,-f)*180/Math.PI)};return a.addEventListener("pointerdown",p=>{
p.preventDefault(),a.focus({preventScroll:!0}),c(p),R(a,p,c)}),a.addEventListener("keydown",p=>{let d={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,
PageUp:45}[p.key];d!==void 0&&(p.preventDefault(),p.stopPropagation(),r(e+(p.shiftKey?d/5:d)))}),requestAnimationFrame(h),{element:a,redraw:h,made:()=>s,judge:p=>(i=
Ke(p),h(),qo(e,i))}}var _t=9,[Y,te,it,Ge]=[34,12,12,26];function si({label:o,unit:t,most:e},s){let i=Array(_t).fill(e/4),n=!1,a=null,h=l("canvas",{class:"sketch\
-canvas"}),r=i.map((m,v)=>l("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":T("{what} with the load at {angle}",{what:T(o),angle:`${45*v}°`}),
"aria-orientation":"vertical","aria-valuemin":"0","aria-valuemax":String(e),onkeydown:k=>{let M={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[k.key];M&&(k.
preventDefault(),k.stopPropagation(),g(v,i[v]+M*e/(k.shiftKey?100:20)))}})),c=l("div",{class:"guess sketch",role:"group","aria-label":"Draw the curve: pull the \
points up and down"},h,r),p=()=>h.getBoundingClientRect(),d=m=>Y+m/(_t-1)*(p().width-Y-te),u=m=>it+(1-m/e)*(p().height-it-Ge),f=()=>{let{context:m,width:v,height:k}=I(
h),M=getComputedStyle(c),A=S=>M.getPropertyValue(S).trim();m.clearRect(0,0,v,k),m.strokeStyle=A("--line"),m.fillStyle=A("--soft"),m.font="11px system-ui, sans-s\
erif";for(let S=0;S<_t;S+=2)m.textAlign="center",m.fillText(`${45*S}°`,d(S),k-8),m.strokeRect(d(S),it,0,k-it-Ge);for(let S of[0,e/2,e])m.textAlign="right",m.fillText(
String(S),Y-6,u(S)+4),m.strokeRect(Y,u(S),v-Y-te,0);m.textAlign="left",m.fillText(t,Y+4,it+10);let E=(S,K,qi)=>{m.strokeStyle=K,m.lineWidth=2.5,m.setLineDash(qi),
m.beginPath(),S.forEach((ds,us)=>{let fs=Y+us/(S.length-1)*(v-Y-te);us?m.lineTo(fs,u(b(ds,0,e))):m.moveTo(fs,u(b(ds,0,e)))}),m.stroke(),m.setLineDash([])};E(i,A(
"--accent"),[6,4]),a&&E(a,A("--ink"),[]),r.forEach((S,K)=>{S.style.transform=`translate(${d(K)}px, ${u(i[K])}px)`})},g=(m,v)=>{a||(i[m]=b(v,0,e),n=!0,r[m].setAttribute(
"aria-valuenow",i[m].toPrecision(3)),r[m].setAttribute("aria-valuetext",`${i[m].toPrecision(2)} ${t}`),f(),s())},y=null,w=m=>{let v=p(),k=b((m.clientX-v.left-Y)/
(v.width-Y-te),0,1),M=Math.round(k*(_t-1)),A=e*(1-(m.clientY-v.top-it)/(v.height-it-Ge)),E=y??M,S=i[E];for(let K=Math.min(E,M);K<=Math.max(E,M);K++)g(K,E===M?A:
S+(A-S)*(K-E)/(M-E));y=M};c.addEventListener("pointerdown",m=>{m.preventDefault(),y=null,w(m),R(c,m,w)});for(let[m,v]of r.entries())v.setAttribute("aria-valueno\
w",i[m].toPrecision(3));return requestAnimationFrame(f),{element:c,redraw:f,made:()=>n,judge:m=>{a=m,f();let v=(m.length-1)/(_t-1);return Wo(i,i.map((k,M)=>m[Math.
round(M*v)]))}}}var se=2*Math.PI,O=(o,t)=>o.events.find(e=>e.kind===t),ee=o=>P(o-se*Math.floor(o/se));function Uo(o,t,e=72){let{angle:s}=o.columns,i=o.columns[t],n=[],a=0;for(let h=0;h<=
e;h++){let r=o.columns.angle[0]+se*h/e;for(;a+1<o.length&&s[a+1]<r;)a+=1;let c=Math.min(a+1,o.length-1),p=s[c]>s[a]?Math.min((r-s[a])/(s[c]-s[a]),1):0;n.push(i[a]+
p*(i[c]-i[a]))}return n}var Yo=(o,t)=>o.t[o.columns.angle.findIndex(e=>e>=t)]??o.duration,Go={R:"roll",S:"spin",K:"skid",H:"bounce"},ot=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:o=>$t(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],o),until:([o])=>{
let[t,e]=[O(o,"skim"),O(o,"impact")];return t?t.t+.7*((e?.t??o.duration)-t.t):o.duration},answer:([o])=>{let t=O(o,"skim")??O(o,"takeoff");return{truth:t?.kind===
"skim"?"skim":t?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:ee(t?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:o=>si({label:"Speed of the centre",unit:"m/s",most:10},
o),until:([o])=>Yo(o,se),answer:([o])=>{let t=Uo(o,"vx");return{truth:t,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:x(Math.max(
...t),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:o=>Xe("Angle of the load where it begins to slip",o),until:([o])=>(O(o,"slip_start")?.t??0)+.02,answer:([o])=>{let t=O(o,"slip_start"),e=o.at(t.t).normal_force/
(o.mass*o.gravity);return{truth:t.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:ee(t.
angle),share:`${x(100*e,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:o=>Xe("Angle of the load\
 where it takes off",o),until:([o])=>(O(o,"takeoff")?.t??0)+.12,answer:([o])=>{let t=O(o,"takeoff"),e=o.at(t.t-1e-6);return{truth:t.angle*180/Math.PI,text:"It t\
akes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:ee(t.angle),slip:x(Math.abs(e.slip),3)}}},why:"A rolling hoop would be braked by the plan\
e while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the \
top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does it d\
o just after it has landed?",queries:[""],guess:o=>$t([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim turns \
too fast."],["bounce","It bounces."]],o),until:([o])=>(O(o,"impact")?.t??o.duration)+.15,answer:([o])=>{let[t,e]=[O(o,"takeoff"),O(o,"impact")],s=o.events.find(
i=>i.kind==="apex");return{truth:Go[o.at((e?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
values:{time:x((e?.t??0)-(t?.t??0),3),height:x(100*(s?.height??0),3),angle:ee(e?.angle??0)}}},why:"An impact takes no time, but its friction is as strong as its\
 push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",title:"\
More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highest?",queries:[
"plane.mu=0.05","plane.mu=0.2",""],guess:o=>$t([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],o),until:o=>.3+Math.max(0,...o.map(t=>O(t,"impact")?.t??0)),
answer:o=>{let t=o.map(n=>Math.max(0,...n.events.map(({kind:a,height:h})=>a==="apex"?h:0))),[e,s,i]=t.map(n=>x(100*n,3));return{truth:String(t.indexOf(Math.max(
...t))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:e,middle:s,high:i}}},why:"On ice nothing drives the ro\
tation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the\
 way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies w\
ith dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plan\
e.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:o=>$t([["flight","It flies off."],["impact","An impact stops the sli\
de at once."],["both","Both agree with the laws."]],o),until:o=>Math.min(.8,...o.map(t=>t.duration)),answer:o=>({truth:o.every(t=>O(t,"painleve_indeterminate"))?
"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws have two an\
swers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"Your tur\
n",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from\
 the motion itself.",question:"",queries:[""]}];var ii="hophoop-visit",ie=class{step=null;guess=null;films=[];points=new Map;play;next;stop=null;loop=null;asked=0;constructor(t,e){this.lab=t,this.onchallenges=
e,this.body=l("div",{class:"visit-body"}),this.said=l("div",{class:"visit-answer",role:"status"}),this.element=l("section",{class:"visit card","aria-label":"Gui\
ded visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){lt(ii)||(this.element.hidden=!1,j(this.said,""),this.
body.replaceChildren(l("div",{class:"buttons offer"},l("p",{},l("b",{},"New here?")," ","Eight short questions: guess, then play."),l("button",{type:"button",class:"\
main",onclick:()=>this.start()},"Start the visit"),l("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){this.points.clear(),this.go(0)}leave(){
ct(ii,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.root.classList.remove("visiting"),this.veil(),this.
lab.show()}async go(t){let e=ot[t],s=++this.asked,{lab:i}=this;i.clock.play(!1),i.clock.time=0,this.step=e,this.stop=null,this.guess=null,this.unwind(),j(this.said,
""),this.element.hidden=!1,i.root.classList.toggle("visiting",t<ot.length-1);try{let n=await Promise.all(e.queries.map(a=>i.backend.call("film",{query:a})));if(s!==
this.asked)return;this.films=n.map(a=>new tt(a)),i.motions.active=0,i.motions.set(n.slice(0,2)),this.guess=e.guess?.(()=>this.guessed())??null,this.veil(),i.changed(),
i.motions.note(),this.fill(t)}catch(n){i.notice.fail(n)}}veil(){this.lab.root.classList.toggle("guessing",this.guessing),this.guessing&&this.lab.stage.element.setAttribute(
"aria-label",T("The hoop, before it is let go."))}fill(t){let e=ot[t];this.play=l("button",{type:"button",class:"main",disabled:!!this.guess,onclick:()=>this.show()},
"Play");let s=t===ot.length-1,i=l("h2",{tabindex:"-1"},e.title);this.next=l("button",{type:"button",onclick:()=>this.go(t+1)},"Next"),this.body.replaceChildren(
l("header",{},l("span",{class:"visit-count"},`Step ${t+1} of ${ot.length}`),l("progress",{max:String(ot.length),value:String(t+1),"aria-hidden":"true"}),l("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),i,l("p",{},e.text),e.question?l("p",{class:"visit-question"},e.
question):"",this.guess?.element??"",l("div",{class:"buttons"},t>0&&l("button",{type:"button",onclick:()=>this.go(t-1)},"Back"),this.guess&&this.play,s?l("butto\
n",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,s&&l("button",{type:"button",onclick:()=>this.leave()},"Done"),this.guess&&
l("span",{class:"hint visit-wait"},"First say what you expect, then play."))),s&&this.points.size&&this.total(),i.focus({preventScroll:!0})}guessed(){this.play&&
(this.play.disabled=!1);let t=this.body.querySelector(".visit-wait");t&&(t.hidden=!0)}show(){let{lab:t,step:e}=this;!e||!this.guess||(this.play.disabled=!0,this.
stop=e.until?.(t.films())??t.clock.duration,this.loop??=t.clock.loop,t.clock.loop=!1,t.clock.seek(0),matchMedia("(prefers-reduced-motion: reduce)").matches?t.clock.
seek(this.stop):t.clock.play(!0),this.frame())}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:t}=this.lab;if(this.stop===
null||t.playing&&t.time<this.stop||!(t.time>=this.stop-1e-9||!t.playing))return;t.playing=!1;let s=this.stop;this.stop=null,this.unwind(),t.seek(s),this.judge()}judge(){
let{step:t,guess:e}=this;if(!t?.answer||!e)return;let{truth:s,text:i,values:n={}}=t.answer(this.films),a=e.judge(s);this.points.set(t.key,a),this.said.replaceChildren(
l("p",{},l("b",{},T("{points} of 100 points.",{points:a}))," ",T(i,n)),l("p",{},t.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.
scrollIntoView({block:"nearest"})}total(){let t=[...this.points.values()].reduce((e,s)=>e+s,0);this.said.replaceChildren(l("p",{},T("You have {sum} of {most} po\
ints.",{sum:t,most:100*this.points.size})))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&this.veil()}};var oe=class{constructor(t){this.lab=t,this.grips=new Vt(t),this.sound=new Zt,this.present=new Jt(t),this.challenges=new Gt(t),this.visit=new ie(t,()=>this.challenges.
open()),this.table=new Qt(t),this.teach=ei(e=>this.challenges.load(e),()=>this.visit.start()),this.layOut(),this.spoken()}layOut(){let{lab:t}=this,e=t.stage.element.
parentElement,s=t.root.querySelector(".side");s?s.prepend(this.visit.element,this.challenges.element):e.before(this.visit.element,this.challenges.element),e.after(
this.table.element),t.root.append(this.teach),t.transport.element.querySelector(".switches")?.before(this.tools()),t.header.element.querySelector(".right")?.prepend(
this.menu(),this.languages()),t.hosted&&!location.search&&!location.hash&&this.visit.offer()}tools(){let{clock:t}=this.lab,e=(s,i,n)=>l("button",{type:"button",
title:i,"aria-label":i,"aria-pressed":"false",onclick:n},L(s));return this.loop=e("loop","Repeat",()=>{t.loop=!t.loop,this.mark()}),this.slow=e("slow","Slow mot\
ion: a tenth of the speed",()=>{t.speed=t.speed===.1?1:.1,t.changed(),this.mark()}),this.loud=e("sound","Sound of the contact",()=>{this.sound.turn(!this.sound.
on),this.mark()}),this.large=e("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),this.mark(),l("div",{class:"\
buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:t}=this.lab;this.loop?.setAttribute("aria-pressed",String(t.loop)),this.slow?.setAttribute(
"aria-pressed",String(t.speed===.1)),this.loud?.setAttribute("aria-pressed",String(this.sound.on)),this.large?.setAttribute("aria-pressed",String(this.present.on))}menu(){
let t=(s,i)=>l("button",{type:"button",onclick:()=>{e.open=!1,i()}},s),e=l("details",{class:"menu learn"},l("summary",{class:"button"},"Learn"),l("div",{class:"\
menu-body"},t("Guided visit",()=>this.visit.start()),t("Challenges",()=>this.challenges.open()),t("Table of the motion",()=>this.table.open(!0)),t("Presentation",
()=>this.present.turn(!0)),t("For teachers",()=>this.teach.showModal())));return this.lab.root.addEventListener("pointerdown",s=>{e.contains(s.target)||(e.open=
!1)}),e.addEventListener("keydown",s=>{s.key!=="Escape"||!e.open||(s.stopPropagation(),e.open=!1,e.querySelector("summary")?.focus())}),e}languages(){let t=l("s\
elect",{class:"language","aria-label":"Language",onchange:()=>{Ts(t.value),Le(t.value),this.spoken(),_s(this.lab.root),this.lab.show()}},Object.entries(xt).map(
([e,s])=>l("option",{value:e,lang:e},s)));return t.value=zt(),t}spoken(){this.lab.root.lang=zt(),this.lab.hosted&&(document.documentElement.lang=zt())}frame(){let{
lab:t}=this;this.grips.draw(),this.sound.follow(t.film(),t.clock),this.table.cursor(t.clock.time),this.visit.frame(),this.mark()}changed(){this.grips.draw(),this.
table.draw(this.lab.film()),this.challenges.changed(),this.visit.changed()}close(){this.sound.close(),this.present.close()}};var Rt=(o,t,e)=>l("button",{type:"button",title:t,"aria-label":t,onclick:e},o),ne=class{constructor(t,e,s){let i=new Map;for(let a of t)i.set(a.group,[...i.get(
a.group)??[],a]);this.fresh=!1,this.presets=l("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let a=t.find(({key:h})=>h===this.presets.
value);this.fresh=a!==void 0,a&&s.take(a)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},l("option",{value:""},"Motions to start from …"),[...i].
map(([a,h])=>l("optgroup",{label:a},h.map(({key:r,title:c})=>l("option",{value:r},c))))),this.undo=Rt(L("undo"),"Undo (z)",s.undo),this.redo=Rt(L("redo"),"Redo \
(y)",s.redo);let n=l("span",{},l("span",{class:"long"},"Compare"),l("span",{class:"short"},L("two")));this.compare=Rt(n,"Compare two hoops",s.compare),this.element=
l("header",{class:"top"},l("h1",{},l("span",{class:"logo","aria-hidden":"true"}),l("span",{},"hophoop",l("span",{class:"long"}," lab"))),this.presets,l("div",{class:"\
buttons"},this.undo,this.redo,this.compare),l("div",{class:"buttons right"},e,Rt(L("theme"),"Dark or light (d)",s.theme),Rt("?","Keys and help (?)",s.help)))}show(t,e){
this.undo.disabled=!t.past.length,this.redo.disabled=!t.future.length,this.compare.setAttribute("aria-pressed",String(e))}};var Ko=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["Esc","leave a field, a menu, a picture \
that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],Xo=[["R","roll","the rim does not slide"],["S","spin","slip: the rim tur\
ns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],["H","\
flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],Vo=[["▲ ▼","take-off, landing"],["•","highest point"],
["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy out of nothing"],["≋","bounces without numbe\
r end"],["◗ ■","skimming begins, rest"]],Ve=(o,t,e=()=>!1)=>l("table",{},l("caption",{},o),t.map(([s,...i])=>l("tr",{},l("th",{scope:"row"},e(s),s),i.map(n=>l(
"td",{},n)))));function oi(o,t,e){let s=l("dialog",{class:"help","aria-label":"Keys and help"},l("h2",{},"The hoop"),l("p",{},"A ring with a load on its rim rol\
ls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide\
. Move a slider and see."),Ve("Modes",Xo,i=>l("i",{class:"dot",style:`background:${t.modes[i]}`})),Ve("Marks on the bar of time",Vo),Ve("Keys",Ko),e,l("p",{class:"\
hint"},`hophoop ${o}`),l("button",{type:"button",class:"close",onclick:()=>s.close()},"Close"));return s}var ae=class{constructor(t){this.tabs=["A","B"].map((e,s)=>l("button",{type:"button","aria-pressed":"false",onclick:()=>t(s)},`Hoop ${e}`)),this.bar=l("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=l("p",{class:"preset-text"}),this.element=l("div",{class:"lanes"},
this.bar,this.text)}show(t,e){this.bar.hidden=t<2;for(let[s,i]of this.tabs.entries())i.setAttribute("aria-pressed",String(s===e))}};var ni="hophoop-theme",Jo=["gravity_center","airborne","normal_force","friction_force"],re=class{constructor(t,e,s,i){this.root=t,this.colors=e,this.hosted=s,this.
changed=i,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=ze(t),this.inks={...e},this.read()}mark(){let t=this.hosted?Je(ni):null;this.root.dataset.theme=this.chosen??t??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=ze(this.root),this.inks={...this.colors};for(let t of Jo)
this.inks[t]=Ot(this.colors[t],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&Ze(ni,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};function Je(o){try{return localStorage.getItem(o)}catch{
return null}}function Ze(o,t){try{localStorage.setItem(o,t)}catch{}}var ai="hophoop-single-keys",Zo=(o,t)=>({" ":()=>o.clock.play(),ArrowLeft:()=>t?o.transport.jump(-1):o.transport.nudge(-1),ArrowRight:()=>t?o.transport.jump(1):
o.transport.nudge(1),Home:()=>o.clock.seek(0),End:()=>o.clock.seek(o.clock.duration),h:()=>o.transport.jump(1,"takeoff"),l:()=>o.transport.jump(1,"impact"),"[":()=>o.
clock.faster(-1),"]":()=>o.clock.faster(1),t:()=>o.toggle("traces"),f:()=>o.toggle("forces"),c:()=>o.toggle("speed"),w:()=>o.toggle("whole"),3:()=>o.toggle("thr\
ee"),"+":()=>o.stage.zoom(1.25),"=":()=>o.stage.zoom(1.25),"-":()=>o.stage.zoom(.8),0:()=>o.stage.zoom(0),z:()=>o.travel(-1),y:()=>o.travel(1),d:()=>o.theme.toggle(),
p:()=>o.share.code(),"?":()=>o.help.showModal()});function Qo(o,t){let e=t.key.toLowerCase();t.altKey||!(e==="z"||e==="y")||(t.preventDefault(),o.travel(e==="y"||
t.shiftKey?1:-1))}function tn(o){let t=o.share.menu;t.open&&(t.open=!1,t.querySelector("summary")?.focus())}var he=class{constructor(t){this.on=!t||Je(ai)!=="of\
f";let e=l("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=e.checked,t&&Ze(ai,this.on?"on":"off")}});this.element=l("label",{class:"check"},e,"Si\
ngle keys (letters, digits, signs) do what the table says")}};function en(o,t){let e=t.target;if(o.root.querySelector("dialog[open]"))return;if(t.key==="Escape"){
tn(o);return}if(e.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(t.ctrlKey||t.metaKey){Qo(o,t);return}if(t.altKey||e.matches?.("selec\
t")&&!(t.key===" "&&o.header.fresh)||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary, input[ty\
pe=checkbox]")||!o.singleKeys.on&&t.key!==" "&&t.key.length===1)return;let i=Zo(o,t.shiftKey)[t.key];i&&(t.preventDefault(),i())}function ri(o,t){let e=t?document:
o.root,s=i=>{en(o,i),t||i.stopPropagation()};return e.addEventListener("keydown",s),()=>e.removeEventListener("keydown",s)}var[hi,sn]=[62,92],on=12,nt=10,nn=36,li=Math.PI/180,G=["x","y"],le=class{box;constructor(t){this.known=new Map(t.map(e=>[e.path,e])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=hi}info(t){return this.known.get(this.paths[t])}whole(t){return[...this.info(t).range]}home(){
for(let t of G)this.windows[t]=this.whole(t)}choose(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t]),this.paths[t]=e,this.home()}asked(t,e){
let[s,i]=this.windows[t];return{path:this.paths[t],from:s,to:i,cells:e}}bounds(t){let{range:e,allowed:s}=this.info(t),i=2*(e[1]-e[0]);return[Math.max(s[0],e[0]-
i),Math.min(s[1],e[1]+i)]}zoom(t,e){let s={x:[],y:[]};for(let i of G){let[n,a]=this.windows[i],h=e?.[i]??.5*(n+a);s[i]=at([h-(h-n)*t,h+(a-h)*t],this.bounds(i));
let r=Math.max(Math.abs(s[i][0]),Math.abs(s[i][1]),1e-9);if(s[i][1]-s[i][0]<400*Number.EPSILON*r)return!1}return G.every(i=>s[i].every((n,a)=>n===this.windows[i][a]))?
!1:(this.windows=s,!0)}drag(t,e,s){let i=(n,a)=>at(t[n].map(h=>h+a*(t[n][1]-t[n][0])),this.bounds(n));this.windows={x:i("x",-e/this.box.width),y:i("y",s/this.box.
height)}}restore(t){if(!G.every(e=>this.known.has(t[e][0]))||t.x[0]===t.y[0])return!1;for(let e of G)this.paths[e]=t[e][0];for(let e of G)this.windows[e]=at(t[e].
slice(1).map(Number),this.bounds(e));return!0}isHome(){return G.every(t=>this.windows[t].every((e,s)=>e===this.whole(t)[s]))}middle(){let{x:t,y:e}=this.windows;
return{x:.5*(t[0]+t[1]),y:.5*(e[0]+e[1])}}fit(t,e){this.left=this.deep("y")?sn:hi,this.box={width:t-this.left-on,height:e-nt-nn}}clip(t){t.beginPath(),t.rect(this.
left,nt,this.box.width,this.box.height),t.clip()}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-e)*this.box.width}y(t){let[e,s]=this.windows.y;return nt+
(1-(t-e)/(s-e))*this.box.height}place(t,e){let s=([i,n],a)=>i+b(a,0,1)*(n-i);return{x:s(this.windows.x,(t-this.left)/this.box.width),y:s(this.windows.y,1-(e-nt)/
this.box.height)}}deep(t){let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.abs(e),Math.abs(s))}said(t){let e=s=>{let i=this.info(s),[n,a]=this.windows[s],
h=Math.max(Math.abs(n),Math.abs(a)),r=b(Math.ceil(Math.log10(h/(a-n)))+4,4,16);return`${i.label} = ${$(x(i.degrees?t[s]/li:t[s],r),i.unit)}`};return`${e("x")}, ${e(
"y")}`}draw(t,e,s){t.strokeStyle=s.soft,t.fillStyle=s.soft,t.lineWidth=1,t.strokeRect(this.left+.5,nt+.5,this.box.width-1,this.box.height-1),t.font=`11px ${s.font}`;
for(let i of G){let n=this.info(i),a=n.degrees?1/li:1,[h,r]=this.windows[i].map(w=>w*a),c=i==="x"?this.box.width/80:this.box.height/40,p=z(r-h,c),d=this.deep(i),
u=d?Number((.5*(h+r)).toPrecision(12)):0,f=d?q(h-u,r-u,c).map(w=>w+u):q(h,r,c);for(let w of f){let m=d?x(w-u,3):B(w,p);i==="x"?(t.textAlign="center",t.fillText(
m,this.x(w/a),nt+this.box.height+14)):(t.textAlign="right",t.textBaseline="middle",t.fillText(m,this.left-5,this.y(w/a)),t.textBaseline="alphabetic")}let g=d?` \
− ${String(u).replace("-","−")}`:"",y=`${n.label}${g}${n.unit?` [${n.unit}]`:""}`;t.save(),t.textAlign="center",i==="x"?t.translate(this.left+.5*this.box.width,
e-5):(t.translate(12,nt+.5*this.box.height),t.rotate(-Math.PI/2)),t.fillText(y,0,0),t.restore()}}};function at([o,t],[e,s]){let i=Math.min(t-o,s-e);return o<e?[
e,e+i]:t>s?[s-i,s]:[o,t]}function Qe(o,t,e,s,i){for(let[n,a]of[[i,4],[s,1.8]])o.strokeStyle=n,o.lineWidth=a,o.beginPath(),o.arc(t,e,7,0,2*Math.PI),o.moveTo(t-13,
e),o.lineTo(t-4,e),o.moveTo(t+4,e),o.lineTo(t+13,e),o.moveTo(t,e-13),o.lineTo(t,e-4),o.moveTo(t,e+4),o.lineTo(t,e+13),o.stroke()}var gt=o=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${o&&`; ${o}`}; double-click for all`,an=.0018,ci=200,
[rn,hn]=[1/.6,1/1.7];function D(o,{zoom:t,home:e,chosen:s=()=>o,keys:i=!1}){return o.addEventListener("wheel",n=>{(n.ctrlKey||n.metaKey||Bt(s()))&&(n.preventDefault(),
t(Math.exp(-Math.min(Math.max(n.deltaY,-ci),ci)*an),n))},{passive:!1}),o.addEventListener("dblclick",e),i&&o.addEventListener("keydown",n=>{if(n.key==="+"||n.key===
"=")t(rn);else if(n.key==="-")t(hn);else if(n.key==="0")e();else if(n.key==="Escape")o.blur();else return;n.preventDefault(),n.stopPropagation()}),Gs(o,t)}var pi={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},di=48;function ui(o){let{body:t}=o,e=!1,s=D(t,{zoom:(i,n)=>o.axes.box&&o.zoom(1/i,n?ts(
o,n):o.pointed??void 0),home:()=>o.home(),keys:!0});t.addEventListener("pointerdown",i=>cn(o,i,s,n=>e=n)),t.addEventListener("pointermove",i=>{o.axes.box&&!e&&i.
pointerType!=="touch"&&ln(o,i)}),t.addEventListener("pointerleave",()=>o.tip.hidden=!0),t.addEventListener("keydown",i=>pn(o,i))}function ts(o,t){let e=o.body.getBoundingClientRect();
return o.axes.place(t.clientX-e.left,t.clientY-e.top)}function ln(o,t){o.tip.textContent=o.said(ts(o,t)),o.tip.hidden=!1;let e=o.body.getBoundingClientRect();o.
tip.style.left=`${b(t.clientX-e.left,150,Math.max(e.width-150,150))}px`,o.tip.style.bottom=`${e.bottom-t.clientY+16}px`}function cn(o,t,e,s){t.preventDefault(),
o.body.focus({preventScroll:!0});let i=[t.clientX,t.clientY],n={x:[...o.axes.windows.x],y:[...o.axes.windows.y]};o.pointed=ts(o,t);let a=!1,h=e(),r=c=>{if(h||=e(),
h)return;let[p,d]=[c.clientX-i[0],c.clientY-i[1]];Math.hypot(p,d)<5&&!a||(a=!0,s(!0),o.tip.hidden=!0,o.axes.drag(n,p,d),o.redraw(),o.soon())};R(o.body,t,r,(c,p)=>{
p&&!a&&!h&&o.pointed&&o.take(o.pointed),s(!1)})}function pn(o,t){let e=o.pointed??o.here()??o.axes.middle();if(o.pointed=e,pi[t.key]){let[s,i]=pi[t.key],{x:n,y:a}=o.
axes.windows;o.pointed={x:b(e.x+s*(n[1]-n[0])/di,n[0],n[1]),y:b(e.y+i*(a[1]-a[0])/di,a[0],a[1])},o.state.textContent=o.said(o.pointed),o.say(o.said(o.pointed))}else if(t.
key==="Enter")o.take(e);else return;t.preventDefault(),t.stopPropagation(),o.redraw()}var dn=["start.height","start.vx","start.vy","start.omega"];function fi(o,t){let e="speed"in o.start;return!e&&t.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":e&&t.some(s=>dn.includes(s))?"of starts in any state, though this motion starts rolling":""}var un=Math.PI/180,fn=12,mn=["hop_height","flight_time","energy_lost","greatest_utilization"];function mi(o){return o.unit==="rad"?[1/un,"°"]:[1,o.unit==="1"?"":
o.unit]}function gn({classes:o,what:t},e){let[s,i]=[1/0,-1/0];if(o)return[s,i];for(let n of e)n<s&&(s=n),n>i&&(i=n);return[mn.includes(t)?Math.min(s,0):s,i]}function gi(o){
let{values:t}=o.arrays,e=o.header,{x:s,y:i,classes:n}=e,a=new ImageData(s.cells,i.cells),[h,r]=gn(e,t),c=n?.map(({color:d})=>X(d));for(let d=0;d<i.cells;d++)for(let u=0;u<
s.cells;u++){let f=t[d*s.cells+u],g=4*((i.cells-1-d)*s.cells+u);if(!Number.isFinite(f))continue;let y=c&&(u+1<s.cells&&t[d*s.cells+u+1]!==f||d+1<i.cells&&t[(d+1)*
s.cells+u]!==f),w=c?c[f].map(m=>y?.72*m:m):dt[b(Math.round(255*(f-h)/(r-h||1)),0,255)];a.data.set([...w,255],g)}let p=l("canvas",{width:s.cells,height:i.cells});
return V(p).putImageData(a,0,0),{picture:p,header:e,values:t,x:[s.from,s.to],y:[i.from,i.to],low:h,high:r}}function wi(o,t){let e=(i,n)=>i[0]>=n[0]-1e-300&&i[1]<=
n[1]+1e-300;return[...o.filter(i=>!(e(i.x,t.x)&&e(i.y,t.y))),t].slice(-fn)}function yi({header:o,low:t,high:e,values:s}){let{classes:i}=o;if(!i){let h=l("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),r=V(h);for(let d=0;d<120;d++)r.fillStyle=`rgb(${dt[Math.floor(255*d/119)].join(",")})`,r.fillRect(d,0,1,10);
let[c,p]=mi(o);return[l("span",{},`${o.label}: ${e>=t?x(t*c,3):"none"} `),h,l("span",{},e>=t?$(x(e*c,3),p):""),s.some(d=>!Number.isFinite(d))?l("span",{},l("i",
{class:"blank"}),"none"):""]}let n=new Map;for(let h of s)n.set(h,(n.get(h)??0)+1);let a=[...n].filter(([h])=>h>=0).sort((h,r)=>r[1]-h[1]);return[...a.slice(0,10).
map(([h])=>{let{color:r,text:c}=i[h];return l("span",{},l("i",{style:`background:${r}`,"aria-hidden":"true"}),c)}),a.length>10?l("span",{},`and ${a.length-10} m\
ore`):""]}function bi(o,t){for(let{header:e,values:s}of[...o].reverse()){let{x:i,y:n,classes:a}=e,h=Math.floor((t.x-i.from)/(i.to-i.from)*i.cells),r=Math.floor(
(t.y-n.from)/(n.to-n.from)*n.cells);if(h<0||r<0||h>=i.cells||r>=n.cells)continue;let c=s[r*i.cells+h];if(a)return a[c]?.text??"not allowed";let[p,d]=mi(e);return Number.
isFinite(c)?$(x(c*p,4),d):"none"}return"…"}var vi=[[24,16],[72,48],[216,144]],ce=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(t,e,{take:s,say:i,changed:n}){this.backend=
t,this.onmotion=s,this.say=i,this.changed=n;let a=e.controls.map_axes;this.axes=new le(a),this.what="sequence",this.layers=[],this.canvas=l("canvas",{class:"plo\
t-canvas"}),this.tip=l("div",{class:"tip",hidden:!0}),this.body=l("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow ke\
ys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=l("div",{class:"map-keys"}),this.state=l("span",{class:"hint"});
let h=r=>{let c=l("select",{"data-axis":r,onchange:()=>this.setAxis(r,c.value)},a.map(({path:p,label:d})=>l("option",{value:p},d)));return c};this.selects={x:h(
"x"),y:h("y")},this.quantity=l("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},e.map_quantities.map(([r,
c])=>l("option",{value:r},c))),this.element=l("section",{class:"map","aria-label":"Map of motions"},l("div",{class:"map-head"},l("h2",{},"Map"),l("label",{},"of",
this.quantity),l("label",{},"Across",this.selects.x),l("label",{},"Up",this.selects.y),l("span",{class:"buttons"},l("button",{type:"button","aria-label":"Zoom i\
nto the map",onclick:()=>this.zoom(.5)},"+"),l("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),l("button",{type:"but\
ton",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,l("p",{class:"hint"},`Click to take that motion into the player; ${gt("drag to move")}\
.`)),ui(this),this.soon=U(()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([r])=>{this.seen=r.isIntersecting,this.seen&&this.stale&&this.
refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let t of G)this.selects[t].value=
this.axes.paths[t]}setAxis(t,e){this.axes.choose(t,e),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(t){let e=structuredClone(t);
for(let s of Object.values(this.axes.paths)){let[i,n]=s.split(".");e[i]&&delete e[i][n]}return JSON.stringify(e)}mark(t,e){this.film=t,this.look=e;let s=this.key_of(
t.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){let{paths:t,windows:e}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&
t.x==="start.speed"&&t.y==="plane.mu")return;let s=i=>[t[i],...e[i]];return{what:this.what,x:s("x"),y:s("y")}}restore(t){![...this.quantity.options].some(({value:e})=>e===
t.what)||!this.axes.restore(t)||(this.quantity.value=this.what=t.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let i=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;i!==this.kind&&(this.layers=[]),this.
kind=i,this.redraw();try{for(let[n,a]of vi){this.state.textContent=`computing ${n*a} motions …`;let h={x:this.axes.asked("x",n),y:this.axes.asked("y",a)},r={scenario:e,
changes:s,...h,what:this.what},c=await zs(()=>this.backend.call("map",r,t),u=>{this.state.textContent=u},t),p=gi(c);this.layers=wi(this.layers,p),this.keys.replaceChildren(
...yi(p));let d=fi(e,Object.values(this.axes.paths));this.state.textContent=`${n*a} motions${s.length?", with rigid contact":""}${d&&`; ${d}`}`,this.redraw()}this.
level=vi.length}catch(n){let{name:a,message:h}=n;if(a==="AbortError")return;this.state.textContent=h}this.computing=!1}redraw(){if(!this.film)return;let{look:t}=this,
{context:e,width:s,height:i}=I(this.canvas);this.axes.fit(s,i),e.clearRect(0,0,s,i),e.save(),this.axes.clip(e),e.imageSmoothingEnabled=!1;let{axes:n}=this;for(let h of this.
layers){let[r,c]=h.x.map(u=>n.x(u)),[p,d]=h.y.map(u=>n.y(u));e.drawImage(h.picture,r,d,c-r,p-d)}let a=this.here();a&&Qe(e,n.x(a.x),n.y(a.y),t.ink,t.paper),this.
pointed&&Bt(this.body)&&Qe(e,n.x(this.pointed.x),n.y(this.pointed.y),"#D55E00",t.paper),e.restore(),n.draw(e,i,t)}here(){let t=s=>{let[i,n]=s.split(".");return this.
film.values[s]??this.film.scenario[i]?.[n]},e={x:t(this.axes.paths.x),y:t(this.axes.paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}said(t){return`${this.
axes.said(t)}: ${bi(this.layers,t)}`}take(t){this.onmotion([[this.axes.paths.x,t.x],[this.axes.paths.y,t.y]])}zoom(t,e){this.tip.hidden=!0,this.axes.zoom(t,e)&&
(this.redraw(),this.soon())}};var pe=class{constructor(){this.past=[],this.future=[],this.now=null,this.what="",this.when=-1/0}note(t,e="",s=performance.now()){let i=this.now;if(this.now=t,i===
null||es(i,t))return"same";let n=e!==""&&e===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=e,this.when=s,this.future=[],n?"again":(this.past.push(
i),this.past.length>500&&this.past.shift(),"step")}next(t){return(t<0?this.past:this.future).at(-1)??null}step(t){let[e,s]=t<0?[this.past,this.future]:[this.future,
this.past],i=e.pop();!i||!this.now||(s.push(this.now),this.now=i,this.what="")}arrive(t){if(!(this.now&&es(this.now,t))){for(let e of[-1,1]){let s=e<0?this.past:
this.future,i=s.length-s.findLastIndex(n=>es(n,t));if(!(i>s.length)){for(let n=0;n<i;n++)this.step(e);return}}Object.assign(this,{past:[],future:[],now:t,what:""})}}},
es=(o,t)=>JSON.stringify(o)===JSON.stringify(t);var de=class{constructor(t,e){this.backend=t,this.listener=e,this.history=new pe,this.lanes=[],this.active=0,this.going=Promise.resolve()}film(t=this.active){return this.
lanes[t].film}films(){return this.lanes.map(t=>t.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([t])=>t))}name(){return this.lanes.length>
1?"AB"[this.active]:""}set(t){this.lanes=t.map(e=>({film:new tt(e)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(t){this.set(await Promise.
all(t.map(e=>this.backend.call("film",{query:e}))))}change(t,e){let s=this.lanes[this.active];s.since??=performance.now(),s.pending=[...(s.pending??[]).filter(([
i])=>!t.some(([n])=>n===i)),...t],s.commit||=e,s.what=t.map(([i])=>i).join(),this.pump(s)}async pump(t){if(t.busy||!this.lanes.includes(t))return;if(!t.pending){
t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{t.film=new tt(await this.backend.call("film",{scenario:t.film.
scenario,changes:e})),this.lanes.includes(t)&&this.listener.shown(s)}catch(i){this.lanes.includes(t)&&this.listener.failed(i,e)}finally{t.busy=!1}this.pump(t)}settle(t){
t.commit=!1,this.note(t.what),this.listener.settled()}queries(){return this.films().map(t=>t.query)}note(t){this.listener.noted(this.history.note(this.queries(),
t))}replace(t){this.lanes[this.active]={film:new tt(t)},this.listener.shown(),this.note()}travel(t){return this.inTurn(async()=>{let e=this.history.next(t);e&&(await this.
load(e),this.history.step(t),await this.listener.travelled(t),this.listener.shown(),this.listener.noted("travelled"))})}arrive(t){return this.inTurn(async()=>{await this.
load(t),this.history.arrive(t),this.listener.shown(),this.listener.noted("travelled")})}inTurn(t){return this.going=this.going.then(t).then(()=>!0,e=>(this.listener.
failed(e),!1)),this.going}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=
0),this.listener.shown(),this.note()}choose(t){this.active=t,this.listener.shown(),this.listener.noted("same")}link(t=""){let s=[this.lanes.length>1?`with=${encodeURIComponent(
this.film(1).query)}`:"",t].filter(Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};var wn=6e3,ue=class{constructor(){this.message=l("p",{class:"message",role:"alert",hidden:!0}),this.toast=l("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(t){this.message.textContent=t.message,this.message.hidden=!1,this.seen()||this.say(t.message,this.message.isConnected)}seen(){let{top:t,bottom:e,height:s}=this.
message.getBoundingClientRect();return this.message.isConnected&&s>0&&t>=0&&e<=innerHeight}clear(){this.message.hidden=!0}say(t,e=!1){this.toast.setAttribute("r\
ole",e?"presentation":"status"),this.toast.textContent=t,this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},wn)}};var H=52,ss=10,F=8,yn=30,bn={solid:[],dash:[6,4],dot:[2,3]},wt=class{films;active;look;box;range;heights;picked;named;values;constructor({key:t,title:e,unit:s,curves:i,
limits:n,symmetric:a=!1},h){this.key=t,this.title=e,this.unit=s,this.curves=i,this.limits=n,this.symmetric=a,this.shared=h,this.canvas=l("canvas",{class:"plot-c\
anvas"}),this.over=l("canvas",{class:"plot-canvas plot-over"}),this.keys=l("div",{class:"plot-keys"}),this.body=l("div",{class:"plot-body",tabindex:"0",role:"im\
g","aria-label":e},this.canvas,this.over),this.element=l("section",{class:"plot","data-plot":t},l("header",{},l("h3",{},e),this.keys),this.body),this.body.addEventListener(
"pointerdown",r=>this.press(r)),this.pinched=D(this.body,{zoom:(r,c)=>this.films&&this.zoomAbout(c?this.valueAt(c):this.middle(),1/r),home:()=>this.zoomTo(null),
keys:!0}),this.onseek=()=>{}}abscissa(t){return N[this.shared.axis].values(t)}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.
duration),1e-9)];let[t,e]=[1/0,-1/0];for(let s of this.films)for(let i of this.abscissa(s))i<t&&(t=i),i>e&&(e=i);return e>t?[t,e]:[t-1,e+1]}draw(t,e,s,i){this.films=
t,this.active=e,this.look=s;let{context:n,width:a,height:h}=I(this.canvas);this.box={width:a-H-ss,height:h-F-yn},n.clearRect(0,0,a,h),this.range=this.shared.range??
this.fullRange();let r=t.flatMap((c,p)=>this.shades(c).map(d=>({...d,film:c,lane:p})));this.heights=this.limits??this.findHeights(r),this.shared.axis==="time"&&
this.bands(n,t[e],i),this.grid(n,s,a,h),n.save(),n.beginPath(),n.rect(H,F,this.box.width,this.box.height),n.clip();for(let c of r)this.curve(n,c,t.length>1);n.restore(),
this.legend(this.shades(t[e]),s.dark),this.describe(r)}shades(t){return this.curves(t).map(e=>({...e,color:e.color&&Ot(e.color,this.look.dark)}))}x(t){return H+
(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return F+(1-(t-this.heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(t){
let e=[];for(let{film:p,values:d}of t){let u=this.abscissa(p);for(let f=0;f<d.length;f++)u[f]>=this.range[0]&&u[f]<=this.range[1]&&Number.isFinite(d[f])&&e.push(
d[f])}if(!e.length)return[0,1];let s=Float64Array.from(e).sort(),[i,n]=[s[0],s[s.length-1]],[a,h]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],r=Math.
max(h-a,1e-12);n>h+4*r&&(n=h+.6*r),i<a-4*r&&(i=a-.6*r),i=Math.min(i,0),n=Math.max(n,0),this.symmetric&&([i,n]=[-Math.max(-i,n),Math.max(-i,n)]);let c=.06*(n-i)||
1;return[i<0?i-c:i,n+c]}bands(t,e,s){for(let i of e.phases){let n=b(this.x(i.from),H,H+this.box.width),a=b(this.x(i.to),H,H+this.box.width);a<=n||(t.fillStyle=Mt(
s.modes[i.mode],.14),t.fillRect(n,F,a-n,this.box.height))}}grid(t,e,s,i){t.font=`11px ${e.font}`,t.strokeStyle=e.line,t.fillStyle=e.soft,t.lineWidth=1;let n=Math.
max(this.box.height/28,4);for(;q(this.heights[0],this.heights[1],n).length<3&&n<12;)n+=1;let a=z(this.heights[1]-this.heights[0],n);t.textAlign="right",t.textBaseline=
"middle";for(let u of q(this.heights[0],this.heights[1],n)){let f=Math.round(this.y(u))+.5;t.globalAlpha=Math.abs(u)<1e-9*a?1:.55,t.beginPath(),t.moveTo(H,f),t.
lineTo(s-ss,f),t.stroke(),t.globalAlpha=1,t.fillText(B(u,a),H-6,f)}let h=this.box.width/70,r=z(this.range[1]-this.range[0],h);t.textAlign="center",t.textBaseline=
"alphabetic";let{name:c,unit:p}=N[this.shared.axis],d=p?`${T(c)} [${p}]`:T(c);for(let u of q(this.range[0],this.range[1],h)){let f=this.x(u);t.beginPath(),t.moveTo(
f,F+this.box.height),t.lineTo(f,F+this.box.height+4),t.stroke(),t.fillText(B(u,r),f,F+this.box.height+15)}t.textAlign="right",t.fillText(d,s-ss,i-3),t.save(),t.
translate(11,F+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText(this.unit,0,0),t.restore()}curve(t,{film:e,lane:s,values:i,color:n,dash:a},h){
let r=this.abscissa(e);t.strokeStyle=n??this.look.ink,t.lineWidth=h&&s===1?1.2:1.8,t.setLineDash(h&&s===1?[3,3]:bn[a??"solid"]),t.globalAlpha=h&&s===1?.85:1,t.beginPath();
let c=!1;for(let p=0;p<i.length;p++){if(!Number.isFinite(i[p])||!Number.isFinite(r[p])){c=!1;continue}let d=this.x(r[p]),u=b(this.y(i[p]),-1e4,1e4);c?t.lineTo(d,
u):t.moveTo(d,u),c=!0}t.stroke(),t.setLineDash([]),t.globalAlpha=1}legend(t,e){let s=t.map(i=>i.name).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>l(
"span",{class:"value"})),this.keys.replaceChildren(...t.map((i,n)=>l("span",{class:"plot-key"},is(i.color,i.dash),i.name," ",this.values[n]))))}describe(t){let e=t.
slice(0,6).map(({name:s,values:i,lane:n})=>{let[a,h]=[1/0,-1/0];for(let c of i)c<a&&(a=c),c>h&&(h=c);let r=this.films.length>1?`${"AB"[n]}: `:"";return h>=a?`${r}${s}\
 from ${x(a,3)} to ${x(h,3)}`:""});this.body.setAttribute("aria-label",`${this.title} in ${this.unit}. ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.films)
return;let{context:e,width:s,height:i}=I(this.over);if(e.clearRect(0,0,s,i),this.films.forEach((n,a)=>{let h=n.at(t),r=n.index(h.t),c=Math.min(r+1,n.length-1),p=n.
t[c]>n.t[r]?(h.t-n.t[r])/(n.t[c]-n.t[r]):0,d=this.abscissa(n),u=this.x(d[r]+p*(d[c]-d[r])),f=u>=H-1&&u<=H+this.box.width+1;f&&(e.strokeStyle=this.look.soft,e.lineWidth=
1,e.beginPath(),e.moveTo(u,F),e.lineTo(u,F+this.box.height),e.stroke()),this.shades(n).forEach((g,y)=>{let w=g.values[c],m=Number.isFinite(w)?g.values[r]+p*(w-g.
values[r]):g.values[r];a===this.active&&this.values?.[y]&&(this.values[y].textContent=x(m,3));let v=this.y(m);!f||!(v>=F-1&&v<=F+this.box.height+1)||(e.fillStyle=
g.color??this.look.ink,e.beginPath(),e.arc(u,v,3.2,0,2*Math.PI),e.fill())})}),this.picked){let[n,a]=this.picked;e.fillStyle=Mt("#0072B2",.2),e.fillRect(Math.min(
n,a),F,Math.abs(a-n),this.box.height)}}valueAt(t){let e=this.body.getBoundingClientRect(),s=b((t.clientX-e.left-H)/this.box.width,0,1);return this.range[0]+s*(this.
range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.body.getBoundingClientRect(),s=t.clientX-e.left,i=this.valueAt(t),n=this.pinched(),a=h=>{if(n||=
this.pinched(),n)return;let r=h.clientX-e.left;this.picked=t.pointerType==="mouse"&&Math.abs(r-s)>5?[s,r]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(h)),
this.cursor(this.shared.clock.time)};R(this.body,t,a,(h,r)=>{let c=this.valueAt(h),{picked:p}=this;this.picked=null,p&&r?this.zoomTo(i<c?[i,c]:[c,i]):p?this.cursor(
this.shared.clock.time):r&&!n&&this.seek(t.pointerType==="mouse"?i:c)})}seek(t){if(this.shared.axis==="time")return this.onseek(t);let e=this.films[this.active],
s=this.abscissa(e),i=0;for(let n=0;n<s.length;n++)Math.abs(s[n]-t)<Math.abs(s[i]-t)&&(i=n);return this.onseek(e.t[i])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(t,e){
let s=this.fullRange(),i=Math.max(t-(t-this.range[0])*e,s[0]),n=Math.min(t+(this.range[1]-t)*e,s[1]);this.zoomTo(i<=s[0]&&n>=s[1]?null:[i,n])}zoomTo(t){this.shared.
range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}};function is(o,t="solid"){let e=l("i",{class:"swatch","aria-hidden":"true"});return e.style.borderTopColor=
o??"var(--ink)",e.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted"}[t],e}var et=52,xi=10,_=8,vn=30,xn="RSKHM?",fe=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(t,e,s){this.backend=
t,this.clock=e,this.colors=s,this.canvas=l("canvas",{class:"plot-canvas"}),this.over=l("canvas",{class:"plot-canvas plot-over"}),this.keys=l("div",{class:"plot-\
keys"}),this.body=l("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=l("section",{class:"phase"},l("header",{},l("h3",{},"Plane of θ and θ̇"),this.keys),this.body,l("p",{class:"hint"},
`Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox. Click to go there; ${gt("")}.`)),this.body.addEventListener(
"pointerdown",i=>this.seek(i)),this.pinched=D(this.body,{zoom:(i,n)=>this.box&&this.zoomAbout(n?this.point(n):this.middle(),1/i),home:()=>this.zoomTo(null),keys:!0}),
this.range=[0,2*Math.PI],this.asked="",this.soon=U(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),i=JSON.stringify([t.hoop,t.plane,s]);if(i!==this.
asked){let n=await this.painted(t,[0,2*Math.PI,-s,s],e);this.asked=i,this.pictures=[n],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.
pictures||!this.window)){this.sharpening?.abort(),this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,[...this.range,
...this.window],this.sharpening.signal);this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){let{header:i,
arrays:n}=await this.backend.call("regions",{scenario:t,window:e},s);return{window:i.window,paradox:n.paradox,picture:this.paint(n.modes,i.arrays[0].shape)}}reach(){
return this.reached}findReach(){let t=0;for(let s of this.films??[]){let i=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(
t,i[Math.floor(.99*(i.length-1))]??0)}let e=z(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}zoomTo(t){this.range=t??[0,2*Math.PI],this.window=null,
this.pictures?.splice(1),this.redraw()}point(t){let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left-et)/this.box.width,i=1-(t.clientY-e.top-_)/this.box.
height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+i*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.
bottom()+this.top())]}zoomAbout([t,e],s){let i=Math.max(t-(t-this.range[0])*s,0),n=Math.min(t+(this.range[1]-t)*s,2*Math.PI),a=this.reach(),h=Math.max(e-(e-this.
bottom())*s,-a),r=Math.min(e+(this.top()-e)*s,a);this.range=[i,n],this.window=n-i<2*Math.PI-1e-9||r-h<2*a-1e-9?[h,r]:null,this.redraw(),this.soon()}bottom(){return this.
window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){this.films=
t,this.active=e,this.look=s,this.reached=this.findReach(),this.forwards=t.some(i=>i.columns.omega.some(n=>n>.3)),this.backwards=t.some(i=>i.columns.omega.some(n=>n<
-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(t){return et+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return _+
(1-(t-this.bottom())/(this.top()-this.bottom()))*this.box.height}paint(t,[e,s]){let{modes:i}=this.colors,n=l("canvas",{width:s,height:e}),a=new ImageData(s,e);for(let h=0;h<
e;h++)for(let r=0;r<s;r++){let c=xn[t[h*s+r]],p=X(i[c]??"#6E6E6E"),d=4*((e-1-h)*s+r);a.data.set([...p,255],d)}return V(n).putImageData(a,0,0),n}redraw(){if(!this.
films)return;let{colors:t,look:e}=this,{context:s,width:i,height:n}=I(this.canvas);if(this.box={width:i-et-xi,height:n-_-vn},s.clearRect(0,0,i,n),s.save(),s.beginPath(),
s.rect(et,_,this.box.width,this.box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:h}of this.pictures){let[r,c,p,d]=h,u=[this.
x(r),this.y(d),this.x(c)-this.x(r),this.y(p)-this.y(d)];s.fillStyle=e.panel,s.fillRect(u[0],u[1],u[2],u[3]),s.globalAlpha=.35,s.drawImage(a,u[0],u[1],u[2],u[3]),
s.globalAlpha=1}this.hatch(s)}for(let[a,h]of this.films.entries())this.way(s,h,a);if(s.restore(),this.axes(s,i,n),this.keyed!==e.dark){this.keyed=e.dark;let a=Object.
entries(t.mode_names).filter(([h])=>"RSKH".includes(h));this.keys.replaceChildren(...a.map(([h,r])=>l("span",{class:"plot-key"},is(t.modes[h]),r)))}this.cursor(
this.clock.time)}hatch(t){let{paradox:e}=this.pictures[0],s=e.length;t.strokeStyle=Mt(this.look.dark?"#ffffff":"#000000",.28),t.lineWidth=1;for(let i=0;i<s;i++){
if(!e[i])continue;let n=i;for(;n<s&&e[n]===e[i];)n++;let a=this.x(i*2*Math.PI/s),h=this.x(n*2*Math.PI/s);t.save(),t.beginPath(),t.rect(a,_,h-a,this.box.height),
t.clip(),t.beginPath();let r=e[i];for(let c=-this.box.height;c<h-a+this.box.height;c+=7)t.moveTo(a+c,r>0?_+this.box.height:_),t.lineTo(a+c+this.box.height,r>0?_:
_+this.box.height);t.stroke(),t.restore(),i=n}}way(t,e,s){let{angle:i,omega:n,mode:a}=e.columns,h=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=
this.look.ink,t.beginPath();let r=null;for(let c=0;c<e.length;c++){if(!Number.isFinite(n[c])){r=null;continue}let p=Math.floor(i[c]/h),d=i[c]-p*h;if(r===null)t.
moveTo(this.x(d),this.y(n[c]));else if(p!==r.lap){let u=p>r.lap?h:0;t.lineTo(this.x(u),this.y(n[c])),t.moveTo(this.x(h-u),this.y(n[c])),t.lineTo(this.x(d),this.
y(n[c]))}else t.lineTo(this.x(d),this.y(n[c]));r={lap:p,mode:a[c]}}t.stroke(),t.setLineDash([])}axes(t,e,s){let{look:i}=this;t.font=`11px ${i.font}`,t.strokeStyle=
i.soft,t.fillStyle=i.soft,t.lineWidth=1,t.strokeRect(et+.5,_+.5,this.box.width-1,this.box.height-1),t.textAlign="center";let n=this.range[0]*180/Math.PI,a=this.
range[1]*180/Math.PI,h=a-n>200?45:z(a-n,6);for(let c=Math.ceil(n/h-1e-9);c*h<=a+1e-9;c++){let p=this.x(c*h*Math.PI/180);t.beginPath(),t.moveTo(p,_+this.box.height),
t.lineTo(p,_+this.box.height+4),t.stroke(),t.fillText(B(c*h,h),p,_+this.box.height+15)}t.textAlign="right",t.fillText("angle θ within a turn [°]",e-xi,s-3),t.
textBaseline="middle";let r=this.top()-this.bottom();for(let c of q(this.bottom(),this.top(),5))t.fillText(B(c,z(r,5)),et-6,this.y(c));t.textBaseline="alphabeti\
c",t.save(),t.translate(11,_+.5*this.box.height),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText("θ̇ [rad/s]",0,0),t.restore()}cursor(t){if(!this.films||
!this.box)return;let{context:e,width:s,height:i}=I(this.over);e.clearRect(0,0,s,i),this.films.forEach((n,a)=>{let h=n.at(t),r=2*Math.PI,c=h.angle-Math.floor(h.angle/
r)*r,p=this.x(c),d=this.y(h.omega);p>=et&&p<=et+this.box.width&&d>=_&&d<=_+this.box.height&&(e.beginPath(),e.arc(p,d,a?4:5.5,0,2*Math.PI),e.fillStyle=this.colors.
modes[h.mode],e.fill(),e.lineWidth=2,e.strokeStyle=this.look.ink,e.stroke())})}seek(t){let e=this.body.getBoundingClientRect(),[s,i]=[t.clientX-e.left,t.clientY-
e.top];if(this.pinched())return;let n=this.films[this.active],{angle:a,omega:h}=n.columns,r=2*Math.PI,c={distance:1/0,t:0};for(let p=0;p<n.length;p++){let d=a[p]-
Math.floor(a[p]/r)*r,u=Math.hypot(this.x(d)-s,this.y(h[p])-i);u<c.distance&&(c={distance:u,t:n.t[p]})}c.distance<40&&this.clock.seek(b(c.t,0,n.duration))}};var os=o=>Object.entries(N).map(([t,e])=>l("option",{value:t},o(e)));function ki(o){let t="height",e=new wt({key:"own",title:"Your choice",unit:"",curves:n=>[{name:T(
N[t].name),values:N[t].values(n)}]},o),s=()=>{let{symbol:n,unit:a}=N[t];e.unit=a?`${n} [${a}]`:n},i=l("select",{"aria-label":"What your diagram shows",onchange:()=>{
t=i.value,s(),o.changed()}},os(Zs));return i.value=t,s(),e.element.querySelector("h3")?.after(i),e}function kn(o){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:t=>[{name:"v (centre)",color:o.center_speed,values:t.columns.vx},{name:"\
R θ̇",color:o.rotation_speed,dash:"dash",values:t.derived("spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:t=>[{name:"kinetic",color:o.kinetic,values:t.columns.kinetic},{name:"potential",color:o.potential,values:t.columns.potential},{name:"\
total",values:t.derived("total",({t:e,kinetic:s,potential:i})=>Float64Array.from(e,(n,a)=>s[a]+i[a])),dash:"dash"},{name:"lost to friction",color:o.friction_loss,
values:t.columns.friction_loss},{name:t.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:o.impact_loss,values:t.columns.
normal_loss,dash:"dot"},...t.scenario.plane.rolling_resistance?[{name:"lost to rolling resistance",values:t.columns.rolling_resistance,dash:"dot"}]:[]]},{key:"f\
orces",title:"Contact forces",unit:"force [N]",curves:t=>[{name:"normal N",color:o.normal_force,values:t.columns.normal_force},{name:"friction F",color:o.friction_force,
dash:"dash",values:t.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],curves:t=>[{name:"|F| / μN",color:o.
friction_force,values:t.columns.utilization}]}]}var me=class{films;active;look;constructor(t,e){this.colors=e,this.shared={axis:"time",range:null,clock:t,changed:()=>this.
redraw()},this.plots=[...kn(e).map(i=>new wt(i,this.shared)),ki(this.shared)];for(let i of this.plots)i.onseek=n=>t.seek(n);this.seen=new Map(this.plots.map(i=>[
i.element,!0]));let s=new IntersectionObserver(i=>{for(let{target:n,isIntersecting:a}of i)this.seen.set(n,a);this.redraw()},{rootMargin:"400px"});for(let i of this.
plots)s.observe(i.element);this.axis=l("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=
null,this.redraw()}},os(({name:i})=>`over ${i}`)),this.back=l("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=
l("span",{class:"hint"}),this.element=l("div",{class:"plots"},l("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(i=>i.element))}draw(t,e,s){
this.films=t,this.active=e,this.look=s;let i=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":`click to go there, drag to zoom; ${gt("")}`;
this.hint.textContent=t.length>1?`A full, B dotted; numbers and colours of ${"AB"[e]}; ${i}`:i,this.redraw()}redraw(){if(this.films?.length){this.back.hidden=!this.
shared.range;for(let t of this.visible())t.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.plots.filter(
t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())e.cursor(t)}};var Mn=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],ge=class{constructor(t){this.lab=t,this.menu=l("details",{class:"menu"},l("summary",{class:"button"},"Keep"),l("div",{class:"menu-body"},t.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),Mn.map(([e,s])=>this.item(s,()=>this.download(e))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=l("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),t.root.addEventListener("pointerdown",e=>{this.menu.contains(e.target)||(this.menu.open=!1)})}item(t,e){return l("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await e()}catch(s){this.lab.notice.fail(s)}}},t)}async copyLink(){let t=this.lab.link()??"";try{await navigator.clipboard.writeText(t),this.
lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",t)}}async download(t){let e=this.lab.film();this.lab.notice.say(t.endsWith("mp4")?
"The film is being made; this takes a while …":`Fetching ${t} …`),ut(await this.lab.backend.file(t,e.query),`hophoop-${t}`),this.lab.notice.say(`${t} is the\
re.`)}picture(){this.lab.drawStage();let t=this.lab.stage.canvas(),e=l("canvas",{width:t.width,height:t.height});return this.copyInto(e),new Promise(s=>{e.toBlob(
i=>{i&&ut(i,"hophoop.png"),s()},"image/png")})}copyInto(t){let{lab:e}=this,s=e.stage.canvas(),i=V(t);i.fillStyle=e.theme.look.paper,i.fillRect(0,0,t.width,t.height),
i.drawImage(s,0,0,t.width,t.height);let n=t.width/Math.max(s.getBoundingClientRect().width,1);i.textBaseline="top",i.textAlign="left";let a=e.films();for(let[h,
r]of a.entries()){let c=r.at(e.clock.time),p=[a.length>1?`${"AB"[h]}: `:"",`${e.theme.colors.mode_names[c.mode]}, t = ${c.t.toFixed(3)} s, θ = ${P(c.angle)}, v\
 = ${x(c.vx,3)} m/s`].join(""),d=e.stage.options.three?10+20*h:10+h*s.getBoundingClientRect().height/a.length;i.fillStyle=e.theme.colors.modes[c.mode],i.fillRect(
12*n,(d+2)*n,11*n,11*n),i.fillStyle=e.theme.look.ink,i.font=`${13*n}px ${e.theme.look.font}`,i.fillText(p,30*n,d*n)}}async record(){let{lab:t}=this,e=t.stage.canvas();
if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 instead.");let s=l("canvas",{width:2*Math.ceil(
e.width/2),height:2*Math.ceil(e.height/2)}),i=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),n=[];i.ondataavailable=r=>n.push(r.data);let a=new Promise(
r=>i.onstop=r),h=t.clock.loop;t.clock.loop=!1,t.clock.seek(0),t.notice.say("Recording one run …"),t.afterFrame=()=>{this.copyInto(s),!t.clock.playing&&i.state===
"recording"&&i.stop()},i.start(),t.clock.play(!0),await a,t.afterFrame=null,t.clock.loop=h,ut(new Blob(n,{type:i.mimeType}),"hophoop.webm"),t.notice.say("The fi\
lm is there.")}async code(){let{header:t}=await this.lab.backend.call("code",{scenario:this.lab.film().scenario});this.show("The same motion in Python",t.python,
"The scenario as a file",t.toml)}show(...t){let e=[];for(let s=0;s<t.length;s+=2){let i=t[s+1],n=l("button",{type:"button"},"Copy");n.onclick=async()=>{await navigator.
clipboard?.writeText(i).catch(()=>{}),n.textContent="Copied"},e.push(l("header",{},l("h2",{},t[s]),n),l("pre",{tabindex:"0"},l("code",{},i)))}this.dialog.replaceChildren(
...e,l("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};function Mi(o,t){let e=l("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([i])=>{let n=!i.isIntersecting&&i.boundingClientRect.top<0;if(n===
o.classList.contains("stuck"))return;let a=o.offsetHeight;o.style.marginBottom="",o.classList.toggle("stuck",n),n&&(o.style.marginBottom=`${a-o.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=n?`${o.offsetHeight}px`:"",t()});return s.observe(e),{edge:e,close:()=>s.disconnect()}}var Ti=120,we=class{constructor(t,e){this.canvas=t,this.onview=e,this.zoom=1,this.shift=[0,0],this.views=[],this.fixed=null,t.addEventListener("pointerdown",s=>this.
drag(s)),this.pinched=D(t,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>t.parentElement})}reset(){this.zoom=1,this.shift=[0,0],this.onview()}zoomBy(t){
this.zoom=b(this.zoom*t,.05,60),this.onview()}drag(t){let e=[t.clientX,t.clientY],s=this.shift;R(this.canvas,t,i=>{this.pinched()||(this.shift=[s[0]+i.clientX-e[0],
s[1]+i.clientY-e[1]],this.onview())})}draw(t,e,s,i,n){let{context:a,width:h,height:r}=I(this.canvas);if(a.clearRect(0,0,h,r),h<40||r<40)return;let c=r/t.length,
p={top:Math.max(...t.map(d=>d.extent.top)),radius:Math.max(...t.map(d=>d.radius)),speed:Math.max(...t.map(d=>d.extent.speed))};t.forEach((d,u)=>{a.save(),a.beginPath(),
a.rect(0,u*c,h,c),a.clip(),a.translate(0,u*c);let f=new ns(a,h,c,d,e,s,i,n,this.zoom,this.shift,p);f.top=u*c,f.scale=this.fixed??f.scale,f.draw(),this.views[u]=
f,t.length>1&&(a.fillStyle=i.soft,a.font=`600 15px ${i.font}`,a.textAlign="left",a.fillText("AB"[u],12,c-12)),a.restore(),u>0&&(a.fillStyle=i.line,a.fillRect(0,
u*c-.5,h,1))})}},ns=class{top=0;constructor(t,e,s,i,n,a,h,r,c,p,d){this.context=t,this.width=e,this.height=s,this.film=i,this.options=a,this.look=h,this.colors=
r,this.common=d,this.pose=i.at(n);let u=i.radius,{left:f,right:g}=i.extent,{top:y}=d;this.cosine=Math.cos(i.slope),this.sine=Math.sin(i.slope);let w=2*d.radius+
Math.min(y,6*d.radius),m=Math.min(.66*s/w,.36*e/d.radius);if(a.whole){let v=(g-f)*this.cosine+2.6*u,k=(g-f)*Math.abs(this.sine)+2.6*u+y;this.scale=Math.min(e/v,
.86*s/k,m)*c,this.focus=[.5*(f+g),0],this.place=[.5*e+p[0],(i.slope?.62:.8)*s+p[1]]}else this.scale=m*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],
this.place=[(e<520?.6:.46)*e+p[0],.82*s+p[1]]}point(t,e){let s=t-this.focus[0],i=e-this.focus[1];return[this.place[0]+this.scale*(s*this.cosine+i*this.sine),this.
place[1]-this.scale*(i*this.cosine-s*this.sine)]}unpoint(t,e){let s=(t-this.place[0])/this.scale,i=-(e-this.place[1])/this.scale;return[this.focus[0]+s*this.cosine-
i*this.sine,this.focus[1]+s*this.sine+i*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&
this.forces()}ground(){let{context:t,look:e,width:s,height:i}=this,n=(Math.hypot(s,i)*1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[a,h]=this.
point(this.focus[0]-n,0),[r,c]=this.point(this.focus[0]+n,0),p=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,t.beginPath(),t.moveTo(a,h),t.lineTo(r,c),t.
lineTo(r+p[0],c+p[1]),t.lineTo(a+p[0],h+p[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(a,h),t.lineTo(r,c),t.stroke();let d=z(s/this.
scale,s/90);t.fillStyle=e.soft,t.font=`11px ${e.font}`,t.textAlign="center",t.lineWidth=1;let u=Math.ceil((this.focus[0]-n)/d),f=Math.min(Math.floor((this.focus[0]+
n)/d),u+400);for(let g=u;g<=f;g++){let[y,w]=this.point(g*d,0);y<-40||y>s+40||(t.beginPath(),t.moveTo(y,w),t.lineTo(y-6*this.sine,w+6*this.cosine),t.stroke(),t.fillText(
`${B(g*d,d)} m`,y-18*this.sine,w+8+10*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:i}=this,n=this.options.ahead?t.length-1:t.index(this.pose.t),a=t.
radius,{x:h,height:r,angle:c,mode:p}=t.columns,d=(u,f,g,y)=>{e.strokeStyle=f,e.lineWidth=g,e.lineJoin="round",e.beginPath();let w=!1,m=(v,k,M)=>{let[A,E]=this.point(
v+u*Math.sin(M),a+k+u*Math.cos(M));w?e.lineTo(A,E):e.moveTo(A,E),w=!0};for(let v=0;v<=n;v++)y===void 0||p[v]===3===y?m(h[v],r[v],c[v]):w=!1;!this.options.ahead&&
(y===void 0||this.pose.mode==="H"===y)&&m(this.pose.x,this.pose.height,this.pose.angle),e.stroke()};e.globalAlpha=this.options.ahead?.45:1,d(a,s.ink,1.3),d(t.eccentricity*
a,i.gravity_center,1.8,!1),d(t.eccentricity*a,i.airborne,2.4,!0),e.globalAlpha=1}hoop(){let{film:t,pose:e,context:s,look:i,colors:n,scale:a}=this,h=t.radius,r=b(
.07*h*a,2,14),c=h-.5*r/a,p=[e.x,h+e.height],d=(w,m=c)=>this.point(p[0]+m*Math.sin(w),p[1]+m*Math.cos(w));if(s.lineCap="butt",i.dark&&(s.strokeStyle=i.soft,s.lineWidth=
r+2,s.beginPath(),s.arc(...this.point(p[0],p[1]),c*a,0,2*Math.PI),s.stroke()),this.options.speed){let w=this.common.speed;s.lineWidth=r;let m=2*Math.PI/Ti;for(let v=0;v<
Ti;v++){let k=e.angle+v*m,M=Math.hypot(e.vx+h*e.omega*Math.cos(k+.5*m),e.vy-h*e.omega*Math.sin(k+.5*m));s.strokeStyle=Ft[b(Math.round(255*M/w)||0,0,255)],s.beginPath(),
s.moveTo(...d(k-.04*m)),s.lineTo(...d(k+1.04*m)),s.stroke()}}else s.strokeStyle=n.modes[e.mode],s.lineWidth=r,s.beginPath(),s.arc(...this.point(p[0],p[1]),c*a,0,
2*Math.PI),s.stroke();s.strokeStyle=i.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(p[0],p[1])),s.lineTo(...d(e.angle)),s.stroke();let u=(w,m,v,k)=>{s.
beginPath(),s.arc(...w,m,0,2*Math.PI),s.fillStyle=v,s.fill(),s.lineWidth=1.5,s.strokeStyle=k,s.stroke()};u(this.point(p[0],p[1]),2.5,i.soft,i.soft);let f=t.scenario.
hoop.parts;f?this.parts(f,p):u(d(e.angle),b(.1*h*a,4,16),i.ink,i.paper);let g=t.eccentricity*h,y=this.point(p[0]+g*Math.sin(e.angle),p[1]+g*Math.cos(e.angle));u(
y,b(.05*h*a,3.5,7),e.mode==="H"?n.airborne:n.gravity_center,i.paper)}parts(t,e){let{film:s,pose:i,context:n,look:a,scale:h}=this,c=t.reduce((p,d)=>p+d.mass*(d.at??
0),0)<0?-1:1;n.strokeStyle=a.ink;for(let p of t){let d=c*(p.at??0),u=this.point(e[0]+d*Math.sin(i.angle),e[1]+d*Math.cos(i.angle));if(n.fillStyle=a.ink,n.lineWidth=
1,n.beginPath(),p.shape==="ring")n.globalAlpha=.22,n.arc(...u,p.outer_radius*h,0,2*Math.PI),n.arc(...u,p.inner_radius*h,0,2*Math.PI,!0),n.fill(),n.globalAlpha=1;else if(p.
shape==="rod"){let f=.5*p.length,g=y=>this.point(e[0]+y*Math.sin(i.angle),e[1]+y*Math.cos(i.angle));n.lineWidth=4,n.moveTo(...g(d-f)),n.lineTo(...g(d+f)),n.stroke()}else{
let f=p.shape==="disk"?p.radius*h:b(.08*s.radius*h,3,12);n.globalAlpha=p.shape==="disk"?.55:1,n.arc(...u,f,0,2*Math.PI),n.fill(),n.globalAlpha=1}}}forces(){let{
film:t,pose:e,colors:s}=this,i=t.radius,n=t.mass*(t.gravity||9.81),a=r=>.55*i*r/n;if(e.mode==="H"||!(e.normal_force>0))return;let h=[e.x,e.height];this.arrow(h,
[0,a(e.normal_force)],s.normal_force,`N = ${x(e.normal_force,3)} N`,!1),this.arrow(h,[a(e.friction_force),0],s.friction_force,`F = ${x(e.friction_force,3)} N`,!0)}arrow([
t,e],[s,i],n,a,h){let{context:r,look:c,width:p}=this,d=2.2*this.film.radius,u=Math.abs(s)>d||Math.abs(i)>d;[s,i]=[b(s,-d,d),b(i,-d,d)];let f=this.point(t,e),g=this.
point(t+s,e+i),y=Math.hypot(g[0]-f[0],g[1]-f[1]);if(y<2)return;let w=(g[0]-f[0])/y,m=(g[1]-f[1])/y,v=Math.min(11,y);for(let[A,E]of[[c.paper,6],[n,3]])r.strokeStyle=
A,r.fillStyle=A,r.lineWidth=E,r.beginPath(),r.moveTo(...f),r.lineTo(g[0]-w*v,g[1]-m*v),r.stroke();if(r.beginPath(),r.moveTo(...g),r.lineTo(g[0]-w*v-m*v*.5,g[1]-
m*v+w*v*.5),r.lineTo(g[0]-w*v+m*v*.5,g[1]-m*v-w*v*.5),r.fill(),u){let[A,E]=[f[0]+.55*w*y,f[1]+.55*m*y];r.strokeStyle=c.paper,r.lineWidth=2,r.beginPath();for(let S of[
-3,3])r.moveTo(A+w*(S-3)-m*7,E+m*(S-3)+w*7),r.lineTo(A+w*(S+3)+m*7,E+m*(S+3)-w*7);r.stroke()}r.font=`600 12px ${c.font}`;let k=r.measureText(a).width;r.lineWidth=
3,r.strokeStyle=h?c.ground:c.paper,r.textAlign="left";let M=h?[f[0]-.5*k-32*this.sine,f[1]+32*this.cosine]:[g[0]+12,b(g[1]+4,16,f[1]-.36*this.film.radius*this.scale)];
M[0]=b(M[0],4,p-k-4),r.strokeText(a,M[0],M[1]),r.fillText(a,M[0],M[1])}};function rs(o,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let i=0;i<4;i++){let n=0;for(let a=0;a<4;a++)n+=o[4*a+i]*t[4*s+a];e[4*s+i]=n}return e}function Si(o,t,e,s){
let i=1/Math.tan(o/2),n=1/(e-s);return new Float32Array([i/t,0,0,0,0,i,0,0,0,0,(s+e)*n,-1,0,0,2*s*e*n,0])}function Ei(o,t){let e=rt(hs(o,t)),s=rt(ye([0,1,0],e)),
i=ye(e,s);return new Float32Array([s[0],i[0],e[0],0,s[1],i[1],e[1],0,s[2],i[2],e[2],0,-as(s,o),-as(i,o),-as(e,o),1])}var hs=(o,t)=>[o[0]-t[0],o[1]-t[1],o[2]-t[2]],
as=(o,t)=>o[0]*t[0]+o[1]*t[1]+o[2]*t[2],ye=(o,t)=>[o[1]*t[2]-o[2]*t[1],o[2]*t[0]-o[0]*t[2],o[0]*t[1]-o[1]*t[0]];function rt(o){let t=Math.hypot(...o)||1;return[
o[0]/t,o[1]/t,o[2]/t]}function be(o,t,e,s){let i=rt(t),n=rt(ye(i,Math.abs(i[2])>.9?[1,0,0]:[0,0,1])),a=ye(n,i);return new Float32Array([...n.map(h=>h*s),0,...i.
map(h=>h*e),0,...a.map(h=>h*s),0,...o,1])}function ls(o){let[t,e]=[Math.cos(o),Math.sin(o)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function W(o){let t=Number.parseInt(o.slice(1,7),16);
return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function yt(o,t,e){let s=o.createProgram(),i=[[o.VERTEX_SHADER,t],[o.FRAGMENT_SHADER,e]];for(let[a,h]of i){let r=o.createShader(a);if(o.shaderSource(r,h),o.compileShader(
r),!o.getShaderParameter(r,o.COMPILE_STATUS))throw new Error(String(o.getShaderInfoLog(r)));o.attachShader(s,r)}if(o.linkProgram(s),!o.getProgramParameter(s,o.LINK_STATUS))
throw new Error(String(o.getProgramInfoLog(s)));let n={program:s,uniforms:{},attributes:{}};for(let a=0;a<o.getProgramParameter(s,o.ACTIVE_UNIFORMS);a++){let{name:h}=o.
getActiveUniform(s,a);n.uniforms[h]=o.getUniformLocation(s,h)}for(let a=0;a<o.getProgramParameter(s,o.ACTIVE_ATTRIBUTES);a++){let{name:h}=o.getActiveAttrib(s,a);
n.attributes[h]=o.getAttribLocation(s,h)}return n}function ht(o,t,e,s){let i=o.createBuffer();o.bindBuffer(o.ARRAY_BUFFER,i),o.bufferData(o.ARRAY_BUFFER,new Float32Array(
t),o.STATIC_DRAW);let n=s?o.createBuffer():null;s&&(o.bindBuffer(o.ELEMENT_ARRAY_BUFFER,n),o.bufferData(o.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),o.STATIC_DRAW));
let a=4*Object.values(e).reduce((h,r)=>h+r,0);return{vertices:i,elements:n,parts:e,stride:a,count:s?s.length:4*t.length/a}}function bt(o,t,e){o.bindBuffer(o.ARRAY_BUFFER,
e.vertices);let s=0;for(let[i,n]of Object.entries(e.parts)){let a=t.attributes[i];a!==void 0&&(o.enableVertexAttribArray(a),o.vertexAttribPointer(a,n,o.FLOAT,!1,
e.stride,s)),s+=4*n}e.elements&&o.bindBuffer(o.ELEMENT_ARRAY_BUFFER,e.elements)}function cs(o,t){let e=[];for(let s=0;s<o;s++)for(let i=0;i<t;i++){let n=s*(t+1)+
i,a=n+t+1;e.push(n,a,n+1,a,a+1,n+1)}return e}function Ai(o,t=120,e=14){let s=[];for(let i=0;i<=t;i++)for(let n=0;n<=e;n++)s.push(2*Math.PI*i/t,2*Math.PI*n/e);return ht(
o,s,{bend:2},cs(t,e))}function Pi(o,t=28,e=18){let s=[];for(let i=0;i<=t;i++)for(let n=0;n<=e;n++){let[a,h]=[2*Math.PI*i/t,Math.PI*n/e],r=[Math.sin(h)*Math.cos(
a),Math.cos(h),Math.sin(h)*Math.sin(a)];s.push(...r,...r)}return ht(o,s,{position:3,normal:3},cs(t,e))}function ps(o,t,e=20){let s=[];for(let i=0;i<=e;i++){let n=2*
Math.PI*i/e,a=[Math.cos(n),1-t,Math.sin(n)];s.push(Math.cos(n),0,Math.sin(n),...a,t*Math.cos(n),1,t*Math.sin(n),...a)}return ht(o,s,{position:3,normal:3},cs(e,1))}var Ri=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Li=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Ni="vec4(0.0, 0.0, 0.0, shadow)",_i=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Li}
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
   ${Ri}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Ni} : vec4(shaded(color, n), 1.0);
   }`],Ii=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Li}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${Ri}
   void main() { gl_FragColor = shadow > 0.0 ? ${Ni} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],$i=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],ve=class{constructor(t,e,s,i,{keep:n=!1}={}){let a=t.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:n});if(!a)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=a,this.canvas=
t,this.sun=rt(s),this.dark=i,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=yt(a,_i[0],_i[1]),this.body=yt(a,Ii[0],Ii[1]),this.line=yt(a,$i[0],$i[1]),this.torus=Ai(
a),this.sphere=Pi(a),this.cylinder=ps(a,1),this.cone=ps(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.colors);let h=new Uint8Array(e.flatMap(
r=>[...r,255]));a.pixelStorei(a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,e.length,1,0,a.RGBA,a.UNSIGNED_BYTE,h);for(let r of[a.TEXTURE_WRAP_S,a.TEXTURE_WRAP_T])
a.texParameteri(a.TEXTURE_2D,r,a.CLAMP_TO_EDGE);for(let r of[a.TEXTURE_MIN_FILTER,a.TEXTURE_MAG_FILTER])a.texParameteri(a.TEXTURE_2D,r,a.LINEAR);this.view=ls(0),
this.eye=[0,0,1],this.fastest=1}begin({background:t,eye:e,target:s,slope:i,angle:n,near:a,far:h}){let{gl:r,canvas:c}=this;r.viewport(0,0,c.width,c.height),r.clearColor(
t[0],t[1],t[2],1),r.clear(r.COLOR_BUFFER_BIT|r.DEPTH_BUFFER_BIT|r.STENCIL_BUFFER_BIT),r.enable(r.DEPTH_TEST);let p=Si(n,c.width/c.height,a,h);this.view=rs(rs(p,
Ei(e,s)),ls(i)),this.eye=rt(hs(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let i={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[
n,a]of Object.entries(i)){let h=t.uniforms[n];h!==void 0&&(typeof a=="number"?s.uniform1f(h,a):a.length===16?s.uniformMatrix4fv(h,!1,a):s[`uniform${a.length}fv`](
h,a))}}ground(t){let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,
e.ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),
e.depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:i=!1,lit:n=!0}={}){let{gl:a}=this;this.use(this.body,{model:e,color:s,shadow:i?
this.dark:0,lit:Number(n)}),bt(a,this.body,t),a.drawElements(a.TRIANGLES,t.count,a.UNSIGNED_SHORT,0)}ball(t,e,s,i){this.solid(this.sphere,be(t,[0,1,0],e,e),s,{shadow:i})}ring({
center:t,radius:e,tube:s,broad:i,angle:n,velocity:a,omega:h,plain:r=null},c){let{gl:p}=this;this.use(this.rim,{center:t,size:[e,s,i,n],motion:[...a,h],most:this.
fastest,shadow:c?this.dark:0,plain:r??[0,0,0],colored:r?0:1}),bt(p,this.rim,this.torus),p.drawElements(p.TRIANGLES,this.torus.count,p.UNSIGNED_SHORT,0)}rod(t,e,s,i,n,a=!1){
this.solid(this.cylinder,be(t,e,s,i),n,{shadow:a})}arrow(t,e,s,i,n){if(!(s>.02*i))return;let a=Math.min(.18*i,s),h=t.map((r,c)=>r+e[c]*(s-a));s>a&&this.rod(t,e,
s-a,.029*i,n),this.solid(this.cone,be(h,e,a,Math.min(.075*i,.6*a)),n)}trace(t,e,s){let i=[];for(let n=0;n<t;n++){let a=e(n),h=e(Math.min(n+1,t-1));if(Math.hypot(
h[0]-a[0],h[1]-a[1])<1e-9&&n>0){let r=e(n-1);h=a.map((c,p)=>2*c-r[p])}for(let r of[-1,1])i.push(...a,0,...h,0,...s(n),r)}return ht(this.gl,i,{position:3,next:3,
tint:3,side:1})}drawTrace(t,e,{width:s,distance:i=0,shift:n,depth:a}){let{gl:h,canvas:r}=this;this.use(this.line,{pixel:[2/r.width,2/r.height],width:s,distance:i,
shift:n,depth:a}),bt(h,this.line,t),h.drawArrays(h.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let i=this.view,[n,a,h]=[0,1,3].map(r=>i[r]*t+i[4+r]*e+i[8+r]*s+i[12+
r]);return h>0?[(.5+.5*n/h)*this.canvas.width,(.5-.5*a/h)*this.canvas.height]:null}};var Tn=[.35,.85,.4],Sn=.18,zi={azimuth:.5,height:.22,distance:5.2},Ci=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],xe=class{constructor(t,e){this.canvas=t,this.onview=e,this.space=new ve(t,dt,Tn,Sn,{keep:!0}),this.floor=yt(this.space.gl,Ci[0],Ci[1]),this.corners=ht(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...zi},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,t.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=D(t,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>t.parentElement})}zoomBy(t){t?this.turned.distance=b(
this.turned.distance/t,1.6,60):this.turned={...zi},this.onview()}drag(t){let e={...this.turned,x:t.clientX,y:t.clientY};R(this.canvas,t,s=>{this.pinched()||(this.
turned.azimuth=b(e.azimuth-(s.clientX-e.x)*.008,-1.5,1.5),this.turned.height=b(e.height+(s.clientY-e.y)*.006,.02,1.45),this.onview())})}quality(){let t=performance.
now(),e=t-(this.before||t);return this.before=t,e>0&&e<200&&(this.pace=.9*this.pace+.1*e),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(t,e,s,i,n,a){let{canvas:h,space:r}=this,c=Math.min(globalThis.devicePixelRatio||1,2)*(a?this.quality():1),p=h.getBoundingClientRect();h.
width=Math.max(Math.round(p.width*c),1),h.height=Math.max(Math.round(p.height*c),1);let d=t.map(g=>g.at(e)),u=t[0].radius;r.fastest=Math.max(...t.map(g=>g.extent.
speed)),this.focus=Number.isFinite(d[0].x)?d[0].x:0,r.begin({background:W(i.paper),...this.camera(t[0],d[0],u,s)}),r.ground(()=>this.drawFloor(u,i));let f=g=>{for(let[
y,w]of t.entries())g(w,d[y],-2.1*u*y)};r.shadows(()=>f((g,y,w)=>this.drawHoop(g,y,w,s,i,n,!0))),f((g,y,w)=>{this.drawHoop(g,y,w,s,i,n,!1),s.traces&&this.drawTraces(
g,y,w,i,n,c),s.forces&&this.drawForces(g,y,w,n)})}camera(t,e,s,i){let{azimuth:n,height:a,distance:h}=this.turned,{left:r,right:c}=t.extent,p=i.whole?Math.max(h*
s,.85*(c-r)+3*s):h*s,[d,u]=[i.whole?.5*(r+c)-this.focus:0,s+.45*(e.height||0)],f=Math.cos(t.slope),g=Math.sin(t.slope),y=[d*f+u*g,-d*g+u*f,0],w=[y[0]+p*Math.sin(
n)*Math.cos(a),y[1]+p*Math.sin(a),p*Math.cos(n)*Math.cos(a)];return this.reach=12*s+3*p,{eye:w,target:y,slope:t.slope,angle:.75,near:.05*s,far:40*s+6*p}}drawFloor(t,e){
let{space:s}=this,i=W(e.ground),n=i.map(r=>r*(e.dark?.82:.94)),a=.5*t,h=this.focus%(2*a);s.use(this.floor,{reach:this.reach,light:i,dark:n,far:W(e.paper),tile:a,
shift:h}),bt(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(t,e,s,i,n,a,h){let{space:r}=this,c=t.radius,p=.045*c,d=[e.x-this.focus,
c+e.height,s];r.ring({center:d,radius:c,tube:p,broad:3.2*p,angle:e.angle,velocity:[e.vx,e.vy],omega:e.omega,plain:i.speed?null:W(a.modes[e.mode])},h);let u=[Math.
sin(e.angle),Math.cos(e.angle),0],f=y=>d.map((w,m)=>w+y*u[m]);r.ball(f(c-p),.125*c,n.dark?[.9,.91,.94]:[.12,.13,.15],h),r.rod(d,u,c-p,.012*c,[.55,.57,.6],h);let g=e.
mode==="H";r.ball(f(t.eccentricity*c),.07*c,W(g?a.airborne:a.gravity_center),h)}drawForces(t,e,s,i){if(e.mode==="H"||!(e.normal_force>0))return;let n=t.radius,a=t.
mass*(t.gravity||9.81),h=[e.x-this.focus,e.height+.03*n,s+.2*n],r=p=>b(.55*n*Math.abs(p)/a,0,3.2*n),c=Math.sign(e.friction_force);this.space.arrow(h,[0,1,0],r(e.
normal_force),n,W(i.normal_force)),this.space.arrow(h,[c,0,0],r(e.friction_force),n,W(i.friction_force))}linesOf(t,e,s){let i=this.lines.get(t);if(i?.dark===e.dark)
return i;let n=t.radius,{x:a,height:h,angle:r,mode:c}=t.columns,p=(y,w)=>this.space.trace(t.length,m=>[a[m]+y*Math.sin(r[m]),n+h[m]+y*Math.cos(r[m])],w),[d,u,f]=[
W(s.gravity_center),W(s.airborne),W(e.ink)],g={dark:e.dark,load:p(n,()=>f),center:p(t.eccentricity*n,y=>c[y]===3?u:d)};return this.lines.set(t,g),g}drawTraces(t,e,s,i,n,a){
let{load:h,center:r}=this.linesOf(t,i,n),c=Math.min(t.index(e.t)+2,t.length),p={shift:this.focus,depth:s};this.space.drawTrace(h,c,{width:a,...p}),this.space.drawTrace(
r,c,{width:1.6*a,...p})}};var En=["hoop","mode","time","angle","v","R θ̇","gap"],ke=class{constructor(t,e){this.colors=t,this.onview=e,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1},this.plane=l("canvas",{class:"stage-canvas"}),this.space=l("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new we(this.plane,e),this.deep=
null,this.outputs=En.map(i=>({name:l("dt",{},i),value:l("dd",{})})),this.outputs[1].value.className="mode",this.fastest=l("span",{}),this.legend=l("div",{class:"\
legend","aria-hidden":"true"},l("i",{style:`background: linear-gradient(90deg, ${Ft.filter((i,n)=>n%15===0).join(",")})`}),l("span",{},"0"),l("span",{},"rim spe\
ed"),this.fastest);let s=(i,n)=>l("span",{},l("i",{class:"dot",style:`background:${i}`}),n);this.order=l("span",{hidden:!0},"A in front, B behind"),this.element=
l("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,l("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(
({name:i,value:n})=>[i,n])),this.legend,l("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(t.gravity_center,"centre of gravity"),s(t.airborne,
"the same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(t,e,s,{look:i,inks:n}){let{options:a}=this;this.legend.hidden=!a.
speed,this.order.hidden=!(a.three&&t.length>1),this.fastest.textContent=`≥ ${x(Math.max(...t.map(h=>h.extent.speed)),2)} m/s`,a.three?(this.deep??=new xe(this.
space,this.onview),this.deep.draw(t,s.time,a,i,n,s.playing)):this.flat.draw(t,s.time,a,i,n),this.read(t,e,s.time)}read(t,e,s){let i=t[e],n=i.at(s),a=[t.length>1?
"AB"[e]:"",this.colors.mode_names[n.mode],`${n.t.toFixed(3)} s`,P(n.angle),$(x(n.vx,3),"m/s"),$(x(n.omega*i.radius,3),"m/s"),n.height>0?Z(n.height):"0"];for(let[
c,p]of a.entries()){let{value:d}=this.outputs[c];d.textContent!==p&&(d.textContent=p)}let[h,r]=this.outputs;h.value.hidden=h.name.hidden=t.length<2,r.value.style.
setProperty("--mode",this.colors.modes[n.mode])}describe(t){this.element.setAttribute("aria-label",`The hoop. ${t.map(e=>e.summary).join(" ")}`)}turn(t){let e=()=>{
this.plane.hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,e();try{t()}catch(s){throw this.options.three=
!1,e(),s}}zoom(t){this.options.three?this.deep?.zoomBy(t):t?this.flat.zoomBy(t):this.flat.reset()}};var Me=class{film;items;current;constructor(t){this.clock=t,this.summary=l("p",{class:"summary"}),this.list=l("ol",{class:"story-list"}),this.heading=l("h2",{},
"What happens"),this.live=l("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=l("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(t,e,s){this.film=t[e],this.heading.textContent=t.length>1?`What happens to hoop ${"AB"[e]}`:"What happens",this.
summary.replaceChildren(...t.flatMap((i,n)=>[t.length>1?l("b",{},`${"AB"[n]}: `):"",i.summary,i.status==="event_limit"||i.shortened?" (not all events are shown)":
"",n+1<t.length?l("br"):""])),this.items=this.film.story.map(i=>l("li",{},l("button",{type:"button",onclick:()=>this.clock.seek(i.t)},l("i",{class:"dot",style:`\
background:${s.modes[i.mode]}`,"aria-hidden":"true"}),l("span",{class:"when"},`${x(i.t,4)} s`),l("span",{},i.text)))),this.list.replaceChildren(...this.items),this.
current=-1,this.cursor(this.clock.time)}say(t){this.live.textContent=t}announce(t){this.say(t.map(e=>e.summary).join(" "))}cursor(t){let{story:e}=this.film,s=-1;
for(let n=0;n<e.length&&e[n].t<=t+1e-9;n++)s=n;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),
this.items[this.current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let i=this.items[s];if(i){let n=i.offsetTop-
this.list.offsetTop;(n<this.list.scrollTop||n+i.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=n-.4*this.list.clientHeight)}}},Te=class{constructor(){
this.list=l("dl",{}),this.heading=l("h2",{},"What theory says"),this.element=l("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){this.heading.textContent=
e?`What theory says of hoop ${e}`:"What theory says",this.list.replaceChildren(...t.flatMap(({label:s,text:i})=>[l("dt",{},s),l("dd",{},i)]))}};var Se={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns back",apex:"hi\
ghest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"jam",kane_gain:"\
energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},Oi=o=>o.kind==="takeoff"||o.to==="H"&&o.from!=="H"&&o.kind!=="impact";var Lt={jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"\
↺",apex:"•"},Ee=Object.keys(Lt);function Fi(o,t=11){let s=[...o.filter(({kind:n})=>n in Lt)].sort((n,a)=>Ee.indexOf(n.kind)-Ee.indexOf(a.kind)||n.x-a.x),i=[];
for(let{kind:n,x:a}of s){let h=Ee.indexOf(n)<Ee.indexOf("takeoff"),r=i.filter(c=>Math.abs(c.x-a)<t);r.length?r.length===1&&r[0].rare&&!i.some(c=>Math.abs(c.x-(r[0].
x+t))<t-1e-9)?r[0].mark!==Lt[n]&&i.push({mark:Lt[n],x:r[0].x+t,rare:!1,hidden:0}):r[0].hidden+=1:i.push({mark:Lt[n],x:a,rare:h,hidden:0})}return i.sort((n,a)=>n.
x-a.x).map(({mark:n,x:a})=>({mark:n,x:a}))}function Bi(o,t,e){let s=[],i=new Map,n=-1,a=(r,c,p)=>{let d=s.at(-1);d&&d.mode===r&&Math.abs(d.from+d.wide-c)<1e-6?d.
wide+=p:s.push({mode:r,from:c,wide:p})},h=()=>{i.size&&a([...i].reduce((r,c)=>c[1]>r[1]?c:r)[0],n,1),i=new Map};for(let{mode:r,from:c,to:p}of o){let[d,u]=[Math.
max(t(c),0),Math.min(t(p),e)];if(u>d)for(let f=d;f<u-1e-9;){if((Math.floor(f+1e-9)!==n||!i.size)&&(h(),n=Math.floor(f+1e-9),u-f>=1&&Math.abs(f-n)<1e-6)){let y=Math.
floor(u-f+1e-9);a(r,n,y),f=n+y;continue}let g=Math.min(u,n+1);i.set(r,(i.get(r)??0)+g-f),f=g}}return h(),s}var Ae=class{films;said;constructor(t){this.clock=t,this.window=null,this.canvas=l("canvas",{class:"timeline-canvas"}),this.tip=l("div",{class:"tip",hidden:!0}),
this.element=l("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),
this.element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermove",e=>this.hover(e)),this.element.addEventListener("point\
erleave",()=>this.tip.hidden=!0),this.pinched=D(this.element,{zoom:(e,s)=>this.zoom(1/e,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let t=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=t[1]?t:at(this.window,t)}zoom(t,e){let[s,i]=this.ends(),n=1e-6*this.clock.duration,
a=Math.max((i-s)*t,n),h=(e-s)/(i-s);this.window=a<this.clock.duration?at([e-h*a,e+(1-h)*a],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[t,e]=this.ends(),{time:s,duration:i}=this.clock;if(s>=t&&s<=e)return;let n=e-t;this.window=at(s>e?[s-.1*n,s+.9*n]:[s-.5*n,s+.5*n],[0,i])}timeAt(t){let e=this.
canvas.getBoundingClientRect(),[s,i]=this.ends();return s+b((t.clientX-e.left)/e.width,0,1)*(i-s)}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});
let e=this.clock.playing;this.clock.playing=!1;let s=i=>!this.pinched()&&this.clock.seek(this.timeAt(i));s(t),R(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){
let e=this.timeAt(t),s=this.nearest(e,8),i=s?`${Se[s.kind]??s.kind} · ${x(s.t,5)} s · ${x(s.angle*180/Math.PI,4)}°`:`${x(e,4)} s`;this.tip.textContent=i,this.
tip.hidden=!1;let n=this.canvas.getBoundingClientRect();this.tip.style.left=`${b(t.clientX-n.left,70,n.width-70)}px`}nearest(t,e){let[s,i]=this.ends(),n=e*(i-s)/
(this.canvas.getBoundingClientRect().width||1),a=null;for(let h of this.films??[])for(let r of h.events){if(r.kind==="end")continue;let c=Math.abs(r.t-t);c<=n&&
(!a||c<Math.abs(a.t-t))&&(a=r)}return a}draw(t,e,s){this.films=t;let{context:i,width:n,height:a}=I(this.canvas);this.keep();let[h,r]=this.ends(),c=w=>(w-h)/(r-h)*
n;i.clearRect(0,0,n,a);let p=15,d=(a-15)/t.length-p;t.forEach((w,m)=>{let v=p+m*(p+d);for(let{mode:k,from:M,wide:A}of Bi(w.phases,c,n)){let E=s.modes[k];i.fillStyle=
E,i.fillRect(M,v,A,d-2),this.named(i,s.mode_names[k],M,A,v,d-2,E,e)}w.duration<r&&(i.fillStyle=e.line,i.fillRect(Math.max(c(w.duration),0),v,n,d-2)),this.marks(
i,w,c,v,n,e),t.length>1&&(i.fillStyle=e.soft,i.font=`600 11px ${e.font}`,i.textAlign="left",i.fillText("AB"[m],1,v-4))});let u=z(r-h,n/60);i.fillStyle=e.soft,i.
font=`10.5px ${e.font}`;let f=q(h,r,n/60);for(let w of f){let m=c(w);i.textAlign=m<14?"left":m>n-14?"right":"center",i.fillText(B(w,u)+(w===f[0]?" s":""),m,a-3)}
let g=b(c(this.clock.time),6,n-6),y=b(c(this.clock.time),1,n-1);i.fillStyle=e.ink,i.fillRect(y-1,p-4,2,a-p-9),i.beginPath(),i.moveTo(g-6,p-10),i.lineTo(g+6,p-10),
i.lineTo(y,p-1),i.fill(),this.tell(t,s)}tell(t,e){let{time:s,duration:i,playing:n}=this.clock,h=t.map((r,c)=>{let p=e.mode_names[r.at(s).mode];return t.length>1?
`${"AB"[c]} ${p}`:p}).join(", ");n&&h===this.said||(this.said=h,this.element.setAttribute("aria-valuemax",i.toFixed(3)),this.element.setAttribute("aria-valuenow",
s.toFixed(3)),this.element.setAttribute("aria-valuetext",`${x(s,4)} seconds, ${h}`))}named(t,e,s,i,n,a,h,r){t.font=`11px ${r.font}`,!(a<13||t.measureText(e).width+
8>i)&&(t.fillStyle=Is(h),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*i,n+.5*a+1),t.textBaseline="alphabetic")}marks(t,e,s,i,n,a){t.font=`11px\
 ${a.font}`,t.textAlign="center";let h=e.events.filter(({kind:r})=>r!=="start"&&r!=="end").map(({kind:r,t:c})=>({kind:r,x:s(c)})).filter(({x:r})=>r>=-1&&r<=n+1);
if(t.fillStyle=a.panel,h.length<n/6)for(let{x:r}of h)t.fillRect(r-.5,i,1,5);t.fillStyle=a.ink;for(let{mark:r,x:c}of Fi(h))t.fillText(r,b(c,6,n-6),i-4)}};var An=1/60,Pn=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],_n={three:"In space"},st=(o,t,e)=>l(
"button",{type:"button",title:t,"aria-label":t,onclick:e},o),Di=(o,t)=>l("span",{},l("span",{"aria-hidden":"true"},`${o} `),t),Pe=class{constructor(t,e,s,i,n){this.
clock=t,this.films=e,this.say=i,this.tell=n,this.playButton=st(L("play"),"Play (space)",()=>t.play()),this.playButton.classList.add("play"),this.speeds=l("selec\
t",{"aria-label":"Speed of the film",onchange:()=>{t.speed=Number(this.speeds.value)}},St.map(a=>l("option",{value:String(a)},`${a}×`))),this.speeds.value="1",
this.switches=new Map(Pn.map(([a,h,r])=>{let c=`${a==="three"?_n.three:h} (${r})`;return[a,l("button",{type:"button",class:"switch",title:c,onclick:()=>s(a)},h)]})),
this.element=l("div",{class:"transport"},l("div",{class:"buttons"},st(L("start"),"To the start (Home)",()=>t.seek(0)),st(L("previous"),"Previous event (Shift ←)",
()=>this.jump(-1)),st(L("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,st(L("on"),"One frame on (→)",()=>this.nudge(1)),st(L("next"),"Next\
 event (Shift →)",()=>this.jump(1))),l("div",{class:"buttons jumps"},st(Di("▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),st(Di("▼","l\
anding"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,l("div",{class:"buttons switches"},[...this.switches.values()]))}show(t){let{clock:e,
playButton:s}=this;for(let[n,a]of this.switches)a.setAttribute("aria-pressed",String(t[n]));let i=e.playing?"Pause (space)":"Play (space)";(s.title!==i||!s.firstChild)&&
(s.replaceChildren(L(e.playing?"pause":"play")),s.title=i,s.setAttribute("aria-label",i)),this.speeds.value!==String(e.speed)&&(this.speeds.value=String(e.speed))}nudge(t){
this.clock.playing=!1,this.clock.seek(this.clock.time+t*An*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap((c,p)=>c.
events.map(d=>({event:d,lane:p}))).filter(({event:c})=>!e||(e==="impact"?c.kind===e:Oi(c))).sort((c,p)=>c.event.t-p.event.t),i=this.clock.time,n=t>0?s.find(({event:c})=>c.
t>i+1e-9):s.findLast(({event:c})=>c.t<i-1e-9);if(!n&&e&&(n=s[0]),!n){e&&this.say(e==="takeoff"?"This motion has no flight.":"This motion has no landing.");return}
this.clock.seek(n.event.t);let{event:a,lane:h}=n,r=this.films().length>1?`Hoop ${"AB"[h]}: `:"";this.tell(`${r}${Se[a.kind]??a.kind} at ${P(a.angle)}, ${x(a.t,4)}\
 s`)}};var Nt=class{constructor(t,e,s,{hosted:i=!1,panels:n=null,onmotion:a=()=>{}}={}){this.root=t,this.backend=e,this.hosted=i,this.onmotion=a,this.prepareRoot();let{
colors:h}=s;this.known=s.presets,this.address=i?new Dt(this):null,this.clock=new Wt,this.motions=new de(e,{shown:r=>this.changed(r),settled:()=>this.story.announce(
this.films()),noted:r=>this.noted(r),travelled:async r=>this.address?.travel(r),failed:(r,c)=>this.failed(r,c)}),this.notice=new ue,this.theme=new re(t,h,i,()=>this.
show()),this.stage=new ke(h,()=>{this.request(),this.address?.soon()}),this.transport=new Pe(this.clock,()=>this.films(),r=>this.toggle(r),r=>this.notice.say(r),
r=>this.story.say(r)),this.timeline=new Ae(this.clock),this.story=new Me(this.clock),this.theory=new Te,this.plots=new me(this.clock,h),this.phase=new fe(e,this.
clock,h),this.map=new ce(e,s,{take:r=>{this.clock.time=0,this.motions.change(r,!0)},say:r=>this.story.say(r),changed:()=>this.address?.soon()}),this.controls=new Yt(
s.controls,(r,c)=>this.motions.change(r,c)),this.share=new ge(this),this.singleKeys=new he(i),this.help=oi(s.version,h,this.singleKeys.element),this.hoops=new ae(
r=>this.motions.choose(r)),this.header=new ne(s.presets,this.share.menu,{take:r=>this.take(r),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.
motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(n),this.extras=new oe(this),this.requested=!1,this.surrounding=!1,this.
taken=null,this.afterFrame=null,this.asked=null,this.later=U(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=this.frame.bind(this),this.clock.
listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=ri(this,i),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){this.
root.classList.add("hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts=
"true")}layOut(t){let{root:e,notice:s}=this,i=p=>!t||t.includes(p),n=l("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.
element),a=l("div",{class:"player"},this.stage.element,this.timeline.element,this.transport.element);this.sticky=this.hosted?Mi(a,()=>this.request()):null;let h=l(
"a",{class:"skip button",href:"#hh-player"},"Skip to the player");h.onclick=p=>{p.preventDefault(),this.timeline.element.focus()};let r=l("div",{class:"middle"},
this.sticky?.edge,a,l("div",{class:"words"},this.story.element,i("theory")&&this.theory.element),i("map")&&this.map.element),c=l("div",{class:"why"},i("plots")&&
this.plots.element,i("plots")&&this.phase.element);e.replaceChildren(l("div",{class:"page"},this.hosted&&h,this.header.element,l("div",{class:"columns"},i("cont\
rols")&&n,r,c)),s.toast,this.share.dialog,this.help),e.classList.toggle("no-controls",!i("controls"))}async open(t,e={}){await this.motions.load(t),this.clock.duration=
Math.max(...this.films().map(s=>s.duration)),this.restore(e),this.begin()}begin(){this.show(),this.motions.note(),this.sizes.observe(this.stage.element),this.root.
dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.map.close(),this.theme.close(),this.address?.close(),this.sticky?.
close(),this.sizes.disconnect(),this.deaf()}film(t=this.motions.active){return this.motions.film(t)}films(){return this.motions.films()}changed(t=null){this.notice.
clear(),this.show(t)}failed(t,e=[]){this.controls.refuse(e,t.message)||(this.notice.fail(t),this.controls.restore()),this.showPreset()}noted(t){this.header.show(
this.motions.history,this.motions.lanes.length>1),this.address?.write(t),this.onmotion(this.film().query)}link(){let{clock:t,stage:e,map:s}=this;return this.motions.
link(Ls({time:t.time,options:e.options,zoom:e.flat.zoom,map:s.shown()}))}restore({time:t,options:e,zoom:s,map:i}){if(e){let{three:n,...a}=e;Object.assign(this.stage.
options,a),n&&this.toggle("three")}s&&(this.stage.flat.zoom=s),i&&this.map.restore(i),t&&this.clock.seek(t)}showPreset(){let{query:t}=this.film(),e=this.known.find(
s=>s.query===t);this.header.presets.value=e?.key??"",this.hoops.text.textContent=e?.text??""}async take(t){this.taken=t;try{let e=await this.backend.call("film",
{query:t.query});if(this.taken!==t)return;this.clock.time=0,this.motions.replace(e),this.story.announce(this.films())}catch(e){this.failed(e)}}travel(t){return this.
motions.travel(t)}show(t=null){let{motions:e,clock:s}=this,i=this.films();if(!i.length)return;let n=i.length>1;this.theme.read(),s.duration=Math.max(...i.map(a=>a.
duration)),s.time=Math.min(s.time,s.duration),this.root.classList.toggle("two",n),this.header.show(e.history,n),this.hoops.show(i.length,e.active),this.drawStage(),
this.controls.show(this.film(),this.motions.waiting()),this.showPreset(),t!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-
t),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let t=this.
films(),{active:e}=this.motions,{look:s,colors:i}=this.theme;this.plots.draw(t,e,s),this.phase.draw(t,e,s),this.story.draw(t,e,i),this.drawTime(),this.map.mark(
this.film(),s),this.stage.describe(t),this.extras.changed(),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){
let{time:t}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(t),this.phase.cursor(t),this.story.
cursor(t),this.transport.show(this.stage.options))}request(){this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){this.requested=!1,this.
motions.lanes.length&&(this.clock.tick(t),this.drawStage(),this.drawTime(),this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){
let{scenario:t}=this.film();this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked;try{let s=await this.backend.call("theory",{scenario:t},
e);this.theory.draw(s.header.thresholds,this.motions.name()),await this.phase.fetch(t,e)}catch(s){let{name:i,message:n}=s;i!=="AbortError"&&this.theory.draw([{label:"\
–",text:n}])}}toggle(t){let{options:e}=this.stage;if(t!=="three")e[t]=!e[t];else try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}
this.transport.show(e),this.address?.soon(),this.request()}};async function In(o){let t=new URL("./",document.baseURI.split(/[?#]/)[0]),e=new Ht(t),s;try{s=(await e.call("setup",{})).header}catch(h){o.textContent=h.message;
return}let i=new Nt(o,e,s,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let n=new URLSearchParams(location.hash.slice(1)).get("with"),a=Ns(location.hash);
try{await i.open([location.search.slice(1),...n===null?[]:[n]],a)}catch(h){history.replaceState(null,"",t),await i.open([""]),i.notice.fail(h)}}function $n({model:o,
el:t}){let e=document.createElement("div");t.append(e);let s=new qt(o),i=new Nt(e,s,o.get("setup"),{panels:o.get("panels"),onmotion:a=>{o.get("query")!==a&&(o.set(
"query",a),o.save_changes())}});i.motions.set([ft(o.get("film"))]),i.begin();let n=()=>i.motions.replace(ft(o.get("film")));return o.on("change:film",n),()=>{o.
off("change:film",n),s.close(),i.close()}}var Hi=document.getElementById("hophoop-lab");Hi&&In(Hi);var Gl={render:$n};export{Gl as default};
