import{y as o}from"./app.js";const e=o(null);export{e as h};
