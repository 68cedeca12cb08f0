const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./tray_view-DwAAxWLF.js","./section-BqabMN7-.js","./stage-DkIH-HGQ.js","./pieces-C94rT9YN.js","./pick-Rb7rrXKJ.js","./part_view-BPK0-W8h.js","./thumbnails-37d3PiEK.js","./clash-Cntwv0wL.js","./sweep-Eneu3xcy.js"])))=>i.map(i=>d[i]);
const ll=/\{[^{}]+\}/g,cl=()=>typeof process=="object"&&Number.parseInt(process?.versions?.node?.substring(0,2))>=18&&process.versions.undici;function hl(){return Math.random().toString(36).slice(2,11)}function ul(e){let{baseUrl:t="",Request:s=globalThis.Request,fetch:n=globalThis.fetch,querySerializer:i,bodySerializer:a,pathSerializer:r,headers:o,requestInitExt:c=void 0,...h}={...e};c=cl()?c:void 0,t=Hi(t);const u=[];async function p(f,m){const{baseUrl:v,fetch:y=n,Request:M=s,headers:A,params:N={},parseAs:ot="json",querySerializer:W,bodySerializer:Fi=a??pl,pathSerializer:il,body:Ii,middleware:al=[],...gn}=m||{};let $n=t;v&&($n=Hi(v)??t);let bn=typeof i=="function"?i:Ui(i);W&&(bn=typeof W=="function"?W:Ui({...typeof i=="object"?i:{},...W}));const zi=il||r||dl,vn=Ii===void 0?void 0:Fi(Ii,Bi(o,A,N.header)),rl=Bi(vn===void 0||vn instanceof FormData?{}:{"Content-Type":"application/json"},o,A,N.header),kt=[...u,...al],ol={redirect:"follow",...h,...gn,body:vn,headers:rl};let ds,ps,xt=new M(fl(f,{baseUrl:$n,params:N,querySerializer:bn,pathSerializer:zi}),ol),F;for(const Q in gn)Q in xt||(xt[Q]=gn[Q]);if(kt.length){ds=hl(),ps=Object.freeze({baseUrl:$n,fetch:y,parseAs:ot,querySerializer:bn,bodySerializer:Fi,pathSerializer:zi});for(const Q of kt)if(Q&&typeof Q=="object"&&typeof Q.onRequest=="function"){const I=await Q.onRequest({request:xt,schemaPath:f,params:N,options:ps,id:ds});if(I)if(I instanceof M)xt=I;else if(I instanceof Response){F=I;break}else throw new Error("onRequest: must return new Request() or Response() when modifying the request")}}if(!F){try{F=await y(xt,c)}catch(Q){let I=Q;if(kt.length)for(let Et=kt.length-1;Et>=0;Et--){const fs=kt[Et];if(fs&&typeof fs=="object"&&typeof fs.onError=="function"){const ke=await fs.onError({request:xt,error:I,schemaPath:f,params:N,options:ps,id:ds});if(ke){if(ke instanceof Response){I=void 0,F=ke;break}if(ke instanceof Error){I=ke;continue}throw new Error("onError: must return new Response() or instance of Error")}}}if(I)throw I}if(kt.length)for(let Q=kt.length-1;Q>=0;Q--){const I=kt[Q];if(I&&typeof I=="object"&&typeof I.onResponse=="function"){const Et=await I.onResponse({request:xt,response:F,schemaPath:f,params:N,options:ps,id:ds});if(Et){if(!(Et instanceof Response))throw new Error("onResponse: must return new Response() when modifying the response");F=Et}}}}const Ri=F.headers.get("Content-Length");if(F.status===204||xt.method==="HEAD"||Ri==="0"&&!F.headers.get("Transfer-Encoding")?.includes("chunked"))return F.ok?{data:void 0,response:F}:{error:void 0,response:F};if(F.ok)return{data:await(async()=>{if(ot==="stream")return F.body;if(ot==="json"&&!Ri){const I=await F.text();return I?JSON.parse(I):void 0}return await F[ot]()})(),response:F};let yn=await F.text();try{yn=JSON.parse(yn)}catch{}return{error:yn,response:F}}return{request(f,m,v){return p(m,{...v,method:f.toUpperCase()})},GET(f,m){return p(f,{...m,method:"GET"})},PUT(f,m){return p(f,{...m,method:"PUT"})},POST(f,m){return p(f,{...m,method:"POST"})},DELETE(f,m){return p(f,{...m,method:"DELETE"})},OPTIONS(f,m){return p(f,{...m,method:"OPTIONS"})},HEAD(f,m){return p(f,{...m,method:"HEAD"})},PATCH(f,m){return p(f,{...m,method:"PATCH"})},TRACE(f,m){return p(f,{...m,method:"TRACE"})},use(...f){for(const m of f)if(m){if(typeof m!="object"||!("onRequest"in m||"onResponse"in m||"onError"in m))throw new Error("Middleware must be an object with one of `onRequest()`, `onResponse() or `onError()`");u.push(m)}},eject(...f){for(const m of f){const v=u.indexOf(m);v!==-1&&u.splice(v,1)}}}}function Us(e,t,s){if(t==null)return"";if(typeof t=="object")throw new Error("Deeply-nested arrays/objects aren’t supported. Provide your own `querySerializer()` to handle these.");return`${e}=${s?.allowReserved===!0?t:encodeURIComponent(t)}`}function nr(e,t,s){if(!t||typeof t!="object")return"";const n=[],i={simple:",",label:".",matrix:";"}[s.style]||"&";if(s.style!=="deepObject"&&s.explode===!1){for(const o in t)n.push(o,s.allowReserved===!0?t[o]:encodeURIComponent(t[o]));const r=n.join(",");switch(s.style){case"form":return`${e}=${r}`;case"label":return`.${r}`;case"matrix":return`;${e}=${r}`;default:return r}}for(const r in t){const o=s.style==="deepObject"?`${e}[${r}]`:r;n.push(Us(o,t[r],s))}const a=n.join(i);return s.style==="label"||s.style==="matrix"?`${i}${a}`:a}function ir(e,t,s){if(!Array.isArray(t))return"";if(s.explode===!1){const a={form:",",spaceDelimited:"%20",pipeDelimited:"|"}[s.style]||",",r=(s.allowReserved===!0?t:t.map(o=>encodeURIComponent(o))).join(a);switch(s.style){case"simple":return r;case"label":return`.${r}`;case"matrix":return`;${e}=${r}`;default:return`${e}=${r}`}}const n={simple:",",label:".",matrix:";"}[s.style]||"&",i=[];for(const a of t)s.style==="simple"||s.style==="label"?i.push(s.allowReserved===!0?a:encodeURIComponent(a)):i.push(Us(e,a,s));return s.style==="label"||s.style==="matrix"?`${n}${i.join(n)}`:i.join(n)}function Ui(e){return function(s){const n=[];if(s&&typeof s=="object")for(const i in s){const a=s[i];if(a!=null){if(Array.isArray(a)){if(a.length===0)continue;n.push(ir(i,a,{style:"form",explode:!0,...e?.array,allowReserved:e?.allowReserved||!1}));continue}if(typeof a=="object"){n.push(nr(i,a,{style:"deepObject",explode:!0,...e?.object,allowReserved:e?.allowReserved||!1}));continue}n.push(Us(i,a,e))}}return n.join("&")}}function dl(e,t){let s=e;for(const n of e.match(ll)??[]){let i=n.substring(1,n.length-1),a=!1,r="simple";if(i.endsWith("*")&&(a=!0,i=i.substring(0,i.length-1)),i.startsWith(".")?(r="label",i=i.substring(1)):i.startsWith(";")&&(r="matrix",i=i.substring(1)),!t||t[i]===void 0||t[i]===null)continue;const o=t[i];if(Array.isArray(o)){s=s.replace(n,ir(i,o,{style:r,explode:a}));continue}if(typeof o=="object"){s=s.replace(n,nr(i,o,{style:r,explode:a}));continue}if(r==="matrix"){s=s.replace(n,`;${Us(i,o)}`);continue}s=s.replace(n,r==="label"?`.${encodeURIComponent(o)}`:encodeURIComponent(o))}return s}function pl(e,t){return e instanceof FormData?e:t&&(t.get instanceof Function?t.get("Content-Type")??t.get("content-type"):t["Content-Type"]??t["content-type"])==="application/x-www-form-urlencoded"?new URLSearchParams(e).toString():JSON.stringify(e)}function fl(e,t){let s=`${t.baseUrl}${e}`;t.params?.path&&(s=t.pathSerializer(s,t.params.path));let n=t.querySerializer(t.params.query??{});return n.startsWith("?")&&(n=n.substring(1)),n&&(s+=`?${n}`),s}function Bi(...e){const t=new Headers;for(const s of e){if(!s||typeof s!="object")continue;const n=s instanceof Headers?s.entries():Object.entries(s);for(const[i,a]of n)if(a===null)t.delete(i);else if(Array.isArray(a))for(const r of a)t.append(i,r);else a!==void 0&&t.set(i,a)}return t}function Hi(e){return e.endsWith("/")?e.substring(0,e.length-1):e}function ii(e){return e.replace(/--([a-z][a-z-]*[a-z])/g,(t,s)=>`“${s.replaceAll("-"," ")}”`).replace(/(^|[\s(])'([^']+)'(?=$|[\s.,:;)])/g,"$1“$2”").replaceAll("'","’")}function st(e){const t=ii(e.trim()),s=t.charAt(0).toUpperCase()+t.slice(1);return/[.!?…]$/.test(s)?s:`${s}.`}class Ct extends Error{constructor(t,s,n=null){super(t),this.status=s,this.file=n}}const ar="The server does not answer. It may have been stopped: start spectralpack serve again.";let Ne={reached(){},tokenWanted(){}};function ml(e){Ne=e}const C=ul({baseUrl:"./",credentials:"same-origin"});function rr(e,t){Ne.reached(!0),e===401&&Ne.tokenWanted();const s=t,n=typeof s?.error=="string"&&s.error?st(s.error):`The server answered ${e}. Try again.`;return new Ct(n,e,typeof s?.file=="string"?s.file:null)}async function j(e){let t;try{t=await e}catch(s){throw s instanceof DOMException&&s.name==="AbortError"?s:(Ne.reached(!1),new Ct(ar,0))}if(!t.response.ok)throw rr(t.response.status,t.error);return Ne.reached(!0),t.data}const Y=e=>({path:{id:e}}),T={info:()=>j(C.GET("/api/info")),startSession:e=>j(C.POST("/api/session",{body:{token:e}})),jobs:(e,t)=>j(C.GET("/api/jobs",{params:{query:{most:t,...e?{find:e}:{}}}})),createJob:e=>j(C.POST("/api/jobs",{body:e})),job:e=>j(C.GET("/api/jobs/{id}",{params:Y(e)})),rename:(e,t)=>j(C.PATCH("/api/jobs/{id}",{params:Y(e),body:{name:t}})),deleteJob:e=>j(C.DELETE("/api/jobs/{id}",{params:Y(e)})),deleteFile:(e,t)=>j(C.DELETE("/api/jobs/{id}/files/{name}",{params:{path:{id:e,name:t}}})),fileBytes:(e,t)=>j(C.GET("/api/jobs/{id}/files/{name}",{params:{path:{id:e,name:t}},parseAs:"arrayBuffer"})),parts:e=>j(C.GET("/api/jobs/{id}/parts",{params:Y(e)})),meshes:(e,t,s)=>j(C.GET("/api/jobs/{id}/meshes.bin",{params:{...Y(e),query:{detail:t,ids:s.join(",")}},parseAs:"arrayBuffer"})),jobFile:async e=>{try{return await j(C.GET("/api/jobs/{id}/job.json",{params:Y(e)}))}catch(t){if(t instanceof Ct&&t.status===404)return null;throw t}},putJobFile:(e,t)=>j(C.PUT("/api/jobs/{id}/job.json",{params:Y(e),body:t})),estimate:(e,t)=>j(C.POST("/api/jobs/{id}/estimate",{params:Y(e),signal:t})),start:(e,t=null)=>j(C.POST("/api/jobs/{id}/start",{params:Y(e),...t?{body:t}:{}})),change:(e,t)=>j(C.POST("/api/jobs/{id}/change",{params:Y(e),body:{changes:t.map(wn)}})),revert:(e,t)=>j(C.POST("/api/jobs/{id}/revert",{params:Y(e),body:{revision:t}})),cancel:e=>j(C.POST("/api/jobs/{id}/cancel",{params:Y(e)})),packing:e=>j(C.GET("/api/jobs/{id}/packing.json",{params:Y(e)})),check:e=>j(C.GET("/api/jobs/{id}/check",{params:Y(e)})),clearance:(e,t,s,n)=>j(C.GET("/api/jobs/{id}/clearance",{params:{...Y(e),query:{tray:t,placement:s}},signal:n})),askClearance:(e,t,s,n)=>j(C.POST("/api/jobs/{id}/clearance",{params:Y(e),body:{...wn(t),transform:or(t.transform),changes:s.map(wn)},signal:n}))},or=e=>e.map(t=>[...t]),wn=({tray:e,part:t,copy:s,transform:n})=>({tray:e,part:t,copy:s,transform:n&&or(n)});function ai(e,t,s){const n=s===null||t==="json"?"":`?tray=${s}`;return`./api/jobs/${e}/packing.${t}${n}`}const lr=e=>`./api/jobs/${e}/picture.png`;function gl(e,t){return`./api/jobs/${e}/files/${encodeURIComponent(t)}`}function $l(e,t){const s=/^#token=(.+)$/.exec(e.hash);return s?.[1]?(t.replaceState(null,"",e.pathname+e.search),decodeURIComponent(s[1])):null}async function cr(e){await T.startSession(e.trim())}function et(e,t){try{const s=localStorage.getItem(`spectralpack.${e}`);return s===null?t:JSON.parse(s)}catch{return t}}function it(e,t){try{localStorage.setItem(`spectralpack.${e}`,JSON.stringify(t))}catch{}}class Z{constructor(t){this.listeners=new Set,this.current=t}get value(){return this.current}set(t){const s={...this.current,...t};if(!Object.keys(t).every(i=>Object.is(s[i],this.current[i]))){this.current=s;for(const i of[...this.listeners])i()}}subscribe(t){return this.listeners.add(t),()=>this.listeners.delete(t)}}const $=new Z({route:{page:"start"},info:null,tokenWanted:!1,connected:!0,choice:et("theme","system"),theme:"light",problem:null,toast:null,announcement:"",letterKeys:et("letterKeys",!0),dialog:null});function bl(e){it("letterKeys",e),$.set({letterKeys:e})}function Rt(e){$.set({announcement:e})}function ce(e){$.set({problem:e})}async function nt(e){try{const t=await e();return ce(null),t}catch(t){return t instanceof DOMException&&t.name==="AbortError"||ce(Bt(t)),null}}function Bt(e){return e instanceof Error&&e.message?e.message:"Something went wrong. Reload the page."}function vl(e){const t=/^#\/job\/([a-z0-9]{12})(?:\/(parts|build|apart))?\/?$/.exec(e);return t?.[1]?{page:"job",id:t[1],step:t[2]??"parts"}:{page:"start"}}function ws(e){return e.page==="start"?"#/":`#/job/${e.id}/${e.step}`}function rt(e,t=!1){const s=ws(e);location.hash!==s&&(t?location.replace(s):location.hash=s)}const hr=()=>matchMedia("(prefers-color-scheme: dark)");function Dn(){const e=$.value.choice,t=e==="system"?hr().matches?"dark":"light":e;document.documentElement.dataset.theme=t,$.set({theme:t})}function yl(e){it("theme",e),$.set({choice:e}),Dn()}function wl(){hr().addEventListener("change",Dn),Dn()}/**
 * @license
 * Copyright 2019 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const gs=globalThis,ri=gs.ShadowRoot&&(gs.ShadyCSS===void 0||gs.ShadyCSS.nativeShadow)&&"adoptedStyleSheets"in Document.prototype&&"replace"in CSSStyleSheet.prototype,ur=Symbol(),qi=new WeakMap;let kl=class{constructor(t,s,n){if(this._$cssResult$=!0,n!==ur)throw Error("CSSResult is not constructable. Use `unsafeCSS` or `css` instead.");this.cssText=t,this.t=s}get styleSheet(){let t=this.o;const s=this.t;if(ri&&t===void 0){const n=s!==void 0&&s.length===1;n&&(t=qi.get(s)),t===void 0&&((this.o=t=new CSSStyleSheet).replaceSync(this.cssText),n&&qi.set(s,t))}return t}toString(){return this.cssText}};const xl=e=>new kl(typeof e=="string"?e:e+"",void 0,ur),Ml=(e,t)=>{if(ri)e.adoptedStyleSheets=t.map(s=>s instanceof CSSStyleSheet?s:s.styleSheet);else for(const s of t){const n=document.createElement("style"),i=gs.litNonce;i!==void 0&&n.setAttribute("nonce",i),n.textContent=s.cssText,e.appendChild(n)}},Wi=ri?e=>e:e=>e instanceof CSSStyleSheet?(t=>{let s="";for(const n of t.cssRules)s+=n.cssText;return xl(s)})(e):e;/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const{is:_l,defineProperty:Ol,getOwnPropertyDescriptor:Pl,getOwnPropertyNames:Sl,getOwnPropertySymbols:Tl,getPrototypeOf:Al}=Object,Bs=globalThis,Vi=Bs.trustedTypes,Cl=Vi?Vi.emptyScript:"",jl=Bs.reactiveElementPolyfillSupport,Ae=(e,t)=>e,ks={toAttribute(e,t){switch(t){case Boolean:e=e?Cl:null;break;case Object:case Array:e=e==null?e:JSON.stringify(e)}return e},fromAttribute(e,t){let s=e;switch(t){case Boolean:s=e!==null;break;case Number:s=e===null?null:Number(e);break;case Object:case Array:try{s=JSON.parse(e)}catch{s=null}}return s}},oi=(e,t)=>!_l(e,t),Ki={attribute:!0,type:String,converter:ks,reflect:!1,useDefault:!1,hasChanged:oi};Symbol.metadata??=Symbol("metadata"),Bs.litPropertyMetadata??=new WeakMap;let ae=class extends HTMLElement{static addInitializer(t){this._$Ei(),(this.l??=[]).push(t)}static get observedAttributes(){return this.finalize(),this._$Eh&&[...this._$Eh.keys()]}static createProperty(t,s=Ki){if(s.state&&(s.attribute=!1),this._$Ei(),this.prototype.hasOwnProperty(t)&&((s=Object.create(s)).wrapped=!0),this.elementProperties.set(t,s),!s.noAccessor){const n=Symbol(),i=this.getPropertyDescriptor(t,n,s);i!==void 0&&Ol(this.prototype,t,i)}}static getPropertyDescriptor(t,s,n){const{get:i,set:a}=Pl(this.prototype,t)??{get(){return this[s]},set(r){this[s]=r}};return{get:i,set(r){const o=i?.call(this);a?.call(this,r),this.requestUpdate(t,o,n)},configurable:!0,enumerable:!0}}static getPropertyOptions(t){return this.elementProperties.get(t)??Ki}static _$Ei(){if(this.hasOwnProperty(Ae("elementProperties")))return;const t=Al(this);t.finalize(),t.l!==void 0&&(this.l=[...t.l]),this.elementProperties=new Map(t.elementProperties)}static finalize(){if(this.hasOwnProperty(Ae("finalized")))return;if(this.finalized=!0,this._$Ei(),this.hasOwnProperty(Ae("properties"))){const s=this.properties,n=[...Sl(s),...Tl(s)];for(const i of n)this.createProperty(i,s[i])}const t=this[Symbol.metadata];if(t!==null){const s=litPropertyMetadata.get(t);if(s!==void 0)for(const[n,i]of s)this.elementProperties.set(n,i)}this._$Eh=new Map;for(const[s,n]of this.elementProperties){const i=this._$Eu(s,n);i!==void 0&&this._$Eh.set(i,s)}this.elementStyles=this.finalizeStyles(this.styles)}static finalizeStyles(t){const s=[];if(Array.isArray(t)){const n=new Set(t.flat(1/0).reverse());for(const i of n)s.unshift(Wi(i))}else t!==void 0&&s.push(Wi(t));return s}static _$Eu(t,s){const n=s.attribute;return n===!1?void 0:typeof n=="string"?n:typeof t=="string"?t.toLowerCase():void 0}constructor(){super(),this._$Ep=void 0,this.isUpdatePending=!1,this.hasUpdated=!1,this._$Em=null,this._$Ev()}_$Ev(){this._$ES=new Promise(t=>this.enableUpdating=t),this._$AL=new Map,this._$E_(),this.requestUpdate(),this.constructor.l?.forEach(t=>t(this))}addController(t){(this._$EO??=new Set).add(t),this.renderRoot!==void 0&&this.isConnected&&t.hostConnected?.()}removeController(t){this._$EO?.delete(t)}_$E_(){const t=new Map,s=this.constructor.elementProperties;for(const n of s.keys())this.hasOwnProperty(n)&&(t.set(n,this[n]),delete this[n]);t.size>0&&(this._$Ep=t)}createRenderRoot(){const t=this.shadowRoot??this.attachShadow(this.constructor.shadowRootOptions);return Ml(t,this.constructor.elementStyles),t}connectedCallback(){this.renderRoot??=this.createRenderRoot(),this.enableUpdating(!0),this._$EO?.forEach(t=>t.hostConnected?.())}enableUpdating(t){}disconnectedCallback(){this._$EO?.forEach(t=>t.hostDisconnected?.())}attributeChangedCallback(t,s,n){this._$AK(t,n)}_$ET(t,s){const n=this.constructor.elementProperties.get(t),i=this.constructor._$Eu(t,n);if(i!==void 0&&n.reflect===!0){const a=(n.converter?.toAttribute!==void 0?n.converter:ks).toAttribute(s,n.type);this._$Em=t,a==null?this.removeAttribute(i):this.setAttribute(i,a),this._$Em=null}}_$AK(t,s){const n=this.constructor,i=n._$Eh.get(t);if(i!==void 0&&this._$Em!==i){const a=n.getPropertyOptions(i),r=typeof a.converter=="function"?{fromAttribute:a.converter}:a.converter?.fromAttribute!==void 0?a.converter:ks;this._$Em=i;const o=r.fromAttribute(s,a.type);this[i]=o??this._$Ej?.get(i)??o,this._$Em=null}}requestUpdate(t,s,n,i=!1,a){if(t!==void 0){const r=this.constructor;if(i===!1&&(a=this[t]),n??=r.getPropertyOptions(t),!((n.hasChanged??oi)(a,s)||n.useDefault&&n.reflect&&a===this._$Ej?.get(t)&&!this.hasAttribute(r._$Eu(t,n))))return;this.C(t,s,n)}this.isUpdatePending===!1&&(this._$ES=this._$EP())}C(t,s,{useDefault:n,reflect:i,wrapped:a},r){n&&!(this._$Ej??=new Map).has(t)&&(this._$Ej.set(t,r??s??this[t]),a!==!0||r!==void 0)||(this._$AL.has(t)||(this.hasUpdated||n||(s=void 0),this._$AL.set(t,s)),i===!0&&this._$Em!==t&&(this._$Eq??=new Set).add(t))}async _$EP(){this.isUpdatePending=!0;try{await this._$ES}catch(s){Promise.reject(s)}const t=this.scheduleUpdate();return t!=null&&await t,!this.isUpdatePending}scheduleUpdate(){return this.performUpdate()}performUpdate(){if(!this.isUpdatePending)return;if(!this.hasUpdated){if(this.renderRoot??=this.createRenderRoot(),this._$Ep){for(const[i,a]of this._$Ep)this[i]=a;this._$Ep=void 0}const n=this.constructor.elementProperties;if(n.size>0)for(const[i,a]of n){const{wrapped:r}=a,o=this[i];r!==!0||this._$AL.has(i)||o===void 0||this.C(i,void 0,a,o)}}let t=!1;const s=this._$AL;try{t=this.shouldUpdate(s),t?(this.willUpdate(s),this._$EO?.forEach(n=>n.hostUpdate?.()),this.update(s)):this._$EM()}catch(n){throw t=!1,this._$EM(),n}t&&this._$AE(s)}willUpdate(t){}_$AE(t){this._$EO?.forEach(s=>s.hostUpdated?.()),this.hasUpdated||(this.hasUpdated=!0,this.firstUpdated(t)),this.updated(t)}_$EM(){this._$AL=new Map,this.isUpdatePending=!1}get updateComplete(){return this.getUpdateComplete()}getUpdateComplete(){return this._$ES}shouldUpdate(t){return!0}update(t){this._$Eq&&=this._$Eq.forEach(s=>this._$ET(s,this[s])),this._$EM()}updated(t){}firstUpdated(t){}};ae.elementStyles=[],ae.shadowRootOptions={mode:"open"},ae[Ae("elementProperties")]=new Map,ae[Ae("finalized")]=new Map,jl?.({ReactiveElement:ae}),(Bs.reactiveElementVersions??=[]).push("2.1.2");/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const li=globalThis,Gi=e=>e,xs=li.trustedTypes,Ji=xs?xs.createPolicy("lit-html",{createHTML:e=>e}):void 0,dr="$lit$",_t=`lit$${Math.random().toFixed(9).slice(2)}$`,pr="?"+_t,El=`<${pr}>`,Ht=document,De=()=>Ht.createComment(""),Fe=e=>e===null||typeof e!="object"&&typeof e!="function",ci=Array.isArray,Ll=e=>ci(e)||typeof e?.[Symbol.iterator]=="function",kn=`[ 	
\f\r]`,xe=/<(?:(!--|\/[^a-zA-Z])|(\/?[a-zA-Z][^>\s]*)|(\/?$))/g,Yi=/-->/g,Zi=/>/g,Lt=RegExp(`>|${kn}(?:([^\\s"'>=/]+)(${kn}*=${kn}*(?:[^ 	
\f\r"'\`<>=]|("|')|))|$)`,"g"),Xi=/'/g,Qi=/"/g,fr=/^(?:script|style|textarea|title)$/i,mr=e=>(t,...s)=>({_$litType$:e,strings:t,values:s}),l=mr(1),oe=mr(2),yt=Symbol.for("lit-noChange"),d=Symbol.for("lit-nothing"),ta=new WeakMap,zt=Ht.createTreeWalker(Ht,129);function gr(e,t){if(!ci(e)||!e.hasOwnProperty("raw"))throw Error("invalid template strings array");return Ji!==void 0?Ji.createHTML(t):t}const Nl=(e,t)=>{const s=e.length-1,n=[];let i,a=t===2?"<svg>":t===3?"<math>":"",r=xe;for(let o=0;o<s;o++){const c=e[o];let h,u,p=-1,f=0;for(;f<c.length&&(r.lastIndex=f,u=r.exec(c),u!==null);)f=r.lastIndex,r===xe?u[1]==="!--"?r=Yi:u[1]!==void 0?r=Zi:u[2]!==void 0?(fr.test(u[2])&&(i=RegExp("</"+u[2],"g")),r=Lt):u[3]!==void 0&&(r=Lt):r===Lt?u[0]===">"?(r=i??xe,p=-1):u[1]===void 0?p=-2:(p=r.lastIndex-u[2].length,h=u[1],r=u[3]===void 0?Lt:u[3]==='"'?Qi:Xi):r===Qi||r===Xi?r=Lt:r===Yi||r===Zi?r=xe:(r=Lt,i=void 0);const m=r===Lt&&e[o+1].startsWith("/>")?" ":"";a+=r===xe?c+El:p>=0?(n.push(h),c.slice(0,p)+dr+c.slice(p)+_t+m):c+_t+(p===-2?o:m)}return[gr(e,a+(e[s]||"<?>")+(t===2?"</svg>":t===3?"</math>":"")),n]};class Ie{constructor({strings:t,_$litType$:s},n){let i;this.parts=[];let a=0,r=0;const o=t.length-1,c=this.parts,[h,u]=Nl(t,s);if(this.el=Ie.createElement(h,n),zt.currentNode=this.el.content,s===2||s===3){const p=this.el.content.firstChild;p.replaceWith(...p.childNodes)}for(;(i=zt.nextNode())!==null&&c.length<o;){if(i.nodeType===1){if(i.hasAttributes())for(const p of i.getAttributeNames())if(p.endsWith(dr)){const f=u[r++],m=i.getAttribute(p).split(_t),v=/([.?@])?(.*)/.exec(f);c.push({type:1,index:a,name:v[2],strings:m,ctor:v[1]==="."?Fl:v[1]==="?"?Il:v[1]==="@"?zl:Hs}),i.removeAttribute(p)}else p.startsWith(_t)&&(c.push({type:6,index:a}),i.removeAttribute(p));if(fr.test(i.tagName)){const p=i.textContent.split(_t),f=p.length-1;if(f>0){i.textContent=xs?xs.emptyScript:"";for(let m=0;m<f;m++)i.append(p[m],De()),zt.nextNode(),c.push({type:2,index:++a});i.append(p[f],De())}}}else if(i.nodeType===8)if(i.data===pr)c.push({type:2,index:a});else{let p=-1;for(;(p=i.data.indexOf(_t,p+1))!==-1;)c.push({type:7,index:a}),p+=_t.length-1}a++}}static createElement(t,s){const n=Ht.createElement("template");return n.innerHTML=t,n}}function he(e,t,s=e,n){if(t===yt)return t;let i=n!==void 0?s._$Co?.[n]:s._$Cl;const a=Fe(t)?void 0:t._$litDirective$;return i?.constructor!==a&&(i?._$AO?.(!1),a===void 0?i=void 0:(i=new a(e),i._$AT(e,s,n)),n!==void 0?(s._$Co??=[])[n]=i:s._$Cl=i),i!==void 0&&(t=he(e,i._$AS(e,t.values),i,n)),t}class Dl{constructor(t,s){this._$AV=[],this._$AN=void 0,this._$AD=t,this._$AM=s}get parentNode(){return this._$AM.parentNode}get _$AU(){return this._$AM._$AU}u(t){const{el:{content:s},parts:n}=this._$AD,i=(t?.creationScope??Ht).importNode(s,!0);zt.currentNode=i;let a=zt.nextNode(),r=0,o=0,c=n[0];for(;c!==void 0;){if(r===c.index){let h;c.type===2?h=new ge(a,a.nextSibling,this,t):c.type===1?h=new c.ctor(a,c.name,c.strings,this,t):c.type===6&&(h=new Rl(a,this,t)),this._$AV.push(h),c=n[++o]}r!==c?.index&&(a=zt.nextNode(),r++)}return zt.currentNode=Ht,i}p(t){let s=0;for(const n of this._$AV)n!==void 0&&(n.strings!==void 0?(n._$AI(t,n,s),s+=n.strings.length-2):n._$AI(t[s])),s++}}class ge{get _$AU(){return this._$AM?._$AU??this._$Cv}constructor(t,s,n,i){this.type=2,this._$AH=d,this._$AN=void 0,this._$AA=t,this._$AB=s,this._$AM=n,this.options=i,this._$Cv=i?.isConnected??!0}get parentNode(){let t=this._$AA.parentNode;const s=this._$AM;return s!==void 0&&t?.nodeType===11&&(t=s.parentNode),t}get startNode(){return this._$AA}get endNode(){return this._$AB}_$AI(t,s=this){t=he(this,t,s),Fe(t)?t===d||t==null||t===""?(this._$AH!==d&&this._$AR(),this._$AH=d):t!==this._$AH&&t!==yt&&this._(t):t._$litType$!==void 0?this.$(t):t.nodeType!==void 0?this.T(t):Ll(t)?this.k(t):this._(t)}O(t){return this._$AA.parentNode.insertBefore(t,this._$AB)}T(t){this._$AH!==t&&(this._$AR(),this._$AH=this.O(t))}_(t){this._$AH!==d&&Fe(this._$AH)?this._$AA.nextSibling.data=t:this.T(Ht.createTextNode(t)),this._$AH=t}$(t){const{values:s,_$litType$:n}=t,i=typeof n=="number"?this._$AC(t):(n.el===void 0&&(n.el=Ie.createElement(gr(n.h,n.h[0]),this.options)),n);if(this._$AH?._$AD===i)this._$AH.p(s);else{const a=new Dl(i,this),r=a.u(this.options);a.p(s),this.T(r),this._$AH=a}}_$AC(t){let s=ta.get(t.strings);return s===void 0&&ta.set(t.strings,s=new Ie(t)),s}k(t){ci(this._$AH)||(this._$AH=[],this._$AR());const s=this._$AH;let n,i=0;for(const a of t)i===s.length?s.push(n=new ge(this.O(De()),this.O(De()),this,this.options)):n=s[i],n._$AI(a),i++;i<s.length&&(this._$AR(n&&n._$AB.nextSibling,i),s.length=i)}_$AR(t=this._$AA.nextSibling,s){for(this._$AP?.(!1,!0,s);t!==this._$AB;){const n=Gi(t).nextSibling;Gi(t).remove(),t=n}}setConnected(t){this._$AM===void 0&&(this._$Cv=t,this._$AP?.(t))}}class Hs{get tagName(){return this.element.tagName}get _$AU(){return this._$AM._$AU}constructor(t,s,n,i,a){this.type=1,this._$AH=d,this._$AN=void 0,this.element=t,this.name=s,this._$AM=i,this.options=a,n.length>2||n[0]!==""||n[1]!==""?(this._$AH=Array(n.length-1).fill(new String),this.strings=n):this._$AH=d}_$AI(t,s=this,n,i){const a=this.strings;let r=!1;if(a===void 0)t=he(this,t,s,0),r=!Fe(t)||t!==this._$AH&&t!==yt,r&&(this._$AH=t);else{const o=t;let c,h;for(t=a[0],c=0;c<a.length-1;c++)h=he(this,o[n+c],s,c),h===yt&&(h=this._$AH[c]),r||=!Fe(h)||h!==this._$AH[c],h===d?t=d:t!==d&&(t+=(h??"")+a[c+1]),this._$AH[c]=h}r&&!i&&this.j(t)}j(t){t===d?this.element.removeAttribute(this.name):this.element.setAttribute(this.name,t??"")}}class Fl extends Hs{constructor(){super(...arguments),this.type=3}j(t){this.element[this.name]=t===d?void 0:t}}class Il extends Hs{constructor(){super(...arguments),this.type=4}j(t){this.element.toggleAttribute(this.name,!!t&&t!==d)}}class zl extends Hs{constructor(t,s,n,i,a){super(t,s,n,i,a),this.type=5}_$AI(t,s=this){if((t=he(this,t,s,0)??d)===yt)return;const n=this._$AH,i=t===d&&n!==d||t.capture!==n.capture||t.once!==n.once||t.passive!==n.passive,a=t!==d&&(n===d||i);i&&this.element.removeEventListener(this.name,this,n),a&&this.element.addEventListener(this.name,this,t),this._$AH=t}handleEvent(t){typeof this._$AH=="function"?this._$AH.call(this.options?.host??this.element,t):this._$AH.handleEvent(t)}}class Rl{constructor(t,s,n){this.element=t,this.type=6,this._$AN=void 0,this._$AM=s,this.options=n}get _$AU(){return this._$AM._$AU}_$AI(t){he(this,t)}}const Ul={I:ge},Bl=li.litHtmlPolyfillSupport;Bl?.(Ie,ge),(li.litHtmlVersions??=[]).push("3.3.3");const Hl=(e,t,s)=>{const n=s?.renderBefore??t;let i=n._$litPart$;if(i===void 0){const a=s?.renderBefore??null;n._$litPart$=i=new ge(t.insertBefore(De(),a),a,void 0,s??{})}return i._$AI(e),i};/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const hi=globalThis;let Ce=class extends ae{constructor(){super(...arguments),this.renderOptions={host:this},this._$Do=void 0}createRenderRoot(){const t=super.createRenderRoot();return this.renderOptions.renderBefore??=t.firstChild,t}update(t){const s=this.render();this.hasUpdated||(this.renderOptions.isConnected=this.isConnected),super.update(t),this._$Do=Hl(s,this.renderRoot,this.renderOptions)}connectedCallback(){super.connectedCallback(),this._$Do?.setConnected(!0)}disconnectedCallback(){super.disconnectedCallback(),this._$Do?.setConnected(!1)}render(){return yt}};Ce._$litElement$=!0,Ce.finalized=!0,hi.litElementHydrateSupport?.({LitElement:Ce});const ql=hi.litElementPolyfillSupport;ql?.({LitElement:Ce});(hi.litElementVersions??=[]).push("4.2.2");/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const k=e=>(t,s)=>{s!==void 0?s.addInitializer(()=>{customElements.define(e,t)}):customElements.define(e,t)};/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Wl={attribute:!0,type:String,converter:ks,reflect:!1,hasChanged:oi},Vl=(e=Wl,t,s)=>{const{kind:n,metadata:i}=s;let a=globalThis.litPropertyMetadata.get(i);if(a===void 0&&globalThis.litPropertyMetadata.set(i,a=new Map),n==="setter"&&((e=Object.create(e)).wrapped=!0),a.set(s.name,e),n==="accessor"){const{name:r}=s;return{set(o){const c=t.get.call(this);t.set.call(this,o),this.requestUpdate(r,c,e,!0,o)},init(o){return o!==void 0&&this.C(r,void 0,e,o),o}}}if(n==="setter"){const{name:r}=s;return function(o){const c=this[r];t.call(this,o),this.requestUpdate(r,c,e,!0,o)}}throw Error("Unsupported decorator location: "+n)};function g(e){return(t,s)=>typeof s=="object"?Vl(e,t,s):((n,i,a)=>{const r=i.hasOwnProperty(a);return i.constructor.createProperty(a,n),r?Object.getOwnPropertyDescriptor(i,a):void 0})(e,t,s)}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */function O(e){return g({...e,state:!0,attribute:!1})}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Kl=(e,t,s)=>(s.configurable=!0,s.enumerable=!0,Reflect.decorate&&typeof t!="object"&&Object.defineProperty(e,t,s),s);/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */function H(e,t){return(s,n,i)=>{const a=r=>r.renderRoot?.querySelector(e)??null;return Kl(s,n,{get(){return a(this)}})}}/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const $r={CHILD:2,ELEMENT:6},ui=e=>(...t)=>({_$litDirective$:e,values:t});let di=class{constructor(t){}get _$AU(){return this._$AM._$AU}_$AT(t,s,n){this._$Ct=t,this._$AM=s,this._$Ci=n}_$AS(t,s){return this.update(t,s)}update(t,s){return this.render(...s)}};/**
 * @license
 * Copyright 2020 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const{I:Gl}=Ul,ea=e=>e,sa=()=>document.createComment(""),Me=(e,t,s)=>{const n=e._$AA.parentNode,i=t===void 0?e._$AB:t._$AA;if(s===void 0){const a=n.insertBefore(sa(),i),r=n.insertBefore(sa(),i);s=new Gl(a,r,e,e.options)}else{const a=s._$AB.nextSibling,r=s._$AM,o=r!==e;if(o){let c;s._$AQ?.(e),s._$AM=e,s._$AP!==void 0&&(c=e._$AU)!==r._$AU&&s._$AP(c)}if(a!==i||o){let c=s._$AA;for(;c!==a;){const h=ea(c).nextSibling;ea(n).insertBefore(c,i),c=h}}}return s},Nt=(e,t,s=e)=>(e._$AI(t,s),e),Jl={},br=(e,t=Jl)=>e._$AH=t,Yl=e=>e._$AH,xn=e=>{e._$AR(),e._$AA.remove()};/**
 * @license
 * Copyright 2021 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Zl=ui(class extends di{constructor(){super(...arguments),this.key=d}render(e,t){return this.key=e,t}update(e,[t,s]){return t!==this.key&&(br(e),this.key=t),s}}),Xl={add:"M8 3v10M3 8h10",any:"M8 2.4a5.6 5.6 0 015.3 3.8M13.6 2.8v3.4h-3.4M8 13.6a5.6 5.6 0 01-5.3-3.8M2.4 13.2V9.8h3.4",axes:"M4 12V4M4 12h8M4 12l4.5-4.5M4 4L2.8 5.4M4 4l1.2 1.4M12 12l-1.4-1.2M12 12l-1.4 1.2",bad:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 5v3.6M8 10.9v.1",box:"M8 1.8l5.6 3.1v6.2L8 14.2l-5.6-3.1V4.9zM2.4 4.9L8 8l5.6-3.1M8 8v6.2",braces:"M6 2.5c-2 0-1.5 2-1.5 3.5S3 8 3 8s1.5.5 1.5 2-.5 3.5 1.5 3.5M10 2.5c2 0 1.5 2 1.5 3.5S13 8 13 8s-1.5.5-1.5 2 .5 3.5-1.5 3.5",check:"M3 8.5l3.2 3L13 4.5",clock:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 4.6V8l2.4 1.6",close:"M4 4l8 8M12 4l-8 8",copy:"M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",down:"M4 6l4 4 4-4",download:"M8 2v8M4.8 6.8L8 10l3.2-3.2M2.5 10.5v3h11v-3",drawn:"M3.5 3.5h9v9h-9zM8 6v4M6 8h4",eye:"M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM8 6.2a1.8 1.8 0 110 3.6 1.8 1.8 0 010-3.6",eyeOff:"M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM3 13L13 3",file:"M4 1.8h5l3.2 3.2v9.2H4zM9 1.8V5h3.2",find:"M7 2.5a4.5 4.5 0 110 9 4.5 4.5 0 010-9zM10.4 10.4L14 14",first:"M12 3.5L6.5 8l5.5 4.5zM4 3.5v9",flip:"M8 2v12M5.5 5L2.5 11h3zM10.5 5l3 6h-3z",folder:"M1.8 4h4.4l1.5 1.6h6.5v7.6H1.8z",frame:"M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3",goBack:"M4.5 11.5l7-7M6.5 4.5h5v5",goBend:"M4 13V7.5a2 2 0 012-2h6.5M9.5 2.5l3 3-3 3",goDown:"M8 3v10M4.5 9.5L8 13l3.5-3.5",goFront:"M11.5 4.5l-7 7M9.5 11.5h-5v-5",goLeft:"M13 8H3M6.5 4.5L3 8l3.5 3.5",goRight:"M3 8h10M9.5 4.5L13 8l-3.5 3.5",goUp:"M8 13V3M4.5 6.5L8 3l3.5 3.5",help:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM6.2 6.4a1.9 1.9 0 113 1.5c-.8.5-1.2.8-1.2 1.6M8 11.4v.1",improve:"M2.5 12.5l4-4 2.5 2.5 4.5-5.5M10 5.5h3.5V9",info:"M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 7.4v3.6M8 5.1v.1",last:"M4 3.5L9.5 8 4 12.5zM12 3.5v9",left:"M10 4L6 8l4 4",list:"M5.5 4h8M5.5 8h8M5.5 12h8M2.6 4h.1M2.6 8h.1M2.6 12h.1",lock:"M4 7h8v6.5H4zM5.6 7V5a2.4 2.4 0 014.8 0v2",mesh:"M6.5 9.5l3-3M7 4.5l1-1a2.8 2.8 0 014 4l-1 1M9 11.5l-1 1a2.8 2.8 0 01-4-4l1-1",minus:"M3.5 8h9",moon:"M13 9.6A5.6 5.6 0 016.4 3 5.6 5.6 0 1013 9.6z",more:"M3.5 8h.1M8 8h.1M12.5 8h.1",move:"M8 2v12M2 8h12M6.2 3.8L8 2l1.8 1.8M6.2 12.2L8 14l1.8-1.8M3.8 6.2L2 8l1.8 1.8M12.2 6.2L14 8l-1.8 1.8",pause:"M4.5 3h2.5v10H4.5zM9 3h2.5v10H9z",picture:"M2.5 3h11v10h-11zM2.5 11l3.2-3.2 2.6 2.6 2.2-2.2 3 3M10.5 6h.1",play:"M4.5 2.5L13 8l-8.5 5.5z",printer:"M4.5 6V2.5h7V6M4.5 11.5h-2V6h11v5.5h-2M4.5 9.5h7v4h-7z",redo:"M10 4l3 3-3 3M13 7H6.5a3.5 3.5 0 000 7H8",right:"M6 4l4 4-4 4",settings:"M2.5 4.5h6M11.5 4.5h2M10 3v3M2.5 11.5h2M7.5 11.5h6M6 10v3",stepBack:"M11 3.5L5.5 8 11 12.5z",stepOn:"M5 3.5L10.5 8 5 12.5z",stop:"M4 4h8v8H4z",sun:"M8 5.2a2.8 2.8 0 110 5.6 2.8 2.8 0 010-5.6M8 1.6v1.2M8 13.2v1.2M1.6 8h1.2M13.2 8h1.2M3.5 3.5l.8.8M11.7 11.7l.8.8M12.5 3.5l-.8.8M4.3 11.7l-.8.8",system:"M2.5 3h11v7.5h-11zM6 13.5h4M8 10.5v3",trash:"M3 4.4h10M6.4 4.4V2.8h3.2v1.6M4.4 4.4l.5 9.2h6.2l.5-9.2",unlock:"M4 7h8v6.5H4zM5.6 7V5a2.4 2.4 0 014.7-.7",undo:"M6 4L3 7l3 3M3 7h6.5a3.5 3.5 0 010 7H8",upright:"M8 13V3M8 3L5.6 5.4M8 3l2.4 2.4M3.4 13.4h9.2",warn:"M8 2.2L14.5 13.5h-13zM8 6.5v3.2M8 11.6v.1"};function b(e){return l`<svg class="i" viewBox="0 0 16 16" aria-hidden="true">${oe`<path d=${Xl[e]} />`}</svg>`}const z=l`<svg class="i spin" viewBox="0 0 16 16" aria-hidden="true">
  <path d="M8 1.8a6.2 6.2 0 016.2 6.2" />
</svg>`,vr=l`<svg class="mark" viewBox="0 0 20 20" aria-hidden="true">
  <path class="edge" d="M10 1.5l7.5 4.2v8.6L10 18.5l-7.5-4.2V5.7z" />
  <path class="face" d="M10 10l7.5-4.3v8.6L10 18.5z" />
  <path class="edge" d="M2.5 5.7L10 10v8.5" />
</svg>`;class x extends Ce{constructor(){super(...arguments),this.watching=[],this.watchedStores=[]}stores(){return[]}createRenderRoot(){return this}connectedCallback(){super.connectedCallback(),this.watchStores()}disconnectedCallback(){super.disconnectedCallback();for(const t of this.watching)t();this.watching=[],this.watchedStores=[]}willUpdate(){this.watchStores()}watchStores(){const t=this.stores();if(!(t.length===this.watchedStores.length&&t.every((n,i)=>n===this.watchedStores[i]))){for(const n of this.watching)n();this.watching=t.map(n=>n.subscribe(()=>this.requestUpdate())),this.watchedStores=t}}}const Ql={mm:1,inch:25.4,m:1e3};function yr(e,t,s){return(t.unit_known?t.unit:Ql[e.unit??s.unit])*e.scale}function wr(e,t,s){return yr(e,t,s)/t.unit}function qs(e,t,s){const n=wr(e,t,s),[i=0,a=0,r=0]=t.size;return[i*n,a*n,r*n]}function kr(e,t,s){return t.volume*wr(e,t,s)**3}const L=" ";function w(e){return Math.round(e).toString().replace(/\B(?=(\d{3})+$)/g,L)}function Mt(e,t=2){return Number(e.toFixed(t)).toString()}const qt=(e,t=1)=>`${e.toFixed(t)}${L}mm`,K=(e,t=1)=>`${(e*100).toFixed(t)}${L}%`;function P(e,t,s=`${t}s`){return`${w(e)} ${e===1?t:s}`}const S=e=>P(e,"copy","copies");function tc(e){const t=e%100,s=t>10&&t<14?"th":["th","st","nd","rd"][e%10]??"th";return`${w(e)}${s}`}function Ms(e){const t=["bytes","kB","MB","GB","TB"];let s=e,n=0;for(;s>=999.5&&n<t.length-1;)s/=1e3,n+=1;return`${n===0||s>=10?s.toFixed(0):s.toFixed(1)}${L}${t[n]}`}function pi(e){const t=e/1e3;return t>=1e3?`${Mt(t/1e3,t>=1e4?1:2)} litres`:t>=1?`${t.toFixed(1)}${L}cm³`:`${w(e)}${L}mm³`}function ut(e,t=!1,s="mm"){const n=s==="inch"?e.map(r=>r/25.4):e,i=Math.max(...n)<19.5||Math.min(...n)<.95,a=s==="inch"?2:t||i?1:0;return`${n.map(r=>r.toFixed(a)).join(" × ")}${L}${s==="inch"?"in":"mm"}`}function gt(e){const t=e.replace(/[\s\u202f\u2009]/g,"").replace(",",".");if(!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(t))return null;const s=Number(t);return Number.isFinite(s)?s:null}function ec(e,t){const[s,n,i]=e,a=(r,o,c)=>[[r,o,c],[o,r,c]];switch(t.kind){case"fixed":return[e];case"upright":return a(s,n,i);case"axes":return t.axes.flatMap(r=>r.endsWith("x")?a(n,i,s):r.endsWith("y")?a(s,i,n):a(s,n,i));default:return[...a(s,n,i),...a(n,i,s),...a(s,i,n)]}}function xr(e,t,s){const n=i=>Math.min(...i.map((a,r)=>a>0?(s[r]??0)/a:Number.POSITIVE_INFINITY));return Math.max(...ec(e,t).map(n))}const Mr=1e-9;function na(e,t,s){return xr(e,t,s)<1-Mr}function sc(e,t,s,n){const i=Math.floor(xr(e,t,s)*n*100+Mr);return i>=1?i/100:null}function nc(e){return e===void 0||e==="90"||e===90||e==="none"}const _r={do:"leave_out",text:"Leave out"},ic={do:"replace",text:"Replace"};function ac({part:e,mesh:t,draft:s,room:n,reading:i}){return t?[rc(e,t,s,n),oc(e,t,s),lc(t),cc(t)].filter(a=>a!==null):i?[]:[{tone:"bad",text:`${e.object===null?e.file:`Object ${e.object} of ${e.file}`} is not there.`,actions:[ic,_r]}]}function rc(e,t,s,n){if(!n||!nc(s.options.rotations))return null;const i=qs(e,t,s);if(!na(i,e.stands,n))return null;const a=sc(i,e.stands,n,e.scale),r=!na(i,{kind:"any"},n),o=e.stands.kind==="any"?"in every position":r?"as it may stand":"in every position";return{tone:"bad",text:`${ut(i)} is larger than the tray ${o}.`,actions:[...a===null?[]:[{do:"scale",scale:a,text:`Scale to ${K(a,0)}`}],_r]}}function oc(e,t,s){if(t.unit_hint===null||t.unit_known||e.unit!==null||s.unit!=="mm")return null;const n=Math.max(...qs(e,t,s));return n>=1e3?{tone:"warn",text:`${(n/1e3).toFixed(1)} m long: perhaps drawn in another unit.`,actions:[{do:"scale",scale:.001,text:`Scale to ${K(.001)}`},{do:"unit",unit:"mm",text:"Keep mm"}]}:{tone:"warn",text:`Only ${n.toFixed(n<1?2:1)} mm long: perhaps drawn in ${n<.2?"metres":"inches"}.`,actions:[n<.2?{do:"unit",unit:"m",text:"Read as metres"}:{do:"unit",unit:"inch",text:"Read as inches"},{do:"unit",unit:"mm",text:"Keep mm"}]}}function lc(e){const t=e.warnings.filter(s=>s!==e.unit_hint&&!s.includes("--unit"));return t.length===0?null:{tone:"warn",text:`${t.map(st).join(" ")}`,actions:[]}}function cc(e){const t=e.repairs.filter(i=>!hc(i));if(t.length===0)return null;const s=st(t[0]??""),n=t.length>1?` ${P(t.length-1,"more thing")} mended.`:"";return{tone:"info",text:s+n,actions:[{do:"repairs",text:"See what changed"}]}}function hc(e){return/^(merged|welded) [\d\s]+ vert(ex|ices)/.test(e)}function Ws(e,t){const s=e.tray;return s.kind==="printer"?t.printers.find(n=>n.name===s.name)??null:null}function jt(e,t,s){const n=e.tray;return n.kind==="box"?n.size:n.kind==="printer"?Ws(e,t)?.size??null:s.find(a=>a.file===n.file)?.size??null}function Vs(e,t){return e.gap??Ws(e,t)?.gap??.2}function fi(e,t){return e.wallGap??Ws(e,t)?.wall_gap??0}function uc(e,t,s){const n=jt(e,t,s);if(!n)return null;const i=2*fi(e,t),a=e.openHeight?Number.POSITIVE_INFINITY:n[2]-i;return[n[0]-i,n[1]-i,a]}const dc=44,pc=26,ia=e=>dc+e.remarks.length*pc,ss=(e,t)=>e.name??t?.name??e.file.replace(/\.[^.]*$/,"");function mi(e){const t=new Map(e.map(s=>[`${s.file}
${s.object??""}`,s]));return s=>t.get(`${s.file}
${s.object??""}`)??null}const aa=new WeakMap;function Fn(e){const t=[e.draft,e.parts,e.uploads.state.value.active],s=aa.get(e);if(s?.of.every((i,a)=>i===t[a]))return s.rows;const n=fc(e);return aa.set(e,{of:t,rows:n}),n}function fc(e){const{draft:t,info:s,parts:n}=e,i=uc(t,s,n.meshes),a=mi(n.meshes),r=n.reading>0||e.uploads.state.value.active;return t.parts.map((o,c)=>{const h=a(o);return{part:o,index:c,mesh:h,remarks:ac({part:o,mesh:h,draft:t,room:i,reading:r})}})}function mc(e,t){const s=(t??"").trim().toLowerCase();return s===""?e:e.filter(({part:n,mesh:i})=>`${ss(n,i)} ${n.file} ${n.order??""}`.toLowerCase().includes(s))}function Or(e){return e.reduce((t,{part:s,mesh:n})=>t+(n?s.count:0),0)}function gc(e,t){return e.reduce((s,{part:n,mesh:i})=>s+(i?kr(n,i,t.draft)*n.count:0),0)}function $c(e,t){return e.mesh?qs(e.part,e.mesh,t.draft):null}function bc(e){const{draft:t,parts:s}=e,n=mi(s.meshes),i=Array.isArray(t.fixed)?t.fixed.length:0;return t.parts.map((a,r)=>{const o=n(a),c=o?(a.unit&&!o.unit_known?vc(a.unit)/o.unit:1)*a.scale:1;return{index:r+i,name:ss(a,o),count:a.count,volume:(o?.volume??0)*c**3,mesh:o}})}const vc=e=>e==="inch"?25.4:e==="m"?1e3:1;function Ks(e,t){const{meshes:s}=e.parts,n=new Map(s.map(a=>[`${a.file}
${a.object??""}`,a])),i=new Map(s.map(a=>[a.file,a]));return t.parts.map(a=>({index:a.index,name:a.name,count:a.count,volume:a.volume,mesh:n.get(`${a.file}
${a.object??""}`)??i.get(a.file)??null}))}function ra(e,t,s){const n=t.parts[s];return n?e.draft.parts.filter(a=>a.file===n.file&&(a.object??null)===n.object)[0]?.key??e.draft.parts.find(a=>a.file===n.file)?.key??null:null}function Pr(e){const t=new Map;for(const s of e)for(const{part:n}of s.placements)t.set(n,(t.get(n)??0)+1);return t}function yc(e,t){const s=e.trays[t-1];return t>0&&s?[s]:e.trays}const wc=3e3;function kc(e,t){let s=null,n=0;const i=()=>{s=new EventSource(`./api/jobs/${e}/events`);const a=(r,o)=>s?.addEventListener(r,c=>{try{o(JSON.parse(c.data))}catch{}});a("state",r=>t.state(r)),a("line",r=>t.line(r)),a("anew",()=>t.anew()),s.onopen=()=>t.connected(!0),s.onerror=()=>{t.connected(!1),s?.readyState===EventSource.CLOSED&&(n=window.setTimeout(()=>{t.anew(),i()},wc))}};return i(),()=>{clearTimeout(n),s?.close()}}class xc{constructor(){this.what="",this.before=0,this.points=[],this.seconds=0,this.left=null}add({phase:t,what:s,before:n,now:i,seconds:a,left:r}){if(t!=="improve"||s===void 0||n===void 0||i===void 0)return;(s!==this.what||n!==this.before||a<this.seconds)&&this.begin(s,n,a),this.seconds=a,this.left=r??null;const o=this.points[this.points.length-1];o&&o.value!==i&&(this.points=[...this.points,{seconds:a,value:i}])}get now(){return this.points[this.points.length-1]?.value??this.before}get isThere(){return this.what!==""}clear(){this.what="",this.points=[],this.seconds=0,this.left=null}begin(t,s,n){this.what=t,this.before=s,this.points=[{seconds:n,value:s}]}}const _=e=>`${e.part}/${e.copy}`;class Mc{constructor(){this.trays=new Map,this.phases=new Set,this.seconds=new Map,this.remarks=[],this.curve=new xc,this.progress=null,this.newest=null,this.version=0,this.placed=0,this.changes=new Map}clear(){for(const t of this.trays.keys())this.noteCleared(t);this.trays.clear(),this.phases.clear(),this.seconds.clear(),this.remarks.length=0,this.curve.clear(),this.progress=null,this.newest=null,this.placed=0,this.version+=1}apply(t){if(t===null||typeof t!="object")return;const s=t;this.version+=1,s.event!==void 0?this.applyEvent(s):s.phase!==void 0?this.applyProgress(t):s.warning!==void 0?this.remark(s.warning):s.error!==void 0&&this.remark(s.error)}get standing(){let t=0;for(const s of this.trays.values())t+=s.copies.size;return t}counts(){const t=new Map;for(const s of this.trays.values())for(const n of s.copies.values())t.set(n.part,(t.get(n.part)??0)+1);return t}get current(){return this.newest?.tray??Math.max(1,...this.trays.keys())}drain(t,s=!1){const n=this.changes.get(t);if(this.changes.delete(t),s)return{cleared:!0,placed:[...this.trays.get(t)?.copies.values()??[]],removed:[]};const i=[],a=[];for(const r of n?.copies.values()??[])"transform"in r?i.push(r):a.push(r);return{cleared:n?.cleared??!1,placed:i,removed:a}}applyEvent(t){const s=t.tray??1;switch(t.event){case"tray_begun":this.trays.set(s,{number:s,copies:new Map,finished:!1}),this.noteCleared(s);break;case"copy_placed":case"copy_put_back":case"copy_moved":this.stand(s,t,t.event==="copy_placed");break;case"copy_taken_out":{const n={part:t.part??0,copy:t.copy??0};this.tray(s).copies.delete(_(n)),this.changesOf(s).copies.set(_(n),n);break}case"tray_finished":this.tray(s).finished=!0;break}}stand(t,s,n){if(!s.transform)return;const i={part:s.part??0,copy:s.copy??0},a=_(i),r=this.tray(t),o=r.copies.get(a)?.order??this.placed++,c={...i,transform:s.transform,order:o};r.copies.set(a,c),this.changesOf(t).copies.set(a,c),n&&(this.newest={tray:t,copy:c})}applyProgress(t){this.progress=t,this.curve.add(t),this.phases.add(t.phase),this.seconds.set(t.phase,t.seconds)}remark(t){this.remarks.includes(t)||this.remarks.push(t)}tray(t){let s=this.trays.get(t);return s||(s={number:t,copies:new Map,finished:!1},this.trays.set(t,s)),s}changesOf(t){let s=this.changes.get(t);return s||(s={cleared:!1,copies:new Map},this.changes.set(t,s)),s}noteCleared(t){this.changes.set(t,{cleared:!0,copies:new Map})}}const Sr=[480,245,200],_s={parts:[],unit:"mm",tray:{kind:"box",size:Sr},openHeight:!1,trays:1,keepOut:[],gap:null,wallGap:null,goal:"lowest",timeLimit:null,material:"",physical:!1,options:{},fixed:null},gi={kind:"any"};function Gs(e,t,s){return{key:s,file:e,object:t,name:null,count:1,scale:1,unit:null,stands:gi,gap:null,priority:0,due:null,order:null,value:null}}function Js(e,t,s){const n=t===null?e:`${e}#${t}`;if(!s.has(n))return n;let i=2;for(;s.has(`${n}*${i}`);)i+=1;return`${n}*${i}`}function ns(e){return e.openHeight||e.goal==="box"}function Tr(e){return e.tray.kind!=="mesh"&&e.keepOut.length===0}function Ar(e){return e.parts.reduce((t,s)=>t+s.count,0)}function Wt(e){return e.split(/[/\\]/).pop()??e}function Cr(e,t){const s={...ze(e.options)},n=y=>{const M=s[y];return delete s[y],M??void 0},i=ze(e.container),a=$t(n("printer")),r=Lr(i.size??n("tray")),o=(e.open_height??n("open-height"))===!0,c=e.trays??n("trays"),h=lt(e.gap??n("gap")),u=lt(e.wall_gap??n("wall-gap")),p=is(e.unit??n("unit")),f=_c(n,s["height-at"]);f==="lowest"&&delete s["height-at"];const m=lt(n("time-limit")),v=$t(n("material"));return{parts:Sc(e.parts,t),unit:p??"mm",tray:Oc(i,a,r),openHeight:o,trays:c==="all"?"all":Math.max(1,Math.round(lt(c)??1)),keepOut:ue(e.keep_out).flatMap(Pc),gap:h,wallGap:u,goal:f,timeLimit:m,material:v??"",physical:i.physical===!0,options:s,fixed:ue(e.fixed).length>0?e.fixed??null:null}}function _c(e,t){return e("minimise")==="box"?"box":t==="top"?"lowest":"fill"}function Oc(e,t,s){const n=$t(e.mesh);if(n!==null){const i=e.is;return{kind:"mesh",file:Wt(n),is:i==="solid"||i==="vessel"?i:null,unit:is(e.unit),transform:e.transform??null}}return s?{kind:"box",size:s}:t===null?_s.tray:{kind:"printer",name:t}}function Pc(e){const t=ze(e),s=$t(t.mesh);if(s!==null)return[{mesh:Wt(s),transform:t.transform??null,unit:is(t.unit)}];const[n,i]=ue(t.box).map(Lr);return n&&i?[{box:[n,i]}]:[]}function Sc(e,t){const s=[],n=new Set;for(const i of ue(e).map(ze)){const a=$t(i.mesh);if(a===null)continue;const r=Wt(a);for(const o of $i(r,$t(i.object),t)){const c=Js(r,o,n);n.add(c),s.push(Tc(i,Gs(r,o,c)))}}return s}function $i(e,t,s){if(t!==null)return[t];const n=s.filter(i=>i.file===e);return n.length>0?n.map(i=>i.object):[null]}function Tc(e,t){return{...t,name:$t(e.name),count:Math.max(1,Math.round(lt(e.count)??1)),scale:lt(e.scale)??1,unit:is(e.unit),stands:jr(e.orientations),gap:lt(e.gap),priority:lt(e.priority)??0,due:$t(e.due),order:$t(e.order),value:lt(e.value)}}function jr(e){if(e==="upright"||e==="fixed")return{kind:e};const t=ze(e);if(t.matrices)return{kind:"matrices",matrices:t.matrices};const s=ue(t.axes).filter(Er);return s.length>0?{kind:"axes",axes:s,yaw:lt(t.yaw)}:gi}function Er(e){return typeof e=="string"&&/^[+-][xyz]$/.test(e)}function is(e){return e==="mm"||e==="inch"||e==="m"?e:null}function ze(e){return e!==null&&typeof e=="object"&&!Array.isArray(e)?e:{}}function ue(e){return Array.isArray(e)?e:[]}const $t=e=>typeof e=="string"&&e!==""?e:null,lt=e=>typeof e=="number"&&Number.isFinite(e)?e:null;function Lr(e){const[t,s,n=0]=ue(e).map(lt);return typeof t=="number"&&typeof s=="number"&&n!==null?[t,s,n]:null}const Nr="taken out by hand";function Ac(e){const t=e,s=je(t.container.size);return{size:s,openHeight:t.container.open_height===!0,keepOut:(t.container.keep_out??[]).flatMap(({box:n})=>n?[[je(n[0]??[]),je(n[1]??[])]]:[]),parts:t.parts.map((n,i)=>({index:i,name:n.name,file:Wt(n.mesh),object:n.object??null,count:n.count,volume:n.volume,stands:typeof n.orientations=="string"?n.orientations:""})),trays:t.trays.map((n,i)=>Cc(n,i+1,s[0]*s[1])),leftOver:jc(t.unplaced??[]),options:t.options??{},copies:t.metrics.copies,placed:t.metrics.placed,density:t.metrics.density,minGap:t.metrics.min_gap,seconds:t.metrics.seconds?.total??0,improvement:t.metrics.improvement??null}}function Cc(e,t,s){const n=e.disassembly?.steps??[],i=new Map;n.forEach((r,o)=>{for(const c of r.placements)i.has(c)||i.set(c,o)});const a=e.placements.map((r,o)=>{const c=i.get(o),h=c===void 0?void 0:n[c];return{index:o,part:r.part,copy:r.copy,transform:r.transform,fixed:r.fixed===!0,step:c===void 0?null:c+1,path:(h?.path??[]).map(je),together:h?.placements.length??0}});return{number:t,placements:a,byId:new Map(a.map(r=>[_(r),r])),density:e.density,height:e.height,layers:e.layers?{thickness:e.layers.thickness,share:e.layers.area.map(r=>r/s),exact:!0}:null,steps:n.length,plan:n.map((r,o)=>({placements:r.placements,path:r.path.map(je),throughWalls:e.disassembly?.through_walls?.includes(o)??!1})),complete:e.disassembly?.complete===!0,throughWalls:e.disassembly?.through_walls?.length??0}}function jc(e){const t=new Map;for(const{part:s,copy:n,reason:i,detail:a=""}of e){const r=a===Nr,o=`${s}/${i}/${r}`,c=[...t.get(o)?.which??[],n];t.set(o,{part:s,reason:i,copies:c.length,detail:t.get(o)?.detail||a,which:c,byHand:r})}return[...t.values()]}function je(e){return[e[0]??0,e[1]??0,e[2]??0]}const E=e=>e.status==="running"||e.status==="queued";class Ec{constructor(t){this.live=new Mc,this.overlay=s=>s,this.arrived=()=>{},this.kind=null,this.stopWatching=null,this.telling=0,this.closed=!1,this.state=new Z({job:t,packing:null,stored:null,loading:!1,problem:null,version:0,since:0,stopping:!1})}get id(){return this.state.value.job.id}begin(){const{job:t}=this.state.value,s=et(`run.${this.id}`,null);E(t)&&s&&s.started===(t.started??null)&&(this.kind=s.kind),this.take(t),E(t)&&t.has_packing&&this.kind!=="pack"&&this.load()}get doing(){if(this.kind)return this.kind;const{job:t,stored:s}=this.state.value,n=this.live.progress?.phase??t.progress?.phase;return!t.has_packing||!s||this.live.phases.has("search")?"pack":n==="improve"||this.live.curve.isThere?"improve":(n==="disassemble"||n==="check")&&this.live.standing===0?"change":"pack"}get checking(){return E(this.state.value.job)&&this.doing==="change"}get packs(){return E(this.state.value.job)&&this.doing!=="change"}show(){const{stored:t}=this.state.value;t&&this.state.set({packing:this.overlay(t)})}take(t){const s=this.state.value.job;if(this.state.set({job:t}),E(t)){this.stopWatching||this.watch();return}const n=E(s);this.state.set({stopping:!1}),t.has_packing&&(n||!this.state.value.packing)?this.load():n&&this.arrived(null)}async refresh(){this.take(await T.job(this.id))}async start(t,s){const n=await s();this.unwatch(),this.kind=t,it(`run.${this.id}`,{kind:t,started:n.started??null}),this.live.clear();const i=t==="pack"?{packing:null,stored:null}:{};this.state.set({...i,version:this.live.version,stopping:!1}),this.take(n),!E(n)&&n.has_packing&&await this.load()}async cancel(){this.state.set({stopping:!0});try{const t=await T.cancel(this.id);E(this.state.value.job)&&this.take(t)}catch(t){throw this.state.set({stopping:!1}),t}}close(){this.closed=!0,this.unwatch()}watch(){this.live.clear(),this.state.set({since:Date.now()}),this.stopWatching=kc(this.id,{state:t=>{this.take(t),E(t)||this.unwatch()},line:t=>{this.live.apply(t),this.tellSoon()},anew:()=>{this.live.clear(),this.tellSoon()},connected:t=>$.set({connected:t})})}unwatch(){this.stopWatching?.(),this.stopWatching=null}tellSoon(){if(this.telling)return;const t=()=>{this.telling=0,this.state.set({version:this.live.version})};this.telling=document.hidden?window.setTimeout(t,500):requestAnimationFrame(t)}async load(){this.state.set({loading:!0,problem:null});try{const t=Ac(await T.packing(this.id));if(this.closed)return;E(this.state.value.job)||this.arrived(t),this.state.set({stored:t,packing:this.overlay(t),loading:!1})}catch(t){this.state.set({loading:!1,problem:Bt(t)})}}}const Lc=5e3;let bt=null;function Os(e,t,s=()=>{}){bi();const n={finish:s,timer:0};bt=n,$.set({toast:{text:e,undo:()=>{bt===n&&(Dr(),t())}}}),Se(!1)}function Se(e){bt&&(clearTimeout(bt.timer),e||(bt.timer=window.setTimeout(bi,Lc)))}function bi(){const e=bt?.finish;Dr(),e?.()}function Dr(){bt&&clearTimeout(bt.timer),bt=null,$.set({toast:null})}addEventListener("pagehide",bi);function Fr(e,t){if(!t)return e;const s=new Map;let n=1;for(const{name:r,count:o}of t.parts)s.set(r,[...s.get(r)??[],{first:n,count:o}]),n+=o;const i=[...s.keys()].filter(r=>r!=="").sort((r,o)=>o.length-r.length);if(i.length===0)return e;const a=new RegExp(`(?<![\\w.])(\\d+) (${i.map(Nc).join("|")})(?![\\w-])`,"g");return e.replace(a,(r,o,c)=>{const h=s.get(c)?.find(({first:u,count:p})=>Number(o)>=u&&Number(o)<u+p);return h?`${c} ${Number(o)-h.first+1}`:r})}const Nc=e=>e.replace(/[.*+?^${}()|[\]\\]/g,"\\$&");class Dc{constructor(){this.lists={past:[],future:[]}}get now(){return this.lists}get last(){return this.lists.past[this.lists.past.length-1]??null}get next(){return this.lists.future[this.lists.future.length-1]??null}push(t){this.lists={past:[...this.lists.past,t].slice(-200),future:[]}}undo(){const{last:t}=this;return t&&(this.lists={past:this.lists.past.slice(0,-1),future:[...this.lists.future,t]}),t}redo(){const{next:t}=this;return t&&(this.lists={past:[...this.lists.past,t],future:this.lists.future.slice(0,-1)}),t}replace(t,s){const n=i=>i.flatMap(a=>a===t?s?[s]:[]:[a]);this.lists={past:n(this.lists.past),future:n(this.lists.future)}}restore(t){this.lists=t}}const Ut=e=>`${e.tray}/${e.part}/${e.copy}`;function as(e,t){return e?.trays[t.tray-1]?.byId.get(_(t))??null}function ie(e,t){if(e.length===0||t.length===0)return e.length===0?t:e;const s=new Map;for(const n of[...e,...t])s.delete(_(n)),s.set(_(n),n);return[...s.values()]}function Fc(e,t){return t.map(({tray:s,part:n,copy:i})=>({tray:s,part:n,copy:i,transform:as(e,{tray:s,part:n,copy:i})?.transform??null}))}function oa(e,t){if(t.length===0)return e;const s=e.trays.map(r=>{const o=t.filter(c=>c.tray===r.number);return o.length>0?Ic(e,r,o):r}),n=s.reduce((r,o)=>r+o.placements.length,0),i=e.trays.reduce((r,o)=>r+Ps(e,o.placements),0),a=s.reduce((r,o)=>r+Ps(e,o.placements),0);return{...e,trays:s,placed:n,density:i>0?e.density*a/i:e.density,leftOver:Rc(e,t)}}function Ic(e,t,s){const n=new Map(t.byId);for(const o of s){const c=_(o),h=n.get(c);o.transform===null?n.delete(c):n.set(c,{...h??zc(o,n.size),transform:o.transform,...Ir})}const i=[...n.values()],a=Ps(e,t.placements),r=a>0?Ps(e,i)/a:1;return{...t,placements:i,byId:n,density:t.density*r,steps:0,complete:!1}}const Ir={step:null,path:[],together:0};function zc({part:e,copy:t},s){return{part:e,copy:t,index:s,fixed:!1,...Ir}}function Ps(e,t){return t.reduce((s,{part:n})=>s+(e.parts[n]?.volume??0),0)}function Rc(e,t){let s=[...e.leftOver];for(const n of t){const i=n.transform===null;i&&!as(e,n)||(s=i?Uc(s,n):s.flatMap(a=>Bc(a,n)))}return s}function Uc(e,{part:t,copy:s}){const n=e.find(a=>a.part===t&&a.byHand);return[n?{...n,copies:n.copies+1,which:[...n.which,s]}:{part:t,reason:"not_tried",copies:1,detail:Nr,which:[s],byHand:!0},...e.filter(a=>a!==n)]}function Bc(e,{part:t,copy:s}){if(e.part!==t||!e.which.includes(s))return[e];const n=e.which.filter(i=>i!==s);return n.length>0?[{...e,which:n,copies:n.length}]:[]}const Hc=e=>new Set(et(`locks.${e}`,[])),qc=(e,t)=>it(`locks.${e}`,[...t]);function Ys(e){const[t=1,s=0,n=0]=e.split("/").map(Number);return{tray:t,part:s,copy:n}}function la(e,t,s){const n=new Set(e);for(const i of t)s?n.add(Ut(i)):n.delete(Ut(i));return n.size===e.size?e:n}function Wc(e,t){return[...e].map(Ys).filter(s=>t===0||s.tray===t)}function vi(e,t,s=null){return(t===0?e.trays:e.trays.filter(i=>i.number===t)).flatMap(i=>i.placements.filter(a=>s===null||a.part===s).map(a=>({tray:i.number,part:a.part,copy:a.copy})))}function Vc(e,t){const s=[...e].filter(n=>{const{tray:i,part:a,copy:r}=Ys(n);return t.trays[i-1]?.byId.has(`${a}/${r}`)});return s.length===e.size?e:new Set(s)}function Kc(e,t,s){const n=new Set;for(const i of e){const{tray:a,part:r,copy:o}=Ys(i),c=t.trays[a-1]?.byId.get(`${r}/${o}`),h=c&&s.trays[a-1]?.placements.find(u=>Jc(t,c,s,u));h&&n.add(Ut({tray:a,part:h.part,copy:h.copy}))}return n}const Gc=1e-4;function Jc(e,t,s,n){const[i,a]=[e.parts[t.part],s.parts[n.part]];return!i||!a||i.file!==a.file||i.object!==a.object?!1:t.transform.every((r,o)=>r.every((c,h)=>Math.abs(c-(n.transform[o]?.[h]??Number.NaN))<Gc))}const Yc={left:"left wall",right:"right wall",front:"front wall",back:"back wall",bottom:"bottom",top:"top"};function zr(e,t){const{nearest:s,wall:n}=e;if(e.clear)return{tone:"ok",bold:"It may stand here.",text:"Every gap is kept."};const i=n?n.gap-n.distance:0,a=s?s.gap-s.distance:0;if(n&&i>0&&i>=a)return Zc(n);if(s&&a>0){const r=t(s);return s.distance<=0?{tone:"bad",bold:`Touches ${r}.`,text:Qc(s.gap)}:{tone:"bad",bold:`Too close to ${r}.`,text:Rr(s.distance,s.gap)}}return{tone:"bad",bold:"It cannot stand here.",text:"It reaches out of the tray or into a keep-out."}}function Zc({side:e,distance:t,gap:s}){const n=Yc[e]??e;return t<0?{tone:"bad",bold:"Outside the tray.",text:`It sticks out at the ${n} by ${Ss(-t,1)}.`}:{tone:"bad",bold:`Too close to the ${n}.`,text:Rr(t,s)}}function Xc(e,t,s){if(s)return{tone:"bad",bold:"Outside the tray.",text:"It sticks out of the tray."};const[n]=e,i=e.length-1,a=i>0?` and ${i} more`:"";return{tone:"bad",bold:`Touches ${n?t(n):"another copy"}${a}.`,text:"The gap is measured."}}const Ss=(e,t)=>`${e.toFixed(t)}${L}mm`,Qc=e=>e>0?`A gap of ${Ss(e,1)} is asked for.`:"Move it farther away.";function Rr(e,t){const s=[1,2,3].find(n=>e.toFixed(n)!==t.toFixed(n))??4;return`The gap is ${Ss(e,s)}; ${Ss(t,s)} is asked for.`}function th(e){const t=Math.abs(e).toFixed(1);return t==="0.0"?t:`${e<0?"−":"+"}${t}`}const eh=120,ca=600;class sh{constructor(t){this.asking=t,this.wanted=null,this.flight=null,this.stopper=new AbortController}want(t){this.wanted=t,clearTimeout(this.timer),this.timer=setTimeout(()=>void this.next(),eh)}async now(t){this.wanted=null,clearTimeout(this.timer),await this.flight;const{signal:s}=this.stopper;for(;;)try{return await this.asking.ask(t,s)}catch(n){if(s.aborted||!this.isLater(n))throw n;await new Promise(i=>setTimeout(i,ca))}}stop(){this.wanted=null,clearTimeout(this.timer),this.stopper.abort(),this.stopper=new AbortController}async next(){const t=this.wanted;this.flight||!t||(this.wanted=null,this.flight=this.once(t,this.stopper.signal),await this.flight,this.flight=null,this.wanted&&(this.timer=setTimeout(()=>void this.next(),this.wanted===t?ca:0)))}async once(t,s){try{const n=await this.asking.ask(t,s);s.aborted||this.asking.answered(t,n)}catch(n){if(s.aborted)return;this.isLater(n)?this.wanted??=t:this.asking.waits(n instanceof Error?n.message:"It could not be measured.")}}isLater(t){return t instanceof Ct?(t.status===409&&this.asking.waits("The change before is checked first; then the gap is measured."),[0,409,429,503].includes(t.status)):!1}}const ha=.1,ua=64,nh=14;async function ih(e){const t=ha/Math.max(ha,e.length);let s=ah(e,t),n=0,i=1;for(let a=0;a<nh&&i-n>t;a+=1)await e.mayStand(s)?n=s:i=s,s=(n+i)/2;return n}function ah(e,t){let s=1,n=1;for(let i=ua;i>=0&&(n=i/ua,!e.touchesNothing(n));i-=1)s=n;for(;s-n>t;){const i=(n+s)/2;e.touchesNothing(i)?n=i:s=i}return n}const U=(e,t,s)=>e[t]?.[s]??0;function Ur(e){const t=[0,1,2].map(s=>Math.hypot(U(e,0,s),U(e,1,s),U(e,2,s))||1);return[0,1,2].map(s=>[0,1,2].map(n=>U(e,s,n)/(t[n]??1)))}function rh(e,t){const[s,n,i]=t,a=(n-s+3)%3===1?1:-1,r=Math.max(-1,Math.min(1,-a*U(e,i,s))),o=Math.asin(r);return Math.abs(r)>1-1e-9?[0,o,Math.atan2(-a*U(e,s,n),U(e,n,n))]:[Math.atan2(a*U(e,i,n),U(e,i,i)),o,Math.atan2(a*U(e,n,s),U(e,s,s))]}const oh=[[0,1,2],[2,0,1],[1,2,0],[0,2,1],[1,0,2],[2,1,0]];function In(e){const t=Ur(e);let s=null;for(const n of oh){const i=rh(t,n).map((a,r)=>({degrees:Math.round(a*180/Math.PI),axis:"XYZ"[n[r]??0]??""})).filter(({degrees:a})=>a%360!==0).map(({degrees:a,axis:r})=>`${a===-180?180:a}° about ${r}`);(!s||i.length<s.length)&&(s=i)}return s?.length?`turned ${s.join(", then ").replaceAll("-","−")}`:"as drawn"}function lh(e,t,s,n,i){return U(e,i,0)*t+U(e,i,1)*s+U(e,i,2)*n+U(e,i,3)}function ch(e){return Ur(e).every(t=>t.every(s=>Math.abs(s)<1e-9||Math.abs(s)>1-1e-9))}function Zs(e,t,s){const n=[1/0,1/0,1/0],i=[-1/0,-1/0,-1/0],a=(r,o,c)=>{for(let h=0;h<3;h+=1){const u=lh(e,r,o,c,h);u<(n[h]??0)&&(n[h]=u),u>(i[h]??0)&&(i[h]=u)}};if(s&&s.length>0&&!ch(e))for(let r=0;r+2<s.length;r+=3)a(s[r]??0,s[r+1]??0,s[r+2]??0);else for(let r=0;r<8;r+=1)a(U(t,r&1,0),U(t,r>>1&1,1),U(t,r>>2&1,2));return{low:n,high:i}}function hh(e){const t=e.map(uh).filter((s,n,i)=>s!==i[n-1]);return t.length===0?"it stands alone by then":t.length>3?`${t.length} moves, last ${t[t.length-1]}`:t.join(", then ")}function uh(e){const[t=0,s=0,n=0]=e,i=Math.max(Math.abs(t),Math.abs(s),Math.abs(n));return Math.abs(n)===i?n>0?"up":"down":Math.abs(t)===i?t>0?"to the right":"to the left":s>0?"to the back":"to the front"}function da(e,t,s){const n=t.box.map(i=>i.map(a=>a/t.unit));return Zs(e,n,s?.positions??null)}function Re(e,t){return e.map((s,n)=>n<3?[...s.slice(0,3),(s[3]??0)+(t[n]??0)]:s)}function dh(e,t,s){return t.map((n,i)=>i<3?[...n.slice(0,3),(e[i]?.[3]??0)*(1-s)+(n[3]??0)*s]:n)}function Br(e,t){return e.every((s,n)=>s.slice(0,3).every((i,a)=>Math.abs(i-(t[n]?.[a]??0))<1e-9))}function ph(e,t){return e===null||t===null?e===t:Br(e,t)&&e.every((s,n)=>Math.abs((s[3]??0)-(t[n]?.[3]??0))<1e-7)}function fh(e,t){const s=n=>(t[n]?.[3]??0)-(e[n]?.[3]??0);return[s(0),s(1),s(2)]}const mh={x:[1,2],y:[2,0],z:[0,1]};function gh(e,t,s){const n=Re(e,[-s[0],-s[1],-s[2]]),[i,a]=mh[t],r=n.map((o,c)=>c===i?(n[a]??[]).map(h=>-h):c===a?n[i]??[]:o);return Re(r,s).map(o=>o.map(c=>Object.is(c,-0)?0:c))}function $h({low:e,high:t}){return[(e[0]+t[0])/2,(e[1]+t[1])/2,(e[2]+t[2])/2]}function bh(e,t,s=0){return e.low.every((n,i)=>n<(t.high[i]??0)+s&&(t.low[i]??0)<(e.high[i]??0)+s)}const vh=[[1,0,0],[-1,0,0],[0,1,0],[0,-1,0],[0,0,1],[0,0,-1]],yh=.5,wh=1.12,kh=400,xh=24;async function Mh(e,t){let s=0;for(let n=yh;n<kh;n*=wh)for(const[i,a,r]of vh){const o=Re(e,[i*n,a*n,r*n]);if(t.touchesNothing(o)){if(s+=1,await t.mayStand(o))return o;if(s>=xh)return null}}return null}const _h=(function(){const t=typeof document<"u"&&document.createElement("link").relList;return t&&t.supports&&t.supports("modulepreload")?"modulepreload":"preload"})(),Oh=function(e,t){return new URL(e,t).href},pa={},$e=function(t,s,n){let i=Promise.resolve();if(s&&s.length>0){let r=function(u){return Promise.all(u.map(p=>Promise.resolve(p).then(f=>({status:"fulfilled",value:f}),f=>({status:"rejected",reason:f}))))};const o=document.getElementsByTagName("link"),c=document.querySelector("meta[property=csp-nonce]"),h=c?.nonce||c?.getAttribute("nonce");i=r(s.map(u=>{if(u=Oh(u,n),u in pa)return;pa[u]=!0;const p=u.endsWith(".css"),f=p?'[rel="stylesheet"]':"";if(!!n)for(let y=o.length-1;y>=0;y--){const M=o[y];if(M.href===u&&(!p||M.rel==="stylesheet"))return}else if(document.querySelector(`link[href="${u}"]${f}`))return;const v=document.createElement("link");if(v.rel=p?"stylesheet":_h,p||(v.as="script"),v.crossOrigin="",v.href=u,h&&v.setAttribute("nonce",h),document.head.appendChild(v),p)return new Promise((y,M)=>{v.addEventListener("load",y),v.addEventListener("error",()=>M(new Error(`Unable to preload CSS for ${u}`)))})}))}function a(r){const o=new Event("vite:preloadError",{cancelable:!0});if(o.payload=r,window.dispatchEvent(o),!o.defaultPrevented)throw r}return i.then(r=>{for(const o of r||[])o.status==="rejected"&&a(o.reason);return t().catch(a)})},Hr=()=>$e(()=>import("./tray_view-DwAAxWLF.js"),__vite__mapDeps([0,1,2,3,4]),import.meta.url),Ph=()=>$e(()=>import("./part_view-BPK0-W8h.js"),__vite__mapDeps([5,1,2,3]),import.meta.url),Sh=()=>$e(()=>import("./thumbnails-37d3PiEK.js"),__vite__mapDeps([6,1,3]),import.meta.url),Th=()=>$e(()=>import("./bundle-D8DdDFnV.js"),[],import.meta.url),Ah=()=>$e(()=>import("./clash-Cntwv0wL.js"),__vite__mapDeps([7,1,4]),import.meta.url);class Ch{constructor(t,s,n,i,a){this.packing=t,this.meshes=s,this.changed=a,this.fine=new Map,this.asked=new Set,this.touches=null;const r=new Map(n.map(o=>[o.index,o.mesh]));this.mesh=r.get(i.part)??null,this.neighbours=(t.trays[i.tray-1]?.placements??[]).flatMap(o=>{const c=r.get(o.part);return!c||_(o)===_(i)?[]:[{placement:o,mesh:c,extent:da(o.transform,c,s.mesh(c))}]}),Ah().then(o=>{this.touches=o.touches,a()})}extent(t){return this.mesh&&da(t,this.mesh,this.meshes.mesh(this.mesh))}isOutside(t){const s=this.extent(t);if(!s)return!1;const n=1e-6;return s.low.some(i=>i<-n)||s.high.some((i,a)=>i>this.end(a)+n)}touching(t){const{mesh:s,touches:n}=this,i=this.extent(t);if(!s||!i||!n)return[];const a=this.dataOf(s);return a?this.neighbours.filter(r=>bh(i,r.extent)).filter(r=>{const o=this.dataOf(r.mesh);return o&&n({mesh:a,transform:t},{mesh:o,transform:r.placement.transform})}).map(({placement:r})=>({part:r.part,copy:r.copy})):[]}end(t){return t===2&&this.packing.openHeight?1/0:this.packing.size[t]??0}dataOf(t){return this.asked.has(t)||(this.asked.add(t),this.meshes.fine(t).then(s=>{s&&(this.fine.set(t,s),this.changed())})),this.fine.get(t)??this.meshes.mesh(t)}}const jh=[],Mn={copy:null,from:null,transform:jh,touching:[],outside:!1,clearance:null,wait:null,seeking:!1,placing:!1};class Eh{constructor(t,s,n){this.session=t,this.unsent=s,this.placed=n,this.state=new Z(Mn),this.around=null,this.lastClear=null,this.grabbed=null,this.looking=0,this.asker=new sh({ask:(i,a)=>this.ask(i,a),answered:(i,a)=>this.answered(i,a),waits:i=>this.state.set({wait:i,placing:!1})})}get active(){return this.state.value.copy!==null}get moved(){const{copy:t,from:s,transform:n}=this.state.value;return t!==null&&!ph(s,n)}begin(t,s=null){const{packing:n}=this.session.run.state.value,i=as(n,t)?.transform??null,a=i??s;!n||!a||(this.end(),this.around=new Ch(n,this.session.meshes,Ks(this.session,n),t,()=>this.lookSoon()),this.lastClear=i,this.session.build.set({selected:[{part:t.part,copy:t.copy}],section:null,find:null}),this.state.set({...Mn,copy:t,from:i,transform:a}),this.to(a))}end(){this.asker.stop(),cancelAnimationFrame(this.looking),this.looking=0,this.around=null,this.grabbed=null,this.state.set(Mn)}to(t){this.active&&(this.state.set({transform:t,clearance:null,wait:null,placing:!1}),this.lookSoon(),this.asker.want(t))}shift(t){this.state.value.seeking||this.to(Re(this.state.value.transform,t))}dragged(t,s){this.grabbed??=this.state.value.transform;const n=this.grabbed;s&&(this.grabbed=null),this.to(Re(n,t))}turn(t){const{transform:s,seeking:n}=this.state.value,i=this.around?.extent(s);i&&!n&&this.to(gh(s,t,$h(i)))}extent(t){return this.around?.extent(t)??null}place(){const{copy:t,transform:s,clearance:n,touching:i,outside:a,seeking:r}=this.state.value;!t||r||(this.moved?n?.clear?(this.end(),this.placed(t,s)):!n&&i.length===0&&!a?this.state.set({placing:!0}):Rt(this.sentence()):this.end())}async seek(){const{copy:t,from:s,transform:n,seeking:i}=this.state.value,{around:a}=this;if(!(!t||!a||i)){this.state.set({seeking:!0});try{const r=await this.along(a,n)??await this.outwards(a,n)??s;if(this.state.value.copy!==t)return;this.state.set({seeking:!1}),r?this.to(r):this.state.set({wait:"No free place was found near it. Move it by hand."})}catch{this.state.value.copy===t&&this.state.set({seeking:!1})}}}async along(t,s){const n=this.lastClear;if(!n||!Br(n,s))return null;const i=r=>dh(n,s,r),a=await ih({length:Math.hypot(...fh(n,s)),touchesNothing:r=>t.touching(i(r)).length===0&&!t.isOutside(i(r)),mayStand:r=>this.mayStand(i(r))});return i(a)}async outwards(t,s){return Mh(s,{touchesNothing:n=>t.touching(n).length===0&&!t.isOutside(n),mayStand:n=>this.mayStand(n)})}async mayStand(t){return(await this.asker.now(t)).clear}ask(t,s){const n=this.state.value.copy;return T.askClearance(this.session.id,{...n,transform:t},this.unsent(),s)}answered(t,s){if(t!==this.state.value.transform)return;s.clear&&(this.lastClear=t);const{placing:n}=this.state.value;this.state.set({clearance:s,wait:null,placing:!1}),n?this.place():s.clear||Rt(this.sentence())}sentence(){const{clearance:t}=this.state.value;if(!t)return"It touches another copy.";const{bold:s,text:n}=zr(t,i=>this.nameOf(i));return`${s} ${n}`}nameOf({part:t,copy:s}){return`${this.session.run.state.value.packing?.parts[t]?.name??"copy"} ${s+1}`}lookSoon(){this.looking===0&&(this.looking=requestAnimationFrame(()=>{this.looking=0;const{around:t}=this;if(!t||!this.active)return;const{transform:s}=this.state.value;this.state.set({touching:t.touching(s),outside:t.isOutside(s)})}))}}function Lh(e,t,s){const n=Object.entries(et(`places.${e}`,{}));for(const i of s){const a=as(t,i)?.transform,r=t.parts[i.part]?.name;a&&r!==void 0&&n.push([_(i),{tray:i.tray,transform:a,name:r}])}it(`places.${e}`,Object.fromEntries(n.slice(-300)))}function Nh(e,t,s,n){const i=et(`places.${e}`,{})[_(s)];if(i&&i.name===t.parts[s.part]?.name&&t.trays[i.tray-1])return{change:{tray:i.tray,part:s.part,copy:s.copy,transform:i.transform},known:!0};const a=t.trays.flatMap(o=>o.placements.filter(({part:c})=>c===s.part).map(c=>({tray:o.number,placement:c})))[0],r=a?.placement.transform??Dh(t,s.part,n);return{change:{tray:a?.tray??1,part:s.part,copy:s.copy,transform:r},known:!1}}function Dh(e,t,s){const n=e.parts[t]?.volume??0;if(!s||s.volume<=0||n<=0)return null;const i=Math.cbrt(n/s.volume),a=i*s.unit,r=(s.box[0]??[]).map(c=>c*i),o=c=>[0,1,2].map(h=>h===c?a:0).concat(-(r[c]??0));return[o(0),o(1),o(2),[0,0,0,1]]}const Fh=1500,Ih=new Set([0,409,429,503]);class zh{constructor(t){this.host=t,this.waiting=[],this.sent=[],this.checking=[]}get pending(){return ie(ie(this.checking,this.sent),this.waiting)}get unsent(){return ie(this.sent,this.waiting)}add(t){this.waiting=ie(this.waiting,t),this.host.changed(),this.next()}loaded(){this.checking=[]}async next(){if(clearTimeout(this.timer),!(this.sent.length>0||this.waiting.length===0||!this.host.free())){this.sent=this.waiting,this.waiting=[],this.host.sending();try{await this.host.send(this.sent),this.checking=ie(this.checking,this.sent),this.sent=[],this.host.taken(),this.host.changed()}catch(t){this.failed(t)}}}stop(){clearTimeout(this.timer)}drop(){this.waiting=[],this.sent=[],this.checking=[],this.host.changed()}failed(t){if(t instanceof Ct&&Ih.has(t.status)){this.waiting=ie(this.sent,this.waiting),this.sent=[],this.timer=setTimeout(()=>void this.next(),Fh);return}this.waiting=[],this.sent=[],this.host.refused(t instanceof Error?t.message:"The change was refused."),this.host.changed()}}class Rh{constructor(t,s,n){this.session=t,this.history=s,this.box=n,this.running=null,this.goal=null}begins(t){const{job:s}=this.session,n=this.session.run.state.value.stored;this.running=null,!(!n||(s.revision??null)===null)&&(this.running={entry:{kind:"pack",before:this.revisionNow(s.revision??0),after:null},before:n,how:t})}started(t,s){t?this.running?this.history.push(this.running.entry):this.history.restore({past:[],future:[]}):this.running=null,t&&s==="anew"&&this.box.setLocks(new Set)}async revert(t,s){const{session:n}=this;this.goal=t,!await nt(async()=>(await n.run.start("change",()=>T.revert(n.id,t.number)),!0))&&(this.goal=null,s())}arrived(t){this.running&&this.settle(t),this.goal&&(this.goal.packed!==null&&it(`packed.${this.session.id}`,this.goal.packed),this.box.setLocks(this.goal.locks),this.goal=null)}settle(t){const{job:s}=this.session,n=this.running;if(this.running=null,n?.entry.kind!=="pack")return;const{before:i}=n.entry;if(!t||s.revision===i.number||s.revision===null){this.history.replace(n.entry,null),this.box.setLocks(i.locks);return}n.how==="keeps"&&this.box.setLocks(Kc(i.locks,n.before,t)),this.history.replace(n.entry,{...n.entry,after:this.revisionNow(s.revision)})}revisionNow(t){return{number:t,locks:this.box.locks(),packed:et(`packed.${this.session.id}`,null)}}}class Uh{constructor(t){this.session=t,this.history=new Dc,this.taken=this.history.now,this.sending=this.history.now,this.wasRunning=!1,this.state=new Z({locks:Hc(t.id),version:0,waits:!1}),this.queue=new zh({free:()=>!E(t.job)&&t.run.state.value.stored!==null&&!t.run.state.value.loading,send:s=>t.run.start("change",()=>T.change(t.id,s)),changed:()=>{this.state.set({waits:this.queue.unsent.length>0}),t.run.show()},sending:()=>{this.sending=this.history.now},taken:()=>{this.taken=this.sending},refused:s=>this.refused(s)}),this.repacks=new Rh(t,this.history,{locks:()=>this.state.value.locks,setLocks:s=>this.setLocks(s)}),this.move=new Eh(t,()=>this.queue.unsent,(s,n)=>this.change([{...s,transform:n}])),t.run.overlay=s=>oa(s,this.queue.pending),t.run.arrived=s=>this.arrived(s),t.run.state.subscribe(()=>this.followRun())}close(){this.queue.stop(),this.move.end()}get shown(){return this.session.run.state.value.packing}get unchecked(){return this.state.value.waits||this.move.moved||this.session.run.checking}remove(t){const{shown:s}=this,n=t.filter(u=>!this.isLocked(u)&&as(s,u));if(!s||n.length===0){t.length>0&&Rt("Locked copies stay. Unlock them first.");return}Lh(this.session.id,s,n),this.change(n.map(u=>({...u,transform:null})));const i=new Set(n.map(Ut)),{build:a}=this.session,r=Math.max(1,a.value.tray);a.set({selected:a.value.selected.filter(u=>!i.has(Ut({tray:r,...u})))});const[o]=n,c=o&&n.length===1?this.move.nameOf(o):`${n.length} copies`,h=this.history.last;Os(`${c} ${n.length===1?"is":"are"} taken out.`,()=>{this.history.last===h&&this.undo()})}putBack(t){const s=t.map(n=>this.placeOf(n));s.every(n=>n?.known)?this.change(s.flatMap(n=>n?[n.change]:[])):t[0]&&this.placeByHand(t[0])}placeByHand(t){const s=this.placeOf(t)?.change;if(!s?.transform)return;const{build:n}=this.session;n.value.tray!==s.tray&&n.set({tray:s.tray,follow:!1}),this.move.begin(s,s.transform)}placeOf(t){const{shown:s,session:n}=this;if(!s)return null;const i=Ks(n,s).find(a=>a.index===t.part)?.mesh??null;return Nh(n.id,s,t,i)}change(t){const{shown:s}=this;if(!s||t.length===0)return;const n=this.state.value.locks,i=t.filter(r=>r.transform===null),a=la(n,i,!1);this.history.push({kind:"changes",does:t,undoes:Fc(s,t),before:n,after:a}),this.setLocks(a),this.queue.add(t)}refused(t){this.move.end(),this.history.restore(this.taken),this.count(),ce(Fr(t,this.session.run.state.value.stored))}isLocked(t){return this.state.value.locks.has(Ut(t))}lock(t,s){const n=this.state.value.locks,i=la(n,t,s);i!==n&&(this.history.push({kind:"locks",before:n,after:i}),this.setLocks(i))}toggleLock(t){t.length>0&&this.lock(t,!t.every(s=>this.isLocked(s)))}setLocks(t){qc(this.session.id,t),this.state.set({locks:t}),this.count()}get canUndo(){return this.can(this.history.last,"before")}get canRedo(){return this.can(this.history.next,"after")}can(t,s){if(!t||this.session.run.packs||this.move.active)return!1;if(t.kind!=="pack")return!0;const n=t[s]?.number;return!this.unchecked&&n!==void 0&&(this.session.job.revisions??[]).includes(n)}async undo(){if(!this.canUndo)return;const t=this.history.undo();t?.kind==="changes"?this.again(t.undoes,t.before):t?.kind==="locks"?this.setLocks(t.before):t&&await this.revert(t.before,()=>this.history.redo())}async redo(){if(!this.canRedo)return;const t=this.history.redo();t?.kind==="changes"?this.again(t.does,t.after):t?.kind==="locks"?this.setLocks(t.after):t?.after&&await this.revert(t.after,()=>this.history.undo())}async revert(t,s){await this.repacks.revert(t,s),this.count()}again(t,s){this.setLocks(s),this.queue.add(t)}count(){this.state.set({version:this.state.value.version+1})}packs(t){this.move.end(),this.repacks.begins(t)}started(t,s){this.repacks.started(t,s),this.count()}arrived(t){const{job:s}=this.session;if(s.status==="failed"&&this.queue.pending.length>0&&(this.queue.drop(),this.refused(s.error??"The change could not be checked.")),this.queue.loaded(),this.repacks.arrived(t),t){const n=Vc(this.state.value.locks,oa(t,this.queue.pending));n!==this.state.value.locks&&this.setLocks(n)}this.taken=this.history.now,this.count(),queueMicrotask(()=>void this.queue.next())}followRun(){const{run:t}=this.session,s=t.packs;s&&!this.wasRunning&&this.move.end(),this.wasRunning=s,E(t.state.value.job)||this.queue.next()}}const Bh={tray:1,follow:!0,colouring:"part",section:null,selected:[],hiddenParts:new Set,hiddenCopies:new Set,isolated:null,find:null},Hh=()=>new Z(Bh);function qr(e,t){const s=_(t);return e.isolated&&!e.isolated.has(s)?!0:e.hiddenParts.has(t.part)||e.hiddenCopies.has(s)}function qh(e){return e.isolated!==null||e.hiddenParts.size>0||e.hiddenCopies.size>0}const Wr={hiddenParts:new Set,hiddenCopies:new Set,isolated:null};function Wh(e,t){const s=new Set(e.hiddenParts);return s.delete(t)||s.add(t),{hiddenParts:s}}function Vr(e){return e.selected.length===0?{}:{hiddenCopies:new Set([...e.hiddenCopies,...e.selected.map(_)]),selected:[]}}function Kr(e){return e.isolated?{isolated:null}:e.selected.length>0?{isolated:new Set(e.selected.map(_))}:{}}function Vh(e,t){const s=e.filter(n=>_(n)!==_(t));return s.length<e.length?s:[...e,t]}const $s=[{value:"part",text:"Part"},{value:"order",text:"Order"},{value:"height",text:"Height"},{value:"way",text:"Way out"}];function Kh(e){const t=$s.findIndex(s=>s.value===e);return $s[(t+1)%$s.length]?.value??"part"}function Ts(e,t,s){return{...e,parts:e.parts.map(n=>t.has(n.key)?{...n,...s}:n)}}function Xs(e,t){return{...e,parts:e.parts.filter(s=>!t.has(s.key))}}function Gh(e,t,s){return e.parts.some(n=>n.file===t)?{...e,parts:e.parts.map(n=>n.file===t?{...n,file:s}:n)}:e}function Gr(e,t){return t.length===0?e:{...e,parts:[...e.parts,...t]}}function zn(e,t){const s={...e,tray:t};return t.kind==="mesh"?{...s,openHeight:!1,goal:e.goal==="box"?"fill":e.goal}:s}function Jh(e,t){const s={...e,keepOut:[...e.keepOut,t],openHeight:!1};return Tr(s)||s.goal!=="box"?s:{...s,goal:"fill"}}function Vt(e,t,s){if(t==="height-at"&&s==="top")return{...ma(e,t),goal:"lowest"};const n=t==="height-at"&&e.goal==="lowest"?{...e,goal:"fill"}:e;return s===void 0?ma(n,t):{...n,options:{...n.options,[t]:s}}}function fa(e,t){return t==="height-at"&&e.goal==="lowest"?"top":e.options[t]}function ma(e,t){const{[t]:s,...n}=e.options;return{...e,options:n}}const Yh=/\.(stl|3mf|obj|ply|off|csv|json)$/i,Zh={step:"STEP",stp:"STEP",iges:"IGES",igs:"IGES",sldprt:"SolidWorks",ipt:"Inventor",f3d:"Fusion",x_t:"Parasolid",x_b:"Parasolid",sat:"ACIS","3dm":"Rhino",fcstd:"FreeCAD",amf:"AMF",glb:"glTF",gltf:"glTF",dae:"Collada",fbx:"FBX",blend:"Blender"};function Xh(e,t){const s=[],n=[],i=new Set;for(const{file:a,path:r}of e){const o=r.split("/"),c=o.pop()??r;if(c.startsWith("."))continue;if(!Yh.test(c)){const u=Qh(c,o.length>0);u&&n.push({file:c,error:u});continue}if(a.size>t){n.push({file:c,error:"The file is larger than this server takes. Make it coarser, or raise the limit."});continue}const h=tu(Jr(c),o,i);i.add(h),s.push({file:a,name:h})}return{files:s,refused:n}}function Qh(e,t){const s=e.split(".").pop()?.toLowerCase()??"",n=Zh[s];return n?`${n} files are not read. Export it as 3MF or STL.`:t?null:"Files of this kind are not read. STL, 3MF, OBJ, PLY and OFF are."}function Jr(e){const t=e.replace(/[\u0000-\u001f\u007f/\\]/g,"_");return t.length<=160?t:t.slice(0,100)+t.slice(-60)}function tu(e,t,s){let n=e;for(let i=t.length-1;i>=0&&s.has(n);i-=1)n=Jr(`${t.slice(i).join("-")}-${e}`);for(let i=2;s.has(n);i+=1)n=e.replace(/(\.[^.]*)$/,`-${i}$1`);return n}function eu(e,t){const s=e.map(({path:c})=>c.includes("/")?c.split("/")[0]:"").find(c=>c);if(s)return As(s);const n=c=>c.replace(/\.[^.]*$/,""),a=e.find(({file:c})=>/\.(csv|json)$/i.test(c.name))??(e.length===1?e[0]:void 0);if(a)return As(n(a.file.name))||"Build";const r=c=>c.toString().padStart(2,"0");return`Build ${`${t.getFullYear()}-${r(t.getMonth()+1)}-${r(t.getDate())}`} ${r(t.getHours())}:${r(t.getMinutes())}`}function As(e){let t=e.trim();for(;new TextEncoder().encode(t).length>100;)t=[...t].slice(0,-1).join("");return t}class su{constructor(t,s=()=>Date.now(),n=1200,i=200){this.document=t,this.now=s,this.closely=n,this.most=i,this.past=[],this.future=[],this.tag="",this.at=0}get value(){return this.document}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}change(t,s=""){if(t===this.document)return;const n=this.now();s!==""&&s===this.tag&&n-this.at<this.closely&&this.past.length>0||(this.past.push(this.document),this.past.length>this.most&&this.past.shift()),this.tag=s,this.at=n,this.future=[],this.document=t}undo(){const t=this.past.pop();t!==void 0&&(this.future.push(this.document),this.document=t,this.tag="")}redo(){const t=this.future.pop();t!==void 0&&(this.past.push(this.document),this.document=t,this.tag="")}reset(t){this.past=[],this.future=[],this.tag="",this.document=t}}const ga=64,nu=16,iu=96,au=5e3;function mt(e){return`${e.file}#${e.object??""}:${e.triangles}:${e.volume}:${e.size.join(",")}`}class ru{constructor(t){this.job=t,this.state=new Z({version:0}),this.loaded={rough:new Map,coarse:new Map},this.asked={rough:new Map,coarse:new Map},this.finer=new Map,this.drawn=new Map,this.latest=new Map,this.wishes=new Map,this.drawing=!1,this.holds=new Set}mesh(t,s){const n=mt(t),{rough:i,coarse:a}=this.loaded;return(s?this.loaded[s].get(n):a.get(n)??i.get(n))??null}async load(t,s="coarse"){const n=this.asked[s],i=new Map(t.map(r=>[mt(r),r])),a=[...i].filter(([r])=>!n.has(r)).map(([,r])=>r);for(let r=0;r<a.length;r+=ga)this.fetch(a.slice(r,r+ga),s);await Promise.allSettled([...i.keys()].map(r=>n.get(r)))}fine(t){const s=mt(t);let n=this.finer.get(s);return n||(n=this.bundle("fine",[t.id]).then(i=>i[0]??null,()=>(this.finer.delete(s),null)),this.finer.set(s,n)),n}picture(t,s,n){const i=`${mt(t)}|${s}|${n}`,a=this.drawn.get(i);return a===void 0&&!this.wishes.has(i)&&(this.wishes.set(i,{mesh:t,colour:s,theme:n}),this.draw()),a??this.latest.get(mt(t))??null}holdPictures(){let t=()=>{};const s=new Promise(n=>{t=n,setTimeout(n,au)});return this.holds.add(s),s.then(()=>this.holds.delete(s)),t}fetch(t,s){const n=this.asked[s],i=t.map(r=>r.id),a=this.bundle(s,i).then(r=>{const o=new Map(r.map(c=>[c.id,c]));for(const c of t){const h=o.get(c.id);h&&this.loaded[s].set(mt(c),h)}this.tell()});for(const r of t)n.set(mt(r),a);a.catch(()=>{for(const r of t)n.delete(mt(r))})}async bundle(t,s){const[{readBundle:n},i]=await Promise.all([Th(),T.meshes(this.job,t,s)]);return n(i)}async draw(){if(!this.drawing){this.drawing=!0;try{for(await new Promise(t=>setTimeout(t,30));this.wishes.size>0;)await Promise.all(this.holds),await this.drawBatch()}finally{this.drawing=!1}}}async drawBatch(){const[,t]=[...this.wishes].at(-1)??[],s=[...this.wishes].reverse().filter(([,r])=>r.theme===t?.theme).slice(0,nu);await this.load(s.map(([,r])=>r.mesh));const n=s.flatMap(([r,{mesh:o,colour:c}])=>{const h=this.mesh(o);return h?[{key:r,own:mt(o),mesh:h,colour:c}]:[]});for(const[r]of s)this.wishes.delete(r);if(n.length===0||!t)return;const{thumbnails:i}=await Sh(),a=await i(n,iu,t.theme);n.forEach(({key:r,own:o},c)=>{const h=a[c];h!==void 0&&(this.drawn.set(r,h),this.latest.set(o,h))}),this.tell()}tell(){this.state.set({version:this.state.value.version+1})}}function Rn(e,t=()=>!0){const s={format:"spectralpack/job",version:1,unit:e.unit},n=ou(e,t);n&&(s.container=n),e.openHeight&&(s.open_height=!0),e.trays!==1&&!ns(e)&&(s.trays=e.trays);const i=e.keepOut.filter(r=>"box"in r||t(r.mesh));i.length>0&&(s.keep_out=i.map(lu)),e.gap!==null&&(s.gap=e.gap),e.wallGap!==null&&(s.wall_gap=e.wallGap),e.fixed!==null&&(s.fixed=e.fixed),s.parts=e.parts.filter(r=>t(r.file)).map(cu);const a=uu(e);return Object.keys(a).length>0&&(s.options=a),s}function ou(e,t){const s=e.tray;if(s.kind==="mesh"){if(s.file===null||!t(s.file))return null;const i={mesh:s.file};return s.transform!==null&&(i.transform=s.transform),s.unit!==null&&(i.unit=s.unit),s.is!==null&&(i.is=s.is),e.physical&&(i.physical=!0),i}if(s.kind==="printer")return null;const n={size:e.openHeight&&s.size[2]===0?s.size.slice(0,2):s.size};return e.physical&&(n.physical=!0),n}function lu(e){if("box"in e)return{box:e.box};const t={mesh:e.mesh};return e.transform!==null&&(t.transform=e.transform),e.unit!==null&&(t.unit=e.unit),t}function cu(e){const t={};return e.name!==null&&(t.name=e.name),t.mesh=e.file,e.object!==null&&(t.object=e.object),t.count=e.count,e.scale!==1&&(t.scale=e.scale),e.unit!==null&&(t.unit=e.unit),e.stands.kind!=="any"&&(t.orientations=hu(e.stands)),e.gap!==null&&(t.gap=e.gap),e.priority!==0&&(t.priority=e.priority),e.due!==null&&(t.due=e.due),e.order!==null&&(t.order=e.order),e.value!==null&&(t.value=e.value),t}function hu(e){return e.kind==="axes"?e.yaw===null?{axes:e.axes}:{axes:e.axes,yaw:e.yaw}:e.kind==="matrices"?{matrices:e.matrices}:e.kind}function uu(e){const t={};e.tray.kind==="printer"&&(t.printer=e.tray.name),e.goal==="lowest"&&(t["height-at"]="top"),e.goal==="box"&&(t.minimise="box"),e.timeLimit!==null&&(t["time-limit"]=e.timeLimit),e.material!==""&&(t.material=e.material);for(const[s,n]of Object.entries(e.options))s==="improve"&&n==="rest"&&e.timeLimit===null||(t[s]=n);return t}function Yr(e){let t=2166136261;for(const s of JSON.stringify(Rn(e)))t=Math.imul(t^(s.codePointAt(0)??0),16777619);return(t>>>0).toString(16)}function Zr(e){const t=et("printer",null),s=e.printers.find(({name:n})=>n===t)??e.printers.find(({gap:n})=>n>0);return s?{kind:"printer",name:s.name}:null}function du(e){return{..._s,tray:Zr(e)??_s.tray}}function pu(e){try{return new TextDecoder("utf-8",{fatal:!0}).decode(e)}catch{return new TextDecoder("windows-1252").decode(e)}}function fu(e){const t=e.replace(/^\ufeff/,""),s=t.slice(0,t.search(/\r?\n|$/)),n=s.includes(";")&&!s.includes(",")?";":",",i=[];let a=[],r="",o=!1;const c=()=>{a.push(r),r=""},h=()=>{c(),a.some(u=>u.trim()!=="")&&i.push(a),a=[]};for(let u=0;u<t.length;u+=1){const p=t[u];o?p!=='"'?r+=p:t[u+1]==='"'?(r+='"',u+=1):o=!1:p==='"'&&r===""?o=!0:p===n?c():p===`
`?h():p!=="\r"&&(r+=p)}return(r!==""||a.length>0)&&h(),i}function mu(e,t,s){const[n,...i]=fu(e),a=n?.map(c=>c.trim().toLowerCase());if(!a?.some(c=>c==="mesh"||c==="file"))return null;const r=new Set(s),o=[];for(const c of i){const h=(...f)=>{const m=a.findIndex(v=>f.includes(v));return(c[m]??"").trim()},u=h("mesh","file");if(u==="")continue;const p=Wt(u);for(const f of $i(p,null,t)){const m=Js(p,f,r);r.add(m);const v=Gs(p,f,m);o.push({...v,name:h("name")||null,count:Math.max(1,Math.round(gt(h("count","quantity"))??1)),scale:gt(h("scale"))??1,unit:is(h("unit").toLowerCase()),gap:gt(h("gap")),priority:gt(h("priority"))??0,due:h("due")||null,value:gt(h("value")),stands:gu(h("orientations"))})}}return o}function gu(e){const t=e.toLowerCase().split(/\s+/).filter(Er);return t.length>0?{kind:"axes",axes:t,yaw:null}:jr(e.toLowerCase())}function $u(e,t,s){const n=new Set(s);return e.rows.flatMap(i=>$i(Wt(i.mesh),null,t).map(a=>{const r=Wt(i.mesh),o=Js(r,a,n);n.add(o);const{name:c,count:h,scale:u,gap:p,priority:f,due:m}=i;return{...Gs(r,a,o),name:c||null,count:h,scale:u,gap:p,priority:f,due:m}}))}function Un(e){return new Set([...e.meshes.map(t=>t.file),...e.bad.map(t=>t.file),...e.sets.map(t=>t.file)])}const bu=e=>/\.(csv|json)$/i.test(e);function vu(e,t,s,n){const i=t.sets.filter(r=>s.has(r.file));let a=e;for(const r of i)a=wu(a,r,t.meshes,n);return i.length>0?a:Gr(a,yu(a,t.meshes,s))}function yu(e,t,s){const n=new Set(e.parts.map(i=>i.key));return Qr(e,t).filter(i=>s.has(i.file)).map(i=>Xr(i,n))}function Xr(e,t){const s=Js(e.file,e.object,t);return t.add(s),{...Gs(e.file,e.object,s),count:Math.max(1,e.instances)}}function wu(e,t,s,n){if(t.kind==="job")return t.job?Cr(t.job,s):e;const i=n.get(t.file),a=new Set,r=(i===void 0?null:mu(i,s,a))??$u(t,s,a),o=new Map(r.map(u=>[u.key,u])),c=e.parts.map(u=>o.get(u.key)??u),h=new Set(e.parts.map(u=>u.key));return{...e,parts:[...c,...r.filter(u=>!h.has(u.key))]}}function Qr(e,t){const s=new Set;e.tray.kind==="mesh"&&e.tray.file!==null&&s.add(e.tray.file);for(const i of e.keepOut)"mesh"in i&&s.add(i.mesh);const n=new Set(e.parts.map(i=>`${i.file}
${i.object??""}`));return t.filter(i=>!s.has(i.file)&&!n.has(`${i.file}
${i.object??""}`))}const ku={reading:0,meshes:[],bad:[],sets:[]},xu=600;class Mu{constructor(t,s,n){this.job=t,this.sending=s,this.take=n,this.state=new Z({parts:ku,problem:null}),this.fresh=new Set,this.all=!1,this.timer=0,this.asking=!1,this.closed=!1}add(t){this.fresh.add(t),this.soon(150)}async refresh(){const t=await T.parts(this.job);return this.state.set({parts:t,problem:null}),t}addAll(){this.all=!0,this.soon(0)}soon(t){this.closed||this.asking||(clearTimeout(this.timer),this.timer=window.setTimeout(()=>void this.ask(),t))}close(){this.closed=!0,clearTimeout(this.timer)}async ask(){this.asking=!0;const t=new Set(this.fresh),s=this.sending();try{const n=await this.refresh();await this.handOn(n,t,s||this.sending())}catch(n){this.state.set({problem:Bt(n)})}finally{this.asking=!1,(this.state.value.parts.reading>0||this.fresh.size>0||this.sending())&&this.soon(xu)}}async handOn(t,s,n){const i=t.reading>0||n;if(this.all){if(i)return;for(const o of Un(t))this.fresh.add(o);this.all=!1}if(i&&[...this.fresh].some(bu))return;const a=Un(t),r=new Set([...this.fresh].filter(o=>a.has(o)));if(r.size>0){const o=await this.texts(t,r);for(const c of r)this.fresh.delete(c);this.take(t,r,o)}if(!i)for(const o of s)this.fresh.delete(o)}async texts(t,s){const n=new Map;for(const i of t.sets)if(!(i.kind!=="set"||!s.has(i.file)))try{n.set(i.file,pu(await T.fileBytes(this.job,i.file)))}catch{}return n}}const _u=()=>new Z({current:null,chosen:new Set,find:null,advanced:!1,inch:!1});function Ou(e,t){return e.chosen.has(t)?e.chosen:new Set([t])}const Pu=500,Su=700;class Tu{constructor(t,s){this.job=t,this.there=s,this.state=new Z({saving:!1,problem:null,estimate:null,estimating:!1,doubt:null}),this.saved="",this.stale=!0,this.draft=null,this.saveTimer=0,this.estimateTimer=0,this.asking=null,this.running=Promise.resolve(!0)}begin(t,s){this.draft=t,this.saved=s?this.textOf(t):"",this.state.set({problem:null,doubt:null})}look(){this.stale&&this.textOf(this.draft??_s)===this.saved&&this.askSoon()}change(t){if(this.draft=t,clearTimeout(this.saveTimer),this.textOf(t)===this.saved){this.stale&&this.askSoon();return}this.stale=!0,this.asking?.abort(),this.saveTimer=window.setTimeout(()=>void this.flush(),Pu)}textOf(t){return JSON.stringify(Rn(t,this.there))}flush(){return clearTimeout(this.saveTimer),this.running=this.running.then(()=>this.save()),this.running}close(){clearTimeout(this.estimateTimer),this.asking?.abort(),this.flush()}async save(){if(!this.draft)return!0;const t=Rn(this.draft,this.there),s=this.textOf(this.draft);if(s===this.saved)return this.state.set({problem:null}),!0;this.state.set({saving:!0});try{return await T.putJobFile(this.job,t),this.saved=s,this.stale=!0,this.state.set({saving:!1,problem:null}),this.askSoon(),!0}catch(n){return this.state.set({saving:!1,problem:Bt(n),estimate:null,estimating:!1}),!1}}askSoon(){if(clearTimeout(this.estimateTimer),this.asking?.abort(),!this.draft||this.draft.parts.length===0){this.state.set({estimate:null,estimating:!1,doubt:null});return}this.state.set({estimating:!0}),this.estimateTimer=window.setTimeout(()=>void this.ask(),Su)}async ask(){const t=new AbortController;this.asking=t;try{const s=await T.estimate(this.job,t.signal);if(t.signal.aborted)return;this.stale=!1,this.state.set({estimate:s,estimating:!1,doubt:null})}catch(s){if(t.signal.aborted)return;this.stale=!1,this.state.set({estimate:null,estimating:!1,doubt:Bt(s)})}}}async function Au(e,t){const{draft:s,id:n,saver:i,work:a}=e;if(e.locked||a.unchecked||s.parts.length===0)return;if(!await i.flush()){ce(i.state.value.problem);return}const r=[...a.state.value.locks].map(Ys);await to(e,t==="none"?"anew":"keeps",t==="none"?null:{keep:t==="all"?"all":r})&&(it(`packed.${n}`,Yr(e.draft)),e.build.set({follow:!0,selected:[],section:null,find:null}),rt({page:"job",id:n,step:"build"}))}async function Cu(e,t){!e.locked&&!e.work.unchecked&&await to(e,"improves",{improve:t})}async function to(e,t,s){e.work.packs(t);const n=await nt(async()=>(await e.run.start(t==="improves"?"improve":"pack",()=>T.start(e.id,s)),!0));return e.work.started(n===!0,t),n===!0}function ju(e,t,s,n){const i=new XMLHttpRequest,a=new Promise((r,o)=>{i.upload.onprogress=c=>n(c.loaded),i.onload=()=>{i.status>=200&&i.status<300?r():o(rr(i.status,Eu(i.responseText)))},i.onerror=()=>o(new Ct(ar,0)),i.onabort=()=>o(new DOMException("stopped","AbortError"))});return i.open("PUT",gl(e,t)),i.setRequestHeader("Content-Type","application/octet-stream"),i.send(s),{done:a,stop:()=>i.abort()}}function Eu(e){try{return JSON.parse(e)}catch{return null}}const $a={total:0,done:0,bytes:0,sent:0,active:!1},Lu=3;class Nu{constructor(t,s){this.job=t,this.told=s,this.state=new Z($a),this.waiting=[],this.running=new Map,this.doneBytes=0}add(t){if(t.length===0)return;this.waiting.push(...t);const{total:s,bytes:n}=this.state.value,i=t.reduce((a,{file:r})=>a+r.size,0);this.state.set({total:s+t.length,bytes:n+i,active:!0}),this.next()}stop(){this.waiting.length=0;for(const{upload:t}of this.running.values())t.stop();this.finishIfIdle()}next(){for(;this.running.size<Lu;){const t=this.waiting.shift();if(!t)break;this.send(t)}this.finishIfIdle()}send(t){const s={sent:0,upload:ju(this.job,t.name,t.file,n=>{s.sent=n,this.count()})};this.running.set(t,s),s.upload.done.then(()=>this.told(t.name,null)).catch(n=>{n instanceof Ct&&this.told(t.name,{file:t.name,error:n.message})}).finally(()=>{this.running.delete(t),this.doneBytes+=t.file.size,this.state.set({done:this.state.value.done+1}),this.count(),this.next()})}count(){let t=this.doneBytes;for(const s of this.running.values())t+=s.sent;this.state.set({sent:t})}finishIfIdle(){this.running.size>0||this.waiting.length>0||(this.doneBytes=0,this.state.set($a))}}class Du{constructor(t,s){this.info=t,this.view=_u(),this.build=Hh(),this.filesOf=null,this.fileNames=new Set;const n=du(t);this.history=new su(n),this.state=new Z({draft:n,canUndo:!1,canRedo:!1,refused:[],dismissed:new Set}),this.run=new Ec(s),this.meshes=new ru(s.id),this.work=new Uh(this),this.saver=new Tu(s.id,i=>this.files.has(i)),this.uploads=new Nu(s.id,(i,a)=>this.fileSent(i,a)),this.source=new Mu(s.id,()=>this.uploads.state.value.active,(i,a,r)=>this.takeFiles(i,a,r))}get id(){return this.run.id}get job(){return this.run.state.value.job}get draft(){return this.state.value.draft}get parts(){return this.source.state.value.parts}get files(){return this.filesOf!==this.parts&&(this.filesOf=this.parts,this.fileNames=new Set(this.parts.meshes.map(t=>t.file))),this.fileNames}get locked(){return E(this.job)}async open(t){const[s,n]=await Promise.all([t?null:T.jobFile(this.id),this.source.refresh()]),i=Array.isArray(s?.parts)&&s.parts.length>0,a=s&&i?Cr(s,n.meshes):this.draft;this.history.reset(a),this.show(),this.saver.begin(a,i),this.source.state.subscribe(()=>this.saver.change(this.draft)),i?n.reading>0&&this.source.soon(0):this.source.addAll(),this.run.begin()}close(){this.work.close(),this.uploads.stop(),this.source.close(),this.saver.close(),this.run.close()}edit(t,s=""){this.locked||(this.history.change(t(this.draft),s),this.show(),this.saver.change(this.draft))}editWithToast(t,s){this.edit(s);const n=this.draft;Os(t,()=>{this.draft===n&&this.undo()})}undo(){this.step(()=>this.history.undo())}redo(){this.step(()=>this.history.redo())}step(t){this.locked||(t(),this.show(),this.saver.change(this.draft))}show(){const{value:t,canUndo:s,canRedo:n}=this.history;this.state.set({draft:t,canUndo:s,canRedo:n});const{current:i,chosen:a}=this.view.value,r=new Set(t.parts.map(c=>c.key)),o=new Set([...a].filter(c=>r.has(c)));this.view.set({current:i!==null&&r.has(i)?i:t.parts[0]?.key??null,chosen:o.size===a.size?a:o})}addFiles(t){const{files:s,refused:n}=Xh(t,this.info.limits.file_bytes),i=new Set(s.map(({name:r})=>r)),a=this.state.value.refused.filter(({file:r})=>!i.has(r));this.state.set({refused:[...a,...n]}),this.uploads.add(s)}replaceFile(t,s){this.dismissRefused(t);const i=s.name.split(".").pop()?.toLowerCase()===t.split(".").pop()?.toLowerCase(),a={file:s,name:i?t:s.name};i||(this.edit(r=>Gh(r,t,a.name)),Un(this.parts).has(t)&&this.removeFile(t)),this.uploads.add([a])}leaveOutFiles(t){const{dismissed:s,refused:n}=this.state.value;this.state.set({dismissed:new Set([...s,...t])});const i=t.length===1?`${t[0]} is left out.`:`${t.length} files are left out.`,a=()=>{const o=new Set(this.state.value.dismissed);for(const c of t)o.delete(c);this.state.set({dismissed:o})},r=t.filter(o=>!n.some(({file:c})=>c===o));Os(i,a,()=>{for(const o of t)this.dismissRefused(o);Promise.all(r.map(o=>this.removeFile(o))).then(a)})}async removeFile(t){await nt(()=>T.deleteFile(this.id,t)),await nt(()=>this.source.refresh())}dismissRefused(t){this.state.set({refused:this.state.value.refused.filter(({file:s})=>s!==t)})}fileSent(t,s){s?this.state.set({refused:[...this.state.value.refused,s]}):this.source.add(t)}takeFiles(t,s,n){const i=this.draft.parts.length===0&&!this.history.canUndo;this.edit(a=>vu(a,t,s,n),"take in"),!(!i||this.locked)&&(this.history.reset(this.draft),this.show())}pack(t="none"){return Au(this,t)}async packWith(t){this.edit(()=>t),await this.pack()}async goOn(){await nt(()=>this.run.start("pack",()=>T.start(this.id)))}async stop(){await nt(()=>this.run.cancel())}get changedSince(){const t=et(`packed.${this.id}`,null);return t!==null&&t!==Yr(this.draft)}}const V=new Z({session:null,problem:null});let Dt="";const eo=new Set;function Fu(e){eo.add(e)}async function Bn(e){if(V.value.session?.id===e)return V.value.session;if(Dt===e)return null;so(),Dt=e;try{const t=$.value.info??await T.info();$.set({info:t});const s=new Du(t,await T.job(e));return await s.open(eo.delete(e)),Dt!==e?(s.close(),null):(V.set({session:s,problem:null}),s)}catch(t){return Dt===e&&V.set({problem:t instanceof Error?t.message:"The job cannot be opened."}),null}finally{Dt===e&&(Dt="")}}function so(){Dt="",V.value.session?.close(),V.set({session:null,problem:null})}function Iu(e){const t=e.ctrlKey||e.metaKey?"Ctrl+":"",s=e.altKey?"Alt+":"";if(e.code==="BracketLeft"||e.code==="BracketRight"){if(e.key==="{"||e.key==="[")return`${t}${s}${e.shiftKey?"Shift+":""}[`;if(e.key==="}"||e.key==="]")return`${t}${s}${e.shiftKey?"Shift+":""}]`}if(e.key.length===1&&!/[a-z]/i.test(e.key))return`${t}${s}${e.key}`;const n=e.shiftKey?"Shift+":"",i=e.key.length===1?e.key.toUpperCase():e.key;return`${t}${s}${n}${i==="Escape"?"Esc":i==="Delete"?"Del":i}`}function zu(e,t){return e.some(s=>Uu(s)===t||s==="1–9"&&/^[1-9]$/.test(t))}const Ru={"←":"ArrowLeft","→":"ArrowRight","↑":"ArrowUp","↓":"ArrowDown",Space:" "},Uu=e=>e.replace(/[←→↑↓]|Space/,t=>Ru[t]??t),Bu=e=>/^(Shift\+)?[A-Z0-9]$|^[[\]/]$|^Shift\+[[\]]$/.test(e),Cs=new Set;function Ue(e){return Cs.add(e),()=>Cs.delete(e)}function Hu(){return[...Cs].flat()}function qu(e){return!!e?.closest?.("input:not([type=checkbox]), textarea, select, [contenteditable]")}function Wu(e){if(e.defaultPrevented||document.querySelector("dialog[open]"))return;const t=Iu(e);if(qu(e.target)&&t!=="Ctrl+Enter"&&t!=="Esc"||Bu(t)&&!$.value.letterKeys)return;const s=[...Cs].reverse().flat().find(n=>zu(n.keys,t)&&n.when?.(e)!==!1);s&&(e.preventDefault(),t==="Ctrl+Enter"&&document.activeElement?.blur(),s.run(e))}let ba=!1;function Vu(){ba||(ba=!0,document.addEventListener("keydown",Wu),Ue([{keys:["?"],does:"help and keys",run:()=>$.set({dialog:"help"})}]))}class Ku extends di{constructor(t){if(super(t),this.before={},t.type!==$r.ELEMENT)throw new Error("styles() stands in a tag, not in an attribute")}update(t,[s]){const{style:n}=t.element;for(const i of Object.keys(this.before))i in s||n.removeProperty(i);for(const[i,a]of Object.entries(s))a!==this.before[i]&&(a===null?n.removeProperty(i):n.setProperty(i,a));return this.before=s,yt}render(t){return yt}}const B=ui(Ku),Gu={ok:"check",warn:"warn",bad:"bad",run:"clock",plain:null};function Be(e,t){const s=Gu[e];return l`<span class="badge ${e}">${s?b(s):d}${t}</span>`}function D(e,t,s,n=""){return l`<button type="button" class="btn ghost icon ${n}" aria-label=${t} title=${t} @click=${s}>
    ${b(e)}
  </button>`}function te(e,t,s,n,i="fill s"){return l`<div class="seg ${i}" role="group" aria-label=${e}>
    ${t.map(a=>l`<button
          type="button"
          aria-pressed=${a.value===s}
          ?disabled=${a.disabled??!1}
          title=${a.title??d}
          @click=${()=>n(a.value)}
        >
          ${a.icon?b(a.icon):d}<span>${a.text}</span>
        </button>`)}
  </div>`}function Qs(e,t,s,n=!1){return l`<button
    type="button"
    class="switch ${t?"on":""}"
    role="switch"
    aria-checked=${t}
    aria-label=${e}
    ?disabled=${n}
    @click=${()=>s(!t)}
  ></button>`}function tn(e,t,s,n=null){return l`<button
    type="button"
    class="check ${t?"on":""}"
    role="checkbox"
    aria-checked=${t==="mixed"?"mixed":t}
    aria-label=${e}
    tabindex=${n??d}
    @click=${i=>s(t!==!0,i)}
  >
    ${t==="mixed"?b("minus"):t?b("check"):d}
  </button>`}function Kt(e,t,s,n,i="",a=!1){return l`<span class="pick ${i}">
    <select
      aria-label=${e}
      ?disabled=${a}
      @change=${r=>n(r.target.value)}
    >
      ${s===null?l`<option value="" selected disabled>–</option>`:d}
      ${t.map(r=>l`<option value=${r.value} .selected=${r.value===s}>${r.text}</option>`)}
    </select>
    ${b("down")}
  </span>`}function rs(e,t=null,s=""){const n=`${Math.max(0,Math.min(1,e))*100}%`;return t===null?l`<div class="bar ${s}"><i ${B({width:n})}></i></div>`:l`<div
        class="bar ${s}"
        role="progressbar"
        aria-label=${t}
        aria-valuemin="0"
        aria-valuemax="100"
        aria-valuenow=${Math.round(e*100)}
      >
        <i ${B({width:n})}></i>
      </div>`}function G(e,t,s){return l`<div><b>${e} ${t?l`<small>${t}</small>`:d}</b><span>${s}</span></div>`}function X(e,t="th"){return e?l`<img class=${t} src=${e} alt="" draggable="false" />`:l`<span class="${t} blank"></span>`}var Ju=Object.defineProperty,Yu=Object.getOwnPropertyDescriptor,no=(e,t,s,n)=>{for(var i=n>1?void 0:n?Yu(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Ju(t,s,i),i};const Zu=[["Left button","turns the view"],["Middle button, Shift+left","shifts it"],["Wheel","zooms to the pointer"],["Click","selects a copy; with Ctrl one more"],["Double click","frames it"],["Touch","one finger turns, two shift, pinch zooms, tap selects"]];let Hn=class extends x{stores(){return[$]}firstUpdated(){this.dialog.showModal()}render(){return l`<dialog class="dialog" aria-labelledby="help-title" @close=${()=>$.set({dialog:null})}>
      <div class="head">
        <h2 id="help-title" class="grow">Help</h2>
        <button type="button" class="btn ghost icon" aria-label="Close" @click=${()=>this.dialog.close()}>
          ${b("close")}
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
            ${Hu().map(e=>l`<dt>${e.keys.map((t,s)=>l`${s>0?" ":""}<kbd>${t}</kbd>`)}</dt>
                  <dd>${e.does}</dd>`)}
          </dl>
          <div class="field">
            <span class="dim">Keys of one letter</span>
            ${Qs("Keys of one letter",$.value.letterKeys,bl)}
          </div>
        </section>
        <section class="sec">
          <h3>Mouse and touch</h3>
          <dl class="keys">${Zu.map(([e,t])=>l`<dt>${e}</dt><dd>${t}</dd>`)}</dl>
        </section>
        <section class="sec">
          <p class="small faint">
            ${$.value.info?.program??"spectralpack"} ·
            <a class="link" href="./openapi.json" download="openapi.json">API description</a>
          </p>
        </section>
      </div>
    </dialog>`}};no([H("dialog")],Hn.prototype,"dialog",2);Hn=no([k("sp-help")],Hn);var Xu=Object.defineProperty,Qu=Object.getOwnPropertyDescriptor,en=(e,t,s,n)=>{for(var i=n>1?void 0:n?Qu(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Xu(t,s,i),i};let He=class extends x{constructor(){super(...arguments),this.problem="",this.busy=!1}firstUpdated(){this.input.focus()}render(){return l`<main class="token">
      <form class="card" @submit=${this.send}>
        <span class="brand">${vr} spectralpack</span>
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
        ${this.problem?l`<p class="small bad-text" role="alert">${this.problem}</p>`:d}
        <button class="btn primary l" ?disabled=${this.busy}>Go on</button>
      </form>
    </main>`}async send(e){if(e.preventDefault(),this.input.value.trim()!==""){this.busy=!0;try{await cr(this.input.value),$.set({tokenWanted:!1,problem:null})}catch(t){const s=t instanceof Ct&&t.status===401;this.problem=s?"This is not the token. Look where the server was started.":Bt(t)}finally{this.busy=!1}}}};en([O()],He.prototype,"problem",2);en([O()],He.prototype,"busy",2);en([H("input")],He.prototype,"input",2);He=en([k("sp-token")],He);var td=Object.getOwnPropertyDescriptor,ed=(e,t,s,n)=>{for(var i=n>1?void 0:n?td(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=r(i)||i);return i};let va=class extends x{stores(){return[$]}render(){const e=$.value.toast;return l`<div class="toasts" role="status" aria-live="polite">
      ${e?l`<div
              class="toast"
              @pointerenter=${()=>Se(!0)}
              @pointerleave=${()=>Se(!1)}
              @focusin=${()=>Se(!0)}
              @focusout=${()=>Se(!1)}
            >
              <span class="cut">${e.text}</span>
              <button type="button" class="btn s" @click=${e.undo}>Undo</button>
            </div>`:d}
    </div>`}};va=ed([k("sp-toast")],va);const bs=[{phase:"load",text:"Read the parts",always:!0},{phase:"voxelize",text:"Prepare shapes",always:!1},{phase:"search",text:"Place copies, slide them together",always:!0},{phase:"disassemble",text:"Check that it comes apart",always:!0},{phase:"reinsert",text:"Put back what was in the way",always:!1},{phase:"improve",text:"Pack it better",always:!1},{phase:"write",text:"Write the files",always:!1},{phase:"check",text:"Measure every gap",always:!0},{phase:"render",text:"Draw the picture",always:!1}];function qn(e){return bs.find(t=>t.phase===e)?.text??""}function sd(e,t,s){const n=bs.findIndex(i=>i.phase===t);return bs.filter(i=>i.always||e.has(i.phase)).map(i=>{const a=bs.indexOf(i),r=a===n?"now":e.has(i.phase)||a<n?"done":"wait";return{phase:i.phase,text:i.phase==="load"?`Read ${P(s,"part")}`:i.text,state:r}})}function Gt(e){if(e<9.95)return`${e.toFixed(1)}${L}s`;if(e<119.5)return`${Math.round(e)}${L}s`;const t=Math.round(e/60);if(t<60)return`${t}${L}min`;const s=t%60;return`${Math.floor(t/60)}${L}h${s?` ${s}${L}min`:""}`}function Pt(e){const t=Math.max(0,Math.round(e)),s=a=>a.toString().padStart(2,"0"),n=Math.floor(t/3600),i=Math.floor(t/60)%60;return n?`${n}:${s(i)}:${s(t%60)}`:`${i}:${s(t%60)}`}const nd=["Jan","Feb","Mar","Apr","May","Jun","Jul","Aug","Sep","Oct","Nov","Dec"];function Wn(e){return`${e.getDate()} ${nd[e.getMonth()]??""}`}function yi(e){return`${e.getHours().toString().padStart(2,"0")}:${e.getMinutes().toString().padStart(2,"0")}`}function id(e,t){if(t.getTime()-e.getTime()<6e4)return"now";const s=a=>new Date(a.getFullYear(),a.getMonth(),a.getDate()).getTime(),n=Math.round((s(t)-s(e))/864e5);return n<=0?yi(e):n===1?"yesterday":e.getFullYear()===t.getFullYear()||n<180?Wn(e):`${Wn(e)} ${e.getFullYear()}`}function ya(e,t){const[s,n,i]=e.split("-").map(Number);if(!s||!n||!i)return e;const a=Wn(new Date(s,n-1,i));return s===t.getFullYear()||Math.abs(n-1+12*(s-t.getFullYear())-t.getMonth())<6?a:`${a} ${s}`}function ad(e){const t=e.progress;return t&&t.total>0?Math.min(1,t.done/t.total):0}function de(e){const t=e.verdict;return t?t.apart==="no"?{tone:"bad",text:"Does not come apart"}:t.ok?t.apart==="not_checked"?{tone:"warn",text:"Coming apart: not checked"}:{tone:"ok",text:"Comes apart"}:{tone:"bad",text:"Check failed"}:null}function js(e){switch(e.status){case"new":return{tone:"plain",text:"Not packed yet"};case"queued":return{tone:"plain",text:e.queue_place?`Waiting: place ${e.queue_place}`:"Waiting"};case"running":return{tone:"run",text:rd(e)};case"failed":return{tone:"bad",text:"Failed"};case"interrupted":return{tone:"warn",text:"Interrupted"};case"cancelled":return e.has_packing?de(e)??{tone:"warn",text:"Stopped"}:{tone:"warn",text:"Stopped"};default:return de(e)??{tone:"plain",text:"Packed"}}}function rd(e){const t=e.progress?.phase;return t==="search"?`Packing ${K(ad(e),0)}`:t==="improve"?"Improving":t==="disassemble"||t==="reinsert"||t==="check"?"Checking":t==="render"||t==="write"?"Writing":"Packing"}function io(e){if(e.status==="failed"&&e.error)return st(e.error);const t=e.progress;if(e.status==="running"&&t){const n=typeof t.left=="number"?` · about ${Gt(t.left)} left`:"";return t.phase==="search"?`${w(t.done)} of ${w(t.total)} placed${n}`:`${qn(t.phase)}${n}`}const s=e.summary;return s?`${w(s.placed)} of ${S(s.copies)} · ${K(s.density)} full`:e.files===0?"no files yet":e.files===1?"1 file":`${w(e.files)} files`}function od(e){const t=e.summary&&e.summary.trays>1?` · ${e.summary.trays} trays`:"";return(e.tray??"No tray chosen yet")+t}function ld(e){return`Interrupted ${yi(new Date(e.changed))}`}function cd(e){return e.run.checking?{tone:"run",text:"Checking"}:e.work.unchecked?{tone:"warn",text:"Changed: not checked"}:de(e.job)}function hd(e){const{verdict:t}=e.job;return e.run.checking?"The change is being checked: export follows":e.work.unchecked?"The build is changed: it is checked before it can be exported":t!==null&&!t.ok&&t.findings.length>0?"The check found faults: nothing is exported":null}var ud=Object.defineProperty,dd=Object.getOwnPropertyDescriptor,wt=(e,t,s,n)=>{for(var i=n>1?void 0:n?dd(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&ud(t,s,i),i};let dt=class extends x{constructor(){super(...arguments),this.button="",this.content=()=>l``,this.label="",this.buttonClasses="btn",this.menuClasses="",this.disabled=!1,this.hint="",this.open=!1,this.outside=e=>{this.contains(e.target)||this.close(!1)},this.moved=e=>{const t=this.querySelector(".menu");e.target instanceof Node&&t?.contains(e.target)||this.close(!1)}}disconnectedCallback(){super.disconnectedCallback(),this.stopListening()}render(){return l`<button
        type="button"
        class=${this.buttonClasses}
        aria-haspopup="menu"
        aria-expanded=${this.open}
        aria-label=${this.label||d}
        title=${this.hint||d}
        ?disabled=${this.disabled}
        @click=${()=>this.open?this.close(!0):this.show()}
        @keydown=${e=>{e.key!=="ArrowDown"||this.open||(e.preventDefault(),this.show())}}
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
            </div>`:d}`}show(){this.disabled||(this.open=!0,document.addEventListener("pointerdown",this.outside,!0),document.addEventListener("scroll",this.moved,!0),addEventListener("resize",this.moved),this.updateComplete.then(()=>{this.place(),this.items()[0]?.focus({preventScroll:!0})}))}place(){const e=this.querySelector(".menu"),t=this.querySelector("button[aria-haspopup]")?.getBoundingClientRect();if(!e||!t)return;e.showPopover();const s=e.getBoundingClientRect(),n=8,i=t.left+s.width>innerWidth-n?t.right-s.width:t.left,a=t.bottom+4,r=a+s.height>innerHeight-n?t.top-4-s.height:a;e.style.left=`${Math.max(n,i)}px`,e.style.top=`${Math.max(n,r)}px`}stopListening(){document.removeEventListener("pointerdown",this.outside,!0),document.removeEventListener("scroll",this.moved,!0),removeEventListener("resize",this.moved)}close(e){this.open&&(this.open=!1,this.stopListening(),e&&this.querySelector("button[aria-haspopup]")?.focus())}items(){return[...this.querySelectorAll(".menu [role^=menuitem]:not([disabled]):not([aria-disabled=true])")]}clicked(e){const t=e.target.closest("[role^=menuitem]");t&&!t.hasAttribute("data-stays")&&this.close(!0)}left(e){e.relatedTarget&&!this.contains(e.relatedTarget)&&this.close(!1)}key(e){const t=this.items(),s=t.indexOf(document.activeElement),i={ArrowDown:s+1,ArrowUp:s-1+t.length,Home:0,End:t.length-1}[e.key];i!==void 0&&t.length>0?(e.preventDefault(),e.stopPropagation(),t[i%t.length]?.focus()):e.key==="Escape"&&(e.stopPropagation(),this.close(!0))}};wt([g({attribute:!1})],dt.prototype,"button",2);wt([g({attribute:!1})],dt.prototype,"content",2);wt([g()],dt.prototype,"label",2);wt([g()],dt.prototype,"buttonClasses",2);wt([g()],dt.prototype,"menuClasses",2);wt([g({type:Boolean})],dt.prototype,"disabled",2);wt([g()],dt.prototype,"hint",2);wt([O()],dt.prototype,"open",2);dt=wt([k("sp-menu")],dt);let Ee=null;function ao(e){return Ee=e,()=>{Ee===e&&(Ee=null)}}async function pd(){return Ee?Ee():null}var fd=Object.defineProperty,md=Object.getOwnPropertyDescriptor,os=(e,t,s,n)=>{for(var i=n>1?void 0:n?md(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&fd(t,s,i),i};const gd=[{kind:"3mf",icon:"box",text:"3MF for the slicer",what:"every copy in its place"},{kind:"stl",icon:"mesh",text:"STL",what:"all copies in one mesh"},{kind:"json",icon:"braces",text:"Packing file (JSON)",what:"everything, exactly"},{kind:"csv",icon:"list",text:"List of copies (CSV)",what:"part, number, place"}];let pe=class extends x{constructor(){super(...arguments),this.all=!1,this.drawing=!1}stores(){const{session:e}=this;return[e.run.state,e.build,e.work.state,e.work.move.state]}show(){this.menu.show()}render(){const e=hd(this.session);return l`<sp-menu
      buttonClasses="btn primary"
      menuClasses="export"
      hint=${e??"Export (Ctrl+E)"}
      ?disabled=${e!==null}
      .button=${l`${this.drawing?z:b("download")}Export${b("down")}`}
      .content=${()=>this.entries()}
    ></sp-menu>`}entries(){const{job:e,packing:t}=this.session.run.state.value,s=this.session.build.value.tray,n=t?.trays.length??1,i=n>1&&s>0&&!this.all?s:null,a=de(e),r=i===null?t?.placed:t?.trays[i-1]?.placements.length;return l`<div class="row between menu-head">
        ${a?Be(a.tone,a.tone==="ok"?"Comes apart: checked":a.text):d}
        <span class="small faint">${S(r??0)}</span>
      </div>
      ${n>1&&s>0?l`<div class="seg fill s" role="group" aria-label="Which trays">
              ${this.choice(`Tray ${s}`,!1)}${this.choice(`All ${n} trays`,!0)}
            </div>`:d}
      ${gd.map(o=>this.link(o,o.kind==="json"?null:i))}
      ${s>0?l`<button type="button" class="mi" role="menuitem" @click=${()=>this.drawView()}>
              ${b("picture")}<span>Picture (PNG)<span>the view as it is now</span></span>
            </button>`:this.link({kind:"png",icon:"picture",text:"Picture (PNG)",what:"all trays"},null)}
      <hr />
      ${this.link({kind:"html",icon:"printer",text:"Printable report",what:"pictures, parts, way out, left over"},i)}`}choice(e,t){return l`<button
      type="button"
      role="menuitemradio"
      aria-checked=${this.all===t}
      data-stays
      @click=${()=>{this.all=t}}
    >
      ${e}
    </button>`}link(e,t){return l`<a
      class="mi"
      role="menuitem"
      href=${ai(this.session.id,e.kind,t)}
      download=${this.fileName(e.kind,t)}
    >
      ${b(e.icon)}<span>${e.text}<span>${e.what}</span></span>
    </a>`}fileName(e,t){return`${this.session.job.name.replace(/[^\p{L}\p{N} ._-]+/gu,"").trim()||"build"}${t===null?"":` tray ${t}`}.${e}`}async drawView(){this.drawing=!0;const e=await nt(()=>pd());if(this.drawing=!1,!e)return;const t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=this.fileName("png",this.session.build.value.tray),t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}};os([g({attribute:!1})],pe.prototype,"session",2);os([O()],pe.prototype,"all",2);os([O()],pe.prototype,"drawing",2);os([H("sp-menu")],pe.prototype,"menu",2);pe=os([k("sp-export")],pe);const $d=6,bd=500,vd=2e3,J=new Z({jobs:null,total:0,bytes:0,find:null,all:!1,going:new Set,dismissed:et("dismissed",[]),failed:!1});let wa=0,_n=0;async function qe(){const{find:e,all:t}=J.value;try{const s=await T.jobs(e??"",t||e?bd:$d);J.set({jobs:s.jobs,total:s.total,bytes:s.bytes,failed:!1})}catch{J.set({failed:!0})}}function yd(){_n+=1;const e=async()=>{document.hidden||await qe(),_n>0&&(wa=window.setTimeout(e,vd))},t=()=>{document.hidden||qe()};return document.addEventListener("visibilitychange",t),e(),()=>{_n-=1,clearTimeout(wa),document.removeEventListener("visibilitychange",t)}}function ms(e){J.set({find:e}),qe()}function ka(e){J.set({all:e}),qe()}function ro(e){J.set({going:new Set([...J.value.going,e.id])});const t=()=>{const s=new Set(J.value.going);s.delete(e.id),J.set({going:s})};Os(`“${e.name}” is deleted${E(e)?", and stopped":""}.`,t,()=>{nt(()=>T.deleteJob(e.id)).then(qe).then(t)})}const oo=e=>`${e.id} ${e.changed}`;function wd(e){return(e.jobs??[]).filter(t=>t.status==="interrupted"&&!e.going.has(t.id)&&!e.dismissed.includes(oo(t)))}function kd(e){const t=[...J.value.dismissed.slice(-50),oo(e)];it("dismissed",t),J.set({dismissed:t})}async function xd(e){e.length!==0&&await nt(async()=>{const t=await T.createJob({name:eu(e,new Date)});Fu(t.id),(await Bn(t.id))?.addFiles(e),rt({page:"job",id:t.id,step:"parts"})})}async function Md(){await nt(async()=>{const e=await T.createJob({name:"Sample",sample:!0});rt({page:"job",id:e.id,step:"parts"})})}async function lo(e,t){await nt(async()=>{const s=await T.createJob({copy_of:e,name:As(`${t} copy`)});rt({page:"job",id:s.id,step:"parts"})})}var _d=Object.defineProperty,Od=Object.getOwnPropertyDescriptor,sn=(e,t,s,n)=>{for(var i=n>1?void 0:n?Od(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&_d(t,s,i),i};let We=class extends x{constructor(){super(...arguments),this.renaming=!1}stores(){return[this.session.run.state]}render(){const{job:e}=this.session;return this.renaming?l`<span class="in rename">
        <input
          aria-label="Name of the job"
          maxlength="100"
          .value=${e.name}
          @blur=${()=>this.rename(!0)}
          @keydown=${t=>{t.key==="Enter"&&this.rename(!0),t.key==="Escape"&&this.rename(!1)}}
        />
      </span>`:l`<sp-menu
      label=${`Job: ${e.name}`}
      buttonClasses="btn ghost name"
      .button=${l`<span class="cut">${e.name}</span>${b("down")}`}
      .content=${()=>l`
        <button type="button" class="mi" role="menuitem" @click=${()=>this.begin()}>
          ${b("drawn")}<span>Rename</span>
        </button>
        <button type="button" class="mi" role="menuitem" @click=${()=>lo(e.id,e.name)}>
          ${b("copy")}<span>Copy the job</span>
        </button>
        <button
          type="button"
          class="mi danger"
          role="menuitem"
          @click=${()=>{ro(e),rt({page:"start"})}}
        >
          ${b("trash")}<span>Delete the job</span>
        </button>
        <hr />
        <button type="button" class="mi" role="menuitem" @click=${()=>rt({page:"start"})}>
          ${b("list")}<span>All jobs</span>
        </button>
      `}
    ></sp-menu>`}begin(){this.renaming=!0,this.updateComplete.then(()=>this.input?.select())}async rename(e){if(!this.renaming)return;const t=As(this.input?.value??"");if(this.renaming=!1,!e||t===""||t===this.session.job.name)return;const s=await nt(()=>T.rename(this.session.id,t));s&&this.session.run.take(s)}};sn([g({attribute:!1})],We.prototype,"session",2);sn([O()],We.prototype,"renaming",2);sn([H("input")],We.prototype,"input",2);We=sn([k("sp-job-menu")],We);const Pd=[{value:"light",text:"Light",icon:"sun"},{value:"dark",text:"Dark",icon:"moon"},{value:"system",text:"As the system",icon:"system"}];function Sd(){return l`<sp-menu
    label="Light or dark"
    hint="Light or dark"
    buttonClasses="btn ghost icon"
    .button=${b($.value.theme==="dark"?"sun":"moon")}
    .content=${()=>l`${Pd.map(e=>l`<button
            type="button"
            class="mi"
            role="menuitemradio"
            aria-checked=${$.value.choice===e.value}
            @click=${()=>yl(e.value)}
          >
            ${b(e.icon)}<span>${e.text}</span>${$.value.choice===e.value?b("check"):""}
          </button>`)}`}
  ></sp-menu>`}function Td(e,t){const{work:s}=e,n=t==="build",i=!e.locked,a=n?s.canUndo:e.state.value.canUndo&&i,r=n?s.canRedo:e.state.value.canRedo&&i;return l`${xa("undo","Undo (Ctrl+Z)",a,()=>n?void s.undo():e.undo())}
    ${xa("redo","Redo (Ctrl+Shift+Z)",r,()=>n?void s.redo():e.redo())}
    <span class="rule"></span>`}function xa(e,t,s,n){return l`<button type="button" class="btn ghost icon" aria-label=${t} title=${t} ?disabled=${!s} @click=${n}>
    ${b(e)}
  </button>`}var Ad=Object.getOwnPropertyDescriptor,Cd=(e,t,s,n)=>{for(var i=n>1?void 0:n?Ad(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=r(i)||i);return i};let Ma=class extends x{get session(){const{route:e}=$.value,t=V.value.session;return e.page==="job"&&t?.id===e.id?t:null}stores(){const e=this.session;return e?[$,V,e.state,e.run.state,e.work.state,e.work.move.state]:[$,V]}render(){const e=this.session,{route:t}=$.value,s=t.page==="job"?t.step:null;return l`<header class="top">
      <div class="row first">
        <a class="brand" href="#/" aria-label="spectralpack: all jobs">${vr}<span class="hide-s">spectralpack</span></a>
        ${e?l`<span class="rule"></span><sp-job-menu .session=${e}></sp-job-menu>${this.state(e)}`:d}
      </div>
      ${e&&s?this.steps(e,s):l`<span></span>`}
      <div class="row last">
        ${e&&(s==="parts"||s==="build")?Td(e,s):d} ${Sd()}
        ${D("help","Help and keys (?)",()=>$.set({dialog:"help"}))}
        ${e&&s&&s!=="parts"?this.result(e):d}
      </div>
    </header>`}state(e){const t=$.value.route.page==="job"&&$.value.route.step!=="parts"&&e.run.checking;if(!E(e.job)||t)return d;const s=e.job.status==="running"&&e.run.doing==="improve";return Be("run",s?"Improving":js(e.job).text)}steps(e,t){const s=e.job.status!=="new"||e.job.has_packing,n=e.run.state.value.packing?.trays.some(r=>r.steps>0)??!1,i=s&&!E(e.job)?"This build has no plan to take it apart":"Press Pack first",a=(r,o,c,h="Press Pack first")=>c?l`<a
            class="tab"
            href=${ws({page:"job",id:e.id,step:r})}
            aria-current=${t===r?"step":d}
            >${o}</a
          >`:l`<span class="tab" aria-disabled="true" title=${h}>${o}</span>`;return l`<nav class="tabs" aria-label="Steps">
      ${a("parts","Parts",!0)}${a("build","Build",s)}${a("apart","Take apart",n,i)}
    </nav>`}result(e){if(e.run.packs||!e.run.state.value.packing)return d;const t=cd(e),s=t?.tone==="ok"?"Comes apart: checked":t?.text,n=t?.tone==="ok"?"Checked":t?.text.replace("Changed: not","Not");return l`<span class="rule hide-s"></span>
      ${t?Be(t.tone,l`<span class="hide-s">${s}</span><span class="show-s">${n}</span>`):d}
      <sp-export .session=${e}></sp-export>`}};Ma=Cd([k("sp-top-bar")],Ma);function co(e){return e.filter(t=>!/journal|same command/.test(t)).map(st)}function It(e,t,s,n,i){return l`<div class="note ${e}" role="status">
    ${b(t)}
    <div>
      <p><b>${s}</b> ${n}</p>
      ${i.length>0?l`<div class="row wrap">
              ${i.map(a=>l`<button type="button" class="btn s" @click=${a.run}>${a.text}</button>`)}
            </div>`:d}
    </div>
  </div>`}function jd(e,t,s){const n=[...Ed(e,t),...Ld(e),...Nd(e,t,s)],i=co(e.job.remarks);return n.length===0&&i.length===0?d:l`<section class="sec stack">
    ${n}
    ${i.length>0?l`<ul class="said">
            ${i.map(a=>l`<li>${a}</li>`)}
          </ul>`:d}
  </section>`}function Ed(e,t){const{job:s,draft:n}=e,i={text:"Pack again",run:()=>void e.pack()},a=t.leftOver.filter(r=>r.reason==="not_tried"&&!r.byHand).reduce((r,o)=>r+o.copies,0);if(s.status==="interrupted"){const r=yi(new Date(s.changed));return[It("warn","warn",`Interrupted at ${r}.`,"The computer or the program stopped. This is the best packing so far.",[{text:"Continue packing",run:()=>void e.goOn()}])]}if(s.status==="cancelled"&&t.improvement)return[It("info","info","Stopped.","The best build that was found is kept.",[])];if(s.status==="cancelled")return[It("info","info","Stopped.","This is the best packing so far.",[{text:"Go on packing",run:()=>void e.goOn()}])];if(s.status==="failed")return[It("bad","bad","The run failed.",s.error?st(s.error):"",[i])];if(a>0&&n.timeLimit!==null){const r=n.timeLimit*2;return[It("warn","clock",`Time limit of ${Gt(n.timeLimit)} reached.`,`This is the best packing found; ${S(a)} ${a===1?"was":"were"} not tried.`,[{text:`Pack again with ${Gt(r)}`,run:()=>void e.packWith({...n,timeLimit:r})}])]}return[]}function Ld(e){return e.changedSince?[It("info","info","Parts or settings have changed since.","This build does not have the changes.",[])]:[]}function Nd(e,t,s){const n=t.trays[t.trays.length-1];if(s!==0||!n||t.trays.length<2||!wi(t,n.number))return[];const i=t.trays.length-1;return[It("warn","warn",`Tray ${n.number} holds ${S(n.placements.length)}.`,"It may not be worth a print.",[{text:i===1?"Pack again with 1 tray":`Pack again with ${w(i)} trays`,run:()=>void e.packWith({...e.draft,trays:i})}])]}function wi(e,t){const s=e.trays[t-1],n=Math.max(...e.trays.map(i=>i.density));return s!==void 0&&e.trays.length>1&&s.density<n/8}function Vn(e,t,s,n=!0){if(t.trays.length<2)return d;const i=(a,r)=>l`<button
      type="button"
      class="tt ${a===s?"on":""}"
      role="tab"
      aria-selected=${a===s}
      tabindex=${a===s?0:-1}
      @click=${()=>Ve(e,a)}
    >
      ${r}
    </button>`;return l`<nav class="tstrip" aria-label="Trays"><div class="tabs-row" role="tablist" @keydown=${a=>Dd(a)}>
    ${n?i(0,l`<span class="alone"><b>All trays</b><small>${S(t.placed)}</small></span>`):d}
    ${t.trays.map(a=>i(a.number,l`<img src=${ai(e.id,"png",a.number)} alt="" loading="lazy" />
          <span>
            <b>Tray ${a.number}</b>
            <small
              >${K(a.density)}${wi(t,a.number)?l` <span class="warn-text" title="Nearly empty">${b("warn")}</span>`:d}</small
            >
          </span>`))}
  </div></nav>`}function Ve(e,t){e.build.set({tray:t,follow:!1,selected:[],find:null})}function Dd(e){const t=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0;if(t===0)return;const s=[...e.currentTarget.querySelectorAll("[role=tab]")],n=s.indexOf(document.activeElement),i=s[(n+t+s.length)%s.length];e.preventDefault(),e.stopPropagation(),i?.focus(),i?.click()}var Fd=Object.defineProperty,Id=Object.getOwnPropertyDescriptor,be=(e,t,s,n)=>{for(var i=n>1?void 0:n?Id(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Fd(t,s,i),i};let Jt=class extends x{constructor(){super(...arguments),this.property="",this.side="left",this.label="",this.least=200,this.most=900,this.grab=e=>{const t=this.panel;if(!t)return;e.preventDefault(),this.setPointerCapture(e.pointerId);const s=t.getBoundingClientRect().width,n=e.clientX,i=r=>{const o=r.clientX-n;this.show(s+(this.side==="left"?o:-o))},a=()=>{this.removeEventListener("pointermove",i),t.getBoundingClientRect().width!==s&&this.put(t.getBoundingClientRect().width)};this.addEventListener("pointermove",i),this.addEventListener("lostpointercapture",a,{once:!0})},this.key=e=>{const t=e.key==="ArrowLeft"?-16:e.key==="ArrowRight"?16:0;t===0||!this.panel||(e.preventDefault(),e.stopPropagation(),this.put(this.panel.getBoundingClientRect().width+(this.side==="left"?t:-t)))}}connectedCallback(){super.connectedCallback(),this.tabIndex=0,this.setAttribute("role","separator"),this.setAttribute("aria-orientation","vertical"),this.addEventListener("pointerdown",this.grab),this.addEventListener("dblclick",()=>this.put(null)),this.addEventListener("keydown",this.key)}updated(){this.setAttribute("aria-label",this.label);const e=et(`width${this.property}`,null);e!==null&&this.show(e);const{panel:t}=this;t&&this.setAttribute("aria-valuenow",t.getBoundingClientRect().width.toFixed(0)),this.setAttribute("aria-valuemin",String(this.least)),this.setAttribute("aria-valuemax",String(this.most))}get panel(){return this.side==="left"?this.previousElementSibling:this.nextElementSibling}show(e){const t=Math.max(this.least,Math.min(this.most,e));this.parentElement?.style.setProperty(this.property,`${t}px`),this.setAttribute("aria-valuenow",t.toFixed(0))}put(e){it(`width${this.property}`,e),e===null?this.parentElement?.style.removeProperty(this.property):this.show(e)}};be([g()],Jt.prototype,"property",2);be([g()],Jt.prototype,"side",2);be([g()],Jt.prototype,"label",2);be([g({type:Number})],Jt.prototype,"least",2);be([g({type:Number})],Jt.prototype,"most",2);Jt=be([k("sp-divider")],Jt);function zd(e){const t=e.placements.map((c,h)=>h),s=[{number:0,members:t,madeBy:-1,offset:[0,0,0]}],n=t.map(()=>0),i=t.map(()=>Number.POSITIVE_INFINITY),a=t.map(()=>[]),r=e.plan.map((c,h)=>{const{placements:u,path:p,throughWalls:f}=c,m=n[u[0]??0]??0,v=p.reduce((M,A)=>M+po(A),0);let y=null;if(u.length>1){y=s.length;const M=p.reduce(Yt,s[m]?.offset??[0,0,0]);s.push({number:y,members:u,madeBy:h,offset:M})}for(const M of u)a[M]?.push(h),y===null?i[M]=h:n[M]=y;return{index:h,placements:u,path:p,length:v,from:m,makes:y,throughWalls:f}}),o=t.filter(c=>i[c]===Number.POSITIVE_INFINITY);return{steps:r,assemblies:s,outAt:i,stepsOf:a,staying:o}}function ho(e,t,s){const n=e.stepsOf[t]?.find(i=>i+1>s);return n===void 0?null:e.steps[n]??null}function ki(e,t){const s=e.assemblies[t];if(!s)return[];const n=new Set(s.members);return e.steps.filter(i=>i.index>s.madeBy&&i.placements.some(a=>n.has(a)))}function uo(e,t){return e.outAt.reduce((s,n)=>s+(n>t?1:0),0)}const po=e=>Math.hypot(e[0],e[1],e[2]),Yt=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],y$=120,w$=200;function k$(e){if(e<=0)return 0;if(e>=1)return 1;let t=0,s=1;for(let i=0;i<20;++i){const a=(t+s)/2;.6*a*(1-a)**2+a**3<e?t=a:s=a}const n=(t+s)/2;return 3*n*n*(1-n)+n**3}function _a(){return globalThis.matchMedia?.("(prefers-reduced-motion: reduce)").matches??!1}const Oa=600,Rd=240,Ud=1e3,Bd=[.25,.5,1,2,4,8,16];function fo({plan:e,step:t,alone:s}){const n=e?.steps[t],i=s===null?null:e?.assemblies[s]?.members;return n&&(!i||n.placements.some(a=>i.includes(a)))?n:null}class Hd{constructor(){this.clock=new Z({time:0}),this.state=new Z({plan:null,step:0,playing:!1,speed:et("apart.speed",1),show:"left",follow:et("apart.follow",!1),faint:et("apart.faint",!1),alone:null}),this.tray=null,this.until=Number.POSITIVE_INFINITY,this.glide=null,this.request=0,this.before=0}take(t){t!==this.tray&&(this.tray=t,this.pause(),this.clock.set({time:0}),this.state.set({plan:t?zd(t):null,step:0,alone:null}))}get steps(){return this.state.value.plan?.steps.length??0}get time(){return this.clock.value.time}toggle(){this.state.value.playing?this.pause():this.play()}play(t=Number.POSITIVE_INFINITY){if(this.steps!==0){if(this.glide=null,this.state.value.alone!==null){const s=this.stepsAlone();this.time>=(s[s.length-1]??0)+1&&this.show(s[0]??0)}else this.time>=this.steps&&this.show(0);this.until=t,this.state.set({playing:!0}),this.run()}}pause(){this.until=Number.POSITIVE_INFINITY,this.glide=null,cancelAnimationFrame(this.request),clearTimeout(this.timer),this.request=0,this.state.set({playing:!1})}seek(t){this.pause(),this.stepsAlone().includes(Math.floor(t))||this.state.set({alone:null}),this.show(t)}move(t){const s=this.glide?.to??this.time,n=t<0?Math.ceil(s-1e-6):Math.floor(s+1e-6),i=Math.max(0,Math.min(this.steps,n+t));if(this.pause(),Math.abs(t)>1||_a()||this.state.value.show==="apart"){this.seek(i);return}this.glide={from:this.time,to:i,start:performance.now()},this.run()}setShow(t){this.state.set({show:t,...t==="apart"?{alone:null}:{}})}setSpeed(t){it("apart.speed",t),this.state.set({speed:t})}setFollow(t){it("apart.follow",t),this.state.set({follow:t})}setFaint(t){it("apart.faint",t),this.state.set({faint:t})}playAlone(t){this.pause(),this.state.set({alone:t,show:"left"});const s=this.stepsAlone();t===null||s.length===0||(this.show(s[0]??0),this.play())}stepsAlone(){const{plan:t,alone:s}=this.state.value,n=s===null?void 0:t?.assemblies[s];return!t||!n?[]:[n.madeBy,...ki(t,n.number).map(i=>i.index)]}show(t){const s=Math.max(0,Math.min(this.steps,t));this.clock.set({time:s}),this.state.set({step:Math.floor(s)})}run(){if(this.before=performance.now(),_a()&&!this.glide){this.timer=setTimeout(()=>this.jump(),Oa/this.state.value.speed);return}this.request=requestAnimationFrame(t=>this.frame(t))}jump(){this.advance(Math.floor(this.time)+1),this.state.value.playing&&this.run()}frame(t){if(this.glide){const{from:n,to:i,start:a}=this.glide,r=Math.min(1,Math.max(0,(t-a)/Rd));this.show(n+(i-n)*r),r===1?this.pause():this.request=requestAnimationFrame(o=>this.frame(o));return}const s=Math.min(Ud,Math.max(0,t-this.before));this.before=t,this.advance(this.time+s/Oa*this.state.value.speed),this.state.value.playing&&(this.request=requestAnimationFrame(n=>this.frame(n)))}advance(t){const s=Math.min(this.until,this.steps);let n=t;if(this.state.value.alone!==null){const i=this.stepsAlone(),a=(i[i.length-1]??0)+1;if(Math.floor(n)!==Math.floor(this.time)&&(n=i.find(r=>r>=Math.floor(n))??a),n>=a){this.pause(),this.show(a);return}}if(n<s){this.show(n);return}this.pause(),this.show(s)}}const Pa=new WeakMap;function at(e){let t=Pa.get(e);return t||(t=new Hd,Pa.set(e,t)),t}function qd(e,t,s){const n=new Set(t.placements),i=t.placements.flatMap(a=>{const r=s[a];return r?Vd(r,t.path):[]});return(e.assemblies[t.from]?.members??[]).flatMap(a=>{if(n.has(a))return[];const r=Wd(e,a,t.from),o=s[a];return r===null||r>=t.index||!o?[]:i.some(c=>Kd(c,o))?[{placement:a,step:r}]:[]})}function Wd(e,t,s){return e.stepsOf[t]?.find(n=>e.steps[n]?.from===s)??null}function Vd(e,t){let{low:s,high:n}=e;return t.map(i=>{const a=Yt(s,i),r=Yt(n,i),o={low:Sa(s,a,Math.min),high:Sa(n,r,Math.max)};return s=a,n=r,o})}function Sa(e,t,s){return[s(e[0],t[0]),s(e[1],t[1]),s(e[2],t[2])]}function Kd(e,t){return[0,1,2].every(s=>(e.low[s]??0)<(t.high[s]??0)&&(t.low[s]??0)<(e.high[s]??0))}const Ta=10;class mo{constructor(t){this.ground=t,this.state=new Z({step:null,found:null}),this.found=new Map}ask(t){const s=t?.index??null;s!==this.state.value.step&&(this.state.set({step:s,found:null}),t&&this.before(t).then(n=>{this.state.value.step===s&&this.state.set({found:n})}))}before(t){let s=this.found.get(t.index);return s||(s=this.look(t),this.found.set(t.index,s)),s}async look(t){const{plan:s,placements:n,extents:i}=this.ground,a=qd(s,t,i).sort((p,f)=>p.step-f.step);if(a.length===0)return a;const{Sweep:r}=await $e(async()=>{const{Sweep:p}=await import("./sweep-Eneu3xcy.js");return{Sweep:p}},__vite__mapDeps([8,1,4]),import.meta.url),o=p=>{const f=n[p],m=f?this.ground.meshOf(f.part):null;return f&&m?{mesh:m,transform:f.transform}:null},c=t.placements.flatMap(p=>{const f=o(p);return f?[new r(f,t.path)]:[]}),h=[];let u=performance.now()+Ta;for(const p of a){const f=o(p.placement);f&&c.some(m=>m.meets(f))&&h.push(p),!(performance.now()<u)&&(await new Promise(m=>setTimeout(m)),u=performance.now()+Ta)}return h}}function Gd(e,t,s,n){const i=Ks(e,t),a=o=>{const c=s.placements[o];return c?i[c.part]??null:null},r=s.placements.map(()=>null);return{packing:t,tray:s,plan:n,parts:i,partOf:a,nameOf:o=>`${a(o)?.name??"copy"} ${(s.placements[o]?.copy??0)+1}`,extents:r,ways:new mo({plan:n,placements:s.placements,extents:r,meshOf:()=>null}),measured:!1}}function Jd(e,t){const{plan:s,parts:n}=t,{placements:i}=t.tray,a=i.map(o=>Yd(e,o,n[o.part]??null)),r=o=>{const c=n[o]?.mesh;return c?e.meshes.mesh(c):null};return{...t,extents:a,ways:new mo({plan:s,placements:i,extents:a,meshOf:r}),measured:!0}}function Yd(e,t,s){const n=s?.mesh;if(!n)return null;const i=n.box.map(a=>a.map(r=>r/n.unit));return Zs(t.transform,i,e.meshes.mesh(n)?.positions??null)}function le(e,t){const s=e.build.value.selected.at(-1);return s?t.byId.get(_(s))??null:null}function ls(e,t){e.build.set({selected:t?[{part:t.part,copy:t.copy}]:[]})}const Aa=10;function Zd(e){return!e.target?.closest?.("button, a, summary, [role=switch], [role=menuitem]")}function Xd({session:e,player:t,frame:s,openExport:n}){const i=(a,r,o)=>({keys:[a],does:o,run:()=>t().move(r)});return[{keys:["Space"],does:"play, pause",when:Zd,run:()=>t().toggle()},i("←",-1,"step back"),i("→",1,"step on"),i("Shift+←",-Aa,"ten steps back"),i("Shift+→",Aa,"ten steps on"),{keys:["Home"],does:"first step",run:()=>t().seek(0)},{keys:["End"],does:"after the last step",run:()=>t().seek(t().steps)},{keys:["F"],does:"frame what leaves, or what is selected",run:()=>s(!1)},{keys:["Shift+F"],does:"frame all",run:()=>s(!0)},{keys:["/"],does:"find a copy or part",run:()=>e().build.set({find:e().build.value.find??""})},{keys:["Esc"],does:"close, let go",run:()=>{const{build:a}=e();a.value.find!==null?a.set({find:null}):t().state.value.alone!==null?t().playAlone(null):a.set({selected:[]})}},{keys:["1–9"],does:"that tray",run:a=>{const r=Number(a.key);(e().run.state.value.packing?.trays.length??0)>=r&&Ve(e(),r)}},{keys:["Ctrl+E"],does:"export",run:n}]}function On(e){return e<=.04045?e/12.92:((e+.055)/1.055)**2.4}function Qd(e){return e<=.0031308?e*12.92:1.055*e**(1/2.4)-.055}function Te(e){const t=Number.parseInt(e.slice(1),16);return[On((t>>16)/255),On((t>>8&255)/255),On((t&255)/255)]}function go(e){const t=s=>Math.round(255*Qd(Math.min(1,Math.max(0,s)))).toString(16).padStart(2,"0");return`#${t(e[0])}${t(e[1])}${t(e[2])}`}function Kn([e,t,s]){const n=Math.cbrt(.4122214708*e+.5363325363*t+.0514459929*s),i=Math.cbrt(.2119034982*e+.6806995451*t+.1073969566*s),a=Math.cbrt(.0883024619*e+.2817188376*t+.6299787005*s);return[.2104542553*n+.793617785*i-.0040720468*a,1.9779984951*n-2.428592205*i+.4505937099*a,.0259040371*n+.7827717662*i-.808675766*a]}function $o([e,t,s]){const n=(e+.3963377774*t+.2158037573*s)**3,i=(e-.1055613458*t-.0638541728*s)**3,a=(e-.0894841775*t-1.291485548*s)**3;return[4.0767416621*n-3.3077115913*i+.2309699292*a,-1.2684380046*n+2.6097574011*i-.3413193965*a,-.0041960863*n-.7034186147*i+1.707614701*a]}function bo(e){const[t,s,n]=Kn(e);return{lightness:t,chroma:Math.hypot(s,n),hue:Math.atan2(n,s)*180/Math.PI}}function Ca(e){return e.every(t=>t>=-1e-4&&t<=1+1e-4)}function vo({lightness:e,chroma:t,hue:s}){const n=s*Math.PI/180,i=Math.min(1,Math.max(0,e)),a=c=>$o([i,c*Math.cos(n),c*Math.sin(n)]);let r=a(t);if(!Ca(r)){let c=0,h=t;for(let u=0;u<16;++u){const p=(c+h)/2;Ca(a(p))?c=p:h=p}r=a(c)}const o=c=>Math.min(1,Math.max(0,c));return[o(r[0]),o(r[1]),o(r[2])]}function tp(e,t,s){const n=Kn(e),i=Kn(t),a=c=>n[c]+(i[c]-n[c])*s,r=c=>Math.min(1,Math.max(0,c)),o=$o([a(0),a(1),a(2)]);return[r(o[0]),r(o[1]),r(o[2])]}const Pn=["#69a3cb","#edc06b","#3e9790","#e7917a","#826bb3","#c7d787","#e496b5","#99d6e3","#a6603a","#a9e4ca","#48658b","#e5d6b6","#955b85","#609562","#cab7e3","#7d8792"],ep=19,sp=.03,np=4,ip=.025,ap=4,rp=.7548776662466927,op=.5698402909980532;function yo(e){const t=Te(Pn[e%Pn.length]??"#7d8792"),s=Math.floor(e/Pn.length);if(s===0)return t;const{lightness:n,chroma:i,hue:a}=bo(t);return vo({lightness:n-sp*(s%np),chroma:i,hue:a+ep*s})}function tt(e,t){return go(yo(e))}function x$(e,t){const{lightness:s,chroma:n,hue:i}=bo(yo(e)),a=r=>2*(r-Math.floor(r))-1;return vo({lightness:s+ip*a(.5+t*rp),chroma:n,hue:i+ap*a(.5+t*op)})}const lp={"one-hue":[Te("#dbe5fb"),Te("#1f3f96")],height:[Te("#f3e7c4"),Te("#2f6f6a")]};function cp(e,t){const[s,n]=lp[e];return tp(s,n,Math.min(1,Math.max(0,t)))}function M$(e,t=5){return Array.from({length:t},(s,n)=>go(cp(e,n/(t-1))))}var hp=Object.defineProperty,up=Object.getOwnPropertyDescriptor,ve=(e,t,s,n)=>{for(var i=n>1?void 0:n?up(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&hp(t,s,i),i};const dp=10;let Zt=class extends x{constructor(){super(...arguments),this.parts=[],this.tray=1,this.at=0}stores(){return[this.session.build,this.session.meshes.state]}firstUpdated(){this.input.focus()}standing(){const{live:e,state:t}=this.session.run,n=t.value.packing?.trays[this.tray-1]?.placements??e.trays.get(this.tray)?.copies.values()??[],i=new Map;for(const{part:a,copy:r}of n)i.set(a,[...i.get(a)??[],{part:a,copy:r}]);return i}hits(){const e=(this.session.build.value.find??"").trim().toLowerCase(),t=/^(.*\S)\s+(\d+)$/.exec(e),s=this.standing(),n=[];for(const i of this.parts){const a=s.get(i.index)??[];if(a.length===0)continue;const r=i.name.toLowerCase();if(t?.[1]&&r.includes(t[1])){const o=a.find(c=>c.copy===Number(t[2])-1);o&&n.unshift({part:i,copies:[o],text:`${i.name} ${o.copy+1}`})}r.includes(e)&&n.push({part:i,copies:a,text:i.name})}return n.slice(0,dp)}render(){const e=this.hits(),{meshes:t,build:s}=this.session;return l`<div class="hud find-box card" role="search">
      <span class="in wide">
        ${b("find")}
        <input
          type="search"
          role="combobox"
          aria-expanded="true"
          aria-controls="find-hits"
          aria-activedescendant=${e.length>0?`hit-${this.at}`:d}
          aria-label="Find a copy or part"
          placeholder="fan-blower 4"
          .value=${s.value.find??""}
          @input=${n=>{this.at=0,s.set({find:n.target.value})}}
          @keydown=${n=>this.key(n,e)}
        />
      </span>
      <div id="find-hits" role="listbox" aria-label="Found">
        ${e.map((n,i)=>l`<div
              id="hit-${i}"
              class="li ${i===this.at?"sel":""}"
              role="option"
              aria-selected=${i===this.at}
              @click=${()=>this.take(n)}
            >
              ${X(n.part.mesh?t.picture(n.part.mesh,tt(n.part.index),$.value.theme):null)}
              <span class="cut">${n.text}</span>
              <span class="count">${n.copies.length>1?S(n.copies.length):""}</span>
            </div>`)}
        ${e.length===0?l`<p class="small dim none">Nothing of that name stands in this tray.</p>`:d}
      </div>
    </div>`}key(e,t){if(e.key==="ArrowDown"||e.key==="ArrowUp"){e.preventDefault();const s=e.key==="ArrowDown"?1:t.length-1;this.at=t.length>0?(this.at+s)%t.length:0}else if(e.key==="Enter"){const s=t[this.at];s&&this.take(s)}else e.key==="Escape"&&(e.stopPropagation(),this.session.build.set({find:null}))}take(e){this.session.build.set({selected:e.copies,find:null}),this.dispatchEvent(new CustomEvent("found",{bubbles:!0}))}};ve([g({attribute:!1})],Zt.prototype,"session",2);ve([g({attribute:!1})],Zt.prototype,"parts",2);ve([g({type:Number})],Zt.prototype,"tray",2);ve([O()],Zt.prototype,"at",2);ve([H("input")],Zt.prototype,"input",2);Zt=ve([k("sp-find")],Zt);const pp=1e4,fp=1e5,mp=3e6,gp=800,$p=5e5;class wo{constructor(t,s,n){this.session=t,this.view=s,this.changed=n,this.parts="",this.standing="",this.hidden=[],this.ready=!1,this.asked="",this.labelled="",this.refined=new Set,this.coarseLater=0,this.refining=!1,this.shown=null,this.shownParts=[],this.moving=null,this.handled=null,this.movedTo=null}get placed(){return this.ready?this.standing:""}showLive(t,s,n,i=!0){const{draft:a,info:r}=this.session,o=this.session.parts.meshes,c=jt(a,r,o)??[100,100,100],h=a.keepOut.flatMap(W=>"box"in W?[W.box]:[]),u=a.tray.kind==="mesh"?a.tray.file:null;if(this.setTray(c,a.openHeight,h,u),!this.setParts(t,W=>W.count))return;const p=`live ${n}`,f=p!==this.standing,m=this.standing==="";f&&this.view.clear(),this.standing=p;const{cleared:v,placed:y,removed:M}=s.drain(n,f);v&&!f&&this.view.clear(),M.length>0&&this.view.remove(M);const A=i&&s.newest?.tray===n?s.newest.copy:null,N=y.filter(W=>W.part===A?.part&&W.copy===A.copy),ot=y.filter(W=>!N.includes(W));ot.length>0&&this.view.place(ot),N.length>0&&this.view.place(N,!0),m&&this.view.frame(null)}showPacked(t,s,n,i=!1){const a=this.session.draft.tray.kind==="mesh"?this.session.draft.tray.file:null;if(this.setTray(s.size,s.openHeight,s.keepOut,a),!this.setParts(t,ja(n)))return;const r=`packed ${n.number} ${vp(n)}`;if(r===this.standing)return;const o=this.standing==="",c=this.standing.startsWith(`packed ${n.number} `)?this.shown:null;this.standing=r,this.shown=n,this.shownParts=t,i&&c?this.placeChanged(c,n):(this.view.clear(),this.view.place(n.placements.map(Sn))),o&&this.view.frame(null),this.refine(t,n)}placeChanged(t,s){const n=[...t.byId].filter(([a])=>!s.byId.has(a)).map(([,a])=>a);n.length>0&&this.view.remove(n);const i=s.placements.filter(a=>!yp(t.byId.get(_(a)),a));i.length>0&&this.view.place(i.map(Sn))}showMove(t,s,n){const{copy:i,transform:a}=t;if(this.moving&&(!i||_(i)!==_(this.moving))){const r=s?.byId.get(_(this.moving));r?this.view.place([Sn(r)]):this.view.remove([this.moving]),this.moving=null,this.movedTo=null}i!==this.handled&&this.view.setMoving(i),this.handled=i,this.view.setLeaving(i?[i]:[]),this.view.setMarked(n,i!==null,"bad"),!(!i||a===this.movedTo||!this.ready)&&(this.moving=i,this.movedTo=a,this.view.place([{part:i.part,copy:i.copy,transform:a,order:s?.byId.get(_(i))?.index??0}]))}showView(t,s=[]){this.view.setLocked(s),this.view.setColouring(t.colouring),this.view.setSection(t.section),this.view.setSelected(t.selected);const n=[t.hiddenParts,t.hiddenCopies,t.isolated];n.every((i,a)=>i===this.hidden[a])||(this.hidden=n,this.view.setHidden(i=>qr(t,i)))}showLabels(t,s,n){const i=[...s.length===1?s:[],...n?[n]:[]],a=new Map(i.map(o=>{const c=t.find(h=>h.index===o.part);return[_(o),{copy:o,text:`${c?.name??""} ${o.copy+1}`}]})),r=[...a.keys()].join();r!==this.labelled&&(this.labelled=r,this.view.setLabels([...a.values()]))}setTray(t,s,n,i){const a=i===null?null:this.session.parts.meshes.find(h=>h.file===i),r=a?this.session.meshes.mesh(a):null;a&&!r&&this.session.meshes.load([a]).then(this.changed);const o=JSON.stringify([t,s,n,i,r!==null]);if(o===this.asked)return;this.asked=o;const c=n.map(h=>[...h]);this.view.setTray([t[0],t[1],s?null:t[2]],r??void 0,c)}setParts(t,s){const n=t.map(i=>`${i.index}:${i.mesh?.id}:${i.mesh?.volume}`).join();if(n!==this.parts){this.parts=n,this.ready=!1,this.standing="",this.refined.clear();const i=Ea(t,s,gp),a=i>$p;this.coarseLater=a?i:0,this.load(t,a?"rough":"coarse").then(r=>{n===this.parts&&(this.view.setParts(r),this.ready=!0,this.changed())})}return this.ready}async load(t,s){const{meshes:n}=this.session;return await n.load(t.flatMap(i=>i.mesh?[i.mesh]:[]),s),t.flatMap(i=>{const a=i.mesh?n.mesh(i.mesh,s):null;return a?[{index:i.index,name:i.name,mesh:a}]:[]})}paced(){this.shown&&this.ready&&this.refine(this.shownParts,this.shown)}async refine(t,s){if(!this.refining){this.refining=!0;try{await this.coarsen(t),await this.fine(t,s)}finally{this.refining=!1}}}async coarsen(t){const s=this.coarseLater>0?this.view.draws(this.coarseLater):"never";if(s==="never")return;const n=this.parts,i=await this.load(t,"coarse");n===this.parts&&(this.coarseLater=0,this.view.refine(new Map(i.map(({index:a,mesh:r})=>[a,r])),s==="slowly"))}async fine(t,s){if(this.coarseLater>0)return;const n=ja(s),i=Ea(t,n,pp);if(i>mp||i>fp&&this.view.draws(i)!=="fast")return;const a=this.parts;for(const r of t){if(!r.mesh||n(r)===0||this.refined.has(r.index))continue;const o=await this.session.meshes.fine(r.mesh);if(a!==this.parts||!this.standing.startsWith(`packed ${s.number} `))return;!o||this.refined.has(r.index)||(this.refined.add(r.index),this.view.refine(new Map([[r.index,o]])))}}}function ja(e){let t=null;return s=>{if(!t){t=new Map;for(const{part:n}of e.placements)t.set(n,(t.get(n)??0)+1)}return t.get(s.index)??0}}function Ea(e,t,s){return e.reduce((n,i)=>n+Math.min(s,i.mesh?.triangles??0)*t(i),0)}const La=new WeakMap;let bp=0;function vp(e){const t=La.get(e)??++bp;return La.set(e,t),t}function yp(e,t){return!e||e.step!==t.step||e.index!==t.index?!1:e.transform.every((s,n)=>s.every((i,a)=>i===t.transform[n]?.[a]))}function Sn(e){const{part:t,copy:s,transform:n,index:i,step:a}=e;return a===null?{part:t,copy:s,transform:n,order:i}:{part:t,copy:s,transform:n,order:i,step:a}}var wp=Object.defineProperty,kp=Object.getOwnPropertyDescriptor,q=(e,t,s,n)=>{for(var i=n>1?void 0:n?kp(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&wp(t,s,i),i};let R=class extends x{constructor(){super(...arguments),this.label="",this.unit="",this.value=null,this.least=Number.NEGATIVE_INFINITY,this.most=Number.POSITIVE_INFINITY,this.above=!1,this.step=1,this.digits=2,this.places=0,this.optional=!1,this.placeholder="",this.mixed=!1,this.disabled=!1,this.classes="n",this.tab=0,this.problem="",this.typing=!1}focus(){this.input?.focus(),this.input?.select()}shown(){return this.mixed||this.value===null?"":this.places>0&&Number.isInteger(this.value*10**this.places)?this.value.toFixed(this.places):Mt(this.value,Math.max(this.digits,this.places))}updated(){const e=this.shown();!this.typing&&this.input.value!==e&&(this.input.value=e)}render(){return l`<span class="in ${this.classes} ${this.problem?"wrong":""}">
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
          @wheel=${{handleEvent:e=>this.wheel(e),passive:!1}}
        />${this.unit?l`<span class="u">${this.unit}</span>`:d}</span
      >${this.problem?l`<span class="range" role="alert">${this.problem}</span>`:d}`}typed(){this.typing=!0,this.problem=""}commit(){if(!this.typing)return;const e=this.input.value.trim();if(e===""&&(this.optional||this.mixed)){this.done(this.mixed?void 0:null);return}const t=gt(e);if(t===null||t>this.most||(this.above?t<=this.least:t<this.least)){this.problem=this.range();return}this.done(Number(t.toFixed(this.digits)))}done(e){this.typing=!1,this.problem="";const t=this.value;e!==void 0&&(e!==t||this.mixed)&&this.dispatchEvent(new CustomEvent("value",{detail:e,bubbles:!0})),this.requestUpdate(),this.input.value=e===void 0||e===t?this.shown():this.input.value}range(){const{least:e,most:t}=this,s=this.above?`more than ${Mt(e)}`:`${Mt(e)} or more`;return Number.isFinite(e)&&Number.isFinite(t)?`${Mt(e)} to ${Mt(t)}`:Number.isFinite(e)?s:Number.isFinite(t)?`${Mt(t)} or less`:"A number"}key(e){e.key==="Enter"?this.commit():e.key==="Escape"&&this.typing?(e.stopPropagation(),this.typing=!1,this.problem="",this.input.value=this.shown()):(e.key==="ArrowUp"||e.key==="ArrowDown")&&(e.preventDefault(),e.stopPropagation(),this.stepBy(e.key==="ArrowUp"?1:-1,e.shiftKey))}wheel(e){document.activeElement!==this.input||this.disabled||(e.preventDefault(),this.stepBy(e.deltaY<0?1:-1,e.shiftKey))}stepBy(e,t){const i=((this.typing?gt(this.input.value):this.value)??(Number.isFinite(this.least)?this.least:0))+e*this.step*(t?10:1),a=this.above?this.least+this.step:this.least;this.typing=!0,this.input.value=Mt(Math.min(this.most,Math.max(a,i)),this.digits),this.commit()}};q([g()],R.prototype,"label",2);q([g()],R.prototype,"unit",2);q([g({attribute:!1})],R.prototype,"value",2);q([g({type:Number})],R.prototype,"least",2);q([g({type:Number})],R.prototype,"most",2);q([g({type:Boolean})],R.prototype,"above",2);q([g({type:Number})],R.prototype,"step",2);q([g({type:Number})],R.prototype,"digits",2);q([g({type:Number})],R.prototype,"places",2);q([g({type:Boolean})],R.prototype,"optional",2);q([g()],R.prototype,"placeholder",2);q([g({type:Boolean})],R.prototype,"mixed",2);q([g({type:Boolean})],R.prototype,"disabled",2);q([g()],R.prototype,"classes",2);q([g({type:Number})],R.prototype,"tab",2);q([O()],R.prototype,"problem",2);q([H("input")],R.prototype,"input",2);R=q([k("sp-number")],R);const xp={x:0,y:1,z:2};function xi(e,t){const{packing:s}=e.run.state.value;return s?.size[xp[t]]??0}function ko(e,t,s){if(s?.axis===t)return s;const{packing:n}=e.run.state.value,i=n?.trays[e.build.value.tray-1],a=t==="z"&&i?i.height:xi(e,t);return{axis:t,at:Math.round(a*5)/10,flipped:!1}}function xo(e,t,s){const{packing:n}=e.run.state.value,a=n?.trays[e.build.value.tray-1]?.layers?.thickness??1,r=Math.max(0,Math.min(xi(e,t.axis),t.at+s*a));return{...t,at:Math.round(r*10)/10}}function Mp(e,t){const s=e.run.live.newest,n=t.find(a=>a.index===s?.copy.part);if(!s||!n)return d;const i=n.mesh?e.meshes.picture(n.mesh,tt(n.index),$.value.theme):null;return l`<div class="glass placed">
    ${X(i)}
    <span><span class="small dim">Just placed</span><b class="cut">${n.name} ${s.copy.copy+1}</b></span>
  </div>`}function _p(e,t){const{build:s}=e,{colouring:n}=s.value;return l`<div class="stack">
    <div class="glass">
      <span class="lab hide-s">Colour by</span>
      ${te("Colour by",$s,n,i=>s.set({colouring:i}),"s flat")}
    </div>
    ${t&&n!=="part"?Op(t,n==="height"?`${L}mm`:""):d}
  </div>`}function Op(e,t){return l`<div class="glass legend" role="img" aria-label="Legend: ${e.values.map(Math.round).join(", ")}${t}">
    <i ${B({background:`linear-gradient(90deg, ${e.colours.join(", ")})`})}></i>
    <span class="row between">${e.values.map(s=>l`<span>${Math.round(s)}${t}</span>`)}</span>
  </div>`}const Pp=[{side:"home",text:"All of it, from the corner"},{side:"front",text:"From the front"},{side:"back",text:"From the back"},{side:"left",text:"From the left"},{side:"right",text:"From the right"},{side:"top",text:"From above"}];function Mo(e){return l`<sp-menu
    label="Look from"
    hint="Look from"
    buttonClasses="btn ghost icon float"
    .button=${b("box")}
    .content=${()=>l`${Pp.map(({side:t,text:s})=>l`<button type="button" class="mi plain" role="menuitem" @click=${()=>e(t)}>
            <span>${s}</span>
          </button>`)}`}
  ></sp-menu>`}function _o(e){const{build:t}=e,{selected:s,isolated:n}=t.value,i=s.length>0,a=qh(t.value),r=(c,h,u,p)=>l`<button type="button" class="mi plain" role="menuitem" ?disabled=${u} @click=${p}>
      <span>${c}</span><kbd>${h}</kbd>
    </button>`,o=n?"Show the others again":"Show only what is selected";return l`<sp-menu
    label="Hide and show"
    hint="Hide and show"
    buttonClasses="btn ghost icon float ${a?"on":""}"
    .button=${b(a?"eyeOff":"eye")}
    .content=${()=>l`
      ${r("Hide what is selected","H",!i,()=>t.set(Vr(t.value)))}
      ${r(o,"I",!i&&!n,()=>t.set(Kr(t.value)))}
      ${r("Show all","Shift H",!a,()=>t.set(Wr))}
    `}
  ></sp-menu>`}function Sp(e){const{build:t}=e,{section:s}=t.value,n=i=>t.set({section:i===null?null:ko(e,i,s)});return l`<div class="glass">
    <span class="lab hide-s">Section</span>
    ${te("Section",[{value:null,text:"Off"},{value:"x",text:"X"},{value:"y",text:"Y"},{value:"z",text:"Z"}],s?.axis??null,n,"s flat")}
    ${s?Tp(e,s):d}
  </div>`}function Tp(e,t){const s=n=>e.build.set({section:{...t,...n}});return l`<sp-number
      label=${`Section at ${t.axis.toUpperCase()}`}
      unit="mm"
      classes="s at"
      .value=${t.at}
      .least=${0}
      .most=${xi(e,t.axis)}
      .places=${1}
      .digits=${1}
      @value=${n=>s({at:n.detail??0})}
    ></sp-number>
    ${D("flip","Other side (B)",()=>s({flipped:!t.flipped}),"s hide-s")}`}function Ap(e){return l`<div class="glass">
    <span class="lab hide-s">Show</span>
    ${te("Show",[{value:"left",text:"What is left"},{value:"apart",text:"All, drawn apart"}],e.state.value.show,t=>e.setShow(t),"s flat words")}
  </div>`}function Cp(e,t,s){const{build:n}=e,{find:i}=n.value;return l`<div class="glass">
    ${D("frame","Frame all (Shift+F)",s,"float")} ${Mo(t)} ${_o(e)}
    ${D("find","Find a copy or part (/)",()=>n.set({find:i===null?"":null}),"float")}
  </div>`}function jp(e,t,s,n){const{tray:i}=e,a=fo(t),r=a?i.placements[a.placements[0]??-1]:void 0,o=t.show==="apart",c=[a&&r?_e(tt(r.part,$.value.theme),a.makes===null?"leaves now":"leave together",!0):d,s&&!a?.placements.includes(s.index)?_e("var(--select)","selected",!0):d,n?_e("var(--warn-mark)","in its way"):d,o||!a||t.alone!==null?d:_e("var(--stay)","stays"),(t.faint||o)&&t.step>0?_e("var(--stay)","has left",!1,"faint-mark"):d].filter(h=>h!==d);return c.length>0?l`<div class="glass keys-bar">${c}</div>`:d}function _e(e,t,s=!1,n=""){return l`<span><i class="${s?"outlined":""} ${n}" ${B({background:e})}></i>${t}</span>`}function Ep(e,t,s){const n=e.plan.assemblies[s]?.members.length??0;return l`<div class="hud bc">
    <div class="glass alone-bar">
      <span class="lab">Only the group of ${n}</span>
      <button type="button" class="btn s" @click=${()=>t.playAlone(null)}>Show all again</button>
    </div>
  </div>`}const Na=.55,Lp=.9;function Np(e,t,s){const n=t.map(i=>i?Da(i,s):[0,0,0]);for(const i of[...e.assemblies].reverse()){if(i.madeBy<0)continue;const a=Gn(i.members.flatMap(r=>t[r]??[]));if(a)for(const r of i.members)n[r]=Da(a,s)}return n}function Da({low:e,high:t},s){const n=[0,1,2].map(i=>((e[i]??0)+(t[i]??0))/2);return[Na*((n[0]??0)-s[0]/2),Na*((n[1]??0)-s[1]/2),Lp*e[2]]}function Gn(e){const[t]=e;if(!t)return null;const s=[...t.low],n=[...t.high];for(const i of e)for(let a=0;a<3;a+=1)s[a]=Math.min(s[a]??0,i.low[a]??0),n[a]=Math.max(n[a]??0,i.high[a]??0);return{low:s,high:n}}function Dp({low:e,high:t},s){return{low:[e[0]+s[0],e[1]+s[1],e[2]+s[2]],high:[t[0]+s[0],t[1]+s[1],t[2]+s[2]]}}const Fp=.12;function Ip(e,t,s){const n=Math.floor(s);if((e.outAt[t]??0)<n)return{kind:"out"};let i=[0,0,0];for(const a of e.stepsOf[t]??[]){const r=e.steps[a];if(!r||a>n)break;if(a===n)return{kind:"moves",offset:Yt(Oo(e,r),zp(r,s-n))};r.makes!==null&&(i=e.assemblies[r.makes]?.offset??i)}return{kind:"stands",offset:i}}function Oo(e,t){return e.assemblies[t.from]?.offset??[0,0,0]}function zp(e,t){return Po(e,t).offset}function Rp(e,t){return Po(e,t).distance}function Po(e,t){const s=e.path.map(po),n=s.reduce((c,h)=>c+h,0),i=s.map(c=>Math.max(c,Fp*n));let a=i.reduce((c,h)=>c+h,0)*Math.min(1,Math.max(0,t)),r=[0,0,0],o=0;return e.path.forEach((c,h)=>{const u=i[h]??0,p=u>0?Math.min(1,Math.max(0,a/u)):1;a-=u,r=Yt(r,[c[0]*p,c[1]*p,c[2]*p]),o+=(s[h]??0)*p}),{offset:r,distance:o}}function Up(e,t,s){const n=[Yt(s,Oo(e,t))];for(const i of t.path)n.push(Yt(n[n.length-1]??s,i));return n}const Bp=.35;class Hp{constructor(t){this.view=t,this.apart=null,this.placed="",this.shown=[],this.exploded=[],this.told=new Map}show(t,s,n){(t!==this.apart||s!==this.placed)&&(this.apart=t,this.placed=s,this.shown=t.tray.placements.map(()=>[0,0,0]),this.exploded=Np(t.plan,t.extents,t.packing.size),this.told.clear()),this.move(t,n),this.paint(t,n)}move(t,s){const n=[],i=[];t.tray.placements.forEach((a,r)=>{const o=this.target(t,r,s),c=this.shown[r]??null;(o===null?c===null:c!==null&&o[0]===c[0]&&o[1]===c[1]&&o[2]===c[2])||(this.shown[r]=o,o?n.push(Vp(a,o)):i.push({part:a.part,copy:a.copy}))}),i.length>0&&this.view.remove(i),n.length>0&&this.view.place(n)}target(t,s,{time:n,player:i}){if(i.show==="apart")return this.exploded[s]??[0,0,0];const a=Ip(t.plan,s,n);return a.kind!=="out"?a.offset:i.faint?[0,0,0]:null}paint(t,s){const{player:n,selected:i,hovered:a,blockers:r,time:o}=s,{view:c}=this,{tray:h}=t,u=fo(n),p=n.show==="apart",f=A=>A.flatMap(N=>h.placements[N]??[]).map(Tn),m=u?.placements??[],v=Math.floor(o),y=(A,N,ot)=>{const W=JSON.stringify(N);this.told.get(A)!==W&&(this.told.set(A,W),ot())};y("leaving",m,()=>c.setLeaving(f(m),!0)),y("selected",i?.index,()=>c.setSelected(i?[Tn(i)]:[])),y("marked",[r,p],()=>c.setMarked(f(r),!p));const M=n.faint||p;y("faint",M?v:-1,()=>{const A=N=>qp(t,N,v);c.setFaint(M?A:null)}),this.setHidden(t,s),y("labels",[u?.index,i?.index,a],()=>c.setLabels(this.labels(t,u,i,a))),y("path",[p,u?.index],()=>c.setPath(u&&!p?this.path(t,u):null)),y("follow",[n.follow&&!p,m],()=>c.setFollowed(n.follow&&!p&&m.length>0?f(m):null)),y("surround",p,()=>c.setSurround(p?this.explodedBox(t):Wp(t)))}setHidden(t,{player:s,hidden:n}){const{alone:i}=s,a=this.told.get("hidden");if(a?.[0]===i&&a[1]===n)return;this.told.set("hidden",[i,n]);const r=i===null?null:new Set(t.plan.assemblies[i]?.members);this.view.setHidden(o=>{if(!r)return n(o);const c=t.tray.byId.get(_(o));return!c||!r.has(c.index)})}labels(t,s,n,i){const a=new Map,r=s?.placements[0];s&&r!==void 0&&a.set(r,s.makes===null?t.nameOf(r):`Group of ${s.placements.length}`);const o=i?t.tray.byId.get(_(i)):void 0;for(const c of[n,o])c&&!a.has(c.index)&&a.set(c.index,t.nameOf(c.index));return[...a].flatMap(([c,h])=>{const u=t.tray.placements[c];return u?[{copy:Tn(u),text:h,beside:c===r}]:[]})}path(t,s){const n=Gn(s.placements.flatMap(a=>t.extents[a]??[]));if(!n||s.path.length===0)return null;const i=[(n.low[0]+n.high[0])/2,(n.low[1]+n.high[1])/2,(n.low[2]+n.high[2])/2];return Up(t.plan,s,i)}explodedBox(t){const s=t.extents.flatMap((i,a)=>i?[Dp(i,this.exploded[a]??[0,0,0])]:[]),n=Gn(s);return n?[n.low,n.high]:null}}function Tn({part:e,copy:t}){return{part:e,copy:t}}function qp(e,t,s){const n=e.tray.byId.get(_(t));return n!==void 0&&(e.plan.outAt[n.index]??0)<s}function Wp({packing:e,tray:t}){const[s,n,i]=e.size,a=e.openHeight?t.height:i;return[[0,0,0],[s,n,a*(1+Bp)]]}function Vp(e,t){const{part:s,copy:n,transform:i,index:a}=e,r=[...t,0],o=i.map((c,h)=>c.map((u,p)=>p===3?u+(r[h]??0):u));return{part:s,copy:n,transform:o,order:a}}const Kp=Math.sin(Math.PI/12),Gp=[["to the right","to the left"],["to the back","to the front"],["up","down"]],Jn=e=>Math.hypot(e[0],e[1],e[2]);function Jp(e){const t=Jn(e)||1;return e.map((s,n)=>({share:Math.abs(s)/t,text:Gp[n]?.[s<0?1:0]??""})).filter(({share:s})=>s>Kp).sort((s,n)=>n.share-s.share).map(({text:s})=>s).join(" and ")}function Yn(e){return`${e.toFixed(e<9.95?1:0)}${L}mm`}const Fa=.5;function So(e){const t=[],s=e.some(n=>Jn(n)>=Fa)?Fa:Number.MIN_VALUE;for(const n of e){const i=Jn(n),a=Jp(n),r=t[t.length-1];i<s||(r?.text===a?r.length+=i:t.push({text:a,length:i}))}return t}function Yp(e){const t=So(e),[s]=t;return s?t.length>1?t.map(({text:i,length:a})=>`${i} ${Yn(a)}`).join(", then "):`${s.text==="up"||s.text==="down"?"straight ":""}${s.text}, ${Yn(s.length)}`:null}function Zp(e){const t=So(e),[s]=t;if(!s)return"none";if(t.length>1)return"bend";const n={up:"up",down:"down","to the left":"left","to the right":"right"}[s.text];return n||(s.text==="to the back"?"back":s.text==="to the front"?"front":"slant")}function nn(e,t){return t.makes===null?e.nameOf(t.placements[0]??-1):`Group of ${t.placements.length}`}function cs(e){return Yp(e.path)??"nothing is left around it"}function Mi(e,t){const{plan:s}=e,n=s.steps[t];if(!n)return To(e);const i=uo(s,t-1),a=`${nn(e,n)}, ${cs(n)}`;return`Step ${w(t+1)} of ${w(s.steps.length)}: ${a}. ${S(i)} ${i===1?"is":"are"} left.`}function To({plan:e}){const{length:t}=e.staying;return t===0?"All copies are out.":`All steps are done. ${S(t)} ${t===1?"stays":"stay"} in the tray.`}var Xp=Object.defineProperty,Qp=Object.getOwnPropertyDescriptor,ee=(e,t,s,n)=>{for(var i=n>1?void 0:n?Qp(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Xp(t,s,i),i};let St=class extends x{constructor(){super(...arguments),this.lost=!1,this.failed="",this.hovered=null,this.view=null,this.trays=null,this.scene=null,this.loading=!1,this.noPicture=null,this.noClock=null,this.hiddenOf=[],this.concealed=()=>!1}stores(){const{session:e}=this;return[e.run.state,e.build,this.apart.ways.state,this.player.state,$]}get player(){return at(this.session)}connectedCallback(){super.connectedCallback(),this.noClock=this.player.clock.subscribe(()=>this.sync())}disconnectedCallback(){super.disconnectedCallback(),this.noClock?.(),this.end()}updated(e){this.view?this.sync():this.begin()}async begin(){if(!(this.loading||this.failed)){this.loading=!0;try{const{createTrayView:e}=await Hr();if(!this.isConnected)return;const t=e(this.stage,{select:s=>this.select(s),hover:s=>{this.hovered=s},paced:()=>this.trays?.paced(),lost:s=>{this.lost=s}},$.value.theme);this.view=t,this.trays=new wo(this.session,t,()=>this.requestUpdate()),this.scene=new Hp(t),this.noPicture=ao(()=>t.picture(this.stage.clientWidth*2,this.stage.clientHeight*2)),this.requestUpdate()}catch{this.failed="This browser draws no 3D graphics. The list of steps and the export work without them."}finally{this.loading=!1}}}end(){this.noPicture?.(),this.view?.dispose(),this.view=null,this.trays=null,this.scene=null}again(){this.end(),this.lost=!1,this.requestUpdate()}sync(){const{view:e,trays:t,scene:s,apart:n,session:i}=this;!e||!t||!s||(e.setTheme($.value.theme),t.showPacked(n.parts,n.packing,n.tray),!(t.placed===""||!n.measured)&&s.show(n,t.placed,{time:this.player.time,player:this.player.state.value,selected:le(i,n.tray),hovered:this.hovered,blockers:this.blockers(),hidden:this.hiddenTest()}))}blockers(){const{step:e}=this.player.state.value,{found:t}=this.apart.ways.state.value;return(t??[]).filter(s=>s.step>=e).map(s=>s.placement)}hiddenTest(){const e=this.session.build.value,t=[e.hiddenParts,e.hiddenCopies,e.isolated];return t.every((s,n)=>s===this.hiddenOf[n])||(this.hiddenOf=t,this.concealed=s=>qr(e,s)),this.concealed}select(e){const t=e?this.apart.tray.byId.get(_(e)):null;ls(this.session,t??null)}frame(e){const{apart:t,player:s}=this,n=le(this.session,t.tray),i=t.plan.steps[s.state.value.step]?.placements??[],a=n?[n]:i.flatMap(r=>t.tray.placements[r]??[]);this.view?.frame(e||a.length===0?null:a)}render(){const{session:e,apart:t,player:s}=this,{find:n}=e.build.value,{step:i,alone:a}=s.state.value;return l`<section class="view tray" aria-label="Tray coming apart">
      <div class="stage"></div>
      <p class="out">${Mi(t,i)}</p>
      <div class="hud tl">${Ap(s)}</div>
      <div class="hud tr">${Cp(e,r=>this.view?.look(r),()=>this.frame(!0))}</div>
      ${n===null?d:l`<sp-find .session=${e} .parts=${t.parts} .tray=${t.tray.number} @found=${()=>this.frame(!1)}></sp-find>`}
      <div class="hud bl">${jp(t,s.state.value,le(e,t.tray),this.blockers().length>0)}</div>
      ${a===null?d:Ep(t,s,a)}
      ${this.failed||this.lost?l`<div class="lost">
              <p>${this.failed||"The graphics card took the picture away."}</p>
              ${this.failed?d:l`<button type="button" class="btn" @click=${this.again}>Draw again</button>`}
            </div>`:d}
    </section>`}};ee([g({attribute:!1})],St.prototype,"session",2);ee([g({attribute:!1})],St.prototype,"apart",2);ee([H(".stage")],St.prototype,"stage",2);ee([O()],St.prototype,"lost",2);ee([O()],St.prototype,"failed",2);ee([O()],St.prototype,"hovered",2);St=ee([k("sp-apart-tray")],St);const tf=.06,ef=.98;function sf(e,t){const s=e.steps.length,n=Math.max(1,Math.min(s,Math.floor(t))),i=new Array(n).fill(0);for(const o of e.steps){const c=Math.min(n-1,Math.floor(o.index*n/s));i[c]=Math.max(i[c]??0,o.length)}const a=[...i].sort((o,c)=>o-c),r=a[Math.min(n-1,Math.floor(ef*n))]||a[n-1]||1;return i.map((o,c)=>({from:c/n,to:(c+1)/n,height:Math.max(tf,Math.min(1,o/r))}))}function nf(e,t){const n=[1,2,5].flatMap(a=>[1,10,100,1e3,1e4].map(r=>a*r)).sort((a,r)=>a-r).find(a=>a>=t)??e,i=[1];for(let a=n;a<e;a+=n)a-1>=t*.6&&e-a>=t*.6&&i.push(a);return e>1&&i.push(e),i}function af(e){const t=[];for(let s=0;s<e.steps.length;)s=Ao(e,s,0,t);return e.staying.length>0&&(t.push({kind:"caption",count:e.staying.length}),t.push(...e.staying.map(s=>({kind:"stays",placement:s})))),t}function Ao(e,t,s,n){const i=e.steps[t];if(!i)return t+1;if(i.makes===null)return n.push({kind:"step",step:t,depth:s,last:!1}),t+1;n.push({kind:"group",step:t,depth:s});const a=Co(e,i.makes),r=new Set(a.flatMap(h=>e.steps[h]?.placements??[]));let o=t+1;for(;o<=t+a.length;)o=Ao(e,o,s+1,n);for(const h of i.placements)r.has(h)||n.push({kind:"member",placement:h,depth:s+1,last:!1});const c=n[n.length-1];return s===0&&c&&(c.kind==="step"||c.kind==="member")&&(n[n.length-1]={...c,last:!0}),o}function Co(e,t){const s=e.assemblies[t]?.madeBy??-1;return ki(e,t).map(n=>n.index).filter((n,i)=>n===s+1+i)}function rf(e){const t=[];return e.forEach((s,n)=>{(s.kind==="step"||s.kind==="group")&&(t[s.step]=n)}),t}function of(e){return e.assemblies.filter(t=>t.madeBy>=0).map(t=>({first:t.madeBy,last:t.madeBy+Co(e,t.number).length}))}var lf=Object.defineProperty,cf=Object.getOwnPropertyDescriptor,ye=(e,t,s,n)=>{for(var i=n>1?void 0:n?cf(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&lf(t,s,i),i};const hf=3,uf=64,df=5;let Xt=class extends x{constructor(){super(...arguments),this.width=0,this.hovered=null,this.bars=null,this.barsFor=[],this.noClock=null,this.resume=!1,this.sizes=new ResizeObserver(()=>{this.width=this.track.clientWidth}),this.hover=e=>{e.pointerType!=="touch"&&(this.hovered=Math.min(this.steps-1,Math.floor(this.timeAt(e))))},this.grab=e=>{if(e.button!==0)return;const{track:t,player:s}=this;this.resume=s.state.value.playing,t.setPointerCapture(e.pointerId),s.seek(this.timeAt(e));const n=i=>s.seek(this.timeAt(i));t.addEventListener("pointermove",n),t.addEventListener("lostpointercapture",()=>{t.removeEventListener("pointermove",n),this.resume&&s.play()},{once:!0})}}stores(){return[this.player.state]}connectedCallback(){super.connectedCallback(),this.noClock=this.player.clock.subscribe(()=>this.placeHead())}disconnectedCallback(){super.disconnectedCallback(),this.noClock?.(),this.sizes.disconnect()}firstUpdated(){this.sizes.observe(this.track)}updated(e){this.placeHead(),!e.has("hovered")&&this.player.state.value.step!==this.hovered&&(this.hovered=null)}get steps(){return Math.max(1,this.apart.plan.steps.length)}placeHead(){if(!this.track)return;const e=Math.min(1,this.player.time/this.steps);this.track.style.setProperty("--at",`${(100*e).toFixed(3)}%`)}render(){const{apart:e,player:t,hovered:s,steps:n}=this,{step:i}=t.state.value,a=Math.min(i,e.plan.steps.length-1);return l`<div
      class="track"
      role="slider"
      tabindex="0"
      aria-label="Step"
      aria-valuemin="1"
      aria-valuemax=${e.plan.steps.length}
      aria-valuenow=${a+1}
      aria-valuetext=${Mi(e,i)}
      @pointerdown=${this.grab}
      @pointermove=${this.hover}
      @pointerleave=${()=>{this.hovered=null}}
    >
      ${this.drawnBars()}
      <span class="now-bar" ${B({left:`${100*a/n}%`,width:`max(${100/n}%, 2px)`})}></span>
      <span class="head-line"></span>
      ${this.ticks()}
      ${s===null?d:this.tip(s)}
    </div>`}drawnBars(){const{plan:e}=this.apart;if(this.bars&&this.barsFor[0]===e&&this.barsFor[1]===this.width)return this.bars;this.barsFor=[e,this.width];const t=sf(e,Math.max(40,this.width/hf)),s=.3/t.length,n=t.map(({from:a,to:r,height:o})=>`M${a+s/2} 1V${1-o}H${r-s/2}V1z`).join(""),i=a=>l`<svg class="bars ${a}" viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
        ${oe`<path d=${n} />`}
      </svg>`;return this.bars=l`${i("")}${i("done")}${of(e).map(({first:a,last:r})=>l`<span
          class="bracket"
          ${B({left:`${100*a/this.steps}%`,width:`max(${100*(r+1-a)/this.steps}%, 6px)`})}
        ></span>`)}`,this.bars}ticks(){const{steps:e}=this,{step:t}=this.player.state.value,s=Math.min(t+1,e),n=uf*e/Math.max(1,this.width),i=a=>`${100*(a-.5)/e}%`;return[...nf(e,n).filter(a=>Math.abs(a-s)>n*.55).map(a=>l`<span class="tick" ${B({left:i(a)})}>${w(a)}</span>`),l`<b class="tick now" ${B({left:i(s)})}>${w(s)}</b>`]}tip(e){const t=this.apart.plan.steps[e],s=(e+.5)/this.steps;return l`<span class="tip" ${B({left:`clamp(60px, ${100*s}%, calc(100% - 60px))`})}
      >${w(e+1)} ${t?nn(this.apart,t):""}</span
    >`}timeAt(e){const{left:t,width:s}=this.track.getBoundingClientRect(),i=Math.min(1,Math.max(0,(e.clientX-t)/Math.max(1,s)))*this.steps;return s/this.steps>=df?i:Math.round(i)}};ye([g({attribute:!1})],Xt.prototype,"player",2);ye([g({attribute:!1})],Xt.prototype,"apart",2);ye([O()],Xt.prototype,"width",2);ye([O()],Xt.prototype,"hovered",2);ye([H(".track")],Xt.prototype,"track",2);Xt=ye([k("sp-timeline")],Xt);var pf=Object.defineProperty,ff=Object.getOwnPropertyDescriptor,_i=(e,t,s,n)=>{for(var i=n>1?void 0:n?ff(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&pf(t,s,i),i};let Es=class extends x{get player(){return at(this.session)}stores(){return[this.player.state]}render(){const{player:e,apart:t}=this,{step:s,playing:n,speed:i}=e.state.value,{length:a}=t.plan.steps,r=n?"Pause (Space)":"Play (Space)";return l`<footer class="dock player" aria-label="Player">
      <div class="row controls">
        ${D("first","To the start (Home)",()=>e.seek(0))}
        ${D("stepBack","Step back (←)",()=>e.move(-1))}
        <button type="button" class="play" aria-label=${r} title=${r} @click=${()=>e.toggle()}>
          ${b(n?"pause":"play")}
        </button>
        ${D("stepOn","Step on (→)",()=>e.move(1))}
        ${D("last","To the end (End)",()=>e.seek(a))}
      </div>
      <sp-timeline .player=${e} .apart=${t}></sp-timeline>
      <div class="row count-speed">
        <div class="num">
          <b>${w(Math.min(s+1,a))}</b> <span class="dim">of ${w(a)}</span>
          <div class="small faint hide-s">bar height: distance</div>
        </div>
        ${Kt("Speed",Bd.map(o=>({value:String(o),text:`${o}×`})),String(i),o=>e.setSpeed(Number(o)),"s")}
      </div>
    </footer>`}};_i([g({attribute:!1})],Es.prototype,"session",2);_i([g({attribute:!1})],Es.prototype,"apart",2);Es=_i([k("sp-player")],Es);/**
 * @license
 * Copyright 2017 Google LLC
 * SPDX-License-Identifier: BSD-3-Clause
 */const Ia=(e,t,s)=>{const n=new Map;for(let i=t;i<=s;i++)n.set(e[i],i);return n},an=ui(class extends di{constructor(e){if(super(e),e.type!==$r.CHILD)throw Error("repeat() can only be used in text expressions")}dt(e,t,s){let n;s===void 0?s=t:t!==void 0&&(n=t);const i=[],a=[];let r=0;for(const o of e)i[r]=n?n(o,r):r,a[r]=s(o,r),r++;return{values:a,keys:i}}render(e,t,s){return this.dt(e,t,s).values}update(e,[t,s,n]){const i=Yl(e),{values:a,keys:r}=this.dt(t,s,n);if(!Array.isArray(i))return this.ut=r,a;const o=this.ut??=[],c=[];let h,u,p=0,f=i.length-1,m=0,v=a.length-1;for(;p<=f&&m<=v;)if(i[p]===null)p++;else if(i[f]===null)f--;else if(o[p]===r[m])c[m]=Nt(i[p],a[m]),p++,m++;else if(o[f]===r[v])c[v]=Nt(i[f],a[v]),f--,v--;else if(o[p]===r[v])c[v]=Nt(i[p],a[v]),Me(e,c[v+1],i[p]),p++,v--;else if(o[f]===r[m])c[m]=Nt(i[f],a[m]),Me(e,i[p],i[f]),f--,m++;else if(h===void 0&&(h=Ia(r,m,v),u=Ia(o,p,f)),h.has(o[p]))if(h.has(o[f])){const y=u.get(r[m]),M=y!==void 0?i[y]:null;if(M===null){const A=Me(e,i[p]);Nt(A,a[m]),c[m]=A}else c[m]=Nt(M,a[m]),Me(e,i[p],M),i[y]=null;m++}else xn(i[f]),f--;else xn(i[p]),p++;for(;m<=v;){const y=Me(e,c[v+1]);Nt(y,a[m]),c[m++]=y}for(;p<=f;){const y=i[p++];y!==null&&xn(y)}return this.ut=r,br(e,c),yt}}),mf={up:"goUp",down:"goDown",left:"goLeft",right:"goRight",back:"goBack",front:"goFront",slant:"goBack",bend:"goBend",none:"check"};function gf(e){const{row:t}=e;switch(t.kind){case"step":return $f(e,t.step,t.depth,t.last);case"group":return bf(e,t.step,t.depth);case"member":return za(e,t.placement,`${Oi(t.depth)}${t.last?" last":""}`);case"stays":return za(e,t.placement,"");default:return l`<div class="stp caption" role="listitem"><span>${S(t.count)} without a way out</span></div>`}}function $f(e,t,s,n){const{apart:i}=e,a=i.plan.steps[t],r=a?.placements[0];if(!a||r===void 0)return l``;const o=i.nameOf(r);return l`<div
    class="stp ${jo(e,t)} ${Oi(s)} ${n?"last":""} ${r===e.selected?"chosen":""}"
    role="listitem"
    aria-current=${t===e.step?"step":d}
  >
    ${Eo(e,a)}<span class="n">${w(t+1)}</span>${No(e,r)}
    <span class="cut" title=${o}>${o}</span>${Lo(a)}
  </div>`}function bf(e,t,s){const n=e.apart.plan.steps[t];return n?l`<div
    class="stp grp ${jo(e,t)} ${Oi(s)}"
    role="listitem"
    aria-current=${t===e.step?"step":d}
  >
    ${Eo(e,n)}<span class="n">${w(t+1)}</span>
    <span class="cut">Group of ${n.placements.length}</span>${Lo(n)}
  </div>`:l``}function za(e,t,s){const{apart:n,session:i}=e,a=n.tray.placements[t],r=n.plan.outAt[t]??Number.POSITIVE_INFINITY,o=n.nameOf(t),c=Number.isFinite(r)?`step ${w(r+1)}`:a?.fixed?"fixed":"stays";return l`<div class="stp ${s} ${t===e.selected?"chosen":""}" role="listitem">
    <button type="button" class="whole" aria-label="Select ${o}" @click=${()=>ls(i,a??null)}></button>
    <span class="n"></span>${No(e,t)}<span class="cut" title=${o}>${o}</span>
    <span class="mv">${c}</span>
  </div>`}const Oi=e=>e>1?"inner deep":e>0?"inner":"",jo=({step:e},t)=>t<e?"past":t===e?"now":"";function Eo({apart:e,session:t},s){const n=s.throughWalls?", through the walls":"";return l`<button
    type="button"
    class="whole"
    aria-label="Step ${s.index+1}: ${nn(e,s)}, ${cs(s)}${n}"
    title=${s.throughWalls?"Leads through the walls":d}
    @click=${()=>at(t).seek(s.index)}
  ></button>`}function Lo(e){const t=Zp(e.path);return l`<span class="mv ${e.throughWalls?"walls":""}" title=${cs(e)}>
    ${b(e.throughWalls?"warn":mf[t])}${t==="none"?"":w(e.length)}
  </span>`}function No({apart:e,session:t},s){const n=e.partOf(s);return X(n?.mesh?t.meshes.picture(n.mesh,tt(n.index),$.value.theme):null)}var vf=Object.defineProperty,yf=Object.getOwnPropertyDescriptor,rn=(e,t,s,n)=>{for(var i=n>1?void 0:n?yf(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&vf(t,s,i),i};const Ra={usual:36,narrow:44},wf=matchMedia("(max-width: 1023px)"),Ua=10,Ba=.2;let Ke=class extends x{constructor(){super(...arguments),this.rows=[],this.places=[],this.rowsOf=null,this.top=0,this.height=900,this.followed=-1,this.sizes=new ResizeObserver(()=>{this.height===0&&(this.followed=-1),this.height=this.scroller.clientHeight,this.requestUpdate()})}stores(){const{session:e}=this;return[e.build,e.meshes.state,at(e).state,$]}firstUpdated(){this.sizes.observe(this.scroller)}disconnectedCallback(){super.disconnectedCallback(),this.sizes.disconnect()}willUpdate(){super.willUpdate(),this.apart.plan!==this.rowsOf&&(this.rowsOf=this.apart.plan,this.rows=af(this.apart.plan),this.places=rf(this.rows))}updated(e){const{step:t}=at(this.session).state.value;if(t===this.followed)return;this.followed=t;const{clientHeight:s,scrollTop:n}=this.scroller;if(s===0)return;const i=(this.places[t]??this.rows.length)*this.rowHeight,a=n+Ba*s,r=n+(1-Ba)*s-this.rowHeight;i>=a&&i<=r||(this.scroller.scrollTop=i-.4*s,this.top=this.scroller.scrollTop,this.requestUpdate())}get rowHeight(){return wf.matches?Ra.narrow:Ra.usual}render(){const{rows:e,rowHeight:t,apart:s}=this,n=Math.max(0,Math.floor(this.top/t)-Ua),i=Math.min(e.length,Math.ceil((this.top+this.height)/t)+Ua),{step:a}=at(this.session).state.value,r=le(this.session,s.tray)?.index??null;return l`<div class="head">
        <h2 class="grow">Steps</h2>
        <span class="count">${w(s.plan.steps.length)} · moves in mm</span>
      </div>
      <div
        class="scroll"
        @scroll=${()=>{this.top=this.scroller.scrollTop,this.requestUpdate()}}
      >
        <div role="list" aria-label="Steps">
          ${this.space(n*t)}
          ${an(e.slice(n,i),(o,c)=>n+c,o=>gf({session:this.session,apart:s,row:o,step:a,selected:r}))}
          ${this.space((e.length-i)*t)}
        </div>
      </div>`}space(e){return l`<div role="presentation" ${B({height:`${e}px`})}></div>`}};rn([g({attribute:!1})],Ke.prototype,"session",2);rn([g({attribute:!1})],Ke.prototype,"apart",2);rn([H(".scroll")],Ke.prototype,"scroller",2);Ke=rn([k("sp-steps")],Ke);function kf(e,t,s){const n=i=>{const a=t.partOf(i),r=a?.mesh?e.meshes.picture(a.mesh,tt(a.index),$.value.theme):null,o=t.nameOf(i);return l`<li class="li">
      <button
        type="button"
        class="whole"
        aria-label="Select ${o}"
        @click=${()=>ls(e,t.tray.placements[i]??null)}
      ></button>
      ${X(r)}<span class="cut">${o}</span>
    </li>`};return l`<h2>Group of ${s.placements.length}</h2>
    <p class="small dim gap">These copies hold one another. They leave as one and are parted outside.</p>
    <ul class="flush gap">
      ${s.placements.map(n)}
    </ul>`}function xf(e,t,s){const n=at(e),i=s.makes===null?[]:ki(t.plan,s.makes);return l`<section class="sec">
    <h3>Parted outside</h3>
    ${i.length>0?l`<ol class="parting">
            ${i.map(a=>l`<li>
                  <button type="button" class="link" @click=${()=>n.seek(a.index)}>step ${w(a.index+1)}</button>
                  ${nn(t,a)}${a.length>0?l` ${cs(a)}`:d}
                </li>`)}
          </ol>`:l`<p class="dim">The plan does not say how.</p>`}
    <button type="button" class="btn fill" @click=${()=>n.playAlone(s.makes)}>Play the group alone</button>
  </section>`}var Mf=Object.defineProperty,_f=Object.getOwnPropertyDescriptor,Pi=(e,t,s,n)=>{for(var i=n>1?void 0:n?_f(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Mf(t,s,i),i};let Ls=class extends x{stores(){return[this.player.clock]}render(){const e=this.player.time-this.step.index,t=e>=1?this.step.length:Rp(this.step,e);return l`${Yn(t)}`}};Pi([g({attribute:!1})],Ls.prototype,"player",2);Pi([g({attribute:!1})],Ls.prototype,"step",2);Ls=Pi([k("sp-now-at")],Ls);const An=40;function Of(e,t,s){const{step:n}=at(e).state.value,i=t.plan.outAt[s.index]??Number.POSITIVE_INFINITY,a=t.partOf(s.index),r=a?.mesh?e.meshes.picture(a.mesh,tt(a.index),$.value.theme):null,o=t.nameOf(s.index);return l`<section class="sec" aria-label="Selected copy">
    <div class="row gap">
      ${X(r,"th large")}
      <div class="grow cut">
        <h2 class="cut" title=${o}>${o}</h2>
        <div class="small dim">selected · ${Pf(e,t,s)}</div>
      </div>
      ${D("close","Let go (Esc)",()=>ls(e,null),"s")}
    </div>
    ${i>=n&&Number.isFinite(i)?Sf(e,t,s,i):d}
  </section>`}function Pf(e,t,s){const{plan:n}=t,{step:i}=at(e).state.value,a=n.outAt[s.index]??Number.POSITIVE_INFINITY;if(s.fixed&&!Number.isFinite(a))return"fixed: it stays where it is";const r=ho(n,s.index,i);if(!r)return Number.isFinite(a)?l`left at ${vs(e,a)}`:"the plan has no way out for it";if(r.makes!==null)return l`leaves in a group at ${vs(e,r.index)}`;const o=(n.assemblies[r.from]?.madeBy??-1)>=0;return l`${o?"parted from its group at":"leaves at"} ${vs(e,r.index)}`}function vs(e,t){return l`<button type="button" class="link" @click=${()=>at(e).seek(t)}>step ${w(t+1)}</button>`}function Sf(e,t,s,n){const i=at(e),{step:a}=i.state.value,r=l`<button type="button" class="btn fill" @click=${()=>i.play(n+1)}>
    Play until it is out
  </button>`;if(t.plan.steps[a]?.placements.includes(s.index))return r;const{found:o}=t.ways.state.value;if(!o)return l`<p class="row dim gap">${z}Looking for what is in its way …</p>${r}`;const c=o.filter(u=>u.step>=a);if(c.length===0)return l`<p class="row dim gap"><span class="ok-text">${b("check")}</span>Nothing is in its way now.</p>${r}`;const h=c.length===1?"One copy stands in its way. It leaves first.":`${Cf(c.length)} copies stand in its way. They leave first.`;return l`<div class="note warn gap">${b("warn")}<p>${h}</p></div>
    ${r}
    <ul class="flush blockers" aria-label="In its way">
      ${c.slice(0,An).map(u=>Tf(e,t,u))}
      ${c.length>An?l`<li class="small dim more">And ${w(c.length-An)} more.</li>`:d}
    </ul>`}function Tf(e,t,s){const n=t.partOf(s.placement),i=n?.mesh?e.meshes.picture(n.mesh,tt(n.index),$.value.theme):null,a=t.nameOf(s.placement);return l`<li class="li">
    <button
      type="button"
      class="whole"
      aria-label="Select ${a}"
      @click=${()=>ls(e,t.tray.placements[s.placement]??null)}
    ></button>
    ${X(i)}<span class="cut">${a}</span><span class="over">${vs(e,s.step)}</span>
  </li>`}const Af=["No","One","Two","Three","Four","Five","Six","Seven","Eight","Nine","Ten"],Cf=e=>Af[e]??w(e);function jf({plan:e,tray:t}){const s=e.staying.filter(a=>t.placements[a]?.fixed).length,n=e.staying.length-s,i=e.steps.filter(a=>a.throughWalls).length;return e.staying.length===0&&i===0?d:l`<section class="sec stack">
    ${n>0?l`<div class="note warn">
            ${b("warn")}
            <p>
              <b>The plan is not complete.</b> For ${S(n)} no way out is known. They stay in the tray and stand at
              the end of the list.
            </p>
          </div>`:d}
    ${s>0?l`<p class="small dim">${S(s)} ${s===1?"is":"are"} fixed and ${s===1?"stays":"stay"} where ${s===1?"it is":"they are"}.</p>`:d}
    ${i>0?l`<p class="small dim">
            ${P(i,"step")} ${i===1?"leads":"lead"} through the walls: open the tray at a side for
            ${i===1?"it":"them"}.
          </p>`:d}
  </section>`}var Ef=Object.defineProperty,Lf=Object.getOwnPropertyDescriptor,Si=(e,t,s,n)=>{for(var i=n>1?void 0:n?Lf(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Ef(t,s,i),i};let Ns=class extends x{get player(){return at(this.session)}stores(){const{session:e}=this;return[e.run.state,e.build,e.meshes.state,this.player.state,this.apart.ways.state,$]}render(){const{session:e,apart:t}=this,{step:s}=this.player.state.value,{plan:n}=t,i=n.steps[s],a=le(e,t.tray),r=uo(n,i?i.index:n.steps.length);return l`<div class="head">
        <h2 class="grow nw">${i?`Step ${w(s+1)}`:"Done"}</h2>
        <span class="count">${i?`${S(r)} after it`:""}</span>
      </div>
      <div class="scroll">
        ${i?this.step(i):this.end()} ${i?.makes!=null?xf(e,t,i):d}
        ${a?Of(e,t,a):this.hint()} ${jf(t)}
      </div>
      ${this.options()}`}step(e){return l`<section class="sec">
      ${e.makes===null?this.one(e):kf(this.session,this.apart,e)}
      <dl class="kv">
        <dt>Moves</dt>
        <dd>${cs(e)}</dd>
        ${e.length>0?l`<dt>Now at</dt>
                <dd><sp-now-at .player=${this.player} .step=${e}></sp-now-at></dd>`:d}
        <dt>Way is clear</dt>
        <dd>${this.clear()}</dd>
      </dl>
      ${e.throughWalls?l`<div class="note warn">
              ${b("warn")}
              <p>This step leads through the walls of the tray. Open the tray at that side for it.</p>
            </div>`:d}
    </section>`}one(e){const{session:t,apart:s}=this,n=e.placements[0]??-1,i=s.partOf(n),a=i?.mesh?t.meshes.picture(i.mesh,tt(i.index),$.value.theme):null,r=s.plan.assemblies[e.from],o=r&&r.madeBy>=0?`parted outside from a group of ${r.members.length}`:"";return l`<div class="row gap">
      ${X(a,"th large")}
      <div class="grow cut">
        <h2 class="cut" title=${s.nameOf(n)}>${s.nameOf(n)}</h2>
        <div class="small dim">${o||"leaves on its own"}</div>
      </div>
    </div>`}clear(){const{verdict:e}=this.session.job;return e?.apart==="checked"&&e.ok?l`<span class="ok-text">checked</span>`:e?.apart==="checked"?l`<span class="warn-text">checked, but the check found other faults</span>`:e?.apart==="no"?l`<span class="bad-text">no: the check found the plan wrong</span>`:l`<span class="warn-text">not checked yet</span>`}end(){return l`<section class="sec">
      <h2>${To(this.apart)}</h2>
      <p class="dim">
        ${w(this.apart.plan.steps.length)} steps, each one after the other. Play starts again at the first.
      </p>
    </section>`}hint(){return this.player.state.value.step>=this.apart.plan.steps.length&&this.apart.plan.staying.length===0?d:l`<section class="sec">
      <p class="dim">Click a copy in the tray to see when it leaves, and what is in its way.</p>
    </section>`}options(){const{player:e}=this,{follow:t,faint:s}=e.state.value,n=(i,a,r)=>l`<div class="field"><span class="dim">${i}</span>${Qs(i,a,r)}</div>`;return l`<section class="sec bottom">
      ${n("Follow with the camera",t,i=>e.setFollow(i))}
      ${n("Keep copies that left, faint",s,i=>e.setFaint(i))}
    </section>`}};Si([g({attribute:!1})],Ns.prototype,"session",2);Si([g({attribute:!1})],Ns.prototype,"apart",2);Ns=Si([k("sp-step")],Ns);var Nf=Object.defineProperty,Df=Object.getOwnPropertyDescriptor,on=(e,t,s,n)=>{for(var i=n>1?void 0:n?Df(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Nf(t,s,i),i};let Ge=class extends x{constructor(){super(...arguments),this.drawer=null,this.release=null,this.apart=null,this.madeOf=[],this.said=-1}get player(){return at(this.session)}stores(){const{session:e}=this;return[e.run.state,e.build,e.source.state,this.player.state]}connectedCallback(){super.connectedCallback(),this.release=Ue(Xd({session:()=>this.session,player:()=>this.player,frame:e=>this.pane?.frame(e),openExport:()=>document.querySelector("sp-export")?.show()}))}disconnectedCallback(){super.disconnectedCallback(),this.release?.(),this.release=null,this.player.pause()}updated(e){const{apart:t}=this,{step:s,playing:n,plan:i}=this.player.state.value;if(!t||!i||n||s===this.said)return;const a=this.said<0;this.said=s,a||Rt(Mi(t,s))}willUpdate(){super.willUpdate();const{stored:e}=this.session.run.state.value,t=this.trayNumber(e),s=e?.trays[t-1]??null;this.player.take(s);const{plan:n,step:i}=this.player.state.value,{meshes:a}=this.session.parts;if((n!==this.madeOf[0]||a!==this.madeOf[1])&&(this.madeOf=[n,a],this.apart=e&&s&&n?Gd(this.session,e,s,n):null,this.apart&&this.measure(this.apart)),!this.apart)return;const r=le(this.session,this.apart.tray);this.apart.ways.ask(r&&n&&this.apart.measured?ho(n,r.index,i):null)}async measure(e){await this.session.meshes.load(e.parts.flatMap(t=>t.mesh?[t.mesh]:[])),this.apart===e&&(this.apart=Jd(this.session,e)),this.requestUpdate()}trayNumber(e){if(!e)return 1;const t=Math.min(this.session.build.value.tray,e.trays.length);return t>0?t:e.trays.find(s=>s.steps>0)?.number??1}render(){const{session:e,apart:t}=this,{stored:s,loading:n}=e.run.state.value;if(E(e.job))return this.message("It is being packed","How it comes apart is found at the end.");if(!s||!t)return n||e.job.has_packing?l`<main class="empty" aria-busy="true"><p class="dim row">${z}Opening the build …</p></main>`:this.message("No build yet","Press Pack on the Parts step.");const i=Vn(e,s,t.tray.number,!1);return t.plan.steps.length===0?l`${i}${this.message("No plan for this tray","It was packed without one, or the search was stopped before.")}`:l`${i}
      <main class="main build apart" data-drawer=${this.drawer??d}>
        <h1 class="out">${e.job.name}: take apart</h1>
        <aside class="side left" aria-label="Steps">
          <sp-steps .session=${e} .apart=${t}></sp-steps>
        </aside>
        <sp-divider property="--left" side="left" label="Width of the list" most="480"></sp-divider>
        <div class="middle"><sp-apart-tray .session=${e} .apart=${t}></sp-apart-tray></div>
        <sp-divider property="--right" side="right" label="Width of the step" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Step">
          <sp-step .session=${e} .apart=${t}></sp-step>
        </aside>
        ${this.drawers()}
      </main>
      <sp-player .session=${e} .apart=${t}></sp-player>`}drawers(){const e=(t,s)=>l`<button
        type="button"
        class="btn"
        aria-pressed=${this.drawer===t}
        @click=${()=>{this.drawer=this.drawer===t?null:t}}
      >
        ${b(t==="left"?"list":"info")}${s}
      </button>`;return l`<div class="drawers">${e("left","Steps")}${e("right","This step")}</div>`}message(e,t){return l`<main class="empty">
      <h2>${e}</h2>
      <p class="dim">${t}</p>
      <div class="row">
        <button
          type="button"
          class="btn primary"
          @click=${()=>rt({page:"job",id:this.session.id,step:"build"})}
        >
          To the build
        </button>
      </div>
    </main>`}};on([g({attribute:!1})],Ge.prototype,"session",2);on([O()],Ge.prototype,"drawer",2);on([H("sp-apart-tray")],Ge.prototype,"pane",2);Ge=on([k("sp-apart")],Ge);function Je(e){const{tray:t,selected:s}=e.build.value,n=(e.run.state.value.packing?.trays.length??1)>1;return n&&t===0?[]:s.map(({part:i,copy:a})=>({tray:n?t:1,part:i,copy:a}))}const Ff=e=>e.target instanceof Element&&e.target.closest("button, a, [role=menuitem]")!==null;function If(e){const t=()=>e().work,s=()=>!t().move.active;return[{keys:["L"],does:"lock what is selected; again: unlock",when:s,run:()=>t().toggleLock(Je(e()))},{keys:["Del"],does:"remove what is selected",when:s,run:()=>t().remove(Je(e()))},{keys:["M"],does:"move the selected copy",when:s,run:()=>Do(e())},{keys:["Ctrl+Z"],does:"undo",run:()=>void t().undo()},{keys:["Ctrl+Shift+Z","Ctrl+Y"],does:"redo",run:()=>void t().redo()}]}function Do(e){const[t,...s]=Je(e);t&&s.length===0&&!e.work.isLocked(t)&&e.work.move.begin(t)}const Ha=[["←",[-1,0,0]],["→",[1,0,0]],["↓",[0,-1,0]],["↑",[0,1,0]],["PageDown",[0,0,-1]],["PageUp",[0,0,1]]];function zf(e){const t=()=>e().work.move;return[...[1,10].map(n=>({keys:Ha.map(([a])=>n===10?`Shift+${a}`:a),does:`move it by ${n} mm: left, right, to the front, to the back, down, up`,run:a=>{const r={ArrowLeft:"←",ArrowRight:"→",ArrowDown:"↓",ArrowUp:"↑"}[a.key]??a.key,o=Ha.find(([c])=>c===r)?.[1];o&&t().shift([o[0]*n,o[1]*n,o[2]*n])}})),{keys:["Enter"],does:"place it here",when:n=>!Ff(n),run:()=>t().place()},{keys:["Esc","M"],does:"put it back",run:()=>t().end()}]}function Rf({session:e,frame:t,openExport:s,openPack:n},i){const a=()=>e().build,r=()=>!e().work.move.active,o=u=>({keys:[u.toUpperCase()],does:`section along ${u.toUpperCase()}; again: off`,when:r,run:()=>{const p=a().value.section;a().set({section:p?.axis===u?null:ko(e(),u,p)})}}),c=(u,p,f)=>({keys:[u],does:f,run:()=>{const{section:m}=a().value;m&&a().set({section:xo(e(),m,p)})}}),h=[{keys:["F"],does:"frame what is selected",run:()=>t(!1)},{keys:["Shift+F"],does:"frame all",run:()=>t(!0)},{keys:["/"],does:"find a copy or part",run:()=>a().set({find:a().value.find??""})},{keys:["Esc"],does:"close, let go",run:()=>a().set({find:null,selected:[]})}];return i?h:[...h,o("x"),o("y"),o("z"),c("[",-1,"section a layer down"),c("]",1,"section a layer up"),c("Shift+[",-10,"section ten layers down"),c("Shift+]",10,"section ten layers up"),{keys:["B"],does:"other side of the section",run:()=>{const{section:u}=a().value;u&&a().set({section:{...u,flipped:!u.flipped}})}},{keys:["H"],does:"hide what is selected",run:()=>a().set(Vr(a().value))},{keys:["I"],does:"show only what is selected",run:()=>a().set(Kr(a().value))},{keys:["Shift+H"],does:"show all",run:()=>a().set(Wr)},{keys:["C"],does:"next colouring",run:()=>a().set({colouring:Kh(a().value.colouring)})},{keys:["1–9"],does:"that tray",when:r,run:u=>{const p=Number(u.key);(e().run.state.value.packing?.trays.length??0)>=p&&Ve(e(),p)}},{keys:["0"],does:"all trays",when:r,run:()=>{(e().run.state.value.packing?.trays.length??0)>1&&Ve(e(),0)}},{keys:["Ctrl+E"],does:"export",run:s},{keys:["Ctrl+Enter"],does:"pack again: all, or the rest",run:n},...If(e)]}function Fo(e,t,s,n=400){let i=0,a=0;for(;a<e.length&&i+(e[a]??0)<=t-n;)i+=e[a++]??0;const r=i;let o=a;for(;o<e.length&&i<t+s+n;)i+=e[o++]??0;let c=0;for(let h=o;h<e.length;h+=1)c+=e[h]??0;return{first:a,last:o,before:r,after:c}}const Ti={text:"Change the part",draft:null};function Uf(e,t,s,n){switch(e.reason){case"no_place":return{text:e.detail?st(e.detail):"No free place left.",remedy:qa(t,s)};case"cannot_leave":return{text:"Held by other copies, and no other place left.",remedy:qa(t,s)};case"too_large":return Wf(e.detail,t,s,n);case"cap":return{text:qf(e.detail),remedy:{text:"Pack again without the cap",draft:Hf(s)}};case"not_tried":return{text:"The run ended before it was tried.",remedy:Bf(s)};case"bad_file":return{text:st(e.detail||"The file cannot be used"),remedy:{...Ti,text:"Replace the file"}}}}function qa(e,t){if(ns(t)||t.trays==="all"||t.options.fill===!0)return Ti;const s=Math.max(t.trays,e.trays.length)+1;return{text:`Pack again with ${w(s)} trays`,draft:{...t,trays:s}}}function Bf(e){if(e.timeLimit===null)return{text:"Pack again",draft:e};const t=Math.max(60,e.timeLimit*2);return{text:`Pack again with ${Gt(t)}`,draft:{...e,timeLimit:t}}}function Hf(e){return Vt(Vt(e,"max-density",void 0),"max-layer-fill",void 0)}function qf(e){const t=/(\d*\.?\d+)/.exec(e)?.[1],s=t===void 0?Number.NaN:Number(t);return s>0&&s<=1?`The tray may be filled to ${K(s,0)} only.`:"The tray may not be filled more."}function Wf(e,t,s,n){const i=[...e.matchAll(/([\d.]+) x ([\d.]+)(?: x ([\d.]+))? mm/g)].map(u=>[Number(u[1]),Number(u[2]),Number(u[3]??0)]),[a,r]=i,o=a&&r?`${ut(a)}; the tray takes ${Vf(r,a)}.`:"Larger than the tray.",c=/--rotations (\S+?)\.?$/.exec(e)?.[1],h=/It fits into (.+): --printer (\S+?)\.?$/.exec(e);if(e.includes("as its orientations do")&&n!==null){const u=s.parts.map(p=>p.key===n?{...p,stands:gi}:p);return{text:o,remedy:{text:"Let it stand any way",draft:{...s,parts:u}}}}if(c){const u=/^\d+$/.test(c)?`Turn parts in steps of ${c}°`:"Turn parts in finer steps";return{text:o,remedy:{text:u,draft:Vt(s,"rotations",c)}}}if(h?.[1]&&h[2]){const u={kind:"printer",name:h[2]};return{text:o,remedy:{text:`Use ${h[1]}`,draft:{...s,tray:u,gap:null,wallGap:null}}}}return{text:t.openHeight?"Larger than the tray's base.":o,remedy:Ti}}function Vf(e,t){return e[2]===0&&t[2]!==0?ut([e[0],e[1]]):ut(e)}var Kf=Object.defineProperty,Gf=Object.getOwnPropertyDescriptor,Ai=(e,t,s,n)=>{for(var i=n>1?void 0:n?Gf(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Kf(t,s,i),i};let Ds=class extends x{constructor(){super(...arguments),this.parts=[]}stores(){const{session:e}=this;return[e.run.state,e.state,e.meshes.state,e.work.state,e.work.move.state,$]}render(){const{packing:e}=this.session.run.state.value;if(!e||e.leftOver.length===0)return d;const t=e.leftOver.reduce((n,i)=>n+i.copies,0),s=this.shared(e);return l`<section class="left-over" aria-label="Left over">
      <h3>Left over <span class="count">${S(t)}</span></h3>
      ${e.leftOver.map(n=>this.row(e,n,s))}
    </section>`}shared(e){const t=new Map;for(const s of e.leftOver){if(s.byHand)continue;const{remedy:n}=this.words(e,s);n.draft&&!t.has(n.text)&&t.set(n.text,s)}return t}words(e,t){return Uf(t,e,this.session.draft,ra(this.session,e,t.part))}row(e,t,s){const{text:n,remedy:i}=this.words(e,t);if(t.byHand)return this.byHand(e,t);const a=i.draft===null||s.get(i.text)===t;return this.frame(e,t,n,a?l`<button type="button" class="link small" @click=${()=>this.take(e,t,i)}>
            ${i.text}
          </button>`:d)}frame(e,t,s,n){const i=this.parts.find(o=>o.index===t.part),{meshes:a}=this.session,r=i?.mesh?a.picture(i.mesh,tt(t.part),$.value.theme):null;return l`<div class="left-row">
      ${X(r)}
      <div class="grow">
        <div class="row between">
          <span class="cut">${i?.name??e.parts[t.part]?.name??""}</span>
          <span class="dim nw">${t.copies} of ${i?.count??t.copies}</span>
        </div>
        <div class="small dim">${s}</div>
        ${n}
      </div>
    </div>`}byHand(e,t){const{work:s}=this.session,n=t.which.map(r=>({part:t.part,copy:r})),[i]=n,a=this.session.run.packs||s.move.active;return this.frame(e,t,"Taken out by hand.",l`<span class="row">
        <button type="button" class="link small" ?disabled=${a} @click=${()=>s.putBack(n)}>
          ${n.length>1?`Put all ${n.length} back`:"Put back"}
        </button>
        <button type="button" class="link small" ?disabled=${a} @click=${()=>i&&s.placeByHand(i)}>
          Place by hand
        </button>
      </span>`)}take(e,t,s){if(s.draft){this.session.packWith(s.draft);return}const n=ra(this.session,e,t.part);n!==null&&this.session.view.set({current:n}),rt({page:"job",id:this.session.id,step:"parts"})}};Ai([g({attribute:!1})],Ds.prototype,"session",2);Ai([g({attribute:!1})],Ds.prototype,"parts",2);Ds=Ai([k("sp-left-over")],Ds);function Ci(e,t,s){const{packing:n}=e.run.state.value,{locks:i}=e.work.state.value;return!n||i.size===0?0:vi(n,t,s).filter(a=>i.has(Ut(a))).length}function Jf(e,t,s,n){const i=Ci(e,t,s);if(i===0)return d;const a=i===n?"all locked":`${i} locked`;return l`<span class="locked small" title=${a}
    >${b("lock")}${i===n?d:i}<span class="out">${a}</span></span
  >`}function Le(e,t,s,n){return l`<button type="button" class="mi" role="menuitem" ?disabled=${s} @click=${n}>
    ${b(e)}<span>${t}</span>
  </button>`}function Yf(e,t,s,n){return l`<sp-menu
    class="row-menu"
    label="More of ${s.name}"
    hint="More"
    buttonClasses="btn s ghost icon eye"
    .button=${b("more")}
    .content=${()=>{const{packing:i}=e.run.state.value,a=i?vi(i,t,s.index):[],r=Ci(e,t,s.index);return l`${Le("lock",`Lock all ${S(n)}`,r===n,()=>e.work.lock(a,!0))}
        ${Le("unlock","Unlock all of them",r===0,()=>e.work.lock(a,!1))}
        <hr />
        ${Le("trash",`Remove all ${S(n)}`,r===n,()=>e.work.remove(a))}`}}
  ></sp-menu>`}function Zf(e,t){return l`<sp-menu
    label="Lock the tray"
    hint="Lock the tray"
    buttonClasses="btn s ghost icon"
    .button=${b("lock")}
    .content=${()=>{const{packing:s}=e.run.state.value,n=s?vi(s,t):[],i=Ci(e,t,null),a=(s?.trays.length??1)>1&&t>0?`all of tray ${t}`:"all copies";return l`<p class="menu-head small dim">
          ${i>0?`${S(i)} locked. `:""}Locked copies stay where they are when the rest is packed again.
        </p>
        ${Le("lock",`Lock ${a}`,i===n.length,()=>e.work.lock(n,!0))}
        ${Le("unlock",`Unlock ${a}`,i===0,()=>e.work.lock(n,!1))}`}}
  ></sp-menu>`}var Xf=Object.defineProperty,Qf=Object.getOwnPropertyDescriptor,we=(e,t,s,n)=>{for(var i=n>1?void 0:n?Qf(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Xf(t,s,i),i};const Cn=40;let Qt=class extends x{constructor(){super(...arguments),this.parts=[],this.live=!1,this.tray=1,this.top=0,this.height=900,this.followed=-1,this.sizes=new ResizeObserver(()=>{this.height=this.scroller.clientHeight,this.requestUpdate()})}stores(){const{session:e}=this;return[e.run.state,e.build,e.work.state,e.meshes.state,$]}firstUpdated(){this.sizes.observe(this.scroller)}disconnectedCallback(){super.disconnectedCallback(),this.sizes.disconnect()}updated(){if(!this.live)return;const e=this.session.run.live.newest?.copy.part??-1;if(e===this.followed)return;this.followed=e;const t=this.parts.findIndex(i=>i.index===e)*Cn,{scrollTop:s,clientHeight:n}=this.scroller;t>=0&&(t<s||t+Cn>s+n)&&(this.scroller.scrollTop=t-n/2)}render(){const{session:e,live:t}=this,{packing:s}=e.run.state.value,n=t?e.run.live.counts():Pr(s?yc(s,this.tray):[]),i=this.parts.reduce((c,h)=>c+h.count,0),a=[...n.values()].reduce((c,h)=>c+h,0),r=t?Math.max(i,e.run.live.progress?.total??0):s?.copies??i,o=Fo(this.parts.map(()=>Cn),this.top,this.height);return l`<div class="head">
        <h2 class="grow">Parts</h2>
        <span class="count">${w(a)} of ${w(r)}${t?" placed":""}</span>
        ${t?d:D("find","Find (/)",()=>e.build.set({find:""}),"s")}
        ${t?d:Zf(e,this.tray)}
      </div>
      <div
        class="scroll"
        @scroll=${()=>{this.top=this.scroller.scrollTop,this.requestUpdate()}}
      >
        <div role="list" aria-label="Parts">
          <div role="presentation" ${B({height:`${o.before}px`})}></div>
          ${an(this.parts.slice(o.first,o.last),c=>c.index,c=>this.row(c,n.get(c.index)??0))}
          <div role="presentation" ${B({height:`${o.after}px`})}></div>
        </div>
      </div>
      ${t?d:l`<sp-left-over .session=${e} .parts=${this.parts}></sp-left-over>`}`}row(e,t){const{session:s,live:n}=this,{selected:i,hiddenParts:a}=s.build.value,r=s.run.doing==="improve"?null:s.run.live.newest,o=n?r?.copy.part===e.index:i.some(f=>f.part===e.index),c=a.has(e.index),{mesh:h}=e,u=X(h?s.meshes.picture(h,tt(e.index),$.value.theme):null);if(n){const f=t>=e.count;return l`<div class="li ${o?"sel":""}" role="listitem">
        ${u}
        <div class="cut">
          <div class="cut">${e.name}</div>
          ${rs(e.count>0?t/e.count:0,null,f?"done":"")}
        </div>
        <span class="dim num">${w(t)} <span class="faint">/ ${w(e.count)}</span></span>
      </div>`}const p=c?`Show ${e.name}`:`Hide ${e.name}`;return l`<div class="li ${o?"sel":""} ${c?"past":""}" role="listitem">
      <button
        type="button"
        class="whole"
        aria-label="Select ${e.name}, ${t} of ${e.count}"
        aria-pressed=${o}
        @click=${f=>this.select(e,f.ctrlKey||f.metaKey)}
      ></button>
      ${u}
      <div class="cut ${o?"b":""}" title=${e.name}>${e.name}</div>
      <span class="dim row">
        ${Jf(s,this.tray,e.index,t)}
        ${t===e.count||this.tray>0?w(t):`${w(t)} / ${w(e.count)}`}
        ${Yf(s,this.tray,e,t)}
        <button
          type="button"
          class="btn s ghost icon eye ${c?"off":""}"
          aria-label=${p}
          title=${p}
          aria-pressed=${c}
          @click=${()=>s.build.set(Wh(s.build.value,e.index))}
        >
          ${b(c?"eyeOff":"eye")}
        </button>
      </span>
    </div>`}select(e,t){const{packing:s}=this.session.run.state.value,{build:n}=this.session,a=(s?.trays[this.tray-1]?.placements??[]).filter(c=>c.part===e.index).map(({part:c,copy:h})=>({part:c,copy:h})),r=n.value.selected.filter(c=>c.part!==e.index),o=r.length<n.value.selected.length&&(t||r.length===0);n.set({selected:o?r:t?[...r,...a]:a})}};we([g({attribute:!1})],Qt.prototype,"session",2);we([g({attribute:!1})],Qt.prototype,"parts",2);we([g({type:Boolean})],Qt.prototype,"live",2);we([g({type:Number})],Qt.prototype,"tray",2);we([H(".scroll")],Qt.prototype,"scroller",2);Qt=we([k("sp-build-list")],Qt);const Io=e=>e==="height"||e==="box"||e==="trays",zo=e=>`${(e/1e3).toFixed(0)}${L}cm³`;function Ot(e,t){switch(e){case"height":return`${t.toFixed(1)}${L}mm`;case"density":return K(t,2);case"copies":return w(t);case"box":return zo(t);case"trays":return t.toFixed(2);default:return Number(t.toPrecision(6)).toString()}}function Ro(e){return{height:"height",density:"filled",copies:"copies placed",box:"volume of the box",trays:"trays",value:"value placed"}[e]??e}function ln(e,t,s){const n=Io(e)?t-s:s-t;if(!(n>0))return null;switch(e){case"height":return n<.05?null:`${n.toFixed(1)}${L}mm lower`;case"density":return`${K(n,2)} more filled`;case"copies":return n===1?"1 copy more":`${w(n)} copies more`;case"box":return`${zo(n)} smaller`;case"trays":return`${n.toFixed(2)} trays less`;default:return`${Ot(e,n)} more`}}function tm(e,t,s){const n=ln(e,t,s);return n?`Made better: ${n}, ${Ot(e,s)} instead of ${Ot(e,t)}.`:"Nothing better was found."}const Zn=272,ys=96,Wa=8,em=43200;function sm(e,t=!1){const[s]=e.points;if(!s)return null;const n=s.seconds,i=Math.max(1,e.seconds-n+Uo(e,t)),a=e.points.map(({value:p})=>Io(e.what)?s.value-p:p-s.value),r=Math.max(...a,Math.abs(s.value)*1e-4,1e-9),o=p=>(p-n)/i*Zn,c=p=>ys-Wa-Math.max(0,p)/r*(ys-2*Wa);let h="";e.points.forEach(({seconds:p},f)=>{const m=c(a[f]??0).toFixed(1);h+=f===0?`M0 ${m}`:`H${o(p).toFixed(1)}V${m}`});const u=o(e.seconds);return h+=`H${u.toFixed(1)}`,{line:h,area:`${h}V${ys}H0Z`,startY:c(0),nowY:c(a[a.length-1]??0),nowX:u}}const Uo=({left:e},t)=>t||e===null||e>em?0:Math.max(0,e);function ji(e,t=!1){const s=sm(e,t);if(!s)return d;const{what:n,before:i,now:a}=e,[r]=e.points,o=r?.seconds??0,c=e.seconds-o+Uo(e,t),h=ln(n,i,a),u=`${Ro(n)} from ${Ot(n,i)} to ${Ot(n,a)} within ${Pt(e.seconds-o)}`;return l`<figure class="curve">
    <div class="row between small">
      <span class="dim">at first ${Ot(n,i)}</span>
      <span class="b accent">${h?`best ${Ot(n,a)}`:""}</span>
    </div>
    <svg viewBox="0 0 ${Zn} ${ys}" preserveAspectRatio="none" role="img" aria-label=${u}>
      ${oe`<path class="area" d=${s.area} />
        <path class="start" d="M0 ${s.startY}H${Zn}" />
        <path class="line" d=${s.line} />`}
    </svg>
    <div class="row between scale faint"><span>0</span><span>${c>0?Pt(c):""}</span></div>
  </figure>`}var nm=Object.defineProperty,im=Object.getOwnPropertyDescriptor,Bo=(e,t,s,n)=>{for(var i=n>1?void 0:n?im(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&nm(t,s,i),i};const Ho=86400,am=new Set(["write","render","check"]);let Xn=class extends x{constructor(){super(...arguments),this.ticking=0}stores(){return[this.session.run.state,$]}connectedCallback(){super.connectedCallback(),this.ticking=window.setInterval(()=>this.requestUpdate(),1e3)}disconnectedCallback(){super.disconnectedCallback(),clearInterval(this.ticking)}render(){const{job:e}=this.session.run.state.value,{curve:t,progress:s}=this.session.run.live,n=s!==null&&t.isThere&&am.has(s.phase);return l`<div class="head">
        <h2 class="grow">Improving</h2>
        ${n||e.status==="queued"?d:l`<span class="count">${Pt(t.seconds)} so far</span>`}
      </div>
      <div class="scroll">
        ${e.status==="queued"?this.queued():t.isThere?this.improving():this.beginning()}
        ${n&&s?l`<section class="sec row">${z}<span>${qn(s.phase)}</span></section>`:d}
      </div>
      ${this.stop()}`}queued(){const e=this.session.job.queue_place;return l`<section class="sec">
      <p><b>${e?`Place ${e} in the queue.`:"In the queue."}</b> It begins as soon as the jobs before it are done.</p>
    </section>`}beginning(){const{progress:e}=this.session.run.live;return l`<section class="sec">
      <p class="row">${z}<span>${e?qn(e.phase):"Getting ready"}</span></p>
      <p class="small faint after">The build that stands is kept until a better one is found.</p>
    </section>`}improving(){const{curve:e}=this.session.run.live,{what:t,before:s,now:n,left:i,seconds:a}=e,r=ln(t,s,n),o=i===null||i>Ho/2,[c="",h=""]=Ot(t,n).split(L),u=a+Math.max(0,i??0);return l`<section class="sec">
        <div class="fig">
          ${G(c,h,`${Ro(t)}, best so far`)}
          ${o?G("–","","until it is stopped"):G(Pt(i),"left",`of ${Pt(u)}`)}
        </div>
        ${o?d:rs(u>0?a/u:0,"Time used","thick")}
      </section>
      <section class="sec">
        <h3>${r??"Nothing better yet"}</h3>
        ${ji(e)}
        <p class="small faint after">
          Other orders are tried. Each better build takes the place of the one before, and has its own way apart.
        </p>
      </section>`}stop(){const{job:e,stopping:t}=this.session.run.state.value,s=t||e.stopping===!0;return l`<section class="sec bottom">
      <button type="button" class="btn l fill" ?disabled=${s} @click=${()=>this.session.stop()}>
        ${s?z:b("stop")}${s?"Stopping":"Stop and keep the best"}
      </button>
      <p class="small faint">
        ${s?"The best build is checked.":"Closing this page does not stop it."}
      </p>
    </section>`}};Bo([g({attribute:!1})],Xn.prototype,"session",2);Xn=Bo([k("sp-improve")],Xn);const rm=[[60,"For 1 minute",""],[300,"For 5 minutes",""],[900,"For 15 minutes",""],[Ho,"Until it is stopped","or for a day"]];function om(e){const{job:t}=e.run.state.value;if(t.can_improve!==!0)return d;const s=e.work.unchecked,n=e.work.state.value.locks.size>0;return l`<div class="improve">
    <sp-menu
      buttonClasses="btn fill"
      hint=${s?"The change is checked first":"Looks for a better build; the best is kept"}
      ?disabled=${s}
      .button=${l`${b("improve")}Keep improving${b("down")}`}
      .content=${()=>l`${rm.map(([i,a,r])=>l`<button type="button" class="mi plain" role="menuitem" @click=${()=>void Cu(e,i)}>
              <span>${a}${r?l`<span>${r}</span>`:d}</span>
            </button>`)}
        ${n?l`<p class="menu-head small dim after">Locked copies may move: all orders are tried.</p>`:d}`}
    ></sp-menu>
  </div>`}function lm(e,t,s,n=190){const i=Math.max(1,Math.min(n,Math.round(s/2))),a=s/i,r=new Array(i).fill(0);for(const{extent:o,volume:c}of e){const h=o.low[2],u=Math.max(o.high[2],h+1e-6),p=c/(u-h)/t,f=Math.max(0,Math.floor(h/a)),m=Math.min(i-1,Math.floor(u/a));for(let v=f;v<=m;v+=1){const y=Math.min(u,(v+1)*a)-Math.max(h,v*a);y>0&&(r[v]=(r[v]??0)+p*y/a)}}return{thickness:a,share:r.map(o=>Math.min(1,o)),exact:!1}}function Va(e,t){const s=Math.floor(t/e.thickness);return e.share[Math.max(0,Math.min(e.share.length-1,s))]??0}function qo(e){let t=0;return e.share.forEach((s,n)=>{s>(e.share[t]??0)&&(t=n)}),{share:e.share[t]??0,z:(t+.5)*e.thickness}}function cm(e){if(!e)return .4;const t=qo(e).share;return[.02,.04,.06,.1,.16,.2,.3,.4,.5,.6,.8,1].find(n=>n>=t*1.02)??1}var hm=Object.defineProperty,um=Object.getOwnPropertyDescriptor,se=(e,t,s,n)=>{for(var i=n>1?void 0:n?um(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&hm(t,s,i),i};let Tt=class extends x{constructor(){super(...arguments),this.layers=null,this.height=0,this.average=0,this.live=!1,this.hover=null,this.dragging=!1}stores(){return[this.session.build]}get cut(){const{section:e}=this.session.build.value;return e?.axis==="z"?e.at:null}render(){const e=cm(this.layers);return l`<aside class="strip" aria-label="Filled area of each layer">
      <header><b>Layers</b><span class="dim">filled area</span></header>
      ${this.height>0?l`<div
              class="plot ${this.live?"":"cuts"}"
              @pointerdown=${this.grab}
              @pointermove=${this.move}
              @pointerup=${this.drop}
              @pointercancel=${this.drop}
              @pointerleave=${()=>{this.hover=null}}
            >
              ${this.drawing(e)} ${this.marks()} ${this.cutLine()} ${this.hoverLine()}
            </div>`:l`<div class="plot"></div>`}
      <footer>
        <div class="row between faint scale">
          <span>0</span><span>${Math.round(e*50)}</span><span>${K(e,0)}</span>
        </div>
        ${this.words()}
      </footer>
    </aside>`}words(){if(this.live||!this.layers)return l`<b>${K(this.average)}</b> on average,<br />grows as copies land`;const{cut:e}=this;if(e!==null)return l`<b>${K(Va(this.layers,e))}</b> at the cut<br />Drag to move it`;const t=qo(this.layers);return l`<b>${K(t.share,0)}</b> at ${t.z.toFixed(0)} mm,<br />the fullest layer`}y(e){return(1-e/this.height)*1e3}drawing(e){const{layers:t,cut:s}=this,i=t?dm(t,r=>(r/e*100).toFixed(2),r=>this.y(r).toFixed(1)):"",a=s===null?0:this.y(s);return l`<svg viewBox="0 0 100 1000" preserveAspectRatio="none" aria-hidden="true">
      ${[1,2,3].map(r=>oe`<path class="grid" d="M${r*25} 0V1000" />`)}
      ${i===""?d:s===null?oe`<polygon class="area" points=${i} />`:oe`<polygon class="area past" points=${i} />
                <clipPath id="below-cut"><rect x="0" y=${a} width="100" height=${1e3-a} /></clipPath>
                <polygon class="area" points=${i} clip-path="url(#below-cut)" />`}
    </svg>`}marks(){const e=[10,20,50,100,200,500].find(s=>this.height/s<=5)??1e3,t=[];for(let s=e;s<this.height;s+=e)t.push(l`<span class="mark-z" ${B({bottom:`${s/this.height*100}%`})}>${s}</span>`);return t}cutLine(){const{cut:e}=this;return e===null||this.live?d:l`<span
      class="cut-line"
      role="slider"
      tabindex="0"
      aria-label="Height of the section, mm"
      aria-orientation="vertical"
      aria-valuemin="0"
      aria-valuemax=${this.height}
      aria-valuenow=${e}
      ${B({bottom:`${e/this.height*100}%`})}
      @keydown=${this.key}
      ><span>${e.toFixed(1)}</span></span
    >`}hoverLine(){const{hover:e,layers:t}=this;if(e===null||!t||this.dragging)return d;const s=Va(t,e);return l`<span class="hover-line" ${B({bottom:`${e/this.height*100}%`})}
      ><span>${e.toFixed(0)} mm · ${K(s)}</span></span
    >`}heightAt(e){const t=e.currentTarget,{top:s,height:n}=t.getBoundingClientRect(),i=Math.max(0,Math.min(1,1-(e.clientY-s)/n));return Math.round(i*this.height*10)/10}cutAt(e){const{build:t}=this.session,{section:s}=t.value;t.set({section:{axis:"z",at:e,flipped:s?.axis==="z"?s.flipped:!1}})}grab(e){this.live||(e.preventDefault(),e.currentTarget.setPointerCapture(e.pointerId),this.dragging=!0,this.cutAt(this.heightAt(e)))}move(e){this.dragging?this.cutAt(this.heightAt(e)):this.hover=this.heightAt(e)}drop(){this.dragging=!1}key(e){const{build:t}=this.session,{section:s}=t.value,n=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;!s||n===0||(e.preventDefault(),e.stopPropagation(),t.set({section:xo(this.session,s,e.shiftKey?n*10:n)}))}};se([g({attribute:!1})],Tt.prototype,"session",2);se([g({attribute:!1})],Tt.prototype,"layers",2);se([g({type:Number})],Tt.prototype,"height",2);se([g({type:Number})],Tt.prototype,"average",2);se([g({type:Boolean})],Tt.prototype,"live",2);se([O()],Tt.prototype,"hover",2);Tt=se([k("sp-layers")],Tt);function dm(e,t,s){const n=[`0,${s(0)}`];return e.share.forEach((i,a)=>{n.push(`${t(i)},${s((a+.5)*e.thickness)}`)}),n.push(`0,${s(e.share.length*e.thickness)}`),n.join(" ")}const Ka=new WeakMap;function pm(e,t,s){const n=Ka.get(t);if(n)return n;const i=s.box.map(o=>o.map(c=>c/s.unit)),a=e.meshes.mesh(s)?.positions??null,r=Zs(t.transform,i,a);return a&&Ka.set(t,r),r}function fm(e,t,s,n,i){const a=new Map(s.map(p=>[p.index,p])),r=[];let o=0,c=0;for(const p of t.trays.get(n)?.copies.values()??[]){const f=a.get(p.part);if(!f?.mesh)continue;const m=pm(e,p,f.mesh);r.push({extent:m,volume:f.volume}),o=Math.max(o,m.high[2]),c+=f.volume}const h=i[0]*i[1],u=h*Math.max(i[2],o);return{standing:t.standing,density:u>0?c/u:0,height:o,layers:r.length>0&&h>0?lm(r,h,Math.max(i[2],o)):null}}function mm(e,t){const{live:s}=e.run;return l`<nav class="tstrip" aria-label="Trays"><div class="tabs-row" role="tablist">
    ${[...s.trays.values()].map(n=>l`<button
          type="button"
          class="tt plain ${n.number===t?"on":""}"
          role="tab"
          aria-selected=${n.number===t}
          @click=${()=>e.build.set({tray:n.number,follow:n.number===s.current})}
        >
          ${n.finished?l`<span class="ok-text">${b("check")}</span>`:z}
          <span><b>Tray ${n.number}</b><small>${S(n.copies.size)}</small></span>
        </button>`)}
  </div></nav>`}var gm=Object.defineProperty,$m=Object.getOwnPropertyDescriptor,cn=(e,t,s,n)=>{for(var i=n>1?void 0:n?$m(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&gm(t,s,i),i};const Ga=["x","y","z"];let Ye=class extends x{constructor(){super(...arguments),this.parts=[]}stores(){const{session:e}=this;return[e.work.move.state,e.run.state,e.meshes.state,$]}get move(){return this.session.work.move}render(){const{copy:e}=this.move.state.value;return e?l`<div class="head">
        <h2 class="grow">${this.move.state.value.from?"Move":"Put back"}</h2>
        <span class="count">Esc ${this.move.state.value.from?"puts it back":"leaves it out"}</span>
      </div>
      <div class="scroll">
        <section class="sec">${this.heading()}${this.place()}${this.turns()}</section>
        <section class="sec stack">${this.judgement()}${this.near()}${this.back()}</section>
        <section class="sec">${this.end()}</section>
      </div>`:d}heading(){const{copy:e}=this.move.state.value,t=this.parts.find(n=>n.index===e?.part);if(!e||!t)return d;const s=t.mesh?this.session.meshes.picture(t.mesh,tt(t.index),$.value.theme):null;return l`<div class="row">
      ${X(s,"th large")}
      <div class="grow cut">
        <h3 class="cut large-name">${t.name} ${e.copy+1}</h3>
        <div class="small dim cut">copy ${e.copy+1} of ${t.count}</div>
      </div>
    </div>`}place(){const{transform:e,from:t,seeking:s}=this.move.state.value,n=this.move.extent(e)?.low,i=t&&this.move.extent(t)?.low,a=(r,o)=>{const c=n?.[o]??0,h=[0,0,0];return l`<span class="axis">${r.toUpperCase()}</span>
        <sp-number
          label=${`Place along ${r.toUpperCase()}`}
          unit="mm"
          classes="third"
          .value=${Number(c.toFixed(1))}
          .places=${1}
          .digits=${1}
          ?disabled=${s}
          @value=${u=>{h[o]=(u.detail??c)-c,this.move.shift(h)}}
        ></sp-number>
        <span class="dim num">${i?th(c-(i[o]??0)):""}</span>`};return l`<div class="places">${Ga.map((r,o)=>a(r,o))}</div>`}turns(){const{transform:e,seeking:t}=this.move.state.value;return l`<div class="row between turns">
        <span class="dim">Turn</span>
        <div class="seg s" role="group" aria-label="Turn">
          ${Ga.map(s=>l`<button
                type="button"
                ?disabled=${t}
                title="Turn by 90° about ${s.toUpperCase()}"
                @click=${()=>this.move.turn(s)}
              >
                ${s.toUpperCase()} 90°
              </button>`)}
        </div>
      </div>
      <p class="small faint stands">${In(e)}</p>`}judgement(){const{clearance:e,touching:t,outside:s,wait:n,seeking:i}=this.move.state.value,a=r=>this.move.nameOf(r);if(i)return Oe("info",z,"Looking for the nearest free place","");if(e){const{tone:r,bold:o,text:c}=zr(e,a);return Oe(r,b(r==="ok"?"check":"bad"),o,c)}if(s||t.length>0){const{bold:r,text:o}=Xc(t,a,s);return Oe("bad",b("bad"),r,n??o)}return n?Oe("warn",b("warn"),"Not measured.",n):Oe("info",z,"Measuring the gaps","")}near(){const{clearance:e}=this.move.state.value,{nearest:t,next:s,wall:n}=e??{},i=(a,r)=>e?a?l`<dd class=${a.distance<a.gap?"bad-text b":""}>${r} · ${bm(a.distance)}</dd>`:l`<dd>none</dd>`:l`<dd class="faint">…</dd>`;return l`<dl class="kv">
      <dt>Nearest copy</dt>
      ${i(t,t?this.move.nameOf(t):"")}
      <dt>Next</dt>
      ${i(s,s?this.move.nameOf(s):"")}
      <dt>Nearest wall</dt>
      ${i(n,n?.side??"")}
    </dl>`}back(){const{clearance:e,touching:t,outside:s,seeking:n,from:i}=this.move.state.value,a=e?!e.clear:t.length>0||s;return l`<button
      type="button"
      class="btn fill"
      ?disabled=${!a||n}
      @click=${()=>void this.move.seek()}
    >
      ${n?z:d}${i?"Back to":"To"} the nearest free place
    </button>`}end(){const{clearance:e,placing:t,from:s}=this.move.state.value,n=e?.clear===!0&&this.move.moved;return l`<div class="halves">
        <button
          type="button"
          class="btn ${n?"primary":""}"
          ?disabled=${!n}
          title="Place here (Enter)"
          @click=${()=>this.move.place()}
        >
          ${t?z:d}Place here
        </button>
        <button type="button" class="btn" title="Put back (Esc)" @click=${()=>this.move.end()}>
          ${s?"Put back":"Leave it out"}
        </button>
      </div>
      <p class="small faint after">After a change the build is checked again before it can be exported.</p>`}};cn([g({attribute:!1})],Ye.prototype,"session",2);cn([g({attribute:!1})],Ye.prototype,"packing",2);cn([g({attribute:!1})],Ye.prototype,"parts",2);Ye=cn([k("sp-move")],Ye);const bm=e=>e<0?`${qt(-e,1)} outside`:qt(e,1);function Oe(e,t,s,n){return l`<div class="note ${e}" role="status">${t}<p><b>${s}</b> ${n}</p></div>`}function vm(e){const{job:t,loading:s,problem:n}=e.run.state.value;if(s||t.has_packing&&!n)return l`<main class="empty" aria-busy="true"><p class="dim row">${z}Opening the build …</p></main>`;const i={failed:["The run failed",t.error?st(t.error):"Nothing is said of why."],cancelled:["Stopped","Nothing was placed by then."],interrupted:["Interrupted","The computer or the program stopped before anything was placed."]},[a,r]=i[t.status]??["No build yet",n??"Press Pack on the Parts step."];return l`<main class="empty">
    <h2>${a}</h2>
    <p class="dim">${r}</p>
    <div class="row">
      ${t.status==="interrupted"||t.status==="cancelled"?l`<button type="button" class="btn primary" @click=${()=>e.goOn()}>Continue packing</button>`:d}
      <button
        type="button"
        class="btn ${t.status==="failed"?"primary":""}"
        @click=${()=>rt({page:"job",id:e.id,step:"parts"})}
      >
        To the parts
      </button>
      ${t.status==="failed"?l`<button type="button" class="btn" @click=${()=>e.pack()}>Pack again</button>`:d}
    </div>
  </main>`}var ym=Object.defineProperty,wm=Object.getOwnPropertyDescriptor,Ei=(e,t,s,n)=>{for(var i=n>1?void 0:n?wm(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&ym(t,s,i),i};let Fs=class extends x{constructor(){super(...arguments),this.ticking=0}stores(){return[this.session.run.state,$]}connectedCallback(){super.connectedCallback(),this.ticking=window.setInterval(()=>this.requestUpdate(),1e3)}disconnectedCallback(){super.disconnectedCallback(),clearInterval(this.ticking)}render(){const{job:e,since:t}=this.session.run.state.value;if(e.status==="queued")return this.queued();const s=t>0?(Date.now()-t)/1e3:0;return l`<div class="head">
        <h2 class="grow">Packing</h2>
        <span class="count">${Pt(Math.max(s,this.heard()))} so far</span>
      </div>
      <div class="scroll">
        <section class="sec">${this.numbers()}</section>
        <section class="sec">${this.phases()}</section>
        ${this.improving()} ${this.said()}
      </div>
      ${this.stop("Stop and keep the best so far")}`}queued(){const e=this.session.job.queue_place;return l`<div class="head"><h2 class="grow">Waiting</h2></div>
      <div class="scroll">
        <section class="sec">
          <p>
            ${e?l`<b>Place ${e} in the queue.</b>`:l`<b>In the queue.</b>`} It begins as soon as the
            jobs before it are done.
          </p>
        </section>
      </div>
      ${this.stop("Take it out of the queue")}`}heard(){return Math.max(0,...this.session.run.live.seconds.values())}numbers(){const{draft:e,info:t,parts:s,run:n}=this.session,{progress:i}=n.live,a=Math.max(Ar(e),i?.phase==="search"?i.total:0),{standing:r,density:o,height:c}=this.figures,h=i?.left??null,u=jt(e,t,s.meshes),p=n.live.trays.size>1;return l`<div class="fig">
        ${G(w(r),`of ${w(a)}`,"placed")}
        ${h===null?G("–","","time left"):G(Pt(h),"left",`of about ${Pt(h+(i?.seconds??0))}`)}
        ${G((o*100).toFixed(1),"%",p?"of this tray filled":"of the tray filled")}
        ${G(c.toFixed(0),"mm",u&&!e.openHeight&&!ns(e)?`height of ${u[2].toFixed(0)}`:"height")}
      </div>
      ${rs(a>0?r/a:0,"Copies placed","thick")}`}phases(){const{draft:e,run:t}=this.session,{live:s}=t,n=s.progress?.phase??null,i=sd(s.phases,n,e.parts.length);return l`<h3>What happens now</h3>
      <div class="checks">
        ${i.map(a=>{const r=s.seconds.get(a.phase),o=s.progress;return a.state==="now"?l`<div class="now" aria-current="step">
              <span class="dot"></span><span>${a.text}</span>
              <span>${o&&o.total>1?w(o.done):""}</span>
            </div>`:l`<div class=${a.state}>
            ${a.state==="done"?b("check"):l`<span></span>`}<span>${a.text}</span>
            <span class="faint">${a.state==="done"&&r!==void 0&&r>=.05?Gt(r):""}</span>
          </div>`})}
      </div>
      ${this.orders()}`}orders(){const e=this.session.run.live.progress;return e?.orders?l`<p class="small faint">Order ${e.order??1} of ${P(e.orders,"order")} tried.</p>`:d}improving(){const{curve:e}=this.session.run.live;return e.isThere?l`<section class="sec">
      <h3>${ln(e.what,e.before,e.now)??"Nothing better yet"}</h3>
      ${ji(e)}
    </section>`:d}said(){const e=co(this.session.run.live.remarks);return e.length===0?d:l`<section class="sec">
      <h3>Set aside and remarked</h3>
      <ul class="said">
        ${e.map(t=>l`<li>${t}</li>`)}
      </ul>
    </section>`}stop(e){const{job:t,stopping:s}=this.session.run.state.value,n=s||t.stopping===!0;return E(t)?l`<section class="sec bottom">
      <button
        type="button"
        class="btn l fill"
        ?disabled=${n}
        @click=${()=>this.session.stop()}
      >
        ${n?z:b("stop")}${n?"Stopping":e}
      </button>
      <p class="small faint">
        ${n?"What stands is taken apart and checked.":"Closing this page does not stop the job."}
      </p>
    </section>`:d}};Ei([g({attribute:!1})],Fs.prototype,"session",2);Ei([g({attribute:!1})],Fs.prototype,"figures",2);Fs=Ei([k("sp-packing")],Fs);const jn=8;function km(e,t){const{verdict:s}=e;if(!s)return l`<section class="sec">
      <h3>Checked</h3>
      <p class="dim">Not checked yet.</p>
    </section>`;const n=s.findings,i=n.some(h=>h.includes("outside")),a=n.some(h=>/overlap|gap|nested/.test(h)),r=Number(t.options["wall-gap"]??0),o=t.trays.reduce((h,u)=>h+u.steps,0),c=t.trays.reduce((h,u)=>h+u.throughWalls,0);return l`<section class="sec">
    <div class="row between">
      <h3>Checked</h3>
      <span class="small faint">on the exact meshes</span>
    </div>
    <div class="checks">
      ${Pe(a?"bad":"ok",a?"Copies come too near":"No two copies touch",s.min_gap===null?"":qt(s.min_gap,2))}
      ${Pe(i?"bad":"ok",i?"A copy sticks out":"All inside the tray",r>0?`${qt(r)} and more`:"")}
      ${s.apart==="checked"?Pe("ok","Comes apart",P(s.steps||o,"step")):s.apart==="no"?Pe("bad","Does not come apart",""):Pe("warn","Coming apart was not looked at","")}
    </div>
    ${s.apart==="checked"&&c>0?l`<p class="small dim">${P(c,"step")} ${c===1?"leads":"lead"} through the walls: open the tray at a side for ${c===1?"it":"them"}.</p>`:d}
    ${n.length>0?l`<ul class="said bad-text">
            ${n.slice(0,jn).map(h=>l`<li>${st(Fr(h,t))}</li>`)}
            ${n.length>jn?l`<li>And ${n.length-jn} more.</li>`:d}
          </ul>`:d}
  </section>`}function xm(e){const t=e.run.checking;return l`<section class="sec">
    <h3>${t?"Checking":"Not checked"}</h3>
    <div class="checks" role="status">
      <div class=${t?"run":"warn"}>
        ${t?z:b("warn")}<span
          >${t?"Every gap is measured, and the plan to take it apart is made anew.":"The build was changed. It is checked next."}</span
        ><span></span>
      </div>
    </div>
  </section>`}const Mm={ok:"check",warn:"warn",bad:"bad"};function Pe(e,t,s){return l`<div class=${e}>${b(Mm[e])}<span>${t}</span><span class="faint">${s}</span></div>`}function _m(e){const{packing:t}=e.run.state.value;return t?Math.max(0,Ar(e.draft)-t.placed):0}function Wo(e){const t=e.work.state.value.locks.size,s=_m(e);return l`${En("any","Pack all again",t>0?"locks are given up":"as the parts list has it",!1,()=>e.pack("none"))}
    ${En("lock",t>0?`Keep locked copies (${t}) and pack the rest`:"Keep locked copies and pack the rest",t>0?"they stay where they are":"lock some first: select them and press L",t===0,()=>e.pack("locked"))}
    ${En("add","Keep all, add what is missing",s>0?`${S(s)} more, in the room that is left`:"nothing is missing",s===0,()=>e.pack("all"))}`}function En(e,t,s,n,i){return l`<button type="button" class="mi" role="menuitem" ?disabled=${n} @click=${()=>void i()}>
    ${b(e)}<span>${t}<span>${s}</span></span>
  </button>`}function Om(e){const t=e.work.unchecked;return l`<sp-menu
    class="pack-again"
    buttonClasses="btn s"
    menuClasses="wide"
    hint=${t?"The change is checked first":"Pack again (Ctrl+Enter)"}
    ?disabled=${t}
    .button=${l`Pack again${b("down")}`}
    .content=${()=>Wo(e)}
  ></sp-menu>`}function Ja(e){const{work:t}=e,s=Je(e);if(s.length===0)return d;const n=s.filter(o=>t.isLocked(o)).length,i=n===s.length,a=i?"Locked: unlock it first (L)":"",r=s.length-n;return l`<div class="acts">
      <button
        type="button"
        class="btn"
        aria-pressed=${i}
        title=${i?"Unlock (L)":"Lock: it stays where it is when the rest is packed again (L)"}
        @click=${()=>t.toggleLock(s)}
      >
        ${b(i?"lock":"unlock")}${i?"Locked":l`Lock<kbd class="hide-s">L</kbd>`}
      </button>
      ${s.length===1?l`<button
              type="button"
              class="btn"
              ?disabled=${i}
              title=${a||"Move (M)"}
              @click=${()=>Do(e)}
            >
              ${b("move")}Move
            </button>`:d}
      <button
        type="button"
        class="btn danger"
        ?disabled=${i}
        title=${a||"Remove: take it out of the build (Del)"}
        @click=${()=>t.remove(s)}
      >
        ${b("trash")}${s.length>1&&r>0?`Remove ${r}`:"Remove"}
      </button>
    </div>
    ${n>0?l`<p class="small faint lock-words">
            ${s.length===1?"It stays where it is when the rest is packed again.":i?"They stay where they are when the rest is packed again.":`${S(n)} of them ${n===1?"is":"are"} locked.`}
          </p>`:d}`}var Pm=Object.defineProperty,Sm=Object.getOwnPropertyDescriptor,ne=(e,t,s,n)=>{for(var i=n>1?void 0:n?Sm(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Pm(t,s,i),i};const Tm=200;let At=class extends x{constructor(){super(...arguments),this.parts=[],this.tray=1,this.clearance=null,this.unknown=!1,this.asked="",this.timer=0,this.asking=null}stores(){const{session:e}=this;return[e.build,e.meshes.state,e.work.state,e.run.state,$]}disconnectedCallback(){super.disconnectedCallback(),clearTimeout(this.timer),this.asking?.abort()}get placements(){const{byId:e}=this.packing.trays[this.tray-1]??{byId:new Map};return this.session.build.value.selected.flatMap(t=>e.get(_(t))??[])}updated(e){const{placements:t}=this,s=t.length===1?t[0]:void 0,{unchecked:n}=this.session.work,i=s&&!n?`${this.tray}/${s.index}/${this.session.job.revision}/${_(s)}`:"";i!==this.asked&&(this.asked=i,clearTimeout(this.timer),this.asking?.abort(),this.clearance=null,this.unknown=!1,s&&(this.timer=window.setTimeout(()=>void this.measure(s.index),Tm)))}async measure(e){const t=new AbortController;this.asking=t;try{const s=await T.clearance(this.session.id,this.tray,e,t.signal);t.signal.aborted||(this.clearance=s)}catch{t.signal.aborted||(this.unknown=!0)}}render(){const{placements:e}=this,[t]=e;return t?l`<section class="sec selected" aria-label="Selected copy">
      ${e.length===1?this.one(t):this.several(e)}
    </section>`:d}head(e,t,s){const{meshes:n,work:i}=this.session,a=Je(this.session),r=a.length>0&&a.every(c=>i.isLocked(c)),o=e?.mesh?n.picture(e.mesh,tt(e.index),$.value.theme):null;return l`<div class="row">
      ${X(o,"th large")}
      <div class="grow cut">
        <h2 class="cut row">
          <span class="cut">${t}</span>
          ${r?l`<span class="locked" role="img" aria-label="Locked" title="Locked">${b("lock")}</span>`:d}
        </h2>
        <div class="small dim cut">${s}</div>
      </div>
      ${D("close","Let go (Esc)",()=>this.session.build.set({selected:[]}),"s")}
    </div>`}one(e){const t=this.parts.find(i=>i.index===e.part),s=t?.name??"",n=e.copy+1;return l`${this.head(t,`${s} ${n}`,`copy ${n} of ${t?.count??n} · placed ${tc(e.index+1)}`)}
      <dl class="kv">
        ${this.place(e,t)}
        <dt>Stands</dt>
        <dd>${In(e.transform)}</dd>
        ${this.nearest()}
        <dt>Way out</dt>
        <dd>${this.way(e)}</dd>
      </dl>
      ${Ja(this.session)} ${this.steps(e)}`}place(e,t){const s=t?.mesh;if(!s)return d;const n=s.box.map(o=>o.map(c=>c/s.unit)),i=Zs(e.transform,n,this.session.meshes.mesh(s)?.positions??null),a=i.low.map(o=>Math.abs(o).toFixed(1)),r=i.high.map((o,c)=>o-(i.low[c]??0));return l`<dt>Place</dt>
      <dd class="nw">X ${a[0]} &nbsp;Y ${a[1]} &nbsp;Z ${a[2]}</dd>
      <dt>Takes</dt>
      <dd>${ut(r,!0)}</dd>`}nearest(){const{clearance:e,unknown:t}=this,s=this.session.work.unchecked,n=t||s?l`<span class="faint">${s?"after the check":"not measured"}</span>`:z,{nearest:i,wall:a}=e??{},r=i?this.parts.find(o=>o.index===i.part)?.name:"";return l`<dt>Nearest copy</dt>
      <dd>
        ${e?i?l`<button
                    type="button"
                    class="link"
                    @click=${()=>this.session.build.set({selected:[{part:i.part,copy:i.copy}]})}
                  >
                    ${r} ${i.copy+1}</button
                  > · ${qt(i.distance,2)}`:"none":n}
      </dd>
      <dt>Nearest wall</dt>
      <dd>${e?a?`${a.side} · ${qt(a.distance,2)}`:"none":n}</dd>`}way(e){const t=this.packing.trays[this.tray-1];if(this.session.work.unchecked)return"after the check";if(e.step===null)return e.fixed?"stays where it is":"not known";const s=e.together>1?`, with ${P(e.together-1,"other")}`:"";return`step ${e.step} of ${t?.steps??0} · ${hh(e.path)}${s}`}steps(e){const t=(this.packing.trays[this.tray-1]?.placements??[]).filter(i=>i.part===e.part);if(t.length<2)return d;const s=t.findIndex(i=>i.copy===e.copy),n=i=>{const a=t[(s+i+t.length)%t.length];a&&this.session.build.set({selected:[{part:a.part,copy:a.copy}]})};return l`<div class="row between steps">
      ${D("left","The copy before",()=>n(-1),"s")}
      <button
        type="button"
        class="link small"
        @click=${()=>this.session.build.set({selected:t.map(({part:i,copy:a})=>({part:i,copy:a}))})}
      >
        Select all ${S(t.length)}
      </button>
      ${D("right","The next copy",()=>n(1),"s")}
    </div>`}several(e){const t=new Set(e.map(o=>o.part)),[s]=e,n=t.size===1?this.parts.find(o=>o.index===s?.part):void 0,i=e.reduce((o,c)=>o+(this.parts.find(h=>h.index===c.part)?.volume??0),0),a=new Set(e.map(o=>In(o.transform))),r=n?n.name:P(t.size,"part");return l`${this.head(n,r,`${S(e.length)} selected`)}
      <dl class="kv">
        <dt>Volume</dt>
        <dd>${pi(i)}</dd>
        <dt>Stand</dt>
        <dd>${a.size===1?[...a][0]:P(a.size,"way")}</dd>
      </dl>
      ${Ja(this.session)}
      ${n&&s?l`<div class="row between steps">
              <button
                type="button"
                class="link small"
                @click=${()=>this.session.build.set({selected:[{part:s.part,copy:s.copy}]})}
              >
                One after the other
              </button>
            </div>`:d}`}};ne([g({attribute:!1})],At.prototype,"session",2);ne([g({attribute:!1})],At.prototype,"packing",2);ne([g({attribute:!1})],At.prototype,"parts",2);ne([g({type:Number})],At.prototype,"tray",2);ne([O()],At.prototype,"clearance",2);ne([O()],At.prototype,"unknown",2);At=ne([k("sp-selected")],At);var Am=Object.defineProperty,Cm=Object.getOwnPropertyDescriptor,hs=(e,t,s,n)=>{for(var i=n>1?void 0:n?Cm(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Am(t,s,i),i};let fe=class extends x{constructor(){super(...arguments),this.parts=[],this.tray=1}stores(){const{session:e}=this;return[e.run.state,e.state,e.build,e.work.state,$]}render(){const{session:e,packing:t,tray:s}=this,n=t.trays.length<2?"Build":s===0?"All trays":`Tray ${s}`;return l`<div class="head">
        <h2 class="grow nw">${n}</h2>
        <button
          type="button"
          class="btn s ghost"
          @click=${()=>rt({page:"job",id:e.id,step:"parts"})}
        >
          ${b("add")}Add parts
        </button>
        ${Om(e)}
      </div>
      <div class="scroll">
        ${jd(e,t,s)}
        <section class="sec">${this.figures()}</section>
        ${e.build.value.selected.length>0&&s>0?l`<sp-selected .session=${e} .packing=${t} .parts=${this.parts} .tray=${s}></sp-selected>`:d}
        ${e.work.unchecked?xm(e):km(e.job,t)} ${this.how()}
      </div>`}figures(){const{packing:e,session:t,tray:s}=this,n=e.trays[s-1],i=t.job.verdict?.min_gap??e.minGap,a=n&&e.trays.length>1?n.placements.length:e.placed,r=n?n.height:Math.max(0,...e.trays.map(h=>h.height)),o=n?n.density:e.density,c=n?"of the tray filled":`filled, of ${e.trays.length} trays`;return l`<div class="fig">
      ${G((o*100).toFixed(1),"%",c)}
      ${G(r.toFixed(1),"mm",e.openHeight?"height reached":n?`height of ${w(e.size[2])}`:"greatest height")}
      ${G(w(a),`of ${w(e.copies)}`,n&&e.trays.length>1?"copies in this tray":"copies placed")}
      ${i===null?G("–","","least gap"):G(i.toFixed(2),"mm","least gap, measured")}
    </div>`}how(){const{packing:e}=this,t=e.improvement;return l`<section class="sec">
      <h3>How it went</h3>
      <p class="dim">Packed in ${Gt(e.seconds)}.</p>
      ${t?l`<p class="dim">${tm(t.what,t.before,t.now)}</p>`:d}
      ${ji(this.session.run.live.curve,!0)} ${om(this.session)}
    </section>`}};hs([g({attribute:!1})],fe.prototype,"session",2);hs([g({attribute:!1})],fe.prototype,"packing",2);hs([g({attribute:!1})],fe.prototype,"parts",2);hs([g({type:Number})],fe.prototype,"tray",2);fe=hs([k("sp-result")],fe);function jm(){return l`<div class="glass move-legend">
    <span><i class="you"></i>you move</span><span><i class="close"></i>too close</span
    ><span><i class="stays"></i>stays</span>
  </div>`}function Em(){return l`<div class="glass move-hint">
    <span>Drag an axis<span class="hide-touch">, or</span></span>
    <span class="hide-touch"
      ><kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd> <kbd>Page ↑</kbd> <kbd>Page ↓</kbd> by 1&#8239;mm</span
    >
    <span class="hide-touch"><kbd>Shift</kbd> by 10</span>
  </div>`}function Lm({clearance:e,touching:t}){if(!e)return t;const n=[e.nearest,e.next].filter(i=>i&&i.distance<i.gap).flatMap(i=>i?[{part:i.part,copy:i.copy}]:[]);return e.clear?[]:[...n,...t]}var Nm=Object.defineProperty,Dm=Object.getOwnPropertyDescriptor,pt=(e,t,s,n)=>{for(var i=n>1?void 0:n?Dm(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Nm(t,s,i),i};let ct=class extends x{constructor(){super(...arguments),this.parts=[],this.live=!1,this.tray=1,this.lost=!1,this.failed="",this.hovered=null,this.legend=null,this.view=null,this.scene=null,this.loading=!1,this.noPicture=null,this.drawn=()=>{}}stores(){const{session:e}=this,{work:t}=e;return[e.run.state,e.build,t.state,t.move.state,e.source.state,e.meshes.state,$]}disconnectedCallback(){super.disconnectedCallback(),this.end()}updated(e){this.view&&this.scene?this.sync(this.view,this.scene):this.begin()}async begin(){if(!(this.loading||this.failed)){this.loading=!0,this.drawn=this.session.meshes.holdPictures();try{const{createTrayView:e}=await Hr();if(!this.isConnected)return;const{build:t}=this.session;this.view=e(this.stage,{select:(s,n)=>this.select(s,n),hover:s=>{this.hovered=s},section:s=>{const n=t.value.section;n&&t.set({section:{...n,at:s}})},move:(s,n)=>this.session.work.move.dragged(s,n),shown:()=>this.drawn(),paced:()=>this.scene?.paced(),lost:s=>{this.lost=s}},$.value.theme),this.scene=new wo(this.session,this.view,()=>this.requestUpdate()),this.noPicture=ao(async()=>{const{clientWidth:s,clientHeight:n}=this.stage;if(!this.view)throw new Error("There is no picture yet.");return this.view.picture(s*2,n*2)}),this.requestUpdate()}catch{this.drawn(),this.failed="This browser draws no 3D graphics. Lists, figures and export work without them."}finally{this.loading=!1}}}end(){this.drawn(),this.noPicture?.(),this.view?.dispose(),this.view=null,this.scene=null}sync(e,t){const{session:s}=this,{packing:n}=s.run.state.value;e.setTheme($.value.theme);const i=n?.trays[this.tray-1];this.live?t.showLive(this.parts,s.run.live,this.tray,s.run.doing!=="improve"):n&&i&&t.showPacked(this.parts,n,i,!0);const{work:a}=s;t.showView(s.build.value,this.live?[]:Wc(a.state.value.locks,this.tray)),t.showMove(a.move.state.value,i,Lm(a.move.state.value)),t.showLabels(this.parts,a.move.active?[]:s.build.value.selected,this.hovered);const r=e.legend();JSON.stringify(r)!==JSON.stringify(this.legend)&&(this.legend=r)}select(e,t){const{build:s,work:n}=this.session;if(!n.move.active){if(!e){t||s.set({selected:[]});return}s.set({selected:t?Vh(s.value.selected,e):[e]})}}frame(e){const{selected:t}=this.session.build.value;this.view?.frame(e||t.length===0?null:t)}render(){const{session:e}=this,{build:t}=e,{find:s}=t.value,n=e.work.move.active;return l`<section class="view tray" aria-label="Tray">
      <div class="stage"></div>
      <p class="out">${this.summary()}</p>
      <div class="hud tl">
        ${this.live?e.run.doing==="improve"?d:Mp(e,this.parts):n?jm():_p(e,this.legend)}
      </div>
      <div class="hud tr">
        <div class="glass">
          ${D("frame","Frame all (Shift+F)",()=>this.frame(!0),"float")} ${Mo(i=>this.view?.look(i))} ${_o(e)}
          ${D("find","Find a copy or part (/)",()=>t.set({find:s===null?"":null}),"float")}
        </div>
      </div>
      ${s===null?d:l`<sp-find .session=${this.session} .parts=${this.parts} .tray=${this.tray} @found=${()=>this.frame(!1)}></sp-find>`}
      ${this.live?d:l`<div class="hud bc">${n?Em():Sp(e)}</div>`}
      ${this.failed||this.lost?l`<div class="lost">
              <p>${this.failed||"The graphics card took the picture away."}</p>
              ${this.failed?d:l`<button type="button" class="btn" @click=${this.again}>Draw again</button>`}
            </div>`:d}
    </section>`}again(){this.end(),this.lost=!1,this.requestUpdate()}summary(){const{packing:e}=this.session.run.state.value,{selected:t}=this.session.build.value,s=t.length>0?` ${S(t.length)} selected.`:"";if(this.live)return`${S(this.session.run.live.standing)} placed so far.${s}`;const n=e?.trays[this.tray-1];if(!n)return"";const i=new Set(n.placements.map(a=>a.part)).size;return`${S(n.placements.length)} of ${P(i,"part")}, ${K(n.density)} filled.${s}`}};pt([g({attribute:!1})],ct.prototype,"session",2);pt([g({attribute:!1})],ct.prototype,"parts",2);pt([g({type:Boolean})],ct.prototype,"live",2);pt([g({type:Number})],ct.prototype,"tray",2);pt([H(".stage")],ct.prototype,"stage",2);pt([O()],ct.prototype,"lost",2);pt([O()],ct.prototype,"failed",2);pt([O()],ct.prototype,"hovered",2);pt([O()],ct.prototype,"legend",2);ct=pt([k("sp-tray")],ct);var Fm=Object.defineProperty,Im=Object.getOwnPropertyDescriptor,us=(e,t,s,n)=>{for(var i=n>1?void 0:n?Im(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Fm(t,s,i),i};const zm=40;let me=class extends x{constructor(){super(...arguments),this.parts=[],this.all=!1}stores(){return[this.session.run.state,this.session.meshes.state,$]}render(){const{packing:e}=this,t=Math.max(...e.trays.map(s=>s.density),1e-9);return l`<section class="trays" aria-label="All trays">
      <div class="tgrid">${e.trays.map(s=>this.card(s,t))}</div>
      ${this.table()}
    </section>`}card(e,t){const s=this.session.job.verdict?.apart==="checked"&&e.complete,n=wi(this.packing,e.number),[i,a,r]=this.packing.size;return l`<article class="card tcard ${r>=Math.max(i,a)?"tall":""}">
      <button
        type="button"
        class="whole"
        aria-label="Open tray ${e.number}"
        @click=${()=>Ve(this.session,e.number)}
      ></button>
      <div class="view"><img src=${ai(this.session.id,"png",e.number)} alt="Tray ${e.number}" loading="lazy" /></div>
      <div class="bd">
        <div class="row between">
          <h2>Tray ${e.number}</h2>
          ${n?l`<span class="row small b warn-text">${b("warn")}Nearly empty</span>`:s?l`<span class="ok-text" role="img" aria-label="Comes apart: checked" title="Comes apart: checked"
                    >${b("check")}</span
                  >`:d}
        </div>
        <div class="row between">
          <span class="dim">${S(e.placements.length)}</span><b>${K(e.density)}</b>
        </div>
        ${rs(e.density/t)}
      </div>
    </article>`}table(){const{trays:e}=this.packing,t=e.map(i=>Pr([i])),s=this.all?this.parts:this.parts.slice(0,zm),n=(i,a)=>`color-mix(in srgb, var(--accent) ${Math.round(4+32*i/Math.max(1,a.count))}%, transparent)`;return l`<div class="card wide-table">
      <table class="mx">
        <thead>
          <tr>
            <th scope="col">Where each part went</th>
            ${e.map(i=>l`<th scope="col">Tray ${i.number}</th>`)}
            <th scope="col">Left over</th>
            <th scope="col">Total</th>
          </tr>
        </thead>
        <tbody>
          ${s.map(i=>{const a=t.map(o=>o.get(i.index)??0),r=i.count-a.reduce((o,c)=>o+c,0);return l`<tr>
              <th scope="row">
                <span class="row">
                  ${X(i.mesh?this.session.meshes.picture(i.mesh,tt(i.index),$.value.theme):null,"th small-th")}<span class="cut">${i.name}</span>
                </span>
              </th>
              ${a.map(o=>l`<td>
                    ${o>0?l`<span class="share" ${B({background:n(o,i)})}>${o}</span>`:l`<span class="faint">·</span>`}
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
              ${P(this.parts.length-s.length,"more part")}
            </button>`:d}
    </div>`}};us([g({attribute:!1})],me.prototype,"session",2);us([g({attribute:!1})],me.prototype,"packing",2);us([g({attribute:!1})],me.prototype,"parts",2);us([O()],me.prototype,"all",2);me=us([k("sp-trays")],me);var Rm=Object.defineProperty,Um=Object.getOwnPropertyDescriptor,hn=(e,t,s,n)=>{for(var i=n>1?void 0:n?Um(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Rm(t,s,i),i};let Ze=class extends x{constructor(){super(...arguments),this.drawer=null,this.release=null,this.releaseMove=null,this.liveKeys=null,this.saidTenth=-1,this.wasRunning=!1,this.parts=[],this.madeOf=[]}stores(){const{session:e}=this;return[e.run.state,e.build,e.source.state,e.work.move.state]}disconnectedCallback(){super.disconnectedCallback(),this.release?.(),this.release=null,this.liveKeys=null,this.releaseMove?.(),this.releaseMove=null,this.session.work.move.end()}updated(e){const t=this.session.run.packs;this.holdMoveKeys(),t!==this.liveKeys&&(this.release?.(),this.release=Ue(Rf({session:()=>this.session,frame:s=>this.pane?.frame(s),openExport:()=>document.querySelector("sp-export")?.show(),openPack:()=>this.querySelector("sp-menu.pack-again")?.show()},t)),this.liveKeys=t),this.say(t)}holdMoveKeys(){const{active:e}=this.session.work.move;e&&!this.releaseMove?(this.releaseMove=Ue(zf(()=>this.session)),this.drawer="right"):e||(this.releaseMove?.(),this.releaseMove=null)}say(e){const{progress:t}=this.session.run.live;if(e&&t?.phase==="search"&&t.total>0){const s=Math.floor(10*t.done/t.total);s>this.saidTenth&&s>0&&Rt(`${s*10} percent of the copies are placed.`),this.saidTenth=s}if(this.wasRunning&&!e){const{job:s,packing:n}=this.session.run.state.value,i=de(s)?.text??js(s).text;Rt(n?`Done. ${S(n.placed)} placed, ${K(n.density)} filled. ${i}.`:js(s).text)}this.wasRunning=e}render(){const{session:e}=this,{packing:t,loading:s}=e.run.state.value,n=s&&!t&&e.run.live.standing>0,{curve:i,standing:a}=e.run.live,r=e.run.packs&&e.run.doing==="improve"&&(a===0||i.points.length<2);if((e.run.packs||n)&&!(r&&t))return this.live();if(!t)return vm(e);const o=this.partsOf(t,()=>Ks(e,t)),c=t.trays.length<2?1:Math.min(e.build.value.tray,t.trays.length);return c===0?this.all(t,o):this.one(t,o,c)}partsOf(e,t){const{meshes:s}=this.session.parts;return(this.madeOf[0]!==e||this.madeOf[1]!==s)&&(this.madeOf=[e,s],this.parts=t()),this.parts}live(){const{session:e}=this,{live:t}=e.run,{follow:s,tray:n}=e.build.value,i=this.partsOf(e.draft,()=>bc(e)),a=s||n===0?t.current:n,r=jt(e.draft,e.info,e.parts.meshes)??[100,100,100],o=fm(e,t,i,a,r);return this.frame({live:!0,parts:i,tray:a,tabs:t.trays.size>1?mm(e,a):d,layers:o.layers,height:Math.max(r[2],o.height),average:o.density,panel:e.run.doing==="improve"?l`<sp-improve .session=${e}></sp-improve>`:l`<sp-packing .session=${e} .figures=${o}></sp-packing>`})}one(e,t,s){const{session:n}=this,i=e.trays[s-1];return this.frame({live:!1,parts:t,tray:s,tabs:Vn(n,e,s),layers:i?.layers??null,height:Math.max(e.size[2],i?.height??0),average:i?.density??0,panel:this.resultPanel(e,t,s)})}resultPanel(e,t,s){const{session:n}=this;return n.run.packs?l`<sp-improve .session=${n}></sp-improve>`:n.work.move.active?l`<sp-move .session=${n} .packing=${e} .parts=${t}></sp-move>`:l`<sp-result .session=${n} .packing=${e} .parts=${t} .tray=${s}></sp-result>`}frame(e){const{session:t}=this,{live:s,parts:n,tray:i}=e;return l`${e.tabs}
      <main class="main build" data-drawer=${this.drawer??d}>
        <h1 class="out">${t.job.name}: build</h1>
        <aside class="side left" aria-label="Parts">
          <sp-build-list .session=${t} .parts=${n} ?live=${s} .tray=${i}></sp-build-list>
        </aside>
        <sp-divider property="--left" side="left" label="Width of the list" most="480"></sp-divider>
        <div class="vsplit">
          <sp-tray .session=${t} .parts=${n} ?live=${s} .tray=${i}></sp-tray>
          <sp-layers
            .session=${t}
            ?live=${s}
            .layers=${e.layers}
            .height=${e.height}
            .average=${e.average}
          ></sp-layers>
        </div>
        <sp-divider property="--right" side="right" label="Width of the figures" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label=${s?"Packing":"Build"}>${e.panel}</aside>
        ${this.drawers()}
      </main>`}all(e,t){const{session:s}=this;return l`${Vn(s,e,0)}
      <main class="main build all" data-drawer=${this.drawer??d}>
        <h1 class="out">${s.job.name}: all trays</h1>
        <sp-trays .session=${s} .packing=${e} .parts=${t}></sp-trays>
        <sp-divider property="--right" side="right" label="Width of the figures" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Build">${this.resultPanel(e,t,0)}</aside>
        ${this.drawers()}
      </main>`}drawers(){const e=(t,s)=>l`<button
        type="button"
        class="btn"
        aria-pressed=${this.drawer===t}
        @click=${()=>{this.drawer=this.drawer===t?null:t}}
      >
        ${b(t==="left"?"list":"info")}${s}
      </button>`;return l`<div class="drawers">${e("left","Parts")}${e("right","Figures")}</div>`}};hn([g({attribute:!1})],Ze.prototype,"session",2);hn([O()],Ze.prototype,"drawer",2);hn([H("sp-tray")],Ze.prototype,"pane",2);Ze=hn([k("sp-build")],Ze);function Bm(e){const t=[...e.files??[]].map(s=>({file:s,path:s.webkitRelativePath||s.name}));return e.value="",t}function Vo(e){return[...e.dataTransfer?.items??[]].filter(t=>t.kind==="file").length}async function Ko(e){const t=[...e.dataTransfer?.items??[]].filter(a=>a.kind==="file"),s=t.map(a=>a.webkitGetAsEntry?.()??null),n=t.map(a=>a.getAsFile());return(await Promise.all(s.map((a,r)=>{const o=n[r];return a?Go(a):Promise.resolve(o?[{file:o,path:o.name}]:[])}))).flat()}async function Go(e){const t=e.fullPath.replace(/^\//,"");if(e.isFile){const n=await new Promise(i=>e.file(i,()=>i(null)));return n?[{file:n,path:t}]:[]}const s=[];for(const n of await Hm(e))s.push(...await Go(n));return s}async function Hm(e){const t=e.createReader(),s=[];for(;;){const n=await new Promise(i=>t.readEntries(i,()=>i([])));if(n.length===0)return s;s.push(...n)}}const qm=".stl,.3mf,.obj,.ply,.off,.csv,.json";function vt(e,t={}){const s=document.createElement("input");s.type="file",s.multiple=t.several??!0,t.folder?s.webkitdirectory=!0:s.accept=t.accept??qm,s.addEventListener("change",()=>e(Bm(s))),s.click()}function Li(e){const{refused:t,dismissed:s}=e.state.value,n=e.parts.bad.map(({file:i,error:a,place:r})=>({file:i,error:st(r?`${r}: ${a}`:a)}));return[...t,...n].filter(({file:i})=>!s.has(i))}function Wm(e){return e.parts.sets.filter(t=>t.missing.length>0&&!e.state.value.dismissed.has(t.file)).map(t=>`${t.file} names ${P(t.missing.length,"file")} that ${t.missing.length===1?"is":"are"} not here: ${Vm(t.missing)}.`)}function Vm(e){const t=e.slice(0,3).join(", ");return e.length>3?`${t} and ${e.length-3} more`:t}function Km(e,t){const s=Li(e),n=s.length+e.parts.meshes.length;return l`${s.length>0?l`<div class="banner bad" role="status">
          ${b("bad")}
          <span class="grow">
            <b>${s.length} of ${P(Math.max(n,s.length),"file")} cannot be used.</b>
            ${t>0?l`<span class="dim">The other parts are ready to pack.</span>`:d}
          </span>
          <button type="button" class="btn s" @click=${()=>e.leaveOutFiles(s.map(({file:i})=>i))}>
            ${s.length===1?"Leave it out":s.length===2?"Leave both out":"Leave all out"}
          </button>
        </div>`:d}${Wm(e).map(i=>l`<div class="banner warn" role="status">
        ${b("warn")}<span class="grow">${i}</span>
        <button type="button" class="btn s" @click=${()=>vt(a=>e.addFiles(a))}>Add them</button>
      </div>`)}`}function Gm(e){return Li(e).map(({file:t,error:s})=>l`<div class="pr bad-file" role="row">
        <span role="gridcell" class="c-check bad-text">${b("bad")}</span>
        <span role="gridcell" class="nm">
          <b class="cut">${t}</b>
          <span class="cut bad-text" title=${s}>${s}</span>
        </span>
        <span role="gridcell" class="row">
          <button
            type="button"
            class="btn s"
            @click=${()=>vt(([n])=>n&&e.replaceFile(t,n.file),{several:!1})}
          >
            Replace
          </button>
          <button type="button" class="btn s" @click=${()=>e.leaveOutFiles([t])}>Leave out</button>
        </span>
      </div>`)}var Jm=Object.defineProperty,Ym=Object.getOwnPropertyDescriptor,Ni=(e,t,s,n)=>{for(var i=n>1?void 0:n?Ym(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Jm(t,s,i),i};let Is=class extends x{constructor(){super(...arguments),this.starting=!1}stores(){const{session:e}=this,{saver:t,source:s,uploads:n,run:i,work:a}=e;return[e.state,t.state,s.state,n.state,i.state,a.state,$]}render(){const{session:e}=this,t=Or(Fn(e)),s=e.uploads.state.value.active||e.parts.reading>0;return l`<footer class="dock" aria-label="Estimate">
      ${this.figures()}
      <span class="grow"></span>
      ${this.remark(s)} ${this.packButton(t,e.locked||t===0||s||this.starting)}
    </footer>`}packButton(e,t){const{session:s}=this,n=l`${this.starting?z:d}${e>0?`Pack ${S(e)}`:"Pack"}
      <kbd class="hide-s">Ctrl ↵</kbd>`;return s.work.state.value.locks.size>0&&s.job.has_packing?l`<sp-menu
        class="pack-again"
        buttonClasses="btn primary l pack"
        menuClasses="wide"
        ?disabled=${t}
        .button=${l`${n}${b("down")}`}
        .content=${()=>Wo(s)}
      ></sp-menu>`:l`<button type="button" class="btn primary l pack" ?disabled=${t} @click=${this.pack}>${n}</button>`}figures(){const{estimate:e,estimating:t}=this.session.saver.state.value;if(!e)return t?l`<span class="dim row">${z}Estimating …</span>`:d;const{volume_ratio:s,seconds:n,memory:i}=e,[a,r]=n===null?["",""]:Gt(n).split(L),[o,c]=Ms(i).split(L);return l`<div class="fig ${t?"stale":""}">
      ${s===void 0?d:this.fill(s)}
      ${a?G(`≈ ${a}`,r??"","to pack"):d}
      ${G(`≈ ${o}`,c??"","of memory")}
    </div>`}fill(e){const{draft:t}=this.session;if(t.trays==="all"||e>1)return G(`≈ ${e.toFixed(e<10?2:0)}`,"trays","of solid material");const s=e/t.trays*100;return G(`≈ ${s.toFixed(s<10?1:0)}`,"%",t.trays>1?"of the trays filled":"of the tray filled")}remark(e){const{session:t}=this,{problem:s,doubt:n,estimate:i}=t.saver.state.value;if(s??n)return l`<span class="row small bad-text remark-text">${b("bad")}<span>${s??n}</span></span>`;if(e)return l`<span class="row small dim">${z}Files are still read</span>`;const a=Fn(t).filter(c=>c.remarks.some(h=>h.tone==="bad")).length;if(a>0)return l`<span class="row small warn-text"
        >${b("warn")}<span>Not everything may fit: ${P(a,"part")} ${a===1?"needs":"need"} a look</span></span
      >`;const r=Li(t).length;if(r>0)return l`<span class="row small bad-text">${b("bad")}<span>${P(r,"file")} will be left out</span></span>`;const o=i?.left_over??0;return o>0?l`<span class="row small warn-text">${b("warn")}<span>${S(o)} will be left over</span></span>`:d}async pack(){this.starting=!0,await this.session.pack(),this.starting=!1}};Ni([g({attribute:!1})],Is.prototype,"session",2);Ni([O()],Is.prototype,"starting",2);Is=Ni([k("sp-dock")],Is);const un=[{value:"any",text:"Any way",icon:"any"},{value:"upright",text:"Upright",icon:"upright"},{value:"fixed",text:"As drawn",icon:"drawn"},{value:"axes",text:"Axes",icon:"axes"}];function Qn(e){if(e.kind==="axes"){const t=[...new Set(e.axes.map(s=>s.slice(1).toUpperCase()))];return t.length===1?`About ${t[0]}`:"Axes"}return e.kind==="matrices"?"As listed":un.find(t=>t.value===e.kind)?.text??""}function Jo(e){return un.find(t=>t.value===e.kind)?.icon??"axes"}function Yo(e,t){return e===t.kind?t:e==="axes"?{kind:e,axes:["+z","-z"],yaw:null}:e==="matrices"?t:{kind:e}}const Zm=["+x","-x","+y","-y","+z","-z"],Xm=e=>e.toUpperCase().replace("-","−");function Qm(e,t){switch(e.kind){case"any":return t;case"upright":return"Turned about the vertical only; its top stays up.";case"fixed":return"As it lies in its file.";case"axes":return"One of these directions of the part points up.";default:return"Turns listed in the job file."}}function tg(e){return e===void 0||e==="90"||e===90?"24 positions tried":e==="none"?"As in the file: turns are off":e==="45"||e===45?"208 positions tried":`Turned in steps: ${e}`}const zs=[{value:"1",text:"First"},{value:"0",text:"Normal"},{value:"-1",text:"If room"}];function eg(e){return zs.find(s=>Number(s.value)===e)?.text??String(e)}var sg=Object.defineProperty,ng=Object.getOwnPropertyDescriptor,Zo=(e,t,s,n)=>{for(var i=n>1?void 0:n?ng(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&sg(t,s,i),i};let ti=class extends x{stores(){return[this.session.state,this.session.view]}get parts(){const{chosen:e,current:t}=this.session.view.value;return this.session.draft.parts.filter(s=>e.size>0?e.has(s.key):s.key===t)}change(e,t=""){const s=new Set(this.parts.map(n=>n.key));this.session.edit(n=>Ts(n,s,e),t&&`${t} ${s.size}`)}render(){const{parts:e}=this,[t]=e;if(!t)return d;const s=e.length>1,n=e.every(a=>a.stands.kind===t.stands.kind)?t.stands.kind:null,i=tg(this.session.draft.options.rotations);return l`<div class="hud bl wide">
      <div class="card part-card">
        <div class="row between">
          <span class="small dim">${s?`${e.length} parts may stand`:"May stand"}</span>
          <span class="small faint cut">${n===null?"":Qm(t.stands,i)}</span>
        </div>
        ${te("May stand",un,n,a=>this.change({stands:Yo(a,s?{kind:"any"}:t.stands)}),"fill s icons")}
        ${t.stands.kind==="axes"&&n==="axes"?this.axes(t.stands):d}
        <div class="fields ${s?"":"only-s"}">${this.fields(e,t,s)}</div>
      </div>
    </div>`}axes(e){const t=s=>{const i=e.axes.includes(s)?e.axes.filter(a=>a!==s):[...e.axes,s];i.length>0&&this.change({stands:{...e,axes:i}})};return l`<div class="row axes">
      <span class="small dim">Up</span>
      <div class="seg fill s" role="group" aria-label="Directions of the part that may point up">
        ${Zm.map(s=>l`<button type="button" aria-pressed=${e.axes.includes(s)} @click=${()=>t(s)}>
              ${Xm(s)}
            </button>`)}
      </div>
      ${Kt("Turned about the vertical in steps of",[{value:"",text:"usual turns"},{value:"90",text:"90° turns"},{value:"45",text:"45° turns"},{value:"15",text:"15° turns"},{value:"360",text:"no turns"}],e.yaw===null?"":String(e.yaw),s=>this.change({stands:{...e,yaw:s===""?null:Number(s)}}),"s")}
    </div>`}fields(e,t,s){const n=r=>e.every(o=>r(o)===r(t)),i=Vs(this.session.draft,this.session.info).toFixed(1),a=n(r=>r.priority)?String(t.priority):null;return l`${s?l`<label class="field"
              ><span class="dim">Copies</span>
              <sp-number
                label="Copies of each"
                .value=${t.count}
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
                .value=${t.scale*100}
                ?mixed=${!n(r=>r.scale)}
                .least=${0}
                above
                .digits=${4}
                @value=${r=>this.change({scale:(r.detail??100)/100},"scale")}
              ></sp-number>
            </label>`:d}
      <label class="field"
        ><span class="dim">Gap</span>
        <sp-number
          label="Gap"
          unit="mm"
          optional
          placeholder=${i}
          .value=${t.gap}
          ?mixed=${!n(r=>r.gap)}
          .least=${0}
          .step=${.5}
          .places=${1}
          @value=${r=>this.change({gap:r.detail},"gap")}
        ></sp-number>
      </label>
      <div class="field">
        <span class="dim">Priority</span>
        ${Kt("Priority",zs,a,r=>this.change({priority:Number(r)}),"n")}
      </div>
      ${s?l`<label class="field"
              ><span class="dim">Due</span>
              <span class="in n date"
                ><input
                  type="date"
                  aria-label="Due date"
                  .value=${n(r=>r.due)?t.due??"":""}
                  @change=${r=>this.change({due:r.target.value||null})}
              /></span>
            </label>`:d}`}};Zo([g({attribute:!1})],ti.prototype,"session",2);ti=Zo([k("sp-part-card")],ti);var ig=Object.defineProperty,ag=Object.getOwnPropertyDescriptor,Di=(e,t,s,n)=>{for(var i=n>1?void 0:n?ag(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&ig(t,s,i),i};let Rs=class extends x{constructor(){super(...arguments),this.view=null,this.loading=!1,this.shownAs=""}stores(){const{session:e}=this;return[e.state,e.view,e.source.state,e.meshes.state,$]}disconnectedCallback(){super.disconnectedCallback(),this.view?.dispose(),this.view=null,this.shownAs=""}get shown(){const{current:e}=this.session.view.value,{draft:t,parts:s}=this.session,n=t.parts.findIndex(a=>a.key===e),i=t.parts[n];return i?{part:i,index:n,mesh:mi(s.meshes)(i)}:null}updated(e){this.view?this.draw(this.view):this.begin()}async begin(){if(this.loading||!this.shown)return;this.loading=!0;const{createPartView:e}=await Ph();if(this.loading=!1,!this.isConnected)return;const t=e(this.stage,$.value.theme);this.view=t,this.draw(t)}draw(e){e.setTheme($.value.theme);const t=this.shown,s=t?.mesh;if(!t||!s){this.shownAs!==""&&e.show(null,1,"#888888","any"),this.shownAs="";return}const{part:n,index:i}=t,a=yr(n,s,this.session.draft),r=n.stands.kind==="matrices"?"axes":n.stands.kind,o=tt(i),c=[n.key,s.id,s.volume,s.triangles,a,r,o].join("|"),h=this.session.meshes.mesh(s);c!==this.shownAs&&(h?e.show(h,a,o,r):this.session.meshes.load([s]),this.shownAs=c,this.session.meshes.fine(s).then(u=>{u&&this.shownAs===c&&this.view?.show(u,a,o,r)}))}render(){const e=this.shown,{chosen:t}=this.session.view.value;return l`<section class="view preview" aria-label="Selected part">
      <div class="stage"></div>
      ${e?this.words(e):d}
      ${e||t.size>0?l`<sp-part-card .session=${this.session}></sp-part-card>`:d}
    </section>`}words({part:e,mesh:t}){const{draft:s,view:n}=this.session,i=n.value.inch?"inch":"mm";return l`<div class="hud tl wide">
      <div class="cut grow">
        <h2 class="cut">${ss(e,t)}</h2>
        ${t?l`<p class="dim small cut">
                  ${ut(qs(e,t,s),!0,i)} · ${pi(kr(e,t,s))}
                </p>
                <p class="dim small facts hide-s">${rg(t)}</p>`:l`<p class="dim small cut">${e.file}</p>`}
      </div>
      ${te("Unit of the sizes shown",[{value:"mm",text:"mm"},{value:"inch",text:"inch"}],i,a=>n.set({inch:a==="inch"}),"s")}
    </div>`}};Di([g({attribute:!1})],Rs.prototype,"session",2);Di([H(".stage")],Rs.prototype,"stage",2);Rs=Di([k("sp-part-preview")],Rs);function rg(e){const t=e.watertight?"closed":"not closed",s=e.shells>1?` · ${P(e.shells,"body","bodies")}`:"",n=`${P(e.triangles,"triangle")} · ${t}${s}`;return e.repairs.length===0?l`${n} · nothing mended`:l`${n} ·
    <details class="repairs">
      <summary class="link">${P(e.repairs.length,"thing")} mended</summary>
      <ul>
        ${e.repairs.map(i=>l`<li>${st(i)}</li>`)}
      </ul>
    </details>`}const Ft=["check","name","count","scale","stands","gap","priority","due"],og="input, select, button",lg=new Set(["scale","stands","gap","priority","due"]);class cg{constructor(t){this.list=t,this.cell={row:0,column:1},this.wanted=!1,this.fresh=!1}settle(){this.wanted&&(this.wanted=!1,this.element(this.cell)?.focus())}focused(t){const s=t.target.closest("[data-column]"),n=s?.closest("[data-row]");if(!s||!n)return;const i={row:Number(n.dataset.row),column:Ft.indexOf(s.dataset.column)};i.row===this.cell.row&&i.column===this.cell.column||(this.cell=i,this.look(),this.list.requestUpdate())}pressed(t){const s=t.target.closest("[data-row]");this.fresh=s!==null&&!s.classList.contains("sel")}released(t){const s=t.target.closest("[data-column]");!this.fresh||!s||!lg.has(s.dataset.column??"")||(this.fresh=!1,this.list.updateComplete.then(()=>this.enter(s)))}key(t){const s=t.target,n=s.closest("[data-column]");n&&(s!==n?this.keyInField(t,n):this.keyOnCell(t,n))}keyInField(t,s){t.key==="Escape"?(t.stopPropagation(),s.focus()):t.key==="Enter"&&!t.ctrlKey&&!t.metaKey&&t.target instanceof HTMLInputElement&&(t.preventDefault(),this.move(1,0))}keyOnCell(t,s){const i=this.list.shown.length-1,r={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1],PageUp:[-8,0],PageDown:[8,0],Home:t.ctrlKey?[-i,-Ft.length]:[0,-Ft.length],End:t.ctrlKey?[i,0]:[0,Ft.length]}[t.key];r?(t.preventDefault(),t.stopPropagation(),t.shiftKey&&r[1]===0&&this.choose(this.cell.row,!0),this.move(r[0],r[1]),t.shiftKey&&r[1]===0&&this.choose(this.cell.row,!0)):(t.key==="Enter"||t.key==="F2")&&!t.ctrlKey&&!t.metaKey?(t.preventDefault(),this.enter(s)):t.key===" "?(t.preventDefault(),this.choose(this.cell.row,null)):t.key==="a"&&(t.ctrlKey||t.metaKey)?(t.preventDefault(),this.list.session.view.set({chosen:new Set(this.list.shown.map(o=>o.part.key))})):/^[0-9]$/.test(t.key)&&s.querySelector("input")&&(t.stopPropagation(),this.enter(s))}enter(t){const s=t.querySelector("input, select")??t.querySelector(og);s&&(s.focus(),s instanceof HTMLInputElement?s.select?.():s instanceof HTMLButtonElement&&s.click())}move(t,s){const n=Math.max(0,Math.min(this.list.shown.length-1,this.cell.row+t)),i=Math.max(0,Math.min(Ft.length-1,this.cell.column+s));this.cell={row:n,column:i},this.wanted=!0,this.look(),this.list.reveal(n)}look(){const t=this.list.shown[this.cell.row]?.part.key;t!==void 0&&this.list.session.view.set({current:t})}choose(t,s){const{view:n}=this.list.session,i=this.list.shown[t]?.part.key;if(i===void 0)return;const a=new Set(n.value.chosen);s??!a.has(i)?a.add(i):a.delete(i),n.set({chosen:a})}element(t){const s=Ft[t.column]??"name";return this.list.querySelector(`[data-row="${t.row}"] [data-column="${s}"]`)}}const Ln=50,hg="#9aa3af";function ug(e){const t=e.parts.reading>0?[]:Qr(e.draft,e.parts.meshes);return t.length===0?d:l`<section class="left-out" aria-label="Left out">
    <div class="row between">
      <h3>Left out <span class="count">${P(t.length,"part")}</span></h3>
      ${t.length>1?l`<button type="button" class="link small" @click=${()=>Ya(e,t)}>Put all back</button>`:d}
    </div>
    ${t.slice(0,Ln).map(s=>l`<div class="li">
          ${X(e.meshes.picture(s,hg,$.value.theme))}
          <div class="cut">${s.name} <span class="count">${ut(s.size)}</span></div>
          <button type="button" class="link small" @click=${()=>Ya(e,[s])}>Put back</button>
        </div>`)}
    ${t.length>Ln?l`<p class="small faint">${P(t.length-Ln,"more part")}.</p>`:d}
  </section>`}function Ya(e,t){e.edit(s=>{const n=new Set(s.parts.map(i=>i.key));return Gr(s,t.map(i=>Xr(i,n)))})}var dg=Object.defineProperty,pg=Object.getOwnPropertyDescriptor,ft=(e,t,s,n)=>{for(var i=n>1?void 0:n?pg(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&dg(t,s,i),i};let ht=class extends x{constructor(){super(...arguments),this.label="",this.value=null,this.least=1,this.most=1e6,this.mixed=!1,this.disabled=!1,this.bare=!1,this.tab=0}focus(){this.field?.focus()}render(){const e=(t,s,n,i)=>this.bare?d:l`<button
            type="button"
            class="more-less"
            tabindex="-1"
            aria-label="${s} ${this.label}"
            ?disabled=${this.disabled||i}
            @click=${()=>this.field.stepBy(n,!1)}
          >
            ${b(t)}
          </button>`;return l`<span class="step ${this.bare?"bare":""}">
      ${e("minus","One less:",-1,this.value!==null&&this.value<=this.least)}
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
      ${e("add","One more:",1,!1)}
    </span>`}};ft([g()],ht.prototype,"label",2);ft([g({attribute:!1})],ht.prototype,"value",2);ft([g({type:Number})],ht.prototype,"least",2);ft([g({type:Number})],ht.prototype,"most",2);ft([g({type:Boolean})],ht.prototype,"mixed",2);ft([g({type:Boolean})],ht.prototype,"disabled",2);ft([g({type:Boolean})],ht.prototype,"bare",2);ft([g({type:Number})],ht.prototype,"tab",2);ft([H("sp-number")],ht.prototype,"field",2);ht=ft([k("sp-stepper")],ht);const fg={info:"info",warn:"warn",bad:"bad"};function mg(e,t,s){return l`<div class="remark ${s.tone}" role="gridcell">
    ${b(fg[s.tone])}
    <span class="cut" title=${s.text}>${s.text}</span>
    ${s.actions.map(n=>l`<button type="button" class="link" @click=${()=>gg(e,t,n)}>${n.text}</button>`)}
  </div>`}function gg(e,{part:t,mesh:s},n){const i=new Set([t.key]);switch(n.do){case"unit":e.edit(a=>Ts(a,i,{unit:n.unit}));break;case"scale":e.edit(a=>Ts(a,i,{scale:n.scale}));break;case"leave_out":e.editWithToast(`${ss(t,s)} is left out.`,a=>Xs(a,i));break;case"replace":vt(([a])=>a&&e.replaceFile(t.file,a.file),{several:!1});break;case"repairs":e.view.set({current:t.key});break}}function $g(e,t,s){return l`<sp-menu
    label=${`${e}: ${Qn(t)}`}
    buttonClasses="ori"
    .button=${l`${b(Jo(t))}<span>${Qn(t)}</span>${b("down")}`}
    .content=${()=>l`${un.map(n=>l`<button
            type="button"
            class="mi"
            role="menuitemradio"
            aria-checked=${n.value===t.kind}
            @click=${()=>s(Yo(n.value,t))}
          >
            ${b(n.icon)}<span>${n.text}</span>${n.value===t.kind?b("check"):""}
          </button>`)}`}
  ></sp-menu>`}function bg(e,t,s,n){const{part:i,mesh:a}=t,{current:r,chosen:o}=e.view.value,c=r===i.key,h=o.has(i.key),u=$c(t,e),p=ss(i,a),f=A=>n.row===s&&Ft[n.column]===A?0:-1,m=(A,N="")=>e.edit(ot=>Ts(ot,Ou(e.view.value,i.key),A),`${N} ${i.key}`),v=new yg(e,i,p,m),y=tt(t.index),M=t.remarks;return l`<div
    class="pr ${c?"sel":""} ${h?"chosen":""} ${M.length>0?"has":""}"
    role="row"
    aria-rowindex=${s+2}
    aria-selected=${h}
    data-row=${s}
    @pointerdown=${()=>e.view.set({current:i.key})}
  >
    <span role="gridcell" class="c-check" data-column="check" tabindex=${f("check")}>
      ${tn(`Choose ${p}`,h,(A,N)=>vg(e,i.key,A,N.shiftKey),-1)}
    </span>
    ${a?X(e.meshes.picture(a,y,$.value.theme)):l`<span class="th blank ${M.length>0?"":"reading"}"></span>`}
    <span role="gridcell" class="nm" data-column="name" tabindex=${f("name")}>
      <b class="cut" title=${p}>${p}</b>
      <span class="cut">${u?ut(u):a===null&&M.length>0?i.file:"is read …"}</span>
    </span>
    <span role="gridcell" class="num" data-column="count" tabindex=${f("count")}>${v.count(c)}</span>
    <span role="gridcell" class="num" data-column="scale" tabindex=${f("scale")}>${v.scale(c)}</span>
    <span role="gridcell" data-column="stands" tabindex=${f("stands")}>${v.stands(c)}</span>
    <span role="gridcell" class="num hide-s" data-column="gap" tabindex=${f("gap")}>${v.gap(c)}</span>
    <span role="gridcell" class="hide-s" data-column="priority" tabindex=${f("priority")}
      >${v.priority(c)}</span
    >
    <span role="gridcell" class="num" data-column="due" tabindex=${f("due")}>${v.due(c)}</span>
    ${M.map(A=>mg(e,t,A))}
  </div>`}function vg(e,t,s,n){const{chosen:i,current:a}=e.view.value,r=new Set(i),o=e.draft.parts.map(p=>p.key),c=n&&a!==null?o.indexOf(a):-1,h=o.indexOf(t),u=c<0?[t]:o.slice(Math.min(c,h),Math.max(c,h)+1);for(const p of u)s?r.add(p):r.delete(p);e.view.set({chosen:r})}class yg{constructor(t,s,n,i){this.session=t,this.part=s,this.name=n,this.change=i}count(t){return l`<sp-stepper
      label=${`copies of ${this.name}`}
      .value=${this.part.count}
      .tab=${-1}
      ?bare=${!t}
      @value=${s=>this.change({count:s.detail??1},"count")}
    ></sp-stepper>`}scale(t){return t?l`<sp-number
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
    ></sp-number>`:l`${K(this.part.scale,this.part.scale*100===Math.round(this.part.scale*100)?0:1)}`}stands(t){const{stands:s}=this.part;return t?$g(`${this.name} may stand`,s,n=>this.change({stands:n})):l`<span class="ori">${b(Jo(s))}${Qn(s)}</span>`}gap(t){const s=Vs(this.session.draft,this.session.info).toFixed(1),n=this.part.gap;return t?l`<sp-number
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
    ></sp-number>`:l`<span class=${n===null?"faint":""}>${n===null?s:n.toFixed(1)}</span>`}priority(t){const{priority:s}=this.part,n=eg(s);if(!t)return l`<span class=${s>0?"b":s===0?"faint":""}>${n}</span>`;const i=zs.some(a=>Number(a.value)===s)?[]:[{value:String(s),text:n}];return l`<select
      class="plain"
      tabindex="-1"
      aria-label=${`Priority of ${this.name}`}
      @change=${a=>this.change({priority:Number(a.target.value)})}
    >
      ${[...zs,...i].map(a=>l`<option value=${a.value} .selected=${Number(a.value)===s}>${a.text}</option>`)}
    </select>`}due(t){const s=this.part.due;return t?l`<label class="due ${s===null?"faint":""}">
      <span aria-hidden="true">${s===null?"None":ya(s,new Date)}</span>
      <input
        type="date"
        tabindex="-1"
        aria-label=${`Due date of ${this.name}`}
        .value=${s??""}
        @click=${wg}
        @change=${n=>this.change({due:n.target.value||null})}
      />
    </label>`:s===null?d:l`${ya(s,new Date)}`}}function wg(e){try{e.target.showPicker()}catch{}}function kg(e){const{active:t,total:s,done:n,sent:i,bytes:a}=e.uploads.state.value,{reading:r}=e.parts,{problem:o}=e.source.state.value;return t?l`<div class="loading" role="status">
      <div class="row between">
        <span><b>Sending</b> ${n} of ${P(s,"file")} · ${Ms(i)} of ${Ms(a)}</span>
        <button type="button" class="btn s" @click=${()=>e.uploads.stop()}>Stop</button>
      </div>
      ${rs(a>0?i/a:0,"Sent")}
    </div>`:r>0?l`<div class="loading" role="status"><b>Reading</b> ${P(r,"file")} …</div>`:o?l`<div class="loading bad-text" role="alert">${o}</div>`:d}var xg=Object.defineProperty,Mg=Object.getOwnPropertyDescriptor,dn=(e,t,s,n)=>{for(var i=n>1?void 0:n?Mg(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&xg(t,s,i),i};let Xe=class extends x{constructor(){super(...arguments),this.rows=[],this.top=0,this.height=900,this.wasFinding=!1,this.grid=new cg(this),this.sizes=new ResizeObserver(()=>{this.height=this.scroller.clientHeight,this.requestUpdate()})}stores(){const{session:e}=this;return[e.state,e.view,e.source.state,e.uploads.state,e.meshes.state,e.run.state,$]}get shown(){return this.rows}firstUpdated(){this.sizes.observe(this.scroller)}disconnectedCallback(){super.disconnectedCallback(),this.sizes.disconnect()}updated(e){const t=this.session.view.value.find!==null;t&&!this.wasFinding&&this.findInput?.focus(),this.wasFinding=t,this.grid.settle()}render(){const{session:e}=this,t=Fn(e),{find:s,chosen:n}=e.view.value;this.rows=mc(t,s);const i=Fo(this.rows.map(ia),this.top,this.height),a=this.rows.slice(i.first,i.last),r=this.rows.filter(c=>n.has(c.part.key)).length,o=r>0&&r===this.rows.length;return l`${this.head(t)}${kg(e)}${Km(e,t.length)}
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
              ${tn("Choose all",o?!0:r>0?"mixed":!1,c=>e.view.set({chosen:new Set(c?this.rows.map(h=>h.part.key):[])}))}
            </span>
            <span role="columnheader" class="c-name two">Part</span>
            <span role="columnheader" class="num">Copies</span>
            <span role="columnheader" class="num">Scale</span>
            <span role="columnheader">May stand</span>
            <span role="columnheader" class="num hide-s">Gap</span>
            <span role="columnheader" class="hide-s">Priority</span>
            <span role="columnheader" class="num">Due</span>
          </div>
          ${Gm(e)}
          <div role="presentation" ${B({height:`${i.before}px`})}></div>
          ${an(a,c=>c.part.key,(c,h)=>bg(e,c,i.first+h,this.grid.cell))}
          <div role="presentation" ${B({height:`${i.after}px`})}></div>
        </div>
        ${t.length===0?this.nothingYet():d}
        ${this.rows.length===0&&t.length>0?l`<p class="none dim">No part has “${s}” in its name.</p>`:d}
        ${ug(e)}
      </div>`}head(e){const{session:t}=this,{find:s,chosen:n}=t.view.value,i=`${S(Or(e))} · ${pi(gc(e,t))}`;return l`<div class="head">
      ${n.size>0?l`<h2>${n.size} chosen</h2>
              <span class="count grow cut">what you change in one changes in all</span>
              <button type="button" class="btn s" @click=${()=>this.leaveOut(n)}>Leave out</button>
              ${D("close","Choose none (Esc)",()=>t.view.set({chosen:new Set}),"s")}`:l`<h2 class="nw">${P(e.length,"part")}</h2>
              <span class="count grow cut">${e.length>0?i:""}</span>`}
      ${s===null?D("find","Find a part (/)",()=>t.view.set({find:""}),"s"):l`<span class="in s find">
              ${b("find")}
              <input
                type="search"
                aria-label="Find a part"
                placeholder="Part of the name"
                .value=${s}
                @input=${a=>t.view.set({find:a.target.value})}
                @keydown=${a=>{a.key==="Escape"&&t.view.set({find:null})}}
              />
            </span>`}
      <button type="button" class="btn s" @click=${()=>vt(a=>t.addFiles(a))}>
        ${b("add")}Add parts
      </button>
    </div>`}nothingYet(){const{session:e}=this;return e.parts.reading>0||e.uploads.state.value.active?d:l`<div class="none">
      <h2>No parts yet</h2>
      <p class="dim">Drop files or a folder here, or choose them.</p>
      <div class="row">
        <button type="button" class="btn" @click=${()=>vt(t=>e.addFiles(t))}>
          ${b("file")}Choose files
        </button>
        <button
          type="button"
          class="btn"
          @click=${()=>vt(t=>e.addFiles(t),{folder:!0})}
        >
          ${b("folder")}Choose a folder
        </button>
      </div>
    </div>`}leaveOut(e){const t=e.size===1?"1 part is left out.":`${e.size} parts are left out.`;this.session.editWithToast(t,s=>Xs(s,e))}scrolled(){this.top=this.scroller.scrollTop,this.requestUpdate()}reveal(e){const t=this.rows.map(ia),s=t.slice(0,e).reduce((r,o)=>r+o,0),n=32,{scrollTop:i,clientHeight:a}=this.scroller;s<i?this.scroller.scrollTop=s:s+(t[e]??0)>i+a-n&&(this.scroller.scrollTop=s+(t[e]??0)-a+n),this.top=this.scroller.scrollTop,this.requestUpdate()}};dn([g({attribute:!1})],Xe.prototype,"session",2);dn([H(".scroll")],Xe.prototype,"scroller",2);dn([H(".find input")],Xe.prototype,"findInput",2);Xe=dn([k("sp-parts-list")],Xe);const _g=new Set(["tray","printer","trays","gap","wall-gap","open-height","minimise","time-limit","material","unit"]),Og=new Set(["dry-run","json","progress","details","require-all","skip-unusable","job-name"]);function Pg(e){return e.filter(t=>t.here&&!_g.has(t.name)&&!Og.has(t.name))}function Xo(e){switch(e.type){case"flag":return"switch";case"word":case"rotations":return"choice";case"integer":case"natural":case"number":return"number";default:return"text"}}function Sg(e){return e.type==="flag"&&e.default.startsWith("on")}function Qo(e){return[...e.none_word&&!e.words.includes(e.none_word)?[e.none_word]:[],...e.words]}function Tg(e){const t=e.default.split(/[:\s]/)[0]??"";return Qo(e).find(s=>s===t)??null}function Ag(e,t){const s=t.trim();if(s==="")return{value:void 0};if(s===e.none_word||s===e.zero_word)return{value:s};if(Xo(e)!=="number"&&e.type!=="bytes")return{value:s};const n=e.type==="bytes"?Cg(s):gt(s);if(n===null)return{problem:`Takes ${e.values}.`};const i=e.type==="integer"||e.type==="natural"||e.type==="bytes",a=e.least!==void 0&&(e.above?n<=e.least:n<e.least),r=e.most!==void 0&&n>e.most;return a||r||i&&!Number.isInteger(n)?{problem:`Takes ${e.values}.`}:{value:n}}function Cg(e){const t=/^(.*?)([kmgt]?)(i?)b?$/i.exec(e),s=gt(t?.[1]??"");if(s===null||!t)return null;const n="kmgt".indexOf((t[2]??"").toLowerCase())+1;return Math.round(s*(t[3]?1024:1e3)**(t[2]?n:0))}function Za(e){return e==null?"":String(e)}function re(e){const t=e.replaceAll("-"," ");return t.charAt(0).toUpperCase()+t.slice(1)}function Xa(e){return e.help?`${st(e.line)} ${ii(e.help)}`:st(e.line)}function Qa(e){return ii(e.default)}const jg={parts:"Parts",tray:"Tray",gap:"Gap",packing:"Packing",result:"Result"};function Eg(e){return jg[e.toLowerCase()]??re(e)}var Lg=Object.defineProperty,Ng=Object.getOwnPropertyDescriptor,pn=(e,t,s,n)=>{for(var i=n>1?void 0:n?Ng(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Lg(t,s,i),i};const Nn="";let Qe=class extends x{constructor(){super(...arguments),this.find="",this.problems=new Map}stores(){return[this.session.state,this.session.view]}render(){const{session:e}=this,t=Pg(e.info.options).filter(i=>i.name!=="material-density");if(t.length===0)return d;const{advanced:s}=e.view.value,n=t.filter(i=>this.isSet(i)).length;return l`<section class="sec advanced">
      <button
        type="button"
        class="row fold"
        aria-expanded=${s}
        @click=${()=>e.view.set({advanced:!s})}
      >
        ${b(s?"down":"right")}<span class="b grow">Advanced</span>
        <span class="count">${n===0?"all at their defaults":`${P(n,"option")} set`}</span>
      </button>
      ${s?this.all(t,n):d}
    </section>`}isSet(e){return fa(this.session.draft,e.name)!==void 0&&!(e.name==="height-at"&&this.session.draft.goal==="lowest")}all(e,t){const s=this.find.trim().toLowerCase(),n=e.filter(a=>`${re(a.name)} ${Xa(a)}`.toLowerCase().includes(s)),i=[...new Set(n.map(a=>a.group))];return l`<div class="row">
        <span class="in s find grow">
          ${b("find")}
          <input
            type="search"
            aria-label="Find an option"
            placeholder="Find an option"
            .value=${this.find}
            @input=${a=>{this.find=a.target.value}}
          />
        </span>
        ${t>0?l`<button type="button" class="link small" @click=${()=>this.reset(e)}>All to defaults</button>`:d}
      </div>
      ${i.map(a=>l`<h4>${Eg(a)}</h4>
            ${n.filter(r=>r.group===a).map(r=>this.option(r))}`)}
      ${n.length===0?l`<p class="small dim">No option says “${this.find}”.</p>`:d}`}reset(e){this.problems.clear(),this.session.editWithToast("Options are at their defaults.",t=>e.filter(s=>this.isSet(s)).reduce((s,n)=>Vt(s,n.name,void 0),t))}set(e,t){this.session.edit(s=>Vt(s,e.name,t),`option ${e.name}`)}option(e){const t=fa(this.session.draft,e.name),s=this.problems.get(e.name);return l`<div class="field option ${this.isSet(e)?"set":""}">
      <span class=${this.isSet(e)?"b":"dim"}>${re(e.name)}</span>
      ${this.control(e,t)} ${s?l`<span class="range" role="alert">${s}</span>`:d}
      <span class="hint">${Xa(e)}</span>
    </div>`}control(e,t){switch(Xo(e)){case"switch":{const s=Sg(e),n=typeof t=="boolean"?t:s;return Qs(re(e.name),n,i=>this.set(e,i===s?void 0:i))}case"choice":return this.choice(e,t);default:return this.typed(e,t)}}choice(e,t){const s=Za(t),n=Qo(e),i=s!==""&&!n.includes(s)?[s]:[],a=Tg(e);return Kt(re(e.name),[{value:Nn,text:a?`${a} (default)`:e.default?`${Qa(e)}`:"default"},...[...n,...i].filter(r=>r!==a).map(r=>({value:r,text:r}))],s===a?Nn:s,r=>this.set(e,r===Nn?void 0:r),"n wider")}typed(e,t){const s=[e.none_word,e.zero_word].filter(i=>i!==""),n=`words-${e.name}`;return l`<span class="in n wider ${this.problems.has(e.name)?"wrong":""}"
      ><input
        type="text"
        autocomplete="off"
        spellcheck="false"
        list=${s.length>0?n:d}
        aria-label=${re(e.name)}
        placeholder=${Qa(e)||"none"}
        .value=${Za(t)}
        @change=${i=>this.read(e,i.target)} />${s.length>0?l`<datalist id=${n}>${s.map(i=>l`<option value=${i}></option>`)}</datalist>`:d}</span
    >`}read(e,t){const s=Ag(e,t.value);"problem"in s?this.problems.set(e.name,s.problem):(this.problems.delete(e.name),this.set(e,s.value)),this.requestUpdate()}};pn([g({attribute:!1})],Qe.prototype,"session",2);pn([O()],Qe.prototype,"find",2);pn([O()],Qe.prototype,"problems",2);Qe=pn([k("sp-advanced")],Qe);function Dg(e){const{draft:t}=e,s=ns(t);return l`<div class="field">
      <span class="dim">Keep-out zones</span>
      <button
        type="button"
        class="link"
        ?disabled=${s}
        title=${s?"Not without a ceiling, nor for the least box":"Room that stays empty"}
        @click=${()=>e.edit(n=>Jh(n,Fg(e)))}
      >
        Add
      </button>
    </div>
    ${t.keepOut.map((n,i)=>Ig(e,n,i))}`}function Fg(e){const[t,s,n]=jt(e.draft,e.info,e.parts.meshes)??[100,100,100];return{box:[[0,0,0],[Math.round(t/10),Math.round(s/10),n]]}}function Ig(e,t,s){const n=()=>e.editWithToast("The keep-out zone is removed.",i=>({...i,keepOut:i.keepOut.filter((a,r)=>r!==s)}));return l`<div class="zone">
    <div class="row between">
      <span class="small dim">${"mesh"in t?t.mesh:`Zone ${s+1}: from, to (mm)`}</span>
      ${D("close",`Remove keep-out zone ${s+1}`,n,"s")}
    </div>
    ${"box"in t?l`${tr(e,t.box,s,0)}${tr(e,t.box,s,1)}`:d}
  </div>`}function tr(e,t,s,n){const i=(a,r)=>e.edit(o=>{const c=[...t[n]];c[a]=r??0;const h=n===0?[c,t[1]]:[t[0],c];return{...o,keepOut:o.keepOut.map((u,p)=>p===s?{box:h}:u)}},`zone ${s} ${n} ${a}`);return l`<div class="thirds" role="group" aria-label=${n===0?"From":"To"}>
    ${["X","Y","Z"].map((a,r)=>l`<sp-number
          label=${`${n===0?"From":"To"} ${a}, mm`}
          classes="s third"
          .value=${t[n][r]??0}
          @value=${o=>i(r,o.detail)}
        ></sp-number>`)}
  </div>`}function zg(e){const{draft:t}=e;return l`${te("Tray",[{value:"printer",text:"Printer",disabled:e.info.printers.length===0},{value:"box",text:"Box"},{value:"mesh",text:"Mesh"}],t.tray.kind,s=>e.edit(n=>{const i=zn(n,Rg(e,s));return n.tray.kind!=="printer"||s==="printer"?i:{...i,gap:Vs(n,e.info),wallGap:fi(n,e.info)}}))}
  ${t.tray.kind==="printer"?Bg(e):t.tray.kind==="box"?Hg(e,t.tray.size):Vg(e)}
  ${t.tray.kind==="mesh"?d:qg(e)} ${Wg(e)}`}function Rg(e,t){const{draft:s,info:n,parts:i}=e;return s.tray.kind===t?s.tray:t==="printer"?Zr(n)??s.tray:t==="box"?{kind:t,size:Ug(jt(s,n,i.meshes)??Sr)}:{kind:t,file:null,is:null,unit:null,transform:null}}function Ug(e){const t=s=>Math.ceil(s*10-1e-6)/10;return[t(e[0]),t(e[1]),t(e[2])]}function Bg(e){const{draft:t,info:s}=e,n=t.tray.kind==="printer"?t.tray.name:"",i=jt(t,s,[]),a=s.printers.some(r=>r.name===n);return l`${Kt("Printer",[...s.printers.map(r=>({value:r.name,text:r.title.charAt(0).toUpperCase()+r.title.slice(1)})),...a?[]:[{value:n,text:`${n}: not known here`}]],n,r=>{it("printer",r),e.edit(o=>({...o,tray:{kind:"printer",name:r},gap:null,wallGap:null}))},"wide")}
    <div class="field"><span class="dim">Size</span><span>${i?ut(i):"unknown"}</span></div>`}function Hg(e,t){const s=(n,i)=>l`<sp-number
      label=${`${i}, mm`}
      classes="third"
      .value=${t[n]}
      .least=${0}
      above
      .most=${1e5}
      ?disabled=${n===2&&e.draft.openHeight}
      @value=${a=>{const r=[...t];r[n]=a.detail??t[n],e.edit(o=>({...o,tray:{kind:"box",size:r}}),`box ${n}`)}}
    ></sp-number>`;return l`<div class="thirds" role="group" aria-label="Size of the box, mm">
    ${s(0,"Length")}<span class="faint">×</span>${s(1,"Width")}<span class="faint">×</span>${s(2,"Height")}
    <span class="faint">mm</span>
  </div>`}function qg(e){const{draft:t}=e,s=t.keepOut.length===0;return l`<div class="field">
    <span class="dim">No ceiling</span>
    ${Qs("No ceiling: as low as can be on the base",t.openHeight,n=>e.edit(i=>({...i,openHeight:n})),!s)}
    ${t.openHeight?l`<span class="hint">As low as can be on the base, however high that is.</span>`:s?d:l`<span class="hint">Not with keep-out zones.</span>`}
  </div>`}function Wg(e){const{draft:t}=e;if(ns(t))return l`<div class="field">
      <span class="dim">Trays</span><span>1</span>
      <span class="hint">${t.openHeight?"Without a ceiling one tray holds all.":"The least box holds all."}</span>
    </div>`;const s=t.trays,n=s==="all";return l`<div class="field">
    <span class="dim">Trays</span>
    <span class="row">
      ${n?d:l`<sp-stepper
              label="trays"
              .value=${s}
              .most=${1e3}
              @value=${i=>e.edit(a=>({...a,trays:i.detail??1}),"trays")}
            ></sp-stepper>`}
      <button
        type="button"
        class="btn s ${n?"on":""}"
        aria-pressed=${n}
        title="As many trays as it takes"
        @click=${()=>e.edit(i=>({...i,trays:n?1:"all"}))}
      >
        As many as needed
      </button>
    </span>
  </div>`}function Vg(e){const{draft:t,parts:s}=e,n=t.tray;if(n.kind!=="mesh")return l``;const i=[...new Set(s.meshes.map(o=>o.file))],a=jt(t,e.info,s.meshes),r=o=>e.edit(c=>{const h=new Set(c.parts.filter(u=>u.file===o).map(u=>u.key));return zn(Xs(c,h),{...n,file:o})});return l`${i.length>0?Kt("Mesh to fill",[...n.file!==null&&!i.includes(n.file)?[{value:n.file,text:`${n.file}: not there`}]:[],...i.map(o=>({value:o,text:o}))],n.file,r,"wide"):l`<p class="faint small">A closed mesh that is filled instead of a box.</p>`}
    <button
      type="button"
      class="btn s"
      @click=${()=>vt(([o])=>{o&&(e.addFiles([o]),r(o.file.name))},{several:!1,accept:".stl,.3mf,.obj,.ply,.off"})}
    >
      Choose a file
    </button>
    <div class="field"><span class="dim">Size</span><span>${a?ut(a):"–"}</span></div>
    <div class="field">
      <span class="dim">Filled is</span>
      ${Kt("What of the mesh is filled",[{value:"auto",text:"by its shape"},{value:"solid",text:"its own volume"},{value:"vessel",text:"what it holds"}],n.is??"auto",o=>e.edit(c=>zn(c,{...n,is:o==="auto"?null:o})),"n wider")}
    </div>
    <label class="row">
      ${tn("Its walls are really there",t.physical,o=>e.edit(c=>({...c,physical:o})))}
      <span>Its walls are really there</span>
    </label>
    ${t.physical?l`<p class="faint small">Copies leave over the top, which is open.</p>`:d}`}var Kg=Object.defineProperty,Gg=Object.getOwnPropertyDescriptor,tl=(e,t,s,n)=>{for(var i=n>1?void 0:n?Gg(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Kg(t,s,i),i};const Jg={lowest:"Places every copy as low as it goes, so the print is short.",fill:"Fills each tray as densely as it goes before the next; the last is packed low.",box:"Seeks the smallest box that holds all copies, on a base up to the tray’s."};let ei=class extends x{stores(){return[this.session.state,this.session.source.state,$]}render(){const{session:e}=this;return l`<div class="head"><h2 class="grow">Build settings</h2></div>
      <div class="scroll">
        <section class="sec stack">
          <h3>Tray</h3>
          ${zg(e)} ${Dg(e)}
        </section>
        ${this.gaps()}${this.goal()}${this.time()}${this.material()}
        <sp-advanced .session=${e}></sp-advanced>
      </div>`}edit(e,t=""){this.session.edit(s=>({...s,...e}),t)}gaps(){const{draft:e,info:t}=this.session,s=Ws(e,t),n=(i,a,r)=>i!==null&&a!==void 0&&i!==a?l`<span class="hint"
            >The printer’s usual is ${qt(a)}.
            <button type="button" class="link" @click=${()=>this.edit(r)}>Use it</button></span
          >`:d;return l`<section class="sec stack">
      <h3>Gap</h3>
      <div class="field">
        <span class="dim">Between copies</span>
        <sp-number
          label="Gap between copies"
          unit="mm"
          .value=${Vs(e,t)}
          .least=${0}
          .step=${.5}
          .places=${1}
          @value=${i=>this.edit({gap:i.detail},"gap")}
        ></sp-number>
        ${n(e.gap,s?.gap,{gap:null})}
      </div>
      <div class="field">
        <span class="dim">To the walls</span>
        <sp-number
          label="Gap to the walls"
          unit="mm"
          .value=${fi(e,t)}
          .least=${0}
          .step=${.5}
          .places=${1}
          @value=${i=>this.edit({wallGap:i.detail},"wall gap")}
        ></sp-number>
        ${n(e.wallGap,s?.wall_gap,{wallGap:null})}
      </div>
    </section>`}goal(){const{draft:e}=this.session,t=Tr(e);return l`<section class="sec stack">
      <h3>Goal</h3>
      ${te("Goal",[{value:"lowest",text:"Lowest"},{value:"fill",text:"Fill tray"},{value:"box",text:"Least box",disabled:!t,...t?{}:{title:"Not with a mesh to fill, nor with keep-out zones"}}],e.goal,s=>this.edit({goal:s}))}
      <p class="faint small">${Jg[e.goal]}</p>
    </section>`}time(){const{draft:e,info:t}=this.session,s=t.limits.time_limit,n=e.options.improve==="rest";return l`<section class="sec stack">
      <div class="field">
        <span class="b">Time limit</span>
        <sp-number
          label="Time limit, minutes"
          unit="min"
          optional
          placeholder="none"
          .value=${e.timeLimit===null?null:e.timeLimit/60}
          .least=${0}
          above
          .most=${s===null?Number.POSITIVE_INFINITY:s/60}
          @value=${i=>this.edit({timeLimit:i.detail===null?null:i.detail*60},"time limit")}
        ></sp-number>
      </div>
      ${e.timeLimit===null?l`<p class="faint small">Packs until it is done. With a limit, the best packing by then is kept.</p>`:l`<label class="row">
                ${tn("Use all of the time to pack better",n,i=>this.session.edit(a=>Vt(a,"improve",i?"rest":void 0)))}
                <span>Use all of it to pack better</span>
              </label>
              <p class="faint small">The best packing so far is kept.</p>`}
    </section>`}material(){const{draft:e,info:t}=this.session,s=e.options["material-density"],n=t.options.some(i=>i.name==="material-density"&&i.here);return l`<section class="sec stack">
      <h3>Material</h3>
      <label class="field">
        <span class="dim">Name</span>
        <span class="in n wider"
          ><input
            type="text"
            maxlength="100"
            aria-label="Material"
            placeholder="PA 12"
            .value=${e.material}
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
                @value=${i=>this.session.edit(a=>Vt(a,"material-density",i.detail??void 0),"density")}
              ></sp-number>
              <span class="hint">The report then has masses.</span>
            </div>`:d}
    </section>`}};tl([g({attribute:!1})],ei.prototype,"session",2);ei=tl([k("sp-settings")],ei);var Yg=Object.defineProperty,Zg=Object.getOwnPropertyDescriptor,fn=(e,t,s,n)=>{for(var i=n>1?void 0:n?Zg(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&Yg(t,s,i),i};let ts=class extends x{constructor(){super(...arguments),this.over=0,this.drawer="left",this.release=null,this.keys=[{keys:["Ctrl+Enter"],does:"pack",run:()=>this.pack()},{keys:["Ctrl+Z"],does:"undo",run:()=>this.session.undo()},{keys:["Ctrl+Shift+Z","Ctrl+Y"],does:"redo",run:()=>this.session.redo()},{keys:["/"],does:"find a part",run:()=>this.session.view.set({find:this.session.view.value.find??""})},{keys:["Del"],does:"leave out the chosen parts",run:()=>this.leaveOut()},{keys:["Esc"],does:"let go",run:()=>this.session.view.set({chosen:new Set,find:null})}],this.dragOver=e=>{const t=Vo(e);t===0||this.session.locked||(e.preventDefault(),this.over=t)},this.dragLeave=e=>{e.relatedTarget===null&&(this.over=0)},this.drop=e=>{e.preventDefault(),this.over=0,!this.session.locked&&Ko(e).then(t=>this.session.addFiles(t))}}stores(){return[this.session.run.state]}connectedCallback(){super.connectedCallback(),this.release=Ue(this.keys),this.session.locked||this.session.saver.look(),addEventListener("dragover",this.dragOver),addEventListener("dragleave",this.dragLeave),addEventListener("drop",this.drop)}disconnectedCallback(){super.disconnectedCallback(),this.release?.(),removeEventListener("dragover",this.dragOver),removeEventListener("dragleave",this.dragLeave),removeEventListener("drop",this.drop)}render(){const{session:e}=this,t=e.locked;return l`${t?this.lockedBanner():d}
      <main class="main parts" data-drawer=${this.drawer??d}>
        <h1 class="out">${e.job.name}: parts</h1>
        <aside class="side left" aria-label="Parts" ?inert=${t}>
          <sp-parts-list .session=${e}></sp-parts-list>
        </aside>
        <sp-divider property="--parts" side="left" label="Width of the list" least="480"></sp-divider>
        <sp-part-preview .session=${e} ?inert=${t}></sp-part-preview>
        <sp-divider property="--right" side="right" label="Width of the settings" least="264" most="480"></sp-divider>
        <aside class="side right" aria-label="Settings" ?inert=${t}>
          <sp-settings .session=${e}></sp-settings>
        </aside>
        <div class="drawers">
          ${this.drawerButton("left","Parts")}${this.drawerButton("right","Settings")}
        </div>
        ${this.over>0?l`<div class="over-all"><h2>Drop to add ${P(this.over,"file")}</h2></div>`:d}
      </main>
      <sp-dock .session=${e}></sp-dock>`}pack(){const e=this.querySelector("sp-menu.pack-again");e?e.show():this.session.pack()}lockedBanner(){return this.session.run.checking?l`<div class="banner info" role="status">
        ${b("clock")}
        <span class="grow"><b>The build is being checked.</b> Parts and settings can be changed once that is done.</span>
      </div>`:l`<div class="banner info" role="status">
      ${b("clock")}
      <span class="grow"><b>This job is being packed.</b> Parts and settings can be changed once it is done or stopped.</span>
      <a class="btn s" href=${`#/job/${this.session.id}/build`}>Watch it</a>
      <button type="button" class="btn s" @click=${()=>this.session.stop()}>Stop it</button>
    </div>`}drawerButton(e,t){return l`<button
      type="button"
      class="btn"
      aria-pressed=${this.drawer===e}
      @click=${()=>{this.drawer=this.drawer===e?null:e}}
    >
      ${b(e==="left"?"list":"settings")}${t}
    </button>`}leaveOut(){const{chosen:e,current:t}=this.session.view.value,s=e.size>0?e:new Set(t===null?[]:[t]);if(s.size===0)return;const n=s.size===1?"1 part is left out.":`${s.size} parts are left out.`;this.session.editWithToast(n,i=>Xs(i,s))}};fn([g({attribute:!1})],ts.prototype,"session",2);fn([O()],ts.prototype,"over",2);fn([O()],ts.prototype,"drawer",2);ts=fn([k("sp-parts")],ts);function el(e){return e==="localhost"||e==="[::1]"||/^127\./.test(e)}function Xg(e){return el(e)?"Files stay on this computer.":`Files go to ${e}, and nowhere else.`}const Qg=e=>el(e)?"on this computer":`on ${e}`,t$="250,392 20,300 142,228 354,298",e$="258,96 0,40 138,-2 374,38",s$=l`<svg class="empty-tray" viewBox="-8 -14 392 418" aria-hidden="true">
  <polygon class="floor" points=${t$} />
  <path class="far" d="M142 228L138 -2" />
  <path d="M250 392L258 96M20 300L0 40M354 298L374 38" />
  <path d="M20 300L250 392L354 298" />
  <path class="far" d="M20 300L142 228L354 298" />
  <polygon points=${e$} />
</svg>`;var n$=Object.defineProperty,i$=Object.getOwnPropertyDescriptor,mn=(e,t,s,n)=>{for(var i=n>1?void 0:n?i$(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&n$(t,s,i),i};let es=class extends x{constructor(){super(...arguments),this.second=!1,this.over=0,this.busy=!1,this.dragOver=e=>{const t=Vo(e);t!==0&&(e.preventDefault(),this.over=t)},this.dragLeave=e=>{e.relatedTarget===null&&(this.over=0)},this.drop=e=>{e.preventDefault(),this.over=0,Ko(e).then(t=>this.take(t))}}stores(){return[$]}connectedCallback(){super.connectedCallback(),addEventListener("dragover",this.dragOver),addEventListener("dragleave",this.dragLeave),addEventListener("drop",this.drop)}disconnectedCallback(){super.disconnectedCallback(),removeEventListener("dragover",this.dragOver),removeEventListener("dragleave",this.dragLeave),removeEventListener("drop",this.drop)}render(){const e=$.value.info?.samples??!1;return l`<div class="drop ${this.over>0?"over":""}">
      ${s$}
      <h2>${this.over>0?this.dropText():"Drop files or a folder here"}</h2>
      <p class="dim">STL, 3MF, OBJ, PLY, OFF, or a job or set file with its meshes</p>
      <div class="row wrap">
        <button
          type="button"
          class="btn l ${this.second?"":"primary"}"
          ?disabled=${this.busy}
          @click=${()=>vt(t=>this.take(t))}
        >
          ${this.busy?z:b("file")}Choose files
        </button>
        <button
          type="button"
          class="btn l"
          ?disabled=${this.busy}
          @click=${()=>vt(t=>this.take(t),{folder:!0})}
        >
          ${b("folder")}Choose a folder
        </button>
        ${e?l`<button
                type="button"
                class="btn l ghost accent"
                ?disabled=${this.busy}
                @click=${()=>this.begin(Md())}
              >
                Try the sample
              </button>`:d}
      </div>
    </div>`}dropText(){return this.over===1?"Drop to begin":`Drop to add ${P(this.over,"file")}`}take(e){e.length>0&&this.begin(xd(e))}async begin(e){this.busy=!0,await e,this.busy=!1}};mn([g({type:Boolean})],es.prototype,"second",2);mn([O()],es.prototype,"over",2);mn([O()],es.prototype,"busy",2);es=mn([k("sp-drop")],es);function a$(e){const t=de(e),s=e.has_packing?"Nothing is lost: the best packing so far is saved.":"Nothing was placed by then. It goes on from where it was.";return l`<article class="card interrupted" aria-label="Interrupted job">
    <span class="pic">${X(e.has_picture?lr(e.id):null,"shot")}</span>
    <div>
      <div class="row between">
        <h2 class="cut">“${e.name}” was interrupted</h2>
        ${Be("warn",ld(e))}
      </div>
      <p class="dim">The computer or the program stopped while it was packing. ${s}</p>
      ${e.has_packing?l`<p>
              ${io(e)}${t?.tone==="ok"?l` · <span class="ok-text">comes apart: checked</span>`:d}
            </p>`:d}
      <div class="row">
        <button type="button" class="btn primary" @click=${()=>r$(e)}>Continue packing</button>
        ${e.has_packing?l`<a class="btn" href=${`#/job/${e.id}/build`}>Open what is there</a>`:l`<a class="btn" href=${`#/job/${e.id}/parts`}>Open the parts</a>`}
        <button type="button" class="btn ghost" @click=${()=>kd(e)}>Dismiss</button>
      </div>
    </div>
  </article>`}async function r$(e){await nt(()=>T.start(e.id))&&rt({page:"job",id:e.id,step:"build"})}function o$(e,t){const s=js(e),n=e.has_packing||E(e)||e.status==="failed"?"build":"parts",i=E(e)?"now":id(new Date(e.changed),t);return l`<li class="job">
    <a class="whole" href=${ws({page:"job",id:e.id,step:n})} aria-label=${`Open ${e.name}`}></a>
    <span class="pic">${X(e.has_picture?lr(e.id):null,"shot")}</span>
    <div class="cut">
      <div class="b cut">${e.name}</div>
      <div class="dim small cut">${od(e)}</div>
      <div class="faint small cut">${io(e)}</div>
    </div>
    <div class="num">
      ${Be(s.tone,s.text)}
      <div class="faint small when">${i}</div>
      <div class="acts">
        <a class="btn s ghost accent" href=${ws({page:"job",id:e.id,step:n})} aria-label=${`Open ${e.name}`}>
          Open
        </a>
        ${D("copy",`Copy ${e.name}`,()=>lo(e.id,e.name),"s")}
        ${D("trash",`Delete ${e.name}`,()=>ro(e),"s")}
      </div>
    </div>
  </li>`}var l$=Object.defineProperty,c$=Object.getOwnPropertyDescriptor,sl=(e,t,s,n)=>{for(var i=n>1?void 0:n?c$(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&l$(t,s,i),i};let si=class extends x{stores(){return[J]}render(){const{jobs:e,total:t,bytes:s,find:n,all:i,going:a}=J.value,r=(e??[]).filter(o=>!a.has(o.id));return l`<section class="recent" aria-labelledby="recent-jobs">
      <div class="row between">
        <h2 id="recent-jobs">Recent jobs</h2>
        ${n===null?this.findButton(t):this.findField(n)}
      </div>
      <p class="dim lead">
        ${e===null?"Looking for jobs …":t===0?"No jobs yet.":this.summary(t,s)}
      </p>
      ${r.length>0?this.list(r):this.none(n,t)}
      <div class="row between foot">
        ${n===null&&t>r.length&&!i?l`<button type="button" class="link small" @click=${()=>ka(!0)}>
                Show all ${P(t,"job")}
              </button>`:n===null&&i?l`<button type="button" class="link small" @click=${()=>ka(!1)}>Show the newest</button>`:l`<span></span>`}
        ${t>0?l`<span class="faint small">Jobs go on when this page is closed.</span>`:d}
      </div>
    </section>`}summary(e,t){return`${P(e,"job")} ${Qg(location.hostname)}, ${Ms(t)}.`}list(e){const t=new Date;return l`<ul class="card jobs" role="list">
      ${an(e,s=>s.id,s=>o$(s,t))}
    </ul>`}none(e,t){return e!==null&&e!==""&&J.value.jobs?l`<p class="none dim">No job has “${e}” in its name.</p>`:t>0||J.value.jobs===null?d:l`<p class="none dim">What you pack is kept here, with its parts and settings, until you delete it.</p>`}findButton(e){return e<2?d:l`<button
      type="button"
      class="btn s ghost"
      @click=${()=>{ms(""),this.updateComplete.then(()=>this.input?.focus())}}
    >
      ${b("find")}Find
    </button>`}findField(e){return l`<span class="in s find">
      ${b("find")}
      <input
        type="search"
        aria-label="Find a job by its name"
        placeholder="Part of the name"
        .value=${e}
        @input=${t=>ms(t.target.value)}
        @keydown=${t=>{t.key==="Escape"&&ms(null)}}
        @blur=${()=>{e===""&&ms(null)}}
      />
    </span>`}};sl([H("input")],si.prototype,"input",2);si=sl([k("sp-recent")],si);var h$=Object.getOwnPropertyDescriptor,u$=(e,t,s,n)=>{for(var i=n>1?void 0:n?h$(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=r(i)||i);return i};let er=class extends x{constructor(){super(...arguments),this.stop=null}stores(){return[$,J]}connectedCallback(){super.connectedCallback(),this.stop=yd()}disconnectedCallback(){super.disconnectedCallback(),this.stop?.()}render(){const e=wd(J.value)[0];return l`<main class="start">
      <section class="begin" aria-labelledby="new-build">
        <h1 id="new-build">New build</h1>
        <p class="dim lead">Bring the parts, choose the printer, press Pack. ${Xg(location.hostname)}</p>
        ${e?a$(e):d}
        <sp-drop ?second=${e!==void 0}></sp-drop>
      </section>
      <sp-recent></sp-recent>
    </main>`}};er=u$([k("sp-start")],er);var d$=Object.defineProperty,p$=Object.getOwnPropertyDescriptor,nl=(e,t,s,n)=>{for(var i=n>1?void 0:n?p$(t,s):t,a=e.length-1,r;a>=0;a--)(r=e[a])&&(i=(n?r(t,s,i):r(i))||i);return n&&i&&d$(t,s,i),i};const f$=3e3;let ni=class extends x{constructor(){super(...arguments),this.ready=!1,this.route=null,this.retry=0,this.learning=!1}stores(){const e=V.value.session;return e?[$,V,e.run.state]:[$,V]}connectedCallback(){super.connectedCallback(),Vu()}updated(e){if(!this.ready)return;if($.value.tokenWanted){this.route=null;return}$.value.info||this.learn(),this.route!==$.value.route&&this.follow($.value.route),$.value.connected||this.askSoon();const t=V.value.session;document.title=t&&$.value.route.page==="job"?`${t.job.name} · spectralpack`:"spectralpack"}async learn(){if(!this.learning){this.learning=!0;try{$.set({info:await T.info()})}catch{}finally{this.learning=!1}}}follow(e){const t=this.route;this.route=e,e.page==="start"?so():(t?.page!=="job"||t.id!==e.id||!V.value.session)&&Bn(e.id)}askSoon(){clearTimeout(this.retry),this.retry=window.setTimeout(async()=>{try{$.set({info:await T.info()}),await V.value.session?.run.refresh(),!V.value.session&&this.route?.page==="job"&&Bn(this.route.id)}catch{this.askSoon()}},f$)}render(){const{tokenWanted:e,dialog:t}=$.value;return this.ready?e?l`<sp-token></sp-token>`:l`<div class="app">
        <sp-top-bar></sp-top-bar>
        <div class="page">${this.banners()}${this.page()}</div>
      </div>
      <sp-toast></sp-toast>
      <div class="out" role="status" aria-live="polite">${$.value.announcement}</div>
      ${t==="help"?l`<sp-help></sp-help>`:d}`:d}banners(){const{connected:e,problem:t}=$.value;return l`${e?d:l`<div class="banner warn" role="alert">
            ${b("warn")}
            <span class="grow"><b>No answer from the server.</b> Jobs that run go on; the page asks again by itself.</span>
          </div>`}${t&&e?l`<div class="banner bad" role="alert">
            ${b("bad")}<span class="grow">${t}</span>
            <button type="button" class="btn s" @click=${()=>ce(null)}>Close</button>
          </div>`:d}`}page(){const{route:e}=$.value;if(e.page==="start")return l`<sp-start></sp-start>`;const{session:t,problem:s}=V.value;return t&&t.id===e.id?this.jobPage(t,e.step):s===null?l`<main class="empty" aria-busy="true"></main>`:l`<main class="empty">
      <h2>This job cannot be opened</h2>
      <p class="dim">${s}</p>
      <button type="button" class="btn" @click=${()=>rt({page:"start"})}>All jobs</button>
    </main>`}jobPage(e,t){const s=E(e.job)||e.job.status!=="new"||e.job.has_packing,n={parts:l`<sp-parts .session=${e}></sp-parts>`,build:l`<sp-build .session=${e}></sp-build>`,apart:l`<sp-apart .session=${e}></sp-apart>`};return l`${Zl(e,n[s?t:"parts"])}`}};nl([g({type:Boolean})],ni.prototype,"ready",2);ni=nl([k("sp-app")],ni);const sr=$l(location,history);ml({reached:e=>$.set({connected:e}),tokenWanted:()=>$.set({tokenWanted:!0})});wl();async function m$(){if(sr!==null)try{await cr(sr),$.set({tokenWanted:!1})}catch(t){$.value.tokenWanted||ce(Bt(t))}const e=()=>$.set({route:vl(location.hash)});addEventListener("hashchange",e),e(),document.querySelector("sp-app")?.setAttribute("ready","")}m$();export{Te as a,M$ as b,w$ as c,x$ as d,k$ as e,cp as f,y$ as g,tt as p,_a as r};
