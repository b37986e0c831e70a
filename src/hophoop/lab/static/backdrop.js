/* Built from web/site/backdrop.ts by esbuild 0.28.2; sources 28d40d580a9b64ea5d815ec25b6f59dc */
function O(a,i,[t,n,o,s]){let[l,g,y,w]=[n[0]-o[0],n[1]-o[1],s[0]-o[0],s[1]-o[1]],[x,j]=[t[0]-n[0]+o[0]-s[0],t[1]-n[1]+o[1]-s[1]],v=l*w-y*g,r=(x*w-y*j)/v,c=(l*j-
x*g)/v,m=[n[0]-t[0]+r*n[0],n[1]-t[1]+r*n[1],r].map(h=>h/a),p=[s[0]-t[0]+c*s[0],s[1]-t[1]+c*s[1],c].map(h=>h/i);return[m[0],m[1],0,m[2],p[0],p[1],0,p[2],0,0,1,0,
t[0],t[1],0,1]}var f=await(await fetch("film.json")).json(),[d,u]=f.size,e=document.createElement("video");Object.assign(e,{src:"film.mp4",muted:!0,playsInline:!0,
preload:"auto",className:"backdrop",width:d,height:u});Object.assign(e.style,{position:"absolute",left:0,top:0,width:`${d}px`,height:`${u}px`,maxWidth:"none",transformOrigin:"\
0 0",zIndex:-1,pointerEvents:"none"});function b(){requestAnimationFrame(b);let a=globalThis.hophoopLab,i=a?.stage,t=i?.flat.views[0];if(!t)return;e.isConnected||
(Object.assign(i.element.style,{isolation:"isolate",overflow:"hidden"}),i.plane.style.opacity=.7,i.element.prepend(e)),e.hidden=i.options.three||a.films().length>
1;let n=f.corners.map(([s,l])=>t.point(s,l));e.style.transform=`matrix3d(${O(d,u,n).join(",")})`;let o=f.start+a.clock.time;e.style.visibility=o>e.duration?"hid\
den":"visible",!e.seeking&&Math.abs(e.currentTime-o)>.002&&(e.currentTime=o)}b();
