document.title = "Somato report";
