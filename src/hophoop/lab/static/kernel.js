/* Built from web/kernel/worker.js by esbuild 0.28.2; sources fef7b403726746846543d997975d7593 */
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
d","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var A=s=>Object.fromEntries(s.map((t,e)=>[t,e])),Mt=A(c.cell),w=A(c.heads),m=A(c.events),L=A(c.samples),Rt=A(c.changes),G=A(c.numbers),T=A(c.words);function k(s){
let t=new Float64Array(c.cell.length),e={...Object.fromEntries(Object.entries(s).filter(([,n])=>typeof n=="number")),law:c.impact_laws.indexOf(s.impact_law),strike:+(s.
painleve==="impact"),ideal:Number(s.ideal),allowed:1};return c.cell.forEach((n,o)=>{t[o]=e[n]??0}),t}function B(s){let t=e=>e??Number.NaN;return Float64Array.of(
c.laws.indexOf(s.law),c.friction_laws.indexOf(s.friction),t(s.stiffness),t(s.damping),t(s.restitution),t(s.slip_speed),t(s.tangential_stiffness),t(s.rtol))}var S=class{constructor(t){this.exports=t,this.rooms=new Map}room(t,e){let n=this.rooms.get(t);if(n&&n.bytes>=e)return n.place;n&&this.exports.free(n.place),this.
rooms.delete(t);let o=this.exports.malloc(e);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(t,{place:o,bytes:e}),
o}floats(t,e){return new Float64Array(this.exports.memory.buffer,t,e)}put(t,e){let n=this.room(t,8*Math.max(e.length,1));return this.floats(n,e.length).set(e),n}};var it=150,at=240,ct=6e3,[It,I,$]=[0,1,2],lt={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["frict\
ion_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal",
"damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function j(s,t,e){let{rows:n,count:o,duration:i}=t,[r,a]=(e??[0,i]).map(u=>Math.
min(Math.max(u,0),i)),l=Math.min(Math.max(Math.ceil((a-r)*it),at),ct),h=c.events.length,d=new Set;for(let u=0;u<=l&&i>0;u++)d.add(u===l?a:r+u*((a-r)/l));let f=new Set;
for(let u=0;u<o;u++){let g=Math.min(n[u*h+m.t],i);g>=r&&g<=a&&f.add(g)}for(let u of f)d.add(u);let p=Float64Array.from(d).sort(),x=Float64Array.from(f).filter(u=>u>
0).sort(),_=s.states(t,p,!1),b=s.states(t,x,!0);return ft(p,_,x,b)}function ft(s,t,e,n){let o=s.length+e.length,i=c.samples.length,r=new Float64Array(o),a=new Float64Array(
o*i),l=0,h=0;for(let f=0;f<s.length;f++)h<e.length&&e[h]<=s[f]&&(r[l]=e[h],a.set(n.subarray(h*i,(h+1)*i),l*i),l++,h++),r[l]=s[f],a.set(t.subarray(f*i,(f+1)*i),l*
i),l++;let d={t:r};for(let[f,p]of Object.entries(lt)){let x=new Float64Array(o).fill(-0);for(let _ of p)for(let b=0;b<o;b++)x[b]+=a[b*i+L[_]];d[f]=x}return d.mode=
ht(a,o,d.omega),d}function ht(s,t,e){let n=c.samples.length,o=new Float64Array(t),i=0;for(let r=t-1;r>=0&&!i;r--)i=Math.sign(e[r])||0;for(let r=t-1;r>=0;r--){i=
Math.sign(e[r])||i;let a=s[r*n+L.mode],l=a===I?-1:a===$?1:0;o[r]=l===0?a:l*i<0?I:$}return o}var dt=s=>s/2**32|0,ut=s=>s>>>0;function W(s,t,e,n){let o=dt(e),i=ut(e);s.setUint32(t,n?i:o,n),s.setUint32(t+4,n?o:i,n)}function z(s){return s instanceof Uint8Array||ArrayBuffer.isView(s)&&s.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in s&&s.BYTES_PER_ELEMENT===1}var N=s=>s?
`"${s}" `:"";function mt(s,t=""){if(typeof s!="number")throw new TypeError(N(t)+"expected number, got "+typeof s);if(!Number.isSafeInteger(s)||s<0)throw new RangeError(
N(t)+"expected integer >= 0, got "+s);return s}function U(s,t,e=""){if(z(s)&&(t===void 0||s.length===t))return s;t!==void 0&&mt(t,"length");let n=z(s),o=t!==void 0?` of length ${t}`:"",i=n?`length=${s.length}`:
`type=${typeof s}`,r=N(e)+"expected Uint8Array"+o+", got "+i;throw n?new RangeError(r):new TypeError(r)}var pt=(s,t)=>{if(s===null||typeof s!="object"||Array.isArray(s))throw new TypeError((t==="object"?"":`"${t}" `)+"expected object, got type="+typeof s)},P=(s,t)=>{
pt(s,t);let e=Object.getPrototypeOf(s);if(e!==Object.prototype&&e!==null)throw new TypeError(`"${t}" expected plain object`);if(Object.hasOwn(s,"__proto__"))throw new TypeError(
`"${t}.__proto__" is not allowed`)};function F(s,t=!0){if(s.destroyed)throw new Error("hash was destroyed");if(t&&s.finished)throw new Error("digest() was alrea\
dy called")}function q(s,t){U(s,void 0,"output");let e=t.outputLen;if(!(s.length>=e))throw new RangeError('"output" expected length >= '+e)}function M(...s){for(let t=0;t<s.length;t++)s[t].fill(0)}function v(s){return new DataView(s.buffer,s.byteOffset,s.byteLength)}function y(s,t){return s<<32-t|s>>>
t}function xt(s,t,e="opts"){return P(s,"defaults"),t!==void 0&&P(t,e),Object.assign(Object.create(null),s,t)}function K(s,t={}){if(typeof s!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof s);t=xt({},t,"info");let e=(o,i)=>s(i).update(o).digest(),n=s(void 0);return e.outputLen=n.outputLen,e.blockLen=
n.blockLen,e.canXOF=n.canXOF,e.create=o=>s(o),Object.assign(e,t),Object.freeze(e)}var V=s=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,s])});function X(s,t,e){return s&t^~s&e}function J(s,t,e){return s&t^s&e^t&e}var H=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(t,e,n,o){
this.blockLen=t,this.outputLen=e,this.padOffset=n,this.isLE=o,this.buffer=new Uint8Array(t),this.view=v(this.buffer)}update(t){F(this),U(t);let{view:e,buffer:n,
blockLen:o}=this,i=t.length,r=!1;for(let a=0;a<i;){let l=Math.min(o-this.pos,i-a);if(l===o){let h=v(t);for(;o<=i-a;a+=o)this.process(h,a);r=!0;continue}n.set(a===
0&&l===i?t:t.subarray(a,a+l),this.pos),this.pos+=l,a+=l,this.pos===o&&(this.process(e,0),this.pos=0,r=!0)}return this.length+=t.length,r&&this.roundClean(),this}digestInto(t){
F(this),q(t,this),this.finished=!0;let{buffer:e,view:n,blockLen:o,isLE:i}=this,{pos:r}=this;e[r++]=128,e.fill(0,r),this.padOffset>o-r&&(this.process(n,0),e.fill(
0)),W(n,o-8,this.length*8,i),this.process(n,0),this.roundClean();let a=t===e?n:v(t),l=this.outputLen,h=l/4,d=this.get();if(l%4||h>d.length)throw new Error("inva\
lid outputLen");for(let f=0;f<h;f++)a.setUint32(4*f,d[f],i)}digest(){let{buffer:t,outputLen:e}=this;this.digestInto(t);let n=t.slice(0,e);return this.destroy(),
n}_cloneIntoMeta(t){let{buffer:e,length:n,finished:o,destroyed:i,pos:r}=this;return t.destroyed=i,t.finished=o,t.length=n,t.pos=r,r&&t.buffer.set(e),t}clone(){return this.
_cloneInto()}},Y=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var bt=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),E=new Uint32Array(64),R=class extends H{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(t,e){super(64,t,8,!1),
this.A=e[0]|0,this.B=e[1]|0,this.C=e[2]|0,this.D=e[3]|0,this.E=e[4]|0,this.F=e[5]|0,this.G=e[6]|0,this.H=e[7]|0}get(){let{A:t,B:e,C:n,D:o,E:i,F:r,G:a,H:l}=this;
return[t,e,n,o,i,r,a,l]}set(t,e,n,o,i,r,a,l){this.A=t|0,this.B=e|0,this.C=n|0,this.D=o|0,this.E=i|0,this.F=r|0,this.G=a|0,this.H=l|0}_cloneInto(t){return(t||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(t)}process(t,e){for(let f=0;f<16;f++,e+=4)E[f]=t.getUint32(e,!1);for(let f=16;f<64;f++){let p=E[f-15],x=E[f-
2],_=y(p,7)^y(p,18)^p>>>3,b=y(x,17)^y(x,19)^x>>>10;E[f]=b+E[f-7]+_+E[f-16]|0}let{A:n,B:o,C:i,D:r,E:a,F:l,G:h,H:d}=this;for(let f=0;f<64;f++){let p=y(a,6)^y(a,11)^
y(a,25),x=d+p+X(a,l,h)+bt[f]+E[f]|0,b=(y(n,2)^y(n,13)^y(n,22))+J(n,o,i)|0;d=h,h=l,l=a,a=r+x|0,r=i,i=o,o=n,n=x+b|0}n=n+this.A|0,o=o+this.B|0,i=i+this.C|0,r=r+this.
D|0,a=a+this.E|0,l=l+this.F|0,h=h+this.G|0,d=d+this.H|0,this.set(n,o,i,r,a,l,h,d)}roundClean(){M(E)}destroy(){this.destroyed=!0,this.set(0,0,0,0,0,0,0,0),M(this.
buffer)}},C=class extends R{constructor(){super(32,Y)}};var Q=K(()=>new C,V(1));var Z=["t","x","height","angle","vx","vy","omega","slip"],gt=16,_t=0x7ff8000000000000n;function tt(s,t){let e=new TextEncoder,n=Q.create(),o=new DataView(new ArrayBuffer(
8*Z.length)),i=new Uint8Array(o.buffer);for(let a=0;a<t;a++){let l=a*c.events.length;n.update(e.encode(c.kinds[s[l+m.kind]])),Z.forEach((h,d)=>{let f=s[l+m[h]];
Number.isNaN(f)?o.setBigUint64(8*d,_t,!0):o.setFloat64(8*d,f+0,!0)}),n.update(i)}return Array.from(n.digest(),a=>a.toString(16).padStart(2,"0")).join("").slice(
0,gt)}function et(s,t){let e=new Map,n=new Float64Array(t);for(let o=0;o<t;o++){let i=yt(s.subarray(o*c.keys,(o+1)*c.keys));if(i===""){n[o]=Number.NaN;continue}let r=e.
get(i);r===void 0&&(r=e.size,e.set(i,r)),n[o]=r}return{values:n,sequences:[...e.keys()]}}function yt(s){let t="";for(let e of s){let n=e;for(let o=0;o<c.letters_a_key&&
n;o++){let i=Number(n&7n);n>>=3n,i&&(t+=i===c.more?"+":c.letters[i-1])}}return t}var wt=256,Et=2048,At=4096,kt=2e5,St=c.statuses.indexOf("buffer"),vt=new Set(c.passing),D=s=>Number.isFinite(s)?s:null,O=class{constructor(t){this.exports=new WebAssembly.
Instance(t,{}).exports,this.exports._initialize?.(),this.memory=new S(this.exports),this.mostEvents=wt,this.mostSegments=Et,this.mostRows=At}call(t,...e){let n=this.
exports[t](...e);if(n)throw new Error(`The kernel ended ${t} with ${n}.`)}compute(t){let{memory:e}=this,n=c.events.length;for(;;){let o=e.room("table",8*n*this.
mostEvents),i=e.room("heads",8*c.heads.length);t.contact?this.computeCompliant(t,t.contact,o,i):this.computeRigid(t,o,i);let r=e.floats(i,c.heads.length).slice(),
a=r[w.events];if(r[w.status]===St)this.makeRoom(t,r[w.segments]);else if(a===this.mostEvents&&a<t.max_events)this.mostEvents*=4;else{let l=e.floats(o,a*n).slice();
return{given:t,head:r,rows:l,count:a,duration:r[w.duration],segments:r[w.segments]}}}}computeRigid(t,e,n){let{memory:o}=this,i=o.put("cell",k(t)),r=o.room("even\
ts",c.event_bytes*this.mostEvents),a=o.room("segments",c.segment_bytes*this.mostSegments);this.call("motion",i,r,this.mostEvents,a,this.mostSegments,e,n)}computeCompliant(t,e,n,o){
let{memory:i}=this,r=i.put("cell",k(t)),a=i.put("contact",B(e)),l=i.room("events",c.event_bytes*this.mostEvents),h=i.room("rows",c.compliant_segment_bytes*this.
mostRows);this.call("compliant_motion",r,a,l,this.mostEvents,kt,h,this.mostRows,n,o)}makeRoom(t,e){t.contact?this.mostRows=e:this.mostSegments*=4}motion(t){return st(
this.compute(t))}film(t){let e=this.compute(t);return{motion:st(e),columns:j(this,e)}}columns(t,e){return j(this,this.compute(t),e)}samples(t,e){let n=this.states(
this.compute(t),e,!1),o=c.samples.length;return Object.fromEntries(c.samples.map((i,r)=>[i,Float64Array.from(e,(a,l)=>n[l*o+r])]))}states(t,e,n){return this.rows(
"samples",c.samples.length,t,e,n)}margins(t,e,n=!1){if(t.contact)throw new TypeError("A compliant contact has no such rules.");let o=c.margins.length,i=this.rows(
"margins",o,this.compute(t),e,n);return Object.fromEntries(c.margins.map((r,a)=>[r,Float64Array.from(e,(l,h)=>i[h*o+a])]))}rows(t,e,n,o,i){let{memory:r}=this,a=o.
length*e,l=r.put("times",o),h=r.room("states",8*Math.max(a,1)),d=r.room("cell",8),f=[n.segments,l,o.length,Number(i),h];return n.given.contact?this.call("compli\
ant_samples",d,r.room("contact",8),r.room("rows",8),...f):this.call(t,d,r.room("segments",8),...f),r.floats(h,a).slice()}changes(t,e){let{memory:n}=this,o=this.
compute(t),i=n.put("rates",e),r=this.side(o,i,1),{reason:a,sided:l}=r,h=l||a==="border"||a==="contact"?this.side(o,i,-1):r;return{count:o.count,larger:r,smaller:h}}side({
count:t,segments:e,head:n},o,i){let{memory:r}=this,a=t*c.changes.length,l=r.room("changes",8*a),h=r.room("why",16),[d,f,p]=["cell","events","segments"].map(u=>r.
room(u,8)),x=n[w.doubt_from];this.call("changes",d,o,1,i,f,t,p,e,x,l,h);let[_,b]=r.floats(h,2);return{rates:r.floats(l,a).slice(),reason:c.reasons[Math.max(_,0)],
sided:_<0,failed:b}}thresholds(t){let{memory:e}=this,n=e.put("cell",k(t)),o=e.room("answers",8*c.thresholds.length),i=t.rolling&&t.angle===0;this.call("threshol\
ds",n,i?t.vx:Number.NaN,o);let r=e.floats(o,c.thresholds.length),a=h=>{let d=r[c.thresholds.indexOf(h)];return Number.isNaN(d)?null:d},l=["jam_angle","jam_angle\
_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a("first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immediate_hop_\
speed"),needed_friction:a("needed_friction"),painleve_friction:a("painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:l.filter(h=>h!==null),stable_angle:a(
"stable_angle"),massless_loss_angle:a("massless_loss_angle"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(t,[e,n,o,i],r,a){let{memory:l}=this,
h=l.put("cell",k(t)),d=l.room("modes",r*a),f=l.room("sides",r);this.call("regions",h,e,n,o,i,r,a,d,f);let{buffer:p}=this.exports.memory;return{modes:new Uint8Array(
p,d,r*a).slice(),paradox:Float32Array.from(new Int8Array(p,f,r))}}map({count:t,rows:e},n,o){let{memory:i}=this,r=i.put("cells",e),a=i.room("numbers",8*t*c.numbers.
length),l=i.room("words",4*t*c.words.length),h=i.room("keys",8*t*c.keys),{angle:d,stop:f,timed:p}=c.spans[o],x=c.wanted[n];this.call("map_cells",r,t,d??Number.NaN,
f,p,x,a,l,h);let{buffer:_}=this.exports.memory;if(n==="sequence")return et(new BigUint64Array(_,h,t*c.keys),t);let b=new Float64Array(t);if(n in T){let u=new Int32Array(
_,l,t*c.words.length);for(let g=0;g<t;g++)b[g]=u[g*c.words.length+T[n]]}else{let u=i.floats(a,t*c.numbers.length);for(let g=0;g<t;g++)b[g]=u[g*c.numbers.length+
G[n]]}return{values:b}}ideal(t){let e=this.memory.room("answers",8*c.thresholds.length);return this.call("ideal_hoop",t,e),this.memory.floats(e,1)[0]}resistance(t,e){
let n=this.memory.room("answers",8*c.thresholds.length);return this.call("resistance_limit",t,e,n),this.memory.floats(n,1)[0]}combine(t,e){let{memory:n}=this,o=n.
put("parts",e.flatMap(Ht)),i=n.room("answers",8*c.thresholds.length),r=n.room("reaches",8*e.length);this.call("hoop_of_parts",t,o,e.length,i,r);let[a,l,h]=n.floats(
i,3);return{mass:a,eccentricity:l,inertia_ratio:h,reaches:[...n.floats(r,e.length)]}}compliance(t){let{memory:e}=this;if(!t.contact)throw new TypeError("The con\
tact is rigid.");let n=e.put("cell",k(t)),o=e.put("contact",B(t.contact)),i=e.room("answers",8*c.thresholds.length);this.call("compliance",n,o,i);let r=e.floats(
i,c.chosen.length),a=l=>r[c.chosen.indexOf(l)];return{stiffness:a("stiffness"),tangential_stiffness:a("tangential_stiffness"),slip_speed:a("slip_speed"),depth:a(
"depth"),automatic:{stiffness:a("stiffness_si"),slip_speed:a("slip_speed_si")}}}};function Ht(s){let t=s.shape==="rod"?`${s.direction}_rod`:s.shape,e=c.shapes.indexOf(
t);return s.shape==="ring"?[e,s.mass,s.inner_radius,s.outer_radius,0]:s.shape==="disk"?[e,s.mass,s.radius,0,s.at]:s.shape==="rod"?[e,s.mass,s.length,0,s.at]:[e,
s.mass,0,0,s.at]}var Ot=["friction","impact_normal","impact_tangential","rolling_resistance"],Lt=["kinetic","potential",...Ot,"residual"],nt=["x","height","angl\
e","vx","vy","omega"];function st({given:s,head:t,rows:e,count:n,duration:o}){let i=c.events.length,r=Array.from({length:n},(d,f)=>Tt(e.subarray(f*i,(f+1)*i))),
a=r[n-1],l=Object.fromEntries([...Lt,...s.contact?["spring","damping"]:[]].map(d=>[d,t[w[d]]])),h=D(t[w.doubt_from]);return{status:c.statuses[t[w.status]],sequence:Bt(
r),fingerprint:h===null?tt(e,n):null,duration:o,events:r,final:{t:a.t,mode:a.to,...Object.fromEntries(nt.map(d=>[d,a[d]]))},energy:l,doubt:h}}function Tt(s){let t=c.
kinds[s[m.kind]],e=s[m.from_mode],n={t:s[m.t],kind:t,from:e<0?null:c.letters[e],to:c.letters[s[m.to_mode]]};for(let o of nt)n[o]=D(s[m[o]]);return n.before=Object.
fromEntries(["vx","vy","omega"].map(o=>[o,D(s[m[`before_${o}`]])])),n.impulse={normal:s[m.impulse_normal],tangential:s[m.impulse_tangential]},s[m.collision]===0&&
(n.collision=!1),t==="kane_gain"&&(n.gain=s[m.gain]),s[m.stable]>=0&&(n.stable=s[m.stable]===1),n}function Bt(s){let t=s.filter((n,o)=>o===s.length-1||!vt.has(n.
kind));return t.slice(0,-1).map((n,o)=>t[o+1].t>n.t?n.to:"").join("")||(s.at(-1)?.to??"")}var ot;function jt(s){let t=new Set,e=n=>{ArrayBuffer.isView(n)?t.add(n.buffer):n&&typeof n=="object"&&!Array.isArray(n)&&Object.values(n).forEach(e)};return e(
s),[...t]}function Nt({data:{number:s,compiled:t,call:e,values:n}}){try{if(t){ot=new O(t);return}let o=ot[e](...n);self.postMessage({number:s,answer:o},{transfer:jt(
o)})}catch(o){self.postMessage({number:s,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",Nt);export{O as HoopModule};
