document.title = "Somato view";
