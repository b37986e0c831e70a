/* Built from web/kernel/worker.ts by esbuild 0.28.2; sources aad799d4bd84b9b7992c68c29598e786 */
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
d","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var E=n=>Object.fromEntries(n.map((t,e)=>[t,e])),Rt=E(c.cell),w=E(c.heads),p=E(c.events),L=E(c.samples),Ct=E(c.changes),$=E(c.numbers),T=E(c.words);function k(n){
let t=new Float64Array(c.cell.length),e={...Object.fromEntries(Object.entries(n).filter(([,s])=>typeof s=="number")),law:c.impact_laws.indexOf(n.impact_law),strike:+(n.
painleve==="impact"),ideal:Number(n.ideal),allowed:1};return c.cell.forEach((s,o)=>{t[o]=e[s]??0}),t}function v(n){let t=e=>e??Number.NaN;return Float64Array.of(
c.laws.indexOf(n.law),c.friction_laws.indexOf(n.friction),t(n.stiffness),t(n.damping),t(n.restitution),t(n.slip_speed),t(n.tangential_stiffness),t(n.rtol))}var S=class{constructor(t){this.exports=t;this.rooms=new Map}room(t,e){let s=this.rooms.get(t);if(s&&s.bytes>=e)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(t);let o=this.exports.malloc(e);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(t,{place:o,bytes:e}),
o}floats(t,e){return new Float64Array(this.exports.memory.buffer,t,e)}put(t,e){let s=this.room(t,8*Math.max(e.length,1));return this.floats(s,e.length).set(e),s}};var at=150,ct=240,lt=6e3,[It,I,W]=[0,1,2],ft={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["frict\
ion_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal",
"damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function B(n,t,e){let{rows:s,count:o,duration:r}=t,[a,i]=(e??[0,r]).map(u=>Math.
min(Math.max(u,0),r)),l=Math.min(Math.max(Math.ceil((i-a)*at),ct),lt),h=c.events.length,m=new Set;for(let u=0;u<=l&&r>0;u++)m.add(u===l?i:a+u*((i-a)/l));let f=new Set;
for(let u=0;u<o;u++){let g=Math.min(s[u*h+p.t],r);g>=a&&g<=i&&f.add(g)}for(let u of f)m.add(u);let d=Float64Array.from(m).sort(),x=Float64Array.from(f).filter(u=>u>
0).sort(),_=n.states(t,d,!1),b=n.states(t,x,!0);return M(d,_,x,b)}function M(n,t,e,s){let o=n.length+e.length,r=c.samples.length,a=new Float64Array(o),i=new Float64Array(
o*r),l=0,h=0;for(let f=0;f<n.length;f++)h<e.length&&e[h]<=n[f]&&(a[l]=e[h],i.set(s.subarray(h*r,(h+1)*r),l*r),l++,h++),a[l]=n[f],i.set(t.subarray(f*r,(f+1)*r),l*
r),l++;let m={t:a};for(let[f,d]of Object.entries(ft)){let x=new Float64Array(o).fill(-0);for(let _ of d)for(let b=0;b<o;b++)x[b]+=i[b*r+L[_]];m[f]=x}return m.mode=
ht(i,o,m.omega),m}function ht(n,t,e){let s=c.samples.length,o=new Float64Array(t),r=0;for(let a=t-1;a>=0&&!r;a--)r=Math.sign(e[a])||0;for(let a=t-1;a>=0;a--){r=
Math.sign(e[a])||r;let i=n[a*s+L.mode],l=i===I?-1:i===W?1:0;o[a]=l===0?i:l*r<0?I:W}return o}var mt=n=>n/2**32|0,dt=n=>n>>>0;function P(n,t,e,s){let o=mt(e),r=dt(e);n.setUint32(t,s?r:o,s),n.setUint32(t+4,s?o:r,s)}function z(n){return n instanceof Uint8Array||ArrayBuffer.isView(n)&&n.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in n&&n.BYTES_PER_ELEMENT===1}var U=n=>n?
`"${n}" `:"";function ut(n,t=""){if(typeof n!="number")throw new TypeError(U(t)+"expected number, got "+typeof n);if(!Number.isSafeInteger(n)||n<0)throw new RangeError(
U(t)+"expected integer >= 0, got "+n);return n}function j(n,t,e=""){if(z(n)&&(t===void 0||n.length===t))return n;t!==void 0&&ut(t,"length");let s=z(n),o=t!==void 0?` of length ${t}`:"",r=s?`length=${n.length}`:
`type=${typeof n}`,a=U(e)+"expected Uint8Array"+o+", got "+r;throw s?new RangeError(a):new TypeError(a)}var pt=(n,t)=>{if(n===null||typeof n!="object"||Array.isArray(n))throw new TypeError((t==="object"?"":`"${t}" `)+"expected object, got type="+typeof n)},K=(n,t)=>{
pt(n,t);let e=Object.getPrototypeOf(n);if(e!==Object.prototype&&e!==null)throw new TypeError(`"${t}" expected plain object`);if(Object.hasOwn(n,"__proto__"))throw new TypeError(
`"${t}.__proto__" is not allowed`)};function N(n,t=!0){if(n.destroyed)throw new Error("hash was destroyed");if(t&&n.finished)throw new Error("digest() was alrea\
dy called")}function q(n,t){j(n,void 0,"output");let e=t.outputLen;if(!(n.length>=e))throw new RangeError('"output" expected length >= '+e)}function R(...n){for(let t=0;t<n.length;t++)n[t].fill(0)}function H(n){return new DataView(n.buffer,n.byteOffset,n.byteLength)}function y(n,t){return n<<32-t|n>>>
t}function xt(n,t,e="opts"){return K(n,"defaults"),t!==void 0&&K(t,e),Object.assign(Object.create(null),n,t)}function V(n,t={}){if(typeof n!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof n);t=xt({},t,"info");let e=(o,r)=>n(r).update(o).digest(),s=n(void 0);return e.outputLen=s.outputLen,e.blockLen=
s.blockLen,e.canXOF=s.canXOF,e.create=o=>n(o),Object.assign(e,t),Object.freeze(e)}var X=n=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,n])});function J(n,t,e){return n&t^~n&e}function Y(n,t,e){return n&t^n&e^t&e}var O=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(t,e,s,o){
this.blockLen=t,this.outputLen=e,this.padOffset=s,this.isLE=o,this.buffer=new Uint8Array(t),this.view=H(this.buffer)}update(t){N(this),j(t);let{view:e,buffer:s,
blockLen:o}=this,r=t.length,a=!1;for(let i=0;i<r;){let l=Math.min(o-this.pos,r-i);if(l===o){let h=H(t);for(;o<=r-i;i+=o)this.process(h,i);a=!0;continue}s.set(i===
0&&l===r?t:t.subarray(i,i+l),this.pos),this.pos+=l,i+=l,this.pos===o&&(this.process(e,0),this.pos=0,a=!0)}return this.length+=t.length,a&&this.roundClean(),this}digestInto(t){
N(this),q(t,this),this.finished=!0;let{buffer:e,view:s,blockLen:o,isLE:r}=this,{pos:a}=this;e[a++]=128,e.fill(0,a),this.padOffset>o-a&&(this.process(s,0),e.fill(
0)),P(s,o-8,this.length*8,r),this.process(s,0),this.roundClean();let i=t===e?s:H(t),l=this.outputLen,h=l/4,m=this.get();if(l%4||h>m.length)throw new Error("inva\
lid outputLen");for(let f=0;f<h;f++)i.setUint32(4*f,m[f],r)}digest(){let{buffer:t,outputLen:e}=this;this.digestInto(t);let s=t.slice(0,e);return this.destroy(),
s}_cloneIntoMeta(t){let{buffer:e,length:s,finished:o,destroyed:r,pos:a}=this;return t.destroyed=r,t.finished=o,t.length=s,t.pos=a,a&&t.buffer.set(e),t}clone(){return this.
_cloneInto()}},Q=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var bt=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),A=new Uint32Array(64),C=class extends O{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(t,e){super(64,t,8,!1),
this.A=e[0]|0,this.B=e[1]|0,this.C=e[2]|0,this.D=e[3]|0,this.E=e[4]|0,this.F=e[5]|0,this.G=e[6]|0,this.H=e[7]|0}get(){let{A:t,B:e,C:s,D:o,E:r,F:a,G:i,H:l}=this;
return[t,e,s,o,r,a,i,l]}set(t,e,s,o,r,a,i,l){this.A=t|0,this.B=e|0,this.C=s|0,this.D=o|0,this.E=r|0,this.F=a|0,this.G=i|0,this.H=l|0}_cloneInto(t){return(t||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(t)}process(t,e){for(let f=0;f<16;f++,e+=4)A[f]=t.getUint32(e,!1);for(let f=16;f<64;f++){let d=A[f-15],x=A[f-
2],_=y(d,7)^y(d,18)^d>>>3,b=y(x,17)^y(x,19)^x>>>10;A[f]=b+A[f-7]+_+A[f-16]|0}let{A:s,B:o,C:r,D:a,E:i,F:l,G:h,H:m}=this;for(let f=0;f<64;f++){let d=y(i,6)^y(i,11)^
y(i,25),x=m+d+J(i,l,h)+bt[f]+A[f]|0,b=(y(s,2)^y(s,13)^y(s,22))+Y(s,o,r)|0;m=h,h=l,l=i,i=a+x|0,a=r,r=o,o=s,s=x+b|0}s=s+this.A|0,o=o+this.B|0,r=r+this.C|0,a=a+this.
D|0,i=i+this.E|0,l=l+this.F|0,h=h+this.G|0,m=m+this.H|0,this.set(s,o,r,a,i,l,h,m)}roundClean(){R(A)}destroy(){this.destroyed=!0,this.set(0,0,0,0,0,0,0,0),R(this.
buffer)}},G=class extends C{constructor(){super(32,Q)}};var Z=V(()=>new G,X(1));var tt=["t","x","height","angle","vx","vy","omega","slip"],gt=16,_t=0x7ff8000000000000n;function et(n,t){let e=new TextEncoder,s=Z.create(),o=new DataView(new ArrayBuffer(
8*tt.length)),r=new Uint8Array(o.buffer);for(let i=0;i<t;i++){let l=i*c.events.length;s.update(e.encode(c.kinds[n[l+p.kind]])),tt.forEach((h,m)=>{let f=n[l+p[h]];
Number.isNaN(f)?o.setBigUint64(8*m,_t,!0):o.setFloat64(8*m,f+0,!0)}),s.update(r)}return Array.from(s.digest(),i=>i.toString(16).padStart(2,"0")).join("").slice(
0,gt)}function nt(n,t){let e=new Map,s=new Float64Array(t);for(let o=0;o<t;o++){let r=yt(n.subarray(o*c.keys,(o+1)*c.keys));if(r===""){s[o]=Number.NaN;continue}let a=e.
get(r);a===void 0&&(a=e.size,e.set(r,a)),s[o]=a}return{values:s,sequences:[...e.keys()]}}function yt(n){let t="";for(let e of n){let s=e;for(let o=0;o<c.letters_a_key&&
s;o++){let r=Number(s&7n);s>>=3n,r&&(t+=r===c.more?"+":c.letters[r-1])}}return t}var wt=256,At=2048,Et=4096,kt=2e5,vt=c.statuses.indexOf("buffer"),St=2,Ht=new Set(c.passing),D=n=>Number.isFinite(n)?n:null,F=class{constructor(t){this.kept=[];
this.turn=0;this.exports=new WebAssembly.Instance(t,{}).exports,this.exports._initialize?.(),this.memory=new S(this.exports),this.mostEvents=wt,this.mostSegments=
At,this.mostRows=Et}call(t,...e){let s=this.exports[t](...e);if(s)throw new Error(`The kernel ended ${t} with ${s}.`)}compute(t){let{memory:e}=this,s=c.events.length;
for(;;){let o=e.room("table",8*s*this.mostEvents),r=e.room("heads",8*c.heads.length);t.contact?this.computeCompliant(t,t.contact,o,r):this.computeRigid(t,o,r);let a=e.
floats(r,c.heads.length).slice(),i=a[w.events];if(a[w.status]===vt)this.makeRoom(t,a[w.segments]);else if(i===this.mostEvents&&i<t.max_events)this.mostEvents*=4;else{
let l=e.floats(o,i*s).slice();return{given:t,head:a,rows:l,count:i,duration:a[w.duration],segments:a[w.segments]}}}}computeRigid(t,e,s){let{memory:o}=this,r=o.put(
"cell",k(t)),a=o.room("events",c.event_bytes*this.mostEvents),i=o.room("segments",c.segment_bytes*this.mostSegments);this.call("motion",r,a,this.mostEvents,i,this.
mostSegments,e,s)}computeCompliant(t,e,s,o){let{memory:r}=this,a=r.put("cell",k(t)),i=r.put("contact",v(e)),l=r.room("events",c.event_bytes*this.mostEvents),h=r.
room("rows",c.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,i,l,this.mostEvents,kt,h,this.mostRows,s,o)}makeRoom(t,e){t.contact?this.mostRows=
e:this.mostSegments*=4}motion(t){return st(this.compute(t))}film(t){let e=this.compute(t),[s,o]=t.contact?["rows",c.compliant_segment_bytes]:["segments",c.segment_bytes],
r=this.memory.room(s,8),a=new Uint8Array(this.exports.memory.buffer,r,o*e.segments).slice();return{motion:st(e),columns:B(this,e),pieces:a}}instant(t,e,s){let o=e.
length/(t.contact?c.compliant_segment_bytes:c.segment_bytes);this.memory.put("cell",k(t)),t.contact&&this.memory.put("contact",v(t.contact));let r=Float64Array.
of(s),a=this.states({given:t,segments:o},r,!1,this.placeOf(e)),i=new Float64Array(0);return M(r,a,i,i)}placeOf(t){let e=this.kept.find(r=>r.pieces===t);if(e)return e.
place;let{turn:s}=this;this.turn=(s+1)%St;let o=this.memory.room(`pieces ${s}`,Math.max(t.length,1));return new Uint8Array(this.exports.memory.buffer,o,t.length).
set(t),this.kept[s]={pieces:t,place:o},o}columns(t,e){return B(this,this.compute(t),e)}samples(t,e){let s=this.states(this.compute(t),e,!1),o=c.samples.length;return Object.
fromEntries(c.samples.map((r,a)=>[r,Float64Array.from(e,(i,l)=>s[l*o+a])]))}states(t,e,s,o){return this.rows("samples",c.samples.length,t,e,s,o)}margins(t,e,s=!1){
if(t.contact)throw new TypeError("A compliant contact has no such rules.");let o=c.margins.length,r=this.rows("margins",o,this.compute(t),e,s);return Object.fromEntries(
c.margins.map((a,i)=>[a,Float64Array.from(e,(l,h)=>r[h*o+i])]))}rows(t,e,s,o,r,a){let{memory:i}=this,l=o.length*e,h=i.put("times",o),m=i.room("states",8*Math.max(
l,1)),f=i.room("cell",8),d=[s.segments,h,o.length,Number(r),m];return s.given.contact?this.call("compliant_samples",f,i.room("contact",8),a??i.room("rows",8),...d):
this.call(t,f,a??i.room("segments",8),...d),i.floats(m,l).slice()}changes(t,e){let{memory:s}=this,o=this.compute(t),r=s.put("rates",e),a=this.side(o,r,1),{reason:i,
sided:l}=a,h=l||i==="border"||i==="contact"?this.side(o,r,-1):a;return{count:o.count,larger:a,smaller:h}}side({count:t,segments:e,head:s},o,r){let{memory:a}=this,
i=t*c.changes.length,l=a.room("changes",8*i),h=a.room("why",16),[m,f,d]=["cell","events","segments"].map(u=>a.room(u,8)),x=s[w.doubt_from];this.call("changes",m,
o,1,r,f,t,d,e,x,l,h);let[_,b]=a.floats(h,2);return{rates:a.floats(l,i).slice(),reason:c.reasons[Math.max(_,0)],sided:_<0,failed:b}}thresholds(t){let{memory:e}=this,
s=e.put("cell",k(t)),o=e.room("answers",8*c.thresholds.length),r=t.rolling&&t.angle===0;this.call("thresholds",s,r?t.vx:Number.NaN,o);let a=e.floats(o,c.thresholds.
length),i=h=>{let m=a[c.thresholds.indexOf(h)];return Number.isNaN(m)?null:m},l=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(i);return{first_slip_speed:i(
"first_slip_speed"),first_hop_speed:i("first_hop_speed"),immediate_hop_speed:i("immediate_hop_speed"),needed_friction:i("needed_friction"),painleve_friction:i("\
painleve_friction"),painleve_angle:i("painleve_angle"),jam_angles:l.filter(h=>h!==null),stable_angle:i("stable_angle"),massless_loss_angle:i("massless_loss_angl\
e"),massless_loss_by_friction:i("massless_loss_by_friction")===1}}regions(t,[e,s,o,r],a,i){let{memory:l}=this,h=l.put("cell",k(t)),m=l.room("modes",a*i),f=l.room(
"sides",a);this.call("regions",h,e,s,o,r,a,i,m,f);let{buffer:d}=this.exports.memory;return{modes:new Uint8Array(d,m,a*i).slice(),paradox:Float32Array.from(new Int8Array(
d,f,a))}}map({count:t,rows:e},s,o){let{memory:r}=this,a=r.put("cells",e),i=r.room("numbers",8*t*c.numbers.length),l=r.room("words",4*t*c.words.length),h=r.room(
"keys",8*t*c.keys),{angle:m,stop:f,timed:d}=c.spans[o],x=c.wanted[s];this.call("map_cells",a,t,m??Number.NaN,f,d,x,i,l,h);let{buffer:_}=this.exports.memory;if(s===
"sequence")return nt(new BigUint64Array(_,h,t*c.keys),t);let b=new Float64Array(t);if(s in T){let u=new Int32Array(_,l,t*c.words.length);for(let g=0;g<t;g++)b[g]=
u[g*c.words.length+T[s]]}else{let u=r.floats(i,t*c.numbers.length);for(let g=0;g<t;g++)b[g]=u[g*c.numbers.length+$[s]]}return{values:b}}ideal(t){let e=this.memory.
room("answers",8*c.thresholds.length);return this.call("ideal_hoop",t,e),this.memory.floats(e,1)[0]}resistance(t,e){let s=this.memory.room("answers",8*c.thresholds.
length);return this.call("resistance_limit",t,e,s),this.memory.floats(s,1)[0]}combine(t,e){let{memory:s}=this,o=s.put("parts",e.flatMap(Ot)),r=s.room("answers",
8*c.thresholds.length),a=s.room("reaches",8*e.length);this.call("hoop_of_parts",t,o,e.length,r,a);let[i,l,h]=s.floats(r,3);return{mass:i,eccentricity:l,inertia_ratio:h,
reaches:[...s.floats(a,e.length)]}}compliance(t){let{memory:e}=this;if(!t.contact)throw new TypeError("The contact is rigid.");let s=e.put("cell",k(t)),o=e.put(
"contact",v(t.contact)),r=e.room("answers",8*c.thresholds.length);this.call("compliance",s,o,r);let a=e.floats(r,c.chosen.length),i=l=>a[c.chosen.indexOf(l)];return{
stiffness:i("stiffness"),tangential_stiffness:i("tangential_stiffness"),slip_speed:i("slip_speed"),depth:i("depth"),automatic:{stiffness:i("stiffness_si"),slip_speed:i(
"slip_speed_si")}}}};function Ot(n){let t=n.shape==="rod"?`${n.direction}_rod`:n.shape,e=c.shapes.indexOf(t);return n.shape==="ring"?[e,n.mass,n.inner_radius,n.
outer_radius,0]:n.shape==="disk"?[e,n.mass,n.radius,0,n.at]:n.shape==="rod"?[e,n.mass,n.length,0,n.at]:[e,n.mass,0,0,n.at]}var Ft=["friction","impact_normal","i\
mpact_tangential","rolling_resistance"],Lt=["kinetic","potential",...Ft,"residual"],ot=["x","height","angle","vx","vy","omega"];function st({given:n,head:t,rows:e,
count:s,duration:o}){let r=c.events.length,a=Array.from({length:s},(m,f)=>Tt(e.subarray(f*r,(f+1)*r))),i=a[s-1],l=Object.fromEntries([...Lt,...n.contact?["sprin\
g","damping"]:[]].map(m=>[m,t[w[m]]])),h=D(t[w.doubt_from]);return{status:c.statuses[t[w.status]],sequence:Bt(a),fingerprint:h===null?et(e,s):null,duration:o,events:a,
final:{t:i.t,mode:i.to,...Object.fromEntries(ot.map(m=>[m,i[m]]))},energy:l,doubt:h}}function Tt(n){let t=c.kinds[n[p.kind]],e=n[p.from_mode],s={t:n[p.t],kind:t,
from:e<0?null:c.letters[e],to:c.letters[n[p.to_mode]]};for(let o of ot)s[o]=D(n[p[o]]);return s.before=Object.fromEntries(["vx","vy","omega"].map(o=>[o,D(n[p[`b\
efore_${o}`]])])),s.impulse={normal:n[p.impulse_normal],tangential:n[p.impulse_tangential]},n[p.collision]===0&&(s.collision=!1),t==="kane_gain"&&(s.gain=n[p.gain]),
n[p.stable]>=0&&(s.stable=n[p.stable]===1),s}function Bt(n){let t=n.filter((s,o)=>o===n.length-1||!Ht.has(s.kind));return t.slice(0,-1).map((s,o)=>t[o+1].t>s.t?
s.to:"").join("")||(n.at(-1)?.to??"")}var rt;function Mt(n){let t=new Set,e=s=>{ArrayBuffer.isView(s)?t.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(e)};return e(
n),[...t]}function Ut({data:{number:n,compiled:t,call:e,values:s}}){try{if(t){rt=new F(t);return}let o=rt[e](...s);self.postMessage({number:n,answer:o},{transfer:Mt(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",Ut);export{F as HoopModule};
