# The package kohonen, driven as serve.py drives the others: PEER CASE FOLDER THREADS.
suppressMessages(library(kohonen))
arguments <- commandArgs(trailingOnly = TRUE)
name <- arguments[2]
folder <- arguments[3]
threads <- as.integer(arguments[4])

read_npy <- function(path) {
  file <- file(path, "rb")
  on.exit(close(file))
  readBin(file, "raw", 8)
  length <- readBin(file, "integer", 1, size = 2, signed = FALSE, endian = "little")
  header <- rawToChar(readBin(file, "raw", length))
  shape <- as.integer(strsplit(gsub(".*\\(|\\).*", "", header), ",")[[1]])
  matrix(readBin(file, "numeric", prod(shape), size = 4, endian = "little"),
         nrow = shape[1], byrow = TRUE)
}

# The number that follows a key of case.json.
number <- function(key) {
  text <- paste(readLines(file.path(folder, "case.json"), warn = FALSE), collapse = "")
  as.numeric(sub(paste0(".*\"", key, "\": *([0-9.eE+-]+).*"), "\\1", text))
}

data <- read_npy(file.path(folder, "samples.npy"))
initial <- read_npy(file.path(folder, "initial.npy"))
grid <- somgrid(number("columns"), number("rows"),
                if (name == "hexagonal_batch") "hexagonal" else "rectangular",
                neighbourhood.fct = "gaussian")
batch <- grepl("batch", name)
steps <- number("steps")

# Batch: an epoch on a part of the samples gives the time of all; online: so many times all samples.
part <- 1
rounds <- 1
if (batch) {
  rows <- min(nrow(data), 2000)
  part <- rows / nrow(data) / steps
  data <- data[seq_len(rows), , drop = FALSE]
} else if (name != "winners") {
  rounds <- if (grepl("sparse", name)) 1 else ceiling(steps / nrow(data))
  part <- min(1, rounds * nrow(data) / steps)
}

# Layers are halves of the columns, with a Euclidean and a Manhattan distance.
distances <- "sumofsquares"
layers <- function(rows) list(rows)
if (grepl("layers", name)) {
  distances <- c("euclidean", "manhattan")
  half <- ncol(data) / 2
  layers <- function(rows) {
    list(rows[, 1:half, drop = FALSE], rows[, (half + 1):ncol(rows), drop = FALSE])
  }
}

run <- if (name == "winners") {
  trained <- supersom(list(data[1:10, ]), grid, rlen = 1, init = list(initial))
  function() map(trained, list(data))
} else {
  function() {
    supersom(layers(data), grid, rlen = rounds, alpha = c(0.3, 0.02), dist.fcts = distances,
             radius = c(number("radius_start"), number("radius_end")),
             mode = if (batch) "pbatch" else "online", cores = threads, init = layers(initial),
             keep.data = FALSE)
  }
}

peak_kib <- function() {
  line <- grep("VmHWM", readLines("/proc/self/status"), value = TRUE)
  as.integer(gsub("[^0-9]", "", line))
}

cat("{\"ready\": true}\n")
input <- file("stdin", "r")
while (length(line <- readLines(input, 1)) > 0 && line != "quit") {
  if (startsWith(line, "weights ")) {
    cat("{\"written\": false}\n")
    next
  }
  took <- system.time(run())[["elapsed"]]
  cat(sprintf("{\"seconds\": %.9f, \"took\": %.9f, \"part\": %.9f, \"peak_kib\": %d}\n",
              took / part, took, part, peak_kib()))
}
