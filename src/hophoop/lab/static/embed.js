/* Built from web/site/embed.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
var $=function(a,g){let i=a,u=j[g],e=null,t=0,l=null,y=[],x={},p=function(o,f){t=i*4+17,e=(function(n){let c=new Array(n);for(let s=0;s<n;s+=1){c[s]=new Array(n);
for(let w=0;w<n;w+=1)c[s][w]=null}return c})(t),d(0,0),d(t-7,0),d(0,t-7),k(),P(),I(o,f),i>=7&&D(o),l==null&&(l=nt(i,u,y)),R(l,f)},d=function(o,f){for(let n=-1;n<=
7;n+=1)if(!(o+n<=-1||t<=o+n))for(let c=-1;c<=7;c+=1)f+c<=-1||t<=f+c||(0<=n&&n<=6&&(c==0||c==6)||0<=c&&c<=6&&(n==0||n==6)||2<=n&&n<=4&&2<=c&&c<=4?e[o+n][f+c]=!0:
e[o+n][f+c]=!1)},_=function(){let o=0,f=0;for(let n=0;n<8;n+=1){p(!0,n);let c=v.getLostPoint(x);(n==0||o>c)&&(o=c,f=n)}return f},P=function(){for(let o=8;o<t-8;o+=
1)e[o][6]==null&&(e[o][6]=o%2==0);for(let o=8;o<t-8;o+=1)e[6][o]==null&&(e[6][o]=o%2==0)},k=function(){let o=v.getPatternPosition(i);for(let f=0;f<o.length;f+=1)
for(let n=0;n<o.length;n+=1){let c=o[f],s=o[n];if(e[c][s]==null)for(let w=-2;w<=2;w+=1)for(let b=-2;b<=2;b+=1)w==-2||w==2||b==-2||b==2||w==0&&b==0?e[c+w][s+b]=!0:
e[c+w][s+b]=!1}},D=function(o){let f=v.getBCHTypeNumber(i);for(let n=0;n<18;n+=1){let c=!o&&(f>>n&1)==1;e[Math.floor(n/3)][n%3+t-8-3]=c}for(let n=0;n<18;n+=1){let c=!o&&
(f>>n&1)==1;e[n%3+t-8-3][Math.floor(n/3)]=c}},I=function(o,f){let n=u<<3|f,c=v.getBCHTypeInfo(n);for(let s=0;s<15;s+=1){let w=!o&&(c>>s&1)==1;s<6?e[s][8]=w:s<8?
e[s+1][8]=w:e[t-15+s][8]=w}for(let s=0;s<15;s+=1){let w=!o&&(c>>s&1)==1;s<8?e[8][t-s-1]=w:s<9?e[8][15-s-1+1]=w:e[8][15-s-1]=w}e[t-8][8]=!o},R=function(o,f){let n=-1,
c=t-1,s=7,w=0,b=v.getMaskFunction(f);for(let B=t-1;B>0;B-=2)for(B==6&&(B-=1);;){for(let m=0;m<2;m+=1)if(e[c][B-m]==null){let C=!1;w<o.length&&(C=(o[w]>>>s&1)==1),
b(c,B-m)&&(C=!C),e[c][B-m]=C,s-=1,s==-1&&(w+=1,s=7)}if(c+=n,c<0||t<=c){c-=n,n=-n;break}}},et=function(o,f){let n=0,c=0,s=0,w=new Array(f.length),b=new Array(f.length);
for(let A=0;A<f.length;A+=1){let M=f[A].dataCount,E=f[A].totalCount-M;c=Math.max(c,M),s=Math.max(s,E),w[A]=new Array(M);for(let N=0;N<w[A].length;N+=1)w[A][N]=255&
o.getBuffer()[N+n];n+=M;let K=v.getErrorCorrectPolynomial(E),F=S(w[A],K.getLength()-1).mod(K);b[A]=new Array(K.getLength()-1);for(let N=0;N<b[A].length;N+=1){let Y=N+
F.getLength()-b[A].length;b[A][N]=Y>=0?F.getAt(Y):0}}let B=0;for(let A=0;A<f.length;A+=1)B+=f[A].totalCount;let m=new Array(B),C=0;for(let A=0;A<c;A+=1)for(let M=0;M<
f.length;M+=1)A<w[M].length&&(m[C]=w[M][A],C+=1);for(let A=0;A<s;A+=1)for(let M=0;M<f.length;M+=1)A<b[M].length&&(m[C]=b[M][A],C+=1);return m},nt=function(o,f,n){
let c=q.getRSBlocks(o,f),s=G();for(let b=0;b<n.length;b+=1){let B=n[b];s.put(B.getMode(),4),s.put(B.getLength(),v.getLengthInBits(B.getMode(),o)),B.write(s)}let w=0;
for(let b=0;b<c.length;b+=1)w+=c[b].dataCount;if(s.getLengthInBits()>w*8)throw"code length overflow. ("+s.getLengthInBits()+">"+w*8+")";for(s.getLengthInBits()+
4<=w*8&&s.put(0,4);s.getLengthInBits()%8!=0;)s.putBit(!1);for(;!(s.getLengthInBits()>=w*8||(s.put(236,8),s.getLengthInBits()>=w*8));)s.put(17,8);return et(s,c)};
x.addData=function(o,f){f=f||"Byte";let n=null;switch(f){case"Numeric":n=rt(o);break;case"Alphanumeric":n=it(o);break;case"Byte":n=st(o);break;case"Kanji":n=ct(
o);break;default:throw"mode:"+f}y.push(n),l=null},x.isDark=function(o,f){if(o<0||t<=o||f<0||t<=f)throw o+","+f;return e[o][f]},x.getModuleCount=function(){return t},
x.make=function(){if(i<1){let o=1;for(;o<40;o++){let f=q.getRSBlocks(o,u),n=G();for(let s=0;s<y.length;s++){let w=y[s];n.put(w.getMode(),4),n.put(w.getLength(),
v.getLengthInBits(w.getMode(),o)),w.write(n)}let c=0;for(let s=0;s<f.length;s++)c+=f[s].dataCount;if(n.getLengthInBits()<=c*8)break}i=o}p(!1,_())},x.createTableTag=
function(o,f){o=o||2,f=typeof f>"u"?o*4:f;let n="";n+='<table style="',n+=" border-width: 0px; border-style: none;",n+=" border-collapse: collapse;",n+=" paddin\
g: 0px; margin: "+f+"px;",n+='">',n+="<tbody>";for(let c=0;c<x.getModuleCount();c+=1){n+="<tr>";for(let s=0;s<x.getModuleCount();s+=1)n+='<td style="',n+=" bord\
er-width: 0px; border-style: none;",n+=" border-collapse: collapse;",n+=" padding: 0px; margin: 0px;",n+=" width: "+o+"px;",n+=" height: "+o+"px;",n+=" backgrou\
nd-color: ",n+=x.isDark(c,s)?"#000000":"#ffffff",n+=";",n+='"/>';n+="</tr>"}return n+="</tbody>",n+="</table>",n},x.createSvgTag=function(o,f,n,c){let s={};typeof arguments[0]==
"object"&&(s=arguments[0],o=s.cellSize,f=s.margin,n=s.alt,c=s.title),o=o||2,f=typeof f>"u"?o*4:f,n=typeof n=="string"?{text:n}:n||{},n.text=n.text||null,n.id=n.
text?n.id||"qrcode-description":null,c=typeof c=="string"?{text:c}:c||{},c.text=c.text||null,c.id=c.text?c.id||"qrcode-title":null;let w=x.getModuleCount()*o+f*
2,b,B,m,C,A="",M;for(M="l"+o+",0 0,"+o+" -"+o+",0 0,-"+o+"z ",A+='<svg version="1.1" xmlns="http://www.w3.org/2000/svg"',A+=s.scalable?"":' width="'+w+'px" heig\
ht="'+w+'px"',A+=' viewBox="0 0 '+w+" "+w+'" ',A+=' preserveAspectRatio="xMinYMin meet"',A+=c.text||n.text?' role="img" aria-labelledby="'+H([c.id,n.id].join(" ").
trim())+'"':"",A+=">",A+=c.text?'<title id="'+H(c.id)+'">'+H(c.text)+"</title>":"",A+=n.text?'<description id="'+H(n.id)+'">'+H(n.text)+"</description>":"",A+='\
<rect width="100%" height="100%" fill="white" cx="0" cy="0"/>',A+='<path d="',m=0;m<x.getModuleCount();m+=1)for(C=m*o+f,b=0;b<x.getModuleCount();b+=1)x.isDark(m,
b)&&(B=b*o+f,A+="M"+B+","+C+M);return A+='" stroke="transparent" fill="black"/>',A+="</svg>",A},x.createDataURL=function(o,f){o=o||2,f=typeof f>"u"?o*4:f;let n=x.
getModuleCount()*o+f*2,c=f,s=n-f;return at(n,n,function(w,b){if(c<=w&&w<s&&c<=b&&b<s){let B=Math.floor((w-c)/o),m=Math.floor((b-c)/o);return x.isDark(m,B)?0:1}else
return 1})},x.createImgTag=function(o,f,n){o=o||2,f=typeof f>"u"?o*4:f;let c=x.getModuleCount()*o+f*2,s="";return s+="<img",s+=' src="',s+=x.createDataURL(o,f),
s+='"',s+=' width="',s+=c,s+='"',s+=' height="',s+=c,s+='"',n&&(s+=' alt="',s+=H(n),s+='"'),s+="/>",s};let H=function(o){let f="";for(let n=0;n<o.length;n+=1){let c=o.
charAt(n);switch(c){case"<":f+="&lt;";break;case">":f+="&gt;";break;case"&":f+="&amp;";break;case'"':f+="&quot;";break;default:f+=c;break}}return f},ot=function(o){
o=typeof o>"u"?2:o;let n=x.getModuleCount()*1+o*2,c=o,s=n-o,w,b,B,m,C,A={"██":"█","█ ":"▀"," █":"▄","  ":" "},M={"██":"▀","█ ":"▀"," █":"\
 ","  ":" "},E="";for(w=0;w<n;w+=2){for(B=Math.floor((w-c)/1),m=Math.floor((w+1-c)/1),b=0;b<n;b+=1)C="█",c<=b&&b<s&&c<=w&&w<s&&x.isDark(B,Math.floor((b-c)/1))&&
(C=" "),c<=b&&b<s&&c<=w+1&&w+1<s&&x.isDark(m,Math.floor((b-c)/1))?C+=" ":C+="█",E+=o<1&&w+1>=s?M[C]:A[C];E+=`
`}return n%2&&o>0?E.substring(0,E.length-n-1)+Array(n+1).join("▀"):E.substring(0,E.length-1)};return x.createASCII=function(o,f){if(o=o||1,o<2)return ot(f);o-=
1,f=typeof f>"u"?o*2:f;let n=x.getModuleCount()*o+f*2,c=f,s=n-f,w,b,B,m,C=Array(o+1).join("██"),A=Array(o+1).join("  "),M="",E="";for(w=0;w<n;w+=1){for(B=Math.
floor((w-c)/o),E="",b=0;b<n;b+=1)m=1,c<=b&&b<s&&c<=w&&w<s&&x.isDark(B,Math.floor((b-c)/o))&&(m=0),E+=m?C:A;for(B=0;B<o;B+=1)M+=E+`
`}return M.substring(0,M.length-1)},x.renderTo2dContext=function(o,f){f=f||2;let n=x.getModuleCount();for(let c=0;c<n;c++)for(let s=0;s<n;s++)o.fillStyle=x.isDark(
c,s)?"black":"white",o.fillRect(s*f,c*f,f,f)},x};$.stringToBytes=function(a){let g=[];for(let h=0;h<a.length;h+=1){let r=a.charCodeAt(h);g.push(r&255)}return g};
$.createStringToBytes=function(a,g){let h=(function(){let i=ut(a),u=function(){let l=i.read();if(l==-1)throw"eof";return l},e=0,t={};for(;;){let l=i.read();if(l==
-1)break;let y=u(),x=u(),p=u(),d=String.fromCharCode(l<<8|y),_=x<<8|p;t[d]=_,e+=1}if(e!=g)throw e+" != "+g;return t})(),r=63;return function(i){let u=[];for(let e=0;e<
i.length;e+=1){let t=i.charCodeAt(e);if(t<128)u.push(t);else{let l=h[i.charAt(e)];typeof l=="number"?(l&255)==l?u.push(l):(u.push(l>>>8),u.push(l&255)):u.push(r)}}
return u}};var T={MODE_NUMBER:1,MODE_ALPHA_NUM:2,MODE_8BIT_BYTE:4,MODE_KANJI:8},j={L:1,M:0,Q:3,H:2},O={PATTERN000:0,PATTERN001:1,PATTERN010:2,PATTERN011:3,PATTERN100:4,
PATTERN101:5,PATTERN110:6,PATTERN111:7},v=(function(){let a=[[],[6,18],[6,22],[6,26],[6,30],[6,34],[6,22,38],[6,24,42],[6,26,46],[6,28,50],[6,30,54],[6,32,58],[
6,34,62],[6,26,46,66],[6,26,48,70],[6,26,50,74],[6,30,54,78],[6,30,56,82],[6,30,58,86],[6,34,62,90],[6,28,50,72,94],[6,26,50,74,98],[6,30,54,78,102],[6,28,54,80,
106],[6,32,58,84,110],[6,30,58,86,114],[6,34,62,90,118],[6,26,50,74,98,122],[6,30,54,78,102,126],[6,26,52,78,104,130],[6,30,56,82,108,134],[6,34,60,86,112,138],
[6,30,58,86,114,142],[6,34,62,90,118,146],[6,30,54,78,102,126,150],[6,24,50,76,102,128,154],[6,28,54,80,106,132,158],[6,32,58,84,110,136,162],[6,26,54,82,110,138,
166],[6,30,58,86,114,142,170]],g=1335,h=7973,r=21522,i={},u=function(e){let t=0;for(;e!=0;)t+=1,e>>>=1;return t};return i.getBCHTypeInfo=function(e){let t=e<<10;
for(;u(t)-u(g)>=0;)t^=g<<u(t)-u(g);return(e<<10|t)^r},i.getBCHTypeNumber=function(e){let t=e<<12;for(;u(t)-u(h)>=0;)t^=h<<u(t)-u(h);return e<<12|t},i.getPatternPosition=
function(e){return a[e-1]},i.getMaskFunction=function(e){switch(e){case O.PATTERN000:return function(t,l){return(t+l)%2==0};case O.PATTERN001:return function(t,l){
return t%2==0};case O.PATTERN010:return function(t,l){return l%3==0};case O.PATTERN011:return function(t,l){return(t+l)%3==0};case O.PATTERN100:return function(t,l){
return(Math.floor(t/2)+Math.floor(l/3))%2==0};case O.PATTERN101:return function(t,l){return t*l%2+t*l%3==0};case O.PATTERN110:return function(t,l){return(t*l%2+
t*l%3)%2==0};case O.PATTERN111:return function(t,l){return(t*l%3+(t+l)%2)%2==0};default:throw"bad maskPattern:"+e}},i.getErrorCorrectPolynomial=function(e){let t=S(
[1],0);for(let l=0;l<e;l+=1)t=t.multiply(S([1,U.gexp(l)],0));return t},i.getLengthInBits=function(e,t){if(1<=t&&t<10)switch(e){case T.MODE_NUMBER:return 10;case T.
MODE_ALPHA_NUM:return 9;case T.MODE_8BIT_BYTE:return 8;case T.MODE_KANJI:return 8;default:throw"mode:"+e}else if(t<27)switch(e){case T.MODE_NUMBER:return 12;case T.
MODE_ALPHA_NUM:return 11;case T.MODE_8BIT_BYTE:return 16;case T.MODE_KANJI:return 10;default:throw"mode:"+e}else if(t<41)switch(e){case T.MODE_NUMBER:return 14;case T.
MODE_ALPHA_NUM:return 13;case T.MODE_8BIT_BYTE:return 16;case T.MODE_KANJI:return 12;default:throw"mode:"+e}else throw"type:"+t},i.getLostPoint=function(e){let t=e.
getModuleCount(),l=0;for(let p=0;p<t;p+=1)for(let d=0;d<t;d+=1){let _=0,P=e.isDark(p,d);for(let k=-1;k<=1;k+=1)if(!(p+k<0||t<=p+k))for(let D=-1;D<=1;D+=1)d+D<0||
t<=d+D||k==0&&D==0||P==e.isDark(p+k,d+D)&&(_+=1);_>5&&(l+=3+_-5)}for(let p=0;p<t-1;p+=1)for(let d=0;d<t-1;d+=1){let _=0;e.isDark(p,d)&&(_+=1),e.isDark(p+1,d)&&(_+=
1),e.isDark(p,d+1)&&(_+=1),e.isDark(p+1,d+1)&&(_+=1),(_==0||_==4)&&(l+=3)}for(let p=0;p<t;p+=1)for(let d=0;d<t-6;d+=1)e.isDark(p,d)&&!e.isDark(p,d+1)&&e.isDark(
p,d+2)&&e.isDark(p,d+3)&&e.isDark(p,d+4)&&!e.isDark(p,d+5)&&e.isDark(p,d+6)&&(l+=40);for(let p=0;p<t;p+=1)for(let d=0;d<t-6;d+=1)e.isDark(d,p)&&!e.isDark(d+1,p)&&
e.isDark(d+2,p)&&e.isDark(d+3,p)&&e.isDark(d+4,p)&&!e.isDark(d+5,p)&&e.isDark(d+6,p)&&(l+=40);let y=0;for(let p=0;p<t;p+=1)for(let d=0;d<t;d+=1)e.isDark(d,p)&&(y+=
1);let x=Math.abs(100*y/t/t-50)/5;return l+=x*10,l},i})(),U=(function(){let a=new Array(256),g=new Array(256);for(let r=0;r<8;r+=1)a[r]=1<<r;for(let r=8;r<256;r+=
1)a[r]=a[r-4]^a[r-5]^a[r-6]^a[r-8];for(let r=0;r<255;r+=1)g[a[r]]=r;let h={};return h.glog=function(r){if(r<1)throw"glog("+r+")";return g[r]},h.gexp=function(r){
for(;r<0;)r+=255;for(;r>=256;)r-=255;return a[r]},h})(),S=function(a,g){if(typeof a.length>"u")throw a.length+"/"+g;let h=(function(){let i=0;for(;i<a.length&&a[i]==
0;)i+=1;let u=new Array(a.length-i+g);for(let e=0;e<a.length-i;e+=1)u[e]=a[e+i];return u})(),r={};return r.getAt=function(i){return h[i]},r.getLength=function(){
return h.length},r.multiply=function(i){let u=new Array(r.getLength()+i.getLength()-1);for(let e=0;e<r.getLength();e+=1)for(let t=0;t<i.getLength();t+=1)u[e+t]^=
U.gexp(U.glog(r.getAt(e))+U.glog(i.getAt(t)));return S(u,0)},r.mod=function(i){if(r.getLength()-i.getLength()<0)return r;let u=U.glog(r.getAt(0))-U.glog(i.getAt(
0)),e=new Array(r.getLength());for(let t=0;t<r.getLength();t+=1)e[t]=r.getAt(t);for(let t=0;t<i.getLength();t+=1)e[t]^=U.gexp(U.glog(i.getAt(t))+u);return S(e,0).
mod(i)},r},q=(function(){let a=[[1,26,19],[1,26,16],[1,26,13],[1,26,9],[1,44,34],[1,44,28],[1,44,22],[1,44,16],[1,70,55],[1,70,44],[2,35,17],[2,35,13],[1,100,80],
[2,50,32],[2,50,24],[4,25,9],[1,134,108],[2,67,43],[2,33,15,2,34,16],[2,33,11,2,34,12],[2,86,68],[4,43,27],[4,43,19],[4,43,15],[2,98,78],[4,49,31],[2,32,14,4,33,
15],[4,39,13,1,40,14],[2,121,97],[2,60,38,2,61,39],[4,40,18,2,41,19],[4,40,14,2,41,15],[2,146,116],[3,58,36,2,59,37],[4,36,16,4,37,17],[4,36,12,4,37,13],[2,86,68,
2,87,69],[4,69,43,1,70,44],[6,43,19,2,44,20],[6,43,15,2,44,16],[4,101,81],[1,80,50,4,81,51],[4,50,22,4,51,23],[3,36,12,8,37,13],[2,116,92,2,117,93],[6,58,36,2,59,
37],[4,46,20,6,47,21],[7,42,14,4,43,15],[4,133,107],[8,59,37,1,60,38],[8,44,20,4,45,21],[12,33,11,4,34,12],[3,145,115,1,146,116],[4,64,40,5,65,41],[11,36,16,5,37,
17],[11,36,12,5,37,13],[5,109,87,1,110,88],[5,65,41,5,66,42],[5,54,24,7,55,25],[11,36,12,7,37,13],[5,122,98,1,123,99],[7,73,45,3,74,46],[15,43,19,2,44,20],[3,45,
15,13,46,16],[1,135,107,5,136,108],[10,74,46,1,75,47],[1,50,22,15,51,23],[2,42,14,17,43,15],[5,150,120,1,151,121],[9,69,43,4,70,44],[17,50,22,1,51,23],[2,42,14,
19,43,15],[3,141,113,4,142,114],[3,70,44,11,71,45],[17,47,21,4,48,22],[9,39,13,16,40,14],[3,135,107,5,136,108],[3,67,41,13,68,42],[15,54,24,5,55,25],[15,43,15,10,
44,16],[4,144,116,4,145,117],[17,68,42],[17,50,22,6,51,23],[19,46,16,6,47,17],[2,139,111,7,140,112],[17,74,46],[7,54,24,16,55,25],[34,37,13],[4,151,121,5,152,122],
[4,75,47,14,76,48],[11,54,24,14,55,25],[16,45,15,14,46,16],[6,147,117,4,148,118],[6,73,45,14,74,46],[11,54,24,16,55,25],[30,46,16,2,47,17],[8,132,106,4,133,107],
[8,75,47,13,76,48],[7,54,24,22,55,25],[22,45,15,13,46,16],[10,142,114,2,143,115],[19,74,46,4,75,47],[28,50,22,6,51,23],[33,46,16,4,47,17],[8,152,122,4,153,123],
[22,73,45,3,74,46],[8,53,23,26,54,24],[12,45,15,28,46,16],[3,147,117,10,148,118],[3,73,45,23,74,46],[4,54,24,31,55,25],[11,45,15,31,46,16],[7,146,116,7,147,117],
[21,73,45,7,74,46],[1,53,23,37,54,24],[19,45,15,26,46,16],[5,145,115,10,146,116],[19,75,47,10,76,48],[15,54,24,25,55,25],[23,45,15,25,46,16],[13,145,115,3,146,116],
[2,74,46,29,75,47],[42,54,24,1,55,25],[23,45,15,28,46,16],[17,145,115],[10,74,46,23,75,47],[10,54,24,35,55,25],[19,45,15,35,46,16],[17,145,115,1,146,116],[14,74,
46,21,75,47],[29,54,24,19,55,25],[11,45,15,46,46,16],[13,145,115,6,146,116],[14,74,46,23,75,47],[44,54,24,7,55,25],[59,46,16,1,47,17],[12,151,121,7,152,122],[12,
75,47,26,76,48],[39,54,24,14,55,25],[22,45,15,41,46,16],[6,151,121,14,152,122],[6,75,47,34,76,48],[46,54,24,10,55,25],[2,45,15,64,46,16],[17,152,122,4,153,123],
[29,74,46,14,75,47],[49,54,24,10,55,25],[24,45,15,46,46,16],[4,152,122,18,153,123],[13,74,46,32,75,47],[48,54,24,14,55,25],[42,45,15,32,46,16],[20,147,117,4,148,
118],[40,75,47,7,76,48],[43,54,24,22,55,25],[10,45,15,67,46,16],[19,148,118,6,149,119],[18,75,47,31,76,48],[34,54,24,34,55,25],[20,45,15,61,46,16]],g=function(i,u){
let e={};return e.totalCount=i,e.dataCount=u,e},h={},r=function(i,u){switch(u){case j.L:return a[(i-1)*4+0];case j.M:return a[(i-1)*4+1];case j.Q:return a[(i-1)*
4+2];case j.H:return a[(i-1)*4+3];default:return}};return h.getRSBlocks=function(i,u){let e=r(i,u);if(typeof e>"u")throw"bad rs block @ typeNumber:"+i+"/errorCo\
rrectionLevel:"+u;let t=e.length/3,l=[];for(let y=0;y<t;y+=1){let x=e[y*3+0],p=e[y*3+1],d=e[y*3+2];for(let _=0;_<x;_+=1)l.push(g(p,d))}return l},h})(),G=function(){
let a=[],g=0,h={};return h.getBuffer=function(){return a},h.getAt=function(r){let i=Math.floor(r/8);return(a[i]>>>7-r%8&1)==1},h.put=function(r,i){for(let u=0;u<
i;u+=1)h.putBit((r>>>i-u-1&1)==1)},h.getLengthInBits=function(){return g},h.putBit=function(r){let i=Math.floor(g/8);a.length<=i&&a.push(0),r&&(a[i]|=128>>>g%8),
g+=1},h},rt=function(a){let g=T.MODE_NUMBER,h=a,r={};r.getMode=function(){return g},r.getLength=function(e){return h.length},r.write=function(e){let t=h,l=0;for(;l+
2<t.length;)e.put(i(t.substring(l,l+3)),10),l+=3;l<t.length&&(t.length-l==1?e.put(i(t.substring(l,l+1)),4):t.length-l==2&&e.put(i(t.substring(l,l+2)),7))};let i=function(e){
let t=0;for(let l=0;l<e.length;l+=1)t=t*10+u(e.charAt(l));return t},u=function(e){if("0"<=e&&e<="9")return e.charCodeAt(0)-48;throw"illegal char :"+e};return r},
it=function(a){let g=T.MODE_ALPHA_NUM,h=a,r={};r.getMode=function(){return g},r.getLength=function(u){return h.length},r.write=function(u){let e=h,t=0;for(;t+1<
e.length;)u.put(i(e.charAt(t))*45+i(e.charAt(t+1)),11),t+=2;t<e.length&&u.put(i(e.charAt(t)),6)};let i=function(u){if("0"<=u&&u<="9")return u.charCodeAt(0)-48;if("\
A"<=u&&u<="Z")return u.charCodeAt(0)-65+10;switch(u){case" ":return 36;case"$":return 37;case"%":return 38;case"*":return 39;case"+":return 40;case"-":return 41;case"\
.":return 42;case"/":return 43;case":":return 44;default:throw"illegal char :"+u}};return r},st=function(a){let g=T.MODE_8BIT_BYTE,h=a,r=$.stringToBytes(a),i={};
return i.getMode=function(){return g},i.getLength=function(u){return r.length},i.write=function(u){for(let e=0;e<r.length;e+=1)u.put(r[e],8)},i},ct=function(a){
let g=T.MODE_KANJI,h=a,r=$.stringToBytes;(function(e,t){let l=r(e);if(l.length!=2||(l[0]<<8|l[1])!=t)throw"sjis not supported."})("友",38726);let i=r(a),u={};return u.
getMode=function(){return g},u.getLength=function(e){return~~(i.length/2)},u.write=function(e){let t=i,l=0;for(;l+1<t.length;){let y=(255&t[l])<<8|255&t[l+1];if(33088<=
y&&y<=40956)y-=33088;else if(57408<=y&&y<=60351)y-=49472;else throw"illegal char at "+(l+1)+"/"+y;y=(y>>>8&255)*192+(y&255),e.put(y,13),l+=2}if(l<t.length)throw"\
illegal char at "+(l+1)},u},J=function(){let a=[],g={};return g.writeByte=function(h){a.push(h&255)},g.writeShort=function(h){g.writeByte(h),g.writeByte(h>>>8)},
g.writeBytes=function(h,r,i){r=r||0,i=i||h.length;for(let u=0;u<i;u+=1)g.writeByte(h[u+r])},g.writeString=function(h){for(let r=0;r<h.length;r+=1)g.writeByte(h.
charCodeAt(r))},g.toByteArray=function(){return a},g.toString=function(){let h="";h+="[";for(let r=0;r<a.length;r+=1)r>0&&(h+=","),h+=a[r];return h+="]",h},g},ft=function(){
let a=0,g=0,h=0,r="",i={},u=function(t){r+=String.fromCharCode(e(t&63))},e=function(t){if(t<0)throw"n:"+t;if(t<26)return 65+t;if(t<52)return 97+(t-26);if(t<62)return 48+
(t-52);if(t==62)return 43;if(t==63)return 47;throw"n:"+t};return i.writeByte=function(t){for(a=a<<8|t&255,g+=8,h+=1;g>=6;)u(a>>>g-6),g-=6},i.flush=function(){if(g>
0&&(u(a<<6-g),a=0,g=0),h%3!=0){let t=3-h%3;for(let l=0;l<t;l+=1)r+="="}},i.toString=function(){return r},i},ut=function(a){let g=a,h=0,r=0,i=0,u={};u.read=function(){
for(;i<8;){if(h>=g.length){if(i==0)return-1;throw"unexpected end of file./"+i}let l=g.charAt(h);if(h+=1,l=="=")return i=0,-1;if(l.match(/^\s$/))continue;r=r<<6|
e(l.charCodeAt(0)),i+=6}let t=r>>>i-8&255;return i-=8,t};let e=function(t){if(65<=t&&t<=90)return t-65;if(97<=t&&t<=122)return t-97+26;if(48<=t&&t<=57)return t-
48+52;if(t==43)return 62;if(t==47)return 63;throw"c:"+t};return u},lt=function(a,g){let h=a,r=g,i=new Array(a*g),u={};u.setPixel=function(y,x,p){i[x*h+y]=p},u.write=
function(y){y.writeString("GIF87a"),y.writeShort(h),y.writeShort(r),y.writeByte(128),y.writeByte(0),y.writeByte(0),y.writeByte(0),y.writeByte(0),y.writeByte(0),
y.writeByte(255),y.writeByte(255),y.writeByte(255),y.writeString(","),y.writeShort(0),y.writeShort(0),y.writeShort(h),y.writeShort(r),y.writeByte(0);let x=2,p=t(
x);y.writeByte(x);let d=0;for(;p.length-d>255;)y.writeByte(255),y.writeBytes(p,d,255),d+=255;y.writeByte(p.length-d),y.writeBytes(p,d,p.length-d),y.writeByte(0),
y.writeString(";")};let e=function(y){let x=y,p=0,d=0,_={};return _.write=function(P,k){if(P>>>k)throw"length over";for(;p+k>=8;)x.writeByte(255&(P<<p|d)),k-=8-
p,P>>>=8-p,d=0,p=0;d=P<<p|d,p=p+k},_.flush=function(){p>0&&x.writeByte(d)},_},t=function(y){let x=1<<y,p=(1<<y)+1,d=y+1,_=l();for(let R=0;R<x;R+=1)_.add(String.
fromCharCode(R));_.add(String.fromCharCode(x)),_.add(String.fromCharCode(p));let P=J(),k=e(P);k.write(x,d);let D=0,I=String.fromCharCode(i[D]);for(D+=1;D<i.length;){
let R=String.fromCharCode(i[D]);D+=1,_.contains(I+R)?I=I+R:(k.write(_.indexOf(I),d),_.size()<4095&&(_.size()==1<<d&&(d+=1),_.add(I+R)),I=R)}return k.write(_.indexOf(
I),d),k.write(p,d),k.flush(),P.toByteArray()},l=function(){let y={},x=0,p={};return p.add=function(d){if(p.contains(d))throw"dup key:"+d;y[d]=x,x+=1},p.size=function(){
return x},p.indexOf=function(d){return y[d]},p.contains=function(d){return typeof y[d]<"u"},p};return u},at=function(a,g,h){let r=lt(a,g);for(let t=0;t<g;t+=1)for(let l=0;l<
a;l+=1)r.setPixel(l,t,h(l,t));let i=J();r.write(i);let u=ft(),e=i.toByteArray();for(let t=0;t<e.length;t+=1)u.writeByte(e[t]);return u.flush(),"data:image/gif;b\
ase64,"+u},X=$,Bt=$.stringToBytes;function Z(a){let g=X(0,"M");g.addData(a),g.make();let h=g.getModuleCount(),r="";for(let u=0;u<h;u++)for(let e=0;e<h;e++)g.isDark(u,e)&&(r+=`M${e+4} ${u+4}h1v1h\
-1z`);let i=h+8;return`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${i} ${i}" role="img" aria-label="QR code of the link"><path fill="#fff" d="M0 0h${i}\
v${i}H0z"/><path fill="#000" d="${r}"/></svg>`}var W=new URL("../",import.meta.url),ht=await import(new URL("lab.js",import.meta.url).href),{current:gt,languageMenu:dt,name:pt,repeat:wt,say:V,speakFrom:yt,t:xt}=ht,
L=a=>document.getElementById(a),Q=a=>a.replaceAll("&","&amp;").replaceAll('"',"&quot;").replaceAll("<","&lt;");function bt(a){let g=a.trim(),h=g.indexOf("?");return(h>=
0?g.slice(h+1):g.includes("=")?g:"").split("#")[0]}function z(){let a=bt(L("scenario").value),g=[...document.querySelectorAll("input[name=panel]:checked")].map(
e=>e.value),h=new URL(a?`?${a}`:"",W).href,r=`<script type="module" src="${new URL("static/hophoop-motion.js",W).href}"><\/script>
<hophoop-motion scenario="${Q(a)}"${g.length?` panels="${g.join(" ")}"`:""}></hophoop-motion>`,i=`<iframe src="${Q(h)}" title="${Q(xt("embed.a_hopping_hoop"))}"\
 width="100%" height="700" loading="lazy"></iframe>`;L("tag").value=r,L("frame").value=i,L("link").textContent=h,L("link").href=h,L("code").innerHTML=Z(h);let u=document.
createElement("hophoop-motion");u.setAttribute("scenario",a),u.setAttribute("panels",g.join(" ")),L("example").replaceChildren(u)}async function At({target:a}){
await navigator.clipboard.writeText(L(a.dataset.copies).value),V(L("said"),"embed.copied")}function tt(){document.documentElement.lang=gt(),document.title=L("ti\
tle").textContent,L("said").textContent="",z()}await yt(new URL("./",import.meta.url));for(let a of document.querySelectorAll("[data-said]"))V(a,a.getAttribute(
"data-said"));for(let a of document.querySelectorAll("[data-label]"))pt(a,"aria-label",a.getAttribute("data-label"));L("language").append(dt(()=>{wt(document.body),
tt()}));L("scenario").value=location.search.slice(1);for(let a of document.querySelectorAll("input"))a.addEventListener("change",z);for(let a of document.querySelectorAll(
"button[data-copies]"))a.addEventListener("click",At);tt();
