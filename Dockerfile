# Somato on Debian, for machines with another system (docs/container.md):
#   docker build -t somato .
#   docker run --rm -v "$PWD:/data" somato som train data.csv -o my.map --standardize
ARG DEBIAN=12
FROM debian:${DEBIAN} AS build
WORKDIR /somato
COPY . .
RUN ./dev setup build && ./dev build release && cmake --install build/release --prefix /opt/somato

FROM debian:${DEBIAN}-slim
COPY scripts/setup.sh scripts/packages.txt /opt/scripts/
RUN /opt/scripts/setup.sh run && rm -rf /opt/scripts /var/lib/apt/lists/*
COPY --from=build /opt/somato /usr/local
RUN ldconfig
WORKDIR /data
ENTRYPOINT ["somato"]
