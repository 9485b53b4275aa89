# Somato on Debian, for machines with another system (docs/container.md):
#   docker build -t somato .
#   docker run --rm -v "$PWD:/data" somato som train data.csv -o my.map --standardize
# The image is a Debian with the package of Somato (docs/packages.md).
ARG DEBIAN=12
FROM debian:${DEBIAN} AS build
WORKDIR /somato
COPY . .
RUN ./dev setup build package && scripts/release/pack.sh /packages

FROM debian:${DEBIAN}-slim
RUN --mount=type=bind,from=build,source=/packages,target=/packages \
    apt-get update && apt-get install -y --no-install-recommends /packages/somato_*.deb && rm -rf /var/lib/apt/lists/*
WORKDIR /data
ENTRYPOINT ["somato"]
