import{y as r}from"./app.js";const t=r(null),e=o=>/ \S?axiometry dynamic\b/.test(o);export{t as h,e as i};
