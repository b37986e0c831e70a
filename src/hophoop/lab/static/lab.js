/* Built from web/lab/shell/main.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
var w={sources:"8b55b304b90bb2841a2033a0ba629ce4",module:"08ddd1356e3298fb",derivatives:"caff7ba008cdc5ef",built_with:{numba:"0.68.1",llvmlite:"0.50.0",numpy:"2\
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
"buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var Ot=n=>Object.fromEntries(n.map((t,e)=>[t,e])),Fo=Ot(w.cell),ht=Ot(w.heads),F=Ot(w.events),Xs=Ot(w.samples),Io=Ot(w.changes),$o=Ot(w.numbers),Qs=Ot(w.words),
Ba={law:({impact_law:n})=>w.impact_laws.indexOf(n),strike:({painleve:n})=>+(n==="impact"),allowed:()=>1},Qt=w.cell.map(n=>Ba[n]??(t=>Number(t[n]??0))),St=n=>Float64Array.
from(Qt,t=>t(n));function Zt(n){let t=n?{...n,law:w.laws.indexOf(n.law),friction_law:w.friction_laws.indexOf(n.friction)}:{};return Float64Array.from(w.compliant,
e=>t[e]??Number.NaN)}var jo={setup:{version:"0.1.0",controls:{groups:{hoop:[{path:"hoop.load_fraction",label:"parameter.hoop.load_fraction",symbol:"γ",unit:"",help:"help.hoop.load_\
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
omega"]};var S=jo,te=n=>n==="inf"?1/0:n;var{codes:Wa,families:Ga,massless:Ua,hops:Ka,rolls:Va,other:Ya}=S.classes,qo="sequence",Ja=n=>[...n].reduce((t,e)=>(131*t+e.charCodeAt(0))%997,0)/997;function Do(n,t){
if(t!==qo)return Wa[t]?.[n]??Ya;let e=/[SK]/.exec(n)?.[0]??"R",s=[n.startsWith("R")&&"rolls",/[SK]/.test(n)&&"slips"].filter(Boolean).join(", "),o=n.endsWith("H")?
Ka:Ga[e+n.slice(-1)]??Va,i=n.includes("M")?Ua[s]:o,r=[1,3,5].map(d=>Number.parseInt(i.slice(d,d+2),16)/255),a=(r[0]+r[1]+r[2])/3,l=Math.min(n.length-1,9)/9,h=.2*
Ja(n),m=.62-.62*Math.min(2*l,1),u=Math.max(2*l-1,0)*.5;return`#${r.map(d=>{let f=(1-h)*d+h*a;return Math.round(255*(f+(1-f)*m)*(1-u)).toString(16).padStart(2,"0")}).
join("")}`}function Bo(n,t){if(t!==qo)return`class.${n}`;let{letters:e,modes:s}=S.words;return[...n].map(i=>i==="+"?"…":`mode.${s[e.indexOf(i)]}`).flatMap((i,r)=>r?
[" → ",i]:[i])}function U({duration:n,hoop:t,plane:e,start:s,contact:o}){let{radius:i,mass:r,eccentricity:a,inertia_ratio:l}=t,{mu:h,apart:m,...u}=e,{x:p,height:d,angle:f,vx:_,
vy:g,omega:b,slip:y}=ct(s,i),{max_events:k,model:M,...O}=o;return{radius:i,mass:r,eccentricity:a,inertia_ratio:l,ideal:t.load_fraction!==null,...u,x:p,height:d,
angle:f,vx:_,vy:g,omega:b,slip:y,rolling:s.speed!==null,duration:n,max_events:k,contact:M==="rigid"?null:O}}function ct({x:n,height:t,angle:e,speed:s,vx:o,vy:i,
omega:r},a){let l=s===null?Number(r):s/a;return{x:n,height:t,angle:e,vx:o,vy:i,omega:l,slip:s===null?o-a*l:0}}var zo={"axis.hoop.eccentricity":"Eccentricity ε","axis.hoop.inertia_ratio":"Inertia ratio κ","axis.hoop.load_fraction":"Load fraction γ","axis.hoop.radius":"\
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
_turn":"Your turn"};var Qa=["en","de","es","fr","zh"],Za=/\{(\w+)\}/g,tl=n=>{let t=new Intl.DisplayNames([n],{type:"language"}).of(n)??n;return t[0].toLocaleUpperCase(n)+t.slice(1)},
Bt=Object.fromEntries(Qa.map(n=>[n,tl(n)])),Go=n=>Object.assign(Object.create(null),n),oe=Go(zo),Wo=new Map([["en",oe]]),Uo=async()=>oe,Dt="en",ee=oe,se=new Intl.
PluralRules("en"),ne=!1,Tt=()=>Dt;function Ce(n){Uo=n}async function zt(n){let t=Wo.get(n)??Go(await Uo(n));Wo.set(n,t),[Dt,ee]=[n,t],se=new Intl.PluralRules(n),
ne=1.5.toLocaleString(n).includes(",")}var rt=n=>ne?n.replace(/(\d)\.(\d)/g,"$1,$2"):n;function T(n,t){let e=ee[n]??oe[n];if(e===void 0)return rt(n);let s=typeof e==
"string"?e:e[se.select(Number(t?.count))]??e.other;return t?s.replace(Za,(o,i)=>el(i,t)):s}function el(n,t){if(n in t)return I(t[n]);let e=I(t[n[0].toLowerCase()+
n.slice(1)]);return e.slice(0,1).toLocaleUpperCase(Dt)+e.slice(1)}function I(n){return typeof n=="string"?T(n):typeof n=="number"?rt(String(n)):typeof n=="funct\
ion"?n():Array.isArray(n)?n.map(I).join(""):T(n.key,n.values)}var tt=n=>n.flatMap((t,e)=>e?["list.comma",t]:[t]);function sl(n){let t={language:Dt,table:ee,plurals:se,
commas:ne};[Dt,ee,se,ne]=["en",oe,new Intl.PluralRules("en"),!1];try{return I(n)}finally{({language:Dt,table:ee,plurals:se,commas:ne}=t)}}var Z=class extends Error{constructor(e){
super(sl(e));this.said=e}},K=n=>n.said??n.message;var nl=/^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i,ol=/^\s*([+-]?)(inf|infinity|nan)\s*$/i;function wt(n){return Number.isNaN(n)?"nan":String(n).replace("Infi\
nity","inf")}var Zs=n=>wt(n).replace(/^-?\d+$/,"$&.0");function et(n,t=6){if(!Number.isFinite(n))return wt(n);let e=n!==0&&Math.abs(n)<1e-4,[s,...o]=(e?n.toExponential(
t-1):n.toPrecision(t)).split("e");return[s.includes(".")?s.replace(/\.?0+$/,""):s,...o].join("e")}var tn=(n,t)=>Number.isFinite(n)?n.toFixed(t):wt(n),il={g:(n,t)=>et(
n,t||6),e:(n,t)=>n.toExponential(t),f:tn};function Ne(n,t){let s=[...n.matchAll(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g)].map(([,o,i,r,a])=>{let l=t[o];return a?
[o,il[a](l,Number(r))]:l?.key||Array.isArray(l)||typeof l=="number"?[o,i?Re(l):l]:[o,rl(i?Re(l):String(l))]});return Object.fromEntries(s)}function Re(n){return typeof n==
"number"?wt(n):typeof n=="string"?Oe(`'${n}'`):n==null?"None":Oe(JSON.stringify(n))}var rl=n=>n.replace(/[\p{C}\p{Zl}\p{Zp}]/gu,t=>`\\u{${t.codePointAt(0)?.toString(
16)}}`);function Oe(n){let t=[...n];return t.length<=60?n:`${t.slice(0,57).join("")}...`}function Ko(n){if(nl.test(n))return Number(n);let[,t,e]=ol.exec(n)??[];
if(e)return e[0].toLowerCase()==="n"?Number.NaN:t==="-"?-1/0:1/0}var{texts:al,scenario:Vo}=S,ll=2,L=class extends Z{constructor(){super(...arguments);this.name="InputError"}},V=class extends L{},P=(n,t={})=>({key:`refusal.${n}`,
values:Ne(al[n],t)}),mt=n=>n!==null&&typeof n=="object"&&!Array.isArray(n),Nt=(n,t,e,s)=>P("finding",{path:n||P("whole_scenario"),shown:Re(t),allowed:P(e,s)});function sn(n,t,e,s){
let{fields:o,place:i}=Vo.models[n],r=mt(t)?nn(i,t,Object.keys(o)):Nt(e,t,"table");if(r&&s.push(r),r)return null;let a=s.length,l={};for(let[h,m]of Object.entries(
o))Object.hasOwn(t,h)?l[h]=on(m,t[h],`${e}.${h}`,s):m.required?s.push(P("missing",{path:`${e}.${h}`})):l[h]=te(m.default);return s.length===a?{values:l,given:new Set(
Object.keys(t))}:null}function nn(n,t,e){let s=Object.keys(t).find(a=>!e.includes(a));if(s===void 0)return null;let[o]=[...e].sort((a,l)=>en(s,a)-en(s,l)),r=en(
s,o)<=ll?P("did_you_mean",{close:o}):P("known_are",{known:e.join(", ")});return P("unknown_key",{path:`${n}${Oe(s)}`,hint:r})}function en(n,t){let e=Array.from(
{length:t.length+1},(s,o)=>o);for(let[s,o]of[...n].entries()){let i=[s+1];for(let r=0;r<t.length;r++)i.push(Math.min(i[r]+1,e[r+1]+1,e[r]+ +(o!==t[r])));e=i}return e[t.
length]}function on(n,t,e,s){if(t===null&&n.nullable)return null;if(n.kind==="parts")return ml(t,e,s);let o=n.kind==="friction"&&t==="inf"?1/0:t,i=cl(n,o);return i&&
s.push(Nt(e,t,...i)),typeof o=="number"?o+0:o}var hl={greater_than:(n,t)=>n>t,greater_than_equal:(n,t)=>n>=t,less_than_equal:(n,t)=>n<=t};function cl(n,t){let{kind:e,
options:s,limits:o=[],range:i}=n;if(e==="word")return s.includes(t)?null:["literal_error",{expected:Yo(s)}];if(typeof t!="number")return["number"];if(e==="frict\
ion"&&!(t>=0))return["friction"];if(e==="whole"&&!Number.isInteger(t))return["whole"];if(e!=="friction"&&!Number.isFinite(t))return["finite_number"];let r=o.find(
([a,l])=>!hl[a](t,l));return r?[r[0],{limit:r[1]}]:i&&!an(i,t)?["range",{words:rn(i)}]:null}function rn({least:n,most:t,unit:e="",also:s=[]}){return{key:`range.${`${s.
includes(0)?"zero_or_":""}from_to${s.includes("inf")?"_or_inf":""}`}`,values:{least:et(n),most:`${et(t)}${e&&` ${e}`}`}}}function Yo(n){let t=n.map(e=>`'${e}'`);
return t.length===1?t:{key:"list.or",values:{some:tt(t.slice(0,-1)),last:t[t.length-1]}}}var an=({least:n,most:t,also:e=[]},s)=>n<=s&&s<=t||e.some(o=>te(o)===s);
function ml(n,t,e){if(!Array.isArray(n))e.push(Nt(t,n,"list"));else return n.map((s,o)=>ul(s,`${t}.${o}`,e))}function ul(n,t,e){let s=ln(n,"shape",Vo.parts,t,e),
o=s&&sn(s,n,t,e);if(!o)return null;let{inner_radius:i,outer_radius:r}=o.values;return i>r&&e.push(P("ring_radii",{inner:i,outer:r})),o.values}function ln(n,t,e,s,o,i){
let r=mt(n)&&Object.hasOwn(n,t)?n[t]:i;if(!mt(n))o.push(Nt(s,n,"table"));else if(r===void 0)o.push(P("missing",{path:`${s}.${t}`}));else{if(typeof r=="string"&&
Object.hasOwn(e,r))return e[r];o.push(Nt(`${s}.${t}`,r,"literal_error",{expected:Yo(Object.keys(e))}))}return null}function hn(n){let t=n.length-1;return t?{key:"\
refusal.other_problems",values:{first:()=>I(n[0]).replace(/[.。]$/,""),count:t}}:n[0]}var Xo=new Map(Object.entries(S.scenario.ends));function mn(n){let[t,...e]=n.split(".");return[t,e.join(".")]}function ie(n){for(let t of n){let e=(Xo.get(t)??[]).
map(o=>`${mn(t)[0]}.${o}`),s=n.find(o=>e.some(i=>o===i||o.startsWith(`${i}.`)));if(s!==void 0)return[t,s]}return null}function Jo(n){let[t,e]=mn(n);return(t==="\
start"?10:0)+(e===""?0:n==="contact.model"||n==="hoop.parts"?1:2)}function Qo(n,t,e,s){let o=[...e.keys()],i=ie(o);if(i){let[a,l]=i;throw new L(P("two_ways",{one:a,
other:l,one_value:e.get(a),other_value:e.get(l)}))}let r=new Set;for(let a of o.sort((l,h)=>Jo(l)-Jo(h))){let l=structuredClone(e.get(a)),[h,m]=mn(a);if(m==="")
cn(t,h,l);else if(a==="contact.model")t.contact={model:l};else{Object.hasOwn(t,h)||cn(t,h,{});let u=t[h];if(!mt(u))throw new L(P("no_section_parts",{path:a,section:h}));
let p=Xo.get(a)??[];if(!r.has(h)&&p.some(d=>Object.hasOwn(u,d))){r.add(h);let d=e.has(h)?s(h,e.get(h)):n[h],f=pl(d,a,()=>s("hoop",t.hoop));for(let[_,g]of Object.
entries(f))e.has(`${h}.${_}`)||(u[_]=g)}for(let d of p)delete u[d];dl(u,m.split("."),l,a)}}return t}var cn=(n,t,e)=>Object.defineProperty(n,t,{value:e,enumerable:!0,
configurable:!0,writable:!0});function pl(n,t,e){let{mass:s,eccentricity:o,inertia_ratio:i,mu_static:r,mu_kinetic:a}=n;if(t==="hoop.load_fraction")return{mass:s};
if(t==="hoop.eccentricity"||t==="hoop.inertia_ratio")return{mass:s,eccentricity:o,inertia_ratio:i};if(t==="plane.mu_static"||t==="plane.mu_kinetic")return{mu_static:r,
mu_kinetic:a};if(!t.startsWith("start.")||t==="start.speed")return{};let{height:l,vx:h,vy:m,omega:u}=ct(n,e().radius);return{height:l,vx:h,vy:m,omega:u}}function dl(n,t,e,s){
let o=n;for(let[i,r]of t.entries()){let a=i===t.length-1;if(!(Array.isArray(o)&&/^\d+$/.test(r)&&Number(r)<o.length)&&!(mt(o)&&(a||Object.hasOwn(o,r))))throw new L(
P("not_there",{path:s,step:r}));a?cn(o,r,e):o=o[r]}}var{lab:fl,limits:j}=S,{allowed:Zo,events:gl,flight_turns:_l,quantities:bl}=S.map,yl=1e-300,$=(n,t={})=>({key:`lab.${n}`,values:Ne(fl[n],t)}),un=n=>$("doubt",{time:et(
n,4)});function vt(n){let{duration:t,hoop:e,contact:s}=n;if(t>j.duration)throw new V($("too_long",{duration:t,most:j.duration}));let o=e.parts?.length??0;if(o>j.
parts)throw new V($("too_many_parts",{parts:o,most:j.parts}));let i=ni(si(n));if(i>j.turns)throw new V($("too_many_turns",{duration:t,turns:i,most:j.turns}));if(s.
model==="compliant"){let r=wl(n,i);if(r>j.steps)throw new V($("too_stiff",{steps:r/1e6,most:j.steps/1e6}))}return s.max_events<=j.events?n:{...n,contact:{...s,max_events:j.
events}}}function pn({duration:n}){if(n>j.film)throw new V($("film_too_long",{duration:n,most:j.film}))}function si({duration:n,hoop:{radius:t},plane:{gravity:e,
slope:s},start:o}){let{height:i,vx:r,vy:a,omega:l}=ct(o,t);return{duration:n,radius:t,gravity:e,slope:s,height:i,vx:r,vy:a,omega:l}}function ni({duration:n,radius:t,
gravity:e,slope:s,height:o,vx:i,vy:r,omega:a}){return(2*(Math.abs(i)+Math.abs(r)+t*Math.abs(a)+2*Math.sqrt(e*(t+o)))+.5*e*Math.min(Math.abs(s),1)*n)*n/(2*Math.PI*
t)}function wl({duration:n,hoop:{radius:t,mass:e},plane:{gravity:s},contact:{stiffness:o}},i){let a=10/Math.sqrt(t/(s>0?s:1))+(o===null?0:Math.sqrt(o/e));return 10*
n*a+40*i}function dn(n,{x:t,y:e,what:s}){if(n.contact.model!=="rigid")throw new L($("rigid_maps"));let{contact:o,...i}=vt(n),r={...i,contact:{...o,max_events:Math.
min(o.max_events,gl)}};vl(r,t,e,bl[s].span);let a=ie([e.path,t.path]);if(a)throw new L($("two_axes",{one:a[0],other:a[1]}));return r}function vl(n,t,e,s){let o=si(
n),i=s==="first_revolution",r=re(t).filter(u=>ei(t.path,u)),a=re(e).filter(u=>ei(e.path,u)),[l,h]=[0,0];for(let u of a)for(let p of r){let d=ti(ti(o,e.path,u),t.
path,p),_=i?1+Math.min(d.vx*d.vx/(10*o.gravity*o.radius+yl),_l):ni(d);l+=_,h=Math.max(h,_)}if(!i&&h>j.turns)throw new V($("cell_turns",{turns:h,most:j.turns}));
if(l<=j.map_turns)return;let m=r.length*a.length;throw new V($("map_turns",{cells:m,turns:l,most:j.map_turns}))}function ti(n,t,e){if(t==="start.speed")return{...n,
vx:e,vy:0,omega:0};let s=t.slice(t.lastIndexOf(".")+1);return s in n&&s!=="height"?{...n,[s]:e}:n}var re=({from:n,to:t,cells:e})=>Array.from({length:e},(s,o)=>n+
(o+.5)*((t-n)/e));function ei(n,t){return!Zo[n]||an(Zo[n],t)}var xl=1e3;function oi(n){let t=n.replace(/^\?/,"");if(t.split("&").length>xl)throw new L(P("unreadable_query",{reason:"Max number of fields exceeded"}));let e=new Map;
for(let[i,r]of new URLSearchParams(`&${t}`)){let a=i.split("."),l=a.pop(),h=e;for(let m of a)if(h.has(m)||h.set(m,new Map),h=h.get(m),!(h instanceof Map))throw new L(
P("value_above",{path:i,above:i.replace(/\.[^.]*$/,"")}));if(h.has(l))throw new L(P("given_twice",{path:i}));h.set(l,Ko(r)??r)}let s=e.get("hoop"),o=s instanceof
Map&&s.get("parts");return o instanceof Map&&s.set("parts",kl(o)),fn(e)}function kl(n){let t=Array.from({length:n.size},(s,o)=>String(o)),e=[...n.keys()].find(s=>!t.
includes(s));if(e!==void 0)throw new L(P("parts_out_of_order",{name:e}));return t.map(s=>n.get(s))}function fn(n){return Array.isArray(n)?n.map(fn):n instanceof
Map?Object.fromEntries([...n].map(([t,e])=>[t,fn(e)])):n}function gn(n,t=""){return typeof n=="string"?`${t}=${n}`:typeof n=="number"?`${t}=${wt(n).replace("e+",
"e")}`:Object.entries(n).map(([e,s])=>gn(s,t?`${t}.${e}`:e)).join("&")}var{scenario:_n}=S,Ml=_n.rules,Sl=["load_fraction","eccentricity","inertia_ratio"],ii=["mu_static","mu_kinetic"],Tl=["height","vx","vy","omega"],ri={mass:1,inertia_ratio:1,
contact:null};function Fe(n,t,e){let[s,o]=e.refused(n),i=Ml[s];if(!i)return null;let r=Object.entries(i.values).map(([h,m])=>{let[u,p]=m.split(".");return[h,t[u][p]]}),
{words:a,...l}=i.known;return a&&(l.words=rn(a)),P(i.sentence,{...l,...Object.fromEntries(r),[i.number]:o})}function He(n,t,e,s){let o=s.find(i=>e.has(i));return o?
P("together",{section:n,other:o,way:t}):null}var ai={hoop:El,plane:Al,start:Ll,contact:Pl};function El(n,t,e){let s=Sl.filter(o=>t.has(o)&&n[o]!==null);if(n.parts){
let o=n.parts.length?He("hoop","parts",t,[...s,"mass"]):P("no_parts");if(o)return o;let{radius:i,parts:r}=n,{reaches:a,...l}=e.combine(i,r),h=a.findIndex(m=>m>i*
(1+_n.touch));if(h>=0)return P("beyond_the_rim",{index:h,shape:r[h].shape,reach:a[h],radius:i});Object.assign(n,l)}else if(n.load_fraction!==null||!s.length){let o=He(
"hoop","load_fraction",t,s.slice(+(n.load_fraction!==null)));if(o)return o;n.load_fraction??=_n.models.Hoop.fields.eccentricity.default,n.eccentricity=n.load_fraction,
n.inertia_ratio=e.ideal(n.load_fraction)}else if(s.length===1){let o=s[0]==="eccentricity"?"inertia_ratio":"eccentricity";return P("half_a_hoop",{missing:o,given:s[0]})}
return Fe({...ri,...n,ideal:n.load_fraction!==null},{hoop:n},e)}function Al(n,t,e){if(n.apart=ii.some(s=>t.has(s)),n.mu!==null){let s=He("plane","mu",t,ii);if(s)
return s;n.mu_static=n.mu_kinetic=n.mu}else n.mu_static===n.mu_kinetic&&(n.mu=n.mu_static);return Fe({...ri,...n},{plane:n},e)}function Ll(n,t){return n.speed===
null?n.omega===null?P("no_omega"):null:(n.vx=n.speed,n.omega=null,He("start","speed",t,Tl))}function Pl({damping:n=null,restitution:t=null}){return n!==null&&t!==
null?P("together",{section:"contact",other:"restitution",way:"damping"}):null}var{scenario:ut}=S,li=ut.left_out,hi={rigid:"Rigid",compliant:"Compliant"};function le(n,t){let{fields:e,place:s}=ut.models.Scenario,o=mt(n)?nn(s,n,Object.keys(
e)):Nt("",n,"table");if(o)throw new L(o);let i=[],r=Object.keys(e).map(h=>{let m=Object.hasOwn(n,h)?n[h]:ut.default[h];return[h,yn(h,m,t,i)]}),a=Object.fromEntries(
r),l=i.length?hn(i):Fe(U(a),a,t);if(l)throw new L(l);return a}function yn(n,t,e,s){if(n==="duration")return on(ut.models.Scenario.fields[n],t,n,s);let[o]=n==="c\
ontact"?[ln(t,"model",hi,n,s,"rigid")]:ut.sections[n],i=o&&sn(o,t,n,s),r=i&&ai[n](i.values,i.given,e);return r&&s.push(r),i?.values}var he=(n,t)=>le(oi(n),t),$e=(n,t,e)=>le(
ci(n,t,e),e);function ci(n,t,e){return Qo(n,Et(n),t,(s,o)=>{let i=[],r=yn(s,o,e,i);if(i.length)throw new L(hn(i));return r})}function mi(n,t,e){let s=[];try{let o=ci(
n,t,e),r=[...new Set([...t.keys()].map(a=>a.split(".")[0]))].map(a=>[a,yn(a,o[a],e,s)]);return s.length?null:Object.fromEntries(r)}catch(o){if(o instanceof L)return null;
throw o}}var ae=(n,t)=>Object.fromEntries(t.filter(e=>n[e]!==null).map(e=>[e,n[e]===1/0?"inf":n[e]])),bn=n=>Object.keys(ut.models[n].fields);function Et({duration:n,
hoop:t,plane:e,start:s,contact:o}){let i=e.apart?["mu"]:["mu_static","mu_kinetic"],r=l=>l in li&&e[l]===li[l],a=["x","height","angle","vx","vy","omega"];return{
duration:n,hoop:Cl(t),plane:ae(e,bn("Plane").filter(l=>!i.includes(l)&&!r(l))),start:ae(s,s.speed===null?a:["x","angle","speed"]),contact:ae(o,bn(hi[o.model]))}}
function Cl(n){if(n.parts){let e=n.parts.map(s=>ae(s,bn(ut.parts[s.shape])));return{radius:n.radius,parts:e}}let t=n.load_fraction===null?["eccentricity","inert\
ia_ratio"]:["load_fraction"];return ae(n,["radius","mass",...t])}function wn(n,t){if(n==="hoop"||n==="plane")return ut.default[n];let{fields:e}=ut.models[n==="s\
tart"?"Start":t==="compliant"?"Compliant":"Rigid"];return Object.fromEntries(Object.entries(e).map(([s,o])=>[s,o.default??void 0]))}function ce(n){let t={};for(let[
e,s]of Object.entries(Et(n))){if(Ie(s,ut.default[e]))continue;let o=mt(s)?wn(e,s.model):{},i=Object.entries(s).filter(([r,a])=>r==="model"||!Ie(o[r],a));t[e]=mt(
s)&&i.length?Object.fromEntries(i):s}return gn(t)}var Ie=(n,t)=>JSON.stringify(n)===JSON.stringify(t);var Rl=8,{quantities:ui}=S.map;async function vn(n,{x:t,y:e},s,o){let[i,r]=[re(t),re(e)],a=(...f)=>mi(n,new Map(f),s),l=Ol(n,t.path,e.path),h=l&&i.map(f=>a([t.path,
f])),m=l&&r.map(f=>a([e.path,f])),u=i.length*r.length,p=new Float64Array(Qt.length*u),d=performance.now();for(let f=0;f<u;f++){let _=f%i.length,g=(f-_)/i.length;
_===0&&performance.now()-d>Rl&&(await new Promise(M=>setTimeout(M)),o?.throwIfAborted(),d=performance.now());let b=h?h[_]:a([e.path,r[g]],[t.path,i[_]]),y=m?m[g]:
b;if(!b||!y)continue;let k=U({...n,...b,...y});for(let M=0;M<Qt.length;M++)p[M*u+f]=Qt[M](k)}return{count:u,rows:p}}function Ol({start:n},t,e){let s=[t,e].map(i=>i.
split(".")[0]);if(s[0]===s[1])return!1;let o=[t,e].some(i=>i.startsWith("start.")&&i!=="start.speed");return!(s.includes("hoop")&&o&&n.speed!==null)}var xn=n=>ui[n].
span;function kn({x:n,y:t,what:e},s){let{unit:o,words:i}=ui[e],r=`quantity.${e}`,{values:a,names:l}=Nl(s,o===""?i:null),h=m=>({name:m,text:Bo(m,e),color:Do(m,e)});
return{header:{x:n,y:t,what:e,label:r,unit:o,classes:o===""?l.map(h):null},arrays:{values:a}}}function Nl({values:n,sequences:t},e){if(!e)return{values:n,names:[]};
let s=t?[...t].sort((r,a)=>r.length-a.length||(r<a?-1:1)):e,o=t?.map(r=>s.indexOf(r));return{values:Float64Array.from(n,r=>r>=0?o?.[r]??r:Number.NaN),names:s}}var{scenario:me}=S,Hl=30,gi={};for(let{fields:n}of Object.values(me.models))Object.assign(gi,n);function _i(n,t){return typeof t=="string"?JSON.stringify(t):gi[n]?.
kind==="whole"?String(t):Zs(t)}function pi(n,t,e){if(Array.isArray(e)){let r=a=>Object.entries(a).map(([l,h])=>`${l} = ${di(l,h)}`);return[`${t} = [`,...e.map(a=>`\
  { ${r(a).join(", ")} },`),"]"].join(`
`)}let s=`${t} = ${di(t,e)}`,i=(me.sections[n]??["Scenario"]).map(r=>me.models[r].fields).find(r=>t in r)[t].unit;return i===""||i==="1"?s:`${s.padEnd(Hl)} # ${i}`}
var di=(n,t)=>t==="inf"?"inf":_i(n,t);function je(n){let{duration:t,...e}=Et(n),s=[pi("","duration",t)];for(let[o,i]of Object.entries(e))s.push("",`[${o}]`,...Object.
entries(i).map(([r,a])=>pi(o,r,a)));return`${s.join(`
`)}
`}var Fl={hoop:"Hoop",plane:"Plane",start:"Start"},Il=["load_fraction","mu"];function Mn(n){let{duration:t,contact:e,...s}=Et(n),o=Object.entries(s).map(([i,r])=>fi(
i,r));return Ie(e,me.default.contact)||o.push(`contact=${fi("contact",e)}`),o.splice(3,0,`duration=${Zs(t)}`),`import hophoop as hh

motion = hh.simulate(
${o.map(i=>`    ${i},
`).join("")})
print(motion.sequence, motion.status)
for event in motion.events:
    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")
`}function fi(n,{parts:t,...e}){let s=n==="start"&&"speed"in e,o=s?"Start.rolling":Fl[n]??(e.model==="rigid"?"Rigid":"Compliant"),i=s?{angle:0,x:0}:wn(n,e.model),
r=Object.entries(e).filter(([l,h])=>Il.includes(l)||i[l]!==h),a=t?[`parts=[${t.map($l).join(", ")}]`]:[];return`hh.${o}(${[...r.map(bi),...a].join(", ")})`}var $l=({
shape:n,...t})=>`hh.${me.parts[n]}(${Object.entries(t).map(bi).join(", ")})`,bi=([n,t])=>`${n}=${t==="inf"?'float("inf")':_i(n,t)}`;var{letters:wi,modes:Tn,summed_up:jl}=S.words,ql=400,[,Sn,yi,Dl,Bl]=Tn,zl="⁰¹²³⁴⁵⁶⁷⁸⁹";function vi(n,t){let{omega:e,to:s}=n[t];return e===0&&(s===
"S"||s==="K")&&t+1<n.length}var En=n=>[...n.keys()].filter(t=>vi(n,t)),An=(n,t)=>.5*(n[t].t+n[t+1].t);function Ln(n,t=ql){let e=[],s=0,o=ki(n.events);for(let[i,
r]of n.events.entries()){let a=o.get(i);if(a===0||r.kind==="end")continue;let l=a===void 0?Gl(n,i,r):{key:"story.more_bounces",values:{count:a}};if(e.length>=t){
s++;continue}e.push({t:r.t,event:i,mode:wi[Tn.indexOf(qe(n,i))],text:l})}return s&&e.push({...e[e.length-1],text:{key:"story.left_out",values:{count:s}}}),e}var xi=n=>n.
kind==="impact"&&n.to==="H"&&n.collision!==!1;function ki(n,t=3,e=6){let s=new Map,o=[];for(let i=0;i<=n.length;i++){let r=n[i];if(r&&(xi(r)||o.length&&r.kind===
"apex")){o.push(i);continue}let a=o.filter(l=>n[l].kind==="impact");if(a.length>=e){for(let l of o.slice(o.indexOf(a[t])))s.set(l,0);s.set(a[t],a.length-t)}o=[]}
return s}function Pn(n,t=6){let e=[],s=0,o=ki(n.events,1);for(let[r,a]of n.events.entries()){let l=o.get(r);if(l!==void 0){l&&e.push({key:"summary.more_times",values:{
what:e.pop()??"",count:l}});continue}if(a.kind==="start"||!e.length){e.push(`verb.${qe(n,r)}`);continue}let h=Wl(n,r,a);h&&(s++,s<=t&&e.push({key:h,values:{where:Wt(
a.angle)}}))}s>t&&e.push({key:"summary.more_changes",values:{count:s-t}});let i=`status.${n.status}`;return n.status==="completed"?{key:"summary.whole",values:{
phrases:tt(e)}}:{key:"summary.with_ending",values:{phrases:tt(e),ending:i}}}function Wl(n,t,e){return e.collision===!1?"summary.without_collision":xi(e)?"summar\
y.bounces":["slip_start","slip_reversal"].includes(e.kind)||Mi(e)?`summary.${qe(n,t)}`:jl.includes(e.kind)?`summary.${e.kind}`:""}function Gl(n,t,e){let s=qe(n,
t),o={where:Wt(e.angle),verb:`verb.${s}`};return{key:`story.${Ul(n.events,t,s,o)}`,values:o}}function Ul(n,t,e,s){let o=n[t],{kind:i}=o;return i==="start"&&(s.speed=
Ht(o.vx),e===Dl||e===Bl)?`start_${e}`:i==="slip_start"&&e===Sn?"slip_start_spin":i==="takeoff"?Kl(n,t,s):i==="impact"?(s.speed=Ht(o.before.vy===null?null:Math.abs(
o.before.vy)),o.collision===!1?"impact_without_collision":o.to==="H"?"impact_bounce":i):i==="turn"&&Mi(o)?"turn_in_slip":(i==="apex"&&(s.gap=Si(o.height)),i==="\
kane_gain"&&(s.gain=Ht(o.gain)),i==="rest"&&o.stable===!1?"rest_unstable":i)}function Kl(n,t,e){let{t:s}=n[t],o=0;for(let i=t;i<n.length;i++)if(o=Math.max(o,n[i].
height),!(i===t||n[i].kind!=="impact")){for(let r=i+1;r<n.length&&n[r].t<=n[i].t;r++)o=Math.max(o,n[r].height);if(!o)break;return e.top=Si(o),e.time=Ht(n[i].t-s),
"takeoff_and_landing"}return"takeoff"}function qe(n,t){let e=n.events[t];return Vl(e.to,vi(n.events,t)?n.omega(t):e.omega)}function Vl(n,t){return n==="S"?t>0?Sn:
yi:n==="K"?t<0?Sn:yi:Tn[wi.indexOf(n)]}var Mi=n=>n.kind==="turn"&&(n.to==="S"||n.to==="K"),Wt=n=>`${tn(n*(180/Math.PI),1)}°`.replaceAll("-","−");function Si(n){
return n>=.995?`${Ht(n)} m`:n>=.00995?`${Ht(n*100)} cm`:`${Ht(n*1e3)} mm`}function Ht(n){if(n===null||Number.isNaN(n))return"?";let[t,e]=et(n,3).split("e"),s=e===
void 0?"":`·10${Yl(Number(e))}`;return`${t}${s}`.replaceAll("-","−")}var Yl=n=>[...String(n)].map(t=>t==="-"?"⁻":zl[Number(t)]).join("");var Ti=2e3;function De(n,{status:t,sequence:e,fingerprint:s,events:o,final:i,energy:r}){let{schema:a,setup:l}=S,h=Et(n);return{schema:a,version:l.version,scenario:h,
status:t,sequence:e,fingerprint:s,events:o,final:i,energy:r}}function Be(n,t,e,s){let o={events:t.events,status:t.status,omega:e};return{...De(n,t),events:t.events.
slice(0,Ti),query:ce(n),duration:t.duration,values:Jl(n),automatic:Xl(n,s),massless:n.hoop.inertia_ratio===0,summary:Pn(o),story:Ln(o),shortened:t.events.length>
Ti}}function Jl({hoop:n,plane:t,start:e}){let s={hoop:n,plane:t,start:{...ct(e,n.radius),speed:e.speed}},o=S.shown.map(i=>{let[r,a]=i.split("."),l=s[r][a];return[
i,l===1/0?"inf":l]});return Object.fromEntries(o)}function Xl(n,t){if(n.contact.model==="rigid")return{};let{stiffness:e,slip_speed:s}=t.chosen(U(n)),{restitution:o}=n.
plane;return{"contact.stiffness":e,"contact.slip_speed":s,"contact.restitution":o}}var{rate:Ql,variables:Cn}=S.table,{letters:Zl}=S.words,Rn=(n,t)=>JSON.stringify(De(n,t),null,1);function On(n){let t=Math.min(Math.max(Math.floor(n*Ql)+1,2),S.limits.
samples),e=n/(t-1);return Float64Array.from({length:t},(s,o)=>o===t-1?n:o*e)}function Nn(n,t){let e=Object.keys(Cn),s=e.map(l=>Cn[l]==="1"?l:`${l} [${Cn[l]}]`),
{kinetic:o,potential:i}=t,r={...t,total:Float64Array.from(o,(l,h)=>l+i[h])},a=[["t [s]",...s].join(",")];for(let[l,h]of n.entries()){let m=e.map(u=>u==="mode"?Zl[r.
mode[l]]:wt(r[u][l]));a.push([wt(h),...m].join(","))}return`${a.join(`\r
`)}\r
`}var{limits:ze}=S;function J({scenario:n,query:t,changes:e=[]},s){let i=n!==void 0&&t===void 0?le(n,s):he(t??"",s),r=new Map;for(let[a,l]of e)ie([...r.keys(),a])&&
(i=$e(i,r,s),r=new Map),r.set(a,l);return r.size?$e(i,r,s):i}function Hn({scenario:n,query:t,changes:e=[],...s},o){if(e.length>ze.changes)throw new V($("too_man\
y_changes",{pairs:e.length,most:ze.changes}));let{x:i,y:r}=s;if(i&&i.path===r.path)throw new L($("equal_axes",{path:i.path}));let a=i?i.cells*r.cells:0;if(a>ze.
cells)throw new V($("too_many_cells",{cells:a,most:ze.cells}));return{...s,checked:J({scenario:n,query:t,changes:e},o)}}var th=new Set(Object.keys(S.scenario.models.Scenario.fields)),eh=40,We=n=>new URLSearchParams(`&${n}`).keys().next().value??"",Ei=n=>!We(n).includes(".")&&!th.
has(We(n));function Fn(n,t){let e=n.replace(/^\?/,"").split("&").filter(Boolean),s=e.filter(l=>!Ei(l)),o=e.filter(Ei).map(We),i=l=>{try{return vt(J({query:l.join(
"&")},t)),null}catch(h){if(h instanceof L)return h;throw h}},r=i(s);return{query:(r?sh(s,l=>!i(l)):s).join("&"),foreign:[...new Set(o)],error:r}}function sh(n,t){
if(n.length>eh)return[];let e=new Map;for(let o of n){let i=We(o).split(".")[0];e.set(i,[...e.get(i)??[],o])}let s=[];for(let o of e.values()){let i=[...s,...nh(
o,t)];t(i)&&(s=i)}return s}function nh(n,t){let e=(...o)=>n.filter((i,r)=>!o.includes(r));return[n,...n.map((o,i)=>e(i)),...n.flatMap((o,i)=>n.map((r,a)=>e(i,a)))].
find(t)??[]}var oh=["hoop.eccentricity","plane.slope"],ih={...Object.fromEntries(Object.entries(S.map.rates).map(([n,t])=>[n,()=>({[t]:1})])),"hoop.radius":rh,"hoop.mass":({
hoop:n})=>n.parts?null:{mass:1},"hoop.load_fraction":({hoop:{load_fraction:n}})=>n===null?null:{eccentricity:1,inertia_ratio:-2*n},"plane.mu":({plane:{mu:n}})=>n===
null||n===1/0?null:{mu_static:1,mu_kinetic:1},"plane.mu_static":({plane:n})=>n.mu_static===1/0?null:{mu_static:1},"plane.mu_kinetic":({plane:n})=>n.mu_kinetic===
1/0?null:{mu_kinetic:1},"plane.rolling_resistance":({hoop:n})=>n.inertia_ratio===0?null:{rolling_resistance:1},"start.speed":({hoop:n,start:t})=>t.speed===null?
null:{omega:1/n.radius},"start.vx":()=>({slip:1}),"start.omega":({hoop:n})=>({omega:1,slip:-n.radius})};function rh({hoop:{radius:n,parts:t,eccentricity:e,inertia_ratio:s},
start:{speed:o,omega:i}}){let r={radius:1};return o===null?r.slip=-(i||0):r.omega=-o/(n*n),t?{...r,eccentricity:-e/n,inertia_ratio:-2*s/n}:r}function In(n,t){let e=ih[t]?.(
n),{smaller:s,larger:o}=ah(n,t);if(!e||!(s||o))return null;let i=new Float64Array(w.cell.length);for(let[r,a]of Object.entries(e))i[Fo[r]]=a;return{rates:i,smaller:s,
larger:o}}function ah(n,t){let{mu_static:e,mu_kinetic:s}=n.plane,o=lh(n,t),{least:i,most:r,also:a=[]}=S.map.allowed[t],l=e!==s,h=n.hoop.inertia_ratio===0&&oh.includes(
t);return{smaller:!h&&o>Math.min(i,...a.map(te))&&(l||t!=="plane.mu_static"),larger:!h&&o<r&&(l||t!=="plane.mu_kinetic")}}function lh(n,t){return t==="start.ome\
ga"?ct(n.start,n.hoop.radius).omega:t.split(".").reduce((e,s)=>e[s],n)}function jn({hoop:n,plane:t},e){let s=[],o=(a,l,h,m)=>{l!==null&&s.push({key:a,label:`theory.${a}`,value:Number.isFinite(l)?l:null,unit:h,text:m(l)})},i=()=>o("\
painleve",e.painleve_friction,"1",a=>ch(a,e,t));if(t.gravity<=0)return i(),s;if(n.inertia_ratio===0){let a=e.massless_loss_by_friction?"theory.loss_by_friction":
"theory.loss_of_contact";return o("loss",e.massless_loss_angle,"rad",l=>Ai(a,l)),s}t.slope>=0?(o("first_slip",e.first_slip_speed,"m/s",a=>$n(a,"would_slip")),o(
"first_hop",e.first_hop_speed,"m/s",a=>$n(a,"would_hop")),o("immediate_hop",e.immediate_hop_speed,"m/s",a=>$n(a,"would_hop_at_once"))):s.push({key:"uphill",label:"\
theory.uphill",value:null,unit:"",text:"theory.no_threshold"}),o("needed_friction",e.needed_friction,"1",a=>hh(a,t)),i();let r=tt(e.jam_angles.map(Wt));return o(
"jam",e.jam_angles[0]??null,"rad",()=>({key:"theory.jam_at",values:{places:r}})),n.eccentricity>0&&o("rest",e.stable_angle,"rad",a=>Ai("theory.rest_at",a)),s}var Ai=(n,t)=>({
key:n,values:{where:Wt(t)}});function $n(n,t){return n<S.words.least_speed?`theory.${t}.always`:Number.isFinite(n)?{key:`theory.${t}.above`,values:{speed:et(n,4)}}:
"theory.no_speed"}function hh(n,{mu_static:t}){return Number.isFinite(n)?{key:n<=t?"theory.friction_enough":"theory.friction_short",values:{mu:et(n,3)}}:"theory\
.no_friction"}function ch(n,{painleve_angle:t},{mu_kinetic:e}){return t===null?"theory.never":{key:n<=e?"theory.paradox_here":"theory.paradox_not_here",values:{
mu:et(n,3),where:Wt(t)}}}function xt(n){let t=Number.parseInt(n.slice(1,7),16);return[t>>16&255,t>>8&255,t&255]}var Li=n=>ue(n)>.2?"#111111":"#ffffff",pe=(n,t)=>`rgba(${xt(n).join(",")}\
,${t})`,uh=n=>{let t=n/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4};function ue(n){let[t,e,s]=xt(n).map(uh);return .2126*t+.7152*e+.0722*s}function de(n,t){
if(!t||!/^#[0-9a-f]{6}$/i.test(n))return n;if(ue(n)<.002)return"#eceef2";let e=n;for(let s=0;ue(e)<.2&&s<1;s+=.05)e=`#${xt(n).map(o=>Math.round(o+(255-o)*s).toString(
16).padStart(2,"0")).join("")}`;return e}var Ge=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function ph(){let n=[];
for(let t=0;t<256;t++){let e=t/255*(Ge.length-1),s=Math.min(Math.floor(e),Ge.length-2),o=xt(Ge[s]),i=xt(Ge[s+1]);n.push(o.map((r,a)=>Math.round(r+(i[a]-r)*(e-s))))}
return n}var Ue=ph(),Ke=Ue.map(n=>`rgb(${n.join(",")})`),dh=["#123a8c","#8a6d00"],pt=(n,t)=>de(dh[n],t);var qn=new Map;function st(n){try{return localStorage.getItem(n)??qn.get(n)??null}catch{return qn.get(n)??null}}function nt(n,t){qn.set(n,t);try{localStorage.setItem(
n,t)}catch{}}function Pi(n){try{return sessionStorage.getItem(n)}catch{return null}}function Ci(n,t){try{sessionStorage.setItem(n,t)}catch{}}var Ri="hophoop-language";function Bn(){let n=st(Ri);return n&&n in Bt?n:(globalThis.navigator?.languages??[]).map(s=>s.slice(0,2).toLowerCase()).find(s=>s in Bt)??
"en"}function Oi(n){nt(Ri,n)}var Ni=new WeakMap,Dn=new WeakMap;function fe(n){let t=document.createTextNode(I(n));return Ni.set(t,n),t}function dt(n,t,e){Dn.set(
n,{...Dn.get(n),[t]:e}),n.setAttribute(t,I(e))}function zn(n){let t=document.createTreeWalker(n,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let e=t.nextNode();e;e=
t.nextNode()){let s=Ni.get(e);s!==void 0&&(e.nodeValue=I(s));let o=Dn.get(e);for(let[i,r]of Object.entries(o??{}))e.setAttribute(i,I(r))}}var fh=14,gh=new Set(["aria-label","title","placeholder","label"]);function c(n,t={},...e){let s=document.createElement(n),o=s;for(let[i,r]of Object.entries(t))
r==null||r===!1||(i.startsWith("on")?s.addEventListener(i.slice(2),r):i==="class"?s.className=r:gh.has(i)?dt(s,i,r):i in s&&i!=="list"&&typeof r!="string"?o[i]=
r:s.setAttribute(i,r===!0?"":r));for(let i of e.flat(2))i==null||i===!1||s.append(i.nodeType?i:fe(i));return s}function E(n,t){t?n.replaceChildren(fe(t)):n.replaceChildren()}
var ge=n=>n!==null&&n.getRootNode().activeElement===n,ft=n=>n.getContext("2d");function B(n,t=1){let e=n.getBoundingClientRect(),s=Math.min(globalThis.devicePixelRatio||
1,2.5),o=Math.max(Math.round(e.width*s),1),i=Math.max(Math.round(e.height*s),1);(n.width!==o||n.height!==i)&&(n.width=o,n.height=i);let r=ft(n),a=s*t;return r.setTransform(
a,0,0,a,0,0),{context:r,width:o/a,height:i/a}}function _h(n){if(/^#[0-9a-f]{6}$/i.test(n))return n;let t=ft(c("canvas",{width:1,height:1}));t.fillStyle=n,t.fillRect(
0,0,1,1);let[e,s,o]=t.getImageData(0,0,1,1).data;return`#${[e,s,o].map(i=>i.toString(16).padStart(2,"0")).join("")}`}function Wn(n){let t=getComputedStyle(n),e=o=>t.
getPropertyValue(o).trim(),s=o=>_h(e(o));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("--paper"),panel:s("--panel"),ground:s("--ground"),font:e(
"--font"),px:Number.parseFloat(t.fontSize)/fh||1,dark:ue(s("--paper"))<.2}}function Gt(n,t){let e=c("a",{href:URL.createObjectURL(n),download:t});document.body.
append(e),e.click(),e.remove(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function ot(n,t){let e=0;return()=>{clearTimeout(e),e=setTimeout(n,t)}}var v=(n,t,e)=>Math.min(Math.max(n,t),e);function x(n,t=4){if(n==null)return"–";if(typeof n!="number")return String(n);if(!Number.isFinite(n))return Number.isNaN(
n)?"–":n>0?"∞":"−∞";if(n===0)return"0";let e=Math.abs(n),s;if(e>=1e6||e<1e-4){let[o,i]=n.toExponential(t-1).split("e");s=`${Hi(o)}·10${bh(Number(i))}`}else
s=Hi(n.toPrecision(t)),s.includes("e")&&(s=String(Math.round(n)));return rt(s.replace("-","−"))}function Hi(n){return n.includes(".")&&!n.includes("e")?n.replace(
/\.?0+$/,""):n}function bh(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join(
"")}var N=(n,t)=>t?t==="°"?`${n}°`:`${n} ${t}`:n,q=n=>rt(`${(n*180/Math.PI).toFixed(1)}°`.replace("-","−"));function At(n){let t=Math.abs(n),[e,s]=t>=.995?
[1,"m"]:t>=.00995?[100,"cm"]:[1e3,"mm"];return N(x(n*e,3),s)}function z(n,t){let e=n/Math.max(t,1),s=10**Math.floor(Math.log10(e)),o=e/s;return(o>5?10:o>2?5:o>1?
2:1)*s}function at(n,t,e){if(!(t>n)||!Number.isFinite(n)||!Number.isFinite(t))return[];let s=z(t-n,e),o=[];for(let i=Math.ceil(n/s-1e-9);i*s<=t+1e-9*s&&o.length<
200;i++)o.push(i*s);return o}function it(n,t){let e=v(-Math.floor(Math.log10(t)+1e-9),0,15);return Math.max(Math.abs(n),t)>=1e6||e>12?x(n,3):rt((Math.abs(n)<t*1e-6?
0:n).toFixed(e).replace("-","−"))}var Ii=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],yh="tfc",wh=/^[0-9a-f]{16}$/,vh=400;function $i({time:n=0,options:t={},zoom:e=1,
pan:s=[0,0],from:o,more:i,map:r,fingerprints:a=[]}){let l=[];n>0&&l.push(`t=${Number(n.toFixed(4))}`);let h=Ii.filter(([m])=>t[m]).map(([,m])=>m);return h.join(
"")!==yh&&l.push(`show=${h.join("")}`),e!==1&&l.push(`zoom=${Number(e.toPrecision(3))}`),s.some(m=>Math.abs(m)>5e-4)&&l.push(`pan=${s.map(m=>Number(m.toFixed(3))).
join(",")}`),o&&l.push(`from=${o.map(m=>Number(m.toPrecision(3))).join(",")}`),i&&l.push(`more=${i}`),r&&l.push(`map=${[r.what,...r.x,...r.y].join(",")}`),a.some(
Boolean)&&l.push(`fingerprint=${a.join(",")}`),l.join("&")}function ji(n){let t=new URLSearchParams(n.replace(/^#/,"")),e={},s=Number(t.get("t")??Number.NaN);s>=
0&&(e.time=s);let o=t.get("show");o!==null&&(e.options=Object.fromEntries(Ii.map(([y,k])=>[y,o.includes(k)])));let i=Number(t.get("zoom")??Number.NaN);i>0&&(e.zoom=
v(i,.05,60));let r=Fi(t.get("pan"),2);r&&(e.pan=r.map(y=>v(y,-20,20)));let a=Fi(t.get("from"),3);a&&(e.from=a);let l=t.get("more");l&&(e.more=l);let[h,m,u,p,d,f,
_]=t.get("map")?.split(",")??[],g=[u,p,f,_].map(Number);_!==void 0&&g.every(Number.isFinite)&&g[0]<g[1]&&g[2]<g[3]&&(e.map={what:h,x:[m,g[0],g[1]],y:[d,g[2],g[3]]});
let b=t.get("fingerprint")?.toLowerCase().split(",");return b&&(e.fingerprints=b.map(y=>wh.test(y)?y:"")),e}function Fi(n,t){let e=(n??"").split(",").map(Number);
return n&&e.length===t&&e.every(Number.isFinite)?e:null}var Gn=()=>{let n=new URLSearchParams(location.hash.slice(1)).get("with");return[location.search.slice(1),
...n===null?[]:[n]]},Ve=class{constructor(t,e,s){this.motions=t;this.notice=e;this.link=s;this.number=history.state?.number??0;this.held=!1;this.soon=ot(()=>this.
write("same"),vh),this.listen=()=>this.arrived(),addEventListener("popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(t){let{motions:e}=this;
if(!e.lanes.length||!e.history.holds(e.queries())||this.held&&(t==="same"||t==="travelled"))return;let s=this.link();t==="step"||this.held?history.pushState({number:++this.
number},"",s):history.replaceState({number:this.number},"",s),this.held=!1}read(t){let{notice:e}=this,{backend:s}=this.motions,o=t.map(l=>s.readable?.(l)??{query:l,
foreign:[],error:null}),i=o.find(l=>l.error)?.error,r=o.flatMap(l=>l.foreign);this.held=!!i;let a=()=>{i?e.fail(i,"shell.the_rest_of_the"):r.length&&e.say({key:"\
shell.ignored_in_the_link",values:{names:tt(r)}})};return{links:o.map(l=>l.query),said:a}}travel(t){return new Promise(e=>{let s=()=>e();addEventListener("popst\
ate",s,{once:!0}),setTimeout(s,300),history.go(t)})}async arrived(){let t=history.state?.number??0,{links:e,said:s}=this.read(Gn());JSON.stringify(e)===JSON.stringify(
this.motions.queries())?this.number=t:await this.motions.arrive(e)?(this.number=t,s()):t!==this.number&&history.go(this.number-t)}};var _e=[.05,.1,.25,.5,1,2,4],Ye=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Je=class{constructor(){this.time=0;this.duration=1;this.speed=1;this.
playing=!1;this.loop=!Ye();this.once=!1;this.pointed=null;this.last=null;this.listeners=new Set}changed(){for(let t of this.listeners)t(this)}run({to:t=this.time,
once:e=!1}={}){Ye()?this.seek(t):(this.play(!0),this.once=e)}seek(t){this.time=v(t,0,this.duration),this.changed()}point(t){this.pointed=t,this.changed()}play(t=!this.
playing){this.playing=t,this.once=!1,this.last=null,t&&this.time>=this.duration&&(this.time=0),this.changed()}faster(t){let e=_e.indexOf(this.speed);this.speed=
_e[v(e+t,0,_e.length-1)],this.changed()}tick(t){if(!this.playing)return!1;let e=this.last===null?0:Math.min(t-this.last,100)/1e3;return this.last=t,this.time+=e*
this.speed,this.time>=this.duration&&(this.loop&&!this.once&&this.duration>0?this.time%=this.duration:(this.time=this.once?0:this.duration,this.playing=!1,this.
changed())),!0}};function xh(n,t=""){let e=n.trim();t&&e.endsWith(t)&&(e=e.slice(0,-t.length)),e=e.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(o,i,r)=>`e${i&&"-"}${r.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(e);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(e)?Number(e.replace(",",".")):Number.NaN}function kh(n,t,{label:e,unit:s,range:o}){let i=n.trim();if(Number.isNaN(t))return{key:"controls.name_value_must_b\
e",values:{name:e,value:i}};if(!Number.isFinite(t)&&/\d/.test(i))return{key:"controls.label_value_is_too",values:{label:e,value:i}};if(!o||t>=o.least&&t<=o.most||
o.also.includes(t))return"";let[r,a]=[o.also.includes(0),o.also.includes(1/0)],h={key:`range.${r?"zero_or_":""}from_to${a?"_or_inf":""}`,values:{least:x(o.least,
4),most:N(x(o.most,4),s)}};return{key:"controls.name_value_must_be_rule",values:{name:e,value:N(x(t,6),s),rule:h}}}var Mh=0,Ut=class{constructor(t,e){this.info=
t;this.onvalue=e;this.shown="";this.typing=!1;this.error=c("p",{class:"error",role:"alert",id:`hh-error-${++Mh}`,hidden:!0});this.input=c("input",{type:"text",inputmode:"\
decimal",autocomplete:"off",spellcheck:"false",class:"exact","aria-label":t.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.
typing&&this.typed(),onkeydown:s=>{s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute(
"aria-invalid")==="true"}typed(){let t=this.input.value;if(!this.typing)return;if(this.typing=!1,t.trim()===""){this.restore();return}let e=xh(t,this.info.unit),
s=kh(t,e,this.info);s?this.refuse(s):this.onvalue(e)}refuse(t){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.
id),E(this.error,t),this.error.hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){
this.typing=!1,this.input.value=this.shown,this.accept()}show(t){this.shown=rt(t),this.typing||this.restore()}};var qi={ring:{label:"parts.ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"parts.disk",keys:["mass","radius","at"]},point_mass:{label:"parts.poi\
nt_mass",keys:["mass","at"]},rod:{label:"parts.rod",keys:["mass","length","at"]}},Sh={mass:["parts.mass","kg"],inner_radius:["parts.inner_radius","m"],outer_radius:[
"parts.outer_radius","m"],radius:["parts.radius","m"],at:["parts.distance_from_centre","m"],length:["parts.length","m"]},Th=(n,t,e)=>({ring:{shape:n,mass:e,inner_radius:.95*
t,outer_radius:t},disk:{shape:n,mass:e,radius:.1*t,at:.8*t},point_mass:{shape:n,mass:e,at:t},rod:{shape:n,mass:e,length:.5*t,at:.5*t}})[n];function Di(n){let t=n["\
hoop.radius"],e=n["hoop.mass"],s=Math.min(Math.max(n["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:Xe(e*(1-s)),inner_radius:Xe(.98*t),outer_radius:t},
{shape:"point_mass",mass:Xe(e*s),at:t}]}var Xe=n=>Number(n.toPrecision(6)),Qe=class{constructor(t){this.onchange=t;this.list=c("div",{class:"parts"});this.element=
c("div",{},this.list,c("select",{"aria-label":"parts.add_a_part",onchange:e=>{let s=e.target.value;e.target.value="",s&&this.send([...this.parts,Th(s,this.radius,
Xe(.2*this.mass))])}},c("option",{value:""},"parts.add_a_part_2"),Object.entries(qi).map(([e,{label:s}])=>c("option",{value:e},s))))}send(t){this.onchange([["ho\
op.parts",t]])}show(t,e,s){let o=JSON.stringify(t);if(o===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=t;return}Object.assign(
this,{text:o,parts:t,radius:e,mass:s}),this.list.replaceChildren(...t.map((i,r)=>this.row(i,r)))}row(t,e){let{label:s,keys:o}=qi[t.shape];return c("fieldset",{class:"\
part"},c("legend",{},s,this.parts.length>1&&c("button",{type:"button",class:"quiet","aria-label":{key:"parts.remove_part_number_what",values:{number:e+1,what:s}},
onclick:()=>this.send(this.parts.filter((i,r)=>r!==e))},"×")),o.map(i=>this.field(t,e,i)))}field(t,e,s){let[o,i]=Sh[s],r=new Ut({label:o,unit:i},a=>this.send(this.
parts.map((l,h)=>h===e?{...l,[s]:a}:l)));return r.show(String(t[s]??0)),c("div",{},c("label",{},o,` [${i}]`,r.input),r.error)}};var Un=Math.PI/180;function Eh({allowed:n,degrees:t}){if(!n)return;let e=t?1/Un:1;return{least:n.least*e,most:n.most*e,also:n.also.map(s=>s==="inf"?1/0:Number(s))}}
var Kn=class{constructor(t,e){this.info=t;this.onchange=e;this.held=!1;let s=`hh-${t.path}-${Math.random().toString(36).slice(2,7)}`,o=l=>()=>{this.held=l};this.
range=c("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:t.logarithmic?"0.01":String(t.step),"data-path":t.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:o(!0),onpointerup:o(!1),onpointercancel:o(!1),onblur:o(!1)});let{label:i,unit:r}=t,a=r?{key:"controls.name_exa\
ct_value_in",values:{name:i,unit:r}}:{key:"controls.name_exact_value",values:{name:i}};this.entry=new Ut({label:i,unit:r,name:a,range:Eh(t)},l=>this.send(l,!0)),
this.element=c("div",{class:"control",title:t.help},c("label",{for:s},c("span",{},i),c("span",{class:"symbol"},t.symbol)),this.range,c("span",{class:"entry"},this.
entry.input,c("span",{class:"unit"},r)),this.entry.error)}low(){return this.info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.
logarithmic?Math.log10(this.info.most):this.info.most}slid(t){let e=Number(this.range.value),s=this.info.logarithmic?Number((10**e).toPrecision(3)):e;this.entry.
typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,t)}send(t,e){let s=this.info.degrees?t*Un:t;this.onchange([[this.info.path,Number.isFinite(s)?s:"in\
f"]],e)}say(t){this.range.setAttribute("aria-valuetext",N(x(t,4),this.info.unit))}show(t,e=null){if(this.held)return;let s=t!=null,o=s?t:e;if(o==null){this.entry.
show("");return}let i=o==="inf"?1/0:Number(o)/(this.info.degrees?Un:1);this.entry.show(s?Number.isFinite(i)?String(Number(i.toPrecision(9))):"∞":""),this.entry.
input.placeholder=s?"":T("controls.auto_value",{value:x(i,2)}),this.entry.input.title=s?N(String(i),this.info.unit):"";let r=v(this.info.logarithmic?Math.log10(
i):i,this.low(),this.high());Math.abs(Number(this.range.value)-r)>1e-6&&(this.range.value=String(r)),this.say(i)}};function Ah(n,t){let e=c("select",{"data-path":n.
path,onchange:()=>t([[n.path,e.value]],!0)},n.options.map(([o,i])=>c("option",{value:o},i)));return{element:c("label",{class:"choice",title:n.help},c("span",{},
n.label),e),select:e,path:n.path}}var Ze=class{constructor(t,e){this.sliders=new Map;this.onchange=(s,o=!0)=>e(s,o);for(let s of Object.values(t.groups))for(let o of s)
this.sliders.set(o.path,new Kn(o,this.onchange));this.choices=new Map(t.choices.map(s=>[s.path,Ah(s,this.onchange)])),this.parts=new Qe(this.onchange),this.gravities=
t.gravities,this.element=c("div",{class:"controls"},this.hoop(),this.plane(),this.start(),this.contact())}at(t){let e=this.sliders.get(t)??this.choices.get(t);if(!e)
throw new Error(`There is no control of ${t}.`);return e.element}of(t,e={}){return[...this.sliders.keys(),...this.choices.keys()].filter(s=>s.startsWith(`${t}.`)).
flatMap(s=>[...e[s]??[],this.at(s)])}select(t,e,s){let o=c("select",{onchange:()=>s(o.value)},e.map(([i,r])=>c("option",{value:i},r)));return{select:o,element:c(
"label",{class:"choice"},c("span",{},t),o)}}group(t,...e){let s=t==="controls.start"||t==="controls.plane"||!matchMedia("(max-width: 47.5em)").matches;return c(
"details",{class:"group",open:s},c("summary",{},t),e)}hoop(){return this.way=this.select("controls.given_by",[["load_fraction","controls.load_fraction_gamma"],[
"eccentricity","controls.epsilon_and_kappa"],["parts","controls.real_parts"]],t=>{let{values:e}=this.film;t==="parts"?this.onchange([["hoop.parts",Di(e)]]):this.
onchange([[`hoop.${t}`,e["hoop.eccentricity"]]])}),this.derived=c("p",{class:"derived"}),this.group("controls.hoop",this.way.element,...this.of("hoop",{"hoop.ra\
dius":[this.parts.element,this.derived]}))}plane(){this.apart=c("input",{type:"checkbox",onchange:()=>{let{values:s}=this.film;this.apart.checked?this.onchange(
[["plane.mu_static",s["plane.mu_static"]],["plane.mu_kinetic",s["plane.mu_kinetic"]]]):this.onchange([["plane.mu",s["plane.mu_static"]]])}}),this.gravity=this.select(
"controls.where",[...this.gravities.map(([s])=>[s,s]),["","controls.elsewhere"]],s=>{let o=this.gravities.find(([i])=>i===s);o&&this.onchange([["plane.gravity",
o[1]]])});let e={"plane.slope":[c("label",{class:"check"},this.apart,"controls.static_and_kinetic_friction")],"plane.gravity":[this.gravity.element]};return this.
group("controls.plane",...this.of("plane",e))}start(){return this.kind=this.select("controls.starts",[["rolling","controls.rolling"],["free","controls.in_any_st\
ate"]],t=>{let{values:e}=this.film;t==="rolling"?this.onchange([["start.speed",e["start.vx"]]]):this.onchange([["start.omega",e["start.omega"]]])}),this.group("\
controls.start",this.kind.element,...this.of("start"),this.at("duration"))}contact(){return this.group("controls.contact",this.at("contact.model"),this.at("cont\
act.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitution"))}refuse(t,e){let s=t.length===1?
this.sliders.get(t[0][0]):void 0;return s?.element.checkVisibility()?(s.entry.refuse(e),!0):!1}restore(){this.film&&this.showChoices(this.film,new Set)}show(t,e=new Set){
this.film=t,this.showChoices(t,e);let s=t.scenario;for(let[o,i]of this.sliders){if(e.has(o))continue;let[r,a]=o.split(".");i.show(t.values[o]??(a?s[r]?.[a]:s[r]),
t.automatic?.[o])}}showChoices(t,e){let{scenario:s,values:o}=t,i=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_fraction":"eccentricity",r="speed"in s.start,
a="mu_static"in s.plane,l=s.contact.model==="compliant",h=(...d)=>d.some(f=>e.has(f));h("hoop.load_fraction","hoop.eccentricity","hoop.parts")||(this.way.select.
value=i),h("start.speed","start.omega")||(this.kind.select.value=r?"rolling":"free"),h("plane.mu","plane.mu_static")||(this.apart.checked=a);let m=this.gravities.
find(([,d])=>Math.abs(d-s.plane.gravity)<1e-9);h("plane.gravity")||(this.gravity.select.value=m?m[0]:"");let u={"hoop.load_fraction":i==="load_fraction","hoop.e\
ccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!=="parts","plane.mu":!a,"plane.mu_static":a,"plane.mu_kinetic":a,"plane.re\
stitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":r,"start.height":!r,"start.vx":!r,"start.vy":!r,"start.omega":!r,"contact.law":l,"contact.\
friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[d,f]of Object.entries(u))this.at(d).hidden=!f;this.parts.element.hidden=
i!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,o["hoop.radius"],o["hoop.mass"]),this.derived.textContent=i==="eccentricity"?"":`ε = ${x(o["hoop.eccentr\
icity"],5)}, κ = ${x(o["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${x(o["hoop.mass"],5)} kg`:"");let p=s;for(let[d,{select:f}]of this.choices){if(e.has(d))
continue;let[_,g]=d.split(".");p[_]?.[g]!==void 0&&(f.value=p[_][g])}}};var Vn=Math.PI/180;function Bi(n,t){let{start:e,plane:s,contact:o,hoop:i}=n.scenario;return o.model!=="rigid"?"challenge.rigid_contact_only":n.slope!==0?"challe\
nge.the_plane_must_be":Math.abs(n.gravity-9.81)>1e-9?"challenge.it_must_be_on":(s.restitution??0)!==0?"challenge.restitution_must_be_0":n.radius!==1||i.parts?"c\
hallenge.the_radius_must_stay":n.eccentricity>.9?"challenge.at_most_90_of":"load_fraction"in i?"speed"in e?Math.abs(e.speed??3.1)>t+1e-9?t>5?"challenge.at_most_\
10_m":"challenge.at_most_3_1":n.scenario.duration>6?"challenge.at_most_6_s":"":"challenge.it_must_start_rolling":"challenge.the_hoop_must_be"}var zi=n=>n.events.
filter(({kind:t})=>t==="takeoff");function Lh(n){return n.events.filter(({kind:t})=>t==="apex").map(({height:t})=>t)}var Wi=(n,t)=>Math.min(Math.round(100*n/t),
100),Ph=1.596,Ch=.37,Rh=.05,Yn=[{key:"highest",title:"challenge.hop_highest",text:"challenge.on_level_ground_rolling",start:"",best:"hoop.load_fraction=0.9&plan\
e.mu=0.29",score:n=>{let t=Bi(n,3.1);if(t)return{points:0,text:t};let e=Math.max(0,...Lh(n));return e?{points:Wi(e,Ph),text:"challenge.it_rises_by_height",values:{
height:At(e)}}:{points:0,text:"challenge.it_does_not_hop"}}},{key:"upright",title:"challenge.land_upright",text:"challenge.let_the_hoop_land",start:"",best:"hoo\
p.load_fraction=0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:n=>{let t=zi(n)[0],e=n.events.find(({kind:r,t:a})=>r==="impact"&&t&&a>t.
t);if(!t||!e)return{points:0,text:"challenge.it_does_not_hop"};let s=n.events.find(({kind:r,t:a})=>r==="apex"&&a>t.t);if(!s||s.height<Rh)return{points:0,text:"c\
hallenge.the_first_hop_is"};let o=Math.abs(e.angle-2*Math.PI*Math.round(e.angle/(2*Math.PI)))/Vn,i=Math.max(0,Math.round(100*(1-(o-.5)/89.5)));return{points:Math.
min(i,100),text:"challenge.it_lands_off_away",values:{off:q(o*Vn)}}}},{key:"clean",title:"challenge.hop_without_skidding",text:"challenge.on_level_ground_the",start:"\
start.angle=3.141592653589793&start.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:n=>{let t=Bi(n,10);
if(t)return{points:0,text:t};if(Math.abs(Math.abs(n.scenario.start.angle??0)-Math.PI)>.5*Vn)return{points:0,text:"challenge.the_load_must_start"};if(n.values["p\
lane.mu_kinetic"]>1.5||n.values["plane.mu_static"]>1.5)return{points:0,text:"challenge.friction_must_be_at"};let e=zi(n)[0];if(!e)return{points:0,text:"challeng\
e.it_does_not_hop"};let s=n.phases.filter(({from:i})=>i<e.t);if(s.some(({mode:i})=>i==="K"))return{points:0,text:"challenge.it_skids_before_it"};if(s[0]?.mode!==
"R")return{points:0,text:"challenge.it_must_start_rolling"};let o=n.events.find(({kind:i,t:r})=>i==="apex"&&r>e.t);return o?{points:Wi(o.height,Ch),text:"challe\
nge.it_rises_by_height",values:{height:At(o.height)}}:{points:0,text:"challenge.it_does_not_hop"}}}],Jn=n=>n>=95?3:n>=75?2:n>=40?1:0;var Gi="hophoop-best-",Oh=n=>"★".repeat(Jn(n))+"☆".repeat(3-Jn(n)),ts=class{constructor({film:t,load:e,ahead:s}){this.goal=null;this.solved=new Set;this.solutions=
new Set;Object.assign(this,{film:t,load:e,ahead:s}),this.tabs=new Map(Yn.map(o=>[o.key,c("button",{type:"button","aria-pressed":"false",onclick:()=>this.choose(
o)},o.title)])),this.text=c("p",{}),this.meter=c("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"100","aria-label":"challenge.score"}),this.result=c("p",
{class:"challenge-result",role:"status"}),this.kept=c("p",{class:"hint"}),this.element=c("section",{class:"challenges card","aria-label":"menu.challenges",hidden:!0},
c("header",{},c("h2",{},"menu.challenges"),c("button",{type:"button",class:"quiet","aria-label":"challenge.leave_the_challenges",onclick:()=>this.close()},"×")),
c("div",{class:"tabs",role:"group","aria-label":"challenge.which_challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.kept,c("div",{class:"\
buttons"},c("button",{type:"button",onclick:()=>this.begin()},"challenge.begin_again"),c("button",{type:"button",onclick:()=>this.solve()},"challenge.show_a_bes\
t_one")))}open(){this.element.hidden=!1,this.choose(this.goal??Yn[0]),this.element.scrollIntoView({block:"nearest"}),this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){
this.goal=null,this.element.hidden=!0}choose(t){this.goal=t;for(let[e,s]of this.tabs)s.setAttribute("aria-pressed",String(e===t.key));E(this.text,t.text),this.changed()}begin(){
this.goal&&(this.solved.delete(this.goal.key),this.load(this.goal.start))}async solve(){let{goal:t}=this;t&&(this.solved.add(t.key),await this.load(t.best),this.
solutions.add(this.film().query))}changed(){let{goal:t}=this;if(!t)return;let{points:e,text:s,values:o={}}=t.score(this.film()),i=!this.solved.has(t.key)&&!this.
solutions.has(this.film().query);this.meter.value=e;let a={key:i?"challenge.stars_points_points_what":"challenge.stars_points_points_shown",values:{stars:Oh(e),
count:e,what:{key:s,values:o}}};this.result.textContent!==I(a)&&E(this.result,a);let l=Number(st(Gi+t.key)??0),h=i&&!this.ahead()?Math.max(l,e):l;h>l&&nt(Gi+t.key,
String(h)),E(this.kept,{key:"challenge.your_best_points_points",values:{count:h}})}};var Ui=.09,Nh=.03,Xn=Math.PI/180,es=Math.PI/4,Ki=2*Math.PI,be=n=>n-Ki*Math.round(n/Ki);function ss(n,t){let e=n.at(t),s=t===0;return{angle:be(e.angle),height:Math.
max(e.height,0),vx:s?e.vx:0,vy:s?e.vy:0,omega:s?e.omega:0,slope:n.slope}}var Vi=n=>2*Math.sqrt(Math.max(n.gravity,1)*n.radius),Lt=n=>Number(n.toFixed(4))+0;function Yi(n,t,e){
if(n==="plane")return[["plane.slope",Lt(t.slope)]];if(t.height>0)return[["start.angle",Lt(t.angle)],["start.height",Lt(t.height)],["start.vx",Lt(t.vx)],["start.\
vy",Lt(t.vy)],["start.omega",Lt(t.omega)]];let s=n==="load"?t.omega*e.radius:t.vx;return[["start.angle",Lt(t.angle)],["start.speed",Lt(s)]]}var ye=class{constructor(t,e,s,o,i){
this.grip=t;this.film=e;this.view=o;this.turned=0;this.trail=[];this.moved=0;this.before=ss(e,s),this.held={...this.before,vx:0,vy:0,omega:0};let r=e.at(s);this.
center=[r.x,e.radius+r.height],this.foot=o.point(r.x,0),this.from=this.read(i)}read(t){let[e,s]=this.view.unpoint(t.clientX,t.clientY),o=this.grip==="plane"?Math.
atan2(t.clientY-this.foot[1],t.clientX-this.foot[0]):Math.atan2(e-this.center[0],s-this.center[1]);return{x:t.clientX,y:t.clientY,along:e,away:s,turn:o}}move(t,e){
let s=this.read(t),{radius:o}=this.film;if(this.turned+=be(s.turn-this.from.turn-this.turned),this.grip==="plane"){let i=v(this.before.slope+this.turned,-es,es);
this.held.slope=Math.abs(i)<Xn?0:i}else if(this.grip==="load")this.held.angle=be(this.before.angle+this.turned);else{let i=this.before.height+s.away-this.from.away;
this.held.height=i<Nh*o?0:i;let r=s.along-this.from.along;this.held.angle=be(this.before.angle+(this.held.height>0?0:r/o)),this.moved=s.x-this.from.x}for(this.trail.
push({t:e/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<e/1e3-Ui;)this.trail.shift();return this.held}release(t){let{held:e,
trail:s,film:o}=this,i=s.at(-1),r=s[0],a=i&&r?i.t-r.t:0,l=!i||a<.012||t/1e3-i.t>Ui,h=Vi(o);return l||this.grip==="plane"||(this.grip==="load"?e.omega=v((i.turned-
r.turned)/a,-h/o.radius,h/o.radius):(e.vx=v((i.along-r.along)/a,-h,h),e.vy=e.height>0?v((i.away-r.away)/a,-h,h):0)),e}};function Ji(n,t,e,s,o){let i={ArrowLeft:-1,
ArrowRight:1}[t]??0,r={ArrowDown:-1,ArrowUp:1}[t]??0;if(!i&&!r)return null;let a=e?.2:1;if(n==="load"){let u=be(s.angle+(i||r)*5*Xn*a);return{...s,angle:u}}if(n===
"plane"){let u=v(s.slope+(i||-r)*Xn*a,-es,es);return{...s,slope:Math.abs(u)<1e-9?0:u}}let l=Vi(o),h=v(s.height+r*.05*a*o.radius,0,4*o.radius),m=v(s.vx+i*.1*a,-l,
l);return{...s,height:h<1e-9?0:h,vx:m}}function X(n,t,e,s=()=>{}){let o=new AbortController,{signal:i}=o,r=(l,h)=>n.addEventListener(l,m=>m.pointerId===t.pointerId&&h(m),{signal:i}),a=l=>h=>{o.abort(),
s(h,l)};n.setPointerCapture(t.pointerId),r("pointermove",e),r("pointerup",a(!0)),r("pointercancel",a(!1))}function Xi(n,t){let e=new Map,s=null,o=()=>{let[r,a]=[
...e.values()];return{span:Math.max(Math.hypot(r.clientX-a.clientX,r.clientY-a.clientY),1),clientX:.5*(r.clientX+a.clientX),clientY:.5*(r.clientY+a.clientY)}};n.
addEventListener("pointerdown",r=>{r.pointerType!=="mouse"&&(e.set(r.pointerId,r),s=e.size===2?o():null)}),n.addEventListener("pointermove",r=>{if(!e.has(r.pointerId)||
(e.set(r.pointerId,r),e.size!==2||!s))return;let a=o();t(a.span/s.span,a),s=a});for(let r of["pointerup","pointercancel"])n.addEventListener(r,a=>{e.delete(a.pointerId),
s=null});let i=r=>r.touches.length>1&&r.cancelable&&r.preventDefault();return n.addEventListener("touchmove",i,{passive:!1}),()=>e.size>1}var Hh=700,ns=44,Fh=[["plane","hand.slope_of_the_plane","hand.tilt_the_plane_drag"],["hoop","hand.the_hoop_height_and","hand.lift_roll_or_throw"],["load","hand.\
angle_of_the_load","hand.turn_the_load_drag"]],os=class{constructor(t){this.lab=t;this.pull=null;this.held=null;this.before=null;this.hint=c("div",{class:"grip-\
hint","aria-hidden":"true",hidden:!0},"hand.drag_the_load");this.places=new Map(Fh.map(([i,r,a])=>[i,this.place(i,r,a)])),this.tip=c("output",{class:"grip-tip",
"aria-hidden":"true",hidden:!0}),this.element=c("div",{class:"grips",role:"group","aria-label":"hand.the_hoop_in_your"},[...this.places.values()],this.tip,this.
hint);let{flat:e,plane:s}=t.stage;e.grab=i=>this.take(i),s.addEventListener("pointermove",i=>this.hover(i)),s.addEventListener("pointerleave",()=>this.hover(null));
let o=i=>this.pull&&i.cancelable&&i.preventDefault();s.addEventListener("touchmove",o,{passive:!1}),this.settle=ot(()=>this.chosen(!1),Hh)}static{this.Pull=ye}place(t,e,s){
return c("div",{class:`grip grip-${t}`,role:"slider",tabindex:"0","aria-label":e,"aria-valuenow":"0",title:s,onkeydown:o=>this.key(t,o),onblur:()=>this.held&&this.
chosen(!1)})}view(){return this.lab.stage.flat.views[this.lab.motions.active]}draw(){let{lab:t}=this,e=this.view(),s=!!e&&!t.stage.options.three;if(this.element.
hidden=!s,!s)return;this.element.classList.toggle("running",t.clock.playing);let{pose:o,film:i,scale:r}=e,a=i.radius,l=e.point(o.x,a+o.height),h=e.point(o.x+a*Math.
sin(o.angle),a+o.height+a*Math.cos(o.angle)),m=this.onPlane(e),u=v(1.1*a*r,ns,190),p=[["plane",m,ns],["hoop",l,u],["load",h,ns]];for(let[d,[f,_],g]of p){let b=this.
places.get(d);b.style.transform=`translate(${f-g/2}px, ${e.top+_-g/2}px)`,b.style.width=b.style.height=`${g}px`,b.hidden=f<0||_<0||f>e.width||_>e.height}if(!this.
hint.hidden){let[d,f]=p[2][1];this.hint.style.transform=`translate(${v(d,70,e.width-70)}px, ${e.top+Math.max(f-ns,18)}px) translate(-50%, -50%)`}t.clock.playing||
this.tell(i)}onPlane(t){let e=t.point(t.pose.x,0),o=(Math.min(e[0]+Math.max(1.9*t.film.radius*t.scale,90),t.width-30)-e[0])/(t.scale*Math.max(t.cosine,.2));return t.
point(t.pose.x+o,0)}tell(t){let e=this.pull?.held??this.held??ss(t,this.lab.clock.time),s={load:q(e.angle),hoop:T("hand.gap_height_speed_speed",{height:At(e.height),
speed:x(e.vx,3)}),plane:q(e.slope)},o={load:e.angle*(180/Math.PI),hoop:e.height,plane:e.slope*(180/Math.PI)},i={load:[-180,180],hoop:[0,4*t.radius],plane:[-45,45]};
for(let[r,a]of this.places)a.getAttribute("aria-valuetext")!==s[r]&&(a.setAttribute("aria-valuetext",s[r]),a.setAttribute("aria-valuenow",String(Number(o[r].toPrecision(
4)))),a.setAttribute("aria-valuemin",String(i[r][0])),a.setAttribute("aria-valuemax",String(Number(i[r][1].toPrecision(4)))))}under(t){if(this.element.hidden)return null;
let e=null;for(let[s,o]of this.places){let{left:i,top:r,width:a}=o.getBoundingClientRect(),l=Math.hypot(t.clientX-i-a/2,t.clientY-r-a/2);!o.hidden&&l<=a/2&&(e=s)}
return e}hover(t){if(this.pull)return;let e=t&&t.pointerType!=="touch"?this.under(t):null;for(let[s,o]of this.places)o.classList.toggle("near",s===e);this.lab.stage.
plane.style.cursor=e?"grab":""}take(t){let e=this.under(t);if(!e||t.button>0||this.pull)return!1;let{lab:s}=this,{flat:o,plane:i}=s.stage,r=this.places.get(e),a=this.
view(),l=i.getBoundingClientRect(),h=b=>({clientX:b.clientX-l.left,clientY:b.clientY-l.top-a.top}),m=new ye(e,s.film(),s.clock.time,a,h(t)),u=[...o.shift],[p,d]=[
!1,!1];this.pull=m,r.classList.add("held");let f=()=>{d=!0,_.abort(),r.classList.remove("held"),o.fixed=null,this.pull=null,p&&this.comeBack(u)},_=new AbortController,
g=b=>{b.key==="Escape"&&(b.stopPropagation(),f(),p&&this.back())};return addEventListener("keydown",g,{capture:!0,signal:_.signal}),X(i,t,b=>{if(!d){if(o.pinched()){
f(),p&&this.back();return}!p&&Math.hypot(b.clientX-t.clientX,b.clientY-t.clientY)<3||(p||(o.fixed=a.scale,this.hold(),this.begin()),p=!0,m.move(h(b),b.timeStamp),
o.shift=[u[0]+m.moved,u[1]],this.change(e,m.held,!1),this.show(e,m.held))}},(b,y)=>{d||(f(),p&&(y?(this.change(e,m.release(b.timeStamp),!0),this.end(!0)):this.back()))}),
!0}key(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{lab:s}=this;if(e.key==="Escape"&&this.held)this.back();else if(e.key==="Enter")this.chosen(!0);else{this.
held??=ss(s.film(),s.clock.time);let o=Ji(t,e.key,e.shiftKey,this.held,s.film());if(!o)return;this.before===null&&(this.hold(),this.begin()),this.held=o,this.change(
t==="load"?"hoop":t,o,!1),this.show(t,o),this.settle()}e.preventDefault(),e.stopPropagation()}hold(){this.lab.clock.play(!1),this.before=this.lab.film().query}begin(){
let{lab:t}=this;t.stage.options.ahead=!0,t.clock.seek(0),t.mark("holding",!0)}change(t,e,s){this.lab.motions.change(Yi(t,e,this.lab.film()),s)}show(t,e){let s={
load:`θ = ${q(e.angle)}`,hoop:e.height>0?`y = ${At(e.height)}`:`θ = ${q(e.angle)}`,plane:`β = ${q(e.slope)}`};E(this.tip,e.vx&&this.held?`${s[t]}, v = ${x(e.
vx,3)} m/s`:s[t]),this.tip.hidden=!1}chosen(t){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(t)}end(t){let{lab:e}=this;this.held=null,this.
before=null,this.tip.hidden=!0,e.stage.options.ahead=!1,e.mark("holding",!1),t&&e.clock.seek(0),t&&e.clock.run(),e.request()}async back(){let{lab:t,before:e}=this;
if(this.end(!1),e===null)return;let s=t.motions.lanes[t.motions.active];for(s.pending=null;s.busy;)await new Promise(o=>requestAnimationFrame(o));try{t.motions.
replace(await t.backend.film({query:e}))}catch(o){t.notice.fail(o)}}comeBack(t){let{flat:e}=this.lab.stage,s=Ye(),o=()=>{if(this.pull)return;let i=e.shift[0]-t[0];
e.shift=Math.abs(i)<1||s?[...t]:[t[0]+.82*i,t[1]],this.lab.request(),e.shift[0]!==t[0]&&requestAnimationFrame(o)};o()}};var Ih={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function W(n){let t="\
http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 17 17"),e.setAttribute("aria-hidden","true"),e.setAttribute("class",
`icon icon-${n}`);let s=document.createElementNS(t,"path");return s.setAttribute("d",Ih[n]),e.append(s),e}function Qn(n,t=()=>{}){let e=c("select",{class:"language","aria-label":"language.language",onchange:async()=>{try{await zt(e.value),Oi(e.value),n()}catch{e.value=
Tt(),t(new Error("language.not_loaded"))}}},Object.entries(Bt).map(([s,o])=>c("option",{value:s,lang:s},document.createTextNode(o))));return e.value=Tt(),e}var kt=n=>`event.${n}`,Qi=n=>n.kind==="takeoff"||n.to==="H"&&n.from!=="H"&&n.kind!=="impact";var $h=new Set(w.passing),jh=3,qh=1e-10;function Dh(n){let t=[],e=-1,s=-1;for(let[o,{kind:i,from:r,to:a,t:l,height:h}]of n.entries())e>=0&&i==="apex"&&(s<0||h>n[s].
height)&&(s=o),!$h.has(i)&&(e>=0&&r==="H"&&l>n[e].t&&(t.push({begin:e,top:s,end:i==="end"?-1:o}),e=s=-1),a==="H"&&i!=="end"&&([e,s]=[o,-1]));return t}var is=class{constructor(t,e,s){
let{larger:o=null,smaller:i=null,count:r=0}=e??{};this.events=t.events,this.count=Math.min(r,t.events.length),this.radius=t.radius,this.side=o??i,this.step=o?s:
-s,this.edge=!o||!i,this.sided=!this.edge&&(o?.sided||Bh(o,i))}rate(t,e){return this.side?this.side.rates[t*w.changes.length+Io[e]]:Number.NaN}of(t,e){return this.
step*this.rate(t,e)}get failed(){return this.side&&this.side.reason!=="none"?this.side.failed:-1}hops(){return Dh(this.events.slice(0,this.count)).map(({begin:t,
top:e,end:s})=>{let o=i=>s<0?Number.NaN:this.step*(this.rate(s,i)-this.rate(t,i));return{begin:t,end:s,height:this.of(e<0?t:e,"height"),distance:o("x"),duration:o(
"t")}})}};function Bh(n,t){return n!==t&&(n?.rates.some((e,s)=>Number.isFinite(e)!==Number.isFinite(t?.rates[s]))??!1)}function tr(n,t){let e=Math.abs(n);if(t===
"°")return N(x(e*180/Math.PI,3),"°");let s=e<.0995,o=e<9995e-8,[i,r]=s?o?[1e6,"µ"]:[1e3,"m"]:[1,""];return t==="m/s"?N(x(e,3),t):N(x(i*e,3),`${r}${t}`)}var rs=(n,t)=>Math.
abs(n)>qh*Math.max(t,.001);function er(n,t){return Number.isFinite(n)?rs(n,1)?`${n>0?"+":"−"}${tr(n,t)}`:"0":"–"}function Zn(n){let t=n.filter(([e])=>Number.
isFinite(e)&&rs(e,1)).map(([e,s,o,i])=>({key:e>0?o:i,values:{amount:tr(e,s)}}));return t.length?tt(t):null}var Zi=["m","sensitivity.amount_further_to_the","sens\
itivity.amount_further_to_the_left"],zh=["s","sensitivity.amount_later","sensitivity.amount_earlier"];function sr(n){let{events:t,count:e}=n,s=[],o=n.hops();for(let[
a,{begin:l,end:h,height:m,distance:u,duration:p}]of o.slice(0,jh).entries()){let d=h>=0&&t[h].x<t[l].x?-u:u,f=Zn([[m,"m","sensitivity.amount_higher","sensitivit\
y.amount_lower"],[d,"m","sensitivity.amount_longer","sensitivity.amount_shorter"],[p,"s","sensitivity.amount_more_in_the","sensitivity.amount_less_in_the"],[n.of(
l,"t"),"s","sensitivity.begins_amount_later","sensitivity.begins_amount_earlier"]]);f&&s.push(o.length>1?{key:"sensitivity.hop_number_list",values:{number:a+1,list:f}}:
{key:"sensitivity.the_hop_list",values:{list:f}})}let i=o.length?-1:t.findIndex(({kind:a},l)=>l<e&&a!=="start"&&a!=="end");if(i>=0){let a=Zn([[n.of(i,"t"),...zh],
[n.of(i,"x"),...Zi]]);a&&s.push({key:"sensitivity.the_first_event_what",values:{what:kt(t[i].kind),list:a}})}let r=e-1;if(r>0&&t[r].kind==="end"){let a=Math.sign(
t[r].vx)*n.of(r,"vx"),l=Zn([[n.of(r,"x"),...Zi],[a,"m/s","sensitivity.amount_faster","sensitivity.amount_slower"]]);l&&s.push({key:"sensitivity.at_the_end_after",
values:{time:x(t[r].t,4),list:l}})}return s}var Ft=S.words.signs,as=Object.keys(Ft);function nr(n,t=11){let s=[...n.filter(({kind:i})=>i in Ft)].sort((i,r)=>as.indexOf(i.kind)-as.indexOf(r.kind)||i.x-r.x),
o=[];for(let{kind:i,x:r}of s){let a=as.indexOf(i)<as.indexOf("takeoff"),l=o.filter(h=>Math.abs(h.x-r)<t);l.length?l.length===1&&l[0].rare&&!o.some(h=>Math.abs(h.
x-(l[0].x+t))<t-1e-9)?l[0].mark!==Ft[i]&&o.push({mark:Ft[i],x:l[0].x+t,rare:!1,hidden:0}):l[0].hidden+=1:o.push({mark:Ft[i],x:r,rare:a,hidden:0})}return o.sort(
(i,r)=>i.x-r.x).map(({mark:i,x:r})=>({mark:i,x:r}))}function or(n,t,e){let s=[],o=new Map,i=-1,r=(l,h,m)=>{let u=s.at(-1);u&&u.mode===l&&Math.abs(u.from+u.wide-
h)<1e-6?u.wide+=m:s.push({mode:l,from:h,wide:m})},a=()=>{o.size&&r([...o].reduce((l,h)=>h[1]>l[1]?h:l)[0],i,1),o=new Map};for(let{mode:l,from:h,to:m}of n){let[u,
p]=[Math.max(t(h),0),Math.min(t(m),e)];if(p>u)for(let d=u;d<p-1e-9;){if((Math.floor(d+1e-9)!==i||!o.size)&&(a(),i=Math.floor(d+1e-9),p-d>=1&&Math.abs(d-i)<1e-6)){
let _=Math.floor(p-d+1e-9);r(l,i,_),d=i+_;continue}let f=Math.min(p,i+1);o.set(l,(o.get(l)??0)+f-d),d=f}}return a(),s}var ir=.7,rr=34,Wh=3,Gh=400,Uh=8,to=13;function ar(n){let{events:t,count:e}=n;return t.slice(0,Math.min(e,Gh)).map(({kind:s,x:o,height:i},r)=>({kind:s,x:o,y:i,dx:n.
of(r,"x"),dy:n.of(r,"height")}))}function lr(n,t,e){let s=n.map(({dx:a,dy:l})=>Math.hypot(a,l)).filter(a=>Number.isFinite(a)&&rs(a,t)).sort((a,l)=>a-l);if(!s.length)
return 0;let o=Math.max(ir*t,rr/e)/s[Math.floor(s.length/2)];if(o<=1)return 1;let i=10**Math.floor(Math.log10(o)),r=o/i;return(r>=5?5:r>=2?2:1)*i}function hr(n,t,e){
let s=[],o=Wh*Math.max(ir*n.film.radius,rr/n.scale);for(let{kind:i,x:r,y:a,dx:l,dy:h}of t){let m=Number.isFinite(l)&&Number.isFinite(h),u=m?e*Math.hypot(l,h):0,
p=u>o?o/u:1,d=m?[p*e*l,p*e*h]:[0,0],f=n.point(r,a),_=n.point(r+d[0],a+d[1]);if(Math.max(f[0],_[0])<-20||Math.min(f[0],_[0])>n.width+20)continue;let[g,b]=[Math.min(
f[0],_[0])-12,Math.max(f[0],_[0])+12],y=f[1];for(;s.some(M=>Math.abs(M.base-y)<to-1&&M.low<b&&M.high>g);)y-=to;if(f[1]-y>Uh*to)continue;s.push({low:g,high:b,base:y});
let k=y-f[1];Kh(n,f,[_[0],_[1]+k],k,{known:m,broken:p<1,mark:Ft[i]??""})}}function Kh({context:n,look:t},e,s,o,{known:i,broken:r,mark:a}){let l=[e[0],e[1]+o],h=Math.
hypot(s[0]-l[0],s[1]-l[1]),[m,u]=h>0?[(s[0]-l[0])/h,(s[1]-l[1])/h]:[1,0],p=Math.min(9,h);for(let[f,_]of[[t.paper,6.5],[t.ink,2.5]])n.strokeStyle=f,n.fillStyle=f,
n.lineCap="round",o&&(n.lineWidth=_>3?3:1,n.beginPath(),n.moveTo(e[0],e[1]),n.lineTo(l[0],l[1]),n.stroke()),n.lineWidth=_,n.setLineDash(r?[5,6]:[]),n.beginPath(),
n.moveTo(l[0],l[1]),n.lineTo(s[0]-m*p,s[1]-u*p),n.stroke(),n.setLineDash([]),n.beginPath(),n.arc(l[0],l[1],_>3?5.5:3.5,0,2*Math.PI),n.fill(),!(h<1)&&(n.lineWidth=
_>3?4:1,n.beginPath(),n.moveTo(s[0],s[1]),n.lineTo(s[0]-m*p-u*p*.55,s[1]-u*p+m*p*.55),n.lineTo(s[0]-m*p+u*p*.55,s[1]-u*p-m*p*.55),n.closePath(),n.stroke(),n.fill());
n.lineCap="butt";let d=i?a:"?";d&&(n.font=`600 ${11*t.px}px ${t.font}`,n.textAlign="center",n.lineWidth=3,n.strokeStyle=t.paper,n.fillStyle=t.ink,n.strokeText(d,
l[0],l[1]-7),n.fillText(d,l[0],l[1]-7))}var cr=Math.PI/180,Vh=100,mr="plane.mu",Yh=/^(contact\.|duration$)/,Jh=200,eo=n=>`reason.${n}`,ls=class{constructor(t){this.lab=t;this.on=!1;this.path=mr;this.changes=
null;this.arrows=[];this.factor=0;this.three=!1;this.asked=null;this.known="";this.paths="";this.speak=!1;this.later=ot(()=>this.fetch(),Vh),this.switch=c("butt\
on",{type:"button",class:"switch",title:"sensitivity.what_a_little_more","aria-pressed":"false",onclick:()=>this.turn()},"sensitivity.arrows"),this.picked=c("se\
lect",{onchange:()=>this.pick(this.picked.value)}),this.step=c("span",{class:"more-step"}),this.take=c("button",{type:"button",onclick:()=>this.apply()},"sensit\
ivity.do_it"),this.said=c("ul",{class:"more-said"}),this.reason=c("p",{class:"more-reason",hidden:!0}),this.scale=c("p",{class:"hint"}),this.body=c("tbody",{}),
this.rows=c("details",{class:"more-events"},c("summary",{},"sensitivity.every_event_by_this"),c("div",{class:"table-scroll",tabindex:"0",role:"region","aria-lab\
el":"sensitivity.what_changes_at_every"},c("table",{},c("thead",{},c("tr",{},["sensitivity.event","column.time","sensitivity.place","sensitivity.height","sensit\
ivity.load_angle"].map(e=>c("th",{scope:"col"},e)))),this.body))),this.element=c("section",{class:"table more","aria-label":"sensitivity.what_a_little_more_woul\
d",hidden:!0},c("header",{},c("h2",{},"sensitivity.what_a_little_more_would"),c("button",{type:"button",onclick:()=>this.turn(!1)},"table.close")),c("div",{class:"\
more-asked"},c("label",{},c("span",{},"sensitivity.a_little_more"),this.picked),this.step,this.take),this.said,this.reason,this.rows,this.scale),t.stage.flat.over=
(e,s)=>{let o=t.marked("guessing");if(!this.on||o||s!==t.motions.active)return;let i=lr(this.arrows,e.film.radius,e.scale);(i||this.arrows.some(({dx:r})=>Number.
isNaN(r)))&&hr(e,this.arrows,i||1),i!==this.factor&&(this.factor=i,this.tellScale())}}turn(t=!this.on,e=this.path){this.on=t,this.path=e,this.element.hidden=!t,
this.switch.setAttribute("aria-pressed",String(t)),this.known="",t?this.changed(!0):this.forget(),this.lab.motions.lanes.length&&this.lab.address?.soon(),this.lab.
request()}pick(t){this.path=t,this.known="",this.changed(!0),this.lab.address?.soon()}offered(){return[...this.lab.controls.sliders.values()].filter(({info:e,element:s})=>!s.
hidden&&!Yh.test(e.path)).map(({info:e})=>e)}parameter(){let{values:t,scenario:e}=this.lab.film(),s=this.offered().find(({path:a})=>a===this.path);if(!s)return null;
let[o,i]=s.path.split("."),r=t[s.path]??e[o][i];return{info:s,value:Number(r==="inf"?1/0:r),step:s.step*(s.degrees?cr:1)}}changed(t=!1){if(!this.on||(this.speak||=
t,!this.lab.motions.lanes.length))return;this.offer();let{query:e}=this.lab.film();this.known===`${this.path} ${e}`?this.tell():(this.forget(),this.later())}offer(){
let t=this.offered();t.some(({path:s})=>s===this.path)||(this.path=t.find(({path:s})=>s.startsWith(mr))?.path??t[0].path);let e=t.map(({path:s})=>s).join();if(e!==
this.paths){this.paths=e;let s=({path:o,label:i,symbol:r})=>c("option",{value:o},i," ",r);this.picked.replaceChildren(...t.map(s))}this.picked.value=this.path}forget(){
this.asked?.abort(),this.changes=null,this.arrows=[],this.factor=0}async fetch(){if(!this.on)return;let{lab:t,path:e}=this,s=t.film(),o=this.parameter();this.asked?.
abort(),this.asked=new AbortController;let{signal:i}=this.asked;if(this.known=`${e} ${s.query}`,!o||!Number.isFinite(o.value))return this.refuse("sensitivity.it\
_is_infinite_there");try{let r=await t.backend.changes(s.scenario,e,i);if(i.aborted||t.film()!==s)return;if(!r)return this.refuse(eo("edge"));this.changes=new is(
s,r,o.step),this.arrows=ar(this.changes),this.factor=0,this.tell()}catch(r){r.name!=="AbortError"&&!i.aborted&&this.refuse(K(r))}t.request()}refuse(t){this.forget(),
this.take.disabled=!0;for(let e of[this.step,this.said,this.body])e.replaceChildren();this.rows.hidden=this.scale.hidden=!0,this.reason.hidden=!1,E(this.reason,
t),this.speak&&this.lab.story.say(t),this.speak=!1,this.lab.request()}tell(){let{changes:t}=this,e=this.parameter();if(!t||!e)return;let{info:s,value:o}=e,i=h=>N(
x(s.degrees?h/cr:h,5),s.unit),r=`${i(o)} → ${i(o+t.step)}`;this.step.textContent=r,this.take.disabled=!1,this.rows.hidden=this.scale.hidden=!1;let a=sr(t);!a.
length&&t.failed<0&&a.push("sensitivity.nothing_no_event_moves"),this.said.replaceChildren(...a.map(h=>c("li",{},[h])));let l=this.why(t);this.reason.hidden=!l,
E(this.reason,l),this.fill(t),this.tellScale(),this.speak&&this.lab.story.say([s.label,` ${r}.`,...[...a,l].flatMap(h=>h?[" ",h]:[])]),this.speak=!1}frame(){let{
three:t}=this.lab.stage.options;this.on&&t!==this.three&&this.changes&&this.tellScale(),this.three=t}tellScale(){let{three:t}=this.lab.stage.options,e=t?"sensit\
ivity.the_arrows_are_drawn":{key:"sensitivity.the_arrows_in_the",values:{factor:x(this.factor,3)}};E(this.scale,t||this.factor?e:"")}why(t){let{failed:e,side:s,
events:o,edge:i,sided:r}=t;if(e>=0&&s){let{kind:a,t:l}=o[Math.min(e,o.length-1)];return{key:"sensitivity.from_what_at_time",values:{what:kt(a),time:x(l,4),reason:eo(
s.reason)}}}return!i&&!r?"":{key:"sensitivity.to_one_side_only",values:{reason:eo(i?"edge":"sided")}}}fill(t){let e=(o,i,r)=>{let a=er(o,i),l=a[0]==="+"?"▲ ":
a[0]==="−"?"▼ ":"";return c("td",{"data-rate":String(r)},l&&c("span",{"aria-hidden":"true"},l),a)},s=[["t","s"],["x","m"],["height","m"],["angle","°"]];this.
body.replaceChildren(...t.events.slice(0,Math.min(t.count,Jh)).map(({kind:o,t:i},r)=>c("tr",{onclick:()=>this.lab.clock.seek(i)},c("th",{scope:"row"},kt(o),c("s\
mall",{},` ${x(i,4)} s`)),s.map(([a,l])=>e(t.of(r,a),l,t.rate(r,a))))))}apply(){let t=this.parameter();if(!t||!this.changes)return;let e=Number((t.value+this.changes.
step).toPrecision(12));this.lab.motions.change([[this.path,e]],!0)}};var hs=class{constructor(t,e){this.root=t;this.show=e;this.full=!1;this.on=!1;this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener(
"fullscreenchange",this.left),this.onchange=()=>{}}async turn(t=!this.on){let{root:e}=this;if(this.on=t,e.classList.toggle("presenting",t),this.onchange(),this.
show(),!t){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await e.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var ur=.22,pr=.03;function dr(n,t){let e=n.at(t),s=n.mass*(n.gravity||9.81),o=e.mode==="H"||!(e.normal_force>0)?0:e.normal_force/s,i=o/(1+o),r=e.mode==="S"||e.mode===
"K",a=Math.abs(e.slip)/Math.sqrt((n.gravity||9.81)*n.radius);return{tone:i,pitch:55*(1+Math.min(o,8))**.5,hiss:r?i*v(.15+a,0,1):0}}function fr(n,t,e){let s=Math.
sqrt(2*(n.gravity||9.81)*n.radius);return n.events.filter(({kind:o,t:i,before:r})=>o==="impact"&&r&&i>t&&i<=e).map(({before:o})=>v(Math.abs(o.vy)/s,.02,1))}function Xh(n){
let t=n.createBuffer(1,n.sampleRate,n.sampleRate),e=t.getChannelData(0),s=1;for(let o=0;o<e.length;o++)s=s*16807%2147483647,e[o]=2*s/2147483647-1;return t}var cs=class{constructor(){
this.context=null;this.on=!1;this.last=0}static{this.heard=dr}static{this.knocks=fr}start(){let t=new AudioContext,e=t.createOscillator();e.type="triangle";let s=t.
createBufferSource();s.buffer=Xh(t),s.loop=!0;let o=t.createBiquadFilter();o.type="bandpass",o.frequency.value=1800,o.Q.value=.6;let[i,r]=[t.createGain(),t.createGain()];
i.gain.value=r.gain.value=0,e.connect(i).connect(t.destination),s.connect(o).connect(r).connect(t.destination),e.start(),s.start(),this.context=t,Object.assign(
this,{tone:e,low:i,high:r})}turn(t){this.on=t,t&&!this.context&&this.start(),t?this.context?.resume():this.context&&(this.set("low",0),this.set("high",0))}set(t,e){
let{gain:s}=this[t];s.setTargetAtTime(ur*e,this.context.currentTime,pr)}follow(t,e){if(!this.on||!this.context)return;if(!e.playing){this.set("low",0),this.set(
"high",0),this.last=e.time;return}let{tone:s,pitch:o,hiss:i}=dr(t,e.time);if(this.set("low",s),this.set("high",.6*i),this.tone.frequency.setTargetAtTime(o,this.
context.currentTime,pr),e.time>this.last)for(let r of fr(t,this.last,e.time))this.knock(r);this.last=e.time}knock(t){let e=this.context,s=e.currentTime,o=e.createGain();
o.gain.setValueAtTime(2.2*ur*Math.sqrt(t),s),o.gain.exponentialRampToValueAtTime(1e-4,s+.18);let i=e.createOscillator();i.frequency.setValueAtTime(190,s),i.frequency.
exponentialRampToValueAtTime(60,s+.15),i.connect(o).connect(e.destination),i.start(s),i.stop(s+.2)}close(){this.context?.close()}};var so=Math.PI/180,Y=n=>t=>t.columns[n],we=(n,t)=>e=>e.derived(n,s=>Float64Array.from(e.t,(o,i)=>t(s,i,e))),D={time:{name:"column.time",symbol:"t",unit:"s",values:n=>n.
t},angle:{name:"column.angle",symbol:"θ",unit:"°",values:we("degrees",({angle:n},t)=>n[t]/so)},turns:{name:"column.angle_within_a_turn",symbol:"column.theta_m\
od_360",unit:"°",values:we("within",({angle:n},t)=>{let e=s=>Math.floor(n[s]/so/360);return t>0&&e(t)!==e(t-1)?Number.NaN:n[t]/so-360*e(t)})},x:{name:"column.p\
lace_of_the_centre",symbol:"x",unit:"m",values:Y("x")},height:{name:"column.gap_under_the_rim",symbol:"y",unit:"m",values:Y("height")},rise:{name:"column.height\
_of_the_centre",symbol:"h_G",unit:"m",values:we("rise",({height:n,angle:t},e,s)=>s.radius*(1+s.eccentricity*Math.cos(t[e]))+n[e])},vx:{name:"column.speed_of_the\
_centre",symbol:"v",unit:"m/s",values:Y("vx")},spin:{name:"column.speed_of_rotation",symbol:"R θ̇",unit:"m/s",values:we("spin",({omega:n},t,e)=>n[t]*e.radius)},
vy:{name:"column.speed_away_from_the",symbol:"ẏ",unit:"m/s",values:Y("vy")},slip:{name:"column.slip_velocity",symbol:"v_t",unit:"m/s",values:Y("slip")},omega:{
name:"column.angular_velocity",symbol:"θ̇",unit:"rad/s",values:Y("omega")},normal_force:{name:"column.normal_force",symbol:"N",unit:"N",values:Y("normal_force")},
friction_force:{name:"column.friction_force",symbol:"F",unit:"N",values:Y("friction_force")},utilization:{name:"column.use_of_friction",symbol:"|F|/μN",unit:"",
values:Y("utilization")},kinetic:{name:"column.kinetic_energy",symbol:"W_k",unit:"J",values:Y("kinetic")},potential:{name:"column.potential_energy",symbol:"W_p",
unit:"J",values:Y("potential")},total:{name:"column.total_energy",symbol:"W",unit:"J",values:we("total",({kinetic:n,potential:t},e)=>n[e]+t[e])},friction_loss:{
name:"diagram.lost_to_friction",symbol:"W_f",unit:"J",values:Y("friction_loss")},normal_loss:{name:"diagram.lost_in_impacts_normal",symbol:"W_i",unit:"J",values:Y(
"normal_loss")},rolling_resistance:{name:"diagram.lost_to_rolling_resistance",symbol:"W_r",unit:"J",values:Y("rolling_resistance")}},gr=({name:n,symbol:t})=>[n,
" ",t];var Qh=["time","angle","x","vx","spin","normal_force","friction_force"],Zh=[1,.5,.2,.1,.05,.02,.01],no=601;function _r(n,t,e){let s=Math.min(Math.floor(n.duration/
e+1e-9)+1,no),o=[];for(let i=0;i<s;i++){let r=Number((i*e).toPrecision(12));o.push({time:r,mode:n.at(r).mode,values:t.map(a=>tc(n,a,r))})}return o}function tc(n,t,e){
return D[t].values(n.moment(e))[0]}var ms=class{constructor({film:t,clock:e,names:s}){this.rows=[];this.columns=[...Qh];this.source=t,this.clock=e,this.names=s,
this.step=c("select",{onchange:()=>this.fill()},Zh.map(o=>c("option",{value:String(o)},`${o} s`))),this.step.value="0.1",this.picks=c("div",{class:"table-picks"},
Object.entries(D).filter(([o])=>o!=="time").map(([o,{name:i}])=>this.pick(o,i))),this.caption=c("caption",{}),this.head=c("thead",{}),this.body=c("tbody",{}),this.
element=c("section",{class:"table","aria-label":"table.table_of_the_motion",hidden:!0},c("header",{},c("h2",{},"table.table"),c("label",{class:"table-step"},c("\
span",{},"table.every"),this.step),c("button",{type:"button",onclick:()=>this.save()},"table.save_as_csv"),c("button",{type:"button",onclick:()=>this.open(!1)},
"table.close")),c("details",{class:"table-columns"},c("summary",{},"table.columns"),this.picks),c("div",{class:"table-scroll",tabindex:"0",role:"region","aria-l\
abel":"table.table_of_the_motion_rows"},c("table",{},this.caption,this.head,this.body)))}pick(t,e){let s=c("input",{type:"checkbox",checked:this.columns.includes(
t),onchange:()=>{let o=new Set(this.columns);s.checked?o.add(t):o.delete(t),this.columns=Object.keys(D).filter(i=>o.has(i)),this.fill()}});return c("label",{},s,
c("span",{},e))}open(t){this.element.hidden=!t,t&&(this.draw(this.source()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.
focus())}draw(t){this.element.hidden||(this.film=t,this.fill())}fill(){let{film:t,columns:e}=this,s=Number(this.step.value),o=this.names(),i=e.map(h=>D[h]);this.
head.replaceChildren(c("tr",{},i.map(({name:h,symbol:m,unit:u})=>c("th",{scope:"col",title:h},m,u&&c("small",{},` ${u}`))),c("th",{scope:"col"},"table.mode")));
let r=_r(t,e,s);this.rows=r.map(({time:h,mode:m,values:u})=>({time:h,row:c("tr",{onclick:()=>this.clock.seek(h)},u.map((p,d)=>d===0?c("th",{scope:"row"},x(p,4)):
c("td",{},x(p,4))),c("td",{class:"table-mode"},o[m]))})),this.body.replaceChildren(...this.rows.map(({row:h})=>h));let a=t.duration/s+1<=no+1e-6,l={key:"table.t\
he_first_count_rows",values:{count:no}};E(this.caption,a?t.summary:[t.summary," ",l]),this.cursor(this.clock.time)}cursor(t){if(this.element.hidden||!this.rows.
length)return;let e=Number(this.step.value),s=this.rows[Math.min(Math.round(t/e),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.
add("now"),this.now=s)}save(){let{film:t,columns:e}=this,s=[...e.map(i=>`${T(D[i].name)} [${D[i].unit||"1"}]`),T("table.mode")],o=_r(t,e,Number(this.step.value)).
map(({mode:i,values:r})=>[...r,i].join(","));Gt(new Blob([[s.join(","),...o,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var ec=[["keys.space","keys.play_pause"],["← →","keys.one_frame"],["keys.shift","keys.previous_next_event"],["h  l","keys.next_flight_landing"],["[ ]","keys\
.slower_faster"],["keys.home_end","keys.start_end"],["t f c w","keys.traces_forces_rim_speed"],["a","keys.arrows_what_a_little"],["3","keys.in_space"],["+ − 0",
"keys.zoom_zoom_back"],["keys.esc","keys.leave_a_field_a"],["keys.z_y_ctrl_z","keys.undo_redo"],["d","keys.dark_light"],["p","keys.python"]],sc=[["R","mode.roll",
"keys.the_rim_does_not"],["S","mode.spin","keys.slip_the_rim_turns"],["K","mode.skid","keys.slip_the_rim_slides"],["H","mode.flight","keys.the_hop_from_take"],[
"M","mode.skim","keys.a_massless_rim_that"]],nc=[["▲ ▼","keys.take_off_landing"],["•","event.apex"],["↺","event.turn"],["◆ ◇","keys.painleves_parado\
x_no_solution"],["✖","event.jam"],["✚","example.kane"],["≋","keys.bounces_without_number_end"],["◗ ■","keys.skimming_begins_rest"]],oo=(n,t,e=()=>!1)=>c(
"table",{},c("caption",{},n),t.map(([s,...o])=>c("tr",{},c("th",{scope:"row"},e(s),s),o.map(i=>c("td",{},i))))),io=()=>document.querySelector("meta[name=hophoop\
-docs]")?.content;function br(n,t){let e=io(),s=(a,l)=>c("a",{href:a,target:"_blank",rel:"noopener"},l),o=(a,...l)=>[c("dt",{},a),c("dd",{},l)],i=t&&s(new URL("\
licences.txt",import.meta.url).href,"keys.licences_of_all_that"),r=c("dialog",{class:"about","aria-label":"menu.about_hophoop"},c("h2",{},"menu.about_hophoop"),
c("p",{},"keys.hophoop_computes_exactly_how"),c("dl",{},o("keys.version",document.createTextNode(n)),o("keys.licence",document.createTextNode("MIT"),...i?[". ",
i]:[]),o("keys.documentation",e?s(e,"keys.the_documentation"):"keys.docs_index_md_in"),o("keys.commands",c("code",{},document.createTextNode("hophoop --help")))),
c("button",{type:"button",class:"close",onclick:()=>r.close()},"table.close"));return r}function yr(n,t,e){let s=c("dialog",{class:"help","aria-label":"keys.key\
s_and_help"},c("h2",{},"player.the_hoop"),c("p",{},"keys.a_ring_with_a"),oo("keys.modes",sc,o=>c("i",{class:"dot",style:`background:${t.modes[o]}`})),oo("keys.m\
arks_on_the_bar",nc),oo("keys.keys",ec),e,c("button",{type:"button",class:"link",onclick:()=>n.showModal()},"menu.about_hophoop"),c("button",{type:"button",class:"\
close",onclick:()=>s.close()},"table.close"));return s}var wr="hoop.radius=0.4&duration=1.5&start.speed=",oc=[["0","teach.show_the_hoop_at","duration=2"],["3","teach.everybody_predicts_where_the",null],["7","teach.e\
nergy_on_the_way","start.speed=0.1&duration=8"],["17","teach.lift_at_the_top","start.speed=3.7&duration=2"],["24","teach.the_film_again_in","duration=2"],["28",
"teach.each_group_takes_one",`${wr}2.2`],["35","teach.why_what_has_to",null],["42","teach.one_sentence_each_the",null]],ic=[["teach.the_load_pulls_the","teach.o\
nly_if_it_is"],["teach.it_hops_at_the","teach.there_the_floor_pushes"],["teach.nothing_can_be_faster","teach.the_ring_can_it"],["teach.friction_always_brakes","\
teach.it_acts_against_slip"],["teach.more_friction_more_hop","teach.there_is_a_best"],["teach.a_heavier_hoop_behaves","teach.only_the_shares_of"]],rc=["teach.be\
fore_the_film_where","teach.the_hoop_gets_only","teach.while_a_wheel_rolls","teach.how_fast_is_a","teach.find_the_force_of","teach.in_the_lab_what","teach.find_\
the_smallest_speed","teach.at_2_2_m"],ac=["1.0","1.3","1.6","1.9","2.2","2.3"];function vr(n,t){let e=m=>{h.close(),n(m)},s=(m,u="teach.show")=>c("button",{type:"\
button",class:"link",onclick:()=>e(m)},u),o=io(),i=o&&[["teach/index.html","teach.teaching_with_the_hoop"],["teach/worksheet.html","teach.worksheet"],["teach/so\
lutions.html","teach.solutions"],["teach/exercises.html","teach.exercises"]],r=c("table",{},c("caption",{},"teach.a_lesson_of_45"),c("thead",{},c("tr",{},["teac\
h.minute","motion.what_happens","teach.motion"].map(m=>c("th",{scope:"col"},m)))),c("tbody",{},oc.map(([m,u,p])=>c("tr",{},c("th",{scope:"row"},m),c("td",{},u),
c("td",{},p===null?"":s(p)))))),a=c("table",{},c("caption",{},"teach.what_students_often_think"),c("thead",{},c("tr",{},["teach.idea","teach.what_is_right"].map(
m=>c("th",{scope:"col"},m)))),c("tbody",{},ic.map(([m,u])=>c("tr",{},c("td",{},m),c("td",{},u))))),l=c("section",{class:"sheet"},c("h3",{},"teach.worksheet_the_\
hoop_that"),c("p",{},"teach.a_thin_ring_of"),c("ol",{},rc.map(m=>c("li",{},m,c("div",{class:"answer-line"})))),c("table",{class:"sheet-table"},c("thead",{},c("t\
r",{},["v₀ [m/s]","teach.phases","teach.does_it_hop","teach.at_which_angle"].map(m=>c("th",{scope:"col"},m)))),c("tbody",{},ac.map(m=>c("tr",{},c("th",{scope:"\
row"},s(`${wr}${Number(m)}`,m)),c("td",{}),c("td",{}),c("td",{})))))),h=c("dialog",{class:"teach","aria-label":"menu.for_teachers"},c("header",{},c("h2",{},"men\
u.for_teachers"),c("button",{type:"button",onclick:()=>print()},"teach.print"),c("button",{type:"button",class:"close",onclick:()=>h.close()},"table.close")),c(
"p",{},"teach.the_visit_asks_before"," ",c("button",{type:"button",class:"link",onclick:()=>{h.close(),t()}},"teach.start_the_visit")),i&&c("p",{},i.map(([m,u])=>c(
"a",{class:"teach-page",href:new URL(m,new URL(o,document.baseURI)).href},u))),r,a,l);return h}var ro=S.words.letters,lc=1/60,hc=10,xr=8,cc={x:"vx",angle:"omega",height:"vy"},It=class{constructor(t){this.latest=null;this.pinned=null;this.sure=!0;this.cache=
new Map;this.part=null;let{header:e}=t;this.scenario=e.scenario,this.query=e.query,this.duration=e.duration,this.status=e.status,this.sequence=e.sequence,this.fingerprint=
e.fingerprint??null,this.events=e.events,this.values=e.values,this.automatic=e.automatic,this.summary=e.summary,this.story=e.story,this.shortened=e.shortened,this.
doubt=e.doubt??"",this.columns=t.arrays,this.exact=t.exact,this.samples=t.samples,this.t=t.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radi\
us"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.
gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent()}wanted(t,e=0){if(this.duration<lc*this.length)return null;let s=v(t,0,this.duration),o=Math.
min(s+e,this.duration);if(this.part&&s>=this.part.t[0]&&o<=this.part.t[this.part.length-1])return null;let i=Math.max(s-.25*xr,0);return[i,Math.min(i+xr+e,this.
duration)]}refine(t){this.part=this.with(t),this.latest=null}with(t){let{t:e}=t,s={columns:t,t:e,length:e.length,cache:new Map,part:null,latest:null,pinned:null,
sure:!0};return Object.assign(Object.create(this),s)}pin(t,e){let s=this.with(t);this.pinned=s.one(s.index(e)),this.latest=null}one(t){return this.with(Object.fromEntries(
Object.entries(this.columns).map(([e,s])=>[e,[s[t]]])))}holding(t){let{part:e}=this;return e&&t>=e.t[0]&&t<=e.t[e.length-1]?e:this}findPhases(){let{mode:t}=this.
columns,e=[];for(let s=0;s<this.length;s++){let o=e.at(-1);o&&o.mode===ro[t[s]]?o.to=this.t[s]:e.push({mode:ro[t[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+
1<e.length;s++)e[s].to=e[s+1].from;return e.filter(s=>s.to>s.from||e.length===1)}findExtent(){let{x:t,height:e,vx:s,vy:o,omega:i}=this.columns,r={left:1/0,right:-1/0,
top:0,speed:0},a=[];for(let h=0;h<this.length;h++){Number.isFinite(t[h])&&(r.left=Math.min(r.left,t[h]),r.right=Math.max(r.right,t[h])),e[h]>r.top&&(r.top=e[h]);
let m=Math.hypot(s[h],o[h])+this.radius*Math.abs(i[h]),u=Math.floor(this.t[h]/hc);a[u]??=[],Number.isFinite(m)&&a[u].push(m)}let l=h=>h.sort((m,u)=>m-u)[Math.floor(
.95*(h.length-1))];return r.speed=Math.max(0,...a.filter(h=>h?.length).map(l))||1,r}index(t){let e=0,s=this.length;for(;s-e>1;){let o=e+s>>1;this.t[o]<=t?e=o:s=
o}return e}pieces(){let{part:t}=this;if(!t)return[{film:this,from:0,to:this.length}];let[e,s]=[t.t[0],t.t[t.length-1]],o=this.index(e);for(;o>0&&this.t[o]>=e;)o--;
let i=this.t[o]>=e?0:o+1;return[{film:this,from:0,to:i},{film:t,from:0,to:t.length},{film:this,from:this.index(s)+1,to:this.length}]}moment(t){let e=v(t,0,this.
duration);if(this.latest?.t[0]===e)return this.latest;let{pinned:s,exact:o}=this,i=this.holding(e),r=i.index(e);return o?this.latest=this.with({...o(e),mode:[i.
columns.mode[r]]}):s?.t[0]===e?this.latest=s:this.latest=i.t[r]===e?i.one(r):i.between(e,r),this.latest}between(t,e){let s=Math.min(e+1,this.length-1),o=this.t[s]-
this.t[e],i=o>0?(t-this.t[e])/o:0,r={};for(let[a,l]of Object.entries(this.columns)){let h=l[e],m=l[s],u=this.columns[cc[a]];a==="mode"||!Number.isFinite(m)?r[a]=
[h]:r[a]=[u?mc(h,m,u[e]*o,u[s]*o,i):h+(m-h)*i]}return Object.assign(this.with({...r,t:[t]}),{sure:!1})}at(t){let{columns:e,sure:s}=this.moment(t);return{...Object.
fromEntries(Object.entries(e).map(([i,[r]])=>[i,r])),mode:ro[e.mode[0]],digits:s?3:2}}derived(t,e){let s=this.cache.get(t)??e(this.columns);return this.cache.set(
t,s),s}};function mc(n,t,e,s,o){if(!Number.isFinite(e)||!Number.isFinite(s))return n+(t-n)*o;let i=1-o;return i*i*(1+2*o)*n+o*o*(3-2*o)*t+o*i*(i*e-o*s)}var ho=n=>n-360*Math.floor(n/360);function uc(n,t){let e=Math.abs(ho(n-t+180)-180);return Math.round(100*v(1-(e-1)/89,0,1))}function pc(n,t){let e=Math.max(...t)-
Math.min(...t,0),s=t.reduce((o,i,r)=>o+Math.abs(i-n[r]),0)/t.length;return Math.round(100*v(1-2*s/(e||1),0,1))}var dc=0;function ke(n,t,e=!1){let s=`hh-guess-${++dc}`,
o="",i=n.map(([r,a])=>{let l=c("input",{type:"radio",name:s,value:r,onchange:()=>{o=r,t()}});return{key:r,radio:l,row:c("label",{class:"guess-choice"},l,c("span",
{},a))}});return{element:c("div",{class:"guess",role:"radiogroup","aria-label":"visit.your_guess"},i.map(({row:r})=>r)),made:()=>o!=="",judge:r=>{for(let{key:a,
radio:l,row:h}of i){l.disabled=!0;let m=e||a===r;m&&h.append(c("b",{class:"guess-right"},"✓")),h.classList.toggle("right",m)}return e||o===r?100:0}}}var _t=168,
xe=58,ao=(n,t=xe)=>{let e=n*Math.PI/180;return[_t/2+t*Math.sin(e),_t/2-t*Math.cos(e)]};function co(n,t){let e=0,s=!1,o=null,i=c("canvas",{class:"dial-canvas"}),
r=c("div",{class:"guess dial",role:"slider",tabindex:"0","aria-label":n,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},i),a=()=>{let m=getComputedStyle(
r),{context:u}=B(i,Number.parseFloat(m.width)/_t||1),p=m.getPropertyValue("--ink").trim(),d=m.getPropertyValue("--soft").trim(),f=m.getPropertyValue("--accent").
trim();u.clearRect(0,0,_t,_t),u.strokeStyle=d,u.fillStyle=d,u.lineWidth=1.5,u.beginPath(),u.moveTo(8,_t/2+xe),u.lineTo(_t-8,_t/2+xe),u.stroke(),u.lineWidth=4,u.
beginPath(),u.arc(_t/2,_t/2,xe,0,2*Math.PI),u.stroke(),u.font="11px system-ui, sans-serif",u.textAlign="center";for(let g of[0,90,180,270]){let[b,y]=ao(g,xe-28);
u.fillText(`${g}°`,b,y+4)}let _=(g,b,y)=>{u.fillStyle=b,u.beginPath(),u.arc(...ao(g),y,0,2*Math.PI),u.fill()};o!==null&&(u.strokeStyle=p,u.lineWidth=2,u.beginPath(),
u.arc(...ao(o),12,0,2*Math.PI),u.stroke(),_(o,p,7)),_(e,s?f:d,9)},l=m=>{o===null&&(e=ho(m),s=!0,r.setAttribute("aria-valuenow",String(Math.round(e))),r.setAttribute(
"aria-valuetext",`${Math.round(e)}°`),a(),t())},h=m=>{let u=i.getBoundingClientRect(),[p,d]=[m.clientX-u.left-u.width/2,m.clientY-u.top-u.height/2];l(Math.atan2(
p,-d)*180/Math.PI)};return r.addEventListener("pointerdown",m=>{m.preventDefault(),r.focus({preventScroll:!0}),h(m),X(r,m,h)}),r.addEventListener("keydown",m=>{
let u={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,PageUp:45}[m.key];u!==void 0&&(m.preventDefault(),m.stopPropagation(),l(e+(m.shiftKey?u/5:u)))}),
requestAnimationFrame(a),{element:r,redraw:a,made:()=>s,judge:m=>(o=ho(m),a(),uc(e,o))}}var ve=9,[gt,us,$t,lo]=[34,12,12,26];function kr({label:n,unit:t,most:e},s){
let o=Array(ve).fill(e/4),i=!1,r=null,a=c("canvas",{class:"sketch-canvas"}),l=o.map((y,k)=>c("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":{
key:"visit.what_with_the_load",values:{what:n,angle:`${45*k}°`}},"aria-orientation":"vertical","aria-valuemin":"0","aria-valuemax":String(e),onkeydown:M=>{let O={
ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[M.key];O&&(M.preventDefault(),M.stopPropagation(),_(k,o[k]+O*e/(M.shiftKey?100:20)))}})),h=c("div",{class:"gue\
ss sketch",role:"group","aria-label":"visit.draw_the_curve_pull"},a,l),m=()=>a.getBoundingClientRect(),u={width:0,height:0,px:1},p=y=>gt+y/(ve-1)*(u.width-gt-us),
d=y=>$t+(1-y/e)*(u.height-$t-lo),f=()=>{let y=getComputedStyle(h),k=Number.parseFloat(y.getPropertyValue("font-size"))/14||1,{context:M,width:O,height:G}=B(a,k);
u={width:O,height:G,px:k};let H=R=>y.getPropertyValue(R).trim();M.clearRect(0,0,O,G),M.strokeStyle=H("--line"),M.fillStyle=H("--soft"),M.font="11px system-ui, s\
ans-serif";for(let R=0;R<ve;R+=2)M.textAlign="center",M.fillText(`${45*R}°`,p(R),G-8),M.strokeRect(p(R),$t,0,G-$t-lo);for(let R of[0,e/2,e])M.textAlign="right",
M.fillText(String(R),gt-6,d(R)+4),M.strokeRect(gt,d(R),O-gt-us,0);M.textAlign="left",M.fillText(t,gt+4,$t+10);let Xt=(R,Rt,Mt)=>{M.strokeStyle=Rt,M.lineWidth=2.5,
M.setLineDash(Mt),M.beginPath(),R.forEach((Oo,No)=>{let Ho=gt+No/(R.length-1)*(O-gt-us);No?M.lineTo(Ho,d(v(Oo,0,e))):M.moveTo(Ho,d(v(Oo,0,e)))}),M.stroke(),M.setLineDash(
[])};Xt(o,H("--accent"),[6,4]),r&&Xt(r,H("--ink"),[]),l.forEach((R,Rt)=>{R.style.transform=`translate(${k*p(Rt)}px, ${k*d(o[Rt])}px)`})},_=(y,k)=>{r||(o[y]=v(k,
0,e),i=!0,l[y].setAttribute("aria-valuenow",o[y].toPrecision(3)),l[y].setAttribute("aria-valuetext",`${o[y].toPrecision(2)} ${t}`),f(),s())},g=null,b=y=>{let k=m(),
[M,O]=[y.clientX-k.left,y.clientY-k.top].map(Mt=>Mt/u.px),G=v((M-gt)/(u.width-gt-us),0,1),H=Math.round(G*(ve-1)),Xt=e*(1-(O-$t)/(u.height-$t-lo)),R=g??H,Rt=o[R];
for(let Mt=Math.min(R,H);Mt<=Math.max(R,H);Mt++)_(Mt,R===H?Xt:Rt+(Xt-Rt)*(Mt-R)/(H-R));g=H};h.addEventListener("pointerdown",y=>{y.preventDefault(),g=null,b(y),
X(h,y,b)});for(let[y,k]of l.entries())k.setAttribute("aria-valuenow",o[y].toPrecision(3));return requestAnimationFrame(f),{element:h,redraw:f,made:()=>i,judge:y=>{
r=y,f();let k=(y.length-1)/(ve-1);return pc(o,o.map((M,O)=>y[Math.round(O*k)]))}}}var ds=2*Math.PI,Q=(n,t)=>n.events.find(e=>e.kind===t),ps=n=>q(n-ds*Math.floor(n/ds));function fc(n,t,e=72){let{angle:s}=n.columns,o=n.columns[t],i=[],r=0;for(let a=0;a<=
e;a++){let l=n.columns.angle[0]+ds*a/e;for(;r+1<n.length&&s[r+1]<l;)r+=1;let h=Math.min(r+1,n.length-1),m=s[h]>s[r]?Math.min((l-s[r])/(s[h]-s[r]),1):0;i.push(o[r]+
m*(o[h]-o[r]))}return i}var gc=(n,t)=>n.t[n.columns.angle.findIndex(e=>e>=t)]??n.duration,_c={R:"roll",S:"spin",K:"skid",H:"bounce"},jt=[{key:"littlewood",title:"\
visit.littlewoods_question",text:"visit.a_hoop_without_mass",question:"visit.what_do_you_think",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:n=>ke(
[["roll","visit.it_rolls_on"],["hop","visit.it_hops_the_hoop"],["skim","visit.the_weight_falls_freely"]],n),until:([n])=>{let[t,e]=[Q(n,"skim"),Q(n,"impact")];return t?
t.t+.7*((e?.t??n.duration)-t.t):n.duration},answer:([n])=>{let t=Q(n,"skim")??Q(n,"takeoff");return{truth:t?.kind==="skim"?"skim":t?"hop":"roll",text:"visit.at_\
angle_there_is",values:{angle:ps(t?.angle??0)}}},why:"visit.littlewood_said_that_the"},{key:"speed",title:"visit.a_ring_with_mass",text:"visit.now_a_quarter_of",
question:"visit.draw_how_fast_the",queries:["start.speed=0.1&duration=8"],guess:n=>kr({label:"visit.speed_of_the_centre",unit:"m/s",most:10},n),until:([n])=>gc(
n,ds),answer:([n])=>{let t=fc(n,"vx");return{truth:t,text:"visit.with_the_load_at",values:{speed:x(Math.max(...t),2)}}},why:"visit.the_lowest_point_of"},{key:"s\
lip",title:"visit.why_it_slips",text:"visit.a_harder_push_2",question:"visit.where_is_the_load",queries:["start.speed=2.8"],guess:n=>co("visit.angle_of_the_load",
n),until:([n])=>Q(n,"slip_start")?.t??n.duration,answer:([n])=>{let t=Q(n,"slip_start"),e=n.at(t.t).normal_force/(n.mass*n.gravity);return{truth:t.angle*180/Math.
PI,text:"visit.it_begins_to_slip",values:{angle:ps(t.angle),share:`${x(100*e,2)} %`}}},why:"visit.the_load_on_its"},{key:"hop",title:"visit.the_hop",text:"visit\
.a_little_faster_3",question:"visit.where_is_the_load_when",queries:[""],guess:n=>co("visit.angle_of_the_load_where",n),until:([n])=>Q(n,"takeoff")?.t??n.duration,
answer:([n])=>{let t=Q(n,"takeoff"),e=n.at(t.t-1e-6);return{truth:t.angle*180/Math.PI,text:"visit.it_takes_off_at",values:{angle:ps(t.angle),slip:x(Math.abs(e.slip),
3)}}},why:"visit.a_rolling_hoop_would"},{key:"landing",title:"visit.the_landing",text:"visit.the_hoop_is_in",question:"visit.what_does_it_do",queries:[""],guess:n=>ke(
[["roll","visit.it_rolls_at_once"],["skid","visit.it_skids_the_rim"],["spin","visit.it_spins_the_rim"],["bounce","visit.it_bounces"]],n),until:([n])=>Q(n,"impac\
t")?.t??n.duration,answer:([n])=>{let[t,e]=[Q(n,"takeoff"),Q(n,"impact")],s=n.events.find(o=>o.kind==="apex");return{truth:_c[n.at((e?.t??0)+1e-6).mode],text:"v\
isit.it_was_in_the",values:{time:x((e?.t??0)-(t?.t??0),3),height:x(100*(s?.height??0),3),angle:ps(e?.angle??0)}}},why:"visit.an_impact_takes_no"},{key:"friction",
title:"visit.more_friction_more_hop",text:"visit.three_hoops_get_the",question:"visit.which_of_them_hops",queries:["plane.mu=0.05","plane.mu=0.2",""],guess:n=>ke(
[["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],n),until:n=>.3+Math.max(0,...n.map(t=>Q(t,"impact")?.t??0)),answer:n=>{let t=n.map(i=>Math.max(0,...i.events.
map(({kind:r,height:a})=>r==="apex"?a:0))),[e,s,o]=t.map(i=>x(100*i,3));return{truth:String(t.indexOf(Math.max(...t))),text:"visit.they_rise_by_low",values:{low:e,
middle:s,high:o}}},why:"visit.on_ice_nothing_drives"},{key:"undecided",title:"visit.what_rigid_bodies_cannot",text:"visit.a_hoop_is_thrown",question:"visit.what\
_do_they_say",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plane.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start\
.omega=5&duration=3"],guess:n=>ke([["flight","visit.it_flies_off"],["impact","visit.an_impact_stops_the"],["both","visit.both_agree_with_the"]],n),until:n=>Math.
min(.8,...n.map(t=>t.duration)),answer:n=>({truth:n.every(t=>Q(t,"painleve_indeterminate"))?"both":"flight",text:"visit.hoop_a_and_hoop"}),why:"visit.painleve_f\
ound_this_in"},{key:"yours",title:"visit.your_turn",text:"visit.take_the_hoop_turn",question:"",queries:[""]}];var Mr="hophoop-visit",fs=class{constructor(t,e){this.lab=t;this.step=null;this.guess=null;this.films=[];this.points=new Map;this.running=!1;this.stop=null;this.
loop=null;this.asked=0;this.onchallenges=e,this.body=c("div",{class:"visit-body"}),this.said=c("div",{class:"visit-answer",role:"status"}),this.element=c("secti\
on",{class:"visit card","aria-label":"menu.guided_visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){st(Mr)||
(this.element.hidden=!1,E(this.said,""),this.body.replaceChildren(c("div",{class:"buttons offer"},c("p",{},c("b",{},"visit.new_here")," ","visit.eight_short_que\
stions_guess"),c("button",{type:"button",class:"main",onclick:()=>this.start()},"teach.start_the_visit"),c("button",{type:"button",onclick:()=>this.leave()},"vi\
sit.not_now"))))}start(){this.points.clear(),this.go(0)}leave(){nt(Mr,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),
this.lab.mark("visiting",!1),this.veil(),this.lab.show()}async go(t){let e=jt[t],s=++this.asked;this.lab.opening.end();let{lab:o}=this;o.clock.play(!1),o.clock.
time=0,this.step=e,this.stop=null,this.guess=null,this.unwind(),E(this.said,""),this.element.hidden=!1,o.mark("visiting",t<jt.length-1);try{let i=await Promise.
all(e.queries.map(r=>o.backend.film({query:r})));if(s!==this.asked)return;this.films=i.map(r=>new It(r)),o.motions.active=0,o.motions.set(i.slice(0,2)),this.guess=
e.guess?.(()=>this.guessed())??null,this.veil(),o.changed(),o.motions.note(),this.fill(t)}catch(i){o.notice.fail(i)}}veil(){this.lab.mark("guessing",this.guessing),
this.guessing&&dt(this.lab.stage.element,"aria-label","visit.the_hoop_before_it")}fill(t){let e=jt[t];this.play=c("button",{type:"button",class:"main",disabled:!!this.
guess,onclick:()=>this.show()},"visit.play"),this.running=!1,this.wait=c("span",{class:"hint visit-wait"},"visit.first_say_what_you"),this.skip=c("button",{type:"\
button",hidden:!0,onclick:()=>this.stop!==null&&this.lab.clock.seek(this.stop)},"visit.skip_to_the_answer");let s=t===jt.length-1,o=c("h2",{tabindex:"-1"},e.title);
this.next=c("button",{type:"button",onclick:()=>this.go(t+1)},"visit.next"),this.body.replaceChildren(c("header",{},c("span",{class:"visit-count"},{key:"visit.s\
tep_number_of_all",values:{number:t+1,all:jt.length}}),c("progress",{max:String(jt.length),value:String(t+1),"aria-hidden":"true"}),c("button",{type:"button",class:"\
quiet","aria-label":"visit.leave_the_visit",onclick:()=>this.leave()},"×")),o,c("p",{},e.text),e.question?c("p",{class:"visit-question"},e.question):"",this.guess?.
element??"",c("div",{class:"buttons"},t>0&&c("button",{type:"button",onclick:()=>this.go(t-1)},"visit.back"),this.guess&&this.play,this.guess&&this.skip,s?c("bu\
tton",{type:"button",class:"main",onclick:()=>this.challenge()},"menu.challenges"):this.next,s&&c("button",{type:"button",onclick:()=>this.leave()},"visit.done"),
this.guess&&this.wait)),s&&this.points.size&&this.total(),o.focus({preventScroll:!0})}guessed(){this.play&&(this.play.disabled=!1),this.wait.hidden=!0}show(){let{
lab:t,step:e}=this;if(!(!e||!this.guess)){if(this.stop!==null){t.clock.play();return}this.stop=e.until?.(t.films())??t.clock.duration,this.loop??=t.clock.loop,t.
clock.loop=!1,t.clock.seek(0),t.clock.run({to:this.stop}),this.frame()}}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:t}=this.
lab;if(this.stop===null||(this.skip.hidden=!1,this.running!==t.playing&&(this.running=t.playing,E(this.play,this.running?"visit.pause":"visit.play")),t.time<this.
stop-1e-9))return;t.playing=!1;let e=this.stop;this.stop=null,this.unwind(),t.seek(e),this.judge()}judge(){let{step:t,guess:e}=this;if(!t?.answer||!e)return;let{
truth:s,text:o,values:i={}}=t.answer(this.films),r=e.judge(s);this.points.set(t.key,r),this.play.hidden=this.skip.hidden=!0,this.said.replaceChildren(c("p",{},c(
"b",{},r?{key:"visit.points_of_100_points",values:{points:r}}:"visit.not_so")," ",{key:o,values:i}),c("p",{},t.why??"")),this.veil(),this.next.classList.add("ma\
in"),this.lab.show(),this.said.scrollIntoView({block:"nearest"})}total(){let t=[...this.points.values()].reduce((e,s)=>e+s,0);this.said.replaceChildren(c("p",{},
{key:"visit.you_have_sum_of",values:{sum:t,most:100*this.points.size}}))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&
this.veil()}};var Sr=60,gs=class{constructor(t){this.lab=t;this.sound=new cs;let e=()=>t.film(),s=i=>t.load(i);this.grips=new os(t),this.present=new hs(t.root,()=>t.show()),this.
challenges=new ts({film:e,load:s,ahead:()=>t.stage.options.ahead}),this.visit=new fs(t,()=>this.challenges.open()),this.table=new ms({film:e,clock:t.clock,names:()=>t.
theme.colors.mode_names}),this.more=new ls(t),this.teach=vr(s,()=>this.visit.start()),this.tools=this.makeTools(),this.menu=this.makeMenu();let o=()=>{this.spoken(),
zn(t.root),t.show()};this.languages=Qn(o,i=>t.notice.fail(i)),this.spoken()}makeTools(){let{clock:t}=this.lab,e=(s,o,i)=>c("button",{type:"button",title:o,"aria\
-label":o,"aria-pressed":"false",onclick:i},W(s));return this.loop=e("loop","menu.repeat",()=>{t.loop=!t.loop,this.mark()}),this.slow=e("slow","menu.slow_motion\
_a_tenth",()=>{t.speed=t.speed===.1?1:.1,t.changed(),this.mark()}),this.loud=e("sound","menu.sound_of_the_contact",()=>{this.sound.turn(!this.sound.on),this.mark()}),
this.large=e("large","menu.presentation_on_the_whole",()=>this.present.turn()),this.present.onchange=()=>this.mark(),this.mark(),c("div",{class:"buttons tools"},
this.loop,this.slow,this.loud,this.large)}mark(){let{clock:t}=this.lab;this.loop.setAttribute("aria-pressed",String(t.loop)),this.slow.setAttribute("aria-presse\
d",String(t.speed===.1)),this.loud.setAttribute("aria-pressed",String(this.sound.on)),this.large.setAttribute("aria-pressed",String(this.present.on))}makeMenu(){
let t=(s,o)=>c("button",{type:"button",onclick:()=>{e.open=!1,o()}},s),e=c("details",{class:"learn"},c("summary",{class:"button"},"menu.learn"),c("div",{class:"\
menu-body"},t("menu.guided_visit",()=>this.visit.start()),t("menu.challenges",()=>this.challenges.open()),t("sensitivity.what_a_little_more_would",()=>this.more.
turn(!0)),t("table.table_of_the_motion",()=>this.table.open(!0)),t("menu.presentation",()=>this.present.turn(!0)),t("menu.for_teachers",()=>this.teach.showModal()),
t("menu.about_hophoop",()=>this.lab.about.showModal())));return e.addEventListener("keydown",s=>{s.key!=="Escape"||!e.open||(s.stopPropagation(),e.open=!1,e.querySelector(
"summary")?.focus())}),e}spoken(){this.lab.root.lang=Tt(),this.lab.hosted&&(document.documentElement.lang=Tt(),this.titled())}titled(){let{lab:t}=this;if(!t.hosted)
return;let e=this.visit.guessing?[]:t.motions.films().map(o=>this.nameOf(o)),s=[...new Set(e)].join(" | ");document.title=s?`${s} – hophoop`:T("menu.hophoop_l\
ab_play_with")}nameOf({query:t,summary:e}){let s=this.lab.known.find(i=>i.query===t);if(s)return T(s.title);let[o]=I(e).split(/(?<=[.。])(?!\d)/u);return o.length<=
Sr?o.replace(/[.。]$/u,""):`${o.slice(0,Sr).replace(/[,，][^,，]*$/u,"")} …`}frame(){let{lab:t}=this;this.grips.draw(),this.sound.follow(t.film(),t.clock),
this.table.cursor(t.clock.time),this.more.frame(),this.visit.frame(),this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.more.changed(),
this.challenges.changed(),this.visit.changed(),this.titled()}close(){this.sound.close(),this.present.close()}};var Me=(n,t,e)=>c("button",{type:"button",title:t,"aria-label":t,onclick:e},n),_s=class{constructor(t,e,s,o){this.fresh=!1;let i=new Map;for(let a of t)i.set(a.
group,[...i.get(a.group)??[],a]);this.presets=c("select",{class:"presets","aria-label":"header.examples",onchange:()=>{let a=t.find(({key:l})=>l===this.presets.
value);this.fresh=a!==void 0,a&&o.take(a)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},c("option",{value:""},"header.examples_2"),[...i].map(([
a,l])=>c("optgroup",{label:a},l.map(({key:h,title:m})=>c("option",{value:h},m))))),this.undo=Me(W("undo"),"header.undo_z",o.undo),this.redo=Me(W("redo"),"header\
.redo_y",o.redo);let r=c("span",{},c("span",{class:"long"},"header.compare"),c("span",{class:"short"},W("two")));this.compare=Me(r,"header.compare_two_hoops",o.
compare),this.compare.classList.add("full"),this.right=c("div",{class:"buttons right"},e,Me(W("theme"),"header.dark_or_light_d",o.theme),Me("?","header.keys_and\
_help",o.help)),this.element=c("header",{class:"top"},c("h1",{},c("span",{class:"logo","aria-hidden":"true"}),c("span",{},"hophoop",c("span",{class:"long"}," ",
"header.lab"))),this.presets,c("div",{class:"buttons"},this.undo,this.redo,this.compare,s),this.right)}show(t,e){this.undo.disabled=!t.past.length,this.redo.disabled=
!t.future.length,this.compare.setAttribute("aria-pressed",String(e))}};var bc=["pointerdown","wheel"],bs=class{constructor(t,e){this.clock=t;this.hint=e;this.touches=new AbortController}begin(t){let{signal:e}=this.touches,s=()=>this.
end();for(let o of bc)t.addEventListener(o,s,{signal:e,capture:!0,passive:!0});addEventListener("keydown",s,{signal:e,capture:!0}),this.hint.hidden=!1,this.clock.
run({once:!0})}end(){this.hint.hidden=!0,this.touches.abort()}};var Tr="hophoop-view",yc=new Set(["start.speed","hoop.load_fraction","plane.mu","duration"]),Er=({query:n})=>[...new URLSearchParams(n).keys()].some(t=>!yc.has(
t)),ys=class{constructor(t,e,s){this.root=t;this.hosted=e;this.changed=s;this.simple=!1;this.button=c("button",{type:"button",class:"view",hidden:!e,onclick:()=>this.
choose()}),this.more=c("p",{class:"hint beyond",hidden:!0},"shell.this_motion_has_other"," ",c("button",{type:"button",class:"link",onclick:()=>this.choose()},"\
shell.show_everything"))}get everything(){return st(Tr)==="everything"}open(t,{map:e,more:s,fingerprints:o}){let i=t.length>1||e||s||o?.some(Boolean)||t.some(Er);
this.turn(this.hosted&&!this.everything&&!i)}choose(){this.turn(!this.simple),nt(Tr,this.simple?"simple":"everything"),this.changed(),this.button.focus({preventScroll:!0})}turn(t){
this.simple=t,this.root.classList.toggle("simple",t),E(this.button,t?"shell.everything":"shell.simple_view");for(let e of this.root.querySelectorAll("details.gr\
oup"))t?(e.dataset.open=String(e.open),e.open=!0):e.dataset.open&&(e.open=e.dataset.open==="true")}show(t){this.more.hidden=!this.simple||!t.some(Er)}};var ws=class{constructor(t){this.tabs=["hoops.hoop_a","hoops.hoop_b"].map((e,s)=>c("button",{type:"button","aria-pressed":"false",onclick:()=>t(s)},e)),this.bar=
c("div",{class:"tabs",role:"group","aria-label":"hoops.which_hoop_the_controls",hidden:!0},this.tabs),this.text=c("p",{class:"preset-text"}),this.element=c("div",
{class:"lanes"},this.bar,this.text)}show(t,e){this.bar.hidden=t<2;for(let[s,o]of this.tabs.entries())o.setAttribute("aria-pressed",String(s===e))}};var Ar="hophoop-single-keys",wc=(n,t)=>({" ":()=>n.clock.play(),ArrowLeft:()=>t?n.transport.jump(-1):n.transport.nudge(-1),ArrowRight:()=>t?n.transport.jump(1):
n.transport.nudge(1),Home:()=>n.clock.seek(0),End:()=>n.clock.seek(n.clock.duration),h:()=>n.transport.jump(1,"takeoff"),l:()=>n.transport.jump(1,"impact"),"[":()=>n.
clock.faster(-1),"]":()=>n.clock.faster(1),t:()=>n.toggle("traces"),f:()=>n.toggle("forces"),c:()=>n.toggle("speed"),a:()=>n.extras.more.turn(),w:()=>n.toggle("\
whole"),3:()=>n.toggle("three"),"+":()=>n.stage.zoom(1.25),"=":()=>n.stage.zoom(1.25),"-":()=>n.stage.zoom(.8),0:()=>n.stage.zoom(0),z:()=>n.travel(-1),y:()=>n.
travel(1),d:()=>n.theme.toggle(),p:()=>n.share.code(),"?":()=>n.help.showModal()});function vc(n,t){let e=t.key.toLowerCase();t.altKey||!(e==="z"||e==="y")||(t.
preventDefault(),n.travel(e==="y"||t.shiftKey?1:-1))}function xc(n){let t=n.share.menu;t.open&&(t.open=!1,t.querySelector("summary")?.focus())}var vs=class{constructor(t){
this.on=!t||st(Ar)!=="off";let e=c("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=e.checked,t&&nt(Ar,this.on?"on":"off")}});this.element=c("labe\
l",{class:"check"},e,"keys.single_keys_letters_digits")}};function kc(n,t){let e=t.target;if(n.root.querySelector("dialog[open]"))return;if(t.key==="Escape"){xc(
n);return}if(e.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(t.ctrlKey||t.metaKey){vc(n,t);return}if(t.altKey||e.matches?.("select")&&
!(t.key===" "&&n.header.fresh)||e.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(t.key)||t.key===" "&&e.matches?.("button, summary, input[type=ch\
eckbox]")||!n.singleKeys.on&&t.key!==" "&&t.key.length===1)return;let o=wc(n,t.shiftKey)[t.key];o&&(t.preventDefault(),o())}function Lr(n,t){let e=t?document:n.
root,s=o=>{kc(n,o),t||o.stopPropagation()};return e.addEventListener("keydown",s),()=>e.removeEventListener("keydown",s)}function Pr(n,t){let e=c("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([o])=>{let i=!o.isIntersecting&&o.boundingClientRect.top<0;if(i===
n.classList.contains("stuck"))return;let r=n.offsetHeight;n.style.marginBottom="",n.classList.toggle("stuck",i),i&&(n.style.marginBottom=`${r-n.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=i?`${n.offsetHeight}px`:"",t()});return s.observe(e),{edge:e,close:()=>s.disconnect()}}function Cr(n,t){n.classList.add("hophoop"),n.dir="ltr",!t&&(n.classList.add("embedded"),n.dataset.lmSuppressShortcuts="true",n.dataset.pSuppressShortcuts="true")}
function Rr(n,t){let{root:e,notice:s,hosted:o,extras:i,transport:r,header:a}=n,l=_=>!t||t.includes(_),h=[i.visit.element,i.challenges.element],m=c("aside",{class:"\
side","aria-label":"page.parameters"},...h,n.hoops.element,s.message,n.controls.element,n.view.more);r.row.append(i.more.switch),r.row.before(i.tools),a.right.prepend(
i.menu,i.languages);let u=c("div",{class:"player"},i.grips.element,n.stage.element,n.timeline.element,r.element),p=o?Pr(u,()=>n.request()):null,d=c("div",{class:"\
middle"},p?.edge,!l("controls")&&h,u,i.more.element,i.table.element,c("div",{class:"words"},n.story.element,l("theory")&&n.theory.element),l("map")&&n.map.element),
f=c("div",{class:"why"},l("plots")&&n.plots.element,l("plots")&&n.phase.element);return e.replaceChildren(c("div",{class:"page"},o&&Mc(n.timeline.element),a.element,
c("div",{class:"columns"},l("controls")&&m,d,f)),s.toast,n.share.dialog,n.help,n.about,i.teach),e.addEventListener("pointerdown",({target:_})=>{for(let g of[n.share.
menu,i.menu])g.contains(_)||(g.open=!1)}),e.classList.toggle("no-controls",!l("controls")),{player:u,sticky:p}}function Mc(n){n.id="hh-player";let t=c("a",{class:"\
skip button",href:"#hh-player"},"page.skip_to_the_player");return t.onclick=e=>{e.preventDefault(),n.focus()},t}var Se=({font:n})=>`11px ${n}`;function Kt(n,t,{left:e,top:s,box:o},{across:i,up:r,lines:a=!1,middle:l=!1}){let h=s+o.height,m=e+o.width;n.save(),n.font=Se(t),n.
strokeStyle=a?t.line:t.soft,n.fillStyle=t.soft,n.lineWidth=1,a||n.strokeRect(e+.5,s+.5,o.width-1,o.height-1),n.textAlign="right",n.textBaseline="middle";for(let{
at:u,text:p,strong:d}of r.marks)a&&(n.globalAlpha=d?1:.55,Or(n,[e,Math.round(u)+.5],[m,Math.round(u)+.5]),n.globalAlpha=1),n.fillText(p,e-6,u);n.textBaseline="a\
lphabetic",n.textAlign="center";for(let{at:u,text:p}of i.marks)Or(n,[u,h],[u,h+4]),n.fillText(p,u,h+15);l?n.fillText(i.name,e+.5*o.width,h+30):(n.textAlign="rig\
ht",n.fillText(i.name,m,h+27)),n.translate(11,s+.5*o.height),n.rotate(-Math.PI/2),n.textAlign="center",n.fillText(r.name,0,0),n.restore()}function Or(n,t,e){n.beginPath(),
n.moveTo(...t),n.lineTo(...e),n.stroke()}var Nr=(n,t)=>t?`${T(n)} [${t}]`:T(n);var mo=62,Sc=20,Tc=10,Hr=40,Fr=12,Te=10,Ec=36,Ir=Math.PI/180,bt=["x","y"],xs=class{constructor(t){this.paths={x:"start.speed",y:"plane.mu"};this.known=new Map(t.
map(e=>[e.path,e])),this.windows={x:this.whole("x"),y:this.whole("y")},this.left=mo}info(t){return this.known.get(this.paths[t])}whole(t){return[...this.info(t).
range]}home(){for(let t of bt)this.windows[t]=this.whole(t)}choose(t,e){let s=t==="x"?"y":"x";this.paths[s]===e&&(this.paths[s]=this.paths[t]),this.paths[t]=e,this.
home()}asked(t,e){let[s,o]=this.windows[t];return{path:this.paths[t],from:s,to:o,cells:e}}bounds(t){let{range:e,allowed:s}=this.info(t),o=2*(e[1]-e[0]);return[Math.
max(s[0],e[0]-o),Math.min(s[1],e[1]+o)]}zoom(t,e){let s={x:[],y:[]};for(let o of bt){let[i,r]=this.windows[o],a=e?.[o]??.5*(i+r);s[o]=qt([a-(a-i)*t,a+(r-a)*t],this.
bounds(o));let l=Math.max(Math.abs(s[o][0]),Math.abs(s[o][1]),1e-9);if(s[o][1]-s[o][0]<400*Number.EPSILON*l)return!1}return bt.every(o=>s[o].every((i,r)=>i===this.
windows[o][r]))?!1:(this.windows=s,!0)}drag(t,e,s){let o=(i,r)=>qt(t[i].map(a=>a+r*(t[i][1]-t[i][0])),this.bounds(i));this.windows={x:o("x",-e/this.box.width),y:o(
"y",s/this.box.height)}}restore(t){if(!bt.every(e=>this.known.has(t[e][0]))||t.x[0]===t.y[0])return!1;for(let e of bt)this.paths[e]=t[e][0];for(let e of bt)this.
windows[e]=qt(t[e].slice(1).map(Number),this.bounds(e));return!0}isHome(){return bt.every(t=>this.windows[t].every((e,s)=>e===this.whole(t)[s]))}middle(){let{x:t,
y:e}=this.windows;return{x:.5*(t[0]+t[1]),y:.5*(e[0]+e[1])}}fit(t,e,s=()=>0){this.box={width:t-mo-Fr,height:e-Te-Ec};let o=this.axis("y",this.box.height/Hr).marks.
map(({text:i})=>s(i));this.left=Math.max(mo,Math.ceil(Sc+Tc+Math.max(0,...o))),this.box.width=t-this.left-Fr}clip(t){t.beginPath(),t.rect(this.left,Te,this.box.
width,this.box.height),t.clip()}x(t){let[e,s]=this.windows.x;return this.left+(t-e)/(s-e)*this.box.width}y(t){let[e,s]=this.windows.y;return Te+(1-(t-e)/(s-e))*
this.box.height}place(t,e){let s=([o,i],r)=>o+v(r,0,1)*(i-o);return{x:s(this.windows.x,(t-this.left)/this.box.width),y:s(this.windows.y,1-(e-Te)/this.box.height)}}deep(t){
let[e,s]=this.windows[t];return s-e<5e-5*Math.max(Math.abs(e),Math.abs(s))}said(t){let e=s=>{let o=this.info(s),[i,r]=this.windows[s],a=Math.max(Math.abs(i),Math.
abs(r)),l=v(Math.ceil(Math.log10(a/(r-i)))+4,4,16);return`${T(o.label)} = ${N(x(o.degrees?t[s]/Ir:t[s],l),o.unit)}`};return`${e("x")}, ${e("y")}`}draw(t,e){let{
left:s,box:o}=this,[i,r]=[this.axis("x",o.width/80),this.axis("y",o.height/Hr)];Kt(t,e,{left:s,top:Te,box:o},{across:i,up:r,middle:!0})}axis(t,e){let s=this.info(
t),o=s.degrees?1/Ir:1,[i,r]=this.windows[t].map(p=>p*o),a=z(r-i,e),l=this.deep(t),h=l?Number((.5*(i+r)).toPrecision(12)):0,m=l?at(i-h,r-h,e).map(p=>p+h):at(i,r,
e),u=l?` − ${String(h).replace("-","−")}`:"";return{marks:m.map(p=>({at:this[t](p/o),text:l?x(p-h,3):it(p,a)})),name:`${T(s.label)}${u}${s.unit?` [${s.unit}\
]`:""}`}}};function qt([n,t],[e,s]){let o=Math.min(t-n,s-e);return n<e?[e,e+o]:t>s?[s-o,s]:[n,t]}function uo(n,t,e,s,o){for(let[i,r]of[[o,4],[s,1.8]])n.strokeStyle=
i,n.lineWidth=r,n.beginPath(),n.arc(t,e,7,0,2*Math.PI),n.moveTo(t-13,e),n.lineTo(t-4,e),n.moveTo(t+4,e),n.lineTo(t+13,e),n.moveTo(t,e-13),n.lineTo(t,e-4),n.moveTo(
t,e+4),n.lineTo(t,e+13),n.stroke()}var ks=()=>matchMedia("(hover: none)").matches,Ac=.0018,$r=200,[Lc,Pc]=[1/.6,1/1.7];function yt(n,{zoom:t,home:e,chosen:s=()=>n,keys:o=!1}){return n.addEventListener(
"wheel",i=>{(i.ctrlKey||i.metaKey||ge(s()))&&(i.preventDefault(),t(Math.exp(-Math.min(Math.max(i.deltaY,-$r),$r)*Ac),i))},{passive:!1}),n.addEventListener("dblc\
lick",e),o&&n.addEventListener("keydown",i=>{if(i.key==="+"||i.key==="=")t(Lc);else if(i.key==="-")t(Pc);else if(i.key==="0")e();else if(i.key==="Escape")n.blur();else
return;i.preventDefault(),i.stopPropagation()}),Xi(n,t)}var jr={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},qr=48;function Dr(n){let{body:t}=n,e=!1,s=yt(t,{zoom:(o,i)=>n.axes.box&&n.zoom(1/o,i?po(
n,i):n.aim()),home:()=>n.home(),keys:!0});t.addEventListener("pointerdown",o=>Rc(n,o,s,i=>e=i)),t.addEventListener("pointermove",o=>{n.axes.box&&!e&&o.pointerType!==
"touch"&&Cc(n,o)}),t.addEventListener("pointerleave",()=>n.tip.hidden=!0),t.addEventListener("keydown",o=>Oc(n,o))}function po(n,t){let e=n.body.getBoundingClientRect(),
{px:s}=n.look;return n.axes.place((t.clientX-e.left)/s,(t.clientY-e.top)/s)}function Cc(n,t){n.tip.textContent=n.said(po(n,t)),n.tip.hidden=!1;let e=n.body.getBoundingClientRect();
n.tip.style.left=`${v(t.clientX-e.left,150,Math.max(e.width-150,150))}px`,n.tip.style.bottom=`${e.bottom-t.clientY+16}px`}function Rc(n,t,e,s){t.preventDefault(),
n.body.focus({preventScroll:!0});let o=[t.clientX,t.clientY],i={x:[...n.axes.windows.x],y:[...n.axes.windows.y]};n.pointed=po(n,t);let r=!1,a=!1,l=e(),h=m=>{if(l||=
e(),l)return;let[u,p]=[m.clientX-o[0],m.clientY-o[1]];a||Math.hypot(u,p)<5&&!r||(a=!r&&t.pointerType==="touch"&&Math.abs(p)>=Math.abs(u),!a&&(r=!0,s(!0),n.tip.hidden=
!0,n.axes.drag(i,u/n.look.px,p/n.look.px),n.redraw(),n.soon()))};X(n.body,t,h,(m,u)=>{u&&!r&&!a&&!l&&n.pointed&&n.take(n.pointed),s(!1)})}function Oc(n,t){let e=n.
pointed??n.here()??n.axes.middle();if(n.pointed=e,jr[t.key]){let[s,o]=jr[t.key],{x:i,y:r}=n.axes.windows;n.pointed={x:v(e.x+s*(i[1]-i[0])/qr,i[0],i[1]),y:v(e.y+
o*(r[1]-r[0])/qr,r[0],r[1])},n.state.textContent=n.said(n.pointed),n.say(n.said(n.pointed))}else if(t.key==="Enter")n.take(e);else return;t.preventDefault(),t.stopPropagation(),
n.redraw()}var Nc=["start.height","start.vx","start.vy","start.omega"];function Br(n,t){let e="speed"in n.start;return!e&&t.includes("start.speed")?"map.of_rolling_starts_\
though":e&&t.some(s=>Nc.includes(s))?"map.of_starts_in_any":""}var Hc=Math.PI/180,Fc=12,Ic=["hop_height","flight_time","energy_lost","greatest_utilization"];function zr(n){return n.unit==="rad"?[1/Hc,"°"]:[1,n.unit==="1"?"":
n.unit]}function $c({classes:n,what:t},e){let[s,o]=[1/0,-1/0];if(n)return[s,o];for(let i of e)i<s&&(s=i),i>o&&(o=i);return[Ic.includes(t)?Math.min(s,0):s,o]}function Wr(n){
let{values:t}=n.arrays,e=n.header,{x:s,y:o,classes:i}=e,r=new ImageData(s.cells,o.cells),[a,l]=$c(e,t),h=i?.map(({color:u})=>xt(u));for(let u=0;u<o.cells;u++)for(let p=0;p<
s.cells;p++){let d=t[u*s.cells+p],f=4*((o.cells-1-u)*s.cells+p);if(!Number.isFinite(d))continue;let _=h&&(p+1<s.cells&&t[u*s.cells+p+1]!==d||u+1<o.cells&&t[(u+1)*
s.cells+p]!==d),g=h?h[d].map(b=>_?.72*b:b):Ue[v(Math.round(255*(d-a)/(l-a||1)),0,255)];r.data.set([...g,255],f)}let m=c("canvas",{width:s.cells,height:o.cells});
return ft(m).putImageData(r,0,0),{picture:m,header:e,values:t,x:[s.from,s.to],y:[o.from,o.to],low:a,high:l}}function Gr(n,t){let e=(o,i)=>o[0]>=i[0]-1e-300&&o[1]<=
i[1]+1e-300;return[...n.filter(o=>!(e(o.x,t.x)&&e(o.y,t.y))),t].slice(-Fc)}function Ur({header:n,low:t,high:e,values:s}){let{classes:o}=n;if(!o){let a=c("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=ft(a);for(let u=0;u<120;u++)l.fillStyle=`rgb(${Ue[Math.floor(255*u/119)].join(",")})`,l.fillRect(u,0,1,
10);let[h,m]=zr(n);return[c("span",{},n.label,": ",e>=t?x(t*h,3):"map.none"," "),a,c("span",{},e>=t?N(x(e*h,3),m):""),s.some(u=>!Number.isFinite(u))?c("span",{},
c("i",{class:"blank"}),"map.none"):""]}let i=new Map;for(let a of s)i.set(a,(i.get(a)??0)+1);let r=[...i].filter(([a])=>a>=0).sort((a,l)=>l[1]-a[1]);return[...r.
slice(0,10).map(([a])=>{let{color:l,text:h}=o[a];return c("span",{},c("i",{style:`background:${l}`,"aria-hidden":"true"}),h)}),r.length>10?c("span",{},{key:"map\
.and_count_more",values:{count:r.length-10}}):"",o.some(({name:a})=>n.what==="sequence"&&/[SK]/.test(a))?c("span",{class:"hint"},"map.spin_and_skid"):""]}function Kr(n,t){
for(let{header:e,values:s}of[...n].reverse()){let{x:o,y:i,classes:r}=e,a=Math.floor((t.x-o.from)/(o.to-o.from)*o.cells),l=Math.floor((t.y-i.from)/(i.to-i.from)*
i.cells);if(a<0||l<0||a>=o.cells||l>=i.cells)continue;let h=s[l*o.cells+a];if(r)return I(r[h]?.text??"map.not_allowed");let[m,u]=zr(e);return Number.isFinite(h)?
N(x(h*m,4),u):T("map.none")}return"…"}var Vr=[[24,16],[72,48],[216,144]],Ms=class{constructor(t,e,{take:s,say:o,changed:i}){this.backend=t;this.pointed=null;this.what="sequence";this.layers=[];this.
seen=!1;this.onmotion=s,this.say=o,this.changed=i;let r=e.controls.map_axes;this.axes=new xs(r),this.canvas=c("canvas",{class:"plot-canvas"}),this.tip=c("div",{
class:"tip",hidden:!0}),this.body=c("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"map.map_of_motions_arrow"},this.canvas,this.tip),this.
keys=c("div",{class:"map-keys"}),this.state=c("span",{class:"hint"});let a=l=>{let h=c("select",{"data-axis":l,onchange:()=>this.setAxis(l,h.value)},r.map(({path:m,
label:u})=>c("option",{value:m},u)));return h};this.selects={x:a("x"),y:a("y")},this.quantity=c("select",{"aria-label":"map.what_the_map_shows",onchange:()=>{this.
what=this.quantity.value,this.refresh()}},e.map_quantities.map(([l,h])=>c("option",{value:l},h))),this.element=c("section",{class:"map","aria-label":"map.map_of\
_motions"},c("div",{class:"map-head"},c("h2",{},"map.map"),c("label",{},"map.of",this.quantity),c("label",{},"map.across",this.selects.x),c("label",{},"map.up",
this.selects.y),c("span",{class:"buttons"},c("button",{type:"button","aria-label":"map.zoom_into_the_map",onclick:()=>this.zoom(.5,this.aim())},"+"),c("button",
{type:"button","aria-label":"map.zoom_out_of_the",onclick:()=>this.zoom(2,this.aim())},"−"),c("button",{type:"button",onclick:()=>this.home()},"map.whole_map")),
this.state),this.body,this.keys,c("p",{class:"hint"},ks()?"map.click_to_take_that":"map.click_to_take_that_motion")),Dr(this),this.soon=ot(()=>this.refresh(),140),
this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){
this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let t of bt)this.selects[t].value=this.axes.paths[t]}setAxis(t,e){this.axes.choose(t,e),this.syncSelects(),
this.refresh()}home(){this.axes.home(),this.refresh()}key_of(t){let e=structuredClone(t);for(let s of Object.values(this.axes.paths)){let[o,i]=s.split(".");e[o]&&
delete e[o][i]}return JSON.stringify(e)}mark(t,e){this.film=t,this.look=e;let s=this.key_of(t.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){
let{paths:t,windows:e}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&t.x==="start.speed"&&t.y==="plane.mu")return;let s=o=>[t[o],...e[o]];return{what:this.
what,x:s("x"),y:s("y")}}restore(t){![...this.quantity.options].some(({value:e})=>e===t.what)||!this.axes.restore(t)||(this.quantity.value=this.what=t.what,this.
syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;
let{signal:t}=this.asked,e=this.film.scenario,s=e.contact.model==="rigid"?[]:[["contact.model","choice.contact.model.rigid"]];this.computing=!0;let o=`${this.what}\
 ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;o!==this.kind&&(this.layers=[]),this.kind=o,this.redraw();try{for(let[i,r]of Vr){E(this.state,{key:"\
map.computing_count_motions",values:{count:i*r}});let a={x:this.axes.asked("x",i),y:this.axes.asked("y",r)},l={scenario:e,changes:s,...a,what:this.what},h=await this.
backend.map(l,t),m=Wr(h);this.layers=Gr(this.layers,m),this.keys.replaceChildren(...Ur(m));let u=Br(e,Object.values(this.axes.paths)),d={key:s.length?"map.count\
_motions_with_rigid":"map.count_motions",values:{count:i*r}};E(this.state,u?[d,"; ",u]:d),this.redraw()}this.level=Vr.length}catch(i){if(i.name==="AbortError")return;
E(this.state,K(i))}this.computing=!1}redraw(){if(!this.film)return;let{look:t}=this,{context:e,width:s,height:o}=B(this.canvas,t.px);e.font=Se(t),this.axes.fit(
s,o,a=>e.measureText(a).width),e.clearRect(0,0,s,o),e.save(),this.axes.clip(e),e.imageSmoothingEnabled=!1;let{axes:i}=this;for(let a of this.layers){let[l,h]=a.
x.map(p=>i.x(p)),[m,u]=a.y.map(p=>i.y(p));e.drawImage(a.picture,l,u,h-l,m-u)}let r=this.here();r&&uo(e,i.x(r.x),i.y(r.y),t.ink,t.paper),this.pointed&&ge(this.body)&&
uo(e,i.x(this.pointed.x),i.y(this.pointed.y),"#D55E00",t.paper),e.restore(),i.draw(e,t)}aim(){let t=ge(this.body)&&this.pointed||this.here(),{windows:e}=this.axes;
return t&&bt.every(o=>t[o]>=e[o][0]&&t[o]<=e[o][1])?t:void 0}here(){let t=s=>{let[o,i]=s.split(".");return this.film.values[s]??this.film.scenario[o]?.[i]},e={x:t(
this.axes.paths.x),y:t(this.axes.paths.y)};return typeof e.x=="number"&&typeof e.y=="number"?e:null}said(t){return`${this.axes.said(t)}: ${Kr(this.layers,t)}`}take(t){
this.onmotion([[this.axes.paths.x,t.x],[this.axes.paths.y,t.y]])}zoom(t,e){this.tip.hidden=!0,this.axes.zoom(t,e)&&(this.redraw(),this.soon())}};var Ss=class{constructor(){this.past=[];this.future=[];this.now=null;this.what="";this.when=-1/0}note(t,e="",s=performance.now()){let o=this.now;if(this.now=t,o===
null||Ee(o,t))return"same";let i=e!==""&&e===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=e,this.when=s,this.future=[],i?"again":(this.past.push(
o),this.past.length>500&&this.past.shift(),"step")}touch(t,e){t===this.what&&e-this.when<1e3&&(this.when=e)}written(){return JSON.stringify({past:this.past.slice(
-100),now:this.now,future:this.future.slice(-100)})}restore(t){if(!t||!this.now)return;let{past:e,now:s,future:o}=JSON.parse(t);s&&Ee(s,this.now)&&Object.assign(
this,{past:e,future:o})}holds(t){return this.now!==null&&Ee(this.now,t)}next(t){return(t<0?this.past:this.future).at(-1)??null}step(t){let[e,s]=t<0?[this.past,this.
future]:[this.future,this.past],o=e.pop();!o||!this.now||(s.push(this.now),this.now=o,this.what="")}arrive(t){if(!(this.now&&Ee(this.now,t))){for(let e of[-1,1]){
let s=e<0?this.past:this.future,o=s.length-s.findLastIndex(i=>Ee(i,t));if(!(o>s.length)){for(let i=0;i<o;i++)this.step(e);return}}Object.assign(this,{past:[],future:[],
now:t,what:""})}}},Ee=(n,t)=>JSON.stringify(n)===JSON.stringify(t);var jc=1e-6,Ts=class{constructor(t,e){this.backend=t;this.listener=e;this.history=new Ss;this.lanes=[];this.active=0;this.going=Promise.resolve()}film(t=this.active){
return this.lanes[t].film}films(){return this.lanes.map(t=>t.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([t])=>t))}name(){return this.
lanes.length>1?"AB"[this.active]:""}filmOf(t){let e=new It(t);return(t.exact||t.samples?null:this.backend.exact(e.scenario))?.then(o=>{Object.assign(e,o,{latest:null}),
this.listener.refined()}).catch(()=>{}),e}set(t){this.lanes=t.map(e=>({film:this.filmOf(e)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(t){
this.set(await Promise.all(t.map(e=>this.backend.film({query:e}))))}change(t,e){let s=this.lanes[this.active];s.moved=performance.now(),s.since??=s.moved,s.pending=
[...(s.pending??[]).filter(([o])=>!t.some(([i])=>i===o)),...t],s.commit||=e,s.what=t.map(([o])=>o).join(),e&&this.history.touch(s.what,s.moved),this.pump(s)}async pump(t){
if(t.busy||!this.lanes.includes(t))return;if(!t.pending){t.commit&&this.settle(t);return}let e=t.pending,{since:s}=t;t.pending=null,t.since=null,t.busy=!0;try{t.
film=new It(await this.backend.film({scenario:t.film.scenario,changes:e})),this.lanes.includes(t)&&this.listener.shown(s)}catch(o){this.lanes.includes(t)&&this.
listener.failed(o,e)}finally{t.busy=!1}this.pump(t)}refine(t,e){for(let s of this.lanes){let{film:o}=s;if(s.refining||s.coarse===o)continue;let i=o.wanted(t,e),
r=!i&&e===0&&!o.moment(t).sure;!i&&!r||(s.refining=!0,this.samples(o,i??[t,t+jc]).then(a=>{i?o.refine(a):o.pin(a,t),this.listener.refined()}).catch(()=>{s.coarse=
o}).finally(()=>{s.refining=!1}))}}async samples(t,e){return t.samples?t.samples(e):this.backend.samples(t.scenario,e)}settle(t){t.commit=!1,this.note(t.what,t.
moved),this.listener.settled()}queries(){return this.films().map(t=>t.query)}note(t,e){this.listener.noted(this.history.note(this.queries(),t,e))}replace(t){this.
lanes[this.active]={film:this.filmOf(t)},this.listener.shown(),this.note()}travel(t){return this.inTurn(async()=>{let e=this.history.next(t);e&&(await this.load(
e),this.history.step(t),await this.listener.travelled(t),this.listener.shown(),this.listener.noted("travelled"))})}arrive(t){return this.inTurn(async()=>{await this.
load(t),this.history.arrive(this.queries()),this.listener.shown(),this.listener.noted("travelled")})}inTurn(t){return this.going=this.going.then(t).then(()=>!0,
e=>(this.listener.failed(e),!1)),this.going}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.
active,1),this.active=0),this.listener.shown(),this.note()}choose(t){this.active=t,this.listener.shown(),this.listener.noted("same")}link(t=""){let s=[this.lanes.
length>1?`with=${encodeURIComponent(this.film(1).query)}`:"",t].filter(Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};var qc=6e3,Es=class{constructor(){this.message=c("p",{class:"message",role:"alert",hidden:!0});this.toast=c("div",{class:"toast",role:"status",hidden:!0});this.
timer=0}fail(t,e=""){let s=K(t);this.message.replaceChildren(...[s,...e?[" ",e]:[]].map(fe)),this.message.hidden=!1,this.seen()||this.say(s,this.message.isConnected)}seen(){
let{top:t,bottom:e,height:s}=this.message.getBoundingClientRect();return this.message.isConnected&&s>0&&t>=0&&e<=innerHeight}clear(){this.message.hidden=!0}say(t,e=!1){
this.toast.setAttribute("role",e?"presentation":"status"),E(this.toast,t),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=
!0},qc)}};var C=52,Ae=10,A=8,As=30;function Yr(n,t){if(!n.length)return[0,1];let e=Float64Array.from(n).sort(),[s,o]=[e[0],e[e.length-1]],[i,r]=[e[Math.floor(.02*e.length)],
e[Math.ceil(.98*e.length)-1]],a=Math.max(r-i,1e-12);o>r+4*a&&(o=r+.6*a),s<i-4*a&&(s=i-.6*a),s=Math.min(s,0),o=Math.max(o,0),t&&([s,o]=[-Math.max(-s,o),Math.max(
-s,o)]);let l=.06*(o-s)||1;return[s<0?s-l:s,o+l]}function Jr(n,t){let{look:e,box:s,heights:o,range:i}=t,r=Math.max(s.height/28,4);for(;at(o[0],o[1],r).length<3&&
r<12;)r+=1;let a=z(o[1]-o[0],r),l=s.width/70,h=z(i[1]-i[0],l),{name:m,unit:u}=D[t.shared.axis];Kt(n,e,{left:C,top:A,box:s},{up:{marks:at(o[0],o[1],r).map(p=>({at:t.
y(p),text:it(p,a),strong:Math.abs(p)<1e-9*a})),name:T(t.unit)},across:{marks:at(i[0],i[1],l).map(p=>({at:t.x(p),text:it(p,h)})),name:Nr(m,u)},lines:!0})}var{letters:Dc}=S.words;function Xr(n,t,e){let s=n.length/t,o=c("canvas",{width:t,height:s}),i=new ImageData(t,s);for(let r=0;r<s;r++)for(let a=0;a<t;a++){let l=Dc[n[r*
t+a]],h=xt(e[l]??"#6E6E6E"),m=4*((s-1-r)*t+a);i.data.set([...h,255],m)}return ft(o).putImageData(i,0,0),o}var Bc=2;function Qr(n,t,e){let s=e.length/2,[o,i,r]=[
A,v(t.y(0),A,A+t.box.height),A+t.box.height];n.strokeStyle=pe(t.look.dark?"#ffffff":"#000000",.28),n.lineWidth=1;for(let[a,l,h]of[[0,i,r],[s,o,i]])for(let m=0;m<
s;m++){let u=e[a+m];if(!u)continue;let p=m;for(;p<s&&e[a+p]===u;)p++;let d=t.x(m*2*Math.PI/s),f=t.x(p*2*Math.PI/s);n.save(),n.beginPath(),n.rect(d,l,f-d,h-l),n.
clip(),n.beginPath();let{height:_}=t.box;for(let g=-_;g<f-d+_;g+=7)for(let b of u===Bc?[!0,!1]:[u>0])n.moveTo(d+g,b?r:o),n.lineTo(d+g+_,b?o:r);n.stroke(),n.restore(),
m=p}}function Zr(n,t){let{look:e,box:s}=t,[o,i]=t.range.map(h=>h*180/Math.PI),r=i-o>200?45:z(i-o,6),a=[];for(let h=Math.ceil(o/r-1e-9);h*r<=i+1e-9;h++)a.push(h*
r);let l=z(t.top()-t.bottom(),5);Kt(n,e,{left:C,top:A,box:s},{across:{marks:a.map(h=>({at:t.x(h*Math.PI/180),text:it(h,r)})),name:T("phase.angle_theta_within_a")},
up:{marks:at(t.bottom(),t.top(),5).map(h=>({at:t.y(h),text:it(h,l)})),name:"θ̇ [rad/s]"}})}var Ls={solid:[],dash:[6,4],dot:[2,3],long:[14,4],mixed:[8,3,2,3]};function Ps(n,t="solid"){let e=c("i",{class:"swatch","aria-hidden":"true"});if(e.style.borderTopColor=
n??"var(--ink)",e.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted",long:"none",mixed:"none"}[t],t==="long"||t==="mixed"){let s=0,o=Ls[t].map((i,r)=>(s+=
i,`${r%2?"transparent":n??"var(--ink)"} ${s-i}px ${s}px`));e.style.height="2.5px",e.style.width="28px",e.style.background=`repeating-linear-gradient(90deg, ${o.
join(", ")})`}return e}var Cs=class{constructor(t,e,s){this.backend=t;this.clock=e;this.colors=s;this.canvas=c("canvas",{class:"plot-canvas"});this.over=c("canvas",{class:"plot-canvas\
 plot-over"});this.keys=c("div",{class:"plot-keys"});this.hatched=c("span",{hidden:!0},"phase.hatched"," ");this.asked="";this.body=c("div",{class:"plot-body",role:"\
figure",tabindex:"0","aria-label":"phase.plane_of_angle_and"},this.canvas,this.over),this.element=c("section",{class:"phase"},c("header",{},c("h3",{},"phase.pla\
ne_of_theta_and"),this.keys),this.body,c("p",{class:"hint"},"phase.colours"," ",this.hatched,ks()?"phase.click_to_go_there":"phase.click_to_go_there_once")),this.
body.addEventListener("pointerdown",o=>this.seek(o)),this.pinched=yt(this.body,{zoom:(o,i)=>this.box&&this.zoomAbout(i?this.point(i):this.middle(),1/o),home:()=>this.
home(),keys:!0}),this.range=[0,2*Math.PI],this.soon=ot(()=>this.sharpen(),140)}async fetch(t,e){let s=this.reach(),o=JSON.stringify([t.hoop,t.plane,s]);if(o!==this.
asked){let i=await this.painted(t,[0,2*Math.PI,-s,s],e);this.asked=o,this.pictures=[i],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(this.sharpening?.
abort(),!(!this.pictures||this.isWhole())){this.sharpening=new AbortController;try{let t=await this.painted(this.films[this.active].scenario,[...this.range,this.
bottom(),this.top()],this.sharpening.signal);this.pictures=[this.pictures[0],t],this.redraw()}catch(t){if(t.name!=="AbortError")throw t}}}async painted(t,e,s){let{
modes:o,paradox:i}=await this.backend.regions(t,e,s);return s?.throwIfAborted(),{window:e,paradox:i,picture:Xr(o,i.length/2,this.colors.modes)}}reach(){return this.
reached}findReach(){let t=0;for(let s of this.films??[]){let o=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();t=Math.max(t,o[Math.floor(
.99*(o.length-1))]??0)}let e=z(Math.max(t,1)*1.15,4);return Math.ceil(Math.max(t,1)*1.12/e)*e}home(){this.range=[0,2*Math.PI],this.window=null,this.wholeAgain(),
this.redraw()}isWhole(){let[t,e]=this.range;return e-t>=2*Math.PI-1e-9&&(!this.window||this.window[1]-this.window[0]>=2*this.reach()-1e-9)}wholeAgain(){this.sharpening?.
abort(),this.pictures?.splice(1)}point(t){let e=this.body.getBoundingClientRect(),s=((t.clientX-e.left)/this.look.px-C)/this.box.width,o=1-((t.clientY-e.top)/this.
look.px-A)/this.box.height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+o*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.
range[1]),.5*(this.bottom()+this.top())]}zoomAbout([t,e],s){let o=Math.max(t-(t-this.range[0])*s,0),i=Math.min(t+(this.range[1]-t)*s,2*Math.PI),r=this.reach(),a=Math.
max(e-(e-this.bottom())*s,-r),l=Math.min(e+(this.top()-e)*s,r);this.range=[o,i],this.window=[a,l],this.isWhole()?this.wholeAgain():this.soon(),this.redraw()}bottom(){
return this.window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(t,e,s){
this.films=t,this.active=e,this.look=s,this.reached=this.findReach(),this.forwards=t.some(o=>o.columns.omega.some(i=>i>.3)),this.backwards=t.some(o=>o.columns.omega.
some(i=>i<-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(t){return C+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){
return A+(1-(t-this.bottom())/(this.top()-this.bottom()))*this.box.height}redraw(){if(!this.films)return;let{colors:t,look:e}=this,{context:s,width:o,height:i}=B(
this.canvas,e.px);if(this.box={width:o-C-Ae,height:i-A-As},s.clearRect(0,0,o,i),s.save(),s.beginPath(),s.rect(C,A,this.box.width,this.box.height),s.clip(),this.
pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:l}of this.pictures){let[h,m,u,p]=l,d=[this.x(h),this.y(p),this.x(m)-this.x(h),this.y(u)-this.y(p)];
s.fillStyle=e.panel,s.fillRect(d[0],d[1],d[2],d[3]),s.globalAlpha=.35,s.drawImage(a,d[0],d[1],d[2],d[3]),s.globalAlpha=1}let{paradox:r}=this.pictures[0];Qr(s,this,
r),this.hatched.hidden=!r.some(a=>a!==0)}for(let[r,a]of this.films.entries())this.way(s,a,r);if(s.restore(),Zr(s,this),this.keyed!==e.dark){this.keyed=e.dark;let r=Object.
entries(t.mode_names).filter(([a])=>"RSKH".includes(a));this.keys.replaceChildren(...r.map(([a,l])=>c("span",{class:"plot-key"},Ps(t.modes[a]),l)))}this.cursor(
this.clock.time)}way(t,e,s){let{angle:o,omega:i,mode:r}=e.columns,a=2*Math.PI;t.lineWidth=s?1.2:1.8,t.setLineDash(s?[4,3]:[]),t.strokeStyle=this.films.length>1?
pt(s,this.look.dark):this.look.ink,t.beginPath();let l=null;for(let h=0;h<e.length;h++){if(!Number.isFinite(i[h])){l=null;continue}let m=Math.floor(o[h]/a),u=o[h]-
m*a;if(l===null)t.moveTo(this.x(u),this.y(i[h]));else if(m!==l.lap){let p=m>l.lap?a:0;t.lineTo(this.x(p),this.y(i[h])),t.moveTo(this.x(a-p),this.y(i[h])),t.lineTo(
this.x(u),this.y(i[h]))}else t.lineTo(this.x(u),this.y(i[h]));l={lap:m,mode:r[h]}}t.stroke(),t.setLineDash([])}spot({angle:t,omega:e}){let s=2*Math.PI;return[this.
x(t-Math.floor(t/s)*s),this.y(e)]}cursor(t){if(!this.films||!this.box)return;let{context:e,width:s,height:o}=B(this.over,this.look.px);e.clearRect(0,0,s,o);let{
pointed:i}=this.clock;if(i!==null){let[r,a]=this.spot(this.films[this.active].at(i));e.strokeStyle=this.look.ink,e.lineWidth=1.5;for(let l of[6,10])e.beginPath(),
e.arc(r,a,l,0,2*Math.PI),e.stroke()}this.films.forEach((r,a)=>{let l=r.at(t),[h,m]=this.spot(l);h>=C&&h<=C+this.box.width&&m>=A&&m<=A+this.box.height&&(e.beginPath(),
e.arc(h,m,a?4:5.5,0,2*Math.PI),e.fillStyle=this.colors.modes[l.mode],e.fill(),e.lineWidth=2,e.strokeStyle=this.films.length>1?pt(a,this.look.dark):this.look.ink,
e.stroke(),!(this.films.length<2)&&(e.font=`700 12px ${this.look.font}`,e.textAlign="left",e.fillStyle=e.strokeStyle,e.fillText("AB"[a],h+8,m-6)))})}seek(t){let e=this.
body.getBoundingClientRect(),[s,o]=[t.clientX-e.left,t.clientY-e.top].map(m=>m/this.look.px);if(this.pinched())return;let i=this.films[this.active],{angle:r,omega:a}=i.
columns,l=2*Math.PI,h={distance:1/0,t:0};for(let m=0;m<i.length;m++){let u=r[m]-Math.floor(r[m]/l)*l,p=Math.hypot(this.x(u)-s,this.y(a[m])-o);p<h.distance&&(h={
distance:p,t:i.t[m]})}h.distance<40&&this.clock.seek(v(h.t,0,i.duration))}};function ta(n,t){let e=[],s=null;for(let o=0;o<n.length;o++){let i=Math.floor(n[o]),r=t[o];Number.isFinite(i+r)?s&&s.x===i?(s.low=Math.min(s.low,r),s.high=Math.
max(s.high,r),s.middle+=(r-s.middle)/++s.count):(s={x:i,low:r,high:r,middle:r,count:1},e.push(s)):(s&&e.push(null),s=null)}return e}function ea(n){let t=n.filter(
e=>e!==null);return t.filter(({count:e})=>e>=4).length>.5*t.length}var Vt=class{constructor({key:t,title:e,unit:s,curves:o,limits:i,symmetric:r=!1},a){this.shared=a;this.cut=null;this.key=t,this.title=e,this.unit=s,this.curves=
o,this.limits=i,this.symmetric=r,this.canvas=c("canvas",{class:"plot-canvas"}),this.over=c("canvas",{class:"plot-canvas plot-over"}),this.keys=c("div",{class:"p\
lot-keys"}),this.body=c("div",{class:"plot-body",tabindex:"0",role:"figure","aria-label":e},this.canvas,this.over),this.element=c("section",{class:"plot","data-\
plot":t},c("header",{},c("h3",{},e),this.keys),this.body),this.body.addEventListener("pointerdown",l=>this.press(l)),this.pinched=yt(this.body,{zoom:(l,h)=>this.
films&&this.zoomAbout(h?this.valueAt(h):this.middle(),1/l),home:()=>this.zoomTo(null),keys:!0}),this.onseek=()=>{}}abscissa(t){return D[this.shared.axis].values(
t)}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.duration),1e-9)];let[t,e]=[1/0,-1/0];for(let s of this.films)for(let o of this.
abscissa(s))o<t&&(t=o),o>e&&(e=o);return e>t?[t,e]:[t-1,e+1]}take(t,e,s){this.films=t,this.active=e,this.look=s,this.range=this.shared.range??this.fullRange(),this.
legend(this.shades(t[e],e),s.dark)}draw(t){let{films:e,active:s}=this,{context:o,width:i,height:r}=B(this.canvas,this.look.px);this.box={width:i-C-Ae,height:r-A-
As},o.clearRect(0,0,i,r);let a=e.flatMap((h,m)=>this.shades(h,m).map((u,p)=>({...u,film:h,lane:m,number:p})).filter((u,p,d)=>this.compares(u,m,d.length)));this.
heights=this.limits??this.findHeights(a),this.shared.axis==="time"&&this.bands(o,e[s],t),Jr(o,this),o.save(),o.beginPath(),o.rect(C,A,this.box.width,this.box.height),
o.clip();for(let h of a)this.curve(o,h);let l=e.map((h,m)=>a.find(u=>u.lane===m));if(e.length>1)for(let h of l)h&&this.letter(o,h);this.cut&&this.tell(o,T("plot\
.cut",this.cut)),o.restore(),this.describe(a)}shades(t,e){let{dark:s}=this.look;if(this.films.length<2)return this.curves(t).map(i=>({...i,color:i.color&&de(i.color,
s)}));let o=Object.keys(Ls);return this.curves(t).map((i,r)=>({...i,color:pt(e,s),dash:o[r%o.length]}))}compares({name:t},e,s){return e===this.active||s<=2||t===
"total"}x(t){return C+(t-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(t){return A+(1-(t-this.heights[0])/(this.heights[1]-this.heights[0]))*this.
box.height}findHeights(t){let e=[];for(let{film:r,values:a}of t){let l=this.abscissa(r);for(let h=0;h<a.length;h++)l[h]>=this.range[0]&&l[h]<=this.range[1]&&Number.
isFinite(a[h])&&e.push(a[h])}let s=Yr(e,this.symmetric),[o,i]=e.reduce(([r,a],l)=>[Math.min(r,l),Math.max(a,l)],s);return this.cut=o<s[0]||i>s[1]?{low:x(o,3),high:x(
i,3)}:null,s}bands(t,e,s){for(let o of e.phases){let i=v(this.x(o.from),C,C+this.box.width),r=v(this.x(o.to),C,C+this.box.width);r<=i||(t.fillStyle=pe(s.modes[o.
mode],.14),t.fillRect(i,A,r-i,this.box.height))}}curve(t,{film:e,color:s,dash:o,number:i}){let[r,a]=[[],[]];for(let u of e.pieces()){let p=this.abscissa(u.film),
{values:d}=this.curves(u.film)[i];for(let f=u.from;f<u.to;f++)r.push(this.x(p[f])),a.push(v(this.y(d[f]),-1e4,1e4))}t.strokeStyle=t.fillStyle=s??this.look.ink,t.
lineWidth=1.8,t.setLineDash(Ls[o??"solid"]);let l=ta(r,a),h=ea(l),m=h?l.map(u=>u&&[u.x+.5,u.middle]):r.map((u,p)=>Number.isFinite(u+a[p])?[u,a[p]]:null);if(h){t.
globalAlpha=.28;for(let u of l)u&&t.fillRect(u.x,u.low,1,u.high-u.low);t.globalAlpha=1}t.beginPath();for(let[u,p]of m.entries())p&&m[u-1]?t.lineTo(...p):p&&t.moveTo(
...p);t.stroke(),t.setLineDash([])}letter(t,{film:e,lane:s,values:o,color:i}){let r=this.abscissa(e),a=this.range[0]+(s?.84:.7)*(this.range[1]-this.range[0]),l=r.
findIndex(u=>u>=a);if(l<0||!Number.isFinite(o[l]))return;let[h,m]=[this.x(r[l]),v(this.y(o[l])-8,A+10,A+this.box.height-4)];t.font=`700 12px ${this.look.font}`,
t.textAlign="center",t.lineWidth=4,t.strokeStyle=this.look.panel,t.strokeText("AB"[s],h,m),t.fillStyle=i??this.look.ink,t.fillText("AB"[s],h,m)}tell(t,e){t.font=
Se(this.look),t.textAlign="left",t.lineWidth=4,t.strokeStyle=this.look.panel,t.strokeText(e,C+6,A+11),t.fillStyle=this.look.ink,t.fillText(e,C+6,A+11)}legend(t,e){
let s=t.map(o=>o.name+o.color+o.dash).join()+e;this.named!==s&&(this.named=s,this.values=t.map(()=>c("span",{class:"value"})),this.keys.replaceChildren(...t.map(
(o,i)=>c("span",{class:"plot-key"},Ps(o.color,o.dash),o.name," ",this.values[i]))))}describe(t){let e=t.slice(0,6).map(({name:o,values:i,lane:r})=>{let[a,l]=[1/0,
-1/0];for(let d of i)d<a&&(a=d),d>l&&(l=d);let h=this.films.length>1?`${"AB"[r]}: `:"",m=1e-12*Math.max(-a,l),u=d=>x(Math.abs(d)<m?0:d,3),p={name:T(o),low:u(a),
high:u(l)};return l>=a?`${h}${T("diagram.name_from_low_to",p)}`:""}),s=T("diagram.diagram_title_in_unit",{title:T(this.title),unit:T(this.unit)});this.body.setAttribute(
"aria-label",`${s} ${e.filter(Boolean).join("; ")}.`)}cursor(t){if(!this.heights)return;let{context:e,width:s,height:o}=B(this.over,this.look.px);e.clearRect(0,
0,s,o),this.films.forEach((r,a)=>{let l=r.moment(t),h=this.x(this.abscissa(l)[0]),m=h>=C-1&&h<=C+this.box.width+1;m&&(e.strokeStyle=this.look.soft,e.lineWidth=1,
e.beginPath(),e.moveTo(h,A),e.lineTo(h,A+this.box.height),e.stroke()),this.shades(l,a).forEach((u,p,d)=>{if(!this.compares(u,a,d.length))return;let f=u.values[0];
a===this.active&&this.values?.[p]&&(this.values[p].textContent=x(f,l.sure?3:2));let _=this.y(f);!m||!(_>=A-1&&_<=A+this.box.height+1)||(e.fillStyle=u.color??this.
look.ink,e.beginPath(),e.arc(h,_,3.2,0,2*Math.PI),e.fill())})});let{pointed:i}=this.shared.clock;if(i!==null&&this.shared.axis==="time"&&(e.strokeStyle=this.look.
ink,e.setLineDash([4,3]),e.strokeRect(this.x(i),A,0,this.box.height),e.setLineDash([])),this.picked){let[r,a]=this.picked;e.fillStyle=pe("#0072B2",.2),e.fillRect(
Math.min(r,a),A,Math.abs(a-r),this.box.height)}}valueAt(t){let e=this.body.getBoundingClientRect(),{px:s}=this.look,o=v(((t.clientX-e.left)/s-C)/(e.width/s-C-Ae),
0,1);return this.range[0]+o*(this.range[1]-this.range[0])}press(t){if(!this.films)return;let e=this.body.getBoundingClientRect(),s=(t.clientX-e.left)/this.look.
px,o=this.valueAt(t),i=this.pinched(),r=a=>{if(i||=this.pinched(),i)return;let l=(a.clientX-e.left)/this.look.px;this.picked=t.pointerType==="mouse"&&Math.abs(l-
s)>5?[s,l]:null,t.pointerType!=="mouse"&&this.seek(this.valueAt(a)),this.cursor(this.shared.clock.time)};X(this.body,t,r,(a,l)=>{let h=this.valueAt(a),{picked:m}=this;
this.picked=null,m&&l?this.zoomTo(o<h?[o,h]:[h,o]):m?this.cursor(this.shared.clock.time):l&&!i&&this.seek(t.pointerType==="mouse"?o:h)})}seek(t){if(this.shared.
axis==="time")return this.onseek(t);let e=this.films[this.active],s=this.abscissa(e),o=0;for(let i=0;i<s.length;i++)Math.abs(s[i]-t)<Math.abs(s[o]-t)&&(o=i);return this.
onseek(e.t[o])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(t,e){let s=this.fullRange(),o=Math.max(t-(t-this.range[0])*e,s[0]),i=Math.min(t+(this.
range[1]-t)*e,s[1]);this.zoomTo(o<=s[0]&&i>=s[1]?null:[o,i])}zoomTo(t){this.shared.range=t&&t[1]-t[0]>1e-9?t:null,this.shared.changed()}};var fo=n=>Object.entries(D).map(([t,e])=>c("option",{value:t},n(e)));function sa(n){let t="height",e=new Vt({key:"own",title:"diagram.your_choice",unit:"",curves:i=>[
{name:D[t].name,values:D[t].values(i)}]},n),s=()=>{let{symbol:i,unit:r}=D[t];e.unit=r?`${i} [${r}]`:i},o=c("select",{"aria-label":"diagram.what_your_diagram_sho\
ws",onchange:()=>{t=o.value,s(),n.changed()}},fo(gr));return o.value=t,s(),e.element.querySelector("h3")?.after(o),e}function zc(n){return[{key:"velocities",title:"diagram.velocities",unit:"diagram.velocity_m_s",curves:t=>[{name:"diagram.v_centre",color:n.center_speed,values:t.
columns.vx},{name:"R θ̇",color:n.rotation_speed,dash:"dash",values:t.derived("spin",({omega:e})=>Float64Array.from(e,s=>s*t.radius))}]},{key:"energies",title:"\
diagram.energies_and_losses",unit:"diagram.energy_j",curves:t=>[{name:"diagram.kinetic",color:n.kinetic,values:t.columns.kinetic},{name:"diagram.potential",color:n.
potential,values:t.columns.potential},{name:"diagram.total",values:t.derived("total",({t:e,kinetic:s,potential:o})=>Float64Array.from(e,(i,r)=>s[r]+o[r])),dash:"\
dash"},{name:"diagram.lost_to_friction",color:n.friction_loss,values:t.columns.friction_loss},{name:t.scenario.contact.model==="compliant"?"diagram.lost_in_the_\
damper":"diagram.lost_in_impacts_normal",color:n.impact_loss,values:t.columns.normal_loss,dash:"dot"},...t.scenario.plane.rolling_resistance?[{name:"diagram.los\
t_to_rolling_resistance",values:t.columns.rolling_resistance,dash:"dot"}]:[]]},{key:"forces",title:"diagram.contact_forces",unit:"diagram.force_n",curves:t=>[{name:"\
diagram.normal_n",color:n.normal_force,values:t.columns.normal_force},{name:"diagram.friction_f",color:n.friction_force,dash:"dash",values:t.columns.friction_force}]},
{key:"utilization",title:"diagram.use_of_friction",unit:"|F| / μN",limits:[0,1.08],curves:t=>[{name:"|F| / μN",color:n.friction_force,values:t.columns.utilization}]}]}
var Rs=class{constructor(t,e){this.colors=e;this.shared={axis:"time",range:null,clock:t,changed:()=>this.redraw()},this.plots=[...zc(e).map(o=>new Vt(o,this.shared)),
sa(this.shared)];for(let o of this.plots)o.onseek=i=>t.seek(i);this.seen=new Map(this.plots.map(o=>[o.element,!0]));let s=new IntersectionObserver(o=>{for(let{target:i,
isIntersecting:r}of o)this.seen.set(i,r);this.redraw()},{rootMargin:"400px"});for(let o of this.plots)s.observe(o.element);this.axis=c("select",{"aria-label":"d\
iagram.horizontal_axis_of_the",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=null,this.redraw()}},fo(({name:o})=>({key:"diagram.over_quantity",
values:{quantity:o}}))),this.back=c("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"diagram.whole_motion"),this.hint=c("span",{class:"\
hint"}),this.element=c("div",{class:"plots"},c("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(o=>o.element))}draw(t,e,s){this.films=t,
this.active=e,this.look=s;let o=matchMedia("(hover: none)").matches?"diagram.slide_to_go_there":"diagram.click_to_go_there",i=t.length>1;E(this.hint,i?{key:"dia\
gram.a_blue_b_ochre",values:{hoop:"AB"[e],hands:o}}:o),this.redraw()}redraw(){if(this.films?.length){this.back.hidden=!this.shared.range;for(let t of this.plots)
t.take(this.films,this.active,this.look);for(let t of this.visible())t.draw(this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.plots.filter(
t=>this.seen.get(t.element))}cursor(t){for(let e of this.visible())e.cursor(t)}};var Wc={python:"fingerprint.same_bits_as_in",link:"fingerprint.same_bits_as_where"},Gc={python:"fingerprint.the_bits_differ_own",link:"fingerprint.the_bits_diff\
er_own_here"},Os=class{constructor(t){this.link=new Map;this.python=new Map(t.map(({key:e,query:s})=>[s,S.fingerprints[e]]))}expect(t,e){for(let[s,{query:o}]of t.
entries())e[s]&&this.link.set(o,e[s])}expected(t){return t.map(({query:e})=>this.link.get(e)??"")}of({query:t,fingerprint:e}){return e?["python","link"].flatMap(
s=>{let o=this[s].get(t);if(!o)return[];let i=e===o;return[{same:i,text:i?Wc[s]:{key:Gc[s],values:{own:e,other:o}}}]}):[]}};var na=n=>new URL(`${n}?ffed6a535371fa98a0ae1f5c8a376399`,import.meta.url).href,oa=()=>import(na("stage3d.js")),ia=()=>import(na("svg.js")),Ns=n=>n.catch(()=>{throw new Error(
"page.not_loaded")});var Uc=3840;async function ra(n){let{width:t,height:e}=n.stage.canvas().getBoundingClientRect(),s=Math.max(Uc/t,globalThis.devicePixelRatio||1),o=c("canvas",{width:Math.
round(t*s),height:Math.round(e*s)}),i=ft(o);return i.setTransform(s,0,0,s,0,0),go(i,n,t,e),n.stage.options.three?(i.drawImage(n.stage.sharp(n,s),0,0,t,e),n.drawStage()):
ha(i,n,t,e),_o(i,n,e),new Promise((r,a)=>o.toBlob(l=>l?r(l):a(new Error("save.the_picture_is_too"))))}async function aa(n){if(n.stage.options.three)throw new Error(
"save.a_picture_in_space");let{width:t,height:e}=n.stage.canvas().getBoundingClientRect(),{Context:s}=await Ns(ia()),o=new s({width:t,height:e,document});return go(
o,n,t,e),ha(o,n,t,e),_o(o,n,e),new Blob([o.getSerializedSvg()],{type:"image/svg+xml"})}function la(n,t){let e=n.stage.canvas(),{width:s,height:o}=e.getBoundingClientRect(),
i=ft(t);i.setTransform(t.width/s,0,0,t.height/o,0,0),go(i,n,s,o),i.drawImage(e,0,0,s,o),_o(i,n,o)}function go(n,{theme:t},e,s){n.fillStyle=t.look.paper,n.fillRect(
0,0,e,s)}function ha(n,t,e,s){let{stage:o,clock:i,theme:r}=t;o.flat.paint(n,e,s,t.films(),i.time,o.options,r.look,r.inks)}function _o(n,t,e){let{theme:s,stage:o,
clock:i}=t,{px:r}=s.look,a=t.films();n.textBaseline="top",n.textAlign="left";for(let[l,h]of a.entries()){let m=h.at(i.time),u=a.length>1?`${"AB"[l]}: `:"",p=T(s.
colors.mode_names[m.mode]),d=`t = ${m.t.toFixed(3)} s, θ = ${q(m.angle)}, v = ${x(m.vx,m.digits)} m/s`,f=o.options.three?10+20*r*l:10+l*e/a.length;n.fillStyle=
s.colors.modes[m.mode],n.fillRect(12,f+2*r,11*r,11*r),n.fillStyle=s.look.ink,n.font=`${13*r}px ${s.look.font}`,n.fillText(`${u}${p}, ${d}`,12+18*r,f)}n.textBaseline=
"alphabetic"}async function ca(n){let t=n.stage.canvas();if(!t.captureStream||!globalThis.MediaRecorder)throw new Error("save.this_browser_cannot_record");let e=c("canvas",{
width:2*Math.ceil(t.width/2),height:2*Math.ceil(t.height/2)}),s=new MediaRecorder(e.captureStream(60),{videoBitsPerSecond:8e6}),o=[];s.ondataavailable=a=>o.push(
a.data);let i=new Promise(a=>s.onstop=a),{loop:r}=n.clock;return n.clock.loop=!1,n.clock.seek(0),n.notice.say("save.recording_one_run"),n.afterFrame=()=>{la(n,e),
!n.clock.playing&&s.state==="recording"&&s.stop()},s.start(),n.clock.play(!0),await i,n.afterFrame=null,n.clock.loop=r,new Blob(o,{type:s.mimeType})}var Kc=[["motion.toml","save.save_the_scenario_toml"],["motion.csv","save.save_the_states_csv"],["motion.nc","save.save_the_motion_netcdf"],["motion.json","save\
.save_the_events_json"],["motion.mp4","save.save_a_film_mp4"]],Hs=class{constructor(t){this.lab=t;this.menu=c("details",{class:"menu"},c("summary",{class:"butto\
n"},c("span",{class:"long"},"save.share_and_save"),c("span",{class:"short"},"save.share")),c("div",{class:"menu-body"},t.backend.shares&&this.item("save.copy_a_\
link_to",()=>this.copyLink()),Kc.filter(([e])=>t.backend.files.includes(e)).map(([e,s])=>this.item(s,()=>this.download(e))),this.item("save.save_a_picture_png",
()=>this.picture("png",ra)),this.item("save.save_a_picture_svg",()=>this.picture("svg",aa)),this.item("save.record_one_run_as",()=>this.record()),this.item("sav\
e.show_the_python_code",()=>this.code()))),this.dialog=c("dialog",{class:"code-dialog","aria-label":"save.the_same_motion_in"})}item(t,e){return c("button",{type:"\
button",onclick:async()=>{this.menu.open=!1;try{await e()}catch(s){this.lab.notice.fail(s)}}},t)}async copyLink(){let t=this.lab.link(this.lab.films().map(({fingerprint:e})=>e??
""))??"";try{await navigator.clipboard.writeText(t),this.lab.notice.say("save.the_link_is_copied")}catch{this.show("save.the_link_to_this",t)}}async download(t){
let e=this.lab.film();this.lab.notice.say(t.endsWith("mp4")?"save.the_film_is_being":{key:"save.fetching_name",values:{name:t}}),Gt(await this.lab.backend.file(
t,e.query),`hophoop-${t}`),this.lab.notice.say({key:"save.name_is_there",values:{name:t}})}async picture(t,e){Gt(await e(this.lab),`hophoop.${t}`)}async record(){
Gt(await ca(this.lab),"hophoop.webm"),this.lab.notice.say("save.the_film_is_there")}async code(){let{python:t,toml:e}=this.lab.backend.code(this.lab.film().scenario);
this.show("save.the_same_motion_in",t,"save.the_scenario_as_a",e)}show(...t){let e=[];for(let s=0;s<t.length;s+=2){let o=t[s+1],i=c("button",{type:"button"},"mo\
tion.copy");i.onclick=async()=>{await navigator.clipboard?.writeText(o).catch(()=>{}),E(i,"motion.copied")},e.push(c("header",{},c("h2",{},t[s]),i),c("pre",{tabindex:"\
0"},c("code",{},document.createTextNode(o))))}this.dialog.replaceChildren(...e,c("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"table.c\
lose")),this.dialog.showModal()}};var ma=120,Fs=class{constructor(t,e,s,o,i,r,a,l,h,m,u){this.context=t;this.width=e;this.height=s;this.film=o;this.options=r;this.look=a;this.colors=l;this.common=
u;this.top=0;this.pose=o.at(i);let p=o.radius,{left:d,right:f}=o.extent,{top:_}=u;this.cosine=Math.cos(o.slope),this.sine=Math.sin(o.slope);let g=2*u.radius+Math.
min(_,6*u.radius),b=Math.min(.66*s/g,.36*e/u.radius);if(r.whole){let y=(f-d)*this.cosine+2.6*p,k=(f-d)*Math.abs(this.sine)+2.6*p+_;this.scale=Math.min(e/y,.86*s/
k,b)*h,this.focus=[.5*(d+f),0],this.place=[.5*e+m[0],(o.slope?.62:.8)*s+m[1]]}else this.scale=b*h,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.
place=[(e<520?.6:.46)*e+m[0],.82*s+m[1]]}point(t,e){let s=t-this.focus[0],o=e-this.focus[1];return[this.place[0]+this.scale*(s*this.cosine+o*this.sine),this.place[1]-
this.scale*(o*this.cosine-s*this.sine)]}unpoint(t,e){let s=(t-this.place[0])/this.scale,o=-(e-this.place[1])/this.scale;return[this.focus[0]+s*this.cosine-o*this.
sine,this.focus[1]+s*this.sine+o*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&this.
forces()}ground(){let{context:t,look:e,width:s,height:o}=this,i=(Math.hypot(s,o)*1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[r,a]=this.point(
this.focus[0]-i,0),[l,h]=this.point(this.focus[0]+i,0),m=[-this.sine*4e3,this.cosine*4e3];t.fillStyle=e.ground,t.beginPath(),t.moveTo(r,a),t.lineTo(l,h),t.lineTo(
l+m[0],h+m[1]),t.lineTo(r+m[0],a+m[1]),t.fill(),t.strokeStyle=e.soft,t.lineWidth=1.5,t.beginPath(),t.moveTo(r,a),t.lineTo(l,h),t.stroke();let u=z(s/this.scale,s/
(90*e.px));t.fillStyle=e.soft,t.font=`${11*e.px}px ${e.font}`,t.textAlign="center",t.lineWidth=1;let p=Math.ceil((this.focus[0]-i)/u),d=Math.min(Math.floor((this.
focus[0]+i)/u),p+400);for(let f=p;f<=d;f++){let[_,g]=this.point(f*u,0);_<-40||_>s+40||(t.beginPath(),t.moveTo(_,g),t.lineTo(_-6*this.sine,g+6*this.cosine),t.stroke(),
t.fillText(`${it(f*u,u)} m`,_-18*e.px*this.sine,g+8+10*e.px*this.cosine))}}traces(){let{film:t,context:e,look:s,colors:o}=this,i=t.radius,r=this.options.ahead?t.
duration:this.pose.t,a=(l,h,m,u)=>{e.strokeStyle=h,e.lineWidth=m,e.lineJoin="round",e.beginPath();let p=!1,d=(f,_,g)=>{let[b,y]=this.point(f+l*Math.sin(g),i+_+l*
Math.cos(g));p?e.lineTo(b,y):e.moveTo(b,y),p=!0};for(let f of t.pieces()){let{x:_,height:g,angle:b,mode:y}=f.film.columns;for(let k=f.from;k<f.to&&f.film.t[k]<=
r;k++)u===void 0||y[k]===3===u?d(_[k],g[k],b[k]):p=!1}!this.options.ahead&&(u===void 0||this.pose.mode==="H"===u)&&d(this.pose.x,this.pose.height,this.pose.angle),
e.stroke()};e.globalAlpha=this.options.ahead?.45:1,a(i,s.ink,1.3),a(t.eccentricity*i,o.gravity_center,1.8,!1),a(t.eccentricity*i,o.airborne,2.4,!0),e.globalAlpha=
1}mark(t,e){let{context:s,film:o,pose:i,scale:r}=this,[a,l]=this.point(i.x,o.radius+i.height);s.strokeStyle=e,s.lineWidth=3,s.beginPath(),s.arc(a,l,Math.max(o.radius*
r-v(.07*o.radius*r,2,14)-3,2),0,2*Math.PI),s.stroke(),s.fillStyle=e,s.font=`700 ${17*this.look.px}px ${this.look.font}`,s.textAlign="center",s.fillText(t,a-14,l+
20)}ghost(t){let{context:e,film:s,look:o,width:i,scale:r}=this,a=s.radius,[l,h]=this.point(t.x,a+t.height),m=a*r;if(e.strokeStyle=e.fillStyle=o.ink,e.lineWidth=
1.5,e.beginPath(),l>-.5*m&&l<i+.5*m){let _=this.point(t.x+a*Math.sin(t.angle),a+t.height+a*Math.cos(t.angle));e.setLineDash([6,5]),e.arc(l,h,m,0,2*Math.PI),e.moveTo(
l,h),e.lineTo(..._),e.stroke(),e.setLineDash([]),e.beginPath(),e.arc(..._,v(.1*m,4,16),0,2*Math.PI),e.fillStyle=o.paper,e.fill(),e.stroke();return}let u=l<0?-1:
1,p=u<0?6:i-6,d=v(h,24,this.height-24);e.moveTo(p,d),e.lineTo(p-14*u,d-9),e.lineTo(p-14*u,d+9),e.fill(),e.font=`600 ${12*o.px}px ${o.font}`,e.textAlign=u<0?"lef\
t":"right",e.lineWidth=3,e.strokeStyle=o.paper;let f=`${x(t.x-this.focus[0],3)} m`;e.strokeText(f,p-20*u,d+4*o.px),e.fillText(f,p-20*u,d+4*o.px)}hoop(){let{film:t,
pose:e,context:s,look:o,colors:i,scale:r}=this,a=t.radius,l=v(.07*a*r,2,14),h=a-.5*l/r,m=[e.x,a+e.height],u=(g,b=h)=>this.point(m[0]+b*Math.sin(g),m[1]+b*Math.cos(
g));if(s.lineCap="butt",o.dark&&(s.strokeStyle=o.soft,s.lineWidth=l+2,s.beginPath(),s.arc(...this.point(m[0],m[1]),h*r,0,2*Math.PI),s.stroke()),this.options.speed){
let g=this.common.speed;s.lineWidth=l;let b=2*Math.PI/ma;for(let y=0;y<ma;y++){let k=e.angle+y*b,M=Math.hypot(e.vx+a*e.omega*Math.cos(k+.5*b),e.vy-a*e.omega*Math.
sin(k+.5*b));s.strokeStyle=Ke[v(Math.round(255*M/g)||0,0,255)],s.beginPath(),s.moveTo(...u(k-.04*b)),s.lineTo(...u(k+1.04*b)),s.stroke()}}else s.strokeStyle=i.modes[e.
mode],s.lineWidth=l,s.beginPath(),s.arc(...this.point(m[0],m[1]),h*r,0,2*Math.PI),s.stroke();s.strokeStyle=o.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(
m[0],m[1])),s.lineTo(...u(e.angle)),s.stroke();let p=(g,b,y,k)=>{s.beginPath(),s.arc(...g,b,0,2*Math.PI),s.fillStyle=y,s.fill(),s.lineWidth=1.5,s.strokeStyle=k,
s.stroke()};p(this.point(m[0],m[1]),2.5,o.soft,o.soft);let d=t.scenario.hoop.parts;d?this.parts(d,m):p(u(e.angle),v(.1*a*r,4,16),o.ink,o.paper);let f=t.eccentricity*
a,_=this.point(m[0]+f*Math.sin(e.angle),m[1]+f*Math.cos(e.angle));p(_,v(.05*a*r,3.5,7),e.mode==="H"?i.airborne:i.gravity_center,o.paper)}parts(t,e){let{film:s,pose:o,
context:i,look:r,scale:a}=this,h=t.reduce((m,u)=>m+u.mass*(u.at??0),0)<0?-1:1;i.strokeStyle=r.ink;for(let m of t){let u=h*(m.at??0),p=this.point(e[0]+u*Math.sin(
o.angle),e[1]+u*Math.cos(o.angle));if(i.fillStyle=r.ink,i.lineWidth=1,i.beginPath(),m.shape==="ring")i.globalAlpha=.22,i.arc(...p,m.outer_radius*a,0,2*Math.PI),
i.arc(...p,m.inner_radius*a,0,2*Math.PI,!0),i.fill(),i.globalAlpha=1;else if(m.shape==="rod"){let d=.5*m.length,f=_=>this.point(e[0]+_*Math.sin(o.angle),e[1]+_*
Math.cos(o.angle));i.lineWidth=4,i.moveTo(...f(u-d)),i.lineTo(...f(u+d)),i.stroke()}else{let d=m.shape==="disk"?m.radius*a:v(.08*s.radius*a,3,12);i.globalAlpha=
m.shape==="disk"?.55:1,i.arc(...p,d,0,2*Math.PI),i.fill(),i.globalAlpha=1}}}forces(){let{film:t,pose:e,colors:s}=this,o=t.radius,i=t.mass*(t.gravity||9.81),r=l=>.55*
o*l/i;if(e.mode==="H"||!(e.normal_force>0))return;let a=[e.x,e.height];this.arrow(a,[0,r(e.normal_force)],s.normal_force,`N = ${x(e.normal_force,e.digits)} N`,!1),
this.arrow(a,[r(e.friction_force),0],s.friction_force,`F = ${x(e.friction_force,e.digits)} N`,!0)}arrow([t,e],[s,o],i,r,a){let{context:l,look:h,width:m}=this,u=2.2*
this.film.radius,p=Math.abs(s)>u||Math.abs(o)>u;[s,o]=[v(s,-u,u),v(o,-u,u)];let d=this.point(t,e),f=this.point(t+s,e+o),_=Math.hypot(f[0]-d[0],f[1]-d[1]);if(_<2)
return;let g=(f[0]-d[0])/_,b=(f[1]-d[1])/_,y=Math.min(11,_);for(let[O,G]of[[h.paper,6],[i,3]])l.strokeStyle=O,l.fillStyle=O,l.lineWidth=G,l.beginPath(),l.moveTo(
...d),l.lineTo(f[0]-g*y,f[1]-b*y),l.stroke();if(l.beginPath(),l.moveTo(...f),l.lineTo(f[0]-g*y-b*y*.5,f[1]-b*y+g*y*.5),l.lineTo(f[0]-g*y+b*y*.5,f[1]-b*y-g*y*.5),
l.fill(),p){let[O,G]=[d[0]+.55*g*_,d[1]+.55*b*_];l.strokeStyle=h.paper,l.lineWidth=2,l.beginPath();for(let H of[-3,3])l.moveTo(O+g*(H-3)-b*7,G+b*(H-3)+g*7),l.lineTo(
O+g*(H+3)+b*7,G+b*(H+3)-g*7);l.stroke()}l.font=`600 ${12*h.px}px ${h.font}`;let k=l.measureText(r).width;l.lineWidth=3,l.strokeStyle=a?h.ground:h.paper,l.textAlign=
"left";let M=a?[d[0]-.5*k-32*h.px*this.sine,d[1]+32*h.px*this.cosine]:[f[0]+12,v(f[1]+4,16,d[1]-.36*this.film.radius*this.scale)];M[0]=v(M[0],4,m-k-4),l.strokeText(
r,M[0],M[1]),l.fillText(r,M[0],M[1])}};var Is=class{constructor(t,e){this.canvas=t;this.onview=e;this.zoom=1;this.shift=[0,0];this.views=[];this.fixed=null;this.pointed=null;this.grab=()=>!1,this.over=
()=>{},t.addEventListener("pointerdown",s=>this.drag(s)),this.pinched=yt(t,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>t.parentElement})}reset(){this.
zoom=1,this.shift=[0,0],this.onview()}pan(){let{width:t,height:e}=this.canvas.getBoundingClientRect();return[this.shift[0]/(t||1),this.shift[1]/(e||1)]}look(t=1,[
e,s]=[0,0]){let{width:o,height:i}=this.canvas.getBoundingClientRect();this.zoom=t,this.shift=[e*o,s*i]}zoomBy(t){this.zoom=v(this.zoom*t,.05,60),this.onview()}drag(t){
if(this.grab(t))return;let e=[t.clientX,t.clientY],s=this.shift;X(this.canvas,t,o=>{this.pinched()||(this.shift=[s[0]+o.clientX-e[0],s[1]+o.clientY-e[1]],this.onview())})}draw(t,e,s,o,i){
let{context:r,width:a,height:l}=B(this.canvas);r.clearRect(0,0,a,l),!(a<40||l<40)&&(this.views=this.paint(r,a,l,t,e,s,o,i))}paint(t,e,s,o,i,r,a,l){let h=s/o.length,
m={top:Math.max(...o.map(u=>u.extent.top)),radius:Math.max(...o.map(u=>u.radius)),speed:Math.max(...o.map(u=>u.extent.speed))};return o.map((u,p)=>{t.save(),t.beginPath(),
t.rect(0,p*h,e,h),t.clip(),t.translate(0,p*h);let d=new Fs(t,e,h,u,i,r,a,l,this.zoom,this.shift,m);return d.top=p*h,d.scale=this.fixed??d.scale,d.draw(),this.pointed?.
lane===p&&d.ghost(u.at(this.pointed.time)),this.over(d,p),o.length>1&&(d.mark("AB"[p],pt(p,a.dark)),t.fillStyle=pt(p,a.dark),t.font=`700 ${17*a.px}px ${a.font}`,
t.textAlign="left",t.fillText("AB"[p],12,h-12)),t.restore(),p>0&&(t.fillStyle=a.line,t.fillRect(0,p*h-.5,e,1)),d})}};var Vc=["player.hoop","table.mode","column.time","column.angle","v","R θ̇","player.gap"],$s=class{constructor(t,e){this.colors=t;this.onview=e;this.options={traces:!0,
forces:!0,speed:!0,whole:!1,three:!1,ahead:!1};this.plane=c("canvas",{class:"stage-canvas"});this.space=c("canvas",{class:"stage-canvas",hidden:!0});this.flat=new Is(
this.plane,this.onview);this.deep=null;this.outputs=Vc.map(o=>({name:c("dt",{},o),value:c("dd",{})})),this.outputs[1].value.className="mode",this.fastest=c("spa\
n",{}),this.legend=c("div",{class:"legend","aria-hidden":"true"},c("i",{style:`background: linear-gradient(90deg, ${Ke.filter((o,i)=>i%15===0).join(",")})`}),c(
"span",{},"0"),c("span",{},"player.rim_speed"),this.fastest);let s=(o,i)=>c("span",{},c("i",{class:"dot",style:`background:${o}`}),i);this.order=c("span",{hidden:!0},
"player.a_in_front_b"),this.element=c("div",{class:"stage",role:"figure","aria-label":"player.the_hoop",tabindex:"0"},this.plane,this.space,c("dl",{class:"reado\
ut","aria-hidden":"true"},this.outputs.flatMap(({name:o,value:i})=>[o,i])),this.legend,c("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","player.\
load"),s(t.gravity_center,"player.centre_of_gravity"),s(t.airborne,"player.the_same_in_flight"),this.order))}canvas(){return this.options.three?this.space:this.
plane}draw(t,e,s,{look:o,inks:i}){let{options:r}=this;this.legend.hidden=!r.speed,this.order.hidden=!(r.three&&t.length>1),this.fastest.textContent=`≥ ${x(Math.
max(...t.map(a=>a.extent.speed)),2)} m/s`,r.three?this.deep?.draw(t,s.time,r,o,i,s.playing):(this.flat.pointed=s.pointed===null?null:{time:s.pointed,lane:e},this.
flat.draw(t,s.time,r,o,i)),this.read(t,e,s.time)}sharp(t,e){let{look:s,inks:o}=t.theme;return this.deep?.draw(t.films(),t.clock.time,this.options,s,o,!1,e),this.
space}read(t,e,s){let o=t[e],i=o.at(s),r=[t.length>1?"AB"[e]:"",T(this.colors.mode_names[i.mode]),rt(`${i.t.toFixed(3)} s`),q(i.angle),N(x(i.vx,i.digits),"m/s"),
N(x(i.omega*o.radius,i.digits),"m/s"),i.height>0?At(i.height):"0"];for(let[h,m]of r.entries()){let{value:u}=this.outputs[h];u.textContent!==m&&(u.textContent=m)}
let[a,l]=this.outputs;a.value.hidden=a.name.hidden=t.length<2,l.value.style.setProperty("--mode",this.colors.modes[i.mode])}describe(t){dt(this.element,"aria-la\
bel",["player.the_hoop_2",...t.flatMap(e=>[" ",e.summary])])}async turn(t){let e=this.deep?null:await Ns(oa()),s=()=>{this.plane.hidden=this.options.three,this.
space.hidden=!this.options.three};this.options.three=!this.options.three,s();try{e&&(this.deep??=new e.Stage3D(this.space,this.onview)),t()}catch(o){throw this.
options.three=!1,s(),o}}view(){let{options:t,flat:e,deep:s}=this;return{options:t,zoom:e.zoom,pan:e.pan(),from:s?.from()}}restore({options:t,zoom:e,pan:s,from:o}){
if(t){let{three:i,...r}=t;Object.assign(this.options,r)}this.flat.look(e,s),o&&this.deep?.look(o)}zoom(t){this.options.three?this.deep?.zoomBy(t):t?this.flat.zoomBy(
t):this.flat.reset()}};var js=class{constructor(t){this.clock=t;this.listed=null;this.summary=c("p",{class:"summary"});this.doubt=c("p",{class:"hint",hidden:!0});this.list=c("ol",{class:"\
story-list"});this.heading=c("h2",{},"motion.what_happens");this.signature=c("span",{});this.compared=c("span",{});this.fingerprint=c("p",{class:"hint fingerpri\
nt"},this.signature,this.compared);this.live=c("div",{class:"spoken",role:"status","aria-live":"polite"});this.element=c("section",{class:"story","aria-label":"\
motion.the_motion_in_words"},this.heading,this.summary,this.doubt,this.list,this.fingerprint,this.live)}draw(t,e,s,o){this.film=t[e],E(this.heading,t.length>1?{
key:"motion.what_happens_to_hoop",values:{hoop:"AB"[e]}}:"motion.what_happens"),this.summary.replaceChildren(...t.flatMap((i,r)=>[t.length>1?c("b",{},`${"AB"[r]}\
: `):"",c("span",{},i.summary),i.status==="event_limit"||i.shortened?c("span",{}," ","motion.not_all_events_are"):"",r+1<t.length?c("br"):""])),this.doubt.hidden=
!this.film.doubt,E(this.doubt,this.film.doubt),this.listed!==this.film&&this.fill(s),this.sign(),this.compared.replaceChildren(...o.flatMap(({same:i,text:r})=>[
" ",c("span",{class:i?"same":"differs"},r)])),this.cursor(this.clock.time)}fill(t){this.listed=this.film,this.current=-1,this.items=this.film.story.map(e=>c("li",
{},c("button",{type:"button",onclick:()=>this.clock.seek(e.t),onpointerenter:()=>this.clock.point(e.t),onpointerleave:()=>this.clock.point(null),onfocus:()=>this.
clock.point(e.t),onblur:()=>this.clock.point(null)},c("i",{class:"dot",style:`background:${t.modes[e.mode]}`,"aria-hidden":"true"}),c("span",{class:"when"},`${x(
e.t,4)} s`),c("span",{},e.text)))),this.list.replaceChildren(...this.items),this.clock.pointed=null}sign(){let{fingerprint:t}=this.film;t!==this.signed&&(this.signed=
t,this.signature.replaceChildren(...Yc(t)))}say(t){E(this.live,t)}announce(t){this.say(t.flatMap((e,s)=>s?[" ",e.summary]:[e.summary]))}cursor(t){let{story:e}=this.
film,s=-1;for(let i=0;i<e.length&&e[i].t<=t+1e-9;i++)s=i;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add(
"now"),this.items[this.current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let o=this.items[s];if(o){let i=o.
offsetTop-this.list.offsetTop;(i<this.list.scrollTop||i+o.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=i-.4*this.list.clientHeight)}}};
function Yc(n){if(!n)return[c("span",{},"motion.no_fingerprint_this_motion")];let t=c("code",{},document.createTextNode(n)),e=c("button",{type:"button"},"motion\
.copy");return e.onclick=async()=>{try{await navigator.clipboard.writeText(n),E(e,"motion.copied")}catch{getSelection()?.selectAllChildren(t)}},[c("span",{title:"\
motion.a_hash_of_all"},"motion.fingerprint")," ",t," ",e]}var qs=class{constructor(){this.list=c("dl",{});this.heading=c("h2",{},"motion.what_theory_says");this.
element=c("section",{class:"theory"},this.heading,this.list)}draw(t,e=""){E(this.heading,e?{key:"motion.what_theory_says_of",values:{hoop:e}}:"motion.what_theor\
y_says"),this.list.replaceChildren(...t.flatMap(({label:s,text:o})=>[c("dt",{},s),c("dd",{},o)]))}};var ua="hophoop-theme",Jc=["gravity_center","airborne","normal_force","friction_force"],Ds=class{constructor(t,e,s,o){this.root=t;this.colors=e;this.hosted=s;this.
changed=o;this.chosen=null;this.media=matchMedia("(prefers-color-scheme: dark)");this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=Wn(t),this.inks={...e},this.read()}mark(){let t=this.hosted?st(ua):null;this.root.dataset.theme=this.chosen??t??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=Wn(this.root),this.inks={...this.colors};for(let t of Jc)
this.inks[t]=de(this.colors[t],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&nt(ua,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};var Bs=class{constructor(t){this.clock=t;this.window=null;this.canvas=c("canvas",{class:"timeline-canvas"});this.tip=c("div",{class:"tip",hidden:!0});this.element=
c("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"player.time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),this.
element.addEventListener("pointerdown",e=>this.scrub(e)),this.element.addEventListener("pointermove",e=>this.hover(e)),this.element.addEventListener("pointerlea\
ve",()=>this.tip.hidden=!0),this.pinched=yt(this.element,{zoom:(e,s)=>this.zoom(1/e,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let t=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=t[1]?t:qt(this.window,t)}zoom(t,e){let[s,o]=this.ends(),i=1e-6*this.clock.duration,
r=Math.max((o-s)*t,i),a=(e-s)/(o-s);this.window=r<this.clock.duration?qt([e-a*r,e+(1-a)*r],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[t,e]=this.ends(),{time:s,duration:o}=this.clock;if(s>=t&&s<=e)return;let i=e-t;this.window=qt(s>e?[s-.1*i,s+.9*i]:[s-.5*i,s+.5*i],[0,o])}timeAt(t){let e=this.
canvas.getBoundingClientRect(),[s,o]=this.ends();return s+v((t.clientX-e.left)/e.width,0,1)*(o-s)}scrub(t){t.preventDefault(),this.element.focus({preventScroll:!0});
let e=this.clock.playing;this.clock.playing=!1;let s=o=>!this.pinched()&&this.clock.seek(this.timeAt(o));s(t),X(this.element,t,s,()=>e&&this.clock.play(!0))}hover(t){
let e=this.timeAt(t),s=this.nearest(e,8),o=s?`${T(kt(s.kind))} · ${x(s.t,5)} s · ${x(s.angle*180/Math.PI,4)}°`:`${x(e,4)} s`;this.tip.textContent=o,this.tip.
hidden=!1;let i=this.canvas.getBoundingClientRect();this.tip.style.left=`${v(t.clientX-i.left,70,i.width-70)}px`}nearest(t,e){let[s,o]=this.ends(),i=e*(o-s)/(this.
canvas.getBoundingClientRect().width||1),r=null;for(let a of this.films??[])for(let l of a.events){if(l.kind==="end")continue;let h=Math.abs(l.t-t);h<=i&&(!r||h<
Math.abs(r.t-t))&&(r=l)}return r}draw(t,e,s){this.films=t;let{context:o,width:i,height:r}=B(this.canvas,e.px);this.keep();let[a,l]=this.ends(),h=b=>(b-a)/(l-a)*
i;o.clearRect(0,0,i,r);let m=15,u=(r-15)/t.length-m;t.forEach((b,y)=>{let k=m+y*(m+u);for(let{mode:M,from:O,wide:G}of or(b.phases,h,i)){let H=s.modes[M];o.fillStyle=
H,o.fillRect(O,k,G,u-2),this.named(o,T(s.mode_names[M]),O,G,k,u-2,H,e)}b.duration<l&&(o.fillStyle=e.line,o.fillRect(Math.max(h(b.duration),0),k,i,u-2)),this.marks(
o,b,h,k,i,e),t.length>1&&(o.fillStyle=pt(y,e.dark),o.font=`700 12px ${e.font}`,o.textAlign="right",o.fillText("AB"[y],i-1,k-4))});let p=z(l-a,i/60);o.fillStyle=
e.soft,o.font=`10.5px ${e.font}`;let d=at(a,l,i/60);for(let b of d){let y=h(b);o.textAlign=y<14?"left":y>i-14?"right":"center",o.fillText(it(b,p)+(b===d[0]?" s":
""),y,r-3)}let{pointed:f}=this.clock;if(f!==null&&f>=a&&f<=l){let b=v(h(f),2,i-2);o.lineWidth=2;for(let[y,k]of[[e.paper,5],[e.ink,1]])o.fillStyle=y,o.fillRect(b-
.5*k,m-4,k,r-m-9),o.fillRect(b-5-.5*k,m-4,10+k,k)}let _=v(h(this.clock.time),6,i-6),g=v(h(this.clock.time),1,i-1);o.fillStyle=e.ink,o.fillRect(g-1,m-4,2,r-m-9),
o.beginPath(),o.moveTo(_-6,m-10),o.lineTo(_+6,m-10),o.lineTo(g,m-1),o.fill(),this.tell(t,s)}tell(t,e){let{time:s,duration:o,playing:i}=this.clock,a=t.map((l,h)=>{
let m=T(e.mode_names[l.at(s).mode]);return t.length>1?`${"AB"[h]} ${m}`:m}).join(", ");i&&a===this.said||(this.said=a,this.element.setAttribute("aria-valuemax",
o.toFixed(3)),this.element.setAttribute("aria-valuenow",s.toFixed(3)),this.element.setAttribute("aria-valuetext",T("player.time_seconds_what",{time:x(s,4),what:a})))}named(t,e,s,o,i,r,a,l){
t.font=`11px ${l.font}`,!(r<13||t.measureText(e).width+8>o)&&(t.fillStyle=Li(a),t.textAlign="center",t.textBaseline="middle",t.fillText(e,s+.5*o,i+.5*r+1),t.textBaseline=
"alphabetic")}marks(t,e,s,o,i,r){t.font=`11px ${r.font}`,t.textAlign="center";let a=e.events.filter(({kind:l})=>l!=="start"&&l!=="end").map(({kind:l,t:h})=>({kind:l,
x:s(h)})).filter(({x:l})=>l>=-1&&l<=i+1);if(t.fillStyle=r.panel,a.length<i/6)for(let{x:l}of a)t.fillRect(l-.5,o,1,5);t.fillStyle=r.ink;for(let{mark:l,x:h}of nr(
a))t.fillText(l,v(h,6,i-6),o-4)}};var Xc=1/60,Qc=[["traces","player.traces","player.traces_t"],["forces","player.forces","player.forces_f"],["speed","player.rim_speed_2","player.rim_speed_c"],["\
whole","player.whole_path","player.whole_path_w"],["three","3D","player.in_space_3"]],Pt=(n,t,e)=>c("button",{type:"button",title:t,"aria-label":t,onclick:e},n),
pa=(n,t)=>c("span",{},c("span",{"aria-hidden":"true"},`${n} `),t),zs=class{constructor(t,e,s,o,i){this.clock=t;this.films=e;this.say=o;this.tell=i;this.titled="";
this.playButton=Pt(W("play"),"player.play_space",()=>t.play()),this.playButton.classList.add("play"),this.speeds=c("select",{"aria-label":"player.speed_of_the_f\
ilm",onchange:()=>{t.speed=Number(this.speeds.value)}},_e.map(r=>c("option",{value:String(r)},`${r}×`))),this.speeds.value="1",this.switches=new Map(Qc.map(([r,
a,l])=>[r,c("button",{type:"button",class:"switch",title:l,onclick:()=>s(r)},a)])),this.row=c("div",{class:"buttons switches"},[...this.switches.values()]),this.
element=c("div",{class:"transport"},c("div",{class:"buttons"},Pt(W("start"),"player.to_the_start_home",()=>t.seek(0)),Pt(W("previous"),"player.previous_event_sh\
ift",()=>this.jump(-1)),Pt(W("back"),"player.one_frame_back",()=>this.nudge(-1)),this.playButton,Pt(W("on"),"player.one_frame_on",()=>this.nudge(1)),Pt(W("next"),
"player.next_event_shift",()=>this.jump(1))),c("div",{class:"buttons jumps"},Pt(pa("▲","mode.flight"),"player.to_the_next_flight",()=>this.jump(1,"takeoff")),
Pt(pa("▼","event.impact"),"player.to_the_next_landing",()=>this.jump(1,"impact"))),this.speeds,this.row)}show(t){let{clock:e,playButton:s}=this;for(let[i,r]of this.
switches)r.setAttribute("aria-pressed",String(t[i]));let o=e.playing?"player.pause_space":"player.play_space";this.titled!==o&&(this.titled=o,s.replaceChildren(
W(e.playing?"pause":"play")),dt(s,"title",o),dt(s,"aria-label",o)),this.speeds.value!==String(e.speed)&&(this.speeds.value=String(e.speed))}nudge(t){this.clock.
playing=!1,this.clock.seek(this.clock.time+t*Xc*Math.min(this.clock.speed,1))}jump(t,e=null){this.clock.playing=!1;let s=this.films().flatMap((m,u)=>m.events.map(
p=>({event:p,lane:u}))).filter(({event:m})=>!e||(e==="impact"?m.kind===e:Qi(m))).sort((m,u)=>m.event.t-u.event.t),o=this.clock.time,i=t>0?s.find(({event:m})=>m.
t>o+1e-9):s.findLast(({event:m})=>m.t<o-1e-9);if(!i&&e&&(i=s[0]),!i){e&&this.say(e==="takeoff"?"player.this_motion_has_no":"player.this_motion_has_no_landing");
return}this.clock.seek(i.event.t);let{event:r,lane:a}=i,h={key:"player.what_at_angle_time",values:{what:kt(r.kind),angle:q(r.angle),time:x(r.t,4)}};this.tell(this.
films().length>1?[["hoops.hoop_a","hoops.hoop_b"][a],": ",h]:h)}};var da="hophoop-steps",Yt=class{constructor(t,e,s,{hosted:o=!1,panels:i=null,onmotion:r=()=>{}}={}){this.root=t;this.backend=e;this.requested=!1;this.surrounding=
!1;this.taken=null;this.afterFrame=null;this.asked=null;this.frames=0;this.latencies=[];this.hosted=o,this.onmotion=r,Cr(t,o);let{colors:a}=s;this.known=s.presets,
this.sameness=new Os(s.presets),this.clock=new Je,this.motions=new Ts(e,{shown:m=>this.changed(m),refined:()=>this.request(),settled:()=>this.story.announce(this.
films()),noted:m=>this.noted(m),travelled:async m=>this.address?.travel(m),failed:(m,u)=>this.failed(m,u)}),this.notice=new Es,this.address=o?new Ve(this.motions,
this.notice,()=>this.link()):null,this.theme=new Ds(t,a,o,()=>this.show()),this.stage=new $s(a,()=>{this.request(),this.address?.soon()}),this.transport=new zs(
this.clock,()=>this.films(),m=>this.toggle(m),m=>this.notice.say(m),m=>this.story.say(m)),this.timeline=new Bs(this.clock),this.story=new js(this.clock),this.theory=
new qs,this.plots=new Rs(this.clock,a),this.phase=new Cs(e,this.clock,a),this.map=new Ms(e,s,{take:m=>{this.clock.time=0,this.motions.change(m,!0)},say:m=>this.
story.say(m),changed:()=>this.address?.soon()}),this.controls=new Ze(s.controls,(m,u)=>this.motions.change(m,u)),this.share=new Hs(this),this.singleKeys=new vs(
o),this.about=br(s.version,o),this.help=yr(this.about,a,this.singleKeys.element),this.view=new ys(t,o,()=>this.show()),this.hoops=new ws(m=>this.motions.choose(
m)),this.header=new _s(s.presets,this.share.menu,this.view.button,{take:m=>this.take(m),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.motions.
compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.extras=new gs(this),this.opening=new bs(this.clock,this.extras.grips.hint);let{player:l,
sticky:h}=Rr(this,i);this.player=l,this.sticky=h,o&&!location.search&&!location.hash&&this.extras.visit.offer(),this.later=ot(()=>this.fetchTheory(),120),this.frame=
this.frame.bind(this),this.clock.listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=Lr(this,o),this.sizes=new ResizeObserver(
()=>this.show())}async open(t,e={}){await this.motions.load(t),this.clock.duration=Math.max(...this.films().map(s=>s.duration)),this.sameness.expect(this.films(),
e.fingerprints??[]),this.view.open(this.films(),e),this.restore(e),this.begin(),this.hosted&&e.time===void 0&&!this.view.everything&&this.opening.begin(this.player)}begin(){
this.show();let t=this.hosted?Pi(da):null;this.motions.note(),t&&(this.motions.history.restore(t),this.noted("same")),this.sizes.observe(this.stage.element),this.
root.dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.opening.end(),this.map.close(),this.theme.close(),this.address?.
close(),this.sticky?.close(),this.sizes.disconnect(),this.deaf()}film(t=this.motions.active){return this.motions.film(t)}films(){return this.motions.films()}changed(t=null){
this.notice.clear(),this.show(t)}failed(t,e=[]){this.controls.refuse(e,K(t))||(this.notice.fail(t),this.controls.restore()),this.showPreset()}noted(t){this.header.
show(this.motions.history,this.motions.lanes.length>1),this.address?.write(t),this.hosted&&Ci(da,this.motions.history.written()),this.onmotion(this.film().query)}link(t=this.
sameness.expected(this.films())){let{clock:e,stage:s,map:o,extras:i}=this,{on:r,path:a}=i.more;return this.motions.link($i({time:e.time,...s.view(),more:r?a:void 0,
map:o.shown(),fingerprints:t}))}restore({time:t,map:e,options:s,more:o,...i}){let r=s?.three?this.toggle("three"):Promise.resolve();this.stage.restore({options:s,
...i}),r.then(()=>this.stage.restore(i)),e&&this.map.restore(e),o&&this.extras.more.turn(!0,o),t&&this.clock.seek(t)}showPreset(){let{query:t}=this.film(),e=this.
known.find(s=>s.query===t);this.header.presets.value=e?.key??"",E(this.hoops.text,e?.text??"")}async take(t){this.taken=t;try{let e=await this.backend.film({query:t.
query});if(this.taken!==t)return;this.clock.time=0,this.motions.replace(e),this.story.announce(this.films())}catch(e){this.failed(e)}}async load(t){try{let e=await this.
backend.film({query:t});this.clock.play(!1),this.clock.time=0,this.motions.replace(e)}catch(e){this.notice.fail(e)}}mark(t,e){this.root.classList.toggle(t,e)}marked(t){
return this.root.classList.contains(t)}travel(t){return this.motions.travel(t)}show(t=null){let{motions:e,clock:s}=this,o=this.films();if(!o.length)return;let i=o.
length>1;this.theme.read(),s.duration=Math.max(...o.map(r=>r.duration)),s.time=Math.min(s.time,s.duration),this.root.classList.toggle("two",i),this.header.show(
e.history,i),this.hoops.show(o.length,e.active),this.drawStage(),this.controls.show(this.film(),this.motions.waiting()),this.view.show(o),this.showPreset(),t!==
null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-t),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(
()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let t=this.films(),{active:e}=this.motions,{look:s,colors:o}=this.theme;this.plots.draw(
t,e,s),this.phase.draw(t,e,s),this.story.draw(t,e,o,this.sameness.of(t[e])),this.drawTime(),this.map.mark(this.film(),s),this.stage.describe(t),this.extras.changed(),
this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{time:t}=this.clock;this.surrounding||(this.timeline.
draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(t),this.phase.cursor(t),this.story.cursor(t),this.transport.show(this.stage.options))}request(){
this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(t){this.requested=!1,this.motions.lanes.length&&(this.clock.tick(t),this.motions.refine(
this.clock.time,this.clock.playing?2*this.clock.speed:0),this.drawStage(),this.drawTime(),this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&
this.request())}async fetchTheory(){let{scenario:t}=this.film();this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked;try{this.theory.draw(
await this.backend.theory(t,e),this.motions.name()),await this.phase.fetch(t,e)}catch(s){s.name!=="AbortError"&&this.theory.draw([{label:"–",text:K(s)}])}}async toggle(t){
let{options:e}=this.stage;if(t!=="three")e[t]=!e[t];else try{await this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(K(s))}this.transport.show(e),this.
address?.soon(),this.request()}};var Zc={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function Le(n){let t=n instanceof DataView||ArrayBuffer.isView(n)?n:new DataView(n),e=new Uint8Array(t.buffer,
t.byteOffset,t.byteLength);e.byteOffset%8&&(e=e.slice());let s=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(e.subarray(
4,4+s))),i={};for(let{name:r,type:a,shape:l,place:h}of o.arrays){let m=l.reduce((u,p)=>u*p,1);i[r]=new Zc[a](e.buffer,e.byteOffset+4+s+h,m)}return{header:o,arrays:i}}var tm=4,em="backend.the_server_does_not",Ws=class{constructor(t){this.base=t}async motion(t,e){let s={method:"POST",headers:{"Content-Type":"application/json"},
body:JSON.stringify(t),signal:e};return Le(await(await this.answered(new URL("lab/motion",this.base),s)).arrayBuffer())}async file(t,e){return(await this.answered(
new URL(`api/v1/files/${t}?${e}`,this.base))).blob()}async answered(t,e){for(let s=tm;;s--){let o=await fetch(t,e).catch(r=>{throw r.name==="AbortError"?r:new Error(
em)});if(o.ok)return o;let i=Number(o.headers.get("Retry-After"));if(o.status!==503||!(i>0)||s<=1){let{detail:r}=await o.json().catch(()=>({}));throw o.status===
503?new Z({key:"server.busy",values:{count:i}}):o.status===413?new Error("server.too_much"):o.status===500?new Error("server.failed"):r?new Error(r):new Z({key:"\
backend.the_server_answered_status",values:{status:o.status}})}await new Promise(r=>setTimeout(r,1e3*Math.min(i,10))),e?.signal?.throwIfAborted()}}},sm=2e4,nm=3e5,
Gs=class{constructor(t){this.model=t;this.waiting=new Map;this.number=0;this.view=Math.random().toString(36).slice(2);this.listen=(e,s)=>this.answered(e,s),t.on(
"msg:custom",this.listen)}answered(t,e){let s=t?.view===this.view&&this.waiting.get(t.number);s&&(clearTimeout(s.timer),this.waiting.delete(t.number),t.error?s.
reject(new Error(t.error)):s.resolve(Le(e[0])))}ask(t,e,s){let o=++this.number;return new Promise((i,r)=>{let a=setTimeout(()=>{this.waiting.delete(o),r(new Error(
"backend.the_notebooks_kernel_does"))},t==="file"?nm:sm);this.waiting.set(o,{resolve:i,reject:r,timer:a}),s?.addEventListener("abort",()=>{clearTimeout(a),this.
waiting.delete(o),r(new DOMException("superseded","AbortError"))}),this.model.send({view:this.view,number:o,call:t,body:e})})}motion(t,e){return this.ask("motio\
n",t,e)}async file(t,e){let{arrays:s}=await this.ask("file",{query:e,name:t});return new Blob([s.content])}async derivatives(){return(await this.ask("derivative\
s",{})).arrays.content}close(){this.model.off("msg:custom",this.listen)}};var bo=class extends Z{},yo=class{constructor(t,e){this.start=t;this.compiled=e;this.number=0;this.waiting=null;this.worker=this.begun()}begun(){let t=this.start();
return t.onmessage=({data:e})=>{if(e.number!==this.number||!this.waiting)return;let{resolve:s,reject:o}=this.waiting;this.waiting=null,e.error?o(new Error(e.error)):
s(e.answer)},t.onerror=e=>this.fail(new Error(e.message||"kernel.not_started")),t.postMessage({compiled:this.compiled}),t}fail(t){this.waiting?.reject(t),this.waiting=
null}stop(t){this.worker.terminate(),this.worker=this.begun(),this.fail(t)}ask(t,e,s){this.number++;let o=new Promise((i,r)=>{this.waiting={resolve:i,reject:r}});
return this.worker.postMessage({number:this.number,call:t,values:e},s),o}},Jt=class{constructor(t,e,s,o){this.start=t;this.compiled=e;this.size=s;this.limit=o;this.
idle=[];this.hired=0;this.queue=[]}hand(){let t=this.idle.pop();return t?Promise.resolve(t):this.hired<this.size?(this.hired++,Promise.resolve(new yo(this.start,
this.compiled))):new Promise(e=>this.queue.push(e))}release(t){let e=this.queue.shift();e?e(t):this.idle.push(t)}async ask(t,e,s,o=[]){s?.throwIfAborted();let i=await this.
hand(),r=()=>i.stop(new DOMException("superseded","AbortError")),a=setTimeout(()=>i.stop(new bo({key:"kernel.stopped",values:{time:this.limit/1e3}})),this.limit);
try{return s?.throwIfAborted(),s?.addEventListener("abort",r),await i.ask(t,e,o)}finally{clearTimeout(a),s?.removeEventListener("abort",r),this.release(i)}}close(){
for(let t of this.idle)t.worker.terminate()}};var Us=class{constructor(t){this.exports=t;this.rooms=new Map}room(t,e){let s=this.rooms.get(t);if(s&&s.bytes>=e)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(t);let o=this.exports.malloc(e);if(!o)throw new RangeError("kernel.no_memory");return this.rooms.set(t,{place:o,bytes:e}),o}floats(t,e){return new Float64Array(
this.exports.memory.buffer,t,e)}put(t,e){let s=this.room(t,8*Math.max(e.length,1));return this.floats(s,e.length).set(e),s}};var om=150,im=240,rm=6e3,[nb,fa,ga]=[0,1,2],am={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["fri\
ction_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_norm\
al","damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function wo(n,t,e){let{rows:s,count:o,duration:i}=t,[r,a]=(e??[0,i]).map(g=>Math.
min(Math.max(g,0),i)),l=Math.min(Math.max(Math.ceil((a-r)*om),im),rm),h=w.events.length,m=new Set;for(let g=0;g<=l&&i>0;g++)m.add(g===l?a:r+g*((a-r)/l));let u=new Set;
for(let g=0;g<o;g++){let b=Math.min(s[g*h+F.t],i);b>=r&&b<=a&&u.add(b)}for(let g of u)m.add(g);let p=Float64Array.from(m).sort(),d=Float64Array.from(u).filter(g=>g>
0).sort(),f=n.states(t,p,!1),_=n.states(t,d,!0);return vo(p,f,d,_)}function vo(n,t,e,s){let o=n.length+e.length,i=w.samples.length,r=new Float64Array(o),a=new Float64Array(
o*i),l=0,h=0;for(let u=0;u<n.length;u++)h<e.length&&e[h]<=n[u]&&(r[l]=e[h],a.set(s.subarray(h*i,(h+1)*i),l*i),l++,h++),r[l]=n[u],a.set(t.subarray(u*i,(u+1)*i),l*
i),l++;let m={t:r};for(let[u,p]of Object.entries(am)){let d=new Float64Array(o).fill(-0);for(let f of p)for(let _=0;_<o;_++)d[_]+=a[_*i+Xs[f]];m[u]=d}return m.mode=
lm(a,o,m.omega),m}function lm(n,t,e){let s=w.samples.length,o=new Float64Array(t),i=0;for(let r=t-1;r>=0&&!i;r--)i=Math.sign(e[r])||0;for(let r=t-1;r>=0;r--){i=
Math.sign(e[r])||i;let a=n[r*s+Xs.mode],l=a===fa?-1:a===ga?1:0;o[r]=l===0?a:l*i<0?fa:ga}return o}var hm=n=>n/2**32|0,cm=n=>n>>>0;function _a(n,t,e,s){let o=hm(e),i=cm(e);n.setUint32(t,s?i:o,s),n.setUint32(t+4,s?o:i,s)}function ba(n){return n instanceof Uint8Array||ArrayBuffer.isView(n)&&n.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in n&&n.BYTES_PER_ELEMENT===1}var xo=n=>n?
`"${n}" `:"";function mm(n,t=""){if(typeof n!="number")throw new TypeError(xo(t)+"expected number, got "+typeof n);if(!Number.isSafeInteger(n)||n<0)throw new RangeError(
xo(t)+"expected integer >= 0, got "+n);return n}function ko(n,t,e=""){if(ba(n)&&(t===void 0||n.length===t))return n;t!==void 0&&mm(t,"length");let s=ba(n),o=t!==void 0?` of length ${t}`:"",i=s?`length=${n.length}`:
`type=${typeof n}`,r=xo(e)+"expected Uint8Array"+o+", got "+i;throw s?new RangeError(r):new TypeError(r)}var um=(n,t)=>{if(n===null||typeof n!="object"||Array.isArray(n))throw new TypeError((t==="object"?"":`"${t}" `)+"expected object, got type="+typeof n)},ya=(n,t)=>{
um(n,t);let e=Object.getPrototypeOf(n);if(e!==Object.prototype&&e!==null)throw new TypeError(`"${t}" expected plain object`);if(Object.hasOwn(n,"__proto__"))throw new TypeError(
`"${t}.__proto__" is not allowed`)};function Mo(n,t=!0){if(n.destroyed)throw new Error("hash was destroyed");if(t&&n.finished)throw new Error("digest() was alre\
ady called")}function wa(n,t){ko(n,void 0,"output");let e=t.outputLen;if(!(n.length>=e))throw new RangeError('"output" expected length >= '+e)}function So(...n){for(let t=0;t<n.length;t++)n[t].fill(0)}function Ks(n){return new DataView(n.buffer,n.byteOffset,n.byteLength)}function lt(n,t){return n<<32-t|
n>>>t}function pm(n,t,e="opts"){return ya(n,"defaults"),t!==void 0&&ya(t,e),Object.assign(Object.create(null),n,t)}function va(n,t={}){if(typeof n!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof n);t=pm({},t,"info");let e=(o,i)=>n(i).update(o).digest(),s=n(void 0);return e.outputLen=s.outputLen,e.blockLen=
s.blockLen,e.canXOF=s.canXOF,e.create=o=>n(o),Object.assign(e,t),Object.freeze(e)}var xa=n=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,n])});function ka(n,t,e){return n&t^~n&e}function Ma(n,t,e){return n&t^n&e^t&e}var Vs=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(t,e,s,o){
this.blockLen=t,this.outputLen=e,this.padOffset=s,this.isLE=o,this.buffer=new Uint8Array(t),this.view=Ks(this.buffer)}update(t){Mo(this),ko(t);let{view:e,buffer:s,
blockLen:o}=this,i=t.length,r=!1;for(let a=0;a<i;){let l=Math.min(o-this.pos,i-a);if(l===o){let h=Ks(t);for(;o<=i-a;a+=o)this.process(h,a);r=!0;continue}s.set(a===
0&&l===i?t:t.subarray(a,a+l),this.pos),this.pos+=l,a+=l,this.pos===o&&(this.process(e,0),this.pos=0,r=!0)}return this.length+=t.length,r&&this.roundClean(),this}digestInto(t){
Mo(this),wa(t,this),this.finished=!0;let{buffer:e,view:s,blockLen:o,isLE:i}=this,{pos:r}=this;e[r++]=128,e.fill(0,r),this.padOffset>o-r&&(this.process(s,0),e.fill(
0)),_a(s,o-8,this.length*8,i),this.process(s,0),this.roundClean();let a=t===e?s:Ks(t),l=this.outputLen,h=l/4,m=this.get();if(l%4||h>m.length)throw new Error("in\
valid outputLen");for(let u=0;u<h;u++)a.setUint32(4*u,m[u],i)}digest(){let{buffer:t,outputLen:e}=this;this.digestInto(t);let s=t.slice(0,e);return this.destroy(),
s}_cloneIntoMeta(t){let{buffer:e,length:s,finished:o,destroyed:i,pos:r}=this;return t.destroyed=i,t.finished=o,t.length=s,t.pos=r,r&&t.buffer.set(e),t}clone(){return this.
_cloneInto()}},Sa=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var dm=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),Ct=new Uint32Array(64),To=class extends Vs{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(t,e){super(64,t,
8,!1),this.A=e[0]|0,this.B=e[1]|0,this.C=e[2]|0,this.D=e[3]|0,this.E=e[4]|0,this.F=e[5]|0,this.G=e[6]|0,this.H=e[7]|0}get(){let{A:t,B:e,C:s,D:o,E:i,F:r,G:a,H:l}=this;
return[t,e,s,o,i,r,a,l]}set(t,e,s,o,i,r,a,l){this.A=t|0,this.B=e|0,this.C=s|0,this.D=o|0,this.E=i|0,this.F=r|0,this.G=a|0,this.H=l|0}_cloneInto(t){return(t||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(t)}process(t,e){for(let u=0;u<16;u++,e+=4)Ct[u]=t.getUint32(e,!1);for(let u=16;u<64;u++){let p=Ct[u-15],d=Ct[u-
2],f=lt(p,7)^lt(p,18)^p>>>3,_=lt(d,17)^lt(d,19)^d>>>10;Ct[u]=_+Ct[u-7]+f+Ct[u-16]|0}let{A:s,B:o,C:i,D:r,E:a,F:l,G:h,H:m}=this;for(let u=0;u<64;u++){let p=lt(a,6)^
lt(a,11)^lt(a,25),d=m+p+ka(a,l,h)+dm[u]+Ct[u]|0,_=(lt(s,2)^lt(s,13)^lt(s,22))+Ma(s,o,i)|0;m=h,h=l,l=a,a=r+d|0,r=i,i=o,o=s,s=d+_|0}s=s+this.A|0,o=o+this.B|0,i=i+
this.C|0,r=r+this.D|0,a=a+this.E|0,l=l+this.F|0,h=h+this.G|0,m=m+this.H|0,this.set(s,o,i,r,a,l,h,m)}roundClean(){So(Ct)}destroy(){this.destroyed=!0,this.set(0,0,
0,0,0,0,0,0),So(this.buffer)}},Eo=class extends To{constructor(){super(32,Sa)}};var Ta=va(()=>new Eo,xa(1));var Ea=["t","x","height","angle","vx","vy","omega","slip"],fm=16,gm=0x7ff8000000000000n;function Aa(n,t){let e=new TextEncoder,s=Ta.create(),o=new DataView(new ArrayBuffer(
8*Ea.length)),i=new Uint8Array(o.buffer);for(let a=0;a<t;a++){let l=a*w.events.length;s.update(e.encode(w.kinds[n[l+F.kind]])),Ea.forEach((h,m)=>{let u=n[l+F[h]];
Number.isNaN(u)?o.setBigUint64(8*m,gm,!0):o.setFloat64(8*m,u+0,!0)}),s.update(i)}return Array.from(s.digest(),a=>a.toString(16).padStart(2,"0")).join("").slice(
0,fm)}function La(n,t){let e=new Map,s=new Float64Array(t);for(let o=0;o<t;o++){let i=_m(n.subarray(o*w.keys,(o+1)*w.keys));if(i===""){s[o]=Number.NaN;continue}let r=e.
get(i);r===void 0&&(r=e.size,e.set(i,r)),s[o]=r}return{values:s,sequences:[...e.keys()]}}function _m(n){let t="";for(let e of n){let s=e;for(let o=0;o<w.letters_a_key&&
s;o++){let i=Number(s&7n);s>>=3n,i&&(t+=i===w.more?"+":w.letters[i-1])}}return t}var bm=256,ym=2048,wm=4096,vm=2e5,xm=w.statuses.indexOf("buffer"),km=2,Mm=new Set(w.passing),Ao=n=>Number.isFinite(n)?n:null,Ys=class{constructor(t){this.kept=[];
this.turn=0;this.exports=new WebAssembly.Instance(t,{}).exports,this.exports._initialize?.(),this.memory=new Us(this.exports),this.mostEvents=bm,this.mostSegments=
ym,this.mostRows=wm}call(t,...e){let s=this.exports[t](...e);if(s)throw new Error(`The kernel ended ${t} with ${s}.`)}compute(t){let{memory:e}=this,s=w.events.length;
for(;;){let o=e.room("table",8*s*this.mostEvents),i=e.room("heads",8*w.heads.length);t.contact?this.computeCompliant(t,t.contact,o,i):this.computeRigid(t,o,i);let r=e.
floats(i,w.heads.length).slice(),a=r[ht.events];if(r[ht.status]===xm)this.makeRoom(t,r[ht.segments]);else if(a===this.mostEvents&&a<t.max_events)this.mostEvents*=
4;else{let l=e.floats(o,a*s).slice();return{given:t,head:r,rows:l,count:a,duration:r[ht.duration],segments:r[ht.segments]}}}}computeRigid(t,e,s){let{memory:o}=this,
i=o.put("cell",St(t)),r=o.room("events",w.event_bytes*this.mostEvents),a=o.room("segments",w.segment_bytes*this.mostSegments);this.call("motion",i,r,this.mostEvents,
a,this.mostSegments,e,s)}computeCompliant(t,e,s,o){let{memory:i}=this,r=i.put("cell",St(t)),a=i.put("contact",Zt(e)),l=i.room("events",w.event_bytes*this.mostEvents),
h=i.room("rows",w.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",r,a,l,this.mostEvents,vm,h,this.mostRows,s,o)}makeRoom(t,e){t.contact?this.
mostRows=e:this.mostSegments*=4}motion(t){return Pa(this.compute(t))}film(t){let e=this.compute(t),[s,o]=t.contact?["rows",w.compliant_segment_bytes]:["segments",
w.segment_bytes],i=this.memory.room(s,8),r=new Uint8Array(this.exports.memory.buffer,i,o*e.segments).slice();return{motion:Pa(e),columns:wo(this,e),pieces:r}}instant(t,e,s){
let o=e.length/(t.contact?w.compliant_segment_bytes:w.segment_bytes);this.memory.put("cell",St(t)),t.contact&&this.memory.put("contact",Zt(t.contact));let i=Float64Array.
of(s),r=this.states({given:t,segments:o},i,!1,this.placeOf(e)),a=new Float64Array(0);return vo(i,r,a,a)}placeOf(t){let e=this.kept.find(i=>i.pieces===t);if(e)return e.
place;let{turn:s}=this;this.turn=(s+1)%km;let o=this.memory.room(`pieces ${s}`,Math.max(t.length,1));return new Uint8Array(this.exports.memory.buffer,o,t.length).
set(t),this.kept[s]={pieces:t,place:o},o}columns(t,e){return wo(this,this.compute(t),e)}samples(t,e){let s=this.states(this.compute(t),e,!1),o=w.samples.length;
return Object.fromEntries(w.samples.map((i,r)=>[i,Float64Array.from(e,(a,l)=>s[l*o+r])]))}states(t,e,s,o){return this.rows("samples",w.samples.length,t,e,s,o)}margins(t,e,s=!1){
if(t.contact)throw new TypeError("A compliant contact has no such rules.");let o=w.margins.length,i=this.rows("margins",o,this.compute(t),e,s);return Object.fromEntries(
w.margins.map((r,a)=>[r,Float64Array.from(e,(l,h)=>i[h*o+a])]))}rows(t,e,s,o,i,r){let{memory:a}=this,l=o.length*e,h=a.put("times",o),m=a.room("states",8*Math.max(
l,1)),u=a.room("cell",8),p=[s.segments,h,o.length,Number(i),m];return s.given.contact?this.call("compliant_samples",u,a.room("contact",8),r??a.room("rows",8),...p):
this.call(t,u,r??a.room("segments",8),...p),a.floats(m,l).slice()}changes(t,e){let{memory:s}=this,o=this.compute(t),i=s.put("rates",e),r=this.side(o,i,1),{reason:a,
sided:l}=r,h=l||a==="border"||a==="contact"?this.side(o,i,-1):r;return{count:o.count,larger:r,smaller:h}}side({count:t,segments:e,head:s},o,i){let{memory:r}=this,
a=t*w.changes.length,l=r.room("changes",8*a),h=r.room("why",16),[m,u,p]=["cell","events","segments"].map(g=>r.room(g,8)),d=s[ht.doubt_from];this.call("changes",
m,o,1,i,u,t,p,e,d,l,h);let[f,_]=r.floats(h,2);return{rates:r.floats(l,a).slice(),reason:w.reasons[Math.max(f,0)],sided:f<0,failed:_}}thresholds(t){let{memory:e}=this,
s=e.put("cell",St(t)),o=e.room("answers",8*w.thresholds.length),i=t.rolling&&t.angle===0;this.call("thresholds",s,i?t.vx:Number.NaN,o);let r=e.floats(o,w.thresholds.
length),a=h=>{let m=r[w.thresholds.indexOf(h)];return Number.isNaN(m)?null:m},l=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(a);return{first_slip_speed:a(
"first_slip_speed"),first_hop_speed:a("first_hop_speed"),immediate_hop_speed:a("immediate_hop_speed"),needed_friction:a("needed_friction"),painleve_friction:a("\
painleve_friction"),painleve_angle:a("painleve_angle"),jam_angles:l.filter(h=>h!==null),stable_angle:a("stable_angle"),massless_loss_angle:a("massless_loss_angl\
e"),massless_loss_by_friction:a("massless_loss_by_friction")===1}}regions(t,[e,s,o,i],r,a){let{memory:l}=this,h=l.put("cell",St(t)),m=l.room("modes",r*a),u=l.room(
"sides",2*r);this.call("regions",h,e,s,o,i,r,a,m,u);let{buffer:p}=this.exports.memory;return{modes:new Uint8Array(p,m,r*a).slice(),paradox:Float32Array.from(new Int8Array(
p,u,2*r))}}map({count:t,rows:e},s,o){let{memory:i}=this,r=i.put("cells",e),a=i.room("numbers",8*t*w.numbers.length),l=i.room("words",4*t*w.words.length),h=i.room(
"keys",8*t*w.keys),{angle:m,stop:u,timed:p}=w.spans[o],d=w.wanted[s];this.call("map_cells",r,t,m??Number.NaN,u,p,d,a,l,h);let{buffer:f}=this.exports.memory;if(s===
"sequence")return La(new BigUint64Array(f,h,t*w.keys),t);let _=new Float64Array(t);if(s in Qs){let g=new Int32Array(f,l,t*w.words.length);for(let b=0;b<t;b++)_[b]=
g[b*w.words.length+Qs[s]]}else{let g=i.floats(a,t*w.numbers.length);for(let b=0;b<t;b++)_[b]=g[b*w.numbers.length+$o[s]]}return{values:_}}ideal(t){let e=this.memory.
room("answers",8*w.thresholds.length);return this.call("ideal_hoop",t,e),this.memory.floats(e,1)[0]}refused(t){let e=this.memory.put("cell",St(t)),s=this.memory.
put("contact",Zt(t.contact)),o=this.memory.room("answers",8*w.thresholds.length);this.call("refused",e,s,+!t.contact,o);let[i,r]=this.memory.floats(o,2);return[
i,r]}combine(t,e){let{memory:s}=this,o=s.put("parts",e.flatMap(Sm)),i=s.room("answers",8*w.thresholds.length),r=s.room("reaches",8*e.length);this.call("hoop_of_\
parts",t,o,e.length,i,r);let[a,l,h]=s.floats(i,3);return{mass:a,eccentricity:l,inertia_ratio:h,reaches:[...s.floats(r,e.length)]}}chosen(t){let e=this.memory.put(
"cell",St(t)),s=this.memory.put("contact",Zt(t.contact)),o=this.memory.room("answers",8*w.thresholds.length);this.call("compliance",e,s,o);let i=this.memory.floats(
o,w.chosen.length);return Object.fromEntries(w.chosen.map((r,a)=>[r,i[a]]))}};function Sm(n){let t=n.shape==="rod"?`${n.direction}_rod`:n.shape,e=w.shapes.indexOf(
t);return n.shape==="ring"?[e,n.mass,n.inner_radius,n.outer_radius,0]:n.shape==="disk"?[e,n.mass,n.radius,0,n.at]:n.shape==="rod"?[e,n.mass,n.length,0,n.at]:[e,
n.mass,0,0,n.at]}var Tm=["friction","impact_normal","impact_tangential","rolling_resistance"],Em=["kinetic","potential",...Tm,"residual"],Ca=["x","height","angl\
e","vx","vy","omega"];function Pa({given:n,head:t,rows:e,count:s,duration:o}){let i=w.events.length,r=Array.from({length:s},(m,u)=>Am(e.subarray(u*i,(u+1)*i))),
a=r[s-1],l=Object.fromEntries([...Em,...n.contact?["spring","damping"]:[]].map(m=>[m,t[ht[m]]])),h=Ao(t[ht.doubt_from]);return{status:w.statuses[t[ht.status]],sequence:Lm(
r),fingerprint:h===null?Aa(e,s):null,duration:o,events:r,final:{t:a.t,mode:a.to,...Object.fromEntries(Ca.map(m=>[m,a[m]]))},energy:l,doubt:h}}function Am(n){let t=w.
kinds[n[F.kind]],e=n[F.from_mode],s={t:n[F.t],kind:t,from:e<0?null:w.letters[e],to:w.letters[n[F.to_mode]]};for(let o of Ca)s[o]=Ao(n[F[o]]);return s.before=Object.
fromEntries(["vx","vy","omega"].map(o=>[o,Ao(n[F[`before_${o}`]])])),s.impulse={normal:n[F.impulse_normal],tangential:n[F.impulse_tangential]},n[F.collision]===
0&&(s.collision=!1),t==="kane_gain"&&(s.gain=n[F.gain]),n[F.stable]>=0&&(s.stable=n[F.stable]===1),s}function Lm(n){let t=n.filter((s,o)=>o===n.length-1||!Mm.has(
s.kind));return t.slice(0,-1).map((s,o)=>t[o+1].t>s.t?s.to:"").join("")||(n.at(-1)?.to??"")}var Lo=1e4,Pm="kernel.the_part_of_the",Po=256;function Ra(n){let t=URL.createObjectURL(new Blob([n],{type:"text/javascript"}));return()=>new Worker(t,{type:"mod\
ule"})}async function Oa(n){let t=await fetch(n);if(!t.ok)throw new Z({key:"kernel.not_loaded",values:{status:t.status}});return t.headers.get("Content-Type")===
"application/wasm"?WebAssembly.compileStreaming(t):WebAssembly.compile(await t.arrayBuffer())}async function Na(n){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream(
"gzip"));return WebAssembly.compile(await new Response(t).arrayBuffer())}var Pe=class n{constructor(t,e,s){this.start=e;this.derivatives=s;this.rates=null;this.
mechanics=new Ys(t),this.motions=new Jt(e,t,2,Lo);let o=navigator.hardwareConcurrency||2;this.maps=new Jt(e,t,Math.max(1,Math.min(o-1,8)),Lo)}static async load(t){
let e=await Oa(new URL(`hophoop.wasm?${w.module}`,t)),s=()=>Oa(new URL(`hophoop-derivatives.wasm?${w.derivatives}`,t)),o=new URL(`kernel.js?${w.module}`,t);return o.
origin===globalThis.location?.origin?new n(e,()=>new Worker(o,{type:"module"}),s):new n(e,Ra(await(await fetch(o)).text()),s)}static async unpack(t,e,s){return new n(
await Na(t),Ra(e),async()=>Na(await s()))}motion(t,e){return this.motions.ask("motion",[t],e)}film(t,e){return this.motions.ask("film",[t],e)}columns(t,e,s){return this.
motions.ask("columns",[t,s],e)}samples(t,e,s){return this.motions.ask("samples",[t,e],s)}async changes(t,e,s){return this.rates??=this.derivatives().then(i=>new Jt(
this.start,i,1,Lo)),(await this.rates.catch(()=>{throw this.rates=null,new Error(Pm)})).ask("changes",[t,e],s)}thresholds(t,e){return this.motions.ask("threshol\
ds",[t],e)}regions(t,e,s,o,i){return this.motions.ask("regions",[t,e,s,o],i)}async map({count:t,rows:e},s,o,i){let r=w.cell.length,a=new Float64Array(t).fill(Number.
NaN),l=[],h=async u=>{let p=Math.min(Po,t-u),d=new Float64Array(r*p);for(let g=0;g<r;g++)d.set(e.subarray(g*t+u,g*t+u+p),g*p);let f=await this.maps.ask("map",[{
count:p,rows:d},s,o],i,[d.buffer]),_=f.sequences?.map(g=>(l.includes(g)||l.push(g),l.indexOf(g)));for(let g=0;g<p;g++)a[u+g]=_?_[f.values[g]]??Number.NaN:f.values[g]},
m=Array.from({length:Math.ceil(t/Po)},(u,p)=>p*Po);return await Promise.all(m.map(h)),s==="sequence"?{values:a,sequences:l}:{values:a}}close(){this.motions.close(),
this.maps.close(),this.rates?.then(t=>t.close()).catch(()=>{})}};var Cm=360,Rm=240,Co={"motion.toml":"application/toml","motion.csv":"text/csv; charset=utf-8","motion.json":"application/json"},Om=["motion.nc","motion.mp4","mo\
tion.gif"],Js=class{constructor(t,e,{base:s=null,python:o=null}={}){this.kernel=t;this.mechanics=e;this.base=s,this.python=o,this.shares=s!==null,this.files=[...Object.
keys(Co),...o?Om:[]]}async film(t,e){e?.throwIfAborted();let s=J(t,this.mechanics),o=U(vt(s)),{python:i}=this,{motion:r,columns:a,pieces:l}=this.kernel.film?await this.
kernel.film(o,e):{motion:await this.kernel.motion(o,e),columns:await this.kernel.columns(o,e),pieces:null},{doubt:h}=r;if(h!==null&&i){let d=ce(s),f=async _=>(await i.
motion({query:d,window:_})).arrays;return{...this.shown(await i.motion({query:d},e),s),samples:f}}let m=await this.turning(o,r,e),u=Be(s,r,m,this.mechanics),p=this.
mechanics.instant?.bind(this.mechanics);return{header:h===null?u:{...u,doubt:un(h)},arrays:a,exact:p&&l?d=>p(o,l,d):void 0}}async exact(t){let{exact:e,samples:s}=await this.
film({scenario:t});return{exact:e,samples:s}}readable(t){return Fn(t,this.mechanics)}shown({header:t,arrays:e},s=he(t.query,this.mechanics)){return{header:Be(s,
t,i=>t.turning[i],this.mechanics),arrays:e}}async samples(t,e,s){let o=J({scenario:t},this.mechanics);return this.kernel.columns(U(vt(o)),s,e)}async turning(t,{
events:e},s){let o=En(e);if(!o.length)return()=>0;let i=Float64Array.from(o,a=>An(e,a)),{omega:r}=await this.kernel.samples(t,i,s);return a=>r[o.indexOf(a)]}code(t){
let e=J({scenario:t},this.mechanics);return{python:Mn(e),toml:je(e)}}async theory(t,e){e?.throwIfAborted();let s=J({scenario:t},this.mechanics);return jn(s,await this.
kernel.thresholds(U(s),e))}async regions(t,e,s){s?.throwIfAborted();let o=U(J({scenario:t},this.mechanics));return this.kernel.regions(o,e,Cm,Rm,s)}async changes(t,e,s){
if(!this.kernel.changes)throw new TypeError("This kernel has no derivatives.");let o=vt(J({scenario:t},this.mechanics)),i=U(o);if(i.contact)throw new L($("compl\
iant_changes"));let r=In(o,e);if(!r)return null;let{rates:a,smaller:l,larger:h}=r,m=await this.kernel.changes(i,a,s);return{count:m.count,smaller:l?m.smaller:null,
larger:h?m.larger:null}}async map(t,e){e?.throwIfAborted();let{checked:s,x:o,y:i,what:r}=Hn(t,this.mechanics),a=dn(s,{x:o,y:i,what:r}),l=await vn(a,{x:o,y:i},this.
mechanics,e);return kn({x:o,y:i,what:r},await this.kernel.map(l,r,xn(r),e))}async file(t,e){if(!(t in Co)){if(this.python&&/\.(mp4|gif)$/.test(t)&&pn(J({query:e},
this.mechanics)),this.python)return this.python.file(t,e);throw new L({key:"save.needs_python",values:{name:t}})}return new Blob([await this.fileText(t,e)],{type:Co[t]})}async fileText(t,e){
let s=J({query:e},this.mechanics);if(t==="motion.toml")return je(s);let o=vt(s),i=U(o),r=await this.kernel.motion(i);if(r.doubt!==null&&this.python)return(await this.
python.file(t,e)).text();if(t==="motion.json")return Rn(o,r);let a=On(r.duration);return Nn(a,await this.kernel.samples(i,a))}link(t,e){return this.base&&`${new URL(
t?`?${t}`:"",this.base)}${e}`}};async function Ha(n,t){let e=await n.catch(s=>{throw typeof WebAssembly=="object"&&!(s instanceof WebAssembly.CompileError)?s:new Error("page.this_needs_a_brows\
er")});return new Js(e,e.mechanics,t)}function Ro(n,t,e){return Ha(Pe.load(n),{base:e,python:t&&new Ws(t)})}function Fa(n,t){let e=Pe.unpack(n.get("module"),n.get(
"worker"),()=>t.derivatives());return Ha(e,{python:t})}function Ia(n){navigator.serviceWorker?.register(n).catch(()=>{})}var $a=new URL("./",import.meta.url);function qa(n){return Ce(async t=>{let e=await fetch(new URL(`words.${t}.json?ffed6a535371fa98a0ae1f5c8a376399`,n));if(!e.ok)
throw new Error(`words.${t}.json: ${e.status}`);return e.json()}),zt(Bn()).catch(()=>{})}function Nm(n){let t=async()=>{let s=new Blob([n]).stream().pipeThrough(
new DecompressionStream("gzip"));return new Response(s).json()},e;return Ce(async s=>(e??=t(),(await e)[s])),zt(Bn()).catch(()=>{})}async function Hm(n){let t=new URL(
"./",document.baseURI.split(/[?#]/)[0]),e=document.querySelector("meta[name=hophoop-site]"),s,o=qa($a);try{s=await Ro($a,e?null:t,t)}catch(m){await o,E(n,K(m));
return}await o,e&&Ia(e.getAttribute("content")??"");let i=new Yt(n,s,S.setup,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let r=ji(location.hash),a=i.address,
{links:l,said:h}=a.read(Gn());try{await i.open(l,r),h()}catch(m){a.held=!0,await i.open([""]),i.notice.fail(m)}}async function Gb(n,t,e,s){let o=qa(t),i=await Ro(
t,null,new URL("../",t));await o;let r=new Yt(n,i,S.setup,{panels:s});return await r.open([e]),r}async function Fm({model:n,el:t}){let e=document.createElement(
"div");t.append(e);let s=Nm(n.get("words")),o=new Gs(n),i;try{i=await Fa(n,o),await s}catch(h){return await s,E(e,K(h)),()=>o.close()}let r=()=>i.shown(Le(n.get(
"film"))),a=new Yt(e,i,S.setup,{panels:n.get("panels"),onmotion:h=>{n.get("query")!==h&&(n.set("query",h),n.save_changes())}});a.motions.set([r()]),a.begin();let l=()=>a.
motions.replace(r());return n.on("change:film",l),()=>{n.off("change:film",l),o.close(),a.close()}}var ja=document.getElementById("hophoop-lab");ja&&Hm(ja);var Ub={
render:Fm};export{Tt as current,Ub as default,Qn as languageMenu,Gb as mount,dt as name,zn as repeat,E as say,qa as speakFrom,T as t};
