/* Built from web/site/motion_element.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
var a=new URL("./",import.meta.url),i=0,o=class extends HTMLElement{constructor(){super();this.lab=null;this.number=++i}static{this.observedAttributes=["scenari\
o"]}async connectedCallback(){if(this.shadowRoot)return;let r=this.attachShadow({mode:"open"}),t=document.createElement("link");t.rel="stylesheet",t.href=new URL(
"lab.css",a).href;let e=document.createElement("style");e.textContent=":host { display: block; min-height: 18rem; } :host([hidden]) { display: none; }";let n=document.
createElement("div");n.textContent="The hoop is loading …",r.append(t,e,n);try{let{mount:s}=await import(new URL("lab.js",a).href);n.textContent="",this.lab=await s(
n,a,this.scenario,this.panels),this.dispatchEvent(new Event("ready"))}catch(s){n.textContent=s.message}}disconnectedCallback(){this.lab?.close()}attributeChangedCallback(r,t,e){
this.lab&&t!==e&&this.lab.open([e??""])}get scenario(){return(this.getAttribute("scenario")??"").replace(/^\?/,"")}get panels(){return(this.getAttribute("panels")??
"").split(/[\s,]+/).filter(Boolean)}};customElements.define("hophoop-motion",o);
