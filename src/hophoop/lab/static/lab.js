/* Built from web/lab/shell/main.ts by esbuild 0.28.2; sources 40742352566fed2b84702c259ec110d0 */
var xl=Object.create;var ti=Object.defineProperty;var _l=Object.getOwnPropertyDescriptor;var El=Object.getOwnPropertyNames;var Ml=Object.getPrototypeOf,Sl=Object.prototype.hasOwnProperty;var Tl=(s,e)=>()=>{try{return e||s((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var Al=(s,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of El(e))!Sl.call(s,o)&&o!==t&&ti(s,o,{get:()=>e[o],enumerable:!(n=_l(e,o))||n.enumerable});
return s};var Ll=(s,e,t)=>(t=s!=null?xl(Ml(s)):{},Al(e||!s||!s.__esModule?ti(t,"default",{value:s,enumerable:!0}):t,s));var Lr=Tl(Un=>{"use strict";Object.defineProperty(Un,"__esModule",{value:!0});function Sr(s){return!s||typeof s=="string"?s:s+""}var Lo=class{async svg2canvas(e,t,n){
let o=await new Promise(r=>{var l=new Image;l.onload=function(){r(l)},l.src=e});var i=document.createElement("canvas");return i.width=t,i.height=n,i.getContext(
"2d").drawImage(o,0,0),i}toDataURL(e,t,n,o,i,a){var r=new XMLSerializer().serializeToString(e),l=document.documentMode;if(l){var c=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi;
c.test(r)&&(r=r.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink'))}a||(a={});var m="data:image/svg+xml;charset=utf-8,"+encodeURIComponent(
r);if(o==="image/svg+xml"||!o)return a.async?Promise.resolve(m):m;if(o==="image/jpeg"||o==="image/png"){if(!a.async)throw new Error("svgcanvas: options.async mu\
st be set to true if type is image/jpeg | image/png");return(async()=>{let h=await this.svg2canvas(m,t,n),d=h.toDataURL(o,i);return h.remove(),d})()}throw new Error(
"svgcanvas: Unknown type for toDataURL, please use image/jpeg | image/png | image/svg+xml.")}getImageData(e,t,n,o,i,a,r,l){if(l||(l={}),!l.async)throw new Error(
"svgcanvas: options.async must be set to true for getImageData");let c=this.toDataURL(e,t,n,"image/svg+xml");return(async()=>{let m=await this.svg2canvas(c,t,n),
d=m.getContext("2d").getImageData(o,i,a,r);return m.remove(),d})()}},Tr=new Lo;var Ar=(function(){var s,e,t,n,o;function i(h,d){var p=Object.keys(d),f;for(f=0;f<
p.length;f++)h=h.replace(new RegExp("\\{"+p[f]+"\\}","gi"),d[p[f]]);return h}function a(h){var d,p,f;if(!h)throw new Error("cannot create a random attribute nam\
e for an undefined object");d="ABCDEFGHIJKLMNOPQRSTUVWXTZabcdefghiklmnopqrstuvwxyz",p="";do for(p="",f=0;f<12;f++)p+=d[Math.floor(Math.random()*d.length)];while(h[p]);
return p}function r(h,d){var p,f,g={},b;for(h=h.split(","),d=d||10,p=0;p<h.length;p+=2)f="&"+h[p+1]+";",b=parseInt(h[p],d),g[f]="&#"+b+";";return g["\\xa0"]="&#\
160;",g}function l(h){var d={left:"start",right:"end",center:"middle",start:"start",end:"end"};return d[h]||d.start}function c(h){var d={alphabetic:"alphabetic",
hanging:"hanging",top:"text-before-edge",bottom:"text-after-edge",middle:"central"};return d[h]||d.alphabetic}o=r("50,nbsp,51,iexcl,52,cent,53,pound,54,curren,5\
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
p,rsquo,80q,sbquo,80s,ldquo,80t,rdquo,80u,bdquo,810,dagger,811,Dagger,81g,permil,81p,lsaquo,81q,rsaquo,85c,euro",32),s={strokeStyle:{svgAttr:"stroke",canvas:"#0\
00000",svg:"none",apply:"stroke"},fillStyle:{svgAttr:"fill",canvas:"#000000",svg:null,apply:"fill"},lineCap:{svgAttr:"stroke-linecap",canvas:"butt",svg:"butt",apply:"\
stroke"},lineJoin:{svgAttr:"stroke-linejoin",canvas:"miter",svg:"miter",apply:"stroke"},miterLimit:{svgAttr:"stroke-miterlimit",canvas:10,svg:4,apply:"stroke"},
lineWidth:{svgAttr:"stroke-width",canvas:1,svg:1,apply:"stroke"},globalAlpha:{svgAttr:"opacity",canvas:1,svg:1,apply:"fill stroke"},font:{canvas:"10px sans-seri\
f"},shadowColor:{canvas:"#000000"},shadowOffsetX:{canvas:0},shadowOffsetY:{canvas:0},shadowBlur:{canvas:0},textAlign:{canvas:"start"},textBaseline:{canvas:"alph\
abetic"},lineDash:{svgAttr:"stroke-dasharray",canvas:[],svg:null,apply:"stroke"}},t=function(h,d){this.__root=h,this.__ctx=d},t.prototype.addColorStop=function(h,d){
var p=this.__ctx.__createElement("stop"),f,g;p.setAttribute("offset",h),Sr(d).indexOf("rgba")!==-1?(f=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
g=f.exec(d),p.setAttribute("stop-color",i("rgb({r},{g},{b})",{r:g[1],g:g[2],b:g[3]})),p.setAttribute("stop-opacity",g[4])):p.setAttribute("stop-color",Sr(d)),this.
__root.appendChild(p)},n=function(h,d){this.__root=h,this.__ctx=d},e=function(h){var d={width:500,height:500,enableMirroring:!1},p;if(arguments.length>1?(p=d,p.
width=arguments[0],p.height=arguments[1]):h?p=h:p=d,!(this instanceof e))return new e(p);this.width=p.width||d.width,this.height=p.height||d.height,this.enableMirroring=
p.enableMirroring!==void 0?p.enableMirroring:d.enableMirroring,this.canvas=this,this.__document=p.document||document,p.ctx?this.__ctx=p.ctx:(this.__canvas=this.
__document.createElement("canvas"),this.__ctx=this.__canvas.getContext("2d")),this.__setDefaultStyles(),this.__styleStack=[this.__getStyleState()],this.__groupStack=
[],this.__root=this.__document.createElementNS("http://www.w3.org/2000/svg","svg"),this.__root.setAttribute("version",1.1),this.__root.setAttribute("xmlns","htt\
p://www.w3.org/2000/svg"),this.__root.setAttributeNS("http://www.w3.org/2000/xmlns/","xmlns:xlink","http://www.w3.org/1999/xlink"),this.__root.setAttribute("wid\
th",this.width),this.__root.setAttribute("height",this.height),this.__ids={},this.__defs=this.__document.createElementNS("http://www.w3.org/2000/svg","defs"),this.
__root.appendChild(this.__defs),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.resetTransform(),this.__options=p,this.__id=Math.random().toString(16).substring(2,8),this.__debug("new",h)},e.prototype.__debug=function(...h){this.__options.
debug&&console.debug(`svgcanvas#${this.__id}:`,...h)},e.prototype.__createElement=function(h,d,p){typeof d>"u"&&(d={});var f=this.__document.createElementNS("ht\
tp://www.w3.org/2000/svg",h),g=Object.keys(d),b,w;for(p&&(f.setAttribute("fill","none"),f.setAttribute("stroke","none")),b=0;b<g.length;b++)w=g[b],f.setAttribute(
w,d[w]);return f},e.prototype.__setDefaultStyles=function(){var h=Object.keys(s),d,p;for(d=0;d<h.length;d++)p=h[d],this[p]=s[p].canvas},e.prototype.__applyStyleState=
function(h){var d=Object.keys(h),p,f;for(p=0;p<d.length;p++)f=d[p],this[f]=h[f]},e.prototype.__getStyleState=function(){var h,d={},p=Object.keys(s),f;for(h=0;h<
p.length;h++)f=p[h],d[f]=this[f];return d},e.prototype.__applyTransformation=function(h,d){let{a:p,b:f,c:g,d:b,e:w,f:y}=d||this.getTransform();h.setAttribute("t\
ransform",`matrix(${p} ${f} ${g} ${b} ${w} ${y})`)},e.prototype.__applyStyleToCurrentElement=function(h){var d=this.__currentElement,p=this.__currentElementsToStyle;
p&&(d.setAttribute(h,""),d=p.element,p.children.forEach(function(H){H.setAttribute(h,"")}));var f=Object.keys(s),g,b,w,y,v,E,T,L;for(g=0;g<f.length;g++)if(b=s[f[g]],
w=this[f[g]],b.apply){if(w instanceof n){if(w.__ctx)for(T=0;T<w.__ctx.__defs.childNodes.length;T++)L=w.__ctx.__defs.childNodes[T],E=L.getAttribute("id"),this.__ids[E]=
E,this.__defs.appendChild(L);d.setAttribute(b.apply,i("url(#{id})",{id:w.__root.getAttribute("id")}))}else if(w instanceof t)d.setAttribute(b.apply,i("url(#{id}\
)",{id:w.__root.getAttribute("id")}));else if(b.apply.indexOf(h)!==-1&&b.svg!==w)if((b.svgAttr==="stroke"||b.svgAttr==="fill")&&w&&w.indexOf("rgba")!==-1){y=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
v=y.exec(w),d.setAttribute(b.svgAttr,i("rgb({r},{g},{b})",{r:v[1],g:v[2],b:v[3]}));var P=v[4],F=this.globalAlpha;F!=null&&(P*=F),d.setAttribute(b.svgAttr+"-opac\
ity",P)}else{var A=b.svgAttr;if(f[g]==="globalAlpha"){if(A=h+"-"+b.svgAttr,d.getAttribute(A))continue}else if(f[g]==="lineWidth"){var D=this.__getTransformScale();
w=w*Math.max(D.x,D.y)}d.setAttribute(A,w)}}},e.prototype.__closestGroupOrSvg=function(h){return h=h||this.__currentElement,h.nodeName==="g"||h.nodeName==="svg"?
h:this.__closestGroupOrSvg(h.parentNode)},e.prototype.getSerializedSvg=function(h){var d=new XMLSerializer().serializeToString(this.__root),p,f,g,b,w,y;if(y=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi,
y.test(d)&&(d=d.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink')),h)for(p=Object.keys(o),f=0;f<p.length;f++)g=p[f],b=o[g],
w=new RegExp(g,"gi"),w.test(d)&&(d=d.replace(w,b));return d},e.prototype.getSvg=function(){return this.__root},e.prototype.save=function(){var h=this.__createElement(
"g"),d=this.__closestGroupOrSvg();this.__groupStack.push(d),d.appendChild(h),this.__currentElement=h;let p=this.__getStyleState();this.__debug("save style",p),this.
__styleStack.push(p),this.__transformMatrixStack||(this.__transformMatrixStack=[]),this.__transformMatrixStack.push(this.getTransform())},e.prototype.restore=function(){
this.__currentElement=this.__groupStack.pop(),this.__currentElementsToStyle=null,this.__currentElement||(this.__currentElement=this.__root.childNodes[1]);var h=this.
__styleStack.pop();this.__debug("restore style",h),this.__applyStyleState(h),this.__transformMatrixStack&&this.__transformMatrixStack.length>0&&this.setTransform(
this.__transformMatrixStack.pop())},e.prototype.beginPath=function(){var h,d;this.__currentDefaultPath="",this.__currentPosition={},h=this.__createElement("path",
{},!0),d=this.__closestGroupOrSvg(),d.appendChild(h),this.__currentElement=h},e.prototype.__applyCurrentDefaultPath=function(){var h=this.__currentElement;h.nodeName===
"path"?h.setAttribute("d",this.__currentDefaultPath):console.error("Attempted to apply path command to node",h.nodeName)},e.prototype.__addPathCommand=function(h){
this.__currentDefaultPath+=" ",this.__currentDefaultPath+=h},e.prototype.moveTo=function(h,d){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.__currentPosition=
{x:h,y:d},this.__addPathCommand(i("M {x} {y}",{x:this.__matrixTransform(h,d).x,y:this.__matrixTransform(h,d).y}))},e.prototype.closePath=function(){this.__currentDefaultPath&&
this.__addPathCommand("Z")},e.prototype.lineTo=function(h,d){this.__currentPosition={x:h,y:d},this.__currentDefaultPath.indexOf("M")>-1?this.__addPathCommand(i(
"L {x} {y}",{x:this.__matrixTransform(h,d).x,y:this.__matrixTransform(h,d).y})):this.__addPathCommand(i("M {x} {y}",{x:this.__matrixTransform(h,d).x,y:this.__matrixTransform(
h,d).y}))},e.prototype.bezierCurveTo=function(h,d,p,f,g,b){this.__currentPosition={x:g,y:b},this.__addPathCommand(i("C {cp1x} {cp1y} {cp2x} {cp2y} {x} {y}",{cp1x:this.
__matrixTransform(h,d).x,cp1y:this.__matrixTransform(h,d).y,cp2x:this.__matrixTransform(p,f).x,cp2y:this.__matrixTransform(p,f).y,x:this.__matrixTransform(g,b).
x,y:this.__matrixTransform(g,b).y}))},e.prototype.quadraticCurveTo=function(h,d,p,f){this.__currentPosition={x:p,y:f},this.__addPathCommand(i("Q {cpx} {cpy} {x}\
 {y}",{cpx:this.__matrixTransform(h,d).x,cpy:this.__matrixTransform(h,d).y,x:this.__matrixTransform(p,f).x,y:this.__matrixTransform(p,f).y}))};var m=function(h){
var d=Math.sqrt(h[0]*h[0]+h[1]*h[1]);return[h[0]/d,h[1]/d]};return e.prototype.arcTo=function(h,d,p,f,g){var b=this.__currentPosition&&this.__currentPosition.x,
w=this.__currentPosition&&this.__currentPosition.y;if(!(typeof b>"u"||typeof w>"u")){if(g<0)throw new Error("IndexSizeError: The radius provided ("+g+") is nega\
tive.");if(b===h&&w===d||h===p&&d===f||g===0){this.lineTo(h,d);return}var y=m([b-h,w-d]),v=m([p-h,f-d]);if(y[0]*v[1]===y[1]*v[0]){this.lineTo(h,d);return}var E=y[0]*
v[0]+y[1]*v[1],T=Math.acos(Math.abs(E)),L=m([y[0]+v[0],y[1]+v[1]]),P=g/Math.sin(T/2),F=h+P*L[0],A=d+P*L[1],D=[-y[1],y[0]],H=[v[1],-v[0]],le=function(Xo){var ei=Xo[0],
kl=Xo[1];return kl>=0?Math.acos(ei):-Math.acos(ei)},Ie=le(D),jt=le(H);this.lineTo(F+D[0]*g,A+D[1]*g),this.arc(F,A,g,Ie,jt)}},e.prototype.stroke=function(){this.
__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","fill stroke markers"),this.__applyCurrentDefaultPath(),this.__applyStyleToCurrentElement(
"stroke")},e.prototype.fill=function(){this.__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","stroke fill markers"),this.__applyCurrentDefaultPath(),
this.__applyStyleToCurrentElement("fill")},e.prototype.rect=function(h,d,p,f){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.moveTo(h,d),this.lineTo(
h+p,d),this.lineTo(h+p,d+f),this.lineTo(h,d+f),this.lineTo(h,d),this.closePath()},e.prototype.roundRect=function(h,d,p,f,g){this.__currentElement.nodeName!=="pa\
th"&&this.beginPath();let b,w,y,v;typeof g=="number"?(b=g,w=g,y=g,v=g):[b,w,y,v]=g,this.moveTo(h+b,d),this.arcTo(h+p,d,h+p,d+f,w),this.arcTo(h+p,d+f,h,d+f,y),this.
arcTo(h,d+f,h,d,v),this.arcTo(h,d,h+p,d,b),this.closePath()},e.prototype.fillRect=function(h,d,p,f){let{a:g,b,c:w,d:y,e:v,f:E}=this.getTransform();JSON.stringify(
[g,b,w,y,v,E])===JSON.stringify([1,0,0,1,0,0])&&h===0&&d===0&&p===this.width&&f===this.height&&this.__clearCanvas();var T,L;T=this.__createElement("rect",{x:h,y:d,
width:p,height:f},!0),L=this.__closestGroupOrSvg(),L.appendChild(T),this.__currentElement=T,this.__applyTransformation(T),this.__applyStyleToCurrentElement("fil\
l")},e.prototype.strokeRect=function(h,d,p,f){var g,b;g=this.__createElement("rect",{x:h,y:d,width:p,height:f},!0),b=this.__closestGroupOrSvg(),b.appendChild(g),
this.__currentElement=g,this.__applyTransformation(g),this.__applyStyleToCurrentElement("stroke")},e.prototype.__clearCanvas=function(){var h=this.__root.childNodes[1];
this.__root.removeChild(h),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.__groupStack=[]},e.prototype.clearRect=function(h,d,p,f){let{a:g,b,c:w,d:y,e:v,f:E}=this.getTransform();if(JSON.stringify([g,b,w,y,v,E])===JSON.stringify([
1,0,0,1,0,0])&&h===0&&d===0&&p===this.width&&f===this.height){this.__clearCanvas();return}var T,L=this.__closestGroupOrSvg();T=this.__createElement("rect",{x:h,
y:d,width:p,height:f,fill:"#FFFFFF"},!0),this.__applyTransformation(T),L.appendChild(T)},e.prototype.createLinearGradient=function(h,d,p,f){var g=this.__createElement(
"linearGradient",{id:a(this.__ids),x1:h+"px",x2:p+"px",y1:d+"px",y2:f+"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(g),new t(g,this)},
e.prototype.createRadialGradient=function(h,d,p,f,g,b){var w=this.__createElement("radialGradient",{id:a(this.__ids),cx:f+"px",cy:g+"px",r:b+"px",fx:h+"px",fy:d+
"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(w),new t(w,this)},e.prototype.__applyText=function(h,d,p,f){var g=document.createElement(
"span");g.setAttribute("style","font:"+this.font);var b=g.style,w=this.__closestGroupOrSvg(),y=this.__createElement("text",{"font-family":b.fontFamily,"font-siz\
e":b.fontSize,"font-style":b.fontStyle,"font-weight":b.fontWeight,"text-decoration":this.__fontUnderline,x:d,y:p,"text-anchor":l(this.textAlign),"dominant-basel\
ine":c(this.textBaseline)},!0);if(y.appendChild(this.__document.createTextNode(h)),this.__currentElement=y,this.__applyTransformation(y),this.__applyStyleToCurrentElement(
f),this.__fontHref){var v=this.__createElement("a");v.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",this.__fontHref),v.appendChild(y),y=v}w.appendChild(
y)},e.prototype.fillText=function(h,d,p){this.__applyText(h,d,p,"fill")},e.prototype.strokeText=function(h,d,p){this.__applyText(h,d,p,"stroke")},e.prototype.measureText=
function(h){return this.__ctx.font=this.font,this.__ctx.measureText(h)},e.prototype.arc=function(h,d,p,f,g,b){if(f!==g){f=f%(2*Math.PI),g=g%(2*Math.PI),f===g&&(g=
(g+2*Math.PI-.001*(b?-1:1))%(2*Math.PI));var w=h+p*Math.cos(g),y=d+p*Math.sin(g),v=h+p*Math.cos(f),E=d+p*Math.sin(f),T=b?0:1,L=0,P=g-f;P<0&&(P+=2*Math.PI),b?L=P>
Math.PI?0:1:L=P>Math.PI?1:0;var F=Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),A=Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d);
this.lineTo(v,E),this.__addPathCommand(i("A {rx} {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:p*F,ry:p*A,xAxisRotation:0,largeArcFlag:L,sweepFlag:T,
endX:this.__matrixTransform(w,y).x,endY:this.__matrixTransform(w,y).y})),this.__currentPosition={x:w,y}}},e.prototype.ellipse=function(h,d,p,f,g,b,w,y){if(b!==w){
var v=this.__matrixTransform(h,d);h=v.x,d=v.y;var E=this.__getTransformScale();p=p*E.x,f=f*E.y,g=g+this.__getTransformRotation(),b=b%(2*Math.PI),w=w%(2*Math.PI),
b===w&&(w=(w+2*Math.PI-.001*(y?-1:1))%(2*Math.PI));var T=h+Math.cos(-g)*p*Math.cos(w)+Math.sin(-g)*f*Math.sin(w),L=d-Math.sin(-g)*p*Math.cos(w)+Math.cos(-g)*f*Math.
sin(w),P=h+Math.cos(-g)*p*Math.cos(b)+Math.sin(-g)*f*Math.sin(b),F=d-Math.sin(-g)*p*Math.cos(b)+Math.cos(-g)*f*Math.sin(b),A=y?0:1,D=0,H=w-b;H<0&&(H+=2*Math.PI),
y?D=H>Math.PI?0:1:D=H>Math.PI?1:0;var le=this.__transformMatrix;this.resetTransform(),this.lineTo(P,F),this.__transformMatrix=le,this.__addPathCommand(i("A {rx}\
 {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:p,ry:f,xAxisRotation:g*(180/Math.PI),largeArcFlag:D,sweepFlag:A,endX:T,endY:L})),this.__currentPosition=
{x:T,y:L}}},e.prototype.clip=function(){var h=this.__closestGroupOrSvg(),d=this.__createElement("clipPath"),p=a(this.__ids),f=this.__createElement("g");this.__applyCurrentDefaultPath(),
h.removeChild(this.__currentElement),d.setAttribute("id",p),d.appendChild(this.__currentElement),this.__defs.appendChild(d),h.setAttribute("clip-path",i("url(#{\
id})",{id:p})),h.appendChild(f),this.__currentElement=f},e.prototype.drawImage=function(){var h=Array.prototype.slice.call(arguments),d=h[0],p,f,g,b,w=0,y=0,v,E,
T,L,P,F,A,D,H,le;if(h.length===3)p=h[1],f=h[2],v=d.width,E=d.height,g=v,b=E;else if(h.length===5)p=h[1],f=h[2],g=h[3],b=h[4],v=d.width,E=d.height;else if(h.length===
9)w=h[1],y=h[2],v=h[3],E=h[4],p=h[5],f=h[6],g=h[7],b=h[8];else throw new Error("Invalid number of arguments passed to drawImage: "+arguments.length);T=this.__closestGroupOrSvg(),
this.__currentElement;let Ie=this.getTransform().translate(p,f);if(d instanceof e){if(L=d.getSvg().cloneNode(!0),L.childNodes&&L.childNodes.length>1){for(P=L.childNodes[0];P.
childNodes.length;)le=P.childNodes[0].getAttribute("id"),this.__ids[le]=le,this.__defs.appendChild(P.childNodes[0]);F=L.childNodes[1],F&&(this.__applyTransformation(
F,Ie),T.appendChild(F))}}else(d.nodeName==="CANVAS"||d.nodeName==="IMG")&&(A=this.__createElement("image"),A.setAttribute("width",g),A.setAttribute("height",b),
A.setAttribute("preserveAspectRatio","none"),(w||y||v!==d.width||E!==d.height)&&(D=this.__document.createElement("canvas"),D.width=g,D.height=b,H=D.getContext("\
2d"),H.drawImage(d,w,y,v,E,0,0,g,b),d=D),this.__applyTransformation(A,Ie),A.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",d.nodeName==="CANVAS"?d.toDataURL():
d.getAttribute("src")),T.appendChild(A))},e.prototype.createPattern=function(h,d){var p=this.__document.createElementNS("http://www.w3.org/2000/svg","pattern"),
f=a(this.__ids),g;return p.setAttribute("id",f),p.setAttribute("width",h.width),p.setAttribute("height",h.height),p.setAttribute("patternUnits","userSpaceOnUse"),
h.nodeName==="CANVAS"||h.nodeName==="IMG"?(g=this.__document.createElementNS("http://www.w3.org/2000/svg","image"),g.setAttribute("width",h.width),g.setAttribute(
"height",h.height),g.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",h.nodeName==="CANVAS"?h.toDataURL():h.getAttribute("src")),p.appendChild(g),this.
__defs.appendChild(p)):h instanceof e&&(p.appendChild(h.__root.childNodes[1]),this.__defs.appendChild(p)),new n(p,this)},e.prototype.setLineDash=function(h){h&&
h.length>0?this.lineDash=h.join(","):this.lineDash=null},e.prototype.setTransform=function(h,d,p,f,g,b){h instanceof DOMMatrix?this.__transformMatrix=new DOMMatrix(
[h.a,h.b,h.c,h.d,h.e,h.f]):this.__transformMatrix=new DOMMatrix([h,d,p,f,g,b])},e.prototype.getTransform=function(){let{a:h,b:d,c:p,d:f,e:g,f:b}=this.__transformMatrix;
return new DOMMatrix([h,d,p,f,g,b])},e.prototype.resetTransform=function(){this.setTransform(1,0,0,1,0,0)},e.prototype.scale=function(h,d){if(d===void 0&&(d=h),
isNaN(h)||isNaN(d)||!isFinite(h)||!isFinite(d))return;let p=this.getTransform().scale(h,d);this.setTransform(p)},e.prototype.rotate=function(h){let d=this.getTransform().
multiply(new DOMMatrix([Math.cos(h),Math.sin(h),-Math.sin(h),Math.cos(h),0,0]));this.setTransform(d)},e.prototype.translate=function(h,d){let p=this.getTransform().
translate(h,d);this.setTransform(p)},e.prototype.transform=function(h,d,p,f,g,b){let w=this.getTransform().multiply(new DOMMatrix([h,d,p,f,g,b]));this.setTransform(
w)},e.prototype.__matrixTransform=function(h,d){return new DOMPoint(h,d).matrixTransform(this.__transformMatrix)},e.prototype.__getTransformScale=function(){return{
x:Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),y:Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d)}},e.prototype.__getTransformRotation=
function(){return Math.atan2(this.__transformMatrix.b,this.__transformMatrix.a)},e.prototype.getImageData=function(h,d,p,f,g){return Tr.getImageData(this.getSvg(),
this.width,this.height,h,d,p,f,g)},e.prototype.drawFocusRing=function(){},e.prototype.createImageData=function(){},e.prototype.putImageData=function(){},e.prototype.
globalCompositeOperation=function(){},e})();function Ne(s){this.ctx=new Ar(s),this.svg=this.ctx.__root;var e=this.svg,t=this,n=document.createElement("div");n.style.
display="inline-block",n.appendChild(e),this.wrapper=n,Object.defineProperty(this,"className",{get:function(){return n.getAttribute("class")||""},set:function(o){
return n.setAttribute("class",o)}}),Object.defineProperty(this,"tagName",{get:function(){return"CANVAS"},set:function(){}}),["width","height"].forEach(function(o){
Object.defineProperty(t,o,{get:function(){return e.getAttribute(o)|0},set:function(i){if(!(isNaN(i)||typeof i>"u"))return t.ctx[o]=i,e.setAttribute(o,i),n[o]=i}})}),
["style","id"].forEach(function(o){Object.defineProperty(t,o,{get:function(){return n[o]},set:function(i){if(typeof i<"u")return n[o]=i}})}),["getBoundingClient\
Rect"].forEach(function(o){t[o]=function(){return e[o]()}})}Ne.prototype.getContext=function(s){if(s!=="2d")throw new Error("Unsupported type of context for SVG\
Canvas");return this.ctx};Ne.prototype.toObjectURL=function(){var s=new XMLSerializer().serializeToString(this.svg),e=new Blob([s],{type:"image/svg+xml;charset=\
utf-8"});return URL.createObjectURL(e)};Ne.prototype.toDataURL=function(s,e,t){return Tr.toDataURL(this.svg,this.width,this.height,s,e,t)};Ne.prototype.addEventListener=
function(){return this.svg.addEventListener.apply(this.svg,arguments)};Ne.prototype.getElement=function(){return this.wrapper};Ne.prototype.getAttribute=function(s){
return this.wrapper.getAttribute(s)};Ne.prototype.setAttribute=function(s,e){this.wrapper.setAttribute(s,e)};Un.Context=Ar;Un.Element=Ne});var x={sources:"8b55b304b90bb2841a2033a0ba629ce4",module:"08ddd1356e3298fb",derivatives:"caff7ba008cdc5ef",built_with:{numba:"0.68.1",llvmlite:"0.50.0",numpy:"2\
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
"buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var qe=s=>Object.fromEntries(s.map((e,t)=>[e,t])),ni=qe(x.cell),de=qe(x.heads),B=qe(x.events),ms=qe(x.samples),si=qe(x.changes),oi=qe(x.numbers),ps=qe(x.words),
Pl={law:({impact_law:s})=>x.impact_laws.indexOf(s),strike:({painleve:s})=>+(s==="impact"),allowed:()=>1},ht=x.cell.map(s=>Pl[s]??(e=>Number(e[s]??0))),Ae=s=>Float64Array.
from(ht,e=>e(s));function ct(s){let e=s?{...s,law:x.laws.indexOf(s.law),friction_law:x.friction_laws.indexOf(s.friction)}:{};return Float64Array.from(x.compliant,
t=>e[t]??Number.NaN)}var ii={setup:{version:"0.1.0",controls:{groups:{hoop:[{path:"hoop.load_fraction",label:"Load fraction",symbol:"γ",unit:"",help:"Share of the mass in the load \
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
3B0A",limit:"#6E6E6E"}},fingerprints:{hop:"85b1751f991ff2a3",slip:"e4f784b57d9527de",roll:"67a142a154835aa6",slow:"915956aa4dd065c8",slippery:"1a8ae06b20c63390",
littlewood:"f722b9a4b8757b9d","littlewood-fast":"d43e0434fa7cbae3","nearly-massless":"147fe27d9b5619a0",inconsistent:"feb302b6289b4311",indeterminate:"0578ec530\
4f707df",jam:"eafe27173f21f089",kane:"700bd2b728523ae1",downhill:"d5a475e54711f966",bounces:"c6734bd1e0f9fa98",moon:"6ec3efb6023122ba"},schema:"hophoop/1",scenario:{
sections:{hoop:["Hoop"],plane:["Plane"],start:["Start"],contact:["Rigid","Compliant"]},models:{Scenario:{place:"",fields:{duration:{kind:"number",unit:"s",default:6,
limits:[["greater_than",0]],range:{least:1e-9,most:1e9,words:"from 1e-09 to 1e+09 s"}},hoop:{kind:"section",unit:""},plane:{kind:"section",unit:""},start:{kind:"\
section",unit:""},contact:{kind:"section",unit:""}}},Hoop:{place:"hoop.",fields:{radius:{kind:"number",unit:"m",default:1,limits:[["greater_than",0]],range:{least:1e-6,
most:1e6,words:"from 1e-06 to 1e+06 m"}},mass:{kind:"number",unit:"kg",default:1,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,words:"from 1e-12 to 1\
e+12 kg"}},load_fraction:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than_equal",0],["less_than_equal",1]]},eccentricity:{kind:"number",unit:"\
1",default:.75,limits:[["greater_than_equal",0],["less_than_equal",1]]},inertia_ratio:{kind:"number",unit:"1",default:.4375,limits:[["greater_than_equal",0]],range:{
least:1e-12,most:1e6,words:"0 or from 1e-12 to 1e+06",also:[0]}},parts:{kind:"parts",unit:"",nullable:!0,default:null}}},Plane:{place:"plane.",fields:{gravity:{
kind:"number",unit:"m/s²",default:9.81,limits:[["greater_than_equal",0]],range:{least:1e-6,most:1e6,words:"0 or from 1e-06 to 1e+06 m/s²",also:[0]}},slope:{kind:"\
number",unit:"rad",default:0},mu:{kind:"friction",unit:"1",nullable:!0,default:null,range:{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]}},mu_static:{
kind:"friction",unit:"1",default:1,range:{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]}},mu_kinetic:{kind:"friction",unit:"1",default:1,range:{
least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]}},restitution:{kind:"number",unit:"1",default:0,limits:[["greater_than_equal",0],["less_than_equal",
1]]},impact_law:{kind:"word",unit:"",default:"stronge",options:["stronge","newton","poisson"],expected:"'stronge', 'newton' or 'poisson'"},painleve:{kind:"word",
unit:"",default:"flight",options:["flight","impact"],expected:"'flight' or 'impact'"},rolling_resistance:{kind:"number",unit:"1",default:0,limits:[["greater_tha\
n_equal",0],["less_than_equal",1]]}}},Start:{place:"start.",fields:{x:{kind:"number",unit:"m",default:0,range:{least:-1e9,most:1e9,words:"from -1e+09 to 1e+09 m"}},
height:{kind:"number",unit:"m",default:0,limits:[["greater_than_equal",0]],range:{least:0,most:1e6,words:"from 0 to 1e+06 m"}},angle:{kind:"number",unit:"rad",default:0,
range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 rad"}},speed:{kind:"number",unit:"m/s",nullable:!0,default:null,range:{least:-1e6,most:1e6,words:"from -1\
e+06 to 1e+06 m/s"}},vx:{kind:"number",unit:"m/s",default:0,range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 m/s"}},vy:{kind:"number",unit:"m/s",default:0,
range:{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06 m/s"}},omega:{kind:"number",unit:"rad/s",nullable:!0,default:0,range:{least:-1e9,most:1e9,words:"from -1e\
+09 to 1e+09 rad/s"}}}},Rigid:{place:"contact.",fields:{model:{kind:"word",unit:"",default:"rigid",options:["rigid"],expected:"'rigid'"},max_events:{kind:"whole",
unit:"1",default:1e5,limits:[["greater_than_equal",1],["less_than_equal",1e7]]}}},Compliant:{place:"contact.",fields:{model:{kind:"word",unit:"",default:"compli\
ant",options:["compliant"],expected:"'compliant'"},stiffness:{kind:"number",unit:"N/m",nullable:!0,default:null,limits:[["greater_than",0]],range:{least:1e-6,most:1e18,
words:"from 1e-06 to 1e+18 N/m"}},damping:{kind:"number",unit:"N s/m or s/m",nullable:!0,default:null,limits:[["greater_than_equal",0]],range:{least:0,most:1e12,
words:"from 0 to 1e+12"}},restitution:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than_equal",0],["less_than_equal",1]]},law:{kind:"word",
unit:"",default:"kelvin-voigt",options:["kelvin-voigt","hunt-crossley"],expected:"'kelvin-voigt' or 'hunt-crossley'"},friction:{kind:"word",unit:"",default:"tan\
h",options:["tanh","linear","bristle"],expected:"'tanh', 'linear' or 'bristle'"},slip_speed:{kind:"number",unit:"m/s",nullable:!0,default:null,limits:[["greater\
_than",0]],range:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06 m/s"}},tangential_stiffness:{kind:"number",unit:"N/m",nullable:!0,default:null,limits:[["great\
er_than",0]],range:{least:1e-6,most:1e18,words:"from 1e-06 to 1e+18 N/m"}},rtol:{kind:"number",unit:"1",nullable:!0,default:null,limits:[["greater_than",0]],range:{
least:1e-10,most:.1,words:"from 1e-10 to 0.1"}},max_events:{kind:"whole",unit:"1",default:1e5,limits:[["greater_than_equal",1],["less_than_equal",1e7]]}}},Ring:{
place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"ring",options:["ring"],expected:"'ring'"},mass:{kind:"number",unit:"kg",required:!0,limits:[["g\
reater_than",0]],range:{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},inner_radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than_equal",0]]},
outer_radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06 m"}}}},Disk:{place:"hoop.par\
ts: ",fields:{shape:{kind:"word",unit:"",default:"disk",options:["disk"],expected:"'disk'"},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],
range:{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},radius:{kind:"number",unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,
words:"from 1e-12 to 1e+06 m"}},at:{kind:"number",unit:"m",default:0}}},PointMass:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"point_mass",
options:["point_mass"],expected:"'point_mass'"},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,words:"from 1\
e-12 to 1e+12 kg"}},at:{kind:"number",unit:"m",required:!0}}},Rod:{place:"hoop.parts: ",fields:{shape:{kind:"word",unit:"",default:"rod",options:["rod"],expected:"\
'rod'"},mass:{kind:"number",unit:"kg",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"}},length:{kind:"number",
unit:"m",required:!0,limits:[["greater_than",0]],range:{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06 m"}},at:{kind:"number",unit:"m",default:0},direction:{kind:"\
word",unit:"",default:"radial",options:["radial","tangential"],expected:"'radial' or 'tangential'"}}}},parts:{ring:"Ring",disk:"Disk",point_mass:"PointMass",rod:"\
Rod"},ends:{"hoop.load_fraction":["eccentricity","inertia_ratio","parts"],"hoop.eccentricity":["load_fraction","parts"],"hoop.inertia_ratio":["load_fraction","p\
arts"],"hoop.parts":["load_fraction","eccentricity","inertia_ratio","mass"],"plane.mu":["mu_static","mu_kinetic"],"plane.mu_static":["mu"],"plane.mu_kinetic":["\
mu"],"start.speed":["height","vx","vy","omega"],"start.height":["speed"],"start.vx":["speed"],"start.vy":["speed"],"start.omega":["speed"],"contact.damping":["r\
estitution"],"contact.restitution":["damping"]},left_out:{rolling_resistance:0},rules:[null,{sentence:"hoop_mass",values:{mass:"hoop.mass"},known:{words:"from 1\
e-12 to 1e+12 kg"},number:""},{sentence:"load_inertia",values:{load_fraction:"hoop.load_fraction",inertia_ratio:"hoop.inertia_ratio"},known:{words:"0 or from 1e\
-12 to 1e+06"},number:""},{sentence:"parts_inertia",values:{inertia_ratio:"hoop.inertia_ratio"},known:{words:"0 or from 1e-12 to 1e+06"},number:""},{sentence:"m\
assless_eccentricity",values:{eccentricity:"hoop.eccentricity"},known:{},number:""},{sentence:"kinetic_above_static",values:{mu_kinetic:"plane.mu_kinetic",mu_static:"\
plane.mu_static"},known:{},number:""},{sentence:"vertical",values:{slope:"plane.slope"},known:{},number:""},{sentence:"slope",values:{slope:"plane.slope"},known:{
words:"from -1.57 to 1.57 rad"},number:""},{sentence:"massless_slope",values:{slope:"plane.slope"},known:{},number:""},{sentence:"massless_resistance",values:{given:"\
plane.rolling_resistance"},known:{},number:""},{sentence:"resistance",values:{given:"plane.rolling_resistance"},known:{},number:"most"},{sentence:"massless_comp\
liant",values:{},known:{},number:""},{sentence:"compliant_friction",values:{},known:{},number:""},{sentence:"relative_contact",values:{value:"contact.stiffness"},
known:{name:"stiffness",unit:"m g/R",words:"from 0.01 to 1e+15"},number:"relative"},{sentence:"relative_contact",values:{value:"contact.tangential_stiffness"},known:{
name:"tangential_stiffness",unit:"m g/R",words:"from 0.01 to 1e+15"},number:"relative"},{sentence:"relative_contact",values:{value:"contact.slip_speed"},known:{
name:"slip_speed",unit:"√(g R)",words:"from 1e-12 to 1e+06"},number:"relative"},{sentence:"too_soft",values:{stiffness:"contact.stiffness"},known:{most:100},number:"\
depth"}],touch:1e-12,default:{duration:6,hoop:{radius:1,mass:1,load_fraction:.75},plane:{gravity:9.81,slope:0,mu:1,restitution:0,impact_law:"stronge",painleve:"\
flight"},start:{x:0,angle:0,speed:3.1},contact:{model:"rigid",max_events:1e5}}},texts:{unknown_key:"{path} is not a known key; {hint}",did_you_mean:"did you mea\
n {close}?",known_are:"known are {known}.",missing:"{path} is missing.",together:"{section}.{other} cannot be given together with {section}.{way}.",finding:"{pa\
th} = {shown} {allowed}.",number:"must be a number",friction:"must be at least 0 (inf is allowed)",whole:"must be a whole number",finite_number:"must be a finit\
e number",greater_than:"must be greater than {limit:g}",greater_than_equal:"must be at least {limit:g}",less_than:"must be less than {limit:g}",less_than_equal:"\
must be at most {limit:g}",range:"must be {words}",literal_error:"must be {expected}",table:"must be a table of keys",list:"must be a list",word:"must be a word",
other_problem:"{first} (and {count} more problem).",other_problems:"{first} (and {count} more problems).",whole_scenario:"the scenario",no_parts:"hoop.parts mus\
t not be empty.",half_a_hoop:"hoop.{missing} is missing: hoop.{given} does not define a hoop without it.",massless_eccentricity:"hoop.inertia_ratio = 0 needs ho\
op.eccentricity = 1 (all mass in a point on the rim), not {eccentricity!r}.",hoop_mass:"hoop.mass = {mass!r} must be {words}.",parts_inertia:"hoop.parts give ho\
op.inertia_ratio = {inertia_ratio!r}, which must be {words}.",load_inertia:"hoop.load_fraction = {load_fraction!r} gives hoop.inertia_ratio = {inertia_ratio!r},\
 which must be {words}.",ring_radii:"ring.inner_radius = {inner!r} must not exceed ring.outer_radius = {outer!r}.",beyond_the_rim:"hoop.parts.{index} ({shape}) \
reaches {reach!r} m from the centre, beyond the rim: hoop.radius = {radius!r}.",kinetic_above_static:"plane.mu_kinetic = {mu_kinetic!r} must not exceed plane.mu\
_static = {mu_static!r}.",vertical:"plane.slope = {slope!r} must lie between -pi/2 and pi/2 (radians).",slope:"plane.slope = {slope!r} must be {words}.",no_omega:"\
start.omega = None must be a number.",massless_slope:"plane.slope = {slope!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",massless_resistance:"pl\
ane.rolling_resistance = {given!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",resistance:"plane.rolling_resistance = {given!r} must be below {mo\
st:.6g} for this hoop, whose inertia about the contact it would cancel at some angle.",massless_compliant:"contact.model = 'compliant' must be 'rigid' for the m\
assless hoop (hoop.inertia_ratio = 0).",compliant_friction:"plane.mu_static = inf must be finite with contact.model = 'compliant'.",relative_contact:"contact.{n\
ame} = {value!r} is {relative:.3g} {unit} of this hoop and must be {words} of it.",too_soft:"contact.stiffness = {stiffness!r} lets the rim sink some {depth:.0e\
} radii into the plane, at the speed of the start, and must be high enough for at most {most:g}.",no_parameter:"{path} is not a parameter of a scenario; known a\
re {known}.",no_section_parts:"{path} is not a parameter of a scenario: {section} has no parts.",two_ways:"{one} = {one_value!r} and {other} = {other_value!r} c\
annot be given together.",not_there:"{path} is not there to be replaced: the scenario has no {step!r}.",unreadable_query:"The query cannot be read: {reason}.",value_above:"\
{path} cannot be given together with a value for {above}.",given_twice:"{path} is given twice.",parts_out_of_order:"hoop.parts.{name} is out of order: parts are\
 numbered from 0 without a gap."},words:{letters:"RSKHM",modes:["roll","spin","skid","flight","skim"],verbs:{roll:"rolls",spin:"spins",skid:"skids",flight:"flie\
s",skim:"skims the plane"},events:{start:{verb:"starts",label:"start",summed_up:!0},slip_start:{verb:"slips",label:"slip starts",summed_up:!0},stick:{verb:"roll\
s",label:"slip ends",summed_up:!0},slip_reversal:{verb:"slips the other way",label:"slip reverses",summed_up:!0},takeoff:{verb:"hops",label:"take-off",summed_up:!0},
impact:{verb:"lands",label:"landing",summed_up:!0},turn:{verb:"turns back",label:"turns back",summed_up:!1},apex:{verb:"is highest",label:"highest point",summed_up:!1},
bounce_limit:{verb:"stops bouncing",label:"bounces end",summed_up:!0},painleve_inconsistent:{verb:"meets Painlevé's paradox",label:"Painlevé: no solution",summed_up:!0},
painleve_indeterminate:{verb:"meets Painlevé's indeterminacy",label:"Painlevé: several solutions",summed_up:!0},jam:{verb:"jams",label:"jam",summed_up:!0},kane_gain:{
verb:"gains energy (Kane)",label:"energy gain (Kane)",summed_up:!0},skim:{verb:"skims",label:"skimming starts",summed_up:!0},rest:{verb:"rests",label:"at rest",
summed_up:!0},end:{verb:"ends",label:"end",summed_up:!1}},signs:{jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"\
≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"↺",apex:"•"},statuses:{completed:"",at_rest:"It has come to rest.",jammed:"The normal force grow\
s without bound (dynamic jam): rigid-body mechanics has no motion beyond.",undetermined:"The model does not determine the motion beyond.",event_limit:"The limit\
 of events (contact.max_events), or of work for one motion, was reached before the end."},sequence:{R:"roll",S:"slip −",K:"slip +",H:"flight",M:"skim","+":"…"},
story:{start:"It {started} with the load at {where} and the centre at {speed} m/s.",started:"starts and {verb}",started_flight:"starts in the air",started_skim:"\
starts skimming",slip_start:"It {verb} at {where}; friction reaches its limit: the rim slides ahead.",slip_start_spin:"It {verb} at {where}; friction reaches it\
s limit: the rim turns too fast for its path.",stick:"It rolls again at {where}; the slip has stopped.",slip_reversal:"The slip reverses at {where}; it {verb}.",
takeoff:"It hops at {where}.",takeoff_and_landing:"It hops at {where}. It rises {top} and stays up for {time} s.",impact:"It lands at {where} with {speed} m/s d\
ownwards and {verb}.",impact_bounce:"It lands at {where} with {speed} m/s downwards and bounces.",impact_without_collision:"An impact without collision at {wher\
e} stops the slip; then it {verb}.",turn:"It turns back at {where}.",turn_in_slip:"It turns back at {where}, and {verb} now.",apex:"The centre is highest at {wh\
ere}: the gap is {gap}.",bounce_limit:"Infinitely many bounces end here, at {where}.",painleve_inconsistent:"Painlevé's paradox at {where}: no contact force agr\
ees with this slip.",painleve_indeterminate:"Painlevé's paradox at {where}: several contact forces agree with it.",jam:"Dynamic jam at {where}: the contact for\
ce grows without bound.",kane_gain:"Newton's law of impact has created {gain} J (Kane's example).",skim:"No contact force is left at {where}: the load falls fre\
ely and the rim skims the plane.",rest:"It rests at {where}.",rest_unstable:"It rests at {where}, which is not stable.",end:"",other:"{kind} at {where}.",more_bounces:"\
It bounces {count} more times.",left_out:"… and {count} more."},summary:{change:"{phrase} at {where}",bounces:"bounces",without_collision:"stops its slip at o\
nce",more_bounces:"and {count} more times",more_changes:", … ({count} more)",sentence:"{phrases}. {ending}"},theory:{first_slip:"Slips",first_hop:"Hops",immediate_hop:"\
Hops at once",needed_friction:"Friction for pure rolling",painleve:"Painlevé’s paradox",jam:"Dynamic jam",rest:"Rests stably",loss:"End of rolling",loss_by_friction:"\
at {where} friction reaches its limit",loss_of_contact:"at {where} the contact force is gone",would_slip:"would slip",would_hop:"would hop in its first turn",would_hop_at_once:"\
would hop at once",any_push:"{would}: any push is enough",any_speed:"{would}: at any speed",no_speed:"never, at any speed",above:"{would} above {speed} m/s",no_friction:"\
no friction keeps it rolling",friction_enough:"μ = {mu} would keep it rolling (enough here)",friction_short:"μ = {mu} would keep it rolling (more than there is\
)",never:"never",paradox_here:"from μ = {mu} on, at {where}: possible here",paradox_not_here:"from μ = {mu} on, at {where}: not here",jam_at:"can end a slip a\
t {places}",rest_at:"with the load at {where}",uphill:"Slips, hops",no_threshold:"no single threshold uphill (β < 0): it depends on where the hoop turns back; s\
ee the map"},least_speed:1e-9},classes:{codes:{hop:{no:"#D9D9D9",yes:"#D55E00"},painleve:{no:"#D9D9D9",yes:"#000000"},ending:{duration:"#6E6E6E",revolutions:"#0\
072B2",reversal:"#009E73",takeoff:"#D55E00",rest:"#56B4E9",jam:"#000000",undetermined:"#F0E442",event_limit:"#CC79A7"},status:{completed:"#0072B2",at_rest:"#56B\
4E9",jammed:"#000000",undetermined:"#F0E442",event_limit:"#CC79A7"},first_event:{slip_start:"#E69F00",stick:"#0072B2",slip_reversal:"#CC79A7",takeoff:"#D55E00",
impact:"#F0E442",turn:"#009E73",jam:"#000000",rest:"#D9D9D9",end:"#56B4E9"}},families:{SR:"#009E73",SS:"#F0E442",SK:"#E69F00",KR:"#CC79A7",KS:"#8C6BB1",KK:"#F2B\
5D4"},massless:{rolls:"#F0E442","rolls, slips":"#E69F00","":"#009E73",slips:"#CC79A7"},hops:"#D55E00",rolls:"#0072B2",other:"#6E6E6E"},map:{events:2e3,flight_turns:2e3,
allowed:{"hoop.load_fraction":{least:0,most:1,words:"from 0 to 1"},"hoop.eccentricity":{least:0,most:1,words:"from 0 to 1"},"hoop.inertia_ratio":{least:1e-12,most:1e6,
words:"0 or from 1e-12 to 1e+06",also:[0]},"hoop.radius":{least:1e-6,most:1e6,words:"from 1e-06 to 1e+06"},"hoop.mass":{least:1e-12,most:1e12,words:"from 1e-12 \
to 1e+12"},"plane.mu":{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]},"plane.mu_static":{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:[
"inf"]},"plane.mu_kinetic":{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]},"plane.slope":{least:-1.57,most:1.57,words:"from -1.57 to 1.57"},"pla\
ne.gravity":{least:1e-6,most:1e6,words:"0 or from 1e-06 to 1e+06",also:[0]},"plane.restitution":{least:0,most:1,words:"from 0 to 1"},"plane.rolling_resistance":{
least:0,most:1,words:"from 0 to 1"},"start.speed":{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06"},"start.angle":{least:-1e6,most:1e6,words:"from -1e+06 to 1e\
+06"},"start.x":{least:-1e9,most:1e9,words:"from -1e+09 to 1e+09"},"start.height":{least:0,most:1e6,words:"from 0 to 1e+06"},"start.vx":{least:-1e6,most:1e6,words:"\
from -1e+06 to 1e+06"},"start.vy":{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06"},"start.omega":{least:-1e9,most:1e9,words:"from -1e+09 to 1e+09"},duration:{
least:1e-9,most:1e9,words:"from 1e-09 to 1e+09"},"contact.stiffness":{least:1e-6,most:1e18,words:"from 1e-06 to 1e+18"},"contact.slip_speed":{least:1e-12,most:1e6,
words:"from 1e-12 to 1e+06"},"contact.restitution":{least:0,most:1,words:"from 0 to 1"},"contact.damping":{least:0,most:1e12,words:"from 0 to 1e+12"},"contact.t\
angential_stiffness":{least:1e-6,most:1e18,words:"from 1e-06 to 1e+18"},"contact.rtol":{least:1e-10,most:.1,words:"from 1e-10 to 0.1"},"contact.max_events":{least:1,
most:1e7,words:"from 1 to 1e+07"},"hoop.parts.mass":{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12"},"hoop.parts.length":{least:1e-12,most:1e6,words:"from 1e\
-12 to 1e+06"}},rates:{"hoop.eccentricity":"eccentricity","hoop.inertia_ratio":"inertia_ratio","hoop.radius":"radius","hoop.mass":"mass","plane.mu_static":"mu_s\
tatic","plane.mu_kinetic":"mu_kinetic","plane.slope":"slope","plane.gravity":"gravity","plane.restitution":"restitution","plane.rolling_resistance":"rolling_res\
istance","start.angle":"angle","start.x":"x","start.height":"height","start.vy":"vy","start.omega":"omega",duration:"duration"},quantities:{sequence:{label:"wha\
t happens in the first turn",span:"first_revolution",unit:"",words:[]},hop_height:{label:"height of the first hop",span:"takeoff",unit:"m",words:[]},takeoff_angle:{
label:"angle of take-off",span:"takeoff",unit:"rad",words:[]},flight_time:{label:"duration of the first hop",span:"takeoff",unit:"s",words:[]},greatest_utilization:{
label:"greatest friction utilization",span:"first_revolution",unit:"1",words:[]},energy_lost:{label:"energy lost",span:"duration",unit:"J",words:[]},end_angle:{
label:"angle at the end",span:"duration",unit:"rad",words:[]},painleve:{label:"Painlevé’s paradox or jam met",span:"duration",unit:"",words:["no","yes"]},ending:{
label:"how it ends",span:"duration",unit:"",words:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"]}}},lab:{too_long:"du\
ration = {duration:g} must be at most {most:g} s in the lab; the library itself has no such limit.",too_many_parts:"hoop.parts has {parts} parts and must have a\
t most {most} in the lab.",too_many_turns:"duration = {duration:g} s at this speed and radius is about {turns:.0e} revolutions and must be at most {most:.0e} in\
 the lab; the library itself has no such limit.",too_stiff:"contact.stiffness, contact.slip_speed and duration need about {steps:.0e} steps of integration and m\
ust need at most {most:.0e} in the lab.",too_many_changes:"changes has {pairs} pairs and must have at most {most} in the lab.",too_many_cells:"x.cells times y.c\
ells = {cells} must be at most {most} in the lab.",equal_axes:"x.path and y.path are both {path!r} and must differ.",two_axes:"{one} and {other} cannot both be \
axes: they say the same thing in two ways.",rigid_maps:"contact.model = 'compliant' must be 'rigid' for a map.",cell_turns:"A cell of this map is about {turns:.\
0e} revolutions and must be at most {most:.0e} in the lab.",map_turns:"x and y make {cells} cells of about {turns:.2g} revolutions in all, and must be at most {\
most:.0e} in the lab; take fewer cells, lower speeds or a shorter duration.",doubt:"After {time} s the motion depends on more digits than this page computes. Ru\
n it in hophoop lab or Python for the exact result.",compliant_changes:"With a compliant contact no derivatives are computed: choose the rigid contact model.",not_a_pair:"\
changes holds {change}, which is not a pair of path and value.",window:"must be four numbers, θ from and to [rad], θ̇ from and to [rad/s], each pair rising",
times:"must be two times, from and to [s], rising from 0",number_path:"must be a number's path, not that of a word",one_of:"must be one of {known}"},reasons:{graze:"\
a quantity that sets off the event only touches zero there",border:"the motion lies on the border of two classes: the least change may lead to other events",plastic:"\
restitution is 0 and the rim has landed: with any restitution it would bounce",contact:"the motion starts in contact: with the rim lifted or thrown it would bou\
nce, and its events are others",singular:"the slip runs into p_σ = 0, where the contact force has no bound",massless:"the massless hoop (γ = 1) is a singular l\
imit once the contact force is lost",frictionless:"without friction the hoop rests on no more than a border of two classes",ended:"the motion has no answer from\
 there on",edge:"the parameter is at the edge of what is allowed",sided:"the derivatives of the two sides differ"},limits:{duration:600,events:2e4,parts:64,samples:20001,
cells:65536,turns:2e5,map_turns:4e6,steps:3e6,changes:200},table:{rate:200,variables:{mode:"1",x:"m",height:"m",angle:"rad",vx:"m/s",vy:"m/s",omega:"rad/s",slip:"\
m/s",friction_force:"N",normal_force:"N",kinetic:"J",potential:"J",total:"J",friction:"J",impact_normal:"J",impact_tangential:"J",rolling_resistance:"J",spring:"\
J",damping:"J"}},shown:["hoop.load_fraction","hoop.eccentricity","hoop.inertia_ratio","hoop.radius","hoop.mass","plane.mu","plane.mu_static","plane.mu_kinetic",
"plane.slope","plane.gravity","plane.restitution","plane.rolling_resistance","start.speed","start.angle","start.height","start.vx","start.vy","start.omega"]};var S=ii,ut=s=>s==="inf"?1/0:s;var{codes:zl,families:Nl,massless:Dl,hops:Ol,rolls:Il,other:ql}=S.classes,{sequence:Fl}=S.words,ai="sequence",Hl=s=>[...s].reduce((e,t)=>(131*e+t.charCodeAt(0))%
997,0)/997;function ri(s,e){if(e!==ai)return zl[e]?.[s]??ql;let t=/[SK]/.exec(s)?.[0]??"R",n=[s.startsWith("R")&&"rolls",/[SK]/.test(s)&&"slips"].filter(Boolean).
join(", "),o=s.endsWith("H")?Ol:Nl[t+s.slice(-1)]??Il,i=s.includes("M")?Dl[n]:o,a=[1,3,5].map(p=>Number.parseInt(i.slice(p,p+2),16)/255),r=(a[0]+a[1]+a[2])/3,l=Math.
min(s.length-1,9)/9,c=.2*Hl(s),m=.62-.62*Math.min(2*l,1),h=Math.max(2*l-1,0)*.5;return`#${a.map(p=>{let f=(1-c)*p+c*r;return Math.round(255*(f+(1-f)*m)*(1-h)).toString(
16).padStart(2,"0")}).join("")}`}function li(s,e){return e!==ai?s.replaceAll("_"," "):[...s].map(t=>Fl[t]).join(" → ")}function Z({duration:s,hoop:e,plane:t,start:n,contact:o}){let{radius:i,mass:a,eccentricity:r,inertia_ratio:l}=e,{mu:c,apart:m,...h}=t,{x:d,height:p,angle:f,vx:g,
vy:b,omega:w,slip:y}=me(n,i),{max_events:v,model:E,...T}=o;return{radius:i,mass:a,eccentricity:r,inertia_ratio:l,ideal:e.load_fraction!==null,...h,x:d,height:p,
angle:f,vx:g,vy:b,omega:w,slip:y,rolling:n.speed!==null,duration:s,max_events:v,contact:E==="rigid"?null:T}}function me({x:s,height:e,angle:t,speed:n,vx:o,vy:i,
omega:a},r){let l=n===null?Number(a):n/r;return{x:s,height:e,angle:t,vx:o,vy:i,omega:l,slip:n===null?o-r*l:0}}var jl=/^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i,Bl=/^\s*([+-]?)(inf|infinity|nan)\s*$/i;function xe(s){return Number.isNaN(s)?"nan":String(s).replace("Infi\
nity","inf")}var fs=s=>xe(s).replace(/^-?\d+$/,"$&.0");function _e(s,e=6){if(!Number.isFinite(s))return xe(s);let t=s!==0&&Math.abs(s)<1e-4,[n,...o]=(t?s.toExponential(
e-1):s.toPrecision(e)).split("e");return[n.includes(".")?n.replace(/\.?0+$/,""):n,...o].join("e")}var gs=(s,e)=>Number.isFinite(s)?s.toFixed(e):xe(s),$l={g:(s,e)=>_e(
s,e||6),e:(s,e)=>s.toExponential(e),f:gs};function O(s,e){return s.replace(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g,(t,n,o,i,a)=>{let r=e[n];return a?$l[a](r,Number(
i)):o?bs(r):String(r)})}function bs(s){return typeof s=="number"?xe(s):typeof s=="string"?Bt(`'${s}'`):s==null?"None":Bt(JSON.stringify(s))}var hi=s=>s.replace(
/[\p{C}\p{Zl}\p{Zp}]/gu,e=>`\\u{${e.codePointAt(0)?.toString(16)}}`);function Bt(s){let e=[...s];return e.length<=60?s:`${e.slice(0,57).join("")}...`}function ci(s){
if(jl.test(s))return Number(s);let[,e,t]=Bl.exec(s)??[];if(t)return t[0].toLowerCase()==="n"?Number.NaN:e==="-"?-1/0:1/0}var{texts:ui,scenario:di}=S,Wl=2,C=class extends Error{constructor(e){super(hi(e)),this.name="InputError"}},ee=class extends C{},N=(s,e={})=>O(ui[s],e),pe=s=>s!==
null&&typeof s=="object"&&!Array.isArray(s),Fe=(s,e,t,n)=>N("finding",{path:s||ui.whole_scenario,shown:bs(e),allowed:N(t,n)});function ys(s,e,t,n){let{fields:o,
place:i}=di.models[s],a=pe(e)?vs(i,e,Object.keys(o)):Fe(t,e,"table");if(a&&n.push(a),a)return null;let r=n.length,l={};for(let[c,m]of Object.entries(o))Object.hasOwn(
e,c)?l[c]=ks(m,e[c],`${t}.${c}`,n):m.required?n.push(N("missing",{path:`${t}.${c}`})):l[c]=ut(m.default);return n.length===r?{values:l,given:new Set(Object.keys(
e))}:null}function vs(s,e,t){let n=Object.keys(e).find(r=>!t.includes(r));if(n===void 0)return null;let[o]=[...t].sort((r,l)=>ws(n,r)-ws(n,l)),a=ws(n,o)<=Wl?N("\
did_you_mean",{close:o}):N("known_are",{known:t.join(", ")});return N("unknown_key",{path:`${s}${Bt(n)}`,hint:a})}function ws(s,e){let t=Array.from({length:e.length+
1},(n,o)=>o);for(let[n,o]of[...s].entries()){let i=[n+1];for(let a=0;a<e.length;a++)i.push(Math.min(i[a]+1,t[a+1]+1,t[a]+ +(o!==e[a])));t=i}return t[e.length]}function ks(s,e,t,n){
if(e===null&&s.nullable)return null;if(s.kind==="parts")return Kl(e,t,n);let o=s.kind==="friction"&&e==="inf"?1/0:e,i=Ul(s,o);return i&&n.push(Fe(t,e,...i)),typeof o==
"number"?o+0:o}var Gl={greater_than:(s,e)=>s>e,greater_than_equal:(s,e)=>s>=e,less_than_equal:(s,e)=>s<=e};function Ul(s,e){let{kind:t,options:n,limits:o=[],range:i}=s;
if(t==="word")return n.includes(e)?null:["literal_error",s];if(typeof e!="number")return["number"];if(t==="friction"&&!(e>=0))return["friction"];if(t==="whole"&&
!Number.isInteger(e))return["whole"];if(t!=="friction"&&!Number.isFinite(e))return["finite_number"];let a=o.find(([r,l])=>!Gl[r](e,l));return a?[a[0],{limit:a[1]}]:
i&&!xs(i,e)?["range",i]:null}var xs=({least:s,most:e,also:t=[]},n)=>s<=n&&n<=e||t.some(o=>ut(o)===n);function Kl(s,e,t){if(!Array.isArray(s))t.push(Fe(e,s,"list"));else
return s.map((n,o)=>Vl(n,`${e}.${o}`,t))}function Vl(s,e,t){let n=_s(s,"shape",di.parts,e,t),o=n&&ys(n,s,e,t);if(!o)return null;let{inner_radius:i,outer_radius:a}=o.
values;return i>a&&t.push(N("ring_radii",{inner:i,outer:a})),o.values}function _s(s,e,t,n,o,i){let a=pe(s)&&Object.hasOwn(s,e)?s[e]:i;if(!pe(s))o.push(Fe(n,s,"t\
able"));else if(a===void 0)o.push(N("missing",{path:`${n}.${e}`}));else{if(typeof a=="string"&&Object.hasOwn(t,a))return t[a];{let r=Object.keys(t).map(l=>`'${l}\
'`).join(" or ");o.push(Fe(`${n}.${e}`,a,"literal_error",{expected:r}))}}return null}function Es(s){let e=s.length-1;return e?N(e===1?"other_problem":"other_pro\
blems",{first:s[0].replace(/\.$/,""),count:e}):s[0]}var pi=new Map(Object.entries(S.scenario.ends));function Ss(s){let[e,...t]=s.split(".");return[e,t.join(".")]}function dt(s){for(let e of s){let t=(pi.get(e)??[]).
map(o=>`${Ss(e)[0]}.${o}`),n=s.find(o=>t.some(i=>o===i||o.startsWith(`${i}.`)));if(n!==void 0)return[e,n]}return null}function mi(s){let[e,t]=Ss(s);return(e==="\
start"?10:0)+(t===""?0:s==="contact.model"||s==="hoop.parts"?1:2)}function fi(s,e,t,n){let o=[...t.keys()],i=dt(o);if(i){let[r,l]=i;throw new C(N("two_ways",{one:r,
other:l,one_value:t.get(r),other_value:t.get(l)}))}let a=new Set;for(let r of o.sort((l,c)=>mi(l)-mi(c))){let l=structuredClone(t.get(r)),[c,m]=Ss(r);if(m==="")
Ms(e,c,l);else if(r==="contact.model")e.contact={model:l};else{Object.hasOwn(e,c)||Ms(e,c,{});let h=e[c];if(!pe(h))throw new C(N("no_section_parts",{path:r,section:c}));
let d=pi.get(r)??[];if(!a.has(c)&&d.some(p=>Object.hasOwn(h,p))){a.add(c);let p=t.has(c)?n(c,t.get(c)):s[c],f=Jl(p,r,()=>n("hoop",e.hoop));for(let[g,b]of Object.
entries(f))t.has(`${c}.${g}`)||(h[g]=b)}for(let p of d)delete h[p];Yl(h,m.split("."),l,r)}}return e}var Ms=(s,e,t)=>Object.defineProperty(s,e,{value:t,enumerable:!0,
configurable:!0,writable:!0});function Jl(s,e,t){let{mass:n,eccentricity:o,inertia_ratio:i,mu_static:a,mu_kinetic:r}=s;if(e==="hoop.load_fraction")return{mass:n};
if(e==="hoop.eccentricity"||e==="hoop.inertia_ratio")return{mass:n,eccentricity:o,inertia_ratio:i};if(e==="plane.mu_static"||e==="plane.mu_kinetic")return{mu_static:a,
mu_kinetic:r};if(!e.startsWith("start.")||e==="start.speed")return{};let{height:l,vx:c,vy:m,omega:h}=me(s,t().radius);return{height:l,vx:c,vy:m,omega:h}}function Yl(s,e,t,n){
let o=s;for(let[i,a]of e.entries()){let r=i===e.length-1;if(!(Array.isArray(o)&&/^\d+$/.test(a)&&Number(a)<o.length)&&!(pe(o)&&(r||Object.hasOwn(o,a))))throw new C(
N("not_there",{path:n,step:a}));r?Ms(o,a,t):o=o[a]}}var{lab:Zl,limits:Q}=S,{allowed:gi,events:Ql,flight_turns:Xl,quantities:eh}=S.map,th=1e-300,$=(s,e={})=>O(Zl[s],e),Ts=s=>$("doubt",{time:_e(s,4)});function Ee(s){
let{duration:e,hoop:t,contact:n}=s;if(e>Q.duration)throw new ee($("too_long",{duration:e,most:Q.duration}));let o=t.parts?.length??0;if(o>Q.parts)throw new ee($(
"too_many_parts",{parts:o,most:Q.parts}));let i=vi(yi(s));if(i>Q.turns)throw new ee($("too_many_turns",{duration:e,turns:i,most:Q.turns}));if(n.model==="complia\
nt"){let a=nh(s,i);if(a>Q.steps)throw new ee($("too_stiff",{steps:a,most:Q.steps}))}return n.max_events<=Q.events?s:{...s,contact:{...n,max_events:Q.events}}}function yi({
duration:s,hoop:{radius:e},plane:{gravity:t,slope:n},start:o}){let{height:i,vx:a,vy:r,omega:l}=me(o,e);return{duration:s,radius:e,gravity:t,slope:n,height:i,vx:a,
vy:r,omega:l}}function vi({duration:s,radius:e,gravity:t,slope:n,height:o,vx:i,vy:a,omega:r}){return(2*(Math.abs(i)+Math.abs(a)+e*Math.abs(r)+2*Math.sqrt(t*(e+o)))+
.5*t*Math.min(Math.abs(n),1)*s)*s/(2*Math.PI*e)}function nh({duration:s,hoop:{radius:e,mass:t},plane:{gravity:n},contact:{stiffness:o}},i){let r=10/Math.sqrt(e/
(n>0?n:1))+(o===null?0:Math.sqrt(o/t));return 10*s*r+40*i}function As(s,{x:e,y:t,what:n}){if(s.contact.model!=="rigid")throw new C($("rigid_maps"));let{contact:o,
...i}=Ee(s),a={...i,contact:{...o,max_events:Math.min(o.max_events,Ql)}};sh(a,e,t,eh[n].span);let r=dt([t.path,e.path]);if(r)throw new C($("two_axes",{one:r[0],
other:r[1]}));return a}function sh(s,e,t,n){let o=yi(s),i=n==="first_revolution",a=mt(e).filter(h=>wi(e.path,h)),r=mt(t).filter(h=>wi(t.path,h)),[l,c]=[0,0];for(let h of r)
for(let d of a){let p=bi(bi(o,t.path,h),e.path,d),g=i?1+Math.min(p.vx*p.vx/(10*o.gravity*o.radius+th),Xl):vi(p);l+=g,c=Math.max(c,g)}if(!i&&c>Q.turns)throw new ee(
$("cell_turns",{turns:c,most:Q.turns}));if(l<=Q.map_turns)return;let m=a.length*r.length;throw new ee($("map_turns",{cells:m,turns:l,most:Q.map_turns}))}function bi(s,e,t){
if(e==="start.speed")return{...s,vx:t,vy:0,omega:0};let n=e.slice(e.lastIndexOf(".")+1);return n in s&&n!=="height"?{...s,[n]:t}:s}var mt=({from:s,to:e,cells:t})=>Array.
from({length:t},(n,o)=>s+(o+.5)*((e-s)/t));function wi(s,e){return!gi[s]||xs(gi[s],e)}var oh=1e3;function ki(s){let e=s.replace(/^\?/,"");if(e.split("&").length>oh)throw new C(N("unreadable_query",{reason:"Max number of fields exceeded"}));let t=new Map;
for(let[i,a]of new URLSearchParams(`&${e}`)){let r=i.split("."),l=r.pop(),c=t;for(let m of r)if(c.has(m)||c.set(m,new Map),c=c.get(m),!(c instanceof Map))throw new C(
N("value_above",{path:i,above:i.replace(/\.[^.]*$/,"")}));if(c.has(l))throw new C(N("given_twice",{path:i}));c.set(l,ci(a)??a)}let n=t.get("hoop"),o=n instanceof
Map&&n.get("parts");return o instanceof Map&&n.set("parts",ih(o)),Ls(t)}function ih(s){let e=Array.from({length:s.size},(n,o)=>String(o)),t=[...s.keys()].find(n=>!e.
includes(n));if(t!==void 0)throw new C(N("parts_out_of_order",{name:t}));return e.map(n=>s.get(n))}function Ls(s){return Array.isArray(s)?s.map(Ls):s instanceof
Map?Object.fromEntries([...s].map(([e,t])=>[e,Ls(t)])):s}function Rs(s,e=""){return typeof s=="string"?`${e}=${s}`:typeof s=="number"?`${e}=${xe(s).replace("e+",
"e")}`:Object.entries(s).map(([t,n])=>Rs(n,e?`${e}.${t}`:t)).join("&")}var{scenario:Ps}=S,ah=Ps.rules,rh=["load_fraction","eccentricity","inertia_ratio"],xi=["mu_static","mu_kinetic"],lh=["height","vx","vy","omega"],_i={mass:1,inertia_ratio:1,
contact:null};function Wt(s,e,t){let[n,o]=t.refused(s),i=ah[n];if(!i)return null;let a=Object.entries(i.values).map(([r,l])=>{let[c,m]=l.split(".");return[r,e[c][m]]});
return N(i.sentence,{...i.known,...Object.fromEntries(a),[i.number]:o})}function $t(s,e,t,n){let o=n.find(i=>t.has(i));return o?N("together",{section:s,other:o,
way:e}):null}var Ei={hoop:hh,plane:ch,start:uh,contact:dh};function hh(s,e,t){let n=rh.filter(o=>e.has(o)&&s[o]!==null);if(s.parts){let o=s.parts.length?$t("hoo\
p","parts",e,[...n,"mass"]):N("no_parts");if(o)return o;let{radius:i,parts:a}=s,{reaches:r,...l}=t.combine(i,a),c=r.findIndex(m=>m>i*(1+Ps.touch));if(c>=0)return N(
"beyond_the_rim",{index:c,shape:a[c].shape,reach:r[c],radius:i});Object.assign(s,l)}else if(s.load_fraction!==null||!n.length){let o=$t("hoop","load_fraction",e,
n.slice(+(s.load_fraction!==null)));if(o)return o;s.load_fraction??=Ps.models.Hoop.fields.eccentricity.default,s.eccentricity=s.load_fraction,s.inertia_ratio=t.
ideal(s.load_fraction)}else if(n.length===1){let o=n[0]==="eccentricity"?"inertia_ratio":"eccentricity";return N("half_a_hoop",{missing:o,given:n[0]})}return Wt(
{..._i,...s,ideal:s.load_fraction!==null},{hoop:s},t)}function ch(s,e,t){if(s.apart=xi.some(n=>e.has(n)),s.mu!==null){let n=$t("plane","mu",e,xi);if(n)return n;
s.mu_static=s.mu_kinetic=s.mu}else s.mu_static===s.mu_kinetic&&(s.mu=s.mu_static);return Wt({..._i,...s},{plane:s},t)}function uh(s,e){return s.speed===null?s.omega===
null?N("no_omega"):null:(s.vx=s.speed,s.omega=null,$t("start","speed",e,lh))}function dh({damping:s=null,restitution:e=null}){return s!==null&&e!==null?N("toget\
her",{section:"contact",other:"restitution",way:"damping"}):null}var{scenario:fe}=S,Mi=fe.left_out,Si={rigid:"Rigid",compliant:"Compliant"};function ft(s,e){let{fields:t,place:n}=fe.models.Scenario,o=pe(s)?vs(n,s,Object.keys(
t)):Fe("",s,"table");if(o)throw new C(o);let i=[],a=Object.keys(t).map(c=>{let m=Object.hasOwn(s,c)?s[c]:fe.default[c];return[c,zs(c,m,e,i)]}),r=Object.fromEntries(
a),l=i.length?Es(i):Wt(Z(r),r,e);if(l)throw new C(l);return r}function zs(s,e,t,n){if(s==="duration")return ks(fe.models.Scenario.fields[s],e,s,n);let[o]=s==="c\
ontact"?[_s(e,"model",Si,s,n,"rigid")]:fe.sections[s],i=o&&ys(o,e,s,n),a=i&&Ei[s](i.values,i.given,t);return a&&n.push(a),i?.values}var gt=(s,e)=>ft(ki(s),e),Ut=(s,e,t)=>ft(
Ti(s,e,t),t);function Ti(s,e,t){return fi(s,Le(s),e,(n,o)=>{let i=[],a=zs(n,o,t,i);if(i.length)throw new C(Es(i));return a})}function Ai(s,e,t){let n=[];try{let o=Ti(
s,e,t),a=[...new Set([...e.keys()].map(r=>r.split(".")[0]))].map(r=>[r,zs(r,o[r],t,n)]);return n.length?null:Object.fromEntries(a)}catch(o){if(o instanceof C)return null;
throw o}}var pt=(s,e)=>Object.fromEntries(e.filter(t=>s[t]!==null).map(t=>[t,s[t]===1/0?"inf":s[t]])),Cs=s=>Object.keys(fe.models[s].fields);function Le({duration:s,
hoop:e,plane:t,start:n,contact:o}){let i=t.apart?["mu"]:["mu_static","mu_kinetic"],a=l=>l in Mi&&t[l]===Mi[l],r=["x","height","angle","vx","vy","omega"];return{
duration:s,hoop:mh(e),plane:pt(t,Cs("Plane").filter(l=>!i.includes(l)&&!a(l))),start:pt(n,n.speed===null?r:["x","angle","speed"]),contact:pt(o,Cs(Si[o.model]))}}
function mh(s){if(s.parts){let t=s.parts.map(n=>pt(n,Cs(fe.parts[n.shape])));return{radius:s.radius,parts:t}}let e=s.load_fraction===null?["eccentricity","inert\
ia_ratio"]:["load_fraction"];return pt(s,["radius","mass",...e])}function Ns(s,e){if(s==="hoop"||s==="plane")return fe.default[s];let{fields:t}=fe.models[s==="s\
tart"?"Start":e==="compliant"?"Compliant":"Rigid"];return Object.fromEntries(Object.entries(t).map(([n,o])=>[n,o.default??void 0]))}function bt(s){let e={};for(let[
t,n]of Object.entries(Le(s))){if(Gt(n,fe.default[t]))continue;let o=pe(n)?Ns(t,n.model):{},i=Object.entries(n).filter(([a,r])=>a==="model"||!Gt(o[a],r));e[t]=pe(
n)&&i.length?Object.fromEntries(i):n}return Rs(e)}var Gt=(s,e)=>JSON.stringify(s)===JSON.stringify(e);var ph=8,{quantities:Li}=S.map;async function Ds(s,{x:e,y:t},n,o){let[i,a]=[mt(e),mt(t)],r=(...f)=>Ai(s,new Map(f),n),l=fh(s,e.path,t.path),c=l&&i.map(f=>r([e.path,
f])),m=l&&a.map(f=>r([t.path,f])),h=i.length*a.length,d=new Float64Array(ht.length*h),p=performance.now();for(let f=0;f<h;f++){let g=f%i.length,b=(f-g)/i.length;
g===0&&performance.now()-p>ph&&(await new Promise(E=>setTimeout(E)),o?.throwIfAborted(),p=performance.now());let w=c?c[g]:r([t.path,a[b]],[e.path,i[g]]),y=m?m[b]:
w;if(!w||!y)continue;let v=Z({...s,...w,...y});for(let E=0;E<ht.length;E++)d[E*h+f]=ht[E](v)}return{count:h,rows:d}}function fh({start:s},e,t){let n=[e,t].map(i=>i.
split(".")[0]);if(n[0]===n[1])return!1;let o=[e,t].some(i=>i.startsWith("start.")&&i!=="start.speed");return!(n.includes("hoop")&&o&&s.speed!==null)}var Os=s=>Li[s].
span;function Is({x:s,y:e,what:t},n){let{label:o,unit:i,words:a}=Li[t],{values:r,names:l}=gh(n,i===""?a:null),c=m=>({name:m,text:li(m,t),color:ri(m,t)});return{
header:{x:s,y:e,what:t,label:o,unit:i,classes:i===""?l.map(c):null},arrays:{values:r}}}function gh({values:s,sequences:e},t){if(!t)return{values:s,names:[]};let n=e?
[...e].sort((a,r)=>a.length-r.length||(a<r?-1:1)):t,o=e?.map(a=>n.indexOf(a));return{values:Float64Array.from(s,a=>a>=0?o?.[a]??a:Number.NaN),names:n}}var{scenario:wt}=S,bh=30,zi={};for(let{fields:s}of Object.values(wt.models))Object.assign(zi,s);function Ni(s,e){return typeof e=="string"?JSON.stringify(e):zi[s]?.
kind==="whole"?String(e):fs(e)}function Ri(s,e,t){if(Array.isArray(t)){let a=r=>Object.entries(r).map(([l,c])=>`${l} = ${Pi(l,c)}`);return[`${e} = [`,...t.map(r=>`\
  { ${a(r).join(", ")} },`),"]"].join(`
`)}let n=`${e} = ${Pi(e,t)}`,i=(wt.sections[s]??["Scenario"]).map(a=>wt.models[a].fields).find(a=>e in a)[e].unit;return i===""||i==="1"?n:`${n.padEnd(bh)} # ${i}`}
var Pi=(s,e)=>e==="inf"?"inf":Ni(s,e);function Kt(s){let{duration:e,...t}=Le(s),n=[Ri("","duration",e)];for(let[o,i]of Object.entries(t))n.push("",`[${o}]`,...Object.
entries(i).map(([a,r])=>Ri(o,a,r)));return`${n.join(`
`)}
`}var wh={hoop:"Hoop",plane:"Plane",start:"Start"},yh=["load_fraction","mu"];function qs(s){let{duration:e,contact:t,...n}=Le(s),o=Object.entries(n).map(([i,a])=>Ci(
i,a));return Gt(t,wt.default.contact)||o.push(`contact=${Ci("contact",t)}`),o.splice(3,0,`duration=${fs(e)}`),`import hophoop as hh

motion = hh.simulate(
${o.map(i=>`    ${i},
`).join("")})
print(motion.sequence, motion.status)
for event in motion.events:
    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")
`}function Ci(s,{parts:e,...t}){let n=s==="start"&&"speed"in t,o=n?"Start.rolling":wh[s]??(t.model==="rigid"?"Rigid":"Compliant"),i=n?{angle:0,x:0}:Ns(s,t.model),
a=Object.entries(t).filter(([l,c])=>yh.includes(l)||i[l]!==c),r=e?[`parts=[${e.map(vh).join(", ")}]`]:[];return`hh.${o}(${[...a.map(Di),...r].join(", ")})`}var vh=({
shape:s,...e})=>`hh.${wt.parts[s]}(${Object.entries(e).map(Di).join(", ")})`,Di=([s,e])=>`${s}=${e==="inf"?'float("inf")':Ni(s,e)}`;var{letters:Ii,modes:Hs,verbs:js,events:kh,statuses:xh,story:He,summary:Ye}=S.words,_h=400,[,Fs,Oi,Eh,Mh]=Hs,Sh="⁰¹²³⁴⁵⁶⁷⁸⁹";function qi(s,e){let{
omega:t,to:n}=s[e];return t===0&&(n==="S"||n==="K")&&e+1<s.length}var Bs=s=>[...s.keys()].filter(e=>qi(s,e)),$s=(s,e)=>.5*(s[e].t+s[e+1].t);function Ws(s,e=_h){
let t=[],n=0,o=Hi(s.events);for(let[i,a]of s.events.entries()){let r=o.get(i);if(r===0)continue;let l=r===void 0?Ah(s,i,a):O(He.more_bounces,{count:r});if(l){if(t.
length>=e){n++;continue}t.push({t:a.t,event:i,mode:Ii[Hs.indexOf(Vt(s,i))],text:l})}}return n&&t.push({...t[t.length-1],text:O(He.left_out,{count:n})}),t}var Fi=s=>s.
kind==="impact"&&s.to==="H"&&s.collision!==!1;function Hi(s,e=3,t=6){let n=new Map,o=[];for(let i=0;i<=s.length;i++){let a=s[i];if(a&&(Fi(a)||o.length&&a.kind===
"apex")){o.push(i);continue}let r=o.filter(l=>s[l].kind==="impact");if(r.length>=t){for(let l of o.slice(o.indexOf(r[e])))n.set(l,0);n.set(r[e],r.length-e)}o=[]}
return n}function Gs(s,e=6){let t=[],n=0,o=Hi(s.events,1);for(let[l,c]of s.events.entries()){let m=o.get(l);if(m!==void 0){m&&t.push(O(Ye.more_bounces,{count:m}));
continue}if(c.kind==="start"||!t.length){t.push(js[Vt(s,l)]);continue}let h=Th(s,l,c);h&&(n++,n<=e&&t.push(O(Ye.change,{phrase:h,where:Be(c.angle)})))}let i=n>e?
O(Ye.more_changes,{count:n-e}):"",a=t.join(", ").replaceAll(", and "," and ")+i,r={phrases:a.slice(0,1).toUpperCase()+a.slice(1),ending:xh[s.status]};return O(Ye.
sentence,r).trim()}function Th(s,e,t){if(t.collision===!1)return Ye.without_collision;if(Fi(t))return Ye.bounces;if(["slip_start","slip_reversal"].includes(t.kind)||
ji(t))return js[Vt(s,e)];let{verb:n,summed_up:o}=kh[t.kind];return o?n:""}function Ah(s,e,t){let n=Vt(s,e),o={where:Be(t.angle),verb:js[n],kind:t.kind.replaceAll(
"_"," ")},i=Lh(s.events,e,n,o);return O(He[i]??He.other,o)}function Lh(s,e,t,n){let o=s[e],{kind:i}=o;return i==="start"&&(n.speed=je(o.vx),n.started=O(t===Eh?He.
started_flight:t===Mh?He.started_skim:He.started,n)),i==="slip_start"&&t===Fs?"slip_start_spin":i==="takeoff"?Rh(s,e,n):i==="impact"?(n.speed=je(o.before.vy===null?
null:Math.abs(o.before.vy)),o.collision===!1?"impact_without_collision":o.to==="H"?"impact_bounce":i):i==="turn"&&ji(o)?"turn_in_slip":(i==="apex"&&(n.gap=Bi(o.
height)),i==="kane_gain"&&(n.gain=je(o.gain)),i==="rest"&&o.stable===!1?"rest_unstable":i)}function Rh(s,e,t){let{t:n}=s[e],o=0;for(let i=e;i<s.length;i++)if(o=
Math.max(o,s[i].height),!(i===e||s[i].kind!=="impact")){for(let a=i+1;a<s.length&&s[a].t<=s[i].t;a++)o=Math.max(o,s[a].height);if(!o)break;return t.top=Bi(o),t.
time=je(s[i].t-n),"takeoff_and_landing"}return"takeoff"}function Vt(s,e){let t=s.events[e];return Ph(t.to,qi(s.events,e)?s.omega(e):t.omega)}function Ph(s,e){return s===
"S"?e>0?Fs:Oi:s==="K"?e<0?Fs:Oi:Hs[Ii.indexOf(s)]}var ji=s=>s.kind==="turn"&&(s.to==="S"||s.to==="K"),Be=s=>`${gs(s*(180/Math.PI),1)}°`.replaceAll("-","−");function Bi(s){
return s>=.995?`${je(s)} m`:s>=.00995?`${je(s*100)} cm`:`${je(s*1e3)} mm`}function je(s){if(s===null||Number.isNaN(s))return"?";let[e,t]=_e(s,3).split("e"),n=t===
void 0?"":`·10${Ch(Number(t))}`;return`${e}${n}`.replaceAll("-","−")}var Ch=s=>[...String(s)].map(e=>e==="-"?"⁻":Sh[Number(e)]).join("");var $i=2e3;function Jt(s,{status:e,sequence:t,fingerprint:n,events:o,final:i,energy:a}){let{schema:r,setup:l}=S,c=Le(s);return{schema:r,version:l.version,scenario:c,
status:e,sequence:t,fingerprint:n,events:o,final:i,energy:a}}function Yt(s,e,t,n){let o={events:e.events,status:e.status,omega:t};return{...Jt(s,e),events:e.events.
slice(0,$i),query:bt(s),duration:e.duration,values:zh(s),automatic:Nh(s,n),massless:s.hoop.inertia_ratio===0,summary:Gs(o),story:Ws(o),ending:S.words.statuses[e.
status],shortened:e.events.length>$i}}function zh({hoop:s,plane:e,start:t}){let n={hoop:s,plane:e,start:{...me(t,s.radius),speed:t.speed}},o=S.shown.map(i=>{let[
a,r]=i.split("."),l=n[a][r];return[i,l===1/0?"inf":l]});return Object.fromEntries(o)}function Nh(s,e){if(s.contact.model==="rigid")return{};let{stiffness:t,slip_speed:n}=e.
chosen(Z(s)),{restitution:o}=s.plane;return{"contact.stiffness":t,"contact.slip_speed":n,"contact.restitution":o}}var{rate:Dh,variables:Us}=S.table,{letters:Oh}=S.words,Ks=(s,e)=>JSON.stringify(Jt(s,e),null,1);function Vs(s){let e=Math.min(Math.max(Math.floor(s*Dh)+1,2),S.limits.
samples),t=s/(e-1);return Float64Array.from({length:e},(n,o)=>o===e-1?s:o*t)}function Js(s,e){let t=Object.keys(Us),n=t.map(l=>Us[l]==="1"?l:`${l} [${Us[l]}]`),
{kinetic:o,potential:i}=e,a={...e,total:Float64Array.from(o,(l,c)=>l+i[c])},r=[["t [s]",...n].join(",")];for(let[l,c]of s.entries()){let m=t.map(h=>h==="mode"?Oh[a.
mode[l]]:xe(a[h][l]));r.push([xe(c),...m].join(","))}return`${r.join(`\r
`)}\r
`}var{limits:Zt}=S;function ne({scenario:s,query:e,changes:t=[]},n){let i=s!==void 0&&e===void 0?ft(s,n):gt(e??"",n),a=new Map;for(let[r,l]of t)dt([...a.keys(),r])&&
(i=Ut(i,a,n),a=new Map),a.set(r,l);return a.size?Ut(i,a,n):i}function Ys({scenario:s,query:e,changes:t=[],...n},o){if(t.length>Zt.changes)throw new ee($("too_ma\
ny_changes",{pairs:t.length,most:Zt.changes}));let{x:i,y:a}=n;if(i&&i.path===a.path)throw new C($("equal_axes",{path:i.path}));let r=i?i.cells*a.cells:0;if(r>Zt.
cells)throw new ee($("too_many_cells",{cells:r,most:Zt.cells}));return{...n,checked:ne({scenario:s,query:e,changes:t},o)}}var Ih=new Set(Object.keys(S.scenario.models.Scenario.fields)),qh=40,Qt=s=>new URLSearchParams(`&${s}`).keys().next().value??"",Wi=s=>!Qt(s).includes(".")&&!Ih.
has(Qt(s));function Zs(s,e){let t=s.replace(/^\?/,"").split("&").filter(Boolean),n=t.filter(l=>!Wi(l)),o=t.filter(Wi).map(Qt),i=l=>{try{return Ee(ne({query:l.join(
"&")},e)),null}catch(c){if(c instanceof C)return c;throw c}},a=i(n);return{query:(a?Fh(n,l=>!i(l)):n).join("&"),foreign:[...new Set(o)],error:a}}function Fh(s,e){
if(s.length>qh)return[];let t=new Map;for(let o of s){let i=Qt(o).split(".")[0];t.set(i,[...t.get(i)??[],o])}let n=[];for(let o of t.values()){let i=[...n,...Hh(
o,e)];e(i)&&(n=i)}return n}function Hh(s,e){let t=(...o)=>s.filter((i,a)=>!o.includes(a));return[s,...s.map((o,i)=>t(i)),...s.flatMap((o,i)=>s.map((a,r)=>t(i,r)))].
find(e)??[]}var jh=["hoop.eccentricity","plane.slope"],Bh={...Object.fromEntries(Object.entries(S.map.rates).map(([s,e])=>[s,()=>({[e]:1})])),"hoop.radius":$h,"hoop.mass":({
hoop:s})=>s.parts?null:{mass:1},"hoop.load_fraction":({hoop:{load_fraction:s}})=>s===null?null:{eccentricity:1,inertia_ratio:-2*s},"plane.mu":({plane:{mu:s}})=>s===
null||s===1/0?null:{mu_static:1,mu_kinetic:1},"plane.mu_static":({plane:s})=>s.mu_static===1/0?null:{mu_static:1},"plane.mu_kinetic":({plane:s})=>s.mu_kinetic===
1/0?null:{mu_kinetic:1},"plane.rolling_resistance":({hoop:s})=>s.inertia_ratio===0?null:{rolling_resistance:1},"start.speed":({hoop:s,start:e})=>e.speed===null?
null:{omega:1/s.radius},"start.vx":()=>({slip:1}),"start.omega":({hoop:s})=>({omega:1,slip:-s.radius})};function $h({hoop:{radius:s,parts:e,eccentricity:t,inertia_ratio:n},
start:{speed:o,omega:i}}){let a={radius:1};return o===null?a.slip=-(i||0):a.omega=-o/(s*s),e?{...a,eccentricity:-t/s,inertia_ratio:-2*n/s}:a}function Qs(s,e){let t=Bh[e]?.(
s),{smaller:n,larger:o}=Wh(s,e);if(!t||!(n||o))return null;let i=new Float64Array(x.cell.length);for(let[a,r]of Object.entries(t))i[ni[a]]=r;return{rates:i,smaller:n,
larger:o}}function Wh(s,e){let{mu_static:t,mu_kinetic:n}=s.plane,o=Gh(s,e),{least:i,most:a,also:r=[]}=S.map.allowed[e],l=t!==n,c=s.hoop.inertia_ratio===0&&jh.includes(
e);return{smaller:!c&&o>Math.min(i,...r.map(ut))&&(l||e!=="plane.mu_static"),larger:!c&&o<a&&(l||e!=="plane.mu_kinetic")}}function Gh(s,e){return e==="start.ome\
ga"?me(s.start,s.hoop.radius).omega:e.split(".").reduce((t,n)=>t[n],s)}var{theory:W}=S.words;function eo({hoop:s,plane:e},t){let n=[],o=(r,l,c,m)=>{l!==null&&n.push({key:r,label:W[r],value:Number.isFinite(l)?l:null,unit:c,text:m(l)})},
i=()=>o("painleve",t.painleve_friction,"1",r=>Kh(r,t,e));if(e.gravity<=0)return i(),n;if(s.inertia_ratio===0){let r=t.massless_loss_by_friction?W.loss_by_friction:
W.loss_of_contact;return o("loss",t.massless_loss_angle,"rad",l=>O(r,{where:Be(l)})),n}if(e.slope>=0){let{would_slip:r,would_hop:l,would_hop_at_once:c,any_push:m,
any_speed:h}=W;o("first_slip",t.first_slip_speed,"m/s",d=>Xs(d,r,m)),o("first_hop",t.first_hop_speed,"m/s",d=>Xs(d,l,m)),o("immediate_hop",t.immediate_hop_speed,
"m/s",d=>Xs(d,c,h))}else n.push({key:"uphill",label:W.uphill,value:null,unit:"",text:W.no_threshold});o("needed_friction",t.needed_friction,"1",r=>Uh(r,e)),i();
let a=t.jam_angles.map(Be).join(", ");return o("jam",t.jam_angles[0]??null,"rad",()=>O(W.jam_at,{places:a})),s.eccentricity>0&&o("rest",t.stable_angle,"rad",r=>O(
W.rest_at,{where:Be(r)})),n}function Xs(s,e,t){return s<S.words.least_speed?O(t,{would:e}):Number.isFinite(s)?O(W.above,{would:e,speed:_e(s,4)}):W.no_speed}function Uh(s,{
mu_static:e}){return Number.isFinite(s)?O(s<=e?W.friction_enough:W.friction_short,{mu:_e(s,3)}):W.no_friction}function Kh(s,{painleve_angle:e},{mu_kinetic:t}){if(e===
null)return W.never;let n=s<=t?W.paradox_here:W.paradox_not_here;return O(n,{mu:_e(s,3),where:Be(e)})}function Me(s){let e=Number.parseInt(s.slice(1,7),16);return[e>>16&255,e>>8&255,e&255]}var Gi=s=>yt(s)>.2?"#111111":"#ffffff",vt=(s,e)=>`rgba(${Me(s).join(",")}\
,${e})`,Jh=s=>{let e=s/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4};function yt(s){let[e,t,n]=Me(s).map(Jh);return .2126*e+.7152*t+.0722*n}function kt(s,e){
if(!e||!/^#[0-9a-f]{6}$/i.test(s))return s;if(yt(s)<.002)return"#eceef2";let t=s;for(let n=0;yt(t)<.2&&n<1;n+=.05)t=`#${Me(s).map(o=>Math.round(o+(255-o)*n).toString(
16).padStart(2,"0")).join("")}`;return t}var Xt=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function Yh(){let s=[];
for(let e=0;e<256;e++){let t=e/255*(Xt.length-1),n=Math.min(Math.floor(t),Xt.length-2),o=Me(Xt[n]),i=Me(Xt[n+1]);s.push(o.map((a,r)=>Math.round(a+(i[r]-a)*(t-n))))}
return s}var Ze=Yh(),en=Ze.map(s=>`rgb(${s.join(",")})`),Zh=["#123a8c","#8a6d00"],ge=(s,e)=>kt(Zh[s],e);var Re={roll:"Rollen",spin:"Durchdrehen",skid:"Rutschen",flight:"Flug",skim:"Streifen","slip −":"Schlupf −","slip +":"Schlupf +",rolls:"rollt",spins:"dreht \
durch",skids:"rutscht",flies:"fliegt","skims the plane":"streift die Ebene","rolls at {angle}":"rollt ab {angle}","spins at {angle}":"dreht ab {angle} durch","s\
kids at {angle}":"rutscht ab {angle}","flies at {angle}":"fliegt ab {angle}","skims the plane at {angle}":"streift ab {angle} die Ebene","hops at {angle}":"hüpf\
t bei {angle}","lands at {angle}":"landet bei {angle}","bounces at {angle}":"springt bei {angle} wieder ab","slips the other way at {angle}":"gleitet ab {angle}\
 in der anderen Richtung","stops its slip at once at {angle}":"hört bei {angle} schlagartig auf zu gleiten","turns back at {angle}":"kehrt bei {angle} um","sto\
ps bouncing at {angle}":"ist bei {angle} ausgesprungen","meets Painlevé's paradox at {angle}":"trifft bei {angle} auf das Painlevé-Paradoxon","meets Painlevé'\
s indeterminacy at {angle}":"trifft bei {angle} auf die Unbestimmtheit nach Painlevé","jams at {angle}":"verklemmt sich bei {angle}","gains energy (Kane) at {a\
ngle}":"gewinnt bei {angle} Energie (Kane)","skims at {angle}":"streift ab {angle}","rests at {angle}":"ruht bei {angle}","starts at {angle}":"beginnt bei {angl\
e}","slips at {angle}":"gleitet ab {angle}","{what} and {count} more times":"{what} und noch {count}-mal","… ({count} more)":"… (noch {count})","It has come\
 to rest.":"Er ist zur Ruhe gekommen.","The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.":"Die Normalkraft wächst \
über alle Grenzen (dynamisches Verklemmen): Die Mechanik starrer Körper kennt keine Bewegung darüber hinaus.","The model does not determine the motion beyond\
.":"Das Modell legt die weitere Bewegung nicht fest.","The limit of events (contact.max_events), or of work for one motion, was reached before the end.":"Die Gr\
enze der Ereignisse (contact.max_events) oder des Aufwands für eine Bewegung wurde vor dem Ende erreicht.","It starts and {verb} with the load at {angle} and t\
he centre at {speed} m/s.":"Er startet und {verb}, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It starts in the air with the load at {angle} and th\
e centre at {speed} m/s.":"Er startet in der Luft, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It starts skimming with the load at {angle} and the \
centre at {speed} m/s.":"Er streift zu Beginn die Ebene, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It {verb} at {angle}; friction reaches its lim\
it: the rim turns too fast for its path.":"Ab {angle} {verb} er: Die Reibung ist ausgeschöpft, der Rand dreht sich zu schnell für seinen Weg.","It {verb} at {\
angle}; friction reaches its limit: the rim slides ahead.":"Ab {angle} {verb} er: Die Reibung ist ausgeschöpft, der Rand gleitet voraus.","It rolls again at {a\
ngle}; the slip has stopped.":"Ab {angle} rollt er wieder; der Schlupf hat aufgehört.","The slip reverses at {angle}; it {verb}.":"Bei {angle} kehrt sich der S\
chlupf um; er {verb}.","It hops at {angle}.":"Er hüpft bei {angle}.","It hops at {angle}. It rises {height} and stays up for {time} s.":"Er hüpft bei {angle}. \
Er steigt {height} hoch und bleibt {time} s in der Luft.","An impact without collision at {angle} stops the slip; then it {verb}.":"Ein Stoß ohne Aufprall beend\
et bei {angle} den Schlupf; dann {verb} er.","It lands at {angle} with {speed} m/s downwards and bounces.":"Er landet bei {angle} mit {speed} m/s abwärts und sp\
ringt wieder ab.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Er landet bei {angle} mit {speed} m/s abwärts und {verb}.","It turns back at {a\
ngle}.":"Er kehrt bei {angle} um.","It turns back at {angle}, and {verb} now.":"Er kehrt bei {angle} um und {verb} jetzt.","The centre is highest at {angle}: th\
e gap is {height}.":"Bei {angle} ist der Mittelpunkt am höchsten: Der Spalt beträgt {height}.","Infinitely many bounces end here, at {angle}.":"Hier, bei {ang\
le}, enden unzählige Sprünge.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Painlevé-Paradoxon bei {angle}: Keine Kontaktkraft p\
asst zu diesem Schlupf.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Painlevé-Paradoxon bei {angle}: Mehrere Kontaktkräfte passen d\
azu.","Dynamic jam at {angle}: the contact force grows without bound.":"Dynamisches Verklemmen bei {angle}: Die Kontaktkraft wächst über alle Grenzen.","Newto\
n's law of impact has created {energy} J (Kane's example).":"Newtons Stoßgesetz hat {energy} J erzeugt (Beispiel von Kane).","No contact force is left at {angl\
e}: the load falls freely and the rim skims the plane.":"Bei {angle} ist keine Kontaktkraft mehr da: Die Last fällt frei, der Rand streift die Ebene.","It rest\
s at {angle}.":"Er ruht bei {angle}.","It rests at {angle}, which is not stable.":"Er ruht bei {angle}, aber nicht stabil.","It bounces {count} more times.":"Er\
 springt noch {count}-mal.","… and {count} more.":"… und noch {count}.",Slips:"Gleitet",Hops:"Hüpft","Hops at once":"Hüpft sofort","Friction for pure roll\
ing":"Reibung für reines Rollen","Painlevé’s paradox":"Painlevé-Paradoxon","Dynamic jam":"Dynamisches Verklemmen","Rests stably":"Ruht stabil","End of roll\
ing":"Ende des Rollens","would slip above {speed} m/s":"würde über {speed} m/s gleiten","would slip: any push is enough":"würde gleiten: jeder Stoß genügt",
"would hop in its first turn above {speed} m/s":"würde über {speed} m/s in der ersten Umdrehung hüpfen","would hop in its first turn: any push is enough":"wü\
rde in der ersten Umdrehung hüpfen: jeder Stoß genügt","would hop at once above {speed} m/s":"würde über {speed} m/s sofort hüpfen","would hop at once: at\
 any speed":"würde sofort hüpfen: bei jeder Geschwindigkeit","never, at any speed":"nie, bei keiner Geschwindigkeit","no friction keeps it rolling":"keine Rei\
bung hält ihn am Rollen","μ = {mu} would keep it rolling (enough here)":"μ = {mu} hielte ihn am Rollen (hier genug)","μ = {mu} would keep it rolling (more th\
an there is)":"μ = {mu} hielte ihn am Rollen (mehr als hier)",never:"nie","from μ = {mu} on, at {angle}: possible here":"ab μ = {mu}, bei {angle}: hier möglic\
h","from μ = {mu} on, at {angle}: not here":"ab μ = {mu}, bei {angle}: hier nicht","can end a slip at {angles}":"kann einen Schlupf bei {angles} beenden","wit\
h the load at {angle}":"mit der Last bei {angle}","at {angle} friction reaches its limit":"bei {angle} ist die Reibung ausgeschöpft","at {angle} the contact fo\
rce is gone":"bei {angle} ist die Kontaktkraft weg","Load fraction":"Massenanteil der Last","Share of the mass in the load of an ideal hoop":"Anteil der Last an\
 der Masse eines idealen Reifens",Eccentricity:"Exzentrizität","Distance of the centre of gravity from the centre, over the radius":"Abstand des Schwerpunkts v\
om Mittelpunkt, geteilt durch den Radius","Inertia ratio":"Bezogenes Trägheitsmoment","Moment of inertia about the centre of gravity over m R²":"Trägheitsmome\
nt um den Schwerpunkt, geteilt durch m R²",Radius:"Radius","Rim radius":"Radius des Randes",Mass:"Masse","Total mass":"Gesamtmasse",Friction:"Reibungszahl","Fr\
iction, static and kinetic":"Reibungszahl, Haft- und Gleitreibung","Static friction":"Haftreibungszahl","Kinetic friction":"Gleitreibungszahl",Slope:"Neigung","\
Slope of the plane, downhill along +x":"Neigung der Ebene, bergab in Richtung +x",Gravity:"Fallbeschleunigung",Restitution:"Stoßzahl","Restitution of an impact":"\
Stoßzahl eines Stoßes",Speed:"Geschwindigkeit","Velocity of the centre in a rolling start":"Geschwindigkeit des Mittelpunkts bei rollendem Start","Load angle":"\
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
es ist um den Faktor 2,46 langsamer.",Examples:"Beispiele","Examples …":"Beispiele …","Undo (z)":"Rückgängig (z)","Redo (y)":"Wiederholen (y)",Compare:"Ve\
rgleichen","Compare two hoops":"Zwei Reifen vergleichen","Dark or light (d)":"Dunkel oder hell (d)","Keys and help (?)":"Tasten und Hilfe (?)","Keys and help":"\
Tasten und Hilfe",lab:"Labor",Learn:"Lernen",Language:"Sprache","Hoop A":"Reifen A","Hoop B":"Reifen B","Which hoop the controls change":"Welchen Reifen die Reg\
ler ändern",Parameters:"Parameter","Skip to the player":"Zum Abspieler springen",Hoop:"Reifen",Plane:"Ebene",Start:"Start",Contact:"Kontakt","Given by":"Gegebe\
n durch","load fraction γ":"Massenanteil γ","ε and κ":"ε und κ","real parts":"wirkliche Teile",Where:"Wo",elsewhere:"anderswo","static and kinetic frictio\
n apart":"Haft- und Gleitreibung getrennt",Starts:"Startet",rolling:"rollend","in any state":"in beliebigem Zustand","auto {value}":"auto {value}","{name}, exac\
t value in {unit}":"{name}, genauer Wert in {unit}","{name}, exact value":"{name}, genauer Wert",Ring:"Ring",Disk:"Scheibe","Point mass":"Punktmasse",Rod:"Stab",
mass:"Masse","inner radius":"Innenradius","outer radius":"Außenradius",radius:"Radius","distance from centre":"Abstand vom Mittelpunkt",length:"Länge","Add a \
part":"Ein Teil hinzufügen","+ add a part …":"+ ein Teil hinzufügen …","Remove part {number}, {what}":"Teil {number} entfernen, {what}","{name} = {value} \
must be {rule}.":"{name} = {value} muss {rule} sein.","{name} = {value} must be a number, such as 2.5.":"{name} = {value} muss eine Zahl sein, etwa 2,5.","{name\
} = {value} must be a number.":"{name} = {value} muss eine Zahl sein.","from {least} to {most}":"von {least} bis {most}","from {least} to {most}, or inf":"von {\
least} bis {most} oder unendlich","0 or from {least} to {most}":"0 oder von {least} bis {most}","0 or from {least} to {most}, or inf":"0, von {least} bis {most}\
 oder unendlich","at most {most} in the lab":"im Labor höchstens {most}","0 for the massless hoop (hoop.inertia_ratio = 0)":"für den masselosen Reifen 0 (hoop.\
inertia_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"für den masselosen Reifen „rigid“ (hoop.inertia_ratio = 0)","The server does \
not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"Der Server antwortet nicht. Was hier ist, läuft weiter; für Änderungen muss\
 `hophoop lab` wieder laufen.","The server answered {status}.":"Der Server hat {status} geantwortet.","The notebook’s kernel does not answer; run the cell again\
.":"Der Kernel des Notebooks antwortet nicht; die Zelle noch einmal ausführen.",hoop:"Reifen",mode:"Phase",time:"Zeit",angle:"Winkel",gap:"Spalt","rim speed":"\
Randtempo",load:"Last","centre of gravity":"Schwerpunkt","the same in flight":"derselbe im Flug","A in front, B behind":"A vorn, B hinten","The hoop":"Der Reife\
n","The hoop.":"Der Reifen.",Time:"Zeit","{time} seconds, {what}":"{time} Sekunden, {what}","Traces (t)":"Spuren (t)","Forces (f)":"Kräfte (f)","Rim speed (c)":"\
Randgeschwindigkeit (c)","Whole path (w)":"Ganzer Weg (w)","In space (3)":"Im Raum (3)",Traces:"Spuren",Forces:"Kräfte","Rim speed":"Randtempo","Whole path":"G\
anzer Weg","Play (space)":"Abspielen (Leertaste)","Pause (space)":"Pause (Leertaste)","Speed of the film":"Tempo des Films","To the start (Home)":"Zum Anfang (P\
os1)","Previous event (Shift ←)":"Voriges Ereignis (Umschalt ←)","Next event (Shift →)":"Nächstes Ereignis (Umschalt →)","One frame back (←)":"Ein Bi\
ld zurück (←)","One frame on (→)":"Ein Bild weiter (→)",landing:"Landung","To the next flight (h)":"Zum nächsten Flug (h)","To the next landing (l)":"Zu\
r nächsten Landung (l)","This motion has no flight.":"Diese Bewegung hat keinen Flug.","This motion has no landing.":"Diese Bewegung hat keine Landung.","{what\
} at {angle}, {time} s":"{what} bei {angle}, {time} s",start:"Start","slip starts":"Schlupf beginnt","slip ends":"Schlupf endet","slip reverses":"Schlupf kehrt \
sich um","take-off":"Abheben","turns back":"kehrt um","highest point":"höchster Punkt","bounces end":"Sprünge enden","Painlevé: several solutions":"Painlevé:\
 mehrere Lösungen","energy gain (Kane)":"Energiegewinn (Kane)","skimming starts":"Streifen beginnt","at rest":"in Ruhe",end:"Ende","What happens":"Was geschieh\
t","What happens to hoop {hoop}":"Was mit Reifen {hoop} geschieht","The motion in words":"Die Bewegung in Worten","(not all events are shown)":"(nicht alle Erei\
gnisse sind gezeigt)","What theory says":"Was die Theorie sagt","What theory says of hoop {hoop}":"Was die Theorie zu Reifen {hoop} sagt",Velocities:"Geschwindi\
gkeiten","velocity [m/s]":"Geschwindigkeit [m/s]","v (centre)":"v (Mittelpunkt)","Energies and losses":"Energien und Verluste","energy [J]":"Energie [J]",kinetic:"\
kinetisch",potential:"potenziell",total:"gesamt","lost to friction":"durch Reibung verloren","lost in the damper":"im Dämpfer verloren","lost in impacts, norma\
l part":"in Stößen verloren, Normalanteil","Contact forces":"Kontaktkräfte","force [N]":"Kraft [N]","normal N":"Normalkraft N","friction F":"Reibungskraft F",
"Use of friction":"Ausnutzung der Reibung","Your choice":"Deine Wahl","What your diagram shows":"Was dein Diagramm zeigt","Horizontal axis of the diagrams":"Waa\
gerechte Achse der Diagramme","over {quantity}":"über: {quantity}","Whole motion":"Ganze Bewegung","slide to go there, two fingers zoom":"schieben, um dorthin \
zu gehen; zwei Finger vergrößern","click to go there, drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"klicken: dorthin gehen\
; ziehen: vergrößern; nach einem Klick oder mit Strg zoomt das Rad; Doppelklick: alles","{name} from {low} to {high}":"{name} von {low} bis {high}","Diagram: \
{title} in {unit}.":"Diagramm: {title} in {unit}.","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"Winkel inn\
erhalb einer Umdrehung","place of the centre":"Ort des Mittelpunkts","gap under the rim":"Spalt unter dem Rand","height of the centre of gravity":"Höhe des Schw\
erpunkts","speed of the centre":"Geschwindigkeit des Mittelpunkts","speed of rotation":"Umfangsgeschwindigkeit","speed away from the plane":"Geschwindigkeit weg\
 von der Ebene","slip velocity":"Schlupfgeschwindigkeit","angular velocity":"Winkelgeschwindigkeit","normal force":"Normalkraft","friction force":"Reibungskraft",
"use of friction":"Ausnutzung der Reibung","kinetic energy":"kinetische Energie","potential energy":"potenzielle Energie","total energy":"Gesamtenergie","Plane \
of θ and θ̇":"Ebene von θ und θ̇","Plane of angle and angular velocity with the regions of rolling, slip and flight":"Ebene von Winkel und Winkelgeschwind\
igkeit mit den Gebieten von Rollen, Schlupf und Flug","angle θ within a turn [°]":"Winkel θ innerhalb einer Umdrehung [°]","Colours: the mode that follows c\
ontact without slip.":"Farben: die Phase, die auf Kontakt ohne Schlupf folgt.","Hatched: slip that meets Painlevé’s paradox.":"Schraffiert: Schlupf, der auf \
das Painlevé-Paradoxon trifft.","Click to go there; two fingers zoom.":"Tippen: dorthin gehen; zwei Finger vergrößern.","Click to go there; once clicked, or \
with Ctrl, the wheel zooms; double-click for all.":"Klicken: dorthin gehen; nach einem Klick oder mit Strg zoomt das Rad; Doppelklick: alles.",Map:"Karte",of:"v\
on",Across:"Waagerecht",Up:"Senkrecht","What the map shows":"Was die Karte zeigt","Map of motions":"Karte der Bewegungen","Map of motions. Arrow keys move the m\
ark, Enter takes the motion, plus and minus zoom.":"Karte der Bewegungen. Pfeiltasten bewegen die Marke, Eingabe übernimmt die Bewegung, Plus und Minus zoomen.",
"Zoom into the map":"In die Karte hineinzoomen","Zoom out of the map":"Aus der Karte herauszoomen","Whole map":"Ganze Karte","Click to take that motion into the\
 player; two fingers zoom.":"Tippen übernimmt die Bewegung in den Abspieler; zwei Finger vergrößern.","Click to take that motion into the player; once clicke\
d, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Ein Klick übernimmt die Bewegung in den Abspieler; nach einem Klick oder mit Strg zoomt \
das Rad; Ziehen verschiebt; Doppelklick: alles.","computing {count} motions …":"{count} Bewegungen werden berechnet …","{count} motions":"{count} Bewegungen",
"{count} motions, with rigid contact":"{count} Bewegungen, mit starrem Kontakt","of rolling starts, though this motion starts otherwise":"rollender Starts, obwo\
hl diese Bewegung anders beginnt","of starts in any state, though this motion starts rolling":"aus beliebigem Zustand, obwohl diese Bewegung rollend beginnt","S\
hare and save":"Teilen und speichern","Copy a link to this motion":"Link zu dieser Bewegung kopieren","Save the scenario (TOML)":"Szenario speichern (TOML)","Sa\
ve the states (CSV)":"Zustände speichern (CSV)","Save the motion (netCDF)":"Bewegung speichern (netCDF)","Save the events (JSON)":"Ereignisse speichern (JSON)",
"Save a film (MP4)":"Film speichern (MP4)","Save a picture (PNG)":"Bild speichern (PNG)","Record one run as a film (WebM)":"Einen Durchlauf als Film aufnehmen (\
WebM)","Show the Python code":"Python-Code zeigen","The same motion in Python":"Dieselbe Bewegung in Python","The link is copied.":"Der Link ist kopiert.","The \
link to this motion":"Der Link zu dieser Bewegung","The film is being made; this takes a while …":"Der Film wird gemacht; das dauert eine Weile …","Fetching\
 {name} …":"{name} wird geholt …","{name} is there.":"{name} ist da.","This browser cannot record a canvas; take the MP4 instead.":"Dieser Browser kann die \
Zeichenfläche nicht aufnehmen; nimm stattdessen das MP4.","Recording one run …":"Ein Durchlauf wird aufgenommen …","The film is there.":"Der Film ist da.",
"The scenario as a file":"Das Szenario als Datei",Copy:"Kopieren",Copied:"Kopiert",Close:"Schließen","A ring with a load on its rim rolls on a plane. Friction \
can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"\
Ein Ring mit einer Last am Rand rollt auf einer Ebene. Reibung hält nur begrenzt, und die Ebene kann nur drücken: Also gleitet er, hüpft, landet – oder tut etwa\
s, das die Mechanik starrer Körper nicht entscheiden kann. Bewege einen Regler und sieh zu.",Modes:"Phasen","Marks on the bar of time":"Zeichen auf der Zeitlei\
ste",Keys:"Tasten",space:"Leertaste","play, pause":"abspielen, anhalten","one frame":"ein Bild","Shift ← →":"Umschalt ← →","previous, next event":"vorig\
es, nächstes Ereignis","next flight, landing":"nächster Flug, nächste Landung","slower, faster":"langsamer, schneller","Home End":"Pos1 Ende","start, end":"A\
nfang, Ende","traces, forces, rim speed, whole path":"Spuren, Kräfte, Randgeschwindigkeit, ganzer Weg","in space":"im Raum","zoom, zoom back":"zoomen, zurück",
"leave a field, a menu, a picture that the wheel zooms":"ein Feld, ein Menü, ein Bild verlassen, das das Rad zoomt","z y  Ctrl Z":"z y  Strg Z","undo, redo":"r\
ückgängig, wiederholen","dark, light":"dunkel, hell",Python:"Python","the rim does not slide":"der Rand gleitet nicht","slip: the rim turns too fast for the w\
ay it goes (slip −, for a hoop that rolls ahead)":"Schlupf: Der Rand dreht sich zu schnell für seinen Weg (Schlupf −, wenn der Reifen vorwärts rollt)","sl\
ip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"Schlupf: Der Rand gleitet voraus (Schlupf +, wenn der Reifen vorwärts rollt)","the hop: from t\
ake-off to landing":"der Hüpfer: vom Abheben bis zur Landung","a massless rim that touches without force":"ein masseloser Rand, der ohne Kraft berührt","take-\
off, landing":"Abheben, Landung","Painlevé’s paradox: no solution, several":"Painlevé-Paradoxon: keine Lösung, mehrere","bounces without number end":"unzäh\
lige Sprünge enden","skimming begins, rest":"Streifen beginnt, Ruhe","Single keys (letters, digits, signs) do what the table says":"Einzelne Tasten (Buchstaben\
, Ziffern, Zeichen) tun, was die Tabelle sagt","The hoop in your hand":"Der Reifen in der Hand","Slope of the plane":"Neigung der Ebene","Tilt the plane: drag, \
or arrow keys":"Ebene neigen: ziehen oder Pfeiltasten","The hoop: height and speed":"Der Reifen: Höhe und Geschwindigkeit","Lift, roll or throw the hoop: drag,\
 or arrow keys":"Reifen heben, rollen oder werfen: ziehen oder Pfeiltasten","Angle of the load":"Winkel der Last","Turn the load: drag, or arrow keys":"Last dre\
hen: ziehen oder Pfeiltasten","gap {height}, speed {speed} m/s":"Spalt {height}, Geschwindigkeit {speed} m/s",Repeat:"Wiederholen","Slow motion: a tenth of the \
speed":"Zeitlupe: ein Zehntel des Tempos","Sound of the contact":"Klang des Kontakts","Presentation on the whole screen":"Vorführung auf dem ganzen Bildschirm",
"Guided visit":"Geführter Besuch","Table of the motion":"Tabelle der Bewegung","Table of the motion, rows":"Tabelle der Bewegung, Zeilen",Presentation:"Vorführ\
ung","For teachers":"Für Lehrkräfte",Table:"Tabelle",Every:"Alle","Save as CSV":"Als CSV speichern",Columns:"Spalten","The first {count} rows.":"Die ersten {c\
ount} Zeilen.",Challenges:"Herausforderungen","Leave the challenges":"Herausforderungen verlassen","Which challenge":"Welche Herausforderung",Score:"Punkte","Be\
gin again":"Von vorn beginnen","Show a best one":"Eine beste zeigen","{stars} {points} points. {what}":"{stars} {points} Punkte. {what}","Your best: {points} po\
ints.":"Deine beste: {points} Punkte.","Hop highest":"Am höchsten hüpfen","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it start\
s, and friction. How high can the hoop rise within 6 s?":"Auf ebenem Boden, rollend, mit höchstens 3,1 m/s: Du wählst die Last, wo sie beginnt, und die Reibung.\
 Wie hoch kann der Reifen in 6 s steigen?","Land upright":"Aufrecht landen","Let the hoop land with its load at the very top. Everything is allowed; the first h\
op has to be at least 5 cm high.":"Lass den Reifen so landen, dass seine Last ganz oben ist. Alles ist erlaubt; der erste Hüpfer muss mindestens 5 cm hoch sein.",
"Hop without skidding":"Hüpfen ohne Rutschen","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.\
5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Auf ebenem Boden beginnt der Reifen zu rollen, die Last unten, mit höchstens 10 \
m/s, und μ ist höchstens 1,5. Vor dem Hüpfer darf er nicht rutschen; durchdrehen darf er. Wie hoch hüpft er?","Rigid contact only.":"Nur starrer Kontakt.","\
The plane must be level.":"Die Ebene muss waagerecht sein.","It must be on Earth.":"Es muss auf der Erde sein.","Restitution must be 0.":"Die Stoßzahl muss 0 se\
in.","The radius must stay 1 m, without parts.":"Der Radius muss 1 m bleiben, ohne Teile.","At most 90 % of the mass may be in the load.":"Höchstens 90 % der Ma\
sse dürfen in der Last sein.","The hoop must be given by its load fraction.":"Der Reifen muss durch den Massenanteil der Last gegeben sein.","It must start rol\
ling.":"Er muss rollend beginnen.","At most 10 m/s.":"Höchstens 10 m/s.","At most 3.1 m/s.":"Höchstens 3,1 m/s.","At most 6 s.":"Höchstens 6 s.","It does not\
 hop.":"Er hüpft nicht.","It rises by {height}.":"Er steigt um {height}.","The first hop is too low.":"Der erste Hüpfer ist zu niedrig.","It lands {off} away \
from the top.":"Er landet {off} neben der höchsten Stelle.","The load must start at the bottom.":"Die Last muss unten beginnen.","Friction must be at most 1.5.":"\
Die Reibungszahl darf höchstens 1,5 sein.","It skids before it hops.":"Er rutscht, bevor er hüpft.","New here?":"Neu hier?","Eight short questions: guess, the\
n play.":"Acht kurze Fragen: erst raten, dann abspielen.","Start the visit":"Besuch beginnen","Not now":"Jetzt nicht","The hoop, before it is let go.":"Der Reif\
en, bevor er losgelassen wird.",Play:"Abspielen",Next:"Weiter",Back:"Zurück",Done:"Fertig","Step {number} of {all}":"Schritt {number} von {all}","Leave the vis\
it":"Besuch verlassen","First say what you expect, then play.":"Sag erst, was du erwartest, dann spiel ab.","Your guess":"Dein Tipp","{points} of 100 points.":"\
{points} von 100 Punkten.","You have {sum} of {most} points.":"Du hast {sum} von {most} Punkten.","{what} with the load at {angle}":"{what} mit der Last bei {an\
gle}","Draw the curve: pull the points up and down":"Zeichne die Kurve: zieh die Punkte auf und ab","Littlewood’s question":"Littlewoods Frage","A hoop withou\
t mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the weight is l\
evel with the centre.":"Ein Reifen ohne Masse trägt ein Gewicht am Rand. Mit dem Gewicht oben bekommt er den kleinsten Stoß und rollt. J. E. Littlewood fragte 1\
953, was geschieht, wenn das Gewicht auf der Höhe des Mittelpunkts ist.","What do you think?":"Was meinst du?","It rolls on.":"Er rollt weiter.","It hops: the \
hoop leaves the plane.":"Er hüpft: Der Reifen verlässt die Ebene.","The weight falls freely, and the hoop skims the plane below it.":"Das Gewicht fällt frei, \
und der Reifen streift darunter die Ebene.","At {angle} there is no contact force any more.":"Bei {angle} gibt es keine Kontaktkraft mehr.","Littlewood said tha\
t the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs so\
me mass in its rim.":"Littlewood sagte, der Reifen hüpfe. Doch die Kontaktkraft ist null, nicht nach oben gerichtet: Das Gewicht fällt frei, und ein Rand ohne M\
asse folgt ihm die Ebene entlang. Zum Hüpfen braucht ein Reifen etwas Masse im Rand.","A ring with mass":"Ein Ring mit Masse","Now a quarter of the mass is in \
the ring. Again the load is at the top, and the hoop gets the smallest push.":"Jetzt steckt ein Viertel der Masse im Ring. Wieder ist die Last oben, und der Rei\
fen bekommt den kleinsten Stoß.","Draw how fast the hoop’s centre goes during the first turn.":"Zeichne, wie schnell der Mittelpunkt in der ersten Umdrehung \
ist.","Speed of the centre":"Geschwindigkeit des Mittelpunkts","With the load at the bottom the centre has {speed} m/s.":"Mit der Last unten hat der Mittelpunkt\
 {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: it\
 is faster than a stone that falls from the same height.":"Der tiefste Punkt eines rollenden Reifens ruht. Dort hat die Last keine kinetische Energie, und der l\
eichte Ring hat alles, was die schwere Last verloren hat: Er ist schneller als ein Stein, der aus derselben Höhe fällt.","Why it slips":"Warum er gleitet","A \
harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Ein kräftigerer Stoß: 2,8 m/s oben. Rollen braucht Reib\
ung, und Reibung hat eine Grenze: Sie ist höchstens μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"Wo ist die Last, wen\
n die Reibung zum ersten Mal nachgibt? Dreh die Marke.","Angle of the load where it begins to slip":"Winkel der Last, wo er zu gleiten beginnt","It begins to sl\
ip at {angle}. There the plane carries only {share} of the weight.":"Er beginnt bei {angle} zu gleiten. Dort trägt die Ebene nur {share} des Gewichts.","The lo\
ad on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use \
of friction’: it comes to 1.":"Die Last drückt auf ihrem Weg hinab und herum kaum auf die Ebene, N ist also klein, während der Ring schneller werden muss: Das\
 braucht Reibung. Sieh das Diagramm „Ausnutzung der Reibung“: Sie erreicht 1.","The hop":"Der Hüpfer","A little faster, 3.1 m/s. This time the hoop leaves \
the plane, before the first turn is over.":"Etwas schneller, 3,1 m/s. Diesmal verlässt der Reifen die Ebene, bevor die erste Umdrehung vorbei ist.","Where is t\
he load when the hoop takes off? Turn the mark.":"Wo ist die Last, wenn der Reifen abhebt? Dreh die Marke.","Angle of the load where it takes off":"Winkel der L\
ast beim Abheben","It takes off at {angle}, while its rim slips at {slip} m/s.":"Er hebt bei {angle} ab, während sein Rand mit {slip} m/s gleitet.","A rolling \
hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it of\
f the plane before it is at the top.":"Einen rollenden Reifen würde die Ebene bremsen, während die Last hochkommt. Dafür ist die Reibung zu schwach: Der Rand dr\
eht durch, der Reifen dreht schnell weiter, und die Last zieht ihn von der Ebene, bevor sie oben ist.","The landing":"Die Landung","The hoop is in the air. Its \
centre of gravity goes on a parabola, and it turns evenly.":"Der Reifen ist in der Luft. Sein Schwerpunkt fliegt auf einer Parabel, und er dreht sich gleichmäßi\
g.","What does it do just after it has landed?":"Was tut er gleich nach der Landung?","It rolls at once.":"Er rollt sofort.","It skids: the rim slides ahead.":"\
Er rutscht: Der Rand gleitet voraus.","It spins: the rim turns too fast.":"Er dreht durch: Der Rand dreht sich zu schnell.","It bounces.":"Er springt wieder ab.",
"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Er war {time} s in der Luft und stieg um {height} cm; er landet mi\
t der Last bei {angle}.","An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With less friction, or more re\
stitution, the landing would be another one. Try it afterwards.":"Ein Stoß braucht keine Zeit, doch seine Reibung ist so stark wie sein Druck: Hier genügt sie, \
um allen Schlupf zu beenden. Mit weniger Reibung oder größerer Stoßzahl wäre die Landung eine andere. Probier es nachher aus.","More friction, more hop?":"M\
ehr Reibung, mehr Hüpfen?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Drei Reifen bekommen denselben Stoß von 3,1 \
m/s, auf Ebenen mit der Reibungszahl 0,05, 0,2 und 1,0.","Which of them hops highest?":"Welcher hüpft am höchsten?","They rise by {low} cm, {middle} cm and {h\
igh} cm. (The first two are A and B.)":"Sie steigen um {low} cm, {middle} cm und {high} cm. (Die ersten beiden sind A und B.)","On ice nothing drives the rotati\
on; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the way\
 up.":"Auf Eis treibt nichts die Drehung an; mit endloser Reibung gleitet nichts. Der Hüpfer braucht beides: genug Reibung, um den Reifen auf dem Weg hinab schn\
ell zu drehen, und nicht so viel, dass er auf dem Weg hinauf gebremst wird.","What rigid bodies cannot decide":"Was starre Körper nicht entscheiden","A hoop is\
 thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Ein Reifen wird so geworfen, dass\
 er schnell über eine raue Ebene gleitet. Die Gesetze starrer Körper mit trockener Reibung müssen sagen, was als Nächstes geschieht.","What do they say?":"W\
as sagen sie?","It flies off.":"Er fliegt davon.","An impact stops the slide at once.":"Ein Stoß beendet das Gleiten sofort.","Both agree with the laws.":"Beid\
es passt zu den Gesetzen.","Hoop A and hoop B start alike, and both motions obey every law.":"Reifen A und Reifen B beginnen gleich, und beide Bewegungen befolg\
en jedes Gesetz.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that deci\
des: choose the compliant contact under ‘Contact’.":"Painlevé fand dies 1895. Für einen starren Körper haben die Gesetze hier zwei Antworten, in anderen Zus\
tänden keine. Wirkliche Körper geben etwas nach, und das entscheidet: Wähle unter „Kontakt“ den nachgiebigen.","Your turn":"Du bist dran","Take the hoop:\
 turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the motion itself.":"N\
imm den Reifen: Dreh die Last, heb ihn an und lass ihn fallen, stoß ihn an, neige die Ebene. Oder nimm eine Herausforderung an, und sieh, wie deine Punkte aus d\
er Bewegung selbst berechnet werden.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Den Reifen einmal in voller G\
eschwindigkeit zeigen, ohne Kommentar. „Ich stoße ihn an. Rollt er nur?“","Everybody predicts where the load is at take-off. Count the votes by quarters of\
 the turn.":"Alle sagen voraus, wo die Last beim Abheben ist. Stimmen nach Vierteln der Umdrehung zählen.","Energy on the way down, in pairs: who has the energ\
y when the load is at rest?":"Energie auf dem Weg hinab, zu zweit: Wer hat die Energie, wenn die Last ruht?","Lift at the top: at which speed is the force of th\
e floor zero?":"Abheben oben: Bei welcher Geschwindigkeit ist die Kraft des Bodens null?","The film again, in slow motion and with forces; stop at take-off. Com\
pare with the votes.":"Der Film noch einmal, in Zeitlupe und mit Kräften; beim Abheben anhalten. Mit den Stimmen vergleichen.","Each group takes one speed of t\
he worksheet; results on the board.":"Jede Gruppe nimmt eine Geschwindigkeit des Arbeitsblatts; Ergebnisse an die Tafel.","Why? What has to brake the rotation o\
n the way up, how strong can it be, and what if it is too weak?":"Warum? Was muss die Drehung auf dem Weg hinauf bremsen, wie stark kann es sein, und was, wenn \
es zu schwach ist?","One sentence each: “The hoop hops because …”":"Ein Satz von jedem: „Der Reifen hüpft, weil …“","The load pulls the hoop up at \
the top, so it hops there.":"Die Last zieht den Reifen oben hoch, also hüpft er dort.","Only if it is very fast. Slower hoops hop before the top, after slippin\
g.":"Nur wenn er sehr schnell ist. Langsamere Reifen hüpfen vor der höchsten Stelle, nach dem Gleiten.","It hops at the bottom, where it is fastest.":"Er hüpf\
t unten, wo er am schnellsten ist.","There the floor pushes hardest: the load has to be turned upwards.":"Dort drückt der Boden am stärksten: Die Last muss nach\
 oben umgelenkt werden.","Nothing can be faster than a falling stone.":"Nichts kann schneller sein als ein fallender Stein.","The ring can: it gets the energy o\
f a load that has come to rest.":"Der Ring schon: Er bekommt die Energie einer Last, die zur Ruhe gekommen ist.","Friction always brakes.":"Reibung bremst immer\
.","It acts against slip. On the hoop’s way up it points forwards.":"Sie wirkt gegen den Schlupf. Auf dem Weg hinauf zeigt sie nach vorn.","More friction, mor\
e hop.":"Mehr Reibung, mehr Hüpfen.","There is a best friction in between.":"Dazwischen gibt es eine beste Reibungszahl.","A heavier hoop behaves otherwise.":"\
Ein schwererer Reifen verhält sich anders.","Only the shares of mass count.":"Nur die Anteile der Massen zählen.","Before the film: where is the load when the\
 hoop leaves the floor? Mark the place and give one reason.":"Vor dem Film: Wo ist die Last, wenn der Reifen den Boden verlässt? Markiere die Stelle und nenne e\
inen Grund.","The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"Der Reifen bekommt n\
ur den kleinsten Stoß und rollt. Wie viel potenzielle Energie ist frei geworden, wenn die Last unten ist?","While a wheel rolls, its lowest point is at rest. W\
hich part of the hoop has kinetic energy then, and how fast is the centre?":"Wenn ein Rad rollt, ruht sein tiefster Punkt. Welcher Teil des Reifens hat dann kin\
etische Energie, und wie schnell ist der Mittelpunkt?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"Wie schnell is\
t ein Stein, der aus der Höhe der Last fällt? Warum kann der Reifen schneller sein?","Find the force of the floor at the top for 1.0 m/s, and the speed at whi\
ch it becomes zero.":"Bestimme die Kraft des Bodens oben für 1,0 m/s und die Geschwindigkeit, bei der sie null wird.","In the lab: what does the hoop do in its\
 first 1.5 s, and at which angle does it hop? Fill in the table.":"Im Labor: Was tut der Reifen in den ersten 1,5 s, und bei welchem Winkel hüpft er? Fülle die \
Tabelle aus.","Find the smallest speed with which the hoop hops, to 1 cm/s.":"Finde die kleinste Geschwindigkeit, mit der der Reifen hüpft, auf 1 cm/s genau.",
"At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping help it to hop?":"Bei 2,2 m/s verlässt der Reifen den Boden, während sein Rand glei\
tet. Warum hilft ihm das Gleiten zu hüpfen?",Show:"Zeigen","Teaching with the hoop":"Unterrichten mit dem Reifen",Worksheet:"Arbeitsblatt",Solutions:"Lösungen",
Exercises:"Aufgaben","A lesson of 45 minutes":"Eine Unterrichtsstunde von 45 Minuten",Minute:"Minute",Motion:"Bewegung","What students often think":"Was Lernend\
e oft denken",Idea:"Vorstellung","What is right":"Was richtig ist","Worksheet: the hoop that hops":"Arbeitsblatt: der hüpfende Reifen","A thin ring of radius 0\
.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Fricti\
on: μ = 1; g = 9.81 m/s².":"Ein dünner Ring mit dem Radius 0,40 m hat eine Masse von 0,25 kg. An seinem Rand ist eine Last von 0,75 kg befestigt. Der Reifen s\
teht mit der Last oben auf ebenem Boden und wird nach rechts gestoßen. Reibungszahl: μ = 1; g = 9,81 m/s².",phases:"Phasen","does it hop?":"hüpft er?","at w\
hich angle?":"bei welchem Winkel?",Print:"Drucken","The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student.":"\
Der Besuch fragt, bevor er zeigt; die Vorführung füllt den Bildschirm; die Tabelle gibt allen Zahlen.",inf:"inf","greater than {least}":"größer als {least}",
"at least {least}":"mindestens {least}","at least {least} (inf is allowed)":"mindestens {least} (inf ist erlaubt)","at most {most}":"höchstens {most}","a finit\
e number":"eine endliche Zahl","a whole number":"eine ganze Zahl","'{word}' or '{word2}'":"„{word}“ oder „{word2}“","'{word}', '{word2}' or '{word3}'":"\
„{word}“, „{word2}“ oder „{word3}“","Rolling resistance":"Rollwiderstand","Rolling resistance: couple against the rotation over R N":"Rollwiderstand\
: Moment gegen die Drehung, geteilt durch R N","Slips, hops":"Gleitet, hüpft","no single threshold uphill (β < 0): it depends on where the hoop turns back; see\
 the map":"bergauf (β < 0) keine Schwelle: Ob er gleitet oder hüpft, hängt davon ab, wo er umkehrt; die Karte zeigt es","'rigid' for a map":"für eine Karte „\
rigid“","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells mal y.cells = {cells} darf im Labor höchstens {most} sein.","{one} and \
{other} cannot both be axes: they say the same thing in two ways.":"{one} und {other} können nicht beide Achsen sein: Sie sagen dasselbe auf zwei Arten.","x.pa\
th and y.path are both {path} and must differ.":"x.path und y.path sind beide {path} und müssen verschieden sein.","lost to rolling resistance":"durch Rollwide\
rstand verloren","Rolling resistance f":"Rollwiderstand f","{name} = {value} must lie between -pi/2 and pi/2 (radians).":"{name} = {value} muss zwischen -pi/2 u\
nd pi/2 liegen (Radiant).","{word} is not a known key; known are {word2}.":"{word} ist kein bekannter Schlüssel; bekannt sind {word2}.","{one} cannot be given \
together with {other}.":"{one} kann nicht zusammen mit {other} gegeben werden.","{one} = {value} must not exceed {other} = {limit}.":"{one} = {value} darf {othe\
r} = {limit} nicht übersteigen.","plane.mu_static = inf must be finite with contact.model = 'compliant'.":"plane.mu_static = inf muss bei contact.model = 'comp\
liant' endlich sein.","hoop.parts must not be empty.":"hoop.parts darf nicht leer sein.","This takes longer than {time} s; ask for a shorter motion or fewer cel\
ls.":"Das dauert länger als {time} s; verlange eine kürzere Bewegung oder weniger Zellen.","The lab is busy; try again in {time} seconds.":"Das Labor ist besc\
häftigt; in {time} Sekunden noch einmal versuchen.","The lab is busy; try again in 1 second.":"Das Labor ist beschäftigt; in 1 Sekunde noch einmal versuchen.",
"The computation failed.":"Die Rechnung ist gescheitert.","The process that computed this has ended.":"Der Prozess, der dies berechnet hat, ist beendet.","durat\
ion = {value} must be at most {most} s in the lab; the library itself has no such limit.":"duration = {value} darf im Labor höchstens {most} s sein; die Bibliot\
hek selbst hat keine solche Grenze.","duration = {value} s at this speed and radius is about {turns} revolutions and must be at most {most} in the lab; the libr\
ary itself has no such limit.":"duration = {value} s sind bei dieser Geschwindigkeit und diesem Radius etwa {turns} Umdrehungen, im Labor höchstens {most}; die \
Bibliothek selbst hat keine solche Grenze.","hoop.parts has {count} parts and must have at most {most} in the lab.":"hoop.parts hat {count} Teile und darf im La\
bor höchstens {most} haben.","contact.stiffness, contact.slip_speed and duration need about {steps} steps of integration and must need at most {most} in the la\
b.":"contact.stiffness, contact.slip_speed und duration brauchen etwa {steps} Integrationsschritte, im Labor höchstens {most}.","A cell of this map is about {t\
urns} revolutions and must be at most {most} in the lab.":"Eine Zelle dieser Karte sind etwa {turns} Umdrehungen, im Labor höchstens {most}.","x and y make {co\
unt} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter duration.":"x und y ergeben {\
count} Zellen mit zusammen etwa {turns} Umdrehungen, im Labor höchstens {most}; nimm weniger Zellen, kleinere Geschwindigkeiten oder eine kürzere Dauer.","dur\
ation = {value} must be at most {most} s for a film from the lab.":"duration = {value} darf für einen Film aus dem Labor höchstens {most} s sein.","A blue, B \
ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A blau, B ocker; die Strichart nennt die Größe; Zahlen von {hoop}; {hands}","After {time} \
s the motion depends on more digits than this page computes. Run it in hophoop lab or Python for the exact result.":"Was nach {time} s kommt, hängt an mehr Stel\
len, als die Zahlen dieser Seite haben; hophoop lab und Python nehmen so viele, wie nötig sind.",Fingerprint:"Fingerabdruck","No fingerprint: this motion depen\
ds on more digits than this page computes.":"Kein Fingerabdruck: Diese Bewegung hängt an mehr Stellen, als diese Seite rechnet.","A hash of all events: the sam\
e wherever hophoop computes the same bits, also in Python":"Ein Hashwert aller Ereignisse: derselbe überall, wo hophoop dieselben Bits rechnet, auch in Python",
"✓ Same bits as in Python":"✓ Dieselben Bits wie in Python","✓ Same bits as where the link was made":"✓ Dieselben Bits wie dort, wo der Link entstand","\
The bits differ: {own} here, {other} in Python.":"Die Bits sind verschieden: {own} hier, {other} in Python.","The bits differ: {own} here, {other} where the lin\
k was made, perhaps with another version.":"Die Bits sind verschieden: {own} hier, {other} dort, wo der Link entstand, vielleicht mit einer anderen Version.","h\
ophoop lab: play with the hopping hoop":"hophoop-Labor: mit dem hüpfenden Reifen spielen","Put a hopping hoop into a page of yours":"Einen hüpfenden Reifen in \
die eigene Seite setzen","One tag and one script show a live hoop in a blog, a course page or slides. The motion is computed in the reader’s browser; nothing is\
 sent anywhere.":"Ein Tag und ein Skript zeigen einen lebendigen Reifen in einem Blog, auf einer Kursseite oder auf Folien. Die Bewegung wird im Browser der Les\
enden berechnet; nichts wird irgendwohin gesendet.","Choose a motion in the lab, and copy its link here.":"Im Labor eine Bewegung wählen und ihren Link hierher \
kopieren.","Scenario: a link of the lab, or what stands behind its question mark":"Szenario: ein Link des Labors, oder was hinter seinem Fragezeichen steht","Wh\
at stands beside the player":"Was neben dem Abspieler steht",sliders:"Regler",diagrams:"Diagramme",theory:"Theorie",map:"Karte","As a tag":"Als Tag","The tag":"\
Der Tag","Copy the tag":"Den Tag kopieren","As a frame, where scripts are not allowed":"Als Rahmen, wo Skripte nicht erlaubt sind","The frame":"Der Rahmen","Cop\
y the frame":"Den Rahmen kopieren","As a QR code":"Als QR-Code","How it looks":"Wie es aussieht","Copied.":"Kopiert.","A hopping hoop":"Ein hüpfender Reifen","\
Save a picture (SVG)":"Bild speichern (SVG)","A picture in space has no lines to keep: take the PNG, or leave 3D.":"Ein räumliches Bild hat keine Linien, die bl\
eiben: nimm das PNG oder verlasse 3D.","The picture is too large for this browser.":"Das Bild ist für diesen Browser zu groß.",Arrows:"Pfeile","What a little \
more would do (a)":"Was ein wenig mehr bewirken würde (a)","What a little more would do":"Was ein wenig mehr bewirken würde","A little more":"Ein wenig mehr",
"Do it":"Ausführen","Every event, by this step":"Jedes Ereignis, bei diesem Schritt","What changes at every event":"Was sich bei jedem Ereignis ändert",event:"\
Ereignis",place:"Ort",height:"Höhe","load angle":"Winkel der Last","It is infinite: there is no more of it.":"Der Wert ist unendlich: Mehr davon gibt es nicht.",
"This needs a browser that runs WebAssembly.":"Das braucht einen Browser, der WebAssembly ausführt.","The part of the page that computes this could not be load\
ed; choose it again when there is a network.":"Der Teil der Seite, der das berechnet, konnte nicht geladen werden; wähle es noch einmal, wenn ein Netz da ist.",
"Nothing: no event moves.":"Nichts: Kein Ereignis verschiebt sich.","The arrows are drawn in the picture in the plane: leave 3D to see them.":"Die Pfeile stehen\
 im ebenen Bild: Verlasse 3D, um sie zu sehen.","The arrows in the picture lead from where the rim touches to where it would, {factor} times as long.":"Die Pfei\
le im Bild führen von dort, wo der Rand aufsetzt, dorthin, wo er es täte, {factor}-mal so lang.","From {what} at {time} s on no derivative: {reason}.":"Ab {wh\
at} bei {time} s gibt es keine Ableitung: {reason}.","To one side only: {reason}.":"Nur nach einer Seite: {reason}.","{amount} further to the right":"{amount} w\
eiter rechts","{amount} further to the left":"{amount} weiter links","{amount} later":"{amount} später","{amount} earlier":"{amount} früher","{amount} higher":"\
{amount} höher","{amount} lower":"{amount} niedriger","{amount} longer":"{amount} weiter","{amount} shorter":"{amount} kürzer","{amount} more in the air":"{am\
ount} mehr in der Luft","{amount} less in the air":"{amount} weniger in der Luft","begins {amount} later":"beginnt {amount} später","begins {amount} earlier":"\
beginnt {amount} früher","{amount} faster":"{amount} schneller","{amount} slower":"{amount} langsamer","The hop: {list}.":"Der Sprung: {list}.","Hop {number}: \
{list}.":"Sprung {number}: {list}.","The first event, {what}: {list}.":"Das erste Ereignis, {what}: {list}.","At the end, after {time} s: {list}.":"Am Ende, nac\
h {time} s: {list}.","arrows: what a little more would do":"Pfeile: was ein wenig mehr bewirken würde","a quantity that sets off the event only touches zero th\
ere":"eine Größe, die das Ereignis auslöst, berührt dort die Null nur","the motion lies on the border of two classes: the least change may lead to other eve\
nts":"die Bewegung liegt auf der Grenze zweier Klassen: Die kleinste Änderung kann zu anderen Ereignissen führen","restitution is 0 and the rim has landed: wi\
th any restitution it would bounce":"die Stoßzahl ist 0 und der Rand ist gelandet: Mit jeder anderen spränge er","the motion starts in contact: with the rim l\
ifted or thrown it would bounce, and its events are others":"die Bewegung beginnt in Berührung: Mit gehobenem oder geworfenem Rand spränge er, und es gäbe ander\
e Ereignisse","the slip runs into p_σ = 0, where the contact force has no bound":"der Schlupf läuft in p_σ = 0, wo die Kontaktkraft keine Grenze hat","the ma\
ssless hoop (γ = 1) is a singular limit once the contact force is lost":"der masselose Reifen (γ = 1) ist ein singulärer Grenzfall, sobald die Kontaktkraft ver\
loren ist","without friction the hoop rests on no more than a border of two classes":"ohne Reibung ruht der Reifen nur auf der Grenze zweier Klassen","the motio\
n has no answer from there on":"die Bewegung hat von dort an keine Antwort","the parameter is at the edge of what is allowed":"der Parameter liegt am Rand des E\
rlaubten","the derivatives of the two sides differ":"die Ableitungen der beiden Seiten sind verschieden","With a compliant contact no derivatives are computed: \
choose the rigid contact model.":"Mit nachgiebigem Kontakt werden keine Ableitungen berechnet: Wähle das starre Kontaktmodell.","The rest of the link is shown.\
 Correct the address, or go on from here.":"Gezeigt wird der Rest des Links. Die Adresse kann berichtigt werden; oder es geht von hier aus weiter.","Ignored in \
the link: {names}.":"Im Link nicht beachtet: {names}.","{stars} {points} points, shown and not counted. {what}":"{stars} {points} Punkte, gezeigt und nicht gewe\
rtet. {what}","{label} = {value} is too large.":"{label} = {value} ist zu groß.","Skip to the answer":"Zur Antwort springen","Not so.":"Nein.",Pause:"Anhalten",
Share:"Teilen",Everything:"Alles","Simple view":"Einfache Ansicht","Show everything":"Alles zeigen","This motion has other settings too.":"Diese Bewegung hat no\
ch andere Einstellungen.","Drag the load":"Zieh die Last","About hophoop":"Über hophoop","hophoop computes exactly how a hoop with a load on its rim rolls, sli\
ps, hops and lands.":"hophoop berechnet genau, wie ein Reifen mit einer Last am Rand rollt, gleitet, hüpft und landet.",Version:"Version",Licence:"Lizenz","Lic\
ences of all that the page contains":"Lizenzen von allem, was die Seite enthält",Documentation:"Dokumentation","The documentation":"Die Dokumentation","docs/in\
dex.md in the source; this page: docs/lab.md":"docs/index.md im Quelltext; diese Seite: docs/lab.md",Commands:"Befehle"};var Xh=["rodadura","patinaje","derrape","vuelo","roce","deslizamiento −","deslizamiento +","rueda","patina","derrapa","vuela","roza el plano","rueda desde {an\
gle}","patina desde {angle}","derrapa desde {angle}","vuela desde {angle}","roza el plano desde {angle}","salta a {angle}","aterriza a {angle}","rebota a {angle\
}","desliza en sentido contrario desde {angle}","deja de deslizar de golpe a {angle}","da la vuelta a {angle}","termina de rebotar a {angle}","encuentra la para\
doja de Painlevé a {angle}","encuentra la indeterminación de Painlevé a {angle}","se bloquea a {angle}","gana energía (Kane) a {angle}","roza desde {angle}",
"reposa a {angle}","empieza a {angle}","desliza desde {angle}","{what} y {count} veces más","… ({count} más)","Ha quedado en reposo.","La fuerza normal crec\
e sin límite (bloqueo dinámico): la mecánica del sólido rígido no da ningún movimiento más allá.","El modelo no determina el movimiento posterior.","Se \
alcanzó el límite de sucesos (contact.max_events), o de cálculo para un movimiento, antes del final.","Empieza y {verb}, con la carga a {angle} y el centro a\
 {speed} m/s.","Empieza en el aire, con la carga a {angle} y el centro a {speed} m/s.","Empieza rozando el plano, con la carga a {angle} y el centro a {speed} m\
/s.","A {angle} {verb}: el rozamiento está agotado y la llanta gira demasiado deprisa para lo que avanza.","A {angle} {verb}: el rozamiento está agotado y la l\
lanta desliza hacia delante.","A {angle} vuelve a rodar; el deslizamiento ha cesado.","A {angle} se invierte el deslizamiento; {verb}.","Salta a {angle}.","Salt\
a a {angle}. Sube {height} y permanece {time} s en el aire.","Un impacto sin choque a {angle} detiene el deslizamiento; luego {verb}.","Aterriza a {angle} con {\
speed} m/s hacia abajo y rebota.","Aterriza a {angle} con {speed} m/s hacia abajo y {verb}.","Da la vuelta a {angle}.","Da la vuelta a {angle}, y ahora {verb}.",
"El centro está más alto a {angle}: la separación es de {height}.","Aquí, a {angle}, terminan infinitos rebotes.","Paradoja de Painlevé a {angle}: ninguna f\
uerza de contacto es compatible con este deslizamiento.","Paradoja de Painlevé a {angle}: varias fuerzas de contacto son compatibles.","Bloqueo dinámico a {ang\
le}: la fuerza de contacto crece sin límite.","La ley de impacto de Newton ha creado {energy} J (ejemplo de Kane).","A {angle} ya no hay fuerza de contacto: la\
 carga cae libremente y la llanta roza el plano.","Reposa a {angle}.","Reposa a {angle}, pero no de forma estable.","Rebota {count} veces más.","… y {count} má\
s.","Desliza","Salta","Salta de inmediato","Rozamiento para rodadura pura","Paradoja de Painlevé","Bloqueo dinámico","Reposo estable","Fin de la rodadura","de\
slizaría por encima de {speed} m/s","deslizaría: basta cualquier empujón","saltaría en la primera vuelta por encima de {speed} m/s","saltaría en la primera \
vuelta: basta cualquier empujón","saltaría de inmediato por encima de {speed} m/s","saltaría de inmediato: a cualquier velocidad","nunca, a ninguna velocidad",
"ningún rozamiento lo mantiene rodando","μ = {mu} lo mantendría rodando (aquí basta)","μ = {mu} lo mantendría rodando (más de lo que hay)","nunca","desde\
 μ = {mu}, a {angle}: aquí es posible","desde μ = {mu}, a {angle}: aquí no","puede acabar un deslizamiento a {angles}","con la carga a {angle}","a {angle} s\
e agota el rozamiento","a {angle} desaparece la fuerza de contacto","Fracción de la carga","Parte de la masa que está en la carga de un aro ideal","Excentrici\
dad","Distancia del centro de gravedad al centro, dividida por el radio","Momento de inercia relativo","Momento de inercia respecto al centro de gravedad, divid\
ido por m R²","Radio","Radio de la llanta","Masa","Masa total","Coeficiente de rozamiento","Coeficiente de rozamiento, estático y cinético","Rozamiento estát\
ico","Rozamiento cinético","Inclinación","Inclinación del plano, cuesta abajo hacia +x","Gravedad","Restitución","Coeficiente de restitución de un impacto",
"Velocidad","Velocidad del centro en una salida rodando","Ángulo de la carga","Ángulo desde la normal del plano hasta el centro de gravedad","Altura de la sep\
aración","Separación entre la llanta y el plano","Velocidad a lo largo","Velocidad del centro a lo largo del plano","Velocidad hacia arriba","Velocidad del ce\
ntro alejándose del plano","Velocidad angular","Rigidez","Rigidez del contacto","Velocidad de deslizamiento","Velocidad de deslizamiento en la que se establece\
 el rozamiento","Restitución para la que se elige el amortiguamiento","Duración","Duración del movimiento","Ley de impacto","Ley de restitución","Stronge (e\
nergía)","Poisson (impulso)","Newton (velocidad)","Painlevé: dos soluciones","Qué sigue a un contacto indeterminado","impacto","Modelo de contacto","rígido",
"flexible","Fuerza normal","Ley de rozamiento","Rozamiento regularizado","suave (tanh)","lineal","cerdas (puede sujetar)","Kelvin–Voigt","Hunt–Crossley","Ve\
locidad v₀","Ángulo de la carga θ₀","Velocidad a lo largo ẋ₀","Velocidad angular θ̇₀","Altura de la separación y₀","Fracción de la carga γ","\
Excentricidad ε","Momento de inercia relativo κ","Radio R","Rozamiento μ","Inclinación β","Gravedad g","Restitución e","Tierra","Luna","Marte","Júpiter",
"Ingravidez","lo que ocurre en la primera vuelta","altura del primer salto","ángulo de despegue","duración del primer salto","mayor uso del rozamiento","energ\
ía perdida","ángulo final","paradoja de Painlevé o bloqueo","cómo termina","duración","vueltas","inversión","despegue","reposo","bloqueo","indeterminado",
"límite de sucesos","no","sí","ninguno","no permitido","y {count} más","El artículo","El aro de Littlewood","Paradojas","Más","Salta: 3,1 m/s","Desliza dos\
 veces, luego deja el plano justo antes de dar una vuelta y vuela durante 0,76 s.","Desliza: 2,8 m/s","El rozamiento se agota dos veces por vuelta; cada desliza\
miento es más débil que el anterior, y ninguno es el último.","Rueda: 2 m/s","Rodadura pura, más rápida y uniforme que tras una salida lenta, y cerca del lím\
ite del rozamiento.","El menor empujón: 0,1 m/s","Casi en reposo con la carga arriba, rápido con la carga abajo; se usa el 38 % del rozamiento.","Poco rozamie\
nto: 0,1 m/s, μ = 0,3","Deslizar cuesta la energía que exige una vuelta entera: el aro se balancea.","Toda la masa en la carga","Un anillo sin masa: a 90° ya \
no hay fuerza de contacto; la carga cae y la llanta roza el plano.","Toda la masa en la carga, con empujón","Con un empujón la fuerza de contacto desaparece an\
tes, a cos θ = v₀²/(gR).","Casi toda la masa en la carga","γ = 0,99: lo que hace un anillo real en lugar del salto de Littlewood.","Painlevé: ninguna soluc\
ión","Ninguna fuerza de contacto es compatible con este deslizamiento. Un impacto sin choque lo detiene de golpe.","Vuelo e impacto cumplen ambos las leyes. El\
ige con el selector de «Plano».","Un deslizamiento rápido tras un salto: la fuerza de contacto crece sin límite en un tiempo finito, y ninguna ley dice qué si\
gue.","Kane: energía de la nada","La ley de impacto de Newton con rozamiento crea dos julios. La de Stronge, no.","Cuesta abajo","En una pendiente de 10° el ar\
o gana velocidad vuelta a vuelta, hasta que salta.","Rebotes sin número","Soltado con giro y restitución 0,5: infinitos rebotes en un tiempo finito.","En la L\
una","El salto del artículo con gravedad lunar: todo es 2,46 veces más lento.","Ejemplos","Ejemplos…","Deshacer (z)","Rehacer (y)","Comparar","Comparar dos \
aros","Oscuro o claro (d)","Teclas y ayuda (?)","Teclas y ayuda","laboratorio","Aprender","Idioma","Aro A","Aro B","Qué aro cambian los controles","Parámetros",
"Ir al reproductor","Aro","Plano","Inicio","Contacto","Dado por","fracción de carga γ","ε y κ","piezas reales","Dónde","otro lugar","rozamiento estático y \
cinético por separado","Empieza","rodando","en cualquier estado","auto {value}","{name}, valor exacto en {unit}","{name}, valor exacto","Anillo","Disco","Masa \
puntual","Varilla","masa","radio interior","radio exterior","radio","distancia al centro","longitud","Añadir una pieza","+ añadir una pieza…","Quitar la pie\
za {number}, {what}","{name} = {value} debe ser {rule}.","{name} = {value} debe ser un número, como 2,5.","{name} = {value} debe ser un número.","de {least} a\
 {most}","de {least} a {most}, o inf","0 o de {least} a {most}","0, de {least} a {most}, o inf","como mucho {most} en el laboratorio","0 para el aro sin masa (h\
oop.inertia_ratio = 0)","«rigid» para el aro sin masa (hoop.inertia_ratio = 0)","El servidor no responde. Lo que hay aquí sigue funcionando; para cambios hay \
que volver a ejecutar `hophoop lab`.","El servidor respondió {status}.","El núcleo del cuaderno no responde; vuelva a ejecutar la celda.","aro","fase","tiempo",
"ángulo","separación","vel. de la llanta","carga","centro de gravedad","el mismo en vuelo","A delante, B detrás","El aro","El aro.","Tiempo","{time} segundos\
, {what}","Trayectorias (t)","Fuerzas (f)","Velocidad de la llanta (c)","Todo el recorrido (w)","En el espacio (3)","Trayectorias","Fuerzas","Vel. llanta","Reco\
rrido","Reproducir (espacio)","Pausa (espacio)","Velocidad de la película","Al principio (Inicio)","Suceso anterior (Mayús ←)","Suceso siguiente (Mayús →)",
"Un fotograma atrás (←)","Un fotograma adelante (→)","aterrizaje","Al siguiente vuelo (h)","Al siguiente aterrizaje (l)","Este movimiento no tiene vuelo.",
"Este movimiento no tiene aterrizaje.","{what} a {angle}, {time} s","inicio","empieza el deslizamiento","acaba el deslizamiento","se invierte el deslizamiento",
"despegue","da la vuelta","punto más alto","acaban los rebotes","Painlevé: varias soluciones","ganancia de energía (Kane)","empieza el roce","en reposo","fin\
al","Qué ocurre","Qué le ocurre al aro {hoop}","El movimiento en palabras","(no se muestran todos los sucesos)","Qué dice la teoría","Qué dice la teoría del\
 aro {hoop}","Velocidades","velocidad [m/s]","v (centro)","Energías y pérdidas","energía [J]","cinética","potencial","total","perdida por rozamiento","perdi\
da en el amortiguador","perdida en impactos, parte normal","Fuerzas de contacto","fuerza [N]","normal N","rozamiento F","Uso del rozamiento","A tu elección","Q\
ué muestra tu diagrama","Eje horizontal de los diagramas","en función de: {quantity}","Todo el movimiento","desliza para ir ahí; dos dedos amplían","clic pa\
ra ir ahí, arrastrar para ampliar; tras un clic, o con Ctrl, la rueda amplía; doble clic para todo","{name} de {low} a {high}","Diagrama: {title} en {unit}.",
"θ mod 360°","Esc","{name} [{unit}]","ángulo dentro de una vuelta","posición del centro","separación bajo la llanta","altura del centro de gravedad","veloc\
idad del centro","velocidad de rotación","velocidad de alejamiento del plano","velocidad de deslizamiento","velocidad angular","fuerza normal","fuerza de rozam\
iento","uso del rozamiento","energía cinética","energía potencial","energía total","Plano de θ y θ̇","Plano de ángulo y velocidad angular con las regione\
s de rodadura, deslizamiento y vuelo","ángulo θ dentro de una vuelta [°]","Colores: la fase que sigue al contacto sin deslizamiento.","Rayado: deslizamiento \
que encuentra la paradoja de Painlevé.","Toca para ir ahí; dos dedos amplían.","Clic para ir ahí; tras un clic, o con Ctrl, la rueda amplía; doble clic para \
todo.","Mapa","de","Horizontal","Vertical","Qué muestra el mapa","Mapa de movimientos","Mapa de movimientos. Las flechas mueven la marca, Intro toma el movimie\
nto, más y menos amplían.","Ampliar el mapa","Reducir el mapa","Mapa entero","Toca para llevar ese movimiento al reproductor; dos dedos amplían.","Un clic ll\
eva ese movimiento al reproductor; tras un clic, o con Ctrl, la rueda amplía; arrastrar desplaza; doble clic para todo.","calculando {count} movimientos…","{\
count} movimientos","{count} movimientos, con contacto rígido","con salidas rodando, aunque este movimiento empieza de otro modo","desde cualquier estado, aunq\
ue este movimiento empieza rodando","Compartir y guardar","Copiar un enlace a este movimiento","Guardar el escenario (TOML)","Guardar los estados (CSV)","Guarda\
r el movimiento (netCDF)","Guardar los eventos (JSON)","Guardar una película (MP4)","Guardar una imagen (PNG)","Grabar un recorrido como película (WebM)","Mos\
trar el código Python","El mismo movimiento en Python","El enlace está copiado.","El enlace a este movimiento","Se está haciendo la película; tarda un poco…",
"Obteniendo {name}…","{name} ya está.","Este navegador no puede grabar el lienzo; use el MP4.","Grabando una pasada…","La película ya está.","El escenari\
o como archivo","Copiar","Copiado","Cerrar","Un anillo con una carga en la llanta rueda sobre un plano. El rozamiento aguanta hasta un límite y el plano solo pu\
ede empujar: por eso desliza, salta, aterriza… o hace algo que la mecánica del sólido rígido no puede decidir. Mueve un control y observa.","Fases","Marcas\
 en la barra de tiempo","Teclas","espacio","reproducir, pausa","un fotograma","Mayús ← →","suceso anterior, siguiente","siguiente vuelo, aterrizaje","más l\
ento, más rápido","Inicio Fin","principio, final","trayectorias, fuerzas, velocidad de la llanta, recorrido","en el espacio","ampliar, volver","salir de un ca\
mpo, un menú o una imagen que amplía la rueda","z y  Ctrl Z","deshacer, rehacer","oscuro, claro","Python","la llanta no desliza","deslizamiento: la llanta gir\
a demasiado deprisa para lo que avanza (deslizamiento −, si el aro rueda hacia delante)","deslizamiento: la llanta desliza hacia delante (deslizamiento +, si \
el aro rueda hacia delante)","el salto: del despegue al aterrizaje","una llanta sin masa que toca sin fuerza","despegue, aterrizaje","Paradoja de Painlevé: ning\
una solución, varias","acaban infinitos rebotes","empieza el roce, reposo","Las teclas sueltas (letras, cifras, signos) hacen lo que dice la tabla","El aro en \
tu mano","Inclinación del plano","Inclinar el plano: arrastrar o flechas","El aro: altura y velocidad","Levantar, rodar o lanzar el aro: arrastrar o flechas","\
Ángulo de la carga","Girar la carga: arrastrar o flechas","separación {height}, velocidad {speed} m/s","Repetir","Cámara lenta: una décima parte","Sonido de\
l contacto","Presentación a pantalla completa","Visita guiada","Tabla del movimiento","Tabla del movimiento, filas","Presentación","Para docentes","Tabla","Ca\
da","Guardar como CSV","Columnas","Las primeras {count} filas.","Retos","Salir de los retos","Qué reto","Puntuación","Empezar de nuevo","Ver una de las mejore\
s","{stars} {points} puntos. {what}","Tu mejor: {points} puntos.","El salto más alto","En suelo horizontal, rodando, con 3,1 m/s como mucho: eliges la carga, d\
ónde empieza y el rozamiento. ¿Hasta qué altura puede subir el aro en 6 s?","Aterrizar en pie","Haz que el aro aterrice con la carga arriba del todo. Todo va\
le; el primer salto debe tener al menos 5 cm de altura.","Saltar sin derrapar","En suelo horizontal el aro empieza rodando con la carga abajo, a 10 m/s como muc\
ho, y μ no pasa de 1,5. Antes de saltar no debe derrapar; patinar sí puede. ¿Hasta qué altura salta?","Solo contacto rígido.","El plano debe ser horizontal\
.","Debe ser en la Tierra.","La restitución debe ser 0.","El radio debe seguir siendo 1 m, sin piezas.","Como mucho el 90 % de la masa puede estar en la carga.",
"El aro debe darse por la fracción de carga.","Debe empezar rodando.","Como mucho 10 m/s.","Como mucho 3,1 m/s.","Como mucho 6 s.","No salta.","Sube {height}.",
"El primer salto es demasiado bajo.","Aterriza a {off} de lo más alto.","La carga debe empezar abajo.","El rozamiento debe ser como mucho 1,5.","Derrapa antes \
de saltar.","¿Primera vez?","Ocho preguntas cortas: adivina y luego reproduce.","Empezar la visita","Ahora no","El aro, antes de soltarlo.","Reproducir","Sigui\
ente","Atrás","Hecho","Paso {number} de {all}","Salir de la visita","Di primero qué esperas y luego reproduce.","Tu respuesta","{points} de 100 puntos.","Tien\
es {sum} de {most} puntos.","{what} con la carga a {angle}","Dibuja la curva: mueve los puntos arriba y abajo","La pregunta de Littlewood","Un aro sin masa llev\
a un peso en la llanta. Con el peso arriba recibe el menor empujón y rueda. J. E. Littlewood preguntó en 1953 qué ocurre cuando el peso está a la altura del cen\
tro.","¿Qué crees?","Sigue rodando.","Salta: el aro deja el plano.","El peso cae libremente y el aro roza el plano debajo de él.","A {angle} ya no hay fuerza\
 de contacto.","Littlewood dijo que el aro salta. Pero la fuerza de contacto es nula, no hacia arriba: el peso cae libremente y una llanta sin masa lo sigue por\
 el plano. Para saltar, un aro necesita algo de masa en la llanta.","Un anillo con masa","Ahora un cuarto de la masa está en el anillo. De nuevo la carga está a\
rriba y el aro recibe el menor empujón.","Dibuja la velocidad del centro del aro durante la primera vuelta.","Velocidad del centro","Con la carga abajo el cent\
ro va a {speed} m/s.","El punto más bajo de un aro que rueda está en reposo. Ahí la carga no tiene energía cinética, y el anillo ligero tiene toda la que ha per\
dido la carga pesada: va más rápido que una piedra que cae desde la misma altura.","Por qué desliza","Un empujón más fuerte: 2,8 m/s arriba. Rodar exige roza\
miento, y el rozamiento tiene un límite: como mucho μ N.","¿Dónde está la carga cuando el rozamiento cede por primera vez? Gira la marca.","Ángulo de la ca\
rga donde empieza a deslizar","Empieza a deslizar a {angle}. Ahí el plano soporta solo el {share} del peso.","En su camino hacia abajo la carga apenas aprieta \
el plano, así que N es pequeña, mientras que el anillo debe acelerarse: eso exige rozamiento. Mira el diagrama «Uso del rozamiento»: llega a 1.","El salto",
"Un poco más rápido, 3,1 m/s. Esta vez el aro deja el plano antes de acabar la primera vuelta.","¿Dónde está la carga cuando el aro despega? Gira la marca.",
"Ángulo de la carga al despegar","Despega a {angle}, mientras su llanta desliza a {slip} m/s.","A un aro que rueda el plano lo frenaría mientras sube la carga.\
 El rozamiento es demasiado débil para eso: la llanta patina, el aro sigue girando deprisa y la carga lo arranca del plano antes de llegar arriba.","El aterriz\
aje","El aro está en el aire. Su centro de gravedad sigue una parábola y gira de manera uniforme.","¿Qué hace justo después de aterrizar?","Rueda de inmedi\
ato.","Derrapa: la llanta desliza hacia delante.","Patina: la llanta gira demasiado deprisa.","Rebota.","Estuvo {time} s en el aire y subió {height} cm; aterriz\
a con la carga a {angle}.","Un impacto no dura nada, pero su rozamiento es tan fuerte como su empuje: aquí basta para detener todo deslizamiento. Con menos roza\
miento, o más restitución, el aterrizaje sería otro. Pruébalo después.","¿Más rozamiento, más salto?","Tres aros reciben el mismo empujón de 3,1 m/s, en\
 planos con rozamiento 0,05, 0,2 y 1,0.","¿Cuál salta más alto?","Suben {low} cm, {middle} cm y {high} cm. (Los dos primeros son A y B.)","Sobre hielo nada i\
mpulsa el giro; con rozamiento sin fin nada desliza. El salto necesita ambas cosas: rozamiento bastante para girar deprisa en la bajada, y no tanto que lo frene\
 en la subida.","Lo que los sólidos rígidos no pueden decidir","Se lanza un aro de modo que deslice deprisa sobre un plano rugoso. Las leyes del sólido rígido\
 con rozamiento seco deben decir qué ocurre después.","¿Qué dicen?","Sale volando.","Un impacto detiene el deslizamiento de golpe.","Ambas cosas cumplen las\
 leyes.","El aro A y el aro B empiezan igual, y ambos movimientos cumplen todas las leyes.","Painlevé lo descubrió en 1895. Para un sólido rígido las leyes tien\
en aquí dos respuestas, y en otros estados ninguna. Los cuerpos reales ceden un poco, y eso decide: elige el contacto flexible en «Contacto».","Te toca a ti",
"Toma el aro: gira la carga, levántalo y suéltalo, dale un impulso, inclina el plano. O acepta un reto y mira cómo tu puntuación se calcula del propio movimient\
o.","Mostrar el aro a toda velocidad, una vez, sin comentar. «Lo empujo. ¿Solo rueda?»","Todos predicen dónde está la carga al despegar. Contar los votos por\
 cuartos de vuelta.","Energía en la bajada, por parejas: ¿quién tiene la energía cuando la carga está en reposo?","Elevación arriba: ¿a qué velocidad es nu\
la la fuerza del suelo?","La película otra vez, a cámara lenta y con fuerzas; parar al despegar. Comparar con los votos.","Cada grupo toma una velocidad de la\
 hoja de trabajo; resultados en la pizarra.","¿Por qué? ¿Qué debe frenar el giro en la subida, qué fuerza puede tener y qué pasa si es demasiado débil?",
"Una frase cada uno: «El aro salta porque…»","La carga tira del aro hacia arriba en lo alto, por eso salta ahí.","Solo si es muy rápido. Los más lentos sal\
tan antes de lo alto, tras deslizar.","Salta abajo, donde es más rápido.","Ahí el suelo empuja más: hay que desviar la carga hacia arriba.","Nada puede ser \
más rápido que una piedra que cae.","El anillo sí: recibe la energía de una carga que ha quedado en reposo.","El rozamiento siempre frena.","Actúa contra el\
 deslizamiento. En la subida apunta hacia delante.","Más rozamiento, más salto.","Hay un rozamiento óptimo intermedio.","Un aro más pesado se comporta de otr\
o modo.","Solo cuentan las proporciones de masa.","Antes de la película: ¿dónde está la carga cuando el aro deja el suelo? Marca el lugar y da una razón.",
"El aro recibe solo el menor empujón y rueda. ¿Cuánta energía potencial se ha liberado cuando la carga está abajo?","Mientras una rueda rueda, su punto más\
 bajo está en reposo. ¿Qué parte del aro tiene entonces energía cinética y a qué velocidad va el centro?","¿Qué velocidad tiene una piedra que cae desde l\
a altura de la carga? ¿Por qué puede ser más rápido el aro?","Halla la fuerza del suelo arriba para 1,0 m/s y la velocidad a la que se anula.","En el labora\
torio: ¿qué hace el aro en sus primeros 1,5 s y a qué ángulo salta? Completa la tabla.","Halla la menor velocidad con la que el aro salta, con 1 cm/s de pre\
cisión.","A 2,2 m/s el aro deja el suelo mientras su llanta desliza. ¿Por qué le ayuda a saltar el deslizamiento?","Mostrar","Enseñar con el aro","Hoja de t\
rabajo","Soluciones","Ejercicios","Una clase de 45 minutos","Minuto","Movimiento","Lo que suelen pensar los estudiantes","Idea","Lo correcto","Hoja de trabajo: \
el aro que salta","Un anillo delgado de radio 0,40 m tiene una masa de 0,25 kg. En su llanta va fijada una carga de 0,75 kg. El aro está sobre un suelo horizont\
al con la carga arriba y se empuja hacia la derecha. Rozamiento: μ = 1; g = 9,81 m/s².","fases","¿salta?","¿a qué ángulo?","Imprimir","La visita pregunta \
antes de mostrar; la presentación llena la pantalla; la tabla da números a cada estudiante.","inf","mayor que {least}","como mínimo {least}","como mínimo {le\
ast} (se admite inf)","como mucho {most}","un número finito","un número entero","«{word}» o «{word2}»","«{word}», «{word2}» o «{word3}»","Resistenci\
a a la rodadura","Resistencia a la rodadura: par contra el giro, dividido por R N","Desliza, salta","cuesta arriba (β < 0) no hay umbral: que deslice o salte de\
pende de dónde da la vuelta; el mapa lo muestra","«rigid» para un mapa","x.cells por y.cells = {cells} debe ser como mucho {most} en el laboratorio.","{one} \
y {other} no pueden ser ambos ejes: dicen lo mismo de dos maneras.","x.path e y.path son ambos {path} y deben ser distintos.","perdida por resistencia a la roda\
dura","Resistencia a la rodadura f","{name} = {value} debe estar entre -pi/2 y pi/2 (radianes).","{word} no es una clave conocida; las conocidas son {word2}.","\
{one} no puede darse junto con {other}.","{one} = {value} no debe superar {other} = {limit}.","plane.mu_static = inf debe ser finito con contact.model = 'compli\
ant'.","hoop.parts no debe estar vacío.","Esto tarda más de {time} s; pide un movimiento más corto o menos celdas.","El laboratorio está ocupado; inténtalo d\
e nuevo en {time} segundos.","El laboratorio está ocupado; inténtalo de nuevo en 1 segundo.","El cálculo ha fallado.","El proceso que calculaba esto ha termi\
nado.","duration = {value} debe ser como mucho {most} s en el laboratorio; la biblioteca misma no tiene ese límite.","duration = {value} s son unas {turns} vue\
ltas a esta velocidad y radio, y en el laboratorio como mucho {most}; la biblioteca misma no tiene ese límite.","hoop.parts tiene {count} piezas y debe tener c\
omo mucho {most} en el laboratorio.","contact.stiffness, contact.slip_speed y duration requieren unos {steps} pasos de integración, y en el laboratorio como muc\
ho {most}.","Una celda de este mapa son unas {turns} vueltas, y en el laboratorio como mucho {most}.","x e y dan {count} celdas con unas {turns} vueltas en tota\
l, y en el laboratorio como mucho {most}; toma menos celdas, velocidades menores o una duración más corta.","duration = {value} debe ser como mucho {most} s p\
ara una película del laboratorio.","A azul, B ocre; el trazo indica la magnitud; números de {hoop}; {hands}","Lo que viene después de {time} s depende de más \
cifras de las que tienen los números de esta página; hophoop lab y Python toman las que hagan falta.","Huella","Sin huella: este movimiento depende de más cif\
ras de las que calcula esta página.","Un hash de todos los sucesos: el mismo donde hophoop calcula los mismos bits, también en Python","✓ Los mismos bits que \
en Python","✓ Los mismos bits que donde se hizo el enlace","Los bits difieren: {own} aquí, {other} en Python.","Los bits difieren: {own} aquí, {other} donde \
se hizo el enlace, quizá con otra versión.","hophoop lab: juega con el aro saltarín","Pon un aro saltarín en una página tuya","Una etiqueta y un script mue\
stran un aro vivo en un blog, una página de curso o unas diapositivas. El movimiento se calcula en el navegador de quien lee; no se envía nada a ninguna parte.",
"Elige un movimiento en el laboratorio y copia aquí su enlace.","Escenario: un enlace del laboratorio, o lo que va tras su signo de interrogación","Lo que aco\
mpaña al reproductor","controles","diagramas","teoría","mapa","Como etiqueta","La etiqueta","Copiar la etiqueta","Como marco, donde no se permiten scripts","E\
l marco","Copiar el marco","Como código QR","Cómo se ve","Copiado.","Un aro saltarín","Guardar una imagen (SVG)","Una imagen en el espacio no tiene líneas qu\
e guardar: toma el PNG o sal del 3D.","La imagen es demasiado grande para este navegador.","Flechas","Qué haría un poco más (a)","Qué haría un poco más","\
Un poco más","Hacerlo","Cada suceso, con este paso","Qué cambia en cada suceso","suceso","lugar","altura","ángulo de la carga","Es infinito: no hay más.","E\
sto necesita un navegador que ejecute WebAssembly.","No se pudo cargar la parte de la página que calcula esto; elígelo de nuevo cuando haya red.","Nada: ningú\
n suceso se mueve.","Las flechas se dibujan en la imagen plana: sal de 3D para verlas.","Las flechas de la imagen van de donde toca la llanta a donde tocaría, {\
factor} veces más largas.","Desde {what} en {time} s no hay derivada: {reason}.","Solo hacia un lado: {reason}.","{amount} más a la derecha","{amount} más a l\
a izquierda","{amount} más tarde","{amount} antes","{amount} más alto","{amount} más bajo","{amount} más largo","{amount} más corto","{amount} más en el ai\
re","{amount} menos en el aire","empieza {amount} más tarde","empieza {amount} antes","{amount} más rápido","{amount} más lento","El salto: {list}.","Salto \
{number}: {list}.","El primer suceso, {what}: {list}.","Al final, a los {time} s: {list}.","flechas: qué haría un poco más","una magnitud que provoca el suce\
so solo toca el cero allí","el movimiento está en la frontera de dos clases: el menor cambio puede llevar a otros sucesos","la restitución es 0 y la llanta ha\
 aterrizado: con cualquier otra rebotaría","el movimiento empieza en contacto: con la llanta levantada o lanzada rebotaría, y sus sucesos son otros","el desli\
zamiento llega a p_σ = 0, donde la fuerza de contacto no tiene límite","el aro sin masa (γ = 1) es un límite singular en cuanto se pierde la fuerza de contact\
o","sin rozamiento el aro reposa solo en la frontera de dos clases","el movimiento no tiene respuesta desde allí","el parámetro está en el borde de lo permitid\
o","las derivadas de los dos lados difieren","Con contacto flexible no se calculan derivadas: elige el modelo de contacto rígido.","Se muestra el resto del enl\
ace. Corrija la dirección o continúe desde aquí.","Se ha ignorado en el enlace: {names}.","{stars} {points} puntos, mostrados y no contados. {what}","{label}\
 = {value} es demasiado grande.","Saltar a la respuesta","No es así.","Pausa","Compartir","Todo","Vista sencilla","Mostrar todo","Este movimiento tiene también\
 otros ajustes.","Arrastra la carga","Acerca de hophoop","hophoop calcula con exactitud cómo un aro con una carga en el borde rueda, desliza, salta y cae.","Ve\
rsión","Licencia","Licencias de todo lo que contiene la página","Documentación","La documentación","docs/index.md en el código fuente; esta página: docs/lab\
.md","Órdenes"],Ui=Object.fromEntries(Object.keys(Re).map((s,e)=>[s,Xh[e]]));var ec=["roulement","patinage","dérapage","vol","effleurement","glissement −","glissement +","roule","patine","dérape","vole","effleure le plan","roule à pa\
rtir de {angle}","patine à partir de {angle}","dérape à partir de {angle}","vole à partir de {angle}","effleure le plan à partir de {angle}","saute à {angl\
e}","retombe à {angle}","rebondit à {angle}","glisse dans l’autre sens à partir de {angle}","cesse brusquement de glisser à {angle}","fait demi-tour à {an\
gle}","finit de rebondir à {angle}","rencontre le paradoxe de Painlevé à {angle}","rencontre l’indétermination de Painlevé à {angle}","se coince à {angl\
e}","gagne de l’énergie (Kane) à {angle}","effleure à partir de {angle}","repose à {angle}","part à {angle}","glisse à partir de {angle}","{what} et enc\
ore {count} fois","… (encore {count})","Il s’est immobilisé.","La force normale croît sans limite (coincement dynamique) : la mécanique du solide ne donne \
pas de suite au mouvement.","Le modèle ne détermine pas la suite du mouvement.","La limite du nombre d’événements (contact.max_events), ou du calcul pour un m\
ouvement, a été atteinte avant la fin.","Il part et {verb}, la masselotte à {angle} et le centre à {speed} m/s.","Il part en l’air, la masselotte à {angle} \
et le centre à {speed} m/s.","Il part en effleurant le plan, la masselotte à {angle} et le centre à {speed} m/s.","À {angle} il {verb} : le frottement est ép\
uisé, la jante tourne trop vite pour son trajet.","À {angle} il {verb} : le frottement est épuisé, la jante glisse vers l’avant.","À {angle} il roule de n\
ouveau ; le glissement a cessé.","À {angle} le glissement s’inverse ; il {verb}.","Il saute à {angle}.","Il saute à {angle}. Il monte de {height} et reste \
{time} s en l’air.","Un impact sans collision à {angle} arrête le glissement ; puis il {verb}.","Il retombe à {angle} avec {speed} m/s vers le bas et rebond\
it.","Il retombe à {angle} avec {speed} m/s vers le bas et {verb}.","Il fait demi-tour à {angle}.","Il fait demi-tour à {angle}, et maintenant il {verb}.","L\
e centre est au plus haut à {angle} : l’écart est de {height}.","Ici, à {angle}, s’achève une infinité de rebonds.","Paradoxe de Painlevé à {angle} : a\
ucune force de contact n’est compatible avec ce glissement.","Paradoxe de Painlevé à {angle} : plusieurs forces de contact sont compatibles.","Coincement dy\
namique à {angle} : la force de contact croît sans limite.","La loi d’impact de Newton a créé {energy} J (exemple de Kane).","À {angle} il n’y a plus de f\
orce de contact : la masselotte tombe en chute libre et la jante effleure le plan.","Il repose à {angle}.","Il repose à {angle}, mais pas de façon stable.","\
Il rebondit encore {count} fois.","… et encore {count}.","Glisse","Saute","Saute aussitôt","Frottement pour rouler sans glisser","Paradoxe de Painlevé","Coi\
ncement dynamique","Repos stable","Fin du roulement","glisserait au-delà de {speed} m/s","glisserait : la moindre poussée suffit","sauterait au premier tour a\
u-delà de {speed} m/s","sauterait au premier tour : la moindre poussée suffit","sauterait aussitôt au-delà de {speed} m/s","sauterait aussitôt : à toute vit\
esse","jamais, à aucune vitesse","aucun frottement ne le fait rouler sans glisser","μ = {mu} le ferait rouler sans glisser (ici, cela suffit)","μ = {mu} le fe\
rait rouler sans glisser (plus qu’ici)","jamais","à partir de μ = {mu}, à {angle} : possible ici","à partir de μ = {mu}, à {angle} : pas ici","peut term\
iner un glissement à {angles}","avec la masselotte à {angle}","à {angle} le frottement est épuisé","à {angle} la force de contact a disparu","Part de la m\
asselotte","Part de la masse qui est dans la masselotte d’un cerceau idéal","Excentricité","Distance du centre de gravité au centre, divisée par le rayon",
"Moment d’inertie réduit","Moment d’inertie par rapport au centre de gravité, divisé par m R²","Rayon","Rayon de la jante","Masse","Masse totale","Coeff\
icient de frottement","Coefficient de frottement, statique et dynamique","Frottement statique","Frottement dynamique","Inclinaison","Inclinaison du plan, descen\
te vers +x","Pesanteur","Restitution","Coefficient de restitution d’un impact","Vitesse","Vitesse du centre au départ en roulant","Angle de la masselotte","A\
ngle entre la normale au plan et le centre de gravité","Hauteur de l’écart","Écart entre la jante et le plan","Vitesse le long du plan","Vitesse du centre \
le long du plan","Vitesse vers le haut","Vitesse du centre en s’éloignant du plan","Vitesse angulaire","Raideur","Raideur du contact","Vitesse de glissement",
"Vitesse de glissement sur laquelle le frottement s’établit","Restitution pour laquelle l’amortissement est choisi","Durée","Durée du mouvement","Loi d’i\
mpact","Loi de restitution","Stronge (énergie)","Poisson (impulsion)","Newton (vitesse)","Painlevé : deux solutions","Ce qui suit un contact indéterminé","i\
mpact","Modèle de contact","rigide","souple","Force normale","Loi de frottement","Frottement régularisé","lisse (tanh)","linéaire","soies (peut retenir)","K\
elvin–Voigt","Hunt–Crossley","Vitesse v₀","Angle de la masselotte θ₀","Vitesse le long du plan ẋ₀","Vitesse angulaire θ̇₀","Hauteur de l’écart \
y₀","Part de la masselotte γ","Excentricité ε","Moment d’inertie réduit κ","Rayon R","Frottement μ","Inclinaison β","Pesanteur g","Restitution e","Te\
rre","Lune","Mars","Jupiter","Apesanteur","ce qui se passe au premier tour","hauteur du premier saut","angle de décollage","durée du premier saut","plus grand\
e utilisation du frottement","énergie perdue","angle à la fin","paradoxe de Painlevé ou coincement rencontré","comment cela finit","durée","tours","demi-to\
ur","décollage","repos","coincement","indéterminé","limite d’événements","non","oui","aucun","non permis","et {count} autres","L’article","Le cerceau d\
e Littlewood","Paradoxes","Autres","Il saute : 3,1 m/s","Glisse deux fois, puis quitte le plan juste avant un tour complet et vole pendant 0,76 s.","Il glisse :\
 2,8 m/s","Le frottement est épuisé deux fois par tour ; chaque glissement est plus faible que le précédent, et aucun n’est le dernier.","Il roule : 2 m/s",
"Roulement sans glissement, plus rapide et plus régulier qu’après un départ lent, et près de la limite du frottement.","La plus petite poussée : 0,1 m/s",
"Presque immobile avec la masselotte en haut, rapide avec la masselotte en bas ; 38 % du frottement est utilisé.","Peu de frottement : 0,1 m/s, μ = 0,3","Le g\
lissement coûte l’énergie qu’exige un tour complet : le cerceau se balance.","Toute la masse dans la masselotte","Un anneau sans masse : à 90° il n’y a pl\
us de force de contact ; la masselotte tombe, la jante effleure le plan.","Toute la masse dans la masselotte, poussé","Avec une poussée la force de contact dis\
paraît plus tôt, à cos θ = v₀²/(gR).","Presque toute la masse dans la masselotte","γ = 0,99 : ce que fait un anneau réel au lieu du saut de Littlewood.",
"Painlevé : aucune solution","Aucune force de contact n’est compatible avec ce glissement. Un impact sans collision l’arrête aussitôt.","Vol et impact ob\
éissent tous deux aux lois. Choisissez sous « Plan ».","Un glissement rapide après un saut : la force de contact croît sans limite en un temps fini, et aucun\
e loi ne dit la suite.","Kane : de l’énergie à partir de rien","La loi d’impact de Newton avec frottement crée deux joules. Celle de Stronge, non.","En d\
escente","Sur une pente de 10° le cerceau prend de la vitesse tour après tour, jusqu’à ce qu’il saute.","Rebonds sans nombre","Lâché en rotation, restitu\
tion 0,5 : une infinité de rebonds en un temps fini.","Sur la Lune","Le saut de l’article sous la pesanteur lunaire : tout est 2,46 fois plus lent.","Exemple\
s","Exemples…","Annuler (z)","Rétablir (y)","Comparer","Comparer deux cerceaux","Sombre ou clair (d)","Touches et aide (?)","Touches et aide","labo","Apprend\
re","Langue","Cerceau A","Cerceau B","Quel cerceau les réglages modifient","Paramètres","Aller au lecteur","Cerceau","Plan","Départ","Contact","Donné par","\
part de la masselotte γ","ε et κ","pièces réelles","Où","ailleurs","frottements statique et dynamique séparés","Part","en roulant","dans un état quelcon\
que","auto {value}","{name}, valeur exacte en {unit}","{name}, valeur exacte","Anneau","Disque","Masse ponctuelle","Tige","masse","rayon intérieur","rayon exté\
rieur","rayon","distance au centre","longueur","Ajouter une pièce","+ ajouter une pièce…","Retirer la pièce {number}, {what}","{name} = {value} doit être {\
rule}.","{name} = {value} doit être un nombre, par exemple 2,5.","{name} = {value} doit être un nombre.","de {least} à {most}","de {least} à {most}, ou inf",
"0 ou de {least} à {most}","0, de {least} à {most}, ou inf","au plus {most} dans le labo","0 pour le cerceau sans masse (hoop.inertia_ratio = 0)","« rigid » p\
our le cerceau sans masse (hoop.inertia_ratio = 0)","Le serveur ne répond pas. Ce qui est là continue ; pour le modifier, relancez `hophoop lab`.","Le serveur\
 a répondu {status}.","Le noyau du notebook ne répond pas ; relancez la cellule.","cerceau","phase","temps","angle","écart","vitesse de jante","masselotte","\
centre de gravité","le même en vol","A devant, B derrière","Le cerceau","Le cerceau.","Temps","{time} secondes, {what}","Trajectoires (t)","Forces (f)","Vite\
sse de la jante (c)","Tout le trajet (w)","En 3D (3)","Trajectoires","Forces","Vit. jante","Trajet entier","Lecture (espace)","Pause (espace)","Vitesse du film",
"Au début (Début)","Événement précédent (Maj ←)","Événement suivant (Maj →)","Une image en arrière (←)","Une image en avant (→)","retombée","A\
u vol suivant (h)","À la retombée suivante (l)","Ce mouvement n’a pas de vol.","Ce mouvement n’a pas de retombée.","{what} à {angle}, {time} s","départ",
"le glissement commence","le glissement cesse","le glissement s’inverse","décollage","fait demi-tour","point le plus haut","les rebonds cessent","Painlevé : \
plusieurs solutions","gain d’énergie (Kane)","l’effleurement commence","au repos","fin","Ce qui se passe","Ce qui arrive au cerceau {hoop}","Le mouvement e\
n mots","(tous les événements ne sont pas montrés)","Ce que dit la théorie","Ce que dit la théorie du cerceau {hoop}","Vitesses","vitesse [m/s]","v (centre\
)","Énergies et pertes","énergie [J]","cinétique","potentielle","totale","perdue par frottement","perdue dans l’amortisseur","perdue dans les impacts, part\
 normale","Forces de contact","force [N]","normale N","frottement F","Utilisation du frottement","À votre choix","Ce que montre votre diagramme","Axe horizonta\
l des diagrammes","en fonction de : {quantity}","Tout le mouvement","glissez pour y aller ; deux doigts agrandissent","cliquez pour y aller, tirez pour agrandir\
 ; après un clic, ou avec Ctrl, la molette agrandit ; double-clic pour tout","{name} de {low} à {high}","Diagramme : {title} en {unit}.","θ mod 360°","Échap",
"{name} [{unit}]","angle dans un tour","position du centre","écart sous la jante","hauteur du centre de gravité","vitesse du centre","vitesse de rotation","vi\
tesse d’éloignement du plan","vitesse de glissement","vitesse angulaire","force normale","force de frottement","utilisation du frottement","énergie cinétique",
"énergie potentielle","énergie totale","Plan de θ et θ̇","Plan de l’angle et de la vitesse angulaire avec les régions de roulement, de glissement et de vol",
"angle θ dans un tour [°]","Couleurs : la phase qui suit un contact sans glissement.","Hachures : glissement qui rencontre le paradoxe de Painlevé.","Touchez\
 pour y aller ; deux doigts agrandissent.","Cliquez pour y aller ; après un clic, ou avec Ctrl, la molette agrandit ; double-clic pour tout.","Carte","de","Hor\
izontale","Verticale","Ce que montre la carte","Carte des mouvements","Carte des mouvements. Les flèches déplacent la marque, Entrée prend le mouvement, plus et\
 moins agrandissent.","Agrandir la carte","Réduire la carte","Carte entière","Touchez pour mettre ce mouvement dans le lecteur ; deux doigts agrandissent.","U\
n clic met ce mouvement dans le lecteur ; après un clic, ou avec Ctrl, la molette agrandit ; tirez pour déplacer ; double-clic pour tout.","calcul de {count} \
mouvements…","{count} mouvements","{count} mouvements, avec contact rigide","partant en roulant, bien que ce mouvement parte autrement","partant d’un état que\
lconque, bien que ce mouvement parte en roulant","Partager et enregistrer","Copier un lien vers ce mouvement","Enregistrer le scénario (TOML)","Enregistrer les\
 états (CSV)","Enregistrer le mouvement (netCDF)","Enregistrer les évènements (JSON)","Enregistrer un film (MP4)","Enregistrer une image (PNG)","Filmer un pa\
ssage (WebM)","Afficher le code Python","Le même mouvement en Python","Le lien est copié.","Le lien vers ce mouvement","Le film se fait ; cela prend un moment\
…","Récupération de {name}…","{name} est là.","Ce navigateur ne peut pas enregistrer le canevas ; prenez le MP4.","Enregistrement d’un passage…","Le \
film est là.","Le scénario en fichier","Copier","Copié","Fermer","Un anneau lesté d’une masselotte roule sur un plan. Le frottement ne retient pas sans limit\
e et le plan ne peut que pousser : alors il glisse, saute, retombe – ou fait ce que la mécanique du solide ne peut décider. Bougez un réglage et voyez.","P\
hases","Marques sur la barre de temps","Touches","espace","lecture, pause","une image","Maj ← →","événement précédent, suivant","vol, retombée suivants",
"plus lent, plus vite","Début Fin","début, fin","trajectoires, forces, vitesse de la jante, trajet","en 3D","agrandir, revenir","quitter un champ, un menu, un\
e image que la molette agrandit","z y  Ctrl Z","annuler, rétablir","sombre, clair","Python","la jante ne glisse pas","glissement : la jante tourne trop vite po\
ur son trajet (glissement −, pour un cerceau qui avance)","glissement : la jante glisse vers l’avant (glissement +, pour un cerceau qui avance)","le saut : \
du décollage à la retombée","une jante sans masse qui touche sans force","décollage, retombée","Paradoxe de Painlevé : aucune solution, plusieurs","une in\
finité de rebonds s’achève","l’effleurement commence, repos","Les touches seules (lettres, chiffres, signes) font ce que dit le tableau","Le cerceau dans \
votre main","Inclinaison du plan","Incliner le plan : tirer, ou flèches","Le cerceau : hauteur et vitesse","Lever, rouler ou lancer le cerceau : tirer, ou flèc\
hes","Angle de la masselotte","Tourner la masselotte : tirer, ou flèches","écart {height}, vitesse {speed} m/s","Répéter","Ralenti : un dixième de la vitess\
e","Son du contact","Présentation en plein écran","Visite guidée","Tableau du mouvement","Tableau du mouvement, lignes","Présentation","Pour les enseignants",
"Tableau","Toutes les","Enregistrer en CSV","Colonnes","Les {count} premières lignes.","Défis","Quitter les défis","Quel défi","Score","Recommencer","Montre\
r un des meilleurs","{stars} {points} points. {what}","Votre meilleur : {points} points.","Sauter le plus haut","Sur sol horizontal, en roulant, à 3,1 m/s au pl\
us : vous choisissez la masselotte, sa position de départ et le frottement. À quelle hauteur le cerceau peut-il monter en 6 s ?","Retomber debout","Faites ret\
omber le cerceau avec la masselotte tout en haut. Tout est permis ; le premier saut doit faire au moins 5 cm.","Sauter sans déraper","Sur sol horizontal le cer\
ceau part en roulant, la masselotte en bas, à 10 m/s au plus, et μ vaut au plus 1,5. Avant de sauter il ne doit pas déraper ; patiner est permis. À quelle haute\
ur saute-t-il ?","Contact rigide seulement.","Le plan doit être horizontal.","Ce doit être sur Terre.","La restitution doit être 0.","Le rayon doit rester 1 \
m, sans pièces.","Au plus 90 % de la masse dans la masselotte.","Le cerceau doit être donné par la part de la masselotte.","Il doit partir en roulant.","Au p\
lus 10 m/s.","Au plus 3,1 m/s.","Au plus 6 s.","Il ne saute pas.","Il monte de {height}.","Le premier saut est trop bas.","Il retombe à {off} du sommet.","La m\
asselotte doit partir d’en bas.","Le frottement doit être au plus 1,5.","Il dérape avant de sauter.","Première visite ?","Huit questions brèves : devinez, \
puis lancez.","Commencer la visite","Pas maintenant","Le cerceau, avant d’être lâché.","Lancer","Suivant","Retour","Terminé","Étape {number} sur {all}","\
Quitter la visite","Dites d’abord ce que vous attendez, puis lancez.","Votre réponse","{points} points sur 100.","Vous avez {sum} points sur {most}.","{what}\
 avec la masselotte à {angle}","Tracez la courbe : tirez les points vers le haut ou le bas","La question de Littlewood","Un cerceau sans masse porte un poids s\
ur sa jante. Le poids en haut, il reçoit la plus petite poussée et roule. J. E. Littlewood demanda en 1953 ce qui se passe quand le poids est à la hauteur du ce\
ntre.","Qu’en pensez-vous ?","Il continue de rouler.","Il saute : le cerceau quitte le plan.","Le poids tombe en chute libre, et le cerceau effleure le plan s\
ous lui.","À {angle} il n’y a plus de force de contact.","Littlewood disait que le cerceau saute. Mais la force de contact est nulle, non dirigée vers le hau\
t : le poids tombe en chute libre et une jante sans masse le suit le long du plan. Pour sauter, il faut au cerceau un peu de masse dans la jante.","Un anneau av\
ec masse","À présent un quart de la masse est dans l’anneau. De nouveau la masselotte est en haut et le cerceau reçoit la plus petite poussée.","Tracez la\
 vitesse du centre du cerceau pendant le premier tour.","Vitesse du centre","Avec la masselotte en bas, le centre a {speed} m/s.","Le point le plus bas d’un cer\
ceau qui roule est au repos. Là, la masselotte n’a pas d’énergie cinétique, et l’anneau léger a tout ce que la lourde masselotte a perdu : il est plus rapide qu\
’une pierre tombant de la même hauteur.","Pourquoi il glisse","Une poussée plus forte : 2,8 m/s en haut. Rouler exige du frottement, et le frottement a une l\
imite : il vaut au plus μ N.","Où est la masselotte quand le frottement cède pour la première fois ? Tournez la marque.","Angle de la masselotte où il comme\
nce à glisser","Il commence à glisser à {angle}. Là, le plan ne porte que {share} du poids.","Dans sa descente la masselotte appuie peu sur le plan : N est \
petite, alors que l’anneau doit accélérer, ce qui demande du frottement. Voyez le diagramme « Utilisation du frottement » : elle atteint 1.","Le saut","Un\
 peu plus vite, 3,1 m/s. Cette fois le cerceau quitte le plan avant la fin du premier tour.","Où est la masselotte quand le cerceau décolle ? Tournez la marque.",
"Angle de la masselotte au décollage","Il décolle à {angle}, tandis que sa jante glisse à {slip} m/s.","Le plan freinerait un cerceau qui roule tandis que l\
a masselotte remonte. Le frottement est trop faible pour cela : la jante patine, le cerceau continue de tourner vite, et la masselotte l’arrache du plan avant d\
’être en haut.","La retombée","Le cerceau est en l’air. Son centre de gravité suit une parabole et il tourne uniformément.","Que fait-il juste après êtr\
e retombé ?","Il roule aussitôt.","Il dérape : la jante glisse vers l’avant.","Il patine : la jante tourne trop vite.","Il rebondit.","Il est resté {time} \
s en l’air et est monté de {height} cm ; il retombe avec la masselotte à {angle}.","Un impact ne dure pas, mais son frottement est aussi fort que sa poussée\
 : ici il suffit à arrêter tout glissement. Avec moins de frottement, ou plus de restitution, la retombée serait autre. Essayez ensuite.","Plus de frottement\
, plus haut ?","Trois cerceaux reçoivent la même poussée de 3,1 m/s, sur des plans de frottement 0,05, 0,2 et 1,0.","Lequel saute le plus haut ?","Ils monten\
t de {low} cm, {middle} cm et {high} cm. (Les deux premiers sont A et B.)","Sur la glace rien n’entraîne la rotation ; avec un frottement sans fin rien ne gliss\
e. Le saut exige les deux : assez de frottement pour tourner vite à la descente, et pas assez pour être freiné à la remontée.","Ce que les solides ne peuve\
nt décider","On lance un cerceau de sorte qu’il glisse vite sur un plan rugueux. Les lois des solides avec frottement sec doivent dire la suite.","Que disent\
-elles ?","Il s’envole.","Un impact arrête aussitôt le glissement.","Les deux obéissent aux lois.","Les cerceaux A et B partent de même, et les deux mouvem\
ents obéissent à toutes les lois.","Painlevé l’a trouvé en 1895. Pour un solide, les lois ont ici deux réponses, dans d’autres états aucune. Les corps réels c\
èdent un peu, et cela décide : choisissez le contact souple sous « Contact ».","À vous","Prenez le cerceau : tournez la masselotte, levez-le et lâchez-le, \
lancez-le, inclinez le plan. Ou relevez un défi, et voyez votre score calculé d’après le mouvement lui-même.","Montrer le cerceau à pleine vitesse, une fo\
is, sans commentaire. « Je le pousse. Ne fait-il que rouler ? »","Chacun prédit où est la masselotte au décollage. Compter les voix par quarts de tour.","L\
’énergie à la descente, par deux : qui a l’énergie quand la masselotte est au repos ?","Soulèvement en haut : à quelle vitesse la force du sol est-elle n\
ulle ?","Le film à nouveau, au ralenti et avec les forces ; arrêter au décollage. Comparer avec les voix.","Chaque groupe prend une vitesse de la fiche ; rés\
ultats au tableau.","Pourquoi ? Qu’est-ce qui doit freiner la rotation à la remontée, avec quelle force, et si c’est trop faible ?","Une phrase chacun : «\
 Le cerceau saute parce que… »","La masselotte tire le cerceau vers le haut au sommet, donc il saute là.","Seulement s’il est très rapide. Les plus lents sa\
utent avant le sommet, après avoir glissé.","Il saute en bas, où il est le plus rapide.","Là le sol pousse le plus fort : il faut dévier la masselotte vers l\
e haut.","Rien ne peut être plus rapide qu’une pierre qui tombe.","L’anneau le peut : il reçoit l’énergie d’une masselotte qui s’est arrêtée.","L\
e frottement freine toujours.","Il agit contre le glissement. À la remontée il est dirigé vers l’avant.","Plus de frottement, plus de saut.","Il y a un fro\
ttement optimal entre les deux.","Un cerceau plus lourd se comporte autrement.","Seules les parts de masse comptent.","Avant le film : où est la masselotte quan\
d le cerceau quitte le sol ? Marquez l’endroit et donnez une raison.","Le cerceau ne reçoit que la plus petite poussée et roule. Quelle énergie potentielle a \
été libérée quand la masselotte est en bas ?","Quand une roue roule, son point le plus bas est au repos. Quelle partie du cerceau a alors de l’énergie cinét\
ique, et quelle est la vitesse du centre ?","Quelle est la vitesse d’une pierre tombant de la hauteur de la masselotte ? Pourquoi le cerceau peut-il être plus r\
apide ?","Trouvez la force du sol au sommet pour 1,0 m/s, et la vitesse où elle s’annule.","Dans le labo : que fait le cerceau pendant ses 1,5 premières seco\
ndes, et à quel angle saute-t-il ? Remplissez le tableau.","Trouvez la plus petite vitesse pour laquelle le cerceau saute, à 1 cm/s près.","À 2,2 m/s le cerc\
eau quitte le sol tandis que sa jante glisse. Pourquoi le glissement l’aide-t-il à sauter ?","Montrer","Enseigner avec le cerceau","Fiche de travail","Corrig\
é","Exercices","Une séance de 45 minutes","Minute","Mouvement","Ce que pensent souvent les élèves","Idée","Ce qui est juste","Fiche de travail : le cerceau\
 sauteur","Un anneau mince de rayon 0,40 m a une masse de 0,25 kg. Une masselotte de 0,75 kg est fixée sur sa jante. Le cerceau est posé sur un sol horizontal, \
la masselotte en haut, et poussé vers la droite. Frottement : μ = 1 ; g = 9,81 m/s².","phases","saute-t-il ?","à quel angle ?","Imprimer","La visite interro\
ge avant de montrer ; la présentation remplit l’écran ; le tableau donne des nombres à chaque élève.","inf","supérieur à {least}","au moins {least}","a\
u moins {least} (inf est permis)","au plus {most}","un nombre fini","un nombre entier","« {word} » ou « {word2} »","« {word} », « {word2} » ou « {word3} »",
"Résistance au roulement","Résistance au roulement : couple opposé à la rotation, divisé par R N","Glisse, saute","en montée (β < 0) pas de seuil : qu’il g\
lisse ou saute dépend de l’endroit où il fait demi-tour ; la carte le montre","« rigid » pour une carte","x.cells fois y.cells = {cells} doit être au plus\
 {most} dans le labo.","{one} et {other} ne peuvent être tous deux des axes : ils disent la même chose de deux façons.","x.path et y.path sont tous deux {pat\
h} et doivent différer.","perdue par résistance au roulement","Résistance au roulement f","{name} = {value} doit être entre -pi/2 et pi/2 (radians).","{word\
} n’est pas une clé connue ; sont connues {word2}.","{one} ne peut pas être donné avec {other}.","{one} = {value} ne doit pas dépasser {other} = {limit}.",
"plane.mu_static = inf doit être fini avec contact.model = 'compliant'.","hoop.parts ne doit pas être vide.","Cela prend plus de {time} s ; demandez un mouvem\
ent plus court ou moins de cellules.","Le labo est occupé ; réessayez dans {time} secondes.","Le labo est occupé ; réessayez dans 1 seconde.","Le calcul a é\
choué.","Le processus qui calculait cela s’est arrêté.","duration = {value} doit être au plus {most} s dans le labo ; la bibliothèque elle-même n’a pas cet\
te limite.","duration = {value} s font environ {turns} tours à cette vitesse et ce rayon, au plus {most} dans le labo ; la bibliothèque elle-même n’a pas cette \
limite.","hoop.parts a {count} pièces et doit en avoir au plus {most} dans le labo.","contact.stiffness, contact.slip_speed et duration demandent environ {step\
s} pas d’intégration, au plus {most} dans le labo.","Une cellule de cette carte fait environ {turns} tours, au plus {most} dans le labo.","x et y font {count\
} cellules d’environ {turns} tours en tout, au plus {most} dans le labo ; prenez moins de cellules, des vitesses plus faibles ou une durée plus courte.","dur\
ation = {value} doit être au plus {most} s pour un film du labo.","A bleu, B ocre ; le tracé indique la grandeur ; nombres de {hoop} ; {hands}","Ce qui vient \
après {time} s dépend de plus de chiffres que n’en ont les nombres de cette page ; hophoop lab et Python en prennent autant qu’il faut.","Empreinte","Pas \
d’empreinte : ce mouvement dépend de plus de chiffres que cette page n’en calcule.","Un hachage de tous les événements : le même partout où hophoop calcule\
 les mêmes bits, aussi en Python","✓ Les mêmes bits qu’en Python","✓ Les mêmes bits que là où le lien a été créé","Les bits diffèrent : {own} ici\
, {other} en Python.","Les bits diffèrent : {own} ici, {other} là où le lien a été créé, peut-être avec une autre version.","hophoop lab : jouer avec le\
 cerceau sauteur","Mettre un cerceau sauteur dans une page à vous","Une balise et un script montrent un cerceau vivant dans un blog, une page de cours ou des d\
iapositives. Le mouvement est calculé dans le navigateur du lecteur ; rien n’est envoyé nulle part.","Choisissez un mouvement dans le labo et copiez son lie\
n ici.","Scénario : un lien du labo, ou ce qui suit son point d’interrogation","Ce qui accompagne le lecteur","réglages","diagrammes","théorie","carte","En\
 balise","La balise","Copier la balise","En cadre, là où les scripts ne sont pas permis","Le cadre","Copier le cadre","En code QR","Aperçu","Copié.","Un cer\
ceau sauteur","Enregistrer une image (SVG)","Une image dans l’espace n’a pas de lignes à garder : prenez le PNG, ou quittez la 3D.","L’image est trop grand\
e pour ce navigateur.","Flèches","Ce que ferait un peu plus (a)","Ce que ferait un peu plus","Un peu plus","L’appliquer","Chaque événement, pour ce pas","C\
e qui change à chaque événement","événement","lieu","hauteur","angle de la charge","Elle est infinie : il n’y en a pas plus.","Il faut un navigateur qui \
exécute WebAssembly.","La partie de la page qui calcule cela n’a pas pu être chargée ; choisis de nouveau quand il y aura un réseau.","Rien : aucun événem\
ent ne bouge.","Les flèches sont dessinées dans l’image plane : quitte la 3D pour les voir.","Les flèches de l’image vont de là où la jante touche à là où e\
lle toucherait, {factor} fois plus longues.","À partir de {what} à {time} s, pas de dérivée : {reason}.","D’un seul côté : {reason}.","{amount} plus à d\
roite","{amount} plus à gauche","{amount} plus tard","{amount} plus tôt","{amount} plus haut","{amount} plus bas","{amount} plus long","{amount} plus court","\
{amount} de plus en l’air","{amount} de moins en l’air","commence {amount} plus tard","commence {amount} plus tôt","{amount} plus vite","{amount} moins vit\
e","Le saut : {list}.","Saut {number} : {list}.","Le premier événement, {what} : {list}.","À la fin, après {time} s : {list}.","flèches : ce que ferait un p\
eu plus","une grandeur qui déclenche l’événement ne fait qu’y toucher zéro","le mouvement est à la frontière de deux classes : le moindre changement peu\
t mener à d’autres événements","la restitution est nulle et la jante est retombée : avec toute autre elle rebondirait","le mouvement commence en contact :\
 avec la jante levée ou lancée il rebondirait, et ses événements sont autres","le glissement atteint p_σ = 0, où la force de contact n’a pas de borne","\
le cerceau sans masse (γ = 1) est une limite singulière dès que la force de contact est perdue","sans frottement le cerceau ne repose que sur la frontière de\
 deux classes","le mouvement n’a pas de réponse à partir de là","le paramètre est au bord de ce qui est permis","les dérivées des deux côtés diffèrent",
"Avec un contact souple, pas de dérivées : choisis le modèle de contact rigide.","Le reste du lien est affiché. Corrigez l’adresse ou continuez à partir d’ic\
i.","Ignoré dans le lien : {names}.","{stars} {points} points, montrés et non comptés. {what}","{label} = {value} est trop grand.","Passer à la réponse","N\
on.","Pause","Partager","Tout","Vue simple","Tout afficher","Ce mouvement a aussi d’autres réglages.","Tirez la masselotte","À propos de hophoop","hophoop c\
alcule exactement comment un cerceau lesté au bord roule, glisse, saute et retombe.","Version","Licence","Licences de tout ce que contient la page","Documentat\
ion","La documentation","docs/index.md dans les sources ; cette page : docs/lab.md","Commandes"],Ki=Object.fromEntries(Object.keys(Re).map((s,e)=>[s,ec[e]]));var tc=["滚动","空转","拖滑","腾空","擦地","滑动 −","滑动 +","滚动","空转","拖滑","腾空","贴着平面滑过","在 {angle} 处开始滚动",
"在 {angle} 处开始空转","在 {angle} 处开始拖滑","在 {angle} 处腾空","在 {angle} 处开始贴着平面滑过","在 {angle} 处跳起","在 {angle}\
 处落地","在 {angle} 处弹起","在 {angle} 处反向滑动","在 {angle} 处滑动骤停","在 {angle} 处折返","在 {angle} 处弹跳结束","在 {angle}\
 处遇到潘勒韦悖论","在 {angle} 处遇到潘勒韦不定性","在 {angle} 处卡死","在 {angle} 处获得能量（凯恩）","在 {angle} 处开始擦地",
"在 {angle} 处静止","在 {angle} 处开始","在 {angle} 处开始滑动","{what}，并再重复 {count} 次","……（还有 {count} 项）","它已静止。",
"法向力无限增大（动力学卡死）：刚体力学给不出此后的运动。","模型不能确定此后的运动。","在结束之前已达到事件数(contact.max_events)或单\
次计算量的上限。","开始时{verb}，重物位于 {angle}，圆心速度 {speed} m/s。","开始时在空中，重物位于 {angle}，圆心速度 {speed} m/s。",
"开始时贴着平面滑过，重物位于 {angle}，圆心速度 {speed} m/s。","在 {angle} 处开始{verb}：摩擦力已达上限，圆环转得比前进得快。",
"在 {angle} 处开始{verb}：摩擦力已达上限，接触点向前滑。","在 {angle} 处恢复滚动，滑动停止。","在 {angle} 处滑动反向；它{verb}。",
"它在 {angle} 处跳起。","它在 {angle} 处跳起，升高 {height}，腾空 {time} s。","在 {angle} 处，一次无碰撞的冲击使滑动停止；随后它{verb}。",
"它在 {angle} 处以 {speed} m/s 的向下速度落地并弹起。","它在 {angle} 处以 {speed} m/s 的向下速度落地，随后{verb}。","它在 {angle} 处折\
返。","它在 {angle} 处折返，此后{verb}。","圆心在 {angle} 处最高：间隙为 {height}。","无穷多次弹跳在 {angle} 处结束。","{angle}\
 处的潘勒韦悖论：没有接触力与这种滑动相容。","{angle} 处的潘勒韦悖论：有多个接触力与之相容。","{angle} 处动力学卡死：接触力无限增大。",
"牛顿碰撞定律凭空产生了 {energy} J（凯恩的例子）。","在 {angle} 处接触力消失：重物自由下落，圆环贴着平面滑过。","它在 {\
angle} 处静止。","它在 {angle} 处静止，但不稳定。","它又弹跳了 {count} 次。","……还有 {count} 项。","打滑","跳起","立即跳起",
"纯滚动所需的摩擦因数","潘勒韦悖论","动力学卡死","稳定静止","滚动终止","速度超过 {speed} m/s 时打滑","会打滑：任何一推都足够",
"速度超过 {speed} m/s 时在第一圈内跳起","会在第一圈内跳起：任何一推都足够","速度超过 {speed} m/s 时立即跳起","会立即跳起：任何速度都行",
"任何速度下都不会","任何摩擦都不能使它保持滚动","μ = {mu} 可保持滚动（这里足够）","μ = {mu} 可保持滚动（这里不够）",
"从不","从 μ = {mu} 起，在 {angle} 处：这里可能出现","从 μ = {mu} 起，在 {angle} 处：这里不会出现","可能在 {angles} 处终止滑动",
"重物位于 {angle}","在 {angle} 处摩擦力达到上限","在 {angle} 处接触力消失","重物质量占比","理想圆环中重物占总质量的比例",
"偏心率","重心到圆心的距离与半径之比","无量纲转动惯量","绕重心的转动惯量与 m R² 之比","半径","圆环半径","质量","总质量",
"摩擦因数","摩擦因数（静、动相同）","静摩擦因数","动摩擦因数","倾角","平面倾角，下坡方向为 +x","重力加速度","恢复系数",
"碰撞的恢复系数","速度","滚动起始时圆心的速度","重物角度","从平面法线到重心的角度","间隙高度","圆环与平面的间隙","\
沿平面速度","圆心沿平面的速度","向上速度","圆心离开平面的速度","角速度","刚度","接触刚度","滑动速度","摩擦力建立所需的滑动速度",
"用于选取阻尼的恢复系数","时长","运动的时长","碰撞定律","恢复定律","斯特朗格（能量）","泊松（冲量）","牛顿（速度）",
"潘勒韦：两个解","不定接触之后发生什么","冲击","接触模型","刚性","柔性","法向力","摩擦定律","正则化摩擦","光滑 (tanh)",
"线性","鬃毛模型（可保持静止）","开尔文–沃伊特","亨特–克罗斯利","速度 v₀","重物角度 θ₀","沿平面速度 ẋ₀","角速度 θ̇\
₀","间隙高度 y₀","重物质量占比 γ","偏心率 ε","无量纲转动惯量 κ","半径 R","摩擦因数 μ","倾角 β","重力加速度 g","恢复系数 e",
"地球","月球","火星","木星","失重","第一圈内发生什么","第一次跳起的高度","离地角度","第一次跳起的时长","摩擦利用率的最大值",
"损失的能量","终止角度","是否遇到潘勒韦悖论或卡死","如何结束","时长","圈数","折返","离地","静止","卡死","未定","事件数上限",
"否","是","无","不允许","以及另外 {count} 类","论文","李特尔伍德的圆环","悖论","更多","跳起：3.1 m/s","打滑两次，然后在即将转满一圈时离开平面，腾空 0.76 s\
。","打滑：2.8 m/s","每圈摩擦力两次达到上限；每次打滑都比前一次弱，且没有最后一次。","滚动：2 m/s","纯滚动，比慢速起动更快更均匀，接近摩擦极限。",
"最轻的一推：0.1 m/s","重物在上时几乎静止，在下时很快；只用到 38 % 的摩擦。","低摩擦：0.1 m/s,μ = 0.3","打滑耗去了转满一圈所需的能量：圆环来回摆动。",
"全部质量在重物上","无质量的环：在 90° 处接触力消失；重物下落，圆环贴着平面滑过。","全部质量在重物上，推一下","\
推一下后接触力更早消失，在 cos θ = v₀²/(gR) 处。","几乎全部质量在重物上","γ = 0.99：真实的环会怎样，而不是李特尔伍德所说的跳起。",
"潘勒韦：无解","没有接触力与这种滑动相容。一次无碰撞的冲击使它骤停。","腾空与冲击都符合定律。请在“平面”下选择。",
"跳起之后的快速滑动：接触力在有限时间内无限增大，没有定律能说明之后如何。","凯恩：无中生有的能量","带摩擦的牛顿碰撞定律凭空产生两\
焦耳。斯特朗格定律则不会。","下坡","在 10° 的斜面上，圆环一圈比一圈快，直到跳起。","无穷多次弹跳","带旋转落下，恢复系数 0.5：有限时间\
内无穷多次弹跳。","在月球上","论文中的跳起，月球重力：一切慢到原来的 1/2.46。","示例","示例……","撤销 (z)","重做 (y)",
"比较","比较两个圆环","深色或浅色 (d)","按键与帮助 (?)","按键与帮助","实验室","学习","语言","圆环 A","圆环 B","控件作用于哪个圆环",
"参数","跳到播放器","圆环","平面","起始","接触","给定方式","质量占比 γ","ε 与 κ","实际部件","地点","其他","静、动摩擦因数分开",
"起始状态","滚动","任意状态","自动 {value}","{name}，精确值，单位 {unit}","{name}，精确值","圆环部件","圆盘","质点","杆","质量",
"内半径","外半径","半径","到圆心的距离","长度","添加部件","+ 添加部件……","移除部件 {number}，{what}","{name} = {value} 必须{rule}\
。","{name} = {value} 必须是数字，例如 2.5。","{name} = {value} 必须是数字。","在 {least} 到 {most} 之间","在 {least} 到 {most} 之间或为 inf",
"为 0 或在 {least} 到 {most} 之间","为 0、在 {least} 到 {most} 之间或为 inf","在本实验室中不超过 {most}","为 0（无质量圆环，hoop.inertia_ratio = \
0）","为 'rigid'（无质量圆环，hoop.inertia_ratio = 0）","服务器没有响应。已有内容可以继续播放；要更改需重新运行 `hophoop lab`。",
"服务器返回 {status}。","笔记本内核没有响应；请重新运行单元格。","圆环","状态","时间","角度","间隙","环缘速度","重物","\
重心","腾空时的重心","A 在前，B 在后","圆环","圆环。","时间","{time} 秒，{what}","轨迹 (t)","力 (f)","环缘速度 (c)","全程 (w)","三\
维 (3)","轨迹","力","环缘速度","全程","播放（空格）","暂停（空格）","播放速度","回到开头 (Home)","上一事件 (Shift ←)","下一事件 \
(Shift →)","后退一帧 (←)","前进一帧 (→)","落地","到下一次腾空 (h)","到下一次落地 (l)","此运动没有腾空。","此运动没有落地。",
"{what}:{angle},{time} s","开始","滑动开始","滑动结束","滑动反向","离地","折返","最高点","弹跳结束","潘勒韦：多个解","能量增加（凯恩）",
"开始擦地","静止","结束","发生了什么","圆环 {hoop} 发生了什么","运动的文字描述","（未显示全部事件）","理论怎么说","理论对圆\
环 {hoop} 的结论","速度","速度 [m/s]","v（圆心）","能量与损耗","能量 [J]","动能","势能","总能量","摩擦损耗","阻尼损耗","碰撞损耗，法\
向部分","接触力","力 [N]","法向力 N","摩擦力 F","摩擦利用率","自选","自选图的纵轴","图的横轴","横轴：{quantity}","整个运动",
"滑动以跳转，双指缩放","单击跳转，拖动放大；单击后或按住 Ctrl 时滚轮缩放；双击显示全部","{name}：{low} 至 {high}","图：{ti\
tle}，单位 {unit}。","θ mod 360°","Esc","{name} [{unit}]","一圈内的角度","圆心位置","圆环下的间隙","重心高度","圆心速度","转动线速度",
"离开平面的速度","滑动速度","角速度","法向力","摩擦力","摩擦利用率","动能","势能","总能量","θ–θ̇ 相平面","角度与角速度相平面，标出滚动\
、滑动与腾空区域","一圈内的角度 θ [°]","颜色：无滑动接触之后的状态。","阴影线：会遇到潘勒韦悖论的滑动。","点按跳转；双指缩\
放。","单击跳转；单击后或按住 Ctrl 时滚轮缩放；双击显示全部。","分布图","内容","横轴","纵轴","分布图显示的内容","运动分布\
图","运动分布图。方向键移动标记，回车采用该运动，加减号缩放。","放大分布图","缩小分布图","整张图","点按即可把该运动放入播放器；双指缩放。",
"单击即可把该运动放入播放器；单击后或按住 Ctrl 时滚轮缩放；拖动平移；双击显示全部。","正在计算 {count} 个运动……",
"{count} 个运动","{count} 个运动，刚性接触","均为滚动起始，而当前运动并非如此","均为任意状态起始，而当前运动为滚动起始",
"分享与保存","复制此运动的链接","保存场景（TOML）","保存状态（CSV）","保存运动（netCDF）","保存事件（JSON）","保存影片（MP4）",
"保存图片（PNG）","将一次运动录成影片（WebM）","显示 Python 代码","同一运动的 Python 代码","链接已复制。","此运动的链接",
"正在制作影片，请稍候……","正在获取 {name}……","{name} 已就绪。","此浏览器无法录制画布；请改用 MP4。","正在录制一遍……",
"影片已就绪。","场景文件","复制","已复制","关闭","一个边缘带重物的环在平面上滚动。摩擦力有上限，平面只能推不能拉：于是它打滑、跳起、落地——或者做出刚体力学无法判定的事。拖动滑块看看。",
"状态","时间条上的标记","按键","空格","播放、暂停","一帧","Shift ← →","上一、下一事件","下一次腾空、落地","更慢、更快",
"Home End","开头、结尾","轨迹、力、环缘速度、全程","三维","缩放、还原","离开输入框、菜单或滚轮缩放的图","z y  Ctrl Z","撤销\
、重做","深色、浅色","Python","环缘不滑动","滑动：环缘转得比前进快（圆环向前滚时为滑动 −）","滑动：接触点向前滑（圆环向前滚时为滑动 +）",
"跳起：从离地到落地","无质量的环缘，接触而无力","离地、落地","潘勒韦悖论：无解、多解","无穷多次弹跳结束","开始擦地、静止",
"单个按键（字母、数字、符号）按表中所述起作用","手中的圆环","平面倾角","倾斜平面：拖动或方向键","圆环：高度与速度",
"提起、滚动或抛出圆环：拖动或方向键","重物角度","转动重物：拖动或方向键","间隙 {height}，速度 {speed} m/s","循环","慢放：十分之\
一速度","接触声音","全屏演示","引导参观","运动数据表","运动数据表，各行","演示","教师专区","数据表","每隔","保存为 CSV",
"列","前 {count} 行。","挑战","退出挑战","选择挑战","得分","重新开始","看一个最佳解","{stars} {points} 分。{what}","你的最佳成绩：{points} \
分。","跳得最高","在水平面上以不超过 3.1 m/s 滚动起始：你来选择重物、起始位置与摩擦。6 s 内圆环能升多高？","正立落地",
"让圆环落地时重物恰好在最高处。一切都允许；第一次跳起至少 5 cm 高。","不拖滑地跳起","在水平面上圆环以不超过 10 m/s 滚动起始，重物在最低处，μ 不超过 1.\
5。跳起之前不得拖滑，但可以空转。它能跳多高？","只限刚性接触。","平面必须水平。","必须在地球上。","恢复系数必须为 0。",
"半径必须保持 1 m，且不用部件。","重物最多占总质量的 90 %。","圆环必须用重物质量占比给定。","必须以滚动起始。","不超过\
 10 m/s。","不超过 3.1 m/s。","不超过 6 s。","它没有跳起。","它升高 {height}。","第一次跳起太低。","落地时偏离最高处 {off}。",
"重物必须从最低处起始。","摩擦因数不得超过 1.5。","它在跳起之前拖滑了。","第一次来？","八个小问题：先猜，再播放。",
"开始参观","以后再说","放手之前的圆环。","播放","下一步","上一步","完成","第 {number} 步，共 {all} 步","退出参观","先说出你的预测，再播\
放。","你的预测","{points} 分（满分 100）。","你得到 {sum} 分，满分 {most}。","重物位于 {angle} 时的{what}","画出曲线：上下拖动各点",
"李特尔伍德的问题","一个没有质量的圆环，边缘固定着一个重物。重物在最高处时轻轻一推，它便滚动起来。1953 年李特尔伍德问：当重物与圆心同高时会发生什么？",
"你认为呢？","它继续滚动。","它跳起：圆环离开平面。","重物自由下落，圆环在它下方贴着平面滑过。","在 {angle} 处已没有接触力。",
"李特尔伍德说圆环会跳起。但接触力是零，而不是向上：重物自由下落，没有质量的环沿平面跟随它。要跳起，环本身必须有一些质量。",
"有质量的环","现在环占总质量的四分之一。重物同样在最高处，轻轻一推。","画出第一圈内圆心的速度。","圆心速度","重物在\
最低处时圆心速度为 {speed} m/s。","滚动圆环的最低点是静止的。重物到那里没有动能，轻环得到了沉重的重物失去的全部能量：它比从同一高度落下的石头还快。",
"为什么打滑","推得更重：最高处 2.8 m/s。滚动需要摩擦，而摩擦力有上限：最大为 μ N。","摩擦第一次不够时，重物在哪里？转动标记。",
"开始打滑时重物的角度","它在 {angle} 处开始打滑。此时平面只承担重力的 {share}。","重物在下落转动途中对平面压力很小，N 很小，而环却要加速：这需要摩擦。看“摩擦利用率”图：它达到 \
1。","跳起","稍快一些，3.1 m/s。这一次圆环在第一圈结束之前离开平面。","圆环离地时，重物在哪里？转动标记。","离地时重物的角度",
"它在 {angle} 处离地，此时环缘以 {slip} m/s 打滑。","若圆环纯滚动，重物上升时平面会使转动减慢。但摩擦力不够：环缘空转，圆环继续快速转动，重物在到达最高处之前就把它拉离平面。",
"落地","圆环在空中。它的重心走抛物线，转动是匀速的。","落地之后它马上会怎样？","立即滚动。","拖滑：接触点向前滑。",
"空转：环转得太快。","弹起。","它在空中 {time} s，升高 {height} cm；落地时重物位于 {angle}。","碰撞不占时间，但其中的摩擦与冲力一样强：这里足以使滑动全部停止。若摩擦更小\
或恢复系数更大，落地情形就会不同。之后可以试试。","摩擦越大，跳得越高？","三个圆环以相同的 3.1 m/s 起始，平面摩擦因数分别为 0.05、0.2 和 1.0。",
"哪一个跳得最高？","它们分别升高 {low} cm、{middle} cm 和 {high} cm。（前两个是 A 和 B。）","在冰上没有什么驱动转动；摩擦无穷大时则不会打滑。跳起需要两者兼顾：下落途中摩擦足以使\
圆环转快，上升途中又不至于把它刹住。","刚体无法判定的事","把圆环抛出，使它在粗糙平面上快速滑动。带干摩擦的刚体定律必须说明接下来会怎样。",
"它们怎么说？","它飞起来。","一次冲击使滑动骤停。","两者都符合定律。","圆环 A 与圆环 B 起始相同，两种运动都遵守全部定律。",
"潘勒韦在 1895 年发现了这一点。对刚体而言，这里的定律有两个答案，在另一些状态下则没有答案。真实物体会略微变形，由此得出结果：请在“接触”下选择柔性接触。",
"轮到你了","拿起圆环：转动重物、提起再放下、轻弹一下、倾斜平面。或者接受挑战，看看得分如何由运动本身算出。","\
全速播放一次，不作说明。“我推它一下。它只是滚动吗？”","每人预测离地时重物的位置。按四分之一圈统计票数。","两\
人一组讨论下落途中的能量：重物静止时能量在哪里？","最高处的抬升：速度多大时地面的力为零？","再次慢放并显示力；在离地时停下，与投票对比。",
"每组取学习单中的一个速度；结果写在黑板上。","为什么？上升途中是什么使转动减慢？它能有多强？太弱时又会怎样？",
"每人一句话：“圆环跳起是因为……”","重物在最高处把圆环往上拉，所以在那里跳起。","只有很快时才如此。较慢的圆环在打滑之后、到达最高处之前跳起。",
"它在最低处跳起，因为那里最快。","在那里地面推力最大：必须使重物转而向上。","没有什么比下落的石头更快。","环可以：它得\
到了已静止的重物的能量。","摩擦总是阻碍运动。","它阻碍的是相对滑动。重物上升途中它指向前方。","摩擦越大跳得越高。",
"中间存在一个最佳摩擦因数。","更重的圆环表现不同。","只有质量的比例起作用。","看影片之前：圆环离地时重物在哪里？标出位置并写出一个理由。",
"轻轻一推圆环便滚动。重物到最低处时释放了多少势能？","轮子滚动时最低点静止。此时圆环的哪一部分有动能？圆心速度多大？",
"从重物的高度落下的石头速度多大？圆环为什么可以更快？","求 1.0 m/s 时最高处地面的力，以及它变为零时的速度。","在实验\
室中：圆环在最初 1.5 s 内做什么？在哪个角度跳起？填表。","求圆环能跳起的最小速度，精确到 1 cm/s。","2.2 m/s 时圆环在打滑中离地。打滑\
为什么有助于跳起？","演示","用圆环教学","学习单","答案","习题","一节 45 分钟的课","分钟","运动","学生常有的想法","想法",
"正确的是","学习单：会跳的圆环","一个半径 0.40 m 的薄环质量为 0.25 kg，边缘固定着 0.75 kg 的重物。圆环立在水平地面上，重物在最高处，向右推动。摩擦因数 μ = 1;g = 9.81 m/s²。",
"阶段","是否跳起？","在哪个角度？","打印","参观先提问后演示；演示占满屏幕；数据表为每个学生提供数字。","inf","大于 {le\
ast}","不小于 {least}","不小于 {least}（允许 inf）","不大于 {most}","是有限的数","是整数","为“{word}”或“{word2}”","为“{word}”、“{wo\
rd2}”或“{word3}”","滚动阻力","滚动阻力：阻碍转动的力偶与 R N 之比","打滑、跳起","上坡(β < 0)没有阈值：是否打滑或跳起取决于在何处折返；分布图会显示",
"为 'rigid'（用于分布图）","x.cells 乘 y.cells = {cells} 在本实验室中不得超过 {most}。","{one} 与 {other} 不能同时作为坐标轴：它们以两种方式表示同一个量。",
"x.path 与 y.path 都是 {path}，必须不同。","滚动阻力损耗","滚动阻力 f","{name} = {value} 必须在 -pi/2 与 pi/2 之间（弧度）。","{wo\
rd} 不是已知的键；已知的有 {word2}。","{one} 不能与 {other} 同时给定。","{one} = {value} 不得超过 {other} = {limit}。","contact.model =\
 'compliant' 时 plane.mu_static = inf 必须为有限值。","hoop.parts 不能为空。","耗时超过 {time} s；请缩短运动或减少格数。","实验室繁忙；请在\
 {time} 秒后重试。","实验室繁忙；请在 1 秒后重试。","计算失败。","执行此计算的进程已结束。","duration = {value} 在本实验室中不得超过 {m\
ost} s；库本身没有此限制。","在此速度与半径下 duration = {value} s 约为 {turns} 圈，本实验室中不得超过 {most}；库本身没有此限制。",
"hoop.parts 有 {count} 个部件，本实验室中不得超过 {most}。","contact.stiffness、contact.slip_speed 与 duration 约需 {steps} 步积分，本实验室中不得超过 {most}。",
"此分布图的一格约为 {turns} 圈，本实验室中不得超过 {most}。","x 与 y 共 {count} 格，约 {turns} 圈，本实验室中不得超过 {most}；请减少格数、降低速度或缩短时长。",
"从本实验室制作影片时 duration = {value} 不得超过 {most} s。","A 为蓝色，B 为赭色；线型表示物理量；数值属于 {hoop}；{hands}",
"{time} s 之后会发生什么，取决于比本页数值更多的位数；hophoop lab 与 Python 会取所需的位数。","指纹","没有指纹：这一运动取决于比本页所算更多的位数。",
"所有事件的哈希值：凡 hophoop 算出相同比特之处（包括 Python）都相同","✓ 与 Python 中的比特相同","✓ 与创建链接处的比特相同",
"比特不同：此处为 {own}，Python 中为 {other}。","比特不同：此处为 {own}，创建链接处为 {other}，版本可能不同。","hophoop 实验室：玩\
转会跳的圆环","把会跳的圆环放进您的网页","一个标签和一个脚本，就能在博客、课程页面或幻灯片中显示可操作的圆环。运动在读者的浏览器中计算；不向任何地方发送数据。",
"在实验室中选择一个运动，并把它的链接复制到这里。","场景：实验室的链接，或其问号之后的部分","播放器旁显示的内容",
"滑块","图表","理论","分布图","作为标签","标签","复制标签","作为框架，用于不允许脚本的地方","框架","复制框架","作为二维码",
"显示效果","已复制。","会跳的圆环","保存图片（SVG）","空间画面没有可保存的线条：请用 PNG，或退出 3D。","图片对此浏览器来说太大了。",
"箭头","再多一点会怎样（a）","再多一点会怎样","再多一点","照做","按这一步，每个事件","每个事件的变化","事件","位置",
"高度","负载角度","它是无穷大：不能再多了。","这需要能运行 WebAssembly 的浏览器。","页面中计算此项的部分无法加载；有网络时请再选一次。",
"没有变化：没有事件移动。","箭头画在平面图中：离开三维即可看到。","图中的箭头从环缘现在接触之处指向它将接触之处，长度放大到 {factor} 倍。",
"自 {time} s 的{what}起没有导数：{reason}。","仅对一侧成立：{reason}。","向右多 {amount}","向左多 {amount}","晚 {amount}","早 {amount}",
"高 {amount}","低 {amount}","远 {amount}","近 {amount}","腾空多 {amount}","腾空少 {amount}","开始晚 {amount}","开始早 {amount}","快 {amount}","\
慢 {amount}","跳跃：{list}。","第 {number} 次跳跃：{list}。","第一个事件（{what}）：{list}。","结束时（{time} s）：{list}。","箭头：再多一点\
会怎样","触发该事件的量在那里只是触及零","该运动位于两类的边界上：极小的变化就可能导致不同的事件","恢复系数为 0 且环缘已落地：只\
要不为零它就会弹起","运动从接触开始：若环缘被抬起或抛起，它会弹跳，事件就不同了","滑动到达 p_σ = 0，那里接触力无界",
"接触力消失后，无质量圆环（γ = 1）是奇异极限","没有摩擦时圆环只静止在两类的边界上","从那里起该运动没有答案","该参数\
处于允许范围的边缘","两侧的导数不同","柔性接触不计算导数：请选择刚性接触模型。","显示的是链接的其余部分。可以更正地址，也可以从这里继续。",
"链接中已忽略：{names}。","{stars} {points} 分，是演示，不计分。{what}","{label} = {value} 太大。","跳到答案","不是这样。","暂停",
"分享","全部","简洁视图","显示全部","此运动还有其他设置。","拖动重物","关于 hophoop","hophoop 精确计算边缘带重物的圆环如何滚动、滑动、跳起和落地。",
"版本","许可证","本页所含内容的许可证","文档","查看文档","源代码中的 docs/index.md；本页：docs/lab.md","命令"],Vi=Object.fromEntries(
Object.keys(Re).map((s,e)=>[s,tc[e]]));var xt={de:Re,es:Ui,fr:Ki,zh:Vi};var to=new Map;function se(s){try{return localStorage.getItem(s)??to.get(s)??null}catch{return to.get(s)??null}}function oe(s,e){to.set(s,e);try{localStorage.setItem(
s,e)}catch{}}function Ji(s){try{return sessionStorage.getItem(s)}catch{return null}}function Yi(s,e){try{sessionStorage.setItem(s,e)}catch{}}var nc=s=>{let e=new Intl.DisplayNames([s],{type:"language"}).of(s)??s;return e[0].toLocaleUpperCase(s)+e.slice(1)},Mt=Object.fromEntries(["en",...Object.keys(xt)].
map(s=>[s,nc(s)])),Xi="hophoop-language",ea=4e3,sc=/^((\d\S* )?(rad(\/s)?|kg|m\/s²?)|'?[\w.[\]]+\.\w+'?|'\w*'|([\w.]+, )+[\w.]+|hophoop.*)$/u,tn=/\{(\w+)\}/g,Se="\
en",ta=!1,na=[],_t=new Map,Et=new Set,Qe=new Set,Pe=()=>Se;function so(s){Se=s in Mt?s:"en",ta=1.5.toLocaleString(Se).includes(","),_t=new Map,Et=new Set,Qe.clear(),
na=Object.keys(xt[Se]??{}).filter(e=>e.includes("{")).map(ic).sort((e,t)=>Zi(t.key)-Zi(e.key))}function oc(){let s=se(Xi);return s&&s in Mt?s:(globalThis.navigator?.
languages??[]).map(n=>n.slice(0,2).toLowerCase()).find(n=>n in Mt)??"en"}function sa(s){oe(Xi,s)}var Zi=s=>s.replace(tn,"").length;function ic(s){let e=[...s.matchAll(
tn)].map(([,n])=>n),t=s.split(/\{\w+\}/).map(n=>n.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));return{key:s,names:e,pattern:new RegExp(`^${t.join("(.+?)")}$`,"su")}}var be=s=>ta?
s.replace(/(\d)\.(\d)/g,"$1,$2"):s;function k(s,e){let t=xt[Se];if(e)return j(oa(t?.[s]??Qi(s),e));if(!t||!/\p{L}/u.test(s))return be(s);if(Et.has(s))return s;let n=_t.
get(s);if(n!==void 0)return n;let o=s.trim(),i=t[o]??ac(o,t)??Qi(o),a=s.replace(o,()=>i);return _t.size>ea&&_t.clear(),_t.set(s,a),j(a)}function j(s){return Et.
size>ea&&Et.clear(),Et.add(s),s}var nn=(s,e)=>s.replace(tn,(t,n)=>String(e[n])),oa=(s,e)=>s.replace(tn,(t,n)=>n.startsWith("word")?String(e[n]):k(String(e[n])));
function ac(s,e){for(let{key:t,pattern:n,names:o}of na){let i=s.match(n);if(i)return oa(e[t],Object.fromEntries(o.map((a,r)=>[a,i[r+1]])))}return rc(s)}function rc(s){
if(s.includes(" → "))return s.split(" → ").map(e=>k(e)).join(" → ")}function ia(s){if(!xt[Se])return s;let[,e,t]=s.match(/^(.*?)\.(?: (.*))?$/su)??["",s,""],
{comma:n,stop:o}=Se==="zh"?{comma:"，",stop:"。"}:{comma:", ",stop:"."},a=`${e[0]?.toLowerCase()??""}${e.slice(1)}`.split(/, (?!\d)/).map(r=>k(r)).join(n);return j(
`${a[0]?.toLocaleUpperCase(Se)??""}${a.slice(1)}${o}${t?` ${k(t)}`:""}`)}function Qi(s){let e=/\p{L}{3,}/u.test(s)&&!sc.test(s);return Se!=="en"&&e&&Qe.size<200&&
Qe.add(s),be(s)}var oo=new WeakMap,no=new WeakMap;function St(s){let e=document.createTextNode(k(s));return oo.set(e,s),e}function Xe(s,e,t){let n=no.get(s)??{};
n[e]=t,no.set(s,n),s.setAttribute(e,k(t))}function lc(s){let e=document.createTreeWalker(s,NodeFilter.SHOW_TEXT);for(let t=e.nextNode();t;t=e.nextNode()){let n=(t.
nodeValue??"").replace(/\s+/g," ");n.trim()&&oo.set(t,n)}for(let t of s.querySelectorAll("[aria-label]"))Xe(t,"aria-label",t.getAttribute("aria-label")??"");sn(
s)}function sn(s){let e=document.createTreeWalker(s,NodeFilter.SHOW_ELEMENT|NodeFilter.SHOW_TEXT);for(let t=e.nextNode();t;t=e.nextNode()){let n=oo.get(t);n!==void 0&&
(t.nodeValue=k(n));let o=no.get(t);for(let[i,a]of Object.entries(o??{}))t.setAttribute(i,k(a))}}so(oc());var hc=14,cc=new Set(["aria-label","title","placeholder","label"]);function u(s,e={},...t){let n=document.createElement(s),o=n;for(let[i,a]of Object.entries(e))
a==null||a===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),a):i==="class"?n.className=a:i in n&&i!=="list"&&typeof a!="string"?o[i]=a:cc.has(i)?Xe(n,i,String(
a)):n.setAttribute(i,a===!0?"":a));for(let i of t.flat())i==null||i===!1||n.append(i.nodeType?i:St(String(i)));return n}function R(s,e){e?s.replaceChildren(St(e)):
s.replaceChildren()}var Tt=s=>s!==null&&s.getRootNode().activeElement===s,we=s=>s.getContext("2d");function K(s,e=1){let t=s.getBoundingClientRect(),n=Math.min(
globalThis.devicePixelRatio||1,2.5),o=Math.max(Math.round(t.width*n),1),i=Math.max(Math.round(t.height*n),1);(s.width!==o||s.height!==i)&&(s.width=o,s.height=i);
let a=we(s),r=n*e;return a.setTransform(r,0,0,r,0,0),{context:a,width:o/r,height:i/r}}function uc(s){if(/^#[0-9a-f]{6}$/i.test(s))return s;let e=we(u("canvas",{
width:1,height:1}));e.fillStyle=s,e.fillRect(0,0,1,1);let[t,n,o]=e.getImageData(0,0,1,1).data;return`#${[t,n,o].map(i=>i.toString(16).padStart(2,"0")).join("")}`}
function io(s){let e=getComputedStyle(s),t=o=>e.getPropertyValue(o).trim(),n=o=>uc(t(o));return{ink:n("--ink"),soft:n("--soft"),line:n("--line"),paper:n("--pape\
r"),panel:n("--panel"),ground:n("--ground"),font:t("--font"),px:Number.parseFloat(e.fontSize)/hc||1,dark:yt(n("--paper"))<.2}}function et(s,e){let t=u("a",{href:URL.
createObjectURL(s),download:e});document.body.append(t),t.click(),t.remove(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function ie(s,e){let t=0;return()=>{
clearTimeout(t),t=setTimeout(s,e)}}var _=(s,e,t)=>Math.min(Math.max(s,e),t);function M(s,e=4){if(s==null)return"–";if(typeof s!="number")return String(s);if(!Number.isFinite(s))return Number.isNaN(
s)?"–":s>0?"∞":"−∞";if(s===0)return"0";let t=Math.abs(s),n;if(t>=1e6||t<1e-4){let[o,i]=s.toExponential(e-1).split("e");n=`${aa(o)}·10${dc(Number(i))}`}else
n=aa(s.toPrecision(e)),n.includes("e")&&(n=String(Math.round(s)));return be(n.replace("-","−"))}function aa(s){return s.includes(".")&&!s.includes("e")?s.replace(
/\.?0+$/,""):s}function dc(s){let e={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(s)].map(t=>e[t]).join(
"")}var I=(s,e)=>e?e==="°"?`${s}°`:`${s} ${e}`:s,G=s=>be(`${(s*180/Math.PI).toFixed(1)}°`.replace("-","−"));function Ce(s){let e=Math.abs(s),[t,n]=e>=.995?
[1,"m"]:e>=.00995?[100,"cm"]:[1e3,"mm"];return I(M(s*t,3),n)}function V(s,e){let t=s/Math.max(e,1),n=10**Math.floor(Math.log10(t)),o=t/n;return(o>5?10:o>2?5:o>1?
2:1)*n}function he(s,e,t){if(!(e>s)||!Number.isFinite(s)||!Number.isFinite(e))return[];let n=V(e-s,t),o=[];for(let i=Math.ceil(s/n-1e-9);i*n<=e+1e-9*n&&o.length<
200;i++)o.push(i*n);return o}function ae(s,e){let t=_(-Math.floor(Math.log10(e)+1e-9),0,15);return Math.max(Math.abs(s),e)>=1e6||t>12?M(s,3):be((Math.abs(s)<e*1e-6?
0:s).toFixed(t).replace("-","−"))}var la=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],mc="tfc",pc=/^[0-9a-f]{16}$/,fc=400;function ha({time:s=0,options:e={},zoom:t=1,
pan:n=[0,0],from:o,more:i,map:a,fingerprints:r=[]}){let l=[];s>0&&l.push(`t=${Number(s.toFixed(4))}`);let c=la.filter(([m])=>e[m]).map(([,m])=>m);return c.join(
"")!==mc&&l.push(`show=${c.join("")}`),t!==1&&l.push(`zoom=${Number(t.toPrecision(3))}`),n.some(m=>Math.abs(m)>5e-4)&&l.push(`pan=${n.map(m=>Number(m.toFixed(3))).
join(",")}`),o&&l.push(`from=${o.map(m=>Number(m.toPrecision(3))).join(",")}`),i&&l.push(`more=${i}`),a&&l.push(`map=${[a.what,...a.x,...a.y].join(",")}`),r.some(
Boolean)&&l.push(`fingerprint=${r.join(",")}`),l.join("&")}function ca(s){let e=new URLSearchParams(s.replace(/^#/,"")),t={},n=Number(e.get("t")??Number.NaN);n>=
0&&(t.time=n);let o=e.get("show");o!==null&&(t.options=Object.fromEntries(la.map(([y,v])=>[y,o.includes(v)])));let i=Number(e.get("zoom")??Number.NaN);i>0&&(t.zoom=
_(i,.05,60));let a=ra(e.get("pan"),2);a&&(t.pan=a.map(y=>_(y,-20,20)));let r=ra(e.get("from"),3);r&&(t.from=r);let l=e.get("more");l&&(t.more=l);let[c,m,h,d,p,f,
g]=e.get("map")?.split(",")??[],b=[h,d,f,g].map(Number);g!==void 0&&b.every(Number.isFinite)&&b[0]<b[1]&&b[2]<b[3]&&(t.map={what:c,x:[m,b[0],b[1]],y:[p,b[2],b[3]]});
let w=e.get("fingerprint")?.toLowerCase().split(",");return w&&(t.fingerprints=w.map(y=>pc.test(y)?y:"")),t}function ra(s,e){let t=(s??"").split(",").map(Number);
return s&&t.length===e&&t.every(Number.isFinite)?t:null}var ao=()=>{let s=new URLSearchParams(location.hash.slice(1)).get("with");return[location.search.slice(1),
...s===null?[]:[s]]},on=class{constructor(e,t,n){this.motions=e;this.notice=t;this.link=n;this.number=history.state?.number??0;this.held=!1;this.soon=ie(()=>this.
write("same"),fc),this.listen=()=>this.arrived(),addEventListener("popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(e){let{motions:t}=this;
if(!t.lanes.length||!t.history.holds(t.queries())||this.held&&(e==="same"||e==="travelled"))return;let n=this.link();e==="step"||this.held?history.pushState({number:++this.
number},"",n):history.replaceState({number:this.number},"",n),this.held=!1}read(e){let{notice:t}=this,{backend:n}=this.motions,o=e.map(l=>n.readable?.(l)??{query:l,
foreign:[],error:null}),i=o.find(l=>l.error)?.error,a=o.flatMap(l=>l.foreign);this.held=!!i;let r=()=>{i?t.fail(i,"The rest of the link is shown. Correct the ad\
dress, or go on from here."):a.length&&t.say(nn("Ignored in the link: {names}.",{names:a.join(", ")}))};return{links:o.map(l=>l.query),said:r}}travel(e){return new Promise(
t=>{let n=()=>t();addEventListener("popstate",n,{once:!0}),setTimeout(n,300),history.go(e)})}async arrived(){let e=history.state?.number??0,{links:t,said:n}=this.
read(ao());JSON.stringify(t)===JSON.stringify(this.motions.queries())?this.number=e:await this.motions.arrive(t)?(this.number=e,n()):e!==this.number&&history.go(
this.number-e)}};var At=[.05,.1,.25,.5,1,2,4],an=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,rn=class{constructor(){this.time=0;this.duration=1;this.speed=1;this.
playing=!1;this.loop=!an();this.once=!1;this.pointed=null;this.last=null;this.listeners=new Set}changed(){for(let e of this.listeners)e(this)}run({to:e=this.time,
once:t=!1}={}){an()?this.seek(e):(this.play(!0),this.once=t)}seek(e){this.time=_(e,0,this.duration),this.changed()}point(e){this.pointed=e,this.changed()}play(e=!this.
playing){this.playing=e,this.once=!1,this.last=null,e&&this.time>=this.duration&&(this.time=0),this.changed()}faster(e){let t=At.indexOf(this.speed);this.speed=
At[_(t+e,0,At.length-1)],this.changed()}tick(e){if(!this.playing)return!1;let t=this.last===null?0:Math.min(e-this.last,100)/1e3;return this.last=e,this.time+=t*
this.speed,this.time>=this.duration&&(this.loop&&!this.once&&this.duration>0?this.time%=this.duration:(this.time=this.once?0:this.duration,this.playing=!1,this.
changed())),!0}};function gc(s,e=""){let t=s.trim();e&&t.endsWith(e)&&(t=t.slice(0,-e.length)),t=t.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(o,i,a)=>`e${i&&"-"}${a.normalize("NFKD")}`);let n=/^([+-]?)(inf|infinity|∞)$/i.exec(t);return n?n[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(t)?Number(t.replace(",",".")):Number.NaN}function bc(s,e,{label:t,unit:n,range:o}){let i=s.trim();if(Number.isNaN(e))return`${t} = ${i} must be a number, s\
uch as 2.5.`;if(!Number.isFinite(e)&&/\d/.test(i))return`${t} = ${i} is too large.`;if(!o||e>=o.least&&e<=o.most||o.also.includes(e))return"";let a=o.also.includes(
0)?"0 or ":"",r=`from ${M(o.least,4)} to ${I(M(o.most,4),n)}`,l=o.also.includes(1/0)?", or inf":"";return`${t} = ${I(M(e,6),n)} must be ${a}${r}${l}.`}var wc=0,
tt=class{constructor(e,t){this.info=e;this.onvalue=t;this.shown="";this.typing=!1;this.error=u("p",{class:"error",role:"alert",id:`hh-error-${++wc}`,hidden:!0});
this.input=u("input",{type:"text",inputmode:"decimal",autocomplete:"off",spellcheck:"false",class:"exact","aria-label":e.name,oninput:()=>{this.typing=!0,this.accept()},
onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:n=>{n.key!=="Escape"||!(this.typing||this.refused())||(n.stopPropagation(),this.restore())}})}refused(){
return this.input.getAttribute("aria-invalid")==="true"}typed(){let e=this.input.value;if(!this.typing)return;if(this.typing=!1,e.trim()===""){this.restore();return}
let t=gc(e,this.info.unit),n=bc(e,t,this.info);n?this.refuse(n):this.onvalue(t)}refuse(e){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute(
"aria-describedby",this.error.id),R(this.error,e),this.error.hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-desc\
ribedby"),this.error.hidden=!0}restore(){this.typing=!1,this.input.value=this.shown,this.accept()}show(e){this.shown=be(e),this.typing||this.restore()}};var ua={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},yc={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},vc=(s,e,t)=>({ring:{shape:s,mass:t,inner_radius:.95*e,outer_radius:e},disk:{shape:s,mass:t,radius:.1*
e,at:.8*e},point_mass:{shape:s,mass:t,at:e},rod:{shape:s,mass:t,length:.5*e,at:.5*e}})[s];function da(s){let e=s["hoop.radius"],t=s["hoop.mass"],n=Math.min(Math.
max(s["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:ln(t*(1-n)),inner_radius:ln(.98*e),outer_radius:e},{shape:"point_mass",mass:ln(t*n),at:e}]}var ln=s=>Number(
s.toPrecision(6)),hn=class{constructor(e){this.onchange=e;this.list=u("div",{class:"parts"});this.element=u("div",{},this.list,u("select",{"aria-label":"Add a p\
art",onchange:t=>{let n=t.target.value;t.target.value="",n&&this.send([...this.parts,vc(n,this.radius,ln(.2*this.mass))])}},u("option",{value:""},"+ add a part \
…"),Object.entries(ua).map(([t,{label:n}])=>u("option",{value:t},n))))}send(e){this.onchange([["hoop.parts",e]])}show(e,t,n){let o=JSON.stringify(e);if(o===this.
text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=e;return}Object.assign(this,{text:o,parts:e,radius:t,mass:n}),this.list.replaceChildren(
...e.map((i,a)=>this.row(i,a)))}row(e,t){let{label:n,keys:o}=ua[e.shape];return u("fieldset",{class:"part"},u("legend",{},n,this.parts.length>1&&u("button",{type:"\
button",class:"quiet","aria-label":`Remove part ${t+1}, ${n}`,onclick:()=>this.send(this.parts.filter((i,a)=>a!==t))},"×")),o.map(i=>this.field(e,t,i)))}field(e,t,n){
let[o,i]=yc[n],a=new tt({label:o,unit:i},r=>this.send(this.parts.map((l,c)=>c===t?{...l,[n]:r}:l)));return a.show(String(e[n]??0)),u("div",{},u("label",{},`${o}\
 [${i}]`,a.input),a.error)}};var ro=Math.PI/180;function kc({allowed:s,degrees:e}){if(!s)return;let t=e?1/ro:1;return{least:s.least*t,most:s.most*t,also:s.also.map(n=>n==="inf"?1/0:Number(n))}}
var lo=class{constructor(e,t){this.info=e;this.onchange=t;this.held=!1;let n=`hh-${e.path}-${Math.random().toString(36).slice(2,7)}`,o=l=>()=>{this.held=l};this.
range=u("input",{type:"range",id:n,class:"slider",min:String(this.low()),max:String(this.high()),step:e.logarithmic?"0.01":String(e.step),"data-path":e.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:o(!0),onpointerup:o(!1),onpointercancel:o(!1),onblur:o(!1)});let{label:i,unit:a}=e,r=`${i}, exact value${a?` i\
n ${a}`:""}`;this.entry=new tt({label:i,unit:a,name:r,range:kc(e)},l=>this.send(l,!0)),this.element=u("div",{class:"control",title:e.help},u("label",{for:n},u("\
span",{},i),u("span",{class:"symbol"},e.symbol)),this.range,u("span",{class:"entry"},this.entry.input,u("span",{class:"unit"},a)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(e){let t=Number(
this.range.value),n=this.info.logarithmic?Number((10**t).toPrecision(3)):t;this.entry.typing=!1,this.entry.show(String(n)),this.say(n),this.send(n,e)}send(e,t){
let n=this.info.degrees?e*ro:e;this.onchange([[this.info.path,Number.isFinite(n)?n:"inf"]],t)}say(e){this.range.setAttribute("aria-valuetext",I(M(e,4),this.info.
unit))}show(e,t=null){if(this.held)return;let n=e!=null,o=n?e:t;if(o==null){this.entry.show("");return}let i=o==="inf"?1/0:Number(o)/(this.info.degrees?ro:1);this.
entry.show(n?Number.isFinite(i)?String(Number(i.toPrecision(9))):"∞":""),this.entry.input.placeholder=n?"":k("auto {value}",{value:M(i,2)}),this.entry.input.title=
n?I(String(i),this.info.unit):"";let a=_(this.info.logarithmic?Math.log10(i):i,this.low(),this.high());Math.abs(Number(this.range.value)-a)>1e-6&&(this.range.value=
String(a)),this.say(i)}};function xc(s,e){let t=u("select",{"data-path":s.path,onchange:()=>e([[s.path,t.value]],!0)},s.options.map(([o,i])=>u("option",{value:o},
i)));return{element:u("label",{class:"choice",title:s.help},u("span",{},s.label),t),select:t,path:s.path}}var cn=class{constructor(e,t){this.sliders=new Map;this.
onchange=(n,o=!0)=>t(n,o);for(let n of Object.values(e.groups))for(let o of n)this.sliders.set(o.path,new lo(o,this.onchange));this.choices=new Map(e.choices.map(
n=>[n.path,xc(n,this.onchange)])),this.parts=new hn(this.onchange),this.gravities=e.gravities,this.element=u("div",{class:"controls"},this.hoop(),this.plane(),this.
start(),this.contact())}at(e){let t=this.sliders.get(e)??this.choices.get(e);if(!t)throw new Error(`There is no control of ${e}.`);return t.element}of(e,t={}){return[
...this.sliders.keys(),...this.choices.keys()].filter(n=>n.startsWith(`${e}.`)).flatMap(n=>[...t[n]??[],this.at(n)])}select(e,t,n){let o=u("select",{onchange:()=>n(
o.value)},t.map(([i,a])=>u("option",{value:i},a)));return{select:o,element:u("label",{class:"choice"},u("span",{},e),o)}}group(e,...t){let n=e==="Start"||e==="P\
lane"||!matchMedia("(max-width: 47.5em)").matches;return u("details",{class:"group",open:n},u("summary",{},e),t)}hoop(){return this.way=this.select("Given by",[
["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],e=>{let{values:t}=this.film;e==="parts"?this.onchange([["hoop.parts",da(
t)]]):this.onchange([[`hoop.${e}`,t["hoop.eccentricity"]]])}),this.derived=u("p",{class:"derived"}),this.group("Hoop",this.way.element,...this.of("hoop",{"hoop.\
radius":[this.parts.element,this.derived]}))}plane(){this.apart=u("input",{type:"checkbox",onchange:()=>{let{values:n}=this.film;this.apart.checked?this.onchange(
[["plane.mu_static",n["plane.mu_static"]],["plane.mu_kinetic",n["plane.mu_kinetic"]]]):this.onchange([["plane.mu",n["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([n])=>[n,n]),["","elsewhere"]],n=>{let o=this.gravities.find(([i])=>i===n);o&&this.onchange([["plane.gravity",o[1]]])});let t={"\
plane.slope":[u("label",{class:"check"},this.apart,"static and kinetic friction apart")],"plane.gravity":[this.gravity.element]};return this.group("Plane",...this.
of("plane",t))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],e=>{let{values:t}=this.film;e==="rolling"?this.onchange(
[["start.speed",t["start.vx"]]]):this.onchange([["start.omega",t["start.omega"]]])}),this.group("Start",this.kind.element,...this.of("start"),this.at("duration"))}contact(){
return this.group("Contact",this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),
this.at("contact.restitution"))}refuse(e,t){let n=e.length===1?this.sliders.get(e[0][0]):void 0;return n?.element.checkVisibility()?(n.entry.refuse(t),!0):!1}restore(){
this.film&&this.showChoices(this.film,new Set)}show(e,t=new Set){this.film=e,this.showChoices(e,t);let n=e.scenario;for(let[o,i]of this.sliders){if(t.has(o))continue;
let[a,r]=o.split(".");i.show(e.values[o]??(r?n[a]?.[r]:n[a]),e.automatic?.[o])}}showChoices(e,t){let{scenario:n,values:o}=e,i=n.hoop.parts?"parts":"load_fractio\
n"in n.hoop?"load_fraction":"eccentricity",a="speed"in n.start,r="mu_static"in n.plane,l=n.contact.model==="compliant",c=(...p)=>p.some(f=>t.has(f));c("hoop.loa\
d_fraction","hoop.eccentricity","hoop.parts")||(this.way.select.value=i),c("start.speed","start.omega")||(this.kind.select.value=a?"rolling":"free"),c("plane.mu",
"plane.mu_static")||(this.apart.checked=r);let m=this.gravities.find(([,p])=>Math.abs(p-n.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=m?
m[0]:"");let h={"hoop.load_fraction":i==="load_fraction","hoop.eccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!=="parts",
"plane.mu":!r,"plane.mu_static":r,"plane.mu_kinetic":r,"plane.restitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":a,"start.height":!a,"start\
.vx":!a,"start.vy":!a,"start.omega":!a,"contact.law":l,"contact.friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[p,f]of Object.
entries(h))this.at(p).hidden=!f;this.parts.element.hidden=i!=="parts",n.hoop.parts&&this.parts.show(n.hoop.parts,o["hoop.radius"],o["hoop.mass"]),this.derived.textContent=
i==="eccentricity"?"":`ε = ${M(o["hoop.eccentricity"],5)}, κ = ${M(o["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${M(o["hoop.mass"],5)} kg`:"");let d=n;for(let[
p,{select:f}]of this.choices){if(t.has(p))continue;let[g,b]=p.split(".");d[g]?.[b]!==void 0&&(f.value=d[g][b])}}};var ho=Math.PI/180;function ma(s,e){let{start:t,plane:n,contact:o,hoop:i}=s.scenario;return o.model!=="rigid"?"Rigid contact only.":s.slope!==0?"The plane must \
be level.":Math.abs(s.gravity-9.81)>1e-9?"It must be on Earth.":(n.restitution??0)!==0?"Restitution must be 0.":s.radius!==1||i.parts?"The radius must stay 1 m,\
 without parts.":s.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in i?"speed"in t?Math.abs(t.speed??3.1)>e+1e-9?e>5?"At most 10 \
m/s.":"At most 3.1 m/s.":s.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var pa=s=>s.events.filter(
({kind:e})=>e==="takeoff");function _c(s){return s.events.filter(({kind:e})=>e==="apex").map(({height:e})=>e)}var fa=(s,e)=>Math.min(Math.round(100*s/e),100),Ec=1.596,
Mc=.37,Sc=.05,co=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:s=>{let e=ma(s,3.1);if(e)return{points:0,text:e};let t=Math.max(
0,..._c(s));return t?{points:fa(t,Ec),text:"It rises by {height}.",values:{height:Ce(t)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land uprigh\
t",text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=\
0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:s=>{let e=pa(s)[0],t=s.events.find(({kind:a,t:r})=>a==="impact"&&e&&r>e.t);if(!e||!t)return{
points:0,text:"It does not hop."};let n=s.events.find(({kind:a,t:r})=>a==="apex"&&r>e.t);if(!n||n.height<Sc)return{points:0,text:"The first hop is too low."};let o=Math.
abs(t.angle-2*Math.PI*Math.round(t.angle/(2*Math.PI)))/ho,i=Math.max(0,Math.round(100*(1-(o-.5)/89.5)));return{points:Math.min(i,100),text:"It lands {off} away \
from the top.",values:{off:G(o*ho)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:s=>{let e=ma(s,10);if(e)return{points:0,text:e};if(Math.
abs(Math.abs(s.scenario.start.angle??0)-Math.PI)>.5*ho)return{points:0,text:"The load must start at the bottom."};if(s.values["plane.mu_kinetic"]>1.5||s.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let t=pa(s)[0];if(!t)return{points:0,text:"It does not hop."};let n=s.phases.filter(
({from:i})=>i<t.t);if(n.some(({mode:i})=>i==="K"))return{points:0,text:"It skids before it hops."};if(n[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let o=s.events.find(({kind:i,t:a})=>i==="apex"&&a>t.t);return o?{points:fa(o.height,Mc),text:"It rises by {height}.",values:{height:Ce(o.height)}}:{points:0,
text:"It does not hop."}}}],uo=s=>s>=95?3:s>=75?2:s>=40?1:0;var ga="hophoop-best-",Tc=s=>"★".repeat(uo(s))+"☆".repeat(3-uo(s)),un=class{constructor({film:e,load:t,ahead:n}){this.goal=null;this.solved=new Set;this.solutions=
new Set;Object.assign(this,{film:e,load:t,ahead:n}),this.tabs=new Map(co.map(o=>[o.key,u("button",{type:"button","aria-pressed":"false",onclick:()=>this.choose(
o)},o.title)])),this.text=u("p",{}),this.meter=u("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"100","aria-label":"Score"}),this.result=u("p",{class:"ch\
allenge-result",role:"status"}),this.kept=u("p",{class:"hint"}),this.element=u("section",{class:"challenges card","aria-label":"Challenges",hidden:!0},u("header",
{},u("h2",{},"Challenges"),u("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",onclick:()=>this.close()},"×")),u("div",{class:"tabs",role:"\
group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.kept,u("div",{class:"buttons"},u("button",{type:"button",onclick:()=>this.
begin()},"Begin again"),u("button",{type:"button",onclick:()=>this.solve()},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??co[0]),this.
element.scrollIntoView({block:"nearest"}),this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(e){this.goal=
e;for(let[t,n]of this.tabs)n.setAttribute("aria-pressed",String(t===e.key));R(this.text,e.text),this.changed()}begin(){this.goal&&(this.solved.delete(this.goal.
key),this.load(this.goal.start))}async solve(){let{goal:e}=this;e&&(this.solved.add(e.key),await this.load(e.best),this.solutions.add(this.film().query))}changed(){
let{goal:e}=this;if(!e)return;let{points:t,text:n,values:o={}}=e.score(this.film()),i=!this.solved.has(e.key)&&!this.solutions.has(this.film().query);this.meter.
value=t;let r=k(i?"{stars} {points} points. {what}":"{stars} {points} points, shown and not counted. {what}",{stars:Tc(t),points:t,what:k(n,o)});this.result.textContent!==
r&&(this.result.textContent=r);let l=Number(se(ga+e.key)??0),c=i&&!this.ahead()?Math.max(l,t):l;c>l&&oe(ga+e.key,String(c)),R(this.kept,k("Your best: {points} p\
oints.",{points:c}))}};var ba=.09,Ac=.03,mo=Math.PI/180,dn=Math.PI/4,wa=2*Math.PI,Lt=s=>s-wa*Math.round(s/wa);function mn(s,e){let t=s.at(e),n=e===0;return{angle:Lt(t.angle),height:Math.
max(t.height,0),vx:n?t.vx:0,vy:n?t.vy:0,omega:n?t.omega:0,slope:s.slope}}var ya=s=>2*Math.sqrt(Math.max(s.gravity,1)*s.radius),ze=s=>Number(s.toFixed(4))+0;function va(s,e,t){
if(s==="plane")return[["plane.slope",ze(e.slope)]];if(e.height>0)return[["start.angle",ze(e.angle)],["start.height",ze(e.height)],["start.vx",ze(e.vx)],["start.\
vy",ze(e.vy)],["start.omega",ze(e.omega)]];let n=s==="load"?e.omega*t.radius:e.vx;return[["start.angle",ze(e.angle)],["start.speed",ze(n)]]}var Rt=class{constructor(e,t,n,o,i){
this.grip=e;this.film=t;this.view=o;this.turned=0;this.trail=[];this.moved=0;this.before=mn(t,n),this.held={...this.before,vx:0,vy:0,omega:0};let a=t.at(n);this.
center=[a.x,t.radius+a.height],this.foot=o.point(a.x,0),this.from=this.read(i)}read(e){let[t,n]=this.view.unpoint(e.clientX,e.clientY),o=this.grip==="plane"?Math.
atan2(e.clientY-this.foot[1],e.clientX-this.foot[0]):Math.atan2(t-this.center[0],n-this.center[1]);return{x:e.clientX,y:e.clientY,along:t,away:n,turn:o}}move(e,t){
let n=this.read(e),{radius:o}=this.film;if(this.turned+=Lt(n.turn-this.from.turn-this.turned),this.grip==="plane"){let i=_(this.before.slope+this.turned,-dn,dn);
this.held.slope=Math.abs(i)<mo?0:i}else if(this.grip==="load")this.held.angle=Lt(this.before.angle+this.turned);else{let i=this.before.height+n.away-this.from.away;
this.held.height=i<Ac*o?0:i;let a=n.along-this.from.along;this.held.angle=Lt(this.before.angle+(this.held.height>0?0:a/o)),this.moved=n.x-this.from.x}for(this.trail.
push({t:t/1e3,along:n.along,away:n.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<t/1e3-ba;)this.trail.shift();return this.held}release(e){let{held:t,
trail:n,film:o}=this,i=n.at(-1),a=n[0],r=i&&a?i.t-a.t:0,l=!i||r<.012||e/1e3-i.t>ba,c=ya(o);return l||this.grip==="plane"||(this.grip==="load"?t.omega=_((i.turned-
a.turned)/r,-c/o.radius,c/o.radius):(t.vx=_((i.along-a.along)/r,-c,c),t.vy=t.height>0?_((i.away-a.away)/r,-c,c):0)),t}};function ka(s,e,t,n,o){let i={ArrowLeft:-1,
ArrowRight:1}[e]??0,a={ArrowDown:-1,ArrowUp:1}[e]??0;if(!i&&!a)return null;let r=t?.2:1;if(s==="load"){let h=Lt(n.angle+(i||a)*5*mo*r);return{...n,angle:h}}if(s===
"plane"){let h=_(n.slope+(i||-a)*mo*r,-dn,dn);return{...n,slope:Math.abs(h)<1e-9?0:h}}let l=ya(o),c=_(n.height+a*.05*r*o.radius,0,4*o.radius),m=_(n.vx+i*.1*r,-l,
l);return{...n,height:c<1e-9?0:c,vx:m}}function J(s,e,t,n=()=>{}){let o=new AbortController,{signal:i}=o,a=(l,c)=>s.addEventListener(l,m=>m.pointerId===e.pointerId&&c(m),{signal:i}),r=l=>c=>{o.abort(),
n(c,l)};s.setPointerCapture(e.pointerId),a("pointermove",t),a("pointerup",r(!0)),a("pointercancel",r(!1))}function xa(s,e){let t=new Map,n=null,o=()=>{let[a,r]=[
...t.values()];return{span:Math.max(Math.hypot(a.clientX-r.clientX,a.clientY-r.clientY),1),clientX:.5*(a.clientX+r.clientX),clientY:.5*(a.clientY+r.clientY)}};s.
addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(t.set(a.pointerId,a),n=t.size===2?o():null)}),s.addEventListener("pointermove",a=>{if(!t.has(a.pointerId)||
(t.set(a.pointerId,a),t.size!==2||!n))return;let r=o();e(r.span/n.span,r),n=r});for(let a of["pointerup","pointercancel"])s.addEventListener(a,r=>{t.delete(r.pointerId),
n=null});let i=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();return s.addEventListener("touchmove",i,{passive:!1}),()=>t.size>1}var Lc=700,pn=44,Rc=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],fn=class{constructor(e){this.lab=e;this.pull=null;this.held=null;this.before=
null;this.hint=u("div",{class:"grip-hint","aria-hidden":"true",hidden:!0},"Drag the load");this.places=new Map(Rc.map(([i,a,r])=>[i,this.place(i,a,r)])),this.tip=
u("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=u("div",{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.
values()],this.tip,this.hint);let{flat:t,plane:n}=e.stage;t.grab=i=>this.take(i),n.addEventListener("pointermove",i=>this.hover(i)),n.addEventListener("pointerl\
eave",()=>this.hover(null));let o=i=>this.pull&&i.cancelable&&i.preventDefault();n.addEventListener("touchmove",o,{passive:!1}),this.settle=ie(()=>this.chosen(!1),
Lc)}static{this.Pull=Rt}place(e,t,n){return u("div",{class:`grip grip-${e}`,role:"slider",tabindex:"0","aria-label":t,"aria-valuenow":"0",title:n,onkeydown:o=>this.
key(e,o),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.flat.views[this.lab.motions.active]}draw(){let{lab:e}=this,t=this.view(),n=!!t&&!e.
stage.options.three;if(this.element.hidden=!n,!n)return;this.element.classList.toggle("running",e.clock.playing);let{pose:o,film:i,scale:a}=t,r=i.radius,l=t.point(
o.x,r+o.height),c=t.point(o.x+r*Math.sin(o.angle),r+o.height+r*Math.cos(o.angle)),m=this.onPlane(t),h=_(1.1*r*a,pn,190),d=[["plane",m,pn],["hoop",l,h],["load",c,
pn]];for(let[p,[f,g],b]of d){let w=this.places.get(p);w.style.transform=`translate(${f-b/2}px, ${t.top+g-b/2}px)`,w.style.width=w.style.height=`${b}px`,w.hidden=
f<0||g<0||f>t.width||g>t.height}if(!this.hint.hidden){let[p,f]=d[2][1];this.hint.style.transform=`translate(${_(p,70,t.width-70)}px, ${t.top+Math.max(f-pn,18)}p\
x) translate(-50%, -50%)`}e.clock.playing||this.tell(i)}onPlane(e){let t=e.point(e.pose.x,0),o=(Math.min(t[0]+Math.max(1.9*e.film.radius*e.scale,90),e.width-30)-
t[0])/(e.scale*Math.max(e.cosine,.2));return e.point(e.pose.x+o,0)}tell(e){let t=this.pull?.held??this.held??mn(e,this.lab.clock.time),n={load:G(t.angle),hoop:k(
"gap {height}, speed {speed} m/s",{height:Ce(t.height),speed:M(t.vx,3)}),plane:G(t.slope)},o={load:t.angle*(180/Math.PI),hoop:t.height,plane:t.slope*(180/Math.PI)},
i={load:[-180,180],hoop:[0,4*e.radius],plane:[-45,45]};for(let[a,r]of this.places)r.getAttribute("aria-valuetext")!==n[a]&&(r.setAttribute("aria-valuetext",n[a]),
r.setAttribute("aria-valuenow",String(Number(o[a].toPrecision(4)))),r.setAttribute("aria-valuemin",String(i[a][0])),r.setAttribute("aria-valuemax",String(Number(
i[a][1].toPrecision(4)))))}under(e){if(this.element.hidden)return null;let t=null;for(let[n,o]of this.places){let{left:i,top:a,width:r}=o.getBoundingClientRect(),
l=Math.hypot(e.clientX-i-r/2,e.clientY-a-r/2);!o.hidden&&l<=r/2&&(t=n)}return t}hover(e){if(this.pull)return;let t=e&&e.pointerType!=="touch"?this.under(e):null;
for(let[n,o]of this.places)o.classList.toggle("near",n===t);this.lab.stage.plane.style.cursor=t?"grab":""}take(e){let t=this.under(e);if(!t||e.button>0||this.pull)
return!1;let{lab:n}=this,{flat:o,plane:i}=n.stage,a=this.places.get(t),r=this.view(),l=i.getBoundingClientRect(),c=w=>({clientX:w.clientX-l.left,clientY:w.clientY-
l.top-r.top}),m=new Rt(t,n.film(),n.clock.time,r,c(e)),h=[...o.shift],[d,p]=[!1,!1];this.pull=m,a.classList.add("held");let f=()=>{p=!0,g.abort(),a.classList.remove(
"held"),o.fixed=null,this.pull=null,d&&this.comeBack(h)},g=new AbortController,b=w=>{w.key==="Escape"&&(w.stopPropagation(),f(),d&&this.back())};return addEventListener(
"keydown",b,{capture:!0,signal:g.signal}),J(i,e,w=>{if(!p){if(o.pinched()){f(),d&&this.back();return}!d&&Math.hypot(w.clientX-e.clientX,w.clientY-e.clientY)<3||
(d||(o.fixed=r.scale,this.hold(),this.begin()),d=!0,m.move(c(w),w.timeStamp),o.shift=[h[0]+m.moved,h[1]],this.change(t,m.held,!1),this.show(t,m.held))}},(w,y)=>{
p||(f(),d&&(y?(this.change(t,m.release(w.timeStamp),!0),this.end(!0)):this.back()))}),!0}key(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return;let{lab:n}=this;if(t.
key==="Escape"&&this.held)this.back();else if(t.key==="Enter")this.chosen(!0);else{this.held??=mn(n.film(),n.clock.time);let o=ka(e,t.key,t.shiftKey,this.held,n.
film());if(!o)return;this.before===null&&(this.hold(),this.begin()),this.held=o,this.change(e==="load"?"hoop":e,o,!1),this.show(e,o),this.settle()}t.preventDefault(),
t.stopPropagation()}hold(){this.lab.clock.play(!1),this.before=this.lab.film().query}begin(){let{lab:e}=this;e.stage.options.ahead=!0,e.clock.seek(0),e.mark("ho\
lding",!0)}change(e,t,n){this.lab.motions.change(va(e,t,this.lab.film()),n)}show(e,t){let n={load:`θ = ${G(t.angle)}`,hoop:t.height>0?`y = ${Ce(t.height)}`:`θ \
= ${G(t.angle)}`,plane:`β = ${G(t.slope)}`};R(this.tip,t.vx&&this.held?`${n[e]}, v = ${M(t.vx,3)} m/s`:n[e]),this.tip.hidden=!1}chosen(e){this.held&&this.before!==
null&&this.lab.motions.change([],!0),this.end(e)}end(e){let{lab:t}=this;this.held=null,this.before=null,this.tip.hidden=!0,t.stage.options.ahead=!1,t.mark("hold\
ing",!1),e&&t.clock.seek(0),e&&t.clock.run(),t.request()}async back(){let{lab:e,before:t}=this;if(this.end(!1),t===null)return;let n=e.motions.lanes[e.motions.active];
for(n.pending=null;n.busy;)await new Promise(o=>requestAnimationFrame(o));try{e.motions.replace(await e.backend.film({query:t}))}catch(o){e.notice.fail(o)}}comeBack(e){
let{flat:t}=this.lab.stage,n=an(),o=()=>{if(this.pull)return;let i=t.shift[0]-e[0];t.shift=Math.abs(i)<1||n?[...e]:[e[0]+.82*i,e[1]],this.lab.request(),t.shift[0]!==
e[0]&&requestAnimationFrame(o)};o()}};var Pc={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function Y(s){let e="\
http://www.w3.org/2000/svg",t=document.createElementNS(e,"svg");t.setAttribute("viewBox","0 0 17 17"),t.setAttribute("aria-hidden","true"),t.setAttribute("class",
`icon icon-${s}`);let n=document.createElementNS(e,"path");return n.setAttribute("d",Pc[s]),t.append(n),t}function po(s){let e=u("select",{class:"language","aria-label":"Language",onchange:()=>{sa(e.value),so(e.value),s()}},Object.entries(Mt).map(([t,n])=>u("option",
{value:t,lang:t},document.createTextNode(n))));return e.value=Pe(),e}var Cc=Object.entries(S.words.events),Te=Object.fromEntries(Cc.map(([s,{label:e}])=>[s,e])),_a=s=>s.kind==="takeoff"||s.to==="H"&&s.from!=="H"&&s.kind!=="impact";var zc=new Set(x.passing),Nc=3,Dc=1e-10;function Oc(s){let e=[],t=-1,n=-1;for(let[o,{kind:i,from:a,to:r,t:l,height:c}]of s.entries())t>=0&&i==="apex"&&(n<0||c>s[n].
height)&&(n=o),!zc.has(i)&&(t>=0&&a==="H"&&l>s[t].t&&(e.push({begin:t,top:n,end:i==="end"?-1:o}),t=n=-1),r==="H"&&i!=="end"&&([t,n]=[o,-1]));return e}var gn=class{constructor(e,t,n){
let{larger:o=null,smaller:i=null,count:a=0}=t??{};this.events=e.events,this.count=Math.min(a,e.events.length),this.radius=e.radius,this.side=o??i,this.step=o?n:
-n,this.edge=!o||!i,this.sided=!this.edge&&(o?.sided||Ic(o,i))}rate(e,t){return this.side?this.side.rates[e*x.changes.length+si[t]]:Number.NaN}of(e,t){return this.
step*this.rate(e,t)}get failed(){return this.side&&this.side.reason!=="none"?this.side.failed:-1}hops(){return Oc(this.events.slice(0,this.count)).map(({begin:e,
top:t,end:n})=>{let o=i=>n<0?Number.NaN:this.step*(this.rate(n,i)-this.rate(e,i));return{begin:e,end:n,height:this.of(t<0?e:t,"height"),distance:o("x"),duration:o(
"t")}})}};function Ic(s,e){return s!==e&&(s?.rates.some((t,n)=>Number.isFinite(t)!==Number.isFinite(e?.rates[n]))??!1)}function Ma(s,e){let t=Math.abs(s);if(e===
"°")return I(M(t*180/Math.PI,3),"°");let n=t<.0995,o=t<9995e-8,[i,a]=n?o?[1e6,"µ"]:[1e3,"m"]:[1,""];return e==="m/s"?I(M(t,3),e):I(M(i*t,3),`${a}${e}`)}var bn=(s,e)=>Math.
abs(s)>Dc*Math.max(e,.001);function Sa(s,e){return Number.isFinite(s)?bn(s,1)?`${s>0?"+":"−"}${Ma(s,e)}`:"0":"–"}function fo(s){let e=s.filter(([t])=>Number.
isFinite(t)&&bn(t,1)).map(([t,n,o,i])=>k(t>0?o:i,{amount:Ma(t,n)})).join(Pe()==="zh"?"，":", ");return j(e)}var Ea=["m","{amount} further to the right","{amoun\
t} further to the left"],qc=["s","{amount} later","{amount} earlier"];function Ta(s){let{events:e,count:t}=s,n=[],o=s.hops();for(let[r,{begin:l,end:c,height:m,distance:h,
duration:d}]of o.slice(0,Nc).entries()){let p=c>=0&&e[c].x<e[l].x?-h:h,f=fo([[m,"m","{amount} higher","{amount} lower"],[p,"m","{amount} longer","{amount} short\
er"],[d,"s","{amount} more in the air","{amount} less in the air"],[s.of(l,"t"),"s","begins {amount} later","begins {amount} earlier"]]);f&&n.push(o.length>1?k(
"Hop {number}: {list}.",{number:r+1,list:f}):k("The hop: {list}.",{list:f}))}let i=o.length?-1:e.findIndex(({kind:r},l)=>l<t&&r!=="start"&&r!=="end");if(i>=0){let r=fo(
[[s.of(i,"t"),...qc],[s.of(i,"x"),...Ea]]);r&&n.push(k("The first event, {what}: {list}.",{what:k(Te[e[i].kind]),list:r}))}let a=t-1;if(a>0&&e[a].kind==="end"){
let r=Math.sign(e[a].vx)*s.of(a,"vx"),l=fo([[s.of(a,"x"),...Ea],[r,"m/s","{amount} faster","{amount} slower"]]);l&&n.push(k("At the end, after {time} s: {list}.",
{time:M(e[a].t,4),list:l}))}return n}var $e=S.words.signs,wn=Object.keys($e);function Aa(s,e=11){let n=[...s.filter(({kind:i})=>i in $e)].sort((i,a)=>wn.indexOf(i.kind)-wn.indexOf(a.kind)||i.x-a.x),
o=[];for(let{kind:i,x:a}of n){let r=wn.indexOf(i)<wn.indexOf("takeoff"),l=o.filter(c=>Math.abs(c.x-a)<e);l.length?l.length===1&&l[0].rare&&!o.some(c=>Math.abs(c.
x-(l[0].x+e))<e-1e-9)?l[0].mark!==$e[i]&&o.push({mark:$e[i],x:l[0].x+e,rare:!1,hidden:0}):l[0].hidden+=1:o.push({mark:$e[i],x:a,rare:r,hidden:0})}return o.sort(
(i,a)=>i.x-a.x).map(({mark:i,x:a})=>({mark:i,x:a}))}function La(s,e,t){let n=[],o=new Map,i=-1,a=(l,c,m)=>{let h=n.at(-1);h&&h.mode===l&&Math.abs(h.from+h.wide-
c)<1e-6?h.wide+=m:n.push({mode:l,from:c,wide:m})},r=()=>{o.size&&a([...o].reduce((l,c)=>c[1]>l[1]?c:l)[0],i,1),o=new Map};for(let{mode:l,from:c,to:m}of s){let[h,
d]=[Math.max(e(c),0),Math.min(e(m),t)];if(d>h)for(let p=h;p<d-1e-9;){if((Math.floor(p+1e-9)!==i||!o.size)&&(r(),i=Math.floor(p+1e-9),d-p>=1&&Math.abs(p-i)<1e-6)){
let g=Math.floor(d-p+1e-9);a(l,i,g),p=i+g;continue}let f=Math.min(d,i+1);o.set(l,(o.get(l)??0)+f-p),p=f}}return r(),n}var Ra=.7,Pa=34,Fc=3,Hc=400,jc=8,go=13;function Ca(s){let{events:e,count:t}=s;return e.slice(0,Math.min(t,Hc)).map(({kind:n,x:o,height:i},a)=>({kind:n,x:o,y:i,dx:s.
of(a,"x"),dy:s.of(a,"height")}))}function za(s,e,t){let n=s.map(({dx:r,dy:l})=>Math.hypot(r,l)).filter(r=>Number.isFinite(r)&&bn(r,e)).sort((r,l)=>r-l);if(!n.length)
return 0;let o=Math.max(Ra*e,Pa/t)/n[Math.floor(n.length/2)];if(o<=1)return 1;let i=10**Math.floor(Math.log10(o)),a=o/i;return(a>=5?5:a>=2?2:1)*i}function Na(s,e,t){
let n=[],o=Fc*Math.max(Ra*s.film.radius,Pa/s.scale);for(let{kind:i,x:a,y:r,dx:l,dy:c}of e){let m=Number.isFinite(l)&&Number.isFinite(c),h=m?t*Math.hypot(l,c):0,
d=h>o?o/h:1,p=m?[d*t*l,d*t*c]:[0,0],f=s.point(a,r),g=s.point(a+p[0],r+p[1]);if(Math.max(f[0],g[0])<-20||Math.min(f[0],g[0])>s.width+20)continue;let[b,w]=[Math.min(
f[0],g[0])-12,Math.max(f[0],g[0])+12],y=f[1];for(;n.some(E=>Math.abs(E.base-y)<go-1&&E.low<w&&E.high>b);)y-=go;if(f[1]-y>jc*go)continue;n.push({low:b,high:w,base:y});
let v=y-f[1];Bc(s,f,[g[0],g[1]+v],v,{known:m,broken:d<1,mark:$e[i]??""})}}function Bc({context:s,look:e},t,n,o,{known:i,broken:a,mark:r}){let l=[t[0],t[1]+o],c=Math.
hypot(n[0]-l[0],n[1]-l[1]),[m,h]=c>0?[(n[0]-l[0])/c,(n[1]-l[1])/c]:[1,0],d=Math.min(9,c);for(let[f,g]of[[e.paper,6.5],[e.ink,2.5]])s.strokeStyle=f,s.fillStyle=f,
s.lineCap="round",o&&(s.lineWidth=g>3?3:1,s.beginPath(),s.moveTo(t[0],t[1]),s.lineTo(l[0],l[1]),s.stroke()),s.lineWidth=g,s.setLineDash(a?[5,6]:[]),s.beginPath(),
s.moveTo(l[0],l[1]),s.lineTo(n[0]-m*d,n[1]-h*d),s.stroke(),s.setLineDash([]),s.beginPath(),s.arc(l[0],l[1],g>3?5.5:3.5,0,2*Math.PI),s.fill(),!(c<1)&&(s.lineWidth=
g>3?4:1,s.beginPath(),s.moveTo(n[0],n[1]),s.lineTo(n[0]-m*d-h*d*.55,n[1]-h*d+m*d*.55),s.lineTo(n[0]-m*d+h*d*.55,n[1]-h*d-m*d*.55),s.closePath(),s.stroke(),s.fill());
s.lineCap="butt";let p=i?r:"?";p&&(s.font=`600 ${11*e.px}px ${e.font}`,s.textAlign="center",s.lineWidth=3,s.strokeStyle=e.paper,s.fillStyle=e.ink,s.strokeText(p,
l[0],l[1]-7),s.fillText(p,l[0],l[1]-7))}var Da=Math.PI/180,$c=100,Oa="plane.mu",Wc=/^(contact\.|duration$)/,Gc=200,yn=S.reasons;function Ia(s,e){return s.textContent=e,s}var vn=class{constructor(e){this.
lab=e;this.on=!1;this.path=Oa;this.changes=null;this.arrows=[];this.factor=0;this.three=!1;this.asked=null;this.known="";this.texts="";this.speak=!1;this.later=
ie(()=>this.fetch(),$c),this.switch=u("button",{type:"button",class:"switch",title:"What a little more would do (a)","aria-pressed":"false",onclick:()=>this.turn()},
"Arrows"),this.picked=u("select",{onchange:()=>this.pick(this.picked.value)}),this.step=u("span",{class:"more-step"}),this.take=u("button",{type:"button",onclick:()=>this.
apply()},"Do it"),this.said=u("ul",{class:"more-said"}),this.reason=u("p",{class:"more-reason",hidden:!0}),this.scale=u("p",{class:"hint"}),this.body=u("tbody",
{}),this.rows=u("details",{class:"more-events"},u("summary",{},"Every event, by this step"),u("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"\
What changes at every event"},u("table",{},u("thead",{},u("tr",{},["event","time","place","height","load angle"].map(t=>u("th",{scope:"col"},t)))),this.body))),
this.element=u("section",{class:"table more","aria-label":"What a little more would do",hidden:!0},u("header",{},u("h2",{},"What a little more would do"),u("but\
ton",{type:"button",onclick:()=>this.turn(!1)},"Close")),u("div",{class:"more-asked"},u("label",{},u("span",{},"A little more"),this.picked),this.step,this.take),
this.said,this.reason,this.rows,this.scale),e.stage.flat.over=(t,n)=>{let o=e.marked("guessing");if(!this.on||o||n!==e.motions.active)return;let i=za(this.arrows,
t.film.radius,t.scale);(i||this.arrows.some(({dx:a})=>Number.isNaN(a)))&&Na(t,this.arrows,i||1),i!==this.factor&&(this.factor=i,this.tellScale())}}turn(e=!this.
on,t=this.path){this.on=e,this.path=t,this.element.hidden=!e,this.switch.setAttribute("aria-pressed",String(e)),this.known="",e?this.changed(!0):this.forget(),this.
lab.motions.lanes.length&&this.lab.address?.soon(),this.lab.request()}pick(e){this.path=e,this.known="",this.changed(!0),this.lab.address?.soon()}offered(){return[
...this.lab.controls.sliders.values()].filter(({info:t,element:n})=>!n.hidden&&!Wc.test(t.path)).map(({info:t})=>t)}parameter(){let{values:e,scenario:t}=this.lab.
film(),n=this.offered().find(({path:r})=>r===this.path);if(!n)return null;let[o,i]=n.path.split("."),a=e[n.path]??t[o][i];return{info:n,value:Number(a==="inf"?1/0:
a),step:n.step*(n.degrees?Da:1)}}changed(e=!1){if(!this.on||(this.speak||=e,!this.lab.motions.lanes.length))return;this.offer();let{query:t}=this.lab.film();this.
known===`${this.path} ${t}`?this.tell():(this.forget(),this.later())}offer(){let e=this.offered();e.some(({path:n})=>n===this.path)||(this.path=e.find(({path:n})=>n.
startsWith(Oa))?.path??e[0].path);let t=e.map(({label:n,symbol:o})=>`${k(n)} ${o}`);t.join()!==this.texts&&(this.texts=t.join(),this.picked.replaceChildren(...e.
map(({path:n},o)=>Ia(u("option",{value:n}),t[o])))),this.picked.value=this.path}forget(){this.asked?.abort(),this.changes=null,this.arrows=[],this.factor=0}async fetch(){
if(!this.on)return;let{lab:e,path:t}=this,n=e.film(),o=this.parameter();this.asked?.abort(),this.asked=new AbortController;let{signal:i}=this.asked;if(this.known=
`${t} ${n.query}`,!o||!Number.isFinite(o.value))return this.refuse("It is infinite: there is no more of it.");try{let a=await e.backend.changes(n.scenario,t,i);
if(i.aborted||e.film()!==n)return;if(!a)return this.refuse(yn.edge);this.changes=new gn(n,a,o.step),this.arrows=Ca(this.changes),this.factor=0,this.tell()}catch(a){
let{name:r,message:l}=a;r!=="AbortError"&&!i.aborted&&this.refuse(l)}e.request()}refuse(e){this.forget(),this.take.disabled=!0;for(let t of[this.step,this.said,
this.body])t.replaceChildren();this.rows.hidden=this.scale.hidden=!0,this.reason.hidden=!1,R(this.reason,e),this.speak&&this.lab.story.say(k(e)),this.speak=!1,this.
lab.request()}tell(){let{changes:e}=this,t=this.parameter();if(!e||!t)return;let{info:n,value:o}=t,i=c=>I(M(n.degrees?c/Da:c,5),n.unit),a=`${i(o)} → ${i(o+e.step)}`;
this.step.textContent=a,this.take.disabled=!1,this.rows.hidden=this.scale.hidden=!1;let r=Ta(e);!r.length&&e.failed<0&&r.push(k("Nothing: no event moves.")),this.
said.replaceChildren(...r.map(c=>Ia(u("li",{}),c)));let l=this.why(e);this.reason.hidden=!l,this.reason.textContent=l,this.fill(e),this.tellScale(),this.speak&&
this.lab.story.say(j([`${k(n.label)} ${a}.`,...r,l&&k(l)].filter(Boolean).join(" "))),this.speak=!1}frame(){let{three:e}=this.lab.stage.options;this.on&&e!==this.
three&&this.changes&&this.tellScale(),this.three=e}tellScale(){let{three:e}=this.lab.stage.options,t=e?"The arrows are drawn in the picture in the plane: leave \
3D to see them.":k("The arrows in the picture lead from where the rim touches to where it would, {factor} times as long.",{factor:M(this.factor,3)});this.scale.
textContent=e||this.factor?k(t):""}why(e){let{failed:t,side:n,events:o,edge:i,sided:a}=e;if(t>=0&&n){let{kind:r,t:l}=o[Math.min(t,o.length-1)],c=k(Te[r]??r),m=k(
yn[n.reason]);return j(k("From {what} at {time} s on no derivative: {reason}.",{what:c,time:M(l,4),reason:m}))}return i?j(k("To one side only: {reason}.",{reason:k(
yn.edge)})):a?j(k("To one side only: {reason}.",{reason:k(yn.sided)})):""}fill(e){let t=(o,i,a)=>{let r=Sa(o,i),l=r[0]==="+"?"▲ ":r[0]==="−"?"▼ ":"";return u(
"td",{"data-rate":String(a)},l&&u("span",{"aria-hidden":"true"},l),j(r))},n=[["t","s"],["x","m"],["height","m"],["angle","°"]];this.body.replaceChildren(...e.events.
slice(0,Math.min(e.count,Gc)).map(({kind:o,t:i},a)=>u("tr",{onclick:()=>this.lab.clock.seek(i)},u("th",{scope:"row"},Te[o]??o,u("small",{},` ${M(i,4)} s`)),n.map(
([r,l])=>t(e.of(a,r),l,e.rate(a,r))))))}apply(){let e=this.parameter();if(!e||!this.changes)return;let t=Number((e.value+this.changes.step).toPrecision(12));this.
lab.motions.change([[this.path,t]],!0)}};var kn=class{constructor(e,t){this.root=e;this.show=t;this.full=!1;this.on=!1;this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener(
"fullscreenchange",this.left),this.onchange=()=>{}}async turn(e=!this.on){let{root:t}=this;if(this.on=e,t.classList.toggle("presenting",e),this.onchange(),this.
show(),!e){let n=this.full;this.full=!1,n&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await t.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var qa=.22,Fa=.03;function Ha(s,e){let t=s.at(e),n=s.mass*(s.gravity||9.81),o=t.mode==="H"||!(t.normal_force>0)?0:t.normal_force/n,i=o/(1+o),a=t.mode==="S"||t.mode===
"K",r=Math.abs(t.slip)/Math.sqrt((s.gravity||9.81)*s.radius);return{tone:i,pitch:55*(1+Math.min(o,8))**.5,hiss:a?i*_(.15+r,0,1):0}}function ja(s,e,t){let n=Math.
sqrt(2*(s.gravity||9.81)*s.radius);return s.events.filter(({kind:o,t:i,before:a})=>o==="impact"&&a&&i>e&&i<=t).map(({before:o})=>_(Math.abs(o.vy)/n,.02,1))}function Uc(s){
let e=s.createBuffer(1,s.sampleRate,s.sampleRate),t=e.getChannelData(0),n=1;for(let o=0;o<t.length;o++)n=n*16807%2147483647,t[o]=2*n/2147483647-1;return e}var xn=class{constructor(){
this.context=null;this.on=!1;this.last=0}static{this.heard=Ha}static{this.knocks=ja}start(){let e=new AudioContext,t=e.createOscillator();t.type="triangle";let n=e.
createBufferSource();n.buffer=Uc(e),n.loop=!0;let o=e.createBiquadFilter();o.type="bandpass",o.frequency.value=1800,o.Q.value=.6;let[i,a]=[e.createGain(),e.createGain()];
i.gain.value=a.gain.value=0,t.connect(i).connect(e.destination),n.connect(o).connect(a).connect(e.destination),t.start(),n.start(),this.context=e,Object.assign(
this,{tone:t,low:i,high:a})}turn(e){this.on=e,e&&!this.context&&this.start(),e?this.context?.resume():this.context&&(this.set("low",0),this.set("high",0))}set(e,t){
let{gain:n}=this[e];n.setTargetAtTime(qa*t,this.context.currentTime,Fa)}follow(e,t){if(!this.on||!this.context)return;if(!t.playing){this.set("low",0),this.set(
"high",0),this.last=t.time;return}let{tone:n,pitch:o,hiss:i}=Ha(e,t.time);if(this.set("low",n),this.set("high",.6*i),this.tone.frequency.setTargetAtTime(o,this.
context.currentTime,Fa),t.time>this.last)for(let a of ja(e,this.last,t.time))this.knock(a);this.last=t.time}knock(e){let t=this.context,n=t.currentTime,o=t.createGain();
o.gain.setValueAtTime(2.2*qa*Math.sqrt(e),n),o.gain.exponentialRampToValueAtTime(1e-4,n+.18);let i=t.createOscillator();i.frequency.setValueAtTime(190,n),i.frequency.
exponentialRampToValueAtTime(60,n+.15),i.connect(o).connect(t.destination),i.start(n),i.stop(n+.2)}close(){this.context?.close()}};var bo=Math.PI/180,X=s=>e=>e.columns[s],Pt=(s,e)=>t=>t.derived(s,n=>Float64Array.from(t.t,(o,i)=>e(n,i,t))),U={time:{name:"time",symbol:"t",unit:"s",values:s=>s.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:Pt("degrees",({angle:s},e)=>s[e]/bo)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:Pt(
"within",({angle:s},e)=>{let t=n=>Math.floor(s[n]/bo/360);return e>0&&t(e)!==t(e-1)?Number.NaN:s[e]/bo-360*t(e)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:X("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:X("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:Pt(
"rise",({height:s,angle:e},t,n)=>n.radius*(1+n.eccentricity*Math.cos(e[t]))+s[t])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:X("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:Pt("spin",({omega:s},e,t)=>s[e]*t.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:X(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:X("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:X("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:X("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:X("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:X("utilization")},kinetic:{name:"kinetic energy",symbol:"W_k",unit:"J",values:X("kinetic")},potential:{name:"\
potential energy",symbol:"W_p",unit:"J",values:X("potential")},total:{name:"total energy",symbol:"W",unit:"J",values:Pt("total",({kinetic:s,potential:e},t)=>s[t]+
e[t])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:X("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:X("normal_loss")},rolling_resistance:{name:"lost to rolling resistance",symbol:"W_r",unit:"J",values:X("rolling_resistance")}},Ba=({name:s,symbol:e})=>[
s," ",e];var Kc=["time","angle","x","vx","spin","normal_force","friction_force"],Vc=[1,.5,.2,.1,.05,.02,.01],wo=601;function $a(s,e,t){let n=Math.min(Math.floor(s.duration/
t+1e-9)+1,wo),o=[];for(let i=0;i<n;i++){let a=Number((i*t).toPrecision(12));o.push({time:a,mode:s.at(a).mode,values:e.map(r=>Jc(s,r,a))})}return o}function Jc(s,e,t){
return U[e].values(s.moment(t))[0]}var _n=class{constructor({film:e,clock:t,names:n}){this.rows=[];this.columns=[...Kc];this.source=e,this.clock=t,this.names=n,
this.step=u("select",{onchange:()=>this.fill()},Vc.map(o=>u("option",{value:String(o)},`${o} s`))),this.step.value="0.1",this.picks=u("div",{class:"table-picks"},
Object.entries(U).filter(([o])=>o!=="time").map(([o,{name:i}])=>this.pick(o,i))),this.caption=u("caption",{}),this.head=u("thead",{}),this.body=u("tbody",{}),this.
element=u("section",{class:"table","aria-label":"Table of the motion",hidden:!0},u("header",{},u("h2",{},"Table"),u("label",{class:"table-step"},u("span",{},"Ev\
ery"),this.step),u("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),u("button",{type:"button",onclick:()=>this.open(!1)},"Close")),u("details",{class:"\
table-columns"},u("summary",{},"Columns"),this.picks),u("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table of the motion, rows"},u("tabl\
e",{},this.caption,this.head,this.body)))}pick(e,t){let n=u("input",{type:"checkbox",checked:this.columns.includes(e),onchange:()=>{let o=new Set(this.columns);
n.checked?o.add(e):o.delete(e),this.columns=Object.keys(U).filter(i=>o.has(i)),this.fill()}});return u("label",{},n,u("span",{},t))}open(e){this.element.hidden=
!e,e&&(this.draw(this.source()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(e){this.element.hidden||(this.
film=e,this.fill())}fill(){let{film:e,columns:t}=this,n=Number(this.step.value),o=this.names(),i=t.map(c=>U[c]);this.head.replaceChildren(u("tr",{},i.map(({name:c,
symbol:m,unit:h})=>u("th",{scope:"col",title:c},m,h&&u("small",{},` ${h}`))),u("th",{scope:"col"},"mode")));let a=$a(e,t,n);this.rows=a.map(({time:c,mode:m,values:h})=>({
time:c,row:u("tr",{onclick:()=>this.clock.seek(c)},h.map((d,p)=>p===0?u("th",{scope:"row"},M(d,4)):u("td",{},M(d,4))),u("td",{class:"table-mode"},o[m]))})),this.
body.replaceChildren(...this.rows.map(({row:c})=>c));let r=e.duration/n+1<=wo+1e-6,l=k("The first {count} rows.",{count:wo});R(this.caption,r?e.summary:j(`${e.summary}\
 ${l}`)),this.cursor(this.clock.time)}cursor(e){if(this.element.hidden||!this.rows.length)return;let t=Number(this.step.value),n=this.rows[Math.min(Math.round(e/
t),this.rows.length-1)]?.row;n!==this.now&&(this.now?.classList.remove("now"),n?.classList.add("now"),this.now=n)}save(){let{film:e,columns:t}=this,n=[...t.map(
i=>`${U[i].name} [${U[i].unit||"1"}]`),"mode"],o=$a(e,t,Number(this.step.value)).map(({mode:i,values:a})=>[...a,i].join(","));et(new Blob([[n.join(","),...o,""].
join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var Yc=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["a","arrows: what a little more would do"],["3","in space"],["+ − 0","zoom, zoom back"],
["Esc","leave a field, a menu, a picture that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],Zc=[["R","roll","the rim does n\
ot slide"],["S","spin","slip: the rim turns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip\
 +, for a hoop that rolls ahead)"],["H","flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],Qc=[["▲ ▼","\
take-off, landing"],["•","highest point"],["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy ou\
t of nothing"],["≋","bounces without number end"],["◗ ■","skimming begins, rest"]],yo=(s,e,t=()=>!1)=>u("table",{},u("caption",{},s),e.map(([n,...o])=>u("\
tr",{},u("th",{scope:"row"},t(n),n),o.map(i=>u("td",{},i))))),vo=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function Wa(s,e){let t=vo(),n=(r,l)=>u(
"a",{href:r,target:"_blank",rel:"noopener"},l),o=(r,...l)=>[u("dt",{},r),u("dd",{},l)],i=e&&n(new URL("licences.txt",import.meta.url).href,"Licences of all that\
 the page contains"),a=u("dialog",{class:"about","aria-label":"About hophoop"},u("h2",{},"About hophoop"),u("p",{},"hophoop computes exactly how a hoop with a l\
oad on its rim rolls, slips, hops and lands."),u("dl",{},o("Version",document.createTextNode(s)),o("Licence",document.createTextNode("MIT"),...i?[". ",i]:[]),o(
"Documentation",t?n(t,"The documentation"):"docs/index.md in the source; this page: docs/lab.md"),o("Commands",u("code",{},document.createTextNode("hophoop --he\
lp")))),u("button",{type:"button",class:"close",onclick:()=>a.close()},"Close"));return a}function Ga(s,e,t){let n=u("dialog",{class:"help","aria-label":"Keys a\
nd help"},u("h2",{},"The hoop"),u("p",{},"A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: so it sli\
ps, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see."),yo("Modes",Zc,o=>u("i",{class:"dot",style:`background:${e.
modes[o]}`})),yo("Marks on the bar of time",Qc),yo("Keys",Yc),t,u("button",{type:"button",class:"link",onclick:()=>s.showModal()},"About hophoop"),u("button",{type:"\
button",class:"close",onclick:()=>n.close()},"Close"));return n}var Ua="hoop.radius=0.4&duration=1.5&start.speed=",Xc=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${Ua}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],eu=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],tu=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],nu=["1.0","1.3","1.6","1.9","2.2","2.3"];function Ka(s,e){let t=m=>{c.close(),s(m)},n=(m,h="Show")=>u("button",{type:"\
button",class:"link",onclick:()=>t(m)},h),o=vo(),i=o&&[["teach/index.html","Teaching with the hoop"],["teach/worksheet.html","Worksheet"],["teach/solutions.html",
"Solutions"],["teach/exercises.html","Exercises"]],a=u("table",{},u("caption",{},"A lesson of 45 minutes"),u("thead",{},u("tr",{},["Minute","What happens","Moti\
on"].map(m=>u("th",{scope:"col"},m)))),u("tbody",{},Xc.map(([m,h,d])=>u("tr",{},u("th",{scope:"row"},m),u("td",{},h),u("td",{},d===null?"":n(d)))))),r=u("table",
{},u("caption",{},"What students often think"),u("thead",{},u("tr",{},["Idea","What is right"].map(m=>u("th",{scope:"col"},m)))),u("tbody",{},eu.map(([m,h])=>u(
"tr",{},u("td",{},m),u("td",{},h))))),l=u("section",{class:"sheet"},u("h3",{},"Worksheet: the hoop that hops"),u("p",{},"A thin ring of radius 0.40 m has a mass\
 of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9\
.81 m/s²."),u("ol",{},tu.map(m=>u("li",{},m,u("div",{class:"answer-line"})))),u("table",{class:"sheet-table"},u("thead",{},u("tr",{},["v₀ [m/s]","phases","do\
es it hop?","at which angle?"].map(m=>u("th",{scope:"col"},m)))),u("tbody",{},nu.map(m=>u("tr",{},u("th",{scope:"row"},n(`${Ua}${Number(m)}`,m)),u("td",{}),u("t\
d",{}),u("td",{})))))),c=u("dialog",{class:"teach","aria-label":"For teachers"},u("header",{},u("h2",{},"For teachers"),u("button",{type:"button",onclick:()=>print()},
"Print"),u("button",{type:"button",class:"close",onclick:()=>c.close()},"Close")),u("p",{},"The visit asks before it shows; the presentation fills the screen; t\
he table gives numbers to every student. ",u("button",{type:"button",class:"link",onclick:()=>{c.close(),e()}},"Start the visit")),i&&u("p",{},i.map(([m,h])=>u(
"a",{class:"teach-page",href:new URL(m,new URL(o,document.baseURI)).href},h))),a,r,l);return c}var ko=S.words.letters,su=1/60,Va=8,ou={x:"vx",angle:"omega",height:"vy"},We=class{constructor(e){this.latest=null;this.pinned=null;this.sure=!0;this.cache=new Map;
this.part=null;let{header:t}=e;this.scenario=t.scenario,this.query=t.query,this.duration=t.duration,this.status=t.status,this.sequence=t.sequence,this.fingerprint=
t.fingerprint??null,this.events=t.events,this.values=t.values,this.automatic=t.automatic,this.said=t.summary,this.story=t.story,this.shortened=t.shortened,this.
doubt=t.doubt??"",this.columns=e.arrays,this.exact=e.exact,this.samples=e.samples,this.t=e.arrays.t,this.length=this.t.length,this.radius=this.values["hoop.radi\
us"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=this.scenario.plane.
gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent()}wanted(e,t=0){if(this.duration<su*this.length)return null;let n=_(e,0,this.duration),o=Math.
min(n+t,this.duration);if(this.part&&n>=this.part.t[0]&&o<=this.part.t[this.part.length-1])return null;let i=Math.max(n-.25*Va,0);return[i,Math.min(i+Va+t,this.
duration)]}refine(e){this.part=this.with(e),this.latest=null}with(e){let{t}=e,n={columns:e,t,length:t.length,cache:new Map,part:null,latest:null,pinned:null,sure:!0};
return Object.assign(Object.create(this),n)}pin(e,t){let n=this.with(e);this.pinned=n.one(n.index(t)),this.latest=null}one(e){return this.with(Object.fromEntries(
Object.entries(this.columns).map(([t,n])=>[t,[n[e]]])))}holding(e){let{part:t}=this;return t&&e>=t.t[0]&&e<=t.t[t.length-1]?t:this}get summary(){return ia(this.
said)}findPhases(){let{mode:e}=this.columns,t=[];for(let n=0;n<this.length;n++){let o=t.at(-1);o&&o.mode===ko[e[n]]?o.to=this.t[n]:t.push({mode:ko[e[n]],from:this.
t[n],to:this.t[n]})}for(let n=0;n+1<t.length;n++)t[n].to=t[n+1].from;return t.filter(n=>n.to>n.from||t.length===1)}findExtent(){let{x:e,height:t,vx:n,vy:o,omega:i}=this.
columns,a={left:1/0,right:-1/0,top:0,speed:0},r=[];for(let l=0;l<this.length;l++){Number.isFinite(e[l])&&(a.left=Math.min(a.left,e[l]),a.right=Math.max(a.right,
e[l])),t[l]>a.top&&(a.top=t[l]);let c=Math.hypot(n[l],o[l])+this.radius*Math.abs(i[l]);Number.isFinite(c)&&r.push(c)}return r.sort((l,c)=>l-c),a.speed=r[Math.floor(
.95*(r.length-1))]||1,a}index(e){let t=0,n=this.length;for(;n-t>1;){let o=t+n>>1;this.t[o]<=e?t=o:n=o}return t}pieces(){let{part:e}=this;if(!e)return[{film:this,
from:0,to:this.length}];let[t,n]=[e.t[0],e.t[e.length-1]],o=this.index(t);for(;o>0&&this.t[o]>=t;)o--;let i=this.t[o]>=t?0:o+1;return[{film:this,from:0,to:i},{film:e,
from:0,to:e.length},{film:this,from:this.index(n)+1,to:this.length}]}moment(e){let t=_(e,0,this.duration);if(this.latest?.t[0]===t)return this.latest;let{pinned:n,
exact:o}=this,i=this.holding(t),a=i.index(t);return o?this.latest=this.with({...o(t),mode:[i.columns.mode[a]]}):n?.t[0]===t?this.latest=n:this.latest=i.t[a]===t?
i.one(a):i.between(t,a),this.latest}between(e,t){let n=Math.min(t+1,this.length-1),o=this.t[n]-this.t[t],i=o>0?(e-this.t[t])/o:0,a={};for(let[r,l]of Object.entries(
this.columns)){let c=l[t],m=l[n],h=this.columns[ou[r]];r==="mode"||!Number.isFinite(m)?a[r]=[c]:a[r]=[h?iu(c,m,h[t]*o,h[n]*o,i):c+(m-c)*i]}return Object.assign(
this.with({...a,t:[e]}),{sure:!1})}at(e){let{columns:t,sure:n}=this.moment(e);return{...Object.fromEntries(Object.entries(t).map(([i,[a]])=>[i,a])),mode:ko[t.mode[0]],
digits:n?3:2}}derived(e,t){let n=this.cache.get(e)??t(this.columns);return this.cache.set(e,n),n}};function iu(s,e,t,n,o){if(!Number.isFinite(t)||!Number.isFinite(
n))return s+(e-s)*o;let i=1-o;return i*i*(1+2*o)*s+o*o*(3-2*o)*e+o*i*(i*t-o*n)}var Eo=s=>s-360*Math.floor(s/360);function au(s,e){let t=Math.abs(Eo(s-e+180)-180);return Math.round(100*_(1-(t-1)/89,0,1))}function ru(s,e){let t=Math.max(...e)-
Math.min(...e,0),n=e.reduce((o,i,a)=>o+Math.abs(i-s[a]),0)/e.length;return Math.round(100*_(1-2*n/(t||1),0,1))}var lu=0;function Nt(s,e,t=!1){let n=`hh-guess-${++lu}`,
o="",i=s.map(([a,r])=>{let l=u("input",{type:"radio",name:n,value:a,onchange:()=>{o=a,e()}});return{key:a,radio:l,row:u("label",{class:"guess-choice"},l,u("span",
{},r))}});return{element:u("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},i.map(({row:a})=>a)),made:()=>o!=="",judge:a=>{for(let{key:r,radio:l,
row:c}of i){l.disabled=!0;let m=t||r===a;m&&c.append(u("b",{class:"guess-right"},"✓")),c.classList.toggle("right",m)}return t||o===a?100:0}}}var ve=168,zt=58,
xo=(s,e=zt)=>{let t=s*Math.PI/180;return[ve/2+e*Math.sin(t),ve/2-e*Math.cos(t)]};function Mo(s,e){let t=0,n=!1,o=null,i=u("canvas",{class:"dial-canvas"}),a=u("d\
iv",{class:"guess dial",role:"slider",tabindex:"0","aria-label":s,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},i),r=()=>{let m=getComputedStyle(
a),{context:h}=K(i,Number.parseFloat(m.width)/ve||1),d=m.getPropertyValue("--ink").trim(),p=m.getPropertyValue("--soft").trim(),f=m.getPropertyValue("--accent").
trim();h.clearRect(0,0,ve,ve),h.strokeStyle=p,h.fillStyle=p,h.lineWidth=1.5,h.beginPath(),h.moveTo(8,ve/2+zt),h.lineTo(ve-8,ve/2+zt),h.stroke(),h.lineWidth=4,h.
beginPath(),h.arc(ve/2,ve/2,zt,0,2*Math.PI),h.stroke(),h.font="11px system-ui, sans-serif",h.textAlign="center";for(let b of[0,90,180,270]){let[w,y]=xo(b,zt-28);
h.fillText(`${b}°`,w,y+4)}let g=(b,w,y)=>{h.fillStyle=w,h.beginPath(),h.arc(...xo(b),y,0,2*Math.PI),h.fill()};o!==null&&(h.strokeStyle=d,h.lineWidth=2,h.beginPath(),
h.arc(...xo(o),12,0,2*Math.PI),h.stroke(),g(o,d,7)),g(t,n?f:p,9)},l=m=>{o===null&&(t=Eo(m),n=!0,a.setAttribute("aria-valuenow",String(Math.round(t))),a.setAttribute(
"aria-valuetext",`${Math.round(t)}°`),r(),e())},c=m=>{let h=i.getBoundingClientRect(),[d,p]=[m.clientX-h.left-h.width/2,m.clientY-h.top-h.height/2];l(Math.atan2(
d,-p)*180/Math.PI)};return a.addEventListener("pointerdown",m=>{m.preventDefault(),a.focus({preventScroll:!0}),c(m),J(a,m,c)}),a.addEventListener("keydown",m=>{
let h={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,PageUp:45}[m.key];h!==void 0&&(m.preventDefault(),m.stopPropagation(),l(t+(m.shiftKey?h/5:h)))}),
requestAnimationFrame(r),{element:a,redraw:r,made:()=>n,judge:m=>(o=Eo(m),r(),au(t,o))}}var Ct=9,[ye,En,Ge,_o]=[34,12,12,26];function Ja({label:s,unit:e,most:t},n){
let o=Array(Ct).fill(t/4),i=!1,a=null,r=u("canvas",{class:"sketch-canvas"}),l=o.map((y,v)=>u("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":`${s}\
 with the load at ${45*v}°`,"aria-orientation":"vertical","aria-valuemin":"0","aria-valuemax":String(t),onkeydown:E=>{let T={ArrowUp:1,ArrowRight:1,ArrowDown:-1,
ArrowLeft:-1}[E.key];T&&(E.preventDefault(),E.stopPropagation(),g(v,o[v]+T*t/(E.shiftKey?100:20)))}})),c=u("div",{class:"guess sketch",role:"group","aria-label":"\
Draw the curve: pull the points up and down"},r,l),m=()=>r.getBoundingClientRect(),h={width:0,height:0,px:1},d=y=>ye+y/(Ct-1)*(h.width-ye-En),p=y=>Ge+(1-y/t)*(h.
height-Ge-_o),f=()=>{let y=getComputedStyle(c),v=Number.parseFloat(y.getPropertyValue("font-size"))/14||1,{context:E,width:T,height:L}=K(r,v);h={width:T,height:L,
px:v};let P=A=>y.getPropertyValue(A).trim();E.clearRect(0,0,T,L),E.strokeStyle=P("--line"),E.fillStyle=P("--soft"),E.font="11px system-ui, sans-serif";for(let A=0;A<
Ct;A+=2)E.textAlign="center",E.fillText(`${45*A}°`,d(A),L-8),E.strokeRect(d(A),Ge,0,L-Ge-_o);for(let A of[0,t/2,t])E.textAlign="right",E.fillText(String(A),ye-
6,p(A)+4),E.strokeRect(ye,p(A),T-ye-En,0);E.textAlign="left",E.fillText(e,ye+4,Ge+10);let F=(A,D,H)=>{E.strokeStyle=D,E.lineWidth=2.5,E.setLineDash(H),E.beginPath(),
A.forEach((le,Ie)=>{let jt=ye+Ie/(A.length-1)*(T-ye-En);Ie?E.lineTo(jt,p(_(le,0,t))):E.moveTo(jt,p(_(le,0,t)))}),E.stroke(),E.setLineDash([])};F(o,P("--accent"),
[6,4]),a&&F(a,P("--ink"),[]),l.forEach((A,D)=>{A.style.transform=`translate(${v*d(D)}px, ${v*p(o[D])}px)`})},g=(y,v)=>{a||(o[y]=_(v,0,t),i=!0,l[y].setAttribute(
"aria-valuenow",o[y].toPrecision(3)),l[y].setAttribute("aria-valuetext",`${o[y].toPrecision(2)} ${e}`),f(),n())},b=null,w=y=>{let v=m(),[E,T]=[y.clientX-v.left,
y.clientY-v.top].map(H=>H/h.px),L=_((E-ye)/(h.width-ye-En),0,1),P=Math.round(L*(Ct-1)),F=t*(1-(T-Ge)/(h.height-Ge-_o)),A=b??P,D=o[A];for(let H=Math.min(A,P);H<=
Math.max(A,P);H++)g(H,A===P?F:D+(F-D)*(H-A)/(P-A));b=P};c.addEventListener("pointerdown",y=>{y.preventDefault(),b=null,w(y),J(c,y,w)});for(let[y,v]of l.entries())
v.setAttribute("aria-valuenow",o[y].toPrecision(3));return requestAnimationFrame(f),{element:c,redraw:f,made:()=>i,judge:y=>{a=y,f();let v=(y.length-1)/(Ct-1);return ru(
o,o.map((E,T)=>y[Math.round(T*v)]))}}}var Sn=2*Math.PI,te=(s,e)=>s.events.find(t=>t.kind===e),Mn=s=>G(s-Sn*Math.floor(s/Sn));function hu(s,e,t=72){let{angle:n}=s.columns,o=s.columns[e],i=[],a=0;for(let r=0;r<=
t;r++){let l=s.columns.angle[0]+Sn*r/t;for(;a+1<s.length&&n[a+1]<l;)a+=1;let c=Math.min(a+1,s.length-1),m=n[c]>n[a]?Math.min((l-n[a])/(n[c]-n[a]),1):0;i.push(o[a]+
m*(o[c]-o[a]))}return i}var cu=(s,e)=>s.t[s.columns.angle.findIndex(t=>t>=e)]??s.duration,uu={R:"roll",S:"spin",K:"skid",H:"bounce"},Ue=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:s=>Nt(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],s),until:([s])=>{
let[e,t]=[te(s,"skim"),te(s,"impact")];return e?e.t+.7*((t?.t??s.duration)-e.t):s.duration},answer:([s])=>{let e=te(s,"skim")??te(s,"takeoff");return{truth:e?.kind===
"skim"?"skim":e?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:Mn(e?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:s=>Ja({label:"Speed of the centre",unit:"m/s",most:10},
s),until:([s])=>cu(s,Sn),answer:([s])=>{let e=hu(s,"vx");return{truth:e,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:M(Math.max(
...e),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:s=>Mo("Angle of the load where it begins to slip",s),until:([s])=>te(s,"slip_start")?.t??s.duration,answer:([s])=>{let e=te(s,"slip_start"),t=s.at(e.t).normal_force/
(s.mass*s.gravity);return{truth:e.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:Mn(e.
angle),share:`${M(100*t,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:s=>Mo("Angle of the load\
 where it takes off",s),until:([s])=>te(s,"takeoff")?.t??s.duration,answer:([s])=>{let e=te(s,"takeoff"),t=s.at(e.t-1e-6);return{truth:e.angle*180/Math.PI,text:"\
It takes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:Mn(e.angle),slip:M(Math.abs(t.slip),3)}}},why:"A rolling hoop would be braked by the \
plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at \
the top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does \
it do just after it has landed?",queries:[""],guess:s=>Nt([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim tu\
rns too fast."],["bounce","It bounces."]],s),until:([s])=>te(s,"impact")?.t??s.duration,answer:([s])=>{let[e,t]=[te(s,"takeoff"),te(s,"impact")],n=s.events.find(
o=>o.kind==="apex");return{truth:uu[s.at((t?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
values:{time:M((t?.t??0)-(e?.t??0),3),height:M(100*(n?.height??0),3),angle:Mn(t?.angle??0)}}},why:"An impact takes no time, but its friction is as strong as its\
 push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",title:"\
More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highest?",queries:[
"plane.mu=0.05","plane.mu=0.2",""],guess:s=>Nt([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],s),until:s=>.3+Math.max(0,...s.map(e=>te(e,"impact")?.t??0)),
answer:s=>{let e=s.map(i=>Math.max(0,...i.events.map(({kind:a,height:r})=>a==="apex"?r:0))),[t,n,o]=e.map(i=>M(100*i,3));return{truth:String(e.indexOf(Math.max(
...e))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:t,middle:n,high:o}}},why:"On ice nothing drives the ro\
tation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is braked on the\
 way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies w\
ith dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3","plan\
e.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:s=>Nt([["flight","It flies off."],["impact","An impact stops the sli\
de at once."],["both","Both agree with the laws."]],s),until:s=>Math.min(.8,...s.map(e=>e.duration)),answer:s=>({truth:s.every(e=>te(e,"painleve_indeterminate"))?
"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws have two an\
swers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"Your tur\
n",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from\
 the motion itself.",question:"",queries:[""]}];var Ya="hophoop-visit",Tn=class{constructor(e,t){this.lab=e;this.step=null;this.guess=null;this.films=[];this.points=new Map;this.running=!1;this.stop=null;this.
loop=null;this.asked=0;this.onchallenges=t,this.body=u("div",{class:"visit-body"}),this.said=u("div",{class:"visit-answer",role:"status"}),this.element=u("secti\
on",{class:"visit card","aria-label":"Guided visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){se(Ya)||(this.
element.hidden=!1,R(this.said,""),this.body.replaceChildren(u("div",{class:"buttons offer"},u("p",{},u("b",{},"New here?")," ","Eight short questions: guess, th\
en play."),u("button",{type:"button",class:"main",onclick:()=>this.start()},"Start the visit"),u("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){
this.points.clear(),this.go(0)}leave(){oe(Ya,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.mark("visit\
ing",!1),this.veil(),this.lab.show()}async go(e){let t=Ue[e],n=++this.asked;this.lab.opening.end();let{lab:o}=this;o.clock.play(!1),o.clock.time=0,this.step=t,this.
stop=null,this.guess=null,this.unwind(),R(this.said,""),this.element.hidden=!1,o.mark("visiting",e<Ue.length-1);try{let i=await Promise.all(t.queries.map(a=>o.backend.
film({query:a})));if(n!==this.asked)return;this.films=i.map(a=>new We(a)),o.motions.active=0,o.motions.set(i.slice(0,2)),this.guess=t.guess?.(()=>this.guessed())??
null,this.veil(),o.changed(),o.motions.note(),this.fill(e)}catch(i){o.notice.fail(i)}}veil(){this.lab.mark("guessing",this.guessing),this.guessing&&this.lab.stage.
element.setAttribute("aria-label",k("The hoop, before it is let go."))}fill(e){let t=Ue[e];this.play=u("button",{type:"button",class:"main",disabled:!!this.guess,
onclick:()=>this.show()},"Play"),this.running=!1,this.skip=u("button",{type:"button",hidden:!0,onclick:()=>this.stop!==null&&this.lab.clock.seek(this.stop)},"Sk\
ip to the answer");let n=e===Ue.length-1,o=u("h2",{tabindex:"-1"},t.title);this.next=u("button",{type:"button",onclick:()=>this.go(e+1)},"Next"),this.body.replaceChildren(
u("header",{},u("span",{class:"visit-count"},`Step ${e+1} of ${Ue.length}`),u("progress",{max:String(Ue.length),value:String(e+1),"aria-hidden":"true"}),u("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),o,u("p",{},t.text),t.question?u("p",{class:"visit-question"},t.
question):"",this.guess?.element??"",u("div",{class:"buttons"},e>0&&u("button",{type:"button",onclick:()=>this.go(e-1)},"Back"),this.guess&&this.play,this.guess&&
this.skip,n?u("button",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,n&&u("button",{type:"button",onclick:()=>this.leave()},
"Done"),this.guess&&u("span",{class:"hint visit-wait"},"First say what you expect, then play."))),n&&this.points.size&&this.total(),o.focus({preventScroll:!0})}guessed(){
this.play&&(this.play.disabled=!1);let e=this.body.querySelector(".visit-wait");e&&(e.hidden=!0)}show(){let{lab:e,step:t}=this;if(!(!t||!this.guess)){if(this.stop!==
null){e.clock.play();return}this.stop=t.until?.(e.films())??e.clock.duration,this.loop??=e.clock.loop,e.clock.loop=!1,e.clock.seek(0),e.clock.run({to:this.stop}),
this.frame()}}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:e}=this.lab;if(this.stop===null||(this.skip.hidden=!1,
this.running!==e.playing&&(this.running=e.playing,R(this.play,this.running?"Pause":"Play")),e.time<this.stop-1e-9))return;e.playing=!1;let t=this.stop;this.stop=
null,this.unwind(),e.seek(t),this.judge()}judge(){let{step:e,guess:t}=this;if(!e?.answer||!t)return;let{truth:n,text:o,values:i={}}=e.answer(this.films),a=t.judge(
n);this.points.set(e.key,a),this.play.hidden=this.skip.hidden=!0,this.said.replaceChildren(u("p",{},u("b",{},a?`${a} of 100 points.`:"Not so.")," ",nn(o,i)),u("\
p",{},e.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.scrollIntoView({block:"nearest"})}total(){let e=[...this.points.values()].
reduce((t,n)=>t+n,0);this.said.replaceChildren(u("p",{},`You have ${e} of ${100*this.points.size} points.`))}challenge(){this.leave(),this.onchallenges()}changed(){
this.guess?.redraw?.(),this.guessing&&this.veil()}};var Za=60,An=class{constructor(e){this.lab=e;this.words={t:k,untranslated:Qe};this.sound=new xn;let t=()=>e.film(),n=o=>e.load(o);this.grips=new fn(e),this.present=
new kn(e.root,()=>e.show()),this.challenges=new un({film:t,load:n,ahead:()=>e.stage.options.ahead}),this.visit=new Tn(e,()=>this.challenges.open()),this.table=new _n(
{film:t,clock:e.clock,names:()=>e.theme.colors.mode_names}),this.more=new vn(e),this.teach=Ka(n,()=>this.visit.start()),this.tools=this.makeTools(),this.menu=this.
makeMenu(),this.languages=po(()=>{this.spoken(),sn(e.root),e.show()}),this.spoken()}makeTools(){let{clock:e}=this.lab,t=(n,o,i)=>u("button",{type:"button",title:o,
"aria-label":o,"aria-pressed":"false",onclick:i},Y(n));return this.loop=t("loop","Repeat",()=>{e.loop=!e.loop,this.mark()}),this.slow=t("slow","Slow motion: a t\
enth of the speed",()=>{e.speed=e.speed===.1?1:.1,e.changed(),this.mark()}),this.loud=t("sound","Sound of the contact",()=>{this.sound.turn(!this.sound.on),this.
mark()}),this.large=t("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),this.mark(),u("div",{class:"butt\
ons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:e}=this.lab;this.loop.setAttribute("aria-pressed",String(e.loop)),this.slow.setAttribute(
"aria-pressed",String(e.speed===.1)),this.loud.setAttribute("aria-pressed",String(this.sound.on)),this.large.setAttribute("aria-pressed",String(this.present.on))}makeMenu(){
let e=(n,o)=>u("button",{type:"button",onclick:()=>{t.open=!1,o()}},n),t=u("details",{class:"learn"},u("summary",{class:"button"},"Learn"),u("div",{class:"menu-\
body"},e("Guided visit",()=>this.visit.start()),e("Challenges",()=>this.challenges.open()),e("What a little more would do",()=>this.more.turn(!0)),e("Table of t\
he motion",()=>this.table.open(!0)),e("Presentation",()=>this.present.turn(!0)),e("For teachers",()=>this.teach.showModal()),e("About hophoop",()=>this.lab.about.
showModal())));return t.addEventListener("keydown",n=>{n.key!=="Escape"||!t.open||(n.stopPropagation(),t.open=!1,t.querySelector("summary")?.focus())}),t}spoken(){
this.lab.root.lang=Pe(),this.lab.hosted&&(document.documentElement.lang=Pe(),this.titled())}titled(){let{lab:e}=this;if(!e.hosted)return;let t=this.visit.guessing?
[]:e.motions.films().map(o=>this.nameOf(o)),n=[...new Set(t)].join(" | ");document.title=n?`${n} – hophoop`:k("hophoop lab: play with the hopping hoop")}nameOf({
query:e,summary:t}){let n=this.lab.known.find(i=>i.query===e);if(n)return k(n.title);let[o]=t.split(/(?<=[.。])(?!\d)/u);return o.length<=Za?o.replace(/[.。]$/u,
""):`${o.slice(0,Za).replace(/[,，][^,，]*$/u,"")} …`}frame(){let{lab:e}=this;this.grips.draw(),this.sound.follow(e.film(),e.clock),this.table.cursor(e.clock.
time),this.more.frame(),this.visit.frame(),this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.more.changed(),this.challenges.changed(),
this.visit.changed(),this.titled()}close(){this.sound.close(),this.present.close()}};var Dt=(s,e,t)=>u("button",{type:"button",title:e,"aria-label":e,onclick:t},s),Ln=class{constructor(e,t,n,o){this.fresh=!1;let i=new Map;for(let r of e)i.set(r.
group,[...i.get(r.group)??[],r]);this.presets=u("select",{class:"presets","aria-label":"Examples",onchange:()=>{let r=e.find(({key:l})=>l===this.presets.value);
this.fresh=r!==void 0,r&&o.take(r)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},u("option",{value:""},"Examples …"),[...i].map(([r,l])=>u("o\
ptgroup",{label:r},l.map(({key:c,title:m})=>u("option",{value:c},m))))),this.undo=Dt(Y("undo"),"Undo (z)",o.undo),this.redo=Dt(Y("redo"),"Redo (y)",o.redo);let a=u(
"span",{},u("span",{class:"long"},"Compare"),u("span",{class:"short"},Y("two")));this.compare=Dt(a,"Compare two hoops",o.compare),this.compare.classList.add("fu\
ll"),this.right=u("div",{class:"buttons right"},t,Dt(Y("theme"),"Dark or light (d)",o.theme),Dt("?","Keys and help (?)",o.help)),this.element=u("header",{class:"\
top"},u("h1",{},u("span",{class:"logo","aria-hidden":"true"}),u("span",{},"hophoop",u("span",{class:"long"}," lab"))),this.presets,u("div",{class:"buttons"},this.
undo,this.redo,this.compare,n),this.right)}show(e,t){this.undo.disabled=!e.past.length,this.redo.disabled=!e.future.length,this.compare.setAttribute("aria-press\
ed",String(t))}};var du=["pointerdown","wheel"],Rn=class{constructor(e,t){this.clock=e;this.hint=t;this.touches=new AbortController}begin(e){let{signal:t}=this.touches,n=()=>this.
end();for(let o of du)e.addEventListener(o,n,{signal:t,capture:!0,passive:!0});addEventListener("keydown",n,{signal:t,capture:!0}),this.hint.hidden=!1,this.clock.
run({once:!0})}end(){this.hint.hidden=!0,this.touches.abort()}};var Qa="hophoop-view",mu=new Set(["start.speed","hoop.load_fraction","plane.mu","duration"]),Xa=({query:s})=>[...new URLSearchParams(s).keys()].some(e=>!mu.has(
e)),Pn=class{constructor(e,t,n){this.root=e;this.hosted=t;this.changed=n;this.simple=!1;this.button=u("button",{type:"button",class:"view",hidden:!t,onclick:()=>this.
choose()}),this.more=u("p",{class:"hint beyond",hidden:!0},"This motion has other settings too. ",u("button",{type:"button",class:"link",onclick:()=>this.choose()},
"Show everything"))}get everything(){return se(Qa)==="everything"}open(e,{map:t,more:n,fingerprints:o}){let i=e.length>1||t||n||o?.some(Boolean)||e.some(Xa);this.
turn(this.hosted&&!this.everything&&!i)}choose(){this.turn(!this.simple),oe(Qa,this.simple?"simple":"everything"),this.changed(),this.button.focus({preventScroll:!0})}turn(e){
this.simple=e,this.root.classList.toggle("simple",e),R(this.button,e?"Everything":"Simple view");for(let t of this.root.querySelectorAll("details.group"))e?(t.dataset.
open=String(t.open),t.open=!0):t.dataset.open&&(t.open=t.dataset.open==="true")}show(e){this.more.hidden=!this.simple||!e.some(Xa)}};var Cn=class{constructor(e){this.tabs=["A","B"].map((t,n)=>u("button",{type:"button","aria-pressed":"false",onclick:()=>e(n)},`Hoop ${t}`)),this.bar=u("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=u("p",{class:"preset-text"}),this.element=u("div",{class:"lanes"},
this.bar,this.text)}show(e,t){this.bar.hidden=e<2;for(let[n,o]of this.tabs.entries())o.setAttribute("aria-pressed",String(n===t))}};var er="hophoop-single-keys",pu=(s,e)=>({" ":()=>s.clock.play(),ArrowLeft:()=>e?s.transport.jump(-1):s.transport.nudge(-1),ArrowRight:()=>e?s.transport.jump(1):
s.transport.nudge(1),Home:()=>s.clock.seek(0),End:()=>s.clock.seek(s.clock.duration),h:()=>s.transport.jump(1,"takeoff"),l:()=>s.transport.jump(1,"impact"),"[":()=>s.
clock.faster(-1),"]":()=>s.clock.faster(1),t:()=>s.toggle("traces"),f:()=>s.toggle("forces"),c:()=>s.toggle("speed"),a:()=>s.extras.more.turn(),w:()=>s.toggle("\
whole"),3:()=>s.toggle("three"),"+":()=>s.stage.zoom(1.25),"=":()=>s.stage.zoom(1.25),"-":()=>s.stage.zoom(.8),0:()=>s.stage.zoom(0),z:()=>s.travel(-1),y:()=>s.
travel(1),d:()=>s.theme.toggle(),p:()=>s.share.code(),"?":()=>s.help.showModal()});function fu(s,e){let t=e.key.toLowerCase();e.altKey||!(t==="z"||t==="y")||(e.
preventDefault(),s.travel(t==="y"||e.shiftKey?1:-1))}function gu(s){let e=s.share.menu;e.open&&(e.open=!1,e.querySelector("summary")?.focus())}var zn=class{constructor(e){
this.on=!e||se(er)!=="off";let t=u("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=t.checked,e&&oe(er,this.on?"on":"off")}});this.element=u("labe\
l",{class:"check"},t,"Single keys (letters, digits, signs) do what the table says")}};function bu(s,e){let t=e.target;if(s.root.querySelector("dialog[open]"))return;
if(e.key==="Escape"){gu(s);return}if(t.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(e.ctrlKey||e.metaKey){fu(s,e);return}if(e.altKey||
t.matches?.("select")&&!(e.key===" "&&s.header.fresh)||t.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(e.key)||e.key===" "&&t.matches?.("button,\
 summary, input[type=checkbox]")||!s.singleKeys.on&&e.key!==" "&&e.key.length===1)return;let o=pu(s,e.shiftKey)[e.key];o&&(e.preventDefault(),o())}function tr(s,e){
let t=e?document:s.root,n=o=>{bu(s,o),e||o.stopPropagation()};return t.addEventListener("keydown",n),()=>t.removeEventListener("keydown",n)}function nr(s,e){let t=u("div",{class:"edge","aria-hidden":"true"}),n=new IntersectionObserver(([o])=>{let i=!o.isIntersecting&&o.boundingClientRect.top<0;if(i===
s.classList.contains("stuck"))return;let a=s.offsetHeight;s.style.marginBottom="",s.classList.toggle("stuck",i),i&&(s.style.marginBottom=`${a-s.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=i?`${s.offsetHeight}px`:"",e()});return n.observe(t),{edge:t,close:()=>n.disconnect()}}function sr(s,e){s.classList.add("hophoop"),s.dir="ltr",!e&&(s.classList.add("embedded"),s.dataset.lmSuppressShortcuts="true",s.dataset.pSuppressShortcuts="true")}
function or(s,e){let{root:t,notice:n,hosted:o,extras:i,transport:a,header:r}=s,l=g=>!e||e.includes(g),c=[i.visit.element,i.challenges.element],m=u("aside",{class:"\
side","aria-label":"Parameters"},...c,s.hoops.element,n.message,s.controls.element,s.view.more);a.row.append(i.more.switch),a.row.before(i.tools),r.right.prepend(
i.menu,i.languages);let h=u("div",{class:"player"},i.grips.element,s.stage.element,s.timeline.element,a.element),d=o?nr(h,()=>s.request()):null,p=u("div",{class:"\
middle"},d?.edge,!l("controls")&&c,h,i.more.element,i.table.element,u("div",{class:"words"},s.story.element,l("theory")&&s.theory.element),l("map")&&s.map.element),
f=u("div",{class:"why"},l("plots")&&s.plots.element,l("plots")&&s.phase.element);return t.replaceChildren(u("div",{class:"page"},o&&wu(s.timeline.element),r.element,
u("div",{class:"columns"},l("controls")&&m,p,f)),n.toast,s.share.dialog,s.help,s.about,i.teach),t.addEventListener("pointerdown",({target:g})=>{for(let b of[s.share.
menu,i.menu])b.contains(g)||(b.open=!1)}),t.classList.toggle("no-controls",!l("controls")),d}function wu(s){s.id="hh-player";let e=u("a",{class:"skip button",href:"\
#hh-player"},"Skip to the player");return e.onclick=t=>{t.preventDefault(),s.focus()},e}function nt(s,e,{left:t,top:n,box:o},{across:i,up:a,lines:r=!1,middle:l=!1}){let c=n+o.height,m=t+o.width;s.save(),s.font=`11px ${e.font}`,s.strokeStyle=r?e.line:
e.soft,s.fillStyle=e.soft,s.lineWidth=1,r||s.strokeRect(t+.5,n+.5,o.width-1,o.height-1),s.textAlign="right",s.textBaseline="middle";for(let{at:h,text:d,strong:p}of a.
marks)r&&(s.globalAlpha=p?1:.55,ir(s,[t,Math.round(h)+.5],[m,Math.round(h)+.5]),s.globalAlpha=1),s.fillText(d,t-6,h);s.textBaseline="alphabetic",s.textAlign="ce\
nter";for(let{at:h,text:d}of i.marks)ir(s,[h,c],[h,c+4]),s.fillText(d,h,c+15);l?s.fillText(i.name,t+.5*o.width,c+30):(s.textAlign="right",s.fillText(i.name,m,c+
27)),s.translate(11,n+.5*o.height),s.rotate(-Math.PI/2),s.textAlign="center",s.fillText(a.name,0,0),s.restore()}function ir(s,e,t){s.beginPath(),s.moveTo(...e),
s.lineTo(...t),s.stroke()}var ar=(s,e)=>e?`${k(s)} [${e}]`:k(s);var[rr,yu]=[62,92],vu=12,Ot=10,ku=36,lr=Math.PI/180,ke=["x","y"],Nn=class{constructor(e){this.paths={x:"start.speed",y:"plane.mu"};this.known=new Map(e.map(t=>[
t.path,t])),this.windows={x:this.whole("x"),y:this.whole("y")},this.left=rr}info(e){return this.known.get(this.paths[e])}whole(e){return[...this.info(e).range]}home(){
for(let e of ke)this.windows[e]=this.whole(e)}choose(e,t){let n=e==="x"?"y":"x";this.paths[n]===t&&(this.paths[n]=this.paths[e]),this.paths[e]=t,this.home()}asked(e,t){
let[n,o]=this.windows[e];return{path:this.paths[e],from:n,to:o,cells:t}}bounds(e){let{range:t,allowed:n}=this.info(e),o=2*(t[1]-t[0]);return[Math.max(n[0],t[0]-
o),Math.min(n[1],t[1]+o)]}zoom(e,t){let n={x:[],y:[]};for(let o of ke){let[i,a]=this.windows[o],r=t?.[o]??.5*(i+a);n[o]=Ke([r-(r-i)*e,r+(a-r)*e],this.bounds(o));
let l=Math.max(Math.abs(n[o][0]),Math.abs(n[o][1]),1e-9);if(n[o][1]-n[o][0]<400*Number.EPSILON*l)return!1}return ke.every(o=>n[o].every((i,a)=>i===this.windows[o][a]))?
!1:(this.windows=n,!0)}drag(e,t,n){let o=(i,a)=>Ke(e[i].map(r=>r+a*(e[i][1]-e[i][0])),this.bounds(i));this.windows={x:o("x",-t/this.box.width),y:o("y",n/this.box.
height)}}restore(e){if(!ke.every(t=>this.known.has(e[t][0]))||e.x[0]===e.y[0])return!1;for(let t of ke)this.paths[t]=e[t][0];for(let t of ke)this.windows[t]=Ke(
e[t].slice(1).map(Number),this.bounds(t));return!0}isHome(){return ke.every(e=>this.windows[e].every((t,n)=>t===this.whole(e)[n]))}middle(){let{x:e,y:t}=this.windows;
return{x:.5*(e[0]+e[1]),y:.5*(t[0]+t[1])}}fit(e,t){this.left=this.deep("y")?yu:rr,this.box={width:e-this.left-vu,height:t-Ot-ku}}clip(e){e.beginPath(),e.rect(this.
left,Ot,this.box.width,this.box.height),e.clip()}x(e){let[t,n]=this.windows.x;return this.left+(e-t)/(n-t)*this.box.width}y(e){let[t,n]=this.windows.y;return Ot+
(1-(e-t)/(n-t))*this.box.height}place(e,t){let n=([o,i],a)=>o+_(a,0,1)*(i-o);return{x:n(this.windows.x,(e-this.left)/this.box.width),y:n(this.windows.y,1-(t-Ot)/
this.box.height)}}deep(e){let[t,n]=this.windows[e];return n-t<5e-5*Math.max(Math.abs(t),Math.abs(n))}said(e){let t=n=>{let o=this.info(n),[i,a]=this.windows[n],
r=Math.max(Math.abs(i),Math.abs(a)),l=_(Math.ceil(Math.log10(r/(a-i)))+4,4,16);return`${k(o.label)} = ${I(M(o.degrees?e[n]/lr:e[n],l),o.unit)}`};return`${t("x")}\
, ${t("y")}`}draw(e,t){let{left:n,box:o}=this,[i,a]=[this.axis("x",o.width/80),this.axis("y",o.height/40)];nt(e,t,{left:n,top:Ot,box:o},{across:i,up:a,middle:!0})}axis(e,t){
let n=this.info(e),o=n.degrees?1/lr:1,[i,a]=this.windows[e].map(d=>d*o),r=V(a-i,t),l=this.deep(e),c=l?Number((.5*(i+a)).toPrecision(12)):0,m=l?he(i-c,a-c,t).map(
d=>d+c):he(i,a,t),h=l?` − ${String(c).replace("-","−")}`:"";return{marks:m.map(d=>({at:this[e](d/o),text:l?M(d-c,3):ae(d,r)})),name:`${k(n.label)}${h}${n.unit?
` [${n.unit}]`:""}`}}};function Ke([s,e],[t,n]){let o=Math.min(e-s,n-t);return s<t?[t,t+o]:e>n?[n-o,n]:[s,e]}function So(s,e,t,n,o){for(let[i,a]of[[o,4],[n,1.8]])
s.strokeStyle=i,s.lineWidth=a,s.beginPath(),s.arc(e,t,7,0,2*Math.PI),s.moveTo(e-13,t),s.lineTo(e-4,t),s.moveTo(e+4,t),s.lineTo(e+13,t),s.moveTo(e,t-13),s.lineTo(
e,t-4),s.moveTo(e,t+4),s.lineTo(e,t+13),s.stroke()}var st=s=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${s&&`; ${s}`}; double-click for all`,xu=.0018,hr=200,
[_u,Eu]=[1/.6,1/1.7];function re(s,{zoom:e,home:t,chosen:n=()=>s,keys:o=!1}){return s.addEventListener("wheel",i=>{(i.ctrlKey||i.metaKey||Tt(n()))&&(i.preventDefault(),
e(Math.exp(-Math.min(Math.max(i.deltaY,-hr),hr)*xu),i))},{passive:!1}),s.addEventListener("dblclick",t),o&&s.addEventListener("keydown",i=>{if(i.key==="+"||i.key===
"=")e(_u);else if(i.key==="-")e(Eu);else if(i.key==="0")t();else if(i.key==="Escape")s.blur();else return;i.preventDefault(),i.stopPropagation()}),xa(s,e)}var cr={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},ur=48;function dr(s){let{body:e}=s,t=!1,n=re(e,{zoom:(o,i)=>s.axes.box&&s.zoom(1/o,i?To(
s,i):s.aim()),home:()=>s.home(),keys:!0});e.addEventListener("pointerdown",o=>Su(s,o,n,i=>t=i)),e.addEventListener("pointermove",o=>{s.axes.box&&!t&&o.pointerType!==
"touch"&&Mu(s,o)}),e.addEventListener("pointerleave",()=>s.tip.hidden=!0),e.addEventListener("keydown",o=>Tu(s,o))}function To(s,e){let t=s.body.getBoundingClientRect(),
{px:n}=s.look;return s.axes.place((e.clientX-t.left)/n,(e.clientY-t.top)/n)}function Mu(s,e){s.tip.textContent=s.said(To(s,e)),s.tip.hidden=!1;let t=s.body.getBoundingClientRect();
s.tip.style.left=`${_(e.clientX-t.left,150,Math.max(t.width-150,150))}px`,s.tip.style.bottom=`${t.bottom-e.clientY+16}px`}function Su(s,e,t,n){e.preventDefault(),
s.body.focus({preventScroll:!0});let o=[e.clientX,e.clientY],i={x:[...s.axes.windows.x],y:[...s.axes.windows.y]};s.pointed=To(s,e);let a=!1,r=!1,l=t(),c=m=>{if(l||=
t(),l)return;let[h,d]=[m.clientX-o[0],m.clientY-o[1]];r||Math.hypot(h,d)<5&&!a||(r=!a&&e.pointerType==="touch"&&Math.abs(d)>=Math.abs(h),!r&&(a=!0,n(!0),s.tip.hidden=
!0,s.axes.drag(i,h/s.look.px,d/s.look.px),s.redraw(),s.soon()))};J(s.body,e,c,(m,h)=>{h&&!a&&!r&&!l&&s.pointed&&s.take(s.pointed),n(!1)})}function Tu(s,e){let t=s.
pointed??s.here()??s.axes.middle();if(s.pointed=t,cr[e.key]){let[n,o]=cr[e.key],{x:i,y:a}=s.axes.windows;s.pointed={x:_(t.x+n*(i[1]-i[0])/ur,i[0],i[1]),y:_(t.y+
o*(a[1]-a[0])/ur,a[0],a[1])},s.state.textContent=s.said(s.pointed),s.say(s.said(s.pointed))}else if(e.key==="Enter")s.take(t);else return;e.preventDefault(),e.stopPropagation(),
s.redraw()}var Au=["start.height","start.vx","start.vy","start.omega"];function mr(s,e){let t="speed"in s.start;return!t&&e.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":t&&e.some(n=>Au.includes(n))?"of starts in any state, though this motion starts rolling":""}var Lu=Math.PI/180,Ru=12,Pu=["hop_height","flight_time","energy_lost","greatest_utilization"];function pr(s){return s.unit==="rad"?[1/Lu,"°"]:[1,s.unit==="1"?"":
s.unit]}function Cu({classes:s,what:e},t){let[n,o]=[1/0,-1/0];if(s)return[n,o];for(let i of t)i<n&&(n=i),i>o&&(o=i);return[Pu.includes(e)?Math.min(n,0):n,o]}function fr(s){
let{values:e}=s.arrays,t=s.header,{x:n,y:o,classes:i}=t,a=new ImageData(n.cells,o.cells),[r,l]=Cu(t,e),c=i?.map(({color:h})=>Me(h));for(let h=0;h<o.cells;h++)for(let d=0;d<
n.cells;d++){let p=e[h*n.cells+d],f=4*((o.cells-1-h)*n.cells+d);if(!Number.isFinite(p))continue;let g=c&&(d+1<n.cells&&e[h*n.cells+d+1]!==p||h+1<o.cells&&e[(h+1)*
n.cells+d]!==p),b=c?c[p].map(w=>g?.72*w:w):Ze[_(Math.round(255*(p-r)/(l-r||1)),0,255)];a.data.set([...b,255],f)}let m=u("canvas",{width:n.cells,height:o.cells});
return we(m).putImageData(a,0,0),{picture:m,header:t,values:e,x:[n.from,n.to],y:[o.from,o.to],low:r,high:l}}function gr(s,e){let t=(o,i)=>o[0]>=i[0]-1e-300&&o[1]<=
i[1]+1e-300;return[...s.filter(o=>!(t(o.x,e.x)&&t(o.y,e.y))),e].slice(-Ru)}function br({header:s,low:e,high:t,values:n}){let{classes:o}=s;if(!o){let r=u("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=we(r);for(let h=0;h<120;h++)l.fillStyle=`rgb(${Ze[Math.floor(255*h/119)].join(",")})`,l.fillRect(h,0,1,
10);let[c,m]=pr(s);return[u("span",{},s.label,": ",t>=e?M(e*c,3):"none"," "),r,u("span",{},t>=e?I(M(t*c,3),m):""),n.some(h=>!Number.isFinite(h))?u("span",{},u("\
i",{class:"blank"}),"none"):""]}let i=new Map;for(let r of n)i.set(r,(i.get(r)??0)+1);let a=[...i].filter(([r])=>r>=0).sort((r,l)=>l[1]-r[1]);return[...a.slice(
0,10).map(([r])=>{let{color:l,text:c}=o[r];return u("span",{},u("i",{style:`background:${l}`,"aria-hidden":"true"}),c)}),a.length>10?u("span",{},`and ${a.length-
10} more`):""]}function wr(s,e){for(let{header:t,values:n}of[...s].reverse()){let{x:o,y:i,classes:a}=t,r=Math.floor((e.x-o.from)/(o.to-o.from)*o.cells),l=Math.floor(
(e.y-i.from)/(i.to-i.from)*i.cells);if(r<0||l<0||r>=o.cells||l>=i.cells)continue;let c=n[l*o.cells+r];if(a)return k(a[c]?.text??"not allowed");let[m,h]=pr(t);return Number.
isFinite(c)?I(M(c*m,4),h):k("none")}return"…"}var yr=[[24,16],[72,48],[216,144]],Dn=class{constructor(e,t,{take:n,say:o,changed:i}){this.backend=e;this.pointed=null;this.what="sequence";this.layers=[];this.
seen=!1;this.onmotion=n,this.say=o,this.changed=i;let a=t.controls.map_axes;this.axes=new Nn(a),this.canvas=u("canvas",{class:"plot-canvas"}),this.tip=u("div",{
class:"tip",hidden:!0}),this.body=u("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow keys move the mark, Enter takes \
the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=u("div",{class:"map-keys"}),this.state=u("span",{class:"hint"});let r=l=>{let c=u("select",{"\
data-axis":l,onchange:()=>this.setAxis(l,c.value)},a.map(({path:m,label:h})=>u("option",{value:m},h)));return c};this.selects={x:r("x"),y:r("y")},this.quantity=
u("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},t.map_quantities.map(([l,c])=>u("option",{value:l},c))),
this.element=u("section",{class:"map","aria-label":"Map of motions"},u("div",{class:"map-head"},u("h2",{},"Map"),u("label",{},"of",this.quantity),u("label",{},"\
Across",this.selects.x),u("label",{},"Up",this.selects.y),u("span",{class:"buttons"},u("button",{type:"button","aria-label":"Zoom into the map",onclick:()=>this.
zoom(.5,this.aim())},"+"),u("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2,this.aim())},"−"),u("button",{type:"button",onclick:()=>this.
home()},"Whole map")),this.state),this.body,this.keys,u("p",{class:"hint"},`Click to take that motion into the player; ${st("drag to move")}.`)),dr(this),this.soon=
ie(()=>this.refresh(),140),this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.refresh()}),this.watch.observe(this.
body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let e of ke)this.selects[e].value=this.axes.paths[e]}setAxis(e,t){
this.axes.choose(e,t),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(e){let t=structuredClone(e);for(let n of Object.values(this.
axes.paths)){let[o,i]=n.split(".");t[o]&&delete t[o][i]}return JSON.stringify(t)}mark(e,t){this.film=e,this.look=t;let n=this.key_of(e.scenario);n!==this.key_now&&
(this.key_now=n,this.soon()),this.redraw()}shown(){let{paths:e,windows:t}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&e.x==="start.speed"&&e.y==="p\
lane.mu")return;let n=o=>[e[o],...t[o]];return{what:this.what,x:n("x"),y:n("y")}}restore(e){![...this.quantity.options].some(({value:t})=>t===e.what)||!this.axes.
restore(e)||(this.quantity.value=this.what=e.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.stale=!0;return}this.
stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked,t=this.film.scenario,n=t.contact.model==="rigid"?[]:[["contact.model","rigi\
d"]];this.computing=!0;let o=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;o!==this.kind&&(this.layers=[]),this.kind=o,this.redraw();
try{for(let[i,a]of yr){R(this.state,`computing ${i*a} motions …`);let r={x:this.axes.asked("x",i),y:this.axes.asked("y",a)},l={scenario:t,changes:n,...r,what:this.
what},c=await this.backend.map(l,e),m=fr(c);this.layers=gr(this.layers,m),this.keys.replaceChildren(...br(m));let h=mr(t,Object.values(this.axes.paths)),d=k(n.length?
"{count} motions, with rigid contact":"{count} motions",{count:i*a});R(this.state,h?`${d}; ${k(h)}`:d),this.redraw()}this.level=yr.length}catch(i){let{name:a,message:r}=i;
if(a==="AbortError")return;R(this.state,r)}this.computing=!1}redraw(){if(!this.film)return;let{look:e}=this,{context:t,width:n,height:o}=K(this.canvas,e.px);this.
axes.fit(n,o),t.clearRect(0,0,n,o),t.save(),this.axes.clip(t),t.imageSmoothingEnabled=!1;let{axes:i}=this;for(let r of this.layers){let[l,c]=r.x.map(d=>i.x(d)),
[m,h]=r.y.map(d=>i.y(d));t.drawImage(r.picture,l,h,c-l,m-h)}let a=this.here();a&&So(t,i.x(a.x),i.y(a.y),e.ink,e.paper),this.pointed&&Tt(this.body)&&So(t,i.x(this.
pointed.x),i.y(this.pointed.y),"#D55E00",e.paper),t.restore(),i.draw(t,e)}aim(){let e=Tt(this.body)&&this.pointed||this.here(),{windows:t}=this.axes;return e&&ke.
every(o=>e[o]>=t[o][0]&&e[o]<=t[o][1])?e:void 0}here(){let e=n=>{let[o,i]=n.split(".");return this.film.values[n]??this.film.scenario[o]?.[i]},t={x:e(this.axes.
paths.x),y:e(this.axes.paths.y)};return typeof t.x=="number"&&typeof t.y=="number"?t:null}said(e){return`${this.axes.said(e)}: ${wr(this.layers,e)}`}take(e){this.
onmotion([[this.axes.paths.x,e.x],[this.axes.paths.y,e.y]])}zoom(e,t){this.tip.hidden=!0,this.axes.zoom(e,t)&&(this.redraw(),this.soon())}};var On=class{constructor(){this.past=[];this.future=[];this.now=null;this.what="";this.when=-1/0}note(e,t="",n=performance.now()){let o=this.now;if(this.now=e,o===
null||It(o,e))return"same";let i=t!==""&&t===this.what&&n-this.when<1e3&&this.past.length>0;return this.what=t,this.when=n,this.future=[],i?"again":(this.past.push(
o),this.past.length>500&&this.past.shift(),"step")}touch(e,t){e===this.what&&t-this.when<1e3&&(this.when=t)}written(){return JSON.stringify({past:this.past.slice(
-100),now:this.now,future:this.future.slice(-100)})}restore(e){if(!e||!this.now)return;let{past:t,now:n,future:o}=JSON.parse(e);n&&It(n,this.now)&&Object.assign(
this,{past:t,future:o})}holds(e){return this.now!==null&&It(this.now,e)}next(e){return(e<0?this.past:this.future).at(-1)??null}step(e){let[t,n]=e<0?[this.past,this.
future]:[this.future,this.past],o=t.pop();!o||!this.now||(n.push(this.now),this.now=o,this.what="")}arrive(e){if(!(this.now&&It(this.now,e))){for(let t of[-1,1]){
let n=t<0?this.past:this.future,o=n.length-n.findLastIndex(i=>It(i,e));if(!(o>n.length)){for(let i=0;i<o;i++)this.step(t);return}}Object.assign(this,{past:[],future:[],
now:e,what:""})}}},It=(s,e)=>JSON.stringify(s)===JSON.stringify(e);var zu=1e-6,In=class{constructor(e,t){this.backend=e;this.listener=t;this.history=new On;this.lanes=[];this.active=0;this.going=Promise.resolve()}film(e=this.active){
return this.lanes[e].film}films(){return this.lanes.map(e=>e.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([e])=>e))}name(){return this.
lanes.length>1?"AB"[this.active]:""}filmOf(e){let t=new We(e);return(e.exact||e.samples?null:this.backend.exact(t.scenario))?.then(o=>{Object.assign(t,o,{latest:null}),
this.listener.refined()}).catch(()=>{}),t}set(e){this.lanes=e.map(t=>({film:this.filmOf(t)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(e){
this.set(await Promise.all(e.map(t=>this.backend.film({query:t}))))}change(e,t){let n=this.lanes[this.active];n.moved=performance.now(),n.since??=n.moved,n.pending=
[...(n.pending??[]).filter(([o])=>!e.some(([i])=>i===o)),...e],n.commit||=t,n.what=e.map(([o])=>o).join(),t&&this.history.touch(n.what,n.moved),this.pump(n)}async pump(e){
if(e.busy||!this.lanes.includes(e))return;if(!e.pending){e.commit&&this.settle(e);return}let t=e.pending,{since:n}=e;e.pending=null,e.since=null,e.busy=!0;try{e.
film=new We(await this.backend.film({scenario:e.film.scenario,changes:t})),this.lanes.includes(e)&&this.listener.shown(n)}catch(o){this.lanes.includes(e)&&this.
listener.failed(o,t)}finally{e.busy=!1}this.pump(e)}refine(e,t){for(let n of this.lanes){let{film:o}=n;if(n.refining||n.coarse===o)continue;let i=o.wanted(e,t),
a=!i&&t===0&&!o.moment(e).sure;!i&&!a||(n.refining=!0,this.samples(o,i??[e,e+zu]).then(r=>{i?o.refine(r):o.pin(r,e),this.listener.refined()}).catch(()=>{n.coarse=
o}).finally(()=>{n.refining=!1}))}}async samples(e,t){return e.samples?e.samples(t):this.backend.samples(e.scenario,t)}settle(e){e.commit=!1,this.note(e.what,e.
moved),this.listener.settled()}queries(){return this.films().map(e=>e.query)}note(e,t){this.listener.noted(this.history.note(this.queries(),e,t))}replace(e){this.
lanes[this.active]={film:this.filmOf(e)},this.listener.shown(),this.note()}travel(e){return this.inTurn(async()=>{let t=this.history.next(e);t&&(await this.load(
t),this.history.step(e),await this.listener.travelled(e),this.listener.shown(),this.listener.noted("travelled"))})}arrive(e){return this.inTurn(async()=>{await this.
load(e),this.history.arrive(this.queries()),this.listener.shown(),this.listener.noted("travelled")})}inTurn(e){return this.going=this.going.then(e).then(()=>!0,
t=>(this.listener.failed(t),!1)),this.going}compare(){this.lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.
active,1),this.active=0),this.listener.shown(),this.note()}choose(e){this.active=e,this.listener.shown(),this.listener.noted("same")}link(e=""){let n=[this.lanes.
length>1?`with=${encodeURIComponent(this.film(1).query)}`:"",e].filter(Boolean).join("&");return this.backend.link(this.film(0).query,n&&`#${n}`)}};var Nu=6e3,qn=class{constructor(){this.message=u("p",{class:"message",role:"alert",hidden:!0});this.toast=u("div",{class:"toast",role:"status",hidden:!0});this.
timer=0}fail(e,t=""){let n=[e.message,...t?[" ",t]:[]].map(St);this.message.replaceChildren(...n),this.message.hidden=!1,this.seen()||this.say(e.message,this.message.
isConnected)}seen(){let{top:e,bottom:t,height:n}=this.message.getBoundingClientRect();return this.message.isConnected&&n>0&&e>=0&&t<=innerHeight}clear(){this.message.
hidden=!0}say(e,t=!1){this.toast.setAttribute("role",t?"presentation":"status"),R(this.toast,e),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(
()=>{this.toast.hidden=!0},Nu)}};var q=52,Fn=10,z=8,Hn=30;function vr(s,e){if(!s.length)return[0,1];let t=Float64Array.from(s).sort(),[n,o]=[t[0],t[t.length-1]],[i,a]=[t[Math.floor(.02*t.length)],
t[Math.ceil(.98*t.length)-1]],r=Math.max(a-i,1e-12);o>a+4*r&&(o=a+.6*r),n<i-4*r&&(n=i-.6*r),n=Math.min(n,0),o=Math.max(o,0),e&&([n,o]=[-Math.max(-n,o),Math.max(
-n,o)]);let l=.06*(o-n)||1;return[n<0?n-l:n,o+l]}function kr(s,e){let{look:t,box:n,heights:o,range:i}=e,a=Math.max(n.height/28,4);for(;he(o[0],o[1],a).length<3&&
a<12;)a+=1;let r=V(o[1]-o[0],a),l=n.width/70,c=V(i[1]-i[0],l),{name:m,unit:h}=U[e.shared.axis];nt(s,t,{left:q,top:z,box:n},{up:{marks:he(o[0],o[1],a).map(d=>({at:e.
y(d),text:ae(d,r),strong:Math.abs(d)<1e-9*r})),name:k(e.unit)},across:{marks:he(i[0],i[1],l).map(d=>({at:e.x(d),text:ae(d,c)})),name:ar(m,h)},lines:!0})}var{letters:Du}=S.words;function xr(s,e,t){let n=s.length/e,o=u("canvas",{width:e,height:n}),i=new ImageData(e,n);for(let a=0;a<n;a++)for(let r=0;r<e;r++){let l=Du[s[a*
e+r]],c=Me(t[l]??"#6E6E6E"),m=4*((n-1-a)*e+r);i.data.set([...c,255],m)}return we(o).putImageData(i,0,0),o}var Ou=2;function _r(s,e,t){let n=t.length/2,[o,i,a]=[
z,_(e.y(0),z,z+e.box.height),z+e.box.height];s.strokeStyle=vt(e.look.dark?"#ffffff":"#000000",.28),s.lineWidth=1;for(let[r,l,c]of[[0,i,a],[n,o,i]])for(let m=0;m<
n;m++){let h=t[r+m];if(!h)continue;let d=m;for(;d<n&&t[r+d]===h;)d++;let p=e.x(m*2*Math.PI/n),f=e.x(d*2*Math.PI/n);s.save(),s.beginPath(),s.rect(p,l,f-p,c-l),s.
clip(),s.beginPath();let{height:g}=e.box;for(let b=-g;b<f-p+g;b+=7)for(let w of h===Ou?[!0,!1]:[h>0])s.moveTo(p+b,w?a:o),s.lineTo(p+b+g,w?o:a);s.stroke(),s.restore(),
m=d}}function Er(s,e){let{look:t,box:n}=e,[o,i]=e.range.map(c=>c*180/Math.PI),a=i-o>200?45:V(i-o,6),r=[];for(let c=Math.ceil(o/a-1e-9);c*a<=i+1e-9;c++)r.push(c*
a);let l=V(e.top()-e.bottom(),5);nt(s,t,{left:q,top:z,box:n},{across:{marks:r.map(c=>({at:e.x(c*Math.PI/180),text:ae(c,a)})),name:k("angle θ within a turn [°]")},
up:{marks:he(e.bottom(),e.top(),5).map(c=>({at:e.y(c),text:ae(c,l)})),name:"θ̇ [rad/s]"}})}var jn={solid:[],dash:[6,4],dot:[2,3],long:[14,4],mixed:[8,3,2,3]};function Bn(s,e="solid"){let t=u("i",{class:"swatch","aria-hidden":"true"});if(t.style.borderTopColor=
s??"var(--ink)",t.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted",long:"none",mixed:"none"}[e],e==="long"||e==="mixed"){let n=0,o=jn[e].map((i,a)=>(n+=
i,`${a%2?"transparent":s??"var(--ink)"} ${n-i}px ${n}px`));t.style.height="2.5px",t.style.width="28px",t.style.background=`repeating-linear-gradient(90deg, ${o.
join(", ")})`}return t}var $n=class{constructor(e,t,n){this.backend=e;this.clock=t;this.colors=n;this.canvas=u("canvas",{class:"plot-canvas"});this.over=u("canvas",{class:"plot-canvas\
 plot-over"});this.keys=u("div",{class:"plot-keys"});this.hatched=u("span",{hidden:!0},"Hatched: slip that meets Painlevé’s paradox."," ");this.asked="";this.
body=u("div",{class:"plot-body",role:"figure",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and flight"},this.
canvas,this.over),this.element=u("section",{class:"phase"},u("header",{},u("h3",{},"Plane of θ and θ̇"),this.keys),this.body,u("p",{class:"hint"},"Colours: t\
he mode that follows contact without slip."," ",this.hatched,`Click to go there; ${st("")}.`)),this.body.addEventListener("pointerdown",o=>this.seek(o)),this.pinched=
re(this.body,{zoom:(o,i)=>this.box&&this.zoomAbout(i?this.point(i):this.middle(),1/o),home:()=>this.home(),keys:!0}),this.range=[0,2*Math.PI],this.soon=ie(()=>this.
sharpen(),140)}async fetch(e,t){let n=this.reach(),o=JSON.stringify([e.hoop,e.plane,n]);if(o!==this.asked){let i=await this.painted(e,[0,2*Math.PI,-n,n],t);this.
asked=o,this.pictures=[i],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(this.sharpening?.abort(),!(!this.pictures||this.isWhole())){this.sharpening=
new AbortController;try{let e=await this.painted(this.films[this.active].scenario,[...this.range,this.bottom(),this.top()],this.sharpening.signal);this.pictures=
[this.pictures[0],e],this.redraw()}catch(e){if(e.name!=="AbortError")throw e}}}async painted(e,t,n){let{modes:o,paradox:i}=await this.backend.regions(e,t,n);return n?.
throwIfAborted(),{window:t,paradox:i,picture:xr(o,i.length/2,this.colors.modes)}}reach(){return this.reached}findReach(){let e=0;for(let n of this.films??[]){let o=Float64Array.
from(n.columns.omega,Math.abs).filter(Number.isFinite).sort();e=Math.max(e,o[Math.floor(.99*(o.length-1))]??0)}let t=V(Math.max(e,1)*1.15,4);return Math.ceil(Math.
max(e,1)*1.12/t)*t}home(){this.range=[0,2*Math.PI],this.window=null,this.wholeAgain(),this.redraw()}isWhole(){let[e,t]=this.range;return t-e>=2*Math.PI-1e-9&&(!this.
window||this.window[1]-this.window[0]>=2*this.reach()-1e-9)}wholeAgain(){this.sharpening?.abort(),this.pictures?.splice(1)}point(e){let t=this.body.getBoundingClientRect(),
n=((e.clientX-t.left)/this.look.px-q)/this.box.width,o=1-((e.clientY-t.top)/this.look.px-z)/this.box.height;return[this.range[0]+n*(this.range[1]-this.range[0]),
this.bottom()+o*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),.5*(this.bottom()+this.top())]}zoomAbout([e,t],n){let o=Math.max(e-
(e-this.range[0])*n,0),i=Math.min(e+(this.range[1]-e)*n,2*Math.PI),a=this.reach(),r=Math.max(t-(t-this.bottom())*n,-a),l=Math.min(t+(this.top()-t)*n,a);this.range=
[o,i],this.window=[r,l],this.isWhole()?this.wholeAgain():this.soon(),this.redraw()}bottom(){return this.window?this.window[0]:this.backwards?-this.reach():0}top(){
return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(e,t,n){this.films=e,this.active=t,this.look=n,this.reached=this.findReach(),this.
forwards=e.some(o=>o.columns.omega.some(i=>i>.3)),this.backwards=e.some(o=>o.columns.omega.some(i=>i<-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.
redraw()}x(e){return q+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){return z+(1-(e-this.bottom())/(this.top()-this.bottom()))*this.box.height}redraw(){
if(!this.films)return;let{colors:e,look:t}=this,{context:n,width:o,height:i}=K(this.canvas,t.px);if(this.box={width:o-q-Fn,height:i-z-Hn},n.clearRect(0,0,o,i),n.
save(),n.beginPath(),n.rect(q,z,this.box.width,this.box.height),n.clip(),this.pictures){n.imageSmoothingEnabled=!1;for(let{picture:r,window:l}of this.pictures){
let[c,m,h,d]=l,p=[this.x(c),this.y(d),this.x(m)-this.x(c),this.y(h)-this.y(d)];n.fillStyle=t.panel,n.fillRect(p[0],p[1],p[2],p[3]),n.globalAlpha=.35,n.drawImage(
r,p[0],p[1],p[2],p[3]),n.globalAlpha=1}let{paradox:a}=this.pictures[0];_r(n,this,a),this.hatched.hidden=!a.some(r=>r!==0)}for(let[a,r]of this.films.entries())this.
way(n,r,a);if(n.restore(),Er(n,this),this.keyed!==t.dark){this.keyed=t.dark;let a=Object.entries(e.mode_names).filter(([r])=>"RSKH".includes(r));this.keys.replaceChildren(
...a.map(([r,l])=>u("span",{class:"plot-key"},Bn(e.modes[r]),l)))}this.cursor(this.clock.time)}way(e,t,n){let{angle:o,omega:i,mode:a}=t.columns,r=2*Math.PI;e.lineWidth=
n?1.2:1.8,e.setLineDash(n?[4,3]:[]),e.strokeStyle=this.films.length>1?ge(n,this.look.dark):this.look.ink,e.beginPath();let l=null;for(let c=0;c<t.length;c++){if(!Number.
isFinite(i[c])){l=null;continue}let m=Math.floor(o[c]/r),h=o[c]-m*r;if(l===null)e.moveTo(this.x(h),this.y(i[c]));else if(m!==l.lap){let d=m>l.lap?r:0;e.lineTo(this.
x(d),this.y(i[c])),e.moveTo(this.x(r-d),this.y(i[c])),e.lineTo(this.x(h),this.y(i[c]))}else e.lineTo(this.x(h),this.y(i[c]));l={lap:m,mode:a[c]}}e.stroke(),e.setLineDash(
[])}spot({angle:e,omega:t}){let n=2*Math.PI;return[this.x(e-Math.floor(e/n)*n),this.y(t)]}cursor(e){if(!this.films||!this.box)return;let{context:t,width:n,height:o}=K(
this.over,this.look.px);t.clearRect(0,0,n,o);let{pointed:i}=this.clock;if(i!==null){let[a,r]=this.spot(this.films[this.active].at(i));t.strokeStyle=this.look.ink,
t.lineWidth=1.5;for(let l of[6,10])t.beginPath(),t.arc(a,r,l,0,2*Math.PI),t.stroke()}this.films.forEach((a,r)=>{let l=a.at(e),[c,m]=this.spot(l);c>=q&&c<=q+this.
box.width&&m>=z&&m<=z+this.box.height&&(t.beginPath(),t.arc(c,m,r?4:5.5,0,2*Math.PI),t.fillStyle=this.colors.modes[l.mode],t.fill(),t.lineWidth=2,t.strokeStyle=
this.films.length>1?ge(r,this.look.dark):this.look.ink,t.stroke(),!(this.films.length<2)&&(t.font=`700 12px ${this.look.font}`,t.textAlign="left",t.fillStyle=t.
strokeStyle,t.fillText("AB"[r],c+8,m-6)))})}seek(e){let t=this.body.getBoundingClientRect(),[n,o]=[e.clientX-t.left,e.clientY-t.top].map(m=>m/this.look.px);if(this.
pinched())return;let i=this.films[this.active],{angle:a,omega:r}=i.columns,l=2*Math.PI,c={distance:1/0,t:0};for(let m=0;m<i.length;m++){let h=a[m]-Math.floor(a[m]/
l)*l,d=Math.hypot(this.x(h)-n,this.y(r[m])-o);d<c.distance&&(c={distance:d,t:i.t[m]})}c.distance<40&&this.clock.seek(_(c.t,0,i.duration))}};var ot=class{constructor({key:e,title:t,unit:n,curves:o,limits:i,symmetric:a=!1},r){this.shared=r;this.key=e,this.title=t,this.unit=n,this.curves=o,this.limits=
i,this.symmetric=a,this.canvas=u("canvas",{class:"plot-canvas"}),this.over=u("canvas",{class:"plot-canvas plot-over"}),this.keys=u("div",{class:"plot-keys"}),this.
body=u("div",{class:"plot-body",tabindex:"0",role:"figure","aria-label":t},this.canvas,this.over),this.element=u("section",{class:"plot","data-plot":e},u("heade\
r",{},u("h3",{},t),this.keys),this.body),this.body.addEventListener("pointerdown",l=>this.press(l)),this.pinched=re(this.body,{zoom:(l,c)=>this.films&&this.zoomAbout(
c?this.valueAt(c):this.middle(),1/l),home:()=>this.zoomTo(null),keys:!0}),this.onseek=()=>{}}abscissa(e){return U[this.shared.axis].values(e)}fullRange(){if(this.
shared.axis==="time")return[0,Math.max(...this.films.map(n=>n.duration),1e-9)];let[e,t]=[1/0,-1/0];for(let n of this.films)for(let o of this.abscissa(n))o<e&&(e=
o),o>t&&(t=o);return t>e?[e,t]:[e-1,t+1]}take(e,t,n){this.films=e,this.active=t,this.look=n,this.range=this.shared.range??this.fullRange(),this.legend(this.shades(
e[t],t),n.dark)}draw(e){let{films:t,active:n}=this,{context:o,width:i,height:a}=K(this.canvas,this.look.px);this.box={width:i-q-Fn,height:a-z-Hn},o.clearRect(0,
0,i,a);let r=t.flatMap((c,m)=>this.shades(c,m).map((h,d)=>({...h,film:c,lane:m,number:d})).filter((h,d,p)=>this.compares(h,m,p.length)));this.heights=this.limits??
this.findHeights(r),this.shared.axis==="time"&&this.bands(o,t[n],e),kr(o,this),o.save(),o.beginPath(),o.rect(q,z,this.box.width,this.box.height),o.clip();for(let c of r)
this.curve(o,c);let l=t.map((c,m)=>r.find(h=>h.lane===m));if(t.length>1)for(let c of l)c&&this.letter(o,c);o.restore(),this.describe(r)}shades(e,t){let{dark:n}=this.
look;if(this.films.length<2)return this.curves(e).map(i=>({...i,color:i.color&&kt(i.color,n)}));let o=Object.keys(jn);return this.curves(e).map((i,a)=>({...i,color:ge(
t,n),dash:o[a%o.length]}))}compares({name:e},t,n){return t===this.active||n<=2||e==="total"}x(e){return q+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.
width}y(e){return z+(1-(e-this.heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(e){let t=[];for(let{film:n,values:o}of e){let i=this.abscissa(
n);for(let a=0;a<o.length;a++)i[a]>=this.range[0]&&i[a]<=this.range[1]&&Number.isFinite(o[a])&&t.push(o[a])}return vr(t,this.symmetric)}bands(e,t,n){for(let o of t.
phases){let i=_(this.x(o.from),q,q+this.box.width),a=_(this.x(o.to),q,q+this.box.width);a<=i||(e.fillStyle=vt(n.modes[o.mode],.14),e.fillRect(i,z,a-i,this.box.height))}}curve(e,{
film:t,color:n,dash:o,number:i}){e.strokeStyle=n??this.look.ink,e.lineWidth=1.8,e.setLineDash(jn[o??"solid"]),e.beginPath();let a=!1;for(let r of t.pieces()){let l=this.
abscissa(r.film),{values:c}=this.curves(r.film)[i];for(let m=r.from;m<r.to;m++){if(!Number.isFinite(c[m])||!Number.isFinite(l[m])){a=!1;continue}let h=this.x(l[m]),
d=_(this.y(c[m]),-1e4,1e4);a?e.lineTo(h,d):e.moveTo(h,d),a=!0}}e.stroke(),e.setLineDash([])}letter(e,{film:t,lane:n,values:o,color:i}){let a=this.abscissa(t),r=this.
range[0]+(n?.84:.7)*(this.range[1]-this.range[0]),l=a.findIndex(h=>h>=r);if(l<0||!Number.isFinite(o[l]))return;let[c,m]=[this.x(a[l]),_(this.y(o[l])-8,z+10,z+this.
box.height-4)];e.font=`700 12px ${this.look.font}`,e.textAlign="center",e.lineWidth=4,e.strokeStyle=this.look.panel,e.strokeText("AB"[n],c,m),e.fillStyle=i??this.
look.ink,e.fillText("AB"[n],c,m)}legend(e,t){let n=e.map(o=>o.name+o.color+o.dash).join()+t;this.named!==n&&(this.named=n,this.values=e.map(()=>u("span",{class:"\
value"})),this.keys.replaceChildren(...e.map((o,i)=>u("span",{class:"plot-key"},Bn(o.color,o.dash),o.name," ",this.values[i]))))}describe(e){let t=e.slice(0,6).
map(({name:o,values:i,lane:a})=>{let[r,l]=[1/0,-1/0];for(let p of i)p<r&&(r=p),p>l&&(l=p);let c=this.films.length>1?`${"AB"[a]}: `:"",m=1e-12*Math.max(-r,l),h=p=>M(
Math.abs(p)<m?0:p,3),d={name:k(o),low:h(r),high:h(l)};return l>=r?`${c}${k("{name} from {low} to {high}",d)}`:""}),n=k("Diagram: {title} in {unit}.",{title:k(this.
title),unit:k(this.unit)});this.body.setAttribute("aria-label",`${n} ${t.filter(Boolean).join("; ")}.`)}cursor(e){if(!this.heights)return;let{context:t,width:n,
height:o}=K(this.over,this.look.px);t.clearRect(0,0,n,o),this.films.forEach((a,r)=>{let l=a.moment(e),c=this.x(this.abscissa(l)[0]),m=c>=q-1&&c<=q+this.box.width+
1;m&&(t.strokeStyle=this.look.soft,t.lineWidth=1,t.beginPath(),t.moveTo(c,z),t.lineTo(c,z+this.box.height),t.stroke()),this.shades(l,r).forEach((h,d,p)=>{if(!this.
compares(h,r,p.length))return;let f=h.values[0];r===this.active&&this.values?.[d]&&(this.values[d].textContent=M(f,l.sure?3:2));let g=this.y(f);!m||!(g>=z-1&&g<=
z+this.box.height+1)||(t.fillStyle=h.color??this.look.ink,t.beginPath(),t.arc(c,g,3.2,0,2*Math.PI),t.fill())})});let{pointed:i}=this.shared.clock;if(i!==null&&this.
shared.axis==="time"&&(t.strokeStyle=this.look.ink,t.setLineDash([4,3]),t.strokeRect(this.x(i),z,0,this.box.height),t.setLineDash([])),this.picked){let[a,r]=this.
picked;t.fillStyle=vt("#0072B2",.2),t.fillRect(Math.min(a,r),z,Math.abs(r-a),this.box.height)}}valueAt(e){let t=this.body.getBoundingClientRect(),n=_(((e.clientX-
t.left)/this.look.px-q)/this.box.width,0,1);return this.range[0]+n*(this.range[1]-this.range[0])}press(e){if(!this.films)return;let t=this.body.getBoundingClientRect(),
n=(e.clientX-t.left)/this.look.px,o=this.valueAt(e),i=this.pinched(),a=r=>{if(i||=this.pinched(),i)return;let l=(r.clientX-t.left)/this.look.px;this.picked=e.pointerType===
"mouse"&&Math.abs(l-n)>5?[n,l]:null,e.pointerType!=="mouse"&&this.seek(this.valueAt(r)),this.cursor(this.shared.clock.time)};J(this.body,e,a,(r,l)=>{let c=this.
valueAt(r),{picked:m}=this;this.picked=null,m&&l?this.zoomTo(o<c?[o,c]:[c,o]):m?this.cursor(this.shared.clock.time):l&&!i&&this.seek(e.pointerType==="mouse"?o:c)})}seek(e){
if(this.shared.axis==="time")return this.onseek(e);let t=this.films[this.active],n=this.abscissa(t),o=0;for(let i=0;i<n.length;i++)Math.abs(n[i]-e)<Math.abs(n[o]-
e)&&(o=i);return this.onseek(t.t[o])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(e,t){let n=this.fullRange(),o=Math.max(e-(e-this.range[0])*t,n[0]),
i=Math.min(e+(this.range[1]-e)*t,n[1]);this.zoomTo(o<=n[0]&&i>=n[1]?null:[o,i])}zoomTo(e){this.shared.range=e&&e[1]-e[0]>1e-9?e:null,this.shared.changed()}};var Ao=s=>Object.entries(U).map(([e,t])=>u("option",{value:e},s(t)));function Mr(s){let e="height",t=new ot({key:"own",title:"Your choice",unit:"",curves:i=>[{name:k(
U[e].name),values:U[e].values(i)}]},s),n=()=>{let{symbol:i,unit:a}=U[e];t.unit=a?`${i} [${a}]`:i},o=u("select",{"aria-label":"What your diagram shows",onchange:()=>{
e=o.value,n(),s.changed()}},Ao(Ba));return o.value=e,n(),t.element.querySelector("h3")?.after(o),t}function Iu(s){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:e=>[{name:"v (centre)",color:s.center_speed,values:e.columns.vx},{name:"\
R θ̇",color:s.rotation_speed,dash:"dash",values:e.derived("spin",({omega:t})=>Float64Array.from(t,n=>n*e.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:e=>[{name:"kinetic",color:s.kinetic,values:e.columns.kinetic},{name:"potential",color:s.potential,values:e.columns.potential},{name:"\
total",values:e.derived("total",({t,kinetic:n,potential:o})=>Float64Array.from(t,(i,a)=>n[a]+o[a])),dash:"dash"},{name:"lost to friction",color:s.friction_loss,
values:e.columns.friction_loss},{name:e.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:s.impact_loss,values:e.columns.
normal_loss,dash:"dot"},...e.scenario.plane.rolling_resistance?[{name:"lost to rolling resistance",values:e.columns.rolling_resistance,dash:"dot"}]:[]]},{key:"f\
orces",title:"Contact forces",unit:"force [N]",curves:e=>[{name:"normal N",color:s.normal_force,values:e.columns.normal_force},{name:"friction F",color:s.friction_force,
dash:"dash",values:e.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],curves:e=>[{name:"|F| / μN",color:s.
friction_force,values:e.columns.utilization}]}]}var Wn=class{constructor(e,t){this.colors=t;this.shared={axis:"time",range:null,clock:e,changed:()=>this.redraw()},
this.plots=[...Iu(t).map(o=>new ot(o,this.shared)),Mr(this.shared)];for(let o of this.plots)o.onseek=i=>e.seek(i);this.seen=new Map(this.plots.map(o=>[o.element,
!0]));let n=new IntersectionObserver(o=>{for(let{target:i,isIntersecting:a}of o)this.seen.set(i,a);this.redraw()},{rootMargin:"400px"});for(let o of this.plots)
n.observe(o.element);this.axis=u("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=null,
this.redraw()}},Ao(({name:o})=>`over ${o}`)),this.back=u("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=u("\
span",{class:"hint"}),this.element=u("div",{class:"plots"},u("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(o=>o.element))}draw(e,t,n){
this.films=e,this.active=t,this.look=n;let o=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":`click to go there, drag to zoom; ${st("")}`,
i=e.length>1;R(this.hint,i?`A blue, B ochre; the dashes tell the quantities; numbers of ${"AB"[t]}; ${o}`:o),this.redraw()}redraw(){if(this.films?.length){this.
back.hidden=!this.shared.range;for(let e of this.plots)e.take(this.films,this.active,this.look);for(let e of this.visible())e.draw(this.colors);this.cursor(this.
shared.clock.time)}}visible(){return this.plots.filter(e=>this.seen.get(e.element))}cursor(e){for(let t of this.visible())t.cursor(e)}};var qu={python:"✓ Same bits as in Python",link:"✓ Same bits as where the link was made"},Fu={python:"The bits differ: {own} here, {other} in Python.",link:"\
The bits differ: {own} here, {other} where the link was made, perhaps with another version."},Gn=class{constructor(e){this.link=new Map;this.python=new Map(e.map(
({key:t,query:n})=>[n,S.fingerprints[t]]))}expect(e,t){for(let[n,{query:o}]of e.entries())t[n]&&this.link.set(o,t[n])}expected(e){return e.map(({query:t})=>this.
link.get(t)??"")}of({query:e,fingerprint:t}){return t?["python","link"].flatMap(n=>{let o=this[n].get(e);if(!o)return[];let i=t===o;return[{same:i,text:i?qu[n]:
Fu[n].replace("{own}",t).replace("{other}",o)}]}):[]}};var Rr=Ll(Lr(),1);var Hu=3840;async function Pr(s){let{width:e,height:t}=s.stage.canvas().getBoundingClientRect(),n=Math.max(Hu/e,globalThis.devicePixelRatio||1),o=u("canvas",{width:Math.
round(e*n),height:Math.round(t*n)}),i=we(o);return i.setTransform(n,0,0,n,0,0),Ro(i,s,e,t),s.stage.options.three?(i.drawImage(s.stage.sharp(s,n),0,0,e,t),s.drawStage()):
Nr(i,s,e,t),Po(i,s,t),new Promise((a,r)=>o.toBlob(l=>l?a(l):r(new Error("The picture is too large for this browser."))))}function Cr(s){if(s.stage.options.three)
throw new Error("A picture in space has no lines to keep: take the PNG, or leave 3D.");let{width:e,height:t}=s.stage.canvas().getBoundingClientRect(),n=new Rr.Context(
{width:e,height:t,document});return Ro(n,s,e,t),Nr(n,s,e,t),Po(n,s,t),new Blob([n.getSerializedSvg()],{type:"image/svg+xml"})}function zr(s,e){let t=s.stage.canvas(),
{width:n,height:o}=t.getBoundingClientRect(),i=we(e);i.setTransform(e.width/n,0,0,e.height/o,0,0),Ro(i,s,n,o),i.drawImage(t,0,0,n,o),Po(i,s,o)}function Ro(s,{theme:e},t,n){
s.fillStyle=e.look.paper,s.fillRect(0,0,t,n)}function Nr(s,e,t,n){let{stage:o,clock:i,theme:a}=e;o.flat.paint(s,t,n,e.films(),i.time,o.options,a.look,a.inks)}function Po(s,e,t){
let{theme:n,stage:o,clock:i}=e,{px:a}=n.look,r=e.films();s.textBaseline="top",s.textAlign="left";for(let[l,c]of r.entries()){let m=c.at(i.time),h=r.length>1?`${"\
AB"[l]}: `:"",d=k(n.colors.mode_names[m.mode]),p=`t = ${m.t.toFixed(3)} s, θ = ${G(m.angle)}, v = ${M(m.vx,m.digits)} m/s`,f=o.options.three?10+20*a*l:10+l*t/r.
length;s.fillStyle=n.colors.modes[m.mode],s.fillRect(12,f+2*a,11*a,11*a),s.fillStyle=n.look.ink,s.font=`${13*a}px ${n.look.font}`,s.fillText(`${h}${d}, ${p}`,12+
18*a,f)}s.textBaseline="alphabetic"}async function Dr(s){let e=s.stage.canvas();if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 in\
stead.");let t=u("canvas",{width:2*Math.ceil(e.width/2),height:2*Math.ceil(e.height/2)}),n=new MediaRecorder(t.captureStream(60),{videoBitsPerSecond:8e6}),o=[];
n.ondataavailable=r=>o.push(r.data);let i=new Promise(r=>n.onstop=r),{loop:a}=s.clock;return s.clock.loop=!1,s.clock.seek(0),s.notice.say("Recording one run …"),
s.afterFrame=()=>{zr(s,t),!s.clock.playing&&n.state==="recording"&&n.stop()},n.start(),s.clock.play(!0),await i,s.afterFrame=null,s.clock.loop=a,new Blob(o,{type:n.
mimeType})}var ju=[["motion.toml","Save the scenario (TOML)"],["motion.csv","Save the states (CSV)"],["motion.nc","Save the motion (netCDF)"],["motion.json","Save the even\
ts (JSON)"],["motion.mp4","Save a film (MP4)"]],Kn=class{constructor(e){this.lab=e;this.menu=u("details",{class:"menu"},u("summary",{class:"button"},u("span",{class:"\
long"},"Share and save"),u("span",{class:"short"},"Share")),u("div",{class:"menu-body"},e.backend.shares&&this.item("Copy a link to this motion",()=>this.copyLink()),
ju.filter(([t])=>e.backend.files.includes(t)).map(([t,n])=>this.item(n,()=>this.download(t))),this.item("Save a picture (PNG)",()=>this.picture("png",Pr)),this.
item("Save a picture (SVG)",()=>this.picture("svg",Cr)),this.item("Record one run as a film (WebM)",()=>this.record()),this.item("Show the Python code",()=>this.
code()))),this.dialog=u("dialog",{class:"code-dialog","aria-label":"The same motion in Python"})}item(e,t){return u("button",{type:"button",onclick:async()=>{this.
menu.open=!1;try{await t()}catch(n){this.lab.notice.fail(n)}}},e)}async copyLink(){let e=this.lab.link(this.lab.films().map(({fingerprint:t})=>t??""))??"";try{await navigator.
clipboard.writeText(e),this.lab.notice.say("The link is copied.")}catch{this.show("The link to this motion",e)}}async download(e){let t=this.lab.film();this.lab.
notice.say(e.endsWith("mp4")?"The film is being made; this takes a while …":`Fetching ${e} …`),et(await this.lab.backend.file(e,t.query),`hophoop-${e}`),this.
lab.notice.say(`${e} is there.`)}async picture(e,t){et(await t(this.lab),`hophoop.${e}`)}async record(){et(await Dr(this.lab),"hophoop.webm"),this.lab.notice.say(
"The film is there.")}async code(){let{python:e,toml:t}=this.lab.backend.code(this.lab.film().scenario);this.show("The same motion in Python",e,"The scenario as\
 a file",t)}show(...e){let t=[];for(let n=0;n<e.length;n+=2){let o=e[n+1],i=u("button",{type:"button"},"Copy");i.onclick=async()=>{await navigator.clipboard?.writeText(
o).catch(()=>{}),R(i,"Copied")},t.push(u("header",{},u("h2",{},e[n]),i),u("pre",{tabindex:"0"},u("code",{},document.createTextNode(o))))}this.dialog.replaceChildren(
...t,u("button",{type:"button",class:"close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};var Or=120,Vn=class{constructor(e,t,n,o,i,a,r,l,c,m,h){this.context=e;this.width=t;this.height=n;this.film=o;this.options=a;this.look=r;this.colors=l;this.common=
h;this.top=0;this.pose=o.at(i);let d=o.radius,{left:p,right:f}=o.extent,{top:g}=h;this.cosine=Math.cos(o.slope),this.sine=Math.sin(o.slope);let b=2*h.radius+Math.
min(g,6*h.radius),w=Math.min(.66*n/b,.36*t/h.radius);if(a.whole){let y=(f-p)*this.cosine+2.6*d,v=(f-p)*Math.abs(this.sine)+2.6*d+g;this.scale=Math.min(t/y,.86*n/
v,w)*c,this.focus=[.5*(p+f),0],this.place=[.5*t+m[0],(o.slope?.62:.8)*n+m[1]]}else this.scale=w*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.
place=[(t<520?.6:.46)*t+m[0],.82*n+m[1]]}point(e,t){let n=e-this.focus[0],o=t-this.focus[1];return[this.place[0]+this.scale*(n*this.cosine+o*this.sine),this.place[1]-
this.scale*(o*this.cosine-n*this.sine)]}unpoint(e,t){let n=(e-this.place[0])/this.scale,o=-(t-this.place[1])/this.scale;return[this.focus[0]+n*this.cosine-o*this.
sine,this.focus[1]+n*this.sine+o*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&this.
forces()}ground(){let{context:e,look:t,width:n,height:o}=this,i=(Math.hypot(n,o)*1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[a,r]=this.point(
this.focus[0]-i,0),[l,c]=this.point(this.focus[0]+i,0),m=[-this.sine*4e3,this.cosine*4e3];e.fillStyle=t.ground,e.beginPath(),e.moveTo(a,r),e.lineTo(l,c),e.lineTo(
l+m[0],c+m[1]),e.lineTo(a+m[0],r+m[1]),e.fill(),e.strokeStyle=t.soft,e.lineWidth=1.5,e.beginPath(),e.moveTo(a,r),e.lineTo(l,c),e.stroke();let h=V(n/this.scale,n/
(90*t.px));e.fillStyle=t.soft,e.font=`${11*t.px}px ${t.font}`,e.textAlign="center",e.lineWidth=1;let d=Math.ceil((this.focus[0]-i)/h),p=Math.min(Math.floor((this.
focus[0]+i)/h),d+400);for(let f=d;f<=p;f++){let[g,b]=this.point(f*h,0);g<-40||g>n+40||(e.beginPath(),e.moveTo(g,b),e.lineTo(g-6*this.sine,b+6*this.cosine),e.stroke(),
e.fillText(`${ae(f*h,h)} m`,g-18*t.px*this.sine,b+8+10*t.px*this.cosine))}}traces(){let{film:e,context:t,look:n,colors:o}=this,i=e.radius,a=this.options.ahead?e.
duration:this.pose.t,r=(l,c,m,h)=>{t.strokeStyle=c,t.lineWidth=m,t.lineJoin="round",t.beginPath();let d=!1,p=(f,g,b)=>{let[w,y]=this.point(f+l*Math.sin(b),i+g+l*
Math.cos(b));d?t.lineTo(w,y):t.moveTo(w,y),d=!0};for(let f of e.pieces()){let{x:g,height:b,angle:w,mode:y}=f.film.columns;for(let v=f.from;v<f.to&&f.film.t[v]<=
a;v++)h===void 0||y[v]===3===h?p(g[v],b[v],w[v]):d=!1}!this.options.ahead&&(h===void 0||this.pose.mode==="H"===h)&&p(this.pose.x,this.pose.height,this.pose.angle),
t.stroke()};t.globalAlpha=this.options.ahead?.45:1,r(i,n.ink,1.3),r(e.eccentricity*i,o.gravity_center,1.8,!1),r(e.eccentricity*i,o.airborne,2.4,!0),t.globalAlpha=
1}mark(e,t){let{context:n,film:o,pose:i,scale:a}=this,[r,l]=this.point(i.x,o.radius+i.height);n.strokeStyle=t,n.lineWidth=3,n.beginPath(),n.arc(r,l,Math.max(o.radius*
a-_(.07*o.radius*a,2,14)-3,2),0,2*Math.PI),n.stroke(),n.fillStyle=t,n.font=`700 ${17*this.look.px}px ${this.look.font}`,n.textAlign="center",n.fillText(e,r-14,l+
20)}ghost(e){let{context:t,film:n,look:o,width:i,scale:a}=this,r=n.radius,[l,c]=this.point(e.x,r+e.height),m=r*a;if(t.strokeStyle=t.fillStyle=o.ink,t.lineWidth=
1.5,t.beginPath(),l>-.5*m&&l<i+.5*m){let g=this.point(e.x+r*Math.sin(e.angle),r+e.height+r*Math.cos(e.angle));t.setLineDash([6,5]),t.arc(l,c,m,0,2*Math.PI),t.moveTo(
l,c),t.lineTo(...g),t.stroke(),t.setLineDash([]),t.beginPath(),t.arc(...g,_(.1*m,4,16),0,2*Math.PI),t.fillStyle=o.paper,t.fill(),t.stroke();return}let h=l<0?-1:
1,d=h<0?6:i-6,p=_(c,24,this.height-24);t.moveTo(d,p),t.lineTo(d-14*h,p-9),t.lineTo(d-14*h,p+9),t.fill(),t.font=`600 ${12*o.px}px ${o.font}`,t.textAlign=h<0?"lef\
t":"right",t.lineWidth=3,t.strokeStyle=o.paper;let f=`${M(e.x-this.focus[0],3)} m`;t.strokeText(f,d-20*h,p+4*o.px),t.fillText(f,d-20*h,p+4*o.px)}hoop(){let{film:e,
pose:t,context:n,look:o,colors:i,scale:a}=this,r=e.radius,l=_(.07*r*a,2,14),c=r-.5*l/a,m=[t.x,r+t.height],h=(b,w=c)=>this.point(m[0]+w*Math.sin(b),m[1]+w*Math.cos(
b));if(n.lineCap="butt",o.dark&&(n.strokeStyle=o.soft,n.lineWidth=l+2,n.beginPath(),n.arc(...this.point(m[0],m[1]),c*a,0,2*Math.PI),n.stroke()),this.options.speed){
let b=this.common.speed;n.lineWidth=l;let w=2*Math.PI/Or;for(let y=0;y<Or;y++){let v=t.angle+y*w,E=Math.hypot(t.vx+r*t.omega*Math.cos(v+.5*w),t.vy-r*t.omega*Math.
sin(v+.5*w));n.strokeStyle=en[_(Math.round(255*E/b)||0,0,255)],n.beginPath(),n.moveTo(...h(v-.04*w)),n.lineTo(...h(v+1.04*w)),n.stroke()}}else n.strokeStyle=i.modes[t.
mode],n.lineWidth=l,n.beginPath(),n.arc(...this.point(m[0],m[1]),c*a,0,2*Math.PI),n.stroke();n.strokeStyle=o.soft,n.lineWidth=1,n.beginPath(),n.moveTo(...this.point(
m[0],m[1])),n.lineTo(...h(t.angle)),n.stroke();let d=(b,w,y,v)=>{n.beginPath(),n.arc(...b,w,0,2*Math.PI),n.fillStyle=y,n.fill(),n.lineWidth=1.5,n.strokeStyle=v,
n.stroke()};d(this.point(m[0],m[1]),2.5,o.soft,o.soft);let p=e.scenario.hoop.parts;p?this.parts(p,m):d(h(t.angle),_(.1*r*a,4,16),o.ink,o.paper);let f=e.eccentricity*
r,g=this.point(m[0]+f*Math.sin(t.angle),m[1]+f*Math.cos(t.angle));d(g,_(.05*r*a,3.5,7),t.mode==="H"?i.airborne:i.gravity_center,o.paper)}parts(e,t){let{film:n,pose:o,
context:i,look:a,scale:r}=this,c=e.reduce((m,h)=>m+h.mass*(h.at??0),0)<0?-1:1;i.strokeStyle=a.ink;for(let m of e){let h=c*(m.at??0),d=this.point(t[0]+h*Math.sin(
o.angle),t[1]+h*Math.cos(o.angle));if(i.fillStyle=a.ink,i.lineWidth=1,i.beginPath(),m.shape==="ring")i.globalAlpha=.22,i.arc(...d,m.outer_radius*r,0,2*Math.PI),
i.arc(...d,m.inner_radius*r,0,2*Math.PI,!0),i.fill(),i.globalAlpha=1;else if(m.shape==="rod"){let p=.5*m.length,f=g=>this.point(t[0]+g*Math.sin(o.angle),t[1]+g*
Math.cos(o.angle));i.lineWidth=4,i.moveTo(...f(h-p)),i.lineTo(...f(h+p)),i.stroke()}else{let p=m.shape==="disk"?m.radius*r:_(.08*n.radius*r,3,12);i.globalAlpha=
m.shape==="disk"?.55:1,i.arc(...d,p,0,2*Math.PI),i.fill(),i.globalAlpha=1}}}forces(){let{film:e,pose:t,colors:n}=this,o=e.radius,i=e.mass*(e.gravity||9.81),a=l=>.55*
o*l/i;if(t.mode==="H"||!(t.normal_force>0))return;let r=[t.x,t.height];this.arrow(r,[0,a(t.normal_force)],n.normal_force,`N = ${M(t.normal_force,t.digits)} N`,!1),
this.arrow(r,[a(t.friction_force),0],n.friction_force,`F = ${M(t.friction_force,t.digits)} N`,!0)}arrow([e,t],[n,o],i,a,r){let{context:l,look:c,width:m}=this,h=2.2*
this.film.radius,d=Math.abs(n)>h||Math.abs(o)>h;[n,o]=[_(n,-h,h),_(o,-h,h)];let p=this.point(e,t),f=this.point(e+n,t+o),g=Math.hypot(f[0]-p[0],f[1]-p[1]);if(g<2)
return;let b=(f[0]-p[0])/g,w=(f[1]-p[1])/g,y=Math.min(11,g);for(let[T,L]of[[c.paper,6],[i,3]])l.strokeStyle=T,l.fillStyle=T,l.lineWidth=L,l.beginPath(),l.moveTo(
...p),l.lineTo(f[0]-b*y,f[1]-w*y),l.stroke();if(l.beginPath(),l.moveTo(...f),l.lineTo(f[0]-b*y-w*y*.5,f[1]-w*y+b*y*.5),l.lineTo(f[0]-b*y+w*y*.5,f[1]-w*y-b*y*.5),
l.fill(),d){let[T,L]=[p[0]+.55*b*g,p[1]+.55*w*g];l.strokeStyle=c.paper,l.lineWidth=2,l.beginPath();for(let P of[-3,3])l.moveTo(T+b*(P-3)-w*7,L+w*(P-3)+b*7),l.lineTo(
T+b*(P+3)+w*7,L+w*(P+3)-b*7);l.stroke()}l.font=`600 ${12*c.px}px ${c.font}`;let v=l.measureText(a).width;l.lineWidth=3,l.strokeStyle=r?c.ground:c.paper,l.textAlign=
"left";let E=r?[p[0]-.5*v-32*c.px*this.sine,p[1]+32*c.px*this.cosine]:[f[0]+12,_(f[1]+4,16,p[1]-.36*this.film.radius*this.scale)];E[0]=_(E[0],4,m-v-4),l.strokeText(
a,E[0],E[1]),l.fillText(a,E[0],E[1])}};var Jn=class{constructor(e,t){this.canvas=e;this.onview=t;this.zoom=1;this.shift=[0,0];this.views=[];this.fixed=null;this.pointed=null;this.grab=()=>!1,this.over=
()=>{},e.addEventListener("pointerdown",n=>this.drag(n)),this.pinched=re(e,{zoom:n=>this.zoomBy(n),home:()=>this.reset(),chosen:()=>e.parentElement})}reset(){this.
zoom=1,this.shift=[0,0],this.onview()}pan(){let{width:e,height:t}=this.canvas.getBoundingClientRect();return[this.shift[0]/(e||1),this.shift[1]/(t||1)]}look(e=1,[
t,n]=[0,0]){let{width:o,height:i}=this.canvas.getBoundingClientRect();this.zoom=e,this.shift=[t*o,n*i]}zoomBy(e){this.zoom=_(this.zoom*e,.05,60),this.onview()}drag(e){
if(this.grab(e))return;let t=[e.clientX,e.clientY],n=this.shift;J(this.canvas,e,o=>{this.pinched()||(this.shift=[n[0]+o.clientX-t[0],n[1]+o.clientY-t[1]],this.onview())})}draw(e,t,n,o,i){
let{context:a,width:r,height:l}=K(this.canvas);a.clearRect(0,0,r,l),!(r<40||l<40)&&(this.views=this.paint(a,r,l,e,t,n,o,i))}paint(e,t,n,o,i,a,r,l){let c=n/o.length,
m={top:Math.max(...o.map(h=>h.extent.top)),radius:Math.max(...o.map(h=>h.radius)),speed:Math.max(...o.map(h=>h.extent.speed))};return o.map((h,d)=>{e.save(),e.beginPath(),
e.rect(0,d*c,t,c),e.clip(),e.translate(0,d*c);let p=new Vn(e,t,c,h,i,a,r,l,this.zoom,this.shift,m);return p.top=d*c,p.scale=this.fixed??p.scale,p.draw(),this.pointed?.
lane===d&&p.ghost(h.at(this.pointed.time)),this.over(p,d),o.length>1&&(p.mark("AB"[d],ge(d,r.dark)),e.fillStyle=ge(d,r.dark),e.font=`700 ${17*r.px}px ${r.font}`,
e.textAlign="left",e.fillText("AB"[d],12,c-12)),e.restore(),d>0&&(e.fillStyle=r.line,e.fillRect(0,d*c-.5,t,1)),p})}};function zo(s,e){let t=new Float32Array(16);for(let n=0;n<4;n++)for(let o=0;o<4;o++){let i=0;for(let a=0;a<4;a++)i+=s[4*a+o]*e[4*n+a];t[4*n+o]=i}return t}function Ir(s,e,t,n){
let o=1/Math.tan(s/2),i=1/(t-n);return new Float32Array([o/e,0,0,0,0,o,0,0,0,0,(n+t)*i,-1,0,0,2*n*t*i,0])}function qr(s,e){let t=Ve(No(s,e)),n=Ve(Yn([0,1,0],t)),
o=Yn(t,n);return new Float32Array([n[0],o[0],t[0],0,n[1],o[1],t[1],0,n[2],o[2],t[2],0,-Co(n,s),-Co(o,s),-Co(t,s),1])}var No=(s,e)=>[s[0]-e[0],s[1]-e[1],s[2]-e[2]],
Co=(s,e)=>s[0]*e[0]+s[1]*e[1]+s[2]*e[2],Yn=(s,e)=>[s[1]*e[2]-s[2]*e[1],s[2]*e[0]-s[0]*e[2],s[0]*e[1]-s[1]*e[0]];function Ve(s){let e=Math.hypot(...s)||1;return[
s[0]/e,s[1]/e,s[2]/e]}function Zn(s,e,t,n){let o=Ve(e),i=Ve(Yn(o,Math.abs(o[2])>.9?[1,0,0]:[0,0,1])),a=Yn(i,o);return new Float32Array([...i.map(r=>r*n),0,...o.
map(r=>r*t),0,...a.map(r=>r*n),0,...s,1])}function Do(s){let[e,t]=[Math.cos(s),Math.sin(s)];return new Float32Array([e,-t,0,0,t,e,0,0,0,0,1,0,0,0,0,1])}function ce(s){let e=Number.parseInt(s.slice(1,7),
16);return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}function it(s,e,t){let n=s.createProgram(),o=[[s.VERTEX_SHADER,e],[s.FRAGMENT_SHADER,t]];for(let[a,r]of o){let l=s.createShader(a);if(s.shaderSource(l,r),s.compileShader(
l),!s.getShaderParameter(l,s.COMPILE_STATUS))throw new Error(String(s.getShaderInfoLog(l)));s.attachShader(n,l)}if(s.linkProgram(n),!s.getProgramParameter(n,s.LINK_STATUS))
throw new Error(String(s.getProgramInfoLog(n)));let i={program:n,uniforms:{},attributes:{}};for(let a=0;a<s.getProgramParameter(n,s.ACTIVE_UNIFORMS);a++){let{name:r}=s.
getActiveUniform(n,a);i.uniforms[r]=s.getUniformLocation(n,r)}for(let a=0;a<s.getProgramParameter(n,s.ACTIVE_ATTRIBUTES);a++){let{name:r}=s.getActiveAttrib(n,a);
i.attributes[r]=s.getAttribLocation(n,r)}return i}function Je(s,e,t,n){let o=s.createBuffer();s.bindBuffer(s.ARRAY_BUFFER,o),s.bufferData(s.ARRAY_BUFFER,new Float32Array(
e),s.STATIC_DRAW);let i=n?s.createBuffer():null;n&&(s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,i),s.bufferData(s.ELEMENT_ARRAY_BUFFER,new Uint16Array(n),s.STATIC_DRAW));
let a=4*Object.values(t).reduce((r,l)=>r+l,0);return{vertices:o,elements:i,parts:t,stride:a,count:n?n.length:4*e.length/a}}function at(s,e,t){s.bindBuffer(s.ARRAY_BUFFER,
t.vertices);let n=0;for(let[o,i]of Object.entries(t.parts)){let a=e.attributes[o];a!==void 0&&(s.enableVertexAttribArray(a),s.vertexAttribPointer(a,i,s.FLOAT,!1,
t.stride,n)),n+=4*i}t.elements&&s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,t.elements)}function Oo(s,e){let t=[];for(let n=0;n<s;n++)for(let o=0;o<e;o++){let i=n*(e+1)+
o,a=i+e+1;t.push(i,a,i+1,a,a+1,i+1)}return t}function Fr(s,e=120,t=14){let n=[];for(let o=0;o<=e;o++)for(let i=0;i<=t;i++)n.push(2*Math.PI*o/e,2*Math.PI*i/t);return Je(
s,n,{bend:2},Oo(e,t))}function Hr(s,e=28,t=18){let n=[];for(let o=0;o<=e;o++)for(let i=0;i<=t;i++){let[a,r]=[2*Math.PI*o/e,Math.PI*i/t],l=[Math.sin(r)*Math.cos(
a),Math.cos(r),Math.sin(r)*Math.sin(a)];n.push(...l,...l)}return Je(s,n,{position:3,normal:3},Oo(e,t))}function Io(s,e,t=20){let n=[];for(let o=0;o<=t;o++){let i=2*
Math.PI*o/t,a=[Math.cos(i),1-e,Math.sin(i)];n.push(Math.cos(i),0,Math.sin(i),...a,e*Math.cos(i),1,e*Math.sin(i),...a)}return Je(s,n,{position:3,normal:3},Oo(t,1))}var Wr=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,Gr=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,Ur="vec4(0.0, 0.0, 0.0, shadow)",jr=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${Gr}
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
   ${Wr}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${Ur} : vec4(shaded(color, n), 1.0);
   }`],Br=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${Gr}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${Wr}
   void main() { gl_FragColor = shadow > 0.0 ? ${Ur} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],$r=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],Qn=class{constructor(e,t,n,o,{keep:i=!1}={}){this.canvas=e;
this.dark=o;this.eye=[0,0,1];this.fastest=1;let a=e.getContext("webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:i});if(!a)throw new Error("This browser dr\
aws nothing in space (WebGL is missing).");this.gl=a,this.sun=Ve(n),this.slant=[n[0]/n[1],1,n[2]/n[1]],this.rim=it(a,jr[0],jr[1]),this.body=it(a,Br[0],Br[1]),this.
line=it(a,$r[0],$r[1]),this.torus=Fr(a),this.sphere=Hr(a),this.cylinder=Io(a,1),this.cone=Io(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.
colors);let r=new Uint8Array(t.flatMap(l=>[...l,255]));a.pixelStorei(a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,t.length,1,0,a.RGBA,a.UNSIGNED_BYTE,
r);for(let l of[a.TEXTURE_WRAP_S,a.TEXTURE_WRAP_T])a.texParameteri(a.TEXTURE_2D,l,a.CLAMP_TO_EDGE);for(let l of[a.TEXTURE_MIN_FILTER,a.TEXTURE_MAG_FILTER])a.texParameteri(
a.TEXTURE_2D,l,a.LINEAR);this.view=Do(0)}begin({background:e,eye:t,target:n,slope:o,angle:i,near:a,far:r}){let{gl:l,canvas:c}=this;l.viewport(0,0,c.width,c.height),
l.clearColor(e[0],e[1],e[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let m=Ir(i,c.width/c.height,a,r);this.
view=zo(zo(m,qr(t,n)),Do(o)),this.eye=Ve(No(t,n))}use(e,t){let{gl:n}=this;n.useProgram(e.program);let o={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,
...t};for(let[i,a]of Object.entries(o)){let r=e.uniforms[i];r!==void 0&&(typeof a=="number"?n.uniform1f(r,a):a.length===16?n.uniformMatrix4fv(r,!1,a):n[`uniform${a.
length}fv`](r,a))}}ground(e){let{gl:t}=this;t.depthFunc(t.ALWAYS),e(),t.depthFunc(t.LESS)}shadows(e){let{gl:t}=this;t.enable(t.BLEND),t.blendFuncSeparate(t.SRC_ALPHA,
t.ONE_MINUS_SRC_ALPHA,t.ZERO,t.ONE),t.enable(t.STENCIL_TEST),t.stencilFunc(t.EQUAL,0,255),t.stencilOp(t.KEEP,t.KEEP,t.INCR),t.depthFunc(t.ALWAYS),t.depthMask(!1),
e(),t.depthMask(!0),t.depthFunc(t.LESS),t.disable(t.STENCIL_TEST),t.disable(t.BLEND)}solid(e,t,n,{shadow:o=!1,lit:i=!0}={}){let{gl:a}=this;this.use(this.body,{model:t,
color:n,shadow:o?this.dark:0,lit:Number(i)}),at(a,this.body,e),a.drawElements(a.TRIANGLES,e.count,a.UNSIGNED_SHORT,0)}ball(e,t,n,o){this.solid(this.sphere,Zn(e,
[0,1,0],t,t),n,{shadow:o})}ring({center:e,radius:t,tube:n,broad:o,angle:i,velocity:a,omega:r,plain:l=null},c){let{gl:m}=this;this.use(this.rim,{center:e,size:[t,
n,o,i],motion:[...a,r],most:this.fastest,shadow:c?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),at(m,this.rim,this.torus),m.drawElements(m.TRIANGLES,this.torus.count,
m.UNSIGNED_SHORT,0)}rod(e,t,n,o,i,a=!1){this.solid(this.cylinder,Zn(e,t,n,o),i,{shadow:a})}arrow(e,t,n,o,i){if(!(n>.02*o))return;let a=Math.min(.18*o,n),r=e.map(
(l,c)=>l+t[c]*(n-a));n>a&&this.rod(e,t,n-a,.029*o,i),this.solid(this.cone,Zn(r,t,a,Math.min(.075*o,.6*a)),i)}trace(e,t,n){let o=[];for(let i=0;i<e;i++){let a=t(
i),r=t(Math.min(i+1,e-1));if(Math.hypot(r[0]-a[0],r[1]-a[1])<1e-9&&i>0){let l=t(i-1);r=a.map((c,m)=>2*c-l[m])}for(let l of[-1,1])o.push(...a,0,...r,0,...n(i),l)}
return Je(this.gl,o,{position:3,next:3,tint:3,side:1})}drawTrace(e,t,{width:n,distance:o=0,shift:i,depth:a}){let{gl:r,canvas:l}=this;this.use(this.line,{pixel:[
2/l.width,2/l.height],width:n,distance:o,shift:i,depth:a}),at(r,this.line,e),r.drawArrays(r.TRIANGLE_STRIP,0,2*t)}onScreen([e,t,n]){let o=this.view,[i,a,r]=[0,1,
3].map(l=>o[l]*e+o[4+l]*t+o[8+l]*n+o[12+l]);return r>0?[(.5+.5*i/r)*this.canvas.width,(.5-.5*a/r)*this.canvas.height]:null}};var Bu=[.35,.85,.4],$u=.18,qt={azimuth:.5,height:.22,distance:5.2},Kr=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],Xn=class{constructor(e,t){this.canvas=e;this.onview=t;this.space=new Qn(this.canvas,Ze,Bu,$u,{keep:!0});this.floor=it(this.space.gl,Kr[0],Kr[1]);this.corners=
Je(this.space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2});this.turned={...qt};this.lines=new WeakMap;this.share=1;this.pace=16;this.before=0;this.focus=0;this.reach=1;
e.addEventListener("pointerdown",n=>this.drag(n)),this.pinched=re(e,{zoom:n=>this.zoomBy(n),home:()=>this.zoomBy(0),chosen:()=>e.parentElement})}zoomBy(e){e?this.
turned.distance=_(this.turned.distance/e,1.6,60):this.turned={...qt},this.onview()}from(){let{azimuth:e,height:t,distance:n}=this.turned;return e===qt.azimuth&&
t===qt.height&&n===qt.distance?void 0:[e,t,n]}look([e,t,n]){this.turned={azimuth:_(e,-1.5,1.5),height:_(t,.02,1.45),distance:_(n,1.6,60)}}drag(e){let t={...this.
turned,x:e.clientX,y:e.clientY};J(this.canvas,e,n=>{this.pinched()||(this.turned.azimuth=_(t.azimuth-(n.clientX-t.x)*.008,-1.5,1.5),this.turned.height=_(t.height+
(n.clientY-t.y)*.006,.02,1.45),this.onview())})}quality(){let e=performance.now(),t=e-(this.before||e);return this.before=e,t>0&&t<200&&(this.pace=.9*this.pace+
.1*t),this.pace>26&&this.share>.5&&(this.share=Math.max(this.share-.1,.5),this.pace=16),this.share}draw(e,t,n,o,i,a,r){let{canvas:l,space:c}=this,m=r??Math.min(
globalThis.devicePixelRatio||1,2)*(a?this.quality():1),h=l.getBoundingClientRect();l.width=Math.max(Math.round(h.width*m),1),l.height=Math.max(Math.round(h.height*
m),1);let d=e.map(g=>g.at(t)),p=e[0].radius;c.fastest=Math.max(...e.map(g=>g.extent.speed)),this.focus=Number.isFinite(d[0].x)?d[0].x:0,c.begin({background:ce(o.
paper),...this.camera(e[0],d[0],p,n)}),c.ground(()=>this.drawFloor(p,o));let f=g=>{for(let[b,w]of e.entries())g(w,d[b],-2.1*p*b)};c.shadows(()=>f((g,b,w)=>this.
drawHoop(g,b,w,n,o,i,!0))),f((g,b,w)=>{this.drawHoop(g,b,w,n,o,i,!1),n.traces&&this.drawTraces(g,b,w,o,i,m),n.forces&&this.drawForces(g,b,w,i)})}camera(e,t,n,o){
let{azimuth:i,height:a,distance:r}=this.turned,{left:l,right:c}=e.extent,m=o.whole?Math.max(r*n,.85*(c-l)+3*n):r*n,[h,d]=[o.whole?.5*(l+c)-this.focus:0,n+.45*(t.
height||0)],p=Math.cos(e.slope),f=Math.sin(e.slope),g=[h*p+d*f,-h*f+d*p,0],b=[g[0]+m*Math.sin(i)*Math.cos(a),g[1]+m*Math.sin(a),m*Math.cos(i)*Math.cos(a)];return this.
reach=12*n+3*m,{eye:b,target:g,slope:e.slope,angle:.75,near:.05*n,far:40*n+6*m}}drawFloor(e,t){let{space:n}=this,o=ce(t.ground),i=o.map(l=>l*(t.dark?.82:.94)),a=.5*
e,r=this.focus%(2*a);n.use(this.floor,{reach:this.reach,light:o,dark:i,far:ce(t.paper),tile:a,shift:r}),at(n.gl,this.floor,this.corners),n.gl.drawArrays(n.gl.TRIANGLE_STRIP,
0,4)}drawHoop(e,t,n,o,i,a,r){let{space:l}=this,c=e.radius,m=.045*c,h=[t.x-this.focus,c+t.height,n];l.ring({center:h,radius:c,tube:m,broad:3.2*m,angle:t.angle,velocity:[
t.vx,t.vy],omega:t.omega,plain:o.speed?null:ce(a.modes[t.mode])},r);let d=[Math.sin(t.angle),Math.cos(t.angle),0],p=g=>h.map((b,w)=>b+g*d[w]);l.ball(p(c-m),.125*
c,i.dark?[.9,.91,.94]:[.12,.13,.15],r),l.rod(h,d,c-m,.012*c,[.55,.57,.6],r);let f=t.mode==="H";l.ball(p(e.eccentricity*c),.07*c,ce(f?a.airborne:a.gravity_center),
r)}drawForces(e,t,n,o){if(t.mode==="H"||!(t.normal_force>0))return;let i=e.radius,a=e.mass*(e.gravity||9.81),r=[t.x-this.focus,t.height+.03*i,n+.2*i],l=m=>_(.55*
i*Math.abs(m)/a,0,3.2*i),c=Math.sign(t.friction_force);this.space.arrow(r,[0,1,0],l(t.normal_force),i,ce(o.normal_force)),this.space.arrow(r,[c,0,0],l(t.friction_force),
i,ce(o.friction_force))}linesOf(e,t,n){let o=this.lines.get(e);if(o?.dark===t.dark)return o;let i=e.radius,{x:a,height:r,angle:l,mode:c}=e.columns,m=(g,b)=>this.
space.trace(e.length,w=>[a[w]+g*Math.sin(l[w]),i+r[w]+g*Math.cos(l[w])],b),[h,d,p]=[ce(n.gravity_center),ce(n.airborne),ce(t.ink)],f={dark:t.dark,load:m(i,()=>p),
center:m(e.eccentricity*i,g=>c[g]===3?d:h)};return this.lines.set(e,f),f}drawTraces(e,t,n,o,i,a){let{load:r,center:l}=this.linesOf(e,o,i),c=Math.min(e.index(t.t)+
2,e.length),m={shift:this.focus,depth:n};this.space.drawTrace(r,c,{width:a,...m}),this.space.drawTrace(l,c,{width:1.6*a,...m})}};var Wu=["hoop","mode","time","angle","v","R θ̇","gap"],es=class{constructor(e,t){this.colors=e;this.onview=t;this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1};this.plane=u("canvas",{class:"stage-canvas"});this.space=u("canvas",{class:"stage-canvas",hidden:!0});this.flat=new Jn(this.plane,this.onview);
this.deep=null;this.outputs=Wu.map(o=>({name:u("dt",{},o),value:u("dd",{})})),this.outputs[1].value.className="mode",this.fastest=u("span",{}),this.legend=u("di\
v",{class:"legend","aria-hidden":"true"},u("i",{style:`background: linear-gradient(90deg, ${en.filter((o,i)=>i%15===0).join(",")})`}),u("span",{},"0"),u("span",
{},"rim speed"),this.fastest);let n=(o,i)=>u("span",{},u("i",{class:"dot",style:`background:${o}`}),i);this.order=u("span",{hidden:!0},"A in front, B behind"),this.
element=u("div",{class:"stage",role:"figure","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,u("dl",{class:"readout","aria-hidden":"true"},this.outputs.
flatMap(({name:o,value:i})=>[o,i])),this.legend,u("div",{class:"stage-keys","aria-hidden":"true"},n("var(--ink)","load"),n(e.gravity_center,"centre of gravity"),
n(e.airborne,"the same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(e,t,n,{look:o,inks:i}){let{options:a}=this;this.legend.
hidden=!a.speed,this.order.hidden=!(a.three&&e.length>1),this.fastest.textContent=`≥ ${M(Math.max(...e.map(r=>r.extent.speed)),2)} m/s`,a.three?(this.deep??=new Xn(
this.space,this.onview),this.deep.draw(e,n.time,a,o,i,n.playing)):(this.flat.pointed=n.pointed===null?null:{time:n.pointed,lane:t},this.flat.draw(e,n.time,a,o,i)),
this.read(e,t,n.time)}sharp(e,t){let{look:n,inks:o}=e.theme;return this.deep?.draw(e.films(),e.clock.time,this.options,n,o,!1,t),this.space}read(e,t,n){let o=e[t],
i=o.at(n),a=[e.length>1?"AB"[t]:"",k(this.colors.mode_names[i.mode]),be(`${i.t.toFixed(3)} s`),G(i.angle),I(M(i.vx,i.digits),"m/s"),I(M(i.omega*o.radius,i.digits),
"m/s"),i.height>0?Ce(i.height):"0"];for(let[c,m]of a.entries()){let{value:h}=this.outputs[c];h.textContent!==m&&(h.textContent=m)}let[r,l]=this.outputs;r.value.
hidden=r.name.hidden=e.length<2,l.value.style.setProperty("--mode",this.colors.modes[i.mode])}describe(e){let t=e.map(n=>n.summary).join(" ");this.element.setAttribute(
"aria-label",`${k("The hoop.")} ${t}`)}turn(e){let t=()=>{this.plane.hidden=this.options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.
three,t();try{e()}catch(n){throw this.options.three=!1,t(),n}}view(){let{options:e,flat:t,deep:n}=this;return{options:e,zoom:t.zoom,pan:t.pan(),from:n?.from()}}restore({
options:e,zoom:t,pan:n,from:o}){if(e){let{three:i,...a}=e;Object.assign(this.options,a)}this.flat.look(t,n),o&&this.deep?.look(o)}zoom(e){this.options.three?this.
deep?.zoomBy(e):e?this.flat.zoomBy(e):this.flat.reset()}};var ts=class{constructor(e){this.clock=e;this.listed=null;this.summary=u("p",{class:"summary"});this.doubt=u("p",{class:"hint",hidden:!0});this.list=u("ol",{class:"\
story-list"});this.heading=u("h2",{},"What happens");this.signature=u("span",{});this.compared=u("span",{});this.fingerprint=u("p",{class:"hint fingerprint"},this.
signature,this.compared);this.live=u("div",{class:"spoken",role:"status","aria-live":"polite"});this.element=u("section",{class:"story","aria-label":"The motion\
 in words"},this.heading,this.summary,this.doubt,this.list,this.fingerprint,this.live)}draw(e,t,n,o){this.film=e[t],R(this.heading,e.length>1?`What happens to h\
oop ${"AB"[t]}`:"What happens"),this.summary.replaceChildren(...e.flatMap((i,a)=>[e.length>1?u("b",{},`${"AB"[a]}: `):"",i.summary,i.status==="event_limit"||i.shortened?
" (not all events are shown)":"",a+1<e.length?u("br"):""])),this.doubt.hidden=!this.film.doubt,R(this.doubt,this.film.doubt),this.listed!==this.film&&this.fill(
n),this.sign(),this.compared.replaceChildren(...o.flatMap(({same:i,text:a})=>[" ",u("span",{class:i?"same":"differs"},a)])),this.cursor(this.clock.time)}fill(e){
this.listed=this.film,this.current=-1,this.items=this.film.story.map(t=>u("li",{},u("button",{type:"button",onclick:()=>this.clock.seek(t.t),onpointerenter:()=>this.
clock.point(t.t),onpointerleave:()=>this.clock.point(null),onfocus:()=>this.clock.point(t.t),onblur:()=>this.clock.point(null)},u("i",{class:"dot",style:`backgr\
ound:${e.modes[t.mode]}`,"aria-hidden":"true"}),u("span",{class:"when"},`${M(t.t,4)} s`),u("span",{},t.text)))),this.list.replaceChildren(...this.items),this.clock.
pointed=null}sign(){let{fingerprint:e}=this.film;e!==this.signed&&(this.signed=e,this.signature.replaceChildren(...Gu(e)))}say(e){R(this.live,e)}announce(e){this.
say(j(e.map(t=>t.summary).join(" ")))}cursor(e){let{story:t}=this.film,n=-1;for(let i=0;i<t.length&&t[i].t<=e+1e-9;i++)n=i;if(n===this.current)return;this.items[this.
current]?.classList.remove("now"),this.items[n]?.classList.add("now"),this.items[this.current]?.removeAttribute("aria-current"),this.items[n]?.setAttribute("ari\
a-current","step"),this.current=n;let o=this.items[n];if(o){let i=o.offsetTop-this.list.offsetTop;(i<this.list.scrollTop||i+o.offsetHeight>this.list.scrollTop+this.
list.clientHeight)&&(this.list.scrollTop=i-.4*this.list.clientHeight)}}};function Gu(s){if(!s)return[u("span",{},"No fingerprint: this motion depends on more di\
gits than this page computes.")];let e=u("code",{},document.createTextNode(s)),t=u("button",{type:"button"},"Copy");return t.onclick=async()=>{try{await navigator.
clipboard.writeText(s),R(t,"Copied")}catch{getSelection()?.selectAllChildren(e)}},[u("span",{title:"A hash of all events: the same wherever hophoop computes the\
 same bits, also in Python"},"Fingerprint")," ",e," ",t]}var ns=class{constructor(){this.list=u("dl",{});this.heading=u("h2",{},"What theory says");this.element=
u("section",{class:"theory"},this.heading,this.list)}draw(e,t=""){R(this.heading,t?`What theory says of hoop ${t}`:"What theory says"),this.list.replaceChildren(
...e.flatMap(({label:n,text:o})=>[u("dt",{},n),u("dd",{},o)]))}};var Vr="hophoop-theme",Uu=["gravity_center","airborne","normal_force","friction_force"],ss=class{constructor(e,t,n,o){this.root=e;this.colors=t;this.hosted=n;this.
changed=o;this.chosen=null;this.media=matchMedia("(prefers-color-scheme: dark)");this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=io(e),this.inks={...t},this.read()}mark(){let e=this.hosted?se(Vr):null;this.root.dataset.theme=this.chosen??e??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=io(this.root),this.inks={...this.colors};for(let e of Uu)
this.inks[e]=kt(this.colors[e],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&oe(Vr,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};var os=class{constructor(e){this.clock=e;this.window=null;this.canvas=u("canvas",{class:"timeline-canvas"});this.tip=u("div",{class:"tip",hidden:!0});this.element=
u("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),this.element.
addEventListener("pointerdown",t=>this.scrub(t)),this.element.addEventListener("pointermove",t=>this.hover(t)),this.element.addEventListener("pointerleave",()=>this.
tip.hidden=!0),this.pinched=re(this.element,{zoom:(t,n)=>this.zoom(1/t,n?this.timeAt(n):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){let e=[0,this.
clock.duration||1];return!this.window||this.window[1]-this.window[0]>=e[1]?e:Ke(this.window,e)}zoom(e,t){let[n,o]=this.ends(),i=1e-6*this.clock.duration,a=Math.
max((o-n)*e,i),r=(t-n)/(o-n);this.window=a<this.clock.duration?Ke([t-r*a,t+(1-r)*a],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)return;
let[e,t]=this.ends(),{time:n,duration:o}=this.clock;if(n>=e&&n<=t)return;let i=t-e;this.window=Ke(n>t?[n-.1*i,n+.9*i]:[n-.5*i,n+.5*i],[0,o])}timeAt(e){let t=this.
canvas.getBoundingClientRect(),[n,o]=this.ends();return n+_((e.clientX-t.left)/t.width,0,1)*(o-n)}scrub(e){e.preventDefault(),this.element.focus({preventScroll:!0});
let t=this.clock.playing;this.clock.playing=!1;let n=o=>!this.pinched()&&this.clock.seek(this.timeAt(o));n(e),J(this.element,e,n,()=>t&&this.clock.play(!0))}hover(e){
let t=this.timeAt(e),n=this.nearest(t,8),o=n?`${k(Te[n.kind]??n.kind)} · ${M(n.t,5)} s · ${M(n.angle*180/Math.PI,4)}°`:`${M(t,4)} s`;this.tip.textContent=o,this.
tip.hidden=!1;let i=this.canvas.getBoundingClientRect();this.tip.style.left=`${_(e.clientX-i.left,70,i.width-70)}px`}nearest(e,t){let[n,o]=this.ends(),i=t*(o-n)/
(this.canvas.getBoundingClientRect().width||1),a=null;for(let r of this.films??[])for(let l of r.events){if(l.kind==="end")continue;let c=Math.abs(l.t-e);c<=i&&
(!a||c<Math.abs(a.t-e))&&(a=l)}return a}draw(e,t,n){this.films=e;let{context:o,width:i,height:a}=K(this.canvas,t.px);this.keep();let[r,l]=this.ends(),c=w=>(w-r)/
(l-r)*i;o.clearRect(0,0,i,a);let m=15,h=(a-15)/e.length-m;e.forEach((w,y)=>{let v=m+y*(m+h);for(let{mode:E,from:T,wide:L}of La(w.phases,c,i)){let P=n.modes[E];o.
fillStyle=P,o.fillRect(T,v,L,h-2),this.named(o,k(n.mode_names[E]),T,L,v,h-2,P,t)}w.duration<l&&(o.fillStyle=t.line,o.fillRect(Math.max(c(w.duration),0),v,i,h-2)),
this.marks(o,w,c,v,i,t),e.length>1&&(o.fillStyle=ge(y,t.dark),o.font=`700 12px ${t.font}`,o.textAlign="right",o.fillText("AB"[y],i-1,v-4))});let d=V(l-r,i/60);o.
fillStyle=t.soft,o.font=`10.5px ${t.font}`;let p=he(r,l,i/60);for(let w of p){let y=c(w);o.textAlign=y<14?"left":y>i-14?"right":"center",o.fillText(ae(w,d)+(w===
p[0]?" s":""),y,a-3)}let{pointed:f}=this.clock;if(f!==null&&f>=r&&f<=l){let w=_(c(f),2,i-2);o.lineWidth=2;for(let[y,v]of[[t.paper,5],[t.ink,1]])o.fillStyle=y,o.
fillRect(w-.5*v,m-4,v,a-m-9),o.fillRect(w-5-.5*v,m-4,10+v,v)}let g=_(c(this.clock.time),6,i-6),b=_(c(this.clock.time),1,i-1);o.fillStyle=t.ink,o.fillRect(b-1,m-
4,2,a-m-9),o.beginPath(),o.moveTo(g-6,m-10),o.lineTo(g+6,m-10),o.lineTo(b,m-1),o.fill(),this.tell(e,n)}tell(e,t){let{time:n,duration:o,playing:i}=this.clock,r=e.
map((l,c)=>{let m=k(t.mode_names[l.at(n).mode]);return e.length>1?`${"AB"[c]} ${m}`:m}).join(", ");i&&r===this.said||(this.said=r,this.element.setAttribute("ari\
a-valuemax",o.toFixed(3)),this.element.setAttribute("aria-valuenow",n.toFixed(3)),this.element.setAttribute("aria-valuetext",k("{time} seconds, {what}",{time:M(
n,4),what:j(r)})))}named(e,t,n,o,i,a,r,l){e.font=`11px ${l.font}`,!(a<13||e.measureText(t).width+8>o)&&(e.fillStyle=Gi(r),e.textAlign="center",e.textBaseline="m\
iddle",e.fillText(t,n+.5*o,i+.5*a+1),e.textBaseline="alphabetic")}marks(e,t,n,o,i,a){e.font=`11px ${a.font}`,e.textAlign="center";let r=t.events.filter(({kind:l})=>l!==
"start"&&l!=="end").map(({kind:l,t:c})=>({kind:l,x:n(c)})).filter(({x:l})=>l>=-1&&l<=i+1);if(e.fillStyle=a.panel,r.length<i/6)for(let{x:l}of r)e.fillRect(l-.5,o,
1,5);e.fillStyle=a.ink;for(let{mark:l,x:c}of Aa(r))e.fillText(l,_(c,6,i-6),o-4)}};var Ku=1/60,Vu=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],Ju={three:"In space"},De=(s,e,t)=>u(
"button",{type:"button",title:e,"aria-label":e,onclick:t},s),Jr=(s,e)=>u("span",{},u("span",{"aria-hidden":"true"},`${s} `),e),is=class{constructor(e,t,n,o,i){this.
clock=e;this.films=t;this.say=o;this.tell=i;this.titled="";this.playButton=De(Y("play"),"Play (space)",()=>e.play()),this.playButton.classList.add("play"),this.
speeds=u("select",{"aria-label":"Speed of the film",onchange:()=>{e.speed=Number(this.speeds.value)}},At.map(a=>u("option",{value:String(a)},`${a}×`))),this.speeds.
value="1",this.switches=new Map(Vu.map(([a,r,l])=>{let c=`${a==="three"?Ju.three:r} (${l})`;return[a,u("button",{type:"button",class:"switch",title:c,onclick:()=>n(
a)},r)]})),this.row=u("div",{class:"buttons switches"},[...this.switches.values()]),this.element=u("div",{class:"transport"},u("div",{class:"buttons"},De(Y("sta\
rt"),"To the start (Home)",()=>e.seek(0)),De(Y("previous"),"Previous event (Shift ←)",()=>this.jump(-1)),De(Y("back"),"One frame back (←)",()=>this.nudge(-1)),
this.playButton,De(Y("on"),"One frame on (→)",()=>this.nudge(1)),De(Y("next"),"Next event (Shift →)",()=>this.jump(1))),u("div",{class:"buttons jumps"},De(Jr(
"▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),De(Jr("▼","landing"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,this.
row)}show(e){let{clock:t,playButton:n}=this;for(let[i,a]of this.switches)a.setAttribute("aria-pressed",String(e[i]));let o=t.playing?"Pause (space)":"Play (spac\
e)";this.titled!==o&&(this.titled=o,n.replaceChildren(Y(t.playing?"pause":"play")),Xe(n,"title",o),Xe(n,"aria-label",o)),this.speeds.value!==String(t.speed)&&(this.
speeds.value=String(t.speed))}nudge(e){this.clock.playing=!1,this.clock.seek(this.clock.time+e*Ku*Math.min(this.clock.speed,1))}jump(e,t=null){this.clock.playing=
!1;let n=this.films().flatMap((m,h)=>m.events.map(d=>({event:d,lane:h}))).filter(({event:m})=>!t||(t==="impact"?m.kind===t:_a(m))).sort((m,h)=>m.event.t-h.event.
t),o=this.clock.time,i=e>0?n.find(({event:m})=>m.t>o+1e-9):n.findLast(({event:m})=>m.t<o-1e-9);if(!i&&t&&(i=n[0]),!i){t&&this.say(t==="takeoff"?"This motion has\
 no flight.":"This motion has no landing.");return}this.clock.seek(i.event.t);let{event:a,lane:r}=i,l=this.films().length>1?`${k(`Hoop ${"AB"[r]}`)}: `:"",c=k(Te[a.
kind]??a.kind);this.tell(j(`${l}${k("{what} at {angle}, {time} s",{what:c,angle:G(a.angle),time:M(a.t,4)})}`))}};var Yr="hophoop-steps",rt=class{constructor(e,t,n,{hosted:o=!1,panels:i=null,onmotion:a=()=>{}}={}){this.root=e;this.backend=t;this.requested=!1;this.surrounding=
!1;this.taken=null;this.afterFrame=null;this.asked=null;this.frames=0;this.latencies=[];this.hosted=o,this.onmotion=a,sr(e,o);let{colors:r}=n;this.known=n.presets,
this.sameness=new Gn(n.presets),this.clock=new rn,this.motions=new In(t,{shown:l=>this.changed(l),refined:()=>this.request(),settled:()=>this.story.announce(this.
films()),noted:l=>this.noted(l),travelled:async l=>this.address?.travel(l),failed:(l,c)=>this.failed(l,c)}),this.notice=new qn,this.address=o?new on(this.motions,
this.notice,()=>this.link()):null,this.theme=new ss(e,r,o,()=>this.show()),this.stage=new es(r,()=>{this.request(),this.address?.soon()}),this.transport=new is(
this.clock,()=>this.films(),l=>this.toggle(l),l=>this.notice.say(l),l=>this.story.say(l)),this.timeline=new os(this.clock),this.story=new ts(this.clock),this.theory=
new ns,this.plots=new Wn(this.clock,r),this.phase=new $n(t,this.clock,r),this.map=new Dn(t,n,{take:l=>{this.clock.time=0,this.motions.change(l,!0)},say:l=>this.
story.say(l),changed:()=>this.address?.soon()}),this.controls=new cn(n.controls,(l,c)=>this.motions.change(l,c)),this.share=new Kn(this),this.singleKeys=new zn(
o),this.about=Wa(n.version,o),this.help=Ga(this.about,r,this.singleKeys.element),this.view=new Pn(e,o,()=>this.show()),this.hoops=new Cn(l=>this.motions.choose(
l)),this.header=new Ln(n.presets,this.share.menu,this.view.button,{take:l=>this.take(l),undo:()=>this.travel(-1),redo:()=>this.travel(1),compare:()=>this.motions.
compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.extras=new An(this),this.opening=new Rn(this.clock,this.extras.grips.hint),this.sticky=
or(this,i),o&&!location.search&&!location.hash&&this.extras.visit.offer(),this.later=ie(()=>this.fetchTheory(),120),this.frame=this.frame.bind(this),this.clock.
listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=tr(this,o),this.sizes=new ResizeObserver(()=>this.show())}async open(e,t={}){
await this.motions.load(e),this.clock.duration=Math.max(...this.films().map(n=>n.duration)),this.sameness.expect(this.films(),t.fingerprints??[]),this.view.open(
this.films(),t),this.restore(t),this.begin(),this.hosted&&t.time===void 0&&!this.view.everything&&this.opening.begin(this.stage.element.parentElement)}begin(){this.
show();let e=this.hosted?Ji(Yr):null;this.motions.note(),e&&(this.motions.history.restore(e),this.noted("same")),this.sizes.observe(this.stage.element),this.root.
dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.close(),this.opening.end(),this.map.close(),this.theme.close(),this.address?.
close(),this.sticky?.close(),this.sizes.disconnect(),this.deaf()}film(e=this.motions.active){return this.motions.film(e)}films(){return this.motions.films()}changed(e=null){
this.notice.clear(),this.show(e)}failed(e,t=[]){this.controls.refuse(t,e.message)||(this.notice.fail(e),this.controls.restore()),this.showPreset()}noted(e){this.
header.show(this.motions.history,this.motions.lanes.length>1),this.address?.write(e),this.hosted&&Yi(Yr,this.motions.history.written()),this.onmotion(this.film().
query)}link(e=this.sameness.expected(this.films())){let{clock:t,stage:n,map:o,extras:i}=this,{on:a,path:r}=i.more;return this.motions.link(ha({time:t.time,...n.
view(),more:a?r:void 0,map:o.shown(),fingerprints:e}))}restore({time:e,map:t,options:n,more:o,...i}){n?.three&&this.toggle("three"),this.stage.restore({options:n,
...i}),t&&this.map.restore(t),o&&this.extras.more.turn(!0,o),e&&this.clock.seek(e)}showPreset(){let{query:e}=this.film(),t=this.known.find(n=>n.query===e);this.
header.presets.value=t?.key??"",R(this.hoops.text,t?.text??"")}async take(e){this.taken=e;try{let t=await this.backend.film({query:e.query});if(this.taken!==e)return;
this.clock.time=0,this.motions.replace(t),this.story.announce(this.films())}catch(t){this.failed(t)}}async load(e){try{let t=await this.backend.film({query:e});
this.clock.play(!1),this.clock.time=0,this.motions.replace(t)}catch(t){this.notice.fail(t)}}mark(e,t){this.root.classList.toggle(e,t)}marked(e){return this.root.
classList.contains(e)}travel(e){return this.motions.travel(e)}show(e=null){let{motions:t,clock:n}=this,o=this.films();if(!o.length)return;let i=o.length>1;this.
theme.read(),n.duration=Math.max(...o.map(a=>a.duration)),n.time=Math.min(n.time,n.duration),this.root.classList.toggle("two",i),this.header.show(t.history,i),this.
hoops.show(o.length,t.active),this.drawStage(),this.controls.show(this.film(),this.motions.waiting()),this.view.show(o),this.showPreset(),e!==null&&requestAnimationFrame(
()=>setTimeout(()=>this.latencies.push(performance.now()-e),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),
0)))}showSurroundings(){this.surrounding=!1;let e=this.films(),{active:t}=this.motions,{look:n,colors:o}=this.theme;this.plots.draw(e,t,n),this.phase.draw(e,t,n),
this.story.draw(e,t,o,this.sameness.of(e[t])),this.drawTime(),this.map.mark(this.film(),n),this.stage.describe(e),this.extras.changed(),this.later()}drawStage(){
this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){let{time:e}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.
theme.look,this.theme.colors),this.plots.cursor(e),this.phase.cursor(e),this.story.cursor(e),this.transport.show(this.stage.options))}request(){this.requested||
(this.requested=!0,requestAnimationFrame(this.frame))}frame(e){this.requested=!1,this.motions.lanes.length&&(this.clock.tick(e),this.motions.refine(this.clock.time,
this.clock.playing?2*this.clock.speed:0),this.drawStage(),this.drawTime(),this.extras.frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){
let{scenario:e}=this.film();this.asked?.abort(),this.asked=new AbortController;let{signal:t}=this.asked;try{this.theory.draw(await this.backend.theory(e,t),this.
motions.name()),await this.phase.fetch(e,t)}catch(n){let{name:o,message:i}=n;o!=="AbortError"&&this.theory.draw([{label:"–",text:i}])}}toggle(e){let{options:t}=this.
stage;if(e!=="three")t[e]=!t[e];else try{this.stage.turn(()=>this.drawStage())}catch(n){this.notice.say(n.message)}this.transport.show(t),this.address?.soon(),this.
request()}};var Yu={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function Ft(s){let e=s instanceof DataView||ArrayBuffer.isView(s)?s:new DataView(s),t=new Uint8Array(e.buffer,
e.byteOffset,e.byteLength);t.byteOffset%8&&(t=t.slice());let n=new DataView(t.buffer,t.byteOffset).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(t.subarray(
4,4+n))),i={};for(let{name:a,type:r,shape:l,place:c}of o.arrays){let m=l.reduce((h,d)=>h*d,1);i[a]=new Yu[r](t.buffer,t.byteOffset+4+n+c,m)}return{header:o,arrays:i}}var Zu=4,Qu="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.",as=class{constructor(e){this.base=e}async motion(e,t){
let n={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),signal:t};return Ft(await(await this.answered(new URL("lab/motion",this.
base),n)).arrayBuffer())}async file(e,t){return(await this.answered(new URL(`api/v1/files/${e}?${t}`,this.base))).blob()}async answered(e,t){for(let n=Zu;;n--){
let o=await fetch(e,t).catch(a=>{throw a.name==="AbortError"?a:new Error(Qu)});if(o.ok)return o;let i=Number(o.headers.get("Retry-After"));if(o.status!==503||!(i>
0)||n<=1){let a=await o.json().catch(()=>({}));throw new Error(a.detail??`The server answered ${o.status}.`)}await new Promise(a=>setTimeout(a,1e3*Math.min(i,10))),
t?.signal?.throwIfAborted()}}},Xu=2e4,ed=3e5,rs=class{constructor(e){this.model=e;this.waiting=new Map;this.number=0;this.view=Math.random().toString(36).slice(
2);this.listen=(t,n)=>this.answered(t,n),e.on("msg:custom",this.listen)}answered(e,t){let n=e?.view===this.view&&this.waiting.get(e.number);n&&(clearTimeout(n.timer),
this.waiting.delete(e.number),e.error?n.reject(new Error(e.error)):n.resolve(Ft(t[0])))}ask(e,t,n){let o=++this.number;return new Promise((i,a)=>{let r=setTimeout(
()=>{this.waiting.delete(o),a(new Error("The notebook’s kernel does not answer; run the cell again."))},e==="file"?ed:Xu);this.waiting.set(o,{resolve:i,reject:a,
timer:r}),n?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(o),a(new DOMException("superseded","AbortError"))}),this.model.send({view:this.view,
number:o,call:e,body:t})})}motion(e,t){return this.ask("motion",e,t)}async file(e,t){let{arrays:n}=await this.ask("file",{query:t,name:e});return new Blob([n.content])}async derivatives(){
return(await this.ask("derivatives",{})).arrays.content}close(){this.model.off("msg:custom",this.listen)}};var qo=class extends Error{},Fo=class{constructor(e,t){this.start=e;this.compiled=t;this.number=0;this.waiting=null;this.worker=this.begun()}begun(){let e=this.
start();return e.onmessage=({data:t})=>{if(t.number!==this.number||!this.waiting)return;let{resolve:n,reject:o}=this.waiting;this.waiting=null,t.error?o(new Error(
t.error)):n(t.answer)},e.onerror=t=>this.fail(new Error(t.message||"The kernel could not be started.")),e.postMessage({compiled:this.compiled}),e}fail(e){this.waiting?.
reject(e),this.waiting=null}stop(e){this.worker.terminate(),this.worker=this.begun(),this.fail(e)}ask(e,t,n){this.number++;let o=new Promise((i,a)=>{this.waiting=
{resolve:i,reject:a}});return this.worker.postMessage({number:this.number,call:e,values:t},n),o}},lt=class{constructor(e,t,n,o){this.start=e;this.compiled=t;this.
size=n;this.limit=o;this.idle=[];this.hired=0;this.queue=[]}hand(){let e=this.idle.pop();return e?Promise.resolve(e):this.hired<this.size?(this.hired++,Promise.
resolve(new Fo(this.start,this.compiled))):new Promise(t=>this.queue.push(t))}release(e){let t=this.queue.shift();t?t(e):this.idle.push(e)}async ask(e,t,n,o=[]){
n?.throwIfAborted();let i=await this.hand(),a=()=>i.stop(new DOMException("superseded","AbortError")),r=setTimeout(()=>i.stop(new qo(`This takes longer than ${this.
limit/1e3} s, and was stopped.`)),this.limit);try{return n?.throwIfAborted(),n?.addEventListener("abort",a),await i.ask(e,t,o)}finally{clearTimeout(r),n?.removeEventListener(
"abort",a),this.release(i)}}close(){for(let e of this.idle)e.worker.terminate()}};var ls=class{constructor(e){this.exports=e;this.rooms=new Map}room(e,t){let n=this.rooms.get(e);if(n&&n.bytes>=t)return n.place;n&&this.exports.free(n.place),this.
rooms.delete(e);let o=this.exports.malloc(t);if(!o)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:o,bytes:t}),
o}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let n=this.room(e,8*Math.max(t.length,1));return this.floats(n,t.length).set(t),n}};var td=150,nd=240,sd=6e3,[by,Zr,Qr]=[0,1,2],od={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["fri\
ction_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_norm\
al","damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function Ho(s,e,t){let{rows:n,count:o,duration:i}=e,[a,r]=(t??[0,i]).map(b=>Math.
min(Math.max(b,0),i)),l=Math.min(Math.max(Math.ceil((r-a)*td),nd),sd),c=x.events.length,m=new Set;for(let b=0;b<=l&&i>0;b++)m.add(b===l?r:a+b*((r-a)/l));let h=new Set;
for(let b=0;b<o;b++){let w=Math.min(n[b*c+B.t],i);w>=a&&w<=r&&h.add(w)}for(let b of h)m.add(b);let d=Float64Array.from(m).sort(),p=Float64Array.from(h).filter(b=>b>
0).sort(),f=s.states(e,d,!1),g=s.states(e,p,!0);return jo(d,f,p,g)}function jo(s,e,t,n){let o=s.length+t.length,i=x.samples.length,a=new Float64Array(o),r=new Float64Array(
o*i),l=0,c=0;for(let h=0;h<s.length;h++)c<t.length&&t[c]<=s[h]&&(a[l]=t[c],r.set(n.subarray(c*i,(c+1)*i),l*i),l++,c++),a[l]=s[h],r.set(e.subarray(h*i,(h+1)*i),l*
i),l++;let m={t:a};for(let[h,d]of Object.entries(od)){let p=new Float64Array(o).fill(-0);for(let f of d)for(let g=0;g<o;g++)p[g]+=r[g*i+ms[f]];m[h]=p}return m.mode=
id(r,o,m.omega),m}function id(s,e,t){let n=x.samples.length,o=new Float64Array(e),i=0;for(let a=e-1;a>=0&&!i;a--)i=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){i=
Math.sign(t[a])||i;let r=s[a*n+ms.mode],l=r===Zr?-1:r===Qr?1:0;o[a]=l===0?r:l*i<0?Zr:Qr}return o}var ad=s=>s/2**32|0,rd=s=>s>>>0;function Xr(s,e,t,n){let o=ad(t),i=rd(t);s.setUint32(e,n?i:o,n),s.setUint32(e+4,n?o:i,n)}function el(s){return s instanceof Uint8Array||ArrayBuffer.isView(s)&&s.constructor.name==="Uint8Array"&&"BYTES_PER_ELEMENT"in s&&s.BYTES_PER_ELEMENT===1}var Bo=s=>s?
`"${s}" `:"";function ld(s,e=""){if(typeof s!="number")throw new TypeError(Bo(e)+"expected number, got "+typeof s);if(!Number.isSafeInteger(s)||s<0)throw new RangeError(
Bo(e)+"expected integer >= 0, got "+s);return s}function $o(s,e,t=""){if(el(s)&&(e===void 0||s.length===e))return s;e!==void 0&&ld(e,"length");let n=el(s),o=e!==void 0?` of length ${e}`:"",i=n?`length=${s.length}`:
`type=${typeof s}`,a=Bo(t)+"expected Uint8Array"+o+", got "+i;throw n?new RangeError(a):new TypeError(a)}var hd=(s,e)=>{if(s===null||typeof s!="object"||Array.isArray(s))throw new TypeError((e==="object"?"":`"${e}" `)+"expected object, got type="+typeof s)},tl=(s,e)=>{
hd(s,e);let t=Object.getPrototypeOf(s);if(t!==Object.prototype&&t!==null)throw new TypeError(`"${e}" expected plain object`);if(Object.hasOwn(s,"__proto__"))throw new TypeError(
`"${e}.__proto__" is not allowed`)};function Wo(s,e=!0){if(s.destroyed)throw new Error("hash was destroyed");if(e&&s.finished)throw new Error("digest() was alre\
ady called")}function nl(s,e){$o(s,void 0,"output");let t=e.outputLen;if(!(s.length>=t))throw new RangeError('"output" expected length >= '+t)}function Go(...s){for(let e=0;e<s.length;e++)s[e].fill(0)}function hs(s){return new DataView(s.buffer,s.byteOffset,s.byteLength)}function ue(s,e){return s<<32-e|
s>>>e}function cd(s,e,t="opts"){return tl(s,"defaults"),e!==void 0&&tl(e,t),Object.assign(Object.create(null),s,e)}function sl(s,e={}){if(typeof s!="function")throw new TypeError(
'"hashCons" expected function, got type='+typeof s);e=cd({},e,"info");let t=(o,i)=>s(i).update(o).digest(),n=s(void 0);return t.outputLen=n.outputLen,t.blockLen=
n.blockLen,t.canXOF=n.canXOF,t.create=o=>s(o),Object.assign(t,e),Object.freeze(t)}var ol=s=>({oid:Uint8Array.from([6,9,96,134,72,1,101,3,4,2,s])});function il(s,e,t){return s&e^~s&t}function al(s,e,t){return s&e^s&t^e&t}var cs=class{blockLen;outputLen;canXOF=!1;padOffset;isLE;buffer;view;finished=!1;length=0;pos=0;destroyed=!1;constructor(e,t,n,o){
this.blockLen=e,this.outputLen=t,this.padOffset=n,this.isLE=o,this.buffer=new Uint8Array(e),this.view=hs(this.buffer)}update(e){Wo(this),$o(e);let{view:t,buffer:n,
blockLen:o}=this,i=e.length,a=!1;for(let r=0;r<i;){let l=Math.min(o-this.pos,i-r);if(l===o){let c=hs(e);for(;o<=i-r;r+=o)this.process(c,r);a=!0;continue}n.set(r===
0&&l===i?e:e.subarray(r,r+l),this.pos),this.pos+=l,r+=l,this.pos===o&&(this.process(t,0),this.pos=0,a=!0)}return this.length+=e.length,a&&this.roundClean(),this}digestInto(e){
Wo(this),nl(e,this),this.finished=!0;let{buffer:t,view:n,blockLen:o,isLE:i}=this,{pos:a}=this;t[a++]=128,t.fill(0,a),this.padOffset>o-a&&(this.process(n,0),t.fill(
0)),Xr(n,o-8,this.length*8,i),this.process(n,0),this.roundClean();let r=e===t?n:hs(e),l=this.outputLen,c=l/4,m=this.get();if(l%4||c>m.length)throw new Error("in\
valid outputLen");for(let h=0;h<c;h++)r.setUint32(4*h,m[h],i)}digest(){let{buffer:e,outputLen:t}=this;this.digestInto(e);let n=e.slice(0,t);return this.destroy(),
n}_cloneIntoMeta(e){let{buffer:t,length:n,finished:o,destroyed:i,pos:a}=this;return e.destroyed=i,e.finished=o,e.length=n,e.pos=a,a&&e.buffer.set(t),e}clone(){return this.
_cloneInto()}},rl=Uint32Array.from([1779033703,3144134277,1013904242,2773480762,1359893119,2600822924,528734635,1541459225]);var ud=Uint32Array.from([1116352408,1899447441,3049323471,3921009573,961987163,1508970993,2453635748,2870763221,3624381080,310598401,607225278,1426881987,1925078388,
2162078206,2614888103,3248222580,3835390401,4022224774,264347078,604807628,770255983,1249150122,1555081692,1996064986,2554220882,2821834349,2952996808,3210313671,
3336571891,3584528711,113926993,338241895,666307205,773529912,1294757372,1396182291,1695183700,1986661051,2177026350,2456956037,2730485921,2820302411,3259730800,
3345764771,3516065817,3600352804,4094571909,275423344,430227734,506948616,659060556,883997877,958139571,1322822218,1537002063,1747873779,1955562222,2024104815,2227730452,
2361852424,2428436474,2756734187,3204031479,3329325298]),Oe=new Uint32Array(64),Uo=class extends cs{A=0;B=0;C=0;D=0;E=0;F=0;G=0;H=0;constructor(e,t){super(64,e,
8,!1),this.A=t[0]|0,this.B=t[1]|0,this.C=t[2]|0,this.D=t[3]|0,this.E=t[4]|0,this.F=t[5]|0,this.G=t[6]|0,this.H=t[7]|0}get(){let{A:e,B:t,C:n,D:o,E:i,F:a,G:r,H:l}=this;
return[e,t,n,o,i,a,r,l]}set(e,t,n,o,i,a,r,l){this.A=e|0,this.B=t|0,this.C=n|0,this.D=o|0,this.E=i|0,this.F=a|0,this.G=r|0,this.H=l|0}_cloneInto(e){return(e||=new this.
constructor).set(...this.get()),this._cloneIntoMeta(e)}process(e,t){for(let h=0;h<16;h++,t+=4)Oe[h]=e.getUint32(t,!1);for(let h=16;h<64;h++){let d=Oe[h-15],p=Oe[h-
2],f=ue(d,7)^ue(d,18)^d>>>3,g=ue(p,17)^ue(p,19)^p>>>10;Oe[h]=g+Oe[h-7]+f+Oe[h-16]|0}let{A:n,B:o,C:i,D:a,E:r,F:l,G:c,H:m}=this;for(let h=0;h<64;h++){let d=ue(r,6)^
ue(r,11)^ue(r,25),p=m+d+il(r,l,c)+ud[h]+Oe[h]|0,g=(ue(n,2)^ue(n,13)^ue(n,22))+al(n,o,i)|0;m=c,c=l,l=r,r=a+p|0,a=i,i=o,o=n,n=p+g|0}n=n+this.A|0,o=o+this.B|0,i=i+
this.C|0,a=a+this.D|0,r=r+this.E|0,l=l+this.F|0,c=c+this.G|0,m=m+this.H|0,this.set(n,o,i,a,r,l,c,m)}roundClean(){Go(Oe)}destroy(){this.destroyed=!0,this.set(0,0,
0,0,0,0,0,0),Go(this.buffer)}},Ko=class extends Uo{constructor(){super(32,rl)}};var ll=sl(()=>new Ko,ol(1));var hl=["t","x","height","angle","vx","vy","omega","slip"],dd=16,md=0x7ff8000000000000n;function cl(s,e){let t=new TextEncoder,n=ll.create(),o=new DataView(new ArrayBuffer(
8*hl.length)),i=new Uint8Array(o.buffer);for(let r=0;r<e;r++){let l=r*x.events.length;n.update(t.encode(x.kinds[s[l+B.kind]])),hl.forEach((c,m)=>{let h=s[l+B[c]];
Number.isNaN(h)?o.setBigUint64(8*m,md,!0):o.setFloat64(8*m,h+0,!0)}),n.update(i)}return Array.from(n.digest(),r=>r.toString(16).padStart(2,"0")).join("").slice(
0,dd)}function ul(s,e){let t=new Map,n=new Float64Array(e);for(let o=0;o<e;o++){let i=pd(s.subarray(o*x.keys,(o+1)*x.keys));if(i===""){n[o]=Number.NaN;continue}let a=t.
get(i);a===void 0&&(a=t.size,t.set(i,a)),n[o]=a}return{values:n,sequences:[...t.keys()]}}function pd(s){let e="";for(let t of s){let n=t;for(let o=0;o<x.letters_a_key&&
n;o++){let i=Number(n&7n);n>>=3n,i&&(e+=i===x.more?"+":x.letters[i-1])}}return e}var fd=256,gd=2048,bd=4096,wd=2e5,yd=x.statuses.indexOf("buffer"),vd=2,kd=new Set(x.passing),Vo=s=>Number.isFinite(s)?s:null,us=class{constructor(e){this.kept=[];
this.turn=0;this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new ls(this.exports),this.mostEvents=fd,this.mostSegments=
gd,this.mostRows=bd}call(e,...t){let n=this.exports[e](...t);if(n)throw new Error(`The kernel ended ${e} with ${n}.`)}compute(e){let{memory:t}=this,n=x.events.length;
for(;;){let o=t.room("table",8*n*this.mostEvents),i=t.room("heads",8*x.heads.length);e.contact?this.computeCompliant(e,e.contact,o,i):this.computeRigid(e,o,i);let a=t.
floats(i,x.heads.length).slice(),r=a[de.events];if(a[de.status]===yd)this.makeRoom(e,a[de.segments]);else if(r===this.mostEvents&&r<e.max_events)this.mostEvents*=
4;else{let l=t.floats(o,r*n).slice();return{given:e,head:a,rows:l,count:r,duration:a[de.duration],segments:a[de.segments]}}}}computeRigid(e,t,n){let{memory:o}=this,
i=o.put("cell",Ae(e)),a=o.room("events",x.event_bytes*this.mostEvents),r=o.room("segments",x.segment_bytes*this.mostSegments);this.call("motion",i,a,this.mostEvents,
r,this.mostSegments,t,n)}computeCompliant(e,t,n,o){let{memory:i}=this,a=i.put("cell",Ae(e)),r=i.put("contact",ct(t)),l=i.room("events",x.event_bytes*this.mostEvents),
c=i.room("rows",x.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,r,l,this.mostEvents,wd,c,this.mostRows,n,o)}makeRoom(e,t){e.contact?this.
mostRows=t:this.mostSegments*=4}motion(e){return dl(this.compute(e))}film(e){let t=this.compute(e),[n,o]=e.contact?["rows",x.compliant_segment_bytes]:["segments",
x.segment_bytes],i=this.memory.room(n,8),a=new Uint8Array(this.exports.memory.buffer,i,o*t.segments).slice();return{motion:dl(t),columns:Ho(this,t),pieces:a}}instant(e,t,n){
let o=t.length/(e.contact?x.compliant_segment_bytes:x.segment_bytes);this.memory.put("cell",Ae(e)),e.contact&&this.memory.put("contact",ct(e.contact));let i=Float64Array.
of(n),a=this.states({given:e,segments:o},i,!1,this.placeOf(t)),r=new Float64Array(0);return jo(i,a,r,r)}placeOf(e){let t=this.kept.find(i=>i.pieces===e);if(t)return t.
place;let{turn:n}=this;this.turn=(n+1)%vd;let o=this.memory.room(`pieces ${n}`,Math.max(e.length,1));return new Uint8Array(this.exports.memory.buffer,o,e.length).
set(e),this.kept[n]={pieces:e,place:o},o}columns(e,t){return Ho(this,this.compute(e),t)}samples(e,t){let n=this.states(this.compute(e),t,!1),o=x.samples.length;
return Object.fromEntries(x.samples.map((i,a)=>[i,Float64Array.from(t,(r,l)=>n[l*o+a])]))}states(e,t,n,o){return this.rows("samples",x.samples.length,e,t,n,o)}margins(e,t,n=!1){
if(e.contact)throw new TypeError("A compliant contact has no such rules.");let o=x.margins.length,i=this.rows("margins",o,this.compute(e),t,n);return Object.fromEntries(
x.margins.map((a,r)=>[a,Float64Array.from(t,(l,c)=>i[c*o+r])]))}rows(e,t,n,o,i,a){let{memory:r}=this,l=o.length*t,c=r.put("times",o),m=r.room("states",8*Math.max(
l,1)),h=r.room("cell",8),d=[n.segments,c,o.length,Number(i),m];return n.given.contact?this.call("compliant_samples",h,r.room("contact",8),a??r.room("rows",8),...d):
this.call(e,h,a??r.room("segments",8),...d),r.floats(m,l).slice()}changes(e,t){let{memory:n}=this,o=this.compute(e),i=n.put("rates",t),a=this.side(o,i,1),{reason:r,
sided:l}=a,c=l||r==="border"||r==="contact"?this.side(o,i,-1):a;return{count:o.count,larger:a,smaller:c}}side({count:e,segments:t,head:n},o,i){let{memory:a}=this,
r=e*x.changes.length,l=a.room("changes",8*r),c=a.room("why",16),[m,h,d]=["cell","events","segments"].map(b=>a.room(b,8)),p=n[de.doubt_from];this.call("changes",
m,o,1,i,h,e,d,t,p,l,c);let[f,g]=a.floats(c,2);return{rates:a.floats(l,r).slice(),reason:x.reasons[Math.max(f,0)],sided:f<0,failed:g}}thresholds(e){let{memory:t}=this,
n=t.put("cell",Ae(e)),o=t.room("answers",8*x.thresholds.length),i=e.rolling&&e.angle===0;this.call("thresholds",n,i?e.vx:Number.NaN,o);let a=t.floats(o,x.thresholds.
length),r=c=>{let m=a[x.thresholds.indexOf(c)];return Number.isNaN(m)?null:m},l=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(r);return{first_slip_speed:r(
"first_slip_speed"),first_hop_speed:r("first_hop_speed"),immediate_hop_speed:r("immediate_hop_speed"),needed_friction:r("needed_friction"),painleve_friction:r("\
painleve_friction"),painleve_angle:r("painleve_angle"),jam_angles:l.filter(c=>c!==null),stable_angle:r("stable_angle"),massless_loss_angle:r("massless_loss_angl\
e"),massless_loss_by_friction:r("massless_loss_by_friction")===1}}regions(e,[t,n,o,i],a,r){let{memory:l}=this,c=l.put("cell",Ae(e)),m=l.room("modes",a*r),h=l.room(
"sides",2*a);this.call("regions",c,t,n,o,i,a,r,m,h);let{buffer:d}=this.exports.memory;return{modes:new Uint8Array(d,m,a*r).slice(),paradox:Float32Array.from(new Int8Array(
d,h,2*a))}}map({count:e,rows:t},n,o){let{memory:i}=this,a=i.put("cells",t),r=i.room("numbers",8*e*x.numbers.length),l=i.room("words",4*e*x.words.length),c=i.room(
"keys",8*e*x.keys),{angle:m,stop:h,timed:d}=x.spans[o],p=x.wanted[n];this.call("map_cells",a,e,m??Number.NaN,h,d,p,r,l,c);let{buffer:f}=this.exports.memory;if(n===
"sequence")return ul(new BigUint64Array(f,c,e*x.keys),e);let g=new Float64Array(e);if(n in ps){let b=new Int32Array(f,l,e*x.words.length);for(let w=0;w<e;w++)g[w]=
b[w*x.words.length+ps[n]]}else{let b=i.floats(r,e*x.numbers.length);for(let w=0;w<e;w++)g[w]=b[w*x.numbers.length+oi[n]]}return{values:g}}ideal(e){let t=this.memory.
room("answers",8*x.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}refused(e){let t=this.memory.put("cell",Ae(e)),n=this.memory.
put("contact",ct(e.contact)),o=this.memory.room("answers",8*x.thresholds.length);this.call("refused",t,n,+!e.contact,o);let[i,a]=this.memory.floats(o,2);return[
i,a]}combine(e,t){let{memory:n}=this,o=n.put("parts",t.flatMap(xd)),i=n.room("answers",8*x.thresholds.length),a=n.room("reaches",8*t.length);this.call("hoop_of_\
parts",e,o,t.length,i,a);let[r,l,c]=n.floats(i,3);return{mass:r,eccentricity:l,inertia_ratio:c,reaches:[...n.floats(a,t.length)]}}chosen(e){let t=this.memory.put(
"cell",Ae(e)),n=this.memory.put("contact",ct(e.contact)),o=this.memory.room("answers",8*x.thresholds.length);this.call("compliance",t,n,o);let i=this.memory.floats(
o,x.chosen.length);return Object.fromEntries(x.chosen.map((a,r)=>[a,i[r]]))}};function xd(s){let e=s.shape==="rod"?`${s.direction}_rod`:s.shape,t=x.shapes.indexOf(
e);return s.shape==="ring"?[t,s.mass,s.inner_radius,s.outer_radius,0]:s.shape==="disk"?[t,s.mass,s.radius,0,s.at]:s.shape==="rod"?[t,s.mass,s.length,0,s.at]:[t,
s.mass,0,0,s.at]}var _d=["friction","impact_normal","impact_tangential","rolling_resistance"],Ed=["kinetic","potential",..._d,"residual"],ml=["x","height","angl\
e","vx","vy","omega"];function dl({given:s,head:e,rows:t,count:n,duration:o}){let i=x.events.length,a=Array.from({length:n},(m,h)=>Md(t.subarray(h*i,(h+1)*i))),
r=a[n-1],l=Object.fromEntries([...Ed,...s.contact?["spring","damping"]:[]].map(m=>[m,e[de[m]]])),c=Vo(e[de.doubt_from]);return{status:x.statuses[e[de.status]],sequence:Sd(
a),fingerprint:c===null?cl(t,n):null,duration:o,events:a,final:{t:r.t,mode:r.to,...Object.fromEntries(ml.map(m=>[m,r[m]]))},energy:l,doubt:c}}function Md(s){let e=x.
kinds[s[B.kind]],t=s[B.from_mode],n={t:s[B.t],kind:e,from:t<0?null:x.letters[t],to:x.letters[s[B.to_mode]]};for(let o of ml)n[o]=Vo(s[B[o]]);return n.before=Object.
fromEntries(["vx","vy","omega"].map(o=>[o,Vo(s[B[`before_${o}`]])])),n.impulse={normal:s[B.impulse_normal],tangential:s[B.impulse_tangential]},s[B.collision]===
0&&(n.collision=!1),e==="kane_gain"&&(n.gain=s[B.gain]),s[B.stable]>=0&&(n.stable=s[B.stable]===1),n}function Sd(s){let e=s.filter((n,o)=>o===s.length-1||!kd.has(
n.kind));return e.slice(0,-1).map((n,o)=>e[o+1].t>n.t?n.to:"").join("")||(s.at(-1)?.to??"")}var Jo=1e4,Td="The part of the page that computes this could not be loaded; choose it again when there is a network.",Yo=256;function pl(s){let e=URL.createObjectURL(
new Blob([s],{type:"text/javascript"}));return()=>new Worker(e,{type:"module"})}async function fl(s){let e=await fetch(s);if(!e.ok)throw new Error(`The kernel i\
s not there: ${s.pathname} gives ${e.status}.`);return e.headers.get("Content-Type")==="application/wasm"?WebAssembly.compileStreaming(e):WebAssembly.compile(await e.
arrayBuffer())}async function gl(s){let e=new Blob([s]).stream().pipeThrough(new DecompressionStream("gzip"));return WebAssembly.compile(await new Response(e).arrayBuffer())}
var Ht=class s{constructor(e,t,n){this.start=t;this.derivatives=n;this.rates=null;this.mechanics=new us(e),this.motions=new lt(t,e,2,Jo);let o=navigator.hardwareConcurrency||
2;this.maps=new lt(t,e,Math.max(1,Math.min(o-1,8)),Jo)}static async load(e){let t=await fl(new URL(`hophoop.wasm?${x.module}`,e)),n=()=>fl(new URL(`hophoop-deri\
vatives.wasm?${x.derivatives}`,e)),o=new URL(`kernel.js?${x.module}`,e);return o.origin===globalThis.location?.origin?new s(t,()=>new Worker(o,{type:"module"}),
n):new s(t,pl(await(await fetch(o)).text()),n)}static async unpack(e,t,n){return new s(await gl(e),pl(t),async()=>gl(await n()))}motion(e,t){return this.motions.
ask("motion",[e],t)}film(e,t){return this.motions.ask("film",[e],t)}columns(e,t,n){return this.motions.ask("columns",[e,n],t)}samples(e,t,n){return this.motions.
ask("samples",[e,t],n)}async changes(e,t,n){return this.rates??=this.derivatives().then(i=>new lt(this.start,i,1,Jo)),(await this.rates.catch(()=>{throw this.rates=
null,new Error(Td)})).ask("changes",[e,t],n)}thresholds(e,t){return this.motions.ask("thresholds",[e],t)}regions(e,t,n,o,i){return this.motions.ask("regions",[e,
t,n,o],i)}async map({count:e,rows:t},n,o,i){let a=x.cell.length,r=new Float64Array(e).fill(Number.NaN),l=[],c=async h=>{let d=Math.min(Yo,e-h),p=new Float64Array(
a*d);for(let b=0;b<a;b++)p.set(t.subarray(b*e+h,b*e+h+d),b*d);let f=await this.maps.ask("map",[{count:d,rows:p},n,o],i,[p.buffer]),g=f.sequences?.map(b=>(l.includes(
b)||l.push(b),l.indexOf(b)));for(let b=0;b<d;b++)r[h+b]=g?g[f.values[b]]??Number.NaN:f.values[b]},m=Array.from({length:Math.ceil(e/Yo)},(h,d)=>d*Yo);return await Promise.
all(m.map(c)),n==="sequence"?{values:r,sequences:l}:{values:r}}close(){this.motions.close(),this.maps.close(),this.rates?.then(e=>e.close()).catch(()=>{})}};var Ad=360,Ld=240,Zo={"motion.toml":"application/toml","motion.csv":"text/csv; charset=utf-8","motion.json":"application/json"},Rd=["motion.nc","motion.mp4","mo\
tion.gif"],ds=class{constructor(e,t,{base:n=null,python:o=null}={}){this.kernel=e;this.mechanics=t;this.base=n,this.python=o,this.shares=n!==null,this.files=[...Object.
keys(Zo),...o?Rd:[]]}async film(e,t){t?.throwIfAborted();let n=ne(e,this.mechanics),o=Z(Ee(n)),{python:i}=this,{motion:a,columns:r,pieces:l}=this.kernel.film?await this.
kernel.film(o,t):{motion:await this.kernel.motion(o,t),columns:await this.kernel.columns(o,t),pieces:null},{doubt:c}=a;if(c!==null&&i){let p=bt(n),f=async g=>(await i.
motion({query:p,window:g})).arrays;return{...this.shown(await i.motion({query:p},t),n),samples:f}}let m=await this.turning(o,a,t),h=Yt(n,a,m,this.mechanics),d=this.
mechanics.instant?.bind(this.mechanics);return{header:c===null?h:{...h,doubt:Ts(c)},arrays:r,exact:d&&l?p=>d(o,l,p):void 0}}async exact(e){let{exact:t,samples:n}=await this.
film({scenario:e});return{exact:t,samples:n}}readable(e){return Zs(e,this.mechanics)}shown({header:e,arrays:t},n=gt(e.query,this.mechanics)){return{header:Yt(n,
e,i=>e.turning[i],this.mechanics),arrays:t}}async samples(e,t,n){let o=ne({scenario:e},this.mechanics);return this.kernel.columns(Z(Ee(o)),n,t)}async turning(e,{
events:t},n){let o=Bs(t);if(!o.length)return()=>0;let i=Float64Array.from(o,r=>$s(t,r)),{omega:a}=await this.kernel.samples(e,i,n);return r=>a[o.indexOf(r)]}code(e){
let t=ne({scenario:e},this.mechanics);return{python:qs(t),toml:Kt(t)}}async theory(e,t){t?.throwIfAborted();let n=ne({scenario:e},this.mechanics);return eo(n,await this.
kernel.thresholds(Z(n),t))}async regions(e,t,n){n?.throwIfAborted();let o=Z(ne({scenario:e},this.mechanics));return this.kernel.regions(o,t,Ad,Ld,n)}async changes(e,t,n){
if(!this.kernel.changes)throw new TypeError("This kernel has no derivatives.");let o=Ee(ne({scenario:e},this.mechanics)),i=Z(o);if(i.contact)throw new C($("comp\
liant_changes"));let a=Qs(o,t);if(!a)return null;let{rates:r,smaller:l,larger:c}=a,m=await this.kernel.changes(i,r,n);return{count:m.count,smaller:l?m.smaller:null,
larger:c?m.larger:null}}async map(e,t){t?.throwIfAborted();let{checked:n,x:o,y:i,what:a}=Ys(e,this.mechanics),r=As(n,{x:o,y:i,what:a}),l=await Ds(r,{x:o,y:i},this.
mechanics,t);return Is({x:o,y:i,what:a},await this.kernel.map(l,a,Os(a),t))}async file(e,t){if(!(e in Zo)){if(this.python)return this.python.file(e,t);throw new C(
`${e} needs Python: run hophoop lab.`)}return new Blob([await this.fileText(e,t)],{type:Zo[e]})}async fileText(e,t){let n=ne({query:t},this.mechanics);if(e==="m\
otion.toml")return Kt(n);let o=Ee(n),i=Z(o),a=await this.kernel.motion(i);if(a.doubt!==null&&this.python)return(await this.python.file(e,t)).text();if(e==="moti\
on.json")return Ks(o,a);let r=Vs(a.duration);return Js(r,await this.kernel.samples(i,r))}link(e,t){return this.base&&`${new URL(e?`?${e}`:"",this.base)}${t}`}};async function bl(s,e){let t=await s.catch(n=>{throw typeof WebAssembly=="object"&&!(n instanceof WebAssembly.CompileError)?n:new Error("This needs a browser th\
at runs WebAssembly.")});return new ds(t,t.mechanics,e)}function Qo(s,e,t){return bl(Ht.load(s),{base:t,python:e&&new as(e)})}function wl(s,e){let t=Ht.unpack(s.
get("module"),s.get("worker"),()=>e.derivatives());return bl(t,{python:e})}function yl(s){navigator.serviceWorker?.register(s).catch(()=>{})}var Pd=new URL("./",import.meta.url);async function Cd(s){let e=new URL("./",document.baseURI.split(/[?#]/)[0]),t=document.querySelector("meta[name=hophoop-site\
]"),n;try{n=await Qo(Pd,t?null:e,e)}catch(c){R(s,c.message);return}t&&yl(t.getAttribute("content")??"");let o=new rt(s,n,S.setup,{hosted:!0});Object.assign(globalThis,
{hophoopLab:o});let i=ca(location.hash),a=o.address,{links:r,said:l}=a.read(ao());try{await o.open(r,i),l()}catch(c){a.held=!0,await o.open([""]),o.notice.fail(
c)}}async function sv(s,e,t,n){let o=await Qo(e,null,new URL("../",e)),i=new rt(s,o,S.setup,{panels:n});return await i.open([t]),i}async function zd({model:s,el:e}){
let t=document.createElement("div");e.append(t);let n=new rs(s),o;try{o=await wl(s,n)}catch(l){return R(t,l.message),()=>n.close()}let i=()=>o.shown(Ft(s.get("f\
ilm"))),a=new rt(t,o,S.setup,{panels:s.get("panels"),onmotion:l=>{s.get("query")!==l&&(s.set("query",l),s.save_changes())}});a.motions.set([i()]),a.begin();let r=()=>a.
motions.replace(i());return s.on("change:film",r),()=>{s.off("change:film",r),n.close(),a.close()}}var vl=document.getElementById("hophoop-lab");vl&&Cd(vl);var ov={
render:zd};export{lc as adopt,Pe as current,ov as default,po as languageMenu,sv as mount,sn as repeat,k as t,Qe as untranslated};
