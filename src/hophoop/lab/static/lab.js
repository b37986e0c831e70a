/* Built from web/lab/main.js by esbuild 0.28.2; sources 8dda6340007e55a9fe4536fcb9466212 */
function Z(i){let e=Number.parseInt(i.slice(1,7),16);return[e>>16&255,e>>8&255,e&255]}var bs=i=>xe(i)>.2?"#111111":"#ffffff",Te=(i,e)=>`rgba(${Z(i).join(",")},${e}\
)`,Go=i=>{let e=i/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4};function xe(i){let[e,t,s]=Z(i).map(Go);return .2126*e+.7152*t+.0722*s}function _e(i,e){if(!e||
!/^#[0-9a-f]{6}$/i.test(i))return i;if(xe(i)<.002)return"#eceef2";let t=i;for(let s=0;xe(t)<.2&&s<1;s+=.05)t=`#${Z(i).map(o=>Math.round(o+(255-o)*s).toString(16).
padStart(2,"0")).join("")}`;return t}var je=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function Vo(){let i=[];for(let e=0;e<
256;e++){let t=e/255*(je.length-1),s=Math.min(Math.floor(t),je.length-2),o=Z(je[s]),a=Z(je[s+1]);i.push(o.map((n,r)=>Math.round(n+(a[r]-n)*(t-s))))}return i}var me=Vo(),
He=me.map(i=>`rgb(${i.join(",")})`);var ys={roll:"Rollen",spin:"Durchdrehen",skid:"Rutschen",flight:"Flug",skim:"Streifen",hop:"Hüpfer","slip −":"Schlupf −","slip +":"Schlupf +",rolls:"rollt",
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
: alles","A full, B dotted; numbers and colours of {hoop}; {hands}":"A durchgezogen, B gepunktet; Zahlen und Farben von {hoop}; {hands}","{name} from {low} to {\
high}":"{name} von {low} bis {high}","Diagram: {title} in {unit}.":"Diagramm: {title} in {unit}.","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"{na\
me} [{unit}]","angle within a turn":"Winkel innerhalb einer Umdrehung","place of the centre":"Ort des Mittelpunkts","gap under the rim":"Spalt unter dem Rand","\
height of the centre of gravity":"Höhe des Schwerpunkts","speed of the centre":"Geschwindigkeit des Mittelpunkts","speed of rotation":"Umfangsgeschwindigkeit",
"speed away from the plane":"Geschwindigkeit weg von der Ebene","slip velocity":"Schlupfgeschwindigkeit","angular velocity":"Winkelgeschwindigkeit","normal forc\
e":"Normalkraft","friction force":"Reibungskraft","use of friction":"Ausnutzung der Reibung","kinetic energy":"kinetische Energie","potential energy":"potenziel\
le Energie","total energy":"Gesamtenergie","Plane of θ and θ̇":"Ebene von θ und θ̇","Plane of angle and angular velocity with the regions of rolling, slip\
 and flight":"Ebene von Winkel und Winkelgeschwindigkeit mit den Gebieten von Rollen, Schlupf und Flug","angle θ within a turn [°]":"Winkel θ innerhalb einer \
Umdrehung [°]","no answer":"keine Antwort","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"Farben: die \
Phase, die auf Kontakt ohne Schlupf folgt. Schraffiert: Schlupf, der auf das Painlevé-Paradoxon trifft.","Tap to go there, two fingers zoom.":"Tippen: dorthin \
gehen; zwei Finger vergrößern.","Click to go there; two fingers zoom.":"Tippen: dorthin gehen; zwei Finger vergrößern.","Click to go there; once clicked, or\
 with Ctrl, the wheel zooms; double-click for all.":"Klicken: dorthin gehen; nach einem Klick oder mit Strg zoomt das Rad; Doppelklick: alles.",Map:"Karte",of:"\
von",Across:"Waagerecht",Up:"Senkrecht","What the map shows":"Was die Karte zeigt","Map of motions":"Karte der Bewegungen","Map of motions. Arrow keys move the \
mark, Enter takes the motion, plus and minus zoom.":"Karte der Bewegungen. Pfeiltasten bewegen die Marke, Eingabe übernimmt die Bewegung, Plus und Minus zoomen.",
"Zoom into the map":"In die Karte hineinzoomen","Zoom out of the map":"Aus der Karte herauszoomen","Whole map":"Ganze Karte","Click to take that motion into the\
 player; two fingers zoom.":"Tippen übernimmt die Bewegung in den Abspieler; zwei Finger vergrößern.","Click to take that motion into the player; once clicke\
d, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Ein Klick übernimmt die Bewegung in den Abspieler; nach einem Klick oder mit Strg zoomt \
das Rad; Ziehen verschiebt; Doppelklick: alles.","computing {count} motions …":"{count} Bewegungen werden berechnet …","{count} motions":"{count} Bewegungen",
"{count} motions, with rigid contact":"{count} Bewegungen, mit starrem Kontakt","of rolling starts, though this motion starts otherwise":"rollender Starts, obwo\
hl diese Bewegung anders beginnt","of starts in any state, though this motion starts rolling":"aus beliebigem Zustand, obwohl diese Bewegung rollend beginnt","c\
ompiling the kernel of maps, this once: {done} of {all} functions":"der Rechenkern der Karten wird einmalig übersetzt: {done} von {all} Funktionen",Keep:"Behal\
ten","Copy the link":"Link kopieren","Scenario (TOML)":"Szenario (TOML)","States (CSV)":"Zustände (CSV)","Motion (netCDF)":"Bewegung (netCDF)","Events (JSON)":"\
Ereignisse (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Bild (PNG)","Record a film here (WebM)":"Hier einen Film aufnehmen (WebM)","Show me the Python":"D\
as Python dazu zeigen","The same motion in Python":"Dieselbe Bewegung in Python","The link is copied.":"Der Link ist kopiert.","The link to this motion":"Der Li\
nk zu dieser Bewegung","The film is being made; this takes a while …":"Der Film wird gemacht; das dauert eine Weile …","Fetching {name} …":"{name} wird ge\
holt …","{name} is there.":"{name} ist da.","This browser cannot record a canvas; take the MP4 instead.":"Dieser Browser kann die Zeichenfläche nicht aufnehme\
n; nimm stattdessen das MP4.","Recording one run …":"Ein Durchlauf wird aufgenommen …","The film is there.":"Der Film ist da.","The scenario as a file":"Das\
 Szenario als Datei",Copy:"Kopieren",Copied:"Kopiert",Close:"Schließen","A ring with a load on its rim rolls on a plane. Friction can only hold so much, and th\
e plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"Ein Ring mit einer Last \
am Rand rollt auf einer Ebene. Reibung hält nur begrenzt, und die Ebene kann nur drücken: Also gleitet er, hüpft, landet – oder tut etwas, das die Mechanik star\
rer Körper nicht entscheiden kann. Bewege einen Regler und sieh zu.",Modes:"Phasen","Marks on the bar of time":"Zeichen auf der Zeitleiste",Keys:"Tasten",space:"\
Leertaste","play, pause":"abspielen, anhalten","one frame":"ein Bild","Shift ← →":"Umschalt ← →","previous, next event":"voriges, nächstes Ereignis","n\
ext flight, landing":"nächster Flug, nächste Landung","slower, faster":"langsamer, schneller","Home End":"Pos1 Ende","start, end":"Anfang, Ende","traces, forc\
es, rim speed, whole path":"Spuren, Kräfte, Randgeschwindigkeit, ganzer Weg","in space":"im Raum","zoom, zoom back":"zoomen, zurück","leave a field, a menu, a\
 picture that the wheel zooms":"ein Feld, ein Menü, ein Bild verlassen, das das Rad zoomt","z y  Ctrl Z":"z y  Strg Z","undo, redo":"rückgängig, wiederholen",
"dark, light":"dunkel, hell",Python:"Python","the rim does not slide":"der Rand gleitet nicht","slip: the rim turns too fast for the way it goes (slip −, for a \
hoop that rolls ahead)":"Schlupf: Der Rand dreht sich zu schnell für seinen Weg (Schlupf −, wenn der Reifen vorwärts rollt)","slip: the rim slides ahead (sl\
ip +, for a hoop that rolls ahead)":"Schlupf: Der Rand gleitet voraus (Schlupf +, wenn der Reifen vorwärts rollt)","the hop: from take-off to landing":"der Hüp\
fer: vom Abheben bis zur Landung","a massless rim that touches without force":"ein masseloser Rand, der ohne Kraft berührt","take-off, landing":"Abheben, Landu\
ng","Painlevé’s paradox: no solution, several":"Painlevé-Paradoxon: keine Lösung, mehrere","bounces without number end":"unzählige Sprünge enden","skimmi\
ng begins, rest":"Streifen beginnt, Ruhe","Single keys (letters, digits, signs) do what the table says":"Einzelne Tasten (Buchstaben, Ziffern, Zeichen) tun, was\
 die Tabelle sagt","The hoop in your hand":"Der Reifen in der Hand","Slope of the plane":"Neigung der Ebene","Tilt the plane: drag, or arrow keys":"Ebene neigen\
: ziehen oder Pfeiltasten","The hoop: height and speed":"Der Reifen: Höhe und Geschwindigkeit","Lift, roll or throw the hoop: drag, or arrow keys":"Reifen hebe\
n, rollen oder werfen: ziehen oder Pfeiltasten","Angle of the load":"Winkel der Last","Turn the load: drag, or arrow keys":"Last drehen: ziehen oder Pfeiltasten",
"gap {height}, speed {speed} m/s":"Spalt {height}, Geschwindigkeit {speed} m/s",Repeat:"Wiederholen","Slow motion: a tenth of the speed":"Zeitlupe: ein Zehntel \
des Tempos","Sound of the contact":"Klang des Kontakts","Presentation on the whole screen":"Vorführung auf dem ganzen Bildschirm","Guided visit":"Geführter Bes\
uch","Table of the motion":"Tabelle der Bewegung","Table of the motion, rows":"Tabelle der Bewegung, Zeilen",Presentation:"Vorführung","For teachers":"Für Lehr\
kräfte",Table:"Tabelle",Every:"Alle","Save as CSV":"Als CSV speichern",Columns:"Spalten","The first {count} rows.":"Die ersten {count} Zeilen.",Challenges:"Her\
ausforderungen","Leave the challenges":"Herausforderungen verlassen","Which challenge":"Welche Herausforderung",Score:"Punkte","Begin again":"Von vorn beginnen",
"Show a best one":"Eine beste zeigen","{stars} {points} points. {what}":"{stars} {points} Punkte. {what}","Your best: {points} points.":"Deine beste: {points} P\
unkte.","Hop highest":"Am höchsten hüpfen","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. How high can t\
he hoop rise within 6 s?":"Auf ebenem Boden, rollend, mit höchstens 3,1 m/s: Du wählst die Last, wo sie beginnt, und die Reibung. Wie hoch kann der Reifen in 6 \
s steigen?","Land upright":"Aufrecht landen","Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high\
.":"Lass den Reifen so landen, dass seine Last ganz oben ist. Alles ist erlaubt; der erste Hüpfer muss mindestens 5 cm hoch sein.","Hop without skidding":"Hüpf\
en ohne Rutschen","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not\
 skid; to spin is allowed. How high does it hop?":"Auf ebenem Boden beginnt der Reifen zu rollen, die Last unten, mit höchstens 10 m/s, und μ ist höchstens 1,5.\
 Vor dem Hüpfer darf er nicht rutschen; durchdrehen darf er. Wie hoch hüpft er?","Rigid contact only.":"Nur starrer Kontakt.","The plane must be level.":"Die \
Ebene muss waagerecht sein.","It must be on Earth.":"Es muss auf der Erde sein.","Restitution must be 0.":"Die Stoßzahl muss 0 sein.","The radius must stay 1 m\
, without parts.":"Der Radius muss 1 m bleiben, ohne Teile.","At most 90 % of the mass may be in the load.":"Höchstens 90 % der Masse dürfen in der Last sein.",
"The hoop must be given by its load fraction.":"Der Reifen muss durch den Massenanteil der Last gegeben sein.","It must start rolling.":"Er muss rollend beginne\
n.","At most 10 m/s.":"Höchstens 10 m/s.","At most 3.1 m/s.":"Höchstens 3,1 m/s.","At most 6 s.":"Höchstens 6 s.","It does not hop.":"Er hüpft nicht.","It r\
ises by {height}.":"Er steigt um {height}.","The first hop is too low.":"Der erste Hüpfer ist zu niedrig.","It lands {off} away from the top.":"Er landet {off}\
 neben der höchsten Stelle.","The load must start at the bottom.":"Die Last muss unten beginnen.","Friction must be at most 1.5.":"Die Reibungszahl darf höchst\
ens 1,5 sein.","It skids before it hops.":"Er rutscht, bevor er hüpft.","New here?":"Neu hier?","Eight short questions: guess, then play.":"Acht kurze Fragen: \
erst raten, dann abspielen.","Start the visit":"Besuch beginnen","Not now":"Jetzt nicht","The hoop, before it is let go.":"Der Reifen, bevor er losgelassen wird\
.",Play:"Abspielen",Next:"Weiter",Back:"Zurück",Done:"Fertig","Step {number} of {all}":"Schritt {number} von {all}","Leave the visit":"Besuch verlassen","First\
 say what you expect, then play.":"Sag erst, was du erwartest, dann spiel ab.","Your guess":"Dein Tipp","{points} of 100 points.":"{points} von 100 Punkten.","Y\
ou have {sum} of {most} points.":"Du hast {sum} von {most} Punkten.","{what} with the load at {angle}":"{what} mit der Last bei {angle}","Draw the curve: pull t\
he points up and down":"Zeichne die Kurve: zieh die Punkte auf und ab","Littlewood’s question":"Littlewoods Frage","A hoop without mass has a weight on its ri\
m. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the weight is level with the centre.":"Ein R\
eifen ohne Masse trägt ein Gewicht am Rand. Mit dem Gewicht oben bekommt er den kleinsten Stoß und rollt. J. E. Littlewood fragte 1953, was geschieht, wenn das \
Gewicht auf der Höhe des Mittelpunkts ist.","What do you think?":"Was meinst du?","It rolls on.":"Er rollt weiter.","It hops: the hoop leaves the plane.":"Er h\
üpft: Der Reifen verlässt die Ebene.","The weight falls freely, and the hoop skims the plane below it.":"Das Gewicht fällt frei, und der Reifen streift darunt\
er die Ebene.","At {angle} there is no contact force any more.":"Bei {angle} gibt es keine Kontaktkraft mehr.","Littlewood said that the hoop hops. But the cont\
act force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim.":"Littlew\
ood sagte, der Reifen hüpfe. Doch die Kontaktkraft ist null, nicht nach oben gerichtet: Das Gewicht fällt frei, und ein Rand ohne Masse folgt ihm die Ebene entl\
ang. Zum Hüpfen braucht ein Reifen etwas Masse im Rand.","A ring with mass":"Ein Ring mit Masse","Now a quarter of the mass is in the ring. Again the load is a\
t the top, and the hoop gets the smallest push.":"Jetzt steckt ein Viertel der Masse im Ring. Wieder ist die Last oben, und der Reifen bekommt den kleinsten Sto\
ß.","Draw how fast the hoop’s centre goes during the first turn.":"Zeichne, wie schnell der Mittelpunkt in der ersten Umdrehung ist.","Speed of the centre":"\
Geschwindigkeit des Mittelpunkts","With the load at the bottom the centre has {speed} m/s.":"Mit der Last unten hat der Mittelpunkt {speed} m/s.","The lowest po\
int of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: it is faster than a stone that \
falls from the same height.":"Der tiefste Punkt eines rollenden Reifens ruht. Dort hat die Last keine kinetische Energie, und der leichte Ring hat alles, was di\
e schwere Last verloren hat: Er ist schneller als ein Stein, der aus derselben Höhe fällt.","Why it slips":"Warum er gleitet","A harder push: 2.8 m/s at the t\
op. Rolling needs friction, and friction has a limit: it is at most μ N.":"Ein kräftigerer Stoß: 2,8 m/s oben. Rollen braucht Reibung, und Reibung hat eine Gre\
nze: Sie ist höchstens μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"Wo ist die Last, wenn die Reibung zum ersten Mal \
nachgibt? Dreh die Marke.","Angle of the load where it begins to slip":"Winkel der Last, wo er zu gleiten beginnt","It begins to slip at {angle}. There the plan\
e carries only {share} of the weight.":"Er beginnt bei {angle} zu gleiten. Dort trägt die Ebene nur {share} des Gewichts.","The load on its way down and round \
presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.":"\
Die Last drückt auf ihrem Weg hinab und herum kaum auf die Ebene, N ist also klein, während der Ring schneller werden muss: Das braucht Reibung. Sieh das Diagra\
mm „Ausnutzung der Reibung“: Sie erreicht 1.","The hop":"Der Hüpfer","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn \
is over.":"Etwas schneller, 3,1 m/s. Diesmal verlässt der Reifen die Ebene, bevor die erste Umdrehung vorbei ist.","Where is the load when the hoop takes off? \
Turn the mark.":"Wo ist die Last, wenn der Reifen abhebt? Dreh die Marke.","Angle of the load where it takes off":"Winkel der Last beim Abheben","It takes off a\
t {angle}, while its rim slips at {slip} m/s.":"Er hebt bei {angle} ab, während sein Rand mit {slip} m/s gleitet.","A rolling hoop would be braked by the plane\
 while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the t\
op.":"Einen rollenden Reifen würde die Ebene bremsen, während die Last hochkommt. Dafür ist die Reibung zu schwach: Der Rand dreht durch, der Reifen dreht schne\
ll weiter, und die Last zieht ihn von der Ebene, bevor sie oben ist.","The landing":"Die Landung","The hoop is in the air. Its centre of gravity goes on a parab\
ola, and it turns evenly.":"Der Reifen ist in der Luft. Sein Schwerpunkt fliegt auf einer Parabel, und er dreht sich gleichmäßig.","What does it do just after\
 it has landed?":"Was tut er gleich nach der Landung?","It rolls at once.":"Er rollt sofort.","It skids: the rim slides ahead.":"Er rutscht: Der Rand gleitet vo\
raus.","It spins: the rim turns too fast.":"Er dreht durch: Der Rand dreht sich zu schnell.","It bounces.":"Er springt wieder ab.","It was in the air for {time}\
 s and rose by {height} cm; it lands with the load at {angle}.":"Er war {time} s in der Luft und stieg um {height} cm; er landet mit der Last bei {angle}.","An \
impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing would \
be another one. Try it afterwards.":"Ein Stoß braucht keine Zeit, doch seine Reibung ist so stark wie sein Druck: Hier genügt sie, um allen Schlupf zu beenden. \
Mit weniger Reibung oder größerer Stoßzahl wäre die Landung eine andere. Probier es nachher aus.","More friction, more hop?":"Mehr Reibung, mehr Hüpfen?","\
Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Drei Reifen bekommen denselben Stoß von 3,1 m/s, auf Ebenen mit der Reibu\
ngszahl 0,05, 0,2 und 1,0.","Which of them hops highest?":"Welcher hüpft am höchsten?","They rise by {low} cm, {middle} cm and {high} cm. (The first two are A\
 and B.)":"Sie steigen um {low} cm, {middle} cm und {high} cm. (Die ersten beiden sind A und B.)","On ice nothing drives the rotation; with endless friction not\
hing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the way up.":"Auf Eis treibt nichts \
die Drehung an; mit endloser Reibung gleitet nichts. Der Hüpfer braucht beides: genug Reibung, um den Reifen auf dem Weg hinab schnell zu drehen, und nicht so v\
iel, dass er auf dem Weg hinauf gebremst wird.","What rigid bodies cannot decide":"Was starre Körper nicht entscheiden","A hoop is thrown so that it slides fas\
t over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Ein Reifen wird so geworfen, dass er schnell über eine raue Eb\
ene gleitet. Die Gesetze starrer Körper mit trockener Reibung müssen sagen, was als Nächstes geschieht.","What do they say?":"Was sagen sie?","It flies off.":"\
Er fliegt davon.","An impact stops the slide at once.":"Ein Stoß beendet das Gleiten sofort.","Both agree with the laws.":"Beides passt zu den Gesetzen.","Hoop\
 A and hoop B start alike, and both motions obey every law.":"Reifen A und Reifen B beginnen gleich, und beide Bewegungen befolgen jedes Gesetz.","Painlevé foun\
d this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contac\
t under ‘Contact’.":"Painlevé fand dies 1895. Für einen starren Körper haben die Gesetze hier zwei Antworten, in anderen Zuständen keine. Wirkliche Körper g\
eben etwas nach, und das entscheidet: Wähle unter „Kontakt“ den nachgiebigen.","Your turn":"Du bist dran","Take the hoop: turn the load, lift the hoop and \
let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the motion itself.":"Nimm den Reifen: Dreh die Last, heb\
 ihn an und lass ihn fallen, stoß ihn an, neige die Ebene. Oder nimm eine Herausforderung an, und sieh, wie deine Punkte aus der Bewegung selbst berechnet werde\
n.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Den Reifen einmal in voller Geschwindigkeit zeigen, ohne Kommen\
tar. „Ich stoße ihn an. Rollt er nur?“","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.":"Alle sagen voraus, wo\
 die Last beim Abheben ist. Stimmen nach Vierteln der Umdrehung zählen.","Energy on the way down, in pairs: who has the energy when the load is at rest?":"Ener\
gie auf dem Weg hinab, zu zweit: Wer hat die Energie, wenn die Last ruht?","Lift at the top: at which speed is the force of the floor zero?":"Abheben oben: Bei \
welcher Geschwindigkeit ist die Kraft des Bodens null?","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.":"Der Film no\
ch einmal, in Zeitlupe und mit Kräften; beim Abheben anhalten. Mit den Stimmen vergleichen.","Each group takes one speed of the worksheet; results on the board\
.":"Jede Gruppe nimmt eine Geschwindigkeit des Arbeitsblatts; Ergebnisse an die Tafel.","Why? What has to brake the rotation on the way up, how strong can it be\
, and what if it is too weak?":"Warum? Was muss die Drehung auf dem Weg hinauf bremsen, wie stark kann es sein, und was, wenn es zu schwach ist?","One sentence \
each: “The hoop hops because …”":"Ein Satz von jedem: „Der Reifen hüpft, weil …“","The load pulls the hoop up at the top, so it hops there.":"Die L\
ast zieht den Reifen oben hoch, also hüpft er dort.","Only if it is very fast. Slower hoops hop before the top, after slipping.":"Nur wenn er sehr schnell ist.\
 Langsamere Reifen hüpfen vor der höchsten Stelle, nach dem Gleiten.","It hops at the bottom, where it is fastest.":"Er hüpft unten, wo er am schnellsten ist.",
"There the floor pushes hardest: the load has to be turned upwards.":"Dort drückt der Boden am stärksten: Die Last muss nach oben umgelenkt werden.","Nothing \
can be faster than a falling stone.":"Nichts kann schneller sein als ein fallender Stein.","The ring can: it gets the energy of a load that has come to rest.":"\
Der Ring schon: Er bekommt die Energie einer Last, die zur Ruhe gekommen ist.","Friction always brakes.":"Reibung bremst immer.","It acts against slip. On the h\
oop’s way up it points forwards.":"Sie wirkt gegen den Schlupf. Auf dem Weg hinauf zeigt sie nach vorn.","More friction, more hop.":"Mehr Reibung, mehr Hüpfen\
.","There is a best friction in between.":"Dazwischen gibt es eine beste Reibungszahl.","A heavier hoop behaves otherwise.":"Ein schwererer Reifen verhält sich \
anders.","Only the shares of mass count.":"Nur die Anteile der Massen zählen.","Before the film: where is the load when the hoop leaves the floor? Mark the pla\
ce and give one reason.":"Vor dem Film: Wo ist die Last, wenn der Reifen den Boden verlässt? Markiere die Stelle und nenne einen Grund.","The hoop gets only th\
e smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"Der Reifen bekommt nur den kleinsten Stoß und rollt. Wi\
e viel potenzielle Energie ist frei geworden, wenn die Last unten ist?","While a wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic en\
ergy then, and how fast is the centre?":"Wenn ein Rad rollt, ruht sein tiefster Punkt. Welcher Teil des Reifens hat dann kinetische Energie, und wie schnell ist\
 der Mittelpunkt?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"Wie schnell ist ein Stein, der aus der Höhe der La\
st fällt? Warum kann der Reifen schneller sein?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.":"Bestimme die Kr\
aft des Bodens oben für 1,0 m/s und die Geschwindigkeit, bei der sie null wird.","In the lab: what does the hoop do in its first 1.5 s, and at which angle does\
 it hop? Fill in the table.":"Im Labor: Was tut der Reifen in den ersten 1,5 s, und bei welchem Winkel hüpft er? Fülle die Tabelle aus.","Find the smallest sp\
eed with which the hoop hops, to 1 cm/s.":"Finde die kleinste Geschwindigkeit, mit der der Reifen hüpft, auf 1 cm/s genau.","At 2.2 m/s the hoop leaves the flo\
or while its rim slips. Why does slipping help it to hop?":"Bei 2,2 m/s verlässt der Reifen den Boden, während sein Rand gleitet. Warum hilft ihm das Gleiten zu\
 hüpfen?",Show:"Zeigen","Teaching with the hoop":"Unterrichten mit dem Reifen",Worksheet:"Arbeitsblatt",Solutions:"Lösungen",Exercises:"Aufgaben","A lesson of\
 45 minutes":"Eine Unterrichtsstunde von 45 Minuten",Minute:"Minute",Motion:"Bewegung","What students often think":"Was Lernende oft denken",Idea:"Vorstellung",
"What is right":"Was richtig ist","Worksheet: the hoop that hops":"Arbeitsblatt: der hüpfende Reifen","A thin ring of radius 0.40 m has a mass of 0.25 kg. A lo\
ad of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Ein\
 dünner Ring mit dem Radius 0,40 m hat eine Masse von 0,25 kg. An seinem Rand ist eine Last von 0,75 kg befestigt. Der Reifen steht mit der Last oben auf ebenem\
 Boden und wird nach rechts gestoßen. Reibungszahl: μ = 1; g = 9,81 m/s².",phases:"Phasen","does it hop?":"hüpft er?","at which angle?":"bei welchem Winkel?",
Print:"Drucken","The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student.":"Der Besuch fragt, bevor er zeigt\
; die Vorführung füllt den Bildschirm; die Tabelle gibt allen Zahlen."};var vs={roll:"rodadura",spin:"patinaje",skid:"derrape",flight:"vuelo",skim:"roce",hop:"salto","slip −":"deslizamiento −","slip +":"deslizamiento +",rolls:"r\
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
as un clic, o con Ctrl, la rueda amplía; doble clic para todo","A full, B dotted; numbers and colours of {hoop}; {hands}":"A continua, B punteada; números y co\
lores de {hoop}; {hands}","{name} from {low} to {high}":"{name} de {low} a {high}","Diagram: {title} in {unit}.":"Diagrama: {title} en {unit}.","θ mod 360°":"\
θ mod 360°",Esc:"Esc","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"ángulo dentro de una vuelta","place of the centre":"posición del centro","g\
ap under the rim":"separación bajo la llanta","height of the centre of gravity":"altura del centro de gravedad","speed of the centre":"velocidad del centro","s\
peed of rotation":"velocidad de rotación","speed away from the plane":"velocidad de alejamiento del plano","slip velocity":"velocidad de deslizamiento","angula\
r velocity":"velocidad angular","normal force":"fuerza normal","friction force":"fuerza de rozamiento","use of friction":"uso del rozamiento","kinetic energy":"\
energía cinética","potential energy":"energía potencial","total energy":"energía total","Plane of θ and θ̇":"Plano de θ y θ̇","Plane of angle and angu\
lar velocity with the regions of rolling, slip and flight":"Plano de ángulo y velocidad angular con las regiones de rodadura, deslizamiento y vuelo","angle θ w\
ithin a turn [°]":"ángulo θ dentro de una vuelta [°]","no answer":"sin respuesta","Colours: the mode that follows contact without slip. Hatched: slip that m\
eets Painlevé’s paradox.":"Colores: la fase que sigue al contacto sin deslizamiento. Rayado: deslizamiento que encuentra la paradoja de Painlevé.","Tap to g\
o there, two fingers zoom.":"Toca para ir ahí; dos dedos amplían.","Click to go there; two fingers zoom.":"Toca para ir ahí; dos dedos amplían.","Click to g\
o there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Clic para ir ahí; tras un clic, o con Ctrl, la rueda amplía; doble clic para todo.",
Map:"Mapa",of:"de",Across:"Horizontal",Up:"Vertical","What the map shows":"Qué muestra el mapa","Map of motions":"Mapa de movimientos","Map of motions. Arrow k\
eys move the mark, Enter takes the motion, plus and minus zoom.":"Mapa de movimientos. Las flechas mueven la marca, Intro toma el movimiento, más y menos amplía\
n.","Zoom into the map":"Ampliar el mapa","Zoom out of the map":"Reducir el mapa","Whole map":"Mapa entero","Click to take that motion into the player; two fing\
ers zoom.":"Toca para llevar ese movimiento al reproductor; dos dedos amplían.","Click to take that motion into the player; once clicked, or with Ctrl, the whe\
el zooms; drag to move; double-click for all.":"Un clic lleva ese movimiento al reproductor; tras un clic, o con Ctrl, la rueda amplía; arrastrar desplaza; dobl\
e clic para todo.","computing {count} motions …":"calculando {count} movimientos…","{count} motions":"{count} movimientos","{count} motions, with rigid cont\
act":"{count} movimientos, con contacto rígido","of rolling starts, though this motion starts otherwise":"con salidas rodando, aunque este movimiento empieza d\
e otro modo","of starts in any state, though this motion starts rolling":"desde cualquier estado, aunque este movimiento empieza rodando","compiling the kernel \
of maps, this once: {done} of {all} functions":"compilando el núcleo de los mapas, solo esta vez: {done} de {all} funciones",Keep:"Guardar","Copy the link":"Co\
piar el enlace","Scenario (TOML)":"Escenario (TOML)","States (CSV)":"Estados (CSV)","Motion (netCDF)":"Movimiento (netCDF)","Events (JSON)":"Sucesos (JSON)","Fi\
lm (MP4)":"Película (MP4)","Picture (PNG)":"Imagen (PNG)","Record a film here (WebM)":"Grabar aquí una película (WebM)","Show me the Python":"Ver el código P\
ython","The same motion in Python":"El mismo movimiento en Python","The link is copied.":"El enlace está copiado.","The link to this motion":"El enlace a este \
movimiento","The film is being made; this takes a while …":"Se está haciendo la película; tarda un poco…","Fetching {name} …":"Obteniendo {name}…","{n\
ame} is there.":"{name} ya está.","This browser cannot record a canvas; take the MP4 instead.":"Este navegador no puede grabar el lienzo; use el MP4.","Recordi\
ng one run …":"Grabando una pasada…","The film is there.":"La película ya está.","The scenario as a file":"El escenario como archivo",Copy:"Copiar",Copied:"\
Copiado",Close:"Cerrar","A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands –\
 or does something that rigid-body mechanics cannot decide. Move a slider and see.":"Un anillo con una carga en la llanta rueda sobre un plano. El rozamiento ag\
uanta hasta un límite y el plano solo puede empujar: por eso desliza, salta, aterriza… o hace algo que la mecánica del sólido rígido no puede decidir. Mueve un \
control y observa.",Modes:"Fases","Marks on the bar of time":"Marcas en la barra de tiempo",Keys:"Teclas",space:"espacio","play, pause":"reproducir, pausa","one\
 frame":"un fotograma","Shift ← →":"Mayús ← →","previous, next event":"suceso anterior, siguiente","next flight, landing":"siguiente vuelo, aterrizaje",
"slower, faster":"más lento, más rápido","Home End":"Inicio Fin","start, end":"principio, final","traces, forces, rim speed, whole path":"trayectorias, fuerz\
as, velocidad de la llanta, recorrido","in space":"en el espacio","zoom, zoom back":"ampliar, volver","leave a field, a menu, a picture that the wheel zooms":"s\
alir de un campo, un menú o una imagen que amplía la rueda","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"deshacer, rehacer","dark, light":"oscuro, claro",Python:"\
Python","the rim does not slide":"la llanta no desliza","slip: the rim turns too fast for the way it goes (slip −, for a hoop that rolls ahead)":"deslizamient\
o: la llanta gira demasiado deprisa para lo que avanza (deslizamiento −, si el aro rueda hacia delante)","slip: the rim slides ahead (slip +, for a hoop that \
rolls ahead)":"deslizamiento: la llanta desliza hacia delante (deslizamiento +, si el aro rueda hacia delante)","the hop: from take-off to landing":"el salto: d\
el despegue al aterrizaje","a massless rim that touches without force":"una llanta sin masa que toca sin fuerza","take-off, landing":"despegue, aterrizaje","Pai\
nlevé’s paradox: no solution, several":"Paradoja de Painlevé: ninguna solución, varias","bounces without number end":"acaban infinitos rebotes","skimming b\
egins, rest":"empieza el roce, reposo","Single keys (letters, digits, signs) do what the table says":"Las teclas sueltas (letras, cifras, signos) hacen lo que d\
ice la tabla","The hoop in your hand":"El aro en tu mano","Slope of the plane":"Inclinación del plano","Tilt the plane: drag, or arrow keys":"Inclinar el plano\
: arrastrar o flechas","The hoop: height and speed":"El aro: altura y velocidad","Lift, roll or throw the hoop: drag, or arrow keys":"Levantar, rodar o lanzar e\
l aro: arrastrar o flechas","Angle of the load":"Ángulo de la carga","Turn the load: drag, or arrow keys":"Girar la carga: arrastrar o flechas","gap {height}, \
speed {speed} m/s":"separación {height}, velocidad {speed} m/s",Repeat:"Repetir","Slow motion: a tenth of the speed":"Cámara lenta: una décima parte","Sound \
of the contact":"Sonido del contacto","Presentation on the whole screen":"Presentación a pantalla completa","Guided visit":"Visita guiada","Table of the motion":"\
Tabla del movimiento","Table of the motion, rows":"Tabla del movimiento, filas",Presentation:"Presentación","For teachers":"Para docentes",Table:"Tabla",Every:"\
Cada","Save as CSV":"Guardar como CSV",Columns:"Columnas","The first {count} rows.":"Las primeras {count} filas.",Challenges:"Retos","Leave the challenges":"Sal\
ir de los retos","Which challenge":"Qué reto",Score:"Puntuación","Begin again":"Empezar de nuevo","Show a best one":"Ver una de las mejores","{stars} {points}\
 points. {what}":"{stars} {points} puntos. {what}","Your best: {points} points.":"Tu mejor: {points} puntos.","Hop highest":"El salto más alto","On level groun\
d, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. How high can the hoop rise within 6 s?":"En suelo horizontal, rodando, con\
 3,1 m/s como mucho: eliges la carga, dónde empieza y el rozamiento. ¿Hasta qué altura puede subir el aro en 6 s?","Land upright":"Aterrizar en pie","Let the\
 hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.":"Haz que el aro aterrice con la carga arriba del t\
odo. Todo vale; el primer salto debe tener al menos 5 cm de altura.","Hop without skidding":"Saltar sin derrapar","On level ground the hoop starts rolling with \
its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"En suelo hor\
izontal el aro empieza rodando con la carga abajo, a 10 m/s como mucho, y μ no pasa de 1,5. Antes de saltar no debe derrapar; patinar sí puede. ¿Hasta qué altur\
a salta?","Rigid contact only.":"Solo contacto rígido.","The plane must be level.":"El plano debe ser horizontal.","It must be on Earth.":"Debe ser en la Tierr\
a.","Restitution must be 0.":"La restitución debe ser 0.","The radius must stay 1 m, without parts.":"El radio debe seguir siendo 1 m, sin piezas.","At most 90\
 % of the mass may be in the load.":"Como mucho el 90 % de la masa puede estar en la carga.","The hoop must be given by its load fraction.":"El aro debe darse p\
or la fracción de carga.","It must start rolling.":"Debe empezar rodando.","At most 10 m/s.":"Como mucho 10 m/s.","At most 3.1 m/s.":"Como mucho 3,1 m/s.","At \
most 6 s.":"Como mucho 6 s.","It does not hop.":"No salta.","It rises by {height}.":"Sube {height}.","The first hop is too low.":"El primer salto es demasiado b\
ajo.","It lands {off} away from the top.":"Aterriza a {off} de lo más alto.","The load must start at the bottom.":"La carga debe empezar abajo.","Friction must\
 be at most 1.5.":"El rozamiento debe ser como mucho 1,5.","It skids before it hops.":"Derrapa antes de saltar.","New here?":"¿Primera vez?","Eight short quest\
ions: guess, then play.":"Ocho preguntas cortas: adivina y luego reproduce.","Start the visit":"Empezar la visita","Not now":"Ahora no","The hoop, before it is \
let go.":"El aro, antes de soltarlo.",Play:"Reproducir",Next:"Siguiente",Back:"Atrás",Done:"Hecho","Step {number} of {all}":"Paso {number} de {all}","Leave the\
 visit":"Salir de la visita","First say what you expect, then play.":"Di primero qué esperas y luego reproduce.","Your guess":"Tu respuesta","{points} of 100 p\
oints.":"{points} de 100 puntos.","You have {sum} of {most} points.":"Tienes {sum} de {most} puntos.","{what} with the load at {angle}":"{what} con la carga a {\
angle}","Draw the curve: pull the points up and down":"Dibuja la curva: mueve los puntos arriba y abajo","Littlewood’s question":"La pregunta de Littlewood","\
A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when th\
e weight is level with the centre.":"Un aro sin masa lleva un peso en la llanta. Con el peso arriba recibe el menor empujón y rueda. J. E. Littlewood preguntó e\
n 1953 qué ocurre cuando el peso está a la altura del centro.","What do you think?":"¿Qué crees?","It rolls on.":"Sigue rodando.","It hops: the hoop leaves \
the plane.":"Salta: el aro deja el plano.","The weight falls freely, and the hoop skims the plane below it.":"El peso cae libremente y el aro roza el plano deba\
jo de él.","At {angle} there is no contact force any more.":"A {angle} ya no hay fuerza de contacto.","Littlewood said that the hoop hops. But the contact forc\
e is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim.":"Littlewood dijo\
 que el aro salta. Pero la fuerza de contacto es nula, no hacia arriba: el peso cae libremente y una llanta sin masa lo sigue por el plano. Para saltar, un aro \
necesita algo de masa en la llanta.","A ring with mass":"Un anillo con masa","Now a quarter of the mass is in the ring. Again the load is at the top, and the ho\
op gets the smallest push.":"Ahora un cuarto de la masa está en el anillo. De nuevo la carga está arriba y el aro recibe el menor empujón.","Draw how fast th\
e hoop’s centre goes during the first turn.":"Dibuja la velocidad del centro del aro durante la primera vuelta.","Speed of the centre":"Velocidad del centro",
"With the load at the bottom the centre has {speed} m/s.":"Con la carga abajo el centro va a {speed} m/s.","The lowest point of a rolling hoop is at rest. There\
 the load has no kinetic energy, and the light ring has all that the heavy load has lost: it is faster than a stone that falls from the same height.":"El punto \
más bajo de un aro que rueda está en reposo. Ahí la carga no tiene energía cinética, y el anillo ligero tiene toda la que ha perdido la carga pesada: va más ráp\
ido que una piedra que cae desde la misma altura.","Why it slips":"Por qué desliza","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction ha\
s a limit: it is at most μ N.":"Un empujón más fuerte: 2,8 m/s arriba. Rodar exige rozamiento, y el rozamiento tiene un límite: como mucho μ N.","Where is \
the load when friction gives way for the first time? Turn the mark.":"¿Dónde está la carga cuando el rozamiento cede por primera vez? Gira la marca.","Angle \
of the load where it begins to slip":"Ángulo de la carga donde empieza a deslizar","It begins to slip at {angle}. There the plane carries only {share} of the w\
eight.":"Empieza a deslizar a {angle}. Ahí el plano soporta solo el {share} del peso.","The load on its way down and round presses little on the plane, so that\
 N is small, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.":"En su camino hacia abajo la ca\
rga apenas aprieta el plano, así que N es pequeña, mientras que el anillo debe acelerarse: eso exige rozamiento. Mira el diagrama «Uso del rozamiento»: llega a \
1.","The hop":"El salto","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn is over.":"Un poco más rápido, 3,1 m/s. Esta vez \
el aro deja el plano antes de acabar la primera vuelta.","Where is the load when the hoop takes off? Turn the mark.":"¿Dónde está la carga cuando el aro despega\
? Gira la marca.","Angle of the load where it takes off":"Ángulo de la carga al despegar","It takes off at {angle}, while its rim slips at {slip} m/s.":"Despeg\
a a {angle}, mientras su llanta desliza a {slip} m/s.","A rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the \
rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the top.":"A un aro que rueda el plano lo frenaría mientras sube l\
a carga. El rozamiento es demasiado débil para eso: la llanta patina, el aro sigue girando deprisa y la carga lo arranca del plano antes de llegar arriba.","Th\
e landing":"El aterrizaje","The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.":"El aro está en el aire. Su centro de graved\
ad sigue una parábola y gira de manera uniforme.","What does it do just after it has landed?":"¿Qué hace justo después de aterrizar?","It rolls at once.":"R\
ueda de inmediato.","It skids: the rim slides ahead.":"Derrapa: la llanta desliza hacia delante.","It spins: the rim turns too fast.":"Patina: la llanta gira de\
masiado deprisa.","It bounces.":"Rebota.","It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Estuvo {time} s en el ai\
re y subió {height} cm; aterriza con la carga a {angle}.","An impact takes no time, but its friction is as strong as its push: here it is enough to stop all sl\
ip. With less friction, or more restitution, the landing would be another one. Try it afterwards.":"Un impacto no dura nada, pero su rozamiento es tan fuerte co\
mo su empuje: aquí basta para detener todo deslizamiento. Con menos rozamiento, o más restitución, el aterrizaje sería otro. Pruébalo después.","More fric\
tion, more hop?":"¿Más rozamiento, más salto?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Tres aros reciben el m\
ismo empujón de 3,1 m/s, en planos con rozamiento 0,05, 0,2 y 1,0.","Which of them hops highest?":"¿Cuál salta más alto?","They rise by {low} cm, {middle} c\
m and {high} cm. (The first two are A and B.)":"Suben {low} cm, {middle} cm y {high} cm. (Los dos primeros son A y B.)","On ice nothing drives the rotation; wit\
h endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the way up.":"\
Sobre hielo nada impulsa el giro; con rozamiento sin fin nada desliza. El salto necesita ambas cosas: rozamiento bastante para girar deprisa en la bajada, y no \
tanto que lo frene en la subida.","What rigid bodies cannot decide":"Lo que los sólidos rígidos no pueden decidir","A hoop is thrown so that it slides fast ov\
er a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Se lanza un aro de modo que deslice deprisa sobre un plano rugoso.\
 Las leyes del sólido rígido con rozamiento seco deben decir qué ocurre después.","What do they say?":"¿Qué dicen?","It flies off.":"Sale volando.","An im\
pact stops the slide at once.":"Un impacto detiene el deslizamiento de golpe.","Both agree with the laws.":"Ambas cosas cumplen las leyes.","Hoop A and hoop B s\
tart alike, and both motions obey every law.":"El aro A y el aro B empiezan igual, y ambos movimientos cumplen todas las leyes.","Painlevé found this in 1895. F\
or a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’\
.":"Painlevé lo descubrió en 1895. Para un sólido rígido las leyes tienen aquí dos respuestas, y en otros estados ninguna. Los cuerpos reales ceden un poco, y e\
so decide: elige el contacto flexible en «Contacto».","Your turn":"Te toca a ti","Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt \
the plane. Or accept a challenge, and see how your scores are computed from the motion itself.":"Toma el aro: gira la carga, levántalo y suéltalo, dale un impul\
so, inclina el plano. O acepta un reto y mira cómo tu puntuación se calcula del propio movimiento.","Show the hoop at full speed, once, without a comment. “I \
push it. Does it only roll?”":"Mostrar el aro a toda velocidad, una vez, sin comentar. «Lo empujo. ¿Solo rueda?»","Everybody predicts where the load is at \
take-off. Count the votes by quarters of the turn.":"Todos predicen dónde está la carga al despegar. Contar los votos por cuartos de vuelta.","Energy on the w\
ay down, in pairs: who has the energy when the load is at rest?":"Energía en la bajada, por parejas: ¿quién tiene la energía cuando la carga está en reposo?",
"Lift at the top: at which speed is the force of the floor zero?":"Elevación arriba: ¿a qué velocidad es nula la fuerza del suelo?","The film again, in slow \
motion and with forces; stop at take-off. Compare with the votes.":"La película otra vez, a cámara lenta y con fuerzas; parar al despegar. Comparar con los voto\
s.","Each group takes one speed of the worksheet; results on the board.":"Cada grupo toma una velocidad de la hoja de trabajo; resultados en la pizarra.","Why? \
What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?":"¿Por qué? ¿Qué debe frenar el giro en la subida, qué fuerza pu\
ede tener y qué pasa si es demasiado débil?","One sentence each: “The hoop hops because …”":"Una frase cada uno: «El aro salta porque…»","The load p\
ulls the hoop up at the top, so it hops there.":"La carga tira del aro hacia arriba en lo alto, por eso salta ahí.","Only if it is very fast. Slower hoops hop \
before the top, after slipping.":"Solo si es muy rápido. Los más lentos saltan antes de lo alto, tras deslizar.","It hops at the bottom, where it is fastest.":"\
Salta abajo, donde es más rápido.","There the floor pushes hardest: the load has to be turned upwards.":"Ahí el suelo empuja más: hay que desviar la carga hac\
ia arriba.","Nothing can be faster than a falling stone.":"Nada puede ser más rápido que una piedra que cae.","The ring can: it gets the energy of a load that\
 has come to rest.":"El anillo sí: recibe la energía de una carga que ha quedado en reposo.","Friction always brakes.":"El rozamiento siempre frena.","It acts\
 against slip. On the hoop’s way up it points forwards.":"Actúa contra el deslizamiento. En la subida apunta hacia delante.","More friction, more hop.":"Más \
rozamiento, más salto.","There is a best friction in between.":"Hay un rozamiento óptimo intermedio.","A heavier hoop behaves otherwise.":"Un aro más pesado s\
e comporta de otro modo.","Only the shares of mass count.":"Solo cuentan las proporciones de masa.","Before the film: where is the load when the hoop leaves the\
 floor? Mark the place and give one reason.":"Antes de la película: ¿dónde está la carga cuando el aro deja el suelo? Marca el lugar y da una razón.","The \
hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"El aro recibe solo el menor empujón y \
rueda. ¿Cuánta energía potencial se ha liberado cuando la carga está abajo?","While a wheel rolls, its lowest point is at rest. Which part of the hoop has k\
inetic energy then, and how fast is the centre?":"Mientras una rueda rueda, su punto más bajo está en reposo. ¿Qué parte del aro tiene entonces energía cinética\
 y a qué velocidad va el centro?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"¿Qué velocidad tiene una piedra qu\
e cae desde la altura de la carga? ¿Por qué puede ser más rápido el aro?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it bec\
omes zero.":"Halla la fuerza del suelo arriba para 1,0 m/s y la velocidad a la que se anula.","In the lab: what does the hoop do in its first 1.5 s, and at whic\
h angle does it hop? Fill in the table.":"En el laboratorio: ¿qué hace el aro en sus primeros 1,5 s y a qué ángulo salta? Completa la tabla.","Find the smal\
lest speed with which the hoop hops, to 1 cm/s.":"Halla la menor velocidad con la que el aro salta, con 1 cm/s de precisión.","At 2.2 m/s the hoop leaves the f\
loor while its rim slips. Why does slipping help it to hop?":"A 2,2 m/s el aro deja el suelo mientras su llanta desliza. ¿Por qué le ayuda a saltar el deslizami\
ento?",Show:"Mostrar","Teaching with the hoop":"Enseñar con el aro",Worksheet:"Hoja de trabajo",Solutions:"Soluciones",Exercises:"Ejercicios","A lesson of 45 m\
inutes":"Una clase de 45 minutos",Minute:"Minuto",Motion:"Movimiento","What students often think":"Lo que suelen pensar los estudiantes",Idea:"Idea","What is ri\
ght":"Lo correcto","Worksheet: the hoop that hops":"Hoja de trabajo: el aro que salta","A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is\
 fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Un anillo delgado d\
e radio 0,40 m tiene una masa de 0,25 kg. En su llanta va fijada una carga de 0,75 kg. El aro está sobre un suelo horizontal con la carga arriba y se empuja hac\
ia la derecha. Rozamiento: μ = 1; g = 9,81 m/s².",phases:"fases","does it hop?":"¿salta?","at which angle?":"¿a qué ángulo?",Print:"Imprimir","The visit a\
sks before it shows; the presentation fills the screen; the table gives numbers to every student.":"La visita pregunta antes de mostrar; la presentación llena l\
a pantalla; la tabla da números a cada estudiante."};var ks={roll:"roulement",spin:"patinage",skid:"dérapage",flight:"vol",skim:"effleurement",hop:"saut","slip −":"glissement −","slip +":"glissement +",rolls:"\
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
lette agrandit ; double-clic pour tout","A full, B dotted; numbers and colours of {hoop}; {hands}":"A trait plein, B pointillé ; nombres et couleurs de {hoop} ;\
 {hands}","{name} from {low} to {high}":"{name} de {low} à {high}","Diagram: {title} in {unit}.":"Diagramme : {title} en {unit}.","θ mod 360°":"θ mod 360°",
Esc:"Échap","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"angle dans un tour","place of the centre":"position du centre","gap under the rim":"écar\
t sous la jante","height of the centre of gravity":"hauteur du centre de gravité","speed of the centre":"vitesse du centre","speed of rotation":"vitesse de rot\
ation","speed away from the plane":"vitesse d’éloignement du plan","slip velocity":"vitesse de glissement","angular velocity":"vitesse angulaire","normal for\
ce":"force normale","friction force":"force de frottement","use of friction":"utilisation du frottement","kinetic energy":"énergie cinétique","potential energ\
y":"énergie potentielle","total energy":"énergie totale","Plane of θ and θ̇":"Plan de θ et θ̇","Plane of angle and angular velocity with the regions of \
rolling, slip and flight":"Plan de l’angle et de la vitesse angulaire avec les régions de roulement, de glissement et de vol","angle θ within a turn [°]":"\
angle θ dans un tour [°]","no answer":"sans réponse","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"\
Couleurs : la phase qui suit un contact sans glissement. Hachures : glissement qui rencontre le paradoxe de Painlevé.","Tap to go there, two fingers zoom.":"To\
uchez pour y aller ; deux doigts agrandissent.","Click to go there; two fingers zoom.":"Touchez pour y aller ; deux doigts agrandissent.","Click to go there; on\
ce clicked, or with Ctrl, the wheel zooms; double-click for all.":"Cliquez pour y aller ; après un clic, ou avec Ctrl, la molette agrandit ; double-clic pour to\
ut.",Map:"Carte",of:"de",Across:"Horizontale",Up:"Verticale","What the map shows":"Ce que montre la carte","Map of motions":"Carte des mouvements","Map of motio\
ns. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Carte des mouvements. Les flèches déplacent la marque, Entrée prend le mouvement, p\
lus et moins agrandissent.","Zoom into the map":"Agrandir la carte","Zoom out of the map":"Réduire la carte","Whole map":"Carte entière","Click to take that m\
otion into the player; two fingers zoom.":"Touchez pour mettre ce mouvement dans le lecteur ; deux doigts agrandissent.","Click to take that motion into the pla\
yer; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Un clic met ce mouvement dans le lecteur ; après un clic, ou avec Ctrl, \
la molette agrandit ; tirez pour déplacer ; double-clic pour tout.","computing {count} motions …":"calcul de {count} mouvements…","{count} motions":"{count\
} mouvements","{count} motions, with rigid contact":"{count} mouvements, avec contact rigide","of rolling starts, though this motion starts otherwise":"partant \
en roulant, bien que ce mouvement parte autrement","of starts in any state, though this motion starts rolling":"partant d’un état quelconque, bien que ce mouvem\
ent parte en roulant","compiling the kernel of maps, this once: {done} of {all} functions":"compilation du noyau des cartes, cette fois seulement : {done} fonct\
ions sur {all}",Keep:"Garder","Copy the link":"Copier le lien","Scenario (TOML)":"Scénario (TOML)","States (CSV)":"États (CSV)","Motion (netCDF)":"Mouvement (\
netCDF)","Events (JSON)":"Événements (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Image (PNG)","Record a film here (WebM)":"Enregistrer un film ici (Web\
M)","Show me the Python":"Montrer le Python","The same motion in Python":"Le même mouvement en Python","The link is copied.":"Le lien est copié.","The link to\
 this motion":"Le lien vers ce mouvement","The film is being made; this takes a while …":"Le film se fait ; cela prend un moment…","Fetching {name} …":"Ré\
cupération de {name}…","{name} is there.":"{name} est là.","This browser cannot record a canvas; take the MP4 instead.":"Ce navigateur ne peut pas enregistr\
er le canevas ; prenez le MP4.","Recording one run …":"Enregistrement d’un passage…","The film is there.":"Le film est là.","The scenario as a file":"Le \
scénario en fichier",Copy:"Copier",Copied:"Copié",Close:"Fermer","A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plan\
e can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"Un anneau lesté d’une masselot\
te roule sur un plan. Le frottement ne retient pas sans limite et le plan ne peut que pousser : alors il glisse, saute, retombe – ou fait ce que la mécanique du\
 solide ne peut décider. Bougez un réglage et voyez.",Modes:"Phases","Marks on the bar of time":"Marques sur la barre de temps",Keys:"Touches",space:"espace",
"play, pause":"lecture, pause","one frame":"une image","Shift ← →":"Maj ← →","previous, next event":"événement précédent, suivant","next flight, lan\
ding":"vol, retombée suivants","slower, faster":"plus lent, plus vite","Home End":"Début Fin","start, end":"début, fin","traces, forces, rim speed, whole pat\
h":"trajectoires, forces, vitesse de la jante, trajet","in space":"en 3D","zoom, zoom back":"agrandir, revenir","leave a field, a menu, a picture that the wheel\
 zooms":"quitter un champ, un menu, une image que la molette agrandit","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"annuler, rétablir","dark, light":"sombre, clai\
r",Python:"Python","the rim does not slide":"la jante ne glisse pas","slip: the rim turns too fast for the way it goes (slip −, for a hoop that rolls ahead)":"\
glissement : la jante tourne trop vite pour son trajet (glissement −, pour un cerceau qui avance)","slip: the rim slides ahead (slip +, for a hoop that rolls \
ahead)":"glissement : la jante glisse vers l’avant (glissement +, pour un cerceau qui avance)","the hop: from take-off to landing":"le saut : du décollage à l\
a retombée","a massless rim that touches without force":"une jante sans masse qui touche sans force","take-off, landing":"décollage, retombée","Painlevé’s pa\
radox: no solution, several":"Paradoxe de Painlevé : aucune solution, plusieurs","bounces without number end":"une infinité de rebonds s’achève","skimming \
begins, rest":"l’effleurement commence, repos","Single keys (letters, digits, signs) do what the table says":"Les touches seules (lettres, chiffres, signes) f\
ont ce que dit le tableau","The hoop in your hand":"Le cerceau dans votre main","Slope of the plane":"Inclinaison du plan","Tilt the plane: drag, or arrow keys":"\
Incliner le plan : tirer, ou flèches","The hoop: height and speed":"Le cerceau : hauteur et vitesse","Lift, roll or throw the hoop: drag, or arrow keys":"Lever\
, rouler ou lancer le cerceau : tirer, ou flèches","Angle of the load":"Angle de la masselotte","Turn the load: drag, or arrow keys":"Tourner la masselotte : t\
irer, ou flèches","gap {height}, speed {speed} m/s":"écart {height}, vitesse {speed} m/s",Repeat:"Répéter","Slow motion: a tenth of the speed":"Ralenti : un\
 dixième de la vitesse","Sound of the contact":"Son du contact","Presentation on the whole screen":"Présentation en plein écran","Guided visit":"Visite guidé\
e","Table of the motion":"Tableau du mouvement","Table of the motion, rows":"Tableau du mouvement, lignes",Presentation:"Présentation","For teachers":"Pour les\
 enseignants",Table:"Tableau",Every:"Toutes les","Save as CSV":"Enregistrer en CSV",Columns:"Colonnes","The first {count} rows.":"Les {count} premières lignes.",
Challenges:"Défis","Leave the challenges":"Quitter les défis","Which challenge":"Quel défi",Score:"Score","Begin again":"Recommencer","Show a best one":"Mont\
rer un des meilleurs","{stars} {points} points. {what}":"{stars} {points} points. {what}","Your best: {points} points.":"Votre meilleur : {points} points.","Hop\
 highest":"Sauter le plus haut","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. How high can the hoop rise \
within 6 s?":"Sur sol horizontal, en roulant, à 3,1 m/s au plus : vous choisissez la masselotte, sa position de départ et le frottement. À quelle hauteur le cer\
ceau peut-il monter en 6 s ?","Land upright":"Retomber debout","Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be \
at least 5 cm high.":"Faites retomber le cerceau avec la masselotte tout en haut. Tout est permis ; le premier saut doit faire au moins 5 cm.","Hop without skid\
ding":"Sauter sans déraper","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops \
it must not skid; to spin is allowed. How high does it hop?":"Sur sol horizontal le cerceau part en roulant, la masselotte en bas, à 10 m/s au plus, et μ vaut a\
u plus 1,5. Avant de sauter il ne doit pas déraper ; patiner est permis. À quelle hauteur saute-t-il ?","Rigid contact only.":"Contact rigide seulement.","The\
 plane must be level.":"Le plan doit être horizontal.","It must be on Earth.":"Ce doit être sur Terre.","Restitution must be 0.":"La restitution doit être 0.",
"The radius must stay 1 m, without parts.":"Le rayon doit rester 1 m, sans pièces.","At most 90 % of the mass may be in the load.":"Au plus 90 % de la masse da\
ns la masselotte.","The hoop must be given by its load fraction.":"Le cerceau doit être donné par la part de la masselotte.","It must start rolling.":"Il doit\
 partir en roulant.","At most 10 m/s.":"Au plus 10 m/s.","At most 3.1 m/s.":"Au plus 3,1 m/s.","At most 6 s.":"Au plus 6 s.","It does not hop.":"Il ne saute pas\
.","It rises by {height}.":"Il monte de {height}.","The first hop is too low.":"Le premier saut est trop bas.","It lands {off} away from the top.":"Il retombe à\
 {off} du sommet.","The load must start at the bottom.":"La masselotte doit partir d’en bas.","Friction must be at most 1.5.":"Le frottement doit être au plus\
 1,5.","It skids before it hops.":"Il dérape avant de sauter.","New here?":"Première visite ?","Eight short questions: guess, then play.":"Huit questions brèv\
es : devinez, puis lancez.","Start the visit":"Commencer la visite","Not now":"Pas maintenant","The hoop, before it is let go.":"Le cerceau, avant d’être lâché.",
Play:"Lancer",Next:"Suivant",Back:"Retour",Done:"Terminé","Step {number} of {all}":"Étape {number} sur {all}","Leave the visit":"Quitter la visite","First say\
 what you expect, then play.":"Dites d’abord ce que vous attendez, puis lancez.","Your guess":"Votre réponse","{points} of 100 points.":"{points} points sur \
100.","You have {sum} of {most} points.":"Vous avez {sum} points sur {most}.","{what} with the load at {angle}":"{what} avec la masselotte à {angle}","Draw the\
 curve: pull the points up and down":"Tracez la courbe : tirez les points vers le haut ou le bas","Littlewood’s question":"La question de Littlewood","A hoop \
without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the weigh\
t is level with the centre.":"Un cerceau sans masse porte un poids sur sa jante. Le poids en haut, il reçoit la plus petite poussée et roule. J. E. Littlewood d\
emanda en 1953 ce qui se passe quand le poids est à la hauteur du centre.","What do you think?":"Qu’en pensez-vous ?","It rolls on.":"Il continue de rouler.",
"It hops: the hoop leaves the plane.":"Il saute : le cerceau quitte le plan.","The weight falls freely, and the hoop skims the plane below it.":"Le poids tombe \
en chute libre, et le cerceau effleure le plan sous lui.","At {angle} there is no contact force any more.":"À {angle} il n’y a plus de force de contact.","Li\
ttlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop\
, a hoop needs some mass in its rim.":"Littlewood disait que le cerceau saute. Mais la force de contact est nulle, non dirigée vers le haut : le poids tombe en \
chute libre et une jante sans masse le suit le long du plan. Pour sauter, il faut au cerceau un peu de masse dans la jante.","A ring with mass":"Un anneau avec \
masse","Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"À présent un quart de la masse est dans l\
’anneau. De nouveau la masselotte est en haut et le cerceau reçoit la plus petite poussée.","Draw how fast the hoop’s centre goes during the first turn.":"\
Tracez la vitesse du centre du cerceau pendant le premier tour.","Speed of the centre":"Vitesse du centre","With the load at the bottom the centre has {speed} m\
/s.":"Avec la masselotte en bas, le centre a {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light r\
ing has all that the heavy load has lost: it is faster than a stone that falls from the same height.":"Le point le plus bas d’un cerceau qui roule est au repos.\
 Là, la masselotte n’a pas d’énergie cinétique, et l’anneau léger a tout ce que la lourde masselotte a perdu : il est plus rapide qu’une pierre tombant de la mê\
me hauteur.","Why it slips":"Pourquoi il glisse","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Une\
 poussée plus forte : 2,8 m/s en haut. Rouler exige du frottement, et le frottement a une limite : il vaut au plus μ N.","Where is the load when friction give\
s way for the first time? Turn the mark.":"Où est la masselotte quand le frottement cède pour la première fois ? Tournez la marque.","Angle of the load where\
 it begins to slip":"Angle de la masselotte où il commence à glisser","It begins to slip at {angle}. There the plane carries only {share} of the weight.":"Il \
commence à glisser à {angle}. Là, le plan ne porte que {share} du poids.","The load on its way down and round presses little on the plane, so that N is small\
, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.":"Dans sa descente la masselotte appuie peu\
 sur le plan : N est petite, alors que l’anneau doit accélérer, ce qui demande du frottement. Voyez le diagramme « Utilisation du frottement » : elle atteint 1.",
"The hop":"Le saut","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn is over.":"Un peu plus vite, 3,1 m/s. Cette fois le ce\
rceau quitte le plan avant la fin du premier tour.","Where is the load when the hoop takes off? Turn the mark.":"Où est la masselotte quand le cerceau décolle ?\
 Tournez la marque.","Angle of the load where it takes off":"Angle de la masselotte au décollage","It takes off at {angle}, while its rim slips at {slip} m/s.":"\
Il décolle à {angle}, tandis que sa jante glisse à {slip} m/s.","A rolling hoop would be braked by the plane while the load comes up. Friction is too weak fo\
r that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the top.":"Le plan freinerait un cerceau qui roule tan\
dis que la masselotte remonte. Le frottement est trop faible pour cela : la jante patine, le cerceau continue de tourner vite, et la masselotte l’arrache du pla\
n avant d’être en haut.","The landing":"La retombée","The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.":"Le cerceau es\
t en l’air. Son centre de gravité suit une parabole et il tourne uniformément.","What does it do just after it has landed?":"Que fait-il juste après être re\
tombé ?","It rolls at once.":"Il roule aussitôt.","It skids: the rim slides ahead.":"Il dérape : la jante glisse vers l’avant.","It spins: the rim turns to\
o fast.":"Il patine : la jante tourne trop vite.","It bounces.":"Il rebondit.","It was in the air for {time} s and rose by {height} cm; it lands with the load a\
t {angle}.":"Il est resté {time} s en l’air et est monté de {height} cm ; il retombe avec la masselotte à {angle}.","An impact takes no time, but its frict\
ion is as strong as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards.":"\
Un impact ne dure pas, mais son frottement est aussi fort que sa poussée : ici il suffit à arrêter tout glissement. Avec moins de frottement, ou plus de restitu\
tion, la retombée serait autre. Essayez ensuite.","More friction, more hop?":"Plus de frottement, plus haut ?","Three hoops get the same push of 3.1 m/s, on pl\
anes with friction 0.05, 0.2 and 1.0.":"Trois cerceaux reçoivent la même poussée de 3,1 m/s, sur des plans de frottement 0,05, 0,2 et 1,0.","Which of them ho\
ps highest?":"Lequel saute le plus haut ?","They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)":"Ils montent de {low} cm, {middle} c\
m et {high} cm. (Les deux premiers sont A et B.)","On ice nothing drives the rotation; with endless friction nothing slips. The hop needs both: enough friction \
to turn the hoop fast on the way down, and not so much that it is braked on the way up.":"Sur la glace rien n’entraîne la rotation ; avec un frottement sans fin\
 rien ne glisse. Le saut exige les deux : assez de frottement pour tourner vite à la descente, et pas assez pour être freiné à la remontée.","What rigid bo\
dies cannot decide":"Ce que les solides ne peuvent décider","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry fric\
tion have to say what happens next.":"On lance un cerceau de sorte qu’il glisse vite sur un plan rugueux. Les lois des solides avec frottement sec doivent dire \
la suite.","What do they say?":"Que disent-elles ?","It flies off.":"Il s’envole.","An impact stops the slide at once.":"Un impact arrête aussitôt le glisseme\
nt.","Both agree with the laws.":"Les deux obéissent aux lois.","Hoop A and hoop B start alike, and both motions obey every law.":"Les cerceaux A et B partent \
de même, et les deux mouvements obéissent à toutes les lois.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states \
none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’.":"Painlevé l’a trouvé en 1895. Pour un solide, les lois on\
t ici deux réponses, dans d’autres états aucune. Les corps réels cèdent un peu, et cela décide : choisissez le contact souple sous « Contact ».","Your \
turn":"À vous","Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are compu\
ted from the motion itself.":"Prenez le cerceau : tournez la masselotte, levez-le et lâchez-le, lancez-le, inclinez le plan. Ou relevez un défi, et voyez votre \
score calculé d’après le mouvement lui-même.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Montrer le cerce\
au à pleine vitesse, une fois, sans commentaire. « Je le pousse. Ne fait-il que rouler ? »","Everybody predicts where the load is at take-off. Count the vote\
s by quarters of the turn.":"Chacun prédit où est la masselotte au décollage. Compter les voix par quarts de tour.","Energy on the way down, in pairs: who ha\
s the energy when the load is at rest?":"L’énergie à la descente, par deux : qui a l’énergie quand la masselotte est au repos ?","Lift at the top: at whi\
ch speed is the force of the floor zero?":"Soulèvement en haut : à quelle vitesse la force du sol est-elle nulle ?","The film again, in slow motion and with f\
orces; stop at take-off. Compare with the votes.":"Le film à nouveau, au ralenti et avec les forces ; arrêter au décollage. Comparer avec les voix.","Each gr\
oup takes one speed of the worksheet; results on the board.":"Chaque groupe prend une vitesse de la fiche ; résultats au tableau.","Why? What has to brake the \
rotation on the way up, how strong can it be, and what if it is too weak?":"Pourquoi ? Qu’est-ce qui doit freiner la rotation à la remontée, avec quelle force, \
et si c’est trop faible ?","One sentence each: “The hoop hops because …”":"Une phrase chacun : « Le cerceau saute parce que… »","The load pulls the \
hoop up at the top, so it hops there.":"La masselotte tire le cerceau vers le haut au sommet, donc il saute là.","Only if it is very fast. Slower hoops hop bef\
ore the top, after slipping.":"Seulement s’il est très rapide. Les plus lents sautent avant le sommet, après avoir glissé.","It hops at the bottom, where i\
t is fastest.":"Il saute en bas, où il est le plus rapide.","There the floor pushes hardest: the load has to be turned upwards.":"Là le sol pousse le plus fort\
 : il faut dévier la masselotte vers le haut.","Nothing can be faster than a falling stone.":"Rien ne peut être plus rapide qu’une pierre qui tombe.","The r\
ing can: it gets the energy of a load that has come to rest.":"L’anneau le peut : il reçoit l’énergie d’une masselotte qui s’est arrêtée.","Friction\
 always brakes.":"Le frottement freine toujours.","It acts against slip. On the hoop’s way up it points forwards.":"Il agit contre le glissement. À la remonté\
e il est dirigé vers l’avant.","More friction, more hop.":"Plus de frottement, plus de saut.","There is a best friction in between.":"Il y a un frottement op\
timal entre les deux.","A heavier hoop behaves otherwise.":"Un cerceau plus lourd se comporte autrement.","Only the shares of mass count.":"Seules les parts de \
masse comptent.","Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.":"Avant le film : où est la masselotte \
quand le cerceau quitte le sol ? Marquez l’endroit et donnez une raison.","The hoop gets only the smallest push and rolls. How much potential energy has been \
set free when the load is at the bottom?":"Le cerceau ne reçoit que la plus petite poussée et roule. Quelle énergie potentielle a été libérée quand la masselott\
e est en bas ?","While a wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"Quand une roue \
roule, son point le plus bas est au repos. Quelle partie du cerceau a alors de l’énergie cinétique, et quelle est la vitesse du centre ?","How fast is a sto\
ne that falls from the height of the load? Why can the hoop be faster?":"Quelle est la vitesse d’une pierre tombant de la hauteur de la masselotte ? Pourquoi le\
 cerceau peut-il être plus rapide ?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.":"Trouvez la force du sol au \
sommet pour 1,0 m/s, et la vitesse où elle s’annule.","In the lab: what does the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the tabl\
e.":"Dans le labo : que fait le cerceau pendant ses 1,5 premières secondes, et à quel angle saute-t-il ? Remplissez le tableau.","Find the smallest speed with\
 which the hoop hops, to 1 cm/s.":"Trouvez la plus petite vitesse pour laquelle le cerceau saute, à 1 cm/s près.","At 2.2 m/s the hoop leaves the floor while \
its rim slips. Why does slipping help it to hop?":"À 2,2 m/s le cerceau quitte le sol tandis que sa jante glisse. Pourquoi le glissement l’aide-t-il à sauter ?",
Show:"Montrer","Teaching with the hoop":"Enseigner avec le cerceau",Worksheet:"Fiche de travail",Solutions:"Corrigé",Exercises:"Exercices","A lesson of 45 minu\
tes":"Une séance de 45 minutes",Minute:"Minute",Motion:"Mouvement","What students often think":"Ce que pensent souvent les élèves",Idea:"Idée","What is righ\
t":"Ce qui est juste","Worksheet: the hoop that hops":"Fiche de travail : le cerceau sauteur","A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.7\
5 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².":"Un anneau mi\
nce de rayon 0,40 m a une masse de 0,25 kg. Une masselotte de 0,75 kg est fixée sur sa jante. Le cerceau est posé sur un sol horizontal, la masselotte en haut, \
et poussé vers la droite. Frottement : μ = 1 ; g = 9,81 m/s².",phases:"phases","does it hop?":"saute-t-il ?","at which angle?":"à quel angle ?",Print:"Impri\
mer","The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student.":"La visite interroge avant de montrer ; la p\
résentation remplit l’écran ; le tableau donne des nombres à chaque élève."};var xs={roll:"滚动",spin:"空转",skid:"拖滑",flight:"腾空",skim:"擦地",hop:"跳起","slip −":"滑动 −","slip +":"滑动 +",rolls:"滚动",spins:"空\
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
"A full, B dotted; numbers and colours of {hoop}; {hands}":"A 为实线，B 为点线；数值与颜色属于 {hoop}；{hands}","{name} from {low} to {high}":"{\
name}：{low} 至 {high}","Diagram: {title} in {unit}.":"图：{title}，单位 {unit}。","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"{name} [{u\
nit}]","angle within a turn":"一圈内的角度","place of the centre":"圆心位置","gap under the rim":"圆环下的间隙","height of the centre of gravity":"\
重心高度","speed of the centre":"圆心速度","speed of rotation":"转动线速度","speed away from the plane":"离开平面的速度","slip velocity":"滑动\
速度","angular velocity":"角速度","normal force":"法向力","friction force":"摩擦力","use of friction":"摩擦利用率","kinetic energy":"动能","po\
tential energy":"势能","total energy":"总能量","Plane of θ and θ̇":"θ–θ̇ 相平面","Plane of angle and angular velocity with the regions of rollin\
g, slip and flight":"角度与角速度相平面，标出滚动、滑动与腾空区域","angle θ within a turn [°]":"一圈内的角度 θ [°]","no answer":"\
无解","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"颜色：无滑动接触之后的状态。阴影线：会遇到潘勒韦悖论的滑动。",
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
he screen; the table gives numbers to every student.":"参观先提问后演示；演示占满屏幕；数据表为每个学生提供数字。"};var qt=new Map;function U(i){try{return localStorage.getItem(i)??qt.get(i)??null}catch{return qt.get(i)??null}}function K(i,e){qt.set(i,e);try{localStorage.setItem(
i,e)}catch{}}var ze={en:"English",de:"Deutsch",es:"Español",fr:"Français",zh:"中文"},Nt={de:ys,es:vs,fr:ks,zh:xs},Qo=new Set(["de","es","fr"]),Ms="hophoop-language",zs=4e3,
Oe=/\{(\w+)\}/g,X="en",Es=[],Se=new Map,Me=new Set,Ee=new Set,$e=()=>X;function Ft(i){X=i in ze?i:"en",Se=new Map,Me=new Set,Ee.clear(),Es=Object.keys(Nt[X]??{}).
filter(e=>e.includes("{")).map(ti).sort((e,t)=>Ts(t.key)-Ts(e.key))}function ei(){let i=U(Ms);return i&&i in ze?i:(globalThis.navigator?.languages??[]).map(s=>s.
slice(0,2).toLowerCase()).find(s=>s in ze)??"en"}function As(i){K(Ms,i)}var Ts=i=>i.replace(Oe,"").length;function ti(i){let e=[...i.matchAll(Oe)].map(([,s])=>s),
t=i.split(/\{\w+\}/).map(s=>s.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));return{key:i,names:e,pattern:new RegExp(`^${t.join("(.+?)")}$`,"su")}}var se=i=>Qo.has(X)?i.
replace(/(\d)\.(\d)/g,"$1,$2"):i;function k(i,e){let t=Nt[X];if(e)return Q(Rs(t?.[i]??Ss(i),e));if(!t||!/\p{L}/u.test(i))return se(i);if(Me.has(i))return i;let s=Se.
get(i);if(s!==void 0)return s;let o=i.trim(),a=t[o]??si(o,t)??Ss(o),n=i.replace(o,()=>a);return Se.size>zs&&Se.clear(),Se.set(i,n),Q(n)}function Q(i){return Me.
size>zs&&Me.clear(),Me.add(i),i}var Ps=(i,e)=>i.replace(Oe,(t,s)=>String(e[s])),Rs=(i,e)=>i.replace(Oe,(t,s)=>k(String(e[s])));function si(i,e){for(let{key:t,pattern:s,
names:o}of Es){let a=i.match(s);if(a)return Rs(e[t],Object.fromEntries(o.map((n,r)=>[n,a[r+1]])))}return oi(i)}function oi(i){if(i.includes(" → "))return i.split(
" → ").map(e=>k(e)).join(" → ")}function Ls(i){if(!Nt[X])return i;let[,e,t]=i.match(/^(.*?)\.(?: (.*))?$/su)??["",i,""],{comma:s,stop:o}=X==="zh"?{comma:"，",
stop:"。"}:{comma:", ",stop:"."},n=`${e[0]?.toLowerCase()??""}${e.slice(1)}`.split(/, (?!\d)/).map(r=>k(r)).join(s);return Q(`${n[0]?.toLocaleUpperCase(X)??""}${n.
slice(1)}${o}${t?` ${k(t)}`:""}`)}function Ss(i){let e=/\p{L}{3,}/u.test(i)&&!/^([\w.[\]]+\.\w+|rad\/s|hophoop.*)$/u.test(i);return X!=="en"&&e&&Ee.size<200&&Ee.
add(i),se(i)}var Is=new WeakMap,Dt=new WeakMap;function Bt(i){let e=document.createTextNode(k(i));return Is.set(e,i),e}function Ae(i,e,t){let s=Dt.get(i)??{};s[e]=
t,Dt.set(i,s),i.setAttribute(e,k(t))}function Cs(i){let e=document.createTreeWalker(i,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let t=e.nextNode();t;t=e.
nextNode()){let s=Is.get(t);s!==void 0&&(t.nodeValue=k(s));let o=Dt.get(t);for(let[a,n]of Object.entries(o??{}))t.setAttribute(a,k(n))}}Ft(ei());var ii=new Set(["aria-label","title","placeholder","label"]);function h(i,e={},...t){let s=document.createElement(i),o=s;for(let[a,n]of Object.entries(e))n==null||
n===!1||(a.startsWith("on")?s.addEventListener(a.slice(2),n):a==="class"?s.className=n:a in s&&a!=="list"&&typeof n!="string"?o[a]=n:ii.has(a)?Ae(s,a,String(n)):
s.setAttribute(a,n===!0?"":n));for(let a of t.flat())a==null||a===!1||s.append(a.nodeType?a:Bt(String(a)));return s}function T(i,e){e?i.replaceChildren(Bt(e)):i.
replaceChildren()}var Ue=i=>i!==null&&i.getRootNode().activeElement===i,ee=i=>i.getContext("2d");function L(i){let e=i.getBoundingClientRect(),t=Math.min(globalThis.
devicePixelRatio||1,2.5),s=Math.max(Math.round(e.width*t),1),o=Math.max(Math.round(e.height*t),1);(i.width!==s||i.height!==o)&&(i.width=s,i.height=o);let a=ee(i);
return a.setTransform(t,0,0,t,0,0),{context:a,width:s/t,height:o/t}}function ai(i){if(/^#[0-9a-f]{6}$/i.test(i))return i;let e=ee(h("canvas",{width:1,height:1}));
e.fillStyle=i,e.fillRect(0,0,1,1);let[t,s,o]=e.getImageData(0,0,1,1).data;return`#${[t,s,o].map(a=>a.toString(16).padStart(2,"0")).join("")}`}function jt(i){let e=getComputedStyle(
i),t=o=>e.getPropertyValue(o).trim(),s=o=>ai(t(o));return{ink:s("--ink"),soft:s("--soft"),line:s("--line"),paper:s("--paper"),panel:s("--panel"),ground:s("--gro\
und"),font:t("--font"),dark:xe(s("--paper"))<.2}}function fe(i,e){let t=h("a",{href:URL.createObjectURL(i),download:e});document.body.append(t),t.click(),t.remove(),
setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function G(i,e){let t=0;return()=>{clearTimeout(t),t=setTimeout(i,e)}}var y=(i,e,t)=>Math.min(Math.max(i,e),t);function x(i,e=4){if(i==null)return"–";if(typeof i!="number")return String(i);if(!Number.isFinite(i))return Number.isNaN(
i)?"–":i>0?"∞":"−∞";if(i===0)return"0";let t=Math.abs(i),s;if(t>=1e6||t<1e-4){let[o,a]=i.toExponential(e-1).split("e");s=`${Ws(o)}·10${ni(Number(a))}`}else
s=Ws(i.toPrecision(e)),s.includes("e")&&(s=String(Math.round(i)));return se(s.replace("-","−"))}function Ws(i){return i.includes(".")&&!i.includes("e")?i.replace(
/\.?0+$/,""):i}function ni(i){let e={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(i)].map(t=>e[t]).join(
"")}var I=(i,e)=>e?e==="°"?`${i}°`:`${i} ${e}`:i,P=i=>se(`${(i*180/Math.PI).toFixed(1)}°`.replace("-","−"));function oe(i){let e=Math.abs(i),[t,s]=e>=.995?
[1,"m"]:e>=.00995?[100,"cm"]:[1e3,"mm"];return I(x(i*t,3),s)}function D(i,e){let t=i/Math.max(e,1),s=10**Math.floor(Math.log10(t)),o=t/s;return(o>5?10:o>2?5:o>1?
2:1)*s}function O(i,e,t){if(!(e>i)||!Number.isFinite(i)||!Number.isFinite(e))return[];let s=D(e-i,t),o=[];for(let a=Math.ceil(i/s-1e-9);a*s<=e+1e-9*s&&o.length<
200;a++)o.push(a*s);return o}function j(i,e){let t=y(-Math.floor(Math.log10(e)+1e-9),0,15);return Math.max(Math.abs(i),e)>=1e6||t>12?x(i,3):se((Math.abs(i)<e*1e-6?
0:i).toFixed(t).replace("-","−"))}var qs=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],ri="tfc",li=400;function Ds({time:i=0,options:e={},zoom:t=1,map:s}){let o=[];i>
0&&o.push(`t=${Number(i.toFixed(4))}`);let a=qs.filter(([n])=>e[n]).map(([,n])=>n);return a.join("")!==ri&&o.push(`show=${a.join("")}`),t!==1&&o.push(`zoom=${Number(
t.toPrecision(3))}`),s&&o.push(`map=${[s.what,...s.x,...s.y].join(",")}`),o.join("&")}function Ns(i){let e=new URLSearchParams(i.replace(/^#/,"")),t={},s=Number(
e.get("t")??Number.NaN);s>=0&&(t.time=s);let o=e.get("show");o!==null&&(t.options=Object.fromEntries(qs.map(([g,b])=>[g,o.includes(b)])));let a=Number(e.get("zo\
om")??Number.NaN);a>0&&(t.zoom=y(a,.05,60));let[n,r,l,c,d,u,p]=e.get("map")?.split(",")??[],m=[l,c,u,p].map(Number);return p!==void 0&&m.every(Number.isFinite)&&
m[0]<m[1]&&m[2]<m[3]&&(t.map={what:n,x:[r,m[0],m[1]],y:[d,m[2],m[3]]}),t}var hi=()=>{let i=new URLSearchParams(location.hash.slice(1)).get("with");return[location.
search.slice(1),...i===null?[]:[i]]},Ke=class{constructor(e){this.lab=e,this.number=0,this.soon=G(()=>this.write("same"),li),this.listen=()=>this.arrived(),addEventListener(
"popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(e){let{lab:t}=this;if(!t.motions.lanes.length)return;let s=t.link();e==="step"?
history.pushState({number:++this.number},"",s):history.replaceState({number:this.number},"",s)}travel(e){return new Promise(t=>{let s=()=>t();addEventListener("\
popstate",s,{once:!0}),setTimeout(s,300),history.go(e)})}async arrived(){let e=history.state?.number??0,t=hi();JSON.stringify(t)===JSON.stringify(this.lab.motions.
queries())?this.number=e:await this.lab.motions.arrive(t)?this.number=e:e!==this.number&&history.go(this.number-e)}};var ci={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function ge(i){let e=i instanceof DataView||ArrayBuffer.isView(i)?i:new DataView(i),t=new Uint8Array(e.buffer,
e.byteOffset,e.byteLength);t.byteOffset%8&&(t=t.slice());let s=new DataView(t.buffer,t.byteOffset).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(t.subarray(
4,4+s))),a={};for(let{name:n,type:r,shape:l,place:c}of o.arrays){let d=l.reduce((u,p)=>u*p,1);a[n]=new ci[r](t.buffer,t.byteOffset+4+s+c,d)}return{header:o,arrays:a}}var Pe=class extends Error{},di=500,ui=4,pi="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";async function Fs(i,e,t){
for(;;)try{return await i()}catch(s){if(!(s instanceof Pe))throw s;e(s.message),await new Promise(o=>setTimeout(o,di)),t.throwIfAborted()}}var Ge=class{constructor(e){
this.base=e,this.shares=!0}async call(e,t,s){let o={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(t),signal:s},a=await this.answered(
new URL(`lab/${e}`,this.base),o);if(a.status===202)throw new Pe((await a.json()).detail);return ge(await a.arrayBuffer())}async answered(e,t){for(let s=ui;;s--){
let o=await fetch(e,t).catch(n=>{throw n.name==="AbortError"?n:new Error(pi)});if(o.ok)return o;let a=Number(o.headers.get("Retry-After"));if(o.status!==503||!(a>
0)||s<=1){let n=await o.json().catch(()=>({}));throw new Error(n.detail??`The server answered ${o.status}.`)}await new Promise(n=>setTimeout(n,1e3*Math.min(a,10))),
t?.signal?.throwIfAborted()}}async file(e,t){return(await this.answered(new URL(`api/v1/files/${e}?${t}`,this.base))).blob()}link(e,t){return`${new URL(e?`?${e}`:
"",this.base)}${t}`}},mi=2e4,fi=3e5,Ve=class{constructor(e){this.model=e,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).
slice(2),this.listen=(t,s)=>this.answered(t,s),e.on("msg:custom",this.listen)}answered(e,t){let s=e?.view===this.view&&this.waiting.get(e.number);s&&(clearTimeout(
s.timer),this.waiting.delete(e.number),e.compiling?s.reject(new Pe(e.compiling)):e.error?s.reject(new Error(e.error)):s.resolve(ge(t[0])))}call(e,t,s){let o=++this.
number;return new Promise((a,n)=>{let r=setTimeout(()=>{this.waiting.delete(o),n(new Error("The notebook’s kernel does not answer; run the cell again."))},e===
"file"?fi:mi);this.waiting.set(o,{resolve:a,reject:n,timer:r}),s?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(o),n(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:o,call:e,body:t})})}async file(e,t){let{arrays:s}=await this.call("file",{query:t,name:e});return new Blob(
[s.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};var Re=[.05,.1,.25,.5,1,2,4],Ye=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let e of this.listeners)e(this)}seek(e){this.time=y(e,0,this.duration),this.changed()}play(e=!this.playing){this.playing=e,this.last=null,e&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(e){let t=Re.indexOf(this.speed);this.speed=Re[y(t+e,0,Re.length-1)],this.changed()}tick(e){if(!this.playing)return!1;
let t=this.last===null?0:Math.min(e-this.last,100)/1e3;return this.last=e,this.time+=t*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function gi(i,e=""){let t=i.trim();e&&t.endsWith(e)&&(t=t.slice(0,-e.length)),t=t.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(o,a,n)=>`e${a&&"-"}${n.normalize("NFKD")}`);let s=/^([+-]?)(inf|infinity|∞)$/i.exec(t);return s?s[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(t)?Number(t.replace(",",".")):Number.NaN}function wi(i,e,{label:t,unit:s,range:o}){let a=i.trim();if(Number.isNaN(e))return`${t} = ${a} must be a number, s\
uch as 2.5.`;if(!o||e>=o.least&&e<=o.most||o.also.includes(e))return"";let n=o.also.includes(0)?"0 or ":"",r=`from ${x(o.least,4)} to ${I(x(o.most,4),s)}`,l=o.also.
includes(1/0)?", or inf":"";return`${t} = ${I(x(e,6),s)} must be ${n}${r}${l}.`}var bi=0,we=class{constructor(e,t){this.info=e,this.onvalue=t,this.shown="",this.
typing=!1,this.error=h("p",{class:"error",role:"alert",id:`hh-error-${++bi}`,hidden:!0}),this.input=h("input",{type:"text",inputmode:"decimal",autocomplete:"off",
spellcheck:"false",class:"exact","aria-label":e.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:s=>{
s.key!=="Escape"||!(this.typing||this.refused())||(s.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute("aria-invalid")==="true"}typed(){
let e=this.input.value;if(!this.typing)return;if(this.typing=!1,e.trim()===""){this.restore();return}let t=gi(e,this.info.unit),s=wi(e,t,this.info);s?this.refuse(
s):this.onvalue(t)}refuse(e){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.id),T(this.error,e),this.error.
hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){this.typing=!1,this.
input.value=this.shown,this.accept()}show(e){this.shown=se(e),this.typing||this.restore()}};var Bs={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},yi={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},vi=(i,e,t)=>({ring:{shape:i,mass:t,inner_radius:.95*e,outer_radius:e},disk:{shape:i,mass:t,radius:.1*
e,at:.8*e},point_mass:{shape:i,mass:t,at:e},rod:{shape:i,mass:t,length:.5*e,at:.5*e}})[i];function js(i){let e=i["hoop.radius"],t=i["hoop.mass"],s=Math.min(Math.
max(i["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:Je(t*(1-s)),inner_radius:Je(.98*e),outer_radius:e},{shape:"point_mass",mass:Je(t*s),at:e}]}var Je=i=>Number(
i.toPrecision(6)),Ze=class{parts;text;radius;mass;constructor(e){this.onchange=e,this.list=h("div",{class:"parts"}),this.element=h("div",{},this.list,h("select",
{"aria-label":"Add a part",onchange:t=>{let s=t.target.value;t.target.value="",s&&this.send([...this.parts,vi(s,this.radius,Je(.2*this.mass))])}},h("option",{value:""},
"+ add a part …"),Object.entries(Bs).map(([t,{label:s}])=>h("option",{value:t},s))))}send(e){this.onchange([["hoop.parts",e]])}show(e,t,s){let o=JSON.stringify(
e);if(o===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=e;return}Object.assign(this,{text:o,parts:e,radius:t,mass:s}),this.list.
replaceChildren(...e.map((a,n)=>this.row(a,n)))}row(e,t){let{label:s,keys:o}=Bs[e.shape];return h("fieldset",{class:"part"},h("legend",{},s,this.parts.length>1&&
h("button",{type:"button",class:"quiet","aria-label":`Remove part ${t+1}, ${s}`,onclick:()=>this.send(this.parts.filter((a,n)=>n!==t))},"×")),o.map(a=>this.field(
e,t,a)))}field(e,t,s){let[o,a]=yi[s],n=new we({label:o,unit:a},r=>this.send(this.parts.map((l,c)=>c===t?{...l,[s]:r}:l)));return n.show(String(e[s]??0)),h("div",
{},h("label",{},`${o} [${a}]`,n.input),n.error)}};var _t=Math.PI/180;function ki({allowed:i,degrees:e}){if(!i)return;let t=e?1/_t:1;return{least:i.least*t,most:i.most*t,also:i.also.map(s=>s==="inf"?1/0:Number(s))}}
var Ht=class{constructor(e,t){this.info=e,this.onchange=t,this.held=!1;let s=`hh-${e.path}-${Math.random().toString(36).slice(2,7)}`,o=l=>()=>{this.held=l};this.
range=h("input",{type:"range",id:s,class:"slider",min:String(this.low()),max:String(this.high()),step:e.logarithmic?"0.01":String(e.step),"data-path":e.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:o(!0),onpointerup:o(!1),onpointercancel:o(!1),onblur:o(!1)});let{label:a,unit:n}=e,r=`${a}, exact value${n?` i\
n ${n}`:""}`;this.entry=new we({label:a,unit:n,name:r,range:ki(e)},l=>this.send(l,!0)),this.element=h("div",{class:"control",title:e.help},h("label",{for:s},h("\
span",{},a),h("span",{class:"symbol"},e.symbol)),this.range,h("span",{class:"entry"},this.entry.input,h("span",{class:"unit"},n)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(e){let t=Number(
this.range.value),s=this.info.logarithmic?Number((10**t).toPrecision(3)):t;this.entry.typing=!1,this.entry.show(String(s)),this.say(s),this.send(s,e)}send(e,t){
let s=this.info.degrees?e*_t:e;this.onchange([[this.info.path,Number.isFinite(s)?s:"inf"]],t)}say(e){this.range.setAttribute("aria-valuetext",I(x(e,4),this.info.
unit))}show(e,t=null){if(this.held)return;let s=e!=null,o=s?e:t;if(o==null){this.entry.show("");return}let a=o==="inf"?1/0:Number(o)/(this.info.degrees?_t:1);this.
entry.show(s?Number.isFinite(a)?String(Number(a.toPrecision(9))):"∞":""),this.entry.input.placeholder=s?"":k("auto {value}",{value:x(a,2)}),this.entry.input.title=
s?I(String(a),this.info.unit):"";let n=y(this.info.logarithmic?Math.log10(a):a,this.low(),this.high());Math.abs(Number(this.range.value)-n)>1e-6&&(this.range.value=
String(n)),this.say(a)}};function xi(i,e){let t=h("select",{"data-path":i.path,onchange:()=>e([[i.path,t.value]],!0)},i.options.map(([o,a])=>h("option",{value:o},
a)));return{element:h("label",{class:"choice",title:i.help},h("span",{},i.label),t),select:t,path:i.path}}var Xe=class{way;kind;gravity;apart;derived;film;constructor(e,t){
this.onchange=(s,o=!0)=>t(s,o),this.sliders=new Map;for(let s of Object.values(e.groups))for(let o of s)this.sliders.set(o.path,new Ht(o,this.onchange));this.choices=
new Map(e.choices.map(s=>[s.path,xi(s,this.onchange)])),this.parts=new Ze(this.onchange),this.gravities=e.gravities,this.element=h("div",{class:"controls"},this.
hoop(),this.plane(),this.start(),this.contact())}at(e){let t=this.sliders.get(e)??this.choices.get(e);if(!t)throw new Error(`There is no control of ${e}.`);return t.
element}select(e,t,s){let o=h("select",{onchange:()=>s(o.value)},t.map(([a,n])=>h("option",{value:a},n)));return{select:o,element:h("label",{class:"choice"},h("\
span",{},e),o)}}group(e,...t){let s=e==="Start"||e==="Plane"||!matchMedia("(max-width: 760px)").matches;return h("details",{class:"group",open:s},h("summary",{},
e),t)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],e=>{let{values:t}=this.
film;e==="parts"?this.onchange([["hoop.parts",js(t)]]):this.onchange([[`hoop.${e}`,t["hoop.eccentricity"]]])}),this.derived=h("p",{class:"derived"}),this.group(
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
this.film,new Set)}show(e,t=new Set){this.film=e,this.showChoices(e,t);let s=e.scenario;for(let[o,a]of this.sliders){if(t.has(o))continue;let[n,r]=o.split(".");
a.show(e.values[o]??(r?s[n]?.[r]:s[n]),e.automatic?.[o])}}showChoices(e,t){let{scenario:s,values:o}=e,a=s.hoop.parts?"parts":"load_fraction"in s.hoop?"load_frac\
tion":"eccentricity",n="speed"in s.start,r="mu_static"in s.plane,l=s.contact.model==="compliant",c=(...m)=>m.some(g=>t.has(g));c("hoop.load_fraction","hoop.ecce\
ntricity","hoop.parts")||(this.way.select.value=a),c("start.speed","start.omega")||(this.kind.select.value=n?"rolling":"free"),c("plane.mu","plane.mu_static")||
(this.apart.checked=r);let d=this.gravities.find(([,m])=>Math.abs(m-s.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=d?d[0]:"");let u={"hoo\
p.load_fraction":a==="load_fraction","hoop.eccentricity":a==="eccentricity","hoop.inertia_ratio":a==="eccentricity","hoop.mass":a!=="parts","plane.mu":!r,"plane\
.mu_static":r,"plane.mu_kinetic":r,"plane.restitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":n,"start.height":!n,"start.vx":!n,"start.vy":!n,
"start.omega":!n,"contact.law":l,"contact.friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[m,g]of Object.entries(u))this.
at(m).hidden=!g;this.parts.element.hidden=a!=="parts",s.hoop.parts&&this.parts.show(s.hoop.parts,o["hoop.radius"],o["hoop.mass"]),this.derived.textContent=a==="\
eccentricity"?"":`ε = ${x(o["hoop.eccentricity"],5)}, κ = ${x(o["hoop.inertia_ratio"],5)}`+(a==="parts"?`, m = ${x(o["hoop.mass"],5)} kg`:"");let p=s;for(let[
m,{select:g}]of this.choices){if(t.has(m))continue;let[b,w]=m.split(".");p[b]?.[w]!==void 0&&(g.value=p[b][w])}}};var Ot=Math.PI/180;function _s(i,e){let{start:t,plane:s,contact:o,hoop:a}=i.scenario;return o.model!=="rigid"?"Rigid contact only.":i.slope!==0?"The plane must \
be level.":Math.abs(i.gravity-9.81)>1e-9?"It must be on Earth.":(s.restitution??0)!==0?"Restitution must be 0.":i.radius!==1||a.parts?"The radius must stay 1 m,\
 without parts.":i.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in a?"speed"in t?Math.abs(t.speed??3.1)>e+1e-9?e>5?"At most 10 \
m/s.":"At most 3.1 m/s.":i.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var Hs=i=>i.events.filter(
({kind:e})=>e==="takeoff");function Ti(i){return i.events.filter(({kind:e})=>e==="apex").map(({height:e})=>e)}var Os=(i,e)=>Math.min(Math.round(100*i/e),100),Si=1.596,
Mi=.37,zi=.05,$t=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:i=>{let e=_s(i,3.1);if(e)return{points:0,text:e};let t=Math.max(
0,...Ti(i));return t?{points:Os(t,Si),text:"It rises by {height}.",values:{height:oe(t)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land uprigh\
t",text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=\
0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:i=>{let e=Hs(i)[0],t=i.events.find(({kind:n,t:r})=>n==="impact"&&e&&r>e.t);if(!e||!t)return{
points:0,text:"It does not hop."};let s=i.events.find(({kind:n,t:r})=>n==="apex"&&r>e.t);if(!s||s.height<zi)return{points:0,text:"The first hop is too low."};let o=Math.
abs(t.angle-2*Math.PI*Math.round(t.angle/(2*Math.PI)))/Ot,a=Math.max(0,Math.round(100*(1-(o-.5)/89.5)));return{points:Math.min(a,100),text:"It lands {off} away \
from the top.",values:{off:P(o*Ot)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:i=>{let e=_s(i,10);if(e)return{points:0,text:e};if(Math.
abs(Math.abs(i.scenario.start.angle??0)-Math.PI)>.5*Ot)return{points:0,text:"The load must start at the bottom."};if(i.values["plane.mu_kinetic"]>1.5||i.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let t=Hs(i)[0];if(!t)return{points:0,text:"It does not hop."};let s=i.phases.filter(
({from:a})=>a<t.t);if(s.some(({mode:a})=>a==="K"))return{points:0,text:"It skids before it hops."};if(s[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let o=i.events.find(({kind:a,t:n})=>a==="apex"&&n>t.t);return o?{points:Os(o.height,Mi),text:"It rises by {height}.",values:{height:oe(o.height)}}:{points:0,
text:"It does not hop."}}}],Ut=i=>i>=95?3:i>=75?2:i>=40?1:0;var $s="hophoop-best-",Ei=i=>"★".repeat(Ut(i))+"☆".repeat(3-Ut(i)),Qe=class{goal=null;constructor(e){this.lab=e,this.tabs=new Map($t.map(t=>[t.key,h("button",
{type:"button","aria-pressed":"false",onclick:()=>this.choose(t)},t.title)])),this.text=h("p",{}),this.meter=h("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"\
100","aria-label":"Score"}),this.result=h("p",{class:"challenge-result",role:"status"}),this.kept=h("p",{class:"hint"}),this.element=h("section",{class:"challen\
ges card","aria-label":"Challenges",hidden:!0},h("header",{},h("h2",{},"Challenges"),h("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",
onclick:()=>this.close()},"×")),h("div",{class:"tabs",role:"group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.
kept,h("div",{class:"buttons"},h("button",{type:"button",onclick:()=>this.goal&&this.load(this.goal.start)},"Begin again"),h("button",{type:"button",onclick:()=>this.
goal&&this.load(this.goal.best)},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??$t[0]),this.element.scrollIntoView({block:"nearest"}),
this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(e){this.goal=e;for(let[t,s]of this.tabs)s.setAttribute(
"aria-pressed",String(t===e.key));T(this.text,e.text),this.changed()}async load(e){let{lab:t}=this;try{let s=await t.backend.call("film",{query:e});t.clock.play(
!1),t.clock.time=0,t.motions.replace(s)}catch(s){t.notice.fail(s)}}changed(){let{goal:e,lab:t}=this;if(!e)return;let{points:s,text:o,values:a={}}=e.score(t.film());
this.meter.value=s;let n=k("{stars} {points} points. {what}",{stars:Ei(s),points:s,what:k(o,a)});this.result.textContent!==n&&(this.result.textContent=n);let r=Number(
U($s+e.key)??0);s>r&&!t.stage.options.ahead&&K($s+e.key,String(s)),T(this.kept,k("Your best: {points} points.",{points:Math.max(r,t.stage.options.ahead?0:s)}))}};var Us=.09,Ai=.03,Kt=Math.PI/180,et=Math.PI/4,Ks=2*Math.PI,Le=i=>i-Ks*Math.round(i/Ks);function tt(i,e){let t=i.at(e),s=e===0;return{angle:Le(t.angle),height:Math.
max(t.height,0),vx:s?t.vx:0,vy:s?t.vy:0,omega:s?t.omega:0,slope:i.slope}}var Gs=i=>2*Math.sqrt(Math.max(i.gravity,1)*i.radius),ie=i=>Number(i.toFixed(4))+0;function Vs(i,e,t){
if(i==="plane")return[["plane.slope",ie(e.slope)]];if(e.height>0)return[["start.angle",ie(e.angle)],["start.height",ie(e.height)],["start.vx",ie(e.vx)],["start.\
vy",ie(e.vy)],["start.omega",ie(e.omega)]];let s=i==="load"?e.omega*t.radius:e.vx;return[["start.angle",ie(e.angle)],["start.speed",ie(s)]]}var Ie=class{constructor(e,t,s,o,a){
this.grip=e,this.film=t,this.view=o,this.before=tt(t,s),this.held={...this.before,vx:0,vy:0,omega:0};let n=t.at(s);this.center=[n.x,t.radius+n.height],this.foot=
o.point(n.x,0),this.from=this.read(a),this.turned=0,this.trail=[],this.moved=0}read(e){let[t,s]=this.view.unpoint(e.clientX,e.clientY),o=this.grip==="plane"?Math.
atan2(e.clientY-this.foot[1],e.clientX-this.foot[0]):Math.atan2(t-this.center[0],s-this.center[1]);return{x:e.clientX,y:e.clientY,along:t,away:s,turn:o}}move(e,t){
let s=this.read(e),{radius:o}=this.film;if(this.turned+=Le(s.turn-this.from.turn-this.turned),this.grip==="plane"){let a=y(this.before.slope+this.turned,-et,et);
this.held.slope=Math.abs(a)<Kt?0:a}else if(this.grip==="load")this.held.angle=Le(this.before.angle+this.turned);else{let a=this.before.height+s.away-this.from.away;
this.held.height=a<Ai*o?0:a;let n=s.along-this.from.along;this.held.angle=Le(this.before.angle+(this.held.height>0?0:n/o)),this.moved=s.x-this.from.x}for(this.trail.
push({t:t/1e3,along:s.along,away:s.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<t/1e3-Us;)this.trail.shift();return this.held}release(e){let{held:t,
trail:s,film:o}=this,a=s.at(-1),n=s[0],r=a&&n?a.t-n.t:0,l=!a||r<.012||e/1e3-a.t>Us,c=Gs(o);return l||this.grip==="plane"||(this.grip==="load"?t.omega=y((a.turned-
n.turned)/r,-c/o.radius,c/o.radius):(t.vx=y((a.along-n.along)/r,-c,c),t.vy=t.height>0?y((a.away-n.away)/r,-c,c):0)),t}};function Ys(i,e,t,s,o){let a={ArrowLeft:-1,
ArrowRight:1}[e]??0,n={ArrowDown:-1,ArrowUp:1}[e]??0;if(!a&&!n)return null;let r=t?.2:1;if(i==="load"){let u=Le(s.angle+(a||n)*5*Kt*r);return{...s,angle:u}}if(i===
"plane"){let u=y(s.slope+(a||-n)*Kt*r,-et,et);return{...s,slope:Math.abs(u)<1e-9?0:u}}let l=Gs(o),c=y(s.height+n*.05*r*o.radius,0,4*o.radius),d=y(s.vx+a*.1*r,-l,
l);return{...s,height:c<1e-9?0:c,vx:d}}function C(i,e,t,s=()=>{}){let o=new AbortController,{signal:a}=o,n=(l,c)=>i.addEventListener(l,d=>d.pointerId===e.pointerId&&c(d),{signal:a}),r=l=>c=>{o.abort(),
s(c,l)};i.setPointerCapture(e.pointerId),n("pointermove",t),n("pointerup",r(!0)),n("pointercancel",r(!1))}function Js(i,e){let t=new Map,s=null,o=()=>{let[n,r]=[
...t.values()];return{span:Math.max(Math.hypot(n.clientX-r.clientX,n.clientY-r.clientY),1),clientX:.5*(n.clientX+r.clientX),clientY:.5*(n.clientY+r.clientY)}};i.
addEventListener("pointerdown",n=>{n.pointerType!=="mouse"&&(t.set(n.pointerId,n),s=t.size===2?o():null)}),i.addEventListener("pointermove",n=>{if(!t.has(n.pointerId)||
(t.set(n.pointerId,n),t.size!==2||!s))return;let r=o();e(r.span/s.span,r),s=r});for(let n of["pointerup","pointercancel"])i.addEventListener(n,r=>{t.delete(r.pointerId),
s=null});let a=n=>n.touches.length>1&&n.cancelable&&n.preventDefault();return i.addEventListener("touchmove",a,{passive:!1}),()=>t.size>1}var Pi=700,Gt=44,Ri=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],st=class{static Pull=Ie;pull=null;held=null;before=null;constructor(e){this.
lab=e,this.places=new Map(Ri.map(([a,n,r])=>[a,this.place(a,n,r)])),this.tip=h("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=h("div",
{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.values()],this.tip),e.stage.element.before(this.element);let{flat:t,plane:s}=e.
stage;t.grab=a=>this.take(a),s.addEventListener("pointermove",a=>this.hover(a)),s.addEventListener("pointerleave",()=>this.hover(null));let o=a=>this.pull&&a.cancelable&&
a.preventDefault();s.addEventListener("touchmove",o,{passive:!1}),this.settle=G(()=>this.chosen(!1),Pi)}place(e,t,s){return h("div",{class:`grip grip-${e}`,role:"\
slider",tabindex:"0","aria-label":t,"aria-valuenow":"0",title:s,onkeydown:o=>this.key(e,o),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.
flat.views[this.lab.motions.active]}draw(){let{lab:e}=this,t=this.view(),s=!!t&&!e.stage.options.three;if(this.element.hidden=!s,!s)return;this.element.classList.
toggle("running",e.clock.playing);let{pose:o,film:a,scale:n}=t,r=a.radius,l=t.point(o.x,r+o.height),c=t.point(o.x+r*Math.sin(o.angle),r+o.height+r*Math.cos(o.angle)),
d=this.onPlane(t),u=y(1.1*r*n,Gt,190),p=[["plane",d,Gt],["hoop",l,u],["load",c,Gt]];for(let[m,[g,b],w]of p){let f=this.places.get(m);f.style.transform=`translat\
e(${g-w/2}px, ${t.top+b-w/2}px)`,f.style.width=f.style.height=`${w}px`,f.hidden=g<0||b<0||g>t.width||b>t.height}e.clock.playing||this.tell(a)}onPlane(e){let t=e.
point(e.pose.x,0),o=(Math.min(t[0]+Math.max(1.9*e.film.radius*e.scale,90),e.width-30)-t[0])/(e.scale*Math.max(e.cosine,.2));return e.point(e.pose.x+o,0)}tell(e){
let t=this.pull?.held??this.held??tt(e,this.lab.clock.time),s={load:P(t.angle),hoop:k("gap {height}, speed {speed} m/s",{height:oe(t.height),speed:x(t.vx,3)}),plane:P(
t.slope)},o={load:t.angle*(180/Math.PI),hoop:t.height,plane:t.slope*(180/Math.PI)},a={load:[-180,180],hoop:[0,4*e.radius],plane:[-45,45]};for(let[n,r]of this.places)
r.getAttribute("aria-valuetext")!==s[n]&&(r.setAttribute("aria-valuetext",s[n]),r.setAttribute("aria-valuenow",String(Number(o[n].toPrecision(4)))),r.setAttribute(
"aria-valuemin",String(a[n][0])),r.setAttribute("aria-valuemax",String(Number(a[n][1].toPrecision(4)))))}under(e){if(this.element.hidden)return null;let t=null;
for(let[s,o]of this.places){let{left:a,top:n,width:r}=o.getBoundingClientRect(),l=Math.hypot(e.clientX-a-r/2,e.clientY-n-r/2);!o.hidden&&l<=r/2&&(t=s)}return t}hover(e){
if(this.pull)return;let t=e&&e.pointerType!=="touch"?this.under(e):null;for(let[s,o]of this.places)o.classList.toggle("near",s===t);this.lab.stage.plane.style.cursor=
t?"grab":""}take(e){let t=this.under(e);if(!t||e.button>0||this.pull)return!1;let{lab:s}=this,{flat:o,plane:a}=s.stage,n=this.places.get(t),r=this.view(),l=a.getBoundingClientRect(),
c=f=>({clientX:f.clientX-l.left,clientY:f.clientY-l.top-r.top}),d=new Ie(t,s.film(),s.clock.time,r,c(e)),u=[...o.shift],[p,m]=[!1,!1];this.pull=d,n.classList.add(
"held");let g=()=>{m=!0,b.abort(),n.classList.remove("held"),o.fixed=null,this.pull=null,p&&this.comeBack(u)},b=new AbortController,w=f=>{f.key==="Escape"&&(f.stopPropagation(),
g(),p&&this.back())};return addEventListener("keydown",w,{capture:!0,signal:b.signal}),C(a,e,f=>{if(!m){if(o.pinched()){g(),p&&this.back();return}!p&&Math.hypot(
f.clientX-e.clientX,f.clientY-e.clientY)<3||(p||(o.fixed=r.scale,this.hold(),this.begin()),p=!0,d.move(c(f),f.timeStamp),o.shift=[u[0]+d.moved,u[1]],this.change(
t,d.held,!1),this.show(t,d.held))}},(f,v)=>{m||(g(),p&&(v?(this.change(t,d.release(f.timeStamp),!0),this.end(!0)):this.back()))}),!0}key(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return;let{lab:s}=this;if(t.key==="Escape"&&this.held)this.back();else if(t.key==="Enter")this.chosen(!0);else{this.held??=tt(s.film(),s.clock.time);let o=Ys(
e,t.key,t.shiftKey,this.held,s.film());if(!o)return;this.before===null&&(this.hold(),this.begin()),this.held=o,this.change(e==="load"?"hoop":e,o,!1),this.show(e,
o),this.settle()}t.preventDefault(),t.stopPropagation()}hold(){this.lab.clock.play(!1),this.before=this.lab.film().query}begin(){let{lab:e}=this;e.stage.options.
ahead=!0,e.clock.seek(0),e.root.classList.add("holding")}change(e,t,s){this.lab.motions.change(Vs(e,t,this.lab.film()),s)}show(e,t){let s={load:`θ = ${P(t.angle)}`,
hoop:t.height>0?`y = ${oe(t.height)}`:`θ = ${P(t.angle)}`,plane:`β = ${P(t.slope)}`};T(this.tip,t.vx&&this.held?`${s[e]}, v = ${x(t.vx,3)} m/s`:s[e]),this.tip.
hidden=!1}chosen(e){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(e)}end(e){let{lab:t}=this;this.held=null,this.before=null,this.tip.hidden=
!0,t.stage.options.ahead=!1,t.root.classList.remove("holding"),e&&t.clock.seek(0),e&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&t.clock.play(!0),t.
request()}async back(){let{lab:e,before:t}=this;if(this.end(!1),t===null)return;let s=e.motions.lanes[e.motions.active];for(s.pending=null;s.busy;)await new Promise(
o=>requestAnimationFrame(o));try{e.motions.replace(await e.backend.call("film",{query:t}))}catch(o){e.notice.fail(o)}}comeBack(e){let{flat:t}=this.lab.stage,s=matchMedia(
"(prefers-reduced-motion: reduce)").matches,o=()=>{if(this.pull)return;let a=t.shift[0]-e[0];t.shift=Math.abs(a)<1||s?[...e]:[e[0]+.82*a,e[1]],this.lab.request(),
t.shift[0]!==e[0]&&requestAnimationFrame(o)};o()}};var Li={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function W(i){let e="\
http://www.w3.org/2000/svg",t=document.createElementNS(e,"svg");t.setAttribute("viewBox","0 0 17 17"),t.setAttribute("aria-hidden","true"),t.setAttribute("class",
"icon");let s=document.createElementNS(e,"path");return s.setAttribute("d",Li[i]),t.append(s),t}var ot=class{constructor(e){this.lab=e,this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener("fullscreenchange",this.left),
this.full=!1,this.on=!1,this.onchange=()=>{}}async turn(e=!this.on){let{root:t}=this.lab;if(this.on=e,t.classList.toggle("presenting",e),this.onchange(),this.lab.
show(),!e){let s=this.full;this.full=!1,s&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await t.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var Zs=.22,Xs=.03;function Qs(i,e){let t=i.at(e),s=i.mass*(i.gravity||9.81),o=t.mode==="H"||!(t.normal_force>0)?0:t.normal_force/s,a=o/(1+o),n=t.mode==="S"||t.mode===
"K",r=Math.abs(t.slip)/Math.sqrt((i.gravity||9.81)*i.radius);return{tone:a,pitch:55*(1+Math.min(o,8))**.5,hiss:n?a*y(.15+r,0,1):0}}function eo(i,e,t){let s=Math.
sqrt(2*(i.gravity||9.81)*i.radius);return i.events.filter(({kind:o,t:a,before:n})=>o==="impact"&&n&&a>e&&a<=t).map(({before:o})=>y(Math.abs(o.vy)/s,.02,1))}function Ii(i){
let e=i.createBuffer(1,i.sampleRate,i.sampleRate),t=e.getChannelData(0),s=1;for(let o=0;o<t.length;o++)s=s*16807%2147483647,t[o]=2*s/2147483647-1;return e}var it=class{static heard=Qs;static knocks=eo;context=null;on=!1;last=0;start(){
let e=new AudioContext,t=e.createOscillator();t.type="triangle";let s=e.createBufferSource();s.buffer=Ii(e),s.loop=!0;let o=e.createBiquadFilter();o.type="bandp\
ass",o.frequency.value=1800,o.Q.value=.6;let[a,n]=[e.createGain(),e.createGain()];a.gain.value=n.gain.value=0,t.connect(a).connect(e.destination),s.connect(o).connect(
n).connect(e.destination),t.start(),s.start(),this.context=e,Object.assign(this,{tone:t,low:a,high:n})}turn(e){this.on=e,e&&!this.context&&this.start(),e?this.context?.
resume():this.context&&(this.set("low",0),this.set("high",0))}set(e,t){let{gain:s}=this[e];s.setTargetAtTime(Zs*t,this.context.currentTime,Xs)}follow(e,t){if(!this.
on||!this.context)return;if(!t.playing){this.set("low",0),this.set("high",0),this.last=t.time;return}let{tone:s,pitch:o,hiss:a}=Qs(e,t.time);if(this.set("low",s),
this.set("high",.6*a),this.tone.frequency.setTargetAtTime(o,this.context.currentTime,Xs),t.time>this.last)for(let n of eo(e,this.last,t.time))this.knock(n);this.
last=t.time}knock(e){let t=this.context,s=t.currentTime,o=t.createGain();o.gain.setValueAtTime(2.2*Zs*Math.sqrt(e),s),o.gain.exponentialRampToValueAtTime(1e-4,s+
.18);let a=t.createOscillator();a.frequency.setValueAtTime(190,s),a.frequency.exponentialRampToValueAtTime(60,s+.15),a.connect(o).connect(t.destination),a.start(
s),a.stop(s+.2)}close(){this.context?.close()}};var Vt=Math.PI/180,N=i=>e=>e.columns[i],Ce=(i,e)=>t=>t.derived(i,s=>Float64Array.from(t.t,(o,a)=>e(s,a,t))),q={time:{name:"time",symbol:"t",unit:"s",values:i=>i.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:Ce("degrees",({angle:i},e)=>i[e]/Vt)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:Ce(
"within",({angle:i},e)=>{let t=s=>Math.floor(i[s]/Vt/360);return e>0&&t(e)!==t(e-1)?Number.NaN:i[e]/Vt-360*t(e)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:N("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:N("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:Ce(
"rise",({height:i,angle:e},t,s)=>s.radius*(1+s.eccentricity*Math.cos(e[t]))+i[t])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:N("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:Ce("spin",({omega:i},e,t)=>i[e]*t.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:N(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:N("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:N("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:N("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:N("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:N("utilization")},kinetic:{name:"kinetic energy",symbol:"E_k",unit:"J",values:N("kinetic")},potential:{name:"\
potential energy",symbol:"E_p",unit:"J",values:N("potential")},total:{name:"total energy",symbol:"E",unit:"J",values:Ce("total",({kinetic:i,potential:e},t)=>i[t]+
e[t])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:N("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:N("normal_loss")}},to=({name:i,symbol:e})=>[i," ",e];var Ci=["time","angle","x","vx","spin","normal_force","friction_force"],Wi=[1,.5,.2,.1,.05,.02,.01],Yt=601;function so(i,e,t){let s=Math.min(Math.floor(i.duration/
t+1e-9)+1,Yt),o=[];for(let a=0;a<s;a++){let n=Number((a*t).toPrecision(12));o.push({time:n,mode:i.at(n).mode,values:e.map(r=>qi(i,r,n))})}return o}function qi(i,e,t){
if(e==="time")return t;let s=i.at(t);if(e in s&&e!=="angle")return s[e];let o=s.angle*180/Math.PI;if(e==="angle")return o;if(e==="turns")return o-360*Math.floor(
o/360);let a=q[e].values(i),n=i.index(t),r=Math.min(n+1,i.length-1),l=i.t[r]>i.t[n]?(t-i.t[n])/(i.t[r]-i.t[n]):0;return a[n]+l*(a[r]-a[n])}var at=class{film;rows=[];now;constructor(e){
this.lab=e,this.columns=[...Ci],this.step=h("select",{onchange:()=>this.fill()},Wi.map(t=>h("option",{value:String(t)},`${t} s`))),this.step.value="0.1",this.picks=
h("div",{class:"table-picks"},Object.entries(q).filter(([t])=>t!=="time").map(([t,{name:s}])=>this.pick(t,s))),this.caption=h("caption",{}),this.head=h("thead",
{}),this.body=h("tbody",{}),this.element=h("section",{class:"table","aria-label":"Table of the motion",hidden:!0},h("header",{},h("h2",{},"Table"),h("label",{class:"\
table-step"},h("span",{},"Every"),this.step),h("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),h("button",{type:"button",onclick:()=>this.open(!1)},
"Close")),h("details",{class:"table-columns"},h("summary",{},"Columns"),this.picks),h("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table\
 of the motion, rows"},h("table",{},this.caption,this.head,this.body)))}pick(e,t){let s=h("input",{type:"checkbox",checked:this.columns.includes(e),onchange:()=>{
let o=new Set(this.columns);s.checked?o.add(e):o.delete(e),this.columns=Object.keys(q).filter(a=>o.has(a)),this.fill()}});return h("label",{},s,h("span",{},t))}open(e){
this.element.hidden=!e,e&&(this.draw(this.lab.film()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(e){this.
element.hidden||(this.film=e,this.fill())}fill(){let{film:e,columns:t}=this,s=Number(this.step.value),o=this.lab.theme.colors.mode_names,a=t.map(c=>q[c]);this.head.
replaceChildren(h("tr",{},a.map(({name:c,symbol:d,unit:u})=>h("th",{scope:"col",title:c},d,u&&h("small",{},` ${u}`))),h("th",{scope:"col"},"mode")));let n=so(e,
t,s);this.rows=n.map(({time:c,mode:d,values:u})=>({time:c,row:h("tr",{onclick:()=>this.lab.clock.seek(c)},u.map((p,m)=>m===0?h("th",{scope:"row"},x(p,4)):h("td",
{},x(p,4))),h("td",{class:"table-mode"},o[d]))})),this.body.replaceChildren(...this.rows.map(({row:c})=>c));let r=e.duration/s+1<=Yt+1e-6,l=k("The first {count}\
 rows.",{count:Yt});T(this.caption,r?e.summary:Q(`${e.summary} ${l}`)),this.cursor(this.lab.clock.time)}cursor(e){if(this.element.hidden||!this.rows.length)return;
let t=Number(this.step.value),s=this.rows[Math.min(Math.round(e/t),this.rows.length-1)]?.row;s!==this.now&&(this.now?.classList.remove("now"),s?.classList.add("\
now"),this.now=s)}save(){let{film:e,columns:t}=this,s=[...t.map(a=>`${q[a].name} [${q[a].unit||"1"}]`),"mode"],o=so(e,t,Number(this.step.value)).map(({mode:a,values:n})=>[
...n,a].join(","));fe(new Blob([[s.join(","),...o,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var oo="hoop.radius=0.4&duration=1.5&start.speed=",Di=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${oo}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],Ni=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],Fi=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],Bi=["1.0","1.3","1.6","1.9","2.2","2.3"],ji=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function io(i,e){
let t=d=>{c.close(),i(d)},s=(d,u="Show")=>h("button",{type:"button",class:"link",onclick:()=>t(d)},u),o=ji(),a=o&&[["teach/index.html","Teaching with the hoop"],
["teach/worksheet.html","Worksheet"],["teach/solutions.html","Solutions"],["teach/exercises.html","Exercises"]],n=h("table",{},h("caption",{},"A lesson of 45 mi\
nutes"),h("thead",{},h("tr",{},["Minute","What happens","Motion"].map(d=>h("th",{scope:"col"},d)))),h("tbody",{},Di.map(([d,u,p])=>h("tr",{},h("th",{scope:"row"},
d),h("td",{},u),h("td",{},p===null?"":s(p)))))),r=h("table",{},h("caption",{},"What students often think"),h("thead",{},h("tr",{},["Idea","What is right"].map(d=>h(
"th",{scope:"col"},d)))),h("tbody",{},Ni.map(([d,u])=>h("tr",{},h("td",{},d),h("td",{},u))))),l=h("section",{class:"sheet"},h("h3",{},"Worksheet: the hoop that \
hops"),h("p",{},"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at th\
e top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s²."),h("ol",{},Fi.map(d=>h("li",{},d,h("div",{class:"answer-line"})))),h("table",{class:"sheet-\
table"},h("thead",{},h("tr",{},["v₀ [m/s]","phases","does it hop?","at which angle?"].map(d=>h("th",{scope:"col"},d)))),h("tbody",{},Bi.map(d=>h("tr",{},h("th",
{scope:"row"},s(`${oo}${Number(d)}`,d)),h("td",{}),h("td",{}),h("td",{})))))),c=h("dialog",{class:"teach","aria-label":"For teachers"},h("header",{},h("h2",{},"\
For teachers"),h("button",{type:"button",onclick:()=>print()},"Print"),h("button",{type:"button",class:"close",onclick:()=>c.close()},"Close")),h("p",{},"The vi\
sit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",h("button",{type:"button",class:"link",onclick:()=>{c.close(),
e()}},"Start the visit")),a&&h("p",{},a.map(([d,u])=>h("a",{class:"teach-page",href:new URL(d,new URL(o,document.baseURI)).href},u))),n,r,l);return c}var Jt="RSKHM",_i=new Set(["x","angle","height"]),Hi={x:"vx",angle:"omega",height:"vy"},ae=class{constructor(e){let{header:t}=e;this.scenario=t.scenario,this.query=
t.query,this.duration=t.duration,this.status=t.status,this.sequence=t.sequence,this.events=t.events,this.values=t.values,this.automatic=t.automatic,this.said=t.
summary,this.story=t.story,this.shortened=t.shortened,this.columns=e.arrays,this.t=e.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radius"],this.
mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.gravity??
9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map}get summary(){return Ls(this.said)}findPhases(){let{mode:e}=this.columns,t=[];
for(let s=0;s<this.length;s++){let o=t.at(-1);o&&o.mode===Jt[e[s]]?o.to=this.t[s]:t.push({mode:Jt[e[s]],from:this.t[s],to:this.t[s]})}for(let s=0;s+1<t.length;s++)
t[s].to=t[s+1].from;return t.filter(s=>s.to>s.from||t.length===1)}findExtent(){let{x:e,height:t,vx:s,vy:o,omega:a}=this.columns,n={left:1/0,right:-1/0,top:0,speed:0},
r=[];for(let l=0;l<this.length;l++){Number.isFinite(e[l])&&(n.left=Math.min(n.left,e[l]),n.right=Math.max(n.right,e[l])),t[l]>n.top&&(n.top=t[l]);let c=Math.hypot(
s[l],o[l])+this.radius*Math.abs(a[l]);Number.isFinite(c)&&r.push(c)}return r.sort((l,c)=>l-c),n.speed=r[Math.floor(.95*(r.length-1))]||1,n}index(e){let t=0,s=this.
length;for(;s-t>1;){let o=t+s>>1;this.t[o]<=e?t=o:s=o}return t}at(e){let t=y(e,0,this.duration),s=this.index(t),o=Math.min(s+1,this.length-1),a=this.t[o]-this.t[s],
n=a>0?(t-this.t[s])/a:0,r={t,mode:Jt[this.columns.mode[s]]};for(let[l,c]of Object.entries(this.columns)){if(l==="t"||l==="mode")continue;let d=c[s],u=c[o];if(n===
0||!Number.isFinite(u))r[l]=d;else if(_i.has(l)){let p=this.columns[Hi[l]];r[l]=Oi(d,u,p[s]*a,p[o]*a,n)}else r[l]=d+(u-d)*n}return r}derived(e,t){let s=this.cache.
get(e)??t(this.columns);return this.cache.set(e,s),s}};function Oi(i,e,t,s,o){if(!Number.isFinite(t)||!Number.isFinite(s))return i+(e-i)*o;let a=1-o;return a*a*
(1+2*o)*i+o*o*(3-2*o)*e+o*a*(a*t-o*s)}var Qt=i=>i-360*Math.floor(i/360);function $i(i,e){let t=Math.abs(Qt(i-e+180)-180);return Math.round(100*y(1-(t-1)/89,0,1))}function Ui(i,e){let t=Math.max(...e)-
Math.min(...e,0),s=e.reduce((o,a,n)=>o+Math.abs(a-i[n]),0)/e.length;return Math.round(100*y(1-2*s/(t||1),0,1))}var Ki=0;function De(i,e,t=!1){let s=`hh-guess-${++Ki}`,
o="",a=i.map(([n,r])=>{let l=h("input",{type:"radio",name:s,value:n,onchange:()=>{o=n,e()}});return{key:n,radio:l,row:h("label",{class:"guess-choice"},l,h("span",
{},r))}});return{element:h("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},a.map(({row:n})=>n)),made:()=>o!=="",judge:n=>{for(let{key:r,radio:l,
row:c}of a){l.disabled=!0;let d=t||r===n;d&&c.append(h("b",{class:"guess-right"},"✓")),c.classList.toggle("right",d)}return t||o===n?100:0}}}var te=168,qe=58,
Zt=(i,e=qe)=>{let t=i*Math.PI/180;return[te/2+e*Math.sin(t),te/2-e*Math.cos(t)]};function es(i,e){let t=0,s=!1,o=null,a=h("canvas",{class:"dial-canvas"}),n=h("d\
iv",{class:"guess dial",role:"slider",tabindex:"0","aria-label":i,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},a),r=()=>{let{context:d}=L(a),u=getComputedStyle(
n),p=u.getPropertyValue("--ink").trim(),m=u.getPropertyValue("--soft").trim(),g=u.getPropertyValue("--accent").trim();d.clearRect(0,0,te,te),d.strokeStyle=m,d.fillStyle=
m,d.lineWidth=1.5,d.beginPath(),d.moveTo(8,te/2+qe),d.lineTo(te-8,te/2+qe),d.stroke(),d.lineWidth=4,d.beginPath(),d.arc(te/2,te/2,qe,0,2*Math.PI),d.stroke(),d.font=
"11px system-ui, sans-serif",d.textAlign="center";for(let w of[0,90,180,270]){let[f,v]=Zt(w,qe-17);d.fillText(`${w}°`,f,v+4)}let b=(w,f,v)=>{d.fillStyle=f,d.beginPath(),
d.arc(...Zt(w),v,0,2*Math.PI),d.fill()};o!==null&&(d.strokeStyle=p,d.lineWidth=2,d.beginPath(),d.arc(...Zt(o),12,0,2*Math.PI),d.stroke(),b(o,p,7)),b(t,s?g:m,9)},
l=d=>{o===null&&(t=Qt(d),s=!0,n.setAttribute("aria-valuenow",String(Math.round(t))),n.setAttribute("aria-valuetext",`${Math.round(t)}°`),r(),e())},c=d=>{let u=a.
getBoundingClientRect(),[p,m]=[d.clientX-u.left-u.width/2,d.clientY-u.top-u.height/2];l(Math.atan2(p,-m)*180/Math.PI)};return n.addEventListener("pointerdown",d=>{
d.preventDefault(),n.focus({preventScroll:!0}),c(d),C(n,d,c)}),n.addEventListener("keydown",d=>{let u={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,
PageUp:45}[d.key];u!==void 0&&(d.preventDefault(),d.stopPropagation(),l(t+(d.shiftKey?u/5:u)))}),requestAnimationFrame(r),{element:n,redraw:r,made:()=>s,judge:d=>(o=
Qt(d),r(),$i(t,o))}}var We=9,[V,nt,le,Xt]=[34,12,12,26];function ao({label:i,unit:e,most:t},s){let o=Array(We).fill(t/4),a=!1,n=null,r=h("canvas",{class:"sketch\
-canvas"}),l=o.map((f,v)=>h("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":`${i} with the load at ${45*v}°`,"aria-orientation":"vertical",
"aria-valuemin":"0","aria-valuemax":String(t),onkeydown:S=>{let M={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[S.key];M&&(S.preventDefault(),S.stopPropagation(),
g(v,o[v]+M*t/(S.shiftKey?100:20)))}})),c=h("div",{class:"guess sketch",role:"group","aria-label":"Draw the curve: pull the points up and down"},r,l),d=()=>r.getBoundingClientRect(),
u=f=>V+f/(We-1)*(d().width-V-nt),p=f=>le+(1-f/t)*(d().height-le-Xt),m=()=>{let{context:f,width:v,height:S}=L(r),M=getComputedStyle(c),A=z=>M.getPropertyValue(z).
trim();f.clearRect(0,0,v,S),f.strokeStyle=A("--line"),f.fillStyle=A("--soft"),f.font="11px system-ui, sans-serif";for(let z=0;z<We;z+=2)f.textAlign="center",f.fillText(
`${45*z}°`,u(z),S-8),f.strokeRect(u(z),le,0,S-le-Xt);for(let z of[0,t/2,t])f.textAlign="right",f.fillText(String(z),V-6,p(z)+4),f.strokeRect(V,p(z),v-V-nt,0);f.
textAlign="left",f.fillText(e,V+4,le+10);let E=(z,J,Ko)=>{f.strokeStyle=J,f.lineWidth=2.5,f.setLineDash(Ko),f.beginPath(),z.forEach((fs,gs)=>{let ws=V+gs/(z.length-
1)*(v-V-nt);gs?f.lineTo(ws,p(y(fs,0,t))):f.moveTo(ws,p(y(fs,0,t)))}),f.stroke(),f.setLineDash([])};E(o,A("--accent"),[6,4]),n&&E(n,A("--ink"),[]),l.forEach((z,J)=>{
z.style.transform=`translate(${u(J)}px, ${p(o[J])}px)`})},g=(f,v)=>{n||(o[f]=y(v,0,t),a=!0,l[f].setAttribute("aria-valuenow",o[f].toPrecision(3)),l[f].setAttribute(
"aria-valuetext",`${o[f].toPrecision(2)} ${e}`),m(),s())},b=null,w=f=>{let v=d(),S=y((f.clientX-v.left-V)/(v.width-V-nt),0,1),M=Math.round(S*(We-1)),A=t*(1-(f.clientY-
v.top-le)/(v.height-le-Xt)),E=b??M,z=o[E];for(let J=Math.min(E,M);J<=Math.max(E,M);J++)g(J,E===M?A:z+(A-z)*(J-E)/(M-E));b=M};c.addEventListener("pointerdown",f=>{
f.preventDefault(),b=null,w(f),C(c,f,w)});for(let[f,v]of l.entries())v.setAttribute("aria-valuenow",o[f].toPrecision(3));return requestAnimationFrame(m),{element:c,
redraw:m,made:()=>a,judge:f=>{n=f,m();let v=(f.length-1)/(We-1);return Ui(o,o.map((S,M)=>f[Math.round(M*v)]))}}}var lt=2*Math.PI,F=(i,e)=>i.events.find(t=>t.kind===e),rt=i=>P(i-lt*Math.floor(i/lt));function Gi(i,e,t=72){let{angle:s}=i.columns,o=i.columns[e],a=[],n=0;for(let r=0;r<=
t;r++){let l=i.columns.angle[0]+lt*r/t;for(;n+1<i.length&&s[n+1]<l;)n+=1;let c=Math.min(n+1,i.length-1),d=s[c]>s[n]?Math.min((l-s[n])/(s[c]-s[n]),1):0;a.push(o[n]+
d*(o[c]-o[n]))}return a}var Vi=(i,e)=>i.t[i.columns.angle.findIndex(t=>t>=e)]??i.duration,Yi={R:"roll",S:"spin",K:"skid",H:"bounce"},he=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:i=>De(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],i),until:([i])=>{
let[e,t]=[F(i,"skim"),F(i,"impact")];return e?e.t+.7*((t?.t??i.duration)-e.t):i.duration},answer:([i])=>{let e=F(i,"skim")??F(i,"takeoff");return{truth:e?.kind===
"skim"?"skim":e?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:rt(e?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:i=>ao({label:"Speed of the centre",unit:"m/s",most:10},
i),until:([i])=>Vi(i,lt),answer:([i])=>{let e=Gi(i,"vx");return{truth:e,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:x(Math.max(
...e),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:i=>es("Angle of the load where it begins to slip",i),until:([i])=>(F(i,"slip_start")?.t??0)+.02,answer:([i])=>{let e=F(i,"slip_start"),t=i.at(e.t).normal_force/
(i.mass*i.gravity);return{truth:e.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:rt(e.
angle),share:`${x(100*t,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:i=>es("Angle of the load\
 where it takes off",i),until:([i])=>(F(i,"takeoff")?.t??0)+.12,answer:([i])=>{let e=F(i,"takeoff"),t=i.at(e.t-1e-6);return{truth:e.angle*180/Math.PI,text:"It t\
akes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:rt(e.angle),slip:x(Math.abs(t.slip),3)}}},why:"A rolling hoop would be braked by the plan\
e while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the \
top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does it d\
o just after it has landed?",queries:[""],guess:i=>De([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim turns \
too fast."],["bounce","It bounces."]],i),until:([i])=>(F(i,"impact")?.t??i.duration)+.15,answer:([i])=>{let[e,t]=[F(i,"takeoff"),F(i,"impact")],s=i.events.find(
o=>o.kind==="apex");return{truth:Yi[i.at((t?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
values:{time:x((t?.t??0)-(e?.t??0),3),height:x(100*(s?.height??0),3),angle:rt(t?.angle??0)}}},why:"An impact takes no time, but its friction is as strong as its\
 push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",title:"\
More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highest?",queries:[
"plane.mu=0.05","plane.mu=0.2",""],guess:i=>De([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],i),until:i=>.3+Math.max(0,...i.map(e=>F(e,"impact")?.t??0)),
answer:i=>{let e=i.map(a=>Math.max(0,...a.events.map(({kind:n,height:r})=>n==="apex"?r:0))),[t,s,o]=e.map(a=>x(100*a,3));return{truth:String(e.indexOf(Math.max(
...e))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:t,middle:s,high:o}}},why:"On ice nothing drives the ro\
tation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the\
 way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies w\
ith dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plan\
e.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:i=>De([["flight","It flies off."],["impact","An impact stops the sli\
de at once."],["both","Both agree with the laws."]],i),until:i=>Math.min(.8,...i.map(e=>e.duration)),answer:i=>({truth:i.every(e=>F(e,"painleve_indeterminate"))?
"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws have two an\
swers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"Your tur\
n",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from\
 the motion itself.",question:"",queries:[""]}];var no="hophoop-visit",ht=class{step=null;guess=null;films=[];points=new Map;play;next;stop=null;loop=null;asked=0;constructor(e,t){this.lab=e,this.onchallenges=
t,this.body=h("div",{class:"visit-body"}),this.said=h("div",{class:"visit-answer",role:"status"}),this.element=h("section",{class:"visit card","aria-label":"Gui\
ded visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){U(no)||(this.element.hidden=!1,T(this.said,""),this.
body.replaceChildren(h("div",{class:"buttons offer"},h("p",{},h("b",{},"New here?")," ","Eight short questions: guess, then play."),h("button",{type:"button",class:"\
main",onclick:()=>this.start()},"Start the visit"),h("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){this.points.clear(),this.go(0)}leave(){
K(no,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.root.classList.remove("visiting"),this.veil(),this.
lab.show()}async go(e){let t=he[e],s=++this.asked,{lab:o}=this;o.clock.play(!1),o.clock.time=0,this.step=t,this.stop=null,this.guess=null,this.unwind(),T(this.said,
""),this.element.hidden=!1,o.root.classList.toggle("visiting",e<he.length-1);try{let a=await Promise.all(t.queries.map(n=>o.backend.call("film",{query:n})));if(s!==
this.asked)return;this.films=a.map(n=>new ae(n)),o.motions.active=0,o.motions.set(a.slice(0,2)),this.guess=t.guess?.(()=>this.guessed())??null,this.veil(),o.changed(),
o.motions.note(),this.fill(e)}catch(a){o.notice.fail(a)}}veil(){this.lab.root.classList.toggle("guessing",this.guessing),this.guessing&&this.lab.stage.element.setAttribute(
"aria-label",k("The hoop, before it is let go."))}fill(e){let t=he[e];this.play=h("button",{type:"button",class:"main",disabled:!!this.guess,onclick:()=>this.show()},
"Play");let s=e===he.length-1,o=h("h2",{tabindex:"-1"},t.title);this.next=h("button",{type:"button",onclick:()=>this.go(e+1)},"Next"),this.body.replaceChildren(
h("header",{},h("span",{class:"visit-count"},`Step ${e+1} of ${he.length}`),h("progress",{max:String(he.length),value:String(e+1),"aria-hidden":"true"}),h("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),o,h("p",{},t.text),t.question?h("p",{class:"visit-question"},t.
question):"",this.guess?.element??"",h("div",{class:"buttons"},e>0&&h("button",{type:"button",onclick:()=>this.go(e-1)},"Back"),this.guess&&this.play,s?h("butto\
n",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,s&&h("button",{type:"button",onclick:()=>this.leave()},"Done"),this.guess&&
h("span",{class:"hint visit-wait"},"First say what you expect, then play."))),s&&this.points.size&&this.total(),o.focus({preventScroll:!0})}guessed(){this.play&&
(this.play.disabled=!1);let e=this.body.querySelector(".visit-wait");e&&(e.hidden=!0)}show(){let{lab:e,step:t}=this;!t||!this.guess||(this.play.disabled=!0,this.
stop=t.until?.(e.films())??e.clock.duration,this.loop??=e.clock.loop,e.clock.loop=!1,e.clock.seek(0),matchMedia("(prefers-reduced-motion: reduce)").matches?e.clock.
seek(this.stop):e.clock.play(!0),this.frame())}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:e}=this.lab;if(this.stop===
null||e.playing&&e.time<this.stop||!(e.time>=this.stop-1e-9||!e.playing))return;e.playing=!1;let s=this.stop;this.stop=null,this.unwind(),e.seek(s),this.judge()}judge(){
let{step:e,guess:t}=this;if(!e?.answer||!t)return;let{truth:s,text:o,values:a={}}=e.answer(this.films),n=t.judge(s);this.points.set(e.key,n),this.said.replaceChildren(
h("p",{},h("b",{},`${n} of 100 points.`)," ",Ps(o,a)),h("p",{},e.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.scrollIntoView(
{block:"nearest"})}total(){let e=[...this.points.values()].reduce((t,s)=>t+s,0);this.said.replaceChildren(h("p",{},`You have ${e} of ${100*this.points.size} poi\
nts.`))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&this.veil()}};var ct=class{words={t:k,untranslated:Ee};constructor(e){this.lab=e,this.grips=new st(e),this.sound=new it,this.present=new ot(e),this.challenges=new Qe(e),this.
visit=new ht(e,()=>this.challenges.open()),this.table=new at(e),this.teach=io(t=>this.challenges.load(t),()=>this.visit.start()),this.layOut(),this.spoken()}layOut(){
let{lab:e}=this,t=e.stage.element.parentElement,s=e.root.querySelector(".side");s?s.prepend(this.visit.element,this.challenges.element):t.before(this.visit.element,
this.challenges.element),t.after(this.table.element),e.root.append(this.teach),e.transport.element.querySelector(".switches")?.before(this.tools()),e.header.element.
querySelector(".right")?.prepend(this.menu(),this.languages()),e.hosted&&!location.search&&!location.hash&&this.visit.offer()}tools(){let{clock:e}=this.lab,t=(s,o,a)=>h(
"button",{type:"button",title:o,"aria-label":o,"aria-pressed":"false",onclick:a},W(s));return this.loop=t("loop","Repeat",()=>{e.loop=!e.loop,this.mark()}),this.
slow=t("slow","Slow motion: a tenth of the speed",()=>{e.speed=e.speed===.1?1:.1,e.changed(),this.mark()}),this.loud=t("sound","Sound of the contact",()=>{this.
sound.turn(!this.sound.on),this.mark()}),this.large=t("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),
this.mark(),h("div",{class:"buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:e}=this.lab;this.loop?.setAttribute("aria-pressed",String(
e.loop)),this.slow?.setAttribute("aria-pressed",String(e.speed===.1)),this.loud?.setAttribute("aria-pressed",String(this.sound.on)),this.large?.setAttribute("ar\
ia-pressed",String(this.present.on))}menu(){let e=(s,o)=>h("button",{type:"button",onclick:()=>{t.open=!1,o()}},s),t=h("details",{class:"learn"},h("summary",{class:"\
button"},"Learn"),h("div",{class:"menu-body"},e("Guided visit",()=>this.visit.start()),e("Challenges",()=>this.challenges.open()),e("Table of the motion",()=>this.
table.open(!0)),e("Presentation",()=>this.present.turn(!0)),e("For teachers",()=>this.teach.showModal())));return this.lab.root.addEventListener("pointerdown",s=>{
t.contains(s.target)||(t.open=!1)}),t.addEventListener("keydown",s=>{s.key!=="Escape"||!t.open||(s.stopPropagation(),t.open=!1,t.querySelector("summary")?.focus())}),
t}languages(){let e=h("select",{class:"language","aria-label":"Language",onchange:()=>{As(e.value),Ft(e.value),this.spoken(),Cs(this.lab.root),this.lab.show()}},
Object.entries(ze).map(([t,s])=>h("option",{value:t,lang:t},document.createTextNode(s))));return e.value=$e(),e}spoken(){this.lab.root.lang=$e(),this.lab.hosted&&
(document.documentElement.lang=$e())}frame(){let{lab:e}=this;this.grips.draw(),this.sound.follow(e.film(),e.clock),this.table.cursor(e.clock.time),this.visit.frame(),
this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.challenges.changed(),this.visit.changed()}close(){this.sound.close(),this.present.
close()}};var Ne=(i,e,t)=>h("button",{type:"button",title:e,"aria-label":e,onclick:t},i),dt=class{constructor(e,t,s){let o=new Map;for(let n of e)o.set(n.group,[...o.get(
n.group)??[],n]);this.fresh=!1,this.presets=h("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let n=e.find(({key:r})=>r===this.presets.
value);this.fresh=n!==void 0,n&&s.take(n)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},h("option",{value:""},"Motions to start from …"),[...o].
map(([n,r])=>h("optgroup",{label:n},r.map(({key:l,title:c})=>h("option",{value:l},c))))),this.undo=Ne(W("undo"),"Undo (z)",s.undo),this.redo=Ne(W("redo"),"Redo \
(y)",s.redo);let a=h("span",{},h("span",{class:"long"},"Compare"),h("span",{class:"short"},W("two")));this.compare=Ne(a,"Compare two hoops",s.compare),this.element=
h("header",{class:"top"},h("h1",{},h("span",{class:"logo","aria-hidden":"true"}),h("span",{},"hophoop",h("span",{class:"long"}," lab"))),this.presets,h("div",{class:"\
buttons"},this.undo,this.redo,this.compare),h("div",{class:"buttons right"},t,Ne(W("theme"),"Dark or light (d)",s.theme),Ne("?","Keys and help (?)",s.help)))}show(e,t){
this.undo.disabled=!e.past.length,this.redo.disabled=!e.future.length,this.compare.setAttribute("aria-pressed",String(t))}};var Ji=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["Esc","leave a field, a menu, a picture \
that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],Zi=[["R","roll","the rim does not slide"],["S","spin","slip: the rim tur\
ns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],["H","\
flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],Xi=[["▲ ▼","take-off, landing"],["•","highest point"],
["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy out of nothing"],["≋","bounces without numbe\
r end"],["◗ ■","skimming begins, rest"]],ts=(i,e,t=()=>!1)=>h("table",{},h("caption",{},i),e.map(([s,...o])=>h("tr",{},h("th",{scope:"row"},t(s),s),o.map(a=>h(
"td",{},a)))));function ro(i,e,t){let s=h("dialog",{class:"help","aria-label":"Keys and help"},h("h2",{},"The hoop"),h("p",{},"A ring with a load on its rim rol\
ls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide\
. Move a slider and see."),ts("Modes",Zi,o=>h("i",{class:"dot",style:`background:${e.modes[o]}`})),ts("Marks on the bar of time",Xi),ts("Keys",Ji),t,h("p",{class:"\
hint"},`hophoop ${i}`),h("button",{type:"button",class:"close",onclick:()=>s.close()},"Close"));return s}var ut=class{constructor(e){this.tabs=["A","B"].map((t,s)=>h("button",{type:"button","aria-pressed":"false",onclick:()=>e(s)},`Hoop ${t}`)),this.bar=h("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=h("p",{class:"preset-text"}),this.element=h("div",{class:"lanes"},
this.bar,this.text)}show(e,t){this.bar.hidden=e<2;for(let[s,o]of this.tabs.entries())o.setAttribute("aria-pressed",String(s===t))}};var lo="hophoop-single-keys",Qi=(i,e)=>({" ":()=>i.clock.play(),ArrowLeft:()=>e?i.transport.jump(-1):i.transport.nudge(-1),ArrowRight:()=>e?i.transport.jump(1):
i.transport.nudge(1),Home:()=>i.clock.seek(0),End:()=>i.clock.seek(i.clock.duration),h:()=>i.transport.jump(1,"takeoff"),l:()=>i.transport.jump(1,"impact"),"[":()=>i.
clock.faster(-1),"]":()=>i.clock.faster(1),t:()=>i.toggle("traces"),f:()=>i.toggle("forces"),c:()=>i.toggle("speed"),w:()=>i.toggle("whole"),3:()=>i.toggle("thr\
ee"),"+":()=>i.stage.zoom(1.25),"=":()=>i.stage.zoom(1.25),"-":()=>i.stage.zoom(.8),0:()=>i.stage.zoom(0),z:()=>i.travel(-1),y:()=>i.travel(1),d:()=>i.theme.toggle(),
p:()=>i.share.code(),"?":()=>i.help.showModal()});function ea(i,e){let t=e.key.toLowerCase();e.altKey||!(t==="z"||t==="y")||(e.preventDefault(),i.travel(t==="y"||
e.shiftKey?1:-1))}function ta(i){let e=i.share.menu;e.open&&(e.open=!1,e.querySelector("summary")?.focus())}var pt=class{constructor(e){this.on=!e||U(lo)!=="off";
let t=h("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=t.checked,e&&K(lo,this.on?"on":"off")}});this.element=h("label",{class:"check"},t,"Single\
 keys (letters, digits, signs) do what the table says")}};function sa(i,e){let t=e.target;if(i.root.querySelector("dialog[open]"))return;if(e.key==="Escape"){ta(
i);return}if(t.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(e.ctrlKey||e.metaKey){ea(i,e);return}if(e.altKey||t.matches?.("select")&&
!(e.key===" "&&i.header.fresh)||t.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(e.key)||e.key===" "&&t.matches?.("button, summary, input[type=ch\
eckbox]")||!i.singleKeys.on&&e.key!==" "&&e.key.length===1)return;let o=Qi(i,e.shiftKey)[e.key];o&&(e.preventDefault(),o())}function ho(i,e){let t=e?document:i.
root,s=o=>{sa(i,o),e||o.stopPropagation()};return t.addEventListener("keydown",s),()=>t.removeEventListener("keydown",s)}var[co,oa]=[62,92],ia=12,ce=10,aa=36,uo=Math.PI/180,Y=["x","y"],mt=class{box;constructor(e){this.known=new Map(e.map(t=>[t.path,t])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=co}info(e){return this.known.get(this.paths[e])}whole(e){return[...this.info(e).range]}home(){
for(let e of Y)this.windows[e]=this.whole(e)}choose(e,t){let s=e==="x"?"y":"x";this.paths[s]===t&&(this.paths[s]=this.paths[e]),this.paths[e]=t,this.home()}asked(e,t){
let[s,o]=this.windows[e];return{path:this.paths[e],from:s,to:o,cells:t}}bounds(e){let{range:t,allowed:s}=this.info(e),o=2*(t[1]-t[0]);return[Math.max(s[0],t[0]-
o),Math.min(s[1],t[1]+o)]}zoom(e,t){let s={x:[],y:[]};for(let o of Y){let[a,n]=this.windows[o],r=t?.[o]??.5*(a+n);s[o]=de([r-(r-a)*e,r+(n-r)*e],this.bounds(o));
let l=Math.max(Math.abs(s[o][0]),Math.abs(s[o][1]),1e-9);if(s[o][1]-s[o][0]<400*Number.EPSILON*l)return!1}return Y.every(o=>s[o].every((a,n)=>a===this.windows[o][n]))?
!1:(this.windows=s,!0)}drag(e,t,s){let o=(a,n)=>de(e[a].map(r=>r+n*(e[a][1]-e[a][0])),this.bounds(a));this.windows={x:o("x",-t/this.box.width),y:o("y",s/this.box.
height)}}restore(e){if(!Y.every(t=>this.known.has(e[t][0]))||e.x[0]===e.y[0])return!1;for(let t of Y)this.paths[t]=e[t][0];for(let t of Y)this.windows[t]=de(e[t].
slice(1).map(Number),this.bounds(t));return!0}isHome(){return Y.every(e=>this.windows[e].every((t,s)=>t===this.whole(e)[s]))}middle(){let{x:e,y:t}=this.windows;
return{x:.5*(e[0]+e[1]),y:.5*(t[0]+t[1])}}fit(e,t){this.left=this.deep("y")?oa:co,this.box={width:e-this.left-ia,height:t-ce-aa}}clip(e){e.beginPath(),e.rect(this.
left,ce,this.box.width,this.box.height),e.clip()}x(e){let[t,s]=this.windows.x;return this.left+(e-t)/(s-t)*this.box.width}y(e){let[t,s]=this.windows.y;return ce+
(1-(e-t)/(s-t))*this.box.height}place(e,t){let s=([o,a],n)=>o+y(n,0,1)*(a-o);return{x:s(this.windows.x,(e-this.left)/this.box.width),y:s(this.windows.y,1-(t-ce)/
this.box.height)}}deep(e){let[t,s]=this.windows[e];return s-t<5e-5*Math.max(Math.abs(t),Math.abs(s))}said(e){let t=s=>{let o=this.info(s),[a,n]=this.windows[s],
r=Math.max(Math.abs(a),Math.abs(n)),l=y(Math.ceil(Math.log10(r/(n-a)))+4,4,16);return`${k(o.label)} = ${I(x(o.degrees?e[s]/uo:e[s],l),o.unit)}`};return`${t("x")}\
, ${t("y")}`}draw(e,t,s){e.strokeStyle=s.soft,e.fillStyle=s.soft,e.lineWidth=1,e.strokeRect(this.left+.5,ce+.5,this.box.width-1,this.box.height-1),e.font=`11px ${s.
font}`;for(let o of Y){let a=this.info(o),n=a.degrees?1/uo:1,[r,l]=this.windows[o].map(w=>w*n),c=o==="x"?this.box.width/80:this.box.height/40,d=D(l-r,c),u=this.
deep(o),p=u?Number((.5*(r+l)).toPrecision(12)):0,m=u?O(r-p,l-p,c).map(w=>w+p):O(r,l,c);for(let w of m){let f=u?x(w-p,3):j(w,d);o==="x"?(e.textAlign="center",e.fillText(
f,this.x(w/n),ce+this.box.height+14)):(e.textAlign="right",e.textBaseline="middle",e.fillText(f,this.left-5,this.y(w/n)),e.textBaseline="alphabetic")}let g=u?` \
− ${String(p).replace("-","−")}`:"",b=`${k(a.label)}${g}${a.unit?` [${a.unit}]`:""}`;e.save(),e.textAlign="center",o==="x"?e.translate(this.left+.5*this.box.
width,t-5):(e.translate(12,ce+.5*this.box.height),e.rotate(-Math.PI/2)),e.fillText(b,0,0),e.restore()}}};function de([i,e],[t,s]){let o=Math.min(e-i,s-t);return i<
t?[t,t+o]:e>s?[s-o,s]:[i,e]}function ss(i,e,t,s,o){for(let[a,n]of[[o,4],[s,1.8]])i.strokeStyle=a,i.lineWidth=n,i.beginPath(),i.arc(e,t,7,0,2*Math.PI),i.moveTo(e-
13,t),i.lineTo(e-4,t),i.moveTo(e+4,t),i.lineTo(e+13,t),i.moveTo(e,t-13),i.lineTo(e,t-4),i.moveTo(e,t+4),i.lineTo(e,t+13),i.stroke()}var be=i=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${i&&`; ${i}`}; double-click for all`,na=.0018,po=200,
[ra,la]=[1/.6,1/1.7];function _(i,{zoom:e,home:t,chosen:s=()=>i,keys:o=!1}){return i.addEventListener("wheel",a=>{(a.ctrlKey||a.metaKey||Ue(s()))&&(a.preventDefault(),
e(Math.exp(-Math.min(Math.max(a.deltaY,-po),po)*na),a))},{passive:!1}),i.addEventListener("dblclick",t),o&&i.addEventListener("keydown",a=>{if(a.key==="+"||a.key===
"=")e(ra);else if(a.key==="-")e(la);else if(a.key==="0")t();else if(a.key==="Escape")i.blur();else return;a.preventDefault(),a.stopPropagation()}),Js(i,e)}var mo={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},fo=48;function go(i){let{body:e}=i,t=!1,s=_(e,{zoom:(o,a)=>i.axes.box&&i.zoom(1/o,a?os(
i,a):i.pointed??void 0),home:()=>i.home(),keys:!0});e.addEventListener("pointerdown",o=>ca(i,o,s,a=>t=a)),e.addEventListener("pointermove",o=>{i.axes.box&&!t&&o.
pointerType!=="touch"&&ha(i,o)}),e.addEventListener("pointerleave",()=>i.tip.hidden=!0),e.addEventListener("keydown",o=>da(i,o))}function os(i,e){let t=i.body.getBoundingClientRect();
return i.axes.place(e.clientX-t.left,e.clientY-t.top)}function ha(i,e){i.tip.textContent=i.said(os(i,e)),i.tip.hidden=!1;let t=i.body.getBoundingClientRect();i.
tip.style.left=`${y(e.clientX-t.left,150,Math.max(t.width-150,150))}px`,i.tip.style.bottom=`${t.bottom-e.clientY+16}px`}function ca(i,e,t,s){e.preventDefault(),
i.body.focus({preventScroll:!0});let o=[e.clientX,e.clientY],a={x:[...i.axes.windows.x],y:[...i.axes.windows.y]};i.pointed=os(i,e);let n=!1,r=t(),l=c=>{if(r||=t(),
r)return;let[d,u]=[c.clientX-o[0],c.clientY-o[1]];Math.hypot(d,u)<5&&!n||(n=!0,s(!0),i.tip.hidden=!0,i.axes.drag(a,d,u),i.redraw(),i.soon())};C(i.body,e,l,(c,d)=>{
d&&!n&&!r&&i.pointed&&i.take(i.pointed),s(!1)})}function da(i,e){let t=i.pointed??i.here()??i.axes.middle();if(i.pointed=t,mo[e.key]){let[s,o]=mo[e.key],{x:a,y:n}=i.
axes.windows;i.pointed={x:y(t.x+s*(a[1]-a[0])/fo,a[0],a[1]),y:y(t.y+o*(n[1]-n[0])/fo,n[0],n[1])},i.state.textContent=i.said(i.pointed),i.say(i.said(i.pointed))}else if(e.
key==="Enter")i.take(t);else return;e.preventDefault(),e.stopPropagation(),i.redraw()}var ua=["start.height","start.vx","start.vy","start.omega"];function wo(i,e){let t="speed"in i.start;return!t&&e.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":t&&e.some(s=>ua.includes(s))?"of starts in any state, though this motion starts rolling":""}var pa=Math.PI/180,ma=12,fa=["hop_height","flight_time","energy_lost","greatest_utilization"];function bo(i){return i.unit==="rad"?[1/pa,"°"]:[1,i.unit==="1"?"":
i.unit]}function ga({classes:i,what:e},t){let[s,o]=[1/0,-1/0];if(i)return[s,o];for(let a of t)a<s&&(s=a),a>o&&(o=a);return[fa.includes(e)?Math.min(s,0):s,o]}function yo(i){
let{values:e}=i.arrays,t=i.header,{x:s,y:o,classes:a}=t,n=new ImageData(s.cells,o.cells),[r,l]=ga(t,e),c=a?.map(({color:u})=>Z(u));for(let u=0;u<o.cells;u++)for(let p=0;p<
s.cells;p++){let m=e[u*s.cells+p],g=4*((o.cells-1-u)*s.cells+p);if(!Number.isFinite(m))continue;let b=c&&(p+1<s.cells&&e[u*s.cells+p+1]!==m||u+1<o.cells&&e[(u+1)*
s.cells+p]!==m),w=c?c[m].map(f=>b?.72*f:f):me[y(Math.round(255*(m-r)/(l-r||1)),0,255)];n.data.set([...w,255],g)}let d=h("canvas",{width:s.cells,height:o.cells});
return ee(d).putImageData(n,0,0),{picture:d,header:t,values:e,x:[s.from,s.to],y:[o.from,o.to],low:r,high:l}}function vo(i,e){let t=(o,a)=>o[0]>=a[0]-1e-300&&o[1]<=
a[1]+1e-300;return[...i.filter(o=>!(t(o.x,e.x)&&t(o.y,e.y))),e].slice(-ma)}function ko({header:i,low:e,high:t,values:s}){let{classes:o}=i;if(!o){let r=h("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=ee(r);for(let u=0;u<120;u++)l.fillStyle=`rgb(${me[Math.floor(255*u/119)].join(",")})`,l.fillRect(u,0,1,
10);let[c,d]=bo(i);return[h("span",{},i.label,": ",t>=e?x(e*c,3):"none"," "),r,h("span",{},t>=e?I(x(t*c,3),d):""),s.some(u=>!Number.isFinite(u))?h("span",{},h("\
i",{class:"blank"}),"none"):""]}let a=new Map;for(let r of s)a.set(r,(a.get(r)??0)+1);let n=[...a].filter(([r])=>r>=0).sort((r,l)=>l[1]-r[1]);return[...n.slice(
0,10).map(([r])=>{let{color:l,text:c}=o[r];return h("span",{},h("i",{style:`background:${l}`,"aria-hidden":"true"}),c)}),n.length>10?h("span",{},`and ${n.length-
10} more`):""]}function xo(i,e){for(let{header:t,values:s}of[...i].reverse()){let{x:o,y:a,classes:n}=t,r=Math.floor((e.x-o.from)/(o.to-o.from)*o.cells),l=Math.floor(
(e.y-a.from)/(a.to-a.from)*a.cells);if(r<0||l<0||r>=o.cells||l>=a.cells)continue;let c=s[l*o.cells+r];if(n)return k(n[c]?.text??"not allowed");let[d,u]=bo(t);return Number.
isFinite(c)?I(x(c*d,4),u):k("none")}return"…"}var To=[[24,16],[72,48],[216,144]],ft=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(e,t,{take:s,say:o,changed:a}){this.backend=
e,this.onmotion=s,this.say=o,this.changed=a;let n=t.controls.map_axes;this.axes=new mt(n),this.what="sequence",this.layers=[],this.canvas=h("canvas",{class:"plo\
t-canvas"}),this.tip=h("div",{class:"tip",hidden:!0}),this.body=h("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow ke\
ys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=h("div",{class:"map-keys"}),this.state=h("span",{class:"hint"});
let r=l=>{let c=h("select",{"data-axis":l,onchange:()=>this.setAxis(l,c.value)},n.map(({path:d,label:u})=>h("option",{value:d},u)));return c};this.selects={x:r(
"x"),y:r("y")},this.quantity=h("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},t.map_quantities.map(([l,
c])=>h("option",{value:l},c))),this.element=h("section",{class:"map","aria-label":"Map of motions"},h("div",{class:"map-head"},h("h2",{},"Map"),h("label",{},"of",
this.quantity),h("label",{},"Across",this.selects.x),h("label",{},"Up",this.selects.y),h("span",{class:"buttons"},h("button",{type:"button","aria-label":"Zoom i\
nto the map",onclick:()=>this.zoom(.5)},"+"),h("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),h("button",{type:"but\
ton",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,h("p",{class:"hint"},`Click to take that motion into the player; ${be("drag to move")}\
.`)),go(this),this.soon=G(()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.
refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let e of Y)this.selects[e].value=
this.axes.paths[e]}setAxis(e,t){this.axes.choose(e,t),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(e){let t=structuredClone(e);
for(let s of Object.values(this.axes.paths)){let[o,a]=s.split(".");t[o]&&delete t[o][a]}return JSON.stringify(t)}mark(e,t){this.film=e,this.look=t;let s=this.key_of(
e.scenario);s!==this.key_now&&(this.key_now=s,this.soon()),this.redraw()}shown(){let{paths:e,windows:t}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&
e.x==="start.speed"&&e.y==="plane.mu")return;let s=o=>[e[o],...t[o]];return{what:this.what,x:s("x"),y:s("y")}}restore(e){![...this.quantity.options].some(({value:t})=>t===
e.what)||!this.axes.restore(e)||(this.quantity.value=this.what=e.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked,t=this.film.scenario,s=t.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let o=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;o!==this.kind&&(this.layers=[]),this.
kind=o,this.redraw();try{for(let[a,n]of To){T(this.state,`computing ${a*n} motions …`);let r={x:this.axes.asked("x",a),y:this.axes.asked("y",n)},l={scenario:t,
changes:s,...r,what:this.what},c=await Fs(()=>this.backend.call("map",l,e),m=>{T(this.state,m)},e),d=yo(c);this.layers=vo(this.layers,d),this.keys.replaceChildren(
...ko(d));let u=wo(t,Object.values(this.axes.paths)),p=k(s.length?"{count} motions, with rigid contact":"{count} motions",{count:a*n});T(this.state,u?`${p}; ${k(
u)}`:p),this.redraw()}this.level=To.length}catch(a){let{name:n,message:r}=a;if(n==="AbortError")return;T(this.state,r)}this.computing=!1}redraw(){if(!this.film)
return;let{look:e}=this,{context:t,width:s,height:o}=L(this.canvas);this.axes.fit(s,o),t.clearRect(0,0,s,o),t.save(),this.axes.clip(t),t.imageSmoothingEnabled=!1;
let{axes:a}=this;for(let r of this.layers){let[l,c]=r.x.map(p=>a.x(p)),[d,u]=r.y.map(p=>a.y(p));t.drawImage(r.picture,l,u,c-l,d-u)}let n=this.here();n&&ss(t,a.x(
n.x),a.y(n.y),e.ink,e.paper),this.pointed&&Ue(this.body)&&ss(t,a.x(this.pointed.x),a.y(this.pointed.y),"#D55E00",e.paper),t.restore(),a.draw(t,o,e)}here(){let e=s=>{
let[o,a]=s.split(".");return this.film.values[s]??this.film.scenario[o]?.[a]},t={x:e(this.axes.paths.x),y:e(this.axes.paths.y)};return typeof t.x=="number"&&typeof t.
y=="number"?t:null}said(e){return`${this.axes.said(e)}: ${xo(this.layers,e)}`}take(e){this.onmotion([[this.axes.paths.x,e.x],[this.axes.paths.y,e.y]])}zoom(e,t){
this.tip.hidden=!0,this.axes.zoom(e,t)&&(this.redraw(),this.soon())}};var gt=class{constructor(){this.past=[],this.future=[],this.now=null,this.what="",this.when=-1/0}note(e,t="",s=performance.now()){let o=this.now;if(this.now=e,o===
null||is(o,e))return"same";let a=t!==""&&t===this.what&&s-this.when<1e3&&this.past.length>0;return this.what=t,this.when=s,this.future=[],a?"again":(this.past.push(
o),this.past.length>500&&this.past.shift(),"step")}next(e){return(e<0?this.past:this.future).at(-1)??null}step(e){let[t,s]=e<0?[this.past,this.future]:[this.future,
this.past],o=t.pop();!o||!this.now||(s.push(this.now),this.now=o,this.what="")}arrive(e){if(!(this.now&&is(this.now,e))){for(let t of[-1,1]){let s=t<0?this.past:
this.future,o=s.length-s.findLastIndex(a=>is(a,e));if(!(o>s.length)){for(let a=0;a<o;a++)this.step(t);return}}Object.assign(this,{past:[],future:[],now:e,what:""})}}},
is=(i,e)=>JSON.stringify(i)===JSON.stringify(e);var wt=class{constructor(e,t){this.backend=e,this.listener=t,this.history=new gt,this.lanes=[],this.active=0,this.going=Promise.resolve()}film(e=this.active){return this.
lanes[e].film}films(){return this.lanes.map(e=>e.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([e])=>e))}name(){return this.lanes.length>
1?"AB"[this.active]:""}set(e){this.lanes=e.map(t=>({film:new ae(t)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(e){this.set(await Promise.
all(e.map(t=>this.backend.call("film",{query:t}))))}change(e,t){let s=this.lanes[this.active];s.since??=performance.now(),s.pending=[...(s.pending??[]).filter(([
o])=>!e.some(([a])=>a===o)),...e],s.commit||=t,s.what=e.map(([o])=>o).join(),this.pump(s)}async pump(e){if(e.busy||!this.lanes.includes(e))return;if(!e.pending){
e.commit&&this.settle(e);return}let t=e.pending,{since:s}=e;e.pending=null,e.since=null,e.busy=!0;try{e.film=new ae(await this.backend.call("film",{scenario:e.film.
scenario,changes:t})),this.lanes.includes(e)&&this.listener.shown(s)}catch(o){this.lanes.includes(e)&&this.listener.failed(o,t)}finally{e.busy=!1}this.pump(e)}settle(e){
e.commit=!1,this.note(e.what),this.listener.settled()}queries(){return this.films().map(e=>e.query)}note(e){this.listener.noted(this.history.note(this.queries(),
e))}replace(e){this.lanes[this.active]={film:new ae(e)},this.listener.shown(),this.note()}travel(e){return this.inTurn(async()=>{let t=this.history.next(e);t&&(await this.
load(t),this.history.step(e),await this.listener.travelled(e),this.listener.shown(),this.listener.noted("travelled"))})}arrive(e){return this.inTurn(async()=>{await this.
load(e),this.history.arrive(e),this.listener.shown(),this.listener.noted("travelled")})}inTurn(e){return this.going=this.going.then(e).then(()=>!0,t=>(this.listener.
failed(t),!1)),this.going}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=
0),this.listener.shown(),this.note()}choose(e){this.active=e,this.listener.shown(),this.listener.noted("same")}link(e=""){let s=[this.lanes.length>1?`with=${encodeURIComponent(
this.film(1).query)}`:"",e].filter(Boolean).join("&");return this.backend.link(this.film(0).query,s&&`#${s}`)}};var wa=6e3,bt=class{constructor(){this.message=h("p",{class:"message",role:"alert",hidden:!0}),this.toast=h("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(e){T(this.message,e.message),this.message.hidden=!1,this.seen()||this.say(e.message,this.message.isConnected)}seen(){let{top:e,bottom:t,height:s}=this.
message.getBoundingClientRect();return this.message.isConnected&&s>0&&e>=0&&t<=innerHeight}clear(){this.message.hidden=!0}say(e,t=!1){this.toast.setAttribute("r\
ole",t?"presentation":"status"),T(this.toast,e),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},wa)}};var H=52,as=10,B=8,ba=30,ya={solid:[],dash:[6,4],dot:[2,3]},ye=class{films;active;look;box;range;heights;picked;named;values;constructor({key:e,title:t,unit:s,curves:o,
limits:a,symmetric:n=!1},r){this.key=e,this.title=t,this.unit=s,this.curves=o,this.limits=a,this.symmetric=n,this.shared=r,this.canvas=h("canvas",{class:"plot-c\
anvas"}),this.over=h("canvas",{class:"plot-canvas plot-over"}),this.keys=h("div",{class:"plot-keys"}),this.body=h("div",{class:"plot-body",tabindex:"0",role:"im\
g","aria-label":t},this.canvas,this.over),this.element=h("section",{class:"plot","data-plot":e},h("header",{},h("h3",{},t),this.keys),this.body),this.body.addEventListener(
"pointerdown",l=>this.press(l)),this.pinched=_(this.body,{zoom:(l,c)=>this.films&&this.zoomAbout(c?this.valueAt(c):this.middle(),1/l),home:()=>this.zoomTo(null),
keys:!0}),this.onseek=()=>{}}abscissa(e){return q[this.shared.axis].values(e)}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(s=>s.
duration),1e-9)];let[e,t]=[1/0,-1/0];for(let s of this.films)for(let o of this.abscissa(s))o<e&&(e=o),o>t&&(t=o);return t>e?[e,t]:[e-1,t+1]}draw(e,t,s,o){this.films=
e,this.active=t,this.look=s;let{context:a,width:n,height:r}=L(this.canvas);this.box={width:n-H-as,height:r-B-ba},a.clearRect(0,0,n,r),this.range=this.shared.range??
this.fullRange();let l=e.flatMap((c,d)=>this.shades(c).map(u=>({...u,film:c,lane:d})));this.heights=this.limits??this.findHeights(l),this.shared.axis==="time"&&
this.bands(a,e[t],o),this.grid(a,s,n,r),a.save(),a.beginPath(),a.rect(H,B,this.box.width,this.box.height),a.clip();for(let c of l)this.curve(a,c,e.length>1);a.restore(),
this.legend(this.shades(e[t]),s.dark),this.describe(l)}shades(e){return this.curves(e).map(t=>({...t,color:t.color&&_e(t.color,this.look.dark)}))}x(e){return H+
(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return B+(1-(e-this.heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(e){
let t=[];for(let{film:d,values:u}of e){let p=this.abscissa(d);for(let m=0;m<u.length;m++)p[m]>=this.range[0]&&p[m]<=this.range[1]&&Number.isFinite(u[m])&&t.push(
u[m])}if(!t.length)return[0,1];let s=Float64Array.from(t).sort(),[o,a]=[s[0],s[s.length-1]],[n,r]=[s[Math.floor(.02*s.length)],s[Math.ceil(.98*s.length)-1]],l=Math.
max(r-n,1e-12);a>r+4*l&&(a=r+.6*l),o<n-4*l&&(o=n-.6*l),o=Math.min(o,0),a=Math.max(a,0),this.symmetric&&([o,a]=[-Math.max(-o,a),Math.max(-o,a)]);let c=.06*(a-o)||
1;return[o<0?o-c:o,a+c]}bands(e,t,s){for(let o of t.phases){let a=y(this.x(o.from),H,H+this.box.width),n=y(this.x(o.to),H,H+this.box.width);n<=a||(e.fillStyle=Te(
s.modes[o.mode],.14),e.fillRect(a,B,n-a,this.box.height))}}grid(e,t,s,o){e.font=`11px ${t.font}`,e.strokeStyle=t.line,e.fillStyle=t.soft,e.lineWidth=1;let a=Math.
max(this.box.height/28,4);for(;O(this.heights[0],this.heights[1],a).length<3&&a<12;)a+=1;let n=D(this.heights[1]-this.heights[0],a);e.textAlign="right",e.textBaseline=
"middle";for(let p of O(this.heights[0],this.heights[1],a)){let m=Math.round(this.y(p))+.5;e.globalAlpha=Math.abs(p)<1e-9*n?1:.55,e.beginPath(),e.moveTo(H,m),e.
lineTo(s-as,m),e.stroke(),e.globalAlpha=1,e.fillText(j(p,n),H-6,m)}let r=this.box.width/70,l=D(this.range[1]-this.range[0],r);e.textAlign="center",e.textBaseline=
"alphabetic";let{name:c,unit:d}=q[this.shared.axis],u=d?`${k(c)} [${d}]`:k(c);for(let p of O(this.range[0],this.range[1],r)){let m=this.x(p);e.beginPath(),e.moveTo(
m,B+this.box.height),e.lineTo(m,B+this.box.height+4),e.stroke(),e.fillText(j(p,l),m,B+this.box.height+15)}e.textAlign="right",e.fillText(u,s-as,o-3),e.save(),e.
translate(11,B+.5*this.box.height),e.rotate(-Math.PI/2),e.textAlign="center",e.fillText(k(this.unit),0,0),e.restore()}curve(e,{film:t,lane:s,values:o,color:a,dash:n},r){
let l=this.abscissa(t);e.strokeStyle=a??this.look.ink,e.lineWidth=r&&s===1?1.2:1.8,e.setLineDash(r&&s===1?[3,3]:ya[n??"solid"]),e.globalAlpha=r&&s===1?.85:1,e.beginPath();
let c=!1;for(let d=0;d<o.length;d++){if(!Number.isFinite(o[d])||!Number.isFinite(l[d])){c=!1;continue}let u=this.x(l[d]),p=y(this.y(o[d]),-1e4,1e4);c?e.lineTo(u,
p):e.moveTo(u,p),c=!0}e.stroke(),e.setLineDash([]),e.globalAlpha=1}legend(e,t){let s=e.map(o=>o.name).join()+t;this.named!==s&&(this.named=s,this.values=e.map(()=>h(
"span",{class:"value"})),this.keys.replaceChildren(...e.map((o,a)=>h("span",{class:"plot-key"},ns(o.color,o.dash),o.name," ",this.values[a]))))}describe(e){let t=e.
slice(0,6).map(({name:o,values:a,lane:n})=>{let[r,l]=[1/0,-1/0];for(let u of a)u<r&&(r=u),u>l&&(l=u);let c=this.films.length>1?`${"AB"[n]}: `:"",d={name:k(o),low:x(
r,3),high:x(l,3)};return l>=r?`${c}${k("{name} from {low} to {high}",d)}`:""}),s=k("Diagram: {title} in {unit}.",{title:k(this.title),unit:k(this.unit)});this.body.
setAttribute("aria-label",`${s} ${t.filter(Boolean).join("; ")}.`)}cursor(e){if(!this.films)return;let{context:t,width:s,height:o}=L(this.over);if(t.clearRect(0,
0,s,o),this.films.forEach((a,n)=>{let r=a.at(e),l=a.index(r.t),c=Math.min(l+1,a.length-1),d=a.t[c]>a.t[l]?(r.t-a.t[l])/(a.t[c]-a.t[l]):0,u=this.abscissa(a),p=this.
x(u[l]+d*(u[c]-u[l])),m=p>=H-1&&p<=H+this.box.width+1;m&&(t.strokeStyle=this.look.soft,t.lineWidth=1,t.beginPath(),t.moveTo(p,B),t.lineTo(p,B+this.box.height),t.
stroke()),this.shades(a).forEach((g,b)=>{let w=g.values[c],f=Number.isFinite(w)?g.values[l]+d*(w-g.values[l]):g.values[l];n===this.active&&this.values?.[b]&&(this.
values[b].textContent=x(f,3));let v=this.y(f);!m||!(v>=B-1&&v<=B+this.box.height+1)||(t.fillStyle=g.color??this.look.ink,t.beginPath(),t.arc(p,v,3.2,0,2*Math.PI),
t.fill())})}),this.picked){let[a,n]=this.picked;t.fillStyle=Te("#0072B2",.2),t.fillRect(Math.min(a,n),B,Math.abs(n-a),this.box.height)}}valueAt(e){let t=this.body.
getBoundingClientRect(),s=y((e.clientX-t.left-H)/this.box.width,0,1);return this.range[0]+s*(this.range[1]-this.range[0])}press(e){if(!this.films)return;let t=this.
body.getBoundingClientRect(),s=e.clientX-t.left,o=this.valueAt(e),a=this.pinched(),n=r=>{if(a||=this.pinched(),a)return;let l=r.clientX-t.left;this.picked=e.pointerType===
"mouse"&&Math.abs(l-s)>5?[s,l]:null,e.pointerType!=="mouse"&&this.seek(this.valueAt(r)),this.cursor(this.shared.clock.time)};C(this.body,e,n,(r,l)=>{let c=this.
valueAt(r),{picked:d}=this;this.picked=null,d&&l?this.zoomTo(o<c?[o,c]:[c,o]):d?this.cursor(this.shared.clock.time):l&&!a&&this.seek(e.pointerType==="mouse"?o:c)})}seek(e){
if(this.shared.axis==="time")return this.onseek(e);let t=this.films[this.active],s=this.abscissa(t),o=0;for(let a=0;a<s.length;a++)Math.abs(s[a]-e)<Math.abs(s[o]-
e)&&(o=a);return this.onseek(t.t[o])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(e,t){let s=this.fullRange(),o=Math.max(e-(e-this.range[0])*t,s[0]),
a=Math.min(e+(this.range[1]-e)*t,s[1]);this.zoomTo(o<=s[0]&&a>=s[1]?null:[o,a])}zoomTo(e){this.shared.range=e&&e[1]-e[0]>1e-9?e:null,this.shared.changed()}};function ns(i,e="\
solid"){let t=h("i",{class:"swatch","aria-hidden":"true"});return t.style.borderTopColor=i??"var(--ink)",t.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"\
dotted"}[e],t}var ne=52,So=10,R=8,va=30,ka="RSKHM?",yt=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(e,t,s){this.backend=
e,this.clock=t,this.colors=s,this.canvas=h("canvas",{class:"plot-canvas"}),this.over=h("canvas",{class:"plot-canvas plot-over"}),this.keys=h("div",{class:"plot-\
keys"}),this.body=h("div",{class:"plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and fli\
ght"},this.canvas,this.over),this.element=h("section",{class:"phase"},h("header",{},h("h3",{},"Plane of θ and θ̇"),this.keys),this.body,h("p",{class:"hint"},
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox."," ",`Click to go there; ${be("")}.`)),this.body.addEventListener(
"pointerdown",o=>this.seek(o)),this.pinched=_(this.body,{zoom:(o,a)=>this.box&&this.zoomAbout(a?this.point(a):this.middle(),1/o),home:()=>this.zoomTo(null),keys:!0}),
this.range=[0,2*Math.PI],this.asked="",this.soon=G(()=>this.sharpen(),140)}async fetch(e,t){let s=this.reach(),o=JSON.stringify([e.hoop,e.plane,s]);if(o!==this.
asked){let a=await this.painted(e,[0,2*Math.PI,-s,s],t);this.asked=o,this.pictures=[a],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(!(!this.
pictures||!this.window)){this.sharpening?.abort(),this.sharpening=new AbortController;try{let e=await this.painted(this.films[this.active].scenario,[...this.range,
...this.window],this.sharpening.signal);this.pictures=[this.pictures[0],e],this.redraw()}catch(e){if(e.name!=="AbortError")throw e}}}async painted(e,t,s){let{header:o,
arrays:a}=await this.backend.call("regions",{scenario:e,window:t},s);return{window:o.window,paradox:a.paradox,picture:this.paint(a.modes,o.arrays[0].shape)}}reach(){
return this.reached}findReach(){let e=0;for(let s of this.films??[]){let o=Float64Array.from(s.columns.omega,Math.abs).filter(Number.isFinite).sort();e=Math.max(
e,o[Math.floor(.99*(o.length-1))]??0)}let t=D(Math.max(e,1)*1.15,4);return Math.ceil(Math.max(e,1)*1.12/t)*t}zoomTo(e){this.range=e??[0,2*Math.PI],this.window=null,
this.pictures?.splice(1),this.redraw()}point(e){let t=this.body.getBoundingClientRect(),s=(e.clientX-t.left-ne)/this.box.width,o=1-(e.clientY-t.top-R)/this.box.
height;return[this.range[0]+s*(this.range[1]-this.range[0]),this.bottom()+o*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.
bottom()+this.top())]}zoomAbout([e,t],s){let o=Math.max(e-(e-this.range[0])*s,0),a=Math.min(e+(this.range[1]-e)*s,2*Math.PI),n=this.reach(),r=Math.max(t-(t-this.
bottom())*s,-n),l=Math.min(t+(this.top()-t)*s,n);this.range=[o,a],this.window=a-o<2*Math.PI-1e-9||l-r<2*n-1e-9?[r,l]:null,this.redraw(),this.soon()}bottom(){return this.
window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(e,t,s){this.films=
e,this.active=t,this.look=s,this.reached=this.findReach(),this.forwards=e.some(o=>o.columns.omega.some(a=>a>.3)),this.backwards=e.some(o=>o.columns.omega.some(a=>a<
-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(e){return ne+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return R+
(1-(e-this.bottom())/(this.top()-this.bottom()))*this.box.height}paint(e,[t,s]){let{modes:o}=this.colors,a=h("canvas",{width:s,height:t}),n=new ImageData(s,t);for(let r=0;r<
t;r++)for(let l=0;l<s;l++){let c=ka[e[r*s+l]],d=Z(o[c]??"#6E6E6E"),u=4*((t-1-r)*s+l);n.data.set([...d,255],u)}return ee(a).putImageData(n,0,0),a}redraw(){if(!this.
films)return;let{colors:e,look:t}=this,{context:s,width:o,height:a}=L(this.canvas);if(this.box={width:o-ne-So,height:a-R-va},s.clearRect(0,0,o,a),s.save(),s.beginPath(),
s.rect(ne,R,this.box.width,this.box.height),s.clip(),this.pictures){s.imageSmoothingEnabled=!1;for(let{picture:n,window:r}of this.pictures){let[l,c,d,u]=r,p=[this.
x(l),this.y(u),this.x(c)-this.x(l),this.y(d)-this.y(u)];s.fillStyle=t.panel,s.fillRect(p[0],p[1],p[2],p[3]),s.globalAlpha=.35,s.drawImage(n,p[0],p[1],p[2],p[3]),
s.globalAlpha=1}this.hatch(s)}for(let[n,r]of this.films.entries())this.way(s,r,n);if(s.restore(),this.axes(s,o,a),this.keyed!==t.dark){this.keyed=t.dark;let n=Object.
entries(e.mode_names).filter(([r])=>"RSKH".includes(r));this.keys.replaceChildren(...n.map(([r,l])=>h("span",{class:"plot-key"},ns(e.modes[r]),l)))}this.cursor(
this.clock.time)}hatch(e){let{paradox:t}=this.pictures[0],s=t.length;e.strokeStyle=Te(this.look.dark?"#ffffff":"#000000",.28),e.lineWidth=1;for(let o=0;o<s;o++){
if(!t[o])continue;let a=o;for(;a<s&&t[a]===t[o];)a++;let n=this.x(o*2*Math.PI/s),r=this.x(a*2*Math.PI/s);e.save(),e.beginPath(),e.rect(n,R,r-n,this.box.height),
e.clip(),e.beginPath();let l=t[o];for(let c=-this.box.height;c<r-n+this.box.height;c+=7)e.moveTo(n+c,l>0?R+this.box.height:R),e.lineTo(n+c+this.box.height,l>0?R:
R+this.box.height);e.stroke(),e.restore(),o=a}}way(e,t,s){let{angle:o,omega:a,mode:n}=t.columns,r=2*Math.PI;e.lineWidth=s?1.2:1.8,e.setLineDash(s?[4,3]:[]),e.strokeStyle=
this.look.ink,e.beginPath();let l=null;for(let c=0;c<t.length;c++){if(!Number.isFinite(a[c])){l=null;continue}let d=Math.floor(o[c]/r),u=o[c]-d*r;if(l===null)e.
moveTo(this.x(u),this.y(a[c]));else if(d!==l.lap){let p=d>l.lap?r:0;e.lineTo(this.x(p),this.y(a[c])),e.moveTo(this.x(r-p),this.y(a[c])),e.lineTo(this.x(u),this.
y(a[c]))}else e.lineTo(this.x(u),this.y(a[c]));l={lap:d,mode:n[c]}}e.stroke(),e.setLineDash([])}axes(e,t,s){let{look:o}=this;e.font=`11px ${o.font}`,e.strokeStyle=
o.soft,e.fillStyle=o.soft,e.lineWidth=1,e.strokeRect(ne+.5,R+.5,this.box.width-1,this.box.height-1),e.textAlign="center";let a=this.range[0]*180/Math.PI,n=this.
range[1]*180/Math.PI,r=n-a>200?45:D(n-a,6);for(let c=Math.ceil(a/r-1e-9);c*r<=n+1e-9;c++){let d=this.x(c*r*Math.PI/180);e.beginPath(),e.moveTo(d,R+this.box.height),
e.lineTo(d,R+this.box.height+4),e.stroke(),e.fillText(j(c*r,r),d,R+this.box.height+15)}e.textAlign="right",e.fillText(k("angle θ within a turn [°]"),t-So,s-3),
e.textBaseline="middle";let l=this.top()-this.bottom();for(let c of O(this.bottom(),this.top(),5))e.fillText(j(c,D(l,5)),ne-6,this.y(c));e.textBaseline="alphabe\
tic",e.save(),e.translate(11,R+.5*this.box.height),e.rotate(-Math.PI/2),e.textAlign="center",e.fillText("θ̇ [rad/s]",0,0),e.restore()}cursor(e){if(!this.films||
!this.box)return;let{context:t,width:s,height:o}=L(this.over);t.clearRect(0,0,s,o),this.films.forEach((a,n)=>{let r=a.at(e),l=2*Math.PI,c=r.angle-Math.floor(r.angle/
l)*l,d=this.x(c),u=this.y(r.omega);d>=ne&&d<=ne+this.box.width&&u>=R&&u<=R+this.box.height&&(t.beginPath(),t.arc(d,u,n?4:5.5,0,2*Math.PI),t.fillStyle=this.colors.
modes[r.mode],t.fill(),t.lineWidth=2,t.strokeStyle=this.look.ink,t.stroke())})}seek(e){let t=this.body.getBoundingClientRect(),[s,o]=[e.clientX-t.left,e.clientY-
t.top];if(this.pinched())return;let a=this.films[this.active],{angle:n,omega:r}=a.columns,l=2*Math.PI,c={distance:1/0,t:0};for(let d=0;d<a.length;d++){let u=n[d]-
Math.floor(n[d]/l)*l,p=Math.hypot(this.x(u)-s,this.y(r[d])-o);p<c.distance&&(c={distance:p,t:a.t[d]})}c.distance<40&&this.clock.seek(y(c.t,0,a.duration))}};var rs=i=>Object.entries(q).map(([e,t])=>h("option",{value:e},i(t)));function Mo(i){let e="height",t=new ye({key:"own",title:"Your choice",unit:"",curves:a=>[{name:k(
q[e].name),values:q[e].values(a)}]},i),s=()=>{let{symbol:a,unit:n}=q[e];t.unit=n?`${a} [${n}]`:a},o=h("select",{"aria-label":"What your diagram shows",onchange:()=>{
e=o.value,s(),i.changed()}},rs(to));return o.value=e,s(),t.element.querySelector("h3")?.after(o),t}function xa(i){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:e=>[{name:"v (centre)",color:i.center_speed,values:e.columns.vx},{name:"\
R θ̇",color:i.rotation_speed,dash:"dash",values:e.derived("spin",({omega:t})=>Float64Array.from(t,s=>s*e.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:e=>[{name:"kinetic",color:i.kinetic,values:e.columns.kinetic},{name:"potential",color:i.potential,values:e.columns.potential},{name:"\
total",values:e.derived("total",({t,kinetic:s,potential:o})=>Float64Array.from(t,(a,n)=>s[n]+o[n])),dash:"dash"},{name:"lost to friction",color:i.friction_loss,
values:e.columns.friction_loss},{name:e.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:i.impact_loss,values:e.columns.
normal_loss,dash:"dot"}]},{key:"forces",title:"Contact forces",unit:"force [N]",curves:e=>[{name:"normal N",color:i.normal_force,values:e.columns.normal_force},
{name:"friction F",color:i.friction_force,dash:"dash",values:e.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],
curves:e=>[{name:"|F| / μN",color:i.friction_force,values:e.columns.utilization}]}]}var vt=class{films;active;look;constructor(e,t){this.colors=t,this.shared={
axis:"time",range:null,clock:e,changed:()=>this.redraw()},this.plots=[...xa(t).map(o=>new ye(o,this.shared)),Mo(this.shared)];for(let o of this.plots)o.onseek=a=>e.
seek(a);this.seen=new Map(this.plots.map(o=>[o.element,!0]));let s=new IntersectionObserver(o=>{for(let{target:a,isIntersecting:n}of o)this.seen.set(a,n);this.redraw()},
{rootMargin:"400px"});for(let o of this.plots)s.observe(o.element);this.axis=h("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.
axis=this.axis.value,this.shared.range=null,this.redraw()}},rs(({name:o})=>`over ${o}`)),this.back=h("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].
zoomTo(null)},"Whole motion"),this.hint=h("span",{class:"hint"}),this.element=h("div",{class:"plots"},h("div",{class:"plots-head"},this.axis,this.back,this.hint),
this.plots.map(o=>o.element))}draw(e,t,s){this.films=e,this.active=t,this.look=s;let o=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":
`click to go there, drag to zoom; ${be("")}`,a=e.length>1;T(this.hint,a?`A full, B dotted; numbers and colours of ${"AB"[t]}; ${o}`:o),this.redraw()}redraw(){if(this.
films?.length){this.back.hidden=!this.shared.range;for(let e of this.visible())e.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.clock.
time)}}visible(){return this.plots.filter(e=>this.seen.get(e.element))}cursor(e){for(let t of this.visible())t.cursor(e)}};var Ta=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],kt=class{constructor(e){this.lab=e,this.menu=h("details",{class:"menu"},h("summary",{class:"button"},"Keep"),h("div",{class:"menu-body"},e.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),Ta.map(([t,s])=>this.item(s,()=>this.download(t))),this.item("Picture (PNG)",()=>this.picture()),this.item("Recor\
d a film here (WebM)",()=>this.record()),this.item("Show me the Python",()=>this.code()))),this.dialog=h("dialog",{class:"code-dialog","aria-label":"The same mo\
tion in Python"}),e.root.addEventListener("pointerdown",t=>{this.menu.contains(t.target)||(this.menu.open=!1)})}item(e,t){return h("button",{type:"button",onclick:async()=>{
this.menu.open=!1;try{await t()}catch(s){this.lab.notice.fail(s)}}},e)}async copyLink(){let e=this.lab.link()??"";try{await navigator.clipboard.writeText(e),this.
lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",e)}}async download(e){let t=this.lab.film();this.lab.notice.say(e.endsWith("mp4")?
"The film is being made; this takes a while …":`Fetching ${e} …`),fe(await this.lab.backend.file(e,t.query),`hophoop-${e}`),this.lab.notice.say(`${e} is the\
re.`)}picture(){this.lab.drawStage();let e=this.lab.stage.canvas(),t=h("canvas",{width:e.width,height:e.height});return this.copyInto(t),new Promise(s=>{t.toBlob(
o=>{o&&fe(o,"hophoop.png"),s()},"image/png")})}copyInto(e){let{lab:t}=this,s=t.stage.canvas(),o=ee(e);o.fillStyle=t.theme.look.paper,o.fillRect(0,0,e.width,e.height),
o.drawImage(s,0,0,e.width,e.height);let a=e.width/Math.max(s.getBoundingClientRect().width,1);o.textBaseline="top",o.textAlign="left";let n=t.films();for(let[r,
l]of n.entries()){let c=l.at(t.clock.time),d=[n.length>1?`${"AB"[r]}: `:"",`${k(t.theme.colors.mode_names[c.mode])}, t = ${c.t.toFixed(3)} s, θ = ${P(c.angle)}\
, v = ${x(c.vx,3)} m/s`].join(""),u=t.stage.options.three?10+20*r:10+r*s.getBoundingClientRect().height/n.length;o.fillStyle=t.theme.colors.modes[c.mode],o.fillRect(
12*a,(u+2)*a,11*a,11*a),o.fillStyle=t.theme.look.ink,o.font=`${13*a}px ${t.theme.look.font}`,o.fillText(d,30*a,u*a)}}async record(){let{lab:e}=this,t=e.stage.canvas();
if(!t.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 instead.");let s=h("canvas",{width:2*Math.ceil(
t.width/2),height:2*Math.ceil(t.height/2)}),o=new MediaRecorder(s.captureStream(60),{videoBitsPerSecond:8e6}),a=[];o.ondataavailable=l=>a.push(l.data);let n=new Promise(
l=>o.onstop=l),r=e.clock.loop;e.clock.loop=!1,e.clock.seek(0),e.notice.say("Recording one run …"),e.afterFrame=()=>{this.copyInto(s),!e.clock.playing&&o.state===
"recording"&&o.stop()},o.start(),e.clock.play(!0),await n,e.afterFrame=null,e.clock.loop=r,fe(new Blob(a,{type:o.mimeType}),"hophoop.webm"),e.notice.say("The fi\
lm is there.")}async code(){let{header:e}=await this.lab.backend.call("code",{scenario:this.lab.film().scenario});this.show("The same motion in Python",e.python,
"The scenario as a file",e.toml)}show(...e){let t=[];for(let s=0;s<e.length;s+=2){let o=e[s+1],a=h("button",{type:"button"},"Copy");a.onclick=async()=>{await navigator.
clipboard?.writeText(o).catch(()=>{}),T(a,"Copied")},t.push(h("header",{},h("h2",{},e[s]),a),h("pre",{tabindex:"0"},h("code",{},document.createTextNode(o))))}this.
dialog.replaceChildren(...t,h("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};function zo(i,e){let t=h("div",{class:"edge","aria-hidden":"true"}),s=new IntersectionObserver(([o])=>{let a=!o.isIntersecting&&o.boundingClientRect.top<0;if(a===
i.classList.contains("stuck"))return;let n=i.offsetHeight;i.style.marginBottom="",i.classList.toggle("stuck",a),a&&(i.style.marginBottom=`${n-i.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=a?`${i.offsetHeight}px`:"",e()});return s.observe(t),{edge:t,close:()=>s.disconnect()}}var Eo=120,xt=class{constructor(e,t){this.canvas=e,this.onview=t,this.zoom=1,this.shift=[0,0],this.views=[],this.fixed=null,this.grab=()=>!1,e.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=_(e,{zoom:s=>this.zoomBy(s),home:()=>this.reset(),chosen:()=>e.parentElement})}reset(){this.zoom=1,this.shift=[0,0],
this.onview()}zoomBy(e){this.zoom=y(this.zoom*e,.05,60),this.onview()}drag(e){if(this.grab(e))return;let t=[e.clientX,e.clientY],s=this.shift;C(this.canvas,e,o=>{
this.pinched()||(this.shift=[s[0]+o.clientX-t[0],s[1]+o.clientY-t[1]],this.onview())})}draw(e,t,s,o,a){let{context:n,width:r,height:l}=L(this.canvas);if(n.clearRect(
0,0,r,l),r<40||l<40)return;let c=l/e.length,d={top:Math.max(...e.map(u=>u.extent.top)),radius:Math.max(...e.map(u=>u.radius)),speed:Math.max(...e.map(u=>u.extent.
speed))};e.forEach((u,p)=>{n.save(),n.beginPath(),n.rect(0,p*c,r,c),n.clip(),n.translate(0,p*c);let m=new ls(n,r,c,u,t,s,o,a,this.zoom,this.shift,d);m.top=p*c,m.
scale=this.fixed??m.scale,m.draw(),this.views[p]=m,e.length>1&&(n.fillStyle=o.soft,n.font=`600 15px ${o.font}`,n.textAlign="left",n.fillText("AB"[p],12,c-12)),n.
restore(),p>0&&(n.fillStyle=o.line,n.fillRect(0,p*c-.5,r,1))})}},ls=class{top=0;constructor(e,t,s,o,a,n,r,l,c,d,u){this.context=e,this.width=t,this.height=s,this.
film=o,this.options=n,this.look=r,this.colors=l,this.common=u,this.pose=o.at(a);let p=o.radius,{left:m,right:g}=o.extent,{top:b}=u;this.cosine=Math.cos(o.slope),
this.sine=Math.sin(o.slope);let w=2*u.radius+Math.min(b,6*u.radius),f=Math.min(.66*s/w,.36*t/u.radius);if(n.whole){let v=(g-m)*this.cosine+2.6*p,S=(g-m)*Math.abs(
this.sine)+2.6*p+b;this.scale=Math.min(t/v,.86*s/S,f)*c,this.focus=[.5*(m+g),0],this.place=[.5*t+d[0],(o.slope?.62:.8)*s+d[1]]}else this.scale=f*c,this.focus=[Number.
isFinite(this.pose.x)?this.pose.x:0,0],this.place=[(t<520?.6:.46)*t+d[0],.82*s+d[1]]}point(e,t){let s=e-this.focus[0],o=t-this.focus[1];return[this.place[0]+this.
scale*(s*this.cosine+o*this.sine),this.place[1]-this.scale*(o*this.cosine-s*this.sine)]}unpoint(e,t){let s=(e-this.place[0])/this.scale,o=-(t-this.place[1])/this.
scale;return[this.focus[0]+s*this.cosine-o*this.sine,this.focus[1]+s*this.sine+o*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.
traces(),this.hoop(),this.options.forces&&this.forces()}ground(){let{context:e,look:t,width:s,height:o}=this,a=(Math.hypot(s,o)*1.2+Math.abs(this.place[0])+Math.
abs(this.place[1]))/this.scale,[n,r]=this.point(this.focus[0]-a,0),[l,c]=this.point(this.focus[0]+a,0),d=[-this.sine*4e3,this.cosine*4e3];e.fillStyle=t.ground,e.
beginPath(),e.moveTo(n,r),e.lineTo(l,c),e.lineTo(l+d[0],c+d[1]),e.lineTo(n+d[0],r+d[1]),e.fill(),e.strokeStyle=t.soft,e.lineWidth=1.5,e.beginPath(),e.moveTo(n,r),
e.lineTo(l,c),e.stroke();let u=D(s/this.scale,s/90);e.fillStyle=t.soft,e.font=`11px ${t.font}`,e.textAlign="center",e.lineWidth=1;let p=Math.ceil((this.focus[0]-
a)/u),m=Math.min(Math.floor((this.focus[0]+a)/u),p+400);for(let g=p;g<=m;g++){let[b,w]=this.point(g*u,0);b<-40||b>s+40||(e.beginPath(),e.moveTo(b,w),e.lineTo(b-
6*this.sine,w+6*this.cosine),e.stroke(),e.fillText(`${j(g*u,u)} m`,b-18*this.sine,w+8+10*this.cosine))}}traces(){let{film:e,context:t,look:s,colors:o}=this,a=this.
options.ahead?e.length-1:e.index(this.pose.t),n=e.radius,{x:r,height:l,angle:c,mode:d}=e.columns,u=(p,m,g,b)=>{t.strokeStyle=m,t.lineWidth=g,t.lineJoin="round",
t.beginPath();let w=!1,f=(v,S,M)=>{let[A,E]=this.point(v+p*Math.sin(M),n+S+p*Math.cos(M));w?t.lineTo(A,E):t.moveTo(A,E),w=!0};for(let v=0;v<=a;v++)b===void 0||d[v]===
3===b?f(r[v],l[v],c[v]):w=!1;!this.options.ahead&&(b===void 0||this.pose.mode==="H"===b)&&f(this.pose.x,this.pose.height,this.pose.angle),t.stroke()};t.globalAlpha=
this.options.ahead?.45:1,u(n,s.ink,1.3),u(e.eccentricity*n,o.gravity_center,1.8,!1),u(e.eccentricity*n,o.airborne,2.4,!0),t.globalAlpha=1}hoop(){let{film:e,pose:t,
context:s,look:o,colors:a,scale:n}=this,r=e.radius,l=y(.07*r*n,2,14),c=r-.5*l/n,d=[t.x,r+t.height],u=(w,f=c)=>this.point(d[0]+f*Math.sin(w),d[1]+f*Math.cos(w));
if(s.lineCap="butt",o.dark&&(s.strokeStyle=o.soft,s.lineWidth=l+2,s.beginPath(),s.arc(...this.point(d[0],d[1]),c*n,0,2*Math.PI),s.stroke()),this.options.speed){
let w=this.common.speed;s.lineWidth=l;let f=2*Math.PI/Eo;for(let v=0;v<Eo;v++){let S=t.angle+v*f,M=Math.hypot(t.vx+r*t.omega*Math.cos(S+.5*f),t.vy-r*t.omega*Math.
sin(S+.5*f));s.strokeStyle=He[y(Math.round(255*M/w)||0,0,255)],s.beginPath(),s.moveTo(...u(S-.04*f)),s.lineTo(...u(S+1.04*f)),s.stroke()}}else s.strokeStyle=a.modes[t.
mode],s.lineWidth=l,s.beginPath(),s.arc(...this.point(d[0],d[1]),c*n,0,2*Math.PI),s.stroke();s.strokeStyle=o.soft,s.lineWidth=1,s.beginPath(),s.moveTo(...this.point(
d[0],d[1])),s.lineTo(...u(t.angle)),s.stroke();let p=(w,f,v,S)=>{s.beginPath(),s.arc(...w,f,0,2*Math.PI),s.fillStyle=v,s.fill(),s.lineWidth=1.5,s.strokeStyle=S,
s.stroke()};p(this.point(d[0],d[1]),2.5,o.soft,o.soft);let m=e.scenario.hoop.parts;m?this.parts(m,d):p(u(t.angle),y(.1*r*n,4,16),o.ink,o.paper);let g=e.eccentricity*
r,b=this.point(d[0]+g*Math.sin(t.angle),d[1]+g*Math.cos(t.angle));p(b,y(.05*r*n,3.5,7),t.mode==="H"?a.airborne:a.gravity_center,o.paper)}parts(e,t){let{film:s,pose:o,
context:a,look:n,scale:r}=this,c=e.reduce((d,u)=>d+u.mass*(u.at??0),0)<0?-1:1;a.strokeStyle=n.ink;for(let d of e){let u=c*(d.at??0),p=this.point(t[0]+u*Math.sin(
o.angle),t[1]+u*Math.cos(o.angle));if(a.fillStyle=n.ink,a.lineWidth=1,a.beginPath(),d.shape==="ring")a.globalAlpha=.22,a.arc(...p,d.outer_radius*r,0,2*Math.PI),
a.arc(...p,d.inner_radius*r,0,2*Math.PI,!0),a.fill(),a.globalAlpha=1;else if(d.shape==="rod"){let m=.5*d.length,g=b=>this.point(t[0]+b*Math.sin(o.angle),t[1]+b*
Math.cos(o.angle));a.lineWidth=4,a.moveTo(...g(u-m)),a.lineTo(...g(u+m)),a.stroke()}else{let m=d.shape==="disk"?d.radius*r:y(.08*s.radius*r,3,12);a.globalAlpha=
d.shape==="disk"?.55:1,a.arc(...p,m,0,2*Math.PI),a.fill(),a.globalAlpha=1}}}forces(){let{film:e,pose:t,colors:s}=this,o=e.radius,a=e.mass*(e.gravity||9.81),n=l=>.55*
o*l/a;if(t.mode==="H"||!(t.normal_force>0))return;let r=[t.x,t.height];this.arrow(r,[0,n(t.normal_force)],s.normal_force,`N = ${x(t.normal_force,3)} N`,!1),this.
arrow(r,[n(t.friction_force),0],s.friction_force,`F = ${x(t.friction_force,3)} N`,!0)}arrow([e,t],[s,o],a,n,r){let{context:l,look:c,width:d}=this,u=2.2*this.film.
radius,p=Math.abs(s)>u||Math.abs(o)>u;[s,o]=[y(s,-u,u),y(o,-u,u)];let m=this.point(e,t),g=this.point(e+s,t+o),b=Math.hypot(g[0]-m[0],g[1]-m[1]);if(b<2)return;let w=(g[0]-
m[0])/b,f=(g[1]-m[1])/b,v=Math.min(11,b);for(let[A,E]of[[c.paper,6],[a,3]])l.strokeStyle=A,l.fillStyle=A,l.lineWidth=E,l.beginPath(),l.moveTo(...m),l.lineTo(g[0]-
w*v,g[1]-f*v),l.stroke();if(l.beginPath(),l.moveTo(...g),l.lineTo(g[0]-w*v-f*v*.5,g[1]-f*v+w*v*.5),l.lineTo(g[0]-w*v+f*v*.5,g[1]-f*v-w*v*.5),l.fill(),p){let[A,E]=[
m[0]+.55*w*b,m[1]+.55*f*b];l.strokeStyle=c.paper,l.lineWidth=2,l.beginPath();for(let z of[-3,3])l.moveTo(A+w*(z-3)-f*7,E+f*(z-3)+w*7),l.lineTo(A+w*(z+3)+f*7,E+f*
(z+3)-w*7);l.stroke()}l.font=`600 12px ${c.font}`;let S=l.measureText(n).width;l.lineWidth=3,l.strokeStyle=r?c.ground:c.paper,l.textAlign="left";let M=r?[m[0]-.5*
S-32*this.sine,m[1]+32*this.cosine]:[g[0]+12,y(g[1]+4,16,m[1]-.36*this.film.radius*this.scale)];M[0]=y(M[0],4,d-S-4),l.strokeText(n,M[0],M[1]),l.fillText(n,M[0],
M[1])}};function cs(i,e){let t=new Float32Array(16);for(let s=0;s<4;s++)for(let o=0;o<4;o++){let a=0;for(let n=0;n<4;n++)a+=i[4*n+o]*e[4*s+n];t[4*s+o]=a}return t}function Ao(i,e,t,s){
let o=1/Math.tan(i/2),a=1/(t-s);return new Float32Array([o/e,0,0,0,0,o,0,0,0,0,(s+t)*a,-1,0,0,2*s*t*a,0])}function Po(i,e){let t=ue(ds(i,e)),s=ue(Tt([0,1,0],t)),
o=Tt(t,s);return new Float32Array([s[0],o[0],t[0],0,s[1],o[1],t[1],0,s[2],o[2],t[2],0,-hs(s,i),-hs(o,i),-hs(t,i),1])}var ds=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],
hs=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Tt=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];function ue(i){let e=Math.hypot(...i)||1;return[
i[0]/e,i[1]/e,i[2]/e]}function St(i,e,t,s){let o=ue(e),a=ue(Tt(o,Math.abs(o[2])>.9?[1,0,0]:[0,0,1])),n=Tt(a,o);return new Float32Array([...a.map(r=>r*s),0,...o.
map(r=>r*t),0,...n.map(r=>r*s),0,...i,1])}function us(i){let[e,t]=[Math.cos(i),Math.sin(i)];return new Float32Array([e,-t,0,0,t,e,0,0,0,0,1,0,0,0,0,1])}function $(i){let e=Number.parseInt(i.slice(1,7),16);
return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}function ve(i,e,t){let s=i.createProgram(),o=[[i.VERTEX_SHADER,e],[i.FRAGMENT_SHADER,t]];for(let[n,r]of o){let l=i.createShader(n);if(i.shaderSource(l,r),i.compileShader(
l),!i.getShaderParameter(l,i.COMPILE_STATUS))throw new Error(String(i.getShaderInfoLog(l)));i.attachShader(s,l)}if(i.linkProgram(s),!i.getProgramParameter(s,i.LINK_STATUS))
throw new Error(String(i.getProgramInfoLog(s)));let a={program:s,uniforms:{},attributes:{}};for(let n=0;n<i.getProgramParameter(s,i.ACTIVE_UNIFORMS);n++){let{name:r}=i.
getActiveUniform(s,n);a.uniforms[r]=i.getUniformLocation(s,r)}for(let n=0;n<i.getProgramParameter(s,i.ACTIVE_ATTRIBUTES);n++){let{name:r}=i.getActiveAttrib(s,n);
a.attributes[r]=i.getAttribLocation(s,r)}return a}function pe(i,e,t,s){let o=i.createBuffer();i.bindBuffer(i.ARRAY_BUFFER,o),i.bufferData(i.ARRAY_BUFFER,new Float32Array(
e),i.STATIC_DRAW);let a=s?i.createBuffer():null;s&&(i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,a),i.bufferData(i.ELEMENT_ARRAY_BUFFER,new Uint16Array(s),i.STATIC_DRAW));
let n=4*Object.values(t).reduce((r,l)=>r+l,0);return{vertices:o,elements:a,parts:t,stride:n,count:s?s.length:4*e.length/n}}function ke(i,e,t){i.bindBuffer(i.ARRAY_BUFFER,
t.vertices);let s=0;for(let[o,a]of Object.entries(t.parts)){let n=e.attributes[o];n!==void 0&&(i.enableVertexAttribArray(n),i.vertexAttribPointer(n,a,i.FLOAT,!1,
t.stride,s)),s+=4*a}t.elements&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.elements)}function ps(i,e){let t=[];for(let s=0;s<i;s++)for(let o=0;o<e;o++){let a=s*(e+1)+
o,n=a+e+1;t.push(a,n,a+1,n,n+1,a+1)}return t}function Ro(i,e=120,t=14){let s=[];for(let o=0;o<=e;o++)for(let a=0;a<=t;a++)s.push(2*Math.PI*o/e,2*Math.PI*a/t);return pe(
i,s,{bend:2},ps(e,t))}function Lo(i,e=28,t=18){let s=[];for(let o=0;o<=e;o++)for(let a=0;a<=t;a++){let[n,r]=[2*Math.PI*o/e,Math.PI*a/t],l=[Math.sin(r)*Math.cos(
n),Math.cos(r),Math.sin(r)*Math.sin(n)];s.push(...l,...l)}return pe(i,s,{position:3,normal:3},ps(e,t))}function ms(i,e,t=20){let s=[];for(let o=0;o<=t;o++){let a=2*
Math.PI*o/t,n=[Math.cos(a),1-e,Math.sin(a)];s.push(Math.cos(a),0,Math.sin(a),...n,e*Math.cos(a),1,e*Math.sin(a),...n)}return pe(i,s,{position:3,normal:3},ps(t,1))}var qo=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Do=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,No="vec4(0.0, 0.0, 0.0, shadow)",Io=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Do}
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
   ${qo}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${No} : vec4(shaded(color, n), 1.0);
   }`],Co=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Do}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${qo}
   void main() { gl_FragColor = shadow > 0.0 ? ${No} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],Wo=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],Mt=class{constructor(e,t,s,o,{keep:a=!1}={}){let n=e.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:a});if(!n)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=n,this.canvas=
e,this.sun=ue(s),this.dark=o,this.slant=[s[0]/s[1],1,s[2]/s[1]],this.rim=ve(n,Io[0],Io[1]),this.body=ve(n,Co[0],Co[1]),this.line=ve(n,Wo[0],Wo[1]),this.torus=Ro(
n),this.sphere=Lo(n),this.cylinder=ms(n,1),this.cone=ms(n,0),this.colors=n.createTexture(),n.bindTexture(n.TEXTURE_2D,this.colors);let r=new Uint8Array(t.flatMap(
l=>[...l,255]));n.pixelStorei(n.UNPACK_ALIGNMENT,1),n.texImage2D(n.TEXTURE_2D,0,n.RGBA,t.length,1,0,n.RGBA,n.UNSIGNED_BYTE,r);for(let l of[n.TEXTURE_WRAP_S,n.TEXTURE_WRAP_T])
n.texParameteri(n.TEXTURE_2D,l,n.CLAMP_TO_EDGE);for(let l of[n.TEXTURE_MIN_FILTER,n.TEXTURE_MAG_FILTER])n.texParameteri(n.TEXTURE_2D,l,n.LINEAR);this.view=us(0),
this.eye=[0,0,1],this.fastest=1}begin({background:e,eye:t,target:s,slope:o,angle:a,near:n,far:r}){let{gl:l,canvas:c}=this;l.viewport(0,0,c.width,c.height),l.clearColor(
e[0],e[1],e[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let d=Ao(a,c.width/c.height,n,r);this.view=cs(cs(d,
Po(t,s)),us(o)),this.eye=ue(ds(t,s))}use(e,t){let{gl:s}=this;s.useProgram(e.program);let o={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...t};for(let[
a,n]of Object.entries(o)){let r=e.uniforms[a];r!==void 0&&(typeof n=="number"?s.uniform1f(r,n):n.length===16?s.uniformMatrix4fv(r,!1,n):s[`uniform${n.length}fv`](
r,n))}}ground(e){let{gl:t}=this;t.depthFunc(t.ALWAYS),e(),t.depthFunc(t.LESS)}shadows(e){let{gl:t}=this;t.enable(t.BLEND),t.blendFuncSeparate(t.SRC_ALPHA,t.ONE_MINUS_SRC_ALPHA,
t.ZERO,t.ONE),t.enable(t.STENCIL_TEST),t.stencilFunc(t.EQUAL,0,255),t.stencilOp(t.KEEP,t.KEEP,t.INCR),t.depthFunc(t.ALWAYS),t.depthMask(!1),e(),t.depthMask(!0),
t.depthFunc(t.LESS),t.disable(t.STENCIL_TEST),t.disable(t.BLEND)}solid(e,t,s,{shadow:o=!1,lit:a=!0}={}){let{gl:n}=this;this.use(this.body,{model:t,color:s,shadow:o?
this.dark:0,lit:Number(a)}),ke(n,this.body,e),n.drawElements(n.TRIANGLES,e.count,n.UNSIGNED_SHORT,0)}ball(e,t,s,o){this.solid(this.sphere,St(e,[0,1,0],t,t),s,{shadow:o})}ring({
center:e,radius:t,tube:s,broad:o,angle:a,velocity:n,omega:r,plain:l=null},c){let{gl:d}=this;this.use(this.rim,{center:e,size:[t,s,o,a],motion:[...n,r],most:this.
fastest,shadow:c?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),ke(d,this.rim,this.torus),d.drawElements(d.TRIANGLES,this.torus.count,d.UNSIGNED_SHORT,0)}rod(e,t,s,o,a,n=!1){
this.solid(this.cylinder,St(e,t,s,o),a,{shadow:n})}arrow(e,t,s,o,a){if(!(s>.02*o))return;let n=Math.min(.18*o,s),r=e.map((l,c)=>l+t[c]*(s-n));s>n&&this.rod(e,t,
s-n,.029*o,a),this.solid(this.cone,St(r,t,n,Math.min(.075*o,.6*n)),a)}trace(e,t,s){let o=[];for(let a=0;a<e;a++){let n=t(a),r=t(Math.min(a+1,e-1));if(Math.hypot(
r[0]-n[0],r[1]-n[1])<1e-9&&a>0){let l=t(a-1);r=n.map((c,d)=>2*c-l[d])}for(let l of[-1,1])o.push(...n,0,...r,0,...s(a),l)}return pe(this.gl,o,{position:3,next:3,
tint:3,side:1})}drawTrace(e,t,{width:s,distance:o=0,shift:a,depth:n}){let{gl:r,canvas:l}=this;this.use(this.line,{pixel:[2/l.width,2/l.height],width:s,distance:o,
shift:a,depth:n}),ke(r,this.line,e),r.drawArrays(r.TRIANGLE_STRIP,0,2*t)}onScreen([e,t,s]){let o=this.view,[a,n,r]=[0,1,3].map(l=>o[l]*e+o[4+l]*t+o[8+l]*s+o[12+
l]);return r>0?[(.5+.5*a/r)*this.canvas.width,(.5-.5*n/r)*this.canvas.height]:null}};var Sa=[.35,.85,.4],Ma=.18,Fo={azimuth:.5,height:.22,distance:5.2},Bo=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],zt=class{constructor(e,t){this.canvas=e,this.onview=t,this.space=new Mt(e,me,Sa,Ma,{keep:!0}),this.floor=ve(this.space.gl,Bo[0],Bo[1]),this.corners=pe(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...Fo},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,e.addEventListener(
"pointerdown",s=>this.drag(s)),this.pinched=_(e,{zoom:s=>this.zoomBy(s),home:()=>this.zoomBy(0),chosen:()=>e.parentElement})}zoomBy(e){e?this.turned.distance=y(
this.turned.distance/e,1.6,60):this.turned={...Fo},this.onview()}drag(e){let t={...this.turned,x:e.clientX,y:e.clientY};C(this.canvas,e,s=>{this.pinched()||(this.
turned.azimuth=y(t.azimuth-(s.clientX-t.x)*.008,-1.5,1.5),this.turned.height=y(t.height+(s.clientY-t.y)*.006,.02,1.45),this.onview())})}quality(){let e=performance.
now(),t=e-(this.before||e);return this.before=e,t>0&&t<200&&(this.pace=.9*this.pace+.1*t),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.
pace=16),this.share}draw(e,t,s,o,a,n){let{canvas:r,space:l}=this,c=Math.min(globalThis.devicePixelRatio||1,2)*(n?this.quality():1),d=r.getBoundingClientRect();r.
width=Math.max(Math.round(d.width*c),1),r.height=Math.max(Math.round(d.height*c),1);let u=e.map(g=>g.at(t)),p=e[0].radius;l.fastest=Math.max(...e.map(g=>g.extent.
speed)),this.focus=Number.isFinite(u[0].x)?u[0].x:0,l.begin({background:$(o.paper),...this.camera(e[0],u[0],p,s)}),l.ground(()=>this.drawFloor(p,o));let m=g=>{for(let[
b,w]of e.entries())g(w,u[b],-2.1*p*b)};l.shadows(()=>m((g,b,w)=>this.drawHoop(g,b,w,s,o,a,!0))),m((g,b,w)=>{this.drawHoop(g,b,w,s,o,a,!1),s.traces&&this.drawTraces(
g,b,w,o,a,c),s.forces&&this.drawForces(g,b,w,a)})}camera(e,t,s,o){let{azimuth:a,height:n,distance:r}=this.turned,{left:l,right:c}=e.extent,d=o.whole?Math.max(r*
s,.85*(c-l)+3*s):r*s,[u,p]=[o.whole?.5*(l+c)-this.focus:0,s+.45*(t.height||0)],m=Math.cos(e.slope),g=Math.sin(e.slope),b=[u*m+p*g,-u*g+p*m,0],w=[b[0]+d*Math.sin(
a)*Math.cos(n),b[1]+d*Math.sin(n),d*Math.cos(a)*Math.cos(n)];return this.reach=12*s+3*d,{eye:w,target:b,slope:e.slope,angle:.75,near:.05*s,far:40*s+6*d}}drawFloor(e,t){
let{space:s}=this,o=$(t.ground),a=o.map(l=>l*(t.dark?.82:.94)),n=.5*e,r=this.focus%(2*n);s.use(this.floor,{reach:this.reach,light:o,dark:a,far:$(t.paper),tile:n,
shift:r}),ke(s.gl,this.floor,this.corners),s.gl.drawArrays(s.gl.TRIANGLE_STRIP,0,4)}drawHoop(e,t,s,o,a,n,r){let{space:l}=this,c=e.radius,d=.045*c,u=[t.x-this.focus,
c+t.height,s];l.ring({center:u,radius:c,tube:d,broad:3.2*d,angle:t.angle,velocity:[t.vx,t.vy],omega:t.omega,plain:o.speed?null:$(n.modes[t.mode])},r);let p=[Math.
sin(t.angle),Math.cos(t.angle),0],m=b=>u.map((w,f)=>w+b*p[f]);l.ball(m(c-d),.125*c,a.dark?[.9,.91,.94]:[.12,.13,.15],r),l.rod(u,p,c-d,.012*c,[.55,.57,.6],r);let g=t.
mode==="H";l.ball(m(e.eccentricity*c),.07*c,$(g?n.airborne:n.gravity_center),r)}drawForces(e,t,s,o){if(t.mode==="H"||!(t.normal_force>0))return;let a=e.radius,n=e.
mass*(e.gravity||9.81),r=[t.x-this.focus,t.height+.03*a,s+.2*a],l=d=>y(.55*a*Math.abs(d)/n,0,3.2*a),c=Math.sign(t.friction_force);this.space.arrow(r,[0,1,0],l(t.
normal_force),a,$(o.normal_force)),this.space.arrow(r,[c,0,0],l(t.friction_force),a,$(o.friction_force))}linesOf(e,t,s){let o=this.lines.get(e);if(o?.dark===t.dark)
return o;let a=e.radius,{x:n,height:r,angle:l,mode:c}=e.columns,d=(b,w)=>this.space.trace(e.length,f=>[n[f]+b*Math.sin(l[f]),a+r[f]+b*Math.cos(l[f])],w),[u,p,m]=[
$(s.gravity_center),$(s.airborne),$(t.ink)],g={dark:t.dark,load:d(a,()=>m),center:d(e.eccentricity*a,b=>c[b]===3?p:u)};return this.lines.set(e,g),g}drawTraces(e,t,s,o,a,n){
let{load:r,center:l}=this.linesOf(e,o,a),c=Math.min(e.index(t.t)+2,e.length),d={shift:this.focus,depth:s};this.space.drawTrace(r,c,{width:n,...d}),this.space.drawTrace(
l,c,{width:1.6*n,...d})}};var za=["hoop","mode","time","angle","v","R θ̇","gap"],Et=class{constructor(e,t){this.colors=e,this.onview=t,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1},this.plane=h("canvas",{class:"stage-canvas"}),this.space=h("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new xt(this.plane,t),this.deep=
null,this.outputs=za.map(o=>({name:h("dt",{},o),value:h("dd",{})})),this.outputs[1].value.className="mode",this.fastest=h("span",{}),this.legend=h("div",{class:"\
legend","aria-hidden":"true"},h("i",{style:`background: linear-gradient(90deg, ${He.filter((o,a)=>a%15===0).join(",")})`}),h("span",{},"0"),h("span",{},"rim spe\
ed"),this.fastest);let s=(o,a)=>h("span",{},h("i",{class:"dot",style:`background:${o}`}),a);this.order=h("span",{hidden:!0},"A in front, B behind"),this.element=
h("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,h("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(
({name:o,value:a})=>[o,a])),this.legend,h("div",{class:"stage-keys","aria-hidden":"true"},s("var(--ink)","load"),s(e.gravity_center,"centre of gravity"),s(e.airborne,
"the same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(e,t,s,{look:o,inks:a}){let{options:n}=this;this.legend.hidden=!n.
speed,this.order.hidden=!(n.three&&e.length>1),this.fastest.textContent=`≥ ${x(Math.max(...e.map(r=>r.extent.speed)),2)} m/s`,n.three?(this.deep??=new zt(this.
space,this.onview),this.deep.draw(e,s.time,n,o,a,s.playing)):this.flat.draw(e,s.time,n,o,a),this.read(e,t,s.time)}read(e,t,s){let o=e[t],a=o.at(s),n=[e.length>1?
"AB"[t]:"",k(this.colors.mode_names[a.mode]),`${a.t.toFixed(3)} s`,P(a.angle),I(x(a.vx,3),"m/s"),I(x(a.omega*o.radius,3),"m/s"),a.height>0?oe(a.height):"0"];for(let[
c,d]of n.entries()){let{value:u}=this.outputs[c];u.textContent!==d&&(u.textContent=d)}let[r,l]=this.outputs;r.value.hidden=r.name.hidden=e.length<2,l.value.style.
setProperty("--mode",this.colors.modes[a.mode])}describe(e){let t=e.map(s=>s.summary).join(" ");this.element.setAttribute("aria-label",`${k("The hoop.")} ${t}`)}turn(e){
let t=()=>{this.plane.hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,t();try{e()}catch(s){throw this.options.
three=!1,t(),s}}zoom(e){this.options.three?this.deep?.zoomBy(e):e?this.flat.zoomBy(e):this.flat.reset()}};var At=class{film;items;current;constructor(e){this.clock=e,this.summary=h("p",{class:"summary"}),this.list=h("ol",{class:"story-list"}),this.heading=h("h2",{},
"What happens"),this.live=h("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=h("section",{class:"story","aria-label":"The motion in words"},
this.heading,this.summary,this.list,this.live)}draw(e,t,s){this.film=e[t],T(this.heading,e.length>1?`What happens to hoop ${"AB"[t]}`:"What happens"),this.summary.
replaceChildren(...e.flatMap((o,a)=>[e.length>1?h("b",{},`${"AB"[a]}: `):"",o.summary,o.status==="event_limit"||o.shortened?" (not all events are shown)":"",a+1<
e.length?h("br"):""])),this.items=this.film.story.map(o=>h("li",{},h("button",{type:"button",onclick:()=>this.clock.seek(o.t)},h("i",{class:"dot",style:`backgro\
und:${s.modes[o.mode]}`,"aria-hidden":"true"}),h("span",{class:"when"},`${x(o.t,4)} s`),h("span",{},o.text)))),this.list.replaceChildren(...this.items),this.current=
-1,this.cursor(this.clock.time)}say(e){T(this.live,e)}announce(e){this.say(Q(e.map(t=>t.summary).join(" ")))}cursor(e){let{story:t}=this.film,s=-1;for(let a=0;a<
t.length&&t[a].t<=e+1e-9;a++)s=a;if(s===this.current)return;this.items[this.current]?.classList.remove("now"),this.items[s]?.classList.add("now"),this.items[this.
current]?.removeAttribute("aria-current"),this.items[s]?.setAttribute("aria-current","step"),this.current=s;let o=this.items[s];if(o){let a=o.offsetTop-this.list.
offsetTop;(a<this.list.scrollTop||a+o.offsetHeight>this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=a-.4*this.list.clientHeight)}}},Pt=class{constructor(){
this.list=h("dl",{}),this.heading=h("h2",{},"What theory says"),this.element=h("section",{class:"theory"},this.heading,this.list)}draw(e,t=""){T(this.heading,t?
`What theory says of hoop ${t}`:"What theory says"),this.list.replaceChildren(...e.flatMap(({label:s,text:o})=>[h("dt",{},s),h("dd",{},o)]))}};var jo="hophoop-theme",Ea=["gravity_center","airborne","normal_force","friction_force"],Rt=class{constructor(e,t,s,o){this.root=e,this.colors=t,this.hosted=s,this.
changed=o,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=jt(e),this.inks={...t},this.read()}mark(){let e=this.hosted?U(jo):null;this.root.dataset.theme=this.chosen??e??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=jt(this.root),this.inks={...this.colors};for(let e of Ea)
this.inks[e]=_e(this.colors[e],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&K(jo,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};var Lt={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns back",apex:"hi\
ghest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"jam",kane_gain:"\
energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},_o=i=>i.kind==="takeoff"||i.to==="H"&&i.from!=="H"&&i.kind!=="impact";var Fe={jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"\
↺",apex:"•"},It=Object.keys(Fe);function Ho(i,e=11){let s=[...i.filter(({kind:a})=>a in Fe)].sort((a,n)=>It.indexOf(a.kind)-It.indexOf(n.kind)||a.x-n.x),o=[];
for(let{kind:a,x:n}of s){let r=It.indexOf(a)<It.indexOf("takeoff"),l=o.filter(c=>Math.abs(c.x-n)<e);l.length?l.length===1&&l[0].rare&&!o.some(c=>Math.abs(c.x-(l[0].
x+e))<e-1e-9)?l[0].mark!==Fe[a]&&o.push({mark:Fe[a],x:l[0].x+e,rare:!1,hidden:0}):l[0].hidden+=1:o.push({mark:Fe[a],x:n,rare:r,hidden:0})}return o.sort((a,n)=>a.
x-n.x).map(({mark:a,x:n})=>({mark:a,x:n}))}function Oo(i,e,t){let s=[],o=new Map,a=-1,n=(l,c,d)=>{let u=s.at(-1);u&&u.mode===l&&Math.abs(u.from+u.wide-c)<1e-6?u.
wide+=d:s.push({mode:l,from:c,wide:d})},r=()=>{o.size&&n([...o].reduce((l,c)=>c[1]>l[1]?c:l)[0],a,1),o=new Map};for(let{mode:l,from:c,to:d}of i){let[u,p]=[Math.
max(e(c),0),Math.min(e(d),t)];if(p>u)for(let m=u;m<p-1e-9;){if((Math.floor(m+1e-9)!==a||!o.size)&&(r(),a=Math.floor(m+1e-9),p-m>=1&&Math.abs(m-a)<1e-6)){let b=Math.
floor(p-m+1e-9);n(l,a,b),m=a+b;continue}let g=Math.min(p,a+1);o.set(l,(o.get(l)??0)+g-m),m=g}}return r(),s}var Ct=class{films;said;constructor(e){this.clock=e,this.window=null,this.canvas=h("canvas",{class:"timeline-canvas"}),this.tip=h("div",{class:"tip",hidden:!0}),
this.element=h("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),
this.element.addEventListener("pointerdown",t=>this.scrub(t)),this.element.addEventListener("pointermove",t=>this.hover(t)),this.element.addEventListener("point\
erleave",()=>this.tip.hidden=!0),this.pinched=_(this.element,{zoom:(t,s)=>this.zoom(1/t,s?this.timeAt(s):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let e=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=e[1]?e:de(this.window,e)}zoom(e,t){let[s,o]=this.ends(),a=1e-6*this.clock.duration,
n=Math.max((o-s)*e,a),r=(t-s)/(o-s);this.window=n<this.clock.duration?de([t-r*n,t+(1-r)*n],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[e,t]=this.ends(),{time:s,duration:o}=this.clock;if(s>=e&&s<=t)return;let a=t-e;this.window=de(s>t?[s-.1*a,s+.9*a]:[s-.5*a,s+.5*a],[0,o])}timeAt(e){let t=this.
canvas.getBoundingClientRect(),[s,o]=this.ends();return s+y((e.clientX-t.left)/t.width,0,1)*(o-s)}scrub(e){e.preventDefault(),this.element.focus({preventScroll:!0});
let t=this.clock.playing;this.clock.playing=!1;let s=o=>!this.pinched()&&this.clock.seek(this.timeAt(o));s(e),C(this.element,e,s,()=>t&&this.clock.play(!0))}hover(e){
let t=this.timeAt(e),s=this.nearest(t,8),o=s?`${k(Lt[s.kind]??s.kind)} · ${x(s.t,5)} s · ${x(s.angle*180/Math.PI,4)}°`:`${x(t,4)} s`;this.tip.textContent=o,this.
tip.hidden=!1;let a=this.canvas.getBoundingClientRect();this.tip.style.left=`${y(e.clientX-a.left,70,a.width-70)}px`}nearest(e,t){let[s,o]=this.ends(),a=t*(o-s)/
(this.canvas.getBoundingClientRect().width||1),n=null;for(let r of this.films??[])for(let l of r.events){if(l.kind==="end")continue;let c=Math.abs(l.t-e);c<=a&&
(!n||c<Math.abs(n.t-e))&&(n=l)}return n}draw(e,t,s){this.films=e;let{context:o,width:a,height:n}=L(this.canvas);this.keep();let[r,l]=this.ends(),c=w=>(w-r)/(l-r)*
a;o.clearRect(0,0,a,n);let d=15,u=(n-15)/e.length-d;e.forEach((w,f)=>{let v=d+f*(d+u);for(let{mode:S,from:M,wide:A}of Oo(w.phases,c,a)){let E=s.modes[S];o.fillStyle=
E,o.fillRect(M,v,A,u-2),this.named(o,k(s.mode_names[S]),M,A,v,u-2,E,t)}w.duration<l&&(o.fillStyle=t.line,o.fillRect(Math.max(c(w.duration),0),v,a,u-2)),this.marks(
o,w,c,v,a,t),e.length>1&&(o.fillStyle=t.soft,o.font=`600 11px ${t.font}`,o.textAlign="left",o.fillText("AB"[f],1,v-4))});let p=D(l-r,a/60);o.fillStyle=t.soft,o.
font=`10.5px ${t.font}`;let m=O(r,l,a/60);for(let w of m){let f=c(w);o.textAlign=f<14?"left":f>a-14?"right":"center",o.fillText(j(w,p)+(w===m[0]?" s":""),f,n-3)}
let g=y(c(this.clock.time),6,a-6),b=y(c(this.clock.time),1,a-1);o.fillStyle=t.ink,o.fillRect(b-1,d-4,2,n-d-9),o.beginPath(),o.moveTo(g-6,d-10),o.lineTo(g+6,d-10),
o.lineTo(b,d-1),o.fill(),this.tell(e,s)}tell(e,t){let{time:s,duration:o,playing:a}=this.clock,r=e.map((l,c)=>{let d=k(t.mode_names[l.at(s).mode]);return e.length>
1?`${"AB"[c]} ${d}`:d}).join(", ");a&&r===this.said||(this.said=r,this.element.setAttribute("aria-valuemax",o.toFixed(3)),this.element.setAttribute("aria-valuen\
ow",s.toFixed(3)),this.element.setAttribute("aria-valuetext",k("{time} seconds, {what}",{time:x(s,4),what:Q(r)})))}named(e,t,s,o,a,n,r,l){e.font=`11px ${l.font}`,
!(n<13||e.measureText(t).width+8>o)&&(e.fillStyle=bs(r),e.textAlign="center",e.textBaseline="middle",e.fillText(t,s+.5*o,a+.5*n+1),e.textBaseline="alphabetic")}marks(e,t,s,o,a,n){
e.font=`11px ${n.font}`,e.textAlign="center";let r=t.events.filter(({kind:l})=>l!=="start"&&l!=="end").map(({kind:l,t:c})=>({kind:l,x:s(c)})).filter(({x:l})=>l>=
-1&&l<=a+1);if(e.fillStyle=n.panel,r.length<a/6)for(let{x:l}of r)e.fillRect(l-.5,o,1,5);e.fillStyle=n.ink;for(let{mark:l,x:c}of Ho(r))e.fillText(l,y(c,6,a-6),o-
4)}};var Aa=1/60,Pa=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],Ra={three:"In space"},re=(i,e,t)=>h(
"button",{type:"button",title:e,"aria-label":e,onclick:t},i),$o=(i,e)=>h("span",{},h("span",{"aria-hidden":"true"},`${i} `),e),Wt=class{titled="";constructor(e,t,s,o,a){
this.clock=e,this.films=t,this.say=o,this.tell=a,this.playButton=re(W("play"),"Play (space)",()=>e.play()),this.playButton.classList.add("play"),this.speeds=h("\
select",{"aria-label":"Speed of the film",onchange:()=>{e.speed=Number(this.speeds.value)}},Re.map(n=>h("option",{value:String(n)},`${n}×`))),this.speeds.value=
"1",this.switches=new Map(Pa.map(([n,r,l])=>{let c=`${n==="three"?Ra.three:r} (${l})`;return[n,h("button",{type:"button",class:"switch",title:c,onclick:()=>s(n)},
r)]})),this.element=h("div",{class:"transport"},h("div",{class:"buttons"},re(W("start"),"To the start (Home)",()=>e.seek(0)),re(W("previous"),"Previous event (S\
hift ←)",()=>this.jump(-1)),re(W("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,re(W("on"),"One frame on (→)",()=>this.nudge(1)),re(W("n\
ext"),"Next event (Shift →)",()=>this.jump(1))),h("div",{class:"buttons jumps"},re($o("▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),re(
$o("▼","landing"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,h("div",{class:"buttons switches"},[...this.switches.values()]))}show(e){let{
clock:t,playButton:s}=this;for(let[a,n]of this.switches)n.setAttribute("aria-pressed",String(e[a]));let o=t.playing?"Pause (space)":"Play (space)";this.titled!==
o&&(this.titled=o,s.replaceChildren(W(t.playing?"pause":"play")),Ae(s,"title",o),Ae(s,"aria-label",o)),this.speeds.value!==String(t.speed)&&(this.speeds.value=String(
t.speed))}nudge(e){this.clock.playing=!1,this.clock.seek(this.clock.time+e*Aa*Math.min(this.clock.speed,1))}jump(e,t=null){this.clock.playing=!1;let s=this.films().
flatMap((c,d)=>c.events.map(u=>({event:u,lane:d}))).filter(({event:c})=>!t||(t==="impact"?c.kind===t:_o(c))).sort((c,d)=>c.event.t-d.event.t),o=this.clock.time,
a=e>0?s.find(({event:c})=>c.t>o+1e-9):s.findLast(({event:c})=>c.t<o-1e-9);if(!a&&t&&(a=s[0]),!a){t&&this.say(t==="takeoff"?"This motion has no flight.":"This mo\
tion has no landing.");return}this.clock.seek(a.event.t);let{event:n,lane:r}=a,l=this.films().length>1?`${k(`Hoop ${"AB"[r]}`)}: `:"";this.tell(`${l}${k("{what}\
 at {angle}, {time} s",{what:k(Lt[n.kind]??n.kind),angle:P(n.angle),time:x(n.t,4)})}`)}};var Be=class{constructor(e,t,s,{hosted:o=!1,panels:a=null,onmotion:n=()=>{}}={}){this.root=e,this.backend=t,this.hosted=o,this.onmotion=n,this.prepareRoot();let{
colors:r}=s;this.known=s.presets,this.address=o?new Ke(this):null,this.clock=new Ye,this.motions=new wt(t,{shown:l=>this.changed(l),settled:()=>this.story.announce(
this.films()),noted:l=>this.noted(l),travelled:async l=>this.address?.travel(l),failed:(l,c)=>this.failed(l,c)}),this.notice=new bt,this.theme=new Rt(e,r,o,()=>this.
show()),this.stage=new Et(r,()=>{this.request(),this.address?.soon()}),this.transport=new Wt(this.clock,()=>this.films(),l=>this.toggle(l),l=>this.notice.say(l),
l=>this.story.say(l)),this.timeline=new Ct(this.clock),this.story=new At(this.clock),this.theory=new Pt,this.plots=new vt(this.clock,r),this.phase=new yt(t,this.
clock,r),this.map=new ft(t,s,{take:l=>{this.clock.time=0,this.motions.change(l,!0)},say:l=>this.story.say(l),changed:()=>this.address?.soon()}),this.controls=new Xe(
s.controls,(l,c)=>this.motions.change(l,c)),this.share=new kt(this),this.singleKeys=new pt(o),this.help=ro(s.version,r,this.singleKeys.element),this.hoops=new ut(
l=>this.motions.choose(l)),this.header=new dt(s.presets,this.share.menu,{take:l=>this.take(l),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.
motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.layOut(a),this.extras=new ct(this),this.requested=!1,this.surrounding=!1,this.
taken=null,this.afterFrame=null,this.asked=null,this.later=G(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=this.frame.bind(this),this.clock.
listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=ho(this,o),this.sizes=new ResizeObserver(()=>this.show())}prepareRoot(){this.
root.classList.add("hophoop"),!this.hosted&&(this.root.classList.add("embedded"),this.root.dataset.lmSuppressShortcuts="true",this.root.dataset.pSuppressShortcuts=
"true")}layOut(e){let{root:t,notice:s}=this,o=d=>!e||e.includes(d),a=h("aside",{class:"side","aria-label":"Parameters"},this.hoops.element,s.message,this.controls.
element),n=h("div",{class:"player"},this.stage.element,this.timeline.element,this.transport.element);this.sticky=this.hosted?zo(n,()=>this.request()):null;let r=h(
"a",{class:"skip button",href:"#hh-player"},"Skip to the player");r.onclick=d=>{d.preventDefault(),this.timeline.element.focus()};let l=h("div",{class:"middle"},
this.sticky?.edge,n,h("div",{class:"words"},this.story.element,o("theory")&&this.theory.element),o("map")&&this.map.element),c=h("div",{class:"why"},o("plots")&&
this.plots.element,o("plots")&&this.phase.element);t.replaceChildren(h("div",{class:"page"},this.hosted&&r,this.header.element,h("div",{class:"columns"},o("cont\
rols")&&a,l,c)),s.toast,this.share.dialog,this.help),t.classList.toggle("no-controls",!o("controls"))}async open(e,t={}){await this.motions.load(e),this.clock.duration=
Math.max(...this.films().map(s=>s.duration)),this.restore(t),this.begin()}begin(){this.show(),this.motions.note(),this.sizes.observe(this.stage.element),this.root.
dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.map.close(),this.theme.close(),this.address?.close(),this.sticky?.
close(),this.sizes.disconnect(),this.deaf()}film(e=this.motions.active){return this.motions.film(e)}films(){return this.motions.films()}changed(e=null){this.notice.
clear(),this.show(e)}failed(e,t=[]){this.controls.refuse(t,e.message)||(this.notice.fail(e),this.controls.restore()),this.showPreset()}noted(e){this.header.show(
this.motions.history,this.motions.lanes.length>1),this.address?.write(e),this.onmotion(this.film().query)}link(){let{clock:e,stage:t,map:s}=this;return this.motions.
link(Ds({time:e.time,options:t.options,zoom:t.flat.zoom,map:s.shown()}))}restore({time:e,options:t,zoom:s,map:o}){if(t){let{three:a,...n}=t;Object.assign(this.stage.
options,n),a&&this.toggle("three")}s&&(this.stage.flat.zoom=s),o&&this.map.restore(o),e&&this.clock.seek(e)}showPreset(){let{query:e}=this.film(),t=this.known.find(
s=>s.query===e);this.header.presets.value=t?.key??"",T(this.hoops.text,t?.text??"")}async take(e){this.taken=e;try{let t=await this.backend.call("film",{query:e.
query});if(this.taken!==e)return;this.clock.time=0,this.motions.replace(t),this.story.announce(this.films())}catch(t){this.failed(t)}}travel(e){return this.motions.
travel(e)}show(e=null){let{motions:t,clock:s}=this,o=this.films();if(!o.length)return;let a=o.length>1;this.theme.read(),s.duration=Math.max(...o.map(n=>n.duration)),
s.time=Math.min(s.time,s.duration),this.root.classList.toggle("two",a),this.header.show(t.history,a),this.hoops.show(o.length,t.active),this.drawStage(),this.controls.
show(this.film(),this.motions.waiting()),this.showPreset(),e!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-e),0)),this.
surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let e=this.films(),
{active:t}=this.motions,{look:s,colors:o}=this.theme;this.plots.draw(e,t,s),this.phase.draw(e,t,s),this.story.draw(e,t,o),this.drawTime(),this.map.mark(this.film(),
s),this.stage.describe(e),this.extras.changed(),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{
time:e}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(e),this.phase.cursor(e),this.story.cursor(
e),this.transport.show(this.stage.options))}request(){this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(e){this.requested=!1,this.motions.
lanes.length&&(this.clock.tick(e),this.drawStage(),this.drawTime(),this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){
let{scenario:e}=this.film();this.asked?.abort(),this.asked=new AbortController;let{signal:t}=this.asked;try{let s=await this.backend.call("theory",{scenario:e},
t);this.theory.draw(s.header.thresholds,this.motions.name()),await this.phase.fetch(e,t)}catch(s){let{name:o,message:a}=s;o!=="AbortError"&&this.theory.draw([{label:"\
–",text:a}])}}toggle(e){let{options:t}=this.stage;if(e!=="three")t[e]=!t[e];else try{this.stage.turn(()=>this.drawStage())}catch(s){this.notice.say(s.message)}
this.transport.show(t),this.address?.soon(),this.request()}};async function La(i){let e=new URL("./",document.baseURI.split(/[?#]/)[0]),t=new Ge(e),s;try{s=(await t.call("setup",{})).header}catch(r){i.textContent=r.message;
return}let o=new Be(i,t,s,{hosted:!0});Object.assign(globalThis,{hophoopLab:o});let a=new URLSearchParams(location.hash.slice(1)).get("with"),n=Ns(location.hash);
try{await o.open([location.search.slice(1),...a===null?[]:[a]],n)}catch(r){history.replaceState(null,"",e),await o.open([""]),o.notice.fail(r)}}function Ia({model:i,
el:e}){let t=document.createElement("div");e.append(t);let s=new Ve(i),o=new Be(t,s,i.get("setup"),{panels:i.get("panels"),onmotion:n=>{i.get("query")!==n&&(i.set(
"query",n),i.save_changes())}});o.motions.set([ge(i.get("film"))]),o.begin();let a=()=>o.motions.replace(ge(i.get("film")));return i.on("change:film",a),()=>{i.
off("change:film",a),s.close(),o.close()}}var Uo=document.getElementById("hophoop-lab");Uo&&La(Uo);var lc={render:Ia};export{lc as default};
