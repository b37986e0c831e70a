/* Built from web/lab/shell/main.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
var zl=Object.create;var vn=Object.defineProperty;var Ul=Object.getOwnPropertyDescriptor;var Gl=Object.getOwnPropertyNames;var Wl=Object.getPrototypeOf,Kl=Object.prototype.hasOwnProperty;var Z=(n,t,e)=>()=>{if(e)throw e[0];try{return n&&(t=n(n=0)),t}catch(s){throw e=[s],s}};var Vl=(n,t)=>()=>{try{return t||n((t={exports:{}}).exports,t),t.exports}catch(e){throw t=0,e}},fo=(n,t)=>{for(var e in t)vn(n,e,{get:t[e],enumerable:!0})},Yl=(n,t,e,s)=>{
if(t&&typeof t=="object"||typeof t=="function")for(let i of Gl(t))!Kl.call(n,i)&&i!==e&&vn(n,i,{get:()=>t[i],enumerable:!(s=Ul(t,i))||s.enumerable});return n};var Xl=(n,t,e)=>(e=n!=null?zl(Wl(n)):{},Yl(t||!n||!n.__esModule?vn(e,"default",{value:n,enumerable:!0}):e,n));var Mo,ko=Z(()=>{Mo={"axis.hoop.eccentricity":"Eccentricity ε","axis.hoop.inertia_ratio":"Inertia ratio κ","axis.hoop.load_fraction":"Load fraction γ","axis.\
hoop.radius":"Radius R","axis.plane.gravity":"Gravity g","axis.plane.mu":"Friction μ","axis.plane.restitution":"Restitution e","axis.plane.rolling_resistance":"\
Rolling resistance f","axis.plane.slope":"Slope β","axis.start.angle":"Angle of the load θ₀","axis.start.height":"Height of the gap y₀","axis.start.omega":"\
Angular velocity θ̇₀","axis.start.speed":"Speed v₀","axis.start.vx":"Speed along ẋ₀","backend.the_notebooks_kernel_does":"The notebook’s kernel does n\
ot respond; run the cell again.","backend.the_server_answered_status":"The server returned {status}.","backend.the_server_does_not":"The server does not respond\
. The motion still plays; for changes, start `hophoop lab` again.","challenge.at_most_10_m":"At most 10 m/s.","challenge.at_most_3_1":"At most 3.1 m/s.","challe\
nge.at_most_6_s":"At most 6 s.","challenge.at_most_90_of":"At most 90 % of the mass may be in the load.","challenge.begin_again":"Start again","challenge.fricti\
on_must_be_at":"Friction must not exceed 1.5.","challenge.hop_highest":"Hop highest","challenge.hop_without_skidding":"Hop without skidding","challenge.it_does_\
not_hop":"It does not hop.","challenge.it_lands_off_away":"It lands {off} from the top.","challenge.it_must_be_on":"Gravity must be that of Earth.","challenge.i\
t_must_start_rolling":"The hoop must start rolling.","challenge.it_rises_by_height":"It rises by {height}.","challenge.it_skids_before_it":"It skids before it h\
ops.","challenge.land_upright":"Land upright","challenge.leave_the_challenges":"Leave the challenges","challenge.let_the_hoop_land":"Let the hoop land with its \
load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.","challenge.on_level_ground_rolling":"On level ground, rolling, with at\
 most 3.1 m/s: you choose the load, where it starts, and friction. How high can the hoop rise within 6 s?","challenge.on_level_ground_the":"On level ground the \
hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high doe\
s it hop?","challenge.restitution_must_be_0":"Restitution must be 0.","challenge.rigid_contact_only":"Rigid contact only.","challenge.score":"Score","challenge.\
show_a_best_one":"Show a best solution","challenge.stars_points_points_shown":{one:"{stars} {count} point, shown and not counted. {what}",other:"{stars} {count}\
 points, shown and not counted. {what}"},"challenge.stars_points_points_what":{one:"{stars} {count} point. {what}",other:"{stars} {count} points. {what}"},"chal\
lenge.the_first_hop_is":"The first hop is too low.","challenge.the_hoop_must_be":"The hoop must be given by its load fraction.","challenge.the_load_must_start":"\
The load must start at the bottom.","challenge.the_plane_must_be":"The plane must be level.","challenge.the_radius_must_stay":"The radius must stay 1 m, without\
 parts.","challenge.which_challenge":"Which challenge","challenge.your_best_points_points":{one:"Your best: {count} point.",other:"Your best: {count} points."},
"choice.contact.friction.bristle":"bristle (can hold)","choice.contact.friction.linear":"linear","choice.contact.friction.tanh":"smooth (tanh)","choice.contact.\
law.hunt-crossley":"Hunt–Crossley","choice.contact.law.kelvin-voigt":"Kelvin–Voigt","choice.contact.model.compliant":"compliant","choice.contact.model.rigid":"\
rigid","choice.plane.impact_law.newton":"Newton (velocity)","choice.plane.impact_law.poisson":"Poisson (impulse)","choice.plane.impact_law.stronge":"Stronge (en\
ergy)","choice.plane.painleve.flight":"flight","choice.plane.painleve.impact":"impact","class.duration":"duration","class.event_limit":"event limit","class.jam":"\
jam","class.no":"no","class.rest":"rest","class.reversal":"reversal","class.revolutions":"revolutions","class.takeoff":"takeoff","class.undetermined":"undetermi\
ned","class.yes":"yes","column.angle":"angle","column.angle_within_a_turn":"angle within a revolution","column.angular_velocity":"angular velocity","column.fric\
tion_force":"friction force","column.gap_under_the_rim":"gap under the rim","column.height_of_the_centre":"height of the centre of gravity","column.kinetic_ener\
gy":"kinetic energy","column.normal_force":"normal force","column.place_of_the_centre":"displacement of the centre","column.potential_energy":"potential energy",
"column.slip_velocity":"slip velocity","column.speed_away_from_the":"speed away from the plane","column.speed_of_rotation":"circumferential speed","column.speed\
_of_the_centre":"speed of the centre","column.theta_mod_360":"θ mod 360°","column.time":"time","column.total_energy":"total energy","column.use_of_friction":"\
friction utilization","controls.auto_value":"auto {value}","controls.contact":"Contact","controls.elsewhere":"elsewhere","controls.epsilon_and_kappa":"ε and κ",
"controls.given_by":"Defined by","controls.hoop":"Hoop","controls.in_any_state":"in any state","controls.label_value_is_too":"{label} = {value} is too large.","\
controls.load_fraction_gamma":"load fraction γ","controls.name_exact_value":"{name}, exact value","controls.name_exact_value_in":"{name}, exact value in {unit}",
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
_turn":"Your turn"}});function Je(n){So=n}async function oe(n){let t=Eo.get(n)??To(await So(n));Eo.set(n,t),[ne,ye]=[n,t],we=new Intl.PluralRules(n),ve=1.5.toLocaleString(n).includes(
",")}function P(n,t){let e=ye[n]??xe[n];if(e===void 0)return gt(n);let s=typeof e=="string"?e:e[we.select(Number(t?.count))]??e.other;return t?s.replace(hh,(i,o)=>mh(
o,t)):s}function mh(n,t){if(n in t)return U(t[n]);let e=U(t[n[0].toLowerCase()+n.slice(1)]);return e.slice(0,1).toLocaleUpperCase(ne)+e.slice(1)}function U(n){return typeof n==
"string"?P(n):typeof n=="number"?gt(String(n)):typeof n=="function"?n():Array.isArray(n)?n.map(U).join(""):P(n.key,n.values)}function uh(n){let t={language:ne,table:ye,
plurals:we,commas:ve};[ne,ye,we,ve]=["en",xe,new Intl.PluralRules("en"),!1];try{return U(n)}finally{({language:ne,table:ye,plurals:we,commas:ve}=t)}}var lh,hh,ch,
ie,To,xe,Eo,So,ne,ye,we,ve,It,gt,at,rt,et,Ht=Z(()=>{"use strict";ko();lh=["en","de","es","fr","zh"],hh=/\{(\w+)\}/g,ch=n=>{let t=new Intl.DisplayNames([n],{type:"\
language"}).of(n)??n;return t[0].toLocaleUpperCase(n)+t.slice(1)},ie=Object.fromEntries(lh.map(n=>[n,ch(n)])),To=n=>Object.assign(Object.create(null),n),xe=To(Mo),
Eo=new Map([["en",xe]]),So=async()=>xe,ne="en",ye=xe,we=new Intl.PluralRules("en"),ve=!1,It=()=>ne;gt=n=>ve?n.replace(/(\d)\.(\d)/g,"$1,$2"):n;at=n=>n.flatMap((t,e)=>e?
["list.comma",t]:[t]);rt=class extends Error{constructor(e){super(uh(e));this.said=e}},et=n=>n.said??n.message});function Rt(n){let t=Number.parseInt(n.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}function Le(n){let[t,e,s]=Rt(n).map(xc);return .2126*t+.7152*e+.0722*s}function Re(n,t){
if(!t||!/^#[0-9a-f]{6}$/i.test(n))return n;if(Le(n)<.002)return"#eceef2";let e=n;for(let s=0;Le(e)<.2&&s<1;s+=.05)e=`#${Rt(n).map(i=>Math.round(i+(255-i)*s).toString(
16).padStart(2,"0")).join("")}`;return e}function kc(){let n=[];for(let t=0;t<256;t++){let e=t/255*(ms.length-1),s=Math.min(Math.floor(e),ms.length-2),i=Rt(ms[s]),
o=Rt(ms[s+1]);n.push(i.map((r,a)=>Math.round(r+(o[a]-r)*(e-s))))}return n}var cr,Ce,xc,ms,ae,us,Mc,Mt,ht=Z(()=>{"use strict";cr=n=>Le(n)>.2?"#111111":"#ffffff",
Ce=(n,t)=>`rgba(${Rt(n).join(",")},${t})`,xc=n=>{let t=n/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4};ms=["#440154","#472d7b","#3b528b","#2c728e","#21918\
c","#28ae80","#5ec962","#addc30","#fde725"];ae=kc(),us=ae.map(n=>`rgb(${n.join(",")})`),Mc=["#123a8c","#8a6d00"],Mt=(n,t)=>Re(Mc[n],t)});function ct(n){try{return localStorage.getItem(n)??ci.get(n)??null}catch{return ci.get(n)??null}}function mt(n,t){ci.set(n,t);try{localStorage.setItem(n,t)}catch{}}
function mr(n){try{return sessionStorage.getItem(n)}catch{return null}}function ur(n,t){try{sessionStorage.setItem(n,t)}catch{}}var ci,Dt=Z(()=>{"use strict";ci=
new Map});function ui(){let n=ct(pr);return n&&n in ie?n:(globalThis.navigator?.languages??[]).map(s=>s.slice(0,2).toLowerCase()).find(s=>s in ie)??"en"}function dr(n){mt(
pr,n)}function Oe(n){let t=document.createTextNode(U(n));return fr.set(t,n),t}function Et(n,t,e){mi.set(n,{...mi.get(n),[t]:e}),n.setAttribute(t,U(e))}function pi(n){
let t=document.createTreeWalker(n,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let e=t.nextNode();e;e=t.nextNode()){let s=fr.get(e);s!==void 0&&(e.nodeValue=
U(s));let i=mi.get(e);for(let[o,r]of Object.entries(i??{}))e.setAttribute(o,U(r))}}var pr,fr,mi,O=Z(()=>{"use strict";Ht();Dt();Ht();pr="hophoop-language";fr=new WeakMap,
mi=new WeakMap});function u(n,t={},...e){let s=document.createElement(n),i=s;for(let[o,r]of Object.entries(t))r==null||r===!1||(o.startsWith("on")?s.addEventListener(o.slice(2),
r):o==="class"?s.className=r:Tc.has(o)?Et(s,o,r):o in s&&o!=="list"&&typeof r!="string"?i[o]=r:s.setAttribute(o,r===!0?"":r));for(let o of e.flat(2))o==null||o===
!1||s.append(o.nodeType?o:Oe(o));return s}function L(n,t){t?n.replaceChildren(Oe(t)):n.replaceChildren()}function Y(n,t=1){let e=n.getBoundingClientRect(),s=Math.
min(globalThis.devicePixelRatio||1,2.5),i=Math.max(Math.round(e.width*s),1),o=Math.max(Math.round(e.height*s),1);(n.width!==i||n.height!==o)&&(n.width=i,n.height=
o);let r=Tt(n),a=s*t;return r.setTransform(a,0,0,a,0,0),{context:r,width:i/a,height:o/a}}function Sc(n){if(/^#[0-9a-f]{6}$/i.test(n))return n;let t=Tt(u("canvas",
{width:1,height:1}));t.fillStyle=n,t.fillRect(0,0,1,1);let[e,s,i]=t.getImageData(0,0,1,1).data;return`#${[e,s,i].map(o=>o.toString(16).padStart(2,"0")).join("")}`}
function di(n){let t=getComputedStyle(n),e=i=>t.getPropertyValue(i).trim(),s=i=>Sc(e(i));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("--pape\
r"),panel:s("--panel"),ground:s("--ground"),font:e("--font"),px:Number.parseFloat(t.fontSize)/Ec||1,dark:Le(s("--paper"))<.2}}function le(n,t){let e=u("a",{href:URL.
createObjectURL(n),download:t});document.body.append(e),e.click(),e.remove(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function ut(n,t){let e=0;return()=>{
clearTimeout(e),e=setTimeout(n,t)}}var Ec,Tc,Ne,Tt,S=Z(()=>{"use strict";ht();O();Ec=14,Tc=new Set(["aria-label","title","placeholder","label"]);Ne=n=>n!==null&&
n.getRootNode().activeElement===n,Tt=n=>n.getContext("2d")});function M(n,t=4){if(n==null)return"–";if(typeof n!="number")return String(n);if(!Number.isFinite(n))return Number.isNaN(n)?"–":n>0?"∞":"−∞";if(n===0)
return"0";let e=Math.abs(n),s;if(e>=1e6||e<1e-4){let[i,o]=n.toExponential(t-1).split("e");s=`${gr(i)}·10${Ac(Number(o))}`}else s=gr(n.toPrecision(t)),s.includes(
"e")&&(s=String(Math.round(n)));return gt(s.replace("-","−"))}function gr(n){return n.includes(".")&&!n.includes("e")?n.replace(/\.?0+$/,""):n}function Ac(n){
let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}function jt(n){let t=Math.
abs(n),[e,s]=t>=.995?[1,"m"]:t>=.00995?[100,"cm"]:[1e3,"mm"];return j(M(n*e,3),s)}function X(n,t){let e=n/Math.max(t,1),s=10**Math.floor(Math.log10(e)),i=e/s;return(i>
5?10:i>2?5:i>1?2:1)*s}function _t(n,t,e){if(!(t>n)||!Number.isFinite(n)||!Number.isFinite(t))return[];let s=X(t-n,e),i=[];for(let o=Math.ceil(n/s-1e-9);o*s<=t+1e-9*
s&&i.length<200;o++)i.push(o*s);return i}function pt(n,t){let e=x(-Math.floor(Math.log10(t)+1e-9),0,15);return Math.max(Math.abs(n),t)>=1e6||e>12?M(n,3):gt((Math.
abs(n)<t*1e-6?0:n).toFixed(e).replace("-","−"))}var x,j,K,N=Z(()=>{"use strict";O();x=(n,t,e)=>Math.min(Math.max(n,t),e);j=(n,t)=>t?t==="°"?`${n}°`:`${n} ${t}`:
n,K=n=>gt(`${(n*180/Math.PI).toFixed(1)}°`.replace("-","−"))});function J(n,t,e,s=()=>{}){let i=new AbortController,{signal:o}=i,r=(l,c)=>n.addEventListener(l,m=>m.pointerId===t.pointerId&&c(m),{signal:o}),a=l=>c=>{i.abort(),
s(c,l)};n.setPointerCapture(t.pointerId),r("pointermove",e),r("pointerup",a(!0)),r("pointercancel",a(!1))}function Rr(n,t){let e=new Map,s=null,i=()=>{let[r,a]=[
...e.values()];return{span:Math.max(Math.hypot(r.clientX-a.clientX,r.clientY-a.clientY),1),clientX:.5*(r.clientX+a.clientX),clientY:.5*(r.clientY+a.clientY)}};n.
addEventListener("pointerdown",r=>{r.pointerType!=="mouse"&&(e.set(r.pointerId,r),s=e.size===2?i():null)}),n.addEventListener("pointermove",r=>{if(!e.has(r.pointerId)||
(e.set(r.pointerId,r),e.size!==2||!s))return;let a=i();t(a.span/s.span,a),s=a});for(let r of["pointerup","pointercancel"])n.addEventListener(r,a=>{e.delete(a.pointerId),
s=null});let o=r=>r.touches.length>1&&r.cancelable&&r.preventDefault();return n.addEventListener("touchmove",o,{passive:!1}),()=>e.size>1}var Ot=Z(()=>{"use str\
ict"});function dt(n,{zoom:t,home:e,chosen:s=()=>n,keys:i=!1}){return n.addEventListener("wheel",o=>{(o.ctrlKey||o.metaKey||Ne(s()))&&(o.preventDefault(),t(Math.exp(-Math.
min(Math.max(o.deltaY,-ya),ya)*$m),o))},{passive:!1}),n.addEventListener("dblclick",e),i&&n.addEventListener("keydown",o=>{if(o.key==="+"||o.key==="=")t(Dm);else if(o.
key==="-")t(jm);else if(o.key==="0")e();else if(o.key==="Escape")n.blur();else return;o.preventDefault(),o.stopPropagation()}),Rr(n,t)}var Bs,$m,ya,Dm,jm,Bt=Z(()=>{
"use strict";S();Ot();Bs=()=>matchMedia("(hover: none)").matches,$m=.0018,ya=200,[Dm,jm]=[1/.6,1/1.7]});function ji(n,t){let e=new Float32Array(16);for(let s=0;s<4;s++)for(let i=0;i<4;i++){let o=0;for(let r=0;r<4;r++)o+=n[4*r+i]*t[4*s+r];e[4*s+i]=o}return e}function $a(n,t,e,s){
let i=1/Math.tan(n/2),o=1/(e-s);return new Float32Array([i/t,0,0,0,0,i,0,0,0,0,(s+e)*o,-1,0,0,2*s*e*o,0])}function Da(n,t){let e=ee(qi(n,t)),s=ee(Zs([0,1,0],e)),
i=Zs(e,s);return new Float32Array([s[0],i[0],e[0],0,s[1],i[1],e[1],0,s[2],i[2],e[2],0,-Di(s,n),-Di(i,n),-Di(e,n),1])}function ee(n){let t=Math.hypot(...n)||1;return[
n[0]/t,n[1]/t,n[2]/t]}function tn(n,t,e,s){let i=ee(t),o=ee(Zs(i,Math.abs(i[2])>.9?[1,0,0]:[0,0,1])),r=Zs(o,i);return new Float32Array([...o.map(a=>a*s),0,...i.
map(a=>a*e),0,...r.map(a=>a*s),0,...n,1])}function Bi(n){let[t,e]=[Math.cos(n),Math.sin(n)];return new Float32Array([t,-e,0,0,e,t,0,0,0,0,1,0,0,0,0,1])}function bt(n){
let t=Number.parseInt(n.slice(1,7),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]}var qi,Di,Zs,zi=Z(()=>{"use strict";qi=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],
Di=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Zs=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]]});function ue(n,t,e){let s=n.createProgram(),i=[[n.VERTEX_SHADER,t],[n.FRAGMENT_SHADER,e]];for(let[r,a]of i){let l=n.createShader(r);if(n.shaderSource(l,a),n.compileShader(
l),!n.getShaderParameter(l,n.COMPILE_STATUS))throw new Error(String(n.getShaderInfoLog(l)));n.attachShader(s,l)}if(n.linkProgram(s),!n.getProgramParameter(s,n.LINK_STATUS))
throw new Error(String(n.getProgramInfoLog(s)));let o={program:s,uniforms:{},attributes:{}};for(let r=0;r<n.getProgramParameter(s,n.ACTIVE_UNIFORMS);r++){let{name:a}=n.
getActiveUniform(s,r);o.uniforms[a]=n.getUniformLocation(s,a)}for(let r=0;r<n.getProgramParameter(s,n.ACTIVE_ATTRIBUTES);r++){let{name:a}=n.getActiveAttrib(s,r);
o.attributes[a]=n.getAttribLocation(s,a)}return o}function se(n,t,e,s){let i=n.createBuffer();n.bindBuffer(n.ARRAY_BUFFER,i),n.bufferData(n.ARRAY_BUFFER,new Float32Array(
t),n.STATIC_DRAW);let o=s?n.createBuffer():null;s&&(n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,o),n.bufferData(n.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),n.STATIC_DRAW));
let r=4*Object.values(e).reduce((a,l)=>a+l,0);return{vertices:i,elements:o,parts:e,stride:r,count:s?s.length:4*t.length/r}}function pe(n,t,e){n.bindBuffer(n.ARRAY_BUFFER,
e.vertices);let s=0;for(let[i,o]of Object.entries(e.parts)){let r=t.attributes[i];r!==void 0&&(n.enableVertexAttribArray(r),n.vertexAttribPointer(r,o,n.FLOAT,!1,
e.stride,s)),s+=4*o}e.elements&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.elements)}function Ui(n,t){let e=[];for(let s=0;s<n;s++)for(let i=0;i<t;i++){let o=s*(t+1)+
i,r=o+t+1;e.push(o,r,o+1,r,r+1,o+1)}return e}function ja(n,t=120,e=14){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++)s.push(2*Math.PI*i/t,2*Math.PI*o/e);return se(
n,s,{bend:2},Ui(t,e))}function qa(n,t=28,e=18){let s=[];for(let i=0;i<=t;i++)for(let o=0;o<=e;o++){let[r,a]=[2*Math.PI*i/t,Math.PI*o/e],l=[Math.sin(a)*Math.cos(
r),Math.cos(a),Math.sin(a)*Math.sin(r)];s.push(...l,...l)}return se(n,s,{position:3,normal:3},Ui(t,e))}function Gi(n,t,e=20){let s=[];for(let i=0;i<=e;i++){let o=2*
Math.PI*i/e,r=[Math.cos(o),1-t,Math.sin(o)];s.push(Math.cos(o),0,Math.sin(o),...r,t*Math.cos(o),1,t*Math.sin(o),...r)}return se(n,s,{position:3,normal:3},Ui(e,1))}
var Wi=Z(()=>{"use strict"});var Ga,Wa,Ka,Ba,za,Ua,en,Va=Z(()=>{"use strict";zi();Wi();Ga=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Wa=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Ka="vec4(0.0, 0.0, 0.0, shadow)",Ba=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Wa}
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
   ${Ga}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Ka} : vec4(shaded(color, n), 1.0);
   }`],za=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Wa}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${Ga}
   void main() { gl_FragColor = shadow > 0.0 ? ${Ka} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],Ua=[`attribute vec3 position, next, tint; attribute \
float side;
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],en=class{constructor(t,e,s,i,{keep:o=!1}={}){this.canvas=t;
this.dark=i;this.eye=[0,0,1];this.fastest=1;let r=t.getContext("webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:o});if(!r)throw new Error("This browser dr\
aws nothing in space (WebGL is missing).");this.gl=r,this.sun=ee(s),this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=ue(r,Ba[0],Ba[1]),this.body=ue(r,za[0],za[1]),this.
line=ue(r,Ua[0],Ua[1]),this.torus=ja(r),this.sphere=qa(r),this.cylinder=Gi(r,1),this.cone=Gi(r,0),this.colors=r.createTexture(),r.bindTexture(r.TEXTURE_2D,this.
colors);let a=new Uint8Array(e.flatMap(l=>[...l,255]));r.pixelStorei(r.UNPACK_ALIGNMENT,1),r.texImage2D(r.TEXTURE_2D,0,r.RGBA,e.length,1,0,r.RGBA,r.UNSIGNED_BYTE,
a);for(let l of[r.TEXTURE_WRAP_S,r.TEXTURE_WRAP_T])r.texParameteri(r.TEXTURE_2D,l,r.CLAMP_TO_EDGE);for(let l of[r.TEXTURE_MIN_FILTER,r.TEXTURE_MAG_FILTER])r.texParameteri(
r.TEXTURE_2D,l,r.LINEAR);this.view=Bi(0)}begin({background:t,eye:e,target:s,slope:i,angle:o,near:r,far:a}){let{gl:l,canvas:c}=this;l.viewport(0,0,c.width,c.height),
l.clearColor(t[0],t[1],t[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let m=$a(o,c.width/c.height,r,a);this.
view=ji(ji(m,Da(e,s)),Bi(i)),this.eye=ee(qi(e,s))}use(t,e){let{gl:s}=this;s.useProgram(t.program);let i={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,
...e};for(let[o,r]of Object.entries(i)){let a=t.uniforms[o];a!==void 0&&(typeof r=="number"?s.uniform1f(a,r):r.length===16?s.uniformMatrix4fv(a,!1,r):s[`uniform${r.
length}fv`](a,r))}}ground(t){let{gl:e}=this;e.depthFunc(e.ALWAYS),t(),e.depthFunc(e.LESS)}shadows(t){let{gl:e}=this;e.enable(e.BLEND),e.blendFuncSeparate(e.SRC_ALPHA,
e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE),e.enable(e.STENCIL_TEST),e.stencilFunc(e.EQUAL,0,255),e.stencilOp(e.KEEP,e.KEEP,e.INCR),e.depthFunc(e.ALWAYS),e.depthMask(!1),
t(),e.depthMask(!0),e.depthFunc(e.LESS),e.disable(e.STENCIL_TEST),e.disable(e.BLEND)}solid(t,e,s,{shadow:i=!1,lit:o=!0}={}){let{gl:r}=this;this.use(this.body,{model:e,
color:s,shadow:i?this.dark:0,lit:Number(o)}),pe(r,this.body,t),r.drawElements(r.TRIANGLES,t.count,r.UNSIGNED_SHORT,0)}ball(t,e,s,i){this.solid(this.sphere,tn(t,
[0,1,0],e,e),s,{shadow:i})}ring({center:t,radius:e,tube:s,broad:i,angle:o,velocity:r,omega:a,plain:l=null},c){let{gl:m}=this;this.use(this.rim,{center:t,size:[e,
s,i,o],motion:[...r,a],most:this.fastest,shadow:c?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),pe(m,this.rim,this.torus),m.drawElements(m.TRIANGLES,this.torus.count,
m.UNSIGNED_SHORT,0)}rod(t,e,s,i,o,r=!1){this.solid(this.cylinder,tn(t,e,s,i),o,{shadow:r})}arrow(t,e,s,i,o){if(!(s>.02*i))return;let r=Math.min(.18*i,s),a=t.map(
(l,c)=>l+e[c]*(s-r));s>r&&this.rod(t,e,s-r,.029*i,o),this.solid(this.cone,tn(a,e,r,Math.min(.075*i,.6*r)),o)}trace(t,e,s){let i=[];for(let o=0;o<t;o++){let r=e(
o),a=e(Math.min(o+1,t-1));if(Math.hypot(a[0]-r[0],a[1]-r[1])<1e-9&&o>0){let l=e(o-1);a=r.map((c,m)=>2*c-l[m])}for(let l of[-1,1])i.push(...r,0,...a,0,...s(o),l)}
return se(this.gl,i,{position:3,next:3,tint:3,side:1})}drawTrace(t,e,{width:s,distance:i=0,shift:o,depth:r}){let{gl:a,canvas:l}=this;this.use(this.line,{pixel:[
2/l.width,2/l.height],width:s,distance:i,shift:o,depth:r}),pe(a,this.line,t),a.drawArrays(a.TRIANGLE_STRIP,0,2*e)}onScreen([t,e,s]){let i=this.view,[o,r,a]=[0,1,
3].map(l=>i[l]*t+i[4+l]*e+i[8+l]*s+i[12+l]);return a>0?[(.5+.5*o/a)*this.canvas.width,(.5-.5*r/a)*this.canvas.height]:null}}});var Xa={};fo(Xa,{Stage3D:()=>Ki});var su,nu,Ke,Ya,Ki,Ja=Z(()=>{"use strict";zi();Wi();Va();ht();N();Ot();Bt();su=[.35,.85,.4],nu=.18,Ke={azimuth:.5,height:.22,distance:5.2},
Ya=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],Ki=class{constructor(t,e){this.canvas=t;this.onview=e;this.space=new en(this.canvas,ae,su,nu,{keep:!0});this.floor=ue(this.space.gl,Ya[0],Ya[1]);this.corners=
se(this.space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2});this.turned={...Ke};this.lines=new WeakMap;this.share=1;this.pace=16;this.before=0;this.focus=0;this.reach=1;
t.addEventListener("pointerdown",s=>this.drag(s)),this.pinched=dt(t,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>t.parentElement})}zoomBy(t){t?this.
turned.distance=x(this.turned.distance/t,1.6,60):this.turned={...Ke},this.onview()}from(){let{azimuth:t,height:e,distance:s}=this.turned;return t===Ke.azimuth&&
e===Ke.height&&s===Ke.distance?void 0:[t,e,s]}look([t,e,s]){this.turned={azimuth:x(t,-1.5,1.5),height:x(e,.02,1.45),distance:x(s,1.6,60)}}drag(t){let e={...this.
turned,x:t.clientX,y:t.clientY};J(this.canvas,t,s=>{this.pinched()||(this.turned.azimuth=x(e.azimuth-(s.clientX-e.x)*.008,-1.5,1.5),this.turned.height=x(e.height+
(s.clientY-e.y)*.006,.02,1.45),this.onview())})}quality(){let t=performance.now(),e=t-(this.before||t);return this.before=t,e>0&&e<200&&(this.pace=.9*this.pace+
.1*e),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.pace=16),this.share}draw(t,e,s,i,o,r,a){let{canvas:l,space:c}=this,m=a??Math.min(
globalThis.devicePixelRatio||1,2)*(r?this.quality():1),h=l.getBoundingClientRect();l.width=Math.max(Math.round(h.width*m),1),l.height=Math.max(Math.round(h.height*
m),1);let p=t.map(g=>g.at(e)),d=t[0].radius;c.fastest=Math.max(...t.map(g=>g.extent.speed)),this.focus=Number.isFinite(p[0].x)?p[0].x:0,c.begin({background:bt(i.
paper),...this.camera(t[0],p[0],d,s)}),c.ground(()=>this.drawFloor(d,i));let f=g=>{for(let[_,b]of t.entries())g(b,p[_],-2.1*d*_)};c.shadows(()=>f((g,_,b)=>this.
drawHoop(g,_,b,s,i,o,!0))),f((g,_,b)=>{this.drawHoop(g,_,b,s,i,o,!1),s.traces&&this.drawTraces(g,_,b,i,o,m),s.forces&&this.drawForces(g,_,b,o)})}camera(t,e,s,i){
let{azimuth:o,height:r,distance:a}=this.turned,{left:l,right:c}=t.extent,m=i.whole?Math.max(a*s,.85*(c-l)+3*s):a*s,[h,p]=[i.whole?.5*(l+c)-this.focus:0,s+.45*(e.
height||0)],d=Math.cos(t.slope),f=Math.sin(t.slope),g=[h*d+p*f,-h*f+p*d,0],_=[g[0]+m*Math.sin(o)*Math.cos(r),g[1]+m*Math.sin(r),m*Math.cos(o)*Math.cos(r)];return this.
reach=12*s+3*m,{eye:_,target:g,slope:t.slope,angle:.75,near:.05*s,far:40*s+6*m}}drawFloor(t,e){let{space:s}=this,i=bt(e.ground),o=i.map(l=>l*(e.dark?.82:.94)),r=.5*
t,a=this.focus%(2*r);s.use(this.floor,{reach:this.reach,light:i,dark:o,far:bt(e.paper),tile:r,shift:a}),pe(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,
0,4)}drawHoop(t,e,s,i,o,r,a){let{space:l}=this,c=t.radius,m=.045*c,h=[e.x-this.focus,c+e.height,s];l.ring({center:h,radius:c,tube:m,broad:3.2*m,angle:e.angle,velocity:[
e.vx,e.vy],omega:e.omega,plain:i.speed?null:bt(r.modes[e.mode])},a);let p=[Math.sin(e.angle),Math.cos(e.angle),0],d=g=>h.map((_,b)=>_+g*p[b]);l.ball(d(c-m),.125*
c,o.dark?[.9,.91,.94]:[.12,.13,.15],a),l.rod(h,p,c-m,.012*c,[.55,.57,.6],a);let f=e.mode==="H";l.ball(d(t.eccentricity*c),.07*c,bt(f?r.airborne:r.gravity_center),
a)}drawForces(t,e,s,i){if(e.mode==="H"||!(e.normal_force>0))return;let o=t.radius,r=t.mass*(t.gravity||9.81),a=[e.x-this.focus,e.height+.03*o,s+.2*o],l=m=>x(.55*
o*Math.abs(m)/r,0,3.2*o),c=Math.sign(e.friction_force);this.space.arrow(a,[0,1,0],l(e.normal_force),o,bt(i.normal_force)),this.space.arrow(a,[c,0,0],l(e.friction_force),
o,bt(i.friction_force))}linesOf(t,e,s){let i=this.lines.get(t);if(i?.dark===e.dark)return i;let o=t.radius,{x:r,height:a,angle:l,mode:c}=t.columns,m=(g,_)=>this.
space.trace(t.length,b=>[r[b]+g*Math.sin(l[b]),o+a[b]+g*Math.cos(l[b])],_),[h,p,d]=[bt(s.gravity_center),bt(s.airborne),bt(e.ink)],f={dark:e.dark,load:m(o,()=>d),
center:m(t.eccentricity*o,g=>c[g]===3?p:h)};return this.lines.set(t,f),f}drawTraces(t,e,s,i,o,r){let{load:a,center:l}=this.linesOf(t,i,o),c=Math.min(t.index(e.t)+
2,t.length),m={shift:this.focus,depth:s};this.space.drawTrace(a,c,{width:r,...m}),this.space.drawTrace(l,c,{width:1.6*r,...m})}}});var el=Vl(sn=>{"use strict";Object.defineProperty(sn,"__esModule",{value:!0});function Qa(n){return!n||typeof n=="string"?n:n+""}var Vi=class{async svg2canvas(t,e,s){
let i=await new Promise(a=>{var l=new Image;l.onload=function(){a(l)},l.src=t});var o=document.createElement("canvas");return o.width=e,o.height=s,o.getContext(
"2d").drawImage(i,0,0),o}toDataURL(t,e,s,i,o,r){var a=new XMLSerializer().serializeToString(t),l=document.documentMode;if(l){var c=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi;
c.test(a)&&(a=a.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink'))}r||(r={});var m="data:image/svg+xml;charset=utf-8,"+encodeURIComponent(
a);if(i==="image/svg+xml"||!i)return r.async?Promise.resolve(m):m;if(i==="image/jpeg"||i==="image/png"){if(!r.async)throw new Error("svgcanvas: options.async mu\
st be set to true if type is image/jpeg | image/png");return(async()=>{let h=await this.svg2canvas(m,e,s),p=h.toDataURL(i,o);return h.remove(),p})()}throw new Error(
"svgcanvas: Unknown type for toDataURL, please use image/jpeg | image/png | image/svg+xml.")}getImageData(t,e,s,i,o,r,a,l){if(l||(l={}),!l.async)throw new Error(
"svgcanvas: options.async must be set to true for getImageData");let c=this.toDataURL(t,e,s,"image/svg+xml");return(async()=>{let m=await this.svg2canvas(c,e,s),
p=m.getContext("2d").getImageData(i,o,r,a);return m.remove(),p})()}},Za=new Vi;var tl=(function(){var n,t,e,s,i;function o(h,p){var d=Object.keys(p),f;for(f=0;f<
d.length;f++)h=h.replace(new RegExp("\\{"+d[f]+"\\}","gi"),p[d[f]]);return h}function r(h){var p,d,f;if(!h)throw new Error("cannot create a random attribute nam\
e for an undefined object");p="ABCDEFGHIJKLMNOPQRSTUVWXTZabcdefghiklmnopqrstuvwxyz",d="";do for(d="",f=0;f<12;f++)d+=p[Math.floor(Math.random()*p.length)];while(h[d]);
return d}function a(h,p){var d,f,g={},_;for(h=h.split(","),p=p||10,d=0;d<h.length;d+=2)f="&"+h[d+1]+";",_=parseInt(h[d],p),g[f]="&#"+_+";";return g["\\xa0"]="&#\
160;",g}function l(h){var p={left:"start",right:"end",center:"middle",start:"start",end:"end"};return p[h]||p.start}function c(h){var p={alphabetic:"alphabetic",
hanging:"hanging",top:"text-before-edge",bottom:"text-after-edge",middle:"central"};return p[h]||p.alphabetic}i=a("50,nbsp,51,iexcl,52,cent,53,pound,54,curren,5\
5,yen,56,brvbar,57,sect,58,uml,59,copy,5a,ordf,5b,laquo,5c,not,5d,shy,5e,reg,5f,macr,5g,deg,5h,plusmn,5i,sup2,5j,sup3,5k,acute,5l,micro,5m,para,5n,middot,5o,ced\
il,5p,sup1,5q,ordm,5r,raquo,5s,frac14,5t,frac12,5u,frac34,5v,iquest,60,Agrave,61,Aacute,62,Acirc,63,Atilde,64,Auml,65,Aring,66,AElig,67,Ccedil,68,Egrave,69,Eacu\
te,6a,Ecirc,6b,Euml,6c,Igrave,6d,Iacute,6e,Icirc,6f,Iuml,6g,ETH,6h,Ntilde,6i,Ograve,6j,Oacute,6k,Ocirc,6l,Otilde,6m,Ouml,6n,times,6o,Oslash,6p,Ugrave,6q,Uacute,\
6r,Ucirc,6s,Uuml,6t,Yacute,6u,THORN,6v,szlig,70,agrave,71,aacute,72,acirc,73,atilde,74,auml,75,aring,76,aelig,77,ccedil,78,egrave,79,eacute,7a,ecirc,7b,euml,7c,\
igrave,7d,iacute,7e,icirc,7f,iuml,7g,eth,7h,ntilde,7i,ograve,7j,oacute,7k,ocirc,7l,otilde,7m,ouml,7n,divide,7o,oslash,7p,ugrave,7q,uacute,7r,ucirc,7s,uuml,7t,ya\
cute,7u,thorn,7v,yuml,ci,fnof,sh,Alpha,si,Beta,sj,Gamma,sk,Delta,sl,Epsilon,sm,Zeta,sn,Eta,so,Theta,sp,Iota,sq,Kappa,sr,Lambda,ss,Mu,st,Nu,su,Xi,sv,Omicron,t0,P\
i,t1,Rho,t3,Sigma,t4,Tau,t5,Upsilon,t6,Phi,t7,Chi,t8,Psi,t9,Omega,th,alpha,ti,beta,tj,gamma,tk,delta,tl,epsilon,tm,zeta,tn,eta,to,theta,tp,iota,tq,kappa,tr,lamb\
da,ts,mu,tt,nu,tu,xi,tv,omicron,u0,pi,u1,rho,u2,sigmaf,u3,sigma,u4,tau,u5,upsilon,u6,phi,u7,chi,u8,psi,u9,omega,uh,thetasym,ui,upsih,um,piv,812,bull,816,hellip,\
81i,prime,81j,Prime,81u,oline,824,frasl,88o,weierp,88h,image,88s,real,892,trade,89l,alefsym,8cg,larr,8ch,uarr,8ci,rarr,8cj,darr,8ck,harr,8dl,crarr,8eg,lArr,8eh,\
uArr,8ei,rArr,8ej,dArr,8ek,hArr,8g0,forall,8g2,part,8g3,exist,8g5,empty,8g7,nabla,8g8,isin,8g9,notin,8gb,ni,8gf,prod,8gh,sum,8gi,minus,8gn,lowast,8gq,radic,8gt,\
prop,8gu,infin,8h0,ang,8h7,and,8h8,or,8h9,cap,8ha,cup,8hb,int,8hk,there4,8hs,sim,8i5,cong,8i8,asymp,8j0,ne,8j1,equiv,8j4,le,8j5,ge,8k2,sub,8k3,sup,8k4,nsub,8k6,\
sube,8k7,supe,8kl,oplus,8kn,otimes,8l5,perp,8m5,sdot,8o8,lceil,8o9,rceil,8oa,lfloor,8ob,rfloor,8p9,lang,8pa,rang,9ea,loz,9j0,spades,9j3,clubs,9j5,hearts,9j6,dia\
ms,ai,OElig,aj,oelig,b0,Scaron,b1,scaron,bo,Yuml,m6,circ,ms,tilde,802,ensp,803,emsp,809,thinsp,80c,zwnj,80d,zwj,80e,lrm,80f,rlm,80j,ndash,80k,mdash,80o,lsquo,80\
p,rsquo,80q,sbquo,80s,ldquo,80t,rdquo,80u,bdquo,810,dagger,811,Dagger,81g,permil,81p,lsaquo,81q,rsaquo,85c,euro",32),n={strokeStyle:{svgAttr:"stroke",canvas:"#0\
00000",svg:"none",apply:"stroke"},fillStyle:{svgAttr:"fill",canvas:"#000000",svg:null,apply:"fill"},lineCap:{svgAttr:"stroke-linecap",canvas:"butt",svg:"butt",apply:"\
stroke"},lineJoin:{svgAttr:"stroke-linejoin",canvas:"miter",svg:"miter",apply:"stroke"},miterLimit:{svgAttr:"stroke-miterlimit",canvas:10,svg:4,apply:"stroke"},
lineWidth:{svgAttr:"stroke-width",canvas:1,svg:1,apply:"stroke"},globalAlpha:{svgAttr:"opacity",canvas:1,svg:1,apply:"fill stroke"},font:{canvas:"10px sans-seri\
f"},shadowColor:{canvas:"#000000"},shadowOffsetX:{canvas:0},shadowOffsetY:{canvas:0},shadowBlur:{canvas:0},textAlign:{canvas:"start"},textBaseline:{canvas:"alph\
abetic"},lineDash:{svgAttr:"stroke-dasharray",canvas:[],svg:null,apply:"stroke"}},e=function(h,p){this.__root=h,this.__ctx=p},e.prototype.addColorStop=function(h,p){
var d=this.__ctx.__createElement("stop"),f,g;d.setAttribute("offset",h),Qa(p).indexOf("rgba")!==-1?(f=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
g=f.exec(p),d.setAttribute("stop-color",o("rgb({r},{g},{b})",{r:g[1],g:g[2],b:g[3]})),d.setAttribute("stop-opacity",g[4])):d.setAttribute("stop-color",Qa(p)),this.
__root.appendChild(d)},s=function(h,p){this.__root=h,this.__ctx=p},t=function(h){var p={width:500,height:500,enableMirroring:!1},d;if(arguments.length>1?(d=p,d.
width=arguments[0],d.height=arguments[1]):h?d=h:d=p,!(this instanceof t))return new t(d);this.width=d.width||p.width,this.height=d.height||p.height,this.enableMirroring=
d.enableMirroring!==void 0?d.enableMirroring:p.enableMirroring,this.canvas=this,this.__document=d.document||document,d.ctx?this.__ctx=d.ctx:(this.__canvas=this.
__document.createElement("canvas"),this.__ctx=this.__canvas.getContext("2d")),this.__setDefaultStyles(),this.__styleStack=[this.__getStyleState()],this.__groupStack=
[],this.__root=this.__document.createElementNS("http://www.w3.org/2000/svg","svg"),this.__root.setAttribute("version",1.1),this.__root.setAttribute("xmlns","htt\
p://www.w3.org/2000/svg"),this.__root.setAttributeNS("http://www.w3.org/2000/xmlns/","xmlns:xlink","http://www.w3.org/1999/xlink"),this.__root.setAttribute("wid\
th",this.width),this.__root.setAttribute("height",this.height),this.__ids={},this.__defs=this.__document.createElementNS("http://www.w3.org/2000/svg","defs"),this.
__root.appendChild(this.__defs),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.resetTransform(),this.__options=d,this.__id=Math.random().toString(16).substring(2,8),this.__debug("new",h)},t.prototype.__debug=function(...h){this.__options.
debug&&console.debug(`svgcanvas#${this.__id}:`,...h)},t.prototype.__createElement=function(h,p,d){typeof p>"u"&&(p={});var f=this.__document.createElementNS("ht\
tp://www.w3.org/2000/svg",h),g=Object.keys(p),_,b;for(d&&(f.setAttribute("fill","none"),f.setAttribute("stroke","none")),_=0;_<g.length;_++)b=g[_],f.setAttribute(
b,p[b]);return f},t.prototype.__setDefaultStyles=function(){var h=Object.keys(n),p,d;for(p=0;p<h.length;p++)d=h[p],this[d]=n[d].canvas},t.prototype.__applyStyleState=
function(h){var p=Object.keys(h),d,f;for(d=0;d<p.length;d++)f=p[d],this[f]=h[f]},t.prototype.__getStyleState=function(){var h,p={},d=Object.keys(n),f;for(h=0;h<
d.length;h++)f=d[h],p[f]=this[f];return p},t.prototype.__applyTransformation=function(h,p){let{a:d,b:f,c:g,d:_,e:b,f:y}=p||this.getTransform();h.setAttribute("t\
ransform",`matrix(${d} ${f} ${g} ${_} ${b} ${y})`)},t.prototype.__applyStyleToCurrentElement=function(h){var p=this.__currentElement,d=this.__currentElementsToStyle;
d&&(p.setAttribute(h,""),p=d.element,d.children.forEach(function(B){B.setAttribute(h,"")}));var f=Object.keys(n),g,_,b,y,w,k,T,C;for(g=0;g<f.length;g++)if(_=n[f[g]],
b=this[f[g]],_.apply){if(b instanceof s){if(b.__ctx)for(T=0;T<b.__ctx.__defs.childNodes.length;T++)C=b.__ctx.__defs.childNodes[T],k=C.getAttribute("id"),this.__ids[k]=
k,this.__defs.appendChild(C);p.setAttribute(_.apply,o("url(#{id})",{id:b.__root.getAttribute("id")}))}else if(b instanceof e)p.setAttribute(_.apply,o("url(#{id}\
)",{id:b.__root.getAttribute("id")}));else if(_.apply.indexOf(h)!==-1&&_.svg!==b)if((_.svgAttr==="stroke"||_.svgAttr==="fill")&&b&&b.indexOf("rgba")!==-1){y=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
w=y.exec(b),p.setAttribute(_.svgAttr,o("rgb({r},{g},{b})",{r:w[1],g:w[2],b:w[3]}));var R=w[4],q=this.globalAlpha;q!=null&&(R*=q),p.setAttribute(_.svgAttr+"-opac\
ity",R)}else{var A=_.svgAttr;if(f[g]==="globalAlpha"){if(A=h+"-"+_.svgAttr,p.getAttribute(A))continue}else if(f[g]==="lineWidth"){var $=this.__getTransformScale();
b=b*Math.max($.x,$.y)}p.setAttribute(A,b)}}},t.prototype.__closestGroupOrSvg=function(h){return h=h||this.__currentElement,h.nodeName==="g"||h.nodeName==="svg"?
h:this.__closestGroupOrSvg(h.parentNode)},t.prototype.getSerializedSvg=function(h){var p=new XMLSerializer().serializeToString(this.__root),d,f,g,_,b,y;if(y=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi,
y.test(p)&&(p=p.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink')),h)for(d=Object.keys(i),f=0;f<d.length;f++)g=d[f],_=i[g],
b=new RegExp(g,"gi"),b.test(p)&&(p=p.replace(b,_));return p},t.prototype.getSvg=function(){return this.__root},t.prototype.save=function(){var h=this.__createElement(
"g"),p=this.__closestGroupOrSvg();this.__groupStack.push(p),p.appendChild(h),this.__currentElement=h;let d=this.__getStyleState();this.__debug("save style",d),this.
__styleStack.push(d),this.__transformMatrixStack||(this.__transformMatrixStack=[]),this.__transformMatrixStack.push(this.getTransform())},t.prototype.restore=function(){
this.__currentElement=this.__groupStack.pop(),this.__currentElementsToStyle=null,this.__currentElement||(this.__currentElement=this.__root.childNodes[1]);var h=this.
__styleStack.pop();this.__debug("restore style",h),this.__applyStyleState(h),this.__transformMatrixStack&&this.__transformMatrixStack.length>0&&this.setTransform(
this.__transformMatrixStack.pop())},t.prototype.beginPath=function(){var h,p;this.__currentDefaultPath="",this.__currentPosition={},h=this.__createElement("path",
{},!0),p=this.__closestGroupOrSvg(),p.appendChild(h),this.__currentElement=h},t.prototype.__applyCurrentDefaultPath=function(){var h=this.__currentElement;h.nodeName===
"path"?h.setAttribute("d",this.__currentDefaultPath):console.error("Attempted to apply path command to node",h.nodeName)},t.prototype.__addPathCommand=function(h){
this.__currentDefaultPath+=" ",this.__currentDefaultPath+=h},t.prototype.moveTo=function(h,p){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.__currentPosition=
{x:h,y:p},this.__addPathCommand(o("M {x} {y}",{x:this.__matrixTransform(h,p).x,y:this.__matrixTransform(h,p).y}))},t.prototype.closePath=function(){this.__currentDefaultPath&&
this.__addPathCommand("Z")},t.prototype.lineTo=function(h,p){this.__currentPosition={x:h,y:p},this.__currentDefaultPath.indexOf("M")>-1?this.__addPathCommand(o(
"L {x} {y}",{x:this.__matrixTransform(h,p).x,y:this.__matrixTransform(h,p).y})):this.__addPathCommand(o("M {x} {y}",{x:this.__matrixTransform(h,p).x,y:this.__matrixTransform(
h,p).y}))},t.prototype.bezierCurveTo=function(h,p,d,f,g,_){this.__currentPosition={x:g,y:_},this.__addPathCommand(o("C {cp1x} {cp1y} {cp2x} {cp2y} {x} {y}",{cp1x:this.
__matrixTransform(h,p).x,cp1y:this.__matrixTransform(h,p).y,cp2x:this.__matrixTransform(d,f).x,cp2y:this.__matrixTransform(d,f).y,x:this.__matrixTransform(g,_).
x,y:this.__matrixTransform(g,_).y}))},t.prototype.quadraticCurveTo=function(h,p,d,f){this.__currentPosition={x:d,y:f},this.__addPathCommand(o("Q {cpx} {cpy} {x}\
 {y}",{cpx:this.__matrixTransform(h,p).x,cpy:this.__matrixTransform(h,p).y,x:this.__matrixTransform(d,f).x,y:this.__matrixTransform(d,f).y}))};var m=function(h){
var p=Math.sqrt(h[0]*h[0]+h[1]*h[1]);return[h[0]/p,h[1]/p]};return t.prototype.arcTo=function(h,p,d,f,g){var _=this.__currentPosition&&this.__currentPosition.x,
b=this.__currentPosition&&this.__currentPosition.y;if(!(typeof _>"u"||typeof b>"u")){if(g<0)throw new Error("IndexSizeError: The radius provided ("+g+") is nega\
tive.");if(_===h&&b===p||h===d&&p===f||g===0){this.lineTo(h,p);return}var y=m([_-h,b-p]),w=m([d-h,f-p]);if(y[0]*w[1]===y[1]*w[0]){this.lineTo(h,p);return}var k=y[0]*
w[0]+y[1]*w[1],T=Math.acos(Math.abs(k)),C=m([y[0]+w[0],y[1]+w[1]]),R=g/Math.sin(T/2),q=h+R*C[0],A=p+R*C[1],$=[-y[1],y[0]],B=[w[1],-w[0]],ft=function(uo){var po=uo[0],
Bl=uo[1];return Bl>=0?Math.acos(po):-Math.acos(po)},Wt=ft($),Xe=ft(B);this.lineTo(q+$[0]*g,A+$[1]*g),this.arc(q,A,g,Wt,Xe)}},t.prototype.stroke=function(){this.
__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","fill stroke markers"),this.__applyCurrentDefaultPath(),this.__applyStyleToCurrentElement(
"stroke")},t.prototype.fill=function(){this.__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","stroke fill markers"),this.__applyCurrentDefaultPath(),
this.__applyStyleToCurrentElement("fill")},t.prototype.rect=function(h,p,d,f){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.moveTo(h,p),this.lineTo(
h+d,p),this.lineTo(h+d,p+f),this.lineTo(h,p+f),this.lineTo(h,p),this.closePath()},t.prototype.roundRect=function(h,p,d,f,g){this.__currentElement.nodeName!=="pa\
th"&&this.beginPath();let _,b,y,w;typeof g=="number"?(_=g,b=g,y=g,w=g):[_,b,y,w]=g,this.moveTo(h+_,p),this.arcTo(h+d,p,h+d,p+f,b),this.arcTo(h+d,p+f,h,p+f,y),this.
arcTo(h,p+f,h,p,w),this.arcTo(h,p,h+d,p,_),this.closePath()},t.prototype.fillRect=function(h,p,d,f){let{a:g,b:_,c:b,d:y,e:w,f:k}=this.getTransform();JSON.stringify(
[g,_,b,y,w,k])===JSON.stringify([1,0,0,1,0,0])&&h===0&&p===0&&d===this.width&&f===this.height&&this.__clearCanvas();var T,C;T=this.__createElement("rect",{x:h,y:p,
width:d,height:f},!0),C=this.__closestGroupOrSvg(),C.appendChild(T),this.__currentElement=T,this.__applyTransformation(T),this.__applyStyleToCurrentElement("fil\
l")},t.prototype.strokeRect=function(h,p,d,f){var g,_;g=this.__createElement("rect",{x:h,y:p,width:d,height:f},!0),_=this.__closestGroupOrSvg(),_.appendChild(g),
this.__currentElement=g,this.__applyTransformation(g),this.__applyStyleToCurrentElement("stroke")},t.prototype.__clearCanvas=function(){var h=this.__root.childNodes[1];
this.__root.removeChild(h),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.__groupStack=[]},t.prototype.clearRect=function(h,p,d,f){let{a:g,b:_,c:b,d:y,e:w,f:k}=this.getTransform();if(JSON.stringify([g,_,b,y,w,k])===JSON.stringify(
[1,0,0,1,0,0])&&h===0&&p===0&&d===this.width&&f===this.height){this.__clearCanvas();return}var T,C=this.__closestGroupOrSvg();T=this.__createElement("rect",{x:h,
y:p,width:d,height:f,fill:"#FFFFFF"},!0),this.__applyTransformation(T),C.appendChild(T)},t.prototype.createLinearGradient=function(h,p,d,f){var g=this.__createElement(
"linearGradient",{id:r(this.__ids),x1:h+"px",x2:d+"px",y1:p+"px",y2:f+"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(g),new e(g,this)},
t.prototype.createRadialGradient=function(h,p,d,f,g,_){var b=this.__createElement("radialGradient",{id:r(this.__ids),cx:f+"px",cy:g+"px",r:_+"px",fx:h+"px",fy:p+
"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(b),new e(b,this)},t.prototype.__applyText=function(h,p,d,f){var g=document.createElement(
"span");g.setAttribute("style","font:"+this.font);var _=g.style,b=this.__closestGroupOrSvg(),y=this.__createElement("text",{"font-family":_.fontFamily,"font-siz\
e":_.fontSize,"font-style":_.fontStyle,"font-weight":_.fontWeight,"text-decoration":this.__fontUnderline,x:p,y:d,"text-anchor":l(this.textAlign),"dominant-basel\
ine":c(this.textBaseline)},!0);if(y.appendChild(this.__document.createTextNode(h)),this.__currentElement=y,this.__applyTransformation(y),this.__applyStyleToCurrentElement(
f),this.__fontHref){var w=this.__createElement("a");w.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",this.__fontHref),w.appendChild(y),y=w}b.appendChild(
y)},t.prototype.fillText=function(h,p,d){this.__applyText(h,p,d,"fill")},t.prototype.strokeText=function(h,p,d){this.__applyText(h,p,d,"stroke")},t.prototype.measureText=
function(h){return this.__ctx.font=this.font,this.__ctx.measureText(h)},t.prototype.arc=function(h,p,d,f,g,_){if(f!==g){f=f%(2*Math.PI),g=g%(2*Math.PI),f===g&&(g=
(g+2*Math.PI-.001*(_?-1:1))%(2*Math.PI));var b=h+d*Math.cos(g),y=p+d*Math.sin(g),w=h+d*Math.cos(f),k=p+d*Math.sin(f),T=_?0:1,C=0,R=g-f;R<0&&(R+=2*Math.PI),_?C=R>
Math.PI?0:1:C=R>Math.PI?1:0;var q=Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),A=Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d);
this.lineTo(w,k),this.__addPathCommand(o("A {rx} {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:d*q,ry:d*A,xAxisRotation:0,largeArcFlag:C,sweepFlag:T,
endX:this.__matrixTransform(b,y).x,endY:this.__matrixTransform(b,y).y})),this.__currentPosition={x:b,y}}},t.prototype.ellipse=function(h,p,d,f,g,_,b,y){if(_!==b){
var w=this.__matrixTransform(h,p);h=w.x,p=w.y;var k=this.__getTransformScale();d=d*k.x,f=f*k.y,g=g+this.__getTransformRotation(),_=_%(2*Math.PI),b=b%(2*Math.PI),
_===b&&(b=(b+2*Math.PI-.001*(y?-1:1))%(2*Math.PI));var T=h+Math.cos(-g)*d*Math.cos(b)+Math.sin(-g)*f*Math.sin(b),C=p-Math.sin(-g)*d*Math.cos(b)+Math.cos(-g)*f*Math.
sin(b),R=h+Math.cos(-g)*d*Math.cos(_)+Math.sin(-g)*f*Math.sin(_),q=p-Math.sin(-g)*d*Math.cos(_)+Math.cos(-g)*f*Math.sin(_),A=y?0:1,$=0,B=b-_;B<0&&(B+=2*Math.PI),
y?$=B>Math.PI?0:1:$=B>Math.PI?1:0;var ft=this.__transformMatrix;this.resetTransform(),this.lineTo(R,q),this.__transformMatrix=ft,this.__addPathCommand(o("A {rx}\
 {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:d,ry:f,xAxisRotation:g*(180/Math.PI),largeArcFlag:$,sweepFlag:A,endX:T,endY:C})),this.__currentPosition=
{x:T,y:C}}},t.prototype.clip=function(){var h=this.__closestGroupOrSvg(),p=this.__createElement("clipPath"),d=r(this.__ids),f=this.__createElement("g");this.__applyCurrentDefaultPath(),
h.removeChild(this.__currentElement),p.setAttribute("id",d),p.appendChild(this.__currentElement),this.__defs.appendChild(p),h.setAttribute("clip-path",o("url(#{\
id})",{id:d})),h.appendChild(f),this.__currentElement=f},t.prototype.drawImage=function(){var h=Array.prototype.slice.call(arguments),p=h[0],d,f,g,_,b=0,y=0,w,k,
T,C,R,q,A,$,B,ft;if(h.length===3)d=h[1],f=h[2],w=p.width,k=p.height,g=w,_=k;else if(h.length===5)d=h[1],f=h[2],g=h[3],_=h[4],w=p.width,k=p.height;else if(h.length===
9)b=h[1],y=h[2],w=h[3],k=h[4],d=h[5],f=h[6],g=h[7],_=h[8];else throw new Error("Invalid number of arguments passed to drawImage: "+arguments.length);T=this.__closestGroupOrSvg(),
this.__currentElement;let Wt=this.getTransform().translate(d,f);if(p instanceof t){if(C=p.getSvg().cloneNode(!0),C.childNodes&&C.childNodes.length>1){for(R=C.childNodes[0];R.
childNodes.length;)ft=R.childNodes[0].getAttribute("id"),this.__ids[ft]=ft,this.__defs.appendChild(R.childNodes[0]);q=C.childNodes[1],q&&(this.__applyTransformation(
q,Wt),T.appendChild(q))}}else(p.nodeName==="CANVAS"||p.nodeName==="IMG")&&(A=this.__createElement("image"),A.setAttribute("width",g),A.setAttribute("height",_),
A.setAttribute("preserveAspectRatio","none"),(b||y||w!==p.width||k!==p.height)&&($=this.__document.createElement("canvas"),$.width=g,$.height=_,B=$.getContext("\
2d"),B.drawImage(p,b,y,w,k,0,0,g,_),p=$),this.__applyTransformation(A,Wt),A.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",p.nodeName==="CANVAS"?p.toDataURL():
p.getAttribute("src")),T.appendChild(A))},t.prototype.createPattern=function(h,p){var d=this.__document.createElementNS("http://www.w3.org/2000/svg","pattern"),
f=r(this.__ids),g;return d.setAttribute("id",f),d.setAttribute("width",h.width),d.setAttribute("height",h.height),d.setAttribute("patternUnits","userSpaceOnUse"),
h.nodeName==="CANVAS"||h.nodeName==="IMG"?(g=this.__document.createElementNS("http://www.w3.org/2000/svg","image"),g.setAttribute("width",h.width),g.setAttribute(
"height",h.height),g.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",h.nodeName==="CANVAS"?h.toDataURL():h.getAttribute("src")),d.appendChild(g),this.
__defs.appendChild(d)):h instanceof t&&(d.appendChild(h.__root.childNodes[1]),this.__defs.appendChild(d)),new s(d,this)},t.prototype.setLineDash=function(h){h&&
h.length>0?this.lineDash=h.join(","):this.lineDash=null},t.prototype.setTransform=function(h,p,d,f,g,_){h instanceof DOMMatrix?this.__transformMatrix=new DOMMatrix(
[h.a,h.b,h.c,h.d,h.e,h.f]):this.__transformMatrix=new DOMMatrix([h,p,d,f,g,_])},t.prototype.getTransform=function(){let{a:h,b:p,c:d,d:f,e:g,f:_}=this.__transformMatrix;
return new DOMMatrix([h,p,d,f,g,_])},t.prototype.resetTransform=function(){this.setTransform(1,0,0,1,0,0)},t.prototype.scale=function(h,p){if(p===void 0&&(p=h),
isNaN(h)||isNaN(p)||!isFinite(h)||!isFinite(p))return;let d=this.getTransform().scale(h,p);this.setTransform(d)},t.prototype.rotate=function(h){let p=this.getTransform().
multiply(new DOMMatrix([Math.cos(h),Math.sin(h),-Math.sin(h),Math.cos(h),0,0]));this.setTransform(p)},t.prototype.translate=function(h,p){let d=this.getTransform().
translate(h,p);this.setTransform(d)},t.prototype.transform=function(h,p,d,f,g,_){let b=this.getTransform().multiply(new DOMMatrix([h,p,d,f,g,_]));this.setTransform(
b)},t.prototype.__matrixTransform=function(h,p){return new DOMPoint(h,p).matrixTransform(this.__transformMatrix)},t.prototype.__getTransformScale=function(){return{
x:Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),y:Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d)}},t.prototype.__getTransformRotation=
function(){return Math.atan2(this.__transformMatrix.b,this.__transformMatrix.a)},t.prototype.getImageData=function(h,p,d,f,g){return Za.getImageData(this.getSvg(),
this.width,this.height,h,p,d,f,g)},t.prototype.drawFocusRing=function(){},t.prototype.createImageData=function(){},t.prototype.putImageData=function(){},t.prototype.
globalCompositeOperation=function(){},t})();function zt(n){this.ctx=new tl(n),this.svg=this.ctx.__root;var t=this.svg,e=this,s=document.createElement("div");s.style.
display="inline-block",s.appendChild(t),this.wrapper=s,Object.defineProperty(this,"className",{get:function(){return s.getAttribute("class")||""},set:function(i){
return s.setAttribute("class",i)}}),Object.defineProperty(this,"tagName",{get:function(){return"CANVAS"},set:function(){}}),["width","height"].forEach(function(i){
Object.defineProperty(e,i,{get:function(){return t.getAttribute(i)|0},set:function(o){if(!(isNaN(o)||typeof o>"u"))return e.ctx[i]=o,t.setAttribute(i,o),s[i]=o}})}),
["style","id"].forEach(function(i){Object.defineProperty(e,i,{get:function(){return s[i]},set:function(o){if(typeof o<"u")return s[i]=o}})}),["getBoundingClient\
Rect"].forEach(function(i){e[i]=function(){return t[i]()}})}zt.prototype.getContext=function(n){if(n!=="2d")throw new Error("Unsupported type of context for SVG\
Canvas");return this.ctx};zt.prototype.toObjectURL=function(){var n=new XMLSerializer().serializeToString(this.svg),t=new Blob([n],{type:"image/svg+xml;charset=\
utf-8"});return URL.createObjectURL(t)};zt.prototype.toDataURL=function(n,t,e){return Za.toDataURL(this.svg,this.width,this.height,n,t,e)};zt.prototype.addEventListener=
function(){return this.svg.addEventListener.apply(this.svg,arguments)};zt.prototype.getElement=function(){return this.wrapper};zt.prototype.getAttribute=function(n){
return this.wrapper.getAttribute(n)};zt.prototype.setAttribute=function(n,t){this.wrapper.setAttribute(n,t)};sn.Context=tl;sn.Element=zt});var sl={};fo(sl,{Context:()=>nl.Context});var nl,il=Z(()=>{"use strict";nl=Xl(el(),1)});var v={sources:"8b55b304b90bb2841a2033a0ba629ce4",module:"08ddd1356e3298fb",derivatives:"caff7ba008cdc5ef",built_with:{numba:"0.68.1",llvmlite:"0.50.0",numpy:"2\
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
"buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var Kt=n=>Object.fromEntries(n.map((t,e)=>[t,e])),go=Kt(v.cell),wt=Kt(v.heads),z=Kt(v.events),xn=Kt(v.samples),_o=Kt(v.changes),bo=Kt(v.numbers),kn=Kt(v.words),
Ql={law:({impact_law:n})=>v.impact_laws.indexOf(n),strike:({painleve:n})=>+(n==="impact"),allowed:()=>1},ge=v.cell.map(n=>Ql[n]??(t=>Number(t[n]??0))),Ft=n=>Float64Array.
from(ge,t=>t(n));function _e(n){let t=n?{...n,law:v.laws.indexOf(n.law),friction_law:v.friction_laws.indexOf(n.friction)}:{};return Float64Array.from(v.compliant,
e=>t[e]??Number.NaN)}var yo={setup:{version:"0.1.0",controls:{groups:{hoop:[{path:"hoop.load_fraction",label:"parameter.hoop.load_fraction",symbol:"γ",unit:"",help:"help.hoop.load_\
fraction",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}},{path:"hoop.eccentricity",label:"parameter.hoop.eccentricity",symbol:"\
ε",unit:"",help:"help.hoop.eccentricity",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}},{path:"hoop.inertia_ratio",label:"\
parameter.hoop.inertia_ratio",symbol:"κ",unit:"",help:"help.hoop.inertia_ratio",least:.01,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:1e-12,most:1e6,
also:[0]}},{path:"hoop.radius",label:"parameter.hoop.radius",symbol:"R",unit:"m",help:"help.hoop.radius",least:.05,most:3,step:.05,logarithmic:!1,degrees:!1,allowed:{
least:1e-6,most:1e6,also:[]}},{path:"hoop.mass",label:"parameter.hoop.mass",symbol:"m",unit:"kg",help:"help.hoop.mass",least:.1,most:10,step:.1,logarithmic:!1,degrees:!1,
allowed:{least:1e-12,most:1e12,also:[]}}],plane:[{path:"plane.mu",label:"parameter.plane.mu",symbol:"μ",unit:"",help:"help.plane.mu",least:0,most:1.5,step:.01,
logarithmic:!1,degrees:!1,allowed:{least:0,most:1e6,also:["inf"]}},{path:"plane.mu_static",label:"parameter.plane.mu_static",symbol:"μs",unit:"",help:"help.pla\
ne.mu_static",least:0,most:1.5,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1e6,also:["inf"]}},{path:"plane.mu_kinetic",label:"parameter.plane.mu_ki\
netic",symbol:"μk",unit:"",help:"help.plane.mu_kinetic",least:0,most:1.5,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1e6,also:["inf"]}},{path:"pla\
ne.slope",label:"parameter.plane.slope",symbol:"β",unit:"°",help:"help.plane.slope",least:-30,most:30,step:.5,logarithmic:!1,degrees:!0,allowed:{least:-1.57,most:1.57,
also:[]}},{path:"plane.gravity",label:"parameter.plane.gravity",symbol:"g",unit:"m/s²",help:"help.plane.gravity",least:0,most:25,step:.01,logarithmic:!1,degrees:!1,
allowed:{least:1e-6,most:1e6,also:[0]}},{path:"plane.restitution",label:"parameter.plane.restitution",symbol:"e",unit:"",help:"help.plane.restitution",least:0,most:1,
step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}},{path:"plane.rolling_resistance",label:"parameter.plane.rolling_resistance",symbol:"f",unit:"",
help:"help.plane.rolling_resistance",least:0,most:.2,step:.001,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}}],start:[{path:"start.speed",label:"pa\
rameter.start.speed",symbol:"v₀",unit:"m/s",help:"help.start.speed",least:-6,most:6,step:.01,logarithmic:!1,degrees:!1,allowed:{least:-1e6,most:1e6,also:[]}},
{path:"start.angle",label:"parameter.start.angle",symbol:"θ₀",unit:"°",help:"help.start.angle",least:-180,most:180,step:.5,logarithmic:!1,degrees:!0,allowed:{
least:-1e6,most:1e6,also:[]}},{path:"start.height",label:"parameter.start.height",symbol:"y₀",unit:"m",help:"help.start.height",least:0,most:2,step:.01,logarithmic:!1,
degrees:!1,allowed:{least:0,most:1e6,also:[]}},{path:"start.vx",label:"parameter.start.vx",symbol:"ẋ₀",unit:"m/s",help:"help.start.vx",least:-8,most:8,step:.01,
logarithmic:!1,degrees:!1,allowed:{least:-1e6,most:1e6,also:[]}},{path:"start.vy",label:"parameter.start.vy",symbol:"ẏ₀",unit:"m/s",help:"help.start.vy",least:-5,
most:5,step:.01,logarithmic:!1,degrees:!1,allowed:{least:-1e6,most:1e6,also:[]}},{path:"start.omega",label:"parameter.start.omega",symbol:"θ̇₀",unit:"rad/s",
help:"help.start.omega",least:-15,most:15,step:.05,logarithmic:!1,degrees:!1,allowed:{least:-1e9,most:1e9,also:[]}}],contact:[{path:"contact.stiffness",label:"p\
arameter.contact.stiffness",symbol:"k",unit:"N/m",help:"help.contact.stiffness",least:100,most:1e8,step:0,logarithmic:!0,degrees:!1,allowed:{least:1e-6,most:1e18,
also:[]}},{path:"contact.slip_speed",label:"parameter.contact.slip_speed",symbol:"vₛ",unit:"m/s",help:"help.contact.slip_speed",least:1e-7,most:.1,step:0,logarithmic:!0,
degrees:!1,allowed:{least:1e-12,most:1e6,also:[]}},{path:"contact.restitution",label:"parameter.contact.restitution",symbol:"e",unit:"",help:"help.contact.resti\
tution",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}}],motion:[{path:"duration",label:"parameter.duration",symbol:"T",unit:"\
s",help:"help.duration",least:.5,most:30,step:.5,logarithmic:!1,degrees:!1,allowed:{least:1e-9,most:1e9,also:[]}}]},choices:[{path:"plane.impact_law",label:"par\
ameter.plane.impact_law",options:[["stronge","choice.plane.impact_law.stronge"],["poisson","choice.plane.impact_law.poisson"],["newton","choice.plane.impact_law\
.newton"]],help:"help.plane.impact_law"},{path:"plane.painleve",label:"parameter.plane.painleve",options:[["flight","choice.plane.painleve.flight"],["impact","c\
hoice.plane.painleve.impact"]],help:"help.plane.painleve"},{path:"contact.model",label:"parameter.contact.model",options:[["rigid","choice.contact.model.rigid"],
["compliant","choice.contact.model.compliant"]],help:"help.contact.model"},{path:"contact.law",label:"parameter.contact.law",options:[["kelvin-voigt","choice.co\
ntact.law.kelvin-voigt"],["hunt-crossley","choice.contact.law.hunt-crossley"]],help:"help.contact.law"},{path:"contact.friction",label:"parameter.contact.fricti\
on",options:[["tanh","choice.contact.friction.tanh"],["linear","choice.contact.friction.linear"],["bristle","choice.contact.friction.bristle"]],help:"help.conta\
ct.friction"}],gravities:[["gravity.earth",9.81],["gravity.moon",1.62],["gravity.mars",3.71],["gravity.jupiter",24.79],["gravity.weightless",0]],map_axes:[{path:"\
start.speed",label:"axis.start.speed",unit:"m/s",degrees:!1,range:[0,5],allowed:[-1e6,1e6]},{path:"start.angle",label:"axis.start.angle",unit:"°",degrees:!0,range:[
-3.141592653589793,3.141592653589793],allowed:[-1e6,1e6]},{path:"start.vx",label:"axis.start.vx",unit:"m/s",degrees:!1,range:[-6,6],allowed:[-1e6,1e6]},{path:"s\
tart.omega",label:"axis.start.omega",unit:"rad/s",degrees:!1,range:[-8,8],allowed:[-1e9,1e9]},{path:"start.height",label:"axis.start.height",unit:"m",degrees:!1,
range:[0,1],allowed:[0,1e6]},{path:"hoop.load_fraction",label:"axis.hoop.load_fraction",unit:"",degrees:!1,range:[.05,.99],allowed:[0,1]},{path:"hoop.eccentrici\
ty",label:"axis.hoop.eccentricity",unit:"",degrees:!1,range:[.05,.95],allowed:[0,1]},{path:"hoop.inertia_ratio",label:"axis.hoop.inertia_ratio",unit:"",degrees:!1,
range:[.05,1],allowed:[0,1e6]},{path:"hoop.radius",label:"axis.hoop.radius",unit:"m",degrees:!1,range:[.1,2],allowed:[1e-6,1e6]},{path:"plane.mu",label:"axis.pl\
ane.mu",unit:"",degrees:!1,range:[0,1.5],allowed:[0,1e6]},{path:"plane.slope",label:"axis.plane.slope",unit:"°",degrees:!0,range:[-.35,.35],allowed:[-1.57,1.57]},
{path:"plane.gravity",label:"axis.plane.gravity",unit:"m/s²",degrees:!1,range:[1,20],allowed:[0,1e6]},{path:"plane.restitution",label:"axis.plane.restitution",
unit:"",degrees:!1,range:[0,1],allowed:[0,1]},{path:"plane.rolling_resistance",label:"axis.plane.rolling_resistance",unit:"",degrees:!1,range:[0,.1],allowed:[0,
1]}]},map_quantities:[["sequence","quantity.sequence"],["hop_height","quantity.hop_height"],["takeoff_angle","quantity.takeoff_angle"],["flight_time","quantity.\
flight_time"],["greatest_utilization","quantity.greatest_utilization"],["energy_lost","quantity.energy_lost"],["end_angle","quantity.end_angle"],["painleve","qu\
antity.painleve"],["ending","quantity.ending"]],presets:[{key:"hop",group:"examples.article",title:"example.hop",text:"example.hop.text",query:"duration=3"},{key:"\
slip",group:"examples.article",title:"example.slip",text:"example.slip.text",query:"duration=4&start.speed=2.8"},{key:"roll",group:"examples.article",title:"exa\
mple.roll",text:"example.roll.text",query:"duration=3.4&start.speed=2"},{key:"slow",group:"examples.article",title:"example.slow",text:"example.slow.text",query:"\
start.speed=0.1"},{key:"slippery",group:"examples.article",title:"example.slippery",text:"example.slippery.text",query:"duration=15&plane.mu=0.3&start.speed=0.1"},
{key:"littlewood",group:"examples.littlewood",title:"example.littlewood",text:"example.littlewood.text",query:"duration=3&hoop.load_fraction=1&start.speed=0.1"},
{key:"littlewood-fast",group:"examples.littlewood",title:"example.littlewood-fast",text:"example.littlewood-fast.text",query:"duration=3&hoop.load_fraction=1&st\
art.speed=2"},{key:"nearly-massless",group:"examples.littlewood",title:"example.nearly-massless",text:"example.nearly-massless.text",query:"hoop.load_fraction=0\
.99&start.speed=0.1"},{key:"inconsistent",group:"examples.paradoxes",title:"example.inconsistent",text:"example.inconsistent.text",query:"duration=3&plane.mu=1.\
2&start.angle=-0.7&start.vx=3&start.omega=1"},{key:"indeterminate",group:"examples.paradoxes",title:"example.indeterminate",text:"example.indeterminate.text",query:"\
duration=3&plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5"},{key:"jam",group:"examples.paradoxes",title:"example.jam",text:"example.jam.text",query:"dur\
ation=3&hoop.load_fraction=0.9&start.angle=5.14&start.vx=23&start.omega=5.6"},{key:"kane",group:"examples.paradoxes",title:"example.kane",text:"example.kane.tex\
t",query:"duration=1.5&plane.mu=0.6&plane.restitution=0.8&plane.impact_law=newton&start.height=0.3&start.angle=1.45&start.vx=2.16&start.omega=-6.44"},{key:"down\
hill",group:"examples.more",title:"example.downhill",text:"example.downhill.text",query:"duration=5&plane.slope=0.17453292519943295&plane.mu=0.8&start.speed=1.5"},
{key:"bounces",group:"examples.more",title:"example.bounces",text:"example.bounces.text",query:"duration=4&plane.mu=0.4&plane.restitution=0.5&start.height=0.5&s\
tart.angle=0.4&start.vx=0.2&start.omega=2"},{key:"moon",group:"examples.more",title:"example.moon",text:"example.moon.text",query:"duration=15&plane.gravity=1.6\
2&start.speed=1.2597509583501894"}],colors:{modes:{R:"#0072B2",S:"#E69F00",K:"#CC79A7",H:"#D55E00",M:"#F0E442"},mode_names:{R:"mode.roll",S:"mode.spin",K:"mode.\
skid",H:"mode.flight",M:"mode.skim"},gravity_center:"#009E73",airborne:"#CC1F1A",center_speed:"#000000",rotation_speed:"#00857A",kinetic:"#1B3A78",potential:"#6\
67300",friction_loss:"#8F3B0A",impact_loss:"#8E1B5F",normal_force:"#5B3FA8",friction_force:"#8F3B0A",limit:"#6E6E6E"}},fingerprints:{hop:"85b1751f991ff2a3",slip:"\
e4f784b57d9527de",roll:"67a142a154835aa6",slow:"915956aa4dd065c8",slippery:"1a8ae06b20c63390",littlewood:"f722b9a4b8757b9d","littlewood-fast":"d43e0434fa7cbae3",
"nearly-massless":"147fe27d9b5619a0",inconsistent:"feb302b6289b4311",indeterminate:"0578ec5304f707df",jam:"eafe27173f21f089",kane:"700bd2b728523ae1",downhill:"d\
5a475e54711f966",bounces:"c6734bd1e0f9fa98",moon:"6ec3efb6023122ba"},schema:"hophoop/1",scenario:{sections:{hoop:["Hoop"],plane:["Plane"],start:["Start"],contact:[
"Rigid","Compliant"]},models:{Scenario:{place:"",fields:{duration:{kind:"number",unit:"s",default:6,limits:[["greater_than",0]],range:{least:1e-9,most:1e9,unit:"\
s"}},hoop:{kind:"section",unit:""},plane:{kind:"section",unit:""},start:{kind:"section",unit:""},contact:{kind:"section",unit:""}}},Hoop:{place:"hoop.",fields:{
radius:{kind:"number",unit:"m",default:1,limits:[["greater_than",0]],range:{least:1e-6,most:1e6,unit:"m"}},mass:{kind:"number",unit:"kg",default:1,limits:[["gre\
ater_than",0]],range:{least:1e-12,most:1e12,unit:"kg"}},load_fraction:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than_equal",0],["less_t\
han_equal",1]]},eccentricity:{kind:"number",unit:"1",default:.75,limits:[["greater_than_equal",0],["less_than_equal",1]]},inertia_ratio:{kind:"number",unit:"1",
default:.4375,limits:[["greater_than_equal",0]],range:{least:1e-12,most:1e6,also:[0]}},parts:{kind:"parts",unit:"",nullable:!0,default:null}}},Plane:{place:"pla\
ne.",fields:{gravity:{kind:"number",unit:"m/s²",default:9.81,limits:[["greater_than_equal",0]],range:{least:1e-6,most:1e6,unit:"m/s²",also:[0]}},slope:{kind:"\
number",unit:"rad",default:0},mu:{kind:"friction",unit:"1",nullable:!0,default:null,range:{least:0,most:1e6,also:["inf"]}},mu_static:{kind:"friction",unit:"1",default:1,
range:{least:0,most:1e6,also:["inf"]}},mu_kinetic:{kind:"friction",unit:"1",default:1,range:{least:0,most:1e6,also:["inf"]}},restitution:{kind:"number",unit:"1",
default:0,limits:[["greater_than_equal",0],["less_than_equal",1]]},impact_law:{kind:"word",unit:"",default:"stronge",options:["stronge","newton","poisson"]},painleve:{
kind:"word",unit:"",default:"flight",options:["flight","impact"]},rolling_resistance:{kind:"number",unit:"1",default:0,limits:[["greater_than_equal",0],["less_t\
han_equal",1]]}}},Start:{place:"start.",fields:{x:{kind:"number",unit:"m",default:0,range:{least:-1e9,most:1e9,unit:"m"}},height:{kind:"number",unit:"m",default:0,
limits:[["greater_than_equal",0]],range:{least:0,most:1e6,unit:"m"}},angle:{kind:"number",unit:"rad",default:0,range:{least:-1e6,most:1e6,unit:"rad"}},speed:{kind:"\
number",unit:"m/s",nullable:!0,default:null,range:{least:-1e6,most:1e6,unit:"m/s"}},vx:{kind:"number",unit:"m/s",default:0,range:{least:-1e6,most:1e6,unit:"m/s"}},
vy:{kind:"number",unit:"m/s",default:0,range:{least:-1e6,most:1e6,unit:"m/s"}},omega:{kind:"number",unit:"rad/s",nullable:!0,default:0,range:{least:-1e9,most:1e9,
unit:"rad/s"}}}},Rigid:{place:"contact.",fields:{model:{kind:"word",unit:"",default:"rigid",options:["rigid"]},max_events:{kind:"whole",unit:"1",default:1e5,limits:[
["greater_than_equal",1],["less_than_equal",1e7]]}}},Compliant:{place:"contact.",fields:{model:{kind:"word",unit:"",default:"compliant",options:["compliant"]},stiffness:{
kind:"number",unit:"N/m",nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-6,most:1e18,unit:"N/m"}},damping:{kind:"number",unit:"N s/m or s/m",
nullable:!0,default:null,limits:[["greater_than_equal",0]],range:{least:0,most:1e12}},restitution:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["gre\
ater_than_equal",0],["less_than_equal",1]]},law:{kind:"word",unit:"",default:"kelvin-voigt",options:["kelvin-voigt","hunt-crossley"]},friction:{kind:"word",unit:"",
default:"tanh",options:["tanh","linear","bristle"]},slip_speed:{kind:"number",unit:"m/s",nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-12,
most:1e6,unit:"m/s"}},tangential_stiffness:{kind:"number",unit:"N/m",nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-6,most:1e18,unit:"N/m"}},
rtol:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-10,most:.1}},max_events:{kind:"whole",unit:"1",default:1e5,limits:[
["greater_than_equal",1],["less_than_equal",1e7]]}}},Ring:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"ring",options:["ring"]},mass:{kind:"\
number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,unit:"kg"}},inner_radius:{kind:"number",unit:"m",required:!0,limits:[["gr\
eater_than_equal",0]]},outer_radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,unit:"m"}}}},Disk:{place:"hoop.p\
arts: ",fields:{shape:{kind:"word",unit:"",default:"disk",options:["disk"]},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,
most:1e12,unit:"kg"}},radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,unit:"m"}},at:{kind:"number",unit:"m",default:0}}},
PointMass:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"point_mass",options:["point_mass"]},mass:{kind:"number",unit:"kg",required:!0,limits:[
["greater_than",0]],range:{least:1e-12,most:1e12,unit:"kg"}},at:{kind:"number",unit:"m",required:!0}}},Rod:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",
default:"rod",options:["rod"]},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,unit:"kg"}},length:{kind:"numb\
er",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,unit:"m"}},at:{kind:"number",unit:"m",default:0},direction:{kind:"word",unit:"",
default:"radial",options:["radial","tangential"]}}}},parts:{ring:"Ring",disk:"Disk",point_mass:"PointMass",rod:"Rod"},ends:{"hoop.load_fraction":["eccentricity",
"inertia_ratio","parts"],"hoop.eccentricity":["load_fraction","parts"],"hoop.inertia_ratio":["load_fraction","parts"],"hoop.parts":["load_fraction","eccentricit\
y","inertia_ratio","mass"],"plane.mu":["mu_static","mu_kinetic"],"plane.mu_static":["mu"],"plane.mu_kinetic":["mu"],"start.speed":["height","vx","vy","omega"],"\
start.height":["speed"],"start.vx":["speed"],"start.vy":["speed"],"start.omega":["speed"],"contact.damping":["restitution"],"contact.restitution":["damping"]},left_out:{
rolling_resistance:0},rules:[null,{sentence:"hoop_mass",values:{mass:"hoop.mass"},known:{words:{least:1e-12,most:1e12,unit:"kg"}},number:""},{sentence:"load_ine\
rtia",values:{load_fraction:"hoop.load_fraction",inertia_ratio:"hoop.inertia_ratio"},known:{words:{least:1e-12,most:1e6,also:[0]}},number:""},{sentence:"parts_i\
nertia",values:{inertia_ratio:"hoop.inertia_ratio"},known:{words:{least:1e-12,most:1e6,also:[0]}},number:""},{sentence:"massless_eccentricity",values:{eccentricity:"\
hoop.eccentricity"},known:{},number:""},{sentence:"kinetic_above_static",values:{mu_kinetic:"plane.mu_kinetic",mu_static:"plane.mu_static"},known:{},number:""},
{sentence:"vertical",values:{slope:"plane.slope"},known:{},number:""},{sentence:"slope",values:{slope:"plane.slope"},known:{words:{least:-1.57,most:1.57,unit:"r\
ad"}},number:""},{sentence:"massless_slope",values:{slope:"plane.slope"},known:{},number:""},{sentence:"massless_resistance",values:{given:"plane.rolling_resist\
ance"},known:{},number:""},{sentence:"resistance",values:{given:"plane.rolling_resistance"},known:{},number:"most"},{sentence:"massless_compliant",values:{},known:{},
number:""},{sentence:"compliant_friction",values:{},known:{},number:""},{sentence:"relative_contact",values:{value:"contact.stiffness"},known:{name:"stiffness",
unit:"m g/R",words:{least:.01,most:1e15}},number:"relative"},{sentence:"relative_contact",values:{value:"contact.tangential_stiffness"},known:{name:"tangential_\
stiffness",unit:"m g/R",words:{least:.01,most:1e15}},number:"relative"},{sentence:"relative_contact",values:{value:"contact.slip_speed"},known:{name:"slip_speed",
unit:"√(g R)",words:{least:1e-12,most:1e6}},number:"relative"},{sentence:"too_soft",values:{stiffness:"contact.stiffness"},known:{most:100},number:"depth"}],touch:1e-12,
default:{duration:6,hoop:{radius:1,mass:1,load_fraction:.75},plane:{gravity:9.81,slope:0,mu:1,restitution:0,impact_law:"stronge",painleve:"flight"},start:{x:0,angle:0,
speed:3.1},contact:{model:"rigid",max_events:1e5}}},texts:{unknown_key:"{path}{hint}",did_you_mean:"{close}",known_are:"{known}",missing:"{path}",together:"{sec\
tion}{other}{section}{way}",finding:"{path}{shown}{allowed}",number:"",friction:"",whole:"",finite_number:"",greater_than:"{limit:g}",greater_than_equal:"{limit\
:g}",less_than:"{limit:g}",less_than_equal:"{limit:g}",range:"{words}",literal_error:"{expected}",table:"",list:"",word:"",other_problem:"{first}{count}",other_problems:"\
{first}{count}",whole_scenario:"",no_parts:"",half_a_hoop:"{missing}{given}",massless_eccentricity:"{eccentricity!r}",hoop_mass:"{mass!r}{words}",parts_inertia:"\
{inertia_ratio!r}{words}",load_inertia:"{load_fraction!r}{inertia_ratio!r}{words}",ring_radii:"{inner!r}{outer!r}",beyond_the_rim:"{index}{shape}{reach!r}{radiu\
s!r}",kinetic_above_static:"{mu_kinetic!r}{mu_static!r}",vertical:"{slope!r}",slope:"{slope!r}{words}",no_omega:"",massless_slope:"{slope!r}",massless_resistance:"\
{given!r}",resistance:"{given!r}{most:.6g}",massless_compliant:"",compliant_friction:"",relative_contact:"{name}{value!r}{relative:.3g}{unit}{words}",too_soft:"\
{stiffness!r}{depth:.0e}{most:g}",no_parameter:"{path}{known}",no_section_parts:"{path}{section}",two_ways:"{one}{one_value!r}{other}{other_value!r}",not_there:"\
{path}{step!r}",unreadable_query:"{reason}",value_above:"{path}{above}",given_twice:"{path}",parts_out_of_order:"{name}"},words:{letters:"RSKHM",modes:["roll","\
spin","skid","flight","skim"],summed_up:["start","slip_start","stick","slip_reversal","takeoff","impact","bounce_limit","painleve_inconsistent","painleve_indete\
rminate","jam","kane_gain","skim","rest"],signs:{jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",
rest:"■",takeoff:"▲",impact:"▼",turn:"↺",apex:"•"},least_speed:1e-9},classes:{codes:{hop:{no:"#D9D9D9",yes:"#D55E00"},painleve:{no:"#D9D9D9",yes:"#000\
000"},ending:{duration:"#6E6E6E",revolutions:"#0072B2",reversal:"#009E73",takeoff:"#D55E00",rest:"#56B4E9",jam:"#000000",undetermined:"#F0E442",event_limit:"#CC\
79A7"},status:{completed:"#0072B2",at_rest:"#56B4E9",jammed:"#000000",undetermined:"#F0E442",event_limit:"#CC79A7"},first_event:{slip_start:"#E69F00",stick:"#00\
72B2",slip_reversal:"#CC79A7",takeoff:"#D55E00",impact:"#F0E442",turn:"#009E73",jam:"#000000",rest:"#D9D9D9",end:"#56B4E9"}},families:{SR:"#009966",SS:"#9E9D24",
SK:"#CCCC99",KR:"#663300",KS:"#1A1A40",KK:"#3366FF"},massless:{rolls:"#9E9D24","rolls, slips":"#663300","":"#009966",slips:"#332288"},hops:"#332288",rolls:"#66C\
CCC",other:"#6E6E6E"},map:{events:2e3,flight_turns:2e3,allowed:{"hoop.load_fraction":{least:0,most:1},"hoop.eccentricity":{least:0,most:1},"hoop.inertia_ratio":{
least:1e-12,most:1e6,also:[0]},"hoop.radius":{least:1e-6,most:1e6},"hoop.mass":{least:1e-12,most:1e12},"plane.mu":{least:0,most:1e6,also:["inf"]},"plane.mu_stat\
ic":{least:0,most:1e6,also:["inf"]},"plane.mu_kinetic":{least:0,most:1e6,also:["inf"]},"plane.slope":{least:-1.57,most:1.57},"plane.gravity":{least:1e-6,most:1e6,
also:[0]},"plane.restitution":{least:0,most:1},"plane.rolling_resistance":{least:0,most:1},"start.speed":{least:-1e6,most:1e6},"start.angle":{least:-1e6,most:1e6},
"start.x":{least:-1e9,most:1e9},"start.height":{least:0,most:1e6},"start.vx":{least:-1e6,most:1e6},"start.vy":{least:-1e6,most:1e6},"start.omega":{least:-1e9,most:1e9},
duration:{least:1e-9,most:1e9},"contact.stiffness":{least:1e-6,most:1e18},"contact.slip_speed":{least:1e-12,most:1e6},"contact.restitution":{least:0,most:1},"co\
ntact.damping":{least:0,most:1e12},"contact.tangential_stiffness":{least:1e-6,most:1e18},"contact.rtol":{least:1e-10,most:.1},"contact.max_events":{least:1,most:1e7},
"hoop.parts.mass":{least:1e-12,most:1e12},"hoop.parts.length":{least:1e-12,most:1e6}},rates:{"hoop.eccentricity":"eccentricity","hoop.inertia_ratio":"inertia_ra\
tio","hoop.radius":"radius","hoop.mass":"mass","plane.mu_static":"mu_static","plane.mu_kinetic":"mu_kinetic","plane.slope":"slope","plane.gravity":"gravity","pl\
ane.restitution":"restitution","plane.rolling_resistance":"rolling_resistance","start.angle":"angle","start.x":"x","start.height":"height","start.vy":"vy","star\
t.omega":"omega",duration:"duration"},quantities:{sequence:{span:"first_revolution",unit:"",words:[]},hop_height:{span:"takeoff",unit:"m",words:[]},takeoff_angle:{
span:"takeoff",unit:"rad",words:[]},flight_time:{span:"takeoff",unit:"s",words:[]},greatest_utilization:{span:"first_revolution",unit:"1",words:[]},energy_lost:{
span:"duration",unit:"J",words:[]},end_angle:{span:"duration",unit:"rad",words:[]},painleve:{span:"duration",unit:"",words:["no","yes"]},ending:{span:"duration",
unit:"",words:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"]}}},lab:{too_long:"{duration:g}{most:g}",too_many_parts:"\
{parts}{most}",too_many_turns:"{duration:g}{turns:.0e}{most:.0e}",too_stiff:"{steps:.3g}{most:g}",too_many_changes:"{pairs}{most}",too_many_cells:"{cells}{most}",
equal_axes:"{path!r}",two_axes:"{one}{other}",rigid_maps:"",cell_turns:"{turns:.0e}{most:.0e}",map_turns:"{cells}{turns:.2g}{most:.0e}",doubt:"{time}",compliant_changes:"",
not_a_pair:"{change}",film_too_long:"{duration:g}{most:g}",window:"",times:"",number_path:"",one_of:"{known}"},limits:{duration:600,events:2e4,parts:64,samples:20001,
cells:65536,turns:2e5,map_turns:4e6,steps:3e6,changes:200,film:20},table:{rate:200,variables:{mode:"1",x:"m",height:"m",angle:"rad",vx:"m/s",vy:"m/s",omega:"rad\
/s",slip:"m/s",friction_force:"N",normal_force:"N",kinetic:"J",potential:"J",total:"J",friction:"J",impact_normal:"J",impact_tangential:"J",rolling_resistance:"\
J",spring:"J",damping:"J"}},shown:["hoop.load_fraction","hoop.eccentricity","hoop.inertia_ratio","hoop.radius","hoop.mass","plane.mu","plane.mu_static","plane.m\
u_kinetic","plane.slope","plane.gravity","plane.restitution","plane.rolling_resistance","start.speed","start.angle","start.height","start.vx","start.vy","start.\
omega"]};var E=yo,be=n=>n==="inf"?1/0:n;var{codes:th,families:eh,massless:sh,hops:nh,rolls:ih,other:oh}=E.classes,wo="sequence",rh=n=>[...n].reduce((t,e)=>(131*t+e.charCodeAt(0))%997,0)/997;function vo(n,t){
if(t!==wo)return th[t]?.[n]??oh;let e=/[SK]/.exec(n)?.[0]??"R",s=[n.startsWith("R")&&"rolls",/[SK]/.test(n)&&"slips"].filter(Boolean).join(", "),i=n.endsWith("H")?
nh:eh[e+n.slice(-1)]??ih,o=n.includes("M")?sh[s]:i,r=[1,3,5].map(d=>Number.parseInt(o.slice(d,d+2),16)/255),a=(r[0]+r[1]+r[2])/3,l=Math.min(n.length-1,9)/9,c=.2*
rh(n),m=.62-.62*Math.min(2*l,1),h=Math.max(2*l-1,0)*.5;return`#${r.map(d=>{let f=(1-c)*d+c*a;return Math.round(255*(f+(1-f)*m)*(1-h)).toString(16).padStart(2,"0")}).
join("")}`}function xo(n,t){if(t!==wo)return`class.${n}`;let{letters:e,modes:s}=E.words;return[...n].map(o=>o==="+"?"…":`mode.${s[e.indexOf(o)]}`).flatMap((o,r)=>r?
[" → ",o]:[o])}function tt({duration:n,hoop:t,plane:e,start:s,contact:i}){let{radius:o,mass:r,eccentricity:a,inertia_ratio:l}=t,{mu:c,apart:m,...h}=e,{x:p,height:d,angle:f,vx:g,
vy:_,omega:b,slip:y}=vt(s,o),{max_events:w,model:k,...T}=i;return{radius:o,mass:r,eccentricity:a,inertia_ratio:l,ideal:t.load_fraction!==null,...h,x:p,height:d,
angle:f,vx:g,vy:_,omega:b,slip:y,rolling:s.speed!==null,duration:n,max_events:w,contact:k==="rigid"?null:T}}function vt({x:n,height:t,angle:e,speed:s,vx:i,vy:o,
omega:r},a){let l=s===null?Number(r):s/a;return{x:n,height:t,angle:e,vx:i,vy:o,omega:l,slip:s===null?i-a*l:0}}Ht();var ph=/^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i,dh=/^\s*([+-]?)(inf|infinity|nan)\s*$/i;function Lt(n){return Number.isNaN(n)?"nan":String(n).replace("Infi\
nity","inf")}var Mn=n=>Lt(n).replace(/^-?\d+$/,"$&.0");function lt(n,t=6){if(!Number.isFinite(n))return Lt(n);let e=n!==0&&Math.abs(n)<1e-4,[s,...i]=(e?n.toExponential(
t-1):n.toPrecision(t)).split("e");return[s.includes(".")?s.replace(/\.?0+$/,""):s,...i].join("e")}var En=(n,t)=>Number.isFinite(n)?n.toFixed(t):Lt(n),fh={g:(n,t)=>lt(
n,t||6),e:(n,t)=>n.toExponential(t),f:En};function ts(n,t){let s=[...n.matchAll(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g)].map(([,i,o,r,a])=>{let l=t[i];return a?
[i,fh[a](l,Number(r))]:l?.key||Array.isArray(l)||typeof l=="number"?[i,o?Qe(l):l]:[i,gh(o?Qe(l):String(l))]});return Object.fromEntries(s)}function Qe(n){return typeof n==
"number"?Lt(n):typeof n=="string"?Ze(`'${n}'`):n==null?"None":Ze(JSON.stringify(n))}var gh=n=>n.replace(/[\p{C}\p{Zl}\p{Zp}]/gu,t=>`\\u{${t.codePointAt(0)?.toString(
16)}}`);function Ze(n){let t=[...n];return t.length<=60?n:`${t.slice(0,57).join("")}...`}function Ao(n){if(ph.test(n))return Number(n);let[,t,e]=dh.exec(n)??[];
if(e)return e[0].toLowerCase()==="n"?Number.NaN:t==="-"?-1/0:1/0}var{texts:_h,scenario:Po}=E,bh=2,I=class extends rt{constructor(){super(...arguments);this.name="InputError"}},st=class extends I{},H=(n,t={})=>({key:`refusal.${n}`,
values:ts(_h[n],t)}),xt=n=>n!==null&&typeof n=="object"&&!Array.isArray(n),Vt=(n,t,e,s)=>H("finding",{path:n||H("whole_scenario"),shown:Qe(t),allowed:H(e,s)});function Sn(n,t,e,s){
let{fields:i,place:o}=Po.models[n],r=xt(t)?An(o,t,Object.keys(i)):Vt(e,t,"table");if(r&&s.push(r),r)return null;let a=s.length,l={};for(let[c,m]of Object.entries(
i))Object.hasOwn(t,c)?l[c]=Pn(m,t[c],`${e}.${c}`,s):m.required?s.push(H("missing",{path:`${e}.${c}`})):l[c]=be(m.default);return s.length===a?{values:l,given:new Set(
Object.keys(t))}:null}function An(n,t,e){let s=Object.keys(t).find(a=>!e.includes(a));if(s===void 0)return null;let[i]=[...e].sort((a,l)=>Tn(s,a)-Tn(s,l)),r=Tn(
s,i)<=bh?H("did_you_mean",{close:i}):H("known_are",{known:e.join(", ")});return H("unknown_key",{path:`${n}${Ze(s)}`,hint:r})}function Tn(n,t){let e=Array.from(
{length:t.length+1},(s,i)=>i);for(let[s,i]of[...n].entries()){let o=[s+1];for(let r=0;r<t.length;r++)o.push(Math.min(o[r]+1,e[r+1]+1,e[r]+ +(i!==t[r])));e=o}return e[t.
length]}function Pn(n,t,e,s){if(t===null&&n.nullable)return null;if(n.kind==="parts")return vh(t,e,s);let i=n.kind==="friction"&&t==="inf"?1/0:t,o=wh(n,i);return o&&
s.push(Vt(e,t,...o)),typeof i=="number"?i+0:i}var yh={greater_than:(n,t)=>n>t,greater_than_equal:(n,t)=>n>=t,less_than_equal:(n,t)=>n<=t};function wh(n,t){let{kind:e,
options:s,limits:i=[],range:o}=n;if(e==="word")return s.includes(t)?null:["literal_error",{expected:Lo(s)}];if(typeof t!="number")return["number"];if(e==="frict\
ion"&&!(t>=0))return["friction"];if(e==="whole"&&!Number.isInteger(t))return["whole"];if(e!=="friction"&&!Number.isFinite(t))return["finite_number"];let r=i.find(
([a,l])=>!yh[a](t,l));return r?[r[0],{limit:r[1]}]:o&&!Cn(o,t)?["range",{words:Ln(o)}]:null}function Ln({least:n,most:t,unit:e="",also:s=[]}){return{key:`range.${`${s.
includes(0)?"zero_or_":""}from_to${s.includes("inf")?"_or_inf":""}`}`,values:{least:lt(n),most:`${lt(t)}${e&&` ${e}`}`}}}function Lo(n){let t=n.map(e=>`'${e}'`);
return t.length===1?t:{key:"list.or",values:{some:at(t.slice(0,-1)),last:t[t.length-1]}}}var Cn=({least:n,most:t,also:e=[]},s)=>n<=s&&s<=t||e.some(i=>be(i)===s);
function vh(n,t,e){if(!Array.isArray(n))e.push(Vt(t,n,"list"));else return n.map((s,i)=>xh(s,`${t}.${i}`,e))}function xh(n,t,e){let s=Rn(n,"shape",Po.parts,t,e),
i=s&&Sn(s,n,t,e);if(!i)return null;let{inner_radius:o,outer_radius:r}=i.values;return o>r&&e.push(H("ring_radii",{inner:o,outer:r})),i.values}function Rn(n,t,e,s,i,o){
let r=xt(n)&&Object.hasOwn(n,t)?n[t]:o;if(!xt(n))i.push(Vt(s,n,"table"));else if(r===void 0)i.push(H("missing",{path:`${s}.${t}`}));else{if(typeof r=="string"&&
Object.hasOwn(e,r))return e[r];i.push(Vt(`${s}.${t}`,r,"literal_error",{expected:Lo(Object.keys(e))}))}return null}function On(n){let t=n.length-1;return t?{key:"\
refusal.other_problems",values:{first:()=>U(n[0]).replace(/[.。]$/,""),count:t}}:n[0]}var Ro=new Map(Object.entries(E.scenario.ends));function Fn(n){let[t,...e]=n.split(".");return[t,e.join(".")]}function ke(n){for(let t of n){let e=(Ro.get(t)??[]).
map(i=>`${Fn(t)[0]}.${i}`),s=n.find(i=>e.some(o=>i===o||i.startsWith(`${o}.`)));if(s!==void 0)return[t,s]}return null}function Co(n){let[t,e]=Fn(n);return(t==="\
start"?10:0)+(e===""?0:n==="contact.model"||n==="hoop.parts"?1:2)}function Oo(n,t,e,s){let i=[...e.keys()],o=ke(i);if(o){let[a,l]=o;throw new I(H("two_ways",{one:a,
other:l,one_value:e.get(a),other_value:e.get(l)}))}let r=new Set;for(let a of i.sort((l,c)=>Co(l)-Co(c))){let l=structuredClone(e.get(a)),[c,m]=Fn(a);if(m==="")
Nn(t,c,l);else if(a==="contact.model")t.contact={model:l};else{Object.hasOwn(t,c)||Nn(t,c,{});let h=t[c];if(!xt(h))throw new I(H("no_section_parts",{path:a,section:c}));
let p=Ro.get(a)??[];if(!r.has(c)&&p.some(d=>Object.hasOwn(h,d))){r.add(c);let d=e.has(c)?s(c,e.get(c)):n[c],f=kh(d,a,()=>s("hoop",t.hoop));for(let[g,_]of Object.
entries(f))e.has(`${c}.${g}`)||(h[g]=_)}for(let d of p)delete h[d];Mh(h,m.split("."),l,a)}}return t}var Nn=(n,t,e)=>Object.defineProperty(n,t,{value:e,enumerable:!0,
configurable:!0,writable:!0});function kh(n,t,e){let{mass:s,eccentricity:i,inertia_ratio:o,mu_static:r,mu_kinetic:a}=n;if(t==="hoop.load_fraction")return{mass:s};
if(t==="hoop.eccentricity"||t==="hoop.inertia_ratio")return{mass:s,eccentricity:i,inertia_ratio:o};if(t==="plane.mu_static"||t==="plane.mu_kinetic")return{mu_static:r,
mu_kinetic:a};if(!t.startsWith("start.")||t==="start.speed")return{};let{height:l,vx:c,vy:m,omega:h}=vt(n,e().radius);return{height:l,vx:c,vy:m,omega:h}}function Mh(n,t,e,s){
let i=n;for(let[o,r]of t.entries()){let a=o===t.length-1;if(!(Array.isArray(i)&&/^\d+$/.test(r)&&Number(r)<i.length)&&!(xt(i)&&(a||Object.hasOwn(i,r))))throw new I(
H("not_there",{path:s,step:r}));a?Nn(i,r,e):i=i[r]}}var{lab:Eh,limits:W}=E,{allowed:No,events:Th,flight_turns:Sh,quantities:Ah}=E.map,Ph=1e-300,G=(n,t={})=>({key:`lab.${n}`,values:ts(Eh[n],t)}),In=n=>G("doubt",{time:lt(
n,4)});function Ct(n){let{duration:t,hoop:e,contact:s}=n;if(t>W.duration)throw new st(G("too_long",{duration:t,most:W.duration}));let i=e.parts?.length??0;if(i>
W.parts)throw new st(G("too_many_parts",{parts:i,most:W.parts}));let o=$o(Ho(n));if(o>W.turns)throw new st(G("too_many_turns",{duration:t,turns:o,most:W.turns}));
if(s.model==="compliant"){let r=Lh(n,o);if(r>W.steps)throw new st(G("too_stiff",{steps:r/1e6,most:W.steps/1e6}))}return s.max_events<=W.events?n:{...n,contact:{
...s,max_events:W.events}}}function Hn({duration:n}){if(n>W.film)throw new st(G("film_too_long",{duration:n,most:W.film}))}function Ho({duration:n,hoop:{radius:t},
plane:{gravity:e,slope:s},start:i}){let{height:o,vx:r,vy:a,omega:l}=vt(i,t);return{duration:n,radius:t,gravity:e,slope:s,height:o,vx:r,vy:a,omega:l}}function $o({
duration:n,radius:t,gravity:e,slope:s,height:i,vx:o,vy:r,omega:a}){return(2*(Math.abs(o)+Math.abs(r)+t*Math.abs(a)+2*Math.sqrt(e*(t+i)))+.5*e*Math.min(Math.abs(
s),1)*n)*n/(2*Math.PI*t)}function Lh({duration:n,hoop:{radius:t,mass:e},plane:{gravity:s},contact:{stiffness:i}},o){let a=10/Math.sqrt(t/(s>0?s:1))+(i===null?0:
Math.sqrt(i/e));return 10*n*a+40*o}function $n(n,{x:t,y:e,what:s}){if(n.contact.model!=="rigid")throw new I(G("rigid_maps"));let{contact:i,...o}=Ct(n),r={...o,contact:{
...i,max_events:Math.min(i.max_events,Th)}};Ch(r,t,e,Ah[s].span);let a=ke([e.path,t.path]);if(a)throw new I(G("two_axes",{one:a[0],other:a[1]}));return r}function Ch(n,t,e,s){
let i=Ho(n),o=s==="first_revolution",r=Me(t).filter(h=>Io(t.path,h)),a=Me(e).filter(h=>Io(e.path,h)),[l,c]=[0,0];for(let h of a)for(let p of r){let d=Fo(Fo(i,e.
path,h),t.path,p),g=o?1+Math.min(d.vx*d.vx/(10*i.gravity*i.radius+Ph),Sh):$o(d);l+=g,c=Math.max(c,g)}if(!o&&c>W.turns)throw new st(G("cell_turns",{turns:c,most:W.
turns}));if(l<=W.map_turns)return;let m=r.length*a.length;throw new st(G("map_turns",{cells:m,turns:l,most:W.map_turns}))}function Fo(n,t,e){if(t==="start.speed")
return{...n,vx:e,vy:0,omega:0};let s=t.slice(t.lastIndexOf(".")+1);return s in n&&s!=="height"?{...n,[s]:e}:n}var Me=({from:n,to:t,cells:e})=>Array.from({length:e},
(s,i)=>n+(i+.5)*((t-n)/e));function Io(n,t){return!No[n]||Cn(No[n],t)}var Rh=1e3;function Do(n){let t=n.replace(/^\?/,"");if(t.split("&").length>Rh)throw new I(H("unreadable_query",{reason:"Max number of fields exceeded"}));let e=new Map;
for(let[o,r]of new URLSearchParams(`&${t}`)){let a=o.split("."),l=a.pop(),c=e;for(let m of a)if(c.has(m)||c.set(m,new Map),c=c.get(m),!(c instanceof Map))throw new I(
H("value_above",{path:o,above:o.replace(/\.[^.]*$/,"")}));if(c.has(l))throw new I(H("given_twice",{path:o}));c.set(l,Ao(r)??r)}let s=e.get("hoop"),i=s instanceof
Map&&s.get("parts");return i instanceof Map&&s.set("parts",Oh(i)),Dn(e)}function Oh(n){let t=Array.from({length:n.size},(s,i)=>String(i)),e=[...n.keys()].find(s=>!t.
includes(s));if(e!==void 0)throw new I(H("parts_out_of_order",{name:e}));return t.map(s=>n.get(s))}function Dn(n){return Array.isArray(n)?n.map(Dn):n instanceof
Map?Object.fromEntries([...n].map(([t,e])=>[t,Dn(e)])):n}function jn(n,t=""){return typeof n=="string"?`${t}=${n}`:typeof n=="number"?`${t}=${Lt(n).replace("e+",
"e")}`:Object.entries(n).map(([e,s])=>jn(s,t?`${t}.${e}`:e)).join("&")}var{scenario:qn}=E,Nh=qn.rules,Fh=["load_fraction","eccentricity","inertia_ratio"],jo=["mu_static","mu_kinetic"],Ih=["height","vx","vy","omega"],qo={mass:1,inertia_ratio:1,
contact:null};function ss(n,t,e){let[s,i]=e.refused(n),o=Nh[s];if(!o)return null;let r=Object.entries(o.values).map(([c,m])=>{let[h,p]=m.split(".");return[c,t[h][p]]}),
{words:a,...l}=o.known;return a&&(l.words=Ln(a)),H(o.sentence,{...l,...Object.fromEntries(r),[o.number]:i})}function es(n,t,e,s){let i=s.find(o=>e.has(o));return i?
H("together",{section:n,other:i,way:t}):null}var Bo={hoop:Hh,plane:$h,start:Dh,contact:jh};function Hh(n,t,e){let s=Fh.filter(i=>t.has(i)&&n[i]!==null);if(n.parts){
let i=n.parts.length?es("hoop","parts",t,[...s,"mass"]):H("no_parts");if(i)return i;let{radius:o,parts:r}=n,{reaches:a,...l}=e.combine(o,r),c=a.findIndex(m=>m>o*
(1+qn.touch));if(c>=0)return H("beyond_the_rim",{index:c,shape:r[c].shape,reach:a[c],radius:o});Object.assign(n,l)}else if(n.load_fraction!==null||!s.length){let i=es(
"hoop","load_fraction",t,s.slice(+(n.load_fraction!==null)));if(i)return i;n.load_fraction??=qn.models.Hoop.fields.eccentricity.default,n.eccentricity=n.load_fraction,
n.inertia_ratio=e.ideal(n.load_fraction)}else if(s.length===1){let i=s[0]==="eccentricity"?"inertia_ratio":"eccentricity";return H("half_a_hoop",{missing:i,given:s[0]})}
return ss({...qo,...n,ideal:n.load_fraction!==null},{hoop:n},e)}function $h(n,t,e){if(n.apart=jo.some(s=>t.has(s)),n.mu!==null){let s=es("plane","mu",t,jo);if(s)
return s;n.mu_static=n.mu_kinetic=n.mu}else n.mu_static===n.mu_kinetic&&(n.mu=n.mu_static);return ss({...qo,...n},{plane:n},e)}function Dh(n,t){return n.speed===
null?n.omega===null?H("no_omega"):null:(n.vx=n.speed,n.omega=null,es("start","speed",t,Ih))}function jh({damping:n=null,restitution:t=null}){return n!==null&&t!==
null?H("together",{section:"contact",other:"restitution",way:"damping"}):null}var{scenario:kt}=E,zo=kt.left_out,Uo={rigid:"Rigid",compliant:"Compliant"};function Te(n,t){let{fields:e,place:s}=kt.models.Scenario,i=xt(n)?An(s,n,Object.keys(
e)):Vt("",n,"table");if(i)throw new I(i);let o=[],r=Object.keys(e).map(c=>{let m=Object.hasOwn(n,c)?n[c]:kt.default[c];return[c,zn(c,m,t,o)]}),a=Object.fromEntries(
r),l=o.length?On(o):ss(tt(a),a,t);if(l)throw new I(l);return a}function zn(n,t,e,s){if(n==="duration")return Pn(kt.models.Scenario.fields[n],t,n,s);let[i]=n==="\
contact"?[Rn(t,"model",Uo,n,s,"rigid")]:kt.sections[n],o=i&&Sn(i,t,n,s),r=o&&Bo[n](o.values,o.given,e);return r&&s.push(r),o?.values}var Se=(n,t)=>Te(Do(n),t),is=(n,t,e)=>Te(
Go(n,t,e),e);function Go(n,t,e){return Oo(n,$t(n),t,(s,i)=>{let o=[],r=zn(s,i,e,o);if(o.length)throw new I(On(o));return r})}function Wo(n,t,e){let s=[];try{let i=Go(
n,t,e),r=[...new Set([...t.keys()].map(a=>a.split(".")[0]))].map(a=>[a,zn(a,i[a],e,s)]);return s.length?null:Object.fromEntries(r)}catch(i){if(i instanceof I)return null;
throw i}}var Ee=(n,t)=>Object.fromEntries(t.filter(e=>n[e]!==null).map(e=>[e,n[e]===1/0?"inf":n[e]])),Bn=n=>Object.keys(kt.models[n].fields);function $t({duration:n,
hoop:t,plane:e,start:s,contact:i}){let o=e.apart?["mu"]:["mu_static","mu_kinetic"],r=l=>l in zo&&e[l]===zo[l],a=["x","height","angle","vx","vy","omega"];return{
duration:n,hoop:qh(t),plane:Ee(e,Bn("Plane").filter(l=>!o.includes(l)&&!r(l))),start:Ee(s,s.speed===null?a:["x","angle","speed"]),contact:Ee(i,Bn(Uo[i.model]))}}
function qh(n){if(n.parts){let e=n.parts.map(s=>Ee(s,Bn(kt.parts[s.shape])));return{radius:n.radius,parts:e}}let t=n.load_fraction===null?["eccentricity","inert\
ia_ratio"]:["load_fraction"];return Ee(n,["radius","mass",...t])}function Un(n,t){if(n==="hoop"||n==="plane")return kt.default[n];let{fields:e}=kt.models[n==="s\
tart"?"Start":t==="compliant"?"Compliant":"Rigid"];return Object.fromEntries(Object.entries(e).map(([s,i])=>[s,i.default??void 0]))}function Ae(n){let t={};for(let[
e,s]of Object.entries($t(n))){if(ns(s,kt.default[e]))continue;let i=xt(s)?Un(e,s.model):{},o=Object.entries(s).filter(([r,a])=>r==="model"||!ns(i[r],a));t[e]=xt(
s)&&o.length?Object.fromEntries(o):s}return jn(t)}var ns=(n,t)=>JSON.stringify(n)===JSON.stringify(t);var Bh=8,{quantities:Ko}=E.map;async function Gn(n,{x:t,y:e},s,i){let[o,r]=[Me(t),Me(e)],a=(...f)=>Wo(n,new Map(f),s),l=zh(n,t.path,e.path),c=l&&o.map(f=>a([t.path,
f])),m=l&&r.map(f=>a([e.path,f])),h=o.length*r.length,p=new Float64Array(ge.length*h),d=performance.now();for(let f=0;f<h;f++){let g=f%o.length,_=(f-g)/o.length;
g===0&&performance.now()-d>Bh&&(await new Promise(k=>setTimeout(k)),i?.throwIfAborted(),d=performance.now());let b=c?c[g]:a([e.path,r[_]],[t.path,o[g]]),y=m?m[_]:
b;if(!b||!y)continue;let w=tt({...n,...b,...y});for(let k=0;k<ge.length;k++)p[k*h+f]=ge[k](w)}return{count:h,rows:p}}function zh({start:n},t,e){let s=[t,e].map(
o=>o.split(".")[0]);if(s[0]===s[1])return!1;let i=[t,e].some(o=>o.startsWith("start.")&&o!=="start.speed");return!(s.includes("hoop")&&i&&n.speed!==null)}var Wn=n=>Ko[n].
span;function Kn({x:n,y:t,what:e},s){let{unit:i,words:o}=Ko[e],r=`quantity.${e}`,{values:a,names:l}=Uh(s,i===""?o:null),c=m=>({name:m,text:xo(m,e),color:vo(m,e)});
return{header:{x:n,y:t,what:e,label:r,unit:i,classes:i===""?l.map(c):null},arrays:{values:a}}}function Uh({values:n,sequences:t},e){if(!e)return{values:n,names:[]};
let s=t?[...t].sort((r,a)=>r.length-a.length||(r<a?-1:1)):e,i=t?.map(r=>s.indexOf(r));return{values:Float64Array.from(n,r=>r>=0?i?.[r]??r:Number.NaN),names:s}}var{scenario:Pe}=E,Gh=30,Jo={};for(let{fields:n}of Object.values(Pe.models))Object.assign(Jo,n);function Qo(n,t){return typeof t=="string"?JSON.stringify(t):Jo[n]?.
kind==="whole"?String(t):Mn(t)}function Vo(n,t,e){if(Array.isArray(e)){let r=a=>Object.entries(a).map(([l,c])=>`${l} = ${Yo(l,c)}`);return[`${t} = [`,...e.map(a=>`\
  { ${r(a).join(", ")} },`),"]"].join(`
`)}let s=`${t} = ${Yo(t,e)}`,o=(Pe.sections[n]??["Scenario"]).map(r=>Pe.models[r].fields).find(r=>t in r)[t].unit;return o===""||o==="1"?s:`${s.padEnd(Gh)} # ${o}`}
var Yo=(n,t)=>t==="inf"?"inf":Qo(n,t);function os(n){let{duration:t,...e}=$t(n),s=[Vo("","duration",t)];for(let[i,o]of Object.entries(e))s.push("",`[${i}]`,...Object.
entries(o).map(([r,a])=>Vo(i,r,a)));return`${s.join(`
`)}
`}var Wh={hoop:"Hoop",plane:"Plane",start:"Start"},Kh=["load_fraction","mu"];function Vn(n){let{duration:t,contact:e,...s}=$t(n),i=Object.entries(s).map(([o,r])=>Xo(
o,r));return ns(e,Pe.default.contact)||i.push(`contact=${Xo("contact",e)}`),i.splice(3,0,`duration=${Mn(t)}`),`import hophoop as hh

motion = hh.simulate(
${i.map(o=>`    ${o},
`).join("")})
print(motion.sequence, motion.status)
for event in motion.events:
    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")
`}function Xo(n,{parts:t,...e}){let s=n==="start"&&"speed"in e,i=s?"Start.rolling":Wh[n]??(e.model==="rigid"?"Rigid":"Compliant"),o=s?{angle:0,x:0}:Un(n,e.model),
r=Object.entries(e).filter(([l,c])=>Kh.includes(l)||o[l]!==c),a=t?[`parts=[${t.map(Vh).join(", ")}]`]:[];return`hh.${i}(${[...r.map(Zo),...a].join(", ")})`}var Vh=({
shape:n,...t})=>`hh.${Pe.parts[n]}(${Object.entries(t).map(Zo).join(", ")})`,Zo=([n,t])=>`${n}=${t==="inf"?'float("inf")':Qo(n,t)}`;Ht();var{letters:er,modes:Xn,summed_up:Yh}=E.words,Xh=400,[,Yn,tr,Jh,Qh]=Xn,Zh="⁰¹²³⁴⁵⁶⁷⁸⁹";function sr(n,t){let{omega:e,to:s}=n[t];return e===0&&(s===
"S"||s==="K")&&t+1<n.length}var Jn=n=>[...n.keys()].filter(t=>sr(n,t)),Qn=(n,t)=>.5*(n[t].t+n[t+1].t);function Zn(n,t=Xh){let e=[],s=0,i=ir(n.events);for(let[o,
r]of n.events.entries()){let a=i.get(o);if(a===0||r.kind==="end")continue;let l=a===void 0?ec(n,o,r):{key:"story.more_bounces",values:{count:a}};if(e.length>=t){
s++;continue}e.push({t:r.t,event:o,mode:er[Xn.indexOf(rs(n,o))],text:l})}return s&&e.push({...e[e.length-1],text:{key:"story.left_out",values:{count:s}}}),e}var nr=n=>n.
kind==="impact"&&n.to==="H"&&n.collision!==!1;function ir(n,t=3,e=6){let s=new Map,i=[];for(let o=0;o<=n.length;o++){let r=n[o];if(r&&(nr(r)||i.length&&r.kind===
"apex")){i.push(o);continue}let a=i.filter(l=>n[l].kind==="impact");if(a.length>=e){for(let l of i.slice(i.indexOf(a[t])))s.set(l,0);s.set(a[t],a.length-t)}i=[]}
return s}function ti(n,t=6){let e=[],s=0,i=ir(n.events,1);for(let[r,a]of n.events.entries()){let l=i.get(r);if(l!==void 0){l&&e.push({key:"summary.more_times",values:{
what:e.pop()??"",count:l}});continue}if(a.kind==="start"||!e.length){e.push(`verb.${rs(n,r)}`);continue}let c=tc(n,r,a);c&&(s++,s<=t&&e.push({key:c,values:{where:re(
a.angle)}}))}s>t&&e.push({key:"summary.more_changes",values:{count:s-t}});let o=`status.${n.status}`;return n.status==="completed"?{key:"summary.whole",values:{
phrases:at(e)}}:{key:"summary.with_ending",values:{phrases:at(e),ending:o}}}function tc(n,t,e){return e.collision===!1?"summary.without_collision":nr(e)?"summar\
y.bounces":["slip_start","slip_reversal"].includes(e.kind)||or(e)?`summary.${rs(n,t)}`:Yh.includes(e.kind)?`summary.${e.kind}`:""}function ec(n,t,e){let s=rs(n,
t),i={where:re(e.angle),verb:`verb.${s}`};return{key:`story.${sc(n.events,t,s,i)}`,values:i}}function sc(n,t,e,s){let i=n[t],{kind:o}=i;return o==="start"&&(s.speed=
Yt(i.vx),e===Jh||e===Qh)?`start_${e}`:o==="slip_start"&&e===Yn?"slip_start_spin":o==="takeoff"?nc(n,t,s):o==="impact"?(s.speed=Yt(i.before.vy===null?null:Math.abs(
i.before.vy)),i.collision===!1?"impact_without_collision":i.to==="H"?"impact_bounce":o):o==="turn"&&or(i)?"turn_in_slip":(o==="apex"&&(s.gap=rr(i.height)),o==="\
kane_gain"&&(s.gain=Yt(i.gain)),o==="rest"&&i.stable===!1?"rest_unstable":o)}function nc(n,t,e){let{t:s}=n[t],i=0;for(let o=t;o<n.length;o++)if(i=Math.max(i,n[o].
height),!(o===t||n[o].kind!=="impact")){for(let r=o+1;r<n.length&&n[r].t<=n[o].t;r++)i=Math.max(i,n[r].height);if(!i)break;return e.top=rr(i),e.time=Yt(n[o].t-s),
"takeoff_and_landing"}return"takeoff"}function rs(n,t){let e=n.events[t];return ic(e.to,sr(n.events,t)?n.omega(t):e.omega)}function ic(n,t){return n==="S"?t>0?Yn:
tr:n==="K"?t<0?Yn:tr:Xn[er.indexOf(n)]}var or=n=>n.kind==="turn"&&(n.to==="S"||n.to==="K"),re=n=>`${En(n*(180/Math.PI),1)}°`.replaceAll("-","−");function rr(n){
return n>=.995?`${Yt(n)} m`:n>=.00995?`${Yt(n*100)} cm`:`${Yt(n*1e3)} mm`}function Yt(n){if(n===null||Number.isNaN(n))return"?";let[t,e]=lt(n,3).split("e"),s=e===
void 0?"":`·10${oc(Number(e))}`;return`${t}${s}`.replaceAll("-","−")}var oc=n=>[...String(n)].map(t=>t==="-"?"⁻":Zh[Number(t)]).join("");var ar=2e3;function as(n,{status:t,sequence:e,fingerprint:s,events:i,final:o,energy:r}){let{schema:a,setup:l}=E,c=$t(n);return{schema:a,version:l.version,scenario:c,
status:t,sequence:e,fingerprint:s,events:i,final:o,energy:r}}function ls(n,t,e,s){let i={events:t.events,status:t.status,omega:e};return{...as(n,t),events:t.events.
slice(0,ar),query:Ae(n),duration:t.duration,values:rc(n),automatic:ac(n,s),massless:n.hoop.inertia_ratio===0,summary:ti(i),story:Zn(i),shortened:t.events.length>
ar}}function rc({hoop:n,plane:t,start:e}){let s={hoop:n,plane:t,start:{...vt(e,n.radius),speed:e.speed}},i=E.shown.map(o=>{let[r,a]=o.split("."),l=s[r][a];return[
o,l===1/0?"inf":l]});return Object.fromEntries(i)}function ac(n,t){if(n.contact.model==="rigid")return{};let{stiffness:e,slip_speed:s}=t.chosen(tt(n)),{restitution:i}=n.
plane;return{"contact.stiffness":e,"contact.slip_speed":s,"contact.restitution":i}}var{rate:lc,variables:ei}=E.table,{letters:hc}=E.words,si=(n,t)=>JSON.stringify(as(n,t),null,1);function ni(n){let t=Math.min(Math.max(Math.floor(n*lc)+1,2),E.limits.
samples),e=n/(t-1);return Float64Array.from({length:t},(s,i)=>i===t-1?n:i*e)}function ii(n,t){let e=Object.keys(ei),s=e.map(l=>ei[l]==="1"?l:`${l} [${ei[l]}]`),
{kinetic:i,potential:o}=t,r={...t,total:Float64Array.from(i,(l,c)=>l+o[c])},a=[["t [s]",...s].join(",")];for(let[l,c]of n.entries()){let m=e.map(h=>h==="mode"?hc[r.
mode[l]]:Lt(r[h][l]));a.push([Lt(c),...m].join(","))}return`${a.join(`\r
`)}\r
`}var{limits:hs}=E;function it({scenario:n,query:t,changes:e=[]},s){let o=n!==void 0&&t===void 0?Te(n,s):Se(t??"",s),r=new Map;for(let[a,l]of e)ke([...r.keys(),a])&&
(o=is(o,r,s),r=new Map),r.set(a,l);return r.size?is(o,r,s):o}function oi({scenario:n,query:t,changes:e=[],...s},i){if(e.length>hs.changes)throw new st(G("too_ma\
ny_changes",{pairs:e.length,most:hs.changes}));let{x:o,y:r}=s;if(o&&o.path===r.path)throw new I(G("equal_axes",{path:o.path}));let a=o?o.cells*r.cells:0;if(a>hs.
cells)throw new st(G("too_many_cells",{cells:a,most:hs.cells}));return{...s,checked:it({scenario:n,query:t,changes:e},i)}}var cc=new Set(Object.keys(E.scenario.models.Scenario.fields)),mc=40,cs=n=>new URLSearchParams(`&${n}`).keys().next().value??"",lr=n=>!cs(n).includes(".")&&!cc.
has(cs(n));function ri(n,t){let e=n.replace(/^\?/,"").split("&").filter(Boolean),s=e.filter(l=>!lr(l)),i=e.filter(lr).map(cs),o=l=>{try{return Ct(it({query:l.join(
"&")},t)),null}catch(c){if(c instanceof I)return c;throw c}},r=o(s);return{query:(r?uc(s,l=>!o(l)):s).join("&"),foreign:[...new Set(i)],error:r}}function uc(n,t){
if(n.length>mc)return[];let e=new Map;for(let i of n){let o=cs(i).split(".")[0];e.set(o,[...e.get(o)??[],i])}let s=[];for(let i of e.values()){let o=[...s,...pc(
i,t)];t(o)&&(s=o)}return s}function pc(n,t){let e=(...i)=>n.filter((o,r)=>!i.includes(r));return[n,...n.map((i,o)=>e(o)),...n.flatMap((i,o)=>n.map((r,a)=>e(o,a)))].
find(t)??[]}var dc=["hoop.eccentricity","plane.slope"],fc={...Object.fromEntries(Object.entries(E.map.rates).map(([n,t])=>[n,()=>({[t]:1})])),"hoop.radius":gc,"hoop.mass":({
hoop:n})=>n.parts?null:{mass:1},"hoop.load_fraction":({hoop:{load_fraction:n}})=>n===null?null:{eccentricity:1,inertia_ratio:-2*n},"plane.mu":({plane:{mu:n}})=>n===
null||n===1/0?null:{mu_static:1,mu_kinetic:1},"plane.mu_static":({plane:n})=>n.mu_static===1/0?null:{mu_static:1},"plane.mu_kinetic":({plane:n})=>n.mu_kinetic===
1/0?null:{mu_kinetic:1},"plane.rolling_resistance":({hoop:n})=>n.inertia_ratio===0?null:{rolling_resistance:1},"start.speed":({hoop:n,start:t})=>t.speed===null?
null:{omega:1/n.radius},"start.vx":()=>({slip:1}),"start.omega":({hoop:n})=>({omega:1,slip:-n.radius})};function gc({hoop:{radius:n,parts:t,eccentricity:e,inertia_ratio:s},
start:{speed:i,omega:o}}){let r={radius:1};return i===null?r.slip=-(o||0):r.omega=-i/(n*n),t?{...r,eccentricity:-e/n,inertia_ratio:-2*s/n}:r}function ai(n,t){let e=fc[t]?.(
n),{smaller:s,larger:i}=_c(n,t);if(!e||!(s||i))return null;let o=new Float64Array(v.cell.length);for(let[r,a]of Object.entries(e))o[go[r]]=a;return{rates:o,smaller:s,
larger:i}}function _c(n,t){let{mu_static:e,mu_kinetic:s}=n.plane,i=bc(n,t),{least:o,most:r,also:a=[]}=E.map.allowed[t],l=e!==s,c=n.hoop.inertia_ratio===0&&dc.includes(
t);return{smaller:!c&&i>Math.min(o,...a.map(be))&&(l||t!=="plane.mu_static"),larger:!c&&i<r&&(l||t!=="plane.mu_kinetic")}}function bc(n,t){return t==="start.ome\
ga"?vt(n.start,n.hoop.radius).omega:t.split(".").reduce((e,s)=>e[s],n)}Ht();function hi({hoop:n,plane:t},e){let s=[],i=(a,l,c,m)=>{l!==null&&s.push({key:a,label:`theory.${a}`,value:Number.isFinite(l)?l:null,unit:c,text:m(l)})},o=()=>i("\
painleve",e.painleve_friction,"1",a=>wc(a,e,t));if(t.gravity<=0)return o(),s;if(n.inertia_ratio===0){let a=e.massless_loss_by_friction?"theory.loss_by_friction":
"theory.loss_of_contact";return i("loss",e.massless_loss_angle,"rad",l=>hr(a,l)),s}t.slope>=0?(i("first_slip",e.first_slip_speed,"m/s",a=>li(a,"would_slip")),i(
"first_hop",e.first_hop_speed,"m/s",a=>li(a,"would_hop")),i("immediate_hop",e.immediate_hop_speed,"m/s",a=>li(a,"would_hop_at_once"))):s.push({key:"uphill",label:"\
theory.uphill",value:null,unit:"",text:"theory.no_threshold"}),i("needed_friction",e.needed_friction,"1",a=>yc(a,t)),o();let r=at(e.jam_angles.map(re));return i(
"jam",e.jam_angles[0]??null,"rad",()=>({key:"theory.jam_at",values:{places:r}})),n.eccentricity>0&&i("rest",e.stable_angle,"rad",a=>hr("theory.rest_at",a)),s}var hr=(n,t)=>({
key:n,values:{where:re(t)}});function li(n,t){return n<E.words.least_speed?`theory.${t}.always`:Number.isFinite(n)?{key:`theory.${t}.above`,values:{speed:lt(n,4)}}:
"theory.no_speed"}function yc(n,{mu_static:t}){return Number.isFinite(n)?{key:n<=t?"theory.friction_enough":"theory.friction_short",values:{mu:lt(n,3)}}:"theory\
.no_friction"}function wc(n,{painleve_angle:t},{mu_kinetic:e}){return t===null?"theory.never":{key:n<=e?"theory.paradox_here":"theory.paradox_not_here",values:{
mu:lt(n,3),where:re(t)}}}S();N();O();var br=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],Pc="tfc",Lc=/^[0-9a-f]{16}$/,Cc=400;function yr({time:n=0,options:t={},
zoom:e=1,pan:s=[0,0],from:i,more:o,map:r,fingerprints:a=[]}){let l=[];n>0&&l.push(`t=${Number(n.toFixed(4))}`);let c=br.filter(([m])=>t[m]).map(([,m])=>m);return c.
join("")!==Pc&&l.push(`show=${c.join("")}`),e!==1&&l.push(`zoom=${Number(e.toPrecision(3))}`),s.some(m=>Math.abs(m)>5e-4)&&l.push(`pan=${s.map(m=>Number(m.toFixed(
3))).join(",")}`),i&&l.push(`from=${i.map(m=>Number(m.toPrecision(3))).join(",")}`),o&&l.push(`more=${o}`),r&&l.push(`map=${[r.what,...r.x,...r.y].join(",")}`),
a.some(Boolean)&&l.push(`fingerprint=${a.join(",")}`),l.join("&")}function wr(n){let t=new URLSearchParams(n.replace(/^#/,"")),e={},s=Number(t.get("t")??Number.
NaN);s>=0&&(e.time=s);let i=t.get("show");i!==null&&(e.options=Object.fromEntries(br.map(([y,w])=>[y,i.includes(w)])));let o=Number(t.get("zoom")??Number.NaN);o>
0&&(e.zoom=x(o,.05,60));let r=_r(t.get("pan"),2);r&&(e.pan=r.map(y=>x(y,-20,20)));let a=_r(t.get("from"),3);a&&(e.from=a);let l=t.get("more");l&&(e.more=l);let[
c,m,h,p,d,f,g]=t.get("map")?.split(",")??[],_=[h,p,f,g].map(Number);g!==void 0&&_.every(Number.isFinite)&&_[0]<_[1]&&_[2]<_[3]&&(e.map={what:c,x:[m,_[0],_[1]],y:[
d,_[2],_[3]]});let b=t.get("fingerprint")?.toLowerCase().split(",");return b&&(e.fingerprints=b.map(y=>Lc.test(y)?y:"")),e}function _r(n,t){let e=(n??"").split(
",").map(Number);return n&&e.length===t&&e.every(Number.isFinite)?e:null}var fi=()=>{let n=new URLSearchParams(location.hash.slice(1)).get("with");return[location.
search.slice(1),...n===null?[]:[n]]},ps=class{constructor(t,e,s){this.motions=t;this.notice=e;this.link=s;this.number=history.state?.number??0;this.held=!1;this.
soon=ut(()=>this.write("same"),Cc),this.listen=()=>this.arrived(),addEventListener("popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(t){
let{motions:e}=this;if(!e.lanes.length||!e.history.holds(e.queries())||this.held&&(t==="same"||t==="travelled"))return;let s=this.link();t==="step"||this.held?history.
pushState({number:++this.number},"",s):history.replaceState({number:this.number},"",s),this.held=!1}read(t){let{notice:e}=this,{backend:s}=this.motions,i=t.map(
l=>s.readable?.(l)??{query:l,foreign:[],error:null}),o=i.find(l=>l.error)?.error,r=i.flatMap(l=>l.foreign);this.held=!!o;let a=()=>{o?e.fail(o,"shell.the_rest_o\
f_the"):r.length&&e.say({key:"shell.ignored_in_the_link",values:{names:at(r)}})};return{links:i.map(l=>l.query),said:a}}travel(t){return new Promise(e=>{let s=()=>e();
addEventListener("popstate",s,{once:!0}),setTimeout(s,300),history.go(t)})}async arrived(){let t=history.state?.number??0,{links:e,said:s}=this.read(fi());JSON.
stringify(e)===JSON.stringify(this.motions.queries())?this.number=t:await this.motions.arrive(e)?(this.number=t,s()):t!==this.number&&history.go(this.number-t)}};S();Dt();N();var Fe=[.05,.1,.25,.5,1,2,4],ds=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,fs=class{constructor(){this.time=0;this.duration=1;this.speed=1;this.
playing=!1;this.loop=!ds();this.once=!1;this.pointed=null;this.last=null;this.listeners=new Set}changed(){for(let t of this.listeners)t(this)}run({to:t=this.time,
once:e=!1}={}){ds()?this.seek(t):(this.play(!0),this.once=e)}seek(t){this.time=x(t,0,this.duration),this.changed()}point(t){this.pointed=t,this.changed()}play(t=!this.
playing){this.playing=t,this.once=!1,this.last=null,t&&this.time>=this.duration&&(this.time=0),this.changed()}faster(t){let e=Fe.indexOf(this.speed);this.speed=
Fe[x(e+t,0,Fe.length-1)],this.changed()}tick(t){if(!this.playing)return!1;let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*
this.speed,this.time>=this.duration&&(this.loop&&!this.once&&this.duration>0?this.time%=this.duration:(this.time=this.once?0:this.duration,this.playing=!1,this.
changed())),!0}};S();S();N();O();function Rc(n,t=""){let e=n.trim();t&&e.endsWith(t)&&(e=e.slice(0,-t.length)),e=e.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(i,o,r)=>`e${o&&"-"}${r.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(e);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(e)?Number(e.replace(",",".")):Number.NaN}function Oc(n,t,{label:e,unit:s,range:i}){let o=n.trim();if(Number.isNaN(t))return{key:"controls.name_value_must_b\
e",values:{name:e,value:o}};if(!Number.isFinite(t)&&/\d/.test(o))return{key:"controls.label_value_is_too",values:{label:e,value:o}};if(!i||t>=i.least&&t<=i.most||
i.also.includes(t))return"";let[r,a]=[i.also.includes(0),i.also.includes(1/0)],c={key:`range.${r?"zero_or_":""}from_to${a?"_or_inf":""}`,values:{least:M(i.least,
4),most:j(M(i.most,4),s)}};return{key:"controls.name_value_must_be_rule",values:{name:e,value:j(M(t,6),s),rule:c}}}var Nc=0,he=class{constructor(t,e){this.info=
t;this.onvalue=e;this.shown="";this.typing=!1;this.error=u("p",{class:"error",role:"alert",id:`hh-error-${++Nc}`,hidden:!0});this.input=u("input",{type:"text",inputmode:"\
decimal",autocomplete:"off",spellcheck:"false",class:"exact","aria-label":t.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.
typing&&this.typed(),onkeydown:s=>{s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute(
"aria-invalid")==="true"}typed(){let t=this.input.value;if(!this.typing)return;if(this.typing=!1,t.trim()===""){this.restore();return}let e=Rc(t,this.info.unit),
s=Oc(t,e,this.info);s?this.refuse(s):this.onvalue(e)}refuse(t){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.
id),L(this.error,t),this.error.hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){
this.typing=!1,this.input.value=this.shown,this.accept()}show(t){this.shown=gt(t),this.typing||this.restore()}};N();S();var vr={ring:{label:"parts.ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"parts.disk",keys:["mass","radius","at"]},point_mass:{label:"parts.poi\
nt_mass",keys:["mass","at"]},rod:{label:"parts.rod",keys:["mass","length","at"]}},Fc={mass:["parts.mass","kg"],inner_radius:["parts.inner_radius","m"],outer_radius:[
"parts.outer_radius","m"],radius:["parts.radius","m"],at:["parts.distance_from_centre","m"],length:["parts.length","m"]},Ic=(n,t,e)=>({ring:{shape:n,mass:e,inner_radius:.95*
t,outer_radius:t},disk:{shape:n,mass:e,radius:.1*t,at:.8*t},point_mass:{shape:n,mass:e,at:t},rod:{shape:n,mass:e,length:.5*t,at:.5*t}})[n];function xr(n){let t=n["\
hoop.radius"],e=n["hoop.mass"],s=Math.min(Math.max(n["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:gs(e*(1-s)),inner_radius:gs(.98*t),outer_radius:t},
{shape:"point_mass",mass:gs(e*s),at:t}]}var gs=n=>Number(n.toPrecision(6)),_s=class{constructor(t){this.onchange=t;this.list=u("div",{class:"parts"});this.element=
u("div",{},this.list,u("select",{"aria-label":"parts.add_a_part",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,Ic(s,this.radius,
gs(.2*this.mass))])}},u("option",{value:""},"parts.add_a_part_2"),Object.entries(vr).map(([e,{label:s}])=>u("option",{value:e},s))))}send(t){this.onchange([["ho\
op.parts",t]])}show(t,e,s){let i=JSON.stringify(t);if(i===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(
this,{text:i,parts:t,radius:e,mass:s}),this.list.replaceChildren(...t.map((o,r)=>this.row(o,r)))}row(t,e){let{label:s,keys:i}=vr[t.shape];return u("fieldset",{class:"\
part"},u("legend",{},s,this.parts.length>1&&u("button",{type:"button",class:"quiet","aria-label":{key:"parts.remove_part_number_what",values:{number:e+1,what:s}},
onclick:()=>this.send(this.parts.filter((o,r)=>r!==e))},"×")),i.map(o=>this.field(t,e,o)))}field(t,e,s){let[i,o]=Fc[s],r=new he({label:i,unit:o},a=>this.send(this.
parts.map((l,c)=>c===e?{...l,[s]:a}:l)));return r.show(String(t[s]??0)),u("div",{},u("label",{},i,` [${o}]`,r.input),r.error)}};O();var gi=Math.PI/180;function Hc({allowed:n,degrees:t}){if(!n)return;let e=t?1/gi:1;return{least:n.least*e,most:n.most*e,also:n.also.map(s=>s==="inf"?1/0:Number(
s))}}var _i=class{constructor(t,e){this.info=t;this.onchange=e;this.held=!1;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`,i=l=>()=>{this.held=l};
this.range=u("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,
oninput:()=>this.slid(!1),onchange:()=>this.slid(!0),onpointerdown:i(!0),onpointerup:i(!1),onpointercancel:i(!1),onblur:i(!1)});let{label:o,unit:r}=t,a=r?{key:"\
controls.name_exact_value_in",values:{name:o,unit:r}}:{key:"controls.name_exact_value",values:{name:o}};this.entry=new he({label:o,unit:r,name:a,range:Hc(t)},l=>this.
send(l,!0)),this.element=u("div",{class:"control",title:t.help},u("label",{for:s},u("span",{},o),u("span",{class:"symbol"},t.symbol)),this.range,u("span",{class:"\
entry"},this.entry.input,u("span",{class:"unit"},r)),this.entry.error)}low(){return this.info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.
info.logarithmic?Math.log10(this.info.most):this.info.most}slid(t){let e=Number(this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.
entry.typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,t)}send(t,e){let s=this.info.degrees?t*gi:t;this.onchange([[this.info.path,Number.isFinite(s)?
s:"inf"]],e)}say(t){this.range.setAttribute("aria-valuetext",j(M(t,4),this.info.unit))}show(t,e=null){if(this.held)return;let s=t!=null,i=s?t:e;if(i==null){this.
entry.show("");return}let o=i==="inf"?1/0:Number(i)/(this.info.degrees?gi:1);this.entry.show(s?Number.isFinite(o)?String(Number(o.toPrecision(9))):"∞":""),this.
entry.input.placeholder=s?"":P("controls.auto_value",{value:M(o,2)}),this.entry.input.title=s?j(String(o),this.info.unit):"";let r=x(this.info.logarithmic?Math.
log10(o):o,this.low(),this.high());Math.abs(Number(this.range.value)-r)>1e-6&&(this.range.value=String(r)),this.say(o)}};function $c(n,t){let e=u("select",{"dat\
a-path":n.path,onchange:()=>t([[n.path,e.value]],!0)},n.options.map(([i,o])=>u("option",{value:i},o)));return{element:u("label",{class:"choice",title:n.help},u(
"span",{},n.label),e),select:e,path:n.path}}var bs=class{constructor(t,e){this.sliders=new Map;this.onchange=(s,i=!0)=>e(s,i);for(let s of Object.values(t.groups))
for(let i of s)this.sliders.set(i.path,new _i(i,this.onchange));this.choices=new Map(t.choices.map(s=>[s.path,$c(s,this.onchange)])),this.parts=new _s(this.onchange),
this.gravities=t.gravities,this.element=u("div",{class:"controls"},this.hoop(),this.plane(),this.start(),this.contact())}at(t){let e=this.sliders.get(t)??this.choices.
get(t);if(!e)throw new Error(`There is no control of ${t}.`);return e.element}of(t,e={}){return[...this.sliders.keys(),...this.choices.keys()].filter(s=>s.startsWith(
`${t}.`)).flatMap(s=>[...e[s]??[],this.at(s)])}select(t,e,s){let i=u("select",{onchange:()=>s(i.value)},e.map(([o,r])=>u("option",{value:o},r)));return{select:i,
element:u("label",{class:"choice"},u("span",{},t),i)}}group(t,...e){let s=t==="controls.start"||t==="controls.plane"||!matchMedia("(max-width: 47.5em)").matches;
return u("details",{class:"group",open:s},u("summary",{},t),e)}hoop(){return this.way=this.select("controls.given_by",[["load_fraction","controls.load_fraction_\
gamma"],["eccentricity","controls.epsilon_and_kappa"],["parts","controls.real_parts"]],t=>{let{values:e}=this.film;t==="parts"?this.onchange([["hoop.parts",xr(e)]]):
this.onchange([[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=u("p",{class:"derived"}),this.group("controls.hoop",this.way.element,...this.of("hoop",{"ho\
op.radius":[this.parts.element,this.derived]}))}plane(){this.apart=u("input",{type:"checkbox",onchange:()=>{let{values:s}=this.film;this.apart.checked?this.onchange(
[["plane.mu_static",s["plane.mu_static"]],["plane.mu_kinetic",s["plane.mu_kinetic"]]]):this.onchange([["plane.mu",s["plane.mu_static"]]])}}),this.gravity=this.select(
"controls.where",[...this.gravities.map(([s])=>[s,s]),["","controls.elsewhere"]],s=>{let i=this.gravities.find(([o])=>o===s);i&&this.onchange([["plane.gravity",
i[1]]])});let e={"plane.slope":[u("label",{class:"check"},this.apart,"controls.static_and_kinetic_friction")],"plane.gravity":[this.gravity.element]};return this.
group("controls.plane",...this.of("plane",e))}start(){return this.kind=this.select("controls.starts",[["rolling","controls.rolling"],["free","controls.in_any_st\
ate"]],t=>{let{values:e}=this.film;t==="rolling"?this.onchange([["start.speed",e["start.vx"]]]):this.onchange([["start.omega",e["start.omega"]]])}),this.group("\
controls.start",this.kind.element,...this.of("start"),this.at("duration"))}contact(){return this.group("controls.contact",this.at("contact.model"),this.at("cont\
act.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitution"))}refuse(t,e){let s=t.length===1?
this.sliders.get(t[0][0]):void 0;return s?.element.checkVisibility()?(s.entry.refuse(e),!0):!1}restore(){this.film&&this.showChoices(this.film,new Set)}show(t,e=new Set){
this.film=t,this.showChoices(t,e);let s=t.scenario;for(let[i,o]of this.sliders){if(e.has(i))continue;let[r,a]=i.split(".");o.show(t.values[i]??(a?s[r]?.[a]:s[r]),
t.automatic?.[i])}}showChoices(t,e){let{scenario:s,values:i}=t,o=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_fraction":"eccentricity",r="speed"in s.start,
a="mu_static"in s.plane,l=s.contact.model==="compliant",c=(...d)=>d.some(f=>e.has(f));c("hoop.load_fraction","hoop.eccentricity","hoop.parts")||(this.way.select.
value=o),c("start.speed","start.omega")||(this.kind.select.value=r?"rolling":"free"),c("plane.mu","plane.mu_static")||(this.apart.checked=a);let m=this.gravities.
find(([,d])=>Math.abs(d-s.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=m?m[0]:"");let h={"hoop.load_fraction":o==="load_fraction","hoop.e\
ccentricity":o==="eccentricity","hoop.inertia_ratio":o==="eccentricity","hoop.mass":o!=="parts","plane.mu":!a,"plane.mu_static":a,"plane.mu_kinetic":a,"plane.re\
stitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":r,"start.height":!r,"start.vx":!r,"start.vy":!r,"start.omega":!r,"contact.law":l,"contact.\
friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[d,f]of Object.entries(h))this.at(d).hidden=!f;this.parts.element.hidden=
o!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,i["hoop.radius"],i["hoop.mass"]),this.derived.textContent=o==="eccentricity"?"":`ε = ${M(i["hoop.eccentr\
icity"],5)}, κ = ${M(i["hoop.inertia_ratio"],5)}`+(o==="parts"?`, m = ${M(i["hoop.mass"],5)} kg`:"");let p=s;for(let[d,{select:f}]of this.choices){if(e.has(d))
continue;let[g,_]=d.split(".");p[g]?.[_]!==void 0&&(f.value=p[g][_])}}};S();S();N();var bi=Math.PI/180;function kr(n,t){let{start:e,plane:s,contact:i,hoop:o}=n.scenario;return i.model!=="rigid"?"challenge.rigid_contact_only":n.slope!==0?"ch\
allenge.the_plane_must_be":Math.abs(n.gravity-9.81)>1e-9?"challenge.it_must_be_on":(s.restitution??0)!==0?"challenge.restitution_must_be_0":n.radius!==1||o.parts?
"challenge.the_radius_must_stay":n.eccentricity>.9?"challenge.at_most_90_of":"load_fraction"in o?"speed"in e?Math.abs(e.speed??3.1)>t+1e-9?t>5?"challenge.at_mos\
t_10_m":"challenge.at_most_3_1":n.scenario.duration>6?"challenge.at_most_6_s":"":"challenge.it_must_start_rolling":"challenge.the_hoop_must_be"}var Mr=n=>n.events.
filter(({kind:t})=>t==="takeoff");function Dc(n){return n.events.filter(({kind:t})=>t==="apex").map(({height:t})=>t)}var Er=(n,t)=>Math.min(Math.round(100*n/t),
100),jc=1.596,qc=.37,Bc=.05,yi=[{key:"highest",title:"challenge.hop_highest",text:"challenge.on_level_ground_rolling",start:"",best:"hoop.load_fraction=0.9&plan\
e.mu=0.29",score:n=>{let t=kr(n,3.1);if(t)return{points:0,text:t};let e=Math.max(0,...Dc(n));return e?{points:Er(e,jc),text:"challenge.it_rises_by_height",values:{
height:jt(e)}}:{points:0,text:"challenge.it_does_not_hop"}}},{key:"upright",title:"challenge.land_upright",text:"challenge.let_the_hoop_land",start:"",best:"hoo\
p.load_fraction=0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:n=>{let t=Mr(n)[0],e=n.events.find(({kind:r,t:a})=>r==="impact"&&t&&a>t.
t);if(!t||!e)return{points:0,text:"challenge.it_does_not_hop"};let s=n.events.find(({kind:r,t:a})=>r==="apex"&&a>t.t);if(!s||s.height<Bc)return{points:0,text:"c\
hallenge.the_first_hop_is"};let i=Math.abs(e.angle-2*Math.PI*Math.round(e.angle/(2*Math.PI)))/bi,o=Math.max(0,Math.round(100*(1-(i-.5)/89.5)));return{points:Math.
min(o,100),text:"challenge.it_lands_off_away",values:{off:K(i*bi)}}}},{key:"clean",title:"challenge.hop_without_skidding",text:"challenge.on_level_ground_the",start:"\
start.angle=3.141592653589793&start.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:n=>{let t=kr(n,10);
if(t)return{points:0,text:t};if(Math.abs(Math.abs(n.scenario.start.angle??0)-Math.PI)>.5*bi)return{points:0,text:"challenge.the_load_must_start"};if(n.values["p\
lane.mu_kinetic"]>1.5||n.values["plane.mu_static"]>1.5)return{points:0,text:"challenge.friction_must_be_at"};let e=Mr(n)[0];if(!e)return{points:0,text:"challeng\
e.it_does_not_hop"};let s=n.phases.filter(({from:o})=>o<e.t);if(s.some(({mode:o})=>o==="K"))return{points:0,text:"challenge.it_skids_before_it"};if(s[0]?.mode!==
"R")return{points:0,text:"challenge.it_must_start_rolling"};let i=n.events.find(({kind:o,t:r})=>o==="apex"&&r>e.t);return i?{points:Er(i.height,qc),text:"challe\
nge.it_rises_by_height",values:{height:jt(i.height)}}:{points:0,text:"challenge.it_does_not_hop"}}}],wi=n=>n>=95?3:n>=75?2:n>=40?1:0;Dt();O();var Tr="hophoop-best-",zc=n=>"★".repeat(wi(n))+"☆".repeat(3-wi(n)),ys=class{constructor({film:t,load:e,ahead:s}){this.goal=null;this.solved=new Set;
this.solutions=new Set;Object.assign(this,{film:t,load:e,ahead:s}),this.tabs=new Map(yi.map(i=>[i.key,u("button",{type:"button","aria-pressed":"false",onclick:()=>this.
choose(i)},i.title)])),this.text=u("p",{}),this.meter=u("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"100","aria-label":"challenge.score"}),this.result=
u("p",{class:"challenge-result",role:"status"}),this.kept=u("p",{class:"hint"}),this.element=u("section",{class:"challenges card","aria-label":"menu.challenges",
hidden:!0},u("header",{},u("h2",{},"menu.challenges"),u("button",{type:"button",class:"quiet","aria-label":"challenge.leave_the_challenges",onclick:()=>this.close()},
"×")),u("div",{class:"tabs",role:"group","aria-label":"challenge.which_challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.kept,u("div",
{class:"buttons"},u("button",{type:"button",onclick:()=>this.begin()},"challenge.begin_again"),u("button",{type:"button",onclick:()=>this.solve()},"challenge.sh\
ow_a_best_one")))}open(){this.element.hidden=!1,this.choose(this.goal??yi[0]),this.element.scrollIntoView({block:"nearest"}),this.tabs.get(this.goal.key)?.focus(
{preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(t){this.goal=t;for(let[e,s]of this.tabs)s.setAttribute("aria-pressed",String(e===t.key));
L(this.text,t.text),this.changed()}begin(){this.goal&&(this.solved.delete(this.goal.key),this.load(this.goal.start))}async solve(){let{goal:t}=this;t&&(this.solved.
add(t.key),await this.load(t.best),this.solutions.add(this.film().query))}changed(){let{goal:t}=this;if(!t)return;let{points:e,text:s,values:i={}}=t.score(this.
film()),o=!this.solved.has(t.key)&&!this.solutions.has(this.film().query);this.meter.value=e;let a={key:o?"challenge.stars_points_points_what":"challenge.stars_\
points_points_shown",values:{stars:zc(e),count:e,what:{key:s,values:i}}};this.result.textContent!==U(a)&&L(this.result,a);let l=Number(ct(Tr+t.key)??0),c=o&&!this.
ahead()?Math.max(l,e):l;c>l&&mt(Tr+t.key,String(c)),L(this.kept,{key:"challenge.your_best_points_points",values:{count:c}})}};S();S();N();var Sr=.09,Uc=.03,vi=Math.PI/180,ws=Math.PI/4,Ar=2*Math.PI,Ie=n=>n-Ar*Math.round(n/Ar);function vs(n,t){let e=n.at(t),s=t===0;return{angle:Ie(e.angle),height:Math.
max(e.height,0),vx:s?e.vx:0,vy:s?e.vy:0,omega:s?e.omega:0,slope:n.slope}}var Pr=n=>2*Math.sqrt(Math.max(n.gravity,1)*n.radius),qt=n=>Number(n.toFixed(4))+0;function Lr(n,t,e){
if(n==="plane")return[["plane.slope",qt(t.slope)]];if(t.height>0)return[["start.angle",qt(t.angle)],["start.height",qt(t.height)],["start.vx",qt(t.vx)],["start.\
vy",qt(t.vy)],["start.omega",qt(t.omega)]];let s=n==="load"?t.omega*e.radius:t.vx;return[["start.angle",qt(t.angle)],["start.speed",qt(s)]]}var He=class{constructor(t,e,s,i,o){
this.grip=t;this.film=e;this.view=i;this.turned=0;this.trail=[];this.moved=0;this.before=vs(e,s),this.held={...this.before,vx:0,vy:0,omega:0};let r=e.at(s);this.
center=[r.x,e.radius+r.height],this.foot=i.point(r.x,0),this.from=this.read(o)}read(t){let[e,s]=this.view.unpoint(t.clientX,t.clientY),i=this.grip==="plane"?Math.
atan2(t.clientY-this.foot[1],t.clientX-this.foot[0]):Math.atan2(e-this.center[0],s-this.center[1]);return{x:t.clientX,y:t.clientY,along:e,away:s,turn:i}}move(t,e){
let s=this.read(t),{radius:i}=this.film;if(this.turned+=Ie(s.turn-this.from.turn-this.turned),this.grip==="plane"){let o=x(this.before.slope+this.turned,-ws,ws);
this.held.slope=Math.abs(o)<vi?0:o}else if(this.grip==="load")this.held.angle=Ie(this.before.angle+this.turned);else{let o=this.before.height+s.away-this.from.away;
this.held.height=o<Uc*i?0:o;let r=s.along-this.from.along;this.held.angle=Ie(this.before.angle+(this.held.height>0?0:r/i)),this.moved=s.x-this.from.x}for(this.trail.
push({t:e/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<e/1e3-Sr;)this.trail.shift();return this.held}release(t){let{held:e,
trail:s,film:i}=this,o=s.at(-1),r=s[0],a=o&&r?o.t-r.t:0,l=!o||a<.012||t/1e3-o.t>Sr,c=Pr(i);return l||this.grip==="plane"||(this.grip==="load"?e.omega=x((o.turned-
r.turned)/a,-c/i.radius,c/i.radius):(e.vx=x((o.along-r.along)/a,-c,c),e.vy=e.height>0?x((o.away-r.away)/a,-c,c):0)),e}};function Cr(n,t,e,s,i){let o={ArrowLeft:-1,
ArrowRight:1}[t]??0,r={ArrowDown:-1,ArrowUp:1}[t]??0;if(!o&&!r)return null;let a=e?.2:1;if(n==="load"){let h=Ie(s.angle+(o||r)*5*vi*a);return{...s,angle:h}}if(n===
"plane"){let h=x(s.slope+(o||-r)*vi*a,-ws,ws);return{...s,slope:Math.abs(h)<1e-9?0:h}}let l=Pr(i),c=x(s.height+r*.05*a*i.radius,0,4*i.radius),m=x(s.vx+o*.1*a,-l,
l);return{...s,height:c<1e-9?0:c,vx:m}}N();Ot();O();var Gc=700,xs=44,Wc=[["plane","hand.slope_of_the_plane","hand.tilt_the_plane_drag"],["hoop","hand.the_hoop_height_and","hand.lift_roll_or_throw"],[
"load","hand.angle_of_the_load","hand.turn_the_load_drag"]],ks=class{constructor(t){this.lab=t;this.pull=null;this.held=null;this.before=null;this.hint=u("div",
{class:"grip-hint","aria-hidden":"true",hidden:!0},"hand.drag_the_load");this.places=new Map(Wc.map(([o,r,a])=>[o,this.place(o,r,a)])),this.tip=u("output",{class:"\
grip-tip","aria-hidden":"true",hidden:!0}),this.element=u("div",{class:"grips",role:"group","aria-label":"hand.the_hoop_in_your"},[...this.places.values()],this.
tip,this.hint);let{flat:e,plane:s}=t.stage;e.grab=o=>this.take(o),s.addEventListener("pointermove",o=>this.hover(o)),s.addEventListener("pointerleave",()=>this.
hover(null));let i=o=>this.pull&&o.cancelable&&o.preventDefault();s.addEventListener("touchmove",i,{passive:!1}),this.settle=ut(()=>this.chosen(!1),Gc)}static{this.
Pull=He}place(t,e,s){return u("div",{class:`grip grip-${t}`,role:"slider",tabindex:"0","aria-label":e,"aria-valuenow":"0",title:s,onkeydown:i=>this.key(t,i),onblur:()=>this.
held&&this.chosen(!1)})}view(){return this.lab.stage.flat.views[this.lab.motions.active]}draw(){let{lab:t}=this,e=this.view(),s=!!e&&!t.stage.options.three;if(this.
element.hidden=!s,!s)return;this.element.classList.toggle("running",t.clock.playing);let{pose:i,film:o,scale:r}=e,a=o.radius,l=e.point(i.x,a+i.height),c=e.point(
i.x+a*Math.sin(i.angle),a+i.height+a*Math.cos(i.angle)),m=this.onPlane(e),h=x(1.1*a*r,xs,190),p=[["plane",m,xs],["hoop",l,h],["load",c,xs]];for(let[d,[f,g],_]of p){
let b=this.places.get(d);b.style.transform=`translate(${f-_/2}px, ${e.top+g-_/2}px)`,b.style.width=b.style.height=`${_}px`,b.hidden=f<0||g<0||f>e.width||g>e.height}
if(!this.hint.hidden){let[d,f]=p[2][1];this.hint.style.transform=`translate(${x(d,70,e.width-70)}px, ${e.top+Math.max(f-xs,18)}px) translate(-50%, -50%)`}t.clock.
playing||this.tell(o)}onPlane(t){let e=t.point(t.pose.x,0),i=(Math.min(e[0]+Math.max(1.9*t.film.radius*t.scale,90),t.width-30)-e[0])/(t.scale*Math.max(t.cosine,
.2));return t.point(t.pose.x+i,0)}tell(t){let e=this.pull?.held??this.held??vs(t,this.lab.clock.time),s={load:K(e.angle),hoop:P("hand.gap_height_speed_speed",{height:jt(
e.height),speed:M(e.vx,3)}),plane:K(e.slope)},i={load:e.angle*(180/Math.PI),hoop:e.height,plane:e.slope*(180/Math.PI)},o={load:[-180,180],hoop:[0,4*t.radius],plane:[
-45,45]};for(let[r,a]of this.places)a.getAttribute("aria-valuetext")!==s[r]&&(a.setAttribute("aria-valuetext",s[r]),a.setAttribute("aria-valuenow",String(Number(
i[r].toPrecision(4)))),a.setAttribute("aria-valuemin",String(o[r][0])),a.setAttribute("aria-valuemax",String(Number(o[r][1].toPrecision(4)))))}under(t){if(this.
element.hidden)return null;let e=null;for(let[s,i]of this.places){let{left:o,top:r,width:a}=i.getBoundingClientRect(),l=Math.hypot(t.clientX-o-a/2,t.clientY-r-a/
2);!i.hidden&&l<=a/2&&(e=s)}return e}hover(t){if(this.pull)return;let e=t&&t.pointerType!=="touch"?this.under(t):null;for(let[s,i]of this.places)i.classList.toggle(
"near",s===e);this.lab.stage.plane.style.cursor=e?"grab":""}take(t){let e=this.under(t);if(!e||t.button>0||this.pull)return!1;let{lab:s}=this,{flat:i,plane:o}=s.
stage,r=this.places.get(e),a=this.view(),l=o.getBoundingClientRect(),c=b=>({clientX:b.clientX-l.left,clientY:b.clientY-l.top-a.top}),m=new He(e,s.film(),s.clock.
time,a,c(t)),h=[...i.shift],[p,d]=[!1,!1];this.pull=m,r.classList.add("held");let f=()=>{d=!0,g.abort(),r.classList.remove("held"),i.fixed=null,this.pull=null,p&&
this.comeBack(h)},g=new AbortController,_=b=>{b.key==="Escape"&&(b.stopPropagation(),f(),p&&this.back())};return addEventListener("keydown",_,{capture:!0,signal:g.
signal}),J(o,t,b=>{if(!d){if(i.pinched()){f(),p&&this.back();return}!p&&Math.hypot(b.clientX-t.clientX,b.clientY-t.clientY)<3||(p||(i.fixed=a.scale,this.hold(),
this.begin()),p=!0,m.move(c(b),b.timeStamp),i.shift=[h[0]+m.moved,h[1]],this.change(e,m.held,!1),this.show(e,m.held))}},(b,y)=>{d||(f(),p&&(y?(this.change(e,m.release(
b.timeStamp),!0),this.end(!0)):this.back()))}),!0}key(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{lab:s}=this;if(e.key==="Escape"&&this.held)this.back();else if(e.
key==="Enter")this.chosen(!0);else{this.held??=vs(s.film(),s.clock.time);let i=Cr(t,e.key,e.shiftKey,this.held,s.film());if(!i)return;this.before===null&&(this.
hold(),this.begin()),this.held=i,this.change(t==="load"?"hoop":t,i,!1),this.show(t,i),this.settle()}e.preventDefault(),e.stopPropagation()}hold(){this.lab.clock.
play(!1),this.before=this.lab.film().query}begin(){let{lab:t}=this;t.stage.options.ahead=!0,t.clock.seek(0),t.mark("holding",!0)}change(t,e,s){this.lab.motions.
change(Lr(t,e,this.lab.film()),s)}show(t,e){let s={load:`θ = ${K(e.angle)}`,hoop:e.height>0?`y = ${jt(e.height)}`:`θ = ${K(e.angle)}`,plane:`β = ${K(e.slope)}`};
L(this.tip,e.vx&&this.held?`${s[t]}, v = ${M(e.vx,3)} m/s`:s[t]),this.tip.hidden=!1}chosen(t){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.
end(t)}end(t){let{lab:e}=this;this.held=null,this.before=null,this.tip.hidden=!0,e.stage.options.ahead=!1,e.mark("holding",!1),t&&e.clock.seek(0),t&&e.clock.run(),
e.request()}async back(){let{lab:t,before:e}=this;if(this.end(!1),e===null)return;let s=t.motions.lanes[t.motions.active];for(s.pending=null;s.busy;)await new Promise(
i=>requestAnimationFrame(i));try{t.motions.replace(await t.backend.film({query:e}))}catch(i){t.notice.fail(i)}}comeBack(t){let{flat:e}=this.lab.stage,s=ds(),i=()=>{
if(this.pull)return;let o=e.shift[0]-t[0];e.shift=Math.abs(o)<1||s?[...t]:[t[0]+.82*o,t[1]],this.lab.request(),e.shift[0]!==t[0]&&requestAnimationFrame(i)};i()}};var Kc={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function Q(n){let t="\
http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class",
`icon icon-${n}`);let s=document.createElementNS(t,"path");return s.setAttribute("d",Kc[n]),e.append(s),e}S();O();function xi(n,t=()=>{}){let e=u("select",{class:"language","aria-label":"language.language",onchange:async()=>{try{await oe(e.value),dr(e.value),n()}catch{
e.value=It(),t(new Error("language.not_loaded"))}}},Object.entries(ie).map(([s,i])=>u("option",{value:s,lang:s},document.createTextNode(i))));return e.value=It(),
e}var Nt=n=>`event.${n}`,Or=n=>n.kind==="takeoff"||n.to==="H"&&n.from!=="H"&&n.kind!=="impact";N();O();var Vc=new Set(v.passing),Yc=3,Xc=1e-10;function Jc(n){let t=[],e=-1,s=-1;for(let[i,{kind:o,from:r,to:a,t:l,height:c}]of n.entries())e>=0&&o==="apex"&&(s<
0||c>n[s].height)&&(s=i),!Vc.has(o)&&(e>=0&&r==="H"&&l>n[e].t&&(t.push({begin:e,top:s,end:o==="end"?-1:i}),e=s=-1),a==="H"&&o!=="end"&&([e,s]=[i,-1]));return t}
var Ms=class{constructor(t,e,s){let{larger:i=null,smaller:o=null,count:r=0}=e??{};this.events=t.events,this.count=Math.min(r,t.events.length),this.radius=t.radius,
this.side=i??o,this.step=i?s:-s,this.edge=!i||!o,this.sided=!this.edge&&(i?.sided||Qc(i,o))}rate(t,e){return this.side?this.side.rates[t*v.changes.length+_o[e]]:
Number.NaN}of(t,e){return this.step*this.rate(t,e)}get failed(){return this.side&&this.side.reason!=="none"?this.side.failed:-1}hops(){return Jc(this.events.slice(
0,this.count)).map(({begin:t,top:e,end:s})=>{let i=o=>s<0?Number.NaN:this.step*(this.rate(s,o)-this.rate(t,o));return{begin:t,end:s,height:this.of(e<0?t:e,"heig\
ht"),distance:i("x"),duration:i("t")}})}};function Qc(n,t){return n!==t&&(n?.rates.some((e,s)=>Number.isFinite(e)!==Number.isFinite(t?.rates[s]))??!1)}function Fr(n,t){
let e=Math.abs(n);if(t==="°")return j(M(e*180/Math.PI,3),"°");let s=e<.0995,i=e<9995e-8,[o,r]=s?i?[1e6,"µ"]:[1e3,"m"]:[1,""];return t==="m/s"?j(M(e,3),t):j(M(
o*e,3),`${r}${t}`)}var Es=(n,t)=>Math.abs(n)>Xc*Math.max(t,.001);function Ir(n,t){return Number.isFinite(n)?Es(n,1)?`${n>0?"+":"−"}${Fr(n,t)}`:"0":"–"}function ki(n){
let t=n.filter(([e])=>Number.isFinite(e)&&Es(e,1)).map(([e,s,i,o])=>({key:e>0?i:o,values:{amount:Fr(e,s)}}));return t.length?at(t):null}var Nr=["m","sensitivity\
.amount_further_to_the","sensitivity.amount_further_to_the_left"],Zc=["s","sensitivity.amount_later","sensitivity.amount_earlier"];function Hr(n){let{events:t,count:e}=n,
s=[],i=n.hops();for(let[a,{begin:l,end:c,height:m,distance:h,duration:p}]of i.slice(0,Yc).entries()){let d=c>=0&&t[c].x<t[l].x?-h:h,f=ki([[m,"m","sensitivity.am\
ount_higher","sensitivity.amount_lower"],[d,"m","sensitivity.amount_longer","sensitivity.amount_shorter"],[p,"s","sensitivity.amount_more_in_the","sensitivity.a\
mount_less_in_the"],[n.of(l,"t"),"s","sensitivity.begins_amount_later","sensitivity.begins_amount_earlier"]]);f&&s.push(i.length>1?{key:"sensitivity.hop_number_\
list",values:{number:a+1,list:f}}:{key:"sensitivity.the_hop_list",values:{list:f}})}let o=i.length?-1:t.findIndex(({kind:a},l)=>l<e&&a!=="start"&&a!=="end");if(o>=
0){let a=ki([[n.of(o,"t"),...Zc],[n.of(o,"x"),...Nr]]);a&&s.push({key:"sensitivity.the_first_event_what",values:{what:Nt(t[o].kind),list:a}})}let r=e-1;if(r>0&&
t[r].kind==="end"){let a=Math.sign(t[r].vx)*n.of(r,"vx"),l=ki([[n.of(r,"x"),...Nr],[a,"m/s","sensitivity.amount_faster","sensitivity.amount_slower"]]);l&&s.push(
{key:"sensitivity.at_the_end_after",values:{time:M(t[r].t,4),list:l}})}return s}S();N();var Xt=E.words.signs,Ts=Object.keys(Xt);function $r(n,t=11){let s=[...n.filter(({kind:o})=>o in Xt)].sort((o,r)=>Ts.indexOf(o.kind)-Ts.indexOf(r.kind)||o.x-r.x),
i=[];for(let{kind:o,x:r}of s){let a=Ts.indexOf(o)<Ts.indexOf("takeoff"),l=i.filter(c=>Math.abs(c.x-r)<t);l.length?l.length===1&&l[0].rare&&!i.some(c=>Math.abs(c.
x-(l[0].x+t))<t-1e-9)?l[0].mark!==Xt[o]&&i.push({mark:Xt[o],x:l[0].x+t,rare:!1,hidden:0}):l[0].hidden+=1:i.push({mark:Xt[o],x:r,rare:a,hidden:0})}return i.sort(
(o,r)=>o.x-r.x).map(({mark:o,x:r})=>({mark:o,x:r}))}function Dr(n,t,e){let s=[],i=new Map,o=-1,r=(l,c,m)=>{let h=s.at(-1);h&&h.mode===l&&Math.abs(h.from+h.wide-
c)<1e-6?h.wide+=m:s.push({mode:l,from:c,wide:m})},a=()=>{i.size&&r([...i].reduce((l,c)=>c[1]>l[1]?c:l)[0],o,1),i=new Map};for(let{mode:l,from:c,to:m}of n){let[h,
p]=[Math.max(t(c),0),Math.min(t(m),e)];if(p>h)for(let d=h;d<p-1e-9;){if((Math.floor(d+1e-9)!==o||!i.size)&&(a(),o=Math.floor(d+1e-9),p-d>=1&&Math.abs(d-o)<1e-6)){
let g=Math.floor(p-d+1e-9);r(l,o,g),d=o+g;continue}let f=Math.min(p,o+1);i.set(l,(i.get(l)??0)+f-d),d=f}}return a(),s}var jr=.7,qr=34,tm=3,em=400,sm=8,Mi=13;function Br(n){let{events:t,count:e}=n;return t.slice(0,Math.min(e,em)).map(({kind:s,x:i,height:o},r)=>({kind:s,x:i,y:o,dx:n.
of(r,"x"),dy:n.of(r,"height")}))}function zr(n,t,e){let s=n.map(({dx:a,dy:l})=>Math.hypot(a,l)).filter(a=>Number.isFinite(a)&&Es(a,t)).sort((a,l)=>a-l);if(!s.length)
return 0;let i=Math.max(jr*t,qr/e)/s[Math.floor(s.length/2)];if(i<=1)return 1;let o=10**Math.floor(Math.log10(i)),r=i/o;return(r>=5?5:r>=2?2:1)*o}function Ur(n,t,e){
let s=[],i=tm*Math.max(jr*n.film.radius,qr/n.scale);for(let{kind:o,x:r,y:a,dx:l,dy:c}of t){let m=Number.isFinite(l)&&Number.isFinite(c),h=m?e*Math.hypot(l,c):0,
p=h>i?i/h:1,d=m?[p*e*l,p*e*c]:[0,0],f=n.point(r,a),g=n.point(r+d[0],a+d[1]);if(Math.max(f[0],g[0])<-20||Math.min(f[0],g[0])>n.width+20)continue;let[_,b]=[Math.min(
f[0],g[0])-12,Math.max(f[0],g[0])+12],y=f[1];for(;s.some(k=>Math.abs(k.base-y)<Mi-1&&k.low<b&&k.high>_);)y-=Mi;if(f[1]-y>sm*Mi)continue;s.push({low:_,high:b,base:y});
let w=y-f[1];nm(n,f,[g[0],g[1]+w],w,{known:m,broken:p<1,mark:Xt[o]??""})}}function nm({context:n,look:t},e,s,i,{known:o,broken:r,mark:a}){let l=[e[0],e[1]+i],c=Math.
hypot(s[0]-l[0],s[1]-l[1]),[m,h]=c>0?[(s[0]-l[0])/c,(s[1]-l[1])/c]:[1,0],p=Math.min(9,c);for(let[f,g]of[[t.paper,6.5],[t.ink,2.5]])n.strokeStyle=f,n.fillStyle=f,
n.lineCap="round",i&&(n.lineWidth=g>3?3:1,n.beginPath(),n.moveTo(e[0],e[1]),n.lineTo(l[0],l[1]),n.stroke()),n.lineWidth=g,n.setLineDash(r?[5,6]:[]),n.beginPath(),
n.moveTo(l[0],l[1]),n.lineTo(s[0]-m*p,s[1]-h*p),n.stroke(),n.setLineDash([]),n.beginPath(),n.arc(l[0],l[1],g>3?5.5:3.5,0,2*Math.PI),n.fill(),!(c<1)&&(n.lineWidth=
g>3?4:1,n.beginPath(),n.moveTo(s[0],s[1]),n.lineTo(s[0]-m*p-h*p*.55,s[1]-h*p+m*p*.55),n.lineTo(s[0]-m*p+h*p*.55,s[1]-h*p-m*p*.55),n.closePath(),n.stroke(),n.fill());
n.lineCap="butt";let d=o?a:"?";d&&(n.font=`600 ${11*t.px}px ${t.font}`,n.textAlign="center",n.lineWidth=3,n.strokeStyle=t.paper,n.fillStyle=t.ink,n.strokeText(d,
l[0],l[1]-7),n.fillText(d,l[0],l[1]-7))}O();var Gr=Math.PI/180,im=100,Wr="plane.mu",om=/^(contact\.|duration$)/,rm=200,Ei=n=>`reason.${n}`,Ss=class{constructor(t){this.lab=t;this.on=!1;this.path=Wr;this.
changes=null;this.arrows=[];this.factor=0;this.three=!1;this.asked=null;this.known="";this.paths="";this.speak=!1;this.later=ut(()=>this.fetch(),im),this.switch=
u("button",{type:"button",class:"switch",title:"sensitivity.what_a_little_more","aria-pressed":"false",onclick:()=>this.turn()},"sensitivity.arrows"),this.picked=
u("select",{onchange:()=>this.pick(this.picked.value)}),this.step=u("span",{class:"more-step"}),this.take=u("button",{type:"button",onclick:()=>this.apply()},"s\
ensitivity.do_it"),this.said=u("ul",{class:"more-said"}),this.reason=u("p",{class:"more-reason",hidden:!0}),this.scale=u("p",{class:"hint"}),this.body=u("tbody",
{}),this.rows=u("details",{class:"more-events"},u("summary",{},"sensitivity.every_event_by_this"),u("div",{class:"table-scroll",tabindex:"0",role:"region","aria\
-label":"sensitivity.what_changes_at_every"},u("table",{},u("thead",{},u("tr",{},["sensitivity.event","column.time","sensitivity.place","sensitivity.height","se\
nsitivity.load_angle"].map(e=>u("th",{scope:"col"},e)))),this.body))),this.element=u("section",{class:"table more","aria-label":"sensitivity.what_a_little_more_\
would",hidden:!0},u("header",{},u("h2",{},"sensitivity.what_a_little_more_would"),u("button",{type:"button",onclick:()=>this.turn(!1)},"table.close")),u("div",{
class:"more-asked"},u("label",{},u("span",{},"sensitivity.a_little_more"),this.picked),this.step,this.take),this.said,this.reason,this.rows,this.scale),t.stage.
flat.over=(e,s)=>{let i=t.marked("guessing");if(!this.on||i||s!==t.motions.active)return;let o=zr(this.arrows,e.film.radius,e.scale);(o||this.arrows.some(({dx:r})=>Number.
isNaN(r)))&&Ur(e,this.arrows,o||1),o!==this.factor&&(this.factor=o,this.tellScale())}}turn(t=!this.on,e=this.path){this.on=t,this.path=e,this.element.hidden=!t,
this.switch.setAttribute("aria-pressed",String(t)),this.known="",t?this.changed(!0):this.forget(),this.lab.motions.lanes.length&&this.lab.address?.soon(),this.lab.
request()}pick(t){this.path=t,this.known="",this.changed(!0),this.lab.address?.soon()}offered(){return[...this.lab.controls.sliders.values()].filter(({info:e,element:s})=>!s.
hidden&&!om.test(e.path)).map(({info:e})=>e)}parameter(){let{values:t,scenario:e}=this.lab.film(),s=this.offered().find(({path:a})=>a===this.path);if(!s)return null;
let[i,o]=s.path.split("."),r=t[s.path]??e[i][o];return{info:s,value:Number(r==="inf"?1/0:r),step:s.step*(s.degrees?Gr:1)}}changed(t=!1){if(!this.on||(this.speak||=
t,!this.lab.motions.lanes.length))return;this.offer();let{query:e}=this.lab.film();this.known===`${this.path} ${e}`?this.tell():(this.forget(),this.later())}offer(){
let t=this.offered();t.some(({path:s})=>s===this.path)||(this.path=t.find(({path:s})=>s.startsWith(Wr))?.path??t[0].path);let e=t.map(({path:s})=>s).join();if(e!==
this.paths){this.paths=e;let s=({path:i,label:o,symbol:r})=>u("option",{value:i},o," ",r);this.picked.replaceChildren(...t.map(s))}this.picked.value=this.path}forget(){
this.asked?.abort(),this.changes=null,this.arrows=[],this.factor=0}async fetch(){if(!this.on)return;let{lab:t,path:e}=this,s=t.film(),i=this.parameter();this.asked?.
abort(),this.asked=new AbortController;let{signal:o}=this.asked;if(this.known=`${e} ${s.query}`,!i||!Number.isFinite(i.value))return this.refuse("sensitivity.it\
_is_infinite_there");try{let r=await t.backend.changes(s.scenario,e,o);if(o.aborted||t.film()!==s)return;if(!r)return this.refuse(Ei("edge"));this.changes=new Ms(
s,r,i.step),this.arrows=Br(this.changes),this.factor=0,this.tell()}catch(r){r.name!=="AbortError"&&!o.aborted&&this.refuse(et(r))}t.request()}refuse(t){this.forget(),
this.take.disabled=!0;for(let e of[this.step,this.said,this.body])e.replaceChildren();this.rows.hidden=this.scale.hidden=!0,this.reason.hidden=!1,L(this.reason,
t),this.speak&&this.lab.story.say(t),this.speak=!1,this.lab.request()}tell(){let{changes:t}=this,e=this.parameter();if(!t||!e)return;let{info:s,value:i}=e,o=c=>j(
M(s.degrees?c/Gr:c,5),s.unit),r=`${o(i)} → ${o(i+t.step)}`;this.step.textContent=r,this.take.disabled=!1,this.rows.hidden=this.scale.hidden=!1;let a=Hr(t);!a.
length&&t.failed<0&&a.push("sensitivity.nothing_no_event_moves"),this.said.replaceChildren(...a.map(c=>u("li",{},[c])));let l=this.why(t);this.reason.hidden=!l,
L(this.reason,l),this.fill(t),this.tellScale(),this.speak&&this.lab.story.say([s.label,` ${r}.`,...[...a,l].flatMap(c=>c?[" ",c]:[])]),this.speak=!1}frame(){let{
three:t}=this.lab.stage.options;this.on&&t!==this.three&&this.changes&&this.tellScale(),this.three=t}tellScale(){let{three:t}=this.lab.stage.options,e=t?"sensit\
ivity.the_arrows_are_drawn":{key:"sensitivity.the_arrows_in_the",values:{factor:M(this.factor,3)}};L(this.scale,t||this.factor?e:"")}why(t){let{failed:e,side:s,
events:i,edge:o,sided:r}=t;if(e>=0&&s){let{kind:a,t:l}=i[Math.min(e,i.length-1)];return{key:"sensitivity.from_what_at_time",values:{what:Nt(a),time:M(l,4),reason:Ei(
s.reason)}}}return!o&&!r?"":{key:"sensitivity.to_one_side_only",values:{reason:Ei(o?"edge":"sided")}}}fill(t){let e=(i,o,r)=>{let a=Ir(i,o),l=a[0]==="+"?"▲ ":
a[0]==="−"?"▼ ":"";return u("td",{"data-rate":String(r)},l&&u("span",{"aria-hidden":"true"},l),a)},s=[["t","s"],["x","m"],["height","m"],["angle","°"]];this.
body.replaceChildren(...t.events.slice(0,Math.min(t.count,rm)).map(({kind:i,t:o},r)=>u("tr",{onclick:()=>this.lab.clock.seek(o)},u("th",{scope:"row"},Nt(i),u("s\
mall",{},` ${M(o,4)} s`)),s.map(([a,l])=>e(t.of(r,a),l,t.rate(r,a))))))}apply(){let t=this.parameter();if(!t||!this.changes)return;let e=Number((t.value+this.changes.
step).toPrecision(12));this.lab.motions.change([[this.path,e]],!0)}};var As=class{constructor(t,e){this.root=t;this.show=e;this.full=!1;this.on=!1;this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener(
"fullscreenchange",this.left),this.onchange=()=>{}}async turn(t=!this.on){let{root:e}=this;if(this.on=t,e.classList.toggle("presenting",t),this.onchange(),this.
show(),!t){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await e.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};N();var Kr=.22,Vr=.03;function Yr(n,t){let e=n.at(t),s=n.mass*(n.gravity||9.81),i=e.mode==="H"||!(e.normal_force>0)?0:e.normal_force/s,o=i/(1+i),r=e.mode==="S"||
e.mode==="K",a=Math.abs(e.slip)/Math.sqrt((n.gravity||9.81)*n.radius);return{tone:o,pitch:55*(1+Math.min(i,8))**.5,hiss:r?o*x(.15+a,0,1):0}}function Xr(n,t,e){let s=Math.
sqrt(2*(n.gravity||9.81)*n.radius);return n.events.filter(({kind:i,t:o,before:r})=>i==="impact"&&r&&o>t&&o<=e).map(({before:i})=>x(Math.abs(i.vy)/s,.02,1))}function am(n){
let t=n.createBuffer(1,n.sampleRate,n.sampleRate),e=t.getChannelData(0),s=1;for(let i=0;i<e.length;i++)s=s*16807%2147483647,e[i]=2*s/2147483647-1;return t}var Ps=class{constructor(){
this.context=null;this.on=!1;this.last=0}static{this.heard=Yr}static{this.knocks=Xr}start(){let t=new AudioContext,e=t.createOscillator();e.type="triangle";let s=t.
createBufferSource();s.buffer=am(t),s.loop=!0;let i=t.createBiquadFilter();i.type="bandpass",i.frequency.value=1800,i.Q.value=.6;let[o,r]=[t.createGain(),t.createGain()];
o.gain.value=r.gain.value=0,e.connect(o).connect(t.destination),s.connect(i).connect(r).connect(t.destination),e.start(),s.start(),this.context=t,Object.assign(
this,{tone:e,low:o,high:r})}turn(t){this.on=t,t&&!this.context&&this.start(),t?this.context?.resume():this.context&&(this.set("low",0),this.set("high",0))}set(t,e){
let{gain:s}=this[t];s.setTargetAtTime(Kr*e,this.context.currentTime,Vr)}follow(t,e){if(!this.on||!this.context)return;if(!e.playing){this.set("low",0),this.set(
"high",0),this.last=e.time;return}let{tone:s,pitch:i,hiss:o}=Yr(t,e.time);if(this.set("low",s),this.set("high",.6*o),this.tone.frequency.setTargetAtTime(i,this.
context.currentTime,Vr),e.time>this.last)for(let r of Xr(t,this.last,e.time))this.knock(r);this.last=e.time}knock(t){let e=this.context,s=e.currentTime,i=e.createGain();
i.gain.setValueAtTime(2.2*Kr*Math.sqrt(t),s),i.gain.exponentialRampToValueAtTime(1e-4,s+.18);let o=e.createOscillator();o.frequency.setValueAtTime(190,s),o.frequency.
exponentialRampToValueAtTime(60,s+.15),o.connect(i).connect(e.destination),o.start(s),o.stop(s+.2)}close(){this.context?.close()}};S();N();var Ti=Math.PI/180,nt=n=>t=>t.columns[n],$e=(n,t)=>e=>e.derived(n,s=>Float64Array.from(e.t,(i,o)=>t(s,o,e))),V={time:{name:"column.time",symbol:"t",unit:"s",values:n=>n.
t},angle:{name:"column.angle",symbol:"θ",unit:"°",values:$e("degrees",({angle:n},t)=>n[t]/Ti)},turns:{name:"column.angle_within_a_turn",symbol:"column.theta_m\
od_360",unit:"°",values:$e("within",({angle:n},t)=>{let e=s=>Math.floor(n[s]/Ti/360);return t>0&&e(t)!==e(t-1)?Number.NaN:n[t]/Ti-360*e(t)})},x:{name:"column.p\
lace_of_the_centre",symbol:"x",unit:"m",values:nt("x")},height:{name:"column.gap_under_the_rim",symbol:"y",unit:"m",values:nt("height")},rise:{name:"column.heig\
ht_of_the_centre",symbol:"h_G",unit:"m",values:$e("rise",({height:n,angle:t},e,s)=>s.radius*(1+s.eccentricity*Math.cos(t[e]))+n[e])},vx:{name:"column.speed_of_t\
he_centre",symbol:"v",unit:"m/s",values:nt("vx")},spin:{name:"column.speed_of_rotation",symbol:"R θ̇",unit:"m/s",values:$e("spin",({omega:n},t,e)=>n[t]*e.radius)},
vy:{name:"column.speed_away_from_the",symbol:"ẏ",unit:"m/s",values:nt("vy")},slip:{name:"column.slip_velocity",symbol:"v_t",unit:"m/s",values:nt("slip")},omega:{
name:"column.angular_velocity",symbol:"θ̇",unit:"rad/s",values:nt("omega")},normal_force:{name:"column.normal_force",symbol:"N",unit:"N",values:nt("normal_for\
ce")},friction_force:{name:"column.friction_force",symbol:"F",unit:"N",values:nt("friction_force")},utilization:{name:"column.use_of_friction",symbol:"|F|/μN",
unit:"",values:nt("utilization")},kinetic:{name:"column.kinetic_energy",symbol:"W_k",unit:"J",values:nt("kinetic")},potential:{name:"column.potential_energy",symbol:"\
W_p",unit:"J",values:nt("potential")},total:{name:"column.total_energy",symbol:"W",unit:"J",values:$e("total",({kinetic:n,potential:t},e)=>n[e]+t[e])},friction_loss:{
name:"diagram.lost_to_friction",symbol:"W_f",unit:"J",values:nt("friction_loss")},normal_loss:{name:"diagram.lost_in_impacts_normal",symbol:"W_i",unit:"J",values:nt(
"normal_loss")},rolling_resistance:{name:"diagram.lost_to_rolling_resistance",symbol:"W_r",unit:"J",values:nt("rolling_resistance")}},Jr=({name:n,symbol:t})=>[n,
" ",t];O();var lm=["time","angle","x","vx","spin","normal_force","friction_force"],hm=[1,.5,.2,.1,.05,.02,.01],Si=601;function Qr(n,t,e){let s=Math.min(Math.floor(n.duration/
e+1e-9)+1,Si),i=[];for(let o=0;o<s;o++){let r=Number((o*e).toPrecision(12));i.push({time:r,mode:n.at(r).mode,values:t.map(a=>cm(n,a,r))})}return i}function cm(n,t,e){
return V[t].values(n.moment(e))[0]}var Ls=class{constructor({film:t,clock:e,names:s}){this.rows=[];this.columns=[...lm];this.source=t,this.clock=e,this.names=s,
this.step=u("select",{onchange:()=>this.fill()},hm.map(i=>u("option",{value:String(i)},`${i} s`))),this.step.value="0.1",this.picks=u("div",{class:"table-picks"},
Object.entries(V).filter(([i])=>i!=="time").map(([i,{name:o}])=>this.pick(i,o))),this.caption=u("caption",{}),this.head=u("thead",{}),this.body=u("tbody",{}),this.
element=u("section",{class:"table","aria-label":"table.table_of_the_motion",hidden:!0},u("header",{},u("h2",{},"table.table"),u("label",{class:"table-step"},u("\
span",{},"table.every"),this.step),u("button",{type:"button",onclick:()=>this.save()},"table.save_as_csv"),u("button",{type:"button",onclick:()=>this.open(!1)},
"table.close")),u("details",{class:"table-columns"},u("summary",{},"table.columns"),this.picks),u("div",{class:"table-scroll",tabindex:"0",role:"region","aria-l\
abel":"table.table_of_the_motion_rows"},u("table",{},this.caption,this.head,this.body)))}pick(t,e){let s=u("input",{type:"checkbox",checked:this.columns.includes(
t),onchange:()=>{let i=new Set(this.columns);s.checked?i.add(t):i.delete(t),this.columns=Object.keys(V).filter(o=>i.has(o)),this.fill()}});return u("label",{},s,
u("span",{},e))}open(t){this.element.hidden=!t,t&&(this.draw(this.source()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.
focus())}draw(t){this.element.hidden||(this.film=t,this.fill())}fill(){let{film:t,columns:e}=this,s=Number(this.step.value),i=this.names(),o=e.map(c=>V[c]);this.
head.replaceChildren(u("tr",{},o.map(({name:c,symbol:m,unit:h})=>u("th",{scope:"col",title:c},m,h&&u("small",{},` ${h}`))),u("th",{scope:"col"},"table.mode")));
let r=Qr(t,e,s);this.rows=r.map(({time:c,mode:m,values:h})=>({time:c,row:u("tr",{onclick:()=>this.clock.seek(c)},h.map((p,d)=>d===0?u("th",{scope:"row"},M(p,4)):
u("td",{},M(p,4))),u("td",{class:"table-mode"},i[m]))})),this.body.replaceChildren(...this.rows.map(({row:c})=>c));let a=t.duration/s+1<=Si+1e-6,l={key:"table.t\
he_first_count_rows",values:{count:Si}};L(this.caption,a?t.summary:[t.summary," ",l]),this.cursor(this.clock.time)}cursor(t){if(this.element.hidden||!this.rows.
length)return;let e=Number(this.step.value),s=this.rows[Math.min(Math.round(t/e),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.
add("now"),this.now=s)}save(){let{film:t,columns:e}=this,s=[...e.map(o=>`${P(V[o].name)} [${V[o].unit||"1"}]`),P("table.mode")],i=Qr(t,e,Number(this.step.value)).
map(({mode:o,values:r})=>[...r,o].join(","));le(new Blob([[s.join(","),...i,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};S();S();var mm=[["keys.space","keys.play_pause"],["← →","keys.one_frame"],["keys.shift","keys.previous_next_event"],["h  l","keys.next_flight_landing"],["[ ]","\
keys.slower_faster"],["keys.home_end","keys.start_end"],["t f c w","keys.traces_forces_rim_speed"],["a","keys.arrows_what_a_little"],["3","keys.in_space"],["+ −\
 0","keys.zoom_zoom_back"],["keys.esc","keys.leave_a_field_a"],["keys.z_y_ctrl_z","keys.undo_redo"],["d","keys.dark_light"],["p","keys.python"]],um=[["R","mode.\
roll","keys.the_rim_does_not"],["S","mode.spin","keys.slip_the_rim_turns"],["K","mode.skid","keys.slip_the_rim_slides"],["H","mode.flight","keys.the_hop_from_ta\
ke"],["M","mode.skim","keys.a_massless_rim_that"]],pm=[["▲ ▼","keys.take_off_landing"],["•","event.apex"],["↺","event.turn"],["◆ ◇","keys.painleves_\
paradox_no_solution"],["✖","event.jam"],["✚","example.kane"],["≋","keys.bounces_without_number_end"],["◗ ■","keys.skimming_begins_rest"]],Ai=(n,t,e=()=>!1)=>u(
"table",{},u("caption",{},n),t.map(([s,...i])=>u("tr",{},u("th",{scope:"row"},e(s),s),i.map(o=>u("td",{},o))))),Pi=()=>document.querySelector("meta[name=hophoop\
-docs]")?.content;function Zr(n,t){let e=Pi(),s=(a,l)=>u("a",{href:a,target:"_blank",rel:"noopener"},l),i=(a,...l)=>[u("dt",{},a),u("dd",{},l)],o=t&&s(new URL("\
licences.txt",import.meta.url).href,"keys.licences_of_all_that"),r=u("dialog",{class:"about","aria-label":"menu.about_hophoop"},u("h2",{},"menu.about_hophoop"),
u("p",{},"keys.hophoop_computes_exactly_how"),u("dl",{},i("keys.version",document.createTextNode(n)),i("keys.licence",document.createTextNode("MIT"),...o?[". ",
o]:[]),i("keys.documentation",e?s(e,"keys.the_documentation"):"keys.docs_index_md_in"),i("keys.commands",u("code",{},document.createTextNode("hophoop --help")))),
u("button",{type:"button",class:"close",onclick:()=>r.close()},"table.close"));return r}function ta(n,t,e){let s=u("dialog",{class:"help","aria-label":"keys.key\
s_and_help"},u("h2",{},"player.the_hoop"),u("p",{},"keys.a_ring_with_a"),Ai("keys.modes",um,i=>u("i",{class:"dot",style:`background:${t.modes[i]}`})),Ai("keys.m\
arks_on_the_bar",pm),Ai("keys.keys",mm),e,u("button",{type:"button",class:"link",onclick:()=>n.showModal()},"menu.about_hophoop"),u("button",{type:"button",class:"\
close",onclick:()=>s.close()},"table.close"));return s}var ea="hoop.radius=0.4&duration=1.5&start.speed=",dm=[["0","teach.show_the_hoop_at","duration=2"],["3","teach.everybody_predicts_where_the",null],["7","teach.e\
nergy_on_the_way","start.speed=0.1&duration=8"],["17","teach.lift_at_the_top","start.speed=3.7&duration=2"],["24","teach.the_film_again_in","duration=2"],["28",
"teach.each_group_takes_one",`${ea}2.2`],["35","teach.why_what_has_to",null],["42","teach.one_sentence_each_the",null]],fm=[["teach.the_load_pulls_the","teach.o\
nly_if_it_is"],["teach.it_hops_at_the","teach.there_the_floor_pushes"],["teach.nothing_can_be_faster","teach.the_ring_can_it"],["teach.friction_always_brakes","\
teach.it_acts_against_slip"],["teach.more_friction_more_hop","teach.there_is_a_best"],["teach.a_heavier_hoop_behaves","teach.only_the_shares_of"]],gm=["teach.be\
fore_the_film_where","teach.the_hoop_gets_only","teach.while_a_wheel_rolls","teach.how_fast_is_a","teach.find_the_force_of","teach.in_the_lab_what","teach.find_\
the_smallest_speed","teach.at_2_2_m"],_m=["1.0","1.3","1.6","1.9","2.2","2.3"];function sa(n,t){let e=m=>{c.close(),n(m)},s=(m,h="teach.show")=>u("button",{type:"\
button",class:"link",onclick:()=>e(m)},h),i=Pi(),o=i&&[["teach/index.html","teach.teaching_with_the_hoop"],["teach/worksheet.html","teach.worksheet"],["teach/so\
lutions.html","teach.solutions"],["teach/exercises.html","teach.exercises"]],r=u("table",{},u("caption",{},"teach.a_lesson_of_45"),u("thead",{},u("tr",{},["teac\
h.minute","motion.what_happens","teach.motion"].map(m=>u("th",{scope:"col"},m)))),u("tbody",{},dm.map(([m,h,p])=>u("tr",{},u("th",{scope:"row"},m),u("td",{},h),
u("td",{},p===null?"":s(p)))))),a=u("table",{},u("caption",{},"teach.what_students_often_think"),u("thead",{},u("tr",{},["teach.idea","teach.what_is_right"].map(
m=>u("th",{scope:"col"},m)))),u("tbody",{},fm.map(([m,h])=>u("tr",{},u("td",{},m),u("td",{},h))))),l=u("section",{class:"sheet"},u("h3",{},"teach.worksheet_the_\
hoop_that"),u("p",{},"teach.a_thin_ring_of"),u("ol",{},gm.map(m=>u("li",{},m,u("div",{class:"answer-line"})))),u("table",{class:"sheet-table"},u("thead",{},u("t\
r",{},["v₀ [m/s]","teach.phases","teach.does_it_hop","teach.at_which_angle"].map(m=>u("th",{scope:"col"},m)))),u("tbody",{},_m.map(m=>u("tr",{},u("th",{scope:"\
row"},s(`${ea}${Number(m)}`,m)),u("td",{}),u("td",{}),u("td",{})))))),c=u("dialog",{class:"teach","aria-label":"menu.for_teachers"},u("header",{},u("h2",{},"men\
u.for_teachers"),u("button",{type:"button",onclick:()=>print()},"teach.print"),u("button",{type:"button",class:"close",onclick:()=>c.close()},"table.close")),u(
"p",{},"teach.the_visit_asks_before"," ",u("button",{type:"button",class:"link",onclick:()=>{c.close(),t()}},"teach.start_the_visit")),o&&u("p",{},o.map(([m,h])=>u(
"a",{class:"teach-page",href:new URL(m,new URL(i,document.baseURI)).href},h))),r,a,l);return c}S();N();var Li=E.words.letters,bm=1/60,ym=10,na=8,wm={x:"vx",angle:"omega",height:"vy"},Jt=class{constructor(t){this.latest=null;this.pinned=null;this.sure=!0;this.
cache=new Map;this.part=null;let{header:e}=t;this.scenario=e.scenario,this.query=e.query,this.duration=e.duration,this.status=e.status,this.sequence=e.sequence,
this.fingerprint=e.fingerprint??null,this.events=e.events,this.values=e.values,this.automatic=e.automatic,this.summary=e.summary,this.story=e.story,this.shortened=
e.shortened,this.doubt=e.doubt??"",this.columns=t.arrays,this.exact=t.exact,this.samples=t.samples,this.t=t.arrays.t,this.length=this.t.length,this.radius=this.
values["hoop.radius"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=
this.scenario.plane.gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent()}wanted(t,e=0){if(this.duration<bm*this.length)return null;let s=x(
t,0,this.duration),i=Math.min(s+e,this.duration);if(this.part&&s>=this.part.t[0]&&i<=this.part.t[this.part.length-1])return null;let o=Math.max(s-.25*na,0);return[
o,Math.min(o+na+e,this.duration)]}refine(t){this.part=this.with(t),this.latest=null}with(t){let{t:e}=t,s={columns:t,t:e,length:e.length,cache:new Map,part:null,
latest:null,pinned:null,sure:!0};return Object.assign(Object.create(this),s)}pin(t,e){let s=this.with(t);this.pinned=s.one(s.index(e)),this.latest=null}one(t){return this.
with(Object.fromEntries(Object.entries(this.columns).map(([e,s])=>[e,[s[t]]])))}holding(t){let{part:e}=this;return e&&t>=e.t[0]&&t<=e.t[e.length-1]?e:this}findPhases(){
let{mode:t}=this.columns,e=[];for(let s=0;s<this.length;s++){let i=e.at(-1);i&&i.mode===Li[t[s]]?i.to=this.t[s]:e.push({mode:Li[t[s]],from:this.t[s],to:this.t[s]})}
for(let s=0;s+1<e.length;s++)e[s].to=e[s+1].from;return e.filter(s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,vy:i,omega:o}=this.columns,r={
left:1/0,right:-1/0,top:0,speed:0},a=[];for(let c=0;c<this.length;c++){Number.isFinite(t[c])&&(r.left=Math.min(r.left,t[c]),r.right=Math.max(r.right,t[c])),e[c]>
r.top&&(r.top=e[c]);let m=Math.hypot(s[c],i[c])+this.radius*Math.abs(o[c]),h=Math.floor(this.t[c]/ym);a[h]??=[],Number.isFinite(m)&&a[h].push(m)}let l=c=>c.sort(
(m,h)=>m-h)[Math.floor(.95*(c.length-1))];return r.speed=Math.max(0,...a.filter(c=>c?.length).map(l))||1,r}index(t){let e=0,s=this.length;for(;s-e>1;){let i=e+s>>
1;this.t[i]<=t?e=i:s=i}return e}pieces(){let{part:t}=this;if(!t)return[{film:this,from:0,to:this.length}];let[e,s]=[t.t[0],t.t[t.length-1]],i=this.index(e);for(;i>
0&&this.t[i]>=e;)i--;let o=this.t[i]>=e?0:i+1;return[{film:this,from:0,to:o},{film:t,from:0,to:t.length},{film:this,from:this.index(s)+1,to:this.length}]}moment(t){
let e=x(t,0,this.duration);if(this.latest?.t[0]===e)return this.latest;let{pinned:s,exact:i}=this,o=this.holding(e),r=o.index(e);return i?this.latest=this.with(
{...i(e),mode:[o.columns.mode[r]]}):s?.t[0]===e?this.latest=s:this.latest=o.t[r]===e?o.one(r):o.between(e,r),this.latest}between(t,e){let s=Math.min(e+1,this.length-
1),i=this.t[s]-this.t[e],o=i>0?(t-this.t[e])/i:0,r={};for(let[a,l]of Object.entries(this.columns)){let c=l[e],m=l[s],h=this.columns[wm[a]];a==="mode"||!Number.isFinite(
m)?r[a]=[c]:r[a]=[h?vm(c,m,h[e]*i,h[s]*i,o):c+(m-c)*o]}return Object.assign(this.with({...r,t:[t]}),{sure:!1})}at(t){let{columns:e,sure:s}=this.moment(t);return{
...Object.fromEntries(Object.entries(e).map(([o,[r]])=>[o,r])),mode:Li[e.mode[0]],digits:s?3:2}}derived(t,e){let s=this.cache.get(t)??e(this.columns);return this.
cache.set(t,s),s}};function vm(n,t,e,s,i){if(!Number.isFinite(e)||!Number.isFinite(s))return n+(t-n)*i;let o=1-i;return o*o*(1+2*i)*n+i*i*(3-2*i)*t+i*o*(o*e-i*s)}Dt();N();S();N();Ot();var Oi=n=>n-360*Math.floor(n/360);function xm(n,t){let e=Math.abs(Oi(n-t+180)-180);return Math.round(100*x(1-(e-1)/89,0,1))}function km(n,t){let e=Math.
max(...t)-Math.min(...t,0),s=t.reduce((i,o,r)=>i+Math.abs(o-n[r]),0)/t.length;return Math.round(100*x(1-2*s/(e||1),0,1))}var Mm=0;function qe(n,t,e=!1){let s=`h\
h-guess-${++Mm}`,i="",o=n.map(([r,a])=>{let l=u("input",{type:"radio",name:s,value:r,onchange:()=>{i=r,t()}});return{key:r,radio:l,row:u("label",{class:"guess-c\
hoice"},l,u("span",{},a))}});return{element:u("div",{class:"guess",role:"radiogroup","aria-label":"visit.your_guess"},o.map(({row:r})=>r)),made:()=>i!=="",judge:r=>{
for(let{key:a,radio:l,row:c}of o){l.disabled=!0;let m=e||a===r;m&&c.append(u("b",{class:"guess-right"},"✓")),c.classList.toggle("right",m)}return e||i===r?100:
0}}}var At=168,je=58,Ci=(n,t=je)=>{let e=n*Math.PI/180;return[At/2+t*Math.sin(e),At/2-t*Math.cos(e)]};function Ni(n,t){let e=0,s=!1,i=null,o=u("canvas",{class:"\
dial-canvas"}),r=u("div",{class:"guess dial",role:"slider",tabindex:"0","aria-label":n,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},o),a=()=>{
let m=getComputedStyle(r),{context:h}=Y(o,Number.parseFloat(m.width)/At||1),p=m.getPropertyValue("--ink").trim(),d=m.getPropertyValue("--soft").trim(),f=m.getPropertyValue(
"--accent").trim();h.clearRect(0,0,At,At),h.strokeStyle=d,h.fillStyle=d,h.lineWidth=1.5,h.beginPath(),h.moveTo(8,At/2+je),h.lineTo(At-8,At/2+je),h.stroke(),h.lineWidth=
4,h.beginPath(),h.arc(At/2,At/2,je,0,2*Math.PI),h.stroke(),h.font="11px system-ui, sans-serif",h.textAlign="center";for(let _ of[0,90,180,270]){let[b,y]=Ci(_,je-
28);h.fillText(`${_}°`,b,y+4)}let g=(_,b,y)=>{h.fillStyle=b,h.beginPath(),h.arc(...Ci(_),y,0,2*Math.PI),h.fill()};i!==null&&(h.strokeStyle=p,h.lineWidth=2,h.beginPath(),
h.arc(...Ci(i),12,0,2*Math.PI),h.stroke(),g(i,p,7)),g(e,s?f:d,9)},l=m=>{i===null&&(e=Oi(m),s=!0,r.setAttribute("aria-valuenow",String(Math.round(e))),r.setAttribute(
"aria-valuetext",`${Math.round(e)}°`),a(),t())},c=m=>{let h=o.getBoundingClientRect(),[p,d]=[m.clientX-h.left-h.width/2,m.clientY-h.top-h.height/2];l(Math.atan2(
p,-d)*180/Math.PI)};return r.addEventListener("pointerdown",m=>{m.preventDefault(),r.focus({preventScroll:!0}),c(m),J(r,m,c)}),r.addEventListener("keydown",m=>{
let h={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,PageUp:45}[m.key];h!==void 0&&(m.preventDefault(),m.stopPropagation(),l(e+(m.shiftKey?h/5:h)))}),
requestAnimationFrame(a),{element:r,redraw:a,made:()=>s,judge:m=>(i=Oi(m),a(),xm(e,i))}}var De=9,[St,Cs,Qt,Ri]=[34,12,12,26];function ia({label:n,unit:t,most:e},s){
let i=Array(De).fill(e/4),o=!1,r=null,a=u("canvas",{class:"sketch-canvas"}),l=i.map((y,w)=>u("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":{
key:"visit.what_with_the_load",values:{what:n,angle:`${45*w}°`}},"aria-orientation":"vertical","aria-valuemin":"0","aria-valuemax":String(e),onkeydown:k=>{let T={
ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[k.key];T&&(k.preventDefault(),k.stopPropagation(),g(w,i[w]+T*e/(k.shiftKey?100:20)))}})),c=u("div",{class:"gue\
ss sketch",role:"group","aria-label":"visit.draw_the_curve_pull"},a,l),m=()=>a.getBoundingClientRect(),h={width:0,height:0,px:1},p=y=>St+y/(De-1)*(h.width-St-Cs),
d=y=>Qt+(1-y/e)*(h.height-Qt-Ri),f=()=>{let y=getComputedStyle(c),w=Number.parseFloat(y.getPropertyValue("font-size"))/14||1,{context:k,width:T,height:C}=Y(a,w);
h={width:T,height:C,px:w};let R=A=>y.getPropertyValue(A).trim();k.clearRect(0,0,T,C),k.strokeStyle=R("--line"),k.fillStyle=R("--soft"),k.font="11px system-ui, s\
ans-serif";for(let A=0;A<De;A+=2)k.textAlign="center",k.fillText(`${45*A}°`,p(A),C-8),k.strokeRect(p(A),Qt,0,C-Qt-Ri);for(let A of[0,e/2,e])k.textAlign="right",
k.fillText(String(A),St-6,d(A)+4),k.strokeRect(St,d(A),T-St-Cs,0);k.textAlign="left",k.fillText(t,St+4,Qt+10);let q=(A,$,B)=>{k.strokeStyle=$,k.lineWidth=2.5,k.
setLineDash(B),k.beginPath(),A.forEach((ft,Wt)=>{let Xe=St+Wt/(A.length-1)*(T-St-Cs);Wt?k.lineTo(Xe,d(x(ft,0,e))):k.moveTo(Xe,d(x(ft,0,e)))}),k.stroke(),k.setLineDash(
[])};q(i,R("--accent"),[6,4]),r&&q(r,R("--ink"),[]),l.forEach((A,$)=>{A.style.transform=`translate(${w*p($)}px, ${w*d(i[$])}px)`})},g=(y,w)=>{r||(i[y]=x(w,0,e),
o=!0,l[y].setAttribute("aria-valuenow",i[y].toPrecision(3)),l[y].setAttribute("aria-valuetext",`${i[y].toPrecision(2)} ${t}`),f(),s())},_=null,b=y=>{let w=m(),[
k,T]=[y.clientX-w.left,y.clientY-w.top].map(B=>B/h.px),C=x((k-St)/(h.width-St-Cs),0,1),R=Math.round(C*(De-1)),q=e*(1-(T-Qt)/(h.height-Qt-Ri)),A=_??R,$=i[A];for(let B=Math.
min(A,R);B<=Math.max(A,R);B++)g(B,A===R?q:$+(q-$)*(B-A)/(R-A));_=R};c.addEventListener("pointerdown",y=>{y.preventDefault(),_=null,b(y),J(c,y,b)});for(let[y,w]of l.
entries())w.setAttribute("aria-valuenow",i[y].toPrecision(3));return requestAnimationFrame(f),{element:c,redraw:f,made:()=>o,judge:y=>{r=y,f();let w=(y.length-1)/
(De-1);return km(i,i.map((k,T)=>y[Math.round(T*w)]))}}}var Os=2*Math.PI,ot=(n,t)=>n.events.find(e=>e.kind===t),Rs=n=>K(n-Os*Math.floor(n/Os));function Em(n,t,e=72){let{angle:s}=n.columns,i=n.columns[t],o=[],r=0;for(let a=0;a<=
e;a++){let l=n.columns.angle[0]+Os*a/e;for(;r+1<n.length&&s[r+1]<l;)r+=1;let c=Math.min(r+1,n.length-1),m=s[c]>s[r]?Math.min((l-s[r])/(s[c]-s[r]),1):0;o.push(i[r]+
m*(i[c]-i[r]))}return o}var Tm=(n,t)=>n.t[n.columns.angle.findIndex(e=>e>=t)]??n.duration,Sm={R:"roll",S:"spin",K:"skid",H:"bounce"},Zt=[{key:"littlewood",title:"\
visit.littlewoods_question",text:"visit.a_hoop_without_mass",question:"visit.what_do_you_think",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:n=>qe(
[["roll","visit.it_rolls_on"],["hop","visit.it_hops_the_hoop"],["skim","visit.the_weight_falls_freely"]],n),until:([n])=>{let[t,e]=[ot(n,"skim"),ot(n,"impact")];
return t?t.t+.7*((e?.t??n.duration)-t.t):n.duration},answer:([n])=>{let t=ot(n,"skim")??ot(n,"takeoff");return{truth:t?.kind==="skim"?"skim":t?"hop":"roll",text:"\
visit.at_angle_there_is",values:{angle:Rs(t?.angle??0)}}},why:"visit.littlewood_said_that_the"},{key:"speed",title:"visit.a_ring_with_mass",text:"visit.now_a_qu\
arter_of",question:"visit.draw_how_fast_the",queries:["start.speed=0.1&duration=8"],guess:n=>ia({label:"visit.speed_of_the_centre",unit:"m/s",most:10},n),until:([
n])=>Tm(n,Os),answer:([n])=>{let t=Em(n,"vx");return{truth:t,text:"visit.with_the_load_at",values:{speed:M(Math.max(...t),2)}}},why:"visit.the_lowest_point_of"},
{key:"slip",title:"visit.why_it_slips",text:"visit.a_harder_push_2",question:"visit.where_is_the_load",queries:["start.speed=2.8"],guess:n=>Ni("visit.angle_of_t\
he_load",n),until:([n])=>ot(n,"slip_start")?.t??n.duration,answer:([n])=>{let t=ot(n,"slip_start"),e=n.at(t.t).normal_force/(n.mass*n.gravity);return{truth:t.angle*
180/Math.PI,text:"visit.it_begins_to_slip",values:{angle:Rs(t.angle),share:`${M(100*e,2)} %`}}},why:"visit.the_load_on_its"},{key:"hop",title:"visit.the_hop",text:"\
visit.a_little_faster_3",question:"visit.where_is_the_load_when",queries:[""],guess:n=>Ni("visit.angle_of_the_load_where",n),until:([n])=>ot(n,"takeoff")?.t??n.
duration,answer:([n])=>{let t=ot(n,"takeoff"),e=n.at(t.t-1e-6);return{truth:t.angle*180/Math.PI,text:"visit.it_takes_off_at",values:{angle:Rs(t.angle),slip:M(Math.
abs(e.slip),3)}}},why:"visit.a_rolling_hoop_would"},{key:"landing",title:"visit.the_landing",text:"visit.the_hoop_is_in",question:"visit.what_does_it_do",queries:[
""],guess:n=>qe([["roll","visit.it_rolls_at_once"],["skid","visit.it_skids_the_rim"],["spin","visit.it_spins_the_rim"],["bounce","visit.it_bounces"]],n),until:([
n])=>ot(n,"impact")?.t??n.duration,answer:([n])=>{let[t,e]=[ot(n,"takeoff"),ot(n,"impact")],s=n.events.find(i=>i.kind==="apex");return{truth:Sm[n.at((e?.t??0)+1e-6).
mode],text:"visit.it_was_in_the",values:{time:M((e?.t??0)-(t?.t??0),3),height:M(100*(s?.height??0),3),angle:Rs(e?.angle??0)}}},why:"visit.an_impact_takes_no"},{
key:"friction",title:"visit.more_friction_more_hop",text:"visit.three_hoops_get_the",question:"visit.which_of_them_hops",queries:["plane.mu=0.05","plane.mu=0.2",
""],guess:n=>qe([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],n),until:n=>.3+Math.max(0,...n.map(t=>ot(t,"impact")?.t??0)),answer:n=>{let t=n.map(o=>Math.
max(0,...o.events.map(({kind:r,height:a})=>r==="apex"?a:0))),[e,s,i]=t.map(o=>M(100*o,3));return{truth:String(t.indexOf(Math.max(...t))),text:"visit.they_rise_b\
y_low",values:{low:e,middle:s,high:i}}},why:"visit.on_ice_nothing_drives"},{key:"undecided",title:"visit.what_rigid_bodies_cannot",text:"visit.a_hoop_is_thrown",
question:"visit.what_do_they_say",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plane.mu=1.2&plane.painleve=impact&start.angle=-\
0.7&start.vx=8&start.omega=5&duration=3"],guess:n=>qe([["flight","visit.it_flies_off"],["impact","visit.an_impact_stops_the"],["both","visit.both_agree_with_the"]],
n),until:n=>Math.min(.8,...n.map(t=>t.duration)),answer:n=>({truth:n.every(t=>ot(t,"painleve_indeterminate"))?"both":"flight",text:"visit.hoop_a_and_hoop"}),why:"\
visit.painleve_found_this_in"},{key:"yours",title:"visit.your_turn",text:"visit.take_the_hoop_turn",question:"",queries:[""]}];O();var oa="hophoop-visit",Ns=class{constructor(t,e){this.lab=t;this.step=null;this.guess=null;this.films=[];this.points=new Map;this.running=!1;this.stop=null;
this.loop=null;this.asked=0;this.onchallenges=e,this.body=u("div",{class:"visit-body"}),this.said=u("div",{class:"visit-answer",role:"status"}),this.element=u("\
section",{class:"visit card","aria-label":"menu.guided_visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){
ct(oa)||(this.element.hidden=!1,L(this.said,""),this.body.replaceChildren(u("div",{class:"buttons offer"},u("p",{},u("b",{},"visit.new_here")," ","visit.eight_s\
hort_questions_guess"),u("button",{type:"button",class:"main",onclick:()=>this.start()},"teach.start_the_visit"),u("button",{type:"button",onclick:()=>this.leave()},
"visit.not_now"))))}start(){this.points.clear(),this.go(0)}leave(){mt(oa,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),
this.lab.mark("visiting",!1),this.veil(),this.lab.show()}async go(t){let e=Zt[t],s=++this.asked;this.lab.opening.end();let{lab:i}=this;i.clock.play(!1),i.clock.
time=0,this.step=e,this.stop=null,this.guess=null,this.unwind(),L(this.said,""),this.element.hidden=!1,i.mark("visiting",t<Zt.length-1);try{let o=await Promise.
all(e.queries.map(r=>i.backend.film({query:r})));if(s!==this.asked)return;this.films=o.map(r=>new Jt(r)),i.motions.active=0,i.motions.set(o.slice(0,2)),this.guess=
e.guess?.(()=>this.guessed())??null,this.veil(),i.changed(),i.motions.note(),this.fill(t)}catch(o){i.notice.fail(o)}}veil(){this.lab.mark("guessing",this.guessing),
this.guessing&&Et(this.lab.stage.element,"aria-label","visit.the_hoop_before_it")}fill(t){let e=Zt[t];this.play=u("button",{type:"button",class:"main",disabled:!!this.
guess,onclick:()=>this.show()},"visit.play"),this.running=!1,this.wait=u("span",{class:"hint visit-wait"},"visit.first_say_what_you"),this.skip=u("button",{type:"\
button",hidden:!0,onclick:()=>this.stop!==null&&this.lab.clock.seek(this.stop)},"visit.skip_to_the_answer");let s=t===Zt.length-1,i=u("h2",{tabindex:"-1"},e.title);
this.next=u("button",{type:"button",onclick:()=>this.go(t+1)},"visit.next"),this.body.replaceChildren(u("header",{},u("span",{class:"visit-count"},{key:"visit.s\
tep_number_of_all",values:{number:t+1,all:Zt.length}}),u("progress",{max:String(Zt.length),value:String(t+1),"aria-hidden":"true"}),u("button",{type:"button",class:"\
quiet","aria-label":"visit.leave_the_visit",onclick:()=>this.leave()},"×")),i,u("p",{},e.text),e.question?u("p",{class:"visit-question"},e.question):"",this.guess?.
element??"",u("div",{class:"buttons"},t>0&&u("button",{type:"button",onclick:()=>this.go(t-1)},"visit.back"),this.guess&&this.play,this.guess&&this.skip,s?u("bu\
tton",{type:"button",class:"main",onclick:()=>this.challenge()},"menu.challenges"):this.next,s&&u("button",{type:"button",onclick:()=>this.leave()},"visit.done"),
this.guess&&this.wait)),s&&this.points.size&&this.total(),i.focus({preventScroll:!0})}guessed(){this.play&&(this.play.disabled=!1),this.wait.hidden=!0}show(){let{
lab:t,step:e}=this;if(!(!e||!this.guess)){if(this.stop!==null){t.clock.play();return}this.stop=e.until?.(t.films())??t.clock.duration,this.loop??=t.clock.loop,t.
clock.loop=!1,t.clock.seek(0),t.clock.run({to:this.stop}),this.frame()}}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:t}=this.
lab;if(this.stop===null||(this.skip.hidden=!1,this.running!==t.playing&&(this.running=t.playing,L(this.play,this.running?"visit.pause":"visit.play")),t.time<this.
stop-1e-9))return;t.playing=!1;let e=this.stop;this.stop=null,this.unwind(),t.seek(e),this.judge()}judge(){let{step:t,guess:e}=this;if(!t?.answer||!e)return;let{
truth:s,text:i,values:o={}}=t.answer(this.films),r=e.judge(s);this.points.set(t.key,r),this.play.hidden=this.skip.hidden=!0,this.said.replaceChildren(u("p",{},u(
"b",{},r?{key:"visit.points_of_100_points",values:{points:r}}:"visit.not_so")," ",{key:i,values:o}),u("p",{},t.why??"")),this.veil(),this.next.classList.add("ma\
in"),this.lab.show(),this.said.scrollIntoView({block:"nearest"})}total(){let t=[...this.points.values()].reduce((e,s)=>e+s,0);this.said.replaceChildren(u("p",{},
{key:"visit.you_have_sum_of",values:{sum:t,most:100*this.points.size}}))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&
this.veil()}};O();var ra=60,Fs=class{constructor(t){this.lab=t;this.sound=new Ps;let e=()=>t.film(),s=o=>t.load(o);this.grips=new ks(t),this.present=new As(t.root,()=>t.show()),
this.challenges=new ys({film:e,load:s,ahead:()=>t.stage.options.ahead}),this.visit=new Ns(t,()=>this.challenges.open()),this.table=new Ls({film:e,clock:t.clock,
names:()=>t.theme.colors.mode_names}),this.more=new Ss(t),this.teach=sa(s,()=>this.visit.start()),this.tools=this.makeTools(),this.menu=this.makeMenu();let i=()=>{
this.spoken(),pi(t.root),t.show()};this.languages=xi(i,o=>t.notice.fail(o)),this.spoken()}makeTools(){let{clock:t}=this.lab,e=(s,i,o)=>u("button",{type:"button",
title:i,"aria-label":i,"aria-pressed":"false",onclick:o},Q(s));return this.loop=e("loop","menu.repeat",()=>{t.loop=!t.loop,this.mark()}),this.slow=e("slow","men\
u.slow_motion_a_tenth",()=>{t.speed=t.speed===.1?1:.1,t.changed(),this.mark()}),this.loud=e("sound","menu.sound_of_the_contact",()=>{this.sound.turn(!this.sound.
on),this.mark()}),this.large=e("large","menu.presentation_on_the_whole",()=>this.present.turn()),this.present.onchange=()=>this.mark(),this.mark(),u("div",{class:"\
buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:t}=this.lab;this.loop.setAttribute("aria-pressed",String(t.loop)),this.slow.setAttribute(
"aria-pressed",String(t.speed===.1)),this.loud.setAttribute("aria-pressed",String(this.sound.on)),this.large.setAttribute("aria-pressed",String(this.present.on))}makeMenu(){
let t=(s,i)=>u("button",{type:"button",onclick:()=>{e.open=!1,i()}},s),e=u("details",{class:"learn"},u("summary",{class:"button"},"menu.learn"),u("div",{class:"\
menu-body"},t("menu.guided_visit",()=>this.visit.start()),t("menu.challenges",()=>this.challenges.open()),t("sensitivity.what_a_little_more_would",()=>this.more.
turn(!0)),t("table.table_of_the_motion",()=>this.table.open(!0)),t("menu.presentation",()=>this.present.turn(!0)),t("menu.for_teachers",()=>this.teach.showModal()),
t("menu.about_hophoop",()=>this.lab.about.showModal())));return e.addEventListener("keydown",s=>{s.key!=="Escape"||!e.open||(s.stopPropagation(),e.open=!1,e.querySelector(
"summary")?.focus())}),e}spoken(){this.lab.root.lang=It(),this.lab.hosted&&(document.documentElement.lang=It(),this.titled())}titled(){let{lab:t}=this;if(!t.hosted)
return;let e=this.visit.guessing?[]:t.motions.films().map(i=>this.nameOf(i)),s=[...new Set(e)].join(" | ");document.title=s?`${s} – hophoop`:P("menu.hophoop_l\
ab_play_with")}nameOf({query:t,summary:e}){let s=this.lab.known.find(o=>o.query===t);if(s)return P(s.title);let[i]=U(e).split(/(?<=[.。])(?!\d)/u);return i.length<=
ra?i.replace(/[.。]$/u,""):`${i.slice(0,ra).replace(/[,，][^,，]*$/u,"")} …`}frame(){let{lab:t}=this;this.grips.draw(),this.sound.follow(t.film(),t.clock),
this.table.cursor(t.clock.time),this.more.frame(),this.visit.frame(),this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.more.changed(),
this.challenges.changed(),this.visit.changed(),this.titled()}close(){this.sound.close(),this.present.close()}};S();var Be=(n,t,e)=>u("button",{type:"button",title:t,"aria-label":t,onclick:e},n),Is=class{constructor(t,e,s,i){this.fresh=!1;let o=new Map;for(let a of t)o.set(a.
group,[...o.get(a.group)??[],a]);this.presets=u("select",{class:"presets","aria-label":"header.examples",onchange:()=>{let a=t.find(({key:l})=>l===this.presets.
value);this.fresh=a!==void 0,a&&i.take(a)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},u("option",{value:""},"header.examples_2"),[...o].map(([
a,l])=>u("optgroup",{label:a},l.map(({key:c,title:m})=>u("option",{value:c},m))))),this.undo=Be(Q("undo"),"header.undo_z",i.undo),this.redo=Be(Q("redo"),"header\
.redo_y",i.redo);let r=u("span",{},u("span",{class:"long"},"header.compare"),u("span",{class:"short"},Q("two")));this.compare=Be(r,"header.compare_two_hoops",i.
compare),this.compare.classList.add("full"),this.right=u("div",{class:"buttons right"},e,Be(Q("theme"),"header.dark_or_light_d",i.theme),Be("?","header.keys_and\
_help",i.help)),this.element=u("header",{class:"top"},u("h1",{},u("span",{class:"logo","aria-hidden":"true"}),u("span",{},"hophoop",u("span",{class:"long"}," ",
"header.lab"))),this.presets,u("div",{class:"buttons"},this.undo,this.redo,this.compare,s),this.right)}show(t,e){this.undo.disabled=!t.past.length,this.redo.disabled=
!t.future.length,this.compare.setAttribute("aria-pressed",String(e))}};var Am=["pointerdown","wheel"],Hs=class{constructor(t,e){this.clock=t;this.hint=e;this.touches=new AbortController}begin(t){let{signal:e}=this.touches,s=()=>this.
end();for(let i of Am)t.addEventListener(i,s,{signal:e,capture:!0,passive:!0});addEventListener("keydown",s,{signal:e,capture:!0}),this.hint.hidden=!1,this.clock.
run({once:!0})}end(){this.hint.hidden=!0,this.touches.abort()}};S();Dt();var aa="hophoop-view",Pm=new Set(["start.speed","hoop.load_fraction","plane.mu","duration"]),la=({query:n})=>[...new URLSearchParams(n).keys()].some(t=>!Pm.
has(t)),$s=class{constructor(t,e,s){this.root=t;this.hosted=e;this.changed=s;this.simple=!1;this.button=u("button",{type:"button",class:"view",hidden:!e,onclick:()=>this.
choose()}),this.more=u("p",{class:"hint beyond",hidden:!0},"shell.this_motion_has_other"," ",u("button",{type:"button",class:"link",onclick:()=>this.choose()},"\
shell.show_everything"))}get everything(){return ct(aa)==="everything"}open(t,{map:e,more:s,fingerprints:i}){let o=t.length>1||e||s||i?.some(Boolean)||t.some(la);
this.turn(this.hosted&&!this.everything&&!o)}choose(){this.turn(!this.simple),mt(aa,this.simple?"simple":"everything"),this.changed(),this.button.focus({preventScroll:!0})}turn(t){
this.simple=t,this.root.classList.toggle("simple",t),L(this.button,t?"shell.everything":"shell.simple_view");for(let e of this.root.querySelectorAll("details.gr\
oup"))t?(e.dataset.open=String(e.open),e.open=!0):e.dataset.open&&(e.open=e.dataset.open==="true")}show(t){this.more.hidden=!this.simple||!t.some(la)}};S();var Ds=class{constructor(t){this.tabs=["hoops.hoop_a","hoops.hoop_b"].map((e,s)=>u("button",{type:"button","aria-pressed":"false",onclick:()=>t(s)},e)),this.
bar=u("div",{class:"tabs",role:"group","aria-label":"hoops.which_hoop_the_controls",hidden:!0},this.tabs),this.text=u("p",{class:"preset-text"}),this.element=u(
"div",{class:"lanes"},this.bar,this.text)}show(t,e){this.bar.hidden=t<2;for(let[s,i]of this.tabs.entries())i.setAttribute("aria-pressed",String(s===e))}};S();Dt();var ha="hophoop-single-keys",Lm=(n,t)=>({" ":()=>n.clock.play(),ArrowLeft:()=>t?n.transport.jump(-1):n.transport.nudge(-1),ArrowRight:()=>t?n.transport.
jump(1):n.transport.nudge(1),Home:()=>n.clock.seek(0),End:()=>n.clock.seek(n.clock.duration),h:()=>n.transport.jump(1,"takeoff"),l:()=>n.transport.jump(1,"impac\
t"),"[":()=>n.clock.faster(-1),"]":()=>n.clock.faster(1),t:()=>n.toggle("traces"),f:()=>n.toggle("forces"),c:()=>n.toggle("speed"),a:()=>n.extras.more.turn(),w:()=>n.
toggle("whole"),3:()=>n.toggle("three"),"+":()=>n.stage.zoom(1.25),"=":()=>n.stage.zoom(1.25),"-":()=>n.stage.zoom(.8),0:()=>n.stage.zoom(0),z:()=>n.travel(-1),
y:()=>n.travel(1),d:()=>n.theme.toggle(),p:()=>n.share.code(),"?":()=>n.help.showModal()});function Cm(n,t){let e=t.key.toLowerCase();t.altKey||!(e==="z"||e==="\
y")||(t.preventDefault(),n.travel(e==="y"||t.shiftKey?1:-1))}function Rm(n){let t=n.share.menu;t.open&&(t.open=!1,t.querySelector("summary")?.focus())}var js=class{constructor(t){
this.on=!t||ct(ha)!=="off";let e=u("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=e.checked,t&&mt(ha,this.on?"on":"off")}});this.element=u("labe\
l",{class:"check"},e,"keys.single_keys_letters_digits")}};function Om(n,t){let e=t.target;if(n.root.querySelector("dialog[open]"))return;if(t.key==="Escape"){Rm(
n);return}if(e.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(t.ctrlKey||t.metaKey){Cm(n,t);return}if(t.altKey||e.matches?.("select")&&
!(t.key===" "&&n.header.fresh)||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary, input[type=ch\
eckbox]")||!n.singleKeys.on&&t.key!==" "&&t.key.length===1)return;let i=Lm(n,t.shiftKey)[t.key];i&&(t.preventDefault(),i())}function ca(n,t){let e=t?document:n.
root,s=i=>{Om(n,i),t||i.stopPropagation()};return e.addEventListener("keydown",s),()=>e.removeEventListener("keydown",s)}S();S();function ma(n,t){let e=u("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([i])=>{let o=!i.isIntersecting&&i.boundingClientRect.top<0;if(o===
n.classList.contains("stuck"))return;let r=n.offsetHeight;n.style.marginBottom="",n.classList.toggle("stuck",o),o&&(n.style.marginBottom=`${r-n.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=o?`${n.offsetHeight}px`:"",t()});return s.observe(e),{edge:e,close:()=>s.disconnect()}}function ua(n,t){n.classList.add("hophoop"),n.dir="ltr",!t&&(n.classList.add("embedded"),n.dataset.lmSuppressShortcuts="true",n.dataset.pSuppressShortcuts="true")}
function pa(n,t){let{root:e,notice:s,hosted:i,extras:o,transport:r,header:a}=n,l=g=>!t||t.includes(g),c=[o.visit.element,o.challenges.element],m=u("aside",{class:"\
side","aria-label":"page.parameters"},...c,n.hoops.element,s.message,n.controls.element,n.view.more);r.row.append(o.more.switch),r.row.before(o.tools),a.right.prepend(
o.menu,o.languages);let h=u("div",{class:"player"},o.grips.element,n.stage.element,n.timeline.element,r.element),p=i?ma(h,()=>n.request()):null,d=u("div",{class:"\
middle"},p?.edge,!l("controls")&&c,h,o.more.element,o.table.element,u("div",{class:"words"},n.story.element,l("theory")&&n.theory.element),l("map")&&n.map.element),
f=u("div",{class:"why"},l("plots")&&n.plots.element,l("plots")&&n.phase.element);return e.replaceChildren(u("div",{class:"page"},i&&Nm(n.timeline.element),a.element,
u("div",{class:"columns"},l("controls")&&m,d,f)),s.toast,n.share.dialog,n.help,n.about,o.teach),e.addEventListener("pointerdown",({target:g})=>{for(let _ of[n.share.
menu,o.menu])_.contains(g)||(_.open=!1)}),e.classList.toggle("no-controls",!l("controls")),{player:h,sticky:p}}function Nm(n){n.id="hh-player";let t=u("a",{class:"\
skip button",href:"#hh-player"},"page.skip_to_the_player");return t.onclick=e=>{e.preventDefault(),n.focus()},t}S();O();var ze=({font:n})=>`11px ${n}`;function ce(n,t,{left:e,top:s,box:i},{across:o,up:r,lines:a=!1,middle:l=!1}){let c=s+i.height,m=e+i.width;n.save(),n.font=ze(
t),n.strokeStyle=a?t.line:t.soft,n.fillStyle=t.soft,n.lineWidth=1,a||n.strokeRect(e+.5,s+.5,i.width-1,i.height-1),n.textAlign="right",n.textBaseline="middle";for(let{
at:h,text:p,strong:d}of r.marks)a&&(n.globalAlpha=d?1:.55,da(n,[e,Math.round(h)+.5],[m,Math.round(h)+.5]),n.globalAlpha=1),n.fillText(p,e-6,h);n.textBaseline="a\
lphabetic",n.textAlign="center";for(let{at:h,text:p}of o.marks)da(n,[h,c],[h,c+4]),n.fillText(p,h,c+15);l?n.fillText(o.name,e+.5*i.width,c+30):(n.textAlign="rig\
ht",n.fillText(o.name,m,c+27)),n.translate(11,s+.5*i.height),n.rotate(-Math.PI/2),n.textAlign="center",n.fillText(r.name,0,0),n.restore()}function da(n,t,e){n.beginPath(),
n.moveTo(...t),n.lineTo(...e),n.stroke()}var fa=(n,t)=>t?`${P(n)} [${t}]`:P(n);N();O();var Fi=62,Fm=20,Im=10,ga=40,_a=12,Ue=10,Hm=36,ba=Math.PI/180,Pt=["x","y"],qs=class{constructor(t){this.paths={x:"start.speed",y:"plane.mu"};this.known=new Map(
t.map(e=>[e.path,e])),this.windows={x:this.whole("x"),y:this.whole("y")},this.left=Fi}info(t){return this.known.get(this.paths[t])}whole(t){return[...this.info(
t).range]}home(){for(let t of Pt)this.windows[t]=this.whole(t)}choose(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t]),this.paths[t]=
e,this.home()}asked(t,e){let[s,i]=this.windows[t];return{path:this.paths[t],from:s,to:i,cells:e}}bounds(t){let{range:e,allowed:s}=this.info(t),i=2*(e[1]-e[0]);return[
Math.max(s[0],e[0]-i),Math.min(s[1],e[1]+i)]}zoom(t,e){let s={x:[],y:[]};for(let i of Pt){let[o,r]=this.windows[i],a=e?.[i]??.5*(o+r);s[i]=te([a-(a-o)*t,a+(r-a)*
t],this.bounds(i));let l=Math.max(Math.abs(s[i][0]),Math.abs(s[i][1]),1e-9);if(s[i][1]-s[i][0]<400*Number.EPSILON*l)return!1}return Pt.every(i=>s[i].every((o,r)=>o===
this.windows[i][r]))?!1:(this.windows=s,!0)}drag(t,e,s){let i=(o,r)=>te(t[o].map(a=>a+r*(t[o][1]-t[o][0])),this.bounds(o));this.windows={x:i("x",-e/this.box.width),
y:i("y",s/this.box.height)}}restore(t){if(!Pt.every(e=>this.known.has(t[e][0]))||t.x[0]===t.y[0])return!1;for(let e of Pt)this.paths[e]=t[e][0];for(let e of Pt)
this.windows[e]=te(t[e].slice(1).map(Number),this.bounds(e));return!0}isHome(){return Pt.every(t=>this.windows[t].every((e,s)=>e===this.whole(t)[s]))}middle(){let{
x:t,y:e}=this.windows;return{x:.5*(t[0]+t[1]),y:.5*(e[0]+e[1])}}fit(t,e,s=()=>0){this.box={width:t-Fi-_a,height:e-Ue-Hm};let i=this.axis("y",this.box.height/ga).
marks.map(({text:o})=>s(o));this.left=Math.max(Fi,Math.ceil(Fm+Im+Math.max(0,...i))),this.box.width=t-this.left-_a}clip(t){t.beginPath(),t.rect(this.left,Ue,this.
box.width,this.box.height),t.clip()}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-e)*this.box.width}y(t){let[e,s]=this.windows.y;return Ue+(1-(t-e)/(s-
e))*this.box.height}place(t,e){let s=([i,o],r)=>i+x(r,0,1)*(o-i);return{x:s(this.windows.x,(t-this.left)/this.box.width),y:s(this.windows.y,1-(e-Ue)/this.box.height)}}deep(t){
let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.abs(e),Math.abs(s))}said(t){let e=s=>{let i=this.info(s),[o,r]=this.windows[s],a=Math.max(Math.abs(o),Math.
abs(r)),l=x(Math.ceil(Math.log10(a/(r-o)))+4,4,16);return`${P(i.label)} = ${j(M(i.degrees?t[s]/ba:t[s],l),i.unit)}`};return`${e("x")}, ${e("y")}`}draw(t,e){let{
left:s,box:i}=this,[o,r]=[this.axis("x",i.width/80),this.axis("y",i.height/ga)];ce(t,e,{left:s,top:Ue,box:i},{across:o,up:r,middle:!0})}axis(t,e){let s=this.info(
t),i=s.degrees?1/ba:1,[o,r]=this.windows[t].map(p=>p*i),a=X(r-o,e),l=this.deep(t),c=l?Number((.5*(o+r)).toPrecision(12)):0,m=l?_t(o-c,r-c,e).map(p=>p+c):_t(o,r,
e),h=l?` − ${String(c).replace("-","−")}`:"";return{marks:m.map(p=>({at:this[t](p/i),text:l?M(p-c,3):pt(p,a)})),name:`${P(s.label)}${h}${s.unit?` [${s.unit}\
]`:""}`}}};function te([n,t],[e,s]){let i=Math.min(t-n,s-e);return n<e?[e,e+i]:t>s?[s-i,s]:[n,t]}function Ii(n,t,e,s,i){for(let[o,r]of[[i,4],[s,1.8]])n.strokeStyle=
o,n.lineWidth=r,n.beginPath(),n.arc(t,e,7,0,2*Math.PI),n.moveTo(t-13,e),n.lineTo(t-4,e),n.moveTo(t+4,e),n.lineTo(t+13,e),n.moveTo(t,e-13),n.lineTo(t,e-4),n.moveTo(
t,e+4),n.lineTo(t,e+13),n.stroke()}N();Ot();Bt();var wa={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},va=48;function xa(n){let{body:t}=n,e=!1,s=dt(t,{zoom:(i,o)=>n.axes.box&&
n.zoom(1/i,o?Hi(n,o):n.aim()),home:()=>n.home(),keys:!0});t.addEventListener("pointerdown",i=>Bm(n,i,s,o=>e=o)),t.addEventListener("pointermove",i=>{n.axes.box&&
!e&&i.pointerType!=="touch"&&qm(n,i)}),t.addEventListener("pointerleave",()=>n.tip.hidden=!0),t.addEventListener("keydown",i=>zm(n,i))}function Hi(n,t){let e=n.
body.getBoundingClientRect(),{px:s}=n.look;return n.axes.place((t.clientX-e.left)/s,(t.clientY-e.top)/s)}function qm(n,t){n.tip.textContent=n.said(Hi(n,t)),n.tip.
hidden=!1;let e=n.body.getBoundingClientRect();n.tip.style.left=`${x(t.clientX-e.left,150,Math.max(e.width-150,150))}px`,n.tip.style.bottom=`${e.bottom-t.clientY+
16}px`}function Bm(n,t,e,s){t.preventDefault(),n.body.focus({preventScroll:!0});let i=[t.clientX,t.clientY],o={x:[...n.axes.windows.x],y:[...n.axes.windows.y]};
n.pointed=Hi(n,t);let r=!1,a=!1,l=e(),c=m=>{if(l||=e(),l)return;let[h,p]=[m.clientX-i[0],m.clientY-i[1]];a||Math.hypot(h,p)<5&&!r||(a=!r&&t.pointerType==="touch"&&
Math.abs(p)>=Math.abs(h),!a&&(r=!0,s(!0),n.tip.hidden=!0,n.axes.drag(o,h/n.look.px,p/n.look.px),n.redraw(),n.soon()))};J(n.body,t,c,(m,h)=>{h&&!r&&!a&&!l&&n.pointed&&
n.take(n.pointed),s(!1)})}function zm(n,t){let e=n.pointed??n.here()??n.axes.middle();if(n.pointed=e,wa[t.key]){let[s,i]=wa[t.key],{x:o,y:r}=n.axes.windows;n.pointed=
{x:x(e.x+s*(o[1]-o[0])/va,o[0],o[1]),y:x(e.y+i*(r[1]-r[0])/va,r[0],r[1])},n.state.textContent=n.said(n.pointed),n.say(n.said(n.pointed))}else if(t.key==="Enter")
n.take(e);else return;t.preventDefault(),t.stopPropagation(),n.redraw()}var Um=["start.height","start.vx","start.vy","start.omega"];function ka(n,t){let e="speed"in n.start;return!e&&t.includes("start.speed")?"map.of_rolling_starts_\
though":e&&t.some(s=>Um.includes(s))?"map.of_starts_in_any":""}Bt();ht();S();N();O();var Gm=Math.PI/180,Wm=12,Km=["hop_height","flight_time","energy_lost","greatest_utilization"];function Ma(n){return n.unit==="rad"?[1/Gm,"°"]:
[1,n.unit==="1"?"":n.unit]}function Vm({classes:n,what:t},e){let[s,i]=[1/0,-1/0];if(n)return[s,i];for(let o of e)o<s&&(s=o),o>i&&(i=o);return[Km.includes(t)?Math.
min(s,0):s,i]}function Ea(n){let{values:t}=n.arrays,e=n.header,{x:s,y:i,classes:o}=e,r=new ImageData(s.cells,i.cells),[a,l]=Vm(e,t),c=o?.map(({color:h})=>Rt(h));
for(let h=0;h<i.cells;h++)for(let p=0;p<s.cells;p++){let d=t[h*s.cells+p],f=4*((i.cells-1-h)*s.cells+p);if(!Number.isFinite(d))continue;let g=c&&(p+1<s.cells&&t[h*
s.cells+p+1]!==d||h+1<i.cells&&t[(h+1)*s.cells+p]!==d),_=c?c[d].map(b=>g?.72*b:b):ae[x(Math.round(255*(d-a)/(l-a||1)),0,255)];r.data.set([..._,255],f)}let m=u("\
canvas",{width:s.cells,height:i.cells});return Tt(m).putImageData(r,0,0),{picture:m,header:e,values:t,x:[s.from,s.to],y:[i.from,i.to],low:a,high:l}}function Ta(n,t){
let e=(i,o)=>i[0]>=o[0]-1e-300&&i[1]<=o[1]+1e-300;return[...n.filter(i=>!(e(i.x,t.x)&&e(i.y,t.y))),t].slice(-Wm)}function Sa({header:n,low:t,high:e,values:s}){let{
classes:i}=n;if(!i){let a=u("canvas",{width:120,height:10,style:"width:120px;height:10px"}),l=Tt(a);for(let h=0;h<120;h++)l.fillStyle=`rgb(${ae[Math.floor(255*h/
119)].join(",")})`,l.fillRect(h,0,1,10);let[c,m]=Ma(n);return[u("span",{},n.label,": ",e>=t?M(t*c,3):"map.none"," "),a,u("span",{},e>=t?j(M(e*c,3),m):""),s.some(
h=>!Number.isFinite(h))?u("span",{},u("i",{class:"blank"}),"map.none"):""]}let o=new Map;for(let a of s)o.set(a,(o.get(a)??0)+1);let r=[...o].filter(([a])=>a>=0).
sort((a,l)=>l[1]-a[1]);return[...r.slice(0,10).map(([a])=>{let{color:l,text:c}=i[a];return u("span",{},u("i",{style:`background:${l}`,"aria-hidden":"true"}),c)}),
r.length>10?u("span",{},{key:"map.and_count_more",values:{count:r.length-10}}):"",i.some(({name:a})=>n.what==="sequence"&&/[SK]/.test(a))?u("span",{class:"hint"},
"map.spin_and_skid"):""]}function Aa(n,t){for(let{header:e,values:s}of[...n].reverse()){let{x:i,y:o,classes:r}=e,a=Math.floor((t.x-i.from)/(i.to-i.from)*i.cells),
l=Math.floor((t.y-o.from)/(o.to-o.from)*o.cells);if(a<0||l<0||a>=i.cells||l>=o.cells)continue;let c=s[l*i.cells+a];if(r)return U(r[c]?.text??"map.not_allowed");
let[m,h]=Ma(e);return Number.isFinite(c)?j(M(c*m,4),h):P("map.none")}return"…"}O();var Pa=[[24,16],[72,48],[216,144]],zs=class{constructor(t,e,{take:s,say:i,changed:o}){this.backend=t;this.pointed=null;this.what="sequence";this.layers=[];this.
seen=!1;this.onmotion=s,this.say=i,this.changed=o;let r=e.controls.map_axes;this.axes=new qs(r),this.canvas=u("canvas",{class:"plot-canvas"}),this.tip=u("div",{
class:"tip",hidden:!0}),this.body=u("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"map.map_of_motions_arrow"},this.canvas,this.tip),this.
keys=u("div",{class:"map-keys"}),this.state=u("span",{class:"hint"});let a=l=>{let c=u("select",{"data-axis":l,onchange:()=>this.setAxis(l,c.value)},r.map(({path:m,
label:h})=>u("option",{value:m},h)));return c};this.selects={x:a("x"),y:a("y")},this.quantity=u("select",{"aria-label":"map.what_the_map_shows",onchange:()=>{this.
what=this.quantity.value,this.refresh()}},e.map_quantities.map(([l,c])=>u("option",{value:l},c))),this.element=u("section",{class:"map","aria-label":"map.map_of\
_motions"},u("div",{class:"map-head"},u("h2",{},"map.map"),u("label",{},"map.of",this.quantity),u("label",{},"map.across",this.selects.x),u("label",{},"map.up",
this.selects.y),u("span",{class:"buttons"},u("button",{type:"button","aria-label":"map.zoom_into_the_map",onclick:()=>this.zoom(.5,this.aim())},"+"),u("button",
{type:"button","aria-label":"map.zoom_out_of_the",onclick:()=>this.zoom(2,this.aim())},"−"),u("button",{type:"button",onclick:()=>this.home()},"map.whole_map")),
this.state),this.body,this.keys,u("p",{class:"hint"},Bs()?"map.click_to_take_that":"map.click_to_take_that_motion")),xa(this),this.soon=ut(()=>this.refresh(),140),
this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){
this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let t of Pt)this.selects[t].value=this.axes.paths[t]}setAxis(t,e){this.axes.choose(t,e),this.syncSelects(),
this.refresh()}home(){this.axes.home(),this.refresh()}key_of(t){let e=structuredClone(t);for(let s of Object.values(this.axes.paths)){let[i,o]=s.split(".");e[i]&&
delete e[i][o]}return JSON.stringify(e)}mark(t,e){this.film=t,this.look=e;let s=this.key_of(t.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){
let{paths:t,windows:e}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&t.x==="start.speed"&&t.y==="plane.mu")return;let s=i=>[t[i],...e[i]];return{what:this.
what,x:s("x"),y:s("y")}}restore(t){![...this.quantity.options].some(({value:e})=>e===t.what)||!this.axes.restore(t)||(this.quantity.value=this.what=t.what,this.
syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;
let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[["contact.model","choice.contact.model.rigid"]];this.computing=!0;let i=`${this.what}\
 ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;i!==this.kind&&(this.layers=[]),this.kind=i,this.redraw();try{for(let[o,r]of Pa){L(this.state,{key:"\
map.computing_count_motions",values:{count:o*r}});let a={x:this.axes.asked("x",o),y:this.axes.asked("y",r)},l={scenario:e,changes:s,...a,what:this.what},c=await this.
backend.map(l,t),m=Ea(c);this.layers=Ta(this.layers,m),this.keys.replaceChildren(...Sa(m));let h=ka(e,Object.values(this.axes.paths)),d={key:s.length?"map.count\
_motions_with_rigid":"map.count_motions",values:{count:o*r}};L(this.state,h?[d,"; ",h]:d),this.redraw()}this.level=Pa.length}catch(o){if(o.name==="AbortError")return;
L(this.state,et(o))}this.computing=!1}redraw(){if(!this.film)return;let{look:t}=this,{context:e,width:s,height:i}=Y(this.canvas,t.px);e.font=ze(t),this.axes.fit(
s,i,a=>e.measureText(a).width),e.clearRect(0,0,s,i),e.save(),this.axes.clip(e),e.imageSmoothingEnabled=!1;let{axes:o}=this;for(let a of this.layers){let[l,c]=a.
x.map(p=>o.x(p)),[m,h]=a.y.map(p=>o.y(p));e.drawImage(a.picture,l,h,c-l,m-h)}let r=this.here();r&&Ii(e,o.x(r.x),o.y(r.y),t.ink,t.paper),this.pointed&&Ne(this.body)&&
Ii(e,o.x(this.pointed.x),o.y(this.pointed.y),"#D55E00",t.paper),e.restore(),o.draw(e,t)}aim(){let t=Ne(this.body)&&this.pointed||this.here(),{windows:e}=this.axes;
return t&&Pt.every(i=>t[i]>=e[i][0]&&t[i]<=e[i][1])?t:void 0}here(){let t=s=>{let[i,o]=s.split(".");return this.film.values[s]??this.film.scenario[i]?.[o]},e={x:t(
this.axes.paths.x),y:t(this.axes.paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}said(t){return`${this.axes.said(t)}: ${Aa(this.layers,t)}`}take(t){
this.onmotion([[this.axes.paths.x,t.x],[this.axes.paths.y,t.y]])}zoom(t,e){this.tip.hidden=!0,this.axes.zoom(t,e)&&(this.redraw(),this.soon())}};var Us=class{constructor(){this.past=[];this.future=[];this.now=null;this.what="";this.when=-1/0}note(t,e="",s=performance.now()){let i=this.now;if(this.now=t,i===
null||Ge(i,t))return"same";let o=e!==""&&e===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=e,this.when=s,this.future=[],o?"again":(this.past.push(
i),this.past.length>500&&this.past.shift(),"step")}touch(t,e){t===this.what&&e-this.when<1e3&&(this.when=e)}written(){return JSON.stringify({past:this.past.slice(
-100),now:this.now,future:this.future.slice(-100)})}restore(t){if(!t||!this.now)return;let{past:e,now:s,future:i}=JSON.parse(t);s&&Ge(s,this.now)&&Object.assign(
this,{past:e,future:i})}holds(t){return this.now!==null&&Ge(this.now,t)}next(t){return(t<0?this.past:this.future).at(-1)??null}step(t){let[e,s]=t<0?[this.past,this.
future]:[this.future,this.past],i=e.pop();!i||!this.now||(s.push(this.now),this.now=i,this.what="")}arrive(t){if(!(this.now&&Ge(this.now,t))){for(let e of[-1,1]){
let s=e<0?this.past:this.future,i=s.length-s.findLastIndex(o=>Ge(o,t));if(!(i>s.length)){for(let o=0;o<i;o++)this.step(e);return}}Object.assign(this,{past:[],future:[],
now:t,what:""})}}},Ge=(n,t)=>JSON.stringify(n)===JSON.stringify(t);var Ym=1e-6,Gs=class{constructor(t,e){this.backend=t;this.listener=e;this.history=new Us;this.lanes=[];this.active=0;this.going=Promise.resolve()}film(t=this.active){
return this.lanes[t].film}films(){return this.lanes.map(t=>t.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([t])=>t))}name(){return this.
lanes.length>1?"AB"[this.active]:""}filmOf(t){let e=new Jt(t);return(t.exact||t.samples?null:this.backend.exact(e.scenario))?.then(i=>{Object.assign(e,i,{latest:null}),
this.listener.refined()}).catch(()=>{}),e}set(t){this.lanes=t.map(e=>({film:this.filmOf(e)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(t){
this.set(await Promise.all(t.map(e=>this.backend.film({query:e}))))}change(t,e){let s=this.lanes[this.active];s.moved=performance.now(),s.since??=s.moved,s.pending=
[...(s.pending??[]).filter(([i])=>!t.some(([o])=>o===i)),...t],s.commit||=e,s.what=t.map(([i])=>i).join(),e&&this.history.touch(s.what,s.moved),this.pump(s)}async pump(t){
if(t.busy||!this.lanes.includes(t))return;if(!t.pending){t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{t.
film=new Jt(await this.backend.film({scenario:t.film.scenario,changes:e})),this.lanes.includes(t)&&this.listener.shown(s)}catch(i){this.lanes.includes(t)&&this.
listener.failed(i,e)}finally{t.busy=!1}this.pump(t)}refine(t,e){for(let s of this.lanes){let{film:i}=s;if(s.refining||s.coarse===i)continue;let o=i.wanted(t,e),
r=!o&&e===0&&!i.moment(t).sure;!o&&!r||(s.refining=!0,this.samples(i,o??[t,t+Ym]).then(a=>{o?i.refine(a):i.pin(a,t),this.listener.refined()}).catch(()=>{s.coarse=
i}).finally(()=>{s.refining=!1}))}}async samples(t,e){return t.samples?t.samples(e):this.backend.samples(t.scenario,e)}settle(t){t.commit=!1,this.note(t.what,t.
moved),this.listener.settled()}queries(){return this.films().map(t=>t.query)}note(t,e){this.listener.noted(this.history.note(this.queries(),t,e))}replace(t){this.
lanes[this.active]={film:this.filmOf(t)},this.listener.shown(),this.note()}travel(t){return this.inTurn(async()=>{let e=this.history.next(t);e&&(await this.load(
e),this.history.step(t),await this.listener.travelled(t),this.listener.shown(),this.listener.noted("travelled"))})}arrive(t){return this.inTurn(async()=>{await this.
load(t),this.history.arrive(this.queries()),this.listener.shown(),this.listener.noted("travelled")})}inTurn(t){return this.going=this.going.then(t).then(()=>!0,
e=>(this.listener.failed(e),!1)),this.going}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.
active,1),this.active=0),this.listener.shown(),this.note()}choose(t){this.active=t,this.listener.shown(),this.listener.noted("same")}link(t=""){let s=[this.lanes.
length>1?`with=${encodeURIComponent(this.film(1).query)}`:"",t].filter(Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};S();O();var Xm=6e3,Ws=class{constructor(){this.message=u("p",{class:"message",role:"alert",hidden:!0});this.toast=u("div",{class:"toast",role:"status",hidden:!0});
this.timer=0}fail(t,e=""){let s=et(t);this.message.replaceChildren(...[s,...e?[" ",e]:[]].map(Oe)),this.message.hidden=!1,this.seen()||this.say(s,this.message.isConnected)}seen(){
let{top:t,bottom:e,height:s}=this.message.getBoundingClientRect();return this.message.isConnected&&s>0&&t>=0&&e<=innerHeight}clear(){this.message.hidden=!0}say(t,e=!1){
this.toast.setAttribute("role",e?"presentation":"status"),L(this.toast,t),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=
!0},Xm)}};ht();S();N();ht();S();N();N();O();var D=52,We=10,F=8,Ks=30;function La(n,t){if(!n.length)return[0,1];let e=Float64Array.from(n).sort(),[s,i]=[e[0],e[e.length-1]],[o,r]=[e[Math.floor(.02*e.length)],
e[Math.ceil(.98*e.length)-1]],a=Math.max(r-o,1e-12);i>r+4*a&&(i=r+.6*a),s<o-4*a&&(s=o-.6*a),s=Math.min(s,0),i=Math.max(i,0),t&&([s,i]=[-Math.max(-s,i),Math.max(
-s,i)]);let l=.06*(i-s)||1;return[s<0?s-l:s,i+l]}function Ca(n,t){let{look:e,box:s,heights:i,range:o}=t,r=Math.max(s.height/28,4);for(;_t(i[0],i[1],r).length<3&&
r<12;)r+=1;let a=X(i[1]-i[0],r),l=s.width/70,c=X(o[1]-o[0],l),{name:m,unit:h}=V[t.shared.axis];ce(n,e,{left:D,top:F,box:s},{up:{marks:_t(i[0],i[1],r).map(p=>({at:t.
y(p),text:pt(p,a),strong:Math.abs(p)<1e-9*a})),name:P(t.unit)},across:{marks:_t(o[0],o[1],l).map(p=>({at:t.x(p),text:pt(p,c)})),name:fa(m,h)},lines:!0})}O();var{letters:Jm}=E.words;function Ra(n,t,e){let s=n.length/t,i=u("canvas",{width:t,height:s}),o=new ImageData(t,s);for(let r=0;r<s;r++)for(let a=0;a<t;a++){let l=Jm[n[r*
t+a]],c=Rt(e[l]??"#6E6E6E"),m=4*((s-1-r)*t+a);o.data.set([...c,255],m)}return Tt(i).putImageData(o,0,0),i}var Qm=2;function Oa(n,t,e){let s=e.length/2,[i,o,r]=[
F,x(t.y(0),F,F+t.box.height),F+t.box.height];n.strokeStyle=Ce(t.look.dark?"#ffffff":"#000000",.28),n.lineWidth=1;for(let[a,l,c]of[[0,o,r],[s,i,o]])for(let m=0;m<
s;m++){let h=e[a+m];if(!h)continue;let p=m;for(;p<s&&e[a+p]===h;)p++;let d=t.x(m*2*Math.PI/s),f=t.x(p*2*Math.PI/s);n.save(),n.beginPath(),n.rect(d,l,f-d,c-l),n.
clip(),n.beginPath();let{height:g}=t.box;for(let _=-g;_<f-d+g;_+=7)for(let b of h===Qm?[!0,!1]:[h>0])n.moveTo(d+_,b?r:i),n.lineTo(d+_+g,b?i:r);n.stroke(),n.restore(),
m=p}}function Na(n,t){let{look:e,box:s}=t,[i,o]=t.range.map(c=>c*180/Math.PI),r=o-i>200?45:X(o-i,6),a=[];for(let c=Math.ceil(i/r-1e-9);c*r<=o+1e-9;c++)a.push(c*
r);let l=X(t.top()-t.bottom(),5);ce(n,e,{left:D,top:F,box:s},{across:{marks:a.map(c=>({at:t.x(c*Math.PI/180),text:pt(c,r)})),name:P("phase.angle_theta_within_a")},
up:{marks:_t(t.bottom(),t.top(),5).map(c=>({at:t.y(c),text:pt(c,l)})),name:"θ̇ [rad/s]"}})}S();var Vs={solid:[],dash:[6,4],dot:[2,3],long:[14,4],mixed:[8,3,2,3]};function Ys(n,t="solid"){let e=u("i",{class:"swatch","aria-hidden":"true"});if(e.style.borderTopColor=
n??"var(--ink)",e.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted",long:"none",mixed:"none"}[t],t==="long"||t==="mixed"){let s=0,i=Vs[t].map((o,r)=>(s+=
o,`${r%2?"transparent":n??"var(--ink)"} ${s-o}px ${s}px`));e.style.height="2.5px",e.style.width="28px",e.style.background=`repeating-linear-gradient(90deg, ${i.
join(", ")})`}return e}Bt();var Xs=class{constructor(t,e,s){this.backend=t;this.clock=e;this.colors=s;this.canvas=u("canvas",{class:"plot-canvas"});this.over=u("canvas",{class:"plot-c\
anvas plot-over"});this.keys=u("div",{class:"plot-keys"});this.hatched=u("span",{hidden:!0},"phase.hatched"," ");this.asked="";this.body=u("div",{class:"plot-bo\
dy",role:"figure",tabindex:"0","aria-label":"phase.plane_of_angle_and"},this.canvas,this.over),this.element=u("section",{class:"phase"},u("header",{},u("h3",{},
"phase.plane_of_theta_and"),this.keys),this.body,u("p",{class:"hint"},"phase.colours"," ",this.hatched,Bs()?"phase.click_to_go_there":"phase.click_to_go_there_o\
nce")),this.body.addEventListener("pointerdown",i=>this.seek(i)),this.pinched=dt(this.body,{zoom:(i,o)=>this.box&&this.zoomAbout(o?this.point(o):this.middle(),1/
i),home:()=>this.home(),keys:!0}),this.range=[0,2*Math.PI],this.soon=ut(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),i=JSON.stringify([t.hoop,t.plane,
s]);if(i!==this.asked){let o=await this.painted(t,[0,2*Math.PI,-s,s],e);this.asked=i,this.pictures=[o],this.redraw()}this.window&&await this.sharpen()}async sharpen(){
if(this.sharpening?.abort(),!(!this.pictures||this.isWhole())){this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,
[...this.range,this.bottom(),this.top()],this.sharpening.signal);this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){
let{modes:i,paradox:o}=await this.backend.regions(t,e,s);return s?.throwIfAborted(),{window:e,paradox:o,picture:Ra(i,o.length/2,this.colors.modes)}}reach(){return this.
reached}findReach(){let t=0;for(let s of this.films??[]){let i=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(t,i[Math.floor(
.99*(i.length-1))]??0)}let e=X(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}home(){this.range=[0,2*Math.PI],this.window=null,this.wholeAgain(),
this.redraw()}isWhole(){let[t,e]=this.range;return e-t>=2*Math.PI-1e-9&&(!this.window||this.window[1]-this.window[0]>=2*this.reach()-1e-9)}wholeAgain(){this.sharpening?.
abort(),this.pictures?.splice(1)}point(t){let e=this.body.getBoundingClientRect(),s=((t.clientX-e.left)/this.look.px-D)/this.box.width,i=1-((t.clientY-e.top)/this.
look.px-F)/this.box.height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+i*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.
range[1]),.5*(this.bottom()+this.top())]}zoomAbout([t,e],s){let i=Math.max(t-(t-this.range[0])*s,0),o=Math.min(t+(this.range[1]-t)*s,2*Math.PI),r=this.reach(),a=Math.
max(e-(e-this.bottom())*s,-r),l=Math.min(e+(this.top()-e)*s,r);this.range=[i,o],this.window=[a,l],this.isWhole()?this.wholeAgain():this.soon(),this.redraw()}bottom(){
return this.window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){
this.films=t,this.active=e,this.look=s,this.reached=this.findReach(),this.forwards=t.some(i=>i.columns.omega.some(o=>o>.3)),this.backwards=t.some(i=>i.columns.omega.
some(o=>o<-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(t){return D+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){
return F+(1-(t-this.bottom())/(this.top()-this.bottom()))*this.box.height}redraw(){if(!this.films)return;let{colors:t,look:e}=this,{context:s,width:i,height:o}=Y(
this.canvas,e.px);if(this.box={width:i-D-We,height:o-F-Ks},s.clearRect(0,0,i,o),s.save(),s.beginPath(),s.rect(D,F,this.box.width,this.box.height),s.clip(),this.
pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:l}of this.pictures){let[c,m,h,p]=l,d=[this.x(c),this.y(p),this.x(m)-this.x(c),this.y(h)-this.y(p)];
s.fillStyle=e.panel,s.fillRect(d[0],d[1],d[2],d[3]),s.globalAlpha=.35,s.drawImage(a,d[0],d[1],d[2],d[3]),s.globalAlpha=1}let{paradox:r}=this.pictures[0];Oa(s,this,
r),this.hatched.hidden=!r.some(a=>a!==0)}for(let[r,a]of this.films.entries())this.way(s,a,r);if(s.restore(),Na(s,this),this.keyed!==e.dark){this.keyed=e.dark;let r=Object.
entries(t.mode_names).filter(([a])=>"RSKH".includes(a));this.keys.replaceChildren(...r.map(([a,l])=>u("span",{class:"plot-key"},Ys(t.modes[a]),l)))}this.cursor(
this.clock.time)}way(t,e,s){let{angle:i,omega:o,mode:r}=e.columns,a=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=this.films.length>1?
Mt(s,this.look.dark):this.look.ink,t.beginPath();let l=null;for(let c=0;c<e.length;c++){if(!Number.isFinite(o[c])){l=null;continue}let m=Math.floor(i[c]/a),h=i[c]-
m*a;if(l===null)t.moveTo(this.x(h),this.y(o[c]));else if(m!==l.lap){let p=m>l.lap?a:0;t.lineTo(this.x(p),this.y(o[c])),t.moveTo(this.x(a-p),this.y(o[c])),t.lineTo(
this.x(h),this.y(o[c]))}else t.lineTo(this.x(h),this.y(o[c]));l={lap:m,mode:r[c]}}t.stroke(),t.setLineDash([])}spot({angle:t,omega:e}){let s=2*Math.PI;return[this.
x(t-Math.floor(t/s)*s),this.y(e)]}cursor(t){if(!this.films||!this.box)return;let{context:e,width:s,height:i}=Y(this.over,this.look.px);e.clearRect(0,0,s,i);let{
pointed:o}=this.clock;if(o!==null){let[r,a]=this.spot(this.films[this.active].at(o));e.strokeStyle=this.look.ink,e.lineWidth=1.5;for(let l of[6,10])e.beginPath(),
e.arc(r,a,l,0,2*Math.PI),e.stroke()}this.films.forEach((r,a)=>{let l=r.at(t),[c,m]=this.spot(l);c>=D&&c<=D+this.box.width&&m>=F&&m<=F+this.box.height&&(e.beginPath(),
e.arc(c,m,a?4:5.5,0,2*Math.PI),e.fillStyle=this.colors.modes[l.mode],e.fill(),e.lineWidth=2,e.strokeStyle=this.films.length>1?Mt(a,this.look.dark):this.look.ink,
e.stroke(),!(this.films.length<2)&&(e.font=`700 12px ${this.look.font}`,e.textAlign="left",e.fillStyle=e.strokeStyle,e.fillText("AB"[a],c+8,m-6)))})}seek(t){let e=this.
body.getBoundingClientRect(),[s,i]=[t.clientX-e.left,t.clientY-e.top].map(m=>m/this.look.px);if(this.pinched())return;let o=this.films[this.active],{angle:r,omega:a}=o.
columns,l=2*Math.PI,c={distance:1/0,t:0};for(let m=0;m<o.length;m++){let h=r[m]-Math.floor(r[m]/l)*l,p=Math.hypot(this.x(h)-s,this.y(a[m])-i);p<c.distance&&(c={
distance:p,t:o.t[m]})}c.distance<40&&this.clock.seek(x(c.t,0,o.duration))}};S();S();ht();function Fa(n,t){let e=[],s=null;for(let i=0;i<n.length;i++){let o=Math.floor(n[i]),r=t[i];Number.isFinite(o+r)?s&&s.x===o?(s.low=Math.min(s.low,r),s.high=Math.
max(s.high,r),s.middle+=(r-s.middle)/++s.count):(s={x:o,low:r,high:r,middle:r,count:1},e.push(s)):(s&&e.push(null),s=null)}return e}function Ia(n){let t=n.filter(
e=>e!==null);return t.filter(({count:e})=>e>=4).length>.5*t.length}S();N();Ot();O();Bt();var me=class{constructor({key:t,title:e,unit:s,curves:i,limits:o,symmetric:r=!1},a){this.shared=a;this.cut=null;this.key=t,this.title=e,this.unit=s,this.
curves=i,this.limits=o,this.symmetric=r,this.canvas=u("canvas",{class:"plot-canvas"}),this.over=u("canvas",{class:"plot-canvas plot-over"}),this.keys=u("div",{class:"\
plot-keys"}),this.body=u("div",{class:"plot-body",tabindex:"0",role:"figure","aria-label":e},this.canvas,this.over),this.element=u("section",{class:"plot","data\
-plot":t},u("header",{},u("h3",{},e),this.keys),this.body),this.body.addEventListener("pointerdown",l=>this.press(l)),this.pinched=dt(this.body,{zoom:(l,c)=>this.
films&&this.zoomAbout(c?this.valueAt(c):this.middle(),1/l),home:()=>this.zoomTo(null),keys:!0}),this.onseek=()=>{}}abscissa(t){return V[this.shared.axis].values(
t)}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.duration),1e-9)];let[t,e]=[1/0,-1/0];for(let s of this.films)for(let i of this.
abscissa(s))i<t&&(t=i),i>e&&(e=i);return e>t?[t,e]:[t-1,e+1]}take(t,e,s){this.films=t,this.active=e,this.look=s,this.range=this.shared.range??this.fullRange(),this.
legend(this.shades(t[e],e),s.dark)}draw(t){let{films:e,active:s}=this,{context:i,width:o,height:r}=Y(this.canvas,this.look.px);this.box={width:o-D-We,height:r-F-
Ks},i.clearRect(0,0,o,r);let a=e.flatMap((c,m)=>this.shades(c,m).map((h,p)=>({...h,film:c,lane:m,number:p})).filter((h,p,d)=>this.compares(h,m,d.length)));this.
heights=this.limits??this.findHeights(a),this.shared.axis==="time"&&this.bands(i,e[s],t),Ca(i,this),i.save(),i.beginPath(),i.rect(D,F,this.box.width,this.box.height),
i.clip();for(let c of a)this.curve(i,c);let l=e.map((c,m)=>a.find(h=>h.lane===m));if(e.length>1)for(let c of l)c&&this.letter(i,c);this.cut&&this.tell(i,P("plot\
.cut",this.cut)),i.restore(),this.describe(a)}shades(t,e){let{dark:s}=this.look;if(this.films.length<2)return this.curves(t).map(o=>({...o,color:o.color&&Re(o.color,
s)}));let i=Object.keys(Vs);return this.curves(t).map((o,r)=>({...o,color:Mt(e,s),dash:i[r%i.length]}))}compares({name:t},e,s){return e===this.active||s<=2||t===
"total"}x(t){return D+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return F+(1-(t-this.heights[0])/(this.heights[1]-this.heights[0]))*this.
box.height}findHeights(t){let e=[];for(let{film:r,values:a}of t){let l=this.abscissa(r);for(let c=0;c<a.length;c++)l[c]>=this.range[0]&&l[c]<=this.range[1]&&Number.
isFinite(a[c])&&e.push(a[c])}let s=La(e,this.symmetric),[i,o]=e.reduce(([r,a],l)=>[Math.min(r,l),Math.max(a,l)],s);return this.cut=i<s[0]||o>s[1]?{low:M(i,3),high:M(
o,3)}:null,s}bands(t,e,s){for(let i of e.phases){let o=x(this.x(i.from),D,D+this.box.width),r=x(this.x(i.to),D,D+this.box.width);r<=o||(t.fillStyle=Ce(s.modes[i.
mode],.14),t.fillRect(o,F,r-o,this.box.height))}}curve(t,{film:e,color:s,dash:i,number:o}){let[r,a]=[[],[]];for(let h of e.pieces()){let p=this.abscissa(h.film),
{values:d}=this.curves(h.film)[o];for(let f=h.from;f<h.to;f++)r.push(this.x(p[f])),a.push(x(this.y(d[f]),-1e4,1e4))}t.strokeStyle=t.fillStyle=s??this.look.ink,t.
lineWidth=1.8,t.setLineDash(Vs[i??"solid"]);let l=Fa(r,a),c=Ia(l),m=c?l.map(h=>h&&[h.x+.5,h.middle]):r.map((h,p)=>Number.isFinite(h+a[p])?[h,a[p]]:null);if(c){t.
globalAlpha=.28;for(let h of l)h&&t.fillRect(h.x,h.low,1,h.high-h.low);t.globalAlpha=1}t.beginPath();for(let[h,p]of m.entries())p&&m[h-1]?t.lineTo(...p):p&&t.moveTo(
...p);t.stroke(),t.setLineDash([])}letter(t,{film:e,lane:s,values:i,color:o}){let r=this.abscissa(e),a=this.range[0]+(s?.84:.7)*(this.range[1]-this.range[0]),l=r.
findIndex(h=>h>=a);if(l<0||!Number.isFinite(i[l]))return;let[c,m]=[this.x(r[l]),x(this.y(i[l])-8,F+10,F+this.box.height-4)];t.font=`700 12px ${this.look.font}`,
t.textAlign="center",t.lineWidth=4,t.strokeStyle=this.look.panel,t.strokeText("AB"[s],c,m),t.fillStyle=o??this.look.ink,t.fillText("AB"[s],c,m)}tell(t,e){t.font=
ze(this.look),t.textAlign="left",t.lineWidth=4,t.strokeStyle=this.look.panel,t.strokeText(e,D+6,F+11),t.fillStyle=this.look.ink,t.fillText(e,D+6,F+11)}legend(t,e){
let s=t.map(i=>i.name+i.color+i.dash).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>u("span",{class:"value"})),this.keys.replaceChildren(...t.map(
(i,o)=>u("span",{class:"plot-key"},Ys(i.color,i.dash),i.name," ",this.values[o]))))}describe(t){let e=t.slice(0,6).map(({name:i,values:o,lane:r})=>{let[a,l]=[1/0,
-1/0];for(let d of o)d<a&&(a=d),d>l&&(l=d);let c=this.films.length>1?`${"AB"[r]}: `:"",m=1e-12*Math.max(-a,l),h=d=>M(Math.abs(d)<m?0:d,3),p={name:P(i),low:h(a),
high:h(l)};return l>=a?`${c}${P("diagram.name_from_low_to",p)}`:""}),s=P("diagram.diagram_title_in_unit",{title:P(this.title),unit:P(this.unit)});this.body.setAttribute(
"aria-label",`${s} ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.heights)return;let{context:e,width:s,height:i}=Y(this.over,this.look.px);e.clearRect(0,
0,s,i),this.films.forEach((r,a)=>{let l=r.moment(t),c=this.x(this.abscissa(l)[0]),m=c>=D-1&&c<=D+this.box.width+1;m&&(e.strokeStyle=this.look.soft,e.lineWidth=1,
e.beginPath(),e.moveTo(c,F),e.lineTo(c,F+this.box.height),e.stroke()),this.shades(l,a).forEach((h,p,d)=>{if(!this.compares(h,a,d.length))return;let f=h.values[0];
a===this.active&&this.values?.[p]&&(this.values[p].textContent=M(f,l.sure?3:2));let g=this.y(f);!m||!(g>=F-1&&g<=F+this.box.height+1)||(e.fillStyle=h.color??this.
look.ink,e.beginPath(),e.arc(c,g,3.2,0,2*Math.PI),e.fill())})});let{pointed:o}=this.shared.clock;if(o!==null&&this.shared.axis==="time"&&(e.strokeStyle=this.look.
ink,e.setLineDash([4,3]),e.strokeRect(this.x(o),F,0,this.box.height),e.setLineDash([])),this.picked){let[r,a]=this.picked;e.fillStyle=Ce("#0072B2",.2),e.fillRect(
Math.min(r,a),F,Math.abs(a-r),this.box.height)}}valueAt(t){let e=this.body.getBoundingClientRect(),{px:s}=this.look,i=x(((t.clientX-e.left)/s-D)/(e.width/s-D-We),
0,1);return this.range[0]+i*(this.range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left)/this.look.
px,i=this.valueAt(t),o=this.pinched(),r=a=>{if(o||=this.pinched(),o)return;let l=(a.clientX-e.left)/this.look.px;this.picked=t.pointerType==="mouse"&&Math.abs(l-
s)>5?[s,l]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(a)),this.cursor(this.shared.clock.time)};J(this.body,t,r,(a,l)=>{let c=this.valueAt(a),{picked:m}=this;
this.picked=null,m&&l?this.zoomTo(i<c?[i,c]:[c,i]):m?this.cursor(this.shared.clock.time):l&&!o&&this.seek(t.pointerType==="mouse"?i:c)})}seek(t){if(this.shared.
axis==="time")return this.onseek(t);let e=this.films[this.active],s=this.abscissa(e),i=0;for(let o=0;o<s.length;o++)Math.abs(s[o]-t)<Math.abs(s[i]-t)&&(i=o);return this.
onseek(e.t[i])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(t,e){let s=this.fullRange(),i=Math.max(t-(t-this.range[0])*e,s[0]),o=Math.min(t+(this.
range[1]-t)*e,s[1]);this.zoomTo(i<=s[0]&&o>=s[1]?null:[i,o])}zoomTo(t){this.shared.range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}};var $i=n=>Object.entries(V).map(([t,e])=>u("option",{value:t},n(e)));function Ha(n){let t="height",e=new me({key:"own",title:"diagram.your_choice",unit:"",curves:o=>[
{name:V[t].name,values:V[t].values(o)}]},n),s=()=>{let{symbol:o,unit:r}=V[t];e.unit=r?`${o} [${r}]`:o},i=u("select",{"aria-label":"diagram.what_your_diagram_sho\
ws",onchange:()=>{t=i.value,s(),n.changed()}},$i(Jr));return i.value=t,s(),e.element.querySelector("h3")?.after(i),e}function Zm(n){return[{key:"velocities",title:"diagram.velocities",unit:"diagram.velocity_m_s",curves:t=>[{name:"diagram.v_centre",color:n.center_speed,values:t.
columns.vx},{name:"R θ̇",color:n.rotation_speed,dash:"dash",values:t.derived("spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"\
diagram.energies_and_losses",unit:"diagram.energy_j",curves:t=>[{name:"diagram.kinetic",color:n.kinetic,values:t.columns.kinetic},{name:"diagram.potential",color:n.
potential,values:t.columns.potential},{name:"diagram.total",values:t.derived("total",({t:e,kinetic:s,potential:i})=>Float64Array.from(e,(o,r)=>s[r]+i[r])),dash:"\
dash"},{name:"diagram.lost_to_friction",color:n.friction_loss,values:t.columns.friction_loss},{name:t.scenario.contact.model==="compliant"?"diagram.lost_in_the_\
damper":"diagram.lost_in_impacts_normal",color:n.impact_loss,values:t.columns.normal_loss,dash:"dot"},...t.scenario.plane.rolling_resistance?[{name:"diagram.los\
t_to_rolling_resistance",values:t.columns.rolling_resistance,dash:"dot"}]:[]]},{key:"forces",title:"diagram.contact_forces",unit:"diagram.force_n",curves:t=>[{name:"\
diagram.normal_n",color:n.normal_force,values:t.columns.normal_force},{name:"diagram.friction_f",color:n.friction_force,dash:"dash",values:t.columns.friction_force}]},
{key:"utilization",title:"diagram.use_of_friction",unit:"|F| / μN",limits:[0,1.08],curves:t=>[{name:"|F| / μN",color:n.friction_force,values:t.columns.utilization}]}]}
var Js=class{constructor(t,e){this.colors=e;this.shared={axis:"time",range:null,clock:t,changed:()=>this.redraw()},this.plots=[...Zm(e).map(i=>new me(i,this.shared)),
Ha(this.shared)];for(let i of this.plots)i.onseek=o=>t.seek(o);this.seen=new Map(this.plots.map(i=>[i.element,!0]));let s=new IntersectionObserver(i=>{for(let{target:o,
isIntersecting:r}of i)this.seen.set(o,r);this.redraw()},{rootMargin:"400px"});for(let i of this.plots)s.observe(i.element);this.axis=u("select",{"aria-label":"d\
iagram.horizontal_axis_of_the",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=null,this.redraw()}},$i(({name:i})=>({key:"diagram.over_quantity",
values:{quantity:i}}))),this.back=u("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"diagram.whole_motion"),this.hint=u("span",{class:"\
hint"}),this.element=u("div",{class:"plots"},u("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(i=>i.element))}draw(t,e,s){this.films=t,
this.active=e,this.look=s;let i=matchMedia("(hover: none)").matches?"diagram.slide_to_go_there":"diagram.click_to_go_there",o=t.length>1;L(this.hint,o?{key:"dia\
gram.a_blue_b_ochre",values:{hoop:"AB"[e],hands:i}}:i),this.redraw()}redraw(){if(this.films?.length){this.back.hidden=!this.shared.range;for(let t of this.plots)
t.take(this.films,this.active,this.look);for(let t of this.visible())t.draw(this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.plots.filter(
t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())e.cursor(t)}};var tu={python:"fingerprint.same_bits_as_in",link:"fingerprint.same_bits_as_where"},eu={python:"fingerprint.the_bits_differ_own",link:"fingerprint.the_bits_diff\
er_own_here"},Qs=class{constructor(t){this.link=new Map;this.python=new Map(t.map(({key:e,query:s})=>[s,E.fingerprints[e]]))}expect(t,e){for(let[s,{query:i}]of t.
entries())e[s]&&this.link.set(i,e[s])}expected(t){return t.map(({query:e})=>this.link.get(e)??"")}of({query:t,fingerprint:e}){return e?["python","link"].flatMap(
s=>{let i=this[s].get(t);if(!i)return[];let o=e===i;return[{same:o,text:o?tu[s]:{key:eu[s],values:{own:e,other:i}}}]}):[]}};S();S();S();var ol=()=>Promise.resolve().then(()=>(Ja(),Xa)),rl=()=>Promise.resolve().then(()=>(il(),sl)),nn=n=>n.catch(()=>{throw new Error("page.not_loaded")});N();O();var iu=3840;async function al(n){let{width:t,height:e}=n.stage.canvas().getBoundingClientRect(),s=Math.max(iu/t,globalThis.devicePixelRatio||1),i=u("can\
vas",{width:Math.round(t*s),height:Math.round(e*s)}),o=Tt(i);return o.setTransform(s,0,0,s,0,0),Yi(o,n,t,e),n.stage.options.three?(o.drawImage(n.stage.sharp(n,s),
0,0,t,e),n.drawStage()):cl(o,n,t,e),Xi(o,n,e),new Promise((r,a)=>i.toBlob(l=>l?r(l):a(new Error("save.the_picture_is_too"))))}async function ll(n){if(n.stage.options.
three)throw new Error("save.a_picture_in_space");let{width:t,height:e}=n.stage.canvas().getBoundingClientRect(),{Context:s}=await nn(rl()),i=new s({width:t,height:e,
document});return Yi(i,n,t,e),cl(i,n,t,e),Xi(i,n,e),new Blob([i.getSerializedSvg()],{type:"image/svg+xml"})}function hl(n,t){let e=n.stage.canvas(),{width:s,height:i}=e.
getBoundingClientRect(),o=Tt(t);o.setTransform(t.width/s,0,0,t.height/i,0,0),Yi(o,n,s,i),o.drawImage(e,0,0,s,i),Xi(o,n,i)}function Yi(n,{theme:t},e,s){n.fillStyle=
t.look.paper,n.fillRect(0,0,e,s)}function cl(n,t,e,s){let{stage:i,clock:o,theme:r}=t;i.flat.paint(n,e,s,t.films(),o.time,i.options,r.look,r.inks)}function Xi(n,t,e){
let{theme:s,stage:i,clock:o}=t,{px:r}=s.look,a=t.films();n.textBaseline="top",n.textAlign="left";for(let[l,c]of a.entries()){let m=c.at(o.time),h=a.length>1?`${"\
AB"[l]}: `:"",p=P(s.colors.mode_names[m.mode]),d=`t = ${m.t.toFixed(3)} s, θ = ${K(m.angle)}, v = ${M(m.vx,m.digits)} m/s`,f=i.options.three?10+20*r*l:10+l*e/a.
length;n.fillStyle=s.colors.modes[m.mode],n.fillRect(12,f+2*r,11*r,11*r),n.fillStyle=s.look.ink,n.font=`${13*r}px ${s.look.font}`,n.fillText(`${h}${p}, ${d}`,12+
18*r,f)}n.textBaseline="alphabetic"}async function ml(n){let t=n.stage.canvas();if(!t.captureStream||!globalThis.MediaRecorder)throw new Error("save.this_browser_cannot_record");let e=u("canvas",{
width:2*Math.ceil(t.width/2),height:2*Math.ceil(t.height/2)}),s=new MediaRecorder(e.captureStream(60),{videoBitsPerSecond:8e6}),i=[];s.ondataavailable=a=>i.push(
a.data);let o=new Promise(a=>s.onstop=a),{loop:r}=n.clock;return n.clock.loop=!1,n.clock.seek(0),n.notice.say("save.recording_one_run"),n.afterFrame=()=>{hl(n,e),
!n.clock.playing&&s.state==="recording"&&s.stop()},s.start(),n.clock.play(!0),await o,n.afterFrame=null,n.clock.loop=r,new Blob(i,{type:s.mimeType})}var ou=[["motion.toml","save.save_the_scenario_toml"],["motion.csv","save.save_the_states_csv"],["motion.nc","save.save_the_motion_netcdf"],["motion.json","save\
.save_the_events_json"],["motion.mp4","save.save_a_film_mp4"]],on=class{constructor(t){this.lab=t;this.menu=u("details",{class:"menu"},u("summary",{class:"butto\
n"},u("span",{class:"long"},"save.share_and_save"),u("span",{class:"short"},"save.share")),u("div",{class:"menu-body"},t.backend.shares&&this.item("save.copy_a_\
link_to",()=>this.copyLink()),ou.filter(([e])=>t.backend.files.includes(e)).map(([e,s])=>this.item(s,()=>this.download(e))),this.item("save.save_a_picture_png",
()=>this.picture("png",al)),this.item("save.save_a_picture_svg",()=>this.picture("svg",ll)),this.item("save.record_one_run_as",()=>this.record()),this.item("sav\
e.show_the_python_code",()=>this.code()))),this.dialog=u("dialog",{class:"code-dialog","aria-label":"save.the_same_motion_in"})}item(t,e){return u("button",{type:"\
button",onclick:async()=>{this.menu.open=!1;try{await e()}catch(s){this.lab.notice.fail(s)}}},t)}async copyLink(){let t=this.lab.link(this.lab.films().map(({fingerprint:e})=>e??
""))??"";try{await navigator.clipboard.writeText(t),this.lab.notice.say("save.the_link_is_copied")}catch{this.show("save.the_link_to_this",t)}}async download(t){
let e=this.lab.film();this.lab.notice.say(t.endsWith("mp4")?"save.the_film_is_being":{key:"save.fetching_name",values:{name:t}}),le(await this.lab.backend.file(
t,e.query),`hophoop-${t}`),this.lab.notice.say({key:"save.name_is_there",values:{name:t}})}async picture(t,e){le(await e(this.lab),`hophoop.${t}`)}async record(){
le(await ml(this.lab),"hophoop.webm"),this.lab.notice.say("save.the_film_is_there")}async code(){let{python:t,toml:e}=this.lab.backend.code(this.lab.film().scenario);
this.show("save.the_same_motion_in",t,"save.the_scenario_as_a",e)}show(...t){let e=[];for(let s=0;s<t.length;s+=2){let i=t[s+1],o=u("button",{type:"button"},"mo\
tion.copy");o.onclick=async()=>{await navigator.clipboard?.writeText(i).catch(()=>{}),L(o,"motion.copied")},e.push(u("header",{},u("h2",{},t[s]),o),u("pre",{tabindex:"\
0"},u("code",{},document.createTextNode(i))))}this.dialog.replaceChildren(...e,u("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"table.c\
lose")),this.dialog.showModal()}};ht();S();N();ht();S();N();Ot();ht();N();var ul=120,rn=class{constructor(t,e,s,i,o,r,a,l,c,m,h){this.context=t;this.width=e;this.height=s;this.film=i;this.options=r;this.look=a;this.colors=l;this.
common=h;this.top=0;this.pose=i.at(o);let p=i.radius,{left:d,right:f}=i.extent,{top:g}=h;this.cosine=Math.cos(i.slope),this.sine=Math.sin(i.slope);let _=2*h.radius+
Math.min(g,6*h.radius),b=Math.min(.66*s/_,.36*e/h.radius);if(r.whole){let y=(f-d)*this.cosine+2.6*p,w=(f-d)*Math.abs(this.sine)+2.6*p+g;this.scale=Math.min(e/y,
.86*s/w,b)*c,this.focus=[.5*(d+f),0],this.place=[.5*e+m[0],(i.slope?.62:.8)*s+m[1]]}else this.scale=b*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],
this.place=[(e<520?.6:.46)*e+m[0],.82*s+m[1]]}point(t,e){let s=t-this.focus[0],i=e-this.focus[1];return[this.place[0]+this.scale*(s*this.cosine+i*this.sine),this.
place[1]-this.scale*(i*this.cosine-s*this.sine)]}unpoint(t,e){let s=(t-this.place[0])/this.scale,i=-(e-this.place[1])/this.scale;return[this.focus[0]+s*this.cosine-
i*this.sine,this.focus[1]+s*this.sine+i*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&
this.forces()}ground(){let{context:t,look:e,width:s,height:i}=this,o=(Math.hypot(s,i)*1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[r,a]=this.
point(this.focus[0]-o,0),[l,c]=this.point(this.focus[0]+o,0),m=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,t.beginPath(),t.moveTo(r,a),t.lineTo(l,c),t.
lineTo(l+m[0],c+m[1]),t.lineTo(r+m[0],a+m[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(r,a),t.lineTo(l,c),t.stroke();let h=X(s/this.
scale,s/(90*e.px));t.fillStyle=e.soft,t.font=`${11*e.px}px ${e.font}`,t.textAlign="center",t.lineWidth=1;let p=Math.ceil((this.focus[0]-o)/h),d=Math.min(Math.floor(
(this.focus[0]+o)/h),p+400);for(let f=p;f<=d;f++){let[g,_]=this.point(f*h,0);g<-40||g>s+40||(t.beginPath(),t.moveTo(g,_),t.lineTo(g-6*this.sine,_+6*this.cosine),
t.stroke(),t.fillText(`${pt(f*h,h)} m`,g-18*e.px*this.sine,_+8+10*e.px*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:i}=this,o=t.radius,r=this.options.
ahead?t.duration:this.pose.t,a=(l,c,m,h)=>{e.strokeStyle=c,e.lineWidth=m,e.lineJoin="round",e.beginPath();let p=!1,d=(f,g,_)=>{let[b,y]=this.point(f+l*Math.sin(
_),o+g+l*Math.cos(_));p?e.lineTo(b,y):e.moveTo(b,y),p=!0};for(let f of t.pieces()){let{x:g,height:_,angle:b,mode:y}=f.film.columns;for(let w=f.from;w<f.to&&f.film.
t[w]<=r;w++)h===void 0||y[w]===3===h?d(g[w],_[w],b[w]):p=!1}!this.options.ahead&&(h===void 0||this.pose.mode==="H"===h)&&d(this.pose.x,this.pose.height,this.pose.
angle),e.stroke()};e.globalAlpha=this.options.ahead?.45:1,a(o,s.ink,1.3),a(t.eccentricity*o,i.gravity_center,1.8,!1),a(t.eccentricity*o,i.airborne,2.4,!0),e.globalAlpha=
1}mark(t,e){let{context:s,film:i,pose:o,scale:r}=this,[a,l]=this.point(o.x,i.radius+o.height);s.strokeStyle=e,s.lineWidth=3,s.beginPath(),s.arc(a,l,Math.max(i.radius*
r-x(.07*i.radius*r,2,14)-3,2),0,2*Math.PI),s.stroke(),s.fillStyle=e,s.font=`700 ${17*this.look.px}px ${this.look.font}`,s.textAlign="center",s.fillText(t,a-14,l+
20)}ghost(t){let{context:e,film:s,look:i,width:o,scale:r}=this,a=s.radius,[l,c]=this.point(t.x,a+t.height),m=a*r;if(e.strokeStyle=e.fillStyle=i.ink,e.lineWidth=
1.5,e.beginPath(),l>-.5*m&&l<o+.5*m){let g=this.point(t.x+a*Math.sin(t.angle),a+t.height+a*Math.cos(t.angle));e.setLineDash([6,5]),e.arc(l,c,m,0,2*Math.PI),e.moveTo(
l,c),e.lineTo(...g),e.stroke(),e.setLineDash([]),e.beginPath(),e.arc(...g,x(.1*m,4,16),0,2*Math.PI),e.fillStyle=i.paper,e.fill(),e.stroke();return}let h=l<0?-1:
1,p=h<0?6:o-6,d=x(c,24,this.height-24);e.moveTo(p,d),e.lineTo(p-14*h,d-9),e.lineTo(p-14*h,d+9),e.fill(),e.font=`600 ${12*i.px}px ${i.font}`,e.textAlign=h<0?"lef\
t":"right",e.lineWidth=3,e.strokeStyle=i.paper;let f=`${M(t.x-this.focus[0],3)} m`;e.strokeText(f,p-20*h,d+4*i.px),e.fillText(f,p-20*h,d+4*i.px)}hoop(){let{film:t,
pose:e,context:s,look:i,colors:o,scale:r}=this,a=t.radius,l=x(.07*a*r,2,14),c=a-.5*l/r,m=[e.x,a+e.height],h=(_,b=c)=>this.point(m[0]+b*Math.sin(_),m[1]+b*Math.cos(
_));if(s.lineCap="butt",i.dark&&(s.strokeStyle=i.soft,s.lineWidth=l+2,s.beginPath(),s.arc(...this.point(m[0],m[1]),c*r,0,2*Math.PI),s.stroke()),this.options.speed){
let _=this.common.speed;s.lineWidth=l;let b=2*Math.PI/ul;for(let y=0;y<ul;y++){let w=e.angle+y*b,k=Math.hypot(e.vx+a*e.omega*Math.cos(w+.5*b),e.vy-a*e.omega*Math.
sin(w+.5*b));s.strokeStyle=us[x(Math.round(255*k/_)||0,0,255)],s.beginPath(),s.moveTo(...h(w-.04*b)),s.lineTo(...h(w+1.04*b)),s.stroke()}}else s.strokeStyle=o.modes[e.
mode],s.lineWidth=l,s.beginPath(),s.arc(...this.point(m[0],m[1]),c*r,0,2*Math.PI),s.stroke();s.strokeStyle=i.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(
m[0],m[1])),s.lineTo(...h(e.angle)),s.stroke();let p=(_,b,y,w)=>{s.beginPath(),s.arc(..._,b,0,2*Math.PI),s.fillStyle=y,s.fill(),s.lineWidth=1.5,s.strokeStyle=w,
s.stroke()};p(this.point(m[0],m[1]),2.5,i.soft,i.soft);let d=t.scenario.hoop.parts;d?this.parts(d,m):p(h(e.angle),x(.1*a*r,4,16),i.ink,i.paper);let f=t.eccentricity*
a,g=this.point(m[0]+f*Math.sin(e.angle),m[1]+f*Math.cos(e.angle));p(g,x(.05*a*r,3.5,7),e.mode==="H"?o.airborne:o.gravity_center,i.paper)}parts(t,e){let{film:s,pose:i,
context:o,look:r,scale:a}=this,c=t.reduce((m,h)=>m+h.mass*(h.at??0),0)<0?-1:1;o.strokeStyle=r.ink;for(let m of t){let h=c*(m.at??0),p=this.point(e[0]+h*Math.sin(
i.angle),e[1]+h*Math.cos(i.angle));if(o.fillStyle=r.ink,o.lineWidth=1,o.beginPath(),m.shape==="ring")o.globalAlpha=.22,o.arc(...p,m.outer_radius*a,0,2*Math.PI),
o.arc(...p,m.inner_radius*a,0,2*Math.PI,!0),o.fill(),o.globalAlpha=1;else if(m.shape==="rod"){let d=.5*m.length,f=g=>this.point(e[0]+g*Math.sin(i.angle),e[1]+g*
Math.cos(i.angle));o.lineWidth=4,o.moveTo(...f(h-d)),o.lineTo(...f(h+d)),o.stroke()}else{let d=m.shape==="disk"?m.radius*a:x(.08*s.radius*a,3,12);o.globalAlpha=
m.shape==="disk"?.55:1,o.arc(...p,d,0,2*Math.PI),o.fill(),o.globalAlpha=1}}}forces(){let{film:t,pose:e,colors:s}=this,i=t.radius,o=t.mass*(t.gravity||9.81),r=l=>.55*
i*l/o;if(e.mode==="H"||!(e.normal_force>0))return;let a=[e.x,e.height];this.arrow(a,[0,r(e.normal_force)],s.normal_force,`N = ${M(e.normal_force,e.digits)} N`,!1),
this.arrow(a,[r(e.friction_force),0],s.friction_force,`F = ${M(e.friction_force,e.digits)} N`,!0)}arrow([t,e],[s,i],o,r,a){let{context:l,look:c,width:m}=this,h=2.2*
this.film.radius,p=Math.abs(s)>h||Math.abs(i)>h;[s,i]=[x(s,-h,h),x(i,-h,h)];let d=this.point(t,e),f=this.point(t+s,e+i),g=Math.hypot(f[0]-d[0],f[1]-d[1]);if(g<2)
return;let _=(f[0]-d[0])/g,b=(f[1]-d[1])/g,y=Math.min(11,g);for(let[T,C]of[[c.paper,6],[o,3]])l.strokeStyle=T,l.fillStyle=T,l.lineWidth=C,l.beginPath(),l.moveTo(
...d),l.lineTo(f[0]-_*y,f[1]-b*y),l.stroke();if(l.beginPath(),l.moveTo(...f),l.lineTo(f[0]-_*y-b*y*.5,f[1]-b*y+_*y*.5),l.lineTo(f[0]-_*y+b*y*.5,f[1]-b*y-_*y*.5),
l.fill(),p){let[T,C]=[d[0]+.55*_*g,d[1]+.55*b*g];l.strokeStyle=c.paper,l.lineWidth=2,l.beginPath();for(let R of[-3,3])l.moveTo(T+_*(R-3)-b*7,C+b*(R-3)+_*7),l.lineTo(
T+_*(R+3)+b*7,C+b*(R+3)-_*7);l.stroke()}l.font=`600 ${12*c.px}px ${c.font}`;let w=l.measureText(r).width;l.lineWidth=3,l.strokeStyle=a?c.ground:c.paper,l.textAlign=
"left";let k=a?[d[0]-.5*w-32*c.px*this.sine,d[1]+32*c.px*this.cosine]:[f[0]+12,x(f[1]+4,16,d[1]-.36*this.film.radius*this.scale)];k[0]=x(k[0],4,m-w-4),l.strokeText(
r,k[0],k[1]),l.fillText(r,k[0],k[1])}};Bt();var an=class{constructor(t,e){this.canvas=t;this.onview=e;this.zoom=1;this.shift=[0,0];this.views=[];this.fixed=null;this.pointed=null;this.grab=()=>!1,this.
over=()=>{},t.addEventListener("pointerdown",s=>this.drag(s)),this.pinched=dt(t,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>t.parentElement})}reset(){
this.zoom=1,this.shift=[0,0],this.onview()}pan(){let{width:t,height:e}=this.canvas.getBoundingClientRect();return[this.shift[0]/(t||1),this.shift[1]/(e||1)]}look(t=1,[
e,s]=[0,0]){let{width:i,height:o}=this.canvas.getBoundingClientRect();this.zoom=t,this.shift=[e*i,s*o]}zoomBy(t){this.zoom=x(this.zoom*t,.05,60),this.onview()}drag(t){
if(this.grab(t))return;let e=[t.clientX,t.clientY],s=this.shift;J(this.canvas,t,i=>{this.pinched()||(this.shift=[s[0]+i.clientX-e[0],s[1]+i.clientY-e[1]],this.onview())})}draw(t,e,s,i,o){
let{context:r,width:a,height:l}=Y(this.canvas);r.clearRect(0,0,a,l),!(a<40||l<40)&&(this.views=this.paint(r,a,l,t,e,s,i,o))}paint(t,e,s,i,o,r,a,l){let c=s/i.length,
m={top:Math.max(...i.map(h=>h.extent.top)),radius:Math.max(...i.map(h=>h.radius)),speed:Math.max(...i.map(h=>h.extent.speed))};return i.map((h,p)=>{t.save(),t.beginPath(),
t.rect(0,p*c,e,c),t.clip(),t.translate(0,p*c);let d=new rn(t,e,c,h,o,r,a,l,this.zoom,this.shift,m);return d.top=p*c,d.scale=this.fixed??d.scale,d.draw(),this.pointed?.
lane===p&&d.ghost(h.at(this.pointed.time)),this.over(d,p),i.length>1&&(d.mark("AB"[p],Mt(p,a.dark)),t.fillStyle=Mt(p,a.dark),t.font=`700 ${17*a.px}px ${a.font}`,
t.textAlign="left",t.fillText("AB"[p],12,c-12)),t.restore(),p>0&&(t.fillStyle=a.line,t.fillRect(0,p*c-.5,e,1)),d})}};O();var ru=["player.hoop","table.mode","column.time","column.angle","v","R θ̇","player.gap"],ln=class{constructor(t,e){this.colors=t;this.onview=e;this.options=
{traces:!0,forces:!0,speed:!0,whole:!1,three:!1,ahead:!1};this.plane=u("canvas",{class:"stage-canvas"});this.space=u("canvas",{class:"stage-canvas",hidden:!0});
this.flat=new an(this.plane,this.onview);this.deep=null;this.outputs=ru.map(i=>({name:u("dt",{},i),value:u("dd",{})})),this.outputs[1].value.className="mode",this.
fastest=u("span",{}),this.legend=u("div",{class:"legend","aria-hidden":"true"},u("i",{style:`background: linear-gradient(90deg, ${us.filter((i,o)=>o%15===0).join(
",")})`}),u("span",{},"0"),u("span",{},"player.rim_speed"),this.fastest);let s=(i,o)=>u("span",{},u("i",{class:"dot",style:`background:${i}`}),o);this.order=u("\
span",{hidden:!0},"player.a_in_front_b"),this.element=u("div",{class:"stage",role:"figure","aria-label":"player.the_hoop",tabindex:"0"},this.plane,this.space,u(
"dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(({name:i,value:o})=>[i,o])),this.legend,u("div",{class:"stage-keys","aria-hidden":"true"},s("va\
r(--ink)","player.load"),s(t.gravity_center,"player.centre_of_gravity"),s(t.airborne,"player.the_same_in_flight"),this.order))}canvas(){return this.options.three?
this.space:this.plane}draw(t,e,s,{look:i,inks:o}){let{options:r}=this;this.legend.hidden=!r.speed,this.order.hidden=!(r.three&&t.length>1),this.fastest.textContent=
`≥ ${M(Math.max(...t.map(a=>a.extent.speed)),2)} m/s`,r.three?this.deep?.draw(t,s.time,r,i,o,s.playing):(this.flat.pointed=s.pointed===null?null:{time:s.pointed,
lane:e},this.flat.draw(t,s.time,r,i,o)),this.read(t,e,s.time)}sharp(t,e){let{look:s,inks:i}=t.theme;return this.deep?.draw(t.films(),t.clock.time,this.options,s,
i,!1,e),this.space}read(t,e,s){let i=t[e],o=i.at(s),r=[t.length>1?"AB"[e]:"",P(this.colors.mode_names[o.mode]),gt(`${o.t.toFixed(3)} s`),K(o.angle),j(M(o.vx,o.digits),
"m/s"),j(M(o.omega*i.radius,o.digits),"m/s"),o.height>0?jt(o.height):"0"];for(let[c,m]of r.entries()){let{value:h}=this.outputs[c];h.textContent!==m&&(h.textContent=
m)}let[a,l]=this.outputs;a.value.hidden=a.name.hidden=t.length<2,l.value.style.setProperty("--mode",this.colors.modes[o.mode])}describe(t){Et(this.element,"aria\
-label",["player.the_hoop_2",...t.flatMap(e=>[" ",e.summary])])}async turn(t){let e=this.deep?null:await nn(ol()),s=()=>{this.plane.hidden=this.options.three,this.
space.hidden=!this.options.three};this.options.three=!this.options.three,s();try{e&&(this.deep??=new e.Stage3D(this.space,this.onview)),t()}catch(i){throw this.
options.three=!1,s(),i}}view(){let{options:t,flat:e,deep:s}=this;return{options:t,zoom:e.zoom,pan:e.pan(),from:s?.from()}}restore({options:t,zoom:e,pan:s,from:i}){
if(t){let{three:o,...r}=t;Object.assign(this.options,r)}this.flat.look(e,s),i&&this.deep?.look(i)}zoom(t){this.options.three?this.deep?.zoomBy(t):t?this.flat.zoomBy(
t):this.flat.reset()}};S();N();var hn=class{constructor(t){this.clock=t;this.listed=null;this.summary=u("p",{class:"summary"});this.doubt=u("p",{class:"hint",hidden:!0});this.list=u("\
ol",{class:"story-list"});this.heading=u("h2",{},"motion.what_happens");this.signature=u("span",{});this.compared=u("span",{});this.fingerprint=u("p",{class:"hi\
nt fingerprint"},this.signature,this.compared);this.live=u("div",{class:"spoken",role:"status","aria-live":"polite"});this.element=u("section",{class:"story","a\
ria-label":"motion.the_motion_in_words"},this.heading,this.summary,this.doubt,this.list,this.fingerprint,this.live)}draw(t,e,s,i){this.film=t[e],L(this.heading,
t.length>1?{key:"motion.what_happens_to_hoop",values:{hoop:"AB"[e]}}:"motion.what_happens"),this.summary.replaceChildren(...t.flatMap((o,r)=>[t.length>1?u("b",{},
`${"AB"[r]}: `):"",u("span",{},o.summary),o.status==="event_limit"||o.shortened?u("span",{}," ","motion.not_all_events_are"):"",r+1<t.length?u("br"):""])),this.
doubt.hidden=!this.film.doubt,L(this.doubt,this.film.doubt),this.listed!==this.film&&this.fill(s),this.sign(),this.compared.replaceChildren(...i.flatMap(({same:o,
text:r})=>[" ",u("span",{class:o?"same":"differs"},r)])),this.cursor(this.clock.time)}fill(t){this.listed=this.film,this.current=-1,this.items=this.film.story.map(
e=>u("li",{},u("button",{type:"button",onclick:()=>this.clock.seek(e.t),onpointerenter:()=>this.clock.point(e.t),onpointerleave:()=>this.clock.point(null),onfocus:()=>this.
clock.point(e.t),onblur:()=>this.clock.point(null)},u("i",{class:"dot",style:`background:${t.modes[e.mode]}`,"aria-hidden":"true"}),u("span",{class:"when"},`${M(
e.t,4)} s`),u("span",{},e.text)))),this.list.replaceChildren(...this.items),this.clock.pointed=null}sign(){let{fingerprint:t}=this.film;t!==this.signed&&(this.signed=
t,this.signature.replaceChildren(...au(t)))}say(t){L(this.live,t)}announce(t){this.say(t.flatMap((e,s)=>s?[" ",e.summary]:[e.summary]))}cursor(t){let{story:e}=this.
film,s=-1;for(let o=0;o<e.length&&e[o].t<=t+1e-9;o++)s=o;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add(
"now"),this.items[this.current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let i=this.items[s];if(i){let o=i.
offsetTop-this.list.offsetTop;(o<this.list.scrollTop||o+i.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=o-.4*this.list.clientHeight)}}};
function au(n){if(!n)return[u("span",{},"motion.no_fingerprint_this_motion")];let t=u("code",{},document.createTextNode(n)),e=u("button",{type:"button"},"motion\
.copy");return e.onclick=async()=>{try{await navigator.clipboard.writeText(n),L(e,"motion.copied")}catch{getSelection()?.selectAllChildren(t)}},[u("span",{title:"\
motion.a_hash_of_all"},"motion.fingerprint")," ",t," ",e]}var cn=class{constructor(){this.list=u("dl",{});this.heading=u("h2",{},"motion.what_theory_says");this.
element=u("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){L(this.heading,e?{key:"motion.what_theory_says_of",values:{hoop:e}}:"motion.what_theor\
y_says"),this.list.replaceChildren(...t.flatMap(({label:s,text:i})=>[u("dt",{},s),u("dd",{},i)]))}};ht();S();Dt();var pl="hophoop-theme",lu=["gravity_center","airborne","normal_force","friction_force"],mn=class{constructor(t,e,s,i){this.root=t;this.colors=e;this.
hosted=s;this.changed=i;this.chosen=null;this.media=matchMedia("(prefers-color-scheme: dark)");this.listen=()=>this.apply(),this.media.addEventListener("change",
this.listen),this.mark(),this.look=di(t),this.inks={...e},this.read()}mark(){let t=this.hosted?ct(pl):null;this.root.dataset.theme=this.chosen??t??(this.media.matches?
"dark":"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=di(this.root),this.inks={...this.colors};for(let t of lu)
this.inks[t]=Re(this.colors[t],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&mt(pl,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};ht();S();N();Ot();Bt();O();var un=class{constructor(t){this.clock=t;this.window=null;this.canvas=u("canvas",{class:"timeline-canvas"});this.tip=u("div",{class:"tip",hidden:!0});
this.element=u("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"player.time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.
tip),this.element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermove",e=>this.hover(e)),this.element.addEventListener("\
pointerleave",()=>this.tip.hidden=!0),this.pinched=dt(this.element,{zoom:(e,s)=>this.zoom(1/e,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let t=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=t[1]?t:te(this.window,t)}zoom(t,e){let[s,i]=this.ends(),o=1e-6*this.clock.duration,
r=Math.max((i-s)*t,o),a=(e-s)/(i-s);this.window=r<this.clock.duration?te([e-a*r,e+(1-a)*r],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[t,e]=this.ends(),{time:s,duration:i}=this.clock;if(s>=t&&s<=e)return;let o=e-t;this.window=te(s>e?[s-.1*o,s+.9*o]:[s-.5*o,s+.5*o],[0,i])}timeAt(t){let e=this.
canvas.getBoundingClientRect(),[s,i]=this.ends();return s+x((t.clientX-e.left)/e.width,0,1)*(i-s)}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});
let e=this.clock.playing;this.clock.playing=!1;let s=i=>!this.pinched()&&this.clock.seek(this.timeAt(i));s(t),J(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){
let e=this.timeAt(t),s=this.nearest(e,8),i=s?`${P(Nt(s.kind))} · ${M(s.t,5)} s · ${M(s.angle*180/Math.PI,4)}°`:`${M(e,4)} s`;this.tip.textContent=i,this.tip.
hidden=!1;let o=this.canvas.getBoundingClientRect();this.tip.style.left=`${x(t.clientX-o.left,70,o.width-70)}px`}nearest(t,e){let[s,i]=this.ends(),o=e*(i-s)/(this.
canvas.getBoundingClientRect().width||1),r=null;for(let a of this.films??[])for(let l of a.events){if(l.kind==="end")continue;let c=Math.abs(l.t-t);c<=o&&(!r||c<
Math.abs(r.t-t))&&(r=l)}return r}draw(t,e,s){this.films=t;let{context:i,width:o,height:r}=Y(this.canvas,e.px);this.keep();let[a,l]=this.ends(),c=b=>(b-a)/(l-a)*
o;i.clearRect(0,0,o,r);let m=15,h=(r-15)/t.length-m;t.forEach((b,y)=>{let w=m+y*(m+h);for(let{mode:k,from:T,wide:C}of Dr(b.phases,c,o)){let R=s.modes[k];i.fillStyle=
R,i.fillRect(T,w,C,h-2),this.named(i,P(s.mode_names[k]),T,C,w,h-2,R,e)}b.duration<l&&(i.fillStyle=e.line,i.fillRect(Math.max(c(b.duration),0),w,o,h-2)),this.marks(
i,b,c,w,o,e),t.length>1&&(i.fillStyle=Mt(y,e.dark),i.font=`700 12px ${e.font}`,i.textAlign="right",i.fillText("AB"[y],o-1,w-4))});let p=X(l-a,o/60);i.fillStyle=
e.soft,i.font=`10.5px ${e.font}`;let d=_t(a,l,o/60);for(let b of d){let y=c(b);i.textAlign=y<14?"left":y>o-14?"right":"center",i.fillText(pt(b,p)+(b===d[0]?" s":
""),y,r-3)}let{pointed:f}=this.clock;if(f!==null&&f>=a&&f<=l){let b=x(c(f),2,o-2);i.lineWidth=2;for(let[y,w]of[[e.paper,5],[e.ink,1]])i.fillStyle=y,i.fillRect(b-
.5*w,m-4,w,r-m-9),i.fillRect(b-5-.5*w,m-4,10+w,w)}let g=x(c(this.clock.time),6,o-6),_=x(c(this.clock.time),1,o-1);i.fillStyle=e.ink,i.fillRect(_-1,m-4,2,r-m-9),
i.beginPath(),i.moveTo(g-6,m-10),i.lineTo(g+6,m-10),i.lineTo(_,m-1),i.fill(),this.tell(t,s)}tell(t,e){let{time:s,duration:i,playing:o}=this.clock,a=t.map((l,c)=>{
let m=P(e.mode_names[l.at(s).mode]);return t.length>1?`${"AB"[c]} ${m}`:m}).join(", ");o&&a===this.said||(this.said=a,this.element.setAttribute("aria-valuemax",
i.toFixed(3)),this.element.setAttribute("aria-valuenow",s.toFixed(3)),this.element.setAttribute("aria-valuetext",P("player.time_seconds_what",{time:M(s,4),what:a})))}named(t,e,s,i,o,r,a,l){
t.font=`11px ${l.font}`,!(r<13||t.measureText(e).width+8>i)&&(t.fillStyle=cr(a),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*i,o+.5*r+1),t.textBaseline=
"alphabetic")}marks(t,e,s,i,o,r){t.font=`11px ${r.font}`,t.textAlign="center";let a=e.events.filter(({kind:l})=>l!=="start"&&l!=="end").map(({kind:l,t:c})=>({kind:l,
x:s(c)})).filter(({x:l})=>l>=-1&&l<=o+1);if(t.fillStyle=r.panel,a.length<o/6)for(let{x:l}of a)t.fillRect(l-.5,i,1,5);t.fillStyle=r.ink;for(let{mark:l,x:c}of $r(
a))t.fillText(l,x(c,6,o-6),i-4)}};S();N();O();var hu=1/60,cu=[["traces","player.traces","player.traces_t"],["forces","player.forces","player.forces_f"],["speed","player.rim_speed_2","player.rim_speed_c"],
["whole","player.whole_path","player.whole_path_w"],["three","3D","player.in_space_3"]],Ut=(n,t,e)=>u("button",{type:"button",title:t,"aria-label":t,onclick:e},
n),dl=(n,t)=>u("span",{},u("span",{"aria-hidden":"true"},`${n} `),t),pn=class{constructor(t,e,s,i,o){this.clock=t;this.films=e;this.say=i;this.tell=o;this.titled=
"";this.playButton=Ut(Q("play"),"player.play_space",()=>t.play()),this.playButton.classList.add("play"),this.speeds=u("select",{"aria-label":"player.speed_of_th\
e_film",onchange:()=>{t.speed=Number(this.speeds.value)}},Fe.map(r=>u("option",{value:String(r)},`${r}×`))),this.speeds.value="1",this.switches=new Map(cu.map(
([r,a,l])=>[r,u("button",{type:"button",class:"switch",title:l,onclick:()=>s(r)},a)])),this.row=u("div",{class:"buttons switches"},[...this.switches.values()]),
this.element=u("div",{class:"transport"},u("div",{class:"buttons"},Ut(Q("start"),"player.to_the_start_home",()=>t.seek(0)),Ut(Q("previous"),"player.previous_eve\
nt_shift",()=>this.jump(-1)),Ut(Q("back"),"player.one_frame_back",()=>this.nudge(-1)),this.playButton,Ut(Q("on"),"player.one_frame_on",()=>this.nudge(1)),Ut(Q("\
next"),"player.next_event_shift",()=>this.jump(1))),u("div",{class:"buttons jumps"},Ut(dl("▲","mode.flight"),"player.to_the_next_flight",()=>this.jump(1,"take\
off")),Ut(dl("▼","event.impact"),"player.to_the_next_landing",()=>this.jump(1,"impact"))),this.speeds,this.row)}show(t){let{clock:e,playButton:s}=this;for(let[
o,r]of this.switches)r.setAttribute("aria-pressed",String(t[o]));let i=e.playing?"player.pause_space":"player.play_space";this.titled!==i&&(this.titled=i,s.replaceChildren(
Q(e.playing?"pause":"play")),Et(s,"title",i),Et(s,"aria-label",i)),this.speeds.value!==String(e.speed)&&(this.speeds.value=String(e.speed))}nudge(t){this.clock.
playing=!1,this.clock.seek(this.clock.time+t*hu*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap((m,h)=>m.events.map(
p=>({event:p,lane:h}))).filter(({event:m})=>!e||(e==="impact"?m.kind===e:Or(m))).sort((m,h)=>m.event.t-h.event.t),i=this.clock.time,o=t>0?s.find(({event:m})=>m.
t>i+1e-9):s.findLast(({event:m})=>m.t<i-1e-9);if(!o&&e&&(o=s[0]),!o){e&&this.say(e==="takeoff"?"player.this_motion_has_no":"player.this_motion_has_no_landing");
return}this.clock.seek(o.event.t);let{event:r,lane:a}=o,c={key:"player.what_at_angle_time",values:{what:Nt(r.kind),angle:K(r.angle),time:M(r.t,4)}};this.tell(this.
films().length>1?[["hoops.hoop_a","hoops.hoop_b"][a],": ",c]:c)}};O();var fl="hophoop-steps",de=class{constructor(t,e,s,{hosted:i=!1,panels:o=null,onmotion:r=()=>{}}={}){this.root=t;this.backend=e;this.requested=!1;this.surrounding=
!1;this.taken=null;this.afterFrame=null;this.asked=null;this.frames=0;this.latencies=[];this.hosted=i,this.onmotion=r,ua(t,i);let{colors:a}=s;this.known=s.presets,
this.sameness=new Qs(s.presets),this.clock=new fs,this.motions=new Gs(e,{shown:m=>this.changed(m),refined:()=>this.request(),settled:()=>this.story.announce(this.
films()),noted:m=>this.noted(m),travelled:async m=>this.address?.travel(m),failed:(m,h)=>this.failed(m,h)}),this.notice=new Ws,this.address=i?new ps(this.motions,
this.notice,()=>this.link()):null,this.theme=new mn(t,a,i,()=>this.show()),this.stage=new ln(a,()=>{this.request(),this.address?.soon()}),this.transport=new pn(
this.clock,()=>this.films(),m=>this.toggle(m),m=>this.notice.say(m),m=>this.story.say(m)),this.timeline=new un(this.clock),this.story=new hn(this.clock),this.theory=
new cn,this.plots=new Js(this.clock,a),this.phase=new Xs(e,this.clock,a),this.map=new zs(e,s,{take:m=>{this.clock.time=0,this.motions.change(m,!0)},say:m=>this.
story.say(m),changed:()=>this.address?.soon()}),this.controls=new bs(s.controls,(m,h)=>this.motions.change(m,h)),this.share=new on(this),this.singleKeys=new js(
i),this.about=Zr(s.version,i),this.help=ta(this.about,a,this.singleKeys.element),this.view=new $s(t,i,()=>this.show()),this.hoops=new Ds(m=>this.motions.choose(
m)),this.header=new Is(s.presets,this.share.menu,this.view.button,{take:m=>this.take(m),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.motions.
compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.extras=new Fs(this),this.opening=new Hs(this.clock,this.extras.grips.hint);let{player:l,
sticky:c}=pa(this,o);this.player=l,this.sticky=c,i&&!location.search&&!location.hash&&this.extras.visit.offer(),this.later=ut(()=>this.fetchTheory(),120),this.frame=
this.frame.bind(this),this.clock.listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=ca(this,i),this.sizes=new ResizeObserver(
()=>this.show())}async open(t,e={}){await this.motions.load(t),this.clock.duration=Math.max(...this.films().map(s=>s.duration)),this.sameness.expect(this.films(),
e.fingerprints??[]),this.view.open(this.films(),e),this.restore(e),this.begin(),this.hosted&&e.time===void 0&&!this.view.everything&&this.opening.begin(this.player)}begin(){
this.show();let t=this.hosted?mr(fl):null;this.motions.note(),t&&(this.motions.history.restore(t),this.noted("same")),this.sizes.observe(this.stage.element),this.
root.dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.opening.end(),this.map.close(),this.theme.close(),this.address?.
close(),this.sticky?.close(),this.sizes.disconnect(),this.deaf()}film(t=this.motions.active){return this.motions.film(t)}films(){return this.motions.films()}changed(t=null){
this.notice.clear(),this.show(t)}failed(t,e=[]){this.controls.refuse(e,et(t))||(this.notice.fail(t),this.controls.restore()),this.showPreset()}noted(t){this.header.
show(this.motions.history,this.motions.lanes.length>1),this.address?.write(t),this.hosted&&ur(fl,this.motions.history.written()),this.onmotion(this.film().query)}link(t=this.
sameness.expected(this.films())){let{clock:e,stage:s,map:i,extras:o}=this,{on:r,path:a}=o.more;return this.motions.link(yr({time:e.time,...s.view(),more:r?a:void 0,
map:i.shown(),fingerprints:t}))}restore({time:t,map:e,options:s,more:i,...o}){let r=s?.three?this.toggle("three"):Promise.resolve();this.stage.restore({options:s,
...o}),r.then(()=>this.stage.restore(o)),e&&this.map.restore(e),i&&this.extras.more.turn(!0,i),t&&this.clock.seek(t)}showPreset(){let{query:t}=this.film(),e=this.
known.find(s=>s.query===t);this.header.presets.value=e?.key??"",L(this.hoops.text,e?.text??"")}async take(t){this.taken=t;try{let e=await this.backend.film({query:t.
query});if(this.taken!==t)return;this.clock.time=0,this.motions.replace(e),this.story.announce(this.films())}catch(e){this.failed(e)}}async load(t){try{let e=await this.
backend.film({query:t});this.clock.play(!1),this.clock.time=0,this.motions.replace(e)}catch(e){this.notice.fail(e)}}mark(t,e){this.root.classList.toggle(t,e)}marked(t){
return this.root.classList.contains(t)}travel(t){return this.motions.travel(t)}show(t=null){let{motions:e,clock:s}=this,i=this.films();if(!i.length)return;let o=i.
length>1;this.theme.read(),s.duration=Math.max(...i.map(r=>r.duration)),s.time=Math.min(s.time,s.duration),this.root.classList.toggle("two",o),this.header.show(
e.history,o),this.hoops.show(i.length,e.active),this.drawStage(),this.controls.show(this.film(),this.motions.waiting()),this.view.show(i),this.showPreset(),t!==
null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-t),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(
()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let t=this.films(),{active:e}=this.motions,{look:s,colors:i}=this.theme;this.plots.draw(
t,e,s),this.phase.draw(t,e,s),this.story.draw(t,e,i,this.sameness.of(t[e])),this.drawTime(),this.map.mark(this.film(),s),this.stage.describe(t),this.extras.changed(),
this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{time:t}=this.clock;this.surrounding||(this.timeline.
draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(t),this.phase.cursor(t),this.story.cursor(t),this.transport.show(this.stage.options))}request(){
this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){this.requested=!1,this.motions.lanes.length&&(this.clock.tick(t),this.motions.refine(
this.clock.time,this.clock.playing?2*this.clock.speed:0),this.drawStage(),this.drawTime(),this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&
this.request())}async fetchTheory(){let{scenario:t}=this.film();this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked;try{this.theory.draw(
await this.backend.theory(t,e),this.motions.name()),await this.phase.fetch(t,e)}catch(s){s.name!=="AbortError"&&this.theory.draw([{label:"–",text:et(s)}])}}async toggle(t){
let{options:e}=this.stage;if(t!=="three")e[t]=!e[t];else try{await this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(et(s))}this.transport.show(e),
this.address?.soon(),this.request()}};var mu={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function Ve(n){let t=n instanceof DataView||ArrayBuffer.isView(n)?n:new DataView(n),e=new Uint8Array(t.buffer,
t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(e.subarray(
4,4+s))),o={};for(let{name:r,type:a,shape:l,place:c}of i.arrays){let m=l.reduce((h,p)=>h*p,1);o[r]=new mu[a](e.buffer,e.byteOffset+4+s+c,m)}return{header:i,arrays:o}}O();var uu=4,pu="backend.the_server_does_not",dn=class{constructor(t){this.base=t}async motion(t,e){let s={method:"POST",headers:{"Content-Type":"application/js\
on"},body:JSON.stringify(t),signal:e};return Ve(await(await this.answered(new URL("lab/motion",this.base),s)).arrayBuffer())}async file(t,e){return(await this.answered(
new URL(`api/v1/files/${t}?${e}`,this.base))).blob()}async answered(t,e){for(let s=uu;;s--){let i=await fetch(t,e).catch(r=>{throw r.name==="AbortError"?r:new Error(
pu)});if(i.ok)return i;let o=Number(i.headers.get("Retry-After"));if(i.status!==503||!(o>0)||s<=1){let{detail:r}=await i.json().catch(()=>({}));throw i.status===
503?new rt({key:"server.busy",values:{count:o}}):i.status===413?new Error("server.too_much"):i.status===500?new Error("server.failed"):r?new Error(r):new rt({key:"\
backend.the_server_answered_status",values:{status:i.status}})}await new Promise(r=>setTimeout(r,1e3*Math.min(o,10))),e?.signal?.throwIfAborted()}}},du=2e4,fu=3e5,
fn=class{constructor(t){this.model=t;this.waiting=new Map;this.number=0;this.view=Math.random().toString(36).slice(2);this.listen=(e,s)=>this.answered(e,s),t.on(
"msg:custom",this.listen)}answered(t,e){let s=t?.view===this.view&&this.waiting.get(t.number);s&&(clearTimeout(s.timer),this.waiting.delete(t.number),t.error?s.
reject(new Error(t.error)):s.resolve(Ve(e[0])))}ask(t,e,s){let i=++this.number;return new Promise((o,r)=>{let a=setTimeout(()=>{this.waiting.delete(i),r(new Error(
"backend.the_notebooks_kernel_does"))},t==="file"?fu:du);this.waiting.set(i,{resolve:o,reject:r,timer:a}),s?.addEventListener("abort",()=>{clearTimeout(a),this.
waiting.delete(i),r(new DOMException("superseded","AbortError"))}),this.model.send({view:this.view,number:i,call:t,body:e})})}motion(t,e){return this.ask("motio\
n",t,e)}async file(t,e){let{arrays:s}=await this.ask("file",{query:e,name:t});return new Blob([s.content])}async derivatives(){return(await this.ask("derivative\
s",{})).arrays.content}close(){this.model.off("msg:custom",this.listen)}};Ht();Ht();var Ji=class extends rt{},Qi=class{constructor(t,e){this.start=t;this.compiled=e;this.number=0;this.waiting=null;this.worker=this.begun()}begun(){let t=this.
start();return t.onmessage=({data:e})=>{if(e.number!==this.number||!this.waiting)return;let{resolve:s,reject:i}=this.waiting;this.waiting=null,e.error?i(new Error(
e.error)):s(e.answer)},t.onerror=e=>this.fail(new Error(e.message||"kernel.not_started")),t.postMessage({compiled:this.compiled}),t}fail(t){this.waiting?.reject(
t),this.waiting=null}stop(t){this.worker.terminate(),this.worker=this.begun(),this.fail(t)}ask(t,e,s){this.number++;let i=new Promise((o,r)=>{this.waiting={resolve:o,
reject:r}});return this.worker.postMessage({number:this.number,call:t,values:e},s),i}},fe=class{constructor(t,e,s,i){this.start=t;this.compiled=e;this.size=s;this.
limit=i;this.idle=[];this.hired=0;this.queue=[]}hand(){let t=this.idle.pop();return t?Promise.resolve(t):this.hired<this.size?(this.hired++,Promise.resolve(new Qi(
this.start,this.compiled))):new Promise(e=>this.queue.push(e))}release(t){let e=this.queue.shift();e?e(t):this.idle.push(t)}async ask(t,e,s,i=[]){s?.throwIfAborted();
let o=await this.hand(),r=()=>o.stop(new DOMException("superseded","AbortError")),a=setTimeout(()=>o.stop(new Ji({key:"kernel.stopped",values:{time:this.limit/1e3}})),
this.limit);try{return s?.throwIfAborted(),s?.addEventListener("abort",r),await o.ask(t,e,i)}finally{clearTimeout(a),s?.removeEventListener("abort",r),this.release(
o)}}close(){for(let t of this.idle)t.worker.terminate()}};var gn=class{constructor(t){this.exports=t;this.rooms=new Map}room(t,e){let s=this.rooms.get(t);if(s&&s.bytes>=e)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(t);let i=this.exports.malloc(e);if(!i)throw new RangeError("kernel.no_memory");return this.rooms.set(t,{place:i,bytes:e}),i}floats(t,e){return new Float64Array(
this.exports.memory.buffer,t,e)}put(t,e){let s=this.room(t,8*Math.max(e.length,1));return this.floats(s,e.length).set(e),s}};var gu=150,_u=240,bu=6e3,[Py,gl,_l]=[0,1,2],yu={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["fri\
ction_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_norm\
al","damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function Zi(n,t,e){let{rows:s,count:i,duration:o}=t,[r,a]=(e??[0,o]).map(_=>Math.
min(Math.max(_,0),o)),l=Math.min(Math.max(Math.ceil((a-r)*gu),_u),bu),c=v.events.length,m=new Set;for(let _=0;_<=l&&o>0;_++)m.add(_===l?a:r+_*((a-r)/l));let h=new Set;
for(let _=0;_<i;_++){let b=Math.min(s[_*c+z.t],o);b>=r&&b<=a&&h.add(b)}for(let _ of h)m.add(_);let p=Float64Array.from(m).sort(),d=Float64Array.from(h).filter(_=>_>
0).sort(),f=n.states(t,p,!1),g=n.states(t,d,!0);return to(p,f,d,g)}function to(n,t,e,s){let i=n.length+e.length,o=v.samples.length,r=new Float64Array(i),a=new Float64Array(
i*o),l=0,c=0;for(let h=0;h<n.length;h++)c<e.length&&e[c]<=n[h]&&(r[l]=e[c],a.set(s.subarray(c*o,(c+1)*o),l*o),l++,c++),r[l]=n[h],a.set(t.subarray(h*o,(h+1)*o),l*
o),l++;let m={t:r};for(let[h,p]of Object.entries(yu)){let d=new Float64Array(i).fill(-0);for(let f of p)for(let g=0;g<i;g++)d[g]+=a[g*o+xn[f]];m[h]=d}return m.mode=
wu(a,i,m.omega),m}function wu(n,t,e){let s=v.samples.length,i=new Float64Array(t),o=0;for(let r=t-1;r>=0&&!o;r--)o=Math.sign(e[r])||0;for(let r=t-1;r>=0;r--){o=
Math.sign(e[r])||o;let a=n[r*s+xn.mode],l=a===gl?-1:a===_l?1:0;i[r]=l===0?a:l*o<0?gl:_l}return i}var vu=n=>n/2**32|0,xu=n=>n>>>0;function bl(n,t,e,s){let i=vu(e),o=xu(e);n.setUint32(t,s?o:i,s),n.setUint32(t+4,s?i:o,s)}function yl(n){return n instanceof Uint8Array||ArrayBuffer.isView(n)&&n.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in n&&n.BYTES_PER_ELEMENT===1}var eo=n=>n?
`"${n}" `:"";function ku(n,t=""){if(typeof n!="number")throw new TypeError(eo(t)+"expected number, got "+typeof n);if(!Number.isSafeInteger(n)||n<0)throw new RangeError(
eo(t)+"expected integer >= 0, got "+n);return n}function so(n,t,e=""){if(yl(n)&&(t===void 0||n.length===t))return n;t!==void 0&&ku(t,"length");let s=yl(n),i=t!==void 0?` of length ${t}`:"",o=s?`length=${n.length}`:
`type=${typeof n}`,r=eo(e)+"expected Uint8Array"+i+", got "+o;throw s?new RangeError(r):new TypeError(r)}var Mu=(n,t)=>{if(n===null||typeof n!="object"||Array.isArray(n))throw new TypeError((t==="object"?"":`"${t}" `)+"expected object, got type="+typeof n)},wl=(n,t)=>{
Mu(n,t);let e=Object.getPrototypeOf(n);if(e!==Object.prototype&&e!==null)throw new TypeError(`"${t}" expected plain object`);if(Object.hasOwn(n,"__proto__"))throw new TypeError(
`"${t}.__proto__" is not allowed`)};function no(n,t=!0){if(n.destroyed)throw new Error("hash was destroyed");if(t&&n.finished)throw new Error("digest() was alre\
ady called")}function vl(n,t){so(n,void 0,"output");let e=t.outputLen;if(!(n.length>=e))throw new RangeError('"output" expected length >= '+e)}function io(...n){for(let t=0;t<n.length;t++)n[t].fill(0)}function _n(n){return new DataView(n.buffer,n.byteOffset,n.byteLength)}function yt(n,t){return n<<32-t|
n>>>t}function Eu(n,t,e="opts"){return wl(n,"defaults"),t!==void 0&&wl(t,e),Object.assign(Object.create(null),n,t)}function xl(n,t={}){if(typeof n!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof n);t=Eu({},t,"info");let e=(i,o)=>n(o).update(i).digest(),s=n(void 0);return e.outputLen=s.outputLen,e.blockLen=
s.blockLen,e.canXOF=s.canXOF,e.create=i=>n(i),Object.assign(e,t),Object.freeze(e)}var kl=n=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,n])});function Ml(n,t,e){return n&t^~n&e}function El(n,t,e){return n&t^n&e^t&e}var bn=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(t,e,s,i){
this.blockLen=t,this.outputLen=e,this.padOffset=s,this.isLE=i,this.buffer=new Uint8Array(t),this.view=_n(this.buffer)}update(t){no(this),so(t);let{view:e,buffer:s,
blockLen:i}=this,o=t.length,r=!1;for(let a=0;a<o;){let l=Math.min(i-this.pos,o-a);if(l===i){let c=_n(t);for(;i<=o-a;a+=i)this.process(c,a);r=!0;continue}s.set(a===
0&&l===o?t:t.subarray(a,a+l),this.pos),this.pos+=l,a+=l,this.pos===i&&(this.process(e,0),this.pos=0,r=!0)}return this.length+=t.length,r&&this.roundClean(),this}digestInto(t){
no(this),vl(t,this),this.finished=!0;let{buffer:e,view:s,blockLen:i,isLE:o}=this,{pos:r}=this;e[r++]=128,e.fill(0,r),this.padOffset>i-r&&(this.process(s,0),e.fill(
0)),bl(s,i-8,this.length*8,o),this.process(s,0),this.roundClean();let a=t===e?s:_n(t),l=this.outputLen,c=l/4,m=this.get();if(l%4||c>m.length)throw new Error("in\
valid outputLen");for(let h=0;h<c;h++)a.setUint32(4*h,m[h],o)}digest(){let{buffer:t,outputLen:e}=this;this.digestInto(t);let s=t.slice(0,e);return this.destroy(),
s}_cloneIntoMeta(t){let{buffer:e,length:s,finished:i,destroyed:o,pos:r}=this;return t.destroyed=o,t.finished=i,t.length=s,t.pos=r,r&&t.buffer.set(e),t}clone(){return this.
_cloneInto()}},Tl=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var Tu=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),Gt=new Uint32Array(64),oo=class extends bn{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(t,e){super(64,t,
8,!1),this.A=e[0]|0,this.B=e[1]|0,this.C=e[2]|0,this.D=e[3]|0,this.E=e[4]|0,this.F=e[5]|0,this.G=e[6]|0,this.H=e[7]|0}get(){let{A:t,B:e,C:s,D:i,E:o,F:r,G:a,H:l}=this;
return[t,e,s,i,o,r,a,l]}set(t,e,s,i,o,r,a,l){this.A=t|0,this.B=e|0,this.C=s|0,this.D=i|0,this.E=o|0,this.F=r|0,this.G=a|0,this.H=l|0}_cloneInto(t){return(t||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(t)}process(t,e){for(let h=0;h<16;h++,e+=4)Gt[h]=t.getUint32(e,!1);for(let h=16;h<64;h++){let p=Gt[h-15],d=Gt[h-
2],f=yt(p,7)^yt(p,18)^p>>>3,g=yt(d,17)^yt(d,19)^d>>>10;Gt[h]=g+Gt[h-7]+f+Gt[h-16]|0}let{A:s,B:i,C:o,D:r,E:a,F:l,G:c,H:m}=this;for(let h=0;h<64;h++){let p=yt(a,6)^
yt(a,11)^yt(a,25),d=m+p+Ml(a,l,c)+Tu[h]+Gt[h]|0,g=(yt(s,2)^yt(s,13)^yt(s,22))+El(s,i,o)|0;m=c,c=l,l=a,a=r+d|0,r=o,o=i,i=s,s=d+g|0}s=s+this.A|0,i=i+this.B|0,o=o+
this.C|0,r=r+this.D|0,a=a+this.E|0,l=l+this.F|0,c=c+this.G|0,m=m+this.H|0,this.set(s,i,o,r,a,l,c,m)}roundClean(){io(Gt)}destroy(){this.destroyed=!0,this.set(0,0,
0,0,0,0,0,0),io(this.buffer)}},ro=class extends oo{constructor(){super(32,Tl)}};var Sl=xl(()=>new ro,kl(1));var Al=["t","x","height","angle","vx","vy","omega","slip"],Su=16,Au=0x7ff8000000000000n;function Pl(n,t){let e=new TextEncoder,s=Sl.create(),i=new DataView(new ArrayBuffer(
8*Al.length)),o=new Uint8Array(i.buffer);for(let a=0;a<t;a++){let l=a*v.events.length;s.update(e.encode(v.kinds[n[l+z.kind]])),Al.forEach((c,m)=>{let h=n[l+z[c]];
Number.isNaN(h)?i.setBigUint64(8*m,Au,!0):i.setFloat64(8*m,h+0,!0)}),s.update(o)}return Array.from(s.digest(),a=>a.toString(16).padStart(2,"0")).join("").slice(
0,Su)}function Ll(n,t){let e=new Map,s=new Float64Array(t);for(let i=0;i<t;i++){let o=Pu(n.subarray(i*v.keys,(i+1)*v.keys));if(o===""){s[i]=Number.NaN;continue}let r=e.
get(o);r===void 0&&(r=e.size,e.set(o,r)),s[i]=r}return{values:s,sequences:[...e.keys()]}}function Pu(n){let t="";for(let e of n){let s=e;for(let i=0;i<v.letters_a_key&&
s;i++){let o=Number(s&7n);s>>=3n,o&&(t+=o===v.more?"+":v.letters[o-1])}}return t}var Lu=256,Cu=2048,Ru=4096,Ou=2e5,Nu=v.statuses.indexOf("buffer"),Fu=2,Iu=new Set(v.passing),ao=n=>Number.isFinite(n)?n:null,yn=class{constructor(t){this.kept=[];
this.turn=0;this.exports=new WebAssembly.Instance(t,{}).exports,this.exports._initialize?.(),this.memory=new gn(this.exports),this.mostEvents=Lu,this.mostSegments=
Cu,this.mostRows=Ru}call(t,...e){let s=this.exports[t](...e);if(s)throw new Error(`The kernel ended ${t} with ${s}.`)}compute(t){let{memory:e}=this,s=v.events.length;
for(;;){let i=e.room("table",8*s*this.mostEvents),o=e.room("heads",8*v.heads.length);t.contact?this.computeCompliant(t,t.contact,i,o):this.computeRigid(t,i,o);let r=e.
floats(o,v.heads.length).slice(),a=r[wt.events];if(r[wt.status]===Nu)this.makeRoom(t,r[wt.segments]);else if(a===this.mostEvents&&a<t.max_events)this.mostEvents*=
4;else{let l=e.floats(i,a*s).slice();return{given:t,head:r,rows:l,count:a,duration:r[wt.duration],segments:r[wt.segments]}}}}computeRigid(t,e,s){let{memory:i}=this,
o=i.put("cell",Ft(t)),r=i.room("events",v.event_bytes*this.mostEvents),a=i.room("segments",v.segment_bytes*this.mostSegments);this.call("motion",o,r,this.mostEvents,
a,this.mostSegments,e,s)}computeCompliant(t,e,s,i){let{memory:o}=this,r=o.put("cell",Ft(t)),a=o.put("contact",_e(e)),l=o.room("events",v.event_bytes*this.mostEvents),
c=o.room("rows",v.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",r,a,l,this.mostEvents,Ou,c,this.mostRows,s,i)}makeRoom(t,e){t.contact?this.
mostRows=e:this.mostSegments*=4}motion(t){return Cl(this.compute(t))}film(t){let e=this.compute(t),[s,i]=t.contact?["rows",v.compliant_segment_bytes]:["segments",
v.segment_bytes],o=this.memory.room(s,8),r=new Uint8Array(this.exports.memory.buffer,o,i*e.segments).slice();return{motion:Cl(e),columns:Zi(this,e),pieces:r}}instant(t,e,s){
let i=e.length/(t.contact?v.compliant_segment_bytes:v.segment_bytes);this.memory.put("cell",Ft(t)),t.contact&&this.memory.put("contact",_e(t.contact));let o=Float64Array.
of(s),r=this.states({given:t,segments:i},o,!1,this.placeOf(e)),a=new Float64Array(0);return to(o,r,a,a)}placeOf(t){let e=this.kept.find(o=>o.pieces===t);if(e)return e.
place;let{turn:s}=this;this.turn=(s+1)%Fu;let i=this.memory.room(`pieces ${s}`,Math.max(t.length,1));return new Uint8Array(this.exports.memory.buffer,i,t.length).
set(t),this.kept[s]={pieces:t,place:i},i}columns(t,e){return Zi(this,this.compute(t),e)}samples(t,e){let s=this.states(this.compute(t),e,!1),i=v.samples.length;
return Object.fromEntries(v.samples.map((o,r)=>[o,Float64Array.from(e,(a,l)=>s[l*i+r])]))}states(t,e,s,i){return this.rows("samples",v.samples.length,t,e,s,i)}margins(t,e,s=!1){
if(t.contact)throw new TypeError("A compliant contact has no such rules.");let i=v.margins.length,o=this.rows("margins",i,this.compute(t),e,s);return Object.fromEntries(
v.margins.map((r,a)=>[r,Float64Array.from(e,(l,c)=>o[c*i+a])]))}rows(t,e,s,i,o,r){let{memory:a}=this,l=i.length*e,c=a.put("times",i),m=a.room("states",8*Math.max(
l,1)),h=a.room("cell",8),p=[s.segments,c,i.length,Number(o),m];return s.given.contact?this.call("compliant_samples",h,a.room("contact",8),r??a.room("rows",8),...p):
this.call(t,h,r??a.room("segments",8),...p),a.floats(m,l).slice()}changes(t,e){let{memory:s}=this,i=this.compute(t),o=s.put("rates",e),r=this.side(i,o,1),{reason:a,
sided:l}=r,c=l||a==="border"||a==="contact"?this.side(i,o,-1):r;return{count:i.count,larger:r,smaller:c}}side({count:t,segments:e,head:s},i,o){let{memory:r}=this,
a=t*v.changes.length,l=r.room("changes",8*a),c=r.room("why",16),[m,h,p]=["cell","events","segments"].map(_=>r.room(_,8)),d=s[wt.doubt_from];this.call("changes",
m,i,1,o,h,t,p,e,d,l,c);let[f,g]=r.floats(c,2);return{rates:r.floats(l,a).slice(),reason:v.reasons[Math.max(f,0)],sided:f<0,failed:g}}thresholds(t){let{memory:e}=this,
s=e.put("cell",Ft(t)),i=e.room("answers",8*v.thresholds.length),o=t.rolling&&t.angle===0;this.call("thresholds",s,o?t.vx:Number.NaN,i);let r=e.floats(i,v.thresholds.
length),a=c=>{let m=r[v.thresholds.indexOf(c)];return Number.isNaN(m)?null:m},l=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a(
"first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immediate_hop_speed"),needed_friction:a("needed_friction"),painleve_friction:a("\
painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:l.filter(c=>c!==null),stable_angle:a("stable_angle"),massless_loss_angle:a("massless_loss_angl\
e"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(t,[e,s,i,o],r,a){let{memory:l}=this,c=l.put("cell",Ft(t)),m=l.room("modes",r*a),h=l.room(
"sides",2*r);this.call("regions",c,e,s,i,o,r,a,m,h);let{buffer:p}=this.exports.memory;return{modes:new Uint8Array(p,m,r*a).slice(),paradox:Float32Array.from(new Int8Array(
p,h,2*r))}}map({count:t,rows:e},s,i){let{memory:o}=this,r=o.put("cells",e),a=o.room("numbers",8*t*v.numbers.length),l=o.room("words",4*t*v.words.length),c=o.room(
"keys",8*t*v.keys),{angle:m,stop:h,timed:p}=v.spans[i],d=v.wanted[s];this.call("map_cells",r,t,m??Number.NaN,h,p,d,a,l,c);let{buffer:f}=this.exports.memory;if(s===
"sequence")return Ll(new BigUint64Array(f,c,t*v.keys),t);let g=new Float64Array(t);if(s in kn){let _=new Int32Array(f,l,t*v.words.length);for(let b=0;b<t;b++)g[b]=
_[b*v.words.length+kn[s]]}else{let _=o.floats(a,t*v.numbers.length);for(let b=0;b<t;b++)g[b]=_[b*v.numbers.length+bo[s]]}return{values:g}}ideal(t){let e=this.memory.
room("answers",8*v.thresholds.length);return this.call("ideal_hoop",t,e),this.memory.floats(e,1)[0]}refused(t){let e=this.memory.put("cell",Ft(t)),s=this.memory.
put("contact",_e(t.contact)),i=this.memory.room("answers",8*v.thresholds.length);this.call("refused",e,s,+!t.contact,i);let[o,r]=this.memory.floats(i,2);return[
o,r]}combine(t,e){let{memory:s}=this,i=s.put("parts",e.flatMap(Hu)),o=s.room("answers",8*v.thresholds.length),r=s.room("reaches",8*e.length);this.call("hoop_of_\
parts",t,i,e.length,o,r);let[a,l,c]=s.floats(o,3);return{mass:a,eccentricity:l,inertia_ratio:c,reaches:[...s.floats(r,e.length)]}}chosen(t){let e=this.memory.put(
"cell",Ft(t)),s=this.memory.put("contact",_e(t.contact)),i=this.memory.room("answers",8*v.thresholds.length);this.call("compliance",e,s,i);let o=this.memory.floats(
i,v.chosen.length);return Object.fromEntries(v.chosen.map((r,a)=>[r,o[a]]))}};function Hu(n){let t=n.shape==="rod"?`${n.direction}_rod`:n.shape,e=v.shapes.indexOf(
t);return n.shape==="ring"?[e,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[e,n.mass,n.radius,0,n.at]:n.shape==="rod"?[e,n.mass,n.length,0,n.at]:[e,
n.mass,0,0,n.at]}var $u=["friction","impact_normal","impact_tangential","rolling_resistance"],Du=["kinetic","potential",...$u,"residual"],Rl=["x","height","angl\
e","vx","vy","omega"];function Cl({given:n,head:t,rows:e,count:s,duration:i}){let o=v.events.length,r=Array.from({length:s},(m,h)=>ju(e.subarray(h*o,(h+1)*o))),
a=r[s-1],l=Object.fromEntries([...Du,...n.contact?["spring","damping"]:[]].map(m=>[m,t[wt[m]]])),c=ao(t[wt.doubt_from]);return{status:v.statuses[t[wt.status]],sequence:qu(
r),fingerprint:c===null?Pl(e,s):null,duration:i,events:r,final:{t:a.t,mode:a.to,...Object.fromEntries(Rl.map(m=>[m,a[m]]))},energy:l,doubt:c}}function ju(n){let t=v.
kinds[n[z.kind]],e=n[z.from_mode],s={t:n[z.t],kind:t,from:e<0?null:v.letters[e],to:v.letters[n[z.to_mode]]};for(let i of Rl)s[i]=ao(n[z[i]]);return s.before=Object.
fromEntries(["vx","vy","omega"].map(i=>[i,ao(n[z[`before_${i}`]])])),s.impulse={normal:n[z.impulse_normal],tangential:n[z.impulse_tangential]},n[z.collision]===
0&&(s.collision=!1),t==="kane_gain"&&(s.gain=n[z.gain]),n[z.stable]>=0&&(s.stable=n[z.stable]===1),s}function qu(n){let t=n.filter((s,i)=>i===n.length-1||!Iu.has(
s.kind));return t.slice(0,-1).map((s,i)=>t[i+1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var lo=1e4,Bu="kernel.the_part_of_the",ho=256;function Ol(n){let t=URL.createObjectURL(new Blob([n],{type:"text/javascript"}));return()=>new Worker(t,{type:"mod\
ule"})}async function Nl(n){let t=await fetch(n);if(!t.ok)throw new rt({key:"kernel.not_loaded",values:{status:t.status}});return t.headers.get("Content-Type")===
"application/wasm"?WebAssembly.compileStreaming(t):WebAssembly.compile(await t.arrayBuffer())}async function Fl(n){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream(
"gzip"));return WebAssembly.compile(await new Response(t).arrayBuffer())}var Ye=class n{constructor(t,e,s){this.start=e;this.derivatives=s;this.rates=null;this.
mechanics=new yn(t),this.motions=new fe(e,t,2,lo);let i=navigator.hardwareConcurrency||2;this.maps=new fe(e,t,Math.max(1,Math.min(i-1,8)),lo)}static async load(t){
let e=await Nl(new URL(`hophoop.wasm?${v.module}`,t)),s=()=>Nl(new URL(`hophoop-derivatives.wasm?${v.derivatives}`,t)),i=new URL(`kernel.js?${v.module}`,t);return i.
origin===globalThis.location?.origin?new n(e,()=>new Worker(i,{type:"module"}),s):new n(e,Ol(await(await fetch(i)).text()),s)}static async unpack(t,e,s){return new n(
await Fl(t),Ol(e),async()=>Fl(await s()))}motion(t,e){return this.motions.ask("motion",[t],e)}film(t,e){return this.motions.ask("film",[t],e)}columns(t,e,s){return this.
motions.ask("columns",[t,s],e)}samples(t,e,s){return this.motions.ask("samples",[t,e],s)}async changes(t,e,s){return this.rates??=this.derivatives().then(o=>new fe(
this.start,o,1,lo)),(await this.rates.catch(()=>{throw this.rates=null,new Error(Bu)})).ask("changes",[t,e],s)}thresholds(t,e){return this.motions.ask("threshol\
ds",[t],e)}regions(t,e,s,i,o){return this.motions.ask("regions",[t,e,s,i],o)}async map({count:t,rows:e},s,i,o){let r=v.cell.length,a=new Float64Array(t).fill(Number.
NaN),l=[],c=async h=>{let p=Math.min(ho,t-h),d=new Float64Array(r*p);for(let _=0;_<r;_++)d.set(e.subarray(_*t+h,_*t+h+p),_*p);let f=await this.maps.ask("map",[{
count:p,rows:d},s,i],o,[d.buffer]),g=f.sequences?.map(_=>(l.includes(_)||l.push(_),l.indexOf(_)));for(let _=0;_<p;_++)a[h+_]=g?g[f.values[_]]??Number.NaN:f.values[_]},
m=Array.from({length:Math.ceil(t/ho)},(h,p)=>p*ho);return await Promise.all(m.map(c)),s==="sequence"?{values:a,sequences:l}:{values:a}}close(){this.motions.close(),
this.maps.close(),this.rates?.then(t=>t.close()).catch(()=>{})}};var zu=360,Uu=240,co={"motion.toml":"application/toml","motion.csv":"text/csv; charset=utf-8","motion.json":"application/json"},Gu=["motion.nc","motion.mp4","mo\
tion.gif"],wn=class{constructor(t,e,{base:s=null,python:i=null}={}){this.kernel=t;this.mechanics=e;this.base=s,this.python=i,this.shares=s!==null,this.files=[...Object.
keys(co),...i?Gu:[]]}async film(t,e){e?.throwIfAborted();let s=it(t,this.mechanics),i=tt(Ct(s)),{python:o}=this,{motion:r,columns:a,pieces:l}=this.kernel.film?await this.
kernel.film(i,e):{motion:await this.kernel.motion(i,e),columns:await this.kernel.columns(i,e),pieces:null},{doubt:c}=r;if(c!==null&&o){let d=Ae(s),f=async g=>(await o.
motion({query:d,window:g})).arrays;return{...this.shown(await o.motion({query:d},e),s),samples:f}}let m=await this.turning(i,r,e),h=ls(s,r,m,this.mechanics),p=this.
mechanics.instant?.bind(this.mechanics);return{header:c===null?h:{...h,doubt:In(c)},arrays:a,exact:p&&l?d=>p(i,l,d):void 0}}async exact(t){let{exact:e,samples:s}=await this.
film({scenario:t});return{exact:e,samples:s}}readable(t){return ri(t,this.mechanics)}shown({header:t,arrays:e},s=Se(t.query,this.mechanics)){return{header:ls(s,
t,o=>t.turning[o],this.mechanics),arrays:e}}async samples(t,e,s){let i=it({scenario:t},this.mechanics);return this.kernel.columns(tt(Ct(i)),s,e)}async turning(t,{
events:e},s){let i=Jn(e);if(!i.length)return()=>0;let o=Float64Array.from(i,a=>Qn(e,a)),{omega:r}=await this.kernel.samples(t,o,s);return a=>r[i.indexOf(a)]}code(t){
let e=it({scenario:t},this.mechanics);return{python:Vn(e),toml:os(e)}}async theory(t,e){e?.throwIfAborted();let s=it({scenario:t},this.mechanics);return hi(s,await this.
kernel.thresholds(tt(s),e))}async regions(t,e,s){s?.throwIfAborted();let i=tt(it({scenario:t},this.mechanics));return this.kernel.regions(i,e,zu,Uu,s)}async changes(t,e,s){
if(!this.kernel.changes)throw new TypeError("This kernel has no derivatives.");let i=Ct(it({scenario:t},this.mechanics)),o=tt(i);if(o.contact)throw new I(G("com\
pliant_changes"));let r=ai(i,e);if(!r)return null;let{rates:a,smaller:l,larger:c}=r,m=await this.kernel.changes(o,a,s);return{count:m.count,smaller:l?m.smaller:
null,larger:c?m.larger:null}}async map(t,e){e?.throwIfAborted();let{checked:s,x:i,y:o,what:r}=oi(t,this.mechanics),a=$n(s,{x:i,y:o,what:r}),l=await Gn(a,{x:i,y:o},
this.mechanics,e);return Kn({x:i,y:o,what:r},await this.kernel.map(l,r,Wn(r),e))}async file(t,e){if(!(t in co)){if(this.python&&/\.(mp4|gif)$/.test(t)&&Hn(it({query:e},
this.mechanics)),this.python)return this.python.file(t,e);throw new I({key:"save.needs_python",values:{name:t}})}return new Blob([await this.fileText(t,e)],{type:co[t]})}async fileText(t,e){
let s=it({query:e},this.mechanics);if(t==="motion.toml")return os(s);let i=Ct(s),o=tt(i),r=await this.kernel.motion(o);if(r.doubt!==null&&this.python)return(await this.
python.file(t,e)).text();if(t==="motion.json")return si(i,r);let a=ni(r.duration);return ii(a,await this.kernel.samples(o,a))}link(t,e){return this.base&&`${new URL(
t?`?${t}`:"",this.base)}${e}`}};async function Il(n,t){let e=await n.catch(s=>{throw typeof WebAssembly=="object"&&!(s instanceof WebAssembly.CompileError)?s:new Error("page.this_needs_a_brows\
er")});return new wn(e,e.mechanics,t)}function mo(n,t,e){return Il(Ye.load(n),{base:e,python:t&&new dn(t)})}function Hl(n,t){let e=Ye.unpack(n.get("module"),n.get(
"worker"),()=>t.derivatives());return Il(e,{python:t})}function $l(n){navigator.serviceWorker?.register(n).catch(()=>{})}O();S();O();var Dl=new URL("./",import.meta.url);function ql(n){return Je(async t=>{let e=await fetch(new URL(`words.${t}.json?ffed6a535371fa98a0ae1f5c8a376399`,
n));if(!e.ok)throw new Error(`words.${t}.json: ${e.status}`);return e.json()}),oe(ui()).catch(()=>{})}function Wu(n){let t=async()=>{let s=new Blob([n]).stream().
pipeThrough(new DecompressionStream("gzip"));return new Response(s).json()},e;return Je(async s=>(e??=t(),(await e)[s])),oe(ui()).catch(()=>{})}async function Ku(n){
let t=new URL("./",document.baseURI.split(/[?#]/)[0]),e=document.querySelector("meta[name=hophoop-site]"),s,i=ql(Dl);try{s=await mo(Dl,e?null:t,t)}catch(m){await i,
L(n,et(m));return}await i,e&&$l(e.getAttribute("content")??"");let o=new de(n,s,E.setup,{hosted:!0});Object.assign(globalThis,{hophoopLab:o});let r=wr(location.
hash),a=o.address,{links:l,said:c}=a.read(fi());try{await o.open(l,r),c()}catch(m){a.held=!0,await o.open([""]),o.notice.fail(m)}}async function _w(n,t,e,s){let i=ql(
t),o=await mo(t,null,new URL("../",t));await i;let r=new de(n,o,E.setup,{panels:s});return await r.open([e]),r}async function Vu({model:n,el:t}){let e=document.
createElement("div");t.append(e);let s=Wu(n.get("words")),i=new fn(n),o;try{o=await Hl(n,i),await s}catch(c){return await s,L(e,et(c)),()=>i.close()}let r=()=>o.
shown(Ve(n.get("film"))),a=new de(e,o,E.setup,{panels:n.get("panels"),onmotion:c=>{n.get("query")!==c&&(n.set("query",c),n.save_changes())}});a.motions.set([r()]),
a.begin();let l=()=>a.motions.replace(r());return n.on("change:film",l),()=>{n.off("change:film",l),i.close(),a.close()}}var jl=document.getElementById("hophoop\
-lab");jl&&Ku(jl);var bw={render:Vu};export{It as current,bw as default,xi as languageMenu,_w as mount,Et as name,pi as repeat,L as say,ql as speakFrom,P as t};
