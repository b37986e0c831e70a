/* Built from web/kernel/worker.js by esbuild 0.28.2; sources c298d0a4cc0fdbad021bfdaa1de1744d */
var a={sources:"72e72e5aa934b66c019fcb7ce5587d12",module:"37887952927e21e1",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
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
rest","end"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var k=n=>Object.fromEntries(n.map((e,t)=>[e,t])),ae=k(a.cell),y=k(a.heads),d=k(a.events),O=k(a.samples),M=k(a.numbers),S=k(a.words),U={newton:0,poisson:1,stronge:2};
function v(n){let e=new Float64Array(a.cell.length),t={...Object.fromEntries(Object.entries(n).filter(([,s])=>typeof s=="number")),law:U[n.impact_law],strike:+(n.
painleve==="impact"),ideal:Number(n.ideal),allowed:1};return a.cell.forEach((s,o)=>{e[o]=t[s]??0}),e}function N(n){let e=t=>t??Number.NaN;return Float64Array.of(
a.laws.indexOf(n.law),a.friction_laws.indexOf(n.friction),e(n.stiffness),e(n.damping),e(n.restitution),e(n.slip_speed),e(n.tangential_stiffness),e(n.rtol))}var x=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var W=150,B=240,D=6e3,[fe,R,F]=[0,1,2],P={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["friction_\
force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal","d\
amping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function A(n,e,t){let{rows:s,count:o,duration:i}=e,[l,r]=(t??[0,i]).map(p=>Math.
min(Math.max(p,0),i)),c=Math.min(Math.max(Math.ceil((r-l)*W),B),D),m=a.events.length,f=new Set;for(let p=0;p<=c&&i>0;p++)f.add(p===c?r:l+p*((r-l)/c));let _=new Set;
for(let p=0;p<o;p++){let h=Math.min(s[p*m+d.t],i);h>=l&&h<=r&&_.add(h)}for(let p of _)f.add(p);let g=Float64Array.from(f).sort(),b=Float64Array.from(_).filter(p=>p>
0).sort(),w=n.states(e,g,!1),u=n.states(e,b,!0);return V(g,w,b,u)}function V(n,e,t,s){let o=n.length+t.length,i=a.samples.length,l=new Float64Array(o),r=new Float64Array(
o*i),c=0,m=0;for(let _=0;_<n.length;_++)m<t.length&&t[m]<=n[_]&&(l[c]=t[m],r.set(s.subarray(m*i,(m+1)*i),c*i),c++,m++),l[c]=n[_],r.set(e.subarray(_*i,(_+1)*i),c*
i),c++;let f={t:l};for(let[_,g]of Object.entries(P)){let b=new Float64Array(o);for(let w of g)for(let u=0;u<o;u++)b[u]+=r[u*i+O[w]];f[_]=b}return f.mode=C(r,o,f.
omega),f}function C(n,e,t){let s=a.samples.length,o=new Float64Array(e),i=0;for(let l=e-1;l>=0&&!i;l--)i=Math.sign(t[l])||0;for(let l=e-1;l>=0;l--){i=Math.sign(
t[l])||i;let r=n[l*s+O.mode],c=r===R?-1:r===F?1:0;o[l]=c===0?r:c*i<0?R:F}return o}function T(n,e){let t=new Map,s=new Float64Array(e);for(let o=0;o<e;o++){let i=$(n.subarray(o*a.keys,(o+1)*a.keys));if(i===""){s[o]=Number.NaN;continue}let l=t.
get(i);l===void 0&&(l=t.size,t.set(i,l)),s[o]=l}return{values:s,sequences:[...t.keys()]}}function $(n){let e="";for(let t of n){let s=t;for(let o=0;o<a.letters_a_key&&
s;o++){let i=Number(s&7n);s>>=3n,i&&(e+=i===a.more?"+":a.letters[i-1])}}return e}var G=256,H=2048,K=4096,J=2e5,Q=a.statuses.indexOf("buffer"),X=new Set(["turn","apex","kane_gain","rest"]),j=n=>Number.isFinite(n)?n:null,E=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new x(this.exports),this.mostEvents=G,this.mostSegments=H,this.mostRows=
K}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=a.events.length;for(;;){let o=t.
room("table",8*s*this.mostEvents),i=t.room("heads",8*a.heads.length);e.contact?this.computeCompliant(e,e.contact,o,i):this.computeRigid(e,o,i);let l=t.floats(i,
a.heads.length).slice(),r=l[y.events];if(l[y.status]===Q)this.makeRoom(e,l[y.segments]);else if(r===this.mostEvents&&r<e.max_events)this.mostEvents*=4;else{let c=t.
floats(o,r*s).slice();return{given:e,head:l,rows:c,count:r,duration:l[y.duration],segments:l[y.segments]}}}}computeRigid(e,t,s){let{memory:o}=this,i=o.put("cell",
v(e)),l=o.room("events",a.event_bytes*this.mostEvents),r=o.room("segments",a.segment_bytes*this.mostSegments);this.call("motion",i,l,this.mostEvents,r,this.mostSegments,
t,s)}computeCompliant(e,t,s,o){let{memory:i}=this,l=i.put("cell",v(e)),r=i.put("contact",N(t)),c=i.room("events",a.event_bytes*this.mostEvents),m=i.room("rows",
a.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",l,r,c,this.mostEvents,J,m,this.mostRows,s,o)}makeRoom(e,t){e.contact?this.mostRows=t:this.
mostSegments*=4}motion(e){return I(this.compute(e))}film(e){let t=this.compute(e);return{motion:I(t),columns:A(this,t)}}columns(e,t){return A(this,this.compute(
e),t)}samples(e,t){let s=this.states(this.compute(e),t,!1),o=a.samples.length;return Object.fromEntries(a.samples.map((i,l)=>[i,Float64Array.from(t,(r,c)=>s[c*o+
l])]))}states(e,t,s){let{memory:o}=this,i=t.length*a.samples.length,l=o.put("times",t),r=o.room("states",8*Math.max(i,1)),c=o.room("cell",8),m=[e.segments,l,t.length,
Number(s),r];return e.given.contact?this.call("compliant_samples",c,o.room("contact",8),o.room("rows",8),...m):this.call("samples",c,o.room("segments",8),...m),
o.floats(r,i).slice()}thresholds(e){let{memory:t}=this,s=t.put("cell",v(e)),o=t.room("answers",8*a.thresholds.length),i=e.rolling&&e.angle===0;this.call("thresh\
olds",s,i?e.vx:Number.NaN,o);let l=t.floats(o,a.thresholds.length),r=m=>{let f=l[a.thresholds.indexOf(m)];return Number.isNaN(f)?null:f},c=["jam_angle","jam_ang\
le_2","jam_angle_3","jam_angle_4"].map(r);return{first_slip_speed:r("first_slip_speed"),first_hop_speed:r("first_hop_speed"),immediate_hop_speed:r("immediate_ho\
p_speed"),needed_friction:r("needed_friction"),painleve_friction:r("painleve_friction"),painleve_angle:r("painleve_angle"),jam_angles:c.filter(m=>m!==null),stable_angle:r(
"stable_angle"),massless_loss_angle:r("massless_loss_angle"),massless_loss_by_friction:r("massless_loss_by_friction")===1}}regions(e,[t,s,o,i],l,r){let{memory:c}=this,
m=c.put("cell",v(e)),f=c.room("modes",l*r),_=c.room("sides",l);this.call("regions",m,t,s,o,i,l,r,f,_);let{buffer:g}=this.exports.memory;return{modes:new Uint8Array(
g,f,l*r).slice(),paradox:Float32Array.from(new Int8Array(g,_,l))}}map({count:e,rows:t},s,o){let{memory:i}=this,l=i.put("cells",t),r=i.room("numbers",8*e*a.numbers.
length),c=i.room("words",4*e*a.words.length),m=i.room("keys",8*e*a.keys),{angle:f,stop:_,timed:g}=a.spans[o],b=a.wanted[s];this.call("map_cells",l,e,f??Number.NaN,
_,g,b,r,c,m);let{buffer:w}=this.exports.memory;if(s==="sequence")return T(new BigUint64Array(w,m,e*a.keys),e);let u=new Float64Array(e);if(s in S){let p=new Int32Array(
w,c,e*a.words.length);for(let h=0;h<e;h++)u[h]=p[h*a.words.length+S[s]]}else{let p=i.floats(r,e*a.numbers.length);for(let h=0;h<e;h++)u[h]=p[h*a.numbers.length+
M[s]]}return{values:u}}ideal(e){let t=this.memory.room("answers",8*a.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}resistance(e,t){
let s=this.memory.room("answers",8*a.thresholds.length);return this.call("resistance_limit",e,t,s),this.memory.floats(s,1)[0]}combine(e,t){let{memory:s}=this,o=s.
put("parts",t.flatMap(Y)),i=s.room("answers",8*a.thresholds.length),l=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,o,t.length,i,l);let[r,c,m]=s.floats(
i,3);return{mass:r,eccentricity:c,inertia_ratio:m,reaches:[...s.floats(l,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError("The con\
tact is rigid.");let s=t.put("cell",v(e)),o=t.put("contact",N(e.contact)),i=t.room("answers",8*a.thresholds.length);this.call("compliance",s,o,i);let l=t.floats(
i,a.chosen.length),r=c=>l[a.chosen.indexOf(c)];return{stiffness:r("stiffness"),tangential_stiffness:r("tangential_stiffness"),slip_speed:r("slip_speed"),depth:r(
"depth"),steps:r("steps"),automatic:{stiffness:r("stiffness_si"),slip_speed:r("slip_speed_si")}}}};function Y(n){let e=n.shape==="rod"?`${n.direction}_rod`:n.shape,
t=a.shapes.indexOf(e);return n.shape==="ring"?[t,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[t,n.mass,n.radius,0,n.at]:n.shape==="rod"?[t,n.mass,n.
length,0,n.at]:[t,n.mass,0,0,n.at]}var Z=["friction","impact_normal","impact_tangential","rolling_resistance"],ee=["kinetic","potential",...Z,"residual"],L=["x",
"height","angle","vx","vy","omega"];function I({given:n,head:e,rows:t,count:s,duration:o}){let i=a.events.length,l=Array.from({length:s},(m,f)=>te(t.subarray(f*
i,(f+1)*i))),r=l[s-1],c=Object.fromEntries([...ee,...n.contact?["spring","damping"]:[]].map(m=>[m,e[y[m]]]));return{status:a.statuses[e[y.status]],sequence:se(l),
duration:o,events:l,final:{t:r.t,mode:r.to,...Object.fromEntries(L.map(m=>[m,r[m]]))},energy:c,doubt:j(e[y.doubt_from])}}function te(n){let e=a.kinds[n[d.kind]],
t=n[d.from_mode],s={t:n[d.t],kind:e,from:t<0?null:a.letters[t],to:a.letters[n[d.to_mode]]};for(let o of L)s[o]=j(n[d[o]]);return s.before=Object.fromEntries(["v\
x","vy","omega"].map(o=>[o,j(n[d[`before_${o}`]])])),s.impulse={normal:n[d.impulse_normal],tangential:n[d.impulse_tangential]},n[d.collision]===0&&(s.collision=
!1),e==="kane_gain"&&(s.gain=n[d.gain]),n[d.stable]>=0&&(s.stable=n[d.stable]===1),s}function se(n){let e=n.filter(s=>!X.has(s.kind));return e.slice(0,-1).map((s,o)=>e[o+
1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var z;function ne(n){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(n),
[...e]}function oe({data:{number:n,compiled:e,call:t,values:s}}){try{if(e){z=new E(e);return}let o=z[t](...s);self.postMessage({number:n,answer:o},{transfer:ne(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",oe);export{E as HoopModule};
