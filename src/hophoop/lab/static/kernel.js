/* Built from web/kernel/worker.js by esbuild 0.28.2; sources 30dcb82328cced9e9fdb30ca9d4e585b */
var r={sources:"aa53a6a497f806ac85cdb28ab7197be8",module:"0b4d02ef87ab1218",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring","damping","friction",
"impact_normal","impact_tangential","residual"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy","omega","slip","before_vx","before_vy","\
before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain","collision","stable"],samples:["mode","x",
"height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_normal","impact_tangential","spring","damping","kinetic","potential",
"utilization"],compliant:["law","friction_law","stiffness","damping","restitution","slip_speed","tangential_stiffness","rtol"],chosen:["stiffness","slip_speed"],
thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_friction","needed_friction_angle","painleve_friction","painleve_angle","jam_angle",
"jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","massless_loss_by_friction"],numbers:["time","end_angle","end_speed","distance","\
distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","takeoff_time","takeoff_angle","hop_height","flight_time","flight_distance","land\
ing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolution\
s","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},
reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,
end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,
flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undetermined","event_limit"],ending:["duration","revolutions","\
reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounc\
e_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:["no","yes"],painleve:["no","yes"]},shapes:["ring","disk","\
point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start","slip_start","stick","slip_reversal","takeoff","impact","t\
urn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],letters:"RSKHM",statuses:["completed","at_res\
t","jammed","undetermined","event_limit","buffer"],event_bytes:224,segment_bytes:248,compliant_segment_bytes:488};var b=n=>Object.fromEntries(n.map((e,t)=>[e,t])),se=b(r.cell),y=b(r.heads),p=b(r.events),A=b(r.samples),S=b(r.numbers),j=b(r.words),q={newton:0,poisson:1,stronge:2};
function k(n){let e=new Float64Array(r.cell.length),t={...Object.fromEntries(Object.entries(n).filter(([,s])=>typeof s=="number")),law:q[n.impact_law],strike:+(n.
painleve==="impact"),ideal:Number(n.ideal),allowed:1};return r.cell.forEach((s,o)=>{e[o]=t[s]??0}),e}var w=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var U=150,B=240,D=6e3,[ie,M,F]=[0,1,2],V={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["friction_\
force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal","d\
amping"],utilization:["utilization"]};function O(n,e){let{rows:t,count:s,duration:o}=e,i=Math.min(Math.max(Math.ceil(o*U),B),D),a=r.events.length,l=new Set;for(let _=0;_<=
i&&o>0;_++)l.add(_===i?o:_*(o/i));let m=new Set;for(let _=0;_<s;_++)m.add(Math.min(t[_*a+p.t],o));for(let _ of m)l.add(_);let c=Float64Array.from(l).sort(),f=Float64Array.
from(m).filter(_=>_>0).sort(),d=n.states(e,c,!1),u=n.states(e,f,!0);return W(c,d,f,u)}function W(n,e,t,s){let o=n.length+t.length,i=r.samples.length,a=new Float64Array(
o),l=new Float64Array(o*i),m=0,c=0;for(let d=0;d<n.length;d++)c<t.length&&t[c]<=n[d]&&(a[m]=t[c],l.set(s.subarray(c*i,(c+1)*i),m*i),m++,c++),a[m]=n[d],l.set(e.subarray(
d*i,(d+1)*i),m*i),m++;let f={t:a};for(let[d,u]of Object.entries(V)){let _=new Float64Array(o);for(let v of u)for(let g=0;g<o;g++)_[g]+=l[g*i+A[v]];f[d]=_}return f.
mode=P(l,o,f.omega),f}function P(n,e,t){let s=r.samples.length,o=new Float64Array(e),i=0;for(let a=e-1;a>=0&&!i;a--)i=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){
i=Math.sign(t[a])||i;let l=n[a*s+A.mode],m=l===M?-1:l===F?1:0;o[a]=m===0?l:m*i<0?M:F}return o}function T(n,e){let t=new Map,s=new Float64Array(e);for(let o=0;o<e;o++){let i=$(n.subarray(o*r.keys,(o+1)*r.keys));if(i===""){s[o]=Number.NaN;continue}let a=t.
get(i);a===void 0&&(a=t.size,t.set(i,a)),s[o]=a}return{values:s,sequences:[...t.keys()]}}function $(n){let e="";for(let t of n){let s=t;for(let o=0;o<r.letters_a_key&&
s;o++){let i=Number(s&7n);s>>=3n,i&&(e+=i===r.more?"+":r.letters[i-1])}}return e}var H=256,C=2048,G=r.statuses.indexOf("buffer"),K=new Set(["turn","apex","kane_gain","rest"]),N=n=>Number.isFinite(n)?n:null,x=class{constructor(e){this.exports=
new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new w(this.exports),this.mostEvents=H,this.mostSegments=C}call(e,...t){let s=this.
exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=t.put("cell",k(e)),o=r.events.length;for(;;){let i=t.room(
"events",r.event_bytes*this.mostEvents),a=t.room("segments",r.segment_bytes*this.mostSegments),l=t.room("table",8*o*this.mostEvents),m=t.room("heads",8*r.heads.
length);this.call("motion",s,i,this.mostEvents,a,this.mostSegments,l,m);let c=t.floats(m,r.heads.length).slice(),f=c[y.events];if(c[y.status]===G)this.mostSegments*=
4;else if(f===this.mostEvents&&f<e.max_events)this.mostEvents*=4;else{let d=t.floats(l,f*o).slice();return{given:e,head:c,rows:d,count:f,duration:c[y.duration],
segments:c[y.segments]}}}}motion(e){return R(this.compute(e))}film(e){let t=this.compute(e);return{motion:R(t),columns:O(this,t)}}columns(e){return O(this,this.
compute(e))}samples(e,t){let s=this.states(this.compute(e),t,!1),o=r.samples.length;return Object.fromEntries(r.samples.map((i,a)=>[i,Float64Array.from(t,(l,m)=>s[m*
o+a])]))}states(e,t,s){let{memory:o}=this,i=t.length*r.samples.length,a=o.put("times",t),l=o.room("states",8*Math.max(i,1)),m=o.room("segments",r.segment_bytes),
c=o.room("cell",8);return this.call("samples",c,m,e.segments,a,t.length,Number(s),l),o.floats(l,i).slice()}thresholds(e){let{memory:t}=this,s=t.put("cell",k(e)),
o=t.room("answers",8*r.thresholds.length),i=e.rolling&&e.angle===0;this.call("thresholds",s,i?e.vx:Number.NaN,o);let a=t.floats(o,r.thresholds.length),l=c=>{let f=a[r.
thresholds.indexOf(c)];return Number.isNaN(f)?null:f},m=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(l);return{first_slip_speed:l("first_slip_spe\
ed"),first_hop_speed:l("first_hop_speed"),immediate_hop_speed:l("immediate_hop_speed"),needed_friction:l("needed_friction"),painleve_friction:l("painleve_fricti\
on"),painleve_angle:l("painleve_angle"),jam_angles:m.filter(c=>c!==null),stable_angle:l("stable_angle"),massless_loss_angle:l("massless_loss_angle"),massless_loss_by_friction:l(
"massless_loss_by_friction")===1}}regions(e,[t,s,o,i],a,l){let{memory:m}=this,c=m.put("cell",k(e)),f=m.room("modes",a*l),d=m.room("sides",a);this.call("regions",
c,t,s,o,i,a,l,f,d);let{buffer:u}=this.exports.memory;return{modes:new Uint8Array(u,f,a*l).slice(),paradox:Float32Array.from(new Int8Array(u,d,a))}}map({count:e,
rows:t},s,o){let{memory:i}=this,a=i.put("cells",t),l=i.room("numbers",8*e*r.numbers.length),m=i.room("words",4*e*r.words.length),c=i.room("keys",8*e*r.keys),{angle:f,
stop:d,timed:u}=r.spans[o],_=r.wanted[s];this.call("map_cells",a,e,f??Number.NaN,d,u,_,l,m,c);let{buffer:v}=this.exports.memory;if(s==="sequence")return T(new BigUint64Array(
v,c,e*r.keys),e);let g=new Float64Array(e);if(s in j){let E=new Int32Array(v,m,e*r.words.length);for(let h=0;h<e;h++)g[h]=E[h*r.words.length+j[s]]}else{let E=i.
floats(l,e*r.numbers.length);for(let h=0;h<e;h++)g[h]=E[h*r.numbers.length+S[s]]}return{values:g}}ideal(e){let t=this.memory.room("answers",8*r.thresholds.length);
return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}combine(e,t){let{memory:s}=this,o=s.put("parts",t.flatMap(J)),i=s.room("answers",8*r.thresholds.length),
a=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,o,t.length,i,a);let[l,m,c]=s.floats(i,3);return{mass:l,eccentricity:m,inertia_ratio:c,reaches:[...s.floats(
a,t.length)]}}};function J(n){let e=n.shape==="rod"?`${n.direction}_rod`:n.shape,t=r.shapes.indexOf(e);return n.shape==="ring"?[t,n.mass,n.inner_radius,n.outer_radius,
0]:n.shape==="disk"?[t,n.mass,n.radius,0,n.at]:n.shape==="rod"?[t,n.mass,n.length,0,n.at]:[t,n.mass,0,0,n.at]}var L=["x","height","angle","vx","vy","omega"];function R({
head:n,rows:e,count:t,duration:s}){let o=r.events.length,i=Array.from({length:t},(m,c)=>Q(e.subarray(c*o,(c+1)*o))),a=i[t-1],l=Object.fromEntries(["kinetic","po\
tential","friction","impact_normal","impact_tangential","residual"].map(m=>[m,n[y[m]]]));return{status:r.statuses[n[y.status]],sequence:X(i),duration:s,events:i,
final:{t:a.t,mode:a.to,...Object.fromEntries(L.map(m=>[m,a[m]]))},energy:l,doubt:N(n[y.doubt_from])}}function Q(n){let e=r.kinds[n[p.kind]],t=n[p.from_mode],s={
t:n[p.t],kind:e,from:t<0?null:r.letters[t],to:r.letters[n[p.to_mode]]};for(let o of L)s[o]=N(n[p[o]]);return s.before=Object.fromEntries(["vx","vy","omega"].map(
o=>[o,N(n[p[`before_${o}`]])])),s.impulse={normal:n[p.impulse_normal],tangential:n[p.impulse_tangential]},n[p.collision]===0&&(s.collision=!1),e==="kane_gain"&&
(s.gain=n[p.gain]),n[p.stable]>=0&&(s.stable=n[p.stable]===1),s}function X(n){let e=n.filter(s=>!K.has(s.kind));return e.slice(0,-1).map((s,o)=>e[o+1].t>s.t?s.to:
"").join("")||(n.at(-1)?.to??"")}var z;function Y(n){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(n),
[...e]}function Z({data:{number:n,compiled:e,call:t,values:s}}){try{if(e){z=new x(e);return}let o=z[t](...s);self.postMessage({number:n,answer:o},{transfer:Y(o)})}catch(o){
self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",Z);export{x as HoopModule};
