/* Built from web/lab/main.js by esbuild 0.28.2; sources 89e58e5077eec9d620ee13873ae65fe6 */
function ue(o){let e=Number.parseInt(o.slice(1,7),16);return[e>>16&255,e>>8&255,e&255]}var An=o=>ot(o)>.2?"#111111":"#ffffff",nt=(o,e)=>`rgba(${ue(o).join(",")}\
,${e})`,tr=o=>{let e=o/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4};function ot(o){let[e,t,s]=ue(o).map(tr);return .2126*e+.7152*t+.0722*s}function it(o,e){
if(!e||!/^#[0-9a-f]{6}$/i.test(o))return o;if(ot(o)<.002)return"#eceef2";let t=o;for(let s=0;ot(t)<.2&&s<1;s+=.05)t=`#${ue(o).map(n=>Math.round(n+(255-n)*s).toString(
16).padStart(2,"0")).join("")}`;return t}var Nt=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function sr(){let o=[];
for(let e=0;e<256;e++){let t=e/255*(Nt.length-1),s=Math.min(Math.floor(t),Nt.length-2),n=ue(Nt[s]),i=ue(Nt[s+1]);o.push(n.map((a,r)=>Math.round(a+(i[r]-a)*(t-s))))}
return o}var We=sr(),qt=We.map(o=>`rgb(${o.join(",")})`),or=["#123a8c","#8a6d00"],ie=(o,e)=>it(or[o],e);var zn={roll:"Rollen",spin:"Durchdrehen",skid:"Rutschen",flight:"Flug",skim:"Streifen",hop:"Hüpfer","slip −":"Schlupf −","slip +":"Schlupf +",rolls:"rollt",
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
id“ (hoop.inertia_ratio = 0)","The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"Der Server antwortet nicht\
. Was hier ist, läuft weiter; für Änderungen muss `hophoop lab` wieder laufen.","The server answered {status}.":"Der Server hat {status} geantwortet.","The n\
otebook’s kernel does not answer; run the cell again.":"Der Kernel des Notebooks antwortet nicht; die Zelle noch einmal ausführen.",hoop:"Reifen",mode:"Phase",
time:"Zeit",angle:"Winkel",gap:"Spalt","rim speed":"Randtempo",load:"Last","centre of gravity":"Schwerpunkt","the same in flight":"derselbe im Flug","A in front\
, B behind":"A vorn, B hinten","The hoop":"Der Reifen","The hoop.":"Der Reifen.",Time:"Zeit","{time} seconds, {what}":"{time} Sekunden, {what}","Traces (t)":"Sp\
uren (t)","Forces (f)":"Kräfte (f)","Rim speed (c)":"Randgeschwindigkeit (c)","Whole path (w)":"Ganzer Weg (w)","In space (3)":"Im Raum (3)",Traces:"Spuren",Forces:"\
Kräfte","Rim speed":"Randtempo","Whole path":"Ganzer Weg","Play (space)":"Abspielen (Leertaste)","Pause (space)":"Pause (Leertaste)","Speed of the film":"Tempo\
 des Films","To the start (Home)":"Zum Anfang (Pos1)","Previous event (Shift ←)":"Voriges Ereignis (Umschalt ←)","Next event (Shift →)":"Nächstes Ereignis\
 (Umschalt →)","One frame back (←)":"Ein Bild zurück (←)","One frame on (→)":"Ein Bild weiter (→)",landing:"Landung","To the next flight (h)":"Zum nä\
chsten Flug (h)","To the next landing (l)":"Zur nächsten Landung (l)","This motion has no flight.":"Diese Bewegung hat keinen Flug.","This motion has no landin\
g.":"Diese Bewegung hat keine Landung.","{what} at {angle}, {time} s":"{what} bei {angle}, {time} s",start:"Start","slip begins":"Schlupf beginnt","slip ends":"\
Schlupf endet","slip turns round":"Schlupf kehrt sich um","take-off":"Abheben","turns back":"kehrt um","highest point":"höchster Punkt","bounces end":"Sprünge \
enden","Painlevé: several solutions":"Painlevé: mehrere Lösungen","energy gain (Kane)":"Energiegewinn (Kane)","skimming begins":"Streifen beginnt","at rest":"\
in Ruhe",end:"Ende","What happens":"Was geschieht","What happens to hoop {hoop}":"Was mit Reifen {hoop} geschieht","The motion in words":"Die Bewegung in Worten",
"(not all events are shown)":"(nicht alle Ereignisse sind gezeigt)","What theory says":"Was die Theorie sagt","What theory says of hoop {hoop}":"Was die Theorie\
 zu Reifen {hoop} sagt",Velocities:"Geschwindigkeiten","velocity [m/s]":"Geschwindigkeit [m/s]","v (centre)":"v (Mittelpunkt)","Energies and losses":"Energien u\
nd Verluste","energy [J]":"Energie [J]",kinetic:"kinetisch",potential:"potenziell",total:"gesamt","lost to friction":"durch Reibung verloren","lost in the dampe\
r":"im Dämpfer verloren","lost in impacts, normal part":"in Stößen verloren, Normalanteil","Contact forces":"Kontaktkräfte","force [N]":"Kraft [N]","normal \
N":"Normalkraft N","friction F":"Reibungskraft F","Use of friction":"Ausnutzung der Reibung","Your choice":"Deine Wahl","What your diagram shows":"Was dein Diag\
ramm zeigt","Horizontal axis of the diagrams":"Waagerechte Achse der Diagramme","over {quantity}":"über: {quantity}","Whole motion":"Ganze Bewegung","slide to \
go there, two fingers zoom":"schieben, um dorthin zu gehen; zwei Finger vergrößern","click to go there, drag to zoom; once clicked, or with Ctrl, the wheel zo\
oms; double-click for all":"klicken: dorthin gehen; ziehen: vergrößern; nach einem Klick oder mit Strg zoomt das Rad; Doppelklick: alles","{name} from {low} t\
o {high}":"{name} von {low} bis {high}","Diagram: {title} in {unit}.":"Diagramm: {title} in {unit}.","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"\
{name} [{unit}]","angle within a turn":"Winkel innerhalb einer Umdrehung","place of the centre":"Ort des Mittelpunkts","gap under the rim":"Spalt unter dem Rand",
"height of the centre of gravity":"Höhe des Schwerpunkts","speed of the centre":"Geschwindigkeit des Mittelpunkts","speed of rotation":"Umfangsgeschwindigkeit",
"speed away from the plane":"Geschwindigkeit weg von der Ebene","slip velocity":"Schlupfgeschwindigkeit","angular velocity":"Winkelgeschwindigkeit","normal forc\
e":"Normalkraft","friction force":"Reibungskraft","use of friction":"Ausnutzung der Reibung","kinetic energy":"kinetische Energie","potential energy":"potenziel\
le Energie","total energy":"Gesamtenergie","Plane of θ and θ̇":"Ebene von θ und θ̇","Plane of angle and angular velocity with the regions of rolling, slip\
 and flight":"Ebene von Winkel und Winkelgeschwindigkeit mit den Gebieten von Rollen, Schlupf und Flug","angle θ within a turn [°]":"Winkel θ innerhalb einer \
Umdrehung [°]","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"Farben: die Phase, die auf Kontakt ohne \
Schlupf folgt. Schraffiert: Schlupf, der auf das Painlevé-Paradoxon trifft.","Click to go there; two fingers zoom.":"Tippen: dorthin gehen; zwei Finger vergröß\
ern.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Klicken: dorthin gehen; nach einem Klick oder mit Strg zoomt das \
Rad; Doppelklick: alles.",Map:"Karte",of:"von",Across:"Waagerecht",Up:"Senkrecht","What the map shows":"Was die Karte zeigt","Map of motions":"Karte der Bewegun\
gen","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Karte der Bewegungen. Pfeiltasten bewegen die Marke, Eingabe über\
nimmt die Bewegung, Plus und Minus zoomen.","Zoom into the map":"In die Karte hineinzoomen","Zoom out of the map":"Aus der Karte herauszoomen","Whole map":"Ganz\
e Karte","Click to take that motion into the player; two fingers zoom.":"Tippen übernimmt die Bewegung in den Abspieler; zwei Finger vergrößern.","Click to t\
ake that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Ein Klick übernimmt die Bewegung in den Absp\
ieler; nach einem Klick oder mit Strg zoomt das Rad; Ziehen verschiebt; Doppelklick: alles.","computing {count} motions …":"{count} Bewegungen werden berechne\
t …","{count} motions":"{count} Bewegungen","{count} motions, with rigid contact":"{count} Bewegungen, mit starrem Kontakt","of rolling starts, though this mo\
tion starts otherwise":"rollender Starts, obwohl diese Bewegung anders beginnt","of starts in any state, though this motion starts rolling":"aus beliebigem Zust\
and, obwohl diese Bewegung rollend beginnt","compiling the kernel of maps, this once: {done} of {all} functions":"der Rechenkern der Karten wird einmalig überse\
tzt: {done} von {all} Funktionen",Keep:"Behalten","Copy the link":"Link kopieren","Scenario (TOML)":"Szenario (TOML)","States (CSV)":"Zustände (CSV)","Motion (\
netCDF)":"Bewegung (netCDF)","Events (JSON)":"Ereignisse (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Bild (PNG)","Record a film here (WebM)":"Hier einen \
Film aufnehmen (WebM)","Show me the Python":"Das Python dazu zeigen","The same motion in Python":"Dieselbe Bewegung in Python","The link is copied.":"Der Link i\
st kopiert.","The link to this motion":"Der Link zu dieser Bewegung","The film is being made; this takes a while …":"Der Film wird gemacht; das dauert eine We\
ile …","Fetching {name} …":"{name} wird geholt …","{name} is there.":"{name} ist da.","This browser cannot record a canvas; take the MP4 instead.":"Dieser\
 Browser kann die Zeichenfläche nicht aufnehmen; nimm stattdessen das MP4.","Recording one run …":"Ein Durchlauf wird aufgenommen …","The film is there.":"\
Der Film ist da.","The scenario as a file":"Das Szenario als Datei",Copy:"Kopieren",Copied:"Kopiert",Close:"Schließen","A ring with a load on its rim rolls on \
a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move\
 a slider and see.":"Ein Ring mit einer Last am Rand rollt auf einer Ebene. Reibung hält nur begrenzt, und die Ebene kann nur drücken: Also gleitet er, hüpft, l\
andet – oder tut etwas, das die Mechanik starrer Körper nicht entscheiden kann. Bewege einen Regler und sieh zu.",Modes:"Phasen","Marks on the bar of time":"\
Zeichen auf der Zeitleiste",Keys:"Tasten",space:"Leertaste","play, pause":"abspielen, anhalten","one frame":"ein Bild","Shift ← →":"Umschalt ← →","previ\
ous, next event":"voriges, nächstes Ereignis","next flight, landing":"nächster Flug, nächste Landung","slower, faster":"langsamer, schneller","Home End":"Pos\
1 Ende","start, end":"Anfang, Ende","traces, forces, rim speed, whole path":"Spuren, Kräfte, Randgeschwindigkeit, ganzer Weg","in space":"im Raum","zoom, zoom \
back":"zoomen, zurück","leave a field, a menu, a picture that the wheel zooms":"ein Feld, ein Menü, ein Bild verlassen, das das Rad zoomt","z y  Ctrl Z":"z y \
 Strg Z","undo, redo":"rückgängig, wiederholen","dark, light":"dunkel, hell",Python:"Python","the rim does not slide":"der Rand gleitet nicht","slip: the rim \
turns too fast for the way it goes (slip −, for a hoop that rolls ahead)":"Schlupf: Der Rand dreht sich zu schnell für seinen Weg (Schlupf −, wenn der Reifen \
vorwärts rollt)","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"Schlupf: Der Rand gleitet voraus (Schlupf +, wenn der Reifen vorwärts roll\
t)","the hop: from take-off to landing":"der Hüpfer: vom Abheben bis zur Landung","a massless rim that touches without force":"ein masseloser Rand, der ohne Kr\
aft berührt","take-off, landing":"Abheben, Landung","Painlevé’s paradox: no solution, several":"Painlevé-Paradoxon: keine Lösung, mehrere","bounces withou\
t number end":"unzählige Sprünge enden","skimming begins, rest":"Streifen beginnt, Ruhe","Single keys (letters, digits, signs) do what the table says":"Einzel\
ne Tasten (Buchstaben, Ziffern, Zeichen) tun, was die Tabelle sagt","The hoop in your hand":"Der Reifen in der Hand","Slope of the plane":"Neigung der Ebene","T\
ilt the plane: drag, or arrow keys":"Ebene neigen: ziehen oder Pfeiltasten","The hoop: height and speed":"Der Reifen: Höhe und Geschwindigkeit","Lift, roll or \
throw the hoop: drag, or arrow keys":"Reifen heben, rollen oder werfen: ziehen oder Pfeiltasten","Angle of the load":"Winkel der Last","Turn the load: drag, or \
arrow keys":"Last drehen: ziehen oder Pfeiltasten","gap {height}, speed {speed} m/s":"Spalt {height}, Geschwindigkeit {speed} m/s",Repeat:"Wiederholen","Slow mo\
tion: a tenth of the speed":"Zeitlupe: ein Zehntel des Tempos","Sound of the contact":"Klang des Kontakts","Presentation on the whole screen":"Vorführung auf de\
m ganzen Bildschirm","Guided visit":"Geführter Besuch","Table of the motion":"Tabelle der Bewegung","Table of the motion, rows":"Tabelle der Bewegung, Zeilen",
Presentation:"Vorführung","For teachers":"Für Lehrkräfte",Table:"Tabelle",Every:"Alle","Save as CSV":"Als CSV speichern",Columns:"Spalten","The first {count}\
 rows.":"Die ersten {count} Zeilen.",Challenges:"Herausforderungen","Leave the challenges":"Herausforderungen verlassen","Which challenge":"Welche Herausforderu\
ng",Score:"Punkte","Begin again":"Von vorn beginnen","Show a best one":"Eine beste zeigen","{stars} {points} points. {what}":"{stars} {points} Punkte. {what}","\
Your best: {points} points.":"Deine beste: {points} Punkte.","Hop highest":"Am höchsten hüpfen","On level ground, rolling, with at most 3.1 m/s: you choose th\
e load, where it starts, and friction. How high can the hoop rise within 6 s?":"Auf ebenem Boden, rollend, mit höchstens 3,1 m/s: Du wählst die Last, wo sie beg\
innt, und die Reibung. Wie hoch kann der Reifen in 6 s steigen?","Land upright":"Aufrecht landen","Let the hoop land with its load at the very top. Everything i\
s allowed; the first hop has to be at least 5 cm high.":"Lass den Reifen so landen, dass seine Last ganz oben ist. Alles ist erlaubt; der erste Hüpfer muss mind\
estens 5 cm hoch sein.","Hop without skidding":"Hüpfen ohne Rutschen","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 \
m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Auf ebenem Boden beginnt der Reifen zu rollen, die Last\
 unten, mit höchstens 10 m/s, und μ ist höchstens 1,5. Vor dem Hüpfer darf er nicht rutschen; durchdrehen darf er. Wie hoch hüpft er?","Rigid contact only.":"\
Nur starrer Kontakt.","The plane must be level.":"Die Ebene muss waagerecht sein.","It must be on Earth.":"Es muss auf der Erde sein.","Restitution must be 0.":"\
Die Stoßzahl muss 0 sein.","The radius must stay 1 m, without parts.":"Der Radius muss 1 m bleiben, ohne Teile.","At most 90 % of the mass may be in the load.":"\
Höchstens 90 % der Masse dürfen in der Last sein.","The hoop must be given by its load fraction.":"Der Reifen muss durch den Massenanteil der Last gegeben sei\
n.","It must start rolling.":"Er muss rollend beginnen.","At most 10 m/s.":"Höchstens 10 m/s.","At most 3.1 m/s.":"Höchstens 3,1 m/s.","At most 6 s.":"Höchste\
ns 6 s.","It does not hop.":"Er hüpft nicht.","It rises by {height}.":"Er steigt um {height}.","The first hop is too low.":"Der erste Hüpfer ist zu niedrig.",
"It lands {off} away from the top.":"Er landet {off} neben der höchsten Stelle.","The load must start at the bottom.":"Die Last muss unten beginnen.","Friction\
 must be at most 1.5.":"Die Reibungszahl darf höchstens 1,5 sein.","It skids before it hops.":"Er rutscht, bevor er hüpft.","New here?":"Neu hier?","Eight sho\
rt questions: guess, then play.":"Acht kurze Fragen: erst raten, dann abspielen.","Start the visit":"Besuch beginnen","Not now":"Jetzt nicht","The hoop, before \
it is let go.":"Der Reifen, bevor er losgelassen wird.",Play:"Abspielen",Next:"Weiter",Back:"Zurück",Done:"Fertig","Step {number} of {all}":"Schritt {number} v\
on {all}","Leave the visit":"Besuch verlassen","First say what you expect, then play.":"Sag erst, was du erwartest, dann spiel ab.","Your guess":"Dein Tipp","{p\
oints} of 100 points.":"{points} von 100 Punkten.","You have {sum} of {most} points.":"Du hast {sum} von {most} Punkten.","{what} with the load at {angle}":"{wh\
at} mit der Last bei {angle}","Draw the curve: pull the points up and down":"Zeichne die Kurve: zieh die Punkte auf und ab","Littlewood’s question":"Littlewoo\
ds Frage","A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happ\
ens when the weight is level with the centre.":"Ein Reifen ohne Masse trägt ein Gewicht am Rand. Mit dem Gewicht oben bekommt er den kleinsten Stoß und rollt. J\
. E. Littlewood fragte 1953, was geschieht, wenn das Gewicht auf der Höhe des Mittelpunkts ist.","What do you think?":"Was meinst du?","It rolls on.":"Er rollt\
 weiter.","It hops: the hoop leaves the plane.":"Er hüpft: Der Reifen verlässt die Ebene.","The weight falls freely, and the hoop skims the plane below it.":"\
Das Gewicht fällt frei, und der Reifen streift darunter die Ebene.","At {angle} there is no contact force any more.":"Bei {angle} gibt es keine Kontaktkraft me\
hr.","Littlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane\
. To hop, a hoop needs some mass in its rim.":"Littlewood sagte, der Reifen hüpfe. Doch die Kontaktkraft ist null, nicht nach oben gerichtet: Das Gewicht fällt \
frei, und ein Rand ohne Masse folgt ihm die Ebene entlang. Zum Hüpfen braucht ein Reifen etwas Masse im Rand.","A ring with mass":"Ein Ring mit Masse","Now a q\
uarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"Jetzt steckt ein Viertel der Masse im Ring. Wieder ist d\
ie Last oben, und der Reifen bekommt den kleinsten Stoß.","Draw how fast the hoop’s centre goes during the first turn.":"Zeichne, wie schnell der Mittelpunkt\
 in der ersten Umdrehung ist.","Speed of the centre":"Geschwindigkeit des Mittelpunkts","With the load at the bottom the centre has {speed} m/s.":"Mit der Last \
unten hat der Mittelpunkt {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that th\
e heavy load has lost: it is faster than a stone that falls from the same height.":"Der tiefste Punkt eines rollenden Reifens ruht. Dort hat die Last keine kine\
tische Energie, und der leichte Ring hat alles, was die schwere Last verloren hat: Er ist schneller als ein Stein, der aus derselben Höhe fällt.","Why it slip\
s":"Warum er gleitet","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Ein kräftigerer Stoß: 2,8 m/s \
oben. Rollen braucht Reibung, und Reibung hat eine Grenze: Sie ist höchstens μ N.","Where is the load when friction gives way for the first time? Turn the mar\
k.":"Wo ist die Last, wenn die Reibung zum ersten Mal nachgibt? Dreh die Marke.","Angle of the load where it begins to slip":"Winkel der Last, wo er zu gleiten \
beginnt","It begins to slip at {angle}. There the plane carries only {share} of the weight.":"Er beginnt bei {angle} zu gleiten. Dort trägt die Ebene nur {share\
} des Gewichts.","The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction.\
 Watch the diagram ‘Use of friction’: it comes to 1.":"Die Last drückt auf ihrem Weg hinab und herum kaum auf die Ebene, N ist also klein, während der Ring \
schneller werden muss: Das braucht Reibung. Sieh das Diagramm „Ausnutzung der Reibung“: Sie erreicht 1.","The hop":"Der Hüpfer","A little faster, 3.1 m/s. \
This time the hoop leaves the plane, before the first turn is over.":"Etwas schneller, 3,1 m/s. Diesmal verlässt der Reifen die Ebene, bevor die erste Umdrehung\
 vorbei ist.","Where is the load when the hoop takes off? Turn the mark.":"Wo ist die Last, wenn der Reifen abhebt? Dreh die Marke.","Angle of the load where it\
 takes off":"Winkel der Last beim Abheben","It takes off at {angle}, while its rim slips at {slip} m/s.":"Er hebt bei {angle} ab, während sein Rand mit {slip} m\
/s gleitet.","A rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, \
and the load pulls it off the plane before it is at the top.":"Einen rollenden Reifen würde die Ebene bremsen, während die Last hochkommt. Dafür ist die Reibung\
 zu schwach: Der Rand dreht durch, der Reifen dreht schnell weiter, und die Last zieht ihn von der Ebene, bevor sie oben ist.","The landing":"Die Landung","The \
hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.":"Der Reifen ist in der Luft. Sein Schwerpunkt fliegt auf einer Parabel, und \
er dreht sich gleichmäßig.","What does it do just after it has landed?":"Was tut er gleich nach der Landung?","It rolls at once.":"Er rollt sofort.","It skids\
: the rim slides ahead.":"Er rutscht: Der Rand gleitet voraus.","It spins: the rim turns too fast.":"Er dreht durch: Der Rand dreht sich zu schnell.","It bounce\
s.":"Er springt wieder ab.","It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Er war {time} s in der Luft und stieg \
um {height} cm; er landet mit der Last bei {angle}.","An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. Wi\
th less friction, or more restitution, the landing would be another one. Try it afterwards.":"Ein Stoß braucht keine Zeit, doch seine Reibung ist so stark wie s\
ein Druck: Hier genügt sie, um allen Schlupf zu beenden. Mit weniger Reibung oder größerer Stoßzahl wäre die Landung eine andere. Probier es nachher aus.",
"More friction, more hop?":"Mehr Reibung, mehr Hüpfen?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Drei Reifen bek\
ommen denselben Stoß von 3,1 m/s, auf Ebenen mit der Reibungszahl 0,05, 0,2 und 1,0.","Which of them hops highest?":"Welcher hüpft am höchsten?","They rise b\
y {low} cm, {middle} cm and {high} cm. (The first two are A and B.)":"Sie steigen um {low} cm, {middle} cm und {high} cm. (Die ersten beiden sind A und B.)","On\
 ice nothing drives the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so muc\
h that it is braked on the way up.":"Auf Eis treibt nichts die Drehung an; mit endloser Reibung gleitet nichts. Der Hüpfer braucht beides: genug Reibung, um den\
 Reifen auf dem Weg hinab schnell zu drehen, und nicht so viel, dass er auf dem Weg hinauf gebremst wird.","What rigid bodies cannot decide":"Was starre Körper \
nicht entscheiden","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Ein \
Reifen wird so geworfen, dass er schnell über eine raue Ebene gleitet. Die Gesetze starrer Körper mit trockener Reibung müssen sagen, was als Nächstes geschieht\
.","What do they say?":"Was sagen sie?","It flies off.":"Er fliegt davon.","An impact stops the slide at once.":"Ein Stoß beendet das Gleiten sofort.","Both ag\
ree with the laws.":"Beides passt zu den Gesetzen.","Hoop A and hoop B start alike, and both motions obey every law.":"Reifen A und Reifen B beginnen gleich, un\
d beide Bewegungen befolgen jedes Gesetz.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yiel\
d a little, and that decides: choose the compliant contact under ‘Contact’.":"Painlevé fand dies 1895. Für einen starren Körper haben die Gesetze hier zwei \
Antworten, in anderen Zuständen keine. Wirkliche Körper geben etwas nach, und das entscheidet: Wähle unter „Kontakt“ den nachgiebigen.","Your turn":"Du b\
ist dran","Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed fr\
om the motion itself.":"Nimm den Reifen: Dreh die Last, heb ihn an und lass ihn fallen, stoß ihn an, neige die Ebene. Oder nimm eine Herausforderung an, und sie\
h, wie deine Punkte aus der Bewegung selbst berechnet werden.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Den \
Reifen einmal in voller Geschwindigkeit zeigen, ohne Kommentar. „Ich stoße ihn an. Rollt er nur?“","Everybody predicts where the load is at take-off. Count\
 the votes by quarters of the turn.":"Alle sagen voraus, wo die Last beim Abheben ist. Stimmen nach Vierteln der Umdrehung zählen.","Energy on the way down, in\
 pairs: who has the energy when the load is at rest?":"Energie auf dem Weg hinab, zu zweit: Wer hat die Energie, wenn die Last ruht?","Lift at the top: at which\
 speed is the force of the floor zero?":"Abheben oben: Bei welcher Geschwindigkeit ist die Kraft des Bodens null?","The film again, in slow motion and with forc\
es; stop at take-off. Compare with the votes.":"Der Film noch einmal, in Zeitlupe und mit Kräften; beim Abheben anhalten. Mit den Stimmen vergleichen.","Each g\
roup takes one speed of the worksheet; results on the board.":"Jede Gruppe nimmt eine Geschwindigkeit des Arbeitsblatts; Ergebnisse an die Tafel.","Why? What ha\
s to brake the rotation on the way up, how strong can it be, and what if it is too weak?":"Warum? Was muss die Drehung auf dem Weg hinauf bremsen, wie stark kan\
n es sein, und was, wenn es zu schwach ist?","One sentence each: “The hoop hops because …”":"Ein Satz von jedem: „Der Reifen hüpft, weil …“","The l\
oad pulls the hoop up at the top, so it hops there.":"Die Last zieht den Reifen oben hoch, also hüpft er dort.","Only if it is very fast. Slower hoops hop befo\
re the top, after slipping.":"Nur wenn er sehr schnell ist. Langsamere Reifen hüpfen vor der höchsten Stelle, nach dem Gleiten.","It hops at the bottom, where\
 it is fastest.":"Er hüpft unten, wo er am schnellsten ist.","There the floor pushes hardest: the load has to be turned upwards.":"Dort drückt der Boden am stä\
rksten: Die Last muss nach oben umgelenkt werden.","Nothing can be faster than a falling stone.":"Nichts kann schneller sein als ein fallender Stein.","The ring\
 can: it gets the energy of a load that has come to rest.":"Der Ring schon: Er bekommt die Energie einer Last, die zur Ruhe gekommen ist.","Friction always brak\
es.":"Reibung bremst immer.","It acts against slip. On the hoop’s way up it points forwards.":"Sie wirkt gegen den Schlupf. Auf dem Weg hinauf zeigt sie nach \
vorn.","More friction, more hop.":"Mehr Reibung, mehr Hüpfen.","There is a best friction in between.":"Dazwischen gibt es eine beste Reibungszahl.","A heavier \
hoop behaves otherwise.":"Ein schwererer Reifen verhält sich anders.","Only the shares of mass count.":"Nur die Anteile der Massen zählen.","Before the film: \
where is the load when the hoop leaves the floor? Mark the place and give one reason.":"Vor dem Film: Wo ist die Last, wenn der Reifen den Boden verlässt? Marki\
ere die Stelle und nenne einen Grund.","The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bott\
om?":"Der Reifen bekommt nur den kleinsten Stoß und rollt. Wie viel potenzielle Energie ist frei geworden, wenn die Last unten ist?","While a wheel rolls, its \
lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"Wenn ein Rad rollt, ruht sein tiefster Punkt. Welcher Tei\
l des Reifens hat dann kinetische Energie, und wie schnell ist der Mittelpunkt?","How fast is a stone that falls from the height of the load? Why can the hoop b\
e faster?":"Wie schnell ist ein Stein, der aus der Höhe der Last fällt? Warum kann der Reifen schneller sein?","Find the force of the floor at the top for 1.0\
 m/s, and the speed at which it becomes zero.":"Bestimme die Kraft des Bodens oben für 1,0 m/s und die Geschwindigkeit, bei der sie null wird.","In the lab: wh\
at does the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.":"Im Labor: Was tut der Reifen in den ersten 1,5 s, und bei welchem W\
inkel hüpft er? Fülle die Tabelle aus.","Find the smallest speed with which the hoop hops, to 1 cm/s.":"Finde die kleinste Geschwindigkeit, mit der der Reifen\
 hüpft, auf 1 cm/s genau.","At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping help it to hop?":"Bei 2,2 m/s verlässt der Reifen den B\
oden, während sein Rand gleitet. Warum hilft ihm das Gleiten zu hüpfen?",Show:"Zeigen","Teaching with the hoop":"Unterrichten mit dem Reifen",Worksheet:"Arbei\
tsblatt",Solutions:"Lösungen",Exercises:"Aufgaben","A lesson of 45 minutes":"Eine Unterrichtsstunde von 45 Minuten",Minute:"Minute",Motion:"Bewegung","What stu\
dents often think":"Was Lernende oft denken",Idea:"Vorstellung","What is right":"Was richtig ist","Worksheet: the hoop that hops":"Arbeitsblatt: der hüpfende Re\
ifen","A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and \
is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Ein dünner Ring mit dem Radius 0,40 m hat eine Masse von 0,25 kg. An seinem Rand ist eine Last von 0\
,75 kg befestigt. Der Reifen steht mit der Last oben auf ebenem Boden und wird nach rechts gestoßen. Reibungszahl: μ = 1; g = 9,81 m/s².",phases:"Phasen","do\
es it hop?":"hüpft er?","at which angle?":"bei welchem Winkel?",Print:"Drucken","The visit asks before it shows; the presentation fills the screen; the table g\
ives numbers to every student.":"Der Besuch fragt, bevor er zeigt; die Vorführung füllt den Bildschirm; die Tabelle gibt allen Zahlen.",inf:"inf","greater tha\
n {least}":"größer als {least}","at least {least}":"mindestens {least}","at least {least} (inf is allowed)":"mindestens {least} (inf ist erlaubt)","at most {m\
ost}":"höchstens {most}","a finite number":"eine endliche Zahl","a whole number":"eine ganze Zahl","'{word}' or '{word2}'":"„{word}“ oder „{word2}“","'\
{word}', '{word2}' or '{word3}'":"„{word}“, „{word2}“ oder „{word3}“","Rolling resistance":"Rollwiderstand","Rolling resistance: couple against the \
rotation over R N":"Rollwiderstand: Moment gegen die Drehung, geteilt durch R N","Slips, hops":"Gleitet, hüpft","no threshold uphill (β < 0): whether it slips \
or hops hangs on where it turns back; the map shows it":"bergauf (β < 0) keine Schwelle: Ob er gleitet oder hüpft, hängt davon ab, wo er umkehrt; die Karte zeig\
t es","'rigid' for a map":"für eine Karte „rigid“","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells mal y.cells = {cells} darf\
 im Labor höchstens {most} sein.","{one} and {other} cannot both be axes: they say the same thing in two ways.":"{one} und {other} können nicht beide Achsen se\
in: Sie sagen dasselbe auf zwei Arten.","x.path and y.path are both {path} and must differ.":"x.path und y.path sind beide {path} und müssen verschieden sein.",
"lost to rolling resistance":"durch Rollwiderstand verloren","Rolling resistance f":"Rollwiderstand f","{name} = {value} must lie between -pi/2 and pi/2 (radian\
s).":"{name} = {value} muss zwischen -pi/2 und pi/2 liegen (Radiant).","{word} is not a known key; known are {word2}.":"{word} ist kein bekannter Schlüssel; bek\
annt sind {word2}.","{one} cannot be given together with {other}.":"{one} kann nicht zusammen mit {other} gegeben werden.","{one} = {value} must not exceed {oth\
er} = {limit}.":"{one} = {value} darf {other} = {limit} nicht übersteigen.","plane.mu_static = inf must be finite with contact.model = 'compliant'.":"plane.mu_\
static = inf muss bei contact.model = 'compliant' endlich sein.","hoop.parts must not be empty.":"hoop.parts darf nicht leer sein.","This takes longer than {tim\
e} s; ask for a shorter motion or fewer cells.":"Das dauert länger als {time} s; verlange eine kürzere Bewegung oder weniger Zellen.","The lab is busy; try ag\
ain in {time} seconds.":"Das Labor ist beschäftigt; in {time} Sekunden noch einmal versuchen.","The lab is busy; try again in 1 second.":"Das Labor ist beschäf\
tigt; in 1 Sekunde noch einmal versuchen.","The computation failed.":"Die Rechnung ist gescheitert.","The process that computed this has ended.":"Der Prozess, d\
er dies berechnet hat, ist beendet.","duration = {value} must be at most {most} s in the lab; the library itself has no such limit.":"duration = {value} darf im\
 Labor höchstens {most} s sein; die Bibliothek selbst hat keine solche Grenze.","duration = {value} s at this speed and radius is about {turns} revolutions and\
 must be at most {most} in the lab; the library itself has no such limit.":"duration = {value} s sind bei dieser Geschwindigkeit und diesem Radius etwa {turns} \
Umdrehungen, im Labor höchstens {most}; die Bibliothek selbst hat keine solche Grenze.","hoop.parts has {count} parts and must have at most {most} in the lab.":"\
hoop.parts hat {count} Teile und darf im Labor höchstens {most} haben.","contact.stiffness, contact.slip_speed and duration need about {steps} steps of integra\
tion and must need at most {most} in the lab.":"contact.stiffness, contact.slip_speed und duration brauchen etwa {steps} Integrationsschritte, im Labor höchsten\
s {most}.","A cell of this map is about {turns} revolutions and must be at most {most} in the lab.":"Eine Zelle dieser Karte sind etwa {turns} Umdrehungen, im L\
abor höchstens {most}.","x and y make {count} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds \
or a shorter duration.":"x und y ergeben {count} Zellen mit zusammen etwa {turns} Umdrehungen, im Labor höchstens {most}; nimm weniger Zellen, kleinere Geschwin\
digkeiten oder eine kürzere Dauer.","duration = {value} must be at most {most} s for a film from the lab.":"duration = {value} darf für einen Film aus dem Labo\
r höchstens {most} s sein.","A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A blau, B ocker; die Strichart nennt die Größe; Zahl\
en von {hoop}; {hands}"};var Rn={roll:"rodadura",spin:"patinaje",skid:"derrape",flight:"vuelo",skim:"roce",hop:"salto","slip −":"deslizamiento −","slip +":"deslizamiento +",rolls:"r\
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
sa (hoop.inertia_ratio = 0)","The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"El servidor no responde. Lo q\
ue hay aquí sigue funcionando; para cambios hay que volver a ejecutar `hophoop lab`.","The server answered {status}.":"El servidor respondió {status}.","The n\
otebook’s kernel does not answer; run the cell again.":"El núcleo del cuaderno no responde; vuelva a ejecutar la celda.",hoop:"aro",mode:"fase",time:"tiempo",
angle:"ángulo",gap:"separación","rim speed":"vel. de la llanta",load:"carga","centre of gravity":"centro de gravedad","the same in flight":"el mismo en vuelo",
"A in front, B behind":"A delante, B detrás","The hoop":"El aro","The hoop.":"El aro.",Time:"Tiempo","{time} seconds, {what}":"{time} segundos, {what}","Traces\
 (t)":"Trayectorias (t)","Forces (f)":"Fuerzas (f)","Rim speed (c)":"Velocidad de la llanta (c)","Whole path (w)":"Todo el recorrido (w)","In space (3)":"En el \
espacio (3)",Traces:"Trayectorias",Forces:"Fuerzas","Rim speed":"Vel. llanta","Whole path":"Recorrido","Play (space)":"Reproducir (espacio)","Pause (space)":"Pa\
usa (espacio)","Speed of the film":"Velocidad de la película","To the start (Home)":"Al principio (Inicio)","Previous event (Shift ←)":"Suceso anterior (Mayú\
s ←)","Next event (Shift →)":"Suceso siguiente (Mayús →)","One frame back (←)":"Un fotograma atrás (←)","One frame on (→)":"Un fotograma adelante \
(→)",landing:"aterrizaje","To the next flight (h)":"Al siguiente vuelo (h)","To the next landing (l)":"Al siguiente aterrizaje (l)","This motion has no flight\
.":"Este movimiento no tiene vuelo.","This motion has no landing.":"Este movimiento no tiene aterrizaje.","{what} at {angle}, {time} s":"{what} a {angle}, {time\
} s",start:"inicio","slip begins":"empieza el deslizamiento","slip ends":"acaba el deslizamiento","slip turns round":"se invierte el deslizamiento","take-off":"\
despegue","turns back":"da la vuelta","highest point":"punto más alto","bounces end":"acaban los rebotes","Painlevé: several solutions":"Painlevé: varias solu\
ciones","energy gain (Kane)":"ganancia de energía (Kane)","skimming begins":"empieza el roce","at rest":"en reposo",end:"final","What happens":"Qué ocurre","W\
hat happens to hoop {hoop}":"Qué le ocurre al aro {hoop}","The motion in words":"El movimiento en palabras","(not all events are shown)":"(no se muestran todos\
 los sucesos)","What theory says":"Qué dice la teoría","What theory says of hoop {hoop}":"Qué dice la teoría del aro {hoop}",Velocities:"Velocidades","veloc\
ity [m/s]":"velocidad [m/s]","v (centre)":"v (centro)","Energies and losses":"Energías y pérdidas","energy [J]":"energía [J]",kinetic:"cinética",potential:"\
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
 deslizamiento y vuelo","angle θ within a turn [°]":"ángulo θ dentro de una vuelta [°]","Colours: the mode that follows contact without slip. Hatched: slip\
 that meets Painlevé’s paradox.":"Colores: la fase que sigue al contacto sin deslizamiento. Rayado: deslizamiento que encuentra la paradoja de Painlevé.","C\
lick to go there; two fingers zoom.":"Toca para ir ahí; dos dedos amplían.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for \
all.":"Clic para ir ahí; tras un clic, o con Ctrl, la rueda amplía; doble clic para todo.",Map:"Mapa",of:"de",Across:"Horizontal",Up:"Vertical","What the map \
shows":"Qué muestra el mapa","Map of motions":"Mapa de movimientos","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"M\
apa de movimientos. Las flechas mueven la marca, Intro toma el movimiento, más y menos amplían.","Zoom into the map":"Ampliar el mapa","Zoom out of the map":"\
Reducir el mapa","Whole map":"Mapa entero","Click to take that motion into the player; two fingers zoom.":"Toca para llevar ese movimiento al reproductor; dos d\
edos amplían.","Click to take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Un clic lleva ese\
 movimiento al reproductor; tras un clic, o con Ctrl, la rueda amplía; arrastrar desplaza; doble clic para todo.","computing {count} motions …":"calculando {\
count} movimientos…","{count} motions":"{count} movimientos","{count} motions, with rigid contact":"{count} movimientos, con contacto rígido","of rolling sta\
rts, though this motion starts otherwise":"con salidas rodando, aunque este movimiento empieza de otro modo","of starts in any state, though this motion starts \
rolling":"desde cualquier estado, aunque este movimiento empieza rodando","compiling the kernel of maps, this once: {done} of {all} functions":"compilando el nú\
cleo de los mapas, solo esta vez: {done} de {all} funciones",Keep:"Guardar","Copy the link":"Copiar el enlace","Scenario (TOML)":"Escenario (TOML)","States (CSV\
)":"Estados (CSV)","Motion (netCDF)":"Movimiento (netCDF)","Events (JSON)":"Sucesos (JSON)","Film (MP4)":"Película (MP4)","Picture (PNG)":"Imagen (PNG)","Recor\
d a film here (WebM)":"Grabar aquí una película (WebM)","Show me the Python":"Ver el código Python","The same motion in Python":"El mismo movimiento en Pytho\
n","The link is copied.":"El enlace está copiado.","The link to this motion":"El enlace a este movimiento","The film is being made; this takes a while …":"Se\
 está haciendo la película; tarda un poco…","Fetching {name} …":"Obteniendo {name}…","{name} is there.":"{name} ya está.","This browser cannot record a\
 canvas; take the MP4 instead.":"Este navegador no puede grabar el lienzo; use el MP4.","Recording one run …":"Grabando una pasada…","The film is there.":"L\
a película ya está.","The scenario as a file":"El escenario como archivo",Copy:"Copiar",Copied:"Copiado",Close:"Cerrar","A ring with a load on its rim rolls o\
n a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Mo\
ve a slider and see.":"Un anillo con una carga en la llanta rueda sobre un plano. El rozamiento aguanta hasta un límite y el plano solo puede empujar: por eso d\
esliza, salta, aterriza… o hace algo que la mecánica del sólido rígido no puede decidir. Mueve un control y observa.",Modes:"Fases","Marks on the bar of ti\
me":"Marcas en la barra de tiempo",Keys:"Teclas",space:"espacio","play, pause":"reproducir, pausa","one frame":"un fotograma","Shift ← →":"Mayús ← →","\
previous, next event":"suceso anterior, siguiente","next flight, landing":"siguiente vuelo, aterrizaje","slower, faster":"más lento, más rápido","Home End":"\
Inicio Fin","start, end":"principio, final","traces, forces, rim speed, whole path":"trayectorias, fuerzas, velocidad de la llanta, recorrido","in space":"en el\
 espacio","zoom, zoom back":"ampliar, volver","leave a field, a menu, a picture that the wheel zooms":"salir de un campo, un menú o una imagen que amplía la rue\
da","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"deshacer, rehacer","dark, light":"oscuro, claro",Python:"Python","the rim does not slide":"la llanta no desliza","\
slip: the rim turns too fast for the way it goes (slip −, for a hoop that rolls ahead)":"deslizamiento: la llanta gira demasiado deprisa para lo que avanza (d\
eslizamiento −, si el aro rueda hacia delante)","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"deslizamiento: la llanta desliza hacia del\
ante (deslizamiento +, si el aro rueda hacia delante)","the hop: from take-off to landing":"el salto: del despegue al aterrizaje","a massless rim that touches w\
ithout force":"una llanta sin masa que toca sin fuerza","take-off, landing":"despegue, aterrizaje","Painlevé’s paradox: no solution, several":"Paradoja de Pa\
inlevé: ninguna solución, varias","bounces without number end":"acaban infinitos rebotes","skimming begins, rest":"empieza el roce, reposo","Single keys (lett\
ers, digits, signs) do what the table says":"Las teclas sueltas (letras, cifras, signos) hacen lo que dice la tabla","The hoop in your hand":"El aro en tu mano",
"Slope of the plane":"Inclinación del plano","Tilt the plane: drag, or arrow keys":"Inclinar el plano: arrastrar o flechas","The hoop: height and speed":"El ar\
o: altura y velocidad","Lift, roll or throw the hoop: drag, or arrow keys":"Levantar, rodar o lanzar el aro: arrastrar o flechas","Angle of the load":"Ángulo de\
 la carga","Turn the load: drag, or arrow keys":"Girar la carga: arrastrar o flechas","gap {height}, speed {speed} m/s":"separación {height}, velocidad {speed} \
m/s",Repeat:"Repetir","Slow motion: a tenth of the speed":"Cámara lenta: una décima parte","Sound of the contact":"Sonido del contacto","Presentation on the w\
hole screen":"Presentación a pantalla completa","Guided visit":"Visita guiada","Table of the motion":"Tabla del movimiento","Table of the motion, rows":"Tabla \
del movimiento, filas",Presentation:"Presentación","For teachers":"Para docentes",Table:"Tabla",Every:"Cada","Save as CSV":"Guardar como CSV",Columns:"Columnas",
"The first {count} rows.":"Las primeras {count} filas.",Challenges:"Retos","Leave the challenges":"Salir de los retos","Which challenge":"Qué reto",Score:"Punt\
uación","Begin again":"Empezar de nuevo","Show a best one":"Ver una de las mejores","{stars} {points} points. {what}":"{stars} {points} puntos. {what}","Your b\
est: {points} points.":"Tu mejor: {points} puntos.","Hop highest":"El salto más alto","On level ground, rolling, with at most 3.1 m/s: you choose the load, whe\
re it starts, and friction. How high can the hoop rise within 6 s?":"En suelo horizontal, rodando, con 3,1 m/s como mucho: eliges la carga, dónde empieza y el r\
ozamiento. ¿Hasta qué altura puede subir el aro en 6 s?","Land upright":"Aterrizar en pie","Let the hoop land with its load at the very top. Everything is all\
owed; the first hop has to be at least 5 cm high.":"Haz que el aro aterrice con la carga arriba del todo. Todo vale; el primer salto debe tener al menos 5 cm de\
 altura.","Hop without skidding":"Saltar sin derrapar","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at\
 most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"En suelo horizontal el aro empieza rodando con la carga abajo, a 10 m/s \
como mucho, y μ no pasa de 1,5. Antes de saltar no debe derrapar; patinar sí puede. ¿Hasta qué altura salta?","Rigid contact only.":"Solo contacto rígido.",
"The plane must be level.":"El plano debe ser horizontal.","It must be on Earth.":"Debe ser en la Tierra.","Restitution must be 0.":"La restitución debe ser 0.",
"The radius must stay 1 m, without parts.":"El radio debe seguir siendo 1 m, sin piezas.","At most 90 % of the mass may be in the load.":"Como mucho el 90 % de \
la masa puede estar en la carga.","The hoop must be given by its load fraction.":"El aro debe darse por la fracción de carga.","It must start rolling.":"Debe e\
mpezar rodando.","At most 10 m/s.":"Como mucho 10 m/s.","At most 3.1 m/s.":"Como mucho 3,1 m/s.","At most 6 s.":"Como mucho 6 s.","It does not hop.":"No salta.",
"It rises by {height}.":"Sube {height}.","The first hop is too low.":"El primer salto es demasiado bajo.","It lands {off} away from the top.":"Aterriza a {off} \
de lo más alto.","The load must start at the bottom.":"La carga debe empezar abajo.","Friction must be at most 1.5.":"El rozamiento debe ser como mucho 1,5.","\
It skids before it hops.":"Derrapa antes de saltar.","New here?":"¿Primera vez?","Eight short questions: guess, then play.":"Ocho preguntas cortas: adivina y l\
uego reproduce.","Start the visit":"Empezar la visita","Not now":"Ahora no","The hoop, before it is let go.":"El aro, antes de soltarlo.",Play:"Reproducir",Next:"\
Siguiente",Back:"Atrás",Done:"Hecho","Step {number} of {all}":"Paso {number} de {all}","Leave the visit":"Salir de la visita","First say what you expect, then \
play.":"Di primero qué esperas y luego reproduce.","Your guess":"Tu respuesta","{points} of 100 points.":"{points} de 100 puntos.","You have {sum} of {most} po\
ints.":"Tienes {sum} de {most} puntos.","{what} with the load at {angle}":"{what} con la carga a {angle}","Draw the curve: pull the points up and down":"Dibuja \
la curva: mueve los puntos arriba y abajo","Littlewood’s question":"La pregunta de Littlewood","A hoop without mass has a weight on its rim. With the weight a\
t the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the weight is level with the centre.":"Un aro sin masa lleva un \
peso en la llanta. Con el peso arriba recibe el menor empujón y rueda. J. E. Littlewood preguntó en 1953 qué ocurre cuando el peso está a la altura del centro.",
"What do you think?":"¿Qué crees?","It rolls on.":"Sigue rodando.","It hops: the hoop leaves the plane.":"Salta: el aro deja el plano.","The weight falls free\
ly, and the hoop skims the plane below it.":"El peso cae libremente y el aro roza el plano debajo de él.","At {angle} there is no contact force any more.":"A {\
angle} ya no hay fuerza de contacto.","Littlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim withou\
t mass follows it along the plane. To hop, a hoop needs some mass in its rim.":"Littlewood dijo que el aro salta. Pero la fuerza de contacto es nula, no hacia a\
rriba: el peso cae libremente y una llanta sin masa lo sigue por el plano. Para saltar, un aro necesita algo de masa en la llanta.","A ring with mass":"Un anill\
o con masa","Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"Ahora un cuarto de la masa está en e\
l anillo. De nuevo la carga está arriba y el aro recibe el menor empujón.","Draw how fast the hoop’s centre goes during the first turn.":"Dibuja la velocida\
d del centro del aro durante la primera vuelta.","Speed of the centre":"Velocidad del centro","With the load at the bottom the centre has {speed} m/s.":"Con la \
carga abajo el centro va a {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that t\
he heavy load has lost: it is faster than a stone that falls from the same height.":"El punto más bajo de un aro que rueda está en reposo. Ahí la carga no tiene\
 energía cinética, y el anillo ligero tiene toda la que ha perdido la carga pesada: va más rápido que una piedra que cae desde la misma altura.","Why it sli\
ps":"Por qué desliza","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Un empujón más fuerte: 2,8 m/\
s arriba. Rodar exige rozamiento, y el rozamiento tiene un límite: como mucho μ N.","Where is the load when friction gives way for the first time? Turn the ma\
rk.":"¿Dónde está la carga cuando el rozamiento cede por primera vez? Gira la marca.","Angle of the load where it begins to slip":"Ángulo de la carga donde e\
mpieza a deslizar","It begins to slip at {angle}. There the plane carries only {share} of the weight.":"Empieza a deslizar a {angle}. Ahí el plano soporta solo \
el {share} del peso.","The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes fric\
tion. Watch the diagram ‘Use of friction’: it comes to 1.":"En su camino hacia abajo la carga apenas aprieta el plano, así que N es pequeña, mientras que el\
 anillo debe acelerarse: eso exige rozamiento. Mira el diagrama «Uso del rozamiento»: llega a 1.","The hop":"El salto","A little faster, 3.1 m/s. This time th\
e hoop leaves the plane, before the first turn is over.":"Un poco más rápido, 3,1 m/s. Esta vez el aro deja el plano antes de acabar la primera vuelta.","Wher\
e is the load when the hoop takes off? Turn the mark.":"¿Dónde está la carga cuando el aro despega? Gira la marca.","Angle of the load where it takes off":"Á\
ngulo de la carga al despegar","It takes off at {angle}, while its rim slips at {slip} m/s.":"Despega a {angle}, mientras su llanta desliza a {slip} m/s.","A ro\
lling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls\
 it off the plane before it is at the top.":"A un aro que rueda el plano lo frenaría mientras sube la carga. El rozamiento es demasiado débil para eso: la llant\
a patina, el aro sigue girando deprisa y la carga lo arranca del plano antes de llegar arriba.","The landing":"El aterrizaje","The hoop is in the air. Its centr\
e of gravity goes on a parabola, and it turns evenly.":"El aro está en el aire. Su centro de gravedad sigue una parábola y gira de manera uniforme.","What doe\
s it do just after it has landed?":"¿Qué hace justo después de aterrizar?","It rolls at once.":"Rueda de inmediato.","It skids: the rim slides ahead.":"Derra\
pa: la llanta desliza hacia delante.","It spins: the rim turns too fast.":"Patina: la llanta gira demasiado deprisa.","It bounces.":"Rebota.","It was in the air\
 for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Estuvo {time} s en el aire y subió {height} cm; aterriza con la carga a {angle}.","\
An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing wou\
ld be another one. Try it afterwards.":"Un impacto no dura nada, pero su rozamiento es tan fuerte como su empuje: aquí basta para detener todo deslizamiento. Co\
n menos rozamiento, o más restitución, el aterrizaje sería otro. Pruébalo después.","More friction, more hop?":"¿Más rozamiento, más salto?","Three hoop\
s get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Tres aros reciben el mismo empujón de 3,1 m/s, en planos con rozamiento 0,05, 0,2 y\
 1,0.","Which of them hops highest?":"¿Cuál salta más alto?","They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)":"Suben {low} cm\
, {middle} cm y {high} cm. (Los dos primeros son A y B.)","On ice nothing drives the rotation; with endless friction nothing slips. The hop needs both: enough f\
riction to turn the hoop fast on the way down, and not so much that it is braked on the way up.":"Sobre hielo nada impulsa el giro; con rozamiento sin fin nada \
desliza. El salto necesita ambas cosas: rozamiento bastante para girar deprisa en la bajada, y no tanto que lo frene en la subida.","What rigid bodies cannot de\
cide":"Lo que los sólidos rígidos no pueden decidir","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction h\
ave to say what happens next.":"Se lanza un aro de modo que deslice deprisa sobre un plano rugoso. Las leyes del sólido rígido con rozamiento seco deben decir q\
ué ocurre después.","What do they say?":"¿Qué dicen?","It flies off.":"Sale volando.","An impact stops the slide at once.":"Un impacto detiene el deslizamie\
nto de golpe.","Both agree with the laws.":"Ambas cosas cumplen las leyes.","Hoop A and hoop B start alike, and both motions obey every law.":"El aro A y el aro\
 B empiezan igual, y ambos movimientos cumplen todas las leyes.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states \
none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’.":"Painlevé lo descubrió en 1895. Para un sólido rígido las\
 leyes tienen aquí dos respuestas, y en otros estados ninguna. Los cuerpos reales ceden un poco, y eso decide: elige el contacto flexible en «Contacto».","Yo\
ur turn":"Te toca a ti","Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores a\
re computed from the motion itself.":"Toma el aro: gira la carga, levántalo y suéltalo, dale un impulso, inclina el plano. O acepta un reto y mira cómo tu puntu\
ación se calcula del propio movimiento.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Mostrar el aro a toda vel\
ocidad, una vez, sin comentar. «Lo empujo. ¿Solo rueda?»","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.":"Todos\
 predicen dónde está la carga al despegar. Contar los votos por cuartos de vuelta.","Energy on the way down, in pairs: who has the energy when the load is at \
rest?":"Energía en la bajada, por parejas: ¿quién tiene la energía cuando la carga está en reposo?","Lift at the top: at which speed is the force of the fl\
oor zero?":"Elevación arriba: ¿a qué velocidad es nula la fuerza del suelo?","The film again, in slow motion and with forces; stop at take-off. Compare with \
the votes.":"La película otra vez, a cámara lenta y con fuerzas; parar al despegar. Comparar con los votos.","Each group takes one speed of the worksheet; res\
ults on the board.":"Cada grupo toma una velocidad de la hoja de trabajo; resultados en la pizarra.","Why? What has to brake the rotation on the way up, how str\
ong can it be, and what if it is too weak?":"¿Por qué? ¿Qué debe frenar el giro en la subida, qué fuerza puede tener y qué pasa si es demasiado débil?","\
One sentence each: “The hoop hops because …”":"Una frase cada uno: «El aro salta porque…»","The load pulls the hoop up at the top, so it hops there.":"\
La carga tira del aro hacia arriba en lo alto, por eso salta ahí.","Only if it is very fast. Slower hoops hop before the top, after slipping.":"Solo si es muy \
rápido. Los más lentos saltan antes de lo alto, tras deslizar.","It hops at the bottom, where it is fastest.":"Salta abajo, donde es más rápido.","There the\
 floor pushes hardest: the load has to be turned upwards.":"Ahí el suelo empuja más: hay que desviar la carga hacia arriba.","Nothing can be faster than a fal\
ling stone.":"Nada puede ser más rápido que una piedra que cae.","The ring can: it gets the energy of a load that has come to rest.":"El anillo sí: recibe la \
energía de una carga que ha quedado en reposo.","Friction always brakes.":"El rozamiento siempre frena.","It acts against slip. On the hoop’s way up it points \
forwards.":"Actúa contra el deslizamiento. En la subida apunta hacia delante.","More friction, more hop.":"Más rozamiento, más salto.","There is a best frict\
ion in between.":"Hay un rozamiento óptimo intermedio.","A heavier hoop behaves otherwise.":"Un aro más pesado se comporta de otro modo.","Only the shares of \
mass count.":"Solo cuentan las proporciones de masa.","Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.":"\
Antes de la película: ¿dónde está la carga cuando el aro deja el suelo? Marca el lugar y da una razón.","The hoop gets only the smallest push and rolls. Ho\
w much potential energy has been set free when the load is at the bottom?":"El aro recibe solo el menor empujón y rueda. ¿Cuánta energía potencial se ha liberad\
o cuando la carga está abajo?","While a wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"\
Mientras una rueda rueda, su punto más bajo está en reposo. ¿Qué parte del aro tiene entonces energía cinética y a qué velocidad va el centro?","How fast\
 is a stone that falls from the height of the load? Why can the hoop be faster?":"¿Qué velocidad tiene una piedra que cae desde la altura de la carga? ¿Por qué \
puede ser más rápido el aro?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.":"Halla la fuerza del suelo arriba \
para 1,0 m/s y la velocidad a la que se anula.","In the lab: what does the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.":"En e\
l laboratorio: ¿qué hace el aro en sus primeros 1,5 s y a qué ángulo salta? Completa la tabla.","Find the smallest speed with which the hoop hops, to 1 cm/s\
.":"Halla la menor velocidad con la que el aro salta, con 1 cm/s de precisión.","At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping he\
lp it to hop?":"A 2,2 m/s el aro deja el suelo mientras su llanta desliza. ¿Por qué le ayuda a saltar el deslizamiento?",Show:"Mostrar","Teaching with the hoo\
p":"Enseñar con el aro",Worksheet:"Hoja de trabajo",Solutions:"Soluciones",Exercises:"Ejercicios","A lesson of 45 minutes":"Una clase de 45 minutos",Minute:"Mi\
nuto",Motion:"Movimiento","What students often think":"Lo que suelen pensar los estudiantes",Idea:"Idea","What is right":"Lo correcto","Worksheet: the hoop that\
 hops":"Hoja de trabajo: el aro que salta","A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a leve\
l floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Un anillo delgado de radio 0,40 m tiene una masa de 0,25 kg. En\
 su llanta va fijada una carga de 0,75 kg. El aro está sobre un suelo horizontal con la carga arriba y se empuja hacia la derecha. Rozamiento: μ = 1; g = 9,81 m\
/s².",phases:"fases","does it hop?":"¿salta?","at which angle?":"¿a qué ángulo?",Print:"Imprimir","The visit asks before it shows; the presentation fills t\
he screen; the table gives numbers to every student.":"La visita pregunta antes de mostrar; la presentación llena la pantalla; la tabla da números a cada estudi\
ante.",inf:"inf","greater than {least}":"mayor que {least}","at least {least}":"como mínimo {least}","at least {least} (inf is allowed)":"como mínimo {least} (\
se admite inf)","at most {most}":"como mucho {most}","a finite number":"un número finito","a whole number":"un número entero","'{word}' or '{word2}'":"«{word}\
» o «{word2}»","'{word}', '{word2}' or '{word3}'":"«{word}», «{word2}» o «{word3}»","Rolling resistance":"Resistencia a la rodadura","Rolling resistanc\
e: couple against the rotation over R N":"Resistencia a la rodadura: par contra el giro, dividido por R N","Slips, hops":"Desliza, salta","no threshold uphill (\
β < 0): whether it slips or hops hangs on where it turns back; the map shows it":"cuesta arriba (β < 0) no hay umbral: que deslice o salte depende de dónde da \
la vuelta; el mapa lo muestra","'rigid' for a map":"«rigid» para un mapa","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells por y.\
cells = {cells} debe ser como mucho {most} en el laboratorio.","{one} and {other} cannot both be axes: they say the same thing in two ways.":"{one} y {other} no\
 pueden ser ambos ejes: dicen lo mismo de dos maneras.","x.path and y.path are both {path} and must differ.":"x.path e y.path son ambos {path} y deben ser disti\
ntos.","lost to rolling resistance":"perdida por resistencia a la rodadura","Rolling resistance f":"Resistencia a la rodadura f","{name} = {value} must lie betw\
een -pi/2 and pi/2 (radians).":"{name} = {value} debe estar entre -pi/2 y pi/2 (radianes).","{word} is not a known key; known are {word2}.":"{word} no es una cl\
ave conocida; las conocidas son {word2}.","{one} cannot be given together with {other}.":"{one} no puede darse junto con {other}.","{one} = {value} must not exc\
eed {other} = {limit}.":"{one} = {value} no debe superar {other} = {limit}.","plane.mu_static = inf must be finite with contact.model = 'compliant'.":"plane.mu_\
static = inf debe ser finito con contact.model = 'compliant'.","hoop.parts must not be empty.":"hoop.parts no debe estar vacío.","This takes longer than {time}\
 s; ask for a shorter motion or fewer cells.":"Esto tarda más de {time} s; pide un movimiento más corto o menos celdas.","The lab is busy; try again in {time}\
 seconds.":"El laboratorio está ocupado; inténtalo de nuevo en {time} segundos.","The lab is busy; try again in 1 second.":"El laboratorio está ocupado; intén\
talo de nuevo en 1 segundo.","The computation failed.":"El cálculo ha fallado.","The process that computed this has ended.":"El proceso que calculaba esto ha t\
erminado.","duration = {value} must be at most {most} s in the lab; the library itself has no such limit.":"duration = {value} debe ser como mucho {most} s en e\
l laboratorio; la biblioteca misma no tiene ese límite.","duration = {value} s at this speed and radius is about {turns} revolutions and must be at most {most}\
 in the lab; the library itself has no such limit.":"duration = {value} s son unas {turns} vueltas a esta velocidad y radio, y en el laboratorio como mucho {mos\
t}; la biblioteca misma no tiene ese límite.","hoop.parts has {count} parts and must have at most {most} in the lab.":"hoop.parts tiene {count} piezas y debe t\
ener como mucho {most} en el laboratorio.","contact.stiffness, contact.slip_speed and duration need about {steps} steps of integration and must need at most {mo\
st} in the lab.":"contact.stiffness, contact.slip_speed y duration requieren unos {steps} pasos de integración, y en el laboratorio como mucho {most}.","A cell\
 of this map is about {turns} revolutions and must be at most {most} in the lab.":"Una celda de este mapa son unas {turns} vueltas, y en el laboratorio como muc\
ho {most}.","x and y make {count} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter \
duration.":"x e y dan {count} celdas con unas {turns} vueltas en total, y en el laboratorio como mucho {most}; toma menos celdas, velocidades menores o una dura\
ción más corta.","duration = {value} must be at most {most} s for a film from the lab.":"duration = {value} debe ser como mucho {most} s para una película del\
 laboratorio.","A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A azul, B ocre; el trazo indica la magnitud; números de {hoop}; {h\
ands}"};var Pn={roll:"roulement",spin:"patinage",skid:"dérapage",flight:"vol",skim:"effleurement",hop:"saut","slip −":"glissement −","slip +":"glissement +",rolls:"\
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
"The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"Le serveur ne répond pas. Ce qui est là continue ; pour le\
 modifier, relancez `hophoop lab`.","The server answered {status}.":"Le serveur a répondu {status}.","The notebook’s kernel does not answer; run the cell again\
.":"Le noyau du notebook ne répond pas ; relancez la cellule.",hoop:"cerceau",mode:"phase",time:"temps",angle:"angle",gap:"écart","rim speed":"vitesse de jant\
e",load:"masselotte","centre of gravity":"centre de gravité","the same in flight":"le même en vol","A in front, B behind":"A devant, B derrière","The hoop":"\
Le cerceau","The hoop.":"Le cerceau.",Time:"Temps","{time} seconds, {what}":"{time} secondes, {what}","Traces (t)":"Trajectoires (t)","Forces (f)":"Forces (f)",
"Rim speed (c)":"Vitesse de la jante (c)","Whole path (w)":"Tout le trajet (w)","In space (3)":"En 3D (3)",Traces:"Trajectoires",Forces:"Forces","Rim speed":"Vi\
t. jante","Whole path":"Trajet entier","Play (space)":"Lecture (espace)","Pause (space)":"Pause (espace)","Speed of the film":"Vitesse du film","To the start (H\
ome)":"Au début (Début)","Previous event (Shift ←)":"Événement précédent (Maj ←)","Next event (Shift →)":"Événement suivant (Maj →)","One frame \
back (←)":"Une image en arrière (←)","One frame on (→)":"Une image en avant (→)",landing:"retombée","To the next flight (h)":"Au vol suivant (h)","To \
the next landing (l)":"À la retombée suivante (l)","This motion has no flight.":"Ce mouvement n’a pas de vol.","This motion has no landing.":"Ce mouvement n\
’a pas de retombée.","{what} at {angle}, {time} s":"{what} à {angle}, {time} s",start:"départ","slip begins":"le glissement commence","slip ends":"le gliss\
ement cesse","slip turns round":"le glissement s’inverse","take-off":"décollage","turns back":"fait demi-tour","highest point":"point le plus haut","bounces \
end":"les rebonds cessent","Painlevé: several solutions":"Painlevé : plusieurs solutions","energy gain (Kane)":"gain d’énergie (Kane)","skimming begins":"l\
’effleurement commence","at rest":"au repos",end:"fin","What happens":"Ce qui se passe","What happens to hoop {hoop}":"Ce qui arrive au cerceau {hoop}","The m\
otion in words":"Le mouvement en mots","(not all events are shown)":"(tous les événements ne sont pas montrés)","What theory says":"Ce que dit la théorie","\
What theory says of hoop {hoop}":"Ce que dit la théorie du cerceau {hoop}",Velocities:"Vitesses","velocity [m/s]":"vitesse [m/s]","v (centre)":"v (centre)","En\
ergies and losses":"Énergies et pertes","energy [J]":"énergie [J]",kinetic:"cinétique",potential:"potentielle",total:"totale","lost to friction":"perdue par \
frottement","lost in the damper":"perdue dans l’amortisseur","lost in impacts, normal part":"perdue dans les impacts, part normale","Contact forces":"Forces d\
e contact","force [N]":"force [N]","normal N":"normale N","friction F":"frottement F","Use of friction":"Utilisation du frottement","Your choice":"À votre choix",
"What your diagram shows":"Ce que montre votre diagramme","Horizontal axis of the diagrams":"Axe horizontal des diagrammes","over {quantity}":"en fonction de : \
{quantity}","Whole motion":"Tout le mouvement","slide to go there, two fingers zoom":"glissez pour y aller ; deux doigts agrandissent","click to go there, drag \
to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"cliquez pour y aller, tirez pour agrandir ; après un clic, ou avec Ctrl, la molette\
 agrandit ; double-clic pour tout","{name} from {low} to {high}":"{name} de {low} à {high}","Diagram: {title} in {unit}.":"Diagramme : {title} en {unit}.","θ m\
od 360°":"θ mod 360°",Esc:"Échap","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"angle dans un tour","place of the centre":"position du centre",
"gap under the rim":"écart sous la jante","height of the centre of gravity":"hauteur du centre de gravité","speed of the centre":"vitesse du centre","speed of\
 rotation":"vitesse de rotation","speed away from the plane":"vitesse d’éloignement du plan","slip velocity":"vitesse de glissement","angular velocity":"vite\
sse angulaire","normal force":"force normale","friction force":"force de frottement","use of friction":"utilisation du frottement","kinetic energy":"énergie cin\
étique","potential energy":"énergie potentielle","total energy":"énergie totale","Plane of θ and θ̇":"Plan de θ et θ̇","Plane of angle and angular velo\
city with the regions of rolling, slip and flight":"Plan de l’angle et de la vitesse angulaire avec les régions de roulement, de glissement et de vol","angle\
 θ within a turn [°]":"angle θ dans un tour [°]","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"Cou\
leurs : la phase qui suit un contact sans glissement. Hachures : glissement qui rencontre le paradoxe de Painlevé.","Click to go there; two fingers zoom.":"Tou\
chez pour y aller ; deux doigts agrandissent.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Cliquez pour y aller ; a\
près un clic, ou avec Ctrl, la molette agrandit ; double-clic pour tout.",Map:"Carte",of:"de",Across:"Horizontale",Up:"Verticale","What the map shows":"Ce que \
montre la carte","Map of motions":"Carte des mouvements","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Carte des mou\
vements. Les flèches déplacent la marque, Entrée prend le mouvement, plus et moins agrandissent.","Zoom into the map":"Agrandir la carte","Zoom out of the ma\
p":"Réduire la carte","Whole map":"Carte entière","Click to take that motion into the player; two fingers zoom.":"Touchez pour mettre ce mouvement dans le lec\
teur ; deux doigts agrandissent.","Click to take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"\
Un clic met ce mouvement dans le lecteur ; après un clic, ou avec Ctrl, la molette agrandit ; tirez pour déplacer ; double-clic pour tout.","computing {count}\
 motions …":"calcul de {count} mouvements…","{count} motions":"{count} mouvements","{count} motions, with rigid contact":"{count} mouvements, avec contact r\
igide","of rolling starts, though this motion starts otherwise":"partant en roulant, bien que ce mouvement parte autrement","of starts in any state, though this\
 motion starts rolling":"partant d’un état quelconque, bien que ce mouvement parte en roulant","compiling the kernel of maps, this once: {done} of {all} func\
tions":"compilation du noyau des cartes, cette fois seulement : {done} fonctions sur {all}",Keep:"Garder","Copy the link":"Copier le lien","Scenario (TOML)":"Sc\
énario (TOML)","States (CSV)":"États (CSV)","Motion (netCDF)":"Mouvement (netCDF)","Events (JSON)":"Événements (JSON)","Film (MP4)":"Film (MP4)","Picture (P\
NG)":"Image (PNG)","Record a film here (WebM)":"Enregistrer un film ici (WebM)","Show me the Python":"Montrer le Python","The same motion in Python":"Le même mo\
uvement en Python","The link is copied.":"Le lien est copié.","The link to this motion":"Le lien vers ce mouvement","The film is being made; this takes a while\
 …":"Le film se fait ; cela prend un moment…","Fetching {name} …":"Récupération de {name}…","{name} is there.":"{name} est là.","This browser cannot \
record a canvas; take the MP4 instead.":"Ce navigateur ne peut pas enregistrer le canevas ; prenez le MP4.","Recording one run …":"Enregistrement d’un passage\
…","The film is there.":"Le film est là.","The scenario as a file":"Le scénario en fichier",Copy:"Copier",Copied:"Copié",Close:"Fermer","A ring with a load\
 on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanic\
s cannot decide. Move a slider and see.":"Un anneau lesté d’une masselotte roule sur un plan. Le frottement ne retient pas sans limite et le plan ne peut que po\
usser : alors il glisse, saute, retombe – ou fait ce que la mécanique du solide ne peut décider. Bougez un réglage et voyez.",Modes:"Phases","Marks on the \
bar of time":"Marques sur la barre de temps",Keys:"Touches",space:"espace","play, pause":"lecture, pause","one frame":"une image","Shift ← →":"Maj ← →",
"previous, next event":"événement précédent, suivant","next flight, landing":"vol, retombée suivants","slower, faster":"plus lent, plus vite","Home End":"D\
ébut Fin","start, end":"début, fin","traces, forces, rim speed, whole path":"trajectoires, forces, vitesse de la jante, trajet","in space":"en 3D","zoom, zoom\
 back":"agrandir, revenir","leave a field, a menu, a picture that the wheel zooms":"quitter un champ, un menu, une image que la molette agrandit","z y  Ctrl Z":"\
z y  Ctrl Z","undo, redo":"annuler, rétablir","dark, light":"sombre, clair",Python:"Python","the rim does not slide":"la jante ne glisse pas","slip: the rim tu\
rns too fast for the way it goes (slip −, for a hoop that rolls ahead)":"glissement : la jante tourne trop vite pour son trajet (glissement −, pour un cerceau\
 qui avance)","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"glissement : la jante glisse vers l’avant (glissement +, pour un cerceau qui a\
vance)","the hop: from take-off to landing":"le saut : du décollage à la retombée","a massless rim that touches without force":"une jante sans masse qui touc\
he sans force","take-off, landing":"décollage, retombée","Painlevé’s paradox: no solution, several":"Paradoxe de Painlevé : aucune solution, plusieurs","b\
ounces without number end":"une infinité de rebonds s’achève","skimming begins, rest":"l’effleurement commence, repos","Single keys (letters, digits, sign\
s) do what the table says":"Les touches seules (lettres, chiffres, signes) font ce que dit le tableau","The hoop in your hand":"Le cerceau dans votre main","Slo\
pe of the plane":"Inclinaison du plan","Tilt the plane: drag, or arrow keys":"Incliner le plan : tirer, ou flèches","The hoop: height and speed":"Le cerceau : \
hauteur et vitesse","Lift, roll or throw the hoop: drag, or arrow keys":"Lever, rouler ou lancer le cerceau : tirer, ou flèches","Angle of the load":"Angle de \
la masselotte","Turn the load: drag, or arrow keys":"Tourner la masselotte : tirer, ou flèches","gap {height}, speed {speed} m/s":"écart {height}, vitesse {spe\
ed} m/s",Repeat:"Répéter","Slow motion: a tenth of the speed":"Ralenti : un dixième de la vitesse","Sound of the contact":"Son du contact","Presentation on t\
he whole screen":"Présentation en plein écran","Guided visit":"Visite guidée","Table of the motion":"Tableau du mouvement","Table of the motion, rows":"Table\
au du mouvement, lignes",Presentation:"Présentation","For teachers":"Pour les enseignants",Table:"Tableau",Every:"Toutes les","Save as CSV":"Enregistrer en CSV",
Columns:"Colonnes","The first {count} rows.":"Les {count} premières lignes.",Challenges:"Défis","Leave the challenges":"Quitter les défis","Which challenge":"\
Quel défi",Score:"Score","Begin again":"Recommencer","Show a best one":"Montrer un des meilleurs","{stars} {points} points. {what}":"{stars} {points} points. {\
what}","Your best: {points} points.":"Votre meilleur : {points} points.","Hop highest":"Sauter le plus haut","On level ground, rolling, with at most 3.1 m/s: yo\
u choose the load, where it starts, and friction. How high can the hoop rise within 6 s?":"Sur sol horizontal, en roulant, à 3,1 m/s au plus : vous choisissez l\
a masselotte, sa position de départ et le frottement. À quelle hauteur le cerceau peut-il monter en 6 s ?","Land upright":"Retomber debout","Let the hoop land\
 with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.":"Faites retomber le cerceau avec la masselotte tout en haut.\
 Tout est permis ; le premier saut doit faire au moins 5 cm.","Hop without skidding":"Sauter sans déraper","On level ground the hoop starts rolling with its lo\
ad at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Sur sol horizontal\
 le cerceau part en roulant, la masselotte en bas, à 10 m/s au plus, et μ vaut au plus 1,5. Avant de sauter il ne doit pas déraper ; patiner est permis. À quell\
e hauteur saute-t-il ?","Rigid contact only.":"Contact rigide seulement.","The plane must be level.":"Le plan doit être horizontal.","It must be on Earth.":"Ce\
 doit être sur Terre.","Restitution must be 0.":"La restitution doit être 0.","The radius must stay 1 m, without parts.":"Le rayon doit rester 1 m, sans pièce\
s.","At most 90 % of the mass may be in the load.":"Au plus 90 % de la masse dans la masselotte.","The hoop must be given by its load fraction.":"Le cerceau doi\
t être donné par la part de la masselotte.","It must start rolling.":"Il doit partir en roulant.","At most 10 m/s.":"Au plus 10 m/s.","At most 3.1 m/s.":"Au p\
lus 3,1 m/s.","At most 6 s.":"Au plus 6 s.","It does not hop.":"Il ne saute pas.","It rises by {height}.":"Il monte de {height}.","The first hop is too low.":"L\
e premier saut est trop bas.","It lands {off} away from the top.":"Il retombe à {off} du sommet.","The load must start at the bottom.":"La masselotte doit part\
ir d’en bas.","Friction must be at most 1.5.":"Le frottement doit être au plus 1,5.","It skids before it hops.":"Il dérape avant de sauter.","New here?":"Pr\
emière visite ?","Eight short questions: guess, then play.":"Huit questions brèves : devinez, puis lancez.","Start the visit":"Commencer la visite","Not now":"\
Pas maintenant","The hoop, before it is let go.":"Le cerceau, avant d’être lâché.",Play:"Lancer",Next:"Suivant",Back:"Retour",Done:"Terminé","Step {number\
} of {all}":"Étape {number} sur {all}","Leave the visit":"Quitter la visite","First say what you expect, then play.":"Dites d’abord ce que vous attendez, puis \
lancez.","Your guess":"Votre réponse","{points} of 100 points.":"{points} points sur 100.","You have {sum} of {most} points.":"Vous avez {sum} points sur {most\
}.","{what} with the load at {angle}":"{what} avec la masselotte à {angle}","Draw the curve: pull the points up and down":"Tracez la courbe : tirez les points \
vers le haut ou le bas","Littlewood’s question":"La question de Littlewood","A hoop without mass has a weight on its rim. With the weight at the top it gets t\
he smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the weight is level with the centre.":"Un cerceau sans masse porte un poids sur sa \
jante. Le poids en haut, il reçoit la plus petite poussée et roule. J. E. Littlewood demanda en 1953 ce qui se passe quand le poids est à la hauteur du centre.",
"What do you think?":"Qu’en pensez-vous ?","It rolls on.":"Il continue de rouler.","It hops: the hoop leaves the plane.":"Il saute : le cerceau quitte le plan\
.","The weight falls freely, and the hoop skims the plane below it.":"Le poids tombe en chute libre, et le cerceau effleure le plan sous lui.","At {angle} there\
 is no contact force any more.":"À {angle} il n’y a plus de force de contact.","Littlewood said that the hoop hops. But the contact force is zero, not upward\
s: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim.":"Littlewood disait que le cerceau sau\
te. Mais la force de contact est nulle, non dirigée vers le haut : le poids tombe en chute libre et une jante sans masse le suit le long du plan. Pour sauter, i\
l faut au cerceau un peu de masse dans la jante.","A ring with mass":"Un anneau avec masse","Now a quarter of the mass is in the ring. Again the load is at the \
top, and the hoop gets the smallest push.":"À présent un quart de la masse est dans l’anneau. De nouveau la masselotte est en haut et le cerceau reçoit la plus \
petite poussée.","Draw how fast the hoop’s centre goes during the first turn.":"Tracez la vitesse du centre du cerceau pendant le premier tour.","Speed of th\
e centre":"Vitesse du centre","With the load at the bottom the centre has {speed} m/s.":"Avec la masselotte en bas, le centre a {speed} m/s.","The lowest point \
of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: it is faster than a stone that fall\
s from the same height.":"Le point le plus bas d’un cerceau qui roule est au repos. Là, la masselotte n’a pas d’énergie cinétique, et l’anneau léger a tout ce q\
ue la lourde masselotte a perdu : il est plus rapide qu’une pierre tombant de la même hauteur.","Why it slips":"Pourquoi il glisse","A harder push: 2.8 m/s a\
t the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Une poussée plus forte : 2,8 m/s en haut. Rouler exige du frottement, et le f\
rottement a une limite : il vaut au plus μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"Où est la masselotte quand le fr\
ottement cède pour la première fois ? Tournez la marque.","Angle of the load where it begins to slip":"Angle de la masselotte où il commence à glisser","It \
begins to slip at {angle}. There the plane carries only {share} of the weight.":"Il commence à glisser à {angle}. Là, le plan ne porte que {share} du poids.",
"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagra\
m ‘Use of friction’: it comes to 1.":"Dans sa descente la masselotte appuie peu sur le plan : N est petite, alors que l’anneau doit accélérer, ce qui demand\
e du frottement. Voyez le diagramme « Utilisation du frottement » : elle atteint 1.","The hop":"Le saut","A little faster, 3.1 m/s. This time the hoop leaves \
the plane, before the first turn is over.":"Un peu plus vite, 3,1 m/s. Cette fois le cerceau quitte le plan avant la fin du premier tour.","Where is the load wh\
en the hoop takes off? Turn the mark.":"Où est la masselotte quand le cerceau décolle ? Tournez la marque.","Angle of the load where it takes off":"Angle de l\
a masselotte au décollage","It takes off at {angle}, while its rim slips at {slip} m/s.":"Il décolle à {angle}, tandis que sa jante glisse à {slip} m/s.","A\
 rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pu\
lls it off the plane before it is at the top.":"Le plan freinerait un cerceau qui roule tandis que la masselotte remonte. Le frottement est trop faible pour cel\
a : la jante patine, le cerceau continue de tourner vite, et la masselotte l’arrache du plan avant d’être en haut.","The landing":"La retombée","The hoop \
is in the air. Its centre of gravity goes on a parabola, and it turns evenly.":"Le cerceau est en l’air. Son centre de gravité suit une parabole et il tourne un\
iformément.","What does it do just after it has landed?":"Que fait-il juste après être retombé ?","It rolls at once.":"Il roule aussitôt.","It skids: the r\
im slides ahead.":"Il dérape : la jante glisse vers l’avant.","It spins: the rim turns too fast.":"Il patine : la jante tourne trop vite.","It bounces.":"Il \
rebondit.","It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Il est resté {time} s en l’air et est monté de {height}\
 cm ; il retombe avec la masselotte à {angle}.","An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With l\
ess friction, or more restitution, the landing would be another one. Try it afterwards.":"Un impact ne dure pas, mais son frottement est aussi fort que sa pouss\
ée : ici il suffit à arrêter tout glissement. Avec moins de frottement, ou plus de restitution, la retombée serait autre. Essayez ensuite.","More friction, \
more hop?":"Plus de frottement, plus haut ?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Trois cerceaux reçoivent la\
 même poussée de 3,1 m/s, sur des plans de frottement 0,05, 0,2 et 1,0.","Which of them hops highest?":"Lequel saute le plus haut ?","They rise by {low} cm, {\
middle} cm and {high} cm. (The first two are A and B.)":"Ils montent de {low} cm, {middle} cm et {high} cm. (Les deux premiers sont A et B.)","On ice nothing dr\
ives the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is br\
aked on the way up.":"Sur la glace rien n’entraîne la rotation ; avec un frottement sans fin rien ne glisse. Le saut exige les deux : assez de frottement pour t\
ourner vite à la descente, et pas assez pour être freiné à la remontée.","What rigid bodies cannot decide":"Ce que les solides ne peuvent décider","A hoop\
 is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"On lance un cerceau de sorte q\
u’il glisse vite sur un plan rugueux. Les lois des solides avec frottement sec doivent dire la suite.","What do they say?":"Que disent-elles ?","It flies off.":"\
Il s’envole.","An impact stops the slide at once.":"Un impact arrête aussitôt le glissement.","Both agree with the laws.":"Les deux obéissent aux lois.","H\
oop A and hoop B start alike, and both motions obey every law.":"Les cerceaux A et B partent de même, et les deux mouvements obéissent à toutes les lois.","P\
ainlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that decides: choose the comp\
liant contact under ‘Contact’.":"Painlevé l’a trouvé en 1895. Pour un solide, les lois ont ici deux réponses, dans d’autres états aucune. Les corps réels cè\
dent un peu, et cela décide : choisissez le contact souple sous « Contact ».","Your turn":"À vous","Take the hoop: turn the load, lift the hoop and let it d\
rop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the motion itself.":"Prenez le cerceau : tournez la masselotte, \
levez-le et lâchez-le, lancez-le, inclinez le plan. Ou relevez un défi, et voyez votre score calculé d’après le mouvement lui-même.","Show the hoop at fu\
ll speed, once, without a comment. “I push it. Does it only roll?”":"Montrer le cerceau à pleine vitesse, une fois, sans commentaire. « Je le pousse. Ne fai\
t-il que rouler ? »","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.":"Chacun prédit où est la masselotte au décoll\
age. Compter les voix par quarts de tour.","Energy on the way down, in pairs: who has the energy when the load is at rest?":"L’énergie à la descente, par deux :\
 qui a l’énergie quand la masselotte est au repos ?","Lift at the top: at which speed is the force of the floor zero?":"Soulèvement en haut : à quelle vitess\
e la force du sol est-elle nulle ?","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.":"Le film à nouveau, au ralenti e\
t avec les forces ; arrêter au décollage. Comparer avec les voix.","Each group takes one speed of the worksheet; results on the board.":"Chaque groupe prend u\
ne vitesse de la fiche ; résultats au tableau.","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?":"Pourquo\
i ? Qu’est-ce qui doit freiner la rotation à la remontée, avec quelle force, et si c’est trop faible ?","One sentence each: “The hoop hops because …”":"\
Une phrase chacun : « Le cerceau saute parce que… »","The load pulls the hoop up at the top, so it hops there.":"La masselotte tire le cerceau vers le haut \
au sommet, donc il saute là.","Only if it is very fast. Slower hoops hop before the top, after slipping.":"Seulement s’il est très rapide. Les plus lents saute\
nt avant le sommet, après avoir glissé.","It hops at the bottom, where it is fastest.":"Il saute en bas, où il est le plus rapide.","There the floor pushes h\
ardest: the load has to be turned upwards.":"Là le sol pousse le plus fort : il faut dévier la masselotte vers le haut.","Nothing can be faster than a falling\
 stone.":"Rien ne peut être plus rapide qu’une pierre qui tombe.","The ring can: it gets the energy of a load that has come to rest.":"L’anneau le peut : il \
reçoit l’énergie d’une masselotte qui s’est arrêtée.","Friction always brakes.":"Le frottement freine toujours.","It acts against slip. On the hoop’s \
way up it points forwards.":"Il agit contre le glissement. À la remontée il est dirigé vers l’avant.","More friction, more hop.":"Plus de frottement, plus \
de saut.","There is a best friction in between.":"Il y a un frottement optimal entre les deux.","A heavier hoop behaves otherwise.":"Un cerceau plus lourd se co\
mporte autrement.","Only the shares of mass count.":"Seules les parts de masse comptent.","Before the film: where is the load when the hoop leaves the floor? Ma\
rk the place and give one reason.":"Avant le film : où est la masselotte quand le cerceau quitte le sol ? Marquez l’endroit et donnez une raison.","The hoop \
gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"Le cerceau ne reçoit que la plus petite pou\
ssée et roule. Quelle énergie potentielle a été libérée quand la masselotte est en bas ?","While a wheel rolls, its lowest point is at rest. Which part of\
 the hoop has kinetic energy then, and how fast is the centre?":"Quand une roue roule, son point le plus bas est au repos. Quelle partie du cerceau a alors de l\
’énergie cinétique, et quelle est la vitesse du centre ?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"Quelle \
est la vitesse d’une pierre tombant de la hauteur de la masselotte ? Pourquoi le cerceau peut-il être plus rapide ?","Find the force of the floor at the top \
for 1.0 m/s, and the speed at which it becomes zero.":"Trouvez la force du sol au sommet pour 1,0 m/s, et la vitesse où elle s’annule.","In the lab: what doe\
s the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.":"Dans le labo : que fait le cerceau pendant ses 1,5 premières secondes, et\
 à quel angle saute-t-il ? Remplissez le tableau.","Find the smallest speed with which the hoop hops, to 1 cm/s.":"Trouvez la plus petite vitesse pour laquelle\
 le cerceau saute, à 1 cm/s près.","At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping help it to hop?":"À 2,2 m/s le cerceau quitte \
le sol tandis que sa jante glisse. Pourquoi le glissement l’aide-t-il à sauter ?",Show:"Montrer","Teaching with the hoop":"Enseigner avec le cerceau",Worksheet:"\
Fiche de travail",Solutions:"Corrigé",Exercises:"Exercices","A lesson of 45 minutes":"Une séance de 45 minutes",Minute:"Minute",Motion:"Mouvement","What stude\
nts often think":"Ce que pensent souvent les élèves",Idea:"Idée","What is right":"Ce qui est juste","Worksheet: the hoop that hops":"Fiche de travail : le ce\
rceau sauteur","A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the\
 top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Un anneau mince de rayon 0,40 m a une masse de 0,25 kg. Une masselotte de 0,75 kg est fixée\
 sur sa jante. Le cerceau est posé sur un sol horizontal, la masselotte en haut, et poussé vers la droite. Frottement : μ = 1 ; g = 9,81 m/s².",phases:"phas\
es","does it hop?":"saute-t-il ?","at which angle?":"à quel angle ?",Print:"Imprimer","The visit asks before it shows; the presentation fills the screen; the t\
able gives numbers to every student.":"La visite interroge avant de montrer ; la présentation remplit l’écran ; le tableau donne des nombres à chaque élève.",
inf:"inf","greater than {least}":"supérieur à {least}","at least {least}":"au moins {least}","at least {least} (inf is allowed)":"au moins {least} (inf est pe\
rmis)","at most {most}":"au plus {most}","a finite number":"un nombre fini","a whole number":"un nombre entier","'{word}' or '{word2}'":"« {word} » ou « {word2}\
 »","'{word}', '{word2}' or '{word3}'":"« {word} », « {word2} » ou « {word3} »","Rolling resistance":"Résistance au roulement","Rolling resistance: coup\
le against the rotation over R N":"Résistance au roulement : couple opposé à la rotation, divisé par R N","Slips, hops":"Glisse, saute","no threshold uphill\
 (β < 0): whether it slips or hops hangs on where it turns back; the map shows it":"en montée (β < 0) pas de seuil : qu’il glisse ou saute dépend de l’endroit \
où il fait demi-tour ; la carte le montre","'rigid' for a map":"« rigid » pour une carte","x.cells times y.cells = {cells} must be at most {most} in the lab.":"\
x.cells fois y.cells = {cells} doit être au plus {most} dans le labo.","{one} and {other} cannot both be axes: they say the same thing in two ways.":"{one} et \
{other} ne peuvent être tous deux des axes : ils disent la même chose de deux façons.","x.path and y.path are both {path} and must differ.":"x.path et y.path\
 sont tous deux {path} et doivent différer.","lost to rolling resistance":"perdue par résistance au roulement","Rolling resistance f":"Résistance au roulement\
 f","{name} = {value} must lie between -pi/2 and pi/2 (radians).":"{name} = {value} doit être entre -pi/2 et pi/2 (radians).","{word} is not a known key; known\
 are {word2}.":"{word} n’est pas une clé connue ; sont connues {word2}.","{one} cannot be given together with {other}.":"{one} ne peut pas être donné avec {o\
ther}.","{one} = {value} must not exceed {other} = {limit}.":"{one} = {value} ne doit pas dépasser {other} = {limit}.","plane.mu_static = inf must be finite wi\
th contact.model = 'compliant'.":"plane.mu_static = inf doit être fini avec contact.model = 'compliant'.","hoop.parts must not be empty.":"hoop.parts ne doit p\
as être vide.","This takes longer than {time} s; ask for a shorter motion or fewer cells.":"Cela prend plus de {time} s ; demandez un mouvement plus court ou m\
oins de cellules.","The lab is busy; try again in {time} seconds.":"Le labo est occupé ; réessayez dans {time} secondes.","The lab is busy; try again in 1 sec\
ond.":"Le labo est occupé ; réessayez dans 1 seconde.","The computation failed.":"Le calcul a échoué.","The process that computed this has ended.":"Le proce\
ssus qui calculait cela s’est arrêté.","duration = {value} must be at most {most} s in the lab; the library itself has no such limit.":"duration = {value} d\
oit être au plus {most} s dans le labo ; la bibliothèque elle-même n’a pas cette limite.","duration = {value} s at this speed and radius is about {turns} r\
evolutions and must be at most {most} in the lab; the library itself has no such limit.":"duration = {value} s font environ {turns} tours à cette vitesse et ce \
rayon, au plus {most} dans le labo ; la bibliothèque elle-même n’a pas cette limite.","hoop.parts has {count} parts and must have at most {most} in the lab.":"\
hoop.parts a {count} pièces et doit en avoir au plus {most} dans le labo.","contact.stiffness, contact.slip_speed and duration need about {steps} steps of inte\
gration and must need at most {most} in the lab.":"contact.stiffness, contact.slip_speed et duration demandent environ {steps} pas d’intégration, au plus {most}\
 dans le labo.","A cell of this map is about {turns} revolutions and must be at most {most} in the lab.":"Une cellule de cette carte fait environ {turns} tours,\
 au plus {most} dans le labo.","x and y make {count} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower s\
peeds or a shorter duration.":"x et y font {count} cellules d’environ {turns} tours en tout, au plus {most} dans le labo ; prenez moins de cellules, des vitesse\
s plus faibles ou une durée plus courte.","duration = {value} must be at most {most} s for a film from the lab.":"duration = {value} doit être au plus {most} s\
 pour un film du labo.","A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A bleu, B ocre ; le tracé indique la grandeur ; nombres d\
e {hoop} ; {hands}"};var In={roll:"滚动",spin:"空转",skid:"拖滑",flight:"腾空",skim:"擦地",hop:"跳起","slip −":"滑动 −","slip +":"滑动 +",rolls:"滚动",spins:"空\
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
_ratio = 0）","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"为 'rigid'（无质量圆环，hoop.inertia_ratio = 0）","The server does not answer.\
 What is here goes on playing; changes need `hophoop lab` to run again.":"服务器没有响应。已有内容可以继续播放；要更改需重新运行 `hophoop lab`。",
"The server answered {status}.":"服务器返回 {status}。","The notebook’s kernel does not answer; run the cell again.":"笔记本内核没有响应；请重新运行单元格。",
hoop:"圆环",mode:"状态",time:"时间",angle:"角度",gap:"间隙","rim speed":"环缘速度",load:"重物","centre of gravity":"重心","the same in flight":"\
腾空时的重心","A in front, B behind":"A 在前，B 在后","The hoop":"圆环","The hoop.":"圆环。",Time:"时间","{time} seconds, {what}":"{time} 秒，{w\
hat}","Traces (t)":"轨迹 (t)","Forces (f)":"力 (f)","Rim speed (c)":"环缘速度 (c)","Whole path (w)":"全程 (w)","In space (3)":"三维 (3)",Traces:"轨迹",
Forces:"力","Rim speed":"环缘速度","Whole path":"全程","Play (space)":"播放（空格）","Pause (space)":"暂停（空格）","Speed of the film":"播放速度",
"To the start (Home)":"回到开头 (Home)","Previous event (Shift ←)":"上一事件 (Shift ←)","Next event (Shift →)":"下一事件 (Shift →)","One fra\
me back (←)":"后退一帧 (←)","One frame on (→)":"前进一帧 (→)",landing:"落地","To the next flight (h)":"到下一次腾空 (h)","To the next la\
nding (l)":"到下一次落地 (l)","This motion has no flight.":"此运动没有腾空。","This motion has no landing.":"此运动没有落地。","{what} at \
{angle}, {time} s":"{what}:{angle},{time} s",start:"开始","slip begins":"滑动开始","slip ends":"滑动结束","slip turns round":"滑动反向","take-off":"\
离地","turns back":"折返","highest point":"最高点","bounces end":"弹跳结束","Painlevé: several solutions":"潘勒韦：多个解","energy gain (Kane\
)":"能量增加（凯恩）","skimming begins":"开始擦地","at rest":"静止",end:"结束","What happens":"发生了什么","What happens to hoop {hoop}":"圆\
环 {hoop} 发生了什么","The motion in words":"运动的文字描述","(not all events are shown)":"（未显示全部事件）","What theory says":"理论怎么说",
"What theory says of hoop {hoop}":"理论对圆环 {hoop} 的结论",Velocities:"速度","velocity [m/s]":"速度 [m/s]","v (centre)":"v（圆心）","Energies \
and losses":"能量与损耗","energy [J]":"能量 [J]",kinetic:"动能",potential:"势能",total:"总能量","lost to friction":"摩擦损耗","lost in the dam\
per":"阻尼损耗","lost in impacts, normal part":"碰撞损耗，法向部分","Contact forces":"接触力","force [N]":"力 [N]","normal N":"法向力 N","fr\
iction F":"摩擦力 F","Use of friction":"摩擦利用率","Your choice":"自选","What your diagram shows":"自选图的纵轴","Horizontal axis of the diagra\
ms":"图的横轴","over {quantity}":"横轴：{quantity}","Whole motion":"整个运动","slide to go there, two fingers zoom":"滑动以跳转，双指缩放",
"click to go there, drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"单击跳转，拖动放大；单击后或按住 Ctrl 时滚轮缩放；双击显示全部",
"{name} from {low} to {high}":"{name}：{low} 至 {high}","Diagram: {title} in {unit}.":"图：{title}，单位 {unit}。","θ mod 360°":"θ mod 360°",Esc:"Es\
c","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"一圈内的角度","place of the centre":"圆心位置","gap under the rim":"圆环下的间隙",
"height of the centre of gravity":"重心高度","speed of the centre":"圆心速度","speed of rotation":"转动线速度","speed away from the plane":"离开平面的速度",
"slip velocity":"滑动速度","angular velocity":"角速度","normal force":"法向力","friction force":"摩擦力","use of friction":"摩擦利用率","kinet\
ic energy":"动能","potential energy":"势能","total energy":"总能量","Plane of θ and θ̇":"θ–θ̇ 相平面","Plane of angle and angular velocity wit\
h the regions of rolling, slip and flight":"角度与角速度相平面，标出滚动、滑动与腾空区域","angle θ within a turn [°]":"一圈内的角度 θ [°]",
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"颜色：无滑动接触之后的状态。阴影线：会遇到潘勒韦悖论的滑动。",
"Click to go there; two fingers zoom.":"点按跳转；双指缩放。","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"\
单击跳转；单击后或按住 Ctrl 时滚轮缩放；双击显示全部。",Map:"分布图",of:"内容",Across:"横轴",Up:"纵轴","What the map shows":"分布\
图显示的内容","Map of motions":"运动分布图","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"运动分布图。方向键移动标记，回\
车采用该运动，加减号缩放。","Zoom into the map":"放大分布图","Zoom out of the map":"缩小分布图","Whole map":"整张图","Click to take th\
at motion into the player; two fingers zoom.":"点按即可把该运动放入播放器；双指缩放。","Click to take that motion into the player; once click\
ed, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"单击即可把该运动放入播放器；单击后或按住 Ctrl 时滚轮缩放；拖动平移；双击显示全部。",
"computing {count} motions …":"正在计算 {count} 个运动……","{count} motions":"{count} 个运动","{count} motions, with rigid contact":"{count} 个运动，\
刚性接触","of rolling starts, though this motion starts otherwise":"均为滚动起始，而当前运动并非如此","of starts in any state, though this m\
otion starts rolling":"均为任意状态起始，而当前运动为滚动起始","compiling the kernel of maps, this once: {done} of {all} functions":"正在编译分布图内\
核（仅此一次）：{done}/{all} 个函数",Keep:"保存","Copy the link":"复制链接","Scenario (TOML)":"场景 (TOML)","States (CSV)":"状态 (CSV)","Mo\
tion (netCDF)":"运动 (netCDF)","Events (JSON)":"事件 (JSON)","Film (MP4)":"影片 (MP4)","Picture (PNG)":"图片 (PNG)","Record a film here (WebM)":"在此录制影片 \
(WebM)","Show me the Python":"显示 Python 代码","The same motion in Python":"同一运动的 Python 代码","The link is copied.":"链接已复制。","The \
link to this motion":"此运动的链接","The film is being made; this takes a while …":"正在制作影片，请稍候……","Fetching {name} …":"正在获取 {n\
ame}……","{name} is there.":"{name} 已就绪。","This browser cannot record a canvas; take the MP4 instead.":"此浏览器无法录制画布；请改用 MP4。",
"Recording one run …":"正在录制一遍……","The film is there.":"影片已就绪。","The scenario as a file":"场景文件",Copy:"复制",Copied:"已复制",
Close:"关闭","A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does \
something that rigid-body mechanics cannot decide. Move a slider and see.":"一个边缘带重物的环在平面上滚动。摩擦力有上限，平面只能推不能拉：于是它打滑、跳起、落地——或者做出刚体力学无法判定的事。拖动滑块看看。",
Modes:"状态","Marks on the bar of time":"时间条上的标记",Keys:"按键",space:"空格","play, pause":"播放、暂停","one frame":"一帧","Shift ← →":"\
Shift ← →","previous, next event":"上一、下一事件","next flight, landing":"下一次腾空、落地","slower, faster":"更慢、更快","Home End":"H\
ome End","start, end":"开头、结尾","traces, forces, rim speed, whole path":"轨迹、力、环缘速度、全程","in space":"三维","zoom, zoom back":"缩放\
、还原","leave a field, a menu, a picture that the wheel zooms":"离开输入框、菜单或滚轮缩放的图","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"撤销、\
重做","dark, light":"深色、浅色",Python:"Python","the rim does not slide":"环缘不滑动","slip: the rim turns too fast for the way it goes (slip −, fo\
r a hoop that rolls ahead)":"滑动：环缘转得比前进快（圆环向前滚时为滑动 −）","slip: the rim slides ahead (slip +, for a hoop that rolls \
ahead)":"滑动：接触点向前滑（圆环向前滚时为滑动 +）","the hop: from take-off to landing":"跳起：从离地到落地","a massless rim that \
touches without force":"无质量的环缘，接触而无力","take-off, landing":"离地、落地","Painlevé’s paradox: no solution, several":"潘勒韦悖论：无解、多解",
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
he screen; the table gives numbers to every student.":"参观先提问后演示；演示占满屏幕；数据表为每个学生提供数字。",inf:"inf","great\
er than {least}":"大于 {least}","at least {least}":"不小于 {least}","at least {least} (inf is allowed)":"不小于 {least}（允许 inf）","at most {most}":"\
不大于 {most}","a finite number":"是有限的数","a whole number":"是整数","'{word}' or '{word2}'":"为“{word}”或“{word2}”","'{word}', '{word2}\
' or '{word3}'":"为“{word}”、“{word2}”或“{word3}”","Rolling resistance":"滚动阻力","Rolling resistance: couple against the rotation over R N":"\
滚动阻力：阻碍转动的力偶与 R N 之比","Slips, hops":"打滑、跳起","no threshold uphill (β < 0): whether it slips or hops hangs on where it tur\
ns back; the map shows it":"上坡(β < 0)没有阈值：是否打滑或跳起取决于在何处折返；分布图会显示","'rigid' for a map":"为 'rigid'（用于分布\
图）","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells 乘 y.cells = {cells} 在本实验室中不得超过 {most}。","{one} and\
 {other} cannot both be axes: they say the same thing in two ways.":"{one} 与 {other} 不能同时作为坐标轴：它们以两种方式表示同一个量。",
"x.path and y.path are both {path} and must differ.":"x.path 与 y.path 都是 {path}，必须不同。","lost to rolling resistance":"滚动阻力损耗","Roll\
ing resistance f":"滚动阻力 f","{name} = {value} must lie between -pi/2 and pi/2 (radians).":"{name} = {value} 必须在 -pi/2 与 pi/2 之间（弧度）。",
"{word} is not a known key; known are {word2}.":"{word} 不是已知的键；已知的有 {word2}。","{one} cannot be given together with {other}.":"{one} 不能与 \
{other} 同时给定。","{one} = {value} must not exceed {other} = {limit}.":"{one} = {value} 不得超过 {other} = {limit}。","plane.mu_static = inf must be\
 finite with contact.model = 'compliant'.":"contact.model = 'compliant' 时 plane.mu_static = inf 必须为有限值。","hoop.parts must not be empty.":"hoop.p\
arts 不能为空。","This takes longer than {time} s; ask for a shorter motion or fewer cells.":"耗时超过 {time} s；请缩短运动或减少格数。","T\
he lab is busy; try again in {time} seconds.":"实验室繁忙；请在 {time} 秒后重试。","The lab is busy; try again in 1 second.":"实验室繁忙；请在 1 秒后重试。",
"The computation failed.":"计算失败。","The process that computed this has ended.":"执行此计算的进程已结束。","duration = {value} must be at mo\
st {most} s in the lab; the library itself has no such limit.":"duration = {value} 在本实验室中不得超过 {most} s；库本身没有此限制。","durat\
ion = {value} s at this speed and radius is about {turns} revolutions and must be at most {most} in the lab; the library itself has no such limit.":"在此速度与半径下 du\
ration = {value} s 约为 {turns} 圈，本实验室中不得超过 {most}；库本身没有此限制。","hoop.parts has {count} parts and must have at most {m\
ost} in the lab.":"hoop.parts 有 {count} 个部件，本实验室中不得超过 {most}。","contact.stiffness, contact.slip_speed and duration need about {ste\
ps} steps of integration and must need at most {most} in the lab.":"contact.stiffness、contact.slip_speed 与 duration 约需 {steps} 步积分，本实验室中不得超过 {most}。",
"A cell of this map is about {turns} revolutions and must be at most {most} in the lab.":"此分布图的一格约为 {turns} 圈，本实验室中不得超过 {most}。",
"x and y make {count} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter duration.":"\
x 与 y 共 {count} 格，约 {turns} 圈，本实验室中不得超过 {most}；请减少格数、降低速度或缩短时长。","duration = {value} must be a\
t most {most} s for a film from the lab.":"从本实验室制作影片时 duration = {value} 不得超过 {most} s。","A blue, B ochre; the dashes tell the qua\
ntities; numbers of {hoop}; {hands}":"A 为蓝色，B 为赭色；线型表示物理量；数值属于 {hoop}；{hands}"};var Hs=new Map;function ae(o){try{return localStorage.getItem(o)??Hs.get(o)??null}catch{return Hs.get(o)??null}}function re(o,e){Hs.set(o,e);try{localStorage.setItem(
o,e)}catch{}}var lt={en:"English",de:"Deutsch",es:"Español",fr:"Français",zh:"中文"},Us={de:zn,es:Rn,fr:Pn,zh:In},lr=new Set(["de","es","fr"]),qn="hophoop-language",jn=4e3,
hr=/^((\d\S* )?(rad(\/s)?|kg|m\/s²?)|'?[\w.[\]]+\.\w+'?|'\w*'|([\w.]+, )+[\w.]+|hophoop.*)$/u,jt=/\{(\w+)\}/g,me="en",Cn=[],at=new Map,rt=new Set,ht=new Set,Ct=()=>me;
function Gs(o){me=o in lt?o:"en",at=new Map,rt=new Set,ht.clear(),Cn=Object.keys(Us[me]??{}).filter(e=>e.includes("{")).map(dr).sort((e,t)=>Ln(t.key)-Ln(e.key))}
function cr(){let o=ae(qn);return o&&o in lt?o:(globalThis.navigator?.languages??[]).map(s=>s.slice(0,2).toLowerCase()).find(s=>s in lt)??"en"}function On(o){re(
qn,o)}var Ln=o=>o.replace(jt,"").length;function dr(o){let e=[...o.matchAll(jt)].map(([,s])=>s),t=o.split(/\{\w+\}/).map(s=>s.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));
return{key:o,names:e,pattern:new RegExp(`^${t.join("(.+?)")}$`,"su")}}var le=o=>lr.has(me)?o.replace(/(\d)\.(\d)/g,"$1,$2"):o;function x(o,e){let t=Us[me];if(e)
return ee(Fn(t?.[o]??Nn(o),e));if(!t||!/\p{L}/u.test(o))return le(o);if(rt.has(o))return o;let s=at.get(o);if(s!==void 0)return s;let n=o.trim(),i=t[n]??ur(n,t)??
Nn(n),a=o.replace(n,()=>i);return at.size>jn&&at.clear(),at.set(o,a),ee(a)}function ee(o){return rt.size>jn&&rt.clear(),rt.add(o),o}var Dn=(o,e)=>o.replace(jt,(t,s)=>String(
e[s])),Fn=(o,e)=>o.replace(jt,(t,s)=>s.startsWith("word")?String(e[s]):x(String(e[s])));function ur(o,e){for(let{key:t,pattern:s,names:n}of Cn){let i=o.match(s);
if(i)return Fn(e[t],Object.fromEntries(n.map((a,r)=>[a,i[r+1]])))}return mr(o)}function mr(o){if(o.includes(" → "))return o.split(" → ").map(e=>x(e)).join("\
 → ")}function Wn(o){if(!Us[me])return o;let[,e,t]=o.match(/^(.*?)\.(?: (.*))?$/su)??["",o,""],{comma:s,stop:n}=me==="zh"?{comma:"，",stop:"。"}:{comma:", ",
stop:"."},a=`${e[0]?.toLowerCase()??""}${e.slice(1)}`.split(/, (?!\d)/).map(r=>x(r)).join(s);return ee(`${a[0]?.toLocaleUpperCase(me)??""}${a.slice(1)}${n}${t?`\
 ${x(t)}`:""}`)}function Nn(o){let e=/\p{L}{3,}/u.test(o)&&!hr.test(o);return me!=="en"&&e&&ht.size<200&&ht.add(o),le(o)}var $n=new WeakMap,Ks=new WeakMap;function Vs(o){
let e=document.createTextNode(x(o));return $n.set(e,o),e}function ct(o,e,t){let s=Ks.get(o)??{};s[e]=t,Ks.set(o,s),o.setAttribute(e,x(t))}function Bn(o){let e=document.
createTreeWalker(o,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let t=e.nextNode();t;t=e.nextNode()){let s=$n.get(t);s!==void 0&&(t.nodeValue=x(s));let n=Ks.
get(t);for(let[i,a]of Object.entries(n??{}))t.setAttribute(i,x(a))}}Gs(cr());var pr=new Set(["aria-label","title","placeholder","label"]);function d(o,e={},...t){let s=document.createElement(o),n=s;for(let[i,a]of Object.entries(e))a==null||
a===!1||(i.startsWith("on")?s.addEventListener(i.slice(2),a):i==="class"?s.className=a:i in s&&i!=="list"&&typeof a!="string"?n[i]=a:pr.has(i)?ct(s,i,String(a)):
s.setAttribute(i,a===!0?"":a));for(let i of t.flat())i==null||i===!1||s.append(i.nodeType?i:Vs(String(i)));return s}function M(o,e){e?o.replaceChildren(Vs(e)):o.
replaceChildren()}var Ot=o=>o!==null&&o.getRootNode().activeElement===o,pe=o=>o.getContext("2d");function D(o){let e=o.getBoundingClientRect(),t=Math.min(globalThis.
devicePixelRatio||1,2.5),s=Math.max(Math.round(e.width*t),1),n=Math.max(Math.round(e.height*t),1);(o.width!==s||o.height!==n)&&(o.width=s,o.height=n);let i=pe(o);
return i.setTransform(t,0,0,t,0,0),{context:i,width:s/t,height:n/t}}function fr(o){if(/^#[0-9a-f]{6}$/i.test(o))return o;let e=pe(d("canvas",{width:1,height:1}));
e.fillStyle=o,e.fillRect(0,0,1,1);let[t,s,n]=e.getImageData(0,0,1,1).data;return`#${[t,s,n].map(i=>i.toString(16).padStart(2,"0")).join("")}`}function Js(o){let e=getComputedStyle(
o),t=n=>e.getPropertyValue(n).trim(),s=n=>fr(t(n));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("--paper"),panel:s("--panel"),ground:s("--gro\
und"),font:t("--font"),dark:ot(s("--paper"))<.2}}function $e(o,e){let t=d("a",{href:URL.createObjectURL(o),download:e});document.body.append(t),t.click(),t.remove(),
setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function he(o,e){let t=0;return()=>{clearTimeout(t),t=setTimeout(o,e)}}var y=(o,e,t)=>Math.min(Math.max(o,e),t);function _(o,e=4){if(o==null)return"–";if(typeof o!="number")return String(o);if(!Number.isFinite(o))return Number.isNaN(
o)?"–":o>0?"∞":"−∞";if(o===0)return"0";let t=Math.abs(o),s;if(t>=1e6||t<1e-4){let[n,i]=o.toExponential(e-1).split("e");s=`${Hn(n)}·10${gr(Number(i))}`}else
s=Hn(o.toPrecision(e)),s.includes("e")&&(s=String(Math.round(o)));return le(s.replace("-","−"))}function Hn(o){return o.includes(".")&&!o.includes("e")?o.replace(
/\.?0+$/,""):o}function gr(o){let e={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(o)].map(t=>e[t]).join(
"")}var F=(o,e)=>e?e==="°"?`${o}°`:`${o} ${e}`:o,q=o=>le(`${(o*180/Math.PI).toFixed(1)}°`.replace("-","−"));function ye(o){let e=Math.abs(o),[t,s]=e>=.995?
[1,"m"]:e>=.00995?[100,"cm"]:[1e3,"mm"];return F(_(o*t,3),s)}function U(o,e){let t=o/Math.max(e,1),s=10**Math.floor(Math.log10(t)),n=t/s;return(n>5?10:n>2?5:n>1?
2:1)*s}function te(o,e,t){if(!(e>o)||!Number.isFinite(o)||!Number.isFinite(e))return[];let s=U(e-o,t),n=[];for(let i=Math.ceil(o/s-1e-9);i*s<=e+1e-9*s&&n.length<
200;i++)n.push(i*s);return n}function Y(o,e){let t=y(-Math.floor(Math.log10(e)+1e-9),0,15);return Math.max(Math.abs(o),e)>=1e6||t>12?_(o,3):le((Math.abs(o)<e*1e-6?
0:o).toFixed(t).replace("-","−"))}var Kn=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],wr="tfc",br=400;function Un({time:o=0,options:e={},zoom:t=1,map:s}){let n=[];o>
0&&n.push(`t=${Number(o.toFixed(4))}`);let i=Kn.filter(([a])=>e[a]).map(([,a])=>a);return i.join("")!==wr&&n.push(`show=${i.join("")}`),t!==1&&n.push(`zoom=${Number(
t.toPrecision(3))}`),s&&n.push(`map=${[s.what,...s.x,...s.y].join(",")}`),n.join("&")}function Gn(o){let e=new URLSearchParams(o.replace(/^#/,"")),t={},s=Number(
e.get("t")??Number.NaN);s>=0&&(t.time=s);let n=e.get("show");n!==null&&(t.options=Object.fromEntries(Kn.map(([w,b])=>[w,n.includes(b)])));let i=Number(e.get("zo\
om")??Number.NaN);i>0&&(t.zoom=y(i,.05,60));let[a,r,l,h,c,u,m]=e.get("map")?.split(",")??[],p=[l,h,u,m].map(Number);return m!==void 0&&p.every(Number.isFinite)&&
p[0]<p[1]&&p[2]<p[3]&&(t.map={what:a,x:[r,p[0],p[1]],y:[c,p[2],p[3]]}),t}var yr=()=>{let o=new URLSearchParams(location.hash.slice(1)).get("with");return[location.
search.slice(1),...o===null?[]:[o]]},Dt=class{constructor(e){this.lab=e,this.number=0,this.soon=he(()=>this.write("same"),br),this.listen=()=>this.arrived(),addEventListener(
"popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(e){let{lab:t}=this;if(!t.motions.lanes.length)return;let s=t.link();e==="step"?
history.pushState({number:++this.number},"",s):history.replaceState({number:this.number},"",s)}travel(e){return new Promise(t=>{let s=()=>t();addEventListener("\
popstate",s,{once:!0}),setTimeout(s,300),history.go(e)})}async arrived(){let e=history.state?.number??0,t=yr();JSON.stringify(t)===JSON.stringify(this.lab.motions.
queries())?this.number=e:await this.lab.motions.arrive(t)?this.number=e:e!==this.number&&history.go(this.number-e)}};var dt=[.05,.1,.25,.5,1,2,4],Ft=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let e of this.listeners)e(this)}seek(e){this.time=y(e,0,this.duration),this.changed()}play(e=!this.playing){this.playing=e,this.last=null,e&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(e){let t=dt.indexOf(this.speed);this.speed=dt[y(t+e,0,dt.length-1)],this.changed()}tick(e){if(!this.playing)return!1;
let t=this.last===null?0:Math.min(e-this.last,100)/1e3;return this.last=e,this.time+=t*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function vr(o,e=""){let t=o.trim();e&&t.endsWith(e)&&(t=t.slice(0,-e.length)),t=t.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(n,i,a)=>`e${i&&"-"}${a.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(t);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(t)?Number(t.replace(",",".")):Number.NaN}function kr(o,e,{label:t,unit:s,range:n}){let i=o.trim();if(Number.isNaN(e))return`${t} = ${i} must be a number, s\
uch as 2.5.`;if(!n||e>=n.least&&e<=n.most||n.also.includes(e))return"";let a=n.also.includes(0)?"0 or ":"",r=`from ${_(n.least,4)} to ${F(_(n.most,4),s)}`,l=n.also.
includes(1/0)?", or inf":"";return`${t} = ${F(_(e,6),s)} must be ${a}${r}${l}.`}var xr=0,Be=class{constructor(e,t){this.info=e,this.onvalue=t,this.shown="",this.
typing=!1,this.error=d("p",{class:"error",role:"alert",id:`hh-error-${++xr}`,hidden:!0}),this.input=d("input",{type:"text",inputmode:"decimal",autocomplete:"off",
spellcheck:"false",class:"exact","aria-label":e.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:s=>{
s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute("aria-invalid")==="true"}typed(){
let e=this.input.value;if(!this.typing)return;if(this.typing=!1,e.trim()===""){this.restore();return}let t=vr(e,this.info.unit),s=kr(e,t,this.info);s?this.refuse(
s):this.onvalue(t)}refuse(e){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.id),M(this.error,e),this.error.
hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){this.typing=!1,this.
input.value=this.shown,this.accept()}show(e){this.shown=le(e),this.typing||this.restore()}};var Vn={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},_r={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},Tr=(o,e,t)=>({ring:{shape:o,mass:t,inner_radius:.95*e,outer_radius:e},disk:{shape:o,mass:t,radius:.1*
e,at:.8*e},point_mass:{shape:o,mass:t,at:e},rod:{shape:o,mass:t,length:.5*e,at:.5*e}})[o];function Jn(o){let e=o["hoop.radius"],t=o["hoop.mass"],s=Math.min(Math.
max(o["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:Wt(t*(1-s)),inner_radius:Wt(.98*e),outer_radius:e},{shape:"point_mass",mass:Wt(t*s),at:e}]}var Wt=o=>Number(
o.toPrecision(6)),$t=class{parts;text;radius;mass;constructor(e){this.onchange=e,this.list=d("div",{class:"parts"}),this.element=d("div",{},this.list,d("select",
{"aria-label":"Add a part",onchange:t=>{let s=t.target.value;t.target.value="",s&&this.send([...this.parts,Tr(s,this.radius,Wt(.2*this.mass))])}},d("option",{value:""},
"+ add a part …"),Object.entries(Vn).map(([t,{label:s}])=>d("option",{value:t},s))))}send(e){this.onchange([["hoop.parts",e]])}show(e,t,s){let n=JSON.stringify(
e);if(n===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=e;return}Object.assign(this,{text:n,parts:e,radius:t,mass:s}),this.list.
replaceChildren(...e.map((i,a)=>this.row(i,a)))}row(e,t){let{label:s,keys:n}=Vn[e.shape];return d("fieldset",{class:"part"},d("legend",{},s,this.parts.length>1&&
d("button",{type:"button",class:"quiet","aria-label":`Remove part ${t+1}, ${s}`,onclick:()=>this.send(this.parts.filter((i,a)=>a!==t))},"×")),n.map(i=>this.field(
e,t,i)))}field(e,t,s){let[n,i]=_r[s],a=new Be({label:n,unit:i},r=>this.send(this.parts.map((l,h)=>h===t?{...l,[s]:r}:l)));return a.show(String(e[s]??0)),d("div",
{},d("label",{},`${n} [${i}]`,a.input),a.error)}};var Ys=Math.PI/180;function Sr({allowed:o,degrees:e}){if(!o)return;let t=e?1/Ys:1;return{least:o.least*t,most:o.most*t,also:o.also.map(s=>s==="inf"?1/0:Number(s))}}
var Zs=class{constructor(e,t){this.info=e,this.onchange=t,this.held=!1;let s=`hh-${e.path}-${Math.random().toString(36).slice(2,7)}`,n=l=>()=>{this.held=l};this.
range=d("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:e.logarithmic?"0.01":String(e.step),"data-path":e.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:n(!0),onpointerup:n(!1),onpointercancel:n(!1),onblur:n(!1)});let{label:i,unit:a}=e,r=`${i}, exact value${a?` i\
n ${a}`:""}`;this.entry=new Be({label:i,unit:a,name:r,range:Sr(e)},l=>this.send(l,!0)),this.element=d("div",{class:"control",title:e.help},d("label",{for:s},d("\
span",{},i),d("span",{class:"symbol"},e.symbol)),this.range,d("span",{class:"entry"},this.entry.input,d("span",{class:"unit"},a)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(e){let t=Number(
this.range.value),s=this.info.logarithmic?Number((10**t).toPrecision(3)):t;this.entry.typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,e)}send(e,t){
let s=this.info.degrees?e*Ys:e;this.onchange([[this.info.path,Number.isFinite(s)?s:"inf"]],t)}say(e){this.range.setAttribute("aria-valuetext",F(_(e,4),this.info.
unit))}show(e,t=null){if(this.held)return;let s=e!=null,n=s?e:t;if(n==null){this.entry.show("");return}let i=n==="inf"?1/0:Number(n)/(this.info.degrees?Ys:1);this.
entry.show(s?Number.isFinite(i)?String(Number(i.toPrecision(9))):"∞":""),this.entry.input.placeholder=s?"":x("auto {value}",{value:_(i,2)}),this.entry.input.title=
s?F(String(i),this.info.unit):"";let a=y(this.info.logarithmic?Math.log10(i):i,this.low(),this.high());Math.abs(Number(this.range.value)-a)>1e-6&&(this.range.value=
String(a)),this.say(i)}};function Mr(o,e){let t=d("select",{"data-path":o.path,onchange:()=>e([[o.path,t.value]],!0)},o.options.map(([n,i])=>d("option",{value:n},
i)));return{element:d("label",{class:"choice",title:o.help},d("span",{},o.label),t),select:t,path:o.path}}var Bt=class{way;kind;gravity;apart;derived;film;constructor(e,t){
this.onchange=(s,n=!0)=>t(s,n),this.sliders=new Map;for(let s of Object.values(e.groups))for(let n of s)this.sliders.set(n.path,new Zs(n,this.onchange));this.choices=
new Map(e.choices.map(s=>[s.path,Mr(s,this.onchange)])),this.parts=new $t(this.onchange),this.gravities=e.gravities,this.element=d("div",{class:"controls"},this.
hoop(),this.plane(),this.start(),this.contact())}at(e){let t=this.sliders.get(e)??this.choices.get(e);if(!t)throw new Error(`There is no control of ${e}.`);return t.
element}select(e,t,s){let n=d("select",{onchange:()=>s(n.value)},t.map(([i,a])=>d("option",{value:i},a)));return{select:n,element:d("label",{class:"choice"},d("\
span",{},e),n)}}group(e,...t){let s=e==="Start"||e==="Plane"||!matchMedia("(max-width: 760px)").matches;return d("details",{class:"group",open:s},d("summary",{},
e),t)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],e=>{let{values:t}=this.
film;e==="parts"?this.onchange([["hoop.parts",Jn(t)]]):this.onchange([[`hoop.${e}`,t["hoop.eccentricity"]]])}),this.derived=d("p",{class:"derived"}),this.group(
"Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.eccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.r\
adius"),this.at("hoop.mass"))}plane(){return this.apart=d("input",{type:"checkbox",onchange:()=>{let{values:e}=this.film;this.apart.checked?this.onchange([["pla\
ne.mu_static",e["plane.mu_static"]],["plane.mu_kinetic",e["plane.mu_kinetic"]]]):this.onchange([["plane.mu",e["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([e])=>[e,e]),["","elsewhere"]],e=>{let t=this.gravities.find(([s])=>s===e);t&&this.onchange([["plane.gravity",t[1]]])}),this.group(
"Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_kinetic"),d("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.
at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("plane.restitution"),this.at("plane.rolling_resistance"),this.at("plane.impact_law"),this.
at("plane.painleve"))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],e=>{let{values:t}=this.film;e==="rolling"?this.
onchange([["start.speed",t["start.vx"]]]):this.onchange([["start.omega",t["start.omega"]]])}),this.group("Start",this.kind.element,this.at("start.speed"),this.at(
"start.angle"),this.at("start.height"),this.at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.at("duration"))}contact(){return this.group("Contact",
this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitut\
ion"))}refuse(e,t){let s=e.length===1?this.sliders.get(e[0][0]):void 0;return s?.element.checkVisibility()?(s.entry.refuse(t),!0):!1}restore(){this.film&&this.showChoices(
this.film,new Set)}show(e,t=new Set){this.film=e,this.showChoices(e,t);let s=e.scenario;for(let[n,i]of this.sliders){if(t.has(n))continue;let[a,r]=n.split(".");
i.show(e.values[n]??(r?s[a]?.[r]:s[a]),e.automatic?.[n])}}showChoices(e,t){let{scenario:s,values:n}=e,i=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_frac\
tion":"eccentricity",a="speed"in s.start,r="mu_static"in s.plane,l=s.contact.model==="compliant",h=(...p)=>p.some(w=>t.has(w));h("hoop.load_fraction","hoop.ecce\
ntricity","hoop.parts")||(this.way.select.value=i),h("start.speed","start.omega")||(this.kind.select.value=a?"rolling":"free"),h("plane.mu","plane.mu_static")||
(this.apart.checked=r);let c=this.gravities.find(([,p])=>Math.abs(p-s.plane.gravity)<1e-9);h("plane.gravity")||(this.gravity.select.value=c?c[0]:"");let u={"hoo\
p.load_fraction":i==="load_fraction","hoop.eccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!=="parts","plane.mu":!r,"plane\
.mu_static":r,"plane.mu_kinetic":r,"plane.restitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":a,"start.height":!a,"start.vx":!a,"start.vy":!a,
"start.omega":!a,"contact.law":l,"contact.friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[p,w]of Object.entries(u))this.
at(p).hidden=!w;this.parts.element.hidden=i!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,n["hoop.radius"],n["hoop.mass"]),this.derived.textContent=i==="\
eccentricity"?"":`ε = ${_(n["hoop.eccentricity"],5)}, κ = ${_(n["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${_(n["hoop.mass"],5)} kg`:"");let m=s;for(let[
p,{select:w}]of this.choices){if(t.has(p))continue;let[b,g]=p.split(".");m[b]?.[g]!==void 0&&(w.value=m[b][g])}}};var Xs=Math.PI/180;function Yn(o,e){let{start:t,plane:s,contact:n,hoop:i}=o.scenario;return n.model!=="rigid"?"Rigid contact only.":o.slope!==0?"The plane must \
be level.":Math.abs(o.gravity-9.81)>1e-9?"It must be on Earth.":(s.restitution??0)!==0?"Restitution must be 0.":o.radius!==1||i.parts?"The radius must stay 1 m,\
 without parts.":o.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in i?"speed"in t?Math.abs(t.speed??3.1)>e+1e-9?e>5?"At most 10 \
m/s.":"At most 3.1 m/s.":o.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var Zn=o=>o.events.filter(
({kind:e})=>e==="takeoff");function Er(o){return o.events.filter(({kind:e})=>e==="apex").map(({height:e})=>e)}var Xn=(o,e)=>Math.min(Math.round(100*o/e),100),Ar=1.596,
zr=.37,Rr=.05,Qs=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:o=>{let e=Yn(o,3.1);if(e)return{points:0,text:e};let t=Math.max(
0,...Er(o));return t?{points:Xn(t,Ar),text:"It rises by {height}.",values:{height:ye(t)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land uprigh\
t",text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=\
0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:o=>{let e=Zn(o)[0],t=o.events.find(({kind:a,t:r})=>a==="impact"&&e&&r>e.t);if(!e||!t)return{
points:0,text:"It does not hop."};let s=o.events.find(({kind:a,t:r})=>a==="apex"&&r>e.t);if(!s||s.height<Rr)return{points:0,text:"The first hop is too low."};let n=Math.
abs(t.angle-2*Math.PI*Math.round(t.angle/(2*Math.PI)))/Xs,i=Math.max(0,Math.round(100*(1-(n-.5)/89.5)));return{points:Math.min(i,100),text:"It lands {off} away \
from the top.",values:{off:q(n*Xs)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:o=>{let e=Yn(o,10);if(e)return{points:0,text:e};if(Math.
abs(Math.abs(o.scenario.start.angle??0)-Math.PI)>.5*Xs)return{points:0,text:"The load must start at the bottom."};if(o.values["plane.mu_kinetic"]>1.5||o.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let t=Zn(o)[0];if(!t)return{points:0,text:"It does not hop."};let s=o.phases.filter(
({from:i})=>i<t.t);if(s.some(({mode:i})=>i==="K"))return{points:0,text:"It skids before it hops."};if(s[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let n=o.events.find(({kind:i,t:a})=>i==="apex"&&a>t.t);return n?{points:Xn(n.height,zr),text:"It rises by {height}.",values:{height:ye(n.height)}}:{points:0,
text:"It does not hop."}}}],eo=o=>o>=95?3:o>=75?2:o>=40?1:0;var Qn="hophoop-best-",Pr=o=>"★".repeat(eo(o))+"☆".repeat(3-eo(o)),Ht=class{goal=null;constructor(e){this.lab=e,this.tabs=new Map(Qs.map(t=>[t.key,d("button",
{type:"button","aria-pressed":"false",onclick:()=>this.choose(t)},t.title)])),this.text=d("p",{}),this.meter=d("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"\
100","aria-label":"Score"}),this.result=d("p",{class:"challenge-result",role:"status"}),this.kept=d("p",{class:"hint"}),this.element=d("section",{class:"challen\
ges card","aria-label":"Challenges",hidden:!0},d("header",{},d("h2",{},"Challenges"),d("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",
onclick:()=>this.close()},"×")),d("div",{class:"tabs",role:"group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.
kept,d("div",{class:"buttons"},d("button",{type:"button",onclick:()=>this.goal&&this.load(this.goal.start)},"Begin again"),d("button",{type:"button",onclick:()=>this.
goal&&this.load(this.goal.best)},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??Qs[0]),this.element.scrollIntoView({block:"nearest"}),
this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(e){this.goal=e;for(let[t,s]of this.tabs)s.setAttribute(
"aria-pressed",String(t===e.key));M(this.text,e.text),this.changed()}async load(e){let{lab:t}=this;try{let s=await t.backend.call("film",{query:e});t.clock.play(
!1),t.clock.time=0,t.motions.replace(s)}catch(s){t.notice.fail(s)}}changed(){let{goal:e,lab:t}=this;if(!e)return;let{points:s,text:n,values:i={}}=e.score(t.film());
this.meter.value=s;let a=x("{stars} {points} points. {what}",{stars:Pr(s),points:s,what:x(n,i)});this.result.textContent!==a&&(this.result.textContent=a);let r=Number(
ae(Qn+e.key)??0);s>r&&!t.stage.options.ahead&&re(Qn+e.key,String(s)),M(this.kept,x("Your best: {points} points.",{points:Math.max(r,t.stage.options.ahead?0:s)}))}};var ei=.09,Ir=.03,to=Math.PI/180,Kt=Math.PI/4,ti=2*Math.PI,ut=o=>o-ti*Math.round(o/ti);function Ut(o,e){let t=o.at(e),s=e===0;return{angle:ut(t.angle),height:Math.
max(t.height,0),vx:s?t.vx:0,vy:s?t.vy:0,omega:s?t.omega:0,slope:o.slope}}var si=o=>2*Math.sqrt(Math.max(o.gravity,1)*o.radius),ve=o=>Number(o.toFixed(4))+0;function oi(o,e,t){
if(o==="plane")return[["plane.slope",ve(e.slope)]];if(e.height>0)return[["start.angle",ve(e.angle)],["start.height",ve(e.height)],["start.vx",ve(e.vx)],["start.\
vy",ve(e.vy)],["start.omega",ve(e.omega)]];let s=o==="load"?e.omega*t.radius:e.vx;return[["start.angle",ve(e.angle)],["start.speed",ve(s)]]}var mt=class{constructor(e,t,s,n,i){
this.grip=e,this.film=t,this.view=n,this.before=Ut(t,s),this.held={...this.before,vx:0,vy:0,omega:0};let a=t.at(s);this.center=[a.x,t.radius+a.height],this.foot=
n.point(a.x,0),this.from=this.read(i),this.turned=0,this.trail=[],this.moved=0}read(e){let[t,s]=this.view.unpoint(e.clientX,e.clientY),n=this.grip==="plane"?Math.
atan2(e.clientY-this.foot[1],e.clientX-this.foot[0]):Math.atan2(t-this.center[0],s-this.center[1]);return{x:e.clientX,y:e.clientY,along:t,away:s,turn:n}}move(e,t){
let s=this.read(e),{radius:n}=this.film;if(this.turned+=ut(s.turn-this.from.turn-this.turned),this.grip==="plane"){let i=y(this.before.slope+this.turned,-Kt,Kt);
this.held.slope=Math.abs(i)<to?0:i}else if(this.grip==="load")this.held.angle=ut(this.before.angle+this.turned);else{let i=this.before.height+s.away-this.from.away;
this.held.height=i<Ir*n?0:i;let a=s.along-this.from.along;this.held.angle=ut(this.before.angle+(this.held.height>0?0:a/n)),this.moved=s.x-this.from.x}for(this.trail.
push({t:t/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<t/1e3-ei;)this.trail.shift();return this.held}release(e){let{held:t,
trail:s,film:n}=this,i=s.at(-1),a=s[0],r=i&&a?i.t-a.t:0,l=!i||r<.012||e/1e3-i.t>ei,h=si(n);return l||this.grip==="plane"||(this.grip==="load"?t.omega=y((i.turned-
a.turned)/r,-h/n.radius,h/n.radius):(t.vx=y((i.along-a.along)/r,-h,h),t.vy=t.height>0?y((i.away-a.away)/r,-h,h):0)),t}};function ni(o,e,t,s,n){let i={ArrowLeft:-1,
ArrowRight:1}[e]??0,a={ArrowDown:-1,ArrowUp:1}[e]??0;if(!i&&!a)return null;let r=t?.2:1;if(o==="load"){let u=ut(s.angle+(i||a)*5*to*r);return{...s,angle:u}}if(o===
"plane"){let u=y(s.slope+(i||-a)*to*r,-Kt,Kt);return{...s,slope:Math.abs(u)<1e-9?0:u}}let l=si(n),h=y(s.height+a*.05*r*n.radius,0,4*n.radius),c=y(s.vx+i*.1*r,-l,
l);return{...s,height:h<1e-9?0:h,vx:c}}function W(o,e,t,s=()=>{}){let n=new AbortController,{signal:i}=n,a=(l,h)=>o.addEventListener(l,c=>c.pointerId===e.pointerId&&h(c),{signal:i}),r=l=>h=>{n.abort(),
s(h,l)};o.setPointerCapture(e.pointerId),a("pointermove",t),a("pointerup",r(!0)),a("pointercancel",r(!1))}function ii(o,e){let t=new Map,s=null,n=()=>{let[a,r]=[
...t.values()];return{span:Math.max(Math.hypot(a.clientX-r.clientX,a.clientY-r.clientY),1),clientX:.5*(a.clientX+r.clientX),clientY:.5*(a.clientY+r.clientY)}};o.
addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(t.set(a.pointerId,a),s=t.size===2?n():null)}),o.addEventListener("pointermove",a=>{if(!t.has(a.pointerId)||
(t.set(a.pointerId,a),t.size!==2||!s))return;let r=n();e(r.span/s.span,r),s=r});for(let a of["pointerup","pointercancel"])o.addEventListener(a,r=>{t.delete(r.pointerId),
s=null});let i=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();return o.addEventListener("touchmove",i,{passive:!1}),()=>t.size>1}var Lr=700,so=44,Nr=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],Gt=class{static Pull=mt;pull=null;held=null;before=null;constructor(e){this.
lab=e,this.places=new Map(Nr.map(([i,a,r])=>[i,this.place(i,a,r)])),this.tip=d("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=d("div",
{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.values()],this.tip),e.stage.element.before(this.element);let{flat:t,plane:s}=e.
stage;t.grab=i=>this.take(i),s.addEventListener("pointermove",i=>this.hover(i)),s.addEventListener("pointerleave",()=>this.hover(null));let n=i=>this.pull&&i.cancelable&&
i.preventDefault();s.addEventListener("touchmove",n,{passive:!1}),this.settle=he(()=>this.chosen(!1),Lr)}place(e,t,s){return d("div",{class:`grip grip-${e}`,role:"\
slider",tabindex:"0","aria-label":t,"aria-valuenow":"0",title:s,onkeydown:n=>this.key(e,n),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.
flat.views[this.lab.motions.active]}draw(){let{lab:e}=this,t=this.view(),s=!!t&&!e.stage.options.three;if(this.element.hidden=!s,!s)return;this.element.classList.
toggle("running",e.clock.playing);let{pose:n,film:i,scale:a}=t,r=i.radius,l=t.point(n.x,r+n.height),h=t.point(n.x+r*Math.sin(n.angle),r+n.height+r*Math.cos(n.angle)),
c=this.onPlane(t),u=y(1.1*r*a,so,190),m=[["plane",c,so],["hoop",l,u],["load",h,so]];for(let[p,[w,b],g]of m){let f=this.places.get(p);f.style.transform=`translat\
e(${w-g/2}px, ${t.top+b-g/2}px)`,f.style.width=f.style.height=`${g}px`,f.hidden=w<0||b<0||w>t.width||b>t.height}e.clock.playing||this.tell(i)}onPlane(e){let t=e.
point(e.pose.x,0),n=(Math.min(t[0]+Math.max(1.9*e.film.radius*e.scale,90),e.width-30)-t[0])/(e.scale*Math.max(e.cosine,.2));return e.point(e.pose.x+n,0)}tell(e){
let t=this.pull?.held??this.held??Ut(e,this.lab.clock.time),s={load:q(t.angle),hoop:x("gap {height}, speed {speed} m/s",{height:ye(t.height),speed:_(t.vx,3)}),plane:q(
t.slope)},n={load:t.angle*(180/Math.PI),hoop:t.height,plane:t.slope*(180/Math.PI)},i={load:[-180,180],hoop:[0,4*e.radius],plane:[-45,45]};for(let[a,r]of this.places)
r.getAttribute("aria-valuetext")!==s[a]&&(r.setAttribute("aria-valuetext",s[a]),r.setAttribute("aria-valuenow",String(Number(n[a].toPrecision(4)))),r.setAttribute(
"aria-valuemin",String(i[a][0])),r.setAttribute("aria-valuemax",String(Number(i[a][1].toPrecision(4)))))}under(e){if(this.element.hidden)return null;let t=null;
for(let[s,n]of this.places){let{left:i,top:a,width:r}=n.getBoundingClientRect(),l=Math.hypot(e.clientX-i-r/2,e.clientY-a-r/2);!n.hidden&&l<=r/2&&(t=s)}return t}hover(e){
if(this.pull)return;let t=e&&e.pointerType!=="touch"?this.under(e):null;for(let[s,n]of this.places)n.classList.toggle("near",s===t);this.lab.stage.plane.style.cursor=
t?"grab":""}take(e){let t=this.under(e);if(!t||e.button>0||this.pull)return!1;let{lab:s}=this,{flat:n,plane:i}=s.stage,a=this.places.get(t),r=this.view(),l=i.getBoundingClientRect(),
h=f=>({clientX:f.clientX-l.left,clientY:f.clientY-l.top-r.top}),c=new mt(t,s.film(),s.clock.time,r,h(e)),u=[...n.shift],[m,p]=[!1,!1];this.pull=c,a.classList.add(
"held");let w=()=>{p=!0,b.abort(),a.classList.remove("held"),n.fixed=null,this.pull=null,m&&this.comeBack(u)},b=new AbortController,g=f=>{f.key==="Escape"&&(f.stopPropagation(),
w(),m&&this.back())};return addEventListener("keydown",g,{capture:!0,signal:b.signal}),W(i,e,f=>{if(!p){if(n.pinched()){w(),m&&this.back();return}!m&&Math.hypot(
f.clientX-e.clientX,f.clientY-e.clientY)<3||(m||(n.fixed=r.scale,this.hold(),this.begin()),m=!0,c.move(h(f),f.timeStamp),n.shift=[u[0]+c.moved,u[1]],this.change(
t,c.held,!1),this.show(t,c.held))}},(f,k)=>{p||(w(),m&&(k?(this.change(t,c.release(f.timeStamp),!0),this.end(!0)):this.back()))}),!0}key(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return;let{lab:s}=this;if(t.key==="Escape"&&this.held)this.back();else if(t.key==="Enter")this.chosen(!0);else{this.held??=Ut(s.film(),s.clock.time);let n=ni(
e,t.key,t.shiftKey,this.held,s.film());if(!n)return;this.before===null&&(this.hold(),this.begin()),this.held=n,this.change(e==="load"?"hoop":e,n,!1),this.show(e,
n),this.settle()}t.preventDefault(),t.stopPropagation()}hold(){this.lab.clock.play(!1),this.before=this.lab.film().query}begin(){let{lab:e}=this;e.stage.options.
ahead=!0,e.clock.seek(0),e.root.classList.add("holding")}change(e,t,s){this.lab.motions.change(oi(e,t,this.lab.film()),s)}show(e,t){let s={load:`θ = ${q(t.angle)}`,
hoop:t.height>0?`y = ${ye(t.height)}`:`θ = ${q(t.angle)}`,plane:`β = ${q(t.slope)}`};M(this.tip,t.vx&&this.held?`${s[e]}, v = ${_(t.vx,3)} m/s`:s[e]),this.tip.
hidden=!1}chosen(e){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(e)}end(e){let{lab:t}=this;this.held=null,this.before=null,this.tip.hidden=
!0,t.stage.options.ahead=!1,t.root.classList.remove("holding"),e&&t.clock.seek(0),e&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&t.clock.play(!0),t.
request()}async back(){let{lab:e,before:t}=this;if(this.end(!1),t===null)return;let s=e.motions.lanes[e.motions.active];for(s.pending=null;s.busy;)await new Promise(
n=>requestAnimationFrame(n));try{e.motions.replace(await e.backend.call("film",{query:t}))}catch(n){e.notice.fail(n)}}comeBack(e){let{flat:t}=this.lab.stage,s=matchMedia(
"(prefers-reduced-motion: reduce)").matches,n=()=>{if(this.pull)return;let i=t.shift[0]-e[0];t.shift=Math.abs(i)<1||s?[...e]:[e[0]+.82*i,e[1]],this.lab.request(),
t.shift[0]!==e[0]&&requestAnimationFrame(n)};n()}};var qr={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function $(o){let e="\
http://www.w3.org/2000/svg",t=document.createElementNS(e,"svg");t.setAttribute("viewBox","0 0 17 17"),t.setAttribute("aria-hidden","true"),t.setAttribute("class",
"icon");let s=document.createElementNS(e,"path");return s.setAttribute("d",qr[o]),t.append(s),t}var Vt=class{constructor(e){this.lab=e,this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener("fullscreenchange",this.left),
this.full=!1,this.on=!1,this.onchange=()=>{}}async turn(e=!this.on){let{root:t}=this.lab;if(this.on=e,t.classList.toggle("presenting",e),this.onchange(),this.lab.
show(),!e){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await t.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var ai=.22,ri=.03;function li(o,e){let t=o.at(e),s=o.mass*(o.gravity||9.81),n=t.mode==="H"||!(t.normal_force>0)?0:t.normal_force/s,i=n/(1+n),a=t.mode==="S"||t.mode===
"K",r=Math.abs(t.slip)/Math.sqrt((o.gravity||9.81)*o.radius);return{tone:i,pitch:55*(1+Math.min(n,8))**.5,hiss:a?i*y(.15+r,0,1):0}}function hi(o,e,t){let s=Math.
sqrt(2*(o.gravity||9.81)*o.radius);return o.events.filter(({kind:n,t:i,before:a})=>n==="impact"&&a&&i>e&&i<=t).map(({before:n})=>y(Math.abs(n.vy)/s,.02,1))}function jr(o){
let e=o.createBuffer(1,o.sampleRate,o.sampleRate),t=e.getChannelData(0),s=1;for(let n=0;n<t.length;n++)s=s*16807%2147483647,t[n]=2*s/2147483647-1;return e}var Jt=class{static heard=li;static knocks=hi;context=null;on=!1;last=0;start(){
let e=new AudioContext,t=e.createOscillator();t.type="triangle";let s=e.createBufferSource();s.buffer=jr(e),s.loop=!0;let n=e.createBiquadFilter();n.type="bandp\
ass",n.frequency.value=1800,n.Q.value=.6;let[i,a]=[e.createGain(),e.createGain()];i.gain.value=a.gain.value=0,t.connect(i).connect(e.destination),s.connect(n).connect(
a).connect(e.destination),t.start(),s.start(),this.context=e,Object.assign(this,{tone:t,low:i,high:a})}turn(e){this.on=e,e&&!this.context&&this.start(),e?this.context?.
resume():this.context&&(this.set("low",0),this.set("high",0))}set(e,t){let{gain:s}=this[e];s.setTargetAtTime(ai*t,this.context.currentTime,ri)}follow(e,t){if(!this.
on||!this.context)return;if(!t.playing){this.set("low",0),this.set("high",0),this.last=t.time;return}let{tone:s,pitch:n,hiss:i}=li(e,t.time);if(this.set("low",s),
this.set("high",.6*i),this.tone.frequency.setTargetAtTime(n,this.context.currentTime,ri),t.time>this.last)for(let a of hi(e,this.last,t.time))this.knock(a);this.
last=t.time}knock(e){let t=this.context,s=t.currentTime,n=t.createGain();n.gain.setValueAtTime(2.2*ai*Math.sqrt(e),s),n.gain.exponentialRampToValueAtTime(1e-4,s+
.18);let i=t.createOscillator();i.frequency.setValueAtTime(190,s),i.frequency.exponentialRampToValueAtTime(60,s+.15),i.connect(n).connect(t.destination),i.start(
s),i.stop(s+.2)}close(){this.context?.close()}};var oo=Math.PI/180,G=o=>e=>e.columns[o],pt=(o,e)=>t=>t.derived(o,s=>Float64Array.from(t.t,(n,i)=>e(s,i,t))),B={time:{name:"time",symbol:"t",unit:"s",values:o=>o.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:pt("degrees",({angle:o},e)=>o[e]/oo)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:pt(
"within",({angle:o},e)=>{let t=s=>Math.floor(o[s]/oo/360);return e>0&&t(e)!==t(e-1)?Number.NaN:o[e]/oo-360*t(e)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:G("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:G("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:pt(
"rise",({height:o,angle:e},t,s)=>s.radius*(1+s.eccentricity*Math.cos(e[t]))+o[t])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:G("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:pt("spin",({omega:o},e,t)=>o[e]*t.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:G(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:G("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:G("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:G("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:G("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:G("utilization")},kinetic:{name:"kinetic energy",symbol:"E_k",unit:"J",values:G("kinetic")},potential:{name:"\
potential energy",symbol:"E_p",unit:"J",values:G("potential")},total:{name:"total energy",symbol:"E",unit:"J",values:pt("total",({kinetic:o,potential:e},t)=>o[t]+
e[t])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:G("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:G("normal_loss")},rolling_resistance:{name:"lost to rolling resistance",symbol:"W_r",unit:"J",values:G("rolling_resistance")}},ci=({name:o,symbol:e})=>[
o," ",e];var Cr=["time","angle","x","vx","spin","normal_force","friction_force"],Or=[1,.5,.2,.1,.05,.02,.01],no=601;function di(o,e,t){let s=Math.min(Math.floor(o.duration/
t+1e-9)+1,no),n=[];for(let i=0;i<s;i++){let a=Number((i*t).toPrecision(12));n.push({time:a,mode:o.at(a).mode,values:e.map(r=>Dr(o,r,a))})}return n}function Dr(o,e,t){
if(e==="time")return t;let s=o.at(t);if(e in s&&e!=="angle")return s[e];let n=s.angle*180/Math.PI;if(e==="angle")return n;if(e==="turns")return n-360*Math.floor(
n/360);let i=B[e].values(o),a=o.index(t),r=Math.min(a+1,o.length-1),l=o.t[r]>o.t[a]?(t-o.t[a])/(o.t[r]-o.t[a]):0;return i[a]+l*(i[r]-i[a])}var Yt=class{film;rows=[];now;constructor(e){
this.lab=e,this.columns=[...Cr],this.step=d("select",{onchange:()=>this.fill()},Or.map(t=>d("option",{value:String(t)},`${t} s`))),this.step.value="0.1",this.picks=
d("div",{class:"table-picks"},Object.entries(B).filter(([t])=>t!=="time").map(([t,{name:s}])=>this.pick(t,s))),this.caption=d("caption",{}),this.head=d("thead",
{}),this.body=d("tbody",{}),this.element=d("section",{class:"table","aria-label":"Table of the motion",hidden:!0},d("header",{},d("h2",{},"Table"),d("label",{class:"\
table-step"},d("span",{},"Every"),this.step),d("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),d("button",{type:"button",onclick:()=>this.open(!1)},
"Close")),d("details",{class:"table-columns"},d("summary",{},"Columns"),this.picks),d("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table\
 of the motion, rows"},d("table",{},this.caption,this.head,this.body)))}pick(e,t){let s=d("input",{type:"checkbox",checked:this.columns.includes(e),onchange:()=>{
let n=new Set(this.columns);s.checked?n.add(e):n.delete(e),this.columns=Object.keys(B).filter(i=>n.has(i)),this.fill()}});return d("label",{},s,d("span",{},t))}open(e){
this.element.hidden=!e,e&&(this.draw(this.lab.film()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(e){this.
element.hidden||(this.film=e,this.fill())}fill(){let{film:e,columns:t}=this,s=Number(this.step.value),n=this.lab.theme.colors.mode_names,i=t.map(h=>B[h]);this.head.
replaceChildren(d("tr",{},i.map(({name:h,symbol:c,unit:u})=>d("th",{scope:"col",title:h},c,u&&d("small",{},` ${u}`))),d("th",{scope:"col"},"mode")));let a=di(e,
t,s);this.rows=a.map(({time:h,mode:c,values:u})=>({time:h,row:d("tr",{onclick:()=>this.lab.clock.seek(h)},u.map((m,p)=>p===0?d("th",{scope:"row"},_(m,4)):d("td",
{},_(m,4))),d("td",{class:"table-mode"},n[c]))})),this.body.replaceChildren(...this.rows.map(({row:h})=>h));let r=e.duration/s+1<=no+1e-6,l=x("The first {count}\
 rows.",{count:no});M(this.caption,r?e.summary:ee(`${e.summary} ${l}`)),this.cursor(this.lab.clock.time)}cursor(e){if(this.element.hidden||!this.rows.length)return;
let t=Number(this.step.value),s=this.rows[Math.min(Math.round(e/t),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.add("\
now"),this.now=s)}save(){let{film:e,columns:t}=this,s=[...t.map(i=>`${B[i].name} [${B[i].unit||"1"}]`),"mode"],n=di(e,t,Number(this.step.value)).map(({mode:i,values:a})=>[
...a,i].join(","));$e(new Blob([[s.join(","),...n,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var ui="hoop.radius=0.4&duration=1.5&start.speed=",Fr=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${ui}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],Wr=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],$r=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],Br=["1.0","1.3","1.6","1.9","2.2","2.3"],Hr=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function mi(o,e){
let t=c=>{h.close(),o(c)},s=(c,u="Show")=>d("button",{type:"button",class:"link",onclick:()=>t(c)},u),n=Hr(),i=n&&[["teach/index.html","Teaching with the hoop"],
["teach/worksheet.html","Worksheet"],["teach/solutions.html","Solutions"],["teach/exercises.html","Exercises"]],a=d("table",{},d("caption",{},"A lesson of 45 mi\
nutes"),d("thead",{},d("tr",{},["Minute","What happens","Motion"].map(c=>d("th",{scope:"col"},c)))),d("tbody",{},Fr.map(([c,u,m])=>d("tr",{},d("th",{scope:"row"},
c),d("td",{},u),d("td",{},m===null?"":s(m)))))),r=d("table",{},d("caption",{},"What students often think"),d("thead",{},d("tr",{},["Idea","What is right"].map(c=>d(
"th",{scope:"col"},c)))),d("tbody",{},Wr.map(([c,u])=>d("tr",{},d("td",{},c),d("td",{},u))))),l=d("section",{class:"sheet"},d("h3",{},"Worksheet: the hoop that \
hops"),d("p",{},"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at th\
e top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s²."),d("ol",{},$r.map(c=>d("li",{},c,d("div",{class:"answer-line"})))),d("table",{class:"sheet-\
table"},d("thead",{},d("tr",{},["v₀ [m/s]","phases","does it hop?","at which angle?"].map(c=>d("th",{scope:"col"},c)))),d("tbody",{},Br.map(c=>d("tr",{},d("th",
{scope:"row"},s(`${ui}${Number(c)}`,c)),d("td",{}),d("td",{}),d("td",{})))))),h=d("dialog",{class:"teach","aria-label":"For teachers"},d("header",{},d("h2",{},"\
For teachers"),d("button",{type:"button",onclick:()=>print()},"Print"),d("button",{type:"button",class:"close",onclick:()=>h.close()},"Close")),d("p",{},"The vi\
sit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",d("button",{type:"button",class:"link",onclick:()=>{h.close(),
e()}},"Start the visit")),i&&d("p",{},i.map(([c,u])=>d("a",{class:"teach-page",href:new URL(c,new URL(n,document.baseURI)).href},u))),a,r,l);return h}var io="RSKHM",Kr=new Set(["x","angle","height"]),Ur=1/60,pi=8,Gr={x:"vx",angle:"omega",height:"vy"},ke=class{constructor(e){let{header:t}=e;this.scenario=t.scenario,
this.query=t.query,this.duration=t.duration,this.status=t.status,this.sequence=t.sequence,this.events=t.events,this.values=t.values,this.automatic=t.automatic,this.
said=t.summary,this.story=t.story,this.shortened=t.shortened,this.columns=e.arrays,this.t=e.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.rad\
ius"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.
gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map,this.part=null}wanted(e,t=0){if(this.duration<Ur*this.length)return null;
let s=y(e,0,this.duration),n=Math.min(s+t,this.duration);if(this.part&&s>=this.part.t[0]&&n<=this.part.t[this.part.length-1])return null;let i=Math.max(s-.25*pi,
0);return[i,Math.min(i+pi+t,this.duration)]}refine(e){this.part=Object.assign(Object.create(this),{columns:e,t:e.t,length:e.t.length,cache:new Map,part:null})}holding(e){
let{part:t}=this;return t&&e>=t.t[0]&&e<=t.t[t.length-1]?t:this}get summary(){return Wn(this.said)}findPhases(){let{mode:e}=this.columns,t=[];for(let s=0;s<this.
length;s++){let n=t.at(-1);n&&n.mode===io[e[s]]?n.to=this.t[s]:t.push({mode:io[e[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<t.length;s++)t[s].to=t[s+1].from;
return t.filter(s=>s.to>s.from||t.length===1)}findExtent(){let{x:e,height:t,vx:s,vy:n,omega:i}=this.columns,a={left:1/0,right:-1/0,top:0,speed:0},r=[];for(let l=0;l<
this.length;l++){Number.isFinite(e[l])&&(a.left=Math.min(a.left,e[l]),a.right=Math.max(a.right,e[l])),t[l]>a.top&&(a.top=t[l]);let h=Math.hypot(s[l],n[l])+this.
radius*Math.abs(i[l]);Number.isFinite(h)&&r.push(h)}return r.sort((l,h)=>l-h),a.speed=r[Math.floor(.95*(r.length-1))]||1,a}index(e){let t=0,s=this.length;for(;s-
t>1;){let n=t+s>>1;this.t[n]<=e?t=n:s=n}return t}pieces(){let{part:e}=this;if(!e)return[{film:this,from:0,to:this.length}];let[t,s]=[e.t[0],e.t[e.length-1]],n=this.
index(t);for(;n>0&&this.t[n]>=t;)n--;let i=this.t[n]>=t?0:n+1;return[{film:this,from:0,to:i},{film:e,from:0,to:e.length},{film:this,from:this.index(s)+1,to:this.
length}]}at(e){let t=y(e,0,this.duration),s=this.holding(t);if(s!==this)return s.at(t);let n=this.index(t),i=Math.min(n+1,this.length-1),a=this.t[i]-this.t[n],r=a>
0?(t-this.t[n])/a:0,l={t,mode:io[this.columns.mode[n]]};for(let[h,c]of Object.entries(this.columns)){if(h==="t"||h==="mode")continue;let u=c[n],m=c[i];if(r===0||
!Number.isFinite(m))l[h]=u;else if(Kr.has(h)){let p=this.columns[Gr[h]];l[h]=Vr(u,m,p[n]*a,p[i]*a,r)}else l[h]=u+(m-u)*r}return l}derived(e,t){let s=this.cache.
get(e)??t(this.columns);return this.cache.set(e,s),s}};function Vr(o,e,t,s,n){if(!Number.isFinite(t)||!Number.isFinite(s))return o+(e-o)*n;let i=1-n;return i*i*
(1+2*n)*o+n*n*(3-2*n)*e+n*i*(i*t-n*s)}var lo=o=>o-360*Math.floor(o/360);function Jr(o,e){let t=Math.abs(lo(o-e+180)-180);return Math.round(100*y(1-(t-1)/89,0,1))}function Yr(o,e){let t=Math.max(...e)-
Math.min(...e,0),s=e.reduce((n,i,a)=>n+Math.abs(i-o[a]),0)/e.length;return Math.round(100*y(1-2*s/(t||1),0,1))}var Zr=0;function wt(o,e,t=!1){let s=`hh-guess-${++Zr}`,
n="",i=o.map(([a,r])=>{let l=d("input",{type:"radio",name:s,value:a,onchange:()=>{n=a,e()}});return{key:a,radio:l,row:d("label",{class:"guess-choice"},l,d("span",
{},r))}});return{element:d("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},i.map(({row:a})=>a)),made:()=>n!=="",judge:a=>{for(let{key:r,radio:l,
row:h}of i){l.disabled=!0;let c=t||r===a;c&&h.append(d("b",{class:"guess-right"},"✓")),h.classList.toggle("right",c)}return t||n===a?100:0}}}var fe=168,gt=58,
ao=(o,e=gt)=>{let t=o*Math.PI/180;return[fe/2+e*Math.sin(t),fe/2-e*Math.cos(t)]};function ho(o,e){let t=0,s=!1,n=null,i=d("canvas",{class:"dial-canvas"}),a=d("d\
iv",{class:"guess dial",role:"slider",tabindex:"0","aria-label":o,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},i),r=()=>{let{context:c}=D(i),u=getComputedStyle(
a),m=u.getPropertyValue("--ink").trim(),p=u.getPropertyValue("--soft").trim(),w=u.getPropertyValue("--accent").trim();c.clearRect(0,0,fe,fe),c.strokeStyle=p,c.fillStyle=
p,c.lineWidth=1.5,c.beginPath(),c.moveTo(8,fe/2+gt),c.lineTo(fe-8,fe/2+gt),c.stroke(),c.lineWidth=4,c.beginPath(),c.arc(fe/2,fe/2,gt,0,2*Math.PI),c.stroke(),c.font=
"11px system-ui, sans-serif",c.textAlign="center";for(let g of[0,90,180,270]){let[f,k]=ao(g,gt-17);c.fillText(`${g}°`,f,k+4)}let b=(g,f,k)=>{c.fillStyle=f,c.beginPath(),
c.arc(...ao(g),k,0,2*Math.PI),c.fill()};n!==null&&(c.strokeStyle=m,c.lineWidth=2,c.beginPath(),c.arc(...ao(n),12,0,2*Math.PI),c.stroke(),b(n,m,7)),b(t,s?w:p,9)},
l=c=>{n===null&&(t=lo(c),s=!0,a.setAttribute("aria-valuenow",String(Math.round(t))),a.setAttribute("aria-valuetext",`${Math.round(t)}°`),r(),e())},h=c=>{let u=i.
getBoundingClientRect(),[m,p]=[c.clientX-u.left-u.width/2,c.clientY-u.top-u.height/2];l(Math.atan2(m,-p)*180/Math.PI)};return a.addEventListener("pointerdown",c=>{
c.preventDefault(),a.focus({preventScroll:!0}),h(c),W(a,c,h)}),a.addEventListener("keydown",c=>{let u={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,
PageUp:45}[c.key];u!==void 0&&(c.preventDefault(),c.stopPropagation(),l(t+(c.shiftKey?u/5:u)))}),requestAnimationFrame(r),{element:a,redraw:r,made:()=>s,judge:c=>(n=
lo(c),r(),Jr(t,n))}}var ft=9,[ce,Zt,Ee,ro]=[34,12,12,26];function fi({label:o,unit:e,most:t},s){let n=Array(ft).fill(t/4),i=!1,a=null,r=d("canvas",{class:"sketc\
h-canvas"}),l=n.map((f,k)=>d("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":`${o} with the load at ${45*k}°`,"aria-orientation":"vertical",
"aria-valuemin":"0","aria-valuemax":String(t),onkeydown:T=>{let E={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[T.key];E&&(T.preventDefault(),T.stopPropagation(),
w(k,n[k]+E*t/(T.shiftKey?100:20)))}})),h=d("div",{class:"guess sketch",role:"group","aria-label":"Draw the curve: pull the points up and down"},r,l),c=()=>r.getBoundingClientRect(),
u=f=>ce+f/(ft-1)*(c().width-ce-Zt),m=f=>Ee+(1-f/t)*(c().height-Ee-ro),p=()=>{let{context:f,width:k,height:T}=D(r),E=getComputedStyle(h),N=z=>E.getPropertyValue(
z).trim();f.clearRect(0,0,k,T),f.strokeStyle=N("--line"),f.fillStyle=N("--soft"),f.font="11px system-ui, sans-serif";for(let z=0;z<ft;z+=2)f.textAlign="center",
f.fillText(`${45*z}°`,u(z),T-8),f.strokeRect(u(z),Ee,0,T-Ee-ro);for(let z of[0,t/2,t])f.textAlign="right",f.fillText(String(z),ce-6,m(z)+4),f.strokeRect(ce,m(z),
k-ce-Zt,0);f.textAlign="left",f.fillText(e,ce+4,Ee+10);let I=(z,Q,Bs)=>{f.strokeStyle=Q,f.lineWidth=2.5,f.setLineDash(Bs),f.beginPath(),z.forEach((Lt,Mn)=>{let En=ce+
Mn/(z.length-1)*(k-ce-Zt);Mn?f.lineTo(En,m(y(Lt,0,t))):f.moveTo(En,m(y(Lt,0,t)))}),f.stroke(),f.setLineDash([])};I(n,N("--accent"),[6,4]),a&&I(a,N("--ink"),[]),
l.forEach((z,Q)=>{z.style.transform=`translate(${u(Q)}px, ${m(n[Q])}px)`})},w=(f,k)=>{a||(n[f]=y(k,0,t),i=!0,l[f].setAttribute("aria-valuenow",n[f].toPrecision(
3)),l[f].setAttribute("aria-valuetext",`${n[f].toPrecision(2)} ${e}`),p(),s())},b=null,g=f=>{let k=c(),T=y((f.clientX-k.left-ce)/(k.width-ce-Zt),0,1),E=Math.round(
T*(ft-1)),N=t*(1-(f.clientY-k.top-Ee)/(k.height-Ee-ro)),I=b??E,z=n[I];for(let Q=Math.min(I,E);Q<=Math.max(I,E);Q++)w(Q,I===E?N:z+(N-z)*(Q-I)/(E-I));b=E};h.addEventListener(
"pointerdown",f=>{f.preventDefault(),b=null,g(f),W(h,f,g)});for(let[f,k]of l.entries())k.setAttribute("aria-valuenow",n[f].toPrecision(3));return requestAnimationFrame(
p),{element:h,redraw:p,made:()=>i,judge:f=>{a=f,p();let k=(f.length-1)/(ft-1);return Yr(n,n.map((T,E)=>f[Math.round(E*k)]))}}}var Qt=2*Math.PI,V=(o,e)=>o.events.find(t=>t.kind===e),Xt=o=>q(o-Qt*Math.floor(o/Qt));function Xr(o,e,t=72){let{angle:s}=o.columns,n=o.columns[e],i=[],a=0;for(let r=0;r<=
t;r++){let l=o.columns.angle[0]+Qt*r/t;for(;a+1<o.length&&s[a+1]<l;)a+=1;let h=Math.min(a+1,o.length-1),c=s[h]>s[a]?Math.min((l-s[a])/(s[h]-s[a]),1):0;i.push(n[a]+
c*(n[h]-n[a]))}return i}var Qr=(o,e)=>o.t[o.columns.angle.findIndex(t=>t>=e)]??o.duration,el={R:"roll",S:"spin",K:"skid",H:"bounce"},Ae=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:o=>wt(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],o),until:([o])=>{
let[e,t]=[V(o,"skim"),V(o,"impact")];return e?e.t+.7*((t?.t??o.duration)-e.t):o.duration},answer:([o])=>{let e=V(o,"skim")??V(o,"takeoff");return{truth:e?.kind===
"skim"?"skim":e?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:Xt(e?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:o=>fi({label:"Speed of the centre",unit:"m/s",most:10},
o),until:([o])=>Qr(o,Qt),answer:([o])=>{let e=Xr(o,"vx");return{truth:e,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:_(Math.max(
...e),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:o=>ho("Angle of the load where it begins to slip",o),until:([o])=>(V(o,"slip_start")?.t??0)+.02,answer:([o])=>{let e=V(o,"slip_start"),t=o.at(e.t).normal_force/
(o.mass*o.gravity);return{truth:e.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:Xt(e.
angle),share:`${_(100*t,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:o=>ho("Angle of the load\
 where it takes off",o),until:([o])=>(V(o,"takeoff")?.t??0)+.12,answer:([o])=>{let e=V(o,"takeoff"),t=o.at(e.t-1e-6);return{truth:e.angle*180/Math.PI,text:"It t\
akes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:Xt(e.angle),slip:_(Math.abs(t.slip),3)}}},why:"A rolling hoop would be braked by the plan\
e while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the \
top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does it d\
o just after it has landed?",queries:[""],guess:o=>wt([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim turns \
too fast."],["bounce","It bounces."]],o),until:([o])=>(V(o,"impact")?.t??o.duration)+.15,answer:([o])=>{let[e,t]=[V(o,"takeoff"),V(o,"impact")],s=o.events.find(
n=>n.kind==="apex");return{truth:el[o.at((t?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
values:{time:_((t?.t??0)-(e?.t??0),3),height:_(100*(s?.height??0),3),angle:Xt(t?.angle??0)}}},why:"An impact takes no time, but its friction is as strong as its\
 push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",title:"\
More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highest?",queries:[
"plane.mu=0.05","plane.mu=0.2",""],guess:o=>wt([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],o),until:o=>.3+Math.max(0,...o.map(e=>V(e,"impact")?.t??0)),
answer:o=>{let e=o.map(i=>Math.max(0,...i.events.map(({kind:a,height:r})=>a==="apex"?r:0))),[t,s,n]=e.map(i=>_(100*i,3));return{truth:String(e.indexOf(Math.max(
...e))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:t,middle:s,high:n}}},why:"On ice nothing drives the ro\
tation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the\
 way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies w\
ith dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plan\
e.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:o=>wt([["flight","It flies off."],["impact","An impact stops the sli\
de at once."],["both","Both agree with the laws."]],o),until:o=>Math.min(.8,...o.map(e=>e.duration)),answer:o=>({truth:o.every(e=>V(e,"painleve_indeterminate"))?
"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws have two an\
swers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"Your tur\
n",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from\
 the motion itself.",question:"",queries:[""]}];var gi="hophoop-visit",es=class{step=null;guess=null;films=[];points=new Map;play;next;stop=null;loop=null;asked=0;constructor(e,t){this.lab=e,this.onchallenges=
t,this.body=d("div",{class:"visit-body"}),this.said=d("div",{class:"visit-answer",role:"status"}),this.element=d("section",{class:"visit card","aria-label":"Gui\
ded visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){ae(gi)||(this.element.hidden=!1,M(this.said,""),this.
body.replaceChildren(d("div",{class:"buttons offer"},d("p",{},d("b",{},"New here?")," ","Eight short questions: guess, then play."),d("button",{type:"button",class:"\
main",onclick:()=>this.start()},"Start the visit"),d("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){this.points.clear(),this.go(0)}leave(){
re(gi,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.root.classList.remove("visiting"),this.veil(),this.
lab.show()}async go(e){let t=Ae[e],s=++this.asked,{lab:n}=this;n.clock.play(!1),n.clock.time=0,this.step=t,this.stop=null,this.guess=null,this.unwind(),M(this.said,
""),this.element.hidden=!1,n.root.classList.toggle("visiting",e<Ae.length-1);try{let i=await Promise.all(t.queries.map(a=>n.backend.call("film",{query:a})));if(s!==
this.asked)return;this.films=i.map(a=>new ke(a)),n.motions.active=0,n.motions.set(i.slice(0,2)),this.guess=t.guess?.(()=>this.guessed())??null,this.veil(),n.changed(),
n.motions.note(),this.fill(e)}catch(i){n.notice.fail(i)}}veil(){this.lab.root.classList.toggle("guessing",this.guessing),this.guessing&&this.lab.stage.element.setAttribute(
"aria-label",x("The hoop, before it is let go."))}fill(e){let t=Ae[e];this.play=d("button",{type:"button",class:"main",disabled:!!this.guess,onclick:()=>this.show()},
"Play");let s=e===Ae.length-1,n=d("h2",{tabindex:"-1"},t.title);this.next=d("button",{type:"button",onclick:()=>this.go(e+1)},"Next"),this.body.replaceChildren(
d("header",{},d("span",{class:"visit-count"},`Step ${e+1} of ${Ae.length}`),d("progress",{max:String(Ae.length),value:String(e+1),"aria-hidden":"true"}),d("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),n,d("p",{},t.text),t.question?d("p",{class:"visit-question"},t.
question):"",this.guess?.element??"",d("div",{class:"buttons"},e>0&&d("button",{type:"button",onclick:()=>this.go(e-1)},"Back"),this.guess&&this.play,s?d("butto\
n",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,s&&d("button",{type:"button",onclick:()=>this.leave()},"Done"),this.guess&&
d("span",{class:"hint visit-wait"},"First say what you expect, then play."))),s&&this.points.size&&this.total(),n.focus({preventScroll:!0})}guessed(){this.play&&
(this.play.disabled=!1);let e=this.body.querySelector(".visit-wait");e&&(e.hidden=!0)}show(){let{lab:e,step:t}=this;!t||!this.guess||(this.play.disabled=!0,this.
stop=t.until?.(e.films())??e.clock.duration,this.loop??=e.clock.loop,e.clock.loop=!1,e.clock.seek(0),matchMedia("(prefers-reduced-motion: reduce)").matches?e.clock.
seek(this.stop):e.clock.play(!0),this.frame())}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:e}=this.lab;if(this.stop===
null||e.playing&&e.time<this.stop||!(e.time>=this.stop-1e-9||!e.playing))return;e.playing=!1;let s=this.stop;this.stop=null,this.unwind(),e.seek(s),this.judge()}judge(){
let{step:e,guess:t}=this;if(!e?.answer||!t)return;let{truth:s,text:n,values:i={}}=e.answer(this.films),a=t.judge(s);this.points.set(e.key,a),this.said.replaceChildren(
d("p",{},d("b",{},`${a} of 100 points.`)," ",Dn(n,i)),d("p",{},e.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.scrollIntoView(
{block:"nearest"})}total(){let e=[...this.points.values()].reduce((t,s)=>t+s,0);this.said.replaceChildren(d("p",{},`You have ${e} of ${100*this.points.size} poi\
nts.`))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&this.veil()}};var ts=class{words={t:x,untranslated:ht};constructor(e){this.lab=e,this.grips=new Gt(e),this.sound=new Jt,this.present=new Vt(e),this.challenges=new Ht(e),this.
visit=new es(e,()=>this.challenges.open()),this.table=new Yt(e),this.teach=mi(t=>this.challenges.load(t),()=>this.visit.start()),this.layOut(),this.spoken()}layOut(){
let{lab:e}=this,t=e.stage.element.parentElement,s=e.root.querySelector(".side");s?s.prepend(this.visit.element,this.challenges.element):t.before(this.visit.element,
this.challenges.element),t.after(this.table.element),e.root.append(this.teach),e.transport.element.querySelector(".switches")?.before(this.tools()),e.header.element.
querySelector(".right")?.prepend(this.menu(),this.languages()),e.hosted&&!location.search&&!location.hash&&this.visit.offer()}tools(){let{clock:e}=this.lab,t=(s,n,i)=>d(
"button",{type:"button",title:n,"aria-label":n,"aria-pressed":"false",onclick:i},$(s));return this.loop=t("loop","Repeat",()=>{e.loop=!e.loop,this.mark()}),this.
slow=t("slow","Slow motion: a tenth of the speed",()=>{e.speed=e.speed===.1?1:.1,e.changed(),this.mark()}),this.loud=t("sound","Sound of the contact",()=>{this.
sound.turn(!this.sound.on),this.mark()}),this.large=t("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),
this.mark(),d("div",{class:"buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:e}=this.lab;this.loop?.setAttribute("aria-pressed",String(
e.loop)),this.slow?.setAttribute("aria-pressed",String(e.speed===.1)),this.loud?.setAttribute("aria-pressed",String(this.sound.on)),this.large?.setAttribute("ar\
ia-pressed",String(this.present.on))}menu(){let e=(s,n)=>d("button",{type:"button",onclick:()=>{t.open=!1,n()}},s),t=d("details",{class:"learn"},d("summary",{class:"\
button"},"Learn"),d("div",{class:"menu-body"},e("Guided visit",()=>this.visit.start()),e("Challenges",()=>this.challenges.open()),e("Table of the motion",()=>this.
table.open(!0)),e("Presentation",()=>this.present.turn(!0)),e("For teachers",()=>this.teach.showModal())));return this.lab.root.addEventListener("pointerdown",s=>{
t.contains(s.target)||(t.open=!1)}),t.addEventListener("keydown",s=>{s.key!=="Escape"||!t.open||(s.stopPropagation(),t.open=!1,t.querySelector("summary")?.focus())}),
t}languages(){let e=d("select",{class:"language","aria-label":"Language",onchange:()=>{On(e.value),Gs(e.value),this.spoken(),Bn(this.lab.root),this.lab.show()}},
Object.entries(lt).map(([t,s])=>d("option",{value:t,lang:t},document.createTextNode(s))));return e.value=Ct(),e}spoken(){this.lab.root.lang=Ct(),this.lab.hosted&&
(document.documentElement.lang=Ct())}frame(){let{lab:e}=this;this.grips.draw(),this.sound.follow(e.film(),e.clock),this.table.cursor(e.clock.time),this.visit.frame(),
this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.challenges.changed(),this.visit.changed()}close(){this.sound.close(),this.present.
close()}};var bt=(o,e,t)=>d("button",{type:"button",title:e,"aria-label":e,onclick:t},o),ss=class{constructor(e,t,s){let n=new Map;for(let a of e)n.set(a.group,[...n.get(
a.group)??[],a]);this.fresh=!1,this.presets=d("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let a=e.find(({key:r})=>r===this.presets.
value);this.fresh=a!==void 0,a&&s.take(a)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},d("option",{value:""},"Motions to start from …"),[...n].
map(([a,r])=>d("optgroup",{label:a},r.map(({key:l,title:h})=>d("option",{value:l},h))))),this.undo=bt($("undo"),"Undo (z)",s.undo),this.redo=bt($("redo"),"Redo \
(y)",s.redo);let i=d("span",{},d("span",{class:"long"},"Compare"),d("span",{class:"short"},$("two")));this.compare=bt(i,"Compare two hoops",s.compare),this.element=
d("header",{class:"top"},d("h1",{},d("span",{class:"logo","aria-hidden":"true"}),d("span",{},"hophoop",d("span",{class:"long"}," lab"))),this.presets,d("div",{class:"\
buttons"},this.undo,this.redo,this.compare),d("div",{class:"buttons right"},t,bt($("theme"),"Dark or light (d)",s.theme),bt("?","Keys and help (?)",s.help)))}show(e,t){
this.undo.disabled=!e.past.length,this.redo.disabled=!e.future.length,this.compare.setAttribute("aria-pressed",String(t))}};var tl=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["Esc","leave a field, a menu, a picture \
that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],sl=[["R","roll","the rim does not slide"],["S","spin","slip: the rim tur\
ns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],["H","\
flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],ol=[["▲ ▼","take-off, landing"],["•","highest point"],
["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy out of nothing"],["≋","bounces without numbe\
r end"],["◗ ■","skimming begins, rest"]],co=(o,e,t=()=>!1)=>d("table",{},d("caption",{},o),e.map(([s,...n])=>d("tr",{},d("th",{scope:"row"},t(s),s),n.map(i=>d(
"td",{},i)))));function wi(o,e,t){let s=d("dialog",{class:"help","aria-label":"Keys and help"},d("h2",{},"The hoop"),d("p",{},"A ring with a load on its rim rol\
ls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide\
. Move a slider and see."),co("Modes",sl,n=>d("i",{class:"dot",style:`background:${e.modes[n]}`})),co("Marks on the bar of time",ol),co("Keys",tl),t,d("p",{class:"\
hint"},`hophoop ${o}`),d("button",{type:"button",class:"close",onclick:()=>s.close()},"Close"));return s}var os=class{constructor(e){this.tabs=["A","B"].map((t,s)=>d("button",{type:"button","aria-pressed":"false",onclick:()=>e(s)},`Hoop ${t}`)),this.bar=d("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=d("p",{class:"preset-text"}),this.element=d("div",{class:"lanes"},
this.bar,this.text)}show(e,t){this.bar.hidden=e<2;for(let[s,n]of this.tabs.entries())n.setAttribute("aria-pressed",String(s===t))}};var bi="hophoop-single-keys",nl=(o,e)=>({" ":()=>o.clock.play(),ArrowLeft:()=>e?o.transport.jump(-1):o.transport.nudge(-1),ArrowRight:()=>e?o.transport.jump(1):
o.transport.nudge(1),Home:()=>o.clock.seek(0),End:()=>o.clock.seek(o.clock.duration),h:()=>o.transport.jump(1,"takeoff"),l:()=>o.transport.jump(1,"impact"),"[":()=>o.
clock.faster(-1),"]":()=>o.clock.faster(1),t:()=>o.toggle("traces"),f:()=>o.toggle("forces"),c:()=>o.toggle("speed"),w:()=>o.toggle("whole"),3:()=>o.toggle("thr\
ee"),"+":()=>o.stage.zoom(1.25),"=":()=>o.stage.zoom(1.25),"-":()=>o.stage.zoom(.8),0:()=>o.stage.zoom(0),z:()=>o.travel(-1),y:()=>o.travel(1),d:()=>o.theme.toggle(),
p:()=>o.share.code(),"?":()=>o.help.showModal()});function il(o,e){let t=e.key.toLowerCase();e.altKey||!(t==="z"||t==="y")||(e.preventDefault(),o.travel(t==="y"||
e.shiftKey?1:-1))}function al(o){let e=o.share.menu;e.open&&(e.open=!1,e.querySelector("summary")?.focus())}var ns=class{constructor(e){this.on=!e||ae(bi)!=="of\
f";let t=d("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=t.checked,e&&re(bi,this.on?"on":"off")}});this.element=d("label",{class:"check"},t,"Si\
ngle keys (letters, digits, signs) do what the table says")}};function rl(o,e){let t=e.target;if(o.root.querySelector("dialog[open]"))return;if(e.key==="Escape"){
al(o);return}if(t.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(e.ctrlKey||e.metaKey){il(o,e);return}if(e.altKey||t.matches?.("selec\
t")&&!(e.key===" "&&o.header.fresh)||t.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(e.key)||e.key===" "&&t.matches?.("button, summary, input[ty\
pe=checkbox]")||!o.singleKeys.on&&e.key!==" "&&e.key.length===1)return;let n=nl(o,e.shiftKey)[e.key];n&&(e.preventDefault(),n())}function yi(o,e){let t=e?document:
o.root,s=n=>{rl(o,n),e||n.stopPropagation()};return t.addEventListener("keydown",s),()=>t.removeEventListener("keydown",s)}var ll={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function He(o){let e=o instanceof DataView||ArrayBuffer.isView(o)?o:new DataView(o),t=new Uint8Array(e.buffer,
e.byteOffset,e.byteLength);t.byteOffset%8&&(t=t.slice());let s=new DataView(t.buffer,t.byteOffset).getUint32(0,!0),n=JSON.parse(new TextDecoder().decode(t.subarray(
4,4+s))),i={};for(let{name:a,type:r,shape:l,place:h}of n.arrays){let c=l.reduce((u,m)=>u*m,1);i[a]=new ll[r](t.buffer,t.byteOffset+4+s+h,c)}return{header:n,arrays:i}}var yt=class extends Error{},hl=500,cl=4,dl="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";async function vi(o,e,t){
for(;;)try{return await o()}catch(s){if(!(s instanceof yt))throw s;e(s.message),await new Promise(n=>setTimeout(n,hl)),t.throwIfAborted()}}var is=class{constructor(e){
this.base=e,this.shares=!0}async call(e,t,s){let n={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(t),signal:s},i=await this.answered(
new URL(`lab/${e}`,this.base),n);if(i.status===202)throw new yt((await i.json()).detail);return He(await i.arrayBuffer())}async answered(e,t){for(let s=cl;;s--){
let n=await fetch(e,t).catch(a=>{throw a.name==="AbortError"?a:new Error(dl)});if(n.ok)return n;let i=Number(n.headers.get("Retry-After"));if(n.status!==503||!(i>
0)||s<=1){let a=await n.json().catch(()=>({}));throw new Error(a.detail??`The server answered ${n.status}.`)}await new Promise(a=>setTimeout(a,1e3*Math.min(i,10))),
t?.signal?.throwIfAborted()}}async file(e,t){return(await this.answered(new URL(`api/v1/files/${e}?${t}`,this.base))).blob()}link(e,t){return`${new URL(e?`?${e}`:
"",this.base)}${t}`}},ul=2e4,ml=3e5,as=class{constructor(e){this.model=e,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).
slice(2),this.listen=(t,s)=>this.answered(t,s),e.on("msg:custom",this.listen)}answered(e,t){let s=e?.view===this.view&&this.waiting.get(e.number);s&&(clearTimeout(
s.timer),this.waiting.delete(e.number),e.compiling?s.reject(new yt(e.compiling)):e.error?s.reject(new Error(e.error)):s.resolve(He(t[0])))}call(e,t,s){let n=++this.
number;return new Promise((i,a)=>{let r=setTimeout(()=>{this.waiting.delete(n),a(new Error("The notebook’s kernel does not answer; run the cell again."))},e===
"file"?ml:ul);this.waiting.set(n,{resolve:i,reject:a,timer:r}),s?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(n),a(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:n,call:e,body:t})})}async file(e,t){let{arrays:s}=await this.call("file",{query:t,name:e});return new Blob(
[s.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};var[ki,pl]=[62,92],fl=12,ze=10,gl=36,xi=Math.PI/180,de=["x","y"],rs=class{box;constructor(e){this.known=new Map(e.map(t=>[t.path,t])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=ki}info(e){return this.known.get(this.paths[e])}whole(e){return[...this.info(e).range]}home(){
for(let e of de)this.windows[e]=this.whole(e)}choose(e,t){let s=e==="x"?"y":"x";this.paths[s]===t&&(this.paths[s]=this.paths[e]),this.paths[e]=t,this.home()}asked(e,t){
let[s,n]=this.windows[e];return{path:this.paths[e],from:s,to:n,cells:t}}bounds(e){let{range:t,allowed:s}=this.info(e),n=2*(t[1]-t[0]);return[Math.max(s[0],t[0]-
n),Math.min(s[1],t[1]+n)]}zoom(e,t){let s={x:[],y:[]};for(let n of de){let[i,a]=this.windows[n],r=t?.[n]??.5*(i+a);s[n]=Re([r-(r-i)*e,r+(a-r)*e],this.bounds(n));
let l=Math.max(Math.abs(s[n][0]),Math.abs(s[n][1]),1e-9);if(s[n][1]-s[n][0]<400*Number.EPSILON*l)return!1}return de.every(n=>s[n].every((i,a)=>i===this.windows[n][a]))?
!1:(this.windows=s,!0)}drag(e,t,s){let n=(i,a)=>Re(e[i].map(r=>r+a*(e[i][1]-e[i][0])),this.bounds(i));this.windows={x:n("x",-t/this.box.width),y:n("y",s/this.box.
height)}}restore(e){if(!de.every(t=>this.known.has(e[t][0]))||e.x[0]===e.y[0])return!1;for(let t of de)this.paths[t]=e[t][0];for(let t of de)this.windows[t]=Re(
e[t].slice(1).map(Number),this.bounds(t));return!0}isHome(){return de.every(e=>this.windows[e].every((t,s)=>t===this.whole(e)[s]))}middle(){let{x:e,y:t}=this.windows;
return{x:.5*(e[0]+e[1]),y:.5*(t[0]+t[1])}}fit(e,t){this.left=this.deep("y")?pl:ki,this.box={width:e-this.left-fl,height:t-ze-gl}}clip(e){e.beginPath(),e.rect(this.
left,ze,this.box.width,this.box.height),e.clip()}x(e){let[t,s]=this.windows.x;return this.left+(e-t)/(s-t)*this.box.width}y(e){let[t,s]=this.windows.y;return ze+
(1-(e-t)/(s-t))*this.box.height}place(e,t){let s=([n,i],a)=>n+y(a,0,1)*(i-n);return{x:s(this.windows.x,(e-this.left)/this.box.width),y:s(this.windows.y,1-(t-ze)/
this.box.height)}}deep(e){let[t,s]=this.windows[e];return s-t<5e-5*Math.max(Math.abs(t),Math.abs(s))}said(e){let t=s=>{let n=this.info(s),[i,a]=this.windows[s],
r=Math.max(Math.abs(i),Math.abs(a)),l=y(Math.ceil(Math.log10(r/(a-i)))+4,4,16);return`${x(n.label)} = ${F(_(n.degrees?e[s]/xi:e[s],l),n.unit)}`};return`${t("x")}\
, ${t("y")}`}draw(e,t,s){e.strokeStyle=s.soft,e.fillStyle=s.soft,e.lineWidth=1,e.strokeRect(this.left+.5,ze+.5,this.box.width-1,this.box.height-1),e.font=`11px ${s.
font}`;for(let n of de){let i=this.info(n),a=i.degrees?1/xi:1,[r,l]=this.windows[n].map(g=>g*a),h=n==="x"?this.box.width/80:this.box.height/40,c=U(l-r,h),u=this.
deep(n),m=u?Number((.5*(r+l)).toPrecision(12)):0,p=u?te(r-m,l-m,h).map(g=>g+m):te(r,l,h);for(let g of p){let f=u?_(g-m,3):Y(g,c);n==="x"?(e.textAlign="center",e.
fillText(f,this.x(g/a),ze+this.box.height+14)):(e.textAlign="right",e.textBaseline="middle",e.fillText(f,this.left-5,this.y(g/a)),e.textBaseline="alphabetic")}let w=u?
` − ${String(m).replace("-","−")}`:"",b=`${x(i.label)}${w}${i.unit?` [${i.unit}]`:""}`;e.save(),e.textAlign="center",n==="x"?e.translate(this.left+.5*this.box.
width,t-5):(e.translate(12,ze+.5*this.box.height),e.rotate(-Math.PI/2)),e.fillText(b,0,0),e.restore()}}};function Re([o,e],[t,s]){let n=Math.min(e-o,s-t);return o<
t?[t,t+n]:e>s?[s-n,s]:[o,e]}function uo(o,e,t,s,n){for(let[i,a]of[[n,4],[s,1.8]])o.strokeStyle=i,o.lineWidth=a,o.beginPath(),o.arc(e,t,7,0,2*Math.PI),o.moveTo(e-
13,t),o.lineTo(e-4,t),o.moveTo(e+4,t),o.lineTo(e+13,t),o.moveTo(e,t-13),o.lineTo(e,t-4),o.moveTo(e,t+4),o.lineTo(e,t+13),o.stroke()}var Ke=o=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${o&&`; ${o}`}; double-click for all`,wl=.0018,_i=200,
[bl,yl]=[1/.6,1/1.7];function Z(o,{zoom:e,home:t,chosen:s=()=>o,keys:n=!1}){return o.addEventListener("wheel",i=>{(i.ctrlKey||i.metaKey||Ot(s()))&&(i.preventDefault(),
e(Math.exp(-Math.min(Math.max(i.deltaY,-_i),_i)*wl),i))},{passive:!1}),o.addEventListener("dblclick",t),n&&o.addEventListener("keydown",i=>{if(i.key==="+"||i.key===
"=")e(bl);else if(i.key==="-")e(yl);else if(i.key==="0")t();else if(i.key==="Escape")o.blur();else return;i.preventDefault(),i.stopPropagation()}),ii(o,e)}var Ti={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},Si=48;function Mi(o){let{body:e}=o,t=!1,s=Z(e,{zoom:(n,i)=>o.axes.box&&o.zoom(1/n,i?mo(
o,i):o.pointed??void 0),home:()=>o.home(),keys:!0});e.addEventListener("pointerdown",n=>kl(o,n,s,i=>t=i)),e.addEventListener("pointermove",n=>{o.axes.box&&!t&&n.
pointerType!=="touch"&&vl(o,n)}),e.addEventListener("pointerleave",()=>o.tip.hidden=!0),e.addEventListener("keydown",n=>xl(o,n))}function mo(o,e){let t=o.body.getBoundingClientRect();
return o.axes.place(e.clientX-t.left,e.clientY-t.top)}function vl(o,e){o.tip.textContent=o.said(mo(o,e)),o.tip.hidden=!1;let t=o.body.getBoundingClientRect();o.
tip.style.left=`${y(e.clientX-t.left,150,Math.max(t.width-150,150))}px`,o.tip.style.bottom=`${t.bottom-e.clientY+16}px`}function kl(o,e,t,s){e.preventDefault(),
o.body.focus({preventScroll:!0});let n=[e.clientX,e.clientY],i={x:[...o.axes.windows.x],y:[...o.axes.windows.y]};o.pointed=mo(o,e);let a=!1,r=t(),l=h=>{if(r||=t(),
r)return;let[c,u]=[h.clientX-n[0],h.clientY-n[1]];Math.hypot(c,u)<5&&!a||(a=!0,s(!0),o.tip.hidden=!0,o.axes.drag(i,c,u),o.redraw(),o.soon())};W(o.body,e,l,(h,c)=>{
c&&!a&&!r&&o.pointed&&o.take(o.pointed),s(!1)})}function xl(o,e){let t=o.pointed??o.here()??o.axes.middle();if(o.pointed=t,Ti[e.key]){let[s,n]=Ti[e.key],{x:i,y:a}=o.
axes.windows;o.pointed={x:y(t.x+s*(i[1]-i[0])/Si,i[0],i[1]),y:y(t.y+n*(a[1]-a[0])/Si,a[0],a[1])},o.state.textContent=o.said(o.pointed),o.say(o.said(o.pointed))}else if(e.
key==="Enter")o.take(t);else return;e.preventDefault(),e.stopPropagation(),o.redraw()}var _l=["start.height","start.vx","start.vy","start.omega"];function Ei(o,e){let t="speed"in o.start;return!t&&e.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":t&&e.some(s=>_l.includes(s))?"of starts in any state, though this motion starts rolling":""}var Tl=Math.PI/180,Sl=12,Ml=["hop_height","flight_time","energy_lost","greatest_utilization"];function Ai(o){return o.unit==="rad"?[1/Tl,"°"]:[1,o.unit==="1"?"":
o.unit]}function El({classes:o,what:e},t){let[s,n]=[1/0,-1/0];if(o)return[s,n];for(let i of t)i<s&&(s=i),i>n&&(n=i);return[Ml.includes(e)?Math.min(s,0):s,n]}function zi(o){
let{values:e}=o.arrays,t=o.header,{x:s,y:n,classes:i}=t,a=new ImageData(s.cells,n.cells),[r,l]=El(t,e),h=i?.map(({color:u})=>ue(u));for(let u=0;u<n.cells;u++)for(let m=0;m<
s.cells;m++){let p=e[u*s.cells+m],w=4*((n.cells-1-u)*s.cells+m);if(!Number.isFinite(p))continue;let b=h&&(m+1<s.cells&&e[u*s.cells+m+1]!==p||u+1<n.cells&&e[(u+1)*
s.cells+m]!==p),g=h?h[p].map(f=>b?.72*f:f):We[y(Math.round(255*(p-r)/(l-r||1)),0,255)];a.data.set([...g,255],w)}let c=d("canvas",{width:s.cells,height:n.cells});
return pe(c).putImageData(a,0,0),{picture:c,header:t,values:e,x:[s.from,s.to],y:[n.from,n.to],low:r,high:l}}function Ri(o,e){let t=(n,i)=>n[0]>=i[0]-1e-300&&n[1]<=
i[1]+1e-300;return[...o.filter(n=>!(t(n.x,e.x)&&t(n.y,e.y))),e].slice(-Sl)}function Pi({header:o,low:e,high:t,values:s}){let{classes:n}=o;if(!n){let r=d("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=pe(r);for(let u=0;u<120;u++)l.fillStyle=`rgb(${We[Math.floor(255*u/119)].join(",")})`,l.fillRect(u,0,1,
10);let[h,c]=Ai(o);return[d("span",{},o.label,": ",t>=e?_(e*h,3):"none"," "),r,d("span",{},t>=e?F(_(t*h,3),c):""),s.some(u=>!Number.isFinite(u))?d("span",{},d("\
i",{class:"blank"}),"none"):""]}let i=new Map;for(let r of s)i.set(r,(i.get(r)??0)+1);let a=[...i].filter(([r])=>r>=0).sort((r,l)=>l[1]-r[1]);return[...a.slice(
0,10).map(([r])=>{let{color:l,text:h}=n[r];return d("span",{},d("i",{style:`background:${l}`,"aria-hidden":"true"}),h)}),a.length>10?d("span",{},`and ${a.length-
10} more`):""]}function Ii(o,e){for(let{header:t,values:s}of[...o].reverse()){let{x:n,y:i,classes:a}=t,r=Math.floor((e.x-n.from)/(n.to-n.from)*n.cells),l=Math.floor(
(e.y-i.from)/(i.to-i.from)*i.cells);if(r<0||l<0||r>=n.cells||l>=i.cells)continue;let h=s[l*n.cells+r];if(a)return x(a[h]?.text??"not allowed");let[c,u]=Ai(t);return Number.
isFinite(h)?F(_(h*c,4),u):x("none")}return"…"}var Li=[[24,16],[72,48],[216,144]],ls=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(e,t,{take:s,say:n,changed:i}){this.backend=
e,this.onmotion=s,this.say=n,this.changed=i;let a=t.controls.map_axes;this.axes=new rs(a),this.what="sequence",this.layers=[],this.canvas=d("canvas",{class:"plo\
t-canvas"}),this.tip=d("div",{class:"tip",hidden:!0}),this.body=d("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow ke\
ys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=d("div",{class:"map-keys"}),this.state=d("span",{class:"hint"});
let r=l=>{let h=d("select",{"data-axis":l,onchange:()=>this.setAxis(l,h.value)},a.map(({path:c,label:u})=>d("option",{value:c},u)));return h};this.selects={x:r(
"x"),y:r("y")},this.quantity=d("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},t.map_quantities.map(([l,
h])=>d("option",{value:l},h))),this.element=d("section",{class:"map","aria-label":"Map of motions"},d("div",{class:"map-head"},d("h2",{},"Map"),d("label",{},"of",
this.quantity),d("label",{},"Across",this.selects.x),d("label",{},"Up",this.selects.y),d("span",{class:"buttons"},d("button",{type:"button","aria-label":"Zoom i\
nto the map",onclick:()=>this.zoom(.5)},"+"),d("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),d("button",{type:"but\
ton",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,d("p",{class:"hint"},`Click to take that motion into the player; ${Ke("drag to move")}\
.`)),Mi(this),this.soon=he(()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.
refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let e of de)this.selects[e].value=
this.axes.paths[e]}setAxis(e,t){this.axes.choose(e,t),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(e){let t=structuredClone(e);
for(let s of Object.values(this.axes.paths)){let[n,i]=s.split(".");t[n]&&delete t[n][i]}return JSON.stringify(t)}mark(e,t){this.film=e,this.look=t;let s=this.key_of(
e.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){let{paths:e,windows:t}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&
e.x==="start.speed"&&e.y==="plane.mu")return;let s=n=>[e[n],...t[n]];return{what:this.what,x:s("x"),y:s("y")}}restore(e){![...this.quantity.options].some(({value:t})=>t===
e.what)||!this.axes.restore(e)||(this.quantity.value=this.what=e.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked,t=this.film.scenario,s=t.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let n=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;n!==this.kind&&(this.layers=[]),this.
kind=n,this.redraw();try{for(let[i,a]of Li){M(this.state,`computing ${i*a} motions …`);let r={x:this.axes.asked("x",i),y:this.axes.asked("y",a)},l={scenario:t,
changes:s,...r,what:this.what},h=await vi(()=>this.backend.call("map",l,e),p=>{M(this.state,p)},e),c=zi(h);this.layers=Ri(this.layers,c),this.keys.replaceChildren(
...Pi(c));let u=Ei(t,Object.values(this.axes.paths)),m=x(s.length?"{count} motions, with rigid contact":"{count} motions",{count:i*a});M(this.state,u?`${m}; ${x(
u)}`:m),this.redraw()}this.level=Li.length}catch(i){let{name:a,message:r}=i;if(a==="AbortError")return;M(this.state,r)}this.computing=!1}redraw(){if(!this.film)
return;let{look:e}=this,{context:t,width:s,height:n}=D(this.canvas);this.axes.fit(s,n),t.clearRect(0,0,s,n),t.save(),this.axes.clip(t),t.imageSmoothingEnabled=!1;
let{axes:i}=this;for(let r of this.layers){let[l,h]=r.x.map(m=>i.x(m)),[c,u]=r.y.map(m=>i.y(m));t.drawImage(r.picture,l,u,h-l,c-u)}let a=this.here();a&&uo(t,i.x(
a.x),i.y(a.y),e.ink,e.paper),this.pointed&&Ot(this.body)&&uo(t,i.x(this.pointed.x),i.y(this.pointed.y),"#D55E00",e.paper),t.restore(),i.draw(t,n,e)}here(){let e=s=>{
let[n,i]=s.split(".");return this.film.values[s]??this.film.scenario[n]?.[i]},t={x:e(this.axes.paths.x),y:e(this.axes.paths.y)};return typeof t.x=="number"&&typeof t.
y=="number"?t:null}said(e){return`${this.axes.said(e)}: ${Ii(this.layers,e)}`}take(e){this.onmotion([[this.axes.paths.x,e.x],[this.axes.paths.y,e.y]])}zoom(e,t){
this.tip.hidden=!0,this.axes.zoom(e,t)&&(this.redraw(),this.soon())}};var hs=class{constructor(){this.past=[],this.future=[],this.now=null,this.what="",this.when=-1/0}note(e,t="",s=performance.now()){let n=this.now;if(this.now=e,n===
null||po(n,e))return"same";let i=t!==""&&t===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=t,this.when=s,this.future=[],i?"again":(this.past.push(
n),this.past.length>500&&this.past.shift(),"step")}next(e){return(e<0?this.past:this.future).at(-1)??null}step(e){let[t,s]=e<0?[this.past,this.future]:[this.future,
this.past],n=t.pop();!n||!this.now||(s.push(this.now),this.now=n,this.what="")}arrive(e){if(!(this.now&&po(this.now,e))){for(let t of[-1,1]){let s=t<0?this.past:
this.future,n=s.length-s.findLastIndex(i=>po(i,e));if(!(n>s.length)){for(let i=0;i<n;i++)this.step(t);return}}Object.assign(this,{past:[],future:[],now:e,what:""})}}},
po=(o,e)=>JSON.stringify(o)===JSON.stringify(e);var cs=class{constructor(e,t){this.backend=e,this.listener=t,this.history=new hs,this.lanes=[],this.active=0,this.going=Promise.resolve()}film(e=this.active){return this.
lanes[e].film}films(){return this.lanes.map(e=>e.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([e])=>e))}name(){return this.lanes.length>
1?"AB"[this.active]:""}set(e){this.lanes=e.map(t=>({film:new ke(t)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(e){this.set(await Promise.
all(e.map(t=>this.backend.call("film",{query:t}))))}change(e,t){let s=this.lanes[this.active];s.since??=performance.now(),s.pending=[...(s.pending??[]).filter(([
n])=>!e.some(([i])=>i===n)),...e],s.commit||=t,s.what=e.map(([n])=>n).join(),this.pump(s)}async pump(e){if(e.busy||!this.lanes.includes(e))return;if(!e.pending){
e.commit&&this.settle(e);return}let t=e.pending,{since:s}=e;e.pending=null,e.since=null,e.busy=!0;try{e.film=new ke(await this.backend.call("film",{scenario:e.film.
scenario,changes:t})),this.lanes.includes(e)&&this.listener.shown(s)}catch(n){this.lanes.includes(e)&&this.listener.failed(n,t)}finally{e.busy=!1}this.pump(e)}refine(e,t){
for(let s of this.lanes){let{film:n}=s,i=s.refining||s.coarse===n?null:n.wanted(e,t);i&&(s.refining=!0,this.backend.call("samples",{scenario:n.scenario,window:i}).
then(({arrays:a})=>{n.refine(a),this.listener.refined()}).catch(()=>{s.coarse=n}).finally(()=>{s.refining=!1}))}}settle(e){e.commit=!1,this.note(e.what),this.listener.
settled()}queries(){return this.films().map(e=>e.query)}note(e){this.listener.noted(this.history.note(this.queries(),e))}replace(e){this.lanes[this.active]={film:new ke(
e)},this.listener.shown(),this.note()}travel(e){return this.inTurn(async()=>{let t=this.history.next(e);t&&(await this.load(t),this.history.step(e),await this.listener.
travelled(e),this.listener.shown(),this.listener.noted("travelled"))})}arrive(e){return this.inTurn(async()=>{await this.load(e),this.history.arrive(e),this.listener.
shown(),this.listener.noted("travelled")})}inTurn(e){return this.going=this.going.then(e).then(()=>!0,t=>(this.listener.failed(t),!1)),this.going}compare(){this.
lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=0),this.listener.shown(),this.note()}choose(e){
this.active=e,this.listener.shown(),this.listener.noted("same")}link(e=""){let s=[this.lanes.length>1?`with=${encodeURIComponent(this.film(1).query)}`:"",e].filter(
Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};var Al=6e3,ds=class{constructor(){this.message=d("p",{class:"message",role:"alert",hidden:!0}),this.toast=d("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(e){M(this.message,e.message),this.message.hidden=!1,this.seen()||this.say(e.message,this.message.isConnected)}seen(){let{top:e,bottom:t,height:s}=this.
message.getBoundingClientRect();return this.message.isConnected&&s>0&&e>=0&&t<=innerHeight}clear(){this.message.hidden=!0}say(e,t=!1){this.toast.setAttribute("r\
ole",t?"presentation":"status"),M(this.toast,e),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},Al)}};var X=52,fo=10,H=8,zl=30,go={solid:[],dash:[6,4],dot:[2,3],long:[14,4],mixed:[8,3,2,3]},Ue=class{films;active;look;box;range;heights;picked;named;values;constructor({
key:e,title:t,unit:s,curves:n,limits:i,symmetric:a=!1},r){this.key=e,this.title=t,this.unit=s,this.curves=n,this.limits=i,this.symmetric=a,this.shared=r,this.canvas=
d("canvas",{class:"plot-canvas"}),this.over=d("canvas",{class:"plot-canvas plot-over"}),this.keys=d("div",{class:"plot-keys"}),this.body=d("div",{class:"plot-bo\
dy",tabindex:"0",role:"img","aria-label":t},this.canvas,this.over),this.element=d("section",{class:"plot","data-plot":e},d("header",{},d("h3",{},t),this.keys),this.
body),this.body.addEventListener("pointerdown",l=>this.press(l)),this.pinched=Z(this.body,{zoom:(l,h)=>this.films&&this.zoomAbout(h?this.valueAt(h):this.middle(),
1/l),home:()=>this.zoomTo(null),keys:!0}),this.onseek=()=>{}}abscissa(e){return B[this.shared.axis].values(e)}fullRange(){if(this.shared.axis==="time")return[0,
Math.max(...this.films.map(s=>s.duration),1e-9)];let[e,t]=[1/0,-1/0];for(let s of this.films)for(let n of this.abscissa(s))n<e&&(e=n),n>t&&(t=n);return t>e?[e,t]:
[e-1,t+1]}draw(e,t,s,n){this.films=e,this.active=t,this.look=s;let{context:i,width:a,height:r}=D(this.canvas);this.box={width:a-X-fo,height:r-H-zl},i.clearRect(
0,0,a,r),this.range=this.shared.range??this.fullRange();let l=e.flatMap((h,c)=>this.shades(h,c).map((u,m)=>({...u,film:h,lane:c,number:m})));this.heights=this.limits??
this.findHeights(l),this.shared.axis==="time"&&this.bands(i,e[t],n),this.grid(i,s,a,r),i.save(),i.beginPath(),i.rect(X,H,this.box.width,this.box.height),i.clip();
for(let h of l)this.curve(i,h);if(e.length>1)for(let h of l)h.number===0&&this.letter(i,h);i.restore(),this.legend(this.shades(e[t],t),s.dark),this.describe(l)}shades(e,t){
let{dark:s}=this.look;if(this.films.length<2)return this.curves(e).map(i=>({...i,color:i.color&&it(i.color,s)}));let n=Object.keys(go);return this.curves(e).map(
(i,a)=>({...i,color:ie(t,s),dash:n[a%n.length]}))}x(e){return X+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return H+(1-(e-this.heights[0])/
(this.heights[1]-this.heights[0]))*this.box.height}findHeights(e){let t=[];for(let{film:c,values:u}of e){let m=this.abscissa(c);for(let p=0;p<u.length;p++)m[p]>=
this.range[0]&&m[p]<=this.range[1]&&Number.isFinite(u[p])&&t.push(u[p])}if(!t.length)return[0,1];let s=Float64Array.from(t).sort(),[n,i]=[s[0],s[s.length-1]],[a,
r]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],l=Math.max(r-a,1e-12);i>r+4*l&&(i=r+.6*l),n<a-4*l&&(n=a-.6*l),n=Math.min(n,0),i=Math.max(i,0),this.
symmetric&&([n,i]=[-Math.max(-n,i),Math.max(-n,i)]);let h=.06*(i-n)||1;return[n<0?n-h:n,i+h]}bands(e,t,s){for(let n of t.phases){let i=y(this.x(n.from),X,X+this.
box.width),a=y(this.x(n.to),X,X+this.box.width);a<=i||(e.fillStyle=nt(s.modes[n.mode],.14),e.fillRect(i,H,a-i,this.box.height))}}grid(e,t,s,n){e.font=`11px ${t.
font}`,e.strokeStyle=t.line,e.fillStyle=t.soft,e.lineWidth=1;let i=Math.max(this.box.height/28,4);for(;te(this.heights[0],this.heights[1],i).length<3&&i<12;)i+=
1;let a=U(this.heights[1]-this.heights[0],i);e.textAlign="right",e.textBaseline="middle";for(let m of te(this.heights[0],this.heights[1],i)){let p=Math.round(this.
y(m))+.5;e.globalAlpha=Math.abs(m)<1e-9*a?1:.55,e.beginPath(),e.moveTo(X,p),e.lineTo(s-fo,p),e.stroke(),e.globalAlpha=1,e.fillText(Y(m,a),X-6,p)}let r=this.box.
width/70,l=U(this.range[1]-this.range[0],r);e.textAlign="center",e.textBaseline="alphabetic";let{name:h,unit:c}=B[this.shared.axis],u=c?`${x(h)} [${c}]`:x(h);for(let m of te(
this.range[0],this.range[1],r)){let p=this.x(m);e.beginPath(),e.moveTo(p,H+this.box.height),e.lineTo(p,H+this.box.height+4),e.stroke(),e.fillText(Y(m,l),p,H+this.
box.height+15)}e.textAlign="right",e.fillText(u,s-fo,n-3),e.save(),e.translate(11,H+.5*this.box.height),e.rotate(-Math.PI/2),e.textAlign="center",e.fillText(x(this.
unit),0,0),e.restore()}curve(e,{film:t,color:s,dash:n,number:i}){e.strokeStyle=s??this.look.ink,e.lineWidth=1.8,e.setLineDash(go[n??"solid"]),e.beginPath();let a=!1;
for(let r of t.pieces()){let l=this.abscissa(r.film),{values:h}=this.curves(r.film)[i];for(let c=r.from;c<r.to;c++){if(!Number.isFinite(h[c])||!Number.isFinite(
l[c])){a=!1;continue}let u=this.x(l[c]),m=y(this.y(h[c]),-1e4,1e4);a?e.lineTo(u,m):e.moveTo(u,m),a=!0}}e.stroke(),e.setLineDash([])}letter(e,{film:t,lane:s,values:n,
color:i}){let a=this.abscissa(t),r=this.range[0]+(s?.84:.7)*(this.range[1]-this.range[0]),l=a.findIndex(u=>u>=r);if(l<0||!Number.isFinite(n[l]))return;let[h,c]=[
this.x(a[l]),y(this.y(n[l])-8,H+10,H+this.box.height-4)];e.font=`700 12px ${this.look.font}`,e.textAlign="center",e.lineWidth=4,e.strokeStyle=this.look.panel,e.
strokeText("AB"[s],h,c),e.fillStyle=i??this.look.ink,e.fillText("AB"[s],h,c)}legend(e,t){let s=e.map(n=>n.name+n.color+n.dash).join()+t;this.named!==s&&(this.named=
s,this.values=e.map(()=>d("span",{class:"value"})),this.keys.replaceChildren(...e.map((n,i)=>d("span",{class:"plot-key"},wo(n.color,n.dash),n.name," ",this.values[i]))))}describe(e){
let t=e.slice(0,6).map(({name:n,values:i,lane:a})=>{let[r,l]=[1/0,-1/0];for(let u of i)u<r&&(r=u),u>l&&(l=u);let h=this.films.length>1?`${"AB"[a]}: `:"",c={name:x(
n),low:_(r,3),high:_(l,3)};return l>=r?`${h}${x("{name} from {low} to {high}",c)}`:""}),s=x("Diagram: {title} in {unit}.",{title:x(this.title),unit:x(this.unit)});
this.body.setAttribute("aria-label",`${s} ${t.filter(Boolean).join("; ")}.`)}cursor(e){if(!this.films)return;let{context:t,width:s,height:n}=D(this.over);if(t.clearRect(
0,0,s,n),this.films.forEach((i,a)=>{let r=i.holding(e),l=r.at(e),h=r.index(l.t),c=Math.min(h+1,r.length-1),u=r.t[c]>r.t[h]?(l.t-r.t[h])/(r.t[c]-r.t[h]):0,m=this.
abscissa(r),p=this.x(m[h]+u*(m[c]-m[h])),w=p>=X-1&&p<=X+this.box.width+1;w&&(t.strokeStyle=this.look.soft,t.lineWidth=1,t.beginPath(),t.moveTo(p,H),t.lineTo(p,H+
this.box.height),t.stroke()),this.shades(r,a).forEach((b,g)=>{let f=b.values[c],k=Number.isFinite(f)?b.values[h]+u*(f-b.values[h]):b.values[h];a===this.active&&
this.values?.[g]&&(this.values[g].textContent=_(k,3));let T=this.y(k);!w||!(T>=H-1&&T<=H+this.box.height+1)||(t.fillStyle=b.color??this.look.ink,t.beginPath(),t.
arc(p,T,3.2,0,2*Math.PI),t.fill())})}),this.picked){let[i,a]=this.picked;t.fillStyle=nt("#0072B2",.2),t.fillRect(Math.min(i,a),H,Math.abs(a-i),this.box.height)}}valueAt(e){
let t=this.body.getBoundingClientRect(),s=y((e.clientX-t.left-X)/this.box.width,0,1);return this.range[0]+s*(this.range[1]-this.range[0])}press(e){if(!this.films)
return;let t=this.body.getBoundingClientRect(),s=e.clientX-t.left,n=this.valueAt(e),i=this.pinched(),a=r=>{if(i||=this.pinched(),i)return;let l=r.clientX-t.left;
this.picked=e.pointerType==="mouse"&&Math.abs(l-s)>5?[s,l]:null,e.pointerType!=="mouse"&&this.seek(this.valueAt(r)),this.cursor(this.shared.clock.time)};W(this.
body,e,a,(r,l)=>{let h=this.valueAt(r),{picked:c}=this;this.picked=null,c&&l?this.zoomTo(n<h?[n,h]:[h,n]):c?this.cursor(this.shared.clock.time):l&&!i&&this.seek(
e.pointerType==="mouse"?n:h)})}seek(e){if(this.shared.axis==="time")return this.onseek(e);let t=this.films[this.active],s=this.abscissa(t),n=0;for(let i=0;i<s.length;i++)
Math.abs(s[i]-e)<Math.abs(s[n]-e)&&(n=i);return this.onseek(t.t[n])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(e,t){let s=this.fullRange(),n=Math.
max(e-(e-this.range[0])*t,s[0]),i=Math.min(e+(this.range[1]-e)*t,s[1]);this.zoomTo(n<=s[0]&&i>=s[1]?null:[n,i])}zoomTo(e){this.shared.range=e&&e[1]-e[0]>1e-9?e:
null,this.shared.changed()}};function wo(o,e="solid"){let t=d("i",{class:"swatch","aria-hidden":"true"});if(t.style.borderTopColor=o??"var(--ink)",t.style.borderTopStyle=
{solid:"solid",dash:"dashed",dot:"dotted",long:"none",mixed:"none"}[e],e==="long"||e==="mixed"){let s=0,n=go[e].map((i,a)=>(s+=i,`${a%2?"transparent":o??"var(--\
ink)"} ${s-i}px ${s}px`));t.style.height="2.5px",t.style.width="28px",t.style.background=`repeating-linear-gradient(90deg, ${n.join(", ")})`}return t}var xe=52,Ni=10,j=8,Rl=30,Pl="RSKHM?",us=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(e,t,s){this.backend=
e,this.clock=t,this.colors=s,this.canvas=d("canvas",{class:"plot-canvas"}),this.over=d("canvas",{class:"plot-canvas plot-over"}),this.keys=d("div",{class:"plot-\
keys"}),this.body=d("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=d("section",{class:"phase"},d("header",{},d("h3",{},"Plane of θ and θ̇"),this.keys),this.body,d("p",{class:"hint"},
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox."," ",`Click to go there; ${Ke("")}.`)),this.body.addEventListener(
"pointerdown",n=>this.seek(n)),this.pinched=Z(this.body,{zoom:(n,i)=>this.box&&this.zoomAbout(i?this.point(i):this.middle(),1/n),home:()=>this.zoomTo(null),keys:!0}),
this.range=[0,2*Math.PI],this.asked="",this.soon=he(()=>this.sharpen(),140)}async fetch(e,t){let s=this.reach(),n=JSON.stringify([e.hoop,e.plane,s]);if(n!==this.
asked){let i=await this.painted(e,[0,2*Math.PI,-s,s],t);this.asked=n,this.pictures=[i],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.
pictures||!this.window)){this.sharpening?.abort(),this.sharpening=new AbortController;try{let e=await this.painted(this.films[this.active].scenario,[...this.range,
...this.window],this.sharpening.signal);this.pictures=[this.pictures[0],e],this.redraw()}catch(e){if(e.name!=="AbortError")throw e}}}async painted(e,t,s){let{header:n,
arrays:i}=await this.backend.call("regions",{scenario:e,window:t},s);return{window:n.window,paradox:i.paradox,picture:this.paint(i.modes,i.paradox.length)}}reach(){
return this.reached}findReach(){let e=0;for(let s of this.films??[]){let n=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();e=Math.max(
e,n[Math.floor(.99*(n.length-1))]??0)}let t=U(Math.max(e,1)*1.15,4);return Math.ceil(Math.max(e,1)*1.12/t)*t}zoomTo(e){this.range=e??[0,2*Math.PI],this.window=null,
this.pictures?.splice(1),this.redraw()}point(e){let t=this.body.getBoundingClientRect(),s=(e.clientX-t.left-xe)/this.box.width,n=1-(e.clientY-t.top-j)/this.box.
height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+n*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.
bottom()+this.top())]}zoomAbout([e,t],s){let n=Math.max(e-(e-this.range[0])*s,0),i=Math.min(e+(this.range[1]-e)*s,2*Math.PI),a=this.reach(),r=Math.max(t-(t-this.
bottom())*s,-a),l=Math.min(t+(this.top()-t)*s,a);this.range=[n,i],this.window=i-n<2*Math.PI-1e-9||l-r<2*a-1e-9?[r,l]:null,this.redraw(),this.soon()}bottom(){return this.
window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(e,t,s){this.films=
e,this.active=t,this.look=s,this.reached=this.findReach(),this.forwards=e.some(n=>n.columns.omega.some(i=>i>.3)),this.backwards=e.some(n=>n.columns.omega.some(i=>i<
-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(e){return xe+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return j+
(1-(e-this.bottom())/(this.top()-this.bottom()))*this.box.height}paint(e,t){let s=e.length/t,{modes:n}=this.colors,i=d("canvas",{width:t,height:s}),a=new ImageData(
t,s);for(let r=0;r<s;r++)for(let l=0;l<t;l++){let h=Pl[e[r*t+l]],c=ue(n[h]??"#6E6E6E"),u=4*((s-1-r)*t+l);a.data.set([...c,255],u)}return pe(i).putImageData(a,0,
0),i}redraw(){if(!this.films)return;let{colors:e,look:t}=this,{context:s,width:n,height:i}=D(this.canvas);if(this.box={width:n-xe-Ni,height:i-j-Rl},s.clearRect(
0,0,n,i),s.save(),s.beginPath(),s.rect(xe,j,this.box.width,this.box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:a,window:r}of this.
pictures){let[l,h,c,u]=r,m=[this.x(l),this.y(u),this.x(h)-this.x(l),this.y(c)-this.y(u)];s.fillStyle=t.panel,s.fillRect(m[0],m[1],m[2],m[3]),s.globalAlpha=.35,s.
drawImage(a,m[0],m[1],m[2],m[3]),s.globalAlpha=1}this.hatch(s)}for(let[a,r]of this.films.entries())this.way(s,r,a);if(s.restore(),this.axes(s,n,i),this.keyed!==
t.dark){this.keyed=t.dark;let a=Object.entries(e.mode_names).filter(([r])=>"RSKH".includes(r));this.keys.replaceChildren(...a.map(([r,l])=>d("span",{class:"plot\
-key"},wo(e.modes[r]),l)))}this.cursor(this.clock.time)}hatch(e){let{paradox:t}=this.pictures[0],s=t.length;e.strokeStyle=nt(this.look.dark?"#ffffff":"#000000",
.28),e.lineWidth=1;for(let n=0;n<s;n++){if(!t[n])continue;let i=n;for(;i<s&&t[i]===t[n];)i++;let a=this.x(n*2*Math.PI/s),r=this.x(i*2*Math.PI/s);e.save(),e.beginPath(),
e.rect(a,j,r-a,this.box.height),e.clip(),e.beginPath();let l=t[n];for(let h=-this.box.height;h<r-a+this.box.height;h+=7)e.moveTo(a+h,l>0?j+this.box.height:j),e.
lineTo(a+h+this.box.height,l>0?j:j+this.box.height);e.stroke(),e.restore(),n=i}}way(e,t,s){let{angle:n,omega:i,mode:a}=t.columns,r=2*Math.PI;e.lineWidth=s?1.2:1.8,
e.setLineDash(s?[4,3]:[]),e.strokeStyle=this.films.length>1?ie(s,this.look.dark):this.look.ink,e.beginPath();let l=null;for(let h=0;h<t.length;h++){if(!Number.isFinite(
i[h])){l=null;continue}let c=Math.floor(n[h]/r),u=n[h]-c*r;if(l===null)e.moveTo(this.x(u),this.y(i[h]));else if(c!==l.lap){let m=c>l.lap?r:0;e.lineTo(this.x(m),
this.y(i[h])),e.moveTo(this.x(r-m),this.y(i[h])),e.lineTo(this.x(u),this.y(i[h]))}else e.lineTo(this.x(u),this.y(i[h]));l={lap:c,mode:a[h]}}e.stroke(),e.setLineDash(
[])}axes(e,t,s){let{look:n}=this;e.font=`11px ${n.font}`,e.strokeStyle=n.soft,e.fillStyle=n.soft,e.lineWidth=1,e.strokeRect(xe+.5,j+.5,this.box.width-1,this.box.
height-1),e.textAlign="center";let i=this.range[0]*180/Math.PI,a=this.range[1]*180/Math.PI,r=a-i>200?45:U(a-i,6);for(let h=Math.ceil(i/r-1e-9);h*r<=a+1e-9;h++){
let c=this.x(h*r*Math.PI/180);e.beginPath(),e.moveTo(c,j+this.box.height),e.lineTo(c,j+this.box.height+4),e.stroke(),e.fillText(Y(h*r,r),c,j+this.box.height+15)}
e.textAlign="right",e.fillText(x("angle θ within a turn [°]"),t-Ni,s-3),e.textBaseline="middle";let l=this.top()-this.bottom();for(let h of te(this.bottom(),this.
top(),5))e.fillText(Y(h,U(l,5)),xe-6,this.y(h));e.textBaseline="alphabetic",e.save(),e.translate(11,j+.5*this.box.height),e.rotate(-Math.PI/2),e.textAlign="cent\
er",e.fillText("θ̇ [rad/s]",0,0),e.restore()}cursor(e){if(!this.films||!this.box)return;let{context:t,width:s,height:n}=D(this.over);t.clearRect(0,0,s,n),this.
films.forEach((i,a)=>{let r=i.at(e),l=2*Math.PI,h=r.angle-Math.floor(r.angle/l)*l,c=this.x(h),u=this.y(r.omega);c>=xe&&c<=xe+this.box.width&&u>=j&&u<=j+this.box.
height&&(t.beginPath(),t.arc(c,u,a?4:5.5,0,2*Math.PI),t.fillStyle=this.colors.modes[r.mode],t.fill(),t.lineWidth=2,t.strokeStyle=this.films.length>1?ie(a,this.look.
dark):this.look.ink,t.stroke(),!(this.films.length<2)&&(t.font=`700 12px ${this.look.font}`,t.textAlign="left",t.fillStyle=t.strokeStyle,t.fillText("AB"[a],c+8,
u-6)))})}seek(e){let t=this.body.getBoundingClientRect(),[s,n]=[e.clientX-t.left,e.clientY-t.top];if(this.pinched())return;let i=this.films[this.active],{angle:a,
omega:r}=i.columns,l=2*Math.PI,h={distance:1/0,t:0};for(let c=0;c<i.length;c++){let u=a[c]-Math.floor(a[c]/l)*l,m=Math.hypot(this.x(u)-s,this.y(r[c])-n);m<h.distance&&
(h={distance:m,t:i.t[c]})}h.distance<40&&this.clock.seek(y(h.t,0,i.duration))}};var bo=o=>Object.entries(B).map(([e,t])=>d("option",{value:e},o(t)));function qi(o){let e="height",t=new Ue({key:"own",title:"Your choice",unit:"",curves:i=>[{name:x(
B[e].name),values:B[e].values(i)}]},o),s=()=>{let{symbol:i,unit:a}=B[e];t.unit=a?`${i} [${a}]`:i},n=d("select",{"aria-label":"What your diagram shows",onchange:()=>{
e=n.value,s(),o.changed()}},bo(ci));return n.value=e,s(),t.element.querySelector("h3")?.after(n),t}function Il(o){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:e=>[{name:"v (centre)",color:o.center_speed,values:e.columns.vx},{name:"\
R θ̇",color:o.rotation_speed,dash:"dash",values:e.derived("spin",({omega:t})=>Float64Array.from(t,s=>s*e.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:e=>[{name:"kinetic",color:o.kinetic,values:e.columns.kinetic},{name:"potential",color:o.potential,values:e.columns.potential},{name:"\
total",values:e.derived("total",({t,kinetic:s,potential:n})=>Float64Array.from(t,(i,a)=>s[a]+n[a])),dash:"dash"},{name:"lost to friction",color:o.friction_loss,
values:e.columns.friction_loss},{name:e.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:o.impact_loss,values:e.columns.
normal_loss,dash:"dot"},...e.scenario.plane.rolling_resistance?[{name:"lost to rolling resistance",values:e.columns.rolling_resistance,dash:"dot"}]:[]]},{key:"f\
orces",title:"Contact forces",unit:"force [N]",curves:e=>[{name:"normal N",color:o.normal_force,values:e.columns.normal_force},{name:"friction F",color:o.friction_force,
dash:"dash",values:e.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],curves:e=>[{name:"|F| / μN",color:o.
friction_force,values:e.columns.utilization}]}]}var ms=class{films;active;look;constructor(e,t){this.colors=t,this.shared={axis:"time",range:null,clock:e,changed:()=>this.
redraw()},this.plots=[...Il(t).map(n=>new Ue(n,this.shared)),qi(this.shared)];for(let n of this.plots)n.onseek=i=>e.seek(i);this.seen=new Map(this.plots.map(n=>[
n.element,!0]));let s=new IntersectionObserver(n=>{for(let{target:i,isIntersecting:a}of n)this.seen.set(i,a);this.redraw()},{rootMargin:"400px"});for(let n of this.
plots)s.observe(n.element);this.axis=d("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=
null,this.redraw()}},bo(({name:n})=>`over ${n}`)),this.back=d("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=
d("span",{class:"hint"}),this.element=d("div",{class:"plots"},d("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(n=>n.element))}draw(e,t,s){
this.films=e,this.active=t,this.look=s;let n=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":`click to go there, drag to zoom; ${Ke("")}`,
i=e.length>1;M(this.hint,i?`A blue, B ochre; the dashes tell the quantities; numbers of ${"AB"[t]}; ${n}`:n),this.redraw()}redraw(){if(this.films?.length){this.
back.hidden=!this.shared.range;for(let e of this.visible())e.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.
plots.filter(e=>this.seen.get(e.element))}cursor(e){for(let t of this.visible())t.cursor(e)}};var Ll=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],ps=class{constructor(e){this.lab=e,this.menu=d("details",{class:"menu"},d("summary",{class:"button"},"Keep"),d("div",{class:"menu-body"},e.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),Ll.filter(([t])=>e.backend.files?.includes(t)??!0).map(([t,s])=>this.item(s,()=>this.download(t))),this.item("Pic\
ture (PNG)",()=>this.picture()),this.item("Record a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=d("dialog",
{class:"code-dialog","aria-label":"The same motion in Python"}),e.root.addEventListener("pointerdown",t=>{this.menu.contains(t.target)||(this.menu.open=!1)})}item(e,t){
return d("button",{type:"button",onclick:async()=>{this.menu.open=!1;try{await t()}catch(s){this.lab.notice.fail(s)}}},e)}async copyLink(){let e=this.lab.link()??
"";try{await navigator.clipboard.writeText(e),this.lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",e)}}async download(e){let t=this.
lab.film();this.lab.notice.say(e.endsWith("mp4")?"The film is being made; this takes a while …":`Fetching ${e} …`),$e(await this.lab.backend.file(e,t.query),
`hophoop-${e}`),this.lab.notice.say(`${e} is there.`)}picture(){this.lab.drawStage();let e=this.lab.stage.canvas(),t=d("canvas",{width:e.width,height:e.height});
return this.copyInto(t),new Promise(s=>{t.toBlob(n=>{n&&$e(n,"hophoop.png"),s()},"image/png")})}copyInto(e){let{lab:t}=this,s=t.stage.canvas(),n=pe(e);n.fillStyle=
t.theme.look.paper,n.fillRect(0,0,e.width,e.height),n.drawImage(s,0,0,e.width,e.height);let i=e.width/Math.max(s.getBoundingClientRect().width,1);n.textBaseline=
"top",n.textAlign="left";let a=t.films();for(let[r,l]of a.entries()){let h=l.at(t.clock.time),c=[a.length>1?`${"AB"[r]}: `:"",`${x(t.theme.colors.mode_names[h.mode])}\
, t = ${h.t.toFixed(3)} s, θ = ${q(h.angle)}, v = ${_(h.vx,3)} m/s`].join(""),u=t.stage.options.three?10+20*r:10+r*s.getBoundingClientRect().height/a.length;n.
fillStyle=t.theme.colors.modes[h.mode],n.fillRect(12*i,(u+2)*i,11*i,11*i),n.fillStyle=t.theme.look.ink,n.font=`${13*i}px ${t.theme.look.font}`,n.fillText(c,30*i,
u*i)}}async record(){let{lab:e}=this,t=e.stage.canvas();if(!t.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; tak\
e the MP4 instead.");let s=d("canvas",{width:2*Math.ceil(t.width/2),height:2*Math.ceil(t.height/2)}),n=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),
i=[];n.ondataavailable=l=>i.push(l.data);let a=new Promise(l=>n.onstop=l),r=e.clock.loop;e.clock.loop=!1,e.clock.seek(0),e.notice.say("Recording one run …"),e.
afterFrame=()=>{this.copyInto(s),!e.clock.playing&&n.state==="recording"&&n.stop()},n.start(),e.clock.play(!0),await a,e.afterFrame=null,e.clock.loop=r,$e(new Blob(
i,{type:n.mimeType}),"hophoop.webm"),e.notice.say("The film is there.")}async code(){let{header:e}=await this.lab.backend.call("code",{scenario:this.lab.film().
scenario});this.show("The same motion in Python",e.python,"The scenario as a file",e.toml)}show(...e){let t=[];for(let s=0;s<e.length;s+=2){let n=e[s+1],i=d("bu\
tton",{type:"button"},"Copy");i.onclick=async()=>{await navigator.clipboard?.writeText(n).catch(()=>{}),M(i,"Copied")},t.push(d("header",{},d("h2",{},e[s]),i),d(
"pre",{tabindex:"0"},d("code",{},document.createTextNode(n))))}this.dialog.replaceChildren(...t,d("button",{type:"button",class:"close",onclick:()=>this.dialog.
close()},"Close")),this.dialog.showModal()}};function ji(o,e){let t=d("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([n])=>{let i=!n.isIntersecting&&n.boundingClientRect.top<0;if(i===
o.classList.contains("stuck"))return;let a=o.offsetHeight;o.style.marginBottom="",o.classList.toggle("stuck",i),i&&(o.style.marginBottom=`${a-o.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=i?`${o.offsetHeight}px`:"",e()});return s.observe(t),{edge:t,close:()=>s.disconnect()}}var Ci=120,fs=class{constructor(e,t){this.canvas=e,this.onview=t,this.zoom=1,this.shift=[0,0],this.views=[],this.fixed=null,this.grab=()=>!1,e.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=Z(e,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>e.parentElement})}reset(){this.zoom=1,this.shift=[0,0],
this.onview()}zoomBy(e){this.zoom=y(this.zoom*e,.05,60),this.onview()}drag(e){if(this.grab(e))return;let t=[e.clientX,e.clientY],s=this.shift;W(this.canvas,e,n=>{
this.pinched()||(this.shift=[s[0]+n.clientX-t[0],s[1]+n.clientY-t[1]],this.onview())})}draw(e,t,s,n,i){let{context:a,width:r,height:l}=D(this.canvas);if(a.clearRect(
0,0,r,l),r<40||l<40)return;let h=l/e.length,c={top:Math.max(...e.map(u=>u.extent.top)),radius:Math.max(...e.map(u=>u.radius)),speed:Math.max(...e.map(u=>u.extent.
speed))};e.forEach((u,m)=>{a.save(),a.beginPath(),a.rect(0,m*h,r,h),a.clip(),a.translate(0,m*h);let p=new yo(a,r,h,u,t,s,n,i,this.zoom,this.shift,c);p.top=m*h,p.
scale=this.fixed??p.scale,p.draw(),this.views[m]=p,e.length>1&&(p.mark("AB"[m],ie(m,n.dark)),a.fillStyle=ie(m,n.dark),a.font=`700 17px ${n.font}`,a.textAlign="l\
eft",a.fillText("AB"[m],12,h-12)),a.restore(),m>0&&(a.fillStyle=n.line,a.fillRect(0,m*h-.5,r,1))})}},yo=class{top=0;constructor(e,t,s,n,i,a,r,l,h,c,u){this.context=
e,this.width=t,this.height=s,this.film=n,this.options=a,this.look=r,this.colors=l,this.common=u,this.pose=n.at(i);let m=n.radius,{left:p,right:w}=n.extent,{top:b}=u;
this.cosine=Math.cos(n.slope),this.sine=Math.sin(n.slope);let g=2*u.radius+Math.min(b,6*u.radius),f=Math.min(.66*s/g,.36*t/u.radius);if(a.whole){let k=(w-p)*this.
cosine+2.6*m,T=(w-p)*Math.abs(this.sine)+2.6*m+b;this.scale=Math.min(t/k,.86*s/T,f)*h,this.focus=[.5*(p+w),0],this.place=[.5*t+c[0],(n.slope?.62:.8)*s+c[1]]}else
this.scale=f*h,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.place=[(t<520?.6:.46)*t+c[0],.82*s+c[1]]}point(e,t){let s=e-this.focus[0],n=t-this.
focus[1];return[this.place[0]+this.scale*(s*this.cosine+n*this.sine),this.place[1]-this.scale*(n*this.cosine-s*this.sine)]}unpoint(e,t){let s=(e-this.place[0])/
this.scale,n=-(t-this.place[1])/this.scale;return[this.focus[0]+s*this.cosine-n*this.sine,this.focus[1]+s*this.sine+n*this.cosine]}draw(){this.ground(),(this.options.
traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&this.forces()}ground(){let{context:e,look:t,width:s,height:n}=this,i=(Math.hypot(s,n)*
1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[a,r]=this.point(this.focus[0]-i,0),[l,h]=this.point(this.focus[0]+i,0),c=[-this.sine*4e3,this.cosine*
4e3];e.fillStyle=t.ground,e.beginPath(),e.moveTo(a,r),e.lineTo(l,h),e.lineTo(l+c[0],h+c[1]),e.lineTo(a+c[0],r+c[1]),e.fill(),e.strokeStyle=t.soft,e.lineWidth=1.5,
e.beginPath(),e.moveTo(a,r),e.lineTo(l,h),e.stroke();let u=U(s/this.scale,s/90);e.fillStyle=t.soft,e.font=`11px ${t.font}`,e.textAlign="center",e.lineWidth=1;let m=Math.
ceil((this.focus[0]-i)/u),p=Math.min(Math.floor((this.focus[0]+i)/u),m+400);for(let w=m;w<=p;w++){let[b,g]=this.point(w*u,0);b<-40||b>s+40||(e.beginPath(),e.moveTo(
b,g),e.lineTo(b-6*this.sine,g+6*this.cosine),e.stroke(),e.fillText(`${Y(w*u,u)} m`,b-18*this.sine,g+8+10*this.cosine))}}traces(){let{film:e,context:t,look:s,colors:n}=this,
i=e.radius,a=this.options.ahead?e.duration:this.pose.t,r=(l,h,c,u)=>{t.strokeStyle=h,t.lineWidth=c,t.lineJoin="round",t.beginPath();let m=!1,p=(w,b,g)=>{let[f,k]=this.
point(w+l*Math.sin(g),i+b+l*Math.cos(g));m?t.lineTo(f,k):t.moveTo(f,k),m=!0};for(let w of e.pieces()){let{x:b,height:g,angle:f,mode:k}=w.film.columns;for(let T=w.
from;T<w.to&&w.film.t[T]<=a;T++)u===void 0||k[T]===3===u?p(b[T],g[T],f[T]):m=!1}!this.options.ahead&&(u===void 0||this.pose.mode==="H"===u)&&p(this.pose.x,this.
pose.height,this.pose.angle),t.stroke()};t.globalAlpha=this.options.ahead?.45:1,r(i,s.ink,1.3),r(e.eccentricity*i,n.gravity_center,1.8,!1),r(e.eccentricity*i,n.
airborne,2.4,!0),t.globalAlpha=1}mark(e,t){let{context:s,film:n,pose:i,scale:a}=this,[r,l]=this.point(i.x,n.radius+i.height);s.strokeStyle=t,s.lineWidth=3,s.beginPath(),
s.arc(r,l,Math.max(n.radius*a-y(.07*n.radius*a,2,14)-3,2),0,2*Math.PI),s.stroke(),s.fillStyle=t,s.font=`700 17px ${this.look.font}`,s.textAlign="center",s.fillText(
e,r-14,l+20)}hoop(){let{film:e,pose:t,context:s,look:n,colors:i,scale:a}=this,r=e.radius,l=y(.07*r*a,2,14),h=r-.5*l/a,c=[t.x,r+t.height],u=(g,f=h)=>this.point(c[0]+
f*Math.sin(g),c[1]+f*Math.cos(g));if(s.lineCap="butt",n.dark&&(s.strokeStyle=n.soft,s.lineWidth=l+2,s.beginPath(),s.arc(...this.point(c[0],c[1]),h*a,0,2*Math.PI),
s.stroke()),this.options.speed){let g=this.common.speed;s.lineWidth=l;let f=2*Math.PI/Ci;for(let k=0;k<Ci;k++){let T=t.angle+k*f,E=Math.hypot(t.vx+r*t.omega*Math.
cos(T+.5*f),t.vy-r*t.omega*Math.sin(T+.5*f));s.strokeStyle=qt[y(Math.round(255*E/g)||0,0,255)],s.beginPath(),s.moveTo(...u(T-.04*f)),s.lineTo(...u(T+1.04*f)),s.
stroke()}}else s.strokeStyle=i.modes[t.mode],s.lineWidth=l,s.beginPath(),s.arc(...this.point(c[0],c[1]),h*a,0,2*Math.PI),s.stroke();s.strokeStyle=n.soft,s.lineWidth=
1,s.beginPath(),s.moveTo(...this.point(c[0],c[1])),s.lineTo(...u(t.angle)),s.stroke();let m=(g,f,k,T)=>{s.beginPath(),s.arc(...g,f,0,2*Math.PI),s.fillStyle=k,s.
fill(),s.lineWidth=1.5,s.strokeStyle=T,s.stroke()};m(this.point(c[0],c[1]),2.5,n.soft,n.soft);let p=e.scenario.hoop.parts;p?this.parts(p,c):m(u(t.angle),y(.1*r*
a,4,16),n.ink,n.paper);let w=e.eccentricity*r,b=this.point(c[0]+w*Math.sin(t.angle),c[1]+w*Math.cos(t.angle));m(b,y(.05*r*a,3.5,7),t.mode==="H"?i.airborne:i.gravity_center,
n.paper)}parts(e,t){let{film:s,pose:n,context:i,look:a,scale:r}=this,h=e.reduce((c,u)=>c+u.mass*(u.at??0),0)<0?-1:1;i.strokeStyle=a.ink;for(let c of e){let u=h*
(c.at??0),m=this.point(t[0]+u*Math.sin(n.angle),t[1]+u*Math.cos(n.angle));if(i.fillStyle=a.ink,i.lineWidth=1,i.beginPath(),c.shape==="ring")i.globalAlpha=.22,i.
arc(...m,c.outer_radius*r,0,2*Math.PI),i.arc(...m,c.inner_radius*r,0,2*Math.PI,!0),i.fill(),i.globalAlpha=1;else if(c.shape==="rod"){let p=.5*c.length,w=b=>this.
point(t[0]+b*Math.sin(n.angle),t[1]+b*Math.cos(n.angle));i.lineWidth=4,i.moveTo(...w(u-p)),i.lineTo(...w(u+p)),i.stroke()}else{let p=c.shape==="disk"?c.radius*r:
y(.08*s.radius*r,3,12);i.globalAlpha=c.shape==="disk"?.55:1,i.arc(...m,p,0,2*Math.PI),i.fill(),i.globalAlpha=1}}}forces(){let{film:e,pose:t,colors:s}=this,n=e.radius,
i=e.mass*(e.gravity||9.81),a=l=>.55*n*l/i;if(t.mode==="H"||!(t.normal_force>0))return;let r=[t.x,t.height];this.arrow(r,[0,a(t.normal_force)],s.normal_force,`N \
= ${_(t.normal_force,3)} N`,!1),this.arrow(r,[a(t.friction_force),0],s.friction_force,`F = ${_(t.friction_force,3)} N`,!0)}arrow([e,t],[s,n],i,a,r){let{context:l,
look:h,width:c}=this,u=2.2*this.film.radius,m=Math.abs(s)>u||Math.abs(n)>u;[s,n]=[y(s,-u,u),y(n,-u,u)];let p=this.point(e,t),w=this.point(e+s,t+n),b=Math.hypot(
w[0]-p[0],w[1]-p[1]);if(b<2)return;let g=(w[0]-p[0])/b,f=(w[1]-p[1])/b,k=Math.min(11,b);for(let[N,I]of[[h.paper,6],[i,3]])l.strokeStyle=N,l.fillStyle=N,l.lineWidth=
I,l.beginPath(),l.moveTo(...p),l.lineTo(w[0]-g*k,w[1]-f*k),l.stroke();if(l.beginPath(),l.moveTo(...w),l.lineTo(w[0]-g*k-f*k*.5,w[1]-f*k+g*k*.5),l.lineTo(w[0]-g*
k+f*k*.5,w[1]-f*k-g*k*.5),l.fill(),m){let[N,I]=[p[0]+.55*g*b,p[1]+.55*f*b];l.strokeStyle=h.paper,l.lineWidth=2,l.beginPath();for(let z of[-3,3])l.moveTo(N+g*(z-
3)-f*7,I+f*(z-3)+g*7),l.lineTo(N+g*(z+3)+f*7,I+f*(z+3)-g*7);l.stroke()}l.font=`600 12px ${h.font}`;let T=l.measureText(a).width;l.lineWidth=3,l.strokeStyle=r?h.
ground:h.paper,l.textAlign="left";let E=r?[p[0]-.5*T-32*this.sine,p[1]+32*this.cosine]:[w[0]+12,y(w[1]+4,16,p[1]-.36*this.film.radius*this.scale)];E[0]=y(E[0],4,
c-T-4),l.strokeText(a,E[0],E[1]),l.fillText(a,E[0],E[1])}};function ko(o,e){let t=new Float32Array(16);for(let s=0;s<4;s++)for(let n=0;n<4;n++){let i=0;for(let a=0;a<4;a++)i+=o[4*a+n]*e[4*s+a];t[4*s+n]=i}return t}function Oi(o,e,t,s){
let n=1/Math.tan(o/2),i=1/(t-s);return new Float32Array([n/e,0,0,0,0,n,0,0,0,0,(s+t)*i,-1,0,0,2*s*t*i,0])}function Di(o,e){let t=Pe(xo(o,e)),s=Pe(gs([0,1,0],t)),
n=gs(t,s);return new Float32Array([s[0],n[0],t[0],0,s[1],n[1],t[1],0,s[2],n[2],t[2],0,-vo(s,o),-vo(n,o),-vo(t,o),1])}var xo=(o,e)=>[o[0]-e[0],o[1]-e[1],o[2]-e[2]],
vo=(o,e)=>o[0]*e[0]+o[1]*e[1]+o[2]*e[2],gs=(o,e)=>[o[1]*e[2]-o[2]*e[1],o[2]*e[0]-o[0]*e[2],o[0]*e[1]-o[1]*e[0]];function Pe(o){let e=Math.hypot(...o)||1;return[
o[0]/e,o[1]/e,o[2]/e]}function ws(o,e,t,s){let n=Pe(e),i=Pe(gs(n,Math.abs(n[2])>.9?[1,0,0]:[0,0,1])),a=gs(i,n);return new Float32Array([...i.map(r=>r*s),0,...n.
map(r=>r*t),0,...a.map(r=>r*s),0,...o,1])}function _o(o){let[e,t]=[Math.cos(o),Math.sin(o)];return new Float32Array([e,-t,0,0,t,e,0,0,0,0,1,0,0,0,0,1])}function se(o){let e=Number.parseInt(o.slice(1,7),
16);return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}function Ge(o,e,t){let s=o.createProgram(),n=[[o.VERTEX_SHADER,e],[o.FRAGMENT_SHADER,t]];for(let[a,r]of n){let l=o.createShader(a);if(o.shaderSource(l,r),o.compileShader(
l),!o.getShaderParameter(l,o.COMPILE_STATUS))throw new Error(String(o.getShaderInfoLog(l)));o.attachShader(s,l)}if(o.linkProgram(s),!o.getProgramParameter(s,o.LINK_STATUS))
throw new Error(String(o.getProgramInfoLog(s)));let i={program:s,uniforms:{},attributes:{}};for(let a=0;a<o.getProgramParameter(s,o.ACTIVE_UNIFORMS);a++){let{name:r}=o.
getActiveUniform(s,a);i.uniforms[r]=o.getUniformLocation(s,r)}for(let a=0;a<o.getProgramParameter(s,o.ACTIVE_ATTRIBUTES);a++){let{name:r}=o.getActiveAttrib(s,a);
i.attributes[r]=o.getAttribLocation(s,r)}return i}function Ie(o,e,t,s){let n=o.createBuffer();o.bindBuffer(o.ARRAY_BUFFER,n),o.bufferData(o.ARRAY_BUFFER,new Float32Array(
e),o.STATIC_DRAW);let i=s?o.createBuffer():null;s&&(o.bindBuffer(o.ELEMENT_ARRAY_BUFFER,i),o.bufferData(o.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),o.STATIC_DRAW));
let a=4*Object.values(t).reduce((r,l)=>r+l,0);return{vertices:n,elements:i,parts:t,stride:a,count:s?s.length:4*e.length/a}}function Ve(o,e,t){o.bindBuffer(o.ARRAY_BUFFER,
t.vertices);let s=0;for(let[n,i]of Object.entries(t.parts)){let a=e.attributes[n];a!==void 0&&(o.enableVertexAttribArray(a),o.vertexAttribPointer(a,i,o.FLOAT,!1,
t.stride,s)),s+=4*i}t.elements&&o.bindBuffer(o.ELEMENT_ARRAY_BUFFER,t.elements)}function To(o,e){let t=[];for(let s=0;s<o;s++)for(let n=0;n<e;n++){let i=s*(e+1)+
n,a=i+e+1;t.push(i,a,i+1,a,a+1,i+1)}return t}function Fi(o,e=120,t=14){let s=[];for(let n=0;n<=e;n++)for(let i=0;i<=t;i++)s.push(2*Math.PI*n/e,2*Math.PI*i/t);return Ie(
o,s,{bend:2},To(e,t))}function Wi(o,e=28,t=18){let s=[];for(let n=0;n<=e;n++)for(let i=0;i<=t;i++){let[a,r]=[2*Math.PI*n/e,Math.PI*i/t],l=[Math.sin(r)*Math.cos(
a),Math.cos(r),Math.sin(r)*Math.sin(a)];s.push(...l,...l)}return Ie(o,s,{position:3,normal:3},To(e,t))}function So(o,e,t=20){let s=[];for(let n=0;n<=t;n++){let i=2*
Math.PI*n/t,a=[Math.cos(i),1-e,Math.sin(i)];s.push(Math.cos(i),0,Math.sin(i),...a,e*Math.cos(i),1,e*Math.sin(i),...a)}return Ie(o,s,{position:3,normal:3},To(t,1))}var Ki=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Ui=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Gi="vec4(0.0, 0.0, 0.0, shadow)",$i=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Ui}
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
   ${Ki}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Gi} : vec4(shaded(color, n), 1.0);
   }`],Bi=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Ui}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${Ki}
   void main() { gl_FragColor = shadow > 0.0 ? ${Gi} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],Hi=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],bs=class{constructor(e,t,s,n,{keep:i=!1}={}){let a=e.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:i});if(!a)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=a,this.canvas=
e,this.sun=Pe(s),this.dark=n,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=Ge(a,$i[0],$i[1]),this.body=Ge(a,Bi[0],Bi[1]),this.line=Ge(a,Hi[0],Hi[1]),this.torus=Fi(
a),this.sphere=Wi(a),this.cylinder=So(a,1),this.cone=So(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.colors);let r=new Uint8Array(t.flatMap(
l=>[...l,255]));a.pixelStorei(a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,t.length,1,0,a.RGBA,a.UNSIGNED_BYTE,r);for(let l of[a.TEXTURE_WRAP_S,a.TEXTURE_WRAP_T])
a.texParameteri(a.TEXTURE_2D,l,a.CLAMP_TO_EDGE);for(let l of[a.TEXTURE_MIN_FILTER,a.TEXTURE_MAG_FILTER])a.texParameteri(a.TEXTURE_2D,l,a.LINEAR);this.view=_o(0),
this.eye=[0,0,1],this.fastest=1}begin({background:e,eye:t,target:s,slope:n,angle:i,near:a,far:r}){let{gl:l,canvas:h}=this;l.viewport(0,0,h.width,h.height),l.clearColor(
e[0],e[1],e[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let c=Oi(i,h.width/h.height,a,r);this.view=ko(ko(c,
Di(t,s)),_o(n)),this.eye=Pe(xo(t,s))}use(e,t){let{gl:s}=this;s.useProgram(e.program);let n={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...t};for(let[
i,a]of Object.entries(n)){let r=e.uniforms[i];r!==void 0&&(typeof a=="number"?s.uniform1f(r,a):a.length===16?s.uniformMatrix4fv(r,!1,a):s[`uniform${a.length}fv`](
r,a))}}ground(e){let{gl:t}=this;t.depthFunc(t.ALWAYS),e(),t.depthFunc(t.LESS)}shadows(e){let{gl:t}=this;t.enable(t.BLEND),t.blendFuncSeparate(t.SRC_ALPHA,t.ONE_MINUS_SRC_ALPHA,
t.ZERO,t.ONE),t.enable(t.STENCIL_TEST),t.stencilFunc(t.EQUAL,0,255),t.stencilOp(t.KEEP,t.KEEP,t.INCR),t.depthFunc(t.ALWAYS),t.depthMask(!1),e(),t.depthMask(!0),
t.depthFunc(t.LESS),t.disable(t.STENCIL_TEST),t.disable(t.BLEND)}solid(e,t,s,{shadow:n=!1,lit:i=!0}={}){let{gl:a}=this;this.use(this.body,{model:t,color:s,shadow:n?
this.dark:0,lit:Number(i)}),Ve(a,this.body,e),a.drawElements(a.TRIANGLES,e.count,a.UNSIGNED_SHORT,0)}ball(e,t,s,n){this.solid(this.sphere,ws(e,[0,1,0],t,t),s,{shadow:n})}ring({
center:e,radius:t,tube:s,broad:n,angle:i,velocity:a,omega:r,plain:l=null},h){let{gl:c}=this;this.use(this.rim,{center:e,size:[t,s,n,i],motion:[...a,r],most:this.
fastest,shadow:h?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),Ve(c,this.rim,this.torus),c.drawElements(c.TRIANGLES,this.torus.count,c.UNSIGNED_SHORT,0)}rod(e,t,s,n,i,a=!1){
this.solid(this.cylinder,ws(e,t,s,n),i,{shadow:a})}arrow(e,t,s,n,i){if(!(s>.02*n))return;let a=Math.min(.18*n,s),r=e.map((l,h)=>l+t[h]*(s-a));s>a&&this.rod(e,t,
s-a,.029*n,i),this.solid(this.cone,ws(r,t,a,Math.min(.075*n,.6*a)),i)}trace(e,t,s){let n=[];for(let i=0;i<e;i++){let a=t(i),r=t(Math.min(i+1,e-1));if(Math.hypot(
r[0]-a[0],r[1]-a[1])<1e-9&&i>0){let l=t(i-1);r=a.map((h,c)=>2*h-l[c])}for(let l of[-1,1])n.push(...a,0,...r,0,...s(i),l)}return Ie(this.gl,n,{position:3,next:3,
tint:3,side:1})}drawTrace(e,t,{width:s,distance:n=0,shift:i,depth:a}){let{gl:r,canvas:l}=this;this.use(this.line,{pixel:[2/l.width,2/l.height],width:s,distance:n,
shift:i,depth:a}),Ve(r,this.line,e),r.drawArrays(r.TRIANGLE_STRIP,0,2*t)}onScreen([e,t,s]){let n=this.view,[i,a,r]=[0,1,3].map(l=>n[l]*e+n[4+l]*t+n[8+l]*s+n[12+
l]);return r>0?[(.5+.5*i/r)*this.canvas.width,(.5-.5*a/r)*this.canvas.height]:null}};var Nl=[.35,.85,.4],ql=.18,Vi={azimuth:.5,height:.22,distance:5.2},Ji=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],ys=class{constructor(e,t){this.canvas=e,this.onview=t,this.space=new bs(e,We,Nl,ql,{keep:!0}),this.floor=Ge(this.space.gl,Ji[0],Ji[1]),this.corners=Ie(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...Vi},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,e.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=Z(e,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>e.parentElement})}zoomBy(e){e?this.turned.distance=y(
this.turned.distance/e,1.6,60):this.turned={...Vi},this.onview()}drag(e){let t={...this.turned,x:e.clientX,y:e.clientY};W(this.canvas,e,s=>{this.pinched()||(this.
turned.azimuth=y(t.azimuth-(s.clientX-t.x)*.008,-1.5,1.5),this.turned.height=y(t.height+(s.clientY-t.y)*.006,.02,1.45),this.onview())})}quality(){let e=performance.
now(),t=e-(this.before||e);return this.before=e,t>0&&t<200&&(this.pace=.9*this.pace+.1*t),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(e,t,s,n,i,a){let{canvas:r,space:l}=this,h=Math.min(globalThis.devicePixelRatio||1,2)*(a?this.quality():1),c=r.getBoundingClientRect();r.
width=Math.max(Math.round(c.width*h),1),r.height=Math.max(Math.round(c.height*h),1);let u=e.map(w=>w.at(t)),m=e[0].radius;l.fastest=Math.max(...e.map(w=>w.extent.
speed)),this.focus=Number.isFinite(u[0].x)?u[0].x:0,l.begin({background:se(n.paper),...this.camera(e[0],u[0],m,s)}),l.ground(()=>this.drawFloor(m,n));let p=w=>{
for(let[b,g]of e.entries())w(g,u[b],-2.1*m*b)};l.shadows(()=>p((w,b,g)=>this.drawHoop(w,b,g,s,n,i,!0))),p((w,b,g)=>{this.drawHoop(w,b,g,s,n,i,!1),s.traces&&this.
drawTraces(w,b,g,n,i,h),s.forces&&this.drawForces(w,b,g,i)})}camera(e,t,s,n){let{azimuth:i,height:a,distance:r}=this.turned,{left:l,right:h}=e.extent,c=n.whole?
Math.max(r*s,.85*(h-l)+3*s):r*s,[u,m]=[n.whole?.5*(l+h)-this.focus:0,s+.45*(t.height||0)],p=Math.cos(e.slope),w=Math.sin(e.slope),b=[u*p+m*w,-u*w+m*p,0],g=[b[0]+
c*Math.sin(i)*Math.cos(a),b[1]+c*Math.sin(a),c*Math.cos(i)*Math.cos(a)];return this.reach=12*s+3*c,{eye:g,target:b,slope:e.slope,angle:.75,near:.05*s,far:40*s+6*
c}}drawFloor(e,t){let{space:s}=this,n=se(t.ground),i=n.map(l=>l*(t.dark?.82:.94)),a=.5*e,r=this.focus%(2*a);s.use(this.floor,{reach:this.reach,light:n,dark:i,far:se(
t.paper),tile:a,shift:r}),Ve(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(e,t,s,n,i,a,r){let{space:l}=this,h=e.radius,c=.045*
h,u=[t.x-this.focus,h+t.height,s];l.ring({center:u,radius:h,tube:c,broad:3.2*c,angle:t.angle,velocity:[t.vx,t.vy],omega:t.omega,plain:n.speed?null:se(a.modes[t.
mode])},r);let m=[Math.sin(t.angle),Math.cos(t.angle),0],p=b=>u.map((g,f)=>g+b*m[f]);l.ball(p(h-c),.125*h,i.dark?[.9,.91,.94]:[.12,.13,.15],r),l.rod(u,m,h-c,.012*
h,[.55,.57,.6],r);let w=t.mode==="H";l.ball(p(e.eccentricity*h),.07*h,se(w?a.airborne:a.gravity_center),r)}drawForces(e,t,s,n){if(t.mode==="H"||!(t.normal_force>
0))return;let i=e.radius,a=e.mass*(e.gravity||9.81),r=[t.x-this.focus,t.height+.03*i,s+.2*i],l=c=>y(.55*i*Math.abs(c)/a,0,3.2*i),h=Math.sign(t.friction_force);this.
space.arrow(r,[0,1,0],l(t.normal_force),i,se(n.normal_force)),this.space.arrow(r,[h,0,0],l(t.friction_force),i,se(n.friction_force))}linesOf(e,t,s){let n=this.lines.
get(e);if(n?.dark===t.dark)return n;let i=e.radius,{x:a,height:r,angle:l,mode:h}=e.columns,c=(b,g)=>this.space.trace(e.length,f=>[a[f]+b*Math.sin(l[f]),i+r[f]+b*
Math.cos(l[f])],g),[u,m,p]=[se(s.gravity_center),se(s.airborne),se(t.ink)],w={dark:t.dark,load:c(i,()=>p),center:c(e.eccentricity*i,b=>h[b]===3?m:u)};return this.
lines.set(e,w),w}drawTraces(e,t,s,n,i,a){let{load:r,center:l}=this.linesOf(e,n,i),h=Math.min(e.index(t.t)+2,e.length),c={shift:this.focus,depth:s};this.space.drawTrace(
r,h,{width:a,...c}),this.space.drawTrace(l,h,{width:1.6*a,...c})}};var jl=["hoop","mode","time","angle","v","R θ̇","gap"],vs=class{constructor(e,t){this.colors=e,this.onview=t,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1},this.plane=d("canvas",{class:"stage-canvas"}),this.space=d("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new fs(this.plane,t),this.deep=
null,this.outputs=jl.map(n=>({name:d("dt",{},n),value:d("dd",{})})),this.outputs[1].value.className="mode",this.fastest=d("span",{}),this.legend=d("div",{class:"\
legend","aria-hidden":"true"},d("i",{style:`background: linear-gradient(90deg, ${qt.filter((n,i)=>i%15===0).join(",")})`}),d("span",{},"0"),d("span",{},"rim spe\
ed"),this.fastest);let s=(n,i)=>d("span",{},d("i",{class:"dot",style:`background:${n}`}),i);this.order=d("span",{hidden:!0},"A in front, B behind"),this.element=
d("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,d("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(
({name:n,value:i})=>[n,i])),this.legend,d("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(e.gravity_center,"centre of gravity"),s(e.airborne,
"the same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(e,t,s,{look:n,inks:i}){let{options:a}=this;this.legend.hidden=!a.
speed,this.order.hidden=!(a.three&&e.length>1),this.fastest.textContent=`≥ ${_(Math.max(...e.map(r=>r.extent.speed)),2)} m/s`,a.three?(this.deep??=new ys(this.
space,this.onview),this.deep.draw(e,s.time,a,n,i,s.playing)):this.flat.draw(e,s.time,a,n,i),this.read(e,t,s.time)}read(e,t,s){let n=e[t],i=n.at(s),a=[e.length>1?
"AB"[t]:"",x(this.colors.mode_names[i.mode]),le(`${i.t.toFixed(3)} s`),q(i.angle),F(_(i.vx,3),"m/s"),F(_(i.omega*n.radius,3),"m/s"),i.height>0?ye(i.height):"0"];
for(let[h,c]of a.entries()){let{value:u}=this.outputs[h];u.textContent!==c&&(u.textContent=c)}let[r,l]=this.outputs;r.value.hidden=r.name.hidden=e.length<2,l.value.
style.setProperty("--mode",this.colors.modes[i.mode])}describe(e){let t=e.map(s=>s.summary).join(" ");this.element.setAttribute("aria-label",`${x("The hoop.")} ${t}`)}turn(e){
let t=()=>{this.plane.hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,t();try{e()}catch(s){throw this.options.
three=!1,t(),s}}zoom(e){this.options.three?this.deep?.zoomBy(e):e?this.flat.zoomBy(e):this.flat.reset()}};var ks=class{film;items;current;constructor(e){this.clock=e,this.summary=d("p",{class:"summary"}),this.list=d("ol",{class:"story-list"}),this.heading=d("h2",{},
"What happens"),this.live=d("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=d("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(e,t,s){this.film=e[t],M(this.heading,e.length>1?`What happens to hoop ${"AB"[t]}`:"What happens"),this.summary.
replaceChildren(...e.flatMap((n,i)=>[e.length>1?d("b",{},`${"AB"[i]}: `):"",n.summary,n.status==="event_limit"||n.shortened?" (not all events are shown)":"",i+1<
e.length?d("br"):""])),this.items=this.film.story.map(n=>d("li",{},d("button",{type:"button",onclick:()=>this.clock.seek(n.t)},d("i",{class:"dot",style:`backgro\
und:${s.modes[n.mode]}`,"aria-hidden":"true"}),d("span",{class:"when"},`${_(n.t,4)} s`),d("span",{},n.text)))),this.list.replaceChildren(...this.items),this.current=
-1,this.cursor(this.clock.time)}say(e){M(this.live,e)}announce(e){this.say(ee(e.map(t=>t.summary).join(" ")))}cursor(e){let{story:t}=this.film,s=-1;for(let i=0;i<
t.length&&t[i].t<=e+1e-9;i++)s=i;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),this.items[this.
current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let n=this.items[s];if(n){let i=n.offsetTop-this.list.
offsetTop;(i<this.list.scrollTop||i+n.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=i-.4*this.list.clientHeight)}}},xs=class{constructor(){
this.list=d("dl",{}),this.heading=d("h2",{},"What theory says"),this.element=d("section",{class:"theory"},this.heading,this.list)}draw(e,t=""){M(this.heading,t?
`What theory says of hoop ${t}`:"What theory says"),this.list.replaceChildren(...e.flatMap(({label:s,text:n})=>[d("dt",{},s),d("dd",{},n)]))}};var Yi="hophoop-theme",Cl=["gravity_center","airborne","normal_force","friction_force"],_s=class{constructor(e,t,s,n){this.root=e,this.colors=t,this.hosted=s,this.
changed=n,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=Js(e),this.inks={...t},this.read()}mark(){let e=this.hosted?ae(Yi):null;this.root.dataset.theme=this.chosen??e??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=Js(this.root),this.inks={...this.colors};for(let e of Cl)
this.inks[e]=it(this.colors[e],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&re(Yi,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};var Ts={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns back",apex:"hi\
ghest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"jam",kane_gain:"\
energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},Zi=o=>o.kind==="takeoff"||o.to==="H"&&o.from!=="H"&&o.kind!=="impact";var vt={jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"\
↺",apex:"•"},Ss=Object.keys(vt);function Xi(o,e=11){let s=[...o.filter(({kind:i})=>i in vt)].sort((i,a)=>Ss.indexOf(i.kind)-Ss.indexOf(a.kind)||i.x-a.x),n=[];
for(let{kind:i,x:a}of s){let r=Ss.indexOf(i)<Ss.indexOf("takeoff"),l=n.filter(h=>Math.abs(h.x-a)<e);l.length?l.length===1&&l[0].rare&&!n.some(h=>Math.abs(h.x-(l[0].
x+e))<e-1e-9)?l[0].mark!==vt[i]&&n.push({mark:vt[i],x:l[0].x+e,rare:!1,hidden:0}):l[0].hidden+=1:n.push({mark:vt[i],x:a,rare:r,hidden:0})}return n.sort((i,a)=>i.
x-a.x).map(({mark:i,x:a})=>({mark:i,x:a}))}function Qi(o,e,t){let s=[],n=new Map,i=-1,a=(l,h,c)=>{let u=s.at(-1);u&&u.mode===l&&Math.abs(u.from+u.wide-h)<1e-6?u.
wide+=c:s.push({mode:l,from:h,wide:c})},r=()=>{n.size&&a([...n].reduce((l,h)=>h[1]>l[1]?h:l)[0],i,1),n=new Map};for(let{mode:l,from:h,to:c}of o){let[u,m]=[Math.
max(e(h),0),Math.min(e(c),t)];if(m>u)for(let p=u;p<m-1e-9;){if((Math.floor(p+1e-9)!==i||!n.size)&&(r(),i=Math.floor(p+1e-9),m-p>=1&&Math.abs(p-i)<1e-6)){let b=Math.
floor(m-p+1e-9);a(l,i,b),p=i+b;continue}let w=Math.min(m,i+1);n.set(l,(n.get(l)??0)+w-p),p=w}}return r(),s}var Ms=class{films;said;constructor(e){this.clock=e,this.window=null,this.canvas=d("canvas",{class:"timeline-canvas"}),this.tip=d("div",{class:"tip",hidden:!0}),
this.element=d("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),
this.element.addEventListener("pointerdown",t=>this.scrub(t)),this.element.addEventListener("pointermove",t=>this.hover(t)),this.element.addEventListener("point\
erleave",()=>this.tip.hidden=!0),this.pinched=Z(this.element,{zoom:(t,s)=>this.zoom(1/t,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let e=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=e[1]?e:Re(this.window,e)}zoom(e,t){let[s,n]=this.ends(),i=1e-6*this.clock.duration,
a=Math.max((n-s)*e,i),r=(t-s)/(n-s);this.window=a<this.clock.duration?Re([t-r*a,t+(1-r)*a],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[e,t]=this.ends(),{time:s,duration:n}=this.clock;if(s>=e&&s<=t)return;let i=t-e;this.window=Re(s>t?[s-.1*i,s+.9*i]:[s-.5*i,s+.5*i],[0,n])}timeAt(e){let t=this.
canvas.getBoundingClientRect(),[s,n]=this.ends();return s+y((e.clientX-t.left)/t.width,0,1)*(n-s)}scrub(e){e.preventDefault(),this.element.focus({preventScroll:!0});
let t=this.clock.playing;this.clock.playing=!1;let s=n=>!this.pinched()&&this.clock.seek(this.timeAt(n));s(e),W(this.element,e,s,()=>t&&this.clock.play(!0))}hover(e){
let t=this.timeAt(e),s=this.nearest(t,8),n=s?`${x(Ts[s.kind]??s.kind)} · ${_(s.t,5)} s · ${_(s.angle*180/Math.PI,4)}°`:`${_(t,4)} s`;this.tip.textContent=n,this.
tip.hidden=!1;let i=this.canvas.getBoundingClientRect();this.tip.style.left=`${y(e.clientX-i.left,70,i.width-70)}px`}nearest(e,t){let[s,n]=this.ends(),i=t*(n-s)/
(this.canvas.getBoundingClientRect().width||1),a=null;for(let r of this.films??[])for(let l of r.events){if(l.kind==="end")continue;let h=Math.abs(l.t-e);h<=i&&
(!a||h<Math.abs(a.t-e))&&(a=l)}return a}draw(e,t,s){this.films=e;let{context:n,width:i,height:a}=D(this.canvas);this.keep();let[r,l]=this.ends(),h=g=>(g-r)/(l-r)*
i;n.clearRect(0,0,i,a);let c=15,u=(a-15)/e.length-c;e.forEach((g,f)=>{let k=c+f*(c+u);for(let{mode:T,from:E,wide:N}of Qi(g.phases,h,i)){let I=s.modes[T];n.fillStyle=
I,n.fillRect(E,k,N,u-2),this.named(n,x(s.mode_names[T]),E,N,k,u-2,I,t)}g.duration<l&&(n.fillStyle=t.line,n.fillRect(Math.max(h(g.duration),0),k,i,u-2)),this.marks(
n,g,h,k,i,t),e.length>1&&(n.fillStyle=ie(f,t.dark),n.font=`700 12px ${t.font}`,n.textAlign="right",n.fillText("AB"[f],i-1,k-4))});let m=U(l-r,i/60);n.fillStyle=
t.soft,n.font=`10.5px ${t.font}`;let p=te(r,l,i/60);for(let g of p){let f=h(g);n.textAlign=f<14?"left":f>i-14?"right":"center",n.fillText(Y(g,m)+(g===p[0]?" s":
""),f,a-3)}let w=y(h(this.clock.time),6,i-6),b=y(h(this.clock.time),1,i-1);n.fillStyle=t.ink,n.fillRect(b-1,c-4,2,a-c-9),n.beginPath(),n.moveTo(w-6,c-10),n.lineTo(
w+6,c-10),n.lineTo(b,c-1),n.fill(),this.tell(e,s)}tell(e,t){let{time:s,duration:n,playing:i}=this.clock,r=e.map((l,h)=>{let c=x(t.mode_names[l.at(s).mode]);return e.
length>1?`${"AB"[h]} ${c}`:c}).join(", ");i&&r===this.said||(this.said=r,this.element.setAttribute("aria-valuemax",n.toFixed(3)),this.element.setAttribute("aria\
-valuenow",s.toFixed(3)),this.element.setAttribute("aria-valuetext",x("{time} seconds, {what}",{time:_(s,4),what:ee(r)})))}named(e,t,s,n,i,a,r,l){e.font=`11px ${l.
font}`,!(a<13||e.measureText(t).width+8>n)&&(e.fillStyle=An(r),e.textAlign="center",e.textBaseline="middle",e.fillText(t,s+.5*n,i+.5*a+1),e.textBaseline="alphab\
etic")}marks(e,t,s,n,i,a){e.font=`11px ${a.font}`,e.textAlign="center";let r=t.events.filter(({kind:l})=>l!=="start"&&l!=="end").map(({kind:l,t:h})=>({kind:l,x:s(
h)})).filter(({x:l})=>l>=-1&&l<=i+1);if(e.fillStyle=a.panel,r.length<i/6)for(let{x:l}of r)e.fillRect(l-.5,n,1,5);e.fillStyle=a.ink;for(let{mark:l,x:h}of Xi(r))e.
fillText(l,y(h,6,i-6),n-4)}};var Ol=1/60,Dl=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],Fl={three:"In space"},_e=(o,e,t)=>d(
"button",{type:"button",title:e,"aria-label":e,onclick:t},o),ea=(o,e)=>d("span",{},d("span",{"aria-hidden":"true"},`${o} `),e),Es=class{titled="";constructor(e,t,s,n,i){
this.clock=e,this.films=t,this.say=n,this.tell=i,this.playButton=_e($("play"),"Play (space)",()=>e.play()),this.playButton.classList.add("play"),this.speeds=d("\
select",{"aria-label":"Speed of the film",onchange:()=>{e.speed=Number(this.speeds.value)}},dt.map(a=>d("option",{value:String(a)},`${a}×`))),this.speeds.value=
"1",this.switches=new Map(Dl.map(([a,r,l])=>{let h=`${a==="three"?Fl.three:r} (${l})`;return[a,d("button",{type:"button",class:"switch",title:h,onclick:()=>s(a)},
r)]})),this.element=d("div",{class:"transport"},d("div",{class:"buttons"},_e($("start"),"To the start (Home)",()=>e.seek(0)),_e($("previous"),"Previous event (S\
hift ←)",()=>this.jump(-1)),_e($("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,_e($("on"),"One frame on (→)",()=>this.nudge(1)),_e($("n\
ext"),"Next event (Shift →)",()=>this.jump(1))),d("div",{class:"buttons jumps"},_e(ea("▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),_e(
ea("▼","landing"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,d("div",{class:"buttons switches"},[...this.switches.values()]))}show(e){let{
clock:t,playButton:s}=this;for(let[i,a]of this.switches)a.setAttribute("aria-pressed",String(e[i]));let n=t.playing?"Pause (space)":"Play (space)";this.titled!==
n&&(this.titled=n,s.replaceChildren($(t.playing?"pause":"play")),ct(s,"title",n),ct(s,"aria-label",n)),this.speeds.value!==String(t.speed)&&(this.speeds.value=String(
t.speed))}nudge(e){this.clock.playing=!1,this.clock.seek(this.clock.time+e*Ol*Math.min(this.clock.speed,1))}jump(e,t=null){this.clock.playing=!1;let s=this.films().
flatMap((c,u)=>c.events.map(m=>({event:m,lane:u}))).filter(({event:c})=>!t||(t==="impact"?c.kind===t:Zi(c))).sort((c,u)=>c.event.t-u.event.t),n=this.clock.time,
i=e>0?s.find(({event:c})=>c.t>n+1e-9):s.findLast(({event:c})=>c.t<n-1e-9);if(!i&&t&&(i=s[0]),!i){t&&this.say(t==="takeoff"?"This motion has no flight.":"This mo\
tion has no landing.");return}this.clock.seek(i.event.t);let{event:a,lane:r}=i,l=this.films().length>1?`${x(`Hoop ${"AB"[r]}`)}: `:"",h=x(Ts[a.kind]??a.kind);this.
tell(ee(`${l}${x("{what} at {angle}, {time} s",{what:h,angle:q(a.angle),time:_(a.t,4)})}`))}};var Je=class{constructor(e,t,s,{hosted:n=!1,panels:i=null,onmotion:a=()=>{}}={}){this.root=e,this.backend=t,this.hosted=n,this.onmotion=a,this.prepareRoot();let{
colors:r}=s;this.known=s.presets,this.address=n?new Dt(this):null,this.clock=new Ft,this.motions=new cs(t,{shown:l=>this.changed(l),refined:()=>this.request(),settled:()=>this.
story.announce(this.films()),noted:l=>this.noted(l),travelled:async l=>this.address?.travel(l),failed:(l,h)=>this.failed(l,h)}),this.notice=new ds,this.theme=new _s(
e,r,n,()=>this.show()),this.stage=new vs(r,()=>{this.request(),this.address?.soon()}),this.transport=new Es(this.clock,()=>this.films(),l=>this.toggle(l),l=>this.
notice.say(l),l=>this.story.say(l)),this.timeline=new Ms(this.clock),this.story=new ks(this.clock),this.theory=new xs,this.plots=new ms(this.clock,r),this.phase=
new us(t,this.clock,r),this.map=new ls(t,s,{take:l=>{this.clock.time=0,this.motions.change(l,!0)},say:l=>this.story.say(l),changed:()=>this.address?.soon()}),this.
controls=new Bt(s.controls,(l,h)=>this.motions.change(l,h)),this.share=new ps(this),this.singleKeys=new ns(n),this.help=wi(s.version,r,this.singleKeys.element),
this.hoops=new os(l=>this.motions.choose(l)),this.header=new ss(s.presets,this.share.menu,{take:l=>this.take(l),undo:()=>this.travel(-1),redo:()=>this.travel(1),
compare:()=>this.motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(i),this.extras=new ts(this),this.requested=!1,this.
surrounding=!1,this.taken=null,this.afterFrame=null,this.asked=null,this.later=he(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=this.frame.
bind(this),this.clock.listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=yi(this,n),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){
this.root.classList.add("hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts=
"true")}layOut(e){let{root:t,notice:s}=this,n=c=>!e||e.includes(c),i=d("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.
element),a=d("div",{class:"player"},this.stage.element,this.timeline.element,this.transport.element);this.sticky=this.hosted?ji(a,()=>this.request()):null;let r=d(
"a",{class:"skip button",href:"#hh-player"},"Skip to the player");this.hosted&&(this.timeline.element.id="hh-player"),r.onclick=c=>{c.preventDefault(),this.timeline.
element.focus()};let l=d("div",{class:"middle"},this.sticky?.edge,a,d("div",{class:"words"},this.story.element,n("theory")&&this.theory.element),n("map")&&this.
map.element),h=d("div",{class:"why"},n("plots")&&this.plots.element,n("plots")&&this.phase.element);t.replaceChildren(d("div",{class:"page"},this.hosted&&r,this.
header.element,d("div",{class:"columns"},n("controls")&&i,l,h)),s.toast,this.share.dialog,this.help),t.classList.toggle("no-controls",!n("controls"))}async open(e,t={}){
await this.motions.load(e),this.clock.duration=Math.max(...this.films().map(s=>s.duration)),this.restore(t),this.begin()}begin(){this.show(),this.motions.note(),
this.sizes.observe(this.stage.element),this.root.dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.map.close(),this.
theme.close(),this.address?.close(),this.sticky?.close(),this.sizes.disconnect(),this.deaf()}film(e=this.motions.active){return this.motions.film(e)}films(){return this.
motions.films()}changed(e=null){this.notice.clear(),this.show(e)}failed(e,t=[]){this.controls.refuse(t,e.message)||(this.notice.fail(e),this.controls.restore()),
this.showPreset()}noted(e){this.header.show(this.motions.history,this.motions.lanes.length>1),this.address?.write(e),this.onmotion(this.film().query)}link(){let{
clock:e,stage:t,map:s}=this;return this.motions.link(Un({time:e.time,options:t.options,zoom:t.flat.zoom,map:s.shown()}))}restore({time:e,options:t,zoom:s,map:n}){
if(t){let{three:i,...a}=t;Object.assign(this.stage.options,a),i&&this.toggle("three")}s&&(this.stage.flat.zoom=s),n&&this.map.restore(n),e&&this.clock.seek(e)}showPreset(){
let{query:e}=this.film(),t=this.known.find(s=>s.query===e);this.header.presets.value=t?.key??"",M(this.hoops.text,t?.text??"")}async take(e){this.taken=e;try{let t=await this.
backend.call("film",{query:e.query});if(this.taken!==e)return;this.clock.time=0,this.motions.replace(t),this.story.announce(this.films())}catch(t){this.failed(t)}}travel(e){
return this.motions.travel(e)}show(e=null){let{motions:t,clock:s}=this,n=this.films();if(!n.length)return;let i=n.length>1;this.theme.read(),s.duration=Math.max(
...n.map(a=>a.duration)),s.time=Math.min(s.time,s.duration),this.root.classList.toggle("two",i),this.header.show(t.history,i),this.hoops.show(n.length,t.active),
this.drawStage(),this.controls.show(this.film(),this.motions.waiting()),this.showPreset(),e!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(
performance.now()-e),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=
!1;let e=this.films(),{active:t}=this.motions,{look:s,colors:n}=this.theme;this.plots.draw(e,t,s),this.phase.draw(e,t,s),this.story.draw(e,t,n),this.drawTime(),
this.map.mark(this.film(),s),this.stage.describe(e),this.extras.changed(),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.
theme)}drawTime(){let{time:e}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(e),this.phase.cursor(
e),this.story.cursor(e),this.transport.show(this.stage.options))}request(){this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(e){this.requested=
!1,this.motions.lanes.length&&(this.clock.tick(e),this.motions.refine(this.clock.time,this.clock.playing?2*this.clock.speed:0),this.drawStage(),this.drawTime(),
this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){let{scenario:e}=this.film();this.asked?.abort(),this.
asked=new AbortController;let{signal:t}=this.asked;try{let s=await this.backend.call("theory",{scenario:e},t);this.theory.draw(s.header.thresholds,this.motions.
name()),await this.phase.fetch(e,t)}catch(s){let{name:n,message:i}=s;n!=="AbortError"&&this.theory.draw([{label:"–",text:i}])}}toggle(e){let{options:t}=this.stage;
if(e!=="three")t[e]=!t[e];else try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}this.transport.show(t),this.address?.soon(),this.request()}};var Mo=class extends Error{},Eo=class{constructor(e,t){this.start=e,this.compiled=t,this.number=0,this.waiting=null,this.worker=this.begun()}begun(){let e=this.
start();return e.onmessage=({data:t})=>{if(t.number!==this.number||!this.waiting)return;let{resolve:s,reject:n}=this.waiting;this.waiting=null,t.error?n(new Error(
t.error)):s(t.answer)},e.onerror=t=>this.fail(new Error(t.message||"The kernel could not be started.")),e.postMessage({compiled:this.compiled}),e}fail(e){this.waiting?.
reject(e),this.waiting=null}stop(e){this.worker.terminate(),this.worker=this.begun(),this.fail(e)}ask(e,t,s){this.number++;let n=new Promise((i,a)=>{this.waiting=
{resolve:i,reject:a}});return this.worker.postMessage({number:this.number,call:e,values:t},s),n}},kt=class{constructor(e,t,s,n){this.start=e,this.compiled=t,this.
size=s,this.limit=n,this.idle=[],this.hired=0,this.queue=[]}hand(){let e=this.idle.pop();return e?Promise.resolve(e):this.hired<this.size?(this.hired++,Promise.
resolve(new Eo(this.start,this.compiled))):new Promise(t=>this.queue.push(t))}release(e){let t=this.queue.shift();t?t(e):this.idle.push(e)}async ask(e,t,s,n=[]){
s?.throwIfAborted();let i=await this.hand(),a=()=>i.stop(new DOMException("superseded","AbortError")),r=setTimeout(()=>i.stop(new Mo(`This takes longer than ${this.
limit/1e3} s, and was stopped.`)),this.limit);try{return s?.throwIfAborted(),s?.addEventListener("abort",a),await i.ask(e,t,n)}finally{clearTimeout(r),s?.removeEventListener(
"abort",a),this.release(i)}}close(){for(let e of this.idle)e.worker.terminate()}};var v={sources:"1b3290ae96f005267cf6e061f520474c",module:"b193fd5c3517e371",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring",
"damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy",
"omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain",
"collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_norm\
al","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],compliant:["law","friction_law","stiffness","damping","rest\
itution","slip_speed","tangential_stiffness","rtol"],laws:["kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","bristle"],chosen:["stiffness","tangen\
tial_stiffness","slip_speed","depth","stiffness_si","slip_speed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_friction","n\
eeded_friction_angle","painleve_friction","painleve_angle","jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","massless_\
loss_by_friction"],numbers:["time","end_angle","end_speed","distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","takeoff_t\
ime","takeoff_angle","hop_height","flight_time","flight_distance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","hop","pa\
inleve"],keys:4,letters_a_key:21,more:7,endings:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{
angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,
status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,
takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undet\
ermined","event_limit"],ending:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stic\
k","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:[
"no","yes"],painleve:["no","yes"]},shapes:["ring","disk","point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start",
"slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","\
rest","end"],letters:"RSKHM",statuses:["completed","at_rest","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var Ye=o=>Object.fromEntries(o.map((e,t)=>[e,t])),Qp=Ye(v.cell),ge=Ye(v.heads),K=Ye(v.events),Ao=Ye(v.samples),ta=Ye(v.numbers),zo=Ye(v.words),$l={newton:0,poisson:1,
stronge:2};function Ze(o){let e=new Float64Array(v.cell.length),t={...Object.fromEntries(Object.entries(o).filter(([,s])=>typeof s=="number")),law:$l[o.impact_law],
strike:+(o.painleve==="impact"),ideal:Number(o.ideal),allowed:1};return v.cell.forEach((s,n)=>{e[n]=t[s]??0}),e}function Ro(o){let e=t=>t??Number.NaN;return Float64Array.
of(v.laws.indexOf(o.law),v.friction_laws.indexOf(o.friction),e(o.stiffness),e(o.damping),e(o.restitution),e(o.slip_speed),e(o.tangential_stiffness),e(o.rtol))}var As=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let s=this.rooms.get(e);if(s&&s.bytes>=t)return s.place;s&&this.exports.free(s.place),this.
rooms.delete(e);let n=this.exports.malloc(t);if(!n)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:n,bytes:t}),
n}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let s=this.room(e,8*Math.max(t.length,1));return this.floats(s,t.length).set(t),s}};var Bl=150,Hl=240,Kl=6e3,[of,sa,oa]=[0,1,2],Ul={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["fri\
ction_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_norm\
al","damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function Po(o,e,t){let{rows:s,count:n,duration:i}=e,[a,r]=(t??[0,i]).map(g=>Math.
min(Math.max(g,0),i)),l=Math.min(Math.max(Math.ceil((r-a)*Bl),Hl),Kl),h=v.events.length,c=new Set;for(let g=0;g<=l&&i>0;g++)c.add(g===l?r:a+g*((r-a)/l));let u=new Set;
for(let g=0;g<n;g++){let f=Math.min(s[g*h+K.t],i);f>=a&&f<=r&&u.add(f)}for(let g of u)c.add(g);let m=Float64Array.from(c).sort(),p=Float64Array.from(u).filter(g=>g>
0).sort(),w=o.states(e,m,!1),b=o.states(e,p,!0);return Gl(m,w,p,b)}function Gl(o,e,t,s){let n=o.length+t.length,i=v.samples.length,a=new Float64Array(n),r=new Float64Array(
n*i),l=0,h=0;for(let u=0;u<o.length;u++)h<t.length&&t[h]<=o[u]&&(a[l]=t[h],r.set(s.subarray(h*i,(h+1)*i),l*i),l++,h++),a[l]=o[u],r.set(e.subarray(u*i,(u+1)*i),l*
i),l++;let c={t:a};for(let[u,m]of Object.entries(Ul)){let p=new Float64Array(n);for(let w of m)for(let b=0;b<n;b++)p[b]+=r[b*i+Ao[w]];c[u]=p}return c.mode=Vl(r,
n,c.omega),c}function Vl(o,e,t){let s=v.samples.length,n=new Float64Array(e),i=0;for(let a=e-1;a>=0&&!i;a--)i=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){i=Math.
sign(t[a])||i;let r=o[a*s+Ao.mode],l=r===sa?-1:r===oa?1:0;n[a]=l===0?r:l*i<0?sa:oa}return n}function na(o,e){let t=new Map,s=new Float64Array(e);for(let n=0;n<e;n++){let i=Jl(o.subarray(n*v.keys,(n+1)*v.keys));if(i===""){s[n]=Number.NaN;continue}let a=t.
get(i);a===void 0&&(a=t.size,t.set(i,a)),s[n]=a}return{values:s,sequences:[...t.keys()]}}function Jl(o){let e="";for(let t of o){let s=t;for(let n=0;n<v.letters_a_key&&
s;n++){let i=Number(s&7n);s>>=3n,i&&(e+=i===v.more?"+":v.letters[i-1])}}return e}var Yl=256,Zl=2048,Xl=4096,Ql=2e5,eh=v.statuses.indexOf("buffer"),th=new Set(["turn","apex","kane_gain","rest"]),Io=o=>Number.isFinite(o)?o:null,zs=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new As(this.exports),this.mostEvents=Yl,this.mostSegments=Zl,this.mostRows=
Xl}call(e,...t){let s=this.exports[e](...t);if(s)throw new Error(`The kernel ended ${e} with ${s}.`)}compute(e){let{memory:t}=this,s=v.events.length;for(;;){let n=t.
room("table",8*s*this.mostEvents),i=t.room("heads",8*v.heads.length);e.contact?this.computeCompliant(e,e.contact,n,i):this.computeRigid(e,n,i);let a=t.floats(i,
v.heads.length).slice(),r=a[ge.events];if(a[ge.status]===eh)this.makeRoom(e,a[ge.segments]);else if(r===this.mostEvents&&r<e.max_events)this.mostEvents*=4;else{
let l=t.floats(n,r*s).slice();return{given:e,head:a,rows:l,count:r,duration:a[ge.duration],segments:a[ge.segments]}}}}computeRigid(e,t,s){let{memory:n}=this,i=n.
put("cell",Ze(e)),a=n.room("events",v.event_bytes*this.mostEvents),r=n.room("segments",v.segment_bytes*this.mostSegments);this.call("motion",i,a,this.mostEvents,
r,this.mostSegments,t,s)}computeCompliant(e,t,s,n){let{memory:i}=this,a=i.put("cell",Ze(e)),r=i.put("contact",Ro(t)),l=i.room("events",v.event_bytes*this.mostEvents),
h=i.room("rows",v.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,r,l,this.mostEvents,Ql,h,this.mostRows,s,n)}makeRoom(e,t){e.contact?this.
mostRows=t:this.mostSegments*=4}motion(e){return ia(this.compute(e))}film(e){let t=this.compute(e);return{motion:ia(t),columns:Po(this,t)}}columns(e,t){return Po(
this,this.compute(e),t)}samples(e,t){let s=this.states(this.compute(e),t,!1),n=v.samples.length;return Object.fromEntries(v.samples.map((i,a)=>[i,Float64Array.from(
t,(r,l)=>s[l*n+a])]))}states(e,t,s){let{memory:n}=this,i=t.length*v.samples.length,a=n.put("times",t),r=n.room("states",8*Math.max(i,1)),l=n.room("cell",8),h=[e.
segments,a,t.length,Number(s),r];return e.given.contact?this.call("compliant_samples",l,n.room("contact",8),n.room("rows",8),...h):this.call("samples",l,n.room(
"segments",8),...h),n.floats(r,i).slice()}thresholds(e){let{memory:t}=this,s=t.put("cell",Ze(e)),n=t.room("answers",8*v.thresholds.length),i=e.rolling&&e.angle===
0;this.call("thresholds",s,i?e.vx:Number.NaN,n);let a=t.floats(n,v.thresholds.length),r=h=>{let c=a[v.thresholds.indexOf(h)];return Number.isNaN(c)?null:c},l=["\
jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(r);return{first_slip_speed:r("first_slip_speed"),first_hop_speed:r("first_hop_speed"),immediate_hop_speed:r(
"immediate_hop_speed"),needed_friction:r("needed_friction"),painleve_friction:r("painleve_friction"),painleve_angle:r("painleve_angle"),jam_angles:l.filter(h=>h!==
null),stable_angle:r("stable_angle"),massless_loss_angle:r("massless_loss_angle"),massless_loss_by_friction:r("massless_loss_by_friction")===1}}regions(e,[t,s,n,
i],a,r){let{memory:l}=this,h=l.put("cell",Ze(e)),c=l.room("modes",a*r),u=l.room("sides",a);this.call("regions",h,t,s,n,i,a,r,c,u);let{buffer:m}=this.exports.memory;
return{modes:new Uint8Array(m,c,a*r).slice(),paradox:Float32Array.from(new Int8Array(m,u,a))}}map({count:e,rows:t},s,n){let{memory:i}=this,a=i.put("cells",t),r=i.
room("numbers",8*e*v.numbers.length),l=i.room("words",4*e*v.words.length),h=i.room("keys",8*e*v.keys),{angle:c,stop:u,timed:m}=v.spans[n],p=v.wanted[s];this.call(
"map_cells",a,e,c??Number.NaN,u,m,p,r,l,h);let{buffer:w}=this.exports.memory;if(s==="sequence")return na(new BigUint64Array(w,h,e*v.keys),e);let b=new Float64Array(
e);if(s in zo){let g=new Int32Array(w,l,e*v.words.length);for(let f=0;f<e;f++)b[f]=g[f*v.words.length+zo[s]]}else{let g=i.floats(r,e*v.numbers.length);for(let f=0;f<
e;f++)b[f]=g[f*v.numbers.length+ta[s]]}return{values:b}}ideal(e){let t=this.memory.room("answers",8*v.thresholds.length);return this.call("ideal_hoop",e,t),this.
memory.floats(t,1)[0]}resistance(e,t){let s=this.memory.room("answers",8*v.thresholds.length);return this.call("resistance_limit",e,t,s),this.memory.floats(s,1)[0]}combine(e,t){
let{memory:s}=this,n=s.put("parts",t.flatMap(sh)),i=s.room("answers",8*v.thresholds.length),a=s.room("reaches",8*t.length);this.call("hoop_of_parts",e,n,t.length,
i,a);let[r,l,h]=s.floats(i,3);return{mass:r,eccentricity:l,inertia_ratio:h,reaches:[...s.floats(a,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError(
"The contact is rigid.");let s=t.put("cell",Ze(e)),n=t.put("contact",Ro(e.contact)),i=t.room("answers",8*v.thresholds.length);this.call("compliance",s,n,i);let a=t.
floats(i,v.chosen.length),r=l=>a[v.chosen.indexOf(l)];return{stiffness:r("stiffness"),tangential_stiffness:r("tangential_stiffness"),slip_speed:r("slip_speed"),
depth:r("depth"),automatic:{stiffness:r("stiffness_si"),slip_speed:r("slip_speed_si")}}}};function sh(o){let e=o.shape==="rod"?`${o.direction}_rod`:o.shape,t=v.
shapes.indexOf(e);return o.shape==="ring"?[t,o.mass,o.inner_radius,o.outer_radius,0]:o.shape==="disk"?[t,o.mass,o.radius,0,o.at]:o.shape==="rod"?[t,o.mass,o.length,
0,o.at]:[t,o.mass,0,0,o.at]}var oh=["friction","impact_normal","impact_tangential","rolling_resistance"],nh=["kinetic","potential",...oh,"residual"],aa=["x","he\
ight","angle","vx","vy","omega"];function ia({given:o,head:e,rows:t,count:s,duration:n}){let i=v.events.length,a=Array.from({length:s},(h,c)=>ih(t.subarray(c*i,
(c+1)*i))),r=a[s-1],l=Object.fromEntries([...nh,...o.contact?["spring","damping"]:[]].map(h=>[h,e[ge[h]]]));return{status:v.statuses[e[ge.status]],sequence:ah(a),
duration:n,events:a,final:{t:r.t,mode:r.to,...Object.fromEntries(aa.map(h=>[h,r[h]]))},energy:l,doubt:Io(e[ge.doubt_from])}}function ih(o){let e=v.kinds[o[K.kind]],
t=o[K.from_mode],s={t:o[K.t],kind:e,from:t<0?null:v.letters[t],to:v.letters[o[K.to_mode]]};for(let n of aa)s[n]=Io(o[K[n]]);return s.before=Object.fromEntries([
"vx","vy","omega"].map(n=>[n,Io(o[K[`before_${n}`]])])),s.impulse={normal:o[K.impulse_normal],tangential:o[K.impulse_tangential]},o[K.collision]===0&&(s.collision=
!1),e==="kane_gain"&&(s.gain=o[K.gain]),o[K.stable]>=0&&(s.stable=o[K.stable]===1),s}function ah(o){let e=o.filter(s=>!th.has(s.kind));return e.slice(0,-1).map(
(s,n)=>e[n+1].t>s.t?s.to:"").join("")||(o.at(-1)?.to??"")}var ra=1e4,Lo=256;function la(o){let e=URL.createObjectURL(new Blob([o],{type:"text/javascript"}));return()=>new Worker(e,{type:"module"})}var xt=class o{constructor(e,t){
this.mechanics=new zs(e),this.motions=new kt(t,e,2,ra);let s=navigator.hardwareConcurrency||2;this.maps=new kt(t,e,Math.max(1,Math.min(s-1,8)),ra)}static async load(e){
let t=new URL(`hophoop.wasm?${v.module}`,e),s=await fetch(t);if(!s.ok)throw new Error(`The kernel is not there: ${t.pathname} gives ${s.status}.`);let i=await(s.
headers.get("Content-Type")==="application/wasm"?WebAssembly.compileStreaming(s):WebAssembly.compile(await s.arrayBuffer())),a=new URL(`kernel.js?${v.module}`,e);
return a.origin===globalThis.location?.origin?new o(i,()=>new Worker(a,{type:"module"})):new o(i,la(await(await fetch(a)).text()))}static async unpack(e,t){let s=new Blob(
[e]).stream().pipeThrough(new DecompressionStream("gzip")),n=await WebAssembly.compile(await new Response(s).arrayBuffer());return new o(n,la(t))}motion(e,t){return this.
motions.ask("motion",[e],t)}film(e,t){return this.motions.ask("film",[e],t)}columns(e,t,s){return this.motions.ask("columns",[e,s],t)}samples(e,t,s){return this.
motions.ask("samples",[e,t],s)}thresholds(e,t){return this.motions.ask("thresholds",[e],t)}regions(e,t,s,n,i){return this.motions.ask("regions",[e,t,s,n],i)}async map({
count:e,rows:t},s,n,i){let a=v.cell.length,r=new Float64Array(e).fill(Number.NaN),l=[],h=async u=>{let m=Math.min(Lo,e-u),p=new Float64Array(a*m);for(let g=0;g<
a;g++)p.set(t.subarray(g*e+u,g*e+u+m),g*m);let w=await this.maps.ask("map",[{count:m,rows:p},s,n],i,[p.buffer]),b=w.sequences?.map(g=>(l.includes(g)||l.push(g),
l.indexOf(g)));for(let g=0;g<m;g++)r[u+g]=b?b[w.values[g]]??Number.NaN:w.values[g]},c=Array.from({length:Math.ceil(e/Lo)},(u,m)=>m*Lo);return await Promise.all(
c.map(h)),s==="sequence"?{values:r,sequences:l}:{values:r}}close(){this.motions.close(),this.maps.close()}};function No(o,e){let[t,s,n]=[0,0,0];for(let i=0;i<o.length;i++)for(let a=0;a<e.length;a++){let r=0;for(;i+r<o.length&&a+r<e.length&&o[i+r]===e[a+r];)r++;r>t&&([
t,s,n]=[r,i,a])}return t?t+No(o.slice(0,s),e.slice(0,n))+No(o.slice(s+t),e.slice(n+t)):0}function ha(o,e){let t=[...o],s,n=0;for(let i of e){let a=[...i],r=a.length+
t.length;if(2*Math.min(a.length,t.length)/r<.6)continue;let l=2*No(a,t)/r;l>=.6&&(l>n||l===n&&s!==void 0&&i>s)&&([s,n]=[i,l])}return s}var ca={setup:{version:"0.1.0",controls:{groups:{hoop:[{path:"hoop.load_fraction",label:"Load fraction",symbol:"γ",unit:"",help:"Share of the mass in the load \
of an ideal hoop",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}},{path:"hoop.eccentricity",label:"Eccentricity",symbol:"ε",
unit:"",help:"Distance of the centre of gravity from the centre, over the radius",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}},
{path:"hoop.inertia_ratio",label:"Inertia ratio",symbol:"κ",unit:"",help:"Moment of inertia about the centre of gravity over m R²",least:.01,most:1,step:.01,logarithmic:!1,
degrees:!1,allowed:{least:1e-12,most:1e6,also:[0]}},{path:"hoop.radius",label:"Radius",symbol:"R",unit:"m",help:"Rim radius",least:.05,most:3,step:.05,logarithmic:!1,
degrees:!1,allowed:{least:1e-6,most:1e6,also:[]}},{path:"hoop.mass",label:"Mass",symbol:"m",unit:"kg",help:"Total mass",least:.1,most:10,step:.1,logarithmic:!1,
degrees:!1,allowed:{least:1e-12,most:1e12,also:[]}}],plane:[{path:"plane.mu",label:"Friction",symbol:"μ",unit:"",help:"Friction, static and kinetic",least:0,most:1.5,
step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1e6,also:["inf"]}},{path:"plane.mu_static",label:"Static friction",symbol:"μs",unit:"",help:"Static fr\
iction",least:0,most:1.5,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1e6,also:["inf"]}},{path:"plane.mu_kinetic",label:"Kinetic friction",symbol:"μ\
k",unit:"",help:"Kinetic friction",least:0,most:1.5,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1e6,also:["inf"]}},{path:"plane.slope",label:"Slope",
symbol:"β",unit:"°",help:"Slope of the plane, downhill along +x",least:-30,most:30,step:.5,logarithmic:!1,degrees:!0,allowed:{least:-1.57,most:1.57,also:[]}},
{path:"plane.gravity",label:"Gravity",symbol:"g",unit:"m/s²",help:"Gravity",least:0,most:25,step:.01,logarithmic:!1,degrees:!1,allowed:{least:1e-6,most:1e6,also:[
0]}},{path:"plane.restitution",label:"Restitution",symbol:"e",unit:"",help:"Restitution of an impact",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{
least:0,most:1,also:[]}},{path:"plane.rolling_resistance",label:"Rolling resistance",symbol:"f",unit:"",help:"Rolling resistance: couple against the rotation ov\
er R N",least:0,most:.2,step:.001,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}}],start:[{path:"start.speed",label:"Speed",symbol:"v₀",unit:"m/s",
help:"Velocity of the centre in a rolling start",least:-6,most:6,step:.01,logarithmic:!1,degrees:!1,allowed:{least:-1e6,most:1e6,also:[]}},{path:"start.angle",label:"\
Load angle",symbol:"θ₀",unit:"°",help:"Angle from the plane's normal to the centre of gravity",least:-180,most:180,step:.5,logarithmic:!1,degrees:!0,allowed:{
least:-1e6,most:1e6,also:[]}},{path:"start.height",label:"Height of the gap",symbol:"y₀",unit:"m",help:"Gap between rim and plane",least:0,most:2,step:.01,logarithmic:!1,
degrees:!1,allowed:{least:0,most:1e6,also:[]}},{path:"start.vx",label:"Speed along",symbol:"ẋ₀",unit:"m/s",help:"Velocity of the centre along the plane",least:-8,
most:8,step:.01,logarithmic:!1,degrees:!1,allowed:{least:-1e6,most:1e6,also:[]}},{path:"start.vy",label:"Speed upwards",symbol:"ẏ₀",unit:"m/s",help:"Velocit\
y of the centre away from the plane",least:-5,most:5,step:.01,logarithmic:!1,degrees:!1,allowed:{least:-1e6,most:1e6,also:[]}},{path:"start.omega",label:"Angula\
r velocity",symbol:"θ̇₀",unit:"rad/s",help:"Angular velocity",least:-15,most:15,step:.05,logarithmic:!1,degrees:!1,allowed:{least:-1e9,most:1e9,also:[]}}],contact:[
{path:"contact.stiffness",label:"Stiffness",symbol:"k",unit:"N/m",help:"Stiffness of the contact",least:100,most:1e8,step:0,logarithmic:!0,degrees:!1,allowed:{least:1e-6,
most:1e18,also:[]}},{path:"contact.slip_speed",label:"Slip speed",symbol:"vₛ",unit:"m/s",help:"Slip velocity over which friction builds up",least:1e-7,most:.1,
step:0,logarithmic:!0,degrees:!1,allowed:{least:1e-12,most:1e6,also:[]}},{path:"contact.restitution",label:"Restitution",symbol:"e",unit:"",help:"Restitution th\
at the damping is chosen for",least:0,most:1,step:.01,logarithmic:!1,degrees:!1,allowed:{least:0,most:1,also:[]}}],motion:[{path:"duration",label:"Duration",symbol:"\
T",unit:"s",help:"Duration of the motion",least:.5,most:30,step:.5,logarithmic:!1,degrees:!1,allowed:{least:1e-9,most:1e9,also:[]}}]},choices:[{path:"plane.impa\
ct_law",label:"Law of impact",options:[["stronge","Stronge (energy)"],["poisson","Poisson (impulse)"],["newton","Newton (velocity)"]],help:"Law of restitution"},
{path:"plane.painleve",label:"Painlevé: two solutions",options:[["flight","flight"],["impact","impact"]],help:"What follows an indeterminate contact"},{path:"c\
ontact.model",label:"Contact model",options:[["rigid","rigid"],["compliant","compliant"]],help:"Contact model"},{path:"contact.law",label:"Normal force",options:[
["kelvin-voigt","Kelvin–Voigt"],["hunt-crossley","Hunt–Crossley"]],help:"Normal force"},{path:"contact.friction",label:"Friction law",options:[["tanh","smoo\
th (tanh)"],["linear","linear"],["bristle","bristle (can hold)"]],help:"Regularised friction"}],gravities:[["Earth",9.81],["Moon",1.62],["Mars",3.71],["Jupiter",
24.79],["Weightless",0]],map_axes:[{path:"start.speed",label:"Speed v₀",unit:"m/s",degrees:!1,range:[0,5],allowed:[-1e6,1e6]},{path:"start.angle",label:"Angle\
 of the load θ₀",unit:"°",degrees:!0,range:[-3.141592653589793,3.141592653589793],allowed:[-1e6,1e6]},{path:"start.vx",label:"Speed along ẋ₀",unit:"m/s",
degrees:!1,range:[-6,6],allowed:[-1e6,1e6]},{path:"start.omega",label:"Angular velocity θ̇₀",unit:"rad/s",degrees:!1,range:[-8,8],allowed:[-1e9,1e9]},{path:"\
start.height",label:"Height of the gap y₀",unit:"m",degrees:!1,range:[0,1],allowed:[0,1e6]},{path:"hoop.load_fraction",label:"Load fraction γ",unit:"",degrees:!1,
range:[.05,.99],allowed:[0,1]},{path:"hoop.eccentricity",label:"Eccentricity ε",unit:"",degrees:!1,range:[.05,.95],allowed:[0,1]},{path:"hoop.inertia_ratio",label:"\
Inertia ratio κ",unit:"",degrees:!1,range:[.05,1],allowed:[0,1e6]},{path:"hoop.radius",label:"Radius R",unit:"m",degrees:!1,range:[.1,2],allowed:[1e-6,1e6]},{path:"\
plane.mu",label:"Friction μ",unit:"",degrees:!1,range:[0,1.5],allowed:[0,1e6]},{path:"plane.slope",label:"Slope β",unit:"°",degrees:!0,range:[-.35,.35],allowed:[
-1.57,1.57]},{path:"plane.gravity",label:"Gravity g",unit:"m/s²",degrees:!1,range:[1,20],allowed:[0,1e6]},{path:"plane.restitution",label:"Restitution e",unit:"",
degrees:!1,range:[0,1],allowed:[0,1]},{path:"plane.rolling_resistance",label:"Rolling resistance f",unit:"",degrees:!1,range:[0,.1],allowed:[0,1]}]},map_quantities:[
["sequence","what happens in the first turn"],["hop_height","height of the first hop"],["takeoff_angle","angle of take-off"],["flight_time","duration of the fir\
st hop"],["greatest_utilization","greatest friction utilization"],["energy_lost","energy lost"],["end_angle","angle at the end"],["painleve","Painlevé’s paradox\
 or jam met"],["ending","how it ends"]],presets:[{key:"hop",group:"The article",title:"It hops: 3.1 m/s",text:"Slips twice, then leaves the plane just before a \
full turn and flies for 0.76 s.",query:"duration=3"},{key:"slip",group:"The article",title:"It slips: 2.8 m/s",text:"Friction is used up twice a turn; each slip\
 is weaker than the one before, and none is the last.",query:"duration=4&start.speed=2.8"},{key:"roll",group:"The article",title:"It rolls: 2 m/s",text:"Pure ro\
lling, faster and more even than after a slow start, and close to the limit of friction.",query:"duration=3.4&start.speed=2"},{key:"slow",group:"The article",title:"\
The smallest push: 0.1 m/s",text:"Nearly at rest with the load up, fast with the load down; 38 % of the friction is used.",query:"start.speed=0.1"},{key:"slippe\
ry",group:"The article",title:"Low friction: 0.1 m/s, μ = 0.3",text:"Slipping costs the energy that a full turn needs: the hoop rocks to and fro.",query:"durat\
ion=15&plane.mu=0.3&start.speed=0.1"},{key:"littlewood",group:"Littlewood's hoop",title:"All mass in the load",text:"A massless ring: at 90° no contact force is\
 left; the load falls, the rim skims the plane.",query:"duration=3&hoop.load_fraction=1&start.speed=0.1"},{key:"littlewood-fast",group:"Littlewood's hoop",title:"\
All mass in the load, pushed",text:"With a push the contact force is gone earlier, at cos θ = v₀²/(gR).",query:"duration=3&hoop.load_fraction=1&start.speed=\
2"},{key:"nearly-massless",group:"Littlewood's hoop",title:"Nearly all mass in the load",text:"γ = 0.99: what a real ring does instead of Littlewood's hop.",query:"\
hoop.load_fraction=0.99&start.speed=0.1"},{key:"inconsistent",group:"Paradoxes",title:"Painlevé: no solution",text:"No contact force agrees with this slip. An \
impact without collision stops it at once.",query:"duration=3&plane.mu=1.2&start.angle=-0.7&start.vx=3&start.omega=1"},{key:"indeterminate",group:"Paradoxes",title:"\
Painlevé: two solutions",text:"Flight and impact both agree with the laws. Choose which with the switch under Plane.",query:"duration=3&plane.mu=1.2&start.angl\
e=-0.7&start.vx=8&start.omega=5"},{key:"jam",group:"Paradoxes",title:"Dynamic jam",text:"A fast slide after a hop: the contact force grows without bound in fini\
te time, and no law says what follows.",query:"duration=3&hoop.load_fraction=0.9&start.angle=5.14&start.vx=23&start.omega=5.6"},{key:"kane",group:"Paradoxes",title:"\
Kane: energy out of nothing",text:"Newton's law of impact with friction creates two joules. Stronge's law does not.",query:"duration=1.5&plane.mu=0.6&plane.rest\
itution=0.8&plane.impact_law=newton&start.height=0.3&start.angle=1.45&start.vx=2.16&start.omega=-6.44"},{key:"downhill",group:"More",title:"Downhill",text:"On a\
 slope of 10° the hoop gains speed from turn to turn, until it hops.",query:"duration=5&plane.slope=0.17453292519943295&plane.mu=0.8&start.speed=1.5"},{key:"bo\
unces",group:"More",title:"Bounces without number",text:"Dropped with spin and restitution 0.5: infinitely many bounces in finite time.",query:"duration=4&plane\
.mu=0.4&plane.restitution=0.5&start.height=0.5&start.angle=0.4&start.vx=0.2&start.omega=2"},{key:"moon",group:"More",title:"On the Moon",text:"The article's hop\
 under lunar gravity: everything is slower by a factor of 2.46.",query:"duration=15&plane.gravity=1.62&start.speed=1.2597509583501894"}],colors:{modes:{R:"#0072\
B2",S:"#E69F00",K:"#CC79A7",H:"#D55E00",M:"#F0E442"},mode_names:{R:"roll",S:"spin",K:"skid",H:"flight",M:"skim"},gravity_center:"#009E73",airborne:"#CC1F1A",center_speed:"\
#000000",rotation_speed:"#00857A",kinetic:"#1B3A78",potential:"#667300",friction_loss:"#8F3B0A",impact_loss:"#8E1B5F",normal_force:"#5B3FA8",friction_force:"#8F\
3B0A",limit:"#6E6E6E"}},schema:"hophoop/1",scenario:{sections:{hoop:["Hoop"],plane:["Plane"],start:["Start"],contact:["Rigid","Compliant"]},models:{Scenario:{place:"",
fields:{duration:{kind:"number",unit:"s",default:6,limits:[["greater_than",0]],range:{least:1e-9,most:1e9,words:"from 1e-09 to 1e+09 s"}},hoop:{kind:"section",unit:""},
plane:{kind:"section",unit:""},start:{kind:"section",unit:""},contact:{kind:"section",unit:""}}},Hoop:{place:"hoop.",fields:{radius:{kind:"number",unit:"m",default:1,
limits:[["greater_than",0]],range:{least:1e-6,most:1e6,words:"from 1e-06 to 1e+06 m"}},mass:{kind:"number",unit:"kg",default:1,limits:[["greater_than",0]],range:{
least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},load_fraction:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than_equal",0],["less_th\
an_equal",1]]},eccentricity:{kind:"number",unit:"1",default:.75,limits:[["greater_than_equal",0],["less_than_equal",1]]},inertia_ratio:{kind:"number",unit:"1",default:.4375,
limits:[["greater_than_equal",0]],range:{least:1e-12,most:1e6,words:"0 or from 1e-12 to 1e+06",also:[0]}},parts:{kind:"parts",unit:"",nullable:!0,default:null}}},
Plane:{place:"plane.",fields:{gravity:{kind:"number",unit:"m/s²",default:9.81,limits:[["greater_than_equal",0]],range:{least:1e-6,most:1e6,words:"0 or from 1e-\
06 to 1e+06 m/s²",also:[0]}},slope:{kind:"number",unit:"rad",default:0},mu:{kind:"friction",unit:"1",nullable:!0,default:null,range:{least:0,most:1e6,words:"fr\
om 0 to 1e+06, or inf",also:["inf"]}},mu_static:{kind:"friction",unit:"1",default:1,range:{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]}},mu_kinetic:{
kind:"friction",unit:"1",default:1,range:{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]}},restitution:{kind:"number",unit:"1",default:0,limits:[
["greater_than_equal",0],["less_than_equal",1]]},impact_law:{kind:"word",unit:"",default:"stronge",options:["stronge","newton","poisson"],expected:"'stronge', '\
newton' or 'poisson'"},painleve:{kind:"word",unit:"",default:"flight",options:["flight","impact"],expected:"'flight' or 'impact'"},rolling_resistance:{kind:"num\
ber",unit:"1",default:0,limits:[["greater_than_equal",0],["less_than_equal",1]]}}},Start:{place:"start.",fields:{x:{kind:"number",unit:"m",default:0,range:{least:-1e9,
most:1e9,words:"from -1e+09 to 1e+09 m"}},height:{kind:"number",unit:"m",default:0,limits:[["greater_than_equal",0]],range:{least:0,most:1e6,words:"from 0 to 1e\
+06 m"}},angle:{kind:"number",unit:"rad",default:0,range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 rad"}},speed:{kind:"number",unit:"m/s",nullable:!0,default:null,
range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 m/s"}},vx:{kind:"number",unit:"m/s",default:0,range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 m/s"}},
vy:{kind:"number",unit:"m/s",default:0,range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 m/s"}},omega:{kind:"number",unit:"rad/s",nullable:!0,default:0,range:{
least:-1e9,most:1e9,words:"from -1e+09 to 1e+09 rad/s"}}}},Rigid:{place:"contact.",fields:{model:{kind:"word",unit:"",default:"rigid",options:["rigid"],expected:"\
'rigid'"},max_events:{kind:"whole",unit:"1",default:1e5,limits:[["greater_than_equal",1],["less_than_equal",1e7]]}}},Compliant:{place:"contact.",fields:{model:{
kind:"word",unit:"",default:"compliant",options:["compliant"],expected:"'compliant'"},stiffness:{kind:"number",unit:"N/m",nullable:!0,default:null,limits:[["gre\
ater_than",0]],range:{least:1e-6,most:1e18,words:"from 1e-06 to 1e+18 N/m"}},damping:{kind:"number",unit:"N s/m or s/m",nullable:!0,default:null,limits:[["great\
er_than_equal",0]],range:{least:0,most:1e12,words:"from 0 to 1e+12"}},restitution:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than_equal",
0],["less_than_equal",1]]},law:{kind:"word",unit:"",default:"kelvin-voigt",options:["kelvin-voigt","hunt-crossley"],expected:"'kelvin-voigt' or 'hunt-crossley'"},
friction:{kind:"word",unit:"",default:"tanh",options:["tanh","linear","bristle"],expected:"'tanh', 'linear' or 'bristle'"},slip_speed:{kind:"number",unit:"m/s",
nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06 m/s"}},tangential_stiffness:{kind:"number",unit:"N/m",
nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-6,most:1e18,words:"from 1e-06 to 1e+18 N/m"}},rtol:{kind:"number",unit:"1",nullable:!0,default:null,
limits:[["greater_than",0]],range:{least:1e-10,most:.1,words:"from 1e-10 to 0.1"}},max_events:{kind:"whole",unit:"1",default:1e5,limits:[["greater_than_equal",1],
["less_than_equal",1e7]]}}},Ring:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"ring",options:["ring"],expected:"'ring'"},mass:{kind:"number",
unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},inner_radius:{kind:"number",unit:"m",required:!0,
limits:[["greater_than_equal",0]]},outer_radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,words:"from 1e-12 to\
 1e+06 m"}}}},Disk:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"disk",options:["disk"],expected:"'disk'"},mass:{kind:"number",unit:"kg",required:!0,
limits:[["greater_than",0]],range:{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],
range:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06 m"}},at:{kind:"number",unit:"m",default:0}}},PointMass:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",
default:"point_mass",options:["point_mass"],expected:"'point_mass'"},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,
words:"from 1e-12 to 1e+12 kg"}},at:{kind:"number",unit:"m",required:!0}}},Rod:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"rod",options:["\
rod"],expected:"'rod'"},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},length:{
kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06 m"}},at:{kind:"number",unit:"m",default:0},
direction:{kind:"word",unit:"",default:"radial",options:["radial","tangential"],expected:"'radial' or 'tangential'"}}}},parts:{ring:"Ring",disk:"Disk",point_mass:"\
PointMass",rod:"Rod"},paths:["duration","hoop.radius","hoop.mass","hoop.load_fraction","hoop.eccentricity","hoop.inertia_ratio","hoop.parts","plane.gravity","pl\
ane.slope","plane.mu","plane.mu_static","plane.mu_kinetic","plane.restitution","plane.impact_law","plane.painleve","plane.rolling_resistance","start.x","start.h\
eight","start.angle","start.speed","start.vx","start.vy","start.omega","contact.model","contact.max_events","contact.stiffness","contact.damping","contact.resti\
tution","contact.law","contact.friction","contact.slip_speed","contact.tangential_stiffness","contact.rtol"],ends:{"hoop.load_fraction":["eccentricity","inertia\
_ratio","parts"],"hoop.eccentricity":["load_fraction","parts"],"hoop.inertia_ratio":["load_fraction","parts"],"hoop.parts":["load_fraction","eccentricity","iner\
tia_ratio","mass"],"plane.mu":["mu_static","mu_kinetic"],"plane.mu_static":["mu"],"plane.mu_kinetic":["mu"],"start.speed":["height","vx","vy","omega"],"start.he\
ight":["speed"],"start.vx":["speed"],"start.vy":["speed"],"start.omega":["speed"],"contact.damping":["restitution"],"contact.restitution":["damping"]},ranges:{"\
hoop.mass":{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"},"hoop.inertia_ratio":{least:1e-12,most:1e6,words:"0 or from 1e-12 to 1e+06",also:[0]},"plane.s\
lope":{least:-1.57,most:1.57,words:"from -1.57 to 1.57 rad"}},relative:{stiffness:{least:.01,most:1e15,words:"from 0.01 to 1e+15",of:"m g/R"},tangential_stiffness:{
least:.01,most:1e15,words:"from 0.01 to 1e+15",of:"m g/R"},slip_speed:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06",of:"√(g R)"}},most_depth:100,touch:1e-12,
default:{duration:6,hoop:{radius:1,mass:1,load_fraction:.75},plane:{gravity:9.81,slope:0,mu:1,restitution:0,impact_law:"stronge",painleve:"flight"},start:{x:0,angle:0,
speed:3.1},contact:{model:"rigid",max_events:1e5}}},texts:{unknown_key:"{path} is not a known key; {hint}",did_you_mean:"did you mean {close}?",known_are:"known\
 are {known}.",missing:"{path} is missing.",together:"{section}.{other} cannot be given together with {section}.{way}.",finding:"{path} = {shown} {allowed}.",number:"\
must be a number",friction:"must be at least 0 (inf is allowed)",whole:"must be a whole number",finite_number:"must be a finite number",greater_than:"must be gr\
eater than {limit:g}",greater_than_equal:"must be at least {limit:g}",less_than:"must be less than {limit:g}",less_than_equal:"must be at most {limit:g}",range:"\
must be {words}",literal_error:"must be {expected}",table:"must be a table of keys",list:"must be a list",word:"must be a word",other_problem:"{first} (and {cou\
nt} more problem).",other_problems:"{first} (and {count} more problems).",whole_scenario:"the scenario",no_parts:"hoop.parts must not be empty.",half_a_hoop:"ho\
op.{missing} is missing: hoop.{given} does not define a hoop without it.",massless_eccentricity:"hoop.inertia_ratio = 0 needs hoop.eccentricity = 1 (all mass in\
 a point on the rim), not {eccentricity!r}.",hoop_mass:"hoop.mass = {mass!r} must be {words}.",parts_inertia:"hoop.parts give hoop.inertia_ratio = {inertia_rati\
o!r}, which must be {words}.",load_inertia:"hoop.load_fraction = {load_fraction!r} gives hoop.inertia_ratio = {inertia_ratio!r}, which must be {words}.",ring_radii:"\
ring.inner_radius = {inner!r} must not exceed ring.outer_radius = {outer!r}.",beyond_the_rim:"hoop.parts.{index} ({shape}) reaches {reach!r} m from the centre, \
beyond the rim: hoop.radius = {radius!r}.",kinetic_above_static:"plane.mu_kinetic = {mu_kinetic!r} must not exceed plane.mu_static = {mu_static!r}.",vertical:"p\
lane.slope = {slope!r} must lie between -pi/2 and pi/2 (radians).",slope:"plane.slope = {slope!r} must be {words}.",no_omega:"start.omega = None must be a numbe\
r.",massless_slope:"plane.slope = {slope!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",massless_resistance:"plane.rolling_resistance = {given!r}\
 must be 0 for the massless hoop (hoop.inertia_ratio = 0).",resistance:"plane.rolling_resistance = {given!r} must be below {most:.6g} for this hoop, whose inert\
ia about the contact it would cancel at some angle.",massless_compliant:"contact.model = 'compliant' must be 'rigid' for the massless hoop (hoop.inertia_ratio =\
 0).",compliant_friction:"plane.mu_static = inf must be finite with contact.model = 'compliant'.",relative_contact:"contact.{name} = {value!r} is {relative:.3g}\
 {unit} of this hoop and must be {words} of it.",too_soft:"contact.stiffness = {stiffness!r} lets the rim sink some {depth:.0e} radii into the plane, at the spe\
ed of the start, and must be high enough for at most {most:g}.",no_parameter:"{path} is not a parameter of a scenario; known are {known}.",no_section_parts:"{pa\
th} is not a parameter of a scenario: {section} has no parts.",two_ways:"{one} = {one_value!r} and {other} = {other_value!r} cannot be given together.",not_there:"\
{path} is not there to be replaced: the scenario has no {step!r}.",unreadable_query:"The query cannot be read: {reason}.",beside_a_value:"{path} cannot stand be\
side a value for {above}.",given_twice:"{path} is given twice.",parts_out_of_order:"hoop.parts.{name} is out of order: parts are numbered from 0 without a gap."},
words:{letters:"RSKHM",modes:["roll","spin","skid","flight","skim"],verbs:{roll:"rolls",spin:"spins",skid:"skids",flight:"flies",skim:"skims the plane"},events:{
start:"starts",slip_start:"slips",stick:"rolls",slip_reversal:"slips the other way",takeoff:"hops",impact:"lands",turn:"turns back",apex:"is highest",bounce_limit:"\
has bounced out",painleve_inconsistent:"meets Painlevé's paradox",painleve_indeterminate:"meets Painlevé's indeterminacy",jam:"jams",kane_gain:"gains energy (\
Kane)",skim:"skims",rest:"rests",end:"ends"},statuses:{completed:"",at_rest:"It has come to rest.",jammed:"The normal force grows without bound (dynamic jam): r\
igid-body mechanics has no motion beyond.",undetermined:"The model does not determine the motion beyond.",event_limit:"The limit of events (contact.max_events),\
 or of work for one motion, was reached before the end."},sequence:{R:"roll",S:"slip −",K:"slip +",H:"hop",M:"skim","+":"…"},story:{start:"It {started} with\
 the load at {where} and the centre at {speed} m/s.",started:"starts and {verb}",started_flight:"starts in the air",started_skim:"starts skimming",slip_start:"I\
t {verb} at {where}; friction is used up: the rim slides ahead.",slip_start_spin:"It {verb} at {where}; friction is used up: the rim turns too fast for the way \
it goes.",stick:"It rolls again at {where}; the slip has stopped.",slip_reversal:"The slip turns round at {where}; it {verb}.",takeoff:"It hops at {where}.",takeoff_and_landing:"\
It hops at {where}. It rises {top} and stays up for {time} s.",impact:"It lands at {where} with {speed} m/s downwards and {verb}.",impact_bounce:"It lands at {w\
here} with {speed} m/s downwards and bounces.",impact_without_collision:"An impact without collision at {where} stops the slip; then it {verb}.",turn:"It turns \
back at {where}.",turn_in_slip:"It turns back at {where}, and {verb} now.",apex:"The centre is highest at {where}: the gap is {gap}.",bounce_limit:"Bounces with\
out number end here, at {where}.",painleve_inconsistent:"Painlevé's paradox at {where}: no contact force agrees with this slip.",painleve_indeterminate:"Painle\
vé's paradox at {where}: several contact forces agree with it.",jam:"Dynamic jam at {where}: the contact force grows without bound.",kane_gain:"Newton's law of\
 impact has created {gain} J (Kane's example).",skim:"No contact force is left at {where}: the load falls freely and the rim skims the plane.",rest:"It rests at\
 {where}.",rest_unstable:"It rests at {where}, which is not stable.",end:"",other:"{kind} at {where}.",more_bounces:"It bounces {count} more times.",left_out:"…\
 and {count} more."},summary:{change:"{phrase} at {where}",bounces:"bounces",without_collision:"stops its slip at once",more_bounces:"and {count} more times",more_changes:"\
, … ({count} more)",sentence:"{phrases}. {ending}"},theory:{first_slip:"Slips",first_hop:"Hops",immediate_hop:"Hops at once",needed_friction:"Friction for pur\
e rolling",painleve:"Painlevé’s paradox",jam:"Dynamic jam",rest:"Rests stably",loss:"End of rolling",loss_by_friction:"at {where} friction is used up",loss_of_contact:"\
at {where} the contact force is gone",would_slip:"would slip",would_hop:"would hop in its first turn",would_hop_at_once:"would hop at once",any_push:"{would}: a\
ny push is enough",any_speed:"{would}: at any speed",no_speed:"never, at any speed",above:"{would} above {speed} m/s",no_friction:"no friction keeps it rolling",
friction_enough:"μ = {mu} would keep it rolling (enough here)",friction_short:"μ = {mu} would keep it rolling (more than there is)",never:"never",paradox_here:"\
from μ = {mu} on, at {where}: possible here",paradox_not_here:"from μ = {mu} on, at {where}: not here",jam_at:"can end a slip at {places}",rest_at:"with the l\
oad at {where}",uphill:"Slips, hops",no_threshold:"no threshold uphill (β < 0): whether it slips or hops hangs on where it turns back; the map shows it"},least_speed:1e-9},
classes:{codes:{hop:{no:"#D9D9D9",yes:"#D55E00"},painleve:{no:"#D9D9D9",yes:"#000000"},ending:{duration:"#6E6E6E",revolutions:"#0072B2",reversal:"#009E73",takeoff:"\
#D55E00",rest:"#56B4E9",jam:"#000000",undetermined:"#F0E442",event_limit:"#CC79A7"},status:{completed:"#0072B2",at_rest:"#56B4E9",jammed:"#000000",undetermined:"\
#F0E442",event_limit:"#CC79A7"},first_event:{slip_start:"#E69F00",takeoff:"#D55E00",stick:"#0072B2",turn:"#009E73",end:"#56B4E9",impact:"#F0E442",slip_reversal:"\
#CC79A7",rest:"#D9D9D9",jam:"#000000"}},families:{SR:"#009E73",SS:"#F0E442",SK:"#E69F00",KR:"#CC79A7",KS:"#8C6BB1",KK:"#F2B5D4"},massless:{rolls:"#F0E442","roll\
s, slips":"#E69F00","":"#009E73",slips:"#CC79A7"},hops:"#D55E00",rolls:"#0072B2",other:"#6E6E6E"},map:{cell:["radius","mass","eccentricity","inertia_ratio","gra\
vity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_events","ideal","rolling_resistance",
"allowed"],laws:{newton:0,poisson:1,stronge:2},events:2e3,quantities:{sequence:{label:"what happens in the first turn",span:"first_revolution",unit:"",words:[]},
hop_height:{label:"height of the first hop",span:"takeoff",unit:"m",words:[]},takeoff_angle:{label:"angle of take-off",span:"takeoff",unit:"rad",words:[]},flight_time:{
label:"duration of the first hop",span:"takeoff",unit:"s",words:[]},greatest_utilization:{label:"greatest friction utilization",span:"first_revolution",unit:"1",
words:[]},energy_lost:{label:"energy lost",span:"duration",unit:"J",words:[]},end_angle:{label:"angle at the end",span:"duration",unit:"rad",words:[]},painleve:{
label:"Painlevé’s paradox or jam met",span:"duration",unit:"",words:["no","yes"]},ending:{label:"how it ends",span:"duration",unit:"",words:["duration","revo\
lutions","reversal","takeoff","rest","jam","undetermined","event_limit"]}}},lab:{too_long:"duration = {duration:g} must be at most {most:g} s in the lab; the li\
brary itself has no such limit.",too_many_parts:"hoop.parts has {parts} parts and must have at most {most} in the lab.",too_many_turns:"duration = {duration:g} \
s at this speed and radius is about {turns:.0e} revolutions and must be at most {most:.0e} in the lab; the library itself has no such limit.",too_many_cells:"x.\
cells times y.cells = {cells} must be at most {most} in the lab.",equal_axes:"x.path and y.path are both {path!r} and must differ.",two_axes:"{one} and {other} \
cannot both be axes: they say the same thing in two ways.",rigid_maps:"contact.model = 'compliant' must be 'rigid' for a map.",not_a_pair:"changes holds {change\
}, which is not a pair of path and value."},limits:{duration:600,events:2e4,parts:64,samples:20001,cells:65536},table:{rate:200,variables:{mode:"1",x:"m",height:"\
m",angle:"rad",vx:"m/s",vy:"m/s",omega:"rad/s",slip:"m/s",friction_force:"N",normal_force:"N",kinetic:"J",potential:"J",total:"J",friction:"J",impact_normal:"J",
impact_tangential:"J",rolling_resistance:"J",spring:"J",damping:"J"}},shown:["hoop.radius","hoop.mass","hoop.load_fraction","hoop.eccentricity","hoop.inertia_ra\
tio","plane.mu","plane.rolling_resistance","plane.mu_static","plane.mu_kinetic","start.speed","start.height","start.vx","start.vy","start.omega"]};var S=ca,_t=o=>o==="inf"?1/0:o;var Le=class{constructor(e){this.text=e}};function Ne(o){if(Number.isNaN(o))return"nan";if(!Number.isFinite(o))return o>0?"inf":"-inf";let e=o<0||Object.is(o,-0)?
"-":"",[t,s]=Math.abs(o).toExponential().split("e"),n=t.replace(".",""),i=Number(s);return i<-4||i>=16?`${e}${t}e${qo(i)}`:e+(i<0?`0.${"0".repeat(-i-1)}${n}`:ma(
n,i+1))}function ma(o,e){let t=o.padEnd(e,"0");return`${t.slice(0,e)}.${t.slice(e)||"0"}`}var qo=o=>`${o<0?"-":"+"}${String(Math.abs(o)).padStart(2,"0")}`;function pa(o,e){
let[t,s]=o.toExponential(e-1).split("e"),n=t.replace(".",""),i=o.toExponential(100).split("e")[0].replace(".","");return i[e]==="5"&&/^0*$/.test(i.slice(e+1))&&
Number(i[e-1])%2===0?[i.slice(0,e),Number(o.toExponential(100).split("e")[1])]:[n,Number(s)]}function jo(o){return Number.isNaN(o)?"nan":o>0?"inf":"-inf"}var Tt=o=>o<
0||Object.is(o,-0)?"-":"";function qe(o,e=6){if(!Number.isFinite(o))return jo(o);let t=Tt(o);if(o===0)return`${t}0`;let[s,n]=pa(Math.abs(o),e),i=s.replace(/0+$/,
"")||"0";if(n<-4||n>=e)return`${t}${i[0]}${i.length>1?`.${i.slice(1)}`:""}e${qo(n)}`;if(n<0)return`${t}0.${"0".repeat(-n-1)}${i}`;let[a,r]=ma(s,n+1).split("."),
l=r.replace(/0+$/,"");return`${t}${a}${l&&`.${l}`}`}function lh(o,e){if(!Number.isFinite(o))return jo(o);let[t,s]=o===0?["0".repeat(e+1),0]:pa(Math.abs(o),e+1),
n=t.slice(1);return`${Tt(o)}${t[0]}${n&&`.${n}`}e${qo(s)}`}function Co(o,e){if(!Number.isFinite(o))return jo(o);let t=Math.abs(o);if(t>=1e21)return`${Tt(o)}${BigInt(
t)}${e?`.${"0".repeat(e)}`:""}`;let s=t.toFixed(e),n=t.toFixed(100),i=n.slice(n.indexOf(".")+1+e),a=n.slice(0,n.indexOf(".")+(e?1+e:0));return/^50*$/.test(i)&&Number(
a.at(-1))%2===0?Tt(o)+a:Tt(o)+s}function P(o,e){return o.replace(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g,(t,s,n,i,a)=>{let r=e[s];return r instanceof Le?r.text:n?
oe(r):a==="g"?qe(r,i===""?6:Number(i)||1):a==="e"?lh(r,Number(i)):a==="f"?Co(r,Number(i)):String(r)})}function oe(o,e=!0){return o==null?"None":o===!0?"True":o===
!1?"False":typeof o=="number"?e?Ne(o):fa(o):typeof o=="string"?da(o):Array.isArray(o)?`[${o.map(s=>oe(s,e)).join(", ")}]`:`{${Object.entries(o).map(([s,n])=>`${da(
s)}: ${oe(n,e)}`).join(", ")}}`}function fa(o){let e=Object.is(o,-0)?"0":String(o);return/^-?\d+$/.test(e)?e:Ne(o)}function St(o){return typeof o=="number"?fa(o):
typeof o=="string"?JSON.stringify(o).replace(/[\u007f-\uffff]/g,e=>`\\u${Rs(e.charCodeAt(0),4)}`):Array.isArray(o)?`[${o.map(St).join(", ")}]`:o&&typeof o=="obj\
ect"?`{${Object.entries(o).map(([e,t])=>`${St(e)}: ${St(t)}`).join(", ")}}`:String(o)}var Rs=(o,e)=>o.toString(16).padStart(e,"0"),hh=/[\p{C}\p{Zl}\p{Zp}\p{Zs}]/u,
ga=o=>o===" "||!hh.test(o);function wa(o){if(o===`
`)return"\\n";if(o==="\r")return"\\r";if(o==="	")return"\\t";let e=o.codePointAt(0);return e<256?`\\x${Rs(e,2)}`:e<65536?`\\u${Rs(e,4)}`:`\\U${Rs(e,8)}`}function da(o){
let e=o.includes("'")&&!o.includes('"')?'"':"'",t=[...o].map(s=>s===e||s==="\\"?`\\${s}`:ga(s)?s:wa(s));return e+t.join("")+e}var ba=o=>[...o].map(e=>ga(e)?e:wa(
e)).join("");function Ps(o){let e=[...o];return e.length<=60?o:`${e.slice(0,57).join("")}...`}var ua="[\\s\\x1c-\\x1f\\x85]*",ch=new RegExp(`^${ua}([+-]?)(?:(in\
f(?:inity)?|nan)|((?:\\d+(?:_\\d+)*\\.?(?:\\d+(?:_\\d+)*)?|\\.\\d+(?:_\\d+)*)(?:e[+-]?\\d+(?:_\\d+)*)?))${ua}$`,"i");function ya(o){let e=ch.exec(o);if(!e||o.includes(
"\uFEFF"))return;let[,t,s,n]=e,i=s?s[0].toLowerCase()==="n"?Number.NaN:1/0:Number(n.replaceAll("_",""));return t==="-"?-i:i}var{texts:va,scenario:ka}=S,A=class extends Error{constructor(e){super(ba(e)),this.name="InputError"}},Te=class extends A{},R=(o,e={})=>P(va[o],e),ne=o=>o!==null&&
typeof o=="object"&&!Array.isArray(o);function Se(o=()=>!1,e=""){return{said:[],above:e,float:o}}function C(o,e,t,s,n){let i=typeof t=="bigint"?String(t):oe(t,o.
float(e)),a=o.above+e||va.whole_scenario;o.said.push(R("finding",{path:a,shown:Ps(i),allowed:R(s,n)}))}function Oo(o,e,t,s){let{fields:n,place:i}=ka.models[o];if(!ne(
e))return C(s,t,e,"table"),null;for(let l of Object.keys(e))if(!Object.hasOwn(n,l))return s.said.push(Do(i,l,Object.keys(n))),null;let a=s.said.length,r={};for(let[
l,h]of Object.entries(n))h.kind!=="section"&&(Object.hasOwn(e,l)?r[l]=Fo(h,e[l],`${t}.${l}`,s):h.required?s.said.push(R("missing",{path:`${s.above}${t}.${l}`})):
r[l]=_t(h.default));return s.said.length===a?{values:r,given:new Set(Object.keys(e))}:null}function Do(o,e,t){let s=ha(e,t),n=s?R("did_you_mean",{close:s}):R("k\
nown_are",{known:t.join(", ")});return R("unknown_key",{path:`${o}${Ps(e)}`,hint:n})}function Fo(o,e,t,s){if(e===null&&o.nullable)return null;if(o.kind==="parts")
return uh(e,t,s);if(o.kind==="word")return o.options.includes(e)||C(s,t,e,"literal_error",o),e;let n=o.kind==="friction",i=n&&e==="inf"?1/0:e;if(typeof i!="numb\
er")return C(s,t,e,"number");if(n&&!(i>=0))return C(s,t,e,"friction");if(o.kind==="whole"&&!Number.isInteger(i))return C(s,t,e,"whole");if(!n&&!Number.isFinite(
i))return C(s,t,e,"finite_number");for(let[a,r]of o.limits??[])if(!dh(a,i,r))return C(s,t,o.kind==="whole"?BigInt(i):e,a,{limit:r});return o.range&&!Xe(o.range,
i)?C(s,t,e,"range",o.range):i+0}function dh(o,e,t){return o==="greater_than"?e>t:o==="greater_than_equal"?e>=t:o==="less_than"?e<t:e<=t}var Xe=({least:o,most:e,
also:t=[]},s)=>o<=s&&s<=e||t.some(n=>_t(n)===s);function uh(o,e,t){return Array.isArray(o)?o.map((s,n)=>mh(s,`${e}.${n}`,t)):C(t,e,o,"list")}function mh(o,e,t){
let s=Wo(o,"shape",ka.parts,e,t),n=s&&Oo(s,o,e,t);if(!n)return null;let{inner_radius:i,outer_radius:a}=n.values;return i>a&&t.said.push(R("ring_radii",{inner:i,
outer:a})),n.values}function Wo(o,e,t,s,n,i){if(!ne(o))return C(n,s,o,"table"),null;let a=Object.hasOwn(o,e)?o[e]:i;if(a===void 0||a===null&&i)return n.said.push(
R("missing",{path:`${n.above}${s}.${e}`})),null;if(typeof a=="string"&&Object.hasOwn(t,a))return t[a];let r=typeof a=="string"?a:oe(a,n.float(`${s}.${e}`)),l=Object.
keys(t).map(m=>`'${m}'`),h=`${l.slice(0,-1).join(", ")} or ${l.at(-1)}`,c=R("literal_error",{expected:h}),u={path:`${n.above}${s}.${e}`,shown:Ps(oe(r)),allowed:c};
return n.said.push(R("finding",u)),null}function Mt(o){let e=o.length-1;return e?R(e===1?"other_problem":"other_problems",{first:o[0].replace(/\.$/,""),count:e}):
o[0]}var{codes:ph,families:fh,massless:gh,hops:wh,rolls:bh,other:yh}=S.classes,{sequence:vh}=S.words,xa="sequence";function kh(o){let e=-1;for(let t of o){e^=t.charCodeAt(
0);for(let s=0;s<8;s++)e=e>>>1^(e&1?3988292384:0)}return~e>>>0}function _a(o,e){if(e!==xa)return ph[e]?.[o]??yh;let t=[...o].find(p=>"SK".includes(p))??"R",s=[o.
startsWith("R")&&"rolls",/[SK]/.test(o)&&"slips"].filter(Boolean).join(", "),n=o.endsWith("H")?wh:fh[t+o.slice(-1)]??bh,i=o.includes("M")?gh[s]:n,a=[1,3,5].map(
p=>Number.parseInt(i.slice(p,p+2),16)/255),r=(a[0]+a[1]+a[2])/3,l=Math.min(o.length-1,9)/9,h=kh(o)%1e3/1e3,c=.62-.62*Math.min(2*l,1),u=Math.max(2*l-1,0)*.5;return`\
#${a.map(p=>{let w=(1-.2*h)*p+.2*h*r,b=Math.min(Math.max((w+(1-w)*c)*(1-u),0),1);return Math.round(255*b).toString(16).padStart(2,"0")}).join("")}`}function Ta(o,e){
return e!==xa?o.replaceAll("_"," "):[...o].map(t=>vh[t]).join(" → ")}function J({duration:o,hoop:e,plane:t,start:s,contact:n}){let{radius:i,mass:a,eccentricity:r,inertia_ratio:l}=e,{gravity:h,slope:c,rolling_resistance:u,mu_static:m,
mu_kinetic:p,restitution:w,impact_law:b,painleve:g}=t,{x:f,height:k,angle:T,vx:E,vy:N,omega:I,slip:z}=Qe(s,i),{max_events:Q,model:Bs,...Lt}=n;return{radius:i,mass:a,
eccentricity:r,inertia_ratio:l,ideal:e.load_fraction!==null,gravity:h,slope:c,rolling_resistance:u,mu_static:m,mu_kinetic:p,restitution:w,impact_law:b,painleve:g,
x:f,height:k,angle:T,vx:E,vy:N,omega:I,slip:z,rolling:s.speed!==null,duration:o,max_events:Q,contact:Bs==="rigid"?null:Lt}}function Qe({x:o,height:e,angle:t,speed:s,
vx:n,vy:i,omega:a},r){let l=s===null?Number(a):s/r;return{x:o,height:e,angle:t,vx:n,vy:i,omega:l,slip:s===null?n-r*l:0}}var Sa=S.scenario.ends,$o=o=>Object.hasOwn(Sa,o)?Sa[o]:[];function Ho(o){let e=o.indexOf(".");return e<0?[o,""]:[o.slice(0,e),o.slice(e+1)]}function Et(o){for(let e of o){
let[t]=Ho(e),s=$o(e).map(n=>`${t}.${n}`);for(let n of o)if(s.some(i=>n===i||n.startsWith(`${i}.`)))return[e,n]}return null}var Ma=new Set(S.scenario.paths);function Ko(o){
if(!(Ma.has(o)||/^hoop\.parts\.\d+\.\w+$/.test(o)))throw new A(R("no_parameter",{path:o,known:[...Ma].join(", ")}))}function Ea(o){let[e,t]=Ho(o);return(e==="st\
art"?10:0)+(t===""?0:o==="contact.model"||o==="hoop.parts"?1:2)}var Uo=o=>e=>!o.some(t=>e===t||e.startsWith(t.endsWith(".")?t:`${t}.`));function Go(o,e,t,s){let n=[
...t.keys()],i=Et(n);if(i){let[l,h]=i,[c,u]=i.map(m=>new Le(oe(t.get(m),!1)));throw new A(R("two_ways",{one:l,other:h,one_value:c,other_value:u}))}let a=new Set,
r=Uo(n);for(let l of n.sort((h,c)=>Ea(h)-Ea(c))){let h=structuredClone(t.get(l)),[c,u]=Ho(l);if(u==="")Bo(e,c,h);else if(l==="contact.model")e.contact={model:h};else{
Object.hasOwn(e,c)||Bo(e,c,{});let m=e[c];if(!ne(m))throw new A(R("no_section_parts",{path:l,section:c}));if(!a.has(c)&&$o(l).some(p=>Object.hasOwn(m,p))){a.add(
c);let p=xh(o,l,()=>s(e.hoop,r));for(let[w,b]of Object.entries(p))t.has(`${c}.${w}`)||(m[w]=b)}for(let p of $o(l))delete m[p];_h(m,u.split("."),h,l)}}return e}function Bo(o,e,t){
Object.defineProperty(o,e,{value:t,enumerable:!0,configurable:!0,writable:!0})}function xh({hoop:o,plane:e,start:t},s,n){let{mass:i,eccentricity:a,inertia_ratio:r}=o;
if(s==="hoop.eccentricity"||s==="hoop.inertia_ratio")return{mass:i,eccentricity:a,inertia_ratio:r};if(s==="hoop.load_fraction")return{mass:i};if(s==="plane.mu_s\
tatic"||s==="plane.mu_kinetic"){let l=h=>h===1/0?"inf":h;return{mu_static:l(e.mu_static),mu_kinetic:l(e.mu_kinetic)}}if(s.startsWith("start.")&&s!=="start.speed"){
let{height:l,vx:h,vy:c,omega:u}=Qe(t,n().radius);return{height:l,vx:h,vy:c,omega:u}}return{}}function _h(o,e,t,s){let n=o,i=e.pop(),a=l=>new A(R("not_there",{path:s,
step:l})),r=l=>Array.isArray(n)&&/^\d+$/.test(l)&&Number(l)<n.length;for(let l of e)if(r(l))n=n[Number(l)];else if(ne(n)&&Object.hasOwn(n,l))n=n[l];else throw a(
l);if(ne(n))Bo(n,i,t);else if(r(i))n[Number(i)]=t;else throw a(i)}var Th=1e3;function Aa(o){let e=o.startsWith("?")?o.slice(1):o;if(e&&e.split("&").length>Th)throw new A(R("unreadable_query",{reason:"Max number of fields excee\
ded"}));let t=new Map;for(let[i,a]of new URLSearchParams(`&${e}`)){let r=i.split("."),l=r.pop(),h=t;for(let c of r)if(h.has(c)||h.set(c,new Map),h=h.get(c),!(h instanceof
Map))throw new A(R("beside_a_value",{path:i,above:i.slice(0,i.lastIndexOf("."))}));if(h.has(l))throw new A(R("given_twice",{path:i}));h.set(l,ya(a)??a)}let s=t.
get("hoop"),n=s instanceof Map&&s.get("parts");return n instanceof Map&&s.set("parts",Sh(n)),Vo(t)}function Sh(o){let e=Array.from({length:o.size},(s,n)=>String(
n)),t=new Set(e);for(let s of o.keys())if(!t.has(s))throw new A(R("parts_out_of_order",{name:s}));return e.map(s=>o.get(s))}function Vo(o){return Array.isArray(
o)?o.map(Vo):o instanceof Map?Object.fromEntries([...o].map(([e,t])=>[e,Vo(t)])):o}function za(o){return Ra(o,"").map(([e,t])=>`${e}=${Mh(e,t)}`).join("&")}function Ra(o,e){
return o===null||typeof o!="object"?[[e,o]]:Object.entries(o).flatMap(([t,s])=>Ra(s,e?`${e}.${t}`:t))}function Mh(o,e){return Is(o,e).replace("e+","e").replace(
/\.0$/,"")}function Is(o,e){return typeof e=="string"?e:Eh.has(o.slice(o.lastIndexOf(".")+1))?String(e):Ne(e)}var Eh=new Set(Object.values(S.scenario.models).flatMap(
({fields:o})=>Object.keys(o).filter(e=>o[e].kind==="whole")));var{scenario:et}=S,Ah=["load_fraction","eccentricity","inertia_ratio"],Pa=["mu_static","mu_kinetic"],zh=["height","vx","vy","omega"],je=class extends Error{};function L(o,e){
throw new je(R(o,e))}function Ls(o,e,t){let s=t.find(n=>n!==e);s&&L("together",{section:o,other:s,way:e})}function Jo({values:o,given:e},t){let s={...o},n=Ah.filter(
c=>e.has(c)&&o[c]!==null);s.parts!==null?(s.parts.length||L("no_parts"),Ls("hoop","parts",[...n,...e.has("mass")?["mass"]:[]]),Object.assign(s,Rh(s.radius,s.parts,
t))):s.load_fraction!==null||!n.length?(Ls("hoop","load_fraction",n),s.load_fraction??=et.models.Hoop.fields.eccentricity.default,s.eccentricity=s.load_fraction,
s.inertia_ratio=t.ideal(s.load_fraction)):n.length===1&&L("half_a_hoop",{missing:n[0]==="eccentricity"?"inertia_ratio":"eccentricity",given:n[0]});let{mass:i,inertia_ratio:a,
load_fraction:r,eccentricity:l}=s,h=et.ranges;if(Xe(h["hoop.mass"],i)||L("hoop_mass",{mass:i,words:h["hoop.mass"].words}),!Xe(h["hoop.inertia_ratio"],a)){let{words:c}=h["\
hoop.inertia_ratio"];L(s.parts?"parts_inertia":"load_inertia",{load_fraction:r,inertia_ratio:a,words:c})}return a===0&&l!==1&&L("massless_eccentricity",{eccentricity:l}),
s}function Rh(o,e,t){let{reaches:s,...n}=t.combine(o,e),i=s.findIndex(a=>a>o*(1+et.touch));return i>=0&&L("beyond_the_rim",{index:i,shape:e[i].shape,reach:s[i],
radius:o}),n}function Ia({values:o,given:e}){let t={...o};t.apart=Pa.some(r=>e.has(r)),t.mu!==null?(Ls("plane","mu",Pa.filter(r=>e.has(r))),t.mu_static=t.mu,t.mu_kinetic=
t.mu):t.mu_static===t.mu_kinetic&&(t.mu=t.mu_static);let{mu_static:s,mu_kinetic:n,slope:i}=t;n>s&&L("kinetic_above_static",{mu_kinetic:n,mu_static:s}),Math.abs(
i)<.5*Math.PI||L("vertical",{slope:i});let a=et.ranges["plane.slope"];return Xe(a,i)||L("slope",{slope:i,words:a.words}),t}function La({values:o,given:e}){let t={
...o};return t.speed!==null?(Ls("start","speed",zh.filter(s=>e.has(s))),t.vx=t.speed,t.omega=null):t.omega===null&&L("no_omega"),t}function Na({values:o}){let e=o;
return e.model==="compliant"&&e.damping!==null&&e.restitution!==null&&L("together",{section:"contact",other:"restitution",way:"damping"}),e}function qa(o,e,t){let{
hoop:s,plane:n,contact:i}=o,a=s.inertia_ratio===0,r=i.model==="compliant";a&&n.slope!==0&&L("massless_slope",{slope:n.slope});let l=n.rolling_resistance;l!==0&&
a&&L("massless_resistance",{given:l});let h=l===0?void 0:e.resistance?.(s.eccentricity,s.inertia_ratio);h!==void 0&&!(l<h)&&L("resistance",{given:l,most:h}),a&&
r&&L("massless_compliant"),r&&n.mu_static===1/0&&L("compliant_friction"),r&&e.compliance&&Ph(i,e.compliance(t(o)))}function Ph(o,e){for(let[n,{of:i,...a}]of Object.
entries(et.relative)){let r=o[n];if(r===null)continue;let l=e[n];Xe(a,l)||L("relative_contact",{name:n,value:r,relative:l,unit:i,words:a.words})}let{depth:t}=e,
s=_t(et.most_depth);t>s&&L("too_soft",{stiffness:o.stiffness,depth:t,most:s})}var{scenario:we}=S,Ih={rigid:"Rigid",compliant:"Compliant"};function Yo(o,e,t=Se()){let s=Zo(o,e,t);if(!s)throw new A(Mt(t.said));return s}function Zo(o,e,t){let{
fields:s,place:n}=we.models.Scenario;if(!ne(o))return C(t,"",o,"table"),null;let i=Object.keys(o).find(r=>!Object.hasOwn(s,r));if(i!==void 0)return t.said.push(
Do(n,i,Object.keys(s))),null;let a=Object.fromEntries(Object.keys(s).map(r=>{let l=Object.hasOwn(o,r)?o[r]:we.default[r];return[r,Ca(r,l,e,t)]}));return t.said.
length?null:Oa(t,()=>Xo(a,e))}function Ca(o,e,t,s){if(o==="hoop")return At("Hoop",e,o,s,i=>Jo(i,t));if(o==="plane")return At("Plane",e,o,s,Ia);if(o==="start")return At(
"Start",e,o,s,La);if(o!=="contact")return Fo(we.models.Scenario.fields[o],e,o,s);let n=Wo(e,"model",Ih,o,s,"rigid");return n&&At(n,e,o,s,Na)}function Xo(o,e){return qa(
o,e,J),o}function At(o,e,t,s,n){let i=Oo(o,e,t,s);return i&&Oa(s,()=>n(i))}function Oa(o,e){try{return e()}catch(t){if(!(t instanceof je))throw t;return o.said.
push(t.message),null}}function Qo(o,e){return Yo(Aa(o),e,Se(()=>!0))}function Ns(o,e,t){let s=Go(o,be(o),e,(n,i)=>Da(n,t,i));return Yo(s,t,Se(Uo([...e.keys()])))}
function qs(o,e,t){let s=Se();try{let n=Go(o,be(o),e,(r,l)=>Da(r,t,l)),a=[...new Set([...e.keys()].map(r=>r.split(".")[0]))].map(r=>[r,Ca(r,n[r],t,s)]);return s.
said.length?null:Object.fromEntries(a)}catch(n){if(n instanceof A)return null;throw n}}function Da(o,e,t){let s=Se(t),n=At("Hoop",o,"hoop",s,i=>Jo(i,e));if(!n)throw new A(
Mt(s.said));return n}var Lh=o=>o===1/0?"inf":o,zt=(o,e)=>Object.fromEntries(e.filter(t=>o[t]!==null).map(t=>[t,Lh(o[t])])),en=o=>Object.keys(we.models[o].fields);
function be({duration:o,hoop:e,plane:t,start:s,contact:n}){return{duration:o,hoop:Nh(e),plane:qh(t),start:jh(s),contact:zt(n,en(n.model==="rigid"?"Rigid":"Compl\
iant"))}}function Nh(o){if(o.parts){let t=o.parts.map(s=>zt(s,en(we.parts[s.shape])));return{radius:o.radius,parts:t}}let e=o.load_fraction===null?["eccentricit\
y","inertia_ratio"]:["load_fraction"];return zt(o,["radius","mass",...e])}function qh(o){let e=o.apart?["mu"]:["mu_static","mu_kinetic"];return o.rolling_resistance===
0&&e.push("rolling_resistance"),zt(o,en("Plane").filter(t=>!e.includes(t)))}function jh(o){return zt(o,o.speed===null?["x","height","angle","vx","vy","omega"]:[
"x","angle","speed"])}function tn(o,e){let{Hoop:t,Start:s}=we.models;if(o==="hoop"){let{radius:n,mass:i,eccentricity:a}=t.fields;return{radius:n.default,mass:i.
default,load_fraction:a.default}}return o==="plane"?we.default.plane:o==="start"?{...ja(s),speed:void 0}:ja(we.models[e==="compliant"?"Compliant":"Rigid"])}var ja=({
fields:o})=>Object.fromEntries(Object.entries(o).map(([e,t])=>[e,t.default??void 0]));function Pt(o){let e={};for(let[t,s]of Object.entries(be(o))){let n=we.default[t];
if(Rt(s,n))continue;if(!ne(s)){e[t]=s;continue}let i=tn(t,s.model),a=Object.entries(s).filter(([r,l])=>r==="model"||!Rt(i[r],l));e[t]=a.length?Object.fromEntries(
a):s}return za(e)}function Rt(o,e){if(o===e)return!0;if(o===null||e===null||typeof o!="object"||typeof e!="object")return!1;let t=Object.keys(o);return t.length===
Object.keys(e).length&&t.every(s=>Rt(o[s],e[s]))}var{lab:Ch,limits:tt}=S,Me=(o,e={})=>P(Ch[o],e);function js({scenario:o,query:e=null,changes:t=[]},s){let n=Se(),i=null;if(o!==void 0&&!ne(o)?C(n,"scenario",o,"\
table"):o!==void 0&&(i=Zo(o,s,{...n,above:"scenario."})),e!==null&&typeof e!="string"&&C(n,"query",e,"word"),Array.isArray(t)?n.said.push(...t.filter(r=>!Oh(r)).
map(Dh)):C(n,"changes",t,"list"),n.said.length)throw new A(Mt(n.said));(e!==null||!i)&&(i=Qo(e??"",s));let a=new Map;for(let[r,l]of t)Et([...a.keys(),r])&&(i=Ns(
i,a,s),a=new Map),a.set(r,l);return a.size?Ns(i,a,s):i}var Oh=o=>Array.isArray(o)&&o.length===2&&typeof o[0]=="string",Dh=o=>Me("not_a_pair",{change:new Le(St(o).
slice(0,60))});function Ce(o){let{duration:e,hoop:t,contact:s}=o;if(e>tt.duration)throw new Te(Me("too_long",{duration:e,most:tt.duration}));let n=t.parts?.length??
0;if(n>tt.parts)throw new Te(Me("too_many_parts",{parts:n,most:tt.parts}));return s.max_events<=tt.events?o:{...o,contact:{...s,max_events:tt.events}}}var Fh=8,{cell:sn,laws:Wh,events:$h,quantities:Cs}=S.map,Fa=({from:o,to:e,cells:t})=>Array.from({length:t},(s,n)=>o+(n+.5)*((e-o)/t));function on(o,{x:e,y:t}){if(Ko(
e.path),Ko(t.path),e.path===t.path)throw new A(Me("equal_axes",{path:e.path}));let s=e.cells*t.cells;if(s>S.limits.cells)throw new Te(Me("too_many_cells",{cells:s,
most:S.limits.cells}));if(o.contact.model!=="rigid")throw new A(Me("rigid_maps"));let n=Et([t.path,e.path]);if(n)throw new A(Me("two_axes",{one:n[0],other:n[1]}));
let{contact:i,...a}=Ce(o);return{...a,contact:{...i,max_events:Math.min(i.max_events,$h)}}}async function nn(o,{x:e,y:t},s,n){let i=Fa(e),a=Fa(t),r=Bh(o,e.path,
t.path)?Hh(o,{x:e,y:t},[i,a],s):(m,p)=>{let w=new Map([[t.path,a[p]],[e.path,i[m]]]);return qs(o,w,s)},l=i.length*a.length,h=new Float64Array(sn.length*l),c={...o},
u=performance.now();for(let m=0;m<a.length;m++){performance.now()-u>Fh&&(await new Promise(p=>setTimeout(p)),n?.throwIfAborted(),u=performance.now());for(let p=0;p<
i.length;p++){let w=r(p,m),b=w&&Uh(Object.assign(c,w),s);if(!b)continue;let g=m*i.length+p;for(let f=0;f<sn.length;f++)h[f*l+g]=Kh[f](b)}}return{count:l,rows:h}}
function Bh({start:o},e,t){let s=[e,t].map(i=>i.split(".")[0]);if(s[0]===s[1])return!1;let n=[e,t].some(i=>i.startsWith("start.")&&i!=="start.speed");return!(s.
includes("hoop")&&n&&o.speed!==null)}function Hh(o,{x:e,y:t},[s,n],i){let a=s.map(l=>qs(o,new Map([[e.path,l]]),i)),r=n.map(l=>qs(o,new Map([[t.path,l]]),i));return(l,h)=>a[l]&&
r[h]&&{...a[l],...r[h]}}var Kh=sn.map(o=>o==="law"?({impact_law:e})=>Wh[e]:o==="strike"?({painleve:e})=>+(e==="impact"):o==="allowed"?()=>1:e=>Number(e[o]));function Uh(o,e){
try{return J(Xo(o,e))}catch(t){if(!(t instanceof je))throw t;return null}}function an(o){if(Object.hasOwn(Cs,o))return Cs[o].span;throw new A(`what = ${o} must \
be one of ${Object.keys(Cs).join(", ")}.`)}function rn({x:o,y:e,what:t},s){let{label:n,unit:i,words:a}=Cs[t],{values:r,names:l}=Gh(s,i===""?a:null),h=i===""?l.map(
c=>({name:c,text:Ta(c,t),color:_a(c,t)})):null;return{header:{x:o,y:e,what:t,label:n,unit:i,classes:h},arrays:{values:r}}}function Gh({values:o,sequences:e},t){
if(!t)return{values:o,names:[]};let s=e?[...e].sort((a,r)=>a.length-r.length||(a<r?-1:a>r?1:0)):t,n=e?.map(a=>s.indexOf(a));return{values:Float64Array.from(o,a=>a>=
0?n?.[a]??a:Number.NaN),names:s}}var{scenario:Ds}=S,Vh=30;function Wa(o,e){for(let t of Ds.sections[o]??["Scenario"]){let s=Ds.models[t].fields[e];if(s)return s.unit}return""}function Ba(o,e){return e===
"inf"?"inf":typeof e=="string"?JSON.stringify(e):Is(o,e)}function $a(o,e,t){let s=`${o} = ${Ba(o,e)}`;return t===""||t==="1"?s:`${s.padEnd(Vh)} # ${t}`}function Fs(o){
let{duration:e,...t}=be(o),s=[$a("duration",e,Wa("","duration"))];for(let[n,i]of Object.entries(t)){s.push("",`[${n}]`);for(let[a,r]of Object.entries(i))if(!Array.
isArray(r))s.push($a(a,r,Wa(n,a)));else{s.push(`${a} = [`);for(let l of r){let h=Object.entries(l).map(([c,u])=>`${c} = ${Ba(c,u)}`);s.push(`  { ${h.join(", ")}\
 },`)}s.push("]")}}return`${s.join(`
`)}
`}var Jh={hoop:"Hoop",plane:"Plane",start:"Start"},Yh=["load_fraction","mu"];function ln(o){let e=be(o),t=Rt(e.contact,Ds.default.contact)?"":`    contact=${Os(
"contact",e.contact)},
`;return[`import hophoop as hh

`,`motion = hh.simulate(
`,`    ${Os("hoop",e.hoop)},
`,`    ${Os("plane",e.plane)},
`,`    ${Os("start",e.start)},
`,`    duration=${hn("duration",e.duration)},
`,t,`)
`,`print(motion.sequence, motion.status)
`,`for event in motion.events:
`,`    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")
`].join("")}function Os(o,{parts:e,...t}){let s=o==="start"&&"speed"in t,n=s?"Start.rolling":Jh[o]??(t.model==="rigid"?"Rigid":"Compliant"),i=s?{angle:0,x:0}:tn(
o,t.model),a=Object.entries(t).filter(([r,l])=>Yh.includes(r)||i[r]!==l).map(([r,l])=>`${r}=${hn(r,l)}`);return e&&a.push(`parts=[${e.map(Zh).join(", ")}]`),`hh\
.${n}(${a.join(", ")})`}function Zh({shape:o,...e}){let t=Object.entries(e).map(([s,n])=>`${s}=${hn(s,n)}`);return`hh.${Ds.parts[o]}(${t.join(", ")})`}function hn(o,e){
return e==="inf"?'float("inf")':typeof e=="string"?oe(e):Is(o,e)}var{letters:Ka,modes:dn,verbs:un,events:Xh,statuses:Qh,story:Oe,summary:st}=S.words,ec=["turn","apex","end"],tc=400,[,cn,Ha,sc,oc]=dn,nc="⁰¹²³⁴⁵⁶⁷⁸⁹";
function Ua(o,e){let{omega:t,to:s}=o[e];return t===0&&(s==="S"||s==="K")&&e+1<o.length}var mn=o=>[...o.keys()].filter(e=>Ua(o,e)),pn=(o,e)=>.5*(o[e].t+o[e+1].t);
function fn(o,e=tc){let t=[],s=0,n=Va(o.events);for(let[i,a]of o.events.entries()){let r=n.get(i);if(r===0)continue;let l=r===void 0?ac(o,i,a):P(Oe.more_bounces,
{count:r});if(l){if(t.length>=e){s++;continue}t.push({t:a.t,event:i,mode:Ka[dn.indexOf(Ws(o,i))],text:l})}}return s&&t.push({...t[t.length-1],text:P(Oe.left_out,
{count:s})}),t}var Ga=o=>o.kind==="impact"&&o.to==="H"&&o.collision!==!1;function Va(o,e=3,t=6){let s=new Map,n=[];for(let i=0;i<=o.length;i++){let a=o[i];if(a&&
(Ga(a)||n.length&&a.kind==="apex")){n.push(i);continue}let r=n.filter(l=>o[l].kind==="impact");if(r.length>=t){for(let l of n.slice(n.indexOf(r[e])))s.set(l,0);
s.set(r[e],r.length-e)}n=[]}return s}function gn(o,e=6){let t=[],s=0,n=Va(o.events,1);for(let[l,h]of o.events.entries()){let c=n.get(l);if(c!==void 0){c&&t.push(
P(st.more_bounces,{count:c}));continue}if(h.kind==="start"||!t.length){t.push(un[Ws(o,l)]);continue}let u=ic(o,l,h);u&&(s++,s<=e&&t.push(P(st.change,{phrase:u,where:Fe(
h.angle)})))}let i=s>e?P(st.more_changes,{count:s-e}):"",a=t.join(", ").replaceAll(", and "," and ")+i,r={phrases:a.slice(0,1).toUpperCase()+a.slice(1),ending:Qh[o.
status]};return P(st.sentence,r).trim()}function ic(o,e,t){return t.collision===!1?st.without_collision:Ga(t)?st.bounces:["slip_start","slip_reversal"].includes(
t.kind)||Ja(t)?un[Ws(o,e)]:ec.includes(t.kind)?"":Xh[t.kind]}function ac(o,e,t){let s=Ws(o,e),n={where:Fe(t.angle),verb:un[s],kind:t.kind.replaceAll("_"," ")},i=rc(
o.events,e,s,n);return P(Oe[i]??Oe.other,n)}function rc(o,e,t,s){let n=o[e],{kind:i}=n;return i==="start"&&(s.speed=De(n.vx),s.started=P(t===sc?Oe.started_flight:
t===oc?Oe.started_skim:Oe.started,s)),i==="slip_start"&&t===cn?"slip_start_spin":i==="takeoff"?lc(o,e,s):i==="impact"?(s.speed=De(n.before.vy===null?null:Math.abs(
n.before.vy)),n.collision===!1?"impact_without_collision":n.to==="H"?"impact_bounce":i):i==="turn"&&Ja(n)?"turn_in_slip":(i==="apex"&&(s.gap=Ya(n.height)),i==="\
kane_gain"&&(s.gain=De(n.gain)),i==="rest"&&n.stable===!1?"rest_unstable":i)}function lc(o,e,t){let{t:s}=o[e],n=0;for(let i=e;i<o.length;i++)if(n=Math.max(n,o[i].
height),!(i===e||o[i].kind!=="impact")){for(let a=i+1;a<o.length&&o[a].t<=o[i].t;a++)n=Math.max(n,o[a].height);if(!n)break;return t.top=Ya(n),t.time=De(o[i].t-s),
"takeoff_and_landing"}return"takeoff"}function Ws(o,e){let t=o.events[e];return hc(t.to,Ua(o.events,e)?o.omega(e):t.omega)}function hc(o,e){return o==="S"?e>0?cn:
Ha:o==="K"?e<0?cn:Ha:dn[Ka.indexOf(o)]}var Ja=o=>o.kind==="turn"&&(o.to==="S"||o.to==="K"),Fe=o=>`${Co(o*(180/Math.PI),1)}°`.replaceAll("-","−");function Ya(o){
return o>=.995?`${De(o)} m`:o>=.00995?`${De(o*100)} cm`:`${De(o*1e3)} mm`}function De(o){if(o===null||Number.isNaN(o))return"?";let[e,t]=qe(o,3).split("e"),s=t===
void 0?"":`·10${cc(Number(t))}`;return`${e}${s}`.replaceAll("-","−")}var cc=o=>[...String(o)].map(e=>e==="-"?"⁻":nc[Number(e)]).join("");var Za=2e3,dc=o=>o===1/0?"inf":o;function $s(o,{status:e,sequence:t,events:s,final:n,energy:i}){let{schema:a,setup:r}=S;return{schema:a,version:r.version,scenario:be(
o),status:e,sequence:t,events:s,final:n,energy:i}}function wn(o,e,t,s){let n={events:e.events,status:e.status,omega:t};return{...$s(o,e),events:e.events.slice(0,
Za),query:Pt(o),duration:e.duration,values:uc(o),automatic:mc(o,s),massless:o.hoop.inertia_ratio===0,summary:gn(n),story:fn(n),ending:S.words.statuses[e.status],
shortened:e.events.length>Za}}function uc(o){let{speed:e}=o.start,t={...o,start:{...Qe(o.start,o.hoop.radius),speed:e}},s=n=>{let[i,a]=n.split(".");return dc(t[i][a])};
return Object.fromEntries(S.shown.map(n=>[n,s(n)]))}function mc(o,e){if(o.contact.model==="rigid"||!e.compliance)return{};let{stiffness:t,slip_speed:s}=e.compliance(
J(o)).automatic;return{"contact.stiffness":t,"contact.slip_speed":s,"contact.restitution":o.plane.restitution}}var{rate:pc,variables:bn}=S.table,{letters:fc}=S.words,yn=(o,e)=>JSON.stringify($s(o,e),null,1);function vn(o){let e=Math.min(Math.max(Math.floor(o*pc)+1,2),S.limits.
samples),t=o/(e-1);return Float64Array.from({length:e},(s,n)=>n===e-1?o:n*t)}function kn(o,e){let t=Object.keys(bn),s=t.map(l=>bn[l]==="1"?l:`${l} [${bn[l]}]`),
{kinetic:n,potential:i}=e,a={...e,total:Float64Array.from(n,(l,h)=>l+i[h])},r=[["t [s]",...s].join(",")];for(let[l,h]of o.entries()){let c=t.map(u=>u==="mode"?fc[a.
mode[l]]:Ne(a[u][l]));r.push([Ne(h),...c].join(","))}return`${r.join(`\r
`)}\r
`}var{theory:O}=S.words;function _n({hoop:o,plane:e},t){let s=[],n=(r,l,h,c)=>{l!==null&&s.push({key:r,label:O[r],value:Number.isFinite(l)?l:null,unit:h,text:c(l)})},
i=()=>n("painleve",t.painleve_friction,"1",r=>wc(r,t,e));if(e.gravity<=0)return i(),s;if(o.inertia_ratio===0){let r=t.massless_loss_by_friction?O.loss_by_friction:
O.loss_of_contact;return n("loss",t.massless_loss_angle,"rad",l=>P(r,{where:Fe(l)})),s}if(e.slope>=0){let{would_slip:r,would_hop:l,would_hop_at_once:h,any_push:c,
any_speed:u}=O;n("first_slip",t.first_slip_speed,"m/s",m=>xn(m,r,c)),n("first_hop",t.first_hop_speed,"m/s",m=>xn(m,l,c)),n("immediate_hop",t.immediate_hop_speed,
"m/s",m=>xn(m,h,u))}else s.push({key:"uphill",label:O.uphill,value:null,unit:"",text:O.no_threshold});n("needed_friction",t.needed_friction,"1",r=>gc(r,e)),i();
let a=t.jam_angles.map(Fe).join(", ");return n("jam",t.jam_angles[0]??null,"rad",()=>P(O.jam_at,{places:a})),o.eccentricity>0&&n("rest",t.stable_angle,"rad",r=>P(
O.rest_at,{where:Fe(r)})),s}function xn(o,e,t){return o<S.words.least_speed?P(t,{would:e}):Number.isFinite(o)?P(O.above,{would:e,speed:qe(o,4)}):O.no_speed}function gc(o,{
mu_static:e}){return Number.isFinite(o)?P(o<=e?O.friction_enough:O.friction_short,{mu:qe(o,3)}):O.no_friction}function wc(o,{painleve_angle:e},{mu_kinetic:t}){if(e===
null)return O.never;let s=o<=t?O.paradox_here:O.paradox_not_here;return P(s,{mu:qe(o,3),where:Fe(e)})}var yc=360,vc=240,kc=[0,2*Math.PI,-12,12],Tn={"motion.toml":"application/toml","motion.csv":"text/csv; charset=utf-8","motion.json":"application/json"},xc=["mot\
ion.nc","motion.mp4","motion.gif"],It=class{constructor(e,t,{base:s=null,server:n=null}={}){this.kernel=e,this.mechanics=t,this.base=s,this.server=n,this.shares=
s!==null,this.files=[...Object.keys(Tn),...n?xc:[]]}async call(e,t,s){if(s?.throwIfAborted(),e==="setup")return{header:S.setup,arrays:{}};let n=js(t,this.mechanics);
if(e==="film")return this.film(n,s);if(e==="samples"){let i=J(Ce(n));return{header:{window:t.window},arrays:await this.kernel.columns(i,s,t.window)}}if(e==="cod\
e")return{header:{python:ln(n),toml:Fs(n)},arrays:{}};if(e==="theory"){let i=await this.kernel.thresholds(J(n),s);return{header:{thresholds:_n(n,i)},arrays:{}}}
if(e==="regions"){let i=t.window??kc,a=J(n),r=await this.kernel.regions(a,i,yc,vc,s);return{header:{window:i},arrays:r}}if(e==="map")return this.map(n,t,s);throw new A(
`call = '${e}' is not one that the page answers.`)}async film(e,t){let s=J(Ce(e)),{motion:n,columns:i}=this.kernel.film?await this.kernel.film(s,t):{motion:await this.
kernel.motion(s,t),columns:await this.kernel.columns(s,t)};if(n.doubt&&this.server)return this.server.call("film",{query:Pt(e)},t);let a=await this.turning(s,n,
t);return{header:wn(e,n,a,this.mechanics),arrays:i}}async turning(e,{events:t},s){let n=mn(t);if(!n.length)return()=>0;let i=Float64Array.from(n,r=>pn(t,r)),{omega:a}=await this.
kernel.samples(e,i,s);return r=>a[n.indexOf(r)]}async map(e,{x:t,y:s,what:n="sequence"},i){let a=an(n),r=on(e,{x:t,y:s,what:n}),l=await nn(r,{x:t,y:s},this.mechanics,
i);return rn({x:t,y:s,what:n},await this.kernel.map(l,n,a,i))}async file(e,t){if(!(e in Tn)){if(this.server)return this.server.file(e,t);throw new A(`${e} needs\
 Python: run hophoop lab.`)}return new Blob([await this.fileText(e,t)],{type:Tn[e]})}async fileText(e,t){let s=js({query:t},this.mechanics);if(e==="motion.toml")
return Fs(s);let n=Ce(s),i=J(n),a=await this.kernel.motion(i);if(e==="motion.json")return yn(n,a);let r=vn(a.duration);return kn(r,await this.kernel.samples(i,r))}link(e,t){
return this.base&&`${new URL(e?`?${e}`:"",this.base)}${t}`}};async function Sn(o,e,t){let s=e&&new is(e);try{let n=await xt.load(o);return new It(n,n.mechanics,{base:t,server:s})}catch(n){if(s)return s;throw n}}function Xa(o){
navigator.serviceWorker?.register(o).catch(()=>{})}async function Qa(o){let e=new as(o);try{let t=await xt.unpack(o.get("module"),o.get("worker"));return new It(
t,t.mechanics,{server:e})}catch{return e}}var _c=new URL("./",import.meta.url);async function Tc(o){let e=new URL("./",document.baseURI.split(/[?#]/)[0]),t=document.querySelector("meta[name=hophoop-site\
]"),s,n;try{s=await Sn(_c,t?null:e,e),n=(await s.call("setup",{})).header}catch(l){o.textContent=l.message;return}t&&Xa(t.getAttribute("content")??"");let i=new Je(
o,s,n,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let a=new URLSearchParams(location.hash.slice(1)).get("with"),r=Gn(location.hash);try{await i.open([
location.search.slice(1),...a===null?[]:[a]],r)}catch(l){history.replaceState(null,"",e),await i.open([""]),i.notice.fail(l)}}async function Yg(o,e,t,s){let n=await Sn(
e,null,new URL("../",e)),{header:i}=await n.call("setup",{}),a=new Je(o,n,i,{panels:s});return await a.open([t]),a}async function Sc({model:o,el:e}){let t=document.
createElement("div");e.append(t);let s=await Qa(o),n=new Je(t,s,o.get("setup"),{panels:o.get("panels"),onmotion:a=>{o.get("query")!==a&&(o.set("query",a),o.save_changes())}});
n.motions.set([He(o.get("film"))]),n.begin();let i=()=>n.motions.replace(He(o.get("film")));return o.on("change:film",i),()=>{o.off("change:film",i),s.close?.(),
n.close()}}var er=document.getElementById("hophoop-lab");er&&Tc(er);var Zg={render:Sc};export{Zg as default,Yg as mount};
