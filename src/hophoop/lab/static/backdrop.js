/* Built from web/site/backdrop.ts by esbuild 0.28.2; sources ffed6a535371fa98a0ae1f5c8a376399 */
function C(r,i,[e,n,o,s]){let[a,d,y,g]=[n[0]-o[0],n[1]-o[1],s[0]-o[0],s[1]-o[1]],[w,x]=[e[0]-n[0]+o[0]-s[0],e[1]-n[1]+o[1]-s[1]],j=a*g-y*d,l=(w*g-y*x)/j,c=(a*x-
w*d)/j,m=[n[0]-e[0]+l*n[0],n[1]-e[1]+l*n[1],l].map(h=>h/r),p=[s[0]-e[0]+c*s[0],s[1]-e[1]+c*s[1],c].map(h=>h/i);return[m[0],m[1],0,m[2],p[0],p[1],0,p[2],0,0,1,0,
e[0],e[1],0,1]}var u=await(await fetch("film.json")).json(),[f,b]=u.size,t=document.createElement("video");Object.assign(t,{src:"film.mp4",muted:!0,playsInline:!0,
preload:"auto",className:"backdrop",width:f,height:b});Object.assign(t.style,{position:"absolute",left:0,top:0,width:`${f}px`,height:`${b}px`,maxWidth:"none",transformOrigin:"\
0 0",zIndex:-1,pointerEvents:"none"});function v(){requestAnimationFrame(v);let r=globalThis.hophoopLab,i=r?.stage,e=i?.flat.views[0];if(!r||!i||!e)return;t.isConnected||
(Object.assign(i.element.style,{isolation:"isolate",overflow:"hidden"}),i.plane.style.opacity="0.7",i.element.prepend(t)),t.hidden=i.options.three||r.films().length>
1;let n=u.corners.map(([s,a])=>e.point(s,a));t.style.transform=`matrix3d(${C(f,b,n).join(",")})`;let o=u.start+r.clock.time;t.style.visibility=o>t.duration?"hid\
den":"visible",!t.seeking&&Math.abs(t.currentTime-o)>.002&&(t.currentTime=o)}v();
