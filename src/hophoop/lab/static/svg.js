/* Built from web/lab/player/svg.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
var z=Object.create;var j=Object.defineProperty;var V=Object.getOwnPropertyDescriptor;var X=Object.getOwnPropertyNames;var B=Object.getPrototypeOf,Y=Object.prototype.hasOwnProperty;var $=(c,n)=>()=>{try{return n||c((n={exports:{}}).exports,n),n.exports}catch(u){throw n=0,u}};var J=(c,n,u,g)=>{if(n&&typeof n=="object"||typeof n=="function")for(let _ of X(n))!Y.call(c,_)&&_!==u&&j(c,_,{get:()=>n[_],enumerable:!(g=V(n,_))||g.enumerable});
return c};var H=(c,n,u)=>(u=c!=null?z(B(c)):{},J(n||!c||!c.__esModule?j(u,"default",{value:c,enumerable:!0}):u,c));var G=$(N=>{"use strict";Object.defineProperty(N,"__esModule",{value:!0});function R(c){return!c||typeof c=="string"?c:c+""}var O=class{async svg2canvas(n,u,g){
let _=await new Promise(S=>{var M=new Image;M.onload=function(){S(M)},M.src=n});var p=document.createElement("canvas");return p.width=u,p.height=g,p.getContext(
"2d").drawImage(_,0,0),p}toDataURL(n,u,g,_,p,b){var S=new XMLSerializer().serializeToString(n),M=document.documentMode;if(M){var C=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi;
C.test(S)&&(S=S.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink'))}b||(b={});var E="data:image/svg+xml;charset=utf-8,"+encodeURIComponent(
S);if(_==="image/svg+xml"||!_)return b.async?Promise.resolve(E):E;if(_==="image/jpeg"||_==="image/png"){if(!b.async)throw new Error("svgcanvas: options.async mu\
st be set to true if type is image/jpeg | image/png");return(async()=>{let t=await this.svg2canvas(E,u,g),e=t.toDataURL(_,p);return t.remove(),e})()}throw new Error(
"svgcanvas: Unknown type for toDataURL, please use image/jpeg | image/png | image/svg+xml.")}getImageData(n,u,g,_,p,b,S,M){if(M||(M={}),!M.async)throw new Error(
"svgcanvas: options.async must be set to true for getImageData");let C=this.toDataURL(n,u,g,"image/svg+xml");return(async()=>{let E=await this.svg2canvas(C,u,g),
e=E.getContext("2d").getImageData(_,p,b,S);return E.remove(),e})()}},U=new O;var L=(function(){var c,n,u,g,_;function p(t,e){var r=Object.keys(e),i;for(i=0;i<r.
length;i++)t=t.replace(new RegExp("\\{"+r[i]+"\\}","gi"),e[r[i]]);return t}function b(t){var e,r,i;if(!t)throw new Error("cannot create a random attribute name \
for an undefined object");e="ABCDEFGHIJKLMNOPQRSTUVWXTZabcdefghiklmnopqrstuvwxyz",r="";do for(r="",i=0;i<12;i++)r+=e[Math.floor(Math.random()*e.length)];while(t[r]);
return r}function S(t,e){var r,i,s={},a;for(t=t.split(","),e=e||10,r=0;r<t.length;r+=2)i="&"+t[r+1]+";",a=parseInt(t[r],e),s[i]="&#"+a+";";return s["\\xa0"]="&#\
160;",s}function M(t){var e={left:"start",right:"end",center:"middle",start:"start",end:"end"};return e[t]||e.start}function C(t){var e={alphabetic:"alphabetic",
hanging:"hanging",top:"text-before-edge",bottom:"text-after-edge",middle:"central"};return e[t]||e.alphabetic}_=S("50,nbsp,51,iexcl,52,cent,53,pound,54,curren,5\
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
p,rsquo,80q,sbquo,80s,ldquo,80t,rdquo,80u,bdquo,810,dagger,811,Dagger,81g,permil,81p,lsaquo,81q,rsaquo,85c,euro",32),c={strokeStyle:{svgAttr:"stroke",canvas:"#0\
00000",svg:"none",apply:"stroke"},fillStyle:{svgAttr:"fill",canvas:"#000000",svg:null,apply:"fill"},lineCap:{svgAttr:"stroke-linecap",canvas:"butt",svg:"butt",apply:"\
stroke"},lineJoin:{svgAttr:"stroke-linejoin",canvas:"miter",svg:"miter",apply:"stroke"},miterLimit:{svgAttr:"stroke-miterlimit",canvas:10,svg:4,apply:"stroke"},
lineWidth:{svgAttr:"stroke-width",canvas:1,svg:1,apply:"stroke"},globalAlpha:{svgAttr:"opacity",canvas:1,svg:1,apply:"fill stroke"},font:{canvas:"10px sans-seri\
f"},shadowColor:{canvas:"#000000"},shadowOffsetX:{canvas:0},shadowOffsetY:{canvas:0},shadowBlur:{canvas:0},textAlign:{canvas:"start"},textBaseline:{canvas:"alph\
abetic"},lineDash:{svgAttr:"stroke-dasharray",canvas:[],svg:null,apply:"stroke"}},u=function(t,e){this.__root=t,this.__ctx=e},u.prototype.addColorStop=function(t,e){
var r=this.__ctx.__createElement("stop"),i,s;r.setAttribute("offset",t),R(e).indexOf("rgba")!==-1?(i=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
s=i.exec(e),r.setAttribute("stop-color",p("rgb({r},{g},{b})",{r:s[1],g:s[2],b:s[3]})),r.setAttribute("stop-opacity",s[4])):r.setAttribute("stop-color",R(e)),this.
__root.appendChild(r)},g=function(t,e){this.__root=t,this.__ctx=e},n=function(t){var e={width:500,height:500,enableMirroring:!1},r;if(arguments.length>1?(r=e,r.
width=arguments[0],r.height=arguments[1]):t?r=t:r=e,!(this instanceof n))return new n(r);this.width=r.width||e.width,this.height=r.height||e.height,this.enableMirroring=
r.enableMirroring!==void 0?r.enableMirroring:e.enableMirroring,this.canvas=this,this.__document=r.document||document,r.ctx?this.__ctx=r.ctx:(this.__canvas=this.
__document.createElement("canvas"),this.__ctx=this.__canvas.getContext("2d")),this.__setDefaultStyles(),this.__styleStack=[this.__getStyleState()],this.__groupStack=
[],this.__root=this.__document.createElementNS("http://www.w3.org/2000/svg","svg"),this.__root.setAttribute("version",1.1),this.__root.setAttribute("xmlns","htt\
p://www.w3.org/2000/svg"),this.__root.setAttributeNS("http://www.w3.org/2000/xmlns/","xmlns:xlink","http://www.w3.org/1999/xlink"),this.__root.setAttribute("wid\
th",this.width),this.__root.setAttribute("height",this.height),this.__ids={},this.__defs=this.__document.createElementNS("http://www.w3.org/2000/svg","defs"),this.
__root.appendChild(this.__defs),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.resetTransform(),this.__options=r,this.__id=Math.random().toString(16).substring(2,8),this.__debug("new",t)},n.prototype.__debug=function(...t){this.__options.
debug&&console.debug(`svgcanvas#${this.__id}:`,...t)},n.prototype.__createElement=function(t,e,r){typeof e>"u"&&(e={});var i=this.__document.createElementNS("ht\
tp://www.w3.org/2000/svg",t),s=Object.keys(e),a,o;for(r&&(i.setAttribute("fill","none"),i.setAttribute("stroke","none")),a=0;a<s.length;a++)o=s[a],i.setAttribute(
o,e[o]);return i},n.prototype.__setDefaultStyles=function(){var t=Object.keys(c),e,r;for(e=0;e<t.length;e++)r=t[e],this[r]=c[r].canvas},n.prototype.__applyStyleState=
function(t){var e=Object.keys(t),r,i;for(r=0;r<e.length;r++)i=e[r],this[i]=t[i]},n.prototype.__getStyleState=function(){var t,e={},r=Object.keys(c),i;for(t=0;t<
r.length;t++)i=r[t],e[i]=this[i];return e},n.prototype.__applyTransformation=function(t,e){let{a:r,b:i,c:s,d:a,e:o,f:h}=e||this.getTransform();t.setAttribute("t\
ransform",`matrix(${r} ${i} ${s} ${a} ${o} ${h})`)},n.prototype.__applyStyleToCurrentElement=function(t){var e=this.__currentElement,r=this.__currentElementsToStyle;
r&&(e.setAttribute(t,""),e=r.element,r.children.forEach(function(T){T.setAttribute(t,"")}));var i=Object.keys(c),s,a,o,h,l,d,f,m;for(s=0;s<i.length;s++)if(a=c[i[s]],
o=this[i[s]],a.apply){if(o instanceof g){if(o.__ctx)for(f=0;f<o.__ctx.__defs.childNodes.length;f++)m=o.__ctx.__defs.childNodes[f],d=m.getAttribute("id"),this.__ids[d]=
d,this.__defs.appendChild(m);e.setAttribute(a.apply,p("url(#{id})",{id:o.__root.getAttribute("id")}))}else if(o instanceof u)e.setAttribute(a.apply,p("url(#{id}\
)",{id:o.__root.getAttribute("id")}));else if(a.apply.indexOf(t)!==-1&&a.svg!==o)if((a.svgAttr==="stroke"||a.svgAttr==="fill")&&o&&o.indexOf("rgba")!==-1){h=/rgba\(\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\s*,\s*(\d?\.?\d*)\s*\)/gi,
l=h.exec(o),e.setAttribute(a.svgAttr,p("rgb({r},{g},{b})",{r:l[1],g:l[2],b:l[3]}));var y=l[4],w=this.globalAlpha;w!=null&&(y*=w),e.setAttribute(a.svgAttr+"-opac\
ity",y)}else{var v=a.svgAttr;if(i[s]==="globalAlpha"){if(v=t+"-"+a.svgAttr,e.getAttribute(v))continue}else if(i[s]==="lineWidth"){var x=this.__getTransformScale();
o=o*Math.max(x.x,x.y)}e.setAttribute(v,o)}}},n.prototype.__closestGroupOrSvg=function(t){return t=t||this.__currentElement,t.nodeName==="g"||t.nodeName==="svg"?
t:this.__closestGroupOrSvg(t.parentNode)},n.prototype.getSerializedSvg=function(t){var e=new XMLSerializer().serializeToString(this.__root),r,i,s,a,o,h;if(h=/xmlns="http:\/\/www\.w3\.org\/2000\/svg".+xmlns="http:\/\/www\.w3\.org\/2000\/svg/gi,
h.test(e)&&(e=e.replace('xmlns="http://www.w3.org/2000/svg','xmlns:xlink="http://www.w3.org/1999/xlink')),t)for(r=Object.keys(_),i=0;i<r.length;i++)s=r[i],a=_[s],
o=new RegExp(s,"gi"),o.test(e)&&(e=e.replace(o,a));return e},n.prototype.getSvg=function(){return this.__root},n.prototype.save=function(){var t=this.__createElement(
"g"),e=this.__closestGroupOrSvg();this.__groupStack.push(e),e.appendChild(t),this.__currentElement=t;let r=this.__getStyleState();this.__debug("save style",r),this.
__styleStack.push(r),this.__transformMatrixStack||(this.__transformMatrixStack=[]),this.__transformMatrixStack.push(this.getTransform())},n.prototype.restore=function(){
this.__currentElement=this.__groupStack.pop(),this.__currentElementsToStyle=null,this.__currentElement||(this.__currentElement=this.__root.childNodes[1]);var t=this.
__styleStack.pop();this.__debug("restore style",t),this.__applyStyleState(t),this.__transformMatrixStack&&this.__transformMatrixStack.length>0&&this.setTransform(
this.__transformMatrixStack.pop())},n.prototype.beginPath=function(){var t,e;this.__currentDefaultPath="",this.__currentPosition={},t=this.__createElement("path",
{},!0),e=this.__closestGroupOrSvg(),e.appendChild(t),this.__currentElement=t},n.prototype.__applyCurrentDefaultPath=function(){var t=this.__currentElement;t.nodeName===
"path"?t.setAttribute("d",this.__currentDefaultPath):console.error("Attempted to apply path command to node",t.nodeName)},n.prototype.__addPathCommand=function(t){
this.__currentDefaultPath+=" ",this.__currentDefaultPath+=t},n.prototype.moveTo=function(t,e){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.__currentPosition=
{x:t,y:e},this.__addPathCommand(p("M {x} {y}",{x:this.__matrixTransform(t,e).x,y:this.__matrixTransform(t,e).y}))},n.prototype.closePath=function(){this.__currentDefaultPath&&
this.__addPathCommand("Z")},n.prototype.lineTo=function(t,e){this.__currentPosition={x:t,y:e},this.__currentDefaultPath.indexOf("M")>-1?this.__addPathCommand(p(
"L {x} {y}",{x:this.__matrixTransform(t,e).x,y:this.__matrixTransform(t,e).y})):this.__addPathCommand(p("M {x} {y}",{x:this.__matrixTransform(t,e).x,y:this.__matrixTransform(
t,e).y}))},n.prototype.bezierCurveTo=function(t,e,r,i,s,a){this.__currentPosition={x:s,y:a},this.__addPathCommand(p("C {cp1x} {cp1y} {cp2x} {cp2y} {x} {y}",{cp1x:this.
__matrixTransform(t,e).x,cp1y:this.__matrixTransform(t,e).y,cp2x:this.__matrixTransform(r,i).x,cp2y:this.__matrixTransform(r,i).y,x:this.__matrixTransform(s,a).
x,y:this.__matrixTransform(s,a).y}))},n.prototype.quadraticCurveTo=function(t,e,r,i){this.__currentPosition={x:r,y:i},this.__addPathCommand(p("Q {cpx} {cpy} {x}\
 {y}",{cpx:this.__matrixTransform(t,e).x,cpy:this.__matrixTransform(t,e).y,x:this.__matrixTransform(r,i).x,y:this.__matrixTransform(r,i).y}))};var E=function(t){
var e=Math.sqrt(t[0]*t[0]+t[1]*t[1]);return[t[0]/e,t[1]/e]};return n.prototype.arcTo=function(t,e,r,i,s){var a=this.__currentPosition&&this.__currentPosition.x,
o=this.__currentPosition&&this.__currentPosition.y;if(!(typeof a>"u"||typeof o>"u")){if(s<0)throw new Error("IndexSizeError: The radius provided ("+s+") is nega\
tive.");if(a===t&&o===e||t===r&&e===i||s===0){this.lineTo(t,e);return}var h=E([a-t,o-e]),l=E([r-t,i-e]);if(h[0]*l[1]===h[1]*l[0]){this.lineTo(t,e);return}var d=h[0]*
l[0]+h[1]*l[1],f=Math.acos(Math.abs(d)),m=E([h[0]+l[0],h[1]+l[1]]),y=s/Math.sin(f/2),w=t+y*m[0],v=e+y*m[1],x=[-h[1],h[0]],T=[l[1],-l[0]],k=function(D){var I=D[0],
F=D[1];return F>=0?Math.acos(I):-Math.acos(I)},P=k(x),q=k(T);this.lineTo(w+x[0]*s,v+x[1]*s),this.arc(w,v,s,P,q)}},n.prototype.stroke=function(){this.__currentElement.
nodeName==="path"&&this.__currentElement.setAttribute("paint-order","fill stroke markers"),this.__applyCurrentDefaultPath(),this.__applyStyleToCurrentElement("s\
troke")},n.prototype.fill=function(){this.__currentElement.nodeName==="path"&&this.__currentElement.setAttribute("paint-order","stroke fill markers"),this.__applyCurrentDefaultPath(),
this.__applyStyleToCurrentElement("fill")},n.prototype.rect=function(t,e,r,i){this.__currentElement.nodeName!=="path"&&this.beginPath(),this.moveTo(t,e),this.lineTo(
t+r,e),this.lineTo(t+r,e+i),this.lineTo(t,e+i),this.lineTo(t,e),this.closePath()},n.prototype.roundRect=function(t,e,r,i,s){this.__currentElement.nodeName!=="pa\
th"&&this.beginPath();let a,o,h,l;typeof s=="number"?(a=s,o=s,h=s,l=s):[a,o,h,l]=s,this.moveTo(t+a,e),this.arcTo(t+r,e,t+r,e+i,o),this.arcTo(t+r,e+i,t,e+i,h),this.
arcTo(t,e+i,t,e,l),this.arcTo(t,e,t+r,e,a),this.closePath()},n.prototype.fillRect=function(t,e,r,i){let{a:s,b:a,c:o,d:h,e:l,f:d}=this.getTransform();JSON.stringify(
[s,a,o,h,l,d])===JSON.stringify([1,0,0,1,0,0])&&t===0&&e===0&&r===this.width&&i===this.height&&this.__clearCanvas();var f,m;f=this.__createElement("rect",{x:t,y:e,
width:r,height:i},!0),m=this.__closestGroupOrSvg(),m.appendChild(f),this.__currentElement=f,this.__applyTransformation(f),this.__applyStyleToCurrentElement("fil\
l")},n.prototype.strokeRect=function(t,e,r,i){var s,a;s=this.__createElement("rect",{x:t,y:e,width:r,height:i},!0),a=this.__closestGroupOrSvg(),a.appendChild(s),
this.__currentElement=s,this.__applyTransformation(s),this.__applyStyleToCurrentElement("stroke")},n.prototype.__clearCanvas=function(){var t=this.__root.childNodes[1];
this.__root.removeChild(t),this.__currentElement=this.__document.createElementNS("http://www.w3.org/2000/svg","g"),this.__root.appendChild(this.__currentElement),
this.__groupStack=[]},n.prototype.clearRect=function(t,e,r,i){let{a:s,b:a,c:o,d:h,e:l,f:d}=this.getTransform();if(JSON.stringify([s,a,o,h,l,d])===JSON.stringify(
[1,0,0,1,0,0])&&t===0&&e===0&&r===this.width&&i===this.height){this.__clearCanvas();return}var f,m=this.__closestGroupOrSvg();f=this.__createElement("rect",{x:t,
y:e,width:r,height:i,fill:"#FFFFFF"},!0),this.__applyTransformation(f),m.appendChild(f)},n.prototype.createLinearGradient=function(t,e,r,i){var s=this.__createElement(
"linearGradient",{id:b(this.__ids),x1:t+"px",x2:r+"px",y1:e+"px",y2:i+"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(s),new u(s,this)},
n.prototype.createRadialGradient=function(t,e,r,i,s,a){var o=this.__createElement("radialGradient",{id:b(this.__ids),cx:i+"px",cy:s+"px",r:a+"px",fx:t+"px",fy:e+
"px",gradientUnits:"userSpaceOnUse"},!1);return this.__defs.appendChild(o),new u(o,this)},n.prototype.__applyText=function(t,e,r,i){var s=document.createElement(
"span");s.setAttribute("style","font:"+this.font);var a=s.style,o=this.__closestGroupOrSvg(),h=this.__createElement("text",{"font-family":a.fontFamily,"font-siz\
e":a.fontSize,"font-style":a.fontStyle,"font-weight":a.fontWeight,"text-decoration":this.__fontUnderline,x:e,y:r,"text-anchor":M(this.textAlign),"dominant-basel\
ine":C(this.textBaseline)},!0);if(h.appendChild(this.__document.createTextNode(t)),this.__currentElement=h,this.__applyTransformation(h),this.__applyStyleToCurrentElement(
i),this.__fontHref){var l=this.__createElement("a");l.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",this.__fontHref),l.appendChild(h),h=l}o.appendChild(
h)},n.prototype.fillText=function(t,e,r){this.__applyText(t,e,r,"fill")},n.prototype.strokeText=function(t,e,r){this.__applyText(t,e,r,"stroke")},n.prototype.measureText=
function(t){return this.__ctx.font=this.font,this.__ctx.measureText(t)},n.prototype.arc=function(t,e,r,i,s,a){if(i!==s){i=i%(2*Math.PI),s=s%(2*Math.PI),i===s&&(s=
(s+2*Math.PI-.001*(a?-1:1))%(2*Math.PI));var o=t+r*Math.cos(s),h=e+r*Math.sin(s),l=t+r*Math.cos(i),d=e+r*Math.sin(i),f=a?0:1,m=0,y=s-i;y<0&&(y+=2*Math.PI),a?m=y>
Math.PI?0:1:m=y>Math.PI?1:0;var w=Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),v=Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d);
this.lineTo(l,d),this.__addPathCommand(p("A {rx} {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:r*w,ry:r*v,xAxisRotation:0,largeArcFlag:m,sweepFlag:f,
endX:this.__matrixTransform(o,h).x,endY:this.__matrixTransform(o,h).y})),this.__currentPosition={x:o,y:h}}},n.prototype.ellipse=function(t,e,r,i,s,a,o,h){if(a!==
o){var l=this.__matrixTransform(t,e);t=l.x,e=l.y;var d=this.__getTransformScale();r=r*d.x,i=i*d.y,s=s+this.__getTransformRotation(),a=a%(2*Math.PI),o=o%(2*Math.
PI),a===o&&(o=(o+2*Math.PI-.001*(h?-1:1))%(2*Math.PI));var f=t+Math.cos(-s)*r*Math.cos(o)+Math.sin(-s)*i*Math.sin(o),m=e-Math.sin(-s)*r*Math.cos(o)+Math.cos(-s)*
i*Math.sin(o),y=t+Math.cos(-s)*r*Math.cos(a)+Math.sin(-s)*i*Math.sin(a),w=e-Math.sin(-s)*r*Math.cos(a)+Math.cos(-s)*i*Math.sin(a),v=h?0:1,x=0,T=o-a;T<0&&(T+=2*Math.
PI),h?x=T>Math.PI?0:1:x=T>Math.PI?1:0;var k=this.__transformMatrix;this.resetTransform(),this.lineTo(y,w),this.__transformMatrix=k,this.__addPathCommand(p("A {r\
x} {ry} {xAxisRotation} {largeArcFlag} {sweepFlag} {endX} {endY}",{rx:r,ry:i,xAxisRotation:s*(180/Math.PI),largeArcFlag:x,sweepFlag:v,endX:f,endY:m})),this.__currentPosition=
{x:f,y:m}}},n.prototype.clip=function(){var t=this.__closestGroupOrSvg(),e=this.__createElement("clipPath"),r=b(this.__ids),i=this.__createElement("g");this.__applyCurrentDefaultPath(),
t.removeChild(this.__currentElement),e.setAttribute("id",r),e.appendChild(this.__currentElement),this.__defs.appendChild(e),t.setAttribute("clip-path",p("url(#{\
id})",{id:r})),t.appendChild(i),this.__currentElement=i},n.prototype.drawImage=function(){var t=Array.prototype.slice.call(arguments),e=t[0],r,i,s,a,o=0,h=0,l,d,
f,m,y,w,v,x,T,k;if(t.length===3)r=t[1],i=t[2],l=e.width,d=e.height,s=l,a=d;else if(t.length===5)r=t[1],i=t[2],s=t[3],a=t[4],l=e.width,d=e.height;else if(t.length===
9)o=t[1],h=t[2],l=t[3],d=t[4],r=t[5],i=t[6],s=t[7],a=t[8];else throw new Error("Invalid number of arguments passed to drawImage: "+arguments.length);f=this.__closestGroupOrSvg(),
this.__currentElement;let P=this.getTransform().translate(r,i);if(e instanceof n){if(m=e.getSvg().cloneNode(!0),m.childNodes&&m.childNodes.length>1){for(y=m.childNodes[0];y.
childNodes.length;)k=y.childNodes[0].getAttribute("id"),this.__ids[k]=k,this.__defs.appendChild(y.childNodes[0]);w=m.childNodes[1],w&&(this.__applyTransformation(
w,P),f.appendChild(w))}}else(e.nodeName==="CANVAS"||e.nodeName==="IMG")&&(v=this.__createElement("image"),v.setAttribute("width",s),v.setAttribute("height",a),v.
setAttribute("preserveAspectRatio","none"),(o||h||l!==e.width||d!==e.height)&&(x=this.__document.createElement("canvas"),x.width=s,x.height=a,T=x.getContext("2d"),
T.drawImage(e,o,h,l,d,0,0,s,a),e=x),this.__applyTransformation(v,P),v.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",e.nodeName==="CANVAS"?e.toDataURL():
e.getAttribute("src")),f.appendChild(v))},n.prototype.createPattern=function(t,e){var r=this.__document.createElementNS("http://www.w3.org/2000/svg","pattern"),
i=b(this.__ids),s;return r.setAttribute("id",i),r.setAttribute("width",t.width),r.setAttribute("height",t.height),r.setAttribute("patternUnits","userSpaceOnUse"),
t.nodeName==="CANVAS"||t.nodeName==="IMG"?(s=this.__document.createElementNS("http://www.w3.org/2000/svg","image"),s.setAttribute("width",t.width),s.setAttribute(
"height",t.height),s.setAttributeNS("http://www.w3.org/1999/xlink","xlink:href",t.nodeName==="CANVAS"?t.toDataURL():t.getAttribute("src")),r.appendChild(s),this.
__defs.appendChild(r)):t instanceof n&&(r.appendChild(t.__root.childNodes[1]),this.__defs.appendChild(r)),new g(r,this)},n.prototype.setLineDash=function(t){t&&
t.length>0?this.lineDash=t.join(","):this.lineDash=null},n.prototype.setTransform=function(t,e,r,i,s,a){t instanceof DOMMatrix?this.__transformMatrix=new DOMMatrix(
[t.a,t.b,t.c,t.d,t.e,t.f]):this.__transformMatrix=new DOMMatrix([t,e,r,i,s,a])},n.prototype.getTransform=function(){let{a:t,b:e,c:r,d:i,e:s,f:a}=this.__transformMatrix;
return new DOMMatrix([t,e,r,i,s,a])},n.prototype.resetTransform=function(){this.setTransform(1,0,0,1,0,0)},n.prototype.scale=function(t,e){if(e===void 0&&(e=t),
isNaN(t)||isNaN(e)||!isFinite(t)||!isFinite(e))return;let r=this.getTransform().scale(t,e);this.setTransform(r)},n.prototype.rotate=function(t){let e=this.getTransform().
multiply(new DOMMatrix([Math.cos(t),Math.sin(t),-Math.sin(t),Math.cos(t),0,0]));this.setTransform(e)},n.prototype.translate=function(t,e){let r=this.getTransform().
translate(t,e);this.setTransform(r)},n.prototype.transform=function(t,e,r,i,s,a){let o=this.getTransform().multiply(new DOMMatrix([t,e,r,i,s,a]));this.setTransform(
o)},n.prototype.__matrixTransform=function(t,e){return new DOMPoint(t,e).matrixTransform(this.__transformMatrix)},n.prototype.__getTransformScale=function(){return{
x:Math.hypot(this.__transformMatrix.a,this.__transformMatrix.b),y:Math.hypot(this.__transformMatrix.c,this.__transformMatrix.d)}},n.prototype.__getTransformRotation=
function(){return Math.atan2(this.__transformMatrix.b,this.__transformMatrix.a)},n.prototype.getImageData=function(t,e,r,i,s){return U.getImageData(this.getSvg(),
this.width,this.height,t,e,r,i,s)},n.prototype.drawFocusRing=function(){},n.prototype.createImageData=function(){},n.prototype.putImageData=function(){},n.prototype.
globalCompositeOperation=function(){},n})();function A(c){this.ctx=new L(c),this.svg=this.ctx.__root;var n=this.svg,u=this,g=document.createElement("div");g.style.
display="inline-block",g.appendChild(n),this.wrapper=g,Object.defineProperty(this,"className",{get:function(){return g.getAttribute("class")||""},set:function(_){
return g.setAttribute("class",_)}}),Object.defineProperty(this,"tagName",{get:function(){return"CANVAS"},set:function(){}}),["width","height"].forEach(function(_){
Object.defineProperty(u,_,{get:function(){return n.getAttribute(_)|0},set:function(p){if(!(isNaN(p)||typeof p>"u"))return u.ctx[_]=p,n.setAttribute(_,p),g[_]=p}})}),
["style","id"].forEach(function(_){Object.defineProperty(u,_,{get:function(){return g[_]},set:function(p){if(typeof p<"u")return g[_]=p}})}),["getBoundingClient\
Rect"].forEach(function(_){u[_]=function(){return n[_]()}})}A.prototype.getContext=function(c){if(c!=="2d")throw new Error("Unsupported type of context for SVGC\
anvas");return this.ctx};A.prototype.toObjectURL=function(){var c=new XMLSerializer().serializeToString(this.svg),n=new Blob([c],{type:"image/svg+xml;charset=ut\
f-8"});return URL.createObjectURL(n)};A.prototype.toDataURL=function(c,n,u){return U.toDataURL(this.svg,this.width,this.height,c,n,u)};A.prototype.addEventListener=
function(){return this.svg.addEventListener.apply(this.svg,arguments)};A.prototype.getElement=function(){return this.wrapper};A.prototype.getAttribute=function(c){
return this.wrapper.getAttribute(c)};A.prototype.setAttribute=function(c,n){this.wrapper.setAttribute(c,n)};N.Context=L;N.Element=A});var W=H(G(),1);var export_Context=W.Context;export{export_Context as Context};
