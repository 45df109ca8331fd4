import{y as l}from"./app.js";const t=l(null);export{t as h};
