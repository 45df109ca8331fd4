import{y as o}from"./app.js";const m=o([]);export{m as h};
