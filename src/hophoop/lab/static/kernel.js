/* Built from web/kernel/worker.ts by esbuild 0.28.2; sources 5469d3f4c4b4d20d6c94c08681f08014 */
var c={sources:"fd852c67161ba4eadb60f19563a6516d",module:"a6c1ed3dcae80b36",derivatives:"caff7ba008cdc5ef",built_with:{numba:"0.68.1",llvmlite:"0.50.0",numpy:"2\
.4.6",ziglang:"0.17.1"},cell:["eccentricity","inertia_ratio","radius","mass","mu_static","mu_kinetic","slope","gravity","restitution","rolling_resistance","dura\
tion","max_events","law","strike","x","height","angle","vy","omega","slip","ideal","allowed"],heads:["status","events","segments","duration","doubt_from","doubt\
_until","panels","kinetic","potential","spring","damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","fr\
om_mode","to_mode","x","height","angle","vx","vy","omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","fri\
ction","impact_normal","impact_tangential","gain","collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","fric\
tion_force","normal_force","friction","impact_normal","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],margins:[
"normal_force","friction_force","friction_limit","free_acceleration","slip","height","p_sigma"],changes:["t","x","height","angle","omega","slip","vy","impact_no\
rmal","impact_tangential","rolling_resistance","vx"],reasons:["none","graze","border","plastic","contact","singular","massless","frictionless","ended"],compliant:[
"law","friction_law","stiffness","damping","restitution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh",
"linear","bristle"],chosen:["stiffness","slip_speed"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_friction","needed_friction_\
angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","massless_loss_by_frictio\
n"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","takeoff_time","takeoff_a\
ngle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","hop","painleve"],keys:4,
letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{angle:6.283185307179586,
stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,status:0,ending:0,
first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,takeoff_time:1,
takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undetermined","event\
_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stick","slip_revers\
al","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:["no","yes"],painleve:[
"no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],impact_laws:["newton","poisson","stro\
nge"],kinds:["start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam",
"kane_gain","skim","rest","end"],passing:["turn","apex","kane_gain","rest"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit",
"buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var E=n=>Object.fromEntries(n.map((t,e)=>[t,e])),Ct=E(c.cell),w=E(c.heads),m=E(c.events),F=E(c.samples),Gt=E(c.changes),D=E(c.numbers),B=E(c.words),it={law:({impact_law:n})=>c.
impact_laws.indexOf(n),strike:({painleve:n})=>+(n==="impact"),allowed:()=>1},at=c.cell.map(n=>it[n]??(t=>Number(t[n]??0))),v=n=>Float64Array.from(at,t=>t(n));function k(n){
let t=n?{...n,law:c.laws.indexOf(n.law),friction_law:c.friction_laws.indexOf(n.friction)}:{};return Float64Array.from(c.compliant,e=>t[e]??Number.NaN)}var S=class{constructor(t){this.exports=t;this.rooms=new Map}room(t,e){let s=this.rooms.get(t);if(s&&s.bytes>=e)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(t);let o=this.exports.malloc(e);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(t,{place:o,bytes:e}),
o}floats(t,e){return new Float64Array(this.exports.memory.buffer,t,e)}put(t,e){let s=this.room(t,8*Math.max(e.length,1));return this.floats(s,e.length).set(e),s}};var ct=150,lt=240,ft=6e3,[Wt,I,$]=[0,1,2],dt={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["frict\
ion_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal",
"damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function T(n,t,e){let{rows:s,count:o,duration:i}=t,[r,a]=(e??[0,i]).map(u=>Math.
min(Math.max(u,0),i)),l=Math.min(Math.max(Math.ceil((a-r)*ct),lt),ft),d=c.events.length,h=new Set;for(let u=0;u<=l&&i>0;u++)h.add(u===l?a:r+u*((a-r)/l));let f=new Set;
for(let u=0;u<o;u++){let g=Math.min(s[u*d+m.t],i);g>=r&&g<=a&&f.add(g)}for(let u of f)h.add(u);let p=Float64Array.from(h).sort(),x=Float64Array.from(f).filter(u=>u>
0).sort(),y=n.states(t,p,!1),b=n.states(t,x,!0);return ht(p,y,x,b)}function ht(n,t,e,s){let o=n.length+e.length,i=c.samples.length,r=new Float64Array(o),a=new Float64Array(
o*i),l=0,d=0;for(let f=0;f<n.length;f++)d<e.length&&e[d]<=n[f]&&(r[l]=e[d],a.set(s.subarray(d*i,(d+1)*i),l*i),l++,d++),r[l]=n[f],a.set(t.subarray(f*i,(f+1)*i),l*
i),l++;let h={t:r};for(let[f,p]of Object.entries(dt)){let x=new Float64Array(o).fill(-0);for(let y of p)for(let b=0;b<o;b++)x[b]+=a[b*i+F[y]];h[f]=x}return h.mode=
ut(a,o,h.omega),h}function ut(n,t,e){let s=c.samples.length,o=new Float64Array(t),i=0;for(let r=t-1;r>=0&&!i;r--)i=Math.sign(e[r])||0;for(let r=t-1;r>=0;r--){i=
Math.sign(e[r])||i;let a=n[r*s+F.mode],l=a===I?-1:a===$?1:0;o[r]=l===0?a:l*i<0?I:$}return o}var mt=n=>n/2**32|0,pt=n=>n>>>0;function W(n,t,e,s){let o=mt(e),i=pt(e);n.setUint32(t,s?i:o,s),n.setUint32(t+4,s?o:i,s)}function z(n){return n instanceof Uint8Array||ArrayBuffer.isView(n)&&n.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in n&&n.BYTES_PER_ELEMENT===1}var M=n=>n?
`"${n}" `:"";function xt(n,t=""){if(typeof n!="number")throw new TypeError(M(t)+"expected number, got "+typeof n);if(!Number.isSafeInteger(n)||n<0)throw new RangeError(
M(t)+"expected integer >= 0, got "+n);return n}function R(n,t,e=""){if(z(n)&&(t===void 0||n.length===t))return n;t!==void 0&&xt(t,"length");let s=z(n),o=t!==void 0?` of length ${t}`:"",i=s?`length=${n.length}`:
`type=${typeof n}`,r=M(e)+"expected Uint8Array"+o+", got "+i;throw s?new RangeError(r):new TypeError(r)}var bt=(n,t)=>{if(n===null||typeof n!="object"||Array.isArray(n))throw new TypeError((t==="object"?"":`"${t}" `)+"expected object, got type="+typeof n)},P=(n,t)=>{
bt(n,t);let e=Object.getPrototypeOf(n);if(e!==Object.prototype&&e!==null)throw new TypeError(`"${t}" expected plain object`);if(Object.hasOwn(n,"__proto__"))throw new TypeError(
`"${t}.__proto__" is not allowed`)};function N(n,t=!0){if(n.destroyed)throw new Error("hash was destroyed");if(t&&n.finished)throw new Error("digest() was alrea\
dy called")}function q(n,t){R(n,void 0,"output");let e=t.outputLen;if(!(n.length>=e))throw new RangeError('"output" expected length >= '+e)}function U(...n){for(let t=0;t<n.length;t++)n[t].fill(0)}function H(n){return new DataView(n.buffer,n.byteOffset,n.byteLength)}function _(n,t){return n<<32-t|n>>>
t}function gt(n,t,e="opts"){return P(n,"defaults"),t!==void 0&&P(t,e),Object.assign(Object.create(null),n,t)}function K(n,t={}){if(typeof n!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof n);t=gt({},t,"info");let e=(o,i)=>n(i).update(o).digest(),s=n(void 0);return e.outputLen=s.outputLen,e.blockLen=
s.blockLen,e.canXOF=s.canXOF,e.create=o=>n(o),Object.assign(e,t),Object.freeze(e)}var V=n=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,n])});function X(n,t,e){return n&t^~n&e}function J(n,t,e){return n&t^n&e^t&e}var L=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(t,e,s,o){
this.blockLen=t,this.outputLen=e,this.padOffset=s,this.isLE=o,this.buffer=new Uint8Array(t),this.view=H(this.buffer)}update(t){N(this),R(t);let{view:e,buffer:s,
blockLen:o}=this,i=t.length,r=!1;for(let a=0;a<i;){let l=Math.min(o-this.pos,i-a);if(l===o){let d=H(t);for(;o<=i-a;a+=o)this.process(d,a);r=!0;continue}s.set(a===
0&&l===i?t:t.subarray(a,a+l),this.pos),this.pos+=l,a+=l,this.pos===o&&(this.process(e,0),this.pos=0,r=!0)}return this.length+=t.length,r&&this.roundClean(),this}digestInto(t){
N(this),q(t,this),this.finished=!0;let{buffer:e,view:s,blockLen:o,isLE:i}=this,{pos:r}=this;e[r++]=128,e.fill(0,r),this.padOffset>o-r&&(this.process(s,0),e.fill(
0)),W(s,o-8,this.length*8,i),this.process(s,0),this.roundClean();let a=t===e?s:H(t),l=this.outputLen,d=l/4,h=this.get();if(l%4||d>h.length)throw new Error("inva\
lid outputLen");for(let f=0;f<d;f++)a.setUint32(4*f,h[f],i)}digest(){let{buffer:t,outputLen:e}=this;this.digestInto(t);let s=t.slice(0,e);return this.destroy(),
s}_cloneIntoMeta(t){let{buffer:e,length:s,finished:o,destroyed:i,pos:r}=this;return t.destroyed=i,t.finished=o,t.length=s,t.pos=r,r&&t.buffer.set(e),t}clone(){return this.
_cloneInto()}},Y=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var yt=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),A=new Uint32Array(64),j=class extends L{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(t,e){super(64,t,8,!1),
this.A=e[0]|0,this.B=e[1]|0,this.C=e[2]|0,this.D=e[3]|0,this.E=e[4]|0,this.F=e[5]|0,this.G=e[6]|0,this.H=e[7]|0}get(){let{A:t,B:e,C:s,D:o,E:i,F:r,G:a,H:l}=this;
return[t,e,s,o,i,r,a,l]}set(t,e,s,o,i,r,a,l){this.A=t|0,this.B=e|0,this.C=s|0,this.D=o|0,this.E=i|0,this.F=r|0,this.G=a|0,this.H=l|0}_cloneInto(t){return(t||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(t)}process(t,e){for(let f=0;f<16;f++,e+=4)A[f]=t.getUint32(e,!1);for(let f=16;f<64;f++){let p=A[f-15],x=A[f-
2],y=_(p,7)^_(p,18)^p>>>3,b=_(x,17)^_(x,19)^x>>>10;A[f]=b+A[f-7]+y+A[f-16]|0}let{A:s,B:o,C:i,D:r,E:a,F:l,G:d,H:h}=this;for(let f=0;f<64;f++){let p=_(a,6)^_(a,11)^
_(a,25),x=h+p+X(a,l,d)+yt[f]+A[f]|0,b=(_(s,2)^_(s,13)^_(s,22))+J(s,o,i)|0;h=d,d=l,l=a,a=r+x|0,r=i,i=o,o=s,s=x+b|0}s=s+this.A|0,o=o+this.B|0,i=i+this.C|0,r=r+this.
D|0,a=a+this.E|0,l=l+this.F|0,d=d+this.G|0,h=h+this.H|0,this.set(s,o,i,r,a,l,d,h)}roundClean(){U(A)}destroy(){this.destroyed=!0,this.set(0,0,0,0,0,0,0,0),U(this.
buffer)}},C=class extends j{constructor(){super(32,Y)}};var Q=K(()=>new C,V(1));var Z=["t","x","height","angle","vx","vy","omega","slip"],_t=16,wt=0x7ff8000000000000n;function tt(n,t){let e=new TextEncoder,s=Q.create(),o=new DataView(new ArrayBuffer(
8*Z.length)),i=new Uint8Array(o.buffer);for(let a=0;a<t;a++){let l=a*c.events.length;s.update(e.encode(c.kinds[n[l+m.kind]])),Z.forEach((d,h)=>{let f=n[l+m[d]];
Number.isNaN(f)?o.setBigUint64(8*h,wt,!0):o.setFloat64(8*h,f+0,!0)}),s.update(i)}return Array.from(s.digest(),a=>a.toString(16).padStart(2,"0")).join("").slice(
0,_t)}function et(n,t){let e=new Map,s=new Float64Array(t);for(let o=0;o<t;o++){let i=At(n.subarray(o*c.keys,(o+1)*c.keys));if(i===""){s[o]=Number.NaN;continue}let r=e.
get(i);r===void 0&&(r=e.size,e.set(i,r)),s[o]=r}return{values:s,sequences:[...e.keys()]}}function At(n){let t="";for(let e of n){let s=e;for(let o=0;o<c.letters_a_key&&
s;o++){let i=Number(s&7n);s>>=3n,i&&(t+=i===c.more?"+":c.letters[i-1])}}return t}var Et=256,vt=2048,kt=4096,St=2e5,Ht=c.statuses.indexOf("buffer"),Lt=new Set(c.passing),G=n=>Number.isFinite(n)?n:null,O=class{constructor(t){this.exports=new WebAssembly.
Instance(t,{}).exports,this.exports._initialize?.(),this.memory=new S(this.exports),this.mostEvents=Et,this.mostSegments=vt,this.mostRows=kt}call(t,...e){let s=this.
exports[t](...e);if(s)throw new Error(`The kernel ended ${t} with ${s}.`)}compute(t){let{memory:e}=this,s=c.events.length;for(;;){let o=e.room("table",8*s*this.
mostEvents),i=e.room("heads",8*c.heads.length);t.contact?this.computeCompliant(t,t.contact,o,i):this.computeRigid(t,o,i);let r=e.floats(i,c.heads.length).slice(),
a=r[w.events];if(r[w.status]===Ht)this.makeRoom(t,r[w.segments]);else if(a===this.mostEvents&&a<t.max_events)this.mostEvents*=4;else{let l=e.floats(o,a*s).slice();
return{given:t,head:r,rows:l,count:a,duration:r[w.duration],segments:r[w.segments]}}}}computeRigid(t,e,s){let{memory:o}=this,i=o.put("cell",v(t)),r=o.room("even\
ts",c.event_bytes*this.mostEvents),a=o.room("segments",c.segment_bytes*this.mostSegments);this.call("motion",i,r,this.mostEvents,a,this.mostSegments,e,s)}computeCompliant(t,e,s,o){
let{memory:i}=this,r=i.put("cell",v(t)),a=i.put("contact",k(e)),l=i.room("events",c.event_bytes*this.mostEvents),d=i.room("rows",c.compliant_segment_bytes*this.
mostRows);this.call("compliant_motion",r,a,l,this.mostEvents,St,d,this.mostRows,s,o)}makeRoom(t,e){t.contact?this.mostRows=e:this.mostSegments*=4}motion(t){return nt(
this.compute(t))}film(t){let e=this.compute(t);return{motion:nt(e),columns:T(this,e)}}columns(t,e){return T(this,this.compute(t),e)}samples(t,e){let s=this.states(
this.compute(t),e,!1),o=c.samples.length;return Object.fromEntries(c.samples.map((i,r)=>[i,Float64Array.from(e,(a,l)=>s[l*o+r])]))}states(t,e,s){return this.rows(
"samples",c.samples.length,t,e,s)}margins(t,e,s=!1){if(t.contact)throw new TypeError("A compliant contact has no such rules.");let o=c.margins.length,i=this.rows(
"margins",o,this.compute(t),e,s);return Object.fromEntries(c.margins.map((r,a)=>[r,Float64Array.from(e,(l,d)=>i[d*o+a])]))}rows(t,e,s,o,i){let{memory:r}=this,a=o.
length*e,l=r.put("times",o),d=r.room("states",8*Math.max(a,1)),h=r.room("cell",8),f=[s.segments,l,o.length,Number(i),d];return s.given.contact?this.call("compli\
ant_samples",h,r.room("contact",8),r.room("rows",8),...f):this.call(t,h,r.room("segments",8),...f),r.floats(d,a).slice()}changes(t,e){let{memory:s}=this,o=this.
compute(t),i=s.put("rates",e),r=this.side(o,i,1),{reason:a,sided:l}=r,d=l||a==="border"||a==="contact"?this.side(o,i,-1):r;return{count:o.count,larger:r,smaller:d}}side({
count:t,segments:e,head:s},o,i){let{memory:r}=this,a=t*c.changes.length,l=r.room("changes",8*a),d=r.room("why",16),[h,f,p]=["cell","events","segments"].map(u=>r.
room(u,8)),x=s[w.doubt_from];this.call("changes",h,o,1,i,f,t,p,e,x,l,d);let[y,b]=r.floats(d,2);return{rates:r.floats(l,a).slice(),reason:c.reasons[Math.max(y,0)],
sided:y<0,failed:b}}thresholds(t){let{memory:e}=this,s=e.put("cell",v(t)),o=e.room("answers",8*c.thresholds.length),i=t.rolling&&t.angle===0;this.call("threshol\
ds",s,i?t.vx:Number.NaN,o);let r=e.floats(o,c.thresholds.length),a=d=>{let h=r[c.thresholds.indexOf(d)];return Number.isNaN(h)?null:h},l=["jam_angle","jam_angle\
_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a("first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immediate_hop_\
speed"),needed_friction:a("needed_friction"),painleve_friction:a("painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:l.filter(d=>d!==null),stable_angle:a(
"stable_angle"),massless_loss_angle:a("massless_loss_angle"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(t,[e,s,o,i],r,a){let{memory:l}=this,
d=l.put("cell",v(t)),h=l.room("modes",r*a),f=l.room("sides",r);this.call("regions",d,e,s,o,i,r,a,h,f);let{buffer:p}=this.exports.memory;return{modes:new Uint8Array(
p,h,r*a).slice(),paradox:Float32Array.from(new Int8Array(p,f,r))}}map({count:t,rows:e},s,o){let{memory:i}=this,r=i.put("cells",e),a=i.room("numbers",8*t*c.numbers.
length),l=i.room("words",4*t*c.words.length),d=i.room("keys",8*t*c.keys),{angle:h,stop:f,timed:p}=c.spans[o],x=c.wanted[s];this.call("map_cells",r,t,h??Number.NaN,
f,p,x,a,l,d);let{buffer:y}=this.exports.memory;if(s==="sequence")return et(new BigUint64Array(y,d,t*c.keys),t);let b=new Float64Array(t);if(s in B){let u=new Int32Array(
y,l,t*c.words.length);for(let g=0;g<t;g++)b[g]=u[g*c.words.length+B[s]]}else{let u=i.floats(a,t*c.numbers.length);for(let g=0;g<t;g++)b[g]=u[g*c.numbers.length+
D[s]]}return{values:b}}ideal(t){let e=this.memory.room("answers",8*c.thresholds.length);return this.call("ideal_hoop",t,e),this.memory.floats(e,1)[0]}refused(t){
let e=this.memory.put("cell",v(t)),s=this.memory.put("contact",k(t.contact)),o=this.memory.room("answers",8*c.thresholds.length);this.call("refused",e,s,+!t.contact,
o);let[i,r]=this.memory.floats(o,2);return[i,r]}combine(t,e){let{memory:s}=this,o=s.put("parts",e.flatMap(Ot)),i=s.room("answers",8*c.thresholds.length),r=s.room(
"reaches",8*e.length);this.call("hoop_of_parts",t,o,e.length,i,r);let[a,l,d]=s.floats(i,3);return{mass:a,eccentricity:l,inertia_ratio:d,reaches:[...s.floats(r,e.
length)]}}chosen(t){let e=this.memory.put("cell",v(t)),s=this.memory.put("contact",k(t.contact)),o=this.memory.room("answers",8*c.thresholds.length);this.call("\
compliance",e,s,o);let i=this.memory.floats(o,c.chosen.length);return Object.fromEntries(c.chosen.map((r,a)=>[r,i[a]]))}};function Ot(n){let t=n.shape==="rod"?`${n.
direction}_rod`:n.shape,e=c.shapes.indexOf(t);return n.shape==="ring"?[e,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[e,n.mass,n.radius,0,n.at]:n.shape===
"rod"?[e,n.mass,n.length,0,n.at]:[e,n.mass,0,0,n.at]}var Ft=["friction","impact_normal","impact_tangential","rolling_resistance"],Bt=["kinetic","potential",...Ft,
"residual"],st=["x","height","angle","vx","vy","omega"];function nt({given:n,head:t,rows:e,count:s,duration:o}){let i=c.events.length,r=Array.from({length:s},(h,f)=>Tt(
e.subarray(f*i,(f+1)*i))),a=r[s-1],l=Object.fromEntries([...Bt,...n.contact?["spring","damping"]:[]].map(h=>[h,t[w[h]]])),d=G(t[w.doubt_from]);return{status:c.statuses[t[w.
status]],sequence:Mt(r),fingerprint:d===null?tt(e,s):null,duration:o,events:r,final:{t:a.t,mode:a.to,...Object.fromEntries(st.map(h=>[h,a[h]]))},energy:l,doubt:d}}
function Tt(n){let t=c.kinds[n[m.kind]],e=n[m.from_mode],s={t:n[m.t],kind:t,from:e<0?null:c.letters[e],to:c.letters[n[m.to_mode]]};for(let o of st)s[o]=G(n[m[o]]);
return s.before=Object.fromEntries(["vx","vy","omega"].map(o=>[o,G(n[m[`before_${o}`]])])),s.impulse={normal:n[m.impulse_normal],tangential:n[m.impulse_tangential]},
n[m.collision]===0&&(s.collision=!1),t==="kane_gain"&&(s.gain=n[m.gain]),n[m.stable]>=0&&(s.stable=n[m.stable]===1),s}function Mt(n){let t=n.filter((s,o)=>o===n.
length-1||!Lt.has(s.kind));return t.slice(0,-1).map((s,o)=>t[o+1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var ot;function Rt(n){let t=new Set,e=s=>{ArrayBuffer.isView(s)?t.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(e)};return e(
n),[...t]}function Nt({data:{number:n,compiled:t,call:e,values:s}}){try{if(t){ot=new O(t);return}let o=ot[e](...s);self.postMessage({number:n,answer:o},{transfer:Rt(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",Nt);export{O as HoopModule};
