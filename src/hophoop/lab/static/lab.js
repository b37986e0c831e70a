/* Built from web/lab/main.js by esbuild 0.28.2; sources bc0562dfa2a6980f8464c44b5afb176d */
function ee(i){let e=Number.parseInt(i.slice(1,7),16);return[e>>16&255,e>>8&255,e&255]}var Ds=i=>Re(i)>.2?"#111111":"#ffffff",Pe=(i,e)=>`rgba(${ee(i).join(",")}\
,${e})`,Mi=i=>{let e=i/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4};function Re(i){let[e,t,s]=ee(i).map(Mi);return .2126*e+.7152*t+.0722*s}function Le(i,e){
if(!e||!/^#[0-9a-f]{6}$/i.test(i))return i;if(Re(i)<.002)return"#eceef2";let t=i;for(let s=0;Re(t)<.2&&s<1;s+=.05)t=`#${ee(i).map(o=>Math.round(o+(255-o)*s).toString(
16).padStart(2,"0")).join("")}`;return t}var Je=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function Ei(){let i=[];
for(let e=0;e<256;e++){let t=e/255*(Je.length-1),s=Math.min(Math.floor(t),Je.length-2),o=ee(Je[s]),n=ee(Je[s+1]);i.push(o.map((a,r)=>Math.round(a+(n[r]-a)*(t-s))))}
return i}var be=Ei(),Ze=be.map(i=>`rgb(${i.join(",")})`),Ai=["#123a8c","#8a6d00"],G=(i,e)=>Le(Ai[i],e);var Fs={roll:"Rollen",spin:"Durchdrehen",skid:"Rutschen",flight:"Flug",skim:"Streifen",hop:"Hüpfer","slip −":"Schlupf −","slip +":"Schlupf +",rolls:"rollt",
spins:"dreht durch",skids:"rutscht",flies:"fliegt","skims the plane":"streift die Ebene","rolls at {angle}":"rollt ab {angle}","spins at {angle}":"dreht ab {ang\
le} durch","skids at {angle}":"rutscht ab {angle}","flies at {angle}":"fliegt ab {angle}","skims the plane at {angle}":"streift ab {angle} die Ebene","hops at {\
angle}":"hüpft bei {angle}","lands at {angle}":"landet bei {angle}","bounces at {angle}":"springt bei {angle} wieder ab","slips the other way at {angle}":"glei\
tet ab {angle} in der anderen Richtung","stops its slip at once at {angle}":"hört bei {angle} schlagartig auf zu gleiten","turns back at {angle}":"kehrt bei {a\
ngle} um","has bounced out at {angle}":"ist bei {angle} ausgesprungen","meets Painlevé's paradox at {angle}":"trifft bei {angle} auf das Painlevé-Paradoxon","\
meets Painlevé's indeterminacy at {angle}":"trifft bei {angle} auf die Unbestimmtheit nach Painlevé","jams at {angle}":"verklemmt sich bei {angle}","gains ene\
rgy (Kane) at {angle}":"gewinnt bei {angle} Energie (Kane)","skims at {angle}":"streift ab {angle}","rests at {angle}":"ruht bei {angle}","starts at {angle}":"b\
eginnt bei {angle}","slips at {angle}":"gleitet ab {angle}","{what} and {count} more times":"{what} und noch {count}-mal","… ({count} more)":"… (noch {count})",
"It has come to rest.":"Er ist zur Ruhe gekommen.","The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.":"Die Normalk\
raft wächst über alle Grenzen (dynamisches Verklemmen): Die Mechanik starrer Körper kennt keine Bewegung darüber hinaus.","The model does not determine the \
motion beyond.":"Das Modell legt die weitere Bewegung nicht fest.","The limit of events (contact.max_events), or of work for one motion, was reached before the \
end.":"Die Grenze der Ereignisse (contact.max_events) oder des Aufwands für eine Bewegung wurde vor dem Ende erreicht.","It starts and {verb} with the load at \
{angle} and the centre at {speed} m/s.":"Er startet und {verb}, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It starts in the air with the load at {\
angle} and the centre at {speed} m/s.":"Er startet in der Luft, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It starts skimming with the load at {an\
gle} and the centre at {speed} m/s.":"Er streift zu Beginn die Ebene, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It {verb} at {angle}; friction is\
 used up: the rim turns too fast for the way it goes.":"Ab {angle} {verb} er: Die Reibung ist ausgeschöpft, der Rand dreht sich zu schnell für seinen Weg.","I\
t {verb} at {angle}; friction is used up: the rim slides ahead.":"Ab {angle} {verb} er: Die Reibung ist ausgeschöpft, der Rand gleitet voraus.","It rolls again\
 at {angle}; the slip has stopped.":"Ab {angle} rollt er wieder; der Schlupf hat aufgehört.","The slip turns round at {angle}; it {verb}.":"Bei {angle} kehrt s\
ich der Schlupf um; er {verb}.","It hops at {angle}.":"Er hüpft bei {angle}.","It hops at {angle}. It rises {height} and stays up for {time} s.":"Er hüpft bei \
{angle}. Er steigt {height} hoch und bleibt {time} s in der Luft.","An impact without collision at {angle} stops the slip; then it {verb}.":"Ein Stoß ohne Aufpr\
all beendet bei {angle} den Schlupf; dann {verb} er.","It lands at {angle} with {speed} m/s downwards and bounces.":"Er landet bei {angle} mit {speed} m/s abwär\
ts und springt wieder ab.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Er landet bei {angle} mit {speed} m/s abwärts und {verb}.","It turns b\
ack at {angle}.":"Er kehrt bei {angle} um.","It turns back at {angle}, and {verb} now.":"Er kehrt bei {angle} um und {verb} jetzt.","The centre is highest at {a\
ngle}: the gap is {height}.":"Bei {angle} ist der Mittelpunkt am höchsten: Der Spalt beträgt {height}.","Bounces without number end here, at {angle}.":"Hier, \
bei {angle}, enden unzählige Sprünge.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Painlevé-Paradoxon bei {angle}: Keine Kontak\
tkraft passt zu diesem Schlupf.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Painlevé-Paradoxon bei {angle}: Mehrere Kontaktkräfte \
passen dazu.","Dynamic jam at {angle}: the contact force grows without bound.":"Dynamisches Verklemmen bei {angle}: Die Kontaktkraft wächst über alle Grenzen.",
"Newton's law of impact has created {energy} J (Kane's example).":"Newtons Stoßgesetz hat {energy} J erzeugt (Beispiel von Kane).","No contact force is left at\
 {angle}: the load falls freely and the rim skims the plane.":"Bei {angle} ist keine Kontaktkraft mehr da: Die Last fällt frei, der Rand streift die Ebene.","I\
t rests at {angle}.":"Er ruht bei {angle}.","It rests at {angle}, which is not stable.":"Er ruht bei {angle}, aber nicht stabil.","It bounces {count} more times\
.":"Er springt noch {count}-mal.","… and {count} more.":"… und noch {count}.",Slips:"Gleitet",Hops:"Hüpft","Hops at once":"Hüpft sofort","Friction for pur\
e rolling":"Reibung für reines Rollen","Painlevé’s paradox":"Painlevé-Paradoxon","Dynamic jam":"Dynamisches Verklemmen","Rests stably":"Ruht stabil","End o\
f rolling":"Ende des Rollens","would slip above {speed} m/s":"würde über {speed} m/s gleiten","would slip: any push is enough":"würde gleiten: jeder Stoß genü\
gt","would hop in its first turn above {speed} m/s":"würde über {speed} m/s in der ersten Umdrehung hüpfen","would hop in its first turn: any push is enough":"\
würde in der ersten Umdrehung hüpfen: jeder Stoß genügt","would hop at once above {speed} m/s":"würde über {speed} m/s sofort hüpfen","would hop at once:\
 at any speed":"würde sofort hüpfen: bei jeder Geschwindigkeit","never, at any speed":"nie, bei keiner Geschwindigkeit","no friction keeps it rolling":"keine \
Reibung hält ihn am Rollen","μ = {mu} would keep it rolling (enough here)":"μ = {mu} hielte ihn am Rollen (hier genug)","μ = {mu} would keep it rolling (more\
 than there is)":"μ = {mu} hielte ihn am Rollen (mehr als hier)",never:"nie","from μ = {mu} on, at {angle}: possible here":"ab μ = {mu}, bei {angle}: hier mög\
lich","from μ = {mu} on, at {angle}: not here":"ab μ = {mu}, bei {angle}: hier nicht","can end a slip at {angles}":"kann einen Schlupf bei {angles} beenden","\
with the load at {angle}":"mit der Last bei {angle}","at {angle} friction is used up":"bei {angle} ist die Reibung ausgeschöpft","at {angle} the contact force \
is gone":"bei {angle} ist die Kontaktkraft weg","Load fraction":"Massenanteil der Last","Share of the mass in the load of an ideal hoop":"Anteil der Last an der\
 Masse eines idealen Reifens",Eccentricity:"Exzentrizität","Distance of the centre of gravity from the centre, over the radius":"Abstand des Schwerpunkts vom M\
ittelpunkt, geteilt durch den Radius","Inertia ratio":"Bezogenes Trägheitsmoment","Moment of inertia about the centre of gravity over m R²":"Trägheitsmoment u\
m den Schwerpunkt, geteilt durch m R²",Radius:"Radius","Rim radius":"Radius des Randes",Mass:"Masse","Total mass":"Gesamtmasse",Friction:"Reibungszahl","Fricti\
on, static and kinetic":"Reibungszahl, Haft- und Gleitreibung","Static friction":"Haftreibungszahl","Kinetic friction":"Gleitreibungszahl",Slope:"Neigung","Slop\
e of the plane, downhill along +x":"Neigung der Ebene, bergab in Richtung +x",Gravity:"Fallbeschleunigung",Restitution:"Stoßzahl","Restitution of an impact":"S\
toßzahl eines Stoßes",Speed:"Geschwindigkeit","Velocity of the centre in a rolling start":"Geschwindigkeit des Mittelpunkts bei rollendem Start","Load angle":"\
Winkel der Last","Angle from the plane's normal to the centre of gravity":"Winkel von der Normalen der Ebene zum Schwerpunkt","Height of the gap":"Höhe des Spal\
ts","Gap between rim and plane":"Spalt zwischen Rand und Ebene","Speed along":"Geschwindigkeit längs","Velocity of the centre along the plane":"Geschwindigkeit\
 des Mittelpunkts längs der Ebene","Speed upwards":"Geschwindigkeit nach oben","Velocity of the centre away from the plane":"Geschwindigkeit des Mittelpunkts w\
eg von der Ebene","Angular velocity":"Winkelgeschwindigkeit",Stiffness:"Steifigkeit","Stiffness of the contact":"Steifigkeit des Kontakts","Slip speed":"Schlupf\
geschwindigkeit","Slip velocity over which friction builds up":"Schlupfgeschwindigkeit, bei der sich die Reibung aufbaut","Restitution that the damping is chose\
n for":"Stoßzahl, für die die Dämpfung gewählt ist",Duration:"Dauer","Duration of the motion":"Dauer der Bewegung","Law of impact":"Stoßgesetz","Law of res\
titution":"Gesetz der Restitution","Stronge (energy)":"Stronge (Energie)","Poisson (impulse)":"Poisson (Impuls)","Newton (velocity)":"Newton (Geschwindigkeit)",
"Painlevé: two solutions":"Painlevé: zwei Lösungen","What follows an indeterminate contact":"Was auf einen unbestimmten Kontakt folgt",impact:"Stoß","Contac\
t model":"Kontaktmodell",rigid:"starr",compliant:"nachgiebig","Normal force":"Normalkraft","Friction law":"Reibungsgesetz","Regularised friction":"Geglättete Re\
ibung","smooth (tanh)":"glatt (tanh)",linear:"linear","bristle (can hold)":"Borsten (kann halten)","Kelvin–Voigt":"Kelvin–Voigt","Hunt–Crossley":"Hunt–Cro\
ssley","Speed v₀":"Geschwindigkeit v₀","Angle of the load θ₀":"Winkel der Last θ₀","Speed along ẋ₀":"Geschwindigkeit längs ẋ₀","Angular veloc\
ity θ̇₀":"Winkelgeschwindigkeit θ̇₀","Height of the gap y₀":"Höhe des Spalts y₀","Load fraction γ":"Massenanteil der Last γ","Eccentricity ε":"E\
xzentrizität ε","Inertia ratio κ":"Bezogenes Trägheitsmoment κ","Radius R":"Radius R","Friction μ":"Reibungszahl μ","Slope β":"Neigung β","Gravity g":"\
Fallbeschleunigung g","Restitution e":"Stoßzahl e",Earth:"Erde",Moon:"Mond",Mars:"Mars",Jupiter:"Jupiter",Weightless:"Schwerelos","what happens in the first tu\
rn":"was in der ersten Umdrehung geschieht","height of the first hop":"Höhe des ersten Hüpfers","angle of take-off":"Winkel beim Abheben","duration of the fir\
st hop":"Dauer des ersten Hüpfers","greatest friction utilization":"größte Ausnutzung der Reibung","energy lost":"verlorene Energie","angle at the end":"Wink\
el am Ende","Painlevé’s paradox or jam met":"Painlevé-Paradoxon oder Verklemmen getroffen","how it ends":"wie es endet",duration:"Dauer",revolutions:"Umdreh\
ungen",reversal:"Umkehr",takeoff:"Abheben",rest:"Ruhe",jam:"Verklemmen",undetermined:"unbestimmt","event limit":"Grenze der Ereignisse",no:"nein",yes:"ja",none:"\
keine","not allowed":"nicht erlaubt","and {count} more":"und {count} weitere","The article":"Der Artikel","Littlewood's hoop":"Littlewoods Reifen",Paradoxes:"Pa\
radoxa",More:"Mehr","It hops: 3.1 m/s":"Er hüpft: 3,1 m/s","Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.":"Gleitet zweimal,\
 verlässt dann kurz vor einer vollen Umdrehung die Ebene und fliegt 0,76 s lang.","It slips: 2.8 m/s":"Er gleitet: 2,8 m/s","Friction is used up twice a turn; \
each slip is weaker than the one before, and none is the last.":"Zweimal je Umdrehung ist die Reibung ausgeschöpft; jeder Schlupf ist schwächer als der davor, u\
nd keiner ist der letzte.","It rolls: 2 m/s":"Er rollt: 2 m/s","Pure rolling, faster and more even than after a slow start, and close to the limit of friction.":"\
Reines Rollen, schneller und gleichmäßiger als nach langsamem Start und nahe an der Grenze der Reibung.","The smallest push: 0.1 m/s":"Der kleinste Stoß: 0,1 \
m/s","Nearly at rest with the load up, fast with the load down; 38 % of the friction is used.":"Fast in Ruhe mit der Last oben, schnell mit der Last unten; 38 %\
 der Reibung werden genutzt.","Low friction: 0.1 m/s, μ = 0.3":"Wenig Reibung: 0,1 m/s, μ = 0,3","Slipping costs the energy that a full turn needs: the hoop r\
ocks to and fro.":"Das Gleiten kostet die Energie, die eine volle Umdrehung braucht: Der Reifen schaukelt hin und her.","All mass in the load":"Alle Masse in de\
r Last","A massless ring: at 90° no contact force is left; the load falls, the rim skims the plane.":"Ein masseloser Ring: Bei 90° ist keine Kontaktkraft mehr \
da; die Last fällt, der Rand streift die Ebene.","All mass in the load, pushed":"Alle Masse in der Last, angestoßen","With a push the contact force is gone ea\
rlier, at cos θ = v₀²/(gR).":"Mit einem Stoß verschwindet die Kontaktkraft früher, bei cos θ = v₀²/(gR).","Nearly all mass in the load":"Fast alle Mas\
se in der Last","γ = 0.99: what a real ring does instead of Littlewood's hop.":"γ = 0,99: was ein wirklicher Ring anstelle von Littlewoods Hüpfer tut.","Pain\
levé: no solution":"Painlevé: keine Lösung","No contact force agrees with this slip. An impact without collision stops it at once.":"Keine Kontaktkraft passt\
 zu diesem Schlupf. Ein Stoß ohne Aufprall beendet ihn sofort.","Flight and impact both agree with the laws. Choose which with the switch under Plane.":"Flug u\
nd Stoß passen beide zu den Gesetzen. Wähle mit dem Schalter unter „Ebene“.","A fast slide after a hop: the contact force grows without bound in finite ti\
me, and no law says what follows.":"Ein schnelles Gleiten nach einem Hüpfer: Die Kontaktkraft wächst in endlicher Zeit über alle Grenzen, und kein Gesetz sagt, \
was folgt.","Kane: energy out of nothing":"Kane: Energie aus dem Nichts","Newton's law of impact with friction creates two joules. Stronge's law does not.":"New\
tons Stoßgesetz mit Reibung erzeugt zwei Joule. Stronges Gesetz tut das nicht.",Downhill:"Bergab","On a slope of 10° the hoop gains speed from turn to turn, un\
til it hops.":"Auf 10° Neigung wird der Reifen von Umdrehung zu Umdrehung schneller, bis er hüpft.","Bounces without number":"Sprünge ohne Zahl","Dropped wit\
h spin and restitution 0.5: infinitely many bounces in finite time.":"Mit Drehung fallen gelassen, Stoßzahl 0,5: unendlich viele Sprünge in endlicher Zeit.","\
On the Moon":"Auf dem Mond","The article's hop under lunar gravity: everything is slower by a factor of 2.46.":"Der Hüpfer des Artikels mit Mondschwerkraft: All\
es ist um den Faktor 2,46 langsamer.","Motions to start from":"Bewegungen zum Beginnen","Motions to start from …":"Bewegungen zum Beginnen …","Undo (z)":"Rü\
ckgängig (z)","Redo (y)":"Wiederholen (y)",Compare:"Vergleichen","Compare two hoops":"Zwei Reifen vergleichen","Dark or light (d)":"Dunkel oder hell (d)","Keys\
 and help (?)":"Tasten und Hilfe (?)","Keys and help":"Tasten und Hilfe",lab:"Labor",Learn:"Lernen",Language:"Sprache","Hoop A":"Reifen A","Hoop B":"Reifen B","\
Which hoop the controls change":"Welchen Reifen die Regler ändern",Parameters:"Parameter","Skip to the player":"Zum Abspieler springen",Hoop:"Reifen",Plane:"Eb\
ene",Start:"Start",Contact:"Kontakt","Given by":"Gegeben durch","load fraction γ":"Massenanteil γ","ε and κ":"ε und κ","real parts":"wirkliche Teile",Where:"\
Wo",elsewhere:"anderswo","static and kinetic friction apart":"Haft- und Gleitreibung getrennt",Starts:"Startet",rolling:"rollend","in any state":"in beliebigem \
Zustand","auto {value}":"auto {value}","{name}, exact value in {unit}":"{name}, genauer Wert in {unit}","{name}, exact value":"{name}, genauer Wert",Ring:"Ring",
Disk:"Scheibe","Point mass":"Punktmasse",Rod:"Stab",mass:"Masse","inner radius":"Innenradius","outer radius":"Außenradius",radius:"Radius","distance from centr\
e":"Abstand vom Mittelpunkt",length:"Länge","Add a part":"Ein Teil hinzufügen","+ add a part …":"+ ein Teil hinzufügen …","Remove part {number}, {what}":"\
Teil {number} entfernen, {what}","{name} = {value} must be {rule}.":"{name} = {value} muss {rule} sein.","{name} = {value} must be a number, such as 2.5.":"{nam\
e} = {value} muss eine Zahl sein, etwa 2,5.","{name} = {value} must be a number.":"{name} = {value} muss eine Zahl sein.","from {least} to {most}":"von {least} \
bis {most}","from {least} to {most}, or inf":"von {least} bis {most} oder unendlich","0 or from {least} to {most}":"0 oder von {least} bis {most}","0 or from {l\
east} to {most}, or inf":"0, von {least} bis {most} oder unendlich","at most {most} in the lab":"im Labor höchstens {most}","0 for the massless hoop (hoop.iner\
tia_ratio = 0)":"für den masselosen Reifen 0 (hoop.inertia_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"für den masselosen Reifen „rig\
id“ (hoop.inertia_ratio = 0)","plane.mu_kinetic = {one} must not exceed plane.mu_static = {other}.":"plane.mu_kinetic = {one} darf plane.mu_static = {other} n\
icht übersteigen.","The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"Der Server antwortet nicht. Was hier i\
st, läuft weiter; für Änderungen muss `hophoop lab` wieder laufen.","The server answered {status}.":"Der Server hat {status} geantwortet.","The notebook’s ke\
rnel does not answer; run the cell again.":"Der Kernel des Notebooks antwortet nicht; die Zelle noch einmal ausführen.",hoop:"Reifen",mode:"Phase",time:"Zeit",
angle:"Winkel",gap:"Spalt","rim speed":"Geschwindigkeit des Randes",load:"Last","centre of gravity":"Schwerpunkt","the same in flight":"derselbe im Flug",airborne:"\
in der Luft","A in front, B behind":"A vorn, B hinten","The hoop":"Der Reifen","The hoop.":"Der Reifen.",Time:"Zeit","{time} seconds, {what}":"{time} Sekunden, \
{what}","Traces (t)":"Spuren (t)","Forces (f)":"Kräfte (f)","Rim speed (c)":"Randgeschwindigkeit (c)","Whole path (w)":"Ganzer Weg (w)","In space (3)":"Im Raum\
 (3)",Traces:"Spuren",Forces:"Kräfte","Rim speed":"Randtempo","Whole path":"Ganzer Weg","Play (space)":"Abspielen (Leertaste)","Pause (space)":"Pause (Leertast\
e)","Speed of the film":"Tempo des Films","To the start (Home)":"Zum Anfang (Pos1)","Previous event (Shift ←)":"Voriges Ereignis (Umschalt ←)","Next event (\
Shift →)":"Nächstes Ereignis (Umschalt →)","One frame back (←)":"Ein Bild zurück (←)","One frame on (→)":"Ein Bild weiter (→)",landing:"Landung","\
To the next flight (h)":"Zum nächsten Flug (h)","To the next landing (l)":"Zur nächsten Landung (l)","This motion has no flight.":"Diese Bewegung hat keinen F\
lug.","This motion has no landing.":"Diese Bewegung hat keine Landung.","{what} at {angle}, {time} s":"{what} bei {angle}, {time} s",start:"Start","slip begins":"\
Schlupf beginnt","slip ends":"Schlupf endet","slip turns round":"Schlupf kehrt sich um","take-off":"Abheben","turns back":"kehrt um","highest point":"höchster P\
unkt","bounces end":"Sprünge enden","Painlevé: several solutions":"Painlevé: mehrere Lösungen","energy gain (Kane)":"Energiegewinn (Kane)","skimming begins":"\
Streifen beginnt","at rest":"in Ruhe",end:"Ende","What happens":"Was geschieht","What happens to hoop {hoop}":"Was mit Reifen {hoop} geschieht","The motion in w\
ords":"Die Bewegung in Worten","(not all events are shown)":"(nicht alle Ereignisse sind gezeigt)","What theory says":"Was die Theorie sagt","What theory says o\
f hoop {hoop}":"Was die Theorie zu Reifen {hoop} sagt",Velocities:"Geschwindigkeiten","velocity [m/s]":"Geschwindigkeit [m/s]","v (centre)":"v (Mittelpunkt)","E\
nergies and losses":"Energien und Verluste","energy [J]":"Energie [J]",kinetic:"kinetisch",potential:"potenziell",total:"gesamt","lost to friction":"durch Reibu\
ng verloren","lost in the damper":"im Dämpfer verloren","lost in impacts, normal part":"in Stößen verloren, Normalanteil","Contact forces":"Kontaktkräfte","\
force [N]":"Kraft [N]","normal N":"Normalkraft N","friction F":"Reibungskraft F","Use of friction":"Ausnutzung der Reibung","Your choice":"Deine Wahl","What you\
r diagram shows":"Was dein Diagramm zeigt","Horizontal axis of the diagrams":"Waagerechte Achse der Diagramme","over {quantity}":"über: {quantity}","Whole moti\
on":"Ganze Bewegung","slide to go there, two fingers zoom":"schieben, um dorthin zu gehen; zwei Finger vergrößern","click to go there, drag to zoom; once clic\
ked, or with Ctrl, the wheel zooms; double-click for all":"klicken: dorthin gehen; ziehen: vergrößern; nach einem Klick oder mit Strg zoomt das Rad; Doppelklick\
: alles","{name} from {low} to {high}":"{name} von {low} bis {high}","Diagram: {title} in {unit}.":"Diagramm: {title} in {unit}.","θ mod 360°":"θ mod 360°",
Esc:"Esc","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"Winkel innerhalb einer Umdrehung","place of the centre":"Ort des Mittelpunkts","gap under t\
he rim":"Spalt unter dem Rand","height of the centre of gravity":"Höhe des Schwerpunkts","speed of the centre":"Geschwindigkeit des Mittelpunkts","speed of rot\
ation":"Umfangsgeschwindigkeit","speed away from the plane":"Geschwindigkeit weg von der Ebene","slip velocity":"Schlupfgeschwindigkeit","angular velocity":"Win\
kelgeschwindigkeit","normal force":"Normalkraft","friction force":"Reibungskraft","use of friction":"Ausnutzung der Reibung","kinetic energy":"kinetische Energi\
e","potential energy":"potenzielle Energie","total energy":"Gesamtenergie","Plane of θ and θ̇":"Ebene von θ und θ̇","Plane of angle and angular velocity w\
ith the regions of rolling, slip and flight":"Ebene von Winkel und Winkelgeschwindigkeit mit den Gebieten von Rollen, Schlupf und Flug","angle θ within a turn [\
°]":"Winkel θ innerhalb einer Umdrehung [°]","no answer":"keine Antwort","Colours: the mode that follows contact without slip. Hatched: slip that meets Painl\
evé’s paradox.":"Farben: die Phase, die auf Kontakt ohne Schlupf folgt. Schraffiert: Schlupf, der auf das Painlevé-Paradoxon trifft.","Tap to go there, two \
fingers zoom.":"Tippen: dorthin gehen; zwei Finger vergrößern.","Click to go there; two fingers zoom.":"Tippen: dorthin gehen; zwei Finger vergrößern.","Cli\
ck to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Klicken: dorthin gehen; nach einem Klick oder mit Strg zoomt das Rad; Doppe\
lklick: alles.",Map:"Karte",of:"von",Across:"Waagerecht",Up:"Senkrecht","What the map shows":"Was die Karte zeigt","Map of motions":"Karte der Bewegungen","Map \
of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Karte der Bewegungen. Pfeiltasten bewegen die Marke, Eingabe übernimmt die \
Bewegung, Plus und Minus zoomen.","Zoom into the map":"In die Karte hineinzoomen","Zoom out of the map":"Aus der Karte herauszoomen","Whole map":"Ganze Karte","\
Click to take that motion into the player; two fingers zoom.":"Tippen übernimmt die Bewegung in den Abspieler; zwei Finger vergrößern.","Click to take that m\
otion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Ein Klick übernimmt die Bewegung in den Abspieler; nac\
h einem Klick oder mit Strg zoomt das Rad; Ziehen verschiebt; Doppelklick: alles.","computing {count} motions …":"{count} Bewegungen werden berechnet …","{c\
ount} motions":"{count} Bewegungen","{count} motions, with rigid contact":"{count} Bewegungen, mit starrem Kontakt","of rolling starts, though this motion start\
s otherwise":"rollender Starts, obwohl diese Bewegung anders beginnt","of starts in any state, though this motion starts rolling":"aus beliebigem Zustand, obwoh\
l diese Bewegung rollend beginnt","compiling the kernel of maps, this once: {done} of {all} functions":"der Rechenkern der Karten wird einmalig übersetzt: {done\
} von {all} Funktionen",Keep:"Behalten","Copy the link":"Link kopieren","Scenario (TOML)":"Szenario (TOML)","States (CSV)":"Zustände (CSV)","Motion (netCDF)":"\
Bewegung (netCDF)","Events (JSON)":"Ereignisse (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Bild (PNG)","Record a film here (WebM)":"Hier einen Film aufne\
hmen (WebM)","Show me the Python":"Das Python dazu zeigen","The same motion in Python":"Dieselbe Bewegung in Python","The link is copied.":"Der Link ist kopiert\
.","The link to this motion":"Der Link zu dieser Bewegung","The film is being made; this takes a while …":"Der Film wird gemacht; das dauert eine Weile …","\
Fetching {name} …":"{name} wird geholt …","{name} is there.":"{name} ist da.","This browser cannot record a canvas; take the MP4 instead.":"Dieser Browser k\
ann die Zeichenfläche nicht aufnehmen; nimm stattdessen das MP4.","Recording one run …":"Ein Durchlauf wird aufgenommen …","The film is there.":"Der Film i\
st da.","The scenario as a file":"Das Szenario als Datei",Copy:"Kopieren",Copied:"Kopiert",Close:"Schließen","A ring with a load on its rim rolls on a plane. F\
riction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider \
and see.":"Ein Ring mit einer Last am Rand rollt auf einer Ebene. Reibung hält nur begrenzt, und die Ebene kann nur drücken: Also gleitet er, hüpft, landet – od\
er tut etwas, das die Mechanik starrer Körper nicht entscheiden kann. Bewege einen Regler und sieh zu.",Modes:"Phasen","Marks on the bar of time":"Zeichen auf \
der Zeitleiste",Keys:"Tasten",space:"Leertaste","play, pause":"abspielen, anhalten","one frame":"ein Bild","Shift ← →":"Umschalt ← →","previous, next ev\
ent":"voriges, nächstes Ereignis","next flight, landing":"nächster Flug, nächste Landung","slower, faster":"langsamer, schneller","Home End":"Pos1 Ende","sta\
rt, end":"Anfang, Ende","traces, forces, rim speed, whole path":"Spuren, Kräfte, Randgeschwindigkeit, ganzer Weg","in space":"im Raum","zoom, zoom back":"zoome\
n, zurück","leave a field, a menu, a picture that the wheel zooms":"ein Feld, ein Menü, ein Bild verlassen, das das Rad zoomt","z y  Ctrl Z":"z y  Strg Z","un\
do, redo":"rückgängig, wiederholen","dark, light":"dunkel, hell",Python:"Python","the rim does not slide":"der Rand gleitet nicht","slip: the rim turns too fa\
st for the way it goes (slip −, for a hoop that rolls ahead)":"Schlupf: Der Rand dreht sich zu schnell für seinen Weg (Schlupf −, wenn der Reifen vorwärts rol\
lt)","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"Schlupf: Der Rand gleitet voraus (Schlupf +, wenn der Reifen vorwärts rollt)","the hop\
: from take-off to landing":"der Hüpfer: vom Abheben bis zur Landung","a massless rim that touches without force":"ein masseloser Rand, der ohne Kraft berührt",
"take-off, landing":"Abheben, Landung","Painlevé’s paradox: no solution, several":"Painlevé-Paradoxon: keine Lösung, mehrere","bounces without number end":"\
unzählige Sprünge enden","skimming begins, rest":"Streifen beginnt, Ruhe","Single keys (letters, digits, signs) do what the table says":"Einzelne Tasten (Buch\
staben, Ziffern, Zeichen) tun, was die Tabelle sagt","The hoop in your hand":"Der Reifen in der Hand","Slope of the plane":"Neigung der Ebene","Tilt the plane: \
drag, or arrow keys":"Ebene neigen: ziehen oder Pfeiltasten","The hoop: height and speed":"Der Reifen: Höhe und Geschwindigkeit","Lift, roll or throw the hoop:\
 drag, or arrow keys":"Reifen heben, rollen oder werfen: ziehen oder Pfeiltasten","Angle of the load":"Winkel der Last","Turn the load: drag, or arrow keys":"La\
st drehen: ziehen oder Pfeiltasten","gap {height}, speed {speed} m/s":"Spalt {height}, Geschwindigkeit {speed} m/s",Repeat:"Wiederholen","Slow motion: a tenth o\
f the speed":"Zeitlupe: ein Zehntel des Tempos","Sound of the contact":"Klang des Kontakts","Presentation on the whole screen":"Vorführung auf dem ganzen Bildsc\
hirm","Guided visit":"Geführter Besuch","Table of the motion":"Tabelle der Bewegung","Table of the motion, rows":"Tabelle der Bewegung, Zeilen",Presentation:"V\
orführung","For teachers":"Für Lehrkräfte",Table:"Tabelle",Every:"Alle","Save as CSV":"Als CSV speichern",Columns:"Spalten","The first {count} rows.":"Die er\
sten {count} Zeilen.",Challenges:"Herausforderungen","Leave the challenges":"Herausforderungen verlassen","Which challenge":"Welche Herausforderung",Score:"Punk\
te","Begin again":"Von vorn beginnen","Show a best one":"Eine beste zeigen","{stars} {points} points. {what}":"{stars} {points} Punkte. {what}","Your best: {poi\
nts} points.":"Deine beste: {points} Punkte.","Hop highest":"Am höchsten hüpfen","On level ground, rolling, with at most 3.1 m/s: you choose the load, where i\
t starts, and friction. How high can the hoop rise within 6 s?":"Auf ebenem Boden, rollend, mit höchstens 3,1 m/s: Du wählst die Last, wo sie beginnt, und die R\
eibung. Wie hoch kann der Reifen in 6 s steigen?","Land upright":"Aufrecht landen","Let the hoop land with its load at the very top. Everything is allowed; the \
first hop has to be at least 5 cm high.":"Lass den Reifen so landen, dass seine Last ganz oben ist. Alles ist erlaubt; der erste Hüpfer muss mindestens 5 cm hoc\
h sein.","Hop without skidding":"Hüpfen ohne Rutschen","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is a\
t most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Auf ebenem Boden beginnt der Reifen zu rollen, die Last unten, mit höch\
stens 10 m/s, und μ ist höchstens 1,5. Vor dem Hüpfer darf er nicht rutschen; durchdrehen darf er. Wie hoch hüpft er?","Rigid contact only.":"Nur starrer Ko\
ntakt.","The plane must be level.":"Die Ebene muss waagerecht sein.","It must be on Earth.":"Es muss auf der Erde sein.","Restitution must be 0.":"Die Stoßzahl \
muss 0 sein.","The radius must stay 1 m, without parts.":"Der Radius muss 1 m bleiben, ohne Teile.","At most 90 % of the mass may be in the load.":"Höchstens 90\
 % der Masse dürfen in der Last sein.","The hoop must be given by its load fraction.":"Der Reifen muss durch den Massenanteil der Last gegeben sein.","It must \
start rolling.":"Er muss rollend beginnen.","At most 10 m/s.":"Höchstens 10 m/s.","At most 3.1 m/s.":"Höchstens 3,1 m/s.","At most 6 s.":"Höchstens 6 s.","It\
 does not hop.":"Er hüpft nicht.","It rises by {height}.":"Er steigt um {height}.","The first hop is too low.":"Der erste Hüpfer ist zu niedrig.","It lands {o\
ff} away from the top.":"Er landet {off} neben der höchsten Stelle.","The load must start at the bottom.":"Die Last muss unten beginnen.","Friction must be at \
most 1.5.":"Die Reibungszahl darf höchstens 1,5 sein.","It skids before it hops.":"Er rutscht, bevor er hüpft.","New here?":"Neu hier?","Eight short questions\
: guess, then play.":"Acht kurze Fragen: erst raten, dann abspielen.","Start the visit":"Besuch beginnen","Not now":"Jetzt nicht","The hoop, before it is let go\
.":"Der Reifen, bevor er losgelassen wird.",Play:"Abspielen",Next:"Weiter",Back:"Zurück",Done:"Fertig","Step {number} of {all}":"Schritt {number} von {all}","L\
eave the visit":"Besuch verlassen","First say what you expect, then play.":"Sag erst, was du erwartest, dann spiel ab.","Your guess":"Dein Tipp","{points} of 10\
0 points.":"{points} von 100 Punkten.","You have {sum} of {most} points.":"Du hast {sum} von {most} Punkten.","{what} with the load at {angle}":"{what} mit der \
Last bei {angle}","Draw the curve: pull the points up and down":"Zeichne die Kurve: zieh die Punkte auf und ab","Littlewood’s question":"Littlewoods Frage","A\
 hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the\
 weight is level with the centre.":"Ein Reifen ohne Masse trägt ein Gewicht am Rand. Mit dem Gewicht oben bekommt er den kleinsten Stoß und rollt. J. E. Littlew\
ood fragte 1953, was geschieht, wenn das Gewicht auf der Höhe des Mittelpunkts ist.","What do you think?":"Was meinst du?","It rolls on.":"Er rollt weiter.","I\
t hops: the hoop leaves the plane.":"Er hüpft: Der Reifen verlässt die Ebene.","The weight falls freely, and the hoop skims the plane below it.":"Das Gewicht \
fällt frei, und der Reifen streift darunter die Ebene.","At {angle} there is no contact force any more.":"Bei {angle} gibt es keine Kontaktkraft mehr.","Little\
wood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a \
hoop needs some mass in its rim.":"Littlewood sagte, der Reifen hüpfe. Doch die Kontaktkraft ist null, nicht nach oben gerichtet: Das Gewicht fällt frei, und ei\
n Rand ohne Masse folgt ihm die Ebene entlang. Zum Hüpfen braucht ein Reifen etwas Masse im Rand.","A ring with mass":"Ein Ring mit Masse","Now a quarter of th\
e mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"Jetzt steckt ein Viertel der Masse im Ring. Wieder ist die Last oben\
, und der Reifen bekommt den kleinsten Stoß.","Draw how fast the hoop’s centre goes during the first turn.":"Zeichne, wie schnell der Mittelpunkt in der erst\
en Umdrehung ist.","Speed of the centre":"Geschwindigkeit des Mittelpunkts","With the load at the bottom the centre has {speed} m/s.":"Mit der Last unten hat de\
r Mittelpunkt {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load\
 has lost: it is faster than a stone that falls from the same height.":"Der tiefste Punkt eines rollenden Reifens ruht. Dort hat die Last keine kinetische Energ\
ie, und der leichte Ring hat alles, was die schwere Last verloren hat: Er ist schneller als ein Stein, der aus derselben Höhe fällt.","Why it slips":"Warum er\
 gleitet","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Ein kräftigerer Stoß: 2,8 m/s oben. Rollen\
 braucht Reibung, und Reibung hat eine Grenze: Sie ist höchstens μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"Wo ist \
die Last, wenn die Reibung zum ersten Mal nachgibt? Dreh die Marke.","Angle of the load where it begins to slip":"Winkel der Last, wo er zu gleiten beginnt","It\
 begins to slip at {angle}. There the plane carries only {share} of the weight.":"Er beginnt bei {angle} zu gleiten. Dort trägt die Ebene nur {share} des Gewich\
ts.","The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the d\
iagram ‘Use of friction’: it comes to 1.":"Die Last drückt auf ihrem Weg hinab und herum kaum auf die Ebene, N ist also klein, während der Ring schneller we\
rden muss: Das braucht Reibung. Sieh das Diagramm „Ausnutzung der Reibung“: Sie erreicht 1.","The hop":"Der Hüpfer","A little faster, 3.1 m/s. This time th\
e hoop leaves the plane, before the first turn is over.":"Etwas schneller, 3,1 m/s. Diesmal verlässt der Reifen die Ebene, bevor die erste Umdrehung vorbei ist.",
"Where is the load when the hoop takes off? Turn the mark.":"Wo ist die Last, wenn der Reifen abhebt? Dreh die Marke.","Angle of the load where it takes off":"W\
inkel der Last beim Abheben","It takes off at {angle}, while its rim slips at {slip} m/s.":"Er hebt bei {angle} ab, während sein Rand mit {slip} m/s gleitet.",
"A rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load \
pulls it off the plane before it is at the top.":"Einen rollenden Reifen würde die Ebene bremsen, während die Last hochkommt. Dafür ist die Reibung zu schwach: \
Der Rand dreht durch, der Reifen dreht schnell weiter, und die Last zieht ihn von der Ebene, bevor sie oben ist.","The landing":"Die Landung","The hoop is in th\
e air. Its centre of gravity goes on a parabola, and it turns evenly.":"Der Reifen ist in der Luft. Sein Schwerpunkt fliegt auf einer Parabel, und er dreht sich\
 gleichmäßig.","What does it do just after it has landed?":"Was tut er gleich nach der Landung?","It rolls at once.":"Er rollt sofort.","It skids: the rim sli\
des ahead.":"Er rutscht: Der Rand gleitet voraus.","It spins: the rim turns too fast.":"Er dreht durch: Der Rand dreht sich zu schnell.","It bounces.":"Er sprin\
gt wieder ab.","It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Er war {time} s in der Luft und stieg um {height} c\
m; er landet mit der Last bei {angle}.","An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With less frict\
ion, or more restitution, the landing would be another one. Try it afterwards.":"Ein Stoß braucht keine Zeit, doch seine Reibung ist so stark wie sein Druck: Hi\
er genügt sie, um allen Schlupf zu beenden. Mit weniger Reibung oder größerer Stoßzahl wäre die Landung eine andere. Probier es nachher aus.","More frictio\
n, more hop?":"Mehr Reibung, mehr Hüpfen?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Drei Reifen bekommen denselb\
en Stoß von 3,1 m/s, auf Ebenen mit der Reibungszahl 0,05, 0,2 und 1,0.","Which of them hops highest?":"Welcher hüpft am höchsten?","They rise by {low} cm, {\
middle} cm and {high} cm. (The first two are A and B.)":"Sie steigen um {low} cm, {middle} cm und {high} cm. (Die ersten beiden sind A und B.)","On ice nothing \
drives the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is \
braked on the way up.":"Auf Eis treibt nichts die Drehung an; mit endloser Reibung gleitet nichts. Der Hüpfer braucht beides: genug Reibung, um den Reifen auf d\
em Weg hinab schnell zu drehen, und nicht so viel, dass er auf dem Weg hinauf gebremst wird.","What rigid bodies cannot decide":"Was starre Körper nicht entsche\
iden","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Ein Reifen wird s\
o geworfen, dass er schnell über eine raue Ebene gleitet. Die Gesetze starrer Körper mit trockener Reibung müssen sagen, was als Nächstes geschieht.","What \
do they say?":"Was sagen sie?","It flies off.":"Er fliegt davon.","An impact stops the slide at once.":"Ein Stoß beendet das Gleiten sofort.","Both agree with \
the laws.":"Beides passt zu den Gesetzen.","Hoop A and hoop B start alike, and both motions obey every law.":"Reifen A und Reifen B beginnen gleich, und beide B\
ewegungen befolgen jedes Gesetz.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a littl\
e, and that decides: choose the compliant contact under ‘Contact’.":"Painlevé fand dies 1895. Für einen starren Körper haben die Gesetze hier zwei Antworten\
, in anderen Zuständen keine. Wirkliche Körper geben etwas nach, und das entscheidet: Wähle unter „Kontakt“ den nachgiebigen.","Your turn":"Du bist dran",
"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the mot\
ion itself.":"Nimm den Reifen: Dreh die Last, heb ihn an und lass ihn fallen, stoß ihn an, neige die Ebene. Oder nimm eine Herausforderung an, und sieh, wie dei\
ne Punkte aus der Bewegung selbst berechnet werden.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Den Reifen ein\
mal in voller Geschwindigkeit zeigen, ohne Kommentar. „Ich stoße ihn an. Rollt er nur?“","Everybody predicts where the load is at take-off. Count the votes\
 by quarters of the turn.":"Alle sagen voraus, wo die Last beim Abheben ist. Stimmen nach Vierteln der Umdrehung zählen.","Energy on the way down, in pairs: wh\
o has the energy when the load is at rest?":"Energie auf dem Weg hinab, zu zweit: Wer hat die Energie, wenn die Last ruht?","Lift at the top: at which speed is \
the force of the floor zero?":"Abheben oben: Bei welcher Geschwindigkeit ist die Kraft des Bodens null?","The film again, in slow motion and with forces; stop a\
t take-off. Compare with the votes.":"Der Film noch einmal, in Zeitlupe und mit Kräften; beim Abheben anhalten. Mit den Stimmen vergleichen.","Each group takes\
 one speed of the worksheet; results on the board.":"Jede Gruppe nimmt eine Geschwindigkeit des Arbeitsblatts; Ergebnisse an die Tafel.","Why? What has to brake\
 the rotation on the way up, how strong can it be, and what if it is too weak?":"Warum? Was muss die Drehung auf dem Weg hinauf bremsen, wie stark kann es sein,\
 und was, wenn es zu schwach ist?","One sentence each: “The hoop hops because …”":"Ein Satz von jedem: „Der Reifen hüpft, weil …“","The load pulls \
the hoop up at the top, so it hops there.":"Die Last zieht den Reifen oben hoch, also hüpft er dort.","Only if it is very fast. Slower hoops hop before the top\
, after slipping.":"Nur wenn er sehr schnell ist. Langsamere Reifen hüpfen vor der höchsten Stelle, nach dem Gleiten.","It hops at the bottom, where it is fas\
test.":"Er hüpft unten, wo er am schnellsten ist.","There the floor pushes hardest: the load has to be turned upwards.":"Dort drückt der Boden am stärksten: Di\
e Last muss nach oben umgelenkt werden.","Nothing can be faster than a falling stone.":"Nichts kann schneller sein als ein fallender Stein.","The ring can: it g\
ets the energy of a load that has come to rest.":"Der Ring schon: Er bekommt die Energie einer Last, die zur Ruhe gekommen ist.","Friction always brakes.":"Reib\
ung bremst immer.","It acts against slip. On the hoop’s way up it points forwards.":"Sie wirkt gegen den Schlupf. Auf dem Weg hinauf zeigt sie nach vorn.","Mo\
re friction, more hop.":"Mehr Reibung, mehr Hüpfen.","There is a best friction in between.":"Dazwischen gibt es eine beste Reibungszahl.","A heavier hoop behav\
es otherwise.":"Ein schwererer Reifen verhält sich anders.","Only the shares of mass count.":"Nur die Anteile der Massen zählen.","Before the film: where is t\
he load when the hoop leaves the floor? Mark the place and give one reason.":"Vor dem Film: Wo ist die Last, wenn der Reifen den Boden verlässt? Markiere die St\
elle und nenne einen Grund.","The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"Der \
Reifen bekommt nur den kleinsten Stoß und rollt. Wie viel potenzielle Energie ist frei geworden, wenn die Last unten ist?","While a wheel rolls, its lowest poi\
nt is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"Wenn ein Rad rollt, ruht sein tiefster Punkt. Welcher Teil des Reif\
ens hat dann kinetische Energie, und wie schnell ist der Mittelpunkt?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"\
Wie schnell ist ein Stein, der aus der Höhe der Last fällt? Warum kann der Reifen schneller sein?","Find the force of the floor at the top for 1.0 m/s, and th\
e speed at which it becomes zero.":"Bestimme die Kraft des Bodens oben für 1,0 m/s und die Geschwindigkeit, bei der sie null wird.","In the lab: what does the \
hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.":"Im Labor: Was tut der Reifen in den ersten 1,5 s, und bei welchem Winkel hüpft \
er? Fülle die Tabelle aus.","Find the smallest speed with which the hoop hops, to 1 cm/s.":"Finde die kleinste Geschwindigkeit, mit der der Reifen hüpft, auf 1\
 cm/s genau.","At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping help it to hop?":"Bei 2,2 m/s verlässt der Reifen den Boden, während \
sein Rand gleitet. Warum hilft ihm das Gleiten zu hüpfen?",Show:"Zeigen","Teaching with the hoop":"Unterrichten mit dem Reifen",Worksheet:"Arbeitsblatt",Solutions:"\
Lösungen",Exercises:"Aufgaben","A lesson of 45 minutes":"Eine Unterrichtsstunde von 45 Minuten",Minute:"Minute",Motion:"Bewegung","What students often think":"\
Was Lernende oft denken",Idea:"Vorstellung","What is right":"Was richtig ist","Worksheet: the hoop that hops":"Arbeitsblatt: der hüpfende Reifen","A thin ring \
of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the ri\
ght. Friction: μ = 1; g = 9.81 m/s².":"Ein dünner Ring mit dem Radius 0,40 m hat eine Masse von 0,25 kg. An seinem Rand ist eine Last von 0,75 kg befestigt. D\
er Reifen steht mit der Last oben auf ebenem Boden und wird nach rechts gestoßen. Reibungszahl: μ = 1; g = 9,81 m/s².",phases:"Phasen","does it hop?":"hüpft \
er?","at which angle?":"bei welchem Winkel?",Print:"Drucken","The visit asks before it shows; the presentation fills the screen; the table gives numbers to ever\
y student.":"Der Besuch fragt, bevor er zeigt; die Vorführung füllt den Bildschirm; die Tabelle gibt allen Zahlen.","Slips, hops":"Gleitet, hüpft","no thresh\
old uphill (β < 0): whether it slips or hops hangs on where it turns back; the map shows it":"bergauf (β < 0) keine Schwelle: ob er gleitet oder hüpft, hängt d\
avon ab, wo er umkehrt; die Karte zeigt es","A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A blau, B ocker; die Strichart nennt \
die Größe; Zahlen von {hoop}; {hands}"};var js={roll:"rodadura",spin:"patinaje",skid:"derrape",flight:"vuelo",skim:"roce",hop:"salto","slip −":"deslizamiento −","slip +":"deslizamiento +",rolls:"r\
ueda",spins:"patina",skids:"derrapa",flies:"vuela","skims the plane":"roza el plano","rolls at {angle}":"rueda desde {angle}","spins at {angle}":"patina desde {\
angle}","skids at {angle}":"derrapa desde {angle}","flies at {angle}":"vuela desde {angle}","skims the plane at {angle}":"roza el plano desde {angle}","hops at \
{angle}":"salta a {angle}","lands at {angle}":"aterriza a {angle}","bounces at {angle}":"rebota a {angle}","slips the other way at {angle}":"desliza en sentido \
contrario desde {angle}","stops its slip at once at {angle}":"deja de deslizar de golpe a {angle}","turns back at {angle}":"da la vuelta a {angle}","has bounced\
 out at {angle}":"termina de rebotar a {angle}","meets Painlevé's paradox at {angle}":"encuentra la paradoja de Painlevé a {angle}","meets Painlevé's indeterm\
inacy at {angle}":"encuentra la indeterminación de Painlevé a {angle}","jams at {angle}":"se bloquea a {angle}","gains energy (Kane) at {angle}":"gana energía\
 (Kane) a {angle}","skims at {angle}":"roza desde {angle}","rests at {angle}":"reposa a {angle}","starts at {angle}":"empieza a {angle}","slips at {angle}":"des\
liza desde {angle}","{what} and {count} more times":"{what} y {count} veces más","… ({count} more)":"… ({count} más)","It has come to rest.":"Ha quedado e\
n reposo.","The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.":"La fuerza normal crece sin límite (bloqueo dinámico\
): la mecánica del sólido rígido no da ningún movimiento más allá.","The model does not determine the motion beyond.":"El modelo no determina el movimient\
o posterior.","The limit of events (contact.max_events), or of work for one motion, was reached before the end.":"Se alcanzó el límite de sucesos (contact.max_e\
vents), o de cálculo para un movimiento, antes del final.","It starts and {verb} with the load at {angle} and the centre at {speed} m/s.":"Empieza y {verb}, co\
n la carga a {angle} y el centro a {speed} m/s.","It starts in the air with the load at {angle} and the centre at {speed} m/s.":"Empieza en el aire, con la carg\
a a {angle} y el centro a {speed} m/s.","It starts skimming with the load at {angle} and the centre at {speed} m/s.":"Empieza rozando el plano, con la carga a {\
angle} y el centro a {speed} m/s.","It {verb} at {angle}; friction is used up: the rim turns too fast for the way it goes.":"A {angle} {verb}: el rozamiento est\
á agotado y la llanta gira demasiado deprisa para lo que avanza.","It {verb} at {angle}; friction is used up: the rim slides ahead.":"A {angle} {verb}: el roza\
miento está agotado y la llanta desliza hacia delante.","It rolls again at {angle}; the slip has stopped.":"A {angle} vuelve a rodar; el deslizamiento ha cesad\
o.","The slip turns round at {angle}; it {verb}.":"A {angle} se invierte el deslizamiento; {verb}.","It hops at {angle}.":"Salta a {angle}.","It hops at {angle}\
. It rises {height} and stays up for {time} s.":"Salta a {angle}. Sube {height} y permanece {time} s en el aire.","An impact without collision at {angle} stops \
the slip; then it {verb}.":"Un impacto sin choque a {angle} detiene el deslizamiento; luego {verb}.","It lands at {angle} with {speed} m/s downwards and bounces\
.":"Aterriza a {angle} con {speed} m/s hacia abajo y rebota.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Aterriza a {angle} con {speed} m/s h\
acia abajo y {verb}.","It turns back at {angle}.":"Da la vuelta a {angle}.","It turns back at {angle}, and {verb} now.":"Da la vuelta a {angle}, y ahora {verb}.",
"The centre is highest at {angle}: the gap is {height}.":"El centro está más alto a {angle}: la separación es de {height}.","Bounces without number end here,\
 at {angle}.":"Aquí, a {angle}, terminan infinitos rebotes.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Paradoja de Painlevé a \
{angle}: ninguna fuerza de contacto es compatible con este deslizamiento.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Paradoja de \
Painlevé a {angle}: varias fuerzas de contacto son compatibles.","Dynamic jam at {angle}: the contact force grows without bound.":"Bloqueo dinámico a {angle}: \
la fuerza de contacto crece sin límite.","Newton's law of impact has created {energy} J (Kane's example).":"La ley de impacto de Newton ha creado {energy} J (e\
jemplo de Kane).","No contact force is left at {angle}: the load falls freely and the rim skims the plane.":"A {angle} ya no hay fuerza de contacto: la carga ca\
e libremente y la llanta roza el plano.","It rests at {angle}.":"Reposa a {angle}.","It rests at {angle}, which is not stable.":"Reposa a {angle}, pero no de fo\
rma estable.","It bounces {count} more times.":"Rebota {count} veces más.","… and {count} more.":"… y {count} más.",Slips:"Desliza",Hops:"Salta","Hops at \
once":"Salta de inmediato","Friction for pure rolling":"Rozamiento para rodadura pura","Painlevé’s paradox":"Paradoja de Painlevé","Dynamic jam":"Bloqueo di\
námico","Rests stably":"Reposo estable","End of rolling":"Fin de la rodadura","would slip above {speed} m/s":"deslizaría por encima de {speed} m/s","would sli\
p: any push is enough":"deslizaría: basta cualquier empujón","would hop in its first turn above {speed} m/s":"saltaría en la primera vuelta por encima de {spe\
ed} m/s","would hop in its first turn: any push is enough":"saltaría en la primera vuelta: basta cualquier empujón","would hop at once above {speed} m/s":"sal\
taría de inmediato por encima de {speed} m/s","would hop at once: at any speed":"saltaría de inmediato: a cualquier velocidad","never, at any speed":"nunca, a\
 ninguna velocidad","no friction keeps it rolling":"ningún rozamiento lo mantiene rodando","μ = {mu} would keep it rolling (enough here)":"μ = {mu} lo mantend\
ría rodando (aquí basta)","μ = {mu} would keep it rolling (more than there is)":"μ = {mu} lo mantendría rodando (más de lo que hay)",never:"nunca","from μ\
 = {mu} on, at {angle}: possible here":"desde μ = {mu}, a {angle}: aquí es posible","from μ = {mu} on, at {angle}: not here":"desde μ = {mu}, a {angle}: aquí\
 no","can end a slip at {angles}":"puede acabar un deslizamiento a {angles}","with the load at {angle}":"con la carga a {angle}","at {angle} friction is used up":"\
a {angle} se agota el rozamiento","at {angle} the contact force is gone":"a {angle} desaparece la fuerza de contacto","Load fraction":"Fracción de la carga","S\
hare of the mass in the load of an ideal hoop":"Parte de la masa que está en la carga de un aro ideal",Eccentricity:"Excentricidad","Distance of the centre of \
gravity from the centre, over the radius":"Distancia del centro de gravedad al centro, dividida por el radio","Inertia ratio":"Momento de inercia relativo","Mom\
ent of inertia about the centre of gravity over m R²":"Momento de inercia respecto al centro de gravedad, dividido por m R²",Radius:"Radio","Rim radius":"Radi\
o de la llanta",Mass:"Masa","Total mass":"Masa total",Friction:"Coeficiente de rozamiento","Friction, static and kinetic":"Coeficiente de rozamiento, estático y\
 cinético","Static friction":"Rozamiento estático","Kinetic friction":"Rozamiento cinético",Slope:"Inclinación","Slope of the plane, downhill along +x":"Inc\
linación del plano, cuesta abajo hacia +x",Gravity:"Gravedad",Restitution:"Restitución","Restitution of an impact":"Coeficiente de restitución de un impacto",
Speed:"Velocidad","Velocity of the centre in a rolling start":"Velocidad del centro en una salida rodando","Load angle":"Ángulo de la carga","Angle from the pl\
ane's normal to the centre of gravity":"Ángulo desde la normal del plano hasta el centro de gravedad","Height of the gap":"Altura de la separación","Gap betwe\
en rim and plane":"Separación entre la llanta y el plano","Speed along":"Velocidad a lo largo","Velocity of the centre along the plane":"Velocidad del centro a\
 lo largo del plano","Speed upwards":"Velocidad hacia arriba","Velocity of the centre away from the plane":"Velocidad del centro alejándose del plano","Angular\
 velocity":"Velocidad angular",Stiffness:"Rigidez","Stiffness of the contact":"Rigidez del contacto","Slip speed":"Velocidad de deslizamiento","Slip velocity ov\
er which friction builds up":"Velocidad de deslizamiento en la que se establece el rozamiento","Restitution that the damping is chosen for":"Restitución para la\
 que se elige el amortiguamiento",Duration:"Duración","Duration of the motion":"Duración del movimiento","Law of impact":"Ley de impacto","Law of restitution":"\
Ley de restitución","Stronge (energy)":"Stronge (energía)","Poisson (impulse)":"Poisson (impulso)","Newton (velocity)":"Newton (velocidad)","Painlevé: two sol\
utions":"Painlevé: dos soluciones","What follows an indeterminate contact":"Qué sigue a un contacto indeterminado",impact:"impacto","Contact model":"Modelo de\
 contacto",rigid:"rígido",compliant:"flexible","Normal force":"Fuerza normal","Friction law":"Ley de rozamiento","Regularised friction":"Rozamiento regularizad\
o","smooth (tanh)":"suave (tanh)",linear:"lineal","bristle (can hold)":"cerdas (puede sujetar)","Kelvin–Voigt":"Kelvin–Voigt","Hunt–Crossley":"Hunt–Crossl\
ey","Speed v₀":"Velocidad v₀","Angle of the load θ₀":"Ángulo de la carga θ₀","Speed along ẋ₀":"Velocidad a lo largo ẋ₀","Angular velocity θ̇₀":"\
Velocidad angular θ̇₀","Height of the gap y₀":"Altura de la separación y₀","Load fraction γ":"Fracción de la carga γ","Eccentricity ε":"Excentricid\
ad ε","Inertia ratio κ":"Momento de inercia relativo κ","Radius R":"Radio R","Friction μ":"Rozamiento μ","Slope β":"Inclinación β","Gravity g":"Gravedad\
 g","Restitution e":"Restitución e",Earth:"Tierra",Moon:"Luna",Mars:"Marte",Jupiter:"Júpiter",Weightless:"Ingravidez","what happens in the first turn":"lo que\
 ocurre en la primera vuelta","height of the first hop":"altura del primer salto","angle of take-off":"ángulo de despegue","duration of the first hop":"duració\
n del primer salto","greatest friction utilization":"mayor uso del rozamiento","energy lost":"energía perdida","angle at the end":"ángulo final","Painlevé’s p\
aradox or jam met":"paradoja de Painlevé o bloqueo","how it ends":"cómo termina",duration:"duración",revolutions:"vueltas",reversal:"inversión",takeoff:"des\
pegue",rest:"reposo",jam:"bloqueo",undetermined:"indeterminado","event limit":"límite de sucesos",no:"no",yes:"sí",none:"ninguno","not allowed":"no permitido",
"and {count} more":"y {count} más","The article":"El artículo","Littlewood's hoop":"El aro de Littlewood",Paradoxes:"Paradojas",More:"Más","It hops: 3.1 m/s":"\
Salta: 3,1 m/s","Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.":"Desliza dos veces, luego deja el plano justo antes de dar un\
a vuelta y vuela durante 0,76 s.","It slips: 2.8 m/s":"Desliza: 2,8 m/s","Friction is used up twice a turn; each slip is weaker than the one before, and none is\
 the last.":"El rozamiento se agota dos veces por vuelta; cada deslizamiento es más débil que el anterior, y ninguno es el último.","It rolls: 2 m/s":"Rueda:\
 2 m/s","Pure rolling, faster and more even than after a slow start, and close to the limit of friction.":"Rodadura pura, más rápida y uniforme que tras una sal\
ida lenta, y cerca del límite del rozamiento.","The smallest push: 0.1 m/s":"El menor empujón: 0,1 m/s","Nearly at rest with the load up, fast with the load d\
own; 38 % of the friction is used.":"Casi en reposo con la carga arriba, rápido con la carga abajo; se usa el 38 % del rozamiento.","Low friction: 0.1 m/s, μ =\
 0.3":"Poco rozamiento: 0,1 m/s, μ = 0,3","Slipping costs the energy that a full turn needs: the hoop rocks to and fro.":"Deslizar cuesta la energía que exige \
una vuelta entera: el aro se balancea.","All mass in the load":"Toda la masa en la carga","A massless ring: at 90° no contact force is left; the load falls, the\
 rim skims the plane.":"Un anillo sin masa: a 90° ya no hay fuerza de contacto; la carga cae y la llanta roza el plano.","All mass in the load, pushed":"Toda l\
a masa en la carga, con empujón","With a push the contact force is gone earlier, at cos θ = v₀²/(gR).":"Con un empujón la fuerza de contacto desaparece ant\
es, a cos θ = v₀²/(gR).","Nearly all mass in the load":"Casi toda la masa en la carga","γ = 0.99: what a real ring does instead of Littlewood's hop.":"γ = \
0,99: lo que hace un anillo real en lugar del salto de Littlewood.","Painlevé: no solution":"Painlevé: ninguna solución","No contact force agrees with this s\
lip. An impact without collision stops it at once.":"Ninguna fuerza de contacto es compatible con este deslizamiento. Un impacto sin choque lo detiene de golpe.",
"Flight and impact both agree with the laws. Choose which with the switch under Plane.":"Vuelo e impacto cumplen ambos las leyes. Elige con el selector de «Plan\
o».","A fast slide after a hop: the contact force grows without bound in finite time, and no law says what follows.":"Un deslizamiento rápido tras un salto: la\
 fuerza de contacto crece sin límite en un tiempo finito, y ninguna ley dice qué sigue.","Kane: energy out of nothing":"Kane: energía de la nada","Newton's l\
aw of impact with friction creates two joules. Stronge's law does not.":"La ley de impacto de Newton con rozamiento crea dos julios. La de Stronge, no.",Downhill:"\
Cuesta abajo","On a slope of 10° the hoop gains speed from turn to turn, until it hops.":"En una pendiente de 10° el aro gana velocidad vuelta a vuelta, hasta \
que salta.","Bounces without number":"Rebotes sin número","Dropped with spin and restitution 0.5: infinitely many bounces in finite time.":"Soltado con giro y \
restitución 0,5: infinitos rebotes en un tiempo finito.","On the Moon":"En la Luna","The article's hop under lunar gravity: everything is slower by a factor of\
 2.46.":"El salto del artículo con gravedad lunar: todo es 2,46 veces más lento.","Motions to start from":"Movimientos para empezar","Motions to start from …":"\
Movimientos para empezar…","Undo (z)":"Deshacer (z)","Redo (y)":"Rehacer (y)",Compare:"Comparar","Compare two hoops":"Comparar dos aros","Dark or light (d)":"\
Oscuro o claro (d)","Keys and help (?)":"Teclas y ayuda (?)","Keys and help":"Teclas y ayuda",lab:"laboratorio",Learn:"Aprender",Language:"Idioma","Hoop A":"Aro\
 A","Hoop B":"Aro B","Which hoop the controls change":"Qué aro cambian los controles",Parameters:"Parámetros","Skip to the player":"Ir al reproductor",Hoop:"A\
ro",Plane:"Plano",Start:"Inicio",Contact:"Contacto","Given by":"Dado por","load fraction γ":"fracción de carga γ","ε and κ":"ε y κ","real parts":"piezas \
reales",Where:"Dónde",elsewhere:"otro lugar","static and kinetic friction apart":"rozamiento estático y cinético por separado",Starts:"Empieza",rolling:"roda\
ndo","in any state":"en cualquier estado","auto {value}":"auto {value}","{name}, exact value in {unit}":"{name}, valor exacto en {unit}","{name}, exact value":"\
{name}, valor exacto",Ring:"Anillo",Disk:"Disco","Point mass":"Masa puntual",Rod:"Varilla",mass:"masa","inner radius":"radio interior","outer radius":"radio ext\
erior",radius:"radio","distance from centre":"distancia al centro",length:"longitud","Add a part":"Añadir una pieza","+ add a part …":"+ añadir una pieza…",
"Remove part {number}, {what}":"Quitar la pieza {number}, {what}","{name} = {value} must be {rule}.":"{name} = {value} debe ser {rule}.","{name} = {value} must \
be a number, such as 2.5.":"{name} = {value} debe ser un número, como 2,5.","{name} = {value} must be a number.":"{name} = {value} debe ser un número.","from \
{least} to {most}":"de {least} a {most}","from {least} to {most}, or inf":"de {least} a {most}, o inf","0 or from {least} to {most}":"0 o de {least} a {most}","\
0 or from {least} to {most}, or inf":"0, de {least} a {most}, o inf","at most {most} in the lab":"como mucho {most} en el laboratorio","0 for the massless hoop \
(hoop.inertia_ratio = 0)":"0 para el aro sin masa (hoop.inertia_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"«rigid» para el aro sin ma\
sa (hoop.inertia_ratio = 0)","plane.mu_kinetic = {one} must not exceed plane.mu_static = {other}.":"plane.mu_kinetic = {one} no debe superar plane.mu_static = {\
other}.","The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"El servidor no responde. Lo que hay aquí sigue fu\
ncionando; para cambios hay que volver a ejecutar `hophoop lab`.","The server answered {status}.":"El servidor respondió {status}.","The notebook’s kernel does\
 not answer; run the cell again.":"El núcleo del cuaderno no responde; vuelva a ejecutar la celda.",hoop:"aro",mode:"fase",time:"tiempo",angle:"ángulo",gap:"s\
eparación","rim speed":"velocidad de la llanta",load:"carga","centre of gravity":"centro de gravedad","the same in flight":"el mismo en vuelo",airborne:"en el \
aire","A in front, B behind":"A delante, B detrás","The hoop":"El aro","The hoop.":"El aro.",Time:"Tiempo","{time} seconds, {what}":"{time} segundos, {what}","\
Traces (t)":"Trayectorias (t)","Forces (f)":"Fuerzas (f)","Rim speed (c)":"Velocidad de la llanta (c)","Whole path (w)":"Todo el recorrido (w)","In space (3)":"\
En el espacio (3)",Traces:"Trayectorias",Forces:"Fuerzas","Rim speed":"Vel. llanta","Whole path":"Recorrido","Play (space)":"Reproducir (espacio)","Pause (space\
)":"Pausa (espacio)","Speed of the film":"Velocidad de la película","To the start (Home)":"Al principio (Inicio)","Previous event (Shift ←)":"Suceso anterior\
 (Mayús ←)","Next event (Shift →)":"Suceso siguiente (Mayús →)","One frame back (←)":"Un fotograma atrás (←)","One frame on (→)":"Un fotograma ad\
elante (→)",landing:"aterrizaje","To the next flight (h)":"Al siguiente vuelo (h)","To the next landing (l)":"Al siguiente aterrizaje (l)","This motion has no\
 flight.":"Este movimiento no tiene vuelo.","This motion has no landing.":"Este movimiento no tiene aterrizaje.","{what} at {angle}, {time} s":"{what} a {angle}\
, {time} s",start:"inicio","slip begins":"empieza el deslizamiento","slip ends":"acaba el deslizamiento","slip turns round":"se invierte el deslizamiento","take\
-off":"despegue","turns back":"da la vuelta","highest point":"punto más alto","bounces end":"acaban los rebotes","Painlevé: several solutions":"Painlevé: vari\
as soluciones","energy gain (Kane)":"ganancia de energía (Kane)","skimming begins":"empieza el roce","at rest":"en reposo",end:"final","What happens":"Qué ocur\
re","What happens to hoop {hoop}":"Qué le ocurre al aro {hoop}","The motion in words":"El movimiento en palabras","(not all events are shown)":"(no se muestran\
 todos los sucesos)","What theory says":"Qué dice la teoría","What theory says of hoop {hoop}":"Qué dice la teoría del aro {hoop}",Velocities:"Velocidades",
"velocity [m/s]":"velocidad [m/s]","v (centre)":"v (centro)","Energies and losses":"Energías y pérdidas","energy [J]":"energía [J]",kinetic:"cinética",potential:"\
potencial",total:"total","lost to friction":"perdida por rozamiento","lost in the damper":"perdida en el amortiguador","lost in impacts, normal part":"perdida e\
n impactos, parte normal","Contact forces":"Fuerzas de contacto","force [N]":"fuerza [N]","normal N":"normal N","friction F":"rozamiento F","Use of friction":"U\
so del rozamiento","Your choice":"A tu elección","What your diagram shows":"Qué muestra tu diagrama","Horizontal axis of the diagrams":"Eje horizontal de los \
diagramas","over {quantity}":"en función de: {quantity}","Whole motion":"Todo el movimiento","slide to go there, two fingers zoom":"desliza para ir ahí; dos de\
dos amplían","click to go there, drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"clic para ir ahí, arrastrar para ampliar; tr\
as un clic, o con Ctrl, la rueda amplía; doble clic para todo","{name} from {low} to {high}":"{name} de {low} a {high}","Diagram: {title} in {unit}.":"Diagrama\
: {title} en {unit}.","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"ángulo dentro de una vuelta","place of\
 the centre":"posición del centro","gap under the rim":"separación bajo la llanta","height of the centre of gravity":"altura del centro de gravedad","speed of\
 the centre":"velocidad del centro","speed of rotation":"velocidad de rotación","speed away from the plane":"velocidad de alejamiento del plano","slip velocity":"\
velocidad de deslizamiento","angular velocity":"velocidad angular","normal force":"fuerza normal","friction force":"fuerza de rozamiento","use of friction":"uso\
 del rozamiento","kinetic energy":"energía cinética","potential energy":"energía potencial","total energy":"energía total","Plane of θ and θ̇":"Plano de \
θ y θ̇","Plane of angle and angular velocity with the regions of rolling, slip and flight":"Plano de ángulo y velocidad angular con las regiones de rodadura,\
 deslizamiento y vuelo","angle θ within a turn [°]":"ángulo θ dentro de una vuelta [°]","no answer":"sin respuesta","Colours: the mode that follows contact\
 without slip. Hatched: slip that meets Painlevé’s paradox.":"Colores: la fase que sigue al contacto sin deslizamiento. Rayado: deslizamiento que encuentra l\
a paradoja de Painlevé.","Tap to go there, two fingers zoom.":"Toca para ir ahí; dos dedos amplían.","Click to go there; two fingers zoom.":"Toca para ir ahí\
; dos dedos amplían.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Clic para ir ahí; tras un clic, o con Ctrl, la r\
ueda amplía; doble clic para todo.",Map:"Mapa",of:"de",Across:"Horizontal",Up:"Vertical","What the map shows":"Qué muestra el mapa","Map of motions":"Mapa de \
movimientos","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Mapa de movimientos. Las flechas mueven la marca, Intro t\
oma el movimiento, más y menos amplían.","Zoom into the map":"Ampliar el mapa","Zoom out of the map":"Reducir el mapa","Whole map":"Mapa entero","Click to tak\
e that motion into the player; two fingers zoom.":"Toca para llevar ese movimiento al reproductor; dos dedos amplían.","Click to take that motion into the play\
er; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Un clic lleva ese movimiento al reproductor; tras un clic, o con Ctrl, la\
 rueda amplía; arrastrar desplaza; doble clic para todo.","computing {count} motions …":"calculando {count} movimientos…","{count} motions":"{count} movimi\
entos","{count} motions, with rigid contact":"{count} movimientos, con contacto rígido","of rolling starts, though this motion starts otherwise":"con salidas r\
odando, aunque este movimiento empieza de otro modo","of starts in any state, though this motion starts rolling":"desde cualquier estado, aunque este movimiento\
 empieza rodando","compiling the kernel of maps, this once: {done} of {all} functions":"compilando el núcleo de los mapas, solo esta vez: {done} de {all} funcio\
nes",Keep:"Guardar","Copy the link":"Copiar el enlace","Scenario (TOML)":"Escenario (TOML)","States (CSV)":"Estados (CSV)","Motion (netCDF)":"Movimiento (netCDF\
)","Events (JSON)":"Sucesos (JSON)","Film (MP4)":"Película (MP4)","Picture (PNG)":"Imagen (PNG)","Record a film here (WebM)":"Grabar aquí una película (WebM)",
"Show me the Python":"Ver el código Python","The same motion in Python":"El mismo movimiento en Python","The link is copied.":"El enlace está copiado.","The l\
ink to this motion":"El enlace a este movimiento","The film is being made; this takes a while …":"Se está haciendo la película; tarda un poco…","Fetching \
{name} …":"Obteniendo {name}…","{name} is there.":"{name} ya está.","This browser cannot record a canvas; take the MP4 instead.":"Este navegador no puede g\
rabar el lienzo; use el MP4.","Recording one run …":"Grabando una pasada…","The film is there.":"La película ya está.","The scenario as a file":"El escena\
rio como archivo",Copy:"Copiar",Copied:"Copiado",Close:"Cerrar","A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane c\
an only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"Un anillo con una carga en la lla\
nta rueda sobre un plano. El rozamiento aguanta hasta un límite y el plano solo puede empujar: por eso desliza, salta, aterriza… o hace algo que la mecánica del\
 sólido rígido no puede decidir. Mueve un control y observa.",Modes:"Fases","Marks on the bar of time":"Marcas en la barra de tiempo",Keys:"Teclas",space:"esp\
acio","play, pause":"reproducir, pausa","one frame":"un fotograma","Shift ← →":"Mayús ← →","previous, next event":"suceso anterior, siguiente","next fl\
ight, landing":"siguiente vuelo, aterrizaje","slower, faster":"más lento, más rápido","Home End":"Inicio Fin","start, end":"principio, final","traces, forces\
, rim speed, whole path":"trayectorias, fuerzas, velocidad de la llanta, recorrido","in space":"en el espacio","zoom, zoom back":"ampliar, volver","leave a fiel\
d, a menu, a picture that the wheel zooms":"salir de un campo, un menú o una imagen que amplía la rueda","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"deshacer, r\
ehacer","dark, light":"oscuro, claro",Python:"Python","the rim does not slide":"la llanta no desliza","slip: the rim turns too fast for the way it goes (slip −,\
 for a hoop that rolls ahead)":"deslizamiento: la llanta gira demasiado deprisa para lo que avanza (deslizamiento −, si el aro rueda hacia delante)","slip: th\
e rim slides ahead (slip +, for a hoop that rolls ahead)":"deslizamiento: la llanta desliza hacia delante (deslizamiento +, si el aro rueda hacia delante)","the\
 hop: from take-off to landing":"el salto: del despegue al aterrizaje","a massless rim that touches without force":"una llanta sin masa que toca sin fuerza","ta\
ke-off, landing":"despegue, aterrizaje","Painlevé’s paradox: no solution, several":"Paradoja de Painlevé: ninguna solución, varias","bounces without number\
 end":"acaban infinitos rebotes","skimming begins, rest":"empieza el roce, reposo","Single keys (letters, digits, signs) do what the table says":"Las teclas sue\
ltas (letras, cifras, signos) hacen lo que dice la tabla","The hoop in your hand":"El aro en tu mano","Slope of the plane":"Inclinación del plano","Tilt the pl\
ane: drag, or arrow keys":"Inclinar el plano: arrastrar o flechas","The hoop: height and speed":"El aro: altura y velocidad","Lift, roll or throw the hoop: drag\
, or arrow keys":"Levantar, rodar o lanzar el aro: arrastrar o flechas","Angle of the load":"Ángulo de la carga","Turn the load: drag, or arrow keys":"Girar la\
 carga: arrastrar o flechas","gap {height}, speed {speed} m/s":"separación {height}, velocidad {speed} m/s",Repeat:"Repetir","Slow motion: a tenth of the speed":"\
Cámara lenta: una décima parte","Sound of the contact":"Sonido del contacto","Presentation on the whole screen":"Presentación a pantalla completa","Guided vi\
sit":"Visita guiada","Table of the motion":"Tabla del movimiento","Table of the motion, rows":"Tabla del movimiento, filas",Presentation:"Presentación","For te\
achers":"Para docentes",Table:"Tabla",Every:"Cada","Save as CSV":"Guardar como CSV",Columns:"Columnas","The first {count} rows.":"Las primeras {count} filas.",Challenges:"\
Retos","Leave the challenges":"Salir de los retos","Which challenge":"Qué reto",Score:"Puntuación","Begin again":"Empezar de nuevo","Show a best one":"Ver una\
 de las mejores","{stars} {points} points. {what}":"{stars} {points} puntos. {what}","Your best: {points} points.":"Tu mejor: {points} puntos.","Hop highest":"E\
l salto más alto","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. How high can the hoop rise within 6 s?":"\
En suelo horizontal, rodando, con 3,1 m/s como mucho: eliges la carga, dónde empieza y el rozamiento. ¿Hasta qué altura puede subir el aro en 6 s?","Land upr\
ight":"Aterrizar en pie","Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.":"Haz que el aro a\
terrice con la carga arriba del todo. Todo vale; el primer salto debe tener al menos 5 cm de altura.","Hop without skidding":"Saltar sin derrapar","On level gro\
und the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How \
high does it hop?":"En suelo horizontal el aro empieza rodando con la carga abajo, a 10 m/s como mucho, y μ no pasa de 1,5. Antes de saltar no debe derrapar; pa\
tinar sí puede. ¿Hasta qué altura salta?","Rigid contact only.":"Solo contacto rígido.","The plane must be level.":"El plano debe ser horizontal.","It must \
be on Earth.":"Debe ser en la Tierra.","Restitution must be 0.":"La restitución debe ser 0.","The radius must stay 1 m, without parts.":"El radio debe seguir s\
iendo 1 m, sin piezas.","At most 90 % of the mass may be in the load.":"Como mucho el 90 % de la masa puede estar en la carga.","The hoop must be given by its l\
oad fraction.":"El aro debe darse por la fracción de carga.","It must start rolling.":"Debe empezar rodando.","At most 10 m/s.":"Como mucho 10 m/s.","At most 3\
.1 m/s.":"Como mucho 3,1 m/s.","At most 6 s.":"Como mucho 6 s.","It does not hop.":"No salta.","It rises by {height}.":"Sube {height}.","The first hop is too lo\
w.":"El primer salto es demasiado bajo.","It lands {off} away from the top.":"Aterriza a {off} de lo más alto.","The load must start at the bottom.":"La carga \
debe empezar abajo.","Friction must be at most 1.5.":"El rozamiento debe ser como mucho 1,5.","It skids before it hops.":"Derrapa antes de saltar.","New here?":"\
¿Primera vez?","Eight short questions: guess, then play.":"Ocho preguntas cortas: adivina y luego reproduce.","Start the visit":"Empezar la visita","Not now":"\
Ahora no","The hoop, before it is let go.":"El aro, antes de soltarlo.",Play:"Reproducir",Next:"Siguiente",Back:"Atrás",Done:"Hecho","Step {number} of {all}":"\
Paso {number} de {all}","Leave the visit":"Salir de la visita","First say what you expect, then play.":"Di primero qué esperas y luego reproduce.","Your guess":"\
Tu respuesta","{points} of 100 points.":"{points} de 100 puntos.","You have {sum} of {most} points.":"Tienes {sum} de {most} puntos.","{what} with the load at {\
angle}":"{what} con la carga a {angle}","Draw the curve: pull the points up and down":"Dibuja la curva: mueve los puntos arriba y abajo","Littlewood’s question":"\
La pregunta de Littlewood","A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked \
in 1953 what happens when the weight is level with the centre.":"Un aro sin masa lleva un peso en la llanta. Con el peso arriba recibe el menor empujón y rueda.\
 J. E. Littlewood preguntó en 1953 qué ocurre cuando el peso está a la altura del centro.","What do you think?":"¿Qué crees?","It rolls on.":"Sigue rodando\
.","It hops: the hoop leaves the plane.":"Salta: el aro deja el plano.","The weight falls freely, and the hoop skims the plane below it.":"El peso cae librement\
e y el aro roza el plano debajo de él.","At {angle} there is no contact force any more.":"A {angle} ya no hay fuerza de contacto.","Littlewood said that the ho\
op hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass \
in its rim.":"Littlewood dijo que el aro salta. Pero la fuerza de contacto es nula, no hacia arriba: el peso cae libremente y una llanta sin masa lo sigue por e\
l plano. Para saltar, un aro necesita algo de masa en la llanta.","A ring with mass":"Un anillo con masa","Now a quarter of the mass is in the ring. Again the l\
oad is at the top, and the hoop gets the smallest push.":"Ahora un cuarto de la masa está en el anillo. De nuevo la carga está arriba y el aro recibe el menor e\
mpujón.","Draw how fast the hoop’s centre goes during the first turn.":"Dibuja la velocidad del centro del aro durante la primera vuelta.","Speed of the cent\
re":"Velocidad del centro","With the load at the bottom the centre has {speed} m/s.":"Con la carga abajo el centro va a {speed} m/s.","The lowest point of a rol\
ling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: it is faster than a stone that falls from t\
he same height.":"El punto más bajo de un aro que rueda está en reposo. Ahí la carga no tiene energía cinética, y el anillo ligero tiene toda la que ha perdido \
la carga pesada: va más rápido que una piedra que cae desde la misma altura.","Why it slips":"Por qué desliza","A harder push: 2.8 m/s at the top. Rolling ne\
eds friction, and friction has a limit: it is at most μ N.":"Un empujón más fuerte: 2,8 m/s arriba. Rodar exige rozamiento, y el rozamiento tiene un límite: co\
mo mucho μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"¿Dónde está la carga cuando el rozamiento cede por primera vez? \
Gira la marca.","Angle of the load where it begins to slip":"Ángulo de la carga donde empieza a deslizar","It begins to slip at {angle}. There the plane carrie\
s only {share} of the weight.":"Empieza a deslizar a {angle}. Ahí el plano soporta solo el {share} del peso.","The load on its way down and round presses littl\
e on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.":"En su c\
amino hacia abajo la carga apenas aprieta el plano, así que N es pequeña, mientras que el anillo debe acelerarse: eso exige rozamiento. Mira el diagrama «Uso de\
l rozamiento»: llega a 1.","The hop":"El salto","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn is over.":"Un poco más rá\
pido, 3,1 m/s. Esta vez el aro deja el plano antes de acabar la primera vuelta.","Where is the load when the hoop takes off? Turn the mark.":"¿Dónde está la car\
ga cuando el aro despega? Gira la marca.","Angle of the load where it takes off":"Ángulo de la carga al despegar","It takes off at {angle}, while its rim slips\
 at {slip} m/s.":"Despega a {angle}, mientras su llanta desliza a {slip} m/s.","A rolling hoop would be braked by the plane while the load comes up. Friction is\
 too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the top.":"A un aro que rueda el plano lo \
frenaría mientras sube la carga. El rozamiento es demasiado débil para eso: la llanta patina, el aro sigue girando deprisa y la carga lo arranca del plano antes\
 de llegar arriba.","The landing":"El aterrizaje","The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.":"El aro está en el ai\
re. Su centro de gravedad sigue una parábola y gira de manera uniforme.","What does it do just after it has landed?":"¿Qué hace justo después de aterrizar?",
"It rolls at once.":"Rueda de inmediato.","It skids: the rim slides ahead.":"Derrapa: la llanta desliza hacia delante.","It spins: the rim turns too fast.":"Pat\
ina: la llanta gira demasiado deprisa.","It bounces.":"Rebota.","It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Es\
tuvo {time} s en el aire y subió {height} cm; aterriza con la carga a {angle}.","An impact takes no time, but its friction is as strong as its push: here it is\
 enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards.":"Un impacto no dura nada, pero su rozam\
iento es tan fuerte como su empuje: aquí basta para detener todo deslizamiento. Con menos rozamiento, o más restitución, el aterrizaje sería otro. Pruébalo desp\
ués.","More friction, more hop?":"¿Más rozamiento, más salto?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Tres \
aros reciben el mismo empujón de 3,1 m/s, en planos con rozamiento 0,05, 0,2 y 1,0.","Which of them hops highest?":"¿Cuál salta más alto?","They rise by {lo\
w} cm, {middle} cm and {high} cm. (The first two are A and B.)":"Suben {low} cm, {middle} cm y {high} cm. (Los dos primeros son A y B.)","On ice nothing drives \
the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked \
on the way up.":"Sobre hielo nada impulsa el giro; con rozamiento sin fin nada desliza. El salto necesita ambas cosas: rozamiento bastante para girar deprisa en\
 la bajada, y no tanto que lo frene en la subida.","What rigid bodies cannot decide":"Lo que los sólidos rígidos no pueden decidir","A hoop is thrown so that \
it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Se lanza un aro de modo que deslice deprisa sobre\
 un plano rugoso. Las leyes del sólido rígido con rozamiento seco deben decir qué ocurre después.","What do they say?":"¿Qué dicen?","It flies off.":"Sale\
 volando.","An impact stops the slide at once.":"Un impacto detiene el deslizamiento de golpe.","Both agree with the laws.":"Ambas cosas cumplen las leyes.","Ho\
op A and hoop B start alike, and both motions obey every law.":"El aro A y el aro B empiezan igual, y ambos movimientos cumplen todas las leyes.","Painlevé foun\
d this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contac\
t under ‘Contact’.":"Painlevé lo descubrió en 1895. Para un sólido rígido las leyes tienen aquí dos respuestas, y en otros estados ninguna. Los cuerpos real\
es ceden un poco, y eso decide: elige el contacto flexible en «Contacto».","Your turn":"Te toca a ti","Take the hoop: turn the load, lift the hoop and let it \
drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the motion itself.":"Toma el aro: gira la carga, levántalo y su\
éltalo, dale un impulso, inclina el plano. O acepta un reto y mira cómo tu puntuación se calcula del propio movimiento.","Show the hoop at full speed, once, \
without a comment. “I push it. Does it only roll?”":"Mostrar el aro a toda velocidad, una vez, sin comentar. «Lo empujo. ¿Solo rueda?»","Everybody predic\
ts where the load is at take-off. Count the votes by quarters of the turn.":"Todos predicen dónde está la carga al despegar. Contar los votos por cuartos de vue\
lta.","Energy on the way down, in pairs: who has the energy when the load is at rest?":"Energía en la bajada, por parejas: ¿quién tiene la energía cuando la car\
ga está en reposo?","Lift at the top: at which speed is the force of the floor zero?":"Elevación arriba: ¿a qué velocidad es nula la fuerza del suelo?","The\
 film again, in slow motion and with forces; stop at take-off. Compare with the votes.":"La película otra vez, a cámara lenta y con fuerzas; parar al despegar. \
Comparar con los votos.","Each group takes one speed of the worksheet; results on the board.":"Cada grupo toma una velocidad de la hoja de trabajo; resultados e\
n la pizarra.","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?":"¿Por qué? ¿Qué debe frenar el giro en la \
subida, qué fuerza puede tener y qué pasa si es demasiado débil?","One sentence each: “The hoop hops because …”":"Una frase cada uno: «El aro salta por\
que…»","The load pulls the hoop up at the top, so it hops there.":"La carga tira del aro hacia arriba en lo alto, por eso salta ahí.","Only if it is very fa\
st. Slower hoops hop before the top, after slipping.":"Solo si es muy rápido. Los más lentos saltan antes de lo alto, tras deslizar.","It hops at the bottom, \
where it is fastest.":"Salta abajo, donde es más rápido.","There the floor pushes hardest: the load has to be turned upwards.":"Ahí el suelo empuja más: hay q\
ue desviar la carga hacia arriba.","Nothing can be faster than a falling stone.":"Nada puede ser más rápido que una piedra que cae.","The ring can: it gets th\
e energy of a load that has come to rest.":"El anillo sí: recibe la energía de una carga que ha quedado en reposo.","Friction always brakes.":"El rozamiento s\
iempre frena.","It acts against slip. On the hoop’s way up it points forwards.":"Actúa contra el deslizamiento. En la subida apunta hacia delante.","More fri\
ction, more hop.":"Más rozamiento, más salto.","There is a best friction in between.":"Hay un rozamiento óptimo intermedio.","A heavier hoop behaves otherwis\
e.":"Un aro más pesado se comporta de otro modo.","Only the shares of mass count.":"Solo cuentan las proporciones de masa.","Before the film: where is the load\
 when the hoop leaves the floor? Mark the place and give one reason.":"Antes de la película: ¿dónde está la carga cuando el aro deja el suelo? Marca el lugar y \
da una razón.","The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"El aro recibe sol\
o el menor empujón y rueda. ¿Cuánta energía potencial se ha liberado cuando la carga está abajo?","While a wheel rolls, its lowest point is at rest. Which \
part of the hoop has kinetic energy then, and how fast is the centre?":"Mientras una rueda rueda, su punto más bajo está en reposo. ¿Qué parte del aro tiene ent\
onces energía cinética y a qué velocidad va el centro?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"¿Qué veloc\
idad tiene una piedra que cae desde la altura de la carga? ¿Por qué puede ser más rápido el aro?","Find the force of the floor at the top for 1.0 m/s, and t\
he speed at which it becomes zero.":"Halla la fuerza del suelo arriba para 1,0 m/s y la velocidad a la que se anula.","In the lab: what does the hoop do in its \
first 1.5 s, and at which angle does it hop? Fill in the table.":"En el laboratorio: ¿qué hace el aro en sus primeros 1,5 s y a qué ángulo salta? Completa la ta\
bla.","Find the smallest speed with which the hoop hops, to 1 cm/s.":"Halla la menor velocidad con la que el aro salta, con 1 cm/s de precisión.","At 2.2 m/s t\
he hoop leaves the floor while its rim slips. Why does slipping help it to hop?":"A 2,2 m/s el aro deja el suelo mientras su llanta desliza. ¿Por qué le ayuda a\
 saltar el deslizamiento?",Show:"Mostrar","Teaching with the hoop":"Enseñar con el aro",Worksheet:"Hoja de trabajo",Solutions:"Soluciones",Exercises:"Ejercicio\
s","A lesson of 45 minutes":"Una clase de 45 minutos",Minute:"Minuto",Motion:"Movimiento","What students often think":"Lo que suelen pensar los estudiantes",Idea:"\
Idea","What is right":"Lo correcto","Worksheet: the hoop that hops":"Hoja de trabajo: el aro que salta","A thin ring of radius 0.40 m has a mass of 0.25 kg. A l\
oad of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Un\
 anillo delgado de radio 0,40 m tiene una masa de 0,25 kg. En su llanta va fijada una carga de 0,75 kg. El aro está sobre un suelo horizontal con la carga arrib\
a y se empuja hacia la derecha. Rozamiento: μ = 1; g = 9,81 m/s².",phases:"fases","does it hop?":"¿salta?","at which angle?":"¿a qué ángulo?",Print:"Impri\
mir","The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student.":"La visita pregunta antes de mostrar; la pre\
sentación llena la pantalla; la tabla da números a cada estudiante.","Slips, hops":"Desliza, salta","no threshold uphill (β < 0): whether it slips or hops han\
gs on where it turns back; the map shows it":"cuesta arriba (β < 0) no hay umbral: que deslice o salte depende de dónde da la vuelta; el mapa lo muestra","A b\
lue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A azul, B ocre; el trazo indica la magnitud; números de {hoop}; {hands}"};var Bs={roll:"roulement",spin:"patinage",skid:"dérapage",flight:"vol",skim:"effleurement",hop:"saut","slip −":"glissement −","slip +":"glissement +",rolls:"\
roule",spins:"patine",skids:"dérape",flies:"vole","skims the plane":"effleure le plan","rolls at {angle}":"roule à partir de {angle}","spins at {angle}":"pati\
ne à partir de {angle}","skids at {angle}":"dérape à partir de {angle}","flies at {angle}":"vole à partir de {angle}","skims the plane at {angle}":"effleure\
 le plan à partir de {angle}","hops at {angle}":"saute à {angle}","lands at {angle}":"retombe à {angle}","bounces at {angle}":"rebondit à {angle}","slips th\
e other way at {angle}":"glisse dans l’autre sens à partir de {angle}","stops its slip at once at {angle}":"cesse brusquement de glisser à {angle}","turns b\
ack at {angle}":"fait demi-tour à {angle}","has bounced out at {angle}":"finit de rebondir à {angle}","meets Painlevé's paradox at {angle}":"rencontre le par\
adoxe de Painlevé à {angle}","meets Painlevé's indeterminacy at {angle}":"rencontre l’indétermination de Painlevé à {angle}","jams at {angle}":"se coinc\
e à {angle}","gains energy (Kane) at {angle}":"gagne de l’énergie (Kane) à {angle}","skims at {angle}":"effleure à partir de {angle}","rests at {angle}":"\
repose à {angle}","starts at {angle}":"part à {angle}","slips at {angle}":"glisse à partir de {angle}","{what} and {count} more times":"{what} et encore {cou\
nt} fois","… ({count} more)":"… (encore {count})","It has come to rest.":"Il s’est immobilisé.","The normal force grows without bound (dynamic jam): rigi\
d-body mechanics has no motion beyond.":"La force normale croît sans limite (coincement dynamique) : la mécanique du solide ne donne pas de suite au mouvement.",
"The model does not determine the motion beyond.":"Le modèle ne détermine pas la suite du mouvement.","The limit of events (contact.max_events), or of work fo\
r one motion, was reached before the end.":"La limite du nombre d’événements (contact.max_events), ou du calcul pour un mouvement, a été atteinte avant la fin.",
"It starts and {verb} with the load at {angle} and the centre at {speed} m/s.":"Il part et {verb}, la masselotte à {angle} et le centre à {speed} m/s.","It st\
arts in the air with the load at {angle} and the centre at {speed} m/s.":"Il part en l’air, la masselotte à {angle} et le centre à {speed} m/s.","It starts \
skimming with the load at {angle} and the centre at {speed} m/s.":"Il part en effleurant le plan, la masselotte à {angle} et le centre à {speed} m/s.","It {ve\
rb} at {angle}; friction is used up: the rim turns too fast for the way it goes.":"À {angle} il {verb} : le frottement est épuisé, la jante tourne trop vite pou\
r son trajet.","It {verb} at {angle}; friction is used up: the rim slides ahead.":"À {angle} il {verb} : le frottement est épuisé, la jante glisse vers l’avant.",
"It rolls again at {angle}; the slip has stopped.":"À {angle} il roule de nouveau ; le glissement a cessé.","The slip turns round at {angle}; it {verb}.":"À {\
angle} le glissement s’inverse ; il {verb}.","It hops at {angle}.":"Il saute à {angle}.","It hops at {angle}. It rises {height} and stays up for {time} s.":"\
Il saute à {angle}. Il monte de {height} et reste {time} s en l’air.","An impact without collision at {angle} stops the slip; then it {verb}.":"Un impact san\
s collision à {angle} arrête le glissement ; puis il {verb}.","It lands at {angle} with {speed} m/s downwards and bounces.":"Il retombe à {angle} avec {speed}\
 m/s vers le bas et rebondit.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Il retombe à {angle} avec {speed} m/s vers le bas et {verb}.","It \
turns back at {angle}.":"Il fait demi-tour à {angle}.","It turns back at {angle}, and {verb} now.":"Il fait demi-tour à {angle}, et maintenant il {verb}.","Th\
e centre is highest at {angle}: the gap is {height}.":"Le centre est au plus haut à {angle} : l’écart est de {height}.","Bounces without number end here, at\
 {angle}.":"Ici, à {angle}, s’achève une infinité de rebonds.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Paradoxe de Painl\
evé à {angle} : aucune force de contact n’est compatible avec ce glissement.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Parad\
oxe de Painlevé à {angle} : plusieurs forces de contact sont compatibles.","Dynamic jam at {angle}: the contact force grows without bound.":"Coincement dynami\
que à {angle} : la force de contact croît sans limite.","Newton's law of impact has created {energy} J (Kane's example).":"La loi d’impact de Newton a créé {e\
nergy} J (exemple de Kane).","No contact force is left at {angle}: the load falls freely and the rim skims the plane.":"À {angle} il n’y a plus de force de cont\
act : la masselotte tombe en chute libre et la jante effleure le plan.","It rests at {angle}.":"Il repose à {angle}.","It rests at {angle}, which is not stable\
.":"Il repose à {angle}, mais pas de façon stable.","It bounces {count} more times.":"Il rebondit encore {count} fois.","… and {count} more.":"… et encore {\
count}.",Slips:"Glisse",Hops:"Saute","Hops at once":"Saute aussitôt","Friction for pure rolling":"Frottement pour rouler sans glisser","Painlevé’s paradox":"\
Paradoxe de Painlevé","Dynamic jam":"Coincement dynamique","Rests stably":"Repos stable","End of rolling":"Fin du roulement","would slip above {speed} m/s":"gl\
isserait au-delà de {speed} m/s","would slip: any push is enough":"glisserait : la moindre poussée suffit","would hop in its first turn above {speed} m/s":"sa\
uterait au premier tour au-delà de {speed} m/s","would hop in its first turn: any push is enough":"sauterait au premier tour : la moindre poussée suffit","wou\
ld hop at once above {speed} m/s":"sauterait aussitôt au-delà de {speed} m/s","would hop at once: at any speed":"sauterait aussitôt : à toute vitesse","neve\
r, at any speed":"jamais, à aucune vitesse","no friction keeps it rolling":"aucun frottement ne le fait rouler sans glisser","μ = {mu} would keep it rolling (e\
nough here)":"μ = {mu} le ferait rouler sans glisser (ici, cela suffit)","μ = {mu} would keep it rolling (more than there is)":"μ = {mu} le ferait rouler sans\
 glisser (plus qu’ici)",never:"jamais","from μ = {mu} on, at {angle}: possible here":"à partir de μ = {mu}, à {angle} : possible ici","from μ = {mu} on, a\
t {angle}: not here":"à partir de μ = {mu}, à {angle} : pas ici","can end a slip at {angles}":"peut terminer un glissement à {angles}","with the load at {an\
gle}":"avec la masselotte à {angle}","at {angle} friction is used up":"à {angle} le frottement est épuisé","at {angle} the contact force is gone":"à {angle}\
 la force de contact a disparu","Load fraction":"Part de la masselotte","Share of the mass in the load of an ideal hoop":"Part de la masse qui est dans la masse\
lotte d’un cerceau idéal",Eccentricity:"Excentricité","Distance of the centre of gravity from the centre, over the radius":"Distance du centre de gravité au\
 centre, divisée par le rayon","Inertia ratio":"Moment d’inertie réduit","Moment of inertia about the centre of gravity over m R²":"Moment d’inertie par ra\
pport au centre de gravité, divisé par m R²",Radius:"Rayon","Rim radius":"Rayon de la jante",Mass:"Masse","Total mass":"Masse totale",Friction:"Coefficient d\
e frottement","Friction, static and kinetic":"Coefficient de frottement, statique et dynamique","Static friction":"Frottement statique","Kinetic friction":"Frot\
tement dynamique",Slope:"Inclinaison","Slope of the plane, downhill along +x":"Inclinaison du plan, descente vers +x",Gravity:"Pesanteur",Restitution:"Restituti\
on","Restitution of an impact":"Coefficient de restitution d’un impact",Speed:"Vitesse","Velocity of the centre in a rolling start":"Vitesse du centre au dépa\
rt en roulant","Load angle":"Angle de la masselotte","Angle from the plane's normal to the centre of gravity":"Angle entre la normale au plan et le centre de gr\
avité","Height of the gap":"Hauteur de l’écart","Gap between rim and plane":"Écart entre la jante et le plan","Speed along":"Vitesse le long du plan","Velo\
city of the centre along the plane":"Vitesse du centre le long du plan","Speed upwards":"Vitesse vers le haut","Velocity of the centre away from the plane":"Vit\
esse du centre en s’éloignant du plan","Angular velocity":"Vitesse angulaire",Stiffness:"Raideur","Stiffness of the contact":"Raideur du contact","Slip speed":"\
Vitesse de glissement","Slip velocity over which friction builds up":"Vitesse de glissement sur laquelle le frottement s’établit","Restitution that the dampi\
ng is chosen for":"Restitution pour laquelle l’amortissement est choisi",Duration:"Durée","Duration of the motion":"Durée du mouvement","Law of impact":"Loi\
 d’impact","Law of restitution":"Loi de restitution","Stronge (energy)":"Stronge (énergie)","Poisson (impulse)":"Poisson (impulsion)","Newton (velocity)":"Ne\
wton (vitesse)","Painlevé: two solutions":"Painlevé : deux solutions","What follows an indeterminate contact":"Ce qui suit un contact indéterminé",impact:"i\
mpact","Contact model":"Modèle de contact",rigid:"rigide",compliant:"souple","Normal force":"Force normale","Friction law":"Loi de frottement","Regularised fri\
ction":"Frottement régularisé","smooth (tanh)":"lisse (tanh)",linear:"linéaire","bristle (can hold)":"soies (peut retenir)","Kelvin–Voigt":"Kelvin–Voigt",
"Hunt–Crossley":"Hunt–Crossley","Speed v₀":"Vitesse v₀","Angle of the load θ₀":"Angle de la masselotte θ₀","Speed along ẋ₀":"Vitesse le long d\
u plan ẋ₀","Angular velocity θ̇₀":"Vitesse angulaire θ̇₀","Height of the gap y₀":"Hauteur de l’écart y₀","Load fraction γ":"Part de la masse\
lotte γ","Eccentricity ε":"Excentricité ε","Inertia ratio κ":"Moment d’inertie réduit κ","Radius R":"Rayon R","Friction μ":"Frottement μ","Slope β":"\
Inclinaison β","Gravity g":"Pesanteur g","Restitution e":"Restitution e",Earth:"Terre",Moon:"Lune",Mars:"Mars",Jupiter:"Jupiter",Weightless:"Apesanteur","what \
happens in the first turn":"ce qui se passe au premier tour","height of the first hop":"hauteur du premier saut","angle of take-off":"angle de décollage","dura\
tion of the first hop":"durée du premier saut","greatest friction utilization":"plus grande utilisation du frottement","energy lost":"énergie perdue","angle a\
t the end":"angle à la fin","Painlevé’s paradox or jam met":"paradoxe de Painlevé ou coincement rencontré","how it ends":"comment cela finit",duration:"du\
rée",revolutions:"tours",reversal:"demi-tour",takeoff:"décollage",rest:"repos",jam:"coincement",undetermined:"indéterminé","event limit":"limite d’événement\
s",no:"non",yes:"oui",none:"aucun","not allowed":"non permis","and {count} more":"et {count} autres","The article":"L’article","Littlewood's hoop":"Le cerceau\
 de Littlewood",Paradoxes:"Paradoxes",More:"Autres","It hops: 3.1 m/s":"Il saute : 3,1 m/s","Slips twice, then leaves the plane just before a full turn and flie\
s for 0.76 s.":"Glisse deux fois, puis quitte le plan juste avant un tour complet et vole pendant 0,76 s.","It slips: 2.8 m/s":"Il glisse : 2,8 m/s","Friction i\
s used up twice a turn; each slip is weaker than the one before, and none is the last.":"Le frottement est épuisé deux fois par tour ; chaque glissement est plu\
s faible que le précédent, et aucun n’est le dernier.","It rolls: 2 m/s":"Il roule : 2 m/s","Pure rolling, faster and more even than after a slow start, and\
 close to the limit of friction.":"Roulement sans glissement, plus rapide et plus régulier qu’après un départ lent, et près de la limite du frottement.","\
The smallest push: 0.1 m/s":"La plus petite poussée : 0,1 m/s","Nearly at rest with the load up, fast with the load down; 38 % of the friction is used.":"Presq\
ue immobile avec la masselotte en haut, rapide avec la masselotte en bas ; 38 % du frottement est utilisé.","Low friction: 0.1 m/s, μ = 0.3":"Peu de frottemen\
t : 0,1 m/s, μ = 0,3","Slipping costs the energy that a full turn needs: the hoop rocks to and fro.":"Le glissement coûte l’énergie qu’exige un tour complet : \
le cerceau se balance.","All mass in the load":"Toute la masse dans la masselotte","A massless ring: at 90° no contact force is left; the load falls, the rim sk\
ims the plane.":"Un anneau sans masse : à 90° il n’y a plus de force de contact ; la masselotte tombe, la jante effleure le plan.","All mass in the load, pu\
shed":"Toute la masse dans la masselotte, poussé","With a push the contact force is gone earlier, at cos θ = v₀²/(gR).":"Avec une poussée la force de conta\
ct disparaît plus tôt, à cos θ = v₀²/(gR).","Nearly all mass in the load":"Presque toute la masse dans la masselotte","γ = 0.99: what a real ring does in\
stead of Littlewood's hop.":"γ = 0,99 : ce que fait un anneau réel au lieu du saut de Littlewood.","Painlevé: no solution":"Painlevé : aucune solution","No \
contact force agrees with this slip. An impact without collision stops it at once.":"Aucune force de contact n’est compatible avec ce glissement. Un impact sans\
 collision l’arrête aussitôt.","Flight and impact both agree with the laws. Choose which with the switch under Plane.":"Vol et impact obéissent tous deux au\
x lois. Choisissez sous « Plan ».","A fast slide after a hop: the contact force grows without bound in finite time, and no law says what follows.":"Un glissem\
ent rapide après un saut : la force de contact croît sans limite en un temps fini, et aucune loi ne dit la suite.","Kane: energy out of nothing":"Kane : de l’\
énergie à partir de rien","Newton's law of impact with friction creates two joules. Stronge's law does not.":"La loi d’impact de Newton avec frottement crée d\
eux joules. Celle de Stronge, non.",Downhill:"En descente","On a slope of 10° the hoop gains speed from turn to turn, until it hops.":"Sur une pente de 10° le \
cerceau prend de la vitesse tour après tour, jusqu’à ce qu’il saute.","Bounces without number":"Rebonds sans nombre","Dropped with spin and restitution 0.\
5: infinitely many bounces in finite time.":"Lâché en rotation, restitution 0,5 : une infinité de rebonds en un temps fini.","On the Moon":"Sur la Lune","The\
 article's hop under lunar gravity: everything is slower by a factor of 2.46.":"Le saut de l’article sous la pesanteur lunaire : tout est 2,46 fois plus lent.",
"Motions to start from":"Mouvements de départ","Motions to start from …":"Mouvements de départ…","Undo (z)":"Annuler (z)","Redo (y)":"Rétablir (y)",Compare:"\
Comparer","Compare two hoops":"Comparer deux cerceaux","Dark or light (d)":"Sombre ou clair (d)","Keys and help (?)":"Touches et aide (?)","Keys and help":"Touc\
hes et aide",lab:"labo",Learn:"Apprendre",Language:"Langue","Hoop A":"Cerceau A","Hoop B":"Cerceau B","Which hoop the controls change":"Quel cerceau les réglage\
s modifient",Parameters:"Paramètres","Skip to the player":"Aller au lecteur",Hoop:"Cerceau",Plane:"Plan",Start:"Départ",Contact:"Contact","Given by":"Donné pa\
r","load fraction γ":"part de la masselotte γ","ε and κ":"ε et κ","real parts":"pièces réelles",Where:"Où",elsewhere:"ailleurs","static and kinetic fri\
ction apart":"frottements statique et dynamique séparés",Starts:"Part",rolling:"en roulant","in any state":"dans un état quelconque","auto {value}":"auto {va\
lue}","{name}, exact value in {unit}":"{name}, valeur exacte en {unit}","{name}, exact value":"{name}, valeur exacte",Ring:"Anneau",Disk:"Disque","Point mass":"\
Masse ponctuelle",Rod:"Tige",mass:"masse","inner radius":"rayon intérieur","outer radius":"rayon extérieur",radius:"rayon","distance from centre":"distance au\
 centre",length:"longueur","Add a part":"Ajouter une pièce","+ add a part …":"+ ajouter une pièce…","Remove part {number}, {what}":"Retirer la pièce {numb\
er}, {what}","{name} = {value} must be {rule}.":"{name} = {value} doit être {rule}.","{name} = {value} must be a number, such as 2.5.":"{name} = {value} doit ê\
tre un nombre, par exemple 2,5.","{name} = {value} must be a number.":"{name} = {value} doit être un nombre.","from {least} to {most}":"de {least} à {most}","\
from {least} to {most}, or inf":"de {least} à {most}, ou inf","0 or from {least} to {most}":"0 ou de {least} à {most}","0 or from {least} to {most}, or inf":"\
0, de {least} à {most}, ou inf","at most {most} in the lab":"au plus {most} dans le labo","0 for the massless hoop (hoop.inertia_ratio = 0)":"0 pour le cerceau\
 sans masse (hoop.inertia_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"« rigid » pour le cerceau sans masse (hoop.inertia_ratio = 0)",
"plane.mu_kinetic = {one} must not exceed plane.mu_static = {other}.":"plane.mu_kinetic = {one} ne doit pas dépasser plane.mu_static = {other}.","The server do\
es not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"Le serveur ne répond pas. Ce qui est là continue ; pour le modifier, rel\
ancez `hophoop lab`.","The server answered {status}.":"Le serveur a répondu {status}.","The notebook’s kernel does not answer; run the cell again.":"Le noyau\
 du notebook ne répond pas ; relancez la cellule.",hoop:"cerceau",mode:"phase",time:"temps",angle:"angle",gap:"écart","rim speed":"vitesse de la jante",load:"\
masselotte","centre of gravity":"centre de gravité","the same in flight":"le même en vol",airborne:"en l’air","A in front, B behind":"A devant, B derrière",
"The hoop":"Le cerceau","The hoop.":"Le cerceau.",Time:"Temps","{time} seconds, {what}":"{time} secondes, {what}","Traces (t)":"Trajectoires (t)","Forces (f)":"\
Forces (f)","Rim speed (c)":"Vitesse de la jante (c)","Whole path (w)":"Tout le trajet (w)","In space (3)":"En 3D (3)",Traces:"Trajectoires",Forces:"Forces","Ri\
m speed":"Vit. jante","Whole path":"Trajet entier","Play (space)":"Lecture (espace)","Pause (space)":"Pause (espace)","Speed of the film":"Vitesse du film","To \
the start (Home)":"Au début (Début)","Previous event (Shift ←)":"Événement précédent (Maj ←)","Next event (Shift →)":"Événement suivant (Maj →)",
"One frame back (←)":"Une image en arrière (←)","One frame on (→)":"Une image en avant (→)",landing:"retombée","To the next flight (h)":"Au vol suivan\
t (h)","To the next landing (l)":"À la retombée suivante (l)","This motion has no flight.":"Ce mouvement n’a pas de vol.","This motion has no landing.":"Ce \
mouvement n’a pas de retombée.","{what} at {angle}, {time} s":"{what} à {angle}, {time} s",start:"départ","slip begins":"le glissement commence","slip ends":"\
le glissement cesse","slip turns round":"le glissement s’inverse","take-off":"décollage","turns back":"fait demi-tour","highest point":"point le plus haut","\
bounces end":"les rebonds cessent","Painlevé: several solutions":"Painlevé : plusieurs solutions","energy gain (Kane)":"gain d’énergie (Kane)","skimming be\
gins":"l’effleurement commence","at rest":"au repos",end:"fin","What happens":"Ce qui se passe","What happens to hoop {hoop}":"Ce qui arrive au cerceau {hoop}",
"The motion in words":"Le mouvement en mots","(not all events are shown)":"(tous les événements ne sont pas montrés)","What theory says":"Ce que dit la théor\
ie","What theory says of hoop {hoop}":"Ce que dit la théorie du cerceau {hoop}",Velocities:"Vitesses","velocity [m/s]":"vitesse [m/s]","v (centre)":"v (centre)",
"Energies and losses":"Énergies et pertes","energy [J]":"énergie [J]",kinetic:"cinétique",potential:"potentielle",total:"totale","lost to friction":"perdue p\
ar frottement","lost in the damper":"perdue dans l’amortisseur","lost in impacts, normal part":"perdue dans les impacts, part normale","Contact forces":"Force\
s de contact","force [N]":"force [N]","normal N":"normale N","friction F":"frottement F","Use of friction":"Utilisation du frottement","Your choice":"À votre ch\
oix","What your diagram shows":"Ce que montre votre diagramme","Horizontal axis of the diagrams":"Axe horizontal des diagrammes","over {quantity}":"en fonction \
de : {quantity}","Whole motion":"Tout le mouvement","slide to go there, two fingers zoom":"glissez pour y aller ; deux doigts agrandissent","click to go there, \
drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"cliquez pour y aller, tirez pour agrandir ; après un clic, ou avec Ctrl, la mo\
lette agrandit ; double-clic pour tout","{name} from {low} to {high}":"{name} de {low} à {high}","Diagram: {title} in {unit}.":"Diagramme : {title} en {unit}.",
"θ mod 360°":"θ mod 360°",Esc:"Échap","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"angle dans un tour","place of the centre":"position du cen\
tre","gap under the rim":"écart sous la jante","height of the centre of gravity":"hauteur du centre de gravité","speed of the centre":"vitesse du centre","spe\
ed of rotation":"vitesse de rotation","speed away from the plane":"vitesse d’éloignement du plan","slip velocity":"vitesse de glissement","angular velocity":"\
vitesse angulaire","normal force":"force normale","friction force":"force de frottement","use of friction":"utilisation du frottement","kinetic energy":"énergie\
 cinétique","potential energy":"énergie potentielle","total energy":"énergie totale","Plane of θ and θ̇":"Plan de θ et θ̇","Plane of angle and angular \
velocity with the regions of rolling, slip and flight":"Plan de l’angle et de la vitesse angulaire avec les régions de roulement, de glissement et de vol","a\
ngle θ within a turn [°]":"angle θ dans un tour [°]","no answer":"sans réponse","Colours: the mode that follows contact without slip. Hatched: slip that me\
ets Painlevé’s paradox.":"Couleurs : la phase qui suit un contact sans glissement. Hachures : glissement qui rencontre le paradoxe de Painlevé.","Tap to go \
there, two fingers zoom.":"Touchez pour y aller ; deux doigts agrandissent.","Click to go there; two fingers zoom.":"Touchez pour y aller ; deux doigts agrandis\
sent.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Cliquez pour y aller ; après un clic, ou avec Ctrl, la molette a\
grandit ; double-clic pour tout.",Map:"Carte",of:"de",Across:"Horizontale",Up:"Verticale","What the map shows":"Ce que montre la carte","Map of motions":"Carte \
des mouvements","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Carte des mouvements. Les flèches déplacent la marque,\
 Entrée prend le mouvement, plus et moins agrandissent.","Zoom into the map":"Agrandir la carte","Zoom out of the map":"Réduire la carte","Whole map":"Carte e\
ntière","Click to take that motion into the player; two fingers zoom.":"Touchez pour mettre ce mouvement dans le lecteur ; deux doigts agrandissent.","Click to\
 take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Un clic met ce mouvement dans le lecteur ;\
 après un clic, ou avec Ctrl, la molette agrandit ; tirez pour déplacer ; double-clic pour tout.","computing {count} motions …":"calcul de {count} mouvement\
s…","{count} motions":"{count} mouvements","{count} motions, with rigid contact":"{count} mouvements, avec contact rigide","of rolling starts, though this mot\
ion starts otherwise":"partant en roulant, bien que ce mouvement parte autrement","of starts in any state, though this motion starts rolling":"partant d’un état\
 quelconque, bien que ce mouvement parte en roulant","compiling the kernel of maps, this once: {done} of {all} functions":"compilation du noyau des cartes, cett\
e fois seulement : {done} fonctions sur {all}",Keep:"Garder","Copy the link":"Copier le lien","Scenario (TOML)":"Scénario (TOML)","States (CSV)":"États (CSV)",
"Motion (netCDF)":"Mouvement (netCDF)","Events (JSON)":"Événements (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Image (PNG)","Record a film here (WebM)":"\
Enregistrer un film ici (WebM)","Show me the Python":"Montrer le Python","The same motion in Python":"Le même mouvement en Python","The link is copied.":"Le li\
en est copié.","The link to this motion":"Le lien vers ce mouvement","The film is being made; this takes a while …":"Le film se fait ; cela prend un moment…",
"Fetching {name} …":"Récupération de {name}…","{name} is there.":"{name} est là.","This browser cannot record a canvas; take the MP4 instead.":"Ce naviga\
teur ne peut pas enregistrer le canevas ; prenez le MP4.","Recording one run …":"Enregistrement d’un passage…","The film is there.":"Le film est là.","Th\
e scenario as a file":"Le scénario en fichier",Copy:"Copier",Copied:"Copié",Close:"Fermer","A ring with a load on its rim rolls on a plane. Friction can only \
hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"Un a\
nneau lesté d’une masselotte roule sur un plan. Le frottement ne retient pas sans limite et le plan ne peut que pousser : alors il glisse, saute, retombe – ou f\
ait ce que la mécanique du solide ne peut décider. Bougez un réglage et voyez.",Modes:"Phases","Marks on the bar of time":"Marques sur la barre de temps",Keys:"\
Touches",space:"espace","play, pause":"lecture, pause","one frame":"une image","Shift ← →":"Maj ← →","previous, next event":"événement précédent, suivan\
t","next flight, landing":"vol, retombée suivants","slower, faster":"plus lent, plus vite","Home End":"Début Fin","start, end":"début, fin","traces, forces, \
rim speed, whole path":"trajectoires, forces, vitesse de la jante, trajet","in space":"en 3D","zoom, zoom back":"agrandir, revenir","leave a field, a menu, a pi\
cture that the wheel zooms":"quitter un champ, un menu, une image que la molette agrandit","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"annuler, rétablir","dark, \
light":"sombre, clair",Python:"Python","the rim does not slide":"la jante ne glisse pas","slip: the rim turns too fast for the way it goes (slip −, for a hoop t\
hat rolls ahead)":"glissement : la jante tourne trop vite pour son trajet (glissement −, pour un cerceau qui avance)","slip: the rim slides ahead (slip +, for\
 a hoop that rolls ahead)":"glissement : la jante glisse vers l’avant (glissement +, pour un cerceau qui avance)","the hop: from take-off to landing":"le saut\
 : du décollage à la retombée","a massless rim that touches without force":"une jante sans masse qui touche sans force","take-off, landing":"décollage, retom\
bée","Painlevé’s paradox: no solution, several":"Paradoxe de Painlevé : aucune solution, plusieurs","bounces without number end":"une infinité de rebonds s\
’achève","skimming begins, rest":"l’effleurement commence, repos","Single keys (letters, digits, signs) do what the table says":"Les touches seules (lettre\
s, chiffres, signes) font ce que dit le tableau","The hoop in your hand":"Le cerceau dans votre main","Slope of the plane":"Inclinaison du plan","Tilt the plane\
: drag, or arrow keys":"Incliner le plan : tirer, ou flèches","The hoop: height and speed":"Le cerceau : hauteur et vitesse","Lift, roll or throw the hoop: dra\
g, or arrow keys":"Lever, rouler ou lancer le cerceau : tirer, ou flèches","Angle of the load":"Angle de la masselotte","Turn the load: drag, or arrow keys":"T\
ourner la masselotte : tirer, ou flèches","gap {height}, speed {speed} m/s":"écart {height}, vitesse {speed} m/s",Repeat:"Répéter","Slow motion: a tenth of \
the speed":"Ralenti : un dixième de la vitesse","Sound of the contact":"Son du contact","Presentation on the whole screen":"Présentation en plein écran","Gui\
ded visit":"Visite guidée","Table of the motion":"Tableau du mouvement","Table of the motion, rows":"Tableau du mouvement, lignes",Presentation:"Présentation",
"For teachers":"Pour les enseignants",Table:"Tableau",Every:"Toutes les","Save as CSV":"Enregistrer en CSV",Columns:"Colonnes","The first {count} rows.":"Les {c\
ount} premières lignes.",Challenges:"Défis","Leave the challenges":"Quitter les défis","Which challenge":"Quel défi",Score:"Score","Begin again":"Recommence\
r","Show a best one":"Montrer un des meilleurs","{stars} {points} points. {what}":"{stars} {points} points. {what}","Your best: {points} points.":"Votre meilleu\
r : {points} points.","Hop highest":"Sauter le plus haut","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?":"Sur sol horizontal, en roulant, à 3,1 m/s au plus : vous choisissez la masselotte, sa position de départ et le frottemen\
t. À quelle hauteur le cerceau peut-il monter en 6 s ?","Land upright":"Retomber debout","Let the hoop land with its load at the very top. Everything is allowe\
d; the first hop has to be at least 5 cm high.":"Faites retomber le cerceau avec la masselotte tout en haut. Tout est permis ; le premier saut doit faire au moi\
ns 5 cm.","Hop without skidding":"Sauter sans déraper","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is a\
t most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Sur sol horizontal le cerceau part en roulant, la masselotte en bas, à \
10 m/s au plus, et μ vaut au plus 1,5. Avant de sauter il ne doit pas déraper ; patiner est permis. À quelle hauteur saute-t-il ?","Rigid contact only.":"Con\
tact rigide seulement.","The plane must be level.":"Le plan doit être horizontal.","It must be on Earth.":"Ce doit être sur Terre.","Restitution must be 0.":"\
La restitution doit être 0.","The radius must stay 1 m, without parts.":"Le rayon doit rester 1 m, sans pièces.","At most 90 % of the mass may be in the load.":"\
Au plus 90 % de la masse dans la masselotte.","The hoop must be given by its load fraction.":"Le cerceau doit être donné par la part de la masselotte.","It mu\
st start rolling.":"Il doit partir en roulant.","At most 10 m/s.":"Au plus 10 m/s.","At most 3.1 m/s.":"Au plus 3,1 m/s.","At most 6 s.":"Au plus 6 s.","It does\
 not hop.":"Il ne saute pas.","It rises by {height}.":"Il monte de {height}.","The first hop is too low.":"Le premier saut est trop bas.","It lands {off} away f\
rom the top.":"Il retombe à {off} du sommet.","The load must start at the bottom.":"La masselotte doit partir d’en bas.","Friction must be at most 1.5.":"Le \
frottement doit être au plus 1,5.","It skids before it hops.":"Il dérape avant de sauter.","New here?":"Première visite ?","Eight short questions: guess, the\
n play.":"Huit questions brèves : devinez, puis lancez.","Start the visit":"Commencer la visite","Not now":"Pas maintenant","The hoop, before it is let go.":"L\
e cerceau, avant d’être lâché.",Play:"Lancer",Next:"Suivant",Back:"Retour",Done:"Terminé","Step {number} of {all}":"Étape {number} sur {all}","Leave the \
visit":"Quitter la visite","First say what you expect, then play.":"Dites d’abord ce que vous attendez, puis lancez.","Your guess":"Votre réponse","{points} \
of 100 points.":"{points} points sur 100.","You have {sum} of {most} points.":"Vous avez {sum} points sur {most}.","{what} with the load at {angle}":"{what} ave\
c la masselotte à {angle}","Draw the curve: pull the points up and down":"Tracez la courbe : tirez les points vers le haut ou le bas","Littlewood’s question":"\
La question de Littlewood","A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked \
in 1953 what happens when the weight is level with the centre.":"Un cerceau sans masse porte un poids sur sa jante. Le poids en haut, il reçoit la plus petite p\
oussée et roule. J. E. Littlewood demanda en 1953 ce qui se passe quand le poids est à la hauteur du centre.","What do you think?":"Qu’en pensez-vous ?","It\
 rolls on.":"Il continue de rouler.","It hops: the hoop leaves the plane.":"Il saute : le cerceau quitte le plan.","The weight falls freely, and the hoop skims \
the plane below it.":"Le poids tombe en chute libre, et le cerceau effleure le plan sous lui.","At {angle} there is no contact force any more.":"À {angle} il n’\
y a plus de force de contact.","Littlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass \
follows it along the plane. To hop, a hoop needs some mass in its rim.":"Littlewood disait que le cerceau saute. Mais la force de contact est nulle, non dirigée\
 vers le haut : le poids tombe en chute libre et une jante sans masse le suit le long du plan. Pour sauter, il faut au cerceau un peu de masse dans la jante.","\
A ring with mass":"Un anneau avec masse","Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"À prése\
nt un quart de la masse est dans l’anneau. De nouveau la masselotte est en haut et le cerceau reçoit la plus petite poussée.","Draw how fast the hoop’s cent\
re goes during the first turn.":"Tracez la vitesse du centre du cerceau pendant le premier tour.","Speed of the centre":"Vitesse du centre","With the load at th\
e bottom the centre has {speed} m/s.":"Avec la masselotte en bas, le centre a {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has n\
o kinetic energy, and the light ring has all that the heavy load has lost: it is faster than a stone that falls from the same height.":"Le point le plus bas d’u\
n cerceau qui roule est au repos. Là, la masselotte n’a pas d’énergie cinétique, et l’anneau léger a tout ce que la lourde masselotte a perdu : il est plus rapi\
de qu’une pierre tombant de la même hauteur.","Why it slips":"Pourquoi il glisse","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction ha\
s a limit: it is at most μ N.":"Une poussée plus forte : 2,8 m/s en haut. Rouler exige du frottement, et le frottement a une limite : il vaut au plus μ N.","\
Where is the load when friction gives way for the first time? Turn the mark.":"Où est la masselotte quand le frottement cède pour la première fois ? Tournez la \
marque.","Angle of the load where it begins to slip":"Angle de la masselotte où il commence à glisser","It begins to slip at {angle}. There the plane carries \
only {share} of the weight.":"Il commence à glisser à {angle}. Là, le plan ne porte que {share} du poids.","The load on its way down and round presses little\
 on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.":"Dans sa \
descente la masselotte appuie peu sur le plan : N est petite, alors que l’anneau doit accélérer, ce qui demande du frottement. Voyez le diagramme « Utilisation \
du frottement » : elle atteint 1.","The hop":"Le saut","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn is over.":"Un peu \
plus vite, 3,1 m/s. Cette fois le cerceau quitte le plan avant la fin du premier tour.","Where is the load when the hoop takes off? Turn the mark.":"Où est la m\
asselotte quand le cerceau décolle ? Tournez la marque.","Angle of the load where it takes off":"Angle de la masselotte au décollage","It takes off at {angle}\
, while its rim slips at {slip} m/s.":"Il décolle à {angle}, tandis que sa jante glisse à {slip} m/s.","A rolling hoop would be braked by the plane while the\
 load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the top.":"Le p\
lan freinerait un cerceau qui roule tandis que la masselotte remonte. Le frottement est trop faible pour cela : la jante patine, le cerceau continue de tourner \
vite, et la masselotte l’arrache du plan avant d’être en haut.","The landing":"La retombée","The hoop is in the air. Its centre of gravity goes on a parab\
ola, and it turns evenly.":"Le cerceau est en l’air. Son centre de gravité suit une parabole et il tourne uniformément.","What does it do just after it has \
landed?":"Que fait-il juste après être retombé ?","It rolls at once.":"Il roule aussitôt.","It skids: the rim slides ahead.":"Il dérape : la jante glisse ve\
rs l’avant.","It spins: the rim turns too fast.":"Il patine : la jante tourne trop vite.","It bounces.":"Il rebondit.","It was in the air for {time} s and ros\
e by {height} cm; it lands with the load at {angle}.":"Il est resté {time} s en l’air et est monté de {height} cm ; il retombe avec la masselotte à {angle}.",
"An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing wo\
uld be another one. Try it afterwards.":"Un impact ne dure pas, mais son frottement est aussi fort que sa poussée : ici il suffit à arrêter tout glissement. Ave\
c moins de frottement, ou plus de restitution, la retombée serait autre. Essayez ensuite.","More friction, more hop?":"Plus de frottement, plus haut ?","Three \
hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Trois cerceaux reçoivent la même poussée de 3,1 m/s, sur des plans de frottemen\
t 0,05, 0,2 et 1,0.","Which of them hops highest?":"Lequel saute le plus haut ?","They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)":"\
Ils montent de {low} cm, {middle} cm et {high} cm. (Les deux premiers sont A et B.)","On ice nothing drives the rotation; with endless friction nothing slips. T\
he hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the way up.":"Sur la glace rien n’entraîne la rot\
ation ; avec un frottement sans fin rien ne glisse. Le saut exige les deux : assez de frottement pour tourner vite à la descente, et pas assez pour être freiné \
à la remontée.","What rigid bodies cannot decide":"Ce que les solides ne peuvent décider","A hoop is thrown so that it slides fast over a rough plane. The la\
ws of rigid bodies with dry friction have to say what happens next.":"On lance un cerceau de sorte qu’il glisse vite sur un plan rugueux. Les lois des solides a\
vec frottement sec doivent dire la suite.","What do they say?":"Que disent-elles ?","It flies off.":"Il s’envole.","An impact stops the slide at once.":"Un im\
pact arrête aussitôt le glissement.","Both agree with the laws.":"Les deux obéissent aux lois.","Hoop A and hoop B start alike, and both motions obey every l\
aw.":"Les cerceaux A et B partent de même, et les deux mouvements obéissent à toutes les lois.","Painlevé found this in 1895. For a rigid body the laws have \
two answers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’.":"Painlevé l’a trouvé en\
 1895. Pour un solide, les lois ont ici deux réponses, dans d’autres états aucune. Les corps réels cèdent un peu, et cela décide : choisissez le contact souple \
sous « Contact ».","Your turn":"À vous","Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and se\
e how your scores are computed from the motion itself.":"Prenez le cerceau : tournez la masselotte, levez-le et lâchez-le, lancez-le, inclinez le plan. Ou relev\
ez un défi, et voyez votre score calculé d’après le mouvement lui-même.","Show the hoop at full speed, once, without a comment. “I push it. Does it only r\
oll?”":"Montrer le cerceau à pleine vitesse, une fois, sans commentaire. « Je le pousse. Ne fait-il que rouler ? »","Everybody predicts where the load is a\
t take-off. Count the votes by quarters of the turn.":"Chacun prédit où est la masselotte au décollage. Compter les voix par quarts de tour.","Energy on the \
way down, in pairs: who has the energy when the load is at rest?":"L’énergie à la descente, par deux : qui a l’énergie quand la masselotte est au repos ?",
"Lift at the top: at which speed is the force of the floor zero?":"Soulèvement en haut : à quelle vitesse la force du sol est-elle nulle ?","The film again, i\
n slow motion and with forces; stop at take-off. Compare with the votes.":"Le film à nouveau, au ralenti et avec les forces ; arrêter au décollage. Comparer ave\
c les voix.","Each group takes one speed of the worksheet; results on the board.":"Chaque groupe prend une vitesse de la fiche ; résultats au tableau.","Why? W\
hat has to brake the rotation on the way up, how strong can it be, and what if it is too weak?":"Pourquoi ? Qu’est-ce qui doit freiner la rotation à la remontée\
, avec quelle force, et si c’est trop faible ?","One sentence each: “The hoop hops because …”":"Une phrase chacun : « Le cerceau saute parce que… »",
"The load pulls the hoop up at the top, so it hops there.":"La masselotte tire le cerceau vers le haut au sommet, donc il saute là.","Only if it is very fast. \
Slower hoops hop before the top, after slipping.":"Seulement s’il est très rapide. Les plus lents sautent avant le sommet, après avoir glissé.","It hops at\
 the bottom, where it is fastest.":"Il saute en bas, où il est le plus rapide.","There the floor pushes hardest: the load has to be turned upwards.":"Là le sol\
 pousse le plus fort : il faut dévier la masselotte vers le haut.","Nothing can be faster than a falling stone.":"Rien ne peut être plus rapide qu’une pierre q\
ui tombe.","The ring can: it gets the energy of a load that has come to rest.":"L’anneau le peut : il reçoit l’énergie d’une masselotte qui s’est arrêtée.",
"Friction always brakes.":"Le frottement freine toujours.","It acts against slip. On the hoop’s way up it points forwards.":"Il agit contre le glissement. À l\
a remontée il est dirigé vers l’avant.","More friction, more hop.":"Plus de frottement, plus de saut.","There is a best friction in between.":"Il y a un fro\
ttement optimal entre les deux.","A heavier hoop behaves otherwise.":"Un cerceau plus lourd se comporte autrement.","Only the shares of mass count.":"Seules les\
 parts de masse comptent.","Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.":"Avant le film : où est la m\
asselotte quand le cerceau quitte le sol ? Marquez l’endroit et donnez une raison.","The hoop gets only the smallest push and rolls. How much potential energy\
 has been set free when the load is at the bottom?":"Le cerceau ne reçoit que la plus petite poussée et roule. Quelle énergie potentielle a été libérée quand la\
 masselotte est en bas ?","While a wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"Quand\
 une roue roule, son point le plus bas est au repos. Quelle partie du cerceau a alors de l’énergie cinétique, et quelle est la vitesse du centre ?","How fas\
t is a stone that falls from the height of the load? Why can the hoop be faster?":"Quelle est la vitesse d’une pierre tombant de la hauteur de la masselotte ? P\
ourquoi le cerceau peut-il être plus rapide ?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.":"Trouvez la force \
du sol au sommet pour 1,0 m/s, et la vitesse où elle s’annule.","In the lab: what does the hoop do in its first 1.5 s, and at which angle does it hop? Fill i\
n the table.":"Dans le labo : que fait le cerceau pendant ses 1,5 premières secondes, et à quel angle saute-t-il ? Remplissez le tableau.","Find the smallest \
speed with which the hoop hops, to 1 cm/s.":"Trouvez la plus petite vitesse pour laquelle le cerceau saute, à 1 cm/s près.","At 2.2 m/s the hoop leaves the fl\
oor while its rim slips. Why does slipping help it to hop?":"À 2,2 m/s le cerceau quitte le sol tandis que sa jante glisse. Pourquoi le glissement l’aide-t-il à\
 sauter ?",Show:"Montrer","Teaching with the hoop":"Enseigner avec le cerceau",Worksheet:"Fiche de travail",Solutions:"Corrigé",Exercises:"Exercices","A lesson\
 of 45 minutes":"Une séance de 45 minutes",Minute:"Minute",Motion:"Mouvement","What students often think":"Ce que pensent souvent les élèves",Idea:"Idée","W\
hat is right":"Ce qui est juste","Worksheet: the hoop that hops":"Fiche de travail : le cerceau sauteur","A thin ring of radius 0.40 m has a mass of 0.25 kg. A \
load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"U\
n anneau mince de rayon 0,40 m a une masse de 0,25 kg. Une masselotte de 0,75 kg est fixée sur sa jante. Le cerceau est posé sur un sol horizontal, la masselott\
e en haut, et poussé vers la droite. Frottement : μ = 1 ; g = 9,81 m/s².",phases:"phases","does it hop?":"saute-t-il ?","at which angle?":"à quel angle ?",Print:"\
Imprimer","The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student.":"La visite interroge avant de montrer ;\
 la présentation remplit l’écran ; le tableau donne des nombres à chaque élève.","Slips, hops":"Glisse, saute","no threshold uphill (β < 0): whether it s\
lips or hops hangs on where it turns back; the map shows it":"en montée (β < 0) pas de seuil : qu'il glisse ou saute dépend de l'endroit où il rebrousse chemin \
; la carte le montre","A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A bleu, B ocre ; le tracé indique la grandeur ; nombres de \
{hoop} ; {hands}"};var Os={roll:"滚动",spin:"空转",skid:"拖滑",flight:"腾空",skim:"擦地",hop:"跳起","slip −":"滑动 −","slip +":"滑动 +",rolls:"滚动",spins:"空\
转",skids:"拖滑",flies:"腾空","skims the plane":"贴着平面滑过","rolls at {angle}":"在 {angle} 处开始滚动","spins at {angle}":"在 {angle} 处开始空转",
"skids at {angle}":"在 {angle} 处开始拖滑","flies at {angle}":"在 {angle} 处腾空","skims the plane at {angle}":"在 {angle} 处开始贴着平面滑过",
"hops at {angle}":"在 {angle} 处跳起","lands at {angle}":"在 {angle} 处落地","bounces at {angle}":"在 {angle} 处弹起","slips the other way at {angle\
}":"在 {angle} 处反向滑动","stops its slip at once at {angle}":"在 {angle} 处滑动骤停","turns back at {angle}":"在 {angle} 处折返","has bounced \
out at {angle}":"在 {angle} 处弹跳结束","meets Painlevé's paradox at {angle}":"在 {angle} 处遇到潘勒韦悖论","meets Painlevé's indeterminacy at {\
angle}":"在 {angle} 处遇到潘勒韦不定性","jams at {angle}":"在 {angle} 处卡死","gains energy (Kane) at {angle}":"在 {angle} 处获得能量（凯恩）",
"skims at {angle}":"在 {angle} 处开始擦地","rests at {angle}":"在 {angle} 处静止","starts at {angle}":"在 {angle} 处开始","slips at {angle}":"在 {a\
ngle} 处开始滑动","{what} and {count} more times":"{what}，并再重复 {count} 次","… ({count} more)":"……（还有 {count} 项）","It has come to\
 rest.":"它已静止。","The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.":"法向力无限增大（动力学卡死）：刚体力学给不出此后的运动。",
"The model does not determine the motion beyond.":"模型不能确定此后的运动。","The limit of events (contact.max_events), or of work for one motion, w\
as reached before the end.":"在结束之前已达到事件数(contact.max_events)或单次计算量的上限。","It starts and {verb} with the load at {angle}\
 and the centre at {speed} m/s.":"开始时{verb}，重物位于 {angle}，圆心速度 {speed} m/s。","It starts in the air with the load at {angle} and the c\
entre at {speed} m/s.":"开始时在空中，重物位于 {angle}，圆心速度 {speed} m/s。","It starts skimming with the load at {angle} and the centre at \
{speed} m/s.":"开始时贴着平面滑过，重物位于 {angle}，圆心速度 {speed} m/s。","It {verb} at {angle}; friction is used up: the rim turns too f\
ast for the way it goes.":"在 {angle} 处开始{verb}：摩擦力已达上限，圆环转得比前进得快。","It {verb} at {angle}; friction is used up: the\
 rim slides ahead.":"在 {angle} 处开始{verb}：摩擦力已达上限，接触点向前滑。","It rolls again at {angle}; the slip has stopped.":"在 {angle} \
处恢复滚动，滑动停止。","The slip turns round at {angle}; it {verb}.":"在 {angle} 处滑动反向；它{verb}。","It hops at {angle}.":"它在 {angle} \
处跳起。","It hops at {angle}. It rises {height} and stays up for {time} s.":"它在 {angle} 处跳起，升高 {height}，腾空 {time} s。","An impact wi\
thout collision at {angle} stops the slip; then it {verb}.":"在 {angle} 处，一次无碰撞的冲击使滑动停止；随后它{verb}。","It lands at {angle\
} with {speed} m/s downwards and bounces.":"它在 {angle} 处以 {speed} m/s 的向下速度落地并弹起。","It lands at {angle} with {speed} m/s downwards\
 and {verb}.":"它在 {angle} 处以 {speed} m/s 的向下速度落地，随后{verb}。","It turns back at {angle}.":"它在 {angle} 处折返。","It turns ba\
ck at {angle}, and {verb} now.":"它在 {angle} 处折返，此后{verb}。","The centre is highest at {angle}: the gap is {height}.":"圆心在 {angle} 处最高：间隙为 {heig\
ht}。","Bounces without number end here, at {angle}.":"无穷多次弹跳在 {angle} 处结束。","Painlevé's paradox at {angle}: no contact force agrees with\
 this slip.":"{angle} 处的潘勒韦悖论：没有接触力与这种滑动相容。","Painlevé's paradox at {angle}: several contact forces agree with it.":"\
{angle} 处的潘勒韦悖论：有多个接触力与之相容。","Dynamic jam at {angle}: the contact force grows without bound.":"{angle} 处动力学卡死：接触力无限增大。",
"Newton's law of impact has created {energy} J (Kane's example).":"牛顿碰撞定律凭空产生了 {energy} J（凯恩的例子）。","No contact force is le\
ft at {angle}: the load falls freely and the rim skims the plane.":"在 {angle} 处接触力消失：重物自由下落，圆环贴着平面滑过。","It rests\
 at {angle}.":"它在 {angle} 处静止。","It rests at {angle}, which is not stable.":"它在 {angle} 处静止，但不稳定。","It bounces {count} more ti\
mes.":"它又弹跳了 {count} 次。","… and {count} more.":"……还有 {count} 项。",Slips:"打滑",Hops:"跳起","Hops at once":"立即跳起","Frictio\
n for pure rolling":"纯滚动所需的摩擦因数","Painlevé’s paradox":"潘勒韦悖论","Dynamic jam":"动力学卡死","Rests stably":"稳定静止","En\
d of rolling":"滚动终止","would slip above {speed} m/s":"速度超过 {speed} m/s 时打滑","would slip: any push is enough":"会打滑：任何一推都足够",
"would hop in its first turn above {speed} m/s":"速度超过 {speed} m/s 时在第一圈内跳起","would hop in its first turn: any push is enough":"会在第一圈内跳起：\
任何一推都足够","would hop at once above {speed} m/s":"速度超过 {speed} m/s 时立即跳起","would hop at once: at any speed":"会立即跳起：任何速度都行",
"never, at any speed":"任何速度下都不会","no friction keeps it rolling":"任何摩擦都不能使它保持滚动","μ = {mu} would keep it rolling (enoug\
h here)":"μ = {mu} 可保持滚动（这里足够）","μ = {mu} would keep it rolling (more than there is)":"μ = {mu} 可保持滚动（这里不够）",never:"\
从不","from μ = {mu} on, at {angle}: possible here":"从 μ = {mu} 起，在 {angle} 处：这里可能出现","from μ = {mu} on, at {angle}: not here":"从 μ\
 = {mu} 起，在 {angle} 处：这里不会出现","can end a slip at {angles}":"可能在 {angles} 处终止滑动","with the load at {angle}":"重物位于 {angle}",
"at {angle} friction is used up":"在 {angle} 处摩擦力达到上限","at {angle} the contact force is gone":"在 {angle} 处接触力消失","Load fraction":"\
重物质量占比","Share of the mass in the load of an ideal hoop":"理想圆环中重物占总质量的比例",Eccentricity:"偏心率","Distance of the cent\
re of gravity from the centre, over the radius":"重心到圆心的距离与半径之比","Inertia ratio":"无量纲转动惯量","Moment of inertia about the c\
entre of gravity over m R²":"绕重心的转动惯量与 m R² 之比",Radius:"半径","Rim radius":"圆环半径",Mass:"质量","Total mass":"总质量",Friction:"\
摩擦因数","Friction, static and kinetic":"摩擦因数（静、动相同）","Static friction":"静摩擦因数","Kinetic friction":"动摩擦因数",Slope:"\
倾角","Slope of the plane, downhill along +x":"平面倾角，下坡方向为 +x",Gravity:"重力加速度",Restitution:"恢复系数","Restitution of an impa\
ct":"碰撞的恢复系数",Speed:"速度","Velocity of the centre in a rolling start":"滚动起始时圆心的速度","Load angle":"重物角度","Angle from \
the plane's normal to the centre of gravity":"从平面法线到重心的角度","Height of the gap":"间隙高度","Gap between rim and plane":"圆环与平面的间隙",
"Speed along":"沿平面速度","Velocity of the centre along the plane":"圆心沿平面的速度","Speed upwards":"向上速度","Velocity of the centre away \
from the plane":"圆心离开平面的速度","Angular velocity":"角速度",Stiffness:"刚度","Stiffness of the contact":"接触刚度","Slip speed":"滑动速度",
"Slip velocity over which friction builds up":"摩擦力建立所需的滑动速度","Restitution that the damping is chosen for":"用于选取阻尼的恢复系数",
Duration:"时长","Duration of the motion":"运动的时长","Law of impact":"碰撞定律","Law of restitution":"恢复定律","Stronge (energy)":"斯特朗格（能量）",
"Poisson (impulse)":"泊松（冲量）","Newton (velocity)":"牛顿（速度）","Painlevé: two solutions":"潘勒韦：两个解","What follows an indetermin\
ate contact":"不定接触之后发生什么",impact:"冲击","Contact model":"接触模型",rigid:"刚性",compliant:"柔性","Normal force":"法向力","Frict\
ion law":"摩擦定律","Regularised friction":"正则化摩擦","smooth (tanh)":"光滑 (tanh)",linear:"线性","bristle (can hold)":"鬃毛模型（可保持静止）",
"Kelvin–Voigt":"开尔文–沃伊特","Hunt–Crossley":"亨特–克罗斯利","Speed v₀":"速度 v₀","Angle of the load θ₀":"重物角度 θ₀","Sp\
eed along ẋ₀":"沿平面速度 ẋ₀","Angular velocity θ̇₀":"角速度 θ̇₀","Height of the gap y₀":"间隙高度 y₀","Load fraction γ":"重物质量占\
比 γ","Eccentricity ε":"偏心率 ε","Inertia ratio κ":"无量纲转动惯量 κ","Radius R":"半径 R","Friction μ":"摩擦因数 μ","Slope β":"倾角 β",
"Gravity g":"重力加速度 g","Restitution e":"恢复系数 e",Earth:"地球",Moon:"月球",Mars:"火星",Jupiter:"木星",Weightless:"失重","what happens i\
n the first turn":"第一圈内发生什么","height of the first hop":"第一次跳起的高度","angle of take-off":"离地角度","duration of the first hop":"\
第一次跳起的时长","greatest friction utilization":"摩擦利用率的最大值","energy lost":"损失的能量","angle at the end":"终止角度","Painl\
evé’s paradox or jam met":"是否遇到潘勒韦悖论或卡死","how it ends":"如何结束",duration:"时长",revolutions:"圈数",reversal:"折返",takeoff:"\
离地",rest:"静止",jam:"卡死",undetermined:"未定","event limit":"事件数上限",no:"否",yes:"是",none:"无","not allowed":"不允许","and {count} mo\
re":"以及另外 {count} 类","The article":"论文","Littlewood's hoop":"李特尔伍德的圆环",Paradoxes:"悖论",More:"更多","It hops: 3.1 m/s":"跳起：3.1\
 m/s","Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.":"打滑两次，然后在即将转满一圈时离开平面，腾空 0.76 s。",
"It slips: 2.8 m/s":"打滑：2.8 m/s","Friction is used up twice a turn; each slip is weaker than the one before, and none is the last.":"每圈摩擦力两次达到上限；每次打滑都比前一次\
弱，且没有最后一次。","It rolls: 2 m/s":"滚动：2 m/s","Pure rolling, faster and more even than after a slow start, and close to the limit of fricti\
on.":"纯滚动，比慢速起动更快更均匀，接近摩擦极限。","The smallest push: 0.1 m/s":"最轻的一推：0.1 m/s","Nearly at rest with the load\
 up, fast with the load down; 38 % of the friction is used.":"重物在上时几乎静止，在下时很快；只用到 38 % 的摩擦。","Low friction: 0.1 m/\
s, μ = 0.3":"低摩擦：0.1 m/s,μ = 0.3","Slipping costs the energy that a full turn needs: the hoop rocks to and fro.":"打滑耗去了转满一圈所需的能量：圆环来回摆动。",
"All mass in the load":"全部质量在重物上","A massless ring: at 90° no contact force is left; the load falls, the rim skims the plane.":"无质量的环：在 90° 处接触\
力消失；重物下落，圆环贴着平面滑过。","All mass in the load, pushed":"全部质量在重物上，推一下","With a push the contact force is \
gone earlier, at cos θ = v₀²/(gR).":"推一下后接触力更早消失，在 cos θ = v₀²/(gR) 处。","Nearly all mass in the load":"几乎全部质量在重物上",
"γ = 0.99: what a real ring does instead of Littlewood's hop.":"γ = 0.99：真实的环会怎样，而不是李特尔伍德所说的跳起。","Painlevé: no s\
olution":"潘勒韦：无解","No contact force agrees with this slip. An impact without collision stops it at once.":"没有接触力与这种滑动相容。一次无碰撞的冲击使它骤停。",
"Flight and impact both agree with the laws. Choose which with the switch under Plane.":"腾空与冲击都符合定律。请在“平面”下选择。","A fas\
t slide after a hop: the contact force grows without bound in finite time, and no law says what follows.":"跳起之后的快速滑动：接触力在有限时间内无限增大，没有定律能说明之后如何。",
"Kane: energy out of nothing":"凯恩：无中生有的能量","Newton's law of impact with friction creates two joules. Stronge's law does not.":"带摩擦的牛顿碰撞定律凭空产\
生两焦耳。斯特朗格定律则不会。",Downhill:"下坡","On a slope of 10° the hoop gains speed from turn to turn, until it hops.":"在 10° 的斜面上，圆环一圈比一圈\
快，直到跳起。","Bounces without number":"无穷多次弹跳","Dropped with spin and restitution 0.5: infinitely many bounces in finite time.":"带旋转落下，恢复系\
数 0.5：有限时间内无穷多次弹跳。","On the Moon":"在月球上","The article's hop under lunar gravity: everything is slower by a factor of 2.46.":"\
论文中的跳起，月球重力：一切慢到原来的 1/2.46。","Motions to start from":"可选的起始运动","Motions to start from …":"可选的起始运动……",
"Undo (z)":"撤销 (z)","Redo (y)":"重做 (y)",Compare:"比较","Compare two hoops":"比较两个圆环","Dark or light (d)":"深色或浅色 (d)","Keys and he\
lp (?)":"按键与帮助 (?)","Keys and help":"按键与帮助",lab:"实验室",Learn:"学习",Language:"语言","Hoop A":"圆环 A","Hoop B":"圆环 B","Which \
hoop the controls change":"控件作用于哪个圆环",Parameters:"参数","Skip to the player":"跳到播放器",Hoop:"圆环",Plane:"平面",Start:"起始",Contact:"\
接触","Given by":"给定方式","load fraction γ":"质量占比 γ","ε and κ":"ε 与 κ","real parts":"实际部件",Where:"地点",elsewhere:"其他","st\
atic and kinetic friction apart":"静、动摩擦因数分开",Starts:"起始状态",rolling:"滚动","in any state":"任意状态","auto {value}":"自动 {value}",
"{name}, exact value in {unit}":"{name}，精确值，单位 {unit}","{name}, exact value":"{name}，精确值",Ring:"圆环部件",Disk:"圆盘","Point mass":"\
质点",Rod:"杆",mass:"质量","inner radius":"内半径","outer radius":"外半径",radius:"半径","distance from centre":"到圆心的距离",length:"长度",
"Add a part":"添加部件","+ add a part …":"+ 添加部件……","Remove part {number}, {what}":"移除部件 {number}，{what}","{name} = {value} must be \
{rule}.":"{name} = {value} 必须{rule}。","{name} = {value} must be a number, such as 2.5.":"{name} = {value} 必须是数字，例如 2.5。","{name} = {valu\
e} must be a number.":"{name} = {value} 必须是数字。","from {least} to {most}":"在 {least} 到 {most} 之间","from {least} to {most}, or inf":"在 {least}\
 到 {most} 之间或为 inf","0 or from {least} to {most}":"为 0 或在 {least} 到 {most} 之间","0 or from {least} to {most}, or inf":"为 0、在 {least} 到 {mos\
t} 之间或为 inf","at most {most} in the lab":"在本实验室中不超过 {most}","0 for the massless hoop (hoop.inertia_ratio = 0)":"为 0（无质量圆环，hoop.inertia\
_ratio = 0）","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"为 'rigid'（无质量圆环，hoop.inertia_ratio = 0）","plane.mu_kinetic = {one} mu\
st not exceed plane.mu_static = {other}.":"plane.mu_kinetic = {one} 不得超过 plane.mu_static = {other}。","The server does not answer. What is here goes on\
 playing; changes need `hophoop lab` to run again.":"服务器没有响应。已有内容可以继续播放；要更改需重新运行 `hophoop lab`。","The se\
rver answered {status}.":"服务器返回 {status}。","The notebook’s kernel does not answer; run the cell again.":"笔记本内核没有响应；请重新运行单元格。",
hoop:"圆环",mode:"状态",time:"时间",angle:"角度",gap:"间隙","rim speed":"环缘速度",load:"重物","centre of gravity":"重心","the same in flight":"\
腾空时的重心",airborne:"腾空","A in front, B behind":"A 在前，B 在后","The hoop":"圆环","The hoop.":"圆环。",Time:"时间","{time} seconds, {w\
hat}":"{time} 秒，{what}","Traces (t)":"轨迹 (t)","Forces (f)":"力 (f)","Rim speed (c)":"环缘速度 (c)","Whole path (w)":"全程 (w)","In space (3)":"三维\
 (3)",Traces:"轨迹",Forces:"力","Rim speed":"环缘速度","Whole path":"全程","Play (space)":"播放（空格）","Pause (space)":"暂停（空格）","Sp\
eed of the film":"播放速度","To the start (Home)":"回到开头 (Home)","Previous event (Shift ←)":"上一事件 (Shift ←)","Next event (Shift →)":"下一\
事件 (Shift →)","One frame back (←)":"后退一帧 (←)","One frame on (→)":"前进一帧 (→)",landing:"落地","To the next flight (h)":"到下一次腾空 (h)",
"To the next landing (l)":"到下一次落地 (l)","This motion has no flight.":"此运动没有腾空。","This motion has no landing.":"此运动没有落地。",
"{what} at {angle}, {time} s":"{what}:{angle},{time} s",start:"开始","slip begins":"滑动开始","slip ends":"滑动结束","slip turns round":"滑动反向",
"take-off":"离地","turns back":"折返","highest point":"最高点","bounces end":"弹跳结束","Painlevé: several solutions":"潘勒韦：多个解","energ\
y gain (Kane)":"能量增加（凯恩）","skimming begins":"开始擦地","at rest":"静止",end:"结束","What happens":"发生了什么","What happens to hoo\
p {hoop}":"圆环 {hoop} 发生了什么","The motion in words":"运动的文字描述","(not all events are shown)":"（未显示全部事件）","What theory \
says":"理论怎么说","What theory says of hoop {hoop}":"理论对圆环 {hoop} 的结论",Velocities:"速度","velocity [m/s]":"速度 [m/s]","v (centre)":"v\
（圆心）","Energies and losses":"能量与损耗","energy [J]":"能量 [J]",kinetic:"动能",potential:"势能",total:"总能量","lost to friction":"摩擦损耗",
"lost in the damper":"阻尼损耗","lost in impacts, normal part":"碰撞损耗，法向部分","Contact forces":"接触力","force [N]":"力 [N]","normal N":"\
法向力 N","friction F":"摩擦力 F","Use of friction":"摩擦利用率","Your choice":"自选","What your diagram shows":"自选图的纵轴","Horizontal ax\
is of the diagrams":"图的横轴","over {quantity}":"横轴：{quantity}","Whole motion":"整个运动","slide to go there, two fingers zoom":"滑动以跳转，双指缩放",
"click to go there, drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"单击跳转，拖动放大；单击后或按住 Ctrl 时滚轮缩放；双击显示全部",
"{name} from {low} to {high}":"{name}：{low} 至 {high}","Diagram: {title} in {unit}.":"图：{title}，单位 {unit}。","θ mod 360°":"θ mod 360°",Esc:"Es\
c","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"一圈内的角度","place of the centre":"圆心位置","gap under the rim":"圆环下的间隙",
"height of the centre of gravity":"重心高度","speed of the centre":"圆心速度","speed of rotation":"转动线速度","speed away from the plane":"离开平面的速度",
"slip velocity":"滑动速度","angular velocity":"角速度","normal force":"法向力","friction force":"摩擦力","use of friction":"摩擦利用率","kinet\
ic energy":"动能","potential energy":"势能","total energy":"总能量","Plane of θ and θ̇":"θ–θ̇ 相平面","Plane of angle and angular velocity wit\
h the regions of rolling, slip and flight":"角度与角速度相平面，标出滚动、滑动与腾空区域","angle θ within a turn [°]":"一圈内的角度 θ [°]",
"no answer":"无解","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"颜色：无滑动接触之后的状态。阴影线：会遇到潘勒韦悖论的滑动。",
"Tap to go there, two fingers zoom.":"点按跳转，双指缩放。","Click to go there; two fingers zoom.":"点按跳转；双指缩放。","Click to go there\
; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"单击跳转；单击后或按住 Ctrl 时滚轮缩放；双击显示全部。",Map:"分布图",
of:"内容",Across:"横轴",Up:"纵轴","What the map shows":"分布图显示的内容","Map of motions":"运动分布图","Map of motions. Arrow keys move the \
mark, Enter takes the motion, plus and minus zoom.":"运动分布图。方向键移动标记，回车采用该运动，加减号缩放。","Zoom into the map":"\
放大分布图","Zoom out of the map":"缩小分布图","Whole map":"整张图","Click to take that motion into the player; two fingers zoom.":"点按即可把该运动放入播放器；双\
指缩放。","Click to take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"单击即可把该运动放入播放器；单击后或按\
住 Ctrl 时滚轮缩放；拖动平移；双击显示全部。","computing {count} motions …":"正在计算 {count} 个运动……","{count} motions":"{coun\
t} 个运动","{count} motions, with rigid contact":"{count} 个运动，刚性接触","of rolling starts, though this motion starts otherwise":"均为滚动起始，而当前运动并非如\
此","of starts in any state, though this motion starts rolling":"均为任意状态起始，而当前运动为滚动起始","compiling the kernel of maps, this\
 once: {done} of {all} functions":"正在编译分布图内核（仅此一次）：{done}/{all} 个函数",Keep:"保存","Copy the link":"复制链接","Scenari\
o (TOML)":"场景 (TOML)","States (CSV)":"状态 (CSV)","Motion (netCDF)":"运动 (netCDF)","Events (JSON)":"事件 (JSON)","Film (MP4)":"影片 (MP4)","Picture\
 (PNG)":"图片 (PNG)","Record a film here (WebM)":"在此录制影片 (WebM)","Show me the Python":"显示 Python 代码","The same motion in Python":"同一运动的 Py\
thon 代码","The link is copied.":"链接已复制。","The link to this motion":"此运动的链接","The film is being made; this takes a while …":"正在制作影片，\
请稍候……","Fetching {name} …":"正在获取 {name}……","{name} is there.":"{name} 已就绪。","This browser cannot record a canvas; take the MP4 i\
nstead.":"此浏览器无法录制画布；请改用 MP4。","Recording one run …":"正在录制一遍……","The film is there.":"影片已就绪。","The s\
cenario as a file":"场景文件",Copy:"复制",Copied:"已复制",Close:"关闭","A ring with a load on its rim rolls on a plane. Friction can only hold so muc\
h, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"一个边缘带重物的环在平面上滚动\
。摩擦力有上限，平面只能推不能拉：于是它打滑、跳起、落地——或者做出刚体力学无法判定的事。拖动滑块看看。",Modes:"\
状态","Marks on the bar of time":"时间条上的标记",Keys:"按键",space:"空格","play, pause":"播放、暂停","one frame":"一帧","Shift ← →":"Sh\
ift ← →","previous, next event":"上一、下一事件","next flight, landing":"下一次腾空、落地","slower, faster":"更慢、更快","Home End":"Hom\
e End","start, end":"开头、结尾","traces, forces, rim speed, whole path":"轨迹、力、环缘速度、全程","in space":"三维","zoom, zoom back":"缩放、还\
原","leave a field, a menu, a picture that the wheel zooms":"离开输入框、菜单或滚轮缩放的图","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"撤销、重做",
"dark, light":"深色、浅色",Python:"Python","the rim does not slide":"环缘不滑动","slip: the rim turns too fast for the way it goes (slip −, for a hoop\
 that rolls ahead)":"滑动：环缘转得比前进快（圆环向前滚时为滑动 −）","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"\
滑动：接触点向前滑（圆环向前滚时为滑动 +）","the hop: from take-off to landing":"跳起：从离地到落地","a massless rim that touches w\
ithout force":"无质量的环缘，接触而无力","take-off, landing":"离地、落地","Painlevé’s paradox: no solution, several":"潘勒韦悖论：无解、多解",
"bounces without number end":"无穷多次弹跳结束","skimming begins, rest":"开始擦地、静止","Single keys (letters, digits, signs) do what the table \
says":"单个按键（字母、数字、符号）按表中所述起作用","The hoop in your hand":"手中的圆环","Slope of the plane":"平面倾角","Tilt t\
he plane: drag, or arrow keys":"倾斜平面：拖动或方向键","The hoop: height and speed":"圆环：高度与速度","Lift, roll or throw the hoop: drag, \
or arrow keys":"提起、滚动或抛出圆环：拖动或方向键","Angle of the load":"重物角度","Turn the load: drag, or arrow keys":"转动重物：拖动或方向键",
"gap {height}, speed {speed} m/s":"间隙 {height}，速度 {speed} m/s",Repeat:"循环","Slow motion: a tenth of the speed":"慢放：十分之一速度","Soun\
d of the contact":"接触声音","Presentation on the whole screen":"全屏演示","Guided visit":"引导参观","Table of the motion":"运动数据表","Table \
of the motion, rows":"运动数据表，各行",Presentation:"演示","For teachers":"教师专区",Table:"数据表",Every:"每隔","Save as CSV":"保存为 CSV",
Columns:"列","The first {count} rows.":"前 {count} 行。",Challenges:"挑战","Leave the challenges":"退出挑战","Which challenge":"选择挑战",Score:"得\
分","Begin again":"重新开始","Show a best one":"看一个最佳解","{stars} {points} points. {what}":"{stars} {points} 分。{what}","Your best: {points} \
points.":"你的最佳成绩：{points} 分。","Hop highest":"跳得最高","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it star\
ts, and friction. How high can the hoop rise within 6 s?":"在水平面上以不超过 3.1 m/s 滚动起始：你来选择重物、起始位置与摩擦。6 s 内圆环能升多高？",
"Land upright":"正立落地","Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.":"让圆环落地时重物恰好在\
最高处。一切都允许；第一次跳起至少 5 cm 高。","Hop without skidding":"不拖滑地跳起","On level ground the hoop starts rolling with its l\
oad at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"在水平面上圆环以不超过 10 m/\
s 滚动起始，重物在最低处，μ 不超过 1.5。跳起之前不得拖滑，但可以空转。它能跳多高？","Rigid contact only.":"只限刚性接触。",
"The plane must be level.":"平面必须水平。","It must be on Earth.":"必须在地球上。","Restitution must be 0.":"恢复系数必须为 0。","The rad\
ius must stay 1 m, without parts.":"半径必须保持 1 m，且不用部件。","At most 90 % of the mass may be in the load.":"重物最多占总质量的 90 %。",
"The hoop must be given by its load fraction.":"圆环必须用重物质量占比给定。","It must start rolling.":"必须以滚动起始。","At most 10 m/s.":"\
不超过 10 m/s。","At most 3.1 m/s.":"不超过 3.1 m/s。","At most 6 s.":"不超过 6 s。","It does not hop.":"它没有跳起。","It rises by {height}.":"\
它升高 {height}。","The first hop is too low.":"第一次跳起太低。","It lands {off} away from the top.":"落地时偏离最高处 {off}。","The load \
must start at the bottom.":"重物必须从最低处起始。","Friction must be at most 1.5.":"摩擦因数不得超过 1.5。","It skids before it hops.":"它在跳\
起之前拖滑了。","New here?":"第一次来？","Eight short questions: guess, then play.":"八个小问题：先猜，再播放。","Start the visit":"开始参\
观","Not now":"以后再说","The hoop, before it is let go.":"放手之前的圆环。",Play:"播放",Next:"下一步",Back:"上一步",Done:"完成","Step {n\
umber} of {all}":"第 {number} 步，共 {all} 步","Leave the visit":"退出参观","First say what you expect, then play.":"先说出你的预测，再播放。",
"Your guess":"你的预测","{points} of 100 points.":"{points} 分（满分 100）。","You have {sum} of {most} points.":"你得到 {sum} 分，满分 {most}。",
"{what} with the load at {angle}":"重物位于 {angle} 时的{what}","Draw the curve: pull the points up and down":"画出曲线：上下拖动各点","Littlew\
ood’s question":"李特尔伍德的问题","A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E.\
 Littlewood asked in 1953 what happens when the weight is level with the centre.":"一个没有质量的圆环，边缘固定着一个重物。重物在最高处时轻轻一推，它便滚动起来。1953 年李特尔伍德问：当重物与圆心同高时会发生什么？",
"What do you think?":"你认为呢？","It rolls on.":"它继续滚动。","It hops: the hoop leaves the plane.":"它跳起：圆环离开平面。","The weight\
 falls freely, and the hoop skims the plane below it.":"重物自由下落，圆环在它下方贴着平面滑过。","At {angle} there is no contact force any \
more.":"在 {angle} 处已没有接触力。","Littlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a ri\
m without mass follows it along the plane. To hop, a hoop needs some mass in its rim.":"李特尔伍德说圆环会跳起。但接触力是零，而不是向上：重物自由下落，没有质量的环沿平面跟随它。要跳起，环本身必须有一些质量。",
"A ring with mass":"有质量的环","Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"现在环占总质量的四分之\
一。重物同样在最高处，轻轻一推。","Draw how fast the hoop’s centre goes during the first turn.":"画出第一圈内圆心的速度。","Speed \
of the centre":"圆心速度","With the load at the bottom the centre has {speed} m/s.":"重物在最低处时圆心速度为 {speed} m/s。","The lowest point \
of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: it is faster than a stone that fall\
s from the same height.":"滚动圆环的最低点是静止的。重物到那里没有动能，轻环得到了沉重的重物失去的全部能量：它比从同一高度落下的石头还快。",
"Why it slips":"为什么打滑","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"推得更重：最高处 2.8 m/s。滚动\
需要摩擦，而摩擦力有上限：最大为 μ N。","Where is the load when friction gives way for the first time? Turn the mark.":"摩擦第一次不够时，重物在哪里？转动标记。",
"Angle of the load where it begins to slip":"开始打滑时重物的角度","It begins to slip at {angle}. There the plane carries only {share} of the weight.":"\
它在 {angle} 处开始打滑。此时平面只承担重力的 {share}。","The load on its way down and round presses little on the plane, so that N is small,\
 while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.":"重物在下落转动途中对平面压力很小，N 很小，而环却要加速：这需要摩擦。看“摩擦利用率\
”图：它达到 1。","The hop":"跳起","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn is over.":"稍快一些，3.1 m/s。这一次圆环在\
第一圈结束之前离开平面。","Where is the load when the hoop takes off? Turn the mark.":"圆环离地时，重物在哪里？转动标记。","Angle o\
f the load where it takes off":"离地时重物的角度","It takes off at {angle}, while its rim slips at {slip} m/s.":"它在 {angle} 处离地，此时环缘以 {slip} m/s 打滑。",
"A rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load \
pulls it off the plane before it is at the top.":"若圆环纯滚动，重物上升时平面会使转动减慢。但摩擦力不够：环缘空转，圆环继续快速转动，重物在到达最高处之前就把它拉离平面。",
"The landing":"落地","The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.":"圆环在空中。它的重心走抛物线，转动是匀速的。",
"What does it do just after it has landed?":"落地之后它马上会怎样？","It rolls at once.":"立即滚动。","It skids: the rim slides ahead.":"拖滑：接触点向\
前滑。","It spins: the rim turns too fast.":"空转：环转得太快。","It bounces.":"弹起。","It was in the air for {time} s and rose by {height} cm; \
it lands with the load at {angle}.":"它在空中 {time} s，升高 {height} cm；落地时重物位于 {angle}。","An impact takes no time, but its friction i\
s as strong as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards.":"碰撞不\
占时间，但其中的摩擦与冲力一样强：这里足以使滑动全部停止。若摩擦更小或恢复系数更大，落地情形就会不同。之后可以试试。",
"More friction, more hop?":"摩擦越大，跳得越高？","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"三个圆环以相同的 3.1\
 m/s 起始，平面摩擦因数分别为 0.05、0.2 和 1.0。","Which of them hops highest?":"哪一个跳得最高？","They rise by {low} cm, {middle} cm an\
d {high} cm. (The first two are A and B.)":"它们分别升高 {low} cm、{middle} cm 和 {high} cm。（前两个是 A 和 B。）","On ice nothing drives the \
rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on t\
he way up.":"在冰上没有什么驱动转动；摩擦无穷大时则不会打滑。跳起需要两者兼顾：下落途中摩擦足以使圆环转快，上升途中又不至于把它刹住。",
"What rigid bodies cannot decide":"刚体无法判定的事","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry fric\
tion have to say what happens next.":"把圆环抛出，使它在粗糙平面上快速滑动。带干摩擦的刚体定律必须说明接下来会怎样。","Wh\
at do they say?":"它们怎么说？","It flies off.":"它飞起来。","An impact stops the slide at once.":"一次冲击使滑动骤停。","Both agree with t\
he laws.":"两者都符合定律。","Hoop A and hoop B start alike, and both motions obey every law.":"圆环 A 与圆环 B 起始相同，两种运动都遵守全部定律。",
"Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that decides: choose the co\
mpliant contact under ‘Contact’.":"潘勒韦在 1895 年发现了这一点。对刚体而言，这里的定律有两个答案，在另一些状态下则没有答案。真实物体会略微变形，由此得出结果：请在“接触”下选择柔性接触。",
"Your turn":"轮到你了","Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your score\
s are computed from the motion itself.":"拿起圆环：转动重物、提起再放下、轻弹一下、倾斜平面。或者接受挑战，看看得分如何由运动本身算出。",
"Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"全速播放一次，不作说明。“我推它一下。它只是滚动吗？”",
"Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.":"每人预测离地时重物的位置。按四分之一圈统计票数。",
"Energy on the way down, in pairs: who has the energy when the load is at rest?":"两人一组讨论下落途中的能量：重物静止时能量在哪里？","\
Lift at the top: at which speed is the force of the floor zero?":"最高处的抬升：速度多大时地面的力为零？","The film again, in slow motion and\
 with forces; stop at take-off. Compare with the votes.":"再次慢放并显示力；在离地时停下，与投票对比。","Each group takes one speed of the\
 worksheet; results on the board.":"每组取学习单中的一个速度；结果写在黑板上。","Why? What has to brake the rotation on the way up, how str\
ong can it be, and what if it is too weak?":"为什么？上升途中是什么使转动减慢？它能有多强？太弱时又会怎样？","One sentence each: \
“The hoop hops because …”":"每人一句话：“圆环跳起是因为……”","The load pulls the hoop up at the top, so it hops there.":"重物在最高处把圆环往上拉，\
所以在那里跳起。","Only if it is very fast. Slower hoops hop before the top, after slipping.":"只有很快时才如此。较慢的圆环在打滑之后、到达最高处之前跳起。",
"It hops at the bottom, where it is fastest.":"它在最低处跳起，因为那里最快。","There the floor pushes hardest: the load has to be turned upwards\
.":"在那里地面推力最大：必须使重物转而向上。","Nothing can be faster than a falling stone.":"没有什么比下落的石头更快。","The r\
ing can: it gets the energy of a load that has come to rest.":"环可以：它得到了已静止的重物的能量。","Friction always brakes.":"摩擦总是阻碍运动。",
"It acts against slip. On the hoop’s way up it points forwards.":"它阻碍的是相对滑动。重物上升途中它指向前方。","More friction, more hop\
.":"摩擦越大跳得越高。","There is a best friction in between.":"中间存在一个最佳摩擦因数。","A heavier hoop behaves otherwise.":"更重的圆环表现不同\
。","Only the shares of mass count.":"只有质量的比例起作用。","Before the film: where is the load when the hoop leaves the floor? Mark the place and\
 give one reason.":"看影片之前：圆环离地时重物在哪里？标出位置并写出一个理由。","The hoop gets only the smallest push and rolls. Ho\
w much potential energy has been set free when the load is at the bottom?":"轻轻一推圆环便滚动。重物到最低处时释放了多少势能？","While \
a wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"轮子滚动时最低点静止。此时圆环的哪一部分有动能？圆心速度多大？",
"How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"从重物的高度落下的石头速度多大？圆环为什么可以更快？",
"Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.":"求 1.0 m/s 时最高处地面的力，以及它变为零时的速度。",
"In the lab: what does the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.":"在实验室中：圆环在最初 1.5 s 内做什么？在哪个角度跳起？填表。",
"Find the smallest speed with which the hoop hops, to 1 cm/s.":"求圆环能跳起的最小速度，精确到 1 cm/s。","At 2.2 m/s the hoop leaves the floor w\
hile its rim slips. Why does slipping help it to hop?":"2.2 m/s 时圆环在打滑中离地。打滑为什么有助于跳起？",Show:"演示","Teaching with th\
e hoop":"用圆环教学",Worksheet:"学习单",Solutions:"答案",Exercises:"习题","A lesson of 45 minutes":"一节 45 分钟的课",Minute:"分钟",Motion:"\
运动","What students often think":"学生常有的想法",Idea:"想法","What is right":"正确的是","Worksheet: the hoop that hops":"学习单：会跳的圆环",
"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pus\
hed to the right. Friction: μ = 1; g = 9.81 m/s².":"一个半径 0.40 m 的薄环质量为 0.25 kg，边缘固定着 0.75 kg 的重物。圆环立在水平地面上，重物在最高处，向右推动。摩擦因数 μ = 1;g = 9.81 m/s²。",
phases:"阶段","does it hop?":"是否跳起？","at which angle?":"在哪个角度？",Print:"打印","The visit asks before it shows; the presentation fills t\
he screen; the table gives numbers to every student.":"参观先提问后演示；演示占满屏幕；数据表为每个学生提供数字。","Slips, hops":"打\
滑、跳起","no threshold uphill (β < 0): whether it slips or hops hangs on where it turns back; the map shows it":"上坡（β < 0）没有阈值：是否打滑或跳起取决于在何处折返；见参数图",
"A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A 为蓝色，B 为赭色；线型表示物理量；数值属于 {hoop}；{hands}"};var Kt=new Map;function V(i){try{return localStorage.getItem(i)??Kt.get(i)??null}catch{return Kt.get(i)??null}}function Y(i,e){Kt.set(i,e);try{localStorage.setItem(
i,e)}catch{}}var Ce={en:"English",de:"Deutsch",es:"Español",fr:"Français",zh:"中文"},Vt={de:Fs,es:js,fr:Bs,zh:Os},Ii=new Set(["de","es","fr"]),Us="hophoop-language",Ks=4e3,
Xe=/\{(\w+)\}/g,te="en",Gs=[],Ie=new Map,_e=new Set,Ne=new Set,Qe=()=>te;function Yt(i){te=i in Ce?i:"en",Ie=new Map,_e=new Set,Ne.clear(),Gs=Object.keys(Vt[te]??
{}).filter(e=>e.includes("{")).map(Ci).sort((e,t)=>Hs(t.key)-Hs(e.key))}function _i(){let i=V(Us);return i&&i in Ce?i:(globalThis.navigator?.languages??[]).map(
s=>s.slice(0,2).toLowerCase()).find(s=>s in Ce)??"en"}function Vs(i){Y(Us,i)}var Hs=i=>i.replace(Xe,"").length;function Ci(i){let e=[...i.matchAll(Xe)].map(([,s])=>s),
t=i.split(/\{\w+\}/).map(s=>s.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));return{key:i,names:e,pattern:new RegExp(`^${t.join("(.+?)")}$`,"su")}}var ae=i=>Ii.has(te)?
i.replace(/(\d)\.(\d)/g,"$1,$2"):i;function k(i,e){let t=Vt[te];if(e)return se(Js(t?.[i]??$s(i),e));if(!t||!/\p{L}/u.test(i))return ae(i);if(_e.has(i))return i;
let s=Ie.get(i);if(s!==void 0)return s;let o=i.trim(),n=t[o]??Ni(o,t)??$s(o),a=i.replace(o,()=>n);return Ie.size>Ks&&Ie.clear(),Ie.set(i,a),se(a)}function se(i){
return _e.size>Ks&&_e.clear(),_e.add(i),i}var Ys=(i,e)=>i.replace(Xe,(t,s)=>String(e[s])),Js=(i,e)=>i.replace(Xe,(t,s)=>k(String(e[s])));function Ni(i,e){for(let{
key:t,pattern:s,names:o}of Gs){let n=i.match(s);if(n)return Js(e[t],Object.fromEntries(o.map((a,r)=>[a,n[r+1]])))}return Wi(i)}function Wi(i){if(i.includes(" → "))
return i.split(" → ").map(e=>k(e)).join(" → ")}function Zs(i){if(!Vt[te])return i;let[,e,t]=i.match(/^(.*?)\.(?: (.*))?$/su)??["",i,""],{comma:s,stop:o}=te===
"zh"?{comma:"，",stop:"。"}:{comma:", ",stop:"."},a=`${e[0]?.toLowerCase()??""}${e.slice(1)}`.split(/, (?!\d)/).map(r=>k(r)).join(s);return se(`${a[0]?.toLocaleUpperCase(
te)??""}${a.slice(1)}${o}${t?` ${k(t)}`:""}`)}function $s(i){let e=/\p{L}{3,}/u.test(i)&&!/^([\w.[\]]+\.\w+|rad\/s|hophoop.*)$/u.test(i);return te!=="en"&&e&&Ne.
size<200&&Ne.add(i),ae(i)}var Xs=new WeakMap,Gt=new WeakMap;function Jt(i){let e=document.createTextNode(k(i));return Xs.set(e,i),e}function We(i,e,t){let s=Gt.
get(i)??{};s[e]=t,Gt.set(i,s),i.setAttribute(e,k(t))}function Qs(i){let e=document.createTreeWalker(i,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let t=e.
nextNode();t;t=e.nextNode()){let s=Xs.get(t);s!==void 0&&(t.nodeValue=k(s));let o=Gt.get(t);for(let[n,a]of Object.entries(o??{}))t.setAttribute(n,k(a))}}Yt(_i());var qi=new Set(["aria-label","title","placeholder","label"]);function h(i,e={},...t){let s=document.createElement(i),o=s;for(let[n,a]of Object.entries(e))a==null||
a===!1||(n.startsWith("on")?s.addEventListener(n.slice(2),a):n==="class"?s.className=a:n in s&&n!=="list"&&typeof a!="string"?o[n]=a:qi.has(n)?We(s,n,String(a)):
s.setAttribute(n,a===!0?"":a));for(let n of t.flat())n==null||n===!1||s.append(n.nodeType?n:Jt(String(n)));return s}function M(i,e){e?i.replaceChildren(Jt(e)):i.
replaceChildren()}var et=i=>i!==null&&i.getRootNode().activeElement===i,oe=i=>i.getContext("2d");function I(i){let e=i.getBoundingClientRect(),t=Math.min(globalThis.
devicePixelRatio||1,2.5),s=Math.max(Math.round(e.width*t),1),o=Math.max(Math.round(e.height*t),1);(i.width!==s||i.height!==o)&&(i.width=s,i.height=o);let n=oe(i);
return n.setTransform(t,0,0,t,0,0),{context:n,width:s/t,height:o/t}}function Di(i){if(/^#[0-9a-f]{6}$/i.test(i))return i;let e=oe(h("canvas",{width:1,height:1}));
e.fillStyle=i,e.fillRect(0,0,1,1);let[t,s,o]=e.getImageData(0,0,1,1).data;return`#${[t,s,o].map(n=>n.toString(16).padStart(2,"0")).join("")}`}function Zt(i){let e=getComputedStyle(
i),t=o=>e.getPropertyValue(o).trim(),s=o=>Di(t(o));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("--paper"),panel:s("--panel"),ground:s("--gro\
und"),font:t("--font"),dark:Re(s("--paper"))<.2}}function ye(i,e){let t=h("a",{href:URL.createObjectURL(i),download:e});document.body.append(t),t.click(),t.remove(),
setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function J(i,e){let t=0;return()=>{clearTimeout(t),t=setTimeout(i,e)}}var y=(i,e,t)=>Math.min(Math.max(i,e),t);function T(i,e=4){if(i==null)return"–";if(typeof i!="number")return String(i);if(!Number.isFinite(i))return Number.isNaN(
i)?"–":i>0?"∞":"−∞";if(i===0)return"0";let t=Math.abs(i),s;if(t>=1e6||t<1e-4){let[o,n]=i.toExponential(e-1).split("e");s=`${eo(o)}·10${Fi(Number(n))}`}else
s=eo(i.toPrecision(e)),s.includes("e")&&(s=String(Math.round(i)));return ae(s.replace("-","−"))}function eo(i){return i.includes(".")&&!i.includes("e")?i.replace(
/\.?0+$/,""):i}function Fi(i){let e={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(i)].map(t=>e[t]).join(
"")}var _=(i,e)=>e?e==="°"?`${i}°`:`${i} ${e}`:i,P=i=>ae(`${(i*180/Math.PI).toFixed(1)}°`.replace("-","−"));function re(i){let e=Math.abs(i),[t,s]=e>=.995?
[1,"m"]:e>=.00995?[100,"cm"]:[1e3,"mm"];return _(T(i*t,3),s)}function F(i,e){let t=i/Math.max(e,1),s=10**Math.floor(Math.log10(t)),o=t/s;return(o>5?10:o>2?5:o>1?
2:1)*s}function U(i,e,t){if(!(e>i)||!Number.isFinite(i)||!Number.isFinite(e))return[];let s=F(e-i,t),o=[];for(let n=Math.ceil(i/s-1e-9);n*s<=e+1e-9*s&&o.length<
200;n++)o.push(n*s);return o}function O(i,e){let t=y(-Math.floor(Math.log10(e)+1e-9),0,15);return Math.max(Math.abs(i),e)>=1e6||t>12?T(i,3):ae((Math.abs(i)<e*1e-6?
0:i).toFixed(t).replace("-","−"))}var to=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],ji="tfc",Bi=400;function so({time:i=0,options:e={},zoom:t=1,map:s}){let o=[];i>
0&&o.push(`t=${Number(i.toFixed(4))}`);let n=to.filter(([a])=>e[a]).map(([,a])=>a);return n.join("")!==ji&&o.push(`show=${n.join("")}`),t!==1&&o.push(`zoom=${Number(
t.toPrecision(3))}`),s&&o.push(`map=${[s.what,...s.x,...s.y].join(",")}`),o.join("&")}function oo(i){let e=new URLSearchParams(i.replace(/^#/,"")),t={},s=Number(
e.get("t")??Number.NaN);s>=0&&(t.time=s);let o=e.get("show");o!==null&&(t.options=Object.fromEntries(to.map(([w,b])=>[w,o.includes(b)])));let n=Number(e.get("zo\
om")??Number.NaN);n>0&&(t.zoom=y(n,.05,60));let[a,r,l,c,d,u,p]=e.get("map")?.split(",")??[],m=[l,c,u,p].map(Number);return p!==void 0&&m.every(Number.isFinite)&&
m[0]<m[1]&&m[2]<m[3]&&(t.map={what:a,x:[r,m[0],m[1]],y:[d,m[2],m[3]]}),t}var Oi=()=>{let i=new URLSearchParams(location.hash.slice(1)).get("with");return[location.
search.slice(1),...i===null?[]:[i]]},tt=class{constructor(e){this.lab=e,this.number=0,this.soon=J(()=>this.write("same"),Bi),this.listen=()=>this.arrived(),addEventListener(
"popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(e){let{lab:t}=this;if(!t.motions.lanes.length)return;let s=t.link();e==="step"?
history.pushState({number:++this.number},"",s):history.replaceState({number:this.number},"",s)}travel(e){return new Promise(t=>{let s=()=>t();addEventListener("\
popstate",s,{once:!0}),setTimeout(s,300),history.go(e)})}async arrived(){let e=history.state?.number??0,t=Oi();JSON.stringify(t)===JSON.stringify(this.lab.motions.
queries())?this.number=e:await this.lab.motions.arrive(t)?this.number=e:e!==this.number&&history.go(this.number-e)}};var qe=[.05,.1,.25,.5,1,2,4],st=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let e of this.listeners)e(this)}seek(e){this.time=y(e,0,this.duration),this.changed()}play(e=!this.playing){this.playing=e,this.last=null,e&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(e){let t=qe.indexOf(this.speed);this.speed=qe[y(t+e,0,qe.length-1)],this.changed()}tick(e){if(!this.playing)return!1;
let t=this.last===null?0:Math.min(e-this.last,100)/1e3;return this.last=e,this.time+=t*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function Hi(i,e=""){let t=i.trim();e&&t.endsWith(e)&&(t=t.slice(0,-e.length)),t=t.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(o,n,a)=>`e${n&&"-"}${a.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(t);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(t)?Number(t.replace(",",".")):Number.NaN}function $i(i,e,{label:t,unit:s,range:o}){let n=i.trim();if(Number.isNaN(e))return`${t} = ${n} must be a number, s\
uch as 2.5.`;if(!o||e>=o.least&&e<=o.most||o.also.includes(e))return"";let a=o.also.includes(0)?"0 or ":"",r=`from ${T(o.least,4)} to ${_(T(o.most,4),s)}`,l=o.also.
includes(1/0)?", or inf":"";return`${t} = ${_(T(e,6),s)} must be ${a}${r}${l}.`}var Ui=0,ve=class{constructor(e,t){this.info=e,this.onvalue=t,this.shown="",this.
typing=!1,this.error=h("p",{class:"error",role:"alert",id:`hh-error-${++Ui}`,hidden:!0}),this.input=h("input",{type:"text",inputmode:"decimal",autocomplete:"off",
spellcheck:"false",class:"exact","aria-label":e.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:s=>{
s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute("aria-invalid")==="true"}typed(){
let e=this.input.value;if(!this.typing)return;if(this.typing=!1,e.trim()===""){this.restore();return}let t=Hi(e,this.info.unit),s=$i(e,t,this.info);s?this.refuse(
s):this.onvalue(t)}refuse(e){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.id),M(this.error,e),this.error.
hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){this.typing=!1,this.
input.value=this.shown,this.accept()}show(e){this.shown=ae(e),this.typing||this.restore()}};var io={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},Ki={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},Gi=(i,e,t)=>({ring:{shape:i,mass:t,inner_radius:.95*e,outer_radius:e},disk:{shape:i,mass:t,radius:.1*
e,at:.8*e},point_mass:{shape:i,mass:t,at:e},rod:{shape:i,mass:t,length:.5*e,at:.5*e}})[i];function no(i){let e=i["hoop.radius"],t=i["hoop.mass"],s=Math.min(Math.
max(i["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:ot(t*(1-s)),inner_radius:ot(.98*e),outer_radius:e},{shape:"point_mass",mass:ot(t*s),at:e}]}var ot=i=>Number(
i.toPrecision(6)),it=class{parts;text;radius;mass;constructor(e){this.onchange=e,this.list=h("div",{class:"parts"}),this.element=h("div",{},this.list,h("select",
{"aria-label":"Add a part",onchange:t=>{let s=t.target.value;t.target.value="",s&&this.send([...this.parts,Gi(s,this.radius,ot(.2*this.mass))])}},h("option",{value:""},
"+ add a part …"),Object.entries(io).map(([t,{label:s}])=>h("option",{value:t},s))))}send(e){this.onchange([["hoop.parts",e]])}show(e,t,s){let o=JSON.stringify(
e);if(o===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=e;return}Object.assign(this,{text:o,parts:e,radius:t,mass:s}),this.list.
replaceChildren(...e.map((n,a)=>this.row(n,a)))}row(e,t){let{label:s,keys:o}=io[e.shape];return h("fieldset",{class:"part"},h("legend",{},s,this.parts.length>1&&
h("button",{type:"button",class:"quiet","aria-label":`Remove part ${t+1}, ${s}`,onclick:()=>this.send(this.parts.filter((n,a)=>a!==t))},"×")),o.map(n=>this.field(
e,t,n)))}field(e,t,s){let[o,n]=Ki[s],a=new ve({label:o,unit:n},r=>this.send(this.parts.map((l,c)=>c===t?{...l,[s]:r}:l)));return a.show(String(e[s]??0)),h("div",
{},h("label",{},`${o} [${n}]`,a.input),a.error)}};var Xt=Math.PI/180;function Vi({allowed:i,degrees:e}){if(!i)return;let t=e?1/Xt:1;return{least:i.least*t,most:i.most*t,also:i.also.map(s=>s==="inf"?1/0:Number(s))}}
var Qt=class{constructor(e,t){this.info=e,this.onchange=t,this.held=!1;let s=`hh-${e.path}-${Math.random().toString(36).slice(2,7)}`,o=l=>()=>{this.held=l};this.
range=h("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:e.logarithmic?"0.01":String(e.step),"data-path":e.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:o(!0),onpointerup:o(!1),onpointercancel:o(!1),onblur:o(!1)});let{label:n,unit:a}=e,r=`${n}, exact value${a?` i\
n ${a}`:""}`;this.entry=new ve({label:n,unit:a,name:r,range:Vi(e)},l=>this.send(l,!0)),this.element=h("div",{class:"control",title:e.help},h("label",{for:s},h("\
span",{},n),h("span",{class:"symbol"},e.symbol)),this.range,h("span",{class:"entry"},this.entry.input,h("span",{class:"unit"},a)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(e){let t=Number(
this.range.value),s=this.info.logarithmic?Number((10**t).toPrecision(3)):t;this.entry.typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,e)}send(e,t){
let s=this.info.degrees?e*Xt:e;this.onchange([[this.info.path,Number.isFinite(s)?s:"inf"]],t)}say(e){this.range.setAttribute("aria-valuetext",_(T(e,4),this.info.
unit))}show(e,t=null){if(this.held)return;let s=e!=null,o=s?e:t;if(o==null){this.entry.show("");return}let n=o==="inf"?1/0:Number(o)/(this.info.degrees?Xt:1);this.
entry.show(s?Number.isFinite(n)?String(Number(n.toPrecision(9))):"∞":""),this.entry.input.placeholder=s?"":k("auto {value}",{value:T(n,2)}),this.entry.input.title=
s?_(String(n),this.info.unit):"";let a=y(this.info.logarithmic?Math.log10(n):n,this.low(),this.high());Math.abs(Number(this.range.value)-a)>1e-6&&(this.range.value=
String(a)),this.say(n)}};function Yi(i,e){let t=h("select",{"data-path":i.path,onchange:()=>e([[i.path,t.value]],!0)},i.options.map(([o,n])=>h("option",{value:o},
n)));return{element:h("label",{class:"choice",title:i.help},h("span",{},i.label),t),select:t,path:i.path}}var nt=class{way;kind;gravity;apart;derived;film;constructor(e,t){
this.onchange=(s,o=!0)=>t(s,o),this.sliders=new Map;for(let s of Object.values(e.groups))for(let o of s)this.sliders.set(o.path,new Qt(o,this.onchange));this.choices=
new Map(e.choices.map(s=>[s.path,Yi(s,this.onchange)])),this.parts=new it(this.onchange),this.gravities=e.gravities,this.element=h("div",{class:"controls"},this.
hoop(),this.plane(),this.start(),this.contact())}at(e){let t=this.sliders.get(e)??this.choices.get(e);if(!t)throw new Error(`There is no control of ${e}.`);return t.
element}select(e,t,s){let o=h("select",{onchange:()=>s(o.value)},t.map(([n,a])=>h("option",{value:n},a)));return{select:o,element:h("label",{class:"choice"},h("\
span",{},e),o)}}group(e,...t){let s=e==="Start"||e==="Plane"||!matchMedia("(max-width: 760px)").matches;return h("details",{class:"group",open:s},h("summary",{},
e),t)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],e=>{let{values:t}=this.
film;e==="parts"?this.onchange([["hoop.parts",no(t)]]):this.onchange([[`hoop.${e}`,t["hoop.eccentricity"]]])}),this.derived=h("p",{class:"derived"}),this.group(
"Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.eccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.r\
adius"),this.at("hoop.mass"))}plane(){return this.apart=h("input",{type:"checkbox",onchange:()=>{let{values:e}=this.film;this.apart.checked?this.onchange([["pla\
ne.mu_static",e["plane.mu_static"]],["plane.mu_kinetic",e["plane.mu_kinetic"]]]):this.onchange([["plane.mu",e["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([e])=>[e,e]),["","elsewhere"]],e=>{let t=this.gravities.find(([s])=>s===e);t&&this.onchange([["plane.gravity",t[1]]])}),this.group(
"Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_kinetic"),h("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.
at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("plane.restitution"),this.at("plane.rolling_resistance"),this.at("plane.impact_law"),this.
at("plane.painleve"))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],e=>{let{values:t}=this.film;e==="rolling"?this.
onchange([["start.speed",t["start.vx"]]]):this.onchange([["start.omega",t["start.omega"]]])}),this.group("Start",this.kind.element,this.at("start.speed"),this.at(
"start.angle"),this.at("start.height"),this.at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.at("duration"))}contact(){return this.group("Contact",
this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitut\
ion"))}refuse(e,t){let s=e.length===1?this.sliders.get(e[0][0]):void 0;return s?.element.checkVisibility()?(s.entry.refuse(t),!0):!1}restore(){this.film&&this.showChoices(
this.film,new Set)}show(e,t=new Set){this.film=e,this.showChoices(e,t);let s=e.scenario;for(let[o,n]of this.sliders){if(t.has(o))continue;let[a,r]=o.split(".");
n.show(e.values[o]??(r?s[a]?.[r]:s[a]),e.automatic?.[o])}}showChoices(e,t){let{scenario:s,values:o}=e,n=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_frac\
tion":"eccentricity",a="speed"in s.start,r="mu_static"in s.plane,l=s.contact.model==="compliant",c=(...m)=>m.some(w=>t.has(w));c("hoop.load_fraction","hoop.ecce\
ntricity","hoop.parts")||(this.way.select.value=n),c("start.speed","start.omega")||(this.kind.select.value=a?"rolling":"free"),c("plane.mu","plane.mu_static")||
(this.apart.checked=r);let d=this.gravities.find(([,m])=>Math.abs(m-s.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=d?d[0]:"");let u={"hoo\
p.load_fraction":n==="load_fraction","hoop.eccentricity":n==="eccentricity","hoop.inertia_ratio":n==="eccentricity","hoop.mass":n!=="parts","plane.mu":!r,"plane\
.mu_static":r,"plane.mu_kinetic":r,"plane.restitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":a,"start.height":!a,"start.vx":!a,"start.vy":!a,
"start.omega":!a,"contact.law":l,"contact.friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[m,w]of Object.entries(u))this.
at(m).hidden=!w;this.parts.element.hidden=n!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,o["hoop.radius"],o["hoop.mass"]),this.derived.textContent=n==="\
eccentricity"?"":`ε = ${T(o["hoop.eccentricity"],5)}, κ = ${T(o["hoop.inertia_ratio"],5)}`+(n==="parts"?`, m = ${T(o["hoop.mass"],5)} kg`:"");let p=s;for(let[
m,{select:w}]of this.choices){if(t.has(m))continue;let[b,g]=m.split(".");p[b]?.[g]!==void 0&&(w.value=p[b][g])}}};var es=Math.PI/180;function ao(i,e){let{start:t,plane:s,contact:o,hoop:n}=i.scenario;return o.model!=="rigid"?"Rigid contact only.":i.slope!==0?"The plane must \
be level.":Math.abs(i.gravity-9.81)>1e-9?"It must be on Earth.":(s.restitution??0)!==0?"Restitution must be 0.":i.radius!==1||n.parts?"The radius must stay 1 m,\
 without parts.":i.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in n?"speed"in t?Math.abs(t.speed??3.1)>e+1e-9?e>5?"At most 10 \
m/s.":"At most 3.1 m/s.":i.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var ro=i=>i.events.filter(
({kind:e})=>e==="takeoff");function Ji(i){return i.events.filter(({kind:e})=>e==="apex").map(({height:e})=>e)}var lo=(i,e)=>Math.min(Math.round(100*i/e),100),Zi=1.596,
Xi=.37,Qi=.05,ts=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:i=>{let e=ao(i,3.1);if(e)return{points:0,text:e};let t=Math.max(
0,...Ji(i));return t?{points:lo(t,Zi),text:"It rises by {height}.",values:{height:re(t)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land uprigh\
t",text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=\
0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:i=>{let e=ro(i)[0],t=i.events.find(({kind:a,t:r})=>a==="impact"&&e&&r>e.t);if(!e||!t)return{
points:0,text:"It does not hop."};let s=i.events.find(({kind:a,t:r})=>a==="apex"&&r>e.t);if(!s||s.height<Qi)return{points:0,text:"The first hop is too low."};let o=Math.
abs(t.angle-2*Math.PI*Math.round(t.angle/(2*Math.PI)))/es,n=Math.max(0,Math.round(100*(1-(o-.5)/89.5)));return{points:Math.min(n,100),text:"It lands {off} away \
from the top.",values:{off:P(o*es)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:i=>{let e=ao(i,10);if(e)return{points:0,text:e};if(Math.
abs(Math.abs(i.scenario.start.angle??0)-Math.PI)>.5*es)return{points:0,text:"The load must start at the bottom."};if(i.values["plane.mu_kinetic"]>1.5||i.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let t=ro(i)[0];if(!t)return{points:0,text:"It does not hop."};let s=i.phases.filter(
({from:n})=>n<t.t);if(s.some(({mode:n})=>n==="K"))return{points:0,text:"It skids before it hops."};if(s[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let o=i.events.find(({kind:n,t:a})=>n==="apex"&&a>t.t);return o?{points:lo(o.height,Xi),text:"It rises by {height}.",values:{height:re(o.height)}}:{points:0,
text:"It does not hop."}}}],ss=i=>i>=95?3:i>=75?2:i>=40?1:0;var ho="hophoop-best-",en=i=>"★".repeat(ss(i))+"☆".repeat(3-ss(i)),at=class{goal=null;constructor(e){this.lab=e,this.tabs=new Map(ts.map(t=>[t.key,h("button",
{type:"button","aria-pressed":"false",onclick:()=>this.choose(t)},t.title)])),this.text=h("p",{}),this.meter=h("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"\
100","aria-label":"Score"}),this.result=h("p",{class:"challenge-result",role:"status"}),this.kept=h("p",{class:"hint"}),this.element=h("section",{class:"challen\
ges card","aria-label":"Challenges",hidden:!0},h("header",{},h("h2",{},"Challenges"),h("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",
onclick:()=>this.close()},"×")),h("div",{class:"tabs",role:"group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.
kept,h("div",{class:"buttons"},h("button",{type:"button",onclick:()=>this.goal&&this.load(this.goal.start)},"Begin again"),h("button",{type:"button",onclick:()=>this.
goal&&this.load(this.goal.best)},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??ts[0]),this.element.scrollIntoView({block:"nearest"}),
this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(e){this.goal=e;for(let[t,s]of this.tabs)s.setAttribute(
"aria-pressed",String(t===e.key));M(this.text,e.text),this.changed()}async load(e){let{lab:t}=this;try{let s=await t.backend.call("film",{query:e});t.clock.play(
!1),t.clock.time=0,t.motions.replace(s)}catch(s){t.notice.fail(s)}}changed(){let{goal:e,lab:t}=this;if(!e)return;let{points:s,text:o,values:n={}}=e.score(t.film());
this.meter.value=s;let a=k("{stars} {points} points. {what}",{stars:en(s),points:s,what:k(o,n)});this.result.textContent!==a&&(this.result.textContent=a);let r=Number(
V(ho+e.key)??0);s>r&&!t.stage.options.ahead&&Y(ho+e.key,String(s)),M(this.kept,k("Your best: {points} points.",{points:Math.max(r,t.stage.options.ahead?0:s)}))}};var co=.09,tn=.03,os=Math.PI/180,rt=Math.PI/4,uo=2*Math.PI,De=i=>i-uo*Math.round(i/uo);function lt(i,e){let t=i.at(e),s=e===0;return{angle:De(t.angle),height:Math.
max(t.height,0),vx:s?t.vx:0,vy:s?t.vy:0,omega:s?t.omega:0,slope:i.slope}}var po=i=>2*Math.sqrt(Math.max(i.gravity,1)*i.radius),le=i=>Number(i.toFixed(4))+0;function mo(i,e,t){
if(i==="plane")return[["plane.slope",le(e.slope)]];if(e.height>0)return[["start.angle",le(e.angle)],["start.height",le(e.height)],["start.vx",le(e.vx)],["start.\
vy",le(e.vy)],["start.omega",le(e.omega)]];let s=i==="load"?e.omega*t.radius:e.vx;return[["start.angle",le(e.angle)],["start.speed",le(s)]]}var Fe=class{constructor(e,t,s,o,n){
this.grip=e,this.film=t,this.view=o,this.before=lt(t,s),this.held={...this.before,vx:0,vy:0,omega:0};let a=t.at(s);this.center=[a.x,t.radius+a.height],this.foot=
o.point(a.x,0),this.from=this.read(n),this.turned=0,this.trail=[],this.moved=0}read(e){let[t,s]=this.view.unpoint(e.clientX,e.clientY),o=this.grip==="plane"?Math.
atan2(e.clientY-this.foot[1],e.clientX-this.foot[0]):Math.atan2(t-this.center[0],s-this.center[1]);return{x:e.clientX,y:e.clientY,along:t,away:s,turn:o}}move(e,t){
let s=this.read(e),{radius:o}=this.film;if(this.turned+=De(s.turn-this.from.turn-this.turned),this.grip==="plane"){let n=y(this.before.slope+this.turned,-rt,rt);
this.held.slope=Math.abs(n)<os?0:n}else if(this.grip==="load")this.held.angle=De(this.before.angle+this.turned);else{let n=this.before.height+s.away-this.from.away;
this.held.height=n<tn*o?0:n;let a=s.along-this.from.along;this.held.angle=De(this.before.angle+(this.held.height>0?0:a/o)),this.moved=s.x-this.from.x}for(this.trail.
push({t:t/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<t/1e3-co;)this.trail.shift();return this.held}release(e){let{held:t,
trail:s,film:o}=this,n=s.at(-1),a=s[0],r=n&&a?n.t-a.t:0,l=!n||r<.012||e/1e3-n.t>co,c=po(o);return l||this.grip==="plane"||(this.grip==="load"?t.omega=y((n.turned-
a.turned)/r,-c/o.radius,c/o.radius):(t.vx=y((n.along-a.along)/r,-c,c),t.vy=t.height>0?y((n.away-a.away)/r,-c,c):0)),t}};function fo(i,e,t,s,o){let n={ArrowLeft:-1,
ArrowRight:1}[e]??0,a={ArrowDown:-1,ArrowUp:1}[e]??0;if(!n&&!a)return null;let r=t?.2:1;if(i==="load"){let u=De(s.angle+(n||a)*5*os*r);return{...s,angle:u}}if(i===
"plane"){let u=y(s.slope+(n||-a)*os*r,-rt,rt);return{...s,slope:Math.abs(u)<1e-9?0:u}}let l=po(o),c=y(s.height+a*.05*r*o.radius,0,4*o.radius),d=y(s.vx+n*.1*r,-l,
l);return{...s,height:c<1e-9?0:c,vx:d}}function C(i,e,t,s=()=>{}){let o=new AbortController,{signal:n}=o,a=(l,c)=>i.addEventListener(l,d=>d.pointerId===e.pointerId&&c(d),{signal:n}),r=l=>c=>{o.abort(),
s(c,l)};i.setPointerCapture(e.pointerId),a("pointermove",t),a("pointerup",r(!0)),a("pointercancel",r(!1))}function go(i,e){let t=new Map,s=null,o=()=>{let[a,r]=[
...t.values()];return{span:Math.max(Math.hypot(a.clientX-r.clientX,a.clientY-r.clientY),1),clientX:.5*(a.clientX+r.clientX),clientY:.5*(a.clientY+r.clientY)}};i.
addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(t.set(a.pointerId,a),s=t.size===2?o():null)}),i.addEventListener("pointermove",a=>{if(!t.has(a.pointerId)||
(t.set(a.pointerId,a),t.size!==2||!s))return;let r=o();e(r.span/s.span,r),s=r});for(let a of["pointerup","pointercancel"])i.addEventListener(a,r=>{t.delete(r.pointerId),
s=null});let n=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();return i.addEventListener("touchmove",n,{passive:!1}),()=>t.size>1}var sn=700,is=44,on=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],ht=class{static Pull=Fe;pull=null;held=null;before=null;constructor(e){this.
lab=e,this.places=new Map(on.map(([n,a,r])=>[n,this.place(n,a,r)])),this.tip=h("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=h("div",
{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.values()],this.tip),e.stage.element.before(this.element);let{flat:t,plane:s}=e.
stage;t.grab=n=>this.take(n),s.addEventListener("pointermove",n=>this.hover(n)),s.addEventListener("pointerleave",()=>this.hover(null));let o=n=>this.pull&&n.cancelable&&
n.preventDefault();s.addEventListener("touchmove",o,{passive:!1}),this.settle=J(()=>this.chosen(!1),sn)}place(e,t,s){return h("div",{class:`grip grip-${e}`,role:"\
slider",tabindex:"0","aria-label":t,"aria-valuenow":"0",title:s,onkeydown:o=>this.key(e,o),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.
flat.views[this.lab.motions.active]}draw(){let{lab:e}=this,t=this.view(),s=!!t&&!e.stage.options.three;if(this.element.hidden=!s,!s)return;this.element.classList.
toggle("running",e.clock.playing);let{pose:o,film:n,scale:a}=t,r=n.radius,l=t.point(o.x,r+o.height),c=t.point(o.x+r*Math.sin(o.angle),r+o.height+r*Math.cos(o.angle)),
d=this.onPlane(t),u=y(1.1*r*a,is,190),p=[["plane",d,is],["hoop",l,u],["load",c,is]];for(let[m,[w,b],g]of p){let f=this.places.get(m);f.style.transform=`translat\
e(${w-g/2}px, ${t.top+b-g/2}px)`,f.style.width=f.style.height=`${g}px`,f.hidden=w<0||b<0||w>t.width||b>t.height}e.clock.playing||this.tell(n)}onPlane(e){let t=e.
point(e.pose.x,0),o=(Math.min(t[0]+Math.max(1.9*e.film.radius*e.scale,90),e.width-30)-t[0])/(e.scale*Math.max(e.cosine,.2));return e.point(e.pose.x+o,0)}tell(e){
let t=this.pull?.held??this.held??lt(e,this.lab.clock.time),s={load:P(t.angle),hoop:k("gap {height}, speed {speed} m/s",{height:re(t.height),speed:T(t.vx,3)}),plane:P(
t.slope)},o={load:t.angle*(180/Math.PI),hoop:t.height,plane:t.slope*(180/Math.PI)},n={load:[-180,180],hoop:[0,4*e.radius],plane:[-45,45]};for(let[a,r]of this.places)
r.getAttribute("aria-valuetext")!==s[a]&&(r.setAttribute("aria-valuetext",s[a]),r.setAttribute("aria-valuenow",String(Number(o[a].toPrecision(4)))),r.setAttribute(
"aria-valuemin",String(n[a][0])),r.setAttribute("aria-valuemax",String(Number(n[a][1].toPrecision(4)))))}under(e){if(this.element.hidden)return null;let t=null;
for(let[s,o]of this.places){let{left:n,top:a,width:r}=o.getBoundingClientRect(),l=Math.hypot(e.clientX-n-r/2,e.clientY-a-r/2);!o.hidden&&l<=r/2&&(t=s)}return t}hover(e){
if(this.pull)return;let t=e&&e.pointerType!=="touch"?this.under(e):null;for(let[s,o]of this.places)o.classList.toggle("near",s===t);this.lab.stage.plane.style.cursor=
t?"grab":""}take(e){let t=this.under(e);if(!t||e.button>0||this.pull)return!1;let{lab:s}=this,{flat:o,plane:n}=s.stage,a=this.places.get(t),r=this.view(),l=n.getBoundingClientRect(),
c=f=>({clientX:f.clientX-l.left,clientY:f.clientY-l.top-r.top}),d=new Fe(t,s.film(),s.clock.time,r,c(e)),u=[...o.shift],[p,m]=[!1,!1];this.pull=d,a.classList.add(
"held");let w=()=>{m=!0,b.abort(),a.classList.remove("held"),o.fixed=null,this.pull=null,p&&this.comeBack(u)},b=new AbortController,g=f=>{f.key==="Escape"&&(f.stopPropagation(),
w(),p&&this.back())};return addEventListener("keydown",g,{capture:!0,signal:b.signal}),C(n,e,f=>{if(!m){if(o.pinched()){w(),p&&this.back();return}!p&&Math.hypot(
f.clientX-e.clientX,f.clientY-e.clientY)<3||(p||(o.fixed=r.scale,this.hold(),this.begin()),p=!0,d.move(c(f),f.timeStamp),o.shift=[u[0]+d.moved,u[1]],this.change(
t,d.held,!1),this.show(t,d.held))}},(f,x)=>{m||(w(),p&&(x?(this.change(t,d.release(f.timeStamp),!0),this.end(!0)):this.back()))}),!0}key(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return;let{lab:s}=this;if(t.key==="Escape"&&this.held)this.back();else if(t.key==="Enter")this.chosen(!0);else{this.held??=lt(s.film(),s.clock.time);let o=fo(
e,t.key,t.shiftKey,this.held,s.film());if(!o)return;this.before===null&&(this.hold(),this.begin()),this.held=o,this.change(e==="load"?"hoop":e,o,!1),this.show(e,
o),this.settle()}t.preventDefault(),t.stopPropagation()}hold(){this.lab.clock.play(!1),this.before=this.lab.film().query}begin(){let{lab:e}=this;e.stage.options.
ahead=!0,e.clock.seek(0),e.root.classList.add("holding")}change(e,t,s){this.lab.motions.change(mo(e,t,this.lab.film()),s)}show(e,t){let s={load:`θ = ${P(t.angle)}`,
hoop:t.height>0?`y = ${re(t.height)}`:`θ = ${P(t.angle)}`,plane:`β = ${P(t.slope)}`};M(this.tip,t.vx&&this.held?`${s[e]}, v = ${T(t.vx,3)} m/s`:s[e]),this.tip.
hidden=!1}chosen(e){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(e)}end(e){let{lab:t}=this;this.held=null,this.before=null,this.tip.hidden=
!0,t.stage.options.ahead=!1,t.root.classList.remove("holding"),e&&t.clock.seek(0),e&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&t.clock.play(!0),t.
request()}async back(){let{lab:e,before:t}=this;if(this.end(!1),t===null)return;let s=e.motions.lanes[e.motions.active];for(s.pending=null;s.busy;)await new Promise(
o=>requestAnimationFrame(o));try{e.motions.replace(await e.backend.call("film",{query:t}))}catch(o){e.notice.fail(o)}}comeBack(e){let{flat:t}=this.lab.stage,s=matchMedia(
"(prefers-reduced-motion: reduce)").matches,o=()=>{if(this.pull)return;let n=t.shift[0]-e[0];t.shift=Math.abs(n)<1||s?[...e]:[e[0]+.82*n,e[1]],this.lab.request(),
t.shift[0]!==e[0]&&requestAnimationFrame(o)};o()}};var nn={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function N(i){let e="\
http://www.w3.org/2000/svg",t=document.createElementNS(e,"svg");t.setAttribute("viewBox","0 0 17 17"),t.setAttribute("aria-hidden","true"),t.setAttribute("class",
"icon");let s=document.createElementNS(e,"path");return s.setAttribute("d",nn[i]),t.append(s),t}var ct=class{constructor(e){this.lab=e,this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener("fullscreenchange",this.left),
this.full=!1,this.on=!1,this.onchange=()=>{}}async turn(e=!this.on){let{root:t}=this.lab;if(this.on=e,t.classList.toggle("presenting",e),this.onchange(),this.lab.
show(),!e){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await t.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var wo=.22,bo=.03;function yo(i,e){let t=i.at(e),s=i.mass*(i.gravity||9.81),o=t.mode==="H"||!(t.normal_force>0)?0:t.normal_force/s,n=o/(1+o),a=t.mode==="S"||t.mode===
"K",r=Math.abs(t.slip)/Math.sqrt((i.gravity||9.81)*i.radius);return{tone:n,pitch:55*(1+Math.min(o,8))**.5,hiss:a?n*y(.15+r,0,1):0}}function vo(i,e,t){let s=Math.
sqrt(2*(i.gravity||9.81)*i.radius);return i.events.filter(({kind:o,t:n,before:a})=>o==="impact"&&a&&n>e&&n<=t).map(({before:o})=>y(Math.abs(o.vy)/s,.02,1))}function an(i){
let e=i.createBuffer(1,i.sampleRate,i.sampleRate),t=e.getChannelData(0),s=1;for(let o=0;o<t.length;o++)s=s*16807%2147483647,t[o]=2*s/2147483647-1;return e}var dt=class{static heard=yo;static knocks=vo;context=null;on=!1;last=0;start(){
let e=new AudioContext,t=e.createOscillator();t.type="triangle";let s=e.createBufferSource();s.buffer=an(e),s.loop=!0;let o=e.createBiquadFilter();o.type="bandp\
ass",o.frequency.value=1800,o.Q.value=.6;let[n,a]=[e.createGain(),e.createGain()];n.gain.value=a.gain.value=0,t.connect(n).connect(e.destination),s.connect(o).connect(
a).connect(e.destination),t.start(),s.start(),this.context=e,Object.assign(this,{tone:t,low:n,high:a})}turn(e){this.on=e,e&&!this.context&&this.start(),e?this.context?.
resume():this.context&&(this.set("low",0),this.set("high",0))}set(e,t){let{gain:s}=this[e];s.setTargetAtTime(wo*t,this.context.currentTime,bo)}follow(e,t){if(!this.
on||!this.context)return;if(!t.playing){this.set("low",0),this.set("high",0),this.last=t.time;return}let{tone:s,pitch:o,hiss:n}=yo(e,t.time);if(this.set("low",s),
this.set("high",.6*n),this.tone.frequency.setTargetAtTime(o,this.context.currentTime,bo),t.time>this.last)for(let a of vo(e,this.last,t.time))this.knock(a);this.
last=t.time}knock(e){let t=this.context,s=t.currentTime,o=t.createGain();o.gain.setValueAtTime(2.2*wo*Math.sqrt(e),s),o.gain.exponentialRampToValueAtTime(1e-4,s+
.18);let n=t.createOscillator();n.frequency.setValueAtTime(190,s),n.frequency.exponentialRampToValueAtTime(60,s+.15),n.connect(o).connect(t.destination),n.start(
s),n.stop(s+.2)}close(){this.context?.close()}};var ns=Math.PI/180,j=i=>e=>e.columns[i],je=(i,e)=>t=>t.derived(i,s=>Float64Array.from(t.t,(o,n)=>e(s,n,t))),W={time:{name:"time",symbol:"t",unit:"s",values:i=>i.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:je("degrees",({angle:i},e)=>i[e]/ns)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:je(
"within",({angle:i},e)=>{let t=s=>Math.floor(i[s]/ns/360);return e>0&&t(e)!==t(e-1)?Number.NaN:i[e]/ns-360*t(e)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:j("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:j("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:je(
"rise",({height:i,angle:e},t,s)=>s.radius*(1+s.eccentricity*Math.cos(e[t]))+i[t])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:j("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:je("spin",({omega:i},e,t)=>i[e]*t.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:j(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:j("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:j("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:j("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:j("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:j("utilization")},kinetic:{name:"kinetic energy",symbol:"E_k",unit:"J",values:j("kinetic")},potential:{name:"\
potential energy",symbol:"E_p",unit:"J",values:j("potential")},total:{name:"total energy",symbol:"E",unit:"J",values:je("total",({kinetic:i,potential:e},t)=>i[t]+
e[t])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:j("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:j("normal_loss")}},ko=({name:i,symbol:e})=>[i," ",e];var rn=["time","angle","x","vx","spin","normal_force","friction_force"],ln=[1,.5,.2,.1,.05,.02,.01],as=601;function xo(i,e,t){let s=Math.min(Math.floor(i.duration/
t+1e-9)+1,as),o=[];for(let n=0;n<s;n++){let a=Number((n*t).toPrecision(12));o.push({time:a,mode:i.at(a).mode,values:e.map(r=>hn(i,r,a))})}return o}function hn(i,e,t){
if(e==="time")return t;let s=i.at(t);if(e in s&&e!=="angle")return s[e];let o=s.angle*180/Math.PI;if(e==="angle")return o;if(e==="turns")return o-360*Math.floor(
o/360);let n=W[e].values(i),a=i.index(t),r=Math.min(a+1,i.length-1),l=i.t[r]>i.t[a]?(t-i.t[a])/(i.t[r]-i.t[a]):0;return n[a]+l*(n[r]-n[a])}var ut=class{film;rows=[];now;constructor(e){
this.lab=e,this.columns=[...rn],this.step=h("select",{onchange:()=>this.fill()},ln.map(t=>h("option",{value:String(t)},`${t} s`))),this.step.value="0.1",this.picks=
h("div",{class:"table-picks"},Object.entries(W).filter(([t])=>t!=="time").map(([t,{name:s}])=>this.pick(t,s))),this.caption=h("caption",{}),this.head=h("thead",
{}),this.body=h("tbody",{}),this.element=h("section",{class:"table","aria-label":"Table of the motion",hidden:!0},h("header",{},h("h2",{},"Table"),h("label",{class:"\
table-step"},h("span",{},"Every"),this.step),h("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),h("button",{type:"button",onclick:()=>this.open(!1)},
"Close")),h("details",{class:"table-columns"},h("summary",{},"Columns"),this.picks),h("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table\
 of the motion, rows"},h("table",{},this.caption,this.head,this.body)))}pick(e,t){let s=h("input",{type:"checkbox",checked:this.columns.includes(e),onchange:()=>{
let o=new Set(this.columns);s.checked?o.add(e):o.delete(e),this.columns=Object.keys(W).filter(n=>o.has(n)),this.fill()}});return h("label",{},s,h("span",{},t))}open(e){
this.element.hidden=!e,e&&(this.draw(this.lab.film()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(e){this.
element.hidden||(this.film=e,this.fill())}fill(){let{film:e,columns:t}=this,s=Number(this.step.value),o=this.lab.theme.colors.mode_names,n=t.map(c=>W[c]);this.head.
replaceChildren(h("tr",{},n.map(({name:c,symbol:d,unit:u})=>h("th",{scope:"col",title:c},d,u&&h("small",{},` ${u}`))),h("th",{scope:"col"},"mode")));let a=xo(e,
t,s);this.rows=a.map(({time:c,mode:d,values:u})=>({time:c,row:h("tr",{onclick:()=>this.lab.clock.seek(c)},u.map((p,m)=>m===0?h("th",{scope:"row"},T(p,4)):h("td",
{},T(p,4))),h("td",{class:"table-mode"},o[d]))})),this.body.replaceChildren(...this.rows.map(({row:c})=>c));let r=e.duration/s+1<=as+1e-6,l=k("The first {count}\
 rows.",{count:as});M(this.caption,r?e.summary:se(`${e.summary} ${l}`)),this.cursor(this.lab.clock.time)}cursor(e){if(this.element.hidden||!this.rows.length)return;
let t=Number(this.step.value),s=this.rows[Math.min(Math.round(e/t),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.add("\
now"),this.now=s)}save(){let{film:e,columns:t}=this,s=[...t.map(n=>`${W[n].name} [${W[n].unit||"1"}]`),"mode"],o=xo(e,t,Number(this.step.value)).map(({mode:n,values:a})=>[
...a,n].join(","));ye(new Blob([[s.join(","),...o,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var To="hoop.radius=0.4&duration=1.5&start.speed=",cn=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${To}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],dn=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],un=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],pn=["1.0","1.3","1.6","1.9","2.2","2.3"],mn=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function So(i,e){
let t=d=>{c.close(),i(d)},s=(d,u="Show")=>h("button",{type:"button",class:"link",onclick:()=>t(d)},u),o=mn(),n=o&&[["teach/index.html","Teaching with the hoop"],
["teach/worksheet.html","Worksheet"],["teach/solutions.html","Solutions"],["teach/exercises.html","Exercises"]],a=h("table",{},h("caption",{},"A lesson of 45 mi\
nutes"),h("thead",{},h("tr",{},["Minute","What happens","Motion"].map(d=>h("th",{scope:"col"},d)))),h("tbody",{},cn.map(([d,u,p])=>h("tr",{},h("th",{scope:"row"},
d),h("td",{},u),h("td",{},p===null?"":s(p)))))),r=h("table",{},h("caption",{},"What students often think"),h("thead",{},h("tr",{},["Idea","What is right"].map(d=>h(
"th",{scope:"col"},d)))),h("tbody",{},dn.map(([d,u])=>h("tr",{},h("td",{},d),h("td",{},u))))),l=h("section",{class:"sheet"},h("h3",{},"Worksheet: the hoop that \
hops"),h("p",{},"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at th\
e top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s²."),h("ol",{},un.map(d=>h("li",{},d,h("div",{class:"answer-line"})))),h("table",{class:"sheet-\
table"},h("thead",{},h("tr",{},["v₀ [m/s]","phases","does it hop?","at which angle?"].map(d=>h("th",{scope:"col"},d)))),h("tbody",{},pn.map(d=>h("tr",{},h("th",
{scope:"row"},s(`${To}${Number(d)}`,d)),h("td",{}),h("td",{}),h("td",{})))))),c=h("dialog",{class:"teach","aria-label":"For teachers"},h("header",{},h("h2",{},"\
For teachers"),h("button",{type:"button",onclick:()=>print()},"Print"),h("button",{type:"button",class:"close",onclick:()=>c.close()},"Close")),h("p",{},"The vi\
sit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",h("button",{type:"button",class:"link",onclick:()=>{c.close(),
e()}},"Start the visit")),n&&h("p",{},n.map(([d,u])=>h("a",{class:"teach-page",href:new URL(d,new URL(o,document.baseURI)).href},u))),a,r,l);return c}var rs="RSKHM",fn=new Set(["x","angle","height"]),gn=1/60,Mo=8,wn={x:"vx",angle:"omega",height:"vy"},he=class{constructor(e){let{header:t}=e;this.scenario=t.scenario,
this.query=t.query,this.duration=t.duration,this.status=t.status,this.sequence=t.sequence,this.events=t.events,this.values=t.values,this.automatic=t.automatic,this.
said=t.summary,this.story=t.story,this.shortened=t.shortened,this.columns=e.arrays,this.t=e.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.rad\
ius"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.
gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map,this.part=null}wanted(e,t=0){if(this.duration<gn*this.length)return null;
let s=y(e,0,this.duration),o=Math.min(s+t,this.duration);if(this.part&&s>=this.part.t[0]&&o<=this.part.t[this.part.length-1])return null;let n=Math.max(s-.25*Mo,
0);return[n,Math.min(n+Mo+t,this.duration)]}refine(e){this.part=Object.assign(Object.create(this),{columns:e,t:e.t,length:e.t.length,cache:new Map,part:null})}holding(e){
let{part:t}=this;return t&&e>=t.t[0]&&e<=t.t[t.length-1]?t:this}get summary(){return Zs(this.said)}findPhases(){let{mode:e}=this.columns,t=[];for(let s=0;s<this.
length;s++){let o=t.at(-1);o&&o.mode===rs[e[s]]?o.to=this.t[s]:t.push({mode:rs[e[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<t.length;s++)t[s].to=t[s+1].from;
return t.filter(s=>s.to>s.from||t.length===1)}findExtent(){let{x:e,height:t,vx:s,vy:o,omega:n}=this.columns,a={left:1/0,right:-1/0,top:0,speed:0},r=[];for(let l=0;l<
this.length;l++){Number.isFinite(e[l])&&(a.left=Math.min(a.left,e[l]),a.right=Math.max(a.right,e[l])),t[l]>a.top&&(a.top=t[l]);let c=Math.hypot(s[l],o[l])+this.
radius*Math.abs(n[l]);Number.isFinite(c)&&r.push(c)}return r.sort((l,c)=>l-c),a.speed=r[Math.floor(.95*(r.length-1))]||1,a}index(e){let t=0,s=this.length;for(;s-
t>1;){let o=t+s>>1;this.t[o]<=e?t=o:s=o}return t}pieces(){let{part:e}=this;if(!e)return[{film:this,from:0,to:this.length}];let[t,s]=[e.t[0],e.t[e.length-1]],o=this.
index(t);for(;o>0&&this.t[o]>=t;)o--;let n=this.t[o]>=t?0:o+1;return[{film:this,from:0,to:n},{film:e,from:0,to:e.length},{film:this,from:this.index(s)+1,to:this.
length}]}at(e){let t=y(e,0,this.duration),s=this.holding(t);if(s!==this)return s.at(t);let o=this.index(t),n=Math.min(o+1,this.length-1),a=this.t[n]-this.t[o],r=a>
0?(t-this.t[o])/a:0,l={t,mode:rs[this.columns.mode[o]]};for(let[c,d]of Object.entries(this.columns)){if(c==="t"||c==="mode")continue;let u=d[o],p=d[n];if(r===0||
!Number.isFinite(p))l[c]=u;else if(fn.has(c)){let m=this.columns[wn[c]];l[c]=bn(u,p,m[o]*a,m[n]*a,r)}else l[c]=u+(p-u)*r}return l}derived(e,t){let s=this.cache.
get(e)??t(this.columns);return this.cache.set(e,s),s}};function bn(i,e,t,s,o){if(!Number.isFinite(t)||!Number.isFinite(s))return i+(e-i)*o;let n=1-o;return n*n*
(1+2*o)*i+o*o*(3-2*o)*e+o*n*(n*t-o*s)}var cs=i=>i-360*Math.floor(i/360);function yn(i,e){let t=Math.abs(cs(i-e+180)-180);return Math.round(100*y(1-(t-1)/89,0,1))}function vn(i,e){let t=Math.max(...e)-
Math.min(...e,0),s=e.reduce((o,n,a)=>o+Math.abs(n-i[a]),0)/e.length;return Math.round(100*y(1-2*s/(t||1),0,1))}var kn=0;function He(i,e,t=!1){let s=`hh-guess-${++kn}`,
o="",n=i.map(([a,r])=>{let l=h("input",{type:"radio",name:s,value:a,onchange:()=>{o=a,e()}});return{key:a,radio:l,row:h("label",{class:"guess-choice"},l,h("span",
{},r))}});return{element:h("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},n.map(({row:a})=>a)),made:()=>o!=="",judge:a=>{for(let{key:r,radio:l,
row:c}of n){l.disabled=!0;let d=t||r===a;d&&c.append(h("b",{class:"guess-right"},"✓")),c.classList.toggle("right",d)}return t||o===a?100:0}}}var ie=168,Oe=58,
ls=(i,e=Oe)=>{let t=i*Math.PI/180;return[ie/2+e*Math.sin(t),ie/2-e*Math.cos(t)]};function ds(i,e){let t=0,s=!1,o=null,n=h("canvas",{class:"dial-canvas"}),a=h("d\
iv",{class:"guess dial",role:"slider",tabindex:"0","aria-label":i,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},n),r=()=>{let{context:d}=I(n),u=getComputedStyle(
a),p=u.getPropertyValue("--ink").trim(),m=u.getPropertyValue("--soft").trim(),w=u.getPropertyValue("--accent").trim();d.clearRect(0,0,ie,ie),d.strokeStyle=m,d.fillStyle=
m,d.lineWidth=1.5,d.beginPath(),d.moveTo(8,ie/2+Oe),d.lineTo(ie-8,ie/2+Oe),d.stroke(),d.lineWidth=4,d.beginPath(),d.arc(ie/2,ie/2,Oe,0,2*Math.PI),d.stroke(),d.font=
"11px system-ui, sans-serif",d.textAlign="center";for(let g of[0,90,180,270]){let[f,x]=ls(g,Oe-17);d.fillText(`${g}°`,f,x+4)}let b=(g,f,x)=>{d.fillStyle=f,d.beginPath(),
d.arc(...ls(g),x,0,2*Math.PI),d.fill()};o!==null&&(d.strokeStyle=p,d.lineWidth=2,d.beginPath(),d.arc(...ls(o),12,0,2*Math.PI),d.stroke(),b(o,p,7)),b(t,s?w:m,9)},
l=d=>{o===null&&(t=cs(d),s=!0,a.setAttribute("aria-valuenow",String(Math.round(t))),a.setAttribute("aria-valuetext",`${Math.round(t)}°`),r(),e())},c=d=>{let u=n.
getBoundingClientRect(),[p,m]=[d.clientX-u.left-u.width/2,d.clientY-u.top-u.height/2];l(Math.atan2(p,-m)*180/Math.PI)};return a.addEventListener("pointerdown",d=>{
d.preventDefault(),a.focus({preventScroll:!0}),c(d),C(a,d,c)}),a.addEventListener("keydown",d=>{let u={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,
PageUp:45}[d.key];u!==void 0&&(d.preventDefault(),d.stopPropagation(),l(t+(d.shiftKey?u/5:u)))}),requestAnimationFrame(r),{element:a,redraw:r,made:()=>s,judge:d=>(o=
cs(d),r(),yn(t,o))}}var Be=9,[Z,pt,ue,hs]=[34,12,12,26];function Eo({label:i,unit:e,most:t},s){let o=Array(Be).fill(t/4),n=!1,a=null,r=h("canvas",{class:"sketch\
-canvas"}),l=o.map((f,x)=>h("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":`${i} with the load at ${45*x}°`,"aria-orientation":"vertical",
"aria-valuemin":"0","aria-valuemax":String(t),onkeydown:S=>{let E={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[S.key];E&&(S.preventDefault(),S.stopPropagation(),
w(x,o[x]+E*t/(S.shiftKey?100:20)))}})),c=h("div",{class:"guess sketch",role:"group","aria-label":"Draw the curve: pull the points up and down"},r,l),d=()=>r.getBoundingClientRect(),
u=f=>Z+f/(Be-1)*(d().width-Z-pt),p=f=>ue+(1-f/t)*(d().height-ue-hs),m=()=>{let{context:f,width:x,height:S}=I(r),E=getComputedStyle(c),R=A=>E.getPropertyValue(A).
trim();f.clearRect(0,0,x,S),f.strokeStyle=R("--line"),f.fillStyle=R("--soft"),f.font="11px system-ui, sans-serif";for(let A=0;A<Be;A+=2)f.textAlign="center",f.fillText(
`${45*A}°`,u(A),S-8),f.strokeRect(u(A),ue,0,S-ue-hs);for(let A of[0,t/2,t])f.textAlign="right",f.fillText(String(A),Z-6,p(A)+4),f.strokeRect(Z,p(A),x-Z-pt,0);f.
textAlign="left",f.fillText(e,Z+4,ue+10);let z=(A,Q,Si)=>{f.strokeStyle=Q,f.lineWidth=2.5,f.setLineDash(Si),f.beginPath(),A.forEach((Ns,Ws)=>{let qs=Z+Ws/(A.length-
1)*(x-Z-pt);Ws?f.lineTo(qs,p(y(Ns,0,t))):f.moveTo(qs,p(y(Ns,0,t)))}),f.stroke(),f.setLineDash([])};z(o,R("--accent"),[6,4]),a&&z(a,R("--ink"),[]),l.forEach((A,Q)=>{
A.style.transform=`translate(${u(Q)}px, ${p(o[Q])}px)`})},w=(f,x)=>{a||(o[f]=y(x,0,t),n=!0,l[f].setAttribute("aria-valuenow",o[f].toPrecision(3)),l[f].setAttribute(
"aria-valuetext",`${o[f].toPrecision(2)} ${e}`),m(),s())},b=null,g=f=>{let x=d(),S=y((f.clientX-x.left-Z)/(x.width-Z-pt),0,1),E=Math.round(S*(Be-1)),R=t*(1-(f.clientY-
x.top-ue)/(x.height-ue-hs)),z=b??E,A=o[z];for(let Q=Math.min(z,E);Q<=Math.max(z,E);Q++)w(Q,z===E?R:A+(R-A)*(Q-z)/(E-z));b=E};c.addEventListener("pointerdown",f=>{
f.preventDefault(),b=null,g(f),C(c,f,g)});for(let[f,x]of l.entries())x.setAttribute("aria-valuenow",o[f].toPrecision(3));return requestAnimationFrame(m),{element:c,
redraw:m,made:()=>n,judge:f=>{a=f,m();let x=(f.length-1)/(Be-1);return vn(o,o.map((S,E)=>f[Math.round(E*x)]))}}}var ft=2*Math.PI,B=(i,e)=>i.events.find(t=>t.kind===e),mt=i=>P(i-ft*Math.floor(i/ft));function xn(i,e,t=72){let{angle:s}=i.columns,o=i.columns[e],n=[],a=0;for(let r=0;r<=
t;r++){let l=i.columns.angle[0]+ft*r/t;for(;a+1<i.length&&s[a+1]<l;)a+=1;let c=Math.min(a+1,i.length-1),d=s[c]>s[a]?Math.min((l-s[a])/(s[c]-s[a]),1):0;n.push(o[a]+
d*(o[c]-o[a]))}return n}var Tn=(i,e)=>i.t[i.columns.angle.findIndex(t=>t>=e)]??i.duration,Sn={R:"roll",S:"spin",K:"skid",H:"bounce"},pe=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:i=>He(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],i),until:([i])=>{
let[e,t]=[B(i,"skim"),B(i,"impact")];return e?e.t+.7*((t?.t??i.duration)-e.t):i.duration},answer:([i])=>{let e=B(i,"skim")??B(i,"takeoff");return{truth:e?.kind===
"skim"?"skim":e?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:mt(e?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:i=>Eo({label:"Speed of the centre",unit:"m/s",most:10},
i),until:([i])=>Tn(i,ft),answer:([i])=>{let e=xn(i,"vx");return{truth:e,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:T(Math.max(
...e),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:i=>ds("Angle of the load where it begins to slip",i),until:([i])=>(B(i,"slip_start")?.t??0)+.02,answer:([i])=>{let e=B(i,"slip_start"),t=i.at(e.t).normal_force/
(i.mass*i.gravity);return{truth:e.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:mt(e.
angle),share:`${T(100*t,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:i=>ds("Angle of the load\
 where it takes off",i),until:([i])=>(B(i,"takeoff")?.t??0)+.12,answer:([i])=>{let e=B(i,"takeoff"),t=i.at(e.t-1e-6);return{truth:e.angle*180/Math.PI,text:"It t\
akes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:mt(e.angle),slip:T(Math.abs(t.slip),3)}}},why:"A rolling hoop would be braked by the plan\
e while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the \
top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does it d\
o just after it has landed?",queries:[""],guess:i=>He([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim turns \
too fast."],["bounce","It bounces."]],i),until:([i])=>(B(i,"impact")?.t??i.duration)+.15,answer:([i])=>{let[e,t]=[B(i,"takeoff"),B(i,"impact")],s=i.events.find(
o=>o.kind==="apex");return{truth:Sn[i.at((t?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
values:{time:T((t?.t??0)-(e?.t??0),3),height:T(100*(s?.height??0),3),angle:mt(t?.angle??0)}}},why:"An impact takes no time, but its friction is as strong as its\
 push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",title:"\
More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highest?",queries:[
"plane.mu=0.05","plane.mu=0.2",""],guess:i=>He([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],i),until:i=>.3+Math.max(0,...i.map(e=>B(e,"impact")?.t??0)),
answer:i=>{let e=i.map(n=>Math.max(0,...n.events.map(({kind:a,height:r})=>a==="apex"?r:0))),[t,s,o]=e.map(n=>T(100*n,3));return{truth:String(e.indexOf(Math.max(
...e))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:t,middle:s,high:o}}},why:"On ice nothing drives the ro\
tation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the\
 way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies w\
ith dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plan\
e.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:i=>He([["flight","It flies off."],["impact","An impact stops the sli\
de at once."],["both","Both agree with the laws."]],i),until:i=>Math.min(.8,...i.map(e=>e.duration)),answer:i=>({truth:i.every(e=>B(e,"painleve_indeterminate"))?
"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws have two an\
swers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"Your tur\
n",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from\
 the motion itself.",question:"",queries:[""]}];var Ao="hophoop-visit",gt=class{step=null;guess=null;films=[];points=new Map;play;next;stop=null;loop=null;asked=0;constructor(e,t){this.lab=e,this.onchallenges=
t,this.body=h("div",{class:"visit-body"}),this.said=h("div",{class:"visit-answer",role:"status"}),this.element=h("section",{class:"visit card","aria-label":"Gui\
ded visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){V(Ao)||(this.element.hidden=!1,M(this.said,""),this.
body.replaceChildren(h("div",{class:"buttons offer"},h("p",{},h("b",{},"New here?")," ","Eight short questions: guess, then play."),h("button",{type:"button",class:"\
main",onclick:()=>this.start()},"Start the visit"),h("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){this.points.clear(),this.go(0)}leave(){
Y(Ao,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.root.classList.remove("visiting"),this.veil(),this.
lab.show()}async go(e){let t=pe[e],s=++this.asked,{lab:o}=this;o.clock.play(!1),o.clock.time=0,this.step=t,this.stop=null,this.guess=null,this.unwind(),M(this.said,
""),this.element.hidden=!1,o.root.classList.toggle("visiting",e<pe.length-1);try{let n=await Promise.all(t.queries.map(a=>o.backend.call("film",{query:a})));if(s!==
this.asked)return;this.films=n.map(a=>new he(a)),o.motions.active=0,o.motions.set(n.slice(0,2)),this.guess=t.guess?.(()=>this.guessed())??null,this.veil(),o.changed(),
o.motions.note(),this.fill(e)}catch(n){o.notice.fail(n)}}veil(){this.lab.root.classList.toggle("guessing",this.guessing),this.guessing&&this.lab.stage.element.setAttribute(
"aria-label",k("The hoop, before it is let go."))}fill(e){let t=pe[e];this.play=h("button",{type:"button",class:"main",disabled:!!this.guess,onclick:()=>this.show()},
"Play");let s=e===pe.length-1,o=h("h2",{tabindex:"-1"},t.title);this.next=h("button",{type:"button",onclick:()=>this.go(e+1)},"Next"),this.body.replaceChildren(
h("header",{},h("span",{class:"visit-count"},`Step ${e+1} of ${pe.length}`),h("progress",{max:String(pe.length),value:String(e+1),"aria-hidden":"true"}),h("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),o,h("p",{},t.text),t.question?h("p",{class:"visit-question"},t.
question):"",this.guess?.element??"",h("div",{class:"buttons"},e>0&&h("button",{type:"button",onclick:()=>this.go(e-1)},"Back"),this.guess&&this.play,s?h("butto\
n",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,s&&h("button",{type:"button",onclick:()=>this.leave()},"Done"),this.guess&&
h("span",{class:"hint visit-wait"},"First say what you expect, then play."))),s&&this.points.size&&this.total(),o.focus({preventScroll:!0})}guessed(){this.play&&
(this.play.disabled=!1);let e=this.body.querySelector(".visit-wait");e&&(e.hidden=!0)}show(){let{lab:e,step:t}=this;!t||!this.guess||(this.play.disabled=!0,this.
stop=t.until?.(e.films())??e.clock.duration,this.loop??=e.clock.loop,e.clock.loop=!1,e.clock.seek(0),matchMedia("(prefers-reduced-motion: reduce)").matches?e.clock.
seek(this.stop):e.clock.play(!0),this.frame())}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:e}=this.lab;if(this.stop===
null||e.playing&&e.time<this.stop||!(e.time>=this.stop-1e-9||!e.playing))return;e.playing=!1;let s=this.stop;this.stop=null,this.unwind(),e.seek(s),this.judge()}judge(){
let{step:e,guess:t}=this;if(!e?.answer||!t)return;let{truth:s,text:o,values:n={}}=e.answer(this.films),a=t.judge(s);this.points.set(e.key,a),this.said.replaceChildren(
h("p",{},h("b",{},`${a} of 100 points.`)," ",Ys(o,n)),h("p",{},e.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.scrollIntoView(
{block:"nearest"})}total(){let e=[...this.points.values()].reduce((t,s)=>t+s,0);this.said.replaceChildren(h("p",{},`You have ${e} of ${100*this.points.size} poi\
nts.`))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&this.veil()}};var wt=class{words={t:k,untranslated:Ne};constructor(e){this.lab=e,this.grips=new ht(e),this.sound=new dt,this.present=new ct(e),this.challenges=new at(e),this.
visit=new gt(e,()=>this.challenges.open()),this.table=new ut(e),this.teach=So(t=>this.challenges.load(t),()=>this.visit.start()),this.layOut(),this.spoken()}layOut(){
let{lab:e}=this,t=e.stage.element.parentElement,s=e.root.querySelector(".side");s?s.prepend(this.visit.element,this.challenges.element):t.before(this.visit.element,
this.challenges.element),t.after(this.table.element),e.root.append(this.teach),e.transport.element.querySelector(".switches")?.before(this.tools()),e.header.element.
querySelector(".right")?.prepend(this.menu(),this.languages()),e.hosted&&!location.search&&!location.hash&&this.visit.offer()}tools(){let{clock:e}=this.lab,t=(s,o,n)=>h(
"button",{type:"button",title:o,"aria-label":o,"aria-pressed":"false",onclick:n},N(s));return this.loop=t("loop","Repeat",()=>{e.loop=!e.loop,this.mark()}),this.
slow=t("slow","Slow motion: a tenth of the speed",()=>{e.speed=e.speed===.1?1:.1,e.changed(),this.mark()}),this.loud=t("sound","Sound of the contact",()=>{this.
sound.turn(!this.sound.on),this.mark()}),this.large=t("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),
this.mark(),h("div",{class:"buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:e}=this.lab;this.loop?.setAttribute("aria-pressed",String(
e.loop)),this.slow?.setAttribute("aria-pressed",String(e.speed===.1)),this.loud?.setAttribute("aria-pressed",String(this.sound.on)),this.large?.setAttribute("ar\
ia-pressed",String(this.present.on))}menu(){let e=(s,o)=>h("button",{type:"button",onclick:()=>{t.open=!1,o()}},s),t=h("details",{class:"learn"},h("summary",{class:"\
button"},"Learn"),h("div",{class:"menu-body"},e("Guided visit",()=>this.visit.start()),e("Challenges",()=>this.challenges.open()),e("Table of the motion",()=>this.
table.open(!0)),e("Presentation",()=>this.present.turn(!0)),e("For teachers",()=>this.teach.showModal())));return this.lab.root.addEventListener("pointerdown",s=>{
t.contains(s.target)||(t.open=!1)}),t.addEventListener("keydown",s=>{s.key!=="Escape"||!t.open||(s.stopPropagation(),t.open=!1,t.querySelector("summary")?.focus())}),
t}languages(){let e=h("select",{class:"language","aria-label":"Language",onchange:()=>{Vs(e.value),Yt(e.value),this.spoken(),Qs(this.lab.root),this.lab.show()}},
Object.entries(Ce).map(([t,s])=>h("option",{value:t,lang:t},document.createTextNode(s))));return e.value=Qe(),e}spoken(){this.lab.root.lang=Qe(),this.lab.hosted&&
(document.documentElement.lang=Qe())}frame(){let{lab:e}=this;this.grips.draw(),this.sound.follow(e.film(),e.clock),this.table.cursor(e.clock.time),this.visit.frame(),
this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.challenges.changed(),this.visit.changed()}close(){this.sound.close(),this.present.
close()}};var $e=(i,e,t)=>h("button",{type:"button",title:e,"aria-label":e,onclick:t},i),bt=class{constructor(e,t,s){let o=new Map;for(let a of e)o.set(a.group,[...o.get(
a.group)??[],a]);this.fresh=!1,this.presets=h("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let a=e.find(({key:r})=>r===this.presets.
value);this.fresh=a!==void 0,a&&s.take(a)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},h("option",{value:""},"Motions to start from …"),[...o].
map(([a,r])=>h("optgroup",{label:a},r.map(({key:l,title:c})=>h("option",{value:l},c))))),this.undo=$e(N("undo"),"Undo (z)",s.undo),this.redo=$e(N("redo"),"Redo \
(y)",s.redo);let n=h("span",{},h("span",{class:"long"},"Compare"),h("span",{class:"short"},N("two")));this.compare=$e(n,"Compare two hoops",s.compare),this.element=
h("header",{class:"top"},h("h1",{},h("span",{class:"logo","aria-hidden":"true"}),h("span",{},"hophoop",h("span",{class:"long"}," lab"))),this.presets,h("div",{class:"\
buttons"},this.undo,this.redo,this.compare),h("div",{class:"buttons right"},t,$e(N("theme"),"Dark or light (d)",s.theme),$e("?","Keys and help (?)",s.help)))}show(e,t){
this.undo.disabled=!e.past.length,this.redo.disabled=!e.future.length,this.compare.setAttribute("aria-pressed",String(t))}};var Mn=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["Esc","leave a field, a menu, a picture \
that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],En=[["R","roll","the rim does not slide"],["S","spin","slip: the rim tur\
ns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],["H","\
flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],An=[["▲ ▼","take-off, landing"],["•","highest point"],
["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy out of nothing"],["≋","bounces without numbe\
r end"],["◗ ■","skimming begins, rest"]],us=(i,e,t=()=>!1)=>h("table",{},h("caption",{},i),e.map(([s,...o])=>h("tr",{},h("th",{scope:"row"},t(s),s),o.map(n=>h(
"td",{},n)))));function zo(i,e,t){let s=h("dialog",{class:"help","aria-label":"Keys and help"},h("h2",{},"The hoop"),h("p",{},"A ring with a load on its rim rol\
ls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide\
. Move a slider and see."),us("Modes",En,o=>h("i",{class:"dot",style:`background:${e.modes[o]}`})),us("Marks on the bar of time",An),us("Keys",Mn),t,h("p",{class:"\
hint"},`hophoop ${i}`),h("button",{type:"button",class:"close",onclick:()=>s.close()},"Close"));return s}var yt=class{constructor(e){this.tabs=["A","B"].map((t,s)=>h("button",{type:"button","aria-pressed":"false",onclick:()=>e(s)},`Hoop ${t}`)),this.bar=h("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=h("p",{class:"preset-text"}),this.element=h("div",{class:"lanes"},
this.bar,this.text)}show(e,t){this.bar.hidden=e<2;for(let[s,o]of this.tabs.entries())o.setAttribute("aria-pressed",String(s===t))}};var Ro="hophoop-single-keys",zn=(i,e)=>({" ":()=>i.clock.play(),ArrowLeft:()=>e?i.transport.jump(-1):i.transport.nudge(-1),ArrowRight:()=>e?i.transport.jump(1):
i.transport.nudge(1),Home:()=>i.clock.seek(0),End:()=>i.clock.seek(i.clock.duration),h:()=>i.transport.jump(1,"takeoff"),l:()=>i.transport.jump(1,"impact"),"[":()=>i.
clock.faster(-1),"]":()=>i.clock.faster(1),t:()=>i.toggle("traces"),f:()=>i.toggle("forces"),c:()=>i.toggle("speed"),w:()=>i.toggle("whole"),3:()=>i.toggle("thr\
ee"),"+":()=>i.stage.zoom(1.25),"=":()=>i.stage.zoom(1.25),"-":()=>i.stage.zoom(.8),0:()=>i.stage.zoom(0),z:()=>i.travel(-1),y:()=>i.travel(1),d:()=>i.theme.toggle(),
p:()=>i.share.code(),"?":()=>i.help.showModal()});function Rn(i,e){let t=e.key.toLowerCase();e.altKey||!(t==="z"||t==="y")||(e.preventDefault(),i.travel(t==="y"||
e.shiftKey?1:-1))}function Pn(i){let e=i.share.menu;e.open&&(e.open=!1,e.querySelector("summary")?.focus())}var vt=class{constructor(e){this.on=!e||V(Ro)!=="off";
let t=h("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=t.checked,e&&Y(Ro,this.on?"on":"off")}});this.element=h("label",{class:"check"},t,"Single\
 keys (letters, digits, signs) do what the table says")}};function Ln(i,e){let t=e.target;if(i.root.querySelector("dialog[open]"))return;if(e.key==="Escape"){Pn(
i);return}if(t.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(e.ctrlKey||e.metaKey){Rn(i,e);return}if(e.altKey||t.matches?.("select")&&
!(e.key===" "&&i.header.fresh)||t.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(e.key)||e.key===" "&&t.matches?.("button, summary, input[type=ch\
eckbox]")||!i.singleKeys.on&&e.key!==" "&&e.key.length===1)return;let o=zn(i,e.shiftKey)[e.key];o&&(e.preventDefault(),o())}function Po(i,e){let t=e?document:i.
root,s=o=>{Ln(i,o),e||o.stopPropagation()};return t.addEventListener("keydown",s),()=>t.removeEventListener("keydown",s)}var In={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function ke(i){let e=i instanceof DataView||ArrayBuffer.isView(i)?i:new DataView(i),t=new Uint8Array(e.buffer,
e.byteOffset,e.byteLength);t.byteOffset%8&&(t=t.slice());let s=new DataView(t.buffer,t.byteOffset).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(t.subarray(
4,4+s))),n={};for(let{name:a,type:r,shape:l,place:c}of o.arrays){let d=l.reduce((u,p)=>u*p,1);n[a]=new In[r](t.buffer,t.byteOffset+4+s+c,d)}return{header:o,arrays:n}}var Ue=class extends Error{},_n=500,Cn=4,Nn="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";async function Lo(i,e,t){
for(;;)try{return await i()}catch(s){if(!(s instanceof Ue))throw s;e(s.message),await new Promise(o=>setTimeout(o,_n)),t.throwIfAborted()}}var kt=class{constructor(e){
this.base=e,this.shares=!0}async call(e,t,s){let o={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(t),signal:s},n=await this.answered(
new URL(`lab/${e}`,this.base),o);if(n.status===202)throw new Ue((await n.json()).detail);return ke(await n.arrayBuffer())}async answered(e,t){for(let s=Cn;;s--){
let o=await fetch(e,t).catch(a=>{throw a.name==="AbortError"?a:new Error(Nn)});if(o.ok)return o;let n=Number(o.headers.get("Retry-After"));if(o.status!==503||!(n>
0)||s<=1){let a=await o.json().catch(()=>({}));throw new Error(a.detail??`The server answered ${o.status}.`)}await new Promise(a=>setTimeout(a,1e3*Math.min(n,10))),
t?.signal?.throwIfAborted()}}async file(e,t){return(await this.answered(new URL(`api/v1/files/${e}?${t}`,this.base))).blob()}link(e,t){return`${new URL(e?`?${e}`:
"",this.base)}${t}`}},Wn=2e4,qn=3e5,xt=class{constructor(e){this.model=e,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).
slice(2),this.listen=(t,s)=>this.answered(t,s),e.on("msg:custom",this.listen)}answered(e,t){let s=e?.view===this.view&&this.waiting.get(e.number);s&&(clearTimeout(
s.timer),this.waiting.delete(e.number),e.compiling?s.reject(new Ue(e.compiling)):e.error?s.reject(new Error(e.error)):s.resolve(ke(t[0])))}call(e,t,s){let o=++this.
number;return new Promise((n,a)=>{let r=setTimeout(()=>{this.waiting.delete(o),a(new Error("The notebook’s kernel does not answer; run the cell again."))},e===
"file"?qn:Wn);this.waiting.set(o,{resolve:n,reject:a,timer:r}),s?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(o),a(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:o,call:e,body:t})})}async file(e,t){let{arrays:s}=await this.call("file",{query:t,name:e});return new Blob(
[s.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};var[Io,Dn]=[62,92],Fn=12,me=10,jn=36,_o=Math.PI/180,X=["x","y"],Tt=class{box;constructor(e){this.known=new Map(e.map(t=>[t.path,t])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=Io}info(e){return this.known.get(this.paths[e])}whole(e){return[...this.info(e).range]}home(){
for(let e of X)this.windows[e]=this.whole(e)}choose(e,t){let s=e==="x"?"y":"x";this.paths[s]===t&&(this.paths[s]=this.paths[e]),this.paths[e]=t,this.home()}asked(e,t){
let[s,o]=this.windows[e];return{path:this.paths[e],from:s,to:o,cells:t}}bounds(e){let{range:t,allowed:s}=this.info(e),o=2*(t[1]-t[0]);return[Math.max(s[0],t[0]-
o),Math.min(s[1],t[1]+o)]}zoom(e,t){let s={x:[],y:[]};for(let o of X){let[n,a]=this.windows[o],r=t?.[o]??.5*(n+a);s[o]=fe([r-(r-n)*e,r+(a-r)*e],this.bounds(o));
let l=Math.max(Math.abs(s[o][0]),Math.abs(s[o][1]),1e-9);if(s[o][1]-s[o][0]<400*Number.EPSILON*l)return!1}return X.every(o=>s[o].every((n,a)=>n===this.windows[o][a]))?
!1:(this.windows=s,!0)}drag(e,t,s){let o=(n,a)=>fe(e[n].map(r=>r+a*(e[n][1]-e[n][0])),this.bounds(n));this.windows={x:o("x",-t/this.box.width),y:o("y",s/this.box.
height)}}restore(e){if(!X.every(t=>this.known.has(e[t][0]))||e.x[0]===e.y[0])return!1;for(let t of X)this.paths[t]=e[t][0];for(let t of X)this.windows[t]=fe(e[t].
slice(1).map(Number),this.bounds(t));return!0}isHome(){return X.every(e=>this.windows[e].every((t,s)=>t===this.whole(e)[s]))}middle(){let{x:e,y:t}=this.windows;
return{x:.5*(e[0]+e[1]),y:.5*(t[0]+t[1])}}fit(e,t){this.left=this.deep("y")?Dn:Io,this.box={width:e-this.left-Fn,height:t-me-jn}}clip(e){e.beginPath(),e.rect(this.
left,me,this.box.width,this.box.height),e.clip()}x(e){let[t,s]=this.windows.x;return this.left+(e-t)/(s-t)*this.box.width}y(e){let[t,s]=this.windows.y;return me+
(1-(e-t)/(s-t))*this.box.height}place(e,t){let s=([o,n],a)=>o+y(a,0,1)*(n-o);return{x:s(this.windows.x,(e-this.left)/this.box.width),y:s(this.windows.y,1-(t-me)/
this.box.height)}}deep(e){let[t,s]=this.windows[e];return s-t<5e-5*Math.max(Math.abs(t),Math.abs(s))}said(e){let t=s=>{let o=this.info(s),[n,a]=this.windows[s],
r=Math.max(Math.abs(n),Math.abs(a)),l=y(Math.ceil(Math.log10(r/(a-n)))+4,4,16);return`${k(o.label)} = ${_(T(o.degrees?e[s]/_o:e[s],l),o.unit)}`};return`${t("x")}\
, ${t("y")}`}draw(e,t,s){e.strokeStyle=s.soft,e.fillStyle=s.soft,e.lineWidth=1,e.strokeRect(this.left+.5,me+.5,this.box.width-1,this.box.height-1),e.font=`11px ${s.
font}`;for(let o of X){let n=this.info(o),a=n.degrees?1/_o:1,[r,l]=this.windows[o].map(g=>g*a),c=o==="x"?this.box.width/80:this.box.height/40,d=F(l-r,c),u=this.
deep(o),p=u?Number((.5*(r+l)).toPrecision(12)):0,m=u?U(r-p,l-p,c).map(g=>g+p):U(r,l,c);for(let g of m){let f=u?T(g-p,3):O(g,d);o==="x"?(e.textAlign="center",e.fillText(
f,this.x(g/a),me+this.box.height+14)):(e.textAlign="right",e.textBaseline="middle",e.fillText(f,this.left-5,this.y(g/a)),e.textBaseline="alphabetic")}let w=u?` \
− ${String(p).replace("-","−")}`:"",b=`${k(n.label)}${w}${n.unit?` [${n.unit}]`:""}`;e.save(),e.textAlign="center",o==="x"?e.translate(this.left+.5*this.box.
width,t-5):(e.translate(12,me+.5*this.box.height),e.rotate(-Math.PI/2)),e.fillText(b,0,0),e.restore()}}};function fe([i,e],[t,s]){let o=Math.min(e-i,s-t);return i<
t?[t,t+o]:e>s?[s-o,s]:[i,e]}function ps(i,e,t,s,o){for(let[n,a]of[[o,4],[s,1.8]])i.strokeStyle=n,i.lineWidth=a,i.beginPath(),i.arc(e,t,7,0,2*Math.PI),i.moveTo(e-
13,t),i.lineTo(e-4,t),i.moveTo(e+4,t),i.lineTo(e+13,t),i.moveTo(e,t-13),i.lineTo(e,t-4),i.moveTo(e,t+4),i.lineTo(e,t+13),i.stroke()}var xe=i=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${i&&`; ${i}`}; double-click for all`,Bn=.0018,Co=200,
[On,Hn]=[1/.6,1/1.7];function H(i,{zoom:e,home:t,chosen:s=()=>i,keys:o=!1}){return i.addEventListener("wheel",n=>{(n.ctrlKey||n.metaKey||et(s()))&&(n.preventDefault(),
e(Math.exp(-Math.min(Math.max(n.deltaY,-Co),Co)*Bn),n))},{passive:!1}),i.addEventListener("dblclick",t),o&&i.addEventListener("keydown",n=>{if(n.key==="+"||n.key===
"=")e(On);else if(n.key==="-")e(Hn);else if(n.key==="0")t();else if(n.key==="Escape")i.blur();else return;n.preventDefault(),n.stopPropagation()}),go(i,e)}var No={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},Wo=48;function qo(i){let{body:e}=i,t=!1,s=H(e,{zoom:(o,n)=>i.axes.box&&i.zoom(1/o,n?ms(
i,n):i.pointed??void 0),home:()=>i.home(),keys:!0});e.addEventListener("pointerdown",o=>Un(i,o,s,n=>t=n)),e.addEventListener("pointermove",o=>{i.axes.box&&!t&&o.
pointerType!=="touch"&&$n(i,o)}),e.addEventListener("pointerleave",()=>i.tip.hidden=!0),e.addEventListener("keydown",o=>Kn(i,o))}function ms(i,e){let t=i.body.getBoundingClientRect();
return i.axes.place(e.clientX-t.left,e.clientY-t.top)}function $n(i,e){i.tip.textContent=i.said(ms(i,e)),i.tip.hidden=!1;let t=i.body.getBoundingClientRect();i.
tip.style.left=`${y(e.clientX-t.left,150,Math.max(t.width-150,150))}px`,i.tip.style.bottom=`${t.bottom-e.clientY+16}px`}function Un(i,e,t,s){e.preventDefault(),
i.body.focus({preventScroll:!0});let o=[e.clientX,e.clientY],n={x:[...i.axes.windows.x],y:[...i.axes.windows.y]};i.pointed=ms(i,e);let a=!1,r=t(),l=c=>{if(r||=t(),
r)return;let[d,u]=[c.clientX-o[0],c.clientY-o[1]];Math.hypot(d,u)<5&&!a||(a=!0,s(!0),i.tip.hidden=!0,i.axes.drag(n,d,u),i.redraw(),i.soon())};C(i.body,e,l,(c,d)=>{
d&&!a&&!r&&i.pointed&&i.take(i.pointed),s(!1)})}function Kn(i,e){let t=i.pointed??i.here()??i.axes.middle();if(i.pointed=t,No[e.key]){let[s,o]=No[e.key],{x:n,y:a}=i.
axes.windows;i.pointed={x:y(t.x+s*(n[1]-n[0])/Wo,n[0],n[1]),y:y(t.y+o*(a[1]-a[0])/Wo,a[0],a[1])},i.state.textContent=i.said(i.pointed),i.say(i.said(i.pointed))}else if(e.
key==="Enter")i.take(t);else return;e.preventDefault(),e.stopPropagation(),i.redraw()}var Gn=["start.height","start.vx","start.vy","start.omega"];function Do(i,e){let t="speed"in i.start;return!t&&e.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":t&&e.some(s=>Gn.includes(s))?"of starts in any state, though this motion starts rolling":""}var Vn=Math.PI/180,Yn=12,Jn=["hop_height","flight_time","energy_lost","greatest_utilization"];function Fo(i){return i.unit==="rad"?[1/Vn,"°"]:[1,i.unit==="1"?"":
i.unit]}function Zn({classes:i,what:e},t){let[s,o]=[1/0,-1/0];if(i)return[s,o];for(let n of t)n<s&&(s=n),n>o&&(o=n);return[Jn.includes(e)?Math.min(s,0):s,o]}function jo(i){
let{values:e}=i.arrays,t=i.header,{x:s,y:o,classes:n}=t,a=new ImageData(s.cells,o.cells),[r,l]=Zn(t,e),c=n?.map(({color:u})=>ee(u));for(let u=0;u<o.cells;u++)for(let p=0;p<
s.cells;p++){let m=e[u*s.cells+p],w=4*((o.cells-1-u)*s.cells+p);if(!Number.isFinite(m))continue;let b=c&&(p+1<s.cells&&e[u*s.cells+p+1]!==m||u+1<o.cells&&e[(u+1)*
s.cells+p]!==m),g=c?c[m].map(f=>b?.72*f:f):be[y(Math.round(255*(m-r)/(l-r||1)),0,255)];a.data.set([...g,255],w)}let d=h("canvas",{width:s.cells,height:o.cells});
return oe(d).putImageData(a,0,0),{picture:d,header:t,values:e,x:[s.from,s.to],y:[o.from,o.to],low:r,high:l}}function Bo(i,e){let t=(o,n)=>o[0]>=n[0]-1e-300&&o[1]<=
n[1]+1e-300;return[...i.filter(o=>!(t(o.x,e.x)&&t(o.y,e.y))),e].slice(-Yn)}function Oo({header:i,low:e,high:t,values:s}){let{classes:o}=i;if(!o){let r=h("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=oe(r);for(let u=0;u<120;u++)l.fillStyle=`rgb(${be[Math.floor(255*u/119)].join(",")})`,l.fillRect(u,0,1,
10);let[c,d]=Fo(i);return[h("span",{},i.label,": ",t>=e?T(e*c,3):"none"," "),r,h("span",{},t>=e?_(T(t*c,3),d):""),s.some(u=>!Number.isFinite(u))?h("span",{},h("\
i",{class:"blank"}),"none"):""]}let n=new Map;for(let r of s)n.set(r,(n.get(r)??0)+1);let a=[...n].filter(([r])=>r>=0).sort((r,l)=>l[1]-r[1]);return[...a.slice(
0,10).map(([r])=>{let{color:l,text:c}=o[r];return h("span",{},h("i",{style:`background:${l}`,"aria-hidden":"true"}),c)}),a.length>10?h("span",{},`and ${a.length-
10} more`):""]}function Ho(i,e){for(let{header:t,values:s}of[...i].reverse()){let{x:o,y:n,classes:a}=t,r=Math.floor((e.x-o.from)/(o.to-o.from)*o.cells),l=Math.floor(
(e.y-n.from)/(n.to-n.from)*n.cells);if(r<0||l<0||r>=o.cells||l>=n.cells)continue;let c=s[l*o.cells+r];if(a)return k(a[c]?.text??"not allowed");let[d,u]=Fo(t);return Number.
isFinite(c)?_(T(c*d,4),u):k("none")}return"…"}var $o=[[24,16],[72,48],[216,144]],St=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(e,t,{take:s,say:o,changed:n}){this.backend=
e,this.onmotion=s,this.say=o,this.changed=n;let a=t.controls.map_axes;this.axes=new Tt(a),this.what="sequence",this.layers=[],this.canvas=h("canvas",{class:"plo\
t-canvas"}),this.tip=h("div",{class:"tip",hidden:!0}),this.body=h("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow ke\
ys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=h("div",{class:"map-keys"}),this.state=h("span",{class:"hint"});
let r=l=>{let c=h("select",{"data-axis":l,onchange:()=>this.setAxis(l,c.value)},a.map(({path:d,label:u})=>h("option",{value:d},u)));return c};this.selects={x:r(
"x"),y:r("y")},this.quantity=h("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},t.map_quantities.map(([l,
c])=>h("option",{value:l},c))),this.element=h("section",{class:"map","aria-label":"Map of motions"},h("div",{class:"map-head"},h("h2",{},"Map"),h("label",{},"of",
this.quantity),h("label",{},"Across",this.selects.x),h("label",{},"Up",this.selects.y),h("span",{class:"buttons"},h("button",{type:"button","aria-label":"Zoom i\
nto the map",onclick:()=>this.zoom(.5)},"+"),h("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),h("button",{type:"but\
ton",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,h("p",{class:"hint"},`Click to take that motion into the player; ${xe("drag to move")}\
.`)),qo(this),this.soon=J(()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.
refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let e of X)this.selects[e].value=
this.axes.paths[e]}setAxis(e,t){this.axes.choose(e,t),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(e){let t=structuredClone(e);
for(let s of Object.values(this.axes.paths)){let[o,n]=s.split(".");t[o]&&delete t[o][n]}return JSON.stringify(t)}mark(e,t){this.film=e,this.look=t;let s=this.key_of(
e.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){let{paths:e,windows:t}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&
e.x==="start.speed"&&e.y==="plane.mu")return;let s=o=>[e[o],...t[o]];return{what:this.what,x:s("x"),y:s("y")}}restore(e){![...this.quantity.options].some(({value:t})=>t===
e.what)||!this.axes.restore(e)||(this.quantity.value=this.what=e.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked,t=this.film.scenario,s=t.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let o=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;o!==this.kind&&(this.layers=[]),this.
kind=o,this.redraw();try{for(let[n,a]of $o){M(this.state,`computing ${n*a} motions …`);let r={x:this.axes.asked("x",n),y:this.axes.asked("y",a)},l={scenario:t,
changes:s,...r,what:this.what},c=await Lo(()=>this.backend.call("map",l,e),m=>{M(this.state,m)},e),d=jo(c);this.layers=Bo(this.layers,d),this.keys.replaceChildren(
...Oo(d));let u=Do(t,Object.values(this.axes.paths)),p=k(s.length?"{count} motions, with rigid contact":"{count} motions",{count:n*a});M(this.state,u?`${p}; ${k(
u)}`:p),this.redraw()}this.level=$o.length}catch(n){let{name:a,message:r}=n;if(a==="AbortError")return;M(this.state,r)}this.computing=!1}redraw(){if(!this.film)
return;let{look:e}=this,{context:t,width:s,height:o}=I(this.canvas);this.axes.fit(s,o),t.clearRect(0,0,s,o),t.save(),this.axes.clip(t),t.imageSmoothingEnabled=!1;
let{axes:n}=this;for(let r of this.layers){let[l,c]=r.x.map(p=>n.x(p)),[d,u]=r.y.map(p=>n.y(p));t.drawImage(r.picture,l,u,c-l,d-u)}let a=this.here();a&&ps(t,n.x(
a.x),n.y(a.y),e.ink,e.paper),this.pointed&&et(this.body)&&ps(t,n.x(this.pointed.x),n.y(this.pointed.y),"#D55E00",e.paper),t.restore(),n.draw(t,o,e)}here(){let e=s=>{
let[o,n]=s.split(".");return this.film.values[s]??this.film.scenario[o]?.[n]},t={x:e(this.axes.paths.x),y:e(this.axes.paths.y)};return typeof t.x=="number"&&typeof t.
y=="number"?t:null}said(e){return`${this.axes.said(e)}: ${Ho(this.layers,e)}`}take(e){this.onmotion([[this.axes.paths.x,e.x],[this.axes.paths.y,e.y]])}zoom(e,t){
this.tip.hidden=!0,this.axes.zoom(e,t)&&(this.redraw(),this.soon())}};var Mt=class{constructor(){this.past=[],this.future=[],this.now=null,this.what="",this.when=-1/0}note(e,t="",s=performance.now()){let o=this.now;if(this.now=e,o===
null||fs(o,e))return"same";let n=t!==""&&t===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=t,this.when=s,this.future=[],n?"again":(this.past.push(
o),this.past.length>500&&this.past.shift(),"step")}next(e){return(e<0?this.past:this.future).at(-1)??null}step(e){let[t,s]=e<0?[this.past,this.future]:[this.future,
this.past],o=t.pop();!o||!this.now||(s.push(this.now),this.now=o,this.what="")}arrive(e){if(!(this.now&&fs(this.now,e))){for(let t of[-1,1]){let s=t<0?this.past:
this.future,o=s.length-s.findLastIndex(n=>fs(n,e));if(!(o>s.length)){for(let n=0;n<o;n++)this.step(t);return}}Object.assign(this,{past:[],future:[],now:e,what:""})}}},
fs=(i,e)=>JSON.stringify(i)===JSON.stringify(e);var Et=class{constructor(e,t){this.backend=e,this.listener=t,this.history=new Mt,this.lanes=[],this.active=0,this.going=Promise.resolve()}film(e=this.active){return this.
lanes[e].film}films(){return this.lanes.map(e=>e.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([e])=>e))}name(){return this.lanes.length>
1?"AB"[this.active]:""}set(e){this.lanes=e.map(t=>({film:new he(t)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(e){this.set(await Promise.
all(e.map(t=>this.backend.call("film",{query:t}))))}change(e,t){let s=this.lanes[this.active];s.since??=performance.now(),s.pending=[...(s.pending??[]).filter(([
o])=>!e.some(([n])=>n===o)),...e],s.commit||=t,s.what=e.map(([o])=>o).join(),this.pump(s)}async pump(e){if(e.busy||!this.lanes.includes(e))return;if(!e.pending){
e.commit&&this.settle(e);return}let t=e.pending,{since:s}=e;e.pending=null,e.since=null,e.busy=!0;try{e.film=new he(await this.backend.call("film",{scenario:e.film.
scenario,changes:t})),this.lanes.includes(e)&&this.listener.shown(s)}catch(o){this.lanes.includes(e)&&this.listener.failed(o,t)}finally{e.busy=!1}this.pump(e)}refine(e,t){
for(let s of this.lanes){let{film:o}=s,n=s.refining||s.coarse===o?null:o.wanted(e,t);n&&(s.refining=!0,this.backend.call("samples",{scenario:o.scenario,window:n}).
then(({arrays:a})=>{o.refine(a),this.listener.refined()}).catch(()=>{s.coarse=o}).finally(()=>{s.refining=!1}))}}settle(e){e.commit=!1,this.note(e.what),this.listener.
settled()}queries(){return this.films().map(e=>e.query)}note(e){this.listener.noted(this.history.note(this.queries(),e))}replace(e){this.lanes[this.active]={film:new he(
e)},this.listener.shown(),this.note()}travel(e){return this.inTurn(async()=>{let t=this.history.next(e);t&&(await this.load(t),this.history.step(e),await this.listener.
travelled(e),this.listener.shown(),this.listener.noted("travelled"))})}arrive(e){return this.inTurn(async()=>{await this.load(e),this.history.arrive(e),this.listener.
shown(),this.listener.noted("travelled")})}inTurn(e){return this.going=this.going.then(e).then(()=>!0,t=>(this.listener.failed(t),!1)),this.going}compare(){this.
lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=0),this.listener.shown(),this.note()}choose(e){
this.active=e,this.listener.shown(),this.listener.noted("same")}link(e=""){let s=[this.lanes.length>1?`with=${encodeURIComponent(this.film(1).query)}`:"",e].filter(
Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};var Xn=6e3,At=class{constructor(){this.message=h("p",{class:"message",role:"alert",hidden:!0}),this.toast=h("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(e){M(this.message,e.message),this.message.hidden=!1,this.seen()||this.say(e.message,this.message.isConnected)}seen(){let{top:e,bottom:t,height:s}=this.
message.getBoundingClientRect();return this.message.isConnected&&s>0&&e>=0&&t<=innerHeight}clear(){this.message.hidden=!0}say(e,t=!1){this.toast.setAttribute("r\
ole",t?"presentation":"status"),M(this.toast,e),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},Xn)}};var $=52,gs=10,q=8,Qn=30,Uo={solid:[],dash:[6,4],dot:[2,3],long:[14,4],mixed:[8,3,2,3]},Te=class{films;active;look;box;range;heights;picked;named;values;constructor({
key:e,title:t,unit:s,curves:o,limits:n,symmetric:a=!1},r){this.key=e,this.title=t,this.unit=s,this.curves=o,this.limits=n,this.symmetric=a,this.shared=r,this.canvas=
h("canvas",{class:"plot-canvas"}),this.over=h("canvas",{class:"plot-canvas plot-over"}),this.keys=h("div",{class:"plot-keys"}),this.body=h("div",{class:"plot-bo\
dy",tabindex:"0",role:"img","aria-label":t},this.canvas,this.over),this.element=h("section",{class:"plot","data-plot":e},h("header",{},h("h3",{},t),this.keys),this.
body),this.body.addEventListener("pointerdown",l=>this.press(l)),this.pinched=H(this.body,{zoom:(l,c)=>this.films&&this.zoomAbout(c?this.valueAt(c):this.middle(),
1/l),home:()=>this.zoomTo(null),keys:!0}),this.onseek=()=>{}}abscissa(e){return W[this.shared.axis].values(e)}fullRange(){if(this.shared.axis==="time")return[0,
Math.max(...this.films.map(s=>s.duration),1e-9)];let[e,t]=[1/0,-1/0];for(let s of this.films)for(let o of this.abscissa(s))o<e&&(e=o),o>t&&(t=o);return t>e?[e,t]:
[e-1,t+1]}draw(e,t,s,o){this.films=e,this.active=t,this.look=s;let{context:n,width:a,height:r}=I(this.canvas);this.box={width:a-$-gs,height:r-q-Qn},n.clearRect(
0,0,a,r),this.range=this.shared.range??this.fullRange();let l=e.flatMap((c,d)=>this.shades(c,d).map((u,p)=>({...u,film:c,lane:d,number:p})));this.heights=this.limits??
this.findHeights(l),this.shared.axis==="time"&&this.bands(n,e[t],o),this.grid(n,s,a,r),n.save(),n.beginPath(),n.rect($,q,this.box.width,this.box.height),n.clip();
for(let c of l)this.curve(n,c);if(e.length>1)for(let c of l)c.number===0&&this.letter(n,c);n.restore(),this.legend(this.shades(e[t],t),s.dark),this.describe(l)}shades(e,t){
let{dark:s}=this.look;if(this.films.length<2)return this.curves(e).map(n=>({...n,color:n.color&&Le(n.color,s)}));let o=Object.keys(Uo);return this.curves(e).map(
(n,a)=>({...n,color:G(t,s),dash:o[a%o.length]}))}x(e){return $+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return q+(1-(e-this.heights[0])/
(this.heights[1]-this.heights[0]))*this.box.height}findHeights(e){let t=[];for(let{film:d,values:u}of e){let p=this.abscissa(d);for(let m=0;m<u.length;m++)p[m]>=
this.range[0]&&p[m]<=this.range[1]&&Number.isFinite(u[m])&&t.push(u[m])}if(!t.length)return[0,1];let s=Float64Array.from(t).sort(),[o,n]=[s[0],s[s.length-1]],[a,
r]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],l=Math.max(r-a,1e-12);n>r+4*l&&(n=r+.6*l),o<a-4*l&&(o=a-.6*l),o=Math.min(o,0),n=Math.max(n,0),this.
symmetric&&([o,n]=[-Math.max(-o,n),Math.max(-o,n)]);let c=.06*(n-o)||1;return[o<0?o-c:o,n+c]}bands(e,t,s){for(let o of t.phases){let n=y(this.x(o.from),$,$+this.
box.width),a=y(this.x(o.to),$,$+this.box.width);a<=n||(e.fillStyle=Pe(s.modes[o.mode],.14),e.fillRect(n,q,a-n,this.box.height))}}grid(e,t,s,o){e.font=`11px ${t.
font}`,e.strokeStyle=t.line,e.fillStyle=t.soft,e.lineWidth=1;let n=Math.max(this.box.height/28,4);for(;U(this.heights[0],this.heights[1],n).length<3&&n<12;)n+=1;
let a=F(this.heights[1]-this.heights[0],n);e.textAlign="right",e.textBaseline="middle";for(let p of U(this.heights[0],this.heights[1],n)){let m=Math.round(this.
y(p))+.5;e.globalAlpha=Math.abs(p)<1e-9*a?1:.55,e.beginPath(),e.moveTo($,m),e.lineTo(s-gs,m),e.stroke(),e.globalAlpha=1,e.fillText(O(p,a),$-6,m)}let r=this.box.
width/70,l=F(this.range[1]-this.range[0],r);e.textAlign="center",e.textBaseline="alphabetic";let{name:c,unit:d}=W[this.shared.axis],u=d?`${k(c)} [${d}]`:k(c);for(let p of U(
this.range[0],this.range[1],r)){let m=this.x(p);e.beginPath(),e.moveTo(m,q+this.box.height),e.lineTo(m,q+this.box.height+4),e.stroke(),e.fillText(O(p,l),m,q+this.
box.height+15)}e.textAlign="right",e.fillText(u,s-gs,o-3),e.save(),e.translate(11,q+.5*this.box.height),e.rotate(-Math.PI/2),e.textAlign="center",e.fillText(k(this.
unit),0,0),e.restore()}curve(e,{film:t,color:s,dash:o,number:n}){e.strokeStyle=s??this.look.ink,e.lineWidth=1.8,e.setLineDash(Uo[o??"solid"]),e.beginPath();let a=!1;
for(let r of t.pieces()){let l=this.abscissa(r.film),{values:c}=this.curves(r.film)[n];for(let d=r.from;d<r.to;d++){if(!Number.isFinite(c[d])||!Number.isFinite(
l[d])){a=!1;continue}let u=this.x(l[d]),p=y(this.y(c[d]),-1e4,1e4);a?e.lineTo(u,p):e.moveTo(u,p),a=!0}}e.stroke(),e.setLineDash([])}letter(e,{film:t,lane:s,values:o,
color:n}){let a=this.abscissa(t),r=this.range[0]+(s?.84:.7)*(this.range[1]-this.range[0]),l=a.findIndex(u=>u>=r);if(l<0||!Number.isFinite(o[l]))return;let[c,d]=[
this.x(a[l]),y(this.y(o[l])-8,q+10,q+this.box.height-4)];e.font=`700 12px ${this.look.font}`,e.textAlign="center",e.lineWidth=4,e.strokeStyle=this.look.panel,e.
strokeText("AB"[s],c,d),e.fillStyle=n??this.look.ink,e.fillText("AB"[s],c,d)}legend(e,t){let s=e.map(o=>o.name+o.color+o.dash).join()+t;this.named!==s&&(this.named=
s,this.values=e.map(()=>h("span",{class:"value"})),this.keys.replaceChildren(...e.map((o,n)=>h("span",{class:"plot-key"},ws(o.color,o.dash),o.name," ",this.values[n]))))}describe(e){
let t=e.slice(0,6).map(({name:o,values:n,lane:a})=>{let[r,l]=[1/0,-1/0];for(let u of n)u<r&&(r=u),u>l&&(l=u);let c=this.films.length>1?`${"AB"[a]}: `:"",d={name:k(
o),low:T(r,3),high:T(l,3)};return l>=r?`${c}${k("{name} from {low} to {high}",d)}`:""}),s=k("Diagram: {title} in {unit}.",{title:k(this.title),unit:k(this.unit)});
this.body.setAttribute("aria-label",`${s} ${t.filter(Boolean).join("; ")}.`)}cursor(e){if(!this.films)return;let{context:t,width:s,height:o}=I(this.over);if(t.clearRect(
0,0,s,o),this.films.forEach((n,a)=>{let r=n.holding(e),l=r.at(e),c=r.index(l.t),d=Math.min(c+1,r.length-1),u=r.t[d]>r.t[c]?(l.t-r.t[c])/(r.t[d]-r.t[c]):0,p=this.
abscissa(r),m=this.x(p[c]+u*(p[d]-p[c])),w=m>=$-1&&m<=$+this.box.width+1;w&&(t.strokeStyle=this.look.soft,t.lineWidth=1,t.beginPath(),t.moveTo(m,q),t.lineTo(m,q+
this.box.height),t.stroke()),this.shades(r,a).forEach((b,g)=>{let f=b.values[d],x=Number.isFinite(f)?b.values[c]+u*(f-b.values[c]):b.values[c];a===this.active&&
this.values?.[g]&&(this.values[g].textContent=T(x,3));let S=this.y(x);!w||!(S>=q-1&&S<=q+this.box.height+1)||(t.fillStyle=b.color??this.look.ink,t.beginPath(),t.
arc(m,S,3.2,0,2*Math.PI),t.fill())})}),this.picked){let[n,a]=this.picked;t.fillStyle=Pe("#0072B2",.2),t.fillRect(Math.min(n,a),q,Math.abs(a-n),this.box.height)}}valueAt(e){
let t=this.body.getBoundingClientRect(),s=y((e.clientX-t.left-$)/this.box.width,0,1);return this.range[0]+s*(this.range[1]-this.range[0])}press(e){if(!this.films)
return;let t=this.body.getBoundingClientRect(),s=e.clientX-t.left,o=this.valueAt(e),n=this.pinched(),a=r=>{if(n||=this.pinched(),n)return;let l=r.clientX-t.left;
this.picked=e.pointerType==="mouse"&&Math.abs(l-s)>5?[s,l]:null,e.pointerType!=="mouse"&&this.seek(this.valueAt(r)),this.cursor(this.shared.clock.time)};C(this.
body,e,a,(r,l)=>{let c=this.valueAt(r),{picked:d}=this;this.picked=null,d&&l?this.zoomTo(o<c?[o,c]:[c,o]):d?this.cursor(this.shared.clock.time):l&&!n&&this.seek(
e.pointerType==="mouse"?o:c)})}seek(e){if(this.shared.axis==="time")return this.onseek(e);let t=this.films[this.active],s=this.abscissa(t),o=0;for(let n=0;n<s.length;n++)
Math.abs(s[n]-e)<Math.abs(s[o]-e)&&(o=n);return this.onseek(t.t[o])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(e,t){let s=this.fullRange(),o=Math.
max(e-(e-this.range[0])*t,s[0]),n=Math.min(e+(this.range[1]-e)*t,s[1]);this.zoomTo(o<=s[0]&&n>=s[1]?null:[o,n])}zoomTo(e){this.shared.range=e&&e[1]-e[0]>1e-9?e:
null,this.shared.changed()}};function ws(i,e="solid"){let t=h("i",{class:"swatch","aria-hidden":"true"});return t.style.borderTopColor=i??"var(--ink)",t.style.borderTopStyle=
{solid:"solid",dash:"dashed",dot:"dotted",long:"double",mixed:"groove"}[e],t}var ce=52,Ko=10,L=8,ea=30,ta="RSKHM?",zt=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(e,t,s){this.backend=
e,this.clock=t,this.colors=s,this.canvas=h("canvas",{class:"plot-canvas"}),this.over=h("canvas",{class:"plot-canvas plot-over"}),this.keys=h("div",{class:"plot-\
keys"}),this.body=h("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=h("section",{class:"phase"},h("header",{},h("h3",{},"Plane of θ and θ̇"),this.keys),this.body,h("p",{class:"hint"},
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox."," ",`Click to go there; ${xe("")}.`)),this.body.addEventListener(
"pointerdown",o=>this.seek(o)),this.pinched=H(this.body,{zoom:(o,n)=>this.box&&this.zoomAbout(n?this.point(n):this.middle(),1/o),home:()=>this.zoomTo(null),keys:!0}),
this.range=[0,2*Math.PI],this.asked="",this.soon=J(()=>this.sharpen(),140)}async fetch(e,t){let s=this.reach(),o=JSON.stringify([e.hoop,e.plane,s]);if(o!==this.
asked){let n=await this.painted(e,[0,2*Math.PI,-s,s],t);this.asked=o,this.pictures=[n],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.
pictures||!this.window)){this.sharpening?.abort(),this.sharpening=new AbortController;try{let e=await this.painted(this.films[this.active].scenario,[...this.range,
...this.window],this.sharpening.signal);this.pictures=[this.pictures[0],e],this.redraw()}catch(e){if(e.name!=="AbortError")throw e}}}async painted(e,t,s){let{header:o,
arrays:n}=await this.backend.call("regions",{scenario:e,window:t},s);return{window:o.window,paradox:n.paradox,picture:this.paint(n.modes,o.arrays[0].shape)}}reach(){
return this.reached}findReach(){let e=0;for(let s of this.films??[]){let o=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();e=Math.max(
e,o[Math.floor(.99*(o.length-1))]??0)}let t=F(Math.max(e,1)*1.15,4);return Math.ceil(Math.max(e,1)*1.12/t)*t}zoomTo(e){this.range=e??[0,2*Math.PI],this.window=null,
this.pictures?.splice(1),this.redraw()}point(e){let t=this.body.getBoundingClientRect(),s=(e.clientX-t.left-ce)/this.box.width,o=1-(e.clientY-t.top-L)/this.box.
height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+o*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.
bottom()+this.top())]}zoomAbout([e,t],s){let o=Math.max(e-(e-this.range[0])*s,0),n=Math.min(e+(this.range[1]-e)*s,2*Math.PI),a=this.reach(),r=Math.max(t-(t-this.
bottom())*s,-a),l=Math.min(t+(this.top()-t)*s,a);this.range=[o,n],this.window=n-o<2*Math.PI-1e-9||l-r<2*a-1e-9?[r,l]:null,this.redraw(),this.soon()}bottom(){return this.
window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(e,t,s){this.films=
e,this.active=t,this.look=s,this.reached=this.findReach(),this.forwards=e.some(o=>o.columns.omega.some(n=>n>.3)),this.backwards=e.some(o=>o.columns.omega.some(n=>n<
-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(e){return ce+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return L+
(1-(e-this.bottom())/(this.top()-this.bottom()))*this.box.height}paint(e,[t,s]){let{modes:o}=this.colors,n=h("canvas",{width:s,height:t}),a=new ImageData(s,t);for(let r=0;r<
t;r++)for(let l=0;l<s;l++){let c=ta[e[r*s+l]],d=ee(o[c]??"#6E6E6E"),u=4*((t-1-r)*s+l);a.data.set([...d,255],u)}return oe(n).putImageData(a,0,0),n}redraw(){if(!this.
films)return;let{colors:e,look:t}=this,{context:s,width:o,height:n}=I(this.canvas);if(this.box={width:o-ce-Ko,height:n-L-ea},s.clearRect(0,0,o,n),s.save(),s.beginPath(),
s.rect(ce,L,this.box.width,this.box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:r}of this.pictures){let[l,c,d,u]=r,p=[this.
x(l),this.y(u),this.x(c)-this.x(l),this.y(d)-this.y(u)];s.fillStyle=t.panel,s.fillRect(p[0],p[1],p[2],p[3]),s.globalAlpha=.35,s.drawImage(a,p[0],p[1],p[2],p[3]),
s.globalAlpha=1}this.hatch(s)}for(let[a,r]of this.films.entries())this.way(s,r,a);if(s.restore(),this.axes(s,o,n),this.keyed!==t.dark){this.keyed=t.dark;let a=Object.
entries(e.mode_names).filter(([r])=>"RSKH".includes(r));this.keys.replaceChildren(...a.map(([r,l])=>h("span",{class:"plot-key"},ws(e.modes[r]),l)))}this.cursor(
this.clock.time)}hatch(e){let{paradox:t}=this.pictures[0],s=t.length;e.strokeStyle=Pe(this.look.dark?"#ffffff":"#000000",.28),e.lineWidth=1;for(let o=0;o<s;o++){
if(!t[o])continue;let n=o;for(;n<s&&t[n]===t[o];)n++;let a=this.x(o*2*Math.PI/s),r=this.x(n*2*Math.PI/s);e.save(),e.beginPath(),e.rect(a,L,r-a,this.box.height),
e.clip(),e.beginPath();let l=t[o];for(let c=-this.box.height;c<r-a+this.box.height;c+=7)e.moveTo(a+c,l>0?L+this.box.height:L),e.lineTo(a+c+this.box.height,l>0?L:
L+this.box.height);e.stroke(),e.restore(),o=n}}way(e,t,s){let{angle:o,omega:n,mode:a}=t.columns,r=2*Math.PI;e.lineWidth=s?1.2:1.8,e.setLineDash(s?[4,3]:[]),e.strokeStyle=
this.films.length>1?G(s,this.look.dark):this.look.ink,e.beginPath();let l=null;for(let c=0;c<t.length;c++){if(!Number.isFinite(n[c])){l=null;continue}let d=Math.
floor(o[c]/r),u=o[c]-d*r;if(l===null)e.moveTo(this.x(u),this.y(n[c]));else if(d!==l.lap){let p=d>l.lap?r:0;e.lineTo(this.x(p),this.y(n[c])),e.moveTo(this.x(r-p),
this.y(n[c])),e.lineTo(this.x(u),this.y(n[c]))}else e.lineTo(this.x(u),this.y(n[c]));l={lap:d,mode:a[c]}}e.stroke(),e.setLineDash([])}axes(e,t,s){let{look:o}=this;
e.font=`11px ${o.font}`,e.strokeStyle=o.soft,e.fillStyle=o.soft,e.lineWidth=1,e.strokeRect(ce+.5,L+.5,this.box.width-1,this.box.height-1),e.textAlign="center";let n=this.
range[0]*180/Math.PI,a=this.range[1]*180/Math.PI,r=a-n>200?45:F(a-n,6);for(let c=Math.ceil(n/r-1e-9);c*r<=a+1e-9;c++){let d=this.x(c*r*Math.PI/180);e.beginPath(),
e.moveTo(d,L+this.box.height),e.lineTo(d,L+this.box.height+4),e.stroke(),e.fillText(O(c*r,r),d,L+this.box.height+15)}e.textAlign="right",e.fillText(k("angle θ w\
ithin a turn [°]"),t-Ko,s-3),e.textBaseline="middle";let l=this.top()-this.bottom();for(let c of U(this.bottom(),this.top(),5))e.fillText(O(c,F(l,5)),ce-6,this.
y(c));e.textBaseline="alphabetic",e.save(),e.translate(11,L+.5*this.box.height),e.rotate(-Math.PI/2),e.textAlign="center",e.fillText("θ̇ [rad/s]",0,0),e.restore()}cursor(e){
if(!this.films||!this.box)return;let{context:t,width:s,height:o}=I(this.over);t.clearRect(0,0,s,o),this.films.forEach((n,a)=>{let r=n.at(e),l=2*Math.PI,c=r.angle-
Math.floor(r.angle/l)*l,d=this.x(c),u=this.y(r.omega);d>=ce&&d<=ce+this.box.width&&u>=L&&u<=L+this.box.height&&(t.beginPath(),t.arc(d,u,a?4:5.5,0,2*Math.PI),t.fillStyle=
this.colors.modes[r.mode],t.fill(),t.lineWidth=2,t.strokeStyle=this.films.length>1?G(a,this.look.dark):this.look.ink,t.stroke(),!(this.films.length<2)&&(t.font=
`700 12px ${this.look.font}`,t.textAlign="left",t.fillStyle=t.strokeStyle,t.fillText("AB"[a],d+8,u-6)))})}seek(e){let t=this.body.getBoundingClientRect(),[s,o]=[
e.clientX-t.left,e.clientY-t.top];if(this.pinched())return;let n=this.films[this.active],{angle:a,omega:r}=n.columns,l=2*Math.PI,c={distance:1/0,t:0};for(let d=0;d<
n.length;d++){let u=a[d]-Math.floor(a[d]/l)*l,p=Math.hypot(this.x(u)-s,this.y(r[d])-o);p<c.distance&&(c={distance:p,t:n.t[d]})}c.distance<40&&this.clock.seek(y(
c.t,0,n.duration))}};var bs=i=>Object.entries(W).map(([e,t])=>h("option",{value:e},i(t)));function Go(i){let e="height",t=new Te({key:"own",title:"Your choice",unit:"",curves:n=>[{name:k(
W[e].name),values:W[e].values(n)}]},i),s=()=>{let{symbol:n,unit:a}=W[e];t.unit=a?`${n} [${a}]`:n},o=h("select",{"aria-label":"What your diagram shows",onchange:()=>{
e=o.value,s(),i.changed()}},bs(ko));return o.value=e,s(),t.element.querySelector("h3")?.after(o),t}function sa(i){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:e=>[{name:"v (centre)",color:i.center_speed,values:e.columns.vx},{name:"\
R θ̇",color:i.rotation_speed,dash:"dash",values:e.derived("spin",({omega:t})=>Float64Array.from(t,s=>s*e.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:e=>[{name:"kinetic",color:i.kinetic,values:e.columns.kinetic},{name:"potential",color:i.potential,values:e.columns.potential},{name:"\
total",values:e.derived("total",({t,kinetic:s,potential:o})=>Float64Array.from(t,(n,a)=>s[a]+o[a])),dash:"dash"},{name:"lost to friction",color:i.friction_loss,
values:e.columns.friction_loss},{name:e.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:i.impact_loss,values:e.columns.
normal_loss,dash:"dot"}]},{key:"forces",title:"Contact forces",unit:"force [N]",curves:e=>[{name:"normal N",color:i.normal_force,values:e.columns.normal_force},
{name:"friction F",color:i.friction_force,dash:"dash",values:e.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],
curves:e=>[{name:"|F| / μN",color:i.friction_force,values:e.columns.utilization}]}]}var Rt=class{films;active;look;constructor(e,t){this.colors=t,this.shared={
axis:"time",range:null,clock:e,changed:()=>this.redraw()},this.plots=[...sa(t).map(o=>new Te(o,this.shared)),Go(this.shared)];for(let o of this.plots)o.onseek=n=>e.
seek(n);this.seen=new Map(this.plots.map(o=>[o.element,!0]));let s=new IntersectionObserver(o=>{for(let{target:n,isIntersecting:a}of o)this.seen.set(n,a);this.redraw()},
{rootMargin:"400px"});for(let o of this.plots)s.observe(o.element);this.axis=h("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.
axis=this.axis.value,this.shared.range=null,this.redraw()}},bs(({name:o})=>`over ${o}`)),this.back=h("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].
zoomTo(null)},"Whole motion"),this.hint=h("span",{class:"hint"}),this.element=h("div",{class:"plots"},h("div",{class:"plots-head"},this.axis,this.back,this.hint),
this.plots.map(o=>o.element))}draw(e,t,s){this.films=e,this.active=t,this.look=s;let o=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":
`click to go there, drag to zoom; ${xe("")}`,n=e.length>1;M(this.hint,n?`A blue, B ochre; the dashes tell the quantities; numbers of ${"AB"[t]}; ${o}`:o),this.redraw()}redraw(){
if(this.films?.length){this.back.hidden=!this.shared.range;for(let e of this.visible())e.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.
clock.time)}}visible(){return this.plots.filter(e=>this.seen.get(e.element))}cursor(e){for(let t of this.visible())t.cursor(e)}};var oa=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],Pt=class{constructor(e){this.lab=e,this.menu=h("details",{class:"menu"},h("summary",{class:"button"},"Keep"),h("div",{class:"menu-body"},e.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),oa.map(([t,s])=>this.item(s,()=>this.download(t))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=h("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),e.root.addEventListener("pointerdown",t=>{this.menu.contains(t.target)||(this.menu.open=!1)})}item(e,t){return h("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await t()}catch(s){this.lab.notice.fail(s)}}},e)}async copyLink(){let e=this.lab.link()??"";try{await navigator.clipboard.writeText(e),this.
lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",e)}}async download(e){let t=this.lab.film();this.lab.notice.say(e.endsWith("mp4")?
"The film is being made; this takes a while …":`Fetching ${e} …`),ye(await this.lab.backend.file(e,t.query),`hophoop-${e}`),this.lab.notice.say(`${e} is the\
re.`)}picture(){this.lab.drawStage();let e=this.lab.stage.canvas(),t=h("canvas",{width:e.width,height:e.height});return this.copyInto(t),new Promise(s=>{t.toBlob(
o=>{o&&ye(o,"hophoop.png"),s()},"image/png")})}copyInto(e){let{lab:t}=this,s=t.stage.canvas(),o=oe(e);o.fillStyle=t.theme.look.paper,o.fillRect(0,0,e.width,e.height),
o.drawImage(s,0,0,e.width,e.height);let n=e.width/Math.max(s.getBoundingClientRect().width,1);o.textBaseline="top",o.textAlign="left";let a=t.films();for(let[r,
l]of a.entries()){let c=l.at(t.clock.time),d=[a.length>1?`${"AB"[r]}: `:"",`${k(t.theme.colors.mode_names[c.mode])}, t = ${c.t.toFixed(3)} s, θ = ${P(c.angle)}\
, v = ${T(c.vx,3)} m/s`].join(""),u=t.stage.options.three?10+20*r:10+r*s.getBoundingClientRect().height/a.length;o.fillStyle=t.theme.colors.modes[c.mode],o.fillRect(
12*n,(u+2)*n,11*n,11*n),o.fillStyle=t.theme.look.ink,o.font=`${13*n}px ${t.theme.look.font}`,o.fillText(d,30*n,u*n)}}async record(){let{lab:e}=this,t=e.stage.canvas();
if(!t.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 instead.");let s=h("canvas",{width:2*Math.ceil(
t.width/2),height:2*Math.ceil(t.height/2)}),o=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),n=[];o.ondataavailable=l=>n.push(l.data);let a=new Promise(
l=>o.onstop=l),r=e.clock.loop;e.clock.loop=!1,e.clock.seek(0),e.notice.say("Recording one run …"),e.afterFrame=()=>{this.copyInto(s),!e.clock.playing&&o.state===
"recording"&&o.stop()},o.start(),e.clock.play(!0),await a,e.afterFrame=null,e.clock.loop=r,ye(new Blob(n,{type:o.mimeType}),"hophoop.webm"),e.notice.say("The fi\
lm is there.")}async code(){let{header:e}=await this.lab.backend.call("code",{scenario:this.lab.film().scenario});this.show("The same motion in Python",e.python,
"The scenario as a file",e.toml)}show(...e){let t=[];for(let s=0;s<e.length;s+=2){let o=e[s+1],n=h("button",{type:"button"},"Copy");n.onclick=async()=>{await navigator.
clipboard?.writeText(o).catch(()=>{}),M(n,"Copied")},t.push(h("header",{},h("h2",{},e[s]),n),h("pre",{tabindex:"0"},h("code",{},document.createTextNode(o))))}this.
dialog.replaceChildren(...t,h("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};function Vo(i,e){let t=h("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([o])=>{let n=!o.isIntersecting&&o.boundingClientRect.top<0;if(n===
i.classList.contains("stuck"))return;let a=i.offsetHeight;i.style.marginBottom="",i.classList.toggle("stuck",n),n&&(i.style.marginBottom=`${a-i.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=n?`${i.offsetHeight}px`:"",e()});return s.observe(t),{edge:t,close:()=>s.disconnect()}}var Yo=120,Lt=class{constructor(e,t){this.canvas=e,this.onview=t,this.zoom=1,this.shift=[0,0],this.views=[],this.fixed=null,this.grab=()=>!1,e.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=H(e,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>e.parentElement})}reset(){this.zoom=1,this.shift=[0,0],
this.onview()}zoomBy(e){this.zoom=y(this.zoom*e,.05,60),this.onview()}drag(e){if(this.grab(e))return;let t=[e.clientX,e.clientY],s=this.shift;C(this.canvas,e,o=>{
this.pinched()||(this.shift=[s[0]+o.clientX-t[0],s[1]+o.clientY-t[1]],this.onview())})}draw(e,t,s,o,n){let{context:a,width:r,height:l}=I(this.canvas);if(a.clearRect(
0,0,r,l),r<40||l<40)return;let c=l/e.length,d={top:Math.max(...e.map(u=>u.extent.top)),radius:Math.max(...e.map(u=>u.radius)),speed:Math.max(...e.map(u=>u.extent.
speed))};e.forEach((u,p)=>{a.save(),a.beginPath(),a.rect(0,p*c,r,c),a.clip(),a.translate(0,p*c);let m=new ys(a,r,c,u,t,s,o,n,this.zoom,this.shift,d);m.top=p*c,m.
scale=this.fixed??m.scale,m.draw(),this.views[p]=m,e.length>1&&(m.mark("AB"[p],G(p,o.dark)),a.fillStyle=G(p,o.dark),a.font=`700 17px ${o.font}`,a.textAlign="lef\
t",a.fillText("AB"[p],12,c-12)),a.restore(),p>0&&(a.fillStyle=o.line,a.fillRect(0,p*c-.5,r,1))})}},ys=class{top=0;constructor(e,t,s,o,n,a,r,l,c,d,u){this.context=
e,this.width=t,this.height=s,this.film=o,this.options=a,this.look=r,this.colors=l,this.common=u,this.pose=o.at(n);let p=o.radius,{left:m,right:w}=o.extent,{top:b}=u;
this.cosine=Math.cos(o.slope),this.sine=Math.sin(o.slope);let g=2*u.radius+Math.min(b,6*u.radius),f=Math.min(.66*s/g,.36*t/u.radius);if(a.whole){let x=(w-m)*this.
cosine+2.6*p,S=(w-m)*Math.abs(this.sine)+2.6*p+b;this.scale=Math.min(t/x,.86*s/S,f)*c,this.focus=[.5*(m+w),0],this.place=[.5*t+d[0],(o.slope?.62:.8)*s+d[1]]}else
this.scale=f*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.place=[(t<520?.6:.46)*t+d[0],.82*s+d[1]]}point(e,t){let s=e-this.focus[0],o=t-this.
focus[1];return[this.place[0]+this.scale*(s*this.cosine+o*this.sine),this.place[1]-this.scale*(o*this.cosine-s*this.sine)]}unpoint(e,t){let s=(e-this.place[0])/
this.scale,o=-(t-this.place[1])/this.scale;return[this.focus[0]+s*this.cosine-o*this.sine,this.focus[1]+s*this.sine+o*this.cosine]}draw(){this.ground(),(this.options.
traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&this.forces()}ground(){let{context:e,look:t,width:s,height:o}=this,n=(Math.hypot(s,o)*
1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[a,r]=this.point(this.focus[0]-n,0),[l,c]=this.point(this.focus[0]+n,0),d=[-this.sine*4e3,this.cosine*
4e3];e.fillStyle=t.ground,e.beginPath(),e.moveTo(a,r),e.lineTo(l,c),e.lineTo(l+d[0],c+d[1]),e.lineTo(a+d[0],r+d[1]),e.fill(),e.strokeStyle=t.soft,e.lineWidth=1.5,
e.beginPath(),e.moveTo(a,r),e.lineTo(l,c),e.stroke();let u=F(s/this.scale,s/90);e.fillStyle=t.soft,e.font=`11px ${t.font}`,e.textAlign="center",e.lineWidth=1;let p=Math.
ceil((this.focus[0]-n)/u),m=Math.min(Math.floor((this.focus[0]+n)/u),p+400);for(let w=p;w<=m;w++){let[b,g]=this.point(w*u,0);b<-40||b>s+40||(e.beginPath(),e.moveTo(
b,g),e.lineTo(b-6*this.sine,g+6*this.cosine),e.stroke(),e.fillText(`${O(w*u,u)} m`,b-18*this.sine,g+8+10*this.cosine))}}traces(){let{film:e,context:t,look:s,colors:o}=this,
n=e.radius,a=this.options.ahead?e.duration:this.pose.t,r=(l,c,d,u)=>{t.strokeStyle=c,t.lineWidth=d,t.lineJoin="round",t.beginPath();let p=!1,m=(w,b,g)=>{let[f,x]=this.
point(w+l*Math.sin(g),n+b+l*Math.cos(g));p?t.lineTo(f,x):t.moveTo(f,x),p=!0};for(let w of e.pieces()){let{x:b,height:g,angle:f,mode:x}=w.film.columns;for(let S=w.
from;S<w.to&&w.film.t[S]<=a;S++)u===void 0||x[S]===3===u?m(b[S],g[S],f[S]):p=!1}!this.options.ahead&&(u===void 0||this.pose.mode==="H"===u)&&m(this.pose.x,this.
pose.height,this.pose.angle),t.stroke()};t.globalAlpha=this.options.ahead?.45:1,r(n,s.ink,1.3),r(e.eccentricity*n,o.gravity_center,1.8,!1),r(e.eccentricity*n,o.
airborne,2.4,!0),t.globalAlpha=1}mark(e,t){let{context:s,film:o,pose:n,scale:a}=this,[r,l]=this.point(n.x,o.radius+n.height);s.strokeStyle=t,s.lineWidth=3,s.beginPath(),
s.arc(r,l,Math.max(o.radius*a-y(.07*o.radius*a,2,14)-3,2),0,2*Math.PI),s.stroke(),s.fillStyle=t,s.font=`700 17px ${this.look.font}`,s.textAlign="center",s.fillText(
e,r-14,l+20)}hoop(){let{film:e,pose:t,context:s,look:o,colors:n,scale:a}=this,r=e.radius,l=y(.07*r*a,2,14),c=r-.5*l/a,d=[t.x,r+t.height],u=(g,f=c)=>this.point(d[0]+
f*Math.sin(g),d[1]+f*Math.cos(g));if(s.lineCap="butt",o.dark&&(s.strokeStyle=o.soft,s.lineWidth=l+2,s.beginPath(),s.arc(...this.point(d[0],d[1]),c*a,0,2*Math.PI),
s.stroke()),this.options.speed){let g=this.common.speed;s.lineWidth=l;let f=2*Math.PI/Yo;for(let x=0;x<Yo;x++){let S=t.angle+x*f,E=Math.hypot(t.vx+r*t.omega*Math.
cos(S+.5*f),t.vy-r*t.omega*Math.sin(S+.5*f));s.strokeStyle=Ze[y(Math.round(255*E/g)||0,0,255)],s.beginPath(),s.moveTo(...u(S-.04*f)),s.lineTo(...u(S+1.04*f)),s.
stroke()}}else s.strokeStyle=n.modes[t.mode],s.lineWidth=l,s.beginPath(),s.arc(...this.point(d[0],d[1]),c*a,0,2*Math.PI),s.stroke();s.strokeStyle=o.soft,s.lineWidth=
1,s.beginPath(),s.moveTo(...this.point(d[0],d[1])),s.lineTo(...u(t.angle)),s.stroke();let p=(g,f,x,S)=>{s.beginPath(),s.arc(...g,f,0,2*Math.PI),s.fillStyle=x,s.
fill(),s.lineWidth=1.5,s.strokeStyle=S,s.stroke()};p(this.point(d[0],d[1]),2.5,o.soft,o.soft);let m=e.scenario.hoop.parts;m?this.parts(m,d):p(u(t.angle),y(.1*r*
a,4,16),o.ink,o.paper);let w=e.eccentricity*r,b=this.point(d[0]+w*Math.sin(t.angle),d[1]+w*Math.cos(t.angle));p(b,y(.05*r*a,3.5,7),t.mode==="H"?n.airborne:n.gravity_center,
o.paper)}parts(e,t){let{film:s,pose:o,context:n,look:a,scale:r}=this,c=e.reduce((d,u)=>d+u.mass*(u.at??0),0)<0?-1:1;n.strokeStyle=a.ink;for(let d of e){let u=c*
(d.at??0),p=this.point(t[0]+u*Math.sin(o.angle),t[1]+u*Math.cos(o.angle));if(n.fillStyle=a.ink,n.lineWidth=1,n.beginPath(),d.shape==="ring")n.globalAlpha=.22,n.
arc(...p,d.outer_radius*r,0,2*Math.PI),n.arc(...p,d.inner_radius*r,0,2*Math.PI,!0),n.fill(),n.globalAlpha=1;else if(d.shape==="rod"){let m=.5*d.length,w=b=>this.
point(t[0]+b*Math.sin(o.angle),t[1]+b*Math.cos(o.angle));n.lineWidth=4,n.moveTo(...w(u-m)),n.lineTo(...w(u+m)),n.stroke()}else{let m=d.shape==="disk"?d.radius*r:
y(.08*s.radius*r,3,12);n.globalAlpha=d.shape==="disk"?.55:1,n.arc(...p,m,0,2*Math.PI),n.fill(),n.globalAlpha=1}}}forces(){let{film:e,pose:t,colors:s}=this,o=e.radius,
n=e.mass*(e.gravity||9.81),a=l=>.55*o*l/n;if(t.mode==="H"||!(t.normal_force>0))return;let r=[t.x,t.height];this.arrow(r,[0,a(t.normal_force)],s.normal_force,`N \
= ${T(t.normal_force,3)} N`,!1),this.arrow(r,[a(t.friction_force),0],s.friction_force,`F = ${T(t.friction_force,3)} N`,!0)}arrow([e,t],[s,o],n,a,r){let{context:l,
look:c,width:d}=this,u=2.2*this.film.radius,p=Math.abs(s)>u||Math.abs(o)>u;[s,o]=[y(s,-u,u),y(o,-u,u)];let m=this.point(e,t),w=this.point(e+s,t+o),b=Math.hypot(
w[0]-m[0],w[1]-m[1]);if(b<2)return;let g=(w[0]-m[0])/b,f=(w[1]-m[1])/b,x=Math.min(11,b);for(let[R,z]of[[c.paper,6],[n,3]])l.strokeStyle=R,l.fillStyle=R,l.lineWidth=
z,l.beginPath(),l.moveTo(...m),l.lineTo(w[0]-g*x,w[1]-f*x),l.stroke();if(l.beginPath(),l.moveTo(...w),l.lineTo(w[0]-g*x-f*x*.5,w[1]-f*x+g*x*.5),l.lineTo(w[0]-g*
x+f*x*.5,w[1]-f*x-g*x*.5),l.fill(),p){let[R,z]=[m[0]+.55*g*b,m[1]+.55*f*b];l.strokeStyle=c.paper,l.lineWidth=2,l.beginPath();for(let A of[-3,3])l.moveTo(R+g*(A-
3)-f*7,z+f*(A-3)+g*7),l.lineTo(R+g*(A+3)+f*7,z+f*(A+3)-g*7);l.stroke()}l.font=`600 12px ${c.font}`;let S=l.measureText(a).width;l.lineWidth=3,l.strokeStyle=r?c.
ground:c.paper,l.textAlign="left";let E=r?[m[0]-.5*S-32*this.sine,m[1]+32*this.cosine]:[w[0]+12,y(w[1]+4,16,m[1]-.36*this.film.radius*this.scale)];E[0]=y(E[0],4,
d-S-4),l.strokeText(a,E[0],E[1]),l.fillText(a,E[0],E[1])}};function ks(i,e){let t=new Float32Array(16);for(let s=0;s<4;s++)for(let o=0;o<4;o++){let n=0;for(let a=0;a<4;a++)n+=i[4*a+o]*e[4*s+a];t[4*s+o]=n}return t}function Jo(i,e,t,s){
let o=1/Math.tan(i/2),n=1/(t-s);return new Float32Array([o/e,0,0,0,0,o,0,0,0,0,(s+t)*n,-1,0,0,2*s*t*n,0])}function Zo(i,e){let t=ge(xs(i,e)),s=ge(It([0,1,0],t)),
o=It(t,s);return new Float32Array([s[0],o[0],t[0],0,s[1],o[1],t[1],0,s[2],o[2],t[2],0,-vs(s,i),-vs(o,i),-vs(t,i),1])}var xs=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],
vs=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],It=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];function ge(i){let e=Math.hypot(...i)||1;return[
i[0]/e,i[1]/e,i[2]/e]}function _t(i,e,t,s){let o=ge(e),n=ge(It(o,Math.abs(o[2])>.9?[1,0,0]:[0,0,1])),a=It(n,o);return new Float32Array([...n.map(r=>r*s),0,...o.
map(r=>r*t),0,...a.map(r=>r*s),0,...i,1])}function Ts(i){let[e,t]=[Math.cos(i),Math.sin(i)];return new Float32Array([e,-t,0,0,t,e,0,0,0,0,1,0,0,0,0,1])}function K(i){let e=Number.parseInt(i.slice(1,7),16);
return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}function Se(i,e,t){let s=i.createProgram(),o=[[i.VERTEX_SHADER,e],[i.FRAGMENT_SHADER,t]];for(let[a,r]of o){let l=i.createShader(a);if(i.shaderSource(l,r),i.compileShader(
l),!i.getShaderParameter(l,i.COMPILE_STATUS))throw new Error(String(i.getShaderInfoLog(l)));i.attachShader(s,l)}if(i.linkProgram(s),!i.getProgramParameter(s,i.LINK_STATUS))
throw new Error(String(i.getProgramInfoLog(s)));let n={program:s,uniforms:{},attributes:{}};for(let a=0;a<i.getProgramParameter(s,i.ACTIVE_UNIFORMS);a++){let{name:r}=i.
getActiveUniform(s,a);n.uniforms[r]=i.getUniformLocation(s,r)}for(let a=0;a<i.getProgramParameter(s,i.ACTIVE_ATTRIBUTES);a++){let{name:r}=i.getActiveAttrib(s,a);
n.attributes[r]=i.getAttribLocation(s,r)}return n}function we(i,e,t,s){let o=i.createBuffer();i.bindBuffer(i.ARRAY_BUFFER,o),i.bufferData(i.ARRAY_BUFFER,new Float32Array(
e),i.STATIC_DRAW);let n=s?i.createBuffer():null;s&&(i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,n),i.bufferData(i.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),i.STATIC_DRAW));
let a=4*Object.values(t).reduce((r,l)=>r+l,0);return{vertices:o,elements:n,parts:t,stride:a,count:s?s.length:4*e.length/a}}function Me(i,e,t){i.bindBuffer(i.ARRAY_BUFFER,
t.vertices);let s=0;for(let[o,n]of Object.entries(t.parts)){let a=e.attributes[o];a!==void 0&&(i.enableVertexAttribArray(a),i.vertexAttribPointer(a,n,i.FLOAT,!1,
t.stride,s)),s+=4*n}t.elements&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.elements)}function Ss(i,e){let t=[];for(let s=0;s<i;s++)for(let o=0;o<e;o++){let n=s*(e+1)+
o,a=n+e+1;t.push(n,a,n+1,a,a+1,n+1)}return t}function Xo(i,e=120,t=14){let s=[];for(let o=0;o<=e;o++)for(let n=0;n<=t;n++)s.push(2*Math.PI*o/e,2*Math.PI*n/t);return we(
i,s,{bend:2},Ss(e,t))}function Qo(i,e=28,t=18){let s=[];for(let o=0;o<=e;o++)for(let n=0;n<=t;n++){let[a,r]=[2*Math.PI*o/e,Math.PI*n/t],l=[Math.sin(r)*Math.cos(
a),Math.cos(r),Math.sin(r)*Math.sin(a)];s.push(...l,...l)}return we(i,s,{position:3,normal:3},Ss(e,t))}function Ms(i,e,t=20){let s=[];for(let o=0;o<=t;o++){let n=2*
Math.PI*o/t,a=[Math.cos(n),1-e,Math.sin(n)];s.push(Math.cos(n),0,Math.sin(n),...a,e*Math.cos(n),1,e*Math.sin(n),...a)}return we(i,s,{position:3,normal:3},Ss(t,1))}var oi=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,ii=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,ni="vec4(0.0, 0.0, 0.0, shadow)",ei=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${ii}
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
   ${oi}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${ni} : vec4(shaded(color, n), 1.0);
   }`],ti=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${ii}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${oi}
   void main() { gl_FragColor = shadow > 0.0 ? ${ni} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],si=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],Ct=class{constructor(e,t,s,o,{keep:n=!1}={}){let a=e.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:n});if(!a)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=a,this.canvas=
e,this.sun=ge(s),this.dark=o,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=Se(a,ei[0],ei[1]),this.body=Se(a,ti[0],ti[1]),this.line=Se(a,si[0],si[1]),this.torus=Xo(
a),this.sphere=Qo(a),this.cylinder=Ms(a,1),this.cone=Ms(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.colors);let r=new Uint8Array(t.flatMap(
l=>[...l,255]));a.pixelStorei(a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,t.length,1,0,a.RGBA,a.UNSIGNED_BYTE,r);for(let l of[a.TEXTURE_WRAP_S,a.TEXTURE_WRAP_T])
a.texParameteri(a.TEXTURE_2D,l,a.CLAMP_TO_EDGE);for(let l of[a.TEXTURE_MIN_FILTER,a.TEXTURE_MAG_FILTER])a.texParameteri(a.TEXTURE_2D,l,a.LINEAR);this.view=Ts(0),
this.eye=[0,0,1],this.fastest=1}begin({background:e,eye:t,target:s,slope:o,angle:n,near:a,far:r}){let{gl:l,canvas:c}=this;l.viewport(0,0,c.width,c.height),l.clearColor(
e[0],e[1],e[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let d=Jo(n,c.width/c.height,a,r);this.view=ks(ks(d,
Zo(t,s)),Ts(o)),this.eye=ge(xs(t,s))}use(e,t){let{gl:s}=this;s.useProgram(e.program);let o={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...t};for(let[
n,a]of Object.entries(o)){let r=e.uniforms[n];r!==void 0&&(typeof a=="number"?s.uniform1f(r,a):a.length===16?s.uniformMatrix4fv(r,!1,a):s[`uniform${a.length}fv`](
r,a))}}ground(e){let{gl:t}=this;t.depthFunc(t.ALWAYS),e(),t.depthFunc(t.LESS)}shadows(e){let{gl:t}=this;t.enable(t.BLEND),t.blendFuncSeparate(t.SRC_ALPHA,t.ONE_MINUS_SRC_ALPHA,
t.ZERO,t.ONE),t.enable(t.STENCIL_TEST),t.stencilFunc(t.EQUAL,0,255),t.stencilOp(t.KEEP,t.KEEP,t.INCR),t.depthFunc(t.ALWAYS),t.depthMask(!1),e(),t.depthMask(!0),
t.depthFunc(t.LESS),t.disable(t.STENCIL_TEST),t.disable(t.BLEND)}solid(e,t,s,{shadow:o=!1,lit:n=!0}={}){let{gl:a}=this;this.use(this.body,{model:t,color:s,shadow:o?
this.dark:0,lit:Number(n)}),Me(a,this.body,e),a.drawElements(a.TRIANGLES,e.count,a.UNSIGNED_SHORT,0)}ball(e,t,s,o){this.solid(this.sphere,_t(e,[0,1,0],t,t),s,{shadow:o})}ring({
center:e,radius:t,tube:s,broad:o,angle:n,velocity:a,omega:r,plain:l=null},c){let{gl:d}=this;this.use(this.rim,{center:e,size:[t,s,o,n],motion:[...a,r],most:this.
fastest,shadow:c?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),Me(d,this.rim,this.torus),d.drawElements(d.TRIANGLES,this.torus.count,d.UNSIGNED_SHORT,0)}rod(e,t,s,o,n,a=!1){
this.solid(this.cylinder,_t(e,t,s,o),n,{shadow:a})}arrow(e,t,s,o,n){if(!(s>.02*o))return;let a=Math.min(.18*o,s),r=e.map((l,c)=>l+t[c]*(s-a));s>a&&this.rod(e,t,
s-a,.029*o,n),this.solid(this.cone,_t(r,t,a,Math.min(.075*o,.6*a)),n)}trace(e,t,s){let o=[];for(let n=0;n<e;n++){let a=t(n),r=t(Math.min(n+1,e-1));if(Math.hypot(
r[0]-a[0],r[1]-a[1])<1e-9&&n>0){let l=t(n-1);r=a.map((c,d)=>2*c-l[d])}for(let l of[-1,1])o.push(...a,0,...r,0,...s(n),l)}return we(this.gl,o,{position:3,next:3,
tint:3,side:1})}drawTrace(e,t,{width:s,distance:o=0,shift:n,depth:a}){let{gl:r,canvas:l}=this;this.use(this.line,{pixel:[2/l.width,2/l.height],width:s,distance:o,
shift:n,depth:a}),Me(r,this.line,e),r.drawArrays(r.TRIANGLE_STRIP,0,2*t)}onScreen([e,t,s]){let o=this.view,[n,a,r]=[0,1,3].map(l=>o[l]*e+o[4+l]*t+o[8+l]*s+o[12+
l]);return r>0?[(.5+.5*n/r)*this.canvas.width,(.5-.5*a/r)*this.canvas.height]:null}};var ia=[.35,.85,.4],na=.18,ai={azimuth:.5,height:.22,distance:5.2},ri=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],Nt=class{constructor(e,t){this.canvas=e,this.onview=t,this.space=new Ct(e,be,ia,na,{keep:!0}),this.floor=Se(this.space.gl,ri[0],ri[1]),this.corners=we(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...ai},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,e.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=H(e,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>e.parentElement})}zoomBy(e){e?this.turned.distance=y(
this.turned.distance/e,1.6,60):this.turned={...ai},this.onview()}drag(e){let t={...this.turned,x:e.clientX,y:e.clientY};C(this.canvas,e,s=>{this.pinched()||(this.
turned.azimuth=y(t.azimuth-(s.clientX-t.x)*.008,-1.5,1.5),this.turned.height=y(t.height+(s.clientY-t.y)*.006,.02,1.45),this.onview())})}quality(){let e=performance.
now(),t=e-(this.before||e);return this.before=e,t>0&&t<200&&(this.pace=.9*this.pace+.1*t),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(e,t,s,o,n,a){let{canvas:r,space:l}=this,c=Math.min(globalThis.devicePixelRatio||1,2)*(a?this.quality():1),d=r.getBoundingClientRect();r.
width=Math.max(Math.round(d.width*c),1),r.height=Math.max(Math.round(d.height*c),1);let u=e.map(w=>w.at(t)),p=e[0].radius;l.fastest=Math.max(...e.map(w=>w.extent.
speed)),this.focus=Number.isFinite(u[0].x)?u[0].x:0,l.begin({background:K(o.paper),...this.camera(e[0],u[0],p,s)}),l.ground(()=>this.drawFloor(p,o));let m=w=>{for(let[
b,g]of e.entries())w(g,u[b],-2.1*p*b)};l.shadows(()=>m((w,b,g)=>this.drawHoop(w,b,g,s,o,n,!0))),m((w,b,g)=>{this.drawHoop(w,b,g,s,o,n,!1),s.traces&&this.drawTraces(
w,b,g,o,n,c),s.forces&&this.drawForces(w,b,g,n)})}camera(e,t,s,o){let{azimuth:n,height:a,distance:r}=this.turned,{left:l,right:c}=e.extent,d=o.whole?Math.max(r*
s,.85*(c-l)+3*s):r*s,[u,p]=[o.whole?.5*(l+c)-this.focus:0,s+.45*(t.height||0)],m=Math.cos(e.slope),w=Math.sin(e.slope),b=[u*m+p*w,-u*w+p*m,0],g=[b[0]+d*Math.sin(
n)*Math.cos(a),b[1]+d*Math.sin(a),d*Math.cos(n)*Math.cos(a)];return this.reach=12*s+3*d,{eye:g,target:b,slope:e.slope,angle:.75,near:.05*s,far:40*s+6*d}}drawFloor(e,t){
let{space:s}=this,o=K(t.ground),n=o.map(l=>l*(t.dark?.82:.94)),a=.5*e,r=this.focus%(2*a);s.use(this.floor,{reach:this.reach,light:o,dark:n,far:K(t.paper),tile:a,
shift:r}),Me(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(e,t,s,o,n,a,r){let{space:l}=this,c=e.radius,d=.045*c,u=[t.x-this.focus,
c+t.height,s];l.ring({center:u,radius:c,tube:d,broad:3.2*d,angle:t.angle,velocity:[t.vx,t.vy],omega:t.omega,plain:o.speed?null:K(a.modes[t.mode])},r);let p=[Math.
sin(t.angle),Math.cos(t.angle),0],m=b=>u.map((g,f)=>g+b*p[f]);l.ball(m(c-d),.125*c,n.dark?[.9,.91,.94]:[.12,.13,.15],r),l.rod(u,p,c-d,.012*c,[.55,.57,.6],r);let w=t.
mode==="H";l.ball(m(e.eccentricity*c),.07*c,K(w?a.airborne:a.gravity_center),r)}drawForces(e,t,s,o){if(t.mode==="H"||!(t.normal_force>0))return;let n=e.radius,a=e.
mass*(e.gravity||9.81),r=[t.x-this.focus,t.height+.03*n,s+.2*n],l=d=>y(.55*n*Math.abs(d)/a,0,3.2*n),c=Math.sign(t.friction_force);this.space.arrow(r,[0,1,0],l(t.
normal_force),n,K(o.normal_force)),this.space.arrow(r,[c,0,0],l(t.friction_force),n,K(o.friction_force))}linesOf(e,t,s){let o=this.lines.get(e);if(o?.dark===t.dark)
return o;let n=e.radius,{x:a,height:r,angle:l,mode:c}=e.columns,d=(b,g)=>this.space.trace(e.length,f=>[a[f]+b*Math.sin(l[f]),n+r[f]+b*Math.cos(l[f])],g),[u,p,m]=[
K(s.gravity_center),K(s.airborne),K(t.ink)],w={dark:t.dark,load:d(n,()=>m),center:d(e.eccentricity*n,b=>c[b]===3?p:u)};return this.lines.set(e,w),w}drawTraces(e,t,s,o,n,a){
let{load:r,center:l}=this.linesOf(e,o,n),c=Math.min(e.index(t.t)+2,e.length),d={shift:this.focus,depth:s};this.space.drawTrace(r,c,{width:a,...d}),this.space.drawTrace(
l,c,{width:1.6*a,...d})}};var aa=["hoop","mode","time","angle","v","R θ̇","gap"],Wt=class{constructor(e,t){this.colors=e,this.onview=t,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1},this.plane=h("canvas",{class:"stage-canvas"}),this.space=h("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new Lt(this.plane,t),this.deep=
null,this.outputs=aa.map(o=>({name:h("dt",{},o),value:h("dd",{})})),this.outputs[1].value.className="mode",this.fastest=h("span",{}),this.legend=h("div",{class:"\
legend","aria-hidden":"true"},h("i",{style:`background: linear-gradient(90deg, ${Ze.filter((o,n)=>n%15===0).join(",")})`}),h("span",{},"0"),h("span",{},"rim spe\
ed"),this.fastest);let s=(o,n)=>h("span",{},h("i",{class:"dot",style:`background:${o}`}),n);this.order=h("span",{hidden:!0},"A in front, B behind"),this.element=
h("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,h("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(
({name:o,value:n})=>[o,n])),this.legend,h("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(e.gravity_center,"centre of gravity"),s(e.airborne,
"the same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(e,t,s,{look:o,inks:n}){let{options:a}=this;this.legend.hidden=!a.
speed,this.order.hidden=!(a.three&&e.length>1),this.fastest.textContent=`≥ ${T(Math.max(...e.map(r=>r.extent.speed)),2)} m/s`,a.three?(this.deep??=new Nt(this.
space,this.onview),this.deep.draw(e,s.time,a,o,n,s.playing)):this.flat.draw(e,s.time,a,o,n),this.read(e,t,s.time)}read(e,t,s){let o=e[t],n=o.at(s),a=[e.length>1?
"AB"[t]:"",k(this.colors.mode_names[n.mode]),`${n.t.toFixed(3)} s`,P(n.angle),_(T(n.vx,3),"m/s"),_(T(n.omega*o.radius,3),"m/s"),n.height>0?re(n.height):"0"];for(let[
c,d]of a.entries()){let{value:u}=this.outputs[c];u.textContent!==d&&(u.textContent=d)}let[r,l]=this.outputs;r.value.hidden=r.name.hidden=e.length<2,l.value.style.
setProperty("--mode",this.colors.modes[n.mode])}describe(e){let t=e.map(s=>s.summary).join(" ");this.element.setAttribute("aria-label",`${k("The hoop.")} ${t}`)}turn(e){
let t=()=>{this.plane.hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,t();try{e()}catch(s){throw this.options.
three=!1,t(),s}}zoom(e){this.options.three?this.deep?.zoomBy(e):e?this.flat.zoomBy(e):this.flat.reset()}};var qt=class{film;items;current;constructor(e){this.clock=e,this.summary=h("p",{class:"summary"}),this.list=h("ol",{class:"story-list"}),this.heading=h("h2",{},
"What happens"),this.live=h("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=h("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(e,t,s){this.film=e[t],M(this.heading,e.length>1?`What happens to hoop ${"AB"[t]}`:"What happens"),this.summary.
replaceChildren(...e.flatMap((o,n)=>[e.length>1?h("b",{},`${"AB"[n]}: `):"",o.summary,o.status==="event_limit"||o.shortened?" (not all events are shown)":"",n+1<
e.length?h("br"):""])),this.items=this.film.story.map(o=>h("li",{},h("button",{type:"button",onclick:()=>this.clock.seek(o.t)},h("i",{class:"dot",style:`backgro\
und:${s.modes[o.mode]}`,"aria-hidden":"true"}),h("span",{class:"when"},`${T(o.t,4)} s`),h("span",{},o.text)))),this.list.replaceChildren(...this.items),this.current=
-1,this.cursor(this.clock.time)}say(e){M(this.live,e)}announce(e){this.say(se(e.map(t=>t.summary).join(" ")))}cursor(e){let{story:t}=this.film,s=-1;for(let n=0;n<
t.length&&t[n].t<=e+1e-9;n++)s=n;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),this.items[this.
current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let o=this.items[s];if(o){let n=o.offsetTop-this.list.
offsetTop;(n<this.list.scrollTop||n+o.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=n-.4*this.list.clientHeight)}}},Dt=class{constructor(){
this.list=h("dl",{}),this.heading=h("h2",{},"What theory says"),this.element=h("section",{class:"theory"},this.heading,this.list)}draw(e,t=""){M(this.heading,t?
`What theory says of hoop ${t}`:"What theory says"),this.list.replaceChildren(...e.flatMap(({label:s,text:o})=>[h("dt",{},s),h("dd",{},o)]))}};var li="hophoop-theme",ra=["gravity_center","airborne","normal_force","friction_force"],Ft=class{constructor(e,t,s,o){this.root=e,this.colors=t,this.hosted=s,this.
changed=o,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=Zt(e),this.inks={...t},this.read()}mark(){let e=this.hosted?V(li):null;this.root.dataset.theme=this.chosen??e??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=Zt(this.root),this.inks={...this.colors};for(let e of ra)
this.inks[e]=Le(this.colors[e],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&Y(li,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};var jt={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns back",apex:"hi\
ghest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"jam",kane_gain:"\
energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},hi=i=>i.kind==="takeoff"||i.to==="H"&&i.from!=="H"&&i.kind!=="impact";var Ke={jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"\
↺",apex:"•"},Bt=Object.keys(Ke);function ci(i,e=11){let s=[...i.filter(({kind:n})=>n in Ke)].sort((n,a)=>Bt.indexOf(n.kind)-Bt.indexOf(a.kind)||n.x-a.x),o=[];
for(let{kind:n,x:a}of s){let r=Bt.indexOf(n)<Bt.indexOf("takeoff"),l=o.filter(c=>Math.abs(c.x-a)<e);l.length?l.length===1&&l[0].rare&&!o.some(c=>Math.abs(c.x-(l[0].
x+e))<e-1e-9)?l[0].mark!==Ke[n]&&o.push({mark:Ke[n],x:l[0].x+e,rare:!1,hidden:0}):l[0].hidden+=1:o.push({mark:Ke[n],x:a,rare:r,hidden:0})}return o.sort((n,a)=>n.
x-a.x).map(({mark:n,x:a})=>({mark:n,x:a}))}function di(i,e,t){let s=[],o=new Map,n=-1,a=(l,c,d)=>{let u=s.at(-1);u&&u.mode===l&&Math.abs(u.from+u.wide-c)<1e-6?u.
wide+=d:s.push({mode:l,from:c,wide:d})},r=()=>{o.size&&a([...o].reduce((l,c)=>c[1]>l[1]?c:l)[0],n,1),o=new Map};for(let{mode:l,from:c,to:d}of i){let[u,p]=[Math.
max(e(c),0),Math.min(e(d),t)];if(p>u)for(let m=u;m<p-1e-9;){if((Math.floor(m+1e-9)!==n||!o.size)&&(r(),n=Math.floor(m+1e-9),p-m>=1&&Math.abs(m-n)<1e-6)){let b=Math.
floor(p-m+1e-9);a(l,n,b),m=n+b;continue}let w=Math.min(p,n+1);o.set(l,(o.get(l)??0)+w-m),m=w}}return r(),s}var Ot=class{films;said;constructor(e){this.clock=e,this.window=null,this.canvas=h("canvas",{class:"timeline-canvas"}),this.tip=h("div",{class:"tip",hidden:!0}),
this.element=h("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),
this.element.addEventListener("pointerdown",t=>this.scrub(t)),this.element.addEventListener("pointermove",t=>this.hover(t)),this.element.addEventListener("point\
erleave",()=>this.tip.hidden=!0),this.pinched=H(this.element,{zoom:(t,s)=>this.zoom(1/t,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let e=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=e[1]?e:fe(this.window,e)}zoom(e,t){let[s,o]=this.ends(),n=1e-6*this.clock.duration,
a=Math.max((o-s)*e,n),r=(t-s)/(o-s);this.window=a<this.clock.duration?fe([t-r*a,t+(1-r)*a],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[e,t]=this.ends(),{time:s,duration:o}=this.clock;if(s>=e&&s<=t)return;let n=t-e;this.window=fe(s>t?[s-.1*n,s+.9*n]:[s-.5*n,s+.5*n],[0,o])}timeAt(e){let t=this.
canvas.getBoundingClientRect(),[s,o]=this.ends();return s+y((e.clientX-t.left)/t.width,0,1)*(o-s)}scrub(e){e.preventDefault(),this.element.focus({preventScroll:!0});
let t=this.clock.playing;this.clock.playing=!1;let s=o=>!this.pinched()&&this.clock.seek(this.timeAt(o));s(e),C(this.element,e,s,()=>t&&this.clock.play(!0))}hover(e){
let t=this.timeAt(e),s=this.nearest(t,8),o=s?`${k(jt[s.kind]??s.kind)} · ${T(s.t,5)} s · ${T(s.angle*180/Math.PI,4)}°`:`${T(t,4)} s`;this.tip.textContent=o,this.
tip.hidden=!1;let n=this.canvas.getBoundingClientRect();this.tip.style.left=`${y(e.clientX-n.left,70,n.width-70)}px`}nearest(e,t){let[s,o]=this.ends(),n=t*(o-s)/
(this.canvas.getBoundingClientRect().width||1),a=null;for(let r of this.films??[])for(let l of r.events){if(l.kind==="end")continue;let c=Math.abs(l.t-e);c<=n&&
(!a||c<Math.abs(a.t-e))&&(a=l)}return a}draw(e,t,s){this.films=e;let{context:o,width:n,height:a}=I(this.canvas);this.keep();let[r,l]=this.ends(),c=g=>(g-r)/(l-r)*
n;o.clearRect(0,0,n,a);let d=15,u=(a-15)/e.length-d;e.forEach((g,f)=>{let x=d+f*(d+u);for(let{mode:S,from:E,wide:R}of di(g.phases,c,n)){let z=s.modes[S];o.fillStyle=
z,o.fillRect(E,x,R,u-2),this.named(o,k(s.mode_names[S]),E,R,x,u-2,z,t)}g.duration<l&&(o.fillStyle=t.line,o.fillRect(Math.max(c(g.duration),0),x,n,u-2)),this.marks(
o,g,c,x,n,t),e.length>1&&(o.fillStyle=G(f,t.dark),o.font=`700 12px ${t.font}`,o.textAlign="right",o.fillText("AB"[f],n-1,x-4))});let p=F(l-r,n/60);o.fillStyle=t.
soft,o.font=`10.5px ${t.font}`;let m=U(r,l,n/60);for(let g of m){let f=c(g);o.textAlign=f<14?"left":f>n-14?"right":"center",o.fillText(O(g,p)+(g===m[0]?" s":""),
f,a-3)}let w=y(c(this.clock.time),6,n-6),b=y(c(this.clock.time),1,n-1);o.fillStyle=t.ink,o.fillRect(b-1,d-4,2,a-d-9),o.beginPath(),o.moveTo(w-6,d-10),o.lineTo(w+
6,d-10),o.lineTo(b,d-1),o.fill(),this.tell(e,s)}tell(e,t){let{time:s,duration:o,playing:n}=this.clock,r=e.map((l,c)=>{let d=k(t.mode_names[l.at(s).mode]);return e.
length>1?`${"AB"[c]} ${d}`:d}).join(", ");n&&r===this.said||(this.said=r,this.element.setAttribute("aria-valuemax",o.toFixed(3)),this.element.setAttribute("aria\
-valuenow",s.toFixed(3)),this.element.setAttribute("aria-valuetext",k("{time} seconds, {what}",{time:T(s,4),what:se(r)})))}named(e,t,s,o,n,a,r,l){e.font=`11px ${l.
font}`,!(a<13||e.measureText(t).width+8>o)&&(e.fillStyle=Ds(r),e.textAlign="center",e.textBaseline="middle",e.fillText(t,s+.5*o,n+.5*a+1),e.textBaseline="alphab\
etic")}marks(e,t,s,o,n,a){e.font=`11px ${a.font}`,e.textAlign="center";let r=t.events.filter(({kind:l})=>l!=="start"&&l!=="end").map(({kind:l,t:c})=>({kind:l,x:s(
c)})).filter(({x:l})=>l>=-1&&l<=n+1);if(e.fillStyle=a.panel,r.length<n/6)for(let{x:l}of r)e.fillRect(l-.5,o,1,5);e.fillStyle=a.ink;for(let{mark:l,x:c}of ci(r))e.
fillText(l,y(c,6,n-6),o-4)}};var la=1/60,ha=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],ca={three:"In space"},de=(i,e,t)=>h(
"button",{type:"button",title:e,"aria-label":e,onclick:t},i),ui=(i,e)=>h("span",{},h("span",{"aria-hidden":"true"},`${i} `),e),Ht=class{titled="";constructor(e,t,s,o,n){
this.clock=e,this.films=t,this.say=o,this.tell=n,this.playButton=de(N("play"),"Play (space)",()=>e.play()),this.playButton.classList.add("play"),this.speeds=h("\
select",{"aria-label":"Speed of the film",onchange:()=>{e.speed=Number(this.speeds.value)}},qe.map(a=>h("option",{value:String(a)},`${a}×`))),this.speeds.value=
"1",this.switches=new Map(ha.map(([a,r,l])=>{let c=`${a==="three"?ca.three:r} (${l})`;return[a,h("button",{type:"button",class:"switch",title:c,onclick:()=>s(a)},
r)]})),this.element=h("div",{class:"transport"},h("div",{class:"buttons"},de(N("start"),"To the start (Home)",()=>e.seek(0)),de(N("previous"),"Previous event (S\
hift ←)",()=>this.jump(-1)),de(N("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,de(N("on"),"One frame on (→)",()=>this.nudge(1)),de(N("n\
ext"),"Next event (Shift →)",()=>this.jump(1))),h("div",{class:"buttons jumps"},de(ui("▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),de(
ui("▼","landing"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,h("div",{class:"buttons switches"},[...this.switches.values()]))}show(e){let{
clock:t,playButton:s}=this;for(let[n,a]of this.switches)a.setAttribute("aria-pressed",String(e[n]));let o=t.playing?"Pause (space)":"Play (space)";this.titled!==
o&&(this.titled=o,s.replaceChildren(N(t.playing?"pause":"play")),We(s,"title",o),We(s,"aria-label",o)),this.speeds.value!==String(t.speed)&&(this.speeds.value=String(
t.speed))}nudge(e){this.clock.playing=!1,this.clock.seek(this.clock.time+e*la*Math.min(this.clock.speed,1))}jump(e,t=null){this.clock.playing=!1;let s=this.films().
flatMap((c,d)=>c.events.map(u=>({event:u,lane:d}))).filter(({event:c})=>!t||(t==="impact"?c.kind===t:hi(c))).sort((c,d)=>c.event.t-d.event.t),o=this.clock.time,
n=e>0?s.find(({event:c})=>c.t>o+1e-9):s.findLast(({event:c})=>c.t<o-1e-9);if(!n&&t&&(n=s[0]),!n){t&&this.say(t==="takeoff"?"This motion has no flight.":"This mo\
tion has no landing.");return}this.clock.seek(n.event.t);let{event:a,lane:r}=n,l=this.films().length>1?`${k(`Hoop ${"AB"[r]}`)}: `:"";this.tell(`${l}${k("{what}\
 at {angle}, {time} s",{what:k(jt[a.kind]??a.kind),angle:P(a.angle),time:T(a.t,4)})}`)}};var Ee=class{constructor(e,t,s,{hosted:o=!1,panels:n=null,onmotion:a=()=>{}}={}){this.root=e,this.backend=t,this.hosted=o,this.onmotion=a,this.prepareRoot();let{
colors:r}=s;this.known=s.presets,this.address=o?new tt(this):null,this.clock=new st,this.motions=new Et(t,{shown:l=>this.changed(l),refined:()=>this.request(),settled:()=>this.
story.announce(this.films()),noted:l=>this.noted(l),travelled:async l=>this.address?.travel(l),failed:(l,c)=>this.failed(l,c)}),this.notice=new At,this.theme=new Ft(
e,r,o,()=>this.show()),this.stage=new Wt(r,()=>{this.request(),this.address?.soon()}),this.transport=new Ht(this.clock,()=>this.films(),l=>this.toggle(l),l=>this.
notice.say(l),l=>this.story.say(l)),this.timeline=new Ot(this.clock),this.story=new qt(this.clock),this.theory=new Dt,this.plots=new Rt(this.clock,r),this.phase=
new zt(t,this.clock,r),this.map=new St(t,s,{take:l=>{this.clock.time=0,this.motions.change(l,!0)},say:l=>this.story.say(l),changed:()=>this.address?.soon()}),this.
controls=new nt(s.controls,(l,c)=>this.motions.change(l,c)),this.share=new Pt(this),this.singleKeys=new vt(o),this.help=zo(s.version,r,this.singleKeys.element),
this.hoops=new yt(l=>this.motions.choose(l)),this.header=new bt(s.presets,this.share.menu,{take:l=>this.take(l),undo:()=>this.travel(-1),redo:()=>this.travel(1),
compare:()=>this.motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(n),this.extras=new wt(this),this.requested=!1,this.
surrounding=!1,this.taken=null,this.afterFrame=null,this.asked=null,this.later=J(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=this.frame.
bind(this),this.clock.listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=Po(this,o),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){
this.root.classList.add("hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts=
"true")}layOut(e){let{root:t,notice:s}=this,o=d=>!e||e.includes(d),n=h("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.
element),a=h("div",{class:"player"},this.stage.element,this.timeline.element,this.transport.element);this.sticky=this.hosted?Vo(a,()=>this.request()):null;let r=h(
"a",{class:"skip button",href:"#hh-player"},"Skip to the player");r.onclick=d=>{d.preventDefault(),this.timeline.element.focus()};let l=h("div",{class:"middle"},
this.sticky?.edge,a,h("div",{class:"words"},this.story.element,o("theory")&&this.theory.element),o("map")&&this.map.element),c=h("div",{class:"why"},o("plots")&&
this.plots.element,o("plots")&&this.phase.element);t.replaceChildren(h("div",{class:"page"},this.hosted&&r,this.header.element,h("div",{class:"columns"},o("cont\
rols")&&n,l,c)),s.toast,this.share.dialog,this.help),t.classList.toggle("no-controls",!o("controls"))}async open(e,t={}){await this.motions.load(e),this.clock.duration=
Math.max(...this.films().map(s=>s.duration)),this.restore(t),this.begin()}begin(){this.show(),this.motions.note(),this.sizes.observe(this.stage.element),this.root.
dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.map.close(),this.theme.close(),this.address?.close(),this.sticky?.
close(),this.sizes.disconnect(),this.deaf()}film(e=this.motions.active){return this.motions.film(e)}films(){return this.motions.films()}changed(e=null){this.notice.
clear(),this.show(e)}failed(e,t=[]){this.controls.refuse(t,e.message)||(this.notice.fail(e),this.controls.restore()),this.showPreset()}noted(e){this.header.show(
this.motions.history,this.motions.lanes.length>1),this.address?.write(e),this.onmotion(this.film().query)}link(){let{clock:e,stage:t,map:s}=this;return this.motions.
link(so({time:e.time,options:t.options,zoom:t.flat.zoom,map:s.shown()}))}restore({time:e,options:t,zoom:s,map:o}){if(t){let{three:n,...a}=t;Object.assign(this.stage.
options,a),n&&this.toggle("three")}s&&(this.stage.flat.zoom=s),o&&this.map.restore(o),e&&this.clock.seek(e)}showPreset(){let{query:e}=this.film(),t=this.known.find(
s=>s.query===e);this.header.presets.value=t?.key??"",M(this.hoops.text,t?.text??"")}async take(e){this.taken=e;try{let t=await this.backend.call("film",{query:e.
query});if(this.taken!==e)return;this.clock.time=0,this.motions.replace(t),this.story.announce(this.films())}catch(t){this.failed(t)}}travel(e){return this.motions.
travel(e)}show(e=null){let{motions:t,clock:s}=this,o=this.films();if(!o.length)return;let n=o.length>1;this.theme.read(),s.duration=Math.max(...o.map(a=>a.duration)),
s.time=Math.min(s.time,s.duration),this.root.classList.toggle("two",n),this.header.show(t.history,n),this.hoops.show(o.length,t.active),this.drawStage(),this.controls.
show(this.film(),this.motions.waiting()),this.showPreset(),e!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-e),0)),this.
surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let e=this.films(),
{active:t}=this.motions,{look:s,colors:o}=this.theme;this.plots.draw(e,t,s),this.phase.draw(e,t,s),this.story.draw(e,t,o),this.drawTime(),this.map.mark(this.film(),
s),this.stage.describe(e),this.extras.changed(),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{
time:e}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(e),this.phase.cursor(e),this.story.cursor(
e),this.transport.show(this.stage.options))}request(){this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(e){this.requested=!1,this.motions.
lanes.length&&(this.clock.tick(e),this.motions.refine(this.clock.time,this.clock.playing?2*this.clock.speed:0),this.drawStage(),this.drawTime(),this.extras.frame(),
this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){let{scenario:e}=this.film();this.asked?.abort(),this.asked=new AbortController;
let{signal:t}=this.asked;try{let s=await this.backend.call("theory",{scenario:e},t);this.theory.draw(s.header.thresholds,this.motions.name()),await this.phase.fetch(
e,t)}catch(s){let{name:o,message:n}=s;o!=="AbortError"&&this.theory.draw([{label:"–",text:n}])}}toggle(e){let{options:t}=this.stage;if(e!=="three")t[e]=!t[e];else
try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}this.transport.show(t),this.address?.soon(),this.request()}};var Es=class extends Error{},As=class{constructor(e,t){this.start=e,this.compiled=t,this.number=0,this.waiting=null,this.worker=this.begun()}begun(){let e=this.
start();return e.onmessage=({data:t})=>{if(t.number!==this.number||!this.waiting)return;let{resolve:s,reject:o}=this.waiting;this.waiting=null,t.error?o(new Error(
t.error)):s(t.answer)},e.onerror=t=>this.fail(new Error(t.message||"The kernel could not be started.")),e.postMessage({compiled:this.compiled}),e}fail(e){this.waiting?.
reject(e),this.waiting=null}stop(e){this.worker.terminate(),this.worker=this.begun(),this.fail(e)}ask(e,t,s){this.number++;let o=new Promise((n,a)=>{this.waiting=
{resolve:n,reject:a}});return this.worker.postMessage({number:this.number,call:e,values:t},s),o}},Ge=class{constructor(e,t,s,o){this.start=e,this.compiled=t,this.
size=s,this.limit=o,this.idle=[],this.hired=0,this.queue=[]}hand(){let e=this.idle.pop();return e?Promise.resolve(e):this.hired<this.size?(this.hired++,Promise.
resolve(new As(this.start,this.compiled))):new Promise(t=>this.queue.push(t))}release(e){let t=this.queue.shift();t?t(e):this.idle.push(e)}async ask(e,t,s,o=[]){
s?.throwIfAborted();let n=await this.hand(),a=()=>n.stop(new DOMException("superseded","AbortError")),r=setTimeout(()=>n.stop(new Es(`This takes longer than ${this.
limit/1e3} s, and was stopped.`)),this.limit);try{return s?.throwIfAborted(),s?.addEventListener("abort",a),await n.ask(e,t,o)}finally{clearTimeout(r),s?.removeEventListener(
"abort",a),this.release(n)}}close(){for(let e of this.idle)e.worker.terminate()}};var v={sources:"3139167f05f885e0d904e890c18e0282",module:"ea38310512919946",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring",
"damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy",
"omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain",
"collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_norm\
al","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],compliant:["law","friction_law","stiffness","damping","rest\
itution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","bristle"],chosen:["stiffness","tangen\
tial_stiffness","slip_speed","depth","steps","stiffness_si","slip_speed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_fric\
tion","needed_friction_angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","m\
assless_loss_by_friction"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","t\
akeoff_time","takeoff_angle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","\
hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{
angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,
status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,
takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undet\
ermined","event_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stic\
k","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:[
"no","yes"],painleve:["no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start",
"slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","\
rest","end"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var Ae=i=>Object.fromEntries(i.map((e,t)=>[e,t])),rd=Ae(v.cell),ne=Ae(v.heads),D=Ae(v.events),zs=Ae(v.samples),pi=Ae(v.numbers),Rs=Ae(v.words),ua={newton:0,poisson:1,
stronge:2};function ze(i){let e=new Float64Array(v.cell.length),t={...Object.fromEntries(Object.entries(i).filter(([,s])=>typeof s=="number")),law:ua[i.impact_law],
strike:+(i.painleve==="impact"),ideal:Number(i.ideal),allowed:1};return v.cell.forEach((s,o)=>{e[o]=t[s]??0}),e}function Ps(i){let e=t=>t??Number.NaN;return Float64Array.
of(v.laws.indexOf(i.law),v.friction_laws.indexOf(i.friction),e(i.stiffness),e(i.damping),e(i.restitution),e(i.slip_speed),e(i.tangential_stiffness),e(i.rtol))}var $t=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var pa=150,ma=240,fa=6e3,[dd,mi,fi]=[0,1,2],ga={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["fri\
ction_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_norm\
al","damping"],utilization:["utilization"]};function Ls(i,e,t){let{rows:s,count:o,duration:n}=e,[a,r]=(t??[0,n]).map(g=>Math.min(Math.max(g,0),n)),l=Math.min(Math.
max(Math.ceil((r-a)*pa),ma),fa),c=v.events.length,d=new Set;for(let g=0;g<=l&&n>0;g++)d.add(g===l?r:a+g*((r-a)/l));let u=new Set;for(let g=0;g<o;g++){let f=Math.
min(s[g*c+D.t],n);f>=a&&f<=r&&u.add(f)}for(let g of u)d.add(g);let p=Float64Array.from(d).sort(),m=Float64Array.from(u).filter(g=>g>0).sort(),w=i.states(e,p,!1),
b=i.states(e,m,!0);return wa(p,w,m,b)}function wa(i,e,t,s){let o=i.length+t.length,n=v.samples.length,a=new Float64Array(o),r=new Float64Array(o*n),l=0,c=0;for(let u=0;u<
i.length;u++)c<t.length&&t[c]<=i[u]&&(a[l]=t[c],r.set(s.subarray(c*n,(c+1)*n),l*n),l++,c++),a[l]=i[u],r.set(e.subarray(u*n,(u+1)*n),l*n),l++;let d={t:a};for(let[
u,p]of Object.entries(ga)){let m=new Float64Array(o);for(let w of p)for(let b=0;b<o;b++)m[b]+=r[b*n+zs[w]];d[u]=m}return d.mode=ba(r,o,d.omega),d}function ba(i,e,t){
let s=v.samples.length,o=new Float64Array(e),n=0;for(let a=e-1;a>=0&&!n;a--)n=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){n=Math.sign(t[a])||n;let r=i[a*s+zs.mode],
l=r===mi?-1:r===fi?1:0;o[a]=l===0?r:l*n<0?mi:fi}return o}function gi(i,e){let t=new Map,s=new Float64Array(e);for(let o=0;o<e;o++){let n=ya(i.subarray(o*v.keys,(o+1)*v.keys));if(n===""){s[o]=Number.NaN;continue}let a=t.
get(n);a===void 0&&(a=t.size,t.set(n,a)),s[o]=a}return{values:s,sequences:[...t.keys()]}}function ya(i){let e="";for(let t of i){let s=t;for(let o=0;o<v.letters_a_key&&
s;o++){let n=Number(s&7n);s>>=3n,n&&(e+=n===v.more?"+":v.letters[n-1])}}return e}var va=256,ka=2048,xa=4096,Ta=2e5,Sa=v.statuses.indexOf("buffer"),Ma=new Set(["turn","apex","kane_gain","rest"]),Is=i=>Number.isFinite(i)?i:null,Ut=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new $t(this.exports),this.mostEvents=va,this.mostSegments=ka,this.mostRows=
xa}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=v.events.length;for(;;){let o=t.
room("table",8*s*this.mostEvents),n=t.room("heads",8*v.heads.length);e.contact?this.computeCompliant(e,e.contact,o,n):this.computeRigid(e,o,n);let a=t.floats(n,
v.heads.length).slice(),r=a[ne.events];if(a[ne.status]===Sa)this.makeRoom(e,a[ne.segments]);else if(r===this.mostEvents&&r<e.max_events)this.mostEvents*=4;else{
let l=t.floats(o,r*s).slice();return{given:e,head:a,rows:l,count:r,duration:a[ne.duration],segments:a[ne.segments]}}}}computeRigid(e,t,s){let{memory:o}=this,n=o.
put("cell",ze(e)),a=o.room("events",v.event_bytes*this.mostEvents),r=o.room("segments",v.segment_bytes*this.mostSegments);this.call("motion",n,a,this.mostEvents,
r,this.mostSegments,t,s)}computeCompliant(e,t,s,o){let{memory:n}=this,a=n.put("cell",ze(e)),r=n.put("contact",Ps(t)),l=n.room("events",v.event_bytes*this.mostEvents),
c=n.room("rows",v.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,r,l,this.mostEvents,Ta,c,this.mostRows,s,o)}makeRoom(e,t){e.contact?this.
mostRows=t:this.mostSegments*=4}motion(e){return wi(this.compute(e))}film(e){let t=this.compute(e);return{motion:wi(t),columns:Ls(this,t)}}columns(e,t){return Ls(
this,this.compute(e),t)}samples(e,t){let s=this.states(this.compute(e),t,!1),o=v.samples.length;return Object.fromEntries(v.samples.map((n,a)=>[n,Float64Array.from(
t,(r,l)=>s[l*o+a])]))}states(e,t,s){let{memory:o}=this,n=t.length*v.samples.length,a=o.put("times",t),r=o.room("states",8*Math.max(n,1)),l=o.room("cell",8),c=[e.
segments,a,t.length,Number(s),r];return e.given.contact?this.call("compliant_samples",l,o.room("contact",8),o.room("rows",8),...c):this.call("samples",l,o.room(
"segments",8),...c),o.floats(r,n).slice()}thresholds(e){let{memory:t}=this,s=t.put("cell",ze(e)),o=t.room("answers",8*v.thresholds.length),n=e.rolling&&e.angle===
0;this.call("thresholds",s,n?e.vx:Number.NaN,o);let a=t.floats(o,v.thresholds.length),r=c=>{let d=a[v.thresholds.indexOf(c)];return Number.isNaN(d)?null:d},l=["\
jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(r);return{first_slip_speed:r("first_slip_speed"),first_hop_speed:r("first_hop_speed"),immediate_hop_speed:r(
"immediate_hop_speed"),needed_friction:r("needed_friction"),painleve_friction:r("painleve_friction"),painleve_angle:r("painleve_angle"),jam_angles:l.filter(c=>c!==
null),stable_angle:r("stable_angle"),massless_loss_angle:r("massless_loss_angle"),massless_loss_by_friction:r("massless_loss_by_friction")===1}}regions(e,[t,s,o,
n],a,r){let{memory:l}=this,c=l.put("cell",ze(e)),d=l.room("modes",a*r),u=l.room("sides",a);this.call("regions",c,t,s,o,n,a,r,d,u);let{buffer:p}=this.exports.memory;
return{modes:new Uint8Array(p,d,a*r).slice(),paradox:Float32Array.from(new Int8Array(p,u,a))}}map({count:e,rows:t},s,o){let{memory:n}=this,a=n.put("cells",t),r=n.
room("numbers",8*e*v.numbers.length),l=n.room("words",4*e*v.words.length),c=n.room("keys",8*e*v.keys),{angle:d,stop:u,timed:p}=v.spans[o],m=v.wanted[s];this.call(
"map_cells",a,e,d??Number.NaN,u,p,m,r,l,c);let{buffer:w}=this.exports.memory;if(s==="sequence")return gi(new BigUint64Array(w,c,e*v.keys),e);let b=new Float64Array(
e);if(s in Rs){let g=new Int32Array(w,l,e*v.words.length);for(let f=0;f<e;f++)b[f]=g[f*v.words.length+Rs[s]]}else{let g=n.floats(r,e*v.numbers.length);for(let f=0;f<
e;f++)b[f]=g[f*v.numbers.length+pi[s]]}return{values:b}}ideal(e){let t=this.memory.room("answers",8*v.thresholds.length);return this.call("ideal_hoop",e,t),this.
memory.floats(t,1)[0]}combine(e,t){let{memory:s}=this,o=s.put("parts",t.flatMap(Ea)),n=s.room("answers",8*v.thresholds.length),a=s.room("reaches",8*t.length);this.
call("hoop_of_parts",e,o,t.length,n,a);let[r,l,c]=s.floats(n,3);return{mass:r,eccentricity:l,inertia_ratio:c,reaches:[...s.floats(a,t.length)]}}compliance(e){let{
memory:t}=this;if(!e.contact)throw new TypeError("The contact is rigid.");let s=t.put("cell",ze(e)),o=t.put("contact",Ps(e.contact)),n=t.room("answers",8*v.thresholds.
length);this.call("compliance",s,o,n);let a=t.floats(n,v.chosen.length),r=l=>a[v.chosen.indexOf(l)];return{stiffness:r("stiffness"),tangential_stiffness:r("tang\
ential_stiffness"),slip_speed:r("slip_speed"),depth:r("depth"),steps:r("steps"),automatic:{stiffness:r("stiffness_si"),slip_speed:r("slip_speed_si")}}}};function Ea(i){
let e=i.shape==="rod"?`${i.direction}_rod`:i.shape,t=v.shapes.indexOf(e);return i.shape==="ring"?[t,i.mass,i.inner_radius,i.outer_radius,0]:i.shape==="disk"?[t,
i.mass,i.radius,0,i.at]:i.shape==="rod"?[t,i.mass,i.length,0,i.at]:[t,i.mass,0,0,i.at]}var Aa=["friction","impact_normal","impact_tangential","rolling_resistanc\
e"],za=["kinetic","potential",...Aa,"residual"],bi=["x","height","angle","vx","vy","omega"];function wi({given:i,head:e,rows:t,count:s,duration:o}){let n=v.events.
length,a=Array.from({length:s},(c,d)=>Ra(t.subarray(d*n,(d+1)*n))),r=a[s-1],l=Object.fromEntries([...za,...i.contact?["spring","damping"]:[]].map(c=>[c,e[ne[c]]]));
return{status:v.statuses[e[ne.status]],sequence:Pa(a),duration:o,events:a,final:{t:r.t,mode:r.to,...Object.fromEntries(bi.map(c=>[c,r[c]]))},energy:l,doubt:Is(e[ne.
doubt_from])}}function Ra(i){let e=v.kinds[i[D.kind]],t=i[D.from_mode],s={t:i[D.t],kind:e,from:t<0?null:v.letters[t],to:v.letters[i[D.to_mode]]};for(let o of bi)
s[o]=Is(i[D[o]]);return s.before=Object.fromEntries(["vx","vy","omega"].map(o=>[o,Is(i[D[`before_${o}`]])])),s.impulse={normal:i[D.impulse_normal],tangential:i[D.
impulse_tangential]},i[D.collision]===0&&(s.collision=!1),e==="kane_gain"&&(s.gain=i[D.gain]),i[D.stable]>=0&&(s.stable=i[D.stable]===1),s}function Pa(i){let e=i.
filter(s=>!Ma.has(s.kind));return e.slice(0,-1).map((s,o)=>e[o+1].t>s.t?s.to:"").join("")||(i.at(-1)?.to??"")}var yi=1e4,_s=256;function vi(i){let e=URL.createObjectURL(new Blob([i],{type:"text/javascript"}));return()=>new Worker(e,{type:"module"})}var Ve=class i{constructor(e,t){
this.mechanics=new Ut(e),this.motions=new Ge(t,e,2,yi);let s=navigator.hardwareConcurrency||2;this.maps=new Ge(t,e,Math.max(1,Math.min(s-1,8)),yi)}static async load(e){
let t=new URL(`hophoop.wasm?${v.module}`,e),s=await fetch(t);if(!s.ok)throw new Error(`The kernel is not there: ${t.pathname} gives ${s.status}.`);let n=await(s.
headers.get("Content-Type")==="application/wasm"?WebAssembly.compileStreaming(s):WebAssembly.compile(await s.arrayBuffer())),a=new URL(`kernel.js?${v.module}`,e);
return a.origin===globalThis.location?.origin?new i(n,()=>new Worker(a,{type:"module"})):new i(n,vi(await(await fetch(a)).text()))}static async unpack(e,t){let s=new Blob(
[e]).stream().pipeThrough(new DecompressionStream("gzip")),o=await WebAssembly.compile(await new Response(s).arrayBuffer());return new i(o,vi(t))}motion(e,t){return this.
motions.ask("motion",[e],t)}film(e,t){return this.motions.ask("film",[e],t)}columns(e,t,s){return this.motions.ask("columns",[e,s],t)}samples(e,t,s){return this.
motions.ask("samples",[e,t],s)}thresholds(e,t){return this.motions.ask("thresholds",[e],t)}regions(e,t,s,o,n){return this.motions.ask("regions",[e,t,s,o],n)}async map({
count:e,rows:t},s,o,n){let a=v.cell.length,r=new Float64Array(e).fill(Number.NaN),l=[],c=async u=>{let p=Math.min(_s,e-u),m=new Float64Array(a*p);for(let g=0;g<
a;g++)m.set(t.subarray(g*e+u,g*e+u+p),g*p);let w=await this.maps.ask("map",[{count:p,rows:m},s,o],n,[m.buffer]),b=w.sequences?.map(g=>(l.includes(g)||l.push(g),
l.indexOf(g)));for(let g=0;g<p;g++)r[u+g]=b?b[w.values[g]]??Number.NaN:w.values[g]},d=Array.from({length:Math.ceil(e/_s)},(u,p)=>p*_s);return await Promise.all(
d.map(c)),s==="sequence"?{values:r,sequences:l}:{values:r}}close(){this.motions.close(),this.maps.close()}};var Ye=class{constructor(){throw new Error("not yet")}};async function Cs(i,e,t){let s=e&&new kt(e);try{let o=await Ve.load(i);return new Ye(o,o.mechanics,{base:t,server:s})}catch(o){if(s)return s;throw o}}function ki(i){
navigator.serviceWorker?.register(i).catch(()=>{})}async function xi(i){let e=new xt(i);try{let t=await Ve.unpack(i.get("module"),i.get("worker"));return new Ye(
t,t.mechanics,{server:e})}catch{return e}}var La=new URL("./",import.meta.url);async function Ia(i){let e=new URL("./",document.baseURI.split(/[?#]/)[0]),t=document.querySelector("meta[name=hophoop-site\
]"),s,o;try{s=await Cs(La,t?null:e,e),o=(await s.call("setup",{})).header}catch(l){i.textContent=l.message;return}t&&ki(t.getAttribute("content")??"");let n=new Ee(
i,s,o,{hosted:!0});Object.assign(globalThis,{hophoopLab:n});let a=new URLSearchParams(location.hash.slice(1)).get("with"),r=oo(location.hash);try{await n.open([
location.search.slice(1),...a===null?[]:[a]],r)}catch(l){history.replaceState(null,"",e),await n.open([""]),n.notice.fail(l)}}async function _d(i,e,t,s){let o=await Cs(
e,null,new URL("../",e)),{header:n}=await o.call("setup",{}),a=new Ee(i,o,n,{panels:s});return await a.open([t]),a}async function _a({model:i,el:e}){let t=document.
createElement("div");e.append(t);let s=await xi(i),o=new Ee(t,s,i.get("setup"),{panels:i.get("panels"),onmotion:a=>{i.get("query")!==a&&(i.set("query",a),i.save_changes())}});
o.motions.set([ke(i.get("film"))]),o.begin();let n=()=>o.motions.replace(ke(i.get("film")));return i.on("change:film",n),()=>{i.off("change:film",n),s.close?.(),
o.close()}}var Ti=document.getElementById("hophoop-lab");Ti&&Ia(Ti);var Cd={render:_a};export{Cd as default,_d as mount};
