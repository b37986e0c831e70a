/* Built from web/lab/main.js by esbuild 0.28.2; sources a537727ddbb19fd621e74c78d941e5bf */
var Ur=Object.create;var $n=Object.defineProperty;var Gr=Object.getOwnPropertyDescriptor;var Kr=Object.getOwnPropertyNames;var Vr=Object.getPrototypeOf,Jr=Object.prototype.hasOwnProperty;var Yr=(s,e)=>()=>{try{return e||s((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var Zr=(s,e,t,o)=>{if(e&&typeof e=="object"||typeof e=="function")for(let n of Kr(e))!Jr.call(s,n)&&n!==t&&$n(s,n,{get:()=>e[n],enumerable:!(o=Gr(e,n))||o.enumerable});
return s};var Qr=(s,e,t)=>(t=s!=null?Ur(Vr(s)):{},Zr(e||!s||!s.__esModule?$n(t,"default",{value:s,enumerable:!0}):t,s));var aa=Yr(Es=>{"use strict";Object.defineProperty(Es,"__esModule",{value:!0});function oa(s){return!s||typeof s=="string"?s:s+""}var Io=class{async svg2canvas(e,t,o){
let n=await new Promise(r=>{var l=new Image;l.onload=function(){r(l)},l.src=e});var i=document.createElement("canvas");return i.width=t,i.height=o,i.getContext(
"2d").drawImage(n,0,0),i}toDataURL(e,t,o,n,i,a){var r=new XMLSerializer().serializeToString(e),l=document.documentMode;if(l){var c=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi;
c.test(r)&&(r=r.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink'))}a||(a={});var u="data:image/svg+xml;charset=utf-8,"+encodeURIComponent(
r);if(n==="image/svg+xml"||!n)return a.async?Promise.resolve(u):u;if(n==="image/jpeg"||n==="image/png"){if(!a.async)throw new Error("svgcanvas: options.async mu\
st be set to true if type is image/jpeg | image/png");return(async()=>{let h=await this.svg2canvas(u,t,o),d=h.toDataURL(n,i);return h.remove(),d})()}throw new Error(
"svgcanvas: Unknown type for toDataURL, please use image/jpeg | image/png | image/svg+xml.")}getImageData(e,t,o,n,i,a,r,l){if(l||(l={}),!l.async)throw new Error(
"svgcanvas: options.async must be set to true for getImageData");let c=this.toDataURL(e,t,o,"image/svg+xml");return(async()=>{let u=await this.svg2canvas(c,t,o),
d=u.getContext("2d").getImageData(n,i,a,r);return u.remove(),d})()}},na=new Io;var ia=(function(){var s,e,t,o,n;function i(h,d){var m=Object.keys(d),g;for(g=0;g<
m.length;g++)h=h.replace(new RegExp("\\{"+m[g]+"\\}","gi"),d[m[g]]);return h}function a(h){var d,m,g;if(!h)throw new Error("cannot create a random attribute nam\
e for an undefined object");d="ABCDEFGHIJKLMNOPQRSTUVWXTZabcdefghiklmnopqrstuvwxyz",m="";do for(m="",g=0;g<12;g++)m+=d[Math.floor(Math.random()*d.length)];while(h[m]);
return m}function r(h,d){var m,g,f={},w;for(h=h.split(","),d=d||10,m=0;m<h.length;m+=2)g="&"+h[m+1]+";",w=parseInt(h[m],d),f[g]="&#"+w+";";return f["\\xa0"]="&#\
160;",f}function l(h){var d={left:"start",right:"end",center:"middle",start:"start",end:"end"};return d[h]||d.start}function c(h){var d={alphabetic:"alphabetic",
hanging:"hanging",top:"text-before-edge",bottom:"text-after-edge",middle:"central"};return d[h]||d.alphabetic}n=r("50,nbsp,51,iexcl,52,cent,53,pound,54,curren,5\
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
var m=this.__ctx.__createElement("stop"),g,f;m.setAttribute("offset",h),oa(d).indexOf("rgba")!==-1?(g=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
f=g.exec(d),m.setAttribute("stop-color",i("rgb({r},{g},{b})",{r:f[1],g:f[2],b:f[3]})),m.setAttribute("stop-opacity",f[4])):m.setAttribute("stop-color",oa(d)),this.
__root.appendChild(m)},o=function(h,d){this.__root=h,this.__ctx=d},e=function(h){var d={width:500,height:500,enableMirroring:!1},m;if(arguments.length>1?(m=d,m.
width=arguments[0],m.height=arguments[1]):h?m=h:m=d,!(this instanceof e))return new e(m);this.width=m.width||d.width,this.height=m.height||d.height,this.enableMirroring=
m.enableMirroring!==void 0?m.enableMirroring:d.enableMirroring,this.canvas=this,this.__document=m.document||document,m.ctx?this.__ctx=m.ctx:(this.__canvas=this.
__document.createElement("canvas"),this.__ctx=this.__canvas.getContext("2d")),this.__setDefaultStyles(),this.__styleStack=[this.__getStyleState()],this.__groupStack=
[],this.__root=this.__document.createElementNS("http://www.w3.org/2000/svg","svg"),this.__root.setAttribute("version",1.1),this.__root.setAttribute("xmlns","htt\
p://www.w3.org/2000/svg"),this.__root.setAttributeNS("http://www.w3.org/2000/xmlns/","xmlns:xlink","http://www.w3.org/1999/xlink"),this.__root.setAttribute("wid\
th",this.width),this.__root.setAttribute("height",this.height),this.__ids={},this.__defs=this.__document.createElementNS("http://www.w3.org/2000/svg","defs"),this.
__root.appendChild(this.__defs),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.resetTransform(),this.__options=m,this.__id=Math.random().toString(16).substring(2,8),this.__debug("new",h)},e.prototype.__debug=function(...h){this.__options.
debug&&console.debug(`svgcanvas#${this.__id}:`,...h)},e.prototype.__createElement=function(h,d,m){typeof d>"u"&&(d={});var g=this.__document.createElementNS("ht\
tp://www.w3.org/2000/svg",h),f=Object.keys(d),w,b;for(m&&(g.setAttribute("fill","none"),g.setAttribute("stroke","none")),w=0;w<f.length;w++)b=f[w],g.setAttribute(
b,d[b]);return g},e.prototype.__setDefaultStyles=function(){var h=Object.keys(s),d,m;for(d=0;d<h.length;d++)m=h[d],this[m]=s[m].canvas},e.prototype.__applyStyleState=
function(h){var d=Object.keys(h),m,g;for(m=0;m<d.length;m++)g=d[m],this[g]=h[g]},e.prototype.__getStyleState=function(){var h,d={},m=Object.keys(s),g;for(h=0;h<
m.length;h++)g=m[h],d[g]=this[g];return d},e.prototype.__applyTransformation=function(h,d){let{a:m,b:g,c:f,d:w,e:b,f:y}=d||this.getTransform();h.setAttribute("t\
ransform",`matrix(${m} ${g} ${f} ${w} ${b} ${y})`)},e.prototype.__applyStyleToCurrentElement=function(h){var d=this.__currentElement,m=this.__currentElementsToStyle;
m&&(d.setAttribute(h,""),d=m.element,m.children.forEach(function(Z){Z.setAttribute(h,"")}));var g=Object.keys(s),f,w,b,y,v,S,R,M;for(f=0;f<g.length;f++)if(w=s[g[f]],
b=this[g[f]],w.apply){if(b instanceof o){if(b.__ctx)for(R=0;R<b.__ctx.__defs.childNodes.length;R++)M=b.__ctx.__defs.childNodes[R],S=M.getAttribute("id"),this.__ids[S]=
S,this.__defs.appendChild(M);d.setAttribute(w.apply,i("url(#{id})",{id:b.__root.getAttribute("id")}))}else if(b instanceof t)d.setAttribute(w.apply,i("url(#{id}\
)",{id:b.__root.getAttribute("id")}));else if(w.apply.indexOf(h)!==-1&&w.svg!==b)if((w.svgAttr==="stroke"||w.svgAttr==="fill")&&b&&b.indexOf("rgba")!==-1){y=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
v=y.exec(b),d.setAttribute(w.svgAttr,i("rgb({r},{g},{b})",{r:v[1],g:v[2],b:v[3]}));var E=v[4],I=this.globalAlpha;I!=null&&(E*=I),d.setAttribute(w.svgAttr+"-opac\
ity",E)}else{var O=w.svgAttr;if(g[f]==="globalAlpha"){if(O=h+"-"+w.svgAttr,d.getAttribute(O))continue}else if(g[f]==="lineWidth"){var q=this.__getTransformScale();
b=b*Math.max(q.x,q.y)}d.setAttribute(O,b)}}},e.prototype.__closestGroupOrSvg=function(h){return h=h||this.__currentElement,h.nodeName==="g"||h.nodeName==="svg"?
h:this.__closestGroupOrSvg(h.parentNode)},e.prototype.getSerializedSvg=function(h){var d=new XMLSerializer().serializeToString(this.__root),m,g,f,w,b,y;if(y=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi,
y.test(d)&&(d=d.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink')),h)for(m=Object.keys(n),g=0;g<m.length;g++)f=m[g],w=n[f],
b=new RegExp(f,"gi"),b.test(d)&&(d=d.replace(b,w));return d},e.prototype.getSvg=function(){return this.__root},e.prototype.save=function(){var h=this.__createElement(
"g"),d=this.__closestGroupOrSvg();this.__groupStack.push(d),d.appendChild(h),this.__currentElement=h;let m=this.__getStyleState();this.__debug("save style",m),this.
__styleStack.push(m),this.__transformMatrixStack||(this.__transformMatrixStack=[]),this.__transformMatrixStack.push(this.getTransform())},e.prototype.restore=function(){
this.__currentElement=this.__groupStack.pop(),this.__currentElementsToStyle=null,this.__currentElement||(this.__currentElement=this.__root.childNodes[1]);var h=this.
__styleStack.pop();this.__debug("restore style",h),this.__applyStyleState(h),this.__transformMatrixStack&&this.__transformMatrixStack.length>0&&this.setTransform(
this.__transformMatrixStack.pop())},e.prototype.beginPath=function(){var h,d;this.__currentDefaultPath="",this.__currentPosition={},h=this.__createElement("path",
{},!0),d=this.__closestGroupOrSvg(),d.appendChild(h),this.__currentElement=h},e.prototype.__applyCurrentDefaultPath=function(){var h=this.__currentElement;h.nodeName===
"path"?h.setAttribute("d",this.__currentDefaultPath):console.error("Attempted to apply path command to node",h.nodeName)},e.prototype.__addPathCommand=function(h){
this.__currentDefaultPath+=" ",this.__currentDefaultPath+=h},e.prototype.moveTo=function(h,d){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.__currentPosition=
{x:h,y:d},this.__addPathCommand(i("M {x} {y}",{x:this.__matrixTransform(h,d).x,y:this.__matrixTransform(h,d).y}))},e.prototype.closePath=function(){this.__currentDefaultPath&&
this.__addPathCommand("Z")},e.prototype.lineTo=function(h,d){this.__currentPosition={x:h,y:d},this.__currentDefaultPath.indexOf("M")>-1?this.__addPathCommand(i(
"L {x} {y}",{x:this.__matrixTransform(h,d).x,y:this.__matrixTransform(h,d).y})):this.__addPathCommand(i("M {x} {y}",{x:this.__matrixTransform(h,d).x,y:this.__matrixTransform(
h,d).y}))},e.prototype.bezierCurveTo=function(h,d,m,g,f,w){this.__currentPosition={x:f,y:w},this.__addPathCommand(i("C {cp1x} {cp1y} {cp2x} {cp2y} {x} {y}",{cp1x:this.
__matrixTransform(h,d).x,cp1y:this.__matrixTransform(h,d).y,cp2x:this.__matrixTransform(m,g).x,cp2y:this.__matrixTransform(m,g).y,x:this.__matrixTransform(f,w).
x,y:this.__matrixTransform(f,w).y}))},e.prototype.quadraticCurveTo=function(h,d,m,g){this.__currentPosition={x:m,y:g},this.__addPathCommand(i("Q {cpx} {cpy} {x}\
 {y}",{cpx:this.__matrixTransform(h,d).x,cpy:this.__matrixTransform(h,d).y,x:this.__matrixTransform(m,g).x,y:this.__matrixTransform(m,g).y}))};var u=function(h){
var d=Math.sqrt(h[0]*h[0]+h[1]*h[1]);return[h[0]/d,h[1]/d]};return e.prototype.arcTo=function(h,d,m,g,f){var w=this.__currentPosition&&this.__currentPosition.x,
b=this.__currentPosition&&this.__currentPosition.y;if(!(typeof w>"u"||typeof b>"u")){if(f<0)throw new Error("IndexSizeError: The radius provided ("+f+") is nega\
tive.");if(w===h&&b===d||h===m&&d===g||f===0){this.lineTo(h,d);return}var y=u([w-h,b-d]),v=u([m-h,g-d]);if(y[0]*v[1]===y[1]*v[0]){this.lineTo(h,d);return}var S=y[0]*
v[0]+y[1]*v[1],R=Math.acos(Math.abs(S)),M=u([y[0]+v[0],y[1]+v[1]]),E=f/Math.sin(R/2),I=h+E*M[0],O=d+E*M[1],q=[-y[1],y[0]],Z=[v[1],-v[0]],ie=function(Fn){var Wn=Fn[0],
Hr=Fn[1];return Hr>=0?Math.acos(Wn):-Math.acos(Wn)},Bt=ie(q),Br=ie(Z);this.lineTo(I+q[0]*f,O+q[1]*f),this.arc(I,O,f,Bt,Br)}},e.prototype.stroke=function(){this.
__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","fill stroke markers"),this.__applyCurrentDefaultPath(),this.__applyStyleToCurrentElement(
"stroke")},e.prototype.fill=function(){this.__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","stroke fill markers"),this.__applyCurrentDefaultPath(),
this.__applyStyleToCurrentElement("fill")},e.prototype.rect=function(h,d,m,g){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.moveTo(h,d),this.lineTo(
h+m,d),this.lineTo(h+m,d+g),this.lineTo(h,d+g),this.lineTo(h,d),this.closePath()},e.prototype.roundRect=function(h,d,m,g,f){this.__currentElement.nodeName!=="pa\
th"&&this.beginPath();let w,b,y,v;typeof f=="number"?(w=f,b=f,y=f,v=f):[w,b,y,v]=f,this.moveTo(h+w,d),this.arcTo(h+m,d,h+m,d+g,b),this.arcTo(h+m,d+g,h,d+g,y),this.
arcTo(h,d+g,h,d,v),this.arcTo(h,d,h+m,d,w),this.closePath()},e.prototype.fillRect=function(h,d,m,g){let{a:f,b:w,c:b,d:y,e:v,f:S}=this.getTransform();JSON.stringify(
[f,w,b,y,v,S])===JSON.stringify([1,0,0,1,0,0])&&h===0&&d===0&&m===this.width&&g===this.height&&this.__clearCanvas();var R,M;R=this.__createElement("rect",{x:h,y:d,
width:m,height:g},!0),M=this.__closestGroupOrSvg(),M.appendChild(R),this.__currentElement=R,this.__applyTransformation(R),this.__applyStyleToCurrentElement("fil\
l")},e.prototype.strokeRect=function(h,d,m,g){var f,w;f=this.__createElement("rect",{x:h,y:d,width:m,height:g},!0),w=this.__closestGroupOrSvg(),w.appendChild(f),
this.__currentElement=f,this.__applyTransformation(f),this.__applyStyleToCurrentElement("stroke")},e.prototype.__clearCanvas=function(){var h=this.__root.childNodes[1];
this.__root.removeChild(h),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.__groupStack=[]},e.prototype.clearRect=function(h,d,m,g){let{a:f,b:w,c:b,d:y,e:v,f:S}=this.getTransform();if(JSON.stringify([f,w,b,y,v,S])===JSON.stringify(
[1,0,0,1,0,0])&&h===0&&d===0&&m===this.width&&g===this.height){this.__clearCanvas();return}var R,M=this.__closestGroupOrSvg();R=this.__createElement("rect",{x:h,
y:d,width:m,height:g,fill:"#FFFFFF"},!0),this.__applyTransformation(R),M.appendChild(R)},e.prototype.createLinearGradient=function(h,d,m,g){var f=this.__createElement(
"linearGradient",{id:a(this.__ids),x1:h+"px",x2:m+"px",y1:d+"px",y2:g+"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(f),new t(f,this)},
e.prototype.createRadialGradient=function(h,d,m,g,f,w){var b=this.__createElement("radialGradient",{id:a(this.__ids),cx:g+"px",cy:f+"px",r:w+"px",fx:h+"px",fy:d+
"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(b),new t(b,this)},e.prototype.__applyText=function(h,d,m,g){var f=document.createElement(
"span");f.setAttribute("style","font:"+this.font);var w=f.style,b=this.__closestGroupOrSvg(),y=this.__createElement("text",{"font-family":w.fontFamily,"font-siz\
e":w.fontSize,"font-style":w.fontStyle,"font-weight":w.fontWeight,"text-decoration":this.__fontUnderline,x:d,y:m,"text-anchor":l(this.textAlign),"dominant-basel\
ine":c(this.textBaseline)},!0);if(y.appendChild(this.__document.createTextNode(h)),this.__currentElement=y,this.__applyTransformation(y),this.__applyStyleToCurrentElement(
g),this.__fontHref){var v=this.__createElement("a");v.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",this.__fontHref),v.appendChild(y),y=v}b.appendChild(
y)},e.prototype.fillText=function(h,d,m){this.__applyText(h,d,m,"fill")},e.prototype.strokeText=function(h,d,m){this.__applyText(h,d,m,"stroke")},e.prototype.measureText=
function(h){return this.__ctx.font=this.font,this.__ctx.measureText(h)},e.prototype.arc=function(h,d,m,g,f,w){if(g!==f){g=g%(2*Math.PI),f=f%(2*Math.PI),g===f&&(f=
(f+2*Math.PI-.001*(w?-1:1))%(2*Math.PI));var b=h+m*Math.cos(f),y=d+m*Math.sin(f),v=h+m*Math.cos(g),S=d+m*Math.sin(g),R=w?0:1,M=0,E=f-g;E<0&&(E+=2*Math.PI),w?M=E>
Math.PI?0:1:M=E>Math.PI?1:0;var I=Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),O=Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d);
this.lineTo(v,S),this.__addPathCommand(i("A {rx} {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:m*I,ry:m*O,xAxisRotation:0,largeArcFlag:M,sweepFlag:R,
endX:this.__matrixTransform(b,y).x,endY:this.__matrixTransform(b,y).y})),this.__currentPosition={x:b,y}}},e.prototype.ellipse=function(h,d,m,g,f,w,b,y){if(w!==b){
var v=this.__matrixTransform(h,d);h=v.x,d=v.y;var S=this.__getTransformScale();m=m*S.x,g=g*S.y,f=f+this.__getTransformRotation(),w=w%(2*Math.PI),b=b%(2*Math.PI),
w===b&&(b=(b+2*Math.PI-.001*(y?-1:1))%(2*Math.PI));var R=h+Math.cos(-f)*m*Math.cos(b)+Math.sin(-f)*g*Math.sin(b),M=d-Math.sin(-f)*m*Math.cos(b)+Math.cos(-f)*g*Math.
sin(b),E=h+Math.cos(-f)*m*Math.cos(w)+Math.sin(-f)*g*Math.sin(w),I=d-Math.sin(-f)*m*Math.cos(w)+Math.cos(-f)*g*Math.sin(w),O=y?0:1,q=0,Z=b-w;Z<0&&(Z+=2*Math.PI),
y?q=Z>Math.PI?0:1:q=Z>Math.PI?1:0;var ie=this.__transformMatrix;this.resetTransform(),this.lineTo(E,I),this.__transformMatrix=ie,this.__addPathCommand(i("A {rx}\
 {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:m,ry:g,xAxisRotation:f*(180/Math.PI),largeArcFlag:q,sweepFlag:O,endX:R,endY:M})),this.__currentPosition=
{x:R,y:M}}},e.prototype.clip=function(){var h=this.__closestGroupOrSvg(),d=this.__createElement("clipPath"),m=a(this.__ids),g=this.__createElement("g");this.__applyCurrentDefaultPath(),
h.removeChild(this.__currentElement),d.setAttribute("id",m),d.appendChild(this.__currentElement),this.__defs.appendChild(d),h.setAttribute("clip-path",i("url(#{\
id})",{id:m})),h.appendChild(g),this.__currentElement=g},e.prototype.drawImage=function(){var h=Array.prototype.slice.call(arguments),d=h[0],m,g,f,w,b=0,y=0,v,S,
R,M,E,I,O,q,Z,ie;if(h.length===3)m=h[1],g=h[2],v=d.width,S=d.height,f=v,w=S;else if(h.length===5)m=h[1],g=h[2],f=h[3],w=h[4],v=d.width,S=d.height;else if(h.length===
9)b=h[1],y=h[2],v=h[3],S=h[4],m=h[5],g=h[6],f=h[7],w=h[8];else throw new Error("Invalid number of arguments passed to drawImage: "+arguments.length);R=this.__closestGroupOrSvg(),
this.__currentElement;let Bt=this.getTransform().translate(m,g);if(d instanceof e){if(M=d.getSvg().cloneNode(!0),M.childNodes&&M.childNodes.length>1){for(E=M.childNodes[0];E.
childNodes.length;)ie=E.childNodes[0].getAttribute("id"),this.__ids[ie]=ie,this.__defs.appendChild(E.childNodes[0]);I=M.childNodes[1],I&&(this.__applyTransformation(
I,Bt),R.appendChild(I))}}else(d.nodeName==="CANVAS"||d.nodeName==="IMG")&&(O=this.__createElement("image"),O.setAttribute("width",f),O.setAttribute("height",w),
O.setAttribute("preserveAspectRatio","none"),(b||y||v!==d.width||S!==d.height)&&(q=this.__document.createElement("canvas"),q.width=f,q.height=w,Z=q.getContext("\
2d"),Z.drawImage(d,b,y,v,S,0,0,f,w),d=q),this.__applyTransformation(O,Bt),O.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",d.nodeName==="CANVAS"?d.toDataURL():
d.getAttribute("src")),R.appendChild(O))},e.prototype.createPattern=function(h,d){var m=this.__document.createElementNS("http://www.w3.org/2000/svg","pattern"),
g=a(this.__ids),f;return m.setAttribute("id",g),m.setAttribute("width",h.width),m.setAttribute("height",h.height),m.setAttribute("patternUnits","userSpaceOnUse"),
h.nodeName==="CANVAS"||h.nodeName==="IMG"?(f=this.__document.createElementNS("http://www.w3.org/2000/svg","image"),f.setAttribute("width",h.width),f.setAttribute(
"height",h.height),f.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",h.nodeName==="CANVAS"?h.toDataURL():h.getAttribute("src")),m.appendChild(f),this.
__defs.appendChild(m)):h instanceof e&&(m.appendChild(h.__root.childNodes[1]),this.__defs.appendChild(m)),new o(m,this)},e.prototype.setLineDash=function(h){h&&
h.length>0?this.lineDash=h.join(","):this.lineDash=null},e.prototype.setTransform=function(h,d,m,g,f,w){h instanceof DOMMatrix?this.__transformMatrix=new DOMMatrix(
[h.a,h.b,h.c,h.d,h.e,h.f]):this.__transformMatrix=new DOMMatrix([h,d,m,g,f,w])},e.prototype.getTransform=function(){let{a:h,b:d,c:m,d:g,e:f,f:w}=this.__transformMatrix;
return new DOMMatrix([h,d,m,g,f,w])},e.prototype.resetTransform=function(){this.setTransform(1,0,0,1,0,0)},e.prototype.scale=function(h,d){if(d===void 0&&(d=h),
isNaN(h)||isNaN(d)||!isFinite(h)||!isFinite(d))return;let m=this.getTransform().scale(h,d);this.setTransform(m)},e.prototype.rotate=function(h){let d=this.getTransform().
multiply(new DOMMatrix([Math.cos(h),Math.sin(h),-Math.sin(h),Math.cos(h),0,0]));this.setTransform(d)},e.prototype.translate=function(h,d){let m=this.getTransform().
translate(h,d);this.setTransform(m)},e.prototype.transform=function(h,d,m,g,f,w){let b=this.getTransform().multiply(new DOMMatrix([h,d,m,g,f,w]));this.setTransform(
b)},e.prototype.__matrixTransform=function(h,d){return new DOMPoint(h,d).matrixTransform(this.__transformMatrix)},e.prototype.__getTransformScale=function(){return{
x:Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),y:Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d)}},e.prototype.__getTransformRotation=
function(){return Math.atan2(this.__transformMatrix.b,this.__transformMatrix.a)},e.prototype.getImageData=function(h,d,m,g,f){return na.getImageData(this.getSvg(),
this.width,this.height,h,d,m,g,f)},e.prototype.drawFocusRing=function(){},e.prototype.createImageData=function(){},e.prototype.putImageData=function(){},e.prototype.
globalCompositeOperation=function(){},e})();function Pe(s){this.ctx=new ia(s),this.svg=this.ctx.__root;var e=this.svg,t=this,o=document.createElement("div");o.style.
display="inline-block",o.appendChild(e),this.wrapper=o,Object.defineProperty(this,"className",{get:function(){return o.getAttribute("class")||""},set:function(n){
return o.setAttribute("class",n)}}),Object.defineProperty(this,"tagName",{get:function(){return"CANVAS"},set:function(){}}),["width","height"].forEach(function(n){
Object.defineProperty(t,n,{get:function(){return e.getAttribute(n)|0},set:function(i){if(!(isNaN(i)||typeof i>"u"))return t.ctx[n]=i,e.setAttribute(n,i),o[n]=i}})}),
["style","id"].forEach(function(n){Object.defineProperty(t,n,{get:function(){return o[n]},set:function(i){if(typeof i<"u")return o[n]=i}})}),["getBoundingClient\
Rect"].forEach(function(n){t[n]=function(){return e[n]()}})}Pe.prototype.getContext=function(s){if(s!=="2d")throw new Error("Unsupported type of context for SVG\
Canvas");return this.ctx};Pe.prototype.toObjectURL=function(){var s=new XMLSerializer().serializeToString(this.svg),e=new Blob([s],{type:"image/svg+xml;charset=\
utf-8"});return URL.createObjectURL(e)};Pe.prototype.toDataURL=function(s,e,t){return na.toDataURL(this.svg,this.width,this.height,s,e,t)};Pe.prototype.addEventListener=
function(){return this.svg.addEventListener.apply(this.svg,arguments)};Pe.prototype.getElement=function(){return this.wrapper};Pe.prototype.getAttribute=function(s){
return this.wrapper.getAttribute(s)};Pe.prototype.setAttribute=function(s,e){this.wrapper.setAttribute(s,e)};Es.Context=ia;Es.Element=Pe});function ye(s){let e=Number.parseInt(s.slice(1,7),16);return[e>>16&255,e>>8&255,e&255]}var Bn=s=>ut(s)>.2?"#111111":"#ffffff",dt=(s,e)=>`rgba(${ye(s).join(",")}\
,${e})`,Xr=s=>{let e=s/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4};function ut(s){let[e,t,o]=ye(s).map(Xr);return .2126*e+.7152*t+.0722*o}function pt(s,e){
if(!e||!/^#[0-9a-f]{6}$/i.test(s))return s;if(ut(s)<.002)return"#eceef2";let t=s;for(let o=0;ut(t)<.2&&o<1;o+=.05)t=`#${ye(s).map(n=>Math.round(n+(255-n)*o).toString(
16).padStart(2,"0")).join("")}`;return t}var Ht=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"];function el(){let s=[];
for(let e=0;e<256;e++){let t=e/255*(Ht.length-1),o=Math.min(Math.floor(t),Ht.length-2),n=ye(Ht[o]),i=ye(Ht[o+1]);s.push(n.map((a,r)=>Math.round(a+(i[r]-a)*(t-o))))}
return s}var Ve=el(),Ut=Ve.map(s=>`rgb(${s.join(",")})`),tl=["#123a8c","#8a6d00"],ue=(s,e)=>pt(tl[s],e);var Hn={roll:"Rollen",spin:"Durchdrehen",skid:"Rutschen",flight:"Flug",skim:"Streifen","slip −":"Schlupf −","slip +":"Schlupf +",rolls:"rollt",spins:"dreht \
durch",skids:"rutscht",flies:"fliegt","skims the plane":"streift die Ebene","rolls at {angle}":"rollt ab {angle}","spins at {angle}":"dreht ab {angle} durch","s\
kids at {angle}":"rutscht ab {angle}","flies at {angle}":"fliegt ab {angle}","skims the plane at {angle}":"streift ab {angle} die Ebene","hops at {angle}":"hüpf\
t bei {angle}","lands at {angle}":"landet bei {angle}","bounces at {angle}":"springt bei {angle} wieder ab","slips the other way at {angle}":"gleitet ab {angle}\
 in der anderen Richtung","stops its slip at once at {angle}":"hört bei {angle} schlagartig auf zu gleiten","turns back at {angle}":"kehrt bei {angle} um","has\
 bounced out at {angle}":"ist bei {angle} ausgesprungen","meets Painlevé's paradox at {angle}":"trifft bei {angle} auf das Painlevé-Paradoxon","meets Painlevé\
's indeterminacy at {angle}":"trifft bei {angle} auf die Unbestimmtheit nach Painlevé","jams at {angle}":"verklemmt sich bei {angle}","gains energy (Kane) at {\
angle}":"gewinnt bei {angle} Energie (Kane)","skims at {angle}":"streift ab {angle}","rests at {angle}":"ruht bei {angle}","starts at {angle}":"beginnt bei {ang\
le}","slips at {angle}":"gleitet ab {angle}","{what} and {count} more times":"{what} und noch {count}-mal","… ({count} more)":"… (noch {count})","It has com\
e to rest.":"Er ist zur Ruhe gekommen.","The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.":"Die Normalkraft wächst\
 über alle Grenzen (dynamisches Verklemmen): Die Mechanik starrer Körper kennt keine Bewegung darüber hinaus.","The model does not determine the motion beyon\
d.":"Das Modell legt die weitere Bewegung nicht fest.","The limit of events (contact.max_events), or of work for one motion, was reached before the end.":"Die G\
renze der Ereignisse (contact.max_events) oder des Aufwands für eine Bewegung wurde vor dem Ende erreicht.","It starts and {verb} with the load at {angle} and \
the centre at {speed} m/s.":"Er startet und {verb}, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It starts in the air with the load at {angle} and t\
he centre at {speed} m/s.":"Er startet in der Luft, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It starts skimming with the load at {angle} and the\
 centre at {speed} m/s.":"Er streift zu Beginn die Ebene, die Last bei {angle}, der Mittelpunkt mit {speed} m/s.","It {verb} at {angle}; friction is used up: th\
e rim turns too fast for the way it goes.":"Ab {angle} {verb} er: Die Reibung ist ausgeschöpft, der Rand dreht sich zu schnell für seinen Weg.","It {verb} at \
{angle}; friction is used up: the rim slides ahead.":"Ab {angle} {verb} er: Die Reibung ist ausgeschöpft, der Rand gleitet voraus.","It rolls again at {angle};\
 the slip has stopped.":"Ab {angle} rollt er wieder; der Schlupf hat aufgehört.","The slip turns round at {angle}; it {verb}.":"Bei {angle} kehrt sich der Schl\
upf um; er {verb}.","It hops at {angle}.":"Er hüpft bei {angle}.","It hops at {angle}. It rises {height} and stays up for {time} s.":"Er hüpft bei {angle}. Er \
steigt {height} hoch und bleibt {time} s in der Luft.","An impact without collision at {angle} stops the slip; then it {verb}.":"Ein Stoß ohne Aufprall beendet \
bei {angle} den Schlupf; dann {verb} er.","It lands at {angle} with {speed} m/s downwards and bounces.":"Er landet bei {angle} mit {speed} m/s abwärts und sprin\
gt wieder ab.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Er landet bei {angle} mit {speed} m/s abwärts und {verb}.","It turns back at {angl\
e}.":"Er kehrt bei {angle} um.","It turns back at {angle}, and {verb} now.":"Er kehrt bei {angle} um und {verb} jetzt.","The centre is highest at {angle}: the g\
ap is {height}.":"Bei {angle} ist der Mittelpunkt am höchsten: Der Spalt beträgt {height}.","Bounces without number end here, at {angle}.":"Hier, bei {angle},\
 enden unzählige Sprünge.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Painlevé-Paradoxon bei {angle}: Keine Kontaktkraft passt\
 zu diesem Schlupf.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Painlevé-Paradoxon bei {angle}: Mehrere Kontaktkräfte passen dazu.",
"Dynamic jam at {angle}: the contact force grows without bound.":"Dynamisches Verklemmen bei {angle}: Die Kontaktkraft wächst über alle Grenzen.","Newton's la\
w of impact has created {energy} J (Kane's example).":"Newtons Stoßgesetz hat {energy} J erzeugt (Beispiel von Kane).","No contact force is left at {angle}: th\
e load falls freely and the rim skims the plane.":"Bei {angle} ist keine Kontaktkraft mehr da: Die Last fällt frei, der Rand streift die Ebene.","It rests at {\
angle}.":"Er ruht bei {angle}.","It rests at {angle}, which is not stable.":"Er ruht bei {angle}, aber nicht stabil.","It bounces {count} more times.":"Er sprin\
gt noch {count}-mal.","… and {count} more.":"… und noch {count}.",Slips:"Gleitet",Hops:"Hüpft","Hops at once":"Hüpft sofort","Friction for pure rolling":"\
Reibung für reines Rollen","Painlevé’s paradox":"Painlevé-Paradoxon","Dynamic jam":"Dynamisches Verklemmen","Rests stably":"Ruht stabil","End of rolling":"\
Ende des Rollens","would slip above {speed} m/s":"würde über {speed} m/s gleiten","would slip: any push is enough":"würde gleiten: jeder Stoß genügt","woul\
d hop in its first turn above {speed} m/s":"würde über {speed} m/s in der ersten Umdrehung hüpfen","would hop in its first turn: any push is enough":"würde i\
n der ersten Umdrehung hüpfen: jeder Stoß genügt","would hop at once above {speed} m/s":"würde über {speed} m/s sofort hüpfen","would hop at once: at any \
speed":"würde sofort hüpfen: bei jeder Geschwindigkeit","never, at any speed":"nie, bei keiner Geschwindigkeit","no friction keeps it rolling":"keine Reibung \
hält ihn am Rollen","μ = {mu} would keep it rolling (enough here)":"μ = {mu} hielte ihn am Rollen (hier genug)","μ = {mu} would keep it rolling (more than th\
ere is)":"μ = {mu} hielte ihn am Rollen (mehr als hier)",never:"nie","from μ = {mu} on, at {angle}: possible here":"ab μ = {mu}, bei {angle}: hier möglich",
"from μ = {mu} on, at {angle}: not here":"ab μ = {mu}, bei {angle}: hier nicht","can end a slip at {angles}":"kann einen Schlupf bei {angles} beenden","with t\
he load at {angle}":"mit der Last bei {angle}","at {angle} friction is used up":"bei {angle} ist die Reibung ausgeschöpft","at {angle} the contact force is gon\
e":"bei {angle} ist die Kontaktkraft weg","Load fraction":"Massenanteil der Last","Share of the mass in the load of an ideal hoop":"Anteil der Last an der Masse\
 eines idealen Reifens",Eccentricity:"Exzentrizität","Distance of the centre of gravity from the centre, over the radius":"Abstand des Schwerpunkts vom Mittelp\
unkt, geteilt durch den Radius","Inertia ratio":"Bezogenes Trägheitsmoment","Moment of inertia about the centre of gravity over m R²":"Trägheitsmoment um den \
Schwerpunkt, geteilt durch m R²",Radius:"Radius","Rim radius":"Radius des Randes",Mass:"Masse","Total mass":"Gesamtmasse",Friction:"Reibungszahl","Friction, st\
atic and kinetic":"Reibungszahl, Haft- und Gleitreibung","Static friction":"Haftreibungszahl","Kinetic friction":"Gleitreibungszahl",Slope:"Neigung","Slope of t\
he plane, downhill along +x":"Neigung der Ebene, bergab in Richtung +x",Gravity:"Fallbeschleunigung",Restitution:"Stoßzahl","Restitution of an impact":"Stoßzah\
l eines Stoßes",Speed:"Geschwindigkeit","Velocity of the centre in a rolling start":"Geschwindigkeit des Mittelpunkts bei rollendem Start","Load angle":"Winkel\
 der Last","Angle from the plane's normal to the centre of gravity":"Winkel von der Normalen der Ebene zum Schwerpunkt","Height of the gap":"Höhe des Spalts","\
Gap between rim and plane":"Spalt zwischen Rand und Ebene","Speed along":"Geschwindigkeit längs","Velocity of the centre along the plane":"Geschwindigkeit des \
Mittelpunkts längs der Ebene","Speed upwards":"Geschwindigkeit nach oben","Velocity of the centre away from the plane":"Geschwindigkeit des Mittelpunkts weg vo\
n der Ebene","Angular velocity":"Winkelgeschwindigkeit",Stiffness:"Steifigkeit","Stiffness of the contact":"Steifigkeit des Kontakts","Slip speed":"Schlupfgesch\
windigkeit","Slip velocity over which friction builds up":"Schlupfgeschwindigkeit, bei der sich die Reibung aufbaut","Restitution that the damping is chosen for":"\
Stoßzahl, für die die Dämpfung gewählt ist",Duration:"Dauer","Duration of the motion":"Dauer der Bewegung","Law of impact":"Stoßgesetz","Law of restitution":"\
Gesetz der Restitution","Stronge (energy)":"Stronge (Energie)","Poisson (impulse)":"Poisson (Impuls)","Newton (velocity)":"Newton (Geschwindigkeit)","Painlevé: \
two solutions":"Painlevé: zwei Lösungen","What follows an indeterminate contact":"Was auf einen unbestimmten Kontakt folgt",impact:"Stoß","Contact model":"Ko\
ntaktmodell",rigid:"starr",compliant:"nachgiebig","Normal force":"Normalkraft","Friction law":"Reibungsgesetz","Regularised friction":"Geglättete Reibung","smo\
oth (tanh)":"glatt (tanh)",linear:"linear","bristle (can hold)":"Borsten (kann halten)","Kelvin–Voigt":"Kelvin–Voigt","Hunt–Crossley":"Hunt–Crossley","S\
peed v₀":"Geschwindigkeit v₀","Angle of the load θ₀":"Winkel der Last θ₀","Speed along ẋ₀":"Geschwindigkeit längs ẋ₀","Angular velocity θ̇₀":"\
Winkelgeschwindigkeit θ̇₀","Height of the gap y₀":"Höhe des Spalts y₀","Load fraction γ":"Massenanteil der Last γ","Eccentricity ε":"Exzentrizität ε",
"Inertia ratio κ":"Bezogenes Trägheitsmoment κ","Radius R":"Radius R","Friction μ":"Reibungszahl μ","Slope β":"Neigung β","Gravity g":"Fallbeschleunigung\
 g","Restitution e":"Stoßzahl e",Earth:"Erde",Moon:"Mond",Mars:"Mars",Jupiter:"Jupiter",Weightless:"Schwerelos","what happens in the first turn":"was in der er\
sten Umdrehung geschieht","height of the first hop":"Höhe des ersten Hüpfers","angle of take-off":"Winkel beim Abheben","duration of the first hop":"Dauer des\
 ersten Hüpfers","greatest friction utilization":"größte Ausnutzung der Reibung","energy lost":"verlorene Energie","angle at the end":"Winkel am Ende","Painl\
evé’s paradox or jam met":"Painlevé-Paradoxon oder Verklemmen getroffen","how it ends":"wie es endet",duration:"Dauer",revolutions:"Umdrehungen",reversal:"U\
mkehr",takeoff:"Abheben",rest:"Ruhe",jam:"Verklemmen",undetermined:"unbestimmt","event limit":"Grenze der Ereignisse",no:"nein",yes:"ja",none:"keine","not allow\
ed":"nicht erlaubt","and {count} more":"und {count} weitere","The article":"Der Artikel","Littlewood's hoop":"Littlewoods Reifen",Paradoxes:"Paradoxa",More:"Meh\
r","It hops: 3.1 m/s":"Er hüpft: 3,1 m/s","Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.":"Gleitet zweimal, verlässt dann ku\
rz vor einer vollen Umdrehung die Ebene und fliegt 0,76 s lang.","It slips: 2.8 m/s":"Er gleitet: 2,8 m/s","Friction is used up twice a turn; each slip is weake\
r than the one before, and none is the last.":"Zweimal je Umdrehung ist die Reibung ausgeschöpft; jeder Schlupf ist schwächer als der davor, und keiner ist der \
letzte.","It rolls: 2 m/s":"Er rollt: 2 m/s","Pure rolling, faster and more even than after a slow start, and close to the limit of friction.":"Reines Rollen, s\
chneller und gleichmäßiger als nach langsamem Start und nahe an der Grenze der Reibung.","The smallest push: 0.1 m/s":"Der kleinste Stoß: 0,1 m/s","Nearly at\
 rest with the load up, fast with the load down; 38 % of the friction is used.":"Fast in Ruhe mit der Last oben, schnell mit der Last unten; 38 % der Reibung we\
rden genutzt.","Low friction: 0.1 m/s, μ = 0.3":"Wenig Reibung: 0,1 m/s, μ = 0,3","Slipping costs the energy that a full turn needs: the hoop rocks to and fro\
.":"Das Gleiten kostet die Energie, die eine volle Umdrehung braucht: Der Reifen schaukelt hin und her.","All mass in the load":"Alle Masse in der Last","A mass\
less ring: at 90° no contact force is left; the load falls, the rim skims the plane.":"Ein masseloser Ring: Bei 90° ist keine Kontaktkraft mehr da; die Last fä\
llt, der Rand streift die Ebene.","All mass in the load, pushed":"Alle Masse in der Last, angestoßen","With a push the contact force is gone earlier, at cos θ \
= v₀²/(gR).":"Mit einem Stoß verschwindet die Kontaktkraft früher, bei cos θ = v₀²/(gR).","Nearly all mass in the load":"Fast alle Masse in der Last","\
γ = 0.99: what a real ring does instead of Littlewood's hop.":"γ = 0,99: was ein wirklicher Ring anstelle von Littlewoods Hüpfer tut.","Painlevé: no solution":"\
Painlevé: keine Lösung","No contact force agrees with this slip. An impact without collision stops it at once.":"Keine Kontaktkraft passt zu diesem Schlupf. E\
in Stoß ohne Aufprall beendet ihn sofort.","Flight and impact both agree with the laws. Choose which with the switch under Plane.":"Flug und Stoß passen beide \
zu den Gesetzen. Wähle mit dem Schalter unter „Ebene“.","A fast slide after a hop: the contact force grows without bound in finite time, and no law says wh\
at follows.":"Ein schnelles Gleiten nach einem Hüpfer: Die Kontaktkraft wächst in endlicher Zeit über alle Grenzen, und kein Gesetz sagt, was folgt.","Kane: \
energy out of nothing":"Kane: Energie aus dem Nichts","Newton's law of impact with friction creates two joules. Stronge's law does not.":"Newtons Stoßgesetz mit\
 Reibung erzeugt zwei Joule. Stronges Gesetz tut das nicht.",Downhill:"Bergab","On a slope of 10° the hoop gains speed from turn to turn, until it hops.":"Auf \
10° Neigung wird der Reifen von Umdrehung zu Umdrehung schneller, bis er hüpft.","Bounces without number":"Sprünge ohne Zahl","Dropped with spin and restitut\
ion 0.5: infinitely many bounces in finite time.":"Mit Drehung fallen gelassen, Stoßzahl 0,5: unendlich viele Sprünge in endlicher Zeit.","On the Moon":"Auf d\
em Mond","The article's hop under lunar gravity: everything is slower by a factor of 2.46.":"Der Hüpfer des Artikels mit Mondschwerkraft: Alles ist um den Fakto\
r 2,46 langsamer.","Motions to start from":"Bewegungen zum Beginnen","Motions to start from …":"Bewegungen zum Beginnen …","Undo (z)":"Rückgängig (z)","Re\
do (y)":"Wiederholen (y)",Compare:"Vergleichen","Compare two hoops":"Zwei Reifen vergleichen","Dark or light (d)":"Dunkel oder hell (d)","Keys and help (?)":"Ta\
sten und Hilfe (?)","Keys and help":"Tasten und Hilfe",lab:"Labor",Learn:"Lernen",Language:"Sprache","Hoop A":"Reifen A","Hoop B":"Reifen B","Which hoop the con\
trols change":"Welchen Reifen die Regler ändern",Parameters:"Parameter","Skip to the player":"Zum Abspieler springen",Hoop:"Reifen",Plane:"Ebene",Start:"Start",
Contact:"Kontakt","Given by":"Gegeben durch","load fraction γ":"Massenanteil γ","ε and κ":"ε und κ","real parts":"wirkliche Teile",Where:"Wo",elsewhere:"a\
nderswo","static and kinetic friction apart":"Haft- und Gleitreibung getrennt",Starts:"Startet",rolling:"rollend","in any state":"in beliebigem Zustand","auto {\
value}":"auto {value}","{name}, exact value in {unit}":"{name}, genauer Wert in {unit}","{name}, exact value":"{name}, genauer Wert",Ring:"Ring",Disk:"Scheibe",
"Point mass":"Punktmasse",Rod:"Stab",mass:"Masse","inner radius":"Innenradius","outer radius":"Außenradius",radius:"Radius","distance from centre":"Abstand vom\
 Mittelpunkt",length:"Länge","Add a part":"Ein Teil hinzufügen","+ add a part …":"+ ein Teil hinzufügen …","Remove part {number}, {what}":"Teil {number} \
entfernen, {what}","{name} = {value} must be {rule}.":"{name} = {value} muss {rule} sein.","{name} = {value} must be a number, such as 2.5.":"{name} = {value} m\
uss eine Zahl sein, etwa 2,5.","{name} = {value} must be a number.":"{name} = {value} muss eine Zahl sein.","from {least} to {most}":"von {least} bis {most}","f\
rom {least} to {most}, or inf":"von {least} bis {most} oder unendlich","0 or from {least} to {most}":"0 oder von {least} bis {most}","0 or from {least} to {most\
}, or inf":"0, von {least} bis {most} oder unendlich","at most {most} in the lab":"im Labor höchstens {most}","0 for the massless hoop (hoop.inertia_ratio = 0)":"\
für den masselosen Reifen 0 (hoop.inertia_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"für den masselosen Reifen „rigid“ (hoop.inertia\
_ratio = 0)","The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"Der Server antwortet nicht. Was hier ist, läu\
ft weiter; für Änderungen muss `hophoop lab` wieder laufen.","The server answered {status}.":"Der Server hat {status} geantwortet.","The notebook’s kernel doe\
s not answer; run the cell again.":"Der Kernel des Notebooks antwortet nicht; die Zelle noch einmal ausführen.",hoop:"Reifen",mode:"Phase",time:"Zeit",angle:"W\
inkel",gap:"Spalt","rim speed":"Randtempo",load:"Last","centre of gravity":"Schwerpunkt","the same in flight":"derselbe im Flug","A in front, B behind":"A vorn,\
 B hinten","The hoop":"Der Reifen","The hoop.":"Der Reifen.",Time:"Zeit","{time} seconds, {what}":"{time} Sekunden, {what}","Traces (t)":"Spuren (t)","Forces (f\
)":"Kräfte (f)","Rim speed (c)":"Randgeschwindigkeit (c)","Whole path (w)":"Ganzer Weg (w)","In space (3)":"Im Raum (3)",Traces:"Spuren",Forces:"Kräfte","Rim \
speed":"Randtempo","Whole path":"Ganzer Weg","Play (space)":"Abspielen (Leertaste)","Pause (space)":"Pause (Leertaste)","Speed of the film":"Tempo des Films","T\
o the start (Home)":"Zum Anfang (Pos1)","Previous event (Shift ←)":"Voriges Ereignis (Umschalt ←)","Next event (Shift →)":"Nächstes Ereignis (Umschalt →)",
"One frame back (←)":"Ein Bild zurück (←)","One frame on (→)":"Ein Bild weiter (→)",landing:"Landung","To the next flight (h)":"Zum nächsten Flug (h)",
"To the next landing (l)":"Zur nächsten Landung (l)","This motion has no flight.":"Diese Bewegung hat keinen Flug.","This motion has no landing.":"Diese Bewegu\
ng hat keine Landung.","{what} at {angle}, {time} s":"{what} bei {angle}, {time} s",start:"Start","slip begins":"Schlupf beginnt","slip ends":"Schlupf endet","s\
lip turns round":"Schlupf kehrt sich um","take-off":"Abheben","turns back":"kehrt um","highest point":"höchster Punkt","bounces end":"Sprünge enden","Painlevé\
: several solutions":"Painlevé: mehrere Lösungen","energy gain (Kane)":"Energiegewinn (Kane)","skimming begins":"Streifen beginnt","at rest":"in Ruhe",end:"En\
de","What happens":"Was geschieht","What happens to hoop {hoop}":"Was mit Reifen {hoop} geschieht","The motion in words":"Die Bewegung in Worten","(not all even\
ts are shown)":"(nicht alle Ereignisse sind gezeigt)","What theory says":"Was die Theorie sagt","What theory says of hoop {hoop}":"Was die Theorie zu Reifen {ho\
op} sagt",Velocities:"Geschwindigkeiten","velocity [m/s]":"Geschwindigkeit [m/s]","v (centre)":"v (Mittelpunkt)","Energies and losses":"Energien und Verluste","\
energy [J]":"Energie [J]",kinetic:"kinetisch",potential:"potenziell",total:"gesamt","lost to friction":"durch Reibung verloren","lost in the damper":"im Dämpfer\
 verloren","lost in impacts, normal part":"in Stößen verloren, Normalanteil","Contact forces":"Kontaktkräfte","force [N]":"Kraft [N]","normal N":"Normalkraft\
 N","friction F":"Reibungskraft F","Use of friction":"Ausnutzung der Reibung","Your choice":"Deine Wahl","What your diagram shows":"Was dein Diagramm zeigt","Ho\
rizontal axis of the diagrams":"Waagerechte Achse der Diagramme","over {quantity}":"über: {quantity}","Whole motion":"Ganze Bewegung","slide to go there, two f\
ingers zoom":"schieben, um dorthin zu gehen; zwei Finger vergrößern","click to go there, drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-cli\
ck for all":"klicken: dorthin gehen; ziehen: vergrößern; nach einem Klick oder mit Strg zoomt das Rad; Doppelklick: alles","{name} from {low} to {high}":"{nam\
e} von {low} bis {high}","Diagram: {title} in {unit}.":"Diagramm: {title} in {unit}.","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"{name} [{unit}]",
"angle within a turn":"Winkel innerhalb einer Umdrehung","place of the centre":"Ort des Mittelpunkts","gap under the rim":"Spalt unter dem Rand","height of the \
centre of gravity":"Höhe des Schwerpunkts","speed of the centre":"Geschwindigkeit des Mittelpunkts","speed of rotation":"Umfangsgeschwindigkeit","speed away fr\
om the plane":"Geschwindigkeit weg von der Ebene","slip velocity":"Schlupfgeschwindigkeit","angular velocity":"Winkelgeschwindigkeit","normal force":"Normalkraf\
t","friction force":"Reibungskraft","use of friction":"Ausnutzung der Reibung","kinetic energy":"kinetische Energie","potential energy":"potenzielle Energie","t\
otal energy":"Gesamtenergie","Plane of θ and θ̇":"Ebene von θ und θ̇","Plane of angle and angular velocity with the regions of rolling, slip and flight":"\
Ebene von Winkel und Winkelgeschwindigkeit mit den Gebieten von Rollen, Schlupf und Flug","angle θ within a turn [°]":"Winkel θ innerhalb einer Umdrehung [°]",
"Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"Farben: die Phase, die auf Kontakt ohne Schlupf folgt. S\
chraffiert: Schlupf, der auf das Painlevé-Paradoxon trifft.","Click to go there; two fingers zoom.":"Tippen: dorthin gehen; zwei Finger vergrößern.","Click t\
o go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Klicken: dorthin gehen; nach einem Klick oder mit Strg zoomt das Rad; Doppelkli\
ck: alles.",Map:"Karte",of:"von",Across:"Waagerecht",Up:"Senkrecht","What the map shows":"Was die Karte zeigt","Map of motions":"Karte der Bewegungen","Map of m\
otions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Karte der Bewegungen. Pfeiltasten bewegen die Marke, Eingabe übernimmt die Bewe\
gung, Plus und Minus zoomen.","Zoom into the map":"In die Karte hineinzoomen","Zoom out of the map":"Aus der Karte herauszoomen","Whole map":"Ganze Karte","Clic\
k to take that motion into the player; two fingers zoom.":"Tippen übernimmt die Bewegung in den Abspieler; zwei Finger vergrößern.","Click to take that motio\
n into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Ein Klick übernimmt die Bewegung in den Abspieler; nach ei\
nem Klick oder mit Strg zoomt das Rad; Ziehen verschiebt; Doppelklick: alles.","computing {count} motions …":"{count} Bewegungen werden berechnet …","{count\
} motions":"{count} Bewegungen","{count} motions, with rigid contact":"{count} Bewegungen, mit starrem Kontakt","of rolling starts, though this motion starts ot\
herwise":"rollender Starts, obwohl diese Bewegung anders beginnt","of starts in any state, though this motion starts rolling":"aus beliebigem Zustand, obwohl di\
ese Bewegung rollend beginnt","compiling the kernel of maps, this once: {done} of {all} functions":"der Rechenkern der Karten wird einmalig übersetzt: {done} vo\
n {all} Funktionen",Keep:"Behalten","Copy the link":"Link kopieren","Scenario (TOML)":"Szenario (TOML)","States (CSV)":"Zustände (CSV)","Motion (netCDF)":"Bewe\
gung (netCDF)","Events (JSON)":"Ereignisse (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Bild (PNG)","Record a film here (WebM)":"Hier einen Film aufnehmen\
 (WebM)","Show me the Python":"Das Python dazu zeigen","The same motion in Python":"Dieselbe Bewegung in Python","The link is copied.":"Der Link ist kopiert.","\
The link to this motion":"Der Link zu dieser Bewegung","The film is being made; this takes a while …":"Der Film wird gemacht; das dauert eine Weile …","Fetc\
hing {name} …":"{name} wird geholt …","{name} is there.":"{name} ist da.","This browser cannot record a canvas; take the MP4 instead.":"Dieser Browser kann \
die Zeichenfläche nicht aufnehmen; nimm stattdessen das MP4.","Recording one run …":"Ein Durchlauf wird aufgenommen …","The film is there.":"Der Film ist d\
a.","The scenario as a file":"Das Szenario als Datei",Copy:"Kopieren",Copied:"Kopiert",Close:"Schließen","A ring with a load on its rim rolls on a plane. Frict\
ion can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and \
see.":"Ein Ring mit einer Last am Rand rollt auf einer Ebene. Reibung hält nur begrenzt, und die Ebene kann nur drücken: Also gleitet er, hüpft, landet – oder t\
ut etwas, das die Mechanik starrer Körper nicht entscheiden kann. Bewege einen Regler und sieh zu.",Modes:"Phasen","Marks on the bar of time":"Zeichen auf der \
Zeitleiste",Keys:"Tasten",space:"Leertaste","play, pause":"abspielen, anhalten","one frame":"ein Bild","Shift ← →":"Umschalt ← →","previous, next event":"\
voriges, nächstes Ereignis","next flight, landing":"nächster Flug, nächste Landung","slower, faster":"langsamer, schneller","Home End":"Pos1 Ende","start, en\
d":"Anfang, Ende","traces, forces, rim speed, whole path":"Spuren, Kräfte, Randgeschwindigkeit, ganzer Weg","in space":"im Raum","zoom, zoom back":"zoomen, zur\
ück","leave a field, a menu, a picture that the wheel zooms":"ein Feld, ein Menü, ein Bild verlassen, das das Rad zoomt","z y  Ctrl Z":"z y  Strg Z","undo, re\
do":"rückgängig, wiederholen","dark, light":"dunkel, hell",Python:"Python","the rim does not slide":"der Rand gleitet nicht","slip: the rim turns too fast for\
 the way it goes (slip −, for a hoop that rolls ahead)":"Schlupf: Der Rand dreht sich zu schnell für seinen Weg (Schlupf −, wenn der Reifen vorwärts rollt)",
"slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"Schlupf: Der Rand gleitet voraus (Schlupf +, wenn der Reifen vorwärts rollt)","the hop: fro\
m take-off to landing":"der Hüpfer: vom Abheben bis zur Landung","a massless rim that touches without force":"ein masseloser Rand, der ohne Kraft berührt","ta\
ke-off, landing":"Abheben, Landung","Painlevé’s paradox: no solution, several":"Painlevé-Paradoxon: keine Lösung, mehrere","bounces without number end":"un\
zählige Sprünge enden","skimming begins, rest":"Streifen beginnt, Ruhe","Single keys (letters, digits, signs) do what the table says":"Einzelne Tasten (Buchst\
aben, Ziffern, Zeichen) tun, was die Tabelle sagt","The hoop in your hand":"Der Reifen in der Hand","Slope of the plane":"Neigung der Ebene","Tilt the plane: dr\
ag, or arrow keys":"Ebene neigen: ziehen oder Pfeiltasten","The hoop: height and speed":"Der Reifen: Höhe und Geschwindigkeit","Lift, roll or throw the hoop: d\
rag, or arrow keys":"Reifen heben, rollen oder werfen: ziehen oder Pfeiltasten","Angle of the load":"Winkel der Last","Turn the load: drag, or arrow keys":"Last\
 drehen: ziehen oder Pfeiltasten","gap {height}, speed {speed} m/s":"Spalt {height}, Geschwindigkeit {speed} m/s",Repeat:"Wiederholen","Slow motion: a tenth of \
the speed":"Zeitlupe: ein Zehntel des Tempos","Sound of the contact":"Klang des Kontakts","Presentation on the whole screen":"Vorführung auf dem ganzen Bildschi\
rm","Guided visit":"Geführter Besuch","Table of the motion":"Tabelle der Bewegung","Table of the motion, rows":"Tabelle der Bewegung, Zeilen",Presentation:"Vor\
führung","For teachers":"Für Lehrkräfte",Table:"Tabelle",Every:"Alle","Save as CSV":"Als CSV speichern",Columns:"Spalten","The first {count} rows.":"Die erst\
en {count} Zeilen.",Challenges:"Herausforderungen","Leave the challenges":"Herausforderungen verlassen","Which challenge":"Welche Herausforderung",Score:"Punkte",
"Begin again":"Von vorn beginnen","Show a best one":"Eine beste zeigen","{stars} {points} points. {what}":"{stars} {points} Punkte. {what}","Your best: {points}\
 points.":"Deine beste: {points} Punkte.","Hop highest":"Am höchsten hüpfen","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it st\
arts, and friction. How high can the hoop rise within 6 s?":"Auf ebenem Boden, rollend, mit höchstens 3,1 m/s: Du wählst die Last, wo sie beginnt, und die Reibu\
ng. Wie hoch kann der Reifen in 6 s steigen?","Land upright":"Aufrecht landen","Let the hoop land with its load at the very top. Everything is allowed; the firs\
t hop has to be at least 5 cm high.":"Lass den Reifen so landen, dass seine Last ganz oben ist. Alles ist erlaubt; der erste Hüpfer muss mindestens 5 cm hoch se\
in.","Hop without skidding":"Hüpfen ohne Rutschen","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at mo\
st 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Auf ebenem Boden beginnt der Reifen zu rollen, die Last unten, mit höchsten\
s 10 m/s, und μ ist höchstens 1,5. Vor dem Hüpfer darf er nicht rutschen; durchdrehen darf er. Wie hoch hüpft er?","Rigid contact only.":"Nur starrer Kontak\
t.","The plane must be level.":"Die Ebene muss waagerecht sein.","It must be on Earth.":"Es muss auf der Erde sein.","Restitution must be 0.":"Die Stoßzahl muss\
 0 sein.","The radius must stay 1 m, without parts.":"Der Radius muss 1 m bleiben, ohne Teile.","At most 90 % of the mass may be in the load.":"Höchstens 90 % d\
er Masse dürfen in der Last sein.","The hoop must be given by its load fraction.":"Der Reifen muss durch den Massenanteil der Last gegeben sein.","It must star\
t rolling.":"Er muss rollend beginnen.","At most 10 m/s.":"Höchstens 10 m/s.","At most 3.1 m/s.":"Höchstens 3,1 m/s.","At most 6 s.":"Höchstens 6 s.","It doe\
s not hop.":"Er hüpft nicht.","It rises by {height}.":"Er steigt um {height}.","The first hop is too low.":"Der erste Hüpfer ist zu niedrig.","It lands {off} \
away from the top.":"Er landet {off} neben der höchsten Stelle.","The load must start at the bottom.":"Die Last muss unten beginnen.","Friction must be at most\
 1.5.":"Die Reibungszahl darf höchstens 1,5 sein.","It skids before it hops.":"Er rutscht, bevor er hüpft.","New here?":"Neu hier?","Eight short questions: gu\
ess, then play.":"Acht kurze Fragen: erst raten, dann abspielen.","Start the visit":"Besuch beginnen","Not now":"Jetzt nicht","The hoop, before it is let go.":"\
Der Reifen, bevor er losgelassen wird.",Play:"Abspielen",Next:"Weiter",Back:"Zurück",Done:"Fertig","Step {number} of {all}":"Schritt {number} von {all}","Leave\
 the visit":"Besuch verlassen","First say what you expect, then play.":"Sag erst, was du erwartest, dann spiel ab.","Your guess":"Dein Tipp","{points} of 100 po\
ints.":"{points} von 100 Punkten.","You have {sum} of {most} points.":"Du hast {sum} von {most} Punkten.","{what} with the load at {angle}":"{what} mit der Last\
 bei {angle}","Draw the curve: pull the points up and down":"Zeichne die Kurve: zieh die Punkte auf und ab","Littlewood’s question":"Littlewoods Frage","A hoo\
p without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood asked in 1953 what happens when the wei\
ght is level with the centre.":"Ein Reifen ohne Masse trägt ein Gewicht am Rand. Mit dem Gewicht oben bekommt er den kleinsten Stoß und rollt. J. E. Littlewood \
fragte 1953, was geschieht, wenn das Gewicht auf der Höhe des Mittelpunkts ist.","What do you think?":"Was meinst du?","It rolls on.":"Er rollt weiter.","It ho\
ps: the hoop leaves the plane.":"Er hüpft: Der Reifen verlässt die Ebene.","The weight falls freely, and the hoop skims the plane below it.":"Das Gewicht fäll\
t frei, und der Reifen streift darunter die Ebene.","At {angle} there is no contact force any more.":"Bei {angle} gibt es keine Kontaktkraft mehr.","Littlewood \
said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop \
needs some mass in its rim.":"Littlewood sagte, der Reifen hüpfe. Doch die Kontaktkraft ist null, nicht nach oben gerichtet: Das Gewicht fällt frei, und ein Ran\
d ohne Masse folgt ihm die Ebene entlang. Zum Hüpfen braucht ein Reifen etwas Masse im Rand.","A ring with mass":"Ein Ring mit Masse","Now a quarter of the mas\
s is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"Jetzt steckt ein Viertel der Masse im Ring. Wieder ist die Last oben, und\
 der Reifen bekommt den kleinsten Stoß.","Draw how fast the hoop’s centre goes during the first turn.":"Zeichne, wie schnell der Mittelpunkt in der ersten Um\
drehung ist.","Speed of the centre":"Geschwindigkeit des Mittelpunkts","With the load at the bottom the centre has {speed} m/s.":"Mit der Last unten hat der Mit\
telpunkt {speed} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has \
lost: it is faster than a stone that falls from the same height.":"Der tiefste Punkt eines rollenden Reifens ruht. Dort hat die Last keine kinetische Energie, u\
nd der leichte Ring hat alles, was die schwere Last verloren hat: Er ist schneller als ein Stein, der aus derselben Höhe fällt.","Why it slips":"Warum er glei\
tet","A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Ein kräftigerer Stoß: 2,8 m/s oben. Rollen brau\
cht Reibung, und Reibung hat eine Grenze: Sie ist höchstens μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"Wo ist die L\
ast, wenn die Reibung zum ersten Mal nachgibt? Dreh die Marke.","Angle of the load where it begins to slip":"Winkel der Last, wo er zu gleiten beginnt","It begi\
ns to slip at {angle}. There the plane carries only {share} of the weight.":"Er beginnt bei {angle} zu gleiten. Dort trägt die Ebene nur {share} des Gewichts.",
"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagra\
m ‘Use of friction’: it comes to 1.":"Die Last drückt auf ihrem Weg hinab und herum kaum auf die Ebene, N ist also klein, während der Ring schneller werden \
muss: Das braucht Reibung. Sieh das Diagramm „Ausnutzung der Reibung“: Sie erreicht 1.","The hop":"Der Hüpfer","A little faster, 3.1 m/s. This time the hoo\
p leaves the plane, before the first turn is over.":"Etwas schneller, 3,1 m/s. Diesmal verlässt der Reifen die Ebene, bevor die erste Umdrehung vorbei ist.","W\
here is the load when the hoop takes off? Turn the mark.":"Wo ist die Last, wenn der Reifen abhebt? Dreh die Marke.","Angle of the load where it takes off":"Win\
kel der Last beim Abheben","It takes off at {angle}, while its rim slips at {slip} m/s.":"Er hebt bei {angle} ab, während sein Rand mit {slip} m/s gleitet.","A\
 rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pu\
lls it off the plane before it is at the top.":"Einen rollenden Reifen würde die Ebene bremsen, während die Last hochkommt. Dafür ist die Reibung zu schwach: De\
r Rand dreht durch, der Reifen dreht schnell weiter, und die Last zieht ihn von der Ebene, bevor sie oben ist.","The landing":"Die Landung","The hoop is in the \
air. Its centre of gravity goes on a parabola, and it turns evenly.":"Der Reifen ist in der Luft. Sein Schwerpunkt fliegt auf einer Parabel, und er dreht sich g\
leichmäßig.","What does it do just after it has landed?":"Was tut er gleich nach der Landung?","It rolls at once.":"Er rollt sofort.","It skids: the rim slide\
s ahead.":"Er rutscht: Der Rand gleitet voraus.","It spins: the rim turns too fast.":"Er dreht durch: Der Rand dreht sich zu schnell.","It bounces.":"Er springt\
 wieder ab.","It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.":"Er war {time} s in der Luft und stieg um {height} cm;\
 er landet mit der Last bei {angle}.","An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With less frictio\
n, or more restitution, the landing would be another one. Try it afterwards.":"Ein Stoß braucht keine Zeit, doch seine Reibung ist so stark wie sein Druck: Hier\
 genügt sie, um allen Schlupf zu beenden. Mit weniger Reibung oder größerer Stoßzahl wäre die Landung eine andere. Probier es nachher aus.","More friction,\
 more hop?":"Mehr Reibung, mehr Hüpfen?","Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.":"Drei Reifen bekommen denselben\
 Stoß von 3,1 m/s, auf Ebenen mit der Reibungszahl 0,05, 0,2 und 1,0.","Which of them hops highest?":"Welcher hüpft am höchsten?","They rise by {low} cm, {mi\
ddle} cm and {high} cm. (The first two are A and B.)":"Sie steigen um {low} cm, {middle} cm und {high} cm. (Die ersten beiden sind A und B.)","On ice nothing dr\
ives the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is br\
aked on the way up.":"Auf Eis treibt nichts die Drehung an; mit endloser Reibung gleitet nichts. Der Hüpfer braucht beides: genug Reibung, um den Reifen auf dem\
 Weg hinab schnell zu drehen, und nicht so viel, dass er auf dem Weg hinauf gebremst wird.","What rigid bodies cannot decide":"Was starre Körper nicht entscheid\
en","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Ein Reifen wird so \
geworfen, dass er schnell über eine raue Ebene gleitet. Die Gesetze starrer Körper mit trockener Reibung müssen sagen, was als Nächstes geschieht.","What do\
 they say?":"Was sagen sie?","It flies off.":"Er fliegt davon.","An impact stops the slide at once.":"Ein Stoß beendet das Gleiten sofort.","Both agree with th\
e laws.":"Beides passt zu den Gesetzen.","Hoop A and hoop B start alike, and both motions obey every law.":"Reifen A und Reifen B beginnen gleich, und beide Bew\
egungen befolgen jedes Gesetz.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little,\
 and that decides: choose the compliant contact under ‘Contact’.":"Painlevé fand dies 1895. Für einen starren Körper haben die Gesetze hier zwei Antworten, \
in anderen Zuständen keine. Wirkliche Körper geben etwas nach, und das entscheidet: Wähle unter „Kontakt“ den nachgiebigen.","Your turn":"Du bist dran","\
Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the moti\
on itself.":"Nimm den Reifen: Dreh die Last, heb ihn an und lass ihn fallen, stoß ihn an, neige die Ebene. Oder nimm eine Herausforderung an, und sieh, wie dein\
e Punkte aus der Bewegung selbst berechnet werden.","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Den Reifen einm\
al in voller Geschwindigkeit zeigen, ohne Kommentar. „Ich stoße ihn an. Rollt er nur?“","Everybody predicts where the load is at take-off. Count the votes \
by quarters of the turn.":"Alle sagen voraus, wo die Last beim Abheben ist. Stimmen nach Vierteln der Umdrehung zählen.","Energy on the way down, in pairs: who\
 has the energy when the load is at rest?":"Energie auf dem Weg hinab, zu zweit: Wer hat die Energie, wenn die Last ruht?","Lift at the top: at which speed is t\
he force of the floor zero?":"Abheben oben: Bei welcher Geschwindigkeit ist die Kraft des Bodens null?","The film again, in slow motion and with forces; stop at\
 take-off. Compare with the votes.":"Der Film noch einmal, in Zeitlupe und mit Kräften; beim Abheben anhalten. Mit den Stimmen vergleichen.","Each group takes \
one speed of the worksheet; results on the board.":"Jede Gruppe nimmt eine Geschwindigkeit des Arbeitsblatts; Ergebnisse an die Tafel.","Why? What has to brake \
the rotation on the way up, how strong can it be, and what if it is too weak?":"Warum? Was muss die Drehung auf dem Weg hinauf bremsen, wie stark kann es sein, \
und was, wenn es zu schwach ist?","One sentence each: “The hoop hops because …”":"Ein Satz von jedem: „Der Reifen hüpft, weil …“","The load pulls t\
he hoop up at the top, so it hops there.":"Die Last zieht den Reifen oben hoch, also hüpft er dort.","Only if it is very fast. Slower hoops hop before the top,\
 after slipping.":"Nur wenn er sehr schnell ist. Langsamere Reifen hüpfen vor der höchsten Stelle, nach dem Gleiten.","It hops at the bottom, where it is fast\
est.":"Er hüpft unten, wo er am schnellsten ist.","There the floor pushes hardest: the load has to be turned upwards.":"Dort drückt der Boden am stärksten: Die\
 Last muss nach oben umgelenkt werden.","Nothing can be faster than a falling stone.":"Nichts kann schneller sein als ein fallender Stein.","The ring can: it ge\
ts the energy of a load that has come to rest.":"Der Ring schon: Er bekommt die Energie einer Last, die zur Ruhe gekommen ist.","Friction always brakes.":"Reibu\
ng bremst immer.","It acts against slip. On the hoop’s way up it points forwards.":"Sie wirkt gegen den Schlupf. Auf dem Weg hinauf zeigt sie nach vorn.","Mor\
e friction, more hop.":"Mehr Reibung, mehr Hüpfen.","There is a best friction in between.":"Dazwischen gibt es eine beste Reibungszahl.","A heavier hoop behave\
s otherwise.":"Ein schwererer Reifen verhält sich anders.","Only the shares of mass count.":"Nur die Anteile der Massen zählen.","Before the film: where is th\
e load when the hoop leaves the floor? Mark the place and give one reason.":"Vor dem Film: Wo ist die Last, wenn der Reifen den Boden verlässt? Markiere die Ste\
lle und nenne einen Grund.","The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?":"Der R\
eifen bekommt nur den kleinsten Stoß und rollt. Wie viel potenzielle Energie ist frei geworden, wenn die Last unten ist?","While a wheel rolls, its lowest poin\
t is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"Wenn ein Rad rollt, ruht sein tiefster Punkt. Welcher Teil des Reife\
ns hat dann kinetische Energie, und wie schnell ist der Mittelpunkt?","How fast is a stone that falls from the height of the load? Why can the hoop be faster?":"\
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
y student.":"Der Besuch fragt, bevor er zeigt; die Vorführung füllt den Bildschirm; die Tabelle gibt allen Zahlen.",inf:"inf","greater than {least}":"größer a\
ls {least}","at least {least}":"mindestens {least}","at least {least} (inf is allowed)":"mindestens {least} (inf ist erlaubt)","at most {most}":"höchstens {most\
}","a finite number":"eine endliche Zahl","a whole number":"eine ganze Zahl","'{word}' or '{word2}'":"„{word}“ oder „{word2}“","'{word}', '{word2}' or '\
{word3}'":"„{word}“, „{word2}“ oder „{word3}“","Rolling resistance":"Rollwiderstand","Rolling resistance: couple against the rotation over R N":"Rol\
lwiderstand: Moment gegen die Drehung, geteilt durch R N","Slips, hops":"Gleitet, hüpft","no threshold uphill (β < 0): whether it slips or hops hangs on where \
it turns back; the map shows it":"bergauf (β < 0) keine Schwelle: Ob er gleitet oder hüpft, hängt davon ab, wo er umkehrt; die Karte zeigt es","'rigid' for a\
 map":"für eine Karte „rigid“","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells mal y.cells = {cells} darf im Labor höchstens \
{most} sein.","{one} and {other} cannot both be axes: they say the same thing in two ways.":"{one} und {other} können nicht beide Achsen sein: Sie sagen dasselb\
e auf zwei Arten.","x.path and y.path are both {path} and must differ.":"x.path und y.path sind beide {path} und müssen verschieden sein.","lost to rolling res\
istance":"durch Rollwiderstand verloren","Rolling resistance f":"Rollwiderstand f","{name} = {value} must lie between -pi/2 and pi/2 (radians).":"{name} = {valu\
e} muss zwischen -pi/2 und pi/2 liegen (Radiant).","{word} is not a known key; known are {word2}.":"{word} ist kein bekannter Schlüssel; bekannt sind {word2}.",
"{one} cannot be given together with {other}.":"{one} kann nicht zusammen mit {other} gegeben werden.","{one} = {value} must not exceed {other} = {limit}.":"{on\
e} = {value} darf {other} = {limit} nicht übersteigen.","plane.mu_static = inf must be finite with contact.model = 'compliant'.":"plane.mu_static = inf muss be\
i contact.model = 'compliant' endlich sein.","hoop.parts must not be empty.":"hoop.parts darf nicht leer sein.","This takes longer than {time} s; ask for a shor\
ter motion or fewer cells.":"Das dauert länger als {time} s; verlange eine kürzere Bewegung oder weniger Zellen.","The lab is busy; try again in {time} second\
s.":"Das Labor ist beschäftigt; in {time} Sekunden noch einmal versuchen.","The lab is busy; try again in 1 second.":"Das Labor ist beschäftigt; in 1 Sekunde n\
och einmal versuchen.","The computation failed.":"Die Rechnung ist gescheitert.","The process that computed this has ended.":"Der Prozess, der dies berechnet ha\
t, ist beendet.","duration = {value} must be at most {most} s in the lab; the library itself has no such limit.":"duration = {value} darf im Labor höchstens {mo\
st} s sein; die Bibliothek selbst hat keine solche Grenze.","duration = {value} s at this speed and radius is about {turns} revolutions and must be at most {mos\
t} in the lab; the library itself has no such limit.":"duration = {value} s sind bei dieser Geschwindigkeit und diesem Radius etwa {turns} Umdrehungen, im Labor\
 höchstens {most}; die Bibliothek selbst hat keine solche Grenze.","hoop.parts has {count} parts and must have at most {most} in the lab.":"hoop.parts hat {cou\
nt} Teile und darf im Labor höchstens {most} haben.","contact.stiffness, contact.slip_speed and duration need about {steps} steps of integration and must need \
at most {most} in the lab.":"contact.stiffness, contact.slip_speed und duration brauchen etwa {steps} Integrationsschritte, im Labor höchstens {most}.","A cell\
 of this map is about {turns} revolutions and must be at most {most} in the lab.":"Eine Zelle dieser Karte sind etwa {turns} Umdrehungen, im Labor höchstens {mo\
st}.","x and y make {count} cells of about {turns} revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter durati\
on.":"x und y ergeben {count} Zellen mit zusammen etwa {turns} Umdrehungen, im Labor höchstens {most}; nimm weniger Zellen, kleinere Geschwindigkeiten oder eine\
 kürzere Dauer.","duration = {value} must be at most {most} s for a film from the lab.":"duration = {value} darf für einen Film aus dem Labor höchstens {most} \
s sein.","A blue, B ochre; the dashes tell the quantities; numbers of {hoop}; {hands}":"A blau, B ocker; die Strichart nennt die Größe; Zahlen von {hoop}; {hand\
s}","What comes after {time} s hangs on more digits than the numbers of this page have; hophoop lab and Python take as many as it needs.":"Was nach {time} s kom\
mt, hängt an mehr Stellen, als die Zahlen dieser Seite haben; hophoop lab und Python nehmen so viele, wie nötig sind.","hophoop lab: play with the hopping hoo\
p":"hophoop-Labor: mit dem hüpfenden Reifen spielen","Put a hopping hoop into a page of yours":"Einen hüpfenden Reifen in die eigene Seite setzen","One tag an\
d one script show a live hoop in a blog, a course page or slides. The motion is computed in the reader’s browser; nothing is sent anywhere.":"Ein Tag und ein \
Skript zeigen einen lebendigen Reifen in einem Blog, auf einer Kursseite oder auf Folien. Die Bewegung wird im Browser der Lesenden berechnet; nichts wird irgen\
dwohin gesendet.","Choose a motion in the lab, and copy its link here.":"Im Labor eine Bewegung wählen und ihren Link hierher kopieren.","Scenario: a link of t\
he lab, or what stands behind its question mark":"Szenario: ein Link des Labors, oder was hinter seinem Fragezeichen steht","What stands beside the player":"Was\
 neben dem Abspieler steht",sliders:"Regler",diagrams:"Diagramme",theory:"Theorie",map:"Karte","As a tag":"Als Tag","The tag":"Der Tag","Copy the tag":"Den Tag \
kopieren","As a frame, where scripts are not allowed":"Als Rahmen, wo Skripte nicht erlaubt sind","The frame":"Der Rahmen","Copy the frame":"Den Rahmen kopieren",
"As a QR code":"Als QR-Code","How it looks":"Wie es aussieht","Copied.":"Kopiert.","A hopping hoop":"Ein hüpfender Reifen","Picture (SVG)":"Bild (SVG)","A pict\
ure in space has no lines to keep: take the PNG, or leave 3D.":"Ein räumliches Bild hat keine Linien, die bleiben: nimm das PNG oder verlasse 3D.","The picture\
 is too large for this browser.":"Das Bild ist für diesen Browser zu groß."};var Un={roll:"rodadura",spin:"patinaje",skid:"derrape",flight:"vuelo",skim:"roce","slip −":"deslizamiento −","slip +":"deslizamiento +",rolls:"rueda",spins:"\
patina",skids:"derrapa",flies:"vuela","skims the plane":"roza el plano","rolls at {angle}":"rueda desde {angle}","spins at {angle}":"patina desde {angle}","skid\
s at {angle}":"derrapa desde {angle}","flies at {angle}":"vuela desde {angle}","skims the plane at {angle}":"roza el plano desde {angle}","hops at {angle}":"sal\
ta a {angle}","lands at {angle}":"aterriza a {angle}","bounces at {angle}":"rebota a {angle}","slips the other way at {angle}":"desliza en sentido contrario des\
de {angle}","stops its slip at once at {angle}":"deja de deslizar de golpe a {angle}","turns back at {angle}":"da la vuelta a {angle}","has bounced out at {angl\
e}":"termina de rebotar a {angle}","meets Painlevé's paradox at {angle}":"encuentra la paradoja de Painlevé a {angle}","meets Painlevé's indeterminacy at {ang\
le}":"encuentra la indeterminación de Painlevé a {angle}","jams at {angle}":"se bloquea a {angle}","gains energy (Kane) at {angle}":"gana energía (Kane) a {an\
gle}","skims at {angle}":"roza desde {angle}","rests at {angle}":"reposa a {angle}","starts at {angle}":"empieza a {angle}","slips at {angle}":"desliza desde {a\
ngle}","{what} and {count} more times":"{what} y {count} veces más","… ({count} more)":"… ({count} más)","It has come to rest.":"Ha quedado en reposo.","T\
he normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.":"La fuerza normal crece sin límite (bloqueo dinámico): la mecánic\
a del sólido rígido no da ningún movimiento más allá.","The model does not determine the motion beyond.":"El modelo no determina el movimiento posterior.",
"The limit of events (contact.max_events), or of work for one motion, was reached before the end.":"Se alcanzó el límite de sucesos (contact.max_events), o de c\
álculo para un movimiento, antes del final.","It starts and {verb} with the load at {angle} and the centre at {speed} m/s.":"Empieza y {verb}, con la carga a {\
angle} y el centro a {speed} m/s.","It starts in the air with the load at {angle} and the centre at {speed} m/s.":"Empieza en el aire, con la carga a {angle} y \
el centro a {speed} m/s.","It starts skimming with the load at {angle} and the centre at {speed} m/s.":"Empieza rozando el plano, con la carga a {angle} y el ce\
ntro a {speed} m/s.","It {verb} at {angle}; friction is used up: the rim turns too fast for the way it goes.":"A {angle} {verb}: el rozamiento está agotado y la\
 llanta gira demasiado deprisa para lo que avanza.","It {verb} at {angle}; friction is used up: the rim slides ahead.":"A {angle} {verb}: el rozamiento está ago\
tado y la llanta desliza hacia delante.","It rolls again at {angle}; the slip has stopped.":"A {angle} vuelve a rodar; el deslizamiento ha cesado.","The slip tu\
rns round at {angle}; it {verb}.":"A {angle} se invierte el deslizamiento; {verb}.","It hops at {angle}.":"Salta a {angle}.","It hops at {angle}. It rises {heig\
ht} and stays up for {time} s.":"Salta a {angle}. Sube {height} y permanece {time} s en el aire.","An impact without collision at {angle} stops the slip; then i\
t {verb}.":"Un impacto sin choque a {angle} detiene el deslizamiento; luego {verb}.","It lands at {angle} with {speed} m/s downwards and bounces.":"Aterriza a {\
angle} con {speed} m/s hacia abajo y rebota.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Aterriza a {angle} con {speed} m/s hacia abajo y {ve\
rb}.","It turns back at {angle}.":"Da la vuelta a {angle}.","It turns back at {angle}, and {verb} now.":"Da la vuelta a {angle}, y ahora {verb}.","The centre is\
 highest at {angle}: the gap is {height}.":"El centro está más alto a {angle}: la separación es de {height}.","Bounces without number end here, at {angle}.":"\
Aquí, a {angle}, terminan infinitos rebotes.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Paradoja de Painlevé a {angle}: ningun\
a fuerza de contacto es compatible con este deslizamiento.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Paradoja de Painlevé a {ang\
le}: varias fuerzas de contacto son compatibles.","Dynamic jam at {angle}: the contact force grows without bound.":"Bloqueo dinámico a {angle}: la fuerza de con\
tacto crece sin límite.","Newton's law of impact has created {energy} J (Kane's example).":"La ley de impacto de Newton ha creado {energy} J (ejemplo de Kane).",
"No contact force is left at {angle}: the load falls freely and the rim skims the plane.":"A {angle} ya no hay fuerza de contacto: la carga cae libremente y la \
llanta roza el plano.","It rests at {angle}.":"Reposa a {angle}.","It rests at {angle}, which is not stable.":"Reposa a {angle}, pero no de forma estable.","It \
bounces {count} more times.":"Rebota {count} veces más.","… and {count} more.":"… y {count} más.",Slips:"Desliza",Hops:"Salta","Hops at once":"Salta de in\
mediato","Friction for pure rolling":"Rozamiento para rodadura pura","Painlevé’s paradox":"Paradoja de Painlevé","Dynamic jam":"Bloqueo dinámico","Rests st\
ably":"Reposo estable","End of rolling":"Fin de la rodadura","would slip above {speed} m/s":"deslizaría por encima de {speed} m/s","would slip: any push is eno\
ugh":"deslizaría: basta cualquier empujón","would hop in its first turn above {speed} m/s":"saltaría en la primera vuelta por encima de {speed} m/s","would h\
op in its first turn: any push is enough":"saltaría en la primera vuelta: basta cualquier empujón","would hop at once above {speed} m/s":"saltaría de inmediat\
o por encima de {speed} m/s","would hop at once: at any speed":"saltaría de inmediato: a cualquier velocidad","never, at any speed":"nunca, a ninguna velocidad",
"no friction keeps it rolling":"ningún rozamiento lo mantiene rodando","μ = {mu} would keep it rolling (enough here)":"μ = {mu} lo mantendría rodando (aquí ba\
sta)","μ = {mu} would keep it rolling (more than there is)":"μ = {mu} lo mantendría rodando (más de lo que hay)",never:"nunca","from μ = {mu} on, at {angle}\
: possible here":"desde μ = {mu}, a {angle}: aquí es posible","from μ = {mu} on, at {angle}: not here":"desde μ = {mu}, a {angle}: aquí no","can end a slip\
 at {angles}":"puede acabar un deslizamiento a {angles}","with the load at {angle}":"con la carga a {angle}","at {angle} friction is used up":"a {angle} se agot\
a el rozamiento","at {angle} the contact force is gone":"a {angle} desaparece la fuerza de contacto","Load fraction":"Fracción de la carga","Share of the mass \
in the load of an ideal hoop":"Parte de la masa que está en la carga de un aro ideal",Eccentricity:"Excentricidad","Distance of the centre of gravity from the \
centre, over the radius":"Distancia del centro de gravedad al centro, dividida por el radio","Inertia ratio":"Momento de inercia relativo","Moment of inertia ab\
out the centre of gravity over m R²":"Momento de inercia respecto al centro de gravedad, dividido por m R²",Radius:"Radio","Rim radius":"Radio de la llanta",Mass:"\
Masa","Total mass":"Masa total",Friction:"Coeficiente de rozamiento","Friction, static and kinetic":"Coeficiente de rozamiento, estático y cinético","Static f\
riction":"Rozamiento estático","Kinetic friction":"Rozamiento cinético",Slope:"Inclinación","Slope of the plane, downhill along +x":"Inclinación del plano, c\
uesta abajo hacia +x",Gravity:"Gravedad",Restitution:"Restitución","Restitution of an impact":"Coeficiente de restitución de un impacto",Speed:"Velocidad","Ve\
locity of the centre in a rolling start":"Velocidad del centro en una salida rodando","Load angle":"Ángulo de la carga","Angle from the plane's normal to the c\
entre of gravity":"Ángulo desde la normal del plano hasta el centro de gravedad","Height of the gap":"Altura de la separación","Gap between rim and plane":"Se\
paración entre la llanta y el plano","Speed along":"Velocidad a lo largo","Velocity of the centre along the plane":"Velocidad del centro a lo largo del plano",
"Speed upwards":"Velocidad hacia arriba","Velocity of the centre away from the plane":"Velocidad del centro alejándose del plano","Angular velocity":"Velocidad\
 angular",Stiffness:"Rigidez","Stiffness of the contact":"Rigidez del contacto","Slip speed":"Velocidad de deslizamiento","Slip velocity over which friction bui\
lds up":"Velocidad de deslizamiento en la que se establece el rozamiento","Restitution that the damping is chosen for":"Restitución para la que se elige el amor\
tiguamiento",Duration:"Duración","Duration of the motion":"Duración del movimiento","Law of impact":"Ley de impacto","Law of restitution":"Ley de restitución",
"Stronge (energy)":"Stronge (energía)","Poisson (impulse)":"Poisson (impulso)","Newton (velocity)":"Newton (velocidad)","Painlevé: two solutions":"Painlevé: d\
os soluciones","What follows an indeterminate contact":"Qué sigue a un contacto indeterminado",impact:"impacto","Contact model":"Modelo de contacto",rigid:"ríg\
ido",compliant:"flexible","Normal force":"Fuerza normal","Friction law":"Ley de rozamiento","Regularised friction":"Rozamiento regularizado","smooth (tanh)":"su\
ave (tanh)",linear:"lineal","bristle (can hold)":"cerdas (puede sujetar)","Kelvin–Voigt":"Kelvin–Voigt","Hunt–Crossley":"Hunt–Crossley","Speed v₀":"Ve\
locidad v₀","Angle of the load θ₀":"Ángulo de la carga θ₀","Speed along ẋ₀":"Velocidad a lo largo ẋ₀","Angular velocity θ̇₀":"Velocidad ang\
ular θ̇₀","Height of the gap y₀":"Altura de la separación y₀","Load fraction γ":"Fracción de la carga γ","Eccentricity ε":"Excentricidad ε","Inert\
ia ratio κ":"Momento de inercia relativo κ","Radius R":"Radio R","Friction μ":"Rozamiento μ","Slope β":"Inclinación β","Gravity g":"Gravedad g","Restitut\
ion e":"Restitución e",Earth:"Tierra",Moon:"Luna",Mars:"Marte",Jupiter:"Júpiter",Weightless:"Ingravidez","what happens in the first turn":"lo que ocurre en la\
 primera vuelta","height of the first hop":"altura del primer salto","angle of take-off":"ángulo de despegue","duration of the first hop":"duración del primer \
salto","greatest friction utilization":"mayor uso del rozamiento","energy lost":"energía perdida","angle at the end":"ángulo final","Painlevé’s paradox or jam\
 met":"paradoja de Painlevé o bloqueo","how it ends":"cómo termina",duration:"duración",revolutions:"vueltas",reversal:"inversión",takeoff:"despegue",rest:"\
reposo",jam:"bloqueo",undetermined:"indeterminado","event limit":"límite de sucesos",no:"no",yes:"sí",none:"ninguno","not allowed":"no permitido","and {count}\
 more":"y {count} más","The article":"El artículo","Littlewood's hoop":"El aro de Littlewood",Paradoxes:"Paradojas",More:"Más","It hops: 3.1 m/s":"Salta: 3,1\
 m/s","Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.":"Desliza dos veces, luego deja el plano justo antes de dar una vuelta y\
 vuela durante 0,76 s.","It slips: 2.8 m/s":"Desliza: 2,8 m/s","Friction is used up twice a turn; each slip is weaker than the one before, and none is the last.":"\
El rozamiento se agota dos veces por vuelta; cada deslizamiento es más débil que el anterior, y ninguno es el último.","It rolls: 2 m/s":"Rueda: 2 m/s","Pure\
 rolling, faster and more even than after a slow start, and close to the limit of friction.":"Rodadura pura, más rápida y uniforme que tras una salida lenta, y \
cerca del límite del rozamiento.","The smallest push: 0.1 m/s":"El menor empujón: 0,1 m/s","Nearly at rest with the load up, fast with the load down; 38 % of \
the friction is used.":"Casi en reposo con la carga arriba, rápido con la carga abajo; se usa el 38 % del rozamiento.","Low friction: 0.1 m/s, μ = 0.3":"Poco \
rozamiento: 0,1 m/s, μ = 0,3","Slipping costs the energy that a full turn needs: the hoop rocks to and fro.":"Deslizar cuesta la energía que exige una vuelta e\
ntera: el aro se balancea.","All mass in the load":"Toda la masa en la carga","A massless ring: at 90° no contact force is left; the load falls, the rim skims t\
he plane.":"Un anillo sin masa: a 90° ya no hay fuerza de contacto; la carga cae y la llanta roza el plano.","All mass in the load, pushed":"Toda la masa en la\
 carga, con empujón","With a push the contact force is gone earlier, at cos θ = v₀²/(gR).":"Con un empujón la fuerza de contacto desaparece antes, a cos θ \
= v₀²/(gR).","Nearly all mass in the load":"Casi toda la masa en la carga","γ = 0.99: what a real ring does instead of Littlewood's hop.":"γ = 0,99: lo que \
hace un anillo real en lugar del salto de Littlewood.","Painlevé: no solution":"Painlevé: ninguna solución","No contact force agrees with this slip. An impac\
t without collision stops it at once.":"Ninguna fuerza de contacto es compatible con este deslizamiento. Un impacto sin choque lo detiene de golpe.","Flight and\
 impact both agree with the laws. Choose which with the switch under Plane.":"Vuelo e impacto cumplen ambos las leyes. Elige con el selector de «Plano».","A f\
ast slide after a hop: the contact force grows without bound in finite time, and no law says what follows.":"Un deslizamiento rápido tras un salto: la fuerza de\
 contacto crece sin límite en un tiempo finito, y ninguna ley dice qué sigue.","Kane: energy out of nothing":"Kane: energía de la nada","Newton's law of impa\
ct with friction creates two joules. Stronge's law does not.":"La ley de impacto de Newton con rozamiento crea dos julios. La de Stronge, no.",Downhill:"Cuesta \
abajo","On a slope of 10° the hoop gains speed from turn to turn, until it hops.":"En una pendiente de 10° el aro gana velocidad vuelta a vuelta, hasta que sal\
ta.","Bounces without number":"Rebotes sin número","Dropped with spin and restitution 0.5: infinitely many bounces in finite time.":"Soltado con giro y restitu\
ción 0,5: infinitos rebotes en un tiempo finito.","On the Moon":"En la Luna","The article's hop under lunar gravity: everything is slower by a factor of 2.46.":"\
El salto del artículo con gravedad lunar: todo es 2,46 veces más lento.","Motions to start from":"Movimientos para empezar","Motions to start from …":"Movim\
ientos para empezar…","Undo (z)":"Deshacer (z)","Redo (y)":"Rehacer (y)",Compare:"Comparar","Compare two hoops":"Comparar dos aros","Dark or light (d)":"Oscur\
o o claro (d)","Keys and help (?)":"Teclas y ayuda (?)","Keys and help":"Teclas y ayuda",lab:"laboratorio",Learn:"Aprender",Language:"Idioma","Hoop A":"Aro A","\
Hoop B":"Aro B","Which hoop the controls change":"Qué aro cambian los controles",Parameters:"Parámetros","Skip to the player":"Ir al reproductor",Hoop:"Aro",Plane:"\
Plano",Start:"Inicio",Contact:"Contacto","Given by":"Dado por","load fraction γ":"fracción de carga γ","ε and κ":"ε y κ","real parts":"piezas reales",Where:"\
Dónde",elsewhere:"otro lugar","static and kinetic friction apart":"rozamiento estático y cinético por separado",Starts:"Empieza",rolling:"rodando","in any st\
ate":"en cualquier estado","auto {value}":"auto {value}","{name}, exact value in {unit}":"{name}, valor exacto en {unit}","{name}, exact value":"{name}, valor e\
xacto",Ring:"Anillo",Disk:"Disco","Point mass":"Masa puntual",Rod:"Varilla",mass:"masa","inner radius":"radio interior","outer radius":"radio exterior",radius:"\
radio","distance from centre":"distancia al centro",length:"longitud","Add a part":"Añadir una pieza","+ add a part …":"+ añadir una pieza…","Remove part \
{number}, {what}":"Quitar la pieza {number}, {what}","{name} = {value} must be {rule}.":"{name} = {value} debe ser {rule}.","{name} = {value} must be a number, \
such as 2.5.":"{name} = {value} debe ser un número, como 2,5.","{name} = {value} must be a number.":"{name} = {value} debe ser un número.","from {least} to {m\
ost}":"de {least} a {most}","from {least} to {most}, or inf":"de {least} a {most}, o inf","0 or from {least} to {most}":"0 o de {least} a {most}","0 or from {le\
ast} to {most}, or inf":"0, de {least} a {most}, o inf","at most {most} in the lab":"como mucho {most} en el laboratorio","0 for the massless hoop (hoop.inertia\
_ratio = 0)":"0 para el aro sin masa (hoop.inertia_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"«rigid» para el aro sin masa (hoop.iner\
tia_ratio = 0)","The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.":"El servidor no responde. Lo que hay aquí s\
igue funcionando; para cambios hay que volver a ejecutar `hophoop lab`.","The server answered {status}.":"El servidor respondió {status}.","The notebook’s kern\
el does not answer; run the cell again.":"El núcleo del cuaderno no responde; vuelva a ejecutar la celda.",hoop:"aro",mode:"fase",time:"tiempo",angle:"ángulo",
gap:"separación","rim speed":"vel. de la llanta",load:"carga","centre of gravity":"centro de gravedad","the same in flight":"el mismo en vuelo","A in front, B \
behind":"A delante, B detrás","The hoop":"El aro","The hoop.":"El aro.",Time:"Tiempo","{time} seconds, {what}":"{time} segundos, {what}","Traces (t)":"Trayecto\
rias (t)","Forces (f)":"Fuerzas (f)","Rim speed (c)":"Velocidad de la llanta (c)","Whole path (w)":"Todo el recorrido (w)","In space (3)":"En el espacio (3)",Traces:"\
Trayectorias",Forces:"Fuerzas","Rim speed":"Vel. llanta","Whole path":"Recorrido","Play (space)":"Reproducir (espacio)","Pause (space)":"Pausa (espacio)","Speed\
 of the film":"Velocidad de la película","To the start (Home)":"Al principio (Inicio)","Previous event (Shift ←)":"Suceso anterior (Mayús ←)","Next event \
(Shift →)":"Suceso siguiente (Mayús →)","One frame back (←)":"Un fotograma atrás (←)","One frame on (→)":"Un fotograma adelante (→)",landing:"ater\
rizaje","To the next flight (h)":"Al siguiente vuelo (h)","To the next landing (l)":"Al siguiente aterrizaje (l)","This motion has no flight.":"Este movimiento \
no tiene vuelo.","This motion has no landing.":"Este movimiento no tiene aterrizaje.","{what} at {angle}, {time} s":"{what} a {angle}, {time} s",start:"inicio",
"slip begins":"empieza el deslizamiento","slip ends":"acaba el deslizamiento","slip turns round":"se invierte el deslizamiento","take-off":"despegue","turns bac\
k":"da la vuelta","highest point":"punto más alto","bounces end":"acaban los rebotes","Painlevé: several solutions":"Painlevé: varias soluciones","energy gai\
n (Kane)":"ganancia de energía (Kane)","skimming begins":"empieza el roce","at rest":"en reposo",end:"final","What happens":"Qué ocurre","What happens to hoop\
 {hoop}":"Qué le ocurre al aro {hoop}","The motion in words":"El movimiento en palabras","(not all events are shown)":"(no se muestran todos los sucesos)","Wha\
t theory says":"Qué dice la teoría","What theory says of hoop {hoop}":"Qué dice la teoría del aro {hoop}",Velocities:"Velocidades","velocity [m/s]":"velocid\
ad [m/s]","v (centre)":"v (centro)","Energies and losses":"Energías y pérdidas","energy [J]":"energía [J]",kinetic:"cinética",potential:"potencial",total:"t\
otal","lost to friction":"perdida por rozamiento","lost in the damper":"perdida en el amortiguador","lost in impacts, normal part":"perdida en impactos, parte n\
ormal","Contact forces":"Fuerzas de contacto","force [N]":"fuerza [N]","normal N":"normal N","friction F":"rozamiento F","Use of friction":"Uso del rozamiento",
"Your choice":"A tu elección","What your diagram shows":"Qué muestra tu diagrama","Horizontal axis of the diagrams":"Eje horizontal de los diagramas","over {q\
uantity}":"en función de: {quantity}","Whole motion":"Todo el movimiento","slide to go there, two fingers zoom":"desliza para ir ahí; dos dedos amplían","cli\
ck to go there, drag to zoom; once clicked, or with Ctrl, the wheel zooms; double-click for all":"clic para ir ahí, arrastrar para ampliar; tras un clic, o con \
Ctrl, la rueda amplía; doble clic para todo","{name} from {low} to {high}":"{name} de {low} a {high}","Diagram: {title} in {unit}.":"Diagrama: {title} en {unit\
}.","θ mod 360°":"θ mod 360°",Esc:"Esc","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"ángulo dentro de una vuelta","place of the centre":"posi\
ción del centro","gap under the rim":"separación bajo la llanta","height of the centre of gravity":"altura del centro de gravedad","speed of the centre":"velo\
cidad del centro","speed of rotation":"velocidad de rotación","speed away from the plane":"velocidad de alejamiento del plano","slip velocity":"velocidad de de\
slizamiento","angular velocity":"velocidad angular","normal force":"fuerza normal","friction force":"fuerza de rozamiento","use of friction":"uso del rozamiento",
"kinetic energy":"energía cinética","potential energy":"energía potencial","total energy":"energía total","Plane of θ and θ̇":"Plano de θ y θ̇","Plane\
 of angle and angular velocity with the regions of rolling, slip and flight":"Plano de ángulo y velocidad angular con las regiones de rodadura, deslizamiento y \
vuelo","angle θ within a turn [°]":"ángulo θ dentro de una vuelta [°]","Colours: the mode that follows contact without slip. Hatched: slip that meets Painl\
evé’s paradox.":"Colores: la fase que sigue al contacto sin deslizamiento. Rayado: deslizamiento que encuentra la paradoja de Painlevé.","Click to go there;\
 two fingers zoom.":"Toca para ir ahí; dos dedos amplían.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Clic para \
ir ahí; tras un clic, o con Ctrl, la rueda amplía; doble clic para todo.",Map:"Mapa",of:"de",Across:"Horizontal",Up:"Vertical","What the map shows":"Qué muest\
ra el mapa","Map of motions":"Mapa de movimientos","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Mapa de movimientos\
. Las flechas mueven la marca, Intro toma el movimiento, más y menos amplían.","Zoom into the map":"Ampliar el mapa","Zoom out of the map":"Reducir el mapa","\
Whole map":"Mapa entero","Click to take that motion into the player; two fingers zoom.":"Toca para llevar ese movimiento al reproductor; dos dedos amplían.","C\
lick to take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Un clic lleva ese movimiento al rep\
roductor; tras un clic, o con Ctrl, la rueda amplía; arrastrar desplaza; doble clic para todo.","computing {count} motions …":"calculando {count} movimientos\
…","{count} motions":"{count} movimientos","{count} motions, with rigid contact":"{count} movimientos, con contacto rígido","of rolling starts, though this m\
otion starts otherwise":"con salidas rodando, aunque este movimiento empieza de otro modo","of starts in any state, though this motion starts rolling":"desde cu\
alquier estado, aunque este movimiento empieza rodando","compiling the kernel of maps, this once: {done} of {all} functions":"compilando el núcleo de los mapas,\
 solo esta vez: {done} de {all} funciones",Keep:"Guardar","Copy the link":"Copiar el enlace","Scenario (TOML)":"Escenario (TOML)","States (CSV)":"Estados (CSV)",
"Motion (netCDF)":"Movimiento (netCDF)","Events (JSON)":"Sucesos (JSON)","Film (MP4)":"Película (MP4)","Picture (PNG)":"Imagen (PNG)","Record a film here (WebM\
)":"Grabar aquí una película (WebM)","Show me the Python":"Ver el código Python","The same motion in Python":"El mismo movimiento en Python","The link is cop\
ied.":"El enlace está copiado.","The link to this motion":"El enlace a este movimiento","The film is being made; this takes a while …":"Se está haciendo la p\
elícula; tarda un poco…","Fetching {name} …":"Obteniendo {name}…","{name} is there.":"{name} ya está.","This browser cannot record a canvas; take the MP\
4 instead.":"Este navegador no puede grabar el lienzo; use el MP4.","Recording one run …":"Grabando una pasada…","The film is there.":"La película ya está.",
"The scenario as a file":"El escenario como archivo",Copy:"Copiar",Copied:"Copiado",Close:"Cerrar","A ring with a load on its rim rolls on a plane. Friction can\
 only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"\
Un anillo con una carga en la llanta rueda sobre un plano. El rozamiento aguanta hasta un límite y el plano solo puede empujar: por eso desliza, salta, aterriza\
… o hace algo que la mecánica del sólido rígido no puede decidir. Mueve un control y observa.",Modes:"Fases","Marks on the bar of time":"Marcas en la barra\
 de tiempo",Keys:"Teclas",space:"espacio","play, pause":"reproducir, pausa","one frame":"un fotograma","Shift ← →":"Mayús ← →","previous, next event":"\
suceso anterior, siguiente","next flight, landing":"siguiente vuelo, aterrizaje","slower, faster":"más lento, más rápido","Home End":"Inicio Fin","start, end":"\
principio, final","traces, forces, rim speed, whole path":"trayectorias, fuerzas, velocidad de la llanta, recorrido","in space":"en el espacio","zoom, zoom back":"\
ampliar, volver","leave a field, a menu, a picture that the wheel zooms":"salir de un campo, un menú o una imagen que amplía la rueda","z y  Ctrl Z":"z y  Ctr\
l Z","undo, redo":"deshacer, rehacer","dark, light":"oscuro, claro",Python:"Python","the rim does not slide":"la llanta no desliza","slip: the rim turns too fas\
t for the way it goes (slip −, for a hoop that rolls ahead)":"deslizamiento: la llanta gira demasiado deprisa para lo que avanza (deslizamiento −, si el aro r\
ueda hacia delante)","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)":"deslizamiento: la llanta desliza hacia delante (deslizamiento +, si el \
aro rueda hacia delante)","the hop: from take-off to landing":"el salto: del despegue al aterrizaje","a massless rim that touches without force":"una llanta sin\
 masa que toca sin fuerza","take-off, landing":"despegue, aterrizaje","Painlevé’s paradox: no solution, several":"Paradoja de Painlevé: ninguna solución, var\
ias","bounces without number end":"acaban infinitos rebotes","skimming begins, rest":"empieza el roce, reposo","Single keys (letters, digits, signs) do what the\
 table says":"Las teclas sueltas (letras, cifras, signos) hacen lo que dice la tabla","The hoop in your hand":"El aro en tu mano","Slope of the plane":"Inclinac\
ión del plano","Tilt the plane: drag, or arrow keys":"Inclinar el plano: arrastrar o flechas","The hoop: height and speed":"El aro: altura y velocidad","Lift, \
roll or throw the hoop: drag, or arrow keys":"Levantar, rodar o lanzar el aro: arrastrar o flechas","Angle of the load":"Ángulo de la carga","Turn the load: dr\
ag, or arrow keys":"Girar la carga: arrastrar o flechas","gap {height}, speed {speed} m/s":"separación {height}, velocidad {speed} m/s",Repeat:"Repetir","Slow \
motion: a tenth of the speed":"Cámara lenta: una décima parte","Sound of the contact":"Sonido del contacto","Presentation on the whole screen":"Presentación a\
 pantalla completa","Guided visit":"Visita guiada","Table of the motion":"Tabla del movimiento","Table of the motion, rows":"Tabla del movimiento, filas",Presentation:"\
Presentación","For teachers":"Para docentes",Table:"Tabla",Every:"Cada","Save as CSV":"Guardar como CSV",Columns:"Columnas","The first {count} rows.":"Las prim\
eras {count} filas.",Challenges:"Retos","Leave the challenges":"Salir de los retos","Which challenge":"Qué reto",Score:"Puntuación","Begin again":"Empezar de \
nuevo","Show a best one":"Ver una de las mejores","{stars} {points} points. {what}":"{stars} {points} puntos. {what}","Your best: {points} points.":"Tu mejor: {\
points} puntos.","Hop highest":"El salto más alto","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. How hig\
h can the hoop rise within 6 s?":"En suelo horizontal, rodando, con 3,1 m/s como mucho: eliges la carga, dónde empieza y el rozamiento. ¿Hasta qué altura puede \
subir el aro en 6 s?","Land upright":"Aterrizar en pie","Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at leas\
t 5 cm high.":"Haz que el aro aterrice con la carga arriba del todo. Todo vale; el primer salto debe tener al menos 5 cm de altura.","Hop without skidding":"Sal\
tar sin derrapar","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ is at most 1.5. Before it hops it must not\
 skid; to spin is allowed. How high does it hop?":"En suelo horizontal el aro empieza rodando con la carga abajo, a 10 m/s como mucho, y μ no pasa de 1,5. Antes\
 de saltar no debe derrapar; patinar sí puede. ¿Hasta qué altura salta?","Rigid contact only.":"Solo contacto rígido.","The plane must be level.":"El plano \
debe ser horizontal.","It must be on Earth.":"Debe ser en la Tierra.","Restitution must be 0.":"La restitución debe ser 0.","The radius must stay 1 m, without \
parts.":"El radio debe seguir siendo 1 m, sin piezas.","At most 90 % of the mass may be in the load.":"Como mucho el 90 % de la masa puede estar en la carga.","\
The hoop must be given by its load fraction.":"El aro debe darse por la fracción de carga.","It must start rolling.":"Debe empezar rodando.","At most 10 m/s.":"\
Como mucho 10 m/s.","At most 3.1 m/s.":"Como mucho 3,1 m/s.","At most 6 s.":"Como mucho 6 s.","It does not hop.":"No salta.","It rises by {height}.":"Sube {heig\
ht}.","The first hop is too low.":"El primer salto es demasiado bajo.","It lands {off} away from the top.":"Aterriza a {off} de lo más alto.","The load must st\
art at the bottom.":"La carga debe empezar abajo.","Friction must be at most 1.5.":"El rozamiento debe ser como mucho 1,5.","It skids before it hops.":"Derrapa \
antes de saltar.","New here?":"¿Primera vez?","Eight short questions: guess, then play.":"Ocho preguntas cortas: adivina y luego reproduce.","Start the visit":"\
Empezar la visita","Not now":"Ahora no","The hoop, before it is let go.":"El aro, antes de soltarlo.",Play:"Reproducir",Next:"Siguiente",Back:"Atrás",Done:"Hec\
ho","Step {number} of {all}":"Paso {number} de {all}","Leave the visit":"Salir de la visita","First say what you expect, then play.":"Di primero qué esperas y l\
uego reproduce.","Your guess":"Tu respuesta","{points} of 100 points.":"{points} de 100 puntos.","You have {sum} of {most} points.":"Tienes {sum} de {most} punt\
os.","{what} with the load at {angle}":"{what} con la carga a {angle}","Draw the curve: pull the points up and down":"Dibuja la curva: mueve los puntos arriba y\
 abajo","Littlewood’s question":"La pregunta de Littlewood","A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push\
 and rolls. J. E. Littlewood asked in 1953 what happens when the weight is level with the centre.":"Un aro sin masa lleva un peso en la llanta. Con el peso arri\
ba recibe el menor empujón y rueda. J. E. Littlewood preguntó en 1953 qué ocurre cuando el peso está a la altura del centro.","What do you think?":"¿Qué cre\
es?","It rolls on.":"Sigue rodando.","It hops: the hoop leaves the plane.":"Salta: el aro deja el plano.","The weight falls freely, and the hoop skims the plane\
 below it.":"El peso cae libremente y el aro roza el plano debajo de él.","At {angle} there is no contact force any more.":"A {angle} ya no hay fuerza de conta\
cto.","Littlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plan\
e. To hop, a hoop needs some mass in its rim.":"Littlewood dijo que el aro salta. Pero la fuerza de contacto es nula, no hacia arriba: el peso cae libremente y \
una llanta sin masa lo sigue por el plano. Para saltar, un aro necesita algo de masa en la llanta.","A ring with mass":"Un anillo con masa","Now a quarter of th\
e mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.":"Ahora un cuarto de la masa está en el anillo. De nuevo la carga está\
 arriba y el aro recibe el menor empujón.","Draw how fast the hoop’s centre goes during the first turn.":"Dibuja la velocidad del centro del aro durante la p\
rimera vuelta.","Speed of the centre":"Velocidad del centro","With the load at the bottom the centre has {speed} m/s.":"Con la carga abajo el centro va a {speed\
} m/s.","The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: it is fas\
ter than a stone that falls from the same height.":"El punto más bajo de un aro que rueda está en reposo. Ahí la carga no tiene energía cinética, y el anillo li\
gero tiene toda la que ha perdido la carga pesada: va más rápido que una piedra que cae desde la misma altura.","Why it slips":"Por qué desliza","A harder pu\
sh: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.":"Un empujón más fuerte: 2,8 m/s arriba. Rodar exige rozamiento, y\
 el rozamiento tiene un límite: como mucho μ N.","Where is the load when friction gives way for the first time? Turn the mark.":"¿Dónde está la carga cuando e\
l rozamiento cede por primera vez? Gira la marca.","Angle of the load where it begins to slip":"Ángulo de la carga donde empieza a deslizar","It begins to slip\
 at {angle}. There the plane carries only {share} of the weight.":"Empieza a deslizar a {angle}. Ahí el plano soporta solo el {share} del peso.","The load on i\
ts way down and round presses little on the plane, so that N is small, while the ring has to be made faster: that takes friction. Watch the diagram ‘Use of fric\
tion’: it comes to 1.":"En su camino hacia abajo la carga apenas aprieta el plano, así que N es pequeña, mientras que el anillo debe acelerarse: eso exige roz\
amiento. Mira el diagrama «Uso del rozamiento»: llega a 1.","The hop":"El salto","A little faster, 3.1 m/s. This time the hoop leaves the plane, before the fi\
rst turn is over.":"Un poco más rápido, 3,1 m/s. Esta vez el aro deja el plano antes de acabar la primera vuelta.","Where is the load when the hoop takes off?\
 Turn the mark.":"¿Dónde está la carga cuando el aro despega? Gira la marca.","Angle of the load where it takes off":"Ángulo de la carga al despegar","It ta\
kes off at {angle}, while its rim slips at {slip} m/s.":"Despega a {angle}, mientras su llanta desliza a {slip} m/s.","A rolling hoop would be braked by the pla\
ne while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the\
 top.":"A un aro que rueda el plano lo frenaría mientras sube la carga. El rozamiento es demasiado débil para eso: la llanta patina, el aro sigue girando depris\
a y la carga lo arranca del plano antes de llegar arriba.","The landing":"El aterrizaje","The hoop is in the air. Its centre of gravity goes on a parabola, and \
it turns evenly.":"El aro está en el aire. Su centro de gravedad sigue una parábola y gira de manera uniforme.","What does it do just after it has landed?":"¿\
Qué hace justo después de aterrizar?","It rolls at once.":"Rueda de inmediato.","It skids: the rim slides ahead.":"Derrapa: la llanta desliza hacia delante.",
"It spins: the rim turns too fast.":"Patina: la llanta gira demasiado deprisa.","It bounces.":"Rebota.","It was in the air for {time} s and rose by {height} cm;\
 it lands with the load at {angle}.":"Estuvo {time} s en el aire y subió {height} cm; aterriza con la carga a {angle}.","An impact takes no time, but its frict\
ion is as strong as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards.":"\
Un impacto no dura nada, pero su rozamiento es tan fuerte como su empuje: aquí basta para detener todo deslizamiento. Con menos rozamiento, o más restitución, e\
l aterrizaje sería otro. Pruébalo después.","More friction, more hop?":"¿Más rozamiento, más salto?","Three hoops get the same push of 3.1 m/s, on planes \
with friction 0.05, 0.2 and 1.0.":"Tres aros reciben el mismo empujón de 3,1 m/s, en planos con rozamiento 0,05, 0,2 y 1,0.","Which of them hops highest?":"¿Cu\
ál salta más alto?","They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)":"Suben {low} cm, {middle} cm y {high} cm. (Los dos primer\
os son A y B.)","On ice nothing drives the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way d\
own, and not so much that it is braked on the way up.":"Sobre hielo nada impulsa el giro; con rozamiento sin fin nada desliza. El salto necesita ambas cosas: ro\
zamiento bastante para girar deprisa en la bajada, y no tanto que lo frene en la subida.","What rigid bodies cannot decide":"Lo que los sólidos rígidos no puede\
n decidir","A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have to say what happens next.":"Se lanza un \
aro de modo que deslice deprisa sobre un plano rugoso. Las leyes del sólido rígido con rozamiento seco deben decir qué ocurre después.","What do they say?":"\
¿Qué dicen?","It flies off.":"Sale volando.","An impact stops the slide at once.":"Un impacto detiene el deslizamiento de golpe.","Both agree with the laws.":"\
Ambas cosas cumplen las leyes.","Hoop A and hoop B start alike, and both motions obey every law.":"El aro A y el aro B empiezan igual, y ambos movimientos cumpl\
en todas las leyes.","Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies yield a little, and that d\
ecides: choose the compliant contact under ‘Contact’.":"Painlevé lo descubrió en 1895. Para un sólido rígido las leyes tienen aquí dos respuestas, y en otro\
s estados ninguna. Los cuerpos reales ceden un poco, y eso decide: elige el contacto flexible en «Contacto».","Your turn":"Te toca a ti","Take the hoop: turn \
the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are computed from the motion itself.":"Toma el\
 aro: gira la carga, levántalo y suéltalo, dale un impulso, inclina el plano. O acepta un reto y mira cómo tu puntuación se calcula del propio movimiento.",
"Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”":"Mostrar el aro a toda velocidad, una vez, sin comentar. «Lo empujo.\
 ¿Solo rueda?»","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.":"Todos predicen dónde está la carga al despegar. \
Contar los votos por cuartos de vuelta.","Energy on the way down, in pairs: who has the energy when the load is at rest?":"Energía en la bajada, por parejas: ¿q\
uién tiene la energía cuando la carga está en reposo?","Lift at the top: at which speed is the force of the floor zero?":"Elevación arriba: ¿a qué velocidad \
es nula la fuerza del suelo?","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.":"La película otra vez, a cámara lenta \
y con fuerzas; parar al despegar. Comparar con los votos.","Each group takes one speed of the worksheet; results on the board.":"Cada grupo toma una velocidad d\
e la hoja de trabajo; resultados en la pizarra.","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?":"¿Por qu\
é? ¿Qué debe frenar el giro en la subida, qué fuerza puede tener y qué pasa si es demasiado débil?","One sentence each: “The hoop hops because …”":"\
Una frase cada uno: «El aro salta porque…»","The load pulls the hoop up at the top, so it hops there.":"La carga tira del aro hacia arriba en lo alto, por e\
so salta ahí.","Only if it is very fast. Slower hoops hop before the top, after slipping.":"Solo si es muy rápido. Los más lentos saltan antes de lo alto, tras\
 deslizar.","It hops at the bottom, where it is fastest.":"Salta abajo, donde es más rápido.","There the floor pushes hardest: the load has to be turned upwar\
ds.":"Ahí el suelo empuja más: hay que desviar la carga hacia arriba.","Nothing can be faster than a falling stone.":"Nada puede ser más rápido que una piedra\
 que cae.","The ring can: it gets the energy of a load that has come to rest.":"El anillo sí: recibe la energía de una carga que ha quedado en reposo.","Frict\
ion always brakes.":"El rozamiento siempre frena.","It acts against slip. On the hoop’s way up it points forwards.":"Actúa contra el deslizamiento. En la subi\
da apunta hacia delante.","More friction, more hop.":"Más rozamiento, más salto.","There is a best friction in between.":"Hay un rozamiento óptimo intermedio.",
"A heavier hoop behaves otherwise.":"Un aro más pesado se comporta de otro modo.","Only the shares of mass count.":"Solo cuentan las proporciones de masa.","Be\
fore the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.":"Antes de la película: ¿dónde está la carga cuando el aro \
deja el suelo? Marca el lugar y da una razón.","The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at\
 the bottom?":"El aro recibe solo el menor empujón y rueda. ¿Cuánta energía potencial se ha liberado cuando la carga está abajo?","While a wheel rolls, its\
 lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?":"Mientras una rueda rueda, su punto más bajo está en repo\
so. ¿Qué parte del aro tiene entonces energía cinética y a qué velocidad va el centro?","How fast is a stone that falls from the height of the load? Why ca\
n the hoop be faster?":"¿Qué velocidad tiene una piedra que cae desde la altura de la carga? ¿Por qué puede ser más rápido el aro?","Find the force of the\
 floor at the top for 1.0 m/s, and the speed at which it becomes zero.":"Halla la fuerza del suelo arriba para 1,0 m/s y la velocidad a la que se anula.","In th\
e lab: what does the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.":"En el laboratorio: ¿qué hace el aro en sus primeros 1,5 s \
y a qué ángulo salta? Completa la tabla.","Find the smallest speed with which the hoop hops, to 1 cm/s.":"Halla la menor velocidad con la que el aro salta, co\
n 1 cm/s de precisión.","At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping help it to hop?":"A 2,2 m/s el aro deja el suelo mientras \
su llanta desliza. ¿Por qué le ayuda a saltar el deslizamiento?",Show:"Mostrar","Teaching with the hoop":"Enseñar con el aro",Worksheet:"Hoja de trabajo",Solutions:"\
Soluciones",Exercises:"Ejercicios","A lesson of 45 minutes":"Una clase de 45 minutos",Minute:"Minuto",Motion:"Movimiento","What students often think":"Lo que su\
elen pensar los estudiantes",Idea:"Idea","What is right":"Lo correcto","Worksheet: the hoop that hops":"Hoja de trabajo: el aro que salta","A thin ring of radiu\
s 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at the top and is pushed to the right. Fri\
ction: μ = 1; g = 9.81 m/s².":"Un anillo delgado de radio 0,40 m tiene una masa de 0,25 kg. En su llanta va fijada una carga de 0,75 kg. El aro está sobre un \
suelo horizontal con la carga arriba y se empuja hacia la derecha. Rozamiento: μ = 1; g = 9,81 m/s².",phases:"fases","does it hop?":"¿salta?","at which angle\
?":"¿a qué ángulo?",Print:"Imprimir","The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student.":"La visit\
a pregunta antes de mostrar; la presentación llena la pantalla; la tabla da números a cada estudiante.",inf:"inf","greater than {least}":"mayor que {least}","\
at least {least}":"como mínimo {least}","at least {least} (inf is allowed)":"como mínimo {least} (se admite inf)","at most {most}":"como mucho {most}","a fini\
te number":"un número finito","a whole number":"un número entero","'{word}' or '{word2}'":"«{word}» o «{word2}»","'{word}', '{word2}' or '{word3}'":"«{wor\
d}», «{word2}» o «{word3}»","Rolling resistance":"Resistencia a la rodadura","Rolling resistance: couple against the rotation over R N":"Resistencia a la r\
odadura: par contra el giro, dividido por R N","Slips, hops":"Desliza, salta","no threshold uphill (β < 0): whether it slips or hops hangs on where it turns bac\
k; the map shows it":"cuesta arriba (β < 0) no hay umbral: que deslice o salte depende de dónde da la vuelta; el mapa lo muestra","'rigid' for a map":"«rigid»\
 para un mapa","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells por y.cells = {cells} debe ser como mucho {most} en el laboratorio.",
"{one} and {other} cannot both be axes: they say the same thing in two ways.":"{one} y {other} no pueden ser ambos ejes: dicen lo mismo de dos maneras.","x.path\
 and y.path are both {path} and must differ.":"x.path e y.path son ambos {path} y deben ser distintos.","lost to rolling resistance":"perdida por resistencia a \
la rodadura","Rolling resistance f":"Resistencia a la rodadura f","{name} = {value} must lie between -pi/2 and pi/2 (radians).":"{name} = {value} debe estar ent\
re -pi/2 y pi/2 (radianes).","{word} is not a known key; known are {word2}.":"{word} no es una clave conocida; las conocidas son {word2}.","{one} cannot be give\
n together with {other}.":"{one} no puede darse junto con {other}.","{one} = {value} must not exceed {other} = {limit}.":"{one} = {value} no debe superar {other\
} = {limit}.","plane.mu_static = inf must be finite with contact.model = 'compliant'.":"plane.mu_static = inf debe ser finito con contact.model = 'compliant'.",
"hoop.parts must not be empty.":"hoop.parts no debe estar vacío.","This takes longer than {time} s; ask for a shorter motion or fewer cells.":"Esto tarda más d\
e {time} s; pide un movimiento más corto o menos celdas.","The lab is busy; try again in {time} seconds.":"El laboratorio está ocupado; inténtalo de nuevo en {\
time} segundos.","The lab is busy; try again in 1 second.":"El laboratorio está ocupado; inténtalo de nuevo en 1 segundo.","The computation failed.":"El cálcu\
lo ha fallado.","The process that computed this has ended.":"El proceso que calculaba esto ha terminado.","duration = {value} must be at most {most} s in the la\
b; the library itself has no such limit.":"duration = {value} debe ser como mucho {most} s en el laboratorio; la biblioteca misma no tiene ese límite.","durati\
on = {value} s at this speed and radius is about {turns} revolutions and must be at most {most} in the lab; the library itself has no such limit.":"duration = {\
value} s son unas {turns} vueltas a esta velocidad y radio, y en el laboratorio como mucho {most}; la biblioteca misma no tiene ese límite.","hoop.parts has {c\
ount} parts and must have at most {most} in the lab.":"hoop.parts tiene {count} piezas y debe tener como mucho {most} en el laboratorio.","contact.stiffness, co\
ntact.slip_speed and duration need about {steps} steps of integration and must need at most {most} in the lab.":"contact.stiffness, contact.slip_speed y duratio\
n requieren unos {steps} pasos de integración, y en el laboratorio como mucho {most}.","A cell of this map is about {turns} revolutions and must be at most {mo\
st} in the lab.":"Una celda de este mapa son unas {turns} vueltas, y en el laboratorio como mucho {most}.","x and y make {count} cells of about {turns} revoluti\
ons in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter duration.":"x e y dan {count} celdas con unas {turns} vueltas en \
total, y en el laboratorio como mucho {most}; toma menos celdas, velocidades menores o una duración más corta.","duration = {value} must be at most {most} s f\
or a film from the lab.":"duration = {value} debe ser como mucho {most} s para una película del laboratorio.","A blue, B ochre; the dashes tell the quantities;\
 numbers of {hoop}; {hands}":"A azul, B ocre; el trazo indica la magnitud; números de {hoop}; {hands}","What comes after {time} s hangs on more digits than the\
 numbers of this page have; hophoop lab and Python take as many as it needs.":"Lo que viene después de {time} s depende de más cifras de las que tienen los núme\
ros de esta página; hophoop lab y Python toman las que hagan falta.","hophoop lab: play with the hopping hoop":"hophoop lab: juega con el aro saltarín","Put a\
 hopping hoop into a page of yours":"Pon un aro saltarín en una página tuya","One tag and one script show a live hoop in a blog, a course page or slides. The \
motion is computed in the reader’s browser; nothing is sent anywhere.":"Una etiqueta y un script muestran un aro vivo en un blog, una página de curso o unas d\
iapositivas. El movimiento se calcula en el navegador de quien lee; no se envía nada a ninguna parte.","Choose a motion in the lab, and copy its link here.":"E\
lige un movimiento en el laboratorio y copia aquí su enlace.","Scenario: a link of the lab, or what stands behind its question mark":"Escenario: un enlace del \
laboratorio, o lo que va tras su signo de interrogación","What stands beside the player":"Lo que acompaña al reproductor",sliders:"controles",diagrams:"diagra\
mas",theory:"teoría",map:"mapa","As a tag":"Como etiqueta","The tag":"La etiqueta","Copy the tag":"Copiar la etiqueta","As a frame, where scripts are not allow\
ed":"Como marco, donde no se permiten scripts","The frame":"El marco","Copy the frame":"Copiar el marco","As a QR code":"Como código QR","How it looks":"Cómo s\
e ve","Copied.":"Copiado.","A hopping hoop":"Un aro saltarín","Picture (SVG)":"Imagen (SVG)","A picture in space has no lines to keep: take the PNG, or leave 3\
D.":"Una imagen en el espacio no tiene líneas que guardar: toma el PNG o sal del 3D.","The picture is too large for this browser.":"La imagen es demasiado gran\
de para este navegador."};var Gn={roll:"roulement",spin:"patinage",skid:"dérapage",flight:"vol",skim:"effleurement","slip −":"glissement −","slip +":"glissement +",rolls:"roule",spins:"\
patine",skids:"dérape",flies:"vole","skims the plane":"effleure le plan","rolls at {angle}":"roule à partir de {angle}","spins at {angle}":"patine à partir de\
 {angle}","skids at {angle}":"dérape à partir de {angle}","flies at {angle}":"vole à partir de {angle}","skims the plane at {angle}":"effleure le plan à part\
ir de {angle}","hops at {angle}":"saute à {angle}","lands at {angle}":"retombe à {angle}","bounces at {angle}":"rebondit à {angle}","slips the other way at {\
angle}":"glisse dans l’autre sens à partir de {angle}","stops its slip at once at {angle}":"cesse brusquement de glisser à {angle}","turns back at {angle}":"\
fait demi-tour à {angle}","has bounced out at {angle}":"finit de rebondir à {angle}","meets Painlevé's paradox at {angle}":"rencontre le paradoxe de Painlevé\
 à {angle}","meets Painlevé's indeterminacy at {angle}":"rencontre l’indétermination de Painlevé à {angle}","jams at {angle}":"se coince à {angle}","gai\
ns energy (Kane) at {angle}":"gagne de l’énergie (Kane) à {angle}","skims at {angle}":"effleure à partir de {angle}","rests at {angle}":"repose à {angle}",
"starts at {angle}":"part à {angle}","slips at {angle}":"glisse à partir de {angle}","{what} and {count} more times":"{what} et encore {count} fois","… ({coun\
t} more)":"… (encore {count})","It has come to rest.":"Il s’est immobilisé.","The normal force grows without bound (dynamic jam): rigid-body mechanics has \
no motion beyond.":"La force normale croît sans limite (coincement dynamique) : la mécanique du solide ne donne pas de suite au mouvement.","The model does no\
t determine the motion beyond.":"Le modèle ne détermine pas la suite du mouvement.","The limit of events (contact.max_events), or of work for one motion, was \
reached before the end.":"La limite du nombre d’événements (contact.max_events), ou du calcul pour un mouvement, a été atteinte avant la fin.","It starts \
and {verb} with the load at {angle} and the centre at {speed} m/s.":"Il part et {verb}, la masselotte à {angle} et le centre à {speed} m/s.","It starts in the\
 air with the load at {angle} and the centre at {speed} m/s.":"Il part en l’air, la masselotte à {angle} et le centre à {speed} m/s.","It starts skimming wi\
th the load at {angle} and the centre at {speed} m/s.":"Il part en effleurant le plan, la masselotte à {angle} et le centre à {speed} m/s.","It {verb} at {ang\
le}; friction is used up: the rim turns too fast for the way it goes.":"À {angle} il {verb} : le frottement est épuisé, la jante tourne trop vite pour son traje\
t.","It {verb} at {angle}; friction is used up: the rim slides ahead.":"À {angle} il {verb} : le frottement est épuisé, la jante glisse vers l’avant.","It \
rolls again at {angle}; the slip has stopped.":"À {angle} il roule de nouveau ; le glissement a cessé.","The slip turns round at {angle}; it {verb}.":"À {angl\
e} le glissement s’inverse ; il {verb}.","It hops at {angle}.":"Il saute à {angle}.","It hops at {angle}. It rises {height} and stays up for {time} s.":"Il s\
aute à {angle}. Il monte de {height} et reste {time} s en l’air.","An impact without collision at {angle} stops the slip; then it {verb}.":"Un impact sans co\
llision à {angle} arrête le glissement ; puis il {verb}.","It lands at {angle} with {speed} m/s downwards and bounces.":"Il retombe à {angle} avec {speed} m/s\
 vers le bas et rebondit.","It lands at {angle} with {speed} m/s downwards and {verb}.":"Il retombe à {angle} avec {speed} m/s vers le bas et {verb}.","It turn\
s back at {angle}.":"Il fait demi-tour à {angle}.","It turns back at {angle}, and {verb} now.":"Il fait demi-tour à {angle}, et maintenant il {verb}.","The ce\
ntre is highest at {angle}: the gap is {height}.":"Le centre est au plus haut à {angle} : l’écart est de {height}.","Bounces without number end here, at {an\
gle}.":"Ici, à {angle}, s’achève une infinité de rebonds.","Painlevé's paradox at {angle}: no contact force agrees with this slip.":"Paradoxe de Painlevé \
à {angle} : aucune force de contact n’est compatible avec ce glissement.","Painlevé's paradox at {angle}: several contact forces agree with it.":"Paradoxe d\
e Painlevé à {angle} : plusieurs forces de contact sont compatibles.","Dynamic jam at {angle}: the contact force grows without bound.":"Coincement dynamique à\
 {angle} : la force de contact croît sans limite.","Newton's law of impact has created {energy} J (Kane's example).":"La loi d’impact de Newton a créé {energy}\
 J (exemple de Kane).","No contact force is left at {angle}: the load falls freely and the rim skims the plane.":"À {angle} il n’y a plus de force de contact : \
la masselotte tombe en chute libre et la jante effleure le plan.","It rests at {angle}.":"Il repose à {angle}.","It rests at {angle}, which is not stable.":"Il\
 repose à {angle}, mais pas de façon stable.","It bounces {count} more times.":"Il rebondit encore {count} fois.","… and {count} more.":"… et encore {count}\
.",Slips:"Glisse",Hops:"Saute","Hops at once":"Saute aussitôt","Friction for pure rolling":"Frottement pour rouler sans glisser","Painlevé’s paradox":"Parad\
oxe de Painlevé","Dynamic jam":"Coincement dynamique","Rests stably":"Repos stable","End of rolling":"Fin du roulement","would slip above {speed} m/s":"glisser\
ait au-delà de {speed} m/s","would slip: any push is enough":"glisserait : la moindre poussée suffit","would hop in its first turn above {speed} m/s":"sautera\
it au premier tour au-delà de {speed} m/s","would hop in its first turn: any push is enough":"sauterait au premier tour : la moindre poussée suffit","would ho\
p at once above {speed} m/s":"sauterait aussitôt au-delà de {speed} m/s","would hop at once: at any speed":"sauterait aussitôt : à toute vitesse","never, at\
 any speed":"jamais, à aucune vitesse","no friction keeps it rolling":"aucun frottement ne le fait rouler sans glisser","μ = {mu} would keep it rolling (enough\
 here)":"μ = {mu} le ferait rouler sans glisser (ici, cela suffit)","μ = {mu} would keep it rolling (more than there is)":"μ = {mu} le ferait rouler sans glis\
ser (plus qu’ici)",never:"jamais","from μ = {mu} on, at {angle}: possible here":"à partir de μ = {mu}, à {angle} : possible ici","from μ = {mu} on, at {an\
gle}: not here":"à partir de μ = {mu}, à {angle} : pas ici","can end a slip at {angles}":"peut terminer un glissement à {angles}","with the load at {angle}":"\
avec la masselotte à {angle}","at {angle} friction is used up":"à {angle} le frottement est épuisé","at {angle} the contact force is gone":"à {angle} la for\
ce de contact a disparu","Load fraction":"Part de la masselotte","Share of the mass in the load of an ideal hoop":"Part de la masse qui est dans la masselotte d\
’un cerceau idéal",Eccentricity:"Excentricité","Distance of the centre of gravity from the centre, over the radius":"Distance du centre de gravité au centre\
, divisée par le rayon","Inertia ratio":"Moment d’inertie réduit","Moment of inertia about the centre of gravity over m R²":"Moment d’inertie par rapport a\
u centre de gravité, divisé par m R²",Radius:"Rayon","Rim radius":"Rayon de la jante",Mass:"Masse","Total mass":"Masse totale",Friction:"Coefficient de frott\
ement","Friction, static and kinetic":"Coefficient de frottement, statique et dynamique","Static friction":"Frottement statique","Kinetic friction":"Frottement \
dynamique",Slope:"Inclinaison","Slope of the plane, downhill along +x":"Inclinaison du plan, descente vers +x",Gravity:"Pesanteur",Restitution:"Restitution","Re\
stitution of an impact":"Coefficient de restitution d’un impact",Speed:"Vitesse","Velocity of the centre in a rolling start":"Vitesse du centre au départ en r\
oulant","Load angle":"Angle de la masselotte","Angle from the plane's normal to the centre of gravity":"Angle entre la normale au plan et le centre de gravité",
"Height of the gap":"Hauteur de l’écart","Gap between rim and plane":"Écart entre la jante et le plan","Speed along":"Vitesse le long du plan","Velocity of \
the centre along the plane":"Vitesse du centre le long du plan","Speed upwards":"Vitesse vers le haut","Velocity of the centre away from the plane":"Vitesse du \
centre en s’éloignant du plan","Angular velocity":"Vitesse angulaire",Stiffness:"Raideur","Stiffness of the contact":"Raideur du contact","Slip speed":"Vites\
se de glissement","Slip velocity over which friction builds up":"Vitesse de glissement sur laquelle le frottement s’établit","Restitution that the damping is\
 chosen for":"Restitution pour laquelle l’amortissement est choisi",Duration:"Durée","Duration of the motion":"Durée du mouvement","Law of impact":"Loi d’im\
pact","Law of restitution":"Loi de restitution","Stronge (energy)":"Stronge (énergie)","Poisson (impulse)":"Poisson (impulsion)","Newton (velocity)":"Newton (v\
itesse)","Painlevé: two solutions":"Painlevé : deux solutions","What follows an indeterminate contact":"Ce qui suit un contact indéterminé",impact:"impact",
"Contact model":"Modèle de contact",rigid:"rigide",compliant:"souple","Normal force":"Force normale","Friction law":"Loi de frottement","Regularised friction":"\
Frottement régularisé","smooth (tanh)":"lisse (tanh)",linear:"linéaire","bristle (can hold)":"soies (peut retenir)","Kelvin–Voigt":"Kelvin–Voigt","Hunt–C\
rossley":"Hunt–Crossley","Speed v₀":"Vitesse v₀","Angle of the load θ₀":"Angle de la masselotte θ₀","Speed along ẋ₀":"Vitesse le long du plan ẋ₀",
"Angular velocity θ̇₀":"Vitesse angulaire θ̇₀","Height of the gap y₀":"Hauteur de l’écart y₀","Load fraction γ":"Part de la masselotte γ","Ecce\
ntricity ε":"Excentricité ε","Inertia ratio κ":"Moment d’inertie réduit κ","Radius R":"Rayon R","Friction μ":"Frottement μ","Slope β":"Inclinaison β",
"Gravity g":"Pesanteur g","Restitution e":"Restitution e",Earth:"Terre",Moon:"Lune",Mars:"Mars",Jupiter:"Jupiter",Weightless:"Apesanteur","what happens in the f\
irst turn":"ce qui se passe au premier tour","height of the first hop":"hauteur du premier saut","angle of take-off":"angle de décollage","duration of the firs\
t hop":"durée du premier saut","greatest friction utilization":"plus grande utilisation du frottement","energy lost":"énergie perdue","angle at the end":"angl\
e à la fin","Painlevé’s paradox or jam met":"paradoxe de Painlevé ou coincement rencontré","how it ends":"comment cela finit",duration:"durée",revolutions:"\
tours",reversal:"demi-tour",takeoff:"décollage",rest:"repos",jam:"coincement",undetermined:"indéterminé","event limit":"limite d’événements",no:"non",yes:"\
oui",none:"aucun","not allowed":"non permis","and {count} more":"et {count} autres","The article":"L’article","Littlewood's hoop":"Le cerceau de Littlewood",Paradoxes:"\
Paradoxes",More:"Autres","It hops: 3.1 m/s":"Il saute : 3,1 m/s","Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.":"Glisse deux\
 fois, puis quitte le plan juste avant un tour complet et vole pendant 0,76 s.","It slips: 2.8 m/s":"Il glisse : 2,8 m/s","Friction is used up twice a turn; eac\
h slip is weaker than the one before, and none is the last.":"Le frottement est épuisé deux fois par tour ; chaque glissement est plus faible que le précédent, \
et aucun n’est le dernier.","It rolls: 2 m/s":"Il roule : 2 m/s","Pure rolling, faster and more even than after a slow start, and close to the limit of fricti\
on.":"Roulement sans glissement, plus rapide et plus régulier qu’après un départ lent, et près de la limite du frottement.","The smallest push: 0.1 m/s":"\
La plus petite poussée : 0,1 m/s","Nearly at rest with the load up, fast with the load down; 38 % of the friction is used.":"Presque immobile avec la masselott\
e en haut, rapide avec la masselotte en bas ; 38 % du frottement est utilisé.","Low friction: 0.1 m/s, μ = 0.3":"Peu de frottement : 0,1 m/s, μ = 0,3","Slipp\
ing costs the energy that a full turn needs: the hoop rocks to and fro.":"Le glissement coûte l’énergie qu’exige un tour complet : le cerceau se balance.",
"All mass in the load":"Toute la masse dans la masselotte","A massless ring: at 90° no contact force is left; the load falls, the rim skims the plane.":"Un ann\
eau sans masse : à 90° il n’y a plus de force de contact ; la masselotte tombe, la jante effleure le plan.","All mass in the load, pushed":"Toute la masse d\
ans la masselotte, poussé","With a push the contact force is gone earlier, at cos θ = v₀²/(gR).":"Avec une poussée la force de contact disparaît plus tôt, \
à cos θ = v₀²/(gR).","Nearly all mass in the load":"Presque toute la masse dans la masselotte","γ = 0.99: what a real ring does instead of Littlewood's hop\
.":"γ = 0,99 : ce que fait un anneau réel au lieu du saut de Littlewood.","Painlevé: no solution":"Painlevé : aucune solution","No contact force agrees with\
 this slip. An impact without collision stops it at once.":"Aucune force de contact n’est compatible avec ce glissement. Un impact sans collision l’arrête aussi\
tôt.","Flight and impact both agree with the laws. Choose which with the switch under Plane.":"Vol et impact obéissent tous deux aux lois. Choisissez sous « Pl\
an ».","A fast slide after a hop: the contact force grows without bound in finite time, and no law says what follows.":"Un glissement rapide après un saut : la\
 force de contact croît sans limite en un temps fini, et aucune loi ne dit la suite.","Kane: energy out of nothing":"Kane : de l’énergie à partir de rien",
"Newton's law of impact with friction creates two joules. Stronge's law does not.":"La loi d’impact de Newton avec frottement crée deux joules. Celle de Stronge\
, non.",Downhill:"En descente","On a slope of 10° the hoop gains speed from turn to turn, until it hops.":"Sur une pente de 10° le cerceau prend de la vitesse \
tour après tour, jusqu’à ce qu’il saute.","Bounces without number":"Rebonds sans nombre","Dropped with spin and restitution 0.5: infinitely many bounces i\
n finite time.":"Lâché en rotation, restitution 0,5 : une infinité de rebonds en un temps fini.","On the Moon":"Sur la Lune","The article's hop under lunar g\
ravity: everything is slower by a factor of 2.46.":"Le saut de l’article sous la pesanteur lunaire : tout est 2,46 fois plus lent.","Motions to start from":"M\
ouvements de départ","Motions to start from …":"Mouvements de départ…","Undo (z)":"Annuler (z)","Redo (y)":"Rétablir (y)",Compare:"Comparer","Compare two\
 hoops":"Comparer deux cerceaux","Dark or light (d)":"Sombre ou clair (d)","Keys and help (?)":"Touches et aide (?)","Keys and help":"Touches et aide",lab:"labo",
Learn:"Apprendre",Language:"Langue","Hoop A":"Cerceau A","Hoop B":"Cerceau B","Which hoop the controls change":"Quel cerceau les réglages modifient",Parameters:"\
Paramètres","Skip to the player":"Aller au lecteur",Hoop:"Cerceau",Plane:"Plan",Start:"Départ",Contact:"Contact","Given by":"Donné par","load fraction γ":"p\
art de la masselotte γ","ε and κ":"ε et κ","real parts":"pièces réelles",Where:"Où",elsewhere:"ailleurs","static and kinetic friction apart":"frottement\
s statique et dynamique séparés",Starts:"Part",rolling:"en roulant","in any state":"dans un état quelconque","auto {value}":"auto {value}","{name}, exact val\
ue in {unit}":"{name}, valeur exacte en {unit}","{name}, exact value":"{name}, valeur exacte",Ring:"Anneau",Disk:"Disque","Point mass":"Masse ponctuelle",Rod:"T\
ige",mass:"masse","inner radius":"rayon intérieur","outer radius":"rayon extérieur",radius:"rayon","distance from centre":"distance au centre",length:"longueu\
r","Add a part":"Ajouter une pièce","+ add a part …":"+ ajouter une pièce…","Remove part {number}, {what}":"Retirer la pièce {number}, {what}","{name} = \
{value} must be {rule}.":"{name} = {value} doit être {rule}.","{name} = {value} must be a number, such as 2.5.":"{name} = {value} doit être un nombre, par exem\
ple 2,5.","{name} = {value} must be a number.":"{name} = {value} doit être un nombre.","from {least} to {most}":"de {least} à {most}","from {least} to {most},\
 or inf":"de {least} à {most}, ou inf","0 or from {least} to {most}":"0 ou de {least} à {most}","0 or from {least} to {most}, or inf":"0, de {least} à {most},\
 ou inf","at most {most} in the lab":"au plus {most} dans le labo","0 for the massless hoop (hoop.inertia_ratio = 0)":"0 pour le cerceau sans masse (hoop.inerti\
a_ratio = 0)","'rigid' for the massless hoop (hoop.inertia_ratio = 0)":"« rigid » pour le cerceau sans masse (hoop.inertia_ratio = 0)","The server does not an\
swer. What is here goes on playing; changes need `hophoop lab` to run again.":"Le serveur ne répond pas. Ce qui est là continue ; pour le modifier, relancez `ho\
phoop lab`.","The server answered {status}.":"Le serveur a répondu {status}.","The notebook’s kernel does not answer; run the cell again.":"Le noyau du noteb\
ook ne répond pas ; relancez la cellule.",hoop:"cerceau",mode:"phase",time:"temps",angle:"angle",gap:"écart","rim speed":"vitesse de jante",load:"masselotte",
"centre of gravity":"centre de gravité","the same in flight":"le même en vol","A in front, B behind":"A devant, B derrière","The hoop":"Le cerceau","The hoop\
.":"Le cerceau.",Time:"Temps","{time} seconds, {what}":"{time} secondes, {what}","Traces (t)":"Trajectoires (t)","Forces (f)":"Forces (f)","Rim speed (c)":"Vite\
sse de la jante (c)","Whole path (w)":"Tout le trajet (w)","In space (3)":"En 3D (3)",Traces:"Trajectoires",Forces:"Forces","Rim speed":"Vit. jante","Whole path":"\
Trajet entier","Play (space)":"Lecture (espace)","Pause (space)":"Pause (espace)","Speed of the film":"Vitesse du film","To the start (Home)":"Au début (Début)",
"Previous event (Shift ←)":"Événement précédent (Maj ←)","Next event (Shift →)":"Événement suivant (Maj →)","One frame back (←)":"Une image en a\
rrière (←)","One frame on (→)":"Une image en avant (→)",landing:"retombée","To the next flight (h)":"Au vol suivant (h)","To the next landing (l)":"À la\
 retombée suivante (l)","This motion has no flight.":"Ce mouvement n’a pas de vol.","This motion has no landing.":"Ce mouvement n’a pas de retombée.","{wh\
at} at {angle}, {time} s":"{what} à {angle}, {time} s",start:"départ","slip begins":"le glissement commence","slip ends":"le glissement cesse","slip turns rou\
nd":"le glissement s’inverse","take-off":"décollage","turns back":"fait demi-tour","highest point":"point le plus haut","bounces end":"les rebonds cessent","\
Painlevé: several solutions":"Painlevé : plusieurs solutions","energy gain (Kane)":"gain d’énergie (Kane)","skimming begins":"l’effleurement commence","a\
t rest":"au repos",end:"fin","What happens":"Ce qui se passe","What happens to hoop {hoop}":"Ce qui arrive au cerceau {hoop}","The motion in words":"Le mouvemen\
t en mots","(not all events are shown)":"(tous les événements ne sont pas montrés)","What theory says":"Ce que dit la théorie","What theory says of hoop {ho\
op}":"Ce que dit la théorie du cerceau {hoop}",Velocities:"Vitesses","velocity [m/s]":"vitesse [m/s]","v (centre)":"v (centre)","Energies and losses":"Énergies\
 et pertes","energy [J]":"énergie [J]",kinetic:"cinétique",potential:"potentielle",total:"totale","lost to friction":"perdue par frottement","lost in the damp\
er":"perdue dans l’amortisseur","lost in impacts, normal part":"perdue dans les impacts, part normale","Contact forces":"Forces de contact","force [N]":"force\
 [N]","normal N":"normale N","friction F":"frottement F","Use of friction":"Utilisation du frottement","Your choice":"À votre choix","What your diagram shows":"\
Ce que montre votre diagramme","Horizontal axis of the diagrams":"Axe horizontal des diagrammes","over {quantity}":"en fonction de : {quantity}","Whole motion":"\
Tout le mouvement","slide to go there, two fingers zoom":"glissez pour y aller ; deux doigts agrandissent","click to go there, drag to zoom; once clicked, or wi\
th Ctrl, the wheel zooms; double-click for all":"cliquez pour y aller, tirez pour agrandir ; après un clic, ou avec Ctrl, la molette agrandit ; double-clic pour\
 tout","{name} from {low} to {high}":"{name} de {low} à {high}","Diagram: {title} in {unit}.":"Diagramme : {title} en {unit}.","θ mod 360°":"θ mod 360°",Esc:"\
Échap","{name} [{unit}]":"{name} [{unit}]","angle within a turn":"angle dans un tour","place of the centre":"position du centre","gap under the rim":"écart sou\
s la jante","height of the centre of gravity":"hauteur du centre de gravité","speed of the centre":"vitesse du centre","speed of rotation":"vitesse de rotation",
"speed away from the plane":"vitesse d’éloignement du plan","slip velocity":"vitesse de glissement","angular velocity":"vitesse angulaire","normal force":"fo\
rce normale","friction force":"force de frottement","use of friction":"utilisation du frottement","kinetic energy":"énergie cinétique","potential energy":"éne\
rgie potentielle","total energy":"énergie totale","Plane of θ and θ̇":"Plan de θ et θ̇","Plane of angle and angular velocity with the regions of rolling,\
 slip and flight":"Plan de l’angle et de la vitesse angulaire avec les régions de roulement, de glissement et de vol","angle θ within a turn [°]":"angle θ \
dans un tour [°]","Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.":"Couleurs : la phase qui suit un conta\
ct sans glissement. Hachures : glissement qui rencontre le paradoxe de Painlevé.","Click to go there; two fingers zoom.":"Touchez pour y aller ; deux doigts ag\
randissent.","Click to go there; once clicked, or with Ctrl, the wheel zooms; double-click for all.":"Cliquez pour y aller ; après un clic, ou avec Ctrl, la mol\
ette agrandit ; double-clic pour tout.",Map:"Carte",of:"de",Across:"Horizontale",Up:"Verticale","What the map shows":"Ce que montre la carte","Map of motions":"\
Carte des mouvements","Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.":"Carte des mouvements. Les flèches déplacent la m\
arque, Entrée prend le mouvement, plus et moins agrandissent.","Zoom into the map":"Agrandir la carte","Zoom out of the map":"Réduire la carte","Whole map":"C\
arte entière","Click to take that motion into the player; two fingers zoom.":"Touchez pour mettre ce mouvement dans le lecteur ; deux doigts agrandissent.","Cl\
ick to take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.":"Un clic met ce mouvement dans le lec\
teur ; après un clic, ou avec Ctrl, la molette agrandit ; tirez pour déplacer ; double-clic pour tout.","computing {count} motions …":"calcul de {count} mou\
vements…","{count} motions":"{count} mouvements","{count} motions, with rigid contact":"{count} mouvements, avec contact rigide","of rolling starts, though th\
is motion starts otherwise":"partant en roulant, bien que ce mouvement parte autrement","of starts in any state, though this motion starts rolling":"partant d’u\
n état quelconque, bien que ce mouvement parte en roulant","compiling the kernel of maps, this once: {done} of {all} functions":"compilation du noyau des carte\
s, cette fois seulement : {done} fonctions sur {all}",Keep:"Garder","Copy the link":"Copier le lien","Scenario (TOML)":"Scénario (TOML)","States (CSV)":"États \
(CSV)","Motion (netCDF)":"Mouvement (netCDF)","Events (JSON)":"Événements (JSON)","Film (MP4)":"Film (MP4)","Picture (PNG)":"Image (PNG)","Record a film here \
(WebM)":"Enregistrer un film ici (WebM)","Show me the Python":"Montrer le Python","The same motion in Python":"Le même mouvement en Python","The link is copied\
.":"Le lien est copié.","The link to this motion":"Le lien vers ce mouvement","The film is being made; this takes a while …":"Le film se fait ; cela prend un\
 moment…","Fetching {name} …":"Récupération de {name}…","{name} is there.":"{name} est là.","This browser cannot record a canvas; take the MP4 instead.":"\
Ce navigateur ne peut pas enregistrer le canevas ; prenez le MP4.","Recording one run …":"Enregistrement d’un passage…","The film is there.":"Le film est \
là.","The scenario as a file":"Le scénario en fichier",Copy:"Copier",Copied:"Copié",Close:"Fermer","A ring with a load on its rim rolls on a plane. Friction \
can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.":"\
Un anneau lesté d’une masselotte roule sur un plan. Le frottement ne retient pas sans limite et le plan ne peut que pousser : alors il glisse, saute, retombe – \
ou fait ce que la mécanique du solide ne peut décider. Bougez un réglage et voyez.",Modes:"Phases","Marks on the bar of time":"Marques sur la barre de temps",
Keys:"Touches",space:"espace","play, pause":"lecture, pause","one frame":"une image","Shift ← →":"Maj ← →","previous, next event":"événement précédent, \
suivant","next flight, landing":"vol, retombée suivants","slower, faster":"plus lent, plus vite","Home End":"Début Fin","start, end":"début, fin","traces, fo\
rces, rim speed, whole path":"trajectoires, forces, vitesse de la jante, trajet","in space":"en 3D","zoom, zoom back":"agrandir, revenir","leave a field, a menu\
, a picture that the wheel zooms":"quitter un champ, un menu, une image que la molette agrandit","z y  Ctrl Z":"z y  Ctrl Z","undo, redo":"annuler, rétablir","\
dark, light":"sombre, clair",Python:"Python","the rim does not slide":"la jante ne glisse pas","slip: the rim turns too fast for the way it goes (slip −, for a \
hoop that rolls ahead)":"glissement : la jante tourne trop vite pour son trajet (glissement −, pour un cerceau qui avance)","slip: the rim slides ahead (slip \
+, for a hoop that rolls ahead)":"glissement : la jante glisse vers l’avant (glissement +, pour un cerceau qui avance)","the hop: from take-off to landing":"l\
e saut : du décollage à la retombée","a massless rim that touches without force":"une jante sans masse qui touche sans force","take-off, landing":"décollage,\
 retombée","Painlevé’s paradox: no solution, several":"Paradoxe de Painlevé : aucune solution, plusieurs","bounces without number end":"une infinité de reb\
onds s’achève","skimming begins, rest":"l’effleurement commence, repos","Single keys (letters, digits, signs) do what the table says":"Les touches seules (\
lettres, chiffres, signes) font ce que dit le tableau","The hoop in your hand":"Le cerceau dans votre main","Slope of the plane":"Inclinaison du plan","Tilt the\
 plane: drag, or arrow keys":"Incliner le plan : tirer, ou flèches","The hoop: height and speed":"Le cerceau : hauteur et vitesse","Lift, roll or throw the hoo\
p: drag, or arrow keys":"Lever, rouler ou lancer le cerceau : tirer, ou flèches","Angle of the load":"Angle de la masselotte","Turn the load: drag, or arrow ke\
ys":"Tourner la masselotte : tirer, ou flèches","gap {height}, speed {speed} m/s":"écart {height}, vitesse {speed} m/s",Repeat:"Répéter","Slow motion: a ten\
th of the speed":"Ralenti : un dixième de la vitesse","Sound of the contact":"Son du contact","Presentation on the whole screen":"Présentation en plein écran",
"Guided visit":"Visite guidée","Table of the motion":"Tableau du mouvement","Table of the motion, rows":"Tableau du mouvement, lignes",Presentation:"Présentati\
on","For teachers":"Pour les enseignants",Table:"Tableau",Every:"Toutes les","Save as CSV":"Enregistrer en CSV",Columns:"Colonnes","The first {count} rows.":"Le\
s {count} premières lignes.",Challenges:"Défis","Leave the challenges":"Quitter les défis","Which challenge":"Quel défi",Score:"Score","Begin again":"Recomm\
encer","Show a best one":"Montrer un des meilleurs","{stars} {points} points. {what}":"{stars} {points} points. {what}","Your best: {points} points.":"Votre mei\
lleur : {points} points.","Hop highest":"Sauter le plus haut","On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and frictio\
n. How high can the hoop rise within 6 s?":"Sur sol horizontal, en roulant, à 3,1 m/s au plus : vous choisissez la masselotte, sa position de départ et le frott\
ement. À quelle hauteur le cerceau peut-il monter en 6 s ?","Land upright":"Retomber debout","Let the hoop land with its load at the very top. Everything is al\
lowed; the first hop has to be at least 5 cm high.":"Faites retomber le cerceau avec la masselotte tout en haut. Tout est permis ; le premier saut doit faire au\
 moins 5 cm.","Hop without skidding":"Sauter sans déraper","On level ground the hoop starts rolling with its load at the bottom, at no more than 10 m/s, and μ \
is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?":"Sur sol horizontal le cerceau part en roulant, la masselotte en bas\
, à 10 m/s au plus, et μ vaut au plus 1,5. Avant de sauter il ne doit pas déraper ; patiner est permis. À quelle hauteur saute-t-il ?","Rigid contact only.":"\
Contact rigide seulement.","The plane must be level.":"Le plan doit être horizontal.","It must be on Earth.":"Ce doit être sur Terre.","Restitution must be 0.":"\
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
 la présentation remplit l’écran ; le tableau donne des nombres à chaque élève.",inf:"inf","greater than {least}":"supérieur à {least}","at least {leas\
t}":"au moins {least}","at least {least} (inf is allowed)":"au moins {least} (inf est permis)","at most {most}":"au plus {most}","a finite number":"un nombre fi\
ni","a whole number":"un nombre entier","'{word}' or '{word2}'":"« {word} » ou « {word2} »","'{word}', '{word2}' or '{word3}'":"« {word} », « {word2} » ou «\
 {word3} »","Rolling resistance":"Résistance au roulement","Rolling resistance: couple against the rotation over R N":"Résistance au roulement : couple opposé\
 à la rotation, divisé par R N","Slips, hops":"Glisse, saute","no threshold uphill (β < 0): whether it slips or hops hangs on where it turns back; the map sho\
ws it":"en montée (β < 0) pas de seuil : qu’il glisse ou saute dépend de l’endroit où il fait demi-tour ; la carte le montre","'rigid' for a map":"« rig\
id » pour une carte","x.cells times y.cells = {cells} must be at most {most} in the lab.":"x.cells fois y.cells = {cells} doit être au plus {most} dans le labo\
.","{one} and {other} cannot both be axes: they say the same thing in two ways.":"{one} et {other} ne peuvent être tous deux des axes : ils disent la même chose\
 de deux façons.","x.path and y.path are both {path} and must differ.":"x.path et y.path sont tous deux {path} et doivent différer.","lost to rolling resistan\
ce":"perdue par résistance au roulement","Rolling resistance f":"Résistance au roulement f","{name} = {value} must lie between -pi/2 and pi/2 (radians).":"{na\
me} = {value} doit être entre -pi/2 et pi/2 (radians).","{word} is not a known key; known are {word2}.":"{word} n’est pas une clé connue ; sont connues {word2}\
.","{one} cannot be given together with {other}.":"{one} ne peut pas être donné avec {other}.","{one} = {value} must not exceed {other} = {limit}.":"{one} = {\
value} ne doit pas dépasser {other} = {limit}.","plane.mu_static = inf must be finite with contact.model = 'compliant'.":"plane.mu_static = inf doit être fini \
avec contact.model = 'compliant'.","hoop.parts must not be empty.":"hoop.parts ne doit pas être vide.","This takes longer than {time} s; ask for a shorter moti\
on or fewer cells.":"Cela prend plus de {time} s ; demandez un mouvement plus court ou moins de cellules.","The lab is busy; try again in {time} seconds.":"Le l\
abo est occupé ; réessayez dans {time} secondes.","The lab is busy; try again in 1 second.":"Le labo est occupé ; réessayez dans 1 seconde.","The computatio\
n failed.":"Le calcul a échoué.","The process that computed this has ended.":"Le processus qui calculait cela s’est arrêté.","duration = {value} must be a\
t most {most} s in the lab; the library itself has no such limit.":"duration = {value} doit être au plus {most} s dans le labo ; la bibliothèque elle-même n’a p\
as cette limite.","duration = {value} s at this speed and radius is about {turns} revolutions and must be at most {most} in the lab; the library itself has no s\
uch limit.":"duration = {value} s font environ {turns} tours à cette vitesse et ce rayon, au plus {most} dans le labo ; la bibliothèque elle-même n’a pas cette \
limite.","hoop.parts has {count} parts and must have at most {most} in the lab.":"hoop.parts a {count} pièces et doit en avoir au plus {most} dans le labo.","c\
ontact.stiffness, contact.slip_speed and duration need about {steps} steps of integration and must need at most {most} in the lab.":"contact.stiffness, contact.\
slip_speed et duration demandent environ {steps} pas d’intégration, au plus {most} dans le labo.","A cell of this map is about {turns} revolutions and must b\
e at most {most} in the lab.":"Une cellule de cette carte fait environ {turns} tours, au plus {most} dans le labo.","x and y make {count} cells of about {turns}\
 revolutions in all, and must be at most {most} in the lab; take fewer cells, lower speeds or a shorter duration.":"x et y font {count} cellules d’environ {turn\
s} tours en tout, au plus {most} dans le labo ; prenez moins de cellules, des vitesses plus faibles ou une durée plus courte.","duration = {value} must be at m\
ost {most} s for a film from the lab.":"duration = {value} doit être au plus {most} s pour un film du labo.","A blue, B ochre; the dashes tell the quantities; \
numbers of {hoop}; {hands}":"A bleu, B ocre ; le tracé indique la grandeur ; nombres de {hoop} ; {hands}","What comes after {time} s hangs on more digits than \
the numbers of this page have; hophoop lab and Python take as many as it needs.":"Ce qui vient après {time} s dépend de plus de chiffres que n’en ont les nombre\
s de cette page ; hophoop lab et Python en prennent autant qu’il faut.","hophoop lab: play with the hopping hoop":"hophoop lab : jouer avec le cerceau sauteur",
"Put a hopping hoop into a page of yours":"Mettre un cerceau sauteur dans une page à vous","One tag and one script show a live hoop in a blog, a course page or\
 slides. The motion is computed in the reader’s browser; nothing is sent anywhere.":"Une balise et un script montrent un cerceau vivant dans un blog, une page\
 de cours ou des diapositives. Le mouvement est calculé dans le navigateur du lecteur ; rien n’est envoyé nulle part.","Choose a motion in the lab, and copy\
 its link here.":"Choisissez un mouvement dans le labo et copiez son lien ici.","Scenario: a link of the lab, or what stands behind its question mark":"Scénario\
 : un lien du labo, ou ce qui suit son point d’interrogation","What stands beside the player":"Ce qui accompagne le lecteur",sliders:"réglages",diagrams:"dia\
grammes",theory:"théorie",map:"carte","As a tag":"En balise","The tag":"La balise","Copy the tag":"Copier la balise","As a frame, where scripts are not allowed":"\
En cadre, là où les scripts ne sont pas permis","The frame":"Le cadre","Copy the frame":"Copier le cadre","As a QR code":"En code QR","How it looks":"Aperçu",
"Copied.":"Copié.","A hopping hoop":"Un cerceau sauteur","Picture (SVG)":"Image (SVG)","A picture in space has no lines to keep: take the PNG, or leave 3D.":"U\
ne image dans l’espace n’a pas de lignes à garder : prenez le PNG, ou quittez la 3D.","The picture is too large for this browser.":"L’image est trop grande\
 pour ce navigateur."};var Kn={roll:"滚动",spin:"空转",skid:"拖滑",flight:"腾空",skim:"擦地","slip −":"滑动 −","slip +":"滑动 +",rolls:"滚动",spins:"空转",skids:"\
拖滑",flies:"腾空","skims the plane":"贴着平面滑过","rolls at {angle}":"在 {angle} 处开始滚动","spins at {angle}":"在 {angle} 处开始空转",
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
ntities; numbers of {hoop}; {hands}":"A 为蓝色，B 为赭色；线型表示物理量；数值属于 {hoop}；{hands}","What comes after {time} s hangs on mor\
e digits than the numbers of this page have; hophoop lab and Python take as many as it needs.":"{time} s 之后会发生什么，取决于比本页数值更多的位数；hophoop lab 与 Python 会取所需的位数。",
"hophoop lab: play with the hopping hoop":"hophoop 实验室：玩转会跳的圆环","Put a hopping hoop into a page of yours":"把会跳的圆环放进您的网页",
"One tag and one script show a live hoop in a blog, a course page or slides. The motion is computed in the reader’s browser; nothing is sent anywhere.":"一个标签和\
一个脚本，就能在博客、课程页面或幻灯片中显示可操作的圆环。运动在读者的浏览器中计算；不向任何地方发送数据。",
"Choose a motion in the lab, and copy its link here.":"在实验室中选择一个运动，并把它的链接复制到这里。","Scenario: a link of the lab, o\
r what stands behind its question mark":"场景：实验室的链接，或其问号之后的部分","What stands beside the player":"播放器旁显示的内容",
sliders:"滑块",diagrams:"图表",theory:"理论",map:"分布图","As a tag":"作为标签","The tag":"标签","Copy the tag":"复制标签","As a frame, where\
 scripts are not allowed":"作为框架，用于不允许脚本的地方","The frame":"框架","Copy the frame":"复制框架","As a QR code":"作为二维码",
"How it looks":"显示效果","Copied.":"已复制。","A hopping hoop":"会跳的圆环","Picture (SVG)":"图片（SVG）","A picture in space has no lines to \
keep: take the PNG, or leave 3D.":"空间画面没有可保存的线条：请用 PNG，或退出 3D。","The picture is too large for this browser.":"图片对此浏览器来说太\
大了。"};var no=new Map;function de(s){try{return localStorage.getItem(s)??no.get(s)??null}catch{return no.get(s)??null}}function pe(s,e){no.set(s,e);try{localStorage.setItem(
s,e)}catch{}}var gt={en:"English",de:"Deutsch",es:"Español",fr:"Français",zh:"中文"},ao={de:Hn,es:Un,fr:Gn,zh:Kn},al=new Set(["de","es","fr"]),Yn="hophoop-language",Zn=4e3,
rl=/^((\d\S* )?(rad(\/s)?|kg|m\/s²?)|'?[\w.[\]]+\.\w+'?|'\w*'|([\w.]+, )+[\w.]+|hophoop.*)$/u,Gt=/\{(\w+)\}/g,ve="en",Qn=[],mt=new Map,ft=new Set,Je=new Set,Ye=()=>ve;
function ro(s){ve=s in gt?s:"en",mt=new Map,ft=new Set,Je.clear(),Qn=Object.keys(ao[ve]??{}).filter(e=>e.includes("{")).map(hl).sort((e,t)=>Vn(t.key)-Vn(e.key))}
function ll(){let s=de(Yn);return s&&s in gt?s:(globalThis.navigator?.languages??[]).map(o=>o.slice(0,2).toLowerCase()).find(o=>o in gt)??"en"}function Xn(s){pe(
Yn,s)}var Vn=s=>s.replace(Gt,"").length;function hl(s){let e=[...s.matchAll(Gt)].map(([,o])=>o),t=s.split(/\{\w+\}/).map(o=>o.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"));
return{key:s,names:e,pattern:new RegExp(`^${t.join("(.+?)")}$`,"su")}}var me=s=>al.has(ve)?s.replace(/(\d)\.(\d)/g,"$1,$2"):s;function x(s,e){let t=ao[ve];if(e)
return ae(ti(t?.[s]??Jn(s),e));if(!t||!/\p{L}/u.test(s))return me(s);if(ft.has(s))return s;let o=mt.get(s);if(o!==void 0)return o;let n=s.trim(),i=t[n]??cl(n,t)??
Jn(n),a=s.replace(n,()=>i);return mt.size>Zn&&mt.clear(),mt.set(s,a),ae(a)}function ae(s){return ft.size>Zn&&ft.clear(),ft.add(s),s}var ei=(s,e)=>s.replace(Gt,(t,o)=>String(
e[o])),ti=(s,e)=>s.replace(Gt,(t,o)=>o.startsWith("word")?String(e[o]):x(String(e[o])));function cl(s,e){for(let{key:t,pattern:o,names:n}of Qn){let i=s.match(o);
if(i)return ti(e[t],Object.fromEntries(n.map((a,r)=>[a,i[r+1]])))}return ul(s)}function ul(s){if(s.includes(" → "))return s.split(" → ").map(e=>x(e)).join("\
 → ")}function si(s){if(!ao[ve])return s;let[,e,t]=s.match(/^(.*?)\.(?: (.*))?$/su)??["",s,""],{comma:o,stop:n}=ve==="zh"?{comma:"，",stop:"。"}:{comma:", ",
stop:"."},a=`${e[0]?.toLowerCase()??""}${e.slice(1)}`.split(/, (?!\d)/).map(r=>x(r)).join(o);return ae(`${a[0]?.toLocaleUpperCase(ve)??""}${a.slice(1)}${n}${t?`\
 ${x(t)}`:""}`)}function Jn(s){let e=/\p{L}{3,}/u.test(s)&&!rl.test(s);return ve!=="en"&&e&&Je.size<200&&Je.add(s),me(s)}var lo=new WeakMap,io=new WeakMap;function ho(s){
let e=document.createTextNode(x(s));return lo.set(e,s),e}function Ze(s,e,t){let o=io.get(s)??{};o[e]=t,io.set(s,o),s.setAttribute(e,x(t))}function dl(s){let e=document.
createTreeWalker(s,NodeFilter.SHOW_TEXT);for(let t=e.nextNode();t;t=e.nextNode()){let o=(t.nodeValue??"").replace(/\s+/g," ");o.trim()&&lo.set(t,o)}for(let t of s.
querySelectorAll("[aria-label]"))Ze(t,"aria-label",t.getAttribute("aria-label")??"");Kt(s)}function Kt(s){let e=document.createTreeWalker(s,NodeFilter.SHOW_ELEMENT|
NodeFilter.SHOW_TEXT);for(let t=e.nextNode();t;t=e.nextNode()){let o=lo.get(t);o!==void 0&&(t.nodeValue=x(o));let n=io.get(t);for(let[i,a]of Object.entries(n??{}))
t.setAttribute(i,x(a))}}ro(ll());var pl=new Set(["aria-label","title","placeholder","label"]);function p(s,e={},...t){let o=document.createElement(s),n=o;for(let[i,a]of Object.entries(e))a==null||
a===!1||(i.startsWith("on")?o.addEventListener(i.slice(2),a):i==="class"?o.className=a:i in o&&i!=="list"&&typeof a!="string"?n[i]=a:pl.has(i)?Ze(o,i,String(a)):
o.setAttribute(i,a===!0?"":a));for(let i of t.flat())i==null||i===!1||o.append(i.nodeType?i:ho(String(i)));return o}function z(s,e){e?s.replaceChildren(ho(e)):s.
replaceChildren()}var Vt=s=>s!==null&&s.getRootNode().activeElement===s,fe=s=>s.getContext("2d");function U(s){let e=s.getBoundingClientRect(),t=Math.min(globalThis.
devicePixelRatio||1,2.5),o=Math.max(Math.round(e.width*t),1),n=Math.max(Math.round(e.height*t),1);(s.width!==o||s.height!==n)&&(s.width=o,s.height=n);let i=fe(s);
return i.setTransform(t,0,0,t,0,0),{context:i,width:o/t,height:n/t}}function ml(s){if(/^#[0-9a-f]{6}$/i.test(s))return s;let e=fe(p("canvas",{width:1,height:1}));
e.fillStyle=s,e.fillRect(0,0,1,1);let[t,o,n]=e.getImageData(0,0,1,1).data;return`#${[t,o,n].map(i=>i.toString(16).padStart(2,"0")).join("")}`}function co(s){let e=getComputedStyle(
s),t=n=>e.getPropertyValue(n).trim(),o=n=>ml(t(n));return{ink:o("--ink"),soft:o("--soft"),line:o("--line"),paper:o("--paper"),panel:o("--panel"),ground:o("--gro\
und"),font:t("--font"),dark:ut(o("--paper"))<.2}}function Qe(s,e){let t=p("a",{href:URL.createObjectURL(s),download:e});document.body.append(t),t.click(),t.remove(),
setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function ge(s,e){let t=0;return()=>{clearTimeout(t),t=setTimeout(s,e)}}var k=(s,e,t)=>Math.min(Math.max(s,e),t);function T(s,e=4){if(s==null)return"–";if(typeof s!="number")return String(s);if(!Number.isFinite(s))return Number.isNaN(
s)?"–":s>0?"∞":"−∞";if(s===0)return"0";let t=Math.abs(s),o;if(t>=1e6||t<1e-4){let[n,i]=s.toExponential(e-1).split("e");o=`${oi(n)}·10${fl(Number(i))}`}else
o=oi(s.toPrecision(e)),o.includes("e")&&(o=String(Math.round(s)));return me(o.replace("-","−"))}function oi(s){return s.includes(".")&&!s.includes("e")?s.replace(
/\.?0+$/,""):s}function fl(s){let e={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(s)].map(t=>e[t]).join(
"")}var G=(s,e)=>e?e==="°"?`${s}°`:`${s} ${e}`:s,$=s=>me(`${(s*180/Math.PI).toFixed(1)}°`.replace("-","−"));function Me(s){let e=Math.abs(s),[t,o]=e>=.995?
[1,"m"]:e>=.00995?[100,"cm"]:[1e3,"mm"];return G(T(s*t,3),o)}function K(s,e){let t=s/Math.max(e,1),o=10**Math.floor(Math.log10(t)),n=t/o;return(n>5?10:n>2?5:n>1?
2:1)*o}function re(s,e,t){if(!(e>s)||!Number.isFinite(s)||!Number.isFinite(e))return[];let o=K(e-s,t),n=[];for(let i=Math.ceil(s/o-1e-9);i*o<=e+1e-9*o&&n.length<
200;i++)n.push(i*o);return n}function oe(s,e){let t=k(-Math.floor(Math.log10(e)+1e-9),0,15);return Math.max(Math.abs(s),e)>=1e6||t>12?T(s,3):me((Math.abs(s)<e*1e-6?
0:s).toFixed(t).replace("-","−"))}var ii=[["traces","t"],["forces","f"],["speed","c"],["whole","w"],["three","3"]],gl="tfc",wl=400;function ai({time:s=0,options:e={},zoom:t=1,pan:o=[0,0],from:n,
map:i}){let a=[];s>0&&a.push(`t=${Number(s.toFixed(4))}`);let r=ii.filter(([l])=>e[l]).map(([,l])=>l);return r.join("")!==gl&&a.push(`show=${r.join("")}`),t!==1&&
a.push(`zoom=${Number(t.toPrecision(3))}`),o.some(l=>Math.abs(l)>5e-4)&&a.push(`pan=${o.map(l=>Number(l.toFixed(3))).join(",")}`),n&&a.push(`from=${n.map(l=>Number(
l.toPrecision(3))).join(",")}`),i&&a.push(`map=${[i.what,...i.x,...i.y].join(",")}`),a.join("&")}function ri(s){let e=new URLSearchParams(s.replace(/^#/,"")),t={},
o=Number(e.get("t")??Number.NaN);o>=0&&(t.time=o);let n=e.get("show");n!==null&&(t.options=Object.fromEntries(ii.map(([w,b])=>[w,n.includes(b)])));let i=Number(
e.get("zoom")??Number.NaN);i>0&&(t.zoom=k(i,.05,60));let a=ni(e.get("pan"),2);a&&(t.pan=a.map(w=>k(w,-20,20)));let r=ni(e.get("from"),3);r&&(t.from=r);let[l,c,u,
h,d,m,g]=e.get("map")?.split(",")??[],f=[u,h,m,g].map(Number);return g!==void 0&&f.every(Number.isFinite)&&f[0]<f[1]&&f[2]<f[3]&&(t.map={what:l,x:[c,f[0],f[1]],
y:[d,f[2],f[3]]}),t}function ni(s,e){let t=(s??"").split(",").map(Number);return s&&t.length===e&&t.every(Number.isFinite)?t:null}var bl=()=>{let s=new URLSearchParams(
location.hash.slice(1)).get("with");return[location.search.slice(1),...s===null?[]:[s]]},Jt=class{constructor(e){this.lab=e,this.number=0,this.soon=ge(()=>this.
write("same"),wl),this.listen=()=>this.arrived(),addEventListener("popstate",this.listen)}close(){removeEventListener("popstate",this.listen)}write(e){let{lab:t}=this;
if(!t.motions.lanes.length)return;let o=t.link();e==="step"?history.pushState({number:++this.number},"",o):history.replaceState({number:this.number},"",o)}travel(e){
return new Promise(t=>{let o=()=>t();addEventListener("popstate",o,{once:!0}),setTimeout(o,300),history.go(e)})}async arrived(){let e=history.state?.number??0,t=bl();
JSON.stringify(t)===JSON.stringify(this.lab.motions.queries())?this.number=e:await this.lab.motions.arrive(t)?this.number=e:e!==this.number&&history.go(this.number-
e)}};var wt=[.05,.1,.25,.5,1,2,4],Yt=class{constructor(){this.time=0,this.duration=1,this.speed=1,this.playing=!1,this.loop=!0,this.last=null,this.listeners=new Set}changed(){
for(let e of this.listeners)e(this)}seek(e){this.time=k(e,0,this.duration),this.changed()}play(e=!this.playing){this.playing=e,this.last=null,e&&this.time>=this.
duration&&(this.time=0),this.changed()}faster(e){let t=wt.indexOf(this.speed);this.speed=wt[k(t+e,0,wt.length-1)],this.changed()}tick(e){if(!this.playing)return!1;
let t=this.last===null?0:Math.min(e-this.last,100)/1e3;return this.last=e,this.time+=t*this.speed,this.time>=this.duration&&(this.loop&&this.duration>0?this.time%=
this.duration:(this.time=this.duration,this.playing=!1,this.changed())),!0}};function yl(s,e=""){let t=s.trim();e&&t.endsWith(e)&&(t=t.slice(0,-e.length)),t=t.replace(/[\s\u00a0\u202f]/g,"").replace(/[−–]/g,"-").replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/,
(n,i,a)=>`e${i&&"-"}${a.normalize("NFKD")}`);let o=/^([+-]?)(inf|infinity|∞)$/i.exec(t);return o?o[1]==="-"?-1/0:1/0:/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.
test(t)?Number(t.replace(",",".")):Number.NaN}function vl(s,e,{label:t,unit:o,range:n}){let i=s.trim();if(Number.isNaN(e))return`${t} = ${i} must be a number, s\
uch as 2.5.`;if(!n||e>=n.least&&e<=n.most||n.also.includes(e))return"";let a=n.also.includes(0)?"0 or ":"",r=`from ${T(n.least,4)} to ${G(T(n.most,4),o)}`,l=n.also.
includes(1/0)?", or inf":"";return`${t} = ${G(T(e,6),o)} must be ${a}${r}${l}.`}var kl=0,Xe=class{constructor(e,t){this.info=e,this.onvalue=t,this.shown="",this.
typing=!1,this.error=p("p",{class:"error",role:"alert",id:`hh-error-${++kl}`,hidden:!0}),this.input=p("input",{type:"text",inputmode:"decimal",autocomplete:"off",
spellcheck:"false",class:"exact","aria-label":e.name,oninput:()=>{this.typing=!0,this.accept()},onchange:()=>this.typed(),onblur:()=>this.typing&&this.typed(),onkeydown:o=>{
o.key!=="Escape"||!(this.typing||this.refused())||(o.stopPropagation(),this.restore())}})}refused(){return this.input.getAttribute("aria-invalid")==="true"}typed(){
let e=this.input.value;if(!this.typing)return;if(this.typing=!1,e.trim()===""){this.restore();return}let t=yl(e,this.info.unit),o=vl(e,t,this.info);o?this.refuse(
o):this.onvalue(t)}refuse(e){this.input.setAttribute("aria-invalid","true"),this.input.setAttribute("aria-describedby",this.error.id),z(this.error,e),this.error.
hidden=!1}accept(){this.input.removeAttribute("aria-invalid"),this.input.removeAttribute("aria-describedby"),this.error.hidden=!0}restore(){this.typing=!1,this.
input.value=this.shown,this.accept()}show(e){this.shown=me(e),this.typing||this.restore()}};var li={ring:{label:"Ring",keys:["mass","inner_radius","outer_radius"]},disk:{label:"Disk",keys:["mass","radius","at"]},point_mass:{label:"Point mass",keys:["ma\
ss","at"]},rod:{label:"Rod",keys:["mass","length","at"]}},_l={mass:["mass","kg"],inner_radius:["inner radius","m"],outer_radius:["outer radius","m"],radius:["ra\
dius","m"],at:["distance from centre","m"],length:["length","m"]},xl=(s,e,t)=>({ring:{shape:s,mass:t,inner_radius:.95*e,outer_radius:e},disk:{shape:s,mass:t,radius:.1*
e,at:.8*e},point_mass:{shape:s,mass:t,at:e},rod:{shape:s,mass:t,length:.5*e,at:.5*e}})[s];function hi(s){let e=s["hoop.radius"],t=s["hoop.mass"],o=Math.min(Math.
max(s["hoop.eccentricity"],.01),.99);return[{shape:"ring",mass:Zt(t*(1-o)),inner_radius:Zt(.98*e),outer_radius:e},{shape:"point_mass",mass:Zt(t*o),at:e}]}var Zt=s=>Number(
s.toPrecision(6)),Qt=class{parts;text;radius;mass;constructor(e){this.onchange=e,this.list=p("div",{class:"parts"}),this.element=p("div",{},this.list,p("select",
{"aria-label":"Add a part",onchange:t=>{let o=t.target.value;t.target.value="",o&&this.send([...this.parts,xl(o,this.radius,Zt(.2*this.mass))])}},p("option",{value:""},
"+ add a part …"),Object.entries(li).map(([t,{label:o}])=>p("option",{value:t},o))))}send(e){this.onchange([["hoop.parts",e]])}show(e,t,o){let n=JSON.stringify(
e);if(n===this.text||this.list.contains(this.list.getRootNode().activeElement)){this.parts=e;return}Object.assign(this,{text:n,parts:e,radius:t,mass:o}),this.list.
replaceChildren(...e.map((i,a)=>this.row(i,a)))}row(e,t){let{label:o,keys:n}=li[e.shape];return p("fieldset",{class:"part"},p("legend",{},o,this.parts.length>1&&
p("button",{type:"button",class:"quiet","aria-label":`Remove part ${t+1}, ${o}`,onclick:()=>this.send(this.parts.filter((i,a)=>a!==t))},"×")),n.map(i=>this.field(
e,t,i)))}field(e,t,o){let[n,i]=_l[o],a=new Xe({label:n,unit:i},r=>this.send(this.parts.map((l,c)=>c===t?{...l,[o]:r}:l)));return a.show(String(e[o]??0)),p("div",
{},p("label",{},`${n} [${i}]`,a.input),a.error)}};var uo=Math.PI/180;function Tl({allowed:s,degrees:e}){if(!s)return;let t=e?1/uo:1;return{least:s.least*t,most:s.most*t,also:s.also.map(o=>o==="inf"?1/0:Number(o))}}
var po=class{constructor(e,t){this.info=e,this.onchange=t,this.held=!1;let o=`hh-${e.path}-${Math.random().toString(36).slice(2,7)}`,n=l=>()=>{this.held=l};this.
range=p("input",{type:"range",id:o,class:"slider",min:String(this.low()),max:String(this.high()),step:e.logarithmic?"0.01":String(e.step),"data-path":e.path,oninput:()=>this.
slid(!1),onchange:()=>this.slid(!0),onpointerdown:n(!0),onpointerup:n(!1),onpointercancel:n(!1),onblur:n(!1)});let{label:i,unit:a}=e,r=`${i}, exact value${a?` i\
n ${a}`:""}`;this.entry=new Xe({label:i,unit:a,name:r,range:Tl(e)},l=>this.send(l,!0)),this.element=p("div",{class:"control",title:e.help},p("label",{for:o},p("\
span",{},i),p("span",{class:"symbol"},e.symbol)),this.range,p("span",{class:"entry"},this.entry.input,p("span",{class:"unit"},a)),this.entry.error)}low(){return this.
info.logarithmic?Math.log10(this.info.least):this.info.least}high(){return this.info.logarithmic?Math.log10(this.info.most):this.info.most}slid(e){let t=Number(
this.range.value),o=this.info.logarithmic?Number((10**t).toPrecision(3)):t;this.entry.typing=!1,this.entry.show(String(o)),this.say(o),this.send(o,e)}send(e,t){
let o=this.info.degrees?e*uo:e;this.onchange([[this.info.path,Number.isFinite(o)?o:"inf"]],t)}say(e){this.range.setAttribute("aria-valuetext",G(T(e,4),this.info.
unit))}show(e,t=null){if(this.held)return;let o=e!=null,n=o?e:t;if(n==null){this.entry.show("");return}let i=n==="inf"?1/0:Number(n)/(this.info.degrees?uo:1);this.
entry.show(o?Number.isFinite(i)?String(Number(i.toPrecision(9))):"∞":""),this.entry.input.placeholder=o?"":x("auto {value}",{value:T(i,2)}),this.entry.input.title=
o?G(String(i),this.info.unit):"";let a=k(this.info.logarithmic?Math.log10(i):i,this.low(),this.high());Math.abs(Number(this.range.value)-a)>1e-6&&(this.range.value=
String(a)),this.say(i)}};function Sl(s,e){let t=p("select",{"data-path":s.path,onchange:()=>e([[s.path,t.value]],!0)},s.options.map(([n,i])=>p("option",{value:n},
i)));return{element:p("label",{class:"choice",title:s.help},p("span",{},s.label),t),select:t,path:s.path}}var Xt=class{way;kind;gravity;apart;derived;film;constructor(e,t){
this.onchange=(o,n=!0)=>t(o,n),this.sliders=new Map;for(let o of Object.values(e.groups))for(let n of o)this.sliders.set(n.path,new po(n,this.onchange));this.choices=
new Map(e.choices.map(o=>[o.path,Sl(o,this.onchange)])),this.parts=new Qt(this.onchange),this.gravities=e.gravities,this.element=p("div",{class:"controls"},this.
hoop(),this.plane(),this.start(),this.contact())}at(e){let t=this.sliders.get(e)??this.choices.get(e);if(!t)throw new Error(`There is no control of ${e}.`);return t.
element}select(e,t,o){let n=p("select",{onchange:()=>o(n.value)},t.map(([i,a])=>p("option",{value:i},a)));return{select:n,element:p("label",{class:"choice"},p("\
span",{},e),n)}}group(e,...t){let o=e==="Start"||e==="Plane"||!matchMedia("(max-width: 760px)").matches;return p("details",{class:"group",open:o},p("summary",{},
e),t)}hoop(){return this.way=this.select("Given by",[["load_fraction","load fraction γ"],["eccentricity","ε and κ"],["parts","real parts"]],e=>{let{values:t}=this.
film;e==="parts"?this.onchange([["hoop.parts",hi(t)]]):this.onchange([[`hoop.${e}`,t["hoop.eccentricity"]]])}),this.derived=p("p",{class:"derived"}),this.group(
"Hoop",this.way.element,this.at("hoop.load_fraction"),this.at("hoop.eccentricity"),this.at("hoop.inertia_ratio"),this.parts.element,this.derived,this.at("hoop.r\
adius"),this.at("hoop.mass"))}plane(){return this.apart=p("input",{type:"checkbox",onchange:()=>{let{values:e}=this.film;this.apart.checked?this.onchange([["pla\
ne.mu_static",e["plane.mu_static"]],["plane.mu_kinetic",e["plane.mu_kinetic"]]]):this.onchange([["plane.mu",e["plane.mu_static"]]])}}),this.gravity=this.select(
"Where",[...this.gravities.map(([e])=>[e,e]),["","elsewhere"]],e=>{let t=this.gravities.find(([o])=>o===e);t&&this.onchange([["plane.gravity",t[1]]])}),this.group(
"Plane",this.at("plane.mu"),this.at("plane.mu_static"),this.at("plane.mu_kinetic"),p("label",{class:"check"},this.apart,"static and kinetic friction apart"),this.
at("plane.slope"),this.gravity.element,this.at("plane.gravity"),this.at("plane.restitution"),this.at("plane.rolling_resistance"),this.at("plane.impact_law"),this.
at("plane.painleve"))}start(){return this.kind=this.select("Starts",[["rolling","rolling"],["free","in any state"]],e=>{let{values:t}=this.film;e==="rolling"?this.
onchange([["start.speed",t["start.vx"]]]):this.onchange([["start.omega",t["start.omega"]]])}),this.group("Start",this.kind.element,this.at("start.speed"),this.at(
"start.angle"),this.at("start.height"),this.at("start.vx"),this.at("start.vy"),this.at("start.omega"),this.at("duration"))}contact(){return this.group("Contact",
this.at("contact.model"),this.at("contact.law"),this.at("contact.friction"),this.at("contact.stiffness"),this.at("contact.slip_speed"),this.at("contact.restitut\
ion"))}refuse(e,t){let o=e.length===1?this.sliders.get(e[0][0]):void 0;return o?.element.checkVisibility()?(o.entry.refuse(t),!0):!1}restore(){this.film&&this.showChoices(
this.film,new Set)}show(e,t=new Set){this.film=e,this.showChoices(e,t);let o=e.scenario;for(let[n,i]of this.sliders){if(t.has(n))continue;let[a,r]=n.split(".");
i.show(e.values[n]??(r?o[a]?.[r]:o[a]),e.automatic?.[n])}}showChoices(e,t){let{scenario:o,values:n}=e,i=o.hoop.parts?"parts":"load_fraction"in o.hoop?"load_frac\
tion":"eccentricity",a="speed"in o.start,r="mu_static"in o.plane,l=o.contact.model==="compliant",c=(...m)=>m.some(g=>t.has(g));c("hoop.load_fraction","hoop.ecce\
ntricity","hoop.parts")||(this.way.select.value=i),c("start.speed","start.omega")||(this.kind.select.value=a?"rolling":"free"),c("plane.mu","plane.mu_static")||
(this.apart.checked=r);let u=this.gravities.find(([,m])=>Math.abs(m-o.plane.gravity)<1e-9);c("plane.gravity")||(this.gravity.select.value=u?u[0]:"");let h={"hoo\
p.load_fraction":i==="load_fraction","hoop.eccentricity":i==="eccentricity","hoop.inertia_ratio":i==="eccentricity","hoop.mass":i!=="parts","plane.mu":!r,"plane\
.mu_static":r,"plane.mu_kinetic":r,"plane.restitution":!l,"plane.impact_law":!l,"plane.painleve":!l,"start.speed":a,"start.height":!a,"start.vx":!a,"start.vy":!a,
"start.omega":!a,"contact.law":l,"contact.friction":l,"contact.stiffness":l,"contact.slip_speed":l,"contact.restitution":l};for(let[m,g]of Object.entries(h))this.
at(m).hidden=!g;this.parts.element.hidden=i!=="parts",o.hoop.parts&&this.parts.show(o.hoop.parts,n["hoop.radius"],n["hoop.mass"]),this.derived.textContent=i==="\
eccentricity"?"":`ε = ${T(n["hoop.eccentricity"],5)}, κ = ${T(n["hoop.inertia_ratio"],5)}`+(i==="parts"?`, m = ${T(n["hoop.mass"],5)} kg`:"");let d=o;for(let[
m,{select:g}]of this.choices){if(t.has(m))continue;let[f,w]=m.split(".");d[f]?.[w]!==void 0&&(g.value=d[f][w])}}};var mo=Math.PI/180;function ci(s,e){let{start:t,plane:o,contact:n,hoop:i}=s.scenario;return n.model!=="rigid"?"Rigid contact only.":s.slope!==0?"The plane must \
be level.":Math.abs(s.gravity-9.81)>1e-9?"It must be on Earth.":(o.restitution??0)!==0?"Restitution must be 0.":s.radius!==1||i.parts?"The radius must stay 1 m,\
 without parts.":s.eccentricity>.9?"At most 90 % of the mass may be in the load.":"load_fraction"in i?"speed"in t?Math.abs(t.speed??3.1)>e+1e-9?e>5?"At most 10 \
m/s.":"At most 3.1 m/s.":s.scenario.duration>6?"At most 6 s.":"":"It must start rolling.":"The hoop must be given by its load fraction."}var ui=s=>s.events.filter(
({kind:e})=>e==="takeoff");function Ml(s){return s.events.filter(({kind:e})=>e==="apex").map(({height:e})=>e)}var di=(s,e)=>Math.min(Math.round(100*s/e),100),El=1.596,
Al=.37,Rl=.05,fo=[{key:"highest",title:"Hop highest",text:"On level ground, rolling, with at most 3.1 m/s: you choose the load, where it starts, and friction. H\
ow high can the hoop rise within 6 s?",start:"",best:"hoop.load_fraction=0.9&plane.mu=0.29",score:s=>{let e=ci(s,3.1);if(e)return{points:0,text:e};let t=Math.max(
0,...Ml(s));return t?{points:di(t,El),text:"It rises by {height}.",values:{height:Me(t)}}:{points:0,text:"It does not hop."}}},{key:"upright",title:"Land uprigh\
t",text:"Let the hoop land with its load at the very top. Everything is allowed; the first hop has to be at least 5 cm high.",start:"",best:"hoop.load_fraction=\
0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",score:s=>{let e=ui(s)[0],t=s.events.find(({kind:a,t:r})=>a==="impact"&&e&&r>e.t);if(!e||!t)return{
points:0,text:"It does not hop."};let o=s.events.find(({kind:a,t:r})=>a==="apex"&&r>e.t);if(!o||o.height<Rl)return{points:0,text:"The first hop is too low."};let n=Math.
abs(t.angle-2*Math.PI*Math.round(t.angle/(2*Math.PI)))/mo,i=Math.max(0,Math.round(100*(1-(n-.5)/89.5)));return{points:Math.min(i,100),text:"It lands {off} away \
from the top.",values:{off:$(n*mo)}}}},{key:"clean",title:"Hop without skidding",text:"On level ground the hoop starts rolling with its load at the bottom, at n\
o more than 10 m/s, and μ is at most 1.5. Before it hops it must not skid; to spin is allowed. How high does it hop?",start:"start.angle=3.141592653589793&star\
t.speed=8",best:"hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",score:s=>{let e=ci(s,10);if(e)return{points:0,text:e};if(Math.
abs(Math.abs(s.scenario.start.angle??0)-Math.PI)>.5*mo)return{points:0,text:"The load must start at the bottom."};if(s.values["plane.mu_kinetic"]>1.5||s.values["\
plane.mu_static"]>1.5)return{points:0,text:"Friction must be at most 1.5."};let t=ui(s)[0];if(!t)return{points:0,text:"It does not hop."};let o=s.phases.filter(
({from:i})=>i<t.t);if(o.some(({mode:i})=>i==="K"))return{points:0,text:"It skids before it hops."};if(o[0]?.mode!=="R")return{points:0,text:"It must start rolli\
ng."};let n=s.events.find(({kind:i,t:a})=>i==="apex"&&a>t.t);return n?{points:di(n.height,Al),text:"It rises by {height}.",values:{height:Me(n.height)}}:{points:0,
text:"It does not hop."}}}],go=s=>s>=95?3:s>=75?2:s>=40?1:0;var pi="hophoop-best-",Pl=s=>"★".repeat(go(s))+"☆".repeat(3-go(s)),es=class{goal=null;constructor(e){this.lab=e,this.tabs=new Map(fo.map(t=>[t.key,p("button",
{type:"button","aria-pressed":"false",onclick:()=>this.choose(t)},t.title)])),this.text=p("p",{}),this.meter=p("meter",{min:"0",max:"100",low:"40",high:"75",optimum:"\
100","aria-label":"Score"}),this.result=p("p",{class:"challenge-result",role:"status"}),this.kept=p("p",{class:"hint"}),this.element=p("section",{class:"challen\
ges card","aria-label":"Challenges",hidden:!0},p("header",{},p("h2",{},"Challenges"),p("button",{type:"button",class:"quiet","aria-label":"Leave the challenges",
onclick:()=>this.close()},"×")),p("div",{class:"tabs",role:"group","aria-label":"Which challenge"},[...this.tabs.values()]),this.text,this.meter,this.result,this.
kept,p("div",{class:"buttons"},p("button",{type:"button",onclick:()=>this.goal&&this.load(this.goal.start)},"Begin again"),p("button",{type:"button",onclick:()=>this.
goal&&this.load(this.goal.best)},"Show a best one")))}open(){this.element.hidden=!1,this.choose(this.goal??fo[0]),this.element.scrollIntoView({block:"nearest"}),
this.tabs.get(this.goal.key)?.focus({preventScroll:!0})}close(){this.goal=null,this.element.hidden=!0}choose(e){this.goal=e;for(let[t,o]of this.tabs)o.setAttribute(
"aria-pressed",String(t===e.key));z(this.text,e.text),this.changed()}async load(e){let{lab:t}=this;try{let o=await t.backend.call("film",{query:e});t.clock.play(
!1),t.clock.time=0,t.motions.replace(o)}catch(o){t.notice.fail(o)}}changed(){let{goal:e,lab:t}=this;if(!e)return;let{points:o,text:n,values:i={}}=e.score(t.film());
this.meter.value=o;let a=x("{stars} {points} points. {what}",{stars:Pl(o),points:o,what:x(n,i)});this.result.textContent!==a&&(this.result.textContent=a);let r=Number(
de(pi+e.key)??0);o>r&&!t.stage.options.ahead&&pe(pi+e.key,String(o)),z(this.kept,x("Your best: {points} points.",{points:Math.max(r,t.stage.options.ahead?0:o)}))}};var mi=.09,zl=.03,wo=Math.PI/180,ts=Math.PI/4,fi=2*Math.PI,bt=s=>s-fi*Math.round(s/fi);function ss(s,e){let t=s.at(e),o=e===0;return{angle:bt(t.angle),height:Math.
max(t.height,0),vx:o?t.vx:0,vy:o?t.vy:0,omega:o?t.omega:0,slope:s.slope}}var gi=s=>2*Math.sqrt(Math.max(s.gravity,1)*s.radius),Ee=s=>Number(s.toFixed(4))+0;function wi(s,e,t){
if(s==="plane")return[["plane.slope",Ee(e.slope)]];if(e.height>0)return[["start.angle",Ee(e.angle)],["start.height",Ee(e.height)],["start.vx",Ee(e.vx)],["start.\
vy",Ee(e.vy)],["start.omega",Ee(e.omega)]];let o=s==="load"?e.omega*t.radius:e.vx;return[["start.angle",Ee(e.angle)],["start.speed",Ee(o)]]}var yt=class{constructor(e,t,o,n,i){
this.grip=e,this.film=t,this.view=n,this.before=ss(t,o),this.held={...this.before,vx:0,vy:0,omega:0};let a=t.at(o);this.center=[a.x,t.radius+a.height],this.foot=
n.point(a.x,0),this.from=this.read(i),this.turned=0,this.trail=[],this.moved=0}read(e){let[t,o]=this.view.unpoint(e.clientX,e.clientY),n=this.grip==="plane"?Math.
atan2(e.clientY-this.foot[1],e.clientX-this.foot[0]):Math.atan2(t-this.center[0],o-this.center[1]);return{x:e.clientX,y:e.clientY,along:t,away:o,turn:n}}move(e,t){
let o=this.read(e),{radius:n}=this.film;if(this.turned+=bt(o.turn-this.from.turn-this.turned),this.grip==="plane"){let i=k(this.before.slope+this.turned,-ts,ts);
this.held.slope=Math.abs(i)<wo?0:i}else if(this.grip==="load")this.held.angle=bt(this.before.angle+this.turned);else{let i=this.before.height+o.away-this.from.away;
this.held.height=i<zl*n?0:i;let a=o.along-this.from.along;this.held.angle=bt(this.before.angle+(this.held.height>0?0:a/n)),this.moved=o.x-this.from.x}for(this.trail.
push({t:t/1e3,along:o.along,away:o.away,turned:this.turned});this.trail.length>2&&this.trail[0].t<t/1e3-mi;)this.trail.shift();return this.held}release(e){let{held:t,
trail:o,film:n}=this,i=o.at(-1),a=o[0],r=i&&a?i.t-a.t:0,l=!i||r<.012||e/1e3-i.t>mi,c=gi(n);return l||this.grip==="plane"||(this.grip==="load"?t.omega=k((i.turned-
a.turned)/r,-c/n.radius,c/n.radius):(t.vx=k((i.along-a.along)/r,-c,c),t.vy=t.height>0?k((i.away-a.away)/r,-c,c):0)),t}};function bi(s,e,t,o,n){let i={ArrowLeft:-1,
ArrowRight:1}[e]??0,a={ArrowDown:-1,ArrowUp:1}[e]??0;if(!i&&!a)return null;let r=t?.2:1;if(s==="load"){let h=bt(o.angle+(i||a)*5*wo*r);return{...o,angle:h}}if(s===
"plane"){let h=k(o.slope+(i||-a)*wo*r,-ts,ts);return{...o,slope:Math.abs(h)<1e-9?0:h}}let l=gi(n),c=k(o.height+a*.05*r*n.radius,0,4*n.radius),u=k(o.vx+i*.1*r,-l,
l);return{...o,height:c<1e-9?0:c,vx:u}}function V(s,e,t,o=()=>{}){let n=new AbortController,{signal:i}=n,a=(l,c)=>s.addEventListener(l,u=>u.pointerId===e.pointerId&&c(u),{signal:i}),r=l=>c=>{n.abort(),
o(c,l)};s.setPointerCapture(e.pointerId),a("pointermove",t),a("pointerup",r(!0)),a("pointercancel",r(!1))}function yi(s,e){let t=new Map,o=null,n=()=>{let[a,r]=[
...t.values()];return{span:Math.max(Math.hypot(a.clientX-r.clientX,a.clientY-r.clientY),1),clientX:.5*(a.clientX+r.clientX),clientY:.5*(a.clientY+r.clientY)}};s.
addEventListener("pointerdown",a=>{a.pointerType!=="mouse"&&(t.set(a.pointerId,a),o=t.size===2?n():null)}),s.addEventListener("pointermove",a=>{if(!t.has(a.pointerId)||
(t.set(a.pointerId,a),t.size!==2||!o))return;let r=n();e(r.span/o.span,r),o=r});for(let a of["pointerup","pointercancel"])s.addEventListener(a,r=>{t.delete(r.pointerId),
o=null});let i=a=>a.touches.length>1&&a.cancelable&&a.preventDefault();return s.addEventListener("touchmove",i,{passive:!1}),()=>t.size>1}var Il=700,bo=44,Ll=[["plane","Slope of the plane","Tilt the plane: drag, or arrow keys"],["hoop","The hoop: height and speed","Lift, roll or throw the hoop: dr\
ag, or arrow keys"],["load","Angle of the load","Turn the load: drag, or arrow keys"]],os=class{static Pull=yt;pull=null;held=null;before=null;constructor(e){this.
lab=e,this.places=new Map(Ll.map(([i,a,r])=>[i,this.place(i,a,r)])),this.tip=p("output",{class:"grip-tip","aria-hidden":"true",hidden:!0}),this.element=p("div",
{class:"grips",role:"group","aria-label":"The hoop in your hand"},[...this.places.values()],this.tip),e.stage.element.before(this.element);let{flat:t,plane:o}=e.
stage;t.grab=i=>this.take(i),o.addEventListener("pointermove",i=>this.hover(i)),o.addEventListener("pointerleave",()=>this.hover(null));let n=i=>this.pull&&i.cancelable&&
i.preventDefault();o.addEventListener("touchmove",n,{passive:!1}),this.settle=ge(()=>this.chosen(!1),Il)}place(e,t,o){return p("div",{class:`grip grip-${e}`,role:"\
slider",tabindex:"0","aria-label":t,"aria-valuenow":"0",title:o,onkeydown:n=>this.key(e,n),onblur:()=>this.held&&this.chosen(!1)})}view(){return this.lab.stage.
flat.views[this.lab.motions.active]}draw(){let{lab:e}=this,t=this.view(),o=!!t&&!e.stage.options.three;if(this.element.hidden=!o,!o)return;this.element.classList.
toggle("running",e.clock.playing);let{pose:n,film:i,scale:a}=t,r=i.radius,l=t.point(n.x,r+n.height),c=t.point(n.x+r*Math.sin(n.angle),r+n.height+r*Math.cos(n.angle)),
u=this.onPlane(t),h=k(1.1*r*a,bo,190),d=[["plane",u,bo],["hoop",l,h],["load",c,bo]];for(let[m,[g,f],w]of d){let b=this.places.get(m);b.style.transform=`translat\
e(${g-w/2}px, ${t.top+f-w/2}px)`,b.style.width=b.style.height=`${w}px`,b.hidden=g<0||f<0||g>t.width||f>t.height}e.clock.playing||this.tell(i)}onPlane(e){let t=e.
point(e.pose.x,0),n=(Math.min(t[0]+Math.max(1.9*e.film.radius*e.scale,90),e.width-30)-t[0])/(e.scale*Math.max(e.cosine,.2));return e.point(e.pose.x+n,0)}tell(e){
let t=this.pull?.held??this.held??ss(e,this.lab.clock.time),o={load:$(t.angle),hoop:x("gap {height}, speed {speed} m/s",{height:Me(t.height),speed:T(t.vx,3)}),plane:$(
t.slope)},n={load:t.angle*(180/Math.PI),hoop:t.height,plane:t.slope*(180/Math.PI)},i={load:[-180,180],hoop:[0,4*e.radius],plane:[-45,45]};for(let[a,r]of this.places)
r.getAttribute("aria-valuetext")!==o[a]&&(r.setAttribute("aria-valuetext",o[a]),r.setAttribute("aria-valuenow",String(Number(n[a].toPrecision(4)))),r.setAttribute(
"aria-valuemin",String(i[a][0])),r.setAttribute("aria-valuemax",String(Number(i[a][1].toPrecision(4)))))}under(e){if(this.element.hidden)return null;let t=null;
for(let[o,n]of this.places){let{left:i,top:a,width:r}=n.getBoundingClientRect(),l=Math.hypot(e.clientX-i-r/2,e.clientY-a-r/2);!n.hidden&&l<=r/2&&(t=o)}return t}hover(e){
if(this.pull)return;let t=e&&e.pointerType!=="touch"?this.under(e):null;for(let[o,n]of this.places)n.classList.toggle("near",o===t);this.lab.stage.plane.style.cursor=
t?"grab":""}take(e){let t=this.under(e);if(!t||e.button>0||this.pull)return!1;let{lab:o}=this,{flat:n,plane:i}=o.stage,a=this.places.get(t),r=this.view(),l=i.getBoundingClientRect(),
c=b=>({clientX:b.clientX-l.left,clientY:b.clientY-l.top-r.top}),u=new yt(t,o.film(),o.clock.time,r,c(e)),h=[...n.shift],[d,m]=[!1,!1];this.pull=u,a.classList.add(
"held");let g=()=>{m=!0,f.abort(),a.classList.remove("held"),n.fixed=null,this.pull=null,d&&this.comeBack(h)},f=new AbortController,w=b=>{b.key==="Escape"&&(b.stopPropagation(),
g(),d&&this.back())};return addEventListener("keydown",w,{capture:!0,signal:f.signal}),V(i,e,b=>{if(!m){if(n.pinched()){g(),d&&this.back();return}!d&&Math.hypot(
b.clientX-e.clientX,b.clientY-e.clientY)<3||(d||(n.fixed=r.scale,this.hold(),this.begin()),d=!0,u.move(c(b),b.timeStamp),n.shift=[h[0]+u.moved,h[1]],this.change(
t,u.held,!1),this.show(t,u.held))}},(b,y)=>{m||(g(),d&&(y?(this.change(t,u.release(b.timeStamp),!0),this.end(!0)):this.back()))}),!0}key(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return;let{lab:o}=this;if(t.key==="Escape"&&this.held)this.back();else if(t.key==="Enter")this.chosen(!0);else{this.held??=ss(o.film(),o.clock.time);let n=bi(
e,t.key,t.shiftKey,this.held,o.film());if(!n)return;this.before===null&&(this.hold(),this.begin()),this.held=n,this.change(e==="load"?"hoop":e,n,!1),this.show(e,
n),this.settle()}t.preventDefault(),t.stopPropagation()}hold(){this.lab.clock.play(!1),this.before=this.lab.film().query}begin(){let{lab:e}=this;e.stage.options.
ahead=!0,e.clock.seek(0),e.root.classList.add("holding")}change(e,t,o){this.lab.motions.change(wi(e,t,this.lab.film()),o)}show(e,t){let o={load:`θ = ${$(t.angle)}`,
hoop:t.height>0?`y = ${Me(t.height)}`:`θ = ${$(t.angle)}`,plane:`β = ${$(t.slope)}`};z(this.tip,t.vx&&this.held?`${o[e]}, v = ${T(t.vx,3)} m/s`:o[e]),this.tip.
hidden=!1}chosen(e){this.held&&this.before!==null&&this.lab.motions.change([],!0),this.end(e)}end(e){let{lab:t}=this;this.held=null,this.before=null,this.tip.hidden=
!0,t.stage.options.ahead=!1,t.root.classList.remove("holding"),e&&t.clock.seek(0),e&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&t.clock.play(!0),t.
request()}async back(){let{lab:e,before:t}=this;if(this.end(!1),t===null)return;let o=e.motions.lanes[e.motions.active];for(o.pending=null;o.busy;)await new Promise(
n=>requestAnimationFrame(n));try{e.motions.replace(await e.backend.call("film",{query:t}))}catch(n){e.notice.fail(n)}}comeBack(e){let{flat:t}=this.lab.stage,o=matchMedia(
"(prefers-reduced-motion: reduce)").matches,n=()=>{if(this.pull)return;let i=t.shift[0]-e[0];t.shift=Math.abs(i)<1||o?[...e]:[e[0]+.82*i,e[1]],this.lab.request(),
t.shift[0]!==e[0]&&requestAnimationFrame(n)};n()}};var Nl={play:"M5 3l9 5.5L5 14z",pause:"M4 3h3.4v11H4zM9.6 3H13v11H9.6z",start:"M3 3h2v11H3zM14 3v11L6 8.5z",back:"M11.5 3.5v10L4.5 8.5z",on:"M5.5 3.5v10l7-5z",previous:"\
M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",next:"M2 3.5v10l6-5zM8.5 3.5v10l6-5z",undo:"M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",redo:"\
M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",two:"M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",loop:"M4 4h7.5V1.8L15.\
5 5l-4 3.2V6H6v3.5H4zM13 13H5.5v2.2L1.5 12l4-3.2V11H11V7.5h2z",slow:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM7.7 \
5h1.6v3.2l2.2 2.2-1.1 1.1-2.7-2.7z",sound:"M2 6h3l4-3.5v12L5 11H2zM11 5.5a4 4 0 0 1 0 6zM11.5 2.5a6.6 6.6 0 0 1 0 12l-.6-1.6a5 5 0 0 0 0-8.8z",large:"M2 2h5v2H4\
v3H2zM10 2h5v5h-2V4h-3zM2 10h2v3h3v2H2zM13 10h2v5h-5v-2h3z",theme:"M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z"};function J(s){let e="\
http://www.w3.org/2000/svg",t=document.createElementNS(e,"svg");t.setAttribute("viewBox","0 0 17 17"),t.setAttribute("aria-hidden","true"),t.setAttribute("class",
"icon");let o=document.createElementNS(e,"path");return o.setAttribute("d",Nl[s]),t.append(o),t}function yo(s){let e=p("select",{class:"language","aria-label":"Language",onchange:()=>{Xn(e.value),ro(e.value),s()}},Object.entries(gt).map(([t,o])=>p("option",
{value:t,lang:t},document.createTextNode(o))));return e.value=Ye(),e}var ns=class{constructor(e){this.lab=e,this.left=()=>{!document.fullscreenElement&&this.full&&this.turn(!1)},document.addEventListener("fullscreenchange",this.left),
this.full=!1,this.on=!1,this.onchange=()=>{}}async turn(e=!this.on){let{root:t}=this.lab;if(this.on=e,t.classList.toggle("presenting",e),this.onchange(),this.lab.
show(),!e){let o=this.full;this.full=!1,o&&document.fullscreenElement&&await document.exitFullscreen().catch(()=>{});return}try{await t.requestFullscreen?.(),this.
full=!!document.fullscreenElement}catch{}}close(){document.removeEventListener("fullscreenchange",this.left)}};var vi=.22,ki=.03;function _i(s,e){let t=s.at(e),o=s.mass*(s.gravity||9.81),n=t.mode==="H"||!(t.normal_force>0)?0:t.normal_force/o,i=n/(1+n),a=t.mode==="S"||t.mode===
"K",r=Math.abs(t.slip)/Math.sqrt((s.gravity||9.81)*s.radius);return{tone:i,pitch:55*(1+Math.min(n,8))**.5,hiss:a?i*k(.15+r,0,1):0}}function xi(s,e,t){let o=Math.
sqrt(2*(s.gravity||9.81)*s.radius);return s.events.filter(({kind:n,t:i,before:a})=>n==="impact"&&a&&i>e&&i<=t).map(({before:n})=>k(Math.abs(n.vy)/o,.02,1))}function Cl(s){
let e=s.createBuffer(1,s.sampleRate,s.sampleRate),t=e.getChannelData(0),o=1;for(let n=0;n<t.length;n++)o=o*16807%2147483647,t[n]=2*o/2147483647-1;return e}var is=class{static heard=_i;static knocks=xi;context=null;on=!1;last=0;start(){
let e=new AudioContext,t=e.createOscillator();t.type="triangle";let o=e.createBufferSource();o.buffer=Cl(e),o.loop=!0;let n=e.createBiquadFilter();n.type="bandp\
ass",n.frequency.value=1800,n.Q.value=.6;let[i,a]=[e.createGain(),e.createGain()];i.gain.value=a.gain.value=0,t.connect(i).connect(e.destination),o.connect(n).connect(
a).connect(e.destination),t.start(),o.start(),this.context=e,Object.assign(this,{tone:t,low:i,high:a})}turn(e){this.on=e,e&&!this.context&&this.start(),e?this.context?.
resume():this.context&&(this.set("low",0),this.set("high",0))}set(e,t){let{gain:o}=this[e];o.setTargetAtTime(vi*t,this.context.currentTime,ki)}follow(e,t){if(!this.
on||!this.context)return;if(!t.playing){this.set("low",0),this.set("high",0),this.last=t.time;return}let{tone:o,pitch:n,hiss:i}=_i(e,t.time);if(this.set("low",o),
this.set("high",.6*i),this.tone.frequency.setTargetAtTime(n,this.context.currentTime,ki),t.time>this.last)for(let a of xi(e,this.last,t.time))this.knock(a);this.
last=t.time}knock(e){let t=this.context,o=t.currentTime,n=t.createGain();n.gain.setValueAtTime(2.2*vi*Math.sqrt(e),o),n.gain.exponentialRampToValueAtTime(1e-4,o+
.18);let i=t.createOscillator();i.frequency.setValueAtTime(190,o),i.frequency.exponentialRampToValueAtTime(60,o+.15),i.connect(n).connect(t.destination),i.start(
o),i.stop(o+.2)}close(){this.context?.close()}};var vo=Math.PI/180,Q=s=>e=>e.columns[s],vt=(s,e)=>t=>t.derived(s,o=>Float64Array.from(t.t,(n,i)=>e(o,i,t))),B={time:{name:"time",symbol:"t",unit:"s",values:s=>s.
t},angle:{name:"angle",symbol:"θ",unit:"°",values:vt("degrees",({angle:s},e)=>s[e]/vo)},turns:{name:"angle within a turn",symbol:"θ mod 360°",unit:"°",values:vt(
"within",({angle:s},e)=>{let t=o=>Math.floor(s[o]/vo/360);return e>0&&t(e)!==t(e-1)?Number.NaN:s[e]/vo-360*t(e)})},x:{name:"place of the centre",symbol:"x",unit:"\
m",values:Q("x")},height:{name:"gap under the rim",symbol:"y",unit:"m",values:Q("height")},rise:{name:"height of the centre of gravity",symbol:"h_G",unit:"m",values:vt(
"rise",({height:s,angle:e},t,o)=>o.radius*(1+o.eccentricity*Math.cos(e[t]))+s[t])},vx:{name:"speed of the centre",symbol:"v",unit:"m/s",values:Q("vx")},spin:{name:"\
speed of rotation",symbol:"R θ̇",unit:"m/s",values:vt("spin",({omega:s},e,t)=>s[e]*t.radius)},vy:{name:"speed away from the plane",symbol:"ẏ",unit:"m/s",values:Q(
"vy")},slip:{name:"slip velocity",symbol:"v_t",unit:"m/s",values:Q("slip")},omega:{name:"angular velocity",symbol:"θ̇",unit:"rad/s",values:Q("omega")},normal_force:{
name:"normal force",symbol:"N",unit:"N",values:Q("normal_force")},friction_force:{name:"friction force",symbol:"F",unit:"N",values:Q("friction_force")},utilization:{
name:"use of friction",symbol:"|F|/μN",unit:"",values:Q("utilization")},kinetic:{name:"kinetic energy",symbol:"E_k",unit:"J",values:Q("kinetic")},potential:{name:"\
potential energy",symbol:"E_p",unit:"J",values:Q("potential")},total:{name:"total energy",symbol:"E",unit:"J",values:vt("total",({kinetic:s,potential:e},t)=>s[t]+
e[t])},friction_loss:{name:"lost to friction",symbol:"W_f",unit:"J",values:Q("friction_loss")},normal_loss:{name:"lost in impacts, normal part",symbol:"W_i",unit:"\
J",values:Q("normal_loss")},rolling_resistance:{name:"lost to rolling resistance",symbol:"W_r",unit:"J",values:Q("rolling_resistance")}},Ti=({name:s,symbol:e})=>[
s," ",e];var Ol=["time","angle","x","vx","spin","normal_force","friction_force"],ql=[1,.5,.2,.1,.05,.02,.01],ko=601;function Si(s,e,t){let o=Math.min(Math.floor(s.duration/
t+1e-9)+1,ko),n=[];for(let i=0;i<o;i++){let a=Number((i*t).toPrecision(12));n.push({time:a,mode:s.at(a).mode,values:e.map(r=>jl(s,r,a))})}return n}function jl(s,e,t){
if(e==="time")return t;let o=s.at(t);if(e in o&&e!=="angle")return o[e];let n=o.angle*180/Math.PI;if(e==="angle")return n;if(e==="turns")return n-360*Math.floor(
n/360);let i=B[e].values(s),a=s.index(t),r=Math.min(a+1,s.length-1),l=s.t[r]>s.t[a]?(t-s.t[a])/(s.t[r]-s.t[a]):0;return i[a]+l*(i[r]-i[a])}var as=class{film;rows=[];now;constructor(e){
this.lab=e,this.columns=[...Ol],this.step=p("select",{onchange:()=>this.fill()},ql.map(t=>p("option",{value:String(t)},`${t} s`))),this.step.value="0.1",this.picks=
p("div",{class:"table-picks"},Object.entries(B).filter(([t])=>t!=="time").map(([t,{name:o}])=>this.pick(t,o))),this.caption=p("caption",{}),this.head=p("thead",
{}),this.body=p("tbody",{}),this.element=p("section",{class:"table","aria-label":"Table of the motion",hidden:!0},p("header",{},p("h2",{},"Table"),p("label",{class:"\
table-step"},p("span",{},"Every"),this.step),p("button",{type:"button",onclick:()=>this.save()},"Save as CSV"),p("button",{type:"button",onclick:()=>this.open(!1)},
"Close")),p("details",{class:"table-columns"},p("summary",{},"Columns"),this.picks),p("div",{class:"table-scroll",tabindex:"0",role:"region","aria-label":"Table\
 of the motion, rows"},p("table",{},this.caption,this.head,this.body)))}pick(e,t){let o=p("input",{type:"checkbox",checked:this.columns.includes(e),onchange:()=>{
let n=new Set(this.columns);o.checked?n.add(e):n.delete(e),this.columns=Object.keys(B).filter(i=>n.has(i)),this.fill()}});return p("label",{},o,p("span",{},t))}open(e){
this.element.hidden=!e,e&&(this.draw(this.lab.film()),this.element.scrollIntoView({block:"nearest"}),this.element.querySelector("select")?.focus())}draw(e){this.
element.hidden||(this.film=e,this.fill())}fill(){let{film:e,columns:t}=this,o=Number(this.step.value),n=this.lab.theme.colors.mode_names,i=t.map(c=>B[c]);this.head.
replaceChildren(p("tr",{},i.map(({name:c,symbol:u,unit:h})=>p("th",{scope:"col",title:c},u,h&&p("small",{},` ${h}`))),p("th",{scope:"col"},"mode")));let a=Si(e,
t,o);this.rows=a.map(({time:c,mode:u,values:h})=>({time:c,row:p("tr",{onclick:()=>this.lab.clock.seek(c)},h.map((d,m)=>m===0?p("th",{scope:"row"},T(d,4)):p("td",
{},T(d,4))),p("td",{class:"table-mode"},n[u]))})),this.body.replaceChildren(...this.rows.map(({row:c})=>c));let r=e.duration/o+1<=ko+1e-6,l=x("The first {count}\
 rows.",{count:ko});z(this.caption,r?e.summary:ae(`${e.summary} ${l}`)),this.cursor(this.lab.clock.time)}cursor(e){if(this.element.hidden||!this.rows.length)return;
let t=Number(this.step.value),o=this.rows[Math.min(Math.round(e/t),this.rows.length-1)]?.row;o!==this.now&&(this.now?.classList.remove("now"),o?.classList.add("\
now"),this.now=o)}save(){let{film:e,columns:t}=this,o=[...t.map(i=>`${B[i].name} [${B[i].unit||"1"}]`),"mode"],n=Si(e,t,Number(this.step.value)).map(({mode:i,values:a})=>[
...a,i].join(","));Qe(new Blob([[o.join(","),...n,""].join(`\r
`)],{type:"text/csv"}),"hophoop-table.csv")}};var Mi="hoop.radius=0.4&duration=1.5&start.speed=",Dl=[["0","Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”","duratio\
n=2"],["3","Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.",null],["7","Energy on the way down, in pairs: who has th\
e energy when the load is at rest?","start.speed=0.1&duration=8"],["17","Lift at the top: at which speed is the force of the floor zero?","start.speed=3.7&durat\
ion=2"],["24","The film again, in slow motion and with forces; stop at take-off. Compare with the votes.","duration=2"],["28","Each group takes one speed of the\
 worksheet; results on the board.",`${Mi}2.2`],["35","Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?",null],
["42","One sentence each: “The hoop hops because …”",null]],Fl=[["The load pulls the hoop up at the top, so it hops there.","Only if it is very fast. Slow\
er hoops hop before the top, after slipping."],["It hops at the bottom, where it is fastest.","There the floor pushes hardest: the load has to be turned upwards\
."],["Nothing can be faster than a falling stone.","The ring can: it gets the energy of a load that has come to rest."],["Friction always brakes.","It acts agai\
nst slip. On the hoop’s way up it points forwards."],["More friction, more hop.","There is a best friction in between."],["A heavier hoop behaves otherwise.",
"Only the shares of mass count."]],Wl=["Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.","The hoop gets o\
nly the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?","While a wheel rolls, its lowest point is at rest.\
 Which part of the hoop has kinetic energy then, and how fast is the centre?","How fast is a stone that falls from the height of the load? Why can the hoop be f\
aster?","Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.","In the lab: what does the hoop do in its first 1.5 s, and\
 at which angle does it hop? Fill in the table.","Find the smallest speed with which the hoop hops, to 1 cm/s.","At 2.2 m/s the hoop leaves the floor while its \
rim slips. Why does slipping help it to hop?"],$l=["1.0","1.3","1.6","1.9","2.2","2.3"],Bl=()=>document.querySelector("meta[name=hophoop-docs]")?.content;function Ei(s,e){
let t=u=>{c.close(),s(u)},o=(u,h="Show")=>p("button",{type:"button",class:"link",onclick:()=>t(u)},h),n=Bl(),i=n&&[["teach/index.html","Teaching with the hoop"],
["teach/worksheet.html","Worksheet"],["teach/solutions.html","Solutions"],["teach/exercises.html","Exercises"]],a=p("table",{},p("caption",{},"A lesson of 45 mi\
nutes"),p("thead",{},p("tr",{},["Minute","What happens","Motion"].map(u=>p("th",{scope:"col"},u)))),p("tbody",{},Dl.map(([u,h,d])=>p("tr",{},p("th",{scope:"row"},
u),p("td",{},h),p("td",{},d===null?"":o(d)))))),r=p("table",{},p("caption",{},"What students often think"),p("thead",{},p("tr",{},["Idea","What is right"].map(u=>p(
"th",{scope:"col"},u)))),p("tbody",{},Fl.map(([u,h])=>p("tr",{},p("td",{},u),p("td",{},h))))),l=p("section",{class:"sheet"},p("h3",{},"Worksheet: the hoop that \
hops"),p("p",{},"A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a level floor with the load at th\
e top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s²."),p("ol",{},Wl.map(u=>p("li",{},u,p("div",{class:"answer-line"})))),p("table",{class:"sheet-\
table"},p("thead",{},p("tr",{},["v₀ [m/s]","phases","does it hop?","at which angle?"].map(u=>p("th",{scope:"col"},u)))),p("tbody",{},$l.map(u=>p("tr",{},p("th",
{scope:"row"},o(`${Mi}${Number(u)}`,u)),p("td",{}),p("td",{}),p("td",{})))))),c=p("dialog",{class:"teach","aria-label":"For teachers"},p("header",{},p("h2",{},"\
For teachers"),p("button",{type:"button",onclick:()=>print()},"Print"),p("button",{type:"button",class:"close",onclick:()=>c.close()},"Close")),p("p",{},"The vi\
sit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",p("button",{type:"button",class:"link",onclick:()=>{c.close(),
e()}},"Start the visit")),i&&p("p",{},i.map(([u,h])=>p("a",{class:"teach-page",href:new URL(u,new URL(n,document.baseURI)).href},h))),a,r,l);return c}var _o="RSKHM",Hl=new Set(["x","angle","height"]),Ul=1/60,Ai=8,Gl={x:"vx",angle:"omega",height:"vy"},Ae=class{constructor(e){let{header:t}=e;this.scenario=t.scenario,
this.query=t.query,this.duration=t.duration,this.status=t.status,this.sequence=t.sequence,this.events=t.events,this.values=t.values,this.automatic=t.automatic,this.
said=t.summary,this.story=t.story,this.shortened=t.shortened,this.doubt=t.doubt??"",this.columns=e.arrays,this.t=e.arrays.t,this.length=this.t.length,this.radius=
this.values["hoop.radius"],this.mass=this.values["hoop.mass"],this.eccentricity=this.values["hoop.eccentricity"],this.slope=this.scenario.plane.slope??0,this.gravity=
this.scenario.plane.gravity??9.81,this.phases=this.findPhases(),this.extent=this.findExtent(),this.cache=new Map,this.part=null}wanted(e,t=0){if(this.duration<Ul*
this.length)return null;let o=k(e,0,this.duration),n=Math.min(o+t,this.duration);if(this.part&&o>=this.part.t[0]&&n<=this.part.t[this.part.length-1])return null;
let i=Math.max(o-.25*Ai,0);return[i,Math.min(i+Ai+t,this.duration)]}refine(e){this.part=Object.assign(Object.create(this),{columns:e,t:e.t,length:e.t.length,cache:new Map,
part:null})}holding(e){let{part:t}=this;return t&&e>=t.t[0]&&e<=t.t[t.length-1]?t:this}get summary(){return si(this.said)}findPhases(){let{mode:e}=this.columns,
t=[];for(let o=0;o<this.length;o++){let n=t.at(-1);n&&n.mode===_o[e[o]]?n.to=this.t[o]:t.push({mode:_o[e[o]],from:this.t[o],to:this.t[o]})}for(let o=0;o+1<t.length;o++)
t[o].to=t[o+1].from;return t.filter(o=>o.to>o.from||t.length===1)}findExtent(){let{x:e,height:t,vx:o,vy:n,omega:i}=this.columns,a={left:1/0,right:-1/0,top:0,speed:0},
r=[];for(let l=0;l<this.length;l++){Number.isFinite(e[l])&&(a.left=Math.min(a.left,e[l]),a.right=Math.max(a.right,e[l])),t[l]>a.top&&(a.top=t[l]);let c=Math.hypot(
o[l],n[l])+this.radius*Math.abs(i[l]);Number.isFinite(c)&&r.push(c)}return r.sort((l,c)=>l-c),a.speed=r[Math.floor(.95*(r.length-1))]||1,a}index(e){let t=0,o=this.
length;for(;o-t>1;){let n=t+o>>1;this.t[n]<=e?t=n:o=n}return t}pieces(){let{part:e}=this;if(!e)return[{film:this,from:0,to:this.length}];let[t,o]=[e.t[0],e.t[e.
length-1]],n=this.index(t);for(;n>0&&this.t[n]>=t;)n--;let i=this.t[n]>=t?0:n+1;return[{film:this,from:0,to:i},{film:e,from:0,to:e.length},{film:this,from:this.
index(o)+1,to:this.length}]}at(e){let t=k(e,0,this.duration),o=this.holding(t);if(o!==this)return o.at(t);let n=this.index(t),i=Math.min(n+1,this.length-1),a=this.
t[i]-this.t[n],r=a>0?(t-this.t[n])/a:0,l={t,mode:_o[this.columns.mode[n]]};for(let[c,u]of Object.entries(this.columns)){if(c==="t"||c==="mode")continue;let h=u[n],
d=u[i];if(r===0||!Number.isFinite(d))l[c]=h;else if(Hl.has(c)){let m=this.columns[Gl[c]];l[c]=Kl(h,d,m[n]*a,m[i]*a,r)}else l[c]=h+(d-h)*r}return l}derived(e,t){
let o=this.cache.get(e)??t(this.columns);return this.cache.set(e,o),o}};function Kl(s,e,t,o,n){if(!Number.isFinite(t)||!Number.isFinite(o))return s+(e-s)*n;let i=1-
n;return i*i*(1+2*n)*s+n*n*(3-2*n)*e+n*i*(i*t-n*o)}var So=s=>s-360*Math.floor(s/360);function Vl(s,e){let t=Math.abs(So(s-e+180)-180);return Math.round(100*k(1-(t-1)/89,0,1))}function Jl(s,e){let t=Math.max(...e)-
Math.min(...e,0),o=e.reduce((n,i,a)=>n+Math.abs(i-s[a]),0)/e.length;return Math.round(100*k(1-2*o/(t||1),0,1))}var Yl=0;function xt(s,e,t=!1){let o=`hh-guess-${++Yl}`,
n="",i=s.map(([a,r])=>{let l=p("input",{type:"radio",name:o,value:a,onchange:()=>{n=a,e()}});return{key:a,radio:l,row:p("label",{class:"guess-choice"},l,p("span",
{},r))}});return{element:p("div",{class:"guess",role:"radiogroup","aria-label":"Your guess"},i.map(({row:a})=>a)),made:()=>n!=="",judge:a=>{for(let{key:r,radio:l,
row:c}of i){l.disabled=!0;let u=t||r===a;u&&c.append(p("b",{class:"guess-right"},"✓")),c.classList.toggle("right",u)}return t||n===a?100:0}}}var ke=168,_t=58,
xo=(s,e=_t)=>{let t=s*Math.PI/180;return[ke/2+e*Math.sin(t),ke/2-e*Math.cos(t)]};function Mo(s,e){let t=0,o=!1,n=null,i=p("canvas",{class:"dial-canvas"}),a=p("d\
iv",{class:"guess dial",role:"slider",tabindex:"0","aria-label":s,"aria-valuemin":"0","aria-valuemax":"360","aria-valuenow":"0"},i),r=()=>{let{context:u}=U(i),h=getComputedStyle(
a),d=h.getPropertyValue("--ink").trim(),m=h.getPropertyValue("--soft").trim(),g=h.getPropertyValue("--accent").trim();u.clearRect(0,0,ke,ke),u.strokeStyle=m,u.fillStyle=
m,u.lineWidth=1.5,u.beginPath(),u.moveTo(8,ke/2+_t),u.lineTo(ke-8,ke/2+_t),u.stroke(),u.lineWidth=4,u.beginPath(),u.arc(ke/2,ke/2,_t,0,2*Math.PI),u.stroke(),u.font=
"11px system-ui, sans-serif",u.textAlign="center";for(let w of[0,90,180,270]){let[b,y]=xo(w,_t-17);u.fillText(`${w}°`,b,y+4)}let f=(w,b,y)=>{u.fillStyle=b,u.beginPath(),
u.arc(...xo(w),y,0,2*Math.PI),u.fill()};n!==null&&(u.strokeStyle=d,u.lineWidth=2,u.beginPath(),u.arc(...xo(n),12,0,2*Math.PI),u.stroke(),f(n,d,7)),f(t,o?g:m,9)},
l=u=>{n===null&&(t=So(u),o=!0,a.setAttribute("aria-valuenow",String(Math.round(t))),a.setAttribute("aria-valuetext",`${Math.round(t)}°`),r(),e())},c=u=>{let h=i.
getBoundingClientRect(),[d,m]=[u.clientX-h.left-h.width/2,u.clientY-h.top-h.height/2];l(Math.atan2(d,-m)*180/Math.PI)};return a.addEventListener("pointerdown",u=>{
u.preventDefault(),a.focus({preventScroll:!0}),c(u),V(a,u,c)}),a.addEventListener("keydown",u=>{let h={ArrowLeft:-5,ArrowDown:-5,ArrowRight:5,ArrowUp:5,PageDown:-45,
PageUp:45}[u.key];h!==void 0&&(u.preventDefault(),u.stopPropagation(),l(t+(u.shiftKey?h/5:h)))}),requestAnimationFrame(r),{element:a,redraw:r,made:()=>o,judge:u=>(n=
So(u),r(),Vl(t,n))}}var kt=9,[we,rs,Ce,To]=[34,12,12,26];function Ri({label:s,unit:e,most:t},o){let n=Array(kt).fill(t/4),i=!1,a=null,r=p("canvas",{class:"sketc\
h-canvas"}),l=n.map((b,y)=>p("span",{class:"sketch-point",role:"slider",tabindex:"0","aria-label":`${s} with the load at ${45*y}°`,"aria-orientation":"vertical",
"aria-valuemin":"0","aria-valuemax":String(t),onkeydown:v=>{let S={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[v.key];S&&(v.preventDefault(),v.stopPropagation(),
g(y,n[y]+S*t/(v.shiftKey?100:20)))}})),c=p("div",{class:"guess sketch",role:"group","aria-label":"Draw the curve: pull the points up and down"},r,l),u=()=>r.getBoundingClientRect(),
h=b=>we+b/(kt-1)*(u().width-we-rs),d=b=>Ce+(1-b/t)*(u().height-Ce-To),m=()=>{let{context:b,width:y,height:v}=U(r),S=getComputedStyle(c),R=E=>S.getPropertyValue(
E).trim();b.clearRect(0,0,y,v),b.strokeStyle=R("--line"),b.fillStyle=R("--soft"),b.font="11px system-ui, sans-serif";for(let E=0;E<kt;E+=2)b.textAlign="center",
b.fillText(`${45*E}°`,h(E),v-8),b.strokeRect(h(E),Ce,0,v-Ce-To);for(let E of[0,t/2,t])b.textAlign="right",b.fillText(String(E),we-6,d(E)+4),b.strokeRect(we,d(E),
y-we-rs,0);b.textAlign="left",b.fillText(e,we+4,Ce+10);let M=(E,I,O)=>{b.strokeStyle=I,b.lineWidth=2.5,b.setLineDash(O),b.beginPath(),E.forEach((q,Z)=>{let ie=we+
Z/(E.length-1)*(y-we-rs);Z?b.lineTo(ie,d(k(q,0,t))):b.moveTo(ie,d(k(q,0,t)))}),b.stroke(),b.setLineDash([])};M(n,R("--accent"),[6,4]),a&&M(a,R("--ink"),[]),l.forEach(
(E,I)=>{E.style.transform=`translate(${h(I)}px, ${d(n[I])}px)`})},g=(b,y)=>{a||(n[b]=k(y,0,t),i=!0,l[b].setAttribute("aria-valuenow",n[b].toPrecision(3)),l[b].setAttribute(
"aria-valuetext",`${n[b].toPrecision(2)} ${e}`),m(),o())},f=null,w=b=>{let y=u(),v=k((b.clientX-y.left-we)/(y.width-we-rs),0,1),S=Math.round(v*(kt-1)),R=t*(1-(b.
clientY-y.top-Ce)/(y.height-Ce-To)),M=f??S,E=n[M];for(let I=Math.min(M,S);I<=Math.max(M,S);I++)g(I,M===S?R:E+(R-E)*(I-M)/(S-M));f=S};c.addEventListener("pointer\
down",b=>{b.preventDefault(),f=null,w(b),V(c,b,w)});for(let[b,y]of l.entries())y.setAttribute("aria-valuenow",n[b].toPrecision(3));return requestAnimationFrame(
m),{element:c,redraw:m,made:()=>i,judge:b=>{a=b,m();let y=(b.length-1)/(kt-1);return Jl(n,n.map((v,S)=>b[Math.round(S*y)]))}}}var hs=2*Math.PI,ee=(s,e)=>s.events.find(t=>t.kind===e),ls=s=>$(s-hs*Math.floor(s/hs));function Zl(s,e,t=72){let{angle:o}=s.columns,n=s.columns[e],i=[],a=0;for(let r=0;r<=
t;r++){let l=s.columns.angle[0]+hs*r/t;for(;a+1<s.length&&o[a+1]<l;)a+=1;let c=Math.min(a+1,s.length-1),u=o[c]>o[a]?Math.min((l-o[a])/(o[c]-o[a]),1):0;i.push(n[a]+
u*(n[c]-n[a]))}return i}var Ql=(s,e)=>s.t[s.columns.angle.findIndex(t=>t>=e)]??s.duration,Xl={R:"roll",S:"spin",K:"skid",H:"bounce"},Oe=[{key:"littlewood",title:"\
Littlewood’s question",text:"A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. J. E. Littlewood ask\
ed in 1953 what happens when the weight is level with the centre.",question:"What do you think?",queries:["hoop.load_fraction=1&start.speed=0.1&duration=3"],guess:s=>xt(
[["roll","It rolls on."],["hop","It hops: the hoop leaves the plane."],["skim","The weight falls freely, and the hoop skims the plane below it."]],s),until:([s])=>{
let[e,t]=[ee(s,"skim"),ee(s,"impact")];return e?e.t+.7*((t?.t??s.duration)-e.t):s.duration},answer:([s])=>{let e=ee(s,"skim")??ee(s,"takeoff");return{truth:e?.kind===
"skim"?"skim":e?"hop":"roll",text:"At {angle} there is no contact force any more.",values:{angle:ls(e?.angle??0)}}},why:"Littlewood said that the hoop hops. But\
 the contact force is zero, not upwards: the weight falls freely, and a rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim."},
{key:"speed",title:"A ring with mass",text:"Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",question:"\
Draw how fast the hoop’s centre goes during the first turn.",queries:["start.speed=0.1&duration=8"],guess:s=>Ri({label:"Speed of the centre",unit:"m/s",most:10},
s),until:([s])=>Ql(s,hs),answer:([s])=>{let e=Zl(s,"vx");return{truth:e,text:"With the load at the bottom the centre has {speed} m/s.",values:{speed:T(Math.max(
...e),2)}}},why:"The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all that the heavy load has lost: i\
t is faster than a stone that falls from the same height."},{key:"slip",title:"Why it slips",text:"A harder push: 2.8 m/s at the top. Rolling needs friction, an\
d friction has a limit: it is at most μ N.",question:"Where is the load when friction gives way for the first time? Turn the mark.",queries:["start.speed=2.8"],
guess:s=>Mo("Angle of the load where it begins to slip",s),until:([s])=>(ee(s,"slip_start")?.t??0)+.02,answer:([s])=>{let e=ee(s,"slip_start"),t=s.at(e.t).normal_force/
(s.mass*s.gravity);return{truth:e.angle*180/Math.PI,text:"It begins to slip at {angle}. There the plane carries only {share} of the weight.",values:{angle:ls(e.
angle),share:`${T(100*t,2)} %`}}},why:"The load on its way down and round presses little on the plane, so that N is small, while the ring has to be made faster:\
 that takes friction. Watch the diagram ‘Use of friction’: it comes to 1."},{key:"hop",title:"The hop",text:"A little faster, 3.1 m/s. This time the hoop le\
aves the plane, before the first turn is over.",question:"Where is the load when the hoop takes off? Turn the mark.",queries:[""],guess:s=>Mo("Angle of the load\
 where it takes off",s),until:([s])=>(ee(s,"takeoff")?.t??0)+.12,answer:([s])=>{let e=ee(s,"takeoff"),t=s.at(e.t-1e-6);return{truth:e.angle*180/Math.PI,text:"It\
 takes off at {angle}, while its rim slips at {slip} m/s.",values:{angle:ls(e.angle),slip:T(Math.abs(t.slip),3)}}},why:"A rolling hoop would be braked by the pl\
ane while the load comes up. Friction is too weak for that: the rim spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at th\
e top."},{key:"landing",title:"The landing",text:"The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",question:"What does it\
 do just after it has landed?",queries:[""],guess:s=>xt([["roll","It rolls at once."],["skid","It skids: the rim slides ahead."],["spin","It spins: the rim turn\
s too fast."],["bounce","It bounces."]],s),until:([s])=>(ee(s,"impact")?.t??s.duration)+.15,answer:([s])=>{let[e,t]=[ee(s,"takeoff"),ee(s,"impact")],o=s.events.
find(n=>n.kind==="apex");return{truth:Xl[s.at((t?.t??0)+1e-6).mode],text:"It was in the air for {time} s and rose by {height} cm; it lands with the load at {ang\
le}.",values:{time:T((t?.t??0)-(e?.t??0),3),height:T(100*(o?.height??0),3),angle:ls(t?.angle??0)}}},why:"An impact takes no time, but its friction is as strong \
as its push: here it is enough to stop all slip. With less friction, or more restitution, the landing would be another one. Try it afterwards."},{key:"friction",
title:"More friction, more hop?",text:"Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",question:"Which of them hops highes\
t?",queries:["plane.mu=0.05","plane.mu=0.2",""],guess:s=>xt([["0","μ = 0.05"],["1","μ = 0.2"],["2","μ = 1.0"]],s),until:s=>.3+Math.max(0,...s.map(e=>ee(e,"im\
pact")?.t??0)),answer:s=>{let e=s.map(i=>Math.max(0,...i.events.map(({kind:a,height:r})=>a==="apex"?r:0))),[t,o,n]=e.map(i=>T(100*i,3));return{truth:String(e.indexOf(
Math.max(...e))),text:"They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",values:{low:t,middle:o,high:n}}},why:"On ice nothing driv\
es the rotation; with endless friction nothing slips. The hop needs both: enough friction to turn the hoop fast on the way down, and not so much that it is brak\
ed on the way up."},{key:"undecided",title:"What rigid bodies cannot decide",text:"A hoop is thrown so that it slides fast over a rough plane. The laws of rigid\
 bodies with dry friction have to say what happens next.",question:"What do they say?",queries:["plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration\
=3","plane.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3"],guess:s=>xt([["flight","It flies off."],["impact","An impact stop\
s the slide at once."],["both","Both agree with the laws."]],s),until:s=>Math.min(.8,...s.map(e=>e.duration)),answer:s=>({truth:s.every(e=>ee(e,"painleve_indete\
rminate"))?"both":"flight",text:"Hoop A and hoop B start alike, and both motions obey every law."}),why:"Painlevé found this in 1895. For a rigid body the laws \
have two answers here, in other states none. Real bodies yield a little, and that decides: choose the compliant contact under ‘Contact’."},{key:"yours",title:"\
Your turn",text:"Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, and see how your scores are compu\
ted from the motion itself.",question:"",queries:[""]}];var Pi="hophoop-visit",cs=class{step=null;guess=null;films=[];points=new Map;play;next;stop=null;loop=null;asked=0;constructor(e,t){this.lab=e,this.onchallenges=
t,this.body=p("div",{class:"visit-body"}),this.said=p("div",{class:"visit-answer",role:"status"}),this.element=p("section",{class:"visit card","aria-label":"Gui\
ded visit",hidden:!0},this.body,this.said)}get guessing(){return!!this.guess&&!this.said.textContent}offer(){de(Pi)||(this.element.hidden=!1,z(this.said,""),this.
body.replaceChildren(p("div",{class:"buttons offer"},p("p",{},p("b",{},"New here?")," ","Eight short questions: guess, then play."),p("button",{type:"button",class:"\
main",onclick:()=>this.start()},"Start the visit"),p("button",{type:"button",onclick:()=>this.leave()},"Not now"))))}start(){this.points.clear(),this.go(0)}leave(){
pe(Pi,"seen"),this.asked+=1,this.step=this.guess=this.stop=null,this.element.hidden=!0,this.unwind(),this.lab.root.classList.remove("visiting"),this.veil(),this.
lab.show()}async go(e){let t=Oe[e],o=++this.asked,{lab:n}=this;n.clock.play(!1),n.clock.time=0,this.step=t,this.stop=null,this.guess=null,this.unwind(),z(this.said,
""),this.element.hidden=!1,n.root.classList.toggle("visiting",e<Oe.length-1);try{let i=await Promise.all(t.queries.map(a=>n.backend.call("film",{query:a})));if(o!==
this.asked)return;this.films=i.map(a=>new Ae(a)),n.motions.active=0,n.motions.set(i.slice(0,2)),this.guess=t.guess?.(()=>this.guessed())??null,this.veil(),n.changed(),
n.motions.note(),this.fill(e)}catch(i){n.notice.fail(i)}}veil(){this.lab.root.classList.toggle("guessing",this.guessing),this.guessing&&this.lab.stage.element.setAttribute(
"aria-label",x("The hoop, before it is let go."))}fill(e){let t=Oe[e];this.play=p("button",{type:"button",class:"main",disabled:!!this.guess,onclick:()=>this.show()},
"Play");let o=e===Oe.length-1,n=p("h2",{tabindex:"-1"},t.title);this.next=p("button",{type:"button",onclick:()=>this.go(e+1)},"Next"),this.body.replaceChildren(
p("header",{},p("span",{class:"visit-count"},`Step ${e+1} of ${Oe.length}`),p("progress",{max:String(Oe.length),value:String(e+1),"aria-hidden":"true"}),p("butt\
on",{type:"button",class:"quiet","aria-label":"Leave the visit",onclick:()=>this.leave()},"×")),n,p("p",{},t.text),t.question?p("p",{class:"visit-question"},t.
question):"",this.guess?.element??"",p("div",{class:"buttons"},e>0&&p("button",{type:"button",onclick:()=>this.go(e-1)},"Back"),this.guess&&this.play,o?p("butto\
n",{type:"button",class:"main",onclick:()=>this.challenge()},"Challenges"):this.next,o&&p("button",{type:"button",onclick:()=>this.leave()},"Done"),this.guess&&
p("span",{class:"hint visit-wait"},"First say what you expect, then play."))),o&&this.points.size&&this.total(),n.focus({preventScroll:!0})}guessed(){this.play&&
(this.play.disabled=!1);let e=this.body.querySelector(".visit-wait");e&&(e.hidden=!0)}show(){let{lab:e,step:t}=this;!t||!this.guess||(this.play.disabled=!0,this.
stop=t.until?.(e.films())??e.clock.duration,this.loop??=e.clock.loop,e.clock.loop=!1,e.clock.seek(0),matchMedia("(prefers-reduced-motion: reduce)").matches?e.clock.
seek(this.stop):e.clock.play(!0),this.frame())}unwind(){this.loop!==null&&(this.lab.clock.loop=this.loop),this.loop=null}frame(){let{clock:e}=this.lab;if(this.stop===
null||e.playing&&e.time<this.stop||!(e.time>=this.stop-1e-9||!e.playing))return;e.playing=!1;let o=this.stop;this.stop=null,this.unwind(),e.seek(o),this.judge()}judge(){
let{step:e,guess:t}=this;if(!e?.answer||!t)return;let{truth:o,text:n,values:i={}}=e.answer(this.films),a=t.judge(o);this.points.set(e.key,a),this.said.replaceChildren(
p("p",{},p("b",{},`${a} of 100 points.`)," ",ei(n,i)),p("p",{},e.why??"")),this.veil(),this.next.classList.add("main"),this.lab.show(),this.said.scrollIntoView(
{block:"nearest"})}total(){let e=[...this.points.values()].reduce((t,o)=>t+o,0);this.said.replaceChildren(p("p",{},`You have ${e} of ${100*this.points.size} poi\
nts.`))}challenge(){this.leave(),this.onchallenges()}changed(){this.guess?.redraw?.(),this.guessing&&this.veil()}};var us=class{words={t:x,untranslated:Je};constructor(e){this.lab=e,this.grips=new os(e),this.sound=new is,this.present=new ns(e),this.challenges=new es(e),this.
visit=new cs(e,()=>this.challenges.open()),this.table=new as(e),this.teach=Ei(t=>this.challenges.load(t),()=>this.visit.start()),this.layOut(),this.spoken()}layOut(){
let{lab:e}=this,t=e.stage.element.parentElement,o=e.root.querySelector(".side");o?o.prepend(this.visit.element,this.challenges.element):t.before(this.visit.element,
this.challenges.element),t.after(this.table.element),e.root.append(this.teach),e.transport.element.querySelector(".switches")?.before(this.tools()),e.header.element.
querySelector(".right")?.prepend(this.menu(),this.languages()),e.hosted&&!location.search&&!location.hash&&this.visit.offer()}tools(){let{clock:e}=this.lab,t=(o,n,i)=>p(
"button",{type:"button",title:n,"aria-label":n,"aria-pressed":"false",onclick:i},J(o));return this.loop=t("loop","Repeat",()=>{e.loop=!e.loop,this.mark()}),this.
slow=t("slow","Slow motion: a tenth of the speed",()=>{e.speed=e.speed===.1?1:.1,e.changed(),this.mark()}),this.loud=t("sound","Sound of the contact",()=>{this.
sound.turn(!this.sound.on),this.mark()}),this.large=t("large","Presentation on the whole screen",()=>this.present.turn()),this.present.onchange=()=>this.mark(),
this.mark(),p("div",{class:"buttons tools"},this.loop,this.slow,this.loud,this.large)}mark(){let{clock:e}=this.lab;this.loop?.setAttribute("aria-pressed",String(
e.loop)),this.slow?.setAttribute("aria-pressed",String(e.speed===.1)),this.loud?.setAttribute("aria-pressed",String(this.sound.on)),this.large?.setAttribute("ar\
ia-pressed",String(this.present.on))}menu(){let e=(o,n)=>p("button",{type:"button",onclick:()=>{t.open=!1,n()}},o),t=p("details",{class:"learn"},p("summary",{class:"\
button"},"Learn"),p("div",{class:"menu-body"},e("Guided visit",()=>this.visit.start()),e("Challenges",()=>this.challenges.open()),e("Table of the motion",()=>this.
table.open(!0)),e("Presentation",()=>this.present.turn(!0)),e("For teachers",()=>this.teach.showModal())));return this.lab.root.addEventListener("pointerdown",o=>{
t.contains(o.target)||(t.open=!1)}),t.addEventListener("keydown",o=>{o.key!=="Escape"||!t.open||(o.stopPropagation(),t.open=!1,t.querySelector("summary")?.focus())}),
t}languages(){return yo(()=>{this.spoken(),Kt(this.lab.root),this.lab.show()})}spoken(){this.lab.root.lang=Ye(),this.lab.hosted&&(document.documentElement.lang=
Ye(),document.title=x("hophoop lab: play with the hopping hoop"))}frame(){let{lab:e}=this;this.grips.draw(),this.sound.follow(e.film(),e.clock),this.table.cursor(
e.clock.time),this.visit.frame(),this.mark()}changed(){this.grips.draw(),this.table.draw(this.lab.film()),this.challenges.changed(),this.visit.changed()}close(){
this.sound.close(),this.present.close()}};var Tt=(s,e,t)=>p("button",{type:"button",title:e,"aria-label":e,onclick:t},s),ds=class{constructor(e,t,o){let n=new Map;for(let a of e)n.set(a.group,[...n.get(
a.group)??[],a]);this.fresh=!1,this.presets=p("select",{class:"presets","aria-label":"Motions to start from",onchange:()=>{let a=e.find(({key:r})=>r===this.presets.
value);this.fresh=a!==void 0,a&&o.take(a)},onblur:()=>{this.fresh=!1},onpointerdown:()=>{this.fresh=!1}},p("option",{value:""},"Motions to start from …"),[...n].
map(([a,r])=>p("optgroup",{label:a},r.map(({key:l,title:c})=>p("option",{value:l},c))))),this.undo=Tt(J("undo"),"Undo (z)",o.undo),this.redo=Tt(J("redo"),"Redo \
(y)",o.redo);let i=p("span",{},p("span",{class:"long"},"Compare"),p("span",{class:"short"},J("two")));this.compare=Tt(i,"Compare two hoops",o.compare),this.element=
p("header",{class:"top"},p("h1",{},p("span",{class:"logo","aria-hidden":"true"}),p("span",{},"hophoop",p("span",{class:"long"}," lab"))),this.presets,p("div",{class:"\
buttons"},this.undo,this.redo,this.compare),p("div",{class:"buttons right"},t,Tt(J("theme"),"Dark or light (d)",o.theme),Tt("?","Keys and help (?)",o.help)))}show(e,t){
this.undo.disabled=!e.past.length,this.redo.disabled=!e.future.length,this.compare.setAttribute("aria-pressed",String(t))}};var eh=[["space","play, pause"],["← →","one frame"],["Shift ← →","previous, next event"],["h  l","next flight, landing"],["[ ]","slower, faster"],["Home\
 End","start, end"],["t f c w","traces, forces, rim speed, whole path"],["3","in space"],["+ − 0","zoom, zoom back"],["Esc","leave a field, a menu, a picture \
that the wheel zooms"],["z y  Ctrl Z","undo, redo"],["d","dark, light"],["p","Python"]],th=[["R","roll","the rim does not slide"],["S","spin","slip: the rim tur\
ns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],["K","skid","slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],["H","\
flight","the hop: from take-off to landing"],["M","skim","a massless rim that touches without force"]],sh=[["▲ ▼","take-off, landing"],["•","highest point"],
["↺","turns back"],["◆ ◇","Painlevé’s paradox: no solution, several"],["✖","jam"],["✚","Kane: energy out of nothing"],["≋","bounces without numbe\
r end"],["◗ ■","skimming begins, rest"]],Eo=(s,e,t=()=>!1)=>p("table",{},p("caption",{},s),e.map(([o,...n])=>p("tr",{},p("th",{scope:"row"},t(o),o),n.map(i=>p(
"td",{},i)))));function zi(s,e,t){let o=p("dialog",{class:"help","aria-label":"Keys and help"},p("h2",{},"The hoop"),p("p",{},"A ring with a load on its rim rol\
ls on a plane. Friction can only hold so much, and the plane can only push: so it slips, hops, lands – or does something that rigid-body mechanics cannot decide\
. Move a slider and see."),Eo("Modes",th,n=>p("i",{class:"dot",style:`background:${e.modes[n]}`})),Eo("Marks on the bar of time",sh),Eo("Keys",eh),t,p("p",{class:"\
hint"},`hophoop ${s}`),p("button",{type:"button",class:"close",onclick:()=>o.close()},"Close"));return o}var ps=class{constructor(e){this.tabs=["A","B"].map((t,o)=>p("button",{type:"button","aria-pressed":"false",onclick:()=>e(o)},`Hoop ${t}`)),this.bar=p("div",{class:"\
tabs",role:"group","aria-label":"Which hoop the controls change",hidden:!0},this.tabs),this.text=p("p",{class:"preset-text"}),this.element=p("div",{class:"lanes"},
this.bar,this.text)}show(e,t){this.bar.hidden=e<2;for(let[o,n]of this.tabs.entries())n.setAttribute("aria-pressed",String(o===t))}};var Ii="hophoop-single-keys",oh=(s,e)=>({" ":()=>s.clock.play(),ArrowLeft:()=>e?s.transport.jump(-1):s.transport.nudge(-1),ArrowRight:()=>e?s.transport.jump(1):
s.transport.nudge(1),Home:()=>s.clock.seek(0),End:()=>s.clock.seek(s.clock.duration),h:()=>s.transport.jump(1,"takeoff"),l:()=>s.transport.jump(1,"impact"),"[":()=>s.
clock.faster(-1),"]":()=>s.clock.faster(1),t:()=>s.toggle("traces"),f:()=>s.toggle("forces"),c:()=>s.toggle("speed"),w:()=>s.toggle("whole"),3:()=>s.toggle("thr\
ee"),"+":()=>s.stage.zoom(1.25),"=":()=>s.stage.zoom(1.25),"-":()=>s.stage.zoom(.8),0:()=>s.stage.zoom(0),z:()=>s.travel(-1),y:()=>s.travel(1),d:()=>s.theme.toggle(),
p:()=>s.share.code(),"?":()=>s.help.showModal()});function nh(s,e){let t=e.key.toLowerCase();e.altKey||!(t==="z"||t==="y")||(e.preventDefault(),s.travel(t==="y"||
e.shiftKey?1:-1))}function ih(s){let e=s.share.menu;e.open&&(e.open=!1,e.querySelector("summary")?.focus())}var ms=class{constructor(e){this.on=!e||de(Ii)!=="of\
f";let t=p("input",{type:"checkbox",checked:this.on,onchange:()=>{this.on=t.checked,e&&pe(Ii,this.on?"on":"off")}});this.element=p("label",{class:"check"},t,"Si\
ngle keys (letters, digits, signs) do what the table says")}};function ah(s,e){let t=e.target;if(s.root.querySelector("dialog[open]"))return;if(e.key==="Escape"){
ih(s);return}if(t.matches?.("input:not([type=range], [type=checkbox]), textarea"))return;if(e.ctrlKey||e.metaKey){nh(s,e);return}if(e.altKey||t.matches?.("selec\
t")&&!(e.key===" "&&s.header.fresh)||t.matches?.("input[type=range]")&&/^(Arrow|Home|End|Page)/.test(e.key)||e.key===" "&&t.matches?.("button, summary, input[ty\
pe=checkbox]")||!s.singleKeys.on&&e.key!==" "&&e.key.length===1)return;let n=oh(s,e.shiftKey)[e.key];n&&(e.preventDefault(),n())}function Li(s,e){let t=e?document:
s.root,o=n=>{ah(s,n),e||n.stopPropagation()};return t.addEventListener("keydown",o),()=>t.removeEventListener("keydown",o)}function Ni(s,e){let t=p("div",{class:"edge","aria-hidden":"true"}),o=new IntersectionObserver(([n])=>{let i=!n.isIntersecting&&n.boundingClientRect.top<0;if(i===
s.classList.contains("stuck"))return;let a=s.offsetHeight;s.style.marginBottom="",s.classList.toggle("stuck",i),i&&(s.style.marginBottom=`${a-s.offsetHeight}px`),
document.documentElement.style.scrollPaddingTop=i?`${s.offsetHeight}px`:"",e()});return o.observe(t),{edge:t,close:()=>o.disconnect()}}function Ci(s,e){s.classList.add("hophoop"),!e&&(s.classList.add("embedded"),s.dataset.lmSuppressShortcuts="true",s.dataset.pSuppressShortcuts="true")}function Oi(s,e){
let{root:t,notice:o,hosted:n}=s,i=h=>!e||e.includes(h),a=p("aside",{class:"side","aria-label":"Parameters"},s.hoops.element,o.message,s.controls.element),r=p("d\
iv",{class:"player"},s.stage.element,s.timeline.element,s.transport.element),l=n?Ni(r,()=>s.request()):null,c=p("div",{class:"middle"},l?.edge,r,p("div",{class:"\
words"},s.story.element,i("theory")&&s.theory.element),i("map")&&s.map.element),u=p("div",{class:"why"},i("plots")&&s.plots.element,i("plots")&&s.phase.element);
return t.replaceChildren(p("div",{class:"page"},n&&rh(s.timeline.element),s.header.element,p("div",{class:"columns"},i("controls")&&a,c,u)),o.toast,s.share.dialog,
s.help),t.classList.toggle("no-controls",!i("controls")),l}function rh(s){s.id="hh-player";let e=p("a",{class:"skip button",href:"#hh-player"},"Skip to the play\
er");return e.onclick=t=>{t.preventDefault(),s.focus()},e}var lh={f8:Float64Array,f4:Float32Array,u1:Uint8Array};function et(s){let e=s instanceof DataView||ArrayBuffer.isView(s)?s:new DataView(s),t=new Uint8Array(e.buffer,
e.byteOffset,e.byteLength);t.byteOffset%8&&(t=t.slice());let o=new DataView(t.buffer,t.byteOffset).getUint32(0,!0),n=JSON.parse(new TextDecoder().decode(t.subarray(
4,4+o))),i={};for(let{name:a,type:r,shape:l,place:c}of n.arrays){let u=l.reduce((h,d)=>h*d,1);i[a]=new lh[r](t.buffer,t.byteOffset+4+o+c,u)}return{header:n,arrays:i}}var St=class extends Error{},hh=500,ch=4,uh="The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";async function qi(s,e,t){
for(;;)try{return await s()}catch(o){if(!(o instanceof St))throw o;e(o.message),await new Promise(n=>setTimeout(n,hh)),t.throwIfAborted()}}var fs=class{constructor(e){
this.base=e,this.shares=!0}async call(e,t,o){let n={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(t),signal:o},i=await this.answered(
new URL(`lab/${e}`,this.base),n);if(i.status===202)throw new St((await i.json()).detail);return et(await i.arrayBuffer())}async answered(e,t){for(let o=ch;;o--){
let n=await fetch(e,t).catch(a=>{throw a.name==="AbortError"?a:new Error(uh)});if(n.ok)return n;let i=Number(n.headers.get("Retry-After"));if(n.status!==503||!(i>
0)||o<=1){let a=await n.json().catch(()=>({}));throw new Error(a.detail??`The server answered ${n.status}.`)}await new Promise(a=>setTimeout(a,1e3*Math.min(i,10))),
t?.signal?.throwIfAborted()}}async file(e,t){return(await this.answered(new URL(`api/v1/files/${e}?${t}`,this.base))).blob()}link(e,t){return`${new URL(e?`?${e}`:
"",this.base)}${t}`}},dh=2e4,ph=3e5,gs=class{constructor(e){this.model=e,this.shares=!1,this.waiting=new Map,this.number=0,this.view=Math.random().toString(36).
slice(2),this.listen=(t,o)=>this.answered(t,o),e.on("msg:custom",this.listen)}answered(e,t){let o=e?.view===this.view&&this.waiting.get(e.number);o&&(clearTimeout(
o.timer),this.waiting.delete(e.number),e.compiling?o.reject(new St(e.compiling)):e.error?o.reject(new Error(e.error)):o.resolve(et(t[0])))}call(e,t,o){let n=++this.
number;return new Promise((i,a)=>{let r=setTimeout(()=>{this.waiting.delete(n),a(new Error("The notebook’s kernel does not answer; run the cell again."))},e===
"file"?ph:dh);this.waiting.set(n,{resolve:i,reject:a,timer:r}),o?.addEventListener("abort",()=>{clearTimeout(r),this.waiting.delete(n),a(new DOMException("super\
seded","AbortError"))}),this.model.send({view:this.view,number:n,call:e,body:t})})}async file(e,t){let{arrays:o}=await this.call("file",{query:t,name:e});return new Blob(
[o.content])}link(){return null}close(){this.model.off("msg:custom",this.listen)}};var[ji,mh]=[62,92],fh=12,qe=10,gh=36,Di=Math.PI/180,be=["x","y"],ws=class{box;constructor(e){this.known=new Map(e.map(t=>[t.path,t])),this.paths={x:"start.speed",
y:"plane.mu"},this.windows={x:this.whole("x"),y:this.whole("y")},this.left=ji}info(e){return this.known.get(this.paths[e])}whole(e){return[...this.info(e).range]}home(){
for(let e of be)this.windows[e]=this.whole(e)}choose(e,t){let o=e==="x"?"y":"x";this.paths[o]===t&&(this.paths[o]=this.paths[e]),this.paths[e]=t,this.home()}asked(e,t){
let[o,n]=this.windows[e];return{path:this.paths[e],from:o,to:n,cells:t}}bounds(e){let{range:t,allowed:o}=this.info(e),n=2*(t[1]-t[0]);return[Math.max(o[0],t[0]-
n),Math.min(o[1],t[1]+n)]}zoom(e,t){let o={x:[],y:[]};for(let n of be){let[i,a]=this.windows[n],r=t?.[n]??.5*(i+a);o[n]=je([r-(r-i)*e,r+(a-r)*e],this.bounds(n));
let l=Math.max(Math.abs(o[n][0]),Math.abs(o[n][1]),1e-9);if(o[n][1]-o[n][0]<400*Number.EPSILON*l)return!1}return be.every(n=>o[n].every((i,a)=>i===this.windows[n][a]))?
!1:(this.windows=o,!0)}drag(e,t,o){let n=(i,a)=>je(e[i].map(r=>r+a*(e[i][1]-e[i][0])),this.bounds(i));this.windows={x:n("x",-t/this.box.width),y:n("y",o/this.box.
height)}}restore(e){if(!be.every(t=>this.known.has(e[t][0]))||e.x[0]===e.y[0])return!1;for(let t of be)this.paths[t]=e[t][0];for(let t of be)this.windows[t]=je(
e[t].slice(1).map(Number),this.bounds(t));return!0}isHome(){return be.every(e=>this.windows[e].every((t,o)=>t===this.whole(e)[o]))}middle(){let{x:e,y:t}=this.windows;
return{x:.5*(e[0]+e[1]),y:.5*(t[0]+t[1])}}fit(e,t){this.left=this.deep("y")?mh:ji,this.box={width:e-this.left-fh,height:t-qe-gh}}clip(e){e.beginPath(),e.rect(this.
left,qe,this.box.width,this.box.height),e.clip()}x(e){let[t,o]=this.windows.x;return this.left+(e-t)/(o-t)*this.box.width}y(e){let[t,o]=this.windows.y;return qe+
(1-(e-t)/(o-t))*this.box.height}place(e,t){let o=([n,i],a)=>n+k(a,0,1)*(i-n);return{x:o(this.windows.x,(e-this.left)/this.box.width),y:o(this.windows.y,1-(t-qe)/
this.box.height)}}deep(e){let[t,o]=this.windows[e];return o-t<5e-5*Math.max(Math.abs(t),Math.abs(o))}said(e){let t=o=>{let n=this.info(o),[i,a]=this.windows[o],
r=Math.max(Math.abs(i),Math.abs(a)),l=k(Math.ceil(Math.log10(r/(a-i)))+4,4,16);return`${x(n.label)} = ${G(T(n.degrees?e[o]/Di:e[o],l),n.unit)}`};return`${t("x")}\
, ${t("y")}`}draw(e,t,o){e.strokeStyle=o.soft,e.fillStyle=o.soft,e.lineWidth=1,e.strokeRect(this.left+.5,qe+.5,this.box.width-1,this.box.height-1),e.font=`11px ${o.
font}`;for(let n of be){let i=this.info(n),a=i.degrees?1/Di:1,[r,l]=this.windows[n].map(w=>w*a),c=n==="x"?this.box.width/80:this.box.height/40,u=K(l-r,c),h=this.
deep(n),d=h?Number((.5*(r+l)).toPrecision(12)):0,m=h?re(r-d,l-d,c).map(w=>w+d):re(r,l,c);for(let w of m){let b=h?T(w-d,3):oe(w,u);n==="x"?(e.textAlign="center",
e.fillText(b,this.x(w/a),qe+this.box.height+14)):(e.textAlign="right",e.textBaseline="middle",e.fillText(b,this.left-5,this.y(w/a)),e.textBaseline="alphabetic")}
let g=h?` − ${String(d).replace("-","−")}`:"",f=`${x(i.label)}${g}${i.unit?` [${i.unit}]`:""}`;e.save(),e.textAlign="center",n==="x"?e.translate(this.left+.5*
this.box.width,t-5):(e.translate(12,qe+.5*this.box.height),e.rotate(-Math.PI/2)),e.fillText(f,0,0),e.restore()}}};function je([s,e],[t,o]){let n=Math.min(e-s,o-
t);return s<t?[t,t+n]:e>o?[o-n,o]:[s,e]}function Ao(s,e,t,o,n){for(let[i,a]of[[n,4],[o,1.8]])s.strokeStyle=i,s.lineWidth=a,s.beginPath(),s.arc(e,t,7,0,2*Math.PI),
s.moveTo(e-13,t),s.lineTo(e-4,t),s.moveTo(e+4,t),s.lineTo(e+13,t),s.moveTo(e,t-13),s.lineTo(e,t-4),s.moveTo(e,t+4),s.lineTo(e,t+13),s.stroke()}var tt=s=>matchMedia("(hover: none)").matches?"two fingers zoom":`once clicked, or with Ctrl, the wheel zooms${s&&`; ${s}`}; double-click for all`,wh=.0018,Fi=200,
[bh,yh]=[1/.6,1/1.7];function ne(s,{zoom:e,home:t,chosen:o=()=>s,keys:n=!1}){return s.addEventListener("wheel",i=>{(i.ctrlKey||i.metaKey||Vt(o()))&&(i.preventDefault(),
e(Math.exp(-Math.min(Math.max(i.deltaY,-Fi),Fi)*wh),i))},{passive:!1}),s.addEventListener("dblclick",t),n&&s.addEventListener("keydown",i=>{if(i.key==="+"||i.key===
"=")e(bh);else if(i.key==="-")e(yh);else if(i.key==="0")t();else if(i.key==="Escape")s.blur();else return;i.preventDefault(),i.stopPropagation()}),yi(s,e)}var Wi={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},$i=48;function Bi(s){let{body:e}=s,t=!1,o=ne(e,{zoom:(n,i)=>s.axes.box&&s.zoom(1/n,i?Ro(
s,i):s.pointed??void 0),home:()=>s.home(),keys:!0});e.addEventListener("pointerdown",n=>kh(s,n,o,i=>t=i)),e.addEventListener("pointermove",n=>{s.axes.box&&!t&&n.
pointerType!=="touch"&&vh(s,n)}),e.addEventListener("pointerleave",()=>s.tip.hidden=!0),e.addEventListener("keydown",n=>_h(s,n))}function Ro(s,e){let t=s.body.getBoundingClientRect();
return s.axes.place(e.clientX-t.left,e.clientY-t.top)}function vh(s,e){s.tip.textContent=s.said(Ro(s,e)),s.tip.hidden=!1;let t=s.body.getBoundingClientRect();s.
tip.style.left=`${k(e.clientX-t.left,150,Math.max(t.width-150,150))}px`,s.tip.style.bottom=`${t.bottom-e.clientY+16}px`}function kh(s,e,t,o){e.preventDefault(),
s.body.focus({preventScroll:!0});let n=[e.clientX,e.clientY],i={x:[...s.axes.windows.x],y:[...s.axes.windows.y]};s.pointed=Ro(s,e);let a=!1,r=t(),l=c=>{if(r||=t(),
r)return;let[u,h]=[c.clientX-n[0],c.clientY-n[1]];Math.hypot(u,h)<5&&!a||(a=!0,o(!0),s.tip.hidden=!0,s.axes.drag(i,u,h),s.redraw(),s.soon())};V(s.body,e,l,(c,u)=>{
u&&!a&&!r&&s.pointed&&s.take(s.pointed),o(!1)})}function _h(s,e){let t=s.pointed??s.here()??s.axes.middle();if(s.pointed=t,Wi[e.key]){let[o,n]=Wi[e.key],{x:i,y:a}=s.
axes.windows;s.pointed={x:k(t.x+o*(i[1]-i[0])/$i,i[0],i[1]),y:k(t.y+n*(a[1]-a[0])/$i,a[0],a[1])},s.state.textContent=s.said(s.pointed),s.say(s.said(s.pointed))}else if(e.
key==="Enter")s.take(t);else return;e.preventDefault(),e.stopPropagation(),s.redraw()}var xh=["start.height","start.vx","start.vy","start.omega"];function Hi(s,e){let t="speed"in s.start;return!t&&e.includes("start.speed")?"of rolling starts, tho\
ugh this motion starts otherwise":t&&e.some(o=>xh.includes(o))?"of starts in any state, though this motion starts rolling":""}var Th=Math.PI/180,Sh=12,Mh=["hop_height","flight_time","energy_lost","greatest_utilization"];function Ui(s){return s.unit==="rad"?[1/Th,"°"]:[1,s.unit==="1"?"":
s.unit]}function Eh({classes:s,what:e},t){let[o,n]=[1/0,-1/0];if(s)return[o,n];for(let i of t)i<o&&(o=i),i>n&&(n=i);return[Mh.includes(e)?Math.min(o,0):o,n]}function Gi(s){
let{values:e}=s.arrays,t=s.header,{x:o,y:n,classes:i}=t,a=new ImageData(o.cells,n.cells),[r,l]=Eh(t,e),c=i?.map(({color:h})=>ye(h));for(let h=0;h<n.cells;h++)for(let d=0;d<
o.cells;d++){let m=e[h*o.cells+d],g=4*((n.cells-1-h)*o.cells+d);if(!Number.isFinite(m))continue;let f=c&&(d+1<o.cells&&e[h*o.cells+d+1]!==m||h+1<n.cells&&e[(h+1)*
o.cells+d]!==m),w=c?c[m].map(b=>f?.72*b:b):Ve[k(Math.round(255*(m-r)/(l-r||1)),0,255)];a.data.set([...w,255],g)}let u=p("canvas",{width:o.cells,height:n.cells});
return fe(u).putImageData(a,0,0),{picture:u,header:t,values:e,x:[o.from,o.to],y:[n.from,n.to],low:r,high:l}}function Ki(s,e){let t=(n,i)=>n[0]>=i[0]-1e-300&&n[1]<=
i[1]+1e-300;return[...s.filter(n=>!(t(n.x,e.x)&&t(n.y,e.y))),e].slice(-Sh)}function Vi({header:s,low:e,high:t,values:o}){let{classes:n}=s;if(!n){let r=p("canvas",
{width:120,height:10,style:"width:120px;height:10px"}),l=fe(r);for(let h=0;h<120;h++)l.fillStyle=`rgb(${Ve[Math.floor(255*h/119)].join(",")})`,l.fillRect(h,0,1,
10);let[c,u]=Ui(s);return[p("span",{},s.label,": ",t>=e?T(e*c,3):"none"," "),r,p("span",{},t>=e?G(T(t*c,3),u):""),o.some(h=>!Number.isFinite(h))?p("span",{},p("\
i",{class:"blank"}),"none"):""]}let i=new Map;for(let r of o)i.set(r,(i.get(r)??0)+1);let a=[...i].filter(([r])=>r>=0).sort((r,l)=>l[1]-r[1]);return[...a.slice(
0,10).map(([r])=>{let{color:l,text:c}=n[r];return p("span",{},p("i",{style:`background:${l}`,"aria-hidden":"true"}),c)}),a.length>10?p("span",{},`and ${a.length-
10} more`):""]}function Ji(s,e){for(let{header:t,values:o}of[...s].reverse()){let{x:n,y:i,classes:a}=t,r=Math.floor((e.x-n.from)/(n.to-n.from)*n.cells),l=Math.floor(
(e.y-i.from)/(i.to-i.from)*i.cells);if(r<0||l<0||r>=n.cells||l>=i.cells)continue;let c=o[l*n.cells+r];if(a)return x(a[c]?.text??"not allowed");let[u,h]=Ui(t);return Number.
isFinite(c)?G(T(c*u,4),h):x("none")}return"…"}var Yi=[[24,16],[72,48],[216,144]],bs=class{film;look;asked;stale;computing;key_now;kind;level;pointed=null;constructor(e,t,{take:o,say:n,changed:i}){this.backend=
e,this.onmotion=o,this.say=n,this.changed=i;let a=t.controls.map_axes;this.axes=new ws(a),this.what="sequence",this.layers=[],this.canvas=p("canvas",{class:"plo\
t-canvas"}),this.tip=p("div",{class:"tip",hidden:!0}),this.body=p("div",{class:"map-body",tabindex:"0",role:"application","aria-label":"Map of motions. Arrow ke\
ys move the mark, Enter takes the motion, plus and minus zoom."},this.canvas,this.tip),this.keys=p("div",{class:"map-keys"}),this.state=p("span",{class:"hint"});
let r=l=>{let c=p("select",{"data-axis":l,onchange:()=>this.setAxis(l,c.value)},a.map(({path:u,label:h})=>p("option",{value:u},h)));return c};this.selects={x:r(
"x"),y:r("y")},this.quantity=p("select",{"aria-label":"What the map shows",onchange:()=>{this.what=this.quantity.value,this.refresh()}},t.map_quantities.map(([l,
c])=>p("option",{value:l},c))),this.element=p("section",{class:"map","aria-label":"Map of motions"},p("div",{class:"map-head"},p("h2",{},"Map"),p("label",{},"of",
this.quantity),p("label",{},"Across",this.selects.x),p("label",{},"Up",this.selects.y),p("span",{class:"buttons"},p("button",{type:"button","aria-label":"Zoom i\
nto the map",onclick:()=>this.zoom(.5)},"+"),p("button",{type:"button","aria-label":"Zoom out of the map",onclick:()=>this.zoom(2)},"−"),p("button",{type:"but\
ton",onclick:()=>this.home()},"Whole map")),this.state),this.body,this.keys,p("p",{class:"hint"},`Click to take that motion into the player; ${tt("drag to move")}\
.`)),Bi(this),this.soon=ge(()=>this.refresh(),140),this.seen=!1,this.watch=new IntersectionObserver(([l])=>{this.seen=l.isIntersecting,this.seen&&this.stale&&this.
refresh()}),this.watch.observe(this.body),this.syncSelects()}close(){this.asked?.abort(),this.watch.disconnect()}syncSelects(){for(let e of be)this.selects[e].value=
this.axes.paths[e]}setAxis(e,t){this.axes.choose(e,t),this.syncSelects(),this.refresh()}home(){this.axes.home(),this.refresh()}key_of(e){let t=structuredClone(e);
for(let o of Object.values(this.axes.paths)){let[n,i]=o.split(".");t[n]&&delete t[n][i]}return JSON.stringify(t)}mark(e,t){this.film=e,this.look=t;let o=this.key_of(
e.scenario);o!==this.key_now&&(this.key_now=o,this.soon()),this.redraw()}shown(){let{paths:e,windows:t}=this.axes;if(this.what==="sequence"&&this.axes.isHome()&&
e.x==="start.speed"&&e.y==="plane.mu")return;let o=n=>[e[n],...t[n]];return{what:this.what,x:o("x"),y:o("y")}}restore(e){![...this.quantity.options].some(({value:t})=>t===
e.what)||!this.axes.restore(e)||(this.quantity.value=this.what=e.what,this.syncSelects())}async refresh(){if(!this.film)return;if(this.changed(),!this.seen){this.
stale=!0;return}this.stale=!1,this.asked?.abort(),this.asked=new AbortController;let{signal:e}=this.asked,t=this.film.scenario,o=t.contact.model==="rigid"?[]:[[
"contact.model","rigid"]];this.computing=!0;let n=`${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;n!==this.kind&&(this.layers=[]),this.
kind=n,this.redraw();try{for(let[i,a]of Yi){z(this.state,`computing ${i*a} motions …`);let r={x:this.axes.asked("x",i),y:this.axes.asked("y",a)},l={scenario:t,
changes:o,...r,what:this.what},c=await qi(()=>this.backend.call("map",l,e),m=>{z(this.state,m)},e),u=Gi(c);this.layers=Ki(this.layers,u),this.keys.replaceChildren(
...Vi(u));let h=Hi(t,Object.values(this.axes.paths)),d=x(o.length?"{count} motions, with rigid contact":"{count} motions",{count:i*a});z(this.state,h?`${d}; ${x(
h)}`:d),this.redraw()}this.level=Yi.length}catch(i){let{name:a,message:r}=i;if(a==="AbortError")return;z(this.state,r)}this.computing=!1}redraw(){if(!this.film)
return;let{look:e}=this,{context:t,width:o,height:n}=U(this.canvas);this.axes.fit(o,n),t.clearRect(0,0,o,n),t.save(),this.axes.clip(t),t.imageSmoothingEnabled=!1;
let{axes:i}=this;for(let r of this.layers){let[l,c]=r.x.map(d=>i.x(d)),[u,h]=r.y.map(d=>i.y(d));t.drawImage(r.picture,l,h,c-l,u-h)}let a=this.here();a&&Ao(t,i.x(
a.x),i.y(a.y),e.ink,e.paper),this.pointed&&Vt(this.body)&&Ao(t,i.x(this.pointed.x),i.y(this.pointed.y),"#D55E00",e.paper),t.restore(),i.draw(t,n,e)}here(){let e=o=>{
let[n,i]=o.split(".");return this.film.values[o]??this.film.scenario[n]?.[i]},t={x:e(this.axes.paths.x),y:e(this.axes.paths.y)};return typeof t.x=="number"&&typeof t.
y=="number"?t:null}said(e){return`${this.axes.said(e)}: ${Ji(this.layers,e)}`}take(e){this.onmotion([[this.axes.paths.x,e.x],[this.axes.paths.y,e.y]])}zoom(e,t){
this.tip.hidden=!0,this.axes.zoom(e,t)&&(this.redraw(),this.soon())}};var ys=class{constructor(){this.past=[],this.future=[],this.now=null,this.what="",this.when=-1/0}note(e,t="",o=performance.now()){let n=this.now;if(this.now=e,n===
null||Po(n,e))return"same";let i=t!==""&&t===this.what&&o-this.when<1e3&&this.past.length>0;return this.what=t,this.when=o,this.future=[],i?"again":(this.past.push(
n),this.past.length>500&&this.past.shift(),"step")}next(e){return(e<0?this.past:this.future).at(-1)??null}step(e){let[t,o]=e<0?[this.past,this.future]:[this.future,
this.past],n=t.pop();!n||!this.now||(o.push(this.now),this.now=n,this.what="")}arrive(e){if(!(this.now&&Po(this.now,e))){for(let t of[-1,1]){let o=t<0?this.past:
this.future,n=o.length-o.findLastIndex(i=>Po(i,e));if(!(n>o.length)){for(let i=0;i<n;i++)this.step(t);return}}Object.assign(this,{past:[],future:[],now:e,what:""})}}},
Po=(s,e)=>JSON.stringify(s)===JSON.stringify(e);var vs=class{constructor(e,t){this.backend=e,this.listener=t,this.history=new ys,this.lanes=[],this.active=0,this.going=Promise.resolve()}film(e=this.active){return this.
lanes[e].film}films(){return this.lanes.map(e=>e.film)}waiting(){return new Set((this.lanes[this.active].pending??[]).map(([e])=>e))}name(){return this.lanes.length>
1?"AB"[this.active]:""}set(e){this.lanes=e.map(t=>({film:new Ae(t)})),this.active=Math.min(this.active,this.lanes.length-1)}async load(e){this.set(await Promise.
all(e.map(t=>this.backend.call("film",{query:t}))))}change(e,t){let o=this.lanes[this.active];o.since??=performance.now(),o.pending=[...(o.pending??[]).filter(([
n])=>!e.some(([i])=>i===n)),...e],o.commit||=t,o.what=e.map(([n])=>n).join(),this.pump(o)}async pump(e){if(e.busy||!this.lanes.includes(e))return;if(!e.pending){
e.commit&&this.settle(e);return}let t=e.pending,{since:o}=e;e.pending=null,e.since=null,e.busy=!0;try{e.film=new Ae(await this.backend.call("film",{scenario:e.film.
scenario,changes:t})),this.lanes.includes(e)&&this.listener.shown(o)}catch(n){this.lanes.includes(e)&&this.listener.failed(n,t)}finally{e.busy=!1}this.pump(e)}refine(e,t){
for(let o of this.lanes){let{film:n}=o,i=o.refining||o.coarse===n?null:n.wanted(e,t);i&&(o.refining=!0,this.backend.call("samples",{scenario:n.scenario,window:i}).
then(({arrays:a})=>{n.refine(a),this.listener.refined()}).catch(()=>{o.coarse=n}).finally(()=>{o.refining=!1}))}}settle(e){e.commit=!1,this.note(e.what),this.listener.
settled()}queries(){return this.films().map(e=>e.query)}note(e){this.listener.noted(this.history.note(this.queries(),e))}replace(e){this.lanes[this.active]={film:new Ae(
e)},this.listener.shown(),this.note()}travel(e){return this.inTurn(async()=>{let t=this.history.next(e);t&&(await this.load(t),this.history.step(e),await this.listener.
travelled(e),this.listener.shown(),this.listener.noted("travelled"))})}arrive(e){return this.inTurn(async()=>{await this.load(e),this.history.arrive(e),this.listener.
shown(),this.listener.noted("travelled")})}inTurn(e){return this.going=this.going.then(e).then(()=>!0,t=>(this.listener.failed(t),!1)),this.going}compare(){this.
lanes.length===1?(this.lanes.push({film:this.lanes[0].film}),this.active=1):(this.lanes.splice(1-this.active,1),this.active=0),this.listener.shown(),this.note()}choose(e){
this.active=e,this.listener.shown(),this.listener.noted("same")}link(e=""){let o=[this.lanes.length>1?`with=${encodeURIComponent(this.film(1).query)}`:"",e].filter(
Boolean).join("&");return this.backend.link(this.film(0).query,o&&`#${o}`)}};var Ah=6e3,ks=class{constructor(){this.message=p("p",{class:"message",role:"alert",hidden:!0}),this.toast=p("div",{class:"toast",role:"status",hidden:!0}),this.
timer=0}fail(e){z(this.message,e.message),this.message.hidden=!1,this.seen()||this.say(e.message,this.message.isConnected)}seen(){let{top:e,bottom:t,height:o}=this.
message.getBoundingClientRect();return this.message.isConnected&&o>0&&e>=0&&t<=innerHeight}clear(){this.message.hidden=!0}say(e,t=!1){this.toast.setAttribute("r\
ole",t?"presentation":"status"),z(this.toast,e),this.toast.hidden=!1,clearTimeout(this.timer),this.timer=setTimeout(()=>{this.toast.hidden=!0},Ah)}};var C=52,Re=10,P=8,_s=30;function Zi(s,e){if(!s.length)return[0,1];let t=Float64Array.from(s).sort(),[o,n]=[t[0],t[t.length-1]],[i,a]=[t[Math.floor(.02*t.length)],
t[Math.ceil(.98*t.length)-1]],r=Math.max(a-i,1e-12);n>a+4*r&&(n=a+.6*r),o<i-4*r&&(o=i-.6*r),o=Math.min(o,0),n=Math.max(n,0),e&&([o,n]=[-Math.max(-o,n),Math.max(
-o,n)]);let l=.06*(n-o)||1;return[o<0?o-l:o,n+l]}function Qi(s,e,t,o){let{look:n,box:i,heights:a,range:r}=e;s.font=`11px ${n.font}`,s.strokeStyle=n.line,s.fillStyle=
n.soft,s.lineWidth=1;let l=Math.max(i.height/28,4);for(;re(a[0],a[1],l).length<3&&l<12;)l+=1;let c=K(a[1]-a[0],l);s.textAlign="right",s.textBaseline="middle";for(let f of re(
a[0],a[1],l)){let w=Math.round(e.y(f))+.5;s.globalAlpha=Math.abs(f)<1e-9*c?1:.55,s.beginPath(),s.moveTo(C,w),s.lineTo(t-Re,w),s.stroke(),s.globalAlpha=1,s.fillText(
oe(f,c),C-6,w)}let u=i.width/70,h=K(r[1]-r[0],u);s.textAlign="center",s.textBaseline="alphabetic";let{name:d,unit:m}=B[e.shared.axis],g=m?`${x(d)} [${m}]`:x(d);
for(let f of re(r[0],r[1],u)){let w=e.x(f);s.beginPath(),s.moveTo(w,P+i.height),s.lineTo(w,P+i.height+4),s.stroke(),s.fillText(oe(f,h),w,P+i.height+15)}s.textAlign=
"right",s.fillText(g,t-Re,o-3),s.save(),s.translate(11,P+.5*i.height),s.rotate(-Math.PI/2),s.textAlign="center",s.fillText(x(e.unit),0,0),s.restore()}var Rh="RSKHM?";function Xi(s,e,t){let o=s.length/e,n=p("canvas",{width:e,height:o}),i=new ImageData(e,o);for(let a=0;a<o;a++)for(let r=0;r<e;r++){let l=Rh[s[a*
e+r]],c=ye(t[l]??"#6E6E6E"),u=4*((o-1-a)*e+r);i.data.set([...c,255],u)}return fe(n).putImageData(i,0,0),n}function ea(s,e,t){let o=t.length;s.strokeStyle=dt(e.look.
dark?"#ffffff":"#000000",.28),s.lineWidth=1;for(let n=0;n<o;n++){if(!t[n])continue;let i=n;for(;i<o&&t[i]===t[n];)i++;let a=e.x(n*2*Math.PI/o),r=e.x(i*2*Math.PI/
o);s.save(),s.beginPath(),s.rect(a,P,r-a,e.box.height),s.clip(),s.beginPath();let l=t[n];for(let c=-e.box.height;c<r-a+e.box.height;c+=7)s.moveTo(a+c,l>0?P+e.box.
height:P),s.lineTo(a+c+e.box.height,l>0?P:P+e.box.height);s.stroke(),s.restore(),n=i}}function ta(s,e,t,o){let{look:n}=e;s.font=`11px ${n.font}`,s.strokeStyle=n.
soft,s.fillStyle=n.soft,s.lineWidth=1,s.strokeRect(C+.5,P+.5,e.box.width-1,e.box.height-1),s.textAlign="center";let i=e.range[0]*180/Math.PI,a=e.range[1]*180/Math.
PI,r=a-i>200?45:K(a-i,6);for(let c=Math.ceil(i/r-1e-9);c*r<=a+1e-9;c++){let u=e.x(c*r*Math.PI/180);s.beginPath(),s.moveTo(u,P+e.box.height),s.lineTo(u,P+e.box.height+
4),s.stroke(),s.fillText(oe(c*r,r),u,P+e.box.height+15)}s.textAlign="right",s.fillText(x("angle θ within a turn [°]"),t-Re,o-3),s.textBaseline="middle";let l=e.
top()-e.bottom();for(let c of re(e.bottom(),e.top(),5))s.fillText(oe(c,K(l,5)),C-6,e.y(c));s.textBaseline="alphabetic",s.save(),s.translate(11,P+.5*e.box.height),
s.rotate(-Math.PI/2),s.textAlign="center",s.fillText("θ̇ [rad/s]",0,0),s.restore()}var xs={solid:[],dash:[6,4],dot:[2,3],long:[14,4],mixed:[8,3,2,3]};function Ts(s,e="solid"){let t=p("i",{class:"swatch","aria-hidden":"true"});if(t.style.borderTopColor=
s??"var(--ink)",t.style.borderTopStyle={solid:"solid",dash:"dashed",dot:"dotted",long:"none",mixed:"none"}[e],e==="long"||e==="mixed"){let o=0,n=xs[e].map((i,a)=>(o+=
i,`${a%2?"transparent":s??"var(--ink)"} ${o-i}px ${o}px`));t.style.height="2.5px",t.style.width="28px",t.style.background=`repeating-linear-gradient(90deg, ${n.
join(", ")})`}return t}var Ss=class{films;active;look;box;window;pictures;reached;forwards;backwards;keyed;sharpening;constructor(e,t,o){this.backend=e,this.clock=t,this.colors=o,this.
canvas=p("canvas",{class:"plot-canvas"}),this.over=p("canvas",{class:"plot-canvas plot-over"}),this.keys=p("div",{class:"plot-keys"}),this.body=p("div",{class:"\
plot-body",role:"img",tabindex:"0","aria-label":"Plane of angle and angular velocity with the regions of rolling, slip and flight"},this.canvas,this.over),this.
element=p("section",{class:"phase"},p("header",{},p("h3",{},"Plane of θ and θ̇"),this.keys),this.body,p("p",{class:"hint"},"Colours: the mode that follows co\
ntact without slip. Hatched: slip that meets Painlevé’s paradox."," ",`Click to go there; ${tt("")}.`)),this.body.addEventListener("pointerdown",n=>this.seek(
n)),this.pinched=ne(this.body,{zoom:(n,i)=>this.box&&this.zoomAbout(i?this.point(i):this.middle(),1/n),home:()=>this.home(),keys:!0}),this.range=[0,2*Math.PI],this.
asked="",this.soon=ge(()=>this.sharpen(),140)}async fetch(e,t){let o=this.reach(),n=JSON.stringify([e.hoop,e.plane,o]);if(n!==this.asked){let i=await this.painted(
e,[0,2*Math.PI,-o,o],t);this.asked=n,this.pictures=[i],this.redraw()}this.window&&await this.sharpen()}async sharpen(){if(this.sharpening?.abort(),!(!this.pictures||
this.isWhole())){this.sharpening=new AbortController;try{let e=await this.painted(this.films[this.active].scenario,[...this.range,this.bottom(),this.top()],this.
sharpening.signal);this.pictures=[this.pictures[0],e],this.redraw()}catch(e){if(e.name!=="AbortError")throw e}}}async painted(e,t,o){let{header:n,arrays:i}=await this.
backend.call("regions",{scenario:e,window:t},o);return o?.throwIfAborted(),{window:n.window,paradox:i.paradox,picture:Xi(i.modes,i.paradox.length,this.colors.modes)}}reach(){
return this.reached}findReach(){let e=0;for(let o of this.films??[]){let n=Float64Array.from(o.columns.omega,Math.abs).filter(Number.isFinite).sort();e=Math.max(
e,n[Math.floor(.99*(n.length-1))]??0)}let t=K(Math.max(e,1)*1.15,4);return Math.ceil(Math.max(e,1)*1.12/t)*t}home(){this.range=[0,2*Math.PI],this.window=null,this.
wholeAgain(),this.redraw()}isWhole(){let[e,t]=this.range;return t-e>=2*Math.PI-1e-9&&(!this.window||this.window[1]-this.window[0]>=2*this.reach()-1e-9)}wholeAgain(){
this.sharpening?.abort(),this.pictures?.splice(1)}point(e){let t=this.body.getBoundingClientRect(),o=(e.clientX-t.left-C)/this.box.width,n=1-(e.clientY-t.top-P)/
this.box.height;return[this.range[0]+o*(this.range[1]-this.range[0]),this.bottom()+n*(this.top()-this.bottom())]}middle(){return[.5*(this.range[0]+this.range[1]),
.5*(this.bottom()+this.top())]}zoomAbout([e,t],o){let n=Math.max(e-(e-this.range[0])*o,0),i=Math.min(e+(this.range[1]-e)*o,2*Math.PI),a=this.reach(),r=Math.max(
t-(t-this.bottom())*o,-a),l=Math.min(t+(this.top()-t)*o,a);this.range=[n,i],this.window=[r,l],this.isWhole()?this.wholeAgain():this.soon(),this.redraw()}bottom(){
return this.window?this.window[0]:this.backwards?-this.reach():0}top(){return this.window?this.window[1]:this.forwards?this.reach():.12*this.reach()}draw(e,t,o){
this.films=e,this.active=t,this.look=o,this.reached=this.findReach(),this.forwards=e.some(n=>n.columns.omega.some(i=>i>.3)),this.backwards=e.some(n=>n.columns.omega.
some(i=>i<-.3)),!this.forwards&&!this.backwards&&(this.forwards=!0),this.redraw()}x(e){return C+(e-this.range[0])/(this.range[1]-this.range[0])*this.box.width}y(e){
return P+(1-(e-this.bottom())/(this.top()-this.bottom()))*this.box.height}redraw(){if(!this.films)return;let{colors:e,look:t}=this,{context:o,width:n,height:i}=U(
this.canvas);if(this.box={width:n-C-Re,height:i-P-_s},o.clearRect(0,0,n,i),o.save(),o.beginPath(),o.rect(C,P,this.box.width,this.box.height),o.clip(),this.pictures){
o.imageSmoothingEnabled=!1;for(let{picture:a,window:r}of this.pictures){let[l,c,u,h]=r,d=[this.x(l),this.y(h),this.x(c)-this.x(l),this.y(u)-this.y(h)];o.fillStyle=
t.panel,o.fillRect(d[0],d[1],d[2],d[3]),o.globalAlpha=.35,o.drawImage(a,d[0],d[1],d[2],d[3]),o.globalAlpha=1}ea(o,this,this.pictures[0].paradox)}for(let[a,r]of this.
films.entries())this.way(o,r,a);if(o.restore(),ta(o,this,n,i),this.keyed!==t.dark){this.keyed=t.dark;let a=Object.entries(e.mode_names).filter(([r])=>"RSKH".includes(
r));this.keys.replaceChildren(...a.map(([r,l])=>p("span",{class:"plot-key"},Ts(e.modes[r]),l)))}this.cursor(this.clock.time)}way(e,t,o){let{angle:n,omega:i,mode:a}=t.
columns,r=2*Math.PI;e.lineWidth=o?1.2:1.8,e.setLineDash(o?[4,3]:[]),e.strokeStyle=this.films.length>1?ue(o,this.look.dark):this.look.ink,e.beginPath();let l=null;
for(let c=0;c<t.length;c++){if(!Number.isFinite(i[c])){l=null;continue}let u=Math.floor(n[c]/r),h=n[c]-u*r;if(l===null)e.moveTo(this.x(h),this.y(i[c]));else if(u!==
l.lap){let d=u>l.lap?r:0;e.lineTo(this.x(d),this.y(i[c])),e.moveTo(this.x(r-d),this.y(i[c])),e.lineTo(this.x(h),this.y(i[c]))}else e.lineTo(this.x(h),this.y(i[c]));
l={lap:u,mode:a[c]}}e.stroke(),e.setLineDash([])}cursor(e){if(!this.films||!this.box)return;let{context:t,width:o,height:n}=U(this.over);t.clearRect(0,0,o,n),this.
films.forEach((i,a)=>{let r=i.at(e),l=2*Math.PI,c=r.angle-Math.floor(r.angle/l)*l,u=this.x(c),h=this.y(r.omega);u>=C&&u<=C+this.box.width&&h>=P&&h<=P+this.box.height&&
(t.beginPath(),t.arc(u,h,a?4:5.5,0,2*Math.PI),t.fillStyle=this.colors.modes[r.mode],t.fill(),t.lineWidth=2,t.strokeStyle=this.films.length>1?ue(a,this.look.dark):
this.look.ink,t.stroke(),!(this.films.length<2)&&(t.font=`700 12px ${this.look.font}`,t.textAlign="left",t.fillStyle=t.strokeStyle,t.fillText("AB"[a],u+8,h-6)))})}seek(e){
let t=this.body.getBoundingClientRect(),[o,n]=[e.clientX-t.left,e.clientY-t.top];if(this.pinched())return;let i=this.films[this.active],{angle:a,omega:r}=i.columns,
l=2*Math.PI,c={distance:1/0,t:0};for(let u=0;u<i.length;u++){let h=a[u]-Math.floor(a[u]/l)*l,d=Math.hypot(this.x(h)-o,this.y(r[u])-n);d<c.distance&&(c={distance:d,
t:i.t[u]})}c.distance<40&&this.clock.seek(k(c.t,0,i.duration))}};var st=class{films;active;look;box;range;heights;picked;named;values;constructor({key:e,title:t,unit:o,curves:n,limits:i,symmetric:a=!1},r){this.key=e,this.title=
t,this.unit=o,this.curves=n,this.limits=i,this.symmetric=a,this.shared=r,this.canvas=p("canvas",{class:"plot-canvas"}),this.over=p("canvas",{class:"plot-canvas \
plot-over"}),this.keys=p("div",{class:"plot-keys"}),this.body=p("div",{class:"plot-body",tabindex:"0",role:"img","aria-label":t},this.canvas,this.over),this.element=
p("section",{class:"plot","data-plot":e},p("header",{},p("h3",{},t),this.keys),this.body),this.body.addEventListener("pointerdown",l=>this.press(l)),this.pinched=
ne(this.body,{zoom:(l,c)=>this.films&&this.zoomAbout(c?this.valueAt(c):this.middle(),1/l),home:()=>this.zoomTo(null),keys:!0}),this.onseek=()=>{}}abscissa(e){return B[this.
shared.axis].values(e)}fullRange(){if(this.shared.axis==="time")return[0,Math.max(...this.films.map(o=>o.duration),1e-9)];let[e,t]=[1/0,-1/0];for(let o of this.
films)for(let n of this.abscissa(o))n<e&&(e=n),n>t&&(t=n);return t>e?[e,t]:[e-1,t+1]}draw(e,t,o,n){this.films=e,this.active=t,this.look=o;let{context:i,width:a,
height:r}=U(this.canvas);this.box={width:a-C-Re,height:r-P-_s},i.clearRect(0,0,a,r),this.range=this.shared.range??this.fullRange();let l=e.flatMap((c,u)=>this.shades(
c,u).map((h,d)=>({...h,film:c,lane:u,number:d})));this.heights=this.limits??this.findHeights(l),this.shared.axis==="time"&&this.bands(i,e[t],n),Qi(i,this,a,r),i.
save(),i.beginPath(),i.rect(C,P,this.box.width,this.box.height),i.clip();for(let c of l)this.curve(i,c);if(e.length>1)for(let c of l)c.number===0&&this.letter(i,
c);i.restore(),this.legend(this.shades(e[t],t),o.dark),this.describe(l)}shades(e,t){let{dark:o}=this.look;if(this.films.length<2)return this.curves(e).map(i=>({
...i,color:i.color&&pt(i.color,o)}));let n=Object.keys(xs);return this.curves(e).map((i,a)=>({...i,color:ue(t,o),dash:n[a%n.length]}))}x(e){return C+(e-this.range[0])/
(this.range[1]-this.range[0])*this.box.width}y(e){return P+(1-(e-this.heights[0])/(this.heights[1]-this.heights[0]))*this.box.height}findHeights(e){let t=[];for(let{
film:o,values:n}of e){let i=this.abscissa(o);for(let a=0;a<n.length;a++)i[a]>=this.range[0]&&i[a]<=this.range[1]&&Number.isFinite(n[a])&&t.push(n[a])}return Zi(
t,this.symmetric)}bands(e,t,o){for(let n of t.phases){let i=k(this.x(n.from),C,C+this.box.width),a=k(this.x(n.to),C,C+this.box.width);a<=i||(e.fillStyle=dt(o.modes[n.
mode],.14),e.fillRect(i,P,a-i,this.box.height))}}curve(e,{film:t,color:o,dash:n,number:i}){e.strokeStyle=o??this.look.ink,e.lineWidth=1.8,e.setLineDash(xs[n??"s\
olid"]),e.beginPath();let a=!1;for(let r of t.pieces()){let l=this.abscissa(r.film),{values:c}=this.curves(r.film)[i];for(let u=r.from;u<r.to;u++){if(!Number.isFinite(
c[u])||!Number.isFinite(l[u])){a=!1;continue}let h=this.x(l[u]),d=k(this.y(c[u]),-1e4,1e4);a?e.lineTo(h,d):e.moveTo(h,d),a=!0}}e.stroke(),e.setLineDash([])}letter(e,{
film:t,lane:o,values:n,color:i}){let a=this.abscissa(t),r=this.range[0]+(o?.84:.7)*(this.range[1]-this.range[0]),l=a.findIndex(h=>h>=r);if(l<0||!Number.isFinite(
n[l]))return;let[c,u]=[this.x(a[l]),k(this.y(n[l])-8,P+10,P+this.box.height-4)];e.font=`700 12px ${this.look.font}`,e.textAlign="center",e.lineWidth=4,e.strokeStyle=
this.look.panel,e.strokeText("AB"[o],c,u),e.fillStyle=i??this.look.ink,e.fillText("AB"[o],c,u)}legend(e,t){let o=e.map(n=>n.name+n.color+n.dash).join()+t;this.named!==
o&&(this.named=o,this.values=e.map(()=>p("span",{class:"value"})),this.keys.replaceChildren(...e.map((n,i)=>p("span",{class:"plot-key"},Ts(n.color,n.dash),n.name,
" ",this.values[i]))))}describe(e){let t=e.slice(0,6).map(({name:n,values:i,lane:a})=>{let[r,l]=[1/0,-1/0];for(let h of i)h<r&&(r=h),h>l&&(l=h);let c=this.films.
length>1?`${"AB"[a]}: `:"",u={name:x(n),low:T(r,3),high:T(l,3)};return l>=r?`${c}${x("{name} from {low} to {high}",u)}`:""}),o=x("Diagram: {title} in {unit}.",{
title:x(this.title),unit:x(this.unit)});this.body.setAttribute("aria-label",`${o} ${t.filter(Boolean).join("; ")}.`)}cursor(e){if(!this.films)return;let{context:t,
width:o,height:n}=U(this.over);if(t.clearRect(0,0,o,n),this.films.forEach((i,a)=>{let r=i.holding(e),l=r.at(e),c=r.index(l.t),u=Math.min(c+1,r.length-1),h=r.t[u]>
r.t[c]?(l.t-r.t[c])/(r.t[u]-r.t[c]):0,d=this.abscissa(r),m=this.x(d[c]+h*(d[u]-d[c])),g=m>=C-1&&m<=C+this.box.width+1;g&&(t.strokeStyle=this.look.soft,t.lineWidth=
1,t.beginPath(),t.moveTo(m,P),t.lineTo(m,P+this.box.height),t.stroke()),this.shades(r,a).forEach((f,w)=>{let b=f.values[u],y=Number.isFinite(b)?f.values[c]+h*(b-
f.values[c]):f.values[c];a===this.active&&this.values?.[w]&&(this.values[w].textContent=T(y,3));let v=this.y(y);!g||!(v>=P-1&&v<=P+this.box.height+1)||(t.fillStyle=
f.color??this.look.ink,t.beginPath(),t.arc(m,v,3.2,0,2*Math.PI),t.fill())})}),this.picked){let[i,a]=this.picked;t.fillStyle=dt("#0072B2",.2),t.fillRect(Math.min(
i,a),P,Math.abs(a-i),this.box.height)}}valueAt(e){let t=this.body.getBoundingClientRect(),o=k((e.clientX-t.left-C)/this.box.width,0,1);return this.range[0]+o*(this.
range[1]-this.range[0])}press(e){if(!this.films)return;let t=this.body.getBoundingClientRect(),o=e.clientX-t.left,n=this.valueAt(e),i=this.pinched(),a=r=>{if(i||=
this.pinched(),i)return;let l=r.clientX-t.left;this.picked=e.pointerType==="mouse"&&Math.abs(l-o)>5?[o,l]:null,e.pointerType!=="mouse"&&this.seek(this.valueAt(r)),
this.cursor(this.shared.clock.time)};V(this.body,e,a,(r,l)=>{let c=this.valueAt(r),{picked:u}=this;this.picked=null,u&&l?this.zoomTo(n<c?[n,c]:[c,n]):u?this.cursor(
this.shared.clock.time):l&&!i&&this.seek(e.pointerType==="mouse"?n:c)})}seek(e){if(this.shared.axis==="time")return this.onseek(e);let t=this.films[this.active],
o=this.abscissa(t),n=0;for(let i=0;i<o.length;i++)Math.abs(o[i]-e)<Math.abs(o[n]-e)&&(n=i);return this.onseek(t.t[n])}middle(){return .5*(this.range[0]+this.range[1])}zoomAbout(e,t){
let o=this.fullRange(),n=Math.max(e-(e-this.range[0])*t,o[0]),i=Math.min(e+(this.range[1]-e)*t,o[1]);this.zoomTo(n<=o[0]&&i>=o[1]?null:[n,i])}zoomTo(e){this.shared.
range=e&&e[1]-e[0]>1e-9?e:null,this.shared.changed()}};var zo=s=>Object.entries(B).map(([e,t])=>p("option",{value:e},s(t)));function sa(s){let e="height",t=new st({key:"own",title:"Your choice",unit:"",curves:i=>[{name:x(
B[e].name),values:B[e].values(i)}]},s),o=()=>{let{symbol:i,unit:a}=B[e];t.unit=a?`${i} [${a}]`:i},n=p("select",{"aria-label":"What your diagram shows",onchange:()=>{
e=n.value,o(),s.changed()}},zo(Ti));return n.value=e,o(),t.element.querySelector("h3")?.after(n),t}function Ph(s){return[{key:"velocities",title:"Velocities",unit:"velocity [m/s]",curves:e=>[{name:"v (centre)",color:s.center_speed,values:e.columns.vx},{name:"\
R θ̇",color:s.rotation_speed,dash:"dash",values:e.derived("spin",({omega:t})=>Float64Array.from(t,o=>o*e.radius))}]},{key:"energies",title:"Energies and losse\
s",unit:"energy [J]",curves:e=>[{name:"kinetic",color:s.kinetic,values:e.columns.kinetic},{name:"potential",color:s.potential,values:e.columns.potential},{name:"\
total",values:e.derived("total",({t,kinetic:o,potential:n})=>Float64Array.from(t,(i,a)=>o[a]+n[a])),dash:"dash"},{name:"lost to friction",color:s.friction_loss,
values:e.columns.friction_loss},{name:e.scenario.contact.model==="compliant"?"lost in the damper":"lost in impacts, normal part",color:s.impact_loss,values:e.columns.
normal_loss,dash:"dot"},...e.scenario.plane.rolling_resistance?[{name:"lost to rolling resistance",values:e.columns.rolling_resistance,dash:"dot"}]:[]]},{key:"f\
orces",title:"Contact forces",unit:"force [N]",curves:e=>[{name:"normal N",color:s.normal_force,values:e.columns.normal_force},{name:"friction F",color:s.friction_force,
dash:"dash",values:e.columns.friction_force}]},{key:"utilization",title:"Use of friction",unit:"|F| / μN",limits:[0,1.08],curves:e=>[{name:"|F| / μN",color:s.
friction_force,values:e.columns.utilization}]}]}var Ms=class{films;active;look;constructor(e,t){this.colors=t,this.shared={axis:"time",range:null,clock:e,changed:()=>this.
redraw()},this.plots=[...Ph(t).map(n=>new st(n,this.shared)),sa(this.shared)];for(let n of this.plots)n.onseek=i=>e.seek(i);this.seen=new Map(this.plots.map(n=>[
n.element,!0]));let o=new IntersectionObserver(n=>{for(let{target:i,isIntersecting:a}of n)this.seen.set(i,a);this.redraw()},{rootMargin:"400px"});for(let n of this.
plots)o.observe(n.element);this.axis=p("select",{"aria-label":"Horizontal axis of the diagrams",onchange:()=>{this.shared.axis=this.axis.value,this.shared.range=
null,this.redraw()}},zo(({name:n})=>`over ${n}`)),this.back=p("button",{type:"button",hidden:!0,onclick:()=>this.plots[0].zoomTo(null)},"Whole motion"),this.hint=
p("span",{class:"hint"}),this.element=p("div",{class:"plots"},p("div",{class:"plots-head"},this.axis,this.back,this.hint),this.plots.map(n=>n.element))}draw(e,t,o){
this.films=e,this.active=t,this.look=o;let n=matchMedia("(hover: none)").matches?"slide to go there, two fingers zoom":`click to go there, drag to zoom; ${tt("")}`,
i=e.length>1;z(this.hint,i?`A blue, B ochre; the dashes tell the quantities; numbers of ${"AB"[t]}; ${n}`:n),this.redraw()}redraw(){if(this.films?.length){this.
back.hidden=!this.shared.range;for(let e of this.visible())e.draw(this.films,this.active,this.look,this.colors);this.cursor(this.shared.clock.time)}}visible(){return this.
plots.filter(e=>this.seen.get(e.element))}cursor(e){for(let t of this.visible())t.cursor(e)}};var ra=Qr(aa(),1);var zh=3840;async function la(s){let{width:e,height:t}=s.stage.canvas().getBoundingClientRect(),o=Math.max(zh/e,globalThis.devicePixelRatio||1),n=p("canvas",{width:Math.
round(e*o),height:Math.round(t*o)}),i=fe(n);return i.setTransform(o,0,0,o,0,0),Lo(i,s,e,t),s.stage.options.three?(i.drawImage(s.stage.sharp(s,o),0,0,e,t),s.drawStage()):
ua(i,s,e,t),No(i,s,t),new Promise((a,r)=>n.toBlob(l=>l?a(l):r(new Error("The picture is too large for this browser."))))}function ha(s){if(s.stage.options.three)
throw new Error("A picture in space has no lines to keep: take the PNG, or leave 3D.");let{width:e,height:t}=s.stage.canvas().getBoundingClientRect(),o=new ra.Context(
{width:e,height:t,document});return Lo(o,s,e,t),ua(o,s,e,t),No(o,s,t),new Blob([o.getSerializedSvg()],{type:"image/svg+xml"})}function ca(s,e){let t=s.stage.canvas(),
{width:o,height:n}=t.getBoundingClientRect(),i=fe(e);i.setTransform(e.width/o,0,0,e.height/n,0,0),Lo(i,s,o,n),i.drawImage(t,0,0,o,n),No(i,s,n)}function Lo(s,{theme:e},t,o){
s.fillStyle=e.look.paper,s.fillRect(0,0,t,o)}function ua(s,e,t,o){let{stage:n,clock:i,theme:a}=e;n.flat.paint(s,t,o,e.films(),i.time,n.options,a.look,a.inks)}function No(s,e,t){
let{theme:o,stage:n,clock:i}=e,a=e.films();s.textBaseline="top",s.textAlign="left";for(let[r,l]of a.entries()){let c=l.at(i.time),u=a.length>1?`${"AB"[r]}: `:"",
h=x(o.colors.mode_names[c.mode]),d=`t = ${c.t.toFixed(3)} s, θ = ${$(c.angle)}, v = ${T(c.vx,3)} m/s`,m=n.options.three?10+20*r:10+r*t/a.length;s.fillStyle=o.colors.
modes[c.mode],s.fillRect(12,m+2,11,11),s.fillStyle=o.look.ink,s.font=`13px ${o.look.font}`,s.fillText(`${u}${h}, ${d}`,30,m)}s.textBaseline="alphabetic"}async function da(s){let e=s.stage.canvas();if(!e.captureStream||!globalThis.MediaRecorder)throw new Error("This browser cannot record a canvas; take the MP4 in\
stead.");let t=p("canvas",{width:2*Math.ceil(e.width/2),height:2*Math.ceil(e.height/2)}),o=new MediaRecorder(t.captureStream(60),{videoBitsPerSecond:8e6}),n=[];
o.ondataavailable=r=>n.push(r.data);let i=new Promise(r=>o.onstop=r),{loop:a}=s.clock;return s.clock.loop=!1,s.clock.seek(0),s.notice.say("Recording one run …"),
s.afterFrame=()=>{ca(s,t),!s.clock.playing&&o.state==="recording"&&o.stop()},o.start(),s.clock.play(!0),await i,s.afterFrame=null,s.clock.loop=a,new Blob(n,{type:o.
mimeType})}var Ih=[["motion.toml","Scenario (TOML)"],["motion.csv","States (CSV)"],["motion.nc","Motion (netCDF)"],["motion.json","Events (JSON)"],["motion.mp4","Film (MP4\
)"]],As=class{constructor(e){this.lab=e,this.menu=p("details",{class:"menu"},p("summary",{class:"button"},"Keep"),p("div",{class:"menu-body"},e.backend.shares&&
this.item("Copy the link",()=>this.copyLink()),Ih.filter(([t])=>e.backend.files?.includes(t)??!0).map(([t,o])=>this.item(o,()=>this.download(t))),this.item("Pic\
ture (PNG)",()=>this.picture("png",la)),this.item("Picture (SVG)",()=>this.picture("svg",ha)),this.item("Record a film here (WebM)",()=>this.record()),this.item(
"Show me the Python",()=>this.code()))),this.dialog=p("dialog",{class:"code-dialog","aria-label":"The same motion in Python"}),e.root.addEventListener("pointerd\
own",t=>{this.menu.contains(t.target)||(this.menu.open=!1)})}item(e,t){return p("button",{type:"button",onclick:async()=>{this.menu.open=!1;try{await t()}catch(o){
this.lab.notice.fail(o)}}},e)}async copyLink(){let e=this.lab.link()??"";try{await navigator.clipboard.writeText(e),this.lab.notice.say("The link is copied.")}catch{
this.show("The link to this motion",e)}}async download(e){let t=this.lab.film();this.lab.notice.say(e.endsWith("mp4")?"The film is being made; this takes a whil\
e …":`Fetching ${e} …`),Qe(await this.lab.backend.file(e,t.query),`hophoop-${e}`),this.lab.notice.say(`${e} is there.`)}async picture(e,t){Qe(await t(this.lab),
`hophoop.${e}`)}async record(){Qe(await da(this.lab),"hophoop.webm"),this.lab.notice.say("The film is there.")}async code(){let{header:e}=await this.lab.backend.
call("code",{scenario:this.lab.film().scenario});this.show("The same motion in Python",e.python,"The scenario as a file",e.toml)}show(...e){let t=[];for(let o=0;o<
e.length;o+=2){let n=e[o+1],i=p("button",{type:"button"},"Copy");i.onclick=async()=>{await navigator.clipboard?.writeText(n).catch(()=>{}),z(i,"Copied")},t.push(
p("header",{},p("h2",{},e[o]),i),p("pre",{tabindex:"0"},p("code",{},document.createTextNode(n))))}this.dialog.replaceChildren(...t,p("button",{type:"button",class:"\
close",onclick:()=>this.dialog.close()},"Close")),this.dialog.showModal()}};var pa=120,Rs=class{top=0;constructor(e,t,o,n,i,a,r,l,c,u,h){this.context=e,this.width=t,this.height=o,this.film=n,this.options=a,this.look=r,this.colors=l,this.
common=h,this.pose=n.at(i);let d=n.radius,{left:m,right:g}=n.extent,{top:f}=h;this.cosine=Math.cos(n.slope),this.sine=Math.sin(n.slope);let w=2*h.radius+Math.min(
f,6*h.radius),b=Math.min(.66*o/w,.36*t/h.radius);if(a.whole){let y=(g-m)*this.cosine+2.6*d,v=(g-m)*Math.abs(this.sine)+2.6*d+f;this.scale=Math.min(t/y,.86*o/v,b)*
c,this.focus=[.5*(m+g),0],this.place=[.5*t+u[0],(n.slope?.62:.8)*o+u[1]]}else this.scale=b*c,this.focus=[Number.isFinite(this.pose.x)?this.pose.x:0,0],this.place=
[(t<520?.6:.46)*t+u[0],.82*o+u[1]]}point(e,t){let o=e-this.focus[0],n=t-this.focus[1];return[this.place[0]+this.scale*(o*this.cosine+n*this.sine),this.place[1]-
this.scale*(n*this.cosine-o*this.sine)]}unpoint(e,t){let o=(e-this.place[0])/this.scale,n=-(t-this.place[1])/this.scale;return[this.focus[0]+o*this.cosine-n*this.
sine,this.focus[1]+o*this.sine+n*this.cosine]}draw(){this.ground(),(this.options.traces||this.options.ahead)&&this.traces(),this.hoop(),this.options.forces&&this.
forces()}ground(){let{context:e,look:t,width:o,height:n}=this,i=(Math.hypot(o,n)*1.2+Math.abs(this.place[0])+Math.abs(this.place[1]))/this.scale,[a,r]=this.point(
this.focus[0]-i,0),[l,c]=this.point(this.focus[0]+i,0),u=[-this.sine*4e3,this.cosine*4e3];e.fillStyle=t.ground,e.beginPath(),e.moveTo(a,r),e.lineTo(l,c),e.lineTo(
l+u[0],c+u[1]),e.lineTo(a+u[0],r+u[1]),e.fill(),e.strokeStyle=t.soft,e.lineWidth=1.5,e.beginPath(),e.moveTo(a,r),e.lineTo(l,c),e.stroke();let h=K(o/this.scale,o/
90);e.fillStyle=t.soft,e.font=`11px ${t.font}`,e.textAlign="center",e.lineWidth=1;let d=Math.ceil((this.focus[0]-i)/h),m=Math.min(Math.floor((this.focus[0]+i)/h),
d+400);for(let g=d;g<=m;g++){let[f,w]=this.point(g*h,0);f<-40||f>o+40||(e.beginPath(),e.moveTo(f,w),e.lineTo(f-6*this.sine,w+6*this.cosine),e.stroke(),e.fillText(
`${oe(g*h,h)} m`,f-18*this.sine,w+8+10*this.cosine))}}traces(){let{film:e,context:t,look:o,colors:n}=this,i=e.radius,a=this.options.ahead?e.duration:this.pose.t,
r=(l,c,u,h)=>{t.strokeStyle=c,t.lineWidth=u,t.lineJoin="round",t.beginPath();let d=!1,m=(g,f,w)=>{let[b,y]=this.point(g+l*Math.sin(w),i+f+l*Math.cos(w));d?t.lineTo(
b,y):t.moveTo(b,y),d=!0};for(let g of e.pieces()){let{x:f,height:w,angle:b,mode:y}=g.film.columns;for(let v=g.from;v<g.to&&g.film.t[v]<=a;v++)h===void 0||y[v]===
3===h?m(f[v],w[v],b[v]):d=!1}!this.options.ahead&&(h===void 0||this.pose.mode==="H"===h)&&m(this.pose.x,this.pose.height,this.pose.angle),t.stroke()};t.globalAlpha=
this.options.ahead?.45:1,r(i,o.ink,1.3),r(e.eccentricity*i,n.gravity_center,1.8,!1),r(e.eccentricity*i,n.airborne,2.4,!0),t.globalAlpha=1}mark(e,t){let{context:o,
film:n,pose:i,scale:a}=this,[r,l]=this.point(i.x,n.radius+i.height);o.strokeStyle=t,o.lineWidth=3,o.beginPath(),o.arc(r,l,Math.max(n.radius*a-k(.07*n.radius*a,2,
14)-3,2),0,2*Math.PI),o.stroke(),o.fillStyle=t,o.font=`700 17px ${this.look.font}`,o.textAlign="center",o.fillText(e,r-14,l+20)}hoop(){let{film:e,pose:t,context:o,
look:n,colors:i,scale:a}=this,r=e.radius,l=k(.07*r*a,2,14),c=r-.5*l/a,u=[t.x,r+t.height],h=(w,b=c)=>this.point(u[0]+b*Math.sin(w),u[1]+b*Math.cos(w));if(o.lineCap=
"butt",n.dark&&(o.strokeStyle=n.soft,o.lineWidth=l+2,o.beginPath(),o.arc(...this.point(u[0],u[1]),c*a,0,2*Math.PI),o.stroke()),this.options.speed){let w=this.common.
speed;o.lineWidth=l;let b=2*Math.PI/pa;for(let y=0;y<pa;y++){let v=t.angle+y*b,S=Math.hypot(t.vx+r*t.omega*Math.cos(v+.5*b),t.vy-r*t.omega*Math.sin(v+.5*b));o.strokeStyle=
Ut[k(Math.round(255*S/w)||0,0,255)],o.beginPath(),o.moveTo(...h(v-.04*b)),o.lineTo(...h(v+1.04*b)),o.stroke()}}else o.strokeStyle=i.modes[t.mode],o.lineWidth=l,
o.beginPath(),o.arc(...this.point(u[0],u[1]),c*a,0,2*Math.PI),o.stroke();o.strokeStyle=n.soft,o.lineWidth=1,o.beginPath(),o.moveTo(...this.point(u[0],u[1])),o.lineTo(
...h(t.angle)),o.stroke();let d=(w,b,y,v)=>{o.beginPath(),o.arc(...w,b,0,2*Math.PI),o.fillStyle=y,o.fill(),o.lineWidth=1.5,o.strokeStyle=v,o.stroke()};d(this.point(
u[0],u[1]),2.5,n.soft,n.soft);let m=e.scenario.hoop.parts;m?this.parts(m,u):d(h(t.angle),k(.1*r*a,4,16),n.ink,n.paper);let g=e.eccentricity*r,f=this.point(u[0]+
g*Math.sin(t.angle),u[1]+g*Math.cos(t.angle));d(f,k(.05*r*a,3.5,7),t.mode==="H"?i.airborne:i.gravity_center,n.paper)}parts(e,t){let{film:o,pose:n,context:i,look:a,
scale:r}=this,c=e.reduce((u,h)=>u+h.mass*(h.at??0),0)<0?-1:1;i.strokeStyle=a.ink;for(let u of e){let h=c*(u.at??0),d=this.point(t[0]+h*Math.sin(n.angle),t[1]+h*
Math.cos(n.angle));if(i.fillStyle=a.ink,i.lineWidth=1,i.beginPath(),u.shape==="ring")i.globalAlpha=.22,i.arc(...d,u.outer_radius*r,0,2*Math.PI),i.arc(...d,u.inner_radius*
r,0,2*Math.PI,!0),i.fill(),i.globalAlpha=1;else if(u.shape==="rod"){let m=.5*u.length,g=f=>this.point(t[0]+f*Math.sin(n.angle),t[1]+f*Math.cos(n.angle));i.lineWidth=
4,i.moveTo(...g(h-m)),i.lineTo(...g(h+m)),i.stroke()}else{let m=u.shape==="disk"?u.radius*r:k(.08*o.radius*r,3,12);i.globalAlpha=u.shape==="disk"?.55:1,i.arc(...d,
m,0,2*Math.PI),i.fill(),i.globalAlpha=1}}}forces(){let{film:e,pose:t,colors:o}=this,n=e.radius,i=e.mass*(e.gravity||9.81),a=l=>.55*n*l/i;if(t.mode==="H"||!(t.normal_force>
0))return;let r=[t.x,t.height];this.arrow(r,[0,a(t.normal_force)],o.normal_force,`N = ${T(t.normal_force,3)} N`,!1),this.arrow(r,[a(t.friction_force),0],o.friction_force,
`F = ${T(t.friction_force,3)} N`,!0)}arrow([e,t],[o,n],i,a,r){let{context:l,look:c,width:u}=this,h=2.2*this.film.radius,d=Math.abs(o)>h||Math.abs(n)>h;[o,n]=[k(
o,-h,h),k(n,-h,h)];let m=this.point(e,t),g=this.point(e+o,t+n),f=Math.hypot(g[0]-m[0],g[1]-m[1]);if(f<2)return;let w=(g[0]-m[0])/f,b=(g[1]-m[1])/f,y=Math.min(11,
f);for(let[R,M]of[[c.paper,6],[i,3]])l.strokeStyle=R,l.fillStyle=R,l.lineWidth=M,l.beginPath(),l.moveTo(...m),l.lineTo(g[0]-w*y,g[1]-b*y),l.stroke();if(l.beginPath(),
l.moveTo(...g),l.lineTo(g[0]-w*y-b*y*.5,g[1]-b*y+w*y*.5),l.lineTo(g[0]-w*y+b*y*.5,g[1]-b*y-w*y*.5),l.fill(),d){let[R,M]=[m[0]+.55*w*f,m[1]+.55*b*f];l.strokeStyle=
c.paper,l.lineWidth=2,l.beginPath();for(let E of[-3,3])l.moveTo(R+w*(E-3)-b*7,M+b*(E-3)+w*7),l.lineTo(R+w*(E+3)+b*7,M+b*(E+3)-w*7);l.stroke()}l.font=`600 12px ${c.
font}`;let v=l.measureText(a).width;l.lineWidth=3,l.strokeStyle=r?c.ground:c.paper,l.textAlign="left";let S=r?[m[0]-.5*v-32*this.sine,m[1]+32*this.cosine]:[g[0]+
12,k(g[1]+4,16,m[1]-.36*this.film.radius*this.scale)];S[0]=k(S[0],4,u-v-4),l.strokeText(a,S[0],S[1]),l.fillText(a,S[0],S[1])}};var Ps=class{constructor(e,t){this.canvas=e,this.onview=t,this.zoom=1,this.shift=[0,0],this.views=[],this.fixed=null,this.grab=()=>!1,e.addEventListener("pointe\
rdown",o=>this.drag(o)),this.pinched=ne(e,{zoom:o=>this.zoomBy(o),home:()=>this.reset(),chosen:()=>e.parentElement})}reset(){this.zoom=1,this.shift=[0,0],this.onview()}pan(){
let{width:e,height:t}=this.canvas.getBoundingClientRect();return[this.shift[0]/(e||1),this.shift[1]/(t||1)]}look(e=1,[t,o]=[0,0]){let{width:n,height:i}=this.canvas.
getBoundingClientRect();this.zoom=e,this.shift=[t*n,o*i]}zoomBy(e){this.zoom=k(this.zoom*e,.05,60),this.onview()}drag(e){if(this.grab(e))return;let t=[e.clientX,
e.clientY],o=this.shift;V(this.canvas,e,n=>{this.pinched()||(this.shift=[o[0]+n.clientX-t[0],o[1]+n.clientY-t[1]],this.onview())})}draw(e,t,o,n,i){let{context:a,
width:r,height:l}=U(this.canvas);a.clearRect(0,0,r,l),!(r<40||l<40)&&(this.views=this.paint(a,r,l,e,t,o,n,i))}paint(e,t,o,n,i,a,r,l){let c=o/n.length,u={top:Math.
max(...n.map(h=>h.extent.top)),radius:Math.max(...n.map(h=>h.radius)),speed:Math.max(...n.map(h=>h.extent.speed))};return n.map((h,d)=>{e.save(),e.beginPath(),e.
rect(0,d*c,t,c),e.clip(),e.translate(0,d*c);let m=new Rs(e,t,c,h,i,a,r,l,this.zoom,this.shift,u);return m.top=d*c,m.scale=this.fixed??m.scale,m.draw(),n.length>
1&&(m.mark("AB"[d],ue(d,r.dark)),e.fillStyle=ue(d,r.dark),e.font=`700 17px ${r.font}`,e.textAlign="left",e.fillText("AB"[d],12,c-12)),e.restore(),d>0&&(e.fillStyle=
r.line,e.fillRect(0,d*c-.5,t,1)),m})}};function Oo(s,e){let t=new Float32Array(16);for(let o=0;o<4;o++)for(let n=0;n<4;n++){let i=0;for(let a=0;a<4;a++)i+=s[4*a+n]*e[4*o+a];t[4*o+n]=i}return t}function ma(s,e,t,o){
let n=1/Math.tan(s/2),i=1/(t-o);return new Float32Array([n/e,0,0,0,0,n,0,0,0,0,(o+t)*i,-1,0,0,2*o*t*i,0])}function fa(s,e){let t=De(qo(s,e)),o=De(zs([0,1,0],t)),
n=zs(t,o);return new Float32Array([o[0],n[0],t[0],0,o[1],n[1],t[1],0,o[2],n[2],t[2],0,-Co(o,s),-Co(n,s),-Co(t,s),1])}var qo=(s,e)=>[s[0]-e[0],s[1]-e[1],s[2]-e[2]],
Co=(s,e)=>s[0]*e[0]+s[1]*e[1]+s[2]*e[2],zs=(s,e)=>[s[1]*e[2]-s[2]*e[1],s[2]*e[0]-s[0]*e[2],s[0]*e[1]-s[1]*e[0]];function De(s){let e=Math.hypot(...s)||1;return[
s[0]/e,s[1]/e,s[2]/e]}function Is(s,e,t,o){let n=De(e),i=De(zs(n,Math.abs(n[2])>.9?[1,0,0]:[0,0,1])),a=zs(i,n);return new Float32Array([...i.map(r=>r*o),0,...n.
map(r=>r*t),0,...a.map(r=>r*o),0,...s,1])}function jo(s){let[e,t]=[Math.cos(s),Math.sin(s)];return new Float32Array([e,-t,0,0,t,e,0,0,0,0,1,0,0,0,0,1])}function le(s){let e=Number.parseInt(s.slice(1,7),
16);return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}function ot(s,e,t){let o=s.createProgram(),n=[[s.VERTEX_SHADER,e],[s.FRAGMENT_SHADER,t]];for(let[a,r]of n){let l=s.createShader(a);if(s.shaderSource(l,r),s.compileShader(
l),!s.getShaderParameter(l,s.COMPILE_STATUS))throw new Error(String(s.getShaderInfoLog(l)));s.attachShader(o,l)}if(s.linkProgram(o),!s.getProgramParameter(o,s.LINK_STATUS))
throw new Error(String(s.getProgramInfoLog(o)));let i={program:o,uniforms:{},attributes:{}};for(let a=0;a<s.getProgramParameter(o,s.ACTIVE_UNIFORMS);a++){let{name:r}=s.
getActiveUniform(o,a);i.uniforms[r]=s.getUniformLocation(o,r)}for(let a=0;a<s.getProgramParameter(o,s.ACTIVE_ATTRIBUTES);a++){let{name:r}=s.getActiveAttrib(o,a);
i.attributes[r]=s.getAttribLocation(o,r)}return i}function Fe(s,e,t,o){let n=s.createBuffer();s.bindBuffer(s.ARRAY_BUFFER,n),s.bufferData(s.ARRAY_BUFFER,new Float32Array(
e),s.STATIC_DRAW);let i=o?s.createBuffer():null;o&&(s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,i),s.bufferData(s.ELEMENT_ARRAY_BUFFER,new Uint16Array(o),s.STATIC_DRAW));
let a=4*Object.values(t).reduce((r,l)=>r+l,0);return{vertices:n,elements:i,parts:t,stride:a,count:o?o.length:4*e.length/a}}function nt(s,e,t){s.bindBuffer(s.ARRAY_BUFFER,
t.vertices);let o=0;for(let[n,i]of Object.entries(t.parts)){let a=e.attributes[n];a!==void 0&&(s.enableVertexAttribArray(a),s.vertexAttribPointer(a,i,s.FLOAT,!1,
t.stride,o)),o+=4*i}t.elements&&s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,t.elements)}function Do(s,e){let t=[];for(let o=0;o<s;o++)for(let n=0;n<e;n++){let i=o*(e+1)+
n,a=i+e+1;t.push(i,a,i+1,a,a+1,i+1)}return t}function ga(s,e=120,t=14){let o=[];for(let n=0;n<=e;n++)for(let i=0;i<=t;i++)o.push(2*Math.PI*n/e,2*Math.PI*i/t);return Fe(
s,o,{bend:2},Do(e,t))}function wa(s,e=28,t=18){let o=[];for(let n=0;n<=e;n++)for(let i=0;i<=t;i++){let[a,r]=[2*Math.PI*n/e,Math.PI*i/t],l=[Math.sin(r)*Math.cos(
a),Math.cos(r),Math.sin(r)*Math.sin(a)];o.push(...l,...l)}return Fe(s,o,{position:3,normal:3},Do(e,t))}function Fo(s,e,t=20){let o=[];for(let n=0;n<=t;n++){let i=2*
Math.PI*n/t,a=[Math.cos(i),1-e,Math.sin(i)];o.push(Math.cos(i),0,Math.sin(i),...a,e*Math.cos(i),1,e*Math.sin(i),...a)}return Fe(s,o,{position:3,normal:3},Do(t,1))}var ka=`
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`,_a=`
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`,xa="vec4(0.0, 0.0, 0.0, shadow)",ba=[`attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${_a}
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
   ${ka}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${xa} : vec4(shaded(color, n), 1.0);
   }`],ya=[`attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${_a}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,`precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow, lit;
   ${ka}
   void main() { gl_FragColor = shadow > 0.0 ? ${xa} : vec4(lit > 0.5 ? shaded(color, n) : color, 1.0); }`],va=[`attribute vec3 position, next, tint; attribute \
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
   }`,"precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }"],Ls=class{constructor(e,t,o,n,{keep:i=!1}={}){let a=e.getContext(
"webgl",{antialias:!0,stencil:!0,preserveDrawingBuffer:i});if(!a)throw new Error("This browser draws nothing in space (WebGL is missing).");this.gl=a,this.canvas=
e,this.sun=De(o),this.dark=n,this.slant=[o[0]/o[1],1,o[2]/o[1]],this.rim=ot(a,ba[0],ba[1]),this.body=ot(a,ya[0],ya[1]),this.line=ot(a,va[0],va[1]),this.torus=ga(
a),this.sphere=wa(a),this.cylinder=Fo(a,1),this.cone=Fo(a,0),this.colors=a.createTexture(),a.bindTexture(a.TEXTURE_2D,this.colors);let r=new Uint8Array(t.flatMap(
l=>[...l,255]));a.pixelStorei(a.UNPACK_ALIGNMENT,1),a.texImage2D(a.TEXTURE_2D,0,a.RGBA,t.length,1,0,a.RGBA,a.UNSIGNED_BYTE,r);for(let l of[a.TEXTURE_WRAP_S,a.TEXTURE_WRAP_T])
a.texParameteri(a.TEXTURE_2D,l,a.CLAMP_TO_EDGE);for(let l of[a.TEXTURE_MIN_FILTER,a.TEXTURE_MAG_FILTER])a.texParameteri(a.TEXTURE_2D,l,a.LINEAR);this.view=jo(0),
this.eye=[0,0,1],this.fastest=1}begin({background:e,eye:t,target:o,slope:n,angle:i,near:a,far:r}){let{gl:l,canvas:c}=this;l.viewport(0,0,c.width,c.height),l.clearColor(
e[0],e[1],e[2],1),l.clear(l.COLOR_BUFFER_BIT|l.DEPTH_BUFFER_BIT|l.STENCIL_BUFFER_BIT),l.enable(l.DEPTH_TEST);let u=ma(i,c.width/c.height,a,r);this.view=Oo(Oo(u,
fa(t,o)),jo(n)),this.eye=De(qo(t,o))}use(e,t){let{gl:o}=this;o.useProgram(e.program);let n={view:this.view,sun:this.sun,eye:this.eye,slant:this.slant,...t};for(let[
i,a]of Object.entries(n)){let r=e.uniforms[i];r!==void 0&&(typeof a=="number"?o.uniform1f(r,a):a.length===16?o.uniformMatrix4fv(r,!1,a):o[`uniform${a.length}fv`](
r,a))}}ground(e){let{gl:t}=this;t.depthFunc(t.ALWAYS),e(),t.depthFunc(t.LESS)}shadows(e){let{gl:t}=this;t.enable(t.BLEND),t.blendFuncSeparate(t.SRC_ALPHA,t.ONE_MINUS_SRC_ALPHA,
t.ZERO,t.ONE),t.enable(t.STENCIL_TEST),t.stencilFunc(t.EQUAL,0,255),t.stencilOp(t.KEEP,t.KEEP,t.INCR),t.depthFunc(t.ALWAYS),t.depthMask(!1),e(),t.depthMask(!0),
t.depthFunc(t.LESS),t.disable(t.STENCIL_TEST),t.disable(t.BLEND)}solid(e,t,o,{shadow:n=!1,lit:i=!0}={}){let{gl:a}=this;this.use(this.body,{model:t,color:o,shadow:n?
this.dark:0,lit:Number(i)}),nt(a,this.body,e),a.drawElements(a.TRIANGLES,e.count,a.UNSIGNED_SHORT,0)}ball(e,t,o,n){this.solid(this.sphere,Is(e,[0,1,0],t,t),o,{shadow:n})}ring({
center:e,radius:t,tube:o,broad:n,angle:i,velocity:a,omega:r,plain:l=null},c){let{gl:u}=this;this.use(this.rim,{center:e,size:[t,o,n,i],motion:[...a,r],most:this.
fastest,shadow:c?this.dark:0,plain:l??[0,0,0],colored:l?0:1}),nt(u,this.rim,this.torus),u.drawElements(u.TRIANGLES,this.torus.count,u.UNSIGNED_SHORT,0)}rod(e,t,o,n,i,a=!1){
this.solid(this.cylinder,Is(e,t,o,n),i,{shadow:a})}arrow(e,t,o,n,i){if(!(o>.02*n))return;let a=Math.min(.18*n,o),r=e.map((l,c)=>l+t[c]*(o-a));o>a&&this.rod(e,t,
o-a,.029*n,i),this.solid(this.cone,Is(r,t,a,Math.min(.075*n,.6*a)),i)}trace(e,t,o){let n=[];for(let i=0;i<e;i++){let a=t(i),r=t(Math.min(i+1,e-1));if(Math.hypot(
r[0]-a[0],r[1]-a[1])<1e-9&&i>0){let l=t(i-1);r=a.map((c,u)=>2*c-l[u])}for(let l of[-1,1])n.push(...a,0,...r,0,...o(i),l)}return Fe(this.gl,n,{position:3,next:3,
tint:3,side:1})}drawTrace(e,t,{width:o,distance:n=0,shift:i,depth:a}){let{gl:r,canvas:l}=this;this.use(this.line,{pixel:[2/l.width,2/l.height],width:o,distance:n,
shift:i,depth:a}),nt(r,this.line,e),r.drawArrays(r.TRIANGLE_STRIP,0,2*t)}onScreen([e,t,o]){let n=this.view,[i,a,r]=[0,1,3].map(l=>n[l]*e+n[4+l]*t+n[8+l]*o+n[12+
l]);return r>0?[(.5+.5*i/r)*this.canvas.width,(.5-.5*a/r)*this.canvas.height]:null}};var Lh=[.35,.85,.4],Nh=.18,Mt={azimuth:.5,height:.22,distance:5.2},Ta=[`attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,`precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`],Ns=class{constructor(e,t){this.canvas=e,this.onview=t,this.space=new Ls(e,Ve,Lh,Nh,{keep:!0}),this.floor=ot(this.space.gl,Ta[0],Ta[1]),this.corners=Fe(this.
space.gl,[-1,-1,1,-1,-1,1,1,1],{corner:2}),this.turned={...Mt},this.lines=new WeakMap,this.share=1,this.pace=16,this.before=0,this.focus=0,this.reach=1,e.addEventListener(
"pointerdown",o=>this.drag(o)),this.pinched=ne(e,{zoom:o=>this.zoomBy(o),home:()=>this.zoomBy(0),chosen:()=>e.parentElement})}zoomBy(e){e?this.turned.distance=k(
this.turned.distance/e,1.6,60):this.turned={...Mt},this.onview()}from(){let{azimuth:e,height:t,distance:o}=this.turned;return e===Mt.azimuth&&t===Mt.height&&o===
Mt.distance?void 0:[e,t,o]}look([e,t,o]){this.turned={azimuth:k(e,-1.5,1.5),height:k(t,.02,1.45),distance:k(o,1.6,60)}}drag(e){let t={...this.turned,x:e.clientX,
y:e.clientY};V(this.canvas,e,o=>{this.pinched()||(this.turned.azimuth=k(t.azimuth-(o.clientX-t.x)*.008,-1.5,1.5),this.turned.height=k(t.height+(o.clientY-t.y)*.006,
.02,1.45),this.onview())})}quality(){let e=performance.now(),t=e-(this.before||e);return this.before=e,t>0&&t<200&&(this.pace=.9*this.pace+.1*t),this.pace>26&&this.
share>.5&&(this.share=Math.max(this.share-.1,.5),this.pace=16),this.share}draw(e,t,o,n,i,a,r){let{canvas:l,space:c}=this,u=r??Math.min(globalThis.devicePixelRatio||
1,2)*(a?this.quality():1),h=l.getBoundingClientRect();l.width=Math.max(Math.round(h.width*u),1),l.height=Math.max(Math.round(h.height*u),1);let d=e.map(f=>f.at(
t)),m=e[0].radius;c.fastest=Math.max(...e.map(f=>f.extent.speed)),this.focus=Number.isFinite(d[0].x)?d[0].x:0,c.begin({background:le(n.paper),...this.camera(e[0],
d[0],m,o)}),c.ground(()=>this.drawFloor(m,n));let g=f=>{for(let[w,b]of e.entries())f(b,d[w],-2.1*m*w)};c.shadows(()=>g((f,w,b)=>this.drawHoop(f,w,b,o,n,i,!0))),
g((f,w,b)=>{this.drawHoop(f,w,b,o,n,i,!1),o.traces&&this.drawTraces(f,w,b,n,i,u),o.forces&&this.drawForces(f,w,b,i)})}camera(e,t,o,n){let{azimuth:i,height:a,distance:r}=this.
turned,{left:l,right:c}=e.extent,u=n.whole?Math.max(r*o,.85*(c-l)+3*o):r*o,[h,d]=[n.whole?.5*(l+c)-this.focus:0,o+.45*(t.height||0)],m=Math.cos(e.slope),g=Math.
sin(e.slope),f=[h*m+d*g,-h*g+d*m,0],w=[f[0]+u*Math.sin(i)*Math.cos(a),f[1]+u*Math.sin(a),u*Math.cos(i)*Math.cos(a)];return this.reach=12*o+3*u,{eye:w,target:f,slope:e.
slope,angle:.75,near:.05*o,far:40*o+6*u}}drawFloor(e,t){let{space:o}=this,n=le(t.ground),i=n.map(l=>l*(t.dark?.82:.94)),a=.5*e,r=this.focus%(2*a);o.use(this.floor,
{reach:this.reach,light:n,dark:i,far:le(t.paper),tile:a,shift:r}),nt(o.gl,this.floor,this.corners),o.gl.drawArrays(o.gl.TRIANGLE_STRIP,0,4)}drawHoop(e,t,o,n,i,a,r){
let{space:l}=this,c=e.radius,u=.045*c,h=[t.x-this.focus,c+t.height,o];l.ring({center:h,radius:c,tube:u,broad:3.2*u,angle:t.angle,velocity:[t.vx,t.vy],omega:t.omega,
plain:n.speed?null:le(a.modes[t.mode])},r);let d=[Math.sin(t.angle),Math.cos(t.angle),0],m=f=>h.map((w,b)=>w+f*d[b]);l.ball(m(c-u),.125*c,i.dark?[.9,.91,.94]:[.12,
.13,.15],r),l.rod(h,d,c-u,.012*c,[.55,.57,.6],r);let g=t.mode==="H";l.ball(m(e.eccentricity*c),.07*c,le(g?a.airborne:a.gravity_center),r)}drawForces(e,t,o,n){if(t.
mode==="H"||!(t.normal_force>0))return;let i=e.radius,a=e.mass*(e.gravity||9.81),r=[t.x-this.focus,t.height+.03*i,o+.2*i],l=u=>k(.55*i*Math.abs(u)/a,0,3.2*i),c=Math.
sign(t.friction_force);this.space.arrow(r,[0,1,0],l(t.normal_force),i,le(n.normal_force)),this.space.arrow(r,[c,0,0],l(t.friction_force),i,le(n.friction_force))}linesOf(e,t,o){
let n=this.lines.get(e);if(n?.dark===t.dark)return n;let i=e.radius,{x:a,height:r,angle:l,mode:c}=e.columns,u=(f,w)=>this.space.trace(e.length,b=>[a[b]+f*Math.sin(
l[b]),i+r[b]+f*Math.cos(l[b])],w),[h,d,m]=[le(o.gravity_center),le(o.airborne),le(t.ink)],g={dark:t.dark,load:u(i,()=>m),center:u(e.eccentricity*i,f=>c[f]===3?d:
h)};return this.lines.set(e,g),g}drawTraces(e,t,o,n,i,a){let{load:r,center:l}=this.linesOf(e,n,i),c=Math.min(e.index(t.t)+2,e.length),u={shift:this.focus,depth:o};
this.space.drawTrace(r,c,{width:a,...u}),this.space.drawTrace(l,c,{width:1.6*a,...u})}};var Ch=["hoop","mode","time","angle","v","R θ̇","gap"],Cs=class{constructor(e,t){this.colors=e,this.onview=t,this.options={traces:!0,forces:!0,speed:!0,whole:!1,
three:!1,ahead:!1},this.plane=p("canvas",{class:"stage-canvas"}),this.space=p("canvas",{class:"stage-canvas",hidden:!0}),this.flat=new Ps(this.plane,t),this.deep=
null,this.outputs=Ch.map(n=>({name:p("dt",{},n),value:p("dd",{})})),this.outputs[1].value.className="mode",this.fastest=p("span",{}),this.legend=p("div",{class:"\
legend","aria-hidden":"true"},p("i",{style:`background: linear-gradient(90deg, ${Ut.filter((n,i)=>i%15===0).join(",")})`}),p("span",{},"0"),p("span",{},"rim spe\
ed"),this.fastest);let o=(n,i)=>p("span",{},p("i",{class:"dot",style:`background:${n}`}),i);this.order=p("span",{hidden:!0},"A in front, B behind"),this.element=
p("div",{class:"stage",role:"img","aria-label":"The hoop",tabindex:"0"},this.plane,this.space,p("dl",{class:"readout","aria-hidden":"true"},this.outputs.flatMap(
({name:n,value:i})=>[n,i])),this.legend,p("div",{class:"stage-keys","aria-hidden":"true"},o("var(--ink)","load"),o(e.gravity_center,"centre of gravity"),o(e.airborne,
"the same in flight"),this.order))}canvas(){return this.options.three?this.space:this.plane}draw(e,t,o,{look:n,inks:i}){let{options:a}=this;this.legend.hidden=!a.
speed,this.order.hidden=!(a.three&&e.length>1),this.fastest.textContent=`≥ ${T(Math.max(...e.map(r=>r.extent.speed)),2)} m/s`,a.three?(this.deep??=new Ns(this.
space,this.onview),this.deep.draw(e,o.time,a,n,i,o.playing)):this.flat.draw(e,o.time,a,n,i),this.read(e,t,o.time)}sharp(e,t){let{look:o,inks:n}=e.theme;return this.
deep?.draw(e.films(),e.clock.time,this.options,o,n,!1,t),this.space}read(e,t,o){let n=e[t],i=n.at(o),a=[e.length>1?"AB"[t]:"",x(this.colors.mode_names[i.mode]),
me(`${i.t.toFixed(3)} s`),$(i.angle),G(T(i.vx,3),"m/s"),G(T(i.omega*n.radius,3),"m/s"),i.height>0?Me(i.height):"0"];for(let[c,u]of a.entries()){let{value:h}=this.
outputs[c];h.textContent!==u&&(h.textContent=u)}let[r,l]=this.outputs;r.value.hidden=r.name.hidden=e.length<2,l.value.style.setProperty("--mode",this.colors.modes[i.
mode])}describe(e){let t=e.map(o=>o.summary).join(" ");this.element.setAttribute("aria-label",`${x("The hoop.")} ${t}`)}turn(e){let t=()=>{this.plane.hidden=this.
options.three,this.space.hidden=!this.options.three};this.options.three=!this.options.three,t();try{e()}catch(o){throw this.options.three=!1,t(),o}}view(){let{options:e,
flat:t,deep:o}=this;return{options:e,zoom:t.zoom,pan:t.pan(),from:o?.from()}}restore({options:e,zoom:t,pan:o,from:n}){if(e){let{three:i,...a}=e;Object.assign(this.
options,a)}this.flat.look(t,o),n&&this.deep?.look(n)}zoom(e){this.options.three?this.deep?.zoomBy(e):e?this.flat.zoomBy(e):this.flat.reset()}};var Os=class{film;items;current;constructor(e){this.clock=e,this.summary=p("p",{class:"summary"}),this.doubt=p("p",{class:"hint",hidden:!0}),this.list=p("ol",{class:"\
story-list"}),this.heading=p("h2",{},"What happens"),this.live=p("div",{class:"spoken",role:"status","aria-live":"polite"}),this.element=p("section",{class:"sto\
ry","aria-label":"The motion in words"},this.heading,this.summary,this.doubt,this.list,this.live)}draw(e,t,o){this.film=e[t],z(this.heading,e.length>1?`What hap\
pens to hoop ${"AB"[t]}`:"What happens"),this.summary.replaceChildren(...e.flatMap((n,i)=>[e.length>1?p("b",{},`${"AB"[i]}: `):"",n.summary,n.status==="event_li\
mit"||n.shortened?" (not all events are shown)":"",i+1<e.length?p("br"):""])),this.doubt.hidden=!this.film.doubt,z(this.doubt,this.film.doubt),this.items=this.film.
story.map(n=>p("li",{},p("button",{type:"button",onclick:()=>this.clock.seek(n.t)},p("i",{class:"dot",style:`background:${o.modes[n.mode]}`,"aria-hidden":"true"}),
p("span",{class:"when"},`${T(n.t,4)} s`),p("span",{},n.text)))),this.list.replaceChildren(...this.items),this.current=-1,this.cursor(this.clock.time)}say(e){z(this.
live,e)}announce(e){this.say(ae(e.map(t=>t.summary).join(" ")))}cursor(e){let{story:t}=this.film,o=-1;for(let i=0;i<t.length&&t[i].t<=e+1e-9;i++)o=i;if(o===this.
current)return;this.items[this.current]?.classList.remove("now"),this.items[o]?.classList.add("now"),this.items[this.current]?.removeAttribute("aria-current"),this.
items[o]?.setAttribute("aria-current","step"),this.current=o;let n=this.items[o];if(n){let i=n.offsetTop-this.list.offsetTop;(i<this.list.scrollTop||i+n.offsetHeight>
this.list.scrollTop+this.list.clientHeight)&&(this.list.scrollTop=i-.4*this.list.clientHeight)}}},qs=class{constructor(){this.list=p("dl",{}),this.heading=p("h2",
{},"What theory says"),this.element=p("section",{class:"theory"},this.heading,this.list)}draw(e,t=""){z(this.heading,t?`What theory says of hoop ${t}`:"What the\
ory says"),this.list.replaceChildren(...e.flatMap(({label:o,text:n})=>[p("dt",{},o),p("dd",{},n)]))}};var Sa="hophoop-theme",Oh=["gravity_center","airborne","normal_force","friction_force"],js=class{constructor(e,t,o,n){this.root=e,this.colors=t,this.hosted=o,this.
changed=n,this.chosen=null,this.media=matchMedia("(prefers-color-scheme: dark)"),this.listen=()=>this.apply(),this.media.addEventListener("change",this.listen),
this.mark(),this.look=co(e),this.inks={...t},this.read()}mark(){let e=this.hosted?de(Sa):null;this.root.dataset.theme=this.chosen??e??(this.media.matches?"dark":
"light"),this.hosted&&(document.documentElement.style.colorScheme=this.root.dataset.theme)}read(){this.look=co(this.root),this.inks={...this.colors};for(let e of Oh)
this.inks[e]=pt(this.colors[e],this.look.dark)}apply(){this.mark(),this.read(),this.changed()}toggle(){this.chosen=this.root.dataset.theme==="dark"?"light":"dar\
k",this.hosted&&pe(Sa,this.chosen),this.apply()}close(){this.media.removeEventListener("change",this.listen)}};var Ds={start:"start",slip_start:"slip begins",stick:"slip ends",slip_reversal:"slip turns round",takeoff:"take-off",impact:"landing",turn:"turns back",apex:"hi\
ghest point",bounce_limit:"bounces end",painleve_inconsistent:"Painlevé: no solution",painleve_indeterminate:"Painlevé: several solutions",jam:"jam",kane_gain:"\
energy gain (Kane)",skim:"skimming begins",rest:"at rest",end:"end"},Ma=s=>s.kind==="takeoff"||s.to==="H"&&s.from!=="H"&&s.kind!=="impact";var Et={jam:"✖",painleve_inconsistent:"◆",painleve_indeterminate:"◇",kane_gain:"✚",bounce_limit:"≋",skim:"◗",rest:"■",takeoff:"▲",impact:"▼",turn:"\
↺",apex:"•"},Fs=Object.keys(Et);function Ea(s,e=11){let o=[...s.filter(({kind:i})=>i in Et)].sort((i,a)=>Fs.indexOf(i.kind)-Fs.indexOf(a.kind)||i.x-a.x),n=[];
for(let{kind:i,x:a}of o){let r=Fs.indexOf(i)<Fs.indexOf("takeoff"),l=n.filter(c=>Math.abs(c.x-a)<e);l.length?l.length===1&&l[0].rare&&!n.some(c=>Math.abs(c.x-(l[0].
x+e))<e-1e-9)?l[0].mark!==Et[i]&&n.push({mark:Et[i],x:l[0].x+e,rare:!1,hidden:0}):l[0].hidden+=1:n.push({mark:Et[i],x:a,rare:r,hidden:0})}return n.sort((i,a)=>i.
x-a.x).map(({mark:i,x:a})=>({mark:i,x:a}))}function Aa(s,e,t){let o=[],n=new Map,i=-1,a=(l,c,u)=>{let h=o.at(-1);h&&h.mode===l&&Math.abs(h.from+h.wide-c)<1e-6?h.
wide+=u:o.push({mode:l,from:c,wide:u})},r=()=>{n.size&&a([...n].reduce((l,c)=>c[1]>l[1]?c:l)[0],i,1),n=new Map};for(let{mode:l,from:c,to:u}of s){let[h,d]=[Math.
max(e(c),0),Math.min(e(u),t)];if(d>h)for(let m=h;m<d-1e-9;){if((Math.floor(m+1e-9)!==i||!n.size)&&(r(),i=Math.floor(m+1e-9),d-m>=1&&Math.abs(m-i)<1e-6)){let f=Math.
floor(d-m+1e-9);a(l,i,f),m=i+f;continue}let g=Math.min(d,i+1);n.set(l,(n.get(l)??0)+g-m),m=g}}return r(),o}var Ws=class{films;said;constructor(e){this.clock=e,this.window=null,this.canvas=p("canvas",{class:"timeline-canvas"}),this.tip=p("div",{class:"tip",hidden:!0}),
this.element=p("div",{class:"timeline",role:"slider",tabindex:"0","aria-label":"Time","aria-valuemin":"0","aria-orientation":"horizontal"},this.canvas,this.tip),
this.element.addEventListener("pointerdown",t=>this.scrub(t)),this.element.addEventListener("pointermove",t=>this.hover(t)),this.element.addEventListener("point\
erleave",()=>this.tip.hidden=!0),this.pinched=ne(this.element,{zoom:(t,o)=>this.zoom(1/t,o?this.timeAt(o):this.clock.time),home:()=>this.zoom(1/0,0),keys:!0})}ends(){
let e=[0,this.clock.duration||1];return!this.window||this.window[1]-this.window[0]>=e[1]?e:je(this.window,e)}zoom(e,t){let[o,n]=this.ends(),i=1e-6*this.clock.duration,
a=Math.max((n-o)*e,i),r=(t-o)/(n-o);this.window=a<this.clock.duration?je([t-r*a,t+(1-r)*a],[0,this.clock.duration]):null,this.clock.changed()}keep(){if(!this.window)
return;let[e,t]=this.ends(),{time:o,duration:n}=this.clock;if(o>=e&&o<=t)return;let i=t-e;this.window=je(o>t?[o-.1*i,o+.9*i]:[o-.5*i,o+.5*i],[0,n])}timeAt(e){let t=this.
canvas.getBoundingClientRect(),[o,n]=this.ends();return o+k((e.clientX-t.left)/t.width,0,1)*(n-o)}scrub(e){e.preventDefault(),this.element.focus({preventScroll:!0});
let t=this.clock.playing;this.clock.playing=!1;let o=n=>!this.pinched()&&this.clock.seek(this.timeAt(n));o(e),V(this.element,e,o,()=>t&&this.clock.play(!0))}hover(e){
let t=this.timeAt(e),o=this.nearest(t,8),n=o?`${x(Ds[o.kind]??o.kind)} · ${T(o.t,5)} s · ${T(o.angle*180/Math.PI,4)}°`:`${T(t,4)} s`;this.tip.textContent=n,this.
tip.hidden=!1;let i=this.canvas.getBoundingClientRect();this.tip.style.left=`${k(e.clientX-i.left,70,i.width-70)}px`}nearest(e,t){let[o,n]=this.ends(),i=t*(n-o)/
(this.canvas.getBoundingClientRect().width||1),a=null;for(let r of this.films??[])for(let l of r.events){if(l.kind==="end")continue;let c=Math.abs(l.t-e);c<=i&&
(!a||c<Math.abs(a.t-e))&&(a=l)}return a}draw(e,t,o){this.films=e;let{context:n,width:i,height:a}=U(this.canvas);this.keep();let[r,l]=this.ends(),c=w=>(w-r)/(l-r)*
i;n.clearRect(0,0,i,a);let u=15,h=(a-15)/e.length-u;e.forEach((w,b)=>{let y=u+b*(u+h);for(let{mode:v,from:S,wide:R}of Aa(w.phases,c,i)){let M=o.modes[v];n.fillStyle=
M,n.fillRect(S,y,R,h-2),this.named(n,x(o.mode_names[v]),S,R,y,h-2,M,t)}w.duration<l&&(n.fillStyle=t.line,n.fillRect(Math.max(c(w.duration),0),y,i,h-2)),this.marks(
n,w,c,y,i,t),e.length>1&&(n.fillStyle=ue(b,t.dark),n.font=`700 12px ${t.font}`,n.textAlign="right",n.fillText("AB"[b],i-1,y-4))});let d=K(l-r,i/60);n.fillStyle=
t.soft,n.font=`10.5px ${t.font}`;let m=re(r,l,i/60);for(let w of m){let b=c(w);n.textAlign=b<14?"left":b>i-14?"right":"center",n.fillText(oe(w,d)+(w===m[0]?" s":
""),b,a-3)}let g=k(c(this.clock.time),6,i-6),f=k(c(this.clock.time),1,i-1);n.fillStyle=t.ink,n.fillRect(f-1,u-4,2,a-u-9),n.beginPath(),n.moveTo(g-6,u-10),n.lineTo(
g+6,u-10),n.lineTo(f,u-1),n.fill(),this.tell(e,o)}tell(e,t){let{time:o,duration:n,playing:i}=this.clock,r=e.map((l,c)=>{let u=x(t.mode_names[l.at(o).mode]);return e.
length>1?`${"AB"[c]} ${u}`:u}).join(", ");i&&r===this.said||(this.said=r,this.element.setAttribute("aria-valuemax",n.toFixed(3)),this.element.setAttribute("aria\
-valuenow",o.toFixed(3)),this.element.setAttribute("aria-valuetext",x("{time} seconds, {what}",{time:T(o,4),what:ae(r)})))}named(e,t,o,n,i,a,r,l){e.font=`11px ${l.
font}`,!(a<13||e.measureText(t).width+8>n)&&(e.fillStyle=Bn(r),e.textAlign="center",e.textBaseline="middle",e.fillText(t,o+.5*n,i+.5*a+1),e.textBaseline="alphab\
etic")}marks(e,t,o,n,i,a){e.font=`11px ${a.font}`,e.textAlign="center";let r=t.events.filter(({kind:l})=>l!=="start"&&l!=="end").map(({kind:l,t:c})=>({kind:l,x:o(
c)})).filter(({x:l})=>l>=-1&&l<=i+1);if(e.fillStyle=a.panel,r.length<i/6)for(let{x:l}of r)e.fillRect(l-.5,n,1,5);e.fillStyle=a.ink;for(let{mark:l,x:c}of Ea(r))e.
fillText(l,k(c,6,i-6),n-4)}};var qh=1/60,jh=[["traces","Traces","t"],["forces","Forces","f"],["speed","Rim speed","c"],["whole","Whole path","w"],["three","3D","3"]],Dh={three:"In space"},ze=(s,e,t)=>p(
"button",{type:"button",title:e,"aria-label":e,onclick:t},s),Ra=(s,e)=>p("span",{},p("span",{"aria-hidden":"true"},`${s} `),e),$s=class{titled="";constructor(e,t,o,n,i){
this.clock=e,this.films=t,this.say=n,this.tell=i,this.playButton=ze(J("play"),"Play (space)",()=>e.play()),this.playButton.classList.add("play"),this.speeds=p("\
select",{"aria-label":"Speed of the film",onchange:()=>{e.speed=Number(this.speeds.value)}},wt.map(a=>p("option",{value:String(a)},`${a}×`))),this.speeds.value=
"1",this.switches=new Map(jh.map(([a,r,l])=>{let c=`${a==="three"?Dh.three:r} (${l})`;return[a,p("button",{type:"button",class:"switch",title:c,onclick:()=>o(a)},
r)]})),this.element=p("div",{class:"transport"},p("div",{class:"buttons"},ze(J("start"),"To the start (Home)",()=>e.seek(0)),ze(J("previous"),"Previous event (S\
hift ←)",()=>this.jump(-1)),ze(J("back"),"One frame back (←)",()=>this.nudge(-1)),this.playButton,ze(J("on"),"One frame on (→)",()=>this.nudge(1)),ze(J("n\
ext"),"Next event (Shift →)",()=>this.jump(1))),p("div",{class:"buttons jumps"},ze(Ra("▲","flight"),"To the next flight (h)",()=>this.jump(1,"takeoff")),ze(
Ra("▼","landing"),"To the next landing (l)",()=>this.jump(1,"impact"))),this.speeds,p("div",{class:"buttons switches"},[...this.switches.values()]))}show(e){let{
clock:t,playButton:o}=this;for(let[i,a]of this.switches)a.setAttribute("aria-pressed",String(e[i]));let n=t.playing?"Pause (space)":"Play (space)";this.titled!==
n&&(this.titled=n,o.replaceChildren(J(t.playing?"pause":"play")),Ze(o,"title",n),Ze(o,"aria-label",n)),this.speeds.value!==String(t.speed)&&(this.speeds.value=String(
t.speed))}nudge(e){this.clock.playing=!1,this.clock.seek(this.clock.time+e*qh*Math.min(this.clock.speed,1))}jump(e,t=null){this.clock.playing=!1;let o=this.films().
flatMap((u,h)=>u.events.map(d=>({event:d,lane:h}))).filter(({event:u})=>!t||(t==="impact"?u.kind===t:Ma(u))).sort((u,h)=>u.event.t-h.event.t),n=this.clock.time,
i=e>0?o.find(({event:u})=>u.t>n+1e-9):o.findLast(({event:u})=>u.t<n-1e-9);if(!i&&t&&(i=o[0]),!i){t&&this.say(t==="takeoff"?"This motion has no flight.":"This mo\
tion has no landing.");return}this.clock.seek(i.event.t);let{event:a,lane:r}=i,l=this.films().length>1?`${x(`Hoop ${"AB"[r]}`)}: `:"",c=x(Ds[a.kind]??a.kind);this.
tell(ae(`${l}${x("{what} at {angle}, {time} s",{what:c,angle:$(a.angle),time:T(a.t,4)})}`))}};var it=class{constructor(e,t,o,{hosted:n=!1,panels:i=null,onmotion:a=()=>{}}={}){this.root=e,this.backend=t,this.hosted=n,this.onmotion=a,Ci(e,n);let{colors:r}=o;
this.known=o.presets,this.address=n?new Jt(this):null,this.clock=new Yt,this.motions=new vs(t,{shown:l=>this.changed(l),refined:()=>this.request(),settled:()=>this.
story.announce(this.films()),noted:l=>this.noted(l),travelled:async l=>this.address?.travel(l),failed:(l,c)=>this.failed(l,c)}),this.notice=new ks,this.theme=new js(
e,r,n,()=>this.show()),this.stage=new Cs(r,()=>{this.request(),this.address?.soon()}),this.transport=new $s(this.clock,()=>this.films(),l=>this.toggle(l),l=>this.
notice.say(l),l=>this.story.say(l)),this.timeline=new Ws(this.clock),this.story=new Os(this.clock),this.theory=new qs,this.plots=new Ms(this.clock,r),this.phase=
new Ss(t,this.clock,r),this.map=new bs(t,o,{take:l=>{this.clock.time=0,this.motions.change(l,!0)},say:l=>this.story.say(l),changed:()=>this.address?.soon()}),this.
controls=new Xt(o.controls,(l,c)=>this.motions.change(l,c)),this.share=new As(this),this.singleKeys=new ms(n),this.help=zi(o.version,r,this.singleKeys.element),
this.hoops=new ps(l=>this.motions.choose(l)),this.header=new ds(o.presets,this.share.menu,{take:l=>this.take(l),undo:()=>this.travel(-1),redo:()=>this.travel(1),
compare:()=>this.motions.compare(),theme:()=>this.theme.toggle(),help:()=>this.help.showModal()}),this.sticky=Oi(this,i),this.extras=new us(this),this.requested=
!1,this.surrounding=!1,this.taken=null,this.afterFrame=null,this.asked=null,this.later=ge(()=>this.fetchTheory(),120),this.frames=0,this.latencies=[],this.frame=
this.frame.bind(this),this.clock.listeners.add(()=>{this.request(),this.clock.playing||this.address?.soon()}),this.deaf=Li(this,n),this.sizes=new ResizeObserver(
()=>this.show())}async open(e,t={}){await this.motions.load(e),this.clock.duration=Math.max(...this.films().map(o=>o.duration)),this.restore(t),this.begin()}begin(){
this.show(),this.motions.note(),this.sizes.observe(this.stage.element),this.root.dataset.ready="true"}close(){this.clock.playing=!1,this.asked?.abort(),this.extras.
close(),this.map.close(),this.theme.close(),this.address?.close(),this.sticky?.close(),this.sizes.disconnect(),this.deaf()}film(e=this.motions.active){return this.
motions.film(e)}films(){return this.motions.films()}changed(e=null){this.notice.clear(),this.show(e)}failed(e,t=[]){this.controls.refuse(t,e.message)||(this.notice.
fail(e),this.controls.restore()),this.showPreset()}noted(e){this.header.show(this.motions.history,this.motions.lanes.length>1),this.address?.write(e),this.onmotion(
this.film().query)}link(){let{clock:e,stage:t,map:o}=this;return this.motions.link(ai({time:e.time,...t.view(),map:o.shown()}))}restore({time:e,map:t,options:o,
...n}){o?.three&&this.toggle("three"),this.stage.restore({options:o,...n}),t&&this.map.restore(t),e&&this.clock.seek(e)}showPreset(){let{query:e}=this.film(),t=this.
known.find(o=>o.query===e);this.header.presets.value=t?.key??"",z(this.hoops.text,t?.text??"")}async take(e){this.taken=e;try{let t=await this.backend.call("fil\
m",{query:e.query});if(this.taken!==e)return;this.clock.time=0,this.motions.replace(t),this.story.announce(this.films())}catch(t){this.failed(t)}}travel(e){return this.
motions.travel(e)}show(e=null){let{motions:t,clock:o}=this,n=this.films();if(!n.length)return;let i=n.length>1;this.theme.read(),o.duration=Math.max(...n.map(a=>a.
duration)),o.time=Math.min(o.time,o.duration),this.root.classList.toggle("two",i),this.header.show(t.history,i),this.hoops.show(n.length,t.active),this.drawStage(),
this.controls.show(this.film(),this.motions.waiting()),this.showPreset(),e!==null&&requestAnimationFrame(()=>setTimeout(()=>this.latencies.push(performance.now()-
e),0)),this.surrounding||(this.surrounding=!0,requestAnimationFrame(()=>setTimeout(()=>this.showSurroundings(),0)))}showSurroundings(){this.surrounding=!1;let e=this.
films(),{active:t}=this.motions,{look:o,colors:n}=this.theme;this.plots.draw(e,t,o),this.phase.draw(e,t,o),this.story.draw(e,t,n),this.drawTime(),this.map.mark(
this.film(),o),this.stage.describe(e),this.extras.changed(),this.later()}drawStage(){this.stage.draw(this.films(),this.motions.active,this.clock,this.theme)}drawTime(){
let{time:e}=this.clock;this.surrounding||(this.timeline.draw(this.films(),this.theme.look,this.theme.colors),this.plots.cursor(e),this.phase.cursor(e),this.story.
cursor(e),this.transport.show(this.stage.options))}request(){this.requested||(this.requested=!0,requestAnimationFrame(this.frame))}frame(e){this.requested=!1,this.
motions.lanes.length&&(this.clock.tick(e),this.motions.refine(this.clock.time,this.clock.playing?2*this.clock.speed:0),this.drawStage(),this.drawTime(),this.extras.
frame(),this.afterFrame?.(),this.frames+=1,this.clock.playing&&this.request())}async fetchTheory(){let{scenario:e}=this.film();this.asked?.abort(),this.asked=new AbortController;
let{signal:t}=this.asked;try{let o=await this.backend.call("theory",{scenario:e},t);this.theory.draw(o.header.thresholds,this.motions.name()),await this.phase.fetch(
e,t)}catch(o){let{name:n,message:i}=o;n!=="AbortError"&&this.theory.draw([{label:"–",text:i}])}}toggle(e){let{options:t}=this.stage;if(e!=="three")t[e]=!t[e];else
try{this.stage.turn(()=>this.drawStage())}catch(o){this.notice.say(o.message)}this.transport.show(t),this.address?.soon(),this.request()}};var Wo=class extends Error{},$o=class{constructor(e,t){this.start=e,this.compiled=t,this.number=0,this.waiting=null,this.worker=this.begun()}begun(){let e=this.
start();return e.onmessage=({data:t})=>{if(t.number!==this.number||!this.waiting)return;let{resolve:o,reject:n}=this.waiting;this.waiting=null,t.error?n(new Error(
t.error)):o(t.answer)},e.onerror=t=>this.fail(new Error(t.message||"The kernel could not be started.")),e.postMessage({compiled:this.compiled}),e}fail(e){this.waiting?.
reject(e),this.waiting=null}stop(e){this.worker.terminate(),this.worker=this.begun(),this.fail(e)}ask(e,t,o){this.number++;let n=new Promise((i,a)=>{this.waiting=
{resolve:i,reject:a}});return this.worker.postMessage({number:this.number,call:e,values:t},o),n}},At=class{constructor(e,t,o,n){this.start=e,this.compiled=t,this.
size=o,this.limit=n,this.idle=[],this.hired=0,this.queue=[]}hand(){let e=this.idle.pop();return e?Promise.resolve(e):this.hired<this.size?(this.hired++,Promise.
resolve(new $o(this.start,this.compiled))):new Promise(t=>this.queue.push(t))}release(e){let t=this.queue.shift();t?t(e):this.idle.push(e)}async ask(e,t,o,n=[]){
o?.throwIfAborted();let i=await this.hand(),a=()=>i.stop(new DOMException("superseded","AbortError")),r=setTimeout(()=>i.stop(new Wo(`This takes longer than ${this.
limit/1e3} s, and was stopped.`)),this.limit);try{return o?.throwIfAborted(),o?.addEventListener("abort",a),await i.ask(e,t,n)}finally{clearTimeout(r),o?.removeEventListener(
"abort",a),this.release(i)}}close(){for(let e of this.idle)e.worker.terminate()}};var _={sources:"b182e971f1528ff2d91b89283c1ac226",module:"d6ea5b32807b4629",built_with:{numba:"0.68.1",llvmlite:"0.50.0",ziglang:"0.17.1"},cell:["radius","mass",
"eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","max_\
events","ideal","rolling_resistance","allowed"],heads:["status","events","segments","duration","doubt_from","doubt_until","panels","kinetic","potential","spring",
"damping","friction","impact_normal","impact_tangential","residual","rolling_resistance"],events:["t","kind","from_mode","to_mode","x","height","angle","vx","vy",
"omega","slip","before_vx","before_vy","before_omega","before_slip","impulse_normal","impulse_tangential","friction","impact_normal","impact_tangential","gain",
"collision","stable","rolling_resistance"],samples:["mode","x","height","angle","vx","vy","omega","slip","friction_force","normal_force","friction","impact_norm\
al","impact_tangential","spring","damping","kinetic","potential","utilization","rolling_resistance"],margins:["normal_force","friction_force","friction_limit","\
free_acceleration","slip","height","p_sigma"],compliant:["law","friction_law","stiffness","damping","restitution","slip_speed","tangential_stiffness","rtol"],laws:[
"kelvin-voigt","hunt-crossley"],friction_laws:["tanh","linear","bristle"],chosen:["stiffness","tangential_stiffness","slip_speed","depth","stiffness_si","slip_s\
peed_si"],thresholds:["first_slip_speed","first_hop_speed","immediate_hop_speed","needed_friction","needed_friction_angle","painleve_friction","painleve_angle",
"jam_angle","jam_angle_2","jam_angle_3","jam_angle_4","stable_angle","massless_loss_angle","massless_loss_by_friction"],numbers:["time","end_angle","end_speed",
"distance","distance_rolled","revolutions_to_rolling","energy_lost","greatest_utilization","takeoff_time","takeoff_angle","hop_height","flight_time","flight_dis\
tance","landing_angle","landing_loss","doubt_until"],words:["status","ending","first_event","hop","painleve"],keys:4,letters_a_key:21,more:7,endings:["duration",
"revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"],spans:{first_revolution:{angle:6.283185307179586,stop:3,timed:0},takeoff:{angle:null,
stop:2,timed:1},reversal:{angle:null,stop:1,timed:1},duration:{angle:null,stop:0,timed:1}},wanted:{sequence:0,status:0,ending:0,first_event:0,hop:0,painleve:0,time:0,
end_angle:0,end_speed:0,distance:0,distance_rolled:0,revolutions_to_rolling:0,energy_lost:0,greatest_utilization:2,takeoff_time:1,takeoff_angle:1,hop_height:1,flight_time:1,
flight_distance:1,landing_angle:1,landing_loss:1},codes:{status:["completed","at_rest","jammed","undetermined","event_limit"],ending:["duration","revolutions","\
reversal","takeoff","rest","jam","undetermined","event_limit"],first_event:["start","slip_start","stick","slip_reversal","takeoff","impact","turn","apex","bounc\
e_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],hop:["no","yes"],painleve:["no","yes"]},shapes:["ring","disk","\
point_mass","radial_rod","tangential_rod"],part:["shape","mass","first","second","at"],kinds:["start","slip_start","stick","slip_reversal","takeoff","impact","t\
urn","apex","bounce_limit","painleve_inconsistent","painleve_indeterminate","jam","kane_gain","skim","rest","end"],letters:"RSKHM",statuses:["completed","at_res\
t","jammed","undetermined","event_limit","buffer"],event_bytes:232,segment_bytes:256,compliant_segment_bytes:536};var at=s=>Object.fromEntries(s.map((e,t)=>[e,t])),Vg=at(_.cell),_e=at(_.heads),Y=at(_.events),Bo=at(_.samples),Pa=at(_.numbers),Ho=at(_.words),Wh={newton:0,poisson:1,
stronge:2};function rt(s){let e=new Float64Array(_.cell.length),t={...Object.fromEntries(Object.entries(s).filter(([,o])=>typeof o=="number")),law:Wh[s.impact_law],
strike:+(s.painleve==="impact"),ideal:Number(s.ideal),allowed:1};return _.cell.forEach((o,n)=>{e[n]=t[o]??0}),e}function Uo(s){let e=t=>t??Number.NaN;return Float64Array.
of(_.laws.indexOf(s.law),_.friction_laws.indexOf(s.friction),e(s.stiffness),e(s.damping),e(s.restitution),e(s.slip_speed),e(s.tangential_stiffness),e(s.rtol))}var Bs=class{constructor(e){this.exports=e,this.rooms=new Map}room(e,t){let o=this.rooms.get(e);if(o&&o.bytes>=t)return o.place;o&&this.exports.free(o.place),this.
rooms.delete(e);let n=this.exports.malloc(t);if(!n)throw new RangeError("There is not enough memory for this motion.");return this.rooms.set(e,{place:n,bytes:t}),
n}floats(e,t){return new Float64Array(this.exports.memory.buffer,e,t)}put(e,t){let o=this.room(e,8*Math.max(t.length,1));return this.floats(o,t.length).set(t),o}};var $h=150,Bh=240,Hh=6e3,[Qg,za,Ia]=[0,1,2],Uh={x:["x"],height:["height"],angle:["angle"],vx:["vx"],vy:["vy"],omega:["omega"],slip:["slip"],friction_force:["fri\
ction_force"],normal_force:["normal_force"],kinetic:["kinetic"],potential:["potential"],friction_loss:["friction","impact_tangential"],normal_loss:["impact_norm\
al","damping"],rolling_resistance:["rolling_resistance"],utilization:["utilization"]};function Go(s,e,t){let{rows:o,count:n,duration:i}=e,[a,r]=(t??[0,i]).map(w=>Math.
min(Math.max(w,0),i)),l=Math.min(Math.max(Math.ceil((r-a)*$h),Bh),Hh),c=_.events.length,u=new Set;for(let w=0;w<=l&&i>0;w++)u.add(w===l?r:a+w*((r-a)/l));let h=new Set;
for(let w=0;w<n;w++){let b=Math.min(o[w*c+Y.t],i);b>=a&&b<=r&&h.add(b)}for(let w of h)u.add(w);let d=Float64Array.from(u).sort(),m=Float64Array.from(h).filter(w=>w>
0).sort(),g=s.states(e,d,!1),f=s.states(e,m,!0);return Gh(d,g,m,f)}function Gh(s,e,t,o){let n=s.length+t.length,i=_.samples.length,a=new Float64Array(n),r=new Float64Array(
n*i),l=0,c=0;for(let h=0;h<s.length;h++)c<t.length&&t[c]<=s[h]&&(a[l]=t[c],r.set(o.subarray(c*i,(c+1)*i),l*i),l++,c++),a[l]=s[h],r.set(e.subarray(h*i,(h+1)*i),l*
i),l++;let u={t:a};for(let[h,d]of Object.entries(Uh)){let m=new Float64Array(n);for(let g of d)for(let f=0;f<n;f++)m[f]+=r[f*i+Bo[g]];u[h]=m}return u.mode=Kh(r,
n,u.omega),u}function Kh(s,e,t){let o=_.samples.length,n=new Float64Array(e),i=0;for(let a=e-1;a>=0&&!i;a--)i=Math.sign(t[a])||0;for(let a=e-1;a>=0;a--){i=Math.
sign(t[a])||i;let r=s[a*o+Bo.mode],l=r===za?-1:r===Ia?1:0;n[a]=l===0?r:l*i<0?za:Ia}return n}function La(s,e){let t=new Map,o=new Float64Array(e);for(let n=0;n<e;n++){let i=Vh(s.subarray(n*_.keys,(n+1)*_.keys));if(i===""){o[n]=Number.NaN;continue}let a=t.
get(i);a===void 0&&(a=t.size,t.set(i,a)),o[n]=a}return{values:o,sequences:[...t.keys()]}}function Vh(s){let e="";for(let t of s){let o=t;for(let n=0;n<_.letters_a_key&&
o;n++){let i=Number(o&7n);o>>=3n,i&&(e+=i===_.more?"+":_.letters[i-1])}}return e}var Jh=256,Yh=2048,Zh=4096,Qh=2e5,Xh=_.statuses.indexOf("buffer"),ec=new Set(["turn","apex","kane_gain","rest"]),Ko=s=>Number.isFinite(s)?s:null,Hs=class{constructor(e){
this.exports=new WebAssembly.Instance(e,{}).exports,this.exports._initialize?.(),this.memory=new Bs(this.exports),this.mostEvents=Jh,this.mostSegments=Yh,this.mostRows=
Zh}call(e,...t){let o=this.exports[e](...t);if(o)throw new Error(`The kernel ended ${e} with ${o}.`)}compute(e){let{memory:t}=this,o=_.events.length;for(;;){let n=t.
room("table",8*o*this.mostEvents),i=t.room("heads",8*_.heads.length);e.contact?this.computeCompliant(e,e.contact,n,i):this.computeRigid(e,n,i);let a=t.floats(i,
_.heads.length).slice(),r=a[_e.events];if(a[_e.status]===Xh)this.makeRoom(e,a[_e.segments]);else if(r===this.mostEvents&&r<e.max_events)this.mostEvents*=4;else{
let l=t.floats(n,r*o).slice();return{given:e,head:a,rows:l,count:r,duration:a[_e.duration],segments:a[_e.segments]}}}}computeRigid(e,t,o){let{memory:n}=this,i=n.
put("cell",rt(e)),a=n.room("events",_.event_bytes*this.mostEvents),r=n.room("segments",_.segment_bytes*this.mostSegments);this.call("motion",i,a,this.mostEvents,
r,this.mostSegments,t,o)}computeCompliant(e,t,o,n){let{memory:i}=this,a=i.put("cell",rt(e)),r=i.put("contact",Uo(t)),l=i.room("events",_.event_bytes*this.mostEvents),
c=i.room("rows",_.compliant_segment_bytes*this.mostRows);this.call("compliant_motion",a,r,l,this.mostEvents,Qh,c,this.mostRows,o,n)}makeRoom(e,t){e.contact?this.
mostRows=t:this.mostSegments*=4}motion(e){return Na(this.compute(e))}film(e){let t=this.compute(e);return{motion:Na(t),columns:Go(this,t)}}columns(e,t){return Go(
this,this.compute(e),t)}samples(e,t){let o=this.states(this.compute(e),t,!1),n=_.samples.length;return Object.fromEntries(_.samples.map((i,a)=>[i,Float64Array.from(
t,(r,l)=>o[l*n+a])]))}states(e,t,o){return this.rows("samples",_.samples.length,e,t,o)}margins(e,t,o=!1){if(e.contact)throw new TypeError("A compliant contact h\
as no such rules.");let n=_.margins.length,i=this.rows("margins",n,this.compute(e),t,o);return Object.fromEntries(_.margins.map((a,r)=>[a,Float64Array.from(t,(l,c)=>i[c*
n+r])]))}rows(e,t,o,n,i){let{memory:a}=this,r=n.length*t,l=a.put("times",n),c=a.room("states",8*Math.max(r,1)),u=a.room("cell",8),h=[o.segments,l,n.length,Number(
i),c];return o.given.contact?this.call("compliant_samples",u,a.room("contact",8),a.room("rows",8),...h):this.call(e,u,a.room("segments",8),...h),a.floats(c,r).slice()}thresholds(e){
let{memory:t}=this,o=t.put("cell",rt(e)),n=t.room("answers",8*_.thresholds.length),i=e.rolling&&e.angle===0;this.call("thresholds",o,i?e.vx:Number.NaN,n);let a=t.
floats(n,_.thresholds.length),r=c=>{let u=a[_.thresholds.indexOf(c)];return Number.isNaN(u)?null:u},l=["jam_angle","jam_angle_2","jam_angle_3","jam_angle_4"].map(
r);return{first_slip_speed:r("first_slip_speed"),first_hop_speed:r("first_hop_speed"),immediate_hop_speed:r("immediate_hop_speed"),needed_friction:r("needed_fri\
ction"),painleve_friction:r("painleve_friction"),painleve_angle:r("painleve_angle"),jam_angles:l.filter(c=>c!==null),stable_angle:r("stable_angle"),massless_loss_angle:r(
"massless_loss_angle"),massless_loss_by_friction:r("massless_loss_by_friction")===1}}regions(e,[t,o,n,i],a,r){let{memory:l}=this,c=l.put("cell",rt(e)),u=l.room(
"modes",a*r),h=l.room("sides",a);this.call("regions",c,t,o,n,i,a,r,u,h);let{buffer:d}=this.exports.memory;return{modes:new Uint8Array(d,u,a*r).slice(),paradox:Float32Array.
from(new Int8Array(d,h,a))}}map({count:e,rows:t},o,n){let{memory:i}=this,a=i.put("cells",t),r=i.room("numbers",8*e*_.numbers.length),l=i.room("words",4*e*_.words.
length),c=i.room("keys",8*e*_.keys),{angle:u,stop:h,timed:d}=_.spans[n],m=_.wanted[o];this.call("map_cells",a,e,u??Number.NaN,h,d,m,r,l,c);let{buffer:g}=this.exports.
memory;if(o==="sequence")return La(new BigUint64Array(g,c,e*_.keys),e);let f=new Float64Array(e);if(o in Ho){let w=new Int32Array(g,l,e*_.words.length);for(let b=0;b<
e;b++)f[b]=w[b*_.words.length+Ho[o]]}else{let w=i.floats(r,e*_.numbers.length);for(let b=0;b<e;b++)f[b]=w[b*_.numbers.length+Pa[o]]}return{values:f}}ideal(e){let t=this.
memory.room("answers",8*_.thresholds.length);return this.call("ideal_hoop",e,t),this.memory.floats(t,1)[0]}resistance(e,t){let o=this.memory.room("answers",8*_.
thresholds.length);return this.call("resistance_limit",e,t,o),this.memory.floats(o,1)[0]}combine(e,t){let{memory:o}=this,n=o.put("parts",t.flatMap(tc)),i=o.room(
"answers",8*_.thresholds.length),a=o.room("reaches",8*t.length);this.call("hoop_of_parts",e,n,t.length,i,a);let[r,l,c]=o.floats(i,3);return{mass:r,eccentricity:l,
inertia_ratio:c,reaches:[...o.floats(a,t.length)]}}compliance(e){let{memory:t}=this;if(!e.contact)throw new TypeError("The contact is rigid.");let o=t.put("cell",
rt(e)),n=t.put("contact",Uo(e.contact)),i=t.room("answers",8*_.thresholds.length);this.call("compliance",o,n,i);let a=t.floats(i,_.chosen.length),r=l=>a[_.chosen.
indexOf(l)];return{stiffness:r("stiffness"),tangential_stiffness:r("tangential_stiffness"),slip_speed:r("slip_speed"),depth:r("depth"),automatic:{stiffness:r("s\
tiffness_si"),slip_speed:r("slip_speed_si")}}}};function tc(s){let e=s.shape==="rod"?`${s.direction}_rod`:s.shape,t=_.shapes.indexOf(e);return s.shape==="ring"?
[t,s.mass,s.inner_radius,s.outer_radius,0]:s.shape==="disk"?[t,s.mass,s.radius,0,s.at]:s.shape==="rod"?[t,s.mass,s.length,0,s.at]:[t,s.mass,0,0,s.at]}var sc=["f\
riction","impact_normal","impact_tangential","rolling_resistance"],oc=["kinetic","potential",...sc,"residual"],Ca=["x","height","angle","vx","vy","omega"];function Na({
given:s,head:e,rows:t,count:o,duration:n}){let i=_.events.length,a=Array.from({length:o},(c,u)=>nc(t.subarray(u*i,(u+1)*i))),r=a[o-1],l=Object.fromEntries([...oc,
...s.contact?["spring","damping"]:[]].map(c=>[c,e[_e[c]]]));return{status:_.statuses[e[_e.status]],sequence:ic(a),duration:n,events:a,final:{t:r.t,mode:r.to,...Object.
fromEntries(Ca.map(c=>[c,r[c]]))},energy:l,doubt:Ko(e[_e.doubt_from])}}function nc(s){let e=_.kinds[s[Y.kind]],t=s[Y.from_mode],o={t:s[Y.t],kind:e,from:t<0?null:
_.letters[t],to:_.letters[s[Y.to_mode]]};for(let n of Ca)o[n]=Ko(s[Y[n]]);return o.before=Object.fromEntries(["vx","vy","omega"].map(n=>[n,Ko(s[Y[`before_${n}`]])])),
o.impulse={normal:s[Y.impulse_normal],tangential:s[Y.impulse_tangential]},s[Y.collision]===0&&(o.collision=!1),e==="kane_gain"&&(o.gain=s[Y.gain]),s[Y.stable]>=
0&&(o.stable=s[Y.stable]===1),o}function ic(s){let e=s.filter(o=>!ec.has(o.kind));return e.slice(0,-1).map((o,n)=>e[n+1].t>o.t?o.to:"").join("")||(s.at(-1)?.to??
"")}var Oa=1e4,Vo=256;function qa(s){let e=URL.createObjectURL(new Blob([s],{type:"text/javascript"}));return()=>new Worker(e,{type:"module"})}var Rt=class s{constructor(e,t){
this.mechanics=new Hs(e),this.motions=new At(t,e,2,Oa);let o=navigator.hardwareConcurrency||2;this.maps=new At(t,e,Math.max(1,Math.min(o-1,8)),Oa)}static async load(e){
let t=new URL(`hophoop.wasm?${_.module}`,e),o=await fetch(t);if(!o.ok)throw new Error(`The kernel is not there: ${t.pathname} gives ${o.status}.`);let i=await(o.
headers.get("Content-Type")==="application/wasm"?WebAssembly.compileStreaming(o):WebAssembly.compile(await o.arrayBuffer())),a=new URL(`kernel.js?${_.module}`,e);
return a.origin===globalThis.location?.origin?new s(i,()=>new Worker(a,{type:"module"})):new s(i,qa(await(await fetch(a)).text()))}static async unpack(e,t){let o=new Blob(
[e]).stream().pipeThrough(new DecompressionStream("gzip")),n=await WebAssembly.compile(await new Response(o).arrayBuffer());return new s(n,qa(t))}motion(e,t){return this.
motions.ask("motion",[e],t)}film(e,t){return this.motions.ask("film",[e],t)}columns(e,t,o){return this.motions.ask("columns",[e,o],t)}samples(e,t,o){return this.
motions.ask("samples",[e,t],o)}thresholds(e,t){return this.motions.ask("thresholds",[e],t)}regions(e,t,o,n,i){return this.motions.ask("regions",[e,t,o,n],i)}async map({
count:e,rows:t},o,n,i){let a=_.cell.length,r=new Float64Array(e).fill(Number.NaN),l=[],c=async h=>{let d=Math.min(Vo,e-h),m=new Float64Array(a*d);for(let w=0;w<
a;w++)m.set(t.subarray(w*e+h,w*e+h+d),w*d);let g=await this.maps.ask("map",[{count:d,rows:m},o,n],i,[m.buffer]),f=g.sequences?.map(w=>(l.includes(w)||l.push(w),
l.indexOf(w)));for(let w=0;w<d;w++)r[h+w]=f?f[g.values[w]]??Number.NaN:g.values[w]},u=Array.from({length:Math.ceil(e/Vo)},(h,d)=>d*Vo);return await Promise.all(
u.map(c)),o==="sequence"?{values:r,sequences:l}:{values:r}}close(){this.motions.close(),this.maps.close()}};var ja={setup:{version:"0.1.0",controls:{groups:{hoop:[{path:"hoop.load_fraction",label:"Load fraction",symbol:"γ",unit:"",help:"Share of the mass in the load \
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
direction:{kind:"word",unit:"",default:"radial",options:["radial","tangential"],expected:"'radial' or 'tangential'"}}},Axis:{place:"",fields:{path:{kind:"number\
_path",unit:"",required:!0},from:{kind:"number",unit:"",required:!0},to:{kind:"number",unit:"",required:!0},cells:{kind:"whole",unit:"",default:48,limits:[["gre\
ater_than_equal",1],["less_than_equal",4096]]}}}},parts:{ring:"Ring",disk:"Disk",point_mass:"PointMass",rod:"Rod"},paths:["duration","hoop.radius","hoop.mass","\
hoop.load_fraction","hoop.eccentricity","hoop.inertia_ratio","hoop.parts","plane.gravity","plane.slope","plane.mu","plane.mu_static","plane.mu_kinetic","plane.r\
estitution","plane.impact_law","plane.painleve","plane.rolling_resistance","start.x","start.height","start.angle","start.speed","start.vx","start.vy","start.ome\
ga","contact.model","contact.max_events","contact.stiffness","contact.damping","contact.restitution","contact.law","contact.friction","contact.slip_speed","cont\
act.tangential_stiffness","contact.rtol"],ends:{"hoop.load_fraction":["eccentricity","inertia_ratio","parts"],"hoop.eccentricity":["load_fraction","parts"],"hoo\
p.inertia_ratio":["load_fraction","parts"],"hoop.parts":["load_fraction","eccentricity","inertia_ratio","mass"],"plane.mu":["mu_static","mu_kinetic"],"plane.mu_\
static":["mu"],"plane.mu_kinetic":["mu"],"start.speed":["height","vx","vy","omega"],"start.height":["speed"],"start.vx":["speed"],"start.vy":["speed"],"start.om\
ega":["speed"],"contact.damping":["restitution"],"contact.restitution":["damping"]},ranges:{"hoop.mass":{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12 kg"},"\
hoop.inertia_ratio":{least:1e-12,most:1e6,words:"0 or from 1e-12 to 1e+06",also:[0]},"plane.slope":{least:-1.57,most:1.57,words:"from -1.57 to 1.57 rad"}},relative:{
stiffness:{least:.01,most:1e15,words:"from 0.01 to 1e+15",of:"m g/R"},tangential_stiffness:{least:.01,most:1e15,words:"from 0.01 to 1e+15",of:"m g/R"},slip_speed:{
least:1e-12,most:1e6,words:"from 1e-12 to 1e+06",of:"√(g R)"}},most_depth:100,touch:1e-12,default:{duration:6,hoop:{radius:1,mass:1,load_fraction:.75},plane:{
gravity:9.81,slope:0,mu:1,restitution:0,impact_law:"stronge",painleve:"flight"},start:{x:0,angle:0,speed:3.1},contact:{model:"rigid",max_events:1e5}}},texts:{unknown_key:"\
{path} is not a known key; {hint}",did_you_mean:"did you mean {close}?",known_are:"known are {known}.",missing:"{path} is missing.",together:"{section}.{other} \
cannot be given together with {section}.{way}.",finding:"{path} = {shown} {allowed}.",number:"must be a number",friction:"must be at least 0 (inf is allowed)",whole:"\
must be a whole number",finite_number:"must be a finite number",greater_than:"must be greater than {limit:g}",greater_than_equal:"must be at least {limit:g}",less_than:"\
must be less than {limit:g}",less_than_equal:"must be at most {limit:g}",range:"must be {words}",literal_error:"must be {expected}",table:"must be a table of ke\
ys",list:"must be a list",word:"must be a word",other_problem:"{first} (and {count} more problem).",other_problems:"{first} (and {count} more problems).",whole_scenario:"\
the scenario",no_parts:"hoop.parts must not be empty.",half_a_hoop:"hoop.{missing} is missing: hoop.{given} does not define a hoop without it.",massless_eccentricity:"\
hoop.inertia_ratio = 0 needs hoop.eccentricity = 1 (all mass in a point on the rim), not {eccentricity!r}.",hoop_mass:"hoop.mass = {mass!r} must be {words}.",parts_inertia:"\
hoop.parts give hoop.inertia_ratio = {inertia_ratio!r}, which must be {words}.",load_inertia:"hoop.load_fraction = {load_fraction!r} gives hoop.inertia_ratio = \
{inertia_ratio!r}, which must be {words}.",ring_radii:"ring.inner_radius = {inner!r} must not exceed ring.outer_radius = {outer!r}.",beyond_the_rim:"hoop.parts.\
{index} ({shape}) reaches {reach!r} m from the centre, beyond the rim: hoop.radius = {radius!r}.",kinetic_above_static:"plane.mu_kinetic = {mu_kinetic!r} must n\
ot exceed plane.mu_static = {mu_static!r}.",vertical:"plane.slope = {slope!r} must lie between -pi/2 and pi/2 (radians).",slope:"plane.slope = {slope!r} must be\
 {words}.",no_omega:"start.omega = None must be a number.",massless_slope:"plane.slope = {slope!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",massless_resistance:"\
plane.rolling_resistance = {given!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",resistance:"plane.rolling_resistance = {given!r} must be below {\
most:.6g} for this hoop, whose inertia about the contact it would cancel at some angle.",massless_compliant:"contact.model = 'compliant' must be 'rigid' for the\
 massless hoop (hoop.inertia_ratio = 0).",compliant_friction:"plane.mu_static = inf must be finite with contact.model = 'compliant'.",relative_contact:"contact.\
{name} = {value!r} is {relative:.3g} {unit} of this hoop and must be {words} of it.",too_soft:"contact.stiffness = {stiffness!r} lets the rim sink some {depth:.\
0e} radii into the plane, at the speed of the start, and must be high enough for at most {most:g}.",no_parameter:"{path} is not a parameter of a scenario; known\
 are {known}.",no_section_parts:"{path} is not a parameter of a scenario: {section} has no parts.",two_ways:"{one} = {one_value!r} and {other} = {other_value!r}\
 cannot be given together.",not_there:"{path} is not there to be replaced: the scenario has no {step!r}.",unreadable_query:"The query cannot be read: {reason}.",
beside_a_value:"{path} cannot stand beside a value for {above}.",given_twice:"{path} is given twice.",parts_out_of_order:"hoop.parts.{name} is out of order: par\
ts are numbered from 0 without a gap."},words:{letters:"RSKHM",modes:["roll","spin","skid","flight","skim"],verbs:{roll:"rolls",spin:"spins",skid:"skids",flight:"\
flies",skim:"skims the plane"},events:{start:"starts",slip_start:"slips",stick:"rolls",slip_reversal:"slips the other way",takeoff:"hops",impact:"lands",turn:"t\
urns back",apex:"is highest",bounce_limit:"has bounced out",painleve_inconsistent:"meets Painlevé's paradox",painleve_indeterminate:"meets Painlevé's indetermi\
nacy",jam:"jams",kane_gain:"gains energy (Kane)",skim:"skims",rest:"rests",end:"ends"},statuses:{completed:"",at_rest:"It has come to rest.",jammed:"The normal \
force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.",undetermined:"The model does not determine the motion beyond.",event_limit:"\
The limit of events (contact.max_events), or of work for one motion, was reached before the end."},sequence:{R:"roll",S:"slip −",K:"slip +",H:"flight",M:"skim",
"+":"…"},story:{start:"It {started} with the load at {where} and the centre at {speed} m/s.",started:"starts and {verb}",started_flight:"starts in the air",started_skim:"\
starts skimming",slip_start:"It {verb} at {where}; friction is used up: the rim slides ahead.",slip_start_spin:"It {verb} at {where}; friction is used up: the r\
im turns too fast for the way it goes.",stick:"It rolls again at {where}; the slip has stopped.",slip_reversal:"The slip turns round at {where}; it {verb}.",takeoff:"\
It hops at {where}.",takeoff_and_landing:"It hops at {where}. It rises {top} and stays up for {time} s.",impact:"It lands at {where} with {speed} m/s downwards \
and {verb}.",impact_bounce:"It lands at {where} with {speed} m/s downwards and bounces.",impact_without_collision:"An impact without collision at {where} stops \
the slip; then it {verb}.",turn:"It turns back at {where}.",turn_in_slip:"It turns back at {where}, and {verb} now.",apex:"The centre is highest at {where}: the\
 gap is {gap}.",bounce_limit:"Bounces without number end here, at {where}.",painleve_inconsistent:"Painlevé's paradox at {where}: no contact force agrees with t\
his slip.",painleve_indeterminate:"Painlevé's paradox at {where}: several contact forces agree with it.",jam:"Dynamic jam at {where}: the contact force grows w\
ithout bound.",kane_gain:"Newton's law of impact has created {gain} J (Kane's example).",skim:"No contact force is left at {where}: the load falls freely and th\
e rim skims the plane.",rest:"It rests at {where}.",rest_unstable:"It rests at {where}, which is not stable.",end:"",other:"{kind} at {where}.",more_bounces:"It\
 bounces {count} more times.",left_out:"… and {count} more."},summary:{change:"{phrase} at {where}",bounces:"bounces",without_collision:"stops its slip at onc\
e",more_bounces:"and {count} more times",more_changes:", … ({count} more)",sentence:"{phrases}. {ending}"},theory:{first_slip:"Slips",first_hop:"Hops",immediate_hop:"\
Hops at once",needed_friction:"Friction for pure rolling",painleve:"Painlevé’s paradox",jam:"Dynamic jam",rest:"Rests stably",loss:"End of rolling",loss_by_friction:"\
at {where} friction is used up",loss_of_contact:"at {where} the contact force is gone",would_slip:"would slip",would_hop:"would hop in its first turn",would_hop_at_once:"\
would hop at once",any_push:"{would}: any push is enough",any_speed:"{would}: at any speed",no_speed:"never, at any speed",above:"{would} above {speed} m/s",no_friction:"\
no friction keeps it rolling",friction_enough:"μ = {mu} would keep it rolling (enough here)",friction_short:"μ = {mu} would keep it rolling (more than there is\
)",never:"never",paradox_here:"from μ = {mu} on, at {where}: possible here",paradox_not_here:"from μ = {mu} on, at {where}: not here",jam_at:"can end a slip a\
t {places}",rest_at:"with the load at {where}",uphill:"Slips, hops",no_threshold:"no threshold uphill (β < 0): whether it slips or hops hangs on where it turns \
back; the map shows it"},least_speed:1e-9},classes:{codes:{hop:{no:"#D9D9D9",yes:"#D55E00"},painleve:{no:"#D9D9D9",yes:"#000000"},ending:{duration:"#6E6E6E",revolutions:"\
#0072B2",reversal:"#009E73",takeoff:"#D55E00",rest:"#56B4E9",jam:"#000000",undetermined:"#F0E442",event_limit:"#CC79A7"},status:{completed:"#0072B2",at_rest:"#5\
6B4E9",jammed:"#000000",undetermined:"#F0E442",event_limit:"#CC79A7"},first_event:{slip_start:"#E69F00",takeoff:"#D55E00",stick:"#0072B2",turn:"#009E73",end:"#5\
6B4E9",impact:"#F0E442",slip_reversal:"#CC79A7",rest:"#D9D9D9",jam:"#000000"}},families:{SR:"#009E73",SS:"#F0E442",SK:"#E69F00",KR:"#CC79A7",KS:"#8C6BB1",KK:"#F\
2B5D4"},massless:{rolls:"#F0E442","rolls, slips":"#E69F00","":"#009E73",slips:"#CC79A7"},hops:"#D55E00",rolls:"#0072B2",other:"#6E6E6E"},map:{cell:["radius","ma\
ss","eccentricity","inertia_ratio","gravity","slope","mu_static","mu_kinetic","restitution","law","strike","x","height","angle","vy","omega","slip","duration","\
max_events","ideal","rolling_resistance","allowed"],laws:{newton:0,poisson:1,stronge:2},events:2e3,flight_turns:2e3,allowed:{duration:{least:1e-9,most:1e9,words:"\
from 1e-09 to 1e+09"},"hoop.radius":{least:1e-6,most:1e6,words:"from 1e-06 to 1e+06"},"hoop.mass":{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12"},"hoop.load\
_fraction":{least:0,most:1,words:"from 0 to 1"},"hoop.eccentricity":{least:0,most:1,words:"from 0 to 1"},"hoop.inertia_ratio":{least:1e-12,most:1e6,words:"0 or \
from 1e-12 to 1e+06",also:[0]},"hoop.parts.mass":{least:1e-12,most:1e12,words:"from 1e-12 to 1e+12"},"hoop.parts.length":{least:1e-12,most:1e6,words:"from 1e-12\
 to 1e+06"},"plane.gravity":{least:1e-6,most:1e6,words:"0 or from 1e-06 to 1e+06",also:[0]},"plane.slope":{least:-1.57,most:1.57,words:"from -1.57 to 1.57"},"pl\
ane.mu":{least:0,most:1e6,words:"from 0 to 1e+06, or inf",also:["inf"]},"plane.restitution":{least:0,most:1,words:"from 0 to 1"},"plane.rolling_resistance":{least:0,
most:1,words:"from 0 to 1"},"start.x":{least:-1e9,most:1e9,words:"from -1e+09 to 1e+09"},"start.height":{least:0,most:1e6,words:"from 0 to 1e+06"},"start.angle":{
least:-1e6,most:1e6,words:"from -1e+06 to 1e+06"},"start.speed":{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06"},"start.vx":{least:-1e6,most:1e6,words:"from -\
1e+06 to 1e+06"},"start.vy":{least:-1e6,most:1e6,words:"from -1e+06 to 1e+06"},"start.omega":{least:-1e9,most:1e9,words:"from -1e+09 to 1e+09"},"contact.stiffne\
ss":{least:1e-6,most:1e18,words:"from 1e-06 to 1e+18"},"contact.damping":{least:0,most:1e12,words:"from 0 to 1e+12"},"contact.restitution":{least:0,most:1,words:"\
from 0 to 1"},"contact.slip_speed":{least:1e-12,most:1e6,words:"from 1e-12 to 1e+06"},"contact.tangential_stiffness":{least:1e-6,most:1e18,words:"from 1e-06 to \
1e+18"},"contact.rtol":{least:1e-10,most:.1,words:"from 1e-10 to 0.1"},"contact.max_events":{least:1,most:1e7,words:"from 1 to 1e+07"}},words:["hoop.parts","pla\
ne.impact_law","plane.painleve","contact.model","contact.law","contact.friction"],quantities:{sequence:{label:"what happens in the first turn",span:"first_revol\
ution",unit:"",words:[]},hop_height:{label:"height of the first hop",span:"takeoff",unit:"m",words:[]},takeoff_angle:{label:"angle of take-off",span:"takeoff",unit:"\
rad",words:[]},flight_time:{label:"duration of the first hop",span:"takeoff",unit:"s",words:[]},greatest_utilization:{label:"greatest friction utilization",span:"\
first_revolution",unit:"1",words:[]},energy_lost:{label:"energy lost",span:"duration",unit:"J",words:[]},end_angle:{label:"angle at the end",span:"duration",unit:"\
rad",words:[]},painleve:{label:"Painlevé’s paradox or jam met",span:"duration",unit:"",words:["no","yes"]},ending:{label:"how it ends",span:"duration",unit:"",
words:["duration","revolutions","reversal","takeoff","rest","jam","undetermined","event_limit"]}}},lab:{too_long:"duration = {duration:g} must be at most {most:\
g} s in the lab; the library itself has no such limit.",too_many_parts:"hoop.parts has {parts} parts and must have at most {most} in the lab.",too_many_turns:"d\
uration = {duration:g} s at this speed and radius is about {turns:.0e} revolutions and must be at most {most:.0e} in the lab; the library itself has no such lim\
it.",too_stiff:"contact.stiffness, contact.slip_speed and duration need about {steps:.0e} steps of integration and must need at most {most:.0e} in the lab.",too_many_changes:"\
changes has {pairs} pairs and must have at most {most} in the lab.",too_many_cells:"x.cells times y.cells = {cells} must be at most {most} in the lab.",equal_axes:"\
x.path and y.path are both {path!r} and must differ.",two_axes:"{one} and {other} cannot both be axes: they say the same thing in two ways.",rigid_maps:"contact\
.model = 'compliant' must be 'rigid' for a map.",cell_turns:"A cell of this map is about {turns:.0e} revolutions and must be at most {most:.0e} in the lab.",map_turns:"\
x and y make {cells} cells of about {turns:.2g} revolutions in all, and must be at most {most:.0e} in the lab; take fewer cells, lower speeds or a shorter durat\
ion.",doubt:"What comes after {time} s hangs on more digits than the numbers of this page have; hophoop lab and Python take as many as it needs.",not_a_pair:"ch\
anges holds {change}, which is not a pair of path and value.",window:"must be four numbers, θ from and to [rad], θ̇ from and to [rad/s], each pair rising",times:"\
must be two times, from and to [s], rising from 0",number_path:"must be a number's path, not that of a word",one_of:"must be one of {known}"},limits:{duration:600,
events:2e4,parts:64,samples:20001,cells:65536,turns:2e5,map_turns:4e6,steps:3e6,changes:200},calls:{setup:[],film:["scenario","query","changes"],samples:["scena\
rio","query","changes","window"],code:["scenario","query","changes"],simulate:["scenario","query","changes","samples"],theory:["scenario","query","changes"],regions:[
"scenario","query","changes","window"],map:["scenario","query","changes","x","y","what"],file:["scenario","query","changes","name"]},regions:{widest:1e300,usual:[
0,6.283185307179586,-12,12]},table:{rate:200,variables:{mode:"1",x:"m",height:"m",angle:"rad",vx:"m/s",vy:"m/s",omega:"rad/s",slip:"m/s",friction_force:"N",normal_force:"\
N",kinetic:"J",potential:"J",total:"J",friction:"J",impact_normal:"J",impact_tangential:"J",rolling_resistance:"J",spring:"J",damping:"J"}},shown:["hoop.radius",
"hoop.mass","hoop.load_fraction","hoop.eccentricity","hoop.inertia_ratio","plane.mu","plane.rolling_resistance","plane.mu_static","plane.mu_kinetic","start.spee\
d","start.height","start.vx","start.vy","start.omega"]};var A=ja,Pt=s=>s==="inf"?1/0:s;var{codes:rc,families:lc,massless:hc,hops:cc,rolls:uc,other:dc}=A.classes,{sequence:pc}=A.words,Da="sequence";function mc(s){let e=-1;for(let t of s){e^=t.charCodeAt(
0);for(let o=0;o<8;o++)e=e>>>1^(e&1?3988292384:0)}return~e>>>0}function Fa(s,e){if(e!==Da)return rc[e]?.[s]??dc;let t=[...s].find(m=>"SK".includes(m))??"R",o=[s.
startsWith("R")&&"rolls",/[SK]/.test(s)&&"slips"].filter(Boolean).join(", "),n=s.endsWith("H")?cc:lc[t+s.slice(-1)]??uc,i=s.includes("M")?hc[o]:n,a=[1,3,5].map(
m=>Number.parseInt(i.slice(m,m+2),16)/255),r=(a[0]+a[1]+a[2])/3,l=Math.min(s.length-1,9)/9,c=mc(s)%1e3/1e3,u=.62-.62*Math.min(2*l,1),h=Math.max(2*l-1,0)*.5;return`\
#${a.map(m=>{let g=(1-.2*c)*m+.2*c*r,f=Math.min(Math.max((g+(1-g)*u)*(1-h),0),1);return Math.round(255*f).toString(16).padStart(2,"0")}).join("")}`}function Wa(s,e){
return e!==Da?s.replaceAll("_"," "):[...s].map(t=>pc[t]).join(" → ")}function te({duration:s,hoop:e,plane:t,start:o,contact:n}){let{radius:i,mass:a,eccentricity:r,inertia_ratio:l}=e,{gravity:c,slope:u,rolling_resistance:h,mu_static:d,
mu_kinetic:m,restitution:g,impact_law:f,painleve:w}=t,{x:b,height:y,angle:v,vx:S,vy:R,omega:M,slip:E}=Ie(o,i),{max_events:I,model:O,...q}=n;return{radius:i,mass:a,
eccentricity:r,inertia_ratio:l,ideal:e.load_fraction!==null,gravity:c,slope:u,rolling_resistance:h,mu_static:d,mu_kinetic:m,restitution:g,impact_law:f,painleve:w,
x:b,height:y,angle:v,vx:S,vy:R,omega:M,slip:E,rolling:o.speed!==null,duration:s,max_events:I,contact:O==="rigid"?null:q}}function Ie({x:s,height:e,angle:t,speed:o,
vx:n,vy:i,omega:a},r){let l=o===null?Number(a):o/r;return{x:s,height:e,angle:t,vx:n,vy:i,omega:l,slip:o===null?n-r*l:0}}function Jo(s,e){let[t,o,n]=[0,0,0];for(let i=0;i<s.length;i++)for(let a=0;a<e.length;a++){let r=0;for(;i+r<s.length&&a+r<e.length&&s[i+r]===e[a+r];)r++;r>t&&([
t,o,n]=[r,i,a])}return t?t+Jo(s.slice(0,o),e.slice(0,n))+Jo(s.slice(o+t),e.slice(n+t)):0}function $a(s,e){let t=[...s],o,n=0;for(let i of e){let a=[...i],r=a.length+
t.length;if(2*Math.min(a.length,t.length)/r<.6)continue;let l=2*Jo(a,t)/r;l>=.6&&(l>n||l===n&&o!==void 0&&i>o)&&([o,n]=[i,l])}return o}var We=class{constructor(e){this.text=e}};function $e(s){if(Number.isNaN(s))return"nan";if(!Number.isFinite(s))return s>0?"inf":"-inf";let e=s<0||Object.is(s,-0)?
"-":"",[t,o]=Math.abs(s).toExponential().split("e"),n=t.replace(".",""),i=Number(o);return i<-4||i>=16?`${e}${t}e${Yo(i)}`:e+(i<0?`0.${"0".repeat(-i-1)}${n}`:Ua(
n,i+1))}function Ua(s,e){let t=s.padEnd(e,"0");return`${t.slice(0,e)}.${t.slice(e)||"0"}`}var Yo=s=>`${s<0?"-":"+"}${String(Math.abs(s)).padStart(2,"0")}`;function Ga(s,e){
let[t,o]=s.toExponential(e-1).split("e"),n=t.replace(".",""),i=s.toExponential(100).split("e")[0].replace(".","");return i[e]==="5"&&/^0*$/.test(i.slice(e+1))&&
Number(i[e-1])%2===0?[i.slice(0,e),Number(s.toExponential(100).split("e")[1])]:[n,Number(o)]}function Zo(s){return Number.isNaN(s)?"nan":s>0?"inf":"-inf"}var zt=s=>s<
0||Object.is(s,-0)?"-":"";function xe(s,e=6){if(!Number.isFinite(s))return Zo(s);let t=zt(s);if(s===0)return`${t}0`;let[o,n]=Ga(Math.abs(s),e),i=o.replace(/0+$/,
"")||"0";if(n<-4||n>=e)return`${t}${i[0]}${i.length>1?`.${i.slice(1)}`:""}e${Yo(n)}`;if(n<0)return`${t}0.${"0".repeat(-n-1)}${i}`;let[a,r]=Ua(o,n+1).split("."),
l=r.replace(/0+$/,"");return`${t}${a}${l&&`.${l}`}`}function fc(s,e){if(!Number.isFinite(s))return Zo(s);let[t,o]=s===0?["0".repeat(e+1),0]:Ga(Math.abs(s),e+1),
n=t.slice(1);return`${zt(s)}${t[0]}${n&&`.${n}`}e${Yo(o)}`}function Qo(s,e){if(!Number.isFinite(s))return Zo(s);let t=Math.abs(s);if(t>=1e21)return`${zt(s)}${BigInt(
t)}${e?`.${"0".repeat(e)}`:""}`;let o=t.toFixed(e),n=t.toFixed(100),i=n.slice(n.indexOf(".")+1+e),a=n.slice(0,n.indexOf(".")+(e?1+e:0));return/^50*$/.test(i)&&Number(
a.at(-1))%2===0?zt(s)+a:zt(s)+o}function j(s,e){return s.replace(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g,(t,o,n,i,a)=>{let r=e[o];return r instanceof We?r.text:n?
he(r):a==="g"?xe(r,i===""?6:Number(i)||1):a==="e"?fc(r,Number(i)):a==="f"?Qo(r,Number(i)):String(r)})}function he(s,e=!0){return s==null?"None":s===!0?"True":s===
!1?"False":typeof s=="number"?e?$e(s):Ka(s):typeof s=="string"?Ba(s):Array.isArray(s)?`[${s.map(o=>he(o,e)).join(", ")}]`:`{${Object.entries(s).map(([o,n])=>`${Ba(
o)}: ${he(n,e)}`).join(", ")}}`}function Ka(s){let e=Object.is(s,-0)?"0":String(s);return/^-?\d+$/.test(e)?e:$e(s)}function It(s){return typeof s=="number"?Ka(s):
typeof s=="string"?JSON.stringify(s).replace(/[\u007f-\uffff]/g,e=>`\\u${Us(e.charCodeAt(0),4)}`):Array.isArray(s)?`[${s.map(It).join(", ")}]`:s&&typeof s=="obj\
ect"?`{${Object.entries(s).map(([e,t])=>`${It(e)}: ${It(t)}`).join(", ")}}`:String(s)}var Us=(s,e)=>s.toString(16).padStart(e,"0"),gc=/[\p{C}\p{Zl}\p{Zp}\p{Zs}]/u,
Va=s=>s===" "||!gc.test(s);function Ja(s){if(s===`
`)return"\\n";if(s==="\r")return"\\r";if(s==="	")return"\\t";let e=s.codePointAt(0);return e<256?`\\x${Us(e,2)}`:e<65536?`\\u${Us(e,4)}`:`\\U${Us(e,8)}`}function Ba(s){
let e=s.includes("'")&&!s.includes('"')?'"':"'",t=[...s].map(o=>o===e||o==="\\"?`\\${o}`:Va(o)?o:Ja(o));return e+t.join("")+e}var Ya=s=>[...s].map(e=>Va(e)?e:Ja(
e)).join("");function Gs(s){let e=[...s];return e.length<=60?s:`${e.slice(0,57).join("")}...`}var Ha="[\\s\\x1c-\\x1f\\x85]*",wc=new RegExp(`^${Ha}([+-]?)(?:(in\
f(?:inity)?|nan)|((?:\\d+(?:_\\d+)*\\.?(?:\\d+(?:_\\d+)*)?|\\.\\d+(?:_\\d+)*)(?:e[+-]?\\d+(?:_\\d+)*)?))${Ha}$`,"i");function Za(s){let e=wc.exec(s);if(!e||s.includes(
"\uFEFF"))return;let[,t,o,n]=e,i=o?o[0].toLowerCase()==="n"?Number.NaN:1/0:Number(n.replaceAll("_",""));return t==="-"?-i:i}var{texts:Qa,scenario:Xa}=A,L=class extends Error{constructor(e){super(Ya(e)),this.name="InputError"}},se=class extends L{},N=(s,e={})=>j(Qa[s],e),ce=s=>s!==null&&
typeof s=="object"&&!Array.isArray(s);function Le(s=()=>!1,e=""){return{said:[],above:e,float:s}}function D(s,e,t,o,n){Be(s,e,t,N(o,n))}function Be(s,e,t,o){let n=typeof t==
"bigint"?String(t):he(t,s.float(e)),i=s.above+e||Qa.whole_scenario;s.said.push(N("finding",{path:i,shown:Gs(n),allowed:o}))}function Lt(s,e,t,o,n={}){let{fields:i,
place:a}=Xa.models[s];if(!ce(e))return D(o,t,e,"table"),null;for(let c of Object.keys(e))if(!Object.hasOwn(i,c))return o.said.push(Nt(a,c,Object.keys(i))),null;
let r=o.said.length,l={};for(let[c,u]of Object.entries(i)){if(u.kind==="section")continue;let h=n[u.kind];Object.hasOwn(e,c)&&h?l[c]=h(e[c],`${t}.${c}`,o):Object.
hasOwn(e,c)?l[c]=Xo(u,e[c],`${t}.${c}`,o):u.required?o.said.push(N("missing",{path:`${o.above}${t}.${c}`})):l[c]=Pt(u.default)}return o.said.length===r?{values:l,
given:new Set(Object.keys(e))}:null}function Nt(s,e,t){let o=$a(e,t),n=o?N("did_you_mean",{close:o}):N("known_are",{known:t.join(", ")});return N("unknown_key",
{path:`${s}${Gs(e)}`,hint:n})}function Xo(s,e,t,o){if(e===null&&s.nullable)return null;if(s.kind==="parts")return yc(e,t,o);if(s.kind==="word")return s.options.
includes(e)||D(o,t,e,"literal_error",s),e;let n=s.kind==="friction",i=n&&e==="inf"?1/0:e;if(typeof i!="number")return D(o,t,e,"number");if(n&&!(i>=0))return D(o,
t,e,"friction");if(s.kind==="whole"&&!Number.isInteger(i))return D(o,t,e,"whole");if(!n&&!Number.isFinite(i))return D(o,t,e,"finite_number");for(let[a,r]of s.limits??
[])if(!bc(a,i,r))return D(o,t,s.kind==="whole"?BigInt(i):e,a,{limit:r});return s.range&&!Ne(s.range,i)?D(o,t,e,"range",s.range):i+0}function bc(s,e,t){return s===
"greater_than"?e>t:s==="greater_than_equal"?e>=t:s==="less_than"?e<t:e<=t}var Ne=({least:s,most:e,also:t=[]},o)=>s<=o&&o<=e||t.some(n=>Pt(n)===o);function yc(s,e,t){
return Array.isArray(s)?s.map((o,n)=>vc(o,`${e}.${n}`,t)):D(t,e,s,"list")}function vc(s,e,t){let o=en(s,"shape",Xa.parts,e,t),n=o&&Lt(o,s,e,t);if(!n)return null;
let{inner_radius:i,outer_radius:a}=n.values;return i>a&&t.said.push(N("ring_radii",{inner:i,outer:a})),n.values}function en(s,e,t,o,n,i){if(!ce(s))return D(n,o,
s,"table"),null;let a=Object.hasOwn(s,e)?s[e]:i;if(a===void 0||a===null&&i)return n.said.push(N("missing",{path:`${n.above}${o}.${e}`})),null;if(typeof a=="stri\
ng"&&Object.hasOwn(t,a))return t[a];let r=typeof a=="string"?a:he(a,n.float(`${o}.${e}`)),l=Object.keys(t).map(d=>`'${d}'`),c=`${l.slice(0,-1).join(", ")} or ${l.
at(-1)}`,u=N("literal_error",{expected:c}),h={path:`${n.above}${o}.${e}`,shown:Gs(he(r)),allowed:u};return n.said.push(N("finding",h)),null}function Ct(s){let e=s.
length-1;return e?N(e===1?"other_problem":"other_problems",{first:s[0].replace(/\.$/,""),count:e}):s[0]}var er=A.scenario.ends,tn=s=>Object.hasOwn(er,s)?er[s]:[];function on(s){let e=s.indexOf(".");return e<0?[s,""]:[s.slice(0,e),s.slice(e+1)]}function Ot(s){for(let e of s){
let[t]=on(e),o=tn(e).map(n=>`${t}.${n}`);for(let n of s)if(o.some(i=>n===i||n.startsWith(`${i}.`)))return[e,n]}return null}var tr=new Set(A.scenario.paths),kc=new Set(
A.map.words),or=/^hoop\.parts\.\d+\.(\w+)$/,nr=Object.assign(Object.create(null),...Object.values(A.scenario.parts).map(s=>A.scenario.models[s].fields));function ir(s){
return tr.has(s)||(or.exec(s)?.[1]??"")in nr?null:N("no_parameter",{path:s,known:[...tr].join(", ")})}function ar(s){let e=or.exec(s);return e?nr[e[1]].kind!=="\
word":!kc.has(s)}function sr(s){let[e,t]=on(s);return(e==="start"?10:0)+(t===""?0:s==="contact.model"||s==="hoop.parts"?1:2)}var nn=s=>e=>!s.some(t=>e===t||e.startsWith(
t.endsWith(".")?t:`${t}.`));function an(s,e,t,o){let n=[...t.keys()],i=Ot(n);if(i){let[l,c]=i,[u,h]=i.map(d=>new We(he(t.get(d),!1)));throw new L(N("two_ways",{
one:l,other:c,one_value:u,other_value:h}))}let a=new Set,r=nn(n);for(let l of n.sort((c,u)=>sr(c)-sr(u))){let c=structuredClone(t.get(l)),[u,h]=on(l);if(h==="")
sn(e,u,c);else if(l==="contact.model")e.contact={model:c};else{Object.hasOwn(e,u)||sn(e,u,{});let d=e[u];if(!ce(d))throw new L(N("no_section_parts",{path:l,section:u}));
if(!a.has(u)&&tn(l).some(m=>Object.hasOwn(d,m))){a.add(u);let m=_c(s,l,()=>o(e.hoop,r));for(let[g,f]of Object.entries(m))t.has(`${u}.${g}`)||(d[g]=f)}for(let m of tn(
l))delete d[m];xc(d,h.split("."),c,l)}}return e}function sn(s,e,t){Object.defineProperty(s,e,{value:t,enumerable:!0,configurable:!0,writable:!0})}function _c({hoop:s,
plane:e,start:t},o,n){let{mass:i,eccentricity:a,inertia_ratio:r}=s;if(o==="hoop.eccentricity"||o==="hoop.inertia_ratio")return{mass:i,eccentricity:a,inertia_ratio:r};
if(o==="hoop.load_fraction")return{mass:i};if(o==="plane.mu_static"||o==="plane.mu_kinetic"){let l=c=>c===1/0?"inf":c;return{mu_static:l(e.mu_static),mu_kinetic:l(
e.mu_kinetic)}}if(o.startsWith("start.")&&o!=="start.speed"){let{height:l,vx:c,vy:u,omega:h}=Ie(t,n().radius);return{height:l,vx:c,vy:u,omega:h}}return{}}function xc(s,e,t,o){
let n=s,i=e.pop(),a=l=>new L(N("not_there",{path:o,step:l})),r=l=>Array.isArray(n)&&/^\d+$/.test(l)&&Number(l)<n.length;for(let l of e)if(r(l))n=n[Number(l)];else if(ce(
n)&&Object.hasOwn(n,l))n=n[l];else throw a(l);if(ce(n))sn(n,i,t);else if(r(i))n[Number(i)]=t;else throw a(i)}var{lab:Tc,limits:X}=A,{allowed:Sc,events:Mc,flight_turns:Ec,quantities:Ac}=A.map,Rc=1e-300,F=(s,e={})=>j(Tc[s],e),rn=s=>F("doubt",{time:xe(s,4)});function lt(s){
let{duration:e,hoop:t,contact:o}=s;if(e>X.duration)throw new se(F("too_long",{duration:e,most:X.duration}));let n=t.parts?.length??0;if(n>X.parts)throw new se(F(
"too_many_parts",{parts:n,most:X.parts}));let i=cr(hr(s));if(i>X.turns)throw new se(F("too_many_turns",{duration:e,turns:i,most:X.turns}));if(o.model==="complia\
nt"){let a=Pc(s,i);if(a>X.steps)throw new se(F("too_stiff",{steps:a,most:X.steps}))}return o.max_events<=X.events?s:{...s,contact:{...o,max_events:X.events}}}function hr({
duration:s,hoop:{radius:e},plane:{gravity:t,slope:o},start:n}){let{height:i,vx:a,vy:r,omega:l}=Ie(n,e);return{duration:s,radius:e,gravity:t,slope:o,height:i,vx:a,
vy:r,omega:l}}function cr({duration:s,radius:e,gravity:t,slope:o,height:n,vx:i,vy:a,omega:r}){return(2*(Math.abs(i)+Math.abs(a)+e*Math.abs(r)+2*Math.sqrt(t*(e+n)))+
.5*t*Math.abs(Math.sin(o))*s)*s/(2*Math.PI*e)}function Pc({duration:s,hoop:{radius:e,mass:t},plane:{gravity:o},contact:{stiffness:n}},i){let r=10/Math.sqrt(e/(o>
0?o:1))+(n===null?0:Math.sqrt(n/t));return 10*s*r+40*i}function ln(s,{x:e,y:t,what:o}){if(s.contact.model!=="rigid")throw new L(F("rigid_maps"));let{contact:n,...i}=lt(
s),a={...i,contact:{...n,max_events:Math.min(n.max_events,Mc)}};zc(a,e,t,Ac[o].span);let r=Ot([t.path,e.path]);if(r)throw new L(F("two_axes",{one:r[0],other:r[1]}));
return a}function zc(s,e,t,o){let n=hr(s),i=o==="first_revolution",a=qt(e).filter(h=>lr(e.path,h)),r=qt(t).filter(h=>lr(t.path,h)),[l,c]=[0,0];for(let h of r)for(let d of a){
let m=rr(rr(n,t.path,h),e.path,d),f=i?1+Math.min(m.vx**2/(10*n.gravity*n.radius+Rc),Ec):cr(m);l+=f,c=Math.max(c,f)}if(!i&&c>X.turns)throw new se(F("cell_turns",
{turns:c,most:X.turns}));if(l<=X.map_turns)return;let u=a.length*r.length;throw new se(F("map_turns",{cells:u,turns:l,most:X.map_turns}))}function rr(s,e,t){if(e===
"start.speed")return{...s,vx:t,vy:0,omega:0};let o=e.slice(e.lastIndexOf(".")+1);return o in s&&o!=="height"?{...s,[o]:t}:s}var qt=({from:s,to:e,cells:t})=>Array.
from({length:t},(o,n)=>s+(n+.5)*((e-s)/t));function lr(s,e){let t=Sc[s.startsWith("plane.mu")?"plane.mu":s];return!t||Ne(t,e)}var{scenario:ht}=A,Ic=["load_fraction","eccentricity","inertia_ratio"],ur=["mu_static","mu_kinetic"],Lc=["height","vx","vy","omega"],He=class extends Error{};function W(s,e){
throw new He(N(s,e))}function Ks(s,e,t){let o=t.find(n=>n!==e);o&&W("together",{section:s,other:o,way:e})}function hn({values:s,given:e},t){let o={...s},n=Ic.filter(
u=>e.has(u)&&s[u]!==null);o.parts!==null?(o.parts.length||W("no_parts"),Ks("hoop","parts",[...n,...e.has("mass")?["mass"]:[]]),Object.assign(o,Nc(o.radius,o.parts,
t))):o.load_fraction!==null||!n.length?(Ks("hoop","load_fraction",n),o.load_fraction??=ht.models.Hoop.fields.eccentricity.default,o.eccentricity=o.load_fraction,
o.inertia_ratio=t.ideal(o.load_fraction)):n.length===1&&W("half_a_hoop",{missing:n[0]==="eccentricity"?"inertia_ratio":"eccentricity",given:n[0]});let{mass:i,inertia_ratio:a,
load_fraction:r,eccentricity:l}=o,c=ht.ranges;if(Ne(c["hoop.mass"],i)||W("hoop_mass",{mass:i,words:c["hoop.mass"].words}),!Ne(c["hoop.inertia_ratio"],a)){let{words:u}=c["\
hoop.inertia_ratio"];W(o.parts?"parts_inertia":"load_inertia",{load_fraction:r,inertia_ratio:a,words:u})}return a===0&&l!==1&&W("massless_eccentricity",{eccentricity:l}),
o}function Nc(s,e,t){let{reaches:o,...n}=t.combine(s,e),i=o.findIndex(a=>a>s*(1+ht.touch));return i>=0&&W("beyond_the_rim",{index:i,shape:e[i].shape,reach:o[i],
radius:s}),n}function dr({values:s,given:e}){let t={...s};t.apart=ur.some(r=>e.has(r)),t.mu!==null?(Ks("plane","mu",ur.filter(r=>e.has(r))),t.mu_static=t.mu,t.mu_kinetic=
t.mu):t.mu_static===t.mu_kinetic&&(t.mu=t.mu_static);let{mu_static:o,mu_kinetic:n,slope:i}=t;n>o&&W("kinetic_above_static",{mu_kinetic:n,mu_static:o}),Math.abs(
i)<.5*Math.PI||W("vertical",{slope:i});let a=ht.ranges["plane.slope"];return Ne(a,i)||W("slope",{slope:i,words:a.words}),t}function pr({values:s,given:e}){let t={
...s};return t.speed!==null?(Ks("start","speed",Lc.filter(o=>e.has(o))),t.vx=t.speed,t.omega=null):t.omega===null&&W("no_omega"),t}function mr({values:s}){let e=s;
return e.model==="compliant"&&e.damping!==null&&e.restitution!==null&&W("together",{section:"contact",other:"restitution",way:"damping"}),e}function fr(s,e,t){let{
hoop:o,plane:n,contact:i}=s,a=o.inertia_ratio===0,r=i.model==="compliant";a&&n.slope!==0&&W("massless_slope",{slope:n.slope});let l=n.rolling_resistance;l!==0&&
a&&W("massless_resistance",{given:l});let c=l===0?void 0:e.resistance?.(o.eccentricity,o.inertia_ratio);c!==void 0&&!(l<c)&&W("resistance",{given:l,most:c}),a&&
r&&W("massless_compliant"),r&&n.mu_static===1/0&&W("compliant_friction"),r&&e.compliance&&Cc(i,e.compliance(t(s)))}function Cc(s,e){for(let[n,{of:i,...a}]of Object.
entries(ht.relative)){let r=s[n];if(r===null)continue;let l=e[n];Ne(a,l)||W("relative_contact",{name:n,value:r,relative:l,unit:i,words:a.words})}let{depth:t}=e,
o=Pt(ht.most_depth);t>o&&W("too_soft",{stiffness:s.stiffness,depth:t,most:o})}var Oc=1e3;function gr(s){let e=s.startsWith("?")?s.slice(1):s;if(e&&e.split("&").length>Oc)throw new L(N("unreadable_query",{reason:"Max number of fields excee\
ded"}));let t=new Map;for(let[i,a]of new URLSearchParams(`&${e}`)){let r=i.split("."),l=r.pop(),c=t;for(let u of r)if(c.has(u)||c.set(u,new Map),c=c.get(u),!(c instanceof
Map))throw new L(N("beside_a_value",{path:i,above:i.slice(0,i.lastIndexOf("."))}));if(c.has(l))throw new L(N("given_twice",{path:i}));c.set(l,Za(a)??a)}let o=t.
get("hoop"),n=o instanceof Map&&o.get("parts");return n instanceof Map&&o.set("parts",qc(n)),cn(t)}function qc(s){let e=Array.from({length:s.size},(o,n)=>String(
n)),t=new Set(e);for(let o of s.keys())if(!t.has(o))throw new L(N("parts_out_of_order",{name:o}));return e.map(o=>s.get(o))}function cn(s){return Array.isArray(
s)?s.map(cn):s instanceof Map?Object.fromEntries([...s].map(([e,t])=>[e,cn(t)])):s}function wr(s){return br(s,"").map(([e,t])=>`${e}=${jc(e,t)}`).join("&")}function br(s,e){
return s===null||typeof s!="object"?[[e,s]]:Object.entries(s).flatMap(([t,o])=>br(o,e?`${e}.${t}`:t))}function jc(s,e){return Vs(s,e).replace("e+","e").replace(
/\.0$/,"")}function Vs(s,e){return typeof e=="string"?e:Dc.has(s.slice(s.lastIndexOf(".")+1))?String(e):$e(e)}var Dc=new Set(Object.values(A.scenario.models).flatMap(
({fields:s})=>Object.keys(s).filter(e=>s[e].kind==="whole")));var{scenario:Te}=A,Fc={rigid:"Rigid",compliant:"Compliant"};function un(s,e,t=Le()){let o=dn(s,e,t);if(!o)throw new L(Ct(t.said));return o}function dn(s,e,t){let{
fields:o,place:n}=Te.models.Scenario;if(!ce(s))return D(t,"",s,"table"),null;let i=Object.keys(s).find(r=>!Object.hasOwn(o,r));if(i!==void 0)return t.said.push(
Nt(n,i,Object.keys(o))),null;let a=Object.fromEntries(Object.keys(o).map(r=>{let l=Object.hasOwn(s,r)?s[r]:Te.default[r];return[r,vr(r,l,e,t)]}));return t.said.
length?null:kr(t,()=>pn(a,e))}function vr(s,e,t,o){if(s==="hoop")return jt("Hoop",e,s,o,i=>hn(i,t));if(s==="plane")return jt("Plane",e,s,o,dr);if(s==="start")return jt(
"Start",e,s,o,pr);if(s!=="contact")return Xo(Te.models.Scenario.fields[s],e,s,o);let n=en(e,"model",Fc,s,o,"rigid");return n&&jt(n,e,s,o,mr)}function pn(s,e){return fr(
s,e,te),s}function jt(s,e,t,o,n){let i=Lt(s,e,t,o);return i&&kr(o,()=>n(i))}function kr(s,e){try{return e()}catch(t){if(!(t instanceof He))throw t;return s.said.
push(t.message),null}}function mn(s,e){return un(gr(s),e,Le(()=>!0))}function Js(s,e,t){let o=an(s,Se(s),e,(n,i)=>_r(n,t,i));return un(o,t,Le(nn([...e.keys()])))}
function Ys(s,e,t){let o=Le();try{let n=an(s,Se(s),e,(r,l)=>_r(r,t,l)),a=[...new Set([...e.keys()].map(r=>r.split(".")[0]))].map(r=>[r,vr(r,n[r],t,o)]);return o.
said.length?null:Object.fromEntries(a)}catch(n){if(n instanceof L)return null;throw n}}function _r(s,e,t){let o=Le(t),n=jt("Hoop",s,"hoop",o,i=>hn(i,e));if(!n)throw new L(
Ct(o.said));return n}var Wc=s=>s===1/0?"inf":s,Dt=(s,e)=>Object.fromEntries(e.filter(t=>s[t]!==null).map(t=>[t,Wc(s[t])])),fn=s=>Object.keys(Te.models[s].fields);
function Se({duration:s,hoop:e,plane:t,start:o,contact:n}){return{duration:s,hoop:$c(e),plane:Bc(t),start:Hc(o),contact:Dt(n,fn(n.model==="rigid"?"Rigid":"Compl\
iant"))}}function $c(s){if(s.parts){let t=s.parts.map(o=>Dt(o,fn(Te.parts[o.shape])));return{radius:s.radius,parts:t}}let e=s.load_fraction===null?["eccentricit\
y","inertia_ratio"]:["load_fraction"];return Dt(s,["radius","mass",...e])}function Bc(s){let e=s.apart?["mu"]:["mu_static","mu_kinetic"];return s.rolling_resistance===
0&&e.push("rolling_resistance"),Dt(s,fn("Plane").filter(t=>!e.includes(t)))}function Hc(s){return Dt(s,s.speed===null?["x","height","angle","vx","vy","omega"]:[
"x","angle","speed"])}function gn(s,e){let{Hoop:t,Start:o}=Te.models;if(s==="hoop"){let{radius:n,mass:i,eccentricity:a}=t.fields;return{radius:n.default,mass:i.
default,load_fraction:a.default}}return s==="plane"?Te.default.plane:s==="start"?{...yr(o),speed:void 0}:yr(Te.models[e==="compliant"?"Compliant":"Rigid"])}var yr=({
fields:s})=>Object.fromEntries(Object.entries(s).map(([e,t])=>[e,t.default??void 0]));function Wt(s){let e={};for(let[t,o]of Object.entries(Se(s))){let n=Te.default[t];
if(Ft(o,n))continue;if(!ce(o)){e[t]=o;continue}let i=gn(t,o.model),a=Object.entries(o).filter(([r,l])=>r==="model"||!Ft(i[r],l));e[t]=a.length?Object.fromEntries(
a):o}return wr(e)}function Ft(s,e){if(s===e)return!0;if(s===null||e===null||typeof s!="object"||typeof e!="object")return!1;let t=Object.keys(s);return t.length===
Object.keys(e).length&&t.every(o=>Ft(s[o],e[o]))}var Uc=8,{cell:wn,laws:Gc,quantities:xr}=A.map;async function bn(s,{x:e,y:t},o,n){let i=qt(e),a=qt(t),r=Kc(s,e.path,t.path)?Vc(s,{x:e,y:t},[i,a],o):(d,m)=>{let g=new Map(
[[t.path,a[m]],[e.path,i[d]]]);return Ys(s,g,o)},l=i.length*a.length,c=new Float64Array(wn.length*l),u={...s},h=performance.now();for(let d=0;d<a.length;d++){performance.
now()-h>Uc&&(await new Promise(m=>setTimeout(m)),n?.throwIfAborted(),h=performance.now());for(let m=0;m<i.length;m++){let g=r(m,d),f=g&&Yc(Object.assign(u,g),o);
if(!f)continue;let w=d*i.length+m;for(let b=0;b<wn.length;b++)c[b*l+w]=Jc[b](f)}}return{count:l,rows:c}}function Kc({start:s},e,t){let o=[e,t].map(i=>i.split(".")[0]);
if(o[0]===o[1])return!1;let n=[e,t].some(i=>i.startsWith("start.")&&i!=="start.speed");return!(o.includes("hoop")&&n&&s.speed!==null)}function Vc(s,{x:e,y:t},[o,
n],i){let a=o.map(l=>Ys(s,new Map([[e.path,l]]),i)),r=n.map(l=>Ys(s,new Map([[t.path,l]]),i));return(l,c)=>a[l]&&r[c]&&{...a[l],...r[c]}}var Jc=wn.map(s=>s==="l\
aw"?({impact_law:e})=>Gc[e]:s==="strike"?({painleve:e})=>+(e==="impact"):s==="allowed"?()=>1:e=>Number(e[s]));function Yc(s,e){try{return te(pn(s,e))}catch(t){if(!(t instanceof
He))throw t;return null}}var yn=s=>xr[s].span;function vn({x:s,y:e,what:t},o){let{label:n,unit:i,words:a}=xr[t],{values:r,names:l}=Zc(o,i===""?a:null),c=i===""?
l.map(u=>({name:u,text:Wa(u,t),color:Fa(u,t)})):null;return{header:{x:s,y:e,what:t,label:n,unit:i,classes:c},arrays:{values:r}}}function Zc({values:s,sequences:e},t){
if(!t)return{values:s,names:[]};let o=e?[...e].sort((a,r)=>a.length-r.length||(a<r?-1:a>r?1:0)):t,n=e?.map(a=>o.indexOf(a));return{values:Float64Array.from(s,a=>a>=
0?n?.[a]??a:Number.NaN),names:o}}var{scenario:Qs}=A,Qc=30;function Tr(s,e){for(let t of Qs.sections[s]??["Scenario"]){let o=Qs.models[t].fields[e];if(o)return o.unit}return""}function Mr(s,e){return e===
"inf"?"inf":typeof e=="string"?JSON.stringify(e):Vs(s,e)}function Sr(s,e,t){let o=`${s} = ${Mr(s,e)}`;return t===""||t==="1"?o:`${o.padEnd(Qc)} # ${t}`}function Xs(s){
let{duration:e,...t}=Se(s),o=[Sr("duration",e,Tr("","duration"))];for(let[n,i]of Object.entries(t)){o.push("",`[${n}]`);for(let[a,r]of Object.entries(i))if(!Array.
isArray(r))o.push(Sr(a,r,Tr(n,a)));else{o.push(`${a} = [`);for(let l of r){let c=Object.entries(l).map(([u,h])=>`${u} = ${Mr(u,h)}`);o.push(`  { ${c.join(", ")}\
 },`)}o.push("]")}}return`${o.join(`
`)}
`}var Xc={hoop:"Hoop",plane:"Plane",start:"Start"},eu=["load_fraction","mu"];function kn(s){let e=Se(s),t=Ft(e.contact,Qs.default.contact)?"":`    contact=${Zs(
"contact",e.contact)},
`;return[`import hophoop as hh

`,`motion = hh.simulate(
`,`    ${Zs("hoop",e.hoop)},
`,`    ${Zs("plane",e.plane)},
`,`    ${Zs("start",e.start)},
`,`    duration=${_n("duration",e.duration)},
`,t,`)
`,`print(motion.sequence, motion.status)
`,`for event in motion.events:
`,`    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")
`].join("")}function Zs(s,{parts:e,...t}){let o=s==="start"&&"speed"in t,n=o?"Start.rolling":Xc[s]??(t.model==="rigid"?"Rigid":"Compliant"),i=o?{angle:0,x:0}:gn(
s,t.model),a=Object.entries(t).filter(([r,l])=>eu.includes(r)||i[r]!==l).map(([r,l])=>`${r}=${_n(r,l)}`);return e&&a.push(`parts=[${e.map(tu).join(", ")}]`),`hh\
.${n}(${a.join(", ")})`}function tu({shape:s,...e}){let t=Object.entries(e).map(([o,n])=>`${o}=${_n(o,n)}`);return`hh.${Qs.parts[s]}(${t.join(", ")})`}function _n(s,e){
return e==="inf"?'float("inf")':typeof e=="string"?he(e):Vs(s,e)}var{letters:Ar,modes:Tn,verbs:Sn,events:su,statuses:ou,story:Ue,summary:ct}=A.words,nu=["turn","apex","end"],iu=400,[,xn,Er,au,ru]=Tn,lu="⁰¹²³⁴⁵⁶⁷⁸⁹";
function Rr(s,e){let{omega:t,to:o}=s[e];return t===0&&(o==="S"||o==="K")&&e+1<s.length}var Mn=s=>[...s.keys()].filter(e=>Rr(s,e)),En=(s,e)=>.5*(s[e].t+s[e+1].t);
function An(s,e=iu){let t=[],o=0,n=zr(s.events);for(let[i,a]of s.events.entries()){let r=n.get(i);if(r===0)continue;let l=r===void 0?cu(s,i,a):j(Ue.more_bounces,
{count:r});if(l){if(t.length>=e){o++;continue}t.push({t:a.t,event:i,mode:Ar[Tn.indexOf(eo(s,i))],text:l})}}return o&&t.push({...t[t.length-1],text:j(Ue.left_out,
{count:o})}),t}var Pr=s=>s.kind==="impact"&&s.to==="H"&&s.collision!==!1;function zr(s,e=3,t=6){let o=new Map,n=[];for(let i=0;i<=s.length;i++){let a=s[i];if(a&&
(Pr(a)||n.length&&a.kind==="apex")){n.push(i);continue}let r=n.filter(l=>s[l].kind==="impact");if(r.length>=t){for(let l of n.slice(n.indexOf(r[e])))o.set(l,0);
o.set(r[e],r.length-e)}n=[]}return o}function Rn(s,e=6){let t=[],o=0,n=zr(s.events,1);for(let[l,c]of s.events.entries()){let u=n.get(l);if(u!==void 0){u&&t.push(
j(ct.more_bounces,{count:u}));continue}if(c.kind==="start"||!t.length){t.push(Sn[eo(s,l)]);continue}let h=hu(s,l,c);h&&(o++,o<=e&&t.push(j(ct.change,{phrase:h,where:Ke(
c.angle)})))}let i=o>e?j(ct.more_changes,{count:o-e}):"",a=t.join(", ").replaceAll(", and "," and ")+i,r={phrases:a.slice(0,1).toUpperCase()+a.slice(1),ending:ou[s.
status]};return j(ct.sentence,r).trim()}function hu(s,e,t){return t.collision===!1?ct.without_collision:Pr(t)?ct.bounces:["slip_start","slip_reversal"].includes(
t.kind)||Ir(t)?Sn[eo(s,e)]:nu.includes(t.kind)?"":su[t.kind]}function cu(s,e,t){let o=eo(s,e),n={where:Ke(t.angle),verb:Sn[o],kind:t.kind.replaceAll("_"," ")},i=uu(
s.events,e,o,n);return j(Ue[i]??Ue.other,n)}function uu(s,e,t,o){let n=s[e],{kind:i}=n;return i==="start"&&(o.speed=Ge(n.vx),o.started=j(t===au?Ue.started_flight:
t===ru?Ue.started_skim:Ue.started,o)),i==="slip_start"&&t===xn?"slip_start_spin":i==="takeoff"?du(s,e,o):i==="impact"?(o.speed=Ge(n.before.vy===null?null:Math.abs(
n.before.vy)),n.collision===!1?"impact_without_collision":n.to==="H"?"impact_bounce":i):i==="turn"&&Ir(n)?"turn_in_slip":(i==="apex"&&(o.gap=Lr(n.height)),i==="\
kane_gain"&&(o.gain=Ge(n.gain)),i==="rest"&&n.stable===!1?"rest_unstable":i)}function du(s,e,t){let{t:o}=s[e],n=0;for(let i=e;i<s.length;i++)if(n=Math.max(n,s[i].
height),!(i===e||s[i].kind!=="impact")){for(let a=i+1;a<s.length&&s[a].t<=s[i].t;a++)n=Math.max(n,s[a].height);if(!n)break;return t.top=Lr(n),t.time=Ge(s[i].t-o),
"takeoff_and_landing"}return"takeoff"}function eo(s,e){let t=s.events[e];return pu(t.to,Rr(s.events,e)?s.omega(e):t.omega)}function pu(s,e){return s==="S"?e>0?xn:
Er:s==="K"?e<0?xn:Er:Tn[Ar.indexOf(s)]}var Ir=s=>s.kind==="turn"&&(s.to==="S"||s.to==="K"),Ke=s=>`${Qo(s*(180/Math.PI),1)}°`.replaceAll("-","−");function Lr(s){
return s>=.995?`${Ge(s)} m`:s>=.00995?`${Ge(s*100)} cm`:`${Ge(s*1e3)} mm`}function Ge(s){if(s===null||Number.isNaN(s))return"?";let[e,t]=xe(s,3).split("e"),o=t===
void 0?"":`·10${mu(Number(t))}`;return`${e}${o}`.replaceAll("-","−")}var mu=s=>[...String(s)].map(e=>e==="-"?"⁻":lu[Number(e)]).join("");var Nr=2e3,fu=s=>s===1/0?"inf":s;function to(s,{status:e,sequence:t,events:o,final:n,energy:i}){let{schema:a,setup:r}=A;return{schema:a,version:r.version,scenario:Se(
s),status:e,sequence:t,events:o,final:n,energy:i}}function Pn(s,e,t,o){let n={events:e.events,status:e.status,omega:t};return{...to(s,e),events:e.events.slice(0,
Nr),query:Wt(s),duration:e.duration,values:gu(s),automatic:wu(s,o),massless:s.hoop.inertia_ratio===0,summary:Rn(n),story:An(n),ending:A.words.statuses[e.status],
shortened:e.events.length>Nr}}function gu(s){let{speed:e}=s.start,t={...s,start:{...Ie(s.start,s.hoop.radius),speed:e}},o=n=>{let[i,a]=n.split(".");return fu(t[i][a])};
return Object.fromEntries(A.shown.map(n=>[n,o(n)]))}function wu(s,e){if(s.contact.model==="rigid"||!e.compliance)return{};let{stiffness:t,slip_speed:o}=e.compliance(
te(s)).automatic;return{"contact.stiffness":t,"contact.slip_speed":o,"contact.restitution":s.plane.restitution}}var{rate:bu,variables:zn}=A.table,{letters:yu}=A.words,In=(s,e)=>JSON.stringify(to(s,e),null,1);function Ln(s){let e=Math.min(Math.max(Math.floor(s*bu)+1,2),A.limits.
samples),t=s/(e-1);return Float64Array.from({length:e},(o,n)=>n===e-1?s:n*t)}function Nn(s,e){let t=Object.keys(zn),o=t.map(l=>zn[l]==="1"?l:`${l} [${zn[l]}]`),
{kinetic:n,potential:i}=e,a={...e,total:Float64Array.from(n,(l,c)=>l+i[c])},r=[["t [s]",...o].join(",")];for(let[l,c]of s.entries()){let u=t.map(h=>h==="mode"?yu[a.
mode[l]]:$e(a[h][l]));r.push([$e(c),...u].join(","))}return`${r.join(`\r
`)}\r
`}var{calls:vu,regions:Or,map:ku}=A,_u={samples:{window:{read:xu}},regions:{window:{read:Tu,usual:Or.usual}},map:{x:{read:Cr},y:{read:Cr},what:{read:Mu,usual:"seq\
uence"}}};function qr(s,e){let t=vu[s],o=Object.keys(e).find(n=>!t.includes(n));return o===void 0?null:Nt("",o,t)}function jr(s,e,t){let o={};for(let[n,{read:i,
usual:a}]of Object.entries(_u[s]??{}))Object.hasOwn(e,n)?o[n]=i(e[n],n,t):a===void 0?t.said.push(N("missing",{path:n})):o[n]=a;return o}function Dr(s,e,t,o,n){if(!Array.
isArray(s)||s.length!==o)return Be(t,e,s,n);let i=t.said.length;return s.forEach((a,r)=>{typeof a!="number"?D(t,`${e}.${r}`,a,"number"):Number.isFinite(a)||D(t,
`${e}.${r}`,a,"finite_number")}),t.said.length===i?s:null}function xu(s,e,t){let o=Dr(s,e,t,2,F("times"));return o&&!(o[0]>=0&&o[0]<o[1])&&Be(t,e,s,F("times")),
o}function Tu(s,e,t){let o=Dr(s,e,t,4,F("window"));if(!o)return null;let[n,i,a,r]=o,l=o.every(c=>Math.abs(c)<Or.widest);return n<i&&a<r&&l||Be(t,e,s,F("window")),
o}function Cr(s,e,t){return Lt("Axis",s,e,t,{number_path:Su})?.values??null}function Su(s,e,t){if(typeof s!="string")return D(t,e,s,"word");let o=ir(s);return o?
t.said.push(o):ar(s)||Be(t,e,s,F("number_path")),s}function Mu(s,e,t){if(typeof s!="string")return D(t,e,s,"word");let o=Object.keys(ku.quantities);return o.includes(
s)||Be(t,e,s,F("one_of",{known:o.join(", ")})),s}var{limits:so}=A;function oo(s,e,t){let o=qr(s,e);if(o)throw new L(o);let{scenario:n,query:i=null,changes:a=[]}=e,r=Le(),l=null;n!==void 0&&!ce(n)?D(r,"scenario",
n,"table"):n!==void 0&&(l=dn(n,t,{...r,above:"scenario."})),i!==null&&typeof i!="string"&&D(r,"query",i,"word"),Array.isArray(a)?r.said.push(...a.filter(h=>!Au(
h)).map(Ru)):D(r,"changes",a,"list");let c=jr(s,e,r);if(r.said.length)throw new L(Ct(r.said));Eu(a.length,c),(i!==null||!l)&&(l=mn(i??"",t));let u=new Map;for(let[
h,d]of a)Ot([...u.keys(),h])&&(l=Js(l,u,t),u=new Map),u.set(h,d);return{...c,checked:u.size?Js(l,u,t):l}}var Cn=(s,e)=>oo("film",s,e).checked;function Eu(s,{x:e,
y:t}){if(s>so.changes)throw new se(F("too_many_changes",{pairs:s,most:so.changes}));if(!e)return;if(e.path===t.path)throw new L(F("equal_axes",{path:e.path}));let o=e.
cells*t.cells;if(o>so.cells)throw new se(F("too_many_cells",{cells:o,most:so.cells}))}var Au=s=>Array.isArray(s)&&s.length===2&&typeof s[0]=="string",Ru=s=>F("n\
ot_a_pair",{change:new We(It(s).slice(0,60))});var{theory:H}=A.words;function qn({hoop:s,plane:e},t){let o=[],n=(r,l,c,u)=>{l!==null&&o.push({key:r,label:H[r],value:Number.isFinite(l)?l:null,unit:c,text:u(l)})},
i=()=>n("painleve",t.painleve_friction,"1",r=>zu(r,t,e));if(e.gravity<=0)return i(),o;if(s.inertia_ratio===0){let r=t.massless_loss_by_friction?H.loss_by_friction:
H.loss_of_contact;return n("loss",t.massless_loss_angle,"rad",l=>j(r,{where:Ke(l)})),o}if(e.slope>=0){let{would_slip:r,would_hop:l,would_hop_at_once:c,any_push:u,
any_speed:h}=H;n("first_slip",t.first_slip_speed,"m/s",d=>On(d,r,u)),n("first_hop",t.first_hop_speed,"m/s",d=>On(d,l,u)),n("immediate_hop",t.immediate_hop_speed,
"m/s",d=>On(d,c,h))}else o.push({key:"uphill",label:H.uphill,value:null,unit:"",text:H.no_threshold});n("needed_friction",t.needed_friction,"1",r=>Pu(r,e)),i();
let a=t.jam_angles.map(Ke).join(", ");return n("jam",t.jam_angles[0]??null,"rad",()=>j(H.jam_at,{places:a})),s.eccentricity>0&&n("rest",t.stable_angle,"rad",r=>j(
H.rest_at,{where:Ke(r)})),o}function On(s,e,t){return s<A.words.least_speed?j(t,{would:e}):Number.isFinite(s)?j(H.above,{would:e,speed:xe(s,4)}):H.no_speed}function Pu(s,{
mu_static:e}){return Number.isFinite(s)?j(s<=e?H.friction_enough:H.friction_short,{mu:xe(s,3)}):H.no_friction}function zu(s,{painleve_angle:e},{mu_kinetic:t}){if(e===
null)return H.never;let o=s<=t?H.paradox_here:H.paradox_not_here;return j(o,{mu:xe(s,3),where:Ke(e)})}var Lu=360,Nu=240,jn={"motion.toml":"application/toml","motion.csv":"text/csv; charset=utf-8","motion.json":"application/json"},Cu=["motion.nc","motion.mp4","mo\
tion.gif"],$t=class{constructor(e,t,{base:o=null,server:n=null}={}){this.kernel=e,this.mechanics=t,this.base=o,this.server=n,this.shares=o!==null,this.files=[...Object.
keys(jn),...n?Cu:[]]}async call(e,t,o){if(o?.throwIfAborted(),e==="setup")return{header:A.setup,arrays:{}};let{checked:n,...i}=oo(e,t,this.mechanics);if(e==="fi\
lm")return this.film(n,o);if(e==="samples"){let a=te(lt(n)),{window:r}=i;return{header:{window:r},arrays:await this.kernel.columns(a,o,r)}}if(e==="code")return{
header:{python:kn(n),toml:Xs(n)},arrays:{}};if(e==="theory"){let a=await this.kernel.thresholds(te(n),o);return{header:{thresholds:qn(n,a)},arrays:{}}}if(e==="r\
egions"){let{window:a}=i,r=te(n),l=await this.kernel.regions(r,a,Lu,Nu,o);return{header:{window:a},arrays:l}}if(e==="map")return this.map(n,i,o);throw new TypeError(
`The page does not answer ${e}.`)}async film(e,t){let o=te(lt(e)),{motion:n,columns:i}=this.kernel.film?await this.kernel.film(o,t):{motion:await this.kernel.motion(
o,t),columns:await this.kernel.columns(o,t)},{doubt:a}=n;if(a!==null&&this.server)return this.server.call("film",{query:Wt(e)},t);let r=await this.turning(o,n,t),
l=Pn(e,n,r,this.mechanics);return{header:a===null?l:{...l,doubt:rn(a)},arrays:i}}async turning(e,{events:t},o){let n=Mn(t);if(!n.length)return()=>0;let i=Float64Array.
from(n,r=>En(t,r)),{omega:a}=await this.kernel.samples(e,i,o);return r=>a[n.indexOf(r)]}async map(e,{x:t,y:o,what:n},i){let a=yn(n),r=ln(e,{x:t,y:o,what:n}),l=await bn(
r,{x:t,y:o},this.mechanics,i);return vn({x:t,y:o,what:n},await this.kernel.map(l,n,a,i))}async file(e,t){if(!(e in jn)){if(this.server)return this.server.file(e,
t);throw new L(`${e} needs Python: run hophoop lab.`)}return new Blob([await this.fileText(e,t)],{type:jn[e]})}async fileText(e,t){let o=Cn({query:t},this.mechanics);
if(e==="motion.toml")return Xs(o);let n=lt(o),i=te(n),a=await this.kernel.motion(i);if(e==="motion.json")return In(n,a);let r=Ln(a.duration);return Nn(r,await this.
kernel.samples(i,r))}link(e,t){return this.base&&`${new URL(e?`?${e}`:"",this.base)}${t}`}};async function Dn(s,e,t){let o=e&&new fs(e);try{let n=await Rt.load(s);return new $t(n,n.mechanics,{base:t,server:o})}catch(n){if(o)return o;throw n}}function Fr(s){
navigator.serviceWorker?.register(s).catch(()=>{})}async function Wr(s){let e=new gs(s);try{let t=await Rt.unpack(s.get("module"),s.get("worker"));return new $t(
t,t.mechanics,{server:e})}catch{return e}}var Ou=new URL("./",import.meta.url);async function qu(s){let e=new URL("./",document.baseURI.split(/[?#]/)[0]),t=document.querySelector("meta[name=hophoop-site\
]"),o,n;try{o=await Dn(Ou,t?null:e,e),n=(await o.call("setup",{})).header}catch(l){s.textContent=l.message;return}t&&Fr(t.getAttribute("content")??"");let i=new it(
s,o,n,{hosted:!0});Object.assign(globalThis,{hophoopLab:i});let a=new URLSearchParams(location.hash.slice(1)).get("with"),r=ri(location.hash);try{await i.open([
location.search.slice(1),...a===null?[]:[a]],r)}catch(l){history.replaceState(null,"",e),await i.open([""]),i.notice.fail(l)}}async function sb(s,e,t,o){let n=await Dn(
e,null,new URL("../",e)),{header:i}=await n.call("setup",{}),a=new it(s,n,i,{panels:o});return await a.open([t]),a}async function ju({model:s,el:e}){let t=document.
createElement("div");e.append(t);let o=await Wr(s),n=new it(t,o,s.get("setup"),{panels:s.get("panels"),onmotion:a=>{s.get("query")!==a&&(s.set("query",a),s.save_changes())}});
n.motions.set([et(s.get("film"))]),n.begin();let i=()=>n.motions.replace(et(s.get("film")));return s.on("change:film",i),()=>{s.off("change:film",i),o.close?.(),
n.close()}}var $r=document.getElementById("hophoop-lab");$r&&qu($r);var ob={render:ju};export{dl as adopt,Ye as current,ob as default,yo as languageMenu,sb as mount,Kt as repeat,x as t,Je as untranslated};
