import{y as t}from"./app.js";const i=t([]),e=s=>/ axiometry (straightness|angles)\b/.test(s);export{i as h,e as i};
