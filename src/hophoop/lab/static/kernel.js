/* Built from web/kernel/worker.ts by esbuild 0.28.2; sources eeec4168db5d45a2b63af4a94e74dadf */
var c={sources:"67265e6a6ce7c7c493ea343a4d7cb47b",module:"0be4fbd308f1e46d",derivatives:"caff7ba008cdc5ef",built_with:{numba:"0.68.1",llvmlite:"0.50.0",numpy:"2\
.4.6",ziglang:"0.17.1"},cell:["eccentricity","inertia_ratio","radius","mass","mu_static","mu_kinetic","slope","gravity","restitution","rolling_resistance","dura\
tion","max_events","law","strike","x","height","angle","vy","omega","slip","ideal","allowed"],heads:["status","events","segments","duration","doubt_from","doubt\
_until","panels","kinetic","potential","spring","damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","fr\
om_mode","to_mode","x","height","angle","vx","vy","omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","fri\
ction","impact_normal","impact_tangential","gain","collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","fric\
tion_force","normal_force","friction","impact_normal","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],margins:[
"normal_force","friction_force","friction_limit","free_acceleration","slip","height","p_sigma"],changes:["t","x","height","angle","omega","slip","vy","impact_no\
rmal","impact_tangential","rolling_resistance","vx"],reasons:["none","graze","border","plastic","contact","singular","massless","frictionless","ended"],compliant:[
"law","friction_law","stiffness","damping","restitution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh",
"linear","bristle"],chosen:["stiffness","tangential_stiffness","slip_speed","depth","stiffness_si","slip_speed_si"],thresholds:["first_slip_speed","first_hop_sp\
eed","immediate_hop_speed","needed_friction","needed_friction_angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4",
"stable_angle","massless_loss_angle","massless_loss_by_friction"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling",
"energy_lost","greatest_utilization","takeoff_time","takeoff_angle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:[
"status","ending","first_event","hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermin\
ed","event_limit"],spans:{first_revolution:{angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{
angle:null,stop:0,timed:1}},wanted:{sequence:0,status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,
energy_lost:0,greatest_utilization:2,takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:[
"completed","at_rest","jammed","undetermined","event_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:[
"start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain",
"skim","rest","end"],hop:["no","yes"],painleve:["no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","sec\
ond","at"],impact_laws:["newton","poisson","stronge"],kinds:["start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painl\
eve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],passing:["turn","apex","kane_gain","rest"],letters:"RSKHM",statuses:["complete\
d","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var E=n=>Object.fromEntries(n.map((e,t)=>[e,t])),je=E(c.cell),w=E(c.heads),m=E(c.events),O=E(c.samples),Re=E(c.changes),D=E(c.numbers),F=E(c.words);function v(n){
let e=new Float64Array(c.cell.length),t={...Object.fromEntries(Object.entries(n).filter(([,s])=>typeof s=="number")),law:c.impact_laws.indexOf(n.impact_law),strike:+(n.
painleve==="impact"),ideal:Number(n.ideal),allowed:1};return c.cell.forEach((s,o)=>{e[o]=t[s]??0}),e}function T(n){let e=t=>t??Number.NaN;return Float64Array.of(
c.laws.indexOf(n.law),c.friction_laws.indexOf(n.friction),e(n.stiffness),e(n.damping),e(n.restitution),e(n.slip_speed),e(n.tangential_stiffness),e(n.rtol))}var k=class{constructor(e){this.exports=e;this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var ie=150,ae=240,ce=6e3,[Ie,I,$]=[0,1,2],le={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["frict\
ion_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal",
"damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function B(n,e,t){let{rows:s,count:o,duration:i}=e,[r,a]=(t??[0,i]).map(u=>Math.
min(Math.max(u,0),i)),l=Math.min(Math.max(Math.ceil((a-r)*ie),ae),ce),d=c.events.length,h=new Set;for(let u=0;u<=l&&i>0;u++)h.add(u===l?a:r+u*((a-r)/l));let f=new Set;
for(let u=0;u<o;u++){let g=Math.min(s[u*d+m.t],i);g>=r&&g<=a&&f.add(g)}for(let u of f)h.add(u);let p=Float64Array.from(h).sort(),x=Float64Array.from(f).filter(u=>u>
0).sort(),_=n.states(e,p,!1),b=n.states(e,x,!0);return fe(p,_,x,b)}function fe(n,e,t,s){let o=n.length+t.length,i=c.samples.length,r=new Float64Array(o),a=new Float64Array(
o*i),l=0,d=0;for(let f=0;f<n.length;f++)d<t.length&&t[d]<=n[f]&&(r[l]=t[d],a.set(s.subarray(d*i,(d+1)*i),l*i),l++,d++),r[l]=n[f],a.set(e.subarray(f*i,(f+1)*i),l*
i),l++;let h={t:r};for(let[f,p]of Object.entries(le)){let x=new Float64Array(o).fill(-0);for(let _ of p)for(let b=0;b<o;b++)x[b]+=a[b*i+O[_]];h[f]=x}return h.mode=
de(a,o,h.omega),h}function de(n,e,t){let s=c.samples.length,o=new Float64Array(e),i=0;for(let r=e-1;r>=0&&!i;r--)i=Math.sign(t[r])||0;for(let r=e-1;r>=0;r--){i=
Math.sign(t[r])||i;let a=n[r*s+O.mode],l=a===I?-1:a===$?1:0;o[r]=l===0?a:l*i<0?I:$}return o}var he=n=>n/2**32|0,ue=n=>n>>>0;function W(n,e,t,s){let o=he(t),i=ue(t);n.setUint32(e,s?i:o,s),n.setUint32(e+4,s?o:i,s)}function z(n){return n instanceof Uint8Array||ArrayBuffer.isView(n)&&n.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in n&&n.BYTES_PER_ELEMENT===1}var M=n=>n?
`"${n}" `:"";function me(n,e=""){if(typeof n!="number")throw new TypeError(M(e)+"expected number, got "+typeof n);if(!Number.isSafeInteger(n)||n<0)throw new RangeError(
M(e)+"expected integer >= 0, got "+n);return n}function U(n,e,t=""){if(z(n)&&(e===void 0||n.length===e))return n;e!==void 0&&me(e,"length");let s=z(n),o=e!==void 0?` of length ${e}`:"",i=s?`length=${n.length}`:
`type=${typeof n}`,r=M(t)+"expected Uint8Array"+o+", got "+i;throw s?new RangeError(r):new TypeError(r)}var pe=(n,e)=>{if(n===null||typeof n!="object"||Array.isArray(n))throw new TypeError((e==="object"?"":`"${e}" `)+"expected object, got type="+typeof n)},P=(n,e)=>{
pe(n,e);let t=Object.getPrototypeOf(n);if(t!==Object.prototype&&t!==null)throw new TypeError(`"${e}" expected plain object`);if(Object.hasOwn(n,"__proto__"))throw new TypeError(
`"${e}.__proto__" is not allowed`)};function N(n,e=!0){if(n.destroyed)throw new Error("hash was destroyed");if(e&&n.finished)throw new Error("digest() was alrea\
dy called")}function q(n,e){U(n,void 0,"output");let t=e.outputLen;if(!(n.length>=t))throw new RangeError('"output" expected length >= '+t)}function j(...n){for(let e=0;e<n.length;e++)n[e].fill(0)}function S(n){return new DataView(n.buffer,n.byteOffset,n.byteLength)}function y(n,e){return n<<32-e|n>>>
e}function xe(n,e,t="opts"){return P(n,"defaults"),e!==void 0&&P(e,t),Object.assign(Object.create(null),n,e)}function K(n,e={}){if(typeof n!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof n);e=xe({},e,"info");let t=(o,i)=>n(i).update(o).digest(),s=n(void 0);return t.outputLen=s.outputLen,t.blockLen=
s.blockLen,t.canXOF=s.canXOF,t.create=o=>n(o),Object.assign(t,e),Object.freeze(t)}var V=n=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,n])});function X(n,e,t){return n&e^~n&t}function J(n,e,t){return n&e^n&t^e&t}var H=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(e,t,s,o){
this.blockLen=e,this.outputLen=t,this.padOffset=s,this.isLE=o,this.buffer=new Uint8Array(e),this.view=S(this.buffer)}update(e){N(this),U(e);let{view:t,buffer:s,
blockLen:o}=this,i=e.length,r=!1;for(let a=0;a<i;){let l=Math.min(o-this.pos,i-a);if(l===o){let d=S(e);for(;o<=i-a;a+=o)this.process(d,a);r=!0;continue}s.set(a===
0&&l===i?e:e.subarray(a,a+l),this.pos),this.pos+=l,a+=l,this.pos===o&&(this.process(t,0),this.pos=0,r=!0)}return this.length+=e.length,r&&this.roundClean(),this}digestInto(e){
N(this),q(e,this),this.finished=!0;let{buffer:t,view:s,blockLen:o,isLE:i}=this,{pos:r}=this;t[r++]=128,t.fill(0,r),this.padOffset>o-r&&(this.process(s,0),t.fill(
0)),W(s,o-8,this.length*8,i),this.process(s,0),this.roundClean();let a=e===t?s:S(e),l=this.outputLen,d=l/4,h=this.get();if(l%4||d>h.length)throw new Error("inva\
lid outputLen");for(let f=0;f<d;f++)a.setUint32(4*f,h[f],i)}digest(){let{buffer:e,outputLen:t}=this;this.digestInto(e);let s=e.slice(0,t);return this.destroy(),
s}_cloneIntoMeta(e){let{buffer:t,length:s,finished:o,destroyed:i,pos:r}=this;return e.destroyed=i,e.finished=o,e.length=s,e.pos=r,r&&e.buffer.set(t),e}clone(){return this.
_cloneInto()}},Y=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var be=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),A=new Uint32Array(64),R=class extends H{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(e,t){super(64,e,8,!1),
this.A=t[0]|0,this.B=t[1]|0,this.C=t[2]|0,this.D=t[3]|0,this.E=t[4]|0,this.F=t[5]|0,this.G=t[6]|0,this.H=t[7]|0}get(){let{A:e,B:t,C:s,D:o,E:i,F:r,G:a,H:l}=this;
return[e,t,s,o,i,r,a,l]}set(e,t,s,o,i,r,a,l){this.A=e|0,this.B=t|0,this.C=s|0,this.D=o|0,this.E=i|0,this.F=r|0,this.G=a|0,this.H=l|0}_cloneInto(e){return(e||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(e)}process(e,t){for(let f=0;f<16;f++,t+=4)A[f]=e.getUint32(t,!1);for(let f=16;f<64;f++){let p=A[f-15],x=A[f-
2],_=y(p,7)^y(p,18)^p>>>3,b=y(x,17)^y(x,19)^x>>>10;A[f]=b+A[f-7]+_+A[f-16]|0}let{A:s,B:o,C:i,D:r,E:a,F:l,G:d,H:h}=this;for(let f=0;f<64;f++){let p=y(a,6)^y(a,11)^
y(a,25),x=h+p+X(a,l,d)+be[f]+A[f]|0,b=(y(s,2)^y(s,13)^y(s,22))+J(s,o,i)|0;h=d,d=l,l=a,a=r+x|0,r=i,i=o,o=s,s=x+b|0}s=s+this.A|0,o=o+this.B|0,i=i+this.C|0,r=r+this.
D|0,a=a+this.E|0,l=l+this.F|0,d=d+this.G|0,h=h+this.H|0,this.set(s,o,i,r,a,l,d,h)}roundClean(){j(A)}destroy(){this.destroyed=!0,this.set(0,0,0,0,0,0,0,0),j(this.
buffer)}},C=class extends R{constructor(){super(32,Y)}};var Q=K(()=>new C,V(1));var Z=["t","x","height","angle","vx","vy","omega","slip"],ge=16,_e=0x7ff8000000000000n;function ee(n,e){let t=new TextEncoder,s=Q.create(),o=new DataView(new ArrayBuffer(
8*Z.length)),i=new Uint8Array(o.buffer);for(let a=0;a<e;a++){let l=a*c.events.length;s.update(t.encode(c.kinds[n[l+m.kind]])),Z.forEach((d,h)=>{let f=n[l+m[d]];
Number.isNaN(f)?o.setBigUint64(8*h,_e,!0):o.setFloat64(8*h,f+0,!0)}),s.update(i)}return Array.from(s.digest(),a=>a.toString(16).padStart(2,"0")).join("").slice(
0,ge)}function te(n,e){let t=new Map,s=new Float64Array(e);for(let o=0;o<e;o++){let i=ye(n.subarray(o*c.keys,(o+1)*c.keys));if(i===""){s[o]=Number.NaN;continue}let r=t.
get(i);r===void 0&&(r=t.size,t.set(i,r)),s[o]=r}return{values:s,sequences:[...t.keys()]}}function ye(n){let e="";for(let t of n){let s=t;for(let o=0;o<c.letters_a_key&&
s;o++){let i=Number(s&7n);s>>=3n,i&&(e+=i===c.more?"+":c.letters[i-1])}}return e}var we=256,Ae=2048,Ee=4096,ve=2e5,ke=c.statuses.indexOf("buffer"),Se=new Set(c.passing),G=n=>Number.isFinite(n)?n:null,L=class{constructor(e){this.exports=new WebAssembly.
Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new k(this.exports),this.mostEvents=we,this.mostSegments=Ae,this.mostRows=Ee}call(e,...t){let s=this.
exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=c.events.length;for(;;){let o=t.room("table",8*s*this.
mostEvents),i=t.room("heads",8*c.heads.length);e.contact?this.computeCompliant(e,e.contact,o,i):this.computeRigid(e,o,i);let r=t.floats(i,c.heads.length).slice(),
a=r[w.events];if(r[w.status]===ke)this.makeRoom(e,r[w.segments]);else if(a===this.mostEvents&&a<e.max_events)this.mostEvents*=4;else{let l=t.floats(o,a*s).slice();
return{given:e,head:r,rows:l,count:a,duration:r[w.duration],segments:r[w.segments]}}}}computeRigid(e,t,s){let{memory:o}=this,i=o.put("cell",v(e)),r=o.room("even\
ts",c.event_bytes*this.mostEvents),a=o.room("segments",c.segment_bytes*this.mostSegments);this.call("motion",i,r,this.mostEvents,a,this.mostSegments,t,s)}computeCompliant(e,t,s,o){
let{memory:i}=this,r=i.put("cell",v(e)),a=i.put("contact",T(t)),l=i.room("events",c.event_bytes*this.mostEvents),d=i.room("rows",c.compliant_segment_bytes*this.
mostRows);this.call("compliant_motion",r,a,l,this.mostEvents,ve,d,this.mostRows,s,o)}makeRoom(e,t){e.contact?this.mostRows=t:this.mostSegments*=4}motion(e){return ne(
this.compute(e))}film(e){let t=this.compute(e);return{motion:ne(t),columns:B(this,t)}}columns(e,t){return B(this,this.compute(e),t)}samples(e,t){let s=this.states(
this.compute(e),t,!1),o=c.samples.length;return Object.fromEntries(c.samples.map((i,r)=>[i,Float64Array.from(t,(a,l)=>s[l*o+r])]))}states(e,t,s){return this.rows(
"samples",c.samples.length,e,t,s)}margins(e,t,s=!1){if(e.contact)throw new TypeError("A compliant contact has no such rules.");let o=c.margins.length,i=this.rows(
"margins",o,this.compute(e),t,s);return Object.fromEntries(c.margins.map((r,a)=>[r,Float64Array.from(t,(l,d)=>i[d*o+a])]))}rows(e,t,s,o,i){let{memory:r}=this,a=o.
length*t,l=r.put("times",o),d=r.room("states",8*Math.max(a,1)),h=r.room("cell",8),f=[s.segments,l,o.length,Number(i),d];return s.given.contact?this.call("compli\
ant_samples",h,r.room("contact",8),r.room("rows",8),...f):this.call(e,h,r.room("segments",8),...f),r.floats(d,a).slice()}changes(e,t){let{memory:s}=this,o=this.
compute(e),i=s.put("rates",t),r=this.side(o,i,1),{reason:a,sided:l}=r,d=l||a==="border"||a==="contact"?this.side(o,i,-1):r;return{count:o.count,larger:r,smaller:d}}side({
count:e,segments:t,head:s},o,i){let{memory:r}=this,a=e*c.changes.length,l=r.room("changes",8*a),d=r.room("why",16),[h,f,p]=["cell","events","segments"].map(u=>r.
room(u,8)),x=s[w.doubt_from];this.call("changes",h,o,1,i,f,e,p,t,x,l,d);let[_,b]=r.floats(d,2);return{rates:r.floats(l,a).slice(),reason:c.reasons[Math.max(_,0)],
sided:_<0,failed:b}}thresholds(e){let{memory:t}=this,s=t.put("cell",v(e)),o=t.room("answers",8*c.thresholds.length),i=e.rolling&&e.angle===0;this.call("threshol\
ds",s,i?e.vx:Number.NaN,o);let r=t.floats(o,c.thresholds.length),a=d=>{let h=r[c.thresholds.indexOf(d)];return Number.isNaN(h)?null:h},l=["jam_angle","jam_angle\
_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a("first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immediate_hop_\
speed"),needed_friction:a("needed_friction"),painleve_friction:a("painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:l.filter(d=>d!==null),stable_angle:a(
"stable_angle"),massless_loss_angle:a("massless_loss_angle"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(e,[t,s,o,i],r,a){let{memory:l}=this,
d=l.put("cell",v(e)),h=l.room("modes",r*a),f=l.room("sides",r);this.call("regions",d,t,s,o,i,r,a,h,f);let{buffer:p}=this.exports.memory;return{modes:new Uint8Array(
p,h,r*a).slice(),paradox:Float32Array.from(new Int8Array(p,f,r))}}map({count:e,rows:t},s,o){let{memory:i}=this,r=i.put("cells",t),a=i.room("numbers",8*e*c.numbers.
length),l=i.room("words",4*e*c.words.length),d=i.room("keys",8*e*c.keys),{angle:h,stop:f,timed:p}=c.spans[o],x=c.wanted[s];this.call("map_cells",r,e,h??Number.NaN,
f,p,x,a,l,d);let{buffer:_}=this.exports.memory;if(s==="sequence")return te(new BigUint64Array(_,d,e*c.keys),e);let b=new Float64Array(e);if(s in F){let u=new Int32Array(
_,l,e*c.words.length);for(let g=0;g<e;g++)b[g]=u[g*c.words.length+F[s]]}else{let u=i.floats(a,e*c.numbers.length);for(let g=0;g<e;g++)b[g]=u[g*c.numbers.length+
D[s]]}return{values:b}}ideal(e){let t=this.memory.room("answers",8*c.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}resistance(e,t){
let s=this.memory.room("answers",8*c.thresholds.length);return this.call("resistance_limit",e,t,s),this.memory.floats(s,1)[0]}combine(e,t){let{memory:s}=this,o=s.
put("parts",t.flatMap(He)),i=s.room("answers",8*c.thresholds.length),r=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,o,t.length,i,r);let[a,l,d]=s.floats(
i,3);return{mass:a,eccentricity:l,inertia_ratio:d,reaches:[...s.floats(r,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError("The con\
tact is rigid.");let s=t.put("cell",v(e)),o=t.put("contact",T(e.contact)),i=t.room("answers",8*c.thresholds.length);this.call("compliance",s,o,i);let r=t.floats(
i,c.chosen.length),a=l=>r[c.chosen.indexOf(l)];return{stiffness:a("stiffness"),tangential_stiffness:a("tangential_stiffness"),slip_speed:a("slip_speed"),depth:a(
"depth"),automatic:{stiffness:a("stiffness_si"),slip_speed:a("slip_speed_si")}}}};function He(n){let e=n.shape==="rod"?`${n.direction}_rod`:n.shape,t=c.shapes.indexOf(
e);return n.shape==="ring"?[t,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[t,n.mass,n.radius,0,n.at]:n.shape==="rod"?[t,n.mass,n.length,0,n.at]:[t,
n.mass,0,0,n.at]}var Le=["friction","impact_normal","impact_tangential","rolling_resistance"],Oe=["kinetic","potential",...Le,"residual"],se=["x","height","angl\
e","vx","vy","omega"];function ne({given:n,head:e,rows:t,count:s,duration:o}){let i=c.events.length,r=Array.from({length:s},(h,f)=>Fe(t.subarray(f*i,(f+1)*i))),
a=r[s-1],l=Object.fromEntries([...Oe,...n.contact?["spring","damping"]:[]].map(h=>[h,e[w[h]]])),d=G(e[w.doubt_from]);return{status:c.statuses[e[w.status]],sequence:Te(
r),fingerprint:d===null?ee(t,s):null,duration:o,events:r,final:{t:a.t,mode:a.to,...Object.fromEntries(se.map(h=>[h,a[h]]))},energy:l,doubt:d}}function Fe(n){let e=c.
kinds[n[m.kind]],t=n[m.from_mode],s={t:n[m.t],kind:e,from:t<0?null:c.letters[t],to:c.letters[n[m.to_mode]]};for(let o of se)s[o]=G(n[m[o]]);return s.before=Object.
fromEntries(["vx","vy","omega"].map(o=>[o,G(n[m[`before_${o}`]])])),s.impulse={normal:n[m.impulse_normal],tangential:n[m.impulse_tangential]},n[m.collision]===0&&
(s.collision=!1),e==="kane_gain"&&(s.gain=n[m.gain]),n[m.stable]>=0&&(s.stable=n[m.stable]===1),s}function Te(n){let e=n.filter((s,o)=>o===n.length-1||!Se.has(s.
kind));return e.slice(0,-1).map((s,o)=>e[o+1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var oe;function Be(n){let e=new Set,t=s=>{ArrayBuffer.isView(s)?e.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(t)};return t(
n),[...e]}function Me({data:{number:n,compiled:e,call:t,values:s}}){try{if(e){oe=new L(e);return}let o=oe[t](...s);self.postMessage({number:n,answer:o},{transfer:Be(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",Me);export{L as HoopModule};
