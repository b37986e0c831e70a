/* Built from web/lab/player/stage3d.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
function R(n,t){let e=new Float32Array(16);for(let a=0;a<4;a++)for(let s=0;s<4;s++){let i=0;for(let o=0;o<4;o++)i+=n[4*o+s]*t[4*a+o];e[4*a+s]=i}return e}function W(n,t,e,a){
let s=1/Math.tan(n/2),i=1/(e-a);return new Float32Array([s/t,0,0,0,0,s,0,0,0,0,(a+e)*i,-1,0,0,2*a*e*i,0])}function z(n,t){let e=b(L(n,t)),a=b(E([0,1,0],e)),s=E(
e,a);return new Float32Array([a[0],s[0],e[0],0,a[1],s[1],e[1],0,a[2],s[2],e[2],0,-P(a,n),-P(s,n),-P(e,n),1])}var L=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],P=(n,t)=>n[0]*
t[0]+n[1]*t[1]+n[2]*t[2],E=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]];function b(n){let t=Math.hypot(...n)||1;return[n[0]/t,n[1]/t,n[2]/
t]}function S(n,t,e,a){let s=b(t),i=b(E(s,Math.abs(s[2])>.9?[1,0,0]:[0,0,1])),o=E(i,s);return new Float32Array([...i.map(r=>r*a),0,...s.map(r=>r*e),0,...o.map(r=>r*
a),0,...n,1])}function I(n){let[t,e]=[Math.cos(n),Math.sin(n)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function g(n){let t=Number.parseInt(n.slice(1,7),16);
return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}function k(n,t,e){let a=n.createProgram(),s=[[n.VERTEX_SHADER,t],[n.FRAGMENT_SHADER,e]];for(let[o,r]of s){let h=n.createShader(o);if(n.shaderSource(h,r),n.compileShader(
h),!n.getShaderParameter(h,n.COMPILE_STATUS))throw new Error(String(n.getShaderInfoLog(h)));n.attachShader(a,h)}if(n.linkProgram(a),!n.getProgramParameter(a,n.LINK_STATUS))
throw new Error(String(n.getProgramInfoLog(a)));let i={program:a,uniforms:{},attributes:{}};for(let o=0;o<n.getProgramParameter(a,n.ACTIVE_UNIFORMS);o++){let{name:r}=n.
getActiveUniform(a,o);i.uniforms[r]=n.getUniformLocation(a,r)}for(let o=0;o<n.getProgramParameter(a,n.ACTIVE_ATTRIBUTES);o++){let{name:r}=n.getActiveAttrib(a,o);
i.attributes[r]=n.getAttribLocation(a,r)}return i}function v(n,t,e,a){let s=n.createBuffer();n.bindBuffer(n.ARRAY_BUFFER,s),n.bufferData(n.ARRAY_BUFFER,new Float32Array(
t),n.STATIC_DRAW);let i=a?n.createBuffer():null;a&&(n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,i),n.bufferData(n.ELEMENT_ARRAY_BUFFER,new Uint16Array(a),n.STATIC_DRAW));
let o=4*Object.values(e).reduce((r,h)=>r+h,0);return{vertices:s,elements:i,parts:e,stride:o,count:a?a.length:4*t.length/o}}function x(n,t,e){n.bindBuffer(n.ARRAY_BUFFER,
e.vertices);let a=0;for(let[s,i]of Object.entries(e.parts)){let o=t.attributes[s];o!==void 0&&(n.enableVertexAttribArray(o),n.vertexAttribPointer(o,i,n.FLOAT,!1,
e.stride,a)),a+=4*i}e.elements&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.elements)}function F(n,t){let e=[];for(let a=0;a<n;a++)for(let s=0;s<t;s++){let i=a*(t+1)+
s,o=i+t+1;e.push(i,o,i+1,o,o+1,i+1)}return e}function O(n,t=120,e=14){let a=[];for(let s=0;s<=t;s++)for(let i=0;i<=e;i++)a.push(2*Math.PI*s/t,2*Math.PI*i/e);return v(
n,a,{bend:2},F(t,e))}function D(n,t=28,e=18){let a=[];for(let s=0;s<=t;s++)for(let i=0;i<=e;i++){let[o,r]=[2*Math.PI*s/t,Math.PI*i/e],h=[Math.sin(r)*Math.cos(o),
Math.cos(r),Math.sin(r)*Math.sin(o)];a.push(...h,...h)}return v(n,a,{position:3,normal:3},F(t,e))}function C(n,t,e=20){let a=[];for(let s=0;s<=e;s++){let i=2*Math.
PI*s/e,o=[Math.cos(i),1-t,Math.sin(i)];a.push(Math.cos(i),0,Math.sin(i),...o,t*Math.cos(i),1,t*Math.sin(i),...o)}return v(n,a,{position:3,normal:3},F(e,1))}var U=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,j=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,V="vec4(0.0, 0.0, 0.0, shadow)",H=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${j}
   void main() {
     float phi = size.w + bend.x;
     vec2 outwards = vec2(sin(phi), cos(phi));
     vec3 p = center + vec3(outwards * (size.x - size.y + size.y * cos(bend.y)), size.z * sin(bend.y));
     n = vec3(outwards * cos(bend.y) / size.y, sin(bend.y) / size.z);
     vec2 v = motion.xy + motion.z * size.x * vec2(cos(phi), -sin(phi));
     speed = length(v) / most;
     gl_Position = view * vec4(flattened(p, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; varying float speed;
   uniform sampler2D colors; uniform vec3 plain; uniform float colored, shadow;
   ${U}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${V} : vec4(shaded(color, n), 1.0);
   }`],B=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${j}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${U}
   void main() { gl_FragColor = shadow > 0.0 ? ${V} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],G=[`attribute vec3 position, next, tint; attribute fl\
oat side;
   uniform mat4 view; uniform vec2 pixel; uniform float width, distance, shift, depth;
   varying vec3 color;
   void main() {
     vec3 moved = vec3(-shift, 0.0, depth);
     vec4 a = view * vec4(position + moved, 1.0);
     vec4 b = view * vec4(next + moved, 1.0);
     vec2 way = (b.xy / b.w - a.xy / a.w) / pixel;
     float size = length(way);
     vec2 across = size > 1e-6 ? vec2(-way.y, way.x) / size : vec2(0.0, 1.0);
     float wide = distance > 0.0 ? width * distance / a.w : width;
     a.xy += across * side * wide * pixel * a.w;
     gl_Position = a;
     color = tint;
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],M=class{constructor(t,e,a,s,{keep:i=!1}={}){this.canvas=t;this.
dark=s;this.eye=[0,0,1];this.fastest=1;let o=t.getContext("webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:i});if(!o)throw new Error("This browser draws n\
othing in space (WebGL is missing).");this.gl=o,this.sun=b(a),this.slant=[a[0]/a[1],1,a[2]/a[1]],this.rim=k(o,H[0],H[1]),this.body=k(o,B[0],B[1]),this.line=k(o,
G[0],G[1]),this.torus=O(o),this.sphere=D(o),this.cylinder=C(o,1),this.cone=C(o,0),this.colors=o.createTexture(),o.bindTexture(o.TEXTURE_2D,this.colors);let r=new Uint8Array(
e.flatMap(h=>[...h,255]));o.pixelStorei(o.UNPACK_ALIGNMENT,1),o.texImage2D(o.TEXTURE_2D,0,o.RGBA,e.length,1,0,o.RGBA,o.UNSIGNED_BYTE,r);for(let h of[o.TEXTURE_WRAP_S,
o.TEXTURE_WRAP_T])o.texParameteri(o.TEXTURE_2D,h,o.CLAMP_TO_EDGE);for(let h of[o.TEXTURE_MIN_FILTER,o.TEXTURE_MAG_FILTER])o.texParameteri(o.TEXTURE_2D,h,o.LINEAR);
this.view=I(0)}begin({background:t,eye:e,target:a,slope:s,angle:i,near:o,far:r}){let{gl:h,canvas:l}=this;h.viewport(0,0,l.width,l.height),h.clearColor(t[0],t[1],
t[2],1),h.clear(h.COLOR_BUFFER_BIT|h.DEPTH_BUFFER_BIT|h.STENCIL_BUFFER_BIT),h.enable(h.DEPTH_TEST);let c=W(i,l.width/l.height,o,r);this.view=R(R(c,z(e,a)),I(s)),
this.eye=b(L(e,a))}use(t,e){let{gl:a}=this;a.useProgram(t.program);let s={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...e};for(let[i,o]of Object.
entries(s)){let r=t.uniforms[i];r!==void 0&&(typeof o=="number"?a.uniform1f(r,o):o.length===16?a.uniformMatrix4fv(r,!1,o):a[`uniform${o.length}fv`](r,o))}}ground(t){
let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.
ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),t(),e.depthMask(!0),e.
depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,a,{shadow:s=!1,lit:i=!0}={}){let{gl:o}=this;this.use(this.body,{model:e,color:a,shadow:s?
this.dark:0,lit:Number(i)}),x(o,this.body,t),o.drawElements(o.TRIANGLES,t.count,o.UNSIGNED_SHORT,0)}ball(t,e,a,s){this.solid(this.sphere,S(t,[0,1,0],e,e),a,{shadow:s})}ring({
center:t,radius:e,tube:a,broad:s,angle:i,velocity:o,omega:r,plain:h=null},l){let{gl:c}=this;this.use(this.rim,{center:t,size:[e,a,s,i],motion:[...o,r],most:this.
fastest,shadow:l?this.dark:0,plain:h??[0,0,0],colored:h?0:1}),x(c,this.rim,this.torus),c.drawElements(c.TRIANGLES,this.torus.count,c.UNSIGNED_SHORT,0)}rod(t,e,a,s,i,o=!1){
this.solid(this.cylinder,S(t,e,a,s),i,{shadow:o})}arrow(t,e,a,s,i){if(!(a>.02*s))return;let o=Math.min(.18*s,a),r=t.map((h,l)=>h+e[l]*(a-o));a>o&&this.rod(t,e,a-
o,.029*s,i),this.solid(this.cone,S(r,e,o,Math.min(.075*s,.6*o)),i)}trace(t,e,a){let s=[];for(let i=0;i<t;i++){let o=e(i),r=e(Math.min(i+1,t-1));if(Math.hypot(r[0]-
o[0],r[1]-o[1])<1e-9&&i>0){let h=e(i-1);r=o.map((l,c)=>2*l-h[c])}for(let h of[-1,1])s.push(...o,0,...r,0,...a(i),h)}return v(this.gl,s,{position:3,next:3,tint:3,
side:1})}drawTrace(t,e,{width:a,distance:s=0,shift:i,depth:o}){let{gl:r,canvas:h}=this;this.use(this.line,{pixel:[2/h.width,2/h.height],width:a,distance:s,shift:i,
depth:o}),x(r,this.line,t),r.drawArrays(r.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,a]){let s=this.view,[i,o,r]=[0,1,3].map(h=>s[h]*t+s[4+h]*e+s[8+h]*a+s[12+h]);return r>
0?[(.5+.5*i/r)*this.canvas.width,(.5-.5*o/r)*this.canvas.height]:null}};function q(n){let t=Number.parseInt(n.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}var A=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function oe(){let n=[];for(let t=0;t<256;t++){let e=t/255*(A.length-
1),a=Math.min(Math.floor(e),A.length-2),s=q(A[a]),i=q(A[a+1]);n.push(s.map((o,r)=>Math.round(o+(i[r]-o)*(e-a))))}return n}var N=oe(),ye=N.map(n=>`rgb(${n.join("\
,")})`);var Y={"axis.hoop.eccentricity":"Eccentricity ε","axis.hoop.inertia_ratio":"Inertia ratio κ","axis.hoop.load_fraction":"Load fraction γ","axis.hoop.radius":"\
Radius R","axis.plane.gravity":"Gravity g","axis.plane.mu":"Friction μ","axis.plane.restitution":"Restitution e","axis.plane.rolling_resistance":"Rolling resis\
tance f","axis.plane.slope":"Slope β","axis.start.angle":"Angle of the load θ₀","axis.start.height":"Height of the gap y₀","axis.start.omega":"Angular vel\
ocity θ̇₀","axis.start.speed":"Speed v₀","axis.start.vx":"Speed along ẋ₀","backend.the_notebooks_kernel_does":"The notebook’s kernel does not respond;\
 run the cell again.","backend.the_server_answered_status":"The server returned {status}.","backend.the_server_does_not":"The server does not respond. The motio\
n still plays; for changes, start `hophoop lab` again.","challenge.at_most_10_m":"At most 10 m/s.","challenge.at_most_3_1":"At most 3.1 m/s.","challenge.at_most\
_6_s":"At most 6 s.","challenge.at_most_90_of":"At most 90 % of the mass may be in the load.","challenge.begin_again":"Start again","challenge.friction_must_be_\
at":"Friction must not exceed 1.5.","challenge.hop_highest":"Hop highest","challenge.hop_without_skidding":"Hop without skidding","challenge.it_does_not_hop":"I\
t does not hop.","challenge.it_lands_off_away":"It lands {off} from the top.","challenge.it_must_be_on":"Gravity must be that of Earth.","challenge.it_must_star\
t_rolling":"The hoop must start rolling.","challenge.it_rises_by_height":"It rises by {height}.","challenge.it_skids_before_it":"It skids before it hops.","chal\
lenge.land_upright":"Land upright","challenge.leave_the_challenges":"Leave the challenges","challenge.let_the_hoop_land":"Let the hoop land with its load at the\
 very top. Everything is allowed; the first hop has to be at least 5 cm high.","challenge.on_level_ground_rolling":"On level ground, rolling, with at most 3.1 m\
/s: you choose the load, where it starts, and friction. How high can the hoop rise within 6 s?","challenge.on_level_ground_the":"On level ground the hoop starts\
 rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",
"challenge.restitution_must_be_0":"Restitution must be 0.","challenge.rigid_contact_only":"Rigid contact only.","challenge.score":"Score","challenge.show_a_best\
_one":"Show a best solution","challenge.stars_points_points_shown":{one:"{stars} {count} point, shown and not counted. {what}",other:"{stars} {count} points, sh\
own and not counted. {what}"},"challenge.stars_points_points_what":{one:"{stars} {count} point. {what}",other:"{stars} {count} points. {what}"},"challenge.the_f\
irst_hop_is":"The first hop is too low.","challenge.the_hoop_must_be":"The hoop must be given by its load fraction.","challenge.the_load_must_start":"The load m\
ust start at the bottom.","challenge.the_plane_must_be":"The plane must be level.","challenge.the_radius_must_stay":"The radius must stay 1 m, without parts.","\
challenge.which_challenge":"Which challenge","challenge.your_best_points_points":{one:"Your best: {count} point.",other:"Your best: {count} points."},"choice.co\
ntact.friction.bristle":"bristle (can hold)","choice.contact.friction.linear":"linear","choice.contact.friction.tanh":"smooth (tanh)","choice.contact.law.hunt-c\
rossley":"Hunt–Crossley","choice.contact.law.kelvin-voigt":"Kelvin–Voigt","choice.contact.model.compliant":"compliant","choice.contact.model.rigid":"rigid",
"choice.plane.impact_law.newton":"Newton (velocity)","choice.plane.impact_law.poisson":"Poisson (impulse)","choice.plane.impact_law.stronge":"Stronge (energy)",
"choice.plane.painleve.flight":"flight","choice.plane.painleve.impact":"impact","class.duration":"duration","class.event_limit":"event limit","class.jam":"jam",
"class.no":"no","class.rest":"rest","class.reversal":"reversal","class.revolutions":"revolutions","class.takeoff":"takeoff","class.undetermined":"undetermined",
"class.yes":"yes","column.angle":"angle","column.angle_within_a_turn":"angle within a revolution","column.angular_velocity":"angular velocity","column.friction_\
force":"friction force","column.gap_under_the_rim":"gap under the rim","column.height_of_the_centre":"height of the centre of gravity","column.kinetic_energy":"\
kinetic energy","column.normal_force":"normal force","column.place_of_the_centre":"displacement of the centre","column.potential_energy":"potential energy","col\
umn.slip_velocity":"slip velocity","column.speed_away_from_the":"speed away from the plane","column.speed_of_rotation":"circumferential speed","column.speed_of_\
the_centre":"speed of the centre","column.theta_mod_360":"θ mod 360°","column.time":"time","column.total_energy":"total energy","column.use_of_friction":"fric\
tion utilization","controls.auto_value":"auto {value}","controls.contact":"Contact","controls.elsewhere":"elsewhere","controls.epsilon_and_kappa":"ε and κ","c\
ontrols.given_by":"Defined by","controls.hoop":"Hoop","controls.in_any_state":"in any state","controls.label_value_is_too":"{label} = {value} is too large.","co\
ntrols.load_fraction_gamma":"load fraction γ","controls.name_exact_value":"{name}, exact value","controls.name_exact_value_in":"{name}, exact value in {unit}",
"controls.name_value_must_be":"{name} = {value} must be a number, such as 2.5.","controls.name_value_must_be_rule":"{name} = {value} must be {rule}.","controls.\
plane":"Plane","controls.real_parts":"list of parts","controls.rolling":"rolling","controls.start":"Start","controls.starts":"Starts","controls.static_and_kinet\
ic_friction":"separate static and kinetic friction","controls.where":"Where","diagram.a_blue_b_ochre":"A blue, B ochre; dashes show the quantity; values of {hoo\
p}; {hands}","diagram.click_to_go_there":"click to go there, drag to zoom; after a click, or with Ctrl, the wheel zooms; double-click shows all","diagram.contac\
t_forces":"Contact forces","diagram.diagram_title_in_unit":"Diagram: {title} in {unit}.","diagram.energies_and_losses":"Energies and losses","diagram.energy_j":"\
energy [J]","diagram.force_n":"force [N]","diagram.friction_f":"friction F","diagram.horizontal_axis_of_the":"Horizontal axis of the diagrams","diagram.kinetic":"\
kinetic","diagram.lost_in_impacts_normal":"lost in impacts, normal part","diagram.lost_in_the_damper":"lost in the damper","diagram.lost_to_friction":"lost to f\
riction","diagram.lost_to_rolling_resistance":"lost to rolling resistance","diagram.name_from_low_to":"{name} from {low} to {high}","diagram.normal_n":"normal N",
"diagram.over_quantity":"over {quantity}","diagram.potential":"potential","diagram.slide_to_go_there":"slide to go there, two fingers zoom","diagram.total":"tot\
al","diagram.use_of_friction":"Friction utilization","diagram.v_centre":"v (centre)","diagram.velocities":"Velocities","diagram.velocity_m_s":"velocity [m/s]","\
diagram.what_your_diagram_shows":"Quantity of your diagram","diagram.whole_motion":"Whole motion","diagram.your_choice":"Your choice","embed.a_hopping_hoop":"A \
hopping hoop","embed.as_a_frame_where":"As a frame, for pages without scripts","embed.as_a_qr_code":"As a QR code","embed.as_a_tag":"As a tag","embed.choose_a_m\
otion_in":"Choose a motion in the lab and copy its link here.","embed.copied":"Copied.","embed.copy_the_frame":"Copy the frame","embed.copy_the_tag":"Copy the t\
ag","embed.diagrams":"diagrams","embed.how_it_looks":"Preview","embed.map":"map","embed.one_tag_and_one":"One tag and one script show a live hoop in a blog, a c\
ourse page or slides. The motion is computed in the reader’s browser; nothing is sent anywhere.","embed.put_a_hopping_hoop":"Put a hopping hoop into your own \
page","embed.scenario_a_link_of":"Scenario: a link of the lab, or the part after its question mark","embed.sliders":"sliders","embed.the_frame":"The frame","emb\
ed.the_tag":"The tag","embed.theory":"theory","embed.what_stands_beside_the":"Panels next to the player","event.apex":"highest point","event.bounce_limit":"boun\
ces end","event.end":"end","event.impact":"landing","event.jam":"jam","event.kane_gain":"energy gain (Kane)","event.painleve_inconsistent":"Painlevé: no solutio\
n","event.painleve_indeterminate":"Painlevé: several solutions","event.rest":"at rest","event.skim":"skimming starts","event.slip_reversal":"slip reverses","ev\
ent.slip_start":"slip starts","event.start":"start","event.stick":"slip ends","event.takeoff":"take-off","event.turn":"turns back","example.bounces":"Bounces wi\
thout number","example.bounces.text":"Dropped with spin and restitution 0.5: infinitely many bounces in finite time.","example.downhill":"Downhill","example.dow\
nhill.text":"On a slope of 10° the hoop gains speed from turn to turn, until it hops.","example.hop":"It hops: 3.1 m/s","example.hop.text":"Slips twice, then l\
eaves the plane just before a full turn and flies for 0.76 s.","example.inconsistent":"Painlevé: no solution","example.inconsistent.text":"No contact force agr\
ees with this slip. An impact without collision stops it at once.","example.indeterminate":"Painlevé: two solutions","example.indeterminate.text":"Flight and i\
mpact both agree with the laws. Choose which with the switch under Plane.","example.jam":"Dynamic jam","example.jam.text":"A fast slide after a hop: the contact\
 force grows without bound in finite time, and no law says what follows.","example.kane":"Kane: energy out of nothing","example.kane.text":"Newton's law of impa\
ct with friction creates two joules. Stronge's law does not.","example.littlewood":"All mass in the load","example.littlewood-fast":"All mass in the load, pushe\
d","example.littlewood-fast.text":"With a push the contact force is gone earlier, at cos θ = v₀²/(gR).","example.littlewood.text":"A massless ring: at 90° n\
o contact force is left; the load falls, the rim skims the plane.","example.moon":"On the Moon","example.moon.text":"The article's hop under lunar gravity: ever\
ything is slower by a factor of 2.46.","example.nearly-massless":"Nearly all mass in the load","example.nearly-massless.text":"γ = 0.99: what a real ring does i\
nstead of Littlewood's hop.","example.roll":"It rolls: 2 m/s","example.roll.text":"Pure rolling, faster and more even than after a slow start, and close to the \
limit of friction.","example.slip":"It slips: 2.8 m/s","example.slip.text":"Friction is used up twice a turn; each slip is weaker than the one before, and none \
is the last.","example.slippery":"Low friction: 0.1 m/s, μ = 0.3","example.slippery.text":"Slipping costs the energy that a full turn needs: the hoop rocks to \
and fro.","example.slow":"The smallest push: 0.1 m/s","example.slow.text":"Nearly at rest with the load up, fast with the load down; 38 % of the friction is use\
d.","examples.article":"The article","examples.littlewood":"Littlewood's hoop","examples.more":"More","examples.paradoxes":"Paradoxes","fingerprint.same_bits_as\
_in":"✓ Same bits as in Python","fingerprint.same_bits_as_where":"✓ Same bits as where the link was made","fingerprint.the_bits_differ_own":"The bits differ\
: {own} here, {other} in Python.","fingerprint.the_bits_differ_own_here":"The bits differ: {own} here, {other} where the link was made, perhaps with another ver\
sion.","gravity.earth":"Earth","gravity.jupiter":"Jupiter","gravity.mars":"Mars","gravity.moon":"Moon","gravity.weightless":"Weightless","hand.angle_of_the_load":"\
Angle of the load","hand.drag_the_load":"Drag the load","hand.gap_height_speed_speed":"gap {height}, speed {speed} m/s","hand.lift_roll_or_throw":"Lift, roll or\
 throw the hoop: drag, or arrow keys","hand.slope_of_the_plane":"Slope of the plane","hand.the_hoop_height_and":"The hoop: height and speed","hand.the_hoop_in_y\
our":"The hoop in your hand","hand.tilt_the_plane_drag":"Tilt the plane: drag, or arrow keys","hand.turn_the_load_drag":"Turn the load: drag, or arrow keys","he\
ader.compare":"Compare","header.compare_two_hoops":"Compare two hoops","header.dark_or_light_d":"Dark or light (d)","header.examples":"Examples","header.example\
s_2":"Examples …","header.keys_and_help":"Keys and help (?)","header.lab":"lab","header.redo_y":"Redo (y)","header.undo_z":"Undo (z)","help.contact.friction":"\
Regularised friction","help.contact.law":"Normal force","help.contact.model":"Contact model","help.contact.restitution":"Restitution that the damping is chosen \
for","help.contact.slip_speed":"Slip velocity over which friction builds up","help.contact.stiffness":"Stiffness of the contact","help.duration":"Duration of th\
e motion","help.hoop.eccentricity":"Distance of the centre of gravity from the centre, over the radius","help.hoop.inertia_ratio":"Moment of inertia about the c\
entre of gravity over m R²","help.hoop.load_fraction":"Share of the mass in the load of an ideal hoop","help.hoop.mass":"Total mass","help.hoop.radius":"Rim ra\
dius","help.plane.gravity":"Gravity","help.plane.impact_law":"Law of restitution","help.plane.mu":"Friction, static and kinetic","help.plane.mu_kinetic":"Kineti\
c friction","help.plane.mu_static":"Static friction","help.plane.painleve":"What follows an indeterminate contact","help.plane.restitution":"Restitution of an i\
mpact","help.plane.rolling_resistance":"Rolling resistance: couple against the rotation over R N","help.plane.slope":"Slope of the plane, downhill along +x","he\
lp.start.angle":"Angle from the plane's normal to the centre of gravity","help.start.height":"Gap between rim and plane","help.start.omega":"Angular velocity","\
help.start.speed":"Velocity of the centre in a rolling start","help.start.vx":"Velocity of the centre along the plane","help.start.vy":"Velocity of the centre a\
way from the plane","hoops.hoop_a":"Hoop A","hoops.hoop_b":"Hoop B","hoops.which_hoop_the_controls":"Which hoop the controls change","kernel.no_memory":"There i\
s not enough memory for this motion.","kernel.not_loaded":"The module could not be loaded ({status}).","kernel.not_started":"The kernel could not be started.","\
kernel.stopped":"Stopped after {time} s.","kernel.the_part_of_the":"The module that computes this could not be loaded; try again when there is a network.","keys\
.a_massless_rim_that":"a massless rim in contact without force","keys.a_ring_with_a":"A ring with a load on its rim rolls on a plane. Friction is limited, and t\
he plane can only push. So the hoop slips, hops, lands – or meets a case that rigid-body mechanics cannot decide. Move a slider and watch.","keys.arrows_what_\
a_little":"arrows: effect of a small change","keys.bounces_without_number_end":"end of infinitely many bounces","keys.commands":"Commands","keys.dark_light":"da\
rk, light","keys.docs_index_md_in":"docs/index.md in the source; this page: docs/lab.md","keys.documentation":"Documentation","keys.esc":"Esc","keys.home_end":"\
Home End","keys.hophoop_computes_exactly_how":"hophoop computes exactly how a hoop with a load on its rim rolls, slips, hops and lands.","keys.in_space":"in spa\
ce","keys.keys":"Keys","keys.keys_and_help":"Keys and help","keys.leave_a_field_a":"leave a field, a menu, or a picture zoomed by the wheel","keys.licence":"Lic\
ence","keys.licences_of_all_that":"Licences of all that the page contains","keys.marks_on_the_bar":"Marks on the time bar","keys.modes":"Modes","keys.next_fligh\
t_landing":"next flight, landing","keys.one_frame":"one frame","keys.painleves_paradox_no_solution":"Painlevé’s paradox: no solution, several","keys.play_pau\
se":"play, pause","keys.previous_next_event":"previous, next event","keys.python":"Python","keys.shift":"Shift ← →","keys.single_keys_letters_digits":"Enabl\
e single-key shortcuts (letters, digits, signs)","keys.skimming_begins_rest":"skimming starts, rest","keys.slip_the_rim_slides":"slip: the rim slides ahead","ke\
ys.slip_the_rim_turns":"slip: the rim turns too fast for its motion along the plane","keys.slower_faster":"slower, faster","keys.space":"space","keys.start_end":"\
start, end","keys.take_off_landing":"take-off, landing","keys.the_documentation":"The documentation","keys.the_hop_from_take":"the hop: from take-off to landing",
"keys.the_rim_does_not":"the rim does not slide","keys.traces_forces_rim_speed":"traces, forces, rim speed, whole path","keys.undo_redo":"undo, redo","keys.vers\
ion":"Version","keys.z_y_ctrl_z":"z y  Ctrl Z","keys.zoom_zoom_back":"zoom in, zoom out, reset","lab.cell_turns":"A cell of this map is about {turns} revolution\
s and must be at most {most} in the lab.","lab.compliant_changes":"With a compliant contact no derivatives are computed: choose the rigid contact model.","lab.d\
oubt":"After {time} s the motion depends on more digits than this page computes. Run it in hophoop lab or Python for the exact result.","lab.equal_axes":"x.path\
 and y.path are both {path} and must differ.","lab.film_too_long":"duration = {duration} must be at most {most} s for a film from the lab.","lab.map_turns":"x a\
nd y make {cells} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter duration.","lab.\
not_a_pair":"changes holds {change}, which is not a pair of path and value.","lab.number_path":"must be a number's path, not that of a word","lab.one_of":"must \
be one of {known}","lab.rigid_maps":"contact.model = 'compliant' must be 'rigid' for a map.","lab.times":"must be two times, from and to [s], rising from 0","la\
b.too_long":"duration = {duration} must be at most {most} s in the lab; the library itself has no such limit.","lab.too_many_cells":"x.cells times y.cells = {ce\
lls} must be at most {most} in the lab.","lab.too_many_changes":"changes has {pairs} pairs and must have at most {most} in the lab.","lab.too_many_parts":"hoop.\
parts has {parts} parts and must have at most {most} in the lab.","lab.too_many_turns":"duration = {duration} s at this speed and radius is about {turns} revolu\
tions and must be at most {most} in the lab; the library itself has no such limit.","lab.too_stiff":"This motion needs about {steps} million steps; at most {mos\
t} million are computed here: shorten the duration or soften the contact.","lab.two_axes":"{one} and {other} cannot both be axes: they say the same thing in two\
 ways.","lab.window":"must be four numbers, θ from and to [rad], θ̇ from and to [rad/s], each pair rising","language.language":"Language","language.not_loade\
d":"This language could not be loaded; choose it again when there is a network.","list.comma":", ","list.or":"{some} or {last}","map.across":"Horizontal","map.a\
nd_count_more":"and {count} more","map.click_to_take_that":"Tap to show that motion in the player; two fingers zoom.","map.click_to_take_that_motion":"Click to \
show that motion in the player; after a click, or with Ctrl, the wheel zooms; drag to move; double-click shows all.","map.computing_count_motions":{one:"computi\
ng {count} motion …",other:"computing {count} motions …"},"map.count_motions":{one:"{count} motion",other:"{count} motions"},"map.count_motions_with_rigid":{
one:"{count} motion with rigid contact",other:"{count} motions with rigid contact"},"map.map":"Map","map.map_of_motions":"Map of motions","map.map_of_motions_ar\
row":"Map of motions. Arrow keys move the mark, Enter shows the motion, plus and minus zoom.","map.none":"none","map.not_allowed":"not allowed","map.of":"of","m\
ap.of_rolling_starts_though":"with a rolling start, unlike this motion","map.of_starts_in_any":"with a start in any state; this motion starts rolling","map.spin\
_and_skid":"Spin and skid are named for forward rotation; for backward rotation they change places.","map.up":"Vertical","map.what_the_map_shows":"Quantity of t\
he map","map.whole_map":"Whole map","map.zoom_into_the_map":"Zoom into the map","map.zoom_out_of_the":"Zoom out of the map","menu.about_hophoop":"About hophoop",
"menu.challenges":"Challenges","menu.for_teachers":"For teachers","menu.guided_visit":"Guided visit","menu.hophoop_lab_play_with":"hophoop lab: play with the ho\
pping hoop","menu.learn":"Learn","menu.presentation":"Presentation","menu.presentation_on_the_whole":"Presentation in full screen","menu.repeat":"Repeat","menu.\
slow_motion_a_tenth":"Slow motion: a tenth of the speed","menu.sound_of_the_contact":"Sound of the contact","mode.flight":"flight","mode.roll":"roll","mode.skid":"\
skid","mode.skim":"skim","mode.spin":"spin","motion.a_hash_of_all":"Hash of all events: equal wherever hophoop computes the same bits, also in Python","motion.c\
opied":"Copied","motion.copy":"Copy","motion.fingerprint":"Fingerprint","motion.no_fingerprint_this_motion":"No fingerprint: this motion depends on more digits \
than this page computes.","motion.not_all_events_are":"(not all events are shown)","motion.the_motion_in_words":"The motion in words","motion.what_happens":"Wha\
t happens","motion.what_happens_to_hoop":"What happens to hoop {hoop}","motion.what_theory_says":"Theory","motion.what_theory_says_of":"Theory for hoop {hoop}",
"page.not_loaded":"This part of the page could not be loaded; try again when there is a network.","page.parameters":"Parameters","page.skip_to_the_player":"Skip\
 to the player","page.this_needs_a_browser":"This needs a browser that runs WebAssembly.","parameter.contact.friction":"Friction law","parameter.contact.law":"N\
ormal force","parameter.contact.model":"Contact model","parameter.contact.restitution":"Restitution","parameter.contact.slip_speed":"Slip speed","parameter.cont\
act.stiffness":"Stiffness","parameter.duration":"Duration","parameter.hoop.eccentricity":"Eccentricity","parameter.hoop.inertia_ratio":"Inertia ratio","paramete\
r.hoop.load_fraction":"Load fraction","parameter.hoop.mass":"Mass","parameter.hoop.radius":"Radius","parameter.plane.gravity":"Gravity","parameter.plane.impact_\
law":"Law of impact","parameter.plane.mu":"Friction","parameter.plane.mu_kinetic":"Kinetic friction","parameter.plane.mu_static":"Static friction","parameter.pl\
ane.painleve":"Painlevé: two solutions","parameter.plane.restitution":"Restitution","parameter.plane.rolling_resistance":"Rolling resistance","parameter.plane.\
slope":"Slope","parameter.start.angle":"Load angle","parameter.start.height":"Height of the gap","parameter.start.omega":"Angular velocity","parameter.start.spe\
ed":"Speed","parameter.start.vx":"Speed along","parameter.start.vy":"Speed upwards","parts.add_a_part":"Add a part","parts.add_a_part_2":"+ add a part …","par\
ts.disk":"Disk","parts.distance_from_centre":"distance from the centre","parts.inner_radius":"inner radius","parts.length":"length","parts.mass":"mass","parts.o\
uter_radius":"outer radius","parts.point_mass":"Point mass","parts.radius":"radius","parts.remove_part_number_what":"Remove part {number}, {what}","parts.ring":"\
Ring","parts.rod":"Rod","phase.angle_theta_within_a":"angle θ within a revolution [°]","phase.click_to_go_there":"Tap to go there; two fingers zoom.","phase.c\
lick_to_go_there_once":"Click to go there; after a click, or with Ctrl, the wheel zooms; double-click shows all.","phase.colours":"Colours: mode that follows co\
ntact without slip.","phase.hatched":"Hatched: slip with Painlevé’s paradox.","phase.plane_of_angle_and":"Phase plane of angle and angular velocity with the \
regions of rolling, slip and flight","phase.plane_of_theta_and":"Phase plane of θ and θ̇","player.a_in_front_b":"A in front, B behind","player.centre_of_grav\
ity":"centre of gravity","player.forces":"Forces","player.forces_f":"Forces (f)","player.gap":"gap","player.hoop":"hoop","player.in_space_3":"In space (3)","pla\
yer.load":"load","player.next_event_shift":"Next event (Shift →)","player.one_frame_back":"One frame back (←)","player.one_frame_on":"One frame forward (→)",
"player.pause_space":"Pause (space)","player.play_space":"Play (space)","player.previous_event_shift":"Previous event (Shift ←)","player.rim_speed":"rim speed",
"player.rim_speed_2":"Rim speed","player.rim_speed_c":"Rim speed (c)","player.speed_of_the_film":"Playback speed","player.the_hoop":"The hoop","player.the_hoop_\
2":"The hoop.","player.the_same_in_flight":"in flight","player.this_motion_has_no":"This motion has no flight.","player.this_motion_has_no_landing":"This motion\
 has no landing.","player.time":"Time","player.time_seconds_what":"{time} seconds, {what}","player.to_the_next_flight":"To the next flight (h)","player.to_the_n\
ext_landing":"To the next landing (l)","player.to_the_start_home":"To the start (Home)","player.traces":"Traces","player.traces_t":"Traces (t)","player.what_at_\
angle_time":"{what} at {angle}, {time} s","player.whole_path":"Whole path","player.whole_path_w":"Whole path (w)","plot.cut":"axis cut: values from {low} to {hi\
gh}","quantity.end_angle":"angle at the end","quantity.ending":"how it ends","quantity.energy_lost":"energy lost","quantity.flight_time":"duration of the first \
hop","quantity.greatest_utilization":"greatest friction utilization","quantity.hop_height":"height of the first hop","quantity.painleve":"Painlevé’s paradox or \
jam met","quantity.sequence":"what happens in the first turn","quantity.takeoff_angle":"angle of take-off","range.from_to":"from {least} to {most}","range.from_\
to_or_inf":"from {least} to {most}, or inf","range.zero_or_from_to":"0 or from {least} to {most}","range.zero_or_from_to_or_inf":"0 or from {least} to {most}, o\
r inf","reason.border":"the motion lies on the border of two classes: the least change may lead to other events","reason.contact":"the motion starts in contact:\
 with the rim lifted or thrown it would bounce, and its events are others","reason.edge":"the parameter is at the edge of what is allowed","reason.ended":"the m\
otion has no answer from there on","reason.frictionless":"without friction the hoop rests on no more than a border of two classes","reason.graze":"a quantity th\
at sets off the event only touches zero there","reason.massless":"the massless hoop (γ = 1) is a singular limit once the contact force is lost","reason.plastic":"\
restitution is 0 and the rim has landed: with any restitution it would bounce","reason.sided":"the derivatives of the two sides differ","reason.singular":"the s\
lip runs into p_σ = 0, where the contact force has no bound","refusal.beyond_the_rim":"hoop.parts.{index} ({shape}) reaches {reach} m from the centre, beyond t\
he rim: hoop.radius = {radius}.","refusal.compliant_friction":"plane.mu_static = inf must be finite with contact.model = 'compliant'.","refusal.did_you_mean":"d\
id you mean {close}?","refusal.finding":"{path} = {shown} {allowed}.","refusal.finite_number":"must be a finite number","refusal.friction":"must be at least 0 (\
inf is allowed)","refusal.given_twice":"{path} is given twice.","refusal.greater_than":"must be greater than {limit}","refusal.greater_than_equal":"must be at l\
east {limit}","refusal.half_a_hoop":"hoop.{missing} is missing: hoop.{given} does not define a hoop without it.","refusal.hoop_mass":"hoop.mass = {mass} must be\
 {words}.","refusal.kinetic_above_static":"plane.mu_kinetic = {mu_kinetic} must not exceed plane.mu_static = {mu_static}.","refusal.known_are":"known are {known\
}.","refusal.less_than":"must be less than {limit}","refusal.less_than_equal":"must be at most {limit}","refusal.list":"must be a list","refusal.literal_error":"\
must be {expected}","refusal.load_inertia":"hoop.load_fraction = {load_fraction} gives hoop.inertia_ratio = {inertia_ratio}, which must be {words}.","refusal.ma\
ssless_compliant":"contact.model = 'compliant' must be 'rigid' for the massless hoop (hoop.inertia_ratio = 0).","refusal.massless_eccentricity":"hoop.inertia_ra\
tio = 0 needs hoop.eccentricity = 1 (all mass in a point on the rim), not {eccentricity}.","refusal.massless_resistance":"plane.rolling_resistance = {given} mus\
t be 0 for the massless hoop (hoop.inertia_ratio = 0).","refusal.massless_slope":"plane.slope = {slope} must be 0 for the massless hoop (hoop.inertia_ratio = 0)\
.","refusal.missing":"{path} is missing.","refusal.no_omega":"start.omega = None must be a number.","refusal.no_parameter":"{path} is not a parameter of a scena\
rio; known are {known}.","refusal.no_parts":"hoop.parts must not be empty.","refusal.no_section_parts":"{path} is not a parameter of a scenario: {section} has n\
o parts.","refusal.not_there":"{path} is not there to be replaced: the scenario has no {step}.","refusal.number":"must be a number","refusal.other_problems":{one:"\
{first} (and {count} more problem).",other:"{first} (and {count} more problems)."},"refusal.parts_inertia":"hoop.parts give hoop.inertia_ratio = {inertia_ratio}\
, which must be {words}.","refusal.parts_out_of_order":"hoop.parts.{name} is out of order: parts are numbered from 0 without a gap.","refusal.range":"must be {w\
ords}","refusal.relative_contact":"contact.{name} = {value} is {relative} {unit} of this hoop and must be {words} of it.","refusal.resistance":"plane.rolling_re\
sistance = {given} must be below {most} for this hoop, whose inertia about the contact it would cancel at some angle.","refusal.ring_radii":"ring.inner_radius =\
 {inner} must not exceed ring.outer_radius = {outer}.","refusal.slope":"plane.slope = {slope} must be {words}.","refusal.table":"must be a table of keys","refus\
al.together":"{section}.{other} cannot be given together with {section}.{way}.","refusal.too_soft":"contact.stiffness = {stiffness} lets the rim sink some {dept\
h} radii into the plane, at the speed of the start, and must be high enough for at most {most}.","refusal.two_ways":"{one} = {one_value} and {other} = {other_va\
lue} cannot be given together.","refusal.unknown_key":"{path} is not a known key; {hint}","refusal.unreadable_query":"The query cannot be read: {reason}.","refu\
sal.value_above":"{path} cannot be given together with a value for {above}.","refusal.vertical":"plane.slope = {slope} must lie between -pi/2 and pi/2 (radians)\
.","refusal.whole":"must be a whole number","refusal.whole_scenario":"the scenario","refusal.word":"must be a word","save.a_picture_in_space":"SVG works in 2D o\
nly: save a PNG, or leave 3D.","save.copy_a_link_to":"Copy a link to this motion","save.fetching_name":"Fetching {name} …","save.name_is_there":"{name} is rea\
dy.","save.needs_python":"{name} needs Python: run hophoop lab.","save.record_one_run_as":"Record one run as a film (WebM)","save.recording_one_run":"Recording \
one run …","save.save_a_film_mp4":"Save a film (MP4)","save.save_a_picture_png":"Save a picture (PNG)","save.save_a_picture_svg":"Save a picture (SVG)","save.\
save_the_events_json":"Save the events (JSON)","save.save_the_motion_netcdf":"Save the motion (netCDF)","save.save_the_scenario_toml":"Save the scenario (TOML)",
"save.save_the_states_csv":"Save the states (CSV)","save.share":"Share","save.share_and_save":"Share and save","save.show_the_python_code":"Show the Python code",
"save.the_film_is_being":"Making the film; this takes a while …","save.the_film_is_there":"The film is ready.","save.the_link_is_copied":"Link copied.","save.\
the_link_to_this":"Link to this motion","save.the_picture_is_too":"The picture is too large for this browser.","save.the_same_motion_in":"The same motion in Pyt\
hon","save.the_scenario_as_a":"Scenario file","save.this_browser_cannot_record":"This browser cannot record; save the MP4 instead.","sensitivity.a_little_more":"\
Change","sensitivity.amount_earlier":"{amount} earlier","sensitivity.amount_faster":"{amount} faster","sensitivity.amount_further_to_the":"{amount} further to t\
he right","sensitivity.amount_further_to_the_left":"{amount} further to the left","sensitivity.amount_higher":"{amount} higher","sensitivity.amount_later":"{amo\
unt} later","sensitivity.amount_less_in_the":"{amount} less in the air","sensitivity.amount_longer":"{amount} longer","sensitivity.amount_lower":"{amount} lower",
"sensitivity.amount_more_in_the":"{amount} more in the air","sensitivity.amount_shorter":"{amount} shorter","sensitivity.amount_slower":"{amount} slower","sensi\
tivity.arrows":"Arrows","sensitivity.at_the_end_after":"At the end, after {time} s: {list}.","sensitivity.begins_amount_earlier":"starts {amount} earlier","sens\
itivity.begins_amount_later":"starts {amount} later","sensitivity.do_it":"Apply","sensitivity.event":"event","sensitivity.every_event_by_this":"All events, for \
this step","sensitivity.from_what_at_time":"No derivative from {time} s ({what}) on: {reason}.","sensitivity.height":"height","sensitivity.hop_number_list":"Hop\
 {number}: {list}.","sensitivity.it_is_infinite_there":"The value is infinite and cannot increase.","sensitivity.load_angle":"load angle","sensitivity.nothing_n\
o_event_moves":"No event changes.","sensitivity.place":"position","sensitivity.the_arrows_are_drawn":"The arrows are drawn in the 2D picture: leave 3D to see th\
em.","sensitivity.the_arrows_in_the":"Each arrow points from the contact to its changed position, {factor} times enlarged.","sensitivity.the_first_event_what":"\
The first event, {what}: {list}.","sensitivity.the_hop_list":"The hop: {list}.","sensitivity.to_one_side_only":"One-sided derivative: {reason}.","sensitivity.wh\
at_a_little_more":"Sensitivity: effect of a small change (a)","sensitivity.what_a_little_more_would":"Sensitivity: effect of a small change","sensitivity.what_c\
hanges_at_every":"Change of every event","server.busy":{one:"The lab is busy; try again in {count} second.",other:"The lab is busy; try again in {count} seconds\
."},"server.failed":"The computation failed.","server.too_much":"This takes too long; ask for a shorter motion.","shell.everything":"Everything","shell.ignored_\
in_the_link":"Ignored in the link: {names}.","shell.show_everything":"Show everything","shell.simple_view":"Simple view","shell.the_rest_of_the":"The rest of th\
e link is shown. Correct the address, or go on from here.","shell.this_motion_has_other":"This motion has other settings too.","status.at_rest":"It has come to \
rest.","status.event_limit":"The limit of events (contact.max_events), or of work for one motion, was reached before the end.","status.jammed":"The normal force\
 grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.","status.undetermined":"The model does not determine the motion beyond.","story.a\
pex":"The centre is highest at {where}: the gap is {gap}.","story.bounce_limit":"Infinitely many bounces end here, at {where}.","story.impact":"It lands at {whe\
re} with {speed} m/s downwards and {verb}.","story.impact_bounce":"It lands at {where} with {speed} m/s downwards and bounces.","story.impact_without_collision":"\
An impact without collision at {where} stops the slip; then it {verb}.","story.jam":"Dynamic jam at {where}: the contact force grows without bound.","story.kane\
_gain":"Newton's law of impact has created {gain} J (Kane's example).","story.left_out":"… and {count} more.","story.more_bounces":{one:"It bounces {count} mo\
re time.",other:"It bounces {count} more times."},"story.painleve_inconsistent":"Painlevé's paradox at {where}: no contact force agrees with this slip.","story\
.painleve_indeterminate":"Painlevé's paradox at {where}: several contact forces agree with it.","story.rest":"It rests at {where}.","story.rest_unstable":"It r\
ests at {where}, which is not stable.","story.skim":"No contact force is left at {where}: the load falls freely and the rim skims the plane.","story.slip_revers\
al":"The slip reverses at {where}; it {verb}.","story.slip_start":"It skids at {where}; friction reaches its limit: the rim slides ahead.","story.slip_start_spi\
n":"It spins at {where}; friction reaches its limit: the rim turns too fast for its path.","story.start":"It starts and {verb} with the load at {where} and the \
centre at {speed} m/s.","story.start_flight":"It starts in the air with the load at {where} and the centre at {speed} m/s.","story.start_skim":"It starts skimmi\
ng with the load at {where} and the centre at {speed} m/s.","story.stick":"It rolls again at {where}; the slip has stopped.","story.takeoff":"It hops at {where}\
.","story.takeoff_and_landing":"It hops at {where}. It rises {top} and stays up for {time} s.","story.turn":"It turns back at {where}.","story.turn_in_slip":"It\
 turns back at {where} and now {verb}.","summary.bounce_limit":"stops bouncing at {where}","summary.bounces":"bounces at {where}","summary.impact":"lands at {wh\
ere}","summary.jam":"jams at {where}","summary.kane_gain":"gains energy (Kane) at {where}","summary.more_changes":"… ({count} more)","summary.more_times":{one:"\
{what} and {count} more time",other:"{what} and {count} more times"},"summary.painleve_inconsistent":"meets Painlevé's paradox at {where}","summary.painleve_in\
determinate":"meets Painlevé's indeterminacy at {where}","summary.rest":"rests at {where}","summary.skid":"skids at {where}","summary.skim":"skims at {where}",
"summary.spin":"spins at {where}","summary.stick":"rolls at {where}","summary.takeoff":"hops at {where}","summary.whole":"{Phrases}.","summary.with_ending":"{Ph\
rases}. {ending}","summary.without_collision":"stops its slip at once at {where}","table.close":"Close","table.columns":"Columns","table.every":"Every","table.m\
ode":"mode","table.save_as_csv":"Save as CSV","table.table":"Table","table.table_of_the_motion":"Table of the motion","table.table_of_the_motion_rows":"Rows of \
the table","table.the_first_count_rows":"The first {count} rows.","teach.a_heavier_hoop_behaves":"A heavier hoop behaves differently.","teach.a_lesson_of_45":"A\
 lesson of 45 minutes","teach.a_thin_ring_of":"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a l\
evel floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².","teach.at_2_2_m":"At 2.2 m/s the hoop leaves the floor while \
its rim slips. Why does slipping help it to hop?","teach.at_which_angle":"at which angle?","teach.before_the_film_where":"Before the film: where is the load whe\
n the hoop leaves the floor? Mark the position and give one reason.","teach.does_it_hop":"does it hop?","teach.each_group_takes_one":"Each group takes one speed\
 of the worksheet; results on the board.","teach.energy_on_the_way":"Energy on the way down, in pairs: who has the energy when the load is at rest?","teach.ever\
ybody_predicts_where_the":"Everybody predicts where the load is at take-off. Count the votes by quarters of the revolution.","teach.exercises":"Exercises","teac\
h.find_the_force_of":"Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","teach.find_the_smallest_speed":"Find the min\
imum speed at which the hoop hops, to 1 cm/s.","teach.friction_always_brakes":"Friction always brakes.","teach.how_fast_is_a":"How fast is a stone that falls fr\
om the height of the load? Why can the hoop be faster?","teach.idea":"Idea","teach.in_the_lab_what":"In the lab: what does the hoop do in its first 1.5 s, and a\
t which angle does it hop? Fill in the table.","teach.it_acts_against_slip":"It acts against slip. While the load rises, it points forwards.","teach.it_hops_at_\
the":"It hops at the bottom, where it is fastest.","teach.lift_at_the_top":"Take-off at the top: at which speed is the force of the floor zero?","teach.minute":"\
Minute","teach.more_friction_more_hop":"More friction, more hop.","teach.motion":"Motion","teach.nothing_can_be_faster":"Nothing can be faster than a falling st\
one.","teach.one_sentence_each_the":"One sentence each: “The hoop hops because …”","teach.only_if_it_is":"Only if it is very fast. Slower hoops hop before\
 the top, after slipping.","teach.only_the_shares_of":"Only the fractions of mass matter.","teach.phases":"phases","teach.print":"Print","teach.show":"Show","te\
ach.show_the_hoop_at":"Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","teach.solutions":"Solutions","teach.start_the\
_visit":"Start the visit","teach.teaching_with_the_hoop":"Teaching with the hoop","teach.the_film_again_in":"The film again, in slow motion and with forces; sto\
p at take-off. Compare with the votes.","teach.the_hoop_gets_only":"The hoop gets only a tiny push and rolls. How much potential energy has been released when t\
he load is at the bottom?","teach.the_load_pulls_the":"The load pulls the hoop up at the top, so it hops there.","teach.the_ring_can_it":"The ring can: it gets \
the energy of a load that has come to rest.","teach.the_visit_asks_before":"The visit asks before it shows; the presentation fills the screen; the table gives e\
very student numbers.","teach.there_is_a_best":"An intermediate friction is best.","teach.there_the_floor_pushes":"There the floor pushes hardest: the load has \
to be turned upwards.","teach.what_is_right":"What is right","teach.what_students_often_think":"What students often think","teach.while_a_wheel_rolls":"While a \
wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?","teach.why_what_has_to":"Why? What has to\
 brake the rotation while the load rises, how strong can it be, and what if it is too weak?","teach.worksheet":"Worksheet","teach.worksheet_the_hoop_that":"Work\
sheet: the hoop that hops","theory.first_hop":"Hops","theory.first_slip":"Slips","theory.friction_enough":"μ = {mu} would keep it rolling (enough here)","theor\
y.friction_short":"μ = {mu} would keep it rolling (more than there is)","theory.immediate_hop":"Hops at once","theory.jam":"Dynamic jam","theory.jam_at":"can e\
nd a slip at {places}","theory.loss":"End of rolling","theory.loss_by_friction":"at {where} friction reaches its limit","theory.loss_of_contact":"at {where} the\
 contact force is gone","theory.needed_friction":"Friction for pure rolling","theory.never":"never","theory.no_friction":"no friction keeps it rolling","theory.\
no_speed":"never, at any speed","theory.no_threshold":"no single threshold uphill (β < 0): it depends on where the hoop turns back; see the map","theory.painle\
ve":"Painlevé’s paradox","theory.paradox_here":"from μ = {mu} on, at {where}: possible here","theory.paradox_not_here":"from μ = {mu} on, at {where}: not he\
re","theory.rest":"Rests stably","theory.rest_at":"with the load at {where}","theory.uphill":"Slips, hops","theory.would_hop.above":"would hop in its first turn\
 above {speed} m/s","theory.would_hop.always":"would hop in its first turn: any push is enough","theory.would_hop_at_once.above":"would hop at once above {speed\
} m/s","theory.would_hop_at_once.always":"would hop at once: at any speed","theory.would_slip.above":"would slip above {speed} m/s","theory.would_slip.always":"\
would slip: any push is enough","verb.flight":"flies","verb.roll":"rolls","verb.skid":"skids","verb.skim":"skims the plane","verb.spin":"spins","visit.a_harder_\
push_2":"A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.","visit.a_hoop_is_thrown":"A hoop is launched \
so that it slides fast over a rough plane. What do the laws of rigid bodies with dry friction predict?","visit.a_hoop_without_mass":"A massless hoop has a weigh\
t on its rim. With the weight at the top it gets a tiny push and rolls. In 1953 J. E. Littlewood asked what happens when the weight is level with the centre.","\
visit.a_little_faster_3":"A little faster, 3.1 m/s. This time the hoop leaves the plane before the end of its first revolution.","visit.a_ring_with_mass":"A rin\
g with mass","visit.a_rolling_hoop_would":"The plane would brake a rolling hoop while the load rises. Friction is too weak for that: the rim spins, the hoop kee\
ps turning fast, and the load pulls it off the plane before reaching the top.","visit.an_impact_stops_the":"An impact stops the slide at once.","visit.an_impact\
_takes_no":"An impact takes no time, but its friction grows with its force: here it is enough to stop all slip. With less friction, or more restitution, the lan\
ding would differ. Try it afterwards.","visit.angle_of_the_load":"Angle of the load where it starts to slip","visit.angle_of_the_load_where":"Angle of the load \
where it takes off","visit.at_angle_there_is":"At {angle} the contact force vanishes.","visit.back":"Back","visit.both_agree_with_the":"Both agree with the laws\
.","visit.done":"Done","visit.draw_how_fast_the":"Draw the speed of the hoop’s centre during the first revolution.","visit.draw_the_curve_pull":"Draw the curv\
e: pull the points up and down","visit.eight_short_questions_guess":"Eight short questions: guess, then play.","visit.first_say_what_you":"First make a guess, t\
hen play.","visit.hoop_a_and_hoop":"Hoops A and B start in the same state, and both motions obey all laws.","visit.it_begins_to_slip":"It starts to slip at {ang\
le}. There the plane carries only {share} of the weight.","visit.it_bounces":"It bounces.","visit.it_flies_off":"It flies off.","visit.it_hops_the_hoop":"It hop\
s: the hoop leaves the plane.","visit.it_rolls_at_once":"It rolls at once.","visit.it_rolls_on":"It keeps rolling.","visit.it_skids_the_rim":"It skids: the rim \
slides ahead.","visit.it_spins_the_rim":"It spins: the rim turns too fast.","visit.it_takes_off_at":"It takes off at {angle}, while its rim slips at {slip} m/s.",
"visit.it_was_in_the":"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.","visit.leave_the_visit":"Leave the visit","vi\
sit.littlewood_said_that_the":"Littlewood said that the hoop hops. But no upward force is left: the weight falls freely, and the massless rim follows it along t\
he plane. To hop, a hoop needs some mass in its rim.","visit.littlewoods_question":"Littlewood’s question","visit.more_friction_more_hop":"More friction, more\
 hop?","visit.new_here":"New here?","visit.next":"Next","visit.not_now":"Not now","visit.not_so":"Not so.","visit.now_a_quarter_of":"Now a quarter of the mass i\
s in the ring. Again the load is at the top, and the hoop gets a tiny push.","visit.on_ice_nothing_drives":"On ice nothing drives the rotation; with infinite fr\
iction nothing slips. The hop needs both: enough friction to turn the hoop fast while the load falls, and little enough not to brake it while the load rises.","\
visit.painleve_found_this_in":"Painlevé found this in 1895. For a rigid body the laws have two solutions here, in other states none. Real bodies deform a little\
, and that decides: choose the compliant contact under ‘Contact’.","visit.pause":"Pause","visit.play":"Play","visit.points_of_100_points":"{points} of 100 p\
oints.","visit.skip_to_the_answer":"Skip to the answer","visit.speed_of_the_centre":"Speed of the centre","visit.step_number_of_all":"Step {number} of {all}","v\
isit.take_the_hoop_turn":"Take the hoop: turn the load, lift the hoop and drop it, flick it, tilt the plane. Or accept a challenge: your score is computed from \
the motion.","visit.the_hoop_before_it":"The hoop, before it is let go.","visit.the_hoop_is_in":"The hoop is in the air. Its centre of gravity follows a parabol\
a, and it rotates uniformly.","visit.the_hop":"The hop","visit.the_landing":"The landing","visit.the_load_on_its":"While the load falls, it presses little on th\
e plane: N is small. But the ring must speed up, which takes friction. Watch the diagram ‘Friction utilization’: it reaches 1.","visit.the_lowest_point_of":"\
The lowest point of a rolling hoop is at rest. There the load has no kinetic energy; the light ring has all the energy that the heavy load has lost. It is faste\
r than a stone that falls from the same height.","visit.the_weight_falls_freely":"The weight falls freely, and the hoop skims the plane below it.","visit.they_r\
ise_by_low":"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)","visit.three_hoops_get_the":"Three hoops start at the same 3.1 m/s,\
 on planes with friction 0.05, 0.2 and 1.0.","visit.what_do_they_say":"What happens next?","visit.what_do_you_think":"What do you think?","visit.what_does_it_do":"\
What does it do right after landing?","visit.what_rigid_bodies_cannot":"What rigid bodies cannot decide","visit.what_with_the_load":"{what} with the load at {an\
gle}","visit.where_is_the_load":"Where is the load when friction first reaches its limit? Turn the mark.","visit.where_is_the_load_when":"Where is the load when\
 the hoop takes off? Turn the mark.","visit.which_of_them_hops":"Which of them hops highest?","visit.why_it_slips":"Why it slips","visit.with_the_load_at":"With\
 the load at the bottom the centre moves at {speed} m/s.","visit.you_have_sum_of":"You have {sum} of {most} points.","visit.your_guess":"Your guess","visit.your\
_turn":"Your turn"};var ne=["en","de","es","fr","zh"];var ie=n=>{let t=new Intl.DisplayNames([n],{type:"language"}).of(n)??n;return t[0].toLocaleUpperCase(n)+t.slice(1)},$=Object.fromEntries(ne.map(n=>[n,ie(n)])),se=n=>Object.
assign(Object.create(null),n),xe=se(Y);var Te=new Intl.PluralRules("en");var y=(n,t,e)=>Math.min(Math.max(n,t),e);function K(n,t,e,a=()=>{}){let s=new AbortController,{signal:i}=s,o=(h,l)=>n.addEventListener(h,c=>c.pointerId===t.pointerId&&l(c),{signal:i}),r=h=>l=>{s.abort(),
a(l,h)};n.setPointerCapture(t.pointerId),o("pointermove",e),o("pointerup",r(!0)),o("pointercancel",r(!1))}function X(n,t){let e=new Map,a=null,s=()=>{let[o,r]=[
...e.values()];return{span:Math.max(Math.hypot(o.clientX-r.clientX,o.clientY-r.clientY),1),clientX:.5*(o.clientX+r.clientX),clientY:.5*(o.clientY+r.clientY)}};n.
addEventListener("pointerdown",o=>{o.pointerType!=="mouse"&&(e.set(o.pointerId,o),a=e.size===2?s():null)}),n.addEventListener("pointermove",o=>{if(!e.has(o.pointerId)||
(e.set(o.pointerId,o),e.size!==2||!a))return;let r=s();t(r.span/a.span,r),a=r});for(let o of["pointerup","pointercancel"])n.addEventListener(o,r=>{e.delete(r.pointerId),
a=null});let i=o=>o.touches.length>1&&o.cancelable&&o.preventDefault();return n.addEventListener("touchmove",i,{passive:!1}),()=>e.size>1}var J=n=>n!==null&&n.getRootNode().activeElement===n;var le=.0018,Z=200,[ce,me]=[1/.6,1/1.7];function Q(n,{zoom:t,home:e,chosen:a=()=>n,keys:s=!1}){return n.addEventListener("wheel",i=>{(i.ctrlKey||i.metaKey||J(a()))&&
(i.preventDefault(),t(Math.exp(-Math.min(Math.max(i.deltaY,-Z),Z)*le),i))},{passive:!1}),n.addEventListener("dblclick",e),s&&n.addEventListener("keydown",i=>{if(i.
key==="+"||i.key==="=")t(ce);else if(i.key==="-")t(me);else if(i.key==="0")e();else if(i.key==="Escape")n.blur();else return;i.preventDefault(),i.stopPropagation()}),
X(n,t)}var pe=[.35,.85,.4],de=.18,T={azimuth:.5,height:.22,distance:5.2},ee=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],te=class{constructor(t,e){this.canvas=t;this.onview=e;this.space=new M(this.canvas,N,pe,de,{keep:!0});this.floor=k(this.space.gl,ee[0],ee[1]);this.corners=
v(this.space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2});this.turned={...T};this.lines=new WeakMap;this.share=1;this.pace=16;this.before=0;this.focus=0;this.reach=1;t.
addEventListener("pointerdown",a=>this.drag(a)),this.pinched=Q(t,{zoom:a=>this.zoomBy(a),home:()=>this.zoomBy(0),chosen:()=>t.parentElement})}zoomBy(t){t?this.turned.
distance=y(this.turned.distance/t,1.6,60):this.turned={...T},this.onview()}from(){let{azimuth:t,height:e,distance:a}=this.turned;return t===T.azimuth&&e===T.height&&
a===T.distance?void 0:[t,e,a]}look([t,e,a]){this.turned={azimuth:y(t,-1.5,1.5),height:y(e,.02,1.45),distance:y(a,1.6,60)}}drag(t){let e={...this.turned,x:t.clientX,
y:t.clientY};K(this.canvas,t,a=>{this.pinched()||(this.turned.azimuth=y(e.azimuth-(a.clientX-e.x)*.008,-1.5,1.5),this.turned.height=y(e.height+(a.clientY-e.y)*.006,
.02,1.45),this.onview())})}quality(){let t=performance.now(),e=t-(this.before||t);return this.before=t,e>0&&e<200&&(this.pace=.9*this.pace+.1*e),this.pace>26&&this.
share>.5&&(this.share=Math.max(this.share-.1,.5),this.pace=16),this.share}draw(t,e,a,s,i,o,r){let{canvas:h,space:l}=this,c=r??Math.min(globalThis.devicePixelRatio||
1,2)*(o?this.quality():1),_=h.getBoundingClientRect();h.width=Math.max(Math.round(_.width*c),1),h.height=Math.max(Math.round(_.height*c),1);let u=t.map(m=>m.at(
e)),f=t[0].radius;l.fastest=Math.max(...t.map(m=>m.extent.speed)),this.focus=Number.isFinite(u[0].x)?u[0].x:0,l.begin({background:g(s.paper),...this.camera(t[0],
u[0],f,a)}),l.ground(()=>this.drawFloor(f,s));let w=m=>{for(let[p,d]of t.entries())m(d,u[p],-2.1*f*p)};l.shadows(()=>w((m,p,d)=>this.drawHoop(m,p,d,a,s,i,!0))),
w((m,p,d)=>{this.drawHoop(m,p,d,a,s,i,!1),a.traces&&this.drawTraces(m,p,d,s,i,c),a.forces&&this.drawForces(m,p,d,i)})}camera(t,e,a,s){let{azimuth:i,height:o,distance:r}=this.
turned,{left:h,right:l}=t.extent,c=s.whole?Math.max(r*a,.85*(l-h)+3*a):r*a,[_,u]=[s.whole?.5*(h+l)-this.focus:0,a+.45*(e.height||0)],f=Math.cos(t.slope),w=Math.
sin(t.slope),m=[_*f+u*w,-_*w+u*f,0],p=[m[0]+c*Math.sin(i)*Math.cos(o),m[1]+c*Math.sin(o),c*Math.cos(i)*Math.cos(o)];return this.reach=12*a+3*c,{eye:p,target:m,slope:t.
slope,angle:.75,near:.05*a,far:40*a+6*c}}drawFloor(t,e){let{space:a}=this,s=g(e.ground),i=s.map(h=>h*(e.dark?.82:.94)),o=.5*t,r=this.focus%(2*o);a.use(this.floor,
{reach:this.reach,light:s,dark:i,far:g(e.paper),tile:o,shift:r}),x(a.gl,this.floor,this.corners),a.gl.drawArrays(a.gl.TRIANGLE_STRIP,0,4)}drawHoop(t,e,a,s,i,o,r){
let{space:h}=this,l=t.radius,c=.045*l,_=[e.x-this.focus,l+e.height,a];h.ring({center:_,radius:l,tube:c,broad:3.2*c,angle:e.angle,velocity:[e.vx,e.vy],omega:e.omega,
plain:s.speed?null:g(o.modes[e.mode])},r);let u=[Math.sin(e.angle),Math.cos(e.angle),0],f=m=>_.map((p,d)=>p+m*u[d]);h.ball(f(l-c),.125*l,i.dark?[.9,.91,.94]:[.12,
.13,.15],r),h.rod(_,u,l-c,.012*l,[.55,.57,.6],r);let w=e.mode==="H";h.ball(f(t.eccentricity*l),.07*l,g(w?o.airborne:o.gravity_center),r)}drawForces(t,e,a,s){if(e.
mode==="H"||!(e.normal_force>0))return;let i=t.radius,o=t.mass*(t.gravity||9.81),r=[e.x-this.focus,e.height+.03*i,a+.2*i],h=c=>y(.55*i*Math.abs(c)/o,0,3.2*i),l=Math.
sign(e.friction_force);this.space.arrow(r,[0,1,0],h(e.normal_force),i,g(s.normal_force)),this.space.arrow(r,[l,0,0],h(e.friction_force),i,g(s.friction_force))}linesOf(t,e,a){
let s=this.lines.get(t);if(s?.dark===e.dark)return s;let i=t.radius,{x:o,height:r,angle:h,mode:l}=t.columns,c=(m,p)=>this.space.trace(t.length,d=>[o[d]+m*Math.sin(
h[d]),i+r[d]+m*Math.cos(h[d])],p),[_,u,f]=[g(a.gravity_center),g(a.airborne),g(e.ink)],w={dark:e.dark,load:c(i,()=>f),center:c(t.eccentricity*i,m=>l[m]===3?u:_)};
return this.lines.set(t,w),w}drawTraces(t,e,a,s,i,o){let{load:r,center:h}=this.linesOf(t,s,i),l=Math.min(t.index(e.t)+2,t.length),c={shift:this.focus,depth:a};this.
space.drawTrace(r,l,{width:o,...c}),this.space.drawTrace(h,l,{width:1.6*o,...c})}};export{te as Stage3D};
