/* Built from web/kernel/worker.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
var c={sources:"8b55b304b90bb2841a2033a0ba629ce4",module:"08ddd1356e3298fb",derivatives:"caff7ba008cdc5ef",built_with:{numba:"0.68.1",llvmlite:"0.50.0",numpy:"2\
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
"buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var v=n=>Object.fromEntries(n.map((t,e)=>[t,e])),Gt=v(c.cell),w=v(c.heads),p=v(c.events),L=v(c.samples),Dt=v(c.changes),$=v(c.numbers),B=v(c.words),at={law:({impact_law:n})=>c.
impact_laws.indexOf(n),strike:({painleve:n})=>+(n==="impact"),allowed:()=>1},ct=c.cell.map(n=>at[n]??(t=>Number(t[n]??0))),A=n=>Float64Array.from(ct,t=>t(n));function k(n){
let t=n?{...n,law:c.laws.indexOf(n.law),friction_law:c.friction_laws.indexOf(n.friction)}:{};return Float64Array.from(c.compliant,e=>t[e]??Number.NaN)}var S=class{constructor(t){this.exports=t;this.rooms=new Map}room(t,e){let s=this.rooms.get(t);if(s&&s.bytes>=e)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(t);let o=this.exports.malloc(e);if(!o)throw new RangeError("kernel.no_memory");return this.rooms.set(t,{place:o,bytes:e}),o}floats(t,e){return new Float64Array(
this.exports.memory.buffer,t,e)}put(t,e){let s=this.room(t,8*Math.max(e.length,1));return this.floats(s,e.length).set(e),s}};var lt=150,ft=240,mt=6e3,[Pt,I,W]=[0,1,2],ht={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["frict\
ion_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_normal",
"damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function T(n,t,e){let{rows:s,count:o,duration:r}=t,[i,a]=(e??[0,r]).map(d=>Math.
min(Math.max(d,0),r)),l=Math.min(Math.max(Math.ceil((a-i)*lt),ft),mt),m=c.events.length,h=new Set;for(let d=0;d<=l&&r>0;d++)h.add(d===l?a:i+d*((a-i)/l));let f=new Set;
for(let d=0;d<o;d++){let g=Math.min(s[d*m+p.t],r);g>=i&&g<=a&&f.add(g)}for(let d of f)h.add(d);let u=Float64Array.from(h).sort(),x=Float64Array.from(f).filter(d=>d>
0).sort(),y=n.states(t,u,!1),b=n.states(t,x,!0);return M(u,y,x,b)}function M(n,t,e,s){let o=n.length+e.length,r=c.samples.length,i=new Float64Array(o),a=new Float64Array(
o*r),l=0,m=0;for(let f=0;f<n.length;f++)m<e.length&&e[m]<=n[f]&&(i[l]=e[m],a.set(s.subarray(m*r,(m+1)*r),l*r),l++,m++),i[l]=n[f],a.set(t.subarray(f*r,(f+1)*r),l*
r),l++;let h={t:i};for(let[f,u]of Object.entries(ht)){let x=new Float64Array(o).fill(-0);for(let y of u)for(let b=0;b<o;b++)x[b]+=a[b*r+L[y]];h[f]=x}return h.mode=
ut(a,o,h.omega),h}function ut(n,t,e){let s=c.samples.length,o=new Float64Array(t),r=0;for(let i=t-1;i>=0&&!r;i--)r=Math.sign(e[i])||0;for(let i=t-1;i>=0;i--){r=
Math.sign(e[i])||r;let a=n[i*s+L.mode],l=a===I?-1:a===W?1:0;o[i]=l===0?a:l*r<0?I:W}return o}var dt=n=>n/2**32|0,pt=n=>n>>>0;function P(n,t,e,s){let o=dt(e),r=pt(e);n.setUint32(t,s?r:o,s),n.setUint32(t+4,s?o:r,s)}function z(n){return n instanceof Uint8Array||ArrayBuffer.isView(n)&&n.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in n&&n.BYTES_PER_ELEMENT===1}var U=n=>n?
`"${n}" `:"";function xt(n,t=""){if(typeof n!="number")throw new TypeError(U(t)+"expected number, got "+typeof n);if(!Number.isSafeInteger(n)||n<0)throw new RangeError(
U(t)+"expected integer >= 0, got "+n);return n}function R(n,t,e=""){if(z(n)&&(t===void 0||n.length===t))return n;t!==void 0&&xt(t,"length");let s=z(n),o=t!==void 0?` of length ${t}`:"",r=s?`length=${n.length}`:
`type=${typeof n}`,i=U(e)+"expected Uint8Array"+o+", got "+r;throw s?new RangeError(i):new TypeError(i)}var bt=(n,t)=>{if(n===null||typeof n!="object"||Array.isArray(n))throw new TypeError((t==="object"?"":`"${t}" `)+"expected object, got type="+typeof n)},K=(n,t)=>{
bt(n,t);let e=Object.getPrototypeOf(n);if(e!==Object.prototype&&e!==null)throw new TypeError(`"${t}" expected plain object`);if(Object.hasOwn(n,"__proto__"))throw new TypeError(
`"${t}.__proto__" is not allowed`)};function N(n,t=!0){if(n.destroyed)throw new Error("hash was destroyed");if(t&&n.finished)throw new Error("digest() was alrea\
dy called")}function q(n,t){R(n,void 0,"output");let e=t.outputLen;if(!(n.length>=e))throw new RangeError('"output" expected length >= '+e)}function j(...n){for(let t=0;t<n.length;t++)n[t].fill(0)}function H(n){return new DataView(n.buffer,n.byteOffset,n.byteLength)}function _(n,t){return n<<32-t|n>>>
t}function gt(n,t,e="opts"){return K(n,"defaults"),t!==void 0&&K(t,e),Object.assign(Object.create(null),n,t)}function V(n,t={}){if(typeof n!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof n);t=gt({},t,"info");let e=(o,r)=>n(r).update(o).digest(),s=n(void 0);return e.outputLen=s.outputLen,e.blockLen=
s.blockLen,e.canXOF=s.canXOF,e.create=o=>n(o),Object.assign(e,t),Object.freeze(e)}var X=n=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,n])});function J(n,t,e){return n&t^~n&e}function Y(n,t,e){return n&t^n&e^t&e}var O=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(t,e,s,o){
this.blockLen=t,this.outputLen=e,this.padOffset=s,this.isLE=o,this.buffer=new Uint8Array(t),this.view=H(this.buffer)}update(t){N(this),R(t);let{view:e,buffer:s,
blockLen:o}=this,r=t.length,i=!1;for(let a=0;a<r;){let l=Math.min(o-this.pos,r-a);if(l===o){let m=H(t);for(;o<=r-a;a+=o)this.process(m,a);i=!0;continue}s.set(a===
0&&l===r?t:t.subarray(a,a+l),this.pos),this.pos+=l,a+=l,this.pos===o&&(this.process(e,0),this.pos=0,i=!0)}return this.length+=t.length,i&&this.roundClean(),this}digestInto(t){
N(this),q(t,this),this.finished=!0;let{buffer:e,view:s,blockLen:o,isLE:r}=this,{pos:i}=this;e[i++]=128,e.fill(0,i),this.padOffset>o-i&&(this.process(s,0),e.fill(
0)),P(s,o-8,this.length*8,r),this.process(s,0),this.roundClean();let a=t===e?s:H(t),l=this.outputLen,m=l/4,h=this.get();if(l%4||m>h.length)throw new Error("inva\
lid outputLen");for(let f=0;f<m;f++)a.setUint32(4*f,h[f],r)}digest(){let{buffer:t,outputLen:e}=this;this.digestInto(t);let s=t.slice(0,e);return this.destroy(),
s}_cloneIntoMeta(t){let{buffer:e,length:s,finished:o,destroyed:r,pos:i}=this;return t.destroyed=r,t.finished=o,t.length=s,t.pos=i,i&&t.buffer.set(e),t}clone(){return this.
_cloneInto()}},Q=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var yt=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),E=new Uint32Array(64),C=class extends O{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(t,e){super(64,t,8,!1),
this.A=e[0]|0,this.B=e[1]|0,this.C=e[2]|0,this.D=e[3]|0,this.E=e[4]|0,this.F=e[5]|0,this.G=e[6]|0,this.H=e[7]|0}get(){let{A:t,B:e,C:s,D:o,E:r,F:i,G:a,H:l}=this;
return[t,e,s,o,r,i,a,l]}set(t,e,s,o,r,i,a,l){this.A=t|0,this.B=e|0,this.C=s|0,this.D=o|0,this.E=r|0,this.F=i|0,this.G=a|0,this.H=l|0}_cloneInto(t){return(t||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(t)}process(t,e){for(let f=0;f<16;f++,e+=4)E[f]=t.getUint32(e,!1);for(let f=16;f<64;f++){let u=E[f-15],x=E[f-
2],y=_(u,7)^_(u,18)^u>>>3,b=_(x,17)^_(x,19)^x>>>10;E[f]=b+E[f-7]+y+E[f-16]|0}let{A:s,B:o,C:r,D:i,E:a,F:l,G:m,H:h}=this;for(let f=0;f<64;f++){let u=_(a,6)^_(a,11)^
_(a,25),x=h+u+J(a,l,m)+yt[f]+E[f]|0,b=(_(s,2)^_(s,13)^_(s,22))+Y(s,o,r)|0;h=m,m=l,l=a,a=i+x|0,i=r,r=o,o=s,s=x+b|0}s=s+this.A|0,o=o+this.B|0,r=r+this.C|0,i=i+this.
D|0,a=a+this.E|0,l=l+this.F|0,m=m+this.G|0,h=h+this.H|0,this.set(s,o,r,i,a,l,m,h)}roundClean(){j(E)}destroy(){this.destroyed=!0,this.set(0,0,0,0,0,0,0,0),j(this.
buffer)}},G=class extends C{constructor(){super(32,Q)}};var Z=V(()=>new G,X(1));var tt=["t","x","height","angle","vx","vy","omega","slip"],_t=16,wt=0x7ff8000000000000n;function et(n,t){let e=new TextEncoder,s=Z.create(),o=new DataView(new ArrayBuffer(
8*tt.length)),r=new Uint8Array(o.buffer);for(let a=0;a<t;a++){let l=a*c.events.length;s.update(e.encode(c.kinds[n[l+p.kind]])),tt.forEach((m,h)=>{let f=n[l+p[m]];
Number.isNaN(f)?o.setBigUint64(8*h,wt,!0):o.setFloat64(8*h,f+0,!0)}),s.update(r)}return Array.from(s.digest(),a=>a.toString(16).padStart(2,"0")).join("").slice(
0,_t)}function nt(n,t){let e=new Map,s=new Float64Array(t);for(let o=0;o<t;o++){let r=At(n.subarray(o*c.keys,(o+1)*c.keys));if(r===""){s[o]=Number.NaN;continue}let i=e.
get(r);i===void 0&&(i=e.size,e.set(r,i)),s[o]=i}return{values:s,sequences:[...e.keys()]}}function At(n){let t="";for(let e of n){let s=e;for(let o=0;o<c.letters_a_key&&
s;o++){let r=Number(s&7n);s>>=3n,r&&(t+=r===c.more?"+":c.letters[r-1])}}return t}var Et=256,vt=2048,kt=4096,St=2e5,Ht=c.statuses.indexOf("buffer"),Ot=2,Ft=new Set(c.passing),D=n=>Number.isFinite(n)?n:null,F=class{constructor(t){this.kept=[];
this.turn=0;this.exports=new WebAssembly.Instance(t,{}).exports,this.exports._initialize?.(),this.memory=new S(this.exports),this.mostEvents=Et,this.mostSegments=
vt,this.mostRows=kt}call(t,...e){let s=this.exports[t](...e);if(s)throw new Error(`The kernel ended ${t} with ${s}.`)}compute(t){let{memory:e}=this,s=c.events.length;
for(;;){let o=e.room("table",8*s*this.mostEvents),r=e.room("heads",8*c.heads.length);t.contact?this.computeCompliant(t,t.contact,o,r):this.computeRigid(t,o,r);let i=e.
floats(r,c.heads.length).slice(),a=i[w.events];if(i[w.status]===Ht)this.makeRoom(t,i[w.segments]);else if(a===this.mostEvents&&a<t.max_events)this.mostEvents*=4;else{
let l=e.floats(o,a*s).slice();return{given:t,head:i,rows:l,count:a,duration:i[w.duration],segments:i[w.segments]}}}}computeRigid(t,e,s){let{memory:o}=this,r=o.put(
"cell",A(t)),i=o.room("events",c.event_bytes*this.mostEvents),a=o.room("segments",c.segment_bytes*this.mostSegments);this.call("motion",r,i,this.mostEvents,a,this.
mostSegments,e,s)}computeCompliant(t,e,s,o){let{memory:r}=this,i=r.put("cell",A(t)),a=r.put("contact",k(e)),l=r.room("events",c.event_bytes*this.mostEvents),m=r.
room("rows",c.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",i,a,l,this.mostEvents,St,m,this.mostRows,s,o)}makeRoom(t,e){t.contact?this.mostRows=
e:this.mostSegments*=4}motion(t){return st(this.compute(t))}film(t){let e=this.compute(t),[s,o]=t.contact?["rows",c.compliant_segment_bytes]:["segments",c.segment_bytes],
r=this.memory.room(s,8),i=new Uint8Array(this.exports.memory.buffer,r,o*e.segments).slice();return{motion:st(e),columns:T(this,e),pieces:i}}instant(t,e,s){let o=e.
length/(t.contact?c.compliant_segment_bytes:c.segment_bytes);this.memory.put("cell",A(t)),t.contact&&this.memory.put("contact",k(t.contact));let r=Float64Array.
of(s),i=this.states({given:t,segments:o},r,!1,this.placeOf(e)),a=new Float64Array(0);return M(r,i,a,a)}placeOf(t){let e=this.kept.find(r=>r.pieces===t);if(e)return e.
place;let{turn:s}=this;this.turn=(s+1)%Ot;let o=this.memory.room(`pieces ${s}`,Math.max(t.length,1));return new Uint8Array(this.exports.memory.buffer,o,t.length).
set(t),this.kept[s]={pieces:t,place:o},o}columns(t,e){return T(this,this.compute(t),e)}samples(t,e){let s=this.states(this.compute(t),e,!1),o=c.samples.length;return Object.
fromEntries(c.samples.map((r,i)=>[r,Float64Array.from(e,(a,l)=>s[l*o+i])]))}states(t,e,s,o){return this.rows("samples",c.samples.length,t,e,s,o)}margins(t,e,s=!1){
if(t.contact)throw new TypeError("A compliant contact has no such rules.");let o=c.margins.length,r=this.rows("margins",o,this.compute(t),e,s);return Object.fromEntries(
c.margins.map((i,a)=>[i,Float64Array.from(e,(l,m)=>r[m*o+a])]))}rows(t,e,s,o,r,i){let{memory:a}=this,l=o.length*e,m=a.put("times",o),h=a.room("states",8*Math.max(
l,1)),f=a.room("cell",8),u=[s.segments,m,o.length,Number(r),h];return s.given.contact?this.call("compliant_samples",f,a.room("contact",8),i??a.room("rows",8),...u):
this.call(t,f,i??a.room("segments",8),...u),a.floats(h,l).slice()}changes(t,e){let{memory:s}=this,o=this.compute(t),r=s.put("rates",e),i=this.side(o,r,1),{reason:a,
sided:l}=i,m=l||a==="border"||a==="contact"?this.side(o,r,-1):i;return{count:o.count,larger:i,smaller:m}}side({count:t,segments:e,head:s},o,r){let{memory:i}=this,
a=t*c.changes.length,l=i.room("changes",8*a),m=i.room("why",16),[h,f,u]=["cell","events","segments"].map(d=>i.room(d,8)),x=s[w.doubt_from];this.call("changes",h,
o,1,r,f,t,u,e,x,l,m);let[y,b]=i.floats(m,2);return{rates:i.floats(l,a).slice(),reason:c.reasons[Math.max(y,0)],sided:y<0,failed:b}}thresholds(t){let{memory:e}=this,
s=e.put("cell",A(t)),o=e.room("answers",8*c.thresholds.length),r=t.rolling&&t.angle===0;this.call("thresholds",s,r?t.vx:Number.NaN,o);let i=e.floats(o,c.thresholds.
length),a=m=>{let h=i[c.thresholds.indexOf(m)];return Number.isNaN(h)?null:h},l=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a(
"first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immediate_hop_speed"),needed_friction:a("needed_friction"),painleve_friction:a("\
painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:l.filter(m=>m!==null),stable_angle:a("stable_angle"),massless_loss_angle:a("massless_loss_angl\
e"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(t,[e,s,o,r],i,a){let{memory:l}=this,m=l.put("cell",A(t)),h=l.room("modes",i*a),f=l.room(
"sides",2*i);this.call("regions",m,e,s,o,r,i,a,h,f);let{buffer:u}=this.exports.memory;return{modes:new Uint8Array(u,h,i*a).slice(),paradox:Float32Array.from(new Int8Array(
u,f,2*i))}}map({count:t,rows:e},s,o){let{memory:r}=this,i=r.put("cells",e),a=r.room("numbers",8*t*c.numbers.length),l=r.room("words",4*t*c.words.length),m=r.room(
"keys",8*t*c.keys),{angle:h,stop:f,timed:u}=c.spans[o],x=c.wanted[s];this.call("map_cells",i,t,h??Number.NaN,f,u,x,a,l,m);let{buffer:y}=this.exports.memory;if(s===
"sequence")return nt(new BigUint64Array(y,m,t*c.keys),t);let b=new Float64Array(t);if(s in B){let d=new Int32Array(y,l,t*c.words.length);for(let g=0;g<t;g++)b[g]=
d[g*c.words.length+B[s]]}else{let d=r.floats(a,t*c.numbers.length);for(let g=0;g<t;g++)b[g]=d[g*c.numbers.length+$[s]]}return{values:b}}ideal(t){let e=this.memory.
room("answers",8*c.thresholds.length);return this.call("ideal_hoop",t,e),this.memory.floats(e,1)[0]}refused(t){let e=this.memory.put("cell",A(t)),s=this.memory.
put("contact",k(t.contact)),o=this.memory.room("answers",8*c.thresholds.length);this.call("refused",e,s,+!t.contact,o);let[r,i]=this.memory.floats(o,2);return[r,
i]}combine(t,e){let{memory:s}=this,o=s.put("parts",e.flatMap(Lt)),r=s.room("answers",8*c.thresholds.length),i=s.room("reaches",8*e.length);this.call("hoop_of_pa\
rts",t,o,e.length,r,i);let[a,l,m]=s.floats(r,3);return{mass:a,eccentricity:l,inertia_ratio:m,reaches:[...s.floats(i,e.length)]}}chosen(t){let e=this.memory.put(
"cell",A(t)),s=this.memory.put("contact",k(t.contact)),o=this.memory.room("answers",8*c.thresholds.length);this.call("compliance",e,s,o);let r=this.memory.floats(
o,c.chosen.length);return Object.fromEntries(c.chosen.map((i,a)=>[i,r[a]]))}};function Lt(n){let t=n.shape==="rod"?`${n.direction}_rod`:n.shape,e=c.shapes.indexOf(
t);return n.shape==="ring"?[e,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[e,n.mass,n.radius,0,n.at]:n.shape==="rod"?[e,n.mass,n.length,0,n.at]:[e,
n.mass,0,0,n.at]}var Bt=["friction","impact_normal","impact_tangential","rolling_resistance"],Tt=["kinetic","potential",...Bt,"residual"],ot=["x","height","angl\
e","vx","vy","omega"];function st({given:n,head:t,rows:e,count:s,duration:o}){let r=c.events.length,i=Array.from({length:s},(h,f)=>Mt(e.subarray(f*r,(f+1)*r))),
a=i[s-1],l=Object.fromEntries([...Tt,...n.contact?["spring","damping"]:[]].map(h=>[h,t[w[h]]])),m=D(t[w.doubt_from]);return{status:c.statuses[t[w.status]],sequence:Ut(
i),fingerprint:m===null?et(e,s):null,duration:o,events:i,final:{t:a.t,mode:a.to,...Object.fromEntries(ot.map(h=>[h,a[h]]))},energy:l,doubt:m}}function Mt(n){let t=c.
kinds[n[p.kind]],e=n[p.from_mode],s={t:n[p.t],kind:t,from:e<0?null:c.letters[e],to:c.letters[n[p.to_mode]]};for(let o of ot)s[o]=D(n[p[o]]);return s.before=Object.
fromEntries(["vx","vy","omega"].map(o=>[o,D(n[p[`before_${o}`]])])),s.impulse={normal:n[p.impulse_normal],tangential:n[p.impulse_tangential]},n[p.collision]===0&&
(s.collision=!1),t==="kane_gain"&&(s.gain=n[p.gain]),n[p.stable]>=0&&(s.stable=n[p.stable]===1),s}function Ut(n){let t=n.filter((s,o)=>o===n.length-1||!Ft.has(s.
kind));return t.slice(0,-1).map((s,o)=>t[o+1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var rt;function Rt(n){let t=new Set,e=s=>{ArrayBuffer.isView(s)?t.add(s.buffer):s&&typeof s=="object"&&!Array.isArray(s)&&Object.values(s).forEach(e)};return e(
n),[...t]}function Nt({data:{number:n,compiled:t,call:e,values:s}}){try{if(t){rt=new F(t);return}let o=rt[e](...s);self.postMessage({number:n,answer:o},{transfer:Rt(
o)})}catch(o){self.postMessage({number:n,error:o.message})}}typeof self<"u"&&typeof window>"u"&&self.addEventListener("message",Nt);export{F as HoopModule};
