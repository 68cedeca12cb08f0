const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./tray_view-XwCi1PGq.js","./pieces-B4mIAA6L.js","./stage-ipXkgLsU.js","./part_view-3PIUmjKR.js","./thumbnails-la6s02IT.js"])))=>i.map(i=>d[i]);
const Va=/\{[^{}]+\}/g,Ya=()=>typeof process=="object"&&Number.parseInt(process?.versions?.node?.substring(0,2))>=18&&process.versions.undici;function Za(){return Math.random().toString(36).slice(2,11)}function Xa(t){let{baseUrl:e="",Request:s=globalThis.Request,fetch:n=globalThis.fetch,querySerializer:i,bodySerializer:a,pathSerializer:r,headers:o,requestInitExt:c=void 0,...u}={...t};c=Ya()?c:void 0,e=Fn(e);const d=[];async function p(f,$){const{baseUrl:y,fetch:k=n,Request:O=s,headers:N,params:K={},parseAs:H="json",querySerializer:ze,bodySerializer:En=a??tr,pathSerializer:Wa,body:jn,middleware:Ka=[],...Os}=$||{};let Ss=e;y&&(Ss=Fn(y)??e);let As=typeof i=="function"?i:zn(i);ze&&(As=typeof ze=="function"?ze:zn({...typeof i=="object"?i:{},...ze}));const Ln=Wa||r||Qa,Cs=jn===void 0?void 0:En(jn,Nn(o,N,K.header)),Ga=Nn(Cs===void 0||Cs instanceof FormData?{}:{"Content-Type":"application/json"},o,N,K.header),bt=[...d,...Ka],Ja={redirect:"follow",...u,...Os,body:Cs,headers:Ga};let Ne,Fe,gt=new O(er(f,{baseUrl:Ss,params:K,querySerializer:As,pathSerializer:Ln}),Ja),S;for(const I in Os)I in gt||(gt[I]=Os[I]);if(bt.length){Ne=Za(),Fe=Object.freeze({baseUrl:Ss,fetch:k,parseAs:H,querySerializer:As,bodySerializer:En,pathSerializer:Ln});for(const I of bt)if(I&&typeof I=="object"&&typeof I.onRequest=="function"){const A=await I.onRequest({request:gt,schemaPath:f,params:K,options:Fe,id:Ne});if(A)if(A instanceof O)gt=A;else if(A instanceof Response){S=A;break}else throw new Error("onRequest: must return new Request() or Response() when modifying the request")}}if(!S){try{S=await k(gt,c)}catch(I){let A=I;if(bt.length)for(let Mt=bt.length-1;Mt>=0;Mt--){const Re=bt[Mt];if(Re&&typeof Re=="object"&&typeof Re.onError=="function"){const ae=await Re.onError({request:gt,error:A,schemaPath:f,params:K,options:Fe,id:Ne});if(ae){if(ae instanceof Response){A=void 0,S=ae;break}if(ae instanceof Error){A=ae;continue}throw new Error("onError: must return new Response() or instance of Error")}}}if(A)throw A}if(bt.length)for(let I=bt.length-1;I>=0;I--){const A=bt[I];if(A&&typeof A=="object"&&typeof A.onResponse=="function"){const Mt=await A.onResponse({request:gt,response:S,schemaPath:f,params:K,options:Fe,id:Ne});if(Mt){if(!(Mt instanceof Response))throw new Error("onResponse: must return new Response() when modifying the response");S=Mt}}}}const Dn=S.headers.get("Content-Length");if(S.status===204||gt.method==="HEAD"||Dn==="0"&&!S.headers.get("Transfer-Encoding")?.includes("chunked"))return S.ok?{data:void 0,response:S}:{error:void 0,response:S};if(S.ok)return{data:await(async()=>{if(H==="stream")return S.body;if(H==="json"&&!Dn){const A=await S.text();return A?JSON.parse(A):void 0}return await S[H]()})(),response:S};let Ts=await S.text();try{Ts=JSON.parse(Ts)}catch{}return{error:Ts,response:S}}return{request(f,$,y){return p($,{...y,method:f.toUpperCase()})},GET(f,$){return p(f,{...$,method:"GET"})},PUT(f,$){return p(f,{...$,method:"PUT"})},POST(f,$){return p(f,{...$,method:"POST"})},DELETE(f,$){return p(f,{...$,method:"DELETE"})},OPTIONS(f,$){return p(f,{...$,method:"OPTIONS"})},HEAD(f,$){return p(f,{...$,method:"HEAD"})},PATCH(f,$){return p(f,{...$,method:"PATCH"})},TRACE(f,$){return p(f,{...$,method:"TRACE"})},use(...f){for(const $ of f)if($){if(typeof $!="object"||!("onRequest"in $||"onResponse"in $||"onError"in $))throw new Error("Middleware must be an object with one of `onRequest()`, `onResponse() or `onError()`");d.push($)}},eject(...f){for(const $ of f){const y=d.indexOf($);y!==-1&&d.splice(y,1)}}}}function os(t,e,s){if(e==null)return"";if(typeof e=="object")throw new Error("Deeply-nested arrays/objects aren’t supported. Provide your own `querySerializer()` to handle these.");return`${t}=${s?.allowReserved===!0?e:encodeURIComponent(e)}`}function Si(t,e,s){if(!e||typeof e!="object")return"";const n=[],i={simple:",",label:".",matrix:";"}[s.style]||"&";if(s.style!=="deepObject"&&s.explode===!1){for(const o in e)n.push(o,s.allowReserved===!0?e[o]:encodeURIComponent(e[o]));const r=n.join(",");switch(s.style){case"form":return`${t}=${r}`;case"label":return`.${r}`;case"matrix":return`;${t}=${r}`;default:return r}}for(const r in e){const o=s.style==="deepObject"?`${t}[${r}]`:r;n.push(os(o,e[r],s))}const a=n.join(i);return s.style==="label"||s.style==="matrix"?`${i}${a}`:a}function Ai(t,e,s){if(!Array.isArray(e))return"";if(s.explode===!1){const a={form:",",spaceDelimited:"%20",pipeDelimited:"|"}[s.style]||",",r=(s.allowReserved===!0?e:e.map(o=>encodeURIComponent(o))).join(a);switch(s.style){case"simple":return r;case"label":return`.${r}`;case"matrix":return`;${t}=${r}`;default:return`${t}=${r}`}}const n={simple:",",label:".",matrix:";"}[s.style]||"&",i=[];for(const a of e)s.style==="simple"||s.style==="label"?i.push(s.allowReserved===!0?a:encodeURIComponent(a)):i.push(os(t,a,s));return s.style==="label"||s.style==="matrix"?`${n}${i.join(n)}`:i.join(n)}function zn(t){return function(s){const n=[];if(s&&typeof s=="object")for(const i in s){const a=s[i];if(a!=null){if(Array.isArray(a)){if(a.length===0)continue;n.push(Ai(i,a,{style:"form",explode:!0,...t?.array,allowReserved:t?.allowReserved||!1}));continue}if(typeof a=="object"){n.push(Si(i,a,{style:"deepObject",explode:!0,...t?.object,allowReserved:t?.allowReserved||!1}));continue}n.push(os(i,a,t))}}return n.join("&")}}function Qa(t,e){let s=t;for(const n of t.match(Va)??[]){let i=n.substring(1,n.length-1),a=!1,r="simple";if(i.endsWith("*")&&(a=!0,i=i.substring(0,i.length-1)),i.startsWith(".")?(r="label",i=i.substring(1)):i.startsWith(";")&&(r="matrix",i=i.substring(1)),!e||e[i]===void 0||e[i]===null)continue;const o=e[i];if(Array.isArray(o)){s=s.replace(n,Ai(i,o,{style:r,explode:a}));continue}if(typeof o=="object"){s=s.replace(n,Si(i,o,{style:r,explode:a}));continue}if(r==="matrix"){s=s.replace(n,`;${os(i,o)}`);continue}s=s.replace(n,r==="label"?`.${encodeURIComponent(o)}`:encodeURIComponent(o))}return s}function tr(t,e){return t instanceof FormData?t:e&&(e.get instanceof Function?e.get("Content-Type")??e.get("content-type"):e["Content-Type"]??e["content-type"])==="application/x-www-form-urlencoded"?new URLSearchParams(t).toString():JSON.stringify(t)}function er(t,e){let s=`${e.baseUrl}${t}`;e.params?.path&&(s=e.pathSerializer(s,e.params.path));let n=e.querySerializer(e.params.query??{});return n.startsWith("?")&&(n=n.substring(1)),n&&(s+=`?${n}`),s}function Nn(...t){const e=new Headers;for(const s of t){if(!s||typeof s!="object")continue;const n=s instanceof Headers?s.entries():Object.entries(s);for(const[i,a]of n)if(a===null)e.delete(i);else if(Array.isArray(a))for(const r of a)e.append(i,r);else a!==void 0&&e.set(i,a)}return e}function Fn(t){return t.endsWith("/")?t.substring(0,t.length-1):t}function an(t){return t.replace(/--([a-z][a-z-]*[a-z])/g,(e,s)=>`“${s.replaceAll("-"," ")}”`).replace(/(^|[\s(])'([^']+)'(?=$|[\s.,:;)])/g,"$1“$2”").replaceAll("'","’")}function q(t){const e=an(t.trim()),s=e.charAt(0).toUpperCase()+e.slice(1);return/[.!?…]$/.test(s)?s:`${s}.`}class Xt extends Error{constructor(e,s,n=null){super(e),this.status=s,this.file=n}}const Ci="The server does not answer. It may have been stopped: start spectralpack serve again.";let fe={reached(){},tokenWanted(){}};function sr(t){fe=t}const C=Xa({baseUrl:"./",credentials:"same-origin"});function Ti(t,e){fe.reached(!0),t===401&&fe.tokenWanted();const s=e,n=typeof s?.error=="string"&&s.error?q(s.error):`The server answered ${t}. Try again.`;return new Xt(n,t,typeof s?.file=="string"?s.file:null)}async function T(t){let e;try{e=await t}catch(s){throw s instanceof DOMException&&s.name==="AbortError"?s:(fe.reached(!1),new Xt(Ci,0))}if(!e.response.ok)throw Ti(e.response.status,e.error);return fe.reached(!0),e.data}const G=t=>({path:{id:t}}),M={info:()=>T(C.GET("/api/info")),startSession:t=>T(C.POST("/api/session",{body:{token:t}})),jobs:(t,e)=>T(C.GET("/api/jobs",{params:{query:{most:e,...t?{find:t}:{}}}})),createJob:t=>T(C.POST("/api/jobs",{body:t})),job:t=>T(C.GET("/api/jobs/{id}",{params:G(t)})),rename:(t,e)=>T(C.PATCH("/api/jobs/{id}",{params:G(t),body:{name:e}})),deleteJob:t=>T(C.DELETE("/api/jobs/{id}",{params:G(t)})),deleteFile:(t,e)=>T(C.DELETE("/api/jobs/{id}/files/{name}",{params:{path:{id:t,name:e}}})),fileBytes:(t,e)=>T(C.GET("/api/jobs/{id}/files/{name}",{params:{path:{id:t,name:e}},parseAs:"arrayBuffer"})),parts:t=>T(C.GET("/api/jobs/{id}/parts",{params:G(t)})),meshes:(t,e,s)=>T(C.GET("/api/jobs/{id}/meshes.bin",{params:{...G(t),query:{detail:e,ids:s.join(",")}},parseAs:"arrayBuffer"})),jobFile:async t=>{try{return await T(C.GET("/api/jobs/{id}/job.json",{params:G(t)}))}catch(e){if(e instanceof Xt&&e.status===404)return null;throw e}},putJobFile:(t,e)=>T(C.PUT("/api/jobs/{id}/job.json",{params:G(t),body:e})),estimate:(t,e)=>T(C.POST("/api/jobs/{id}/estimate",{params:G(t),signal:e})),start:t=>T(C.POST("/api/jobs/{id}/start",{params:G(t)})),cancel:t=>T(C.POST("/api/jobs/{id}/cancel",{params:G(t)})),packing:t=>T(C.GET("/api/jobs/{id}/packing.json",{params:G(t)})),check:t=>T(C.GET("/api/jobs/{id}/check",{params:G(t)})),clearance:(t,e,s,n)=>T(C.GET("/api/jobs/{id}/clearance",{params:{...G(t),query:{tray:e,placement:s}},signal:n}))};function rn(t,e,s){const n=s===null||e==="json"?"":`?tray=${s}`;return`./api/jobs/${t}/packing.${e}${n}`}const Ei=t=>`./api/jobs/${t}/picture.png`;function nr(t,e){return`./api/jobs/${t}/files/${encodeURIComponent(e)}`}function ir(t,e){const s=/^#token=(.+)$/.exec(t.hash);return s?.[1]?(e.replaceState(null,"",t.pathname+t.search),decodeURIComponent(s[1])):null}async function ji(t){await M.startSession(t.trim())}function qt(t,e){try{const s=localStorage.getItem(`spectralpack.${t}`);return s===null?e:JSON.parse(s)}catch{return e}}function Qt(t,e){try{localStorage.setItem(`spectralpack.${t}`,JSON.stringify(e))}catch{}}class nt{constructor(e){this.listeners=new Set,this.current=e}get value(){return this.current}set(e){const s={...this.current,...e};if(!Object.keys(e).every(i=>Object.is(s[i],this.current[i]))){this.current=s;for(const i of[...this.listeners])i()}}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}}const b=new nt({route:{page:"start"},info:null,tokenWanted:!1,connected:!0,choice:qt("theme","system"),theme:"light",problem:null,toast:null,announcement:"",letterKeys:qt("letterKeys",!0),dialog:null});function ar(t){Qt("letterKeys",t),b.set({letterKeys:t})}function Es(t){b.set({announcement:t})}function me(t){b.set({problem:t})}async function Y(t){try{const e=await t();return me(null),e}catch(e){return e instanceof DOMException&&e.name==="AbortError"||me(Tt(e)),null}}function Tt(t){return t instanceof Error&&t.message?t.message:"Something went wrong. Reload the page."}function rr(t){const e=/^#\/job\/([a-z0-9]{12})(?:\/(parts|build))?\/?$/.exec(t);return e?.[1]?{page:"job",id:e[1],step:e[2]??"parts"}:{page:"start"}}function Ke(t){return t.page==="start"?"#/":`#/job/${t.id}/${t.step}`}function tt(t,e=!1){const s=Ke(t);location.hash!==s&&(e?location.replace(s):location.hash=s)}const Li=()=>matchMedia("(prefers-color-scheme: dark)");function Bs(){const t=b.value.choice,e=t==="system"?Li().matches?"dark":"light":t;document.documentElement.dataset.theme=e,b.set({theme:e})}function or(t){Qt("theme",t),b.set({choice:t}),Bs()}function lr(){Li().addEventListener("change",Bs),Bs()}/**
 * @license
 * Copyright 2019 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Ie=globalThis,on=Ie.ShadowRoot&&(Ie.ShadyCSS===void 0||Ie.ShadyCSS.nativeShadow)&&"adoptedStyleSheets"in Document.prototype&&"replace"in CSSStyleSheet.prototype,Di=Symbol(),Rn=new WeakMap;let cr=class{constructor(e,s,n){if(this._$cssResult$=!0,n!==Di)throw Error("CSSResult is not constructable. Use `unsafeCSS` or `css` instead.");this.cssText=e,this.t=s}get styleSheet(){let e=this.o;const s=this.t;if(on&&e===void 0){const n=s!==void 0&&s.length===1;n&&(e=Rn.get(s)),e===void 0&&((this.o=e=new CSSStyleSheet).replaceSync(this.cssText),n&&Rn.set(s,e))}return e}toString(){return this.cssText}};const ur=t=>new cr(typeof t=="string"?t:t+"",void 0,Di),hr=(t,e)=>{if(on)t.adoptedStyleSheets=e.map(s=>s instanceof CSSStyleSheet?s:s.styleSheet);else for(const s of e){const n=document.createElement("style"),i=Ie.litNonce;i!==void 0&&n.setAttribute("nonce",i),n.textContent=s.cssText,t.appendChild(n)}},Un=on?t=>t:t=>t instanceof CSSStyleSheet?(e=>{let s="";for(const n of e.cssRules)s+=n.cssText;return ur(s)})(t):t;/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const{is:dr,defineProperty:pr,getOwnPropertyDescriptor:fr,getOwnPropertyNames:mr,getOwnPropertySymbols:$r,getPrototypeOf:br}=Object,ls=globalThis,In=ls.trustedTypes,gr=In?In.emptyScript:"",yr=ls.reactiveElementPolyfillSupport,he=(t,e)=>t,Ge={toAttribute(t,e){switch(e){case Boolean:t=t?gr:null;break;case Object:case Array:t=t==null?t:JSON.stringify(t)}return t},fromAttribute(t,e){let s=t;switch(e){case Boolean:s=t!==null;break;case Number:s=t===null?null:Number(t);break;case Object:case Array:try{s=JSON.parse(t)}catch{s=null}}return s}},ln=(t,e)=>!dr(t,e),Hn={attribute:!0,type:String,converter:Ge,reflect:!1,useDefault:!1,hasChanged:ln};Symbol.metadata??=Symbol("metadata"),ls.litPropertyMetadata??=new WeakMap;let It=class extends HTMLElement{static addInitializer(e){this._$Ei(),(this.l??=[]).push(e)}static get observedAttributes(){return this.finalize(),this._$Eh&&[...this._$Eh.keys()]}static createProperty(e,s=Hn){if(s.state&&(s.attribute=!1),this._$Ei(),this.prototype.hasOwnProperty(e)&&((s=Object.create(s)).wrapped=!0),this.elementProperties.set(e,s),!s.noAccessor){const n=Symbol(),i=this.getPropertyDescriptor(e,n,s);i!==void 0&&pr(this.prototype,e,i)}}static getPropertyDescriptor(e,s,n){const{get:i,set:a}=fr(this.prototype,e)??{get(){return this[s]},set(r){this[s]=r}};return{get:i,set(r){const o=i?.call(this);a?.call(this,r),this.requestUpdate(e,o,n)},configurable:!0,enumerable:!0}}static getPropertyOptions(e){return this.elementProperties.get(e)??Hn}static _$Ei(){if(this.hasOwnProperty(he("elementProperties")))return;const e=br(this);e.finalize(),e.l!==void 0&&(this.l=[...e.l]),this.elementProperties=new Map(e.elementProperties)}static finalize(){if(this.hasOwnProperty(he("finalized")))return;if(this.finalized=!0,this._$Ei(),this.hasOwnProperty(he("properties"))){const s=this.properties,n=[...mr(s),...$r(s)];for(const i of n)this.createProperty(i,s[i])}const e=this[Symbol.metadata];if(e!==null){const s=litPropertyMetadata.get(e);if(s!==void 0)for(const[n,i]of s)this.elementProperties.set(n,i)}this._$Eh=new Map;for(const[s,n]of this.elementProperties){const i=this._$Eu(s,n);i!==void 0&&this._$Eh.set(i,s)}this.elementStyles=this.finalizeStyles(this.styles)}static finalizeStyles(e){const s=[];if(Array.isArray(e)){const n=new Set(e.flat(1/0).reverse());for(const i of n)s.unshift(Un(i))}else e!==void 0&&s.push(Un(e));return s}static _$Eu(e,s){const n=s.attribute;return n===!1?void 0:typeof n=="string"?n:typeof e=="string"?e.toLowerCase():void 0}constructor(){super(),this._$Ep=void 0,this.isUpdatePending=!1,this.hasUpdated=!1,this._$Em=null,this._$Ev()}_$Ev(){this._$ES=new Promise(e=>this.enableUpdating=e),this._$AL=new Map,this._$E_(),this.requestUpdate(),this.constructor.l?.forEach(e=>e(this))}addController(e){(this._$EO??=new Set).add(e),this.renderRoot!==void 0&&this.isConnected&&e.hostConnected?.()}removeController(e){this._$EO?.delete(e)}_$E_(){const e=new Map,s=this.constructor.elementProperties;for(const n of s.keys())this.hasOwnProperty(n)&&(e.set(n,this[n]),delete this[n]);e.size>0&&(this._$Ep=e)}createRenderRoot(){const e=this.shadowRoot??this.attachShadow(this.constructor.shadowRootOptions);return hr(e,this.constructor.elementStyles),e}connectedCallback(){this.renderRoot??=this.createRenderRoot(),this.enableUpdating(!0),this._$EO?.forEach(e=>e.hostConnected?.())}enableUpdating(e){}disconnectedCallback(){this._$EO?.forEach(e=>e.hostDisconnected?.())}attributeChangedCallback(e,s,n){this._$AK(e,n)}_$ET(e,s){const n=this.constructor.elementProperties.get(e),i=this.constructor._$Eu(e,n);if(i!==void 0&&n.reflect===!0){const a=(n.converter?.toAttribute!==void 0?n.converter:Ge).toAttribute(s,n.type);this._$Em=e,a==null?this.removeAttribute(i):this.setAttribute(i,a),this._$Em=null}}_$AK(e,s){const n=this.constructor,i=n._$Eh.get(e);if(i!==void 0&&this._$Em!==i){const a=n.getPropertyOptions(i),r=typeof a.converter=="function"?{fromAttribute:a.converter}:a.converter?.fromAttribute!==void 0?a.converter:Ge;this._$Em=i;const o=r.fromAttribute(s,a.type);this[i]=o??this._$Ej?.get(i)??o,this._$Em=null}}requestUpdate(e,s,n,i=!1,a){if(e!==void 0){const r=this.constructor;if(i===!1&&(a=this[e]),n??=r.getPropertyOptions(e),!((n.hasChanged??ln)(a,s)||n.useDefault&&n.reflect&&a===this._$Ej?.get(e)&&!this.hasAttribute(r._$Eu(e,n))))return;this.C(e,s,n)}this.isUpdatePending===!1&&(this._$ES=this._$EP())}C(e,s,{useDefault:n,reflect:i,wrapped:a},r){n&&!(this._$Ej??=new Map).has(e)&&(this._$Ej.set(e,r??s??this[e]),a!==!0||r!==void 0)||(this._$AL.has(e)||(this.hasUpdated||n||(s=void 0),this._$AL.set(e,s)),i===!0&&this._$Em!==e&&(this._$Eq??=new Set).add(e))}async _$EP(){this.isUpdatePending=!0;try{await this._$ES}catch(s){Promise.reject(s)}const e=this.scheduleUpdate();return e!=null&&await e,!this.isUpdatePending}scheduleUpdate(){return this.performUpdate()}performUpdate(){if(!this.isUpdatePending)return;if(!this.hasUpdated){if(this.renderRoot??=this.createRenderRoot(),this._$Ep){for(const[i,a]of this._$Ep)this[i]=a;this._$Ep=void 0}const n=this.constructor.elementProperties;if(n.size>0)for(const[i,a]of n){const{wrapped:r}=a,o=this[i];r!==!0||this._$AL.has(i)||o===void 0||this.C(i,void 0,a,o)}}let e=!1;const s=this._$AL;try{e=this.shouldUpdate(s),e?(this.willUpdate(s),this._$EO?.forEach(n=>n.hostUpdate?.()),this.update(s)):this._$EM()}catch(n){throw e=!1,this._$EM(),n}e&&this._$AE(s)}willUpdate(e){}_$AE(e){this._$EO?.forEach(s=>s.hostUpdated?.()),this.hasUpdated||(this.hasUpdated=!0,this.firstUpdated(e)),this.updated(e)}_$EM(){this._$AL=new Map,this.isUpdatePending=!1}get updateComplete(){return this.getUpdateComplete()}getUpdateComplete(){return this._$ES}shouldUpdate(e){return!0}update(e){this._$Eq&&=this._$Eq.forEach(s=>this._$ET(s,this[s])),this._$EM()}updated(e){}firstUpdated(e){}};It.elementStyles=[],It.shadowRootOptions={mode:"open"},It[he("elementProperties")]=new Map,It[he("finalized")]=new Map,yr?.({ReactiveElement:It}),(ls.reactiveElementVersions??=[]).push("2.1.2");/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const cn=globalThis,Bn=t=>t,Je=cn.trustedTypes,qn=Je?Je.createPolicy("lit-html",{createHTML:t=>t}):void 0,zi="$lit$",vt=`lit$${Math.random().toFixed(9).slice(2)}$`,Ni="?"+vt,vr=`<${Ni}>`,Et=document,$e=()=>Et.createComment(""),be=t=>t===null||typeof t!="object"&&typeof t!="function",un=Array.isArray,wr=t=>un(t)||typeof t?.[Symbol.iterator]=="function",js=`[ 	
\f\r]`,re=/<(?:(!--|\/[^a-zA-Z])|(\/?[a-zA-Z][^>\s]*)|(\/?$))/g,Wn=/-->/g,Kn=/>/g,Pt=RegExp(`>|${js}(?:([^\\s"'>=/]+)(${js}*=${js}*(?:[^ 	
\f\r"'\`<>=]|("|')|))|$)`,"g"),Gn=/'/g,Jn=/"/g,Fi=/^(?:script|style|textarea|title)$/i,Ri=t=>(e,...s)=>({_$litType$:t,strings:e,values:s}),l=Ri(1),He=Ri(2),mt=Symbol.for("lit-noChange"),h=Symbol.for("lit-nothing"),Vn=new WeakMap,Ct=Et.createTreeWalker(Et,129);function Ui(t,e){if(!un(t)||!t.hasOwnProperty("raw"))throw Error("invalid template strings array");return qn!==void 0?qn.createHTML(e):e}const kr=(t,e)=>{const s=t.length-1,n=[];let i,a=e===2?"<svg>":e===3?"<math>":"",r=re;for(let o=0;o<s;o++){const c=t[o];let u,d,p=-1,f=0;for(;f<c.length&&(r.lastIndex=f,d=r.exec(c),d!==null);)f=r.lastIndex,r===re?d[1]==="!--"?r=Wn:d[1]!==void 0?r=Kn:d[2]!==void 0?(Fi.test(d[2])&&(i=RegExp("</"+d[2],"g")),r=Pt):d[3]!==void 0&&(r=Pt):r===Pt?d[0]===">"?(r=i??re,p=-1):d[1]===void 0?p=-2:(p=r.lastIndex-d[2].length,u=d[1],r=d[3]===void 0?Pt:d[3]==='"'?Jn:Gn):r===Jn||r===Gn?r=Pt:r===Wn||r===Kn?r=re:(r=Pt,i=void 0);const $=r===Pt&&t[o+1].startsWith("/>")?" ":"";a+=r===re?c+vr:p>=0?(n.push(u),c.slice(0,p)+zi+c.slice(p)+vt+$):c+vt+(p===-2?o:$)}return[Ui(t,a+(t[s]||"<?>")+(e===2?"</svg>":e===3?"</math>":"")),n]};class ge{constructor({strings:e,_$litType$:s},n){let i;this.parts=[];let a=0,r=0;const o=e.length-1,c=this.parts,[u,d]=kr(e,s);if(this.el=ge.createElement(u,n),Ct.currentNode=this.el.content,s===2||s===3){const p=this.el.content.firstChild;p.replaceWith(...p.childNodes)}for(;(i=Ct.nextNode())!==null&&c.length<o;){if(i.nodeType===1){if(i.hasAttributes())for(const p of i.getAttributeNames())if(p.endsWith(zi)){const f=d[r++],$=i.getAttribute(p).split(vt),y=/([.?@])?(.*)/.exec(f);c.push({type:1,index:a,name:y[2],strings:$,ctor:y[1]==="."?_r:y[1]==="?"?Mr:y[1]==="@"?Pr:cs}),i.removeAttribute(p)}else p.startsWith(vt)&&(c.push({type:6,index:a}),i.removeAttribute(p));if(Fi.test(i.tagName)){const p=i.textContent.split(vt),f=p.length-1;if(f>0){i.textContent=Je?Je.emptyScript:"";for(let $=0;$<f;$++)i.append(p[$],$e()),Ct.nextNode(),c.push({type:2,index:++a});i.append(p[f],$e())}}}else if(i.nodeType===8)if(i.data===Ni)c.push({type:2,index:a});else{let p=-1;for(;(p=i.data.indexOf(vt,p+1))!==-1;)c.push({type:7,index:a}),p+=vt.length-1}a++}}static createElement(e,s){const n=Et.createElement("template");return n.innerHTML=e,n}}function Wt(t,e,s=t,n){if(e===mt)return e;let i=n!==void 0?s._$Co?.[n]:s._$Cl;const a=be(e)?void 0:e._$litDirective$;return i?.constructor!==a&&(i?._$AO?.(!1),a===void 0?i=void 0:(i=new a(t),i._$AT(t,s,n)),n!==void 0?(s._$Co??=[])[n]=i:s._$Cl=i),i!==void 0&&(e=Wt(t,i._$AS(t,e.values),i,n)),e}class xr{constructor(e,s){this._$AV=[],this._$AN=void 0,this._$AD=e,this._$AM=s}get parentNode(){return this._$AM.parentNode}get _$AU(){return this._$AM._$AU}u(e){const{el:{content:s},parts:n}=this._$AD,i=(e?.creationScope??Et).importNode(s,!0);Ct.currentNode=i;let a=Ct.nextNode(),r=0,o=0,c=n[0];for(;c!==void 0;){if(r===c.index){let u;c.type===2?u=new te(a,a.nextSibling,this,e):c.type===1?u=new c.ctor(a,c.name,c.strings,this,e):c.type===6&&(u=new Or(a,this,e)),this._$AV.push(u),c=n[++o]}r!==c?.index&&(a=Ct.nextNode(),r++)}return Ct.currentNode=Et,i}p(e){let s=0;for(const n of this._$AV)n!==void 0&&(n.strings!==void 0?(n._$AI(e,n,s),s+=n.strings.length-2):n._$AI(e[s])),s++}}class te{get _$AU(){return this._$AM?._$AU??this._$Cv}constructor(e,s,n,i){this.type=2,this._$AH=h,this._$AN=void 0,this._$AA=e,this._$AB=s,this._$AM=n,this.options=i,this._$Cv=i?.isConnected??!0}get parentNode(){let e=this._$AA.parentNode;const s=this._$AM;return s!==void 0&&e?.nodeType===11&&(e=s.parentNode),e}get startNode(){return this._$AA}get endNode(){return this._$AB}_$AI(e,s=this){e=Wt(this,e,s),be(e)?e===h||e==null||e===""?(this._$AH!==h&&this._$AR(),this._$AH=h):e!==this._$AH&&e!==mt&&this._(e):e._$litType$!==void 0?this.$(e):e.nodeType!==void 0?this.T(e):wr(e)?this.k(e):this._(e)}O(e){return this._$AA.parentNode.insertBefore(e,this._$AB)}T(e){this._$AH!==e&&(this._$AR(),this._$AH=this.O(e))}_(e){this._$AH!==h&&be(this._$AH)?this._$AA.nextSibling.data=e:this.T(Et.createTextNode(e)),this._$AH=e}$(e){const{values:s,_$litType$:n}=e,i=typeof n=="number"?this._$AC(e):(n.el===void 0&&(n.el=ge.createElement(Ui(n.h,n.h[0]),this.options)),n);if(this._$AH?._$AD===i)this._$AH.p(s);else{const a=new xr(i,this),r=a.u(this.options);a.p(s),this.T(r),this._$AH=a}}_$AC(e){let s=Vn.get(e.strings);return s===void 0&&Vn.set(e.strings,s=new ge(e)),s}k(e){un(this._$AH)||(this._$AH=[],this._$AR());const s=this._$AH;let n,i=0;for(const a of e)i===s.length?s.push(n=new te(this.O($e()),this.O($e()),this,this.options)):n=s[i],n._$AI(a),i++;i<s.length&&(this._$AR(n&&n._$AB.nextSibling,i),s.length=i)}_$AR(e=this._$AA.nextSibling,s){for(this._$AP?.(!1,!0,s);e!==this._$AB;){const n=Bn(e).nextSibling;Bn(e).remove(),e=n}}setConnected(e){this._$AM===void 0&&(this._$Cv=e,this._$AP?.(e))}}class cs{get tagName(){return this.element.tagName}get _$AU(){return this._$AM._$AU}constructor(e,s,n,i,a){this.type=1,this._$AH=h,this._$AN=void 0,this.element=e,this.name=s,this._$AM=i,this.options=a,n.length>2||n[0]!==""||n[1]!==""?(this._$AH=Array(n.length-1).fill(new String),this.strings=n):this._$AH=h}_$AI(e,s=this,n,i){const a=this.strings;let r=!1;if(a===void 0)e=Wt(this,e,s,0),r=!be(e)||e!==this._$AH&&e!==mt,r&&(this._$AH=e);else{const o=e;let c,u;for(e=a[0],c=0;c<a.length-1;c++)u=Wt(this,o[n+c],s,c),u===mt&&(u=this._$AH[c]),r||=!be(u)||u!==this._$AH[c],u===h?e=h:e!==h&&(e+=(u??"")+a[c+1]),this._$AH[c]=u}r&&!i&&this.j(e)}j(e){e===h?this.element.removeAttribute(this.name):this.element.setAttribute(this.name,e??"")}}class _r extends cs{constructor(){super(...arguments),this.type=3}j(e){this.element[this.name]=e===h?void 0:e}}class Mr extends cs{constructor(){super(...arguments),this.type=4}j(e){this.element.toggleAttribute(this.name,!!e&&e!==h)}}class Pr extends cs{constructor(e,s,n,i,a){super(e,s,n,i,a),this.type=5}_$AI(e,s=this){if((e=Wt(this,e,s,0)??h)===mt)return;const n=this._$AH,i=e===h&&n!==h||e.capture!==n.capture||e.once!==n.once||e.passive!==n.passive,a=e!==h&&(n===h||i);i&&this.element.removeEventListener(this.name,this,n),a&&this.element.addEventListener(this.name,this,e),this._$AH=e}handleEvent(e){typeof this._$AH=="function"?this._$AH.call(this.options?.host??this.element,e):this._$AH.handleEvent(e)}}class Or{constructor(e,s,n){this.element=e,this.type=6,this._$AN=void 0,this._$AM=s,this.options=n}get _$AU(){return this._$AM._$AU}_$AI(e){Wt(this,e)}}const Sr={I:te},Ar=cn.litHtmlPolyfillSupport;Ar?.(ge,te),(cn.litHtmlVersions??=[]).push("3.3.3");const Cr=(t,e,s)=>{const n=s?.renderBefore??e;let i=n._$litPart$;if(i===void 0){const a=s?.renderBefore??null;n._$litPart$=i=new te(e.insertBefore($e(),a),a,void 0,s??{})}return i._$AI(t),i};/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const hn=globalThis;let de=class extends It{constructor(){super(...arguments),this.renderOptions={host:this},this._$Do=void 0}createRenderRoot(){const e=super.createRenderRoot();return this.renderOptions.renderBefore??=e.firstChild,e}update(e){const s=this.render();this.hasUpdated||(this.renderOptions.isConnected=this.isConnected),super.update(e),this._$Do=Cr(s,this.renderRoot,this.renderOptions)}connectedCallback(){super.connectedCallback(),this._$Do?.setConnected(!0)}disconnectedCallback(){super.disconnectedCallback(),this._$Do?.setConnected(!1)}render(){return mt}};de._$litElement$=!0,de.finalized=!0,hn.litElementHydrateSupport?.({LitElement:de});const Tr=hn.litElementPolyfillSupport;Tr?.({LitElement:de});(hn.litElementVersions??=[]).push("4.2.2");/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const v=t=>(e,s)=>{s!==void 0?s.addInitializer(()=>{customElements.define(t,e)}):customElements.define(t,e)};/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Er={attribute:!0,type:String,converter:Ge,reflect:!1,hasChanged:ln},jr=(t=Er,e,s)=>{const{kind:n,metadata:i}=s;let a=globalThis.litPropertyMetadata.get(i);if(a===void 0&&globalThis.litPropertyMetadata.set(i,a=new Map),n==="setter"&&((t=Object.create(t)).wrapped=!0),a.set(s.name,t),n==="accessor"){const{name:r}=s;return{set(o){const c=e.get.call(this);e.set.call(this,o),this.requestUpdate(r,c,t,!0,o)},init(o){return o!==void 0&&this.C(r,void 0,t,o),o}}}if(n==="setter"){const{name:r}=s;return function(o){const c=this[r];e.call(this,o),this.requestUpdate(r,c,t,!0,o)}}throw Error("Unsupported decorator location: "+n)};function m(t){return(e,s)=>typeof s=="object"?jr(t,e,s):((n,i,a)=>{const r=i.hasOwnProperty(a);return i.constructor.createProperty(a,n),r?Object.getOwnPropertyDescriptor(i,a):void 0})(t,e,s)}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */function P(t){return m({...t,state:!0,attribute:!1})}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Lr=(t,e,s)=>(s.configurable=!0,s.enumerable=!0,Reflect.decorate&&typeof e!="object"&&Object.defineProperty(t,e,s),s);/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */function W(t,e){return(s,n,i)=>{const a=r=>r.renderRoot?.querySelector(t)??null;return Lr(s,n,{get(){return a(this)}})}}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Ii={CHILD:2,ELEMENT:6},dn=t=>(...e)=>({_$litDirective$:t,values:e});let pn=class{constructor(e){}get _$AU(){return this._$AM._$AU}_$AT(e,s,n){this._$Ct=e,this._$AM=s,this._$Ci=n}_$AS(e,s){return this.update(e,s)}update(e,s){return this.render(...s)}};/**
 * @license
 * Copyright 2020 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const{I:Dr}=Sr,Yn=t=>t,Zn=()=>document.createComment(""),oe=(t,e,s)=>{const n=t._$AA.parentNode,i=e===void 0?t._$AB:e._$AA;if(s===void 0){const a=n.insertBefore(Zn(),i),r=n.insertBefore(Zn(),i);s=new Dr(a,r,t,t.options)}else{const a=s._$AB.nextSibling,r=s._$AM,o=r!==t;if(o){let c;s._$AQ?.(t),s._$AM=t,s._$AP!==void 0&&(c=t._$AU)!==r._$AU&&s._$AP(c)}if(a!==i||o){let c=s._$AA;for(;c!==a;){const u=Yn(c).nextSibling;Yn(n).insertBefore(c,i),c=u}}}return s},Ot=(t,e,s=t)=>(t._$AI(e,s),t),zr={},Hi=(t,e=zr)=>t._$AH=e,Nr=t=>t._$AH,Ls=t=>{t._$AR(),t._$AA.remove()};/**
 * @license
 * Copyright 2021 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Fr=dn(class extends pn{constructor(){super(...arguments),this.key=h}render(t,e){return this.key=t,e}update(t,[e,s]){return e!==this.key&&(Hi(t),this.key=e),s}}),Rr={add:"M8 3v10M3 8h10",any:"M8 2.4a5.6 5.6 0 015.3 3.8M13.6 2.8v3.4h-3.4M8 13.6a5.6 5.6 0 01-5.3-3.8M2.4 13.2V9.8h3.4",axes:"M4 12V4M4 12h8M4 12l4.5-4.5M4 4L2.8 5.4M4 4l1.2 1.4M12 12l-1.4-1.2M12 12l-1.4 1.2",bad:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 5v3.6M8 10.9v.1",box:"M8 1.8l5.6 3.1v6.2L8 14.2l-5.6-3.1V4.9zM2.4 4.9L8 8l5.6-3.1M8 8v6.2",braces:"M6 2.5c-2 0-1.5 2-1.5 3.5S3 8 3 8s1.5.5 1.5 2-.5 3.5 1.5 3.5M10 2.5c2 0 1.5 2 1.5 3.5S13 8 13 8s-1.5.5-1.5 2 .5 3.5-1.5 3.5",check:"M3 8.5l3.2 3L13 4.5",clock:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 4.6V8l2.4 1.6",close:"M4 4l8 8M12 4l-8 8",copy:"M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",down:"M4 6l4 4 4-4",download:"M8 2v8M4.8 6.8L8 10l3.2-3.2M2.5 10.5v3h11v-3",drawn:"M3.5 3.5h9v9h-9zM8 6v4M6 8h4",eye:"M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM8 6.2a1.8 1.8 0 110 3.6 1.8 1.8 0 010-3.6",eyeOff:"M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM3 13L13 3",file:"M4 1.8h5l3.2 3.2v9.2H4zM9 1.8V5h3.2",find:"M7 2.5a4.5 4.5 0 110 9 4.5 4.5 0 010-9zM10.4 10.4L14 14",flip:"M8 2v12M5.5 5L2.5 11h3zM10.5 5l3 6h-3z",folder:"M1.8 4h4.4l1.5 1.6h6.5v7.6H1.8z",frame:"M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3",help:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM6.2 6.4a1.9 1.9 0 113 1.5c-.8.5-1.2.8-1.2 1.6M8 11.4v.1",info:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 7.4v3.6M8 5.1v.1",left:"M10 4L6 8l4 4",list:"M5.5 4h8M5.5 8h8M5.5 12h8M2.6 4h.1M2.6 8h.1M2.6 12h.1",mesh:"M6.5 9.5l3-3M7 4.5l1-1a2.8 2.8 0 014 4l-1 1M9 11.5l-1 1a2.8 2.8 0 01-4-4l1-1",minus:"M3.5 8h9",moon:"M13 9.6A5.6 5.6 0 016.4 3 5.6 5.6 0 1013 9.6z",picture:"M2.5 3h11v10h-11zM2.5 11l3.2-3.2 2.6 2.6 2.2-2.2 3 3M10.5 6h.1",printer:"M4.5 6V2.5h7V6M4.5 11.5h-2V6h11v5.5h-2M4.5 9.5h7v4h-7z",redo:"M10 4l3 3-3 3M13 7H6.5a3.5 3.5 0 000 7H8",right:"M6 4l4 4-4 4",settings:"M2.5 4.5h6M11.5 4.5h2M10 3v3M2.5 11.5h2M7.5 11.5h6M6 10v3",stop:"M4 4h8v8H4z",sun:"M8 5.2a2.8 2.8 0 110 5.6 2.8 2.8 0 010-5.6M8 1.6v1.2M8 13.2v1.2M1.6 8h1.2M13.2 8h1.2M3.5 3.5l.8.8M11.7 11.7l.8.8M12.5 3.5l-.8.8M4.3 11.7l-.8.8",system:"M2.5 3h11v7.5h-11zM6 13.5h4M8 10.5v3",trash:"M3 4.4h10M6.4 4.4V2.8h3.2v1.6M4.4 4.4l.5 9.2h6.2l.5-9.2",undo:"M6 4L3 7l3 3M3 7h6.5a3.5 3.5 0 010 7H8",upright:"M8 13V3M8 3L5.6 5.4M8 3l2.4 2.4M3.4 13.4h9.2",warn:"M8 2.2L14.5 13.5h-13zM8 6.5v3.2M8 11.6v.1"};function g(t){return l`<svg class="i" viewBox="0 0 16 16" aria-hidden="true">${He`<path d=${Rr[t]} />`}</svg>`}const ht=l`<svg class="i spin" viewBox="0 0 16 16" aria-hidden="true">
  <path d="M8 1.8a6.2 6.2 0 016.2 6.2" />
</svg>`,Bi=l`<svg class="mark" viewBox="0 0 20 20" aria-hidden="true">
  <path class="edge" d="M10 1.5l7.5 4.2v8.6L10 18.5l-7.5-4.2V5.7z" />
  <path class="face" d="M10 10l7.5-4.3v8.6L10 18.5z" />
  <path class="edge" d="M2.5 5.7L10 10v8.5" />
</svg>`;class w extends de{constructor(){super(...arguments),this.watching=[],this.watchedStores=[]}stores(){return[]}createRenderRoot(){return this}connectedCallback(){super.connectedCallback(),this.watchStores()}disconnectedCallback(){super.disconnectedCallback();for(const e of this.watching)e();this.watching=[],this.watchedStores=[]}willUpdate(){this.watchStores()}watchStores(){const e=this.stores();if(!(e.length===this.watchedStores.length&&e.every((n,i)=>n===this.watchedStores[i]))){for(const n of this.watching)n();this.watching=e.map(n=>n.subscribe(()=>this.requestUpdate())),this.watchedStores=e}}}const X=t=>`${t.part}/${t.copy}`;class Ur{constructor(){this.trays=new Map,this.phases=new Set,this.seconds=new Map,this.remarks=[],this.progress=null,this.newest=null,this.version=0,this.placed=0,this.changes=new Map}clear(){for(const e of this.trays.keys())this.noteCleared(e);this.trays.clear(),this.phases.clear(),this.seconds.clear(),this.remarks.length=0,this.progress=null,this.newest=null,this.placed=0,this.version+=1}apply(e){if(e===null||typeof e!="object")return;const s=e;this.version+=1,s.event!==void 0?this.applyEvent(s):s.phase!==void 0?this.applyProgress(e):s.warning!==void 0?this.remark(s.warning):s.error!==void 0&&this.remark(s.error)}get standing(){let e=0;for(const s of this.trays.values())e+=s.copies.size;return e}counts(){const e=new Map;for(const s of this.trays.values())for(const n of s.copies.values())e.set(n.part,(e.get(n.part)??0)+1);return e}get current(){return this.newest?.tray??Math.max(1,...this.trays.keys())}drain(e,s=!1){const n=this.changes.get(e);if(this.changes.delete(e),s)return{cleared:!0,placed:[...this.trays.get(e)?.copies.values()??[]],removed:[]};const i=[],a=[];for(const r of n?.copies.values()??[])"transform"in r?i.push(r):a.push(r);return{cleared:n?.cleared??!1,placed:i,removed:a}}applyEvent(e){const s=e.tray??1;switch(e.event){case"tray_begun":this.trays.set(s,{number:s,copies:new Map,finished:!1}),this.noteCleared(s);break;case"copy_placed":case"copy_put_back":case"copy_moved":this.stand(s,e,e.event==="copy_placed");break;case"copy_taken_out":{const n={part:e.part??0,copy:e.copy??0};this.tray(s).copies.delete(X(n)),this.changesOf(s).copies.set(X(n),n);break}case"tray_finished":this.tray(s).finished=!0;break}}stand(e,s,n){if(!s.transform)return;const i={part:s.part??0,copy:s.copy??0},a=X(i),r=this.tray(e),o=r.copies.get(a)?.order??this.placed++,c={...i,transform:s.transform,order:o};r.copies.set(a,c),this.changesOf(e).copies.set(a,c),n&&(this.newest={tray:e,copy:c})}applyProgress(e){this.progress=e,this.phases.add(e.phase),this.seconds.set(e.phase,e.seconds)}remark(e){this.remarks.includes(e)||this.remarks.push(e)}tray(e){let s=this.trays.get(e);return s||(s={number:e,copies:new Map,finished:!1},this.trays.set(e,s)),s}changesOf(e){let s=this.changes.get(e);return s||(s={cleared:!1,copies:new Map},this.changes.set(e,s)),s}noteCleared(e){this.changes.set(e,{cleared:!0,copies:new Map})}}const Ir={tray:1,follow:!0,colouring:"part",section:null,selected:[],hiddenParts:new Set,hiddenCopies:new Set,isolated:null,find:null},Hr=()=>new nt(Ir);function Br(t,e){const s=X(e);return t.isolated&&!t.isolated.has(s)?!0:t.hiddenParts.has(e.part)||t.hiddenCopies.has(s)}function qr(t){return t.isolated!==null||t.hiddenParts.size>0||t.hiddenCopies.size>0}const qi={hiddenParts:new Set,hiddenCopies:new Set,isolated:null};function Wr(t,e){const s=new Set(t.hiddenParts);return s.delete(e)||s.add(e),{hiddenParts:s}}function Wi(t){return t.selected.length===0?{}:{hiddenCopies:new Set([...t.hiddenCopies,...t.selected.map(X)]),selected:[]}}function Ki(t){return t.isolated?{isolated:null}:t.selected.length>0?{isolated:new Set(t.selected.map(X))}:{}}function Kr(t,e){const s=t.filter(n=>X(n)!==X(e));return s.length<t.length?s:[...t,e]}const Be=[{value:"part",text:"Part"},{value:"order",text:"Order"},{value:"height",text:"Height"},{value:"way",text:"Way out"}];function Gr(t){const e=Be.findIndex(s=>s.value===t);return Be[(e+1)%Be.length]?.value??"part"}const Gi=[480,245,200],Ve={parts:[],unit:"mm",tray:{kind:"box",size:Gi},openHeight:!1,trays:1,keepOut:[],gap:null,wallGap:null,goal:"lowest",timeLimit:null,material:"",physical:!1,options:{},fixed:null},fn={kind:"any"};function us(t,e,s){return{key:s,file:t,object:e,name:null,count:1,scale:1,unit:null,stands:fn,gap:null,priority:0,due:null,order:null,value:null}}function hs(t,e,s){const n=e===null?t:`${t}#${e}`;if(!s.has(n))return n;let i=2;for(;s.has(`${n}*${i}`);)i+=1;return`${n}*${i}`}function Ce(t){return t.openHeight||t.goal==="box"}function Ji(t){return t.tray.kind!=="mesh"&&t.keepOut.length===0}function Jr(t){return t.parts.reduce((e,s)=>e+s.count,0)}function Ye(t,e,s){return{...t,parts:t.parts.map(n=>e.has(n.key)?{...n,...s}:n)}}function ds(t,e){return{...t,parts:t.parts.filter(s=>!e.has(s.key))}}function Vr(t,e,s){return t.parts.some(n=>n.file===e)?{...t,parts:t.parts.map(n=>n.file===e?{...n,file:s}:n)}:t}function Vi(t,e){return e.length===0?t:{...t,parts:[...t.parts,...e]}}function qs(t,e){const s={...t,tray:e};return e.kind==="mesh"?{...s,openHeight:!1,goal:t.goal==="box"?"fill":t.goal}:s}function Yr(t,e){const s={...t,keepOut:[...t.keepOut,e],openHeight:!1};return Ji(s)||s.goal!=="box"?s:{...s,goal:"fill"}}function jt(t,e,s){if(e==="height-at"&&s==="top")return{...Qn(t,e),goal:"lowest"};const n=e==="height-at"&&t.goal==="lowest"?{...t,goal:"fill"}:t;return s===void 0?Qn(n,e):{...n,options:{...n.options,[e]:s}}}function Xn(t,e){return e==="height-at"&&t.goal==="lowest"?"top":t.options[e]}function Qn(t,e){const{[e]:s,...n}=t.options;return{...t,options:n}}const Zr=/\.(stl|3mf|obj|ply|off|csv|json)$/i,Xr={step:"STEP",stp:"STEP",iges:"IGES",igs:"IGES",sldprt:"SolidWorks",ipt:"Inventor",f3d:"Fusion",x_t:"Parasolid",x_b:"Parasolid",sat:"ACIS","3dm":"Rhino",fcstd:"FreeCAD",amf:"AMF",glb:"glTF",gltf:"glTF",dae:"Collada",fbx:"FBX",blend:"Blender"};function Qr(t,e){const s=[],n=[],i=new Set;for(const{file:a,path:r}of t){const o=r.split("/"),c=o.pop()??r;if(c.startsWith("."))continue;if(!Zr.test(c)){const d=to(c,o.length>0);d&&n.push({file:c,error:d});continue}if(a.size>e){n.push({file:c,error:"The file is larger than this server takes. Make it coarser, or raise the limit."});continue}const u=eo(Yi(c),o,i);i.add(u),s.push({file:a,name:u})}return{files:s,refused:n}}function to(t,e){const s=t.split(".").pop()?.toLowerCase()??"",n=Xr[s];return n?`${n} files are not read. Export it as 3MF or STL.`:e?null:"Files of this kind are not read. STL, 3MF, OBJ, PLY and OFF are."}function Yi(t){const e=t.replace(/[\u0000-\u001f\u007f/\\]/g,"_");return e.length<=160?e:e.slice(0,100)+e.slice(-60)}function eo(t,e,s){let n=t;for(let i=e.length-1;i>=0&&s.has(n);i-=1)n=Yi(`${e.slice(i).join("-")}-${t}`);for(let i=2;s.has(n);i+=1)n=t.replace(/(\.[^.]*)$/,`-${i}$1`);return n}function so(t,e){const s=t.map(({path:c})=>c.includes("/")?c.split("/")[0]:"").find(c=>c);if(s)return Ze(s);const n=c=>c.replace(/\.[^.]*$/,""),a=t.find(({file:c})=>/\.(csv|json)$/i.test(c.name))??(t.length===1?t[0]:void 0);if(a)return Ze(n(a.file.name))||"Build";const r=c=>c.toString().padStart(2,"0");return`Build ${`${e.getFullYear()}-${r(e.getMonth()+1)}-${r(e.getDate())}`} ${r(e.getHours())}:${r(e.getMinutes())}`}function Ze(t){let e=t.trim();for(;new TextEncoder().encode(e).length>100;)e=[...e].slice(0,-1).join("");return e}class no{constructor(e,s=()=>Date.now(),n=1200,i=200){this.document=e,this.now=s,this.closely=n,this.most=i,this.past=[],this.future=[],this.tag="",this.at=0}get value(){return this.document}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}change(e,s=""){if(e===this.document)return;const n=this.now();s!==""&&s===this.tag&&n-this.at<this.closely&&this.past.length>0||(this.past.push(this.document),this.past.length>this.most&&this.past.shift()),this.tag=s,this.at=n,this.future=[],this.document=e}undo(){const e=this.past.pop();e!==void 0&&(this.future.push(this.document),this.document=e,this.tag="")}redo(){const e=this.future.pop();e!==void 0&&(this.past.push(this.document),this.document=e,this.tag="")}reset(e){this.past=[],this.future=[],this.tag="",this.document=e}}function Lt(t){return t.split(/[/\\]/).pop()??t}function Zi(t,e){const s={...ye(t.options)},n=k=>{const O=s[k];return delete s[k],O??void 0},i=ye(t.container),a=dt(n("printer")),r=ta(i.size??n("tray")),o=(t.open_height??n("open-height"))===!0,c=t.trays??n("trays"),u=Z(t.gap??n("gap")),d=Z(t.wall_gap??n("wall-gap")),p=Te(t.unit??n("unit")),f=io(n,s["height-at"]);f==="lowest"&&delete s["height-at"];const $=Z(n("time-limit")),y=dt(n("material"));return{parts:oo(t.parts,e),unit:p??"mm",tray:ao(i,a,r),openHeight:o,trays:c==="all"?"all":Math.max(1,Math.round(Z(c)??1)),keepOut:Kt(t.keep_out).flatMap(ro),gap:u,wallGap:d,goal:f,timeLimit:$,material:y??"",physical:i.physical===!0,options:s,fixed:Kt(t.fixed).length>0?t.fixed??null:null}}function io(t,e){return t("minimise")==="box"?"box":e==="top"?"lowest":"fill"}function ao(t,e,s){const n=dt(t.mesh);if(n!==null){const i=t.is;return{kind:"mesh",file:Lt(n),is:i==="solid"||i==="vessel"?i:null,unit:Te(t.unit),transform:t.transform??null}}return s?{kind:"box",size:s}:e===null?Ve.tray:{kind:"printer",name:e}}function ro(t){const e=ye(t),s=dt(e.mesh);if(s!==null)return[{mesh:Lt(s),transform:e.transform??null,unit:Te(e.unit)}];const[n,i]=Kt(e.box).map(ta);return n&&i?[{box:[n,i]}]:[]}function oo(t,e){const s=[],n=new Set;for(const i of Kt(t).map(ye)){const a=dt(i.mesh);if(a===null)continue;const r=Lt(a);for(const o of mn(r,dt(i.object),e)){const c=hs(r,o,n);n.add(c),s.push(lo(i,us(r,o,c)))}}return s}function mn(t,e,s){if(e!==null)return[e];const n=s.filter(i=>i.file===t);return n.length>0?n.map(i=>i.object):[null]}function lo(t,e){return{...e,name:dt(t.name),count:Math.max(1,Math.round(Z(t.count)??1)),scale:Z(t.scale)??1,unit:Te(t.unit),stands:Xi(t.orientations),gap:Z(t.gap),priority:Z(t.priority)??0,due:dt(t.due),order:dt(t.order),value:Z(t.value)}}function Xi(t){if(t==="upright"||t==="fixed")return{kind:t};const e=ye(t);if(e.matrices)return{kind:"matrices",matrices:e.matrices};const s=Kt(e.axes).filter(Qi);return s.length>0?{kind:"axes",axes:s,yaw:Z(e.yaw)}:fn}function Qi(t){return typeof t=="string"&&/^[+-][xyz]$/.test(t)}function Te(t){return t==="mm"||t==="inch"||t==="m"?t:null}function ye(t){return t!==null&&typeof t=="object"&&!Array.isArray(t)?t:{}}function Kt(t){return Array.isArray(t)?t:[]}const dt=t=>typeof t=="string"&&t!==""?t:null,Z=t=>typeof t=="number"&&Number.isFinite(t)?t:null;function ta(t){const[e,s,n=0]=Kt(t).map(Z);return typeof e=="number"&&typeof s=="number"&&n!==null?[e,s,n]:null}const co=(function(){const e=typeof document<"u"&&document.createElement("link").relList;return e&&e.supports&&e.supports("modulepreload")?"modulepreload":"preload"})(),uo=function(t,e){return new URL(t,e).href},ti={},ps=function(e,s,n){let i=Promise.resolve();if(s&&s.length>0){let r=function(d){return Promise.all(d.map(p=>Promise.resolve(p).then(f=>({status:"fulfilled",value:f}),f=>({status:"rejected",reason:f}))))};const o=document.getElementsByTagName("link"),c=document.querySelector("meta[property=csp-nonce]"),u=c?.nonce||c?.getAttribute("nonce");i=r(s.map(d=>{if(d=uo(d,n),d in ti)return;ti[d]=!0;const p=d.endsWith(".css"),f=p?'[rel="stylesheet"]':"";if(!!n)for(let k=o.length-1;k>=0;k--){const O=o[k];if(O.href===d&&(!p||O.rel==="stylesheet"))return}else if(document.querySelector(`link[href="${d}"]${f}`))return;const y=document.createElement("link");if(y.rel=p?"stylesheet":co,p||(y.as="script"),y.crossOrigin="",y.href=d,u&&y.setAttribute("nonce",u),document.head.appendChild(y),p)return new Promise((k,O)=>{y.addEventListener("load",k),y.addEventListener("error",()=>O(new Error(`Unable to preload CSS for ${d}`)))})}))}function a(r){const o=new Event("vite:preloadError",{cancelable:!0});if(o.payload=r,window.dispatchEvent(o),!o.defaultPrevented)throw r}return i.then(r=>{for(const o of r||[])o.status==="rejected"&&a(o.reason);return e().catch(a)})},ho=()=>ps(()=>import("./tray_view-XwCi1PGq.js"),__vite__mapDeps([0,1,2]),import.meta.url),po=()=>ps(()=>import("./part_view-3PIUmjKR.js"),__vite__mapDeps([3,1,2]),import.meta.url),fo=()=>ps(()=>import("./thumbnails-la6s02IT.js"),__vite__mapDeps([4,1]),import.meta.url),mo=()=>ps(()=>import("./bundle-D8DdDFnV.js"),[],import.meta.url),ei=64,$o=16,bo=96;function it(t){return`${t.file}#${t.object??""}:${t.triangles}:${t.volume}:${t.size.join(",")}`}class go{constructor(e){this.job=e,this.state=new nt({version:0}),this.coarse=new Map,this.asked=new Map,this.finer=new Map,this.drawn=new Map,this.latest=new Map,this.wishes=new Map,this.drawing=!1}mesh(e){return this.coarse.get(it(e))??null}async load(e){const s=e.filter(n=>!this.asked.has(it(n)));for(let n=0;n<s.length;n+=ei)this.fetch(s.slice(n,n+ei));await Promise.allSettled(e.map(n=>this.asked.get(it(n))))}fine(e){const s=it(e);let n=this.finer.get(s);return n||(n=this.bundle("fine",[e.id]).then(i=>i[0]??null,()=>(this.finer.delete(s),null)),this.finer.set(s,n)),n}picture(e,s,n){const i=`${it(e)}|${s}|${n}`,a=this.drawn.get(i);return a===void 0&&!this.wishes.has(i)&&(this.wishes.set(i,{mesh:e,colour:s,theme:n}),this.draw()),a??this.latest.get(it(e))??null}fetch(e){const s=e.map(i=>i.id),n=this.bundle("coarse",s).then(i=>{const a=new Map(i.map(r=>[r.id,r]));for(const r of e){const o=a.get(r.id);o&&this.coarse.set(it(r),o)}this.tell()});for(const i of e)this.asked.set(it(i),n);n.catch(()=>{for(const i of e)this.asked.delete(it(i))})}async bundle(e,s){const[{readBundle:n},i]=await Promise.all([mo(),M.meshes(this.job,e,s)]);return n(i)}async draw(){if(!this.drawing){this.drawing=!0;try{for(await new Promise(e=>setTimeout(e,30));this.wishes.size>0;)await this.drawBatch()}finally{this.drawing=!1}}}async drawBatch(){const[,e]=[...this.wishes].at(-1)??[],s=[...this.wishes].reverse().filter(([,r])=>r.theme===e?.theme).slice(0,$o);await this.load(s.map(([,r])=>r.mesh));const n=s.flatMap(([r,{mesh:o,colour:c}])=>{const u=this.mesh(o);return u?[{key:r,own:it(o),mesh:u,colour:c}]:[]});for(const[r]of s)this.wishes.delete(r);if(n.length===0||!e)return;const{thumbnails:i}=await fo(),a=await i(n,bo,e.theme);n.forEach(({key:r,own:o},c)=>{const u=a[c];u!==void 0&&(this.drawn.set(r,u),this.latest.set(o,u))}),this.tell()}tell(){this.state.set({version:this.state.value.version+1})}}function Ws(t,e=()=>!0){const s={format:"spectralpack/job",version:1,unit:t.unit},n=yo(t,e);n&&(s.container=n),t.openHeight&&(s.open_height=!0),t.trays!==1&&!Ce(t)&&(s.trays=t.trays);const i=t.keepOut.filter(r=>"box"in r||e(r.mesh));i.length>0&&(s.keep_out=i.map(vo)),t.gap!==null&&(s.gap=t.gap),t.wallGap!==null&&(s.wall_gap=t.wallGap),t.fixed!==null&&(s.fixed=t.fixed),s.parts=t.parts.filter(r=>e(r.file)).map(wo);const a=xo(t);return Object.keys(a).length>0&&(s.options=a),s}function yo(t,e){const s=t.tray;if(s.kind==="mesh"){if(s.file===null||!e(s.file))return null;const i={mesh:s.file};return s.transform!==null&&(i.transform=s.transform),s.unit!==null&&(i.unit=s.unit),s.is!==null&&(i.is=s.is),t.physical&&(i.physical=!0),i}if(s.kind==="printer")return null;const n={size:t.openHeight&&s.size[2]===0?s.size.slice(0,2):s.size};return t.physical&&(n.physical=!0),n}function vo(t){if("box"in t)return{box:t.box};const e={mesh:t.mesh};return t.transform!==null&&(e.transform=t.transform),t.unit!==null&&(e.unit=t.unit),e}function wo(t){const e={};return t.name!==null&&(e.name=t.name),e.mesh=t.file,t.object!==null&&(e.object=t.object),e.count=t.count,t.scale!==1&&(e.scale=t.scale),t.unit!==null&&(e.unit=t.unit),t.stands.kind!=="any"&&(e.orientations=ko(t.stands)),t.gap!==null&&(e.gap=t.gap),t.priority!==0&&(e.priority=t.priority),t.due!==null&&(e.due=t.due),t.order!==null&&(e.order=t.order),t.value!==null&&(e.value=t.value),e}function ko(t){return t.kind==="axes"?t.yaw===null?{axes:t.axes}:{axes:t.axes,yaw:t.yaw}:t.kind==="matrices"?{matrices:t.matrices}:t.kind}function xo(t){const e={};t.tray.kind==="printer"&&(e.printer=t.tray.name),t.goal==="lowest"&&(e["height-at"]="top"),t.goal==="box"&&(e.minimise="box"),t.timeLimit!==null&&(e["time-limit"]=t.timeLimit),t.material!==""&&(e.material=t.material);for(const[s,n]of Object.entries(t.options))s==="improve"&&n==="rest"&&t.timeLimit===null||(e[s]=n);return e}function si(t){let e=2166136261;for(const s of JSON.stringify(Ws(t)))e=Math.imul(e^(s.codePointAt(0)??0),16777619);return(e>>>0).toString(16)}function ea(t){const e=qt("printer",null),s=t.printers.find(({name:n})=>n===e)??t.printers.find(({gap:n})=>n>0);return s?{kind:"printer",name:s.name}:null}function _o(t){return{...Ve,tray:ea(t)??Ve.tray}}const L=" ";function _(t){return Math.round(t).toString().replace(/\B(?=(\d{3})+$)/g,L)}function yt(t,e=2){return Number(t.toFixed(e)).toString()}const ve=(t,e=1)=>`${t.toFixed(e)}${L}mm`,R=(t,e=1)=>`${(t*100).toFixed(e)}${L}%`;function x(t,e,s=`${e}s`){return`${_(t)} ${t===1?e:s}`}const D=t=>x(t,"copy","copies");function Mo(t){const e=t%100,s=e>10&&e<14?"th":["th","st","nd","rd"][t%10]??"th";return`${_(t)}${s}`}function Xe(t){const e=["bytes","kB","MB","GB","TB"];let s=t,n=0;for(;s>=999.5&&n<e.length-1;)s/=1e3,n+=1;return`${n===0||s>=10?s.toFixed(0):s.toFixed(1)}${L}${e[n]}`}function $n(t){const e=t/1e3;return e>=1e3?`${yt(e/1e3,e>=1e4?1:2)} litres`:e>=1?`${e.toFixed(1)}${L}cm³`:`${_(t)}${L}mm³`}function at(t,e=!1,s="mm"){const n=s==="inch"?t.map(r=>r/25.4):t,i=Math.max(...n)<19.5||Math.min(...n)<.95,a=s==="inch"?2:e||i?1:0;return`${n.map(r=>r.toFixed(a)).join(" × ")}${L}${s==="inch"?"in":"mm"}`}function ut(t){const e=t.replace(/[\s\u202f\u2009]/g,"").replace(",",".");if(!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(e))return null;const s=Number(e);return Number.isFinite(s)?s:null}function Po(t){try{return new TextDecoder("utf-8",{fatal:!0}).decode(t)}catch{return new TextDecoder("windows-1252").decode(t)}}function Oo(t){const e=t.replace(/^\ufeff/,""),s=e.slice(0,e.search(/\r?\n|$/)),n=s.includes(";")&&!s.includes(",")?";":",",i=[];let a=[],r="",o=!1;const c=()=>{a.push(r),r=""},u=()=>{c(),a.some(d=>d.trim()!=="")&&i.push(a),a=[]};for(let d=0;d<e.length;d+=1){const p=e[d];o?p!=='"'?r+=p:e[d+1]==='"'?(r+='"',d+=1):o=!1:p==='"'&&r===""?o=!0:p===n?c():p===`
`?u():p!=="\r"&&(r+=p)}return(r!==""||a.length>0)&&u(),i}function So(t,e,s){const[n,...i]=Oo(t),a=n?.map(c=>c.trim().toLowerCase());if(!a?.some(c=>c==="mesh"||c==="file"))return null;const r=new Set(s),o=[];for(const c of i){const u=(...f)=>{const $=a.findIndex(y=>f.includes(y));return(c[$]??"").trim()},d=u("mesh","file");if(d==="")continue;const p=Lt(d);for(const f of mn(p,null,e)){const $=hs(p,f,r);r.add($);const y=us(p,f,$);o.push({...y,name:u("name")||null,count:Math.max(1,Math.round(ut(u("count","quantity"))??1)),scale:ut(u("scale"))??1,unit:Te(u("unit").toLowerCase()),gap:ut(u("gap")),priority:ut(u("priority"))??0,due:u("due")||null,value:ut(u("value")),stands:Ao(u("orientations"))})}}return o}function Ao(t){const e=t.toLowerCase().split(/\s+/).filter(Qi);return e.length>0?{kind:"axes",axes:e,yaw:null}:Xi(t.toLowerCase())}function Co(t,e,s){const n=new Set(s);return t.rows.flatMap(i=>mn(Lt(i.mesh),null,e).map(a=>{const r=Lt(i.mesh),o=hs(r,a,n);n.add(o);const{name:c,count:u,scale:d,gap:p,priority:f,due:$}=i;return{...us(r,a,o),name:c||null,count:u,scale:d,gap:p,priority:f,due:$}}))}function Ks(t){return new Set([...t.meshes.map(e=>e.file),...t.bad.map(e=>e.file),...t.sets.map(e=>e.file)])}const To=t=>/\.(csv|json)$/i.test(t);function Eo(t,e,s,n){const i=e.sets.filter(r=>s.has(r.file));let a=t;for(const r of i)a=Lo(a,r,e.meshes,n);return i.length>0?a:Vi(a,jo(a,e.meshes,s))}function jo(t,e,s){const n=new Set(t.parts.map(i=>i.key));return na(t,e).filter(i=>s.has(i.file)).map(i=>sa(i,n))}function sa(t,e){const s=hs(t.file,t.object,e);return e.add(s),{...us(t.file,t.object,s),count:Math.max(1,t.instances)}}function Lo(t,e,s,n){if(e.kind==="job")return e.job?Zi(e.job,s):t;const i=n.get(e.file),a=new Set,r=(i===void 0?null:So(i,s,a))??Co(e,s,a),o=new Map(r.map(d=>[d.key,d])),c=t.parts.map(d=>o.get(d.key)??d),u=new Set(t.parts.map(d=>d.key));return{...t,parts:[...c,...r.filter(d=>!u.has(d.key))]}}function na(t,e){const s=new Set;t.tray.kind==="mesh"&&t.tray.file!==null&&s.add(t.tray.file);for(const i of t.keepOut)"mesh"in i&&s.add(i.mesh);const n=new Set(t.parts.map(i=>`${i.file}
${i.object??""}`));return e.filter(i=>!s.has(i.file)&&!n.has(`${i.file}
${i.object??""}`))}const Do={reading:0,meshes:[],bad:[],sets:[]},zo=600;class No{constructor(e,s,n){this.job=e,this.sending=s,this.take=n,this.state=new nt({parts:Do,problem:null}),this.fresh=new Set,this.all=!1,this.timer=0,this.asking=!1,this.closed=!1}add(e){this.fresh.add(e),this.soon(150)}async refresh(){const e=await M.parts(this.job);return this.state.set({parts:e,problem:null}),e}addAll(){this.all=!0,this.soon(0)}soon(e){this.closed||this.asking||(clearTimeout(this.timer),this.timer=window.setTimeout(()=>void this.ask(),e))}close(){this.closed=!0,clearTimeout(this.timer)}async ask(){this.asking=!0;try{const e=await this.refresh();await this.handOn(e)}catch(e){this.state.set({problem:Tt(e)})}finally{this.asking=!1,(this.state.value.parts.reading>0||this.fresh.size>0||this.sending())&&this.soon(zo)}}async handOn(e){const s=e.reading>0||this.sending();if(this.all){if(s)return;for(const a of Ks(e))this.fresh.add(a);this.all=!1}if(s&&[...this.fresh].some(To))return;const n=Ks(e),i=new Set([...this.fresh].filter(a=>n.has(a)));if(i.size>0){const a=await this.texts(e,i);for(const r of i)this.fresh.delete(r);this.take(e,i,a)}s||this.fresh.clear()}async texts(e,s){const n=new Map;for(const i of e.sets)if(!(i.kind!=="set"||!s.has(i.file)))try{n.set(i.file,Po(await M.fileBytes(this.job,i.file)))}catch{}return n}}const Fo=()=>new nt({current:null,chosen:new Set,find:null,advanced:!1,inch:!1});function Ro(t,e){return t.chosen.has(e)?t.chosen:new Set([e])}const Uo=3e3;function Io(t,e){let s=null,n=0;const i=()=>{s=new EventSource(`./api/jobs/${t}/events`);const a=(r,o)=>s?.addEventListener(r,c=>{try{o(JSON.parse(c.data))}catch{}});a("state",r=>e.state(r)),a("line",r=>e.line(r)),a("anew",()=>e.anew()),s.onopen=()=>e.connected(!0),s.onerror=()=>{e.connected(!1),s?.readyState===EventSource.CLOSED&&(n=window.setTimeout(()=>{e.anew(),i()},Uo))}};return i(),()=>{clearTimeout(n),s?.close()}}function Ho(t){const e=t,s=qe(e.container.size);return{size:s,openHeight:e.container.open_height===!0,keepOut:(e.container.keep_out??[]).flatMap(({box:n})=>n?[[qe(n[0]??[]),qe(n[1]??[])]]:[]),parts:e.parts.map((n,i)=>({index:i,name:n.name,file:Lt(n.mesh),object:n.object??null,count:n.count,volume:n.volume,stands:typeof n.orientations=="string"?n.orientations:""})),trays:e.trays.map((n,i)=>Bo(n,i+1,s[0]*s[1])),leftOver:qo(e.unplaced??[]),options:e.options??{},copies:e.metrics.copies,placed:e.metrics.placed,density:e.metrics.density,minGap:e.metrics.min_gap,seconds:e.metrics.seconds?.total??0,improvement:e.metrics.improvement??null}}function Bo(t,e,s){const n=t.disassembly?.steps??[],i=new Map;n.forEach((r,o)=>{for(const c of r.placements)i.has(c)||i.set(c,o)});const a=t.placements.map((r,o)=>{const c=i.get(o),u=c===void 0?void 0:n[c];return{index:o,part:r.part,copy:r.copy,transform:r.transform,fixed:r.fixed===!0,step:c===void 0?null:c+1,path:(u?.path??[]).map(qe),together:u?.placements.length??0}});return{number:e,placements:a,byId:new Map(a.map(r=>[X(r),r])),density:t.density,height:t.height,layers:t.layers?{thickness:t.layers.thickness,share:t.layers.area.map(r=>r/s),exact:!0}:null,steps:n.length,complete:t.disassembly?.complete===!0,throughWalls:t.disassembly?.through_walls?.length??0}}function qo(t){const e=new Map;for(const{part:s,reason:n,detail:i=""}of t){const a=`${s}/${n}`,r=e.get(a);e.set(a,{part:s,reason:n,copies:(r?.copies??0)+1,detail:r?.detail||i})}return[...e.values()]}function qe(t){return[t[0]??0,t[1]??0,t[2]??0]}const J=t=>t.status==="running"||t.status==="queued";class Wo{constructor(e){this.live=new Ur,this.stopWatching=null,this.telling=0,this.closed=!1,this.state=new nt({job:e,packing:null,loading:!1,problem:null,version:0,since:0,stopping:!1})}get id(){return this.state.value.job.id}begin(){this.take(this.state.value.job)}take(e){const s=this.state.value.job;if(this.state.set({job:e}),J(e)){this.stopWatching||this.watch();return}const n=J(s);this.state.set({stopping:!1}),e.has_packing&&(n||!this.state.value.packing)&&this.load()}async refresh(){this.take(await M.job(this.id))}async start(){this.unwatch();const e=await M.start(this.id);this.live.clear(),this.state.set({packing:null,version:this.live.version,stopping:!1}),this.take(e)}async cancel(){this.state.set({stopping:!0});try{this.take(await M.cancel(this.id))}catch(e){throw this.state.set({stopping:!1}),e}}close(){this.closed=!0,this.unwatch()}watch(){this.live.clear(),this.state.set({since:Date.now()}),this.stopWatching=Io(this.id,{state:e=>{this.take(e),J(e)||this.unwatch()},line:e=>{this.live.apply(e),this.tellSoon()},anew:()=>{this.live.clear(),this.tellSoon()},connected:e=>b.set({connected:e})})}unwatch(){this.stopWatching?.(),this.stopWatching=null}tellSoon(){if(this.telling)return;const e=()=>{this.telling=0,this.state.set({version:this.live.version})};this.telling=document.hidden?window.setTimeout(e,500):requestAnimationFrame(e)}async load(){this.state.set({loading:!0,problem:null});try{const e=Ho(await M.packing(this.id));this.closed||this.state.set({packing:e,loading:!1})}catch(e){this.state.set({loading:!1,problem:Tt(e)})}}}const Ko=500,Go=700;class Jo{constructor(e,s){this.job=e,this.there=s,this.state=new nt({saving:!1,problem:null,estimate:null,estimating:!1,doubt:null}),this.saved="",this.stale=!0,this.draft=null,this.saveTimer=0,this.estimateTimer=0,this.asking=null,this.running=Promise.resolve(!0)}begin(e,s){this.draft=e,this.saved=s?this.textOf(e):"",this.state.set({problem:null,doubt:null})}look(){this.stale&&this.textOf(this.draft??Ve)===this.saved&&this.askSoon()}change(e){if(this.draft=e,clearTimeout(this.saveTimer),this.textOf(e)===this.saved){this.stale&&this.askSoon();return}this.stale=!0,this.asking?.abort(),this.saveTimer=window.setTimeout(()=>void this.flush(),Ko)}textOf(e){return JSON.stringify(Ws(e,this.there))}flush(){return clearTimeout(this.saveTimer),this.running=this.running.then(()=>this.save()),this.running}close(){clearTimeout(this.estimateTimer),this.asking?.abort(),this.flush()}async save(){if(!this.draft)return!0;const e=Ws(this.draft,this.there),s=this.textOf(this.draft);if(s===this.saved)return this.state.set({problem:null}),!0;this.state.set({saving:!0});try{return await M.putJobFile(this.job,e),this.saved=s,this.stale=!0,this.state.set({saving:!1,problem:null}),this.askSoon(),!0}catch(n){return this.state.set({saving:!1,problem:Tt(n),estimate:null,estimating:!1}),!1}}askSoon(){if(clearTimeout(this.estimateTimer),this.asking?.abort(),!this.draft||this.draft.parts.length===0){this.state.set({estimate:null,estimating:!1,doubt:null});return}this.state.set({estimating:!0}),this.estimateTimer=window.setTimeout(()=>void this.ask(),Go)}async ask(){const e=new AbortController;this.asking=e;try{const s=await M.estimate(this.job,e.signal);if(e.signal.aborted)return;this.stale=!1,this.state.set({estimate:s,estimating:!1,doubt:null})}catch(s){if(e.signal.aborted)return;this.stale=!1,this.state.set({estimate:null,estimating:!1,doubt:Tt(s)})}}}const Vo=5e3;let pt=null;function Gs(t,e,s=()=>{}){bn();const n={finish:s,timer:0};pt=n,b.set({toast:{text:t,undo:()=>{pt===n&&(ia(),e())}}}),ce(!1)}function ce(t){pt&&(clearTimeout(pt.timer),t||(pt.timer=window.setTimeout(bn,Vo)))}function bn(){const t=pt?.finish;ia(),t?.()}function ia(){pt&&clearTimeout(pt.timer),pt=null,b.set({toast:null})}addEventListener("pagehide",bn);function Yo(t,e,s,n){const i=new XMLHttpRequest,a=new Promise((r,o)=>{i.upload.onprogress=c=>n(c.loaded),i.onload=()=>{i.status>=200&&i.status<300?r():o(Ti(i.status,Zo(i.responseText)))},i.onerror=()=>o(new Xt(Ci,0)),i.onabort=()=>o(new DOMException("stopped","AbortError"))});return i.open("PUT",nr(t,e)),i.setRequestHeader("Content-Type","application/octet-stream"),i.send(s),{done:a,stop:()=>i.abort()}}function Zo(t){try{return JSON.parse(t)}catch{return null}}const ni={total:0,done:0,bytes:0,sent:0,active:!1},Xo=3;class Qo{constructor(e,s){this.job=e,this.told=s,this.state=new nt(ni),this.waiting=[],this.running=new Map,this.doneBytes=0}add(e){if(e.length===0)return;this.waiting.push(...e);const{total:s,bytes:n}=this.state.value,i=e.reduce((a,{file:r})=>a+r.size,0);this.state.set({total:s+e.length,bytes:n+i,active:!0}),this.next()}stop(){this.waiting.length=0;for(const{upload:e}of this.running.values())e.stop();this.finishIfIdle()}next(){for(;this.running.size<Xo;){const e=this.waiting.shift();if(!e)break;this.send(e)}this.finishIfIdle()}send(e){const s={sent:0,upload:Yo(this.job,e.name,e.file,n=>{s.sent=n,this.count()})};this.running.set(e,s),s.upload.done.then(()=>this.told(e.name,null)).catch(n=>{n instanceof Xt&&this.told(e.name,{file:e.name,error:n.message})}).finally(()=>{this.running.delete(e),this.doneBytes+=e.file.size,this.state.set({done:this.state.value.done+1}),this.count(),this.next()})}count(){let e=this.doneBytes;for(const s of this.running.values())e+=s.sent;this.state.set({sent:e})}finishIfIdle(){this.running.size>0||this.waiting.length>0||(this.doneBytes=0,this.state.set(ni))}}class tl{constructor(e,s){this.info=e,this.view=Fo(),this.build=Hr(),this.filesOf=null,this.fileNames=new Set;const n=_o(e);this.history=new no(n),this.state=new nt({draft:n,canUndo:!1,canRedo:!1,refused:[],dismissed:new Set}),this.run=new Wo(s),this.meshes=new go(s.id),this.saver=new Jo(s.id,i=>this.files.has(i)),this.uploads=new Qo(s.id,(i,a)=>this.fileSent(i,a)),this.source=new No(s.id,()=>this.uploads.state.value.active,(i,a,r)=>this.takeFiles(i,a,r))}get id(){return this.run.id}get job(){return this.run.state.value.job}get draft(){return this.state.value.draft}get parts(){return this.source.state.value.parts}get files(){return this.filesOf!==this.parts&&(this.filesOf=this.parts,this.fileNames=new Set(this.parts.meshes.map(e=>e.file))),this.fileNames}get locked(){return J(this.job)}async open(e){const[s,n]=await Promise.all([e?null:M.jobFile(this.id),this.source.refresh()]),i=Array.isArray(s?.parts)&&s.parts.length>0,a=s&&i?Zi(s,n.meshes):this.draft;this.history.reset(a),this.show(),this.saver.begin(a,i),this.source.state.subscribe(()=>this.saver.change(this.draft)),i?n.reading>0&&this.source.soon(0):this.source.addAll(),this.run.begin()}close(){this.uploads.stop(),this.source.close(),this.saver.close(),this.run.close()}edit(e,s=""){this.locked||(this.history.change(e(this.draft),s),this.show(),this.saver.change(this.draft))}editWithToast(e,s){this.edit(s);const n=this.draft;Gs(e,()=>{this.draft===n&&this.undo()})}undo(){this.step(()=>this.history.undo())}redo(){this.step(()=>this.history.redo())}step(e){this.locked||(e(),this.show(),this.saver.change(this.draft))}show(){const{value:e,canUndo:s,canRedo:n}=this.history;this.state.set({draft:e,canUndo:s,canRedo:n});const{current:i,chosen:a}=this.view.value,r=new Set(e.parts.map(c=>c.key)),o=new Set([...a].filter(c=>r.has(c)));this.view.set({current:i!==null&&r.has(i)?i:e.parts[0]?.key??null,chosen:o.size===a.size?a:o})}addFiles(e){const{files:s,refused:n}=Qr(e,this.info.limits.file_bytes),i=new Set(s.map(({name:r})=>r)),a=this.state.value.refused.filter(({file:r})=>!i.has(r));this.state.set({refused:[...a,...n]}),this.uploads.add(s)}replaceFile(e,s){this.dismissRefused(e);const i=s.name.split(".").pop()?.toLowerCase()===e.split(".").pop()?.toLowerCase(),a={file:s,name:i?e:s.name};i||(this.edit(r=>Vr(r,e,a.name)),Ks(this.parts).has(e)&&this.removeFile(e)),this.uploads.add([a])}leaveOutFiles(e){const{dismissed:s,refused:n}=this.state.value;this.state.set({dismissed:new Set([...s,...e])});const i=e.length===1?`${e[0]} is left out.`:`${e.length} files are left out.`,a=()=>{const o=new Set(this.state.value.dismissed);for(const c of e)o.delete(c);this.state.set({dismissed:o})},r=e.filter(o=>!n.some(({file:c})=>c===o));Gs(i,a,()=>{for(const o of e)this.dismissRefused(o);Promise.all(r.map(o=>this.removeFile(o))).then(a)})}async removeFile(e){await Y(()=>M.deleteFile(this.id,e)),await Y(()=>this.source.refresh())}dismissRefused(e){this.state.set({refused:this.state.value.refused.filter(({file:s})=>s!==e)})}fileSent(e,s){s?this.state.set({refused:[...this.state.value.refused,s]}):this.source.add(e)}takeFiles(e,s,n){const i=this.draft.parts.length===0&&!this.history.canUndo;this.edit(a=>Eo(a,e,s,n),"take in"),!(!i||this.locked)&&(this.history.reset(this.draft),this.show())}async pack(){if(this.locked||this.draft.parts.length===0)return;if(!await this.saver.flush()){me(this.saver.state.value.problem);return}await Y(async()=>(await this.run.start(),!0))&&(Qt(`packed.${this.id}`,si(this.draft)),this.build.set({follow:!0,selected:[],section:null,find:null}),tt({page:"job",id:this.id,step:"build"}))}async packWith(e){this.edit(()=>e),await this.pack()}async goOn(){await Y(()=>this.run.start())}async stop(){await Y(()=>this.run.cancel())}get changedSince(){const e=qt(`packed.${this.id}`,null);return e!==null&&e!==si(this.draft)}}const F=new nt({session:null,problem:null});let St="";const aa=new Set;function el(t){aa.add(t)}async function Js(t){if(F.value.session?.id===t)return F.value.session;if(St===t)return null;ra(),St=t;try{const e=b.value.info??await M.info();b.set({info:e});const s=new tl(e,await M.job(t));return await s.open(aa.delete(t)),St!==t?(s.close(),null):(F.set({session:s,problem:null}),s)}catch(e){return St===t&&F.set({problem:e instanceof Error?e.message:"The job cannot be opened."}),null}finally{St===t&&(St="")}}function ra(){St="",F.value.session?.close(),F.set({session:null,problem:null})}function sl(t){const e=t.ctrlKey||t.metaKey?"Ctrl+":"",s=t.altKey?"Alt+":"";if(t.code==="BracketLeft"||t.code==="BracketRight"){if(t.key==="{"||t.key==="[")return`${e}${s}${t.shiftKey?"Shift+":""}[`;if(t.key==="}"||t.key==="]")return`${e}${s}${t.shiftKey?"Shift+":""}]`}if(t.key.length===1&&!/[a-z]/i.test(t.key))return`${e}${s}${t.key}`;const n=t.shiftKey?"Shift+":"",i=t.key.length===1?t.key.toUpperCase():t.key;return`${e}${s}${n}${i==="Escape"?"Esc":i==="Delete"?"Del":i}`}function nl(t,e){return t.some(s=>s===e||s==="1–9"&&/^[1-9]$/.test(e))}const il=t=>/^(Shift\+)?[A-Z0-9]$|^[[\]/]$|^Shift\+[[\]]$/.test(t),Qe=new Set;function gn(t){return Qe.add(t),()=>Qe.delete(t)}function al(){return[...Qe].flat()}function rl(t){return!!t?.closest?.("input:not([type=checkbox]), textarea, select, [contenteditable]")}function ol(t){if(t.defaultPrevented||document.querySelector("dialog[open]"))return;const e=sl(t);if(rl(t.target)&&e!=="Ctrl+Enter"&&e!=="Esc"||il(e)&&!b.value.letterKeys)return;const s=[...Qe].reverse().flat().find(n=>nl(n.keys,e));s&&(t.preventDefault(),e==="Ctrl+Enter"&&document.activeElement?.blur(),s.run(t))}let ii=!1;function ll(){ii||(ii=!0,document.addEventListener("keydown",ol),gn([{keys:["?"],does:"help and keys",run:()=>b.set({dialog:"help"})}]))}class cl extends pn{constructor(e){if(super(e),this.before={},e.type!==Ii.ELEMENT)throw new Error("styles() stands in a tag, not in an attribute")}update(e,[s]){const{style:n}=e.element;for(const i of Object.keys(this.before))i in s||n.removeProperty(i);for(const[i,a]of Object.entries(s))a!==this.before[i]&&(a===null?n.removeProperty(i):n.setProperty(i,a));return this.before=s,mt}render(e){return mt}}const Q=dn(cl),ul={ok:"check",warn:"warn",bad:"bad",run:"clock",plain:null};function we(t,e){const s=ul[t];return l`<span class="badge ${t}">${s?g(s):h}${e}</span>`}function V(t,e,s,n=""){return l`<button type="button" class="btn ghost icon ${n}" aria-label=${e} title=${e} @click=${s}>
    ${g(t)}
  </button>`}function ee(t,e,s,n,i="fill s"){return l`<div class="seg ${i}" role="group" aria-label=${t}>
    ${e.map(a=>l`<button
          type="button"
          aria-pressed=${a.value===s}
          ?disabled=${a.disabled??!1}
          title=${a.title??h}
          @click=${()=>n(a.value)}
        >
          ${a.icon?g(a.icon):h}<span>${a.text}</span>
        </button>`)}
  </div>`}function yn(t,e,s,n=!1){return l`<button
    type="button"
    class="switch ${e?"on":""}"
    role="switch"
    aria-checked=${e}
    aria-label=${t}
    ?disabled=${n}
    @click=${()=>s(!e)}
  ></button>`}function fs(t,e,s,n=null){return l`<button
    type="button"
    class="check ${e?"on":""}"
    role="checkbox"
    aria-checked=${e==="mixed"?"mixed":e}
    aria-label=${t}
    tabindex=${n??h}
    @click=${i=>s(e!==!0,i)}
  >
    ${e==="mixed"?g("minus"):e?g("check"):h}
  </button>`}function Gt(t,e,s,n,i="",a=!1){return l`<span class="pick ${i}">
    <select
      aria-label=${t}
      ?disabled=${a}
      @change=${r=>n(r.target.value)}
    >
      ${s===null?l`<option value="" selected disabled>–</option>`:h}
      ${e.map(r=>l`<option value=${r.value} .selected=${r.value===s}>${r.text}</option>`)}
    </select>
    ${g("down")}
  </span>`}function ms(t,e=null,s=""){const n=`${Math.max(0,Math.min(1,t))*100}%`;return e===null?l`<div class="bar ${s}"><i ${Q({width:n})}></i></div>`:l`<div
        class="bar ${s}"
        role="progressbar"
        aria-label=${e}
        aria-valuemin="0"
        aria-valuemax="100"
        aria-valuenow=${Math.round(t*100)}
      >
        <i ${Q({width:n})}></i>
      </div>`}function B(t,e,s){return l`<div><b>${t} ${e?l`<small>${e}</small>`:h}</b><span>${s}</span></div>`}function ot(t,e="th"){return t?l`<img class=${e} src=${t} alt="" draggable="false" />`:l`<span class="${e} blank"></span>`}var hl=Object.defineProperty,dl=Object.getOwnPropertyDescriptor,oa=(t,e,s,n)=>{for(var i=n>1?void 0:n?dl(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&hl(e,s,i),i};const pl=[["Left button","turns the view"],["Middle button, Shift+left","shifts it"],["Wheel","zooms to the pointer"],["Click","selects a copy; with Ctrl one more"],["Double click","frames it"],["Touch","one finger turns, two shift, pinch zooms, tap selects"]];let Vs=class extends w{stores(){return[b]}firstUpdated(){this.dialog.showModal()}render(){return l`<dialog class="dialog" aria-labelledby="help-title" @close=${()=>b.set({dialog:null})}>
      <div class="head">
        <h2 id="help-title" class="grow">Help</h2>
        <button type="button" class="btn ghost icon" aria-label="Close" @click=${()=>this.dialog.close()}>
          ${g("close")}
        </button>
      </div>
      <div class="scroll">
        <section class="sec">
          <p>
            Bring the parts, choose the printer, press Pack. Copies are placed as densely as they go, each at least the
            gap from the others, and so that all of them can be taken out again one after the other. The result is
            checked on the exact meshes before it can be exported.
          </p>
        </section>
        <section class="sec">
          <h3>Keys on this screen</h3>
          <dl class="keys">
            ${al().map(t=>l`<dt>${t.keys.map((e,s)=>l`${s>0?" ":""}<kbd>${e}</kbd>`)}</dt>
                  <dd>${t.does}</dd>`)}
          </dl>
          <div class="field">
            <span class="dim">Keys of one letter</span>
            ${yn("Keys of one letter",b.value.letterKeys,ar)}
          </div>
        </section>
        <section class="sec">
          <h3>Mouse and touch</h3>
          <dl class="keys">${pl.map(([t,e])=>l`<dt>${t}</dt><dd>${e}</dd>`)}</dl>
        </section>
        <section class="sec">
          <p class="small faint">
            ${b.value.info?.program??"spectralpack"} ·
            <a class="link" href="./openapi.json" download="openapi.json">API description</a>
          </p>
        </section>
      </div>
    </dialog>`}};oa([W("dialog")],Vs.prototype,"dialog",2);Vs=oa([v("sp-help")],Vs);var fl=Object.defineProperty,ml=Object.getOwnPropertyDescriptor,$s=(t,e,s,n)=>{for(var i=n>1?void 0:n?ml(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&fl(e,s,i),i};let ke=class extends w{constructor(){super(...arguments),this.problem="",this.busy=!1}firstUpdated(){this.input.focus()}render(){return l`<main class="token">
      <form class="card" @submit=${this.send}>
        <span class="brand">${Bi} spectralpack</span>
        <h1>Token</h1>
        <p class="dim">This server asks for the token that it printed when it was started.</p>
        <label class="in wide ${this.problem?"wrong":""}">
          <input
            type="password"
            aria-label="Token"
            aria-invalid=${this.problem!==""}
            autocomplete="current-password"
            @input=${()=>{this.problem=""}}
          />
        </label>
        ${this.problem?l`<p class="small bad-text" role="alert">${this.problem}</p>`:h}
        <button class="btn primary l" ?disabled=${this.busy}>Go on</button>
      </form>
    </main>`}async send(t){if(t.preventDefault(),this.input.value.trim()!==""){this.busy=!0;try{await ji(this.input.value),b.set({tokenWanted:!1,problem:null})}catch(e){const s=e instanceof Xt&&e.status===401;this.problem=s?"This is not the token. Look where the server was started.":Tt(e)}finally{this.busy=!1}}}};$s([P()],ke.prototype,"problem",2);$s([P()],ke.prototype,"busy",2);$s([W("input")],ke.prototype,"input",2);ke=$s([v("sp-token")],ke);var $l=Object.getOwnPropertyDescriptor,bl=(t,e,s,n)=>{for(var i=n>1?void 0:n?$l(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=r(i)||i);return i};let ai=class extends w{stores(){return[b]}render(){const t=b.value.toast;return l`<div class="toasts" role="status" aria-live="polite">
      ${t?l`<div
              class="toast"
              @pointerenter=${()=>ce(!0)}
              @pointerleave=${()=>ce(!1)}
              @focusin=${()=>ce(!0)}
              @focusout=${()=>ce(!1)}
            >
              <span class="cut">${t.text}</span>
              <button type="button" class="btn s" @click=${t.undo}>Undo</button>
            </div>`:h}
    </div>`}};ai=bl([v("sp-toast")],ai);const We=[{phase:"load",text:"Read the parts",always:!0},{phase:"voxelize",text:"Prepare shapes",always:!1},{phase:"search",text:"Place copies, slide them together",always:!0},{phase:"disassemble",text:"Check that it comes apart",always:!0},{phase:"reinsert",text:"Put back what was in the way",always:!1},{phase:"improve",text:"Pack it better",always:!1},{phase:"write",text:"Write the files",always:!1},{phase:"check",text:"Measure every gap",always:!0},{phase:"render",text:"Draw the picture",always:!1}];function gl(t){return We.find(e=>e.phase===t)?.text??""}function yl(t,e,s){const n=We.findIndex(i=>i.phase===e);return We.filter(i=>i.always||t.has(i.phase)).map(i=>{const a=We.indexOf(i),r=a===n?"now":t.has(i.phase)||a<n?"done":"wait";return{phase:i.phase,text:i.phase==="load"?`Read ${x(s,"part")}`:i.text,state:r}})}function Dt(t){if(t<9.95)return`${t.toFixed(1)}${L}s`;if(t<119.5)return`${Math.round(t)}${L}s`;const e=Math.round(t/60);if(e<60)return`${e}${L}min`;const s=e%60;return`${Math.floor(e/60)}${L}h${s?` ${s}${L}min`:""}`}function Ds(t){const e=Math.max(0,Math.round(t)),s=a=>a.toString().padStart(2,"0"),n=Math.floor(e/3600),i=Math.floor(e/60)%60;return n?`${n}:${s(i)}:${s(e%60)}`:`${i}:${s(e%60)}`}const vl=["Jan","Feb","Mar","Apr","May","Jun","Jul","Aug","Sep","Oct","Nov","Dec"];function Ys(t){return`${t.getDate()} ${vl[t.getMonth()]??""}`}function vn(t){return`${t.getHours().toString().padStart(2,"0")}:${t.getMinutes().toString().padStart(2,"0")}`}function wl(t,e){if(e.getTime()-t.getTime()<6e4)return"now";const s=a=>new Date(a.getFullYear(),a.getMonth(),a.getDate()).getTime(),n=Math.round((s(e)-s(t))/864e5);return n<=0?vn(t):n===1?"yesterday":t.getFullYear()===e.getFullYear()||n<180?Ys(t):`${Ys(t)} ${t.getFullYear()}`}function ri(t,e){const[s,n,i]=t.split("-").map(Number);if(!s||!n||!i)return t;const a=Ys(new Date(s,n-1,i));return s===e.getFullYear()||Math.abs(n-1+12*(s-e.getFullYear())-e.getMonth())<6?a:`${a} ${s}`}function kl(t){const e=t.progress;return e&&e.total>0?Math.min(1,e.done/e.total):0}function Jt(t){const e=t.verdict;return e?e.apart==="no"?{tone:"bad",text:"Does not come apart"}:e.ok?e.apart==="not_checked"?{tone:"warn",text:"Coming apart: not checked"}:{tone:"ok",text:"Comes apart"}:{tone:"bad",text:"Check failed"}:null}function ts(t){switch(t.status){case"new":return{tone:"plain",text:"Not packed yet"};case"queued":return{tone:"plain",text:t.queue_place?`Waiting: place ${t.queue_place}`:"Waiting"};case"running":return{tone:"run",text:xl(t)};case"failed":return{tone:"bad",text:"Failed"};case"interrupted":return{tone:"warn",text:"Interrupted"};case"cancelled":return t.has_packing?Jt(t)??{tone:"warn",text:"Stopped"}:{tone:"warn",text:"Stopped"};default:return Jt(t)??{tone:"plain",text:"Packed"}}}function xl(t){const e=t.progress?.phase;return e==="search"?`Packing ${R(kl(t),0)}`:e==="improve"?"Improving":e==="disassemble"||e==="reinsert"||e==="check"?"Checking":e==="render"||e==="write"?"Writing":"Packing"}function la(t){if(t.status==="failed"&&t.error)return q(t.error);const e=t.progress;if(t.status==="running"&&e){const n=typeof e.left=="number"?` · about ${Dt(e.left)} left`:"";return e.phase==="search"?`${_(e.done)} of ${_(e.total)} placed${n}`:`${gl(e.phase)}${n}`}const s=t.summary;return s?`${_(s.placed)} of ${D(s.copies)} · ${R(s.density)} full`:t.files===0?"no files yet":t.files===1?"1 file":`${_(t.files)} files`}function _l(t){const e=t.summary&&t.summary.trays>1?` · ${t.summary.trays} trays`:"";return(t.tray??"No tray chosen yet")+e}function Ml(t){return`Interrupted ${vn(new Date(t.changed))}`}var Pl=Object.defineProperty,Ol=Object.getOwnPropertyDescriptor,$t=(t,e,s,n)=>{for(var i=n>1?void 0:n?Ol(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Pl(e,s,i),i};let rt=class extends w{constructor(){super(...arguments),this.button="",this.content=()=>l``,this.label="",this.buttonClasses="btn",this.menuClasses="",this.disabled=!1,this.hint="",this.open=!1,this.outside=t=>{this.contains(t.target)||this.close(!1)},this.moved=t=>{const e=this.querySelector(".menu");t.target instanceof Node&&e?.contains(t.target)||this.close(!1)}}disconnectedCallback(){super.disconnectedCallback(),this.stopListening()}render(){return l`<button
        type="button"
        class=${this.buttonClasses}
        aria-haspopup="menu"
        aria-expanded=${this.open}
        aria-label=${this.label||h}
        title=${this.hint||h}
        ?disabled=${this.disabled}
        @click=${()=>this.open?this.close(!0):this.show()}
        @keydown=${t=>{t.key!=="ArrowDown"||this.open||(t.preventDefault(),this.show())}}
      >
        ${this.button}
      </button>
      ${this.open?l`<div
              class="menu ${this.menuClasses}"
              popover="manual"
              role="menu"
              @keydown=${this.key}
              @click=${this.clicked}
              @focusout=${this.left}
            >
              ${this.content()}
            </div>`:h}`}show(){this.disabled||(this.open=!0,document.addEventListener("pointerdown",this.outside,!0),document.addEventListener("scroll",this.moved,!0),addEventListener("resize",this.moved),this.updateComplete.then(()=>{this.place(),this.items()[0]?.focus({preventScroll:!0})}))}place(){const t=this.querySelector(".menu"),e=this.querySelector("button[aria-haspopup]")?.getBoundingClientRect();if(!t||!e)return;t.showPopover();const s=t.getBoundingClientRect(),n=8,i=e.left+s.width>innerWidth-n?e.right-s.width:e.left,a=e.bottom+4,r=a+s.height>innerHeight-n?e.top-4-s.height:a;t.style.left=`${Math.max(n,i)}px`,t.style.top=`${Math.max(n,r)}px`}stopListening(){document.removeEventListener("pointerdown",this.outside,!0),document.removeEventListener("scroll",this.moved,!0),removeEventListener("resize",this.moved)}close(t){this.open&&(this.open=!1,this.stopListening(),t&&this.querySelector("button[aria-haspopup]")?.focus())}items(){return[...this.querySelectorAll(".menu [role^=menuitem]:not([disabled]):not([aria-disabled=true])")]}clicked(t){const e=t.target.closest("[role^=menuitem]");e&&!e.hasAttribute("data-stays")&&this.close(!0)}left(t){t.relatedTarget&&!this.contains(t.relatedTarget)&&this.close(!1)}key(t){const e=this.items(),s=e.indexOf(document.activeElement),i={ArrowDown:s+1,ArrowUp:s-1+e.length,Home:0,End:e.length-1}[t.key];i!==void 0&&e.length>0?(t.preventDefault(),t.stopPropagation(),e[i%e.length]?.focus()):t.key==="Escape"&&(t.stopPropagation(),this.close(!0))}};$t([m({attribute:!1})],rt.prototype,"button",2);$t([m({attribute:!1})],rt.prototype,"content",2);$t([m()],rt.prototype,"label",2);$t([m()],rt.prototype,"buttonClasses",2);$t([m()],rt.prototype,"menuClasses",2);$t([m({type:Boolean})],rt.prototype,"disabled",2);$t([m()],rt.prototype,"hint",2);$t([P()],rt.prototype,"open",2);rt=$t([v("sp-menu")],rt);let pe=null;function Sl(t){return pe=t,()=>{pe===t&&(pe=null)}}async function Al(){return pe?pe():null}var Cl=Object.defineProperty,Tl=Object.getOwnPropertyDescriptor,Ee=(t,e,s,n)=>{for(var i=n>1?void 0:n?Tl(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Cl(e,s,i),i};const El=[{kind:"3mf",icon:"box",text:"3MF for the slicer",what:"every copy in its place"},{kind:"stl",icon:"mesh",text:"STL",what:"all copies in one mesh"},{kind:"json",icon:"braces",text:"Packing file (JSON)",what:"everything, exactly"},{kind:"csv",icon:"list",text:"List of copies (CSV)",what:"part, number, place"}];let Vt=class extends w{constructor(){super(...arguments),this.all=!1,this.drawing=!1}stores(){return[this.session.run.state,this.session.build]}show(){this.menu.show()}render(){const{job:t}=this.session.run.state.value,e=t.verdict!==null&&!t.verdict.ok&&t.verdict.findings.length>0;return l`<sp-menu
      buttonClasses="btn primary"
      menuClasses="export"
      hint=${e?"The check found faults: nothing is exported":"Export (Ctrl+E)"}
      ?disabled=${e}
      .button=${l`${this.drawing?ht:g("download")}Export${g("down")}`}
      .content=${()=>this.entries()}
    ></sp-menu>`}entries(){const{job:t,packing:e}=this.session.run.state.value,s=this.session.build.value.tray,n=e?.trays.length??1,i=n>1&&s>0&&!this.all?s:null,a=Jt(t),r=i===null?e?.placed:e?.trays[i-1]?.placements.length;return l`<div class="row between menu-head">
        ${a?we(a.tone,a.tone==="ok"?"Comes apart: checked":a.text):h}
        <span class="small faint">${D(r??0)}</span>
      </div>
      ${n>1&&s>0?l`<div class="seg fill s" role="group" aria-label="Which trays">
              ${this.choice(`Tray ${s}`,!1)}${this.choice(`All ${n} trays`,!0)}
            </div>`:h}
      ${El.map(o=>this.link(o,o.kind==="json"?null:i))}
      ${s>0?l`<button type="button" class="mi" role="menuitem" @click=${()=>this.drawView()}>
              ${g("picture")}<span>Picture (PNG)<span>the view as it is now</span></span>
            </button>`:this.link({kind:"png",icon:"picture",text:"Picture (PNG)",what:"all trays"},null)}
      <hr />
      ${this.link({kind:"html",icon:"printer",text:"Printable report",what:"pictures, parts, way out, left over"},i)}`}choice(t,e){return l`<button
      type="button"
      role="menuitemradio"
      aria-checked=${this.all===e}
      data-stays
      @click=${()=>{this.all=e}}
    >
      ${t}
    </button>`}link(t,e){return l`<a
      class="mi"
      role="menuitem"
      href=${rn(this.session.id,t.kind,e)}
      download=${this.fileName(t.kind,e)}
    >
      ${g(t.icon)}<span>${t.text}<span>${t.what}</span></span>
    </a>`}fileName(t,e){return`${this.session.job.name.replace(/[^\p{L}\p{N} ._-]+/gu,"").trim()||"build"}${e===null?"":` tray ${e}`}.${t}`}async drawView(){this.drawing=!0;const t=await Y(()=>Al());if(this.drawing=!1,!t)return;const e=document.createElement("a");e.href=URL.createObjectURL(t),e.download=this.fileName("png",this.session.build.value.tray),e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}};Ee([m({attribute:!1})],Vt.prototype,"session",2);Ee([P()],Vt.prototype,"all",2);Ee([P()],Vt.prototype,"drawing",2);Ee([W("sp-menu")],Vt.prototype,"menu",2);Vt=Ee([v("sp-export")],Vt);const jl=6,Ll=500,Dl=2e3,U=new nt({jobs:null,total:0,bytes:0,find:null,all:!1,going:new Set,dismissed:qt("dismissed",[]),failed:!1});let oi=0,zs=0;async function xe(){const{find:t,all:e}=U.value;try{const s=await M.jobs(t??"",e||t?Ll:jl);U.set({jobs:s.jobs,total:s.total,bytes:s.bytes,failed:!1})}catch{U.set({failed:!0})}}function zl(){zs+=1;const t=async()=>{document.hidden||await xe(),zs>0&&(oi=window.setTimeout(t,Dl))},e=()=>{document.hidden||xe()};return document.addEventListener("visibilitychange",e),t(),()=>{zs-=1,clearTimeout(oi),document.removeEventListener("visibilitychange",e)}}function Ue(t){U.set({find:t}),xe()}function li(t){U.set({all:t}),xe()}function ca(t){U.set({going:new Set([...U.value.going,t.id])});const e=()=>{const s=new Set(U.value.going);s.delete(t.id),U.set({going:s})};Gs(`“${t.name}” is deleted${J(t)?", and stopped":""}.`,e,()=>{Y(()=>M.deleteJob(t.id)).then(xe).then(e)})}const ua=t=>`${t.id} ${t.changed}`;function Nl(t){return(t.jobs??[]).filter(e=>e.status==="interrupted"&&!t.going.has(e.id)&&!t.dismissed.includes(ua(e)))}function Fl(t){const e=[...U.value.dismissed.slice(-50),ua(t)];Qt("dismissed",e),U.set({dismissed:e})}async function Rl(t){t.length!==0&&await Y(async()=>{const e=await M.createJob({name:so(t,new Date)});el(e.id),(await Js(e.id))?.addFiles(t),tt({page:"job",id:e.id,step:"parts"})})}async function Ul(){await Y(async()=>{const t=await M.createJob({name:"Sample",sample:!0});tt({page:"job",id:t.id,step:"parts"})})}async function ha(t,e){await Y(async()=>{const s=await M.createJob({copy_of:t,name:Ze(`${e} copy`)});tt({page:"job",id:s.id,step:"parts"})})}var Il=Object.defineProperty,Hl=Object.getOwnPropertyDescriptor,bs=(t,e,s,n)=>{for(var i=n>1?void 0:n?Hl(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Il(e,s,i),i};let _e=class extends w{constructor(){super(...arguments),this.renaming=!1}stores(){return[this.session.run.state]}render(){const{job:t}=this.session;return this.renaming?l`<span class="in rename">
        <input
          aria-label="Name of the job"
          maxlength="100"
          .value=${t.name}
          @blur=${()=>this.rename(!0)}
          @keydown=${e=>{e.key==="Enter"&&this.rename(!0),e.key==="Escape"&&this.rename(!1)}}
        />
      </span>`:l`<sp-menu
      label=${`Job: ${t.name}`}
      buttonClasses="btn ghost name"
      .button=${l`<span class="cut">${t.name}</span>${g("down")}`}
      .content=${()=>l`
        <button type="button" class="mi" role="menuitem" @click=${()=>this.begin()}>
          ${g("drawn")}<span>Rename</span>
        </button>
        <button type="button" class="mi" role="menuitem" @click=${()=>ha(t.id,t.name)}>
          ${g("copy")}<span>Copy the job</span>
        </button>
        <button
          type="button"
          class="mi danger"
          role="menuitem"
          @click=${()=>{ca(t),tt({page:"start"})}}
        >
          ${g("trash")}<span>Delete the job</span>
        </button>
        <hr />
        <button type="button" class="mi" role="menuitem" @click=${()=>tt({page:"start"})}>
          ${g("list")}<span>All jobs</span>
        </button>
      `}
    ></sp-menu>`}begin(){this.renaming=!0,this.updateComplete.then(()=>this.input?.select())}async rename(t){if(!this.renaming)return;const e=Ze(this.input?.value??"");if(this.renaming=!1,!t||e===""||e===this.session.job.name)return;const s=await Y(()=>M.rename(this.session.id,e));s&&this.session.run.take(s)}};bs([m({attribute:!1})],_e.prototype,"session",2);bs([P()],_e.prototype,"renaming",2);bs([W("input")],_e.prototype,"input",2);_e=bs([v("sp-job-menu")],_e);const Bl=[{value:"light",text:"Light",icon:"sun"},{value:"dark",text:"Dark",icon:"moon"},{value:"system",text:"As the system",icon:"system"}];function ql(){return l`<sp-menu
    label="Light or dark"
    hint="Light or dark"
    buttonClasses="btn ghost icon"
    .button=${g(b.value.theme==="dark"?"sun":"moon")}
    .content=${()=>l`${Bl.map(t=>l`<button
            type="button"
            class="mi"
            role="menuitemradio"
            aria-checked=${b.value.choice===t.value}
            @click=${()=>or(t.value)}
          >
            ${g(t.icon)}<span>${t.text}</span>${b.value.choice===t.value?g("check"):""}
          </button>`)}`}
  ></sp-menu>`}var Wl=Object.getOwnPropertyDescriptor,Kl=(t,e,s,n)=>{for(var i=n>1?void 0:n?Wl(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=r(i)||i);return i};let ci=class extends w{get session(){const{route:t}=b.value,e=F.value.session;return t.page==="job"&&e?.id===t.id?e:null}stores(){const t=this.session;return t?[b,F,t.state,t.run.state]:[b,F]}render(){const t=this.session,{route:e}=b.value,s=e.page==="job"?e.step:null;return l`<header class="top">
      <div class="row first">
        <a class="brand" href="#/" aria-label="spectralpack: all jobs">${Bi}<span class="hide-s">spectralpack</span></a>
        ${t?l`<span class="rule"></span><sp-job-menu .session=${t}></sp-job-menu>${this.state(t)}`:h}
      </div>
      ${t&&s?this.steps(t,s):l`<span></span>`}
      <div class="row last">
        ${t&&s==="parts"?this.undo(t):h} ${ql()}
        ${V("help","Help and keys (?)",()=>b.set({dialog:"help"}))}
        ${t&&s==="build"?this.result(t):h}
      </div>
    </header>`}state(t){return J(t.job)?we("run",ts(t.job).text):h}steps(t,e){const s=t.job.status!=="new"||t.job.has_packing,n=(i,a,r)=>r?l`<a
            class="tab"
            href=${Ke({page:"job",id:t.id,step:i})}
            aria-current=${e===i?"step":h}
            >${a}</a
          >`:l`<span class="tab" aria-disabled="true" title="Press Pack first">${a}</span>`;return l`<nav class="tabs" aria-label="Steps">${n("parts","Parts",!0)}${n("build","Build",s)}</nav>`}undo(t){const{canUndo:e,canRedo:s}=t.state.value,n=t.locked;return l`<button
        type="button"
        class="btn ghost icon"
        aria-label="Undo (Ctrl+Z)"
        title="Undo (Ctrl+Z)"
        ?disabled=${!e||n}
        @click=${()=>t.undo()}
      >
        ${g("undo")}
      </button>
      <button
        type="button"
        class="btn ghost icon"
        aria-label="Redo (Ctrl+Shift+Z)"
        title="Redo (Ctrl+Shift+Z)"
        ?disabled=${!s||n}
        @click=${()=>t.redo()}
      >
        ${g("redo")}
      </button>
      <span class="rule"></span>`}result(t){const{job:e,packing:s}=t.run.state.value;if(J(e)||!s)return h;const n=Jt(e),i=n?.tone==="ok";return l`<span class="rule hide-s"></span>
      ${n?we(n.tone,i?l`<span class="hide-s">Comes apart: checked</span><span class="show-s">Checked</span>`:n.text):h}
      <sp-export .session=${t}></sp-export>`}};ci=Kl([v("sp-top-bar")],ci);var Gl=Object.defineProperty,Jl=Object.getOwnPropertyDescriptor,se=(t,e,s,n)=>{for(var i=n>1?void 0:n?Jl(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Gl(e,s,i),i};let zt=class extends w{constructor(){super(...arguments),this.property="",this.side="left",this.label="",this.least=200,this.most=900,this.grab=t=>{const e=this.panel;if(!e)return;t.preventDefault(),this.setPointerCapture(t.pointerId);const s=e.getBoundingClientRect().width,n=t.clientX,i=r=>{const o=r.clientX-n;this.show(s+(this.side==="left"?o:-o))},a=()=>{this.removeEventListener("pointermove",i),e.getBoundingClientRect().width!==s&&this.put(e.getBoundingClientRect().width)};this.addEventListener("pointermove",i),this.addEventListener("lostpointercapture",a,{once:!0})},this.key=t=>{const e=t.key==="ArrowLeft"?-16:t.key==="ArrowRight"?16:0;e===0||!this.panel||(t.preventDefault(),t.stopPropagation(),this.put(this.panel.getBoundingClientRect().width+(this.side==="left"?e:-e)))}}connectedCallback(){super.connectedCallback(),this.tabIndex=0,this.setAttribute("role","separator"),this.setAttribute("aria-orientation","vertical"),this.addEventListener("pointerdown",this.grab),this.addEventListener("dblclick",()=>this.put(null)),this.addEventListener("keydown",this.key)}updated(){this.setAttribute("aria-label",this.label);const t=qt(`width${this.property}`,null);t!==null&&this.show(t);const{panel:e}=this;e&&this.setAttribute("aria-valuenow",e.getBoundingClientRect().width.toFixed(0)),this.setAttribute("aria-valuemin",String(this.least)),this.setAttribute("aria-valuemax",String(this.most))}get panel(){return this.side==="left"?this.previousElementSibling:this.nextElementSibling}show(t){const e=Math.max(this.least,Math.min(this.most,t));this.parentElement?.style.setProperty(this.property,`${e}px`),this.setAttribute("aria-valuenow",e.toFixed(0))}put(t){Qt(`width${this.property}`,t),t===null?this.parentElement?.style.removeProperty(this.property):this.show(t)}};se([m()],zt.prototype,"property",2);se([m()],zt.prototype,"side",2);se([m()],zt.prototype,"label",2);se([m({type:Number})],zt.prototype,"least",2);se([m({type:Number})],zt.prototype,"most",2);zt=se([v("sp-divider")],zt);function gs(t,e){const s=t.tray;return s.kind==="printer"?e.printers.find(n=>n.name===s.name)??null:null}function xt(t,e,s){const n=t.tray;return n.kind==="box"?n.size:n.kind==="printer"?gs(t,e)?.size??null:s.find(a=>a.file===n.file)?.size??null}function ys(t,e){return t.gap??gs(t,e)?.gap??.2}function wn(t,e){return t.wallGap??gs(t,e)?.wall_gap??0}function Vl(t,e,s){const n=xt(t,e,s);if(!n)return null;const i=2*wn(t,e),a=t.openHeight?Number.POSITIVE_INFINITY:n[2]-i;return[n[0]-i,n[1]-i,a]}const Yl={x:0,y:1,z:2};function kn(t,e){const{packing:s}=t.run.state.value;return s?.size[Yl[e]]??0}function da(t,e,s){if(s?.axis===e)return s;const{packing:n}=t.run.state.value,i=n?.trays[t.build.value.tray-1],a=e==="z"&&i?i.height:kn(t,e);return{axis:e,at:Math.round(a*5)/10,flipped:!1}}function pa(t,e,s){const{packing:n}=t.run.state.value,a=n?.trays[t.build.value.tray-1]?.layers?.thickness??1,r=Math.max(0,Math.min(kn(t,e.axis),e.at+s*a));return{...e,at:Math.round(r*10)/10}}function fa(t){return t.filter(e=>!/journal|same command/.test(e)).map(q)}function Bt(t,e,s,n,i){return l`<div class="note ${t}" role="status">
    ${g(e)}
    <div>
      <p><b>${s}</b> ${n}</p>
      ${i.length>0?l`<div class="row wrap">
              ${i.map(a=>l`<button type="button" class="btn s" @click=${a.run}>${a.text}</button>`)}
            </div>`:h}
    </div>
  </div>`}function Zl(t,e,s){const n=[...Xl(t,e),...Ql(t),...tc(t,e,s)],i=fa(t.job.remarks);return n.length===0&&i.length===0?h:l`<section class="sec stack">
    ${n}
    ${i.length>0?l`<ul class="said">
            ${i.map(a=>l`<li>${a}</li>`)}
          </ul>`:h}
  </section>`}function Xl(t,e){const{job:s,draft:n}=t,i={text:"Pack again",run:()=>void t.pack()},a=e.leftOver.filter(r=>r.reason==="not_tried").reduce((r,o)=>r+o.copies,0);if(s.status==="interrupted"){const r=vn(new Date(s.changed));return[Bt("warn","warn",`Interrupted at ${r}.`,"The computer or the program stopped. This is the best packing so far.",[{text:"Continue packing",run:()=>void t.goOn()}])]}if(s.status==="cancelled")return[Bt("info","info","Stopped.","This is the best packing so far.",[{text:"Go on packing",run:()=>void t.goOn()}])];if(s.status==="failed")return[Bt("bad","bad","The run failed.",s.error?q(s.error):"",[i])];if(a>0&&n.timeLimit!==null){const r=n.timeLimit*2;return[Bt("warn","clock",`Time limit of ${Dt(n.timeLimit)} reached.`,`This is the best packing found; ${D(a)} ${a===1?"was":"were"} not tried.`,[{text:`Pack again with ${Dt(r)}`,run:()=>void t.packWith({...n,timeLimit:r})}])]}return[]}function Ql(t){return t.changedSince?[Bt("info","info","Parts or settings have changed since.","This build does not have the changes.",[])]:[]}function tc(t,e,s){const n=e.trays[e.trays.length-1];if(s!==0||!n||e.trays.length<2||!xn(e,n.number))return[];const i=e.trays.length-1;return[Bt("warn","warn",`Tray ${n.number} holds ${D(n.placements.length)}.`,"It may not be worth a print.",[{text:i===1?"Pack again with 1 tray":`Pack again with ${_(i)} trays`,run:()=>void t.packWith({...t.draft,trays:i})}])]}function xn(t,e){const s=t.trays[e-1],n=Math.max(...t.trays.map(i=>i.density));return s!==void 0&&t.trays.length>1&&s.density<n/8}function ui(t,e,s){if(e.trays.length<2)return h;const n=(i,a)=>l`<button
      type="button"
      class="tt ${i===s?"on":""}"
      role="tab"
      aria-selected=${i===s}
      tabindex=${i===s?0:-1}
      @click=${()=>es(t,i)}
    >
      ${a}
    </button>`;return l`<nav class="tstrip" aria-label="Trays"><div class="tabs-row" role="tablist" @keydown=${i=>ec(i)}>
    ${n(0,l`<span class="alone"><b>All trays</b><small>${D(e.placed)}</small></span>`)}
    ${e.trays.map(i=>n(i.number,l`<img src=${rn(t.id,"png",i.number)} alt="" loading="lazy" />
          <span>
            <b>Tray ${i.number}</b>
            <small
              >${R(i.density)}${xn(e,i.number)?l` <span class="warn-text" title="Nearly empty">${g("warn")}</span>`:h}</small
            >
          </span>`))}
  </div></nav>`}function es(t,e){t.build.set({tray:e,follow:!1,selected:[],find:null})}function ec(t){const e=t.key==="ArrowRight"?1:t.key==="ArrowLeft"?-1:0;if(e===0)return;const s=[...t.currentTarget.querySelectorAll("[role=tab]")],n=s.indexOf(document.activeElement),i=s[(n+e+s.length)%s.length];t.preventDefault(),t.stopPropagation(),i?.focus(),i?.click()}function sc({session:t,frame:e,openExport:s},n){const i=()=>t().build,a=c=>({keys:[c.toUpperCase()],does:`section along ${c.toUpperCase()}; again: off`,run:()=>{const u=i().value.section;i().set({section:u?.axis===c?null:da(t(),c,u)})}}),r=(c,u,d)=>({keys:[c],does:d,run:()=>{const{section:p}=i().value;p&&i().set({section:pa(t(),p,u)})}}),o=[{keys:["F"],does:"frame what is selected",run:()=>e(!1)},{keys:["Shift+F"],does:"frame all",run:()=>e(!0)},{keys:["/"],does:"find a copy or part",run:()=>i().set({find:i().value.find??""})},{keys:["Esc"],does:"close, let go",run:()=>i().set({find:null,selected:[]})}];return n?o:[...o,a("x"),a("y"),a("z"),r("[",-1,"section a layer down"),r("]",1,"section a layer up"),r("Shift+[",-10,"section ten layers down"),r("Shift+]",10,"section ten layers up"),{keys:["B"],does:"other side of the section",run:()=>{const{section:c}=i().value;c&&i().set({section:{...c,flipped:!c.flipped}})}},{keys:["H"],does:"hide what is selected",run:()=>i().set(Wi(i().value))},{keys:["I"],does:"show only what is selected",run:()=>i().set(Ki(i().value))},{keys:["Shift+H"],does:"show all",run:()=>i().set(qi)},{keys:["C"],does:"next colouring",run:()=>i().set({colouring:Gr(i().value.colouring)})},{keys:["1–9"],does:"that tray",run:c=>{const u=Number(c.key);(t().run.state.value.packing?.trays.length??0)>=u&&es(t(),u)}},{keys:["0"],does:"all trays",run:()=>{(t().run.state.value.packing?.trays.length??0)>1&&es(t(),0)}},{keys:["Ctrl+E"],does:"export",run:s},{keys:["Ctrl+Enter"],does:"pack again",run:()=>void t().pack()}]}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const hi=(t,e,s)=>{const n=new Map;for(let i=e;i<=s;i++)n.set(t[i],i);return n},_n=dn(class extends pn{constructor(t){if(super(t),t.type!==Ii.CHILD)throw Error("repeat() can only be used in text expressions")}dt(t,e,s){let n;s===void 0?s=e:e!==void 0&&(n=e);const i=[],a=[];let r=0;for(const o of t)i[r]=n?n(o,r):r,a[r]=s(o,r),r++;return{values:a,keys:i}}render(t,e,s){return this.dt(t,e,s).values}update(t,[e,s,n]){const i=Nr(t),{values:a,keys:r}=this.dt(e,s,n);if(!Array.isArray(i))return this.ut=r,a;const o=this.ut??=[],c=[];let u,d,p=0,f=i.length-1,$=0,y=a.length-1;for(;p<=f&&$<=y;)if(i[p]===null)p++;else if(i[f]===null)f--;else if(o[p]===r[$])c[$]=Ot(i[p],a[$]),p++,$++;else if(o[f]===r[y])c[y]=Ot(i[f],a[y]),f--,y--;else if(o[p]===r[y])c[y]=Ot(i[p],a[y]),oe(t,c[y+1],i[p]),p++,y--;else if(o[f]===r[$])c[$]=Ot(i[f],a[$]),oe(t,i[p],i[f]),f--,$++;else if(u===void 0&&(u=hi(r,$,y),d=hi(o,p,f)),u.has(o[p]))if(u.has(o[f])){const k=d.get(r[$]),O=k!==void 0?i[k]:null;if(O===null){const N=oe(t,i[p]);Ot(N,a[$]),c[$]=N}else c[$]=Ot(O,a[$]),oe(t,i[p],O),i[k]=null;$++}else Ls(i[f]),f--;else Ls(i[p]),p++;for(;$<=y;){const k=oe(t,c[y+1]);Ot(k,a[$]),c[$++]=k}for(;p<=f;){const k=i[p++];k!==null&&Ls(k)}return this.ut=r,Hi(t,c),mt}});function Ns(t){return t<=.04045?t/12.92:((t+.055)/1.055)**2.4}function nc(t){return t<=.0031308?t*12.92:1.055*t**(1/2.4)-.055}function ue(t){const e=Number.parseInt(t.slice(1),16);return[Ns((e>>16)/255),Ns((e>>8&255)/255),Ns((e&255)/255)]}function ma(t){const e=s=>Math.round(255*nc(Math.min(1,Math.max(0,s)))).toString(16).padStart(2,"0");return`#${e(t[0])}${e(t[1])}${e(t[2])}`}function Zs([t,e,s]){const n=Math.cbrt(.4122214708*t+.5363325363*e+.0514459929*s),i=Math.cbrt(.2119034982*t+.6806995451*e+.1073969566*s),a=Math.cbrt(.0883024619*t+.2817188376*e+.6299787005*s);return[.2104542553*n+.793617785*i-.0040720468*a,1.9779984951*n-2.428592205*i+.4505937099*a,.0259040371*n+.7827717662*i-.808675766*a]}function $a([t,e,s]){const n=(t+.3963377774*e+.2158037573*s)**3,i=(t-.1055613458*e-.0638541728*s)**3,a=(t-.0894841775*e-1.291485548*s)**3;return[4.0767416621*n-3.3077115913*i+.2309699292*a,-1.2684380046*n+2.6097574011*i-.3413193965*a,-.0041960863*n-.7034186147*i+1.707614701*a]}function ba(t){const[e,s,n]=Zs(t);return{lightness:e,chroma:Math.hypot(s,n),hue:Math.atan2(n,s)*180/Math.PI}}function di(t){return t.every(e=>e>=-1e-4&&e<=1+1e-4)}function ga({lightness:t,chroma:e,hue:s}){const n=s*Math.PI/180,i=Math.min(1,Math.max(0,t)),a=c=>$a([i,c*Math.cos(n),c*Math.sin(n)]);let r=a(e);if(!di(r)){let c=0,u=e;for(let d=0;d<16;++d){const p=(c+u)/2;di(a(p))?c=p:u=p}r=a(c)}const o=c=>Math.min(1,Math.max(0,c));return[o(r[0]),o(r[1]),o(r[2])]}function ic(t,e,s){const n=Zs(t),i=Zs(e),a=c=>n[c]+(i[c]-n[c])*s,r=c=>Math.min(1,Math.max(0,c)),o=$a([a(0),a(1),a(2)]);return[r(o[0]),r(o[1]),r(o[2])]}const Fs=["#69a3cb","#edc06b","#3e9790","#e7917a","#826bb3","#c7d787","#e496b5","#99d6e3","#a6603a","#a9e4ca","#48658b","#e5d6b6","#955b85","#609562","#cab7e3","#7d8792"],ac=19,rc=.03,oc=4,lc=.025,cc=4,uc=.7548776662466927,hc=.5698402909980532;function ya(t){const e=ue(Fs[t%Fs.length]??"#7d8792"),s=Math.floor(t/Fs.length);if(s===0)return e;const{lightness:n,chroma:i,hue:a}=ba(e);return ga({lightness:n-rc*(s%oc),chroma:i,hue:a+ac*s})}function _t(t,e){return ma(ya(t))}function md(t,e){const{lightness:s,chroma:n,hue:i}=ba(ya(t)),a=r=>2*(r-Math.floor(r))-1;return ga({lightness:s+lc*a(.5+e*uc),chroma:n,hue:i+cc*a(.5+e*hc)})}const dc={"one-hue":[ue("#dbe5fb"),ue("#1f3f96")],height:[ue("#f3e7c4"),ue("#2f6f6a")]};function pc(t,e){const[s,n]=dc[t];return ic(s,n,Math.min(1,Math.max(0,e)))}function $d(t,e=5){return Array.from({length:e},(s,n)=>ma(pc(t,n/(e-1))))}function va(t,e,s,n=400){let i=0,a=0;for(;a<t.length&&i+(t[a]??0)<=e-n;)i+=t[a++]??0;const r=i;let o=a;for(;o<t.length&&i<e+s+n;)i+=t[o++]??0;let c=0;for(let u=o;u<t.length;u+=1)c+=t[u]??0;return{first:a,last:o,before:r,after:c}}const fc={mm:1,inch:25.4,m:1e3};function wa(t,e,s){return(e.unit_known?e.unit:fc[t.unit??s.unit])*t.scale}function ka(t,e,s){return wa(t,e,s)/e.unit}function vs(t,e,s){const n=ka(t,e,s),[i=0,a=0,r=0]=e.size;return[i*n,a*n,r*n]}function xa(t,e,s){return e.volume*ka(t,e,s)**3}function mc(t,e){const[s,n,i]=t,a=(r,o,c)=>[[r,o,c],[o,r,c]];switch(e.kind){case"fixed":return[t];case"upright":return a(s,n,i);case"axes":return e.axes.flatMap(r=>r.endsWith("x")?a(n,i,s):r.endsWith("y")?a(s,i,n):a(s,n,i));default:return[...a(s,n,i),...a(n,i,s),...a(s,i,n)]}}function _a(t,e,s){const n=i=>Math.min(...i.map((a,r)=>a>0?(s[r]??0)/a:Number.POSITIVE_INFINITY));return Math.max(...mc(t,e).map(n))}const Ma=1e-9;function pi(t,e,s){return _a(t,e,s)<1-Ma}function $c(t,e,s,n){const i=Math.floor(_a(t,e,s)*n*100+Ma);return i>=1?i/100:null}function bc(t){return t===void 0||t==="90"||t===90||t==="none"}const Pa={do:"leave_out",text:"Leave out"},gc={do:"replace",text:"Replace"};function yc({part:t,mesh:e,draft:s,room:n,reading:i}){return e?[vc(t,e,s,n),wc(t,e,s),kc(e),xc(e)].filter(a=>a!==null):i?[]:[{tone:"bad",text:`${t.object===null?t.file:`Object ${t.object} of ${t.file}`} is not there.`,actions:[gc,Pa]}]}function vc(t,e,s,n){if(!n||!bc(s.options.rotations))return null;const i=vs(t,e,s);if(!pi(i,t.stands,n))return null;const a=$c(i,t.stands,n,t.scale),r=!pi(i,{kind:"any"},n),o=t.stands.kind==="any"?"in every position":r?"as it may stand":"in every position";return{tone:"bad",text:`${at(i)} is larger than the tray ${o}.`,actions:[...a===null?[]:[{do:"scale",scale:a,text:`Scale to ${R(a,0)}`}],Pa]}}function wc(t,e,s){if(e.unit_hint===null||e.unit_known||t.unit!==null||s.unit!=="mm")return null;const n=Math.max(...vs(t,e,s));return n>=1e3?{tone:"warn",text:`${(n/1e3).toFixed(1)} m long: perhaps drawn in another unit.`,actions:[{do:"scale",scale:.001,text:`Scale to ${R(.001)}`},{do:"unit",unit:"mm",text:"Keep mm"}]}:{tone:"warn",text:`Only ${n.toFixed(n<1?2:1)} mm long: perhaps drawn in ${n<.2?"metres":"inches"}.`,actions:[n<.2?{do:"unit",unit:"m",text:"Read as metres"}:{do:"unit",unit:"inch",text:"Read as inches"},{do:"unit",unit:"mm",text:"Keep mm"}]}}function kc(t){const e=t.warnings.filter(s=>s!==t.unit_hint&&!s.includes("--unit"));return e.length===0?null:{tone:"warn",text:`${e.map(q).join(" ")}`,actions:[]}}function xc(t){const e=t.repairs.filter(i=>!_c(i));if(e.length===0)return null;const s=q(e[0]??""),n=e.length>1?` ${x(e.length-1,"more thing")} mended.`:"";return{tone:"info",text:s+n,actions:[{do:"repairs",text:"See what changed"}]}}function _c(t){return/^(merged|welded) [\d\s]+ vert(ex|ices)/.test(t)}const Mc=44,Pc=26,fi=t=>Mc+t.remarks.length*Pc,je=(t,e)=>t.name??e?.name??t.file.replace(/\.[^.]*$/,"");function Mn(t){const e=new Map(t.map(s=>[`${s.file}
${s.object??""}`,s]));return s=>e.get(`${s.file}
${s.object??""}`)??null}const mi=new WeakMap;function Xs(t){const e=[t.draft,t.parts,t.uploads.state.value.active],s=mi.get(t);if(s?.of.every((i,a)=>i===e[a]))return s.rows;const n=Oc(t);return mi.set(t,{of:e,rows:n}),n}function Oc(t){const{draft:e,info:s,parts:n}=t,i=Vl(e,s,n.meshes),a=Mn(n.meshes),r=n.reading>0||t.uploads.state.value.active;return e.parts.map((o,c)=>{const u=a(o);return{part:o,index:c,mesh:u,remarks:yc({part:o,mesh:u,draft:e,room:i,reading:r})}})}function Sc(t,e){const s=(e??"").trim().toLowerCase();return s===""?t:t.filter(({part:n,mesh:i})=>`${je(n,i)} ${n.file} ${n.order??""}`.toLowerCase().includes(s))}function Oa(t){return t.reduce((e,{part:s,mesh:n})=>e+(n?s.count:0),0)}function Ac(t,e){return t.reduce((s,{part:n,mesh:i})=>s+(i?xa(n,i,e.draft)*n.count:0),0)}function Cc(t,e){return t.mesh?vs(t.part,t.mesh,e.draft):null}function Tc(t){const{draft:e,parts:s}=t,n=Mn(s.meshes),i=Array.isArray(e.fixed)?e.fixed.length:0;return e.parts.map((a,r)=>{const o=n(a),c=o?(a.unit&&!o.unit_known?Ec(a.unit)/o.unit:1)*a.scale:1;return{index:r+i,name:je(a,o),count:a.count,volume:(o?.volume??0)*c**3,mesh:o}})}const Ec=t=>t==="inch"?25.4:t==="m"?1e3:1;function jc(t,e){const{meshes:s}=t.parts,n=new Map(s.map(a=>[`${a.file}
${a.object??""}`,a])),i=new Map(s.map(a=>[a.file,a]));return e.parts.map(a=>({index:a.index,name:a.name,count:a.count,volume:a.volume,mesh:n.get(`${a.file}
${a.object??""}`)??i.get(a.file)??null}))}function $i(t,e,s){const n=e.parts[s];return n?t.draft.parts.filter(a=>a.file===n.file&&(a.object??null)===n.object)[0]?.key??t.draft.parts.find(a=>a.file===n.file)?.key??null:null}function Sa(t){const e=new Map;for(const s of t)for(const{part:n}of s.placements)e.set(n,(e.get(n)??0)+1);return e}function Lc(t,e){const s=t.trays[e-1];return e>0&&s?[s]:t.trays}const Pn={text:"Change the part",draft:null};function Dc(t,e,s,n){switch(t.reason){case"no_place":return{text:t.detail?q(t.detail):"No free place left.",remedy:bi(e,s)};case"cannot_leave":return{text:"Held by other copies, and no other place left.",remedy:bi(e,s)};case"too_large":return Rc(t.detail,e,s,n);case"cap":return{text:Fc(t.detail),remedy:{text:"Pack again without the cap",draft:Nc(s)}};case"not_tried":return{text:"The run ended before it was tried.",remedy:zc(s)};case"bad_file":return{text:q(t.detail||"The file cannot be used"),remedy:{...Pn,text:"Replace the file"}}}}function bi(t,e){if(Ce(e)||e.trays==="all"||e.options.fill===!0)return Pn;const s=Math.max(e.trays,t.trays.length)+1;return{text:`Pack again with ${_(s)} trays`,draft:{...e,trays:s}}}function zc(t){if(t.timeLimit===null)return{text:"Pack again",draft:t};const e=Math.max(60,t.timeLimit*2);return{text:`Pack again with ${Dt(e)}`,draft:{...t,timeLimit:e}}}function Nc(t){return jt(jt(t,"max-density",void 0),"max-layer-fill",void 0)}function Fc(t){const e=/(\d*\.?\d+)/.exec(t)?.[1],s=e===void 0?Number.NaN:Number(e);return s>0&&s<=1?`The tray may be filled to ${R(s,0)} only.`:"The tray may not be filled more."}function Rc(t,e,s,n){const i=[...t.matchAll(/([\d.]+) x ([\d.]+)(?: x ([\d.]+))? mm/g)].map(d=>[Number(d[1]),Number(d[2]),Number(d[3]??0)]),[a,r]=i,o=a&&r?`${at(a)}; the tray takes ${Uc(r,a)}.`:"Larger than the tray.",c=/--rotations (\S+?)\.?$/.exec(t)?.[1],u=/It fits into (.+): --printer (\S+?)\.?$/.exec(t);if(t.includes("as its orientations do")&&n!==null){const d=s.parts.map(p=>p.key===n?{...p,stands:fn}:p);return{text:o,remedy:{text:"Let it stand any way",draft:{...s,parts:d}}}}if(c){const d=/^\d+$/.test(c)?`Turn parts in steps of ${c}°`:"Turn parts in finer steps";return{text:o,remedy:{text:d,draft:jt(s,"rotations",c)}}}if(u?.[1]&&u[2]){const d={kind:"printer",name:u[2]};return{text:o,remedy:{text:`Use ${u[1]}`,draft:{...s,tray:d,gap:null,wallGap:null}}}}return{text:e.openHeight?"Larger than the tray's base.":o,remedy:Pn}}function Uc(t,e){return t[2]===0&&e[2]!==0?at([t[0],t[1]]):at(t)}var Ic=Object.defineProperty,Hc=Object.getOwnPropertyDescriptor,On=(t,e,s,n)=>{for(var i=n>1?void 0:n?Hc(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Ic(e,s,i),i};let ss=class extends w{constructor(){super(...arguments),this.parts=[]}stores(){return[this.session.run.state,this.session.state,this.session.meshes.state,b]}render(){const{packing:t}=this.session.run.state.value;if(!t||t.leftOver.length===0)return h;const e=t.leftOver.reduce((n,i)=>n+i.copies,0),s=this.shared(t);return l`<section class="left-over" aria-label="Left over">
      <h3>Left over <span class="count">${D(e)}</span></h3>
      ${t.leftOver.map(n=>this.row(t,n,s))}
    </section>`}shared(t){const e=new Map;for(const s of t.leftOver){const{remedy:n}=this.words(t,s);n.draft&&!e.has(n.text)&&e.set(n.text,s)}return e}words(t,e){return Dc(e,t,this.session.draft,$i(this.session,t,e.part))}row(t,e,s){const n=this.parts.find(u=>u.index===e.part),{text:i,remedy:a}=this.words(t,e),r=a.draft===null||s.get(a.text)===e,{meshes:o}=this.session,c=n?.mesh?o.picture(n.mesh,_t(e.part),b.value.theme):null;return l`<div class="left-row">
      ${ot(c)}
      <div class="grow">
        <div class="row between">
          <span class="cut">${n?.name??t.parts[e.part]?.name??""}</span>
          <span class="dim nw">${e.copies} of ${n?.count??e.copies}</span>
        </div>
        <div class="small dim">${i}</div>
        ${r?l`<button type="button" class="link small" @click=${()=>this.take(t,e,a)}>
                ${a.text}
              </button>`:h}
      </div>
    </div>`}take(t,e,s){if(s.draft){this.session.packWith(s.draft);return}const n=$i(this.session,t,e.part);n!==null&&this.session.view.set({current:n}),tt({page:"job",id:this.session.id,step:"parts"})}};On([m({attribute:!1})],ss.prototype,"session",2);On([m({attribute:!1})],ss.prototype,"parts",2);ss=On([v("sp-left-over")],ss);var Bc=Object.defineProperty,qc=Object.getOwnPropertyDescriptor,ne=(t,e,s,n)=>{for(var i=n>1?void 0:n?qc(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Bc(e,s,i),i};const Rs=40;let Nt=class extends w{constructor(){super(...arguments),this.parts=[],this.live=!1,this.tray=1,this.top=0,this.height=900,this.followed=-1,this.sizes=new ResizeObserver(()=>{this.height=this.scroller.clientHeight,this.requestUpdate()})}stores(){const{session:t}=this;return[t.run.state,t.build,t.meshes.state,b]}firstUpdated(){this.sizes.observe(this.scroller)}disconnectedCallback(){super.disconnectedCallback(),this.sizes.disconnect()}updated(){if(!this.live)return;const t=this.session.run.live.newest?.copy.part??-1;if(t===this.followed)return;this.followed=t;const e=this.parts.findIndex(i=>i.index===t)*Rs,{scrollTop:s,clientHeight:n}=this.scroller;e>=0&&(e<s||e+Rs>s+n)&&(this.scroller.scrollTop=e-n/2)}render(){const{session:t,live:e}=this,{packing:s}=t.run.state.value,n=e?t.run.live.counts():Sa(s?Lc(s,this.tray):[]),i=this.parts.reduce((c,u)=>c+u.count,0),a=[...n.values()].reduce((c,u)=>c+u,0),r=e?Math.max(i,t.run.live.progress?.total??0):s?.copies??i,o=va(this.parts.map(()=>Rs),this.top,this.height);return l`<div class="head">
        <h2 class="grow">Parts</h2>
        <span class="count">${_(a)} of ${_(r)}${e?" placed":""}</span>
        ${e?h:V("find","Find (/)",()=>t.build.set({find:""}),"s")}
      </div>
      <div
        class="scroll"
        @scroll=${()=>{this.top=this.scroller.scrollTop,this.requestUpdate()}}
      >
        <div role="list" aria-label="Parts">
          <div role="presentation" ${Q({height:`${o.before}px`})}></div>
          ${_n(this.parts.slice(o.first,o.last),c=>c.index,c=>this.row(c,n.get(c.index)??0))}
          <div role="presentation" ${Q({height:`${o.after}px`})}></div>
        </div>
      </div>
      ${e?h:l`<sp-left-over .session=${t} .parts=${this.parts}></sp-left-over>`}`}row(t,e){const{session:s,live:n}=this,{selected:i,hiddenParts:a}=s.build.value,r=s.run.live.newest,o=n?r?.copy.part===t.index:i.some(f=>f.part===t.index),c=a.has(t.index),{mesh:u}=t,d=ot(u?s.meshes.picture(u,_t(t.index),b.value.theme):null);if(n){const f=e>=t.count;return l`<div class="li ${o?"sel":""}" role="listitem">
        ${d}
        <div class="cut">
          <div class="cut">${t.name}</div>
          ${ms(t.count>0?e/t.count:0,null,f?"done":"")}
        </div>
        <span class="dim num">${_(e)} <span class="faint">/ ${_(t.count)}</span></span>
      </div>`}const p=c?`Show ${t.name}`:`Hide ${t.name}`;return l`<div class="li ${o?"sel":""} ${c?"past":""}" role="listitem">
      <button
        type="button"
        class="whole"
        aria-label="Select ${t.name}, ${e} of ${t.count}"
        aria-pressed=${o}
        @click=${f=>this.select(t,f.ctrlKey||f.metaKey)}
      ></button>
      ${d}
      <div class="cut ${o?"b":""}" title=${t.name}>${t.name}</div>
      <span class="dim row">
        ${e===t.count||this.tray>0?_(e):`${_(e)} / ${_(t.count)}`}
        <button
          type="button"
          class="btn s ghost icon eye ${c?"off":""}"
          aria-label=${p}
          title=${p}
          aria-pressed=${c}
          @click=${()=>s.build.set(Wr(s.build.value,t.index))}
        >
          ${g(c?"eyeOff":"eye")}
        </button>
      </span>
    </div>`}select(t,e){const{packing:s}=this.session.run.state.value,{build:n}=this.session,a=(s?.trays[this.tray-1]?.placements??[]).filter(c=>c.part===t.index).map(({part:c,copy:u})=>({part:c,copy:u})),r=n.value.selected.filter(c=>c.part!==t.index),o=r.length<n.value.selected.length&&(e||r.length===0);n.set({selected:o?r:e?[...r,...a]:a})}};ne([m({attribute:!1})],Nt.prototype,"session",2);ne([m({attribute:!1})],Nt.prototype,"parts",2);ne([m({type:Boolean})],Nt.prototype,"live",2);ne([m({type:Number})],Nt.prototype,"tray",2);ne([W(".scroll")],Nt.prototype,"scroller",2);Nt=ne([v("sp-build-list")],Nt);function Wc(t,e,s,n=190){const i=Math.max(1,Math.min(n,Math.round(s/2))),a=s/i,r=new Array(i).fill(0);for(const{extent:o,volume:c}of t){const u=o.low[2],d=Math.max(o.high[2],u+1e-6),p=c/(d-u)/e,f=Math.max(0,Math.floor(u/a)),$=Math.min(i-1,Math.floor(d/a));for(let y=f;y<=$;y+=1){const k=Math.min(d,(y+1)*a)-Math.max(u,y*a);k>0&&(r[y]=(r[y]??0)+p*k/a)}}return{thickness:a,share:r.map(o=>Math.min(1,o)),exact:!1}}function gi(t,e){const s=Math.floor(e/t.thickness);return t.share[Math.max(0,Math.min(t.share.length-1,s))]??0}function Aa(t){let e=0;return t.share.forEach((s,n)=>{s>(t.share[e]??0)&&(e=n)}),{share:t.share[e]??0,z:(e+.5)*t.thickness}}function Kc(t){if(!t)return .4;const e=Aa(t).share;return[.02,.04,.06,.1,.16,.2,.3,.4,.5,.6,.8,1].find(n=>n>=e*1.02)??1}var Gc=Object.defineProperty,Jc=Object.getOwnPropertyDescriptor,Rt=(t,e,s,n)=>{for(var i=n>1?void 0:n?Jc(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Gc(e,s,i),i};let wt=class extends w{constructor(){super(...arguments),this.layers=null,this.height=0,this.average=0,this.live=!1,this.hover=null,this.dragging=!1}stores(){return[this.session.build]}get cut(){const{section:t}=this.session.build.value;return t?.axis==="z"?t.at:null}render(){const t=Kc(this.layers);return l`<aside class="strip" aria-label="Filled area of each layer">
      <header><b>Layers</b><span class="dim">filled area</span></header>
      ${this.height>0?l`<div
              class="plot ${this.live?"":"cuts"}"
              @pointerdown=${this.grab}
              @pointermove=${this.move}
              @pointerup=${this.drop}
              @pointercancel=${this.drop}
              @pointerleave=${()=>{this.hover=null}}
            >
              ${this.drawing(t)} ${this.marks()} ${this.cutLine()} ${this.hoverLine()}
            </div>`:l`<div class="plot"></div>`}
      <footer>
        <div class="row between faint scale">
          <span>0</span><span>${Math.round(t*50)}</span><span>${R(t,0)}</span>
        </div>
        ${this.words()}
      </footer>
    </aside>`}words(){if(this.live||!this.layers)return l`<b>${R(this.average)}</b> on average,<br />grows as copies land`;const{cut:t}=this;if(t!==null)return l`<b>${R(gi(this.layers,t))}</b> at the cut<br />Drag to move it`;const e=Aa(this.layers);return l`<b>${R(e.share,0)}</b> at ${e.z.toFixed(0)} mm,<br />the fullest layer`}y(t){return(1-t/this.height)*1e3}drawing(t){const{layers:e,cut:s}=this,i=e?Vc(e,r=>(r/t*100).toFixed(2),r=>this.y(r).toFixed(1)):"",a=s===null?0:this.y(s);return l`<svg viewBox="0 0 100 1000" preserveAspectRatio="none" aria-hidden="true">
      ${[1,2,3].map(r=>He`<path class="grid" d="M${r*25} 0V1000" />`)}
      ${i===""?h:s===null?He`<polygon class="area" points=${i} />`:He`<polygon class="area past" points=${i} />
                <clipPath id="below-cut"><rect x="0" y=${a} width="100" height=${1e3-a} /></clipPath>
                <polygon class="area" points=${i} clip-path="url(#below-cut)" />`}
    </svg>`}marks(){const t=[10,20,50,100,200,500].find(s=>this.height/s<=5)??1e3,e=[];for(let s=t;s<this.height;s+=t)e.push(l`<span class="mark-z" ${Q({bottom:`${s/this.height*100}%`})}>${s}</span>`);return e}cutLine(){const{cut:t}=this;return t===null||this.live?h:l`<span
      class="cut-line"
      role="slider"
      tabindex="0"
      aria-label="Height of the section, mm"
      aria-orientation="vertical"
      aria-valuemin="0"
      aria-valuemax=${this.height}
      aria-valuenow=${t}
      ${Q({bottom:`${t/this.height*100}%`})}
      @keydown=${this.key}
      ><span>${t.toFixed(1)}</span></span
    >`}hoverLine(){const{hover:t,layers:e}=this;if(t===null||!e||this.dragging)return h;const s=gi(e,t);return l`<span class="hover-line" ${Q({bottom:`${t/this.height*100}%`})}
      ><span>${t.toFixed(0)} mm · ${R(s)}</span></span
    >`}heightAt(t){const e=t.currentTarget,{top:s,height:n}=e.getBoundingClientRect(),i=Math.max(0,Math.min(1,1-(t.clientY-s)/n));return Math.round(i*this.height*10)/10}cutAt(t){const{build:e}=this.session,{section:s}=e.value;e.set({section:{axis:"z",at:t,flipped:s?.axis==="z"?s.flipped:!1}})}grab(t){this.live||(t.preventDefault(),t.currentTarget.setPointerCapture(t.pointerId),this.dragging=!0,this.cutAt(this.heightAt(t)))}move(t){this.dragging?this.cutAt(this.heightAt(t)):this.hover=this.heightAt(t)}drop(){this.dragging=!1}key(t){const{build:e}=this.session,{section:s}=e.value,n=t.key==="ArrowUp"?1:t.key==="ArrowDown"?-1:0;!s||n===0||(t.preventDefault(),t.stopPropagation(),e.set({section:pa(this.session,s,t.shiftKey?n*10:n)}))}};Rt([m({attribute:!1})],wt.prototype,"session",2);Rt([m({attribute:!1})],wt.prototype,"layers",2);Rt([m({type:Number})],wt.prototype,"height",2);Rt([m({type:Number})],wt.prototype,"average",2);Rt([m({type:Boolean})],wt.prototype,"live",2);Rt([P()],wt.prototype,"hover",2);wt=Rt([v("sp-layers")],wt);function Vc(t,e,s){const n=[`0,${s(0)}`];return t.share.forEach((i,a)=>{n.push(`${e(i)},${s((a+.5)*t.thickness)}`)}),n.push(`0,${s(t.share.length*t.thickness)}`),n.join(" ")}const j=(t,e,s)=>t[e]?.[s]??0;function Ca(t){const e=[0,1,2].map(s=>Math.hypot(j(t,0,s),j(t,1,s),j(t,2,s))||1);return[0,1,2].map(s=>[0,1,2].map(n=>j(t,s,n)/(e[n]??1)))}function Yc(t,e){const[s,n,i]=e,a=(n-s+3)%3===1?1:-1,r=Math.max(-1,Math.min(1,-a*j(t,i,s))),o=Math.asin(r);return Math.abs(r)>1-1e-9?[0,o,Math.atan2(-a*j(t,s,n),j(t,n,n))]:[Math.atan2(a*j(t,i,n),j(t,i,i)),o,Math.atan2(a*j(t,n,s),j(t,s,s))]}const Zc=[[0,1,2],[2,0,1],[1,2,0],[0,2,1],[1,0,2],[2,1,0]];function yi(t){const e=Ca(t);let s=null;for(const n of Zc){const i=Yc(e,n).map((a,r)=>({degrees:Math.round(a*180/Math.PI),axis:"XYZ"[n[r]??0]??""})).filter(({degrees:a})=>a%360!==0).map(({degrees:a,axis:r})=>`${a===-180?180:a}° about ${r}`);(!s||i.length<s.length)&&(s=i)}return s?.length?`turned ${s.join(", then ").replaceAll("-","−")}`:"as drawn"}function Xc(t,e,s,n,i){return j(t,i,0)*e+j(t,i,1)*s+j(t,i,2)*n+j(t,i,3)}function Qc(t){return Ca(t).every(e=>e.every(s=>Math.abs(s)<1e-9||Math.abs(s)>1-1e-9))}function Ta(t,e,s){const n=[1/0,1/0,1/0],i=[-1/0,-1/0,-1/0],a=(r,o,c)=>{for(let u=0;u<3;u+=1){const d=Xc(t,r,o,c,u);d<(n[u]??0)&&(n[u]=d),d>(i[u]??0)&&(i[u]=d)}};if(s&&s.length>0&&!Qc(t))for(let r=0;r+2<s.length;r+=3)a(s[r]??0,s[r+1]??0,s[r+2]??0);else for(let r=0;r<8;r+=1)a(j(e,r&1,0),j(e,r>>1&1,1),j(e,r>>2&1,2));return{low:n,high:i}}function tu(t){const e=t.map(eu).filter((s,n,i)=>s!==i[n-1]);return e.length===0?"it stands alone by then":e.length>3?`${e.length} moves, last ${e[e.length-1]}`:e.join(", then ")}function eu(t){const[e=0,s=0,n=0]=t,i=Math.max(Math.abs(e),Math.abs(s),Math.abs(n));return Math.abs(n)===i?n>0?"up":"down":Math.abs(e)===i?e>0?"to the right":"to the left":s>0?"to the back":"to the front"}const vi=new WeakMap;function su(t,e,s){const n=vi.get(e);if(n)return n;const i=s.box.map(o=>o.map(c=>c/s.unit)),a=t.meshes.mesh(s)?.positions??null,r=Ta(e.transform,i,a);return a&&vi.set(e,r),r}function nu(t,e,s,n,i){const a=new Map(s.map(p=>[p.index,p])),r=[];let o=0,c=0;for(const p of e.trays.get(n)?.copies.values()??[]){const f=a.get(p.part);if(!f?.mesh)continue;const $=su(t,p,f.mesh);r.push({extent:$,volume:f.volume}),o=Math.max(o,$.high[2]),c+=f.volume}const u=i[0]*i[1],d=u*Math.max(i[2],o);return{standing:e.standing,density:d>0?c/d:0,height:o,layers:r.length>0&&u>0?Wc(r,u,Math.max(i[2],o)):null}}var iu=Object.defineProperty,au=Object.getOwnPropertyDescriptor,Sn=(t,e,s,n)=>{for(var i=n>1?void 0:n?au(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&iu(e,s,i),i};let ns=class extends w{constructor(){super(...arguments),this.ticking=0}stores(){return[this.session.run.state,b]}connectedCallback(){super.connectedCallback(),this.ticking=window.setInterval(()=>this.requestUpdate(),1e3)}disconnectedCallback(){super.disconnectedCallback(),clearInterval(this.ticking)}render(){const{job:t,since:e}=this.session.run.state.value;if(t.status==="queued")return this.queued();const s=e>0?(Date.now()-e)/1e3:0;return l`<div class="head">
        <h2 class="grow">Packing</h2>
        <span class="count">${Ds(Math.max(s,this.heard()))} so far</span>
      </div>
      <div class="scroll">
        <section class="sec">${this.numbers()}</section>
        <section class="sec">${this.phases()}</section>
        ${this.improving()} ${this.said()}
      </div>
      ${this.stop("Stop and keep the best so far")}`}queued(){const t=this.session.job.queue_place;return l`<div class="head"><h2 class="grow">Waiting</h2></div>
      <div class="scroll">
        <section class="sec">
          <p>
            ${t?l`<b>Place ${t} in the queue.</b>`:l`<b>In the queue.</b>`} It begins as soon as the
            jobs before it are done.
          </p>
        </section>
      </div>
      ${this.stop("Take it out of the queue")}`}heard(){return Math.max(0,...this.session.run.live.seconds.values())}numbers(){const{draft:t,info:e,parts:s,run:n}=this.session,{progress:i}=n.live,a=Math.max(Jr(t),i?.phase==="search"?i.total:0),{standing:r,density:o,height:c}=this.figures,u=i?.left??null,d=xt(t,e,s.meshes),p=n.live.trays.size>1;return l`<div class="fig">
        ${B(_(r),`of ${_(a)}`,"placed")}
        ${u===null?B("–","","time left"):B(Ds(u),"left",`of about ${Ds(u+(i?.seconds??0))}`)}
        ${B((o*100).toFixed(1),"%",p?"of this tray filled":"of the tray filled")}
        ${B(c.toFixed(0),"mm",d&&!t.openHeight&&!Ce(t)?`height of ${d[2].toFixed(0)}`:"height")}
      </div>
      ${ms(a>0?r/a:0,"Copies placed","thick")}`}phases(){const{draft:t,run:e}=this.session,{live:s}=e,n=s.progress?.phase??null,i=yl(s.phases,n,t.parts.length);return l`<h3>What happens now</h3>
      <div class="checks">
        ${i.map(a=>{const r=s.seconds.get(a.phase),o=s.progress;return a.state==="now"?l`<div class="now" aria-current="step">
              <span class="dot"></span><span>${a.text}</span>
              <span>${o&&o.total>1?_(o.done):""}</span>
            </div>`:l`<div class=${a.state}>
            ${a.state==="done"?g("check"):l`<span></span>`}<span>${a.text}</span>
            <span class="faint">${a.state==="done"&&r!==void 0&&r>=.05?Dt(r):""}</span>
          </div>`})}
      </div>
      ${this.orders()}`}orders(){const t=this.session.run.live.progress;return t?.orders?l`<p class="small faint">Order ${t.order??1} of ${x(t.orders,"order")} tried.</p>`:h}improving(){const t=this.session.run.live.progress;if(t?.phase!=="improve"||t.before===void 0||t.now===void 0)return h;const{what:e="",before:s,now:n}=t;return l`<section class="sec"><h3>Better so far</h3><p>${Ea(e,s,n)}</p></section>`}said(){const t=fa(this.session.run.live.remarks);return t.length===0?h:l`<section class="sec">
      <h3>Set aside and remarked</h3>
      <ul class="said">
        ${t.map(e=>l`<li>${e}</li>`)}
      </ul>
    </section>`}stop(t){const{job:e,stopping:s}=this.session.run.state.value;return J(e)?l`<section class="sec bottom">
      <button
        type="button"
        class="btn l fill"
        ?disabled=${s}
        @click=${()=>this.session.stop()}
      >
        ${s?ht:g("stop")}${s?"Stopping":t}
      </button>
      <p class="small faint">
        ${s?"What stands is taken apart and checked.":"Closing this page does not stop the job."}
      </p>
    </section>`:h}};Sn([m({attribute:!1})],ns.prototype,"session",2);Sn([m({attribute:!1})],ns.prototype,"figures",2);ns=Sn([v("sp-packing")],ns);function Ea(t,e,s){const n=i=>(i/1e3).toFixed(0);switch(t){case"height":return`${(e-s).toFixed(1)}${L}mm lower: ${s.toFixed(1)} instead of ${e.toFixed(1)}${L}mm.`;case"density":return`${R(s)} filled instead of ${R(e)}.`;case"copies":return`${_(s)} copies placed instead of ${_(e)}.`;case"box":return`A box of ${n(s)} instead of ${n(e)}${L}cm³.`;case"trays":return`${s.toFixed(2)} trays instead of ${e.toFixed(2)}.`;default:return`${s} instead of ${e}.`}}const Us=8;function ru(t,e){const{verdict:s}=t;if(!s)return l`<section class="sec">
      <h3>Checked</h3>
      <p class="dim">Not checked yet.</p>
    </section>`;const n=s.findings,i=n.some(u=>u.includes("outside")),a=n.some(u=>/overlap|gap|nested/.test(u)),r=Number(e.options["wall-gap"]??0),o=e.trays.reduce((u,d)=>u+d.steps,0),c=e.trays.reduce((u,d)=>u+d.throughWalls,0);return l`<section class="sec">
    <div class="row between">
      <h3>Checked</h3>
      <span class="small faint">on the exact meshes</span>
    </div>
    <div class="checks">
      ${le(a?"bad":"ok",a?"Copies come too near":"No two copies touch",s.min_gap===null?"":ve(s.min_gap,2))}
      ${le(i?"bad":"ok",i?"A copy sticks out":"All inside the tray",r>0?`${ve(r)} and more`:"")}
      ${s.apart==="checked"?le("ok","Comes apart",x(s.steps||o,"step")):s.apart==="no"?le("bad","Does not come apart",""):le("warn","Coming apart was not looked at","")}
    </div>
    ${s.apart==="checked"&&c>0?l`<p class="small dim">${x(c,"step")} ${c===1?"leads":"lead"} through the walls: open the tray at a side for ${c===1?"it":"them"}.</p>`:h}
    ${n.length>0?l`<ul class="said bad-text">
            ${n.slice(0,Us).map(u=>l`<li>${q(u)}</li>`)}
            ${n.length>Us?l`<li>And ${n.length-Us} more.</li>`:h}
          </ul>`:h}
  </section>`}const ou={ok:"check",warn:"warn",bad:"bad"};function le(t,e,s){return l`<div class=${t}>${g(ou[t])}<span>${e}</span><span class="faint">${s}</span></div>`}var lu=Object.defineProperty,cu=Object.getOwnPropertyDescriptor,Ut=(t,e,s,n)=>{for(var i=n>1?void 0:n?cu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&lu(e,s,i),i};const uu=200;let kt=class extends w{constructor(){super(...arguments),this.parts=[],this.tray=1,this.clearance=null,this.unknown=!1,this.asked="",this.timer=0,this.asking=null}stores(){return[this.session.build,this.session.meshes.state,b]}disconnectedCallback(){super.disconnectedCallback(),clearTimeout(this.timer),this.asking?.abort()}get placements(){const{byId:t}=this.packing.trays[this.tray-1]??{byId:new Map};return this.session.build.value.selected.flatMap(e=>t.get(X(e))??[])}updated(t){const{placements:e}=this,s=e.length===1?e[0]:void 0,n=s?`${this.tray}/${s.index}/${this.packing.seconds}`:"";n!==this.asked&&(this.asked=n,clearTimeout(this.timer),this.asking?.abort(),this.clearance=null,this.unknown=!1,s&&(this.timer=window.setTimeout(()=>void this.measure(s.index),uu)))}async measure(t){const e=new AbortController;this.asking=e;try{const s=await M.clearance(this.session.id,this.tray,t,e.signal);e.signal.aborted||(this.clearance=s)}catch{e.signal.aborted||(this.unknown=!0)}}render(){const{placements:t}=this,[e]=t;return e?l`<section class="sec selected" aria-label="Selected copy">
      ${t.length===1?this.one(e):this.several(t)}
    </section>`:h}head(t,e,s){const{meshes:n}=this.session,i=t?.mesh?n.picture(t.mesh,_t(t.index),b.value.theme):null;return l`<div class="row">
      ${ot(i,"th large")}
      <div class="grow cut">
        <h2 class="cut">${e}</h2>
        <div class="small dim cut">${s}</div>
      </div>
      ${V("close","Let go (Esc)",()=>this.session.build.set({selected:[]}),"s")}
    </div>`}one(t){const e=this.parts.find(i=>i.index===t.part),s=e?.name??"",n=t.copy+1;return l`${this.head(e,`${s} ${n}`,`copy ${n} of ${e?.count??n} · placed ${Mo(t.index+1)}`)}
      <dl class="kv">
        ${this.place(t,e)}
        <dt>Stands</dt>
        <dd>${yi(t.transform)}</dd>
        ${this.nearest()}
        <dt>Way out</dt>
        <dd>${this.way(t)}</dd>
      </dl>
      ${this.steps(t)}`}place(t,e){const s=e?.mesh;if(!s)return h;const n=s.box.map(o=>o.map(c=>c/s.unit)),i=Ta(t.transform,n,this.session.meshes.mesh(s)?.positions??null),a=i.low.map(o=>Math.abs(o).toFixed(1)),r=i.high.map((o,c)=>o-(i.low[c]??0));return l`<dt>Place</dt>
      <dd class="nw">X ${a[0]} &nbsp;Y ${a[1]} &nbsp;Z ${a[2]}</dd>
      <dt>Takes</dt>
      <dd>${at(r,!0)}</dd>`}nearest(){const{clearance:t,unknown:e}=this,s=e?l`<span class="faint">not measured</span>`:ht,{nearest:n,wall:i}=t??{},a=n?this.parts.find(r=>r.index===n.part)?.name:"";return l`<dt>Nearest copy</dt>
      <dd>
        ${t?n?l`<button
                    type="button"
                    class="link"
                    @click=${()=>this.session.build.set({selected:[{part:n.part,copy:n.copy}]})}
                  >
                    ${a} ${n.copy+1}</button
                  > · ${ve(n.distance,2)}`:"none":s}
      </dd>
      <dt>Nearest wall</dt>
      <dd>${t?i?`${i.side} · ${ve(i.distance,2)}`:"none":s}</dd>`}way(t){const e=this.packing.trays[this.tray-1];if(t.step===null)return t.fixed?"stays where it is":"not known";const s=t.together>1?`, with ${x(t.together-1,"other")}`:"";return`step ${t.step} of ${e?.steps??0} · ${tu(t.path)}${s}`}steps(t){const e=(this.packing.trays[this.tray-1]?.placements??[]).filter(i=>i.part===t.part);if(e.length<2)return h;const s=e.findIndex(i=>i.copy===t.copy),n=i=>{const a=e[(s+i+e.length)%e.length];a&&this.session.build.set({selected:[{part:a.part,copy:a.copy}]})};return l`<div class="row between steps">
      ${V("left","The copy before",()=>n(-1),"s")}
      <button
        type="button"
        class="link small"
        @click=${()=>this.session.build.set({selected:e.map(({part:i,copy:a})=>({part:i,copy:a}))})}
      >
        Select all ${D(e.length)}
      </button>
      ${V("right","The next copy",()=>n(1),"s")}
    </div>`}several(t){const e=new Set(t.map(o=>o.part)),[s]=t,n=e.size===1?this.parts.find(o=>o.index===s?.part):void 0,i=t.reduce((o,c)=>o+(this.parts.find(u=>u.index===c.part)?.volume??0),0),a=new Set(t.map(o=>yi(o.transform))),r=n?n.name:x(e.size,"part");return l`${this.head(n,r,`${D(t.length)} selected`)}
      <dl class="kv">
        <dt>Volume</dt>
        <dd>${$n(i)}</dd>
        <dt>Stand</dt>
        <dd>${a.size===1?[...a][0]:x(a.size,"way")}</dd>
      </dl>
      ${n&&s?l`<div class="row between steps">
              <button
                type="button"
                class="link small"
                @click=${()=>this.session.build.set({selected:[{part:s.part,copy:s.copy}]})}
              >
                One after the other
              </button>
            </div>`:h}`}};Ut([m({attribute:!1})],kt.prototype,"session",2);Ut([m({attribute:!1})],kt.prototype,"packing",2);Ut([m({attribute:!1})],kt.prototype,"parts",2);Ut([m({type:Number})],kt.prototype,"tray",2);Ut([P()],kt.prototype,"clearance",2);Ut([P()],kt.prototype,"unknown",2);kt=Ut([v("sp-selected")],kt);var hu=Object.defineProperty,du=Object.getOwnPropertyDescriptor,Le=(t,e,s,n)=>{for(var i=n>1?void 0:n?du(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&hu(e,s,i),i};let Yt=class extends w{constructor(){super(...arguments),this.parts=[],this.tray=1}stores(){return[this.session.run.state,this.session.state,this.session.build,b]}render(){const{session:t,packing:e,tray:s}=this,n=e.trays.length<2?"Build":s===0?"All trays":`Tray ${s}`;return l`<div class="head">
        <h2 class="grow nw">${n}</h2>
        <button
          type="button"
          class="btn s ghost"
          @click=${()=>tt({page:"job",id:t.id,step:"parts"})}
        >
          ${g("add")}Add parts
        </button>
        <button type="button" class="btn s" @click=${()=>t.pack()}>Pack again</button>
      </div>
      <div class="scroll">
        ${Zl(t,e,s)}
        <section class="sec">${this.figures()}</section>
        ${t.build.value.selected.length>0&&s>0?l`<sp-selected .session=${t} .packing=${e} .parts=${this.parts} .tray=${s}></sp-selected>`:h}
        ${ru(t.job,e)} ${this.how()}
      </div>`}figures(){const{packing:t,session:e,tray:s}=this,n=t.trays[s-1],i=e.job.verdict?.min_gap??t.minGap,a=n&&t.trays.length>1?n.placements.length:t.placed,r=n?n.height:Math.max(0,...t.trays.map(u=>u.height)),o=n?n.density:t.density,c=n?"of the tray filled":`filled, of ${t.trays.length} trays`;return l`<div class="fig">
      ${B((o*100).toFixed(1),"%",c)}
      ${B(r.toFixed(1),"mm",t.openHeight?"height reached":n?`height of ${_(t.size[2])}`:"greatest height")}
      ${B(_(a),`of ${_(t.copies)}`,n&&t.trays.length>1?"copies in this tray":"copies placed")}
      ${i===null?B("–","","least gap"):B(i.toFixed(2),"mm","least gap, measured")}
    </div>`}how(){const{packing:t}=this,e=t.improvement;return l`<section class="sec">
      <h3>How it went</h3>
      <p class="dim">Packed in ${Dt(t.seconds)}.</p>
      ${e?l`<p class="dim">Packed better: ${Ea(e.what,e.before,e.now)}</p>`:h}
    </section>`}};Le([m({attribute:!1})],Yt.prototype,"session",2);Le([m({attribute:!1})],Yt.prototype,"packing",2);Le([m({attribute:!1})],Yt.prototype,"parts",2);Le([m({type:Number})],Yt.prototype,"tray",2);Yt=Le([v("sp-result")],Yt);var pu=Object.defineProperty,fu=Object.getOwnPropertyDescriptor,ie=(t,e,s,n)=>{for(var i=n>1?void 0:n?fu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&pu(e,s,i),i};const mu=10;let Ft=class extends w{constructor(){super(...arguments),this.parts=[],this.tray=1,this.at=0}stores(){return[this.session.build,this.session.meshes.state]}firstUpdated(){this.input.focus()}standing(){const{live:t,state:e}=this.session.run,n=e.value.packing?.trays[this.tray-1]?.placements??t.trays.get(this.tray)?.copies.values()??[],i=new Map;for(const{part:a,copy:r}of n)i.set(a,[...i.get(a)??[],{part:a,copy:r}]);return i}hits(){const t=(this.session.build.value.find??"").trim().toLowerCase(),e=/^(.*\S)\s+(\d+)$/.exec(t),s=this.standing(),n=[];for(const i of this.parts){const a=s.get(i.index)??[];if(a.length===0)continue;const r=i.name.toLowerCase();if(e?.[1]&&r.includes(e[1])){const o=a.find(c=>c.copy===Number(e[2])-1);o&&n.unshift({part:i,copies:[o],text:`${i.name} ${o.copy+1}`})}r.includes(t)&&n.push({part:i,copies:a,text:i.name})}return n.slice(0,mu)}render(){const t=this.hits(),{meshes:e,build:s}=this.session;return l`<div class="hud find-box card" role="search">
      <span class="in wide">
        ${g("find")}
        <input
          type="search"
          role="combobox"
          aria-expanded="true"
          aria-controls="find-hits"
          aria-activedescendant=${t.length>0?`hit-${this.at}`:h}
          aria-label="Find a copy or part"
          placeholder="fan-blower 4"
          .value=${s.value.find??""}
          @input=${n=>{this.at=0,s.set({find:n.target.value})}}
          @keydown=${n=>this.key(n,t)}
        />
      </span>
      <div id="find-hits" role="listbox" aria-label="Found">
        ${t.map((n,i)=>l`<div
              id="hit-${i}"
              class="li ${i===this.at?"sel":""}"
              role="option"
              aria-selected=${i===this.at}
              @click=${()=>this.take(n)}
            >
              ${ot(n.part.mesh?e.picture(n.part.mesh,_t(n.part.index),b.value.theme):null)}
              <span class="cut">${n.text}</span>
              <span class="count">${n.copies.length>1?D(n.copies.length):""}</span>
            </div>`)}
        ${t.length===0?l`<p class="small dim none">Nothing of that name stands in this tray.</p>`:h}
      </div>
    </div>`}key(t,e){if(t.key==="ArrowDown"||t.key==="ArrowUp"){t.preventDefault();const s=t.key==="ArrowDown"?1:e.length-1;this.at=e.length>0?(this.at+s)%e.length:0}else if(t.key==="Enter"){const s=e[this.at];s&&this.take(s)}else t.key==="Escape"&&(t.stopPropagation(),this.session.build.set({find:null}))}take(t){this.session.build.set({selected:t.copies,find:null}),this.dispatchEvent(new CustomEvent("found",{bubbles:!0}))}};ie([m({attribute:!1})],Ft.prototype,"session",2);ie([m({attribute:!1})],Ft.prototype,"parts",2);ie([m({type:Number})],Ft.prototype,"tray",2);ie([P()],Ft.prototype,"at",2);ie([W("input")],Ft.prototype,"input",2);Ft=ie([v("sp-find")],Ft);var $u=Object.defineProperty,bu=Object.getOwnPropertyDescriptor,z=(t,e,s,n)=>{for(var i=n>1?void 0:n?bu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&$u(e,s,i),i};let E=class extends w{constructor(){super(...arguments),this.label="",this.unit="",this.value=null,this.least=Number.NEGATIVE_INFINITY,this.most=Number.POSITIVE_INFINITY,this.above=!1,this.step=1,this.digits=2,this.places=0,this.optional=!1,this.placeholder="",this.mixed=!1,this.disabled=!1,this.classes="n",this.tab=0,this.problem="",this.typing=!1}focus(){this.input?.focus(),this.input?.select()}shown(){return this.mixed||this.value===null?"":this.places>0&&Number.isInteger(this.value*10**this.places)?this.value.toFixed(this.places):yt(this.value,Math.max(this.digits,this.places))}updated(){const t=this.shown();!this.typing&&this.input.value!==t&&(this.input.value=t)}render(){return l`<span class="in ${this.classes} ${this.problem?"wrong":""}">
        <input
          type="text"
          inputmode="decimal"
          autocomplete="off"
          spellcheck="false"
          tabindex=${this.tab}
          aria-label=${this.label}
          aria-invalid=${this.problem!==""}
          placeholder=${this.mixed?"–":this.placeholder}
          ?disabled=${this.disabled}
          @input=${this.typed}
          @change=${this.commit}
          @focus=${()=>this.input.select()}
          @blur=${this.commit}
          @keydown=${this.key}
          @wheel=${{handleEvent:t=>this.wheel(t),passive:!1}}
        />${this.unit?l`<span class="u">${this.unit}</span>`:h}</span
      >${this.problem?l`<span class="range" role="alert">${this.problem}</span>`:h}`}typed(){this.typing=!0,this.problem=""}commit(){if(!this.typing)return;const t=this.input.value.trim();if(t===""&&(this.optional||this.mixed)){this.done(this.mixed?void 0:null);return}const e=ut(t);if(e===null||e>this.most||(this.above?e<=this.least:e<this.least)){this.problem=this.range();return}this.done(Number(e.toFixed(this.digits)))}done(t){this.typing=!1,this.problem="";const e=this.value;t!==void 0&&(t!==e||this.mixed)&&this.dispatchEvent(new CustomEvent("value",{detail:t,bubbles:!0})),this.requestUpdate(),this.input.value=t===void 0||t===e?this.shown():this.input.value}range(){const{least:t,most:e}=this,s=this.above?`more than ${yt(t)}`:`${yt(t)} or more`;return Number.isFinite(t)&&Number.isFinite(e)?`${yt(t)} to ${yt(e)}`:Number.isFinite(t)?s:Number.isFinite(e)?`${yt(e)} or less`:"A number"}key(t){t.key==="Enter"?this.commit():t.key==="Escape"&&this.typing?(t.stopPropagation(),this.typing=!1,this.problem="",this.input.value=this.shown()):(t.key==="ArrowUp"||t.key==="ArrowDown")&&(t.preventDefault(),t.stopPropagation(),this.stepBy(t.key==="ArrowUp"?1:-1,t.shiftKey))}wheel(t){document.activeElement!==this.input||this.disabled||(t.preventDefault(),this.stepBy(t.deltaY<0?1:-1,t.shiftKey))}stepBy(t,e){const i=((this.typing?ut(this.input.value):this.value)??(Number.isFinite(this.least)?this.least:0))+t*this.step*(e?10:1),a=this.above?this.least+this.step:this.least;this.typing=!0,this.input.value=yt(Math.min(this.most,Math.max(a,i)),this.digits),this.commit()}};z([m()],E.prototype,"label",2);z([m()],E.prototype,"unit",2);z([m({attribute:!1})],E.prototype,"value",2);z([m({type:Number})],E.prototype,"least",2);z([m({type:Number})],E.prototype,"most",2);z([m({type:Boolean})],E.prototype,"above",2);z([m({type:Number})],E.prototype,"step",2);z([m({type:Number})],E.prototype,"digits",2);z([m({type:Number})],E.prototype,"places",2);z([m({type:Boolean})],E.prototype,"optional",2);z([m()],E.prototype,"placeholder",2);z([m({type:Boolean})],E.prototype,"mixed",2);z([m({type:Boolean})],E.prototype,"disabled",2);z([m()],E.prototype,"classes",2);z([m({type:Number})],E.prototype,"tab",2);z([P()],E.prototype,"problem",2);z([W("input")],E.prototype,"input",2);E=z([v("sp-number")],E);function gu(t,e){const s=t.run.live.newest,n=e.find(a=>a.index===s?.copy.part);if(!s||!n)return h;const i=n.mesh?t.meshes.picture(n.mesh,_t(n.index),b.value.theme):null;return l`<div class="glass placed">
    ${ot(i)}
    <span><span class="small dim">Just placed</span><b class="cut">${n.name} ${s.copy.copy+1}</b></span>
  </div>`}function yu(t,e){const{build:s}=t,{colouring:n}=s.value;return l`<div class="stack">
    <div class="glass">
      <span class="lab hide-s">Colour by</span>
      ${ee("Colour by",Be,n,i=>s.set({colouring:i}),"s flat")}
    </div>
    ${e&&n!=="part"?vu(e,n==="height"?`${L}mm`:""):h}
  </div>`}function vu(t,e){return l`<div class="glass legend" role="img" aria-label="Legend: ${t.values.map(Math.round).join(", ")}${e}">
    <i ${Q({background:`linear-gradient(90deg, ${t.colours.join(", ")})`})}></i>
    <span class="row between">${t.values.map(s=>l`<span>${Math.round(s)}${e}</span>`)}</span>
  </div>`}const wu=[{side:"home",text:"All of it, from the corner"},{side:"front",text:"From the front"},{side:"back",text:"From the back"},{side:"left",text:"From the left"},{side:"right",text:"From the right"},{side:"top",text:"From above"}];function ku(t){return l`<sp-menu
    label="Look from"
    hint="Look from"
    buttonClasses="btn ghost icon float"
    .button=${g("box")}
    .content=${()=>l`${wu.map(({side:e,text:s})=>l`<button type="button" class="mi plain" role="menuitem" @click=${()=>t(e)}>
            <span>${s}</span>
          </button>`)}`}
  ></sp-menu>`}function xu(t){const{build:e}=t,{selected:s,isolated:n}=e.value,i=s.length>0,a=qr(e.value),r=(c,u,d,p)=>l`<button type="button" class="mi plain" role="menuitem" ?disabled=${d} @click=${p}>
      <span>${c}</span><kbd>${u}</kbd>
    </button>`,o=n?"Show the others again":"Show only what is selected";return l`<sp-menu
    label="Hide and show"
    hint="Hide and show"
    buttonClasses="btn ghost icon float ${a?"on":""}"
    .button=${g(a?"eyeOff":"eye")}
    .content=${()=>l`
      ${r("Hide what is selected","H",!i,()=>e.set(Wi(e.value)))}
      ${r(o,"I",!i&&!n,()=>e.set(Ki(e.value)))}
      ${r("Show all","Shift H",!a,()=>e.set(qi))}
    `}
  ></sp-menu>`}function _u(t){const{build:e}=t,{section:s}=e.value,n=i=>e.set({section:i===null?null:da(t,i,s)});return l`<div class="glass">
    <span class="lab hide-s">Section</span>
    ${ee("Section",[{value:null,text:"Off"},{value:"x",text:"X"},{value:"y",text:"Y"},{value:"z",text:"Z"}],s?.axis??null,n,"s flat")}
    ${s?Mu(t,s):h}
  </div>`}function Mu(t,e){const s=n=>t.build.set({section:{...e,...n}});return l`<sp-number
      label=${`Section at ${e.axis.toUpperCase()}`}
      unit="mm"
      classes="s at"
      .value=${e.at}
      .least=${0}
      .most=${kn(t,e.axis)}
      .places=${1}
      .digits=${1}
      @value=${n=>s({at:n.detail??0})}
    ></sp-number>
    ${V("flip","Other side (B)",()=>s({flipped:!e.flipped}),"s hide-s")}`}const Pu=3e6,Ou=1e4;class Su{constructor(e,s,n){this.session=e,this.view=s,this.changed=n,this.parts="",this.standing="",this.hidden=[],this.ready=!1,this.asked="",this.labelled=""}showLive(e,s,n){const{draft:i,info:a}=this.session,r=this.session.parts.meshes,o=xt(i,a,r)??[100,100,100],c=i.keepOut.flatMap(H=>"box"in H?[H.box]:[]),u=i.tray.kind==="mesh"?i.tray.file:null;if(this.setTray(o,i.openHeight,c,u),!this.setParts(e))return;const d=`live ${n}`,p=d!==this.standing,f=this.standing==="";p&&this.view.clear(),this.standing=d;const{cleared:$,placed:y,removed:k}=s.drain(n,p);$&&!p&&this.view.clear(),k.length>0&&this.view.remove(k);const O=s.newest?.tray===n?s.newest.copy:null,N=y.filter(H=>H.part===O?.part&&H.copy===O.copy),K=y.filter(H=>!N.includes(H));K.length>0&&this.view.place(K),N.length>0&&this.view.place(N,!0),f&&this.view.frame(null)}showPacked(e,s,n){const i=this.session.draft.tray.kind==="mesh"?this.session.draft.tray.file:null;if(this.setTray(s.size,s.openHeight,s.keepOut,i),!this.setParts(e))return;const a=`packed ${n.number} ${s.placed} ${s.seconds}`;if(a===this.standing)return;const r=this.standing==="";this.standing=a,this.view.clear(),this.view.place(n.placements.map(Au)),r&&this.view.frame(null),this.refine(e,n)}showView(e){this.view.setColouring(e.colouring),this.view.setSection(e.section),this.view.setSelected(e.selected);const s=[e.hiddenParts,e.hiddenCopies,e.isolated];s.every((n,i)=>n===this.hidden[i])||(this.hidden=s,this.view.setHidden(n=>Br(e,n)))}showLabels(e,s,n){const i=[...s.length===1?s:[],...n?[n]:[]],a=new Map(i.map(o=>{const c=e.find(u=>u.index===o.part);return[X(o),{copy:o,text:`${c?.name??""} ${o.copy+1}`}]})),r=[...a.keys()].join();r!==this.labelled&&(this.labelled=r,this.view.setLabels([...a.values()]))}setTray(e,s,n,i){const a=i===null?null:this.session.parts.meshes.find(u=>u.file===i),r=a?this.session.meshes.mesh(a):null;a&&!r&&this.session.meshes.load([a]).then(this.changed);const o=JSON.stringify([e,s,n,i,r!==null]);if(o===this.asked)return;this.asked=o;const c=n.map(u=>[...u]);this.view.setTray([e[0],e[1],s?null:e[2]],r??void 0,c)}setParts(e){const s=e.map(n=>`${n.index}:${n.mesh?.id}:${n.mesh?.volume}`).join();if(s!==this.parts){this.parts=s,this.ready=!1,this.standing="";const n=e.flatMap(i=>i.mesh?[i.mesh]:[]);this.session.meshes.load(n).then(()=>{s===this.parts&&(this.view.setParts(e.flatMap(i=>this.viewPart(i))),this.ready=!0,this.changed())})}return this.ready}viewPart(e){const s=e.mesh?this.session.meshes.mesh(e.mesh):null;return s?[{index:e.index,name:e.name,mesh:s}]:[]}async refine(e,s){const n=this.parts,i=new Map;for(const{part:o}of s.placements)i.set(o,(i.get(o)??0)+1);const a=e.filter(o=>o.mesh&&i.has(o.index));if(!(a.reduce((o,c)=>o+Math.min(Ou,c.mesh?.triangles??0)*(i.get(c.index)??0),0)>Pu))for(const o of a){if(!o.mesh)continue;const c=await this.session.meshes.fine(o.mesh);if(n!==this.parts||!this.standing.startsWith(`packed ${s.number} `))return;c&&this.view.refine(new Map([[o.index,c]]))}}}function Au(t){const{part:e,copy:s,transform:n,index:i,step:a}=t;return a===null?{part:e,copy:s,transform:n,order:i}:{part:e,copy:s,transform:n,order:i,step:a}}var Cu=Object.defineProperty,Tu=Object.getOwnPropertyDescriptor,lt=(t,e,s,n)=>{for(var i=n>1?void 0:n?Tu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Cu(e,s,i),i};let et=class extends w{constructor(){super(...arguments),this.parts=[],this.live=!1,this.tray=1,this.lost=!1,this.failed="",this.hovered=null,this.legend=null,this.view=null,this.scene=null,this.loading=!1,this.noPicture=null}stores(){const{session:t}=this;return[t.run.state,t.build,t.source.state,t.meshes.state,b]}disconnectedCallback(){super.disconnectedCallback(),this.end()}updated(t){this.view&&this.scene?this.sync(this.view,this.scene):this.begin()}async begin(){if(!(this.loading||this.failed)){this.loading=!0;try{const{createTrayView:t}=await ho();if(!this.isConnected)return;const{build:e}=this.session;this.view=t(this.stage,{select:(s,n)=>this.select(s,n),hover:s=>{this.hovered=s},section:s=>{const n=e.value.section;n&&e.set({section:{...n,at:s}})},lost:s=>{this.lost=s}},b.value.theme),this.scene=new Su(this.session,this.view,()=>this.requestUpdate()),this.noPicture=Sl(async()=>{const{clientWidth:s,clientHeight:n}=this.stage;if(!this.view)throw new Error("There is no picture yet.");return this.view.picture(s*2,n*2)}),this.requestUpdate()}catch{this.failed="This browser draws no 3D graphics. Lists, figures and export work without them."}finally{this.loading=!1}}}end(){this.noPicture?.(),this.view?.dispose(),this.view=null,this.scene=null}sync(t,e){const{session:s}=this,{packing:n}=s.run.state.value;t.setTheme(b.value.theme);const i=n?.trays[this.tray-1];this.live?e.showLive(this.parts,s.run.live,this.tray):n&&i&&e.showPacked(this.parts,n,i),e.showView(s.build.value),e.showLabels(this.parts,s.build.value.selected,this.hovered);const a=t.legend();JSON.stringify(a)!==JSON.stringify(this.legend)&&(this.legend=a)}select(t,e){const{build:s}=this.session;if(!t){e||s.set({selected:[]});return}s.set({selected:e?Kr(s.value.selected,t):[t]})}frame(t){const{selected:e}=this.session.build.value;this.view?.frame(t||e.length===0?null:e)}render(){const{session:t}=this,{build:e}=t,{find:s}=e.value;return l`<section class="view tray" aria-label="Tray">
      <div class="stage"></div>
      <p class="out">${this.summary()}</p>
      <div class="hud tl">${this.live?gu(t,this.parts):yu(t,this.legend)}</div>
      <div class="hud tr">
        <div class="glass">
          ${V("frame","Frame all (Shift+F)",()=>this.frame(!0),"float")} ${ku(n=>this.view?.look(n))} ${xu(t)}
          ${V("find","Find a copy or part (/)",()=>e.set({find:s===null?"":null}),"float")}
        </div>
      </div>
      ${s===null?h:l`<sp-find .session=${this.session} .parts=${this.parts} .tray=${this.tray} @found=${()=>this.frame(!1)}></sp-find>`}
      ${this.live?h:l`<div class="hud bc">${_u(t)}</div>`}
      ${this.failed||this.lost?l`<div class="lost">
              <p>${this.failed||"The graphics card took the picture away."}</p>
              ${this.failed?h:l`<button type="button" class="btn" @click=${this.again}>Draw again</button>`}
            </div>`:h}
    </section>`}again(){this.end(),this.lost=!1,this.requestUpdate()}summary(){const{packing:t}=this.session.run.state.value,{selected:e}=this.session.build.value,s=e.length>0?` ${D(e.length)} selected.`:"";if(this.live)return`${D(this.session.run.live.standing)} placed so far.${s}`;const n=t?.trays[this.tray-1];if(!n)return"";const i=new Set(n.placements.map(a=>a.part)).size;return`${D(n.placements.length)} of ${x(i,"part")}, ${R(n.density)} filled.${s}`}};lt([m({attribute:!1})],et.prototype,"session",2);lt([m({attribute:!1})],et.prototype,"parts",2);lt([m({type:Boolean})],et.prototype,"live",2);lt([m({type:Number})],et.prototype,"tray",2);lt([W(".stage")],et.prototype,"stage",2);lt([P()],et.prototype,"lost",2);lt([P()],et.prototype,"failed",2);lt([P()],et.prototype,"hovered",2);lt([P()],et.prototype,"legend",2);et=lt([v("sp-tray")],et);var Eu=Object.defineProperty,ju=Object.getOwnPropertyDescriptor,De=(t,e,s,n)=>{for(var i=n>1?void 0:n?ju(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Eu(e,s,i),i};const Lu=40;let Zt=class extends w{constructor(){super(...arguments),this.parts=[],this.all=!1}stores(){return[this.session.run.state,this.session.meshes.state,b]}render(){const{packing:t}=this,e=Math.max(...t.trays.map(s=>s.density),1e-9);return l`<section class="trays" aria-label="All trays">
      <div class="tgrid">${t.trays.map(s=>this.card(s,e))}</div>
      ${this.table()}
    </section>`}card(t,e){const s=this.session.job.verdict?.apart==="checked"&&t.complete,n=xn(this.packing,t.number),[i,a,r]=this.packing.size;return l`<article class="card tcard ${r>=Math.max(i,a)?"tall":""}">
      <button
        type="button"
        class="whole"
        aria-label="Open tray ${t.number}"
        @click=${()=>es(this.session,t.number)}
      ></button>
      <div class="view"><img src=${rn(this.session.id,"png",t.number)} alt="Tray ${t.number}" loading="lazy" /></div>
      <div class="bd">
        <div class="row between">
          <h2>Tray ${t.number}</h2>
          ${n?l`<span class="row small b warn-text">${g("warn")}Nearly empty</span>`:s?l`<span class="ok-text" role="img" aria-label="Comes apart: checked" title="Comes apart: checked"
                    >${g("check")}</span
                  >`:h}
        </div>
        <div class="row between">
          <span class="dim">${D(t.placements.length)}</span><b>${R(t.density)}</b>
        </div>
        ${ms(t.density/e)}
      </div>
    </article>`}table(){const{trays:t}=this.packing,e=t.map(i=>Sa([i])),s=this.all?this.parts:this.parts.slice(0,Lu),n=(i,a)=>`color-mix(in srgb, var(--accent) ${Math.round(4+32*i/Math.max(1,a.count))}%, transparent)`;return l`<div class="card wide-table">
      <table class="mx">
        <thead>
          <tr>
            <th scope="col">Where each part went</th>
            ${t.map(i=>l`<th scope="col">Tray ${i.number}</th>`)}
            <th scope="col">Left over</th>
            <th scope="col">Total</th>
          </tr>
        </thead>
        <tbody>
          ${s.map(i=>{const a=e.map(o=>o.get(i.index)??0),r=i.count-a.reduce((o,c)=>o+c,0);return l`<tr>
              <th scope="row">
                <span class="row">
                  ${ot(i.mesh?this.session.meshes.picture(i.mesh,_t(i.index),b.value.theme):null,"th small-th")}<span class="cut">${i.name}</span>
                </span>
              </th>
              ${a.map(o=>l`<td>
                    ${o>0?l`<span class="share" ${Q({background:n(o,i)})}>${o}</span>`:l`<span class="faint">·</span>`}
                  </td>`)}
              <td>${r>0?l`<span class="warn-text">${r}</span>`:l`<span class="faint">·</span>`}</td>
              <td class="b">${i.count}</td>
            </tr>`})}
        </tbody>
      </table>
      ${s.length<this.parts.length?l`<button
              type="button"
              class="link more"
              @click=${()=>{this.all=!0}}
            >
              ${x(this.parts.length-s.length,"more part")}
            </button>`:h}
    </div>`}};De([m({attribute:!1})],Zt.prototype,"session",2);De([m({attribute:!1})],Zt.prototype,"packing",2);De([m({attribute:!1})],Zt.prototype,"parts",2);De([P()],Zt.prototype,"all",2);Zt=De([v("sp-trays")],Zt);var Du=Object.defineProperty,zu=Object.getOwnPropertyDescriptor,ws=(t,e,s,n)=>{for(var i=n>1?void 0:n?zu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Du(e,s,i),i};let Me=class extends w{constructor(){super(...arguments),this.drawer=null,this.release=null,this.liveKeys=null,this.saidTenth=-1,this.wasRunning=!1,this.parts=[],this.madeOf=[]}stores(){const{session:t}=this;return[t.run.state,t.build,t.source.state]}disconnectedCallback(){super.disconnectedCallback(),this.release?.(),this.release=null,this.liveKeys=null}updated(t){const e=J(this.session.job);e!==this.liveKeys&&(this.release?.(),this.release=gn(sc({session:()=>this.session,frame:s=>this.pane?.frame(s),openExport:()=>document.querySelector("sp-export")?.show()},e)),this.liveKeys=e),this.say(e)}say(t){const{progress:e}=this.session.run.live;if(t&&e?.phase==="search"&&e.total>0){const s=Math.floor(10*e.done/e.total);s>this.saidTenth&&s>0&&Es(`${s*10} percent of the copies are placed.`),this.saidTenth=s}if(this.wasRunning&&!t){const{job:s,packing:n}=this.session.run.state.value,i=Jt(s)?.text??ts(s).text;Es(n?`Done. ${D(n.placed)} placed, ${R(n.density)} filled. ${i}.`:ts(s).text)}this.wasRunning=t}render(){const{session:t}=this,{job:e,packing:s,loading:n}=t.run.state.value,i=n&&!s&&t.run.live.standing>0;if(J(e)||i)return this.live();if(!s)return this.nothingThere();const a=this.partsOf(s,()=>jc(t,s)),r=s.trays.length<2?1:Math.min(t.build.value.tray,s.trays.length);return r===0?this.all(s,a):this.one(s,a,r)}partsOf(t,e){const{meshes:s}=this.session.parts;return(this.madeOf[0]!==t||this.madeOf[1]!==s)&&(this.madeOf=[t,s],this.parts=e()),this.parts}live(){const{session:t}=this,{live:e}=t.run,{follow:s,tray:n}=t.build.value,i=this.partsOf(t.draft,()=>Tc(t)),a=s||n===0?e.current:n,r=xt(t.draft,t.info,t.parts.meshes)??[100,100,100],o=nu(t,e,i,a,r);return this.frame({live:!0,parts:i,tray:a,tabs:e.trays.size>1?this.liveTabs(a):h,layers:o.layers,height:Math.max(r[2],o.height),average:o.density,panel:l`<sp-packing .session=${t} .figures=${o}></sp-packing>`})}one(t,e,s){const{session:n}=this,i=t.trays[s-1];return this.frame({live:!1,parts:e,tray:s,tabs:ui(n,t,s),layers:i?.layers??null,height:Math.max(t.size[2],i?.height??0),average:i?.density??0,panel:this.resultPanel(t,e,s)})}resultPanel(t,e,s){return l`<sp-result .session=${this.session} .packing=${t} .parts=${e} .tray=${s}></sp-result>`}frame(t){const{session:e}=this,{live:s,parts:n,tray:i}=t;return l`${t.tabs}
      <main class="main build" data-drawer=${this.drawer??h}>
        <h1 class="out">${e.job.name}: build</h1>
        <aside class="side left" aria-label="Parts">
          <sp-build-list .session=${e} .parts=${n} ?live=${s} .tray=${i}></sp-build-list>
        </aside>
        <sp-divider property="--left" side="left" label="Width of the list" most="480"></sp-divider>
        <div class="vsplit">
          <sp-tray .session=${e} .parts=${n} ?live=${s} .tray=${i}></sp-tray>
          <sp-layers
            .session=${e}
            ?live=${s}
            .layers=${t.layers}
            .height=${t.height}
            .average=${t.average}
          ></sp-layers>
        </div>
        <sp-divider property="--right" side="right" label="Width of the figures" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label=${s?"Packing":"Build"}>${t.panel}</aside>
        ${this.drawers()}
      </main>`}all(t,e){const{session:s}=this;return l`${ui(s,t,0)}
      <main class="main build all" data-drawer=${this.drawer??h}>
        <h1 class="out">${s.job.name}: all trays</h1>
        <sp-trays .session=${s} .packing=${t} .parts=${e}></sp-trays>
        <sp-divider property="--right" side="right" label="Width of the figures" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Build">${this.resultPanel(t,e,0)}</aside>
        ${this.drawers()}
      </main>`}liveTabs(t){const{live:e}=this.session.run;return l`<nav class="tstrip" aria-label="Trays"><div class="tabs-row" role="tablist">
      ${[...e.trays.values()].map(s=>l`<button
            type="button"
            class="tt plain ${s.number===t?"on":""}"
            role="tab"
            aria-selected=${s.number===t}
            @click=${()=>this.session.build.set({tray:s.number,follow:s.number===e.current})}
          >
            ${s.finished?l`<span class="ok-text">${g("check")}</span>`:ht}
            <span><b>Tray ${s.number}</b><small>${D(s.copies.size)}</small></span>
          </button>`)}
    </div></nav>`}drawers(){const t=(e,s)=>l`<button
        type="button"
        class="btn"
        aria-pressed=${this.drawer===e}
        @click=${()=>{this.drawer=this.drawer===e?null:e}}
      >
        ${g(e==="left"?"list":"info")}${s}
      </button>`;return l`<div class="drawers">${t("left","Parts")}${t("right","Figures")}</div>`}nothingThere(){const{session:t}=this,{job:e,loading:s,problem:n}=t.run.state.value;if(s||e.has_packing&&!n)return l`<main class="empty" aria-busy="true"><p class="dim row">${ht}Opening the build …</p></main>`;const i={failed:["The run failed",e.error?q(e.error):"Nothing is said of why."],cancelled:["Stopped","Nothing was placed by then."],interrupted:["Interrupted","The computer or the program stopped before anything was placed."]},[a,r]=i[e.status]??["No build yet",n??"Press Pack on the Parts step."];return l`<main class="empty">
      <h2>${a}</h2>
      <p class="dim">${r}</p>
      <div class="row">
        ${e.status==="interrupted"||e.status==="cancelled"?l`<button type="button" class="btn primary" @click=${()=>t.goOn()}>Continue packing</button>`:h}
        <button
          type="button"
          class="btn ${e.status==="failed"?"primary":""}"
          @click=${()=>tt({page:"job",id:t.id,step:"parts"})}
        >
          To the parts
        </button>
        ${e.status==="failed"?l`<button type="button" class="btn" @click=${()=>t.pack()}>Pack again</button>`:h}
      </div>
    </main>`}};ws([m({attribute:!1})],Me.prototype,"session",2);ws([P()],Me.prototype,"drawer",2);ws([W("sp-tray")],Me.prototype,"pane",2);Me=ws([v("sp-build")],Me);function Nu(t){const e=[...t.files??[]].map(s=>({file:s,path:s.webkitRelativePath||s.name}));return t.value="",e}function ja(t){return[...t.dataTransfer?.items??[]].filter(e=>e.kind==="file").length}async function La(t){const e=[...t.dataTransfer?.items??[]].filter(a=>a.kind==="file"),s=e.map(a=>a.webkitGetAsEntry?.()??null),n=e.map(a=>a.getAsFile());return(await Promise.all(s.map((a,r)=>{const o=n[r];return a?Da(a):Promise.resolve(o?[{file:o,path:o.name}]:[])}))).flat()}async function Da(t){const e=t.fullPath.replace(/^\//,"");if(t.isFile){const n=await new Promise(i=>t.file(i,()=>i(null)));return n?[{file:n,path:e}]:[]}const s=[];for(const n of await Fu(t))s.push(...await Da(n));return s}async function Fu(t){const e=t.createReader(),s=[];for(;;){const n=await new Promise(i=>e.readEntries(i,()=>i([])));if(n.length===0)return s;s.push(...n)}}const Ru=".stl,.3mf,.obj,.ply,.off,.csv,.json";function ft(t,e={}){const s=document.createElement("input");s.type="file",s.multiple=e.several??!0,e.folder?s.webkitdirectory=!0:s.accept=e.accept??Ru,s.addEventListener("change",()=>t(Nu(s))),s.click()}function An(t){const{refused:e,dismissed:s}=t.state.value,n=t.parts.bad.map(({file:i,error:a,place:r})=>({file:i,error:q(r?`${r}: ${a}`:a)}));return[...e,...n].filter(({file:i})=>!s.has(i))}function Uu(t){return t.parts.sets.filter(e=>e.missing.length>0&&!t.state.value.dismissed.has(e.file)).map(e=>`${e.file} names ${x(e.missing.length,"file")} that ${e.missing.length===1?"is":"are"} not here: ${Iu(e.missing)}.`)}function Iu(t){const e=t.slice(0,3).join(", ");return t.length>3?`${e} and ${t.length-3} more`:e}function Hu(t,e){const s=An(t),n=s.length+t.parts.meshes.length;return l`${s.length>0?l`<div class="banner bad" role="status">
          ${g("bad")}
          <span class="grow">
            <b>${s.length} of ${x(Math.max(n,s.length),"file")} cannot be used.</b>
            ${e>0?l`<span class="dim">The other parts are ready to pack.</span>`:h}
          </span>
          <button type="button" class="btn s" @click=${()=>t.leaveOutFiles(s.map(({file:i})=>i))}>
            ${s.length===1?"Leave it out":s.length===2?"Leave both out":"Leave all out"}
          </button>
        </div>`:h}${Uu(t).map(i=>l`<div class="banner warn" role="status">
        ${g("warn")}<span class="grow">${i}</span>
        <button type="button" class="btn s" @click=${()=>ft(a=>t.addFiles(a))}>Add them</button>
      </div>`)}`}function Bu(t){return An(t).map(({file:e,error:s})=>l`<div class="pr bad-file" role="row">
        <span role="gridcell" class="c-check bad-text">${g("bad")}</span>
        <span role="gridcell" class="nm">
          <b class="cut">${e}</b>
          <span class="cut bad-text" title=${s}>${s}</span>
        </span>
        <span role="gridcell" class="row">
          <button
            type="button"
            class="btn s"
            @click=${()=>ft(([n])=>n&&t.replaceFile(e,n.file),{several:!1})}
          >
            Replace
          </button>
          <button type="button" class="btn s" @click=${()=>t.leaveOutFiles([e])}>Leave out</button>
        </span>
      </div>`)}var qu=Object.defineProperty,Wu=Object.getOwnPropertyDescriptor,Cn=(t,e,s,n)=>{for(var i=n>1?void 0:n?Wu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&qu(e,s,i),i};let is=class extends w{constructor(){super(...arguments),this.starting=!1}stores(){const{session:t}=this;return[t.state,t.saver.state,t.source.state,t.uploads.state,t.run.state,b]}render(){const{session:t}=this,e=Oa(Xs(t)),s=t.uploads.state.value.active||t.parts.reading>0;return l`<footer class="dock" aria-label="Estimate">
      ${this.figures()}
      <span class="grow"></span>
      ${this.remark(s)}
      <button
        type="button"
        class="btn primary l pack"
        ?disabled=${t.locked||e===0||s||this.starting}
        @click=${this.pack}
      >
        ${this.starting?ht:h}${e>0?`Pack ${D(e)}`:"Pack"}
        <kbd class="hide-s">Ctrl ↵</kbd>
      </button>
    </footer>`}figures(){const{estimate:t,estimating:e}=this.session.saver.state.value;if(!t)return e?l`<span class="dim row">${ht}Estimating …</span>`:h;const{volume_ratio:s,seconds:n,memory:i}=t,[a,r]=n===null?["",""]:Dt(n).split(L),[o,c]=Xe(i).split(L);return l`<div class="fig ${e?"stale":""}">
      ${s===void 0?h:this.fill(s)}
      ${a?B(`≈ ${a}`,r??"","to pack"):h}
      ${B(`≈ ${o}`,c??"","of memory")}
    </div>`}fill(t){const{draft:e}=this.session;if(e.trays==="all"||t>1)return B(`≈ ${t.toFixed(t<10?2:0)}`,"trays","of solid material");const s=t/e.trays*100;return B(`≈ ${s.toFixed(s<10?1:0)}`,"%",e.trays>1?"of the trays filled":"of the tray filled")}remark(t){const{session:e}=this,{problem:s,doubt:n,estimate:i}=e.saver.state.value;if(s??n)return l`<span class="row small bad-text remark-text">${g("bad")}<span>${s??n}</span></span>`;if(t)return l`<span class="row small dim">${ht}Files are still read</span>`;const a=Xs(e).filter(c=>c.remarks.some(u=>u.tone==="bad")).length;if(a>0)return l`<span class="row small warn-text"
        >${g("warn")}<span>Not everything may fit: ${x(a,"part")} ${a===1?"needs":"need"} a look</span></span
      >`;const r=An(e).length;if(r>0)return l`<span class="row small bad-text">${g("bad")}<span>${x(r,"file")} will be left out</span></span>`;const o=i?.left_over??0;return o>0?l`<span class="row small warn-text">${g("warn")}<span>${D(o)} will be left over</span></span>`:h}async pack(){this.starting=!0,await this.session.pack(),this.starting=!1}};Cn([m({attribute:!1})],is.prototype,"session",2);Cn([P()],is.prototype,"starting",2);is=Cn([v("sp-dock")],is);const ks=[{value:"any",text:"Any way",icon:"any"},{value:"upright",text:"Upright",icon:"upright"},{value:"fixed",text:"As drawn",icon:"drawn"},{value:"axes",text:"Axes",icon:"axes"}];function Qs(t){if(t.kind==="axes"){const e=[...new Set(t.axes.map(s=>s.slice(1).toUpperCase()))];return e.length===1?`About ${e[0]}`:"Axes"}return t.kind==="matrices"?"As listed":ks.find(e=>e.value===t.kind)?.text??""}function za(t){return ks.find(e=>e.value===t.kind)?.icon??"axes"}function Na(t,e){return t===e.kind?e:t==="axes"?{kind:t,axes:["+z","-z"],yaw:null}:t==="matrices"?e:{kind:t}}const Ku=["+x","-x","+y","-y","+z","-z"],Gu=t=>t.toUpperCase().replace("-","−");function Ju(t,e){switch(t.kind){case"any":return e;case"upright":return"Turned about the vertical only; its top stays up.";case"fixed":return"As it lies in its file.";case"axes":return"One of these directions of the part points up.";default:return"Turns listed in the job file."}}function Vu(t){return t===void 0||t==="90"||t===90?"24 positions tried":t==="none"?"As in the file: turns are off":t==="45"||t===45?"208 positions tried":`Turned in steps: ${t}`}const as=[{value:"1",text:"First"},{value:"0",text:"Normal"},{value:"-1",text:"If room"}];function Yu(t){return as.find(s=>Number(s.value)===t)?.text??String(t)}var Zu=Object.defineProperty,Xu=Object.getOwnPropertyDescriptor,Fa=(t,e,s,n)=>{for(var i=n>1?void 0:n?Xu(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Zu(e,s,i),i};let tn=class extends w{stores(){return[this.session.state,this.session.view]}get parts(){const{chosen:t,current:e}=this.session.view.value;return this.session.draft.parts.filter(s=>t.size>0?t.has(s.key):s.key===e)}change(t,e=""){const s=new Set(this.parts.map(n=>n.key));this.session.edit(n=>Ye(n,s,t),e&&`${e} ${s.size}`)}render(){const{parts:t}=this,[e]=t;if(!e)return h;const s=t.length>1,n=t.every(a=>a.stands.kind===e.stands.kind)?e.stands.kind:null,i=Vu(this.session.draft.options.rotations);return l`<div class="hud bl wide">
      <div class="card part-card">
        <div class="row between">
          <span class="small dim">${s?`${t.length} parts may stand`:"May stand"}</span>
          <span class="small faint cut">${n===null?"":Ju(e.stands,i)}</span>
        </div>
        ${ee("May stand",ks,n,a=>this.change({stands:Na(a,s?{kind:"any"}:e.stands)}),"fill s icons")}
        ${e.stands.kind==="axes"&&n==="axes"?this.axes(e.stands):h}
        <div class="fields ${s?"":"only-s"}">${this.fields(t,e,s)}</div>
      </div>
    </div>`}axes(t){const e=s=>{const i=t.axes.includes(s)?t.axes.filter(a=>a!==s):[...t.axes,s];i.length>0&&this.change({stands:{...t,axes:i}})};return l`<div class="row axes">
      <span class="small dim">Up</span>
      <div class="seg fill s" role="group" aria-label="Directions of the part that may point up">
        ${Ku.map(s=>l`<button type="button" aria-pressed=${t.axes.includes(s)} @click=${()=>e(s)}>
              ${Gu(s)}
            </button>`)}
      </div>
      ${Gt("Turned about the vertical in steps of",[{value:"",text:"usual turns"},{value:"90",text:"90° turns"},{value:"45",text:"45° turns"},{value:"15",text:"15° turns"},{value:"360",text:"no turns"}],t.yaw===null?"":String(t.yaw),s=>this.change({stands:{...t,yaw:s===""?null:Number(s)}}),"s")}
    </div>`}fields(t,e,s){const n=r=>t.every(o=>r(o)===r(e)),i=ys(this.session.draft,this.session.info).toFixed(1),a=n(r=>r.priority)?String(e.priority):null;return l`${s?l`<label class="field"
              ><span class="dim">Copies</span>
              <sp-number
                label="Copies of each"
                .value=${e.count}
                ?mixed=${!n(r=>r.count)}
                .least=${1}
                .digits=${0}
                @value=${r=>this.change({count:r.detail??1},"count")}
              ></sp-number>
            </label>
            <label class="field"
              ><span class="dim">Scale</span>
              <sp-number
                label="Scale"
                unit="%"
                .value=${e.scale*100}
                ?mixed=${!n(r=>r.scale)}
                .least=${0}
                above
                .digits=${4}
                @value=${r=>this.change({scale:(r.detail??100)/100},"scale")}
              ></sp-number>
            </label>`:h}
      <label class="field"
        ><span class="dim">Gap</span>
        <sp-number
          label="Gap"
          unit="mm"
          optional
          placeholder=${i}
          .value=${e.gap}
          ?mixed=${!n(r=>r.gap)}
          .least=${0}
          .step=${.5}
          .places=${1}
          @value=${r=>this.change({gap:r.detail},"gap")}
        ></sp-number>
      </label>
      <div class="field">
        <span class="dim">Priority</span>
        ${Gt("Priority",as,a,r=>this.change({priority:Number(r)}),"n")}
      </div>
      ${s?l`<label class="field"
              ><span class="dim">Due</span>
              <span class="in n date"
                ><input
                  type="date"
                  aria-label="Due date"
                  .value=${n(r=>r.due)?e.due??"":""}
                  @change=${r=>this.change({due:r.target.value||null})}
              /></span>
            </label>`:h}`}};Fa([m({attribute:!1})],tn.prototype,"session",2);tn=Fa([v("sp-part-card")],tn);var Qu=Object.defineProperty,th=Object.getOwnPropertyDescriptor,Tn=(t,e,s,n)=>{for(var i=n>1?void 0:n?th(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Qu(e,s,i),i};let rs=class extends w{constructor(){super(...arguments),this.view=null,this.loading=!1,this.shownAs=""}stores(){const{session:t}=this;return[t.state,t.view,t.source.state,t.meshes.state,b]}disconnectedCallback(){super.disconnectedCallback(),this.view?.dispose(),this.view=null,this.shownAs=""}get shown(){const{current:t}=this.session.view.value,{draft:e,parts:s}=this.session,n=e.parts.findIndex(a=>a.key===t),i=e.parts[n];return i?{part:i,index:n,mesh:Mn(s.meshes)(i)}:null}updated(t){this.view?this.draw(this.view):this.begin()}async begin(){if(this.loading||!this.shown)return;this.loading=!0;const{createPartView:t}=await po();if(this.loading=!1,!this.isConnected)return;const e=t(this.stage,b.value.theme);this.view=e,this.draw(e)}draw(t){t.setTheme(b.value.theme);const e=this.shown,s=e?.mesh;if(!e||!s){this.shownAs!==""&&t.show(null,1,"#888888","any"),this.shownAs="";return}const{part:n,index:i}=e,a=wa(n,s,this.session.draft),r=n.stands.kind==="matrices"?"axes":n.stands.kind,o=_t(i),c=[n.key,s.id,s.volume,s.triangles,a,r,o].join("|"),u=this.session.meshes.mesh(s);c!==this.shownAs&&(u?t.show(u,a,o,r):this.session.meshes.load([s]),this.shownAs=c,this.session.meshes.fine(s).then(d=>{d&&this.shownAs===c&&this.view?.show(d,a,o,r)}))}render(){const t=this.shown,{chosen:e}=this.session.view.value;return l`<section class="view preview" aria-label="Selected part">
      <div class="stage"></div>
      ${t?this.words(t):h}
      ${t||e.size>0?l`<sp-part-card .session=${this.session}></sp-part-card>`:h}
    </section>`}words({part:t,mesh:e}){const{draft:s,view:n}=this.session,i=n.value.inch?"inch":"mm";return l`<div class="hud tl wide">
      <div class="cut grow">
        <h2 class="cut">${je(t,e)}</h2>
        ${e?l`<p class="dim small cut">
                  ${at(vs(t,e,s),!0,i)} · ${$n(xa(t,e,s))}
                </p>
                <p class="dim small facts hide-s">${eh(e)}</p>`:l`<p class="dim small cut">${t.file}</p>`}
      </div>
      ${ee("Unit of the sizes shown",[{value:"mm",text:"mm"},{value:"inch",text:"inch"}],i,a=>n.set({inch:a==="inch"}),"s")}
    </div>`}};Tn([m({attribute:!1})],rs.prototype,"session",2);Tn([W(".stage")],rs.prototype,"stage",2);rs=Tn([v("sp-part-preview")],rs);function eh(t){const e=t.watertight?"closed":"not closed",s=t.shells>1?` · ${x(t.shells,"body","bodies")}`:"",n=`${x(t.triangles,"triangle")} · ${e}${s}`;return t.repairs.length===0?l`${n} · nothing mended`:l`${n} ·
    <details class="repairs">
      <summary class="link">${x(t.repairs.length,"thing")} mended</summary>
      <ul>
        ${t.repairs.map(i=>l`<li>${q(i)}</li>`)}
      </ul>
    </details>`}const At=["check","name","count","scale","stands","gap","priority","due"],sh="input, select, button",nh=new Set(["scale","stands","gap","priority","due"]);class ih{constructor(e){this.list=e,this.cell={row:0,column:1},this.wanted=!1,this.fresh=!1}settle(){this.wanted&&(this.wanted=!1,this.element(this.cell)?.focus())}focused(e){const s=e.target.closest("[data-column]"),n=s?.closest("[data-row]");if(!s||!n)return;const i={row:Number(n.dataset.row),column:At.indexOf(s.dataset.column)};i.row===this.cell.row&&i.column===this.cell.column||(this.cell=i,this.look(),this.list.requestUpdate())}pressed(e){const s=e.target.closest("[data-row]");this.fresh=s!==null&&!s.classList.contains("sel")}released(e){const s=e.target.closest("[data-column]");!this.fresh||!s||!nh.has(s.dataset.column??"")||(this.fresh=!1,this.list.updateComplete.then(()=>this.enter(s)))}key(e){const s=e.target,n=s.closest("[data-column]");n&&(s!==n?this.keyInField(e,n):this.keyOnCell(e,n))}keyInField(e,s){e.key==="Escape"?(e.stopPropagation(),s.focus()):e.key==="Enter"&&!e.ctrlKey&&!e.metaKey&&e.target instanceof HTMLInputElement&&(e.preventDefault(),this.move(1,0))}keyOnCell(e,s){const i=this.list.shown.length-1,r={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1],PageUp:[-8,0],PageDown:[8,0],Home:e.ctrlKey?[-i,-At.length]:[0,-At.length],End:e.ctrlKey?[i,0]:[0,At.length]}[e.key];r?(e.preventDefault(),e.stopPropagation(),e.shiftKey&&r[1]===0&&this.choose(this.cell.row,!0),this.move(r[0],r[1]),e.shiftKey&&r[1]===0&&this.choose(this.cell.row,!0)):(e.key==="Enter"||e.key==="F2")&&!e.ctrlKey&&!e.metaKey?(e.preventDefault(),this.enter(s)):e.key===" "?(e.preventDefault(),this.choose(this.cell.row,null)):e.key==="a"&&(e.ctrlKey||e.metaKey)?(e.preventDefault(),this.list.session.view.set({chosen:new Set(this.list.shown.map(o=>o.part.key))})):/^[0-9]$/.test(e.key)&&s.querySelector("input")&&(e.stopPropagation(),this.enter(s))}enter(e){const s=e.querySelector("input, select")??e.querySelector(sh);s&&(s.focus(),s instanceof HTMLInputElement?s.select?.():s instanceof HTMLButtonElement&&s.click())}move(e,s){const n=Math.max(0,Math.min(this.list.shown.length-1,this.cell.row+e)),i=Math.max(0,Math.min(At.length-1,this.cell.column+s));this.cell={row:n,column:i},this.wanted=!0,this.look(),this.list.reveal(n)}look(){const e=this.list.shown[this.cell.row]?.part.key;e!==void 0&&this.list.session.view.set({current:e})}choose(e,s){const{view:n}=this.list.session,i=this.list.shown[e]?.part.key;if(i===void 0)return;const a=new Set(n.value.chosen);s??!a.has(i)?a.add(i):a.delete(i),n.set({chosen:a})}element(e){const s=At[e.column]??"name";return this.list.querySelector(`[data-row="${e.row}"] [data-column="${s}"]`)}}const Is=50,ah="#9aa3af";function rh(t){const e=t.parts.reading>0?[]:na(t.draft,t.parts.meshes);return e.length===0?h:l`<section class="left-out" aria-label="Left out">
    <div class="row between">
      <h3>Left out <span class="count">${x(e.length,"part")}</span></h3>
      ${e.length>1?l`<button type="button" class="link small" @click=${()=>wi(t,e)}>Put all back</button>`:h}
    </div>
    ${e.slice(0,Is).map(s=>l`<div class="li">
          ${ot(t.meshes.picture(s,ah,b.value.theme))}
          <div class="cut">${s.name} <span class="count">${at(s.size)}</span></div>
          <button type="button" class="link small" @click=${()=>wi(t,[s])}>Put back</button>
        </div>`)}
    ${e.length>Is?l`<p class="small faint">${x(e.length-Is,"more part")}.</p>`:h}
  </section>`}function wi(t,e){t.edit(s=>{const n=new Set(s.parts.map(i=>i.key));return Vi(s,e.map(i=>sa(i,n)))})}var oh=Object.defineProperty,lh=Object.getOwnPropertyDescriptor,ct=(t,e,s,n)=>{for(var i=n>1?void 0:n?lh(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&oh(e,s,i),i};let st=class extends w{constructor(){super(...arguments),this.label="",this.value=null,this.least=1,this.most=1e6,this.mixed=!1,this.disabled=!1,this.bare=!1,this.tab=0}focus(){this.field?.focus()}render(){const t=(e,s,n,i)=>this.bare?h:l`<button
            type="button"
            class="more-less"
            tabindex="-1"
            aria-label="${s} ${this.label}"
            ?disabled=${this.disabled||i}
            @click=${()=>this.field.stepBy(n,!1)}
          >
            ${g(e)}
          </button>`;return l`<span class="step ${this.bare?"bare":""}">
      ${t("minus","One less:",-1,this.value!==null&&this.value<=this.least)}
      <sp-number
        .label=${this.label}
        .value=${this.value}
        .least=${this.least}
        .most=${this.most}
        .digits=${0}
        .tab=${this.tab}
        ?mixed=${this.mixed}
        ?disabled=${this.disabled}
        classes="in-step"
      ></sp-number>
      ${t("add","One more:",1,!1)}
    </span>`}};ct([m()],st.prototype,"label",2);ct([m({attribute:!1})],st.prototype,"value",2);ct([m({type:Number})],st.prototype,"least",2);ct([m({type:Number})],st.prototype,"most",2);ct([m({type:Boolean})],st.prototype,"mixed",2);ct([m({type:Boolean})],st.prototype,"disabled",2);ct([m({type:Boolean})],st.prototype,"bare",2);ct([m({type:Number})],st.prototype,"tab",2);ct([W("sp-number")],st.prototype,"field",2);st=ct([v("sp-stepper")],st);const ch={info:"info",warn:"warn",bad:"bad"};function uh(t,e,s){return l`<div class="remark ${s.tone}" role="gridcell">
    ${g(ch[s.tone])}
    <span class="cut" title=${s.text}>${s.text}</span>
    ${s.actions.map(n=>l`<button type="button" class="link" @click=${()=>hh(t,e,n)}>${n.text}</button>`)}
  </div>`}function hh(t,{part:e,mesh:s},n){const i=new Set([e.key]);switch(n.do){case"unit":t.edit(a=>Ye(a,i,{unit:n.unit}));break;case"scale":t.edit(a=>Ye(a,i,{scale:n.scale}));break;case"leave_out":t.editWithToast(`${je(e,s)} is left out.`,a=>ds(a,i));break;case"replace":ft(([a])=>a&&t.replaceFile(e.file,a.file),{several:!1});break;case"repairs":t.view.set({current:e.key});break}}function dh(t,e,s){return l`<sp-menu
    label=${`${t}: ${Qs(e)}`}
    buttonClasses="ori"
    .button=${l`${g(za(e))}<span>${Qs(e)}</span>${g("down")}`}
    .content=${()=>l`${ks.map(n=>l`<button
            type="button"
            class="mi"
            role="menuitemradio"
            aria-checked=${n.value===e.kind}
            @click=${()=>s(Na(n.value,e))}
          >
            ${g(n.icon)}<span>${n.text}</span>${n.value===e.kind?g("check"):""}
          </button>`)}`}
  ></sp-menu>`}function ph(t,e,s,n){const{part:i,mesh:a}=e,{current:r,chosen:o}=t.view.value,c=r===i.key,u=o.has(i.key),d=Cc(e,t),p=je(i,a),f=N=>n.row===s&&At[n.column]===N?0:-1,$=(N,K="")=>t.edit(H=>Ye(H,Ro(t.view.value,i.key),N),`${K} ${i.key}`),y=new mh(t,i,p,$),k=_t(e.index),O=e.remarks;return l`<div
    class="pr ${c?"sel":""} ${u?"chosen":""} ${O.length>0?"has":""}"
    role="row"
    aria-rowindex=${s+2}
    aria-selected=${u}
    data-row=${s}
    @pointerdown=${()=>t.view.set({current:i.key})}
  >
    <span role="gridcell" class="c-check" data-column="check" tabindex=${f("check")}>
      ${fs(`Choose ${p}`,u,(N,K)=>fh(t,i.key,N,K.shiftKey),-1)}
    </span>
    ${a?ot(t.meshes.picture(a,k,b.value.theme)):l`<span class="th blank ${O.length>0?"":"reading"}"></span>`}
    <span role="gridcell" class="nm" data-column="name" tabindex=${f("name")}>
      <b class="cut" title=${p}>${p}</b>
      <span class="cut">${d?at(d):a===null&&O.length>0?i.file:"is read …"}</span>
    </span>
    <span role="gridcell" class="num" data-column="count" tabindex=${f("count")}>${y.count(c)}</span>
    <span role="gridcell" class="num" data-column="scale" tabindex=${f("scale")}>${y.scale(c)}</span>
    <span role="gridcell" data-column="stands" tabindex=${f("stands")}>${y.stands(c)}</span>
    <span role="gridcell" class="num hide-s" data-column="gap" tabindex=${f("gap")}>${y.gap(c)}</span>
    <span role="gridcell" class="hide-s" data-column="priority" tabindex=${f("priority")}
      >${y.priority(c)}</span
    >
    <span role="gridcell" class="num" data-column="due" tabindex=${f("due")}>${y.due(c)}</span>
    ${O.map(N=>uh(t,e,N))}
  </div>`}function fh(t,e,s,n){const{chosen:i,current:a}=t.view.value,r=new Set(i),o=t.draft.parts.map(p=>p.key),c=n&&a!==null?o.indexOf(a):-1,u=o.indexOf(e),d=c<0?[e]:o.slice(Math.min(c,u),Math.max(c,u)+1);for(const p of d)s?r.add(p):r.delete(p);t.view.set({chosen:r})}class mh{constructor(e,s,n,i){this.session=e,this.part=s,this.name=n,this.change=i}count(e){return l`<sp-stepper
      label=${`copies of ${this.name}`}
      .value=${this.part.count}
      .tab=${-1}
      ?bare=${!e}
      @value=${s=>this.change({count:s.detail??1},"count")}
    ></sp-stepper>`}scale(e){return e?l`<sp-number
      label=${`Scale of ${this.name}`}
      unit="%"
      classes="s cell"
      .value=${Number((this.part.scale*100).toFixed(4))}
      .least=${0}
      .above=${!0}
      .most=${1e11}
      .digits=${4}
      .tab=${-1}
      @value=${s=>this.change({scale:(s.detail??100)/100},"scale")}
    ></sp-number>`:l`${R(this.part.scale,this.part.scale*100===Math.round(this.part.scale*100)?0:1)}`}stands(e){const{stands:s}=this.part;return e?dh(`${this.name} may stand`,s,n=>this.change({stands:n})):l`<span class="ori">${g(za(s))}${Qs(s)}</span>`}gap(e){const s=ys(this.session.draft,this.session.info).toFixed(1),n=this.part.gap;return e?l`<sp-number
      label=${`Gap of ${this.name}, mm`}
      classes="s cell"
      placeholder=${s}
      .value=${n}
      .least=${0}
      .places=${1}
      .step=${.5}
      .tab=${-1}
      optional
      @value=${i=>this.change({gap:i.detail},"gap")}
    ></sp-number>`:l`<span class=${n===null?"faint":""}>${n===null?s:n.toFixed(1)}</span>`}priority(e){const{priority:s}=this.part,n=Yu(s);if(!e)return l`<span class=${s>0?"b":s===0?"faint":""}>${n}</span>`;const i=as.some(a=>Number(a.value)===s)?[]:[{value:String(s),text:n}];return l`<select
      class="plain"
      tabindex="-1"
      aria-label=${`Priority of ${this.name}`}
      @change=${a=>this.change({priority:Number(a.target.value)})}
    >
      ${[...as,...i].map(a=>l`<option value=${a.value} .selected=${Number(a.value)===s}>${a.text}</option>`)}
    </select>`}due(e){const s=this.part.due;return e?l`<label class="due ${s===null?"faint":""}">
      <span aria-hidden="true">${s===null?"None":ri(s,new Date)}</span>
      <input
        type="date"
        tabindex="-1"
        aria-label=${`Due date of ${this.name}`}
        .value=${s??""}
        @click=${$h}
        @change=${n=>this.change({due:n.target.value||null})}
      />
    </label>`:s===null?h:l`${ri(s,new Date)}`}}function $h(t){try{t.target.showPicker()}catch{}}function bh(t){const{active:e,total:s,done:n,sent:i,bytes:a}=t.uploads.state.value,{reading:r}=t.parts,{problem:o}=t.source.state.value;return e?l`<div class="loading" role="status">
      <div class="row between">
        <span><b>Sending</b> ${n} of ${x(s,"file")} · ${Xe(i)} of ${Xe(a)}</span>
        <button type="button" class="btn s" @click=${()=>t.uploads.stop()}>Stop</button>
      </div>
      ${ms(a>0?i/a:0,"Sent")}
    </div>`:r>0?l`<div class="loading" role="status"><b>Reading</b> ${x(r,"file")} …</div>`:o?l`<div class="loading bad-text" role="alert">${o}</div>`:h}var gh=Object.defineProperty,yh=Object.getOwnPropertyDescriptor,xs=(t,e,s,n)=>{for(var i=n>1?void 0:n?yh(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&gh(e,s,i),i};let Pe=class extends w{constructor(){super(...arguments),this.rows=[],this.top=0,this.height=900,this.wasFinding=!1,this.grid=new ih(this),this.sizes=new ResizeObserver(()=>{this.height=this.scroller.clientHeight,this.requestUpdate()})}stores(){const{session:t}=this;return[t.state,t.view,t.source.state,t.uploads.state,t.meshes.state,t.run.state,b]}get shown(){return this.rows}firstUpdated(){this.sizes.observe(this.scroller)}disconnectedCallback(){super.disconnectedCallback(),this.sizes.disconnect()}updated(t){const e=this.session.view.value.find!==null;e&&!this.wasFinding&&this.findInput?.focus(),this.wasFinding=e,this.grid.settle()}render(){const{session:t}=this,e=Xs(t),{find:s,chosen:n}=t.view.value;this.rows=Sc(e,s);const i=va(this.rows.map(fi),this.top,this.height),a=this.rows.slice(i.first,i.last),r=this.rows.filter(c=>n.has(c.part.key)).length,o=r>0&&r===this.rows.length;return l`${this.head(e)}${bh(t)}${Hu(t,e.length)}
      <div class="scroll" @scroll=${this.scrolled}>
        <div
          class="pt"
          role="grid"
          aria-label="Parts"
          aria-multiselectable="true"
          aria-rowcount=${this.rows.length+1}
          @pointerdown=${{handleEvent:c=>this.grid.pressed(c),capture:!0}}
          @pointerup=${c=>this.grid.released(c)}
          @keydown=${c=>this.grid.key(c)}
          @focusin=${c=>this.grid.focused(c)}
        >
          <div class="pr ph" role="row" aria-rowindex="1">
            <span role="columnheader" class="c-check">
              ${fs("Choose all",o?!0:r>0?"mixed":!1,c=>t.view.set({chosen:new Set(c?this.rows.map(u=>u.part.key):[])}))}
            </span>
            <span role="columnheader" class="c-name two">Part</span>
            <span role="columnheader" class="num">Copies</span>
            <span role="columnheader" class="num">Scale</span>
            <span role="columnheader">May stand</span>
            <span role="columnheader" class="num hide-s">Gap</span>
            <span role="columnheader" class="hide-s">Priority</span>
            <span role="columnheader" class="num">Due</span>
          </div>
          ${Bu(t)}
          <div role="presentation" ${Q({height:`${i.before}px`})}></div>
          ${_n(a,c=>c.part.key,(c,u)=>ph(t,c,i.first+u,this.grid.cell))}
          <div role="presentation" ${Q({height:`${i.after}px`})}></div>
        </div>
        ${e.length===0?this.nothingYet():h}
        ${this.rows.length===0&&e.length>0?l`<p class="none dim">No part has “${s}” in its name.</p>`:h}
        ${rh(t)}
      </div>`}head(t){const{session:e}=this,{find:s,chosen:n}=e.view.value,i=`${D(Oa(t))} · ${$n(Ac(t,e))}`;return l`<div class="head">
      ${n.size>0?l`<h2>${n.size} chosen</h2>
              <span class="count grow cut">what you change in one changes in all</span>
              <button type="button" class="btn s" @click=${()=>this.leaveOut(n)}>Leave out</button>
              ${V("close","Choose none (Esc)",()=>e.view.set({chosen:new Set}),"s")}`:l`<h2 class="nw">${x(t.length,"part")}</h2>
              <span class="count grow cut">${t.length>0?i:""}</span>`}
      ${s===null?V("find","Find a part (/)",()=>e.view.set({find:""}),"s"):l`<span class="in s find">
              ${g("find")}
              <input
                type="search"
                aria-label="Find a part"
                placeholder="Part of the name"
                .value=${s}
                @input=${a=>e.view.set({find:a.target.value})}
                @keydown=${a=>{a.key==="Escape"&&e.view.set({find:null})}}
              />
            </span>`}
      <button type="button" class="btn s" @click=${()=>ft(a=>e.addFiles(a))}>
        ${g("add")}Add parts
      </button>
    </div>`}nothingYet(){const{session:t}=this;return t.parts.reading>0||t.uploads.state.value.active?h:l`<div class="none">
      <h2>No parts yet</h2>
      <p class="dim">Drop files or a folder here, or choose them.</p>
      <div class="row">
        <button type="button" class="btn" @click=${()=>ft(e=>t.addFiles(e))}>
          ${g("file")}Choose files
        </button>
        <button
          type="button"
          class="btn"
          @click=${()=>ft(e=>t.addFiles(e),{folder:!0})}
        >
          ${g("folder")}Choose a folder
        </button>
      </div>
    </div>`}leaveOut(t){const e=t.size===1?"1 part is left out.":`${t.size} parts are left out.`;this.session.editWithToast(e,s=>ds(s,t))}scrolled(){this.top=this.scroller.scrollTop,this.requestUpdate()}reveal(t){const e=this.rows.map(fi),s=e.slice(0,t).reduce((r,o)=>r+o,0),n=32,{scrollTop:i,clientHeight:a}=this.scroller;s<i?this.scroller.scrollTop=s:s+(e[t]??0)>i+a-n&&(this.scroller.scrollTop=s+(e[t]??0)-a+n),this.top=this.scroller.scrollTop,this.requestUpdate()}};xs([m({attribute:!1})],Pe.prototype,"session",2);xs([W(".scroll")],Pe.prototype,"scroller",2);xs([W(".find input")],Pe.prototype,"findInput",2);Pe=xs([v("sp-parts-list")],Pe);const vh=new Set(["tray","printer","trays","gap","wall-gap","open-height","minimise","time-limit","material","unit"]),wh=new Set(["dry-run","json","progress","details","require-all","skip-unusable","job-name"]);function kh(t){return t.filter(e=>e.here&&!vh.has(e.name)&&!wh.has(e.name))}function Ra(t){switch(t.type){case"flag":return"switch";case"word":case"rotations":return"choice";case"integer":case"natural":case"number":return"number";default:return"text"}}function xh(t){return t.type==="flag"&&t.default.startsWith("on")}function Ua(t){return[...t.none_word&&!t.words.includes(t.none_word)?[t.none_word]:[],...t.words]}function _h(t){const e=t.default.split(/[:\s]/)[0]??"";return Ua(t).find(s=>s===e)??null}function Mh(t,e){const s=e.trim();if(s==="")return{value:void 0};if(s===t.none_word||s===t.zero_word)return{value:s};if(Ra(t)!=="number"&&t.type!=="bytes")return{value:s};const n=t.type==="bytes"?Ph(s):ut(s);if(n===null)return{problem:`Takes ${t.values}.`};const i=t.type==="integer"||t.type==="natural"||t.type==="bytes",a=t.least!==void 0&&(t.above?n<=t.least:n<t.least),r=t.most!==void 0&&n>t.most;return a||r||i&&!Number.isInteger(n)?{problem:`Takes ${t.values}.`}:{value:n}}function Ph(t){const e=/^(.*?)([kmgt]?)(i?)b?$/i.exec(t),s=ut(e?.[1]??"");if(s===null||!e)return null;const n="kmgt".indexOf((e[2]??"").toLowerCase())+1;return Math.round(s*(e[3]?1024:1e3)**(e[2]?n:0))}function ki(t){return t==null?"":String(t)}function Ht(t){const e=t.replaceAll("-"," ");return e.charAt(0).toUpperCase()+e.slice(1)}function xi(t){return t.help?`${q(t.line)} ${an(t.help)}`:q(t.line)}function _i(t){return an(t.default)}const Oh={parts:"Parts",tray:"Tray",gap:"Gap",packing:"Packing",result:"Result"};function Sh(t){return Oh[t.toLowerCase()]??Ht(t)}var Ah=Object.defineProperty,Ch=Object.getOwnPropertyDescriptor,_s=(t,e,s,n)=>{for(var i=n>1?void 0:n?Ch(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Ah(e,s,i),i};const Hs="";let Oe=class extends w{constructor(){super(...arguments),this.find="",this.problems=new Map}stores(){return[this.session.state,this.session.view]}render(){const{session:t}=this,e=kh(t.info.options).filter(i=>i.name!=="material-density");if(e.length===0)return h;const{advanced:s}=t.view.value,n=e.filter(i=>this.isSet(i)).length;return l`<section class="sec advanced">
      <button
        type="button"
        class="row fold"
        aria-expanded=${s}
        @click=${()=>t.view.set({advanced:!s})}
      >
        ${g(s?"down":"right")}<span class="b grow">Advanced</span>
        <span class="count">${n===0?"all at their defaults":`${x(n,"option")} set`}</span>
      </button>
      ${s?this.all(e,n):h}
    </section>`}isSet(t){return Xn(this.session.draft,t.name)!==void 0&&!(t.name==="height-at"&&this.session.draft.goal==="lowest")}all(t,e){const s=this.find.trim().toLowerCase(),n=t.filter(a=>`${Ht(a.name)} ${xi(a)}`.toLowerCase().includes(s)),i=[...new Set(n.map(a=>a.group))];return l`<div class="row">
        <span class="in s find grow">
          ${g("find")}
          <input
            type="search"
            aria-label="Find an option"
            placeholder="Find an option"
            .value=${this.find}
            @input=${a=>{this.find=a.target.value}}
          />
        </span>
        ${e>0?l`<button type="button" class="link small" @click=${()=>this.reset(t)}>All to defaults</button>`:h}
      </div>
      ${i.map(a=>l`<h4>${Sh(a)}</h4>
            ${n.filter(r=>r.group===a).map(r=>this.option(r))}`)}
      ${n.length===0?l`<p class="small dim">No option says “${this.find}”.</p>`:h}`}reset(t){this.problems.clear(),this.session.editWithToast("Options are at their defaults.",e=>t.filter(s=>this.isSet(s)).reduce((s,n)=>jt(s,n.name,void 0),e))}set(t,e){this.session.edit(s=>jt(s,t.name,e),`option ${t.name}`)}option(t){const e=Xn(this.session.draft,t.name),s=this.problems.get(t.name);return l`<div class="field option ${this.isSet(t)?"set":""}">
      <span class=${this.isSet(t)?"b":"dim"}>${Ht(t.name)}</span>
      ${this.control(t,e)} ${s?l`<span class="range" role="alert">${s}</span>`:h}
      <span class="hint">${xi(t)}</span>
    </div>`}control(t,e){switch(Ra(t)){case"switch":{const s=xh(t),n=typeof e=="boolean"?e:s;return yn(Ht(t.name),n,i=>this.set(t,i===s?void 0:i))}case"choice":return this.choice(t,e);default:return this.typed(t,e)}}choice(t,e){const s=ki(e),n=Ua(t),i=s!==""&&!n.includes(s)?[s]:[],a=_h(t);return Gt(Ht(t.name),[{value:Hs,text:a?`${a} (default)`:t.default?`${_i(t)}`:"default"},...[...n,...i].filter(r=>r!==a).map(r=>({value:r,text:r}))],s===a?Hs:s,r=>this.set(t,r===Hs?void 0:r),"n wider")}typed(t,e){const s=[t.none_word,t.zero_word].filter(i=>i!==""),n=`words-${t.name}`;return l`<span class="in n wider ${this.problems.has(t.name)?"wrong":""}"
      ><input
        type="text"
        autocomplete="off"
        spellcheck="false"
        list=${s.length>0?n:h}
        aria-label=${Ht(t.name)}
        placeholder=${_i(t)||"none"}
        .value=${ki(e)}
        @change=${i=>this.read(t,i.target)} />${s.length>0?l`<datalist id=${n}>${s.map(i=>l`<option value=${i}></option>`)}</datalist>`:h}</span
    >`}read(t,e){const s=Mh(t,e.value);"problem"in s?this.problems.set(t.name,s.problem):(this.problems.delete(t.name),this.set(t,s.value)),this.requestUpdate()}};_s([m({attribute:!1})],Oe.prototype,"session",2);_s([P()],Oe.prototype,"find",2);_s([P()],Oe.prototype,"problems",2);Oe=_s([v("sp-advanced")],Oe);function Th(t){const{draft:e}=t,s=Ce(e);return l`<div class="field">
      <span class="dim">Keep-out zones</span>
      <button
        type="button"
        class="link"
        ?disabled=${s}
        title=${s?"Not without a ceiling, nor for the least box":"Room that stays empty"}
        @click=${()=>t.edit(n=>Yr(n,Eh(t)))}
      >
        Add
      </button>
    </div>
    ${e.keepOut.map((n,i)=>jh(t,n,i))}`}function Eh(t){const[e,s,n]=xt(t.draft,t.info,t.parts.meshes)??[100,100,100];return{box:[[0,0,0],[Math.round(e/10),Math.round(s/10),n]]}}function jh(t,e,s){const n=()=>t.editWithToast("The keep-out zone is removed.",i=>({...i,keepOut:i.keepOut.filter((a,r)=>r!==s)}));return l`<div class="zone">
    <div class="row between">
      <span class="small dim">${"mesh"in e?e.mesh:`Zone ${s+1}: from, to (mm)`}</span>
      ${V("close",`Remove keep-out zone ${s+1}`,n,"s")}
    </div>
    ${"box"in e?l`${Mi(t,e.box,s,0)}${Mi(t,e.box,s,1)}`:h}
  </div>`}function Mi(t,e,s,n){const i=(a,r)=>t.edit(o=>{const c=[...e[n]];c[a]=r??0;const u=n===0?[c,e[1]]:[e[0],c];return{...o,keepOut:o.keepOut.map((d,p)=>p===s?{box:u}:d)}},`zone ${s} ${n} ${a}`);return l`<div class="thirds" role="group" aria-label=${n===0?"From":"To"}>
    ${["X","Y","Z"].map((a,r)=>l`<sp-number
          label=${`${n===0?"From":"To"} ${a}, mm`}
          classes="s third"
          .value=${e[n][r]??0}
          @value=${o=>i(r,o.detail)}
        ></sp-number>`)}
  </div>`}function Lh(t){const{draft:e}=t;return l`${ee("Tray",[{value:"printer",text:"Printer",disabled:t.info.printers.length===0},{value:"box",text:"Box"},{value:"mesh",text:"Mesh"}],e.tray.kind,s=>t.edit(n=>{const i=qs(n,Dh(t,s));return n.tray.kind!=="printer"||s==="printer"?i:{...i,gap:ys(n,t.info),wallGap:wn(n,t.info)}}))}
  ${e.tray.kind==="printer"?Nh(t):e.tray.kind==="box"?Fh(t,e.tray.size):Ih(t)}
  ${e.tray.kind==="mesh"?h:Rh(t)} ${Uh(t)}`}function Dh(t,e){const{draft:s,info:n,parts:i}=t;return s.tray.kind===e?s.tray:e==="printer"?ea(n)??s.tray:e==="box"?{kind:e,size:zh(xt(s,n,i.meshes)??Gi)}:{kind:e,file:null,is:null,unit:null,transform:null}}function zh(t){const e=s=>Math.ceil(s*10-1e-6)/10;return[e(t[0]),e(t[1]),e(t[2])]}function Nh(t){const{draft:e,info:s}=t,n=e.tray.kind==="printer"?e.tray.name:"",i=xt(e,s,[]),a=s.printers.some(r=>r.name===n);return l`${Gt("Printer",[...s.printers.map(r=>({value:r.name,text:r.title.charAt(0).toUpperCase()+r.title.slice(1)})),...a?[]:[{value:n,text:`${n}: not known here`}]],n,r=>{Qt("printer",r),t.edit(o=>({...o,tray:{kind:"printer",name:r},gap:null,wallGap:null}))},"wide")}
    <div class="field"><span class="dim">Size</span><span>${i?at(i):"unknown"}</span></div>`}function Fh(t,e){const s=(n,i)=>l`<sp-number
      label=${`${i}, mm`}
      classes="third"
      .value=${e[n]}
      .least=${0}
      above
      .most=${1e5}
      ?disabled=${n===2&&t.draft.openHeight}
      @value=${a=>{const r=[...e];r[n]=a.detail??e[n],t.edit(o=>({...o,tray:{kind:"box",size:r}}),`box ${n}`)}}
    ></sp-number>`;return l`<div class="thirds" role="group" aria-label="Size of the box, mm">
    ${s(0,"Length")}<span class="faint">×</span>${s(1,"Width")}<span class="faint">×</span>${s(2,"Height")}
    <span class="faint">mm</span>
  </div>`}function Rh(t){const{draft:e}=t,s=e.keepOut.length===0;return l`<div class="field">
    <span class="dim">No ceiling</span>
    ${yn("No ceiling: as low as can be on the base",e.openHeight,n=>t.edit(i=>({...i,openHeight:n})),!s)}
    ${e.openHeight?l`<span class="hint">As low as can be on the base, however high that is.</span>`:s?h:l`<span class="hint">Not with keep-out zones.</span>`}
  </div>`}function Uh(t){const{draft:e}=t;if(Ce(e))return l`<div class="field">
      <span class="dim">Trays</span><span>1</span>
      <span class="hint">${e.openHeight?"Without a ceiling one tray holds all.":"The least box holds all."}</span>
    </div>`;const s=e.trays,n=s==="all";return l`<div class="field">
    <span class="dim">Trays</span>
    <span class="row">
      ${n?h:l`<sp-stepper
              label="trays"
              .value=${s}
              .most=${1e3}
              @value=${i=>t.edit(a=>({...a,trays:i.detail??1}),"trays")}
            ></sp-stepper>`}
      <button
        type="button"
        class="btn s ${n?"on":""}"
        aria-pressed=${n}
        title="As many trays as it takes"
        @click=${()=>t.edit(i=>({...i,trays:n?1:"all"}))}
      >
        As many as needed
      </button>
    </span>
  </div>`}function Ih(t){const{draft:e,parts:s}=t,n=e.tray;if(n.kind!=="mesh")return l``;const i=[...new Set(s.meshes.map(o=>o.file))],a=xt(e,t.info,s.meshes),r=o=>t.edit(c=>{const u=new Set(c.parts.filter(d=>d.file===o).map(d=>d.key));return qs(ds(c,u),{...n,file:o})});return l`${i.length>0?Gt("Mesh to fill",[...n.file!==null&&!i.includes(n.file)?[{value:n.file,text:`${n.file}: not there`}]:[],...i.map(o=>({value:o,text:o}))],n.file,r,"wide"):l`<p class="faint small">A closed mesh that is filled instead of a box.</p>`}
    <button
      type="button"
      class="btn s"
      @click=${()=>ft(([o])=>{o&&(t.addFiles([o]),r(o.file.name))},{several:!1,accept:".stl,.3mf,.obj,.ply,.off"})}
    >
      Choose a file
    </button>
    <div class="field"><span class="dim">Size</span><span>${a?at(a):"–"}</span></div>
    <div class="field">
      <span class="dim">Filled is</span>
      ${Gt("What of the mesh is filled",[{value:"auto",text:"by its shape"},{value:"solid",text:"its own volume"},{value:"vessel",text:"what it holds"}],n.is??"auto",o=>t.edit(c=>qs(c,{...n,is:o==="auto"?null:o})),"n wider")}
    </div>
    <label class="row">
      ${fs("Its walls are really there",e.physical,o=>t.edit(c=>({...c,physical:o})))}
      <span>Its walls are really there</span>
    </label>
    ${e.physical?l`<p class="faint small">Copies leave over the top, which is open.</p>`:h}`}var Hh=Object.defineProperty,Bh=Object.getOwnPropertyDescriptor,Ia=(t,e,s,n)=>{for(var i=n>1?void 0:n?Bh(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Hh(e,s,i),i};const qh={lowest:"Places every copy as low as it goes, so the print is short.",fill:"Fills each tray as densely as it goes before the next; the last is packed low.",box:"Seeks the smallest box that holds all copies, on a base up to the tray’s."};let en=class extends w{stores(){return[this.session.state,this.session.source.state,b]}render(){const{session:t}=this;return l`<div class="head"><h2 class="grow">Build settings</h2></div>
      <div class="scroll">
        <section class="sec stack">
          <h3>Tray</h3>
          ${Lh(t)} ${Th(t)}
        </section>
        ${this.gaps()}${this.goal()}${this.time()}${this.material()}
        <sp-advanced .session=${t}></sp-advanced>
      </div>`}edit(t,e=""){this.session.edit(s=>({...s,...t}),e)}gaps(){const{draft:t,info:e}=this.session,s=gs(t,e),n=(i,a,r)=>i!==null&&a!==void 0&&i!==a?l`<span class="hint"
            >The printer’s usual is ${ve(a)}.
            <button type="button" class="link" @click=${()=>this.edit(r)}>Use it</button></span
          >`:h;return l`<section class="sec stack">
      <h3>Gap</h3>
      <div class="field">
        <span class="dim">Between copies</span>
        <sp-number
          label="Gap between copies"
          unit="mm"
          .value=${ys(t,e)}
          .least=${0}
          .step=${.5}
          .places=${1}
          @value=${i=>this.edit({gap:i.detail},"gap")}
        ></sp-number>
        ${n(t.gap,s?.gap,{gap:null})}
      </div>
      <div class="field">
        <span class="dim">To the walls</span>
        <sp-number
          label="Gap to the walls"
          unit="mm"
          .value=${wn(t,e)}
          .least=${0}
          .step=${.5}
          .places=${1}
          @value=${i=>this.edit({wallGap:i.detail},"wall gap")}
        ></sp-number>
        ${n(t.wallGap,s?.wall_gap,{wallGap:null})}
      </div>
    </section>`}goal(){const{draft:t}=this.session,e=Ji(t);return l`<section class="sec stack">
      <h3>Goal</h3>
      ${ee("Goal",[{value:"lowest",text:"Lowest"},{value:"fill",text:"Fill tray"},{value:"box",text:"Least box",disabled:!e,...e?{}:{title:"Not with a mesh to fill, nor with keep-out zones"}}],t.goal,s=>this.edit({goal:s}))}
      <p class="faint small">${qh[t.goal]}</p>
    </section>`}time(){const{draft:t,info:e}=this.session,s=e.limits.time_limit,n=t.options.improve==="rest";return l`<section class="sec stack">
      <div class="field">
        <span class="b">Time limit</span>
        <sp-number
          label="Time limit, minutes"
          unit="min"
          optional
          placeholder="none"
          .value=${t.timeLimit===null?null:t.timeLimit/60}
          .least=${0}
          above
          .most=${s===null?Number.POSITIVE_INFINITY:s/60}
          @value=${i=>this.edit({timeLimit:i.detail===null?null:i.detail*60},"time limit")}
        ></sp-number>
      </div>
      ${t.timeLimit===null?l`<p class="faint small">Packs until it is done. With a limit, the best packing by then is kept.</p>`:l`<label class="row">
                ${fs("Use all of the time to pack better",n,i=>this.session.edit(a=>jt(a,"improve",i?"rest":void 0)))}
                <span>Use all of it to pack better</span>
              </label>
              <p class="faint small">The best packing so far is kept.</p>`}
    </section>`}material(){const{draft:t,info:e}=this.session,s=t.options["material-density"],n=e.options.some(i=>i.name==="material-density"&&i.here);return l`<section class="sec stack">
      <h3>Material</h3>
      <label class="field">
        <span class="dim">Name</span>
        <span class="in n wider"
          ><input
            type="text"
            maxlength="100"
            aria-label="Material"
            placeholder="PA 12"
            .value=${t.material}
            @change=${i=>this.edit({material:i.target.value.trim()})}
        /></span>
      </label>
      ${n?l`<div class="field">
              <span class="dim">Density</span>
              <sp-number
                label="Density of the material, g/cm³"
                unit="g/cm³"
                classes="n wider"
                optional
                .value=${typeof s=="number"?s:null}
                .least=${0}
                above
                .step=${.01}
                .digits=${3}
                @value=${i=>this.session.edit(a=>jt(a,"material-density",i.detail??void 0),"density")}
              ></sp-number>
              <span class="hint">The report then has masses.</span>
            </div>`:h}
    </section>`}};Ia([m({attribute:!1})],en.prototype,"session",2);en=Ia([v("sp-settings")],en);var Wh=Object.defineProperty,Kh=Object.getOwnPropertyDescriptor,Ms=(t,e,s,n)=>{for(var i=n>1?void 0:n?Kh(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Wh(e,s,i),i};let Se=class extends w{constructor(){super(...arguments),this.over=0,this.drawer="left",this.release=null,this.keys=[{keys:["Ctrl+Enter"],does:"pack",run:()=>void this.session.pack()},{keys:["Ctrl+Z"],does:"undo",run:()=>this.session.undo()},{keys:["Ctrl+Shift+Z","Ctrl+Y"],does:"redo",run:()=>this.session.redo()},{keys:["/"],does:"find a part",run:()=>this.session.view.set({find:this.session.view.value.find??""})},{keys:["Del"],does:"leave out the chosen parts",run:()=>this.leaveOut()},{keys:["Esc"],does:"let go",run:()=>this.session.view.set({chosen:new Set,find:null})}],this.dragOver=t=>{const e=ja(t);e===0||this.session.locked||(t.preventDefault(),this.over=e)},this.dragLeave=t=>{t.relatedTarget===null&&(this.over=0)},this.drop=t=>{t.preventDefault(),this.over=0,!this.session.locked&&La(t).then(e=>this.session.addFiles(e))}}stores(){return[this.session.run.state]}connectedCallback(){super.connectedCallback(),this.release=gn(this.keys),this.session.locked||this.session.saver.look(),addEventListener("dragover",this.dragOver),addEventListener("dragleave",this.dragLeave),addEventListener("drop",this.drop)}disconnectedCallback(){super.disconnectedCallback(),this.release?.(),removeEventListener("dragover",this.dragOver),removeEventListener("dragleave",this.dragLeave),removeEventListener("drop",this.drop)}render(){const{session:t}=this,e=t.locked;return l`${e?this.lockedBanner():h}
      <main class="main parts" data-drawer=${this.drawer??h}>
        <h1 class="out">${t.job.name}: parts</h1>
        <aside class="side left" aria-label="Parts" ?inert=${e}>
          <sp-parts-list .session=${t}></sp-parts-list>
        </aside>
        <sp-divider property="--parts" side="left" label="Width of the list" least="480"></sp-divider>
        <sp-part-preview .session=${t} ?inert=${e}></sp-part-preview>
        <sp-divider property="--right" side="right" label="Width of the settings" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Settings" ?inert=${e}>
          <sp-settings .session=${t}></sp-settings>
        </aside>
        <div class="drawers">
          ${this.drawerButton("left","Parts")}${this.drawerButton("right","Settings")}
        </div>
        ${this.over>0?l`<div class="over-all"><h2>Drop to add ${x(this.over,"file")}</h2></div>`:h}
      </main>
      <sp-dock .session=${t}></sp-dock>`}lockedBanner(){return l`<div class="banner info" role="status">
      ${g("clock")}
      <span class="grow"><b>This job is being packed.</b> Parts and settings can be changed once it is done or stopped.</span>
      <a class="btn s" href=${`#/job/${this.session.id}/build`}>Watch it</a>
      <button type="button" class="btn s" @click=${()=>this.session.stop()}>Stop it</button>
    </div>`}drawerButton(t,e){return l`<button
      type="button"
      class="btn"
      aria-pressed=${this.drawer===t}
      @click=${()=>{this.drawer=this.drawer===t?null:t}}
    >
      ${g(t==="left"?"list":"settings")}${e}
    </button>`}leaveOut(){const{chosen:t,current:e}=this.session.view.value,s=t.size>0?t:new Set(e===null?[]:[e]);if(s.size===0)return;const n=s.size===1?"1 part is left out.":`${s.size} parts are left out.`;this.session.editWithToast(n,i=>ds(i,s))}};Ms([m({attribute:!1})],Se.prototype,"session",2);Ms([P()],Se.prototype,"over",2);Ms([P()],Se.prototype,"drawer",2);Se=Ms([v("sp-parts")],Se);function Ha(t){return t==="localhost"||t==="[::1]"||/^127\./.test(t)}function Gh(t){return Ha(t)?"Files stay on this computer.":`Files go to ${t}, and nowhere else.`}const Jh=t=>Ha(t)?"on this computer":`on ${t}`,Vh="250,392 20,300 142,228 354,298",Yh="258,96 0,40 138,-2 374,38",Zh=l`<svg class="empty-tray" viewBox="-8 -14 392 418" aria-hidden="true">
  <polygon class="floor" points=${Vh} />
  <path class="far" d="M142 228L138 -2" />
  <path d="M250 392L258 96M20 300L0 40M354 298L374 38" />
  <path d="M20 300L250 392L354 298" />
  <path class="far" d="M20 300L142 228L354 298" />
  <polygon points=${Yh} />
</svg>`;var Xh=Object.defineProperty,Qh=Object.getOwnPropertyDescriptor,Ps=(t,e,s,n)=>{for(var i=n>1?void 0:n?Qh(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&Xh(e,s,i),i};let Ae=class extends w{constructor(){super(...arguments),this.second=!1,this.over=0,this.busy=!1,this.dragOver=t=>{const e=ja(t);e!==0&&(t.preventDefault(),this.over=e)},this.dragLeave=t=>{t.relatedTarget===null&&(this.over=0)},this.drop=t=>{t.preventDefault(),this.over=0,La(t).then(e=>this.take(e))}}stores(){return[b]}connectedCallback(){super.connectedCallback(),addEventListener("dragover",this.dragOver),addEventListener("dragleave",this.dragLeave),addEventListener("drop",this.drop)}disconnectedCallback(){super.disconnectedCallback(),removeEventListener("dragover",this.dragOver),removeEventListener("dragleave",this.dragLeave),removeEventListener("drop",this.drop)}render(){const t=b.value.info?.samples??!1;return l`<div class="drop ${this.over>0?"over":""}">
      ${Zh}
      <h2>${this.over>0?this.dropText():"Drop files or a folder here"}</h2>
      <p class="dim">STL, 3MF, OBJ, PLY, OFF, or a job or set file with its meshes</p>
      <div class="row wrap">
        <button
          type="button"
          class="btn l ${this.second?"":"primary"}"
          ?disabled=${this.busy}
          @click=${()=>ft(e=>this.take(e))}
        >
          ${this.busy?ht:g("file")}Choose files
        </button>
        <button
          type="button"
          class="btn l"
          ?disabled=${this.busy}
          @click=${()=>ft(e=>this.take(e),{folder:!0})}
        >
          ${g("folder")}Choose a folder
        </button>
        ${t?l`<button
                type="button"
                class="btn l ghost accent"
                ?disabled=${this.busy}
                @click=${()=>this.begin(Ul())}
              >
                Try the sample
              </button>`:h}
      </div>
    </div>`}dropText(){return this.over===1?"Drop to begin":`Drop to add ${x(this.over,"file")}`}take(t){t.length>0&&this.begin(Rl(t))}async begin(t){this.busy=!0,await t,this.busy=!1}};Ps([m({type:Boolean})],Ae.prototype,"second",2);Ps([P()],Ae.prototype,"over",2);Ps([P()],Ae.prototype,"busy",2);Ae=Ps([v("sp-drop")],Ae);function td(t){const e=Jt(t),s=t.has_packing?"Nothing is lost: the best packing so far is saved.":"Nothing was placed by then. It goes on from where it was.";return l`<article class="card interrupted" aria-label="Interrupted job">
    <span class="pic">${ot(t.has_picture?Ei(t.id):null,"shot")}</span>
    <div>
      <div class="row between">
        <h2 class="cut">“${t.name}” was interrupted</h2>
        ${we("warn",Ml(t))}
      </div>
      <p class="dim">The computer or the program stopped while it was packing. ${s}</p>
      ${t.has_packing?l`<p>
              ${la(t)}${e?.tone==="ok"?l` · <span class="ok-text">comes apart: checked</span>`:h}
            </p>`:h}
      <div class="row">
        <button type="button" class="btn primary" @click=${()=>ed(t)}>Continue packing</button>
        ${t.has_packing?l`<a class="btn" href=${`#/job/${t.id}/build`}>Open what is there</a>`:l`<a class="btn" href=${`#/job/${t.id}/parts`}>Open the parts</a>`}
        <button type="button" class="btn ghost" @click=${()=>Fl(t)}>Dismiss</button>
      </div>
    </div>
  </article>`}async function ed(t){await Y(()=>M.start(t.id))&&tt({page:"job",id:t.id,step:"build"})}function sd(t,e){const s=ts(t),n=t.has_packing||J(t)||t.status==="failed"?"build":"parts",i=J(t)?"now":wl(new Date(t.changed),e);return l`<li class="job">
    <a class="whole" href=${Ke({page:"job",id:t.id,step:n})} aria-label=${`Open ${t.name}`}></a>
    <span class="pic">${ot(t.has_picture?Ei(t.id):null,"shot")}</span>
    <div class="cut">
      <div class="b cut">${t.name}</div>
      <div class="dim small cut">${_l(t)}</div>
      <div class="faint small cut">${la(t)}</div>
    </div>
    <div class="num">
      ${we(s.tone,s.text)}
      <div class="faint small when">${i}</div>
      <div class="acts">
        <a class="btn s ghost accent" href=${Ke({page:"job",id:t.id,step:n})} aria-label=${`Open ${t.name}`}>
          Open
        </a>
        ${V("copy",`Copy ${t.name}`,()=>ha(t.id,t.name),"s")}
        ${V("trash",`Delete ${t.name}`,()=>ca(t),"s")}
      </div>
    </div>
  </li>`}var nd=Object.defineProperty,id=Object.getOwnPropertyDescriptor,Ba=(t,e,s,n)=>{for(var i=n>1?void 0:n?id(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&nd(e,s,i),i};let sn=class extends w{stores(){return[U]}render(){const{jobs:t,total:e,bytes:s,find:n,all:i,going:a}=U.value,r=(t??[]).filter(o=>!a.has(o.id));return l`<section class="recent" aria-labelledby="recent-jobs">
      <div class="row between">
        <h2 id="recent-jobs">Recent jobs</h2>
        ${n===null?this.findButton(e):this.findField(n)}
      </div>
      <p class="dim lead">
        ${t===null?"Looking for jobs …":e===0?"No jobs yet.":this.summary(e,s)}
      </p>
      ${r.length>0?this.list(r):this.none(n,e)}
      <div class="row between foot">
        ${n===null&&e>r.length&&!i?l`<button type="button" class="link small" @click=${()=>li(!0)}>
                Show all ${x(e,"job")}
              </button>`:n===null&&i?l`<button type="button" class="link small" @click=${()=>li(!1)}>Show the newest</button>`:l`<span></span>`}
        ${e>0?l`<span class="faint small">Jobs go on when this page is closed.</span>`:h}
      </div>
    </section>`}summary(t,e){return`${x(t,"job")} ${Jh(location.hostname)}, ${Xe(e)}.`}list(t){const e=new Date;return l`<ul class="card jobs" role="list">
      ${_n(t,s=>s.id,s=>sd(s,e))}
    </ul>`}none(t,e){return t!==null&&t!==""&&U.value.jobs?l`<p class="none dim">No job has “${t}” in its name.</p>`:e>0||U.value.jobs===null?h:l`<p class="none dim">What you pack is kept here, with its parts and settings, until you delete it.</p>`}findButton(t){return t<2?h:l`<button
      type="button"
      class="btn s ghost"
      @click=${()=>{Ue(""),this.updateComplete.then(()=>this.input?.focus())}}
    >
      ${g("find")}Find
    </button>`}findField(t){return l`<span class="in s find">
      ${g("find")}
      <input
        type="search"
        aria-label="Find a job by its name"
        placeholder="Part of the name"
        .value=${t}
        @input=${e=>Ue(e.target.value)}
        @keydown=${e=>{e.key==="Escape"&&Ue(null)}}
        @blur=${()=>{t===""&&Ue(null)}}
      />
    </span>`}};Ba([W("input")],sn.prototype,"input",2);sn=Ba([v("sp-recent")],sn);var ad=Object.getOwnPropertyDescriptor,rd=(t,e,s,n)=>{for(var i=n>1?void 0:n?ad(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=r(i)||i);return i};let Pi=class extends w{constructor(){super(...arguments),this.stop=null}stores(){return[b,U]}connectedCallback(){super.connectedCallback(),this.stop=zl()}disconnectedCallback(){super.disconnectedCallback(),this.stop?.()}render(){const t=Nl(U.value)[0];return l`<main class="start">
      <section class="begin" aria-labelledby="new-build">
        <h1 id="new-build">New build</h1>
        <p class="dim lead">Bring the parts, choose the printer, press Pack. ${Gh(location.hostname)}</p>
        ${t?td(t):h}
        <sp-drop ?second=${t!==void 0}></sp-drop>
      </section>
      <sp-recent></sp-recent>
    </main>`}};Pi=rd([v("sp-start")],Pi);var od=Object.defineProperty,ld=Object.getOwnPropertyDescriptor,qa=(t,e,s,n)=>{for(var i=n>1?void 0:n?ld(e,s):e,a=t.length-1,r;a>=0;a--)(r=t[a])&&(i=(n?r(e,s,i):r(i))||i);return n&&i&&od(e,s,i),i};const cd=3e3;let nn=class extends w{constructor(){super(...arguments),this.ready=!1,this.route=null,this.retry=0,this.learning=!1}stores(){const t=F.value.session;return t?[b,F,t.run.state]:[b,F]}connectedCallback(){super.connectedCallback(),ll()}updated(t){if(!this.ready)return;if(b.value.tokenWanted){this.route=null;return}b.value.info||this.learn(),this.route!==b.value.route&&this.follow(b.value.route),b.value.connected||this.askSoon();const e=F.value.session;document.title=e&&b.value.route.page==="job"?`${e.job.name} · spectralpack`:"spectralpack"}async learn(){if(!this.learning){this.learning=!0;try{b.set({info:await M.info()})}catch{}finally{this.learning=!1}}}follow(t){const e=this.route;this.route=t,t.page==="start"?ra():(e?.page!=="job"||e.id!==t.id||!F.value.session)&&Js(t.id)}askSoon(){clearTimeout(this.retry),this.retry=window.setTimeout(async()=>{try{b.set({info:await M.info()}),await F.value.session?.run.refresh(),!F.value.session&&this.route?.page==="job"&&Js(this.route.id)}catch{this.askSoon()}},cd)}render(){const{tokenWanted:t,dialog:e}=b.value;return this.ready?t?l`<sp-token></sp-token>`:l`<div class="app">
        <sp-top-bar></sp-top-bar>
        <div class="page">${this.banners()}${this.page()}</div>
      </div>
      <sp-toast></sp-toast>
      <div class="out" role="status" aria-live="polite">${b.value.announcement}</div>
      ${e==="help"?l`<sp-help></sp-help>`:h}`:h}banners(){const{connected:t,problem:e}=b.value;return l`${t?h:l`<div class="banner warn" role="alert">
            ${g("warn")}
            <span class="grow"><b>No answer from the server.</b> Jobs that run go on; the page asks again by itself.</span>
          </div>`}${e&&t?l`<div class="banner bad" role="alert">
            ${g("bad")}<span class="grow">${e}</span>
            <button type="button" class="btn s" @click=${()=>me(null)}>Close</button>
          </div>`:h}`}page(){const{route:t}=b.value;if(t.page==="start")return l`<sp-start></sp-start>`;const{session:e,problem:s}=F.value;return e&&e.id===t.id?this.jobPage(e,t.step):s===null?l`<main class="empty" aria-busy="true"></main>`:l`<main class="empty">
      <h2>This job cannot be opened</h2>
      <p class="dim">${s}</p>
      <button type="button" class="btn" @click=${()=>tt({page:"start"})}>All jobs</button>
    </main>`}jobPage(t,e){const s=J(t.job)||t.job.status!=="new"||t.job.has_packing;return l`${Fr(t,e==="build"&&s?l`<sp-build .session=${t}></sp-build>`:l`<sp-parts .session=${t}></sp-parts>`)}`}};qa([m({type:Boolean})],nn.prototype,"ready",2);nn=qa([v("sp-app")],nn);const Oi=ir(location,history);sr({reached:t=>b.set({connected:t}),tokenWanted:()=>b.set({tokenWanted:!0})});lr();async function ud(){if(Oi!==null)try{await ji(Oi),b.set({tokenWanted:!1})}catch(e){b.value.tokenWanted||me(Tt(e))}const t=()=>b.set({route:rr(location.hash)});addEventListener("hashchange",t),t(),document.querySelector("sp-app")?.setAttribute("ready","")}ud();export{$d as a,pc as b,md as c,_t as p,ue as r};
