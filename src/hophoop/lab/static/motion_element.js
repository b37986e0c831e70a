/* Built from web/site/motion_element.js by esbuild 0.28.2; sources fef7b403726746846543d997975d7593 */
var a=new URL("./",import.meta.url),l=0,o=class extends HTMLElement{static observedAttributes=["scenario"];constructor(){super(),this.lab=null,this.number=++l}async connectedCallback(){
if(this.shadowRoot)return;let i=this.attachShadow({mode:"open"}),t=document.createElement("link");t.rel="stylesheet",t.href=new URL("lab.css",a).href;let e=document.
createElement("style");e.textContent=":host { display: block; min-height: 18rem; } :host([hidden]) { display: none; }";let n=document.createElement("div");n.textContent=
"The hoop is loading …",i.append(t,e,n);try{let{mount:s}=await import(new URL("lab.js",a).href);n.textContent="",this.lab=await s(n,a,this.scenario,this.panels),
this.dispatchEvent(new Event("ready"))}catch(s){n.textContent=s.message}}disconnectedCallback(){this.lab?.close()}attributeChangedCallback(i,t,e){this.lab&&t!==
e&&this.lab.open([e??""])}get scenario(){return(this.getAttribute("scenario")??"").replace(/^\?/,"")}get panels(){return(this.getAttribute("panels")??"").split(
/[\s,]+/).filter(Boolean)}};customElements.define("hophoop-motion",o);
