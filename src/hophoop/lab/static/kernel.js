/* Built from web/kernel/worker.js by esbuild 0.28.2; sources f8b462284512e9dc230206a33ae575e5 */
var r={sources:"315defddb4bcdcd88bdeb7750285b666",module:"f555452be29eacee",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring",
"damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy",
"omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain",
"collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_norm\
al","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],compliant:["law","friction_law","stiffness","damping","rest\
itution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","bristle"],chosen:["stiffness","tangen\
tial_stiffness","slip_speed","depth","stiffness_si","slip_speed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_friction","n\
eeded_friction_angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","massless_\
loss_by_friction"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","takeoff_t\
ime","takeoff_angle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","hop","pa\
inleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{
angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,
status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,
takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undet\
ermined","event_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stic\
k","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:[
"no","yes"],painleve:["no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start",
"slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","\
rest","end"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var k=n=>Object.fromEntries(n.map((e,t)=>[e,t])),ae=k(r.cell),y=k(r.heads),p=k(r.events),O=k(r.samples),M=k(r.numbers),S=k(r.words),U={newton:0,poisson:1,stronge:2};
function v(n){let e=new Float64Array(r.cell.length),t={...Object.fromEntries(Object.entries(n).filter(([,s])=>typeof s=="number")),law:U[n.impact_law],strike:+(n.
painleve==="impact"),ideal:Number(n.ideal),allowed:1};return r.cell.forEach((s,o)=>{e[o]=t[s]??0}),e}function N(n){let e=t=>t??Number.NaN;return Float64Array.of(
r.laws.indexOf(n.law),r.friction_laws.indexOf(n.friction),e(n.stiffness),e(n.damping),e(n.restitution),e(n.slip_speed),e(n.tangential_stiffness),e(n.rtol))}var x=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var W=150,B=240,D=6e3,[fe,R,F]=[0,1,2],P={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["friction_\
force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal","d\
amping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function A(n,e,t){let{rows:s,count:o,duration:i}=e,[a,l]=(t??[0,i]).map(d=>Math.
min(Math.max(d,0),i)),c=Math.min(Math.max(Math.ceil((l-a)*W),B),D),m=r.events.length,f=new Set;for(let d=0;d<=c&&i>0;d++)f.add(d===c?l:a+d*((l-a)/c));let _=new Set;
for(let d=0;d<o;d++){let h=Math.min(s[d*m+p.t],i);h>=a&&h<=l&&_.add(h)}for(let d of _)f.add(d);let g=Float64Array.from(f).sort(),b=Float64Array.from(_).filter(d=>d>
0).sort(),w=n.states(e,g,!1),u=n.states(e,b,!0);return V(g,w,b,u)}function V(n,e,t,s){let o=n.length+t.length,i=r.samples.length,a=new Float64Array(o),l=new Float64Array(
o*i),c=0,m=0;for(let _=0;_<n.length;_++)m<t.length&&t[m]<=n[_]&&(a[c]=t[m],l.set(s.subarray(m*i,(m+1)*i),c*i),c++,m++),a[c]=n[_],l.set(e.subarray(_*i,(_+1)*i),c*
i),c++;let f={t:a};for(let[_,g]of Object.entries(P)){let b=new Float64Array(o);for(let w of g)for(let u=0;u<o;u++)b[u]+=l[u*i+O[w]];f[_]=b}return f.mode=C(l,o,f.
omega),f}function C(n,e,t){let s=r.samples.length,o=new Float64Array(e),i=0;for(let a=e-1;a>=0&&!i;a--)i=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){i=Math.sign(
t[a])||i;let l=n[a*s+O.mode],c=l===R?-1:l===F?1:0;o[a]=c===0?l:c*i<0?R:F}return o}function T(n,e){let t=new Map,s=new Float64Array(e);for(let o=0;o<e;o++){let i=$(n.subarray(o*r.keys,(o+1)*r.keys));if(i===""){s[o]=Number.NaN;continue}let a=t.
get(i);a===void 0&&(a=t.size,t.set(i,a)),s[o]=a}return{values:s,sequences:[...t.keys()]}}function $(n){let e="";for(let t of n){let s=t;for(let o=0;o<r.letters_a_key&&
s;o++){let i=Number(s&7n);s>>=3n,i&&(e+=i===r.more?"+":r.letters[i-1])}}return e}var G=256,H=2048,K=4096,J=2e5,Q=r.statuses.indexOf("buffer"),X=new Set(["turn","apex","kane_gain","rest"]),j=n=>Number.isFinite(n)?n:null,E=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new x(this.exports),this.mostEvents=G,this.mostSegments=H,this.mostRows=
K}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=r.events.length;for(;;){let o=t.
room("table",8*s*this.mostEvents),i=t.room("heads",8*r.heads.length);e.contact?this.computeCompliant(e,e.contact,o,i):this.computeRigid(e,o,i);let a=t.floats(i,
r.heads.length).slice(),l=a[y.events];if(a[y.status]===Q)this.makeRoom(e,a[y.segments]);else if(l===this.mostEvents&&l<e.max_events)this.mostEvents*=4;else{let c=t.
floats(o,l*s).slice();return{given:e,head:a,rows:c,count:l,duration:a[y.duration],segments:a[y.segments]}}}}computeRigid(e,t,s){let{memory:o}=this,i=o.put("cell",
v(e)),a=o.room("events",r.event_bytes*this.mostEvents),l=o.room("segments",r.segment_bytes*this.mostSegments);this.call("motion",i,a,this.mostEvents,l,this.mostSegments,
t,s)}computeCompliant(e,t,s,o){let{memory:i}=this,a=i.put("cell",v(e)),l=i.put("contact",N(t)),c=i.room("events",r.event_bytes*this.mostEvents),m=i.room("rows",
r.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,l,c,this.mostEvents,J,m,this.mostRows,s,o)}makeRoom(e,t){e.contact?this.mostRows=t:this.
mostSegments*=4}motion(e){return I(this.compute(e))}film(e){let t=this.compute(e);return{motion:I(t),columns:A(this,t)}}columns(e,t){return A(this,this.compute(
e),t)}samples(e,t){let s=this.states(this.compute(e),t,!1),o=r.samples.length;return Object.fromEntries(r.samples.map((i,a)=>[i,Float64Array.from(t,(l,c)=>s[c*o+
a])]))}states(e,t,s){let{memory:o}=this,i=t.length*r.samples.length,a=o.put("times",t),l=o.room("states",8*Math.max(i,1)),c=o.room("cell",8),m=[e.segments,a,t.length,
Number(s),l];return e.given.contact?this.call("compliant_samples",c,o.room("contact",8),o.room("rows",8),...m):this.call("samples",c,o.room("segments",8),...m),
o.floats(l,i).slice()}thresholds(e){let{memory:t}=this,s=t.put("cell",v(e)),o=t.room("answers",8*r.thresholds.length),i=e.rolling&&e.angle===0;this.call("thresh\
olds",s,i?e.vx:Number.NaN,o);let a=t.floats(o,r.thresholds.length),l=m=>{let f=a[r.thresholds.indexOf(m)];return Number.isNaN(f)?null:f},c=["jam_angle","jam_ang\
le_2","jam_angle_3","jam_angle_4"].map(l);return{first_slip_speed:l("first_slip_speed"),first_hop_speed:l("first_hop_speed"),immediate_hop_speed:l("immediate_ho\
p_speed"),needed_friction:l("needed_friction"),painleve_friction:l("painleve_friction"),painleve_angle:l("painleve_angle"),jam_angles:c.filter(m=>m!==null),stable_angle:l(
"stable_angle"),massless_loss_angle:l("massless_loss_angle"),massless_loss_by_friction:l("massless_loss_by_friction")===1}}regions(e,[t,s,o,i],a,l){let{memory:c}=this,
m=c.put("cell",v(e)),f=c.room("modes",a*l),_=c.room("sides",a);this.call("regions",m,t,s,o,i,a,l,f,_);let{buffer:g}=this.exports.memory;return{modes:new Uint8Array(
g,f,a*l).slice(),paradox:Float32Array.from(new Int8Array(g,_,a))}}map({count:e,rows:t},s,o){let{memory:i}=this,a=i.put("cells",t),l=i.room("numbers",8*e*r.numbers.
length),c=i.room("words",4*e*r.words.length),m=i.room("keys",8*e*r.keys),{angle:f,stop:_,timed:g}=r.spans[o],b=r.wanted[s];this.call("map_cells",a,e,f??Number.NaN,
_,g,b,l,c,m);let{buffer:w}=this.exports.memory;if(s==="sequence")return T(new BigUint64Array(w,m,e*r.keys),e);let u=new Float64Array(e);if(s in S){let d=new Int32Array(
w,c,e*r.words.length);for(let h=0;h<e;h++)u[h]=d[h*r.words.length+S[s]]}else{let d=i.floats(l,e*r.numbers.length);for(let h=0;h<e;h++)u[h]=d[h*r.numbers.length+
M[s]]}return{values:u}}ideal(e){let t=this.memory.room("answers",8*r.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}resistance(e,t){
let s=this.memory.room("answers",8*r.thresholds.length);return this.call("resistance_limit",e,t,s),this.memory.floats(s,1)[0]}combine(e,t){let{memory:s}=this,o=s.
put("parts",t.flatMap(Y)),i=s.room("answers",8*r.thresholds.length),a=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,o,t.length,i,a);let[l,c,m]=s.floats(
i,3);return{mass:l,eccentricity:c,inertia_ratio:m,reaches:[...s.floats(a,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError("The con\
tact is rigid.");let s=t.put("cell",v(e)),o=t.put("contact",N(e.contact)),i=t.room("answers",8*r.thresholds.length);this.call("compliance",s,o,i);let a=t.floats(
i,r.chosen.length),l=c=>a[r.chosen.indexOf(c)];return{stiffness:l("stiffness"),tangential_stiffness:l("tangential_stiffness"),slip_speed:l("slip_speed"),depth:l(
"depth"),automatic:{stiffness:l("stiffness_si"),slip_speed:l("slip_speed_si")}}}};function Y(n){let e=n.shape==="rod"?`${n.direction}_rod`:n.shape,t=r.shapes.indexOf(
e);return n.shape==="ring"?[t,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[t,n.mass,n.radius,0,n.at]:n.shape==="rod"?[t,n.mass,n.length,0,n.at]:[t,
n.mass,0,0,n.at]}var Z=["friction","impact_normal","impact_tangential","rolling_resistance"],ee=["kinetic","potential",...Z,"residual"],L=["x","height","angle",
"vx","vy","omega"];function I({given:n,head:e,rows:t,count:s,duration:o}){let i=r.events.length,a=Array.from({length:s},(m,f)=>te(t.subarray(f*i,(f+1)*i))),l=a[s-
1],c=Object.fromEntries([...ee,...n.contact?["spring","damping"]:[]].map(m=>[m,e[y[m]]]));return{status:r.statuses[e[y.status]],sequence:se(a),duration:o,events:a,
final:{t:l.t,mode:l.to,...Object.fromEntries(L.map(m=>[m,l[m]]))},energy:c,doubt:j(e[y.doubt_from])}}function te(n){let e=r.kinds[n[p.kind]],t=n[p.from_mode],s={
t:n[p.t],kind:e,from:t<0?null:r.letters[t],to:r.letters[n[p.to_mode]]};for(let o of L)s[o]=j(n[p[o]]);return s.before=Object.fromEntries(["vx","vy","omega"].map(
o=>[o,j(n[p[`before_${o}`]])])),s.impulse={normal:n[p.impulse_normal],tangential:n[p.impulse_tangential]},n[p.collision]===0&&(s.collision=!1),e==="kane_gain"&&
(s.gain=n[p.gain]),n[p.stable]>=0&&(s.stable=n[p.stable]===1),s}function se(n){let e=n.filter(s=>!X.has(s.kind));return e.slice(0,-1).map((s,o)=>e[o+1].t>s.t?s.
to:"").join("")||(n.at(-1)?.to??"")}var z;function ne(n){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(n),
[...e]}function oe({data:{number:n,compiled:e,call:t,values:s}}){try{if(e){z=new E(e);return}let o=z[t](...s);self.postMessage({number:n,answer:o},{transfer:ne(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",oe);export{E as HoopModule};
