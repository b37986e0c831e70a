/* Built from web/kernel/worker.js by esbuild 0.28.2; sources 59c86f40b1562ec42e5c454291ad3c75 */
var l={sources:"c0fa79aaac480a8f2c68c98c9184ac4f",module:"65e4c4697ce8a3e5",derivatives:"d16ee3949ca73fc6",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"\
0.17.1"},cell:["radius","mass","eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy",
"omega","slip","duration","max_events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels",
"kinetic","potential","spring","damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode",
"x","height","angle","vx","vy","omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_norm\
al","impact_tangential","gain","collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal\
_force","friction","impact_normal","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],margins:["normal_force","fri\
ction_force","friction_limit","free_acceleration","slip","height","p_sigma"],changes:["t","x","height","angle","omega","slip","vy","impact_normal","impact_tange\
ntial","rolling_resistance","vx"],reasons:["none","graze","border","plastic","contact","singular","massless","frictionless","ended"],compliant:["law","friction_\
law","stiffness","damping","restitution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","brist\
le"],chosen:["stiffness","tangential_stiffness","slip_speed","depth","stiffness_si","slip_speed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate\
_hop_speed","needed_friction","needed_friction_angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle",
"massless_loss_angle","massless_loss_by_friction"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling","energy_lost","\
greatest_utilization","takeoff_time","takeoff_angle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:["status",
"ending","first_event","hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","even\
t_limit"],spans:{first_revolution:{angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,
stop:0,timed:1}},wanted:{sequence:0,status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,
energy_lost:0,greatest_utilization:2,takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:[
"completed","at_rest","jammed","undetermined","event_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:[
"start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain",
"skim","rest","end"],hop:["no","yes"],painleve:["no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","sec\
ond","at"],kinds:["start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate",
"jam","kane_gain","skim","rest","end"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,
compliant_segment_bytes:536};var v=o=>Object.fromEntries(o.map((e,t)=>[e,t])),ae=v(l.cell),y=v(l.heads),d=v(l.events),O=v(l.samples),le=v(l.changes),M=v(l.numbers),S=v(l.words),U={newton:0,
poisson:1,stronge:2};function k(o){let e=new Float64Array(l.cell.length),t={...Object.fromEntries(Object.entries(o).filter(([,s])=>typeof s=="number")),law:U[o.
impact_law],strike:+(o.painleve==="impact"),ideal:Number(o.ideal),allowed:1};return l.cell.forEach((s,n)=>{e[n]=t[s]??0}),e}function A(o){let e=t=>t??Number.NaN;
return Float64Array.of(l.laws.indexOf(o.law),l.friction_laws.indexOf(o.friction),e(o.stiffness),e(o.damping),e(o.restitution),e(o.slip_speed),e(o.tangential_stiffness),
e(o.rtol))}var x=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let n=this.exports.malloc(t);if(!n)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:n,bytes:t}),
n}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var W=150,B=240,C=6e3,[he,R,F]=[0,1,2],D={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["friction_\
force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal","d\
amping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function N(o,e,t){let{rows:s,count:n,duration:r}=e,[i,a]=(t??[0,r]).map(p=>Math.
min(Math.max(p,0),r)),c=Math.min(Math.max(Math.ceil((a-i)*W),B),C),m=l.events.length,f=new Set;for(let p=0;p<=c&&r>0;p++)f.add(p===c?a:i+p*((a-i)/c));let h=new Set;
for(let p=0;p<n;p++){let _=Math.min(s[p*m+d.t],r);_>=i&&_<=a&&h.add(_)}for(let p of h)f.add(p);let g=Float64Array.from(f).sort(),b=Float64Array.from(h).filter(p=>p>
0).sort(),w=o.states(e,g,!1),u=o.states(e,b,!0);return P(g,w,b,u)}function P(o,e,t,s){let n=o.length+t.length,r=l.samples.length,i=new Float64Array(n),a=new Float64Array(
n*r),c=0,m=0;for(let h=0;h<o.length;h++)m<t.length&&t[m]<=o[h]&&(i[c]=t[m],a.set(s.subarray(m*r,(m+1)*r),c*r),c++,m++),i[c]=o[h],a.set(e.subarray(h*r,(h+1)*r),c*
r),c++;let f={t:i};for(let[h,g]of Object.entries(D)){let b=new Float64Array(n);for(let w of g)for(let u=0;u<n;u++)b[u]+=a[u*r+O[w]];f[h]=b}return f.mode=V(a,n,f.
omega),f}function V(o,e,t){let s=l.samples.length,n=new Float64Array(e),r=0;for(let i=e-1;i>=0&&!r;i--)r=Math.sign(t[i])||0;for(let i=e-1;i>=0;i--){r=Math.sign(
t[i])||r;let a=o[i*s+O.mode],c=a===R?-1:a===F?1:0;n[i]=c===0?a:c*r<0?R:F}return n}function T(o,e){let t=new Map,s=new Float64Array(e);for(let n=0;n<e;n++){let r=G(o.subarray(n*l.keys,(n+1)*l.keys));if(r===""){s[n]=Number.NaN;continue}let i=t.
get(r);i===void 0&&(i=t.size,t.set(r,i)),s[n]=i}return{values:s,sequences:[...t.keys()]}}function G(o){let e="";for(let t of o){let s=t;for(let n=0;n<l.letters_a_key&&
s;n++){let r=Number(s&7n);s>>=3n,r&&(e+=r===l.more?"+":l.letters[r-1])}}return e}var H=256,$=2048,K=4096,J=2e5,Q=l.statuses.indexOf("buffer"),X=new Set(["turn","apex","kane_gain","rest"]),j=o=>Number.isFinite(o)?o:null,E=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new x(this.exports),this.mostEvents=H,this.mostSegments=$,this.mostRows=
K}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=l.events.length;for(;;){let n=t.
room("table",8*s*this.mostEvents),r=t.room("heads",8*l.heads.length);e.contact?this.computeCompliant(e,e.contact,n,r):this.computeRigid(e,n,r);let i=t.floats(r,
l.heads.length).slice(),a=i[y.events];if(i[y.status]===Q)this.makeRoom(e,i[y.segments]);else if(a===this.mostEvents&&a<e.max_events)this.mostEvents*=4;else{let c=t.
floats(n,a*s).slice();return{given:e,head:i,rows:c,count:a,duration:i[y.duration],segments:i[y.segments]}}}}computeRigid(e,t,s){let{memory:n}=this,r=n.put("cell",
k(e)),i=n.room("events",l.event_bytes*this.mostEvents),a=n.room("segments",l.segment_bytes*this.mostSegments);this.call("motion",r,i,this.mostEvents,a,this.mostSegments,
t,s)}computeCompliant(e,t,s,n){let{memory:r}=this,i=r.put("cell",k(e)),a=r.put("contact",A(t)),c=r.room("events",l.event_bytes*this.mostEvents),m=r.room("rows",
l.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",i,a,c,this.mostEvents,J,m,this.mostRows,s,n)}makeRoom(e,t){e.contact?this.mostRows=t:this.
mostSegments*=4}motion(e){return z(this.compute(e))}film(e){let t=this.compute(e);return{motion:z(t),columns:N(this,t)}}columns(e,t){return N(this,this.compute(
e),t)}samples(e,t){let s=this.states(this.compute(e),t,!1),n=l.samples.length;return Object.fromEntries(l.samples.map((r,i)=>[r,Float64Array.from(t,(a,c)=>s[c*n+
i])]))}states(e,t,s){return this.rows("samples",l.samples.length,e,t,s)}margins(e,t,s=!1){if(e.contact)throw new TypeError("A compliant contact has no such rule\
s.");let n=l.margins.length,r=this.rows("margins",n,this.compute(e),t,s);return Object.fromEntries(l.margins.map((i,a)=>[i,Float64Array.from(t,(c,m)=>r[m*n+a])]))}rows(e,t,s,n,r){
let{memory:i}=this,a=n.length*t,c=i.put("times",n),m=i.room("states",8*Math.max(a,1)),f=i.room("cell",8),h=[s.segments,c,n.length,Number(r),m];return s.given.contact?
this.call("compliant_samples",f,i.room("contact",8),i.room("rows",8),...h):this.call(e,f,i.room("segments",8),...h),i.floats(m,a).slice()}changes(e,t){let{memory:s}=this,
n=this.compute(e),r=s.put("rates",t),i=this.side(n,r,1),{reason:a,sided:c}=i,m=c||a==="border"||a==="contact"?this.side(n,r,-1):i;return{count:n.count,larger:i,
smaller:m}}side({count:e,segments:t,head:s},n,r){let{memory:i}=this,a=e*l.changes.length,c=i.room("changes",8*a),m=i.room("why",16),[f,h,g]=["cell","events","se\
gments"].map(p=>i.room(p,8)),b=s[y.doubt_from];this.call("changes",f,n,1,r,h,e,g,t,b,c,m);let[w,u]=i.floats(m,2);return{rates:i.floats(c,a).slice(),reason:l.reasons[Math.
max(w,0)],sided:w<0,failed:u}}thresholds(e){let{memory:t}=this,s=t.put("cell",k(e)),n=t.room("answers",8*l.thresholds.length),r=e.rolling&&e.angle===0;this.call(
"thresholds",s,r?e.vx:Number.NaN,n);let i=t.floats(n,l.thresholds.length),a=m=>{let f=i[l.thresholds.indexOf(m)];return Number.isNaN(f)?null:f},c=["jam_angle","\
jam_angle_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a("first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immed\
iate_hop_speed"),needed_friction:a("needed_friction"),painleve_friction:a("painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:c.filter(m=>m!==null),
stable_angle:a("stable_angle"),massless_loss_angle:a("massless_loss_angle"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(e,[t,s,n,r],i,a){
let{memory:c}=this,m=c.put("cell",k(e)),f=c.room("modes",i*a),h=c.room("sides",i);this.call("regions",m,t,s,n,r,i,a,f,h);let{buffer:g}=this.exports.memory;return{
modes:new Uint8Array(g,f,i*a).slice(),paradox:Float32Array.from(new Int8Array(g,h,i))}}map({count:e,rows:t},s,n){let{memory:r}=this,i=r.put("cells",t),a=r.room(
"numbers",8*e*l.numbers.length),c=r.room("words",4*e*l.words.length),m=r.room("keys",8*e*l.keys),{angle:f,stop:h,timed:g}=l.spans[n],b=l.wanted[s];this.call("ma\
p_cells",i,e,f??Number.NaN,h,g,b,a,c,m);let{buffer:w}=this.exports.memory;if(s==="sequence")return T(new BigUint64Array(w,m,e*l.keys),e);let u=new Float64Array(
e);if(s in S){let p=new Int32Array(w,c,e*l.words.length);for(let _=0;_<e;_++)u[_]=p[_*l.words.length+S[s]]}else{let p=r.floats(a,e*l.numbers.length);for(let _=0;_<
e;_++)u[_]=p[_*l.numbers.length+M[s]]}return{values:u}}ideal(e){let t=this.memory.room("answers",8*l.thresholds.length);return this.call("ideal_hoop",e,t),this.
memory.floats(t,1)[0]}resistance(e,t){let s=this.memory.room("answers",8*l.thresholds.length);return this.call("resistance_limit",e,t,s),this.memory.floats(s,1)[0]}combine(e,t){
let{memory:s}=this,n=s.put("parts",t.flatMap(Y)),r=s.room("answers",8*l.thresholds.length),i=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,n,t.length,
r,i);let[a,c,m]=s.floats(r,3);return{mass:a,eccentricity:c,inertia_ratio:m,reaches:[...s.floats(i,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError(
"The contact is rigid.");let s=t.put("cell",k(e)),n=t.put("contact",A(e.contact)),r=t.room("answers",8*l.thresholds.length);this.call("compliance",s,n,r);let i=t.
floats(r,l.chosen.length),a=c=>i[l.chosen.indexOf(c)];return{stiffness:a("stiffness"),tangential_stiffness:a("tangential_stiffness"),slip_speed:a("slip_speed"),
depth:a("depth"),automatic:{stiffness:a("stiffness_si"),slip_speed:a("slip_speed_si")}}}};function Y(o){let e=o.shape==="rod"?`${o.direction}_rod`:o.shape,t=l.shapes.
indexOf(e);return o.shape==="ring"?[t,o.mass,o.inner_radius,o.outer_radius,0]:o.shape==="disk"?[t,o.mass,o.radius,0,o.at]:o.shape==="rod"?[t,o.mass,o.length,0,o.
at]:[t,o.mass,0,0,o.at]}var Z=["friction","impact_normal","impact_tangential","rolling_resistance"],ee=["kinetic","potential",...Z,"residual"],I=["x","height","\
angle","vx","vy","omega"];function z({given:o,head:e,rows:t,count:s,duration:n}){let r=l.events.length,i=Array.from({length:s},(m,f)=>te(t.subarray(f*r,(f+1)*r))),
a=i[s-1],c=Object.fromEntries([...ee,...o.contact?["spring","damping"]:[]].map(m=>[m,e[y[m]]]));return{status:l.statuses[e[y.status]],sequence:se(i),duration:n,
events:i,final:{t:a.t,mode:a.to,...Object.fromEntries(I.map(m=>[m,a[m]]))},energy:c,doubt:j(e[y.doubt_from])}}function te(o){let e=l.kinds[o[d.kind]],t=o[d.from_mode],
s={t:o[d.t],kind:e,from:t<0?null:l.letters[t],to:l.letters[o[d.to_mode]]};for(let n of I)s[n]=j(o[d[n]]);return s.before=Object.fromEntries(["vx","vy","omega"].
map(n=>[n,j(o[d[`before_${n}`]])])),s.impulse={normal:o[d.impulse_normal],tangential:o[d.impulse_tangential]},o[d.collision]===0&&(s.collision=!1),e==="kane_gai\
n"&&(s.gain=o[d.gain]),o[d.stable]>=0&&(s.stable=o[d.stable]===1),s}function se(o){let e=o.filter(s=>!X.has(s.kind));return e.slice(0,-1).map((s,n)=>e[n+1].t>s.
t?s.to:"").join("")||(o.at(-1)?.to??"")}var L;function ne(o){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(o),
[...e]}function oe({data:{number:o,compiled:e,call:t,values:s}}){try{if(e){L=new E(e);return}let n=L[t](...s);self.postMessage({number:o,answer:n},{transfer:ne(
n)})}catch(n){self.postMessage({number:o,error:n.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",oe);export{E as HoopModule};
