/* Built from web/kernel/worker.js by esbuild 0.28.2; sources d2703717c302a1f32f45467b26989783 */
var l={sources:"6a3d7043856754545b5468ccb5e9d281",module:"56c516c525c24606",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring",
"damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy",
"omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain",
"collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_norm\
al","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],compliant:["law","friction_law","stiffness","damping","rest\
itution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","bristle"],chosen:["stiffness","tangen\
tial_stiffness","slip_speed","depth","steps","stiffness_si","slip_speed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_fric\
tion","needed_friction_angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","m\
assless_loss_by_friction"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","t\
akeoff_time","takeoff_angle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","\
hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{
angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,
status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,
takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undet\
ermined","event_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stic\
k","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:[
"no","yes"],painleve:["no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start",
"slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","\
rest","end"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var b=o=>Object.fromEntries(o.map((e,t)=>[e,t])),le=b(l.cell),u=b(l.heads),d=b(l.events),O=b(l.samples),M=b(l.numbers),S=b(l.words),U={newton:0,poisson:1,stronge:2};
function w(o){let e=new Float64Array(l.cell.length),t={...Object.fromEntries(Object.entries(o).filter(([,s])=>typeof s=="number")),law:U[o.impact_law],strike:+(o.
painleve==="impact"),ideal:Number(o.ideal),allowed:1};return l.cell.forEach((s,n)=>{e[n]=t[s]??0}),e}function N(o){let e=t=>t??Number.NaN;return Float64Array.of(
l.laws.indexOf(o.law),l.friction_laws.indexOf(o.friction),e(o.stiffness),e(o.damping),e(o.restitution),e(o.slip_speed),e(o.tangential_stiffness),e(o.rtol))}var k=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let n=this.exports.malloc(t);if(!n)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:n,bytes:t}),
n}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var W=150,B=240,D=6e3,[fe,R,F]=[0,1,2],P={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["friction_\
force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal","d\
amping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function A(o,e){let{rows:t,count:s,duration:n}=e,i=Math.min(Math.max(Math.ceil(n*
W),B),D),a=l.events.length,r=new Set;for(let p=0;p<=i&&n>0;p++)r.add(p===i?n:p*(n/i));let c=new Set;for(let p=0;p<s;p++)c.add(Math.min(t[p*a+d.t],n));for(let p of c)
r.add(p);let m=Float64Array.from(r).sort(),f=Float64Array.from(c).filter(p=>p>0).sort(),_=o.states(e,m,!1),g=o.states(e,f,!0);return V(m,_,f,g)}function V(o,e,t,s){
let n=o.length+t.length,i=l.samples.length,a=new Float64Array(n),r=new Float64Array(n*i),c=0,m=0;for(let _=0;_<o.length;_++)m<t.length&&t[m]<=o[_]&&(a[c]=t[m],r.
set(s.subarray(m*i,(m+1)*i),c*i),c++,m++),a[c]=o[_],r.set(e.subarray(_*i,(_+1)*i),c*i),c++;let f={t:a};for(let[_,g]of Object.entries(P)){let p=new Float64Array(
n);for(let v of g)for(let y=0;y<n;y++)p[y]+=r[y*i+O[v]];f[_]=p}return f.mode=C(r,n,f.omega),f}function C(o,e,t){let s=l.samples.length,n=new Float64Array(e),i=0;
for(let a=e-1;a>=0&&!i;a--)i=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){i=Math.sign(t[a])||i;let r=o[a*s+O.mode],c=r===R?-1:r===F?1:0;n[a]=c===0?r:c*i<0?R:F}return n}function T(o,e){let t=new Map,s=new Float64Array(e);for(let n=0;n<e;n++){let i=$(o.subarray(n*l.keys,(n+1)*l.keys));if(i===""){s[n]=Number.NaN;continue}let a=t.
get(i);a===void 0&&(a=t.size,t.set(i,a)),s[n]=a}return{values:s,sequences:[...t.keys()]}}function $(o){let e="";for(let t of o){let s=t;for(let n=0;n<l.letters_a_key&&
s;n++){let i=Number(s&7n);s>>=3n,i&&(e+=i===l.more?"+":l.letters[i-1])}}return e}var G=256,H=2048,K=4096,J=2e5,Q=l.statuses.indexOf("buffer"),X=new Set(["turn","apex","kane_gain","rest"]),j=o=>Number.isFinite(o)?o:null,x=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new k(this.exports),this.mostEvents=G,this.mostSegments=H,this.mostRows=
K}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=l.events.length;for(;;){let n=t.
room("table",8*s*this.mostEvents),i=t.room("heads",8*l.heads.length);e.contact?this.computeCompliant(e,e.contact,n,i):this.computeRigid(e,n,i);let a=t.floats(i,
l.heads.length).slice(),r=a[u.events];if(a[u.status]===Q)this.makeRoom(e,a[u.segments]);else if(r===this.mostEvents&&r<e.max_events)this.mostEvents*=4;else{let c=t.
floats(n,r*s).slice();return{given:e,head:a,rows:c,count:r,duration:a[u.duration],segments:a[u.segments]}}}}computeRigid(e,t,s){let{memory:n}=this,i=n.put("cell",
w(e)),a=n.room("events",l.event_bytes*this.mostEvents),r=n.room("segments",l.segment_bytes*this.mostSegments);this.call("motion",i,a,this.mostEvents,r,this.mostSegments,
t,s)}computeCompliant(e,t,s,n){let{memory:i}=this,a=i.put("cell",w(e)),r=i.put("contact",N(t)),c=i.room("events",l.event_bytes*this.mostEvents),m=i.room("rows",
l.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,r,c,this.mostEvents,J,m,this.mostRows,s,n)}makeRoom(e,t){e.contact?this.mostRows=t:this.
mostSegments*=4}motion(e){return I(this.compute(e))}film(e){let t=this.compute(e);return{motion:I(t),columns:A(this,t)}}columns(e){return A(this,this.compute(e))}samples(e,t){
let s=this.states(this.compute(e),t,!1),n=l.samples.length;return Object.fromEntries(l.samples.map((i,a)=>[i,Float64Array.from(t,(r,c)=>s[c*n+a])]))}states(e,t,s){
let{memory:n}=this,i=t.length*l.samples.length,a=n.put("times",t),r=n.room("states",8*Math.max(i,1)),c=n.room("cell",8),m=[e.segments,a,t.length,Number(s),r];return e.
given.contact?this.call("compliant_samples",c,n.room("contact",8),n.room("rows",8),...m):this.call("samples",c,n.room("segments",8),...m),n.floats(r,i).slice()}thresholds(e){
let{memory:t}=this,s=t.put("cell",w(e)),n=t.room("answers",8*l.thresholds.length),i=e.rolling&&e.angle===0;this.call("thresholds",s,i?e.vx:Number.NaN,n);let a=t.
floats(n,l.thresholds.length),r=m=>{let f=a[l.thresholds.indexOf(m)];return Number.isNaN(f)?null:f},c=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(
r);return{first_slip_speed:r("first_slip_speed"),first_hop_speed:r("first_hop_speed"),immediate_hop_speed:r("immediate_hop_speed"),needed_friction:r("needed_fri\
ction"),painleve_friction:r("painleve_friction"),painleve_angle:r("painleve_angle"),jam_angles:c.filter(m=>m!==null),stable_angle:r("stable_angle"),massless_loss_angle:r(
"massless_loss_angle"),massless_loss_by_friction:r("massless_loss_by_friction")===1}}regions(e,[t,s,n,i],a,r){let{memory:c}=this,m=c.put("cell",w(e)),f=c.room("\
modes",a*r),_=c.room("sides",a);this.call("regions",m,t,s,n,i,a,r,f,_);let{buffer:g}=this.exports.memory;return{modes:new Uint8Array(g,f,a*r).slice(),paradox:Float32Array.
from(new Int8Array(g,_,a))}}map({count:e,rows:t},s,n){let{memory:i}=this,a=i.put("cells",t),r=i.room("numbers",8*e*l.numbers.length),c=i.room("words",4*e*l.words.
length),m=i.room("keys",8*e*l.keys),{angle:f,stop:_,timed:g}=l.spans[n],p=l.wanted[s];this.call("map_cells",a,e,f??Number.NaN,_,g,p,r,c,m);let{buffer:v}=this.exports.
memory;if(s==="sequence")return T(new BigUint64Array(v,m,e*l.keys),e);let y=new Float64Array(e);if(s in S){let E=new Int32Array(v,c,e*l.words.length);for(let h=0;h<
e;h++)y[h]=E[h*l.words.length+S[s]]}else{let E=i.floats(r,e*l.numbers.length);for(let h=0;h<e;h++)y[h]=E[h*l.numbers.length+M[s]]}return{values:y}}ideal(e){let t=this.
memory.room("answers",8*l.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}combine(e,t){let{memory:s}=this,n=s.put("parts",t.flatMap(
Y)),i=s.room("answers",8*l.thresholds.length),a=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,n,t.length,i,a);let[r,c,m]=s.floats(i,3);return{mass:r,
eccentricity:c,inertia_ratio:m,reaches:[...s.floats(a,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError("The contact is rigid.");let s=t.
put("cell",w(e)),n=t.put("contact",N(e.contact)),i=t.room("answers",8*l.thresholds.length);this.call("compliance",s,n,i);let a=t.floats(i,l.chosen.length),r=c=>a[l.
chosen.indexOf(c)];return{stiffness:r("stiffness"),tangential_stiffness:r("tangential_stiffness"),slip_speed:r("slip_speed"),depth:r("depth"),steps:r("steps"),automatic:{
stiffness:r("stiffness_si"),slip_speed:r("slip_speed_si")}}}};function Y(o){let e=o.shape==="rod"?`${o.direction}_rod`:o.shape,t=l.shapes.indexOf(e);return o.shape===
"ring"?[t,o.mass,o.inner_radius,o.outer_radius,0]:o.shape==="disk"?[t,o.mass,o.radius,0,o.at]:o.shape==="rod"?[t,o.mass,o.length,0,o.at]:[t,o.mass,0,0,o.at]}var Z=[
"friction","impact_normal","impact_tangential","rolling_resistance"],ee=["kinetic","potential",...Z,"residual"],L=["x","height","angle","vx","vy","omega"];function I({
given:o,head:e,rows:t,count:s,duration:n}){let i=l.events.length,a=Array.from({length:s},(m,f)=>te(t.subarray(f*i,(f+1)*i))),r=a[s-1],c=Object.fromEntries([...ee,
...o.contact?["spring","damping"]:[]].map(m=>[m,e[u[m]]]));return{status:l.statuses[e[u.status]],sequence:se(a),duration:n,events:a,final:{t:r.t,mode:r.to,...Object.
fromEntries(L.map(m=>[m,r[m]]))},energy:c,doubt:j(e[u.doubt_from])}}function te(o){let e=l.kinds[o[d.kind]],t=o[d.from_mode],s={t:o[d.t],kind:e,from:t<0?null:l.
letters[t],to:l.letters[o[d.to_mode]]};for(let n of L)s[n]=j(o[d[n]]);return s.before=Object.fromEntries(["vx","vy","omega"].map(n=>[n,j(o[d[`before_${n}`]])])),
s.impulse={normal:o[d.impulse_normal],tangential:o[d.impulse_tangential]},o[d.collision]===0&&(s.collision=!1),e==="kane_gain"&&(s.gain=o[d.gain]),o[d.stable]>=
0&&(s.stable=o[d.stable]===1),s}function se(o){let e=o.filter(s=>!X.has(s.kind));return e.slice(0,-1).map((s,n)=>e[n+1].t>s.t?s.to:"").join("")||(o.at(-1)?.to??
"")}var z;function ne(o){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(o),
[...e]}function oe({data:{number:o,compiled:e,call:t,values:s}}){try{if(e){z=new x(e);return}let n=z[t](...s);self.postMessage({number:o,answer:n},{transfer:ne(
n)})}catch(n){self.postMessage({number:o,error:n.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",oe);export{x as HoopModule};
