/* Built from web/kernel/worker.js by esbuild 0.28.2; sources a537727ddbb19fd621e74c78d941e5bf */
var a={sources:"b182e971f1528ff2d91b89283c1ac226",module:"d6ea5b32807b4629",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring",
"damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy",
"omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain",
"collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_norm\
al","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],margins:["normal_force","friction_force","friction_limit","\
free_acceleration","slip","height","p_sigma"],compliant:["law","friction_law","stiffness","damping","restitution","slip_speed","tangential_stiffness","rtol"],laws:[
"kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","bristle"],chosen:["stiffness","tangential_stiffness","slip_speed","depth","stiffness_si","slip_s\
peed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_friction","needed_friction_angle","painleve_friction","painleve_angle",
"jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","massless_loss_by_friction"],numbers:["time","end_angle","end_speed",
"distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","takeoff_time","takeoff_angle","hop_height","flight_time","flight_dis\
tance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration",
"revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,
stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,
end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,
flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undetermined","event_limit"],ending:["duration","revolutions","\
reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounc\
e_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:["no","yes"],painleve:["no","yes"]},shapes:["ring","disk","\
point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start","slip_start","stick","slip_reversal","takeoff","impact","t\
urn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],letters:"RSKHM",statuses:["completed","at_res\
t","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var k=n=>Object.fromEntries(n.map((e,t)=>[e,t])),ae=k(a.cell),y=k(a.heads),h=k(a.events),O=k(a.samples),M=k(a.numbers),S=k(a.words),U={newton:0,poisson:1,stronge:2};
function v(n){let e=new Float64Array(a.cell.length),t={...Object.fromEntries(Object.entries(n).filter(([,s])=>typeof s=="number")),law:U[n.impact_law],strike:+(n.
painleve==="impact"),ideal:Number(n.ideal),allowed:1};return a.cell.forEach((s,o)=>{e[o]=t[s]??0}),e}function A(n){let e=t=>t??Number.NaN;return Float64Array.of(
a.laws.indexOf(n.law),a.friction_laws.indexOf(n.friction),e(n.stiffness),e(n.damping),e(n.restitution),e(n.slip_speed),e(n.tangential_stiffness),e(n.rtol))}var x=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var W=150,B=240,D=6e3,[fe,R,F]=[0,1,2],P={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["friction_\
force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal","d\
amping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function N(n,e,t){let{rows:s,count:o,duration:r}=e,[i,l]=(t??[0,r]).map(p=>Math.
min(Math.max(p,0),r)),c=Math.min(Math.max(Math.ceil((l-i)*W),B),D),m=a.events.length,f=new Set;for(let p=0;p<=c&&r>0;p++)f.add(p===c?l:i+p*((l-i)/c));let _=new Set;
for(let p=0;p<o;p++){let d=Math.min(s[p*m+h.t],r);d>=i&&d<=l&&_.add(d)}for(let p of _)f.add(p);let g=Float64Array.from(f).sort(),b=Float64Array.from(_).filter(p=>p>
0).sort(),w=n.states(e,g,!1),u=n.states(e,b,!0);return V(g,w,b,u)}function V(n,e,t,s){let o=n.length+t.length,r=a.samples.length,i=new Float64Array(o),l=new Float64Array(
o*r),c=0,m=0;for(let _=0;_<n.length;_++)m<t.length&&t[m]<=n[_]&&(i[c]=t[m],l.set(s.subarray(m*r,(m+1)*r),c*r),c++,m++),i[c]=n[_],l.set(e.subarray(_*r,(_+1)*r),c*
r),c++;let f={t:i};for(let[_,g]of Object.entries(P)){let b=new Float64Array(o);for(let w of g)for(let u=0;u<o;u++)b[u]+=l[u*r+O[w]];f[_]=b}return f.mode=C(l,o,f.
omega),f}function C(n,e,t){let s=a.samples.length,o=new Float64Array(e),r=0;for(let i=e-1;i>=0&&!r;i--)r=Math.sign(t[i])||0;for(let i=e-1;i>=0;i--){r=Math.sign(
t[i])||r;let l=n[i*s+O.mode],c=l===R?-1:l===F?1:0;o[i]=c===0?l:c*r<0?R:F}return o}function T(n,e){let t=new Map,s=new Float64Array(e);for(let o=0;o<e;o++){let r=$(n.subarray(o*a.keys,(o+1)*a.keys));if(r===""){s[o]=Number.NaN;continue}let i=t.
get(r);i===void 0&&(i=t.size,t.set(r,i)),s[o]=i}return{values:s,sequences:[...t.keys()]}}function $(n){let e="";for(let t of n){let s=t;for(let o=0;o<a.letters_a_key&&
s;o++){let r=Number(s&7n);s>>=3n,r&&(e+=r===a.more?"+":a.letters[r-1])}}return e}var G=256,H=2048,K=4096,J=2e5,Q=a.statuses.indexOf("buffer"),X=new Set(["turn","apex","kane_gain","rest"]),j=n=>Number.isFinite(n)?n:null,E=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new x(this.exports),this.mostEvents=G,this.mostSegments=H,this.mostRows=
K}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=a.events.length;for(;;){let o=t.
room("table",8*s*this.mostEvents),r=t.room("heads",8*a.heads.length);e.contact?this.computeCompliant(e,e.contact,o,r):this.computeRigid(e,o,r);let i=t.floats(r,
a.heads.length).slice(),l=i[y.events];if(i[y.status]===Q)this.makeRoom(e,i[y.segments]);else if(l===this.mostEvents&&l<e.max_events)this.mostEvents*=4;else{let c=t.
floats(o,l*s).slice();return{given:e,head:i,rows:c,count:l,duration:i[y.duration],segments:i[y.segments]}}}}computeRigid(e,t,s){let{memory:o}=this,r=o.put("cell",
v(e)),i=o.room("events",a.event_bytes*this.mostEvents),l=o.room("segments",a.segment_bytes*this.mostSegments);this.call("motion",r,i,this.mostEvents,l,this.mostSegments,
t,s)}computeCompliant(e,t,s,o){let{memory:r}=this,i=r.put("cell",v(e)),l=r.put("contact",A(t)),c=r.room("events",a.event_bytes*this.mostEvents),m=r.room("rows",
a.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",i,l,c,this.mostEvents,J,m,this.mostRows,s,o)}makeRoom(e,t){e.contact?this.mostRows=t:this.
mostSegments*=4}motion(e){return I(this.compute(e))}film(e){let t=this.compute(e);return{motion:I(t),columns:N(this,t)}}columns(e,t){return N(this,this.compute(
e),t)}samples(e,t){let s=this.states(this.compute(e),t,!1),o=a.samples.length;return Object.fromEntries(a.samples.map((r,i)=>[r,Float64Array.from(t,(l,c)=>s[c*o+
i])]))}states(e,t,s){return this.rows("samples",a.samples.length,e,t,s)}margins(e,t,s=!1){if(e.contact)throw new TypeError("A compliant contact has no such rule\
s.");let o=a.margins.length,r=this.rows("margins",o,this.compute(e),t,s);return Object.fromEntries(a.margins.map((i,l)=>[i,Float64Array.from(t,(c,m)=>r[m*o+l])]))}rows(e,t,s,o,r){
let{memory:i}=this,l=o.length*t,c=i.put("times",o),m=i.room("states",8*Math.max(l,1)),f=i.room("cell",8),_=[s.segments,c,o.length,Number(r),m];return s.given.contact?
this.call("compliant_samples",f,i.room("contact",8),i.room("rows",8),..._):this.call(e,f,i.room("segments",8),..._),i.floats(m,l).slice()}thresholds(e){let{memory:t}=this,
s=t.put("cell",v(e)),o=t.room("answers",8*a.thresholds.length),r=e.rolling&&e.angle===0;this.call("thresholds",s,r?e.vx:Number.NaN,o);let i=t.floats(o,a.thresholds.
length),l=m=>{let f=i[a.thresholds.indexOf(m)];return Number.isNaN(f)?null:f},c=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(l);return{first_slip_speed:l(
"first_slip_speed"),first_hop_speed:l("first_hop_speed"),immediate_hop_speed:l("immediate_hop_speed"),needed_friction:l("needed_friction"),painleve_friction:l("\
painleve_friction"),painleve_angle:l("painleve_angle"),jam_angles:c.filter(m=>m!==null),stable_angle:l("stable_angle"),massless_loss_angle:l("massless_loss_angl\
e"),massless_loss_by_friction:l("massless_loss_by_friction")===1}}regions(e,[t,s,o,r],i,l){let{memory:c}=this,m=c.put("cell",v(e)),f=c.room("modes",i*l),_=c.room(
"sides",i);this.call("regions",m,t,s,o,r,i,l,f,_);let{buffer:g}=this.exports.memory;return{modes:new Uint8Array(g,f,i*l).slice(),paradox:Float32Array.from(new Int8Array(
g,_,i))}}map({count:e,rows:t},s,o){let{memory:r}=this,i=r.put("cells",t),l=r.room("numbers",8*e*a.numbers.length),c=r.room("words",4*e*a.words.length),m=r.room(
"keys",8*e*a.keys),{angle:f,stop:_,timed:g}=a.spans[o],b=a.wanted[s];this.call("map_cells",i,e,f??Number.NaN,_,g,b,l,c,m);let{buffer:w}=this.exports.memory;if(s===
"sequence")return T(new BigUint64Array(w,m,e*a.keys),e);let u=new Float64Array(e);if(s in S){let p=new Int32Array(w,c,e*a.words.length);for(let d=0;d<e;d++)u[d]=
p[d*a.words.length+S[s]]}else{let p=r.floats(l,e*a.numbers.length);for(let d=0;d<e;d++)u[d]=p[d*a.numbers.length+M[s]]}return{values:u}}ideal(e){let t=this.memory.
room("answers",8*a.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}resistance(e,t){let s=this.memory.room("answers",8*a.thresholds.
length);return this.call("resistance_limit",e,t,s),this.memory.floats(s,1)[0]}combine(e,t){let{memory:s}=this,o=s.put("parts",t.flatMap(Y)),r=s.room("answers",8*
a.thresholds.length),i=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,o,t.length,r,i);let[l,c,m]=s.floats(r,3);return{mass:l,eccentricity:c,inertia_ratio:m,
reaches:[...s.floats(i,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError("The contact is rigid.");let s=t.put("cell",v(e)),o=t.put(
"contact",A(e.contact)),r=t.room("answers",8*a.thresholds.length);this.call("compliance",s,o,r);let i=t.floats(r,a.chosen.length),l=c=>i[a.chosen.indexOf(c)];return{
stiffness:l("stiffness"),tangential_stiffness:l("tangential_stiffness"),slip_speed:l("slip_speed"),depth:l("depth"),automatic:{stiffness:l("stiffness_si"),slip_speed:l(
"slip_speed_si")}}}};function Y(n){let e=n.shape==="rod"?`${n.direction}_rod`:n.shape,t=a.shapes.indexOf(e);return n.shape==="ring"?[t,n.mass,n.inner_radius,n.outer_radius,
0]:n.shape==="disk"?[t,n.mass,n.radius,0,n.at]:n.shape==="rod"?[t,n.mass,n.length,0,n.at]:[t,n.mass,0,0,n.at]}var Z=["friction","impact_normal","impact_tangenti\
al","rolling_resistance"],ee=["kinetic","potential",...Z,"residual"],L=["x","height","angle","vx","vy","omega"];function I({given:n,head:e,rows:t,count:s,duration:o}){
let r=a.events.length,i=Array.from({length:s},(m,f)=>te(t.subarray(f*r,(f+1)*r))),l=i[s-1],c=Object.fromEntries([...ee,...n.contact?["spring","damping"]:[]].map(
m=>[m,e[y[m]]]));return{status:a.statuses[e[y.status]],sequence:se(i),duration:o,events:i,final:{t:l.t,mode:l.to,...Object.fromEntries(L.map(m=>[m,l[m]]))},energy:c,
doubt:j(e[y.doubt_from])}}function te(n){let e=a.kinds[n[h.kind]],t=n[h.from_mode],s={t:n[h.t],kind:e,from:t<0?null:a.letters[t],to:a.letters[n[h.to_mode]]};for(let o of L)
s[o]=j(n[h[o]]);return s.before=Object.fromEntries(["vx","vy","omega"].map(o=>[o,j(n[h[`before_${o}`]])])),s.impulse={normal:n[h.impulse_normal],tangential:n[h.
impulse_tangential]},n[h.collision]===0&&(s.collision=!1),e==="kane_gain"&&(s.gain=n[h.gain]),n[h.stable]>=0&&(s.stable=n[h.stable]===1),s}function se(n){let e=n.
filter(s=>!X.has(s.kind));return e.slice(0,-1).map((s,o)=>e[o+1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var z;function ne(n){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(n),
[...e]}function oe({data:{number:n,compiled:e,call:t,values:s}}){try{if(e){z=new E(e);return}let o=z[t](...s);self.postMessage({number:n,answer:o},{transfer:ne(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",oe);export{E as HoopModule};
