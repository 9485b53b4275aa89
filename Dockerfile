# Somato on Debian 12, for machines with another system (docs/container.md):
#   docker build -t somato .
#   docker run --rm -v "$PWD:/data" somato som train data.csv -o my.map --standardize
FROM debian:12 AS build
WORKDIR /somato
COPY . .
RUN ./dev setup build && ./dev build release && cmake --install build/release --prefix /opt/somato

FROM debian:12-slim
RUN apt-get update -q \
    && apt-get install -y --no-install-recommends \
        libfmt9 liblz4-1 libpng16-16 libsqlite3-0 libstdc++6 libtomlplusplus3 libwebsockets17 libzstd1 zlib1g \
    && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/somato /usr/local
RUN ldconfig
WORKDIR /data
ENTRYPOINT ["somato"]
